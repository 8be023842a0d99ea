# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lies of version 2: each takes the plan of a certificate, and yields plans in which one thing is another one."""
from fractions import Fraction as Q

import patch_liars
import patch_solids as ps
import star_box_2_forge as forge2
from patch_solids import UNIT
from sheet_plans import copied, copied_box, settled_walks


def plain(plan, rng):
    yield copied(plan)


def stars(plan, least=1):
    return [box for box in plan.boxes if len(box.centres) >= least]


def moved_o(box, centres):
    """Other centres; the separators of degree 1 are written from the new first point, so that they stay the same planes."""
    old, before = box.centres[0][0], box.exponent()
    box.centres, box.points_shift = centres, None
    new, by = centres[0][0], before - box.exponent()
    for q in box.separators:
        q[1] += by
        if q[0] == 1 and new != old:
            d = box.exponent() + q[1]
            shift = sum(q[2][1 + k] * (new[2 - k] - old[2 - k]) for k in range(3))
            q[2] = [(q[2][0] << d) + shift, *[c << d for c in q[2][1:]]] if d > 0 else [q[2][0] + (shift << -d), *q[2][1:]]


# ---------------------------------------------------------------- frames

def singular_frames(plan, rng):
    """A row that is 0, twice there, or the sum of the others."""
    for way in range(3 if plan.frames else 0):
        new = copied(plan)
        a, b, _ = rng.sample(new.frames[0], 3)
        new.frames[0] = (a, b, ((0, 0, 0), a, tuple(x + y for x, y in zip(a, b)))[way])
        yield new


def swapped_frames(plan, rng):
    """Rows exchanged, bounds not; boxes in another frame of the table, or in none."""
    if plan.frames:
        new = copied(plan)
        new.frames[0] = tuple(new.frames[0][::-1]) if rng.random() < .5 else tuple(new.frames[0][1:] + new.frames[0][:1])
        yield new
        new = copied(plan)
        new.frames.append(tuple(tuple(rng.randint(-9, 9) for _ in range(3)) for _ in range(3)))
        for box in rng.sample(new.boxes, rng.randint(1, len(new.boxes))):
            box.frame = rng.choice((0, 2))
        yield new


