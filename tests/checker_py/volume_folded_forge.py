# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Writes bodies and certificates of volume-folded-1, whatever they say, and models of volumes that fold: tests only. determinant() is
the tests' own way to the sign: the map of a box of pieces by its values at inner points."""
import hashlib
import itertools
import json
from fractions import Fraction as Q

import model_texts as texts
import star_box_forge as forge

BEGIN, MIDDLE, END = (0, 0), (0, Q(1, 2)), (0, 1)         # of the first piece
FIRST, LAST = (BEGIN,) * 3, (END,) * 3                    # corners of a volume of one piece


class Fold:
    """Everything that a certificate says. maps: texts.Map; a, b: three (piece, number), a number a rational or (n, d)."""
    claim, magic, tail = "volume-folded-1", b"VTVF", b""

    def __init__(self, maps, a=FIRST, b=LAST, entity=0, subject_format="vjson"):
        self.maps, self.a, self.b, self.entity, self.subject_format = maps, a, b, entity, subject_format
        self.count, self.values, self.text = len(maps), {}, None

    def body(self):
        out = [self.magic, forge.u32(self.count), forge.varint(self.entity)]
        for piece, t in (*self.a, *self.b):
            n, d = t if isinstance(t, tuple) else (Q(t).numerator, Q(t).denominator)
            out += map(forge.varint, (piece, n, d))
        return b"".join(out) + self.tail

    def model(self):
        if self.text is None:
            rational = self.subject_format == "mfem"
            maps = [made_rational(m) for m in self.maps] if rational else self.maps
            self.text = texts.WRITERS[self.subject_format](maps)
        return self.text

    def certificate(self, model=None):
        model, body = self.model() if model is None else model, self.body()
        statement = {"certificate": "veritope-certificate-1", "tool": "volume_folded_forge", "claim": self.claim,
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": self.subject_format,
                     "body_sha256": hashlib.sha256(body).hexdigest(), "volumes": len(self.maps), "entity": self.entity}
        statement.update(self.values)
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


# ---------------------------------------------------------------- volumes

def made_rational(m):
    return m if m.rational else texts.Map(m.degrees, m.knots, [(*p, 1) for p in m.points], True)


def bezier(degrees, point, rational=False):
    """point(u, v, w) with u = i / degree."""
    return texts.bezier(degrees, point, rational)


def cube(shape=lambda p: p):
    """The unit cube, its corners moved."""
    return bezier((1, 1, 1), lambda *p: shape(p))


def folded_cube():
    """The example of the page."""
    return cube(lambda p: (0, 0, 0) if p == (1, 1, 1) else p)


def folded_inside(mirrored=False):
    """x runs forward, back and forward again: right at both ends, wrong in the middle."""
    x = (0, 4, -3, 1)
    return bezier((3, 1, 1), lambda u, v, w: ((-1 if mirrored else 1) * x[int(3 * u)], v, w))


def with_knots(degree, inner):
    """Clamped knots with these inner ones."""
    return [Q(0)] * (degree + 1) + [Q(t) for t in inner] + [Q(inner[-1] + 1 if inner else 1)] * (degree + 1)


def graph(knots, height):
    """x = height(u's Greville abscissa) over a grid, y = v, z = w: folds where x runs backward along u."""
    p = len([t for t in knots if t == knots[0]]) - 1
    n = len(knots) - p - 1
    xs = [Q(round(64 * height(sum(knots[i + 1:i + p + 1]) / p)), 64) for i in range(n)]
    return texts.Map((p, 1, 1), [knots, texts.bezier_knots(1), texts.bezier_knots(1)], [(x, y, z) for z in (0, 1) for y in (0, 1) for x in xs])


# ---------------------------------------------------------------- the determinant, in another way

