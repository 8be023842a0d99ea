# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claim patch-invalid-1: sound models with witnesses that look right, and wrong proofs about broken ones."""
import copy
from fractions import Fraction as Q

import patch_solids as ps                                 # and the way to the forges
import patch_invalid_forge as forge

MODELS, STAR = ps.models, ps.forge
WHOLE, HALF = (0, 0, 1), (2, 2, 2)


def sound(rng):
    if rng.random() < .25:
        name = rng.choice(("torus", "octant_sphere", "cubic_octahedron", "bicubic_ball"))
        return at_random(getattr(MODELS, name)(), rng)
    return ps.solid(rng, 0).entities


def at_random(entities, rng):
    place = ps.random_map(rng)
    return [ps.mapped_entity(e, *place) for e in entities]


def changed(finding, **fields):
    new = copy.copy(finding)
    for key, value in fields.items():
        setattr(new, key, value)
    return new


def rows_by_newton(parsed, a, b, start, fixed):
    try:
        _, pu, pv = parsed.at(a, *start[:2])
        _, qu, qv = parsed.at(b, *start[2:])
        columns = [pu, pv, [-c for c in qu], [-c for c in qv]]
        y = forge.inverse(list(zip(*[c for i, c in enumerate(columns) if i != fixed])))
        return [[max(min(round(c * 1024), 1 << 60), -1 << 60) for c in row] for row in y]
    except (ZeroDivisionError, OverflowError, ValueError):
        return None


# ---------------------------------------------------------------- crossings of sound models

def common_border(rng):
    """Points that two patches share on an edge, a corner, a seam, a pole; or one patch with itself."""
    entities = sound(rng)
    parsed = forge.Parsed(entities)
    for _ in range(6):
        a = rng.randrange(len(entities))
        b = rng.choice((a, rng.randrange(len(entities)), (a + 1) % len(entities)))
        places = [rng.choice((Q(0), Q(1), Q(1, 2), Q(1, 1 << 20), 1 - Q(1, 1 << 20))) for _ in range(4)]
        fixed, h = rng.choice((0, 1, 2, 3, 3, None)), Q(1, 1 << rng.choice((1, 5, 21, 40)))
        at = [(p, p) if i == fixed else (max(p - h, 0), min(p + h, 1)) for i, p in enumerate(places)]
        finding = forge.Finding(entities)
        finding.pair = [(a, *at[:2]), (b, *at[2:])]
        random_rows = [[rng.randint(-9, 9) for _ in range(3)] for _ in range(3)]
        finding.y = rng.random() < .7 and rows_by_newton(parsed, a, b, list(map(float, places)), fixed or 0) or random_rows
        yield finding


def a_hair_away(rng):
    """A witness of crossing boxes, told about boxes that have been moved apart, by a hair or by a lot."""
    a = ps.box_solid(rng, (0, 0, 0), (4, 4, 4))
    entities, other = a.entities, ps.box_solid(rng, (1, 1, 3), (3, 3, 6)).entities
    if any(e["shape"]["rational"] or e["shape"]["degrees"] != [1, 1] for e in entities + other):
        entities, other = [ps.box_solid(NoChoice, *c).entities for c in (((0, 0, 0), (4, 4, 4)), ((1, 1, 3), (3, 3, 6)))]
    finding = crossing_of_boxes(entities + other)
    apart = rng.choice((Q(1, 1 << 20), Q(1, 1 << 52), Q(1, 1 << 300), Q(1), Q(5)))
    moved = [ps.mapped_entity(e, *ps.ROTATIONS[0], (1, 1, 1), (0, 0, 1 + apart)) for e in other]
    yield changed(finding, entities=entities + moved)
    low = [ps.mapped_entity(e, *ps.ROTATIONS[0], (1, 1, 1), (10 + apart, 0, 0)) for e in other]
    yield changed(finding, entities=entities + low)


class NoChoice:
    """The plain box: the first of all choices."""
    choice = staticmethod(lambda options: options[0])


