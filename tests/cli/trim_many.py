#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trimmed offsets of random closed curves, beside what others say of them.

usage: python3 trim_many.py PHSPLINE [CURVES [SEED]]

Each curve, of 6 to 25 points, has six distances.  What is looked at:
  area, loops  those of buffers of GEOS (shapely) round dense polygons, area to
               1e-4 of length times distance; where GEOS disagrees, polygons
               four times as dense, then distances from the curve decide
  distance     of points of all pieces from the curve, by brute force: not below
               the distance, but by 1e-9 of it
  closure      of pieces, to 1e-12 of the size
  derivative   area by distance is the length, to 1e-5, of every tenth curve
  the same     moved, rotated, scaled, reversed, and from another point on, of
               every tenth curve: loops, area and length to 1e-8
Only control points and weights are read.  1000 curves take a few minutes.
Status 1: something differs; 77: a package is missing, and which.
"""
import json
import math
import subprocess
import sys

try:
    import numpy as np
    import shapely.geometry
    from scipy.spatial import cKDTree
except ImportError as missing:
    print(missing)
    sys.exit(77)

BATCH = 20  # curves of one run, which have their distances in common
DENSE = 64  # points of a segment in a polygon
failures = []
counts = {}


def count(what):
    counts[what] = counts.get(what, 0) + 1


# ---- curves -----------------------------------------------------------------


def polygon(rng, n):
    """A simple polygon: around a center, or untangled."""
    if rng.random() < 0.4:
        angle = np.sort(rng.uniform(0, 2 * math.pi, n))
        angle += 2 * math.pi * np.arange(n) / n
        angle /= 2
        r = rng.uniform(3, 12, n)
        return np.stack([r * np.cos(angle), r * np.sin(angle)], 1)
    p = rng.uniform(-10, 10, (n, 2))
    for _ in range(1000):  # swaps that make it shorter
        better = False
        for i in range(n - 1):
            for j in range(i + 2, n - (i == 0)):
                a, b, c, d = p[i], p[i + 1], p[j], p[(j + 1) % n]
                if (np.hypot(*(a - c)) + np.hypot(*(b - d)) <
                        np.hypot(*(a - b)) + np.hypot(*(c - d)) - 1e-12):
                    p[i + 1:j + 1] = p[i + 1:j + 1][::-1]
                    better = True
        if not better:
            return p
    return p


def problem(rng, kind):
    p = polygon(rng, int(rng.integers(6, 26))) * 10 ** rng.uniform(-0.3, 0.5)
    if rng.random() < 0.5:
        p = p[::-1]
    return record(kind, p)


def record(kind, p):
    p = [[float(x), float(y)] for x, y in p]
    if kind == 'planar':
        return {'closed': True, 'points': p}
    return {'closed': True, 'tolerance': 0.01,
            'curve': [[p[i], p[(i + 1) % len(p)]] for i in range(len(p))]}


def run(program, command, problems, distances):
    options = ['--offset=' + ','.join('%.17g' % d for d in distances),
               '--offset-mode=trimmed', '-q']
    text = '\n'.join(json.dumps(p) for p in problems)
    found = subprocess.run([program, command] + options, input=text,
                           stdout=subprocess.PIPE, text=True)
    return [json.loads(line) for line in found.stdout.splitlines()]


# ---- their geometry ---------------------------------------------------------


def bernstein(degree, u):
    return np.stack([math.comb(degree, i) * u**i * (1 - u)**(degree - i)
                     for i in range(degree + 1)], 1)


def points_of(result):
    return np.array([s['control_points'] for s in result['segments']])


def dense(control, each):
    """Points of all segments, without their last ones."""
    b = bernstein(control.shape[1] - 1, np.arange(each) / each)
    return np.einsum('ij,kjd->kid', b, control)


def pieces_of(offset):
    for loop in offset['loops']:
        for piece in loop['pieces']:
            yield loop, np.array(piece['control_points']), np.array(
                piece['weights'])


def places_of(offset, each):
    u = (np.arange(each) + 0.5) / each
    out = []
    for _, p, w in pieces_of(offset):
        b = bernstein(len(w) - 1, u) * w
        out.append((b @ p) / b.sum(1)[:, None])
    return np.concatenate(out) if out else np.zeros((0, 2))


class Curve:
    """Distances from a curve: the nearest of many points, then Newton's
    method from each of these on its segment."""

    def __init__(self, control):
        self.control = control
        self.each = DENSE
        self.tree = cKDTree(dense(control, self.each).reshape(-1, 2))

    def distance(self, places, near=6):
        best, at = self.tree.query(places, k=near)
        best = best.min(1)
        n = len(self.control)
        degree = self.control.shape[1] - 1
        first = degree * np.diff(self.control, axis=1)
        second = (degree - 1) * np.diff(first, axis=1)
        for column in range(near):
            for side in (0, -1):  # a sample ends one segment, begins another
                k = at[:, column] // self.each
                u = (at[:, column] % self.each) / self.each
                if side:
                    k = np.where(u == 0, (k - 1) % n, k)
                    u = np.where(u == 0, 1.0, u)
                for _ in range(8):
                    r = np.einsum('ij,ijd->id', bernstein(degree, u),
                                  self.control[k]) - places
                    d = np.einsum('ij,ijd->id', bernstein(degree - 1, u),
                                  first[k])
                    c = np.einsum('ij,ijd->id', bernstein(degree - 2, u),
                                  second[k])
                    best = np.minimum(best, np.hypot(r[:, 0], r[:, 1]))
                    slope = (d * d).sum(1) + (r * c).sum(1)
                    slope = np.where(slope > 0, slope, (d * d).sum(1))
                    u = np.clip(u - (r * d).sum(1) / slope, 0, 1)
        return best


# ---- what is asked ----------------------------------------------------------


def fail(name, text):
    failures.append(name)
    print('%s: %s' % (name, text))
    sys.stdout.flush()


def buffered(control, d, each, steps):
    """Signed area and loops of the buffer, as the offset at d has them; what
    the polygon cuts off the curve is added."""
    p = dense(control, each).reshape(-1, 2)
    x, y = p[:, 0], p[:, 1]
    area = (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
    u, v = x[::2], y[::2]
    coarse = (u * np.roll(v, -1) - v * np.roll(u, -1)).sum() / 2
    side = np.sign(area)
    shape = shapely.geometry.Polygon(p).buffer(-d * side, resolution=steps)
    parts = getattr(shape, 'geoms', [shape])
    loops = sum(1 + len(g.interiors) for g in parts if not g.is_empty)
    cut_off = (area - coarse) / 3 if loops else 0
    return side * shape.area + cut_off, loops, shape


def depth_of(curve, ring):
    """The largest distance from the curve within a ring: by places in it, and
    steps from the best of them."""
    shape = shapely.geometry.Polygon(ring)
    x0, y0, x1, y1 = shape.bounds
    step = max(x1 - x0, y1 - y0)
    best = np.array([[x0 + step / 2, y0 + step / 2]])
    value = -1.0
    for _ in range(40):
        g = np.linspace(-0.5, 0.5, 9) * step
        grid = best + np.stack(np.meshgrid(g, g), 2).reshape(-1, 2)
        d = curve.distance(grid)
        inside = [shape.contains(shapely.geometry.Point(q)) for q in grid]
        d = np.where(inside, d, -1)
        if d.max() > value:
            value, best = d.max(), grid[d.argmax()][None]
        step *= 0.6
    return value


def adjudicate(name, control, curve, d, loops, area, allowed):
    """Who is right where GEOS disagrees."""
    for each, steps in ((4 * DENSE, 256), (16 * DENSE, 1024)):
        theirs, n, shape = buffered(control, d, each, steps)
        if n == loops and abs(theirs - area) <= allowed:
            count('GEOS agrees at %d points of a segment' % each)
            return
    # what is no wider than rounding of polygons is nothing, or joined
    thin = 0
    for g in getattr(shape, 'geoms', [shape]):
        if not g.is_empty:
            for ring in [g.exterior] + list(g.interiors):
                if depth_of(curve, ring) < abs(d) * (1 + 1e-6):
                    thin += 1
    if n - thin == loops and abs(theirs - area) <= allowed:
        count('GEOS has loops that are thinner than 1e-6 of the distance')
        return
    fail(name, '%d loops of area %.9g, GEOS %d (%d thin) of %.9g, allowed %.2g'
         % (loops, area, n, thin, theirs, allowed))


def look_at(name, result, offset, curve, control, size):
    d = offset['distance']
    loops = [loop for loop in offset['loops']]
    ends = [(p[0], p[-1], loop) for loop, p, _ in pieces_of(offset)]
    if not all(loop['closed'] for loop in loops):
        fail(name, 'it is open')
    for loop in loops:
        own = [e for e in ends if e[2] is loop]
        for i, e in enumerate(own):
            gap = np.abs(own[(i + 1) % len(own)][0] - e[1]).max()
            if not gap <= 1e-12 * size:
                fail(name, 'a gap of %g' % (gap / size))
    if offset['diagnostics']['certified'] is not True:
        fail(name, 'not certified')
    places = places_of(offset, 6)
    if len(places):
        least = curve.distance(places).min() / abs(d)
        counts['1 - least distance'] = max(counts.get('1 - least distance', -1),
                                           1 - least)
        if not least >= 1 - 1e-9:
            fail(name, 'a distance of 1 - %g' % (1 - least))
    area, n, _ = buffered(control, d, DENSE, 64)
    allowed = 1e-4 * result['length'] * abs(d)
    if n != len(loops) or not abs(area - offset['area']) <= allowed:
        count('disagreements')
        adjudicate(name, control, curve, d, len(loops), offset['area'], allowed)
    count('offsets')
    count('loops of one offset: %s' % (min(len(loops), 5)))


def differentiate(name, program, command, given, distances):
    h = 1e-5
    for d in distances:
        r = run(program, command, [given], [d * (1 - h), d, d * (1 + h)])[0]
        if r['status'] != 'ok':
            fail(name, r['error']['message'])
            continue
        a, b, c = r['offsets']
        if len({len(o['loops']) for o in (a, b, c)}) == 1 and b['loops']:
            rate = (c['area'] - a['area']) / (c['distance'] - a['distance'])
            counts['dA/dD'] = max(counts.get('dA/dD', 0),
                                  abs(rate / b['length'] + 1))
            if not abs(rate + b['length']) <= 1e-5 * b['length']:
                fail(name, 'at %.17g dA/dD is %g of the length'
                     % (d, rate / b['length']))


def change(name, program, command, kind, points, distances, want):
    c, s = math.cos(1), math.sin(1)
    turn = np.array([[c, s], [-s, c]])
    size = np.ptp(points, 0).max()
    changes = [('moved', points + 100 * size, 1, 1),
               ('rotated', points @ turn, 1, 1),
               ('reversed', points[::-1], 1, -1),
               ('shifted', np.roll(points, -3, 0), 1, 1),
               ('1e9', points * 1e9, 1e9, 1), ('1e-9', points * 1e-9, 1e-9, 1)]
    for what, p, scale, side in changes:
        given = record(kind, p)
        if 'tolerance' in given:
            given['tolerance'] *= scale
        r = run(program, command, [given],
                [side * scale * d for d in distances])[0]
        if r['status'] != 'ok':
            fail(name, '%s: %s' % (what, r['error']['message']))
            continue
        for a, b in zip(r['offsets'], want):
            far = max(abs(a['area'] * side / scale**2 - b['area']) /
                      (size + abs(b['distance']))**2,
                      abs(a['length'] / scale - b['length']) / size)
            key = 'most changed: ' + what
            counts[key] = max(counts.get(key, 0), far)
            if len(a['loops']) != len(b['loops']) or not far <= 1e-8:
                fail(name, '%s, at %.17g: %d loops, changed by %g, not %d'
                     % (what, b['distance'], len(a['loops']), far,
                        len(b['loops'])))


def main():
    program = sys.argv[1]
    curves = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    done = 0
    while done < curves:
        kind = 'planar' if rng.random() < 0.75 else 'tc'
        distances = np.round(10 ** rng.uniform(-1.5, 1, 6) *
                             rng.choice([-1, 1], 6), 6)
        problems = [problem(rng, kind) for _ in range(BATCH)]
        for given, result in zip(
                problems, run(program, kind, problems, distances)):
            name = 'curve %d' % done
            if done == curves:
                break
            if result['status'] != 'ok':
                done += 1
                fail(name, '%s\n%s' % (result['error']['message'],
                                       json.dumps(given)))
                continue
            if any(w['code'] == 'self-crossing'
                   for w in result.get('warnings', [])):
                continue
            done += 1
            control = points_of(result)
            if not shapely.geometry.Polygon(
                    dense(control, DENSE).reshape(-1, 2)).is_valid:
                count('crosses')
                continue
            curve = Curve(control)
            for offset in result['offsets']:
                size = np.ptp(control.reshape(-1, 2), 0).max()
                look_at('%s at %.17g' % (name, offset['distance']), result,
                        offset, curve, control,
                        size + abs(offset['distance']))
            if done % 10 == 0:
                points = np.array(given['points'] if kind == 'planar' else
                                  [c[0] for c in given['curve']])
                differentiate(name, program, kind, given, distances)
                change(name, program, kind, kind, points, distances,
                       result['offsets'])
    for what in sorted(counts):
        print('%s: %.10g' % (what, counts[what]))
    print('%d curves, %d failures' % (done, len(failures)))
    sys.exit(1 if failures or not counts.get('offsets') else 0)


main()
