"""Snapshots of fields in Python against the files of the command: the same numbers.

    PYTHONPATH=build/python ACTIO_COMMAND=build/bin/actio python3 tests/python/test_snapshots.py
"""

import copy
import csv
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
import warnings

import actio
import numpy

GAS = """
[system]
kind = "barotropic_fluid"
mesh = { shape = "box", lower = [0, 0], upper = [1, 0.5], cells = [6, 4], periodic = [true, false] }
material = { name = "polytropic_gas", K = 1, gamma = 1.4 }
[scene]
units = { mass = "kg", length = "m", time = "s" }
[initial]
placement = ["X + 0.02*sin(2*pi*X)", "Y"]
[method]
step = 0.01
[run]
until = 0.3
every = 0.1
[output]
quantities = ["energy"]
snapshots = ["pressure", "density"]
snapshot_at = [0, 0.1, 0.3]
"""
SOLID = """
[system]
kind = "elastic_body"
mesh = { shape = "disc", radius = 1, cells = [2, 4] }
material = { name = "neo_hookean", mu = 1, kappa = 2 }
[initial]
placement = ["1.1*X", "Y"]
[method]
step = 0.02
[run]
until = 0.2
[output]
quantities = ["energy"]
snapshots = ["stress", "jacobian"]
"""
ROD = """
[system]
kind = "rod"
rod = { length = 1, elements = 6, section = { EA = 90, GA = 40, EI = 1, GJ = 1, rA = 1, rI = 0.01 } }
boundary = { start = "clamped" }
load = { gravity = [0, 0, -1] }
[run]
until = 0.2
[output]
quantities = ["end_place"]
snapshots = ["contact_force"]
"""
SPHERE = """
[system]
kind = "vorticity_sphere"
N = 8
rotation = 0.7
[initial]
harmonics = [[2, 1, 0.9, -0.3], [3, 0, -0.5, 0], [4, 3, 0.4, 0.6]]
[method]
step = 0.05
[run]
until = 1
[output]
quantities = ["energy"]
snapshots = ["u", "streamfunction"]
snapshot_every = 0.5
"""


def left_by_the_command(folder, text, *arguments):
    """The folder of a run."""
    scene = pathlib.Path(folder, "scene.toml")
    scene.write_text(text)
    out = f"{folder}/out"
    command = [os.environ["ACTIO_COMMAND"], "run", scene, "--out", out, "--quiet", *arguments]
    subprocess.run(command, check=True, capture_output=True, text=True)
    return out


def table(path):
    """Columns of a table by name."""
    with open(path) as file:
        rows = list(csv.reader(file))
    return dict(zip(rows[0], numpy.array([[float(x) for x in row] for row in rows[1:]]).T))


