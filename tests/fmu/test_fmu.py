"""A unit of FMI 2.0 as a program sees it that runs such units: zip, description and shared library.

usage: test_fmu.py SWAYAW_FMU TRUTH SHIPS
"""
import ctypes
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zipfile

PROGRAM, TRUTH, SHIPS = sys.argv[1:4]
OK, WARNING, DISCARD, ERROR = range(4)

LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ctypes.c_void_p), ("free", ctypes.c_void_p), ("finished", ctypes.c_void_p), ("environment", ctypes.c_void_p)]


def make(ship, folder):
    """Makes a unit of the ship and unpacks it: its folder and its description."""
    out = pathlib.Path(folder) / (pathlib.Path(ship).stem + ".fmu")
    subprocess.run([PROGRAM, ship, "--out", str(out)], check=True, stdout=subprocess.DEVNULL)
    unpacked = out.with_suffix("")
    with zipfile.ZipFile(out) as unit:
        assert unit.testzip() is None
        unit.extractall(unpacked)
    return unpacked, xml.etree.ElementTree.parse(unpacked / "modelDescription.xml").getroot()


class Unit:
    """One instance of an unpacked unit."""

    TYPES = {"Real": ctypes.c_double, "Integer": ctypes.c_int, "Boolean": ctypes.c_int, "String": ctypes.c_char_p}

    def __init__(self, folder, description, name="ship", guid=None, resources=None, kind=1):
        self.lib = ctypes.CDLL(str(next(folder.glob("binaries/*/swayaw_ship.so"))))
        self.lib.fmi2Instantiate.restype = ctypes.c_void_p
        self.lib.fmi2FreeInstance.restype = None
        self.lib.fmi2GetVersion.restype = ctypes.c_char_p
        self.lib.fmi2GetTypesPlatform.restype = ctypes.c_char_p
        self.variables = {v.get("name"): v for v in description.find("ModelVariables")}
        self.said = []
        self.logger = LOGGER(lambda env, name, status, category, form, text: self.said.append((status, category.decode(), text.decode())))
        self.callbacks = Callbacks(self.logger, None, None, None, None)
        uri = resources or (folder / "resources").as_uri()
        self.instance = ctypes.c_void_p(
            self.lib.fmi2Instantiate(name.encode(), kind, (guid or description.get("guid")).encode(), uri.encode(), ctypes.byref(self.callbacks), 0, 0)
        )

    def free(self):
        self.lib.fmi2FreeInstance(self.instance)
        self.instance = None

    def call(self, function, *arguments):
        return getattr(self.lib, "fmi2" + function)(self.instance, *arguments)

    def reference(self, name):
        return (ctypes.c_uint * 1)(int(self.variables[name].get("valueReference")))

    def kind(self, name):
        return self.variables[name][0].tag

    def get(self, name):
        value = (self.TYPES[self.kind(name)] * 1)()
        status = self.call("Get" + self.kind(name), self.reference(name), ctypes.c_size_t(1), value)
        assert status == OK, self.said
        return value[0]

    def set(self, name, value):
        values = (self.TYPES[self.kind(name)] * 1)(value)
        return self.call("Set" + self.kind(name), self.reference(name), ctypes.c_size_t(1), values)

    def set_all(self, **values):
        for name, value in values.items():
            assert self.set(name, value) == OK, self.said

    def set_up(self, start=0.0, stop=None):
        return self.call("SetupExperiment", 0, ctypes.c_double(0.0), ctypes.c_double(start), int(stop is not None), ctypes.c_double(stop or 0.0))

    def begin(self, start=0.0, stop=None):
        for status in (self.set_up(start, stop), self.call("EnterInitializationMode"), self.call("ExitInitializationMode")):
            assert status == OK, self.said

    def step(self, now, dt):
        return self.call("DoStep", ctypes.c_double(now), ctypes.c_double(dt), 1)


