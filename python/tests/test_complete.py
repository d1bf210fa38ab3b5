"""Every public function of the library can be called from Python, or a table says why not."""

import inspect
import pathlib
import re

import pytest

import swayaw

FLOORS = ("core", "linear", "nonlinear", "identification", "mismatch")


def code_of(text: str) -> str:
    """A header without comments, directives, and what stands in quotes."""
    text = re.sub(r'"(\\.|[^"\\\n])*"|\'(\\.|[^\'\\\n])\'', '""', text)
    text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S)
    return re.sub(r"^\s*#(.*\\\n)*.*$", " ", text, flags=re.M)


def statements(text: str) -> list:
    """What is declared at the level of a namespace, bodies left out; not what is in a namespace `detail`."""
    found, statement, open_braces, hidden, depth = [], "", [], 0, 0
    for c in code_of(text):
        depth += (c == "(") - (c == ")")
        if c == "{":
            if re.search(r"\bnamespace\b[^;{}()]*$", statement) and not any(open_braces):
                open_braces.append(False)  # a namespace: what is in it counts
                hidden += "detail" in statement or statement.split()[-1] == "namespace"
                statement = ""
                continue
            open_braces.append(True)
        elif c == "}":
            if open_braces.pop() and not any(open_braces) and depth == 0:
                statement += "{}"
                if re.search(r"\)[^=]*\{\}$", statement):  # the body of a function ends it
                    found += [] if hidden else [statement]
                    statement = ""
        elif any(open_braces):
            continue
        elif c == ";" and depth == 0:
            found += [] if hidden else [statement]
            statement = ""
        else:
            statement += c
    return found


def functions_in(text: str) -> set:
    """Names of the functions that a header declares, without operators."""
    names = set()
    for statement in statements(text):
        statement = re.sub(r"^\s*(template\s*<[^;]*?>\s*(?=[\w\[:]))+", "", " ".join(statement.split()))
        while re.search(r"<[^<>()]*>", statement):
            statement = re.sub(r"<[^<>()]*>", "", statement)
        match = re.search(r"\b(\w+)\s*\(", statement)
        if not match or re.match(r"\s*(using|struct|class|enum|extern|static_assert|friend|concept)\b", statement):
            continue
        if "=" in statement[: match.start()] or match[1] in ("requires", "operator", "decltype", "static_assert"):
            continue
        names.add(match[1])
    return names


def public_functions(source: pathlib.Path) -> dict:
    """Headers and their functions, as "nonlinear/replay.hpp"."""
    found = {}
    for floor in FLOORS:
        root = source / floor / "include" / "swayaw"
        for header in sorted(root.rglob("*.hpp")):
            name = str(header.relative_to(root))
            if "/detail/" not in name and (functions := functions_in(header.read_text(encoding="utf-8"))):
                found[name] = functions
    return found


#: functions that have another name in Python, or are a method or a property there
OTHERWISE = {
    "add_forces": "with_forces",
    "check_run": "check",
    "coefficients": "LinearShip.coefficients",
    "criteria_of": "ImoCriteria.criteria",
    "estimated_mmg_ship": "estimate_ship",
    "feels_wind": "Ship.feels_wind",
    "fit": "map_fit",
    "followed_order": "with_followed_order",
    "group_of": "Recording.group",
    "grouped": "check_groups",
    "has_complex_poles": "SwayYawCoefficients.complex_poles",
    "index_slopes": "zigzag_slopes",
    "indices": "LinearShip.indices",
    "indices_of": "Zigzag.reversals",
    "is_stable": "SwayYawCoefficients.stable",
    "judge_trial": "trial",
    "length": "Ship.length",
    "measured_samples_of": "measured_samples",
    "nomoto_zigzag_analysis": "nomoto_zigzag",
    "parameters_of": "Ship.parameters",
    "parse_recording": "parse_csv",
    "pooled": "pooled_errors",
    "prime_scale": "LinearShip.scale",
    "read_recording": "read_csv",
    "recording_of": "LinearZigzag.recording",
    "recording_text": "Recording.csv_text",
    "response_at": "bode",
    "response_to": "response",
    "rudder_force_words": "Diagnosis.words",
    "rudder_ramp": "rudder_ramp_and_hold",
    "service_speed": "Ship.service_speed",
    "ship_text": "Ship.text",
    "sname": "Linearization.sname",
    "stability_verdict": "ForceFit.stability",
    "steering_gear": "Ship.steering_gear",
    "summary_of": "trial_summary",
    "sway_yaw": "Linearization.sway_yaw",
    "time_unit_of": "Ship.time_unit",
    "verdict": "compare_verdict",
    "version": "__version__",
    "with_effect": "Ship.with_effect",
    "with_values": "Ship.with_values",
    "words_of": "linear_words",
    "write_linear_ship": "LinearShip.save",
    "write_recording": "Recording.write_csv",
    "write_ship": "Ship.save",
}

