#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against the checkers of the claim dms-solid-2: blocks that the domain leaves, matrices and directions against a derivative,
chains that lead nowhere, pairs that are left out, bent bars and arms whose images meet, bodies one of which has its image in another one's,
solids turned inside out; the rest is right. As dms_liars.py, whose models and whose harness these are. VERITOPE names the program that proves
the honest ones that it can; others are proved here, for maps that are linear in each tetrahedron. Run

    python3 tests/mutation/dms_pairs_liars.py --count 10000 --honest 200 --seed 1 --python-share .2 --checker PATH_TO_veritope-check

Whether a matrix, a direction or a block is a lie is computed here, from the page: for the V of a tetrahedron's own, which always reach it, and
for those of others that no plane of the page parts from it."""
import copy
import functools
import itertools
import json
import random
import sys
from fractions import Fraction as Q
from math import gcd, lcm

import dms_liars as solid
import patch_attacks
import vmodel_liars
from dms_files import APART, AT_EDGE, CHAIN, Pair, PairsBody, Proof, clouds_of, grid_domain, model, separate, text
from dms_liars import (HAIR, TURNS, change_control, counted, cross, determinant, dot, is_inside, is_monotone, lying_planes, overlap, product, rows,
                       sub)

CONDITIONS = ["B2", "J1", "J2", "J3", "U1", "U2", "U3", "U4", "U5", "U6", "U7", "W3"]        # needed alone
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


# ---------------------------------------------------------------- models of which the claim is false

def placed(rng, proof):
    """The image, larger or smaller and moved: numbers that floating point does not have."""
    scale, shift = rng.choice((Q(1), Q(1, 3), Q(10 ** 9, 7))), [rng.choice((Q(0), Q(1, 3), Q(-10 ** 7, 9))) for _ in range(3)]
    change_control(proof, lambda at, value: [scale * c + d for c, d in zip(value, shift)])
    return proof


def meeting(rng):
    """A coil that runs into itself, or lies on itself; arms that lean into each other, or touch. Some pairs are not proved."""
    if rng.random() < .5:
        return "coil", coiled(1, rng.choice((13, 14)), rng.choice((Q(0), TOUCH, TOUCH - NEAR, Q(1, 20))))
    # They touch if height * lean = gap / 2.
    gap, height = rng.choice(((1, 2), (1, 1), (2, 2)))
    lean = Q(gap, 2 * height) + rng.choice((Q(0), NEAR, Q(1, 8)))
    return "arms", bowed(rng.choice((1, 1, 2)), gap, height, lean)


def meeting_images(rng):
    lie = rng.choice(list(LIES))
    yield lie + "_meeting", placed(rng, lied(meeting(rng)[1], lie))


def wide_blocks(rng):
    """U1, U2: blocks of two tetrahedra whose images meet: the domain leaves the hull between the arms; the bar in it turns too far."""
    name, proof = meeting(rng)
    proof = lied(proof, "in_blocks")
    if rng.random() < .3:
        m, blocks = read(proof.data), proof.body.blocks
        blocks[-1][2] = lying_planes(rng, m.corners(rng.choice(blocks[-1][0])))
    yield ("U1_arms" if name == "arms" else "U2_coil"), placed(rng, proof)


def several_shells(rng):
    """U7: on the boundary the map is one to one, but the image of a body lies in that of another one; or there is a void. U6: these images
    meet."""
    what, degree = rng.randrange(3), rng.choice((1, 2))
    if what == 0:
        yield "U7_void", copy.deepcopy(with_void())
    elif what == 1:
        proof = two_bodies(1, rng.choice((3, 4)), tuple(Q(rng.randint(1, 15), 8) for _ in range(3)))
        assert not proof.missing
        yield "U7_nested", copy.deepcopy(proof)
    else:
        lie, proof = rng.choice([*LIES, "in_blocks"]), two_bodies(degree, 1, tuple(overlap(rng)))
        yield lie + "_bodies", placed(rng, lied(proof, lie))


def beside(rng):
    """Two bodies whose images lie in boxes that are apart."""
    proof = two_bodies(rng.choice((1, 2)), 4, (Q(rng.choice((-2, 5))), Q(rng.randint(-2, 2)), Q(1)))
    assert not proof.missing
    return placed(rng, copy.deepcopy(proof))


def mirrors(rng):
    """J3: the image is turned inside out, and all matrices and directions with it."""
    proof, axis = any_proof(rng), rng.randrange(3)
    change_control(proof, lambda at, value: [-c if i == axis else c for i, c in enumerate(value)])
    matrices = [node for tree in proof.body.trees for node in tree if node[0] == "leaf"]
    what = rng.randrange(3)
    for node in matrices:
        node[2] = [-c if i % 3 == axis else c for i, c in enumerate(node[2])]
    for block in proof.body.blocks:
        block[1] = [-c if i % 3 == axis else c for i, c in enumerate(block[1])]
    for pair in proof.body.pairs:
        pair.directions = [[-c if i == axis else c for i, c in enumerate(w)] for w in pair.directions]
    if what == 0:                                         # with matrices of a positive determinant
        for node in matrices:
            node[2] = [-c for c in node[2]]
    yield "J3_mirror" if what else "J1_mirror", proof


def moved_points(rng):
    """A control point is moved, or the map is another one: a matrix or a direction is no longer right."""
    if rng.random() < .3:
        name, k = rng.choice(list(BLOCKS)), rng.randrange(POOL)
        proof = honest_proof(name, k)
        proof.data = made(name, k, 0, rng.randrange(POOL))
    else:
        proof = any_proof(rng)
        which = rng.choice(sorted(read(proof.data).control))
        step = [Q(rng.randint(-8, 8), rng.choice((4, 16, 64))) for _ in range(3)]
        change_control(proof, lambda at, value: [a + b for a, b in zip(value, step)] if at == which else value)
    false = is_false_body(proof)
    if false:
        yield false + ("_moved" if is_false_body(proof, False) else "_moved_near"), proof


def near_lies(rng):
    """U2, U4, U5, U6: a matrix or a direction is bent until it is against a derivative of another tetrahedron, not of its own."""
    proof = some(rng, "cubic", "bar", "eight")
    m, alone = read(proof.data), read(proof.data, False)
    bend = [Q(rng.randint(-8, 8)) for _ in range(9)]
    if rng.random() < .4:
        block = rng.choice(proof.body.blocks)
        start, others = block[1], m.of_block(block)
        for k in range(129):
            block[1] = [a + b * max(map(abs, start)) * k / 256 for a, b in zip(start, bend)]
            if any(m.is_against(t, rows(block[1])) for t in block[0]):
                return
            if any(not is_monotone(rows(block[1]), g) for g in others):
                yield "U2_near", proof
                return
        return
    pair = rng.choice(proof.body.pairs)
    at, size = rng.randrange(len(pair.directions)), max(abs(c) for w in pair.directions for c in w)
    start = pair.directions[at]
    for k in range(65):
        pair.directions[at] = [a + b * size * k / 256 for a, b in zip(start, bend)]
        if m.is_false(pair):
            if not alone.is_false(pair):
                yield ("U6_near", "U5_near", "U4_near")[pair.kind], proof
            return


# ---------------------------------------------------------------- certificates that are false

def turned(rng, matrix):
    return [x for row in product(rng.choice(TURNS), rows(matrix)) for x in row]


def misled_leaves(rng):
    """J1, J2: a matrix against a derivative of the tetrahedron's own; a leaf of kind P that knots cut, of a tetrahedron in a block."""
    proof = any_proof(rng)
    t = rng.randrange(len(proof.body.trees))
    tree, m = proof.body.trees[t], read(proof.data)
    if len(tree) > 1:
        return
    if rng.random() < .4:
        if m.is_cut(t):
            tree[0][1] = 13
            if not any(t in block for block, _, _ in proof.body.blocks):
                proof.body.blocks.append([[t], tree[0][2], []])
            if rng.random() < .3:
                tree[0][3] = lying_planes(rng, m.corners(t))
            yield "J2_cut", proof
        return
    other = rng.choice((turned(rng, tree[0][2]), rng.choice(proof.body.trees)[-1][2][::-1]))
    if determinant(rows(other)) > 0 and m.is_against(t, rows(other)):
        tree[0][2] = other
        yield "J1_matrix", proof


