# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claims collar-1 and collar-2: cells that are no collar, or not of this surface, with the best collapse, sides and shores that there are."""
import copy
from fractions import Fraction as Q

import patch_solids as ps                                 # and the way to the forges
import collar_forge as forge
import collar_models as solids
import star_box_2_forge as forge2
import star_box_test as known

STAR, COMPLEXES = ps.forge, forge.complexes
WALL = solids.shell(((0,) * 3, (12,) * 3), ((4,) * 3, (8,) * 3))          # 26 cells of size 4
THICK = solids.shell(((0,) * 3, (20,) * 3), ((8,) * 3, (12,) * 3))        # 124 cells, two deep


class Surface:
    """What a Collar needs of a prover, of a proof that was mapped."""

    def __init__(self, proof):
        self.plan, self.model = proof.plan, STAR.encode_model(proof.entities)
        reader = ps.reader(proof.plan)
        self.patches, self.is_free = reader.patches, reader.is_free


def surface(*bricks):
    """Boxes (lo, hi, turned) in each other, proved together."""
    def make():
        entities = [e for lo, hi, turned in bricks for e in solids.brick(lo, hi, turned)]
        prover = known.AnySign(entities).prove()
        return ps.Proof(prover.plan).settle()
    return Surface(ps.made(("bricks", bricks), make))


def brick(lo, hi, turned=False):
    return surface(((lo,) * 3, (hi,) * 3, turned))


def collar(prover, cells, inner=None, corner=(-4,) * 3, shift=5, depth=0):
    """The best that there is: where the collapse gets stuck, its first steps; a shore through the surface where none is free."""
    made = forge.Collar(prover, corner, shift, depth)
    made.build(made.codes_of(cells), inner, shores=False, steps=False)
    for c in range(made.complex.num_components):
        try:
            made.plan.shores[c] = made.shore(c)
        except ValueError:
            pass
    return made


# ---------------------------------------------------------------- cells that are no collar of this surface

def cells_missing(rng):
    """The surface leaves |K| where a wall, one cell thick, has a hole, or many."""
    some = rng.sample(WALL, len(WALL) - rng.choice((1, 1, 2, 4, 12)))
    return collar(brick(2, 10), some)


def bumps_and_holes(rng):
    bumps = [(x, y, 12, 4) for x in (0, 4, 8) for y in (0, 4, 8) if rng.random() < .3]
    return collar(brick(2, 10), rng.sample(WALL, 25) + bumps)


def out_of_the_wall(rng):
    """The surface touches the boundary of K or crosses it."""
    lo, hi = rng.choice(((4, 10), (2, 8), (2, 12), (0, 10), (2, 14), (-2, 10), (2, 28), (-8, 40), (2, 7), (5, 10)))
    return collar(brick(lo, hi), WALL)


def at_the_wall_of_the_root(rng):
    prover = surface(((0, 2, 2), (10, 10, 10), False))
    return collar(prover, WALL, corner=(0, 0, 0), shift=4)


def kept(name, make):
    """A collar that takes long to build: once for each process."""
    return ps.made(("collar", name), lambda: Kept(make()))


class Kept:
    def __init__(self, made):
        self.plan, self.model, self.complex = made.plan, made.model, made.complex

    def copy(self):
        return copy.copy(self)


def coarse_hulls(rng):
    """Leaves of a ball that are not refined: the claim is true, but this does not prove it. 24 of the 114 hulls stick out, so some of those that stay coarse do."""
    def make():
        ball = ps.made("ball", lambda: ps.proved(ps.models.bicubic_ball(), ((0, 0, 0), Q(1, 3))))
        made = forge.Collar(Surface(ball), (-4,) * 3, 3, 2)
        return made.build(made.cells_at(5))
    made = kept("ball", make)
    made.plan = copy.deepcopy(made.plan)
    leaves = len(made.plan.finer)
    for i in rng.sample(range(leaves), leaves - rng.randrange(20)):
        made.plan.finer[i] = 1
    made.needs_its_hulls = True
    return made


def several_shells(rng):
    """Two, three or four in one collar, with orientations that fit or do not."""
    n, alternate = rng.choice((2, 3, 3, 4)), rng.random() < .7
    far = (Q(1), Q(2), Q(11, 4), Q(7, 2))[:n]
    turned = [alternate and i % 2 == 1 for i in range(n)]
    bricks = tuple(((4 - f,) * 3, (8 + f,) * 3, t) for f, t in zip(far[::-1], turned))
    return collar(surface(*bricks), WALL)


