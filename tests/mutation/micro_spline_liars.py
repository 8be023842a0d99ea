# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lies of the claim micro-inside-1 about spline models, and about sweeps inside of a model; the rest is right. micro_inside_liars.py tells them
beside its own. The cage is the unit cube; models are cubes of patches, and sometimes balls, around it or in it. Their proofs are found by the tests'
own search, once for each model."""
import copy
import functools
import pathlib
import sys
from fractions import Fraction as Q

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("tests/support", "tests/checker_py", "tests/mutation")]
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
import micro_inside_examples as insides                   # noqa: E402
import star_box_models as solids                          # noqa: E402
import vmodel_models                                      # noqa: E402

HALF = (Q(1, 2),) * 3
HAIR = Q(1, 1 << 30)


# ---------------------------------------------------------------- microstructures

def one(rng, lo=Q(1, 4), hi=Q(3, 4)):
    """A jack in [lo, hi]^3, the only cell."""
    plan = bridged.Micro(vmodel_models.honest("cube"), [(0, [[lo, hi]] * 3)], [examples.jack(Q(1, 5), rng.choice((Q(1, 8), Q(1, 10))), Q(0))], [[0]])
    plan.values = dict(cells=1, tiles=1, glued_caps=0, components=1, shells=1, genus=0, bridges=0)
    return plan


def two(rng):
    """Jacks in the first and the last one of 27 cells."""
    breaks = [[Q(i, 3) for i in range(4)]] * 3
    plan = bridged.Micro(vmodel_models.honest("cube"), [(0, breaks)], [examples.jack(Q(1, 5), rng.choice((Q(1, 8), Q(1, 10))), Q(0))],
                         [[0 if c in (0, 26) else None for c in range(27)]])
    plan.values = dict(cells=27, tiles=2, glued_caps=0, components=2, shells=2, genus=0, bridges=0)
    return plan


def with_sweeps(plan, length, walls, **more):
    sweeps = [bridged.swept(plan, 0, 0, w, length, **more) for w in sorted(walls)]
    return plan.changed(sweeps=sweeps, values={**plan.values, "bridges": len(sweeps)})


def some_walls(rng):
    return rng.sample(range(6), rng.randint(1, 6))


# ---------------------------------------------------------------- models

def block(half, middle=HALF, is_reversed=False, degree=1):
    faces = solids.cube(half, middle, degree)
    return [solids.reversed_surface(face) for face in faces] if is_reversed else faces


def joined(*blocks):
    return [face for arguments in blocks for face in block(*arguments)]


@functools.lru_cache(64)
def proved(*blocks, flags=None):
    """The plan about blocks (half side, middle, is it reversed); flags: of the blocks."""
    entities = joined(*blocks)
    return insides.forge2.Prover2(entities, flags=flags and [f for f in flags for _ in range(6)], search=True).prove().plan


def around(rng):
    return proved((rng.choice((Q(5, 8), Q(1), Q(3))), HALF, False))


def inside(micro, plan, **more):
    return insides.InsideSpline(micro, plan, **more)


def hollow(*voids, half=Q(1)):
    """voids: (half side, middle) each."""
    return proved((half, HALF, False), *[(size, middle, True) for size, middle in voids])


def some_void(rng):
    """(half side, middle, a point in it): in a corner of the unit cube, off the jack in [1/4, 3/4]^3."""
    size = Q(rng.choice((3, 5)), 128)
    middle = tuple(rng.choice((Q(1, 8), Q(7, 8))) for _ in range(3))
    return size, middle, tuple(c + size * Q(rng.randint(-15, 15), 16) for c in middle)


# ---------------------------------------------------------------- lies

def on_patches(rng):
    """I1: caps or sweeps touch or leave the model, or a void meets an arm or a sweep."""
    what = rng.randrange(4)
    if what == 0:
        half = Q(1, 4) - rng.choice((0, 0, HAIR, Q(1, 64)))
        yield "I1_cap", inside(one(rng), proved((half, HALF, False)))
    elif what == 1:
        length = Q(1, 4)
        half = Q(1, 2) - rng.choice((0, 0, HAIR, Q(1, 64)))
        yield "I1_end", inside(with_sweeps(one(rng), length, some_walls(rng)), proved((half, HALF, False)))
    elif what == 2:                                       # a void that an arm runs into
        axis, low = rng.randrange(3), rng.randrange(2)
        middle = [Q(1, 2)] * 3
        middle[axis] = Q(1, 4) if low else Q(3, 4)
        x = list(middle)
        x[axis] += Q(-1, 64) if low else Q(1, 64)
        yield "I1_void", inside(one(rng), hollow((Q(1, 32), tuple(middle))), voids=[(0, tuple(x), 8)])
    else:                                                 # a void across the side of a sweep, or in it
        wall = rng.randrange(6)
        plan = with_sweeps(one(rng), Q(3, 16), [wall])
        size, beside = rng.choice(((Q(1, 32), Q(1, 16)), (Q(1, 128), 0)))
        middle = [Q(1, 2) + beside if a == (wall // 2 + 1) % 3 else Q(1, 2) for a in range(3)]
        middle[wall // 2] = Q(7, 8) if wall % 2 else Q(1, 8)
        yield "I1_sweep", inside(plan, hollow((size, tuple(middle))), voids=[(0, tuple(middle), 8)])


def off_the_model(rng):
    """I2: the model is elsewhere, one of two tiles is off it, or all of it is in a void."""
    what = rng.randrange(3)
    if what == 0:
        middle = [Q(1, 2)] * 3
        middle[rng.randrange(3)] += rng.choice((-2, 2))
        yield "I2_elsewhere", inside(one(rng), proved((Q(1), tuple(middle), False)))
    elif what == 1:
        yield "I2_second", inside(two(rng), proved((Q(1, 2), (rng.choice((Q(0), Q(1))),) * 3, False)))
    else:
        yield "I2_void", inside(one(rng), hollow((Q(5, 8), HALF), half=Q(2)), voids=[(0, (Q(1, 8),) * 3, 8)])


def passed_over(rng):
    """I3: a void is in a tile or in a sweep's box, is not listed, or the voids change places."""
    what = rng.randrange(5)
    if what == 0:
        size, middle = Q(1, 64), tuple(c + Q(rng.randint(-2, 2), 64) for c in HALF)
        lie = inside(one(rng), hollow((size, middle)))
        yield "I3_unlisted", lie
        for corner in (8, rng.randrange(8)):
            yield "I3_bubble", lie.changed(voids=[(0, middle, corner)])
        return
    if what == 4:                                         # beside a sweep that leans, in its box
        plan, bend = one(rng), (Q(1, 8), Q(1, 8), Q(0))
        plan = with_sweeps(plan, Q(3, 16), [5], bend=bend)
        middle = (Q(1, 2) + Q(5, 32), Q(1, 2) - Q(1, 64), Q(25, 32))
        yield "I3_sweep", inside(plan, hollow((Q(1, 256), middle)), voids=[(0, middle, 8)])
        return
    size, middle, x = some_void(rng)
    if what == 1:
        lie = inside(one(rng), hollow((size, middle)))
        beyond = tuple(c + size * (2 if c < Q(1, 2) else -2) for c in middle)
        on = (middle[0] + size, *x[1:])
        for voids in ([], [(0, x, 8)] * 2, [(0, beyond, 8)], [(0, on, 8)], [(0, x, 0)]):
            yield "I3_entry", lie.changed(voids=voids)
        return
    other = tuple(1 - c for c in middle)
    entries = [(0, x, 8), (0, other, 8)]
    if what == 2:
        lie = inside(one(rng), hollow((size, middle), (size, other)))
        for voids in (entries[::-1], entries[:1], entries[:1] * 2):
            yield "I3_order", lie.changed(voids=voids)
    else:                                                 # the shells of the file change places, the entries do not
        yield "I3_swapped", inside(one(rng), hollow((size, other), (size, middle)), voids=entries)
        nested = proved((Q(1), HALF, False), (size, middle, True), (size / 2, middle, False))
        yield "I3_body", inside(one(rng), nested, voids=[(0, middle, 8)])