def misled_blocks(rng):
    """U2: a matrix against a derivative of a tetrahedron of the block; one more tetrahedron."""
    proof, what = any_proof(rng), rng.randrange(3)
    block, m = rng.choice(proof.body.blocks), read(proof.data)
    if what == 0:
        block[1] = turned(rng, block[1])
    elif what == 1:
        block[1] = rng.choice((rng.choice(proof.body.blocks)[1], [-c for c in block[1]], [Q(0)] * 9, block[1][::-1]))
    else:
        block[0] = sorted({*block[0], rng.randrange(len(m.tetrahedra))})
    if not any(m.is_against(t, rows(block[1])) for t in block[0]):
        return
    if rng.random() < .3:
        block[2] = lying_planes(rng, m.corners(block[0][0]))
    yield "U2_matrix", proof


def left_hulls(rng):
    """U1: a block of tetrahedra of both arms; a point of a face of the boundary is found inside of four of its corners."""
    proof = copy.deepcopy(bowed(rng.choice((1, 2)), *rng.choice(BOWS)))
    m = read(proof.data)
    block = sorted(rng.sample(range(len(m.tetrahedra)), rng.randint(2, 3)))
    corners = [list(p) for p in sorted({tuple(p) for t in block for p in m.corners(t)})]
    fours = [four if determinant([sub(p, four[0]) for p in four[1:]]) > 0 else (four[1], four[0], *four[2:])
             for four in itertools.combinations(corners, 4)]
    rng.shuffle(fours)
    shares = rng.choice(((Q(1, 3),) * 3, (Q(1, 2), Q(1, 4), Q(1, 4)), (Q(1, 8), Q(3, 4), Q(1, 8))))
    points = [[dot(shares, [m.place(v)[c] for v in face]) for c in range(3)] for face, _ in m.faces]
    if any(m.is_against(t, rows(UNIT)) for t in block) or not any(is_inside(four, p) for four in fours[:60] for p in points):
        return
    planes = lying_planes(rng, m.corners(block[0])) if rng.random() < .5 else []
    proof.body.blocks.insert(rng.randint(0, 3), [block, UNIT, planes])
    yield "U1_hull", proof


