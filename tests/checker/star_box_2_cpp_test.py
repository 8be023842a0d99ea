#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of star-box-2: certificates of version 1 as ones of version 2, in frames and with several sheets, and a lie for each
new condition, beside the honest certificate that differs from it in nothing else. VERITOPE_CHECK names the program."""
import copy
import hashlib
import itertools
import json
import math
import unittest
from fractions import Fraction as Q

import judges
import star_box_forge as forge
import star_box_2_models as models2
import star_box_models as models

in_cpp = judges.in_cpp
varint, zigzag, u32 = forge.varint, forge.zigzag, forge.u32
KINDS = {"surface": 1, "triangle": 2}
UNIT = 1 << 20                                            # coordinates are counted in 2^-20
IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
TURNED = ((3, 4, 0), (-4, 3, 0), (0, 0, 5))
SHEARED = ((8, 0, 0), (1, 8, 0), (0, -1, 8))
MIRRORED = ((1, 0, 0), (0, 0, 1), (0, 1, 0))


def image(matrix, point):
    return tuple(sum(a * c for a, c in zip(row, point)) for row in matrix)


class Box:
    """sheets: (c-, c+) in units of 2^(E + scale); separators: (degree, t, coefficients); signs: one list for each sheet."""

    def __init__(self, kind, lo, size, sheets=(), frame=0, shift=0):
        self.kind, self.lo, self.size, self.frame, self.shift = kind, list(lo), list(size), frame, shift
        self.sheets, self.scale, self.separators, self.signs = [list(s) for s in sheets], 0, [], [[] for _ in sheets]

    def encode(self):
        out = bytes([self.kind]) + varint(self.frame) + varint(self.shift) + b"".join(map(zigzag, self.lo)) + b"".join(map(varint, self.size))
        if self.kind:
            return out
        out += bytes([len(self.sheets), len(self.separators)]) + varint(self.scale)
        first = (0, 0, 0)
        for centre in [c for sheet in self.sheets for c in sheet]:
            out += b"".join(zigzag(a - b) for a, b in zip(centre, first))
            first = self.sheets[0][0]
        for degree, t, coefficients in self.separators:
            out += bytes([degree]) + zigzag(t) + b"".join(map(zigzag, coefficients))
        return out + bytes([sign % 3 for signs in self.signs for sign in signs])


class Plan:
    """A plan of version 1 as one of version 2."""

    def __init__(self, prover):
        self.prover, self.model, old = prover, prover.model, prover.plan
        self.entities, self.flags, self.breaks, self.roots, self.unit = old.entities, list(old.flags), old.breaks, old.roots, old.unit
        self.kinds = [KINDS[e["kind"]] for e in old.entities]
        self.trees, self.walks, self.values = copy.deepcopy(old.trees), list(old.walks), dict(old.values)
        self.frames, self.boxes, self.claim, self.tail = [], [self.box(b) for b in old.boxes], "star-box-2", b""

    @staticmethod
    def box(b):
        sheets = [] if b.kind else [[tuple(a + o << b.shift for a, o in zip(b.lo, c)) for c in (b.minus, b.plus)]]
        return Box(b.kind, b.lo, b.size, sheets, 0, b.shift)

    def leaves(self):
        """(node, box, the list that holds the leaf, its place there)."""
        def walk(node, holder, place):
            if isinstance(holder[place], int):
                yield node, holder[place], holder, place
            else:
                for i, kid in enumerate(node.children()):
                    yield from walk(kid, holder[place], i)
        for patch, trees in zip(self.prover.patches, self.trees):
            for i, node in enumerate(forge.star_nodes.root_nodes(patch)):
                yield from walk(node, trees, i)

    def into_frame(self, matrix, margin=1, which=lambda box: True):
        """These boxes become the least ones in the frame around their leaves and centres, and a margin."""
        self.frames.append(matrix)
        points = [[] for _ in self.boxes]
        for node, box, _, _ in list(self.leaves()):
            x, y, z, w = [[Q(c) for row in a for c in row] for a in node.net]
            points[box] += [image(matrix, (a / d, b / d, c / d)) for a, b, c, d in zip(x, y, z, w)]
        for box, around in zip(self.boxes, points):
            if not which(box):
                continue
            assert box.frame == 0 and box.shift == 0 and box.scale == 0
            centres = [image(matrix, c) for sheet in box.sheets for c in sheet]
            ends = [(math.floor(min(p[k] for p in around)) - margin, math.ceil(max(p[k] for p in around)) + margin) for k in range(3)]
            ends = [(min([lo, *(c[k] - 1 for c in centres)]), max([hi, *(c[k] + 1 for c in centres)])) for k, (lo, hi) in enumerate(ends)]
            box.lo, box.size = [lo for lo, _ in ends], [hi - lo for lo, hi in ends]
            box.frame = len(self.frames)
        return self

    def replace_leaves(self, box):
        """The leaves inside this box, of frame 0, name it; boxes that no leaf names any more are dropped. Returns the box's number."""
        self.boxes.append(box)
        new = len(self.boxes) - 1
        for node, _, holder, place in list(self.leaves()):
            lo, hi = node.hull()
            if all(a * l[1] <= l[0] and h[0] <= (a + s) * h[1] for a, s, l, h in zip(box.lo, box.size, lo, hi)):
                holder[place] = new
        return self.drop_boxes()[new]

    def drop_boxes(self):
        """Drops the boxes that no leaf names; the result has the new number of each other one."""
        named = sorted({leaf[1] for leaf in self.leaves()})
        number = {old: new for new, old in enumerate(named)}
        for _, old, holder, place in list(self.leaves()):
            holder[place] = number[old]
        self.boxes = [self.boxes[old] for old in named]
        self.walks = [(number[b], sign, points, end if isinstance(end, int) else (number[end[0]], end[1]))
                      for b, sign, points, end in self.walks]
        return number

    def body(self):
        out = [b"VTS2", u32(len(self.kinds)), bytes(x for pair in zip(self.kinds, self.flags) for x in pair)]
        for axes in self.breaks:
            for axis in axes:
                out += [u32(len(axis)), *map(forge.rational, axis)]
        out += [bytes(r) for r in self.roots] + [zigzag(self.unit), u32(len(self.frames))]
        out += [zigzag(a) for matrix in self.frames for row in matrix for a in row]
        out += [u32(len(self.boxes))] + [b.encode() for b in self.boxes]
        return b"".join(out) + forge.trees_and_walks(self.trees, self.walks) + self.tail

    def certificate(self, body=None):
        body = self.body() if body is None else body
        statement = {"certificate": "veritope-certificate-1", "tool": "star_box_2_cpp_test", "claim": self.claim,
                     "subject_sha256": hashlib.sha256(self.model).hexdigest(), "subject_bytes": len(self.model), "subject_format": "vjson",
                     "body_sha256": hashlib.sha256(body).hexdigest(), "boxes": len(self.boxes), "flipped": sum(self.flags), **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


def slab(half=Q(1, 4)):
    """A plate of six bilinear patches; its corners are (+-1, +-1, +-half)."""
    return models.cube(shape=lambda p: (p[0], p[1], half * p[2]))


def two_sheets(half=Q(1, 4)):
    """A box around the middle of the slab, which holds a part of its top and a part of its bottom."""
    h, width = int(half * UNIT), UNIT * 7 // 10
    sheets = [[(0, 0, 0), (0, 0, 2 * h)], [(0, 0, 0), (0, 0, -2 * h)]]
    box = Box(0, (-width, -width, -3 * h), (2 * width, 2 * width, 6 * h), sheets)
    box.separators, box.signs = [[1, 20, [0, 1, 0, 0]]], [[1], [-1]]     # z; o is the origin
    return box


class StarBox2Test(unittest.TestCase):
    def says(self, expected, plan, words=""):
        code, condition, line = in_cpp(plan.model, plan.certificate())
        self.assertEqual((code, condition), (0, "ACCEPT") if expected == "ACCEPT" else (1, expected), line)
        self.assertIn(words, line)

    def lie(self, expected, plan, change, words=""):
        """The plan is accepted, and rejected after the change."""
        self.says("ACCEPT", plan)
        changed = copy.copy(plan)
        for name in ("kinds", "frames", "boxes", "trees", "walks", "values", "flags"):
            setattr(changed, name, copy.deepcopy(getattr(plan, name)))
        change(changed)
        self.says(expected, changed, words)


def proved(entities, kind=forge.Prover, **options):
    return Plan(kind(entities, **options).prove())


class OfVersion1(StarBox2Test):
    """What version 1 proves can be proved in version 2, without frames and in them."""

    def test_one_sheet_and_no_frame(self):
        for entities in (models.bicubic_ball(), models.octant_sphere(), models.snake()):
            self.says("ACCEPT", proved(entities))

    def test_in_a_frame(self):
        scaled = tuple(tuple((1 << 28) * a for a in row) for row in TURNED)
        for entities in (models.cube(), models.bicubic_ball(), models.octant_sphere(), models.tetrahedron()):
            for matrix in (TURNED, SHEARED, MIRRORED, scaled):
                with self.subTest(matrix=matrix):
                    self.says("ACCEPT", proved(entities).into_frame(matrix))

    def test_a_mirrored_frame_does_not_turn_a_shell(self):
        """The entities are exchanged for those of the shell turned inside out."""
        plan = proved(models.cube()).into_frame(MIRRORED)
        self.says("ACCEPT", plan)
        plan.flags = [1] * 6
        plan.values["flipped"] = 6
        self.says("C2", plan)


class Frames(StarBox2Test):
    def setUp(self):
        self.plan = proved(models.bicubic_ball()).into_frame(TURNED, 0)

    def test_each_leaf_lies_in_its_box_exactly(self):
        """The boxes have no margin."""
        self.says("ACCEPT", self.plan)
        self.assertEqual(self.sides_moved_inwards(self.plan), {"C1", "B1"})          # B1: a centre, not a leaf, was at the side

    @staticmethod
    def sides_moved_inwards(plan):
        """The conditions that fail when each side of six boxes is shifted by one in turn."""
        seen = set()
        for box in plan.boxes[:6]:
            for k in range(3):
                for move in (1, 0):
                    box.lo[k], box.size[k] = box.lo[k] + move, box.size[k] - 1
                    seen.add(in_cpp(plan.model, plan.certificate())[1])
                    box.lo[k], box.size[k] = box.lo[k] - move, box.size[k] + 1
        return seen

    def test_a_box_in_a_frame_counts_in_its_own_unit(self):
        """Its sides are at 2^89 units of 2^E, and at 2^51 of its own; one of these decides."""
        long = tuple(tuple((1 << 28) * a for a in row) for row in TURNED)
        plan = proved(models.bicubic_ball()).into_frame(long, 0)
        plan.unit -= 38
        for box in plan.boxes:
            box.shift, box.scale = 38, 38
        self.says("ACCEPT", plan)
        self.assertEqual(self.sides_moved_inwards(plan), {"C1", "B1"})
        self.lie("B1", plan, lambda plan: setattr(plan.boxes[0], "shift", 121), "too far away")
        for lo in (1 << 61, -1 << 61):
            self.lie("B1", plan, lambda plan, lo=lo: plan.boxes[0].lo.__setitem__(0, lo), "too far away")

    def test_the_matrix_is_regular_and_its_entries_are_small(self):
        def put(matrix):
            return lambda plan: plan.frames.__setitem__(0, matrix)
        self.lie("B1", self.plan, put(((1, 2, 3), (2, 4, 6), (0, 0, 1))), "determinant")
        for entry in (1 << 31, -1 << 31):
            self.lie("B1", self.plan, put(((3, 4, 0), (-4, 3, 0), (0, 0, entry))), "2^31")
        unused = [((1, 0, 0), (0, 1, 0), (0, 0, (1 << 31) - 1))]
        self.plan.frames += unused
        self.says("ACCEPT", self.plan)

    def test_the_frame_exists(self):
        self.lie("B1", self.plan, lambda plan: setattr(plan.boxes[3], "frame", 2), "frame")

    def test_frames_are_as_many_as_a_free_form_model_needs(self):
        self.plan.frames += [IDENTITY] * 70000
        self.says("ACCEPT", self.plan)

    def test_the_kinds_are_those_of_the_model(self):
        for kind in (0, 2, 3):
            self.lie("B1", self.plan, lambda plan, kind=kind: plan.kinds.__setitem__(1, kind), "kind")

    def test_a_centre_lies_inside_in_the_frame(self):
        def on_the_side(plan):
            box = plan.boxes[0]
            top = image(TURNED, box.sheets[0][0])[2]
            box.size[2] += max(0, box.lo[2] - top) if top < box.lo[2] else 0
            box.lo[2], box.size[2] = top, box.lo[2] + box.size[2] - top
        self.lie("B1", self.plan, on_the_side, "centre")


class Sheets(StarBox2Test):
    """A plate: one box holds a part of its top and a part of its bottom."""
    HALF = Q(1, 4)

    @classmethod
    def setUpClass(cls):
        cls.sound = proved(slab(cls.HALF), roots=2)
        cls.number = cls.sound.replace_leaves(two_sheets(cls.HALF))

    def setUp(self):
        self.plan = self.sound

    def rejected(self, expected, words="", **changes):
        self.lie(expected, self.plan, lambda plan: [setattr(plan.boxes[self.number], *c) for c in changes.items()], words)

    def accepted(self, **changes):
        plan = copy.copy(self.plan)
        plan.boxes = copy.deepcopy(plan.boxes)
        for name, value in changes.items():
            setattr(plan.boxes[self.number], name, value)
        self.says("ACCEPT", plan)
        return plan

    def test_two_sheets_in_frames(self):
        self.says("ACCEPT", self.plan)
        for matrix in (MIRRORED, ((1, 0, 0), (0, 1, 0), (-1, 1, 8)), TURNED):
            plan = copy.copy(self.plan)
            plan.boxes, plan.frames = copy.deepcopy(plan.boxes), []
            self.says("ACCEPT", plan.into_frame(matrix, 1, lambda box: len(box.sheets) > 1))

    def test_some_separator_has_different_signs_for_two_sheets(self):
        for signs in ([[1], [1]], [[1], [0]], [[0], [0]], [[-1], [-1]]):
            self.rejected("B1", "separator", signs=signs)

    def test_numbers_of_sheets_and_separators(self):
        box = self.plan.boxes[self.number]
        self.rejected("B1", "no sheet", sheets=[], signs=[], separators=[])
        self.rejected("B1", "has separators", sheets=box.sheets[:1], signs=[[1]])
        self.rejected("B1", "separator", separators=[], signs=[[], []])
        self.rejected("B1", "too many sheets", sheets=[box.sheets[0]] * 65, signs=[[1]] * 65)
        self.accepted(separators=box.separators * 64, signs=[[1] * 64, [-1] * 64])
        self.rejected("B1", "too many separators", separators=box.separators * 65, signs=[[1] * 65, [-1] * 65])
        for degree in (0, 4):
            self.rejected("B1", "degree", separators=[[degree, 0, [0, 1, 0, 0]]])
        for t in (-65, 65, -4096, 4096, 1 << 62):
            self.rejected("B1", "t is", separators=[[1, t, [0, 1, 0, 0]]])

    def test_signs_of_the_separator(self):
        self.rejected("C2", signs=[[-1], [1]])
        self.accepted(separators=[[1, 20, [0, -1, 0, 0]]], signs=[[-1], [1]])

    def test_a_sign_byte_is_at_most_2(self):
        box = copy.deepcopy(self.plan.boxes[self.number])
        body, encoded = self.plan.body(), box.encode()
        at = body.index(encoded) + len(encoded) - 1
        self.assertEqual(body[at], 2)
        code, condition, line = in_cpp(self.plan.model, self.plan.certificate(body[:at] + b"\3" + body[at + 1:]))
        self.assertEqual((code, condition), (1, "B1"), line)
        self.assertIn("sign of a sheet", line)

    def test_no_coefficient_of_the_separator_is_zero(self):
        """q = z - h is 0 on the top, z - h + 1 is not; the same below."""
        h = int(self.HALF * UNIT)
        self.accepted(separators=[[1, 0, [1 - h, 1, 0, 0]]])
        self.rejected("C2", separators=[[1, 0, [-h, 1, 0, 0]]])
        self.accepted(separators=[[1, 0, [h - 1, 1, 0, 0]]])
        self.rejected("C2", separators=[[1, 0, [h, 1, 0, 0]]])

    def test_quadrics_and_cubics(self):
        """In the order of the page; y is x in units of the model, whose plate has |z| = 1/4."""
        def q(d, **terms):
            order = [(a, b, c) for a in range(d + 1) for b in range(d + 1 - a) for c in range(d + 1 - a - b)]
            return [[d, 20, [terms.get("x" * a + "y" * b + "z" * c, 0) for a, b, c in order]]]
        for d in (2, 3):
            for axis in "xy":
                self.accepted(separators=q(d, **{"z": 8, axis * 2: 1}))
                self.rejected("C2", separators=q(d, **{"z": 1, axis * 2: 4}))
                self.rejected("C2", separators=q(d, **{axis: 1}))
            self.accepted(separators=q(d, z=8, xy=1))
            self.accepted(separators=q(d, z=8, xz=1, yz=-1, zz=1))
            self.rejected("C2", separators=q(d, zz=1))
        self.accepted(separators=q(3, zzz=1))
        self.accepted(separators=q(3, z=16, xxx=1, yyy=1, xxy=1, xyy=1, xyz=1, xxz=1, yyz=-1, xzz=1, yzz=1))
        self.rejected("C2", separators=q(3, xxz=1))
        self.rejected("C2", separators=q(3, xzz=1))

    def test_the_unit_of_the_separator(self):
        """z 2^-t + 1: the bottom is on the other side only if the unit is small; an odd polynomial without constant has no unit."""
        self.accepted(separators=[[1, 0, [1, 1, 0, 0]]])
        self.accepted(separators=[[1, -64, [1 << 62, 1, 0, 0]]])
        self.accepted(separators=[[1, 17, [1, 1, 0, 0]]])
        self.rejected("C2", separators=[[1, 18, [1, 1, 0, 0]]])
        self.rejected("C2", separators=[[1, 64, [1, 1 << 42, 0, 0]]])
        for t in (-64, 64):
            self.accepted(separators=[[1, t, [0, 1, 0, 0]]])
        # z^2 + z, z in units of 2^t: negative between -1 and 0 only
        self.accepted(separators=[[2, 19, [0, 1, 1] + [0] * 7]])
        self.rejected("C2", separators=[[2, 18, [0, 1, 1] + [0] * 7]])

    def test_the_unit_of_the_points(self):
        """Points count 2^(E + r), and so do the separators' units."""
        box = self.plan.boxes[self.number]
        sheets = [[tuple(v >> 4 for v in c) for c in sheet] for sheet in box.sheets]
        self.accepted(scale=4, sheets=sheets, separators=[[1, 13, [1, 1, 0, 0]]])
        self.rejected("C2", scale=4, sheets=sheets, separators=[[1, 14, [1, 1, 0, 0]]])
        self.rejected("B1", "centre", scale=8, sheets=sheets)

    def test_the_origin_of_the_separator_is_the_first_point(self):
        h = int(self.HALF * UNIT)
        sheets = copy.deepcopy(self.plan.boxes[self.number].sheets)
        sheets[0][0] = (0, 0, h // 2)
        self.accepted(sheets=sheets, separators=[[1, 0, [h // 2 - 1, 1, 0, 0]]])
        self.rejected("C2", sheets=sheets, separators=[[1, 0, [-h // 2, 1, 0, 0]]])

    def test_centres(self):
        box = self.plan.boxes[self.number]
        self.rejected("C2", sheets=[box.sheets[0][::-1], box.sheets[1]])
        self.rejected("C2", sheets=box.sheets[::-1])
        h = box.size[2] // 2
        self.rejected("B1", "centre", sheets=[box.sheets[0], [(0, 0, 0), (0, 0, -h)]])
        self.accepted(sheets=[box.sheets[0], [(0, 0, 0), (0, 0, 1 - h)]])

    def test_a_sheet_without_a_node(self):
        box = self.plan.boxes[self.number]
        separators = box.separators + [[1, 20, [4, 1, 0, 0]]]
        self.rejected("C3", sheets=box.sheets + [box.sheets[1]], separators=separators, signs=[[1, 0], [-1, 1], [-1, -1]])

    def test_a_walk_does_not_start_at_several_sheets(self):
        def start(plan):
            plan.walks[0] = (self.number, 1, [], 4)
        self.lie("W1", self.plan, start, "several sheets")


class Components(StarBox2Test):
    def test_leaves_of_two_components_name_a_box_with_two_sheets_only(self):
        """A cavity whose wall is between x = 3/4 and 1."""
        inner = [models.reversed_surface(e) for e in models.cube(Q(3, 4))]
        plan = proved(models.cube() + inner, roots=2)
        at, width = UNIT * 7 // 8, UNIT // 2
        sheets = [[(at, 0, 0), (at + UNIT // 4, 0, 0)], [(at, 0, 0), (at - UNIT // 4, 0, 0)]]
        box = Box(0, (at - UNIT // 3, -width, -width), (2 * UNIT // 3, 2 * width, 2 * width), sheets)
        box.separators, box.signs = [[1, 20, [0, 0, 0, 1]]], [[1], [-1]]
        number = plan.replace_leaves(box)
        self.says("ACCEPT", plan)

        def one_sheet(changed):
            changed.boxes[number] = Box(0, box.lo, box.size, sheets[:1])
        self.lie("C1", plan, one_sheet, "two components")


def covered(entities, plan, roots=None):
    """Another model of the same shape, whose nodes are cut until they lie in boxes of the plan. roots: those of each patch."""
    prover = forge.Prover(entities)
    for patch, cuts in zip(prover.patches, roots or ()):
        patch.roots[:] = cuts

    def tree(node):
        lo, hi = node.hull()
        for i, box in enumerate(plan.boxes):
            if all(a * l[1] <= l[0] and h[0] <= (a + s) * h[1] for a, s, l, h in zip(box.lo, box.size, lo, hi)):
                return i
        return [tree(kid) for kid in node.children()]
    prover.plan.trees = [[tree(node) for node in forge.star_nodes.root_nodes(patch)] for patch in prover.patches]
    prover.plan.values["bodies"] = 1
    other = Plan(prover)
    other.boxes, other.walks = copy.deepcopy(plan.boxes), list(plan.walks)
    return other


def faces_of_points(points):
    """Faces of the cube [-1, 1]^3; points[i][j]: coordinates u, v of a control point."""
    return [forge.surface([[at(*uv) for uv in row] for row in points]) for at in models.cube_faces()]


def bernstein(powers):
    """The cubic Bernstein coefficients, on [-1, 1]^2, of the polynomial {(i, j): coefficient of u^i v^j}."""
    def row(i):                                           # of t^i: the mean of products of i of the three numbers -1, ..., 1
        out = []
        for k in range(4):
            ends = [-1] * (3 - k) + [1] * k
            products = [math.prod(c) for c in itertools.combinations(ends, i)]
            out.append(Q(sum(products), len(products)))
        return out
    return [[sum(f * row(i)[a] * row(j)[b] for (i, j), f in powers.items()) for b in range(4)] for a in range(4)]


class WeakSigns(StarBox2Test):
    """S1 with zeros: the cube again, whose faces have other parameters."""

    def judged(self, points):
        return self.judged_faces(faces_of_points(points))

    def judged_faces(self, faces, roots=None):
        plan = covered(faces, proved(models.cube()), roots)
        plan.drop_boxes()
        return in_cpp(plan.model, plan.certificate())[1]

    def test_normals_that_are_zero_along_sides(self):
        """Repeated control points; version 1 has no certificate of it."""
        grid = (-1, -1, 1, 1)
        self.assertEqual(self.judged([[(u, v) for v in grid] for u in grid]), "ACCEPT")

    def test_no_normal_is_zero_along_a_line_inside(self):
        """The derivative of the cubic with the coefficients -1, 1, -1, 1 is 0 in the middle only."""
        grid = (-1, Q(-1, 3), Q(1, 3), 1)
        self.assertEqual(self.judged([[(u, v) for v in grid] for u in grid]), "ACCEPT")
        grid = (-1, 1, -1, 1)
        self.assertEqual(self.judged([[(u, v) for v in grid] for u in grid]), "C2")

    # PROVES STAR-5.FACES
    def test_no_normal_is_zero_along_an_inner_side_of_a_root(self):
        """Such a line at z = 0 between two roots of a face, whose corners lie on sides of the face."""
        for grid, expected in (((-1, Q(-1, 3), Q(1, 3), 1), "ACCEPT"), ((-1, 1, -1, 1), "C2")):
            plain, faces, roots = (-1, Q(-1, 3), Q(1, 3), 1), [], []
            for at in models.cube_faces():
                cut = [int(at(*end)[2] != at(-1, -1)[2]) for end in ((1, -1), (-1, 1))]    # whether z varies with u, with v
                faces.append(forge.surface([[at(u, v) for v in (grid if cut[1] else plain)] for u in (grid if cut[0] else plain)]))
                roots.append(cut)
            self.assertEqual(self.judged_faces(faces, roots), expected)

    def test_no_normal_is_zero_at_a_point_inside(self):
        """(u, v) (u^2 + v^2 - u^2 v^2): the identity on the sides, one to one, and the normal is zero in the middle alone."""
        x, y = bernstein({(3, 0): 1, (1, 2): 1, (3, 2): -1}), bernstein({(0, 3): 1, (2, 1): 1, (2, 3): -1})
        self.assertEqual(self.judged([[(x[i][j], y[i][j]) for j in range(4)] for i in range(4)]), "C2")

    def test_normals_that_are_zero_along_a_side_of_triangles(self):
        """Whichever side it is. The boxes are those of the octahedron of flat triangles; for the lie, one has c- = c+."""
        plain = proved(models2.octahedron())
        for turn in range(3):
            plan = covered(models2.folded_octahedron(turn), plain)
            plan.drop_boxes()
            self.lie("C2", plan, lambda changed: changed.boxes[0].sheets[0].__setitem__(0, changed.boxes[0].sheets[0][1]))

    def test_no_coefficient_is_negative(self):
        """c- is moved outside, nearly to c+: on a whole face of the ball the coefficients then have both signs."""
        plan = proved(models.bicubic_ball())

        def outside(changed):
            sheet = changed.boxes[0].sheets[0]
            sheet[0] = tuple(c + (a > c) - (a < c) for a, c in zip(*sheet))
        self.lie("C2", plan, outside)

    def test_some_coefficient_is_positive(self):
        """c- in the plane of the face z = 1, whose sides lie far away: all coefficients are zero."""
        plan = proved(models.cube(), roots=0)
        height, wide = UNIT // 8, UNIT * 5 // 8
        box = Box(0, (-wide, -wide, UNIT - 2 * height), (2 * wide, 2 * wide, 4 * height), [[(0, 0, UNIT - 1), (0, 0, UNIT + height)]])
        plan.trees = [[self.cut(tree, 2) for tree in trees] for trees in plan.trees]
        number = plan.replace_leaves(box)
        self.lie("C2", plan, lambda changed: changed.boxes[number].sheets[0].__setitem__(0, (0, 0, UNIT)))

    def cut(self, tree, level):
        """A tree in which leaves above this level are split."""
        if isinstance(tree, int):
            return tree if level == 0 else [self.cut(tree, level - 1) for _ in range(4)]
        return [self.cut(kid, max(level - 1, 0)) for kid in tree]

    def test_no_side_lies_on_a_line_through_a_centre(self):
        """The edge from (1, 0, 0) to (0, 1, 0) of a bulged octahedron is straight; c- lies on it, or a little below it."""
        entities = models.cubic_octahedron()
        for entity in entities:
            for point in entity["shape"]["points"]:
                x, y, z = map(Q, point)
                if z == 0 and x > 0 and y > 0:
                    point[:2] = [str(x / (x + y)), str(y / (x + y))]
        plan = proved(entities)
        plan.trees = [[self.cut(tree, 4) for tree in trees] for trees in plan.trees]
        half = UNIT // 2
        box = Box(0, (half - UNIT // 8, half - UNIT // 8, -UNIT // 8), (UNIT // 4,) * 3,
                  [[(half - 9, half - 9, 0), (half + UNIT // 10, half + UNIT // 10, 0)]])
        number = plan.replace_leaves(box)
        self.lie("C2", plan, lambda changed: changed.boxes[number].sheets[0].__setitem__(0, (half, half, 0)))


class QuadProver(forge.Prover):
    """Mesh boxes where splitting does not help, whatever the shape of the patch."""

    def tree(self, node):
        box = self.star_box(node)
        if box is None and node.level < 2:
            return [self.tree(kid) for kid in node.children()]
        if box is None:
            box = forge.Box(1, *self.grown(node, 1.05))
        else:
            self.components[node.patch.component].append(len(self.plan.boxes))
        self.plan.boxes.append(box)
        return len(self.plan.boxes) - 1


def quads(cells=((0, 0, 0), (-1, 0, 0), (-1, -1, 0), (-1, -1, -1))):
    out = []
    for cell in cells:
        for at in models.cube_faces():
            beyond = tuple(c + int(n) for c, n in zip(cell, [sum(p[k] for p in (at(-1, -1), at(1, 1))) // 2 for k in range(3)]))
            if beyond not in cells:
                out.append(forge.surface([[tuple(m + Q(x + 1, 2) for m, x in zip(cell, at(u, v))) for v in (-1, 1)] for u in (-1, 1)]))
    return out


def mesh_boxes(plan):
    """Mesh boxes in place of all star boxes at which no walk starts."""
    stars = {walk[0] for walk in plan.walks}
    for i, box in enumerate(plan.boxes):
        box.kind = 0 if i in stars else 1
    return plan


class Work(StarBox2Test):
    def test_separators_cost_by_their_degree(self):
        """A plate of patches of degree 9, whose box with both walls has 63 times the same separator: of degree 1, and, with the same
        values, of degree 3, of which each costs thousands of units on a node."""
        entities, _, boxes = models2.plate(Q(1, 64))
        raised, walls = [models2.raised(e, 9, Q(1, 1 << 20)) for e in entities], boxes[1]
        prover = models2.forge2.Prover2(raised, boxes, roots=2, deepest=0).prove()
        (_, t, c), linear = walls.separators[0], models2.forge2.powers(1)
        for degree, expected in ((1, "ACCEPT"), (3, "C2")):
            values = [c[linear.index(abc)] if abc in linear else 0 for abc in models2.forge2.powers(degree)]
            for box in prover.plan.boxes:
                if len(box.centres) == 2:
                    box.separators = [[degree, t, values]] * 63
                    box.signs = [[sign] * 63 for sign in (1, 2)]
            code, condition, line = in_cpp(prover.model, prover.plan.certificate(prover.model))
            self.assertEqual((code, condition), (0, "ACCEPT") if expected == "ACCEPT" else (1, expected), line)
            self.assertIn("" if expected == "ACCEPT" else "more work than allowed", line)


class FlatPatches(StarBox2Test):
    def test_blocks_of_quadrilaterals(self):
        plan = proved(quads(), QuadProver)
        self.assertTrue(any(box.kind for box in plan.boxes))
        self.says("ACCEPT", plan)
        for matrix in (TURNED, SHEARED):
            self.says("ACCEPT", copy.deepcopy(plan).into_frame(matrix, 1, lambda box: box.kind == 1))

    def flat(self, expected, shape=lambda p: p, entities=None, **options):
        """A bicubic cube, whose points may be moved, with mesh boxes; in version 1 a prover finds star boxes for it."""
        plan = mesh_boxes(proved(entities or models.cube(degree=3, shape=shape), **options))
        self.says(expected, plan)
        return plan

    def test_patches_of_higher_degree(self):
        self.flat("ACCEPT")
        self.flat("ACCEPT", roots=1)                      # a patch with several roots is two triangles

    def test_triangles_of_higher_degree(self):
        corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
        faces = []
        for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)):
            a, b, c = (corners[i] for i in face)
            mid = [tuple(Q(x + y, 2) for x, y in zip(p, q)) for p, q in ((a, b), (a, c), (b, c))]
            faces.append([a, mid[0], mid[1], b, mid[2], c])
        self.flat("ACCEPT", entities=[forge.triangle(f, 2) for f in faces], kind=QuadProver)

    def moved(self, expected, point, to):
        """A control point in a face z = 1, not of its sides, is moved."""
        self.flat(expected, lambda p: to if p == point else p)

    def test_all_points_lie_in_the_plane(self):
        at = (Q(1, 3), Q(1, 3), 1)
        self.moved("ACCEPT", at, (Q(1, 3), Q(1, 2), 1))
        self.moved("C4", at, (Q(1, 3), Q(1, 3), Q(9, 8)))

    def test_the_normal_does_not_turn_over(self):
        """The four inner points of every face are drawn together, or exchanged beyond the middle: only then the patch is folded."""
        plan = mesh_boxes(proved(models.cube()))
        grid = (-1, Q(-1, 3), Q(1, 3), 1)
        for factor, expected in ((1, "ACCEPT"), (Q(1, 2), "ACCEPT"), (-3, "C4")):
            inner = factor * Q(1, 3)
            points = [[(u, v) if abs(u) == 1 or abs(v) == 1 else (inner if u > 0 else -inner, inner if v > 0 else -inner) for v in grid]
                      for u in grid]
            other = covered(faces_of_points(points), plan)
            other.drop_boxes()
            self.says(expected, other)

    def test_the_points_of_a_side_lie_on_a_line(self):
        """The side between the faces z = 1 and x = 1 bulges in the plane of the first; mesh boxes lie in the middle of that one only."""
        for x, expected in ((1, "ACCEPT"), (Q(9, 8), "C4")):
            plan = proved(models.cube(degree=3, shape=lambda p, x=x: (x, p[1], 1) if p[::2] == (1, 1) and abs(p[1]) < 1 else p), roots=2)
            middle = [box for i, box in enumerate(plan.boxes) if i != plan.walks[0][0] and box.lo[2] + box.size[2] > UNIT
                      and all(-UNIT < box.lo[k] and box.lo[k] + box.size[k] < UNIT for k in (0, 1))]
            self.assertTrue(middle)
            for box in middle:
                box.kind = 1
            self.says(expected, plan)

    def test_a_rational_patch_is_not_flat(self):
        faces = models.cube(degree=3)
        for face in faces:
            face["shape"].update(rational=True, components=4, points=[p + ["1"] for p in face["shape"]["points"]])
        self.flat("C4", entities=faces)

    def test_corners_are_strictly_convex(self):
        """The edge of a cube from (1, 1, -1) to (1, 1, 1) is drawn into the middle, where z = 1 becomes a triangle, and beyond."""
        for to, expected in ((Q(1, 2), "ACCEPT"), (0, "C4"), (Q(-1, 4), "C4")):
            faces = models.cube(shape=lambda p, to=to: (to, to, p[2]) if p[:2] == (1, 1) else p)
            below = next(face["shape"] for face in faces if all(p[2] == "-1" for p in face["shape"]["points"]))
            below["points"] = [below["points"][i] for i in (1, 3, 0, 2)]    # turned: its diagonal c0 c2 ends there, too
            self.says(expected, mesh_boxes(proved(faces, QuadProver)))

    def test_two_walls_that_overlap(self):
        for x, expected in ((Q(33, 16), "ACCEPT"), (2, "C4")):
            plan = mesh_boxes(proved(models.cube() + models.cube(middle=(x, Q(1, 2), 0)), QuadProver))
            self.says(expected, plan)
            self.says(expected, plan.into_frame(TURNED, 1, lambda box: box.kind == 1))


if __name__ == "__main__":
    unittest.main()
