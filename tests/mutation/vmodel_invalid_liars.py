#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claim vmodel-invalid-1: findings about models that are valid by construction, and findings
about invalid ones that are wrong in one thing by construction. As attacks.py, whose harness this is. Run

    python3 tests/mutation/vmodel_invalid_liars.py --count 20000 --seed 1 --checker PATH_TO_veritope-check
"""
import functools
import itertools
import math
import sys
from fractions import Fraction as Q

import patch_attacks
import patch_solids                                       # noqa: F401  the way to the forges
import vmodel_invalid_lies as lies
import vmodel_invalid_models as models
import vmodel_liars
import vmodel_models as valid
import volume_folded_forge as folds
from vmodel_invalid_forge import KINDS, Invalid
from vmodel_invalid_models import HALF

CONDITIONS = ["B2", "B3", "F1", "H1", "Z1", "O1", "O2", "O3", "O4", "C1", "C2", "C3", "V1", "P1", "P2"]
TURNS = vmodel_liars.TURNS


# ---------------------------------------------------------------- what the strategies share

def placed(lie, rng):
    """After a map of space that keeps the hand."""
    axes, signs = rng.choice(TURNS)
    scales, shift = [rng.choice((1, 2, 3)) for _ in range(3)], [Q(rng.randint(-40, 40), 8) for _ in range(3)]

    def image(p):
        return tuple(scales[k] * signs[k] * p[axes[k]] + shift[k] for k in range(3))
    parts = lie.parts
    if lie.kind == "overlap" and len(parts) == 3:
        most = math.lcm(*scales)
        parts = *parts[:2], tuple(tuple(most // scales[k] * signs[k] * row[axes[k]] for k in range(3)) for row in parts[2])
    return told(lie.changed(maps=[valid.mapped(m, image) for m in lie.maps], parts=parts), rng)


def told(lie, rng):
    """In some format; a number that has no decimals keeps it in the first."""
    lie = lie.changed(subject_format=rng.choice(("vjson", "itd", "g2")))
    try:
        lie.model()
    except (AssertionError, ValueError):
        lie = lie.changed(subject_format="vjson")
    return lie


@functools.lru_cache(None)
def valid_names():
    return list(models.valid_models())


@functools.lru_cache(None)
def cells_named(name):
    return models.valid_models()[name]


def varied(maps, rng):
    """The cells with other names and directions of their parameters, in other degrees, with more knots or rational."""
    maps, _ = valid.renamed(maps, rng) if rng.random() < .6 else (list(maps), None)
    for n, m in enumerate(maps):
        axis, r = rng.randrange(3), rng.random()
        if r < .2 and m.degrees[axis] == 1 and len(m.knots[axis]) == 4:
            lo, hi = m.knots[axis][0], m.knots[axis][-1]
            maps[n] = models.with_knot(m, axis, lo + (hi - lo) * Q(rng.randint(1, 4), 5))
        elif r < .3:
            maps[n] = valid.weighted(m, rng.choice((1, 3, Q(1, 4)))) if not m.rational else m
    return maps


def random_voxels(rng):
    """(unit cubes by their least corners, whether their border is a surface, the points of the lattice at which it is more than one cycle)"""
    size = rng.choice(((3, 1, 1), (2, 2, 1), (2, 2, 2), (3, 2, 1), (3, 2, 2)))
    all_of_them = list(itertools.product(*map(range, size)))
    voxels = rng.sample(all_of_them, rng.randint(2, min(7, len(all_of_them))))
    found = {place: models.voxel_cycles(voxels, place) for place in itertools.product(*[range(n + 1) for n in size])}
    wrong = [place for place, (cycles, _) in found.items() if cycles > 1]
    return voxels, not wrong and not any(touches for _, touches in found.values()), wrong


def manifold_voxels(rng):
    """Cells whose border is a surface."""
    while True:
        voxels, is_surface, _ = random_voxels(rng)
        if is_surface:
            return models.bent_voxels(voxels, rng)


def some_valid(rng):
    """(name, cells)"""
    if rng.random() < .3:
        return "voxels", varied(manifold_voxels(rng), rng)
    name = rng.choice(valid_names())
    maps = cells_named(name)
    return name.replace(" ", "_").replace(",", ""), varied(maps, rng) if rng.random() < .7 else maps


def number(rng):
    return rng.choice((Q(1, 2), Q(1, 3), Q(3, 4), Q(1, 1 << 40), Q(rng.randint(1, 12), 13)))


def somewhere(m, rng):
    return tuple((rng.randrange(len(set(knots)) - 1), number(rng)) for knots in m.knots)


def on_a_face(m, rng):
    place, axis = list(somewhere(m, rng)), rng.randrange(3)
    place[axis] = rng.choice(((0, 0), (len(set(m.knots[axis])) - 2, 1)))
    return tuple(place)


def some_interval(rng, k):
    e = rng.choice((0, 1, 2, 5, 62))
    a, b = sorted(rng.sample(range(min(9, (1 << e) + 1)), 2)) if e else (0, 1)
    return k, e, a, b


# ---------------------------------------------------------------- findings about valid models

def flat_cells(rng):
    name, maps = some_valid(rng)
    for _ in range(3):
        cell = rng.randrange(len(maps))
        yield "flat", placed(Invalid(maps, "flat", cell, tuple(rng.randrange(len(set(t)) - 1) for t in maps[cell].knots)), rng)


def wrong_signs(rng):
    """The sign of the determinant is known in the tests' own way."""
    name, maps = some_valid(rng)
    for _ in range(4):
        cell = rng.randrange(len(maps))
        place = rng.choice((somewhere, on_a_face))(maps[cell], rng)
        sign = folds.sign(maps[cell], place)
        for kind, true in (("left-handed", -1), ("singular", 0)):
            if sign != true:
                yield kind.replace("-", "_"), placed(Invalid(maps, kind, (cell, place)), rng)