class Test(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="a unit of ")  # blanks become %20 in an URI
        cls.kvlcc2 = make(f"{SHIPS}/kvlcc2.toml", cls.scratch.name)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def unit(self, **arguments):
        unit = Unit(*self.kvlcc2, **arguments)
        self.addCleanup(unit.free)
        return unit

    def check_description(self, root):
        variables = list(root.find("ModelVariables"))
        references = [int(v.get("valueReference")) for v in variables]
        names = [v.get("name") for v in variables]
        self.assertEqual(len(set(references)), len(references))
        self.assertEqual(len(set(names)), len(names))
        units = {u.get("name") for u in root.find("UnitDefinitions")}
        for v in variables:
            self.assertLessEqual(v[0].get("unit") and {v[0].get("unit")} or set(), units)
            # a start is asked for of inputs and parameters, and forbidden for what is calculated
            self.assertEqual(v[0].get("start") is not None, v.get("causality") in ("input", "parameter"), v.get("name"))
            if v.get("causality") == "parameter":
                self.assertEqual(v.get("variability"), "fixed")
            if v[0].tag != "Real":
                self.assertNotEqual(v.get("variability"), "continuous")
        outputs = [i + 1 for i, v in enumerate(variables) if v.get("causality") == "output"]
        for part in ("Outputs", "InitialUnknowns"):
            self.assertEqual([int(u.get("index")) for u in root.find(f"ModelStructure/{part}")], outputs)
        self.assertEqual(sum(v.get("causality") == "independent" for v in variables), 1)
        # the order of a sequence in the schema
        order = ["CoSimulation", "UnitDefinitions", "LogCategories", "DefaultExperiment", "ModelVariables", "ModelStructure"]
        self.assertEqual([part.tag for part in root], order)
        self.assertEqual(root.get("fmiVersion"), "2.0")
        return dict(zip(names, variables))

    def test_the_description_keeps_the_rules_of_the_standard_for_ships_of_every_model(self):
        folder, root = self.kvlcc2
        variables = self.check_description(root)
        self.assertTrue((folder / f"binaries/linux64/{root.find('CoSimulation').get('modelIdentifier')}.so").exists() or os.uname().machine != "x86_64")
        self.assertEqual(variables["rev_s"].get("causality"), "input")
        self.assertEqual(variables["thrust_N"].get("causality"), "output")
        for ship in ("wpcc_pi", "mariner", "nawigator_n7"):
            root = make(f"{SHIPS}/{ship}.toml", self.scratch.name)[1]
            self.check_description(root)

    def test_every_variable_can_be_read_and_starts_as_described(self):
        unit = self.unit()
        unit.begin()
        for name, v in unit.variables.items():
            value = unit.get(name)
            if unit.kind(name) == "Real":
                self.assertTrue(math.isfinite(value), name)
            if unit.kind(name) == "Real" and v[0].get("start"):
                self.assertEqual(value, float(v[0].get("start")), name)

    def test_a_unit_needs_no_library_but_its_own_and_those_of_every_system(self):
        folder, _ = self.kvlcc2
        text = subprocess.run(["ldd", str(next(folder.glob("binaries/*/swayaw_ship.so")))], capture_output=True, text=True, check=True).stdout
        own = {f.name for f in folder.glob("binaries/*/*")}
        system = ("linux-vdso", "libstdc++", "libm.", "libgcc_s", "libc.", "/lib", "libpthread")
        for line in text.splitlines():
            name = line.split()[0]
            self.assertTrue(name.startswith(system) or (name in own and str(folder) in line), line)

    def test_a_unit_does_what_the_simulator_does_to_the_last_bit(self):
        lines = subprocess.run([TRUTH, f"{SHIPS}/kvlcc2.toml"], capture_output=True, text=True, check=True).stdout.splitlines()
        names = ["x_m", "y_m", "psi_rad", "u_m_s", "v_m_s", "r_rad_s", "delta_rad", "thrust_N", "instruments.cog_rad", "instruments.wind_speed_m_s"]
        unit = self.unit()
        unit.set_all(**{"start.speed_m_s": 7.0, "start.x_m": 100.0, "start.y_m": -50.0, "start.psi_rad": 0.25})
        unit.set_all(current_speed_m_s=0.75, current_to_rad=1.5, delta_order_rad=-0.125)
        start = 1000.0  # the clock of the one that steps begins elsewhere
        unit.begin(start)
        order, reversals = -0.125, 0
        for i, line in enumerate(lines):
            if i == 1000:
                unit.set_all(wind_speed_m_s=12.0, wind_from_rad=2.0)
            if i == 2000:
                unit.set_all(added_X_N=1e5, added_Y_N=-2e5, added_N_N_m=3e7)
            if i == 3000:
                unit.set_all(rev_s=1.25)
            heading = unit.get("psi_rad") - 0.25
            if heading * order < 0.0 and abs(heading) >= 0.125:
                order, reversals = -order, reversals + 1
            unit.set_all(delta_order_rad=order)  # each step anew, as those do that step units
            self.assertEqual(unit.step(start + 0.1 * i, 0.1), OK)
            self.assertEqual([unit.get(name) for name in names], [float.fromhex(x) for x in line.split()], i)
        self.assertGreaterEqual(reversals, 3)
        self.assertAlmostEqual(unit.get("time_s"), start + 600.0, places=6)
        self.assertEqual(unit.call("Terminate"), OK)

    def test_two_instances_are_independent_and_reset_begins_again(self):
        a, b = self.unit(name="a"), self.unit(name="b")
        a.begin(), b.begin()
        a.set_all(delta_order_rad=0.5)
        for i in range(200):
            self.assertEqual((a.step(0.5 * i, 0.5), b.step(0.5 * i, 0.5)), (OK, OK))
        self.assertLess(a.get("psi_rad"), -0.2)  # to port
        self.assertEqual((b.get("psi_rad"), b.get("delta_order_rad")), (0.0, 0.0))
        once = a.get("x_m"), a.get("y_m")
        self.assertEqual(a.call("Reset"), OK)
        a.set_all(delta_order_rad=0.5)
        a.begin()
        self.assertEqual((a.get("x_m"), a.get("time_s")), (0.0, 0.0))
        for i in range(200):
            a.step(0.5 * i, 0.5)
        self.assertEqual((a.get("x_m"), a.get("y_m")), once)

    def test_another_ship_file_in_the_resources_can_be_named(self):
        folder, _ = self.kvlcc2
        text = pathlib.Path(f"{SHIPS}/kvlcc2_l7.toml").read_text()
        (folder / "resources/model.toml").write_text(text)
        unit = self.unit()
        unit.set_all(ship_file=b"model.toml")
        unit.begin()
        self.assertLess(unit.get("u_m_s"), 2.0)
        self.assertEqual(unit.get("ship_file"), b"model.toml")
        self.assertEqual(unit.get("start.speed_m_s"), unit.get("u_m_s"))

    def refused(self, unit, status, words):
        self.assertEqual(status, ERROR)
        status, category, text = unit.said[-1]
        self.assertEqual((status, category), (ERROR, "logStatusError"))
        self.assertIn(words, text)
        self.assertNotIn("\n", text)

    def test_what_is_wrong_is_refused_in_one_line(self):
        unit = self.unit()
        nine = (ctypes.c_uint * 1)(999999)
        one = ctypes.c_size_t(1)
        self.refused(unit, unit.step(0.0, 0.1), "fmi2DoStep cannot be called before initialization")
        self.refused(unit, unit.call("GetReal", nine, one, (ctypes.c_double * 1)()), "no Real with the value reference 999999")
        self.refused(unit, unit.call("GetInteger", nine, one, (ctypes.c_int * 1)()), "no Integer with the value reference 999999")
        self.refused(unit, unit.call("SetBoolean", nine, one, (ctypes.c_int * 1)()), "no Boolean with the value reference 999999")
        self.refused(unit, unit.call("GetReal", unit.reference("why"), one, (ctypes.c_double * 1)()), "no Real with the value reference")
        self.refused(unit, unit.set("x_m", 1.0), "x_m is an output and cannot be set")
        self.refused(unit, unit.set("start.speed_m_s", -1.0), "start.speed_m_s must be positive")
        self.refused(unit, unit.set("ship_file", b"../other.toml"), "is the name of a file in")
        self.refused(unit, unit.set_up(10.0, 5.0), "cannot run from 10 s to 5 s")
        unit.begin(0.0, 1.0)
        self.refused(unit, unit.call("EnterInitializationMode"), "cannot be called while it is simulated")
        self.refused(unit, unit.set("start.x_m", 1.0), "start.x_m is a parameter and cannot be set while it is simulated")
        self.refused(unit, unit.set("delta_order_rad", math.nan), "delta_order_rad must be a finite number")
        self.refused(unit, unit.step(0.5, 0.1), "the step begins at 0.5 s, the ship is at 0 s")
        self.refused(unit, unit.step(0.0, -0.1), "a step must not be negative")
        self.refused(unit, unit.step(0.0, 2.0), "beyond the stop time 1 s")
        self.refused(unit, unit.call("GetFMUstate", ctypes.byref(ctypes.c_void_p())), "fmi2GetFMUstate: this ship does not offer it")
        self.assertEqual(unit.step(0.0, 1.0), OK)

    def test_a_unit_that_does_not_belong_together_is_not_instantiated(self):
        for arguments, words in (
            ({"guid": "{another}"}, "is not the ship that modelDescription.xml was made of"),
            ({"resources": "http://example.org/unit"}, "must be a file URI"),
            ({"resources": "file:///nowhere"}, "/nowhere/ship.toml"),
            ({"kind": 0}, "co-simulation"),
        ):
            unit = self.unit(**arguments)
            self.assertIsNone(unit.instance.value)
            self.assertIn(words, unit.said[-1][2])

    def test_a_ship_file_that_is_wrong_is_named_with_its_line(self):
        folder, _ = self.kvlcc2
        (folder / "resources/wrong.toml").write_text('name = "x"\nmodel = "mmg"\n[hull]\nY_v = "much"\n')
        unit = self.unit()
        unit.set_all(ship_file=b"wrong.toml")
        unit.set_up()
        unit.call("EnterInitializationMode")
        self.refused(unit, unit.call("ExitInitializationMode"), "resources/wrong.toml:")

    def test_the_logger_hears_where_the_force_model_ends(self):
        unit = self.unit()
        unit.begin()
        unit.set_all(rev_s=0.0, added_X_N=-1e7)
        said = [unit.step(float(i), 1.0) for i in range(400)]
        self.assertEqual(said.count(WARNING), 1)
        self.assertEqual((unit.get("valid"), unit.get("validity")), (0, 1))
        self.assertIn(b"too little way", unit.get("why"))
        self.assertIn("too little way", unit.said[-1][2])

    def test_version_and_platform(self):
        unit = self.unit()
        self.assertEqual((unit.lib.fmi2GetVersion(), unit.lib.fmi2GetTypesPlatform()), (b"2.0", b"default"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
