# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lies of dms_invalid_liars.py about maps: findings of the kinds 5, 6 and 11 to 13 in which one thing is wrong."""
import itertools
from fractions import Fraction as Q

import dms_invalid_findings as true
from dms_invalid_forge import ONE, X, Y, Z, Invalid, add, affine, after, cross, det3, dot, is_inside, jacobian, mix, sub, volume

EPSILON, HAIR = Q(1, 1 << 60), Q(1, 1 << 40)


# ---------------------------------------------------------------- points (kind 5)

def folded(rng):
    """(model, signs of the tetrahedra): collapsed clouds, and a map that is affine on each tetrahedron and folds where a vertex moves."""
    while True:
        model = true.some_model(rng, "pair", "star", "double", "cube")
        step = {rng.randrange(len(model.clouds)): [Q(rng.randint(-9, 9)) for _ in range(3)]}
        image = [add(p, step.get(v, (0, 0, 0))) for v, (p, *_) in enumerate(model.clouds)]
        signs = [volume(*[image[v] for v in t]) for t in model.tetrahedra]
        if min(signs) < 0 < max(signs):
            for t in model.tetrahedra:
                for at in itertools.combinations_with_replacement(sorted(t), model.degree):
                    model.moved[at] = mix([1] * len(at), [step.get(v, (0, 0, 0)) for v in at])
            return model, signs


def entered(model, u):
    """The tetrahedron that the path of rule H enters."""
    steps = [EPSILON, EPSILON ** 2, EPSILON ** 3]
    tetrahedra = range(len(model.tetrahedra))
    for t in tetrahedra:
        if is_inside(model.corners(t), add(u, steps)):
            return t
    t = next(t for t in tetrahedra if is_inside(model.corners(t), u, closed=True))
    middle = mix([1] * 4, model.corners(t))
    x = add(add(u, sub(middle, u), EPSILON), steps, EPSILON)
    return next(t for t in tetrahedra if is_inside(model.corners(t), x))


def points_between(rng):
    """(finding, whether it is true): points of a face, an edge or a vertex between a tetrahedron that is turned over and one that is not."""
    model, signs = folded(rng)
    for t, o in itertools.permutations(range(len(signs)), 2):
        common = [model.point(v) for v in model.tetrahedra[t] if v in model.tetrahedra[o]]
        if common and signs[t] < 0 < signs[o]:
            u = mix(true.shares(rng, len(common)), common)
            yield Invalid(model, 5, u=u), signs[entered(model, u)] < 0


def negative_side(rng):
    while True:
        for finding, is_true in points_between(rng):
            if is_true:
                return finding


def wrong_points(rng):
    """W5: points where det Ds is positive or 0, on the other side of a fold, or outside."""
    for finding, is_true in points_between(rng):
        if not is_true:
            yield "W5_side", finding
            break
    for name, sign in (("W5_positive", 1), ("W5_zero", 0)):
        model, lists = true.some_clouded(rng)
        model.maps = [true.any_map(rng, model.degree, sign)] * len(model.clouds)
        yield name, Invalid(model, 5, lists, u=true.point_of(model, rng.randrange(len(model.tetrahedra)), rng))
    finding = true.negative(rng)
    f = rng.choice(finding.model.boundary())
    a, b, c = [finding.model.point(v) for v in finding.model.face(f)]
    yield "W5_outside", finding.changed(u=add(mix(true.shares(rng, 3), (a, b, c)), cross(sub(b, a), sub(c, a)), rng.choice((HAIR, Q(1)))))


# ---------------------------------------------------------------- leaves (kind 6)

def with_roots(roots, value):
    """A polynomial of an affine function."""
    found = ONE
    for root in roots:
        found = found * (value + ONE * (-root))
    return found


def share_of(corners):
    """The first barycentric coordinate as a function."""
    a, b, c, e = corners
    normal = cross(sub(c, b), sub(e, b))
    size = dot(normal, sub(a, b))
    return affine(-dot(normal, b) / size, *[n / size for n in normal])


