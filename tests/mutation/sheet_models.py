# SPDX-License-Identifier: Apache-2.0 OR MIT
"""False models for the claims of version 2: (plan, why). Each is a sound solid of sheet_solids.py of which a part is moved, turned, open
or folded; the certificate is the honest one of the sound solid, or of each part alone."""
import random
from fractions import Fraction as Q

import patch_solids as ps
import sheet_conditions
import sheet_lies
import sheet_solids as ss
from patch_solids import UNIT
from sheet_plans import copied, joined, made, moved_points, settled_walks, shifted

HAIRS = [Q(0), Q(1, 1 << 400), Q(1, 1 << 60), Q(1, 1 << 40), Q(1, 1 << 20), Q(1, 1 << 10)]
GAPS = [Q(1, 16), Q(1, 64), Q(1, 1 << 10), Q(1, 1 << 16)]
WIDE = 16                                                 # of mesh boxes that have room for a control point far away


def drawn(rng, make, *args, **options):
    """(place, plan of the solid there). What is made once in a process depends on nothing that was drawn before."""
    number = rng.randrange(len(ss.MATRICES))
    place, key = ss.Place(random.Random(number), ss.MATRICES[number]), "%s %d %s %s" % (make.__name__, number, args, sorted(options.items()))
    return place, made(key, lambda: make(random.Random(number), place, *args, **options))


def degree(rng):
    return rng.choice((1, 1, 1, 1, 2, 3))


def plate(rng, **options):
    gap = rng.choice(GAPS)
    return gap, *drawn(rng, ss.stack, (gap,), ring=rng.choice(ss.RINGS), degree=1 if options else degree(rng), **options)


def plates(rng):
    gap = Q(1, 16)
    n = rng.choice((3, 3, 3, 3, 5))
    return gap, *drawn(rng, ss.stack, (gap,) * n, ring=rng.choice(ss.RINGS[:2]), degree=degree(rng))


def sound(rng):
    make = rng.choice((lambda: plate(rng)[2], lambda: plates(rng)[2], lambda: flat_plate(rng, False)[2],
                       lambda: drawn(rng, ss.poke, Q(1, 16), degree=degree(rng), way=rng.choice(("above", "cavity")))[1],
                       lambda: drawn(rng, ss.cavity, rng.choice(GAPS[:3]), degree=degree(rng))[1]))
    return make()


# ---------------------------------------------------------------- crossing and touching

def pulled_through(rng):
    """A corner of the upper wall a hair or more beyond the lower one. (On it, the plate would be a solid without that edge.)"""
    gap, place, plan = plate(rng)
    corners = [p for ring in ss.RINGS for p in ring if has_point(plan, place.point((*p, gap)))]
    x, y = rng.choice(corners)
    beyond = rng.choice(HAIRS[1:] + [gap / 8, gap])
    return moved_points(plan, place.point((x, y, gap)), place.point((x, y, -beyond))), "two walls cross"


def has_point(plan, p):
    return any(list(map(Q, t)) == list(p) for e in plan.entities for t in e["shape"]["points"])


def two_that_cross(rng):
    """A plate, and itself moved by less than its thickness."""
    gap, place, plan = plate(rng)
    x, y = rng.choice([(x, y) for x in (Q(-1, 4), 0, Q(1, 4), 6, -5) for y in (0, Q(1, 4))] + [(0, 5)])    # all rings still overlap
    v = x, y, gap * Q(rng.randint(1, 7), 8)
    return joined(plan, shifted(plan, of_vector(place, v))), "two plates cross"


def two_that_touch(rng):
    gap, place, plan = plate(rng)
    v = Q(0), Q(rng.randint(0, 4), 4), gap * rng.choice((1, -1))
    return joined(plan, shifted(plan, of_vector(place, v))), "two plates touch"


def of_vector(place, v):
    return [int(sum(a * x for a, x in zip(row, v)) * UNIT) for row in place.rows]


def plates_that_cross(rng):
    """The second of the plates, moved down on or into the first; its boxes stay, or go with it."""
    gap, place, plan = plates(rng)
    down, n = gap + rng.choice(HAIRS + [gap / 3, gap]), len(plan.entities) * 2 // (plan.values["shells"] * 2)
    v = Q(rng.randint(0, 1), 3), Q(0), -down
    by = [sum(a * x for a, x in zip(row, v)) for row in place.rows]
    new = copied(plan)
    for i in range(n, 2 * n):
        e = new.entities[i]
        points = [[str(Q(c) + d) for c, d in zip(p, by)] for p in e["shape"]["points"]]
        new.entities[i] = dict(e, shape=dict(e["shape"], points=points))
    return new, "two plates cross"


def poked(rng):
    """A tip on, or in, a face of another body; above it, or of a cavity below it."""
    place, plan = drawn(rng, ss.poke, Q(1, 16), degree=degree(rng), way=rng.choice(("above", "cavity")))
    is_cavity = not has_point(plan, place.point((0, 0, Q(1, 16))))
    apex = place.point((0, 0, Q(-1 if is_cavity else 1, 16)))
    return moved_points(plan, apex, place.point((0, 0, (1 if is_cavity else -1) * rng.choice(HAIRS + [Q(1, 16), Q(1, 8)])))), "a tip crosses a face"


