"""Sweeps: one scene for each of many values, run in threads."""

import itertools
import os
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from typing import TYPE_CHECKING, Any, Optional, overload

import numpy

from actio._errors import Error, FileError, NumericsError, SceneError, Stopped
from actio._html import table
from actio._run import Run, import_pandas
from actio._running import SceneLike, Source, attach, checked_call, checked_choice, outcome, warn_of_files
from actio._values import changes, kind, shown

if TYPE_CHECKING:
    import pandas

MOST_MEMBERS = 1_000_000
Progress = Callable[[float, int], Any]


class Member:
    """One run of a sweep: its number, its values, and its run, or what went wrong.

    index: the number of the member, from 0.
    values: the swept keys and the values that they have here.
    run: its `Run`; where it failed or was stopped, the rows that there were by then, or None.
    error: the exception that ended it; None where it came to its end.
    """

    __slots__ = ("index", "values", "run", "error")

    def __init__(
        self, index: int, values: dict[str, Any], run: Optional[Run], error: Optional[BaseException]
    ) -> None:
        self.index = index
        self.values = values
        #: The run; where it failed or was stopped, what there was of it by then, or None.
        self.run = run
        #: None where the run came to its end.
        self.error = error

    @property
    def status(self) -> int:
        """The exit status of the command for such a run: 0 done, 2 scene, 3 numerics, 4 file, 130 stopped."""
        if self.error is None:
            return 0
        for failure, status in ((SceneError, 2), (NumericsError, 3), (FileError, 4), (Stopped, 130)):
            if isinstance(self.error, failure):
                return status
        return 3

    def __repr__(self) -> str:
        values = ", ".join(f"{key}={shown(value)}" for key, value in self.values.items())
        return (
            f"<actio.Member {self.index} ({values}):"
            f" {'done' if self.error is None else shown(str(self.error))}>"
        )


class Sweep(Sequence[Member]):
    """The members of a sweep: a sequence of `Member`, the last key varying fastest.

        for member in sweep:
            print(member.values, member.error or member.run.drift)
    """

    def __init__(self, keys: Sequence[str], members: Sequence[Member]) -> None:
        self._keys = list(keys)
        self._members = list(members)

    @property
    def swept(self) -> list[str]:
        """The keys that were swept."""
        return list(self._keys)

    @property
    def runs(self) -> list[Run]:
        """The runs that came to their end."""
        return [member.run for member in self._members if member.error is None and member.run is not None]

    @property
    def errors(self) -> list[Member]:
        """The members that did not come to their end."""
        return [member for member in self._members if member.error is not None]

    @overload
    def __getitem__(self, index: int) -> Member:
        ...

    @overload
    def __getitem__(self, index: slice) -> "Sweep":
        ...

    def __getitem__(self, index: Any) -> Any:
        return Sweep(self._keys, self._members[index]) if isinstance(index, slice) else self._members[index]

    def __len__(self) -> int:
        return len(self._members)

    def __iter__(self) -> Iterator[Member]:
        return iter(self._members)

    @property
    def table(self) -> dict[str, list[Any]]:
        """A column for each of what a row of sweep.csv holds: member, the swept keys, status, message,
        steps, wall_seconds, drift_..., error_..., and the last row, last_.... A member that failed has None
        where it has nothing to tell.
        """
        rows = [self._row(member) for member in self._members]
        names = dict.fromkeys(itertools.chain.from_iterable(rows))
        return {name: [row.get(name) for row in rows] for name in names}

    def _row(self, member: Member) -> dict[str, Any]:
        row: dict[str, Any] = {"member": member.index, **{key: member.values.get(key) for key in self._keys}}
        row.update(
            status=member.status,
            message="" if member.error is None else str(member.error),
            steps=None,
            wall_seconds=None,
        )
        if member.error is None and member.run is not None:
            summary = member.run.summary
            row.update(steps=summary["steps"], wall_seconds=summary["wall_seconds"])
            for what in ("drift", "error"):
                row.update((f"{what}_{name}", value) for name, value in getattr(member.run, what).items())
            row.update(
                (f"last_{name}", float(x)) for name, x in zip(member.run.columns, member.run.table[-1])
            )
        return row

    def to_pandas(self) -> "pandas.DataFrame":
        """The table as a data frame, with the number of the member as its index."""
        return import_pandas("Sweep.to_pandas").DataFrame(self.table).set_index("member")

    def __repr__(self) -> str:
        failed = len(self.errors)
        told = f", {failed} failed" if failed else ""
        return f"<actio.Sweep of {', '.join(self._keys)}: {len(self)} members{told}>"

    def _repr_html_(self) -> str:
        columns = {
            name: values for name, values in self[:20].table.items() if name != "message" or any(values)
        }
        rest = f"<p>… {len(self) - 20} members more</p>" if len(self) > 20 else ""
        rows = list(zip(*columns.values()))
        return (
            "<div>"
            + table(list(columns), rows, f"{len(self)} members, {len(self.errors)} failed")
            + rest
            + "</div>"
        )


def _values_of(key: Any, values: Any) -> list[Any]:
    """What a key goes through."""
    if not isinstance(key, str):
        raise TypeError(
            f'over: the keys are texts such as "method.step", found {shown(key)}, of type {kind(key)}'
        )
    if isinstance(values, (str, bytes, Mapping)):
        raise TypeError(
            f"over: {key}: a list of values is expected, found {shown(values)}, of type {kind(values)}"
        )
    try:
        found = list(itertools.islice(values, MOST_MEMBERS + 1))
    except Exception as error:
        raise TypeError(
            f"over: {key}: a list of values is expected, found {shown(values)}: {shown(error)}"
        ) from None
    if not found:
        raise SceneError(f"over: {key}: the list of values is empty")
    return found


