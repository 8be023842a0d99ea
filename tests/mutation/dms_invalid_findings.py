# SPDX-License-Identifier: Apache-2.0 OR MIT
"""True findings about random small simplex-spline solids, one function for each kind of dms_invalid_forge.py; and what they are made of:
domains, clouds, maps. Everything is drawn and everything is exact."""
import itertools
from fractions import Fraction as Q

from dms_invalid_forge import (ONE, X, Y, Z, Invalid, Model, Polynomial, add, affine, after, cross, det3, dot, inverse, is_inside, jacobian, mix, sub,
                               turned, value, volume)
import dms_files as files


# ---------------------------------------------------------------- domains

def oriented(points, tetrahedra):
    return [t if volume(*[points[v] for v in t]) > 0 else [t[1], t[0], *t[2:]] for t in tetrahedra]


def simplex_domain(inner=0):
    """A tetrahedron; with one inner vertex, or with two."""
    points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1], [Q(1, 2), Q(1, 3), Q(3, 4)]][:4 + inner]
    tetrahedra = [[0, 1, 2, 3]]
    for v in range(4, 4 + inner):
        of = next(t for t in tetrahedra if is_inside([points[w] for w in t], points[v]))
        tetrahedra.remove(of)
        tetrahedra += [of[:k] + [v] + of[k + 1:] for k in range(4)]
    return points, oriented(points, tetrahedra)


def pair_domain():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
    return points, oriented(points, [[0, 1, 2, 3], [1, 2, 3, 4]])


DOMAINS = {"one": simplex_domain, "pair": pair_domain, "star": lambda: simplex_domain(1), "double": lambda: simplex_domain(2),
           "cube": lambda: files.grid_domain((1, 1, 1))}
EVEN = [order for order in itertools.permutations(range(4)) if volume(*[[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]][i] for i in order]) > 0]


def matrix(rng, sign=1):
    while True:
        rows = [[rng.randint(-2, 2) for _ in range(3)] for _ in range(3)]
        d = det3(rows)
        if d * sign > 0 or sign == 0 and d == 0:
            return rows


def drawn_domain(rng, *names):
    """A domain of these names after an affine map, its vertices and tetrahedra in another order."""
    points, tetrahedra = DOMAINS[rng.choice(names or list(DOMAINS))]()
    rows, shift = matrix(rng), [Q(rng.randint(-9, 9), rng.choice((1, 2, 3))) for _ in range(3)]
    points = [add([dot(row, p) for row in rows], shift) for p in points]
    order = list(range(len(points)))
    rng.shuffle(order)
    place = {v: i for i, v in enumerate(order)}
    tetrahedra = [[place[t[i]] for i in rng.choice(EVEN)] for t in tetrahedra]
    rng.shuffle(tetrahedra)
    return [points[v] for v in order], tetrahedra


# ---------------------------------------------------------------- models

def some_model(rng, *names, degrees=(1, 2, 2, 3), parts=(X, Y, Z)):
    model = Model(rng.choice(degrees), *drawn_domain(rng, *names), parts)
    model.separate = rng.random() < .3
    return model


def outer_vertices(model):
    return {v for number in model.boundary() for v in model.face(number)}


def centre(model):
    return mix([1] * len(model.clouds), [cloud[0] for cloud in model.clouds])


def clouded(model, rng, outward=False):
    """With clouds of inner vertices, drawn; of those of the boundary of a convex domain, outward, if asked for. (The planes of its faces part
    the hulls then.)"""
    if model.degree == 1 and not model.separate:
        return model
    outer = outer_vertices(model)
    for v in range(len(model.clouds)):
        for i in range(1, model.degree + model.separate):
            if v not in outer and rng.random() < .8:
                model.set_knot(v, i, add(model.point(v), [Q(rng.randint(-9, 9), 90) for _ in range(3)]))
            elif v in outer and outward:
                model.set_knot(v, i, add(model.point(v), way_out(model, v, rng), Q(rng.randint(0, 5), 20)))
    if not model.has_good_clouds():
        model.clouds = [[cloud[0]] for cloud in model.clouds]
    return model


def way_out(model, v, rng):
    """A direction from a vertex of a convex domain that leaves it across each of the vertex's faces."""
    normals = [normal_of(*[model.point(w) for w in model.face(f)]) for f in model.boundary() if v in model.face(f)]
    straight = sub(model.point(v), centre(model))
    for _ in range(20):
        way = add(straight, [Q(rng.randint(-9, 9), 9) for _ in range(3)])
        if all(dot(normal, way) >= 0 for normal in normals):
            return way
    return straight


