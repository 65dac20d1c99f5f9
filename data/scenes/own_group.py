"""Straight lines of Sol, one of Thurston's eight geometries, from its matrices."""

import actio
import numpy

stretch = numpy.diag([1.0, -1.0, 0.0])
along_x, along_y = numpy.zeros((2, 3, 3))
along_x[0, 2] = along_y[1, 2] = 1

sol = actio.System(group=[stretch, along_x, along_y], lagrangian=lambda xi: xi @ xi / 2)
print(sol.components, sol.formula)

run = sol.run(
    velocity=[0.1, 1, 0.9],
    until=40,
    every=0.5,
    step=0.02,
    order=6,
    quantities=[
        "configuration",
        "casimir",
        "energy",
        "tangent_map",
        "poisson_defect",
        "symplectic_defect",
    ],
)
print(*run.summary["remarks"])
print(f"drifts: energy {run.drift['energy']:.0e}, Casimir {run.drift['casimir_1']:.0e}")
for defect in ["poisson_defect", "symplectic_defect"]:
    print(f"{defect}: {run[defect].max():.0e} at most")
# How far apart momenta come that begin close to each other: the norm of 81 matrices.
spread = numpy.linalg.norm(run["tangent_map"], 2, axis=(1, 2))
for k in [0, 20, 40, 80]:
    x, y = run["configuration"][k, :2, 2]
    print(f"t = {run.t[k]:2g}: at ({x:.3f}, {y:.3f}),", end=" ")
    print(f"momenta are {spread[k]:.3g} times as far apart")
