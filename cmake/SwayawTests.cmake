# Tests of a floor: one program, and one test of ctest for each of its files, which runs the cases of that file and names
# those that fail. (A process for each case would be ten times as many.)
find_package(Catch2 REQUIRED)

# Seconds after which a test hangs. The longest takes 2 minutes on two quiet processors and 3.5 beside others, where a machine
# may be a third as fast; without optimisation, and with sanitizers, ten times as long.
set(SWAYAW_TEST_TIMEOUT 900)
if(SWAYAW_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(SWAYAW_TEST_TIMEOUT 3000)
endif()

#   swayaw_add_tests(core SOURCES recording_test.cpp DEPENDS swayaw::core)
#     ctest -R core.recording; or build/dev/tests/core/swayaw_test_core "name of a case"
function(swayaw_add_tests floor)
  cmake_parse_arguments(TESTS "" "" "SOURCES;DEPENDS" ${ARGN})
  set(target swayaw_test_${floor})
  add_executable(${target} ${TESTS_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_link_libraries(${target} PRIVATE swayaw_test_main ${TESTS_DEPENDS})
  target_compile_definitions(${target} PRIVATE
    SWAYAW_TEST_SHIPS="${PROJECT_SOURCE_DIR}/ships"
    SWAYAW_TEST_GOLDEN="${PROJECT_SOURCE_DIR}/tests/golden"
    SWAYAW_TEST_EXAMPLES="${PROJECT_SOURCE_DIR}/examples/recordings"
    SWAYAW_TEST_SHARED="${SWAYAW_SHARED}")
  if(SWAYAW_COVERAGE AND TARGET swayaw_${floor})
    # a file of the floor that no test needs counts as well
    target_link_options(${target} PRIVATE LINKER:--whole-archive $<TARGET_FILE:swayaw_${floor}> LINKER:--no-whole-archive)
  endif()
  swayaw_optimise_little(${target})
  swayaw_set_warnings(${target})
  swayaw_read_once(${target} <catch.hpp>)
  foreach(source ${TESTS_SOURCES})
    get_filename_component(file ${source} NAME_WE)
    string(REGEX REPLACE "_test$" "" name ${floor}.${file})
    add_test(NAME ${name} COMMAND ${target} --filenames-as-tags --warn NoTests "[#${file}]")
    set_tests_properties(${name} PROPERTIES TIMEOUT ${SWAYAW_TEST_TIMEOUT})
  endforeach()
endfunction()

# Tests that take long begin first, so that all processors are busy to the end.
#   swayaw_begin_first(identification.identify 30)    name and rough seconds, …
function(swayaw_begin_first)
  while(ARGN)
    list(POP_FRONT ARGN name seconds)
    set_tests_properties(${name} PROPERTIES COST ${seconds})
  endwhile()
endfunction()
