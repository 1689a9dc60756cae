# SPDX-License-Identifier: GPL-3.0-or-later
"""How often random data are solved, and how time grows with their size.

python3 bench/rates.py PHSPLINE [--members=N] [--seed=S] [--instructions]
                       [FAMILY]...

Solves N (20) random members of each family whose name contains a FAMILY (all),
for each of its sizes, and prints a row for each: how many were solved, the
median and the largest time, by how much twice the size multiplied the median,
what is warned of, and the first error.  `MISSED' ends the row of a family that
misses its target, and the exit status is 1 then:

  all      every member is solved
  first    each size is solved at least as often as the first
  grows    the median grows by at most 2.3 for each doubling, from each size to
           the next one that is at least twice as large, and over all sizes:
           between nearer ones the scatter of a median would count for more
  same=T   a member in radians and its twin in metres have control points that
           differ by at most T times the mean step
  node=T   the mean time is at most T microseconds a node
  worst=T  the largest time is at most T medians

Times are processor times of a run for each member, less that of a run for
nothing.  Where other work slows the machine they say little: with
--instructions they are millions of instructions as callgrind counts them, and
no target in microseconds is judged.  That takes 50 times as long.  All families
take an hour.
"""
import collections
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

GROWTH = 2.3
EARTH = 6371000.0


def norm(v):
    return math.sqrt(sum(c * c for c in v))


def unit(v):
    size = norm(v)
    return [c / size for c in v]


def gauss3(r, sigma=1.0):
    return [r.gauss(0, sigma) for _ in range(3)]


def plus(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]]


# ---- arclength ---------------------------------------------------------------


def walk(r, n):
    points = [gauss3(r)]
    for _ in range(n):
        points.append(plus(points[-1], gauss3(r)))
    return points


def smooth(r, n):
    """A curve of four waves in each coordinate, none of them short."""
    waves = [[(0.05 * r.gauss(0, 1), r.uniform(.02, .12), r.uniform(0, 6.28))
              for _ in range(4)] for _ in range(3)]
    return [[sum(a / w * math.sin(w * t + p) for a, w, p in waves[c]) +
             0.03 * c * t for c in range(3)] for t in range(n + 1)]


def ring(r, n):
    """A closed curve, a circle with waves."""
    waves = [(.1 * r.gauss(0, 1), r.randint(2, 7), r.uniform(0, 6.28))
             for _ in range(3)]
    turn = [2 * math.pi * i / n for i in range(n)]
    return [[n / 6 * math.cos(t), n / 6 * math.sin(t),
             n / 6 * sum(a * math.sin(k * t + p) for a, k, p in waves)]
            for t in turn]


def plane(points):
    return [p[:2] for p in points]


def given(points, lower=0.0, upper=0.0, r=None, **more):
    """Points with lengths from lower to upper times their chords."""
    problem = dict(points=points, **more)
    if lower:
        problem["lengths"] = [norm(plus(b, a, -1)) * r.uniform(lower, upper)
                              for a, b in zip(points, points[1:] + (
                                  points[:1] if problem.get("closed") else []))]
    return problem


def uneven(r, n, lower, upper, **more):
    """Chords of .003 to 1 and lengths from lower to upper times them."""
    points = [[0.0, 0.0, 0.0]]
    for _ in range(n):
        chord = 10 ** r.uniform(math.log10(.003), 0)
        points.append(plus(points[-1], unit(gauss3(r)), chord))
    return given(points, lower, upper, r, **more)


def ribbon(r, n, off=0.0, noise=0.0, **more):
    """Directions of n sensors of a smooth curve and lengths between them."""
    w = [r.uniform(.5, 1.5) for _ in range(3)]
    step = 4.0 / 200
    tangents = []
    for i in range(n):
        t = step * i
        v = [math.cos(w[0] * t), math.sin(2 * w[1] * t),
             1 + 0.3 * math.cos(3 * w[2] * t)]
        tangents.append(unit(plus(unit(v), gauss3(r, noise))))
    lengths = [1 + off * r.uniform(-1, 1) for _ in range(n - 1)]
    return dict(tangents=tangents, lengths=lengths, **more)


# ---- sphere ------------------------------------------------------------------


def from_plane(centre, xy):
    """Points of the tangent plane, moved onto the sphere."""
    e = unit(cross(centre, [0.3, -0.5, 0.8]))
    f = cross(centre, e)
    return [unit(plus(plus(centre, e, x), f, y)) for x, y in xy]


def sphere_walk(r, step, n=12):
    x = y = 0.0
    xy = []
    heading = r.uniform(0, 6.28)
    for _ in range(n):
        xy.append((x, y))
        heading += r.gauss(0, 1.6)
        x += step * math.cos(heading)
        y += step * math.sin(heading)
    return dict(points=from_plane(unit(gauss3(r)), xy))


