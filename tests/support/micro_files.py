# SPDX-License-Identifier: LGPL-3.0-or-later
"""Microstructures for tests: tiles with exact coordinates, files in canonical form (docs/formats/micro-files.md) and their certificates
(docs/certificates/microstructure.md). Nothing here checks anything, so a test can write every lie; nothing is shared with checkers or provers,
but the body about a cage is one that `veritope certify` writes."""
import functools
import hashlib
import itertools
import json
import pathlib
import subprocess
import tempfile
from fractions import Fraction as Q

HALF = Q(1, 2)
MIDDLE = (HALF, HALF, HALF)


# ---------------------------------------------------------------- tiles

class Patch:
    """points: one or more lists of points, the second parameter fastest; the patch is their polynomial in the number of its wall."""

    def __init__(self, points, degrees=(1, 1), wall=None):
        self.points, self.degrees, self.wall = [[tuple(map(Q, p)) for p in of_list] for of_list in points], degrees, wall

    def mapped(self, place, turn=False, wall=None):
        """place: an affine map of points, of lists after the first its linear part. turn: u and v change places."""
        origin, (p, q) = place((0, 0, 0)), self.degrees
        lists = [[place(x) if k == 0 else tuple(a - b for a, b in zip(place(x), origin)) for x in points] for k, points in enumerate(self.points)]
        if turn:
            lists = [[points[i * (q + 1) + j] for j in range(q + 1) for i in range(p + 1)] for points in lists]
        return Patch(lists, (q, p) if turn else self.degrees, wall)


class Tile:
    """boxes: the body of star-box-2 that proves it; None: centre and exit do."""

    def __init__(self, name, patches, centre=MIDDLE, exit=0, range=None, boxes=None):
        self.name, self.patches, self.centre, self.exit, self.range = name, list(patches), tuple(map(Q, centre)), exit, range
        self.boxes = boxes

    def copy(self, **changes):
        tile = Tile(self.name, self.patches, self.centre, self.exit, self.range, self.boxes)
        for key, value in changes.items():
            setattr(tile, key, value)
        return tile

    def turned(self, order, flips):
        """The tile after a symmetry of the cube: coordinate k of the result is coordinate order[k], taken from 1 if flips[k]."""
        def place(x):
            return tuple(1 - x[order[k]] if flips[k] else x[order[k]] for k in (0, 1, 2))
        is_odd = (sum(flips) + (order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))) % 2 == 1
        walls = {2 * order[k] + e: 2 * k + (e ^ flips[k]) for k in (0, 1, 2) for e in (0, 1)}
        patches = [s.mapped(place, is_odd, walls.get(s.wall)) for s in self.patches]
        return self.copy(patches=patches, centre=place(self.centre))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return tuple(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3))


