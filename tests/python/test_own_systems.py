"""Systems of one's own in Python: a Lagrangian that is a function becomes a formula of the same values.

    PYTHONPATH=build/python python3 tests/python/test_own_systems.py
"""

import contextlib
import copy
import fractions
import functools
import inspect
import io
import json
import math
import os
import pathlib
import pickle
import re
import tempfile
import textwrap
import types
import unittest
import warnings

import actio
import numpy

# What the functions of a formula are, where Python reads it.
OF_A_FORMULA = {name: getattr(math, name) for name in dir(math) if not name.startswith("_")}
OF_A_FORMULA["cbrt"] = numpy.cbrt


class Numbers(numpy.ndarray):
    """A velocity of numbers, whose components have names."""

    def __new__(cls, values, names):
        self = numpy.array(values, dtype=float).view(cls)
        self.names = names
        return self

    def __getattr__(self, name):
        if name == "names":
            raise AttributeError(name)
        return self[self.names.index(name)]


def value(formula, names):
    """The value of a formula, read as Python with ** in place of ^."""
    names = dict(names)
    *definitions, last = formula.replace("^", "**").split(";")
    for definition in definitions:
        name, _, text = definition.partition("=")
        assert name.strip() not in names, formula
        names[name.strip()] = eval(text, OF_A_FORMULA, names)
    return eval(last.strip(), OF_A_FORMULA, names)


def system(lagrangian, group="SE(2)", **more):
    return actio.System(group, lagrangian, **more)