def zero_in_rows(rng):
    """det Ds vanishes at all points of W6 but those nearest to a corner: 2 and 3 are the degrees."""
    model = true.some_model(rng, degrees=(2, 3))
    n, t = model.degree, rng.randrange(len(model.tetrahedra))
    corners, size = model.corners(t), Q(rng.randint(1, 4), 4)
    middle = true.point_of(model, t, rng, False)
    corners = [mix((1 - size, size), (middle, c)) for c in corners]
    share, m = share_of(corners), 3 * (n - 1)
    roots = [Q(i + 1, m + 4) for i in range(m + 1)]
    del roots[rng.choice((0, m, rng.randrange(m + 1)))]
    rng.shuffle(roots)
    first, second, third = (roots[i::3] for i in range(3))
    other, last = (affine(0, *row) for row in true.matrix(rng)[:2])
    if not det3(jacobian((share, other, last), middle)):
        return zero_in_rows(rng)
    if n == 2:
        integral = with_roots(first * 2, share) * Q(1, 2)
    else:
        a, b = first
        integral = share * share * share * Q(1, 3) + share * share * (-(a + b) / 2) + share * (a * b)
    parts = after(true.matrix(rng), [0, 0, 0], (integral, other * with_roots(second, share), last * with_roots(third, share)))
    model.maps = [parts] * len(model.clouds)
    return Invalid(model, 6, tet=t, corners=corners, planes=[])


def is_cut_inside(model, t):
    """A point of a triangle of knots of the tetrahedron is found inside."""
    shares = [(a, b, 6 - a - b) for a in range(7) for b in range(7 - a)]
    knots = [sorted({tuple(k) for k in model.v(t, gamma)}) for gamma in model.gammas(model.degree - 1)]
    triangles = {three for names in knots for three in itertools.combinations(names, 3)}
    corners = model.corners(t)
    return any(true.is_cut(corners, three) and any(is_inside(corners, mix(share, three)) for share in shares) for three in triangles)


def planes_through(points, rng):
    """Through the middle of the points, or beside it."""
    found = []
    for _ in range(rng.randint(0, 4)):
        v = [Q(rng.randint(-3, 3)) for _ in range(3)]
        if any(v):
            found.append([*v, dot(v, mix([1] * len(points), points)) + rng.choice((0, 0, HAIR, -HAIR, 5, -5))])
    return found


def wrong_leaves(rng):
    """W6: a determinant that is not 0, or not everywhere; leaves that are cut, reversed, flat, too large, of another tetrahedron."""
    yield "W6_rows", zero_in_rows(rng)
    model, lists = true.some_clouded(rng)
    model.maps = [true.any_map(rng, model.degree, rng.choice((-1, 1)))] * len(model.clouds)
    t = rng.randrange(len(model.tetrahedra))
    corners = true.uncut_leaf(model, t, rng)
    if corners:
        yield "W6_not_zero", Invalid(model, 6, lists, tet=t, corners=corners, planes=[])
    yield from other_leaves("W6", true.flat_leaf(rng))
    yield from cut_leaves(rng)


def other_leaves(condition, finding):
    """Leaves that are reversed, flat, too large, of another tetrahedron."""
    corners, t = finding.witness["corners"], finding.witness["tet"]
    a, b, c, d = corners
    yield condition + "_reversed", finding.changed(corners=[b, a, c, d])
    yield condition + "_flat", finding.changed(corners=[a, b, c, mix((1, 1, 1), (a, b, c))])
    whole = finding.model.corners(t)
    large = [mix((-HAIR, 1 + HAIR), (mix([1] * 4, whole), p)) for p in whole]
    yield condition + "_large", finding.changed(corners=large)
    yield condition + "_corner", finding.changed(corners=[*whole[:3], large[3]])
    for other in range(len(finding.model.tetrahedra)):
        if other != t:
            yield condition + "_tetrahedron", finding.changed(tet=other)
            break


def cut_leaves(rng):
    """W6: the map is flat everywhere, but there are triangles of knots inside of the leaf."""
    model, lists = true.some_clouded(rng, "star", "double", degrees=(2, 3))
    model.maps = [true.flat_map(rng, model.degree)] * len(model.clouds)
    for t in range(len(model.tetrahedra)):
        if is_cut_inside(model, t):
            corners = model.corners(t)
            yield "W6_cut", Invalid(model, 6, lists, tet=t, corners=corners, planes=planes_through(corners, rng))
            return


# ---------------------------------------------------------------- meetings (kind 11)