def points_in_two_places(rng):
    name, maps = some_valid(rng)
    for _ in range(6):
        cells = [rng.randrange(len(maps)) for _ in range(2)]
        places = [(c, rng.choice((somewhere, somewhere, on_a_face))(maps[c], rng)) for c in cells]
        yield "two_points", placed(Invalid(maps, "overlap", *places), rng)
    (cell, place), = places[:1]
    yield "a_point_twice", placed(Invalid(maps, "overlap", (cell, place), (cell, tuple((k, (3 * t.numerator, 3 * t.denominator)) for k, t in
                                                                                      ((k, Q(t)) for k, t in place)))), rng)


def points_of_a_common_face(rng):
    """A and B are one point of a face that two cells share; A lies on it, or a hair inside."""
    maps = [folds.cube(), models.unit_box(1, 0, 0)]
    v, w = number(rng), number(rng)
    hair = rng.choice((0, 0, Q(1, 1 << 52), Q(1, 1 << 62)))
    a, b = (0, ((0, 1 - hair), (0, v), (0, w))), (1, ((0, 0), (0, v), (0, w)))
    yield "common_face", placed(Invalid(maps, "overlap", a, b), rng)
    yield "common_face", placed(Invalid(maps, "overlap", b, a), rng)


def point_at(m, place):
    """The point of space and the derivatives of the map, by differences at nearby points: enough to choose rows."""
    def value(place):
        total, factors = [Q(0)] * 4, [folds.splines(t, p, x, span) for p, t, (x, span) in zip(m.degrees, m.knots, folds.place(m, place))]
        for index, q in m.all().items():
            f = factors[0][index[0]] * factors[1][index[1]] * factors[2][index[2]]
            total = [a + f * c for a, c in zip(total, q)]
        return [c / total[3] for c in total[:3]]
    base, rows = value(place), []
    for axis in range(3):
        near = [list(p) for p in place]
        k, t = near[axis]
        step = Q(1, 64) if t < HALF else -Q(1, 64)
        near[axis] = [k, Q(t) + step]
        rows.append([(b - a) / step for a, b in zip(base, value([tuple(p) for p in near]))])
    return base, rows


def fitting_rows(rows):
    """Rows Y with Y_i . row_j about 0 for i != j and positive for i = j, as integers."""
    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    found = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])]
    det = sum(a * b for a, b in zip(rows[0], found[0]))
    most = max(abs(c) for row in found for c in row) or 1
    return tuple(tuple(round(c / most * 1000) * (1 if det > 0 else -1) for c in row) for row in found)


