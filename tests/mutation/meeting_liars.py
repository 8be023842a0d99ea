# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Liars for the claim patch-invalid-2: sound models, with places that are one point of X or that look like two with one
image, and wrong witnesses about models that are unsound."""
from fractions import Fraction as Q

import invalid_liars as first                             # and the way to the forges
import patch_solids as ps
import patch_invalid_2_forge as forge
import patch_invalid_2_models as models2

MODELS, STAR, Meeting, changed, sound = first.MODELS, first.STAR, forge.Meeting, first.changed, first.sound
HALF, TOP = Q(1, 2), 1 << 63


# ---------------------------------------------------------------- what the strategies share

def inside(rng, longest=TOP - 1):
    """A number strictly between 0 and 1."""
    d = rng.choice((2, 3, 4, 7, 12, 1 << 20, 10 ** 9, longest))
    return Q(rng.randint(1, d - 1), d)


def other_ways(t, rng):
    """A rational as (n, d), not always in lowest terms."""
    k = rng.randint(1, (TOP - 1) // t.denominator)
    return t.numerator * k, t.denominator * k


def plain_box(lo, hi):
    """Six bilinear faces."""
    return ps.box_solid(first.NoChoice, lo, hi).entities


def located(face, p):
    """The parameters of a point in the plane of a bilinear rectangle."""
    (a, c), (b, _) = forge.rows_of(face)

    def along(q):
        way = [y - x for x, y in zip(a, q)]
        return sum(w * (y - x) for w, x, y in zip(way, a, p)) / sum(w * w for w in way)
    return along(b), along(c)


def on(entities, axis, value):
    """The number of the face in this plane."""
    return first.face_at(entities, axis, value)


def at_point(entities, n, p):
    return (n, *located(entities[n], p))


def moved(finding, rng):
    """At a random place; parameters stay what they are."""
    return changed(finding, entities=first.at_random(finding.entities, rng))


def twice(rng):
    """(Meeting, number of entities before): a solid, one of whose patches comes once more, at its end."""
    entities = sound(rng)
    n = rng.randrange(len(entities))
    u, v = inside(rng), inside(rng)
    return Meeting(entities + [entities[n]], (n, u, v), (len(entities), u, v))


def named_points(entities, t):
    """Lists of the border places that have one image, where there are several."""
    along, named = sorted({0, t, 1 - t, 1}), {}
    places = sorted({(end, c) for end in (0, 1) for c in along} | {(c, end) for end in (0, 1) for c in along})
    for n, entity in enumerate(entities):
        for u, v in places:
            named.setdefault(forge.point(entity, u, v), []).append((n, u, v))
    return [places for places in named.values() if len(places) > 1]


# ---------------------------------------------------------------- sound models: one point of X

def two_sides_of_an_edge(rng):
    """One point of an edge, of a corner of several patches, of a pole, in two places."""
    entities = sound(rng)
    groups = named_points(entities, rng.choice((HALF, Q(1, 3), Q(1, 1 << 40))))
    for places in rng.sample(groups, min(6, len(groups))):
        a, b = rng.sample(places, 2)
        yield Meeting(entities, a, b)


def one_place_written_twice(rng):
    entities = sound(rng)
    n, u, v = rng.randrange(len(entities)), inside(rng), inside(rng)
    for a, b in (((n, u, v), (n, u, v)), ((n, u, v), (n, other_ways(u, rng), other_ways(v, rng))),
                 ((n, other_ways(u, rng), v), (n, u, other_ways(v, rng)))):
        yield Meeting(entities, a, b)


def an_inner_break(rng):
    """A point of a line on which a face is cut, in the patches on both sides of it, and on all four at a crossing."""
    entities = sound(rng)
    i = rng.randrange(len(entities))
    finding = Meeting(entities, (i, HALF, 1), (i + 1, HALF, 0))
    if entities[i]["kind"] == "triangle":
        return
    cuts = [Q(0), HALF, Q(1)]
    finding.breaks = [[cuts, cuts] if n == i else axes for n, axes in enumerate(finding.breaks)]
    t = inside(rng)
    for a, b in (((i, t, 1), (i + 1, t, 0)), ((i, 1, t), (i + 2, 0, t)), ((i, 1, 1), (i + 3, 0, 0)),
                 ((i + 1, 1, 0), (i + 2, 0, 1)), ((i, t, HALF), (i, other_ways(t, rng), (2, 4)))):
        yield changed(finding, a=a, b=b)


def first_corner_of_triangles(rng):
    """s = 0 is one corner whatever t is: of one triangle with two t, of two triangles; and with an inner point as A."""
    entities = first.at_random(rng.choice((MODELS.tetrahedron, MODELS.cubic_octahedron))(), rng)
    n = rng.randrange(len(entities))
    t = inside(rng)
    yield Meeting(entities, (n, 0, t), (n, 0, 1 - t if t != HALF else Q(1, 3)))
    for m, entity in enumerate(entities):
        if m != n and forge.point(entity, 0, t) == forge.point(entities[n], 0, t):
            yield Meeting(entities, (n, 0, t), (m, 0, t))
    yield Meeting(entities, (n, inside(rng), t), (n, 0, t))


def a_on_the_border(rng):
    """The honest meeting with B's place, on a border or a corner, as A: what M1 asks for is not symmetric."""
    for name, finding in models2.honest():
        if "border" in name or "corner" in name or name == "triangles":
            yield moved(changed(finding, a=finding.b, b=finding.a), rng)


