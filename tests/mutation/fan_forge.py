# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Flat faces of patches with a side that is collapsed to one point, the *pole*: its petals. Also faces with a petal that is not as
docs/certificates/points.md, section 7, has it.

Vectors are relative to the pole. Faces are squares or parallelograms with corners counterclockwise as seen from outside.
"""
from fractions import Fraction as Q

import forge
from patch_points_forge import patch_forge

WIDE = "half_turn", "more_than_a_half_turn"
FAULTS = ("order", "folds_back", "folds_on", "starts_straight", "ends_straight", "winds", *WIDE, "no_vector", "lifted", "lifted_beyond")


def plus(a, b, s=1, t=1):
    return tuple(s * x + t * y for x, y in zip(a, b))


def between(a, b, t):
    return plus(a, b, 1 - t, t)


class Petal:
    """A patch with its entity. solve(q): its parameters at a point of it, or None; at the pole random ones."""

    def __init__(self, entity, place_at_pole, solve=None):
        self.entity, self.place_at_pole, self.solve = entity, place_at_pole, solve or (lambda q, rng: None)


# ---------------------------------------------------------------- one patch

def with_pole_at(side, rows):
    """The rows of a patch with side 3 collapsed, turned so that it is this side."""
    p, m = len(rows) - 1, len(rows[0]) - 1
    if side == 3:
        return rows
    if side == 1:
        return [row[::-1] for row in rows[::-1]]
    turned = [[rows[j][m - i] for j in range(p + 1)] for i in range(m + 1)]
    return turned if side == 0 else [row[::-1] for row in turned[::-1]]


def turned_place(side, u, v):
    return {3: (u, v), 0: (1 - v, u), 1: (1 - u, 1 - v), 2: (v, 1 - u)}[side]


def random_part(rng):
    return rng.choice((Q(0), Q(1), Q(1, 2), Q(rng.randint(1, 96), 97)))


def petal(rows, rng, solve=None, weight=1):
    """rows[0]: the pole, over and over; the others in the direction in which the boundary turns around it. weight: of all rows but the first."""
    side = rng.randrange(4)
    if weight != 1:
        rows = [[(*(c * w for c in p), w) for p in row] for row, w in zip(rows, (1, *[weight] * len(rows)))]
    entity = patch_forge.surface(with_pole_at(side, rows), rational=weight != 1)
    solved = solve and (lambda q, rng: (lambda at: at and turned_place(side, *at))(solve(q, rng)))
    return Petal(entity, lambda rng: turned_place(side, Q(0), random_part(rng)), solved)


def leaf(pole, first, second, tip, rng):
    """A triangle of degree 2 between two curves from the pole to its tip."""
    e, points = rng.randrange(3), []
    at = {(2, 0, 0): tip, (1, 0, 1): first, (1, 1, 0): second}  # by the indices at corners e, e + 1, e + 2
    for j, k in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)):
        index = 2 - j - k, j, k
        points.append(at.get(tuple(index[(e + i) % 3] for i in range(3)), pole))

    def place(rng):
        t, weights = random_part(rng), {e: Q(0)}
        weights[(e + 1) % 3], weights[(e + 2) % 3] = 1 - t, t
        return weights[1], weights[2]
    return Petal(patch_forge.triangle(points, 2), place)


# ---------------------------------------------------------------- faces

def even_row(a, b, m):
    return [between(a, b, Q(j, m)) for j in range(m + 1)]


def plain(corners):
    a, b, c, d = corners
    return patch_forge.surface([[a, d], [b, c]])


def even_petal(pole, a, b, rng, weight):
    """All that is between the pole and an edge, with known parameters."""
    p, m = rng.choice((1, 1, 2)) if weight == 1 else 1, rng.randint(1, 3)
    rows = [[plus(pole, plus(e, pole, 1, -1), 1, Q(i, p)) for e in even_row(a, b, m)] for i in range(p + 1)]

    def solve(q, rng):
        r, x, y = (forge.sub(c, d) for c, d in ((q, pole), (a, pole), (b, a)))
        n = forge.cross(x, y)
        if forge.dot(n, r):
            return None
        size = Q(forge.dot(n, n))
        f, g = forge.dot(n, forge.cross(r, y)) / size, forge.dot(n, forge.cross(x, r)) / size
        if f == 0:
            return None if g else (Q(0), random_part(rng))
        return (f / (weight - f * weight + f), g / f) if 0 <= f <= 1 and 0 <= g <= f else None
    return petal(rows, rng, solve, weight)


def fan(corners, pole, rng):
    """The petals of a face around a point of it that is on none of its edges, or its first corner."""
    edges = [e for e in zip(corners, corners[1:] + corners[:1]) if pole not in e]
    weight = rng.choice((1, 1, Q(3), Q(1, 2))) if len(edges) == 4 else 1
    return [even_petal(pole, a, b, rng, weight) for a, b in edges]


def rose(corners, rng, fault=None):
    """(petals, pole) of a face around its middle. Other than in a fan some petals are curved, and some are triangles; with a fault, one of
    them is not as the page has it."""
    a, b, _, d = corners
    x, y = plus(b, a, Q(1, 2), Q(-1, 2)), plus(d, a, Q(1, 2), Q(-1, 2))
    pole, ends = plus(a, plus(x, y)), [plus(x, y, s, t) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    first = [plus(e, ends[(k + 1) % 4], rng.choice((Q(3, 8), Q(1, 2))), rng.choice((0, Q(1, 16)))) for k, e in enumerate(ends)]
    last = [plus(s, ends[k - 1], 1, rng.choice((0, 0, Q(1, 8)))) for k, s in enumerate(first)]
    if fault in WIDE:
        first = last = [x, plus(x, y, -1, 0 if fault == "half_turn" else Q(-1, 4)), plus(x, y, Q(-1, 3), -1), plus(x, y, Q(1, 2), -1)]
    if fault == "no_vector":
        first = last = [(0, 0, 0), y, plus(x, y, -1, -1), plus(x, y, 1, -1)]
    petals = []
    for k in range(4):
        is_bad = fault is not None and k == 0
        m = (4 if fault == "winds" else 3) if is_bad else rng.randint(1, 3)
        row, edge = even_row(first[k], last[(k + 1) % 4], m), even_row(ends[k], ends[(k + 1) % 4], m)
        if is_bad:
            spoil(row, fault, x, y)
        elif m > 1:
            row[1] = plus(row[1], row[0], rng.choice((1, Q(3, 4))), rng.choice((0, Q(1, 8))))
        rows = [[(0, 0, 0)] * (m + 1), row, edge]
        if fault == "lifted_beyond" and is_bad or rng.random() < .2:
            rows = elevated(rows)
        if fault == "lifted_beyond" and is_bad:
            rows[2][1] = plus(rows[2][1], forge.cross(x, y), 1, Q(1, 8))
        petals.append(petal([[plus(pole, p) for p in row] for row in rows], rng))
        if last[k] != first[k]:
            petals.append(leaf(pole, plus(pole, last[k]), plus(pole, first[k]), corners[k], rng))
    return petals, pole


def elevated(rows):
    """One degree more across the collapsed side, of degree 2."""
    return [rows[0], *([plus(p, q, Q(i, 3), 1 - Q(i, 3)) for p, q in zip(rows[i - 1], rows[i])] for i in (1, 2)), rows[2]]


def spoil(row, fault, x, y):
    """Changes the inner ones of the vectors that leave the pole."""
    begin, end = row[0], row[-1]
    if fault == "order":
        row[1], row[2] = row[2], row[1]
    elif fault == "folds_back":
        row[1] = plus(begin, end, 1, Q(-1, 2))
    elif fault == "folds_on":
        row[2] = plus(end, begin, 1, Q(-1, 2))
    elif fault == "starts_straight":
        row[1] = plus(begin, begin, 1, Q(1, 2))
    elif fault == "ends_straight":
        row[2] = plus(end, end, 1, Q(1, 2))
    elif fault == "winds":
        row[1:4] = plus(begin, end, Q(-1, 3), 1), plus(begin, end, -1, Q(-1, 3)), plus(begin, end, Q(1, 3), -1)
    elif fault in WIDE:
        row[1:3] = plus(x, y, Q(1, 2), 1), plus(x, y, Q(-1, 2), 1)
    elif fault == "lifted":
        row[1] = plus(row[1], forge.cross(x, y), 1, Q(1, 8))