class Formulas(unittest.TestCase):
    def agrees(self, lagrangian, group="SE(2)", parameters=None, advected=None):
        """The formula has the value of the function at some velocities; it is returned."""
        made = system(lagrangian, group, parameters=parameters, advected=advected)
        generator = numpy.random.default_rng(7)
        for _ in range(5):
            names = {name: generator.uniform(0.2, 0.9) for name in made.components}
            xi = Numbers(list(names.values()), made.components)
            p, a = types.SimpleNamespace(**made.parameters), types.SimpleNamespace()
            for name, items in made.advected.items():
                items = generator.uniform(-1, 1, len(items))
                setattr(a, name, items)
                names.update((f"{name}{k + 1}", item) for k, item in enumerate(items))
            expected = lagrangian(*(xi, p, a)[: lagrangian.__code__.co_argcount])
            found = value(made.formula, {**made.parameters, **names})
            self.assertLess(abs(found - expected), 1e-13 * max(1, abs(expected)), made.formula)
        return made.formula

    def test_a_formula_reads_as_it_was_meant(self):
        formula = self.agrees(lambda xi, p: (xi.w**2 + xi.v1**2 + p.c * xi.v2**2) / 2, parameters={"c": 6})
        self.assertEqual(formula, "(w^2 + v1^2 + c*v2^2)/2")

    def test_brackets_stand_where_they_are_needed(self):
        for lagrangian, formula in [
            (lambda x: x[0] - (x[1] - x[2]), "w - (v1 - v2)"),
            (lambda x: x[0] / (x[1] / x[2]) / x[1], "w/(v1/v2)/v1"),
            (lambda x: x[0] * (x[1] * x[2]), "w*(v1*v2)"),
            (lambda x: (x[0] * x[1]) * x[2], "w*v1*v2"),
            (lambda x: (x[0] + x[1]) * -x[2], "(w + v1)*(-v2)"),
            (lambda x: -x[0] ** 2 - -x[1] ** 2, "-w^2 + v1^2"),
            (lambda x: (-x[0]) ** 2 + x[1] ** -2 + (x[1] ** 2) ** 3, "(-w)^2 + v1^(-2) + (v1^2)^3"),
            (lambda x: x[0] ** x[1] ** x[2] + 2 ** x[0], "w^(v1^v2) + 2^w"),
            (lambda x: -(x[0] + x[1]) - 0.5 * x[2] + (-3 + x[1]), "-(w + v1) - 0.5*v2 + (-3 + v1)"),
            (lambda x: x[0] * -0.5 * fractions.Fraction(1, 3), "w*(-0.5)*(1/3)"),
            (lambda x: fractions.Fraction(-1, 3) * x[0] + math.pi * 1e-7 * x[1] + 1e22 * x[2], None),
        ]:
            with self.subTest(formula):
                found = self.agrees(lagrangian)
                if formula:
                    self.assertEqual(found, formula)

    def test_what_computes_nothing_is_left_out(self):
        self.assertEqual(self.agrees(lambda x: 0 + x[0] * 1 - 0 + x[1] * 0 + 0 / x[2] - (-x[1])), "w + v1")
        self.assertEqual(self.agrees(lambda x: (x[0] ** 1.0) / 1 * x[1] ** 0 - 1 * x[2] * -1), "w + v2")
        self.assertEqual(self.agrees(lambda x: 0 - x[0] + 2.0 * x[1]), "-w + 2*v1")
        self.assertEqual(self.agrees(lambda x: x[0] + -x[1] + x[2] * -1 + -3 - -5), "w - v1 - v2 - 3 + 5")

    def test_a_common_part_is_written_once(self):
        def lagrangian(x):
            speed = x[0] * x[1]
            turned = actio.sin(speed)
            return turned**2 + speed * turned + x[1] * x[0]

        self.assertEqual(self.agrees(lagrangian), "t1 = w*v1; t2 = sin(t1); t2^2 + t1*t2 + t1")

    def test_a_definition_has_a_name_of_its_own(self):
        formula = self.agrees(lambda x, p: (x[0] + p.t1) ** 2 * (x[0] + p.t1), parameters={"t1": 2})
        self.assertEqual(formula, "t_1 = w + t1; t_1^2*t_1")

    def test_every_function_is_that_of_actio_and_of_numpy(self):
        for own, numpys in {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atanh": "arctanh",
                            "asinh": "arcsinh", "sin": "sin", "cos": "cos", "tan": "tan", "sinh": "sinh",
                            "cosh": "cosh", "tanh": "tanh", "exp": "exp", "log": "log", "log2": "log2",
                            "log10": "log10", "sqrt": "sqrt", "cbrt": "cbrt"}.items():  # fmt: skip
            for function in (getattr(actio, own), getattr(numpy, numpys)):
                self.assertEqual(self.agrees(lambda x: function(x.w)), f"{own}(w)")
            self.assertAlmostEqual(getattr(actio, own)(0.5), getattr(numpy, numpys)(0.5), delta=1e-15)
        for lagrangian, formula in [
            (lambda x: actio.acosh(1 + x.w) + numpy.arccosh(2 + x.w), "acosh(1 + w) + acosh(2 + w)"),
            (lambda x: actio.hypot(x.w, 3) + numpy.hypot(4.0, x.w), "hypot(w, 3) + hypot(4, w)"),
            (lambda x: actio.atan2(x.w, 3) + numpy.arctan2(4.0, x.w), "atan2(w, 3) + atan2(4, w)"),
        ]:
            self.assertEqual(self.agrees(lagrangian), formula)

    def test_functions_of_numpy_that_a_formula_does_not_have_are_made_of_those_it_has(self):
        self.agrees(lambda x: numpy.exp2(x.w) + numpy.expm1(x.v1) + numpy.log1p(x.v2) + numpy.square(x.w))
        self.agrees(lambda x: numpy.reciprocal(x.w) + numpy.radians(x.v1) + numpy.degrees(x.v2))
        self.agrees(lambda x: numpy.deg2rad(x.w) + numpy.rad2deg(x.v1) + numpy.float_power(x.v2, 3))

    def test_numbers_of_numpy_count_as_numbers(self):
        self.assertEqual(
            self.agrees(lambda x: numpy.float64(2) * x.w + x.v1 * numpy.int32(3) - numpy.float32(0.5) / x.v2),
            "2*w + v1*3 - 0.5/v2",
        )

    def test_a_velocity_is_an_array(self):
        matrix = numpy.array([[2, 0, 0.5], [0, 1, 0], [0.5, 0, 3]])
        for lagrangian in [
            lambda x: x @ matrix @ x / 2,
            lambda x: numpy.dot(x, matrix @ x),
            lambda x: numpy.sum(matrix * numpy.outer(x, x)) + numpy.trace(numpy.outer(x, x)),
            lambda x: (x**2).sum() + x.prod() + x.mean() + numpy.linalg.norm(x) + numpy.inner(x, x),
            lambda x: sum(each**2 for each in x) + x[-1] * x[1:] @ x[:2],
            lambda x: numpy.cross(x, [1, 2, 3]) @ numpy.sin(x),
            lambda x: numpy.array([1.0, 2, 3]) @ x + (numpy.array([1, 2, 3]) * x.w).sum() + (x.w - x).sum(),
            lambda x: numpy.concatenate([x, x])[2:5] @ numpy.tensordot(matrix, x, 1),
            lambda x: actio.sin(numpy.array([x.w, 0.5])).sum() + actio.exp([x.w, x.v1]).sum(),
            lambda x: numpy.vdot(x, x) + x.std() + numpy.matmul(matrix, x)[0],
        ]:
            self.agrees(lagrangian)

    def test_the_number_of_arguments_says_what_is_handed_over(self):
        more = {"parameters": {"m": 2}, "advected": {"gravity": [0, 0, -1]}}
        self.agrees(lambda x: x @ x, "SO(3)", **more)
        self.agrees(lambda x, p: p.m * x @ x, "SO(3)", **more)
        self.assertEqual(
            self.agrees(lambda x, p, a: x.w1**2 + p.m * a.gravity @ [0, 0, 1], "SO(3)", **more),
            "w1^2 + m*gravity3",
        )
        for lagrangian in [
            lambda x, power=2: x.w1**power,
            functools.partial(lambda power, x: x.w1**power, 2),
            types.SimpleNamespace(of=lambda x: x.w1**2).of,
        ]:
            self.assertEqual(system(lagrangian, "SO(3)").formula, "w1^2")
        self.assertEqual(system(lambda *all: all[0].w1 + all[1]["m"], "SO(3)", **more).formula, "w1 + m")

    def test_the_velocity_is_a_matrix_too(self):
        made = system(lambda x: (x.matrix[0, 2] ** 2 + x.matrix[1, 0] ** 2) / 2)
        self.assertEqual(made.formula, "(v1^2 + w^2)/2")
        own = [[[1, 0], [0, 0]], [[0, 2], [0, 0]]]
        formula = system(lambda x: numpy.trace(x.matrix.T @ x.matrix), own).formula
        self.assertAlmostEqual(value(formula, {"x1": 0.3, "x2": 0.7}), 0.3**2 + 1.4**2, delta=1e-15)

    def test_a_long_lagrangian_costs_in_proportion(self):
        def lagrangian(x):
            total = x.w
            for k in range(20_000):
                total = 1 / (total + k) if k % 100 else actio.sin(total)
            for _ in range(1000):
                total = actio.sin(total)
            return total

        formula = system(lagrangian).formula
        self.assertLess(len(formula), 20_000 * 15)
        depth = deepest = 0
        for letter in formula:
            depth += (letter == "(") - (letter == ")")
            deepest = max(deepest, depth)
        self.assertLess(deepest, 50)
        with self.assertRaisesRegex(actio.SceneError, "more than 100000 operations"):
            system(lambda x: sum(x.w + k for k in range(100_000)))


