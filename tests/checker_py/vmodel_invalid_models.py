# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models of which vmodel-1 is false by construction, with true findings of each kind, and models that are valid: tests only."""
import collections
import functools
from fractions import Fraction as Q
from itertools import product
from math import comb

import model_texts as texts
import vmodel_forge
import vmodel_models as valid
from vmodel_invalid_forge import WHOLE, Invalid
from volume_folded_forge import bezier, cube, folded_inside, made_rational

HALF = Q(1, 2)
IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def unit_box(*at):
    return valid.box(at, tuple(x + 1 for x in at))


def at(cell, *numbers):
    """A point in the first spans."""
    return cell, tuple((0, t) for t in numbers)


def arc(cell, face, side, interval=WHOLE):
    return cell, face, side, interval


def corner_at(maps, place):
    """(cell, corner) of the first corner that is this point of space."""
    for cell, m in enumerate(maps):
        for corner in range(8):
            p = m.at(*[(corner >> a & 1) * (n - 1) for a, n in enumerate(m.sizes)])
            if tuple(c / p[3] for c in p[:3]) == tuple(place):
                return cell, corner
    raise ValueError(place)


# ---------------------------------------------------------------- maps

def with_knot(m, axis, t):
    """Inserts a knot into a map that has the degree 1 and one span along the axis."""
    net, points = m.all(), []
    sizes = [n + (a == axis) for a, n in enumerate(m.sizes)]
    (lo, hi), t = (m.knots[axis][0], m.knots[axis][-1]), Q(t)
    part = (t - lo) / (hi - lo)
    for k, j, i in product(*map(range, sizes[::-1])):
        index = [i, j, k]
        n = index[axis]
        ends = []
        for end in (0, 1):
            index[axis] = end
            ends.append(net[tuple(index)])
        f = (0, part, 1)[n]
        p = tuple((1 - f) * a + f * b for a, b in zip(*ends))
        points.append(p if m.rational else p[:3])
    return texts.Map(m.degrees, [[lo, lo, t, hi, hi] if a == axis else k for a, k in enumerate(m.knots)], points, m.rational)


def power(n):
    """Bernstein coefficients of (u + i v)^n in the degrees (n, n), by blossoms: a cell that is rolled up around its edge u = v = 0, with
    n = 4 so that the faces u = 0 and v = 0 meet."""
    def coefficient(i, j):
        """The monomial u^a v^b has the coefficients C(i, a) C(j, b) / (C(n, a) C(n, b))."""
        x, y = Q(0), Q(0)
        for a in range(n + 1):
            b = n - a
            f = Q(comb(n, a) * comb(i, a) * comb(j, b), comb(n, a) * comb(n, b))
            re, im = ((1, 0), (0, 1), (-1, 0), (0, -1))[b % 4]
            x, y = x + f * re, y + f * im
        return x, y
    return bezier((n, n, 1), lambda u, v, w: (*coefficient(int(n * u), int(n * v)), w))


def spiral():
    """A square ring of one cell that runs one and a half turns in one plane."""
    ring = [(1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1), (1, -1), (-1, -1)]
    return valid.spline((1, 1, 1), [[0, 0, 1, 2, 3, 4, 5, 6, 6], [0, 0, 1, 1], [0, 0, 1, 1]],
                        lambda i, j, k: (ring[i][0] * (1 + 2 * j), ring[i][1] * (1 + 2 * j), k))


def six_of_eight():
    """The cubes around the origin without two opposite ones."""
    return [unit_box(*p) for p in product((-1, 0), repeat=3) if len(set(p)) > 1]


def partly_collapsed():
    """The cells of valid.half_collapsed(), the one below as two: valid once all are cut at u = 1/2."""
    whole, split = valid.half_collapsed(), valid.half_collapsed(True)
    return [whole[0], whole[2], whole[3], split[1], split[5]]


def small_and_partly_collapsed(place):
    """A cell of the size 1/8 that begins at this point; one of its faces collapses on one of two spans."""
    return valid.mapped(valid.half_collapsed()[0], lambda p: tuple(a + c / 16 for a, c in zip(place, (p[0], p[1], p[2] + 1))))