def normal_of(a, b, c):
    return cross(sub(b, a), sub(c, a))


def face_planes(model):
    """The plane of each face of the boundary, as a list of planes."""
    found = []
    for number in model.boundary():
        a, b, c = (model.point(v) for v in model.face(number))
        normal = normal_of(a, b, c)
        found.append([[*normal, dot(normal, a)]])
    return found


def some_clouded(rng, *names, degrees=(1, 2, 2, 3), parts=(X, Y, Z)):
    """(model, planes)"""
    outward = rng.random() < .3
    model = clouded(some_model(rng, *names, degrees=degrees, parts=parts), rng, outward)
    return model, face_planes(model) if outward else None


def joined(*models):
    """Parts without a common vertex, of one degree."""
    first = models[0]
    whole = Model(first.degree, [], [])
    whole.separate = first.separate
    for model in models:
        shift = len(whole.clouds)
        whole.clouds += model.clouds
        whole.maps += model.maps
        whole.tetrahedra += [[v + shift for v in t] for t in model.tetrahedra]
    return whole


def shares(rng, count):
    return [Q(rng.randint(1, 9)) for _ in range(count)]


def point_of(model, t, rng, closed=True):
    """A point of a tetrahedron; one in five lies on a face, an edge or a vertex."""
    found = shares(rng, 4)
    if closed and rng.random() < .2:
        for k in rng.sample(range(4), rng.randint(1, 3)):
            found[k] = Q(0)
    return mix(found, model.corners(t))


# ---------------------------------------------------------------- maps

def random_polynomial(rng, degree, size=Q(1, 8)):
    return Polynomial({p: size * rng.randint(-3, 3) for p in itertools.product(range(degree + 1), repeat=3) if sum(p) <= degree})


def bent(rng, degree, parts):
    """With terms of higher degree that depend on earlier coordinates only: the determinant stays."""
    x, y, z = parts
    if degree > 1 and rng.random() < .6:
        y = y + x * x * Q(rng.randint(-2, 2), 8)
        z = z + x * x * Q(rng.randint(-2, 2), 8)
    return x, y, z


def any_map(rng, degree, sign):
    """A map whose determinant has this sign everywhere."""
    shift = [Q(rng.randint(-5, 5)) for _ in range(3)]
    return after(matrix(rng, sign), shift, bent(rng, degree, (X, Y, Z))) if sign else flat_map(rng, degree)


def flat_map(rng, degree):
    """The third coordinate depends on the other two."""
    a, b = affine(*[rng.randint(-3, 3) for _ in range(4)]), affine(*[rng.randint(-3, 3) for _ in range(4)])
    c = a * Q(rng.randint(-2, 2)) + b * Q(rng.randint(-2, 2)) + ONE
    if degree > 1:
        c = c + rng.choice((a * a, a * b, b * b)) * Q(1, 4)
    return after(matrix(rng), [0, 0, 0], (a, b, c))


# ---------------------------------------------------------------- domains and clouds that have defects

def reversed_tet(rng):
    model = some_model(rng)
    t = rng.randrange(len(model.tetrahedra))
    corners = model.tetrahedra[t]
    a, b = rng.sample(range(4), 2)
    if rng.random() < .6:
        corners[a], corners[b] = corners[b], corners[a]
    else:
        others = [model.point(v) for i, v in enumerate(corners) if i != a]
        model.clouds[corners[a]] = [mix(shares(rng, 3), others)]
    return Invalid(model, 0, tet=t)


def overused_face(rng):
    model = some_model(rng)
    t = list(rng.choice(model.tetrahedra))
    if rng.random() < .5:                                 # another apex
        k = rng.randrange(4)
        model.clouds.append([mix([2 if i == k else 1 for i in range(4)], [model.point(v) for v in t])])
        model.maps.append(model.maps[0])
        t[k] = len(model.clouds) - 1
    model.tetrahedra.append([t[i] for i in rng.choice(EVEN)])
    return Invalid(model, 1, **dict(zip("fg", rng.sample(rng.choice(equal_faces(model)), 2))))


