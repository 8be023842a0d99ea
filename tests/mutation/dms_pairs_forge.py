# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of dms-solid-2 for dms_pairs_liars.py: those that the program makes, and others that are proved here, for maps that are linear
in each tetrahedron; and whether a matrix, a direction or a block is a lie, from the page: for the V of a tetrahedron's own, which always reach
it, and for those of others that no plane of the page parts from it. dms_liars.py sets the path to the files that this imports."""
import copy
import functools
import itertools
import json
import random
from fractions import Fraction as Q
from math import gcd, lcm

import dms_liars as solid
from dms_files import APART, AT_EDGE, CHAIN, Pair, PairsBody, Proof, clouds_of, grid_domain, model, separate, text
from dms_liars import cross, dot, is_monotone, rows, sub

POOL, UNIT = 5, [Q(i % 4 == 0) for i in range(9)]


# ---------------------------------------------------------------- honest proofs of the program

BLOCKS = {"cubic": (3, (1, 1, 1), Q(1, 10)), "quartic": (4, (1, 1, 1), Q(1, 20)), "bar": (3, (2, 1, 1), Q(1, 10)),
          "eight": (2, (2, 2, 2), Q(1, 8))}


@functools.lru_cache(None)
def made(name, k, shift=0, warp=None):
    """Clouds and map are drawn; warp: the number of another map."""
    if name == "separate":
        return separate(made("cubic", k, shift, warp))
    degree, counts, radius = BLOCKS[name]
    points, tetrahedra = grid_domain(counts)
    clouds = solid.moved(clouds_of(points, degree, counts, radius, k, True), shift)
    return model(degree, clouds, tetrahedra, solid.warp_of(k if warp is None else warp, shift))


def honest_proof(name, k, shift=0):
    proof = copy.deepcopy(solid.proved(made(name, k, shift)))
    assert proof.body.magic == b"VTD2", name
    return proof


def some(rng, *names):
    return honest_proof(rng.choice(names or ("cubic", "cubic", "quartic", "bar", "eight")), rng.randrange(POOL))


# ---------------------------------------------------------------- the truth about one tetrahedron

def primitive(w):
    """The vector, in integers without a common divisor."""
    most = lcm(*(Q(x).denominator for x in w))
    w = [int(x * most) for x in w]
    return [x // (gcd(*w) or 1) for x in w]


def parts(ends, planes, corners, knots):
    """Whether a plane parts the knots from the corners; ends: of the corners along the axes."""
    if any(max(c) <= a or min(c) >= b for (a, b), c in zip(ends, zip(*knots))):
        return True
    for *v, c in planes:
        sides = [[dot(v, p) - c for p in those] for those in (corners, knots)]
        for x, y in (sides, [[-h for h in those] for those in sides]):
            if min(x) >= 0 and max(x) > 0 and max(y) <= 0:
                return True
    return False


def unparted(model, tetrahedra, listed=()):
    """(tetrahedron, gamma) of all V that no plane of the page parts from a block."""
    corners, planes, out = [p for t in tetrahedra for p in model.corners(t)], list(listed), []
    for t in tetrahedra:
        for a, b, c in itertools.combinations(model.corners(t), 3):
            v = cross(sub(b, a), sub(c, a))
            planes.append([*v, dot(v, a)])
    ends = [(min(c), max(c)) for c in zip(*corners)]
    for t in range(len(model.tetrahedra)):
        for gamma in model.gammas(model.n - 1):
            if t in tetrahedra or not parts(ends, planes, corners, model.knots(t, gamma)[1]):
                out.append((t, gamma))
    return out


@functools.lru_cache(None)
def reaching(model, t):
    if all(len(cloud) == 1 for cloud in model.clouds):     # in grids no other one does
        return [(t, gamma) for gamma in model.gammas(model.n - 1)]
    return unparted(model, [t])


@functools.lru_cache(None)
def domain_of(data):
    return solid.Read(data)


class Read(solid.Read):
    """near: a model of the same domain, whose V are asked which of them reach a tetrahedron; without it only its own are known to do."""

    def __init__(self, data, near=None):
        super().__init__(data)
        self.faces, memo, gammas = self.boundary(), functools.lru_cache(None), self.gammas(self.n - 1)
        self.given = memo(lambda t: dict(zip(gammas, self.derivatives(t))))
        self.terms = memo(lambda t: [(of, gamma, self.given(of)[gamma])
                                     for of, gamma in (reaching(near, t) if near else [(t, gamma) for gamma in gammas])])
        self.box, self.values, self.path, self.growth = map(memo, (self.box_of, self.values_of, self.shortest, self.images_of))
        self.rough = memo(lambda face: [[float(c) for c in p] for p in self.values(face)])
        self.near = {}
        for t, four in enumerate(self.tetrahedra):
            for v, x in itertools.permutations(four, 2):
                self.near.setdefault(v, {}).setdefault(x, t)

    def of_block(self, block):
        """The derivatives of all V that reach it."""
        return [self.given(of)[gamma] for of, gamma in unparted(self, block[0], block[2])]

    def place(self, v):
        return self.clouds[v][0]

    def images_of(self, t, x):
        """The images of a vector by the derivatives, times positive numbers."""
        return sorted({tuple(primitive([dot(row, x) for row in g])) for _, _, g in self.terms(t)})

    def values_of(self, face):
        of, out = self.faces[face][0], []
        for t, gamma, g in self.terms(self.faces[face][1]):
            first = self.knots(t, gamma)[0][0]
            c = self.control[tuple(sorted(v for v, b, one in zip(self.tetrahedra[t], gamma, (1, 0, 0, 0)) for _ in range(b + one)))]
            for v in of:
                step = sub(self.place(v), first)
                out.append([a + dot(row, step) / self.n for a, row in zip(c, g)])
        return out

    def box_of(self, face):
        return [(min(c), max(c)) for c in zip(*self.values(face))]

    def boxes_meet(self, i, j):
        return all(a <= d and c <= b for (a, b), (c, d) in zip(self.box(i), self.box(j)))

    def common(self, i, j):
        return [v for v in self.faces[i][0] if v in self.faces[j][0]]

    def must_be_listed(self, blocks, i, j):
        """The boxes around the values have a common point; the image of a common vertex is in both."""
        t, u = self.faces[i][1], self.faces[j][1]
        return bool(self.boxes_meet(i, j) or self.common(i, j)) and not any(t in block and u in block for block, _, _ in blocks)

    def is_false(self, pair):
        """That the pair is wrong, if own V are enough to see it."""
        if pair.kind == APART:
            return not self.is_apart(pair)
        ways = (self.of_chain if pair.kind == CHAIN else self.of_edge)(pair)
        return ways is None or any(dot(w, x) <= 0 for w, those in zip(pair.directions, ways) for x in those)

    def is_far_from_apart(self, i, j, w):
        """By floating-point numbers: soon found, and not exact."""
        a, b = ([sum(c * x for c, x in zip(w, p)) for p in self.rough(f)] for f in (i, j))
        return max(a) > min(b) + 1e-9 * sum(map(abs, (*a, *b)))

    def is_apart(self, pair):
        i, j = pair.faces
        w = pair.directions[0]
        return not self.common(i, j) and max(dot(w, x) for x in self.values(i)) < min(dot(w, y) for y in self.values(j))

    def steps(self, t, *along):
        return [x for way in along for x in self.growth(t, tuple(way))]

    def of_chain(self, pair):
        """[what the direction must have a positive product with], or None."""
        (a, t), (b, u) = (self.faces[f] for f in pair.faces)
        ends = pair.chain[0], pair.chain[-1]
        edges = list(zip(pair.chain, pair.chain[1:], pair.tetrahedra))
        if ends[0] not in a or ends[1] not in b or any(x not in self.tetrahedra[s] or y not in self.tetrahedra[s] for x, y, s in edges):
            return None
        first, last = (self.place(v) for v in ends)
        found = self.steps(t, *(sub(first, self.place(v)) for v in a if v != ends[0]))
        found += self.steps(u, *(sub(self.place(v), last) for v in b if v != ends[1]))
        return [found + [x for v, y, s in edges for x in self.steps(s, sub(self.place(y), self.place(v)))]]

    def of_edge(self, pair):
        """The steps that each of two directions has to meet."""
        (a, t), (b, s) = (self.faces[f] for f in pair.faces)
        if len(self.common(*pair.faces)) != 2:
            return None
        k = next(k for k in range(3) if a[k] not in b)
        u, v = self.place(a[k - 2]), self.place(a[k - 1])
        p, q = self.place(a[k]), self.place(next(x for x in b if x not in a))
        at = [[(1 - f) * x + f * y for x, y in zip(u, v)] for f in pair.feet]
        both = self.steps(t, sub(at[0], p)) + self.steps(s, sub(q, at[1]))
        return [both + self.steps(t, edge) for edge in (sub(v, u), sub(u, v))]

    def shortest(self, start, ends):
        """A chain from a vertex to one of some others: (vertices, tetrahedra), or None."""
        before, row = {start: None}, [start]
        for v in row:                                     # it grows
            if v in ends:
                chain, tetrahedra = [v], []
                while before[chain[0]]:
                    v, t = before[chain[0]]
                    chain.insert(0, v)
                    tetrahedra.insert(0, t)
                return chain, tetrahedra
            for x, t in self.near[v].items():
                if x not in before:
                    before[x] = v, t
                    row.append(x)
        return None

    def is_false_leaf(self, t, tree):
        return len(tree) == 1 and tree[0][1] == 12 and any(not is_monotone(rows(tree[0][2]), g) for _, _, g in self.terms(t))


SAME_CLOUDS = {}                                          # the key of a domain: a model of it


@functools.lru_cache(256)
def read(data, with_others=True):
    file, near = json.loads(data), None
    if with_others:
        near = domain_of(SAME_CLOUDS.setdefault(json.dumps([file[key] for key in ("degree", "vertices", "tetrahedra")]), data))
    return Read(data, near)


def is_false_body(proof, with_others=True):
    """The name of a condition that does not hold, or None."""
    m, body = read(proof.data, with_others), proof.body
    if any(m.is_false_leaf(t, tree) for t, tree in enumerate(body.trees)):
        return "J1"
    if any(m.is_against(t, rows(matrix)) for block, matrix, _ in body.blocks for t in block):
        return "U2"
    for pair in body.pairs:
        if m.is_false(pair):
            return ("U6", "U5", "U4")[pair.kind]
    listed = {tuple(pair.faces) for pair in body.pairs}
    pairs = (p for p in itertools.combinations(range(len(m.faces)), 2) if p not in listed)
    return "U6" if any(m.must_be_listed(body.blocks, *p) for p in pairs) else None


# ---------------------------------------------------------------- proofs for maps that are linear in each tetrahedron

def linear(degree, points, tetrahedra, images):
    control = {at: [sum(Q(images[v][c]) for v in at) / degree for c in range(3)]
               for t in tetrahedra for at in itertools.combinations_with_replacement(sorted(t), degree)}
    return text(degree, [[p] for p in points], tetrahedra, control)


def pair_of(faces, kind, directions, chain=(), tetrahedra=(), feet=()):
    pair = Pair.__new__(Pair)
    pair.faces, pair.kind, pair.directions = list(faces), kind, directions
    pair.chain, pair.tetrahedra, pair.feet = list(chain), list(tetrahedra), list(feet)
    return pair


SMALL = sorted((w for w in itertools.product(range(-2, 3), repeat=3) if any(w)), key=lambda w: sum(c * c for c in w))


def first_along(those):
    """A small direction with positive products, or None."""
    return next((list(w) for w in SMALL if all(dot(w, x) > 0 for x in those)), None)


def apart(m, i, j):
    """Two triangles: if a plane parts them, one that is parallel to an edge of each, or to one of them, or across one does."""
    (a, b), middle = ([m.values(f)[:3] for f in (i, j)], lambda p: [sum(c) / 3 for c in zip(*p)])
    edges = [[sub(p[k], p[k - 1]) for k in range(3)] for p in (a, b)]
    normals = [cross(*e[:2]) for e in edges]
    found = [sub(middle(b), middle(a)), *(cross(x, y) for x in edges[0] for y in edges[1]), *normals]
    found += [cross(x, normal) for e, normal in zip(edges, normals) for x in e]
    for w in map(primitive, found):
        for w in (w, [-c for c in w]):
            if max(map(abs, w)) < 1 << 60 and not m.is_far_from_apart(i, j, w) and m.is_apart(pair_of((i, j), APART, [w])):
                return pair_of((i, j), APART, [w])
    return None


def by_chain(m, i, j):
    for v in m.faces[i][0]:
        found = m.path(v, m.faces[j][0])
        if found and len(found[1]) < 8:
            pair = pair_of((i, j), CHAIN, [], *found)
            pair.directions = [first_along(those) for those in m.of_chain(pair)]
            if pair.directions[0]:
                return pair
    return None


def at_edge(m, i, j):
    pair = pair_of((i, j), AT_EDGE, [], feet=(Q(1, 2), Q(1, 2)))
    pair.directions = [first_along(those) for those in m.of_edge(pair) or [()]]
    return pair if len(pair.directions) == 2 and all(pair.directions) else None


def pairs_of(m, blocks, draw):
    """Those that must be listed, and some that need not be; and those for which nothing was found."""
    pairs, missing = [], []
    for i, j in itertools.combinations(range(len(m.faces)), 2):
        if not m.must_be_listed(blocks, i, j):
            if draw.random() < .02 and not m.common(i, j):
                pairs.append(draw.choice((by_chain, apart))(m, i, j))
            continue
        ways = [at_edge, by_chain] if m.common(i, j) else draw.choice(([apart, by_chain], [by_chain, apart]))
        pairs.append(next(filter(None, (way(m, i, j) for way in ways)), None))
        if not pairs[-1]:
            missing.append((i, j))
    return list(filter(None, pairs)), missing


def forged(shape, matrix_of, blocks, seed=0):
    """A proof, with a list of pairs that are not proved. shape: degree, points, tetrahedra, images. The program proves the domain."""
    degree, points, tetrahedra, _ = shape
    data = linear(*shape)
    base, m = solid.proved(linear(degree, points, tetrahedra, points)), read(data)
    body = PairsBody.__new__(PairsBody)
    body.magic, body.planes, body.domain = b"VTD2", [[] for _ in m.faces], base.body.domain
    body.trees = [[["leaf", 12, matrix_of(t), []]] for t in range(len(tetrahedra))]
    body.blocks = [[list(block), list(matrix), []] for block, matrix in blocks]
    proof = Proof.__new__(Proof)
    proof.data, proof.body = data, body
    body.pairs, proof.missing = pairs_of(m, body.blocks, random.Random(seed))
    proof.statement = {"faces" if k == "patches" else k: "dms-solid-2" if k == "claim" else v for k, v in base.statement.items()}
    return proof


def of_cells(*cells):
    return [6 * cell + t for cell in cells for t in range(6)]


def of_neighbours(cells):
    """Blocks of any two cells that have a common face."""
    both = itertools.combinations(enumerate(cells), 2)
    return [(of_cells(i, j), UNIT) for (i, a), (j, b) in both if sum(abs(x - y) for x, y in zip(a, b)) == 1]


# What a lying prover says of faces whose images meet.

def misdirected(m, i, j):
    middles = [[sum(c) for c in zip(*m.values(f))] for f in (i, j)]
    w = primitive(sub(*middles[::-1]))
    return pair_of((i, j), APART, [w if any(w) and max(map(abs, w)) < 1 << 60 else [0, 0, 1]])


def chained(m, i, j):
    found = m.path(m.faces[i][0][0], m.faces[j][0])
    return pair_of((i, j), CHAIN, misdirected(m, i, j).directions, *found or ([m.faces[i][0][0], m.faces[j][0][0]], [m.faces[i][1]]))


def edged(m, i, j):
    return pair_of((i, j), AT_EDGE, [[1, 0, 0], [0, 1, 0]], feet=(Q(0), Q(1)))


LIES = {"U6_left_out": None, "U6_direction": misdirected, "U5_around": chained, "U4_edge": edged}


def lied(proof, lie):
    """With something about the pairs that are missing; in blocks, more than these may be wrong."""
    assert proof.missing
    proof = copy.deepcopy(proof)
    if lie == "in_blocks":
        m, matrices = read(proof.data), [tree[0][2] for tree in proof.body.trees]
        two = sorted({tuple(sorted(m.faces[f][1] for f in pair)) for pair in proof.missing})
        proof.body.blocks += [[list(t), matrices[t[0]], []] for t in two if t[0] != t[1]]
    elif LIES[lie]:
        proof.body.pairs += [LIES[lie](read(proof.data), *faces) for faces in proof.missing]
        proof.body.pairs.sort(key=lambda pair: pair.faces)
    return proof


# ---------------------------------------------------------------- bars, arms, bodies

CIRCLE = [(0, -5), (3, -4), (4, -3), (5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4)]      # of the radius 5


def on_circle(k):
    return [Q(c, 5) for c in CIRCLE[k % len(CIRCLE)]]


def turn(k, next_one):
    """The turn back from the middle of two points of the circle, times a number."""
    a, b = on_circle(k), on_circle(next_one)
    s, c = a[0] + b[0], -a[1] - b[1]
    length = Q(round((s * s + c * c) * 64), 64) / 2 or Q(1)
    return [c, s, Q(0), -s, c, Q(0), Q(0), Q(0), length]


def coil(degree, cells, pitch):
    """A bar that goes round once with each twelve cells, and up by `pitch` with each."""
    points, tetrahedra = grid_domain((cells, 1, 1))
    images = []
    for x, y, z in points:
        a = on_circle(int(x))
        images.append([(3 - y) * a[0], (3 - y) * a[1], z + pitch * x])
    return degree, points, tetrahedra, images


@functools.lru_cache(None)
def coiled(degree, cells, pitch):
    """Blocks are two cells."""
    blocks = [(of_cells(k - 1, k), turn(k, k)) for k in range(1, cells)]
    return forged(coil(degree, cells, pitch), lambda t: turn(t // 6, t // 6 + 1), blocks, cells)


@functools.lru_cache(None)
def bowed(degree, gap, height, lean):
    """Two arms on a base, `gap` cells between them, that lean to each other by `lean` with each cell."""
    wide = gap + 2
    cells = [c for c in itertools.product(range(wide), (0,), range(height + 1)) if c[2] == 0 or c[0] in (0, wide - 1)]
    points, tetrahedra = grid_domain((wide, 1, height + 1), lambda cell: cell in cells)
    images = [[x + max(z - 1, 0) * (lean if x < Q(wide, 2) else -lean), y, z] for x, y, z in points]
    return forged((degree, points, tetrahedra, images), lambda t: UNIT, of_neighbours(cells), height)


@functools.lru_cache(64)
def two_bodies(degree, scale, place):
    """Two cubes; the image of the first one has `scale` times its size, that of the second one is moved to `place`."""
    points, tetrahedra = grid_domain((1, 1, 1))
    other = [[v + len(points) for v in t] for t in tetrahedra]
    images = [[scale * c for c in p] for p in points] + [[a + b for a, b in zip(p, place)] for p in points]
    points = points + [[p[0] + 3, p[1], p[2] + 1] for p in points]
    return forged((degree, points, tetrahedra + other, images), lambda t: UNIT, [(of_cells(k), UNIT) for k in (0, 1)], degree)


@functools.lru_cache(None)
def with_void():
    """A cube of 26 cells around a void."""
    cells = [c for c in itertools.product(range(3), repeat=3) if c != (1, 1, 1)]
    points, tetrahedra = grid_domain((3, 3, 3), lambda cell: cell in cells)
    return forged((1, points, tetrahedra, points), lambda t: UNIT, of_neighbours(cells))


@functools.lru_cache(None)
def in_a_row(k, cells=3):
    """A bar whose cells are blocks; pairs by chains with edges, too."""
    points, tetrahedra = grid_domain((cells, 1, 1))
    draw = random.Random(k)
    images = [[c + Q(draw.randint(-4, 4), 64) for c in p] for p in points]
    return forged((1, points, tetrahedra, images), lambda t: UNIT, [(of_cells(c), UNIT) for c in range(cells)], k)


TOUCH = Q(1, 12)                                          # the pitch at which a coil lies on itself
NEAR = Q(1, 1 << 14)
COILS = ((13, TOUCH + NEAR), (11, Q(0)), (14, Q(1, 8)), (8, Q(1, 40)))
BOWS = ((1, 2, Q(1, 8)), (1, 1, Q(0)), (2, 2, Q(1, 3)), (1, 2, Q(-1, 2)))


def some_forged(rng):
    degree = rng.choice((1, 1, 2))
    proof = rng.choice((lambda: coiled(1, *rng.choice(COILS)), lambda: bowed(degree, *rng.choice(BOWS)),
                        lambda: in_a_row(rng.randrange(POOL))))()
    assert not proof.missing
    return copy.deepcopy(proof)


def any_proof(rng):
    return some(rng) if rng.random() < .6 else some_forged(rng)