def determinant(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def facet(corners, centre, slopes=None, wall=None):
    """A patch of degrees (1, 1) through three or four corners in cyclic order, its normal away from the centre; its corners move by the slopes
    times the number of the wall. A facet of three corners has the first one as a collapsed side."""
    rows = [list(map(lambda p: tuple(map(Q, p)), row)) for row in ([corners] if slopes is None else [corners, slopes])]
    a, b, c = (subtract(p, centre) for p in (rows[0][0], rows[0][1], rows[0][-1]))
    is_outward = determinant(a, b, c) > 0
    order = {(3, True): (0, 0, 1, 2), (3, False): (0, 0, 2, 1), (4, True): (0, 3, 1, 2), (4, False): (0, 1, 3, 2)}[len(corners), is_outward]
    return Patch([[row[i] for i in order] for row in rows], (1, 1), wall)


def polyhedron(name, facets, centre=MIDDLE, exit=0):
    """facets: three or four corners each."""
    return Tile(name, [facet(f, centre) for f in facets], centre, exit)


def wall_point(wall, first, second, depth=0):
    """The point of the cube with these coordinates along the other two axes, `depth` away from the wall."""
    axis, end = divmod(wall, 2)
    point = [first, second]
    point.insert(axis, 1 - depth if end else depth)
    return tuple(map(Q, point))


CYCLE = ((-1, -1), (1, -1), (1, 1), (-1, 1))


def jack(name="jack", half=Q(1, 8), slope=Q(0), core=Q(3, 16), walls=range(6), centre=MIDDLE):
    """Arms from a cube in the middle, of the half side `core`, to the walls: there their half side is `half`, plus `slope` times the number of the
    wall. Six caps and 24 sides for all walls. Patch 0 is a cap. A wall that is not listed has a face of the cube instead of an arm."""
    caps, others = [], []
    for wall in range(6):
        def ring(size, depth, wall=wall):
            return [wall_point(wall, HALF + a * size, HALF + b * size, depth) for a, b in CYCLE]
        inner = ring(core, HALF - core)
        if wall not in walls:
            others.append(facet(inner, centre))
            continue
        outer, named = ring(half, 0), wall if slope else None
        moves = [subtract(p, q) for p, q in zip(ring(half + slope, 0), outer)]
        still = [(0, 0, 0)] * 4
        caps.append(facet(outer, centre, moves if slope else None, named))
        for k in range(4):
            n = (k + 1) % 4
            others.append(facet((outer[k], outer[n], inner[n], inner[k]), centre, (moves[k], moves[n], still[0], still[0]) if slope else None, named))
    return Tile(name, caps + others, centre, 0, (0, 1 << 20) if slope else None)


def rod(name="rod", axis=2, first=(Q(1, 4), Q(3, 4)), second=(Q(1, 4), Q(3, 4))):
    """A prism along the axis, over a rectangle in the other two. Patches 0 and 1 are its caps."""
    rings = [[wall_point(2 * axis + e, first[a > 0], second[b > 0]) for a, b in CYCLE] for e in (0, 1)]
    centre = tuple(sum(p[c] for ring in rings for p in ring) / 8 for c in range(3))
    sides = [(rings[0][k], rings[0][(k + 1) % 4], rings[1][(k + 1) % 4], rings[1][k]) for k in range(4)]
    return polyhedron(name, [*rings, *sides], centre)


def pinched(name="pinched"):
    """Caps [1/4, 1/2]^2 and [1/2, 3/4]^2 on z = 0 and on z = 1, and notches between them."""
    a, b, c, dip = Q(1, 4), HALF, Q(3, 4), Q(1, 8)
    loop = [(a, a, 0), (b, a, 0), (c, a, 1), (c, b, 0), (c, c, 0), (b, c, 0), (a, c, 1), (a, b, 0)]   # the third: whether in a notch
    ends = [[(x, y, n * dip) for x, y, n in loop], [(x, y, 1 - n * dip) for x, y, n in loop]]
    facets = []
    for z, ring in zip((0, 1), ends):
        top = (b, b, Q(z))
        facets += [(ring[0], ring[1], top, ring[7]), (ring[3], ring[4], ring[5], top)]
        facets += [(ring[1], ring[2], top), (ring[2], ring[3], top), (ring[5], ring[6], top), (ring[6], ring[7], top)]
    facets += [(ends[0][k], ends[0][(k + 1) % 8], ends[1][(k + 1) % 8], ends[1][k]) for k in range(8)]
    return polyhedron(name, facets, (Q(3, 8), Q(3, 8), HALF))


def keel(name="keel", ridge=Q(0)):
    """Caps [1/8, 1/4] x [3/8, 5/8] and [3/4, 7/8] x [3/8, 5/8] on z = 0, joined by a keel whose edge has its middle `ridge` above this wall; a cap
    on z = 1. With 0 it lies in the wall, as one side. The caps are two patches each, so that the edge ends at vertices."""
    low, mid, high, deep = Q(3, 8), HALF, Q(5, 8), Q(1, 8)
    x = [Q(1, 8), Q(1, 4), Q(3, 4), Q(7, 8)]

    def p(i, y):
        return (x[i], y, Q(0))
    tops = [(Q(1, 4), Q(1, 4), 1), (Q(3, 4), Q(1, 4), 1), (Q(3, 4), Q(3, 4), 1), (Q(1, 4), Q(3, 4), 1)]
    facets = [tops]
    for i, k in ((0, 1), (3, 2)):
        facets += [(p(i, low), p(k, low), p(k, mid), p(i, mid)), (p(i, mid), p(k, mid), p(k, high), p(i, high))]
    middle = (HALF, mid, ridge)
    for y, t in ((low, tops[:2]), (high, (tops[3], tops[2]))):
        notch = (HALF, y, deep)
        facets += [(p(1, y), p(1, mid), notch), (p(2, y), p(2, mid), notch)]
        facets += [(p(1, mid), middle, notch), (p(2, mid), middle, notch)] if ridge else [(p(1, mid), p(2, mid), notch)]
        facets += [(t[0], p(0, y), p(1, y)), (t[0], p(1, y), notch), (t[0], t[1], notch), (t[1], notch, p(2, y)), (t[1], p(2, y), p(3, y))]
    facets += [(t, p(i, mid), p(i, y)) for i, ends in ((0, (tops[0], tops[3])), (3, (tops[1], tops[2]))) for t, y in zip(ends, (low, high))]
    facets += [(tops[0], tops[3], p(0, mid)), (tops[1], tops[2], p(3, mid))]
    return polyhedron(name, facets)


def twice_wound(name="twice"):
    """A bipyramid whose equator winds twice around the middle, with a cap on x = 1 in its first turn. Every normal points away from the middle."""
    top, bottom, e = (HALF, HALF, Q(7, 8)), (HALF, HALF, Q(1, 8)), Q(1, 8)
    cap = [[(1, HALF - e, HALF + e * s) for s in (1, -1)], [(1, HALF + e, HALF + e * s) for s in (1, -1)]]     # two columns: above, below
    around = [(-1, 1), (-1, -1), (1, 0), (-1, 1), (-1, -1)]
    scale = [Q(1, 4), Q(1, 4), Q(1, 8), Q(1, 8), Q(1, 8)]
    columns = cap + [[(HALF + s * x, HALF + s * y, HALF)] for (x, y), s in zip(around, scale)]
    facets = [(cap[0][0], cap[0][1], cap[1][1], cap[1][0])]
    for a, b in zip(columns, columns[1:] + columns[:1]):
        facets += [(top, a[0], b[0]), (bottom, a[-1], b[-1])]
        if len(a) + len(b) == 3:
            facets.append((*a, *b[::-1]))
    return polyhedron(name, facets)


def frame(name="frame"):
    """A rod along z over [1/4, 3/4]^2 with a square hole along x: genus 1. Patches 0 and 1 are its caps."""
    def block_facets(cells, axes):
        """The quads between blocks of a lattice that are in the solid and others."""
        facets = []
        for cell in sorted(cells):
            for axis in range(3):
                for end in (0, 1):
                    beyond = tuple(c + (2 * end - 1) * (a == axis) for a, c in enumerate(cell))
                    if beyond in cells:
                        continue
                    others = [a for a in range(3) if a != axis]
                    corners = []
                    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        index = list(cell)
                        index[axis] += end
                        index[others[0]] += s
                        index[others[1]] += t
                        corners.append(tuple(axes[a][index[a]] for a in range(3)))
                    middle = tuple((axes[a][cell[a]] + axes[a][cell[a] + 1]) / 2 for a in range(3))
                    facets.append((corners, middle))
        return facets
    axes = [[Q(1, 4), Q(3, 4)], [Q(1, 4), Q(3, 8), Q(5, 8), Q(3, 4)], [Q(0), Q(3, 8), Q(5, 8), Q(1)]]
    cells = {(0, j, k) for j in range(3) for k in range(3)} - {(0, 1, 1)}
    facets = block_facets(cells, axes)
    in_wall = [f for f in facets if all(p[2] in (0, 1) for p in f[0])]
    others = [f for f in facets if f not in in_wall]
    return Tile(name, [facet(corners, middle) for corners, middle in in_wall + others])


# ---------------------------------------------------------------- files

def volume(place=lambda *x: x, order=(0, 1, 2), flips=(0, 0, 0), degree=1, domain=(0, 1)):
    """A cell of the degree (1: trilinear) over the domain along each axis, as an entity. place: from the unit cube to space. The parameter k of the cell is
    coordinate order[k] of the unit cube, taken from 1 if flips[k]."""
    def at(*parameters):
        x = [0, 0, 0]
        for k, t in enumerate(parameters):
            x[order[k]] = 1 - t if flips[k] else t
        return place(*x)
    points = [at(*(Q(i, degree) for i in index)) for index in itertools.product(range(degree + 1), repeat=3)]
    return {"kind": "volume", "group": None, "attributes": [], "shape": {
        "degrees": [degree] * 3, "periodic": [False] * 3, "knots": [[str(Q(t)) for t in domain for _ in range(degree + 1)]] * 3, "rational": False,
        "components": 3, "points": [[str(Q(c)) for c in p] for p in points]}}


class Grid:
    """cells: {(i, j, k): the number of a tile}. numbers: a function of (axis, i, j, k) for the walls that a kept cell has; walls count from its
    begin."""

    def __init__(self, breaks, cells, volume=0, numbers=None):
        self.breaks, self.cells, self.volume = [list(map(Q, axis)) for axis in breaks], dict(cells), volume
        self.numbers = numbers or (lambda axis, *i: 0)

    @classmethod
    def block(cls, n, tile=0, **others):
        """n[a] equal intervals along each axis of [0, 1]^3, each cell with this tile."""
        return cls([[Q(i, m) for i in range(m + 1)] for m in n], dict.fromkeys(itertools.product(*map(range, n)), tile), **others)

    def size(self):
        return [len(axis) - 1 for axis in self.breaks]

    def hexadecimal(self, tile):
        n = self.size()
        bits = [self.cells.get(i) == tile for i in itertools.product(*map(range, n))]
        bits += [False] * (-len(bits) % 4)
        return "".join(f"{8 * a + 4 * b + 2 * c + d:x}" for a, b, c, d in zip(*[iter(bits)] * 4))

    def walls(self, axis):
        n = self.size()
        n[axis] += 1
        for i in itertools.product(*map(range, n)):
            before = tuple(x - (a == axis) for a, x in enumerate(i))
            yield self.numbers(axis, *i) if i in self.cells or before in self.cells else 0


class Bridge:
    """points: the coefficients, the third axis fastest. matrix and cuts: K and s_1 to s_(m - 1) of the certificate."""

    def __init__(self, cell, wall, points, degrees=(1, 1), grid=0, volume=0, matrix=(1, 0, 0, 0, 1, 0, 0, 0, 1), cuts=()):
        self.cell, self.wall, self.points, self.degrees, self.grid, self.volume = cell, wall, [tuple(map(Q, p)) for p in points], degrees, grid, volume
        self.matrix, self.cuts = tuple(map(Q, matrix)), tuple(map(Q, cuts))

    @classmethod
    def along(cls, lists, cell, wall, **others):
        """lists: for each of the three indices of the third axis its points, the second parameter fastest."""
        return cls(cell, wall, [p for points in zip(*lists, strict=True) for p in points], **others)

    def json(self):
        return {"grid": self.grid, "cell": self.cell, "wall": self.wall, "volume": self.volume, "degrees": list(self.degrees),
                "points": [[str(x) for x in p] for p in self.points]}

    def hints(self):
        return b"".join(map(rational, self.matrix)) + bytes([len(self.cuts) + 1]) + b"".join(map(rational, self.cuts))


UNIT_MATRIX = (1, 0, 0, 0, 1, 0, 0, 0, 1)


class Sweep:
    """axis: e and f. matrix, depth and speed: K, d and l of the certificate."""

    def __init__(self, cell, wall, e, f, grid=0, matrix=UNIT_MATRIX, depth=1, speed=1):
        self.cell, self.wall, self.axis, self.grid = cell, wall, [tuple(map(Q, e)), tuple(map(Q, f))], grid
        self.matrix, self.depth, self.speed = tuple(map(Q, matrix)), Q(depth), Q(speed)

    def json(self):
        return {"grid": self.grid, "cell": self.cell, "wall": self.wall, "axis": [[str(x) for x in v] for v in self.axis]}

    def hints(self):
        return b"".join(map(rational, (*self.matrix, self.depth, self.speed)))


class Micro:
    """A file has bridges or sweeps."""

    def __init__(self, grids, tiles, cage=None, model=None, bridges=(), sweeps=()):
        self.grids, self.tiles, self.model, self.bridges, self.sweeps = list(grids), list(tiles), model, list(bridges), list(sweeps)
        self.cage = cage or [volume()]

    def ends(self):
        return self.bridges + self.sweeps

    def cage_text(self):
        return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": self.cage})

    def members(self):
        """The file's members, as texts: a test may change one."""
        def lines(items):
            return "[" + ",".join("\n" + x for x in items) + "]"
        has_range = any(t.range is not None for t in self.tiles)
        extra = {key: lines(json.dumps(b.json()) for b in ends) for key, ends in (("bridges", self.bridges), ("sweeps", self.sweeps)) if ends}
        return {"format": '"veritope-micro-1"', "model": json.dumps(self.model), "cage": self.cage_text(),
                "grids": lines(json.dumps({"volume": g.volume, "breaks": [[str(b) for b in axis] for axis in g.breaks]}) for g in self.grids),
                "tiles": lines(map(tile_text, self.tiles)),
                "cells": lines(json.dumps([g.hexadecimal(t) for t in range(len(self.tiles))]) for g in self.grids),
                "walls": lines("[" + ",".join("[" + ",".join(map(str, g.walls(a))) + "]" for a in range(3)) + "]" for g in self.grids) if has_range
                         else "[]", **extra}

    def text(self, **members):
        """members: texts that replace those of the file; None leaves a member out."""
        every = {**self.members(), **members}
        return ("{" + ",\n".join(f'"{key}": {value}' for key, value in every.items() if value is not None) + "}\n").encode()


def tile_text(tile):
    patches = [{"wall": s.wall, "degrees": list(s.degrees), "points": [[[str(x) for x in p] for p in points] for points in s.points]}
               for s in tile.patches]
    return json.dumps({"name": tile.name, "range": None if tile.range is None else list(tile.range), "patches": patches})


# ---------------------------------------------------------------- certificates

def varint(n):
    out = bytearray()
    while n > 127:
        out.append(n & 127 | 128)
        n >>= 7
    return bytes(out) + bytes([n])


def rational(r):
    p, q = Q(r).numerator, Q(r).denominator
    if max(abs(p), q) < 1 << 63:
        return varint(2 * p if p >= 0 else -2 * p - 1) + varint(q)
    a, b = (n.to_bytes((n.bit_length() + 7) // 8, "little") for n in (abs(p), q))
    return b"\0\0" + varint(len(a) + 1) + bytes([p < 0]) + a + varint(len(b)) + b


def cage_body(text, veritope, *options):
    """The body of the certificate of vmodel-1 about the cage."""
    return certified_body(text, veritope, b"VTVM", *options)


@functools.lru_cache(maxsize=None)
def certified_body(text, veritope, magic, *options, suffix=".vjson"):
    """The body with this magic number of the certificate that the program finds for a model."""
    with tempfile.TemporaryDirectory() as folder:
        model, certificate = pathlib.Path(folder, "model" + suffix), pathlib.Path(folder, "model.cert")
        model.write_text(text)
        done = subprocess.run([veritope, "certify", "--no-check", *options, "--certificate", certificate, model], capture_output=True, text=True,
                              timeout=300, check=False)
        body = certificate.read_bytes().split(b"\n", 1)[1] if certificate.exists() else b""
        if not body.startswith(magic):
            raise ValueError(done.stdout + done.stderr)
        return body


def hints(tiles, bridges=(), count=None):
    """The body before its part about the cage. bridges: or sweeps."""
    body = b"VTMS" + (len(tiles) if count is None else count).to_bytes(4, "little") + len(bridges).to_bytes(4, "little")
    return body + b"".join(map(hint, tiles)) + b"".join(b.hints() for b in bridges)


def hint(tile):
    if tile.boxes is not None:
        return b"\1" + len(tile.boxes).to_bytes(4, "little") + tile.boxes
    return b"\0" + b"".join(map(rational, tile.centre)) + varint(tile.exit)


def surfaces(tile):
    """The patches of a tile, which has no range, as a model of surfaces: the entities of its part about star boxes."""
    def entity(s):
        knots = [["0"] * (n + 1) + ["1"] * (n + 1) for n in s.degrees]
        return {"kind": "surface", "group": None, "attributes": [], "shape": {
            "degrees": list(s.degrees), "periodic": [False] * 2, "knots": knots, "rational": False, "components": 3,
            "points": [[str(x) for x in p] for p in s.points[0]]}}
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": [entity(s) for s in tile.patches]})


def boxed(tile, veritope, *options):
    """The tile with the body of star-box-2 that is found for it, or that says what one of star-box-1 says."""
    body = certified_body(surfaces(tile), veritope, b"VTS", *options)
    return tile.copy(boxes=body if body[3:4] == b"2" else in_version_2(body, len(tile.patches)))


class Cursor:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, n):
        self.at += n
        return self.data[self.at - n:self.at]

    def varint(self):
        n, shift = 0, 0
        while True:
            byte = self.take(1)[0]
            n, shift = n | (byte & 127) << shift, shift + 7
            if byte < 128:
                return n

    def zigzag(self):
        n = self.varint()
        return n // 2 if n % 2 == 0 else -(n // 2) - 1


def zigzag(z):
    return varint(2 * z if z >= 0 else -2 * z - 1)


def in_version_2(body, patches, are_triangles=False):
    """A body of star-box-1 about surfaces without inner breaks, or triangles, as one of star-box-2."""
    cursor = Cursor(body)
    cursor.take(8)
    out = [b"VTS2", body[4:8], b"".join(bytes([1 + are_triangles, flag]) for flag in cursor.take(patches))]
    begin = cursor.at
    cursor.take((0 if are_triangles else patches * 2 * (4 + 2 * 2)) + 2 * patches)    # breaks 0 and 1 for each axis, and the roots
    cursor.varint()
    out += [body[begin:cursor.at], bytes(4)]
    count = cursor.take(4)
    out.append(count)
    for _ in range(int.from_bytes(count, "little")):
        kind, s = cursor.take(1), cursor.varint()
        lo, size = [cursor.zigzag() for _ in range(3)], [cursor.varint() for _ in range(3)]
        out += [kind, varint(0), varint(s), *map(zigzag, lo), *map(varint, size)]
        if kind == b"\0":
            minus, plus = [cursor.varint() for _ in range(3)], [cursor.varint() for _ in range(3)]
            out += [b"\1\0", varint(s), *[zigzag(a + b) for a, b in zip(lo, minus)], *[zigzag(b - a) for a, b in zip(minus, plus)]]
    return b"".join(out) + body[cursor.at:]


def certificate(text, body, numbers, **changes):
    """numbers: those of section 8, by name. changes: of the statement."""
    statement = {"certificate": "veritope-certificate-1", "tool": "micro_files", "claim": "microstructure-1",
                 "subject_sha256": hashlib.sha256(text).hexdigest(), "subject_bytes": len(text), "subject_format": "vmicro",
                 "body_sha256": hashlib.sha256(body).hexdigest(), **numbers, **changes}
    return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


NUMBERS = ("cells", "tiles", "glued_caps", "components", "shells", "genus")    # bridges are counted


def certified(micro, numbers, veritope, *options, members=None):
    """(the file, its certificate). numbers: in the order of NUMBERS."""
    text = micro.text(**(members or {}))
    body = hints(micro.tiles, micro.ends()) + cage_body(micro.cage_text(), veritope, *options)
    return text, certificate(text, body, {**dict(zip(NUMBERS, numbers, strict=True)), "bridges": len(micro.ends())})


# ---------------------------------------------------------------- inside of a mesh

READING_RULE = (
    "Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, unless as_indexed is true (STL: always one); vertex ids count "
    "first occurrences in file order; polygons are fans from their first vertex; decimals round to the nearest binary64, ties to even; binary "
    "floats are widened exactly; normals, colours, texture, lines, groups and attribute bytes are ignored; unreferenced vertices are ignored; all "
    "solid blocks of an ASCII STL are one model; the file is refused unless it yields at least one triangle, finite coordinates and indices in "
    "range.")


class Mesh:
    """Triangles in an OFF file. corners: binary64 numbers."""
    format = "off"

    def __init__(self):
        self.corners, self.triangles = [], []

    def box(self, lo, hi, inward=False):
        """Adds the surface of a box."""
        first = len(self.corners)
        self.corners += [tuple(float((lo, hi)[e][k]) for k, e in enumerate(ends)) for ends in itertools.product((0, 1), repeat=3)]
        for a, b, c, d in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)):
            for t in ((a, b, c), (a, c, d)):
                self.triangles.append(tuple(first + i for i in (t[::-1] if inward else t)))
        return self

    def text(self):
        lines = ["OFF", f"{len(self.corners)} {len(self.triangles)} 0"]
        lines += [" ".join(map(repr, p)) for p in self.corners] + ["3 %d %d %d" % t for t in self.triangles]
        return "\n".join(lines) + "\n"


    def body(self, veritope):
        return certified_body(self.text(), veritope, b"VTMV", suffix=".off")


