#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against the checkers of the claim dms-solid-1: matrices of other leaves, leaves that knots cut, hulls that reach into the
domain, tiles that do not tile, domains and images that overlap, maps that fold; the rest is right. As vmodel_liars.py, whose harness this is.
VERITOPE names the program that proves the honest ones. Run

    python3 tests/mutation/dms_liars.py --count 10000 --honest 200 --seed 1 --python-share .2 --checker PATH_TO_veritope-check

Whether a matrix, a leaf, a hull or a tile is a lie is computed here, from the page, for the knots of one tetrahedron: those can never be excluded."""
import copy
import functools
import itertools
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as Q

import patch_attacks
import vmodel_liars

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support")]
import dms_files as files                                 # noqa: E402

CONDITIONS = ["B2", "J1", "J2", "W3"]                      # needed alone; without another one, what follows it fails
HAIR, POOL = Q(1, 1 << 40), 6


# ---------------------------------------------------------------- honest proofs

@functools.lru_cache(None)
def proved(data):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "m.vdms")
        path.write_bytes(data)
        program = os.environ.get("VERITOPE", ROOT / "build" / "bin" / "veritope")
        done = subprocess.run([program, "certify", path, "--no-check", "--certificate", f"{path}.cert"], capture_output=True, text=True,
                              check=False, timeout=600)
        assert done.returncode in (0, 1), done.stdout + done.stderr
        return files.Proof(data, pathlib.Path(f"{path}.cert").read_bytes())


def moved(clouds, shift):
    return [[[c + shift for c in knot] for knot in cloud] for cloud in clouds]


def warp_of(k, shift):
    """A polynomial map, one to one on all blocks of at most three cells, moved by `shift` along all axes before and after it; its shape is
    drawn."""
    draw = random.Random(k)
    a, b, c = (Q(draw.randint(-4, 4), 64) for _ in range(3))
    turn = draw.choice(((0, 1, 2), (1, 2, 0), (2, 0, 1)))

    def warp(p):
        x, y, z = p[0] - shift, p[1] - shift, p[2] - shift
        bent = [x + a * y * y, y + b * z * x, z + c * x * y]
        return [bent[i] + shift for i in turn]
    return warp


BLOCKS = {"block": (2, (1, 1, 1), 0, False), "bar": (2, (2, 1, 1), 0, False), "cubic": (3, (1, 1, 1), 0, False),
          "inner": (2, (2, 2, 2), Q(1, 8), False), "outward": (2, (1, 1, 1), Q(1, 20), True)}


@functools.lru_cache(None)
def made(name, k, shift=0):
    if name == "ring":
        points, tetrahedra = files.grid_domain((3, 3, 1), lambda cell: cell != (1, 1, 0))
        return files.model(1, moved([[p] for p in points], shift), tetrahedra, warp_of(k, shift))
    if name == "separate":
        return files.separate(made("block", k, shift))
    degree, counts, radius, reach = BLOCKS[name]
    points, tetrahedra = files.grid_domain(counts)
    clouds = files.clouds_of(points, degree, counts, radius, k, reach)
    return files.model(degree, moved(clouds, shift), tetrahedra, warp_of(k, shift))


def honest_proof(name, k, shift=0):
    return copy.deepcopy(proved(made(name, k, shift)))


def some(rng, *names):
    return honest_proof(rng.choice(names), rng.randrange(POOL))


def two_cubes(degree, of_domain, of_image):
    """The second cube is moved by a vector in the domain, and by another one in the image."""
    points, tetrahedra = files.grid_domain((1, 1, 1))
    other = [[v + len(points) for v in t] for t in tetrahedra]
    apart = [[a + b for a, b in zip(p, of_domain)] for p in points]
    control = {}
    for at in {at for t in tetrahedra + other for at in itertools.combinations_with_replacement(sorted(t), degree)}:
        move = of_image if at[0] >= len(points) else (0, 0, 0)
        control[at] = [sum(points[v % len(points)][c] for v in at) / degree + move[c] for c in range(3)]
    return files.text(degree, [[p] for p in points + apart], tetrahedra + other, control)


# ---------------------------------------------------------------- the truth about one tetrahedron

def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def volume(a, b, c, d):
    return dot(cross(sub(b, a), sub(c, a)), sub(d, a))


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def determinant(m):
    return dot(m[0], cross(m[1], m[2]))


def linear_part(points, values):
    """The matrix of the affine map that takes four points to four values."""
    e, f = ([sub(p, those[0]) for p in those[1:]] for those in (points, values))
    dual = [cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])]
    d = dot(e[0], dual[0])
    return [[sum(f[m][i] * dual[m][j] for m in range(3)) / d for j in range(3)] for i in range(3)]


def is_monotone(r, g):
    m = product(r, g)
    s = [[m[i][j] + m[j][i] for j in range(3)] for i in range(3)]
    return s[0][0] > 0 and s[0][0] * s[1][1] > s[0][1] ** 2 and determinant(s) > 0


def rows(numbers):
    return [numbers[i:i + 3] for i in (0, 3, 6)]


class Read:
    """The model of a file with shared control points."""

    def __init__(self, data):
        file = json.loads(data)
        self.n, self.tetrahedra = file["degree"], file["tetrahedra"]
        self.clouds = [[[Q(c) for c in knot] for knot in cloud] for cloud in file["vertices"]]
        self.control = {tuple(c["at"]): [Q(x) for x in c["value"]][:3] for c in file["control"]}

    def knot(self, v, i):
        return self.clouds[v][i if i < len(self.clouds[v]) else 0]

    def corners(self, t):
        return [self.clouds[v][0] for v in self.tetrahedra[t]]

    def gammas(self, total):
        return [g for g in itertools.product(range(total + 1), repeat=4) if sum(g) == total]

    def knots(self, t, gamma):
        """W, V"""
        corners = self.tetrahedra[t]
        return ([self.knot(v, i) for v, i in zip(corners, gamma)],
                [self.knot(v, i) for v, g in zip(corners, gamma) for i in range(g + 1)])

    def derivatives(self, t):
        for gamma in self.gammas(self.n - 1):
            values = []
            for m in range(4):
                beta = [g + (i == m) for i, g in enumerate(gamma)]
                values.append(self.control[tuple(sorted(v for v, b in zip(self.tetrahedra[t], beta) for _ in range(b)))])
            yield [[self.n * x for x in row] for row in linear_part(self.knots(t, gamma)[0], values)]

    def is_against(self, t, matrix):
        return any(not is_monotone(matrix, g) for g in self.derivatives(t))

    def triangles(self, t):
        for gamma in self.gammas(self.n - 1):
            for three in itertools.combinations(self.knots(t, gamma)[1], 3):
                if any(cross(sub(three[1], three[0]), sub(three[2], three[0]))):
                    yield three

    def is_cut(self, t):
        """A point of a triangle of knots is found inside of the tetrahedron."""
        shares = [(Q(a, 6), Q(b, 6), Q(6 - a - b, 6)) for a in range(7) for b in range(7 - a)]
        return any(is_inside(self.corners(t), [dot(share, [k[c] for k in three]) for c in range(3)])
                   for three in self.triangles(t) for share in shares)

    def is_crossed(self, face, t):
        """A triangle of knots of the tetrahedron crosses the face, within it."""
        corners = [self.clouds[v][0] for v in face]
        normal = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
        for three in self.triangles(t):
            heights = [dot(normal, sub(k, corners[0])) for k in three]
            if min(heights) >= 0 or max(heights) <= 0:
                continue
            ends = [[x + (y - x) * h / (h - g) for x, y in zip(a, b)]
                    for (a, h), (b, g) in itertools.combinations(zip(three, heights), 2) if h * g < 0]
            ends += [k for k, h in zip(three, heights) if h == 0]
            middle = [(x + y) / 2 for x, y in zip(ends[0], ends[1])]
            if all(dot(cross(sub(corners[i - 2], corners[i]), sub(middle, corners[i])), normal) > 0 for i in range(3)):
                return True
        return False

    def boundary(self):
        """(face, tetrahedron) in the order of the page."""
        faces = [((q, r, s), (p, s, r), (p, q, s), (p, r, q)) for p, q, r, s in self.tetrahedra]
        least = lambda f: min(f[i:] + f[:i] for i in range(3))             # noqa: E731
        known = {least(f) for four in faces for f in four}
        return [(f, t) for t, four in enumerate(faces) for f in four if least(f[::-1]) not in known]


def is_inside(corners, p):
    return all(volume(*[p if i == k else c for i, c in enumerate(corners)]) > 0 for k in range(4))


# ---------------------------------------------------------------- lies

TURNS = ([[-1, 0, 0], [0, -1, 0], [0, 0, 1]], [[1, 0, 0], [0, -1, 0], [0, 0, -1]], [[0, 1, 0], [0, 0, 1], [1, 0, 0]],
         [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [[1, 9, 0], [0, 1, 0], [0, 0, 1]], [[1, 0, -12], [0, 1, 0], [3, 0, 1]])


def misled_leaves(rng):
    """J1: a matrix against a derivative of the tetrahedron's own; in one of two leaves, too."""
    proof = some(rng, "block", "bar", "cubic", "ring", "inner", "outward")
    t = rng.randrange(len(proof.body.trees))
    tree = proof.body.trees[t]
    if len(tree) > 1:
        return
    turned = [x for row in product(rng.choice(TURNS), rows(tree[0][2])) for x in row]
    other = ["leaf", 12, rng.choice((turned, rng.choice(proof.body.trees)[-1][2][::-1])), []]
    if determinant(rows(other[2])) <= 0 or not Read(proof.data).is_against(t, rows(other[2])):
        return
    cut = ["cut", rng.randrange(6), rng.choice((None, Q(rng.randint(1, 7), 8), HAIR))]
    proof.body.trees[t] = rng.choice(([other], [cut, other, tree[0]], [cut, tree[0], other], [cut, cut, tree[0], tree[0], other]))
    yield "J1_matrix", proof


