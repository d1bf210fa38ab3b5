"""The wheel of the Python module: its extension is built by CMake, which has the version, too."""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).parent.resolve()


def version() -> str:
    """As the project has it in CMakeLists.txt."""
    return re.search(r"project\(swayaw VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


class BuiltByCMake(build_ext):
    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        build = pathlib.Path(self.build_temp).resolve()
        parts = ("PROGRAM", "EXAMPLES", "BENCH", "TESTS", "INSTALL")
        options = [f"-DSWAYAW_{'BUILD_' if part != 'INSTALL' else ''}{part}=OFF" for part in parts]
        subprocess.run(
            ["cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DSWAYAW_BUILD_PYTHON=ON",
             f"-DPython3_EXECUTABLE={sys.executable}", *options, *os.environ.get("SWAYAW_CMAKE", "").split()],
            check=True,
        )
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", build, "--target", "_swayaw", "--parallel", jobs], check=True)
        target.mkdir(parents=True, exist_ok=True)
        self.copy_file(next((build / "python" / "swayaw").glob("_swayaw.*")), target)


setup(
    version=version(),
    packages=["swayaw"],
    package_dir={"swayaw": "python/swayaw"},
    package_data={"swayaw": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("swayaw._swayaw", sources=[])],
    cmdclass={"build_ext": BuiltByCMake},
)