class Refusals(unittest.TestCase):
    def says(self, pattern, lagrangian, kind=actio.SceneError, **more):
        with self.assertRaisesRegex(kind, pattern) as caught, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            system(lagrangian, **more)
        self.assertNotIn("\n", str(caught.exception))

    def test_a_branch_is_named_with_its_line(self):
        def compared(x):
            if x.w < 0.5:
                return x.w
            return x.v1**2

        line = compared.__code__.co_firstlineno + 1
        here = re.escape(__file__)
        self.says(rf"lagrangian: {here}:{line}: `if x.w < 0.5:`: numbers are compared by <; a Lagr", compared)
        for lagrangian in [
            lambda x: x.w if x.w else x.v1,
            lambda x: x.w if x.w == 0 else x.v1,
            lambda x: x.w if x.w in (0, 1) else x.v1,
            lambda x: max(x.w, x.v1),
            lambda x: x.w and x.v1,
            lambda x, p: x.w if p.c != 6 else x.v1,
            lambda x: numpy.where(x > 0, x, 0).sum(),
            lambda x: numpy.where(x == 0, 1, x).sum(),
            lambda x: numpy.where(numpy.asarray(x) == 0, 1, x).sum(),
            lambda x: numpy.sinc(x.w),
            lambda x: x[numpy.argmax(x)],
            lambda x: sorted(x)[0],
            lambda x: numpy.clip(x.w, 0, 1),
            lambda x: x.w if numpy.isfinite(x.w) else 0,
            lambda x: x.w if numpy.allclose(x, 0) else 0,
            lambda x: x.w if x.any() else 0,
        ]:
            self.says(rf"{here}:\d+: .*one smooth formula", lagrangian, parameters={"c": 6})

    def test_a_branch_that_is_caught_is_an_error_all_the_same(self):
        def lagrangian(x):
            try:
                return x.w if x.w > 0 else -x.w
            except Exception:
                return x.w**2

        self.says("compared by >", lagrangian)

    def test_what_is_not_smooth_is_refused(self):
        for lagrangian in [
            lambda x: abs(x.w),
            lambda x: numpy.abs(x).sum(),
            lambda x: numpy.fabs(x.w),
            lambda x: numpy.sign(x.w),
            lambda x: numpy.maximum(x.w, 0),
            lambda x: x.max(),
            lambda x: round(x.w),
            lambda x: math.floor(x.w) + math.ceil(x.w),
            lambda x: x.w // 2,
            lambda x: 7 % x.w,
            lambda x: divmod(x.w, 2)[0],
            lambda x: pow(x.w, 2, 3),
        ]:
            self.says(r"is not smooth, and a Lagrangian has to be", lagrangian)

    def test_math_needs_floats_and_the_message_says_what_does_not(self):
        self.says("math.asin needs a float, .* use actio.asin or numpy.arcsin", lambda x: math.asin(x.w))
        for lagrangian in [
            lambda x: float(x.w),
            lambda x: numpy.asarray(x, dtype=float).sum(),
            lambda x: math.erf(x.w),
        ]:
            self.says("a float is needed here, .* numpy.sin", lagrangian)
        for lagrangian in [lambda x: int(x.w), lambda x: [1, 2][x.w], lambda x: sum(range(x.w))]:
            self.says("a whole number is needed here", lagrangian)
        self.says("to be written in a format", lambda x: f"{x.w:.3f}")
        self.says("a Lagrangian is real", lambda x: complex(x.w))

    def test_what_is_no_function_of_a_formula_is_refused(self):
        self.says("numpy.gcd is no function of a formula, which has sin, cos", lambda x: numpy.gcd(x.w, 2))
        self.says("numpy.spacing is no function", lambda x: numpy.spacing(x).sum())
        self.says(
            "numpy.sin does not take an array that mixes .* actio.sin does",
            lambda x: numpy.sin(numpy.array([x.w, 2])).sum(),
        )
        self.says("numpy.rint is no function", lambda x: numpy.rint(numpy.array([2, x.w])).sum())
        self.says("NumPy says .*det.* of traced numbers", lambda x: numpy.linalg.det(numpy.outer(x, x)))

    def test_what_is_no_number_is_refused(self):
        self.says("a Lagrangian is real, found the complex number 2j", lambda x: x.w * 2j)
        for what in ["nan", "inf", "-inf"]:
            self.says(f"a number is expected, found {what}", lambda x: x.w * float(what))
        self.says("a number is expected, found inf", lambda x: x.w * 10**400)
        self.says("divided by zero", lambda x: x.v1 + x.w / 0)
        for thing in ["a", b"a", [1], (1,), {}]:
            self.says("a number or an array of NumPy is expected, found", lambda x: x.w * thing)
        self.says("unsupported operand", lambda x: x.w + None, TypeError)
        self.says("sin: a number is expected, found None", lambda x: x.w * actio.sin(None), TypeError)

    def test_what_came_back_is_named(self):
        for found, pattern in [
            (None, "returned None, of type NoneType; is a return missing"),
            ("w^2", "returned 'w.2', of type str; a Lagrangian that is a text is given in place"),
            ([1, 2], r"returned \[1, 2\], of type list; a sum over its items"),
            (numpy.eye(2), r"returned an array of shape \(2, 2\); a sum over its items"),
            (3.0, "returned the constant 3.0; it has to be made of"),
            (numpy.float64(3), "returned the constant 3.0"),
            (2j, "returned the constant 2j"),
            (len, "returned <built-in function len>, of type builtin_function_or_method"),
        ]:
            self.says("lagrangian: a number is expected of it, and it " + pattern, lambda x: found)
        self.says(r"returned an array of shape \(3,\)", lambda x: x)
        self.says(
            r"returned c\^2, which does not depend on the velocity \(w, v1, v2\)",
            lambda x, p: p.c**2,
            parameters={"c": 6},
        )
        self.says("returned 0, which does not depend", lambda x: x.w * 0)

        async def later(x):
            return x.w

        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.says("of type coroutine", later)

    def test_numbers_of_two_calls_do_not_mix(self):
        kept = []
        system(lambda x: kept.append(x) or x @ x)
        self.says("numbers of two calls are mixed", lambda x: x @ kept[0])
        self.says("numbers of two calls are mixed", lambda x: actio.hypot(x.w, kept[0].w))
        self.says("returned a number of another call", lambda x: kept[0].w)

    def test_a_lagrangian_within_a_lagrangian_has_symbols_of_its_own(self):
        def lagrangian(x):
            inner = system(lambda y: y.v1**2).formula
            return x.w**2 if inner == "v1^2" else None

        self.assertEqual(system(lagrangian).formula, "w^2")

    def test_a_wrong_number_of_arguments_is_refused(self):
        for lagrangian, found in [
            (lambda: 0, "found one of 0"),
            (lambda a, b, c, d: 0, "found one of 4"),
            (lambda x, *, k: 0, "found one that needs k by name"),
        ]:
            self.says(f"of one, two or three arguments is expected, .* {found}", lagrangian, TypeError)
        self.says("the arguments of <built-in function max> cannot be told", max, TypeError)
        self.says("a function or the text of a formula is expected, found 3, of type int", 3, TypeError)

    def test_what_is_not_there_is_said_with_what_is(self):
        more = {"parameters": {"mass": 1}, "advected": {"gravity": [0, 0, 1]}}
        for lagrangian, pattern in [
            (lambda x: x.v3, "velocity: there is no component 'v3'; there is w, v1, v2"),
            (lambda x, p: p.mas, "there is no parameter 'mas'; did you mean mass.; there is mass"),
            (lambda x, p: p.gravity, "there is no parameter 'gravity'; there is mass"),
            (lambda x, p, a: a.mass, "there is no carried vector 'mass'; there is gravity"),
            (lambda x: x[1:].w, "a part or a copy of the velocity has items alone, and no w"),
            (lambda x: x.copy().matrix, "a part or a copy of the velocity has items alone, and no matrix"),
        ]:
            self.says(pattern, lagrangian, AttributeError, **more)
        self.says("there is no parameter 'mas'", lambda x, p: p["mas"], KeyError, **more)
        self.says("there is no parameter 'c'$", lambda x, p: p.c, AttributeError)

    def test_an_error_of_the_lagrangian_is_its_own(self):
        self.says("division by zero", lambda x: x.w * (1 / 0), ZeroDivisionError)
        self.says("read-only", lambda x: x.__setitem__(0, 1), ValueError)


