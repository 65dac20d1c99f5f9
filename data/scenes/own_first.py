import actio
hull = actio.System("SE(2)", lambda xi: (xi.w**2 + xi.v1**2 + 6 * xi.v2**2) / 2)
run = hull.run(velocity=[0.1, 1, 0], until=20, every=0.1,
               quantities=["configuration", "spatial_momentum"])
print("it ends at", run["configuration"][-1, :2, 2].round(3))
print(f"its impulse has changed by {run.drift['spatial_momentum_v1']:.0e} of itself")
