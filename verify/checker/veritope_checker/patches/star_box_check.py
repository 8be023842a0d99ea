# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims star-box-1 and star-box-turned-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/star-box.md and docs/formats/spline-json.md alone.  All numbers are integers or
fractions.  Lengths are in units of 2^E, so that all boxes have integer corners.
"""
from fractions import Fraction
from itertools import compress

from ..common.errors import Reject
from .star_box_itd import read_subject
from .star_box_patches import FULL, glue, halves, patches_of
from .star_box_read import MAX_DEPTH, Certificate

MAX_DEGREE = 15
MAX_HALVINGS = 64                       # of one curve in the crossing number
UNITS = 2000                            # of work for each leaf and box
MAX_CACHED = 4 * 10 ** 6                # integers kept for later boxes

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker(claim.magic, statement, body, read_subject(model, statement["subject_format"]), skip).run()


# ---------------------------------------------------------------- section 4: nodes, descents, S1

class Node:
    """A root or a quarter of a node.  at: its corners in the patch's parameters, in units of 1 / FULL (barycentric for
    a triangle)."""
    __slots__ = ("patch", "level", "at", "net", "parent", "place", "lo", "hi", "g", "kids", "keep")

    def __init__(self, patch, level, at, net, parent=None, place=0):
        self.patch, self.level, self.at, self.net, self.parent, self.place = patch, level, at, net, parent, place
        self.g = self.kids = self.lo = self.keep = None

    def hull(self):
        """The least and the greatest value of each coordinate, as (numerator, denominator > 0)."""
        if self.lo is None:
            x, y, z, w = [[c for row in a for c in row] for a in self.net]
            if not self.patch.rational:                     # all w are equal
                self.lo = [(min(a), w[0]) for a in (x, y, z)]
                self.hi = [(max(a), w[0]) for a in (x, y, z)]
            else:
                self.lo, self.hi = zip(*[extremes(a, w) for a in (x, y, z)])
        return self.lo, self.hi

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

    def kept(self, arrays):
        """Flags of the coefficients that S1 is about. True: all of them; False: S1 does not hold, because two collapsed
        sides share a corner."""
        if self.keep is None:
            sides = [s for s in range(self.patch.num_sides)
                     if self.line(s)[0] is not None and self.patch.sides[self.line(s)[0]] is None]
            if len({self.patch.corner(s, end) for s in sides for end in (0, 1)}) < 2 * len(sides):
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
    """The root nodes of a patch, v fastest."""
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
        items = []
        for node in self.roots:
            lo, hi = node.hull()
            items.append(([n // d for n, d in lo], [-(-n // d) for n, d in hi], node))
        self.top = hierarchy(items)

    def spend(self, condition, units=1):
        self.work -= units
        if self.work < 0:
            raise Reject(condition, "too much work")

    def roots_near(self, misses, condition):
        stack = [self.top] if self.top else []
        while stack:
            lo, hi, item = stack.pop()
            self.spend(condition)
            if not misses([(n, 1) for n in lo], [(n, 1) for n in hi]):
                if isinstance(item, Node):
                    yield item
                else:
                    stack += item

    def descend(self, misses, condition, taken):
        """The nodes that are taken. Nodes whose hulls miss are dropped; the others are split, down to the last
        level."""
        stack, result = list(self.roots_near(misses, condition)), []
        while stack:
            node = stack.pop()
            self.spend(condition, node.patch.cost)
            if misses(*node.hull()):
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
        """Forgets cached nodes if there are too many; nodes that are in use keep what they need."""
        if self.cached > MAX_CACHED:
            for root in self.roots:
                root.kids = root.g = None
            self.cached = 0

def hierarchy(items):
    """Halves along the axis on which the middles spread most: (lo, hi, node or two halves)."""
    if not items:
        return None
    lo, hi = [min(c) for c in zip(*[i[0] for i in items])], [max(c) for c in zip(*[i[1] for i in items])]
    if len(items) == 1:
        return items[0]
    axis = max(range(3), key=lambda k: max(i[0][k] + i[1][k] for i in items) - min(i[0][k] + i[1][k] for i in items))
    items.sort(key=lambda i: i[0][axis] + i[1][axis])
    return lo, hi, [hierarchy(items[:len(items) // 2]), hierarchy(items[len(items) // 2:])]

def misses_box(box):
    (x0, y0, z0), (x1, y1, z1) = box.lo, box.hi
    def misses(lo, hi):
        return (lo[0][0] > x1 * lo[0][1] or hi[0][0] < x0 * hi[0][1] or lo[1][0] > y1 * lo[1][1] or
                hi[1][0] < y0 * hi[1][1] or lo[2][0] > z1 * lo[2][1] or hi[2][0] < z0 * hi[2][1])
    return misses

def misses_segment(p, d, is_ray):
    """Whether a box misses the points p + t d with 0 <= t (and t <= 1 unless it is a ray), as a function of the box."""
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


# ---------------------------------------------------------------- section 4: the crossing number

class Crossing:
    """The crossing number of the tested nodes of a star box. spend: called for each curve that is halved."""

    def __init__(self, nodes, box, spend):
        self.box, self.spend = box, spend
        self.d = [b - a for a, b in zip(*box.c)]
        self.k = max(range(3), key=lambda k: (abs(self.d[k]), -k))
        # line: (from, to, direction, curve) of each side of a node on it
        self.lines = {}
        for node in nodes:
            for s in range(node.patch.num_sides):
                self.add_side(node, s)

    def add_side(self, node, s):
        patch = node.patch
        side, e, value = node.line(s)
        a, b = [end[1 - e if patch.is_tensor else (e + 2) % 3] for end in node.ends(s)]
        curve, direction = self.project(patch.side(s, node.net)), -1 if patch.flag else 1
        if a > b:
            a, b, curve, direction = b, a, [c[::-1] for c in curve], -direction
        line = patch, e, value
        if side is not None:
            if patch.sides[side] is None:
                return
            line, is_first = patch.sides[side]
            # the first of the two sides rises along the edge, the other falls
            if (direction < 0) == is_first:
                a, b, curve = FULL - b, FULL - a, [c[::-1] for c in curve]
            direction = 1 if is_first else -1
        self.lines.setdefault(line, []).append((a, b, direction, curve))

    def project(self, points):
        k, d, c = self.k, self.d, self.box.c[0]
        def coordinate(i):
            return [(p[i] - p[3] * c[i]) * d[k] - (p[k] - p[3] * c[k]) * d[i] for p in points]
        return [coordinate((k + 1) % 3), coordinate((k + 2) % 3)]

    def number(self):
        total = 0
        for sides in self.lines.values():
            steps, multiplicity = {}, 0
            for a, b, direction, _ in sides:
                steps[a] = steps.get(a, 0) + direction
                steps[b] = steps.get(b, 0) - direction
            places = sorted(steps)
            for a, b in zip(places, places[1:]):
                multiplicity += steps[a]
                if multiplicity:
                    side = next(side for side in sides if side[0] <= a and b <= side[1])
                    total += multiplicity * self.part(side, a, b)
        return total if self.d[self.k] > 0 else -total

    def part(self, side, a, b):
        """The winding number of the part [a, b] of a side."""
        stack, total = [(side[0], side[1], *side[3])], 0
        while stack:
            lo, hi, xs, ys = stack.pop()
            if a <= lo and hi <= b:
                total += self.of_curve(xs, ys)
            elif a < hi and lo < b:
                self.spend()
                mid = (lo + hi) // 2
                (x0, x1), (y0, y1) = halves(xs), halves(ys)
                stack += (lo, mid, x0, y0), (mid, hi, x1, y1)
        return total

    def of_curve(self, xs, ys):
        stack, total = [(0, xs, ys)], 0
        while stack:
            level, xs, ys = stack.pop()
            if min(ys) >= 0 or max(ys) < 0 or max(xs) <= 0:
                continue
            if min(xs) >= 0:
                total += (ys[-1] >= 0) - (ys[0] >= 0)
                continue
            self.spend()
            if level == MAX_HALVINGS:
                raise Reject("C3", "a boundary curve comes too close to the line through the centres")
            (x0, x1), (y0, y1) = halves(xs), halves(ys)
            stack += (level + 1, x0, y0), (level + 1, x1, y1)
        return total


# ---------------------------------------------------------------- section 5: mesh boxes

def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]

def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

def corners_of(patch):
    """The corners of a flat triangle."""
    return [tuple(Fraction(c, p[3]) for c in p[:3]) for p in (patch.side(1)[1], patch.side(2)[1], patch.side(0)[1])]

def triangle_misses_box(patch, box):
    """A separating direction, among the 13 that suffice for a triangle, degenerate or not, and a box."""
    t, units = corners_of(patch), ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    edges = [sub(t[i - 2], t[i]) for i in range(3)]
    for axis in [*units, cross(edges[0], edges[1]), *[cross(u, e) for u in units for e in edges]]:
        of_t = [dot(axis, p) for p in t]
        if (min(of_t) > sum(max(n * l, n * h) for n, l, h in zip(axis, box.lo, box.hi)) or
                max(of_t) < sum(min(n * l, n * h) for n, l, h in zip(axis, box.lo, box.hi))):
            return True
    return False

def common_points(s, t):
    """The corners of the intersection of two triangles, t not degenerate: s cut by the plane and the sides of t."""
    normal, polygon = cross(sub(t[1], t[0]), sub(t[2], t[0])), list(s)
    planes = [(normal, t[0]), (tuple(-n for n in normal), t[0])] + [(cross(normal, sub(t[i - 2], t[i])), t[i]) for i in range(3)]
    for n, at in planes:
        heights, result = [dot(n, sub(p, at)) for p in polygon], []
        for i, (p, h) in enumerate(zip(polygon, heights)):
            q, g = polygon[i - 1], heights[i - 1]
            if min(g, h) < 0 < max(g, h):
                result.append(tuple((x * h - y * g) / (h - g) for x, y in zip(q, p)))
            if h >= 0:
                result.append(p)
        polygon = result
    return polygon

def meet_properly(s, t, common, num_edges):
    """Whether triangles meet exactly in the hull of the common vertices.  common: the points of these vertices."""
    if (len(common), num_edges) not in ((0, 0), (1, 0), (2, 1)):
        return False
    points = common_points(s, t)
    if len(common) < 2:
        return all(p in common for p in points)
    along = sub(common[1], common[0])
    return all(cross(sub(p, common[0]), along) == (0, 0, 0) for p in points)


# ---------------------------------------------------------------- the conditions in the order of the page

class Checker:
    certificate = Certificate                               # the reader of the body

    def __init__(self, magic, statement, body, entities, skip):
        self.statement, self.entities, self.skip = statement, entities, skip
        self.cert = self.certificate(magic, body, entities)
        self.patches, self.vertex_of, self.forest, self.chi, self.inner = [], [], None, [], {}

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def run(self):
        cert = self.cert
        self.make_patches()
        edges, vertices, self.chi, self.vertex_of = glue(self.patches, self.fail)
        counts = {"patches": len(self.patches), "edges": edges, "vertices": vertices, "shells": len(self.chi),
                  "bodies": sum(sign for (_, sign), _, _, _ in cert.walks), "genus": sum(1 - c // 2 for c in self.chi),
                  "boxes": len(cert.boxes), "flipped": sum(cert.flags)}
        for i, patch in enumerate(self.patches):
            self.check_leaves(i, patch)
        for i, box in enumerate(cert.boxes):
            if box.component is None:
                self.fail("C1", "no leaf names box %d" % i)
        self.forest = Forest(self.patches, UNITS * (cert.num_leaves + len(cert.boxes) + 100))
        for i, box in enumerate(cert.boxes):
            (self.check_mesh_box if box.kind else self.check_star_box)(i, box)
        self.check_walks()
        counts.update(self.check_values())
        for key, value in counts.items():
            if self.statement[key] != value:
                self.fail("W3", "%s are %d, the statement says %d" % (key, value, self.statement[key]))

    def make_patches(self):
        for i, (entity, flag, breaks) in enumerate(zip(self.entities, self.cert.flags, self.cert.breaks)):
            if not entity or entity.dimension != 3 or max(entity.degrees) > MAX_DEGREE:
                raise Reject("B2", "entity %d is no surface or triangle in space of degree at most %d" % (i, MAX_DEGREE))
            self.patches += patches_of(entity, breaks, flag, self.cert.unit)
        for i, (patch, roots) in enumerate(zip(self.patches, self.cert.roots)):
            patch.index, patch.roots = i, roots

    def check_leaves(self, i, patch):
        """Tests C1 for the trees of patch i."""
        for root, tree in zip(root_nodes(patch), self.cert.trees[i]):
            stack = [root]
            for number in tree:
                node = stack.pop()
                if number is None:
                    stack += node.children()[::-1]
                    node.kids = None
                    continue
                box, (lo, hi) = self.cert.boxes[number], node.hull()
                if any(n < c * d for (n, d), c in zip(lo, box.lo)) or any(n > c * d for (n, d), c in zip(hi, box.hi)):
                    self.fail("C1", "a leaf of patch %d is not in its box %d" % (i, number))
                if box.component not in (None, patch.component):
                    self.fail("C1", "leaves of two components name box %d" % number)
                box.component = patch.component

    def check_star_box(self, i, box):
        nodes = self.forest.descend(misses_box(box), "C2", lambda node: "C2" in self.skip or node.has_s1(box.c))
        number = Crossing(nodes, box, lambda: self.forest.spend("C2")).number()
        if number != 1:
            self.fail("C3", "the crossing number of box %d is %d" % (i, number))

    def check_mesh_box(self, i, box):
        tested = []

        def take(node):
            if node.patch.is_flat and not triangle_misses_box(node.patch, box):
                tested.append(node.patch)
            return node.patch.is_flat

        self.forest.descend(misses_box(box), "C4", take)
        triangles = [(patch, corners_of(patch), [self.vertex_of[4 * patch.index + s] for s in range(3)]) for patch in tested]
        for n, (patch, t, of_t) in enumerate(triangles):
            if cross(sub(t[1], t[0]), sub(t[2], t[0])) == (0, 0, 0):
                return self.fail("C4", "a triangle in box %d is degenerate" % i)
            for other, s, of_s in triangles[:n]:
                self.forest.spend("C4")
                common = [p for p, v in zip(t, of_t) if v in of_s]
                edges = len({e for e, _ in patch.sides} & {e for e, _ in other.sides})
                if not meet_properly(s, t, common, edges):
                    self.fail("C4", "triangles %d and %d in box %d do not meet properly" % (other.index, patch.index, i))

    def check_walks(self):
        """Tests W1 for the walks; inner: w(c-) of each component."""
        boxes = self.cert.boxes
        for i, (start, points, end, direction) in enumerate(self.cert.walks):
            component = boxes[start[0]].component
            if any(boxes[box].kind for box, _ in [start, end or start]) or component in self.inner:
                self.fail("W1", "walk %d starts or ends at a mesh box, or its component has another walk" % i)
            if end and boxes[end[0]].component not in self.inner:
                self.fail("W1", "walk %d ends at a component without an earlier walk" % i)
            self.follow(boxes[start[0]].c[start[1]], points, end, direction, "W1")
            w = self.inner.get(boxes[end[0]].component, 1) - end[1] if end else 0
            self.inner[component] = w + start[1]
        if len(self.inner) != len(self.chi):
            self.fail("W1", "%d walks for %d components" % (len(self.inner), len(self.chi)))

    def follow(self, start, points, end, direction, condition):
        """Tests the hull descents of a polyline's segments."""
        points = [start, *points, *([self.cert.boxes[end[0]].c[end[1]]] if end else [])]
        segments = [(p, sub(q, p), False) for p, q in zip(points, points[1:])]
        if not end:
            ray = [0, 0, 0]
            ray[direction // 2] = 1 - 2 * (direction % 2)
            segments.append((points[-1], ray, True))
        for segment in segments:
            self.forest.descend(misses_segment(*segment), condition, lambda node: condition in self.skip)

    def check_values(self):
        """Tests W2; returns the numbers of the statement in which this claim differs from others, or that it alone
        has."""
        if self.statement["claim"] == "star-box-turned-1":
            last = self.inner[self.cert.boxes[self.cert.walks[-1][0][0]].component] if self.cert.walks else 1
            if last == 1:
                self.fail("W2", "w is 1 at c- of the last component")
            if any(self.cert.flags):
                self.fail("W3", "a flag is 1: it is not the model that is turned")
            return {"bodies": 0, "winding": 2 * last if last >= 0 else -2 * last - 1}
        if any(w != 1 for w in self.inner.values()):
            self.fail("W2", "w is not 1 at c- and 0 at c+ of all components")
        return {}
