# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of random contact elements, through `phspline cone` and by itself.

    cone_pairs.py PHSPLINE PAIRS SEED

Every strip that is printed is followed by rotations of its frame, to the next
strip and to the second element: all within 1e-10.  Every refusal is confirmed:

  saddle, parallel planes, elements turned back
           pairs of biarcs are fitted, their contact points and their first leg
           being free, from many starts: none meets the second element
  legs     no equal legs meet, of any length
  rounding the pair is found in 64 binary digits: an arc is less than 1e-4 of
           the coordinates
"""

import re
import subprocess
import sys
from collections import Counter

import numpy as np

KINDS = {"any": 0.86, "near": 0.06, "cone": 0.02, "slope": 0.02,
         "cylinder": 0.01, "saddle": 0.0075, "planes": 0.0075,
         "reversed": 0.0075, "behind": 0.0075}
SAYS = {"saddle": "those of a saddle", "planes": "tangent planes are parallel",
        "reversed": "turned by 180 degrees", "behind": "with such legs"}
LIMIT = 1e-10


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def cross_angle(v, w, angle):
    """v turned about the unit vectors w."""
    c, s = np.cos(angle)[:, None], np.sin(angle)[:, None]
    along = np.sum(v * w, axis=1)[:, None]
    return c * v + s * np.cross(w, v) + (1 - c) * along * w


def frames(rng, n):
    e = unit(rng.normal(size=(n, 3)))
    d = rng.normal(size=(n, 3))
    return e, unit(d - np.sum(d * e, axis=1)[:, None] * e)


def elements(rng, n):
    """Points, rulings and tangents, [n][2][3] each, and the kinds."""
    kind = rng.choice(list(KINDS), size=n, p=list(KINDS.values()))
    p = rng.uniform(-10, 10, size=(n, 2, 3))
    e, d = np.empty((n, 2, 3)), np.empty((n, 2, 3))
    for j in range(2):
        e[:, j], d[:, j] = frames(rng, n)
    for i in np.flatnonzero(kind != "any"):
        p[i], e[i], d[i] = special(rng, kind[i], p[i], e[i], d[i])
    e = unit(e)
    d = unit(d - np.sum(d * e, axis=2)[..., None] * e)
    return kind, p, e, d


def special(rng, kind, p, e, d):
    e1, d1, n1 = e[0], d[0], np.cross(e[0], d[0])
    if kind == "near":
        step = 10 ** rng.uniform(-4, -0.5)
        w = rng.uniform(-step, step, 3)
        e2 = unit(e1 + np.cross(w, e1))
        d2 = d1 + np.cross(w, d1)
        p2 = p[0] + 10 * step * d1 + rng.uniform(-step, step, 3)
    elif kind in ("cone", "cylinder"):
        k = rng.uniform(-1, 1) if kind == "cone" else 0
        kn, s = rng.uniform(-1, 1), rng.uniform(0.1, 2)
        K = np.hypot(k, kn)
        bend = k * e1 + kn * n1
        way = np.sin(K * s) / K * d1 + (1 - np.cos(K * s)) / K**2 * bend
        e2, d2 = e1 - k * way, np.cos(K * s) * d1 + np.sin(K * s) / K * bend
        p2 = p[0] + way + rng.uniform(-1, 1) * e2
    elif kind == "slope":
        pitch, t = rng.uniform(0.2, 2), rng.uniform(0, 6)
        f = lambda t: (np.array([np.cos(t), np.sin(t), pitch * t]),
                       unit(np.array([-np.sin(t), np.cos(t), pitch])),
                       np.array([-np.cos(t), -np.sin(t), 0]))
        (a, e1, d1), (b, e2, d2) = f(t), f(t + rng.uniform(0.05, 1))
        return np.array([a + 2 * e1, b + 2 * e2]), np.array([e1, e2]), \
            np.array([d1, d2])
    elif kind == "saddle":
        angle = rng.uniform(0.1, 3) * rng.choice([-1, 1])
        e2, d2 = np.cos(angle) * e1 + np.sin(angle) * n1, d1
        p2 = p[0] + rng.uniform(0.1, 5) * d1 + rng.uniform(-3, 3) * e2
    elif kind == "planes":
        angle = rng.uniform(0.1, 3)
        e2 = np.cos(angle) * e1 + np.sin(angle) * d1
        d2 = np.cos(angle) * d1 - np.sin(angle) * e1
        p2 = p[0] + rng.uniform(-5, 5, 3) + 10 * n1
    elif kind == "reversed":
        e2, d2, p2 = -e1, -d1, p[1]
    else:  # behind
        e2, d2 = e1, d1
        p2 = p[0] - rng.uniform(0.1, 5) * d1 + rng.uniform(-1, 1) * n1
    return np.array([p[0], p2]), np.array([e1, e2]), np.array([d1, unit(d2)])


# ---- what is printed ---------------------------------------------------------


def solve(program, p, e, d):
    """Rows of strips by pair, and messages of refusals."""
    lines = []
    v = np.concatenate([p, e, d], axis=2).reshape(-1, 9)
    for i, row in enumerate(v):
        lines.append(f"{i // 2}," + ",".join(map(repr, map(float, row))))
    run = subprocess.run(
        [program, "cone", "-q", "-f", "csv", "--table=strips", "-"],
        input="id,x,y,z,rx,ry,rz,tx,ty,tz\n" + "\n".join(lines) + "\n",
        capture_output=True, text=True, check=False)
    said = {}
    for line in run.stderr.splitlines():
        found = re.match(r"phspline: -:\d+: record (\d+): (.*)", line)
        if found:
            said[int(found[1])] = found[2]
    body = run.stdout.splitlines()
    names = body[0].split(",")
    want = ["id", "strip", "x", "y", "z", "rx", "ry", "rz", "tx", "ty", "tz",
            "nx", "ny", "nz"]
    columns = [names.index(w) for w in want]
    columns += [names.index("geodesic_curvature") if "geodesic_curvature" in
                names else names.index("k")]
    columns += [columns[-1] + 1, columns[-1] + 2]
    rows = [line.split(",") for line in body[1:] if line]
    table = np.array([[float(r[c]) for c in columns] for r in rows])
    return table, said


def follow(t):
    """Where strips lead: points and frames."""
    c, e, d, n = t[:, 2:5], t[:, 5:8], t[:, 8:11], t[:, 11:14]
    k, kn, length = t[:, 14], t[:, 15], t[:, 16]
    w = kn[:, None] * e - k[:, None] * n
    K = np.hypot(k, kn)
    flat = K * length < 1e-300
    w = np.where(flat[:, None], n, w / np.where(flat, 1, K)[:, None])
    half = K * length / 2
    chord = length * np.sinc(half / np.pi)
    at = c + chord[:, None] * cross_angle(d, w, half)
    return at, [cross_angle(x, w, 2 * half) for x in (e, d, n)]


def check_printed(table, p, e, d):
    """The largest misses, of directions and of points over the pair."""
    first, last = table[0::2], table[1::2]
    pair = first[:, 0].astype(int)
    assert (pair == last[:, 0]).all() and (first[:, 1] == 0).all()
    e, d, p = e[pair], d[pair], p[pair]
    n = np.cross(e, d)
    unit_length = (first[:, 16] + last[:, 16])[:, None]
    middle, m = follow(first)
    end, f = follow(last)
    off = [first[:, 5:8] - e[:, 0], first[:, 8:11] - d[:, 0],
           first[:, 11:14] - n[:, 0], m[0] - last[:, 5:8], m[1] - last[:, 8:11],
           m[2] - last[:, 11:14], f[0] - e[:, 1], f[1] - d[:, 1], f[2] - n[:, 1]]
    beside = lambda at, j: np.cross(at - p[:, j], e[:, j])
    miss = [middle - last[:, 2:5], beside(first[:, 2:5], 0), beside(end, 1)]
    far = np.abs(np.concatenate([first[:, 2:5], last[:, 2:5], end], 1)).max(1)
    rounding = 32 * np.finfo(float).eps * far[:, None]
    directions = np.abs(np.concatenate(off, 1)).max(1)
    points = np.maximum(np.abs(np.concatenate(miss, 1)) - rounding, 0)
    return pair, directions, (points / unit_length).max(1)


# ---- what is refused ---------------------------------------------------------


def dot(a, b):
    return np.sum(a * b, axis=-1, keepdims=True)


def arc_end(a, e, d, n, c):
    """The frames where the arcs from a to c end."""
    v = c - a
    vv = dot(v, v)
    k, kn = 2 * dot(v, e) / vv, 2 * dot(v, n) / vv
    return e - k * v, 2 * dot(v, d) / vv * v - d, n - kn * v


def misses(x, p, e, d, size):
    """How biarcs miss the second frame: one for each row of x."""
    n = np.cross(e, d)
    a = [p[j] + x[:, j, None] * size * e[j] for j in range(2)]
    A = a[1] - a[0]
    lam = x[:, 2:] * size
    N = dot(A, A) / 2 - lam * dot(A, d[0])
    D = dot(A, d[1]) + lam * (1 - d[0] @ d[1])
    with np.errstate(all="ignore"):
        c = (N * (a[0] + lam * d[0]) + lam * (D * a[1] - N * d[1])) / \
            (lam * D + N)
        f = arc_end(a[0], e[0], d[0], n[0], c)
        g = arc_end(c, *f, a[1])
    out = np.concatenate([g[0] - e[1], g[1] - d[1], g[2] - n[1]], axis=1)
    return np.where(np.isfinite(out).all(axis=1)[:, None], out, 10.0)


LOW, HIGH = np.array([-100, -100, 1e-3]), np.array([100, 100, 1e3])


def least_squares(f, x, steps=100):
    """The least squares that Gauss-Newton steps, damped as Levenberg and
    Marquardt do, come to from every row of x within LOW and HIGH: residuals."""
    r = f(x)
    damping = np.full(len(x), 1e-3)
    for _ in range(steps):
        h = 1e-7 * np.maximum(np.abs(x), 1e-2)
        J = np.stack([(f(x + h * axis) - r) / h[:, i, None]
                      for i, axis in enumerate(np.eye(3))], axis=2)
        JT = np.transpose(J, (0, 2, 1))
        M = JT @ J
        scale = np.maximum(np.diagonal(M, axis1=1, axis2=2), 1e-12)
        M = M + (damping[:, None] * scale)[..., None] * np.eye(3)
        step = np.linalg.solve(M, JT @ r[..., None])[..., 0]
        y = np.clip(x - step, LOW, HIGH)
        s = f(y)
        better = np.sum(s * s, axis=1) < np.sum(r * r, axis=1)
        x = np.where(better[:, None], y, x)
        r = np.where(better[:, None], s, r)
        damping = np.where(better, np.maximum(damping / 5, 1e-9),
                           np.minimum(damping * 4, 1e9))
        if np.abs(r).max(axis=1).min() < 1e-5:
            break
    return r


def has_none(rng, p, e, d):
    """Whether no biarc with contact points nearer than 100 distances does."""
    size = np.linalg.norm(p[1] - p[0])
    x = np.column_stack([rng.uniform(-3, 3, (12, 2)),
                         10 ** rng.uniform(-1, 1, 12)])
    r = least_squares(lambda x: misses(x, p, e, d, size), x)
    return not np.abs(r).max(axis=1).min() < 1e-5


def no_legs(p, e, d):
    """Whether no equal legs meet, on a cylinder."""
    A = p[1] - p[0]
    A = A - (A @ e[0]) * e[0]
    lam = np.logspace(-8, 8, 4001) * np.linalg.norm(A)
    gap = np.linalg.norm(A - lam[:, None] * (d[0] + d[1]), axis=1) / lam - 2
    return bool((gap > 0).all())


def short_arc(p, e, d):
    """Whether an arc is less than 1e-4 of the coordinates."""
    L = np.longdouble
    p, e, d = p.astype(L), e.astype(L), d.astype(L)
    e = unit(e)
    d = unit(d - np.sum(d * e, axis=1)[:, None] * e)
    n = np.cross(e, d)
    o = (p[0] + p[1]) / 2
    rows = np.array([d[0], d[1], n[0] - n[1]])
    rhs = np.array([d[0] @ (p[0] - o), d[1] @ (p[1] - o),
                    n[0] @ (p[0] - o) - n[1] @ (p[1] - o)])
    det = rows[0] @ np.cross(rows[1], rows[2])
    m = o + (rhs[0] * np.cross(rows[1], rows[2]) +
             rhs[1] * np.cross(rows[2], rows[0]) +
             rhs[2] * np.cross(rows[0], rows[1])) / det
    a = np.array([p[j] + ((m - p[j]) @ e[j]) * e[j] for j in range(2)])
    A = a[1] - a[0]
    s, c12 = A @ (d[0] + d[1]), 1 - d[0] @ d[1]
    lam = A @ A / (s + np.sqrt(s * s + 2 * (A @ A) * c12))
    c = (a[0] + a[1] + lam * (d[0] - d[1])) / 2
    far = 20 + np.abs(a).max()
    arcs = [np.linalg.norm(c - a[0]), np.linalg.norm(a[1] - c)]
    return bool(min(arcs) < 1e-4 * far)


def confirm(rng, message, p, e, d):
    if "no-convergence" in message:
        return short_arc(p, e, d)
    if "such legs" in message:
        return no_legs(p, e, d)
    if "infeasible" in message:
        return has_none(rng, p, e, d)
    return False


def controls(rng, printed, kind, p, e, d):
    """That what confirms would not do so of pairs that are printed."""
    said = []
    some = [i for i in printed if kind[i] == "any"][:20]
    found = sum(not has_none(rng, p[i], e[i], d[i]) for i in some)
    if found < 0.9 * len(some):
        said.append(f"biarcs are fitted to {found} of {len(some)} pairs alone")
    if sum(short_arc(p[i], e[i], d[i]) for i in some) > 1:
        said.append("short arcs are found where there are none")
    ahead = np.array([[[0, 0, 0], [2.0, 1, 0]], [[0, 0, 1]] * 2, [[1, 0, 0]] * 2])
    if no_legs(*ahead):
        said.append("equal legs are not found")
    return said


def main():
    program, n, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    rng = np.random.default_rng(seed)
    kind, p, e, d = elements(rng, n)
    table, said = solve(program, p, e, d)
    pair, directions, points = check_printed(table, p, e, d)
    bad = controls(rng, pair, kind, p, e, d)
    worst = np.maximum(directions, points)
    for i in np.flatnonzero(~(worst <= LIMIT)):
        bad.append(f"pair {pair[i]} ({kind[pair[i]]}): misses by {worst[i]:.3g}")
    if len(pair) + len(said) != n or set(pair) & set(said):
        bad.append(f"{len(pair)} are printed and {len(said)} refused")
    for i, message in said.items():
        wanted = SAYS.get(kind[i], "no-convergence")
        if wanted not in message or not confirm(rng, message, p[i], e[i], d[i]):
            bad.append(f"pair {i} ({kind[i]}): not confirmed: {message}")
    for i in pair:
        if kind[i] in SAYS:
            bad.append(f"pair {i} ({kind[i]}): is printed")
    print(f"{len(pair)} printed, worst {worst.max():.2g}; refused and confirmed:",
          dict(Counter(kind[i] for i in said)))
    for line in bad[:20]:
        print(line)
    sys.exit(1 if bad else 0)


main()
