# SPDX-License-Identifier: Apache-2.0 OR MIT
"""V-models of which the claim is false by construction, with certificates in which all is right but what is named: tests only."""
import functools
from fractions import Fraction as Q
from itertools import product

import vmodel_forge as forge
import vmodel_models as models
from volume_folded_forge import bezier, cube

HALF = Q(1, 2)


def finished(plan, entries=None, **options):
    """The plan with the proof of X by a search, and with the entries that its determinants have."""
    plan.entries = forge.signs_of(plan) if entries is None else entries
    plan.x = forge.boundary(plan, **options)
    return plan.settled()


def faces_where(plan, condition):
    """The faces all of whose control points are so."""
    faces = forge.Faces(plan.maps, plan.added)
    return [f for f, net in enumerate(faces.nets) if all(condition(p) for p in net.values())]


# ---------------------------------------------------------------- V1

def cavity():
    """The frusta around a cube without it; their inner faces are said to be collapsed."""
    plan = forge.Plan(models.in_a_cube()[:6])
    plan.codes = forge.glued(forge.Faces(plan.maps, plan.added), plan.flags)
    for f in faces_where(plan, lambda p: max(map(abs, p[:3])) == 1):
        plan.codes[f] = 1
    return finished(plan)


def half_collapsed():
    """Two cells meet in the half of a face that is not collapsed; both faces are said to be."""
    plan = forge.Plan(models.half_collapsed())
    plan.codes = forge.glued(forge.Faces(plan.maps, plan.added), plan.flags)
    for f in faces_where(plan, lambda p: p[1] == 0 and 2 * abs(p[2]) <= p[3]):
        if f // 6 < 2:
            plan.codes[f] = 1
    return finished(plan)


def shrunk_arc():
    """An edge of pieces inside of a cell is one point; N is 0 on it, and positive elsewhere."""
    along, thirds, square = (-1, 0, 0, 0, 1), (0, Q(1, 6), HALF, Q(5, 6), 1), (Q(1, 4), -Q(1, 4), Q(1, 4))
    knots = [[0, 0, 0, Q(1, 3), Q(2, 3), 1, 1, 1], [0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1]]
    m = models.spline((2, 2, 2), knots, lambda i, j, k: (along[i] + thirds[i] * (square[j] + square[k]), Q(j, 2), Q(k, 2)))
    return finished(forge.Plan([m], added=[[[], [HALF], [HALF]]]))


# ---------------------------------------------------------------- V2

def folded(weight=0):
    """The middle control point is pulled out; the boundary is that of a cube."""
    middle = (HALF,) * 3
    m = bezier((2, 2, 2), lambda *p: (5, HALF, HALF) if p == middle else p)
    return finished(forge.Plan([models.weighted(m, 2) if weight else m]))


def folded_corner(place=Q(33, 50)):
    """Eight cells of a cube; their common corner is moved so far that N is negative at one corner of one cell."""
    cells = []
    for at in product((0, 1), repeat=3):
        def point(p, at=at):
            found = tuple(a + b for a, b in zip(at, p))
            return (place,) * 3 if found == (1, 1, 1) else found
        cells.append(cube(point))
    plan = forge.Plan(cells)
    plan.codes = forge.glued(forge.Faces(cells, plan.added), plan.flags)
    return finished(plan, {})


def double_pyramids(breaks=False):
    """Three double pyramids fill a cube: the middle of each is a point, where N is 0."""
    cells = [models.mapped(cube(lambda p: (2 * p[0] - 1, (2 * p[0] - 1) * (2 * p[1] - 1), (2 * p[0] - 1) * (2 * p[2] - 1))),
                           lambda p, axes=axes: tuple(p[a] for a in axes)) for axes in ((0, 1, 2), (2, 0, 1), (1, 2, 0))]
    plan = forge.Plan(cells, added=[[[HALF] if breaks else [], [], []]] * 3)
    plan.codes = forge.glued(forge.Faces(plan.maps, plan.added), plan.flags)
    return finished(plan, None if breaks else {n: ((), (0, forge.LEAF, forge.LEAF)) for n in range(3)})


def pinched_inside():
    """A face of pieces inside of a cell is a curve, though none of its edges is collapsed."""
    edge, places = (-Q(2, 3), 0, 0, 0, 0, Q(2, 3)), (-1, -Q(2, 3), 0, 1, Q(5, 3), 2)
    square = (1, -1, 1)
    knots = [[-1, -1, -1, 1, 1, 1], *[[-1] * 4 + [0, 1] + [2] * 4] * 2]

    def point(i, j, k):
        return i - 1, places[j] + places[k], (square[i] * (places[k] - places[j]) + edge[k] - edge[j]) / 3
    return finished(forge.Plan([models.spline((2, 3, 3), knots, point)], added=[[[0], [], []]]))


def turned_inner_cell():
    """A cell inside another, its flag set so that the boundary is that of a solid with a cavity."""
    inner = models.box((1, 1, 1), (2, 2, 2))
    return finished(forge.Plan([models.box((0, 0, 0), (3, 3, 3)), inner], [0, 1]), {})


