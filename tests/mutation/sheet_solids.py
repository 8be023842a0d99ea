# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Small thin solids of flat patches with certificates of version 2: tests only. Each is made in coordinates in which its boxes are along
the axes, and placed by an affine map whose inverse is the frame of its boxes. Few patches and leaves: a checker takes milliseconds."""
from fractions import Fraction as Q

import patch_solids as ps
import star_box_2_forge as forge2
from patch_solids import UNIT, forge

from veritope_checker.common.vectors import cross, dot

nodes = forge.star_nodes
UNITS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
# Rotations up to a factor, shears, scalings, unimodular matrices; some mirror. The last one is for a single plate: walks along the others
# in the gaps between several would take long.
MATRICES = (None, UNITS, ((2, -1, 2), (2, 2, -1), (-1, 2, 2)), ((1, 0, 0), (0, 1, 0), (1, -1, 1)), ((1, 2, 0), (0, 1, 0), (0, 0, 1)),
            ((1, 0, 0), (0, 1, 0), (0, 0, -1)), ((0, 1, 0), (1, 0, 0), (0, 0, 2)), ((3, -4, 0), (4, 3, 0), (0, 0, 5)), ((1, 0, 9), (0, 1, 0), (0, 0, 1)))


class Place:
    """p becomes M p + t. The rows of the frame are those of the inverse of M, times |det M|, in any order, with any signs."""

    def __init__(self, rng, matrix):
        self.rows, self.shift = matrix or UNITS, [rng.randint(-3, 3) for _ in range(3)]
        a, b, c = zip(*self.rows)
        det = dot(a, cross(b, c))
        self.scale, self.is_mirrored = abs(det), det < 0
        self.inverse = [[x if det > 0 else -x for x in row] for row in (cross(b, c), cross(c, a), cross(a, b))]
        self.order = rng.sample(range(3), 3) if matrix else [0, 1, 2]
        self.signs = [rng.choice((1, 1, -1)) if matrix else 1 for _ in range(3)]
        self.frames = [tuple(tuple(s * x for x in self.inverse[k]) for k, s in zip(self.order, self.signs))] if matrix else []

    def point(self, p):
        return tuple(dot(row, p) + t for row, t in zip(self.rows, self.shift))

    def box(self, kind, lo, hi, *centres):
        ends = [[(self.scale * Q(c) + dot(row, self.shift)) * UNIT for c, row in zip(p, self.inverse)] for p in (lo, hi)]
        pairs = [sorted(s * end[k] for end in ends) for k, s in zip(self.order, self.signs)]
        centres = [[whole(self.point(c)) for c in pair] for pair in centres]
        return forge2.Box2(kind, [int(a) for a, _ in pairs], [int(b) for _, b in pairs], centres, frame=len(self.frames))

    def plane(self, height, tilt=(0, 0)):
        """p_3 + tilt p_1 + tilt p_2 - height, up to a positive factor, as a polynomial in the model's coordinates."""
        row = [dot(column, (*tilt, 1)) for column in zip(*self.inverse)]
        return {**dict(zip(UNITS, row)), (0, 0, 0): -(self.scale * Q(height) + dot(row, self.shift)) * UNIT}


def whole(p):
    result = [int(Q(x) * UNIT) for x in p]
    assert all(x == Q(y) * UNIT for x, y in zip(result, p)), p
    return result


def product(p, q):
    result = {}
    for a, x in p.items():
        for b, y in q.items():
            key = tuple(i + j for i, j in zip(a, b))
            result[key] = result.get(key, 0) + x * y
    return result


def separate(box, polynomial, degree, rng, *signs):
    """Adds a separator of this degree to the box with the signs of a linear polynomial: it times a positive one in x - o, so that
    coefficients stay short however fine the grid is on which o lies."""
    def positive(form, constant):
        o = box.centres[0][0]
        return {**dict(zip(UNITS, form)), (0, 0, 0): constant - dot(form, o)}
    if degree == 2:                                       # near the model it is positive
        polynomial = product(polynomial, positive([rng.randint(-2, 2) for _ in range(3)], UNIT << 20))
    if degree == 3:
        form = positive([rng.randint(-2, 2) for _ in range(3)], rng.randint(-9, 9) * UNIT)
        square = product(form, form)
        square[0, 0, 0] += 1 << 60
        polynomial = product(polynomial, square)
    box.separate(polynomial, 20, *signs)