def two_collars_one_shell(rng):
    other = [(x + 16, y, z, s) for x, y, z, s in WALL]
    return collar(brick(2, 10), WALL + other, shift=6)


def handle(rng):
    def make():
        prover = Surface(ps.made("handle", lambda: ps.proved(solids.cube_with_a_handle())))
        return collar(prover, solids.cube_shell(-12, 12, -4, 4), corner=(-32,) * 3, shift=6)
    return kept("handle", make)


def small_torus(rng):
    """In a ball in a collar of a larger torus: every number is right."""
    def make():
        prover = STAR.Prover(solids.ring((0, 1, 2, 3), (0, 1, 2, 3), (5, 6))).prove()
        cells = [c for c in solids.shell(((-32, -32, -4), (32, 32, 8)), ((-16, -16, -4), (16, 16, 8))) if max(abs(c[0] + 2), abs(c[1] + 2)) != 24 or c[2]]
        core = {c for c in cells if c[2] == 0 and 20 < max(abs(c[0] + 2), abs(c[1] + 2)) < 28}
        ring = [(x - 24, y, z, s) for x, y, z, s in cells if (x, y, z, s) not in core]
        return collar(Surface(ps.Proof(prover.plan).settle()), ring, corner=(-64,) * 3, shift=7)
    return kept("small torus", make)


def inside_out(rng):
    return collar(brick(2, 10, True), WALL)


def touching_cells(rng):
    """Bumps that touch along an edge or its part, or in a vertex, or pits that do."""
    bumps = rng.choice((((4, 4, 20, 4), (8, 8, 20, 4)), ((4, 4, 20, 4), (8, 8, 20, 2)), ((4, 4, 20, 4), (8, 8, 20, 4), (8, 4, 20, 4), (4, 8, 24, 4)),
                        ((4, 4, 20, 2), (6, 6, 22, 2), (6, 4, 20, 2)), ((4, 4, 20, 4), (8, 8, 20, 1))))
    return collar(brick(2, 18), THICK + list(bumps))


def pits(rng):
    """In a wall three cells thick."""
    some = rng.choice((((12, 12, 32), (16, 16, 32)), ((12, 12, 32), (20, 16, 32), (20, 16, 28), (16, 16, 28))))
    cells = [c for c in solids.cube_shell(0, 36, 12, 24) if c[:3] not in some]
    return kept(some, lambda: collar(brick(10, 26), cells, inner=True, corner=(-4,) * 3, shift=6))


def tunnel(rng):
    """From the outside to the outside, in a wall three cells thick, above the surface."""
    gone, inner = [(8, 8, z) for z in (28, 24)] + [(12, 8, 24), (16, 8, 24), (16, 8, 28)], rng.choice((True, False))
    cells = [c for c in solids.cube_shell(-4, 32, 8, 20) if c[:3] not in gone]
    return kept(("tunnel", inner), lambda: collar(brick(2, 22), cells, inner, corner=(-4,) * 3, shift=6))


FALSE = ((cells_missing, 6), (bumps_and_holes, 2), (out_of_the_wall, 4), (at_the_wall_of_the_root, 1), (coarse_hulls, .05), (several_shells, 5),
         (two_collars_one_shell, 1), (handle, .1), (small_torus, .05), (inside_out, 1), (touching_cells, 1), (pits, .1), (tunnel, .1))


# ---------------------------------------------------------------- what a prover could bend

