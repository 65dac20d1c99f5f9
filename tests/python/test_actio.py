"""The package actio of Python against the command: the same numbers, held in memory without a copy.

    PYTHONPATH=build/python ACTIO_COMMAND=build/bin/actio python3 tests/python/test_actio.py
"""

import collections
import concurrent.futures
import contextlib
import copy
import csv
import enum
import fractions
import gc
import html.parser
import inspect
import io
import json
import os
import pathlib
import pickle
import re
import resource
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import types
import unittest
import unittest.mock
import warnings

import actio
import numpy

SCENE = """
[system]
kind = "rigid_body"
body = "apophis"
[initial]
angular_velocity = [0.0649, 0.001, 0.22321]
[method]
order = "exact"
step = 0.25
[run]
until = 25.0
every = 0.25
[output]
quantities = ["body_momentum", "energy", "attitude"]
"""
AS_MAPPING = {
    "system": {"kind": "rigid_body", "body": "apophis"},
    "initial": {"angular_velocity": [0.0649, 0.001, 0.22321]},
    "method": {"order": "exact", "step": 0.25},
    "run": {"until": 25.0, "every": 0.25},
    "output": {"quantities": ["body_momentum", "energy", "attitude"]},
}
FOUR_DIMENSIONS = {
    "system": {"kind": "rigid_body_n", "lambda": [1.0, 2.0, 3.0, 4.0]},
    "initial.angular_velocity": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6],
    "run": {"until": 1.0},
    "output.quantities": ["attitude", "momentum", "energy"],
}
# Hours of computing: such a run is there to be ended.
LONG = {"method.order": 2, "run.until": 2.5e11, "run.every": 2.5e10}
TOO_LONG_A_STEP = {
    "method.order": 2,
    "method.step": 25.0,
    "run.every": 25.0,
    "initial.angular_velocity": [0.5, 0.5, 0.5],
}


def command(*arguments):
    """Runs the command, which has to go well."""
    return subprocess.run(
        [os.environ["ACTIO_COMMAND"], *arguments], check=True, capture_output=True, text=True
    )


def folder_of_the_command(folder, *arguments):
    """What `actio run` leaves of the scene."""
    scene = pathlib.Path(folder, "apophis.toml")
    scene.write_text(SCENE)
    command("run", scene, "--out", f"{folder}/out", "--quiet", *arguments)
    return f"{folder}/out"


def table_of_the_command(*arguments):
    """The series that `actio run` writes for the scene: names of its columns, and its numbers."""
    with tempfile.TemporaryDirectory() as folder:
        with open(folder_of_the_command(folder, *arguments) + "/series.csv") as file:
            rows = list(csv.reader(file))
    return rows[0], numpy.array([[float(x) for x in row] for row in rows[1:]])


def momentum_of_a_scene(until):
    """The last momentum of a run, for another process."""
    return actio.run(text=SCENE, set={"run.until": until})


def pages_touched():
    """Pages of memory that this process and those that it started have touched: a cost that no load changes."""
    return sum(resource.getrusage(who).ru_minflt for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))


def interrupt_after(seconds):
    threading.Timer(seconds, lambda: os.kill(os.getpid(), signal.SIGINT)).start()


class Numbers(unittest.TestCase):
    def test_a_run_in_memory_is_that_of_the_command_bit_for_bit(self):
        for order in ["exact", 2, 8]:
            columns, table = table_of_the_command("--set", f"method.order={order}")
            run = actio.run(text=SCENE, set={"method.order": order})
            self.assertEqual(run.columns, columns)
            self.assertEqual(run.table.tobytes(), table.tobytes())

    def test_a_quantity_has_its_own_shape(self):
        run = actio.run(text=SCENE)
        self.assertEqual(run.rows, 101)
        self.assertEqual(run.t.shape, (101,))
        self.assertEqual(run["energy"].shape, (101,))
        self.assertEqual(run["body_momentum"].shape, (101, 3))
        self.assertEqual(run["attitude"].shape, (101, 4))
        for k, end in enumerate("xyz"):
            self.assertTrue(numpy.array_equal(run["body_momentum"][:, k], run["body_momentum_" + end]))
        with self.assertRaisesRegex(KeyError, "did you mean 'energy'"):
            run["enrgy"]

    def test_a_matrix_is_one_for_each_row(self):
        run = actio.run(FOUR_DIMENSIONS)
        self.assertEqual(run["attitude"].shape, (2, 4, 4))
        self.assertIs(run.matrix("attitude").base, run.table)
        self.assertTrue(numpy.array_equal(run["attitude"][0], numpy.eye(4)))
        self.assertLess(abs(run["attitude"][1] @ run["attitude"][1].T - numpy.eye(4)).max(), 1e-13)

    def test_a_skew_matrix_is_its_upper_triangle_or_whole(self):
        run = actio.run(FOUR_DIMENSIONS)
        self.assertEqual(run["momentum"].shape, (2, 6))
        whole = run.matrix("momentum")
        self.assertEqual(whole.shape, (2, 4, 4))
        self.assertTrue(numpy.array_equal(whole, -whole.transpose(0, 2, 1)))
        for column in run.columns_of("momentum"):
            i, j = (int(digit) - 1 for digit in column[-2:])
            self.assertTrue(numpy.array_equal(whole[:, i, j], run[column]))
        # M = Lambda xi + xi Lambda
        self.assertAlmostEqual(whole[0, 0, 1], (1 + 2) * 0.1, delta=1e-15)
        with self.assertRaisesRegex(ValueError, "energy is a scalar"):
            run.matrix("energy")
        with self.assertRaises(KeyError):
            run.matrix("enrgy")

    def test_the_summary_and_the_scene_are_those_of_a_run_in_a_folder(self):
        run = actio.run(text=SCENE)
        self.assertEqual(run.summary["status"], "done")
        self.assertEqual(run.summary["rows"], 101)
        self.assertIn("energy", run.summary["drift"])
        self.assertEqual(run.drift, run.summary["drift"])
        self.assertLessEqual(run.error.items(), run.summary.get("error", {}).items())
        self.assertIn('name = "moser_veselov"', run.scene)
        again = actio.run(text=run.scene)
        self.assertEqual(again.table.tobytes(), run.table.tobytes())


