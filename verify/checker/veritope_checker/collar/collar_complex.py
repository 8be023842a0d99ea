# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The complex of collar_check.py: conditions K0 to K3 of docs/certificates/collar.md, integers only.

A *place* is (z S + y) S + x in units of the smallest cells; a face is 4 place + axis of its normal, with the place of
its least corner, so that faces ascend as on the page; an edge piece is 4 place + axis of its direction, with the place
of its lower end.
"""
from bisect import bisect_left, bisect_right

from ..common.errors import Reject
from ..patches.star_box_patches import Groups

LEVELS = 20
FULL = 1 << LEVELS                      # the edge of the root
S = 2 * FULL
STEP = (1, S, S * S)
MAX_CELLS = 1 << 24

def place(p):
    return (p[2] * S + p[1]) * S + p[0]

def corner(at):
    return at % S, at // S % S, at // (S * S)

def third_bits(m):
    """The number whose bits 0, 1, 2, ... are the bits 0, 3, 6, ..., 57 of m."""
    m &= 0x1249249249249249
    for shift, mask in ((2, 0x10c30c30c30c30c3), (4, 0x100f00f00f00f00f), (8, 0x1f0000ff0000ff), (16, 0x1f00000000ffff),
                        (32, 0x1fffff)):
        m = (m | m >> shift) & mask
    return m

def spread(i):
    for shift, mask in ((32, 0x1f00000000ffff), (16, 0x1f0000ff0000ff), (8, 0x100f00f00f00f00f),
                        (4, 0x10c30c30c30c30c3),
                        (2, 0x1249249249249249)):
        i = (i | i << shift) & mask
    return i

def code_of(p, size):
    """The code of the cell with this least corner."""
    return 2 * (spread(p[0]) | spread(p[1]) << 1 | spread(p[2]) << 2) + size ** 3

def cell_of(code):
    """(least corner, size) of the cell with this code, or None if no cell has it."""
    zeros = (code & -code).bit_length() - 1
    if code <= 0 or zeros % 3 or zeros > 3 * LEVELS or code >> 3 * LEVELS + 1:
        return None
    m = code >> zeros + 1 << zeros                          # Morton code of the least corner
    return (third_bits(m), third_bits(m >> 1), third_bits(m >> 2)), 1 << zeros // 3

class Cells:
    """Tests K0."""

    def __init__(self, codes, stated):
        self.codes, self.cells = codes, [cell_of(code) for code in codes]
        if None in self.cells:
            raise Reject("K0", "a code of no cell")
        for (a, (_, s)), (b, (_, t)) in zip(zip(codes, self.cells), zip(codes[1:], self.cells[1:])):
            if b - a < max(s, t) ** 3:
                raise Reject("K0", "a cell inside another")
        self.index = {code: i for i, code in enumerate(codes)}
        self.stated = stated

    def any_inside(self, code, size):
        """Whether a cell of K lies in this cell and is not in K itself."""
        return bisect_left(self.codes, code + size ** 3) > bisect_right(self.codes, code - size ** 3)

    def squares(self, p, size, axis, near):
        """A node of the octree and its side at half `near` of the axis: the nodes whose sides are the faces of the
        subdivision there, or None if no cell in the node touches that side."""
        code = code_of(p, size)
        if code in self.index:
            return [(p, size)]
        if size == 1 or not self.any_inside(code, size):
            return None
        half, found, kids = size // 2, [], []
        for n in range(4):
            kid = list(p)
            kid[axis] += near * half
            kid[axis - 1] += (n & 1) * half
            kid[axis - 2] += (n >> 1) * half
            kids.append((tuple(kid), half))
            found.append(self.squares(*kids[-1], axis, near))
        if not any(found):
            return None
        return [square for of_kid, kid in zip(found, kids) for square in of_kid or [kid]]

class Complex:
    """The common subdivision.  faces: ascending; sizes and cells (one or two) of each."""

    def __init__(self, cells):
        self.cells, of_face = cells, {}
        for i, (p, size) in enumerate(cells.cells):
            for axis in range(3):
                for near, beyond in ((0, p[axis] + size), (1, p[axis] - size)):
                    plane = p[axis] + (0 if near else size)
                    for q, of_square in self.side(p, size, axis, near, beyond):
                        q = [*q]
                        q[axis] = plane
                        of_face.setdefault(4 * place(q) + axis, [of_square]).append(i)
        self.faces = sorted(of_face)
        self.sizes = [of_face[f][0] for f in self.faces]
        self.cells_of = [of_face[f][1:] for f in self.faces]
        self.find_edges()
        self.boundary = [n for n, of in enumerate(self.cells_of) if len(of) == 1]
        self.edge_to_boundary = {}
        for n in self.boundary:
            for e in self.edges_of[n]:
                self.edge_to_boundary.setdefault(e, []).append(n)
        self.find_components()

    def side(self, p, size, axis, near, beyond):
        q = list(p)
        q[axis] = beyond
        if not 0 <= beyond < FULL:
            return [(q, size)]
        return self.cells.squares(tuple(q), size, axis, near) or [(q, size)]

    def find_edges(self):
        vertices = set()
        for f, size in zip(self.faces, self.sizes):
            a, b = STEP[f % 4 - 2] * size, STEP[f % 4 - 1] * size
            vertices |= {f // 4, f // 4 + a, f // 4 + b, f // 4 + a + b}
        self.next = []                                      # along each axis: of each vertex, if there is one
        for axis in range(3):
            lines = {}
            for v in vertices:
                i = corner(v)[axis]
                lines.setdefault(v - i * STEP[axis], []).append(v)
            following = {}
            for line in lines.values():
                line.sort()
                following.update(zip(line, line[1:]))
            self.next.append(following)
        self.edges_of = [self.edges_of_face(f, size) for f, size in zip(self.faces, self.sizes)]

    def edges_of_face(self, f, size):
        result, at = [], f // 4
        for along, across in ((f % 4 - 2, f % 4 - 1), (f % 4 - 1, f % 4 - 2)):
            axis = along % 3
            for v in (at, at + size * STEP[across]):
                end = v + size * STEP[along]
                while v != end:
                    result.append(4 * v + axis)
                    v = self.next[axis][v]
        return result

    def ends(self, e):
        return e // 4, self.next[e % 4][e // 4]

    def find_components(self):
        """Sets component_of, the component of each boundary face, and body_of, the body of |K| of each cell."""
        number = {n: i for i, n in enumerate(self.boundary)}
        faces, cells = Groups(len(self.boundary)), Groups(len(self.cells.cells))
        for around in self.edge_to_boundary.values():
            for n in around[1:]:
                faces.unite(number[around[0]], number[n])
        for of in self.cells_of:
            if len(of) == 2:
                cells.unite(*of)
        self.body_of = cells.number()
        self.component_of = dict(zip(self.boundary, faces.number()))
        self.num_components = max(self.component_of.values()) + 1
        self.num_bodies = max(self.body_of) + 1
        self.body_of_component = [0] * self.num_components
        for n, c in self.component_of.items():
            self.body_of_component[c] = self.body_of[self.cells_of[n][0]]

    # ------------------------------------------------------------ K1 to K3: None, or what is wrong

    def bad_edge(self):
        """Tests K1E."""
        for e, around in self.edge_to_boundary.items():
            if len(around) != 2:
                return "an edge at %s lies in %d boundary faces" % (corner(e // 4), len(around))
        return None

    def bad_vertex(self):
        """Tests K1V, given K1E: the boundary faces at a vertex are connected through edges there."""
        number = {}
        pairs = [[number.setdefault((v, n), len(number)) for n in around] for e, around in self.edge_to_boundary.items()
                 for v in self.ends(e)]
        groups = Groups(len(number))
        for first, *others in pairs:
            for n in others:
                groups.unite(first, n)
        seen = {}
        for (v, _), n in number.items():
            if seen.setdefault(v, groups.find(n)) != groups.find(n):
                return "the boundary faces at %s form several cycles" % (corner(v),)
        return None

    def bad_sides(self, sides):
        """Tests K2."""
        of_body = [[] for _ in range(self.num_bodies)]
        for component, side in enumerate(sides):
            of_body[self.body_of_component[component]].append(side)
        for body, of in enumerate(of_body):
            if sorted(of) != [0, 1]:
                inner = of.count(1)
                return "component %d has %d boundary components in d+ and %d others" % (body, inner, len(of) - inner)
        return None

    def bad_collapse(self, sides, steps):
        """Tests K3."""
        outer = {n for n, c in self.component_of.items() if sides[c] == 1}
        remaining = [list(of) for of in self.cells_of]
        faces_of = [[] for _ in self.cells.cells]
        for n, of in enumerate(self.cells_of):
            for cell in of:
                faces_of[cell].append(n)
        gone = set()
        for n in steps:
            if not 0 <= n < len(self.faces) or n in gone or n in outer or len(remaining[n]) != 1:
                return "face %d is not free" % n
            for m in faces_of[remaining[n][0]]:
                if m != n:
                    remaining[m].remove(remaining[n][0])
            gone.add(n)
            remaining[n] = []
        if any(remaining):
            return "a cell is left"
        edges = {n: self.edges_of[n] for n in range(len(self.faces)) if n not in gone}
        kept_edges = {e for n in outer for e in self.edges_of[n]}
        left = greedy(edges, {e for of in self.edges_of for e in of} - kept_edges)
        if left[0] != outer:
            return "%d faces are left" % len(left[0] - outer)
        kept = {v for e in kept_edges for v in self.ends(e)}
        left = greedy({e: self.ends(e) for e in left[1] | kept_edges},
                      {v for following in self.next for pair in following.items() for v in pair} - kept)
        if left[0] != kept_edges or left[1]:
            return "edges or vertices are left"
        return None

    def chi(self, component):
        """The Euler characteristic of a component of the boundary."""
        faces = [n for n, c in self.component_of.items() if c == component]
        edges = {e for n in faces for e in self.edges_of[n]}
        return len({v for e in edges for v in self.ends(e)}) - len(edges) + len(faces)

    def least_vertex(self, component):
        return corner(min(v for n, c in self.component_of.items() if c == component for e in self.edges_of[n]
                          for v in self.ends(e)))

def greedy(parts_of, free):
    """Removes a free part that lies in exactly one cell together with that cell, as long as such a part exists.

    A part is one dimension lower than its cell. Returns (cells that are left, free parts that are left)."""
    of_part = {}
    for cell, parts in parts_of.items():
        for part in parts:
            of_part.setdefault(part, set()).add(cell)
    left, free = set(parts_of), set(free)
    stack = [part for part in free if len(of_part.get(part, ())) == 1]
    while stack:
        part = stack.pop()
        if part not in free or len(of_part[part]) != 1:
            continue
        cell = of_part[part].pop()
        left.remove(cell)
        free.remove(part)
        for other in parts_of[cell]:
            of_part[other].discard(cell)
            if other in free and len(of_part[other]) == 1:
                stack.append(other)
    return left, free
