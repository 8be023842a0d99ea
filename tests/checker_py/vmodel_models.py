# SPDX-License-Identifier: Apache-2.0 OR MIT
"""V-models that are mapped one to one by construction, with their certificates: tests only."""
import functools
from fractions import Fraction as Q

import model_texts as texts
import vmodel_forge as forge
from volume_folded_forge import bezier, cube, made_rational, with_knots


def box(lo, hi, degrees=(1, 1, 1)):
    return bezier(degrees, lambda *p: tuple(a + (b - a) * x for a, b, x in zip(lo, hi, p)))


def mapped(m, image):
    """The map after an affine map of space."""
    return texts.Map(m.degrees, m.knots, [(*(c * p[3] for c in image([x / p[3] for x in p[:3]])), p[3]) if m.rational else image(p)
                                          for p in m.points], m.rational)


def permuted(m, axes, reverse=(0, 0, 0)):
    """The map with other names and directions of its parameters: new axis a is axes[a], reversed if reverse[a]."""
    net, knots = m.all(), []
    for a, r in zip(axes, reverse):
        t = m.knots[a]
        knots.append([t[0] + t[-1] - x for x in t[::-1]] if r else t)
    sizes, points = [m.sizes[a] for a in axes], []
    for k in range(sizes[2]):
        for j in range(sizes[1]):
            for i in range(sizes[0]):
                at = [0, 0, 0]
                for a, r, x, n in zip(axes, reverse, (i, j, k), sizes):
                    at[a] = n - 1 - x if r else x
                points.append(net[tuple(at)][:None if m.rational else 3])
    return texts.Map([m.degrees[a] for a in axes], knots, points, m.rational)


def renamed(maps, rng):
    """(the cells, their flags): the parameters of each are named and directed at random, some degrees are higher."""
    found, flags = [], []
    for m in maps:
        if all(len(t) == 2 * p + 2 for t, p in zip(m.knots, m.degrees)) and rng.random() < .5:
            m = raised_cell(m, rng.randrange(3))
        axes, reverse = rng.sample(range(3), 3), [rng.randrange(2) for _ in range(3)]
        found.append(permuted(m, axes, reverse))
        flags.append(is_mirror(axes, reverse))
    return found, flags


def is_mirror(axes, reverse):
    return (sum(axes[i] > axes[j] for i in range(3) for j in range(i + 1, 3)) + sum(reverse)) % 2


def spline(degrees, knots, point):
    """A map whose control points are point(i, j, k)."""
    sizes = [len(t) - p - 1 for p, t in zip(degrees, knots)]
    return texts.Map(degrees, knots, [point(i, j, k) for k in range(sizes[2]) for j in range(sizes[1]) for i in range(sizes[0])])


# ---------------------------------------------------------------- honest

def in_a_cube(inner=lambda p: p, outer=lambda p: tuple(3 * c for c in p)):
    """Six frusta around a cube, and the cube, which is the last: corners are (+-1, +-1, +-1)."""
    cells = []
    for axis in range(3):
        for end in (0, 1):
            p, q = forge.OTHERS[axis]

            def point(u, v, w, axis=axis, end=end, p=p, q=q):
                at = [0, 0, 0]
                at[axis], at[p], at[q] = 2 * end - 1, 2 * u - 1, 2 * v - 1
                return (outer if w else inner)(tuple(at))
            m = cube(lambda x, point=point: point(*x))
            cells.append(m if (axis == 1) != (end == 1) else permuted(m, (1, 0, 2)))
    return cells + [cube(lambda x: inner(tuple(2 * c - 1 for c in x)))]


def closed_frame():
    """A square ring of one cell, glued to itself."""
    ring = [(1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1)]
    return spline((1, 1, 1), [with_knots(1, [1, 2, 3]), [0, 0, 1, 1], [0, 0, 1, 1]],
                  lambda i, j, k: (ring[i][0] * (1 + 2 * j), ring[i][1] * (1 + 2 * j), k))


