#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against the checkers of the claim micro-inside-1: microstructures that leave the model, lie elsewhere, in a void of it, or have
a void in a tile, bridges that end too far from its skin; the rest is right. As vmodel_liars.py, whose harness this is. Run

    python3 tests/mutation/micro_inside_liars.py --count 20000 --honest 1000 --seed 1 --checker PATH_TO_veritope-check

The cage is a box, the numbers are counted by hand. More lies are in tests/checker_py/micro_inside_test.py."""
import functools
import pathlib
import random
import sys
from fractions import Fraction as Q

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("tests/support", "tests/checker_py", "tests/mutation", "verify/checker")]
import attacks                                            # noqa: E402
import mesh_models as meshes                              # noqa: E402
import micro_bridge_examples as bridged                   # noqa: E402
import micro_examples as examples                         # noqa: E402
import micro_inside_examples as insides                   # noqa: E402
import micro_spline_liars                                 # noqa: E402
import micro_variants                                     # noqa: E402
import vmodel_liars                                       # noqa: E402
import vmodel_models                                      # noqa: E402

CONDITIONS = ["A1", "B2", "I0", "I1", "I2", "I3", "I4", "W3"]
HALF = (Q(1, 2),) * 3
KEYS, FRAMES = examples.KEYS, 32                          # a proof of a box takes 0.03 s


# ---------------------------------------------------------------- a box with jacks

@functools.lru_cache(None)
def box_cage(least, sides):
    return micro_variants.Fixed(vmodel_models.forge.proved([vmodel_models.box(least, tuple(a + s for a, s in zip(least, sides)))]))


class Frame:
    """Where the unit cube of the parameters is in space: the map of the cage and of all meshes."""

    def __init__(self, rng, is_even=False):
        rng = random.Random(rng.randrange(FRAMES))
        self.least = tuple(rng.randint(-2, 2) for _ in range(3))
        self.sides = (rng.choice((1, 2, 4)),) * 3 if is_even else tuple(rng.choice((1, 2)) for _ in range(3))

    def cage(self):
        return box_cage(self.least, self.sides)

    def placed(self, mesh):
        points, polygons = mesh
        return [tuple(a + s * float(c) for a, s, c in zip(self.least, self.sides, p)) for p in points], polygons


def counted(n_cells, tiles, bridges=0):
    """Tiles that do not touch each other."""
    return dict(cells=n_cells, tiles=tiles, glued_caps=0, components=tiles, shells=tiles, genus=0, bridges=bridges)


def one(frame, rng, lo=Q(1, 4), hi=Q(3, 4)):
    """A jack in [lo, hi]^3, the only cell."""
    cap = rng.choice((Q(1, 8), Q(1, 10), Q(1, 7)))
    plan = bridged.Micro(frame.cage(), [(0, [[lo, hi]] * 3)], [examples.jack(Q(1, 5), cap, Q(0))], [[0]])
    plan.values = counted(1, 1)
    return plan


def two(frame, rng):
    """Jacks in the first and the last one of 27 cells."""
    cap = rng.choice((Q(1, 8), Q(1, 10), Q(1, 7)))
    breaks = [[Q(i, 3) for i in range(4)]] * 3
    plan = bridged.Micro(frame.cage(), [(0, breaks)], [examples.jack(Q(1, 5), cap, Q(0))], [[0 if c in (0, 26) else None for c in range(27)]])
    plan.values = counted(27, 2)
    return plan


def with_bridges(plan, end, walls):
    bridges = [bridged.straight(plan, 0, 0, w, 1 - end if w % 2 else end) for w in sorted(walls)]
    return plan.changed(bridges=bridges, values={**plan.values, "bridges": len(bridges)})


# ---------------------------------------------------------------- meshes

def cube(at, side):
    return meshes.move(meshes.CUBE, tuple(float(c) for c in at), float(side))


def around(rng):
    gap = rng.choice((Q(1, 8), Q(1, 2), Q(1), Q(3)))
    return cube((-gap,) * 3, 1 + 2 * gap)


def with_voids(mesh, *voids):
    """voids: (least corner, side) each."""
    for at, side in voids:
        mesh = meshes.join(mesh, meshes.turned(cube(at, side)))
    return mesh


def some_walls(rng):
    return rng.sample(range(6), rng.randint(1, 6))


def corner_void(rng):
    """(least corner, side, a point in it): in a corner of the unit cube, off the jack in [1/4, 3/4]^3."""
    side = Q(rng.randint(4, 12), 128)
    at = tuple(rng.choice((Q(1, 32), 1 - Q(1, 32) - side)) for _ in range(3))
    return at, side, tuple(c + side * Q(rng.randint(1, 15), 16) for c in at)


# ---------------------------------------------------------------- lies

def on_the_surface(rng):
    """I1: an arm or a bridge passes through a void, caps touch or leave the model."""
    frame, what = Frame(rng), rng.randrange(5)
    if what == 0:                                         # a cap lies in a face of the model, or beyond it
        axis, low = rng.randrange(3), rng.random() < .5
        step = rng.choice((Q(0), Q(0), Q(1, 1 << 20), Q(1, 64)))
        lo, hi = [Q(-1)] * 3, [Q(2)] * 3
        if low:
            lo[axis] = Q(1, 4) + step
        else:
            hi[axis] = Q(3, 4) - step
        points, polygons = meshes.CUBE
        mesh = [tuple(float(a + (b - a) * Q(c)) for a, b, c in zip(lo, hi, p)) for p in points], polygons
        yield "I1_cap", insides.Inside(one(frame, rng), frame.placed(mesh))
        return
    if what == 1:                                         # a void that an arm runs into
        axis, side = rng.randrange(3), Q(rng.randint(2, 8), 64)
        at = [Q(1, 2) - side / 2] * 3
        at[axis] = rng.choice((Q(1, 4) - side / 2, Q(3, 4) - side / 2))
        x = [Q(1, 2)] * 3
        x[axis] = Q(1, 4) - side / 4 if at[axis] < Q(1, 2) else Q(3, 4) + side / 4
        plan = one(frame, rng)
    elif what == 2:                                       # a void that crosses the side of a bridge
        wall = rng.randrange(6)
        plan = with_bridges(one(frame, rng), Q(1, 16), [wall])
        side, at = Q(rng.randint(4, 8), 64), [Q(17, 32)] * 3
        at[wall // 2] = Q(13, 16) if wall % 2 else Q(3, 16) - side
        x = [c + side * Q(7, 8) for c in at]
    elif what == 3:                                       # a void in a bridge: nothing but its surface's neighbours see it
        wall = rng.randrange(6)
        plan = with_bridges(one(frame, rng), Q(1, 16), [wall])
        side, at = Q(1, 64), [Q(1, 2) - Q(1, 128)] * 3
        at[wall // 2] = Q(7, 8) if wall % 2 else Q(1, 8) - side
        x = [c + side / 2 for c in at]
    else:                                                 # all of the tile's cell is cut by the model's face
        points, polygons = cube((-1,) * 3, 3)
        axis, place = rng.randrange(3), Q(rng.randint(17, 47), 64)
        mesh = [tuple(float(place) if a == axis and c > 1 else c for a, c in enumerate(p)) for p in points], polygons
        yield "I1_cut", insides.Inside(one(frame, rng), frame.placed(mesh))
        return
    mesh = with_voids(around(rng), (at, side))
    yield "I1_void", insides.Inside(plan, frame.placed(mesh), voids=[(0, tuple(x), 8)])


def elsewhere(rng):
    """I2: the model is elsewhere, one of two tiles is off it or in a void of it."""
    frame, what = Frame(rng), rng.randrange(4)
    if what == 0:
        at = [Q(rng.randint(-3, 3), 2) for _ in range(3)]
        at[rng.randrange(3)] = rng.choice((Q(-3), Q(1), Q(5, 4)))
        yield "I2_elsewhere", insides.Inside(one(frame, rng), frame.placed(cube(at, Q(rng.randint(1, 7), 4))))
    elif what == 1:                                       # the first or the last one is inside
        at = rng.choice(((Q(-1),) * 3, (Q(1, 2),) * 3))
        yield "I2_second", insides.Inside(two(frame, rng), frame.placed(cube(at, Q(3, 2))))
    elif what == 2:                                       # all of it is in a void, whose point is right
        gap = Q(rng.randint(1, 15), 64)
        mesh = with_voids(around(rng), ((gap,) * 3, 1 - 2 * gap))
        x = tuple(gap + (Q(1, 4) - gap) / rng.randint(2, 9) for _ in range(3))
        yield "I2_void", insides.Inside(one(frame, rng), frame.placed(mesh), voids=[(0, x, 8)])
    else:                                                 # the last one is
        mesh = with_voids(around(rng), ((Q(5, 8),) * 3, Q(7, 16)))
        if max(max(p) for p in mesh[0]) < Q(9, 8):
            return
        yield "I2_second_in_void", insides.Inside(two(frame, rng), frame.placed(mesh), voids=[(0, (Q(41, 64),) * 3, 8)])


def bubbles(rng):
    """I3: the body of a tile fills a void, or what is said of a void is not so."""
    frame, what = Frame(rng), rng.randrange(7)
    if what < 2:                                          # the bubble
        side = Q(rng.choice((1, 2, 4, 6)), 128)
        plan = one(frame, rng) if rng.random() < .5 else one(frame, rng, Q(0), Q(1))
        lo, hi = plan.grids[0][1][0]
        at = [(lo + hi) / 2 + (hi - lo) * Q(rng.randint(-8, 8), 64) - side / 2 for _ in range(3)]
        if what:                                          # in an arm
            at = [(lo + hi) / 2 - side / 2] * 3
            side /= 4
            at[rng.randrange(3)] += (hi - lo) * rng.choice((-1, 1)) * Q(3, 8)
        x = tuple(c + side * Q(rng.randint(1, 15), 16) for c in at)
        mesh = with_voids(around(rng), (at, side))
        lie = insides.Inside(plan, frame.placed(mesh))
        yield "I3_unlisted", lie
        for corner in range(9):
            yield "I3_bubble", lie.changed(voids=[(0, x, corner)])
        return
    at, side, x = corner_void(rng)
    mesh = frame.placed(with_voids(around(rng), (at, side)))
    lie = insides.Inside(one(frame, rng, *((Q(0), Q(1)) if what == 4 else ())), mesh)
    if what == 2:                                         # no entry, two, another point, the point on the surface
        outside = tuple(c + side * (2 if c < Q(1, 2) else -1) for c in at)
        on = tuple(at[0] if a == 0 else c for a, c in enumerate(x))
        for voids in ([], [(0, x, 8)] * 2, [(0, outside, 8)], [(0, on, 8)], [(0, HALF, 8)]):
            yield "I3_entry", lie.changed(voids=voids)
    elif what == 3:                                       # a corner though the point is in no cell; a point outside of the parameters
        yield "I3_corner", lie.changed(voids=[(0, x, rng.randrange(8))])
        yield "I3_outside", lie.changed(voids=[(0, (x[0], x[1], -x[2]), 8)])
    elif what == 4:                                       # the cell is the whole cube: another corner's box, or none
        right = sum((c > Q(1, 2)) << a for a, c in enumerate(at))
        for corner in (7 - right, 8, right ^ 3, right ^ 5, right ^ 6):
            yield "I3_behind", lie.changed(voids=[(0, x, corner)])
    elif what == 5:                                       # a body in the void: the point is inside of it
        inner = tuple(c + side / 4 for c in at)
        mesh = frame.placed(meshes.join(with_voids(around(rng), (at, side)), cube(inner, side / 2)))
        yield "I3_body", insides.Inside(one(frame, rng), mesh, voids=[(0, tuple(c + side / 2 for c in at), 8)])
    else:                                                 # two voids in the other order, or one twice
        other = tuple(1 - c - side for c in at)
        mesh = frame.placed(with_voids(around(rng), (at, side), (other, side)))
        first, second = (0, x, 8), (0, tuple(c + side / 2 for c in other), 8)
        lie = insides.Inside(one(frame, rng), mesh)
        for voids in ([second, first], [first, first], [first]):
            yield "I3_order", lie.changed(voids=voids)


def short_skins(rng):
    """I4: an end is farther from the model's surface than the skin, or there is a skin without bridges, or the reverse."""
    frame = Frame(rng, is_even=True)
    gap, end = Q(rng.randint(1, 8), 64), Q(rng.randint(9, 15), 64)
    plan, mesh = with_bridges(one(frame, rng), end, some_walls(rng)), frame.placed(cube((gap,) * 3, 1 - 2 * gap))
    true = (end - gap) * frame.sides[0]
    lie = insides.Inside(plan, mesh)
    for skin in ("0", "-", str(true * Q(rng.randint(1, 63), 64)), str(true * (1 - Q(1, 1 << 20)))):
        yield "I4_skin", lie.changed(skin=skin)
    yield "I4_no_bridges", insides.Inside(one(frame, rng), mesh, skin=str(true))