class Patches:
    """Patches in a .vjson file. weight: of a control point, from 1 everywhere if it is None. are_triangles: patches of the degrees (1, 1) become
    two triangles each. options: of the program that certifies them."""
    format, options, weight, are_triangles = "vjson", (), None, False

    def __init__(self, patches=()):
        self.patches = list(patches)

    def box(self, lo, hi, inward=False):
        """Adds the surface of a box, as six patches of the degrees (1, 1)."""
        corners, middle = [tuple(map(Q, p)) for p in (lo, hi)], tuple((Q(a) + Q(b)) / 2 for a, b in zip(lo, hi))
        for axis, end in itertools.product(range(3), (0, 1)):
            ring = []
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                ends = [i, j]
                ends.insert(axis, end)
                ring.append(tuple(corners[e][k] for k, e in enumerate(ends)))
            face = facet(ring, middle)
            self.patches.append(face.mapped(lambda x: x, turn=True) if inward else face)
        return self

    def text(self):
        model = json.loads(surfaces(self))
        if self.weight is not None:
            for of, s in zip(model["entities"], self.patches):
                points = [[*(c * self.weight(p) for c in p), self.weight(p)] for p in s.points[0]]
                of["shape"].update(rational=True, components=4, points=[[str(c) for c in p] for p in points])
        if self.are_triangles:
            corners = [[s.points[0][i] for i in of] for s in self.patches for of in ((0, 2, 3), (0, 3, 1))]
            model["entities"] = [{"kind": "triangle", "group": None, "attributes": [], "shape": {
                "degree": 1, "rational": False, "components": 3, "points": [[str(c) for c in p] for p in of]}} for of in corners]
        return json.dumps(model)

    def body(self, veritope):
        body = certified_body(self.text(), veritope, b"VTS", *self.options)
        return body if body[3:4] == b"2" else in_version_2(body, len(self.patches) * (1 + self.are_triangles), self.are_triangles)


