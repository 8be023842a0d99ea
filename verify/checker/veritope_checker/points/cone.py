# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The directions near a point at which flat walls meet: docs/certificates/points.md, section 7."""
from functools import cmp_to_key
from math import gcd

from ..common.vectors import cross, dot

NOT_CLOSED = "the walls of a solid are not closed"

class Fault(Exception):
    """The walls are not those of solids."""

class Wedge:
    """The directions s a + t b with s, t >= 0.  n = a x b points out of the solid."""

    def __init__(self, a, b):
        self.a, self.b, self.n = primitive(a), primitive(b), primitive(cross(a, b))

    def depth(self, d):
        """Positive if the direction, in the plane, is inside, 0 on a rim, negative outside."""
        return min(dot(self.n, cross(self.a, d)), dot(self.n, cross(d, self.b)))

def primitive(a):
    common = gcd(*a)
    return tuple(x // common for x in a)

def plus(a, b, s=1, t=1):
    return tuple(s * x + t * y for x, y in zip(a, b))

def wedges_of(corners):
    """The wedges of a convex polygon that holds the origin."""
    return [Wedge(a, b) for a, b in zip(corners, corners[1:] + corners[:1]) if any(cross(a, b))]

def values_nearby(cones, f):
    """The values of f, a function of a list of bits, in the directions off all cones."""
    found = set()
    for own, cone in enumerate(cones):
        for wedge in cone:
            for d in between(wedge, stops_in(wedge, [t for j, c in enumerate(cones) if j != own for t in c])):
                front, back = [], []
                for j, other in enumerate(cones):
                    along = wedge if j == own else wedge_along(other, wedge, d)
                    bit = dot(along.n, wedge.n) < 0 if along else is_inside(other, d)
                    front.append(bit)
                    back.append(bit != (along is not None))
                found |= {bool(f(front)), bool(f(back))}
                if len(found) == 2:
                    return found
    if not found:
        raise Fault("no solid has walls there")
    return found

def stops_in(wedge, others):
    """The directions inside of the wedge at which another one begins, ends or crosses it."""
    stops = []
    for t in others:
        line = cross(wedge.n, t.n)
        if any(line):
            line = primitive(line)
            stops += [d for d in (line, tuple(-x for x in line)) if wedge.depth(d) > 0 and t.depth(d) >= 0]
        else:
            stops += [d for d in (t.a, t.b) if wedge.depth(d) > 0]
    order = cmp_to_key(lambda c, d: -dot(wedge.n, cross(c, d)))
    return [wedge.a, *sorted(set(stops), key=order), wedge.b]

def between(wedge, stops):
    return [plus(c, d) for c, d in zip(stops, stops[1:])]

def wedge_along(cone, wedge, d):
    for t in cone:
        if dot(t.n, d) == 0 and t.depth(d) > 0 and not any(cross(t.n, wedge.n)):
            return t

def is_inside(cone, d):
    """Whether the solid has d, which is off its cone: by segments to d from directions beside the first wedge whose
    plane does not hold d."""
    first = next((w for w in cone if dot(w.n, d)), None)
    if first is None:
        raise Fault(NOT_CLOSED)
    for k in range(1, 3 * len(cone) + 2):
        r = plus(first.a, first.b, 1, k)
        passages = [passage(w, r, d) for w in cone if w is not first]
        if None not in passages:
            total = (dot(first.n, d) < 0) + sum(passages)
            if total not in (0, 1):
                raise Fault(NOT_CLOSED)
            return total == 1
    raise Fault(NOT_CLOSED)

def passage(wedge, r, d):
    """1 if the segment from r to d passes the wedge from front to back, -1 from back to front, else 0; None if it
    meets a rim, or lies in the plane."""
    start, end = dot(wedge.n, r), dot(wedge.n, d)
    if start == end == 0:
        return None
    if start * end >= 0:
        return 0
    depth = wedge.depth(plus(r, d, abs(end), abs(start)))
    return None if depth == 0 else 0 if depth < 0 else 1 if start > 0 else -1