def mirrors(rng):
    """J3: R has the determinant 0, or is turned inside out, for a map that is, too."""
    proof, what = some(rng, "block", "bar", "cubic"), rng.randrange(3)
    if what == 0:
        leaf = rng.choice(proof.body.trees)[-1]
        leaf[2] = rng.choice(([-c for c in leaf[2]], [Q(0)] * 9, leaf[2][:6] + leaf[2][:3]))
        yield "J3_matrix", proof
        return
    axis = rng.randrange(3)
    change_control(proof, lambda at, value: [-c if i == axis else c for i, c in enumerate(value)])
    for tree in proof.body.trees:
        for node in tree:
            if node[0] == "leaf":
                node[2] = [-c if i % 3 == axis else c for i, c in enumerate(node[2])]
    yield "J3_mirror", proof


def change_control(proof, change):
    file = json.loads(proof.data)
    for entry in file["control"]:
        value = change(tuple(entry.get("at", ())), [Q(c) for c in entry["value"]])
        entry["value"] = [str(c) for c in value]
    proof.data = json.dumps(file).encode()


def folded_maps(rng):
    """J1: a control point so far away that the determinant of a derivative is not positive: no matrix helps."""
    proof = some(rng, "block", "bar", "cubic", "ring", "inner")
    which = rng.choice(sorted(Read(proof.data).control))
    step = [Q(rng.randint(-8, 8), rng.choice((1, 4))) for _ in range(3)]
    change_control(proof, lambda at, value: [a + b for a, b in zip(value, step)] if at == which else value)
    model = Read(proof.data)
    for t, tree in enumerate(proof.body.trees):
        if len(tree) == 1 and any(determinant(g) <= 0 for g in model.derivatives(t)):
            yield "J1_folded", proof
            return