def equal_faces(model):
    found = {}
    for t in range(len(model.tetrahedra)):
        for k, face in enumerate(model.faces(t)):
            found.setdefault(turned(face), []).append((t, k))
    return [those for those in found.values() if len(those) > 1]


def with_clouds(rng, *names):
    """A model in which there are knots beside those of number 0."""
    while True:
        model = some_model(rng, *names)
        if model.last > 0:
            return model


def degenerate_cloud(rng):
    model = with_clouds(rng)
    t, k, i = rng.randrange(len(model.tetrahedra)), rng.randrange(4), rng.randint(1, model.last)
    where = shares(rng, 4)
    where[k] = rng.choice((Q(0), -min(where) / 2, Q(-1, 1 << 40)))
    model.set_knot(model.tetrahedra[t][k], i, mix(where, model.corners(t)))
    return Invalid(model, 2, tet=t, gamma=[i if m == k else 0 for m in range(4)])


def no_core(rng):
    """At an inner edge pq, W with p_1 near q and W with q_1 near p have no common inner point."""
    model = with_clouds(rng, "double")
    p, q = [v for v in range(len(model.clouds)) if v not in outer_vertices(model)]
    t = rng.choice([t for t, corners in enumerate(model.tetrahedra) if p in corners and q in corners])
    at, other = (model.tetrahedra[t].index(v) for v in (p, q))
    a = Q(rng.randint(5, 9), 10)
    b = rng.choice((1 - a, max(1 - a, Q(rng.randint(1, 9), 10))))
    model.set_knot(p, 1, mix((1 - a, a), (model.point(p), model.point(q))))
    model.set_knot(q, 1, mix((1 - b, b), (model.point(q), model.point(p))))
    first, second = ([int(m == k) for m in range(4)] for k in (at, other))
    # With shares x and y of p and q in the tetrahedron, h of the terms is d (y - a' x), d' (x - b' y), d'' y.
    slopes, sizes = (a / (1 - a), b / (1 - b)), [volume(*model.w(t, g)) for g in (first, second, [0] * 4)]
    terms = [(first, other, 1 / sizes[0]), (second, at, slopes[0] / sizes[1]),
             ([0] * 4, other, (slopes[0] * slopes[1] - 1) / sizes[2])]
    return Invalid(model, 3, tet=t, terms=[term for term in terms if term[2]])


def inner_hull(rng):
    model = with_clouds(rng)
    number = rng.choice(model.boundary())
    k, t = rng.randrange(3), rng.randrange(len(model.tetrahedra))
    model.set_knot(model.face(number)[k], 1, mix(shares(rng, 4), model.corners(t)))
    index = [0, 0, 0]
    index[k] = model.last
    weights = [Q(0)] * (sum(index) + 3)
    weights[k + 1] = Q(rng.randint(1, 9))
    return Invalid(model, 4, f=number, index=index, tet=t, weights=weights)


# ---------------------------------------------------------------- boundaries that have defects

def mirrored(points, about, rng):
    """The points beyond `about`, farther or nearer."""
    factor = Q(rng.randint(1, 4), 2)
    return [add(about, sub(about, p), factor) for p in points]


def copy_at(model, rng, vertices):
    """A model with a second tetrahedron beyond these one or two vertices of its boundary, which it shares; the new one's number."""
    points = [model.point(v) for v in vertices]
    about = mix([1] * len(points), points)
    t = rng.choice([t for t in model.tetrahedra if set(vertices) <= set(t)])
    new = {}
    for v in t:
        if v not in vertices:
            new[v] = len(model.clouds)
            model.clouds += [[p] for p in mirrored([model.point(v)], about, rng)]
            model.maps.append(model.maps[0])
    found = [new.get(v, v) for v in t]
    corners = [model.point(v) for v in found]
    model.tetrahedra.append(found if volume(*corners) > 0 else [found[1], found[0], *found[2:]])
    return len(model.tetrahedra) - 1


def edge_of_three(rng):
    model = some_model(rng)
    a, b = sorted(rng.sample(model.face(rng.choice(model.boundary())), 2))
    copy_at(model, rng, (a, b))
    return Invalid(model, 7, a=a, b=b)


def two_fans(rng):
    model = some_model(rng)
    v = rng.choice(model.face(rng.choice(model.boundary())))
    copy_at(model, rng, (v,))
    return Invalid(model, 8, v=v)


PARTS = "one", "pair", "one", "star"


