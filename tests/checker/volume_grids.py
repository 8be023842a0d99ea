# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Grids of hexahedra as volumes of splines, their boundary faces, and both as texts of .g2, of MFEM and of .itd. Nothing here is taken from a
checker: which faces are outside follows from the grid, and the numbers of MFEM's control points from reading-rule-mfem.md alone."""
import itertools
from fractions import Fraction as Q

import star_box_forge as forge
from star_box_itd_test import decimal

PARAMETERS = {(0, 0): (2, 1), (0, 1): (1, 2), (1, 0): (0, 2), (1, 1): (2, 0), (2, 0): (1, 0), (2, 1): (0, 1)}    # section 3 of the page of faces
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
FACES = ((3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7))
LINEAR = (1, (0, 0, 1, 1))
SKEW = (2, (0, 0, 0, Q(1, 4), 1, 1, 1))                   # not the same in reverse
SIGNED = [(order, signs) for order in itertools.permutations(range(3)) for signs in itertools.product((0, 1), repeat=3)]


def greville(axis):
    """Where the control points of the identity lie."""
    p, knots = axis
    span = knots[-1] - knots[0]
    return [(sum(Q(t) for t in knots[i + 1:i + p + 1]) / p - knots[0]) / span for i in range(len(knots) - p - 1)]


def reversed_axis(axis):
    p, knots = axis
    return p, tuple(knots[0] + knots[-1] - t for t in reversed(knots))


def entity(axes, points, rational=False):
    """points: by tuples of indices."""
    size = [len(greville(axis)) for axis in axes]
    rows = [points[i] for i in itertools.product(*map(range, size))]
    return {"kind": "surface" if len(axes) == 2 else "volume", "group": None, "attributes": [], "shape": {
        "degrees": [p for p, _ in axes], "periodic": [False] * len(axes), "knots": [[str(Q(t)) for t in knots] for _, knots in axes],
        "rational": rational, "components": len(rows[0]), "points": [[str(Q(c)) for c in p] for p in rows]}}


def axes_of(e):
    return [(p, tuple(Q(t) for t in knots)) for p, knots in zip(e["shape"]["degrees"], e["shape"]["knots"])]


def points_of(e):
    size = [len(knots) - p - 1 for p, knots in axes_of(e)]
    rows = [tuple(Q(c) for c in p) for p in e["shape"]["points"]]
    return dict(zip(itertools.product(*map(range, size)), rows, strict=True))


def first_axis_fastest(e):
    points = points_of(e)
    return [points[i] for i in sorted(points, key=lambda i: i[::-1])]


def face_of(volume, axis, end, hand=1):
    axes, points = axes_of(volume), points_of(volume)
    first, second = PARAMETERS[axis, end][::hand]
    last = len(greville(axes[axis])) - 1
    chosen = {(i[first], i[second]): p for i, p in points.items() if i[axis] == end * last}
    return entity([axes[first], axes[second]], chosen, volume["shape"]["rational"])


class Grid:
    """cells: those of a box of cells that there are. axes[a][i]: (degree, knots) of slab i across axis a. turns: for each cell how its own
    axes lie in the grid. place: where the vertices of the grid lie. weight: a function of the place in the grid."""

    def __init__(self, cells=((0, 0, 0),), axes=None, turns=None, place=lambda *v: v, weight=None):
        self.cells, self.place, self.weight = list(cells), place, weight
        self.axes = axes or [[LINEAR] * 9] * 3
        self.turns = turns or [((0, 1, 2), (0, 0, 0))] * len(self.cells)
        self.vertices = sorted({tuple(c + e for c, e in zip(cell, ends)) for cell in self.cells for ends in CORNERS})

    def in_grid(self, cell, position):
        """Where a point of the cell lies in the grid. position: its coordinates along the cell's own axes, from 0 to 1."""
        (order, signs), at = self.turns[self.cells.index(cell)], [None] * 3
        for own, (axis, sign) in enumerate(zip(order, signs)):
            at[axis] = 1 - position[own] if sign else position[own]
        return tuple(c + t for c, t in zip(cell, at))

    def hand(self, cell):
        order, signs = self.turns[self.cells.index(cell)]
        inversions = sum(order[i] > order[j] for i in range(3) for j in range(i + 1, 3))
        return -1 if (inversions + sum(signs)) % 2 else 1

    def own_axes(self, cell):
        order, signs = self.turns[self.cells.index(cell)]
        along = [self.axes[axis][cell[axis]] for axis in order]
        return [reversed_axis(axis) if sign else axis for axis, sign in zip(along, signs)]

    def at(self, point):
        """Where a point of the grid lies, linear in each coordinate between the vertices; homogeneous if there are weights."""
        low = [c if c == int(c) else c - c % 1 for c in map(Q, point)]
        total = [Q(0)] * 3
        for ends in itertools.product((0, 1), repeat=3):
            share = Q(1)
            for c, l, e in zip(point, low, ends):
                share *= (c - l) if e else 1 - (c - l)
            if share:
                total = [t + share * Q(c) for t, c in zip(total, self.place(*(int(l) + e for l, e in zip(low, ends))))]
        if self.weight is None:
            return tuple(total)
        w = self.weight(*point)
        return (*(w * c for c in total), w)

    def volume(self, cell):
        axes = self.own_axes(cell)
        places = [greville(axis) for axis in axes]
        return entity(axes, {i: self.at(self.in_grid(cell, [g[k] for g, k in zip(places, i)])) for i in itertools.product(*(range(len(g)) for g in places))},
                      self.weight is not None)

    def volumes(self):
        return [self.volume(cell) for cell in self.cells]

    def faces(self):
        """Those of the outside, in the page's order."""
        out = []
        for cell in self.cells:
            order, signs = self.turns[self.cells.index(cell)]
            for own, end in itertools.product(range(3), (0, 1)):
                beyond = list(cell)
                beyond[order[own]] += -1 if end == signs[own] else 1
                if tuple(beyond) not in self.cells:
                    out.append(face_of(self.volume(cell), own, end, self.hand(cell)))
        return out