def cut_leaves(rng):
    """J2: leaves of kind P inside of which there are triangles of knots, or whose matrix is against a derivative."""
    proof = some(rng, "inner", "outward") if rng.random() < .7 else some(rng, "block", "cubic")
    model, t = Read(proof.data), rng.randrange(len(proof.body.trees))
    tree = proof.body.trees[t]
    if len(tree) > 1:
        return
    tree[0][1] = 13
    if model.is_cut(t):
        if rng.random() < .5:
            tree[0][3] = lying_planes(rng, model.corners(t))
        yield "J2_cut", proof
    elif all(len(cloud) == 1 for cloud in model.clouds):
        # The map of the tetrahedron is one polynomial, whose Bernstein coefficients these derivatives are.
        tree[0][2] = [x for row in product(rng.choice(TURNS), rows(tree[0][2])) for x in row]
        if determinant(rows(tree[0][2])) > 0 and model.is_against(t, rows(tree[0][2])):
            yield "J2_matrix", proof


def lying_planes(rng, corners):
    """Through the middle of the corners, and beside them."""
    out = []
    for _ in range(rng.randint(1, 4)):
        v = [Q(rng.randint(-3, 3)) for _ in range(3)]
        if any(v):
            out.append([*v, sum(dot(v, c) for c in corners) / len(corners) + rng.choice((0, 0, HAIR, -HAIR, 5, -5))])
    return out