class Memory(unittest.TestCase):
    def test_arrays_look_into_the_table_without_a_copy(self):
        run = actio.run(text=SCENE)
        for name in ["energy", "body_momentum", "body_momentum_y", "t"]:
            self.assertTrue(numpy.shares_memory(run.table, run[name]), name)
            self.assertIs(run[name].base, run.table)
            self.assertFalse(run[name].flags.writeable)
        self.assertFalse(run.table.flags.writeable)
        self.assertTrue(run.table.flags.c_contiguous)

    def test_arrays_stay_when_the_run_is_gone(self):
        run = actio.run(text=SCENE)
        momentum, before = run["body_momentum"], run["body_momentum"].tobytes()
        del run
        gc.collect()
        others = [
            actio.run(text=SCENE, set={"initial.angular_velocity": [0.1, 0.2, 0.3 + k]}) for k in range(20)
        ]
        self.assertEqual(momentum.tobytes(), before)
        self.assertEqual(len(others), 20)

    def test_a_table_beyond_the_memory_is_refused_with_its_size(self):
        with self.assertRaisesRegex(
            actio.Error, r"^25000000001 rows of 9 columns at 8 bytes a number take 1.8 TB, and .* available"
        ):
            actio.run(text=SCENE, set={"run.every": 1e-9})

    def test_memory_that_ends_on_the_way_is_an_error_in_words(self):
        limited = (
            "import resource, actio\n"
            "resource.setrlimit(resource.RLIMIT_AS, (2**30, 2**30))\n"
            f"scene = {SCENE!r}\n"
            "try:\n    actio.run(text=scene, set={'run.every': 1e-6})\n"
            "except actio.Error as error:\n    print(error)\n"
        )
        said = subprocess.run(
            [sys.executable, "-c", limited],
            check=True,
            capture_output=True,
            text=True,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        )
        self.assertRegex(said.stdout, "memory (that is available|are available|does not suffice)")


class AMapping(unittest.TestCase):
    def setUp(self):
        self.run_ = actio.run(text=SCENE)

    def test_it_is_one_over_quantities(self):
        run = self.run_
        names = ["body_momentum", "energy", "attitude"]
        self.assertIsInstance(run, collections.abc.Mapping)
        self.assertEqual((list(run), list(run.keys()), run.quantities, len(run)), (names, names, names, 3))
        for (name, value), other in zip(run.items(), run.values()):
            self.assertTrue(numpy.array_equal(run[name], value) and numpy.array_equal(other, value))
        self.assertEqual(list(dict(run)), names)
        self.assertIsNone(run.get("enrgy"))
        self.assertEqual(run.get("energy").shape, (101,))
        for name in [*names, "t", "body_momentum_x"]:
            self.assertIn(name, run)
        for name in ["enrgy", 3, None, ("energy",), "", "energy\0"]:
            self.assertNotIn(name, run)
            with self.assertRaises(KeyError):
                run[name]

    def test_an_array_of_it_is_the_table(self):
        array = numpy.asarray(self.run_)
        self.assertIs(array, self.run_.table)
        self.assertEqual(numpy.array(self.run_).tobytes(), self.run_.table.tobytes())
        self.assertTrue(numpy.array(self.run_).flags.writeable)
        self.assertEqual(numpy.asarray(self.run_, dtype=numpy.float32).dtype, numpy.float32)

    def test_it_is_equal_to_itself_alone(self):
        other = actio.run(text=SCENE)
        self.assertEqual(self.run_, self.run_)
        self.assertNotEqual(self.run_, other)
        self.assertEqual(len({self.run_, other}), 2)

    def test_it_is_made_by_the_package_alone(self):
        with self.assertRaisesRegex(TypeError, "actio.run"):
            actio.Run()
        with self.assertRaises(AttributeError):
            self.run_.table = 3

    def test_as_a_dictionary_it_has_the_time_as_well(self):
        self.assertEqual(list(self.run_.to_dict()), ["t", "body_momentum", "energy", "attitude"])

    def test_a_data_frame_has_names_and_the_time_as_its_index(self):
        try:
            import pandas
        except ImportError:
            pandas = None
        if pandas is None:
            with self.assertRaisesRegex(ImportError, "needs pandas"):
                self.run_.to_pandas()
            seen = {}

            class DataFrame:
                def __init__(self, values, index, columns):
                    seen.update(values=values, columns=columns)
                    self.attrs, self.index = {}, index

            fake = types.SimpleNamespace(DataFrame=DataFrame, Index=lambda values, name: values)
            with unittest.mock.patch.dict(sys.modules, pandas=fake):
                frame = self.run_.to_pandas()
            self.assertEqual(seen["columns"], self.run_.columns[1:])
            self.assertTrue(numpy.array_equal(seen["values"], self.run_.table[:, 1:]))
        else:
            frame = self.run_.to_pandas()
            self.assertEqual(list(frame.columns), self.run_.columns[1:])
            self.assertTrue(numpy.array_equal(frame["energy"], self.run_["energy"]))
            self.assertTrue(numpy.array_equal(pandas.DataFrame(self.run_).to_numpy(), self.run_.table))
        self.assertTrue(numpy.array_equal(frame.index, self.run_.t))
        self.assertEqual(frame.attrs["units"], self.run_.units)

    def test_pandas_is_not_imported_before_it_is_asked_for(self):
        said = subprocess.run(
            [sys.executable, "-c", "import actio, sys; print('pandas' in sys.modules)"],
            check=True,
            capture_output=True,
            text=True,
        )
        self.assertEqual(said.stdout, "False\n")