# ---------------------------------------------------------------- sound models: two points with two images

def random_places(rng):
    entities = sound(rng)
    ends = (0, 1, (0, 9), (9, 9))
    for _ in range(4):
        a, b = [[rng.choice((rng.randrange(len(entities)), 0)), inside(rng), inside(rng)] for _ in range(2)]
        if rng.random() < .5:
            b[1:] = a[1:] if rng.random() < .5 else a[:0:-1]
        if rng.random() < .5:
            b[rng.choice((1, 2))] = rng.choice(ends)
        if a != b:
            yield Meeting(entities, tuple(a), tuple(b))


def seen_along_an_axis(rng):
    """Points of opposite faces of a box that agree in two coordinates, and ones of the same face that agree in one."""
    lo, hi = [rng.randint(-4, 0) for _ in range(3)], [rng.randint(1, 4) for _ in range(3)]
    entities = plain_box(lo, hi)
    for axis in range(3):
        p = [a + inside(rng) * (b - a) for a, b in zip(lo, hi)]
        places = []
        for value in (lo[axis], hi[axis]):
            p[axis] = value
            places.append(at_point(entities, on(entities, axis, value), p))
        yield Meeting(entities, *places)
        n, u, v = places[0]
        yield Meeting(entities, (n, u, v), (n, u, 1 - v if v != HALF else Q(1, 3)))


def a_hair_apart(rng):
    """A box above another one, with a gap: the places are one point as soon as the gap is 0."""
    gap = rng.choice((Q(1, 1 << 20), Q(1, 1 << 52), Q(1, 1 << 300), Q(1, 3), Q(5)))
    x, y = [1 + 2 * inside(rng, 1 << 60) for _ in range(2)]
    entities = plain_box((0, 0, 0), (4, 4, 4)) + plain_box((1, 1, 4 + gap), (3, 3, 6))
    a = at_point(entities, on(entities[:6], 2, 4), (x, y, 4))
    b = at_point(entities, 6 + on(entities[6:], 2, 4 + gap), (x, y, 4 + gap))
    axes, signs, scales, shift = ps.random_map(rng)
    entities = [ps.mapped_entity(e, axes, signs, scales, shift) for e in entities]
    yield Meeting(entities, a, b)
    yield Meeting(entities, b, a)


def outside_of_the_domain(rng):
    """A face of one box, continued beyond its border, passes through the other box: n is greater than d."""
    entities = plain_box((0, 0, 0), (4, 4, 4)) + plain_box((6, 1, 1), (8, 3, 3))
    for n in range(6, 12):
        for u, v in ((2, HALF), (HALF, 2)):
            p = forge.point(entities[n], u, v)
            if p[0] == 4 and 0 < p[1] < 4 and 0 < p[2] < 4:
                yield moved(Meeting(entities, at_point(entities, on(entities[:6], 0, 4), p), (n, u, v)), rng)
    yield Meeting(entities, (0, HALF, HALF), (7, HALF, (0, 0)))
    yield Meeting(entities, (0, (1, 0), HALF), (7, HALF, HALF))


# ---------------------------------------------------------------- wrong witnesses about unsound models

def slightly_off(rng):
    """A patch that comes twice, with parameters that are equal but for a hair, or exchanged."""
    finding = twice(rng)
    (n, u, v), (m, _, _) = finding.a, finding.b
    off = rng.choice((Q(1, 1 << 20), Q(1, 1 << 61)))
    for s, t in ((u + off, v), (u, v - off), (u, (v + 1) / 2), (u / 2, v), (u, 0), (1, v), (0, 1)):
        if 0 <= s <= 1 and 0 <= t <= 1 and max(s.denominator, t.denominator) < TOP:
            yield changed(finding, b=(m, s, t))
            if 0 < s < 1 and 0 < t < 1:
                yield changed(finding, a=(n, s, t))