def mirrored_frames(plan, rng):
    """A row turned over, bounds with it: the same box. Centres exchanged, as if the frame turned the pieces over."""
    for way in range(3):
        new, k = copied(plan), rng.randrange(3)
        frame = [list(row) for row in new.frames[0]] if new.frames else [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        frame[k] = [-x for x in frame[k]]
        new.frames = [tuple(map(tuple, frame)), *new.frames[1:]]
        for box in new.boxes:
            box.frame = box.frame or 1
            if way < 2 and box.frame == 1:
                box.lo[k], box.hi[k] = -box.hi[k], -box.lo[k]
            if way == 1 and box.centres:
                moved_o(box, [pair[::-1] for pair in box.centres])
        yield new


def sheared_frames(plan, rng):
    if plan.frames:
        new = copied(plan)
        rows = [list(r) for r in new.frames[0]]
        rows[rng.randrange(3)][rng.randrange(3)] += rng.choice((1, -1, 1 << 20))
        new.frames[0] = tuple(map(tuple, rows))
        yield new


# ---------------------------------------------------------------- sheets

def equal_signs(plan, rng):
    """Two sheets on one side of all separators; of none."""
    for way in range(2):
        new = copied(plan)
        for box in stars(new, 2):
            i, j = rng.sample(range(len(box.signs)), 2)
            box.signs[i] = list(box.signs[j]) if way else [0] * len(box.separators)
        yield new


def other_signs(plan, rng):
    for way in range(2):
        new = copied(plan)
        for box in stars(new, 2):
            box.signs = [[3 - s if s else 0 for s in signs] if way else [rng.randint(0, 2) for _ in signs] for signs in box.signs]
        yield new


def merged_sheets(plan, rng):
    """One sheet for what are several, with the centres of one, or from below all to above all; two of several."""
    for way in range(4):
        new = copied(plan)
        for box in stars(new, 2):
            if way == 3:
                i = rng.randrange(len(box.centres))
                del box.signs[i]
                moved_o(box, box.centres[:i] + box.centres[i + 1:])
                if len(box.centres) > 1:
                    continue
            centres = [box.centres[-(way % 2)]] if way != 2 else [[box.centres[0][0], box.centres[-1][1]]]
            box.centres, box.separators, box.signs, box.points_shift = centres, [], [[]], None
        yield new


def merged_by_component(plan, rng):
    """As merged_sheets, with a copy of the box for the leaves of each component."""
    new, way = copied(plan), rng.randint(0, 1)
    owners, copies = [patch.component for patch in ps.reader(copied(plan)).patches], {}
    if max(owners) == 0:
        return
    for n, box in enumerate(plan.boxes):
        if len(box.centres) > 1:
            for owner in set(owners):
                copies[n, owner] = len(new.boxes) if owner else n
                one = new.boxes[n]
                one.centres, one.separators, one.signs, one.points_shift = [box.centres[-way]], [], [[]], None
                new.boxes += [copied_box(one)] if owner else []
    new.trees = [[patch_liars.renamed(t, lambda n: copies.get((n, owner), n)) for t in trees] for owner, trees in zip(owners, new.trees)]
    yield new


def split_sheets(plan, rng):
    """A sheet more, on a side of a plane or with the centres of another."""
    new = copied(plan)
    for box in stars(new):
        pair, k, c = rng.choice(box.centres), rng.randrange(3), rng.randint(-1, 1)
        box.centres = [*box.centres, pair if rng.random() < .5 else pair[::-1]]
        box.separators = [*box.separators, [1, 20, [c, *[int(j == k) for j in range(3)]]]]
        box.signs = [[*s, 1] for s in box.signs] + [[0] * (len(box.separators) - 1) + [2]]
    yield new


def exchanged_centres(plan, rng):
    """Between sheets, c- with c+, any; the separators stay where they are."""
    for way in range(4):
        new = copied(plan)
        for box in stars(new):
            pairs = box.centres
            if way == 0:
                centres = [pair[::-1] for pair in pairs]
            elif way == 1:
                centres = pairs[1:] + pairs[:1]
            elif way == 2:
                points = [c for pair in pairs for c in pair]
                centres = [[rng.choice(points), rng.choice(points)] for _ in pairs]
            else:                                         # all sheets by those of one
                centres = [rng.choice(pairs)] * len(pairs)
            moved_o(box, centres)
        yield new


# ---------------------------------------------------------------- separators

def wrong_coefficients(plan, rng):
    """One coefficient of one separator is 0, or has another sign, or is off by one."""
    for way in range(3):
        new = copied(plan)
        for box in stars(new, 2):
            q = rng.choice(box.separators)
            at = rng.choice([i for i, c in enumerate(q[2]) if c] or [0])
            q[2][at] = (0, -q[2][at], q[2][at] + rng.choice((-1, 1)))[way]
        yield new


def zero_on_a_sheet(plan, rng):
    """Separators moved until they meet a sheet: the constant coefficient scaled, and the unit of y another one."""
    new = copied(plan)
    for box in stars(new, 2):
        q = rng.choice(box.separators)
        if rng.random() < .5:
            q[2][0] = q[2][0] * rng.choice((1, 2, 3)) // rng.choice((1, 2, 4))
        else:
            q[1] += rng.choice((-1, 1))
    yield new


def through_a_vertex(plan, rng):
    """Planes moved until they go through a control point of the model: a point where two bodies touch, for example."""
    new = copied(plan)
    for box in stars(new, 2):
        for q in box.separators:
            points = rng.choice(plan.entities)["shape"]["points"]
            y = [(Q(c) * 2 ** -plan.unit - o) / Q(2) ** (box.exponent() + q[1]) for c, o in zip(rng.choice(points), box.centres[0][0])]
            if q[0] == 1:
                value = sum(c * t for c, t in zip(q[2][1:], y[::-1]))
                q[2] = [int(-value * value.denominator), *[c * value.denominator for c in q[2][1:]]]
    yield new


def separators_of_others(plan, rng):
    """Those of another pair of sheets, of another box, one for all."""
    for way in range(3):
        new = copied(plan)
        boxes = stars(new, 2)
        for box in boxes:
            if way == 0:
                box.separators = rng.sample(box.separators, len(box.separators))
            elif way == 1:
                box.separators = [rng.choice(rng.choice(boxes).separators) for _ in box.separators]
            else:
                box.separators = [box.separators[0]] * len(box.separators)
        yield new


def random_separators(plan, rng):
    """Separators have any degree and go through anything; the sheets have different signs."""
    new, degree = copied(plan), rng.choice((1, 2, 3))
    for box in stars(new, 2):
        n, size = len(box.centres), len(forge2.powers(degree))
        box.separators = [[degree, rng.randint(-2, 30), [rng.choice((0, 0, 1, -1, rng.randint(-1000, 1000))) for _ in range(size)]] for _ in range(n)]
        box.signs = [[1 if i == j else 2 for i in range(n)] for j in range(n)]
    yield new


# ---------------------------------------------------------------- boxes, leaves

def other_boxes(plan, rng):
    """Boxes that reach farther, or less far; all mesh boxes, but where walks start."""
    for way in range(3):
        new, starts = copied(plan), {w[0] for w in plan.walks}
        for i, box in enumerate(new.boxes):
            if way == 2 and i not in starts:
                box.kind, box.centres, box.separators, box.signs = 1, [], [], []
            elif way < 2:
                k, part = rng.randrange(3), rng.choice((2, 8, 64))
                change = (box.hi[k] - box.lo[k]) // part * (1 if way else -1)
                box.lo[k], box.hi[k] = box.lo[k] - change // 2, box.hi[k] + change // 2
        yield new


def reaching_boxes(plan, rng):
    """Mesh boxes that contain whatever was moved, and more than their component."""
    new = copied(plan)
    for box in new.boxes:
        if box.kind:
            by = [(h - l) * rng.choice((0, 1, 8)) for l, h in zip(box.lo, box.hi)]
            box.lo, box.hi, box.shift = [l - d for l, d in zip(box.lo, by)], [h + d for h, d in zip(box.hi, by)], None
    yield new


def boxes_elsewhere(plan, rng):
    """All boxes but those where walks start are mesh boxes where nothing is."""
    new, starts = copied(plan), {w[0] for w in plan.walks}
    for i, box in enumerate(new.boxes):
        if i not in starts:
            box.kind, box.centres, box.separators, box.signs, box.frame = 1, [], [], [], 0
            box.lo, box.hi, box.shift = [-1000 * UNIT] * 3, [-999 * UNIT] * 3, None
    yield new


def shrunk_boxes(plan, rng):
    """Boxes cut down around their first centres, so that other sheets are not in them."""
    new = copied(plan)
    for box in stars(new):
        k, part = rng.randrange(3), rng.choice((4, 64, 1 << 12))
        rows = new.frames[box.frame - 1] if box.frame else ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        ends = [sum(a * x for a, x in zip(rows[k], c)) for c in box.centres[0]]
        d = 1 + (box.hi[k] - box.lo[k]) // part
        box.lo[k], box.hi[k], box.shift = max(box.lo[k], min(ends) - d), min(box.hi[k], max(ends) + d), None
    yield new


def other_leaves(plan, rng):
    """Leaves that name other boxes; boxes that no leaf names stay."""
    for share in (.1, 1):
        new, target = copied(plan), rng.randrange(len(plan.boxes))
        new.trees = [[patch_liars.renamed(t, lambda n: target if rng.random() < share else n) for t in trees] for trees in new.trees]
        yield new


def untested_leaves(plan, rng):
    """The leaves of boxes with several sheets name mesh boxes, or the reverse; the boxes stay, or go."""
    new = copied(plan)
    shared = {i for i, box in enumerate(plan.boxes) if len(box.centres) > 1}
    meshes = [i for i, box in enumerate(plan.boxes) if box.kind]
    if shared and meshes:
        new.trees = [[patch_liars.renamed(t, lambda n: rng.choice(meshes) if n in shared else n) for t in trees] for trees in new.trees]
        if rng.random() < .7:
            keep = [i for i in range(len(new.boxes)) if i not in shared]
            number = {n: i for i, n in enumerate(keep)}
            new.boxes = [new.boxes[i] for i in keep]
            new.trees = [[patch_liars.renamed(t, number.__getitem__) for t in trees] for trees in new.trees]
            new.walks = [(number.get(b, 0), s, p, e if isinstance(e, int) else (number.get(e[0], 0), e[1])) for b, s, p, e in new.walks]
        yield new


# ---------------------------------------------------------------- walks

def other_walks(plan, rng):
    """From, or to, boxes with several sheets or mesh boxes, at either sign."""
    for _ in range(4):
        new = copied(plan)
        new.walks = [(rng.choice((b, rng.randrange(len(new.boxes)))), rng.randint(0, 1), points,
                      end if isinstance(end, int) and rng.random() < .5 else (rng.randrange(len(new.boxes)), rng.randint(0, 1)))
                     for b, _, points, end in new.walks]
        yield settled_walks(new)


def walks_from_shared_boxes(plan, rng):
    """Each walk starts, or ends, at a box with several sheets, at one of the first sheet's centres."""
    shared = [i for i, box in enumerate(plan.boxes) if len(box.centres) > 1]
    if shared:
        for at_end in (False, True):
            new = copied(plan)
            i = rng.randrange(len(new.walks))
            box, sign, points, end = new.walks[i]
            there = rng.choice(shared), rng.randint(0, 1)
            new.walks[i] = (box, sign, points[:-1], there) if at_end else (*there, points, end)
            yield settled_walks(new)


def walks_from_unnamed_boxes(plan, rng):
    """A copy of a star box that no leaf names is where another component's walk starts."""
    ones = [w[0] for w in plan.walks]
    if len(ones) > 1:
        new = copied(plan)
        i, j = rng.sample(range(len(ones)), 2)
        new.boxes.append(copied(plan).boxes[ones[i]])
        new.walks[j] = (len(new.boxes) - 1, *plan.walks[i][1:])
        new.walks = [new.walks[i], *[w for n, w in enumerate(new.walks) if n != i]]
        yield settled_walks(new)


def walks_of_others(plan, rng):
    """The walk of one component comes for two; the boxes of one are named by leaves of the other."""
    ones = [w[0] for w in plan.walks]
    if len(ones) > 1:
        new = copied(plan)
        i, j = rng.sample(range(len(ones)), 2)
        if rng.random() < .5:
            new.walks[j] = new.walks[i]
        else:
            swap = {ones[i]: ones[j], ones[j]: ones[i]}
            new.trees = [[patch_liars.renamed(t, lambda n: swap.get(n, n)) for t in trees] for trees in new.trees]
        yield settled_walks(new)


def missing_walks(plan, rng):
    """A component has no walk, or one from its box to itself."""
    for way in range(3):
        new, i = copied(plan), rng.randrange(len(plan.walks))
        box, sign, _, _ = new.walks[i]
        sign = rng.choice((0, sign))
        new.walks[i:i + 1] = [] if way == 0 else [(box, sign, [], (box, sign))]
        yield settled_walks(new)


def wrong_numbers(plan, rng):
    for key in rng.sample(("patches", "edges", "vertices", "shells", "bodies", "genus"), 2):
        new = copied(plan)
        new.values[key] = abs(new.values[key] + rng.choice((1, -1, 2, 1 << 62)))
        yield new


def said_to_be_turned(plan, rng):
    """Only a model without flags could be."""
    new = copied(plan)
    new.values.update(claim="star-box-turned-2", bodies=0, winding=rng.choice((0, 1, 4)))
    if any(new.flags):
        yield new


def far_walks(plan, rng):
    """Walks that go round, or nowhere."""
    new = copied(plan)
    new.walks = [(b, rng.randint(0, 1), [[rng.randint(-50, 50) * UNIT for _ in range(3)] for _ in range(rng.randint(0, 2))], rng.randrange(6))
                 for b, _, _, _ in new.walks]
    yield settled_walks(new)


LIES = (plain, singular_frames, swapped_frames, mirrored_frames, sheared_frames, equal_signs, other_signs, merged_sheets, merged_by_component,
        split_sheets, exchanged_centres, wrong_coefficients, zero_on_a_sheet, through_a_vertex, separators_of_others, random_separators,
        other_boxes, reaching_boxes, boxes_elsewhere, shrunk_boxes, other_leaves, untested_leaves, other_walks, walks_from_shared_boxes,
        walks_from_unnamed_boxes, walks_of_others, missing_walks, wrong_numbers, said_to_be_turned, far_walks)