class WhatIsToldOfARun(unittest.TestCase):
    def test_units_and_meanings(self):
        run = actio.run(text=SCENE)
        self.assertEqual(list(run.units), ["t", "body_momentum", "energy", "attitude"])
        self.assertEqual((run.units["t"], run.units["attitude"]), ("h", "1"))
        self.assertRegex(run.units["body_momentum"], r"\bh\b")
        self.assertEqual(set(run.meanings), set(run))
        self.assertEqual(actio.run(FOUR_DIMENSIONS).units["t"], "time")

    def test_all_that_is_known_of_a_quantity(self):
        run = actio.run(text=SCENE)
        info = run.quantity_info("body_momentum")
        self.assertEqual(
            (info["kind"], info["shape"], info["columns"]),
            ("vector", (3,), ["body_momentum_x", "body_momentum_y", "body_momentum_z"]),
        )
        self.assertTrue(info["formula"] and info["meaning"])
        self.assertEqual(run.columns_of("body_momentum"), info["columns"])
        info["columns"].clear()
        self.assertEqual(len(run.columns_of("body_momentum")), 3)
        self.assertTrue(run.quantity_info("energy")["conserved"])
        with self.assertRaisesRegex(KeyError, "did you mean 'energy'"):
            run.quantity_info("enrgy")

    def test_a_notebook_shows_the_head_of_the_table(self):
        run = actio.run(text=SCENE, set={"scene.title": "<script>alert(1)</script>&"})
        page = run._repr_html_()
        self.assertNotIn("<script", page)
        self.assertIn("&lt;script", page)
        self.assertRegex(page, r"101 rows to t = 25; drift: energy \d")
        self.assertEqual(page.count("<tr>"), 6)
        self.assertIn("96 rows more", page)
        open_tags = []

        class Balance(html.parser.HTMLParser):
            def handle_starttag(self, tag, attributes):
                open_tags.append(tag)

            def handle_endtag(self, tag):
                assert open_tags.pop() == tag

        Balance().feed(page)
        self.assertEqual(open_tags, [])

    def test_in_one_line(self):
        self.assertEqual(
            repr(actio.run(text=SCENE)), "<actio.Run: 101 rows to t = 25 of body_momentum, energy, attitude>"
        )

    def test_an_estimate_of_the_error_is_read_from_the_summary(self):
        run = actio.run(text=SCENE)
        told = {**run.summary, "error": {"attitude": 1e-7, "momentum": 2e-8, "how": "guessed"}}
        other = actio.Run._of(run.table, {**run._about, "summary": json.dumps(told)})
        self.assertEqual(other.error, {"attitude": 1e-7, "momentum": 2e-8})
        self.assertIn("error: attitude 1.0e-07, momentum 2.0e-08", other._repr_html_())
        self.assertEqual(other.untold, {})

    def test_a_sentence_stands_where_there_is_no_number(self):
        run = actio.run(text=SCENE)
        said = "no number after t = 5, when it was 1.0e-03 rad"
        told = {**run.summary, "error": {"attitude": said, "momentum": 2e-8, "how": "guessed"}}
        other = actio.Run._of(run.table, {**run._about, "summary": json.dumps(told)})
        self.assertEqual(other.error, {"momentum": 2e-8})
        self.assertEqual(other.untold, {"attitude": said})
        self.assertIn(f"error of attitude: {said}", other._repr_html_())


class Copies(unittest.TestCase):
    def same(self, one, other):
        self.assertEqual(one.table.tobytes(), other.table.tobytes())
        self.assertEqual(
            (one.columns, one.quantities, one.scene, one.summary, one.units),
            (other.columns, other.quantities, other.scene, other.summary, other.units),
        )
        self.assertFalse(other.table.flags.writeable)
        self.assertEqual(other["body_momentum"].shape, one["body_momentum"].shape)

    def test_a_run_can_be_pickled(self):
        run = actio.run(text=SCENE)
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            self.same(run, pickle.loads(pickle.dumps(run, protocol)))

    def test_a_run_can_be_copied(self):
        run = actio.run(text=SCENE)
        self.same(run, copy.copy(run))
        self.same(run, copy.deepcopy(run))
        self.assertIs(copy.copy(run).table, run.table)
        self.assertFalse(numpy.shares_memory(copy.deepcopy(run).table, run.table))

    def test_other_processes_hand_runs_back(self):
        with concurrent.futures.ProcessPoolExecutor(2) as pool:
            for until, run in zip([5.0, 10.0], pool.map(momentum_of_a_scene, [5.0, 10.0])):
                self.assertEqual(run.table.tobytes(), momentum_of_a_scene(until).table.tobytes())

    def test_errors_can_be_pickled_with_the_rows_they_carry(self):
        for error in self.errors():
            other = pickle.loads(pickle.dumps(error))
            self.assertIs(type(other), type(error))
            self.assertEqual(str(other), str(error))

    def errors(self):
        for bad in [{"method.step": "fast"}, TOO_LONG_A_STEP]:
            try:
                actio.run(text=SCENE, set=bad)
            except actio.Error as error:
                yield error

    def test_sweeps_can_be_pickled(self):
        sweep = actio.sweep(text=SCENE, over={"method.order": [2, "x"]})
        other = pickle.loads(pickle.dumps(sweep))
        self.assertEqual([member.values for member in other], [member.values for member in sweep])
        self.same(sweep[0].run, other[0].run)
        self.assertEqual(str(other[1].error), str(sweep[1].error))


