# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims star-box-1 and star-box-turned-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/star-box.md and docs/formats/spline-json.md alone.  All numbers are integers or
fractions.  Lengths are in units of 2^E, so that all boxes have integer corners.
"""
from ..common.errors import Reject
from ..common.vectors import cross, sub
from . import star_box_work as work_of
from .star_box_crossing import Crossing
from .model_subject import read_subject
from .star_box_nodes import Forest, in_frame, misses_box, misses_segment, root_nodes
from .star_box_patches import glue, patches_of
from .star_box_read import Certificate
from .star_box_triangles import Flat, corners_of, meet_properly, triangle_misses_box

MAX_DEGREE = 15

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker(claim.magic, statement, body, read_subject(model, statement["subject_format"]), skip).run()


class Checker:
    """The conditions in the order of the page."""
    certificate = Certificate                               # the reader of the body

    def __init__(self, magic, statement, body, entities, skip):
        self.statement, self.entities, self.skip = statement, entities, skip
        self.cert = self.certificate(magic, body, entities)
        self.patches, self.vertex_of, self.forest, self.chi, self.inner = [], [], None, [], {}
        self.work = work_of.allowed(statement["subject_bytes"] + len(body))

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def run(self):
        self.make_patches()
        self.compare(self.numbers())

    def compare(self, counts):
        for key, value in counts.items():
            if self.statement[key] != value:
                self.fail("W3", "%s are %d, the statement says %d" % (key, value, self.statement[key]))

    def numbers(self):
        """Tests the conditions from P1 on; returns the numbers of the statement."""
        cert = self.cert
        edges, vertices, self.chi, self.vertex_of = glue(self.patches, self.fail)
        counts = {"patches": len(self.patches), "edges": edges, "vertices": vertices, "shells": len(self.chi),
                  "bodies": sum(sign for (_, sign), _, _, _ in cert.walks), "genus": sum(1 - c // 2 for c in self.chi),
                  "boxes": len(cert.boxes), "flipped": sum(cert.flags)}
        for i, patch in enumerate(self.patches):
            self.check_leaves(i, patch)
        for i, box in enumerate(cert.boxes):
            if box.component is None:
                self.fail("C1", "no leaf names box %d" % i)
        self.forest = Forest(self.patches, self.work)
        for i, box in enumerate(cert.boxes):
            (self.check_mesh_box if box.kind else self.check_star_box)(i, box)
        self.check_walks()
        counts.update(self.check_values())
        return counts

    def make_patches(self):
        for i, (entity, flag, breaks) in enumerate(zip(self.entities, self.cert.flags, self.cert.breaks)):
            if not entity or entity.dimension != 3 or max(entity.degrees) > MAX_DEGREE:
                raise Reject("B2", "entity %d is no surface or triangle in space of degree at most %d"
                             % (i, MAX_DEGREE))
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
                self.work -= work_of.of_hull(node)
                if self.work < 0:
                    raise Reject("C1", "too much work")
                box = self.cert.boxes[number]
                lo, hi = node.hull(box.frame)
                if any(n < c * d for (n, d), c in zip(lo, box.lo)) or any(n > c * d for (n, d), c in zip(hi, box.hi)):
                    self.fail("C1", "a leaf of patch %d is not in its box %d" % (i, number))
                if box.component not in (None, patch.component) and not box.is_shared:
                    self.fail("C1", "leaves of two components name box %d" % number)
                box.component = patch.component

    def check_star_box(self, i, box):
        def has_s1(node):
            self.forest.spend_on_g("C2", node)
            self.forest.spend("C2", work_of.of_s1(node))
            return "C2" in self.skip or node.has_s1(box.c)

        nodes = self.forest.descend(misses_box(box), "C2", has_s1)
        number = Crossing(nodes, box, lambda units: self.forest.spend("C2", units)).number()
        if number != 1:
            self.fail("C3", "the crossing number of box %d is %d" % (i, number))

    def check_mesh_box(self, i, box):
        found = {}                                          # the triangles of each flat patch

        def take(node):
            index, triangles = node.patch.index, self.triangles_of(node.patch)
            if triangles:
                found[index] = [t for t in triangles if not triangle_misses_box(in_frame(box.frame, t.corners), box)]
            return bool(triangles)

        self.forest.descend(misses_box(box), "C4", take, box.frame)
        tested = [t for triangles in found.values() for t in triangles]
        for n, t in enumerate(tested):
            if cross(sub(t.corners[1], t.corners[0]), sub(t.corners[2], t.corners[0])) == (0, 0, 0):
                return self.fail("C4", "a triangle in box %d is degenerate" % i)
            for s in tested[:n]:
                self.forest.spend("C4", work_of.of_pair(self.patches[s.patch], self.patches[t.patch]))
                common = [p for p, v in zip(t.corners, t.vertices) if v in s.vertices]
                if not meet_properly(s.corners, t.corners, common, len(t.edges & s.edges)):
                    self.fail("C4", "triangles %d and %d in box %d do not meet properly" % (s.patch, t.patch, i))

    def triangles_of(self, patch):
        """The triangles that a patch is in mesh boxes, or () if it is not flat."""
        if not patch.is_flat:
            return ()
        return [Flat(patch.index, corners_of(patch), [self.vertex_of[4 * patch.index + s] for s in range(3)],
                     {side[0] for side in patch.sides if side})]

    def check_walks(self):
        """Tests W1 for the walks; inner: w(c-) of each component."""
        boxes = self.cert.boxes
        for i, (start, points, end, direction) in enumerate(self.cert.walks):
            component = boxes[start[0]].component
            if not all(self.may_walk(boxes[box]) for box, _ in [start, end or start]) or component in self.inner:
                self.fail("W1", "walk %d starts or ends at a %s, or its component has another walk"
                          % (i, self.no_walks))
            if end and boxes[end[0]].component not in self.inner:
                self.fail("W1", "walk %d ends at a component without an earlier walk" % i)
            self.follow(boxes[start[0]].c[start[1]], points, end, direction, "W1")
            w = self.inner.get(boxes[end[0]].component, 1) - end[1] if end else 0
            self.inner[component] = w + start[1]
        if len(self.inner) != len(self.chi):
            self.fail("W1", "%d walks for %d components" % (len(self.inner), len(self.chi)))

    no_walks = "mesh box"

    def may_walk(self, box):
        """May walks start and end at this box?"""
        return not box.kind

    def follow(self, start, points, end, direction, condition):
        """Tests the hull descents of a polyline's segments."""
        points = [start, *points, *([self.cert.boxes[end[0]].c[end[1]]] if end else [])]
        segments = [(p, sub(q, p), False) for p, q in zip(points, points[1:])]
        if not end:
            ray = [0, 0, 0]
            ray[direction // 2] = 1 - 2 * (direction % 2)
            segments.append((points[-1], ray, True))
        for segment in segments:
            self.forest.descend(misses_segment(*segment), condition, lambda node: condition in self.skip, price=2)

    def check_values(self):
        """Tests W2; returns the numbers of the statement in which this claim differs from others, or that it alone
        has."""
        if "turned" in self.statement["claim"]:
            last = self.inner[self.cert.boxes[self.cert.walks[-1][0][0]].component] if self.cert.walks else 1
            if last == 1:
                self.fail("W2", "w is 1 at c- of the last component")
            if any(self.cert.flags):
                self.fail("W3", "a flag is 1: it is not the model that is turned")
            return {"bodies": 0, "winding": 2 * last if last >= 0 else -2 * last - 1}
        if any(w != 1 for w in self.inner.values()):
            self.fail("W2", "w is not 1 at c- and 0 at c+ of all components")
        return {}