def unknown_faces(rng):
    """U3: the tree of a tetrahedron at the boundary is cut, or a leaf of kind P, and it is in no block."""
    proof = honest_proof("eight", rng.randrange(POOL)) if rng.random() < .6 else any_proof(rng)
    m, body = read(proof.data), proof.body
    t = rng.choice(m.faces)[1]
    if len(body.trees[t]) > 1:
        return
    if rng.random() < .8:
        free = [t for _, t in m.faces if len(body.trees[t]) == 1 and not any(t in block for block, _, _ in body.blocks)]
        t = rng.choice(free) if free else t
    body.blocks = [block for block in body.blocks if t not in block[0]]
    leaf = body.trees[t][0]
    if rng.random() < .3:
        leaf[1] = 13
    else:
        cut = ["cut", rng.randrange(6), rng.choice((None, Q(rng.randint(1, 7), 8), HAIR))]
        body.trees[t] = [cut, leaf, copy.deepcopy(leaf)]
    yield "U3_unknown", proof


def other_direction(rng, proof, pair, k):
    w = pair.directions[k]
    other = rng.choice(proof.body.pairs).directions
    return rng.choice(([-c for c in w], [Q(0)] * 3, rng.choice(SMALL), rng.choice(other), w[1:] + w[:1],
                       [c if i == rng.randrange(3) else Q(0) for i, c in enumerate(w)]))


def pick(rng, proof, kind):
    those = [pair for pair in proof.body.pairs if pair.kind == kind]
    return rng.choice(those) if those else None


def yield_if_false(proof, pair, name):
    if read(proof.data).is_false(pair):
        yield name, proof


