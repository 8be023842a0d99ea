# SPDX-License-Identifier: Apache-2.0 OR MIT
"""MFEM meshes whose patches share control points, written from where their control points are: blocks of a lattice, each with an
orientation of its own, and vertices with numbers of their own."""
import itertools
from fractions import Fraction as Q

import model_texts as texts

CORNERS = {2: ((0, 0), (1, 0), (1, 1), (0, 1)),
           3: ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))}
FACES = ("3210", "0154", "1265", "2376", "3047", "4567")


def between(a, b, i, n):
    """Lattice point number i of n on the way from a to b."""
    return tuple(x + (y - x) * i // (n - 1) for x, y in zip(a, b))


class Blocks:
    """counts: blocks along the axes of the lattice.  axes[k]: (degree, knots) along axis k; all blocks have the same.
    left_out: blocks that are missing."""

    def __init__(self, rng, counts, axes, left_out=(), spare_vertices=0):
        self.num_axes, self.axes = len(counts), [(p, [Q(t) for t in knots]) for p, knots in axes]
        self.sizes = [len(t) - p - 1 for p, t in self.axes]
        steps = [n - 1 for n in self.sizes]
        blocks = [b for b in itertools.product(*map(range, counts)) if b not in left_out]
        rng.shuffle(blocks)
        corners = sorted({tuple((c + e) * s for c, e, s in zip(b, ends, steps)) for b in blocks for ends in itertools.product((0, 1), repeat=self.num_axes)})
        numbers = rng.sample(range(len(corners) + spare_vertices), len(corners))
        self.vertex_of, self.num_vertices = dict(zip(corners, numbers)), len(corners) + spare_vertices
        self.at_vertex = {v: p for p, v in self.vertex_of.items()}
        self.patches = [[self.vertex_of[p] for p in self.corners_of(rng, b, steps)] for b in blocks]
        self.find_edges(rng)
        self.find_points()

    def corners_of(self, rng, block, steps):
        """The corners of a block in the order of a patch, whose axes run along those of the lattice in any order, either way."""
        order, flips = rng.sample(range(self.num_axes), self.num_axes), [rng.randrange(2) for _ in steps]
        for ends in CORNERS[self.num_axes]:
            p = [0] * self.num_axes
            for axis, end, flip in zip(order, ends, flips):
                p[axis] = (block[axis] + (end ^ flip)) * steps[axis]
            yield tuple(p)

    def find_edges(self, rng):
        """edges: (knot vector, from, to), from the lesser lattice point unless the knots are the same either way."""
        pairs, self.edges = {}, []
        for vertices in self.patches:
            places = [self.at_vertex[v] for v in vertices]
            for a, b in itertools.combinations(places, 2):
                along = [k for k in range(self.num_axes) if a[k] != b[k]]
                if len(along) == 1:
                    pairs[min(a, b), max(a, b)] = along[0]
        for (a, b), axis in rng.sample(sorted(pairs.items()), len(pairs)):
            knots = self.axes[axis][1]
            if [knots[0] + knots[-1] - t for t in knots[::-1]] == knots and rng.random() < .5:
                a, b = b, a
            self.edges.append((axis, self.vertex_of[a], self.vertex_of[b]))

    def find_points(self):
        """points: the lattice point of each control point, None where there is no such point."""
        self.points = [self.at_vertex.get(v) for v in range(self.num_vertices)]
        for axis, a, b in self.edges:
            n = self.sizes[axis]
            a, b = self.at_vertex[min(a, b)], self.at_vertex[max(a, b)]
            self.points += [between(a, b, i, n) for i in range(1, n - 1)]
        seen, inner = set(), []
        for vertices in self.patches:
            for face in FACES if self.num_axes == 3 else ():
                a, b, c, d = (self.at_vertex[vertices[int(k)]] for k in face)
                if frozenset((a, b, c, d)) not in seen:
                    seen.add(frozenset((a, b, c, d)))
                    self.points += self.grid(a, (b, d))
            places = [self.at_vertex[v] for v in vertices]
            inner += self.grid(places[0], [places[k] for k in (1, 3, 4)[:self.num_axes]])
        self.points += inner

    def size(self, a, b):
        """The number of control points from one corner to another along an edge."""
        return next(n for n, x, y in zip(self.sizes, a, b) if x != y)

    def grid(self, start, ends, first=1):
        """The lattice points of a parallelepiped with these corners next to `start`, the first direction fastest; without its border if
        first is 1."""
        sizes = [self.size(start, end) for end in ends]
        for index in itertools.product(*[range(first, n - first) for n in sizes[::-1]]):
            p = start
            for end, n, i in zip(ends, sizes, index[::-1]):
                q = between(start, end, i, n)
                p = tuple(x + y - z for x, y, z in zip(p, q, start))
            yield p

    def maps(self, place, weight):
        """What the patches mean: place and weight of each lattice point."""
        for vertices in self.patches:
            corners = [self.at_vertex[v] for v in vertices]
            ends, degrees, knots = [corners[k] for k in (1, 3, 4)[:self.num_axes]], [], []
            for end in ends:
                axis = next(k for k in range(self.num_axes) if end[k] != corners[0][k])
                degree, t = self.axes[axis]
                degrees.append(degree)
                knots.append(t if end[axis] > corners[0][axis] else [t[0] + t[-1] - x for x in t[::-1]])
            points = [[*(weight(p) * c for c in place(p)), weight(p)] for p in self.grid(corners[0], ends, 0)]
            yield texts.Map(degrees, knots, points, True)

    def text(self, place, weight=None, ordering=1, version="v1.0", extra="", collection="NURBS"):
        """weight: None for `unitweights`.  Control points that are on no patch get coordinates and weights of their own."""
        patch_words = ["1 %d %s" % (2 * self.num_axes - 1, " ".join(map(str, vertices))) for vertices in self.patches]
        edges = [" ".join(map(str, e)) for e in self.edges]
        axes = ["%d %d %s" % (p, n, texts.numbers(t)) for (p, t), n in zip(self.axes, self.sizes)]
        coordinates = [tuple(place(p)) if p else None for p in self.points]
        width = len(next(c for c in coordinates if c))
        coordinates = [c or (Q(-7),) * width for c in coordinates]
        in_order = coordinates if ordering else zip(*coordinates)
        weights = ["unitweights"] if weight is None else ["weights", *(texts.numbers([weight(p) if p else 0]) for p in self.points)]
        return "\n".join(["MFEM NURBS mesh " + version, "# blocks", "dimension", str(self.num_axes), "elements", str(len(self.patches)), *patch_words,
                          "boundary 2 1 0 5 1 3 0 1 2 3", "edges", str(len(edges)), *edges, "vertices", str(self.num_vertices),
                          "knotvectors", str(len(axes)), *axes, extra, *weights, "FiniteElementSpace", "FiniteElementCollection: " + collection,
                          "VDim: %d" % width, "Ordering: %d" % ordering, *map(texts.numbers, in_order)]) + "\n"
