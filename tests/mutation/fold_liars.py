# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claim volume-folded-1: volumes that do not fold, and wrong points, pieces and numbers about volumes that do."""
from fractions import Fraction as Q

import patch_solids                                       # noqa: F401  the way to the forges
import model_texts as texts
import volume_folded_forge as forge

Fold, TOP = forge.Fold, 1 << 63
FORMATS = ("vjson", "itd", "g2", "mfem")


# ---------------------------------------------------------------- what the strategies share

def number(rng):
    """A number of a piece: an end, or a fraction."""
    return rng.choice((0, 1, Q(1, 2), Q(rng.randint(0, 12), 12), Q(1, 1 << 40), (3, 9)))


def somewhere(m, rng):
    return tuple((rng.randrange(len(set(knots)) - 1), number(rng)) for knots in m.knots)


def in_space(m, rng):
    """The volume after an affine map of space and of its parameters, its weights times a factor. (volume, is_mirrored)"""
    axes, signs = rng.sample(range(3), 3), [rng.choice((1, -1)) for _ in range(3)]
    shift, scale = [Q(rng.randint(-9, 9), 4) for _ in range(3)], rng.choice((1, 2, Q(1, 8)))
    factor = rng.choice((1, 3, Q(1, 4))) if m.rational else 1
    points = []
    for p in m.points:
        w = p[3] if m.rational else 1
        q = [factor * (s * scale * p[a] + w * c) for a, s, c in zip(axes, signs, shift)]
        points.append((*q, factor * w) if m.rational else q)
    a, b = rng.choice((1, 2, 5)), rng.randint(-3, 3)
    is_odd = (sum(axes[i] > axes[j] for i in range(3) for j in range(i + 1, 3)) + signs.count(-1)) % 2 == 1
    return texts.Map(m.degrees, [[a * t + b for t in knots] for knots in m.knots], points, m.rational), is_odd


def sheared(rng):
    """A volume that does not fold: a box with inner knots on an axis, after (x, y, z) -> (x, y + f(x), z + g(x, y))."""
    p, inner = rng.randint(1, 3), sorted(rng.sample((1, 2, 3), rng.randint(0, 2)))
    m = forge.graph(forge.with_knots(p, inner), lambda t: t)
    bends = {x: rng.randint(-3, 3) for x in {q[0] for q in m.points}}
    m = texts.Map(m.degrees, m.knots, [(x, y + bends[x], z + 2 * y) for x, y, z in m.points])
    return forge.made_rational(m) if rng.random() < .3 else m


def flat_at_an_end(rng):
    """A box whose face u = 0 is an edge: det J is 0 there, and positive elsewhere."""
    m = forge.cube(lambda p: (p[0], p[0] * p[1], p[2]))
    return forge.made_rational(m) if rng.random() < .3 else m


def told(maps, a, b, rng, entity=0):
    return Fold(maps, a, b, entity, rng.choice(FORMATS))


def folded(rng):
    """A true fold, at a random place in space."""
    fold = rng.choice(list(forge.honest()))[1]
    maps = list(fold.maps)
    maps[fold.entity], is_mirrored = in_space(maps[fold.entity], rng)
    return told(maps, *((fold.b, fold.a) if is_mirrored else (fold.a, fold.b)), rng, fold.entity)


def changed(fold, **fields):
    out = Fold(fold.maps, fold.a, fold.b, fold.entity, fold.subject_format)
    out.text = fold.model()
    for key, value in fields.items():
        setattr(out, key, value)
    return out


# ---------------------------------------------------------------- volumes that do not fold

def sound_volumes(rng):
    m, _ = in_space(rng.choice((sheared, flat_at_an_end))(rng), rng)
    fold = told([m], forge.FIRST, forge.LAST, rng)
    for _ in range(5):
        yield changed(fold, a=somewhere(m, rng), b=somewhere(m, rng))


def another_hand(rng):
    """Two volumes of different hands: each keeps its own."""
    m = sheared(rng)
    mirrored = texts.Map(m.degrees, m.knots, [(-p[0], *p[1:]) for p in m.points], m.rational)
    maps = [m, mirrored] if rng.random() < .5 else [mirrored, m]
    fold = told(maps, forge.FIRST, forge.LAST, rng)
    for entity in (0, 1):
        yield changed(fold, entity=entity, a=somewhere(m, rng), b=somewhere(m, rng))