def track(r, n, metres, share=1 / 3, **more):
    """A GPS track: steps of some metres, fixes off by a share of a step."""
    step, heading, x, y, xy = metres / EARTH, r.uniform(0, 6.28), 0.0, 0.0, []
    for _ in range(n):
        xy.append((x + r.gauss(0, share * step), y + r.gauss(0, share * step)))
        heading += r.gauss(0, 0.1)
        x += step * math.cos(heading)
        y += step * math.sin(heading)
    points = from_plane(unit([0.6, 0.2, 0.77]), xy)
    return dict(points=points, **more)


def twins(r, n):
    """A track as unit vectors, and the same times the earth's radius."""
    problem = track(r, n, 10)
    large = [[EARTH * c for c in p] for p in problem["points"]]
    return dict(problem, twin=dict(points=large, radius=EARTH))


def places(r, n, metres, noise):
    """A GPS track in degrees with seven digits, fixes off by some metres."""
    degrees = 180 / math.pi / EARTH
    lon, lat, heading, fixes = 11.5, 48.1, r.uniform(0, 6.28), []
    for _ in range(n):
        shrink = math.cos(math.radians(lat))
        fixes.append([round(lon + r.gauss(0, noise) * degrees / shrink, 7),
                      round(lat + r.gauss(0, noise) * degrees, 7)])
        heading += r.gauss(0, 0.1)
        lon += metres * math.cos(heading) * degrees / shrink
        lat += metres * math.sin(heading) * degrees
    return dict(lonlat=fixes, radius=EARTH)


def sphere_gauss(r, step, n=12):
    """A walk whose steps have normal components."""
    xy = [[step * c for c in p] for p in walk2(r, n)]
    return dict(points=from_plane(unit(gauss3(r)), xy))


def random_sphere(r, n):
    return dict(points=[unit(gauss3(r)) for _ in range(n)])


# ---- others ------------------------------------------------------------------


def walk2(r, n):
    points, x, y = [], 0.0, 0.0
    for _ in range(n):
        points.append([x, y])
        x += r.gauss(0, 1)
        y += r.gauss(0, 1)
    return points


def bezier(r, degree, **more):
    """A wavy Bezier curve, as wavy for each degree."""
    phase = r.uniform(0, 6.28)
    return dict(curve=[[i / degree, .2 * math.sin(20 * i / degree + phase)]
                       for i in range(degree + 1)], **more)


def mixed(r, _):
    """What is asked of spatial-hermite, in turn: data of any kind."""
    n = r.randrange(2, 10)
    kind = r.randrange(4)
    if kind == 0:
        points = walk(r, n)
    elif kind == 1:
        points = [gauss3(r) for _ in range(n + 1)]
    elif kind == 2:
        points = [[t, math.sin(t + r.gauss(0, .1)), math.cos(.7 * t)]
                  for t in range(n + 1)]
    else:
        points = [p + [0.0] for p in walk2(r, n + 1)]
    problem = dict(points=points)
    data = r.randrange(3)
    if data == 1:
        problem["tangents"] = [unit(gauss3(r)) for _ in points]
    elif data == 2:
        size = 10 ** r.uniform(-1, 1)
        problem["derivatives"] = [gauss3(r, size) for _ in points]
    if r.random() < .5:
        problem["basis"] = "atph"
    criterion = r.choice([None, "cc", "F1", "F2", "F3", "F3"])
    if criterion and (criterion != "cc" or "basis" not in problem):
        problem["criterion"] = criterion
    return problem


# ---- the families ------------------------------------------------------------

Family = collections.namedtuple("Family", "name command sizes make targets")
LONG = (99, 100, 150, 300, 500, 1000)
SENSORS = (200, 1000, 10000)
STEPS = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7)


