#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether SVG paths of loops of offsets are where their pieces are.

usage: python3 svg_loops.py RECORD PATH WITHIN

Subpaths after those of the curve are loops, in the order of the record, and
closed by Z if they are.  Every place of a piece is within WITHIN of the cubics,
and every place of these of the pieces.  No package is needed.
"""
import json
import math
import re
import sys

EACH = 400  # places of a piece, and of a cubic


def rational(piece):
    p, w = piece['control_points'], piece['weights']
    n = len(w) - 1
    for k in range(EACH + 1):
        u = k / EACH
        b = [math.comb(n, i) * u**i * (1 - u)**(n - i) * w[i]
             for i in range(n + 1)]
        total = sum(b)
        yield (sum(b[i] * p[i][0] for i in range(n + 1)) / total,
               sum(b[i] * p[i][1] for i in range(n + 1)) / total)


def subpaths(text):
    """Points of each, and whether it is closed."""
    for path in re.findall('M[^M]*', text):
        v = [float(x) for x in re.findall(r'-?[0-9.]+(?:e[-+]?[0-9]+)?', path)]
        p = list(zip(v[::2], v[1::2]))
        assert len(p) % 3 == 1 and set(re.findall('[A-Za-df-z]', path)) <= {
            'M', 'C', 'Z'}, path
        out = [p[0]]
        for i in range(0, len(p) - 1, 3):
            for k in range(1, EACH + 1):
                u = k / EACH
                b = [(1 - u)**3, 3 * u * (1 - u)**2, 3 * u * u * (1 - u), u**3]
                out.append(tuple(sum(b[j] * p[i + j][c] for j in range(4))
                                 for c in (0, 1)))
        yield out, 'Z' in path


def apart(p, line):
    """From a point to a polyline."""
    best = math.inf
    for a, b in zip(line, line[1:]):
        x, y = b[0] - a[0], b[1] - a[1]
        square = x * x + y * y
        t = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square if square else 0
        t = min(max(t, 0), 1)
        best = min(best, math.hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y))
    return best


record = json.load(open(sys.argv[1], encoding='utf-8'))
loops = [loop for o in record['offsets'] for loop in o['loops']]
paths = list(subpaths(open(sys.argv[2], encoding='utf-8').read()))
of_loops = paths[len(paths) - len(loops):]
worst = 0
for loop, (line, closed) in zip(loops, of_loops):
    places = [q for piece in loop['pieces'] for q in rational(piece)]
    assert closed == loop['closed'], 'closed'
    worst = max(worst, max(apart(q, line) for q in places[::41]),
                max(apart(q, places) for q in line[::97]))
print('%d loops, within %.3g' % (len(loops), worst))
sys.exit(0 if loops and worst <= 1.01 * float(sys.argv[3]) else 1)
