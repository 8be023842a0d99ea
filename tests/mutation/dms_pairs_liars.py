#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against the checkers of the claim dms-solid-2: blocks that the domain leaves, matrices and directions against a derivative,
chains that lead nowhere, pairs that are left out, bent bars and arms whose images meet, bodies one of which has its image in another one's,
solids turned inside out; the rest is right. As dms_liars.py, whose models and whose harness these are. VERITOPE names the program that proves
the honest ones that it can. Run

    python3 tests/mutation/dms_pairs_liars.py --count 10000 --honest 200 --seed 1 --python-share .2 --checker PATH_TO_veritope-check

dms_pairs_forge.py makes the honest ones, and says what is a lie."""
import copy
import itertools
import json
import sys
from fractions import Fraction as Q

import patch_attacks
import vmodel_liars
from dms_liars import HAIR, TURNS, change_control, counted, determinant, dot, is_inside, is_monotone, lying_planes, overlap, product, rows, sub
from dms_files import APART, AT_EDGE, CHAIN
from dms_pairs_forge import (BLOCKS, BOWS, LIES, NEAR, POOL, SMALL, TOUCH, UNIT, any_proof, bowed, coiled, honest_proof, is_false_body, lied,
                             made, pair_of, read, some, some_forged, two_bodies, with_void)

CONDITIONS = ["B2", "J1", "J2", "J3", "U1", "U2", "U3", "U4", "U5", "U6", "U7", "W3"]        # needed alone


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