def open_hulls(rng):
    """E3: a knot of the boundary inside of a tetrahedron, with or without planes that cut it."""
    proof = some(rng, "block", "bar", "cubic", "inner")
    file, model = json.loads(proof.data), Read(proof.data)
    face, t = rng.choice(model.boundary())
    v = rng.choice(face)
    if len(file["vertices"][v]) > 1:
        return
    corners, size = model.corners(t), Q(1, rng.choice((8, 64, 1 << 30)))
    own = model.tetrahedra[t].index(v)
    shares = [1 - 3 * size if i == own else size for i in range(4)]
    knot = [str(dot(shares, [c[i] for c in corners])) for i in range(3)]
    file["vertices"][v] += [knot] * (file["degree"] - 1)
    proof.data = json.dumps(file).encode()
    if rng.random() < .5:
        proof.body.planes = [lying_planes(rng, corners) for _ in proof.body.planes]
    yield "E3_inside", proof


def bad_clouds(rng):
    """E1, E2: control points that disagree; a knot on the other side of a face."""
    if rng.random() < .5:
        proof = honest_proof("separate", rng.randrange(POOL))
        file, groups = json.loads(proof.data), {}
        for i, c in enumerate(file["control"]):
            corners = file["tetrahedra"][c["tetrahedron"]]
            groups.setdefault(tuple(sorted(v for v, b in zip(corners, c["beta"]) for _ in range(b))), []).append(i)
        one = rng.choice(rng.choice([g for g in groups.values() if len(g) > 1]))
        axis = rng.randrange(3)
        value = file["control"][one]["value"]
        value[axis] = str(Q(value[axis]) + rng.choice((HAIR, -HAIR, Q(1, 1000))))
        proof.data = json.dumps(file).encode()
        yield "E1_apart", proof
        return
    proof = honest_proof("inner", rng.randrange(POOL))
    file, model = json.loads(proof.data), Read(proof.data)
    v = next(i for i, cloud in enumerate(model.clouds) if len(cloud) > 1)
    t = rng.choice([t for t, four in enumerate(model.tetrahedra) if v in four])
    own = model.tetrahedra[t].index(v)
    corners = model.corners(t)
    shares = [Q(rng.randint(1, 4), 8) for _ in range(4)]
    shares[own] = rng.choice((Q(0), -HAIR, Q(-1)))
    shares[own - 1] += 1 - sum(shares)
    file["vertices"][v][1] = [str(dot(shares, [c[i] for c in corners])) for i in range(3)]
    proof.data = json.dumps(file).encode()
    yield "E2_behind", proof


