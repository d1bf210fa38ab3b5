# Installs the build, then configures, builds and runs project/ against what was installed.
set(prefix ${SCRATCH}/prefix)
set(project ${SCRATCH}/project)
file(REMOVE_RECURSE ${prefix} ${project})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILT} --config ${CONFIG} --prefix ${prefix})

# The package must not depend on where it was built.
file(GLOB package_files ${prefix}/${LIBDIR}/cmake/swayaw/*)
foreach(package_file ${package_files})
  file(READ ${package_file} text)
  foreach(folder ${BUILT} ${SOURCES})
    string(FIND "${text}" "${folder}/" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${package_file} names ${folder}")
    endif()
  endforeach()
endforeach()

run(${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_LIST_DIR}/project ${project}
  --build-generator ${GENERATOR} --build-config ${CONFIG}
  --build-options -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=${CONFIG}
    "-DCMAKE_PREFIX_PATH=${prefix};${PREFIX_PATH}"
  --test-command first_overshoot ${prefix}/${DATADIR}/swayaw/ships/kvlcc2_l7.toml)
