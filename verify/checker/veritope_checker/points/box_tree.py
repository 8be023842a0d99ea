# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Finds the triangles that decide about a point of the claim points-1, in a tree of boxes (docs/certificates/points.md,
section 5).  The answer does not depend on the tree."""

LEAF = 4                                                    # triangles of a leaf, at most

class BoxTree:
    """points: integers.  A box is (least x, greatest x, least y, greatest y, least z, greatest z)."""

    def __init__(self, points, triangles):
        self.boxes = []                                     # of the triangles
        for t in triangles:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = [points[v] for v in t]
            self.boxes.append((min(ax, bx, cx), max(ax, bx, cx), min(ay, by, cy), max(ay, by, cy),
                               min(az, bz, cz), max(az, bz, cz)))
        self.nodes = []                                     # (box, left, right) or (box, triangles, None)
        ends = [[box[side] for box in self.boxes] for side in (0, 2, 4)]
        todo = [(list(range(len(triangles))), None, 1)]
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

    def near(self, floors, ceilings, direction):
        """(triangles whose closed boxes contain the point, triangles that the ray may stab, size of the union).  floors
        and ceilings: the coordinates of the point, rounded to integers both ways."""
        u, down = direction // 2, direction % 2
        p, q = (u + 1) % 3, (u + 2) % 3
        u0, u1, p0, p1, q0, q1 = 2 * u, 2 * u + 1, 2 * p, 2 * p + 1, 2 * q, 2 * q + 1
        below_u, below_p, below_q = floors[u], floors[p], floors[q]
        above_u, above_p, above_q = ceilings[u], ceilings[p], ceilings[q]
        touched, crossed, both = [], [], 0
        nodes, boxes, stack = self.nodes, self.boxes, [0]
        while stack:
            box, left, right = nodes[stack.pop()]
            if (box[p0] > below_p or box[p1] < above_p or box[q0] > below_q or box[q1] < above_q or
                    (box[u0] > below_u if down else box[u1] < above_u)):
                continue
            if right is not None:
                stack += (left, right)
                continue
            for f in left:
                box = boxes[f]
                if box[p0] > below_p or box[p1] < above_p or box[q0] > below_q or box[q1] < above_q:
                    continue
                starts, ends = box[u0] <= below_u, box[u1] >= above_u
                inside = starts and ends
                # v < greatest is floor(v) < greatest, since that is an integer
                ahead = (starts if down else ends) and below_p < box[p1] and below_q < box[q1]
                if inside:
                    touched.append(f)
                if ahead:
                    crossed.append(f)
                both += inside or ahead
        return touched, crossed, both