class Systems(unittest.TestCase):
    def test_a_system_tells_what_it_is(self):
        more = {"parameters": {"c": numpy.float64(2)}, "advected": {"a": (1, 0, 0)}}
        made = actio.System("SE(2)", "w^2 + c*v1*v2", **more)
        self.assertEqual(
            (made.group, made.side, made.formula, made.components, made.parameters, made.advected),
            ("SE(2)", "left", "w^2 + c*v1*v2", ["w", "v1", "v2"], {"c": 2.0}, {"a": [1.0, 0.0, 0.0]}),
        )
        self.assertEqual(made.basis.shape, (3, 3, 3))
        self.assertIn("SE(2): w^2 + c*v1*v2", repr(made))
        own = actio.System(numpy.array([[[1, 0], [0, 0]], [[0, 1], [0, 0]]]), lambda x: x @ x, side="right")
        self.assertEqual((own.group, own.side, own.components), ("", "right", ["x1", "x2"]))
        self.assertIn("a group of 2 dimensions", repr(own))

    def test_a_system_can_be_copied_and_pickled(self):
        made = system(lambda x, p: x @ x * p.c, parameters={"c": 6})
        for twin in [copy.copy(made), copy.deepcopy(made), pickle.loads(pickle.dumps(made))]:
            self.assertEqual((twin.formula, twin.parameters), (made.formula, made.parameters))

    def test_a_scene_is_a_mapping_and_a_text(self):
        made = system(lambda x, p: (x.w**2 + p.c * x.v2**2) / 2, parameters={"c": 6}, side="right")
        scene = made.scene(
            velocity=numpy.array([0.7, 1, 0.2]),
            until=10,
            every=0.1,
            step=0.01,
            order=4,
            method="natural_chart",
            configuration=numpy.eye(3),
            quantities=("body_momentum", "energy"),
            title="A sleigh",
        )
        identity = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        self.assertEqual(
            scene,
            {
                "scene": {"title": "A sleigh"},
                "system": {
                    "kind": "euler_poincare",
                    "group": "SE(2)",
                    "side": "right",
                    "lagrangian": "(w^2 + c*v2^2)/2",
                    "parameters": {"c": 6},
                },
                "initial": {"velocity": [0.7, 1, 0.2], "configuration": identity},
                "method": {"name": "natural_chart", "order": 4, "step": 0.01},
                "run": {"until": 10, "every": 0.1},
                "output": {"quantities": ["body_momentum", "energy"]},
            },
        )
        self.assertEqual(json.loads(json.dumps(scene)), scene)
        lines = str(scene).splitlines()
        for line in ['lagrangian = "(w^2 + c*v2^2)/2"', "[system.parameters]", "c = 6", "order = 4"]:
            self.assertIn(line, lines)
        short = made.scene(velocity=[1, 2, 3], until=1)
        self.assertEqual(list(short), ["system", "initial", "run", "output"])
        self.assertIn("configuration", short["output"]["quantities"])

    def test_the_scene_of_a_basis_has_its_matrices(self):
        basis = [[[1, 0], [0, 0]], [[0, 1], [0, 0]]]
        scene = system(lambda x: x @ x, [numpy.array(each) for each in basis]).scene(velocity=[1, 0], until=1)
        self.assertEqual(scene["system"]["algebra"], basis)
        self.assertNotIn("group", scene["system"])

    def test_wrong_arguments_are_refused(self):
        for wrong, kind, pattern in [
            ({"side": "up"}, ValueError, "side: 'left' or 'right' is expected, found 'up'"),
            ({"parameters": [1]}, TypeError, 'parameters: a mapping such as {"c": 6} is expected'),
            ({"parameters": {"c": [1]}}, actio.SceneError, r"parameters: c: a number is expected, .* \[1\]"),
            ({"parameters": {"c": math.nan}}, actio.SceneError, "parameters: c: a number is .*, found nan"),
            ({"parameters": {"c": 1j}}, actio.SceneError, "parameters: c: a number is expected, found 1j"),
            ({"parameters": {"c d": 1}}, actio.SceneError, "parameters: a name of letters and digits"),
            ({"parameters": {3: 1}}, actio.SceneError, "parameters: a name of letters and digits"),
            ({"parameters": {"w": 1}}, actio.SceneError, "parameters: w is a component of the velo"),
            ({"parameters": {"sin": 1}}, actio.SceneError, "parameters: sin is a function already"),
            ({"parameters": {"pi": 3}}, actio.SceneError, "parameters: pi is the number pi already"),
            ({"advected": {"v": [1, 2, 3]}}, actio.SceneError, "v has the component v1, which is a comp"),
            ({"advected": {"a": 3}}, actio.SceneError, "advected: a: a list of numbers is expected, found 3"),
            ({"advected": {"a": ["b"]}}, actio.SceneError, "advected: a: a list of numbers is expected"),
            ({"advected": {"a": []}}, actio.SceneError, "advected: a: a list of numbers is expected"),
            ({"advected": 3}, TypeError, "advected: a mapping such as"),
            ({"group": 3}, TypeError, 'a name such as "SE.2." or a list of matrices is .*, found 3'),
            ({"group": []}, actio.SceneError, "group: the list of matrices is empty"),
            ({"group": [3]}, actio.SceneError, "matrix 1 is a number"),
            ({"group": [[[1, 2]]]}, actio.SceneError, "square matrices of .*, matrix 1 is 1 by 2"),
            ({"group": [[[1]], [[1, 2], [3, 4]]]}, actio.SceneError, "matrix 2 is 2 by 2"),
            ({"group": [[[1j]]]}, TypeError, "matrix of real numbers is expected, matrix 1 is complex"),
            ({"group": [[["a"]]]}, TypeError, "matrix of real numbers is expected, matrix 1 is"),
            ({"group": [[[math.nan]]]}, actio.SceneError, "finite numbers are expected, matrix 1"),
        ]:
            with self.subTest(wrong), self.assertRaisesRegex(kind, pattern):
                actio.System(**{"group": "SE(2)", "lagrangian": "w^2", **wrong})


    def test_what_is_no_group_is_refused_with_what_was_measured(self):
        stretch, lift = [[1, 0], [0, 0]], [[0, 1], [0, 0]]
        for group, pattern in [
            ("SE2", "^group .*'SE2'; did you mean 'SE.2.'"),
            ("", "^group "),
            ("SO(40)", "^group SO.40.: .* measured 780, bound 64"),
            ([stretch, lift, numpy.add(stretch, lift)], "^group: .*independent, but e_3 = 1 e_1 . 1 e_2"),
            ([lift, [[0, 0], [1, 0]]], r"^group: .*\[e_1, e_2\] leaves it; .* measured 1.4142"),
        ]:
            with self.subTest(group), self.assertRaisesRegex(actio.SceneError, pattern):
                actio.System(group, "x1^2")
        self.assertEqual(actio.System(" SO(3)  x R^1 ", "x1^2").group, "SO(3) x R^1")

    def test_a_basis_is_that_of_the_library(self):
        x = system("w1^2", "SO(3)").basis
        self.assertTrue(numpy.array_equal(x[0] @ x[1] - x[1] @ x[0], x[2]))
        self.assertEqual(actio.System("SL(2) |x R^2", "x1^2").basis.shape, (5, 3, 3))
        self.assertFalse(numpy.signbit(x[x == 0]).any())