def wrong_meetings(rng):
    """W11: one point, points with other images, points outside, where s has no value."""
    finding = true.two_points(rng)
    u, v = finding.witness["u"], finding.witness["v"]
    yield "W11_one", finding.changed(v=u)
    yield "W11_hair", finding.changed(v=moved_inside(finding.model, v, rng))
    model, lists = true.some_clouded(rng, degrees=(2, 3))
    t = rng.randrange(len(model.tetrahedra))
    u, f = true.point_of(model, t, rng), rng.choice(model.boundary())
    a, b, c = [model.point(w) for w in model.face(f)]
    v = add(mix(true.shares(rng, 3), (a, b, c)), cross(sub(b, a), sub(c, a)), rng.choice((HAIR, Q(1, 2))))
    axes = true.dual_axes(u, v, rng)
    model.maps = [after(true.matrix(rng), [0, 0, 0], (axes[0] * axes[0], axes[1], axes[2]))] * len(model.clouds)
    yield "W11_outside", Invalid(model, 11, lists, **rng.choice(({"u": u, "v": v}, {"u": v, "v": u})))


def moved_inside(model, v, rng):
    """A point of the domain near one."""
    t = next(t for t in range(len(model.tetrahedra)) if is_inside(model.corners(t), v, closed=True))
    return mix((1 - HAIR, HAIR), (v, true.point_of(model, t, rng, False)))


# ---------------------------------------------------------------- crossings (kind 12)

def shifted(pair, rng):
    """An interval of two is elsewhere, not a point: the surfaces cross along a curve."""
    at = rng.choice([i for i in range(2) if not is_point(pair[i])])
    bits, lo, hi = pair[at]
    size = hi - lo
    lo = lo + 4 * size + 1 if hi + 4 * size + 1 < 1 << bits else max(1, lo - 4 * size - 2)
    return [(bits, lo, lo + size) if i == at else interval for i, interval in enumerate(pair)]


def is_point(interval):
    return interval[1] == interval[2]


def wrong_crossings(rng):
    """W12: rows, intervals, pieces and faces that are others."""
    finding = true.crossing(rng)
    rows, a, b = (finding.witness[name] for name in ("Y", "A", "B"))
    yield from wrong_rows(finding, rows, rng)
    yield "W12_interval", finding.changed(**rng.choice(({"A": shifted(a, rng)}, {"B": shifted(b, rng)})))
    yield "W12_swapped", finding.changed(A=b, B=a, Y=rows)
    for name, pair in (("A", a), ("B", b)):
        point = [(bits, lo, lo) for bits, lo, hi in pair]
        yield "W12_points", finding.changed(**{name: point})
        if any(map(is_point, pair)):                      # by very little
            wide = [(bits + 40, lo << 40, (lo << 40) + 1) if lo == hi else (bits, lo, hi) for bits, lo, hi in pair]
            yield "W12_no_point", finding.changed(**{name: wide})
    for name, pair in (("A", a), ("B", b)):
        for at in range(2):
            bits, lo, hi = pair[at]
            if not is_point(pair[at]):
                ends = ((0, hi), (lo, 1 << bits)) if name == "A" else ((0, hi),)
                lo, hi = rng.choice(ends)
                if name == "A" or at == 0:
                    yield "W12_ends", finding.changed(**{name: [(bits, lo, hi) if i == at else pair[i] for i in range(2)]})
    yield from wrong_pieces(finding, rng)
    yield from wrong_places(rng)
    yield from cut_pieces(rng)


def wrong_rows(finding, rows, rng):
    yield "W12_zero_rows", finding.changed(Y=[[0] * 3] * 3)
    yield "W12_dependent", finding.changed(Y=[rows[0], rows[1], [x + y for x, y in zip(*rows[:2])]])
    yield "W12_sign", finding.changed(Y=[[-c for c in row] if i == 0 else row for i, row in enumerate(rows)])
    yield "W12_order", finding.changed(Y=rows[1:] + rows[:1])


def larger(points):
    """By a hair, about their middle."""
    middle = mix([1] * len(points), points)
    return [mix((-HAIR, 1 + HAIR), (middle, p)) for p in points]


def smaller(points):
    middle = mix([1] * len(points), points)
    return [mix((1, 3), (middle, p)) for p in points]


def wrong_pieces(finding, rng):
    name, number = rng.choice((("sigma", "f"), ("rho", "g")))
    a, b, c = finding.witness[name]
    yield "W12_flat", finding.changed(**{name: [a, b, mix((1, 1), (a, b))]})
    face = finding.witness[number]
    yield "W12_face", finding.changed(**{number: (face[0], (face[1] + rng.randint(1, 3)) % 4)})