def figure_eight():
    """Thirteen boxes around two holes: the Euler characteristic is negative."""
    return [box((x, y, 0), (x + 1, y + 1, 1)) for y in range(3) for x in range(5) if y != 1 or x % 2 == 0]


def pyramid(apex=(0, 0, 0)):
    """The face u = 0 is a point."""
    return cube(lambda p: tuple(a + p[0] * (b - a) for a, b in zip(apex, (1, 2 * p[1] - 1, 2 * p[2] - 1))))


def pyramids_of_a_cube():
    """Six pyramids fill a cube."""
    cells = []
    for axes in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        for sign in (1, -1):
            def image(p, axes=axes, sign=sign):
                out = [0, 0, 0]
                for a, c in zip(axes, (sign * p[0], sign * p[1], p[2])):
                    out[a] = c
                return tuple(out)
            cells.append(mapped(pyramid(), image))
    return cells


def fan(last=1):
    """Four wedges around an axis: a prism over a square. The face u = 0 of each is collapsed onto it."""
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    return [cube(lambda p, a=a, b=b: tuple(p[0] * ((1 - p[1]) * x + p[1] * y) for x, y in zip(a, b)) + (p[2] * last,))
            for a, b in zip(corners, corners[1:] + corners[:1])]


def half_collapsed(split=False):
    """Four cells around a line on which two of them have collapsed for u < 1/2; beyond it these two meet in a face."""
    knots = [[0, 0, Q(1, 2), 1, 1], [0, 0, 1, 1], [0, 0, 1, 1]]
    ends = [(0, 2, 0)] if not split else [(0, 1, 0), (1, 2, 1)]
    cells = []
    for first, last, _ in ends:
        if split:
            knots = [[0, 0, 1, 1]] * 3

        def bend(i, first=first):
            return Q(1, 2) if first + i == 2 else 0

        def side(sign, bend=bend, first=first):
            def point(i, j, k):
                i, j, k = (i, j, k) if sign > 0 else (i, j, 1 - k)
                return (Q(first + i), sign * j, (2 * k - 1) * (j + (1 - j) * bend(i)))
            return point

        def lid(sign, bend=bend, first=first):
            def point(i, a, b):
                a, b = (a, b) if sign > 0 else (b, a)
                return (Q(first + i), a - b, sign * (a + b + bend(i) * (1 - a) * (1 - b)))
            return point
        cells += [spline((1, 1, 1), knots, point) for point in (side(1), side(-1), lid(1), lid(-1))]
    return cells


def flat_edge():
    """A prism over a quadrilateral with an angle of 180 degrees: N = 0 on that edge."""
    corners = {(0, 0): (0, 0), (1, 0): (1, 0), (0, 1): (0, 2), (1, 1): (2, 0)}
    return cube(lambda p: corners[p[0], p[1]] + (p[2],))


def shrunk_edge():
    return cube(lambda p: (1, 1, 0) if p == (1, 1, 1) else p)


def squares():
    """x = u^2, v^2, w: N = 0 on two faces, which are in X."""
    return bezier((2, 2, 1), lambda u, v, w: (int(u), int(v), w))


def bent(degree=2):
    """A curved cell with inner control points."""
    return bezier((degree,) * 3, lambda u, v, w: (u + v * w / 8, v + u * w / 8, w + u * v / 8))


def needs_a_tree():
    """N is positive, but has negative coefficients on the whole cell."""
    x = (0, 1, Q(1, 10), Q(11, 10))
    return bezier((3, 1, 1), lambda u, v, w: (x[int(3 * u)], v, w))


def curved_pair():
    """Two biquadratic cells with a common curved face, one of them of degree 3 across and with an inner knot along."""
    a = bezier((1, 2, 1), lambda u, v, w: (u + (Q(1, 2) * w if v == Q(1, 2) else 0), v, w))
    b = bezier((1, 2, 1), lambda u, v, w: (1 + u + (Q(1, 2) * w if v == Q(1, 2) else 0), v, w))
    return a, b


