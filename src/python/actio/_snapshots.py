"""Snapshots of a field: arrays over positions and times."""

import difflib
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy
from numpy.typing import NDArray

from actio._values import shown

if TYPE_CHECKING:
    import xarray


class Snapshots(Mapping[str, NDArray[Any]]):
    """The snapshots of a run: a mapping of the names of its fields to arrays, the first axis of which is that
    of the times `t`. `coordinates` holds the positions to which the numbers belong; `axes(name)` names the axes.

        run = actio.run(scene)                  # [output] snapshots = ["pressure"]
        x, y = run.snapshots["position"][-1].T     # of the nodes, at the last time
        run.snapshots["pressure"][-1]           # a number for each node
        run.snapshots.to_xarray()               # a Dataset, where xarray is installed

    Of a medium: position, velocity and what was asked for, at the nodes, whose points in the reference are the
    coordinate "reference"; "cells" holds the nodes at the corners of each cell, in the order of VTK. Of a
    flow on the sphere: vorticity and what was asked for over latitude and longitude in radians, and the
    coefficients harmonics_re and harmonics_im of degree l and order m. The numbers are those of the tables,
    bit for bit.
    """

    __slots__ = ("_held",)
    _held: dict[str, Any]

    @classmethod
    def _of(cls, held: dict[str, Any]) -> "Snapshots":
        self = object.__new__(cls)
        for one in held["fields"] + held["coordinates"]:
            if one["counts"] and one["numbers"].dtype != numpy.int64:
                one["numbers"] = one["numbers"].astype(numpy.int64)
            one["numbers"].flags.writeable = False
        held["t"].flags.writeable = False
        self._held = held
        return self

    def __init__(self) -> None:
        raise TypeError("Snapshots: they are those of a run, run.snapshots")

    def __reduce__(self) -> Any:
        return Snapshots._of, (self._held,)

    @property
    def t(self) -> NDArray[numpy.float64]:
        """The times of the snapshots."""
        times: NDArray[numpy.float64] = self._held["t"]
        return times

    @property
    def coordinates(self) -> dict[str, NDArray[Any]]:
        """What is the same for all snapshots: the positions to which the numbers belong."""
        return {one["name"]: one["numbers"] for one in self._held["coordinates"]}

    def __getitem__(self, name: str) -> NDArray[Any]:
        """A field, at all times."""
        return self._found(name)[0]["numbers"]  # type: ignore[no-any-return]

    def __iter__(self) -> Iterator[str]:
        return (one["name"] for one in self._held["fields"])

    def __len__(self) -> int:
        """The number of fields, as of any mapping; `len(t)` is that of the snapshots."""
        return len(self._held["fields"])

    def _found(self, name: Any) -> tuple[dict[str, Any], tuple[str, ...]]:
        """A field or a coordinate, and its axes."""
        for one in self._held["fields"]:
            if one["name"] == name:
                return one, ("time", *one["axes"])
        for one in self._held["coordinates"]:
            if one["name"] == name:
                return one, tuple(one["axes"])
        known = [*self, *self.coordinates]
        near = difflib.get_close_matches(name, known, 1) if isinstance(name, str) else []
        raise KeyError(
            f"there is no field {shown(name)} in these snapshots"
            + (f"; did you mean {near[0]!r}?" if near else f"; there are {', '.join(known) or 'none'}")
        )

    def axes(self, name: str) -> tuple[str, ...]:
        """Names of the axes of a field or a coordinate: ("time", "node", "axis")."""
        return self._found(name)[1]

    @property
    def meanings(self) -> dict[str, str]:
        """What each field and each coordinate is, in a few words."""
        return {one["name"]: one["meaning"] for one in self._held["fields"] + self._held["coordinates"]}

    @property
    def units(self) -> dict[str, str]:
        """The unit of each field and coordinate that has one."""
        every = self._held["fields"] + self._held["coordinates"]
        return {one["name"]: one["unit"] for one in every if one["unit"]}

    def to_xarray(self) -> "xarray.Dataset":
        """All fields as a Dataset with named axes and coordinates; xarray has to be installed."""
        try:
            import xarray
        except ImportError as error:
            raise ImportError(
                "Snapshots.to_xarray needs xarray, which this interpreter does not have (Debian:"
                " python3-xarray)"
            ) from error

        def variable(one: dict[str, Any]) -> tuple[Any, ...]:
            told = {"long_name": one["meaning"], "units": one["unit"]}
            attributes = {key: text for key, text in told.items() if text}
            return self._found(one["name"])[1], one["numbers"], attributes

        coordinates: dict[str, Any] = {one["name"]: variable(one) for one in self._held["coordinates"]}
        coordinates["time"] = self.t
        for one in self._held["fields"]:
            if one["names"]:
                coordinates["component"] = one["names"]
        return xarray.Dataset(
            {one["name"]: variable(one) for one in self._held["fields"]}, coords=coordinates
        )

    def __repr__(self) -> str:
        if not len(self):
            return "<actio.Snapshots: none>"
        until = f" to t = {self.t[-1]:g}" if len(self.t) else ""
        return f"<actio.Snapshots: {len(self.t)}{until} of {', '.join(self)}>"
