"""Systems of one's own: a group, and a Lagrangian of the velocity."""

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import NDArray

from actio._algebra import Group, algebra_of
from actio._errors import SceneError
from actio._force import checked_inputs, constraints_of, formulas_of
from actio._formula_functions import FUNCTIONS, KINKED
from actio._lagrangian import Surroundings, formula_of
from actio._refusals import FORCE, FORCE_IN_SPACE, Subject
from actio._run import Run
from actio._running import Progress, checked_choice, run
from actio._values import SceneText, kind, shown

#: A text, or a function of one to three arguments: velocity, parameters, carried vectors.
Lagrangian = Union[str, Callable[..., Any]]
#: A formula for each component, by its name or in their order; or a function with named arguments.
Force = Union[Mapping[str, Union[str, float]], Sequence[Union[str, float]], Callable[..., Any]]
Vector = Union[Sequence[float], NDArray[Any]]

_STATE = ("configuration", "velocity", "body_momentum", "spatial_momentum", "energy")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")


class Scene(dict[str, Any]):
    """A scene as a mapping, for `actio.run` and `actio.sweep`. `str(scene)` is its text in TOML, for a file
    that the command runs."""

    def __str__(self) -> str:
        return SceneText(self).text.decode()


def _named(table: Any, what: str, example: str) -> dict[str, Any]:
    """A mapping by names that a formula can have."""
    if table is None:
        return {}
    if not isinstance(table, Mapping):
        raise TypeError(
            f"{what}: a mapping such as {example} is expected, found {shown(table)}, of type {kind(table)}"
        )
    for name in table:
        if not isinstance(name, str) or not _NAME.match(name):
            raise SceneError(f"{what}: a name of letters and digits is expected, found {shown(name)}")
    return dict(table)


def _real(value: Any, where: str) -> Union[int, float]:
    if isinstance(value, (bool, int)):
        return int(value)
    try:
        number = numpy.asarray(value)
        found = float(number) if number.shape == () and number.dtype.kind not in "cSU" else numpy.nan
    except (TypeError, ValueError):
        found = numpy.nan
    if not numpy.isfinite(found):
        raise SceneError(
            f"{where}: a number is expected, found {shown(value)}; what is to stay as it is, an array for"
            " instance, can be a variable of Python that the Lagrangian uses"
        )
    return found


def _vector(value: Any, where: str) -> list[float]:
    try:
        found = numpy.asarray(value, dtype=float)
    except (TypeError, ValueError):
        found = numpy.empty(0)
    if found.ndim != 1 or not found.size or not numpy.isfinite(found).all():
        raise SceneError(f"{where}: a list of numbers is expected, found {shown(value)}")
    return [float(number) for number in found]


def _checked_names(
    components: Sequence[str],
    parameters: Mapping[str, Any],
    advected: Mapping[str, Any],
    inputs: Mapping[str, Any],
    definitions: Mapping[str, Any],
) -> None:
    """No name may mean two things."""
    meanings = {**dict.fromkeys(FUNCTIONS, "a function"), "pi": "the number pi"}
    meanings.update(dict.fromkeys(components, "a component of the velocity"))
    for name in parameters:
        if name in meanings:
            raise SceneError(f"parameters: {name} is {meanings[name]} already")
        meanings[name] = "a parameter"
    for name, items in advected.items():
        for own in (f"{name}{k + 1}" for k in range(len(items))):
            if own in meanings:
                raise SceneError(
                    f"advected: {name} has the component {own}, which is {meanings[own]} already"
                )
            meanings[own] = "a component of a carried vector"
    if inputs or definitions:
        meanings.update(dict.fromkeys(KINKED, "a function"), t="the time")
        meanings.update(dict.fromkeys((f"p_{name}" for name in components), "a component of the momentum"))
    for key, names in ("inputs", inputs), ("definitions", definitions):
        for name in names:
            if name in meanings:
                raise SceneError(f"{key}: {name} is {meanings[name]} already")
            meanings[name] = "an input"