# ---------------------------------------------------------------- polyhedra

def faces(loops, place):
    """Flat patches over loops of three or four points, seen from outside to the left."""
    out = []
    for loop in loops:
        points = [place.point(p) for p in (loop[::-1] if place.is_mirrored else loop)]
        if len(points) == 3:
            out.append(forge.triangle(points))
        else:
            a, b, c, d = points
            out.append(forge.surface([[a, d], [b, c]]))
    return out


RINGS = (((-4, -3), (4, -3), (0, 5)), ((-4, -4), (4, -4), (4, 4), (-4, 4)), ((-4, -4), (5, -3), (3, 4), (-3, 3)))


def slab(ring, low, high):
    """The loops of a prism over a convex ring."""
    bottom, top = [[(x, y, z) for x, y in ring] for z in (low, high)]
    n = len(ring)
    return [top, bottom[::-1], *[(bottom[i - 1], bottom[i], top[i], top[i - 1]) for i in range(n)]]


def tip(at, base, half):
    """A pyramid over a triangle, its first point an apex."""
    ring = [(at[0] + half * x, at[1] + half * y, base) for x, y in ((-1, -1), (1, -1), (0, 1))]
    loops = [[at, ring[i], ring[i - 1]] for i in range(3)] + [ring]
    return [loop[::-1] for loop in loops] if base < at[2] else loops


def reversed_loops(loops):
    return [loop[::-1] for loop in loops]


# ---------------------------------------------------------------- plans

class Builder:
    """Trees of few leaves: each star box is named by one leaf of each patch that has one in it, the others name the first mesh box that
    contains them and has their component for its owner, or a star box."""

    def __init__(self, place, loops, boxes, flags=None):
        entities = faces(loops, place)
        self.plan = forge2.Plan2(entities)
        self.plan.flags = flags or [0] * len(entities)
        self.plan.frames, self.plan.boxes = list(place.frames), list(boxes)
        prover = ps.reader(self.plan)
        self.patches, self.plan.values = prover.patches, dict(prover.counts)
        self.frames = [None, *place.frames]
        self.plan.trees = [[self.tree(node, set())] for node in self.roots()]

    def roots(self):
        return [next(nodes.root_nodes(patch)) for patch in self.patches]

    def fits(self, node, box, touching=False):
        lo, hi = node.hull(self.frames[box.frame])
        if box.owner not in (None, node.patch.component):
            return False
        if touching:
            return all(n <= x * d for (n, d), x in zip(lo, box.hi)) and all(n >= x * d for (n, d), x in zip(hi, box.lo))
        return all(n >= x * d for (n, d), x in zip(lo, box.lo)) and all(n <= x * d for (n, d), x in zip(hi, box.hi))

    def tree(self, node, done):
        boxes = list(enumerate(self.plan.boxes))
        wanted = [n for n, box in boxes if box.kind == 0 and n not in done and self.fits(node, box, True)]
        fitting, before = [n for n in wanted if self.fits(node, boxes[n][1])], set(done)
        if len(fitting) < len(wanted) and node.level < 9:
            kids = [self.tree(kid, done) for kid in node.children()]
            if done != before:
                return kids
        if fitting:
            done.add(fitting[0])
            return fitting[0]
        for kind in (1, 0):
            for n, box in boxes:
                if box.kind == kind and self.fits(node, box):
                    return n
        if node.level > 9:
            raise ValueError("no box for a node of patch %d at %r" % (node.patch.index, node.at))
        return [self.tree(kid, done) for kid in node.children()]

    def walks(self, walks):
        self.plan.walks = walks
        self.plan.values["bodies"] = sum(sign for _, sign, _, _ in walks)
        return self.plan


def away(place, p, axis, by=64):
    """(points, end): from p along an axis of the place's coordinates far away, then to infinity along one of the model's."""
    far = list(p)
    far[axis] += by
    way = [row[axis] * by for row in place.rows]
    k = max(range(3), key=lambda i: abs(way[i]))
    return [whole(place.point(far))], 2 * k + (way[k] < 0)


