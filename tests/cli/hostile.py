# SPDX-License-Identifier: GPL-3.0-or-later
"""Families of plane points that are hard for splines.

python3 hostile.py NAME COUNT SEED    problems of a family, a line each
python3 hostile.py names              the families
python3 hostile.py judge OURS OTHER   of two files of results for the same
    problems: how many, failed, the geometric mean of energy times length over
    that of the other, how many are worse by a tenth, and the largest jump of
    the curvature
python3 hostile.py table NAME ONE TWO ...   a line: of the results of the same
    problems, how many solve all of them, and the geometric means of energy times
    length over that of the last one
python3 hostile.py jump RESULTS   how many closed curves, and the largest jump of
    the curvature where no joint is told, over the largest curvature at a joint:
    from the control points, (2/3) (d0 x d1) / |d0|^3
"""
import cmath
import json
import math
import random
import sys


def along(lengths, angles):
    """The points of a polygon with these sides and directions."""
    points = [0j]
    for length, angle in zip(lengths, angles):
        points.append(points[-1] + cmath.rect(length, angle))
    return points


def sums(values):
    total, out = 0, []
    for v in values:
        total += v
        out.append(total)
    return out


def uneven_lengths(r, n, decades):
    return [10 ** r.uniform(-decades, 0) for _ in range(n)]


def randoms(r):
    n = r.randrange(4, 40)
    return [complex(r.random(), r.random()) for _ in range(n)], r.random() < .5


def walk(r):
    n = r.randrange(5, 80)
    return sums(complex(r.gauss(0, 1), r.gauss(0, 1))
                for _ in range(n)), r.random() < .5


def lattice(r, size):
    while True:
        p = [complex(r.randrange(size), r.randrange(size))
             for _ in range(r.randrange(4, 35))]
        p = [q for i, q in enumerate(p) if i == 0 or q != p[i - 1]]
        if all(abs(cmath.phase((b - a).conjugate() * (c - b))) < 3.1415
               for a, b, c in zip(p, p[1:], p[2:])):
            return p, False


def coarse(r):
    return lattice(r, 6)


def grid(r):
    return lattice(r, 30)


def bent(r):
    n = r.randrange(3, 60)
    most = r.choice([.5, 1.5, 3.1])
    return along(uneven_lengths(r, n + 1, r.uniform(0, 6)),
                 sums(r.uniform(.01, most) for _ in range(n))), False


def noisy(r):
    n, s = r.randrange(20, 300), 10 ** r.uniform(-4, -1)
    return [complex(i / n + r.gauss(0, s), .3 * math.sin(6 * i / n) +
                    r.gauss(0, s)) for i in range(n)], False


def zigzag(r):
    n, step, high = r.randrange(4, 60), r.uniform(.05, 1), r.uniform(.2, 2)
    return [complex(i * step, i % 2 * high + r.gauss(0, .05))
            for i in range(n)], False


def spiral(r):
    t = sorted(r.uniform(0, 12) for _ in range(r.randrange(8, 120)))
    return [cmath.rect(x + i * 1e-3, x + i * 1e-3) for i, x in enumerate(t)
            if i > 0], False


def wavy(r, n, k, size):
    waves = [(r.gauss(0, 1) * size(j), j, r.uniform(0, 6)) for j in range(2, k)]
    t = [2 * math.pi * i / n for i in range(n)]
    return [(1 + sum(a * math.cos(j * x + p) for a, j, p in waves)) *
            cmath.exp(1j * x) for x in t]


def track(r):
    z = wavy(r, r.randrange(20, 200), 7, lambda j: .25 / j)
    return [complex(2 * p.real, p.imag) for p in z], True


