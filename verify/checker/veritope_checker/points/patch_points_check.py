# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim points-1 about spline models, written from docs/certificates/points.md, section 6, alone (and the pages
that it quotes).  All numbers are integers or fractions."""
from fractions import Fraction
from math import gcd

from ..common.errors import Reject
from ..patches.model_subject import read_subject
from ..patches.patch_invalid_check import tensor_net, value_at
from ..patches.star_box_check import MAX_DEGREE
from ..patches.star_box_patches import glue, longest, patches_of
from ..patches.star_box_read import Body, read_all_breaks
from .answers import lines_of
from .algebraic import Algebraic
from .box_tree import BoxTree
from .patch_winding import LeftOver, TooMuchWork, Work, winding

BYTES_OF_PATCH = 3                      # of the model and the body
BOX_BITS = 60                           # of the greatest coordinate of a box
RATIONAL, ALGEBRAIC = 0, 1              # the kind of an `on` point's code

def check(claim, statement, data, model, skip, answers, words):
    def fail(condition, why):
        if condition not in skip:
            raise Reject(condition, why)

    entities, body = read_subject(model, statement["subject_format"]), Body(data)
    breaks, codes = read_body(claim, statement, body, entities, words)
    model = Model(entities, breaks, fail)
    work = Work(statement["points"], statement["subject_bytes"] + len(data))
    for number, ((ratios, word, f), code) in enumerate(zip(lines_of(answers, statement), codes), 1):
        if word == "undecided":
            continue
        work.begin_point()
        try:
            wrong = p2_not_on(model, work, ratios, *code) if word == "on" else p3_p4(model, work, ratios, f, code)
        except TooMuchWork:
            wrong = "B1", "more work than allowed"
        if wrong:
            fail(wrong[0], "line %d: %s" % (number, wrong[1]))


# ---------------------------------------------------------------- B1: the body

def read_body(claim, statement, body, entities, words):
    """(breaks of each entity, code of each line or None)"""
    if body.bytes(4) != claim.magic:
        raise Reject("B1", "another magic")
    num_patches = read_counts(body, entities)
    if int.from_bytes(body.bytes(8), "little") != statement["points"]:
        raise Reject("B1", "the number of points differs from the statement's")
    breaks = read_cuts(body, entities, num_patches, statement["subject_bytes"])
    codes = [read_code(body, num_patches, word) for word in words]
    body.end()
    return breaks, codes

def read_counts(body, entities):
    """The stated number of patches."""
    num_patches, num_entities = (int.from_bytes(body.bytes(4), "little") for _ in range(2))
    if num_entities != len(entities) or not entities:
        raise Reject("B1", "another number of entities, or none")
    return num_patches

def read_cuts(body, entities, num_patches, model_bytes):
    """The breaks of the entities."""
    breaks = read_all_breaks(body, entities)
    cells = sum(1 if e.kind == "triangle" else (len(b[0]) - 1) * (len(b[1]) - 1) for e, b in zip(entities, breaks) if e)
    if cells != num_patches or BYTES_OF_PATCH * cells > model_bytes + len(body.data):
        raise Reject("B1", "%d patches, which is another number than stated, or too many for the bytes" % cells)
    return breaks

def read_code(body, num_patches, word):
    """A direction, (patch, two rationals or Algebraic), or None if there is no code."""
    if word == "undecided":
        return None
    if word == "off":
        return body.u8(5)
    return read_place(body, num_patches)

def read_place(body, num_patches):
    patch = body.varint()
    if patch >= num_patches:
        raise Reject("B1", "patch %d does not exist" % patch)
    if body.u8(ALGEBRAIC) == RATIONAL:
        return patch, (body.rational(), body.rational())
    return patch, Algebraic(body)


# ---------------------------------------------------------------- patches and points

class Grid:
    """A patch as a tensor patch.  rows[i][j]: the coefficient (X, Y, Z, W) of u^i v^j, integers without a common
    factor.  borders[s]: (edge, whether it is the first of the edge's two sides) of side s, None if it is collapsed.
    triangle: its arrays if the patch is one."""

    def __init__(self, patch):
        net = tensor_net(patch)
        common = gcd(*[c for a in net for row in a for c in row])
        net = [[[c // common for c in row] for row in a] for a in net]
        self.bits, self.degrees, self.is_tensor = longest(net), (len(net[0]) - 1, len(net[0][0]) - 1), patch.is_tensor
        self.rows = [list(zip(*rows)) for rows in zip(*net)]
        self.triangle = None if patch.is_tensor else patch.net
        side = patch.sides
        self.borders = side if patch.is_tensor else [side[2], side[0], side[1], None]

    def around(self, point):
        """The coefficients R relative to a point: three arrays."""
        return [[[point.d * c[k] - c[3] * point.n[k] for c in row] for row in self.rows] for k in range(3)]

    def box(self, scale):
        """(least x, greatest x, least y, ...) of the control points in units of 2^-scale, rounded outwards."""
        points = [c for row in self.rows for c in row]
        return [bound for k in range(3) for bound in (min(rounded(c[k], c[3], scale)[0] for c in points),
                                                      max(rounded(c[k], c[3], scale)[1] for c in points))]

def rounded(n, d, scale):
    """n / d 2^scale, rounded down and up to integers."""
    n, d = (n << scale, d) if scale >= 0 else (n, d << -scale)
    return n // d, -(-n // d)

class Model:
    def __init__(self, entities, breaks, fail):
        """Tests B2 and P1.  vertices: of corner 4 * patch + corner.  firsts[edge]: (patch, side) of its first side."""
        for i, entity in enumerate(entities):
            if not entity or entity.dimension != 3 or max(entity.degrees) > MAX_DEGREE:
                raise Reject("B2", "entity %d is no surface or triangle in space of degree <= %d" % (i, MAX_DEGREE))
        self.patches = [patch for entity, b in zip(entities, breaks) for patch in patches_of(entity, b, 0, 0)]
        self.vertices = glue(self.patches, fail)[3]
        self.grids = grids = [Grid(patch) for patch in self.patches]
        self.corners, self.sides = {}, {}                   # (patch, corner), (patch, side) by vertex, by edge
        for i, patch in enumerate(self.patches):
            for k, side in enumerate(patch.sides):
                self.corners.setdefault(self.vertices[4 * i + k], []).append((i, k))
                self.sides.setdefault(side and side[0], []).append((i, k))
        self.firsts = {border[0]: (i, s) for i, grid in enumerate(grids) for s, border in enumerate(grid.borders)
                       if border and border[1]}
        self.scale = BOX_BITS - max(abs(c[k]).bit_length() - c[3].bit_length() for grid in grids for row in grid.rows
                                    for c in row for k in range(3))
        self.tree = BoxTree([grid.box(self.scale) for grid in grids])

    def patches_on_ray(self, point, direction):
        """Every patch that step 1 and step 2 of the page do not call missed, and maybe others."""
        floors, ceilings = zip(*[rounded(n, point.d, self.scale) for n in point.n])
        return self.tree.on_ray(floors, ceilings, direction)

class Point:
    """(n_x, n_y, n_z) / d, d the least common denominator.  bits: of the longest of the four."""

    def __init__(self, ratios):
        values = [Fraction(n, d) for n, d in ratios]
        self.d = 1
        for value in values:
            self.d = self.d // gcd(self.d, value.denominator) * value.denominator
        self.n = [value.numerator * (self.d // value.denominator) for value in values]
        self.bits = max(abs(c).bit_length() for c in (*self.n, self.d))


# ---------------------------------------------------------------- the conditions

def p2_not_on(model, work, ratios, patch, at):
    grid, point = model.grids[patch], Point(ratios)
    if isinstance(at, Algebraic):
        work.add_on_algebraic(grid, point.bits, at)
        why = at.not_on(grid, point)
        return why and ("P2", "%s, on patch %d" % (why, patch))
    work.add_on(grid, point.bits, at)
    u, v = at
    if min(at) < 0 or (max(at) if grid.is_tensor else u + v) > 1:
        return "P2", "the parameters leave the domain of patch %d" % patch
    if not grid.is_tensor:
        u, v = u + v, v / (u + v) if u + v else v
    for array in grid.around(point):
        column = [value_at(row, v.numerator, v.denominator) for row in array]
        if value_at(column, u.numerator, u.denominator):
            return "P2", "patch %d has another point at the parameters" % patch

def p3_p4(model, work, ratios, f, direction):
    point = Point(ratios)
    try:
        total = winding(model, point, model.patches_on_ray(point, direction), direction, work)
    except LeftOver as e:
        return "P3", str(e)
    if total != f:
        return "P4", "the winding number is %d, not %d" % (total, f)