def wrong_edges(rng):
    """U4: directions flipped, swapped or others, other feet; faces without a common edge."""
    proof, what = any_proof(rng), rng.randrange(5)
    pair = pick(rng, proof, AT_EDGE if what else rng.choice((CHAIN, APART)))
    if not pair:
        return
    if what == 0:
        w = pair.directions[0]
        new = pair_of(pair.faces, AT_EDGE, [w, rng.choice((w, [-c for c in w]))], feet=(Q(rng.randint(0, 4), 4), Q(rng.randint(0, 4), 4)))
        proof.body.pairs[proof.body.pairs.index(pair)] = pair = new
    elif what == 1:
        pair.directions.reverse()
    elif what == 2:
        pair.feet = [rng.choice((Q(0), Q(1), Q(rng.randint(0, 16), 16), HAIR)) for _ in range(2)]
    else:
        k = rng.randrange(2)
        pair.directions[k] = other_direction(rng, proof, pair, k)
    yield from yield_if_false(proof, pair, "U4_" + ("no_edge", "swapped", "feet", "direction", "direction")[what])


def wrong_chains(rng):
    """U5: chains from and to other vertices, edges that are in no such tetrahedron, ways there and back, other directions."""
    proof, what = any_proof(rng), rng.randrange(7)
    pair = pick(rng, proof, CHAIN)
    if what == 6:
        pair = pick(rng, proof, rng.choice((APART, AT_EDGE)))
    if not pair:
        return
    m = read(proof.data)
    if what == 0:
        pair.directions[0] = other_direction(rng, proof, pair, 0)
    elif what == 1:
        pair.chain[rng.randrange(len(pair.chain))] = rng.randrange(len(m.clouds))
    elif what == 2:
        pair.chain.reverse()
        pair.tetrahedra.reverse()
        pair.directions = rng.choice((pair.directions, [[-c for c in w] for w in pair.directions]))
    elif what == 3 and pair.tetrahedra:
        pair.tetrahedra[rng.randrange(len(pair.tetrahedra))] = rng.randrange(len(m.tetrahedra))
    elif what == 4 and pair.tetrahedra:
        del pair.tetrahedra[-1], pair.chain[rng.choice((0, -1))]
    elif what == 5:
        t = rng.choice([t for t, four in enumerate(m.tetrahedra) if pair.chain[0] in four])
        pair.chain[:0] = [pair.chain[0], rng.choice(m.tetrahedra[t])]
        pair.tetrahedra[:0] = [t, t]
    elif what == 6:
        found = m.path(rng.choice(m.faces[pair.faces[0]][0]), m.faces[pair.faces[1]][0])
        new = pair_of(pair.faces, CHAIN, pair.directions[:1], *found)
        proof.body.pairs[proof.body.pairs.index(pair)] = pair = new
    yield from yield_if_false(proof, pair, "U5_" + ("direction", "vertex", "back", "tetrahedron", "short", "detour", "other")[what])


def missing_pairs(rng):
    """U6: pairs are left out, or called apart, or a block in which they were is; other directions."""
    proof, what = any_proof(rng), rng.randrange(5)
    m, body = read(proof.data), proof.body
    if what < 2:
        if not body.pairs:
            return
        at = rng.randrange(len(body.pairs))
        pair = body.pairs[at]
        if what == 0:
            del body.pairs[at]
            if m.must_be_listed(body.blocks, *pair.faces):
                yield "U6_left_out", proof
        else:
            body.pairs[at] = pair_of(pair.faces, APART, [rng.choice((pair.directions[0], [-c for c in pair.directions[0]], rng.choice(SMALL)))])
            yield from yield_if_false(proof, body.pairs[at], "U6_apart")
    elif what == 2:
        pair = pick(rng, proof, APART)
        if pair:
            pair.directions[0] = other_direction(rng, proof, pair, 0)
            yield from yield_if_false(proof, pair, "U6_direction")
    elif what == 3:
        at = rng.randrange(len(body.blocks))
        gone = body.blocks[at]
        gone[0] = gone[0][:1]
        listed = {tuple(pair.faces) for pair in body.pairs}
        pairs = (p for p in itertools.combinations(range(len(m.faces)), 2) if p not in listed)
        if any(m.must_be_listed(body.blocks, *p) for p in pairs):
            yield "U6_block", proof
    else:
        face = rng.randrange(len(m.faces))
        gone = [pair for pair in body.pairs if face in pair.faces]
        body.pairs = [pair for pair in body.pairs if face not in pair.faces]
        if any(m.must_be_listed(body.blocks, *pair.faces) for pair in gone):
            yield "U6_face", proof