def boxes_that_miss(rng):
    """Boxes near the point, in its cell and in another one, with the rows that fit there."""
    name, maps = some_valid(rng)
    for _ in range(3):
        cell = rng.randrange(len(maps))
        place = somewhere(maps[cell], rng)
        for other in (cell, rng.randrange(len(maps))):
            about = place if other == cell else somewhere(maps[other], rng)
            _, rows = point_at(maps[other], about)
            box = []
            for k, t in about:
                n = min(int(Q(t) * 16), 15)
                box.append((k, 4, max(0, n - rng.randint(0, 2)), min(16, n + rng.randint(1, 3))))
            if other == cell and rng.random() < .5:       # beside the point
                axis = rng.randrange(3)
                k, n = place[axis][0], min(int(Q(place[axis][1]) * 16), 15)
                box[axis] = (k, 4, n + 1, n + 2) if n < 14 else (k, 4, n - 2, n - 1)
            yield "box", placed(Invalid(maps, "overlap", (cell, place), (other, tuple(box)), fitting_rows(rows)), rng)


def corners(rng):
    name, maps = some_valid(rng)
    for _ in range(3):
        yield "corner", placed(Invalid(maps, "point-nonmanifold", rng.randrange(len(maps)), rng.randrange(8)), rng)


def arcs_with_one_curve(rng):
    name, maps = some_valid(rng)
    groups = list(models.sides_by_curve(maps).values())
    most = 2 if max(map(len, groups)) > 2 and rng.random() < .8 else 1
    groups = [arcs for arcs in groups if len(arcs) > most]
    for arcs in rng.sample(groups, min(3, len(groups))):
        three = rng.sample(arcs, 3) if len(arcs) > 2 and rng.random() < .8 else rng.choices(arcs, k=3)
        yield "arcs", placed(Invalid(maps, "curve-nonmanifold", *three), rng)
        cell, face, side, (k, *_) = three[0]
        yield "arcs_that_differ", placed(Invalid(maps, "curve-nonmanifold", (cell, face, side, some_interval(rng, k)), *three[1:]), rng)


def any_arcs(rng):
    name, maps = some_valid(rng)
    arcs = [a for arcs in models.sides_by_curve(maps).values() for a in arcs]
    yield "any_arcs", placed(Invalid(maps, "curve-nonmanifold", *rng.choices(arcs, k=3)), rng)


def findings_of_other_models(rng):
    """A true finding, told of a valid model, as it is or with other bytes."""
    true = rng.choice([f for f in models.made().values() if f.kind not in ("left-handed", "singular")])
    name, maps = some_valid(rng)
    for _ in range(3):
        body = Invalid(maps, true.kind, *true.parts).body()
        if rng.random() < .6:
            body = lies.bent_bytes(rng, body)
        if len(body) < 9 or body[8] not in (1, 2):
            yield "of_another_model", placed(Invalid(maps, true.kind, *true.parts), rng).changed(body=lambda body=body: body)


def cells_cut_too_late(rng):
    """Two cells have faces that collapse on one of two spans, where these cells and two others meet in a line: valid once cut there."""
    maps = varied_without_knots(valid.half_collapsed(), rng)
    places = [Invalid(maps, "point-nonmanifold", rng.randrange(4), rng.randrange(8))]
    for arcs in models.sides_by_curve(maps).values():
        if len(arcs) > 2:
            places.append(Invalid(maps, "curve-nonmanifold", *rng.sample(arcs, 3)))
    for lie in rng.sample(places, 3):
        yield "half_collapsed", placed(lie, rng)


def varied_without_knots(maps, rng):
    found = []
    for m in maps:
        axes, reverse = rng.sample(range(3), 3), [rng.randrange(2) for _ in range(3)]
        found.append(valid.permuted(m, axes, reverse))
    return found


# ---------------------------------------------------------------- invalid models: one thing is wrong

@functools.lru_cache(None)
def all_lies():
    return list(lies.lies())


def wrong_in_one_thing(rng):
    for what, condition, lie in rng.sample(all_lies(), 4):
        yield "lie_" + condition, placed(lie, rng)


def wrong_statements(rng):
    true = placed(rng.choice(list(models.made().values())), rng)
    for values in ({"cells": rng.randrange(9) + len(true.maps) + 1}, {"finding": rng.choice([k for k in KINDS if k != true.kind])},
                   {"cells": 0}):
        yield "statement", true.changed(values=values)


