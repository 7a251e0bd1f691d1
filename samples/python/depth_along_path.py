#!/usr/bin/env python3
"""Plots how deep a tool is along a path: what each move is certified for, and where the positions alone would look.

Usage: depth_along_path.py [PICTURE.png]    without a file, a window
"""

import sys

import matplotlib

if len(sys.argv) > 1:
    matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import gougecheck


def wavy_part(size=60.0, n=60):
    """A surface z = sin x cos y, 3 mm high, as vertices (n, 3) and faces (m, 3)."""
    x, y = np.meshgrid(np.linspace(0, size, n + 1), np.linspace(0, size, n + 1), indexing="ij")
    z = 3 * np.sin(x / 6) * np.cos(y / 9)
    vertices = np.ascontiguousarray(np.stack([x, y, z], axis=-1).reshape(-1, 3))
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    faces = np.concatenate([np.stack([corner, corner + n + 1, corner + n + 2], axis=1),
                            np.stack([corner, corner + n + 2, corner + 1], axis=1)])
    return gougecheck.Mesh(vertices, faces, "wavy part")


def main():
    mesh = wavy_part()
    tool = gougecheck.Tool.ball(diameter=8, length=20, shank=[(8, 8, 30)], holder=[(30, 30, 30)])
    x = np.linspace(2, 58, 57)
    tips = np.stack([x, np.full_like(x, 30.0), 3 * np.sin(x / 6) * np.cos(30 / 9) + 0.05], axis=1)
    axis = np.array([0.2, 0.0, 1.0])

    report = gougecheck.check(gougecheck.Path(tips, axis), mesh, tool)
    positions = gougecheck.depth(mesh, tool, tips, axis)
    print(report)

    move = np.arange(len(report))
    figure, axes = plt.subplots(figsize=(9, 4.5), constrained_layout=True)
    axes.fill_between(move, report.depth, report.depth_upper, step="mid", color="tab:red", alpha=0.25,
                      label="between proved and certified")
    axes.step(move, report.depth, where="mid", color="tab:red", label="whole move")
    axes.plot(move, positions.depth, ".", color="tab:blue", clip_on=False, label="positions alone")
    axes.axhline(0.01, color="0.4", linewidth=0.8, linestyle="--", label="tolerance")
    axes.set(xlabel="move", ylabel="depth in mm (positive: inside)", title="Depth along the path", xlim=(0, move[-1]))
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, loc=(0.45, 0.68))
    axes.spines[["top", "right"]].set_visible(False)
    if len(sys.argv) > 1:
        figure.savefig(sys.argv[1], dpi=120)
    else:
        plt.show()


if __name__ == "__main__":
    main()
