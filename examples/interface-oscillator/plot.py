#!/usr/bin/python3
"""usage: plot.py PICTURE.png RESULTS: draws displacement and energies of the block on its interfaces, and the closed form.
Needs python3-matplotlib."""

import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

V, D_T, AREA, MASS = 0.01, 200e6, 2.0, 2.0 * 0.4 * 1000  # the scene's; two interfaces of 2 m²
OMEGA = math.sqrt(2 * D_T * AREA / MASS)

folder = sys.argv[2]
with open(folder + "/bodies.csv") as file:
    block = [row for row in csv.DictReader(file) if row["body"] == "block"]
with open(folder + "/history.csv") as file:
    history = list(csv.DictReader(file))
t = [float(row["time"]) for row in block]
x = [float(row["x"]) - 1 for row in block]
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.4), dpi=80, layout="constrained")
ms = [1e3 * s for s in t]
left.plot(ms, [1e6 * V / OMEGA * math.sin(OMEGA * s) for s in t], color="black", lw=1, label="v/ω sin ωt")
left.plot(ms[::6], [1e6 * d for d in x[::6]], "o", ms=3, color="#d95f02", label="abut")
left.set(xlabel="time [ms]", ylabel="displacement [µm]")
kinetic = [float(row["kinetic_energy"]) for row in history]
springs = [float(row["interface_energy"]) for row in history]
right.plot(ms, [1e3 * e for e in kinetic], color="#386cb0", label="kinetic")
right.plot(ms, [1e3 * e for e in springs], color="#d95f02", label="in the springs")
right.plot(ms, [1e3 * (a + b) for a, b in zip(kinetic, springs)], color="black", lw=1, label="together")
right.set(xlabel="time [ms]", ylabel="energy [mJ]", ylim=(0, None))
for axes in left, right:
    axes.legend(fontsize=8, loc="upper right")
    axes.grid(alpha=0.3)
figure.savefig(sys.argv[1])
