# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Microstructures with bridges or sweeps, and with tiles that star boxes prove, with their certificates, whatever they say: tests only."""
import copy
import functools
import itertools
import json
import pathlib
import sys
from fractions import Fraction as Q

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "checker_py"))
import micro_examples as examples                         # noqa: E402
import star_box_2_forge as forge2                         # noqa: E402
import star_box_forge as forge                            # noqa: E402

OTHERS = examples.OTHERS


# ---------------------------------------------------------------- tiles of voxels

FIRST_SECOND = ((1, 2), (2, 0), (0, 1))                   # the axes in a face across each axis, so that with it they are right-handed


def voxel_tile(n, voxels, name="voxels"):
    """The union of these cubes of the lattice n x n x n, a patch for each square of its surface, range null. Patch k starts anywhere."""
    voxels, vertices, quads = set(voxels), {}, []
    for v in sorted(voxels):
        for axis, end in itertools.product(range(3), (0, 1)):
            beside = tuple(x + (2 * end - 1 if a == axis else 0) for a, x in enumerate(v))
            if beside in voxels:
                continue
            first, second = FIRST_SECOND[axis][::1 if end else -1]
            quad = []
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(v)
                corner[axis] += end
                corner[first] += i
                corner[second] += j
                quad.append(tuple(corner))
                vertices[quad[-1]] = None, tuple(Q(x, n) for x in corner), (0, 0, 0)
            quads.append(tuple(quad))
    return examples.Tile(vertices, quads, None, name=name)


U_SHAPE = [(0, 1, 2), (1, 1, 2), (2, 1, 2), (3, 1, 2), (3, 2, 2), (3, 3, 2), (2, 3, 2), (1, 3, 2), (0, 3, 2)]
RING = [(i, j, 2) for i in (1, 2, 3) for j in (1, 2, 3) if (i, j) != (2, 2)]


class Boxes:
    """Proof 1 of a tile. plan: of star_box_2_forge.py."""

    def __init__(self, plan):
        self.plan = plan

    def body(self):
        made = self.plan if isinstance(self.plan, bytes) else self.plan.body()
        return b"\1" + forge.u32(len(made)) + made


class Split(forge2.Plan2):
    """Star boxes of patches that are cut at 1/2, which F3 forbids."""

    def __init__(self, given, unit):
        super().__init__(given, unit)
        for axes in self.breaks:
            for axis in axes:
                axis.insert(1, Q(1, 2))


class SplitProver(forge2.Prover2):
    plan_kind = Split


def surfaces_of(tile):
    found = []
    for _, (p, q), lists in tile.patches:
        found.append(forge.surface([lists[0][i * (q + 1):(i + 1) * (q + 1)] for i in range(p + 1)], (p, q)))
    return found


def boxes_of(tile, flags=None):
    """A proof by star boxes, found in the tests' own way."""
    return Boxes(forge2.Prover2(surfaces_of(tile), flags=flags, search=True).prove().plan)


@functools.lru_cache(None)
def voxels_proved(n, voxels):
    tile = voxel_tile(n, voxels)
    return tile, boxes_of(tile)


# ---------------------------------------------------------------- bridges

class Bridge:
    """points: {(i, j, k): point}"""

    def __init__(self, grid, cell, wall, volume, degrees, points, matrix=None, cuts=()):
        self.grid, self.cell, self.wall, self.volume, self.degrees, self.points = grid, cell, wall, volume, degrees, dict(points)
        self.matrix, self.cuts = matrix or inverse(jacobian(self.points, degrees)), list(cuts)

    def changed(self, **fields):
        new = copy.copy(self)
        new.points = dict(self.points)
        for key, value in fields.items():
            setattr(new, key, value)
        return new

    def order(self):
        p, q = self.degrees
        return itertools.product(range(p + 1), range(q + 1), range(3))

    def moved(self, k, move):
        """With the points of list k replaced by move(point)."""
        return self.changed(points={at: tuple(move(point)) if at[2] == k else point for at, point in self.points.items()})

    def json(self):
        return json.dumps({"grid": self.grid, "cell": self.cell, "wall": self.wall, "volume": self.volume, "degrees": list(self.degrees),
                           "points": [[str(c) for c in self.points[at]] for at in self.order()]})

    def hint(self):
        return b"".join([*(forge.rational(c) for row in self.matrix for c in row), bytes([len(self.cuts) + 1]), *map(forge.rational, self.cuts)])


