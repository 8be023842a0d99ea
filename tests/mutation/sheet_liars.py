# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claims star-box-2 and star-box-turned-2: thin plates and spheres that cross, touch or are inside out, with frames, sheets
and separators that are right for their parts; and the lies of version 1 in the form of version 2."""
import copy
from fractions import Fraction as Q

import patch_liars
import patch_solids as ps
import star_box_2_forge as forge2
import star_box_2_models as models2
from patch_solids import UNIT, forge

CLAIMS = {"star-box-1": "star-box-2", "star-box-turned-1": "star-box-turned-2"}
GAPS = [Q(1, 16), Q(1, 64), Q(1, 1 << 10)]


def made(name, make):
    """The plan of a proof, made once in each process. REQUIRES that nobody changes it: copied() does not."""
    if name not in ps.MADE:
        ps.MADE[name] = make().plan
    return copied(ps.MADE[name])


def copied(plan):
    new = copy.copy(plan)
    for name in ("entities", "flags", "kinds", "breaks", "roots", "boxes", "trees", "walks", "values", "frames"):
        setattr(new, name, copy.deepcopy(getattr(plan, name)))
    return new


def encoded(plan):
    model = forge.encode_model(plan.entities)
    return model, plan.certificate(model)


# ---------------------------------------------------------------- sound models

def plate(rng):
    gap, turned = rng.choice(GAPS), rng.random() < .7
    return gap, turned, made("plate %s %s" % (gap, turned), lambda: models2.proved_plate(gap, turned))


def shell(rng):
    gap = Q(1, 1 << rng.choice((6, 12)))
    return made("shell %s" % gap, lambda: models2.proved_shell(gap))


def blocks(rng):
    return made("blocks", lambda: models2.star_and_mesh(models2.blocks()).prove())


def squircle(rng):
    return made("squircle", lambda: forge2.Prover2(models2.prism(models2.squircle), search=True).prove())


def sound(rng):
    return plate(rng)[2] if rng.random() < .7 else rng.choice((blocks, squircle))(rng)


def of_version_1(plan):
    """The plan in version 2; None if it has a box that cannot be read."""
    try:
        new = forge2.to_version_2(plan)
    except forge2.Reject:
        return None
    if "claim" in new.values:
        new.values["claim"] = CLAIMS[new.values["claim"]]
    return new


def shifted(plan, v):
    """The model and its boxes, moved by v in units of 2^E."""
    new, by = copied(plan), [Q(x, 1 << -plan.unit) for x in v]
    for e in new.entities:
        w = e["shape"]["rational"]
        e["shape"]["points"] = [[str(Q(c) + d * (Q(p[3]) if w else 1)) for c, d in zip(p, by)] + p[3:] for p in e["shape"]["points"]]
    for box in new.boxes:
        d = models2.times(plan.frames[box.frame - 1], v) if box.frame else v
        box.lo, box.hi = [[x + y for x, y in zip(p, d)] for p in (box.lo, box.hi)]
        box.centres = [[[x + y for x, y in zip(c, v)] for c in pair] for pair in box.centres]
        box.shift = box.points_shift = None
    new.walks = [(b, s, [[x + y for x, y in zip(p, v)] for p in points], end) for b, s, points, end in new.walks]
    return settled(new, plan)


def settled(plan, old):
    """Separators count from the first point in units of the points: t follows if that unit changed."""
    for box, before in zip(plan.boxes, old.boxes):
        for q in box.separators:
            q[1] += before.exponent() - box.exponent()
    return plan


def joined(a, b):
    """Both models with the boxes that each has alone."""
    new, n = copied(a), len(a.boxes)
    for name in ("entities", "flags", "kinds", "breaks", "roots", "boxes"):
        setattr(new, name, getattr(new, name) + copy.deepcopy(getattr(b, name)))
    for box in new.boxes[n:]:
        box.frame = box.frame and box.frame + len(a.frames)
    new.frames = new.frames + list(b.frames)
    new.trees += [[ps.shifted_tree(tree, n) for tree in trees] for trees in b.trees]
    new.walks += [(box + n, sign, points, end if isinstance(end, int) else (end[0] + n, end[1])) for box, sign, points, end in b.walks]
    for key in ps.COUNTS + ("bodies",):
        new.values[key] += b.values[key]
    return new


# ---------------------------------------------------------------- false models: (plan, why)

def pulled_through(rng):
    """A corner of one wall of a plate beyond the other wall."""
    gap, turned, plan = plate(rng)
    corner = (rng.randint(0, 1), rng.randint(0, 1), gap)
    to = models2.Setting(turned).point
    old, new = (list(map(str, to(p))) for p in (corner, (*corner[:2], -gap * rng.choice((Q(1, 8), 1, 3)))))
    old = list(map(Q, old))
    for e in plan.entities:
        e["shape"]["points"] = [new if list(map(Q, p)) == old else p for p in e["shape"]["points"]]
    return plan, "two walls cross"


def two_that_cross(rng):
    """A plate, and itself moved by less than its thickness."""
    gap, turned, plan = plate(rng)
    part = Q(rng.randint(1, 7), 8)
    v = models2.Setting(turned).point((rng.choice((0, Q(1, 4))), Q(1, 8), gap * part))
    return joined(plan, shifted(plan, [int(x * UNIT) for x in v])), "two plates cross"


def two_that_touch(rng):
    gap, turned, plan = plate(rng)
    v = models2.Setting(turned).point((0, Q(rng.randint(0, 4), 8), gap))
    return joined(plan, shifted(plan, [int(x * UNIT) for x in v])), "two plates touch"


def inside_out(rng):
    plan = shell(rng) if rng.random() < .1 else plate(rng)[2]
    plan.flags = [1 - f for f in plan.flags]
    for box in plan.boxes:
        box.centres = [pair[::-1] for pair in box.centres]
        box.points_shift = None
    for box in plan.boxes:                                # o is another point: the polynomial stays the same one
        if box.separators:
            back = [pair[::-1] for pair in box.centres]
            box.separators = [moved_origin(q, back[0][0], box.centres[0][0], box.exponent()) for q in box.separators]
    if rng.random() < .7:
        plan.walks = [(b, 1 - s, points, end if isinstance(end, int) else (end[0], 1 - end[1])) for b, s, points, end in plan.walks]
        plan.values["bodies"] = sum(s for _, s, _, _ in plan.walks)
    return plan, "inside out"


def moved_origin(separator, old, new, exponent):
    """A separator of degree 1 for another o: its value at the old one becomes that at the new one."""
    degree, t, c = separator
    if degree > 1:
        return separator
    unit = Q(2) ** (exponent + t)
    first = c[0] + sum(c[1 + k] * (new[2 - k] - old[2 - k]) / unit for k in range(3))
    factor = first.denominator
    return [degree, t, [int(first * factor), *[x * factor for x in c[1:]]]]


def bad_nesting(rng):
    """The inner sphere outward, like the outer one."""
    plan = shell(rng)
    half = len(plan.flags) // 2
    for i in range(half, len(plan.flags)):
        plan.flags[i] = 1 - plan.flags[i]
    return plan, "a shell inside a shell, both outward"


FALSE = (pulled_through, two_that_cross, two_that_touch, inside_out, bad_nesting)


# ---------------------------------------------------------------- lies: each yields plans for a false model

def plain(plan, rng):
    yield copied(plan)


def stars(plan, least=1):
    return [box for box in plan.boxes if len(box.centres) >= least]


def other_signs(plan, rng):
    new = copied(plan)
    for box in stars(new, 2):
        box.signs = [[3 - s if s else 0 for s in signs] for signs in box.signs] if rng.random() < .5 else \
            [[rng.randint(0, 2) for _ in signs] for signs in box.signs]
    yield new


def other_separators(plan, rng):
    """Separators of any degree, through anything; the sheets have different signs."""
    for degree in (1, 2, 3):
        new = copied(plan)
        for box in stars(new, 2):
            n = len(box.centres)
            box.separators, box.signs = [], [[] for _ in range(n)]
            for i in range(n):
                size = len(forge2.powers(degree))
                box.separators.append([degree, rng.randint(-2, 30), [rng.choice((0, 0, 1, -1, rng.randint(-1000, 1000))) for _ in range(size)]])
                for j, signs in enumerate(box.signs):
                    signs.append(1 if i == j else 2)
        yield new


def merged_sheets(plan, rng):
    """One sheet for what are several, with the centres of one, or from below all to above all."""
    for way in range(3):
        new = copied(plan)
        for box in stars(new, 2):
            box.centres = [box.centres[way]] if way < 2 else [[box.centres[0][0], box.centres[-1][1]]]
            box.separators, box.signs, box.points_shift = [], [[]], None
        yield new


def split_sheets(plan, rng):
    """A sheet more, on a side of a plane or with the centres of another."""
    new = copied(plan)
    for box in stars(new):
        pair = rng.choice(box.centres)
        box.centres = [*box.centres, pair if rng.random() < .5 else pair[::-1]]
        k = rng.randrange(3)
        box.separators = [*box.separators, [1, 20, [rng.randint(-1, 1), *[int(j == k) for j in range(3)]]]]
        box.signs = [[*s, 1] for s in box.signs] + [[0] * (len(box.separators) - 1) + [2]]
    yield new


def other_centres(plan, rng):
    for way in range(3):
        new = copied(plan)
        for box in stars(new):
            if way == 0:
                box.centres = [pair[::-1] for pair in box.centres]
            elif way == 1:
                box.centres = box.centres[1:] + box.centres[:1]
            else:
                points = [c for pair in box.centres for c in pair]
                box.centres = [[rng.choice(points), rng.choice(points)] for _ in box.centres]
        yield new


def other_frames(plan, rng):
    """Rows exchanged, mirrored, sheared; boxes in another frame of the table."""
    for way in range(4):
        new = copied(plan)
        if way == 3:
            for box in new.boxes:
                box.frame = rng.randint(0, len(new.frames))
        elif new.frames:
            rows = [list(r) for r in new.frames[0]]
            if way == 0:
                rows = rows[::-1]
            elif way == 1:
                rows[rng.randrange(3)] = [-x for x in rows[0]]
            else:
                rows[rng.randrange(3)][rng.randrange(3)] += rng.choice((1, -1, 1 << 20))
            new.frames[0] = rows
        yield new


def other_boxes(plan, rng):
    """Boxes that reach farther, or less far; all mesh boxes, but where walks start."""
    for way in range(3):
        new, starts = copied(plan), {w[0] for w in plan.walks}
        for i, box in enumerate(new.boxes):
            size = [h - l for l, h in zip(box.lo, box.hi)]
            if way == 2 and i not in starts:
                box.kind, box.centres, box.separators, box.signs = 1, [], [], []
            elif way < 2:
                k, part = rng.randrange(3), rng.choice((2, 8, 64))
                change = size[k] // part * (1 if way else -1)
                box.lo[k], box.hi[k] = box.lo[k] - change // 2, box.hi[k] + change // 2
        yield new


def other_leaves(plan, rng):
    """Leaves that name other boxes; boxes that no leaf names stay."""
    for share in (.1, 1):
        new = copied(plan)
        target = rng.randrange(len(new.boxes))
        new.trees = [[patch_liars.renamed(t, lambda n: target if rng.random() < share else n) for t in trees] for trees in new.trees]
        yield new


def other_walks(plan, rng):
    """Walks from, or to, boxes with two sheets or mesh boxes, at either sign."""
    for _ in range(4):
        new = copied(plan)
        new.walks = [(rng.choice((b, rng.randrange(len(new.boxes)))), rng.randint(0, 1), points,
                      end if isinstance(end, int) and rng.random() < .5 else (rng.randrange(len(new.boxes)), rng.randint(0, 1)))
                     for b, _, points, end in new.walks]
        new.values["bodies"] = sum(s for _, s, _, _ in new.walks)
        yield new


def said_to_be_turned(plan, rng):
    """Only a model without flags could be."""
    new = copied(plan)
    new.values.update(claim="star-box-turned-2", bodies=0, winding=rng.choice((0, 1, 4)))
    if any(new.flags):
        yield new


LIES = (plain, other_signs, other_separators, merged_sheets, split_sheets, other_centres, other_frames, other_boxes, other_leaves,
        other_walks, said_to_be_turned)


def thin_attacks(rng):
    false = rng.choice(FALSE[:-1]) if rng.random() < .95 else FALSE[-1]      # spheres take seconds
    plan, _ = false(rng)
    for lie in LIES:
        if lie is plain or rng.random() < .5:
            for new in lie(plan, rng):
                yield "%s/%s" % (false.__name__, lie.__name__), *encoded(new)


def wrong_windings(rng):
    """The cube inside out, in version 2, with another winding number, flags or counts."""
    for case, plan in patch_liars.wrong_windings(rng):
        yield "wrong_windings", case.bytes, of_version_1(plan).certificate(case.bytes)


def sheet_attacks(rng):
    """(strategy, model, certificate)."""
    r = rng.random()
    if r < .6:
        yield from thin_attacks(rng)
    elif r < .65:
        yield from wrong_windings(rng)
    else:
        for name, case, plan in patch_liars.star_lies(rng):
            new = of_version_1(plan)
            if new:
                yield name, case.bytes, new.certificate(case.bytes)


def honest(rng):
    """(name, model, certificate)."""
    way = rng.randrange(6)
    if way < 4:
        plan = (lambda rng: plate(rng)[2], shell, blocks, squircle)[way](rng)
        if way < 2 and rng.random() < .5:
            plan = shifted(plan, [rng.randint(-5, 5) * UNIT for _ in range(3)])
        yield "sheets", *encoded(plan)
    elif way == 4:
        yield "converted", *encoded(of_version_1(ps.solid(rng, .02).plan))
    else:
        case = patch_liars.really_turned(rng)
        yield "turned-2", case.bytes, of_version_1(case.plan).certificate(case.bytes)