# ---------------------------------------------------------------- V3

def cell_and_copies():
    """A cell, and two that are equal and glued along all their faces."""
    plan = forge.Plan([models.box((1, 1, 1), (2, 2, 2))] * 2 + [cube()])
    for f in range(6):
        plan.codes[f], plan.codes[6 + f] = (6 + f, 0), 2
    return finished(plan, {})


def named_twice():
    """A cell inside of others is there twice; both name the same faces."""
    cells = models.in_a_cube()
    plan = forge.Plan([cells[6], cells[6]] + cells[:6])
    plan.codes = forge.glued(forge.Faces(plan.maps, plan.added), plan.flags, range(6))
    for f in range(6):
        plan.codes[f] = plan.codes[6 + f]
    return finished(plan, {})


def one_ulp():
    """A cell inside of others has moved a corner by 2^-52."""
    cells = models.in_a_cube()
    codes = forge.glued(forge.Faces(cells, [[[], [], []]] * 7), [0] * 7)
    m = cells[6]
    cells[6] = models.texts.Map(m.degrees, m.knots, [p if p != (1, 1, 1) else (1 + Q(1, 1 << 52), 1, 1) for p in m.points])
    plan = forge.Plan(cells)
    plan.codes = codes
    return finished(plan, {})


def nobody_names():
    """The frusta around a cube without it; their inner faces are said to be glued."""
    plan = cavity()
    plan.codes = [2 if code == 1 else code for code in plan.codes]
    return plan.settled()


# ---------------------------------------------------------------- X

def nested(flags=(0,) * 12, **options):
    """A cell inside another."""
    plan = forge.Plan([models.box((0, 0, 0), (3, 3, 3)), models.box((1, 1, 1), (2, 2, 2))])
    plan.entries = {}
    plan.x = forge.ProverOfX(forge.entities_of_x(plan), forge.breaks_of_x(plan), flags=list(flags), **options).prove().plan
    return plan.settled()


def turned_in_x():
    """A cell inside another; the flags of its faces in X are set."""
    return nested([0] * 6 + [1] * 6)


def beside(a, b):
    """Two models in one file; each has the proof that it has alone."""
    return forge.together(a, b)


def moved_box(shift, sizes=(1, 1, 1)):
    return forge.proved([models.box(shift, tuple(a + b for a, b in zip(shift, sizes)))])


def not_a_cavity():
    """A cell inside another. The walk of the inner one ends inside the outer one."""
    plan = beside(moved_box((0, 0, 0), (9, 9, 9)), moved_box((4, 4, 4)))
    inner, outer = plan.x.walks[1], plan.x.walks[0]
    plan.x.walks[1] = (inner[0], 1, [], (outer[0], 0))
    return plan.settled()


def through_the_wall():
    """A cell inside another. The walk of each goes to infinity."""
    return beside(moved_box((0, 0, 0), (9, 9, 9)), moved_box((4, 4, 4)))


# name: (model, what rejects it)
FALSE = {
    "cavity": (cavity, "V1"),
    "half collapsed": (half_collapsed, "V1"),
    "shrunk arc": (shrunk_arc, "V1"),
    "folded": (folded, "V2"),
    "folded, rational": (lambda: folded(2), "V2"),
    "folded at a corner": (folded_corner, "V2"),
    "double pyramids": (double_pyramids, "V2"),
    "pinched inside": (pinched_inside, "V2"),
    "turned inner cell": (turned_inner_cell, "V2"),
    "cell and copies": (cell_and_copies, "V3"),
    "named twice": (named_twice, "V3"),
    "one ulp": (one_ulp, "V3"),
    "nobody names": (nobody_names, "V3"),
    "turned in X": (turned_in_x, "V4"),
    "crossing cells": (lambda: beside(models.honest("cube"), moved_box((HALF,) * 3)), "C2"),
    "cells that meet in a part of a face": (lambda: beside(models.honest("cube"), moved_box((1, HALF, 0))), "C2"),
    "cells that meet in a part of an edge": (lambda: beside(models.honest("cube"), moved_box((1, 1, HALF))), "C2"),
    "cells that meet in an edge": (lambda: beside(models.honest("cube"), moved_box((1, 1, 0))), "P1"),
    "cells that meet in a corner": (lambda: beside(models.honest("cube"), moved_box((1, 1, 1))), "C2"),
    "two cells in one place": (lambda: beside(models.honest("cube"), models.honest("cube")), "P1"),
    "two cells nearly in one place": (lambda: beside(models.honest("cube"), moved_box((Q(1, 1024),) * 3)), "C3"),
    "not a cavity": (not_a_cavity, "W2"),
    "through the wall": (through_the_wall, "W1"),
}

# Other conditions reject these, too.
NOT_ALONE = {"crossing cells", "cells that meet in a part of an edge", "cells that meet in an edge", "cells that meet in a corner",
             "two cells in one place"}


@functools.lru_cache(None)
def made(name):
    return FALSE[name][0]()


def false(name):
    """(plan, condition)"""
    return made(name).changed(), FALSE[name][1]