class System:
    """A system of your own: a group, and a Lagrangian that is invariant under it.

        sleigh = actio.System(
            group="SE(2)",
            lagrangian=lambda xi, p: (xi.w**2 + xi.v1**2 + p.c * xi.v2**2) / 2,
            parameters={"c": 6},
        )
        run = sleigh.run(velocity=[0.7, 1, 0.2], until=10, every=0.1, step=0.01, quantities=["energy"])

    group: the name of a group, "SO(3)", "SE(2) x R^1" (`actio.groups()` has them all); or a list of matrices
        that are a basis of its Lie algebra.
    lagrangian: a function of the velocity; of two arguments, of velocity and parameters; of three, of
        velocity, parameters and advected vectors. The velocity is an array whose items have names as well,
        `xi.v1`, and `xi.matrix` is its matrix; parameters are `p.c`, advected vectors arrays, `a.gravity`. Or
        the text of a formula: "(w^2 + v1^2 + c*v2^2)/2".
    side: "left" where the Lagrangian is invariant under left multiplication, its velocity that in the body;
        or "right".
    parameters: numbers by name, which a scene can change.
    advected: vectors by name which the inverse of the motion carries, a = g^-1 c (left) or a = g c (right),
        with their values where g is the identity.
    force: a covector in the components of the velocity, whose power is the sum of their products: a mapping
        or a list of formulas; or a function of some of `velocity`, `momentum`, `advected`, `time`,
        `parameters` and `inputs`, by these names, that returns a list or a mapping of numbers. It need not
        be smooth: abs, numpy.sign, numpy.minimum and the like are there.
    force_in_space: a force that is added, in the same forms and of the same arguments, with components of
        the velocity in space, for side="left".
    constraints: what vanishes along the motion by the principle of Lagrange and d'Alembert, linear in the
        velocity: a list of formulas, or a function of some of `velocity`, `advected`, `time` and
        `parameters`, by these names, that returns a list of numbers. The velocity at the start obeys them,
        or the scene has `initial.project = True`.
    inputs: numbers by name that the force is given as functions of time, each held over a step: a formula of
        t, "20*(t < 5)", or rows of a time and the value from then on, [[0, 20], [5, 0]].
    definitions: formulas by name, {"r": "1 - 4*up3"}, which formulas that are texts use, and each other.

    A function is called once, with symbols, and what it does becomes the formula `formula`: Python has no
    part in the run. So it cannot branch on its arguments, and the functions of the module math, which need
    floats, are replaced by those of actio or of NumPy.

    Raises SceneError where the function branches, is not smooth, or returns no number that depends on the
    velocity; where the matrices are no basis of a Lie algebra; where a name has two meanings.
    """

    __slots__ = (
        "_algebra", "_side", "_formula", "_parameters", "_advected", "_force", "_inputs", "_constraints",
        "_definitions", "_force_in_space",
    )

    def __init__(
        self,
        group: Group,
        lagrangian: Lagrangian,
        *,
        side: str = "left",
        parameters: Optional[Mapping[str, float]] = None,
        advected: Optional[Mapping[str, Vector]] = None,
        force: Optional[Force] = None,
        inputs: Optional[Mapping[str, Any]] = None,
        constraints: Union[Sequence[str], Callable[..., Any], None] = None,
        definitions: Optional[Mapping[str, Union[str, float]]] = None,
        force_in_space: Optional[Force] = None,
    ) -> None:
        self._side: str = checked_choice(side, ("left", "right"), "side")
        self._algebra = algebra_of(group)
        self._parameters = {
            name: _real(value, f"parameters: {name}")
            for name, value in _named(parameters, "parameters", '{"c": 6}').items()
        }
        self._advected = {
            name: _vector(value, f"advected: {name}")
            for name, value in _named(advected, "advected", '{"gravity": [0, 0, -1]}').items()
        }
        self._inputs = checked_inputs(_named(inputs, "inputs", '{"thrust": "20*(t < 5)"}'))
        self._definitions = _named(definitions, "definitions", '{"r": "1 - 4*up3"}')
        _checked_names(
            self.components, self._parameters, self._advected, self._inputs, self._definitions
        )
        self._formula = self._formula_of(lagrangian)
        self._force = self._force_of(force, FORCE)
        self._force_in_space = self._force_of(force_in_space, FORCE_IN_SPACE)
        self._constraints = self._constraints_of(constraints)

    def _formula_of(self, lagrangian: Any) -> str:
        if isinstance(lagrangian, str):
            return str(lagrangian)
        if not callable(lagrangian):
            raise TypeError(
                "lagrangian: a function or the text of a formula is expected, found"
                f" {shown(lagrangian)}, of type {kind(lagrangian)}"
            )
        return formula_of(lagrangian, self._surroundings())

    def _surroundings(self) -> Surroundings:
        sizes = {name: len(items) for name, items in self._advected.items()}
        return Surroundings(
            self.components, self._algebra.basis, list(self._parameters), sizes, list(self._definitions)
        )

    def _force_of(self, force: Any, what: Subject) -> Any:
        """As a scene has it: by components, or a list; None where there is none."""
        if force is None or isinstance(force, Mapping):
            return force if force is None else dict(force)
        if callable(force):
            return formulas_of(force, self._surroundings(), list(self._inputs), what)
        if isinstance(force, (list, tuple)):
            return list(force)
        raise TypeError(
            f"{what.key}: a function, a mapping by components or a list of formulas is expected, found"
            f" {shown(force)}, of type {kind(force)}"
        )

    def _constraints_of(self, constraints: Any) -> Any:
        if callable(constraints):
            return constraints_of(constraints, self._surroundings())
        if constraints is None or isinstance(constraints, (list, tuple)):
            return constraints and list(constraints)
        raise TypeError(
            "constraints: a function or a list of formulas is expected, found"
            f" {shown(constraints)}, of type {kind(constraints)}"
        )

    # ---- What it is

    @property
    def group(self) -> str:
        """The name of the group; empty where it was given by a basis."""
        return self._algebra.name

    @property
    def basis(self) -> NDArray[numpy.float64]:
        """The basis of the Lie algebra: matrices, dimension by n by n."""
        return self._algebra.basis.copy()

    @property
    def components(self) -> list[str]:
        """The names of the components of the velocity."""
        return list(self._algebra.components)

    @property
    def side(self) -> str:
        """ "left" or "right"."""
        return self._side

    @property
    def formula(self) -> str:
        """The Lagrangian as a formula of a scene."""
        return self._formula

    @property
    def force(self) -> Any:
        """The formulas of the force, by components or in their order; None where there is none."""
        return _copied(self._force)

    @property
    def force_in_space(self) -> Any:
        """The formulas of the force in components of space, as those of `force`."""
        return _copied(self._force_in_space)

    @property
    def constraints(self) -> list[str]:
        """The formulas of the constraints on the velocity; empty where there are none."""
        return list(self._constraints or ())

    @property
    def parameters(self) -> dict[str, float]:
        """The parameters by name."""
        return dict(self._parameters)

    @property
    def advected(self) -> dict[str, list[float]]:
        """The advected vectors by name, with their values where the motion is the identity."""
        return {name: list(items) for name, items in self._advected.items()}

    # ---- What is done with it

    def scene(
        self,
        *,
        velocity: Vector,
        until: float,
        every: Optional[float] = None,
        step: Optional[float] = None,
        order: Optional[int] = None,
        accuracy: Optional[float] = None,
        method: Optional[str] = None,
        configuration: Optional[Any] = None,
        quantities: Union[str, Sequence[str], None] = None,
        title: Optional[str] = None,
    ) -> Scene:
        """The scene of a run: a mapping for `actio.run` and `actio.sweep`, and `str` of it a text for a file.

        velocity: at the beginning, in the order of `components`.
        until, every: the last time, and the time from row to row.
        step, order, method: of the method, which is one of `actio.systems()["euler_poincare"]["methods"]`.
        accuracy: in place of the step, and of the order where it is left out: the largest error that
            configuration, momentum and advected vectors may have until the end, relative. Both are chosen by
            it, as `Run.scene` and the remarks of `Run.summary` say, and `Run.error` is compared with it.
        configuration: the matrix at the beginning; the identity where it is left out.
        quantities: what the rows hold, a name or several of `actio.quantities("euler_poincare")` and of
            advected vectors; where it is left out, configuration, velocity, momenta, energy and the
            advected vectors.
        title: of the scene.

        All else that is left out has the default of the scene.
        """
        if until is None:
            raise TypeError("until: the last time of the run is needed, found None")
        if isinstance(quantities, str):
            quantities = [quantities]
        system: dict[str, Any] = {"kind": "euler_poincare"}
        if self._algebra.name:
            system["group"] = self._algebra.name
        else:
            system["algebra"] = self._algebra.basis.tolist()
        system.update(side=self._side, lagrangian=self._formula)
        if self._parameters:
            system["parameters"] = self.parameters
        if self._advected:
            system["advected"] = self.advected
        if self._force is not None:
            system["force"] = self.force
        if self._force_in_space is not None:
            system["force_in_space"] = self.force_in_space
        if self._inputs:
            system["inputs"] = dict(self._inputs)
        if self._constraints is not None:
            system["constraints"] = self.constraints
        if self._definitions:
            system["definitions"] = dict(self._definitions)
        tables: dict[str, dict[str, Any]] = {
            "scene": {"title": title},
            "system": system,
            "initial": {"velocity": _plain(velocity), "configuration": _plain(configuration)},
            "method": {"name": method, "order": order, "step": step},
            "run": {"until": until, "every": every, "accuracy": accuracy},
            "output": {"quantities": list((*_STATE, *self._advected) if quantities is None else quantities)},
        }
        return Scene(
            {
                name: there
                for name, table in tables.items()
                if (there := {key: value for key, value in table.items() if value is not None})
            }
        )

    def run(
        self,
        *,
        velocity: Vector,
        until: float,
        every: Optional[float] = None,
        step: Optional[float] = None,
        order: Optional[int] = None,
        accuracy: Optional[float] = None,
        method: Optional[str] = None,
        configuration: Optional[Any] = None,
        quantities: Union[str, Sequence[str], None] = None,
        title: Optional[str] = None,
        set: Optional[Mapping[str, Any]] = None,
        progress: Optional[Progress] = None,
        on_interrupt: str = "raise",
    ) -> Run:
        """Runs it: `actio.run` of the scene that `System.scene` makes of the same arguments; set, progress
        and on_interrupt are those of `actio.run`."""
        scene = self.scene(
            velocity=velocity,
            until=until,
            every=every,
            step=step,
            order=order,
            accuracy=accuracy,
            method=method,
            configuration=configuration,
            quantities=quantities,
            title=title,
        )
        return run(scene, set=set, progress=progress, on_interrupt=on_interrupt)

    def __repr__(self) -> str:
        where = self.group or f"a group of {len(self.components)} dimensions"
        return f"<actio.System on {where}: {shown(self._formula)[1:-1]}>"


def _copied(force: Any) -> Any:
    return dict(force) if isinstance(force, dict) else force and list(force)


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, numpy.ndarray) else value