def families():
    def add(name, command, sizes, make, *targets):
        rows.append(Family(name, command, sizes, make, targets))

    rows = []
    add("arclength walk free", "arclength", LONG,
        lambda r, n: given(walk(r, n)), "first", "grows")
    add("arclength walk", "arclength", LONG,
        lambda r, n: given(walk(r, n), 1.2, 1.6, r), "first", "grows")
    add("arclength smooth free", "arclength", LONG,
        lambda r, n: given(smooth(r, n)), "first", "grows")
    add("arclength cable", "arclength", LONG,
        lambda r, n: given(smooth(r, n), 1.01, 1.03, r), "first", "grows")
    add("arclength walk soft", "arclength", LONG,
        lambda r, n: given(walk(r, n), 1.2, 1.6, r, length_sigma=.1),
        "all", "grows")
    add("arclength cable soft", "arclength", LONG,
        lambda r, n: given(smooth(r, n), 1.01, 1.03, r, length_sigma=.01),
        "all", "grows")
    add("arclength plane walk", "arclength", LONG,
        lambda r, n: given(plane(walk(r, n)), 1.2, 1.6, r), "first", "grows")
    add("arclength plane cable", "arclength", LONG,
        lambda r, n: given(plane(smooth(r, n)), 1.01, 1.03, r), "first",
        "grows")
    add("arclength ring", "arclength", LONG,
        lambda r, n: given(ring(r, n), 1.01, 1.03, r, closed=True), "first")
    add("arclength uneven soft", "arclength", (3, 5, 7, 9),
        lambda r, n: uneven(r, n, 1.005, 1.02, length_sigma=.01), "all")
    for off in (0, .001, .01, .2):
        add(f"arclength ribbon {off}", "arclength", SENSORS,
            lambda r, n, off=off: ribbon(r, n, off), "all", "grows")
    add("arclength ribbon noise", "arclength", SENSORS,
        lambda r, n: ribbon(r, n, 0, 1e-3), "all", "grows")
    add("arclength ribbon sigma", "arclength", (200, 400, 800, 1600, 3200),
        lambda r, n: ribbon(r, n, .001, .05, tangent_sigma=.05),
        "all", "grows")
    add("arclength 8 points", "arclength", (1.0001, 1.001, 1.01),
        lambda r, f: given(walk(r, 7), f, f, r), "all")

    # what was refused, with other seeds
    add("hard walk lengths", "arclength", (100,),
        lambda r, n: given(walk(r, n), 1.4, 1.4, r), "all")
    add("hard walk free", "arclength", (100,),
        lambda r, n: given(walk(r, n)), "all")
    add("hard free", "arclength", (150,),
        lambda r, n: given(smooth(r, n)), "all")
    add("hard soft", "arclength", (150,),
        lambda r, n: given(smooth(r, n), 1.01, 1.03, r, length_sigma=.01),
        "all")
    add("hard ribbon", "arclength", (1000,),
        lambda r, n: ribbon(r, n, .01), "all")
    add("hard chord", "arclength", (7,),
        lambda r, n: given(walk(r, n), 1.001, 1.001, r), "all")
    for metres in (5, 10):
        add(f"hard gps{metres}", "sphere", (1000,),
            lambda r, n, m=metres: places(r, n, m, 2), "all")
    add("hard walk9", "sphere", (1e-3, 1e-4), sphere_gauss, "all")

    add("sphere walk", "sphere", STEPS, sphere_walk, "all")
    for metres in (1, 3, 10, 100, 1000):
        add(f"sphere track {metres} m", "sphere", (1000,),
            lambda r, n, m=metres: track(r, n, m), "all", "node=50")
    add("sphere track long", "sphere", (1000, 2000, 4000, 8000),
        lambda r, n: track(r, n, 10), "all", "grows", "node=50")
    add("sphere track fifth", "sphere", (1000,),
        lambda r, n: track(r, n, 10, .2), "all", "node=50")
    add("sphere unit", "sphere", (300,), twins, "all", "same=1e-6")
    add("sphere random", "sphere", (250, 500, 1000, 2000), random_sphere,
        "all", "grows")

    for basis in "atph", "ph":
        add(f"planar minimize {basis}", "planar", (20, 40, 80, 160),
            lambda r, n, basis=basis: dict(points=walk2(r, n), minimize="IES",
                                           basis=basis), "all", "grows")
    add("tc degree", "tc", (60, 120, 240, 480),
        lambda r, n: bezier(r, n, tolerance=1e-4), "all", "grows")
    add("tc pieces", "tc", (32, 64, 128, 256),
        lambda r, n: bezier(r, 60, pieces=n), "all", "grows")
    add("spatial-hermite mixed", "spatial-hermite", (2000,), mixed,
        "all", "worst=100")
    return rows


# ---- running them ------------------------------------------------------------


CALLGRIND = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]


def counted(messages):
    """The instructions that callgrind counted, in units of 10^9."""
    found = re.search(rb"Collected : (\d+)", messages)
    return int(found[1]) / 1e9


