# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A forge of star-box certificates of version 2: tests only. Boxes are given by hand, from certificates of version 1 or by the search of
star_box_forge.py; each is judged by the checker's own test of one box. Plan2 can write every lie."""
import copy
import math
from fractions import Fraction as Q

import star_box_forge as forge

from veritope_checker.common.errors import Reject
from veritope_checker.patches import star_box_2_check as check, star_box_2_read as read2

read, star_nodes, varint, zigzag = forge.read, forge.star_nodes, forge.varint, forge.zigzag


# ---------------------------------------------------------------- boxes

def twos(numbers):
    """The greatest s so that 2^s divides all numbers."""
    common = math.gcd(*numbers)
    return (common & -common).bit_length() - 1 if common else 0


def powers(degree):
    return [(a, b, c) for a in range(degree + 1) for b in range(degree + 1 - a) for c in range(degree + 1 - a - b)]


class Box2:
    """frame: a number of the plan's table. centres: (c-, c+) of each sheet, in units of 2^E. separators: (degree, t, coefficients).
    signs: of each sheet for each separator, 0 none, 1 plus, 2 minus."""

    def __init__(self, kind, lo, hi, centres=(), separators=(), signs=None, frame=0):
        self.kind, self.frame, self.lo, self.hi = kind, frame, list(lo), list(hi)
        self.centres = [[list(c) for c in pair] for pair in centres]
        self.separators, self.signs = [list(s) for s in separators], [list(s) for s in signs or [[]] * len(centres)]
        self.shift = self.points_shift = None             # the greatest ones
        self.owner = None                                 # a component: leaves of others do not name the box

    def encode(self):
        size = [h - l for l, h in zip(self.lo, self.hi)]
        s = twos([*self.lo, *size]) if self.shift is None else self.shift
        out = [bytes([self.kind]), varint(self.frame), varint(s), *[zigzag(x >> s) for x in self.lo], *[varint(x >> s) for x in size]]
        if self.kind == 0:
            out += [bytes([len(self.centres), len(self.separators)]), varint(self.exponent())]
            points = [c for pair in self.centres for c in pair]
            for i, p in enumerate(points):
                out += [zigzag(x - o >> self.exponent()) for x, o in zip(p, points[0] if i else (0, 0, 0))]
            for degree, t, coefficients in self.separators:
                out += [bytes([degree]), zigzag(t), *map(zigzag, coefficients)]
            out += [bytes(s) for s in self.signs]
        return b"".join(out)

    def exponent(self):
        """r of the page."""
        return twos([x for pair in self.centres for c in pair for x in c]) if self.points_shift is None else self.points_shift

    def separate(self, polynomial, exponent, *signs):
        """Adds the polynomial in x, {(a, b, c): coefficient}, of degree 1 to 3, as one in (x - o) / 2^exponent."""
        degree, o = max(map(sum, polynomial)), self.centres[0][0] if self.centres else (0, 0, 0)
        terms = dict.fromkeys(powers(degree), Q(0))
        for abc, value in polynomial.items():
            for ijk in powers(degree):
                if all(i <= a for i, a in zip(ijk, abc)):
                    factor = math.prod(math.comb(a, i) * x ** (a - i) for a, i, x in zip(abc, ijk, o))
                    terms[ijk] += Q(value) * factor * Q(2) ** (exponent * sum(ijk))
        denominator = math.lcm(*[Q(c).denominator for c in terms.values()])
        numbers = [int(c * denominator) for c in terms.values()]
        common = math.gcd(*numbers)
        self.separators.append([degree, exponent - self.exponent(), [n // common for n in numbers]])
        for of_sheet, sign in zip(self.signs, signs):
            of_sheet.append(sign)
        return self


def from_version_1(box):
    probe = forge.check_box(box)
    return Box2(box.kind, probe.lo, probe.hi, [probe.c] if probe.c else [])


# ---------------------------------------------------------------- bodies

class Plan2(forge.Plan):
    claim, magic = "star-box-2", b"VTS2"

    def __init__(self, entities, unit=-20):
        super().__init__(entities, unit)
        self.frames, self.kinds = [], [{"surface": 1, "triangle": 2}.get(e["kind"], 0) for e in entities]

    def marks(self):
        return bytes(x for pair in zip(self.kinds, self.flags) for x in pair)

    def table(self):
        return forge.u32(len(self.frames)) + b"".join(zigzag(a) for rows in self.frames for row in rows for a in row)


def to_version_2(plan):
    """The plan of a certificate of version 1 as one of version 2."""
    result = Plan2(plan.entities, plan.unit)
    for name in ("flags", "breaks", "roots", "trees", "walks", "values"):
        setattr(result, name, copy.deepcopy(getattr(plan, name)))
    result.boxes = [from_version_1(box) for box in plan.boxes]
    return result


def read_plan(model, certificate):
    """The plan that a certificate of version 1 or 2 has, as one of version 2."""
    statement, body = certificate.split(b"\n", 1)
    statement, entities = forge.json.loads(statement), forge.json.loads(model)["entities"]
    is_new = body[:4] == b"VTS2"
    cert = (read2.Certificate2 if is_new else read.Certificate)(body[:4], body, read.read_model(model))
    plan = Plan2(entities, cert.unit)
    plan.flags, plan.roots = cert.flags, cert.roots
    plan.breaks = [breaks or [] for breaks in cert.breaks]
    frames = {}
    for box in cert.boxes:
        sheets = box.sheets if is_new else [read2.Sheet(box.c, [])] if box.c else []
        frame = frames.setdefault(box.frame, len(frames) + 1) if box.frame else 0
        separators = [(s.degree, 0, [n for n, _ in s.terms]) for s in getattr(box, "separators", [])]
        copied = Box2(box.kind, box.lo, box.hi, [s.c for s in sheets], separators, [[s % 3 for s in sheet.signs] for sheet in sheets], frame)
        for separator, s in zip(copied.separators, getattr(box, "separators", [])):
            separator[1] = s.exponent - copied.exponent()
        plan.boxes.append(copied)
    plan.frames = list(frames)

    def nested(symbols):
        box = next(symbols)
        return [nested(symbols) for _ in range(4)] if box is None else box

    plan.trees = [[nested(iter(tree)) for tree in trees] for trees in cert.trees]
    plan.walks = [(*start, points, direction if end is None else end) for start, points, end, direction in cert.walks]
    plan.values = {key: statement[key] for key in ("patches", "edges", "vertices", "shells", "bodies", "genus")}
    return plan


# ---------------------------------------------------------------- proofs

class Prover2(forge.Prover):
    """Every node is given to the first of the boxes that contains it and holds, else to a star box that is found as in version 1, else
    it is split."""
    plan_kind = Plan2

    def __init__(self, entities, boxes=(), frames=(), search=False, **options):
        super().__init__(entities, **options)
        self.plan.frames, self.given, self.search = list(frames), [[box, None] for box in boxes], search

    def checker(self):
        result = check.Checker2.__new__(check.Checker2)
        result.skip, result.forest, result.patches = frozenset(), self.forest, self.patches
        result.vertex_of, result.flat = self.vertex_of, {}
        return result

    def probe(self, box):
        """The box as the checker reads it."""
        return read2.Box(read.Body(box.encode()), [tuple(map(tuple, rows)) for rows in self.plan.frames])

    def reason(self, box, work=10 ** 8):
        """Why the box does not hold; "" if it does."""
        before, self.forest.work = self.forest.work, work
        try:
            probe, checker = self.probe(box), self.checker()
            (checker.check_mesh_box if box.kind else checker.check_star_box)(0, probe)
            return ""
        except Reject as e:
            return e.condition + ": " + e.why
        finally:
            self.forest.work = before

    def holds(self, box):
        return not self.reason(box if isinstance(box, Box2) else from_version_1(box), 10 ** 5)

    def star_box(self, node):
        box = super().star_box(node) if self.search else None
        return box and from_version_1(box)

    def tree(self, node):
        for entry in self.given:
            box = self.probe(entry[0])
            if entry[0].owner not in (None, node.patch.component):
                continue
            lo, hi = node.hull(box.frame)
            if all(n >= x * d for (n, d), x in zip(lo, box.lo)) and all(n <= x * d for (n, d), x in zip(hi, box.hi)):
                if entry[1] is None:
                    entry[1] = -1 if self.reason(entry[0]) else self.new_box(entry[0], node)
                if entry[1] >= 0:
                    return entry[1]
        box = self.star_box(node)
        if box:
            return self.new_box(box, node)
        if node.level == self.deepest:
            raise ValueError("no box at %r of patch %d: %s" % (node.at, node.patch.index, [self.reason(box) for box, _ in self.given]))
        return [self.tree(kid) for kid in node.children()]

    def new_box(self, box, node):
        self.plan.boxes.append(box)
        number = len(self.plan.boxes) - 1
        if len(box.centres) == 1:
            self.components[node.patch.component].append(number)
        return number
