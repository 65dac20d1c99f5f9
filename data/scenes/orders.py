"""How far the schemes of each order are from the exact motion of Apophis."""

import actio
import numpy

scene = "data/scenes/apophis.toml"
exact = actio.run(scene, set={"run.until": 100})
for order in [2, 4, 6, 8]:
    run = actio.run(scene, set={"run.until": 100, "method.order": order, "method.step": 0.5})
    error = numpy.linalg.norm(run["body_momentum"] - exact["body_momentum"], axis=1)
    print(f"order {order}: error {error.max():.0e}, drift of the energy {run.summary['drift']['energy']:.0e}")