def unequal_copies(rng):
    """Two cells whose common face is not the same map of its parameters pass an edge; but the third arc is another one, or its faces are
    equal after all."""
    first, second = folds.cube(), models.unit_box(1, 0, 0)
    if rng.random() < .5:
        second = models.with_knot(valid.raised_cell(second, 0), rng.choice((1, 2)), Q(1, 3))
    second = valid.permuted(second, *((axes := rng.sample(range(3), 3)), [rng.randrange(2) for _ in axes]))
    maps = [first, second] + [models.unit_box(5, 0, 0)] * rng.randrange(2)
    for arcs in models.sides_by_curve(maps).values():
        if len(arcs) == 4:
            yield "equal_but_called_border", placed(Invalid(maps, "curve-nonmanifold", *rng.sample(arcs, 3)), rng)


def malformed(rng):
    true = placed(rng.choice(list(models.made().values())), rng)
    body = true.body()
    for n in rng.sample(range(len(body)), 2):
        yield "cut_off", true.changed(body=lambda n=n: body[:n])
    yield "too_long", true.changed(tail=b"\0")
    yield "count", true.changed(count=rng.choice((0, len(true.maps) + 1, (1 << 32) - 1)))
    yield "magic", true.changed(magic=rng.choice((b"VTVM", b"VTVF", b"vtvi")))


STRATEGIES = ((flat_cells, 4), (wrong_signs, 6), (points_in_two_places, 8), (points_of_a_common_face, 4), (boxes_that_miss, 10), (corners, 14),
              (arcs_with_one_curve, 12), (any_arcs, 2), (findings_of_other_models, 10), (cells_cut_too_late, 4), (wrong_in_one_thing, 14),
              (wrong_statements, 2), (unequal_copies, 6), (malformed, 1))


def invalid_cells_attacks(rng):
    """(name, model, certificate)"""
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    for name, lie in strategy(rng):
        model = lie.model()
        yield name, model, lie.certificate(model)


# ---------------------------------------------------------------- true findings

def octants(rng):
    """Boxes in two opposite octants, or in six without two opposite ones, or with two boxes that share an edge; of any sizes."""
    missing = rng.choice(((0, 7), (3, 4)))
    chosen = rng.choice(([o for o in range(8) if o not in missing], list(missing), [0, 3], [1, 2], [0, 1, 6]))
    sizes = [[Q(rng.randint(1, 8), 4) for _ in range(2)] for _ in range(3)]
    cells = []
    for o in chosen:
        ends = [sorted((0, sizes[a][o >> a & 1] * (1 if o >> a & 1 else -1))) for a in range(3)]
        cells.append(valid.box(*zip(*ends)))
    cells = varied(cells, rng)
    return Invalid(cells, "point-nonmanifold", *models.corner_at(cells, (0, 0, 0)))


def voxels_at_a_point(rng):
    while True:
        voxels, _, wrong = random_voxels(rng)
        if wrong:
            at, place = rng.choice([(n, p) for n, v in enumerate(voxels) for p in wrong if all(0 <= b - a <= 1 for a, b in zip(v, p))])
            cells = models.bent_voxels(voxels, rng)
            place = cells[at].at(*[b - a for a, b in zip(voxels[at], place)])
            cells = varied(cells, rng)
            return Invalid(cells, "point-nonmanifold", *models.corner_at(cells, place[:3]))


def honest(rng):
    """(name, model, certificate)"""
    r = rng.random()
    finding = placed(octants(rng) if r < .2 else voxels_at_a_point(rng) if r < .5 else rng.choice(list(models.made().values())), rng)
    yield finding.kind, finding.model(), finding.certificate()


class Run(vmodel_liars.Run):
    conditions, implied = CONDITIONS, {}

    @staticmethod
    def attacks(rng):
        return patch_attacks.subjects(invalid_cells_attacks(rng))

    @staticmethod
    def honest_certificates(rng):
        return patch_attacks.subjects(honest(rng))


def missing_conditions(alone):
    return vmodel_liars.missing_conditions(alone, CONDITIONS)


if __name__ == "__main__":
    sys.exit(vmodel_liars.main(sys.argv[1:], Run, "vmodel_invalid", CONDITIONS))
