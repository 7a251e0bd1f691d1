#!/usr/bin/env python3
"""Where sampling misses what the check proves.

Sampled checks ask a collision library for the depth at poses along each move, and often only at the vertices of the
mesh. This example does the same in plain NumPy (a ball end mill, so that the distance of a point to the tool is exact)
and, where they are installed, with trimesh and python-fcl; then it asks the certified check.

The scene: a plate with a thin pin, 0.2 mm wide, and a path of 5 mm steps that runs through it, and a rotation about a
resting tip that is right at both ends and wrong between.
"""

import numpy as np

import gougecheck
from lead_angle import box

RADIUS, LENGTH = 3.0, 40.0


def depth_of_points(points, tip, axis):
    """The largest depth of the points in a ball end mill that is a capsule: exact, for these points and this pose."""
    start = tip + RADIUS * axis
    along = np.clip((points - start) @ axis, 0, LENGTH)
    distance = np.linalg.norm(points - start - along[:, None] * axis, axis=1)
    return max(0.0, float((RADIUS - distance).max()))


def sampled_numpy(vertices, faces, tips, axes, per_move):
    """Vertices of the mesh against poses: what many checkers do."""
    worst = 0.0
    for i in range(1, len(tips)):
        for t in np.linspace(0, 1, per_move):
            axis = (1 - t) * axes[i - 1] + t * axes[i]
            tip = (1 - t) * tips[i - 1] + t * tips[i]
            worst = max(worst, depth_of_points(vertices, tip, axis / np.linalg.norm(axis)))
    return worst


def sampled_fcl(vertices, faces, tips, axes, per_move):
    """Triangles against poses: whole surfaces, but instants alone."""
    import fcl

    model = fcl.BVHModel()
    model.beginModel(len(vertices), len(faces))
    model.addSubModel(vertices, faces)
    model.endModel()
    part = fcl.CollisionObject(model)
    capsule = fcl.Capsule(RADIUS, LENGTH)
    hits = 0
    for i in range(1, len(tips)):
        for t in np.linspace(0, 1, per_move):
            axis = (1 - t) * axes[i - 1] + t * axes[i]
            axis /= np.linalg.norm(axis)
            centre = (1 - t) * tips[i - 1] + t * tips[i] + (RADIUS + LENGTH / 2) * axis
            side = np.cross(axis, [0, 1, 0])
            side /= np.linalg.norm(side)
            rotation = np.stack([side, np.cross(axis, side), axis], axis=1)
            tool = fcl.CollisionObject(capsule, fcl.Transform(rotation, centre))
            hits += fcl.collide(part, tool, fcl.CollisionRequest(), fcl.CollisionResult()) > 0
    return hits


def scenes():
    plate, faces = box((0, 0, -5), (50, 20, 0))
    pin = box((22.4, 9.9, 0), (22.6, 10.1, 8))
    vertices = np.concatenate([plate, pin[0]])
    both = np.concatenate([faces, pin[1] + len(plate)])
    x = np.arange(0.0, 51.0, 5.0)
    tips = np.stack([x, np.full_like(x, 10.0), np.full_like(x, 7.5)], axis=1)
    yield "a pin between two positions", vertices, both, tips, np.tile([0.0, 0.0, 1.0], (len(x), 1))

    wall, faces = box((-1, -40, 20), (1, 40, 22))  # a bar above: no vertex is near the tool
    tips = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    axes = np.array([[-0.6, 0.0, 0.8], [0.6, 0.0, 0.8]])
    yield "a rotation about a resting tip", wall, faces, tips, axes


def main():
    tool = gougecheck.Tool.ball(diameter=2 * RADIUS, length=RADIUS + LENGTH)
    for name, vertices, faces, tips, axes in scenes():
        print(name)
        for per_move in (2, 5):
            depth = sampled_numpy(vertices, faces, tips, axes, per_move)
            print(f"  vertices at {per_move} poses a move: {depth:.3f} mm")
        try:
            hits = sampled_fcl(vertices, faces, tips, axes, 2)
            print(f"  python-fcl at 2 poses a move: {hits} collisions")
        except ImportError:
            print("  python-fcl: not installed")
        report = gougecheck.check(gougecheck.Path(tips, axes), gougecheck.Mesh(vertices, faces), tool)
        worst = int(np.nanargmax(report.depth))
        print(f"  the check: {report.depth[worst]:.3f} to {report.depth_upper[worst]:.3f} mm, in move {worst} at t = "
              f"{report.t[worst]:.3f}, {gougecheck.state_name(report.state[worst])}")


if __name__ == "__main__":
    main()