class Void:
    def __init__(self, x, corner=8, volume=0):
        self.x, self.corner, self.volume = tuple(map(Q, x)), corner, volume

    def bytes(self):
        return self.volume.to_bytes(4, "little") + b"".join(map(rational, self.x)) + bytes([self.corner])


def inside_body(structure, solid, voids=(), count=None):
    return b"".join([b"VTIM", len(structure).to_bytes(4, "little"), len(solid).to_bytes(4, "little"), structure, solid,
                     (len(voids) if count is None else count).to_bytes(4, "little"), *[v.bytes() for v in voids]])


def inside_certificate(text, solid, body, numbers, **changes):
    """solid: the model's bytes, an OFF file unless model_format is changed."""
    return certificate(text, body, numbers, **{
        "claim": "micro-inside-1", "model_sha256": hashlib.sha256(solid).hexdigest(), "model_bytes": len(solid), "model_format": "off",
        "reading_rule": READING_RULE, "as_indexed": False, "skin": "-", **changes})


def certified_inside(micro, solid, numbers, veritope, *options, voids=(), **changes):
    """(the file, its certificate, the model)."""
    text, model = micro.text(), solid.text()
    structure = hints(micro.tiles, micro.ends()) + cage_body(micro.cage_text(), veritope, *options)
    body = inside_body(structure, solid.body(veritope), voids)
    every = {**dict(zip(NUMBERS, numbers, strict=True)), "bridges": len(micro.ends())}
    return text, inside_certificate(text, model.encode(), body, every, **{"model_format": solid.format, **changes}), model.encode()
