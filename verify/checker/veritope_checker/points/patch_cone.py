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
    for number, place, pole in places(model, patch, tuple(at)):
        work.add_on(model.grids[number], point.bits, at)
        at_pole, own = pole is not None, model.patches[number]
        wedges = wedges_at_pole(own, point, pole) if at_pole else wedges_at(own, point, place)
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
    """(number of a patch, place, None or the side collapsed to it) for each patch at the face, edge or vertex."""
    own = model.patches[patch]
    passed = [(s, part_passed(own, s, at)) for s in range(own.num_sides)]
    passed = [(s, t) for s, t in passed if t is not None]
    if not passed:
        yield patch, at, None
    elif len(passed) == 1 and own.sides[passed[0][0]]:
        (s, t), = passed
        for number, other in model.sides[own.sides[s][0]]:
            is_own = (number, other) == (patch, s)
            yield number, at if is_own else on_side(model.patches[number], other, 1 - t), None
    else:
        corner = own.corner(passed[0][0], 0) if len(passed) == 1 else corners_of(own).index(at)
        for number, corner in model.corners[model.vertices[4 * patch + corner]]:
            other = model.patches[number]
            start, end = (next(s for s in range(other.num_sides) if other.corner(s, end) == corner) for end in (0, 1))
            if other.sides[end]:
                yield number, corners_of(other)[corner], None if other.sides[start] else start

def net_around(patch, point):
    """The control points relative to the point: three arrays."""
    return [[[point.d * x - w * n for x, w in zip(row, weights)] for row, weights in zip(a, patch.net[3])]
            for a, n in zip(patch.net, point.n)]

def is_flat(nets, normal):
    return any(normal) and not any(dot(normal, r) for rows in zip(*nets) for r in zip(*rows))

def wedges_at(patch, point, at):
    """The wedges of a patch at a place where it has the point; None if it is not flat."""
    nets = net_around(patch, point)
    both = [derivatives(a, patch.is_tensor) for a in nets]
    value, factors = (tensor_value, patch.degrees) if patch.is_tensor else (triangle_value, (1, 1))
    unit = at[0].denominator * at[1].denominator
    a, b = (tuple(factors[k] * value(of[k], at, unit) for of in both) for k in (0, 1))
    if not is_flat(nets, cross(a, b)):
        return None
    steps = [[int(unit * (x - y)) for x, y in zip(corner, at)] for corner in corners_of(patch)]
    return wedges_of([tuple(s * x + t * y for x, y in zip(a, b)) for s, t in steps])

def wedges_at_pole(patch, point, s):
    """The wedges of a patch with side s collapsed to the point; None if it is not flat, or its fan does not turn."""
    nets = net_around(patch, point)
    fan = list(zip(*[patch.side_of(without_side(a, s, patch.is_tensor), s) for a in nets]))[::-1]
    normal = cross(fan[0], fan[-1])
    if not is_flat(nets, normal):
        return None
    for i, r in enumerate(fan):
        for k in range(i + 1, len(fan)):
            turn = dot(normal, cross(r, fan[k]))
            if turn < 0 or turn == 0 and (i, k) in ((0, 1), (len(fan) - 2, len(fan) - 1)):
                return None
    return wedges_of([fan[0], fan[-1], (0, 0, 0)])

def without_side(rows, s, is_tensor):
    """An array without the row of side s."""
    if is_tensor:
        return [[r[1:] for r in rows], rows[:-1], [r[:-1] for r in rows], rows[1:]][s]
    return [rows[:-1], [r[:-1] for r in rows[1:]], [r[1:] for r in rows[1:]]][s]

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
