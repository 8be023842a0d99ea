#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""make_solids.py FOLDER: writes the meshes under the free-form solids of the figures: stomach.obj, ring.off, jack.obj.

`veritope convert --pn` makes smooth solids of them. Coordinates are rounded to three decimals, so that the files do not
depend on the mathematical library. The stomach and the jack have normals, the ring has none: its patches take sums over
triangles.
"""
import math
import pathlib
import sys


def rounded(p):
    return tuple(round(x, 3) + 0.0 for x in p)


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def normals(points, faces):
    """Unit sums of the triangles' normals, weighted by the angles at the vertex."""
    sums = [(0.0, 0.0, 0.0)] * len(points)
    for face in faces:
        for k in range(3):
            v, a, b = (face[(k + i) % 3] for i in range(3))
            u, w = unit(minus(points[a], points[v])), unit(minus(points[b], points[v]))
            angle = math.acos(max(-1.0, min(1.0, sum(x * y for x, y in zip(u, w)))))
            n = unit(cross(u, w))
            sums[v] = tuple(s + angle * x for s, x in zip(sums[v], n))
    return [rounded(unit(s)) for s in sums]


def tube(centres, radii, around):
    """A closed tube through circles around the centres, in planes across the curve; its ends are points."""
    points, faces = [rounded(centres[0])], []
    for i in range(1, len(centres) - 1):
        along = unit(minus(centres[i + 1], centres[i - 1]))
        side = unit(cross(along, (0, 1, 0)))
        up = cross(side, along)
        for k in range(around):
            angle = 2 * math.pi * (k - (around - 2) / 4) / around  # half of them on each side
            c, s = math.cos(angle), math.sin(angle)
            points.append(rounded(tuple(centres[i][j] + radii[i] * (c * side[j] + s * up[j]) for j in range(3))))
    points.append(rounded(centres[-1]))
    rings = len(centres) - 2
    for k in range(around):
        n = (k + 1) % around
        faces.append((0, 1 + k, 1 + n))
        for r in range(rings - 1):
            a, b = 1 + r * around + k, 1 + r * around + n
            faces += [(a, a + around, b + around), (a, b + around, b)]
        last = 1 + (rings - 1) * around
        faces.append((len(points) - 1, last + n, last + k))
    return points, faces


def stomach():
    centres = [(-1.05, 0, 1.3), (-0.95, 0, 1.15), (-0.75, 0, 0.75), (-0.6, 0, 0.25), (-0.35, 0, -0.3), (0.15, 0, -0.65),
               (0.75, 0, -0.55), (1.2, 0, -0.2), (1.45, 0, 0.15), (1.52, 0, 0.25)]
    radii = [0, 0.2, 0.42, 0.58, 0.66, 0.6, 0.42, 0.27, 0.14, 0]
    return tube(centres, radii, 8)


def ring():
    """A torus with three swellings."""
    points, faces, around, across = [], [], 12, 6
    for i in range(around):
        a = 2 * math.pi * i / around
        radius = 0.34 + 0.12 * math.cos(3 * a)
        for j in range(across):
            b = 2 * math.pi * (j + 0.5 * (i % 2)) / across
            far = 0.95 + radius * math.cos(b)
            points.append(rounded((far * math.cos(a), far * math.sin(a), radius * math.sin(b))))
    for i in range(around):
        for j in range(across):
            shift = i % 2
            a, b = i * across + j, i * across + (j + 1) % across
            c, d = ((i + 1) % around * across + (j + k) % across for k in (0, 1))
            # Rows are shifted by half a step against each other.
            faces += [(a, c, b), (b, c, d)] if shift == 0 else [(a, c, d), (a, d, b)]
    tilt = 0.6
    c, s = math.cos(tilt), math.sin(tilt)
    turned = [rounded((x * c + z * s + 0.35, y, z * c - x * s)) for x, y, z in points]
    return turned, faces


def jack():
    """A ball with six arms: an octahedron, cut twice, with bumps toward its corners."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(2):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(tuple(x + y for x, y in zip(points[a], points[b]))))
            return middles[key]

        for a, b, c in faces:
            d, e, f = middle(b, c), middle(c, a), middle(a, b)
            finer += [(a, f, e), (f, b, d), (e, d, c), (d, e, f)]
        faces = finer
    bumped = []
    for p in points:
        share = sum(x ** 4 for x in p)  # 1 at the corners of the octahedron, 1/3 between them
        far = 0.45 + 0.95 * max(0.0, (share - 1 / 3) * 1.5) ** 1.5
        bumped.append(rounded(tuple(far * x for x in p)))
    return bumped, faces


def obj(points, faces, with_normals):
    text = "# made by make_solids.py\n" + "".join("v %g %g %g\n" % p for p in points)
    if with_normals:
        text += "".join("vn %g %g %g\n" % n for n in normals(points, faces))
    corner = "%d//%d" if with_normals else "%d"
    for face in faces:
        text += "f " + " ".join(corner % ((v + 1,) * (2 if with_normals else 1)) for v in face) + "\n"
    return text


def off(points, faces):
    rows = "".join("%g %g %g\n" % p for p in points) + "".join("3 %d %d %d\n" % f for f in faces)
    return f"OFF\n# made by make_solids.py\n{len(points)} {len(faces)} 0\n{rows}"


def main():
    folder = pathlib.Path(sys.argv[1])
    (folder / "stomach.obj").write_text(obj(*stomach(), True), encoding="utf-8")
    (folder / "ring.off").write_text(off(*ring()), encoding="utf-8")
    (folder / "jack.obj").write_text(obj(*jack(), True), encoding="utf-8")


if __name__ == "__main__":
    main()