def two_parts(rng, degrees=(1, 2, 2, 3), far=False, names=PARTS):
    """Two models, the second one far away from the first, if asked for."""
    models = [some_model(rng, *names, degrees=degrees) for _ in range(2)]
    models[1].degree, models[1].separate = models[0].degree, models[0].separate
    if far:
        move(models[1], [Q(1000), Q(rng.randint(-9, 9)), Q(0)])
    return models


def move(model, by):
    model.clouds = [[add(knot, by) for knot in cloud] for cloud in model.clouds]


def inner_faces(model):
    return sorted({(t, k) for t in range(len(model.tetrahedra)) for k in range(4)} - set(model.boundary()))


def improper_point(rng, inner=False):
    """inner: the first face is none of the boundary, and the rest is right."""
    one, other = two_parts(rng, names=("pair", "star") if inner else PARTS)
    f, g = rng.choice(inner_faces(one) if inner else one.boundary()), rng.choice(other.boundary())
    w, x = ([Q(rng.choice((0, 1, 1, 2, 3))) for _ in range(3)] for _ in range(2))
    w[rng.randrange(3)] = x[rng.randrange(3)] = Q(1)
    here, there = mix(w, [one.point(v) for v in one.face(f)]), mix(x, [other.point(v) for v in other.face(g)])
    move(other, sub(here, there))
    return Invalid(joined(one, other), 9, f=f, g=(g[0] + len(one.tetrahedra), g[1]), w=w, x=x)


def common_inner_point(rng):
    one, other = two_parts(rng)
    t, o = rng.randrange(len(one.tetrahedra)), rng.randrange(len(other.tetrahedra))
    u = mix(shares(rng, 4), one.corners(t))
    move(other, sub(u, mix(shares(rng, 4), other.corners(o))))
    return Invalid(joined(one, other), 10, tet=t, other=o + len(one.tetrahedra), u=u)


# ---------------------------------------------------------------- maps that have defects

def negative(rng):
    while True:
        model, planes = some_clouded(rng)
        parts = any_map(rng, model.degree, -1)
        if model.degree > 1 and rng.random() < .5:
            parts = [p + random_polynomial(rng, model.degree) for p in parts]
        model.maps = [parts] * len(model.clouds)
        u = point_of(model, rng.randrange(len(model.tetrahedra)), rng)
        if det3(jacobian(parts, u)) < 0:
            return Invalid(model, 5, planes, u=u)


def uncut_leaf(model, t, rng):
    """Four points of the tetrahedron; every triangle of knots has them on one side of its plane. Or all of it."""
    triangles = model.triangles()
    for size in (Q(1), Q(1, 2), Q(1, 8), Q(1, 64), Q(1, 1024)):
        for _ in range(3):
            about, corners = point_of(model, t, rng, False), model.corners(t)
            if size < 1:
                corners = [mix((1 - size, size), (about, c)) for c in corners]
            if not any(is_cut(corners, three) for three in triangles):
                return corners
    return None


def is_cut(corners, three):
    signs = {(h > 0) - (h < 0) for h in (volume(*three, c) for c in corners)}
    return {1, -1} <= signs


def flat_leaf(rng):
    while True:
        model, planes = some_clouded(rng, degrees=(1, 2, 2, 2, 3))
        model.maps = [flat_map(rng, model.degree)] * len(model.clouds)
        t = rng.randrange(len(model.tetrahedra))
        corners = uncut_leaf(model, t, rng)
        if corners:
            return Invalid(model, 6, planes, tet=t, corners=corners, planes=[])


def two_points(rng):
    if rng.random() < .5:                                 # a fold
        model, planes = some_clouded(rng, degrees=(2, 2, 3))
        t = rng.randrange(len(model.tetrahedra))
        u, v = point_of(model, t, rng), point_of(model, t, rng)
        if u == v:
            return two_points(rng)
        axes = dual_axes(u, v, rng)
        parts = after(matrix(rng), [0, 0, 0], (axes[0] * axes[0], axes[1], axes[2] + axes[0] * axes[0]))
        model.maps = [parts] * len(model.clouds)
        return Invalid(model, 11, planes, u=u, v=v)
    one, other = two_parts(rng, far=True)
    u, v = point_of(one, rng.randrange(len(one.tetrahedra)), rng), point_of(other, rng.randrange(len(other.tetrahedra)), rng)
    meet(one, other, u, v, rng)
    return Invalid(joined(one, other), 11, u=u, v=v)


