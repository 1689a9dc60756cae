# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the roads of an OpenDRIVE document and compares them with records.

    python3 opendrive.py FILE.xodr FILE.json LIMIT [up|down]

FILE.json has the same results with --sample=N, on one line each.  Nothing is
known here of the preimages: of every geometry the speed and the curvature of
its polynomials are integrated, for its length, its heading and, by these, its
end.  The end is the start of the next one, its heading goes on but where the
control points of the record have a corner, and the curvature but where the
record has a joint.  s is the sum of the lengths.  Every sample of the record is
on its geometry.  LIMIT is relative to the length, beside the rounding of coordinates; down: y of the record points
downward.  Prints how many roads, lines and polynomials there were.
"""
import json
import math
import sys
import xml.etree.ElementTree

PANELS = 64
# Gauss, 5 nodes on [0,1]
NODES = [(0.5, 64 / 225)] + [
    (0.5 + sign * math.sqrt(5 + f * math.sqrt(40 / 7)) / 6,
     (322 - f * 13 * math.sqrt(70)) / 1800)
    for f in (1, -1) for sign in (1, -1)]


def turned(a):
    """An angle, brought to [-pi,pi]."""
    return math.remainder(a, 2 * math.pi)


class Geometry:
    def __init__(self, element):
        for name in ("s", "x", "y", "hdg", "length"):
            setattr(self, name, float(element.get(name)))
        assert self.length > 0
        (child,) = element
        self.line = child.tag == "line"
        if self.line:
            self.u, self.v = [0, self.length, 0, 0], [0, 0, 0, 0]
            return
        assert child.tag == "paramPoly3", child.tag
        assert child.get("pRange") == "normalized"
        self.u, self.v = ([float(child.get(c + axis)) for c in "abcd"]
                          for axis in "UV")
        # the origin and the direction of u and v are those of the start
        assert self.u[0] == self.v[0] == self.v[1] == 0 and self.u[1] > 0

    def local(self, p):
        return [((d * p + c) * p + b) * p + a
                for a, b, c, d in (self.u, self.v)]

    def rates(self, p):
        (du, ddu), (dv, ddv) = (
            ((3 * d * p + 2 * c) * p + b, 6 * d * p + 2 * c)
            for _, b, c, d in (self.u, self.v))
        speed = math.hypot(du, dv)
        return speed, (du * ddv - dv * ddu) / speed**3

    def point(self, p):
        u, v = self.local(p)
        c, s = math.cos(self.hdg), math.sin(self.hdg)
        return [self.x + c * u - s * v, self.y + s * u + c * v]

    def integrate(self):
        """The length, the heading at the end, and the end."""
        length, heading, x, y = 0, self.hdg, 0, 0
        h = 1 / PANELS
        for i in range(PANELS):
            for node, weight in NODES:
                p = (i + node) * h
                speed, _ = self.rates(p)
                length += weight * h * speed
                # the heading there: its integral from the start of the panel
                at = heading
                for inner, w in NODES:
                    v, k = self.rates((i + node * inner) * h)
                    at += w * node * h * k * v
                x += weight * h * speed * math.cos(at)
                y += weight * h * speed * math.sin(at)
            for node, weight in NODES:
                speed, k = self.rates((i + node) * h)
                heading += weight * h * k * speed
        return length, heading, [self.x + x, self.y + y]


def corner(before, after):
    """The turn from one segment of the record to the next."""
    a, b = before["control_points"], after["control_points"]
    return turned(math.atan2(b[1][1] - b[0][1], b[1][0] - b[0][0]) -
                  math.atan2(a[-1][1] - a[-2][1], a[-1][0] - a[-2][0]))


def look(road, record, limit, up):
    geometries = [Geometry(e) for e in road.find("planView")]
    segments, size = record["segments"], record["length"]
    assert len(geometries) == len(segments)
    assert road.get("junction") == "-1"
    assert abs(float(road.get("length")) - size) <= limit * size
    jumps = {j["segment"]: j["curvature"] for j in record.get("joints", [])}
    largest = max(abs(g.rates(p)[1]) for g in geometries for p in (0, 1))
    ulp = 4 * sys.float_info.epsilon * max(abs(g.x) + abs(g.y)
                                           for g in geometries)
    s = 0
    for k, g in enumerate(geometries):
        length, heading, end = g.integrate()
        assert abs(g.s - s) <= limit * size and (k or g.s == 0)
        assert g.length == segments[k]["length"]
        assert abs(length - g.length) <= limit * size, (k, length, g.length)
        s += g.length
        if k + 1 == len(geometries):
            break
        n = geometries[k + 1]
        assert math.dist(end, (n.x, n.y)) <= limit * size + ulp, (k, end, n.x)
        turn = up * corner(segments[k], segments[k + 1])
        if "joints" in record or "auxiliary" in record:
            turn = 0
            kappa = [g.rates(1)[1], n.rates(0)[1]]
            told = jumps.get(k + 1, [up * kappa[0]] * 2)
            for found, wanted in zip(kappa, told):
                assert abs(up * found - wanted) <= 1e4 * limit * largest, k
        assert abs(turned(n.hdg - heading - turn)) <= 1e3 * limit, (k, heading)
    assert abs(s - size) <= limit * size
    for sample in record["samples"]:
        g = geometries[sample["segment"]]
        x, y = sample["point"]
        found = g.point(sample["t"])
        if g.line:  # at the same length
            found = g.point((sample["s"] - g.s) / g.length)
        assert math.dist(found, (x, up * y)) <= limit * size + ulp, sample
    return sum(g.line for g in geometries), sum(not g.line for g in geometries)


def main():
    roads, records, limit = sys.argv[1], sys.argv[2], float(sys.argv[3])
    up = -1 if "down" in sys.argv[4:] else 1
    root = xml.etree.ElementTree.parse(roads).getroot()
    assert root.tag == "OpenDRIVE"
    assert root[0].tag == "header" and root[0].get("revMajor") == "1"
    roads = root.findall("road")
    ids = [road.get("id") for road in roads]
    assert len(set(ids)) == len(ids)
    with open(records, encoding="utf-8") as lines:
        results = [json.loads(line) for line in lines]
    results = [r for r in results if r["status"] == "ok"]
    assert len(results) == len(roads)
    found = [look(*pair, limit, up) for pair in zip(roads, results)]
    print(len(roads), *(sum(n) for n in zip(*found)))


main()