def coast(r):
    n = r.randrange(20, 150)
    return wavy(r, n, n // 3, lambda j: .15 * j ** -1.2), True


def straight(r):
    z, angle, out = 0j, 0, []
    for _ in range(r.randrange(3, 8)):
        for turns in (0,) * r.randrange(1, 5) + (1,) * r.randrange(2, 6):
            angle += turns * r.uniform(-.8, .8)
            z += cmath.rect(r.uniform(.5, 2), angle)
            out.append(z)
    return out, False


def sharp(r):
    n = r.randrange(5, 40)
    return along([r.uniform(.5, 2) for _ in range(n)],
                 sums(r.choice([-1, 1]) * r.uniform(1.5, 3.1)
                      for _ in range(n))), False


def uneven(r):
    n, s = r.randrange(5, 60), r.choice([.5, 1])
    return along(uneven_lengths(r, n, 3),
                 sums(r.gauss(0, s) for _ in range(n))), False


def very_uneven(r):
    n = r.randrange(6, 60)
    return along(uneven_lengths(r, n, 6), sums(
        r.uniform(-3.05, 3.05) for _ in range(n))), r.random() < .5


def near(r):
    points, closed = r.choice([walk, randoms])(r)
    out = []
    for p in points:
        out.append(p)
        if r.random() < .2:
            out.append(p + cmath.rect(10 ** r.uniform(-9, -3),
                                      r.uniform(0, 6.28)))
    return out, closed


def convex(r):
    """3 to 1000 points, turns to 3.1, chords to 1e6:1; or on an ellipse."""
    n = int(math.exp(r.uniform(math.log(3), math.log(1000))))
    if r.random() < .5:
        aspect = 10 ** r.uniform(-2, 0)
        t = sorted(r.uniform(0, 2 * math.pi) for _ in range(n))
        t = [b for a, b in zip([-1] + t, t) if b - a > 1e-5]
        t = t if len(t) > 2 else [0, 2, 4]
        return [complex(math.cos(x), aspect * math.sin(x)) for x in t], True
    most = r.choice([.1, .5, 1.5, 3.1])
    return along(uneven_lengths(r, n, r.choice([0, 1, 3, 6])), sums(
        r.uniform(1e-3, most) for _ in range(n)))[:max(n, 3)], False


def mixed(r):
    n = int(math.exp(r.uniform(math.log(3), math.log(1000))))
    most = r.choice([.3, 1, 2, 3.1])
    return along(uneven_lengths(r, n, r.choice([0, 1, 3])), sums(
        r.uniform(-most, most) for _ in range(n))), r.random() < .5


FAMILIES = (randoms, walk, coarse, grid, bent, noisy, zigzag, spiral, track,
            coast, straight, sharp, uneven, very_uneven, near)


def problems(name, count, seed):
    r = random.Random(f"{name} {seed}")
    for i in range(count):
        points, closed = globals()[name](r)
        print(json.dumps({"id": f"{name} {i}", "closed": closed,
                          "points": [[p.real, p.imag] for p in points]}))


def product(d):
    return d["diagnostics"]["energy"] * d["length"]


def judge(ours, others):
    failed, worse, logs, jump, pairs = 0, 0, [], 0, 0
    for line, other in zip(open(ours), open(others)):
        d, o = json.loads(line), json.loads(other)
        if d["status"] != "ok":
            failed += 1
            continue
        jump = max(jump, d["diagnostics"]["g2_error"])
        pairs += any(j["kind"] == "pair" for j in d.get("joints", []))
        if o["status"] == "ok" and product(o) > 0:
            ratio = product(d) / product(o)
            worse += not ratio <= 1.1 + 1e-9
            logs.append(math.log(ratio))
    mean = math.exp(sum(logs) / len(logs)) if logs else math.nan
    print(f"{len(logs)} {failed} {mean:.3g} {worse} {jump:.1e} {pairs}")


def table(name, files):
    sets = [[json.loads(line) for line in open(file)] for file in files]
    good = [r for r in zip(*sets)
            if all(d["status"] == "ok" and product(d) > 0 for d in r)]
    means = [math.exp(sum(math.log(product(r[i]) / product(r[-1]))
                          for r in good) / len(good))
             for i in range(len(files) - 1)]
    print(f"{name:<12}{len(good):>5}" + "".join(f"{m:>10.2g}" for m in means))


def jumps(name):
    n, largest = 0, 0
    for line in open(name):
        d = json.loads(line)
        if d["status"] != "ok" or not d["closed"]:
            continue
        n += 1
        legs = [[complex(*b) - complex(*a) for a, b in zip(p, p[1:])]
                for p in (s["control_points"] for s in d["segments"])]
        start = [2 / 3 * (a.conjugate() * b).imag / abs(a) ** 3
                 for a, b, _ in legs]
        end = [2 / 3 * (b.conjugate() * c).imag / abs(c) ** 3
               for _, b, c in legs]
        told = {j["segment"] for j in d.get("joints", [])}
        most = max(map(abs, start + end))
        largest = max([largest] + [abs(start[i] - end[i - 1]) / most
                                   for i in range(len(legs)) if i not in told])
    print(n, f"{largest:.1e}")


if sys.argv[1] == "names":
    print(" ".join(f.__name__ for f in FAMILIES))
elif sys.argv[1] == "table":
    table(sys.argv[2], sys.argv[3:])
elif sys.argv[1] == "jump":
    jumps(sys.argv[2])
elif sys.argv[1] == "judge":
    judge(sys.argv[2], sys.argv[3])
else:
    problems(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
