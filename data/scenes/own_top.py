"""A heavy top from its Lagrangian, and the same top as the library has it."""

import actio
import numpy

mass, arm = 0.1, numpy.array([0, 0, 0.03])
inertia = numpy.diag([4e-5, 4e-5, 6e-5])  # about the centre of mass
inertia += mass * (arm @ arm * numpy.eye(3) - numpy.outer(arm, arm))

top = actio.System(
    group="SO(3)",
    lagrangian=lambda w, p, a: w @ inertia @ w / 2 + mass * a.gravity @ arm,
    advected={"gravity": [0, 0, -9.81]},  # in space; in the body it is a.gravity
)
print("lagrangian:", top.formula)

c, s = numpy.cos(numpy.radians(30)), numpy.sin(numpy.radians(30))
run = top.run(
    velocity=[0, 0, 150],
    configuration=[[1, 0, 0], [0, c, -s], [0, s, c]],
    until=0.5,
    every=0.005,
    step=1e-4,
    order=4,
    quantities=["gravity", "energy", "casimir"],
)
print(*run.summary["remarks"], sep="; ")
print("drift:", ", ".join(f"{name} {drift:.0e}" for name, drift in run.drift.items()))

changed = {"run.until": 0.5, "method.step": 1e-4}
known = actio.run("data/scenes/nodding_top.toml", set=changed)
difference = abs(run["gravity"] / 9.81 - known["direction_of_gravity"]).max()
print(f"directions of gravity differ by {difference:.0e} from those of heavy_top")