def meet(one, other, u, v, rng, sign=1):
    """Gives the models maps that take these points to one. sign: that of the determinant of the first; the second is positive."""
    first, second = (any_map(rng, one.degree, s) for s in (sign, 1))
    shift = sub(value(first, u), value(second, v))
    one.maps = [first] * len(one.clouds)
    other.maps = [[p + ONE * c for p, c in zip(second, shift)]] * len(other.clouds)


def dual_axes(u, v, rng):
    """Three affine functions; the first one is 1 at u and -1 at v, the others are equal there."""
    way = sub(u, v)
    while True:
        rows = matrix(rng)
        if dot(rows[0], way) and any(cross(way, rows[1])):
            break
    scale = Q(2) / dot(rows[0], way)
    first = [scale * c for c in rows[0]]
    found = [affine(1 - dot(first, u), *first)]
    for row in rows[1:]:
        row = sub(row, [dot(row, way) / 2 * c for c in first])
        found.append(affine(0, *row))
    return found


# ---------------------------------------------------------------- crossings

def at_parameters(corners, s, t):
    return mix((1 - s, s * (1 - t), s * t), corners)


def piece_of(corners, rng):
    """A triangle in one, of its orientation."""
    if rng.random() < .4:
        return [list(c) for c in corners]
    a, b, c = corners
    return rng.choice(([mix((3, 1), (a, b)), b, c], [mix((4, 1, 1), corners), mix((1, 4, 1), corners), mix((1, 1, 4), corners)],
                       [b, c, mix((2, 1), (a, c))]))


def around(x, k):
    """An interval of k halvings about a parameter."""
    n = int(x * (1 << k))
    return k, n - 1, n + 2


def rows_at(parts, corners, parameters):
    """The derivatives of the image along s and t."""
    a, b, c = corners
    s, t = parameters
    ways = add(sub(b, a), sub(c, b), t), [s * x for x in sub(c, b)]
    slopes = jacobian(parts[0], at_parameters(corners, s, t))
    return [[dot(row, way) for row in slopes] for way in ways]


def crossing_of(model, f, sigma, g, rho, maps, at, fixed, rng, k=None, planes=None):
    """The finding, or None if the two images touch only, or nearly so: then the enclosures may be too wide. maps: of both; at: parameters,
    of which number `fixed` (0 to 3) is a fraction of a power of two."""
    k = k or rng.choice((16, 20, 24, 30))
    directions = rows_at([maps[0]], sigma, at[0]) + [[-c for c in way] for way in rows_at([maps[1]], rho, at[1])]
    free = [way for i, way in enumerate(directions) if i != fixed]
    if det3(free) == 0:
        return None
    y = inverse([list(column) for column in zip(*free)])
    most = max(abs(c) for row in y for c in row)
    if most > 64:
        return None
    intervals = []
    for i, x in enumerate([*at[0], *at[1]]):
        if i == fixed:
            bits = x.denominator.bit_length() - 1
            intervals.append((bits, x.numerator, x.numerator))
        else:
            intervals.append(around(x, k))
        if not 0 < intervals[-1][1] <= intervals[-1][2] < 1 << intervals[-1][0]:
            return None
    return Invalid(model, 12, planes, f=f, sigma=sigma, planes_f=[], g=g, rho=rho, planes_g=[], A=intervals[:2], B=intervals[2:],
                   Y=[[round(c / most * (1 << 60)) for c in row] for row in y])


def parameters(rng, fixed):
    at = [Q(rng.randint(3, 9), rng.choice((11, 13))) for _ in range(4)]
    at[fixed] = Q(rng.randint(1, 7), 8)
    return at[:2], at[2:]


def crossing(rng):
    make = rng.choice((crossing_of_parts, crossing_of_parts, crossing_of_one_face))
    return until(make, rng)


def until(make, *arguments):
    while True:
        found = make(*arguments)
        if found:
            return found


