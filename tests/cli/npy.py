# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether an array that phspline wrote is the table that it wrote as CSV, bit
by bit: npy.py ARRAY CSV.  Ids of the CSV are numbers of results."""

import csv
import sys

import numpy

array = numpy.load(sys.argv[1], allow_pickle=False)
with open(sys.argv[2], newline="") as file:
    rows = list(csv.reader(file))
names = ["result"] + rows[0][1:]
assert array.dtype.names == tuple(names), array.dtype.names
assert all(array.dtype[i] == numpy.float64 for i in range(len(names)))
assert array.shape == (len(rows) - 1,), array.shape
values = {"": float("nan"), "e2": 2.0, "e3": 3.0}
for i, name in enumerate(names):
    wanted = numpy.array(
        [values[r[i]] if r[i] in values else float(r[i]) for r in rows[1:]])
    assert numpy.array_equal(array[name], wanted, equal_nan=True), name
print(len(array))
