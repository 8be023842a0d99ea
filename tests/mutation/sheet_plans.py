# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Copies, moves and unions of plans of version 2: tests only. Plans share what nobody changes in place: the shapes of entities, trees."""
import copy
from fractions import Fraction as Q

import patch_solids as ps
import star_box_2_models as models2
from patch_solids import forge


def made(name, make):
    """The plan that make() returns, made once in each process."""
    if name not in ps.MADE:
        ps.MADE[name] = make()
    return copied(ps.MADE[name])


def copied_box(box):
    new = copy.copy(box)
    new.lo, new.hi = list(box.lo), list(box.hi)
    new.centres, new.signs = [list(pair) for pair in box.centres], [list(s) for s in box.signs]
    new.separators = [[d, t, list(c)] for d, t, c in box.separators]
    return new


def copied(plan):
    """REQUIRES that nobody changes an entity, a tree, a centre or a breaks' axis in place: they are replaced."""
    new = copy.copy(plan)
    for name in ("entities", "flags", "kinds", "breaks", "roots", "trees", "walks", "frames"):
        setattr(new, name, list(getattr(plan, name)))
    new.boxes, new.values = [copied_box(box) for box in plan.boxes], dict(plan.values)
    return new


def encoded(plan):
    model = forge.encode_model(plan.entities)
    return model, plan.certificate(model)


def with_points(entity, change):
    """change: from the text of a point to that of another."""
    shape = entity["shape"]
    return dict(entity, shape=dict(shape, points=[change(p) for p in shape["points"]]))


def moved_points(plan, old, new):
    """Every control point of polynomial patches at `old` becomes `new`, so that sides stay glued."""
    old, text, result = [Q(c) for c in old], [str(c) for c in new], copied(plan)
    result.entities = [with_points(e, lambda p: text if [Q(c) for c in p] == old else p) for e in result.entities]
    return result


def shifted(plan, v):
    """The model and its boxes, moved by v in units of 2^E."""
    new, by = copied(plan), [Q(x, 1 << -plan.unit) for x in v]

    def moved(p):
        w = Q(p[3]) if len(p) > 3 else 1
        return [str(Q(c) + d * w) for c, d in zip(p, by)] + p[3:]
    new.entities = [with_points(e, moved) for e in new.entities]
    for box in new.boxes:
        d = models2.times(plan.frames[box.frame - 1], v) if box.frame else v
        box.lo, box.hi = [[x + y for x, y in zip(p, d)] for p in (box.lo, box.hi)]
        box.centres = [[[x + y for x, y in zip(c, v)] for c in pair] for pair in box.centres]
        box.shift = box.points_shift = None
    new.walks = [(b, s, [[x + y for x, y in zip(p, v)] for p in points], end) for b, s, points, end in new.walks]
    for box, before in zip(new.boxes, plan.boxes):        # separators count in units of the points: t follows
        for q in box.separators:
            q[1] += before.exponent() - box.exponent()
    return new


def joined(a, b):
    """Both models with the boxes that each has alone."""
    new, n = copied(a), len(a.boxes)
    for name in ("entities", "flags", "kinds", "breaks", "roots"):
        setattr(new, name, getattr(new, name) + getattr(b, name))
    new.boxes = new.boxes + [copied_box(box) for box in b.boxes]
    for box in new.boxes[n:]:
        box.frame = box.frame and box.frame + len(a.frames)
    new.frames = new.frames + list(b.frames)
    new.trees = new.trees + [[ps.shifted_tree(tree, n) for tree in trees] for trees in b.trees]
    new.walks = new.walks + [(box + n, sign, points, end if isinstance(end, int) else (end[0] + n, end[1])) for box, sign, points, end in b.walks]
    for key in ps.COUNTS + ("bodies",):
        new.values[key] += b.values[key]
    return new


def settled_walks(plan):
    """The statement's number of bodies follows the walks."""
    plan.values["bodies"] = sum(sign for _, sign, _, _ in plan.walks)
    return plan
