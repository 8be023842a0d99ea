#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""make_models.py FOLDER: the solids and cages of the figures of [HPE22], as far as they are not of other origin.

bone.off          a bone of 4,252 triangles (figure 5)
cylinder.vjson    a ball on a cylinder, one closed complex of rational surfaces of revolution (figures 3, 4, 8)
cylinder.off      a mesh of it, for bridges: 48 points a ring
duck.off          a mesh of the duck of ../vrep_figures (figure 7)
bone_b.vjson      a cubic cage that follows the bone; bone_a.vjson, bone_c.vjson: linear across it (figure 5)
All numbers are short dyadic or small rational numbers, and no random numbers are used.
"""
import itertools
import json
import math
import pathlib
import sys
from fractions import Fraction as F

BONE_HALF_LENGTH = 4.5


def bone_radius(z, angle):
    """A shaft, and two knuckles at each end."""
    knuckle = math.exp(-((abs(z) - 3.6) / 0.75) ** 2)
    return 0.8 + 0.01 * z * z + knuckle * (0.45 + 0.3 * math.cos(2 * angle))


def bone(rings=70, segments=30, cut=26):
    """Rings between two poles: 2 rings segments = 4,200 triangles, and two more for each one that is cut in three."""
    def short(x):
        return round(x * 1024) / 1024
    points, faces = [], []
    for i in range(rings):
        t = math.pi * (i + 1) / (rings + 1)
        z = -BONE_HALF_LENGTH * math.cos(t)
        for k in range(segments):
            angle = 2 * math.pi * (k + (i % 2) / 2) / segments
            r = bone_radius(z, angle) * min(1.0, 1.9 * math.sin(t)) ** 0.75
            points.append((short(r * math.cos(angle)), short(r * math.sin(angle)), short(z)))
    south, north = len(points), len(points) + 1
    points += [(0.0, 0.0, -BONE_HALF_LENGTH), (0.0, 0.0, BONE_HALF_LENGTH)]
    for k in range(segments):
        n = (k + 1) % segments
        faces += [(south, n, k), (north, (rings - 1) * segments + k, (rings - 1) * segments + n)]
    for i in range(rings - 1):
        low, high = i * segments, (i + 1) * segments
        for k in range(segments):
            n = (k + 1) % segments
            if i % 2 == 0:  # the upper ring is turned by half a segment
                faces += [(low + k, low + n, high + k), (low + n, high + n, high + k)]
            else:
                faces += [(low + k, high + n, high + k), (low + k, low + n, high + n)]
    step = len(faces) // cut
    for f in range(cut):
        a, b, c = faces[f * step]
        m = len(points)
        points.append(tuple(round(sum(points[v][x] for v in (a, b, c)) / 3 * 65536) / 65536 for x in range(3)))
        faces[f * step] = (a, b, m)
        faces += [(b, c, m), (c, a, m)]
    return points, faces


def write_off(path, mesh):
    points, faces = mesh
    with open(path, "w", encoding="ascii") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines("{} {} {}\n".format(*p) for p in points)
        out.writelines("3 {} {} {}\n".format(*f) for f in faces)


# Arcs of circles as rational quadratic curves: points (x, y) with weights.
QUARTERS = [[((1, 0), 1), ((1, 1), 1), ((0, 1), 2)], [((0, 1), 2), ((-1, 1), 1), ((-1, 0), 1)],
            [((-1, 0), 1), ((-1, -1), 1), ((0, -1), 2)], [((0, -1), 2), ((1, -1), 1), ((1, 0), 1)]]


def profile():
    """Curves (r, z) from the bottom to the top: a disk, a cylinder of radius 3, a sphere of radius 5."""
    line = [[((0, 0), 1), ((3, 0), 1)], [((3, 0), 1), ((3, 8), 1)]]
    arcs = [[((3, -4), 1), ((5, F(-5, 2)), 1), ((5, 0), F(5, 4))], [((5, 0), 1), ((5, 5), 1), ((0, 5), 2)]]
    return line + [[((r, z + 12), w) for (r, z), w in arc] for arc in arcs]


def surface_of_revolution(curve, quarter):
    """The angle first, then along the profile: the normal points outward."""
    points = []
    for (x, y), a in quarter:
        for (r, z), b in curve:
            w = F(a) * F(b)
            points.append([x * r * w, y * r * w, F(z) * w, w])
    q = len(curve) - 1
    return {"kind": "surface", "group": None, "attributes": [], "shape": {
        "degrees": [2, q], "periodic": [False, False],
        "knots": [["0"] * 3 + ["1"] * 3, ["0"] * (q + 1) + ["1"] * (q + 1)],
        "rational": True, "components": 4, "points": [[str(F(c)) for c in p] for p in points]}}


def closed_rings(rings, south, north):
    """Rings of as many points each, from the south pole to the north pole, counterclockwise seen from the north."""
    n, points, faces = len(rings[0]), [p for ring in rings for p in ring] + [south, north], []
    last = (len(rings) - 1) * n
    for k in range(n):
        m = (k + 1) % n
        faces += [(len(points) - 2, m, k), (len(points) - 1, last + k, last + m)]
        for low in range(0, last, n):
            faces += [(low + k, low + m, low + n + m), (low + k, low + n + m, low + n + k)]
    return [tuple(round(x * 4096) / 4096 for x in p) for p in points], faces


def cylinder_mesh(segments=48):
    heights = [(3, z) for z in (0, 2, 4, 6)]
    start = math.atan2(-4, 3)
    up = [start + (math.pi / 2 - start) * i / 20 for i in range(20)]
    around = [2 * math.pi * k / segments for k in range(segments)]
    heights += [(5 * math.cos(t), 12 + 5 * math.sin(t)) for t in up]
    rings = [[(r * math.cos(a), r * math.sin(a), z) for a in around] for r, z in heights]
    return closed_rings(rings, (0, 0, 0), (0, 0, 17))


def de_boor(knots, degree, points, t):
    """The point at t of a B-spline curve."""
    span = max(i for i in range(degree, len(points)) if knots[i] <= t)
    d = [list(points[span - degree + j]) for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            i = span - degree + j
            a = (t - knots[i]) / (knots[i + degree - r + 1] - knots[i])
            d[j] = [(1 - a) * x + a * y for x, y in zip(d[j - 1], d[j])]
    return d[degree]


def duck_mesh(segments=32, rings=60):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "vrep_figures"))
    import make_trees  # its surface: closed rings, then along the spine
    surface = make_trees.duck()
    count = [int(k) for k in (10, len(surface["points"]) // 10)]
    knots = [[float(F(k)) for k in axis] for axis in surface["knots"]]
    points = [[float(F(c)) for c in p] for p in surface["points"]]
    net = [[points[i * count[1] + j] for j in range(count[1])] for i in range(count[0])]
    out = []
    for r in range(rings):
        v = knots[1][-1] * r / (rings - 1)
        ring = [de_boor(knots[1], 3, row, min(v, knots[1][-1] * (1 - 1e-12))) for row in net]
        out.append([de_boor(knots[0], 3, ring, 4 * k / segments) for k in range(segments)])

    def middle(ring):
        return tuple(sum(p[x] for p in ring) / len(ring) for x in range(3))
    return closed_rings(out, middle(out[0]), middle(out[-1]))


def spline_file(path, entities):
    text = json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}, separators=(",", ":"))
    pathlib.Path(path).write_text(text + "\n", encoding="ascii")


def cage(degrees, spans, net):
    """A volume with uniform knots; net(i, j, k) has the coordinates of a control point."""
    knots = [[str(F(min(max(t, 0), s), s)) for t in range(-d, s + d + 1)] for d, s in zip(degrees, spans)]
    n = [d + s for d, s in zip(degrees, spans)]
    places = itertools.product(range(n[0]), range(n[1]), range(n[2]))
    points = [[str(F(round(c * 64), 64)) for c in net(*at)] for at in places]
    return {"kind": "volume", "group": None, "attributes": [], "shape": {
        "degrees": list(degrees), "periodic": [False] * 3, "knots": knots, "rational": False, "components": 3,
        "points": points}}


def greville(d, s):
    """The abscissae of the clamped uniform knots of `s` spans, from 0 to 1."""
    t = [min(max(i, 0), s) / s for i in range(-d, s + d + 1)]
    return [sum(t[i + 1:i + d + 1]) / d for i in range(d + s)]


def bone_cage(degrees, spans, width, bulge):
    """Squares along the bone, wider at its ends by `bulge`."""
    at = [greville(d, s) for d, s in zip(degrees, spans)]

    def net(i, j, k):
        z = (2 * at[2][k] - 1) * (BONE_HALF_LENGTH + 0.25)
        bump = bulge * math.exp(-((abs(z) - 3.6) / 1.2) ** 2)
        return ((2 * at[0][i] - 1) * (width + bump), (2 * at[1][j] - 1) * (width + bump / 4), z)
    return cage(degrees, spans, net)


def main():
    folder = pathlib.Path(sys.argv[1])
    write_off(folder / "bone.off", bone())
    write_off(folder / "cylinder.off", cylinder_mesh())
    write_off(folder / "duck.off", duck_mesh())
    spline_file(folder / "cylinder.vjson", [surface_of_revolution(c, q) for q in QUARTERS for c in profile()])
    spline_file(folder / "bone_a.vjson", [bone_cage((1, 1, 3), (1, 1, 9), 1.72, 0.0)])
    spline_file(folder / "bone_b.vjson", [bone_cage((3, 3, 3), (1, 1, 9), 1.1, 0.85)])
    spline_file(folder / "bone_c.vjson", [bone_cage((1, 1, 3), (1, 1, 12), 1.0, 0.85)])


if __name__ == "__main__":
    main()