# ---------------------------------------------------------------- texts

def numbers(values):
    return " ".join(map(decimal, values))


def g2(entities, version="1 0 0"):
    """Several are one file."""
    out = []
    for e in entities:
        axes, rational = axes_of(e), e["shape"]["rational"]
        out.append("%d %s" % (200 if len(axes) == 2 else 700, version))
        out.append("%d %d" % (e["shape"]["components"] - rational, rational))
        for axis in axes:
            out += ["%d %d" % (len(greville(axis)), axis[0] + 1), numbers(axis[1])]
        out += map(numbers, first_axis_fastest(e))
    return "\n".join(out) + "\n"


def itd(entities, keyword="TRIVAR"):
    out = []
    for e in entities:
        axes, rational = axes_of(e), e["shape"]["rational"]
        out.append("[%s BSPLINE %s %s %s" % (keyword, " ".join(str(len(greville(a))) for a in axes), " ".join(str(p + 1) for p, _ in axes), "P3" if rational else "E3"))
        out += ["[KV %s]" % numbers(knots) for _, knots in axes]
        out += ["[%s]" % numbers(p[3:] + p[:3]) for p in first_axis_fastest(e)]
        out[-1] += "]"
    return "\n".join(out) + "\n"


def vjson(entities):
    return forge.encode_model(entities).decode()


def knot_vector(axis):
    return "%d %d %s" % (axis[0], len(greville(axis)), numbers(axis[1]))


def homogeneous(e, point):
    return point if e["shape"]["rational"] else (*point, Q(1))


def head(dimension, elements, edges, vertices, version="v1.0"):
    geometry = {2: 3, 3: 5}[dimension]
    lines = ["MFEM NURBS mesh %s" % version, "", "dimension", str(dimension), "elements", str(len(elements))]
    lines += ["%d %d %s" % (7, geometry, " ".join(map(str, e))) for e in elements]
    return "\n".join(lines + ["boundary", "0", "edges", str(len(edges)), *("%d %d %d" % e for e in edges), "vertices", str(vertices), ""])


def mfem_patches(entities, word="controlpoints_homogeneous"):
    """Section 3 of the page: each patch has its own control points."""
    dimension = len(axes_of(entities[0]))
    corners = 1 << dimension
    out = [head(dimension, [range(corners * i, corners * i + corners) for i in range(len(entities))], [], corners * len(entities)), "patches"]
    for e in entities:
        axes, coordinates = axes_of(e), e["shape"]["components"] - e["shape"]["rational"]
        out += ["knotvectors", str(dimension), *map(knot_vector, axes), "dimension %d" % coordinates, word]
        for p in first_axis_fastest(e):
            *x, w = homogeneous(e, p)
            out.append(numbers([c / w for c in x] + [w] if word == "controlpoints_cartesian" else [*x, w]))
    return "\n".join(out) + "\n"