def no_domains(rng):
    """D1, D2, D3: tetrahedra that are reversed, twice there, or overlap those of another part."""
    what = rng.randrange(3)
    if what < 2:
        proof = some(rng, "block", "bar", "inner", "ring")
        file = json.loads(proof.data)
        tetrahedra = file["tetrahedra"]
        t = rng.randrange(len(tetrahedra))
        if what == 0:
            a, b = rng.sample(range(4), 2)
            tetrahedra[t][a], tetrahedra[t][b] = tetrahedra[t][b], tetrahedra[t][a]
        else:
            tetrahedra.append(tetrahedra[t])
            proof.body.trees.append(proof.body.trees[t])
            proof.lie = {"tetrahedra": len(tetrahedra)}
        proof.data = json.dumps(file).encode()
        yield ("D1_reversed", "D2_twice")[what], proof
        return
    degree, image = rng.choice((1, 2)), (3, rng.randint(0, 2), 0)
    proof = copy.deepcopy(proved(two_cubes(degree, image, image)))
    proof.data = two_cubes(degree, overlap(rng), image)
    yield "D3_overlap", proof


def overlap(rng):
    """A vector by which a unit cube is moved so that it meets the other one: inside, by a hair, or in a face."""
    out = [Q(rng.randint(-7, 7), 8) for _ in range(3)]
    out[rng.randrange(3)] = rng.choice((Q(1), 1 - HAIR, Q(-1), Q(0)))
    return out


def images_that_meet(rng):
    """T3: the map is one to one on each of two parts, but not on both."""
    degree, place = rng.choice((1, 2)), (3, rng.randint(0, 2), 0)
    proof = copy.deepcopy(proved(two_cubes(degree, place, place)))
    proof.data = two_cubes(degree, place, overlap(rng))
    yield "T3_overlap", proof


def parts_of_others(rng):
    """D3, T3: star boxes around another surface, far away."""
    name, k = rng.choice(("block", "bar", "cubic", "ring", "inner")), rng.randrange(POOL)
    proof, other = honest_proof(name, k), honest_proof(name, k, 100)
    if rng.random() < .5:
        proof.body.surface = other.body.surface
        yield "T3_other", proof
    else:
        proof.body.domain = other.body.domain
        yield "D3_other", proof


def no_tilings(rng):
    """T1: tiles are left out, there twice, reversed, out of the plane, or overlap."""
    proof, what = honest_proof("outward", rng.randrange(POOL)), rng.randrange(5)
    body = proof.body
    face = rng.choice([i for i, tiles in enumerate(body.tiles) if len(tiles) > 3])
    tiles = body.tiles[face]
    at = rng.randrange(len(tiles))
    if what == 0:
        del tiles[at]
    elif what == 1:
        tiles.insert(rng.randrange(len(tiles)), tiles[at])
    elif what == 2:
        tiles[at][0].reverse()
    elif what == 3:
        model = Read(proof.data)
        added = [p - len(model.clouds) for p in tiles[at][0] if p >= len(model.clouds)]
        if not added:
            return
        step = rng.choice((HAIR, -HAIR))
        body.points[added[0]] = [a + step * b for a, b in zip(body.points[added[0]], normal_of(model, face))]
    else:
        tiles[at], tiles[at - 1] = ([*tiles[at][0][:2], tiles[at - 1][0][2]], tiles[at][1]), tiles[at - 1]
        if len(set(tiles[at][0])) == 3 and areas_add_up(proof, face):
            return
    yield "T1_tiles", proof


