# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Pairs of faces of the boundary of a simplex-spline solid (docs/certificates/dms-solid-2.md, section 4): U4 to U7."""
from fractions import Fraction

from ..common.vectors import dot, sub
from ..points.box_tree import BoxTree
from .dms_map import AXES, box_of, integer_rows
from .dms_near import block_region, unexcluded
from .dms_pairs_body import CHAIN, FOLD, VALUES

CONDITIONS = {FOLD: "U4", CHAIN: "U5", VALUES: "U6"}
RESOLUTION = 1 << 20                                        # of the boxes of a tree, in the greatest of their spreads

class Pairs:
    """Tests the pairs of a certificate. owners: the tetrahedron of each face of the boundary; spend(condition, units):
    is called for work."""

    def __init__(self, spline, boundary, owners, cert, fail, spend):
        self.spline, self.boundary, self.owners, self.cert = spline, boundary, owners, cert
        self.fail, self.spend = fail, spend
        self.reaching, self.values = {}, {}                 # by tetrahedron; by face
        self.tests = {FOLD: self.why_no_fold, CHAIN: self.why_no_chain, VALUES: self.why_not_parted}

    def test(self):
        """U4 to U6."""
        faces = range(len(self.boundary))
        listed = [[] for _ in faces]
        for pair in self.cert.pairs:
            listed[pair.i].append(pair)
        boxes = [self.box_of_values(i) for i in faces]
        tree = BoxTree(rounded(boxes))
        blocks = self.blocks_of_tetrahedra()
        for i in faces:
            for pair in listed[i]:
                self.test_listed(pair)
            others = {pair.j for pair in listed[i]}
            for j in tree.meeting(tree.boxes[i]):
                if j > i and j not in others:
                    self.test_unlisted(i, j, boxes, blocks)

    def test_shells(self, shells, bodies):
        """U7, with the numbers of the domain."""
        if shells != bodies:
            self.fail("U7", "the domain has %d shells and %d bodies" % (shells, bodies))
        if shells == 1:
            return
        boxes = []
        for faces in self.connected_faces():
            every = [self.box_of_values(i) for i in faces]
            box = [(max if end % 2 else min)(b[end] for b in every) for end in range(6)]
            for other in boxes:
                self.spend("U7")
                if not are_apart(box, other):
                    self.fail("U7", "the shell of the face %d and another one may meet" % faces[0])
            boxes.append(box)

    def connected_faces(self):
        """Lists of faces that chains of common vertices connect."""
        at_vertex, seen = {}, set()
        for i, face in enumerate(self.boundary):
            for v in face:
                at_vertex.setdefault(v, []).append(i)
        for first in range(len(self.boundary)):
            if first in seen:
                continue
            seen.add(first)
            faces = [first]
            for i in faces:                                 # it grows
                more = {j for v in self.boundary[i] for j in at_vertex[v]} - seen
                seen |= more
                faces += more
            yield faces

    def test_listed(self, pair):
        why = self.tests[pair.kind](pair)
        if why:
            self.fail(CONDITIONS[pair.kind], "the faces %d and %d: %s" % (pair.i, pair.j, why))

    def test_unlisted(self, i, j, boxes, blocks):
        """U6 for a pair that is not listed. blocks: of each tetrahedron."""
        self.spend("U6")
        if not are_apart(boxes[i], boxes[j]) and blocks[self.owners[i]].isdisjoint(blocks[self.owners[j]]):
            self.fail("U6", "the faces %d and %d are not listed, not in one block and perhaps not apart" % (i, j))

    def blocks_of_tetrahedra(self):
        """The blocks of each tetrahedron."""
        blocks = [set() for _ in self.spline.model.tetrahedra]
        for number, block in enumerate(self.cert.blocks):
            for t in block.tetrahedra:
                blocks[t].add(number)
        return blocks

    def place(self, v):
        return self.spline.knots[v][0]

    # ------------------------------------------------------------ growth

    def maps_of(self, t, condition):
        """L_gamma in integers, as Map.affine() has them, of the V_gamma that reach a tetrahedron."""
        if t not in self.reaching:
            near = unexcluded(self.spline, block_region(self.spline, [t], []), lambda: self.spend(condition))
            self.reaching[t] = [self.spline.affine(neighbour, gamma) for neighbour, gamma, _ in near]
        return self.reaching[t]

    def grows(self, direction, t, steps, condition):
        """Whether a direction grows in a tetrahedron along all of these vectors."""
        (direction,) = integer_rows([direction])
        for rows, _, _ in self.maps_of(t, condition):
            gradient = [dot(direction, column) for column in zip(*rows)]
            for step in steps:
                self.spend(condition)
                if dot(gradient, step) <= 0:
                    return False
        return True

    def why_no_fold(self, pair):
        """U4."""
        one, other = self.boundary[pair.i], self.boundary[pair.j]
        if len(set(one) & set(other)) != 2:
            return "they do not have two common vertices"
        apex = next(m for m in range(3) if one[m] not in other)
        u, v, p = [self.place(one[(apex + m) % 3]) for m in (1, 2, 0)]
        (q,) = [self.place(vertex) for vertex in other if vertex not in one]
        first, second = self.owners[pair.i], self.owners[pair.j]
        to_edge, from_edge = step_to(p, u, v, pair.feet[0]), backward(step_to(q, u, v, pair.feet[1]))
        for direction, along in zip(pair.directions, (sub(v, u), sub(u, v))):
            if not (self.grows(direction, first, [to_edge, along], "U4")
                    and self.grows(direction, second, [from_edge], "U4")):
                return "a direction does not grow"
        return None

    def why_no_chain(self, pair):
        """U5."""
        vertices, (direction,) = pair.vertices, pair.directions
        one, other = self.boundary[pair.i], self.boundary[pair.j]
        if vertices[0] not in one or vertices[-1] not in other:
            return "the chain does not lead from the one to the other"
        paths = [(self.owners[pair.i], [(v, vertices[0]) for v in one if v != vertices[0]])]
        for t, edge in zip(pair.tetrahedra, zip(vertices, vertices[1:])):
            if not set(edge) <= set(self.spline.model.tetrahedra[t]):
                return "an edge of the chain is not in tetrahedron %d" % t
            paths.append((t, [edge]))
        paths.append((self.owners[pair.j], [(vertices[-1], v) for v in other if v != vertices[-1]]))
        for t, edges in paths:
            if not self.grows(direction, t, [sub(self.place(b), self.place(a)) for a, b in edges], "U5"):
                return "the direction does not grow in tetrahedron %d" % t
        return None

    # ------------------------------------------------------------ values

    def values_of(self, i):
        """The values of a face: (x, y, z, d) stands for the point (x, y, z) / d, integers, d > 0."""
        if i not in self.values:
            corners, points = [self.place(v) for v in self.boundary[i]], set()
            for rows, offset, denominator in self.maps_of(self.owners[i], "U6"):
                for q in corners:
                    points.add(tuple(Fraction(dot(row, q) + c, denominator) for row, c in zip(rows, offset)))
            self.values[i] = [tuple(c for row in integer_rows([[*point], [1]]) for c in row) for point in points]
        return self.values[i]

    def box_of_values(self, i):
        """(least x, greatest x, ...) of the values of a face."""
        values = self.values_of(i)
        return [end for axis in AXES for end in (-greatest(backward(axis), values), greatest(axis, values))]

    def why_not_parted(self, pair):
        """U6 for a listed pair."""
        (direction,) = integer_rows(pair.directions)
        one, other = self.values_of(pair.i), self.values_of(pair.j)
        self.spend("U6", len(one) + len(other))
        if greatest(direction, one) >= -greatest(backward(direction), other):
            return "the direction does not part their values"
        return None

def backward(step):
    return tuple(-c for c in step)

def step_to(point, u, v, share):
    """The vector from a point to (1 - share) u + share v, times the denominator of the share."""
    a, b = share.numerator, share.denominator
    return tuple((b - a) * x + a * y - b * z for x, y, z in zip(u, v, point))

def greatest(direction, values):
    """The greatest product of an integer direction with the values of a face."""
    most, over = None, 1
    for x, y, z, denominator in values:
        product = dot(direction, (x, y, z))
        if most is None or product * over > most * denominator:
            most, over = product, denominator
    return Fraction(most, over)

def are_apart(one, other):
    """Whether two closed boxes have no common point."""
    return any(one[m + 1] < other[m] or other[m + 1] < one[m] for m in (0, 2, 4))

def rounded(boxes):
    """Boxes times a positive number, rounded outward to integers."""
    spread = max(max(ends[m + 1] for ends in boxes) - min(ends[m] for ends in boxes) for m in (0, 2, 4))
    factor = RESOLUTION / spread if spread else 1
    return [box_of([[c * factor for c in box[::2]], [c * factor for c in box[1::2]]]) for box in boxes]
