# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a program of G-code and compares its moves with records.

    python3 gcode.py FILE.ngc FILE.json LIMIT CHORD FEED [up|down]

FILE.json has the same results with --sample=N, on one line each.  Cubics of
records are cubics of the program, to LIMIT of the size of the curve.  Of other
curves, of offsets and of loops, the moves are never further than CHORD from
samples, nor these from the moves: a place of a loop is a place of one of its
pieces, which are evaluated by their definition.  Arcs have their center and both
ends on one circle.  down: y of the record points downward.  Prints how many
chains, lines, cubics and arcs there were.
"""
import json
import math
import re
import sys

WORD = r" ?([A-Z])(-?[0-9]+(?:\.[0-9]*[1-9])?)"
STEPS = 16
WINDOW = 40


class Move:
    def __init__(self, code, start, end, w):
        self.code, self.start, self.end = code, start, end
        self.center = self.inner = None
        if code in ("G2", "G3"):
            c = self.center = [start[0] + w["I"], start[1] + w["J"]]
            self.radius = math.dist(c, start)
            self.missed = abs(self.radius - math.dist(c, end))
            a, b = (math.atan2(p[1] - c[1], p[0] - c[0]) for p in (start, end))
            turn = (b - a) % (2 * math.pi)
            self.angle = a
            self.turn = turn if code == "G3" else turn - 2 * math.pi
        elif code == "G5":
            self.inner = [[start[0] + w["I"], start[1] + w["J"]],
                          [end[0] + w["P"], end[1] + w["Q"]]]

    def away(self, p):
        """The distance of a point from a line or arc."""
        if self.center:
            c = self.center
            a = math.atan2(p[1] - c[1], p[0] - c[0]) - self.angle
            a = a % (2 * math.pi) if self.turn > 0 else -(-a % (2 * math.pi))
            if abs(a) <= abs(self.turn):
                return abs(math.dist(p, c) - self.radius)
            return min(math.dist(p, self.start), math.dist(p, self.end))
        x, y = self.end[0] - self.start[0], self.end[1] - self.start[1]
        u, v = p[0] - self.start[0], p[1] - self.start[1]
        t = min(max((u * x + v * y) / (x * x + y * y), 0), 1)
        return math.hypot(u - t * x, v - t * y)

    @property
    def length(self):
        return math.dist(self.start, self.end)

    def turned(self, before):
        """The turn of a line from the one before."""
        a, b = (math.atan2(m.end[1] - m.start[1], m.end[0] - m.start[0])
                for m in (before, self))
        return math.remainder(b - a, 2 * math.pi)

    def places(self):
        for i in range(1, STEPS):
            t = i / STEPS
            if self.center:
                a = self.angle + t * self.turn
                yield [self.center[0] + self.radius * math.cos(a),
                       self.center[1] + self.radius * math.sin(a)]
            else:
                yield [a + t * (b - a) for a, b in zip(self.start, self.end)]


def read(name, feed):
    """The moves after each comment, as lists of chains."""
    with open(name, encoding="ascii") as file:
        lines = file.read().split("\n")
    assert lines[0] == "G21 G17 G90" and lines[1] == f"F{feed}", lines[:2]
    assert lines[-2:] == ["M2", ""]
    parts, at = [], None
    for line in lines[2:-2]:
        assert len(line) <= 255
        if line[0] == "(":
            assert re.fullmatch(r"\((curve|offset [-0-9.e]+ of) [^()]*\)", line)
            parts.append((line, []))
            continue
        code, rest = line.split(" ", 1)
        assert re.fullmatch(f"(?:{WORD})+", " " + rest), line
        w = {letter: float(x) for letter, x in re.findall(WORD, rest)}
        assert list(w) == list({"G0": "XY", "G1": "XY", "G2": "XYIJ",
                                "G3": "XYIJ", "G5": "XYIJPQ"}[code]), line
        end = [w["X"], w["Y"]]
        if code == "G0":
            parts[-1][1].append([])
        else:
            parts[-1][1][-1].append(Move(code, at, end, w))
            assert at != end, line
        at = end
    return parts


class Nearest:
    """The distance from the moves that follow the one that was nearest last."""

    def __init__(self, moves):
        self.moves, self.at = moves, 0

    def away(self, p):
        low = max(self.at - WINDOW // 4, 0)
        near = range(low, min(low + WINDOW, len(self.moves)))
        away, self.at = min((self.moves[i].away(p), i) for i in near)
        return away


def rational(piece, t, up):
    points, weights = piece["control_points"], piece["weights"]
    n = len(points) - 1
    b = [math.comb(n, j) * t**j * (1 - t) ** (n - j) * w
         for j, w in enumerate(weights)]
    x, y = (sum(c * p[i] for c, p in zip(b, points)) / sum(b) for i in (0, 1))
    return [x, up * y]


class Judge:
    def __init__(self, size, limit, chord, up):
        self.size, self.limit, self.chord, self.up = size, limit, chord, up

    def same(self, a, b):
        assert math.dist(a, b) <= self.limit * self.size, (a, b)

    def cubics(self, moves, segments):
        assert len(moves) == len(segments)
        for move, segment in zip(moves, segments):
            p = [[x, self.up * y] for x, y in segment["control_points"]]
            self.same(move.start, p[0])
            self.same(move.end, p[3])
            if move.inner:
                self.same(move.inner[0], p[1])
                self.same(move.inner[1], p[2])
            else:
                assert move.away(p[1]) + move.away(p[2]) <= \
                    2 * self.limit * self.size

    def near(self, moves, places):
        """Both ways: places are dense, and in the order of the moves."""
        most = self.chord + 2 * self.limit * self.size
        self.same(moves[0].start, places[0])
        self.same(moves[-1].end, places[-1])
        nearest = Nearest(moves)
        for p in places:
            away = nearest.away(p)
            assert away <= most, (p, away, most)
        lines = [Move("G1", a, b, {}) for a, b in zip(places, places[1:])
                 if a != b]
        # a chord of places leaves the curve by an eighth of length and turn;
        # what turns more is a corner
        slack = max([max(a.length, b.length) * abs(b.turned(a)) / 4
                     for a, b in zip(lines, lines[1:])
                     if abs(b.turned(a)) < 0.5] + [0])
        nearest = Nearest(lines)
        for m in moves:
            assert not m.center or m.missed <= self.limit * self.size
            for p in m.places():
                away = nearest.away(p)
                assert away <= most + slack, (p, away, most, slack)


def cut(samples, up):
    """Samples of a raw offset, where it is in one part; gaps are no rounding."""
    chains = [[]]
    last = None
    size = max(math.dist(s["point"], samples[0]["point"]) for s in samples)
    for s in samples:
        p = [s["point"][0], up * s["point"][1]]
        if last and s["segment"] != last[0] and \
                math.dist(p, last[1]) > 1e-9 * size:
            chains.append([])
        chains[-1].append(p)
        last = s["segment"], p
    return chains


def look(parts, record, judge):
    chains = parts.pop(0)[1]
    if record["curve"] == "tc":
        judge.cubics([m for c in chains for m in c], record["segments"])
    else:
        (moves,) = chains
        judge.near(moves, [p for c in cut(record["samples"], judge.up)
                           for p in c])
    for offset in record.get("offsets", []):
        comment, chains = parts.pop(0)
        assert float(comment.split()[1]) == offset["distance"]
        if "loops" not in offset:
            raw = cut(offset["samples"], judge.up)
            assert len(raw) == len(chains), (len(raw), len(chains))
            for moves, places in zip(chains, raw):
                judge.near(moves, places)
            continue
        assert len(offset["loops"]) == len(chains)
        for moves, loop in zip(chains, offset["loops"]):
            pieces = loop["pieces"]
            judge.near(moves, [rational(p, i / STEPS, judge.up)
                               for p in pieces for i in range(STEPS + 1)])
            arcs = [m.turn for m in moves if m.center]
            # all that leave their chord by more than CHORD
            turns = [judge.up * p["angle"] for p in pieces if "angle" in p and
                     abs(p["angle"]) * p["length"] / 8 > judge.chord]
            assert len(arcs) == len(turns), (arcs, turns)
            for found, wanted in zip(arcs, turns):
                assert abs(found - wanted) <= 1e-6, (found, wanted)


def main():
    name, records, limit, chord, feed = sys.argv[1:6]
    up = -1 if "down" in sys.argv[6:] else 1
    parts = read(name, feed)
    moves = [m.code for _, chains in parts for c in chains for m in c]
    counts = [sum(len(chains) for _, chains in parts), moves.count("G1"),
              moves.count("G5"), moves.count("G2") + moves.count("G3")]
    with open(records, encoding="utf-8") as lines:
        for record in map(json.loads, lines):
            if record["status"] != "ok":
                continue
            p = [q for s in record["segments"] for q in s["control_points"]]
            size = max(math.dist(q, p[0]) for q in p)
            look(parts, record, Judge(size, float(limit), float(chord), up))
    assert not parts
    print(*counts)


main()
