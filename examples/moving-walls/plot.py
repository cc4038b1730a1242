#!/usr/bin/python3
"""usage: plot.py SWEEP.csv PICTURE.png: draws the table of sweep.sh like Fig. 7 of the FMPM paper.
Needs python3-matplotlib."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

with open(sys.argv[1]) as file:
    rows = [row for row in csv.DictReader(file) if row["error_percent"] != "failed"]


def curve(method, conditions="combined"):
    points = [(float(r["depth"]), float(r["error_percent"])) for r in rows
              if r["method"] == method and r["conditions"] == conditions]
    return list(zip(*points)) or [(), ()]


figure, (walls, pic) = plt.subplots(1, 2, figsize=(10, 4.6), dpi=80, layout="constrained")
walls.semilogy(*curve("flip"), "o-", ms=3, lw=2.5, color="black", label="FLIP")
walls.semilogy(*curve("fmpm-1"), "o-", ms=3, lw=2.5, color="#999999", label="FMPM(1)")
for k, color in ("2", "#d95f02"), ("4", "#1b9e77"), ("8", "#386cb0"):
    for conditions, line in ("combined", "-"), ("velocity", ":"), ("lumped", "--"):
        walls.semilogy(*curve(f"fmpm-{k}", conditions), "o" + line, ms=3, color=color,
                       label=f"FMPM({k})" if line == "-" else None)
walls.semilogy(*curve("fmpm-2-b2cpdi"), "s-", ms=3, color="#7b3294", label="FMPM(2), b2cpdi")
walls.set_title("conditions: solid combined, dotted velocity, dashed lumped", fontsize=9)
for method, name in ("flip", "FLIP"), ("fmpm-1", "FMPM(1)"), ("xpic-1", "XPIC(1)"), ("pic", "PIC"):
    pic.semilogy(*curve(method), "o--" if name == "PIC" else "o-", ms=3, label=name)
pic.set_title("particle-in-cell methods", fontsize=9)
for axes in walls, pic:
    axes.set(xlabel="depth of the walls [cells]", ylabel="velocity error [%]", ylim=(1e-3, 1e3))
    axes.legend(fontsize=7)
    axes.grid(alpha=0.3)
figure.savefig(sys.argv[2])