def there_and_back():
    """A cell on whose edge u = v = 1 z runs from 0 to 1/2 and back."""
    return bezier((1, 1, 2), lambda u, v, w: (u, v, w if (u, v) != (1, 1) else 4 * w * (1 - w)))


def flat_span():
    return valid.spline((1, 1, 1), [[0, 0, 1, 1], [0, 0, 1, 1], [0, 0, 1, 2, 3, 3]], lambda i, j, k: (Q(i), Q(j), Q((0, 1, 1, 2)[k])))


def bent_to_the_side():
    """A cell over which x and y are quadratic: its points have no rational parameters in general."""
    return bezier((2, 2, 1), lambda u, v, w: (Q(3, 4) + u + v * v / 8, Q(3, 4) + v + u * u / 8, w))


def two_pyramids():
    """With one apex."""
    return [valid.pyramid(), valid.mapped(valid.pyramid(), lambda p: (-p[0], -p[1], p[2]))]


# ---------------------------------------------------------------- true findings

def arcs_of_an_edge(first, second, shift=0):
    """Two boxes, z from 0 to 1 and from `shift`, that meet in the edge x = y = 1."""
    part = (0, 1, 1, 2) if shift else WHOLE
    other = (0, 1, 0, 1) if shift else WHOLE
    return Invalid([first, second], "curve-nonmanifold", arc(0, 1, 3, part), arc(0, 3, 3, part), arc(1, 0, 2, other))