def normal_of(model, face):
    a, b, c = (model.clouds[v][0] for v in model.boundary()[face][0])
    return cross(sub(b, a), sub(c, a))


def areas_add_up(proof, face):
    """Then this test cannot tell."""
    model = Read(proof.data)
    normal, points = normal_of(model, face), [cloud[0] for cloud in model.clouds] + proof.body.points
    area = lambda t: dot(normal, cross(sub(points[t[1]], points[t[0]]), sub(points[t[2]], points[t[0]])))    # noqa: E731
    each = [area(at) for at, _ in proof.body.tiles[face]]
    return min(each) > 0 and sum(each) == dot(normal, normal)


def crossed_faces(rng):
    """T2: a face that a triangle of knots crosses is its only tile."""
    proof = honest_proof("outward", rng.randrange(POOL))
    model = Read(proof.data)
    face = rng.randrange(len(proof.body.tiles))
    of, t = model.boundary()[face]
    if not model.is_crossed(of, t):
        return
    planes = lying_planes(rng, [model.clouds[v][0] for v in of])
    proof.body.tiles[face] = rng.choice(([], [(list(of), planes)]))
    yield "T2_crossed", proof


def wrong_numbers(rng):
    """W3, B1, B2: numbers that are not those of the solid, cuts at the ends of edges, numbers of too many digits."""
    proof, what = some(rng, "block", "bar", "cubic", "ring", "inner", "outward"), rng.randrange(4)
    if what < 2:
        key = rng.choice(("tetrahedra", "control_points", "leaves", "patches", "shells", "bodies", "genus"))
        proof.lie = {key: counted(proof)[key] + rng.choice((1, 2, 1 << 20))}
        yield "W3_numbers", proof
        return
    tree = rng.choice(proof.body.trees)
    leaf = tree[-1]
    if what == 2:
        leaf[2] = [c + Q(1, 3 ** 700) for c in leaf[2]]
        yield "B2_long", proof
        return
    tree[:] = [["cut", rng.randrange(6), rng.choice((Q(0), Q(1), 1 + HAIR, -HAIR))], leaf, leaf]
    yield "B1_cut", proof


def counted(proof):
    """The numbers of an honest proof."""
    return json.loads(proof.certificate().split(b"\n", 1)[0])


STRATEGIES = ((misled_leaves, 12), (mirrors, 4), (folded_maps, 8), (cut_leaves, 8), (open_hulls, 8), (bad_clouds, 6), (no_domains, 6),
              (images_that_meet, 4), (parts_of_others, 4), (no_tilings, 6), (crossed_faces, 4), (wrong_numbers, 4))


def told(strategy, rng):
    """(name, model, certificate)"""
    for name, proof in strategy(rng):
        yield name, proof.data, proof.certificate(**getattr(proof, "lie", {}))


def dms_attacks(rng):
    strategy, = rng.choices([s for s, _ in STRATEGIES], [w for _, w in STRATEGIES])
    yield from told(strategy, rng)


def honest(rng):
    name = rng.choice((*BLOCKS, "ring", "separate"))
    proof = honest_proof(name, rng.randrange(POOL))
    yield name, proof.data, proof.certificate()
    degree, place = rng.choice((1, 2)), (3, rng.randint(0, 2), 0)
    proof = proved(two_cubes(degree, place, place))
    yield "two cubes", proof.data, proof.certificate()


class Run(vmodel_liars.Run):
    conditions, implied = CONDITIONS, {}

    @staticmethod
    def attacks(rng):
        return patch_attacks.subjects(dms_attacks(rng))

    @staticmethod
    def honest_certificates(rng):
        return patch_attacks.subjects(honest(rng))


def missing_conditions(alone):
    return vmodel_liars.missing_conditions(alone, CONDITIONS)


if __name__ == "__main__":
    sys.exit(vmodel_liars.main(sys.argv[1:], Run, "dms", CONDITIONS))