def crossing_of_boxes(entities):
    """The top of the first box (z = 4) and a wall of the second."""
    top = face_at(entities[:6], 2, 4)
    wall = 6 + face_at(entities[6:], 0, 1)
    parsed = forge.Parsed(entities)
    return forge.crossing(entities, top, wall, start_of(parsed, top, wall), 1, 4)


def face_at(entities, axis, value):
    return next(i for i, e in enumerate(entities) if all(Q(p[axis]) == value for p in e["shape"]["points"]))


def start_of(parsed, a, b):
    return min(((u / 8 + .03, v / 8 + .05, s / 8 + .04, t / 8 + .02) for u in range(2, 7, 2) for v in range(2, 7, 2) for s in range(2, 7, 2) for t in range(2, 7, 2)),
               key=lambda x: sum((p - q) ** 2 for p, q in zip(parsed.at(a, *x[:2])[0], parsed.at(b, *x[2:])[0])))


def two_points_fixed(rng):
    """Lines on opposite faces of a box that cross when they are seen along the third axis."""
    entities = MODELS.cube()
    axes, signs, scales, shift = ps.random_map(rng)
    y = [[0, 1, 0], [0, 0, -1], [1, 0, 0]]
    finding = forge.Finding([ps.mapped_entity(e, axes, signs, scales, shift) for e in entities])
    finding.pair = [(0, rng.choice(((2, 1, 3), (4, 3, 9))), HALF), (1, HALF, rng.choice((WHOLE, (2, 1, 3), (4, 7, 12))))]
    finding.y = [[6 // scales[k] * signs[k] * row[axes[k]] for k in range(3)] for row in y]
    yield finding
    yield changed(finding, y=[finding.y[0], finding.y[1], finding.y[0]])
    yield changed(finding, pair=finding.pair[::-1])


def dependent_rows(rng):
    """Rows that do not see one direction."""
    for finding in two_points_fixed(rng):
        a, b = finding.pair
        finding.pair = [(a[0], a[1], (3, 3, 5)), b]
        finding.y = rng.choice(([finding.y[0]] * 3, [[0] * 3] * 3, [finding.y[0], finding.y[1], [s + t for s, t in zip(*finding.y[:2])]]))
        yield finding


# ---------------------------------------------------------------- sides of sound models

def edge_of(rng):
    entities = sound(rng)
    patches = forge.Parsed(entities).patches
    outer = [(n, s) for n, s in patches.outer() if not forge.check.is_collapsed(patches[n].side(s))]
    return forge.side(entities, *rng.choice(outer), part=rng.choice((WHOLE, (2, 1, 3), (4, 0, 9))), t0=Q(rng.choice((5, 7, 8)), 16))


def edges_told_as_borders(rng):
    """The mate left out, told with other intervals, or swallowed by arcs that overlap; numbers that hide it."""
    finding = edge_of(rng)
    if len(finding.arcs) != 2:
        return
    first, (n, s, (k, a, b)) = finding.arcs
    yield finding                                         # 1 and 1
    one = {"same": 1, "opposite": 0}
    yield changed(finding, arcs=[first], values=one)
    yield changed(finding, arcs=[first], values={"same": 2, "opposite": 0})
    yield changed(finding, arcs=[first, first], values={"same": 2, "opposite": 0})
    yield changed(finding, arcs=finding.arcs + [first], values={"same": 2, "opposite": 1})
    yield changed(finding, arcs=finding.arcs + [finding.arcs[1]], values={"same": 1, "opposite": 2})
    yield changed(finding, arcs=finding.arcs + [(*first[:2], half_of(first[2]))] * 2, values={"same": 3, "opposite": 1})
    for other in ((k + 1, 2 * a, 2 * b - 1), (k, a, a), (0, 0, 1), (k + 3, 8 * a, 8 * b - 1)):
        yield changed(finding, arcs=[first, (n, s, other)], values=rng.choice((one, {"same": 1, "opposite": 1}, {"same": 2, "opposite": 0})))
    wrong = [(m, t, first[2]) for m in range(len(finding.entities)) for t in range(3) if (m, t) not in ((n, s), first[:2])]
    yield changed(finding, arcs=[first, rng.choice(wrong)], values={"same": 2, "opposite": 0})
    yield changed(finding, arcs=[first], values=one, t0=rng.choice(((0, 0), (0, 1), (5, 31), (62, 1))))
    yield changed(finding, arcs=[first], values=one, axis=(finding.axis + 1) % 3)


def half_of(at):
    k, a, b = at
    return k + 1, 2 * a, a + b


def inner_breaks(rng):
    """A break line inside of a face, told as a border."""
    entities = at_random(MODELS.cube(degree=rng.choice((1, 2))), rng)
    finding = forge.Finding(entities, kind=1)
    i, cuts = rng.randrange(6), [Q(0), Q(1, rng.choice((2, 3))), Q(1)]
    finding.breaks = [[cuts, [Q(0), Q(1)]] if n == i else b for n, b in enumerate(finding.breaks)]
    outer = set(((i, s) for s in (0, 2, 3)))
    for side in range(4):
        if (i, side) not in outer:
            for axis in range(3):
                new = changed(finding, arcs=[(i, side, WHOLE)], axis=axis, t0=(1, 1), values={"same": 1, "opposite": 0})
                yield new


def turned_by_flags(rng):
    """A face that the prover turns over: its sides pass twice in one direction."""
    entities = sound(rng)
    flags = [0] * len(entities)
    i = rng.randrange(len(entities))
    flags[i] = 1
    patches = forge.Parsed(entities).patches
    sides = [(n, s) for n, s in patches.outer() if n == i and not forge.check.is_collapsed(patches[n].side(s))]
    yield forge.side(entities, *rng.choice(sides), flags=flags)


# ---------------------------------------------------------------- wrong proofs about models that are open

def wrong_proofs(rng):
    entities = at_random(MODELS.cube()[1:], rng)
    border = next((n, s) for n in range(5) for s in range(4) if forge.passing(entities, n, s)[1:] == (1, 0))
    finding = forge.side(entities, *border)
    for axis in {0, 1, 2} - {finding.axis}:
        yield changed(finding, axis=axis)
    for same, opposite in ((0, 1), (2, 0), (1, 1), (0, 0), (1 << 40, 0)):
        yield changed(finding, values={"same": same, "opposite": opposite})
    for values in ({"patches": 6}, {"flipped": 1}, {"finding": "crossing"}):
        yield changed(finding, values=dict(finding.values, **values))
    rows = [[(x, y, 0) for y in (0, 1)] for x in (0, 1, 2, 3)]
    torn = STAR.surface(rows, (1, 1), [[0, 0, 1, 1, 2, 2], [0, 0, 1, 1]])
    yield forge.side(at_random([torn], rng), 0, 0)


STRATEGIES = (common_border, common_border, a_hair_away, two_points_fixed, dependent_rows, edges_told_as_borders, edges_told_as_borders,
              edges_told_as_borders, inner_breaks, turned_by_flags, wrong_proofs)


def invalid_attacks(rng):
    strategy = rng.choice(STRATEGIES)
    for finding in strategy(rng):
        model = STAR.encode_model(finding.entities)
        yield strategy.__name__, model, finding.certificate(model)


def moved_finding(finding, rng):
    """Rows of Y take back the map, up to a factor."""
    axes, signs, scales, shift = ps.random_map(rng)
    rows = [[6 // scales[k] * signs[k] * row[axes[k]] for k in range(3)] for row in finding.y]
    return changed(finding, entities=[ps.mapped_entity(e, axes, signs, scales, shift) for e in finding.entities], y=rows)


def honest(rng):
    """Crossing boxes and open ones."""
    boxes = [ps.box_solid(NoChoice, *c).entities for c in (((0, 0, 0), (4, 4, 4)), ((1, 1, 3), (3, 3, 6)))]
    finding = crossing_of_boxes(boxes[0] + boxes[1])
    yield "crossing", moved_finding(finding, rng)
    entities = at_random(MODELS.cube()[:rng.randint(1, 5)], rng)
    border = rng.choice([(n, s) for n in range(len(entities)) for s in range(4) if forge.passing(entities, n, s)[1:] == (1, 0)])
    yield "side", forge.side(entities, *border)
