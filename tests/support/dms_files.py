# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Simplex-spline solids over grids of cubes, and their certificates as Python values, for tests that forge them."""
import hashlib
import itertools
import json
import random
import struct
from fractions import Fraction as Q


# ---------------------------------------------------------------- models

def grid_domain(counts, keep=lambda cell: True):
    """(points, tetrahedra): cells of unit cubes, each cut into six tetrahedra along a diagonal."""
    cells = [c for c in itertools.product(*map(range, counts)) if keep(c)]
    numbers, tetrahedra = {}, []
    for cell in cells:
        for order in itertools.permutations(range(3)):
            at, corners = list(cell), [cell]
            for axis in order:
                at[axis] += 1
                corners.append(tuple(at))
            even = order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
            names = [numbers.setdefault(c, len(numbers)) for c in corners]
            tetrahedra.append(names if even else [*names[:2], names[3], names[2]])
    return [[Q(c) for c in p] for p in numbers], tetrahedra


def clouds_of(points, degree, counts, radius, seed, reach=False):
    """Clouds of inner vertices, drawn; with `reach` of those on the boundary of a block of cells, too, outward."""
    draw, out = random.Random(seed), []
    for p in points:
        on_side = [c in (0, n) for c, n in zip(p, counts)]
        cloud = [p]
        if radius and (reach or not any(on_side)):
            for _ in range(degree - 1):
                cloud.append([c + shift(draw, radius, c, n) for c, n in zip(p, counts)])
        out.append(cloud)
    return out


def shift(draw, radius, c, n):
    step = Q(draw.randint(-100, 100), 100) * radius
    return -abs(step) if c == 0 else abs(step) if c == n else step


def model(degree, clouds, tetrahedra, warp=lambda p: p, attributes=()):
    """The bytes of a file whose control points are the warped places by the Greville rule. warp: exact."""
    control = {}
    for t in tetrahedra:
        for at in itertools.combinations_with_replacement(sorted(t), degree):
            knots = [clouds[v][k if len(clouds[v]) > 1 else 0] for v in sorted(set(at)) for k in range(at.count(v))]
            control[at] = warp([sum(c) / degree for c in zip(*knots)])
    return text(degree, clouds, tetrahedra, control, attributes)


def text(degree, clouds, tetrahedra, control, attributes=()):
    numbers = lambda values: [str(Q(c)) for c in values]      # noqa: E731
    return json.dumps({
        "format": "veritope-dms-1", "degree": degree, "attributes": list(attributes),
        "vertices": [[numbers(knot) for knot in cloud] for cloud in clouds], "tetrahedra": tetrahedra,
        "control": [{"at": list(at), "value": numbers(value)} for at, value in sorted(control.items())]}).encode()


def separate(data):
    """A file of this solid with control points of each tetrahedron: clouds need n + 1 knots."""
    file = json.loads(data)
    n, control = file["degree"], {tuple(c["at"]): c["value"] for c in file["control"]}
    file["vertices"] = [cloud if len(cloud) == 1 else cloud + cloud[-1:] for cloud in file["vertices"]]
    file["control"] = [
        {"tetrahedron": t, "beta": list(beta),
         "value": control[tuple(sorted(v for v, b in zip(corners, beta) for _ in range(b)))]}
        for t, corners in enumerate(file["tetrahedra"])
        for beta in itertools.product(range(n + 1), repeat=4) if sum(beta) == n]
    return json.dumps(file).encode()


# ---------------------------------------------------------------- certificates

def varint(n):
    out = b""
    while n > 127:
        out, n = out + bytes([n & 127 | 128]), n >> 7
    return out + bytes([n])


def zigzag(z):
    return varint(2 * z if z >= 0 else -2 * z - 1)


def rational(x):
    p, q = Q(x).numerator, Q(x).denominator
    if max(abs(p), q) < 1 << 63:
        return zigzag(p) + varint(q)
    size = lambda n: (n.bit_length() + 7) // 8                # noqa: E731
    top, bottom = abs(p).to_bytes(size(abs(p)), "little"), q.to_bytes(size(q), "little")
    return b"\0\0" + varint(1 + len(top)) + bytes([p < 0]) + top + varint(len(bottom)) + bottom


class Cursor:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, n):
        self.at += n
        return self.data[self.at - n:self.at]

    def u32(self):
        return struct.unpack("<I", self.take(4))[0]

    def varint(self):
        value = shift_by = 0
        while True:
            byte = self.take(1)[0]
            value |= (byte & 127) << shift_by
            shift_by += 7
            if byte < 128:
                return value

    def zigzag(self):
        code = self.varint()
        return -(code + 1 >> 1) if code & 1 else code >> 1

    def rational(self):
        p, q = self.zigzag(), self.varint()
        if q:
            return Q(p, q)
        top, bottom = self.take(self.varint()), self.take(self.varint())
        return Q((1 - 2 * top[0]) * int.from_bytes(top[1:], "little"), int.from_bytes(bottom, "little"))

    def rationals(self, n):
        return [self.rational() for _ in range(n)]

    def planes(self):
        return [self.rationals(4) for _ in range(self.varint())]


def planes_of(those):
    return varint(len(those)) + b"".join(rational(x) for p in those for x in p)


