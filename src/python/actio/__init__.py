"""Mechanics on Lie groups, step by step, from one action principle.

    import actio

    run = actio.run("apophis.toml", set={"method.order": 4})
    run["body_momentum"]                    # a NumPy array, one row for each time
    actio.load("apophis")                   # the run that the command has left in a folder
    actio.sweep("apophis.toml", over={"method.step": [0.1, 0.2]})
    actio.System("SO(3)", lambda w: w[0]**2 + 2*w[1]**2 + 3*w[2]**2)    # a system of one's own

`run`, `load` and `sweep` make runs, and so does `System.run`; `systems`, `quantities`, `bodies` and `groups`
tell what there is. `moments` are those of the mass within a surface. `sin`, `cos`, ... are functions for
Lagrangians.
"""

try:
    import numpy as _numpy  # noqa: F401
except ImportError as _error:
    raise ImportError(
        "actio needs NumPy, which this interpreter does not have (Debian: python3-numpy, for"
        " /usr/bin/python3)"
    ) from _error

from actio._errors import Error, FileError, NumericsError, SceneError, Stopped
from actio._functions import (
    acos,
    acosh,
    asin,
    asinh,
    atan,
    atan2,
    atanh,
    cbrt,
    cos,
    cosh,
    exp,
    hypot,
    log,
    log2,
    log10,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)
from actio._moments import moments
from actio._registry import bodies, groups, quantities, systems
from actio._run import Run
from actio._snapshots import Snapshots
from actio._running import load, run
from actio._sweep import Member, Sweep, sweep
from actio._system import Scene, System
from actio._actio import version as __version__

__all__ = [
    "Error",
    "FileError",
    "Member",
    "NumericsError",
    "Run",
    "Scene",
    "SceneError",
    "Snapshots",
    "Stopped",
    "Sweep",
    "System",
    "acos",
    "acosh",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "bodies",
    "cbrt",
    "cos",
    "cosh",
    "exp",
    "groups",
    "hypot",
    "load",
    "log",
    "log10",
    "log2",
    "moments",
    "quantities",
    "run",
    "sin",
    "sinh",
    "sqrt",
    "sweep",
    "systems",
    "tan",
    "tanh",
    "__version__",
]
