# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 bench/knots.py PHSPLINE: what the rules for knots make of chords that
alternate.

Walks of 12 chords, 1 and 1/q in turn, which turn by angles of a standard
deviation: 100 for each q and deviation.  For each rule the lengths of the curves
over those of the polygons, median and largest; IES over that of chordal knots,
median; and how many have a lower IES than with these.
"""
import json
import math
import random
import subprocess
import sys

RULES = "chordal", "centripetal", "uniform"


def solve(problems, rule):
    run = subprocess.run([sys.argv[1], "planar", "-q", f"--knots={rule}"],
                         input="\n".join(map(json.dumps, problems)), text=True,
                         stdout=subprocess.PIPE, check=True)
    return [json.loads(line) for line in run.stdout.splitlines()]


def walk(r, q, turn):
    heading, points = r.uniform(0, 6.28), [[0, 0]]
    for k in range(12):
        size, (x, y) = 1 / q if k % 2 else 1, points[-1]
        points.append([x + size * math.cos(heading),
                       y + size * math.sin(heading)])
        heading += r.gauss(0, turn)
    return points


def median(values):
    return sorted(values)[len(values) // 2]


print("   q turn rule         length   most       IES  lower")
for q in 1, 3, 10, 30:
    for turn in .3, 1.0:
        r = random.Random(f"{q}{turn}")
        walks = [walk(r, q, turn) for _ in range(100)]
        polygons = [sum(map(math.dist, p, p[1:])) for p in walks]
        for rule in RULES:
            found = solve([dict(points=p) for p in walks], rule)
            IES = [x["diagnostics"]["IES"] for x in found]
            base = IES if rule == "chordal" else base
            lengths = [x["length"] / p for x, p in zip(found, polygons)]
            ratios = [a / b for a, b in zip(IES, base)]
            print(f"{q:4} {turn:4} {rule:11} {median(lengths):7.3f} "
                  f"{max(lengths):6.2f} {median(ratios):9.3g} "
                  f"{sum(x < .999 for x in ratios):6}")