def raised_cell(m, axis):
    """The Bezier cell m in a degree that is higher by one along the axis."""
    net, p = m.all(), m.degrees[axis]
    found = {}
    for start in [i for i in net if i[axis] == 0]:
        def at(k, start=start):
            return start[:axis] + (k,) + start[axis + 1:]
        for k, x in enumerate(forge.raised([net[at(k)] for k in range(p + 1)], p + 1)):
            found[at(k)] = x[:None if m.rational else 3]
    degrees = [q + (a == axis) for a, q in enumerate(m.degrees)]
    points = [found[i, j, k] for k in range(degrees[2] + 1) for j in range(degrees[1] + 1) for i in range(degrees[0] + 1)]
    return texts.Map(degrees, [texts.bezier_knots(q) for q in degrees], points, m.rational)


def scaled_knots(m, axis, a, b):
    return texts.Map(m.degrees, [[a * t + b for t in k] if i == axis else k for i, k in enumerate(m.knots)], m.points, m.rational)


def weighted(m, factor=3):
    """The rational map whose weights are all this."""
    m = made_rational(m)
    return texts.Map(m.degrees, m.knots, [tuple(factor * c for c in p) for p in m.points], True)


def honest_models():
    """{name: (maps, options of forge.proved)}"""
    unit, right = cube(), box((1, 0, 0), (2, 1, 1))
    a, b = curved_pair()
    return {
        "cube": ([unit], {}),
        "cube with breaks": ([unit], {"added": [[[Q(1, 3)], [], [Q(1, 7), Q(1, 2)]]]}),
        "mirrored": ([mapped(unit, lambda p: (-p[0], p[1], p[2]))], {"flags": [1]}),
        "two": ([unit, right], {}),
        "two, one of them mirrored and turned": ([unit, permuted(right, (1, 2, 0), (0, 1, 0))], {"flags": [0, 1]}),
        "two with breaks": ([unit, scaled_knots(permuted(right, (0, 1, 2), (1, 1, 0)), 1, 3, 7)],
                            {"added": [[[], [Q(1, 3)], []], [[], [9], []]]}),
        "two, in other degrees": ([raised_cell(unit, 1), weighted(raised_cell(right, 2))], {}),
        "three in an L": ([unit, right, box((0, 1, 0), (1, 2, 1))], {}),
        "curved pair": ([raised_cell(a, 0), weighted(raised_cell(b, 1), 5)], {}),
        "bent": ([bent()], {}),
        "rational": ([texts.Map((1, 1, 1), unit.knots, [tuple(c * w for c in (*p, 1)) for p, w in zip(unit.points, (1, 2, 1, 3, 1, 1, 2, 1))], True)], {}),
        "in a cube": (in_a_cube(), {}),
        "a ring": ([closed_frame()], {}),
        "a wedge": ([cube(lambda p: (p[0], p[0] * p[1], p[2]))], {}),
        "a wedge with breaks": ([cube(lambda p: (p[0], p[0] * p[1], p[2]))], {"added": [[[Q(1, 2)], [Q(1, 3)], [Q(1, 4)]]]}),
        "a pyramid": ([pyramid()], {}),
        "a pyramid with breaks": ([pyramid((0, -Q(1, 4), 0))], {"added": [[[], [Q(1, 2)], [Q(1, 2)]]]}),
        "six pyramids": (pyramids_of_a_cube(), {}),
        "a fan": (fan(), {}),
        "half collapsed, split": (half_collapsed(True), {}),
        "a flat edge": ([flat_edge()], {}),
        "a shrunk edge": ([shrunk_edge()], {}),
        "squares": ([squares()], {}),
        "a tree": ([needs_a_tree()], {}),
        "a figure eight": (figure_eight(), {}),
        "apart": ([unit, box((5, 0, 0), (6, 1, 1))], {}),
    }


@functools.lru_cache(None)
def proved(name):
    maps, options = honest_models()[name]
    return forge.proved(maps, **options)


def honest(name):
    return proved(name).changed()
