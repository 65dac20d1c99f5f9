"""A long hull in still water: does it keep its course?"""

import actio
import numpy

# Hull and water together: sideways they are c times as heavy as ahead.
hull = actio.System(
    group="SE(2)",
    lagrangian=lambda xi, p: (xi.w**2 + xi.v1**2 + p.c * xi.v2**2) / 2,
    parameters={"c": 6},
)
print("lagrangian:", hull.formula)

wanted = {"until": 20, "every": 0.1, "step": 0.01, "order": 4}
wanted["quantities"] = ["configuration", "velocity", "energy"]
for course, velocity in [("bow first", [0, 1, 0.001]), ("broadside", [0, 0.001, 1])]:
    run = hull.run(velocity=velocity, **wanted)
    g = run["configuration"]  # 201 by 3 by 3
    heading = numpy.unwrap(numpy.arctan2(g[:, 1, 0], g[:, 0, 0]))
    turned = numpy.degrees(abs(heading).max())
    print(f"{course}: turned by {turned:.3g} degrees at most,", end=" ")
    print(f"drift of the energy {run.drift['energy']:.0e}")

# The same for other hulls: one scene, many values.
scene = hull.scene(velocity=[0, 1, 0.001], **wanted)
sweep = actio.sweep(scene, over={"system.parameters.c": [0.5, 1, 2, 6]})
for member in sweep:
    fastest = abs(member.run["velocity_w"]).max()
    print(member.values, f"fastest turn {fastest:.2g} per unit of time")