class Arguments(unittest.TestCase):
    def test_values_of_python_and_of_numpy_set_keys(self):
        plain = actio.run(text=SCENE, set={"method.order": 4, "method.step": 0.125, "run.every": 5.0})
        numbers = [numpy.int64(4), numpy.float64(0.125), numpy.array(5.0)]
        for order, step, every in [
            numbers,
            [enum.IntEnum("Order", {"four": 4}).four, fractions.Fraction(1, 8), numpy.float32(5)],
            [numpy.uint8(4), numpy.longdouble(0.125), numpy.float16(5)],
        ]:
            run = actio.run(text=SCENE, set={"method.order": order, "method.step": step, "run.every": every})
            self.assertEqual(plain.table.tobytes(), run.table.tobytes())
        self.assertEqual(plain.summary["steps"], 200)
        for vector in [numpy.array([0.1, 0.2, 0.3]), (0.1, 0.2, 0.3), [numpy.float64(0.1), 0.2, 0.3]]:
            listed = actio.run(
                text=SCENE, set={"initial.angular_velocity": vector, "scene.title": 'a "title"\\\x01\n\té'}
            )
            self.assertIn("angular_velocity = [0.1, 0.2, 0.3]", listed.scene)
            self.assertEqual(listed.summary["title"], 'a "title"\\\x01\n\té')

    def test_any_mapping_sets_keys(self):
        plain = actio.run(text=SCENE, set={"method.order": 4, "run.every": 5.0})
        for table in [
            types.MappingProxyType({"method.order": 4, "run.every": 5.0}),
            {
                "method": {"order": 4, "step": 0.25},
                "run": types.MappingProxyType({"until": 25.0, "every": 5.0}),
            },
            collections.OrderedDict({"method.order": 4, "run.every": 5.0}),
            collections.ChainMap({"method.order": 4}, {"run.every": 5.0}),
        ]:
            self.assertEqual(actio.run(text=SCENE, set=table).table.tobytes(), plain.table.tobytes())
        self.assertEqual(actio.run(text=SCENE, set={}).rows, 101)

    def test_a_mapping_takes_the_place_of_the_table_that_was_there(self):
        plain = SCENE.replace('order = "exact"\n', "")
        for text in [
            plain + '[system.torque]\npotential = "r33"\n',
            plain.replace('"apophis"\n', '"apophis"\ntorque = { potential = "r33" }\n'),
        ]:
            for table, left in [
                ({"system.torque": {"potential": "2*r33"}}, True),
                ({"system.torque": {"potential": None, "uniform_gravity": None}}, None),
                ({"system.torque": {}}, None),
                ({"system.torque": None}, False),
            ]:
                if left is None:
                    with self.assertRaisesRegex(actio.SceneError, "torque. needs one of"):
                        actio.run(text=text, set=table)
                else:
                    self.assertEqual("2*r33" in actio.run(text=text, set=table).scene, left)
        self.assertEqual(actio.run(text=SCENE, set={"run": {"until": 25.0}}).rows, 2)
        self.assertEqual(actio.run(text=SCENE, set={"run": {"until": 25.0, "every": None}}).rows, 2)
        with self.assertRaisesRegex(actio.SceneError, "needs 'until'"):
            actio.run(text=SCENE, set={"run": {"every": 5.0}})

    def test_none_takes_a_key_out(self):
        with self.assertRaisesRegex(actio.SceneError, "body"):
            actio.run(text=SCENE, set={"system.inertia": [0.6, 0.8, 1.0]})
        run = actio.run(text=SCENE, set={"system.body": None, "system.inertia": [0.6, 0.8, 1.0]})
        self.assertNotIn('apophis"', run.scene)
        self.assertEqual(
            actio.run(
                text=SCENE, set={"run.every": None, "scene.seed": None, "nothing.like_it": None}
            ).rows,
            2,
        )
        with self.assertRaisesRegex(actio.SceneError, "section|kind"):
            actio.run(text=SCENE, set={"system": None})

    def test_a_scene_may_be_a_mapping(self):
        plain = actio.run(text=SCENE)
        proxy = types.MappingProxyType(
            {section: types.MappingProxyType(keys) for section, keys in AS_MAPPING.items()}
        )
        flat = {
            f"{section}.{key}": value for section, keys in AS_MAPPING.items() for key, value in keys.items()
        }
        for scene in [AS_MAPPING, proxy, flat, {**AS_MAPPING, "run.at": None}]:
            self.assertEqual(actio.run(scene).table.tobytes(), plain.table.tobytes())
        self.assertEqual(actio.run(AS_MAPPING, set={"run.every": None}).rows, 2)
        self.assertEqual(actio.run({**AS_MAPPING, "scene": {"title": "mine"}}).summary["title"], "mine")

    def test_what_is_wrong_with_a_mapping_is_told_by_its_key(self):
        for change, said in [
            ({"method.step": "fast"}, r"^method\.step: "),
            ({"system.inertia": [1.0]}, r"^system\.\w+: "),
            ({"system.x y": 1}, r"^system\.\"x y\": unknown key"),
            ({"sytsem.kind": "a"}, r"^sytsem: .*did you mean 'system'"),
            ({"run": 3}, r"run"),
        ]:
            scene = {
                f"{section}.{key}": value
                for section, keys in AS_MAPPING.items()
                if change != {"run": 3} or section != "run"
                for key, value in keys.items()
            }
            with self.assertRaisesRegex(actio.SceneError, said):
                actio.run({**scene, **change})
        with self.assertRaisesRegex(actio.SceneError, "twice"):
            actio.run({**AS_MAPPING, "run.until": 3})
        with self.assertRaisesRegex(actio.SceneError, "value and a table"):
            actio.run({"run.until": 3, "run.until.deeper": 3})
        with self.assertRaises(actio.SceneError):
            actio.run({})

    def test_a_scene_is_read_from_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "apophis.toml")
            path.write_text(SCENE)
            self.assertEqual(actio.run(path).table.tobytes(), actio.run(text=SCENE).table.tobytes())
            self.assertEqual(actio.run(str(path)).summary["title"], "apophis")
            self.assertEqual(os.listdir(folder), ["apophis.toml"])
            strange = os.path.join(os.fsencode(folder), b"no\xffutf8.toml")
            with open(strange, "w") as file:
                file.write(SCENE)
            self.assertEqual(actio.run(os.fsdecode(strange)).rows, 101)

    def test_what_is_no_path_is_not_made_one(self):
        for scene in [3, b"a.toml", 1.5, ["a.toml"], object(), True]:
            with self.assertRaisesRegex(TypeError, "^scene: a path or a mapping is expected, found"):
                actio.run(scene)
        for arguments in [{}, {"scene": "a.toml", "text": SCENE}]:
            with self.assertRaisesRegex(TypeError, "either a scene"):
                actio.run(**arguments)
        with self.assertRaisesRegex(TypeError, "^text: "):
            actio.run(text=b"a")
        with self.assertRaisesRegex(actio.SceneError, "text="):
            actio.run(SCENE)

    def test_files_that_a_run_in_memory_does_not_write_are_warned_of(self):
        for change in [
            {"output.plots": True},
            {"output": {"quantities": ["energy"], "formats": ["hdf5"]}},
        ]:
            with self.assertWarnsRegex(UserWarning, r"^output\.\w+ has no effect on a run in memory") as seen:
                actio.run(text=SCENE, set=change)
            self.assertEqual(seen.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            actio.run(text=SCENE, set={"output.quantities": ["energy"]})

    def test_names_of_arguments_are_checked(self):
        for arguments in [{"progress": 3}, {"set": [("a", 1)]}, {"set": "method.step=1"}]:
            with self.assertRaises(TypeError):
                actio.run(text=SCENE, **arguments)
        with self.assertRaisesRegex(ValueError, "'raise' or 'return'"):
            actio.run(text=SCENE, on_interrupt="stop")


class Hostile(unittest.TestCase):
    """Whatever comes in: an error of actio, or TypeError or ValueError with a sentence, and nothing of the
    machinery below."""

    def refused(self, call, *, allowed=(actio.Error, TypeError, ValueError)):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                call()
            except allowed as error:
                said = str(error)
                self.assertNotRegex(said, r"pybind|C\+\+|std::|incompatible function arguments|PYBIND11")
                self.assertGreater(len(said.split()), 3, said)
                self.assertLess(len(said), 5000)
                said.encode("utf-8")
                return said
        self.fail("it was taken")

    def values(self):
        class BadList:
            def tolist(self):
                raise RuntimeError("no list here")

        class ListOfItself:
            def tolist(self):
                return self

        class Endless(list):
            def __iter__(self):
                return iter(int, 1)

        class BadPath(os.PathLike):
            def __fspath__(self):
                return 3

        class BadRepr:
            def __repr__(self):
                raise RuntimeError("no repr")

        class BadFloat(fractions.Fraction):
            def __float__(self):
                raise OverflowError("too large")

        class BadItems(collections.abc.Mapping):
            def __getitem__(self, key):
                raise KeyError(key)

            def __iter__(self):
                raise RuntimeError("no keys")

            def __len__(self):
                return 1

        of_itself = []
        of_itself.append(of_itself)
        deep = []
        for _ in range(100000):
            deep = [deep]
        wide = [1.0] * 10
        for _ in range(20):
            wide = [wide] * 10
        of_itself_by_name = {}
        of_itself_by_name["a"] = of_itself_by_name
        return [
            10**30,
            -(10**30),
            2**63,
            10**5000,
            float("nan"),
            float("inf"),
            -float("inf"),
            1e308 * 10,
            1j,
            b"bytes",
            bytearray(b"x"),
            "\ud800",
            "a\0b",
            "\udcff" * 1000,
            object(),
            object,
            len,
            {1, 2},
            range(3),
            iter([1]),
            (x for x in [1]),
            {"a": 1},
            {},
            of_itself_by_name,
            numpy.nan,
            numpy.array([1 + 2j]),
            numpy.datetime64("2020-01-01"),
            numpy.array(["a", None], dtype=object),
            numpy.zeros((3, 3, 3)),
            numpy.zeros(0),
            numpy.ma.masked,
            numpy.float64("nan"),
            BadList(),
            ListOfItself(),
            Endless(),
            BadPath(),
            BadRepr(),
            BadFloat(1, 2),
            BadItems(),
            of_itself,
            deep,
            wide,
            [],
            "",
            True,
            [None],
            [{}],
            "x" * 10_000_000,
            Ellipsis,
            NotImplemented,
            pathlib.Path("a\0b"),
            fractions.Fraction(10**400),
            enum.Enum("E", "a").a,
            memoryview(b"ab"),
            Exception("x"),
        ]

    def test_values(self):
        for number, value in enumerate(self.values()):
            for key in ["run.until", "initial.angular_velocity", "system.kind"]:
                with self.subTest(number=number, kind=type(value).__name__, key=key):
                    said = self.refused(lambda: actio.run(text=SCENE, set={key: value}))
                    self.assertRegex(said, "set|run|initial|system|text")
            self.refused(lambda: actio.run({**AS_MAPPING, "method": {"order": value, "step": 0.25}}))
            self.refused(lambda: actio.sweep(text=SCENE, over={"run.until": [value]}, on_error="raise"))

    def test_keys(self):
        for key in [
            3,
            None,
            b"run.until",
            ("run", "until"),
            "",
            ".",
            "run.",
            ".until",
            "run..until",
            "run.until=5 #",
            "a\nb",
            "run.until\n",
            "=",
            "\ud800",
            "x" * 100000,
            ".".join(["a"] * 5000),
            "run until",
            '"',
            'run."until',
            "[run]",
            "#",
            "\0",
            "é",
            object(),
            "run.until[",
            "run.until[x]",
            "run.until[0",
        ]:
            self.refused(lambda: actio.run(text=SCENE, set={key: 5.0}))
            self.refused(lambda: actio.run({key: 5.0}))
            self.refused(lambda: actio.run({"run": {key: 5.0}}))
            self.refused(lambda: actio.sweep(text=SCENE, over={key: [5.0]}, on_error="raise"))

    def test_scenes(self):
        for scene in [
            *self.values(),
            3,
            "",
            "no_such.toml",
            "/",
            "/dev/zero",
            ".",
            "a" * 100000,
            "a\0b",
            {"system": None},
            {"system": 3},
            {3: 4},
        ]:
            self.refused(lambda: actio.run(scene))
            self.refused(lambda: actio.sweep(scene, over={"run.until": [5.0]}, on_error="raise"))
            self.refused(lambda: actio.load(scene))

    def test_texts(self):
        for text in [
            "",
            "\ud800",
            "\0",
            "x" * 5_000_000,
            "[",
            "a=" + "[" * 100000,
            "\ufeff",
            3,
            b"",
            object(),
            "[system]\nkind = 3",
        ]:
            self.refused(lambda: actio.run(text=text))

    def test_arguments_of_a_sweep(self):
        for over in [
            None,
            3,
            [],
            {},
            {"method.step": []},
            {"method.step": 0.1},
            {"method.step": "abc"},
            {"method.step": None},
            {3: [1]},
            {"method.step": numpy.float64(1)},
            {"run.until": iter(int, 1)},
            {"a": range(2000), "b": range(2000)},
            {"a": {"b": 1}},
        ]:
            self.refused(lambda: actio.sweep(text=SCENE, over=over))
        for jobs in [0, -1, 1.5, "2", 10**9, True]:
            self.refused(lambda: actio.sweep(text=SCENE, over={"method.order": [2]}, jobs=jobs))
        for choice in [{"on_error": "x"}, {"on_error": 3}, {"on_interrupt": []}, {"progress": "x"}]:
            self.refused(lambda: actio.sweep(text=SCENE, over={"method.order": [2]}, **choice))

    def test_folders(self):
        run = actio.run(text=SCENE)
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "mine").write_text("mine")
            for path in [
                3,
                b"x",
                "a\0b",
                "\ud800",
                folder,
                folder + "/mine",
                folder + "/mine/deeper",
                "",
                None,
                "a" * 100000,
            ]:
                self.refused(lambda: run.save(path))
                self.refused(lambda: actio.load(path))
            self.assertEqual(os.listdir(folder), ["mine"])


