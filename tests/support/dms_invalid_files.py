# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of the claim dms-invalid-1, made by hand for tests: models come from dms_files, and each function encodes one kind of
witness."""
import hashlib
import itertools
import json
import struct
from fractions import Fraction as Q

from dms_files import rational, varint, zigzag

FINDINGS = ("tet-reversed", "tet-face-overused", "cloud-degenerate", "cloud-no-core", "cloud-inside", "jacobian", "jacobian-zero",
            "M4", "M6", "M7", "M9", "meeting", "crossing", "covering")
KINDS_OF_MAPS = (5, 6, 11, 12, 13)
FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))       # of a tetrahedron, by its corners


class Proof:
    """A model and a witness about it, all of which may be changed. planes: lists of the faces of the boundary, by their numbers; the
    others are empty."""

    def __init__(self, data, kind, witness, planes=None):
        self.data, self.kind, self.witness, self.planes = data, kind, witness, planes or {}

    def body(self):
        file = json.loads(self.data)
        out = b"VTDI" + struct.pack("<IB", len(file["tetrahedra"]), self.kind) + self.witness
        if self.kind in KINDS_OF_MAPS:
            faces = len(boundary(file))
            out += struct.pack("<I", faces) + b"".join(planes_of(self.planes.get(face, ())) for face in range(faces))
        return out

    def certificate(self, body=None, **values):
        body = self.body() if body is None else body
        statement = {"certificate": "veritope-certificate-1", "tool": "test", "claim": "dms-invalid-1", "subject_format": "vdms",
                     "subject_sha256": hashlib.sha256(self.data).hexdigest(), "subject_bytes": len(self.data),
                     "body_sha256": hashlib.sha256(body).hexdigest(), "finding": FINDINGS[self.kind],
                     "tetrahedra": len(json.loads(self.data)["tetrahedra"]), **values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


# ---------------------------------------------------------------- models

def boundary(file):
    """[(tetrahedron, number)] of the faces without an opposite one."""
    def turned(order):
        at = order.index(min(order))
        return (*order[at:], *order[:at])
    all_faces = [(t, number, turned([corners[c] for c in face])) for t, corners in enumerate(file["tetrahedra"])
                 for number, face in enumerate(FACES)]
    orders = {order for *_, order in all_faces}
    return [(t, number) for t, number, (a, b, c) in all_faces if (a, c, b) not in orders]


def determinant(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def d(a, b, c, e):
    return determinant(*([x - y for x, y in zip(p, a)] for p in (b, c, e)))


def height(simplex, m):
    """d with u in the place of point m as an affine function of u: three factors and a constant."""
    at = lambda u: d(*(u if i == m else p for i, p in enumerate(simplex)))        # noqa: E731
    zero = at((0, 0, 0))
    return [at(u) - zero for u in ((1, 0, 0), (0, 1, 0), (0, 0, 1))] + [zero]


def mean(points, weights):
    return [sum(w * x for w, x in zip(weights, column)) / Q(sum(weights)) for column in zip(*points)]


def bezier(value, barycentric):
    """A Bernstein form. value(beta): its coefficients, lists of numbers; barycentric: a list; the degree is that of the longest beta."""
    def at(prefix, degree):
        if degree == 0:
            return value(tuple(prefix))
        parts = [at([b + (i == m) for i, b in enumerate(prefix)], degree - 1) for m in range(len(barycentric))]
        return [sum(w * part[k] for w, part in zip(barycentric, parts)) for k in range(len(parts[0]))]
    return lambda degree: at([0] * len(barycentric), degree)


# ---------------------------------------------------------------- bodies

def rationals(numbers):
    return b"".join(map(rational, numbers))


def planes_of(planes):
    return varint(len(planes)) + b"".join(rationals(plane) for plane in planes)


def index(gamma):
    return bytes(gamma)


def face(tetrahedron, number):
    return varint(tetrahedron) + bytes([number])


def tet_reversed(data, tetrahedron):
    return Proof(data, 0, varint(tetrahedron))


def face_overused(data, f, g):
    return Proof(data, 1, face(*f) + face(*g))


def cloud_degenerate(data, tetrahedron, gamma):
    return Proof(data, 2, varint(tetrahedron) + index(gamma))


def cloud_no_core(data, tetrahedron, parts):
    """parts: (index, m, y) each."""
    return Proof(data, 3, varint(tetrahedron) + bytes([len(parts)]) + b"".join(index(g) + bytes([m]) + rational(y) for g, m, y in parts))


def cloud_inside(data, f, sums, tetrahedron, weights):
    return Proof(data, 4, face(*f) + bytes(sums) + varint(tetrahedron) + rationals(weights))


def negative_jacobian(data, u, planes=None):
    return Proof(data, 5, rationals(u), planes)


def leaf(tetrahedron, points, planes):
    return varint(tetrahedron) + rationals(itertools.chain(*points)) + planes_of(planes)


def zero_jacobian(data, tetrahedron, points, of_leaf=(), planes=None):
    return Proof(data, 6, leaf(tetrahedron, points, of_leaf), planes)


def edge_overused(data, a, b):
    return Proof(data, 7, varint(a) + varint(b))


def several_fans(data, v):
    return Proof(data, 8, varint(v))


def faces_meet(data, f, g, w, x):
    return Proof(data, 9, face(*f) + face(*g) + rationals(w) + rationals(x))


def tetrahedra_meet(data, i, j, u):
    return Proof(data, 10, varint(i) + varint(j) + rationals(u))


def images_meet(data, u, v, planes=None):
    return Proof(data, 11, rationals(u) + rationals(v), planes)


def images_cross(data, pieces, rectangles, rows, planes=None):
    """pieces: (face, three points, planes) each; rectangles: two intervals (k, a, b) for each piece; rows: Y."""
    out = b"".join(face(*f) + rationals(itertools.chain(*points)) + planes_of(those) for f, points, those in pieces)
    out += b"".join(varint(number) for rectangle in rectangles for interval in rectangle for number in interval)
    return Proof(data, 12, out + b"".join(zigzag(y) for row in rows for y in row), planes)


def point_covered(data, tetrahedron, points, u, of_leaf=(), planes=None):
    return Proof(data, 13, leaf(tetrahedron, points, of_leaf) + rationals(u), planes)


def enclosed(sheets, at, fixed, width, places=20):
    """(rectangles, rows) for a crossing. sheets: two functions of (s, t), floats in and out; at: parameters near the crossing, two
    for each; fixed: the number, 0 to 3, of the one that does not change; width: half of the others' intervals; ends are multiples of
    2^-places. Newton's method finds the crossing; what it finds is not checked."""
    at, free = list(at), [i for i in range(4) if i != fixed]
    at[fixed] = round(at[fixed] * (1 << places)) / (1 << places)

    def difference(p):
        return [x - y for x, y in zip(sheets[0](*p[:2]), sheets[1](*p[2:]))]

    def columns(p):
        step = 1e-6
        return [[(x - y) / step for x, y in zip(difference([q + step * (i == j) for j, q in enumerate(p)]), difference(p))] for i in free]

    for _ in range(30):
        f, c = difference(at), columns(at)
        whole = determinant(*c)
        for k, i in enumerate(free):
            at[i] -= determinant(*(f if j == k else c[j] for j in range(3))) / whole
    (a, b, c) = columns(at)
    cross = lambda u, v: [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]       # noqa: E731
    sign = 1 if determinant(a, b, c) > 0 else -1
    rows = [cross(b, c), cross(c, a), cross(a, b)]
    rows = [[round(sign * y * 1e6 / max(map(abs, row))) for y in row] for row in rows]
    ends = [(places, round((x - (i != fixed) * width) * (1 << places)), round((x + (i != fixed) * width) * (1 << places)))
            for i, x in enumerate(at)]
    return (ends[:2], ends[2:]), rows