def another_patch(rng):
    """Another number, one that does not exist, or A's patch for B, too."""
    finding = twice(rng)
    (n, u, v), (m, _, _) = finding.a, finding.b
    for k in {rng.randrange(m) for _ in range(3)} - {n}:
        yield changed(finding, a=(k, u, v))
        yield changed(finding, b=(k, u, v))
    yield changed(finding, b=finding.a)
    yield changed(finding, a=finding.b)
    for k in (m + 1, 1 << 32, TOP - 1):
        yield changed(finding, a=(k, u, v))
        yield changed(finding, b=(k, u, v))


def wrong_numbers(rng):
    """Counts of the statement, a flag that it does not count, N and kinds that are not the model's, a byte too many."""
    finding = twice(rng)
    count = len(finding.entities)
    for values in ({"patches": count - 1}, {"patches": count + 1}, {"flipped": 1}, {"patches": 0}):
        yield changed(finding, values=values)
    flags = list(finding.flags)
    flags[rng.randrange(count)] ^= 1
    yield changed(finding, flags=flags, values={"flipped": 0})
    yield changed(finding, flags=flags, values={"flipped": count})
    kinds = list(finding.kinds)
    kinds[rng.randrange(count)] = rng.choice((0, 3))
    yield changed(finding, kinds=kinds)
    yield changed(finding, kinds=[3 - k for k in finding.kinds])
    yield changed(finding, kinds=[*finding.kinds[:-1]], flags=finding.flags[:-1])
    yield changed(finding, tail=b"\0")


def first_corner_on_a_plate(rng):
    """A triangle stands on a plate with its first corner."""
    plate, at = models2.plate(), (Q(1, 3), Q(2, 5))
    corner = forge.point(plate, *at)
    entities = first.at_random([plate, STAR.triangle([corner, (5, 5, 5), (1, 1, 9)])], rng)
    for t in (0, 1, inside(rng)):
        yield Meeting(entities, (0, *at), (1, 0, t))


def torn(rng):
    """A surface that jumps back to its start: two patches in one place, but is it one surface?"""
    rows = [[(x, y, 0) for y in (0, 1)] for x in (0, 1, 0, 1)]
    surface = STAR.surface(rows, (1, 1), [[0, 0, 1, 1, 2, 2], [0, 0, 1, 1]])
    u, v = inside(rng), inside(rng)
    yield moved(Meeting([surface], (0, u, v), (1, u, v)), rng)
    finding = twice(rng)
    yield Meeting(finding.entities + [surface], finding.a, finding.b)


def bodies_of_the_other_version(rng):
    """What one version can refute, in the layout of the other, or under its name."""
    finding = twice(rng)
    yield changed(finding, magic=b"VTPI")
    yield changed(finding, body=old_body(finding))
    yield changed(finding, body=lambda: b"VTI2" + old_body(finding)()[4:])
    reverse = first.forge.Finding(finding.entities)
    reverse.body = finding.body
    yield reverse
    yield changed(reverse, body=lambda: b"VTPI" + finding.body()[4:])
    yield changed(finding, values={"finding": rng.choice(("crossing", "side"))})


def old_body(finding):
    """A crossing of version 1 at the places, which are no boxes."""
    old = first.forge.Finding(finding.entities)
    old.pair = [(n, (2, 1, 3), (2, 2, 2) if n == finding.a[0] else (2, 1, 3)) for n, _, _ in (finding.a, finding.b)]
    old.y = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    return old.body


STRATEGIES = (two_sides_of_an_edge, two_sides_of_an_edge, one_place_written_twice, an_inner_break,
              first_corner_of_triangles, a_on_the_border, random_places, random_places, seen_along_an_axis, a_hair_apart,
              outside_of_the_domain, slightly_off, slightly_off, another_patch, wrong_numbers, first_corner_on_a_plate,
              torn, bodies_of_the_other_version)


def meeting_attacks(rng):
    strategy = rng.choice(STRATEGIES)
    for finding in strategy(rng):
        model = STAR.encode_model(finding.entities)
        yield strategy.__name__, model, finding.certificate(model)


def honest(rng):
    """(name, Meeting): a patch twice, or one of the small models."""
    yield "meeting", twice(rng)
    yield "meeting", moved(rng.choice(list(models2.honest()))[1], rng)