def _members(over: Any) -> tuple[list[str], list[dict[str, Any]]]:
    if not isinstance(over, Mapping):
        raise TypeError(
            f"over: a mapping of keys and lists of values is expected, found {shown(over)}, of type"
            f" {kind(over)}"
        )
    swept = {key: _values_of(key, values) for key, values in over.items()}
    if not swept:
        raise SceneError('over: no key is swept; one is needed, such as {"method.step": [0.1, 0.2]}')
    size = 1
    for values in swept.values():
        size *= len(values)
    if size > MOST_MEMBERS:
        raise SceneError(f"over: a sweep has at most {MOST_MEMBERS} members, and this one has more")
    return list(swept), [dict(zip(swept, values)) for values in itertools.product(*swept.values())]


def _default_jobs() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _checked_jobs(jobs: Any) -> int:
    if jobs is None:
        return _default_jobs()
    if isinstance(jobs, bool) or not isinstance(jobs, (int, numpy.integer)):
        raise TypeError(f"jobs: a whole number is expected, found {shown(jobs)}, of type {kind(jobs)}")
    if not 1 <= jobs <= 1000:
        raise ValueError(f"jobs: a number from 1 to 1000 is expected, found {shown(jobs)}")
    return int(jobs)


class _Crew:
    """Runs the members, a few at once, and says how far it is."""

    def __init__(
        self,
        source: Source,
        set_: list[tuple[bytes, bool]],
        members: list[dict[str, Any]],
        jobs: int,
        first_error_ends_it: bool,
    ) -> None:
        self.source, self.set = source, set_
        self.values = members
        self.inputs: dict[bytes, Any] = {}
        self.results: list[Optional[Member]] = [None] * len(members)
        self.stopped = threading.Event()
        self.jobs = jobs
        self.first_error_ends_it = first_error_ends_it

    def run_one(self, index: int) -> None:
        if self.stopped.is_set():
            return
        values = self.values[index]
        found: Optional[Run] = None
        try:
            found, error = outcome(
                self.source, self.set + changes(values, "over"), lambda fraction, t: self.stopped.is_set()
            )
            for path, mark in found._about["inputs"].items():
                if self.inputs.setdefault(path, mark) != mark:
                    error = SceneError(
                        f"{os.fsdecode(path)}: has changed since another member of the sweep was read with"
                        " it, and numbers from both are not joined"
                    )
            if error is None and found.summary["status"] != "done":
                error = Stopped("stopped before its end")
        except (Error, TypeError, ValueError) as raised:
            error = raised
        self.results[index] = Member(index, values, found, error)
        if error is not None and self.first_error_ends_it:
            self.stopped.set()

    def go(self, progress: Optional[Progress]) -> None:
        """Until all are done, or the function of the user says stop, or raises, or Ctrl-C comes."""
        ahead = iter(range(len(self.values)))
        with ThreadPoolExecutor(self.jobs, "actio-sweep") as pool:
            try:
                self._watch(pool, ahead, progress)
            finally:
                self.stopped.set()

    def _watch(self, pool: ThreadPoolExecutor, ahead: Iterator[int], progress: Optional[Progress]) -> None:
        going: set[Future[None]] = set()
        done = 0
        while True:
            for index in itertools.islice(ahead, 4 * self.jobs - len(going)):
                going.add(pool.submit(self.run_one, index))
            if not going:
                return
            ready, going = wait(going, 0.25, FIRST_COMPLETED)
            for future in ready:
                future.result()
            done += len(ready)
            if self.stopped.is_set():
                return
            if progress is not None and progress(done / len(self.values), done):
                return


def sweep(
    scene: Optional[SceneLike] = None,
    *,
    over: Mapping[str, Any],
    text: Optional[str] = None,
    set: Optional[Mapping[str, Any]] = None,
    jobs: Optional[int] = None,
    progress: Optional[Progress] = None,
    on_error: str = "collect",
    on_interrupt: str = "raise",
) -> Sweep:
    """Runs a scene once for each combination of values and returns the `Sweep`: a sequence of `Member`, the
    last key being the fastest. No file is written, and all runs are held in memory.

    scene, text, set: as of `run`.
    over: the keys that vary, each with the list of its values, {"method.step": [0.1, 0.2], "method.order":
        [2, 4]}. A value None takes the key out.
    jobs: how many members run at once; as many as there are processors where it is left out.
    progress: called with the fraction and the number of the members that are done, a few times a second and
        as they end. Where what it returns is true, the sweep ends there.
    on_error: "collect", what goes wrong with a member is its `error`; "raise", the first such error ends
        the sweep and is raised.
    on_interrupt: "raise", Ctrl-C raises KeyboardInterrupt; "return", what there is is returned.

    An exception that ends a sweep, KeyboardInterrupt included, has what there is as its attribute `sweep`.
    Members that were not run to their end then have the error `stopped before its end`.
    """
    checked_call(progress, "progress")
    checked_choice(on_interrupt, ("raise", "return"), "on_interrupt")
    checked_choice(on_error, ("collect", "raise"), "on_error")
    source, base = Source(scene, text, "sweep"), changes(set)
    keys, members = _members(over)
    warn_of_files(base)
    crew = _Crew(source, base, members, _checked_jobs(jobs), on_error == "raise")

    def found() -> Sweep:
        return Sweep(
            keys,
            [
                one or Member(k, crew.values[k], None, Stopped("stopped before its end"))
                for k, one in enumerate(crew.results)
            ],
        )

    try:
        crew.go(progress)
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt) and on_interrupt == "return":
            return found()
        attach(error, "sweep", found())
        raise
    out = found()
    if on_error == "raise":
        for member in out:
            if member.error is not None and not isinstance(member.error, Stopped):
                attach(member.error, "sweep", out)
                raise member.error
    return out
