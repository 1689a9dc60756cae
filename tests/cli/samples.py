# SPDX-License-Identifier: GPL-3.0-or-later
"""What samples of a patch, and of what is beside it, say of it.

    python3 samples.py FILE.csv DISTANCE

The table has the samples of one patch, then those at the distance from it.
Fails unless these are at the distance along the normals, and curvatures are
those of differences of points and normals of the fourth order.
"""
import csv
import math
import sys


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def change(a, b, c, d):
    """By the values at -2, -1, 1, 2."""
    return [(8 * (r - q) - (s - p)) / 12 for p, q, r, s in zip(a, b, c, d)]


def check(grid, n):
    worst = 0.0
    for j in range(2, n - 2):
        for i in range(2, n - 2):
            u = change(*(grid[j * n + i + k] for k in (-2, -1, 1, 2)))
            v = change(*(grid[(j + k) * n + i] for k in (-2, -1, 1, 2)))
            e, f, g = dot(u[:3], u[:3]), dot(u[:3], v[:3]), dot(v[:3], v[:3])
            l, m = -dot(u[:3], u[3:6]), -dot(u[:3], v[3:6])
            k = -dot(v[:3], v[3:6])
            det = e * g - f * f
            gauss, mean = grid[j * n + i][6:8]
            worst = max(worst, abs((l * k - m * m) / det - gauss),
                        abs((e * k - 2 * f * m + g * l) / det / 2 - mean))
    assert worst < 5e-4, worst


def main():
    distance = float(sys.argv[2])
    on, beside = [], []
    for row in csv.DictReader(open(sys.argv[1], encoding="ascii")):
        (beside if float(row["distance"]) else on).append(
            [float(row[k]) for k in "x y z nx ny nz gauss mean k1 k2".split()])
    for a, b in zip(on, beside):
        assert max(abs(y - x - distance * n) for x, n, y in
                   zip(a[:3], a[3:6], b[:3])) < 1e-14
        assert a[3:6] == b[3:6]
    n = math.isqrt(len(on))
    check(on, n)
    check(beside, n)


main()
