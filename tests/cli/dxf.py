# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the drawing of curves, read by another program, with their records.

    python3 dxf.py FILE.dxf FILE.json LIMIT

FILE.json has the same results with --sample=N, on one line each.  Every sample
of a curve and of a raw offset, and places of every piece of a loop, are
compared with the spline of FILE.dxf at the same parameter; the distance may be
LIMIT times the size of the curve, and the error that a record with nurbs tells.
Prints how many splines and places there were.  Fails where the audit of ezdxf
finds anything.
"""
import bisect
import json
import math
import sys

import ezdxf


def bezier(piece, x):
    """The point of a rational Bezier curve, by its definition."""
    points, weights = piece["control_points"], piece["weights"]
    n = len(points) - 1
    b = [math.comb(n, j) * x**j * (1 - x) ** (n - j) * w
         for j, w in enumerate(weights)]
    return [sum(c * p[i] for c, p in zip(b, points)) / sum(b) for i in (0, 1)]


class Chain:
    """A spline, evaluated by de Boor's algorithm in homogeneous coordinates."""

    def __init__(self, entity):
        self.closed = entity.closed
        self.degree = entity.dxf.degree
        self.knots = list(entity.knots)
        points = [list(p) for p in entity.control_points]
        weights = list(entity.weights) or [1] * len(points)
        assert len(self.knots) == len(points) + self.degree + 1
        assert len(weights) == len(points)
        self.points = [[w * x for x in p] + [w]
                       for p, w in zip(points, weights)]

    def point(self, t):
        k, d = self.knots, self.degree
        i = min(max(bisect.bisect_right(k, t) - 1, d), len(self.points) - 1)
        q = self.points[i - d:i + 1]
        for r in range(1, d + 1):
            for j in range(d, r - 1, -1):
                a, b = k[i - d + j], k[i + 1 + j - r]
                x = (t - a) / (b - a)
                q[j] = [u + x * (v - u) for u, v in zip(q[j - 1], q[j])]
        return [x / q[d][3] for x in q[d][:3]]


class Drawing:
    def __init__(self, name):
        document = ezdxf.readfile(name)
        audit = document.audit()
        assert not audit.errors and not audit.fixes, audit.errors + audit.fixes
        self.splines = list(document.modelspace())
        assert all(e.dxftype() == "SPLINE" for e in self.splines)
        self.at = self.places = 0

    def chains(self, layer, label, upto, distance=None):
        """The next splines, until one ends at the parameter."""
        chains = []
        while not chains or chains[-1].knots[-1] != upto:
            e = self.splines[self.at]
            self.at += 1
            data = [tag.value for tag in e.get_xdata("PHSPLINE")]
            want = [label] if distance is None else [label, distance]
            assert e.dxf.layer == layer and data == want, (e.dxf.layer, data)
            chains.append(Chain(e))
            knots = chains[-1].knots
            ends = [chains[-1].point(knots[i]) for i in (0, -1)]
            assert e.closed == (math.dist(*ends) == 0)
        return chains

    def compare(self, chains, samples, limit):
        starts = [c.knots[0] for c in chains]
        for t, point in samples:
            i = max(bisect.bisect_right(starts, t) - 1, 0)
            near = [chains[i]] + ([chains[i - 1]] if t == starts[i] else [])
            away = min(math.dist(c.point(t)[:len(point)], point)
                       for c in near)
            assert away <= limit, (t, point, away, limit)
            self.places += 1


def located(record, samples):
    """Samples by the global parameter."""
    for s in samples:
        segment = record["segments"][s["segment"]]
        a, b = segment["interval"]
        u = s["t"] / segment.get("alpha", 1)
        yield a + u * (b - a) if u < 1 else b, s["point"]


def look(drawing, record, number, limit):
    label = str(record.get("id", number))
    end = record["segments"][-1]["interval"][1]
    points = [p for s in record["segments"] for p in s["control_points"]]
    size = max(math.dist(p, points[0]) for p in points)

    def allowed(of):
        return limit * size + 1.25 * max(c["error"] for c in of["nurbs"])

    chains = drawing.chains("curve", label, end)
    drawing.compare(chains, located(record, record["samples"]), allowed(record))
    for offset in record.get("offsets", []):
        d = offset["distance"]
        for loop in offset.get("loops", []):
            t = [0]
            for piece in loop["pieces"]:
                t.append(t[-1] + piece["length"])
            places = [(t[i] + x * (t[i + 1] - t[i]), bezier(piece, x))
                      for i, piece in enumerate(loop["pieces"])
                      for x in (0, .25, .5, .75, 1)]
            drawing.compare(drawing.chains("offset", label, t[-1], d), places,
                            limit * size)
        if "loops" not in offset:
            drawing.compare(drawing.chains("offset", label, end, d),
                            located(record, offset["samples"]), allowed(offset))


def main():
    name, records, limit = sys.argv[1], sys.argv[2], float(sys.argv[3])
    drawing = Drawing(name)
    with open(records, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            record = json.loads(line)
            if record["status"] == "ok":
                look(drawing, record, number, limit)
    assert drawing.at == len(drawing.splines), "more splines than chains"
    print(len(drawing.splines), "splines,", drawing.places, "places")


main()
