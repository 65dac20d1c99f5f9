"""A run, held in memory as one table."""

import difflib
import html
import json
import re
import warnings
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Optional

import numpy
from numpy.typing import NDArray

from actio import _actio
from actio._errors import SceneError
from actio._html import cell, figures, table
from actio._paths import Path, encoded_path
from actio._snapshots import Snapshots
from actio._values import shown

if TYPE_CHECKING:
    import pandas

Array = NDArray[numpy.float64]


def import_pandas(who: str) -> Any:
    """The module pandas, which is not needed otherwise."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError(
            f"{who} needs pandas, which this interpreter does not have (Debian: python3-pandas)"
        ) from error
    return pandas


class Run(Mapping[str, Array]):
    """A run: a mapping of the names of its quantities to arrays, with one row for each time.

    Arrays look into one table, without a copy, and keep it alive; they cannot be written to.
    `run["energy"]` is a quantity, `run["body_momentum_x"]` a column. A run can be pickled and copied.
    """

    __slots__ = ("_table", "_about", "__weakref__")
    _table: Array
    _about: dict[str, Any]

    @classmethod
    def _of(cls, table: Array, about: dict[str, Any]) -> "Run":
        table.flags.writeable = False
        self = object.__new__(cls)
        self._table, self._about = table, about
        if not about["summary"].strip():
            about["summary"] = json.dumps({"status": "unfinished", "rows": len(table)})
        return self

    def __init__(self) -> None:
        raise TypeError("Run: runs are made by actio.run, actio.load and actio.sweep")

    def __reduce__(self) -> Any:
        return Run._of, (self._table, self._about)

    # A run is equal to itself alone, and may be a key of a dictionary.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    # ---- Numbers

    @property
    def t(self) -> Array:
        """The times of the rows."""
        return self._table[:, 0]

    @property
    def table(self) -> Array:
        """All columns, the time first."""
        return self._table

    @property
    def rows(self) -> int:
        """The number of rows."""
        return len(self._table)

    @property
    def columns(self) -> list[str]:
        """Names of the columns of the table, the time first."""
        return list(self._about["columns"])

    @property
    def quantities(self) -> list[str]:
        """Names of the quantities, over which a run is a mapping."""
        return [info["name"] for info in self._about["quantities"]]

    def __getitem__(self, name: str) -> Array:
        """A quantity, with one row for each time and the shape of the quantity; or a column."""
        first = 1
        for info in self._about["quantities"]:
            width = len(info["columns"])
            if info["name"] == name:
                return self._table[:, first : first + width].reshape(self.rows, *info["shape"])
            first += width
        if isinstance(name, str) and name in self._about["columns"]:
            return self._table[:, self._about["columns"].index(name)]
        raise KeyError(self._unknown(name))

    def _unknown(self, name: Any) -> str:
        near = (
            difflib.get_close_matches(name, self.quantities + self.columns, 1)
            if isinstance(name, str)
            else []
        )
        return f"there is no quantity {shown(name)} in this run" + (
            f"; did you mean {near[0]!r}?" if near else ""
        )

    def __iter__(self) -> Iterator[str]:
        return iter(self.quantities)

    def __len__(self) -> int:
        """The number of quantities, as of any mapping; `rows` is the number of rows."""
        return len(self._about["quantities"])

    def __array__(self, dtype: Any = None, copy: Any = None) -> Array:
        """The table."""
        if copy:
            return numpy.array(self._table, dtype=dtype, copy=True)
        return self._table if dtype is None else numpy.asarray(self._table, dtype=dtype)

    def matrix(self, name: str) -> Array:
        """A quantity that is a matrix, N by n by n. Of a skew matrix, whose upper triangle is `run[name]`,
        the whole."""
        info = self.quantity_info(name)
        if info["kind"] == "matrix":
            return self[name]
        if info["kind"] != "skew matrix":
            raise ValueError(f"matrix: {name} is a {info['kind']}, and no matrix")
        size, n = len(info["columns"]), 1
        while n * (n - 1) // 2 < size:
            n += 1
        out = numpy.zeros((self.rows, n, n))
        i, j = numpy.triu_indices(n, 1)
        out[:, i, j] = self[name]
        out[:, j, i] = 0 - self[name]
        return out

    # ---- What the numbers are

    def quantity_info(self, name: str) -> dict[str, Any]:
        """What is known of a quantity: name, kind, unit, meaning, formula (TeX), statement of the thesis,
        needs, conserved, columns, shape."""
        for info in self._about["quantities"]:
            if info["name"] == name:
                return {key: list(value) if isinstance(value, list) else value for key, value in info.items()}
        raise KeyError(self._unknown(name))

    def columns_of(self, name: str) -> list[str]:
        """Names of the columns of a quantity."""
        columns: list[str] = self.quantity_info(name)["columns"]
        return columns

    @property
    def units(self) -> dict[str, str]:
        """The unit of the time, "t", and of each quantity."""
        time = self._about["time_unit"] or "time"
        return {"t": time, **{info["name"]: info["unit"] for info in self._about["quantities"]}}

    @property
    def meanings(self) -> dict[str, str]:
        """What each quantity is, in a sentence."""
        return {info["name"]: info["meaning"] for info in self._about["quantities"]}

    # ---- How it went

    @property
    def scene(self) -> str:
        """The scene with every default written out, in TOML."""
        text: str = self._about["scene"]
        return text

    @property
    def summary(self) -> dict[str, Any]:
        """What summary.json holds, as a dictionary."""
        found: dict[str, Any] = json.loads(self._about["summary"])
        return found

    @property
    def drift(self) -> dict[str, float]:
        """How far each conserved quantity has drifted, as the summary tells it."""
        return dict(self.summary.get("drift") or {})

    @property
    def error(self) -> dict[str, float]:
        """The estimated errors of the method, as the summary tells them; empty where there is no estimate.
        What has none at the end has a sentence in `untold`."""
        told = self.summary.get("error")
        entries = told.items() if isinstance(told, dict) else ()
        return {name: value for name, value in entries if isinstance(value, (int, float))}

    @property
    def accuracy(self) -> Optional[float]:
        """The error that the scene allows, by which its order and step were chosen; None where it allows none
        by name. Where the error at the end is larger, or none is told, a remark of the summary says so."""
        allowed = self.summary.get("accuracy")
        return None if allowed is None else float(allowed)

    @property
    def snapshots(self) -> Snapshots:
        """The snapshots that the scene asks for in [output]; none where it asks for none. Of a run that was
        loaded they are read from its folder when this is first asked for."""
        held = self._about["snapshots"]
        if self._about["with_snapshots"] and not len(held["t"]) and "folder" in self._about:
            held = self._about["snapshots"] = _actio.snapshots(self._about["folder"])
        return Snapshots._of(held)

    @property
    def untold(self) -> dict[str, str]:
        """Why no error of a quantity is told, and until when there was one: a sentence for each of them."""
        told = self.summary.get("error")
        entries = told.items() if isinstance(told, dict) else ()
        return {name: value for name, value in entries if isinstance(value, str) and name != "how"}

    # ---- For others

    def to_dict(self) -> dict[str, Array]:
        """The time, "t", and each quantity in its shape."""
        return {"t": self.t, **self}

    def to_pandas(self) -> "pandas.DataFrame":
        """A data frame with a column for each column of the table, and the time as its index; a copy, to be
        changed at will. `attrs` holds title and units."""
        pandas = import_pandas("Run.to_pandas")
        frame = pandas.DataFrame(
            self._table[:, 1:].copy(), index=pandas.Index(self.t.copy(), name="t"), columns=self.columns[1:]
        )
        frame.attrs.update(title=self.summary.get("title", ""), units=self.units)
        return frame

    def save(self, folder: Path, *, plots: bool = False) -> None:
        """Writes what the command leaves, but no checkpoint: scene.toml, the table in the formats that the
        scene names, and summary.json. plots: with the pictures and their page, plots/index.html. The folder
        is made; one that is not empty is refused. Snapshots are not written, which is warned of."""
        where = encoded_path(folder, "folder")
        if self._about["with_snapshots"]:
            warnings.warn(
                "Run.save writes no snapshots; the command `actio run` does, and run.snapshots holds them",
                stacklevel=2,
            )
        try:
            _actio.save(self.scene.encode(), self._table, self._about["summary"].encode(), where, bool(plots))
        except SceneError as error:
            # The command has options for it.
            raise SceneError(
                re.sub("; --(force|out).*", "; Run.save takes a folder that is new or empty", str(error))
            ) from None

    def __repr__(self) -> str:
        status = self.summary.get("status", "")
        ended = "" if status == "done" else f", {status}"
        until = f" to t = {self.t[-1]:g}" if self.rows else ""
        return f"<actio.Run: {self.rows} rows{until} of {', '.join(self.quantities)}{ended}>"

    def _repr_html_(self) -> str:
        """The head of the table, and above it what the closing line of the command says."""
        summary = self.summary
        caption = (
            f"<b>{cell(summary.get('title', ''))}</b> ({cell(summary.get('system', ''))},"
            f" {cell(summary.get('status', ''))}): {self.rows} rows"
        )
        caption += f" to t = {self.t[-1]:g}" if self.rows else ""
        caption += figures("drift", self.drift) + figures("error", self.error)
        if self.accuracy is not None:
            caption += f"; accuracy {self.accuracy:g}"
        for name, said in self.untold.items():
            caption += f"; error of {html.escape(name)}: {html.escape(said)}"
        first = [[float(x) for x in row] for row in self.table[:5]]
        rest = f"<p>… {self.rows - 5} rows more</p>" if self.rows > 5 else ""
        return "<div>" + table(self.columns, first, caption) + rest + "</div>"
