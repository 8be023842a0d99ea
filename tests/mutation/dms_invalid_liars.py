#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against the checkers of the claim dms-invalid-1: findings about solids without a defect, and true findings in which one thing
is wrong. As vmodel_liars.py, whose harness this is. Run

    python3 tests/mutation/dms_invalid_liars.py --count 10000 --honest 1000 --seed 1 --checker PATH_TO_veritope-check
"""
import copy
import itertools
import sys
from fractions import Fraction as Q

import dms_invalid_findings as true
import dms_invalid_maps_liars as maps
import patch_attacks
import vmodel_liars
from dms_invalid_forge import NAMES, Invalid, add, is_inside, mix, turned, volume

# Needed alone; without D1, E2 fails.
CONDITIONS = ["B2", "B3", "D2", "E1", "E2", "E3", *("W%d" % kind for kind in range(len(NAMES)))]
HAIR = Q(1, 1 << 40)


# ---------------------------------------------------------------- solids without a defect

def any_face(model, rng):
    return rng.randrange(len(model.tetrahedra)), rng.randrange(4)


def any_gamma(model, rng):
    return rng.choice(model.indices())


def near(model, rng):
    """A point in the domain or near it."""
    u = true.point_of(model, rng.randrange(len(model.tetrahedra)), rng)
    return u if rng.random() < .8 else add(u, [Q(rng.randint(-9, 9)) for _ in range(3)])


def any_terms(model, rng):
    return [(any_gamma(model, rng), rng.randrange(4), Q(rng.randint(1, 9))) for _ in range(rng.randint(1, 4))]


def any_hull(model, rng):
    index = [0, 0, 0]
    for _ in range(model.last):
        index[rng.randrange(3)] += 1
    return {"f": rng.choice((any_face(model, rng), rng.choice(model.boundary()))), "index": index, "tet": rng.randrange(len(model.tetrahedra)),
            "weights": [Q(rng.choice((0, 1, 2, 5))) for _ in range(model.last + 3)]}


def any_witness(model, kind, rng):
    tet, other = (rng.randrange(len(model.tetrahedra)) for _ in range(2))
    a, b = (rng.randrange(len(model.clouds)) for _ in range(2))
    return ({"tet": tet}, {"f": any_face(model, rng), "g": any_face(model, rng)}, {"tet": tet, "gamma": any_gamma(model, rng)},
            {"tet": tet, "terms": any_terms(model, rng)}, any_hull(model, rng), {"u": near(model, rng)},
            {"tet": tet, "corners": model.corners(tet), "planes": []}, {"a": min(a, b), "b": max(a, b)}, {"v": a},
            {"f": any_face(model, rng), "g": any_face(model, rng), "w": some_weights(rng), "x": some_weights(rng)},
            {"tet": tet, "other": other, "u": near(model, rng)}, {"u": near(model, rng), "v": near(model, rng)})[kind]


def some_weights(rng):
    return [Q(rng.choice((0, 0, 1, 1, 2))) for _ in range(3)]


def without_defect(rng):
    """(model, lists)"""
    model, lists = true.some_clouded(rng)
    model.maps = [true.any_map(rng, model.degree, 1)] * len(model.clouds)
    return model, lists


def solids_without_defect(rng):
    model, lists = without_defect(rng)
    for kind in rng.sample(range(12), 6):
        yield "no_defect_%d" % kind, Invalid(model, kind, lists, **any_witness(model, kind, rng))


# ---------------------------------------------------------------- one thing is wrong: domains and clouds

def wrong_tets(rng):
    """W0: another tetrahedron than the reversed one."""
    finding = true.reversed_tet(rng)
    for t in range(len(finding.model.tetrahedra)):
        if volume(*finding.model.corners(t)) > 0:
            yield "W0_other", finding.changed(tet=t)
            break
    model, lists = without_defect(rng)
    yield "W0_none", Invalid(model, 0, lists, tet=rng.randrange(len(model.tetrahedra)))


def wrong_faces(rng):
    """W1: one face twice, two faces in opposite directions, two of other vertices."""
    finding = true.overused_face(rng)
    yield "W1_one_face", finding.changed(g=finding.witness["f"])
    yield "W1_other", finding.changed(g=(finding.witness["g"][0], (finding.witness["g"][1] + rng.randint(1, 3)) % 4))
    model = true.some_model(rng, "pair", "star", "cube")
    for f in sorted({(t, k) for t in range(len(model.tetrahedra)) for k in range(4)} - set(model.boundary()))[:1]:
        back = turned(model.face(f)[::-1])
        g = next((t, k) for t in range(len(model.tetrahedra)) for k in range(4) if turned(model.face((t, k))) == back)
        yield "W1_opposite", Invalid(model, 1, f=f, g=g)


def wrong_indices(rng):
    """W2: the index 0, one of a positive volume, one that no condition is about."""
    finding = true.degenerate_cloud(rng)
    model = finding.model
    yield "W2_zero", finding.changed(gamma=[0] * 4)
    reversed_one = true.reversed_tet(rng)
    yield "W2_zero_reversed", Invalid(reversed_one.model, 2, tet=reversed_one.witness["tet"], gamma=[0] * 4)
    t, gamma = rng.randrange(len(model.tetrahedra)), rng.choice(model.indices()[1:])
    if volume(*model.w(t, gamma)) > 0:
        yield "W2_positive", finding.changed(tet=t, gamma=gamma)
    yield "W2_above", finding.changed(gamma=[rng.choice((255, 128, model.degree + 1)) if i else 0 for i in finding.witness["gamma"]])
    yield "W2_last", beyond_last(finding)
    k, t = next(k for k in range(4) if finding.witness["gamma"][k]), finding.witness["tet"]
    lie = finding.changed()
    lie.model.set_knot(model.tetrahedra[t][k], max(finding.witness["gamma"]), mix([HAIR if i == k else 1 for i in range(4)], model.corners(t)))
    yield "W2_small", lie


def beyond_last(finding):
    """The knots that are in wrong places are the last ones, of which no condition is: the control points are shared."""
    finding = finding.changed()
    model, n = finding.model, finding.model.degree
    was_separate, model.separate = model.separate, False
    if was_separate and n == 1:                           # they have one knot or two
        model.clouds = [cloud[:2] for cloud in model.clouds]
    else:
        model.clouds = [cloud if len(cloud) == 1 else [cloud[0]] * n + [next((k for k in cloud if k != cloud[0]), cloud[0])] for cloud in model.clouds]
    above = lambda gamma: [n if i else 0 for i in gamma]      # noqa: E731
    if finding.kind == 2:
        finding.witness["gamma"] = above(finding.witness["gamma"])
    else:
        finding.witness["terms"] = [(above(gamma), m, y) for gamma, m, y in finding.witness["terms"]]
    return finding


def wrong_cores(rng):
    """W3: factors, indices and numbers of points that are others; sums that are positive or not constant."""
    finding = true.no_core(rng)
    model, terms = finding.model, finding.witness["terms"]
    gamma, m, y = terms[0]
    yield "W3_factor", finding.changed(terms=[(gamma, m, y * rng.choice((Q(1, 2), 3, 1 + HAIR))), *terms[1:]])
    yield "W3_negative", finding.changed(terms=[(gamma, m, -y), *terms[1:]])
    yield "W3_none", finding.changed(terms=[(gamma, m, Q(0))])
    yield "W3_fewer", finding.changed(terms=terms[1:])
    yield "W3_point", finding.changed(terms=[(gamma, (m + rng.randint(1, 3)) % 4, y), *terms[1:]])
    yield "W3_above", finding.changed(terms=[([model.degree + model.separate + 1 if i else 0 for i in gamma], m, y), *terms[1:]])
    yield "W3_last", beyond_last(finding)
    whole = [(gamma, m, Q(1)) for m in range(4)]          # the sum is d of the knots
    yield "W3_whole", finding.changed(terms=whole)
    bad = true.degenerate_cloud(rng)
    if volume(*bad.model.w(bad.witness["tet"], bad.witness["gamma"])) < 0:
        yield "W3_reversed", Invalid(bad.model, 3, tet=bad.witness["tet"], terms=[(bad.witness["gamma"], m, Q(1)) for m in range(4)])
    inner = set(range(len(model.clouds))) - true.outer_vertices(model)
    yield "W3_tetrahedron", finding.changed(tet=rng.choice([t for t, corners in enumerate(model.tetrahedra) if not inner <= set(corners)]))


def wrong_hulls(rng):
    """W4: faces inside of the domain, negative weights, points that are not inside, too many knots."""
    finding = true.inner_hull(rng)
    model, weights = finding.model, finding.witness["weights"]
    yield "W4_zero", finding.changed(weights=[Q(0)] * len(weights))
    yield "W4_negative", finding.changed(weights=[-w for w in weights])
    yield "W4_signs", finding.changed(weights=[-HAIR if i == 0 else w for i, w in enumerate(weights)])
    at = next(i for i, w in enumerate(weights) if w)
    yield "W4_outside", finding.changed(weights=[Q(int(i == at - 1)) for i in range(len(weights))])
    u = model.knot(model.face(finding.witness["f"])[at - 1], 1)
    for t in range(len(model.tetrahedra)):
        if not is_inside(model.corners(t), u):
            yield "W4_tetrahedron", finding.changed(tet=t)
            break
    yield "W4_count", finding.changed(index=[model.last + (i == at - 1) if i == at - 1 else 0 for i in range(3)], weights=[*weights, Q(0)])
    # A reversed tetrahedron has no inside.
    t = finding.witness["tet"]
    lie = copy.deepcopy(finding)
    lie.model.tetrahedra.append([model.tetrahedra[t][i] for i in (1, 0, 2, 3)])
    lie.witness["tet"] = len(model.tetrahedra)
    if finding.witness["f"] in lie.model.boundary():
        yield "W4_reversed", lie
    yield from inner_faces(rng)


def inner_faces(rng):
    """The hull of knots of a face inside of the domain, in which there are inner points of tetrahedra: no condition is about it."""
    model = true.with_clouds(rng, "star", "double", "cube", "pair")
    faces = sorted({(t, k) for t in range(len(model.tetrahedra)) for k in range(4)} - set(model.boundary()))
    f, t = rng.choice(faces), rng.randrange(len(model.tetrahedra))
    model.set_knot(model.face(f)[0], 1, mix(true.shares(rng, 4), model.corners(t)))
    yield "W4_inner_face", Invalid(model, 4, f=f, index=[model.last, 0, 0], tet=t, weights=[Q(i == 1) for i in range(model.last + 3)])


def wrong_edges(rng):
    """W7, W8: edges and vertices of surfaces, and those inside; an edge of four faces is one fan."""
    finding = true.edge_of_three(rng)
    a, b = finding.witness["a"], finding.witness["b"]
    yield "W7_descending", finding.changed(a=b, b=a)
    yield "W7_one_vertex", finding.changed(b=a)
    yield "W8_edge", Invalid(finding.model, 8, v=rng.choice((a, b)))
    model, fans = true.some_model(rng, "double", "cube", "pair"), true.two_fans(rng)
    t = rng.randrange(len(model.tetrahedra))
    a, b = sorted(rng.sample(model.tetrahedra[t], 2))
    yield "W7_no_defect", Invalid(model, 7, a=a, b=b)
    yield "W8_no_defect", Invalid(model, 8, v=rng.choice((a, b)))
    v = rng.choice([v for v in range(len(fans.model.clouds)) if v != fans.witness["v"]])
    yield "W8_other", fans.changed(v=v)
    yield "W7_two_fans", Invalid(fans.model, 7, a=min(v, fans.witness["v"]), b=max(v, fans.witness["v"]))
    model = true.some_model(rng, "star", "double")
    inner = sorted({*range(len(model.clouds))} - true.outer_vertices(model))
    yield "W7_inside", Invalid(model, 7, a=min(inner), b=rng.choice([v for v in range(len(model.clouds)) if v > min(inner)] or [min(inner)]))
    model.clouds.append([[Q(0)] * 3])                     # in no tetrahedron
    model.maps.append(model.maps[0])
    for v in (*inner, len(model.clouds) - 1):
        yield "W8_inside", Invalid(model, 8, v=v)


def wrong_contacts(rng):
    """W9: points of common vertices, other points, weights that are negative or all 0, faces that are not of the boundary."""
    finding = true.improper_point(rng)
    w, x = finding.witness["w"], finding.witness["x"]
    yield "W9_zero", finding.changed(w=[Q(0)] * 3)
    yield "W9_zeros", finding.changed(w=[Q(0)] * 3, x=[Q(0)] * 3)
    yield "W9_negative", finding.changed(w=[-c for c in w], x=[-c for c in x])
    yield "W9_point", finding.changed(x=[x[0] + HAIR, *x[1:]] if any(x[1:]) else [Q(0), Q(1), Q(0)])
    yield "W9_one_face", finding.changed(g=finding.witness["f"], x=w)
    yield "W9_inner_face", true.improper_point(rng, inner=True)
    model = true.some_model(rng)
    f, g = rng.sample(model.boundary(), 2)
    common = set(model.face(f)) & set(model.face(g))
    weights = {v: Q(rng.randint(1, 9)) for v in common}
    if common:
        both = [[weights.get(v, Q(0)) for v in model.face(number)] for number in (f, g)]
        yield "W9_common", Invalid(model, 9, f=f, g=g, w=both[0], x=both[1])
    # Neighbours in a plane: a point of one has a negative weight in the other.
    model = true.some_model(rng, "cube")
    for f in model.boundary():
        for g in model.boundary():
            a, b, c = (model.point(v) for v in model.face(f))
            others = [v for v in model.face(g) if v not in model.face(f)]
            if f != g and len(others) == 1 and volume(a, b, c, model.point(others[0])) == 0:
                u = mix([Q(1)] * 3, [model.point(v) for v in model.face(g)])
                w = shares_of(u, (a, b, c), rng)
                yield "W9_outside", Invalid(model, 9, f=f, g=g, w=w, x=[Q(1)] * 3)
                return


def shares_of(u, corners, rng):
    """The barycentric coordinates of a point of the plane of three points."""
    apex = add(corners[0], [Q(rng.randint(1, 9)) for _ in range(3)])
    while volume(*corners, apex) == 0:
        apex = add(corners[0], [Q(rng.randint(-9, 9)) for _ in range(3)])
    whole = volume(*corners, apex)
    return [volume(*[u if i == k else c for i, c in enumerate(corners)], apex) / whole for k in range(3)]


def wrong_overlaps(rng):
    """W10: one tetrahedron twice, a point of a common face, or of one of the two only; a reversed one."""
    finding = true.common_inner_point(rng)
    t, o = finding.witness["tet"], finding.witness["other"]
    yield "W10_one", finding.changed(other=t)
    yield "W10_outside", finding.changed(u=rng.choice(finding.model.corners(rng.choice((t, o)))))
    model = true.some_model(rng, "pair", "star", "double", "cube")
    numbers = [(t, o) for t in range(len(model.tetrahedra)) for o in range(t) if len(set(model.tetrahedra[t]) & set(model.tetrahedra[o])) == 3]
    t, o = rng.choice(numbers)
    common = [model.point(v) for v in model.tetrahedra[t] if v in model.tetrahedra[o]]
    yield "W10_face", Invalid(model, 10, tet=t, other=o, u=mix(true.shares(rng, 3), common))
    yield "W10_inner", Invalid(model, 10, tet=t, other=o, u=mix(true.shares(rng, 4), model.corners(t)))
    lie = copy.deepcopy(finding)
    corners = lie.model.tetrahedra[lie.witness["other"]]
    corners[0], corners[1] = corners[1], corners[0]
    yield "W10_reversed", lie


# ---------------------------------------------------------------- one thing is wrong: the rest

def a_map_finding(rng):
    return true.honest(rng.choice((5, 5, 6, 11, 12, 13)), rng)


def spoiled(rng):
    """D1 to E3: another part, far away, that breaks a condition by which s would be a map."""
    while True:
        finding = a_map_finding(rng)
        what = rng.choice(("D1", "D2", "E1", "E2", "E3"))
        make = {"D1": true.reversed_tet, "D2": true.overused_face, "E2": true.degenerate_cloud, "E3": true.inner_hull}.get(what)
        part = make(rng).model if make else true.some_model(rng, "pair", "star")
        if finding.model.degree == part.degree:
            break
    true.move(part, [Q(5000)] * 3)
    lie = finding.changed()
    lie.model.separate = part.separate = lie.model.separate or part.separate or what == "E1"
    if part.separate:
        for model in (lie.model, part):
            model.clouds = [cloud if len(cloud) == 1 else [*cloud, cloud[0]][:model.degree + 1] for cloud in model.clouds]
    count = len(lie.model.tetrahedra)
    lie.model = true.joined(lie.model, part)
    if what == "E1":                                      # a vertex of two tetrahedra
        first, *others = part.tetrahedra
        k = rng.choice([k for k in range(4) if any(first[k] in t for t in others)])
        betas = lie.model.gammas(part.degree)
        entry = count * len(betas) + betas.index(tuple(part.degree * (i == k) for i in range(4)))
        lie.model.apart = {entry: [rng.choice((HAIR, Q(1)))] * 3}
    lie.lists = [*lie.lists, *[[] for _ in range(len(lie.model.boundary()) - len(lie.lists))]]
    yield what + "_part", lie


def planes_left_out(rng):
    """E3: the planes beside the domain are missing, or others, and needed."""
    lists = None
    while not lists:
        model, lists = true.some_clouded(rng, "cube", "pair", degrees=(2, 2, 3))
    model.maps = [true.any_map(rng, model.degree, -1)] * len(model.clouds)
    middle = true.centre(model)
    cut = [[[*plane[:3], sum(a * b for a, b in zip(plane, middle))] for plane in planes] for planes in lists]
    for lists in (cut, [lists[-1], *lists[:-1]], [[] for _ in lists]):
        if not are_parted(model, lists):
            yield "E3_planes", Invalid(model, 5, lists, u=true.point_of(model, 0, rng))


def are_parted(model, lists):
    """E3"""
    axes = [[Q(i == k) for i in range(3)] for k in range(3)]
    for number, planes in zip(model.boundary(), lists):
        face = model.face(number)
        for index in [g[1:] for g in model.gammas(model.last) if not g[0]]:
            hull = [model.knot(v, k) for v, i in zip(face, index) for k in range(i + 1)]
            if all(knot in [model.point(v) for v in face] for knot in hull):
                continue
            for t in range(len(model.tetrahedra)):
                corners = model.corners(t)
                vectors = axes + [plane[:3] for plane in planes] + [true.normal_of(*three) for three in itertools.combinations(corners, 3)]
                fixed = [None] * 3 + [plane[3] for plane in planes] + [None] * 4
                if not any(parts(vector, at, hull, corners) for vector, at in zip(vectors, fixed)):
                    return False
    return True


def parts(vector, at, hull, corners):
    """Does the plane v.x = at, or one across v if it is None, part the hull from the corners?"""
    one, other = ([sum(a * b for a, b in zip(vector, p)) for p in points] for points in (hull, corners))
    if at is None:
        return max(one) <= min(other) or max(other) <= min(one)
    return max(one) <= at <= min(other) or max(other) <= at <= min(one)


def long_numbers(rng):
    """B2: a point with numbers that are too long, near the right one; a model with such numbers, or of degree 7."""
    finding = true.common_inner_point(rng)
    yield "B2_point", finding.changed(u=[c + Q(1, 3 ** 700) for c in finding.witness["u"]])
    finding = true.negative(rng)
    true.move(finding.model, [Q(1, 3 ** 170)] * 3)
    finding.lists = true.face_planes(finding.model)
    finding.witness["u"] = add(finding.witness["u"], [Q(1, 3 ** 170)] * 3)
    yield "B2_model", finding
    model = true.some_model(rng, "one", degrees=(7,))
    model.separate = False
    model.maps = [true.after(true.matrix(rng, -1), [0, 0, 0], (true.X, true.Y, true.Z))] * 4
    yield "B2_degree", Invalid(model, 5, u=mix(true.shares(rng, 4), model.corners(0)))


def wrong_statements(rng):
    """B3: the name of another kind, another number of tetrahedra."""
    finding = true.honest(rng.choice([k for k in range(len(NAMES)) if k not in (6, 12, 13)]), rng)
    name = rng.choice([name for name in NAMES if name != NAMES[finding.kind]])
    yield "B3_name", finding.told(values={"finding": name})
    yield "B3_count", finding.told(values={"tetrahedra": len(finding.model.tetrahedra) + rng.choice((1, 1 << 32))})


def malformed(rng):
    """B1, and what else bytes of another kind are."""
    finding = true.honest(rng.choice([k for k in range(len(NAMES)) if k not in (6, 12, 13)]), rng)
    body = finding.body()
    yield "cut_off", finding.told(body=lambda n=rng.randrange(len(body)): body[:n])
    yield "too_long", finding.told(tail=b"\0")
    yield "count", finding.told(count=rng.choice((0, len(finding.model.tetrahedra) + 1, (1 << 32) - 1)))
    yield "magic", finding.told(magic=rng.choice((b"VTDM", b"VTVI", b"vtdi")))
    kind = rng.choice([k for k in range(len(NAMES) + 1) if k != finding.kind])
    yield "kind_byte", finding.told(kind_byte=kind, values={"finding": NAMES[min(kind, len(NAMES) - 1)]})
    of_map, cores = true.negative(rng), true.no_core(rng)
    yield "faces", of_map.told(lists=rng.choice((of_map.lists[1:], [*of_map.lists, []])))
    yield "no_terms", cores.changed(terms=rng.choice(([], cores.witness["terms"][:1] * 5)))
    if "tet" in finding.witness:
        yield "no_tet", finding.changed(tet=len(finding.model.tetrahedra))


STRATEGIES = ((solids_without_defect, 8), (wrong_tets, 2), (wrong_faces, 3), (wrong_indices, 4), (wrong_cores, 6), (wrong_hulls, 6),
              (wrong_edges, 4), (wrong_contacts, 5), (wrong_overlaps, 4), (maps.wrong_points, 5), (maps.wrong_leaves, 5), (maps.wrong_meetings, 4),
              (maps.wrong_crossings, 8), (maps.crossings_without_defect, 4), (maps.wrong_coverings, 6), (maps.coverings_without_defect, 3),
              (spoiled, 12), (planes_left_out, 2), (long_numbers, 2), (wrong_statements, 2), (malformed, 1))


def told(strategy, rng):
    """(name, model, certificate)"""
    for name, lie in strategy(rng):
        data = lie.model.data()
        yield name, data, lie.certificate(data)


def dms_invalid_attacks(rng):
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    yield from told(strategy, rng)


def honest(rng):
    kind = rng.randrange(len(NAMES))
    finding = maps.negative_side(rng) if rng.random() < .05 else true.honest(kind, rng)
    data = finding.model.data()
    yield NAMES[finding.kind], data, finding.certificate(data)


class Run(vmodel_liars.Run):
    conditions, implied = CONDITIONS, {}

    @staticmethod
    def attacks(rng):
        return patch_attacks.subjects(dms_invalid_attacks(rng))

    @staticmethod
    def honest_certificates(rng):
        return patch_attacks.subjects(honest(rng))


def missing_conditions(alone):
    return vmodel_liars.missing_conditions(alone, CONDITIONS)


if __name__ == "__main__":
    sys.exit(vmodel_liars.main(sys.argv[1:], Run, "dms_invalid", CONDITIONS))