def turned_shells(rng):
    """I0: a shell that is inside out, or is no void, is turned by a flag; or it is not turned, and what is said of it is."""
    size, middle, x = some_void(rng)
    turned = proved((Q(1), HALF, False), (size, middle, False), flags=(0, 1))
    yield "I0_void", inside(one(rng), turned, voids=[(0, x, 8)])
    inside_out = proved((Q(1), HALF, True), flags=(1,))
    yield "I0_all", inside(one(rng), inside_out)
    for plan in (turned, inside_out):
        lie = copy.copy(plan)
        lie.flags = [0] * len(plan.flags)
        yield "solid_turned", inside(one(rng), lie, voids=[(0, x, 8)] if plan is turned else [])


def other_models(rng):
    """A1, or a condition of the star boxes: the proof of another model, breaks that leave out a part, no patches, cut-off parts."""
    plan, other = proved((Q(1), HALF, False)), proved((Q(5, 8), HALF, False))
    lie = copy.copy(plan)
    lie.boxes, lie.trees, lie.walks = other.boxes, other.trees, other.walks
    yield "solid_other", inside(one(rng), lie)
    lie = copy.deepcopy(plan)
    face, axis = rng.randrange(6), rng.randrange(2)
    lie.breaks[face][axis] = rng.choice(([Q(0), Q(1, 2)], [Q(1, 4), Q(1)], [Q(0), Q(1, 2), Q(1, 2), Q(1)], [Q(0), Q(2)]))
    yield "solid_breaks", inside(one(rng), lie)
    lie = copy.copy(plan)
    lie.entities = plan.entities[:face] + plan.entities[face + 1:]
    yield "solid_open", inside(one(rng), lie)
    true = inside(one(rng), plan)
    yield "A1_other", true.changed(values=rng.choice(({"model_bytes": len(true.model()) - 1}, {"model_sha256": "0" * 64})))


