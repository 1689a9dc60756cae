# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh of a surface must be, read from Wavefront OBJ by another program.

    python3 obj.py FILE.obj BOUNDARIES

Prints a line for each object: how many closed boundaries it has, the largest
angle between a normal and that of a face beside it, and by how much the flat
coordinates, if there are any, stretch an edge, both in parts of a thousand.  Fails unless every
edge has two faces, that run along it in opposite directions, or lies on a
boundary; normals are unit vectors; and there are as many boundaries as wanted.
"""
import math
import sys


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def size(a):
    return math.sqrt(dot(a, a))


def boundaries(faces):
    """How many closed lines the edges with one face make."""
    edges = set()
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            edge = (a[0], b[0])
            assert edge not in edges, f"edge {edge} twice in one direction"
            edges.add(edge)
    next_of = {}
    for a, b in edges:
        if (b, a) not in edges:
            assert a not in next_of, f"two boundaries at vertex {a}"
            next_of[a] = b
    lines = 0
    while next_of:
        start, at = next_of.popitem()
        while at != start:
            at = next_of.pop(at)
        lines += 1
    return lines


def check(name, data, faces, wanted):
    v, vt, vn = data["v"], data["vt"], data["vn"]
    angle = stretch = 0.0
    assert all(abs(size(n) - 1) < 1e-14 for n in vn), "a normal is no unit vector"
    for face in faces:
        p = [v[corner[0]] for corner in face]
        normal = cross(sub(p[2], p[0]), sub(p[3], p[1]))
        for corner in face:
            c = dot(normal, vn[corner[2]]) / size(normal)
            angle = max(angle, math.acos(min(1.0, c)))
        for a, b in zip(face, face[1:] + face[:1]):
            if a[1] is None:
                continue
            length = size(sub(v[a[0]], v[b[0]]))
            flat = size(sub(vt[a[1]], vt[b[1]]))
            stretch = max(stretch, abs(flat / length - 1))
    lines = boundaries(faces)
    print(name, lines, round(angle * 1e3), round(stretch * 1e3))
    assert lines == wanted, f"{lines} boundaries, not {wanted}"


def main():
    data = {"v": [], "vt": [], "vn": []}
    objects = []
    for line in open(sys.argv[1], encoding="ascii"):
        word, *rest = line.split()
        if word == "o":
            objects.append((rest[0], []))
        elif word == "f":
            # from 1, or from the last one back
            kinds = ("v", "vt", "vn")
            objects[-1][1].append([tuple(
                None if not i else
                int(i) - 1 if int(i) > 0 else len(data[kind]) + int(i)
                for i, kind in zip(corner.split("/"), kinds)) for corner in rest])
        elif word in data:
            data[word].append([float(x) for x in rest])
    assert objects, "no object"
    for name, faces in objects:
        check(name, data, faces, int(sys.argv[2]))


main()
