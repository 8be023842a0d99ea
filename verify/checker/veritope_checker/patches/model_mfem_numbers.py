# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Which control points the patches of an MFEM mesh share: docs/certificates/reading-rule-mfem.md, section 4."""
from math import prod

from ..common.errors import Refused

CORNERS = {2: ((0, 0), (1, 0), (1, 1), (0, 1)),
           3: ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))}
EDGES = {2: (((0, 1), (3, 2)), ((1, 2), (0, 3))),           # along each axis, from corner to corner
         3: (((0, 1), (3, 2), (4, 5), (7, 6)), ((1, 2), (0, 3), (5, 6), (4, 7)), ((0, 4), (1, 5), (2, 6), (3, 7)))}
FACES = {2: (), 3: ((3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7))}

class Grid:
    """The control points of one patch, the first axis fastest, by their positions in that order."""

    def __init__(self, vertices, sizes):
        self.sizes = sizes
        self.steps = [prod(sizes[:axis]) for axis in range(len(sizes))]
        self.corners = [sum(end * (n - 1) * step for end, n, step in zip(ends, sizes, self.steps))
                        for ends in CORNERS[len(sizes)]]
        self.position_of = dict(zip(vertices, self.corners))

    def inner(self):
        """The positions within the patch."""
        positions = [0]
        for n, step in reversed(list(zip(self.sizes, self.steps))):
            positions = [p + i * step for p in positions for i in range(1, n - 1)]
        return positions

class Numbering:
    """count: control points of the mesh."""

    def __init__(self, mesh, knot_vectors, most):
        self.mesh, self.knot_vectors, self.reversed = mesh, knot_vectors, {}
        self.find_edges()
        self.axes = [self.axes_of(n) for n in range(len(mesh.patches))]
        sizes = [[self.knot_vectors[kv].size for kv, _ in axes] for axes in self.axes]
        if sum(map(prod, sizes)) > most:
            raise Refused("the patches have more control points than the file has bytes")
        self.knots = [[self.knots_of(kv, ways, n) for kv, ways in axes] for n, axes in enumerate(self.axes)]
        self.grids = [Grid(vertices, n) for vertices, n in zip(mesh.patches, sizes)]
        self.find_faces()
        self.count += sum(prod(n - 2 for n in of_patch) for of_patch in sizes)

    def find_edges(self):
        """Sets edge_of, the edge of each pair of vertices, and first_on, the number that each edge begins with."""
        self.edge_of, self.first_on, self.count = {}, [], self.mesh.num_vertices
        for e, (kv, a, b) in enumerate(self.mesh.edges):
            if kv >= len(self.knot_vectors) or max(a, b) >= self.mesh.num_vertices:
                raise Refused("edge %d has a knot vector or a vertex that does not exist" % e)
            if self.edge_of.setdefault((min(a, b), max(a, b)), e) != e:
                raise Refused("edge %d has the vertices of another edge" % e)
            self.first_on.append(self.count)
            self.count += self.knot_vectors[kv].size - 2

    def edge(self, n, a, b):
        """The number of the edge between two vertices of patch n."""
        e = self.edge_of.get((min(a, b), max(a, b)))
        if e is None:
            raise Refused("patch %d has an edge between vertices %d and %d that is not listed" % (n, a, b))
        return e

    def axes_of(self, n):
        """For each axis of patch n: the knot vector, and the ways in which its edges are listed (True: along the
        axis)."""
        vertices, axes = self.mesh.patches[n], []
        if len(set(vertices)) < len(vertices):
            raise Refused("patch %d has a vertex twice" % n)
        for ends in EDGES[self.mesh.num_axes]:
            edges = [self.mesh.edges[self.edge(n, vertices[c], vertices[d])] for c, d in ends]
            if len({kv for kv, _, _ in edges}) > 1:
                raise Refused("patch %d has edges with different knot vectors along axis %d" % (n, len(axes)))
            axes.append((edges[0][0], [start == vertices[c] for (_, start, _), (c, _) in zip(edges, ends)]))
        return axes

    def knots_of(self, kv, ways, n):
        """The knots of an axis of patch n."""
        plain = self.knot_vectors[kv].knots
        if all(ways):
            return plain
        if kv not in self.reversed:
            self.reversed[kv] = [plain[0] + plain[-1] - t for t in reversed(plain)]
        if any(ways) and self.reversed[kv] != plain:
            raise Refused("patch %d has edges with different knots along one axis" % n)
        return self.reversed[kv]

    def find_faces(self):
        """Sets face_of: for each set of vertices, the face at its first occurrence and the number that it begins
        with."""
        self.face_of = {}
        for vertices, grid in zip(self.mesh.patches, self.grids):
            for corners in FACES[self.mesh.num_axes]:
                face = [vertices[c] for c in corners]
                known, _ = self.face_of.setdefault(tuple(sorted(face)), (face, self.count))
                if known is face:
                    m, k = inner_sizes(grid, *(grid.corners[c] for c in (corners[0], corners[1], corners[3])))
                    self.count += m * k
                elif face[(face.index(known[0]) + 2) % 4] != known[2]:
                    raise Refused("two faces have the vertices %s in another cyclic order" % sorted(face))

    def patches(self):
        """For each patch: degrees, knots, numbers of the control points with the first axis fastest."""
        last = self.count - sum(prod(n - 2 for n in grid.sizes) for grid in self.grids)
        for vertices, axes, knots, grid in zip(self.mesh.patches, self.axes, self.knots, self.grids):
            numbers = [None] * prod(grid.sizes)
            for vertex, position in grid.position_of.items():
                numbers[position] = vertex
            self.number_edges(numbers, vertices, grid)
            self.number_faces(numbers, vertices, grid)
            for position in grid.inner():
                numbers[position], last = last, last + 1
            yield [self.knot_vectors[kv].degree for kv, _ in axes], knots, numbers

    def number_edges(self, numbers, vertices, grid):
        for ends, n, step in zip(EDGES[self.mesh.num_axes], grid.sizes, grid.steps):
            for c, d in ends:
                a, b = vertices[c], vertices[d]
                first = self.first_on[self.edge_of[min(a, b), max(a, b)]]
                for i in range(n - 2):
                    numbers[grid.corners[c] + (i + 1) * step] = first + (i if a < b else n - 3 - i)

    def number_faces(self, numbers, vertices, grid):
        for corners in FACES[self.mesh.num_axes]:
            (a, b, _, d), first = self.face_of[tuple(sorted(vertices[c] for c in corners))]
            at, along, across = (grid.position_of[vertex] for vertex in (a, b, d))
            m, k = inner_sizes(grid, at, along, across)
            for j in range(k):
                for i in range(m):
                    position = at + (i + 1) * ((along - at) // (m + 1)) + (j + 1) * ((across - at) // (k + 1))
                    numbers[position] = first + i + j * m

def inner_sizes(grid, at, along, across):
    """The numbers of control points within the edges from one corner of a face to its two neighbours."""
    by_distance = {(n - 1) * step: n - 2 for n, step in zip(grid.sizes, grid.steps)}
    return by_distance[abs(along - at)], by_distance[abs(across - at)]