def wrong_places(rng):
    """True crossings of pieces that are reversed, not in a face of the boundary, or that overlap."""
    make = true.crossing_of_parts
    yield "W12_reversed", true.until(make, rng, lambda piece, _: [piece[1], piece[0], piece[2]])
    yield "W12_inner", true.until(make, rng, lambda piece, _: piece, True)
    yield "W12_plane", true.until(make, rng, lambda piece, normal: [add(p, normal, -HAIR) for p in smaller(piece)])
    yield "W12_large", true.until(beside_its_face, rng, "one", lambda model: [(f, f, larger) for f in model.boundary()])
    yield "W12_neighbour", true.until(beside_its_face, rng, "cube", neighbours)
    yield "W12_turned", true.until(true.crossing_of_one_face, rng, turned_piece)
    yield "W12_overlap", true.until(true.crossing_of_one_face, rng, overlapping_pieces)
    found = true.until(true.crossing_of_one_face, rng, true.piece_twice)
    same = [(9, 100, 102), (3, 4, 4)], [(9, 99, 103), (9, 250, 260)]
    yield "W12_same", found.changed(A=same[0], B=same[1])
    yield "W12_one_place", found.changed(B=found.witness["A"])


def turned_piece(corners, rng):
    a, b, c = true.piece_of(corners, rng)
    return [a, b, c], [b, c, a]


def overlapping_pieces(corners, rng):
    a, b, c = corners
    return [mix((1 << 30, 1, 1), corners), b, c], [list(p) for p in corners]


def beside_its_face(rng, name, choices):
    """A true crossing, but the first piece, which is a change of a face, is said to be of another face, or is too large for it. choices:
    (face, that of which it is said to be, change)"""
    one, other = (true.some_model(rng, n, degrees=(2,)) for n in (name, "one"))
    one.separate = other.separate = False
    true.move(other, [Q(1000)] * 3)
    f, said, change = rng.choice(choices(one))
    g, fixed = rng.choice(other.boundary()), rng.randrange(4)
    sigma, rho = change([one.point(v) for v in one.face(f)]), [other.point(v) for v in other.face(g)]
    at = true.parameters(rng, fixed)
    true.meet(one, other, true.at_parameters(sigma, *at[0]), true.at_parameters(rho, *at[1]), rng)
    return true.crossing_of(true.joined(one, other), said, sigma, (g[0] + len(one.tetrahedra), g[1]), rho, (one.maps[0], other.maps[0]), at, fixed, rng)


def neighbours(model):
    """Two faces in a plane."""
    found = []
    for f, g in itertools.permutations(model.boundary(), 2):
        a, b, c = (model.point(v) for v in model.face(f))
        if all(volume(a, b, c, model.point(v)) == 0 for v in model.face(g)):
            found.append((f, g, smaller))
    return found


def cut_pieces(rng):
    """True crossings, but triangles of knots that are moved outward cross a piece: faces inside of whose planes there is one."""
    one, other = (true.some_model(rng, name, degrees=(2,)) for name in ("cube", "one"))
    one.separate = other.separate = False
    true.clouded(one, rng, outward=True)
    true.move(other, [Q(1000)] * 3)
    lists = true.face_planes(one) + true.face_planes(other)
    for f in one.boundary():
        corners = [one.point(v) for v in one.face(f)]
        if is_crossed(one, corners):
            g, fixed = rng.choice(other.boundary()), rng.randrange(4)
            rho, at = [other.point(v) for v in other.face(g)], true.parameters(rng, fixed)
            true.meet(one, other, true.at_parameters(corners, *at[0]), true.at_parameters(rho, *at[1]), rng)
            lie = true.crossing_of(true.joined(one, other), f, corners, (g[0] + len(one.tetrahedra), g[1]), rho, (one.maps[0], other.maps[0]), at,
                                   fixed, rng, planes=lists)
            if lie:
                yield "W12_cut", lie.changed(planes_f=planes_through(corners, rng))
            return