def stack(rng, place, gaps, ring=None, degree=1, wide=6, shared=True, at=(Q(1, 2), Q(1, 4))):
    """Plates one above the other, gaps: their thicknesses and those of the air between, in turn. A box with all walls, for each plate a
    box with its upper wall, and a mesh box for each."""
    ring, heights = ring or rng.choice(RINGS), [Q(0)]
    for gap in gaps:
        heights.append(heights[-1] + gap)
    low, high, c = -Q(3, 2), heights[-1] + Q(3, 2), at
    near, far = [x - Q(1, 2) for x in c], [x + Q(1, 2) for x in c]
    least, boxes, loops, walks = min(gaps), [], [], []
    below, above = (*c, -1), (*c, heights[-1] + 1)
    walls = place.box(0, (*near, low), (*far, high), *[(below, above) if i % 2 else (above, below) for i in range(len(heights))])
    for i, (a, b) in enumerate(zip(heights, heights[1:])):
        separate(walls, place.plane((a + b) / 2), degree, rng, *[2 - (j > i) for j in range(len(heights))])
    plates = list(zip(heights[::2], heights[1::2]))
    for n, (a, b) in enumerate(plates):
        loops += slab(ring, a, b)
        d, room = least / 4, least * 2 if len(gaps) > 1 else 1
        one = place.box(0, (*near, b - 2 * d), (*far, b + 2 * d), ((*c, b - d), (*c, b + d)))
        mesh = place.box(1, (-wide, -wide, a - room), (wide, wide, b + room))
        one.owner = mesh.owner = n
        boxes += [one, mesh]
        walks.append((shared + n, 1, *away(place, (*c, b + d), 0 if b < heights[-1] else 2)))
    return Builder(place, loops, [walls] * shared + boxes[::2] + boxes[1::2]).walks(walks)