INERTIA = numpy.diag([1.0, 2, 3])
FREE = {"velocity": [0.3, 0.8, -0.2], "until": 4, "every": 0.5}


def free_body(group="SO(3)"):
    return actio.System(group, lambda w: w @ INERTIA @ w / 2)


class Runs(unittest.TestCase):
    def agree(self, found, expected, bound):
        self.assertEqual(found.shape, expected.shape)
        self.assertLess(abs(found - expected).max(), bound)

    def test_a_free_body_moves_as_that_of_the_library(self):
        run = free_body().run(**FREE, step=0.05, order=6, quantities=["body_momentum", "energy"])
        exact = actio.run(
            {
                "system": {"kind": "rigid_body", "inertia": [1, 2, 3]},
                "initial.angular_velocity": FREE["velocity"],
                "run": {"until": 4, "every": 0.5},
                "output.quantities": ["body_momentum", "energy"],
            }
        )
        self.agree(run["body_momentum"], exact["body_momentum"], 1e-8)
        self.agree(run["energy"], exact["energy"], 1e-8)

    def test_a_run_to_an_accuracy_has_it_and_tells_its_step(self):
        wanted = {**FREE, "quantities": ["body_momentum"]}
        exact = free_body().run(**wanted, method="galerkin", step=0.05, order=12)["body_momentum"]
        for accuracy in (1e-4, 1e-7, 1e-10):
            run = free_body().run(**wanted, accuracy=accuracy)
            self.assertEqual(run.accuracy, accuracy)
            apart = numpy.linalg.norm(run["body_momentum"] - exact, axis=1).max()
            self.assertLess(apart / numpy.linalg.norm(exact[0]), accuracy)
            self.assertLess(max(run.error.values()), accuracy)
            self.assertRegex(run.summary["remarks"][-1], f"accuracy {accuracy:g}: momentum_level of order 8 with steps of 0[.]")
            self.assertIn("chosen_for", run.scene)
            self.assertIn("accuracy", run._repr_html_())
        self.assertIsNone(free_body().run(**wanted, step=0.05).accuracy)
        with self.assertRaisesRegex(actio.SceneError, "accuracy: it chooses the step"):
            free_body().run(**wanted, step=0.05, accuracy=1e-6)
        with self.assertRaisesRegex(actio.SceneError, "accuracy: a number > 0, and 0.1 at most"):
            free_body().run(**wanted, accuracy=-1)

    def test_an_order_to_an_accuracy_stays(self):
        run = free_body().run(**FREE, order=4, accuracy=1e-8, quantities=["energy"])
        self.assertIn("order 4 with steps of", run.summary["remarks"][-1])

    def test_a_basis_of_matrices_gives_the_motion_of_the_group_that_it_is_of(self):
        more = {**FREE, "step": 0.05, "order": 4, "quantities": ["configuration", "body_momentum"]}
        known, own = free_body().run(**more), free_body(free_body().basis).run(**more)
        self.assertEqual(own.columns[-3:], ["body_momentum_x1", "body_momentum_x2", "body_momentum_x3"])
        self.agree(own["body_momentum"], known["body_momentum"], 1e-13)
        self.agree(own["configuration"], known["configuration"], 1e-13)

    def test_a_configuration_is_a_matrix_for_each_row(self):
        start = numpy.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
        run = free_body().run(
            **FREE,
            step=0.05,
            configuration=start,
            quantities=["configuration", "spatial_momentum", "velocity"],
        )
        g = run["configuration"]
        self.assertEqual(g.shape, (9, 3, 3))
        self.assertTrue(numpy.array_equal(g[0], start))
        self.agree(g @ g.transpose(0, 2, 1), numpy.tile(numpy.eye(3), (9, 1, 1)), 1e-13)
        # The momentum in space is g times that in the body, and does not change.
        self.agree(numpy.einsum("kij,kj->ki", g, run["velocity"] @ INERTIA), run["spatial_momentum"], 1e-13)
        self.agree(run["spatial_momentum"], numpy.tile(run["spatial_momentum"][0], (9, 1)), 1e-13)

    def test_a_tangent_map_is_the_derivative_of_the_run(self):
        more = {"until": 2, "every": 1, "step": 0.1, "order": 4}
        more["quantities"] = ["body_momentum", "tangent_map"]
        momentum = INERTIA @ FREE["velocity"]

        def momenta(start):
            return free_body().run(velocity=numpy.linalg.solve(INERTIA, start), **more)["body_momentum"]

        found = free_body().run(velocity=FREE["velocity"], **more)["tangent_map"]
        self.assertEqual(found.shape, (3, 3, 3))
        self.assertTrue(numpy.array_equal(found[0], numpy.eye(3)))
        for k, unit in enumerate(1e-5 * numpy.eye(3)):
            column = (momenta(momentum + unit) - momenta(momentum - unit)) / 2e-5
            self.agree(found[:, :, k], column, 1e-8)

    def test_defects_are_those_of_rounding(self):
        defects = ["poisson_defect", "symplectic_defect", "leaf_defect"]
        run = free_body().run(**FREE, step=0.1, quantities=defects)
        for name in defects:
            self.assertLess(run[name].max(), 1e-12, name)

    def test_the_sides_are_mirror_images(self):
        # The right system at the inverse of a configuration is the left one with the velocity reversed.
        more = {**FREE, "step": 0.05, "quantities": ["configuration", "body_momentum", "spatial_momentum"]}
        left = free_body().run(**more)
        right = actio.System("SO(3)", free_body().formula, side="right").run(
            **{**more, "velocity": numpy.negative(FREE["velocity"])}
        )
        self.agree(right["configuration"].transpose(0, 2, 1), left["configuration"], 1e-13)
        self.agree(right["spatial_momentum"], -left["body_momentum"], 1e-13)

    def test_a_heavy_top_moves_as_that_of_the_library(self):
        scene = {
            "system": {"kind": "heavy_top", "mass": 2, "inertia": [1, 1.2, 0.9]},
            "system.centre_of_mass": [0, 0.1, 0.5],
            "system.gravity": [0, 0, -3],
            "initial.angular_velocity": [0.5, 0.3, 4],
            "method": {"order": 4, "step": 0.005},
            "run": {"until": 2, "every": 0.25},
            "output.quantities": ["direction_of_gravity", "energy"],
        }
        known = actio.run(scene)
        arm = numpy.array([0, 0.1, 0.5])
        inertia = numpy.diag([1, 1.2, 0.9]) + 2 * (arm @ arm * numpy.eye(3) - numpy.outer(arm, arm))
        top = actio.System(
            "SO(3)",
            lambda w, p, a: w @ inertia @ w / 2 + p.mass * a.gravity @ arm,
            parameters={"mass": 2},
            advected={"gravity": [0, 0, -3]},
        )
        run = top.run(
            velocity=[0.5, 0.3, 4], until=2, every=0.25, step=0.005, order=4, quantities=["gravity", "energy"]
        )
        self.agree(run["gravity"] / 3, known["direction_of_gravity"], 1e-7)
        self.agree(run["energy"], known["energy"], 1e-7)

    def test_a_text_and_a_function_give_the_same_rows(self):
        made = system(lambda x, p: (x.w**2 + x.v1**2 + p.c * x.v2**2) / 2, parameters={"c": 6})
        text = actio.System("SE(2)", "(w^2 + v1^2 + c*v2^2)/2", parameters={"c": 6})
        more = {"velocity": [0.7, 1, 0.2], "until": 1, "every": 0.25}
        self.assertEqual(made.run(**more).table.tobytes(), text.run(**more).table.tobytes())

    def test_a_scene_runs_from_a_file_and_in_a_sweep(self):
        made = system(lambda x, p: x @ x / 2 + p.c * x.v2**2 + actio.exp(x.w / 2), parameters={"c": 6})
        wanted = ["energy", "body_momentum"]
        scene = made.scene(velocity=[0.7, 1, 0.2], until=1, every=0.25, quantities=wanted)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "own.toml")
            file.write_text(str(scene))
            table = actio.run(file).table.tobytes()
        self.assertEqual(actio.run(scene).table.tobytes(), table)
        sweep = actio.sweep(scene, over={"system.parameters.c": [6, 3]})
        self.assertEqual(sweep[0].run.table.tobytes(), table)
        self.assertNotEqual(sweep[1].run.table.tobytes(), table)
        more = {"velocity": [0.7, 1, 0.2], "until": 1, "every": 0.25, "quantities": wanted}
        self.assertEqual(made.run(**more).table.tobytes(), table)
        other = made.run(**more, set={"system.parameters.c": 3})
        self.assertEqual(other.table.tobytes(), sweep[1].run.table.tobytes())

    def test_a_dense_metric_on_a_large_group_is_a_formula_too(self):
        generator = numpy.random.default_rng(3)
        factor = generator.normal(size=(36, 36))
        metric = factor @ factor.T / 36 + numpy.eye(36)
        made = actio.System("SO(9)", lambda x: x @ metric @ x / 2)
        start = 0.1 * generator.normal(size=36)
        run = made.run(velocity=start, until=0.1, every=0.1, quantities=["body_momentum", "energy"])
        self.agree(run["body_momentum"][0], metric @ start, 1e-13)
        self.assertAlmostEqual(run["energy"][0], start @ metric @ start / 2, delta=1e-13)

    def test_every_function_runs(self):
        functions = [name for name in OF_A_FORMULA if name in actio.__all__]
        self.assertEqual(len(functions), 20)
        for name in functions:
            with self.subTest(name):
                function = getattr(actio, name)
                angle = (lambda x: function(x, 2.0)) if name in ("hypot", "atan2") else function
                shift = 2 if name == "acosh" else 0.5
                made = system(lambda x: x @ x / 2 + angle(shift + x.v1 / 10))
                run = made.run(velocity=[0.1, 0.2, 0.3], until=0.1, every=0.1, quantities=["energy"])
                # l - v dl/dv with its sign, by a difference quotient.
                v, h = 0.2, 1e-4
                slope = (angle(shift + (v + h) / 10) - angle(shift + (v - h) / 10)) / (2 * h)
                energy = (0.01 + 0.04 + 0.09) / 2 + v * slope - angle(shift + v / 10)
                self.assertAlmostEqual(run["energy"][0], energy, delta=1e-8)

    def test_what_the_library_refuses_is_told_by_its_key(self):
        for made, pattern in [
            (actio.System("SE(2)", "w^2 + abs(v1)"), "^system.lagrangian: .*abs"),
            (actio.System("SE(2)", "w^2 + v1^2"), "^system.lagrangian: .*not regular .* along v2"),
            (actio.System("SE(2)", "w^2 + u^2"), "^system.lagrangian: .*unknown name 'u'"),
            (actio.System("SO(3)", "w1^2", advected={"a": [1, 2]}), "^system.advected.a: .* found 2"),
        ]:
            with self.subTest(pattern), self.assertRaisesRegex(actio.SceneError, pattern):
                made.run(velocity=[1, 1, 1], until=1)
        with self.assertRaisesRegex(actio.SceneError, "^initial.velocity: "):
            free_body().run(velocity=[1, 2], until=1)

    def test_the_loop_has_no_python_in_it(self):
        calls = []

        def lagrangian(w):
            calls.append(w)
            return w @ INERTIA @ w / 2

        actio.System("SO(3)", lagrangian).run(**FREE, step=0.01)
        self.assertEqual(len(calls), 1)


