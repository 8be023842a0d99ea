# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Microstructures with their certificates (microstructure-1), whatever they say: tests only. Tiles are made of bilinear patches over a
lattice on the surface of a cube; the truth about a microstructure is found from the corners of its patches, mapped to space."""
import hashlib
import itertools
import json
import pathlib
import sys
from fractions import Fraction as Q

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "checker_py"))
import star_box_forge as forge                            # noqa: E402
import vmodel_forge                                       # noqa: E402

UNIT, HALF = 1 << 20, Q(1, 2)
OTHERS = ((1, 2), (0, 2), (0, 1))
KEYS = ("cells", "tiles", "glued_caps", "components", "shells", "genus", "bridges")


# ---------------------------------------------------------------- tiles

class Tile:
    """vertices: {name: (wall or None, point, what t adds to it)}, where t is the number of the wall driver[wall]; quads: four names each, counterclockwise as seen from outside. A quad
    is a bilinear patch, turned by turns[n] and written by `written`, if that is given."""

    def __init__(self, vertices, quads, extent, centre=(HALF,) * 3, exit=0, name="tile", driver=range(6)):
        self.driver = driver
        self.vertices, self.quads, self.extent, self.centre, self.exit, self.name = vertices, quads, extent, centre, exit, name
        self.patches = [self.patch(n) for n in range(len(quads))]

    def patch(self, n):
        """(wall, degrees, lists)"""
        corners = [self.vertices[name] for name in self.quads[n]]
        walls = {wall for wall, _, more in corners if any(more)}
        assert len(walls) < 2
        order = (0, 3, 1, 2)
        lists = [[list(corners[c][1 + k]) for c in order] for k in range(2 if walls else 1)]
        return (self.driver[walls.pop()] if walls else None), (1, 1), lists

    def at(self, name, numbers):
        wall, point, more = self.vertices[name]
        t = Q(numbers[self.driver[wall]], UNIT) if wall is not None and any(more) else 0
        return tuple(a + b * t for a, b in zip(point, more))

    def wall_of(self, name):
        """The wall in which a vertex lies, or None."""
        _, point, more = self.vertices[name]
        found = [2 * a + e for a in range(3) for e in (0, 1) if point[a] == e and not more[a]]
        return found[0] if found else None

    def caps(self, wall):
        """The numbers of the quads in a wall."""
        return [n for n, quad in enumerate(self.quads) if all(self.wall_of(name) == wall for name in quad)]

    def json(self):
        patches = ["{\"wall\": %s, \"degrees\": [%d, %d], \"points\": %s}" % (
            "null" if wall is None else wall, *degrees, json.dumps([[[str(c) for c in p] for p in points] for points in lists]))
            for wall, degrees, lists in self.patches]
        return "{\"name\": %s, \"range\": %s, \"patches\": [\n%s]}" % (
            json.dumps(self.name), "null" if self.extent is None else json.dumps(self.extent), ",\n".join(patches))


def pattern(kind, n):
    """The vertices (i, j) of a wall's lattice of n by n quads that lie in the wall."""
    inner = range(1, n)
    near = [n // 2, n // 2 + 1]
    return {"none": [], "block": list(itertools.product(inner, repeat=2)), "centre": list(itertools.product(near, repeat=2)),
            "ring": [v for v in itertools.product(inner, repeat=2) if n < 7 or not (v[0] in near and v[1] in near)],
            "corners": [v for v in itertools.product(inner, repeat=2) if all(x < n // 2 or x > n // 2 + 1 for x in v)],
            "row": [v for v in itertools.product(inner, repeat=2) if v[0] in near]}[kind]


def lattice_tile(n, patterns, scale=(Q(9, 10), Q(1, 20)), extent=(0, UNIT), depth=None, centre=None, name="tile", places=None, driver=range(6)):
    """places: of the lattice along each axis, by default i / n. patterns: the vertices in each wall. Those are at 1/2 + (place - 1/2) (s + r t)
    with (s, r) = scale; the others are drawn to the middle by the factor depth(vertex)."""
    places = places or [[Q(i, n) for i in range(n + 1)]] * 3
    depth, (s, r) = depth or (lambda v: Q(4, 5)), scale
    in_wall = {}
    for wall, chosen in enumerate(patterns):
        axis, end = wall // 2, wall % 2
        for i, j in chosen:
            v = [0, 0, 0]
            v[axis], v[OTHERS[axis][0]], v[OTHERS[axis][1]] = end * n, i, j
            in_wall[tuple(v)] = wall
    vertices, quads = {}, []
    for v in itertools.product(range(n + 1), repeat=3):
        if not any(x in (0, n) for x in v):
            continue
        off = [places[a][x] - HALF for a, x in enumerate(v)]
        wall = in_wall.get(v)
        if wall is None:
            factor = depth(v)
            vertices[v] = None, tuple(HALF + x * factor for x in off), (0, 0, 0)
        else:
            axis, moves = wall // 2, extent is not None
            vertices[v] = (wall, tuple(places[a][v[a]] if a == axis else HALF + off[a] * s for a in range(3)),
                           tuple(off[a] * r if a != axis and moves else Q(0) for a in range(3)))
    for wall in range(6):
        axis, end = wall // 2, wall % 2
        first, second = [(1, 2), (2, 0), (0, 1)][axis][::1 if end else -1]
        for i, j in itertools.product(range(n), repeat=2):
            quad = []
            for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                v = [0, 0, 0]
                v[axis], v[first], v[second] = end * n, i + di, j + dj
                quad.append(tuple(v))
            quads.append(tuple(quad))
    if not r:
        extent = None
    tile = Tile(vertices, quads, extent, name=name, driver=driver)
    tile.centre = centre or tile.centre
    tile.exit = exit_of(tile)
    return tile


def exit_of(tile):
    """A quad in a wall whose middle is straight ahead of the centre, or any."""
    lo = (tile.extent or (0, 0))[0]
    for wall in range(6):
        for n in tile.caps(wall):
            middle = [sum(c) / 4 for c in zip(*[tile.at(name, [lo] * 6) for name in tile.quads[n]])]
            if sum(a != b for a, b in zip(middle, tile.centre)) == 1:
                return n
    return 0


def jack(node=Q(1, 5), cap=Q(1, 8), grows=Q(1, 8), extent=(0, UNIT)):
    """24 patches and six caps, [1/2 - cap - grows t, 1/2 + cap + grows t] squared."""
    vertices, quads = {}, []
    for wall in range(6):
        axis, end = wall // 2, wall % 2
        first, second = [(1, 2), (2, 0), (0, 1)][axis][::1 if end else -1]
        signs, inner, outer = ((-1, -1), (1, -1), (1, 1), (-1, 1)), [], []
        for a, b in signs:
            v = [0, 0, 0]
            v[axis], v[first], v[second] = 2 * end - 1, a, b
            inner.append(tuple(v))
            vertices[tuple(v)] = None, tuple(HALF + node * x for x in v), (0, 0, 0)
            outer.append((wall, *v))
            vertices[(wall, *v)] = (wall, tuple(Q(end) if k == axis else HALF + cap * x for k, x in enumerate(v)),
                                    tuple(0 if k == axis else grows * x for k, x in enumerate(v)))
        quads += [(inner[k], inner[(k + 1) % 4], outer[(k + 1) % 4], outer[k]) for k in range(4)] + [tuple(outer)]
    return Tile(vertices, quads, extent if grows else None, exit=4, name="jack")


def raised(patch, axis):
    """The patch (wall, degrees, lists) in a degree that is higher by one."""
    wall, (p, q), lists = patch
    found = []
    for points in lists:
        net = {(i, j): (*points[i * (q + 1) + j], Q(1)) for i in range(p + 1) for j in range(q + 1)}
        net = vmodel_forge.raised_net(net, (p + 1, q) if axis == 0 else (p, q + 1))
        found.append([list(net[at][:3]) for at in sorted(net)])
    return wall, (p + (axis == 0), q + (axis == 1)), found


# ---------------------------------------------------------------- microstructures

def value_at(m, parameters):
    """The point of space of a map of model_texts.py."""
    net = m.all()
    for axis, t in enumerate(parameters):
        p, knots, n = m.degrees[axis], m.knots[axis], m.sizes[axis]
        k = max(i for i, x in enumerate(knots) if x <= t and i < n)
        rest = {index[:axis] + index[axis + 1:] for index in net}
        net = {index: vmodel_forge.blossom([net[index[:axis] + (i,) + index[axis:]] for i in range(n)], knots, p, k, [t] * p)
               for index in rest} if axis == 0 else {index: vmodel_forge.blossom([net[(i, *index)] for i in range(n)], knots, p, k, [t] * p)
                                                     for index in {index[1:] for index in net}}
    point, = net.values()
    return tuple(c / point[3] for c in point[:3])


class Micro:
    """cage: a plan of vmodel_forge.py; grids: (volume, breaks of three axes); cells: for each grid a list of numbers of tiles, or None;
    walls: for each grid three lists of numbers, or None."""
    magic, tail, count = b"VTMS", b"", None

    def __init__(self, cage, grids, tiles, cells, walls=None):
        self.cage, self.grids, self.tiles, self.cells, self.walls = cage, grids, tiles, cells, walls
        self.hints = [(tile.centre, tile.exit) for tile in tiles]
        self.values, self.model, self.made = {}, None, None

    def changed(self, **fields):
        new = Micro(self.cage, self.grids, self.tiles, self.cells, self.walls)
        new.hints, new.values, new.model = list(self.hints), dict(self.values), self.model
        new.magic, new.tail, new.count = self.magic, self.tail, self.count
        for key, value in fields.items():
            setattr(new, key, value)
        return new

    def text(self):
        """The file."""
        if self.made is None:
            of_grids = ["{\"volume\": %d, \"breaks\": %s}" % (volume, json.dumps([[str(t) for t in b] for b in breaks]))
                        for volume, breaks in self.grids]
            strings = ["[%s]" % ", ".join(json.dumps(bits(of_grid, tile)) for tile in range(len(self.tiles))) for of_grid in self.cells]
            walls = [] if self.walls is None else ["[%s]" % ",".join("[%s]" % ",".join(map(str, w)) for w in lists) for lists in self.walls]
            lists = [",\n".join(parts) for parts in (of_grids, [tile.json() for tile in self.tiles], strings, walls)]
            self.made = ("{\"format\": \"veritope-micro-1\",\n\"model\": %s,\n\"cage\": %s,\n\"grids\": [\n%s],\n\"tiles\": [\n%s],\n"
                         "\"cells\": [\n%s],\n\"walls\": [\n%s]}\n" % (json.dumps(self.model), self.cage.model().decode(), *lists)).encode()
        return self.made

    def body(self):
        out = [self.magic, forge.u32(len(self.tiles) if self.count is None else self.count), forge.u32(0)]
        for centre, exit in self.hints:
            out += [b"\0", *map(forge.rational, centre), forge.varint(exit)]
        return b"".join(out) + self.cage.body() + self.tail

    def certificate(self, **values):
        model, body = self.text(), self.body()
        statement = {"certificate": "veritope-certificate-1", "tool": "micro_examples", "claim": "microstructure-1",
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": "vmicro",
                     "body_sha256": hashlib.sha256(body).hexdigest(), **self.values, **values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body

    # ------------------------------------------------------------ places

    def counts(self, grid):
        return [len(b) - 1 for b in self.grids[grid][1]]

    def index(self, grid, cell):
        _, n1, n2 = self.counts(grid)
        return cell // (n1 * n2), cell // n2 % n1, cell % n2

    def wall_index(self, grid, cell, wall):
        """(axis, index in the list of the axis)"""
        index, counts, axis = list(self.index(grid, cell)), self.counts(grid), wall // 2
        index[axis] += wall % 2
        counts[axis] += 1
        return axis, (index[0] * counts[1] + index[1]) * counts[2] + index[2]

    def numbers(self, grid, cell):
        if self.walls is None:
            return [0] * 6
        return [self.walls[grid][axis][n] for axis, n in (self.wall_index(grid, cell, w) for w in range(6))]

    def parameters(self, grid, cell, point):
        """The parameters in the volume of a point of the unit cube."""
        breaks = self.grids[grid][1]
        return tuple(b[i] + (b[i + 1] - b[i]) * x for b, i, x in zip(breaks, self.index(grid, cell), point))

    def in_space(self, grid, cell, point):
        return value_at(self.cage.maps[self.grids[grid][0]], self.parameters(grid, cell, point))

    def held(self):
        return [(g, c) for g, of_grid in enumerate(self.cells) for c, tile in enumerate(of_grid) if tile is not None]

    def is_on_face(self, grid, cell, wall):
        """Is the wall at an end of its volume?"""
        volume, breaks = self.grids[grid]
        knots, i = self.cage.maps[volume].knots[wall // 2], self.index(grid, cell)[wall // 2]
        return breaks[wall // 2][i + wall % 2] == knots[-(wall % 2)]

    def code(self, grid, cell, wall):
        """The code of the face of the volume, if the wall lies in it."""
        return self.cage.codes[6 * self.grids[grid][0] + wall] if self.is_on_face(grid, cell, wall) else None

    # ------------------------------------------------------------ the truth

    def equal_walls(self):
        """The number of pairs of walls whose patches have the same corners in space."""
        seen = []
        for g, c in self.held():
            tile, numbers = self.tiles[self.cells[g][c]], self.numbers(g, c)
            for wall in range(6):
                quads = [frozenset(self.in_space(g, c, tile.at(name, numbers)) for name in tile.quads[n]) for n in tile.caps(wall)]
                if quads:
                    seen.append(frozenset(quads))
        return len(seen) - len(set(seen))

    def settled(self):
        """With the true numbers."""
        self.values = self.truth()
        return self

    def truth(self):
        """The numbers, from the corners of patches in space: quads in walls that come twice are glued."""
        quads, seen = {}, {}
        for g, c in self.held():
            tile, numbers = self.tiles[self.cells[g][c]], self.numbers(g, c)
            names = {}
            for name in tile.vertices:
                wall = tile.wall_of(name)
                point = tile.at(name, numbers)
                names[name] = (g, c, name) if wall is None else self.in_space(g, c, point)
            for n, quad in enumerate(tile.quads):
                quads[g, c, n] = [names[name] for name in quad]
                if len({tile.wall_of(name) for name in quad} - {None}) == 1 and all(tile.wall_of(name) is not None for name in quad):
                    seen.setdefault(frozenset(quads[g, c, n]), []).append((g, c, n))
        cells, patches, glued = vmodel_forge.Classes(), vmodel_forge.Classes(), set()
        caps = vmodel_forge.Classes()
        for places in seen.values():
            assert len(places) < 3
            if len(places) == 2:
                glued.update(places)
                cells.unite(places[0][:2], places[1][:2])
        edges, in_glued = {}, {}
        for place, corners in quads.items():
            into = in_glued if place in glued else edges
            for a, b in zip(corners, corners[1:] + corners[:1]):
                if a != b:
                    into.setdefault(frozenset((a, b)), []).append(place)
        for places in edges.values():
            assert len(places) == 2, places
            patches.unite(*places)
        for places in in_glued.values():
            for one, other in itertools.combinations(places, 2):
                if one[:2] == other[:2]:
                    caps.unite(one, other)
        left = [place for place in quads if place not in glued]
        points = {p for place in left for p in quads[place]}
        chi = len(points) - len(edges) + len(left)
        shells = len({patches.find(place) for place in left})
        assert chi % 2 == 0
        return {"cells": sum(map(len, self.cells)), "tiles": len(self.held()), "glued_caps": len({caps.find(p) for p in glued}) // 2,
                "components": len({cells.find(place) for place in self.held()}), "shells": shells, "genus": shells - chi // 2, "bridges": 0}


def bits(cells, tile):
    """The hexadecimal digits of the cells that hold the tile."""
    cells = [c == tile for c in cells] + [False] * (-len(cells) % 4)
    return "".join("%x" % sum(b << 3 - k for k, b in enumerate(cells[i:i + 4])) for i in range(0, len(cells), 4))


def large(n, cage):
    """The microstructure of the speed test: n^3 cells of one volume, which has the domain [0, 1]^3, graded jacks with 30 patches."""
    breaks, numbers = [Q(i, n) for i in range(n + 1)], [(7919 * i) % (UNIT + 1) for i in range(n * n * (n + 1))]
    return Micro(cage, [(0, [breaks] * 3)], [jack()], [[0] * n ** 3], [[numbers, numbers[::-1], numbers]])