def wrong_numbers(rng):
    """W3, B2, A1: about microstructures that are inside."""
    plan = honest_plan(rng)
    key = rng.choice(KEYS)
    true = plan.micro.values[key]
    yield "W3_numbers", plan.changed(values={key: rng.choice([n for n in range(true + 3) if n != true])})
    if plan.voids:
        volume, x, corner = plan.voids[0]
        long = tuple(c + Q(1, (1 << 64) + 1) for c in x)
        yield "B2_void", plan.changed(voids=[(volume, long, corner), *plan.voids[1:]])
    yield "A1_model", plan.changed(values=rng.choice(({"model_bytes": len(plan.model()) + 1}, {"model_sha256": "0123456789abcdef" * 4})))


def wrong_structures(rng):
    """The microstructure itself, or the model, is not proved; the rest is right."""
    frame = Frame(rng)
    plan = with_bridges(one(frame, rng), Q(1, 8), some_walls(rng))
    first = plan.bridges[0]
    axis = first.wall // 2
    b = (axis + 1) % 3
    lies = {"R1": first.changed(matrix=[[-c for c in line] for line in first.matrix]),
            "R2": first.moved(0, lambda p: tuple(c + Q(1, 1 << 40) if a == b else c for a, c in enumerate(p)))}
    for name, lie in lies.items():
        yield name + "_bridge", insides.Inside(plan.changed(bridges=[lie, *plan.bridges[1:]]), frame.placed(around(rng)))
    at = rng.choice((Q(1, 2) + Q(1, 1 << 40), Q(9, 10)))
    yield "F2_centre", insides.Inside(plan.changed(hints=[((at, at, at), plan.hints[0][1])]), frame.placed(around(rng)))
    dented = meshes.join(around(rng), cube((-9,) * 3, 18))
    yield "solid", insides.Inside(plan, frame.placed(dented))