class Mesh:
    """Section 4: shared control points. patches: the vertices of each. edges: (knot vector, from, to). axes: (degree, knots) of each knot
    vector. place(patch, position): the homogeneous control point of a patch at its own indices."""

    def __init__(self, dimension, vertices, patches, edges, axes, place):
        self.dimension, self.vertices, self.patches, self.edges, self.axes = dimension, vertices, list(map(tuple, patches)), list(edges), list(axes)
        self.place = place

    def edge(self, a, b):
        return next(i for i, (_, f, t) in enumerate(self.edges) if {f, t} == {a, b})

    def size(self, patch):
        out = []
        for axis in range(self.dimension):
            end = tuple(int(k == axis) for k in range(3))
            out.append(self.inner(self.edge(patch[0], patch[CORNERS.index(end)])) + 2)
        return out

    def inner(self, edge):
        return len(greville(self.axes[self.edges[edge][0]])) - 2

    def control_points(self):
        """By their numbers: [homogeneous point], as the page counts them."""
        found = {}
        first = self.vertices
        firsts = []
        for i in range(len(self.edges)):
            firsts.append(first)
            first += self.inner(i)
        faces = {}                                        # set of vertices: (first number, a, b, d)
        for patch in self.patches:
            for corners in FACES if self.dimension == 3 else ():
                a, b, c, d = (patch[k] for k in corners)
                if frozenset((a, b, c, d)) not in faces:
                    faces[frozenset((a, b, c, d))] = first, a, b, d
                    first += self.inner(self.edge(a, b)) * self.inner(self.edge(b, c))
        for number, patch in enumerate(self.patches):
            size = self.size(patch)
            within_patch = 0
            for reverse in itertools.product(*(range(n) for n in reversed(size))):
                at = reverse[::-1]                        # the first axis is the fastest
                free = [k for k in range(self.dimension) if 0 < at[k] < size[k] - 1]
                if len(free) == self.dimension:
                    key = first + within_patch
                    within_patch += 1
                else:
                    key = self.number_on_border(patch, size, at, free, firsts, faces)
                point = self.place(number, at)
                assert found.setdefault(key, point) == point, (number, at)
            first += within_patch
        self.total = first
        for key in range(self.total):
            found.setdefault(key, (Q(9), Q(9), Q(9), Q(1)))            # of vertices and edges that no patch has
        return [found[key] for key in sorted(found)]

    def vertex(self, patch, size, at, **changes):
        ends = [int(at[k] > 0) for k in range(self.dimension)] + [0] * (3 - self.dimension)
        for k, end in changes.items():
            ends["xyz".index(k)] = end
        return patch[CORNERS.index(tuple(ends))]

    def number_on_border(self, patch, size, at, free, firsts, faces):
        name = ["xyz"[k] for k in free]
        if not free:
            return self.vertex(patch, size, at)
        if len(free) == 1:
            a, b = (self.vertex(patch, size, at, **{name[0]: end}) for end in (0, 1))
            from_a = at[free[0]] - 1
            return firsts[self.edge(a, b)] + (from_a if a < b else size[free[0]] - 3 - from_a)
        corner = {(i, j): self.vertex(patch, size, at, **{name[0]: i, name[1]: j}) for i in (0, 1) for j in (0, 1)}
        first, a, b, d = faces[frozenset(corner.values())]
        where = {v: k for k, v in corner.items()}
        steps = {}
        for end in (b, d):
            k = 0 if where[end][0] != where[a][0] else 1
            steps[end] = at[free[k]] - 1 if where[a][k] == 0 else size[free[k]] - 2 - at[free[k]]
        return first + steps[b] + steps[d] * self.inner(self.edge(a, b))

    def text(self, version="v1.0", between="", ordering=1, collection="NURBS", weights=None, end=""):
        """weights: a word, or the weights are listed."""
        points = self.control_points()
        out = [head(self.dimension, self.patches, self.edges, self.vertices, version), "knotvectors", str(len(self.axes)), *map(knot_vector, self.axes), between]
        out += [weights] if weights else ["weights", *(decimal(p[-1]) for p in points)]
        x = [[c / p[-1] for c in p[:-1]] for p in points]
        out += ["FiniteElementSpace", "FiniteElementCollection: %s" % collection, "VDim: %d" % len(x[0]), "Ordering: %d" % ordering]
        out += map(numbers, x if ordering else zip(*x))
        return "\n".join(out) + "\n" + end


def mesh_of_grid(grid, rng=None, turn_edges=False):
    """The volumes of a grid as one mesh. rng: mixes the numbers of vertices and the order of edges. turn_edges: their knot vectors are
    stored in reverse, and so are their ends."""
    order = list(grid.vertices)
    if rng:
        rng.shuffle(order)
    number = {v: i for i, v in enumerate(order)}
    slabs = sorted({(axis, cell[axis]) for cell in grid.cells for axis in range(3)})
    edges = {}
    for cell in grid.cells:
        for axis in range(3):
            for ends in CORNERS:
                if not ends[axis]:
                    a = tuple(c + e for c, e in zip(cell, ends))
                    b = tuple(c + (k == axis) for k, c in enumerate(a))
                    edges[a, b] = slabs.index((axis, cell[axis]))
    listed = [(k, number[b], number[a]) if turn_edges else (k, number[a], number[b]) for (a, b), k in edges.items()]
    if rng:
        rng.shuffle(listed)
    axes = [grid.axes[axis][slab] for axis, slab in slabs]
    volumes = grid.volumes()
    patches = [[number[tuple(map(int, grid.in_grid(cell, ends)))] for ends in CORNERS] for cell in grid.cells]
    return Mesh(3, len(order), patches, listed, list(map(reversed_axis, axes)) if turn_edges else axes,
                lambda patch, at: homogeneous(volumes[patch], points_of(volumes[patch])[at]))
