# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves problems of plane points, and compares the curves.

python3 moved.py HOW <PROBLEMS         the same problems, moved
python3 moved.py HOW LIMIT ONE OTHER   of the results of both: how many there
    are, and how many are not the same curve; LIMIT is relative to the size

HOW is a word:
    shift     closed data begin at another point, by a third of them
    reverse   the other way round; mirror   on the other side
    quarter   by a quarter of a turn; grow, shrink   by 2^30
    turn      by an angle; away   to another place; big, small   by 1e9
all of which but the last four leave coordinates their digits.
"""
import cmath
import json
import sys

FACTOR = {"quarter": 1j, "turn": cmath.exp(1j), "grow": 2**30,
          "shrink": 2**-30, "big": 1e9, "small": 1e-9}


def moved(how, z):
    z = complex(*z)
    z = z.conjugate() if how == "mirror" else z * FACTOR.get(how, 1)
    z = z + (3 - 2j) if how == "away" else z
    return [z.real, z.imag]


def of_problem(how, problem):
    points = [moved(how, z) for z in problem["points"]]
    if how == "shift" and problem.get("closed"):
        k = len(points) // 3
        points = points[k:] + points[:k]
    if how == "reverse":
        points.reverse()
    return {**problem, "points": points}


def of_result(how, record):
    """The control points of the segments as they should be, from the start."""
    segments = [[moved(how, z) for z in s["control_points"]]
                for s in record["segments"]]
    joints = {j["segment"]: j["kind"] for j in record.get("joints", [])}
    marks = [joints.get(i) for i in range(len(segments))]
    intervals = record["intervals"]
    n = len(segments)
    if how == "shift" and record["closed"]:
        k = intervals[len(intervals) // 3]["segments"][0]
        segments = segments[k:] + segments[:k]
        marks = marks[k:] + marks[:k]
    if how == "reverse":
        segments = [s[::-1] for s in segments[::-1]]
        marks = [marks[-i % n] for i in range(n)]
        if record["closed"]:  # the last point is the first now
            k = intervals[-1]["segments"][1] - intervals[-1]["segments"][0] + 1
            segments = segments[k:] + segments[:k]
            marks = marks[k:] + marks[:k]
    return segments, marks


def same(how, limit, one, other):
    if one["status"] != other["status"]:
        return False
    if one["status"] != "ok":
        return one["error"]["code"] == other["error"]["code"]
    wanted, marks = of_result(how, one)
    found, told = of_result("", other)
    points = [complex(*z) for s in wanted for z in s]
    size = max(abs(z - points[0]) for z in points)
    return len(found) == len(wanted) and marks == told and all(
        abs(complex(*a) - complex(*b)) <= limit * size
        for s, t in zip(wanted, found) for a, b in zip(s, t))


def main():
    how = sys.argv[1]
    if len(sys.argv) == 2:
        for line in sys.stdin:
            print(json.dumps(of_problem(how, json.loads(line))))
        return
    limit, n, others = float(sys.argv[2]), 0, []
    for one, other in zip(open(sys.argv[3]), open(sys.argv[4])):
        n += 1
        one, other = json.loads(one), json.loads(other)
        if not same(how, limit, one, other):
            others.append(one["id"])
    print(n, len(others), *others[:3])


main()
