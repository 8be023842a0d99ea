# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Finds the triangles or patches that decide about a point of the claim points-1, in a tree of boxes
(docs/certificates/points.md, sections 5 and 6).  The answer does not depend on the tree."""

LEAF = 4                                                    # boxes of a leaf, at most

def boxes_of_triangles(points, triangles):
    """points: integers."""
    for t in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = [points[v] for v in t]
        yield (min(ax, bx, cx), max(ax, bx, cx), min(ay, by, cy), max(ay, by, cy), min(az, bz, cz), max(az, bz, cz))

class BoxTree:
    """A box is (least x, greatest x, least y, greatest y, least z, greatest z): integers."""

    def __init__(self, boxes):
        self.boxes = boxes
        self.nodes = []                                     # (box, left, right) or (box, numbers of boxes, None)
        ends = [[box[side] for box in self.boxes] for side in (0, 2, 4)]
        todo = [(list(range(len(boxes))), None, 1)]
        while todo:                                         # parents come before their children
            part, parent, side = todo.pop()
            if parent is not None:
                self.nodes[parent][side] = len(self.nodes)
            if len(part) <= LEAF:
                self.nodes.append([None, part, None])
                continue
            spreads = [max(map(end.__getitem__, part)) - min(map(end.__getitem__, part)) for end in ends]
            part.sort(key=ends[spreads.index(max(spreads))].__getitem__)
            todo += ((part[len(part) // 2:], len(self.nodes), 2), (part[:len(part) // 2], len(self.nodes), 1))
            self.nodes.append([None, None, None])
        for node in reversed(self.nodes):
            inner = [self.boxes[f] for f in node[1]] if node[2] is None else [self.nodes[i][0] for i in node[1:]]
            node[0] = tuple(choose(box[i] for box in inner) for i, choose in enumerate((min, max) * 3))

    def on_ray(self, floors, ceilings, direction):
        """The boxes that meet the closed ray of this direction.  floors and ceilings: the coordinates of its first
        point, rounded to integers both ways."""
        u, down = direction // 2, direction % 2
        p, q = (u + 1) % 3, (u + 2) % 3
        u0, u1, p0, p1, q0, q1 = 2 * u, 2 * u + 1, 2 * p, 2 * p + 1, 2 * q, 2 * q + 1
        below_u, below_p, below_q = floors[u], floors[p], floors[q]
        above_u, above_p, above_q = ceilings[u], ceilings[p], ceilings[q]
        found, nodes, boxes, stack = [], self.nodes, self.boxes, [0]

        def misses(box):
            return (box[p0] > below_p or box[p1] < above_p or box[q0] > below_q or box[q1] < above_q or
                    (box[u0] > below_u if down else box[u1] < above_u))

        while stack:
            box, left, right = nodes[stack.pop()]
            if misses(box):
                continue
            if right is not None:
                stack += (left, right)
            else:
                found += [f for f in left if not misses(boxes[f])]
        return found

    def meeting(self, box, see=lambda: None):
        """The numbers of the boxes that have a point in common with this one; see() is called for each."""
        x0, x1, y0, y1, z0, z1 = box
        nodes, boxes, stack = self.nodes, self.boxes, [0]
        while stack:
            (a, b, c, d, e, f), left, right = nodes[stack.pop()]
            if a > x1 or b < x0 or c > y1 or d < y0 or e > z1 or f < z0:
                continue
            if right is not None:
                stack += (left, right)
                continue
            for n in left:
                a, b, c, d, e, f = boxes[n]
                if not (a > x1 or b < x0 or c > y1 or d < y0 or e > z1 or f < z0):
                    see()
                    yield n

    def near(self, floors, ceilings, direction):
        """(triangles whose closed boxes contain the point, triangles that the ray may stab, size of the union)"""
        u = direction // 2
        p, q = (u + 1) % 3, (u + 2) % 3
        u0, u1, p1, q1 = 2 * u, 2 * u + 1, 2 * p + 1, 2 * q + 1
        below_u, above_u, below_p, below_q = floors[u], ceilings[u], floors[p], floors[q]
        touched, crossed, both = [], [], 0
        for f in self.on_ray(floors, ceilings, direction):
            box = self.boxes[f]
            inside = box[u0] <= below_u and box[u1] >= above_u
            # v < greatest is floor(v) < greatest, since that is an integer
            ahead = below_p < box[p1] and below_q < box[q1]
            if inside:
                touched.append(f)
            if ahead:
                crossed.append(f)
            both += inside or ahead
        return touched, crossed, both