def zero_determinants(rng):
    """One of the two is 0: where the volume is an edge, or everywhere."""
    fold = Fold([flat_at_an_end(rng)], subject_format=rng.choice(FORMATS))
    zero, right = ((0, 0), *somewhere(fold.maps[0], rng)[1:]), ((0, 1), *somewhere(fold.maps[0], rng)[1:])
    yield changed(fold, a=right, b=zero)
    mirrored = texts.Map(fold.maps[0].degrees, fold.maps[0].knots, [(-p[0], *p[1:]) for p in fold.maps[0].points], fold.maps[0].rational)
    yield changed(Fold([mirrored], subject_format=rng.choice(FORMATS)), a=zero, b=right)
    yield Fold([forge.cube(lambda p: (p[0], p[1], p[0]))], somewhere(forge.cube(), rng), somewhere(forge.cube(), rng))


# ---------------------------------------------------------------- wrong certificates about volumes that fold

def equal_signs(rng):
    fold = folded(rng)
    yield changed(fold, a=fold.b)
    yield changed(fold, b=fold.a)
    yield changed(fold, a=fold.b, b=fold.a)


def wrong_side_of_a_knot(rng):
    ridge = forge.graph(forge.with_knots(1, [1]), lambda t: t if t <= 1 else 2 - t)
    rest = somewhere(ridge, rng)[1:]
    left, right = ((0, 1), *rest), ((1, 0), *rest)
    fold = told([ridge], left, right, rng)
    for a, b in ((left, left), (right, right), (right, left)):
        yield changed(fold, a=a, b=b)


def no_such_place(rng):
    """Points outside of the domain, pieces that do not exist, quotients by 0, numbers that are too long."""
    fold = folded(rng)
    for bad in ((9, 0), (TOP - 1, 1), (TOP, 0), (0, (0, 0)), (0, (1, 0)), (0, (2, 1)), (0, (TOP - 1, 1)), (0, (TOP, TOP)), (0, ((1 << 64) - 1, 1 << 63))):
        point = list(rng.choice((fold.a, fold.b)))
        point[rng.randrange(3)] = bad
        yield changed(fold, **{rng.choice("ab"): tuple(point)})


def wrong_counts(rng):
    fold = folded(rng)
    n = len(fold.maps)
    for entity in (n, n + 1, 1 << 32, TOP):
        yield changed(fold, entity=entity, values={"entity": fold.entity})
    for values in ({"entity": fold.entity + 1}, {"volumes": n + 1}, {"volumes": 0}):
        yield changed(fold, values=values)
    for count in (0, n + 1, (1 << 32) - 1):
        yield changed(fold, count=count)
    yield changed(fold, tail=b"\0")
    yield changed(fold, magic=rng.choice((b"VTI2", b"VTPI", b"vtvf")))


def cut_off(rng):
    fold = folded(rng)
    body = fold.body()
    for n in sorted(rng.sample(range(len(body)), 4)):
        yield changed(fold, body=lambda n=n: body[:n])


def over_the_limits(rng):
    """A degree of 16; long knots; long numbers of control points that have short ones each."""
    x = [0, 9, *range(2, 14), 7, 16, 17]
    high = forge.bezier((16, 1, 1), lambda u, v, w: (x[int(16 * u)], v, w))
    places = {forge.sign(high, p): p for p in [((0, Q(i, 16)), forge.BEGIN, forge.END) for i in range(17)]}
    yield told([high], places[1], places[-1], rng)
    m, knots = forge.folded_cube(), rng.choice(([0, 0, (1 << 256) + 1] + [(1 << 256) + 1], [0, 0] + [Q(1, 1 << 256)] * 2))
    yield told([texts.Map(m.degrees, [m.knots[0], knots, m.knots[2]], m.points)], forge.FIRST, forge.LAST, rng)
    small = {(1, 0, 0): Q(1, 1 << 4100), (0, 1, 0): Q(1, 3 ** 2600)}
    yield Fold([forge.cube(lambda p: (0, 0, 0) if p == (1, 1, 1) else (*p[:2], p[2] + small.get(p, 0)))])


def of_another_claim(rng):
    fold = folded(rng)
    yield changed(fold, claim="volume-folded-2")
    yield changed(fold, values={"subject_format": fold.subject_format + "-faces"})
    yield changed(fold, values={"finding": "fold"})


STRATEGIES = (sound_volumes, sound_volumes, sound_volumes, another_hand, zero_determinants, equal_signs, wrong_side_of_a_knot, no_such_place,
              wrong_counts, cut_off, over_the_limits, of_another_claim)


def fold_attacks(rng):
    strategy = rng.choice(STRATEGIES)
    for fold in strategy(rng):
        model = fold.model()
        yield strategy.__name__, model, fold.certificate(model)


def honest(rng):
    """(name, model, certificate)"""
    fold = folded(rng)
    yield "fold", fold.model(), fold.certificate()
