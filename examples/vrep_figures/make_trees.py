#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""make_trees.py FOLDER: writes the trees of the figures, which `veritope build` reads.

Coordinates are multiples of 1/64, so that the files do not depend on the mathematical library.
"""
import json
import math
import pathlib
import sys


def number(x):
    """An integer, or the text of a multiple of 1/64."""
    n = round(64 * x)
    if n % 64 == 0:
        return n // 64
    d = 64 // math.gcd(n, 64)
    return "%d/%d" % (n * d // 64, d)


def clamped(count, degree):
    """The knots of `count` control points, one apart inside."""
    inner = list(range(1, count - degree))
    return [0] * (degree + 1) + inner + [count - degree] * (degree + 1)


def shape(degrees, counts, at, knots=None):
    """A surface or a volume with the control points at(i, j, ...), the last index running first."""
    index, points = [()], []
    for n in counts:
        index = [i + (k,) for i in index for k in range(n)]
    for i in index:
        points.append([str(number(x)) for x in at(*i)])
    knots = knots or [clamped(n, p) for n, p in zip(counts, degrees)]
    return {"degrees": degrees, "periodic": [False] * len(degrees), "knots": [[str(k) for k in axis] for axis in knots],
            "rational": False, "components": 3, "points": points}


def box(low, high):
    return {"op": "box", "min": low, "max": high}


def patch(f, n=4):
    """A bicubic surface with the control points (3 i / (n - 1), 3 j / (n - 1), f(i, j))."""
    return shape([3, 3], [n, n], lambda i, j: (3 * i / (n - 1), 3 * j / (n - 1), f(i, j)))


def section(centre, side, up, half):
    """A square around a point, across a path: its sides are along two unit vectors."""
    def at(i, j):
        return [c + half * ((2 * i - 1) * s + (2 * j - 1) * u) for c, s, u in zip(centre, side, up)]
    return shape([1, 1], [2, 2], at)


def through_itself():
    """A bar along a loop that crosses itself in one plane."""
    sections = []
    for k in range(13):
        t = k / 6 - 1  # x and y of a folium
        x, y = 4 * t * (t * t - 0.55), 4.5 * (1 - t * t)
        dx, dy = 4 * (3 * t * t - 0.55), -9 * t
        length = math.hypot(dx, dy)
        sections.append(section((x, y, 0), (-dy / length, dx / length, 0), (0, 0, 1), 0.375))
    return {"op": "sweep", "sections": sections, "parameters": list(range(13)), "degree": 3, "mode": "interpolate"}


def pulled():
    """A box of 5 x 3 x 3 control points, whose three inner ones are far above its top."""
    def at(i, j, k):
        x = (0, 0.5, 1.5, 2.5, 3)[i]
        is_inner = 0 < i < 4 and j == 1 and k == 1
        return x, j / 2, 3 if is_inner else k / 2
    return {"op": "trivariate", "shape": shape([2, 2, 2], [5, 3, 3], at)}


def halves():
    """Two cells with a curved wall between them."""
    low = patch(lambda i, j: 0)
    wall = patch(lambda i, j: 1.25 + (0.9 if i in (1, 2) and j in (1, 2) else 0) - 0.3 * (i - j) / 3)
    high = patch(lambda i, j: 3)
    return {"op": "glue", "of": [{"op": "ruled", "surfaces": [low, wall]}, {"op": "ruled", "surfaces": [wall, high]}]}


def wavy(height, amplitude, turned=False):
    """A bicubic surface with a wave along one axis."""
    return patch(lambda i, j: height + amplitude * (-1) ** (j if turned else i) * ((j if turned else i) in (1, 2)))


def profile():
    """A planar surface beside the z-axis: a bent section."""
    return shape([2, 2], [3, 3], lambda i, j: (1 + j * 0.5 + (0.6 if i == 1 else 0), 0, i * 1.0))


def bowed_faces():
    """Six faces of a box with edges that bow; each is a function of the other two axes of its cell."""
    def point(u, v, w):
        bow = [x * (2 - x) for x in (u, v, w)]  # the middle control points of an axis, 0 to 2
        x, y, z = 1.5 * u, 1.5 * v, 1.5 * w
        return (x + 0.6 * (1 - u) * (bow[1] + bow[2]), y - 0.45 * bow[0] * (v == 0),
                z + 0.5 * (bow[0] * bow[1]) * (w == 2))

    def face(axis, end):
        def at(i, j):
            p = [i, j]
            p.insert(axis, end)
            return point(*p)
        return shape([2, 2], [3, 3], at)
    return {"op": "boolean-sum", "faces": {"uvw"[a] + "01"[e]: face(a, 2 * e) for a in range(3) for e in range(2)}}


def swept():
    """Sections along a path, each larger and more turned than the one before it."""
    sections = []
    for k in range(6):
        a, half = 0.35 * k, 0.35 + 0.09 * k
        centre = (1.4 * k, 1.2 * math.sin(0.8 * k), 0.3 * k)
        sections.append(section(centre, (0, math.cos(a), math.sin(a)), (0, -math.sin(a), math.cos(a)), half))
    return {"op": "sweep", "sections": sections, "parameters": list(range(6)), "degree": 3, "mode": "interpolate"}


def duck():
    """Closed rings along a spine: four cubic arcs each, which join smoothly."""
    spine = [(-5.0, 1.9, 0.2), (-4.4, 1.5, 0.6), (-3.3, 0.6, 1.2), (-1.6, 0.0, 1.7), (0.4, 0.0, 1.75), (1.9, 0.9, 1.3),
             (2.4, 2.3, 0.8), (2.35, 3.4, 0.75), (2.7, 4.3, 1.0), (3.7, 4.6, 0.85), (4.6, 4.35, 0.42),
             (5.4, 4.15, 0.4), (5.9, 4.1, 0.3)]
    arm = 9 / 16

    def ring(k):
        x, z, r = spine[k]
        before, after = spine[max(k - 1, 0)], spine[min(k + 1, len(spine) - 1)]
        dx, dz = after[0] - before[0], after[1] - before[1]
        length = math.hypot(dx, dz)
        up = (-dz / length, dx / length)
        flat = (0.5 if k >= len(spine) - 3 else 1) * r  # the bill is flat
        corners = [(1, 0), (0, 1), (-1, 0), (0, -1)]

        def at(u, v):  # in multiples of 1/32, so that middles are multiples of 1/64
            return [round(32 * p) / 32 for p in (x + flat * v * up[0], r * u, z + flat * v * up[1])]
        handles = []
        for q in range(4):
            (a, b), (c, d) = corners[q], corners[(q + 1) % 4]
            handles += [at(a + arm * c, b + arm * d), at(c + arm * a, d + arm * b)]
        # The ring passes through the middle of two handles: it is smooth there.
        begin = [(p + q) / 2 for p, q in zip(handles[0], handles[-1])]
        return [begin, *handles, begin]
    rings = [ring(k) for k in range(len(spine))]
    knots = [[0] * 4 + [1, 1, 2, 2, 3, 3] + [4] * 4, clamped(len(spine), 3)]
    return shape([3, 3], [10, len(spine)], lambda i, j: rings[j][i], knots)


def trees():
    yield "1a", through_itself()
    yield "1a_halves", {"op": "split", "axis": "w", "at": 6, "of": through_itself()}
    yield "1b", pulled()
    yield "1b_cut", {"op": "split", "axis": "v", "at": "1/2", "of": pulled()}
    yield "2", halves()
    yield "3", {"op": "glue", "of": [box([0, 0, 0], [1, 1, 1]), box([1, 0, 0], [2, 1, 1]), box([0, 1, 0], [1, 2, 1])]}
    yield "7a", {"op": "extrude", "surface": wavy(0, 1.5), "vector": ["1/2", "1/2", 2]}
    yield "7b", {"op": "ruled", "surfaces": [wavy(0, 1), wavy(2, 1, True)]}
    yield "7c", {"op": "revolve", "surface": profile(), "point": [0, 0, 0], "axis": [0, 0, 1], "degrees": 240}
    yield "7d", bowed_faces()
    yield "7e", swept()
    yield "8a", {"op": "cylinder", "radius": 1, "height": 2, "cells": "one"}
    yield "8b", {"op": "sphere", "radius": 1, "cells": "one"}
    yield "9a", {"op": "cylinder", "radius": 1, "height": 2}
    yield "9b", {"op": "cone", "bottom": 1, "top": "1/3", "height": 2}
    yield "9c", {"op": "torus", "major": 3, "minor": 1}
    yield "9c_cut", {"op": "split", "axis": "w", "at": 2, "of": {"op": "torus", "major": 3, "minor": 1}}
    yield "9d", {"op": "sphere", "radius": 1}
    yield "13", {"op": "tube", "surface": duck()}
    yield "13_cut", {"op": "split", "axis": "w", "at": 5, "of": {"op": "tube", "surface": duck()}}


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, root in trees():
        text = json.dumps({"format": "veritope-tree-1", "root": root}, separators=(",", ":"))
        (folder / f"figure{name}.tree").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
