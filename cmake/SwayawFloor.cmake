# One floor of the house: a library swayaw_<name> (alias swayaw::<name>) that sees its own
# headers and those of the floors in DEPENDS, and nothing else.
#
#   swayaw_add_floor(nonlinear
#     SOURCES src/zigzag.cpp …          compiled here
#     DEPENDS swayaw::core …            seen by whoever uses this floor
#     USES toml++ …                     seen by this floor's sources only)
function(swayaw_add_floor name)
  cmake_parse_arguments(FLOOR "" "" "SOURCES;DEPENDS;USES" ${ARGN})
  set(target swayaw_${name})
  add_library(${target} ${FLOOR_SOURCES})
  add_library(swayaw::${name} ALIAS ${target})
  # before 1.0 a minor version may change what a program is linked to
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # errno and floating-point traps are never read; without them sqrt is one instruction and branches vectorise
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math)
  target_link_libraries(${target} PUBLIC ${FLOOR_DEPENDS} PRIVATE ${FLOOR_USES})
  swayaw_set_warnings(${target})
  swayaw_read_once(${target})
  if(SWAYAW_INSTALL)
    install(TARGETS ${target} EXPORT swayaw
      LIBRARY COMPONENT library NAMELINK_COMPONENT development
      ARCHIVE COMPONENT development)
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  endif()
endfunction()

# The packs of a floor once for each instruction set: NAME_baseline.cpp, which is one of its SOURCES, and on x86-64
# NAME_avx2.cpp and NAME_avx512.cpp; which one runs is decided when the program does. Optimised in every configuration, so
# that no inline function is left that the rest of the program might be linked to (tests/build/kernels.sh looks).
function(swayaw_add_kernels floor name)
  set(kernels ${name}_baseline.cpp)
  if(SWAYAW_HAS_XSIMD)
    target_compile_definitions(swayaw_${floor} PRIVATE SWAYAW_PACKS)
  endif()
  if(SWAYAW_HAS_XSIMD AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$"
      AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_sources(swayaw_${floor} PRIVATE ${name}_avx2.cpp ${name}_avx512.cpp)
    target_compile_definitions(swayaw_${floor} PRIVATE SWAYAW_X86_KERNELS)
    set_property(SOURCE ${name}_avx2.cpp PROPERTY COMPILE_OPTIONS -mavx2 -mfma)
    # g++ 12 takes its own AVX-512 headers for careless
    set_property(SOURCE ${name}_avx512.cpp PROPERTY COMPILE_OPTIONS
      -mavx512f -mavx512cd -mavx512dq -mavx512bw -mfma -Wno-uninitialized
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    list(APPEND kernels ${name}_avx2.cpp ${name}_avx512.cpp)
  endif()
  set_property(SOURCE ${kernels} APPEND PROPERTY COMPILE_OPTIONS -O3)
  set_property(SOURCE ${kernels} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# Files of a target that the compiler reads as one, unless SWAYAW_UNITY is off: small files that spend their time on the same
# headers and templates. A file that is named nowhere is compiled alone; so are those that have options of their own. A
# group holds what is changed together, and stays below 25 s and 700 MB (cmake/compile_cost.py); in its files a name of an
# unnamed namespace means one thing.
#   swayaw_compile_together(swayaw judging src/trial_command.cpp src/trial_page.cpp …)
function(swayaw_compile_together target group)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SWAYAW_UNITY} UNITY_BUILD_MODE GROUP)
  set_property(SOURCE ${ARGN} PROPERTY UNITY_GROUP ${group})
endfunction()

# Headers that most files of a target read, compiled once for it: clang++ then needs an eighth less for all. (g++ gains
# 6 %, and version 12 then warns of the standard library's own strings.)
#   swayaw_read_once(swayaw_test_core <catch.hpp> …)    beside those that all floors read
function(swayaw_read_once target)
  if(SWAYAW_UNITY AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <cmath> <functional> <map> <optional> <span> <string> <vector>
      <fmt/format.h> <Eigen/Core> ${ARGN})
  endif()
endfunction()

# Warnings and, on request, sanitizers, counts of what runs or link-time code generation for a target of this project.
function(swayaw_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -Wno-missing-field-initializers
    # a designator leaves out what has a default; clang++ also warns of implicit signs, which g++ does only with -Wsign-conversion
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion -Wno-missing-braces>
    $<$<BOOL:${SWAYAW_WARNINGS_AS_ERRORS}>:-Werror>)
  if(SWAYAW_SANITIZE)
    # the sanitizers make g++ 12 suspect xsimd and Eigen of using what they do not
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
      -fsanitize=${SWAYAW_SANITIZERS} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${SWAYAW_SANITIZERS})
  endif()
  if(SWAYAW_COVERAGE)
    target_compile_options(${target} PRIVATE -fprofile-instr-generate -fcoverage-mapping)
    target_link_options(${target} PUBLIC -fprofile-instr-generate)
  endif()
  if(SWAYAW_LTO_ODR)
    target_compile_options(${target} PRIVATE -flto)
    target_link_options(${target} PRIVATE -flto=auto -Wodr -Werror=odr -Werror=lto-type-mismatch)
  endif()
endfunction()

# Examples and tests leave most of the work to the library: what they wait for is the compiler.
function(swayaw_optimise_little target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# The program and the module of Python leave all of it to the library. Not so tests: of an inline function that they and the
# library use the linker takes theirs, and without optimisation some took nine times as long.
function(swayaw_optimise_front target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${SWAYAW_FRONT_OPTIMISATION}>)
endfunction()
