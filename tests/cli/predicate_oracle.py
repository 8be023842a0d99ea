# SPDX-License-Identifier: LGPL-3.0-or-later
"""The predicates of `veritope predicate` by their definitions, over Python's fractions: homogeneous determinants, expanded by minors."""
import math
import random
import struct
from fractions import Fraction

NUM_OPERANDS = {"orient2d": 6, "orient3d": 12, "in_circle": 8, "in_sphere": 15, "side_of_plane": 7, "compare_along": 9,
                "power_circle": 12, "power_sphere": 20, "power_edge2d": 9, "power_edge3d": 12, "compare_distance2d": 6, "compare_distance3d": 9,
                "side_of_bisector2d": 6, "side_of_bisector3d": 9, "compare_lengths2d": 8, "compare_lengths3d": 12,
                "order_along_line2d": 8, "order_along_line3d": 12, "order_on_circle": 8}

# Predicates on implicit points: the kinds of their points (docs/cli/predicate.md), e, s, t, l, p in space and E, S, X in the plane.
IMPLICIT = {"orient2d_ssi": "EEX", "orient2d_segment": "SSS", "in_circle_ssi": "EEEX", "in_circle_segment": "SSSS",
            "compare_lexicographic_ssi": "XX", "orient3d_lpi": "eeel", "orient3d_tpi": "eeep", "orient3d_lpi4": "llll",
            "orient3d_mixed": "stlp", "in_sphere_lpi": "eeeel", "in_sphere_mixed": "estls", "compare_lexicographic_lpi": "ll",
            "compare_lexicographic_tpi": "pp"}
KIND_OPERANDS = {"e": 3, "s": 8, "t": 12, "l": 15, "p": 27, "E": 2, "S": 6, "X": 8}
IMPLICIT_OPERANDS = {name: sum(KIND_OPERANDS[kind] for kind in kinds) for name, kinds in IMPLICIT.items()}


def sign_of(value):
    return (value > 0) - (value < 0)


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** i * row[0] * determinant([r[1:] for r in rows[:i] + rows[i + 1:]]) for i, row in enumerate(rows) if row[0])


WEIGHTED = ("power_circle", "power_sphere", "power_edge2d", "power_edge3d")
METRIC = ("compare_distance", "side_of_bisector", "compare_lengths", "order_along_line")


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def homogeneous(kind, v):
    """[w, w x, w y(, w z)] with w > 0 from integers; None if there is no such point. Not the formulas of the library: in
    space planes are rows (normal, offset), points are their generalised cross products; in the plane lines are."""
    dimension = 2 if kind in "ESX" else 3
    points = [v[i:i + dimension] for i in range(0, len(v), dimension)]

    def plane(a, b, c):
        normal = cross(minus(b, a), minus(c, a))
        return [-dot(normal, a), *normal]

    def meet(rows):
        columns = range(len(rows) + 1)
        return [(-1) ** j * determinant([[row[k] for k in columns if k != j] for row in rows]) for j in columns]

    if kind in "eE":
        point = [1, *v]
    elif kind in "sStT":
        count = {"s": 2, "S": 2, "t": 3}[kind]
        weights = v[count * dimension:]
        first = weights[-1] - sum(weights[:-1])
        point = [weights[-1], *(sum(w * p[i] for w, p in zip([first, *weights[:-1]], points)) for i in range(dimension))]
    elif kind == "X":
        point = meet([[p[0] * q[1] - p[1] * q[0], p[1] - q[1], q[0] - p[0]] for p, q in (points[:2], points[2:])])
    elif kind == "l":
        row, (a, b) = plane(*points[2:]), ([1, *p] for p in points[:2])
        at_a, at_b = dot(row, a), dot(row, b)
        point = [at_a * y - at_b * x for x, y in zip(a, b)]
    else:
        point = meet([plane(*points[i:i + 3]) for i in (0, 3, 6)])
    if point[0] == 0:
        return None
    return point if point[0] > 0 else [-x for x in point]


def implicit_sign(name, operands):
    """The sign; None if a point does not exist."""
    exponent = 1074  # coordinates in units of 2^-1074; weights, too: only their ratio matters
    v = [int(Fraction(x) * 2**exponent) for x in operands]
    common = math.gcd(*v) or 1
    v = [x // common for x in v]
    points, start = [], 0
    for kind in IMPLICIT[name]:
        points.append(homogeneous(kind, v[start:start + KIND_OPERANDS[kind]]))
        start += KIND_OPERANDS[kind]
    if None in points:
        return None
    if name.startswith("compare_lexicographic"):
        p, q = points
        return next((sign_of(d) for d in (x * q[0] - y * p[0] for x, y in zip(p[1:], q[1:])) if d), 0)
    if name.startswith("orient"):
        return sign_of(determinant(points))
    return -sign_of(determinant([[w * w, *(w * x for x in p), dot(p, p)] for w, *p in points]))
def weighted_sign(name, points):
    """By definition: lifted determinants; for an edge the centre and the power of the smallest orthogonal sphere."""
    if not name.startswith("power_edge"):
        return -sign_of(determinant([[1, *p, dot(p, p) - w] for p, w in points]))
    (a, wa), (b, wb), (d, wd) = points
    u = minus(b, a)
    if not any(u):
        return 0
    at = (1 + (wa - wb) / dot(u, u)) / 2
    centre = [x + at * y for x, y in zip(a, u)]
    squared_radius = dot(minus(a, centre), minus(a, centre)) - wa
    return -sign_of(dot(minus(d, centre), minus(d, centre)) - wd - squared_radius)


def metric_sign(name, points):
    def squared(i, j):
        difference = minus(points[i], points[j])
        return dot(difference, difference)

    if name == "compare_distance":
        return sign_of(squared(0, 1) - squared(0, 2))
    if name == "side_of_bisector":
        return sign_of(squared(1, 2) - squared(0, 2))
    if name == "compare_lengths":
        return sign_of(squared(0, 1) - squared(2, 3))
    if name == "order_along_line":
        return sign_of(dot(minus(points[1], points[0]), minus(points[2], points[3])))
    # On a circle: as complex numbers, q / p and r / p, sorted by the half that they lie in and by their slope.
    p, q, r = (minus(x, points[0]) for x in points[1:])
    if not (any(p) and any(q) and any(r)):
        return 0

    def turned(x):
        return p[0] * x[0] + p[1] * x[1], p[0] * x[1] - p[1] * x[0]

    def half(x):
        return 0 if x[1] > 0 or x[1] == 0 and x[0] > 0 else 1

    a, b = turned(q), turned(r)
    return sign_of(half(b) - half(a)) or sign_of(a[0] * b[1] - a[1] * b[0])


def sign(name, operands):
    """The exact sign for binary64 operands."""
    if name in IMPLICIT:
        return implicit_sign(name, operands)
    v = [Fraction(x) for x in operands]
    if name == "side_of_plane":
        return sign_of(sum(n * p for n, p in zip(v[:3], v[4:])) + v[3])
    if name == "compare_along":
        return sign_of(sum(d * (p - q) for d, p, q in zip(v[:3], v[3:6], v[6:])))
    dimension = 2 if name in ("orient2d", "in_circle", "power_circle", "order_on_circle") or name.endswith("2d") else 3
    if name in WEIGHTED:
        return weighted_sign(name, [(v[i:i + dimension], v[i + dimension]) for i in range(0, len(v), dimension + 1)])
    if name.rstrip("23d") in METRIC or name == "order_on_circle":
        return metric_sign(name.rstrip("23d"), [v[i:i + dimension] for i in range(0, len(v), dimension)])
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
