# What the library is made with. Programs, tests and benchmarks look for what they need themselves.
if(NOT PROJECT_IS_TOP_LEVEL)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)  # whoever links swayaw links these too
endif()
find_package(Eigen3 3.4 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(Threads REQUIRED)
find_path(SWAYAW_CERES_INCLUDE ceres/jet.h REQUIRED)

# Without GeographicLib recordings in latitude and longitude are refused.
option(SWAYAW_WITH_GEOGRAPHICLIB "Recordings in latitude and longitude, if GeographicLib is there" ON)
if(SWAYAW_WITH_GEOGRAPHICLIB)
  find_package(GeographicLib QUIET)
endif()

# Without libmatio MATLAB files are refused.
option(SWAYAW_WITH_MATIO "MATLAB files, if libmatio is there" ON)
if(SWAYAW_WITH_MATIO)
  find_package(Matio QUIET)
endif()

# Without xsimd batches of ships are sailed one by one. Headers only; the package target asks for xtl, which is not needed.
option(SWAYAW_WITH_XSIMD "Many ships at once in SIMD packs, if xsimd is there" ON)
if(SWAYAW_WITH_XSIMD)
  find_path(SWAYAW_XSIMD_INCLUDE xsimd/xsimd.hpp)
endif()

set(SWAYAW_HAS_GEOGRAPHICLIB OFF)
if(SWAYAW_WITH_GEOGRAPHICLIB AND GeographicLib_FOUND)
  set(SWAYAW_HAS_GEOGRAPHICLIB ON)
endif()
set(SWAYAW_HAS_MATIO OFF)
if(SWAYAW_WITH_MATIO AND Matio_FOUND)
  set(SWAYAW_HAS_MATIO ON)
endif()
set(SWAYAW_HAS_XSIMD OFF)
if(SWAYAW_WITH_XSIMD AND SWAYAW_XSIMD_INCLUDE)
  set(SWAYAW_HAS_XSIMD ON)
endif()
message(STATUS "swayaw: latitude and longitude (GeographicLib) ${SWAYAW_HAS_GEOGRAPHICLIB}, MATLAB files (libmatio) ${SWAYAW_HAS_MATIO}, packs (xsimd) ${SWAYAW_HAS_XSIMD}")