def is_crossed(model, corners):
    """A triangle of knots crosses the inside of this one, knots on both sides."""
    normal = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
    for three in model.triangles():
        heights = [dot(normal, sub(k, corners[0])) for k in three]
        if min(heights) < 0 < max(heights):
            ends = [mix((abs(g), abs(h)), (a, b)) for (a, h), (b, g) in itertools.combinations(zip(three, heights), 2) if h * g < 0]
            ends += [list(k) for k, h in zip(three, heights) if h == 0]
            middle = mix((1, 1), ends)
            if all(dot(cross(sub(corners[i - 2], corners[i]), sub(middle, corners[i])), normal) > 0 for i in range(3)):
                return True
    return False


def crossings_without_defect(rng):
    """Faces of a solid, and intervals about points that are near each other or one, on both sides of an edge, too."""
    model, lists = true.some_clouded(rng)
    maps = true.any_map(rng, model.degree, 1)
    model.maps = [maps] * len(model.clouds)
    for _ in range(3):
        f, g = (rng.choice(model.boundary()) for _ in range(2))
        sigma, rho = ([model.point(v) for v in model.face(n)] for n in (f, g))
        fixed = rng.randrange(4)
        at = true.parameters(rng, fixed)
        common = [p for p in sigma if p in rho]
        if f == g and rng.random() < .5:
            at = (at[0], at[0])
        elif len(common) == 2 and rng.random() < .7:      # beside a point of the common edge
            sigma, rho = ([next(p for p in piece if p not in common), *common] for piece in (sigma, rho))
            at = ([1 - HAIR, Q(1, 2)], [1 - HAIR, Q(1, 2)])
            sigma, rho = oriented(sigma, model, f), oriented(rho, model, g)
        lie = true.crossing_of(model, f, sigma, g, rho, (maps, maps), at, fixed, rng, planes=lists, k=rng.choice((3, 5, 9)))
        if lie:
            yield "no_defect_12", lie


def oriented(piece, model, face):
    a, b, c = (model.point(v) for v in model.face(face))
    normal = cross(sub(b, a), sub(c, a))
    p, q, r = piece
    return piece if dot(normal, cross(sub(q, p), sub(r, p))) > 0 else [p, r, q]


# ---------------------------------------------------------------- coverings (kind 13)

def wrong_coverings(rng):
    """W13: leaves that are cut, reversed, flat, too large, of another tetrahedron; points in the leaf or outside of the domain; images that no
    leaf covers, or that a coefficient passes."""
    finding = true.covering(rng)
    yield from other_leaves("W13", finding)
    corners = finding.witness["corners"]
    yield "W13_inside", finding.changed(u=mix(true.shares(rng, 4), corners))
    shares = true.shares(rng, 4)
    for k in rng.sample(range(4), rng.randint(1, 3)):
        shares[k] = Q(0)
    yield "W13_border", finding.changed(u=mix(shares, corners))
    yield from points_outside(finding, rng)
    yield from uncovered(rng)
    yield from passing_coefficients(rng)
    yield from flat_coverings(rng)
    yield from cut_coverings(rng)


def points_outside(finding, rng):
    """Where s has no value, beside the domain or far away."""
    f = rng.choice(finding.model.boundary())
    a, b, c = [finding.model.point(v) for v in finding.model.face(f)]
    yield "W13_outside", finding.changed(u=add(mix(true.shares(rng, 3), (a, b, c)), cross(sub(b, a), sub(c, a)), rng.choice((HAIR, Q(1, 1 << 20)))))
    yield "W13_far", finding.changed(u=[Q(-5000)] * 3)


def uncovered(rng):
    """The image of the point is that of one on the border of the leaf or beyond it, and of no other; or the leaf is smaller than it has to be."""
    one, other, t, corners, u = true.parts_and_leaf(rng)
    shares, k = true.shares(rng, 4), rng.randrange(4)
    for name, share in (("W13_on_face", Q(0)), ("W13_beyond", -HAIR), ("W13_far_beyond", Q(-1))):
        at = mix([share if i == k else s for i, s in enumerate(shares)], corners)
        yield name, true.covering_at(one, other, t, corners, at, u, rng)[0]
    v = mix(shares, corners)
    finding, _ = true.covering_at(one, other, t, corners, v, u, rng)
    for corner in corners:
        moved = [mix((5, 1), (corner, p)) for p in corners]
        if not is_inside(moved, v, closed=True):
            yield "W13_moved", finding.changed(corners=moved)
    about, size = mix((rng.randint(1, 9), 9), (rng.choice(one.corners(t)), v)), rng.choice((Q(1, 64), HAIR))
    small = [add(about, sub(p, v), size) for p in corners]
    if not is_inside(small, v, closed=True):
        yield "W13_small", finding.changed(corners=small)