def tip_on_a_face(rng):
    """The only plane between them is that of the face, and it has the tip."""
    place, plan = drawn(rng, ss.poke, Q(1, 16))
    plan = moved_points(plan, place.point((0, 0, Q(1, 16))), place.point((0, 0, 0)))
    both = plan.boxes[0]
    both.separators, both.signs = [], [[], []]
    both.separate(place.plane(0), 20, 2, 1)
    return plan, "a tip touches a face"


def nested_and_poking(rng):
    """A tip of a body that lies in another one, through its face: both normals point up."""
    return drawn(rng, ss.poke, -Q(1, 4), way="parallel")[1], "a tip crosses a face"


def far_centres(rng):
    """Such a tip and two boxes of one sheet, whose centres lie above and below them, beside the tip: the line between the centres crosses
    the face only."""
    place, plan = drawn(rng, ss.poke, -Q(1, 4), way="parallel")
    new = next(sheet_lies.merged_by_component(plan, rng))
    for box in new.boxes:
        if box.centres and box.lo == plan.boxes[0].lo:
            x = rng.choice((-2, 2, Q(3, 2)))
            box.centres, box.points_shift = [[ss.whole(place.point((x, 0, z))) for z in (-20, 20)]], None
    return new, "a tip crosses a face"


def z_fold(rng):
    return drawn(rng, ss.folded_roof, degree=degree(rng))[1], "a fold crosses itself"


def pinched_roof(rng):
    """A roof between a line and a parabola that touches it: the iso-line in the middle of the patch is mapped to their common point. Its
    certificate is that of a checker without part 2 of S1 for sides."""
    def make():
        eaves = [[(-1, 0, 0), (0, 0, 0), (1, 0, 0)], [(-1, 1, 0), (0, -1, 0), (1, 1, 0)]]
        floor = [[(x, y, -2) for x in (-2, 0, 2)] for y in (-2, 2)]
        rows = [list(zip(*eaves)), list(zip(floor[0], eaves[0])), list(zip(eaves[1], floor[1])), list(zip(*floor[::-1]))]
        ends = [[(floor[i][k], eaves[i][k]) for i in order] for k, order in ((0, (1, 0)), (2, (0, 1)))]
        prover = ss.forge2.Prover2([ss.forge.surface(r) for r in rows + ends], search=True, deepest=7)
        prover.plan.roots[0][:] = [1, 0]
        prover.forest = ss.nodes.Forest(prover.patches, 10 ** 9)
        with sheet_conditions.PARTS["C2"]["inner side"]():
            return prover.prove().plan
    return made("pinched roof", make), "an iso-line is a point"


def pulled_roof(rng):
    """A corner of a cavity on, or beyond, the outer wall."""
    gap = rng.choice(GAPS[:3])
    place, plan = drawn(rng, ss.cavity, gap, degree=degree(rng))
    x, y = rng.choice((-2, 2)), rng.choice((-2, 2))
    return moved_points(plan, place.point((x, y, 2 - gap)), place.point((x, y, 2 + rng.choice(HAIRS + [gap])))), "a cavity crosses the outer wall"


# ---------------------------------------------------------------- orientation

def inside_out(rng):
    """Flags turned over; the centres, too, or not; walks from the other side, or not."""
    plan = rng.choice((lambda: plate(rng)[2], lambda: plates(rng)[2], lambda: drawn(rng, ss.poke, Q(1, 16))[1]))()
    plan.flags = [1 - f for f in plan.flags]
    if rng.random() < .8:
        for box in plan.boxes:
            origin = box.centres[0][0] if box.centres else None
            box.centres = [pair[::-1] for pair in box.centres]
            box.points_shift = None
            if box.separators:                            # o is another point
                box.separators, box.signs = [moved_origin(q, box.centres[0][0], origin, box.exponent()) for q in box.separators], box.signs
    if rng.random() < .8:
        plan.walks = [(b, 1 - s, points, end if isinstance(end, int) else (end[0], 1 - end[1])) for b, s, points, end in plan.walks]
    return settled_walks(plan), "inside out"


def moved_origin(separator, old, new, exponent):
    """A separator of degree 1 for another o: its value at the old one becomes that at the new one."""
    n, t, c = separator
    if n > 1:
        return separator
    unit = Q(2) ** (exponent + t)
    first = c[0] - sum(c[1 + k] * (new[2 - k] - old[2 - k]) / unit for k in range(3))
    factor = first.denominator
    return [n, t, [int(first * factor), *[x * factor for x in c[1:]]]]


