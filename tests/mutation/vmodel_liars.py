#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claim vmodel-1: models that are false by construction (folded cells, cells that overlap or
touch, a cell and its copy, a ring of one and a half turns, double pyramids that fill a cube), and wrong statements about true ones; the
rest is right. As attacks.py, whose harness this is. Run

    python3 tests/mutation/vmodel_liars.py --count 20000 --seed 1 --checker PATH_TO_veritope-check
"""
import copy
import functools
import random
import sys
import time
from fractions import Fraction as Q

import attacks
import patch_attacks
import patch_solids as ps                                 # and the way to the forges
import vmodel_false_models as false_models
import vmodel_forge as forge
import vmodel_models as models

CONDITIONS = ["V1", "V2", "V3", "V4", "C1", "C2", "C3", "W1", "W2", "W3"]
SLOW = ("pinched inside",)
NAMES = [name for name in false_models.FALSE if name not in SLOW]
TURNS = [turn for turn in ps.ROTATIONS if not ps.is_odd(*turn)]


# ---------------------------------------------------------------- what the strategies share

def placed(plan, rng):
    """The model and its proof after a map of space that keeps the hand."""
    axes, signs = rng.choice(TURNS)
    scales = [rng.choice((1, 2, 3)) for _ in range(3)]
    shift = [Q(rng.randint(-40, 40), 8) for _ in range(3)]

    def image(p, unit=1):
        return [int(x) if unit > 1 else x for x in (scales[k] * signs[k] * p[axes[k]] + shift[k] * unit for k in range(3))]
    new = plan.changed(maps=[models.mapped(m, lambda p: tuple(image(p))) for m in plan.maps], text=None)
    new.x = x = copy.copy(plan.x)
    x.boxes = []
    for box in plan.x.boxes:
        box = copy.copy(box)
        ends = [image(p, ps.UNIT) for p in (box.lo, box.hi)]
        box.lo, box.hi = [list(map(f, *ends)) for f in (min, max)]
        box.centres = [[image(c, ps.UNIT) for c in pair] for pair in box.centres]
        x.boxes.append(box)
    x.walks = [(box, sign, [image(p, ps.UNIT) for p in points], ps.end_of(end, axes, signs)) for box, sign, points, end in plan.x.walks]
    return told(new, rng)


def told(plan, rng):
    """In some format; a number that has no decimals keeps it in the first."""
    plan.subject_format, plan.text = rng.choice(("vjson", "itd", "g2")), None
    try:
        plan.model()
    except (AssertionError, ValueError):
        plan.subject_format = "vjson"
    return plan


def random_tree(rng, most):
    if most == 0 or rng.random() < .4:
        return forge.LEAF
    return rng.randrange(3), random_tree(rng, most - 1), random_tree(rng, most - 1)


def moved_point(m, rng):
    """A control point moves: by an ulp, by a hair, or far."""
    at, axis = rng.randrange(len(m.points)), rng.randrange(3)
    step = rng.choice((Q(1, 1 << 52), Q(-1, 1 << 70), Q(1, 1024), Q(rng.randint(-9, 9) or 1, 4)))
    points = [tuple(c + (step if (i, k) == (at, axis) else 0) for k, c in enumerate(p)) for i, p in enumerate(m.points)]
    return models.texts.Map(m.degrees, m.knots, points, m.rational)


def random_code(plan, f, rng):
    r = rng.random()
    if r < .6 or f + 1 == len(plan.codes):
        return rng.choice([code for code in (0, 1, 2) if code != plan.codes[f]])
    if isinstance(plan.codes[f], tuple) and r < .8:
        return plan.codes[f][0], rng.choice([s for s in range(8) if s != plan.codes[f][1]])
    other = rng.randrange(f + 1, len(plan.codes)), rng.randrange(8)
    return other if other != plan.codes[f] else 0


def bent(plan, rng):
    """Up to three fields of a certificate say something else; the numbers follow."""
    plan = plan.changed()
    for _ in range(rng.randint(1, 3)):
        kind, piece = rng.randrange(6), rng.randrange(plan.values["pieces"])
        zeros, tree = plan.entries.get(piece, ((), forge.LEAF))
        if kind == 0:
            plan.entries[piece] = zeros, random_tree(rng, 5)
        elif kind == 1:
            plan.entries[piece] = sorted(set(zeros) ^ {rng.randrange(26)}), tree
        elif kind == 2:
            plan.entries[piece] = sorted(rng.sample(range(26), rng.randint(0, 3))), random_tree(rng, 3)
        elif kind == 3:
            f = rng.randrange(len(plan.codes))
            plan.codes[f] = random_code(plan, f, rng)
        elif kind == 4:
            plan.flags[rng.randrange(len(plan.flags))] ^= 1
        else:
            plan.x = copy.copy(plan.x)
            plan.x.flags = [rng.choice((f, 1 - f)) for f in plan.x.flags]
    return plan.settled()


def false_plan(rng):
    name = rng.choice(NAMES)
    return name.replace(" ", "_"), placed(false_models.false(name)[0], rng)


# ---------------------------------------------------------------- models that are false

def false_as_it_is(rng):
    name, plan = false_plan(rng)
    yield name, plan


def false_and_bent(rng):
    name, plan = false_plan(rng)
    for _ in range(4):
        yield "bent_" + name, bent(plan, rng)


def signs_everywhere(rng):
    """Folded cells; every tree is deep, and whatever may be zero is said to be."""
    name = rng.choice(("folded", "folded, rational", "folded at a corner", "double pyramids", "turned inner cell"))
    plan = placed(false_models.false(name)[0], rng)
    for _ in range(3):
        for piece in range(plan.values["pieces"]):
            plan.entries[piece] = sorted(rng.sample((0, 1, 3, 4, 9, 12), rng.randint(0, 1))), random_tree(rng, 6)
        yield "signs_" + name.replace(" ", "_"), plan.settled().changed()


def corner_moved_too_far(rng):
    """Eight cells with a common corner, which is just beyond the plane at which N vanishes there."""
    place = Q(2, 3) - Q(1, 1 << rng.choice((6, 20, 52, 100)))
    plan = false_models.made("folded at a corner").changed()
    plan.maps = [models.texts.Map(m.degrees, m.knots, [(place,) * 3 if p == (Q(33, 50),) * 3 else p for p in m.points]) for m in plan.maps]
    plan = placed(plan, rng)
    yield "corner_moved", plan
    yield "corner_moved", plan.changed(entries={0: ([26 - 13], random_tree(rng, 6))}).settled()


@functools.lru_cache(64)
def box_at(lo, hi):
    return forge.proved([models.box(lo, hi)])


def boxes_in_touch(rng):
    """Two boxes that overlap, or have a part of a face, an edge or a corner in common, by a hair or more."""
    lo = tuple(rng.choice((Q(1, 4), Q(1, 2), Q(3, 4), 1, 1)) for _ in range(3))
    hair = rng.choice((0, 0, Q(1, 1024), Q(1, 1 << 18)))
    lo = tuple(x - hair for x in lo)
    sizes = rng.choice(((1, 1, 1), (1, Q(1, 2), 2), (Q(1, 4), Q(1, 4), Q(1, 4))))
    other = box_at(lo, tuple(a + b for a, b in zip(lo, sizes)))
    yield "boxes_in_touch", placed(forge.together(models.honest("cube"), other), rng)


def nested_wrongly(rng):
    """A cell inside another; the walks end in every way."""
    outer, inner = box_at((0, 0, 0), (9, 9, 9)), box_at((4, 4, 4), (4 + rng.randint(1, 3),) * 3)
    plan = forge.together(outer, inner)
    (a, _, _, end_a), (b, _, _, end_b) = plan.x.walks
    for walks in ([(a, 1, [], end_a), (b, 1, [], end_b)], [(a, 1, [], end_a), (b, 1, [], (a, 0))], [(a, 1, [], end_a), (b, 0, [], (a, 0))],
                  [(b, 1, [], end_b), (a, 0, [], (b, 1))]):
        plan.x = copy.copy(plan.x)
        plan.x.walks, plan.x.values = walks, {**plan.x.values, "bodies": sum(sign for _, sign, _, _ in walks)}
        yield "nested_wrongly", placed(plan.settled(), rng)


def out_of_the_way(rng):
    """Two boxes overlap; the leaves whose boxes would show it name others, which do not."""
    other = (Q(1, 2),) * 3
    plan = false_models.false("crossing cells")[0]
    x = plan.x = copy.copy(plan.x)
    n = len(x.boxes) // 2
    sizes = [[(0, ps.UNIT)] * 3, [(int(o * ps.UNIT), int((o + 1) * ps.UNIT)) for o in other]]

    def is_cool(k):
        box, cube = x.boxes[k], sizes[0 if k >= n else 1]
        return any(h < a or l > b for l, h, (a, b) in zip(box.lo, box.hi, cube))
    cool = [[k for k in range(n) if is_cool(k)], [k for k in range(n, 2 * n) if is_cool(k)]]
    number = {k: i for i, k in enumerate(cool[0] + cool[1])}

    def renamed(tree):
        if isinstance(tree, int):
            return number[tree if tree in number else rng.choice(cool[tree >= n])]
        return [renamed(kid) for kid in tree]
    x.trees = [[renamed(tree) for tree in trees] for trees in x.trees]
    walks = []
    for part, names in enumerate(cool):                   # a ray along an axis, away from the other box
        for k in names:
            c = x.boxes[k].centres[0][1]
            axis = c.index(max(c) if part else min(c))
            if c[axis] > sizes[1][0][1] if part else c[axis] < 0:
                walks.append((number[k], 1, [], 2 * axis + 1 - part))
                break
    x.boxes = [x.boxes[k] for k in number]
    if len(walks) == 2:
        x.walks = walks
        yield "out_of_the_way", placed(plan.settled(), rng)


def ring_cells(count, growth):
    corners = [(1, 1), (1, -1), (-1, -1), (-1, 1)]

    def corner(n):
        return tuple(c * (1 + growth * n) for c in corners[n % 4])
    return [models.cube(lambda p, n=n: tuple((1 - p[0]) * (1 + 2 * p[1]) * a + p[0] * (1 + 2 * p[1]) * b for a, b in zip(
        corner(n), corner(n + 1))) + (p[2],)) for n in range(count)]


@functools.lru_cache(4)
def long_ring(growth):
    """Six of the four cells of a square ring, in a row; what is said about each is what is right in a part of the row."""
    parts = [forge.proved(ring_cells(6, growth)[first:first + 3], but=()) for first in (0, 3)]
    cells = ring_cells(6, growth)
    plan = forge.Plan(cells)
    plan.codes = forge.glued(forge.Faces(cells[:3], plan.added[:3]), [0] * 3) * 2
    plan.codes = [(code[0] + (18 if f >= 18 else 0), code[1]) if isinstance(code, tuple) else code for f, code in enumerate(plan.codes)]
    last = forge.glued(forge.Faces(cells[2:4], plan.added[:2]), [0] * 2)
    joint = [f for f in range(6) if isinstance(last[f], tuple)][0]
    end = last[joint][0] - 6
    plan.codes[12 + joint], plan.codes[18 + end] = (18 + end, last[joint][1]), 2
    x = forge.joined_x(*[p.x for p in parts])
    of_x = [(n, f) for n, p in enumerate(parts) for f, code in enumerate(p.codes) if code == 0]
    kept = [i for i, (n, f) in enumerate(of_x) if (n, f) not in ((0, 12 + joint), (1, end))]
    for name in ("entities", "flags", "breaks", "roots", "kinds", "trees"):
        setattr(x, name, [getattr(x, name)[i] for i in kept])
    used = sorted({k for trees in x.trees for tree in trees for k in leaves(tree)})
    number = {k: i for i, k in enumerate(used)}
    x.trees = [[renumbered(tree, number) for tree in trees] for trees in x.trees]
    x.boxes = [x.boxes[k] for k in used]
    x.walks = [(number[box], sign, points, end) for box, sign, points, end in x.walks if box in number][:1]
    x.values.update(patches=26, edges=52, vertices=28, shells=1, genus=0, bodies=1)
    plan.x = x
    return plan.settled()


def leaves(tree):
    return [tree] if isinstance(tree, int) else [k for kid in tree for k in leaves(kid)]


def renumbered(tree, number):
    return number[tree] if isinstance(tree, int) else [renumbered(kid, number) for kid in tree]


def ring_of_one_and_a_half_turns(rng):
    yield "long_ring", placed(long_ring(rng.choice((Q(0), Q(1, 16), Q(-1, 16)))), rng)


# ---------------------------------------------------------------- wrong statements about true models

def true_plan(rng):
    return placed(models.honest(rng.choice(list(models.honest_models()))), rng)


def wrong_numbers(rng):
    plan = true_plan(rng)
    key = rng.choice(list(plan.values))
    for step in (-1, 1, 2):
        if plan.values[key] + step >= 0:
            yield "wrong_" + key, plan.changed(values={**plan.values, key: plan.values[key] + step})


def wrong_zeros(rng):
    """A zero is missing, or N is not zero on it, or it is a part of another one."""
    plan = true_plan(rng)
    for _ in range(3):
        lie, piece = plan.changed(), rng.randrange(plan.values["pieces"])
        zeros, tree = lie.entries.get(piece, ((), forge.LEAF))
        lie.entries[piece] = sorted(set(zeros) ^ {rng.choice([*zeros, *range(26)])}), tree
        yield "wrong_zeros", lie.settled()


def wrong_codes(rng):
    plan = true_plan(rng)
    for _ in range(3):
        lie, f = plan.changed(), rng.randrange(len(plan.codes))
        glued = [f for f, code in enumerate(plan.codes) if isinstance(code, tuple)]
        if glued and rng.random() < .5:
            f = rng.choice(glued)
        lie.codes[f] = random_code(lie, f, rng)
        yield "wrong_codes", lie.settled()


def wrong_flags(rng):
    """Flags of cells, where N is negative, and flags of faces of X."""
    plan = true_plan(rng)
    lie = plan.changed()
    lie.flags[rng.randrange(len(lie.flags))] ^= 1
    yield "wrong_flags", lie.settled()
    lie = plan.changed(x=copy.copy(plan.x))
    lie.x.flags = [int(rng.random() < .5) for _ in lie.x.flags]
    if any(lie.x.flags):
        yield "wrong_flags_of_x", lie.settled()


def nearly_equal(rng):
    """A control point of one of two glued faces has moved."""
    name = rng.choice(("two", "three in an L", "in a cube", "six pyramids", "a fan", "curved pair", "two, one of them mirrored and turned"))
    plan = placed(models.honest(name), rng)
    faces = [f for f, code in enumerate(plan.codes) if code == 2 or isinstance(code, tuple)]
    for _ in range(3):
        maps, f = list(plan.maps), rng.choice(faces)
        moved = moved_point(maps[f // 6], rng)
        on_face = forge.face_net(moved.all(), f % 6 // 2, f % 2) != forge.face_net(maps[f // 6].all(), f % 6 // 2, f % 2)
        maps[f // 6] = moved
        if on_face:
            yield "nearly_equal", plan.changed(maps=maps, text=None, subject_format="vjson")


def wrong_breaks(rng):
    """X is cut where the cells are not, or not where they are; or a cell is cut where its neighbour is not."""
    plan, other = models.honest("cube"), models.honest("cube with breaks")
    if rng.random() < .5:
        plan, other = other, plan
    yield "wrong_breaks_of_x", placed(plan.changed(x=other.x).settled(), rng)
    plan = placed(models.honest(rng.choice(("two", "two with breaks"))), rng)
    lie = plan.changed(added=copy.deepcopy(plan.added))
    cell, axis = rng.randrange(2), rng.randrange(3)
    ends = plan.maps[cell].knots[axis]
    lie.added[cell][axis] = [ends[0] + (ends[-1] - ends[0]) * Q(rng.randint(1, 6), 7)]
    yield "wrong_breaks", lie.settled()


def cut_off(rng):
    plan = true_plan(rng)
    body = plan.body()
    n = rng.randrange(len(body))
    yield "cut_off", plan.changed(body=lambda: body[:n])


STRATEGIES = ((false_as_it_is, 20), (false_and_bent, 20), (signs_everywhere, 8), (corner_moved_too_far, 6), (boxes_in_touch, 10), (nested_wrongly, 6),
              (out_of_the_way, 2), (ring_of_one_and_a_half_turns, 4), (wrong_numbers, 8), (wrong_zeros, 6), (wrong_codes, 6), (wrong_flags, 5),
              (nearly_equal, 6), (wrong_breaks, 4), (cut_off, 1))


def vmodel_attacks(rng):
    """(name, model, certificate)"""
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    for name, plan in strategy(rng):
        model = plan.model()
        yield name, model, plan.certificate(model)


# ---------------------------------------------------------------- true models

def random_polycube(rng):
    """One to three boxes in a row or an L, their parameters named and directed at random, with breaks, in other degrees or rational."""
    shape = rng.choice((((0, 0, 0),), ((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (1, 0, 0), (0, 1, 0)), ((0, 0, 0), (1, 0, 0), (2, 0, 0))))
    maps, flags, added = [], [], []
    breaks = [sorted(rng.sample((Q(1, 3), Q(1, 2), Q(3, 4)), rng.choice((0, 0, 1)))) for _ in range(3)]
    for at in shape:
        m = models.box(at, tuple(a + 1 for a in at))
        if rng.random() < .3:
            m = models.raised_cell(m, rng.randrange(3))
        if rng.random() < .3:
            m = models.weighted(m, rng.choice((1, 3, Q(1, 4))))
        axes, reverse = rng.sample(range(3), 3), [rng.randrange(2) for _ in range(3)]
        maps.append(models.permuted(m, axes, reverse))
        flags.append(models.is_mirror(axes, reverse))
        more = [breaks[a] for a in axes]
        added.append([[1 - t for t in b[::-1]] if r else b for b, r in zip(more, reverse)])
    return forge.proved(maps, flags, added)


def honest(rng):
    """(name, model, certificate)"""
    plan = random_polycube(rng) if rng.random() < .3 else true_plan(rng)
    if rng.random() < .5:
        plan = placed(plan, rng)
    yield "vmodel", plan.model(), plan.certificate()


class Run(attacks.Run):
    conditions, implied = CONDITIONS, {}

    def __init__(self, options):
        super().__init__(options)
        self.order = random.Random(options.seed)          # which attacks the Python checker judges

    @staticmethod
    def attacks(rng):
        return patch_attacks.subjects(vmodel_attacks(rng))

    @staticmethod
    def honest_certificates(rng):
        return patch_attacks.subjects(honest(rng))

    def attack(self, name, case, cert, seed):
        if not self.options.checker or self.order.random() < self.options.python_share:
            super().attack(name, case, cert, seed)
            return
        code, message = self.native.check(case.bytes, cert, *self.more(case))
        if code != 1:
            self.fail("FALSE CLAIM ACCEPTED" if code == 0 else message, case.bytes, cert, seed, name, *self.more(case))
        self.table[name, attacks.condition_of(code, message)] += 1


def missing_conditions(alone, conditions=CONDITIONS):
    return attacks.missing_conditions(alone, conditions, {})


def figures(name, conditions, found, options, seconds):
    table, alone, honest_found, failures = found
    yield f"{name}_attacks", sum(table.values()), options.count
    yield f"{name}_attacks_stopped_by_S_or_B1", sum(n for (_, c), n in table.items() if c in attacks.UNCOUNTED), None
    yield f"{name}_attack_strategies", len({n for n, _ in table}), None
    yield f"{name}_attacks_accepted", sum(n for (_, c), n in table.items() if c == "ACCEPT"), 0
    yield f"{name}_checker_disagreements", sum("disagree" in f for f in failures), 0
    yield f"{name}_conditions_needed_alone", sum(1 for c in conditions if alone.get(c)), len(conditions)
    yield f"honest_{name}_certificates", sum(honest_found.values()), options.honest
    yield f"honest_{name}_certificates_rejected", sum(n for (_, c), n in honest_found.items() if c != "ACCEPT"), 0
    yield "seconds", round(seconds, 1), None


def main(argv, run=Run, name="vmodel", conditions=CONDITIONS):
    options, start = attacks.parse(argv), time.monotonic()
    found = attacks.run_all(options, run)
    table, alone, _, failures = found
    attacks.print_table(table, alone, conditions)
    return attacks.report(failures, figures(name, conditions, found, options, time.monotonic() - start),
                          missing_conditions(alone, conditions) if sum(table.values()) >= 2000 else ())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
