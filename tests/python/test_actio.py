"""The module actio of Python against the command: the same numbers, held in memory without a copy.

    PYTHONPATH=build/python ACTIO_COMMAND=build/bin/actio python3 tests/python/test_actio.py
"""

import csv
import gc
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

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


def table_of_the_command(*arguments):
    """The series that `actio run` writes for the scene: names of its columns, and its numbers."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder, "apophis.toml")
        scene.write_text(SCENE)
        subprocess.run([os.environ["ACTIO_COMMAND"], "run", scene, "--out", f"{folder}/out", "--quiet", *arguments], check=True)
        with open(f"{folder}/out/series.csv") as file:
            rows = list(csv.reader(file))
    return rows[0], numpy.array([[float(x) for x in row] for row in rows[1:]])


class Numbers(unittest.TestCase):
    def test_a_run_in_memory_is_that_of_the_command_bit_for_bit(self):
        for order in ["exact", 2, 8]:
            columns, table = table_of_the_command("--set", f"method.order={order}")
            run = actio.run(text=SCENE, set={"method.order": order})
            self.assertEqual(run.columns, columns)
            self.assertEqual(run.table.tobytes(), table.tobytes())

    def test_a_quantity_has_its_own_shape(self):
        run = actio.run(text=SCENE)
        self.assertEqual(len(run), 101)
        self.assertEqual(run.t.shape, (101,))
        self.assertEqual(run["energy"].shape, (101,))
        self.assertEqual(run["body_momentum"].shape, (101, 3))
        self.assertEqual(run["attitude"].shape, (101, 4))
        self.assertEqual(list(run), ["body_momentum", "energy", "attitude"])
        for k, end in enumerate("xyz"):
            self.assertTrue(numpy.array_equal(run["body_momentum"][:, k], run["body_momentum_" + end]))
        with self.assertRaises(KeyError):
            run["enrgy"]

    def test_a_matrix_is_one_for_each_row(self):
        top = """
            [system]
            kind = "rigid_body_n"
            lambda = [1.0, 2.0, 3.0, 4.0]
            [initial]
            angular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
            [run]
            until = 1.0
            [output]
            quantities = ["attitude"]
        """
        try:
            attitude = actio.run(text=top)["attitude"]
        except actio.SceneError as error:
            self.skipTest(str(error))
        self.assertEqual(attitude.shape, (2, 4, 4))
        self.assertTrue(numpy.array_equal(attitude[0], numpy.eye(4)))
        self.assertLess(abs(attitude[1] @ attitude[1].T - numpy.eye(4)).max(), 1e-13)

    def test_the_summary_and_the_scene_are_those_of_a_run_in_a_folder(self):
        run = actio.run(text=SCENE)
        self.assertEqual(run.summary["status"], "done")
        self.assertEqual(run.summary["rows"], 101)
        self.assertIn("energy", run.summary["drift"])
        self.assertIn('name = "moser_veselov"', run.scene)
        again = actio.run(text=run.scene)
        self.assertEqual(again.table.tobytes(), run.table.tobytes())


class Memory(unittest.TestCase):
    def test_arrays_look_into_the_run_without_a_copy(self):
        run = actio.run(text=SCENE)
        for name in ["energy", "body_momentum", "body_momentum_y", "t"]:
            self.assertTrue(numpy.shares_memory(run.table, run[name]), name)
            self.assertIs(run[name].base, run)
            self.assertFalse(run[name].flags.writeable)
        self.assertTrue(run.table.flags.c_contiguous)

    def test_arrays_stay_when_the_run_is_gone(self):
        run = actio.run(text=SCENE)
        momentum, before = run["body_momentum"], run["body_momentum"].tobytes()
        del run
        gc.collect()
        others = [actio.run(text=SCENE, set={"initial.angular_velocity": [0.1, 0.2, 0.3 + k]}) for k in range(20)]
        self.assertEqual(momentum.tobytes(), before)
        self.assertEqual(len(others), 20)


class Arguments(unittest.TestCase):
    def test_values_of_python_and_of_numpy_override_keys(self):
        plain = actio.run(text=SCENE, set={"method.order": 4, "method.step": 0.125, "run.every": 5.0})
        numbers = actio.run(text=SCENE, set={"method.order": numpy.int64(4), "method.step": numpy.float64(0.125), "run.every": numpy.array(5.0)})
        self.assertEqual(plain.table.tobytes(), numbers.table.tobytes())
        self.assertEqual(plain.summary["steps"], 200)
        listed = actio.run(text=SCENE, set={"initial.angular_velocity": numpy.array([0.1, 0.2, 0.3]), "scene.title": 'a "title"\\'})
        self.assertEqual(listed.summary["title"], 'a "title"\\')
        with self.assertRaises(TypeError):
            actio.run(text=SCENE, set={"method.step": None})
        with self.assertRaises(TypeError):
            actio.run()

    def test_a_scene_is_read_from_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "apophis.toml")
            path.write_text(SCENE)
            self.assertEqual(actio.run(path).table.tobytes(), actio.run(text=SCENE).table.tobytes())
            self.assertEqual(actio.run(str(path)).summary["title"], "apophis")
            self.assertEqual(os.listdir(folder), ["apophis.toml"])


class Failures(unittest.TestCase):
    def test_a_wrong_scene_is_pointed_at(self):
        with self.assertRaisesRegex(actio.SceneError, r"^text:14:15: unknown quantity 'enrgy'; did you mean 'energy'\?"):
            actio.run(text=SCENE.replace('"body_momentum", "energy", "attitude"', '"enrgy"'))
        with self.assertRaisesRegex(actio.SceneError, "there is no such file"):
            actio.run("no_such_scene.toml")
        self.assertTrue(issubclass(actio.SceneError, actio.Error))

    def test_a_step_beyond_its_bound_is_an_error_of_the_numerics(self):
        with self.assertRaises(actio.NumericsError):
            actio.run(text=SCENE, set={"method.order": 2, "method.step": 25.0, "run.every": 25.0, "initial.angular_velocity": [0.5, 0.5, 0.5]})


class Threads(unittest.TestCase):
    LONG = {"method.order": 2, "run.until": 2.5e11, "run.every": 2.5e10}

    def test_ctrl_c_ends_a_run(self):
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            actio.run(text=SCENE, set=self.LONG)
        self.assertLess(time.monotonic() - began, 30)

    def test_other_threads_go_on_meanwhile(self):
        counted = []

        def count():
            while not counted or counted[-1] < 20:
                counted.append(len(counted))
                time.sleep(0.001)
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=count).start()
        with self.assertRaises(KeyboardInterrupt):
            actio.run(text=SCENE, set=self.LONG)
        self.assertEqual(counted[-1], 20)


if __name__ == "__main__":
    unittest.main()
