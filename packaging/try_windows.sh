#!/bin/bash
# How far the library compiles for Windows, by Debian's mingw-w64 and the header packages of this machine: each floor, how many
# of its files compile, and what stops the others.
#   packaging/try_windows.sh [FOLDER] [FLOOR…]
# apt-get install g++-mingw-w64-x86-64-posix; xsimd, GeographicLib, libmatio are left out
set -euo pipefail
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
scratch=${1:-$(mktemp -d)}
floors=("${@:2}")
if ((${#floors[@]} == 0)); then floors=(core linear nonlinear); fi
command -v x86_64-w64-mingw32-g++-posix >/dev/null || { echo "try_windows: x86_64-w64-mingw32-g++-posix is missing" >&2; exit 1; }

# /usr/include has the headers of Linux, too, so those that any system can read are linked into a folder of their own.
mkdir -p "$scratch/include" "$scratch/cmake"
for header in eigen3/Eigen boost fmt toml++ ceres glog gflags; do
  if [[ -e /usr/include/$header ]]; then ln -sfn "/usr/include/$header" "$scratch/include/${header##*/}"; fi
done
headers_only() {  # headers_only PACKAGE VERSION TARGET [DEFINITION]: a package of CMake that is headers and nothing else
  cat >"$scratch/cmake/$1Config.cmake" <<END
if(NOT TARGET $3)
  add_library($3 INTERFACE IMPORTED)
  target_include_directories($3 SYSTEM INTERFACE $scratch/include)
  target_compile_definitions($3 INTERFACE ${4:-})
endif()
set($1_FOUND TRUE)
END
  echo "set(PACKAGE_VERSION $2)
set(PACKAGE_VERSION_COMPATIBLE TRUE)" >"$scratch/cmake/$1ConfigVersion.cmake"
}
headers_only Eigen3 3.4 Eigen3::Eigen
headers_only Boost 1.74 Boost::headers
headers_only fmt 9.1 fmt::fmt FMT_HEADER_ONLY
headers_only tomlplusplus 3.3 tomlplusplus::tomlplusplus
cat >"$scratch/windows.cmake" <<END
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_FIND_ROOT_PATH $scratch)
foreach(what LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_\${what} ONLY)
endforeach()
END

# mingw hides the Bessel functions, which ceres/jet.h asks for, from strict C++20.
echo '#ifdef __cplusplus
extern "C" { double j0(double); double j1(double); double jn(int, double); }
#endif' >"$scratch/bessel.h"

cmake -S "$sources" -B "$scratch/build" -G Ninja -D CMAKE_TOOLCHAIN_FILE="$scratch/windows.cmake" \
  -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS="-include $scratch/bessel.h" -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -D SWAYAW_CERES_INCLUDE="$scratch/include" \
  -D Eigen3_DIR="$scratch/cmake" -D Boost_DIR="$scratch/cmake" -D fmt_DIR="$scratch/cmake" -D tomlplusplus_DIR="$scratch/cmake" \
  -D SWAYAW_WITH_XSIMD=OFF -D SWAYAW_WITH_GEOGRAPHICLIB=OFF -D SWAYAW_WITH_MATIO=OFF -D SWAYAW_BUILD_PROGRAM=OFF \
  -D SWAYAW_BUILD_PYTHON=OFF -D SWAYAW_BUILD_EXAMPLES=OFF -D SWAYAW_BUILD_BENCH=OFF -D BUILD_TESTING=OFF \
  >"$scratch/configured" 2>&1 || { cat "$scratch/configured" >&2; exit 1; }

cmake -D FOLDER="$sources/ships" -D OUTPUT="$scratch/build/nonlinear/published_ship_texts.cpp" -P "$sources/cmake/EmbedShips.cmake"

# Each file by itself: ninja would not begin a floor when a file of the one below does not compile.
python3 - "$scratch/build/compile_commands.json" "$sources" "${floors[@]}" <<'END'
import concurrent.futures, json, os, re, subprocess, sys

commands, sources, *floors = sys.argv[1:]
with open(commands, encoding="utf-8") as file:
    files = json.load(file)


def compiled(one):
    os.makedirs(os.path.dirname(os.path.join(one["directory"], re.search(r" -o (\S+)", one["command"])[1])), exist_ok=True)
    return subprocess.run(one["command"], shell=True, cwd=one["directory"], capture_output=True, text=True)


with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", os.cpu_count()))) as pool:
    for floor in floors:
        runs = list(pool.map(compiled, [one for one in files if f"swayaw_{floor}.dir/" in one["command"]]))
        print(f"{floor}: {sum(run.returncode == 0 for run in runs)} of {len(runs)} files compile", flush=True)
        errors = [line for run in runs for line in run.stderr.splitlines() if "error: " in line]
        print("\n".join(dict.fromkeys(line.replace(sources + "/", "") for line in errors[:20])), end="\n" if errors else "")
END