class ThePage(unittest.TestCase):
    def test_its_examples_run(self):
        page = pathlib.Path(__file__).parents[2] / "docs/pages/05_own_systems.md"
        blocks = re.findall(r"(?:^ {4}.*\n|^\n(?= {4}))+", page.read_text(), re.M)
        self.assertEqual(len(blocks), 7)
        here, said, names = os.getcwd(), io.StringIO(), {}
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                with contextlib.redirect_stdout(said):
                    for block in blocks:
                        exec(compile(textwrap.dedent(block), str(page), "exec"), names)
            finally:
                os.chdir(here)
        for expected in ["softness*sqrt(1 + ", "numbers are compared by >", "(21, 3, 3)"]:
            self.assertIn(expected, said.getvalue())


class Functions(unittest.TestCase):
    def test_they_take_numbers_and_arrays(self):
        self.assertEqual(actio.hypot(3, 4), 5)
        self.assertEqual(actio.cbrt(-8), -2)
        self.assertEqual(actio.sqrt(fractions.Fraction(1, 4)), 0.5)
        self.assertTrue(numpy.array_equal(actio.sin([0.5, 1]), numpy.sin([0.5, 1])))
        self.assertTrue(numpy.array_equal(actio.atan2(numpy.ones(2), 2), numpy.arctan2([1, 1], 2)))
        with self.assertRaisesRegex(ValueError, "domain"):
            actio.sqrt(-1)
        with self.assertRaisesRegex(TypeError, "log: a number is expected, found 'a', of type str"):
            actio.log("a")