def crossing_of_parts(rng, change=lambda piece, normal: piece, inner=False):
    """change: of the first piece. inner: its face is none of the boundary."""
    one, other = two_parts(rng, far=True, names=("pair", "star") if inner else ("one", "pair", "star"))
    for model in (one, other):
        clouded(model, rng)
    f, g = rng.choice(inner_faces(one) if inner else one.boundary()), rng.choice(other.boundary())
    sigma, rho = (piece_of([m.point(v) for v in m.face(n)], rng) for m, n in ((one, f), (other, g)))
    sigma = change(sigma, normal_of(*sigma))
    fixed = rng.randrange(4)
    at = parameters(rng, fixed)
    meet(one, other, at_parameters(sigma, *at[0]), at_parameters(rho, *at[1]), rng)
    return crossing_of(joined(one, other), f, sigma, (g[0] + len(one.tetrahedra), g[1]), rho, (one.maps[0], other.maps[0]), at, fixed, rng)


def pieces_beside(corners, rng):
    a, b, c = corners
    m = mix(shares(rng, 2), (b, c))
    return [a, b, m], [a, m, c]


def piece_twice(corners, rng):
    piece = piece_of(corners, rng)
    return piece, piece


def crossing_of_one_face(rng, pieces=None):
    """A surface that passes a curve twice. pieces: draws two in a face."""
    pieces = pieces or rng.choice((pieces_beside, piece_twice))
    model = clouded(some_model(rng, "one", "star", "cube", degrees=(3,)), rng)
    f = rng.choice(model.boundary())
    sigma, rho = pieces([model.point(v) for v in model.face(f)], rng)
    fixed = rng.randrange(4)
    at = parameters(rng, fixed)
    if sigma == rho and max(abs(x - y) for x, y in zip(*at)) < Q(1, 16):
        return None
    u, v = at_parameters(sigma, *at[0]), at_parameters(rho, *at[1])
    if u == v:
        return None
    w, y, z = dual_axes(u, v, rng)
    parts = after(matrix(rng), [0, 0, 0], (w * w, w * w * w + w * Q(-1), y))
    model.maps = [parts] * len(model.clouds)
    return crossing_of(model, f, sigma, f, rho, (parts, parts), at, fixed, rng)


# ---------------------------------------------------------------- coverings

def net_on(parts, corners, degree):
    """{index: coefficient} of the Bernstein form of a polynomial map on a tetrahedron."""
    indices = [beta for beta in itertools.product(range(degree + 1), repeat=4) if sum(beta) == degree]
    return {beta: [p.polar([c for c, b in zip(corners, beta) for _ in range(b)]) for p in parts] for beta in indices}


def is_covered(net, x):
    """(c) of W13: a share of x in the tetrahedron of the images of the corners is above that of each coefficient of the face."""
    degree = sum(next(iter(net)))
    images = [net[tuple(degree * (k == m) for k in range(4))] for m in range(4)]
    whole = volume(*images)
    if whole == 0:
        return False
    share = lambda m, p: volume(*[p if k == m else c for k, c in enumerate(images)]) / whole     # noqa: E731
    return all(share(m, x) > share(m, b) for m in range(4) for beta, b in net.items() if not beta[m])


def parts_and_leaf(rng, names=PARTS):
    """(model, another one far away, tetrahedron of the first one, an uncut leaf in it, point of the other one)"""
    while True:
        one, other = two_parts(rng, far=True, names=names)
        for model in (one, other):
            clouded(model, rng)
        t = rng.randrange(len(one.tetrahedra))
        corners = uncut_leaf(one, t, rng)
        if corners:
            return one, other, t, corners, point_of(other, rng.randrange(len(other.tetrahedra)), rng)


def covering_at(one, other, t, corners, v, u, rng, planes=(), sign=1):
    """The finding about the images of v and u, which are made one; and the map of the first part, which is one to one in all of space if
    the sign is not 0."""
    meet(one, other, v, u, rng, sign)
    return Invalid(joined(one, other), 13, tet=t, corners=corners, planes=list(planes), u=u), one.maps[0]


def covers(finding, parts):
    """Whether the leaf, on which s is this polynomial map, covers the image of the point."""
    model, u = finding.model, finding.witness["u"]
    t = next(t for t in range(len(model.tetrahedra)) if is_inside(model.corners(t), u, closed=True))
    of_point = model.maps[model.tetrahedra[t][0]]
    return is_covered(net_on(parts, finding.witness["corners"], model.degree), value(of_point, u))


def covering_of_parts(rng):
    one, other, t, corners, u = parts_and_leaf(rng)
    finding, parts = covering_at(one, other, t, corners, mix(shares(rng, 4), corners), u, rng)
    return finding if covers(finding, parts) else None