class Fields(unittest.TestCase):
    def equal(self, a, b):
        self.assertEqual(numpy.ascontiguousarray(a).tobytes(), numpy.ascontiguousarray(b).tobytes())

    def test_those_of_a_rod_are_of_sections_and_of_elements(self):
        with tempfile.TemporaryDirectory() as folder:
            out = left_by_the_command(folder, ROD)
            for run in actio.run(text=ROD), actio.load(out):
                fields = run.snapshots
                self.assertEqual(fields["attitude"].shape, (2, 7, 4))
                self.assertEqual(fields["contact_force"].shape, (2, 6, 3))
                rows = table(f"{out}/snapshots/000001.csv")
                for i, name in enumerate("xyz"):
                    self.equal(fields["position"][1, :, i], rows[name])
                    self.assertEqual(run["end_place"][-1, i], rows[name][-1])
                rows = table(f"{out}/snapshots/000001.elements.csv")
                self.equal(fields["contact_force"][1, :, 2], rows["contact_force_z"])

    def test_those_of_a_medium_are_the_tables_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            out = left_by_the_command(folder, GAS)
            loaded = actio.load(out)
            for run in (actio.run(text=GAS), loaded):
                fields = run.snapshots
                self.assertEqual(list(fields), ["position", "velocity", "pressure", "density"])
                self.equal(fields.t, numpy.array([0, 0.1, 0.3]))
                for k in range(3):
                    rows = table(f"{out}/snapshots/{k:06}.csv")
                    for name, letters in (("position", "xy"), ("velocity", "uv")):
                        for i, letter in enumerate(letters):
                            self.equal(fields[name][k, :, i], rows[letter])
                    for i, letter in enumerate("XY"):
                        self.equal(fields.coordinates["reference"][:, i], rows[letter])
                    for name in ("pressure", "density"):
                        self.equal(fields[name][k], rows[name])
                self.assertEqual(fields.coordinates["cells"].shape, (24, 4))
                self.assertEqual(fields.coordinates["cells"].dtype, numpy.int64)
                self.equal(fields.coordinates["periods"], numpy.array([1.0, 0.0]))
                self.assertEqual(fields.axes("position"), ("time", "node", "axis"))
                self.assertEqual(fields.axes("cells"), ("cell", "corner"))
                self.assertEqual(fields.units["velocity"], "m/s")
                self.assertEqual(fields.units["density"], "kg/m^2")
                self.assertEqual(fields.units["pressure"], "J/m^2")
                self.assertFalse(fields["pressure"].flags.writeable)
            self.equal(loaded.snapshots["position"], actio.run(text=GAS).snapshots["position"])

    def test_frames_in_hdf5_are_read_as_well(self):
        with tempfile.TemporaryDirectory() as folder:
            loaded = actio.load(left_by_the_command(folder, GAS, "--set", 'output.formats=["hdf5"]'))
            self.equal(loaded.snapshots["density"], actio.run(text=GAS).snapshots["density"])

    def test_a_stress_has_its_components(self):
        with tempfile.TemporaryDirectory() as folder:
            out = left_by_the_command(folder, SOLID)
            for run in (actio.run(text=SOLID), actio.load(out)):
                self.assertEqual(run.snapshots["stress"].shape[2], 3)
                rows = table(f"{out}/snapshots/000001.csv")
                for i, name in enumerate(("xx", "xy", "yy")):
                    self.equal(run.snapshots["stress"][1, :, i], rows["stress_" + name])

    def test_those_of_a_flow_are_the_tables_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            out = left_by_the_command(folder, SPHERE)
            for run in (actio.run(text=SPHERE), actio.load(out)):
                fields = run.snapshots
                self.assertEqual(fields["u"].shape, (3, 8, 16))
                latitude, longitude = (fields.coordinates[name] for name in ("latitude", "longitude"))
                for k in range(3):
                    rows = table(f"{out}/snapshots/{k:06}.csv")
                    self.equal(numpy.repeat(latitude, 16), rows["latitude"])
                    self.equal(numpy.tile(longitude, 8), rows["longitude"])
                    for name in ("vorticity", "u", "streamfunction"):
                        self.equal(fields[name][k].ravel(), rows[name])
                    rows = table(f"{out}/snapshots/{k:06}.harmonics.csv")
                    self.equal(fields["harmonics_re"][k], rows["re"])
                    self.equal(fields["harmonics_im"][k], rows["im"])
                    self.equal(fields.coordinates["l"].astype(float), rows["l"])
                    self.equal(fields.coordinates["m"].astype(float), rows["m"])

    def test_a_key_that_is_set_is_heeded(self):
        run = actio.run(text=GAS, set={"output.snapshots": ["jacobian"], "output.snapshot_at": [0.2]})
        self.assertEqual(list(run.snapshots), ["position", "velocity", "jacobian"])
        self.equal(run.snapshots.t, numpy.array([0.2]))

    def test_who_asks_for_none_has_none(self):
        run = actio.run(text=GAS, set={"output.snapshots": None, "output.snapshot_at": None})
        self.assertFalse(run.snapshots)
        self.assertEqual(len(run.snapshots.t), 0)
        with self.assertRaisesRegex(KeyError, "there is no field 'pressure' in these snapshots"):
            run.snapshots["pressure"]
        with self.assertRaisesRegex(KeyError, "did you mean 'pressure'"):
            actio.run(text=GAS).snapshots["presure"]

    def test_an_interrupted_run_has_those_so_far(self):
        run = actio.run(text=GAS, set={"run.until": 1e6, "run.every": 1e4}, progress=lambda f, t: t > 5)
        self.assertEqual(run.summary["status"], "interrupted")
        self.equal(run.snapshots.t, numpy.array([0, 0.1, 0.3]))

    def test_they_are_copied_and_pickled_with_the_run(self):
        run = actio.run(text=GAS)
        for other in (copy.copy(run), pickle.loads(pickle.dumps(run)), copy.deepcopy(run)):
            self.equal(other.snapshots["position"], run.snapshots["position"])
        self.equal(pickle.loads(pickle.dumps(run.snapshots))["position"], run.snapshots["position"])

    def test_one_that_is_gone_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            out = left_by_the_command(folder, GAS)
            os.remove(f"{out}/snapshots/000001.csv")
            run = actio.load(out)
            self.assertEqual(run.rows, 4)
            with self.assertRaisesRegex(actio.FileError, "000001.csv: cannot be read"):
                run.snapshots

    def test_a_run_that_is_saved_warns_that_they_are_not(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertWarnsRegex(UserWarning, "^Run.save writes no snapshots"):
                actio.run(text=GAS).save(f"{folder}/saved")
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                plain = actio.run(text=GAS, set={"output.snapshots": None, "output.snapshot_at": None})
                plain.save(f"{folder}/plain")
                with self.assertRaises(actio.SceneError) as raised:
                    plain.save(f"{folder}/plain")
            self.assertTrue(str(raised.exception).endswith("Run.save takes a folder that is new or empty"))
            self.assertNotIn("--", str(raised.exception))

    def test_xarray_is_given_axes_and_coordinates_that_agree(self):
        kept = []
        fake = types.ModuleType("xarray")
        fake.Dataset = lambda fields, coords: kept.append((fields, coords))
        for text in (GAS, SOLID, SPHERE):
            with unittest.mock.patch.dict(sys.modules, {"xarray": fake}):
                actio.run(text=text).snapshots.to_xarray()
            fields, coordinates = kept.pop()
            sizes = {"time": len(coordinates["time"])}
            told = [*fields.values(), *(one for one in coordinates.values() if type(one) is tuple)]
            for axes, numbers, _ in told:
                self.assertEqual(len(axes), numbers.ndim)
                for axis, size in zip(axes, numbers.shape):
                    self.assertEqual(sizes.setdefault(axis, size), size)
        with unittest.mock.patch.dict(sys.modules, {"xarray": None}):
            with self.assertRaisesRegex(ImportError, "python3-xarray"):
                actio.run(text=GAS).snapshots.to_xarray()

    def test_xarray_takes_them_where_it_is_installed(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("xarray is not installed")
        data = actio.run(text=SPHERE).snapshots.to_xarray()
        self.assertEqual(data["u"].dims, ("time", "latitude", "longitude"))
        self.assertEqual(float(data["u"].sel(time=0.5)[0, 0]), data["u"].values[1, 0, 0])


class Inputs(unittest.TestCase):
    def test_members_of_a_sweep_are_read_with_the_same_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "start.csv")
            path.write_text("l,m,re,im\n1,0,0,0\n1,1,0.2,0.1\n")
            scene = SPHERE.replace("harmonics = [[", f'file = "{path}" # [[')
            members = iter(range(2))

            def change(fraction, done):
                if done == 1 and next(members, None) == 0:
                    # At once, so that nobody reads half of it.
                    other = pathlib.Path(folder, "other.csv")
                    other.write_text("l,m,re,im\n1,0,0,0\n1,1,0.3,0.1\n")
                    other.replace(path)

            sweep = actio.sweep(text=scene, over={"run.until": [1, 30]}, jobs=1, progress=change)
            self.assertEqual(sweep[0].status, 0)
            # The second one had begun with the first, or has the other file.
            if sweep[1].status != 0:
                self.assertEqual(sweep[1].status, 2)
                self.assertRegex(str(sweep[1].error), "start.csv: has changed since another member")


if __name__ == "__main__":
    unittest.main()
