# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim points-1 about chain files, written from docs/certificates/points.md, section 7, alone."""
from fractions import Fraction

from ..common.errors import Reject
from ..mesh import mesh_reader
from ..mesh.mesh_model import TOO_MUCH_WORK, integers_of
from ..patches.model_subject import read_subject
from ..patches.star_box_read import Body
from . import patch_points_check as curved
from . import points_check as flat
from .answers import lines_of
from .box_tree import BoxTree, boxes_of_triangles
from .chain_file import Expression, Box, evaluate
from .cone import Fault, values_nearby, wedges_of
from .patch_cone import cone_at
from .patch_winding import TooMuchWork, Work

MOST_TABLE = 12                                             # variables whose functions are tabulated
MOST_WEDGE_UNITS, FREE_WEDGE_UNITS, WEDGE_UNITS_EACH = 1 << 22, 1 << 23, 1 << 12
ON, OPEN, NOT_COVERED = 12, 13, 14                          # codes
MIXED = 2                                                   # the third value, beside 0 and 1

def check(claim, statement, data, model, skip, answers, files):
    return Check(claim, statement, data, model, skip, *files).run(answers)

class Check:
    def __init__(self, claim, statement, data, model, skip, name, read):
        self.skip, self.statement = skip, statement
        expression = Expression(model, name, read, skip)
        self.root, self.leaves, self.body = expression.root, expression.leaves, Body(data)
        self.not_covered = self.read_head(claim, expression)
        self.budget = Budget()
        makers = {True: MeshPart, False: PatchPart}
        self.parts = {solid: makers[solid.is_mesh](solid, self) for solid in expression.solids}
        for box, inner, operand in expression.inside:
            inner = inner if isinstance(inner, Box) else self.parts[inner]
            if any(a >= b or c >= d for a, b, c, d in zip(box.lo, inner.lo, inner.hi, box.hi)):
                self.fail("O2", "not in the interior of the box: the operand %s" % operand)
        questions, faces = statement["points"] + len(data), sum(part.faces for part in self.parts.values())
        self.budget.triangles = 10 * faces + 1000 * questions
        self.budget.wedges = FREE_WEDGE_UNITS + WEDGE_UNITS_EACH * statement["points"]
        size = sum(len(solid.data) for solid in expression.solids)
        self.budget.patches = Work(questions, len(model) + len(data) + size)

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def read_head(self, claim, expression):
        if self.body.bytes(4) != claim.magic:
            raise Reject("B1", "another magic")
        for value, size in ((len(expression.solids), 4), (expression.leaves, 4), (self.statement["points"], 8)):
            if int.from_bytes(self.body.bytes(size), "little") != value:
                raise Reject("B1", "another number of solids, operands or points: not %d" % value)
        return int.from_bytes(self.body.bytes(8), "little")

    def run(self, answers):
        found = 0
        for number, (point, word, f) in enumerate(lines_of(answers, self.statement), 1):
            if word != "undecided":
                found += not self.is_covered(At(point, "line %d: " % number), word, f)
                if found > self.not_covered:
                    raise Reject("B1", "more points than stated are not covered")
        if found != self.not_covered:
            raise Reject("B1", "fewer points than stated are not covered: %d" % found)
        self.body.end()
        return "%d points, %d not covered" % (self.statement["points"], found)

    def is_covered(self, at, word, f):
        """Whether the line is proved; it is not if its code says so."""
        values, on = {}, {}                                 # of variables; walls(): of those that the point is on

        def value_of(variable):
            if variable not in values:
                values[variable] = self.value(variable, at, on)
            return values[variable]

        try:
            value = evaluate(self.root, value_of, lambda v, bit: v == int(bit), joined3)
            answer = value if value != MIXED else self.on_walls(at, values, on)
        except NotCovered:
            return False
        except TooMuchWork:
            raise Reject("B1", "%smore work than allowed" % at.where)
        if answer != (f if word == "off" else MIXED):
            self.fail("P5", "%sanother word follows" % at.where)
        return True

    def value(self, variable, at, on):
        """0, 1 or MIXED; reads the code of a solid."""
        is_box = isinstance(variable, Box)
        part = variable if is_box else self.parts[variable]
        if not all(a <= x <= b for a, x, b in zip(part.lo, at.point, part.hi)):
            return 0
        if is_box and all(a < x < b for a, x, b in zip(part.lo, at.point, part.hi)):
            return 1
        if is_box:
            on[variable] = lambda: box_cone(variable, at.point)
            return MIXED
        code = self.body.u8(NOT_COVERED)
        if code == NOT_COVERED:
            raise NotCovered
        if code == ON:
            on[variable] = part.read_on(at, self)
        elif code < ON:
            part.check_off(at, code % 6, code // 6, self)
            return code // 6
        return MIXED

    def on_walls(self, at, values, on):
        """0, 1, or MIXED of a point on the boundary; None if P5 fails, but is skipped."""
        met = [variable for variable, value in values.items() if value == MIXED]

        def g(bits):
            known = dict(zip(met, bits))
            return evaluate(self.root, lambda v: known[v] if v in known else values.get(v, 0),
                            lambda v, bit: v == int(bit), joined3)

        relevant, f = met, lambda bits: g([int(bit) for bit in bits])
        if len(met) <= MOST_TABLE:
            table = self.table(met, values)
            relevant = [v for k, v in enumerate(met) if depends(table, k, len(met))]
            if not relevant:
                return table & 1
            places = [met.index(v) for v in relevant]
            f = lambda bits: table >> sum(bit << k for bit, k in zip(bits, places)) & 1     # noqa: E731
        if any(v not in on for v in relevant):
            return self.fail("P5", "%sthe word depends on a solid that is open" % at.where)
        if len(relevant) == 1:
            return MIXED
        cones = []
        for v in relevant:
            cones.append(on[v]())
            if cones[-1] is None:
                return self.fail("P5", "%sa wall is not flat there" % at.where)
        self.spend_wedges(sum(map(len, cones)), 1 if len(met) <= MOST_TABLE else 1 + self.leaves // 64, at)
        try:
            found = values_nearby(cones, f)
        except Fault as e:
            return self.fail("P5", at.where + str(e))
        return MIXED if len(found) == 2 else int(found.pop())

    def table(self, met, values):
        """Bit i is the value of the expression for the bits of i as those of `met`."""
        size = 1 << len(met)
        ones = (1 << size) - 1
        columns = {v: sum(1 << i for i in range(size) if i >> k & 1) for k, v in enumerate(met)}
        return evaluate(self.root, lambda v: columns[v] if v in columns else ones * values.get(v, 0),
                        lambda v, bit: v == (ones if bit else 0),
                        lambda op, a, b: a | b if op == "|" else a & b if op == "&" else a & ~b)

    def spend_wedges(self, n, evaluations, at):
        units = (n * n + n ** 3 // 32) * evaluations
        self.budget.wedges -= units
        if (units > MOST_WEDGE_UNITS or self.budget.wedges < 0) and "B1" not in self.skip:
            raise Reject("B1", "%smore work than allowed: %d wedges" % (at.where, n))

class NotCovered(Exception):
    """The point has the code that says so."""

class Budget:
    """Units of work that may still be spent."""
    triangles = wedges = patches = None

class At:
    """A point.  ratios: pairs of integers."""

    def __init__(self, ratios, where):
        self.ratios, self.where, self.point = ratios, where, [Fraction(n, d) for n, d in ratios]

def joined3(op, a, b):
    """The result for the values 0, 1 and MIXED."""
    if op == "|":
        return 1 if 1 in (a, b) else MIXED if MIXED in (a, b) else 0
    if op == "-" and b != MIXED:
        b = 1 - b
    return 0 if 0 in (a, b) else MIXED if MIXED in (a, b) else 1

def depends(table, k, n):
    """Whether a function of n bits depends on bit k."""
    without = sum(1 << i for i in range(1 << n) if not i >> k & 1)
    return (table ^ table >> (1 << k)) & without != 0

def box_cone(box, point):
    """Signs stand for the sides minus the point: the directions are the same."""
    lo, hi = ([(a > x) - (a < x) for a, x in zip(side, point)] for side in (box.lo, box.hi))
    cone = []
    for k in range(3):
        p, q = (k + 1) % 3, (k + 2) % 3
        square = [(lo[p], lo[q]), (hi[p], lo[q]), (hi[p], hi[q]), (lo[p], hi[q])]      # counterclockwise around +k
        for side, turned in ((lo, True), (hi, False)):
            if side[k] == 0:
                corners = [[s if i == p else t if i == q else 0 for i in range(3)] for s, t in square]
                cone += wedges_of(corners[::-1] if turned else corners)
    return cone

class MeshPart:
    """A mesh in an expression.  lo, hi: its box."""

    def __init__(self, solid, check):
        form, as_indexed = solid.form, check.statement["as_indexed"]
        floats, self.triangles = mesh_reader.read_model(solid.data, form, as_indexed)
        for value in (len(self.triangles), len(floats)):
            if int.from_bytes(check.body.bytes(4), "little") != value:
                raise Reject("B1", "another number of triangles or vertices than %d" % value)
        self.faces = len(self.triangles)
        wrong = flat.p1_not_closed(self.triangles)
        if wrong:
            check.fail(*wrong)
        self.points, self.unit = integers_of(floats)
        self.tree = BoxTree(list(boxes_of_triangles(self.points, self.triangles)))
        box = self.tree.nodes[0][0]
        self.lo, self.hi = ([side * self.unit for side in box[end::2]] for end in (0, 1))

    def point(self, at):
        return flat.Point(at.ratios, self.unit, self.points, self.triangles)

    def spend(self, units, check):
        check.budget.triangles -= units
        if check.budget.triangles < 0 and "B1" not in check.skip:
            raise Reject("B1", TOO_MUCH_WORK)

    def read_on(self, at, check):
        """Returns the function that finds the walls."""
        f, q = check.body.varint(), self.point(at)
        if f >= self.faces:
            raise Reject("B1", "triangle %d does not exist" % f)
        self.spend(1, check)
        wrong = flat.p2_not_on(q, f)
        if wrong:
            check.fail(wrong[0], at.where + wrong[1])
        return lambda: self.walls(q, check)

    def walls(self, q, check):
        touched = self.tree.near(q.floors, q.ceilings, 0)[0]
        self.spend(len(touched), check)
        return [wedge for f in sorted(touched) if q.is_on(f) for wedge in wedges_of(q.corners(f))]

    def check_off(self, at, direction, f, check):
        q = self.point(at)
        touched, crossed, both = self.tree.near(q.floors, q.ceilings, direction)
        self.spend(both, check)
        for wrong in (flat.p3_on(q, touched), flat.p4_winding(q, f, crossed, direction)):
            if wrong:
                check.fail(wrong[0], at.where + wrong[1])

class PatchPart:
    """A spline model in an expression.  lo, hi: the box of its control points."""
    faces = 0

    def __init__(self, solid, check):
        by_faces, body = check.body.u8(1), check.body
        entities = read_subject(solid.data, solid.form + ("-faces" if by_faces else ""))
        self.num_patches = curved.read_counts(body, entities)
        breaks = curved.read_cuts(body, entities, self.num_patches, len(solid.data))
        self.model = curved.Model(entities, breaks, check.fail)
        points = [[Fraction(x, w) for x in point] for patch in self.model.patches
                  for rows in zip(*patch.net) for *point, w in zip(*rows)]
        self.lo, self.hi = ([choose(axis) for axis in zip(*points)] for choose in (min, max))

    def read_on(self, at, check):
        patch, place = curved.read_place(check.body, self.num_patches)
        check.budget.patches.begin_point()
        wrong = curved.p2_not_on(self.model, check.budget.patches, at.ratios, patch, place)
        if wrong:
            check.fail(wrong[0], at.where + wrong[1])
        return lambda: self.walls(at, patch, place, check)

    def walls(self, at, patch, place, check):
        check.budget.patches.begin_point()
        return cone_at(self.model, curved.Point(at.ratios), patch, place, check.budget.patches)

    def check_off(self, at, direction, f, check):
        check.budget.patches.begin_point()
        wrong = curved.p3_p4(self.model, check.budget.patches, at.ratios, f, direction)
        if wrong:
            check.fail(wrong[0], at.where + wrong[1])
