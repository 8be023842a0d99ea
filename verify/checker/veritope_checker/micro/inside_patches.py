# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The patches of a spline model in binary64, with bounds for all errors, and how the surface of a microstructure lies
near them (docs/certificates/micro-inside.md, section 8): I1 and I4."""
from fractions import Fraction
from heapq import heappop, heappush
from math import inf, nextafter, sqrt

from ..common.errors import Reject
from ..common.vectors import cross
from ..points.box_tree import BoxTree
from .inside_blocks import size_of
from .inside_nodes import TINY, ULP, halves, nearest
from .inside_pairs import descends
from .inside_parts import halves_of
from .inside_space import MAX_COORDINATE, Points
from .inside_surface import (FREE_NODES, MAX_LEVEL, MAX_PAIRS, MAX_SKIN_LEVEL, NODES_OF_PART, SKIN_NODES_OF_BRIDGE,
                             test_ends)

KEPT_LEVELS = 16                                            # of the patches of the model
MAX_SEARCHED = 1 << 14                                      # nodes of the model for one node of an end: our own bound

class ModelNode:
    """A node of a patch.  arrays: X, Y, Z, and W if the weights differ, the slowest axis to be halved next; error: of
    their numbers, in units of `scale`, and of W itself."""

    def __init__(self, arrays, sizes, scale, error, level=0):
        self.arrays, self.sizes, self.scale, self.error, self.level = arrays, sizes, scale, error, level
        self.points = self.divided()
        self.box, self.size = self.points.box, size_of(self.points.box)
        self.normal = self.kids = None

    def divided(self):
        """Points."""
        (x, y, z), w, error = self.arrays[:3], self.arrays[3:], self.error * self.scale
        if not w:
            return Points(x, y, z, 2 * error + TINY if error < MAX_COORDINATE else inf)
        w, least = w[0], min(w[0])
        if not (least > 4 * self.error and error < MAX_COORDINATE):
            return Points(x, y, z, inf)
        # The scale is that of X, Y, Z; a coordinate is at most the scale over the least weight, with its error.
        x, y, z = [[a / b for a, b in zip(c, w)] for c in (x, y, z)]
        greatest = max(self.scale, *map(abs, (*x, *y, *z)))
        return Points(x, y, z, 4 * (error + self.error * greatest) / least + 4 * ULP * greatest + TINY)

    def halves(self):
        if self.kids:
            return self.kids
        n = self.sizes[0]
        both = zip(*[halves(a, n) for a in self.arrays])
        kids = [ModelNode(list(arrays), self.sizes[::-1], self.scale, self.error + (n + 1) * ULP, self.level + 1)
                for arrays in both]
        if self.level < KEPT_LEVELS:
            self.kids = kids
        return kids

    def across(self):
        """(a vector across the node, least and greatest product with it), or () if it is 0."""
        if self.normal is None:
            points, last = list(zip(self.points.x, self.points.y, self.points.z)), self.sizes[1] - 1
            a, b, c, d = points[0], points[-1 - last], points[last], points[-1]
            u, v = [[q - p + s - r for p, q, r, s in zip(a, *rest, d)] for rest in ((b, c), (c, b))]
            # (b - a) + (d - c) and (c - a) + (d - b)
            normal = cross(u, v)
            greatest = max(map(abs, normal))
            self.normal = ()
            if 1e-200 < greatest < inf:
                normal = tuple(c / greatest for c in normal)
                self.normal = normal, self.points.extent(*normal)
        return self.normal

class Group:
    """Patches, as nodes of a tree of their boxes."""
    level = -1

    def __init__(self, box, parts):
        self.box, self.size, self.parts = box, size_of(box), parts

    def halves(self):
        return self.parts

def tree_of(grids):
    """The root of a tree over the nodes of patches. grids: of patch_points_check.py."""
    nodes = [node_of(grid) for grid in grids]
    tree, made = BoxTree([node.box for node in nodes]), {}
    for n in reversed(range(len(tree.nodes))):              # parents come before their children
        box, left, right = tree.nodes[n]
        made[n] = Group(box, [nodes[m] for m in left] if right is None else [made.pop(left), made.pop(right)])
    return made[0]

def node_of(grid):
    points = [c for row in grid.rows for c in row]
    heaviest = max(c[3] for c in points)
    is_rational = any(c[3] != heaviest for c in points)
    arrays = [[nearest(Fraction(c[k], heaviest)) for c in points] for k in range(4 if is_rational else 3)]
    scale = max(abs(c) for a in arrays[:3] for c in a)
    if not scale < MAX_COORDINATE:
        arrays, scale = [[0.] * len(points)] * 3, inf
    return ModelNode(arrays, tuple(p + 1 for p in grid.degrees), scale, 2 * ULP)


# ---------------------------------------------------------------- I1, I4

class NearPatches:
    """parts: Parts; grids: of patch_points_check.py."""

    def __init__(self, parts, grids):
        self.parts, self.root, self.pairs, self.nodes = parts, tree_of(grids), 0, 0

    def see(self, x):
        self.pairs += max(1, len(x.pieces()))
        if self.pairs > FREE_NODES + NODES_OF_PART * self.parts.count + MAX_PAIRS:
            raise Reject("I1", "too many pairs of nodes whose boxes meet")

    def test_i1(self):
        model = self.parts.model
        for n, grid in enumerate(model.grids):
            if any(grid.cells) and not self.is_off(self.parts.blocks_of(n).whole()):
                raise Reject("I1", "a tile in a grid in volume %d may meet the model" % grid.volume)
        for n, bridge in enumerate(model.bridges):
            if not self.is_off(self.parts.of_bridge(bridge)):
                raise Reject("I1", "bridge %d may meet the model" % n)
        for n, sweep in enumerate(model.sweeps):
            if not self.is_off(self.parts.of_sweep(sweep)):
                raise Reject("I1", "sweep %d may meet the model" % n)

    def is_off(self, part):
        return descends(part, self.root, self.parts, MAX_LEVEL, self.see, are_apart)

    def test_i4(self, skin):
        """skin: a fraction."""
        model, self.pairs, self.nodes = self.parts.model, 0, 0
        most_nodes = FREE_NODES + SKIN_NODES_OF_BRIDGE * (len(model.bridges) + len(model.sweeps))
        distance = nextafter(nearest(skin), 0)

        def is_within(points):
            self.nodes += 1
            if self.nodes > most_nodes:
                raise Reject("I4", "the ends take too many nodes")
            return self.is_within(points, distance)

        test_ends(self.parts, skin, is_within)

    def is_within(self, points, distance):
        """Is there a node of a level of at most 24, no point of which is farther than the distance from any of these?
        The nearest ones are halved first, MAX_SEARCHED at most."""
        around, todo, count = list(zip(points.x, points.y, points.z)), [(0., 0, self.root)], 0
        outer = {f(around, key=lambda p, k=k: p[k]) for k in range(3) for f in (min, max)}
        while todo and count < MAX_SEARCHED:
            _, _, node = heappop(todo)
            for kid in halves_of(node, self.parts):
                self.pairs += 1
                if self.pairs > MAX_PAIRS:
                    raise Reject("I4", "too many pairs of nodes")
                limit = distance - points.slack(max(map(abs, kid.box))) * 2
                if (distances(outer, kid.box)[0] > distance + 2 * points.error
                        or kid.level >= 0 and kid.points.error == inf):
                    continue
                _, farthest = distances(around, kid.box)
                if kid.level >= 0:
                    if farthest <= limit:
                        return True
                    if kid.level == MAX_SKIN_LEVEL:
                        if are_within(around, kid.points, limit - 2 * kid.points.error):
                            return True
                        continue
                count += 1
                heappush(todo, (farthest, count, kid))
        return False

def are_apart(x, y):
    """Is a node of a part, or a block, apart from a node of the model, on each box of the map?  Their boxes meet."""
    if type(y) is Group:
        return False
    pieces = x.pieces()
    return bool(pieces) and all(is_apart(points, y) for points in pieces)

def is_apart(points, node):
    a, b, c, d, e, f = points.box
    g, h, i, j, k, l = node.box
    if a > h or g > b or c > j or i > d or e > l or k > f:
        return True
    across = node.across()
    if not across:
        return False
    normal, (least, greatest) = across
    lo, hi = points.extent(*normal)
    margin = points.slack() + node.points.slack()
    return lo > greatest + margin or hi < least - margin

def distances(points, box):
    """(at least the greatest distance of a point from the box, at most; at most the greatest distance of a point of
    both), but for roundings."""
    a, b, c, d, e, f = box
    near = far = 0.
    for x, y, z in points:
        p, q, r = max(a - x, 0., x - b), max(c - y, 0., y - d), max(e - z, 0., z - f)
        near = max(near, p * p + q * q + r * r)
        p, q, r = max(x - a, b - x), max(y - c, d - y), max(z - e, f - z)
        far = max(far, p * p + q * q + r * r)
    return sqrt(near) * (1 - 8 * ULP), sqrt(far) * (1 + 8 * ULP)

def are_within(points, others, limit):
    for x, y, z in zip(others.x, others.y, others.z):
        for a, b, c in points:
            if (x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 > limit * limit:
                return False
    return limit >= 0