def honest_findings():
    """{name: function without arguments that makes it}"""
    a, b = cube(), unit_box(1, 1, 0)
    heavy = valid.weighted(b, 3)
    mirrored = valid.mapped(cube(), lambda p: (-p[0], p[1], p[2]))
    turned = valid.permuted(b, (0, 1, 2), (1, 1, 1))      # begins where b ends
    half = (0, 1, 1, 2)
    wedge = cube(lambda p: (p[0], p[0] * p[1], p[2]))
    corner = six_of_eight()
    shared = [cube(), unit_box(1, 1, 1)]
    high = valid.raised_cell(unit_box(1, 1, 0), 2)
    found = {
        "a flat cell": Invalid([cube(lambda p: (p[0], p[1], 0))], "flat", 0, (0, 0, 0)),
        "a cell that is a line": Invalid([cube(), cube(lambda p: (p[0], 0, 0))], "flat", 1, (0, 0, 0)),
        "flat, rational": Invalid([valid.weighted(cube(lambda p: (p[0], p[1], p[0])), 3)], "flat", 0, (0, 0, 0)),
        "flat on one span": Invalid([flat_span()], "flat", 0, (0, 0, 1)),
        "a mirrored cube": Invalid([mirrored], "left-handed", at(0, HALF, HALF, HALF)),
        "a mirrored cube at its corner": Invalid([cube(), mirrored], "left-handed", at(1, 0, 1, 0)),
        "mirrored, rational": Invalid([valid.weighted(mirrored, 2)], "left-handed", at(0, Q(1, 3), 0, 1)),
        "backward in the middle": Invalid([folded_inside()], "left-handed", at(0, HALF, HALF, HALF)),
        "a wedge at its edge": Invalid([wedge], "singular", at(0, 0, HALF, HALF)),
        "a flat cell at a point": Invalid([cube(lambda p: (p[0], p[1], 0))], "singular", at(0, Q(2, 7), HALF, 1)),
        "squares at a face": Invalid([valid.squares()], "singular", at(0, 0, HALF, 1)),
        "rolled up": Invalid([power(4)], "singular", at(0, 0, 0, HALF)),
        "at the flat span's begin": Invalid([flat_span()], "singular", (0, ((0, 0), (0, 0), (1, 0)))),
        "overlapping cubes": Invalid([cube(), unit_box(HALF, HALF, HALF)], "overlap", at(0, Q(3, 4), Q(3, 4), Q(3, 4)), at(1, *[Q(1, 4)] * 3)),
        "overlapping cubes, a box": Invalid([cube(), unit_box(HALF, HALF, HALF)], "overlap", at(0, Q(3, 4), Q(3, 4), Q(3, 4)),
                                            (1, ((0, 1, 0, 1),) * 3), IDENTITY),
        "a corner inside of a cube": Invalid([unit_box(HALF, HALF, HALF), cube()], "overlap", at(0, HALF, HALF, HALF), at(1, 1, 1, 1)),
        "a cell inside another": Invalid([valid.box((0, 0, 0), (3, 3, 3)), unit_box(1, 1, 1)], "overlap", at(1, 0 + HALF, HALF, HALF),
                                         at(0, HALF, HALF, HALF)),
        "a cell and its copy": Invalid([cube(), cube()], "overlap", at(0, HALF, HALF, HALF), at(1, HALF, HALF, HALF)),
        "a cell and its copy, rational": Invalid([cube(), valid.weighted(cube(), 5)], "overlap", at(1, HALF, HALF, HALF), at(0, HALF, HALF, HALF)),
        "a spiral": Invalid([spiral()], "overlap", (0, ((0, HALF), (0, HALF), (0, HALF))), (0, ((4, HALF), (0, HALF), (0, HALF)))),
        "a spiral at a knot": Invalid([spiral()], "overlap", (0, ((0, 1), (0, HALF), (0, HALF))), (0, ((5, 0), (0, HALF), (0, HALF)))),
        "a spiral, a box": Invalid([spiral()], "overlap", (0, ((0, HALF), (0, HALF), (0, HALF))),
                                   (0, ((4, 2, 1, 3), (0, 2, 1, 3), (0, 2, 1, 3))), ((0, -1, 0), (1, 0, 0), (0, 0, 1))),
        "no rational parameters": Invalid([cube(), bent_to_the_side()], "overlap", at(0, Q(31, 32), Q(31, 32), HALF),
                                          (1, ((0, 2, 0, 1), (0, 2, 0, 1), WHOLE)), IDENTITY),
        "two cubes at an edge": arcs_of_an_edge(a, b),
        "two cubes at an edge, rational": arcs_of_an_edge(a, heavy),
        "two cubes at a half edge": arcs_of_an_edge(a, unit_box(1, 1, HALF), HALF),
        "two cubes at an edge, turned": Invalid([a, turned], "curve-nonmanifold", arc(0, 1, 3), arc(0, 3, 3), arc(1, 1, 3)),
        "two cubes at an edge, elevated": arcs_of_an_edge(a, high),
        "two cubes at an edge, two of each": Invalid([a, b], "curve-nonmanifold", arc(0, 1, 3, half), arc(1, 0, 2, half), arc(1, 2, 2, half)),
        "two cubes at an edge with a knot": Invalid([a, with_knot(b, 2, HALF)], "curve-nonmanifold", arc(0, 1, 3, half), arc(0, 3, 3, half),
                                                    arc(1, 0, 2, (1, 0, 0, 1))),
        "a face that is a part of another": Invalid([cube(), valid.box((1, 0, 0), (2, HALF, 1))], "curve-nonmanifold", arc(0, 1, 2),
                                                    arc(0, 2, 3), arc(1, 0, 2)),
        "three cubes": Invalid([cube(), unit_box(1, 1, 0), unit_box(2, 0, 0)], "curve-nonmanifold", arc(1, 1, 2), arc(1, 2, 3), arc(2, 0, 3)),
        "an edge that runs there and back": Invalid([there_and_back()], "curve-nonmanifold", arc(0, 1, 3, (0, 1, 0, 1)), arc(0, 1, 3, half),
                                                    arc(0, 3, 3, half)),
        "two cubes at an edge, another cell at its begin": Invalid([a, b, small_and_partly_collapsed((1, 1, 0))], "curve-nonmanifold",
                                                                   arc(0, 1, 3), arc(0, 3, 3), arc(1, 0, 2)),
        "two cubes at a corner, another cell far away": Invalid(shared + [small_and_partly_collapsed((5, 1, 1))], "point-nonmanifold", 0, 7),
        "two cubes at a corner": Invalid(shared, "point-nonmanifold", 0, 7),
        "two cubes at a corner, the other's": Invalid(shared, "point-nonmanifold", 1, 0),
        "two cubes at a corner, rational": Invalid([made_rational(cube()), valid.weighted(unit_box(1, 1, 1), Q(1, 4))], "point-nonmanifold", 0, 7),
        "two cubes at an edge, its end": Invalid([a, b], "point-nonmanifold", 0, 3),
        "six of eight": Invalid(corner, "point-nonmanifold", *corner_at(corner, (0, 0, 0))),
        "pyramids with one apex": Invalid(two_pyramids(), "point-nonmanifold", 0, 0),
        "pyramids with one apex, another corner": Invalid(two_pyramids(), "point-nonmanifold", 1, 6),
        "wedges with one edge": Invalid([valid.fan()[0], valid.fan()[2]], "point-nonmanifold", 0, 0),
        "wedges along one edge": Invalid([valid.fan()[0], valid.fan()[2]], "curve-nonmanifold", arc(0, 2, 2), arc(0, 3, 2), arc(1, 3, 2)),
    }
    renamed = [valid.permuted(m, (2, 0, 1), (n & 1, n >> 1 & 1, 0)) for n, m in enumerate(corner)]
    found["six of eight, renamed"] = Invalid(renamed, "point-nonmanifold", *corner_at(renamed, (0, 0, 0)))
    knotted = [with_knot(m, n % 3, m.knots[0][0] + Q(n + 1, 8)) for n, m in enumerate(corner)]
    found["six of eight, with knots"] = Invalid(knotted, "point-nonmanifold", *corner_at(knotted, (0, 0, 0)))
    raised = [valid.weighted(valid.raised_cell(m, n % 3), n + 1) if n % 2 else m for n, m in enumerate(corner)]
    found["six of eight, in other degrees"] = Invalid(raised, "point-nonmanifold", *corner_at(raised, (0, 0, 0)))
    return found


