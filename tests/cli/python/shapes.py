"""Meshes and paths whose answers are known by hand."""

import numpy as np

FACES = np.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7],
                  [2, 7, 6], [3, 0, 4], [3, 4, 7]])
VERTICES = np.array([[x, y, z] for z in (-10.0, 0.0) for x, y in ((0, 0), (40, 0), (40, 20), (0, 20))])
UP = np.array([0.0, 0.0, 1.0])

#: Once above a block whose top is z = 0, once 0.25 mm into it.
TIPS = np.array([[-10, 10, 0.5], [50, 10, 0.5], [50, 12, 5], [50, 12, -0.25], [-10, 12, -0.25]])
