# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Random small solids with exact coordinates, and ways to break them at a known place.

Families return (points, triangles) with integer coordinates, outward.  Nothing here is trusted:
callers ask forge.Truth what is the case.
"""
import math

BOX_QUADS = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))


def quads(list_of_quads, rng=None):
    out = []
    for a, b, c, d in list_of_quads:
        if rng and rng.random() < .5:
            a, b, c, d = b, c, d, a
        out += [(a, b, c), (a, c, d)]
    return out


def reverse(tris):
    return [(a, c, b) for a, b, c in tris]


def join(*solids):
    points, tris = [], []
    for p, t in solids:
        n = len(points)
        points = points + list(p)
        tris = tris + [(a + n, b + n, c + n) for a, b, c in t]
    return points, tris


def move(solid, shift=(0, 0, 0), scale=1):
    return [tuple(c * scale + s for c, s in zip(p, shift)) for p in solid[0]], solid[1]


def used_only(points, tris):
    ids = sorted({v for t in tris for v in t})
    new = {v: i for i, v in enumerate(ids)}
    return [points[v] for v in ids], [tuple(new[v] for v in t) for t in tris]


# ---------------------------------------------------------------- families

def tetrahedron(rng):
    while True:
        p = [tuple(rng.randint(-9, 9) for _ in range(3)) for _ in range(4)]
        u, v, w = ([p[i][k] - p[0][k] for k in range(3)] for i in (1, 2, 3))
        det = sum(u[k] * (v[(k + 1) % 3] * w[(k + 2) % 3] - v[(k + 2) % 3] * w[(k + 1) % 3]) for k in range(3))
        if det:
            t = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
            return p, t if det > 0 else reverse(t)


def box(rng):
    a, b, c = (rng.randint(1, 9) for _ in range(3))
    return [(x * a, y * b, z * c) for x in (0, 1) for y in (0, 1) for z in (0, 1)], quads(BOX_QUADS, rng)


def ring(n, radius, rng=None):
    turn = rng.random() if rng else 0
    return [(round(radius * math.cos(2 * math.pi * (i + turn) / n)),
             round(radius * math.sin(2 * math.pi * (i + turn) / n))) for i in range(n)]


def prism(rng):
    n = rng.randint(3, 10)
    r = ring(n, 100, rng)
    h = rng.randint(5, 200)
    p = [(x, y, 0) for x, y in r] + [(x, y, h) for x, y in r]
    t = [(0, i + 1, i) for i in range(1, n - 1)] + [(n, n + i, n + i + 1) for i in range(1, n - 1)]
    return p, t + quads([(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)], rng)


def bipyramid(rng):
    n = rng.randint(3, 9)
    p = [(x, y, 0) for x, y in ring(n, 100, rng)] + [(1, 2, rng.randint(20, 90)), (-3, 1, -rng.randint(20, 90))]
    return p, [(i, (i + 1) % n, n) for i in range(n)] + [((i + 1) % n, i, n + 1) for i in range(n)]


def sphere(rng, levels=None, radius=1000):
    p = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    t = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(rng.randint(0, 2) if levels is None else levels):
        middle, out = {}, []
        for a, b, c in t:
            m = []
            for u, v in ((a, b), (b, c), (c, a)):
                key = (min(u, v), max(u, v))
                if key not in middle:
                    middle[key] = len(p)
                    q = [x + y for x, y in zip(p[u], p[v])]
                    s = math.sqrt(sum(x * x for x in q))
                    p.append(tuple(x / s for x in q))
                m.append(middle[key])
            out += [(a, m[0], m[2]), (m[0], b, m[1]), (m[2], m[1], c), (m[0], m[1], m[2])]
        t = out
    return [tuple(round(radius * x) for x in q) for q in p], t


def star_shape(rng):
    """Every vertex of a sphere moved along its ray: still embedded, seldom convex."""
    p, t = sphere(rng)
    return [tuple(round(c * s) for c in q) for q, s in ((q, rng.uniform(.4, 1.6)) for q in p)], t


def torus(rng):
    n, m = rng.randint(3, 8), rng.randint(3, 6)
    big, small = ring(n, 300, rng), ring(m, 100, rng)
    p = []
    for x, y in big:
        p += [(x * (300 + s) // 300, y * (300 + s) // 300, z) for s, z in small]
    q = [(i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m)
         for i in range(n) for j in range(m)]
    return p, quads(q, rng)


def voxels(rng):
    """A connected set of unit cubes: many coplanar, collinear and grid-aligned contacts."""
    cells = {(0, 0, 0)}
    for _ in range(rng.randint(1, 8)):
        c = rng.choice(sorted(cells))
        k, s = rng.randrange(3), rng.choice((-1, 1))
        cells.add(tuple(x + s * (i == k) for i, x in enumerate(c)))
    return voxel_surface(cells, rng)


def voxel_surface(cells, rng=None):
    ids, out = {}, []
    for c in sorted(cells):
        corner = [tuple(c[k] + (i >> (2 - k) & 1) for k in range(3)) for i in range(8)]
        for q, step in zip(BOX_QUADS, ((-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1))):
            if tuple(x + s for x, s in zip(c, step)) not in cells:
                out.append(tuple(ids.setdefault(corner[i], len(ids)) for i in q))
    return list(ids), quads(out, rng)


def terrain(rng):
    n, m = rng.randint(2, 5), rng.randint(2, 5)
    high = [(x * 3, y * 3, 4 + rng.randint(0, 6)) for x in range(n) for y in range(m)]
    k = n * m
    p = high + [(x, y, 0) for x, y, _ in high]

    def at(x, y):
        return x * m + y

    q = [(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)) for x in range(n - 1) for y in range(m - 1)]
    q += [tuple(v + k for v in reversed(c)) for c in q]
    rim = [at(x, 0) for x in range(n)] + [at(n - 1, y) for y in range(1, m)]
    rim += [at(x, m - 1) for x in range(n - 2, -1, -1)] + [at(0, y) for y in range(m - 2, 0, -1)]
    q += [(b, a, a + k, b + k) for a, b in zip(rim, rim[1:] + rim[:1])]
    return p, quads(q, rng)


def needle(rng):
    """A long thin bipyramid: slivers."""
    p, t = bipyramid(rng)
    s = rng.choice((50, 1000, 10 ** 5))
    return [(x, y, z * s) for x, y, z in p], t


SIMPLE = (tetrahedron, box, prism, bipyramid, sphere, star_shape, torus, voxels, terrain, needle)


def nested(rng):
    """Shells around each other: solid, void in it, solid in the void, ..."""
    parts, scale = [], 1
    for i in range(rng.randint(2, 4)):
        s = sphere(rng, rng.randint(0, 1), 10 * scale)
        parts.append(s if rng.random() < .7 else move(box_of(5 * scale)))
        scale *= 6
    parts.reverse()
    solid = join(*[(p, t if i % 2 == 0 else reverse(t)) for i, (p, t) in enumerate(parts)])
    return solid


def box_of(r):
    return [(x * r, y * r, z * r) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], quads(BOX_QUADS)


def several(rng):
    """Two to four bodies side by side; some of their boxes touch or overlap, they do not."""
    parts, at = [], 0
    for _ in range(rng.randint(2, 4)):
        p, t = rng.choice((tetrahedron, box, prism, bipyramid, voxels))(rng)
        low, high = min(q[0] for q in p), max(q[0] for q in p)
        parts.append(move((p, t), (at - low, rng.randint(-5, 5), rng.randint(-5, 5))))
        at += high - low + rng.randint(1, 3)
    return join(*parts)


def solid(rng):
    f = rng.choice(SIMPLE + (nested, several, several))
    return f(rng)


# ---------------------------------------------------------------- exact maps

def affine(points, rng):
    """A random integer map of positive determinant; sometimes very different exponents."""
    kind = rng.random()
    if kind < .35:
        return points
    while True:
        m = [[rng.randint(-3, 3) for _ in range(3)] for _ in range(3)]
        det = sum(m[0][k] * (m[1][(k + 1) % 3] * m[2][(k + 2) % 3] - m[1][(k + 2) % 3] * m[2][(k + 1) % 3])
                  for k in range(3))
        if det > 0:
            break
    shift = [rng.choice((0, rng.randint(-99, 99), rng.randint(-10 ** 7, 10 ** 7))) for _ in range(3)]
    points = [tuple(sum(m[i][k] * p[k] for k in range(3)) + shift[i] for i in range(3)) for p in points]
    if kind > .85:
        e = [rng.choice((0, rng.randint(-60, 60), rng.randint(-900, 900))) for _ in range(3)]
        points = [tuple(math.ldexp(c, s) for c, s in zip(p, e)) for p in points]
    elif kind > .7:
        points = [tuple(math.ldexp(c, -5) for c in p) for p in points]
    return points


# ---------------------------------------------------------------- defects

def spike(p, t, rng):
    """One vertex moved somewhere: it usually drags its triangles through others."""
    p, v = list(p), rng.randrange(len(p))
    low, high = ([f(q[k] for q in p) for k in range(3)] for f in (min, max))
    w = rng.randrange(len(p))
    kind = rng.random()
    if kind < .4:
        p[v] = tuple(2 * b - a for a, b in zip(p[v], p[w]))
    elif kind < .8:
        p[v] = tuple(rng.randint(a - 3, b + 3) for a, b in zip(low, high))
    else:
        p[v] = tuple(a + rng.choice((-1, 0, 1)) for a in p[v])
    return p, t


def fold(p, t, rng):
    """A vertex thrown over the far side of its own fan: crossings between neighbours."""
    p, v = list(p), rng.choice(t)[0]
    ends = sorted({w for f in t if v in f for w in f} - {v})
    a, b = rng.sample(ends, 2)
    k = rng.choice((1, 1, 2, 3))
    p[v] = tuple(x + k * (x - z) + rng.choice((0, 0, y - x)) for x, y, z in zip(p[a], p[b], p[v]))
    return p, t


def crease(p, t, rng):
    """A new vertex beyond an edge of its own triangle: only triangles with a common vertex overlap."""
    t, f = list(t), rng.randrange(len(t))
    a, b, c = t[f]
    w = rng.choice(((3, 2, -1), (2, 3, -1), (5, -2, 1), (6, -1, -1), (2, 2, 0)))
    p = [tuple(4 * x for x in q) for q in p]
    v = len(p)
    p.append(tuple(sum(k * p[i][m] for k, i in zip(w, (a, b, c))) // 4 + rng.choice((0, 0, 0, 1, -1)) for m in range(3)))
    t[f:f + 1] = [(a, b, v), (b, c, v), (c, a, v)]
    return p, t


def poke(p, t, rng):
    """A second body pushed into the first one."""
    other = rng.choice((tetrahedron, box, prism, voxels))(rng)
    size = max(max(abs(c) for c in q) for q in p)
    k = max(1, size // max(1, max(max(abs(c) for c in q) for q in other[0])))
    shift = [a + rng.randint(-2, 2) * k for a in rng.choice(p)]
    return join((p, t), move(other, shift, k))


def touch_face(p, t, rng):
    """A tetrahedron whose tip lies on (not through) a face; everything scaled by three."""
    p, f = [tuple(3 * c for c in q) for q in p], rng.choice(t)
    a, b, c = (p[v] for v in f)
    w = rng.choice(((1, 1, 1), (2, 1, 0), (1, 2, 0), (0, 2, 1)))
    tip = tuple((w[0] * x + w[1] * y + w[2] * z) // 3 for x, y, z in zip(a, b, c))
    n = [(b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]) for i, j in ((1, 2), (2, 0), (0, 1))]
    e = [[y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]]
    q = [tip] + [tuple(x + m + s * u + r * v for x, m, u, v in zip(tip, n, *e)) for s, r in ((0, 0), (1, 0), (0, 1))]
    return join((p, t), (q, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]))


def touch_edge(p, t, rng):
    """Two bodies whose edges cross in one point."""
    p, f = [tuple(2 * c for c in q) for q in p], rng.choice(t)
    a, b, c = (p[v] for v in f)
    mid = [(x + y) // 2 for x, y in zip(a, b)]
    n = [(b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]) for i, j in ((1, 2), (2, 0), (0, 1))]
    m = [(b[i] - a[i]) * n[j] - (b[j] - a[j]) * n[i] for i, j in ((1, 2), (2, 0), (0, 1))]
    k = rng.choice((0, 0, 1, 3))
    q = [tuple(x + s * w + s * k * v for x, w, v in zip(mid, m, n)) for s in (1, -1)]
    q += [tuple(x + y + s for x, y, s in zip(mid, n, r)) for r in ((0, 0, 0), (b[0] - a[0], b[1] - a[1], b[2] - a[2]))]
    return join((p, t), (q, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]))


def stack_boxes(p, t, rng):
    """Grid-aligned bodies in contact: along a face, part of a face, an edge or a corner."""
    def cuboid(x, y, z):
        q, f = box_of(1)
        return [tuple(r[0] + (r[1] - r[0]) * (c + 1) // 2 for c, r in zip(v, (x, y, z))) for v in q], f

    def span(touching):
        a = rng.randint(-3, 3)
        return (4, 4 + rng.randint(1, 4)) if touching else (a, a + rng.randint(1, 6))

    k = rng.choice((1, 1, 1, 2, 3))
    axes = rng.sample(range(3), k)
    return join(cuboid((0, 4), (0, 4), (0, 4)), cuboid(*[span(i in axes) for i in range(3)]))


def copy_at_vertex(p, t, rng):
    """A mirrored copy that shares exactly one position (pinch if merged, double if as indexed)."""
    v = max(range(len(p)), key=lambda i: p[i])
    q = [tuple(2 * c - x for c, x in zip(p[v], r)) for r in p]
    return join((p, t), (q, reverse(t)))


def copy_at_edge(p, t, rng):
    """Two boxes that share an edge."""
    a, b = rng.randint(1, 5), rng.randint(1, 5)
    one, two = box_of(1), box_of(1)
    return join(([(x * a, y * b, z) for x, y, z in one[0]], one[1]),
                ([(x * a + 2 * a, y * b + 2 * b, z) for x, y, z in two[0]], two[1]))


def flip(p, t, rng):
    t = list(t)
    for f in rng.sample(range(len(t)), rng.choice((1, 1, 2, 3))):
        t[f] = (t[f][0], t[f][2], t[f][1])
    return p, t


def open_up(p, t, rng):
    t = list(t)
    for _ in range(rng.choice((1, 1, 2))):
        t.pop(rng.randrange(len(t)))
    return used_only(p, t) if rng.random() < .5 else (p, t)


def fin(p, t, rng):
    """An extra triangle, pair of triangles or flap on existing vertices."""
    v = rng.sample(range(len(p)), 3)
    extra = [tuple(v)] + ([tuple(reversed(v))] if rng.random() < .5 else [])
    return p, t + extra


def double(p, t, rng):
    """One triangle again, with or against its orientation, or both."""
    a, b, c = rng.choice(t)
    return p, t + rng.choice(([(b, c, a)], [(a, c, b)], [(a, b, c), (a, c, b)]))


def two_sided(p, t, rng):
    """A stray triangle with its own back side."""
    far = [tuple(x + 1000 + s * (i == k) for i, x in enumerate(p[0])) for k, s in ((0, 3), (1, 5), (2, 7))]
    n = len(p)
    return list(p) + far, t + [(n, n + 1, n + 2), (n, n + 2, n + 1)]


def flatten(p, t, rng):
    """A T-vertex closed with a triangle of no area, or a triangle with a repeated corner."""
    t, f = list(t), rng.randrange(len(t))
    a, b, c = t[f]
    if rng.random() < .3:
        return p, t + [(a, a, b)] if rng.random() < .5 else t + [(a, b, a), (b, b, a)]
    p = [tuple(2 * x for x in q) for q in p]
    m = len(p)
    p.append(tuple((x + y) // 2 for x, y in zip(p[a], p[b])))
    t[f:f + 1] = [(a, m, c), (m, b, c), (a, b, m)]        # (a, b, m) has no area
    return p, t


def inside_out(p, t, rng):
    return p, reverse(t)


def wrong_shells(p, t, rng):
    """Nested or disjoint shells with some of the orientations wrong."""
    p, t = nested(rng) if rng.random() < .6 else join(sphere(rng, 0, 10), move(sphere(rng, 0, 9), (40, 0, 0)))
    group = {}
    for f in t:                                           # shells by their own vertices
        for v in f:
            group.setdefault(v, f[0])
    parent = list(range(len(p)))

    def root(v):
        while parent[v] != v:
            v = parent[v]
        return v

    for a, b, c in t:
        parent[root(b)] = root(a)
        parent[root(c)] = root(a)
    roots = sorted({root(f[0]) for f in t})
    bad = set(rng.sample(roots, rng.randint(1, len(roots))))
    return p, [(a, c, b) if root(a) in bad else (a, b, c) for a, b, c in t]


def weld(p, t, rng):
    """Two vertices of one surface put on the same position."""
    p = list(p)
    v, w = rng.sample(range(len(p)), 2)
    p[v] = p[w]
    return p, t


DEFECTS = (spike, spike, fold, fold, crease, crease, poke, touch_face, touch_edge, stack_boxes, stack_boxes, copy_at_vertex,
           copy_at_edge, flip, open_up, fin, double, two_sided, flatten, inside_out, wrong_shells, weld)