@functools.lru_cache(None)
def made():
    return honest_findings()


def honest(name):
    return made()[name].changed()


# ---------------------------------------------------------------- valid models

def with_knots_on_one_side():
    """Two cells with a common face that have different knots there; vmodel-1 needs the breaks of both."""
    return [with_knot(with_knot_late(cube()), 1, Q(1, 3)), unit_box(1, 0, 0)]


def with_knot_late(m):
    return with_knot(m, 2, Q(2, 5))


def valid_models():
    """{name: cells}"""
    found = {name: maps for name, (maps, _) in valid.honest_models().items()}
    found["rolled up"] = [power(4)]
    found["rolled up, two"] = [power(4), valid.mapped(power(4), lambda p: (p[0], p[1], p[2] + 1))]
    found["knots on one side"] = with_knots_on_one_side()
    found["knots on both sides"] = [with_knot(cube(), 1, Q(1, 3)), with_knot(valid.permuted(unit_box(1, 0, 0), (0, 1, 2), (1, 1, 0)), 1, Q(1, 4))]
    found["eight"] = [unit_box(*p) for p in product((-1, 0), repeat=3)]
    found["seven of eight"] = [unit_box(*p) for p in product((-1, 0), repeat=3)][:7]
    found["four of eight, around an edge of the rest"] = [unit_box(*p) for p in ((0, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1))]
    found["half of a fan"] = valid.fan()[:2]
    found["three quarters of a fan"] = valid.fan()[:3]
    found["two fans, one on the other"] = valid.fan() + [valid.mapped(m, lambda p: (p[0], p[1], p[2] + 1)) for m in valid.fan()]
    for name, last in (("a wedge", 1), ("half a fan", 2), ("three quarters of a fan", 3)):
        found[name + " on another"] = [valid.mapped(m, lambda p, z=z: (p[0], p[1], p[2] + z)) for m in valid.fan()[:last] for z in (0, 1)]
    found["half of six pyramids"] = [m for m in valid.pyramids_of_a_cube()[::2]]
    found["five of six pyramids"] = valid.pyramids_of_a_cube()[:5]
    found["a ring of cells"] = ring_of_cells()
    return found


