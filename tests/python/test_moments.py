"""Moments of mass of meshes from Python.

    PYTHONPATH=build/python python3 tests/python/test_moments.py
"""

import fractions
import itertools
import math
import pathlib
import random
import tempfile
import unittest

import actio
import numpy

# A box with a corner at the origin; quadrilaterals, counter-clockwise as seen from outside.
FACES = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"


def box(a, b, c, at=(0, 0, 0)):
    corners = [(0, 0, 0), (a, 0, 0), (a, b, 0), (0, b, 0), (0, 0, c), (a, 0, c), (a, b, c), (0, b, c)]
    return "".join("v {} {} {}\n".format(*(p + q for p, q in zip(corner, at))) for corner in corners) + FACES


class Moments(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, text, name="mesh.obj"):
        path = pathlib.Path(self.folder.name, name)
        path.write_text(text)
        return path

    def refuses(self, error, *said, **arguments):
        with self.assertRaises(error) as caught:
            actio.moments(**{"mesh": self.file(box(1, 1, 1), "unit_box.obj"), **arguments})
        for text in said:
            self.assertIn(text, str(caught.exception))

    def test_of_a_box_are_products_of_powers(self):
        # The integral of x^i over [0, a] is a^(i+1)/(i+1).
        a, b, c = 2, 4, 6
        found = actio.moments(self.file(box(a, b, c)), 5, density=3.5, length_unit=0.5)
        self.assertEqual(found.shape, (56, 4))
        orders = found[:, :3].sum(axis=1)
        self.assertTrue((numpy.diff(orders) >= 0).all())
        self.assertEqual(len({tuple(row[:3]) for row in found}), 56)
        for i, j, l, moment in found:
            expected = 3.5
            for side, power in ((a, i), (b, j), (c, l)):
                expected *= (0.5 * side) ** (power + 1) / (power + 1)
            # Twelve tetrahedra, and sums of positive numbers: some dozens of roundings.
            self.assertAlmostEqual(moment / expected, 1, delta=100 * numpy.finfo(float).eps)

    def test_of_a_tetrahedron_are_those_of_the_simplex_formula(self):
        # Over the rationals, from the integral of monomials over the standard simplex, i! j! l!/(i+j+l+3)!,
        # by expanding x = sum of barycentric coordinates times corners.
        draw = random.Random(3)
        corners = [[draw.randint(-5, 5) for _ in range(3)] for _ in range(4)]
        edges = [[p - q for p, q in zip(corner, corners[0])] for corner in corners[1:]]
        volume = fractions.Fraction(round(numpy.linalg.det(edges)), 6)
        self.assertNotEqual(volume, 0)
        outwards = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
        faces = outwards if volume > 0 else "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n"
        text = "".join("v {} {} {}\n".format(*corner) for corner in corners) + faces

        def exact(powers):
            axes = [axis for axis, power in enumerate(powers) for _ in range(power)]
            total = fractions.Fraction(0)
            for chosen in itertools.product(range(4), repeat=len(axes)):
                term = fractions.Fraction(1)
                for axis, corner in zip(axes, chosen):
                    term *= corners[corner][axis]
                for corner in range(4):
                    term *= math.factorial(chosen.count(corner))
                total += term
            return abs(volume) * 6 * total / math.factorial(len(axes) + 3)

        found = actio.moments(str(self.file(text)), 4)
        largest = abs(found[:, 3]).max()
        for *powers, moment in found:
            expected = float(exact([int(power) for power in powers]))
            self.assertAlmostEqual(moment, expected, delta=1e-13 * largest)

    def test_a_shift_moves_the_centre_and_keeps_the_mass(self):
        at = actio.moments(self.file(box(1, 2, 3, at=(4, -5, 6))), 1)
        self.assertAlmostEqual(at[0, 3], 6, delta=1e-12)
        self.assertEqual(at[1:, :3].sum(), 3)
        centre = {tuple(row[:3]): row[3] / at[0, 3] for row in at[1:]}
        for axis, expected in (((1, 0, 0), 4.5), ((0, 1, 0), -4), ((0, 0, 1), 7.5)):
            self.assertAlmostEqual(centre[axis], expected, delta=1e-12)

    def test_a_scene_takes_them_and_has_the_forces_of_the_shape(self):
        path = self.file(box(2, 4, 6, at=(-1, -2, -3)))
        rows = actio.moments(path, 4, density=50, length_unit=2)
        scene = {
            "system": {
                "kind": "two_bodies",
                "primary": {"moments": rows, "radius": 8},
                "secondary": {"sphere": 1, "mass": 100},
            },
            "initial": {"position": [20, 5, 1], "velocity": [0, 1e-5, 0]},
            "run": {"until": 1000},
            "output": {"quantities": ["potential", "position"]},
        }
        shape = {"shape": str(path), "length_unit": 2, "density": 50}
        one, two = actio.run(scene), actio.run(scene, set={"system.primary": shape})
        self.assertTrue(numpy.allclose(one.table, two.table, rtol=1e-12, atol=0))

    def test_what_is_no_body_is_refused(self):
        self.refuses(actio.FileError, "cannot be read", mesh="there/is/no/such.obj")
        self.refuses(actio.Error, "line 1: a vertex has three coordinates", mesh=self.file("v 1 2\n"))
        is_open = box(1, 1, 1)[: -len("f 4 1 5 8\n")]
        self.refuses(actio.Error, "each edge must be met", mesh=self.file(is_open))
        turned = [" ".join(["f", *reversed(face.split()[1:])]) for face in FACES.splitlines()]
        inside_out = box(1, 1, 1).split("f")[0] + "\n".join(turned)
        self.refuses(actio.Error, "the volume must be positive", mesh=self.file(inside_out))
        self.refuses(actio.SceneError, "order: a whole number from 0 to 16", order=17)
        self.refuses(actio.SceneError, "order: ", order=-1)
        self.refuses(TypeError, "order: a whole number is expected", order=2.5)
        self.refuses(TypeError, "order: ", order=True)
        self.refuses(actio.SceneError, "density: a number > 0", density=0)
        self.refuses(actio.SceneError, "density: ", density=math.nan)
        self.refuses(actio.SceneError, "length_unit: ", length_unit=-1)
        self.refuses(TypeError, "length_unit: a number is expected", length_unit="m")
        self.refuses(TypeError, "mesh: a path is", mesh=3)


if __name__ == "__main__":
    unittest.main()
