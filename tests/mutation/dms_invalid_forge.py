# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of the claim dms-invalid-1 as Python values, and models of which the truth is known: their maps are polynomials, whose
polar forms at the knots are the control points, so that s is the polynomial whatever the clouds are. Shares no code with the checkers."""
import copy
import hashlib
import itertools
import json
import math
import pathlib
import struct
import sys
from fractions import Fraction as Q

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / "support")]
import dms_files as files                                 # noqa: E402

NAMES = ("tet-reversed", "tet-face-overused", "cloud-degenerate", "cloud-no-core", "cloud-inside", "jacobian", "jacobian-zero", "M4", "M6", "M7",
         "M9", "meeting", "crossing", "covering")
OF_THE_MAP = (5, 6, 11, 12, 13)


# ---------------------------------------------------------------- vectors

def add(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def det3(rows):
    return dot(rows[0], cross(rows[1], rows[2]))


def volume(a, b, c, d):
    return det3((sub(b, a), sub(c, a), sub(d, a)))


def mix(shares, points):
    total = sum(shares)
    return [sum(Q(s) * p[i] for s, p in zip(shares, points)) / total for i in range(3)]


def is_inside(corners, p, closed=False):
    found = [volume(*[p if i == k else c for i, c in enumerate(corners)]) for k in range(4)]
    return min(found) > 0 or closed and min(found) == 0


def inverse(rows):
    d = det3(rows)
    columns = cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])
    return [[column[i] / d for column in columns] for i in range(3)]


# ---------------------------------------------------------------- polynomial maps

class Polynomial:
    """terms: {(a, b, c): coefficient} of x^a y^b z^c"""

    def __init__(self, terms):
        self.terms = {powers: Q(c) for powers, c in terms.items() if c}

    def __add__(self, other):
        return Polynomial({p: self.terms.get(p, 0) + other.terms.get(p, 0) for p in {*self.terms, *other.terms}})

    def __mul__(self, other):
        if not isinstance(other, Polynomial):
            return Polynomial({p: c * other for p, c in self.terms.items()})
        found = {}
        for (p, c), (q, d) in itertools.product(self.terms.items(), other.terms.items()):
            powers = tuple(i + j for i, j in zip(p, q))
            found[powers] = found.get(powers, 0) + c * d
        return Polynomial(found)

    def at(self, u):
        return sum((c * u[0] ** p[0] * u[1] ** p[1] * u[2] ** p[2] for p, c in self.terms.items()), Q(0))

    def slope(self, axis):
        return Polynomial({tuple(e - (i == axis) for i, e in enumerate(p)): c * p[axis] for p, c in self.terms.items() if p[axis]})

    def polar(self, points):
        """The polar form at as many points as the degree is."""
        total = Q(0)
        for powers, c in self.terms.items():
            axes = [axis for axis, e in enumerate(powers) for _ in range(e)]
            ways = list(itertools.permutations(points, len(axes)))
            total += c * sum(math.prod((p[a] for p, a in zip(way, axes)), start=Q(1)) for way in ways) / len(ways)
        return total


def affine(*numbers):
    """a + b x + c y + d z"""
    a, b, c, d = numbers
    return Polynomial({(0, 0, 0): a, (1, 0, 0): b, (0, 1, 0): c, (0, 0, 1): d})


X, Y, Z, ONE = affine(0, 1, 0, 0), affine(0, 0, 1, 0), affine(0, 0, 0, 1), affine(1, 0, 0, 0)


def after(matrix, shift, parts):
    """The affine map of these rows after a map."""
    return [sum((p * Q(c) for p, c in zip(parts, row)), ONE * Q(t)) for row, t in zip(matrix, shift)]


def value(parts, u):
    return [p.at(u) for p in parts]


def jacobian(parts, u):
    return [[p.slope(axis).at(u) for axis in range(3)] for p in parts]


# ---------------------------------------------------------------- models

class Model:
    """clouds; tetrahedra; maps: of each vertex a polynomial map, one for all vertices of a connected part; moved: {multiset: vector} added to
    control points; separate: each tetrahedron has its own control points; apart: {number of such a one: vector}."""

    def __init__(self, degree, points, tetrahedra, parts=(X, Y, Z)):
        self.degree, self.clouds, self.tetrahedra = degree, [[list(p)] for p in points], [list(t) for t in tetrahedra]
        self.maps, self.moved, self.separate, self.apart = [parts] * len(points), {}, False, {}

    @property
    def last(self):
        return self.degree - (not self.separate)

    def knot(self, v, i):
        return self.clouds[v][i if i < len(self.clouds[v]) else 0]

    def set_knot(self, v, i, knot):
        size = self.degree + self.separate
        if len(self.clouds[v]) < size:
            self.clouds[v] = [self.clouds[v][0]] * size
        self.clouds[v] = [*self.clouds[v][:i], list(knot), *self.clouds[v][i + 1:]]

    def point(self, v):
        return self.clouds[v][0]

    def corners(self, t):
        return [self.clouds[v][0] for v in self.tetrahedra[t]]

    def faces(self, t):
        p, q, r, s = self.tetrahedra[t]
        return (q, r, s), (p, s, r), (p, q, s), (p, r, q)

    def face(self, number):
        return self.faces(number[0])[number[1]]

    def boundary(self):
        """The numbers of its faces."""
        known = {turned(f) for t in range(len(self.tetrahedra)) for f in self.faces(t)}
        return [(t, k) for t in range(len(self.tetrahedra)) for k, f in enumerate(self.faces(t)) if turned(f[::-1]) not in known]

    def gammas(self, total):
        return [g for g in itertools.product(range(total + 1), repeat=4) if sum(g) == total]

    def indices(self):
        """All gammas that condition (a) is about, and 0."""
        return [g for total in range(self.last + 1) for g in self.gammas(total)]

    def w(self, t, gamma):
        return [self.knot(v, i) for v, i in zip(self.tetrahedra[t], gamma)]

    def v(self, t, gamma):
        return [self.knot(v, k) for v, i in zip(self.tetrahedra[t], gamma) for k in range(i + 1)]

    def triangles(self):
        """Triangles of knots, not on one line."""
        found = set()
        for t in range(len(self.tetrahedra)):
            for gamma in self.gammas(self.degree - 1):
                names = sorted({tuple(k) for k in self.v(t, gamma)})
                found.update(three for three in itertools.combinations(names, 3) if any(cross(sub(three[1], three[0]), sub(three[2], three[0]))))
        return found

    def has_good_clouds(self):
        """(a)"""
        return all(volume(*self.w(t, gamma)) > 0 for t in range(len(self.tetrahedra)) for gamma in self.indices())

    def control(self):
        found = {}
        for t in self.tetrahedra:
            for at in itertools.combinations_with_replacement(sorted(t), self.degree):
                if at not in found:
                    knots = [self.knot(v, k) for v in sorted(set(at)) for k in range(at.count(v))]
                    found[at] = add([p.polar(knots) for p in self.maps[at[0]]], self.moved.get(at, (0, 0, 0)))
        return found

    def data(self):
        data = files.text(self.degree, self.clouds, self.tetrahedra, self.control())
        if not self.separate:
            return data
        file = json.loads(files.separate(data))
        file["vertices"] = [[[str(c) for c in knot] for knot in cloud] for cloud in self.clouds]
        for entry, step in self.apart.items():
            entry = file["control"][entry % len(file["control"])]
            entry["value"] = [str(c) for c in add([Q(c) for c in entry["value"]], step)]
        return json.dumps(file).encode()


def turned(face):
    i = face.index(min(face))
    return (*face[i:], *face[:i])


# ---------------------------------------------------------------- certificates

def varints(numbers):
    return b"".join(map(files.varint, numbers))


def u8s(numbers):
    return bytes(numbers)


def rationals(numbers):
    return b"".join(map(files.rational, numbers))


def face_code(face):
    return files.varint(face[0]) + bytes([face[1]])


def planes_code(planes):
    return files.varint(len(planes)) + b"".join(map(rationals, planes))


def intervals_code(pair):
    return b"".join(map(varints, pair))


def terms_code(terms):
    return bytes([len(terms) & 255]) + b"".join(u8s((*gamma, m)) + files.rational(y) for gamma, m, y in terms)


def points_code(points):
    return b"".join(map(rationals, points))


# The fields of the witness of each kind, in order, each with its code.
FIELDS = (
    {"tet": files.varint},
    {"f": face_code, "g": face_code},
    {"tet": files.varint, "gamma": u8s},
    {"tet": files.varint, "terms": terms_code},
    {"f": face_code, "index": u8s, "tet": files.varint, "weights": rationals},
    {"u": rationals},
    {"tet": files.varint, "corners": points_code, "planes": planes_code},
    {"a": files.varint, "b": files.varint},
    {"v": files.varint},
    {"f": face_code, "g": face_code, "w": rationals, "x": rationals},
    {"tet": files.varint, "other": files.varint, "u": rationals},
    {"u": rationals, "v": rationals},
    {"f": face_code, "sigma": points_code, "planes_f": planes_code, "g": face_code, "rho": points_code, "planes_g": planes_code,
     "A": intervals_code, "B": intervals_code, "Y": lambda rows: b"".join(files.zigzag(c) for row in rows for c in row)},
    {"tet": files.varint, "corners": points_code, "planes": planes_code, "u": rationals},
)


class Invalid:
    """model; kind; witness: {field: value}; lists: the planes of each face of the boundary; values: of the statement, that are not as they are."""

    def __init__(self, model, kind, lists=None, **witness):
        self.model, self.kind, self.witness = model, kind, witness
        self.lists = lists or [[] for _ in model.boundary()]
        self.values, self.magic, self.tail, self.count, self.kind_byte = {}, b"VTDI", b"", None, None

    def changed(self, **witness):
        new = copy.deepcopy(self)
        new.witness.update(witness)
        return new

    def told(self, **values):
        new = copy.deepcopy(self)
        new.__dict__.update(values)
        return new

    def body(self):
        out = self.magic + struct.pack("<I", len(self.model.tetrahedra) if self.count is None else self.count)
        out += bytes([self.kind if self.kind_byte is None else self.kind_byte])
        out += b"".join(code(self.witness[field]) for field, code in FIELDS[self.kind].items())
        if self.kind in OF_THE_MAP:
            out += struct.pack("<I", len(self.lists)) + b"".join(map(planes_code, self.lists))
        return out + self.tail

    def certificate(self, data, body=None):
        body = self.body() if body is None else body
        statement = {"certificate": "veritope-certificate-1", "tool": "dms_invalid_forge", "claim": "dms-invalid-1",
                     "subject_sha256": hashlib.sha256(data).hexdigest(), "subject_bytes": len(data), "subject_format": "vdms",
                     "body_sha256": hashlib.sha256(body).hexdigest(), "finding": NAMES[self.kind], "tetrahedra": len(self.model.tetrahedra)}
        return json.dumps({**statement, **self.values}, separators=(",", ":")).encode() + b"\n" + body
