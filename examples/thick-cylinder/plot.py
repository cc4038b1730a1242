#!/usr/bin/python3
"""usage: plot.py PICTURE.png NAME=RESULTS...: draws stresses and displacement of the particles over the radius, and
Lamé's solution. Needs python3-matplotlib."""

import sys

import matplotlib

sys.dont_write_bytecode = True
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from lame import A, B, exact, last, particles  # noqa: E402

figure, (stress, moved) = plt.subplots(1, 2, figsize=(9.5, 4), dpi=80, layout="constrained")
for (name, folder), color, size in zip((a.split("=", 1) for a in sys.argv[2:]), ("#d95f02", "#1b9e77", "#386cb0"), (5, 3, 2)):
    r, radial, hoop, u = zip(*particles(last(folder)))
    mm = [1000 * x for x in r]
    stress.plot(mm, radial, "o", ms=size, color=color, label=name)
    stress.plot(mm, hoop, "o", ms=size, color=color)
    moved.plot(mm, [1e6 * x for x in u], "o", ms=size, color=color, label=name)
r = [A + (B - A) * i / 200 for i in range(201)]
mm = [1000 * x for x in r]
for k in 0, 1:
    stress.plot(mm, [exact(x)[k] for x in r], color="black", lw=1, label=None if k else "Lamé")
moved.plot(mm, [1e6 * exact(x)[2] for x in r], color="black", lw=1, label="Lamé")
stress.annotate("hoop", (30, 1000))
stress.annotate("radial", (30, -480))
stress.set(xlabel="radius [mm]", ylabel="stress [Pa]")
moved.set(xlabel="radius [mm]", ylabel="radial displacement [µm]")
for axes in stress, moved:
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3)
figure.savefig(sys.argv[1])
