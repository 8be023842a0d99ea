#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Both checkers of dms-solid-2: honest certificates of `veritope certify` are accepted, and each lie dies by the condition that is named.
VERITOPE names the program."""
import copy
import json
import unittest
import unittest.mock
from fractions import Fraction as Q

import judges
from dms_solid_test import Case, bent, files
from veritope_checker.dms import dms_pairs

OTHER = [Q(c) for c in (1, 9, 0, 0, 1, 0, 0, 0, 1)]       # no matrix for maps near the identity
ONE = [Q(i % 4 == 0) for i in range(9)]
FAR = 9                                                   # along all axes of the domain


def cube(degree=3, radius=Q(1, 10), warp=bent, seed=1):
    """Six tetrahedra with outward clouds: so many patches that pairs of faces are taken."""
    points, tetrahedra = files.grid_domain((1, 1, 1))
    return files.model(degree, files.clouds_of(points, degree, (1, 1, 1), radius, seed, True), tetrahedra, warp)


def corner_shape(warp=lambda p: [p[0] + p[1] * p[1] / 64, p[1], p[2]]):
    """Three cubes in the shape of an L, with outward clouds off its inner edge."""
    points, tetrahedra = files.grid_domain((2, 2, 1), lambda cell: cell != (1, 1, 0))
    clouds = files.clouds_of(points, 3, (2, 2, 1), Q(1, 10), 1, True)
    clouds = [cloud if 0 in cloud[0][:2] else cloud[:1] for cloud in clouds]
    return files.model(3, clouds, tetrahedra, warp)


def beside(one, other, factor, shift):
    """Both models in one, the other one far away in the domain; its image is scaled and moved."""
    one, other = json.loads(one), json.loads(other)
    count = len(one["vertices"])
    one["vertices"] += [[[str(Q(c) + FAR) for c in knot] for knot in cloud] for cloud in other["vertices"]]
    one["tetrahedra"] += [[v + count for v in t] for t in other["tetrahedra"]]
    one["control"] += [{"at": [v + count for v in c["at"]], "value": [str(Q(x) * factor + s) for x, s in zip(c["value"], shift)]}
                       for c in other["control"]]
    return json.dumps(one).encode()


def eight_cubes():
    points, tetrahedra = files.grid_domain((2, 2, 2))
    return files.model(2, files.clouds_of(points, 2, (2, 2, 2), Q(1, 8), 1, True), tetrahedra)


def of_degree_1(data):
    """The identity of the same domain."""
    file = json.loads(data)
    points = [[Q(c) for c in cloud[0]] for cloud in file["vertices"]]
    return files.model(1, [[p] for p in points], file["tetrahedra"])


def moved_planes(planes):
    return [[*plane[:3], plane[3] + FAR * sum(plane[:3])] for plane in planes]


def moved_pair(pair, faces, vertices, tetrahedra):
    out = copy.deepcopy(pair)
    out.faces = [f + faces for f in pair.faces]
    out.chain, out.tetrahedra = [v + vertices for v in pair.chain], [t + tetrahedra for t in pair.tetrahedra]
    return out


def opposite(direction):
    return [-c for c in direction]


class Pairs(Case):
    def proof(self, data):
        proof = super().proof(data)
        self.assertEqual(proof.statement["claim"], "dms-solid-2")
        return proof

    def pair(self, proof, kind):
        return next(p for p in proof.body.pairs if p.kind == kind)

    def needed_pair(self, proof, kind):
        """Its faces have a common vertex and are in no common block."""
        of_face, faces = tetrahedra_of_faces(proof), boundary(proof)
        blocks = [set(tetrahedra) for tetrahedra, _, _ in proof.body.blocks]
        return next(p for p in proof.body.pairs if p.kind == kind and set(faces[p.faces[0]]) & set(faces[p.faces[1]])
                    and not any({of_face[f] for f in p.faces} <= block for block in blocks))

    # PROVES DMS-5
    def test_honest_ones(self):
        for data in (cube(), cube(4, Q(1, 20)), cube(radius=Q(1, 12), seed=5), corner_shape()):
            self.judged("ACCEPT", self.proof(data))

    def test_an_image_without_star_boxes(self):
        self.judged("ACCEPT", self.proof(cube(2, Q(1, 20), lambda p: [p[0] + 10**6 * p[1], p[1], p[2]])))

    # PROVES DMS-5.U1
    def test_a_block_that_leaves_the_domain(self):
        proof = self.proof(corner_shape())
        corners = [[proof_point(proof, v) for v in t] for t in json.loads(proof.data)["tetrahedra"]]
        first = next(i for i, c in enumerate(corners) if [2, 1, 0] in c)
        second = next(i for i, c in enumerate(corners) if [1, 2, 0] in c)
        for planes in [], [[Q(1), Q(1), Q(0), Q(3)], [Q(0), Q(0), Q(1), Q(1, 2)]]:
            forged = copy.deepcopy(proof)
            forged.body.blocks.append([sorted((first, second)), ONE, planes])
            self.dies_by("U1", forged)

    # PROVES DMS-5.U2
    def test_a_block_with_a_matrix_of_another_map(self):
        proof = self.proof(cube())
        proof.body.blocks.append([[0], OTHER, []])
        self.dies_by("U2", proof)

    # PROVES DMS-5.U3
    def test_a_face_whose_tetrahedron_is_no_leaf(self):
        proof = self.proof(eight_cubes())
        in_blocks = {t for tetrahedra, _, _ in proof.body.blocks for t in tetrahedra}
        t = next(i for i, four in enumerate(tetrahedra(proof)) if i not in in_blocks and any(set(f) <= set(four) for f in boundary(proof)))
        leaf = proof.body.trees[t][0]
        proof.body.trees[t] = [["cut", 0, None], leaf, leaf]
        self.dies_by("U3", proof)
        proof.body.blocks.append([[t], leaf[2], []])
        self.judged("ACCEPT", proof)

    # PROVES DMS-5.U4
    def test_directions_across_an_edge(self):
        honest = self.proof(cube())
        for lie in (lambda p: p.directions.reverse(), lambda p: p.directions.__setitem__(0, opposite(p.directions[0])),
                    lambda p: p.directions.__setitem__(1, [Q(0)] * 3)):
            proof = copy.deepcopy(honest)
            lie(self.pair(proof, files.AT_EDGE))
            self.dies_by("U4", proof)
        proof = copy.deepcopy(honest)
        self.pair(proof, files.CHAIN).kind = files.AT_EDGE
        pair = self.pair(proof, files.AT_EDGE)
        pair.feet, pair.directions = [Q(1, 2)] * 2, pair.directions * 2
        if pair.chain:
            self.judged("U4", proof)

    # PROVES DMS-5.U5
    def test_chains(self):
        honest = self.proof(cube())
        faces = boundary(honest)
        def turned(p):
            p.directions[0] = opposite(p.directions[0])
        def elsewhere(p):
            p.chain[0] = next(v for v in range(8) if v not in faces[p.faces[0]])
        def detached(p):
            p.chain.append(p.chain[0])
            p.tetrahedra.append(0)
        def in_another_tetrahedron(p):
            other = [v for v in faces[p.faces[1]] if v != p.chain[0]]
            v, t = next((v, t) for v in other for t, four in enumerate(tetrahedra(honest)) if v not in four)
            p.chain.append(v)
            p.tetrahedra.append(t)
        for lie in (turned, elsewhere, detached, in_another_tetrahedron):
            proof = copy.deepcopy(honest)
            lie(self.pair(proof, files.CHAIN))
            self.judged("U5", proof)
        proof = copy.deepcopy(honest)
        turned(self.pair(proof, files.CHAIN))
        self.dies_by("U5", proof)

    # PROVES DMS-5.U6
    def test_pairs_that_are_left_out_or_not_apart(self):
        honest = self.proof(eight_cubes())
        for kind in files.CHAIN, files.AT_EDGE:
            proof = copy.deepcopy(honest)
            proof.body.pairs.remove(self.needed_pair(proof, kind))
            self.dies_by("U6", proof)
            proof = copy.deepcopy(honest)
            pair = self.needed_pair(proof, kind)
            pair.kind, pair.chain, pair.tetrahedra, pair.feet = files.APART, [], [], []
            del pair.directions[1:]
            self.dies_by("U6", proof)

    # PROVES DMS-5.U7
    def test_a_solid_inside_of_another_one(self):
        """The map is one to one on the boundary, and not on the domain."""
        self.dies_by("U7", self.joined(eight_cubes(), eight_cubes(), Q(1, 4), [Q(3, 4)] * 3))

    def test_a_solid_beside_another_one(self):
        shift = [Q(9, 4)] * 3
        self.judged("ACCEPT", self.joined(eight_cubes(), eight_cubes(), Q(1, 4), shift))
        proof = self.proof(beside(eight_cubes(), eight_cubes(), Q(1, 4), shift))
        self.assertEqual((proof.statement["shells"], proof.statement["bodies"]), (2, 2))
        self.judged("ACCEPT", proof)

    def test_boxes_of_shells_that_touch(self):
        """A cube in the notch of an L: no boxes of two of their faces meet, but those of the shells do, in an edge."""
        shape, small = corner_shape(lambda p: p), cube(warp=lambda p: p)
        (_, right, _, back, _, _), (left, _, front, _, _, _) = map(self.box_of_values, (shape, small))
        for step, expected in ((Q(0), "U7"), (Q(1, 1 << 80), "ACCEPT"), (Q(-1, 1 << 80), "U7")):
            self.judged(expected, self.joined(shape, small, 1, [right - left + step, back - front, Q(0)]))

    def box_of_values(self, data):
        """By the Python checker's own parts: how they are used is tested here, not what they are."""
        found, tested = [], dms_pairs.Pairs.test_shells

        def test_shells(pairs, shells, bodies):
            every = [pairs.box_of_values(i) for i in range(len(pairs.boundary))]
            found.extend((max if end % 2 else min)(box[end] for box in every) for end in range(6))
            tested(pairs, shells, bodies)
        with unittest.mock.patch.object(dms_pairs.Pairs, "test_shells", test_shells):
            self.judged("ACCEPT", self.proof(data))
        return found

    def joined(self, one, other, factor, shift):
        """The certificate of both, of the parts of those of each of them."""
        data = beside(one, other, factor, shift)
        first, second, of_domain = self.proof(one), self.proof(other), super().proof(of_degree_1(data))
        counts = [len(json.loads(one)[key]) for key in ("vertices", "tetrahedra")]
        proof = copy.deepcopy(first)
        proof.data, body = data, proof.body
        body.pairs += [moved_pair(pair, len(body.planes), *counts) for pair in second.body.pairs]
        body.trees += second.body.trees
        body.planes += [moved_planes(planes) for planes in second.body.planes]
        body.blocks += [[[t + counts[1] for t in block[0]], block[1], moved_planes(block[2])] for block in second.body.blocks]
        body.domain = of_domain.body.domain
        proof.statement.update(tetrahedra=len(body.trees), shells=2, bodies=2,
                               control_points=first.statement["control_points"] + second.statement["control_points"])
        return proof

    def test_wrong_numbers(self):
        proof = self.proof(cube())
        for key in ("tetrahedra", "control_points", "leaves", "faces", "shells", "bodies", "genus"):
            self.dies_by("W3", proof, **{key: 7 + proof.statement[key]})

    def test_the_layout(self):
        proof = self.proof(cube())
        honest = proof.body.encode()
        far = b"\xff\xff\xff\x0f"
        for body in (honest[:-1], honest + b"\0", b"VTDM" + honest[4:], honest[:4] + far + honest[8:], honest[:8] + far + honest[12:],
                     honest[:12] + far + honest[16:], honest[:16] + far + honest[20:], b"", b"VTD2"):
            code, line = judges.both(proof.data, proof.certificate(body))
            self.assertEqual((code, judges.condition(line)), (1, "B1"), line)

    def test_numbers_that_name_nothing(self):
        honest = self.proof(cube())
        def chain(p):
            return self.pair(p, files.CHAIN)
        lies = (lambda p: p.body.blocks.append([[], ONE, []]), lambda p: p.body.blocks.append([[6], ONE, []]),
                lambda p: p.body.blocks.append([[0, 0], ONE, []]), lambda p: p.body.blocks.append([[2, 1], ONE, []]),
                lambda p: p.body.blocks.append([[0], ONE, [[Q(1), Q(0), Q(0), Q(9)]] * 65]),
                lambda p: chain(p).chain.__setitem__(0, 8), lambda p: p.body.pairs.reverse(),
                lambda p: p.body.pairs.append(p.body.pairs[-1]), lambda p: chain(p).faces.reverse(),
                lambda p: p.body.pairs[-1].faces.__setitem__(1, 12), lambda p: setattr(p.body.pairs[0], "kind", 3),
                lambda p: self.pair(p, files.AT_EDGE).feet.__setitem__(0, Q(9, 8)),
                lambda p: self.pair(p, files.AT_EDGE).feet.__setitem__(1, Q(-1, 8)))
        for number, lie in enumerate(lies):
            proof = copy.deepcopy(honest)
            lie(proof)
            code, line = judges.both(proof.data, proof.certificate())
            self.assertEqual((code, judges.condition(line)), (1, "B1"), (number, line))

    def test_blocks_of_many_tetrahedra(self):
        proof = self.proof(eight_cubes())
        proof.body.blocks.append([list(range(16)), ONE, [[Q(1), Q(0), Q(0), Q(9)]] * 64])
        self.judged("ACCEPT", proof)
        proof.body.blocks[-1][0].append(16)
        self.judged("B1", proof)

    def test_long_numbers(self):
        honest = self.proof(cube())
        for lie in (lambda p: p.body.blocks.append([[0], [c * 3**50 for c in ONE], []]),
                    lambda p: self.pair(p, files.CHAIN).directions.__setitem__(0, [Q(3**50)] * 3),
                    lambda p: self.pair(p, files.AT_EDGE).feet.__setitem__(0, Q(1, 3**50)),
                    lambda p: p.body.blocks.append([[0], ONE, [[Q(1), Q(0), Q(0), Q(1, 3**700)]]])):
            proof = copy.deepcopy(honest)
            lie(proof)
            self.judged("B2", proof)


def tetrahedra(proof):
    return json.loads(proof.data)["tetrahedra"]


def proof_point(proof, vertex):
    return [Q(c) for c in json.loads(proof.data)["vertices"][vertex][0]]


def tetrahedra_of_faces(proof):
    return [next(t for t, four in enumerate(tetrahedra(proof)) if set(face) <= set(four)) for face in boundary(proof)]


def boundary(proof):
    faces = [f for p, q, r, s in tetrahedra(proof) for f in ((q, r, s), (p, s, r), (p, q, s), (p, r, q))]
    turns = {f[i:] + f[:i] for f in faces for i in range(3)}
    return [f for f in faces if f[::-1] not in turns]


if __name__ == "__main__":
    unittest.main()