def ring_of_cells(count=4, growth=0):
    corners = [(1, 1), (1, -1), (-1, -1), (-1, 1)]

    def corner(n):
        return tuple(c * (1 + growth * n) for c in corners[n % 4])
    return [cube(lambda p, n=n: tuple((1 - p[0]) * (1 + 2 * p[1]) * a + p[0] * (1 + 2 * p[1]) * b for a, b in zip(
        corner(n), corner(n + 1))) + (p[2],)) for n in range(count)]


# ---------------------------------------------------------------- arcs

def sides_by_curve(maps):
    """{curve: arcs}: whole spans of sides and their halves that are not collapsed. A curve is known by four of its points, in the tests'
    own way."""
    found = collections.defaultdict(list)
    for cell, m in enumerate(maps):
        net = m.all()
        for face, side in product(range(6), range(4)):
            along = vmodel_forge.OTHERS[face // 2][side // 2]
            index = [None] * 3
            index[face // 2], index[vmodel_forge.OTHERS[face // 2][1 - side // 2]] = face % 2, side % 2
            line = [net[tuple(i if x is None else x * (n - 1) for x, n in zip(index, m.sizes))] for i in range(m.sizes[along])]
            spans = sorted(set(m.knots[along]))
            for k, (lo, hi) in enumerate(zip(spans, spans[1:])):
                for part in ((0, 0, 1), (1, 0, 1), (1, 1, 2)):
                    first, last = [lo + (hi - lo) * Q(n, 1 << part[0]) for n in part[1:]]
                    points = [place_on(line, m, along, k, first + (last - first) * t) for t in (0, Q(1, 3), Q(2, 3), 1)]
                    if points[0] != points[1]:
                        found[min(tuple(points), tuple(points[::-1]))].append(arc(cell, face, side, (k, *part)))
    return found


def place_on(line, m, axis, span, t):
    knots, p = m.knots[axis], m.degrees[axis]
    k = max(i for i, x in enumerate(knots) if x == sorted(set(knots))[span])
    q = vmodel_forge.blossom(line, knots, p, k, [t] * p)
    return tuple(c / q[3] for c in q[:3])


# ---------------------------------------------------------------- the truth about cells around a point

# The octants around each half-axis, in order; bit a of an octant says on which side of the origin it lies along axis a.
OCTANT_RINGS = [[end << axis | i << b | j << c for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
                for axis, (b, c) in enumerate(vmodel_forge.OTHERS) for end in (0, 1)]


def border_cycles(there, rings):
    """rings: the cells around each line through the point, in order. Cells that follow one another join the two sides at which they end."""
    joined = collections.defaultdict(list)
    for ring in rings:
        for first, cell in enumerate(ring):
            if cell in there and ring[first - 1] not in there:
                last = first
                while ring[(last + 1) % len(ring)] in there:
                    last += 1
                ends = [(cell, frozenset((cell, ring[first - 1]))), (ring[last % len(ring)], frozenset((ring[last % len(ring)], ring[(last + 1) % len(ring)])))]
                for one, other in (ends, ends[::-1]):
                    joined[one].append(other)
    seen, cycles = set(), 0
    for start in joined:
        cycles += start not in seen
        reached = [start]
        while reached:
            side = reached.pop()
            if side not in seen:
                seen.add(side)
                reached += joined[side]
    return cycles


def voxel_cycles(voxels, place):
    """(the cycles of the border around a point of the lattice, of the unit cubes that begin at these points; whether two cubes meet in an
    edge there of which nothing else is in a cube)"""
    octants = [o for o in range(8) if tuple(x - 1 + (o >> a & 1) for a, x in enumerate(place)) in voxels]
    touches = any([o in octants for o in ring] in ([True, False] * 2, [False, True] * 2) for ring in OCTANT_RINGS)
    return border_cycles(octants, OCTANT_RINGS), touches


def bent_voxels(voxels, rng):
    """The cubes, after each point of the lattice has moved a little."""
    moved = collections.defaultdict(lambda: [Q(rng.randint(-4, 4), 32) for _ in range(3)])
    return [cube(lambda p, at=at: tuple(a + c + d for a, c, d in zip(at, p, moved[tuple(int(a + c) for a, c in zip(at, p))]))) for at in voxels]
