# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of vmodel-invalid-1 of which all is right but what is named: tests only. Each is accepted without the condition."""
import itertools
from fractions import Fraction as Q

import star_box_forge as forge
import vmodel_invalid_models as models
import vmodel_models as valid
from vmodel_invalid_forge import WHOLE, Invalid
from vmodel_invalid_models import HALF, IDENTITY, arc, at
from volume_folded_forge import bezier, cube

FIRST_HALF, LAST_HALF = (0, 1, 0, 1), (0, 1, 1, 2)


def turned_about(y):
    return y[1:] + y[:1]


def negated(y):
    return tuple(tuple(-c for c in row) for row in y)


def lies():
    """(what is wrong, the condition that rejects it, Invalid)"""
    box = models.honest("overlapping cubes, a box")
    irrational = models.honest("no rational parameters")
    spiral = models.honest("a spiral at a knot")
    edge = models.honest("two cubes at an edge")
    (a, b, c), two = edge.parts, [cube(), models.unit_box(1, 0, 0)]
    wedge = cube(lambda p: (p[0], p[0] * p[1], p[2]))
    high = bezier((16, 1, 1), lambda u, v, w: (-u, v, w))
    yield "degree 16", "B2", Invalid([high], "left-handed", at(0, HALF, HALF, HALF))
    yield "degree 16 of another cell", "B2", Invalid(edge.maps + [high], edge.kind, *edge.parts)
    for name in ("a mirrored cube", "a wedge at its edge", "a flat cell", "two cubes at a corner"):
        true = models.honest(name)
        yield "another number of cells", "B3", true.changed(values={"cells": len(true.maps) + 1})
        yield "another finding", "B3", true.changed(values={"finding": "overlap"})
    for cell in (cube(), valid.weighted(cube(), 3), wedge):
        yield "no flat cell", "F1", Invalid([cell], "flat", 0, (0, 0, 0))
    for span in (0, 2):
        yield "no flat span", "F1", Invalid([models.flat_span()], "flat", 0, (0, 0, span))
    yield "right-handed", "H1", Invalid([cube()], "left-handed", at(0, HALF, HALF, HALF))
    yield "another cell", "H1", models.honest("a mirrored cube at its corner").changed(parts=(at(0, 0, 1, 0),))
    yield "zero, not negative", "H1", Invalid([wedge], "left-handed", at(0, 0, HALF, HALF))
    yield "forward at the end", "H1", models.honest("backward in the middle").changed(parts=(at(0, 1, HALF, HALF),))
    yield "a hair from the edge", "Z1", Invalid([wedge], "singular", at(0, Q(1, 1 << 60), HALF, HALF))
    yield "negative, not zero", "Z1", models.honest("a mirrored cube").changed(kind="singular", number=2)
    yield "the flat span's begin from the other side", "Z1", Invalid([models.flat_span()], "singular", (0, ((0, 0), (0, 0), (0, 1))))
    for axis, end in itertools.product(range(3), (0, 1)):
        numbers = [Q(1, 3)] * 3
        numbers[axis] = end
        where = [0, 0, 0]
        where[axis] = 2 * end - 1
        across = list(numbers)
        across[axis] = 1 - end
        yield "A on a face", "O1", Invalid([cube(), models.unit_box(*where)], "overlap", at(0, *numbers), at(1, *across))
    yield "A at the last knot", "O1", Invalid([models.spiral(), models.unit_box(0, 0, 1)], "overlap", (0, ((0, HALF), (0, HALF), (0, 1))),
                                              (0, ((4, HALF), (0, HALF), (0, 1))))
    yield "A is B", "O2", Invalid([cube()], "overlap", at(0, HALF, HALF, HALF), at(0, HALF, HALF, HALF))
    yield "A is B in other terms", "O2", Invalid([cube()], "overlap", at(0, HALF, HALF, HALF), at(0, (2, 4), (3, 6), HALF))
    yield "a knot from both sides", "O2", spiral.changed(parts=((0, ((0, 1), (0, HALF), (0, HALF))), (0, ((1, 0), (0, HALF), (0, HALF)))))
    for middle in (Q(1, 2), Q(1, 4), Q(1, 8)):
        yield "the box holds A", "O2", Invalid([cube()], "overlap", at(0, middle, HALF, HALF), (0, (WHOLE,) * 3), IDENTITY)
    yield "an ulp away", "O3", models.honest("overlapping cubes").changed(parts=(at(0, *[Q(3, 4)] * 3), at(1, Q(1, 4), Q(1, 4), Q(1, 4) + Q(1, 1 << 52))))
    for axis in range(3):
        numbers = [Q(1, 4)] * 3
        numbers[axis] = Q(1, 3)
        yield "another coordinate", "O3", models.honest("overlapping cubes").changed(parts=(at(0, *[Q(3, 4)] * 3), at(1, *numbers)))
    yield "opposite of the origin", "O3", Invalid([valid.mapped(cube(), lambda p: tuple(c - 2 for c in p)), models.unit_box(1, 1, 1)], "overlap",
                                                  at(0, HALF, HALF, HALF), at(1, HALF, HALF, HALF))
    for true in (box, irrational):
        p, q, y = true.parts
        for other in (turned_about(y), negated(y), (y[0], y[1], (0, 0, 0)), (y[0], y[0], y[2]), (y[1], y[0], y[2])):
            yield "other rows", "O4", true.changed(parts=(p, q, other))
    for axis, part in itertools.product(range(3), (LAST_HALF, (0, 3, 0, 1))):
        parts = [FIRST_HALF] * 3
        parts[axis] = part
        yield "a box beside the point", "O4", box.changed(parts=(box.parts[0], (1, tuple(parts)), IDENTITY))
        parts[axis] = (0, 2, 1, 2) if part == LAST_HALF else (0, 2, 0, 1)
        yield "the point is on a face of the box", "O4", box.changed(parts=(box.parts[0], (1, tuple(parts)), IDENTITY))
    for arcs in ((a, b, b), (a, a, c), (c, b, c)):
        yield "an arc twice", "C1", edge.changed(parts=arcs)
    yield "overlapping arcs", "C1", Invalid([models.there_and_back()], "curve-nonmanifold", arc(0, 1, 3, (0, 2, 0, 3)),
                                            arc(0, 1, 3, (0, 2, 1, 4)), arc(0, 3, 3, (0, 2, 0, 3)))
    yield "another arc", "C2", edge.changed(parts=(a, b, arc(1, 0, 3)))
    for part in (FIRST_HALF, LAST_HALF):
        yield "a part of the arc", "C2", edge.changed(parts=(a, b, arc(1, 0, 2, part)))
        yield "parts of the arc", "C2", edge.changed(parts=((*a[:3], part), (*b[:3], part), c))
    apexes = [arc(0, 2, 2), arc(0, 3, 2), arc(0, 4, 2)]
    yield "points", "C2", Invalid(models.two_pyramids(), "curve-nonmanifold", *apexes)
    glued = two[0], two[1], models.unit_box(0, 5, 0)
    yield "a glued face", "C3", Invalid(list(glued), "curve-nonmanifold", arc(0, 1, 2), arc(0, 2, 3), arc(1, 2, 2))
    yield "a glued face, the last", "C3", Invalid(list(glued), "curve-nonmanifold", arc(0, 2, 3), arc(1, 2, 2), arc(1, 0, 2))
    yield "a collapsed face", "C3", Invalid([wedge], "curve-nonmanifold", arc(0, 0, 2), arc(0, 2, 2), arc(0, 3, 2))
    yield "a side of a ring twice", "C3", Invalid([valid.closed_frame()], "curve-nonmanifold", arc(0, 3, 2), arc(0, 3, 3), arc(0, 0, 3))
    partly = models.partly_collapsed()
    yield "a face that is partly collapsed, and its sides", "V1", Invalid(partly, "curve-nonmanifold", arc(0, 2, 0), arc(0, 2, 1), arc(1, 2, 0))
    yield "a face that is partly collapsed, and its corner", "V1", Invalid(partly, "point-nonmanifold", 0, 0)
    beside = cube(lambda p: tuple(1 + sum(c * x for c, x in zip(row, p)) for row in ((2, 1, 1), (-1, -2, -1), (1, 1, 2))))
    for cell, corner in ((0, 7), (3, 0), (4, 0)):
        yield "three copies", "P1", Invalid([cube()] * 3 + [models.unit_box(1, 1, 1), beside], "point-nonmanifold", cell, corner)
    for name, maps in models.valid_models().items():
        yield "a corner of %s" % name, "P2", Invalid(maps, "point-nonmanifold", 0, 0)


def bent_bytes(rng, body):
    """The body with a few other bytes. A short one keeps its length."""
    if len(body) > 30:
        return forge.bent(rng, body)
    n = rng.randrange(9, len(body))
    return body[:n] + bytes([rng.choice((0, 1, 2, 7, 127, 128, 255))]) + body[n + 1:]