def thin_skins(rng):
    """I4: an end of a sweep or a bridge is farther from the patches than the skin; or the skin is there without them, or the reverse."""
    half, length = Q(rng.randint(33, 48), 64), Q(1, 4) - Q(rng.randint(1, 6), 64)
    if rng.random() < .5:
        plan = with_sweeps(one(rng), length, some_walls(rng))
    else:
        plan = one(rng)
        bridges = [bridged.straight(plan, 0, 0, w, Q(3, 4) + length if w % 2 else Q(1, 4) - length) for w in some_walls(rng)]
        plan = plan.changed(bridges=sorted(bridges, key=lambda b: b.wall), values={**plan.values, "bridges": len(bridges)})
    gap = half - Q(1, 4) - length
    lie = inside(plan, proved((half, HALF, False)))
    for skin in ("0", "-", str(gap * Q(rng.randint(1, 63), 64)), str(gap * (1 - Q(1, 1 << 20)))):
        yield "I4_skin", lie.changed(skin=skin)
    yield "I4_none", inside(one(rng), proved((half, HALF, False)), skin=str(gap))


def wrong_counts(rng):
    """W3, about microstructures that are inside."""
    plan = honest_plan(rng)
    key = rng.choice(("bridges", "tiles", "shells", "genus", "cells"))
    true = plan.micro.values[key]
    yield "W3_spline", plan.changed(values={key: rng.choice([n for n in range(true + 3) if n != true])})


STRATEGIES = ((on_patches, 10), (off_the_model, 6), (passed_over, 10), (turned_shells, 6), (other_models, 5), (thin_skins, 6), (wrong_counts, 3))


# ---------------------------------------------------------------- the truth

@functools.lru_cache(None)
def round_model(kind):
    entities = insides.ball(HALF, Q(2)) if kind == "ball" else solids.octant_sphere(3) if kind == "octants" else joined((Q(1), HALF, False, 2))
    return insides.forge2.Prover2(entities, search=True).prove().plan


def honest_plan(rng):
    what = rng.randrange(5)
    if what == 0:
        return inside(rng.choice((one, two))(rng), around(rng))
    if what == 1:
        return inside(one(rng), round_model(rng.choice(("ball", "octants", "cube"))))
    if what == 2:
        size, middle, x = some_void(rng)
        other = tuple(1 - c for c in middle)
        return inside(one(rng), hollow((size, middle), (size / 2, other)), voids=[(0, x, 8), (0, other, 8)])
    if what == 3:
        half, length = Q(rng.randint(33, 40), 64), Q(1, 4) - Q(rng.randint(1, 4), 64)
        gap = half - Q(1, 4) - length
        return inside(with_sweeps(one(rng), length, some_walls(rng)), proved((half, HALF, False)), skin=str(gap * Q(3, 2)))
    size, middle, x = some_void(rng)
    flagless = proved((Q(1), HALF, False), (size, middle, True), (size / 2, middle, False))
    at = tuple(c + size * Q(3, 4) for c in middle)
    return inside(one(rng), flagless, voids=[(0, at, 8)])
