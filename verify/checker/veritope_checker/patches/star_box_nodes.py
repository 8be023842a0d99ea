# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Pieces of patches: nodes, condition S1, and descents in the hierarchy of all roots (section 4 of star-box.md)."""
from fractions import Fraction
from itertools import compress

from ..common.errors import Reject
from ..common.vectors import dot
from . import star_box_work as work_of
from .star_box_patches import FULL
from .star_box_read import MAX_DEPTH

MAX_CACHED = 4 * 10 ** 6                # integers kept for later boxes

class Node:
    """A root or a quarter of a node.  at: its corners in the patch's parameters, in units of 1 / FULL (barycentric for
    a triangle)."""
    __slots__ = ("patch", "level", "at", "net", "parent", "place", "lo", "hi", "g", "kids", "keep")

    def __init__(self, patch, level, at, net, parent=None, place=0):
        self.patch, self.level, self.at, self.net, self.parent, self.place = patch, level, at, net, parent, place
        self.g = self.kids = self.lo = self.keep = None

    def hull(self, frame=None):
        """The least and the greatest (numerator, denominator > 0) of each coordinate; with a frame, of the control
        points that its matrix maps."""
        if frame is None and self.lo is not None:
            return self.lo, self.hi
        *axes, w = [[c for row in a for c in row] for a in self.net]
        if frame is not None:
            axes = [[a * x + b * y + c * z for x, y, z in zip(*axes)] for a, b, c in frame]
        if not self.patch.rational:                         # all w are equal
            lo, hi = [(min(a), w[0]) for a in axes], [(max(a), w[0]) for a in axes]
        else:
            lo, hi = zip(*[extremes(a, w) for a in axes])
        if frame is None:
            self.lo, self.hi = lo, hi
        return lo, hi

    def children(self):
        if self.kids is None:
            nets = list(zip(*[self.patch.quarters(a) for a in self.net]))
            self.kids = [Node(self.patch, self.level + 1, at, net, self, i)
                         for i, (at, net) in enumerate(zip(self.corners_of_children(), nets))]
        return self.kids

    def corners_of_children(self):
        def mid(a, b):
            return tuple((x + y) // 2 for x, y in zip(a, b))
        if self.patch.is_tensor:
            p, q, r, s = self.at
            a, b, c, d, m = mid(p, q), mid(q, r), mid(r, s), mid(s, p), mid(p, r)
            return [(p, a, m, d), (d, m, c, s), (a, q, b, m), (m, b, r, c)]
        p, q, r = self.at
        a, b, c = mid(q, r), mid(r, p), mid(p, q)
        return [(p, c, b), (c, q, a), (b, a, r), (a, b, c)]

    def ends(self, s):
        return self.at[self.patch.corner(s, 0)], self.at[self.patch.corner(s, 1)]

    def line(self, s):
        """Where side s lies: (the side of the patch or None, constant coordinate, its value)."""
        a, b = self.ends(s)
        e = next(i for i, (x, y) in enumerate(zip(a, b)) if x == y)
        if self.patch.is_tensor:
            return {(1, 0): 0, (0, FULL): 1, (1, FULL): 2, (0, 0): 3}.get((e, a[e])), e, a[e]
        return None if a[e] else e, e, a[e]

    def collapsed_sides(self):
        """The sides that lie in collapsed sides of the patch; None if two of them share a corner."""
        lines = [self.line(s)[0] for s in range(self.patch.num_sides)]
        sides = [s for s, side in enumerate(lines) if side is not None and self.patch.sides[side] is None]
        corners = {self.patch.corner(s, end) for s in sides for end in (0, 1)}
        return None if len(corners) < 2 * len(sides) else sides

    def kept(self, arrays):
        """Flags of the coefficients that S1 is about; True: all; False: none, S1 fails at a corner of two collapsed
        sides."""
        if self.keep is None:
            sides = self.collapsed_sides()
            if sides is None:
                self.keep = False
            elif sides:
                rows, n = [], 0
                for row in arrays[0]:
                    rows.append(list(range(n, n + len(row))))
                    n += len(row)
                left_out = {i for s in sides for i in self.patch.side_of(rows, s)}
                self.keep = [i not in left_out for i in range(n)]
            else:
                self.keep = True
        return self.keep

    def coefficients(self):
        """D, X, Y, Z of g_c = D - c.(X, Y, Z) on this node."""
        if self.g is None:
            if self.parent:
                parts = list(zip(*[self.patch.quarters(a) for a in self.parent.coefficients()]))
                for kid in [*(self.parent.kids or ()), self]:
                    kid.g = parts[kid.place]
            else:
                self.g = self.patch.on_root(self.patch.make_g(), self.at)
        return self.g

    def has_s1(self, c):
        g = self.coefficients()
        keep = self.kept(g)
        if not keep:
            return False
        (a0, a1, a2), (b0, b1, b2) = c
        terms = zip(*[[x for row in a for x in row] for a in g])
        for d, x, y, z in terms if keep is True else compress(terms, keep):
            if d <= a0 * x + a1 * y + a2 * z or d >= b0 * x + b1 * y + b2 * z:
                return False
        return True

def extremes(a, w):
    least = greatest = a[0], w[0]
    for n, d in zip(a, w):
        if n * least[1] < least[0] * d:
            least = n, d
        if n * greatest[1] > greatest[0] * d:
            greatest = n, d
    return least, greatest

def root_nodes(patch):
    """v fastest."""
    if not patch.is_tensor:
        yield Node(patch, 0, [(FULL, 0, 0), (0, FULL, 0), (0, 0, FULL)], patch.net)
        return
    a, b = (FULL >> n for n in patch.roots)
    for u in range(0, FULL, a):
        for v in range(0, FULL, b):
            at = [(u, v), (u + a, v), (u + a, v + b), (u, v + b)]
            yield Node(patch, 0, at, patch.on_root(patch.net, at))

class Forest:
    """All roots in a hierarchy of boxes; counts the work and bounds what is kept in memory."""

    def __init__(self, patches, work):
        self.roots, self.work, self.cached = [node for patch in patches for node in root_nodes(patch)], work, 0
        self.with_g = set()                                 # the patches on which g was needed
        items = []
        for node in self.roots:
            lo, hi = node.hull()
            items.append(([n // d for n, d in lo], [-(-n // d) for n, d in hi], node))
        self.top = hierarchy(items)

    def spend(self, condition, units=1):
        self.work -= units
        if self.work < 0:
            raise Reject(condition, "too much work")

    def spend_on_g(self, condition, node):
        if node.patch not in self.with_g:
            self.with_g.add(node.patch)
            self.spend(condition, work_of.of_products(node.patch))
        self.spend(condition, work_of.of_g(node))

    def roots_near(self, misses, condition, frame):
        stack, visited = [self.top] if self.top else [], 0
        while stack:
            lo, hi, item = stack.pop()
            if visited % work_of.NODES_OF_UNIT == 0:
                self.spend(condition)
            visited += 1
            if frame is not None:
                lo, hi = mapped_box(frame, lo, hi)
            if not misses([(n, 1) for n in lo], [(n, 1) for n in hi]):
                if isinstance(item, Node):
                    yield item
                else:
                    stack += item

    def descend(self, misses, condition, taken, frame=None, price=1):
        """The nodes that are taken; those whose hulls (in the frame) miss are dropped, the others split down to the
        last level.  price: of a node, times the work of its hull."""
        stack, result = list(self.roots_near(misses, condition, frame)), []
        while stack:
            node = stack.pop()
            self.spend(condition, price * work_of.of_hull(node))
            if misses(*node.hull(frame)):
                continue
            if taken(node):
                result.append(node)
            elif node.level == MAX_DEPTH:
                raise Reject(condition, "a node is left at level %d" % MAX_DEPTH)
            else:
                if node.kids is None:
                    self.forget()
                    p, q = node.patch.degrees * (1 if node.patch.is_tensor else 2)
                    self.cached += 16 * (3 * p * 3 * q + (p + 1) * (q + 1))
                stack += node.children()
        return result

    def forget(self):
        """Nodes that are in use keep what they need of their own."""
        if self.cached > MAX_CACHED:
            for root in self.roots:
                root.kids = root.g = None
            self.cached = 0

def hierarchy(items):
    """Halves along the axis in which the middles spread most; (lo, hi, node or two halves)."""
    if not items:
        return None
    lo, hi = [min(c) for c in zip(*[i[0] for i in items])], [max(c) for c in zip(*[i[1] for i in items])]
    if len(items) == 1:
        return items[0]
    axis = max(range(3), key=lambda k: max(i[0][k] + i[1][k] for i in items) - min(i[0][k] + i[1][k] for i in items))
    items.sort(key=lambda i: i[0][axis] + i[1][axis])
    return lo, hi, [hierarchy(items[:len(items) // 2]), hierarchy(items[len(items) // 2:])]

def in_frame(frame, points):
    """The points that the matrix of a frame maps these to; without a frame, the points themselves."""
    return points if frame is None else [tuple(dot(row, p) for row in frame) for p in points]

def mapped_box(frame, lo, hi):
    """A box around what the matrix of a frame maps the box from lo to hi to."""
    return [[sum(a * (x if a > 0 else y) for a, x, y in zip(row, p, q)) for row in frame]
            for p, q in ((lo, hi), (hi, lo))]

def misses_box(box):
    (x0, y0, z0), (x1, y1, z1) = box.lo, box.hi
    def misses(lo, hi):
        return (lo[0][0] > x1 * lo[0][1] or hi[0][0] < x0 * hi[0][1] or lo[1][0] > y1 * lo[1][1] or
                hi[1][0] < y0 * hi[1][1] or lo[2][0] > z1 * lo[2][1] or hi[2][0] < z0 * hi[2][1])
    return misses

def misses_segment(p, d, is_ray):
    """The points p + t d, 0 <= t (<= 1 if it is no ray)."""
    def misses(lo, hi):
        first, last = Fraction(0), None if is_ray else Fraction(1)
        for k in range(3):
            if d[k] == 0:
                if lo[k][0] > p[k] * lo[k][1] or hi[k][0] < p[k] * hi[k][1]:
                    return True
                continue
            t0, t1 = [Fraction(n - p[k] * m, d[k] * m) for n, m in ((lo[k], hi[k]) if d[k] > 0 else (hi[k], lo[k]))]
            first, last = max(first, t0), t1 if last is None else min(last, t1)
            if first > last:
                return True
        return False
    return misses
