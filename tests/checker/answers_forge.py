# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of points-1, written from docs/certificates/points.md, and the truth about points and meshes in Python's fractions: no line of
the C++ checker, and other methods than its own. A point is on a triangle if it is a convex combination of the corners; its winding number is
counted along a ray in general position, or, in a sum of tetrahedra, by the tetrahedra around the point."""
import hashlib
import struct
from fractions import Fraction

import judges                                             # noqa: F401  for the paths
import mesh_models                                        # noqa: F401  for the paths
import forge

DIRECTIONS = [(3, 5, 7), (101, -37, 11), (-13, 29, 1009), (-2, 313, -71), (17, -1, 9973)]


def value(word, decimals):
    """The rational number of a coordinate."""
    sign = -1 if word[0] == "-" else 1
    digits = word.lstrip("+-").lower()
    if digits.startswith("0x"):
        number, exponent = digits[2:].split("p")
        whole, _, part = number.partition(".")
        return sign * int(whole + part or "0", 16) * Fraction(2) ** (int(exponent) - 4 * len(part))
    if "/" in digits:
        n, d = digits.split("/")
        return Fraction(sign * int(n), int(d))
    return Fraction(float(word)) if decimals == "nearest" else Fraction(word)


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def det(a, b, c):
    return dot(a, cross(b, c))


def is_between(q, a, b):
    """Whether q is on the segment from a to b."""
    e, d = sub(b, a), sub(q, a)
    if dot(e, e) == 0:
        return list(q) == list(a)
    t = Fraction(dot(d, e), dot(e, e))
    return 0 <= t <= 1 and all(x == t * y for x, y in zip(d, e))


class Chain:
    """A model, and the triangles that the reading rule finds in it."""

    def __init__(self, model):
        self.model, self.bytes = model, model.encode()
        points, self.tris = model.reading()
        self.vertices = len(points)
        self.points = [[Fraction(x) for x in p] for p in points]

    def corners(self, f):
        return [self.points[v] for v in self.tris[f]]

    def contains(self, f, q):
        a, b, c = self.corners(f)
        e, g, d = sub(b, a), sub(c, a), sub(q, a)
        ee, eg, gg = dot(e, e), dot(e, g), dot(g, g)
        size = ee * gg - eg * eg
        if size == 0:
            return is_between(q, a, b) or is_between(q, b, c) or is_between(q, c, a)
        s, t = Fraction(dot(d, e) * gg - dot(d, g) * eg, size), Fraction(dot(d, g) * ee - dot(d, e) * eg, size)
        return s >= 0 and t >= 0 and s + t <= 1 and all(x == s * y + t * z for x, y, z in zip(d, e, g))

    def on(self, q):
        return [f for f in range(len(self.tris)) if self.contains(f, q)]

    def winding(self, q):
        """The winding number around a point off the triangles."""
        return next(w for w in (self._along(q, ray) for ray in DIRECTIONS) if w is not None)

    def _along(self, q, ray):
        total = 0
        for f in range(len(self.tris)):
            a, b, c = (sub(p, q) for p in self.corners(f))
            if not any(cross(a, b) + cross(b, c) + cross(c, a)) and any(cross(ray, a)):
                continue                                  # a degenerate triangle on a line through q that is not the ray's
            sides = [det(ray, x, y) for x, y in ((a, b), (b, c), (c, a))]
            if all(s > 0 for s in sides) or all(s < 0 for s in sides):
                ahead = det(a, b, c)                      # its sign is that of the normal's product with the ray, if the ray meets f
                total += (ahead > 0) - (ahead < 0) if (ahead > 0) == (sides[0] > 0) else 0
            elif min(sides) == 0 or max(sides) == 0:
                return None                               # the line of the ray may meet an edge
        return total

    def units(self, q, code):
        """The pairs of section 5 for a point off the triangles."""
        u, total = code // 2, 0
        p, s = (u + 1) % 3, (u + 2) % 3
        for f in range(len(self.tris)):
            low = [min(c) for c in zip(*self.corners(f))]
            high = [max(c) for c in zip(*self.corners(f))]
            near = all(low[k] <= q[k] <= high[k] for k in range(3))
            total += near or (all(low[k] <= q[k] < high[k] for k in (p, s)) and (high[u] >= q[u] if code % 2 == 0 else low[u] <= q[u]))
        return total


class Answers:
    """Lines and their codes. A line is (three words, word, f, shell, code); the code of an undecided point is None."""

    def __init__(self, chain, decimals="nearest", winding=False):
        self.chain, self.decimals, self.winding, self.lines = chain, decimals, winding, []

    def add(self, words, shell="-", direction=0):
        """What is true of the point; the word that was chosen."""
        q = [value(word, self.decimals) for word in words]
        on = self.chain.on(q)
        if on:
            return self.put(words, "on", "-", shell, on[direction % len(on)])
        w = self.chain.winding(q)
        if not self.winding:
            assert w in (0, 1), w
        word = "-" if self.winding else ("out", "in")[w]
        return self.put(words, word, str(w), shell, direction)

    def put(self, words, word, f, shell="-", code=None):
        self.lines.append((tuple(words), word, f, shell, code))
        return word

    def copy(self, lines=None):
        other = Answers(self.chain, self.decimals, self.winding)
        other.lines = list(self.lines if lines is None else lines)
        return other

    def changed(self, at, **changes):
        names = ("words", "word", "f", "shell", "code")
        row = dict(zip(names, self.lines[at]), **changes)
        return self.copy(self.lines[:at] + [tuple(row[name] for name in names)] + self.lines[at + 1:])

    def bytes(self):
        return "".join(" ".join((*words, word, f, shell)) + "\n" for words, word, f, shell, _ in self.lines).encode()

    def body(self):
        codes = (b"" if code is None else varint(code) if word == "on" else bytes([code]) for _, word, _, _, code in self.lines)
        return b"VTPT" + struct.pack("<IIQ", len(self.chain.tris), self.chain.vertices, len(self.lines)) + b"".join(codes)

    def files(self, text=None, body=None, **values):
        """(model, certificate, answers)."""
        text = self.bytes() if text is None else text
        words = [line[1] for line in self.lines]
        keys = {"answers_sha256": hashlib.sha256(text).hexdigest(), "answers_bytes": len(text), "decimals": self.decimals, "winding": self.winding,
                "points": len(words), "on": words.count("on"), "undecided": words.count("undecided")}
        body = self.body() if body is None else body
        return self.chain.bytes, forge.certificate(self.chain.bytes, self.chain.model, "points-1", body, {**keys, **values}), text


def varint(n):
    out = b""
    while n > 127:
        out, n = out + bytes([n & 127 | 128]), n >> 7
    return out + bytes([n])


# ---------------------------------------------------------------- sums of tetrahedra

FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))


def tetrahedra(rng, count, place):
    """(model, tetrahedra): the boundaries of random tetrahedra, some of them flat, over few vertices, and triangles with equal ids."""
    points = [tuple(place() for _ in range(3)) for _ in range(rng.randrange(5, 9))]
    chosen = [rng.sample(range(len(points)), 4) for _ in range(count)]
    tris = [tuple(t[i] for i in face) for t in chosen for face in FACES]
    for _ in range(rng.randrange(4)):
        a, b = rng.sample(range(len(points)), 2)
        tris.append(rng.choice([(a, a, b), (a, b, a), (b, b, b)]))
    rng.shuffle(tris)
    return forge.Model(points, tris, rng.choice(("off", "obj", "ply")), as_indexed=rng.random() < .5), [[points[v] for v in t] for t in chosen]


def winding_of_tetrahedra(solids, q):
    """REQUIRES that q is on no face."""
    total = 0
    for t in solids:
        p = [[Fraction(x) for x in v] for v in t]
        whole = det(*(sub(v, p[0]) for v in p[1:]))
        sides = [side(p, i, q) for i in range(4)]
        if whole != 0 and all(s * whole > 0 for s in sides):
            total += 1 if whole > 0 else -1
    return total


def side(p, i, q):
    """The determinant of the tetrahedron with q in the place of corner i."""
    r = [q if j == i else p[j] for j in range(4)]
    return det(*(sub(v, r[0]) for v in r[1:]))


# ---------------------------------------------------------------- spellings

def spellings(x):
    """Words for a binary64 number, which mean it whatever `decimals` says."""
    q = Fraction(x)
    yield float(x).hex()
    yield "%d/%d" % (3 * q.numerator, 3 * q.denominator)
    exact = exact_decimal(q)
    if len(exact) < 4096:
        yield exact


def exact_decimal(q):
    """REQUIRES a denominator that is a power of two."""
    places = q.denominator.bit_length() - 1
    return "%se%d" % (q.numerator * 5 ** places, -places)
