#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Microstructures of tests/models/micro, in the canonical form of docs/formats/micro-files.md.

usage: micro_models.py FOLDER      writes them there
"""
import itertools
import json
import pathlib
import sys
from fractions import Fraction

WHOLE = 2**20


def text(items):
    """A list of numbers, or of lists of them."""
    return "[" + ", ".join(text(i) if isinstance(i, (list, tuple)) else f'"{i}"' for i in items) + "]"


def integers(items):
    return "[" + ",".join(map(str, items)) + "]"


def lines(items):
    items = list(items)
    return "[\n" + ",\n".join(items) + "]" if items else "[]"


def volume(corners, knots=((0, 0, 1, 1),) * 3, degrees=(1, 1, 1)):
    """A volume of the cage from its points, the last axis fastest."""
    rows = ",\n   ".join(text(p) for p in corners)
    axes = ",\n   ".join(text(k) for k in knots)
    return ('{"kind": "volume", "group": null, "attributes": [],\n "shape": {"degrees": [' + ", ".join(map(str, degrees)) +
            '], "periodic": [false, false, false],\n  "knots": [' + axes + '],\n  "rational": false, "components": 3,\n  "points": [' +
            rows + "]}}")


def micro(cage, grids, tiles, cells, walls, model=None):
    """The bytes of a file. cage: texts of volumes; grids: (volume, breaks); tiles: texts; cells: lists of strings; walls: lists of three."""
    name = "null" if model is None else f'{{"name": {json.dumps(model[0])}, "sha256": "{model[1]}"}}'
    return ('{"format": "veritope-micro-1",\n"model": ' + name + ',\n"cage": {"format": "veritope-spline-1",\n"groups": [],\n"entities": [' +
            ",\n ".join(cage) + ']},\n"grids": ' +
            lines(f'{{"volume": {v}, "breaks": {text(breaks)}}}' for v, breaks in grids) +
            ',\n"tiles": ' + lines(tiles) + ',\n"cells": ' + lines(text(c) for c in cells) + ',\n"walls": ' +
            lines("[" + ", ".join(integers(axis) for axis in grid) + "]" for grid in walls) + "}\n")


def patch(points, wall=None):
    """A bilinear patch; points: lists of four, one for each power of t."""
    return f'{{"wall": {"null" if wall is None else wall}, "degrees": [1,1], "points": {text(points)}}}'


def tile(name, patches, limits=None):
    return f'{{"name": "{name}", "range": {"null" if limits is None else integers(limits)}, "patches": [{", ".join(patches)}]}}'


def outward(square, centre):
    """The square with the corners 00, 01, 10, 11, turned so that its normal points away from the centre."""
    a, b, c, _ = square
    u, v = [x - y for x, y in zip(c, a)], [x - y for x, y in zip(b, a)]
    normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    turns = sum(n * (x - m) for n, x, m in zip(normal, a, centre)) < 0
    return [0, 2, 1, 3] if turns else [0, 1, 2, 3]


def cube(name="cube", low=Fraction(1, 4), high=Fraction(3, 4)):
    patches = []
    for axis, end in itertools.product(range(3), (low, high)):
        square = [list(p) for p in itertools.product((low, high), repeat=2)]
        square = [p[:axis] + [end] + p[axis:] for p in square]
        patches.append(patch([[square[i] for i in outward(square, 3 * [(low + high) / 2])]]))
    return tile(name, patches)


def post(name="post", limits=(0, WHOLE)):
    """A square bar along axis 0: from its middle, where its half width is 1/4, to each end, where it is 1/8 + t / 8."""
    middle = [(y, z) for y in (-1, 1) for z in (-1, 1)]
    half, base, slope = Fraction(1, 2), Fraction(1, 8), Fraction(1, 8)

    def end(x, c):
        return [x] + [half + base * s for s in c], [0] + [slope * s for s in c]

    def inner(c):
        return [half] + [half + Fraction(1, 4) * s for s in c], [0, 0, 0]

    patches = []
    for wall, x in ((0, 0), (1, 1)):
        sides = [[end(x, c) for c in middle]]
        for axis, s in itertools.product(range(2), (-1, 1)):
            edge = [c for c in middle if c[axis] == s]
            sides.append([end(x, edge[0]), end(x, edge[1]), inner(edge[0]), inner(edge[1])])
        for side in sides:
            order = outward([p for p, _ in side], [half] * 3)
            patches.append(patch([[side[i][k] for i in order] for k in range(2)], wall))
    return tile(name, patches, limits)


def three_cells(**changes):
    """A bar of three cells in one volume with a knot: two posts and a cube."""
    corners = [[x, y + Fraction(x, 4), z] for x in (0, 1, 3) for y in (0, 1) for z in (0, 1)]
    parts = {"cage": [volume(corners, ((0, 0, 1, 3, 3), (0, 0, 1, 1), (0, 0, 1, 1)))],
             "grids": [(0, [[0, 1, 2, 3], [0, 1], [0, 1]])], "tiles": [post(), cube()], "cells": [["c", "2"]],
             "walls": [([WHOLE // 2, WHOLE // 4, WHOLE, 0], 6 * [0], 6 * [0])],
             "model": ("a bar", 64 * "0")}
    return micro(**{**parts, **changes})


MODELS = {"three_cells.vmicro": three_cells(),
          "two_tiles_in_a_cell.vmicro": three_cells(cells=[["c", "6"]])}

if __name__ == "__main__":
    for name, model in MODELS.items():
        (pathlib.Path(sys.argv[1]) / name).write_text(model)
