import math
import os
import pathlib
import subprocess

import pytest

import swayaw


@pytest.fixture(scope="session")
def source() -> pathlib.Path:
    """The folder of the project."""
    return pathlib.Path(os.environ.get("SWAYAW_SOURCE", pathlib.Path(__file__).parents[2]))


@pytest.fixture(scope="session")
def program():
    """Runs the program; its standard output."""
    path = os.environ.get("SWAYAW_PROGRAM", "")
    if not os.path.exists(path):
        pytest.skip("the program is not built")

    def run(*arguments) -> str:
        command = [path, *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    return run


@pytest.fixture
def ship() -> swayaw.Ship:
    return swayaw.published_ship("kvlcc2")


@pytest.fixture
def model() -> swayaw.Ship:
    """The 7 m model of KVLCC2, whose rudder is 18 % weaker in the example recordings."""
    return swayaw.published_ship("kvlcc2_l7")


@pytest.fixture
def recorded(source) -> list:
    folder = source / "examples" / "recordings"
    return [swayaw.read_csv(folder / name) for name in ("weak_rudder_zz10_10.csv", "weak_rudder_turn35.csv")]


@pytest.fixture(scope="session")
def zigzag() -> swayaw.Zigzag:
    return swayaw.zigzag(swayaw.published_ship("kvlcc2"), math.radians(10), math.radians(10))
