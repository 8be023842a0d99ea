#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""make_models.py FOLDER: the domains, points and scripts of figures.py, all of our own: exact rational numbers."""
import itertools
import json
import math
import pathlib
import random
import sys
from fractions import Fraction as F

ORDERS = list(itertools.permutations(range(3)))


def determinant(a, b, c, d):
    u, v, w = ([q - p for p, q in zip(a, x)] for x in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
            u[2] * (v[0] * w[1] - v[1] * w[0]))


class Domain:
    """Kuhn's six tetrahedra in each cell of a grid, whose nodes have a key and a place."""

    def __init__(self):
        self.number, self.places, self.tetrahedra = {}, [], []

    def node(self, key, place):
        if key not in self.number:
            self.number[key] = len(self.places)
            self.places.append(tuple(F(x) for x in place))
        return self.number[key]

    def cell(self, at, key_of, place_of):
        for order in ORDERS:
            corner, nodes = list(at), []
            for axis in (None, *order):
                if axis is not None:
                    corner[axis] += 1
                nodes.append(self.node(key_of(*corner), place_of(*corner)))
            if determinant(*(self.places[i] for i in nodes)) < 0:
                nodes[2], nodes[3] = nodes[3], nodes[2]
            self.tetrahedra.append(nodes)

    def write(self, path, attributes=None):
        """The identity of degree 1; attributes: name -> function of a place."""
        attributes = attributes or {}
        text = lambda x: str(F(x).limit_denominator(1 << 20)) if isinstance(x, float) else str(x)
        document = {"format": "veritope-dms-1", "degree": 1, "attributes": list(attributes),
                    "vertices": [[[str(x) for x in p]] for p in self.places], "tetrahedra": self.tetrahedra,
                    "control": [{"at": [i], "value": [str(x) for x in p] + [text(f(p)) for f in attributes.values()]}
                                for i, p in enumerate(self.places)]}
        path.write_text(json.dumps(document))


def box(size, low=(0, 0, 0), high=(1, 1, 1), keep=lambda *_: True):
    domain = Domain()
    place = lambda *c: [F(l) + F(k, n) * (F(h) - F(l)) for l, h, k, n in zip(low, high, c, size)]
    for at in itertools.product(*map(range, size)):
        if keep(*at):
            domain.cell(at, lambda *c: c, place)
    return domain


HEXAGON = [(4, 0), (2, F(7, 2)), (-2, F(7, 2)), (-4, 0), (-2, F(-7, 2)), (2, F(-7, 2))]


def hexagon(u):
    """u from 0 to 6: once around."""
    side = int(u) % 6
    t = u - int(u)
    a, b = HEXAGON[side], HEXAGON[(side + 1) % 6]
    return a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])


def ring(around, across, domain=None, name=0, move=(0, 0, 0), scale=1):
    """A torus with six corners: around x across x across cells."""
    domain = domain or Domain()

    def place(i, j, k):
        x, y = hexagon(F(6 * (i % around), around))
        s = F(3, 4) + F(j, 2 * across)
        return [scale * v + m for v, m in zip((s * x, s * y, F(2 * k, across) - 1), move)]

    for at in itertools.product(range(around), range(across), range(across)):
        domain.cell(at, lambda i, j, k: (name, i % around, j, k), place)
    return domain


def points(path, rows):
    path.write_text("".join(" ".join(repr(x) for x in row) + "\n" for row in rows))


def cube_points(n, value, seed):
    draw = random.Random(seed)
    rows = []
    for _ in range(n):
        p = [draw.randrange(1 << 20) / (1 << 20) for _ in range(3)]
        rows.append((*p, value(*p)))
    return rows


def shell(x, y, z):
    """Dense within a ball around the middle, with a quick change: the data of figures 7, 9 and 10."""
    return 0.5 + 0.5 * math.tanh(25 * (0.3 - math.dist((x, y, z), (0.5, 0.5, 0.5))))


def scan_points(cells, seed):
    """One point in each cell of a grid, near its middle: what a scan gives."""
    draw = random.Random(seed)
    return [tuple((i + draw.uniform(0.35, 0.65)) / cells for i in at)
            for at in itertools.product(range(cells), repeat=3)]


def cross(x, y, z):
    """Kinked on a plane: figure 12."""
    return abs(x + y / 2 - z / 4 - 0.6)


HARE = [((8, 9, 7), (6, 4, 4)), ((14, 9, 12), (3, 3, 3)), ((12, 6, 16), (2, 1, 4)), ((12, 12, 16), (2, 1, 4))]


def hare(p):
    """Higher than 1 in a body, a head and two ears, ellipsoids in a box of 20: the animal of figure 6."""
    return sum(2 / (1 + sum(((a - m) / h)**2 for a, m, h in zip(p, middle, half))**2) for middle, half in HARE)


def waves(x, y, z):
    """Figure 11."""
    return 0.5 + 0.25 * math.sin(9 * x) * math.cos(7 * y) + 0.25 * math.sin(8 * z + 3 * x)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    one = Domain()
    one.places = [tuple(map(F, p)) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    one.tetrahedra = [[0, 1, 2, 3]]
    one.write(folder / "one.vdms", {"basis": lambda p: 0})
    ring(18, 2).write(folder / "ring.vdms", {"density": lambda p: F(1, 10), "height": lambda p: p[2]})
    five = Domain()
    for n in range(5):
        ring(12, 1, five, n, (F(9 * n, 2), F(9 * (n % 2), 4), 0), F(1, 2))
    five.write(folder / "five.vdms", {"along": lambda p: p[0] / 18})
    box((4, 4, 4)).write(folder / "cube.vdms", {"a": lambda p: 0})
    bars = box((9, 9, 9), keep=lambda *c: sum(3 <= k < 6 for k in c) >= 2)
    bars.write(folder / "bars.vdms", {"a": lambda p: 0})
    animal = box((12, 11, 13), (0, 0, 0), (20, 18, 22))
    animal.write(folder / "hare.vdms", {"inside": lambda p: hare(tuple(map(float, p)))})
    box((3, 3, 3)).write(folder / "small_cube.vdms", {"a": lambda p: 0})
    points(folder / "shell.txt", cube_points(6000, shell, 7))
    points(folder / "waves.txt", cube_points(6000, waves, 11))
    inside = lambda row: sum(1 / 3 <= x <= 2 / 3 for x in row[:3]) >= 2
    rows = [row for row in cube_points(60000, cross, 12) if inside(row)][:6000]
    points(folder / "cross.txt", rows)
    scan = list(filter(inside, scan_points(20, 8)))
    points(folder / "cross_points.txt", scan)
    points(folder / "cross_scan.txt", [(*p, cross(*p)) for p in scan])


if __name__ == "__main__":
    main()