def covering_of_a_fold(rng):
    """A leaf about the second one of two points with one image in one part; its image may be mirrored."""
    model, planes = some_clouded(rng, degrees=(2, 2, 3))
    t = rng.randrange(len(model.tetrahedra))
    u, v = point_of(model, rng.randrange(len(model.tetrahedra)), rng), point_of(model, t, rng, False)
    if u == v:
        return None
    axes = dual_axes(u, v, rng)
    parts = after(matrix(rng), [0, 0, 0], (axes[0] * axes[0], axes[1], axes[2] + axes[0] * axes[0]))
    model.maps = [parts] * len(model.clouds)
    for size in (Q(1), Q(1, 2), Q(1, 8), Q(1, 64), Q(1, 1024)):
        corners = [mix((1 - size, size), (v, c)) for c in model.corners(t)]
        found = Invalid(model, 13, planes, tet=t, corners=corners, planes=[], u=u)
        if not is_inside(corners, u, closed=True) and covers(found, parts) and not any(is_cut(corners, three) for three in model.triangles()):
            return found
    return None


def covering_beside_knots(rng):
    """A leaf that needs the plane of its list; or None."""
    one, other = two_parts(rng, degrees=(2, 2, 3), far=True, names=("star", "double"))
    clouded(one, rng)
    triangles = sorted(one.triangles())
    for _ in range(50):
        found = leaf_beside(one, rng.sample(rng.choice(triangles), 3), triangles, rng)
        if found:
            t, corners, plane = found
            finding, parts = covering_at(one, other, t, corners, mix(shares(rng, 4), corners), point_of(other, 0, rng), rng, [plane])
            return finding if covers(finding, parts) else None
    return None


def leaf_beside(model, three, triangles, rng):
    """(tetrahedron, corners, plane): a small leaf in the plane of three knots, beside the first two. The plane parts it from these three, and
    from all others that need one. Or None."""
    a, b, c = three
    side, foot = sub(b, a), mix(shares(rng, 2), (a, b))
    out = cross(side, cross(side, sub(c, a)))
    if dot(out, sub(c, a)) > 0:
        out = [-x for x in out]
    v = add(foot, out, Q(rng.randint(1, 9), 64) / max(map(abs, out)))
    t = next((t for t in range(len(model.tetrahedra)) if is_inside(model.corners(t), v)), None)
    if t is None:
        return None
    ways = until(directions, rng)
    size = Q(rng.randint(1, 6), 9) * dot(out, sub(v, foot)) / max(abs(dot(out, way)) for way in ways)
    corners, plane = [add(v, way, size) for way in ways], [*out, dot(out, foot)]
    standard = standard_planes(corners, model.corners(t))
    is_needed = all(is_inside(model.corners(t), p, closed=True) for p in corners) and not is_parted(corners, three, standard)
    return (t, corners, plane) if is_needed and all(is_parted(corners, those, [*standard, plane]) for those in triangles) else None


def directions(rng):
    """To the corners of a tetrahedron about 0; or None."""
    ways = [[Q(rng.randint(-9, 9)) for _ in range(3)] for _ in range(4)]
    return ways if is_inside(ways, [0, 0, 0]) else None


def standard_planes(corners, root):
    """The planes, besides those of a leaf's list and of triangles of knots, that may part the leaf from knots. Numbers of those across an axis
    are None."""
    planes = [[*(Q(i == k) for i in range(3)), None] for k in range(3)]
    for a, b, c in (three for points in (corners, root) for three in itertools.combinations(points, 3)):
        planes.append([*normal_of(a, b, c), dot(normal_of(a, b, c), a)])
    return planes


def is_parted(corners, three, planes):
    """Whether one of the planes, or that of the three knots, parts them from the leaf."""
    if not is_cut(corners, three):
        return True
    for *vector, at in planes:
        one, other = ([dot(vector, p) for p in points] for points in (corners, three))
        for low, high in ((one, other), (other, one)):
            if max(low) <= (max(low) if at is None else at) <= min(high):
                return True
    return False


def covering(rng):
    make = rng.choice((covering_of_parts, covering_of_parts, covering_of_a_fold, covering_of_a_fold, covering_beside_knots))
    return until(make, rng)


HONEST = (reversed_tet, overused_face, degenerate_cloud, no_core, inner_hull, negative, flat_leaf, edge_of_three, two_fans, improper_point,
          common_inner_point, two_points, crossing, covering)


def honest(kind, rng):
    return HONEST[kind](rng)
