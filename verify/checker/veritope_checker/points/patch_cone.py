# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The walls of a spline model at a point where its patches are flat: docs/certificates/points.md, section 7."""
from fractions import Fraction

from ..common.vectors import cross, dot
from ..patches.star_box_patches import derivatives
from .algebraic import Algebraic
from .cone import wedges_of

SQUARE = (0, 0), (1, 0), (1, 1), (0, 1)
TRIANGLE = (0, 0), (1, 0), (0, 1)                           # barycentric coordinates of corners 1 and 2

def cone_at(model, point, patch, at, work):
    """The wedges, or None if the walls there are not flat.  at: the place of the point's code.  Spends work."""
    if isinstance(at, Algebraic):                           # the middle stands for other places inside
        is_tensor = model.patches[patch].is_tensor
        if min(at.distances(is_tensor)) <= 0:
            return None
        at = (Fraction(1, 2 if is_tensor else 3),) * 2
    cone = []
    for number, place in places(model, patch, tuple(at)):
        if number is None:
            return None
        work.add_on(model.grids[number], point.bits, at)
        wedges = wedges_at(model.patches[number], point, place)
        if wedges is None:
            return None
        cone += wedges
    return cone

def corners_of(patch):
    return SQUARE if patch.is_tensor else TRIANGLE

def on_side(patch, s, t):
    """The place at t of side s, in the patch's own direction."""
    a, b = (corners_of(patch)[patch.corner(s, end)] for end in (0, 1))
    return tuple((1 - t) * x + t * y for x, y in zip(a, b))

def part_passed(patch, s, at):
    """t of a place on side s; None of another place."""
    a, b = (corners_of(patch)[patch.corner(s, end)] for end in (0, 1))
    k = 0 if a[0] != b[0] else 1
    t = Fraction(at[k] - a[k]) / (b[k] - a[k])
    return t if tuple(on_side(patch, s, t)) == at else None

def places(model, patch, at):
    """(number of a patch, place) of all patches at the face, edge or vertex; (None, None) at a collapsed side."""
    own = model.patches[patch]
    passed = [(s, part_passed(own, s, at)) for s in range(own.num_sides)]
    passed = [(s, t) for s, t in passed if t is not None]
    if not passed:
        yield patch, at
    elif len(passed) == 1:
        (s, t), = passed
        for number, other in model.sides[own.sides[s][0]] if own.sides[s] else [(None, None)]:
            is_own = (number, other) == (patch, s)
            yield number, None if number is None else at if is_own else on_side(model.patches[number], other, 1 - t)
    else:
        vertex = model.vertices[4 * patch + corners_of(own).index(at)]
        for number, corner in model.corners[vertex]:
            other = model.patches[number]
            if any(other.sides[s] is None and corner in (other.corner(s, 0), other.corner(s, 1))
                   for s in range(other.num_sides)):
                number = None
            yield number, corners_of(other)[corner]

def wedges_at(patch, point, at):
    """The wedges of a patch at a place where it has the point; None if it is not flat."""
    nets = [[[point.d * x - w * n for x, w in zip(row, weights)] for row, weights in zip(a, patch.net[3])]
            for a, n in zip(patch.net, point.n)]
    both = [derivatives(a, patch.is_tensor) for a in nets]
    value, factors = (tensor_value, patch.degrees) if patch.is_tensor else (triangle_value, (1, 1))
    unit = at[0].denominator * at[1].denominator
    a, b = (tuple(factors[k] * value(of[k], at, unit) for of in both) for k in (0, 1))
    normal = cross(a, b)
    if not any(normal) or any(dot(normal, r) for rows in zip(*nets) for r in zip(*rows)):
        return None
    steps = [[int(unit * (x - y)) for x, y in zip(corner, at)] for corner in corners_of(patch)]
    return wedges_of([tuple(s * x + t * y for x, y in zip(a, b)) for s, t in steps])

def tensor_value(rows, at, unit):
    """Times unit to the sum of the degrees."""
    u, v = (int(unit * x) for x in at)
    return bernstein_value([bernstein_value(row, v, unit) for row in rows], u, unit)

def bernstein_value(c, n, d):
    while len(c) > 1:
        c = [(d - n) * x + n * y for x, y in zip(c, c[1:])]
    return c[0]

def triangle_value(rows, at, unit):
    """Times unit to the degree.  rows[r][k]: of corner 1 to the power r - k, corner 2 to the power k."""
    b, c = (int(unit * x) for x in at)
    a = unit - b - c
    while len(rows) > 1:
        rows = [[a * rows[r][k] + b * rows[r + 1][k] + c * rows[r + 1][k + 1] for k in range(r + 1)]
                for r in range(len(rows) - 1)]
    return rows[0][0]
