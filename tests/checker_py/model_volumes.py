# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Volumes for tests of docs/certificates/reading-rule-faces.md, and their faces by brute force: every pair of faces, every symmetry,
fractions."""
import itertools
from fractions import Fraction as Q
from math import comb

import model_texts as texts

PARAMETERS = {(0, 0): (2, 1), (0, 1): (1, 2), (1, 0): (0, 2), (1, 1): (2, 0), (2, 0): (1, 0), (2, 1): (0, 1)}


# ---------------------------------------------------------------- volumes

def block(lo=(0, 0, 0), hi=(1, 1, 1), degrees=(1, 1, 1), rational=False, shape=lambda p: p):
    def point(*t):
        p = shape(tuple(a + (b - a) * x for a, b, x in zip(map(Q, lo), map(Q, hi), t)))
        return (*p, 1) if rational else p
    return texts.bezier(degrees, point, rational)


def rearranged(volume, order, flips):
    """This volume with its axes in another order, some of them reversed: axis k of the result is axis order[k]."""
    at, sizes = dict(volume.all()), [volume.sizes[k] for k in order]
    points = []
    for index in itertools.product(*map(range, sizes[::-1])):
        old = [0] * 3
        for k, i, flip in zip(order, index[::-1], flips):
            old[k] = volume.sizes[k] - 1 - i if flip else i
        points.append(at[tuple(old)][:None if volume.rational else -1])
    knots = [[t[0] + t[-1] - x for x in t[::-1]] if flip else t for t, flip in ((volume.knots[k], flip) for k, flip in zip(order, flips))]
    return texts.Map([volume.degrees[k] for k in order], knots, points, volume.rational)


def mapped(volume, knots_by=(1, 0), factor=1):
    """This volume over other knots a t + b, its homogeneous points times a factor."""
    a, b = knots_by
    points = [tuple(factor * c for c in p) for p in volume.points] if volume.rational else volume.points
    return texts.Map(volume.degrees, [[a * t + b for t in axis] for axis in volume.knots], points, volume.rational)


def made_rational(volume):
    return volume if volume.rational else texts.Map(volume.degrees, volume.knots, [(*p, 1) for p in volume.points], True)


def with_points(volume, change):
    """change(index, homogeneous point)."""
    points = [change(index, p) for index, p in volume.all().items()]
    return texts.Map(volume.degrees, volume.knots, [p if volume.rational else p[:-1] for p in points], volume.rational)


# ---------------------------------------------------------------- the page by brute force

def hand(volume):
    """1 or -1; 0 if corners differ."""
    at, sizes = volume.all(), volume.sizes

    def det(p, others):
        a, b, c = [[x / q[3] - y / p[3] for x, y in zip(q[:3], p[:3])] for q in others]
        return sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))

    corners = set()
    for c in range(8):
        ends = [c >> k & 1 for k in range(3)]
        start = [e * (n - 1) for e, n in zip(ends, sizes)]
        found = det(at[tuple(start)], [at[tuple(s + (k == m) * (1 - 2 * e) for m, (s, e) in enumerate(zip(start, ends)))] for k in range(3)])
        if found:
            corners.add((1 if found > 0 else -1) * (-1) ** sum(ends))
    if corners:
        return sum(corners)
    count = 0
    for k, j, i in itertools.product(*[range(n - 1) for n in sizes[::-1]]):
        found = det(at[i, j, k], [at[i + 1, j, k], at[i, j + 1, k], at[i, j, k + 1]])
        if found:
            return 1 if found > 0 else -1
        count += 1
        if count == 1000:
            break
    return 1


def face(volume, a, e, turn):
    at, axes = volume.all(), PARAMETERS[a, e][::turn]
    points = []
    for j in range(volume.sizes[axes[1]]):
        for i in range(volume.sizes[axes[0]]):
            index = [0] * 3
            index[a], index[axes[0]], index[axes[1]] = e * (volume.sizes[a] - 1), i, j
            points.append(at[tuple(index)][:None if volume.rational else -1])
    return texts.Map([volume.degrees[k] for k in axes], [volume.knots[k] for k in axes], points, volume.rational)


def area(f):
    """Whether the face has one by section 4."""
    at = f.all()
    first = at[0, 0]

    def equal(a, factor, b, other):
        return all(x * factor == y * other for x, y in zip(a, b))
    return not (all(equal(p, first[3], first, p[3]) for p in at.values()) or
                all(equal(p, first[3], at[0, j], at[i, 0][3]) for (i, j), p in at.items()) or
                all(equal(p, first[3], at[i, 0], at[0, j][3]) for (i, j), p in at.items()))


def lowered(f):
    """(degrees, knots, control points) in the lowest degrees, by one degree of one parameter after the other."""
    at, degrees, knots = f.all(), list(f.degrees), list(f.knots)
    for axis in range(2):
        while degrees[axis] > 1 and len(knots[axis]) == 2 * degrees[axis] + 2:
            p, other, new = degrees[axis], max(index[1 - axis] for index in at) + 1, {}
            for j in range(other):
                line = [at[(i, j)[::1 - 2 * axis]] for i in range(p + 1)]
                if any(sum((-1) ** i * comb(p, i) * q[c] for i, q in enumerate(line)) for c in range(4)):
                    break
                r = None
                for i in range(p):
                    r = tuple((p * x - i * y) / Q(p - i) for x, y in zip(line[i], r or line[i]))
                    new[(i, j)[::1 - 2 * axis]] = r
            else:
                at, degrees[axis], knots[axis] = new, p - 1, [Q(0)] * p + [Q(1)] * p
                continue
            break
    return degrees, knots, at


def symmetric(face_in_lowest_degrees, exchange, first, second):
    degrees, knots, at = face_in_lowest_degrees
    m, n = [len(t) - p - 1 for p, t in zip(degrees, knots)]
    knots = [[(t - axis[0]) / (axis[-1] - axis[0]) for t in axis] for axis in knots]
    if exchange:
        at, (m, n), degrees, knots = {(j, i): p for (i, j), p in at.items()}, (n, m), degrees[::-1], knots[::-1]
    if first:
        at, knots = {(m - 1 - i, j): p for (i, j), p in at.items()}, [[1 - t for t in knots[0][::-1]], knots[1]]
    if second:
        at, knots = {(i, n - 1 - j): p for (i, j), p in at.items()}, [knots[0], [1 - t for t in knots[1][::-1]]]
    return degrees, knots, at


def parities(turned, plain):
    """The parities of the symmetries that make one face equal to another."""
    degrees, knots, at = plain
    for parity, other in turned:
        if list(other[0]) == list(degrees) and other[1] == knots and all(
                x * at[0, 0][3] == y * other[2][0, 0][3] for index, p in at.items() for x, y in zip(other[2][index], p)):
            yield parity


def faces(volumes):
    """The faces that are left, or None if the file is refused."""
    every = []
    if any(hand(v) == 0 for v in volumes):
        return None
    for v in volumes:
        every += [face(v, a, e, hand(v)) for a in range(3) for e in range(2)]
    lowest = [lowered(f) for f in every]
    plain = [symmetric(f, 0, 0, 0) for f in lowest]
    turned = [[(sum(way) % 2, symmetric(f, *way)) for way in itertools.product((0, 1), repeat=3)] for f in lowest]
    left = []
    for n, f in enumerate(every):
        equal = [set(parities(turned[n], g)) for m, g in enumerate(plain) if m != n]
        equal = [p for p in equal if p]
        if area(f) and not (len(equal) == 1 and 1 in equal[0]):
            left.append(f)
    return left or None