STRATEGIES = ((bubbles, 10), (on_the_surface, 12), (elsewhere, 10), (short_skins, 4), (wrong_numbers, 4), (wrong_structures, 2),
              *micro_spline_liars.STRATEGIES)


def inside_attacks(rng):
    """(name, the microstructure, the certificate, the model)"""
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    yield from told_by(strategy, rng)


def told_by(strategy, rng):
    for name, plan in strategy(rng):
        yield name, plan.micro.text(), plan.certificate(), plan.model()


# ---------------------------------------------------------------- the truth

def honest_plan(rng):
    frame, what = Frame(rng, is_even=True), rng.randrange(4)
    if what == 0:
        return insides.Inside(two(frame, rng), frame.placed(around(rng)), mesh_format=rng.choice(("off", "stl", "obj", "ply")))
    if what == 1:
        at, side, x = corner_void(rng)
        mesh = frame.placed(with_voids(around(rng), (at, side)))
        return insides.Inside(one(frame, rng), mesh, voids=[(0, x, 8)])
    if what == 2:
        at, side, x = corner_void(rng)
        mesh = frame.placed(with_voids(around(rng), (at, side)))
        return insides.Inside(one(frame, rng, Q(0), Q(1)), mesh, voids=[(0, x, sum((c > Q(1, 2)) << a for a, c in enumerate(at)))])
    gap, end = Q(rng.randint(1, 8), 64), Q(rng.randint(9, 15), 64)
    plan = with_bridges(one(frame, rng), end, some_walls(rng))
    skin = (end - gap) * frame.sides[0] * (1 + rng.choice((Q(1, 16), Q(1, 3))))
    return insides.Inside(plan, frame.placed(cube((gap,) * 3, 1 - 2 * gap)), skin=str(skin))


