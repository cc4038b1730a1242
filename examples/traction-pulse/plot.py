#!/usr/bin/python3
"""usage: plot.py PICTURE.png NAME=RESULTS...: draws the stress along the bar at the end of runs, like Fig. 6B of the
FMPM paper. Needs python3-matplotlib."""

import sys

import matplotlib

sys.dont_write_bytecode = True
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from error import PEAK, profile  # noqa: E402

figure, axes = plt.subplots(figsize=(8.5, 5), dpi=80, layout="constrained")
insets = [(axes.inset_axes([0.05, 0.53, 0.3, 0.42]), (92, 108), (430, 505)),
          (axes.inset_axes([0.69, 0.5, 0.3, 0.42]), (38, 58), (-20, 60))]
theory = [0, 50, 100, 150, 198], [0, 0, PEAK, 0, 0]
for name, folder in (argument.split("=", 1) for argument in sys.argv[2:]):
    # The rows of particles are the same; one point for each place.
    x, stress = zip(*sorted({round(1000 * x, 4): s for x, s in zip(*profile(folder))}.items()))
    for plot in [axes] + [inset[0] for inset in insets]:
        plot.plot(x, stress, lw=1.2, label=name)
for plot in [axes] + [inset[0] for inset in insets]:
    plot.plot(*theory, ":", color="black", label="theory")
    plot.grid(alpha=0.3)
for inset, x, y in insets:
    inset.set(xlim=x, ylim=y)
    inset.tick_params(labelsize=7)
axes.set(xlabel="x [mm]", ylabel="stress xx [Pa]", title="after 1.5 ms, cells of 1 mm", xlim=(-70, 270), xticks=range(0, 201, 50))
axes.legend(loc="lower left", fontsize=8)
figure.savefig(sys.argv[1])