#: why the other functions of a header, or of all headers of a folder, are not called from Python
NOT_CALLED = {
    "core/angle.hpp": "arithmetic that numpy has",
    "core/atomic_file.hpp": "files are read and written by those who know what is in them",
    "core/channel.hpp": "`channels` has the table",
    "core/import.hpp": "text of a table is imported from its file",
    "core/manoeuvres_in.hpp": "names of files that the program writes",
    "core/mat_file.hpp": "variables of MATLAB files by themselves: scipy.io has them",
    "core/motion.hpp": "arithmetic that numpy has",
    "core/parallel.hpp": "threads of C++",
    "core/parameter.hpp": "lists of parameters at compile time; Ship.parameters has them",
    "core/parts_reader.hpp": "pieces of ship files, which `read_ship` puts together",
    "core/recording.hpp": "what fits do with recordings before they begin",
    "core/refusal.hpp": "checks of arguments in C++",
    "core/rounding.hpp": "arithmetic that numpy has",
    "core/scalar.hpp": "arithmetic of numbers, duals and packs",
    "core/ship_text.hpp": "pieces of ship files, which `read_ship` puts together",
    "core/side.hpp": "sides are words",
    "core/steered_thrust.hpp": "a word of ship files",
    "core/steering_gear.hpp": "checks of arguments in C++",
    "linear/batch.hpp": "states of legs: LinearZigzag.states",
    "linear/euler_zigzag.hpp": "a second route for tests of `linear_zigzag`",
    "linear/frequency_response.hpp": "complex numbers by themselves: state_space().to_scipy()",
    "linear/indices.hpp": "a second route for tests of `coefficients_from`",
    "linear/inversion.hpp": "which number is best known: the program tells it",
    "linear/linear_ship.hpp": "other forms of a linear ship: LinearShip.form",
    "linear/response.hpp": "single steps of `response`",
    "linear/rudder_history.hpp": "single legs of a RudderHistory",
    "linear/ship_parts.hpp": "factors of `coefficients_of`",
    "linear/sway_yaw.hpp": "arithmetic that numpy has",
    "linear/track.hpp": "the track of a LinearZigzag: its recording",
    "linear/uncertainty.hpp": "sampling and covariances that numpy does with `coefficient_elasticities`",
    "linear/zigzag.hpp": "templates over the scalar, of `linear_zigzag`",
    "nonlinear/effects.hpp": "properties of effects by the dozen; Effect has what people ask for",
    "nonlinear/effects/": "laws of effects as templates over the scalar; simulations, filter and fits act by them",
    "nonlinear/coefficients.hpp": "values of models as templates over the scalar; Ship.with_values",
    "nonlinear/equilibria.hpp": "single points of `steady_turn_curve`",
    "nonlinear/estimate.hpp": "formulas by part, which `estimate_ship` puts together",
    "nonlinear/estimates/": "formulas by part, which `estimate_ship` puts together",
    "nonlinear/instruments/": "errors of instruments are effects; simulations, filter and fits act by them",
    "nonlinear/manoeuvres/": "limits and steps of the manoeuvres, whose results hold them",
    "nonlinear/models/": "forces by part as templates over the scalar; `force_breakdown` has their values",
    "nonlinear/replay.hpp": "a replay from within a run: `replay` of a part of it",
    "nonlinear/simulation/": "steps of the integration; `replay`, Simulator and manoeuvres take them",
    "nonlinear/simulator.hpp": "words of what Simulator.why tells",
    "nonlinear/steady_motion.hpp": "pieces of `self_propulsion`",
    "nonlinear/surroundings/": "wind, stream and depth as `replay`, Simulator and `steady_run_in_wind` have them",
    "identification/data_compatibility.hpp": "words and pieces of `check`, whose results hold them",
    "identification/identify.hpp": "a name for groups of runs in the program",
    "identification/map_fit.hpp": "pieces of `map_fit` that the search for effects takes one by one",
    "identification/measurement.hpp": "a list of channels: `channels`",
    "identification/noise.hpp": "one number of the filter",
    "identification/segment_simulator.hpp": "one segment of `fit_trajectories`",
    "identification/trial.hpp": "words and pieces of `trial`, whose results hold them",
    "mismatch/quantity.hpp": "series of `compare`, whose results hold them",
    "mismatch/region.hpp": "pieces of `compare`, whose results hold them",
    "mismatch/run_picture.hpp": "many of `run_picture`",
}

