#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a synthetic jaw: jaw.csv, contact elements along its row of teeth, and
jaw.nrrd, a volume as a scanner would give it, 0.5 mm from point to point.

  python3 data/jaw.py [FOLDER]

The teeth stand on a parabola and lean outwards; each has a crown of two or four
cusps, a dark canal, and roots in a bone with a canal of its own.
"""
import array
import math
import os
import sys

SIZE = (140, 116, 90)
STEP = 0.5
ORIGIN = (-34.75, -6.0, -22.0)
WIDTHS = (9, 9, 8, 6.5, 6.5, 7.5, 6, 7, 7, 6, 7.5, 6.5, 6.5, 8, 9, 9)
LEAN = 0.35


def arch(t):
    """The point at t, tangent and the direction outwards, of the row of teeth."""
    x, y = t, 45 - t * t / 21
    n = math.hypot(1, 2 * t / 21)
    d = (1 / n, -2 * t / 21 / n)
    return (x, y), d, (-d[1], d[0])


def row():
    """Parameters at equal distances along the arch, in mm, of -30 to 30."""
    at = [(-31.0, 0.0)]
    while at[-1][0] < 31:
        t, s = at[-1]
        at.append((t + 0.01, s + 0.01 * math.hypot(1, 2 * t / 21)))
    return at


def ruling(t):
    """Towards the roots: down, and inwards where teeth lean outwards."""
    _, _, out = arch(t)
    n = math.hypot(1, LEAN)
    return (-LEAN * out[0] / n, -LEAN * out[1] / n, -1 / n)


def tooth(s, centers):
    """The number of the tooth at an arc length, where in it, from -1 to 1."""
    for i, (c, w) in enumerate(centers):
        if abs(s - c) < w / 2:
            return i, 2 * (s - c) / w
    return -1, 0.0


def density(along, depth, off, centers):
    """What is at an arc length, a depth below the tips, a distance outwards."""
    i, u = tooth(along, centers)
    value = 0.0
    bone = 8 - depth + 0.6 * math.cos(along)
    if bone < 0 and abs(off) < 6 and depth < 26:
        value = 700 + 90 * math.sin(3.1 * along) * math.sin(2.7 * depth + off)
        if math.hypot(depth - 22, off) < 1.5:
            value = 120
    if i < 0:
        return value
    molar = WIDTHS[i] > 7.6
    cusp = 0.7 * math.cos((3 if molar else 1) * math.pi * u)
    narrow = 1 - 0.03 * max(0, depth - 6) if not molar else 1.0
    thick = (4.2 if molar else 3.2) * (1 - max(0, depth - 7) / 16)
    if depth < 0.8 - cusp or depth > 19 or abs(u) > 0.93 * narrow:
        return value
    if molar and depth > 11 and abs(u) < 0.06 * (depth - 11):
        return value
    if abs(off) > thick or abs(u) > 0.93 - 0.04 * max(0, depth - 9):
        return value
    canal = 0.12 if not molar else 0.1
    center = 0.5 if molar and depth > 9 else 0.0
    if depth > 4 and abs(abs(u) - center) < canal and abs(off) < 0.8:
        return 250.0
    edge = min(0.93 * narrow - abs(u), 1) * WIDTHS[i] / 2
    enamel = depth < 8 and (edge < 0.9 or depth < 2.4 - cusp or thick - abs(off) < 0.9)
    return 2400.0 if enamel else 1500.0


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(__file__) or "."
    at = row()
    middle = next(s for t, s in at if t >= 0)
    table = [(t, s - middle) for t, s in at]
    centers, c = [], -sum(WIDTHS) / 2
    for w in WIDTHS:
        centers.append((c + w / 2, w))
        c += w
    with open(os.path.join(folder, "jaw.csv"), "w") as f:
        f.write("x,y,z,rx,ry,rz,tx,ty,tz\n")
        for k in range(-6, 7):
            s = k * 8.5
            t = min(table, key=lambda p: abs(p[1] - s))[0]
            (x, y), d, _ = arch(t)
            f.write(",".join("%.12g" % v for v in (x, y, 0) + ruling(t) + d + (0,)))
            f.write("\n")
    voxels = array.array("h")
    for k in range(SIZE[2]):
        z = ORIGIN[2] + STEP * k
        for j in range(SIZE[1]):
            y = ORIGIN[1] + STEP * j
            for i in range(SIZE[0]):
                x = ORIGIN[0] + STEP * i
                # the nearest place of the arch, of those in a narrow window
                voxels.append(int(at_point(x, y, z, table, centers)))
    with open(os.path.join(folder, "jaw.nrrd"), "wb") as f:
        f.write(("NRRD0004\ntype: short\ndimension: 3\nspace dimension: 3\n"
                 "sizes: %d %d %d\n" % SIZE).encode())
        f.write(("space directions: (%g,0,0) (0,%g,0) (0,0,%g)\n"
                 "space origin: (%g,%g,%g)\n" % (STEP, STEP, STEP, *ORIGIN)).encode())
        f.write(("endian: %s\nencoding: raw\n\n" % sys.byteorder).encode())
        f.write(voxels.tobytes())


def at_point(x, y, z, table, centers):
    depth = -z * math.hypot(1, LEAN)
    if not -2 < depth < 28:
        return 0
    # foot on the arch of this depth: the row moved inwards by LEAN z
    best, t = 1e9, x
    for _ in range(12):
        (px, py), d, out = arch(max(-31.0, min(31.0, t)))
        px, py = px + LEAN * z * out[0], py + LEAN * z * out[1]
        t += 0.7 * ((x - px) * d[0] + (y - py) * d[1]) * d[0]
    t = max(-31.0, min(31.0, t))
    (px, py), d, out = arch(t)
    px, py = px + LEAN * z * out[0], py + LEAN * z * out[1]
    off = (x - px) * out[0] + (y - py) * out[1]
    if abs(off) > 7 or abs((x - px) * d[0] + (y - py) * d[1]) > 1:
        return 0
    return density(table[min(len(table) - 1, int((t + 31) * 100))][1], depth, off, centers)


if __name__ == "__main__":
    main()