def jacobian(points, degrees):
    """The differences along the three axes at a corner, as columns."""
    steps = [tuple(b - a for a, b in zip(points[0, 0, 0], points[at])) for at in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return [list(row) for row in zip(*steps)]


def inverse(m):
    """The inverse of a matrix; the unit matrix if it does not exist."""
    rows = [[Q(c) for c in row] + [Q(i == j) for j in range(3)] for i, row in enumerate(m)]
    for c in range(3):
        pivot = next((r for r in range(c, 3) if rows[r][c]), None)
        if pivot is None:
            return [[Q(i == j) for j in range(3)] for i in range(3)]
        rows[c], rows[pivot] = rows[pivot], rows[c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for r in range(3):
            if r != c:
                rows[r] = [x - rows[r][c] * y for x, y in zip(rows[r], rows[c])]
    return [row[3:] for row in rows]


def straight(plan, grid, cell, wall, end, across=None, cuts=()):
    """A bridge from the wall's first cap of one patch to the plane in which the coordinate across the wall is `end`. across: brings points from
    the parameters of the cell's volume to those of the other side: (volume, axis, map)."""
    tile, numbers = plan.tiles[plan.cells[grid][cell]], plan.numbers(grid, cell)
    n = tile.caps(wall)[0]
    driver, (p, q), lists = tile.patches[n]
    t = Q(numbers[driver], examples.UNIT) if driver is not None else Q(0)
    points = [tuple(sum(c * t ** k for k, c in enumerate(values)) for values in zip(*at)) for at in zip(*lists)]
    points = [plan.parameters(grid, cell, point) for point in points]
    volume, axis, place = across or (plan.grids[grid][0], wall // 2, lambda point: point)
    first, found = [place(point) for point in points], {}
    if is_left_handed(first, q, axis, end):
        first, (p, q) = [first[i * (q + 1) + j] for j in range(q + 1) for i in range(p + 1)], (q, p)
    for i, j, k in itertools.product(range(p + 1), range(q + 1), range(3)):
        point = list(first[i * (q + 1) + j])
        point[axis] += (Q(end) - point[axis]) * Q(k, 2)
        found[i, j, k] = tuple(point)
    return Bridge(grid, cell, wall, volume, (p, q), found, cuts=cuts)


def is_left_handed(first, q, axis, end):
    u, v = ([b - a for a, b in zip(first[0], first[n])] for n in (q + 1, 1))
    a, b = [(axis + k) % 3 for k in (1, 2)]
    return (u[a] * v[b] - u[b] * v[a]) * (end - first[0][axis]) < 0


# ---------------------------------------------------------------- sweeps

class Sweep:
    """The image of the cap of a cell's wall, along the curve with the Bezier points 0, e, f."""

    def __init__(self, grid, cell, wall, e, f, matrix, depth, speed):
        self.grid, self.cell, self.wall, self.e, self.f = grid, cell, wall, tuple(e), tuple(f)
        self.matrix, self.depth, self.speed = matrix, depth, speed

    def changed(self, **fields):
        new = copy.copy(self)
        for key, value in fields.items():
            setattr(new, key, value)
        return new

    def json(self):
        return json.dumps({"grid": self.grid, "cell": self.cell, "wall": self.wall,
                           "axis": [[str(c) for c in self.e], [str(c) for c in self.f]]})

    def hint(self):
        return b"".join(map(forge.rational, [*(c for row in self.matrix for c in row), self.depth, self.speed]))


def swept(plan, grid, cell, wall, length, bend=(0, 0, 0), depth=Q(1, 4)):
    """A sweep that leaves the middle of the wall in the direction of the cage's axis across it. length: in the parameters of the cage; bend: is
    added to f."""
    axis, sign = wall // 2, 1 if wall % 2 else -1
    middle = [Q(1, 2)] * 3
    middle[axis] = Q(wall % 2)
    volume, at = plan.grids[grid][0], plan.parameters(grid, cell, middle)
    columns = [slope(plan.cage.maps[volume], at, a, sign if a == axis else 1) for a in range(3)]
    e = [sign * c * length / 2 for c in columns[axis]]
    f = [2 * c + b for c, b in zip(e, bend)]
    matrix = [[c.limit_denominator(1 << 12) for c in row] for row in inverse([list(row) for row in zip(*columns)])]
    return Sweep(grid, cell, wall, e, f, matrix, depth, 2 / Q(length))


def slope(volume, at, axis, sign, step=Q(1, 1 << 10)):
    """The derivative of the map along an axis, approximately: for hints and directions only."""
    knots = volume.knots[axis]
    ends = [at[axis], at[axis] - sign * step * (knots[-1] - knots[0])]
    if not knots[0] <= ends[1] <= knots[-1]:
        ends[1] = 2 * ends[0] - ends[1]
    first, second = [examples.value_at(volume, [t if a == axis else c for a, c in enumerate(at)]) for t in ends]
    return [((a - b) / (ends[0] - ends[1])).limit_denominator(1 << 12) for a, b in zip(first, second)]


# ---------------------------------------------------------------- microstructures

class Micro(examples.Micro):
    """With bridges or sweeps, materials (a text or None) and a proof for each tile: None for its centre and exit, or Boxes."""
    no_bridges = None                                     # whether the empty list is written

    def __init__(self, *args, bridges=(), materials=None, proofs=None, sweeps=()):
        super().__init__(*args)
        self.bridges, self.materials, self.proofs, self.sweeps = list(bridges), materials, proofs or [None] * len(self.tiles), list(sweeps)

    def changed(self, **fields):
        new = copy.copy(self)
        new.made, new.hints, new.values, new.bridges, new.proofs = None, list(self.hints), dict(self.values), list(self.bridges), list(self.proofs)
        new.sweeps = list(self.sweeps)
        for key, value in fields.items():
            setattr(new, key, value)
        return new

    def text(self):
        if self.made is None:
            text = super().text()[:-2]
            if self.bridges or self.no_bridges:
                text += (",\n\"bridges\": [%s]" % ",\n".join(bridge.json() for bridge in self.bridges)).encode()
            if self.sweeps:
                text += (",\n\"sweeps\": [%s]" % ",\n".join(sweep.json() for sweep in self.sweeps)).encode()
            if self.materials is not None:
                text += (",\n\"materials\": %s" % self.materials).encode()
            self.made = text + b"}\n"
        return self.made

    def body(self):
        out = [self.magic, forge.u32(len(self.tiles) if self.count is None else self.count), forge.u32(len(self.bridges) + len(self.sweeps))]
        for (centre, exit), proof in zip(self.hints, self.proofs):
            out.append(proof.body() if proof else b"\0" + b"".join(map(forge.rational, centre)) + forge.varint(exit))
        return b"".join(out + [hinted.hint() for hinted in self.bridges + self.sweeps]) + self.cage.body() + self.tail

    def truth(self):
        return {**super().truth(), "bridges": len(self.bridges) + len(self.sweeps)}
