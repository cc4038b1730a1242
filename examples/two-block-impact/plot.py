#!/usr/bin/python3
"""usage: plot.py SWEEP.csv PICTURE.png: draws the table of sweep.sh like Figs. 3 and 4 of the FMPM paper.
Needs python3-matplotlib."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

with open(sys.argv[1]) as file:
    rows = [row for row in csv.DictReader(file) if row["loss_percent"] != "failed"]
COLORS = {"0": "black", "1": "#999999", "2": "#d95f02", "4": "#1b9e77", "8": "#386cb0", "16": "#7b3294"}


def curve(x, **filters):
    points = [(float(r[x]), float(r["loss_percent"])) for r in rows if all(r[k] == v for k, v in filters.items())]
    return list(zip(*sorted(points))) or [(), ()]


def name(order):
    return "FLIP" if order == "0" else f"FMPM({order})"


figure, (cells, steps, orders) = plt.subplots(1, 3, figsize=(11, 3.9), dpi=80, layout="constrained")
for order, color in COLORS.items():
    cells.loglog(*curve("cell_mm", part="cell", cfl="1 us", order=order), "o-", ms=4, color=color, label=name(order))
    steps.loglog(*curve("cfl", part="step", variant="every", order=order), "o-", ms=4, color=color)
    steps.loglog(*curve("cfl", part="step", variant="periodic", order=order), "--", color=color)
cells.loglog([0.5, 5], [0.4, 4], ":", color="#cc0000", label="slope 1")
cells.set(title="cell size, step 1 µs", xlabel="cell [mm]", ylabel="energy loss [%]")
cells.set_ylim(0.25, 700)
cells.minorticks_off()
cells.set_xticks([0.5, 1, 2, 5], ["0.5", "1", "2", "5"])
cells.legend(fontsize=7, ncols=3, loc="upper center")
steps.set(title="step, cell 2 mm (dashed: every_cfl 0.2)", xlabel="CFL factor")
for number, shape in enumerate(("cpdi", "ugimp", "gimp", "b2spline", "b2gimp", "b2cpdi")):
    x, y = curve("order", part="shape", variant=shape)
    orders.semilogy(x[1:], y[1:], "o-", ms=4, color=f"C{number}", label=shape)
    orders.axhline(y[0], color=f"C{number}", lw=0.7, ls="-.")
orders.semilogy(*curve("order", part="order", variant="xpic-start"), "s-", ms=3, color="black", label="XPIC, cpdi")
orders.set(title="order, cell 1 mm, CFL 0.2 (dash-dotted: FLIP)", xlabel="order k", ylim=(0.25, 6))
orders.set_yticks([0.3, 0.5, 1, 2, 5], ["0.3", "0.5", "1", "2", "5"])
orders.set_xticks([2, 4, 6, 8, 12, 16])
orders.legend(fontsize=7)
for axes in (cells, steps, orders):
    axes.title.set_fontsize(9)
    axes.grid(alpha=0.3)
figure.savefig(sys.argv[2])