def tree_of(c):
    nodes, open_nodes = [], 1
    while open_nodes:
        symbol = c.take(1)[0]
        if symbol >= 12:
            nodes.append(["leaf", symbol, c.rationals(9), c.planes()])
            open_nodes -= 1
        else:
            nodes.append(["cut", symbol % 6, c.rational() if symbol >= 6 else None])
            open_nodes += 1
    return nodes


def trees_as_bytes(trees):
    out = b""
    for node in itertools.chain.from_iterable(trees):
        if node[0] == "leaf":
            out += bytes([node[1]]) + b"".join(map(rational, node[2])) + planes_of(node[3])
        else:
            out += bytes([node[1] + 6 * (node[2] is not None)]) + (b"" if node[2] is None else rational(node[2]))
    return out


class Body:
    """trees: of nodes ("cut", edge, t or None) or ("leaf", kind, 9 numbers, planes); tiles: (points, planes) each."""

    def __init__(self, data):
        c = Cursor(data)
        self.magic = c.take(4)
        tetrahedra, faces = c.u32(), c.u32()
        self.points = [c.rationals(3) for _ in range(c.u32())]
        self.trees = [tree_of(c) for _ in range(tetrahedra)]
        self.planes = [c.planes() for _ in range(faces)]
        self.tiles = [[([c.varint() for _ in range(3)], c.planes()) for _ in range(c.varint())] for _ in range(faces)]
        self.domain, self.surface = c.take(c.u32()), c.take(c.u32())
        assert c.at == len(data)

    def encode(self):
        out = self.magic + struct.pack("<III", len(self.trees), len(self.planes), len(self.points))
        out += b"".join(rational(x) for point in self.points for x in point) + trees_as_bytes(self.trees)
        out += b"".join(map(planes_of, self.planes))
        for tiles in self.tiles:
            out += varint(len(tiles)) + b"".join(b"".join(map(varint, at)) + planes_of(those) for at, those in tiles)
        return out + b"".join(struct.pack("<I", len(part)) + part for part in (self.domain, self.surface))

    def counts(self):
        return {"patches": sum(len(tiles) or 1 for tiles in self.tiles)}


APART, CHAIN, AT_EDGE = range(3)


class Pair:
    """Two faces of the boundary: chain, tetrahedra of a CHAIN; feet of AT_EDGE; directions, two of AT_EDGE."""

    def __init__(self, c):
        self.faces, self.kind = [c.varint(), c.varint()], c.take(1)[0]
        edges = c.varint() if self.kind == CHAIN else -1
        self.chain, self.tetrahedra = [c.varint() for _ in range(edges + 1)], [c.varint() for _ in range(edges)]
        self.feet = c.rationals(2 if self.kind == AT_EDGE else 0)
        self.directions = [c.rationals(3) for _ in range(2 if self.kind == AT_EDGE else 1)]

    def encode(self):
        out = b"".join(map(varint, self.faces)) + bytes([self.kind])
        if self.kind == CHAIN:
            out += b"".join(map(varint, [len(self.tetrahedra), *self.chain, *self.tetrahedra]))
        return out + b"".join(map(rational, [*self.feet, *itertools.chain.from_iterable(self.directions)]))


class PairsBody:
    """A body of version 2. blocks: [tetrahedra, 9 numbers, planes] each; pairs: of class Pair."""

    def __init__(self, data):
        c = Cursor(data)
        self.magic = c.take(4)
        tetrahedra, faces, blocks, pairs = (c.u32() for _ in range(4))
        self.trees = [tree_of(c) for _ in range(tetrahedra)]
        self.planes = [c.planes() for _ in range(faces)]
        self.blocks = [[[c.varint() for _ in range(c.varint())], c.rationals(9), c.planes()] for _ in range(blocks)]
        self.pairs = [Pair(c) for _ in range(pairs)]
        self.domain = c.take(c.u32())
        assert c.at == len(data)

    def encode(self):
        out = self.magic + struct.pack("<IIII", len(self.trees), len(self.planes), len(self.blocks), len(self.pairs))
        out += trees_as_bytes(self.trees) + b"".join(map(planes_of, self.planes))
        for tetrahedra, matrix, planes in self.blocks:
            out += varint(len(tetrahedra)) + b"".join(map(varint, tetrahedra)) + b"".join(map(rational, matrix)) + planes_of(planes)
        out += b"".join(pair.encode() for pair in self.pairs)
        return out + struct.pack("<I", len(self.domain)) + self.domain

    def counts(self):
        return {"faces": len(self.planes)}


class Proof:
    """A model and its certificate, either of which may be changed."""

    def __init__(self, data, certificate):
        line, body = certificate.split(b"\n", 1)
        self.data, self.statement = data, json.loads(line)
        self.body = (PairsBody if body[:4] == b"VTD2" else Body)(body)

    def certificate(self, body=None, **values):
        """With all hashes right, and the number of leaves and of patches or faces that the body has."""
        body = self.body.encode() if body is None else body
        counts = {"leaves": sum(node[0] == "leaf" for tree in self.body.trees for node in tree), **self.body.counts()}
        statement = {**self.statement, "subject_sha256": hashlib.sha256(self.data).hexdigest(),
                     "subject_bytes": len(self.data), "body_sha256": hashlib.sha256(body).hexdigest(), **counts, **values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body