def run_one(command, text, counts=False):
    """A run's output and its processor time in seconds, or instructions."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as told:
        child = subprocess.Popen((CALLGRIND if counts else []) + command,
                                 stdin=subprocess.PIPE, stdout=out, stderr=told)
        child.stdin.write(text.encode())
        child.stdin.close()
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode not in (0, 1):
            sys.exit(f"{' '.join(command)}: status {child.returncode}")
        out.seek(0)
        told.seek(0)
        return out.read(), (counted(told.read()) if counts
                            else used.ru_utime + used.ru_stime)


def solve(program, command, problems, counts):
    """The results of problems, and the times that they took."""
    start = min(run_one([program, "--version"], "", counts)[1]
                for _ in range(1 if counts else 5))
    results, times = [], []
    for problem in problems:
        twin = problem.pop("twin", None)
        text, time = run_one([program, command, "--jobs=1", "--quiet"],
                             json.dumps(problem), counts)
        results.append(json.loads(text))
        times.append(max(time - start, 1e-5))
        if twin:
            text, _ = run_one([program, command, "--jobs=1", "--quiet"],
                              json.dumps(twin))
            results[-1]["apart"] = apart(results[-1], json.loads(text))
    return results, times


def apart(result, twin):
    """The largest distance of control points, by the mean step."""
    if result["status"] != "ok" or twin["status"] != "ok":
        return math.inf
    one, other = ([[c / x["radius"] for c in p] for segment in x["segments"]
                   for p in segment["control_points"]] for x in (result, twin))
    if len(one) != len(other):
        return math.inf
    step = result["length"] / result["radius"] / len(result["segments"])
    return max(norm(plus(p, q, -1)) for p, q in zip(one, other)) / step


def median(values):
    return sorted(values)[len(values) // 2] if values else math.nan


Row = collections.namedtuple("Row", "size members solved times apart")


def missed(family, rows, counts):
    """The targets that a family misses."""
    for target in family.targets:
        name, _, limit = target.partition("=")
        if name == "all":
            good = all(row.solved == row.members for row in rows)
        elif name == "first":
            good = all(row.solved >= rows[0].solved for row in rows)
        elif name == "grows":
            good = all(grown <= GROWTH for _, grown in growths(rows))
        elif name == "same":
            good = all(row.apart <= float(limit) for row in rows)
        elif name == "node":
            good = counts or all(
                1e6 * sum(row.times) / len(row.times) / row.size
                <= float(limit) for row in rows)
        else:
            good = all(max(row.times) <= float(limit) * median(row.times)
                       for row in rows)
        if not good:
            yield target


def per_doubling(small, large):
    ratio = median(large.times) / median(small.times)
    return ratio ** (1 / math.log2(large.size / small.size))


def growths(rows):
    """The size that each doubling ends at and its factor, all sizes last."""
    begin, found = rows[0], []
    for row in rows[1:]:
        if row.size >= 2 * begin.size:
            found.append((row.size, per_doubling(begin, row)))
            begin = row
    return found + [("all", per_doubling(rows[0], rows[-1]))]


def run_family(program, family, members, seed, counts):
    rows = []
    for size in family.sizes:
        r = random.Random(f"{family.name} {size} {seed}")
        # one record of each is not a family of latencies
        count = size if family.targets[-1].startswith("worst") else members
        results, times = solve(program, family.command,
                               [family.make(r, size) for _ in range(count)],
                               counts)
        errors = [x["error"]["code"] for x in results if x["status"] != "ok"]
        codes = collections.Counter(
            code for x in results
            for code in {w["code"] for w in x.get("warnings", [])})
        rows.append(Row(size, count, count - len(errors), times,
                        max((x.get("apart", 0) for x in results), default=0)))
        grown = ""
        if "grows" in family.targets and len(rows) > 1:
            grown = "".join(f"{g:.2f}" for at, g in growths(rows)
                            if at == size)
        print(f"{family.name:24} {size:7} {rows[-1].solved:5}/{count:<5}"
              f"{1e3 * median(times):9.2f} {1e3 * max(times, default=0):9.2f}"
              f" {grown:>5} ",
              ", ".join(sorted(set(errors))) +
              " ".join(f"{c}:{k}" for c, k in sorted(codes.items())),
              flush=True)
    bad = list(missed(family, rows, counts))
    if "same" in family.targets[-1]:
        print(f"{family.name:24} largest distance "
              f"{max(row.apart for row in rows):.2g} of a step")
    if len(rows) > 1 and "grows" in family.targets:
        print(f"{'':24} {'':7} {'':11}{'':9} {'':9} "
              f"{per_doubling(rows[0], rows[-1]):5.2f}  over all sizes")
    for target in bad:
        print(f"{family.name:24} MISSED: {target}", flush=True)
    return not bad


def main():
    options = dict(a[2:].partition("=")[::2] for a in sys.argv[2:]
                   if a.startswith("--"))
    counts = "instructions" in options
    wanted = [a for a in sys.argv[2:] if not a.startswith("--")] or [""]
    print(f"{'family':24} {'size':>7} {'solved':>11}{'median':>9} "
          f"{'most':>9} {'twice':>5}  errors and warnings; times are "
          + ("millions of instructions" if counts else "milliseconds"))
    chosen = [f for f in families() if any(w in f.name for w in wanted)]
    if not chosen:
        sys.exit("no such family")
    passed = [run_family(sys.argv[1], f, int(options.get("members", 20)),
                         int(options.get("seed", 1)), counts) for f in chosen]
    print(f"{sum(passed)} passed, {len(passed) - sum(passed)} failed")
    sys.exit(not all(passed))


main()
