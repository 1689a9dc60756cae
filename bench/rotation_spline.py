# SPDX-License-Identifier: GPL-3.0-or-later
"""RotationSpline of SciPy, a C2 spline of rotations, built through samples of
a smooth motion: for each N a line `N SECONDS', processor time, best of a few."""
import time

import numpy as np
from scipy.spatial.transform import Rotation, RotationSpline

for n, rounds in (1000, 7), (10000, 7), (100000, 3), (1000000, 1):
    t = 0.063 * np.arange(n)
    angles = np.column_stack((t, 0.4 * np.sin(0.7 * t), 0 * t))
    rotations = Rotation.from_euler("ZYX", angles)
    best = np.inf
    for _ in range(rounds):
        start = time.process_time()
        RotationSpline(t, rotations)
        best = min(best, time.process_time() - start)
    print(n, best)