class TheSources(unittest.TestCase):
    def test_what_is_public_is_documented(self):
        for thing in (actio.System, actio.Scene):
            self.assertTrue(inspect.getdoc(thing))
        for name, member in inspect.getmembers(actio.System):
            if not name.startswith("_"):
                self.assertTrue(inspect.getdoc(member), name)


class Forces(unittest.TestCase):
    SIMPLE = "(w^2 + v1^2 + 6*v2^2)/2"
    KEYS = {"velocity": [0.3, 0.5, 0], "until": 2, "every": 0.1, "step": 0.05, "order": 4}

    def test_a_function_is_the_formulas_that_it_computes(self):
        system = actio.System(
            "SE(2)",
            self.SIMPLE,
            parameters={"k": 0.3},
            force=lambda velocity, momentum, time, parameters, inputs: [
                inputs.tail - parameters.k * velocity.w,
                numpy.sin(time) - velocity.v1 * abs(velocity.v1),
                -0.1 * momentum.v2,
            ],
            inputs={"tail": "cos(2*t)"},
        )
        self.assertEqual(
            system.force, {"w": "tail - k*w", "v1": "sin(t) - v1*abs(v1)", "v2": "(-0.1)*p_v2"}
        )
        by_text = actio.System(
            "SE(2)",
            self.SIMPLE,
            parameters={"k": 0.3},
            force=["tail - k*w", "sin(t) - v1*abs(v1)", "-0.1*p_v2"],
            inputs={"tail": "cos(2*t)"},
        )
        runs = [each.run(**self.KEYS, quantities=["body_momentum"]) for each in (system, by_text)]
        numpy.testing.assert_array_equal(runs[0].table, runs[1].table)
        self.assertEqual(pickle.loads(pickle.dumps(system)).force, system.force)

    def test_the_balance_of_the_momentum_holds_to_rounding(self):
        system = actio.System("SE(2)", self.SIMPLE, force={"w": "cos(t)", "v2": "-v2*abs(v2)"})
        run = system.run(**self.KEYS, quantities=["momentum_balance", "spatial_momentum"])
        drifts = [run.drift[f"momentum_balance_{name}"] for name in system.components]
        self.assertLess(max(drifts), 1e-14)
        self.assertGreater(abs(run["spatial_momentum"][-1] - run["spatial_momentum"][0]).max(), 0.1)

    def test_a_force_in_space_adds_itself_to_the_momentum(self):
        system = actio.System(
            "SE(2)", self.SIMPLE, force_in_space=lambda time: {"v1": 0.3 + 0 * time, "w": 0.1}
        )
        self.assertEqual(set(system.force_in_space), {"v1", "w"})
        run = system.run(**self.KEYS, quantities=["spatial_momentum", "momentum_balance"])
        grown = run["spatial_momentum"] - run["spatial_momentum"][0]
        numpy.testing.assert_allclose(grown, numpy.outer(run.t, [0.1, 0.3, 0]), atol=1e-13)
        by_text = actio.System("SE(2)", self.SIMPLE, force_in_space=["0.1", 0.3, 0])
        table = by_text.run(**self.KEYS, quantities=["spatial_momentum", "momentum_balance"]).table
        numpy.testing.assert_allclose(table, run.table, atol=1e-13)
        with self.assertRaisesRegex(actio.SceneError, "force_in_space: 3 numbers are expected of it"):
            actio.System("SE(2)", self.SIMPLE, force_in_space=lambda velocity: [1])

    def test_mappings_of_some_components_and_rows_of_inputs(self):
        system = actio.System(
            "SO(3)",
            "(w1^2 + 2*w2^2 + 3*w3^2)/2",
            force=lambda velocity, inputs: {"w2": inputs.push, "w1": 0},
            inputs={"push": [[0, 1], [1, 0]]},
        )
        self.assertEqual(system.force, {"w2": "push", "w1": 0.0})
        keys = {"velocity": [0, 0, 0], "until": 2, "every": 0.5, "step": 0.25}
        run = system.run(**keys, quantities=["body_momentum", "work"])
        numpy.testing.assert_allclose(run["body_momentum_w2"], [0, 0.5, 1, 1, 1], atol=1e-15)
        self.assertAlmostEqual(run["work"][-1], 0.25, 14)

    def test_refusals(self):
        def made(force, **others):
            return actio.System("SE(2)", self.SIMPLE, force=force, **others)

        for force, error, words in [
            (lambda velocity: [1, 2], actio.SceneError, "3 numbers are expected of it.*list of 2"),
            (lambda velocity: {"v3": 1}, actio.SceneError, "component 'v3'; there is w, v1, v2"),
            (lambda velocity: [1, 2, "x"], actio.SceneError, "number is expected as its component v2"),
            (lambda speed: [1, 2, 3], TypeError, "velocity, momentum.*found 'speed'"),
            (lambda velocity: [1 if velocity.w > 0 else 0, 0, 0], actio.SceneError, "a force is called"),
            (lambda velocity: [numpy.trunc(velocity.w), 0, 0], actio.SceneError, "no function of a formula"),
            (3, TypeError, "force: a function, a mapping"),
        ]:
            with self.assertRaisesRegex(error, words):
                made(force)
        with self.assertRaisesRegex(actio.SceneError, "inputs: w is a component of the velocity already"):
            made(["w", 0, 0], inputs={"w": "t"})
        with self.assertRaisesRegex(actio.SceneError, "inputs: u: a formula of t or rows"):
            made(["u", 0, 0], inputs={"u": [1, 2]})
        with self.assertRaisesRegex(actio.SceneError, "3 formulas are expected"):
            made(["w", 0]).run(**self.KEYS)
        with self.assertRaisesRegex(actio.SceneError, "lagrangian: .*`.*abs.*not smooth"):
            actio.System("SE(2)", lambda xi: abs(xi.w) + xi @ xi)


