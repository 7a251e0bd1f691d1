#!/usr/bin/env python3
"""Finds the least lead angle with which a holder clears a wall, by bisection on certified checks.

A ball end mill runs along the foot of a wall that is higher than its stick-out. Tilted towards the free side the holder
clears the wall; every angle that is tried is checked over the whole motion, so the answer is proved, not sampled.
"""

import numpy as np

import gougecheck


def box(low, high):
    """A box as vertices (8, 3) and faces (12, 3)."""
    vertices = np.array([[x, y, z] for z in (low[2], high[2])
                         for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))],
                        dtype=float)
    faces = np.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7],
                      [2, 7, 6], [3, 0, 4], [3, 4, 7]])
    return vertices, faces


def main():
    part = [gougecheck.Mesh(*box((0, 0, -10), (100, 60, 0)), "floor"),
            gougecheck.Mesh(*box((0, 60, -10), (100, 80, 60)), "wall")]
    scene = gougecheck.Scene(part)
    tool = gougecheck.Tool.ball(diameter=10, length=20, shank=[(10, 10, 20)], holder=[(40, 50, 60)])
    contact = np.linspace([10, 50, 0.02], [90, 50, 0.02], 9)  # the ball touches the floor here

    def report_at(degrees):
        angle = np.radians(degrees)
        axis = np.array([0.0, -np.sin(angle), np.cos(angle)])
        centre = contact + [0, 0, 5]  # of the ball, which the tilt does not move
        return gougecheck.check(gougecheck.Path(centre - 5 * axis, axis), scene, tool)

    low, high = 0.0, 60.0
    assert not report_at(low).is_clean, "nothing to optimise"
    assert report_at(high).is_clean, "no angle up to 60 degrees clears the wall"
    while high - low > 0.01:
        middle = (low + high) / 2
        if report_at(middle).is_clean:
            high = middle
        else:
            low = middle
    worst = report_at(low)
    print(f"least lead angle: {high:.2f} degrees; at {low:.2f} degrees {worst.verdict}, {worst.worst_depth:.3f} mm")


if __name__ == "__main__":
    main()