class Failures(unittest.TestCase):
    def test_a_wrong_scene_is_pointed_at(self):
        with self.assertRaisesRegex(
            actio.SceneError, r"^text:14:15: unknown quantity 'enrgy'; did you mean 'energy'\?"
        ):
            actio.run(text=SCENE.replace('"body_momentum", "energy", "attitude"', '"enrgy"'))
        with self.assertRaisesRegex(actio.SceneError, "there is no such file"):
            actio.run("no_such_scene.toml")
        with self.assertRaisesRegex(actio.SceneError, r"^set: method.step=\"fast\":1:13: "):
            actio.run(text=SCENE, set={"method.step": "fast"})
        self.assertTrue(issubclass(actio.SceneError, actio.Error))
        self.assertEqual(f"{actio.SceneError.__module__}.{actio.SceneError.__qualname__}", "actio.SceneError")

    def test_a_step_beyond_its_bound_is_an_error_of_the_numerics(self):
        with self.assertRaises(actio.NumericsError) as caught:
            actio.run(text=SCENE, set=TOO_LONG_A_STEP)
        self.assertEqual(caught.exception.run.summary["status"], "failed")
        self.assertLess(caught.exception.run.rows, 2)


class LongRuns(unittest.TestCase):
    def test_ctrl_c_ends_a_run_and_leaves_its_rows(self):
        interrupt_after(0.4)
        # It would take days.
        with self.assertRaises(KeyboardInterrupt) as caught:
            actio.run(text=SCENE, set={**LONG, "run.every": 2.5e4})
        run = caught.exception.run
        self.assertEqual(run.summary["status"], "interrupted")
        self.assertEqual((run.rows, run.summary["rows"]), (len(run.t), len(run.t)))
        self.assertTrue(numpy.array_equal(run.t, 2.5e4 * numpy.arange(run.rows)))

    def test_ctrl_c_may_return_the_rows(self):
        interrupt_after(0.3)
        run = actio.run(text=SCENE, set=LONG, on_interrupt="return")
        self.assertEqual(run.summary["status"], "interrupted")
        self.assertIn("interrupted", repr(run))

    def test_other_threads_go_on_meanwhile(self):
        counted = []

        def count():
            while not counted or counted[-1] < 20:
                counted.append(len(counted))
                time.sleep(0.001)
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=count).start()
        with self.assertRaises(KeyboardInterrupt):
            actio.run(text=SCENE, set=LONG)
        self.assertEqual(counted[-1], 20)

    def test_a_function_is_told_how_far_it_is_and_may_end_it(self):
        seen = []
        run = actio.run(
            text=SCENE, set=LONG, progress=lambda fraction, t: seen.append((fraction, t)) or len(seen) == 3
        )
        self.assertEqual(len(seen), 3)
        self.assertEqual(seen, sorted(seen))
        for fraction, t in seen:
            self.assertTrue(0 < fraction < 1)
            self.assertAlmostEqual(fraction, t / 2.5e11, delta=1e-12)
        self.assertEqual(run.summary["status"], "interrupted")

    def test_it_is_told_of_the_end(self):
        seen = []
        run = actio.run(text=SCENE, progress=lambda *where: seen.append(where))
        self.assertEqual(seen[-1], (1.0, 25.0))
        self.assertEqual(run.summary["status"], "done")

    def test_what_it_raises_comes_out_with_the_rows(self):
        def fail(fraction, t):
            raise LookupError("mine")

        class NoTruth:
            def __bool__(self):
                raise LookupError("mine")

        for progress in [fail, lambda fraction, t: NoTruth(), lambda: None]:
            with self.assertRaises((LookupError, TypeError)) as caught:
                actio.run(text=SCENE, set=LONG, progress=progress)
            self.assertEqual(caught.exception.run.rows, 1)

    def test_an_alarm_ends_a_run_with_its_own_exception(self):
        def ring(*_):
            raise TimeoutError("too long")

        before = signal.signal(signal.SIGALRM, ring)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.3)
            with self.assertRaises(TimeoutError) as caught:
                actio.run(text=SCENE, set=LONG)
            self.assertEqual(caught.exception.run.rows, 1)
        finally:
            signal.signal(signal.SIGALRM, before)


