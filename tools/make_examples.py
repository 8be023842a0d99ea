#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes the bundled examples: examples/{sound_part.stl,part_with_hole.stl,self_crossing.off,quarter_pipe.itd}.

usage: make_examples.py [FOLDER]      (default: examples/ of this tree)

sound_part.stl      an angle bracket: two plates, a fillet of six facets in the corner between them, a hole of sixteen
                    sides drilled through the base. Closed, one body, genus 1.
part_with_hole.stl  the same without the two facets of its front end: four boundary edges.
self_crossing.off   a wall and a hexagonal tube through it, one surface pushed through the other: every edge has two
                    facets, and yet it bounds no solid, because the tube crosses the wall.
quarter_pipe.itd    a quarter of a pipe of radii 2 and 4 and height 1, round exactly: six rational surfaces, volume 3
                    pi.

All coordinates are multiples of 1/64 below 64, so decimals, binary32 and binary64 hold them exactly.
"""
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def grid(value):
    """The nearest multiple of 1/64."""
    return round(value * 64) / 64


def arc(centre, radius, start, step, count):
    """count points on a circle, angles in degrees, rounded to the grid."""
    angles = [math.radians(start + step * i) for i in range(count)]
    return [(grid(centre[0] + radius * math.cos(a)), grid(centre[1] + radius * math.sin(a))) for a in angles]


def fan(polygon):
    return [(polygon[0], polygon[i], polygon[i + 1]) for i in range(1, len(polygon) - 1)]


def reverse(triangles):
    return [(a, c, b) for a, b, c in triangles]


def lift(triangles, place):
    return [tuple(place(*corner) for corner in triangle) for triangle in triangles]


def walls(loop, low, high, place):
    """The wall over a closed loop of plane points; outward if the loop, seen along the third axis, turns to the
    left."""
    triangles = []
    for p, q in zip(loop, loop[1:] + loop[:1]):
        quad = [place(*p, low), place(*q, low), place(*q, high), place(*p, high)]
        triangles += fan(quad)
    return triangles


def plate_with_hole(x0, x1, y0, y1, hole):
    """A rectangle minus a polygon of 4k corners, counter-clockwise, whose first corner looks along +x."""
    quarter = len(hole) // 4
    corners = [(x1, y1), (x0, y1), (x0, y0), (x1, y0)]
    triangles = []
    for i, corner in enumerate(corners):
        rim = [hole[(i * quarter + j) % len(hole)] for j in range(quarter + 1)]
        triangles += [(corner, q, p) for p, q in zip(rim, rim[1:])]
        triangles.append((corner, corners[(i + 1) % 4], rim[-1]))
    return triangles


def bracket():
    """The triangles of the sound part. Its profile lies in the plane of x and z and is extruded along y."""
    length, width, height, thick, radius = 48, 32, 40, 6, 6
    inner = thick + radius
    fillet = arc((inner, inner), radius, 270, -15, 7)  # from the base to the upright
    profile = [(0, 0), (length, 0), (length, thick)] + fillet + [(thick, height), (0, height)]
    hole = arc((31, 16), 8, 0, 22.5, 16)

    def at_y(y):
        return lambda x, z: (x, y, z)

    def at_z(z):
        return lambda x, y: (x, y, z)

    sides = lift(fan(profile), at_y(0)) + lift(reverse(fan(profile)), at_y(width))
    holed = {  # the two faces that the drill goes through replace the walls over these edges of the profile
        ((0, 0), (length, 0)): lift(reverse(plate_with_hole(0, length, 0, width, hole)), at_z(0)),
        ((length, thick), fillet[0]): lift(plate_with_hole(inner, length, 0, width, hole), at_z(thick)),
    }
    hull = []
    for p, q in zip(profile, profile[1:] + profile[:1]):
        quad = [(p[0], 0, p[1]), (p[0], width, p[1]), (q[0], width, q[1]), (q[0], 0, q[1])]
        hull += holed.get((p, q)) or fan(quad)
    drill = reverse(walls(hole, 0, thick, lambda x, y, z: (x, y, z)))
    return sides + hull + drill


def tube_through_wall():
    """Vertices and polygons of the crossing pair: a box, and a hexagonal tube with a bore along x."""
    vertices, polygons = [], []

    def add(ring):
        first = len(vertices)
        vertices.extend(ring)
        return list(range(first, first + len(ring)))

    def join(loop_a, loop_b):
        for i in range(len(loop_a)):
            j = (i + 1) % len(loop_a)
            polygons.append([loop_a[i], loop_a[j], loop_b[j], loop_b[i]])

    square = [(-20, -20), (20, -20), (20, 20), (-20, 20)]
    near, far = (add([(x, y, z) for y, z in square]) for x in (-2, 2))
    join(near, far)
    polygons.extend([near[::-1], far])

    outer, bore = ([(r * y, r * z) for y, z in ((4, 0), (2, 3), (-2, 3), (-4, 0), (-2, -3), (2, -3))] for r in (3, 2))
    rings = {(name, x): add([(x, y, z) for y, z in ring]) for name, ring in (("outer", outer), ("bore", bore))
             for x in (-24, 24)}
    join(rings["outer", -24], rings["outer", 24])
    join(rings["bore", 24], rings["bore", -24])
    join(rings["bore", -24], rings["outer", -24])
    join(rings["outer", 24], rings["bore", 24])
    return vertices, polygons


def quarter_pipe():
    """Six nets of homogeneous points (w, w x, w y, w z), u fastest; dS/du x dS/dv points out."""
    inner, outer, low, high = 2, 4, 0, 1
    arc_of_circle = [(1, 0, 1), (1, 1, 1), (0, 2, 2)]  # w x, w y, w from (1, 0) to (0, 1)

    def at(i, radius, z):
        x, y, w = arc_of_circle[i]
        return (w, radius * x, radius * y, w * z)

    ends, arc_points = (0, 1), (0, 1, 2)
    radii, heights = (inner, outer), (low, high)
    return [
        [[at(u, outer, heights[v]) for u in arc_points] for v in ends],
        [[at(v, inner, heights[u]) for u in ends] for v in arc_points],
        [[at(v, radii[u], high) for u in ends] for v in arc_points],
        [[at(u, radii[v], low) for u in arc_points] for v in ends],
        [[at(0, radii[u], heights[v]) for u in ends] for v in ends],
        [[at(2, radii[v], heights[u]) for u in ends] for v in ends],
    ]


def number(value):
    return format(value, "g") if value == int(value) else repr(float(value))


def ascii_stl(name, triangles):
    lines = [f"solid {name}"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", " outer loop"]
        lines += ["  vertex " + " ".join(number(c) for c in corner) for corner in triangle]
        lines += [" endloop", "endfacet"]
    return "\n".join(lines + [f"endsolid {name}", ""])


def off(vertices, polygons):
    lines = ["OFF", f"{len(vertices)} {len(polygons)} 0"]
    lines += [" ".join(number(c) for c in vertex) for vertex in vertices]
    lines += [" ".join(str(i) for i in [len(polygon)] + polygon) for polygon in polygons]
    return "\n".join(lines + [""])


def itd(name, nets):
    lines = [f"[OBJECT {name}"]
    for net in nets:
        lines.append(f" [SURFACE BEZIER {len(net[0])} {len(net)} P3")
        lines += ["  " + " ".join("[" + " ".join(number(c) for c in point) + "]" for point in row) for row in net]
        lines[-1] += "]"
    return "\n".join(lines + ["]", ""])


def main(arguments):
    if len(arguments) > 1 or arguments[:1] in (["-h"], ["--help"]):
        print(__doc__)
        return 2
    folder = pathlib.Path(arguments[0]) if arguments else ROOT / "examples"
    folder.mkdir(parents=True, exist_ok=True)
    part = bracket()
    end = max(corner[0] for triangle in part for corner in triangle)
    opened = [triangle for triangle in part if any(corner[0] != end for corner in triangle)]
    files = {
        "sound_part.stl": ascii_stl("sound_part", part),
        "part_with_hole.stl": ascii_stl("part_with_hole", opened),
        "self_crossing.off": off(*tube_through_wall()),
        "quarter_pipe.itd": itd("QUARTER_PIPE", quarter_pipe()),
    }
    for name, text in files.items():
        (folder / name).write_bytes(text.encode("ascii"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