def covering_of_one(rng):
    """(finding, coefficients on the leaf, image of the point): the leaf is the tetrahedron; or None."""
    one, other = (true.some_model(rng, "one", degrees=(2, 3)) for _ in range(2))
    other.degree, other.separate = one.degree, one.separate
    true.move(other, [Q(1000)] * 3)
    corners, u = one.corners(0), true.point_of(other, 0, rng)
    finding, parts = true.covering_at(one, other, 0, corners, mix(true.shares(rng, 4), corners), u, rng)
    net, x = true.net_on(parts, corners, one.degree), true.value(other.maps[0], u)
    return (finding, net, x) if true.is_covered(net, x) else None


def passing_coefficients(rng):
    """The leaf covers the image of the point, but a coefficient of a face is moved past that image, or to its level."""
    finding, net, x = true.until(covering_of_one, rng)
    degree, m = finding.model.degree, rng.randrange(4)
    images = [net[tuple(degree * (i == k) for i in range(4))] for k in range(4)]
    height = volume(*[x if k == m else p for k, p in enumerate(images)]) / volume(*images)
    beta = rng.choice([beta for beta in net if not beta[m] and max(beta) < degree])
    at = tuple(sorted(v for v, b in zip(finding.model.tetrahedra[0], beta) for _ in range(b)))
    for name, share in (("W13_level", height), ("W13_above", height + HAIR), ("W13_far_above", height + 1)):
        others = true.shares(rng, 3)
        shares = [s * (1 - share) / sum(others) for s in others]
        place = [sum(s * p[i] for s, p in zip([*shares[:m], share, *shares[m:]], images)) for i in range(3)]
        lie = finding.changed()
        lie.model.moved[at] = sub(place, net[beta])
        yield name, lie


def flat_coverings(rng):
    """The image of the leaf is flat or a surface, which has the image of the point."""
    one, other, t, corners, u = true.parts_and_leaf(rng)
    v = mix(true.shares(rng, 4), corners)
    yield "W13_flat_map", true.covering_at(one, other, t, corners, v, u, rng, sign=0)[0]


def cut_coverings(rng):
    """Triangles of knots are inside of the leaf, or its list of planes does not part one that it has to part."""
    one, other = true.two_parts(rng, degrees=(2, 3), far=True, names=("star", "double"))
    true.clouded(one, rng)
    for t in range(len(one.tetrahedra)):
        if is_cut_inside(one, t):
            corners = one.corners(t)
            v, u = mix(true.shares(rng, 4), corners), true.point_of(other, 0, rng)
            for _ in range(9):
                finding, parts = true.covering_at(one, other, t, corners, v, u, rng, planes_through(corners, rng))
                if true.covers(finding, parts):
                    yield "W13_cut", finding
                    break
            break
    finding = true.until(true.covering_beside_knots, rng)
    (*out, at), = finding.witness["planes"]
    middle = dot(out, mix([1] * 4, finding.witness["corners"]))
    yield "W13_no_planes", finding.changed(planes=[])
    yield "W13_plane_inside", finding.changed(planes=[[*out, middle]])
    yield "W13_plane_beyond", finding.changed(planes=[[*out, at - rng.choice((HAIR, middle - at))]])


def coverings_without_defect(rng):
    """A map that is one to one; points in the leaf, on its border, near it and elsewhere."""
    model, lists = true.some_clouded(rng)
    model.maps = [true.any_map(rng, model.degree, 1)] * len(model.clouds)
    t = rng.randrange(len(model.tetrahedra))
    corners = true.uncut_leaf(model, t, rng) or model.corners(t)
    shares, k = true.shares(rng, 4), rng.randrange(4)
    points = [mix([share if i == k else s for i, s in enumerate(shares)], corners) for share in (shares[k], HAIR, Q(0), -HAIR)]
    for u in (*points, true.point_of(model, rng.randrange(len(model.tetrahedra)), rng)):
        yield "no_defect_13", Invalid(model, 13, lists, tet=t, corners=corners, planes=planes_through(corners, rng), u=u)