class Folders(unittest.TestCase):
    def test_the_run_of_the_command_is_loaded_bit_for_bit(self):
        for formats in ['["csv"]', '["hdf5"]', '["hdf5", "csv"]']:
            with tempfile.TemporaryDirectory() as folder:
                out = folder_of_the_command(
                    folder, "--set", "output.formats=" + formats, "--set", "method.order=4"
                )
                run, here = actio.load(pathlib.Path(out)), actio.run(text=SCENE, set={"method.order": 4})
                self.assertEqual(run.table.tobytes(), here.table.tobytes())
                self.assertEqual((run.columns, run.units, run.drift), (here.columns, here.units, here.drift))
                self.assertEqual(run.summary, json.loads(pathlib.Path(out, "summary.json").read_text()))
                self.assertEqual(run.scene, pathlib.Path(out, "scene.toml").read_text())
                self.assertFalse(run.table.flags.writeable)

    def test_a_run_that_was_killed_is_loaded_as_far_as_it_is(self):
        for ending in [signal.SIGINT, signal.SIGKILL]:
            for formats in ['["csv"]', '["hdf5"]']:
                with tempfile.TemporaryDirectory() as folder:
                    scene = pathlib.Path(folder, "apophis.toml")
                    scene.write_text(SCENE)
                    arguments = [
                        "--set",
                        "method.order=2",
                        "--set",
                        "run.until=2.5e9",
                        "--set",
                        "run.every=2500",
                        "--set",
                        "output.formats=" + formats,
                    ]
                    going = subprocess.Popen(
                        [os.environ["ACTIO_COMMAND"], "run", scene, "--out", folder + "/out", *arguments],
                        stderr=subprocess.DEVNULL,
                    )
                    loaded = None
                    for _ in range(600):
                        time.sleep(0.05)
                        try:
                            loaded = actio.load(folder + "/out")
                        except actio.Error:
                            continue
                        if loaded.rows > 10:
                            break
                    self.assertEqual(loaded.summary["status"], "unfinished")
                    going.send_signal(ending)
                    going.wait()
                    run = actio.load(folder + "/out")
                    self.assertGreaterEqual(run.rows, loaded.rows)
                    self.assertEqual(
                        run.summary["status"], "interrupted" if ending == signal.SIGINT else "unfinished"
                    )
                    self.assertEqual(run.summary["rows"], run.rows)
                    until = {"method.order": 2, "run.every": 2500, "run.until": 2500 * (loaded.rows - 1)}
                    here = actio.run(text=SCENE, set=until)
                    self.assertEqual(run.table[: loaded.rows].tobytes(), here.table.tobytes())

    def test_a_saved_run_is_what_the_command_leaves(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder_of_the_command(folder))
            run = actio.load(out)
            saved = pathlib.Path(folder, "deeper", "saved")
            run.save(saved, plots=True)
            there = sorted(path.name for path in saved.iterdir() if not path.name.startswith("."))
            self.assertEqual(there, ["plots", "scene.toml", "series.csv", "summary.json"])
            for name in ["series.csv", "scene.toml", "summary.json"]:
                self.assertEqual((saved / name).read_bytes(), (out / name).read_bytes(), name)
            self.assertIn("index.html", os.listdir(saved / "plots"))
            self.assertEqual(actio.load(saved).table.tobytes(), run.table.tobytes())
            with self.assertRaisesRegex(actio.SceneError, "not empty"):
                run.save(saved)

    def test_a_folder_without_a_run_is_told_apart(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(actio.SceneError, "no run in this folder"):
                actio.load(folder)
            with self.assertRaisesRegex(actio.SceneError, "none of that name"):
                actio.load(folder + "/none")
            pathlib.Path(folder, "sweep.csv").write_text("member\n")
            with self.assertRaisesRegex(actio.SceneError, "folder of a sweep"):
                actio.load(folder)
            out = pathlib.Path(folder_of_the_command(folder))
            (out / "series.csv").write_text("t,nonsense\n1,2\n")
            with self.assertRaisesRegex(actio.FileError, "columns"):
                actio.load(out)


class Sweeps(unittest.TestCase):
    OVER = {
        "method.order": [2, 4],
        "initial.angular_velocity": [[0.06, 0.0, 0.2], numpy.array([0.05, 0.001, 0.2]), (0.1, 0.0, 0.1)],
    }

    def test_members_are_the_runs_of_each_combination_the_last_key_the_fastest(self):
        sweep = actio.sweep(text=SCENE, over=self.OVER, set={"run.every": 5.0})
        self.assertEqual(
            (len(sweep), sweep.swept, len(sweep.runs), sweep.errors), (6, list(self.OVER), 6, [])
        )
        self.assertEqual([member.index for member in sweep], list(range(6)))
        self.assertEqual([member.values["method.order"] for member in sweep], [2, 2, 2, 4, 4, 4])
        for member in sweep:
            alone = actio.run(text=SCENE, set={"run.every": 5.0, **member.values})
            self.assertEqual(member.run.table.tobytes(), alone.table.tobytes())
        self.assertEqual([member.index for member in sweep[-2:]], [4, 5])
        self.assertIs(sweep[-1].run, sweep.runs[-1])

    def test_threads_give_the_digits_of_one_alone(self):
        scenes = [
            (AS_MAPPING, {"method.order": ["exact", 2, 4, 6, 8, 10]}),
            (FOUR_DIMENSIONS, {"method.name": ["moser_veselov", "natural_chart"], "run.every": [0.25, 0.5]}),
            (
                pathlib.Path(__file__).parents[2] / "data/scenes/nodding_top.toml",
                {"run.until": [1.0, 2.0, 3.0]},
            ),
        ]
        for scene, over in scenes:
            over = {
                **over,
                "initial.angular_velocity": [
                    [0.1 + 0.01 * k, 0.2, 0.3] + ([0.4, 0.5, 0.6] if scene is FOUR_DIMENSIONS else [])
                    for k in range(8)
                ],
            }
            many = actio.sweep(scene, over=over, jobs=8)
            one = actio.sweep(scene, over=over, jobs=1)
            self.assertEqual(many.errors, [])
            for a, b in zip(many, one):
                self.assertEqual(a.run.table.tobytes(), b.run.table.tobytes())

    def test_what_goes_wrong_stays_with_its_member(self):
        sweep = actio.sweep(
            text=SCENE,
            over={"method.order": [2, "x", "exact"], "method.step": [0.25, 25.0, None]},
            set={"initial.angular_velocity": [0.5, 0.5, 0.5], "run.every": 25.0},
        )
        self.assertEqual([member.status for member in sweep], [0, 3, 0, 2, 2, 2, 0, 0, 0])
        self.assertIsInstance(sweep[1].error, actio.NumericsError)
        self.assertIsInstance(sweep[3].error, actio.SceneError)
        self.assertIsNone(sweep[3].run)
        self.assertEqual([member.index for member in sweep.errors], [1, 3, 4, 5])
        self.assertIn("failed", repr(sweep))
        with self.assertRaises(actio.SceneError) as caught:
            actio.sweep(text=SCENE, over={"method.order": [2, "x"]}, on_error="raise", jobs=1)
        self.assertEqual(caught.exception.sweep[0].status, 0)

    def test_its_table_is_that_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder, "apophis.toml")
            scene.write_text(SCENE)
            command(
                "sweep",
                scene,
                "--over",
                "method.order=2,4",
                "--over",
                "method.step=0.25,0.125",
                "--out",
                folder + "/out",
            )
            with open(folder + "/out/sweep.csv") as file:
                rows = list(csv.DictReader(file))
            table = actio.sweep(scene, over={"method.order": [2, 4], "method.step": [0.25, 0.125]}).table
        for name in rows[0]:
            if name.startswith(("last_", "drift_")) or name in (
                "member",
                "method.order",
                "method.step",
                "status",
                "steps",
            ):
                self.assertEqual([float(row[name]) for row in rows], table[name], name)

    def test_its_table_has_a_row_for_each_member(self):
        table = actio.sweep(text=SCENE, over={"method.order": [2, "x"]}).table
        self.assertEqual(
            list(table)[:6], ["member", "method.order", "status", "message", "steps", "wall_seconds"]
        )
        self.assertTrue(all(len(values) == 2 for values in table.values()))
        self.assertEqual((table["status"], table["steps"]), ([0, 2], [100, None]))
        self.assertIn("order", table["message"][1])
        self.assertIsNone(table["drift_energy"][1])

    def test_a_data_frame_and_a_page(self):
        sweep = actio.sweep(text=SCENE, over={"method.order": [2, "<x>"]})
        frames = []

        class DataFrame(dict):
            def set_index(self, name):
                frames.append((self, name))
                return self

        with unittest.mock.patch.dict(sys.modules, pandas=types.SimpleNamespace(DataFrame=DataFrame)):
            sweep.to_pandas()
        self.assertEqual(frames, [(sweep.table, "member")])
        page = sweep._repr_html_()
        self.assertEqual(page.count("<tr>"), 3)
        self.assertNotIn("<x>", page)

    def test_progress_counts_members_and_may_end_it(self):
        seen = []
        actio.sweep(
            text=SCENE,
            over={"run.until": [5.0, 10.0, 15.0]},
            progress=lambda fraction, done: seen.append((fraction, done)),
        )
        self.assertEqual(seen[-1], (1.0, 3))
        self.assertEqual(seen, sorted(seen))
        sweep = actio.sweep(
            text=SCENE, over={"method.step": [0.25, 0.125]}, set=LONG, progress=lambda fraction, done: True
        )
        self.assertEqual([member.status for member in sweep], [130, 130])
        self.assertIsInstance(sweep[0].error, actio.Stopped)
        with self.assertRaisesRegex(LookupError, "mine") as caught:
            actio.sweep(
                text=SCENE, over={"method.step": [0.25]}, set=LONG, progress=lambda fraction, done: {}["mine"]
            )
        self.assertEqual(len(caught.exception.sweep), 1)

    def test_ctrl_c_ends_it_and_leaves_what_is_done(self):
        over = {"run.until": [5.0, 2.5e11], "method.step": [0.25, 0.125, 0.0625]}
        interrupt_after(0.5)
        with self.assertRaises(KeyboardInterrupt) as caught:
            actio.sweep(text=SCENE, over=over, set={"method.order": 2, "run.every": None})
        self.assertEqual([member.status for member in caught.exception.sweep], [0, 0, 0, 130, 130, 130])
        interrupt_after(0.5)
        sweep = actio.sweep(
            text=SCENE, over=over, set={"method.order": 2, "run.every": None}, on_interrupt="return"
        )
        self.assertEqual(len(sweep.runs), 3)

    def test_a_small_member_costs_little(self):
        over = {"initial.angular_velocity": [[0.0649, 0.001 * k, 0.22321] for k in range(500)]}
        before = pages_touched()
        sweep = actio.sweep(text=SCENE, over=over)
        self.assertEqual(sweep.errors, [])
        # A few hold the rows of a member; a process for each would touch a thousand.
        self.assertLess((pages_touched() - before) / 500, 100)