#: enumerations are words in Python, and so are values
WORDS = {"in_words", "name_of", "unit_of", "words_for"}


def in_python(name: str) -> bool:
    place = swayaw
    for part in name.split("."):
        place = getattr(place, part, None)
    return place is not None


def reason_for(header: str) -> str:
    return next((why for place, why in NOT_CALLED.items() if header == place or header.startswith(place) and place[-1] == "/"), "")


def test_every_public_function_is_bound_or_has_a_reason(source):
    missing = {
        f"{header}: {function}"
        for header, functions in public_functions(source).items()
        for function in functions - WORDS
        if not in_python(function) and not in_python(OTHERWISE.get(function, "-")) and not reason_for(header)
    }
    assert not missing, "neither bound nor in the tables: " + ", ".join(sorted(missing))


def test_the_tables_name_what_is_there(source):
    found = public_functions(source)
    everything = set().union(*found.values())
    assert len(everything) > 400  # the headers were read
    for function, name in OTHERWISE.items():
        assert function in everything and in_python(name), function
    for place in NOT_CALLED:
        headers = [h for h in found if h == place or h.startswith(place) and place[-1] == "/"]
        left = {f for h in headers for f in found[h] if not in_python(f) and f not in OTHERWISE}
        assert left, f"{place} needs no reason"


# ---------------------------------------------------------------- docstrings


def parameters_of(function) -> list:
    """Of all signatures of a function."""
    if inspect.isfunction(function):
        return list(inspect.signature(function).parameters)
    lines = [line for line in function.__doc__.splitlines() if re.match(rf"(\d+\. )?{function.__name__}\(.*\) ->", line)]
    return [name for line in lines for name in re.findall(r"[(,] ?(\w+): ", line[: line.rindex(") ->")])]


def sentences_of(function) -> list:
    """Lines of its docstring without signatures."""
    signature = re.compile(rf"(\d+\. )?{function.__name__}\(|Overloaded function")
    return [line for line in function.__doc__.splitlines() if line.strip() and not signature.match(line)]


@pytest.mark.parametrize("name", [n for n in swayaw.__all__ if inspect.isroutine(getattr(swayaw, n))])
def test_every_function_tells_its_parameters(name):
    function = getattr(swayaw, name)
    sentences, parameters = sentences_of(function), parameters_of(function)
    assert len(sentences) > (1 if parameters else 0), f"{name} needs more than a line"
    for parameter in parameters:
        assert re.search(rf"\b{parameter}\b", "\n".join(sentences)), f"{name} does not tell what {parameter} is"