def cavity(rng, place, gap, degree=1, upside_down=False):
    """A solid with a cavity whose roof is thin. upside_down: and a body in the cavity, inside out, whose walk ends at the box with two
    sheets."""
    ring, half = RINGS[1], [(x // 2, y // 2) for x, y in RINGS[1]]
    c, d, top, roof = (Q(1, 2), Q(1, 4)), gap / 4, Q(2), Q(2) - gap
    walls = place.box(0, (-Q(1, 2), -Q(3, 4), 1), (Q(3, 2), Q(5, 4), 3), ((*c, Q(5, 4)), (*c, Q(11, 4))), ((*c, Q(11, 4)), (*c, Q(5, 4))))
    separate(walls, place.plane((top + roof) / 2), degree, rng, 1, 2)
    outer = place.box(0, (-Q(1, 2), -Q(3, 4), top - d), (Q(3, 2), Q(5, 4), top + 2 * d), ((*c, top - d / 2), (*c, top + d)))
    inner = place.box(0, (-Q(1, 2), -Q(3, 4), roof - 2 * d), (Q(3, 2), Q(5, 4), roof + d), ((*c, roof + d / 2), (*c, roof - d)))
    around, hole = place.box(1, (-6, -6, -6), (6, 6, 4)), place.box(1, (-3, -3, -1), (3, 3, roof + 1))
    outer.owner, inner.owner, around.owner, hole.owner = 0, 1, 0, 1
    loops = slab(ring, -3, top) + reversed_loops(slab(half, 0, roof))
    boxes = [walls, outer, inner, around, hole]
    walks = [(1, 1, *away(place, (*c, top + d), 2)), (2, 0, [], (1, 0))]
    if upside_down:                                       # its c- lies in the cavity, as that of the first sheet of `walls`
        low = Q(3, 4)
        third = place.box(0, (-Q(1, 2), -Q(3, 4), low - d), (Q(7, 8), Q(7, 8), low + d), ((*c, low + d / 2), (*c, low - d / 2)))
        mesh = place.box(1, (-2, -2, 0), (2, 2, low + d))
        third.owner = mesh.owner = 2
        loops += reversed_loops(slab([(x // 4, y // 4) for x, y in RINGS[1]], Q(1, 4), low))
        boxes, walks = boxes + [third, mesh], walks + [(5, 0, [], (0, 0))]
    return Builder(place, loops, boxes).walks(walks)


def poke(rng, place, gap, degree=1, way="above"):
    """A block and a pyramid whose apex is a gap away from the block's upper face: above it; a cavity, below it; or "parallel", a pyramid
    in the block, which is no solid. If the gap is not greater than 0 all crossings lie in one box with two sheets."""
    below = way != "above"
    sign, small, h, d = -1 if below else 1, Q(1, 8), Q(3, 4), Q(1, 8)
    at = (Q(0), Q(0), sign * gap)
    loops = slab(RINGS[1], -6, 0)
    half = 1 if way == "parallel" else 2
    body = tip(at, at[2] + 4 * sign, half)
    loops += reversed_loops(body) if way == "cavity" else body
    low, high = (0, 0, small - h), (0, 0, h - small)
    both = place.box(0, (-2, -2, -h), (2, 2, h), (low, high), (low, high) if way == "parallel" else (high, low))
    separate(both, place.plane(at[2] / 2), degree, rng, 2 - below, 1 + below)
    c = Q(11, 4)
    one = place.box(0, (2, 2, -2 * d), (Q(7, 2), Q(7, 2), 2 * d), ((c, c, -d), (c, c, d)))
    far = at[2] + 4 * sign
    if way == "parallel":                                 # on a face of the tip that looks out of the block
        t, z = Q(1, 64), at[2] - Q(1, 8)
        base = place.box(0, (-t, -3 * t, z - 2 * t), (t, -t, z + 2 * t), ((0, -Q(3, 2) * t, z), (0, -Q(5, 2) * t, z)))
        out = (0, -Q(5, 2) * t, z)
    else:
        base = place.box(0, (-Q(1, 2), -1, far - 2 * d), (Q(1, 2), 0, far + 2 * d), ((0, -Q(1, 2), far - d), (0, -Q(1, 2), far + d)))
        out = (0, -Q(1, 2), far + d)
    slabs = [place.box(1, (x0, y0, -7), (x1, y1, d)) for x0, y0, x1, y1 in
             ((-5, -5, -2, 5), (2, -5, 5, 5), (-2, -5, 2, -2), (-2, 2, 2, 5))]
    slabs.append(place.box(1, (-2, -2, -7), (2, 2, -Q(11, 2))))
    rest = place.box(1, (-3, -3, min(sign * Q(1, 4), far) - (d if below else 0)), (3, 3, max(sign * Q(1, 4), far) + d))
    for box in (one, *slabs):
        box.owner = 0
    base.owner = rest.owner = 1
    builder = Builder(place, loops, [both, one, base, *slabs, rest])
    if way == "cavity":
        walk = 2, 0, [whole(place.point((c, c, far - d)))], (1, 0)
    else:
        walk = 2, 1, *away(place, out, 2)
    return builder.walks([(1, 1, *away(place, (c, c, d), 2)), walk])


def folded_roof(rng, place, degree=1):
    """A square block whose roof goes outward, back and outward again, so that its first and third part cross in a ring. Each part has S1
    by some sheet's centres: the middle one by those of the floor."""
    profile = (3, Q(1, 4)), (1, Q(1, 2)), (6, -Q(1, 4)), (6, -Q(3, 4))
    rings = [[(x * r, y * r, z) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))] for r, z in profile]
    loops = [[(Q(0), Q(0), Q(0)), rings[0][i - 1], rings[0][i]] for i in range(4)]
    loops += [(a[i], a[i - 1], b[i - 1], b[i]) for a, b in zip(rings, rings[1:]) for i in range(4)] + [rings[-1][::-1]]
    low, high = (0, 0, -Q(7, 8)), (0, 0, Q(7, 8))
    both = place.box(0, (-4, -4, -1), (4, 4, 1), (low, high), (high, low))
    separate(both, place.plane(-Q(1, 2)), degree, rng, 1, 2)
    one = place.box(0, (Q(9, 2), Q(9, 2), -1), (Q(11, 2), Q(11, 2), -Q(1, 2)), ((5, 5, -Q(5, 8)), (5, 5, -Q(7, 8))))
    r = Q(13, 4)
    slabs = [place.box(1, (x0, y0, -1), (x1, y1, 1)) for x0, y0, x1, y1 in ((-7, -7, -r, 7), (r, -7, 7, 7), (-7, -7, 7, -r), (-7, r, 7, 7))]
    under = place.box(1, (-7, -7, -1), (7, 7, -Q(1, 2)))
    return Builder(place, loops, [both, one, under, *slabs]).walks([(1, 1, *away(place, (5, 5, -Q(7, 8)), 2, -64))])