class Definitions(unittest.TestCase):
    KEYS = {"velocity": [0.7, 1, 0.2], "until": 1, "step": 0.1, "quantities": ["body_momentum", "force"]}

    def test_formulas_share_them(self):
        short = actio.System(
            "SE(2)",
            "(w^2 + v1^2 + side)/2",
            parameters={"c": 6},
            definitions={"side": "c*v2^2", "drag": "-c*v2*slow", "slow": "abs(v2)"},
            force={"v2": "drag", "w": "-0.1*slow"},
        )
        long = actio.System(
            "SE(2)",
            "(w^2 + v1^2 + c*v2^2)/2",
            parameters={"c": 6},
            force={"v2": "-c*v2*abs(v2)", "w": "-0.1*abs(v2)"},
        )
        runs = [each.run(**self.KEYS) for each in (short, long)]
        numpy.testing.assert_array_equal(runs[0].table, runs[1].table)

    def test_names_of_definitions_and_of_a_function_keep_apart(self):
        made = actio.System(
            "SE(2)",
            lambda xi: (xi.w**2 + xi.v1**2) ** 2 + xi.v1**2 + xi.v2**2 + (xi.w**2 + xi.v1**2),
            definitions={"t1": "-w"},
            force={"w": "t1"},
        )
        self.assertIn("t_1 = ", made.formula)
        made.run(**self.KEYS)

    def test_refusals(self):
        for definitions, words in [
            ({"w": "1"}, "definitions: w is a component of the velocity already"),
            ({"c": "1"}, "definitions: c is a parameter already"),
            ({"t": "1"}, "definitions: t is the time already"),
            ({"1a": "1"}, "definitions: a name of letters and digits"),
        ]:
            with self.assertRaisesRegex(actio.SceneError, words):
                actio.System("SE(2)", "c*w^2", parameters={"c": 6}, definitions=definitions)
        with self.assertRaisesRegex(actio.SceneError, "definitions: 'r' does not occur in the lagrangian"):
            actio.System("SE(2)", "w^2 + v1^2 + v2^2", definitions={"r": "w"}).run(**self.KEYS)


class Constraints(unittest.TestCase):
    SLEIGH = "(2*w^2 + v1^2 + v2^2)/2 + w*v2"

    def test_a_blade_turns_as_its_law_has_it(self):
        # Chaplygin's sleigh: blade at the origin, mass centre 1 ahead, moments 1 + 1: v = V tanh(k t + c),
        # w = W sech(k t + c) with V = sqrt(2E), W = sqrt(2E/2), k = V/2.
        by_function = actio.System("SE(2)", self.SLEIGH, constraints=lambda velocity: [velocity.v2])
        self.assertEqual(by_function.constraints, ["v2"])
        run = by_function.run(
            velocity=[1, 0, 0],
            until=3,
            every=0.5,
            step=0.005,
            order=4,
            quantities=["velocity", "constraint", "reaction"],
        )
        k = numpy.sqrt(2) / 2
        w, v = 1 / numpy.cosh(k * run.t), numpy.sqrt(2) * numpy.tanh(k * run.t)
        numpy.testing.assert_allclose(run["velocity_w"], w, atol=1e-8)
        numpy.testing.assert_allclose(run["velocity_v1"], v, atol=1e-8)
        # The blade holds the mass centre: w' + v w, with w' = -w v/2.
        numpy.testing.assert_allclose(run["reaction"][:, 0], v * w / 2, atol=1e-8)
        self.assertLess(abs(run["constraint"]).max(), 1e-13)
        by_text = actio.System("SE(2)", self.SLEIGH, constraints=["v2"])
        scenes = [str(each.scene(velocity=[1, 0, 0], until=1)) for each in (by_text, by_function)]
        self.assertEqual(*scenes)
        free = actio.System("SE(2)", self.SLEIGH).scene(velocity=[1, 0, 0], until=1)
        self.assertNotIn("constraints", free["system"])

    def test_drag_and_a_blade_together(self):
        system = actio.System(
            "SE(2)",
            self.SLEIGH,
            constraints=["v2"],
            force=lambda velocity: {"v1": -velocity.v1 * abs(velocity.v1)},
        )
        keys = {"velocity": [1, 0.2, 0], "until": 2, "every": 1, "quantities": ["velocity", "constraint"]}
        coarse, fine, finest = [system.run(**keys, step=step, order=2) for step in (0.1, 0.05, 0.0125)]
        errors = [abs(each["velocity"][-1] - finest["velocity"][-1]).max() for each in (coarse, fine)]
        self.assertGreater(errors[0] / errors[1], 3.5)
        self.assertLess(abs(finest["constraint"]).max(), 1e-13)

    def test_refusals(self):
        for constraints, error, words in [
            (lambda velocity: velocity.v2, actio.SceneError, "constraints: a list of numbers is expected"),
            (lambda momentum: [momentum.v2], TypeError, "some of velocity, advected, time, parameters"),
            (lambda velocity: [abs(velocity.v2)], actio.SceneError, "a constraint has to be smooth"),
            ("v2", TypeError, "a function or a list of formulas"),
        ]:
            with self.assertRaisesRegex(error, words):
                actio.System("SE(2)", self.SLEIGH, constraints=constraints)


if __name__ == "__main__":
    unittest.main()