class WhatThereIs(unittest.TestCase):
    def test_systems_are_those_of_the_command(self):
        told = json.loads(command("list", "systems", "--json").stdout)
        self.assertEqual(list(actio.systems().values()), told)
        for kind in actio.systems():
            self.assertEqual(
                list(actio.quantities(kind)),
                [quantity["name"] for quantity in actio.systems()[kind]["quantities"]],
            )
        self.assertEqual(actio.quantities("heavy_top")["energy"]["kind"], "scalar")
        for kind in ["heavy", 3, None]:
            with self.assertRaisesRegex(actio.SceneError, "rigid_body"):
                actio.quantities(kind)

    def test_bodies_and_groups_are_those_of_the_command(self):
        for what, found in [("bodies", actio.bodies()), ("groups", actio.groups())]:
            names = [re.split(r"\s{2,}", line)[0] for line in command("list", what).stdout.splitlines()]
            self.assertEqual(list(found), names)
        apophis = actio.bodies()["apophis"]
        self.assertEqual(
            (len(apophis["moments"]), apophis["time"], numpy.shape(apophis["axes"])), (3, "h", (3, 3))
        )
        json.dumps([actio.bodies(), actio.groups(), actio.systems()])


class ThePackage(unittest.TestCase):
    def test_it_tells_the_version_of_the_command(self):
        self.assertIn(actio.__version__, command("--version").stdout)

    def test_it_is_typed_and_documented(self):
        self.assertTrue(pathlib.Path(actio.__file__).with_name("py.typed").exists())
        for name in actio.__all__:
            thing = getattr(actio, name)
            if callable(thing):
                self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isfunction(thing):
                parameters = inspect.signature(thing).parameters.values()
                self.assertTrue(
                    all(parameter.annotation is not inspect.Parameter.empty for parameter in parameters), name
                )
                self.assertIn("return", thing.__annotations__)
        for name, member in inspect.getmembers(actio.Run):
            if not name.startswith("_"):
                self.assertTrue(inspect.getdoc(member), name)

    def test_without_numpy_the_import_says_so(self):
        hidden = (
            "import sys; sys.modules['numpy'] = None\ntry:\n    import actio\nexcept ImportError as error:\n "
            "   print(error)"
        )
        said = subprocess.run([sys.executable, "-c", hidden], check=True, capture_output=True, text=True)
        self.assertRegex(said.stdout, "^actio needs NumPy")