# ---------------------------------------------------------------- running

class Native(attacks.Native):
    """The C++ checker, with the model."""

    def arguments(self, more):
        return [*self.files[:2], "--model", self.files[3]]


class Case:
    def __init__(self, data, model):
        self.bytes, self.model = data, model


class OfModels:
    """The Python checker, whose third file is the model."""

    def __init__(self, py):
        self.py = py

    def check(self, subject, certificate, model):
        return self.py.check(subject, certificate, second=model)

    def _check(self, subject, certificate, skip, model):
        return self.py._check(subject, certificate, skip, second=model)


class Run(vmodel_liars.Run):
    conditions, implied = CONDITIONS, {}

    def __init__(self, options):
        super().__init__(options)
        self.native.close()
        self.py, self.native = OfModels(self.py), Native(options.checker)

    @staticmethod
    def attacks(rng):
        for name, subject, certificate, model in inside_attacks(rng):
            yield name, Case(subject, model), certificate

    @staticmethod
    def honest_certificates(rng):
        plan = honest_plan(rng) if rng.random() < .5 else micro_spline_liars.honest_plan(rng)
        yield "inside", Case(plan.micro.text(), plan.model()), plan.certificate()

    def more(self, case):
        return (case.model,)


def missing_conditions(alone):
    return vmodel_liars.missing_conditions(alone, CONDITIONS)


if __name__ == "__main__":
    sys.exit(vmodel_liars.main(sys.argv[1:], Run, "micro_inside", CONDITIONS))