def one_inside_out(rng):
    """One of several bodies, all its patches reversed, in model or flags; the others are outward."""
    place, plan = drawn(rng, ss.poke, Q(1, 16))
    n = len(ss.slab(ss.RINGS[1], 0, 1))
    chosen = range(n) if rng.random() < .5 else range(n, len(plan.flags))
    plan.flags = [f ^ (i in chosen) for i, f in enumerate(plan.flags)]
    component = 0 if 0 in chosen else 1
    for i in (1 + component,):
        plan.boxes[i].centres = [pair[::-1] for pair in plan.boxes[i].centres]
        plan.boxes[i].points_shift = None
    both = plan.boxes[0]
    origin = both.centres[0][0]
    both.centres[component] = both.centres[component][::-1]
    both.points_shift = None
    both.separators = [moved_origin(q, both.centres[0][0], origin, both.exponent()) for q in both.separators]
    plan.walks = [(b, 1 - s, points, end) if b == 1 + component else (b, s, points, end) for b, s, points, end in plan.walks]
    return settled_walks(plan), "a body inside out"


def upside_down_in_a_cavity(rng):
    """Its walk ends at c- of the outer sheet, which lies in the cavity."""
    return drawn(rng, ss.cavity, Q(1, 16), upside_down=True)[1], "a body inside out in a cavity"


# ---------------------------------------------------------------- open, folded, not flat

def open_by_an_ulp(rng):
    place, plan = drawn(rng, rng.choice((ss.cavity, ss.poke)), Q(1, 16)) if rng.random() < .5 else plate(rng)[1:]
    new, i = copied(plan), rng.randrange(len(plan.entities))
    shape = new.entities[i]["shape"]
    points = [list(p) for p in shape["points"]]
    p, k = rng.randrange(len(points)), rng.randrange(3)
    points[p][k] = str(Q(points[p][k]) + rng.choice((-1, 1)) * Q(1, 1 << rng.choice((30, 52, 80, 400))))
    new.entities[i] = dict(new.entities[i], shape=dict(shape, points=points))
    if rng.random() < .7:                                 # the numbers that a checker without P1 would count
        new.values.update(ps.reader(copied(new)).counts)
    return new, "a gap along a side"


def with_middle(place, plan, move):
    """The lower wall (bilinear, patch 1) in degree two, its middle control point moved."""
    new = copied(plan)
    a, b, c, d = [[Q(x) for x in p] for p in new.entities[1]["shape"]["points"]]
    middle = [sum(x) / 4 + m for x, m in zip(zip(a, b, c, d), of_exact(place, move))]

    def mid(p, q):
        return [(x + y) / 2 for x, y in zip(p, q)]
    new.entities[1] = ss.forge.surface([[a, mid(a, b), b], [mid(a, c), middle, mid(b, d)], [c, mid(c, d), d]])
    return new


def of_exact(place, v):
    return [sum(a * x for a, x in zip(row, v)) for row in place.rows]


def flat_plate(rng, shared):
    gap = rng.choice(GAPS)
    return gap, *drawn(rng, ss.stack, (gap,), ring=ss.RINGS[1], wide=WIDE, shared=shared, at=(Q(13, 4), Q(13, 4)))


def folded(rng):
    """The middle control point of a square of side 8 in its plane, farther than 8 from the middle: the map turns over at a side."""
    gap, place, plan = flat_plate(rng, rng.random() < .5)
    far = 8 + rng.choice((Q(1, 1 << 40), Q(1, 4), 1, 4))
    return with_middle(place, plan, rng.choice(((far, 0, 0), (-far, 0, 0), (0, far, 0), (far, far, 0)))), "a patch is folded"


def bulging(rng):
    """A wall that is not flat and meets the other one: its middle is a quarter as low as its control point."""
    gap, place, plan = flat_plate(rng, rng.random() < .3)
    return with_middle(place, plan, (0, 0, 4 * (gap + rng.choice(HAIRS + [gap / 8])))), "a wall that bulges crosses another"


def dart(rng):
    """A corner of a square plate drawn in beyond the diagonal: the upper and the lower wall fold."""
    gap, place, plan = flat_plate(rng, rng.random() < .5)
    to = -4 + 4 + rng.choice((Q(1, 1 << 40), Q(1, 4), 1))
    for z in (Q(0), gap):
        plan = moved_points(plan, place.point((-4, -4, z)), place.point((to, to, z)))
    return plan, "a patch is folded"


MODELS = ((pulled_through, 5), (two_that_cross, 2), (two_that_touch, 2), (plates_that_cross, 3), (poked, 4), (nested_and_poking, 2), (far_centres, 1), (tip_on_a_face, 1), (z_fold, 2), (pinched_roof, .2),
          (pulled_roof, 2),
          (inside_out, 3), (one_inside_out, 2), (upside_down_in_a_cavity, 1), (open_by_an_ulp, 1), (folded, 2), (bulging, 2), (dart, 2))


def false_model(rng):
    """(name, plan)."""
    make, = rng.choices([m for m, _ in MODELS], [w for _, w in MODELS])
    return make.__name__, make(rng)[0]