def splines(knots, degree, t, span):
    """All B-splines of the degree at t, continued from the span."""
    row = [Q(i == span) for i in range(len(knots) - 1)]
    for p in range(1, degree + 1):
        left = [(t - knots[i]) / (knots[i + p] - knots[i]) if knots[i + p] != knots[i] else 0 for i in range(len(knots) - p)]
        row = [left[i] * row[i] + (1 - left[i + 1] if knots[i + p + 1] != knots[i + 1] else 0) * row[i + 1] for i in range(len(knots) - p - 1)]
    return row


def slopes(knots, degree, t, span):
    """Their derivatives: polynomials of the degree, by their values at degree + 1 points (Newton's divided differences)."""
    nodes = [t + k for k in range(degree + 1)]
    rows = [splines(knots, degree, x, span) for x in nodes]
    out = []
    for values in zip(*rows):
        difference, total, product = list(values), Q(0), Q(1)
        for k in range(1, degree + 1):                      # (x - t)(x - t - 1)...(x - t - k + 1) has this slope at t
            difference = [(b - a) / k for a, b in zip(difference, difference[1:])]
            total += difference[0] * product
            product *= -k
        out.append(total)
    return out


def place(m, point):
    """[(parameter, span)] of a point."""
    out = []
    for (piece, t), knots in zip(point, m.knots):
        ends = sorted(set(knots))
        t = Q(*t) if isinstance(t, tuple) else Q(t)
        span = max(i for i, x in enumerate(knots) if x == ends[piece])
        out.append((ends[piece] + (ends[piece + 1] - ends[piece]) * t, span))
    return out


def determinant(m, point):
    """The Jacobian determinant, exactly, by the quotient rule."""
    factors = []
    for p, knots, (t, span) in zip(m.degrees, m.knots, place(m, point)):
        factors.append([f(knots, p, t, span) for f in (splines, slopes)])
    sums = []
    for by in (None, 0, 1, 2):
        total = [Q(0)] * 4
        for index, p in m.all().items():
            f = Q(1)
            for axis, i in enumerate(index):
                f *= factors[axis][axis == by][i]
            total = [a + f * c for a, c in zip(total, p)]
        sums.append(total)
    (*x, w), rows = sums[0], []
    for *dx, dw in sums[1:]:
        rows.append([(a * w - b * dw) / (w * w) for a, b in zip(dx, x)])
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def sign(m, point):
    d = determinant(m, point)
    return (d > 0) - (d < 0)


def points_of(m, along=(0, Q(1, 2), 1)):
    """All points of these numbers in all pieces."""
    axes = [[(k, t) for k in range(len(set(knots)) - 1) for t in along] for knots in m.knots]
    return list(itertools.product(*axes))


# ---------------------------------------------------------------- true folds

def honest():
    """(name, Fold)"""
    yield "the page's example", Fold([folded_cube()])
    yield "inside", Fold([folded_inside()], FIRST, (MIDDLE,) * 3)
    yield "mirrored, inside", Fold([folded_inside(True)], (MIDDLE,) * 3, FIRST)
    yield "second of three", Fold([cube(), folded_cube(), cube()], entity=1)
    heavy = made_rational(folded_cube())
    heavy = texts.Map(heavy.degrees, heavy.knots, [tuple(c * (k % 3 + 1) for c in p) for k, p in enumerate(heavy.points)], True)
    yield "rational", Fold([heavy])
    # |u - 1|-like: runs forward to the knot 1, and back; at the knot itself each side has its sign.
    ridge = graph(with_knots(1, [1]), lambda t: t if t <= 1 else 2 - t)
    at = ((0, Q(1, 3)), (0, Q(1, 5)))
    yield "a ridge at a knot, from both sides", Fold([ridge], ((0, 1), *at), ((1, 0), *at))
    yield "a ridge, at its ends", Fold([ridge], FIRST, ((1, 1), *at))
    wave = graph(with_knots(3, [1, 2, Q(5, 2), Q(5, 2), 4]), lambda t: t * (t - 2) * (t - 5))
    found = {sign(wave, p): p for p in points_of(wave)}
    yield "a wave with uneven knots", Fold([wave], found[1], found[-1])