def bent(made, rng):
    plan = made.plan
    yield "plain", plan

    def new(**fields):
        other = copy.copy(plan)
        other.values = dict(plan.values)
        for key, value in fields.items():
            setattr(other, key, value)
        return other
    yield "sides", new(sides=[1 - s for s in plan.sides])
    yield "sides", new(sides=[rng.randint(0, 2) for _ in plan.sides])
    yield "sides", new(sides=plan.sides + [0], shores=plan.shores + [([], 0)])
    for change in (plan.collapses[::-1], rng.sample(plan.collapses, len(plan.collapses)), [rng.randrange(4 * len(plan.codes)) for _ in plan.codes]):
        yield "collapses", new(collapses=change)
    ends = [(i, s) for i, b in enumerate(plan.boxes) if b.kind == 0 for s in (0, 1)]
    for _ in range(3):
        yield "shores", new(shores=[([], rng.choice([rng.randrange(6), rng.choice(ends)])) for _ in plan.shores])
    yield "hulls", new(finer=[1] * len(plan.finer))
    if not getattr(made, "needs_its_hulls", False):  # they may be enough
        yield "hulls", new(finer=[[1] * 4 for _ in plan.finer])
    codes = sorted({*plan.codes, rng.choice(plan.codes) + rng.choice((1, 2, -2, 1 << 40))} - {0})
    yield "cells", with_codes(new, plan, codes)
    yield "cells", with_codes(new, plan, [c for c in plan.codes if rng.random() > .05] or plan.codes[:1])
    inside = [COMPLEXES.code_of(p, size // 2) for p, size in (COMPLEXES.cell_of(c) for c in rng.sample(plan.codes, 1))]
    yield "cells", with_codes(new, plan, sorted({*plan.codes, *inside}))
    yield "cells", new(values=dict(plan.values, cells=plan.values["cells"] + rng.choice((1, -1, 1 << 30))))
    for key in ("genus", "shells", "bodies", "vertices"):
        yield "numbers", new(values=dict(plan.values, **{key: plan.values[key] + 1}))


def with_codes(new, plan, codes):
    steps = (plan.collapses + [0] * len(codes))[:len(codes)]
    return new(codes=codes, collapses=steps, values=dict(plan.values, cells=len(codes)))


def collar_attacks(rng):
    make, = rng.choices([m for m, _ in FALSE], [w for _, w in FALSE])
    if rng.random() < .06:
        yield from rng.choice((lies_about_a_collar, lies_about_a_collar_2))(rng)
        return
    made = make(rng)
    for name, plan in bent(made, rng):
        yield "%s/%s" % (make.__name__, name), made.model, plan.certificate(made.model)


def lies_about_a_collar(rng):
    """The collar is a true one; cells that it needs are left out, its numbers are changed, its collapses are wrong."""
    made = collar(brick(2, 10), WALL)
    plan = made.plan
    outer = [n for n, c in made.complex.component_of.items() if plan.sides[c] == 1]
    for name, fields in (("order", dict(collapses=plan.collapses[::-1])), ("order", dict(collapses=[plan.collapses[0]] * 26)),
                         ("order", dict(collapses=outer[:1] + plan.collapses[1:])), ("sides", dict(sides=[1, 1])), ("sides", dict(sides=[0, 0])),
                         ("shores", dict(shores=[plan.shores[0]] * 2)), ("shores", dict(shores=[([], e) for e in (0, 1)]))):
        other = copy.copy(plan)
        other.values = dict(plan.values)
        for key, value in fields.items():
            setattr(other, key, value)
        yield "collar/" + name, made.model, other.certificate(made.model)
    for key in ("cells", "genus", "shells", "edges"):
        other = copy.copy(plan)
        other.values = dict(plan.values, **{key: plan.values[key] + 1})
        yield "collar/numbers", made.model, other.certificate(made.model)


def lies_about_a_collar_2(rng):
    """What lies_about_a_collar says, about the star boxes of the brick in the form of version 2."""
    made = collar(brick(2, 10), WALL)
    star = forge2.to_version_2(made.plan)
    for name, model, certificate in lies_about_a_collar(rng):
        yield name + "-2", model, in_version_2(made, certificate, star)


def in_version_2(made, certificate, star):
    """The certificate of version 2 with the collar of one of version 1 that has the same star boxes."""
    statement, body = certificate.split(b"\n", 1)
    plan = copy.copy(star)
    plan.tail = body[len(STAR.Plan.body(made.prover.plan)):]
    plan.values = {k: v for k, v in STAR.json.loads(statement).items() if k in made.plan.values}
    plan.values["claim"] = "collar-2"
    return plan.certificate(made.model)


def honest(rng):
    """A brick somewhere in its walls, at some place of the root."""
    lo, hi = Q(rng.randint(1, 15), 4), 8 + Q(rng.randint(1, 15), 4)
    corner, shift = rng.choice((((-4,) * 3, 5), ((0, 0, 0), 4), ((-16, -12, -8), 5), ((-100, -36, 0), 7)))
    bumps = [(4, 4, 12, rng.choice((1, 2, 4)))] if corner[2] < 0 and rng.random() < .5 else []
    made = forge.Collar(brick(lo, hi), corner, shift)
    return made.build(made.codes_of(WALL + bumps), rng.choice((None, None, True)))
