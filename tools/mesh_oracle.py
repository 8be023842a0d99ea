# SPDX-License-Identifier: LGPL-3.0-or-later
"""A second opinion on meshes for tools/make_models.py: fractions, all pairs, no filters."""
import collections
from fractions import Fraction


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def clip(polygon, normal, origin):
    """The part of a convex polygon (a list of its corners, perhaps one or two) with normal.(x - origin) >= 0."""
    height = [dot(normal, sub(p, origin)) for p in polygon]
    kept = []
    for i, p in enumerate(polygon):
        q, hp, hq = polygon[i - 1], height[i], height[i - 1]
        if hp * hq < 0:
            t = hq / (hq - hp)
            kept.append(tuple(b + t * (a - b) for a, b in zip(p, q)))
        if hp >= 0:
            kept.append(p)
    return kept


def common_points(t, u):
    """Corners of the intersection of two triangles."""
    normal = cross(sub(u[1], u[0]), sub(u[2], u[0]))
    polygon = clip(clip(list(t), normal, u[0]), tuple(-c for c in normal), u[0])
    for i in range(3):
        if polygon:
            polygon = clip(polygon, cross(normal, sub(u[(i + 1) % 3], u[i])), u[i])
    return polygon


def in_simplex(p, corners):
    """Whether p lies on the point or segment with these corners."""
    if len(corners) < 2:
        return p in corners
    a, b = corners
    return cross(sub(p, a), sub(b, a)) == (0, 0, 0) and 0 <= dot(sub(p, a), sub(b, a)) <= dot(sub(b, a), sub(b, a))


class Oracle:
    """Rule counts and quantities of a triangle mesh, by definition and slowly."""

    def __init__(self, vertices, faces):
        self.points = [tuple(Fraction(c) for c in v) for v in vertices]
        self.faces = faces
        self.solid = [f for f in faces if len(set(f)) == 3]  # faces with a repeated id take part in nothing else
        self.proper = [i for i, f in enumerate(faces) if len(set(f)) == 3 and self.normal(f) != (0, 0, 0)]
        self.directed = collections.Counter((f[k], f[(k + 1) % 3]) for f in self.solid for k in range(3))
        self.edges = {frozenset(e) for e in self.directed}
        self.rules = {f"M{i}": 0 for i in range(1, 10)}
        self.rules["M1"] = len(faces) - len(self.proper)
        self.rules["M2"] = len(self.solid) - len({frozenset(f) for f in self.solid})
        self.count_edges()
        self.rules["M6"] = sum(self.fans(v) > 1 for v in {v for f in self.solid for v in f})
        self.rules["M7"] = sum(self.improper(f, g) for k, f in enumerate(self.proper) for g in self.proper[:k])
        self.shells = self.find_shells()
        is_cycle = all(self.directed[a, b] == self.directed[b, a] for a, b in self.directed)
        self.volumes = [sum(self.det(f) for f in shell) / 6 for shell in self.shells] if is_cycle else None
        self.bodies = self.genus = None
        if all(self.rules[f"M{i}"] == 0 for i in range(1, 7)):
            self.genus = sum((2 - self.euler(shell)) // 2 for shell in self.shells)
            if self.rules["M7"] == 0:
                self.nest()
        if self.bodies is None:
            self.rules["M8"] = self.rules["M9"] = None

    def corners(self, face):
        return [self.points[v] for v in face]

    def normal(self, face):
        a, b, c = self.corners(face)
        return cross(sub(b, a), sub(c, a))

    def det(self, face):
        a, b, c = self.corners(face)
        return dot(a, cross(b, c))

    def count_edges(self):
        for a, b in map(sorted, self.edges):
            there, back = self.directed[a, b], self.directed[b, a]
            self.rules["M3"] += there + back == 1
            self.rules["M4"] += there + back > 2
            self.rules["M5"] += (there, back) in ((2, 0), (0, 2))

    def classes(self, faces, is_link):
        """Classes of faces that are connected through edges for which is_link holds."""
        rest, found = list(faces), []
        while rest:
            group, todo = [], [rest.pop(0)]
            while todo:
                face = todo.pop()
                group.append(face)
                near = [g for g in rest if any(is_link(e) and e <= set(g) for e in self.edges_of(face))]
                rest = [g for g in rest if g not in near]
                todo += near
            found.append(group)
        return found

    @staticmethod
    def edges_of(face):
        return [frozenset((face[k], face[(k + 1) % 3])) for k in range(3)]

    def fans(self, vertex):
        return len(self.classes([f for f in self.solid if vertex in f], lambda edge: vertex in edge))

    def find_shells(self):
        return self.classes(self.solid, lambda edge: True)

    def euler(self, faces):
        return (len({v for f in faces for v in f}) - len({e for f in faces for e in self.edges_of(f)}) + len(faces))

    def improper(self, i, j):
        f, g = self.faces[i], self.faces[j]
        common = set(f) & set(g)
        if len(common) == 3:
            return True
        simplex = [self.points[v] for v in common]
        return any(not in_simplex(p, simplex) for p in common_points(self.corners(f), self.corners(g)))

    def nest(self):
        depths = [sum(self.is_inside(s[0], other) for other in self.shells if other is not s) for s in self.shells]
        self.bodies = sum(d % 2 == 0 for d in depths)
        for depth, volume in zip(depths, self.volumes):
            if (volume > 0) != (depth % 2 == 0):
                self.rules["M8" if depth == 0 else "M9"] += 1

    def is_inside(self, face, shell):
        """Parity of the crossings of a ray from a point of the face; start and direction such that it meets no edge."""
        for k in range(100):
            weights = Fraction(97, 145 + k), Fraction(31, 145 + k), Fraction(17 + k, 145 + k)
            p = tuple(dot(weights, coordinates) for coordinates in zip(*self.corners(face)))
            direction = (Fraction(1), Fraction(k * k + 3, 7919), Fraction(5 * k + 1, 104729))
            hits = [self.crosses(p, direction, self.corners(f)) for f in shell]
            if None not in hits:
                return sum(hits) % 2 == 1
        raise ValueError("no direction in general position")

    @staticmethod
    def crosses(p, direction, triangle):
        """Whether the ray goes through the inside of the triangle; None if it meets an edge or lies in the plane."""
        a, b, c = (sub(corner, p) for corner in triangle)
        signs = [dot(direction, cross(u, v)) for u, v in ((a, b), (b, c), (c, a))]
        total = sum(signs)
        if 0 in signs or total == 0:
            return None if min(signs) <= 0 <= max(signs) or total == 0 else False
        if min(signs) < 0 < max(signs):
            return False
        return dot(a, cross(b, c)) / total > 0

    def is_valid(self):
        return not any(self.rules.values()) and self.bodies is not None