class ThePage(unittest.TestCase):
    def test_its_examples_run(self):
        page = pathlib.Path(__file__).parents[2] / "docs/pages/07_python.md"
        # Lines that are indented, one block after the other; those for a shell are for the test of the wheel.
        blocks = [
            textwrap.dedent(block)
            for block in re.findall(r"(?:^ {4}.*\n|^\n(?= {4}))+", page.read_text(), re.M)
        ]
        blocks = [block for block in blocks if not re.match(r"\s*(PYTHONPATH=|python3 )", block)]
        self.assertEqual(len(blocks), 8)
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.rename(folder_of_the_command(folder), folder + "/apophis")
            os.chdir(folder)
            said = io.StringIO()
            try:
                with contextlib.redirect_stdout(said):
                    names = {}
                    for block in blocks:
                        exec(compile(block, str(page), "exec"), names)
            finally:
                os.chdir(here)
            self.assertEqual(names["x"].shape, names["pressure"].shape)
            self.assertTrue(pathlib.Path(folder, "copy/plots/index.html").exists())
        for expected in [
            "(101, 3)",
            "101 rows to t = 25 of body_momentum",
            "{'method.order': 4, 'method.step': 0.0625}",
            "100%, t = 25",
            "rigid_body -",
            'set: method.step="fast":1:13: step: a number is expected',
        ]:
            self.assertIn(expected, said.getvalue())

    def test_its_table_names_what_there_is(self):
        page = (pathlib.Path(__file__).parents[2] / "docs/pages/07_python.md").read_text()
        run = actio.run(text=SCENE)
        for name in set(re.findall(r"`run\.(\w+)", page)):
            self.assertTrue(hasattr(run, name), name)
        for name in [name for name, _ in inspect.getmembers(actio.Run) if not name.startswith("_")]:
            self.assertIn(name, page)
        for name in actio.__all__:
            self.assertIn(name.strip("_"), page)


if __name__ == "__main__":
    unittest.main()