def parts_of_others(rng):
    """D3: star boxes around another surface, far away. D1, D2, E2, E3: as about tiles."""
    if rng.random() < .5:
        name, k = rng.choice(list(BLOCKS)), rng.randrange(POOL)
        proof = honest_proof(name, k)
        proof.body.domain = honest_proof(name, k, 100).body.domain
        yield "D3_other", proof
        return
    proof, what = some(rng, "cubic", "bar", "eight"), rng.randrange(3)
    file, m = json.loads(proof.data), read(proof.data)
    t = rng.randrange(len(m.tetrahedra))
    if what == 0:
        a, b = rng.sample(range(4), 2)
        file["tetrahedra"][t][a], file["tetrahedra"][t][b] = file["tetrahedra"][t][b], file["tetrahedra"][t][a]
    elif what == 1:
        file["tetrahedra"].append(file["tetrahedra"][t])
        proof.body.trees.append(proof.body.trees[t])
        proof.lie = {"tetrahedra": len(file["tetrahedra"])}
    else:                                                 # a knot of the boundary, inside of a tetrahedron
        face, t = rng.choice(m.faces)
        v = rng.choice(face)
        size = Q(1, rng.choice((8, 64, 1 << 30)))
        shares = [1 - 3 * size if x == v else size for x in m.tetrahedra[t]]
        file["vertices"][v][1] = [str(dot(shares, [c[i] for c in m.corners(t)])) for i in range(3)]
        if rng.random() < .5:
            proof.body.planes = [lying_planes(rng, m.corners(t)) for _ in proof.body.planes]
    proof.data = json.dumps(file).encode()
    yield ("D1_reversed", "D2_twice", "E3_inside")[what], proof


def apart_control(rng):
    """E1: control points of one place are two."""
    proof = honest_proof("separate", rng.randrange(POOL))
    file, groups = json.loads(proof.data), {}
    for i, c in enumerate(file["control"]):
        corners = file["tetrahedra"][c["tetrahedron"]]
        groups.setdefault(tuple(sorted(v for v, b in zip(corners, c["beta"]) for _ in range(b))), []).append(i)
    one = rng.choice(rng.choice([g for g in groups.values() if len(g) > 1]))
    value, axis = file["control"][one]["value"], rng.randrange(3)
    value[axis] = str(Q(value[axis]) + rng.choice((HAIR, -HAIR, Q(1, 1000))))
    proof.data = json.dumps(file).encode()
    yield "E1_apart", proof


def wrong_numbers(rng):
    """W3, B2: numbers that are not those of the solid; numbers of too many digits, of the same planes and directions."""
    proof = any_proof(rng)
    body, what = proof.body, rng.randrange(6)
    if what < 3:
        key = rng.choice(("tetrahedra", "control_points", "leaves", "faces", "shells", "bodies", "genus"))
        proof.lie = {key: counted(proof)[key] + rng.choice((1, 2, 1 << 20))}
        yield "W3_numbers", proof
        return
    scale = rng.choice((Q(1 << 90), Q(1, 1 << 90), Q(1 << 1030), Q(3 ** 50, 5 ** 60)))
    if what == 3:
        block = rng.choice(body.blocks)
        block[1] = [scale * c for c in block[1]]
    elif what == 4 and body.pairs:
        pair = rng.choice(body.pairs)
        pair.directions[-1] = [scale * c for c in pair.directions[-1]]
    else:
        pair = pick(rng, proof, AT_EDGE)
        if what == 5 and pair:
            pair.feet[rng.randrange(2)] += Q(rng.choice((1, -1)), 1 << 70)
            if not all(0 <= f <= 1 for f in pair.feet):
                return
        else:
            block = rng.choice(body.blocks)
            block[2].append([Q(1), Q(1, 1 << 1030), Q(0), Q(1000)])
    yield "B2_long", proof


