# SPDX-License-Identifier: LGPL-3.0-or-later
"""The predicates of `veritope predicate` by their definitions, over Python's fractions: homogeneous determinants, expanded by minors."""
import math
import random
import struct
from fractions import Fraction

NUM_OPERANDS = {"orient2d": 6, "orient3d": 12, "in_circle": 8, "in_sphere": 15, "side_of_plane": 7, "compare_along": 9}


def sign_of(value):
    return (value > 0) - (value < 0)


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** i * row[0] * determinant([r[1:] for r in rows[:i] + rows[i + 1:]]) for i, row in enumerate(rows) if row[0])


def sign(name, operands):
    """The exact sign for binary64 operands."""
    v = [Fraction(x) for x in operands]
    if name == "side_of_plane":
        return sign_of(sum(n * p for n, p in zip(v[:3], v[4:])) + v[3])
    if name == "compare_along":
        return sign_of(sum(d * (p - q) for d, p, q in zip(v[:3], v[3:6], v[6:])))
    dimension = 2 if name in ("orient2d", "in_circle") else 3
    points = [v[i:i + dimension] for i in range(0, len(v), dimension)]
    if name.startswith("orient"):
        return sign_of(determinant([[1, *p] for p in points]))
    return -sign_of(determinant([[1, *p, sum(x * x for x in p)] for p in points]))


def finite_bits(draw):
    while True:
        value = struct.unpack("<d", draw.randbytes(8))[0]
        if math.isfinite(value):
            return value


def hard_operands(draw, count):
    """Small integers (many ties), them nudged, all on few values (flat and round shapes), scaled by a power of two, any bits, or extreme."""
    kind = draw.randrange(6)
    if kind == 0:
        return [float(draw.randint(-3, 3)) for _ in range(count)]
    if kind == 1:
        return [math.nextafter(draw.randint(-3, 3) / 8, draw.choice((-9, 9))) for _ in range(count)]
    if kind == 2:
        values = [draw.random() for _ in range(2)]
        return [draw.choice(values) for _ in range(count)]
    if kind == 3:
        scale = draw.choice((-1074, -1000, -500, 500, 1000, 1021))
        return [math.ldexp(draw.randint(-3, 3), scale) for _ in range(count)]
    if kind == 4:
        return [finite_bits(draw) for _ in range(count)]
    extremes = (0.0, -0.0, 1.0, 3.0, 5e-324, 2.0**-1022, 2.0**511, 2.0**-537, 1.7976931348623157e308)
    return [draw.choice((-1, 1)) * draw.choice(extremes) for _ in range(count)]


def cases(name, seed, count):
    draw = random.Random(f"{name} {seed}")
    return [hard_operands(draw, NUM_OPERANDS[name]) for _ in range(count)]
