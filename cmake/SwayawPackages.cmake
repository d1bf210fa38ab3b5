# Debian packages by `cpack --preset debian`, or packaging/make_deb.sh:
#   libswayaw<soname>   shared libraries of the five floors
#   libswayaw-dev       headers, find_package() and pkg-config
#   swayaw              the program, its manual, completion for bash, ship files, example recordings
#   python3-swayaw      the module of Python
if(NOT BUILD_SHARED_LIBS OR NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "swayaw: packages are of shared libraries under /usr; configure with --preset debian")
endif()
if(NOT SWAYAW_BUILD_PROGRAM OR NOT TARGET _swayaw)
  message(FATAL_ERROR "swayaw: packages need the program and the Python module; packaging/packages.txt has what they are made with")
endif()
set(SWAYAW_MAINTAINER "the swayaw authors <swayaw@packages.invalid>" CACHE STRING "Maintainer of the packages: name <address>")
set(SWAYAW_DEBIAN_REVISION 1 CACHE STRING "Revision of the packages, after the version")

# The date of a release is that of its last change, so that the same sources make the same packages.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 --format=%ct
    OUTPUT_VARIABLE seconds OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT seconds)  # a tarball gives its files the time of the last change
    file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CHANGELOG.md seconds "%s" UTC)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${seconds})
endif()
string(TIMESTAMP release_date "%Y-%m-%d" UTC)
string(TIMESTAMP release_time "%a, %d %b %Y %H:%M:%S +0000" UTC)

set(soname ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(package_library libswayaw${soname})
set(package_development libswayaw-dev)
set(package_program swayaw)
set(package_python python3-swayaw)
set(components library development program python)
set(debian ${PROJECT_SOURCE_DIR}/packaging/debian)
set(made ${PROJECT_BINARY_DIR}/packages)

function(compressed file output)
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${output} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# What every package has.
configure_file(${debian}/changelog.in ${made}/changelog.Debian @ONLY)
compressed(${made}/changelog.Debian ${made}/changelog.Debian.gz)
compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${made}/changelog.gz)
foreach(component IN LISTS components)
  install(FILES ${debian}/copyright ${made}/changelog.Debian.gz ${made}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package_${component}} COMPONENT ${component})
endforeach()

# The C interface, whose folder installs it whole. (swayaw_fmu is made of static floors only: it is in no package.)
if(TARGET swayaw_c)
  install(TARGETS swayaw_c LIBRARY COMPONENT library NAMELINK_COMPONENT development)
  install(FILES ${PROJECT_SOURCE_DIR}/c/include/swayaw.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endif()

# The manual and the completion, from the program's own words.
set(manual ${made}/man)
set(completion ${made}/completion)
add_custom_command(
  OUTPUT ${manual}/swayaw.1 ${completion}/swayaw
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/packaging/make_man.py $<TARGET_FILE:swayaw> ${manual}
    --date ${release_date} --compress
  COMMAND ${CMAKE_COMMAND} -E make_directory ${completion}
  COMMAND swayaw completion > ${completion}/swayaw
  DEPENDS swayaw ${PROJECT_SOURCE_DIR}/packaging/make_man.py
  COMMENT "Pages of the manual"
  VERBATIM)
add_custom_target(swayaw_manual ALL DEPENDS ${manual}/swayaw.1 ${completion}/swayaw)
install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program FILES_MATCHING PATTERN "*.gz")
install(FILES ${completion}/swayaw DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/recordings/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/swayaw/examples COMPONENT program FILES_MATCHING PATTERN "*.csv")

# The module as pip knows it.
set(info swayaw-${PROJECT_VERSION}.dist-info)
configure_file(${debian}/METADATA.in ${made}/METADATA @ONLY)
file(WRITE ${made}/INSTALLER "debian\n")
install(FILES ${made}/METADATA ${made}/INSTALLER DESTINATION ${SWAYAW_PYTHON_DIR}/${info} COMPONENT python)
set(minor_after ${Python3_VERSION_MINOR})
math(EXPR minor_after "${Python3_VERSION_MINOR} + 1")

# maintainer scripts have fixed names
configure_file(${debian}/postinst.python ${made}/python/postinst COPYONLY)
configure_file(${debian}/prerm.python ${made}/python/prerm COPYONLY)

# Which package has which shared library. They stay together: one package, whose name is no soname.
set(shlibs "")
foreach(target swayaw_core swayaw_linear swayaw_nonlinear swayaw_identification swayaw_mismatch swayaw_c)
  if(TARGET ${target})
    string(APPEND shlibs "lib${target} ${soname} ${package_library} (>= ${PROJECT_VERSION})\n")
    get_target_property(folder ${target} BINARY_DIR)
    list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
  endif()
endforeach()
file(WRITE ${made}/shlibs "${shlibs}")
file(WRITE ${made}/triggers "activate-noawait ldconfig\n")
file(WRITE ${made}/overrides "${package_library}: package-name-doesnt-match-sonames *\n")
install(FILES ${made}/overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME ${package_library} COMPONENT library)

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_PACKAGE_NAME swayaw)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # else it comes before that of each package
set(CPACK_PACKAGE_CONTACT ${SWAYAW_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${SWAYAW_DEBIAN_REVISION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(same "${package_library} (= ${PROJECT_VERSION}-${SWAYAW_DEBIAN_REVISION})")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${package_library})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${made}/shlibs ${made}/triggers)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "Ship steering dynamics - shared libraries
Ships as sums of parts: simulation of manoeuvres, linear steering theory,
identification from recordings, and what a model leaves out.
.
This package has the shared libraries.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME ${package_development})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${same}, libeigen3-dev (>= 3.4), libceres-dev, libxsimd-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Ship steering dynamics - headers for C++
Ships as sums of parts: simulation of manoeuvres, linear steering theory,
identification from recordings, and what a model leaves out.
.
This package has the headers, and what CMake and pkg-config ask for.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ${package_program})
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${same}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Ship steering dynamics - program
Simulates zigzags, turning circles and other manoeuvres of a ship, explains
her linear steering, judges recorded trials, finds coefficients from
recordings, and says where a model and a recording differ and what the model
leaves out. Answers are text, JSON, or pages that need no network.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME ${package_python})
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "${same}, python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${minor_after}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-matplotlib, python3-scipy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${made}/python/postinst ${made}/python/prerm)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Ship steering dynamics - module for Python 3
Simulates manoeuvres, explains linear steering, finds coefficients from
recordings and says what a model leaves out, on numpy arrays; tables of
pandas and figures of matplotlib where these are installed.")

include(CPack)