def wrong_bytes(rng):
    """B1: pairs in another order or twice, numbers of what there is not, empty blocks, feet beside the edge, other counts."""
    proof = any_proof(rng)
    body, m, what = proof.body, read(proof.data), rng.randrange(15)
    at = rng.randrange(len(body.pairs) - 1) if len(body.pairs) > 1 else None
    if what < 8 and at is None:
        return
    pair = body.pairs[at] if at is not None else None
    if what == 0:
        body.pairs[at], body.pairs[at + 1] = body.pairs[at + 1], pair
    elif what == 1:
        body.pairs.insert(at, copy.deepcopy(pair))
    elif what == 2:
        pair.faces = rng.choice((pair.faces[::-1], [pair.faces[0]] * 2))
    elif what == 3:
        pair.kind, pair.chain, pair.tetrahedra, pair.feet = rng.choice((3, 4, 255)), [], [], []
    elif what == 4:
        pair = pick(rng, proof, AT_EDGE)
        if not pair:
            return
        pair.feet[rng.randrange(2)] = rng.choice((Q(-1, 8), Q(9, 8), 1 + HAIR, -HAIR))
    elif what == 5:
        body.pairs[-1].faces[1] = len(m.faces) + rng.choice((0, 1, 1 << 32))
    elif what in (6, 7):
        pair = pick(rng, proof, CHAIN)
        those = pair and (pair.chain if what == 6 else pair.tetrahedra)
        if not those:
            return
        those[rng.randrange(len(those))] = (len(m.clouds) if what == 6 else len(m.tetrahedra)) + rng.choice((0, 1 << 32))
    elif what == 8:
        block = rng.choice([block for block in body.blocks if len(block[0]) > 1])
        block[0] = rng.choice(([], [len(m.tetrahedra)], [1 << 32], block[0] * 2, block[0][::-1], block[0][:1] + block[0]))
    elif what == 9:
        rng.choice(body.blocks)[2].append([Q(0), Q(0), Q(0), Q(rng.randint(-1, 1))])
    elif what == 10:                                      # true, but too much
        block = rng.choice(body.blocks)
        most = len(m.tetrahedra)
        if most > 16 and rng.random() < .5:
            block[0] = sorted(rng.sample(range(most), 17))
        else:
            block[2] = [[Q(1), Q(0), Q(0), Q(1000)]] * 65
    elif what == 11:
        proof.lie = {"claim": "dms-solid-1"}
    else:
        raw = body.encode()
        k = 4 * rng.randint(1, 4)
        count = int.from_bytes(raw[k:k + 4], "little")
        other = rng.choice((count + 1, max(count, 1) - 1, (1 << 32) - 1)).to_bytes(4, "little")
        proof.raw = (raw + b"\0", raw[:k] + other + raw[k + 4:], rng.choice((b"VTDM", b"VTD3")) + raw[4:])[what - 12]
    yield "S1_claim" if what == 11 else "B1_%d" % what, proof


STRATEGIES = ((meeting_images, 8), (wide_blocks, 6), (several_shells, 8), (mirrors, 4), (moved_points, 8), (near_lies, 10), (misled_leaves, 6),
              (misled_blocks, 8), (left_hulls, 6), (unknown_faces, 6), (wrong_edges, 12), (wrong_chains, 14), (missing_pairs, 12),
              (parts_of_others, 3), (apart_control, 1), (wrong_numbers, 6), (wrong_bytes, 6))


def told(strategy, rng):
    """(name, model, certificate)"""
    for name, proof in strategy(rng):
        yield name, proof.data, proof.certificate(getattr(proof, "raw", None), **getattr(proof, "lie", {}))


def dms_pairs_attacks(rng):
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    yield from told(strategy, rng)


def honest(rng):
    name = rng.choice((*BLOCKS, "separate"))
    proof = honest_proof(name, rng.randrange(POOL))
    yield name, proof.data, proof.certificate()
    proof = some_forged(rng)
    yield "forged", proof.data, proof.certificate()
    proof = beside(rng)
    yield "beside", proof.data, proof.certificate()


class Run(vmodel_liars.Run):
    conditions, implied = CONDITIONS, {}

    @staticmethod
    def attacks(rng):
        return patch_attacks.subjects(dms_pairs_attacks(rng))

    @staticmethod
    def honest_certificates(rng):
        return patch_attacks.subjects(honest(rng))


def missing_conditions(alone):
    return vmodel_liars.missing_conditions(alone, CONDITIONS)


if __name__ == "__main__":
    sys.exit(vmodel_liars.main(sys.argv[1:], Run, "dms_pairs", CONDITIONS))
