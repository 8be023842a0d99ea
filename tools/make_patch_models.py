#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes tests/models/patches/: for each answer that `veritope explain` knows about spline models the smallest model
that gets it, and the nearest valid one, in two to twelve surfaces or one volume. Most are bilinear and written as
.itd; those with knots or degrees of their own are .vjson.

usage: make_patch_models.py [FOLDER]      (default: tests/models/patches/ of this tree)
"""
import json
import pathlib
import sys
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parent.parent


def corner(low, high, ends):
    return tuple((low, high)[end][axis] for axis, end in enumerate(ends))


def block(low, high):
    """The six faces of a box: [corner at (u, v) = (0, 0), (1, 0), (0, 1), (1, 1)], normals du x dv outward."""
    faces = []
    for axis in range(3):
        for end in (0, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            if end == 0:
                u, v = v, u
            ends = [0, 0, 0]
            ends[axis] = end
            net = []
            for at_v in (0, 1):
                for at_u in (0, 1):
                    ends[u], ends[v] = at_u, at_v
                    net.append(corner(low, high, ends))
            faces.append(net)
    return faces


def moved(faces, old, new):
    """Replaces the corner `old` wherever it occurs."""
    return [[new if p == old else p for p in net] for net in faces]


def turned(net):
    """The surface with its normal reversed."""
    a, b, c, d = net
    return [a, c, b, d]


def decimal(numerator, bits):
    """numerator / 2^bits, written exactly."""
    digits = f"{abs(numerator) * 5 ** bits:0{bits + 1}d}"
    fraction = digits[-bits:].rstrip("0")
    return "-" * (numerator < 0) + digits[:-bits] + ("." + fraction if fraction else "")


def plate(bits):
    """1 x 1 x 2^-bits, turned and scaled by 3: its sides are along (2, -1, 2), (2, 2, -1), (-1, 2, 2)."""
    def point(p):
        x, y, z = p[0] << bits, p[1] << bits, p[2]
        return tuple(decimal(n, bits) for n in (2 * x + 2 * y - z, -x + 2 * y + 2 * z, 2 * x - y + 2 * z))
    return [[point(p) for p in net] for net in block((0, 0, 0), (1, 1, 1))]


def itd(faces):
    lines = ["[OBJECT MODEL"]
    for a, b, c, d in faces:
        points = ["[" + " ".join(str(x) for x in p) + "]" for p in (a, b, c, d)]
        lines += [" [SURFACE BEZIER 2 2 E3", f"  {points[0]} {points[1]}", f"  {points[2]} {points[3]}]"]
    return "\n".join(lines + ["]"]) + "\n"


def surface(degrees, knots, points):
    """An entity of a .vjson file; `points` v fastest."""
    shape = {"degrees": degrees, "periodic": [False, False], "knots": knots, "rational": False, "components": 3,
             "points": [[str(x) for x in p] for p in points]}
    return {"kind": "surface", "group": None, "attributes": [], "shape": shape}


def vjson(entities):
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities}) + "\n"


def bilinear(net):
    a, b, c, d = net
    return surface([1, 1], [["0", "0", "1", "1"]] * 2, [a, c, b, d])


def lid_with_middle(x):
    """The upper face of the unit cube, of degree 2 in u, with the middle control points at x."""
    points = [(u, v, 1) for u in (0, x, 1) for v in (0, 1)]
    return surface([2, 1], [["0", "0", "0", "1", "1", "1"], ["0", "0", "1", "1"]], points)


def pinched_lid():
    """The upper face of the cube [-1, 1]^3 in three surfaces with a knot at u = 1/2, and the other faces, cut where
    they are. The middle one is (x, x^2 v, 1): one to one but for the line x = 0, which is one point."""
    x, square = ("-1", "-1/2", "1/2", "1"), (1, 0, 0, 1)
    bent, straight = ["0"] * 3 + ["1/2"] + ["1"] * 3, ["0", "0", "1", "1"]

    def sheet(y):
        return surface([2, 1], [bent, straight], [(a, y(f, t), 1) for a, f in zip(x, square) for t in (0, 1)])

    def cut(a, b, c, d):
        """A bilinear face from the side a b, which runs along x, to c d."""
        middle = [(0,) + p[1:] for p in (a, c)]
        return surface([1, 1], [["0", "0", "1/2", "1", "1"], straight],
                       [a, c, *middle, b, d])

    low, high = ([(end, y, z) for end in (-1, 1) for y in (-1, 1)] for z in (-1, 1))
    lids = [sheet(lambda f, t: f * (2 * t - 1)), sheet(lambda f, t: f + t * (1 - f)),
            sheet(lambda f, t: t * (1 - f) - 1)]
    return lids + [cut(low[1], low[3], low[0], low[2]), cut(low[0], low[2], high[0], high[2]),
                   cut(high[1], high[3], low[1], low[3]), bilinear([low[0], high[0], low[1], high[1]]),
                   bilinear([low[2], low[3], high[2], high[3]])]


def wavy_lid():
    """The upper face of the unit cube, z = 1 - (x^2 - 1/2)^2: it reaches z = 1 along an irrational line."""
    heights = ("3/4", "3/4", "11/12", "5/4", "3/4")
    return surface([4, 1], [["0"] * 5 + ["1"] * 5, ["0", "0", "1", "1"]],
                   [(f"{i}/4", v, z) for i, z in enumerate(heights) for v in (0, 1)])


def wavy_walls():
    """The two walls below the sides of that face on which y is fixed."""
    heights = ("3/4", "3/4", "11/12", "5/4", "3/4")
    knots = [["0"] * 5 + ["1"] * 5, ["0", "0", "1", "1"]]
    top = [(f"{i}/4", z) for i, z in enumerate(heights)]
    front = [(x, 0, z) for x, height in top for z in (0, height)]
    back = [(x, 1, z) for x, height in top for z in (height, 0)]
    return [surface([4, 1], knots, front), surface([4, 1], knots, back)]


def lid_below(block_above):
    """A block with a wavy lid, and another block above it."""
    low = [bilinear(net) for net in block((0, 0, 0), (1, 1, "3/4")) if len({p[1] for p in net}) > 1]
    return low[:3] + wavy_walls() + [wavy_lid()] + [bilinear(net) for net in block_above]


def lid_with_double_knot(z):
    """The upper face of the unit cube in two pieces of degree 1, the second of which begins at the height z."""
    points = [(u, v, w) for u, w in ((0, 1), ("1/2", 1), ("1/2", z), (1, 1)) for v in (0, 1)]
    return surface([1, 1], [["0", "0", "1/2", "1/2", "1", "1"], ["0", "0", "1", "1"]], points)


def hourglass():
    """Two pyramids with the apex (0, 0, 0), their walls in four patches; the line u = 1/2 of each is the apex."""
    low = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1)]
    walls = []
    for a, b in zip(low, low[1:] + low[:1]):
        walls.append([a, tuple(-x for x in a), b, tuple(-x for x in b)])
    bottom = [low[0], low[3], low[1], low[2]]
    top = [tuple(-x for x in p) for p in (low[0], low[1], low[3], low[2])]
    return [turned(w) for w in walls] + [bottom, top]


def belt_cut(faces):
    """The four faces around the y axis of the unit cube, cut in halves at x = 1/2 or not at all."""
    out = []
    for a, b, c, d in faces:
        along_u, along_v = a[0] != b[0], a[0] != c[0]
        middle = {p: ("0.5",) + p[1:] for p in (a, b, c, d)}
        if along_u:
            out += [[a, middle[b], c, middle[d]], [middle[a], b, middle[c], d]]
        elif along_v:
            out += [[a, b, middle[c], middle[d]], [middle[a], middle[b], c, d]]
        else:
            out.append([a, b, c, d])
    return out


def vjson_models():
    walls = [bilinear(net) for net in block((0, 0, 0), (1, 1, 1))[:5]]
    yield "side_parametrization_smallest", walls + [lid_with_middle("1/4")]
    yield "side_parametrization_nearest_valid", walls + [lid_with_middle("1/2")]
    yield "singular_line_on_a_knot", pinched_lid()
    yield "not_certified_smallest", lid_below(block((0, 0, 1), (1, 1, 2)))
    yield "not_certified_nearest_valid", lid_below(block((0, 0, "10001/10000"), (1, 1, 2)))
    yield "knot_multiplicity_smallest", walls + [lid_with_double_knot("5/4")]
    yield "knot_multiplicity_nearest_valid", walls + [lid_with_double_knot(1)]


def cell(corner, axes=(0, 1, 2)):
    """The unit cube as one volume, its corner (1, 1, 1) moved; axes: the parameters along x, y and z."""
    points = [[at[a] for a in axes] for at in ((u, v, w) for w in (0, 1) for v in (0, 1) for u in (0, 1))]
    words = ["[%s %s %s]" % (corner if p == [1, 1, 1] else tuple(p)) for p in points]
    rows = "\n".join("  " + " ".join(words[i:i + 2]) for i in range(0, 8, 2))
    return f"[OBJECT MODEL\n [TRIVAR BEZIER 2 2 2 E3\n{rows}]\n]\n"


def plate_with_knots(low, high, inner=""):
    """A box as one volume of degree 1; inner: knots of u and v, which are x and y."""
    steps = [low[0], *map(Fraction, inner.split()), high[0]]
    points = " ".join(f"[{x} {y} {z}]" for z in (low[2], high[2]) for y in steps for x in steps)
    knots = " ".join(map(str, [low[0], *steps, high[0]]))
    n = len(steps)
    return (f"[OBJECT MODEL\n [TRIVAR BSPLINE {n} {n} 2 2 2 2 E3 [KV {knots}] [KV {knots}] [KV 0 0 1 1]\n"
            f"  {points}]\n]\n")


def brick(low, high, knots_of_v="0 0 1 1"):
    """A box as one volume of degree 1; an inner knot of v is in the middle."""
    n = len(knots_of_v.split()) - 2
    ys = [low[1] + Fraction(j * (high[1] - low[1]), n - 1) for j in range(n)]
    decimal = lambda x: str(float(x)) if Fraction(x).denominator > 1 else str(x)
    points = " ".join("[" + " ".join(map(decimal, (x, y, z))) + "]"
                      for z in (low[2], high[2]) for y in ys for x in (low[0], high[0]))
    return (f"[OBJECT MODEL\n [TRIVAR BSPLINE 2 {n} 2 2 2 2 E3 [KV 0 0 1 1] [KV {knots_of_v}] [KV 0 0 1 1]\n"
            f"  {points}]\n]\n")


def wedge():
    """The prism over a triangle as one volume: the face u = 0 is collapsed to the edge x = y = 0."""
    points = " ".join(f"[{x} {y} {z}]" for z in (0, 1) for x, y in ((0, 0), (1, 0), (0, 0), (0, 1)))
    return f"[OBJECT MODEL\n [TRIVAR BEZIER 2 2 2 E3\n  {points}]\n]\n"


def volume_models():
    yield "volume_folded_smallest", cell(("0.6", "0.6", "0.6"))
    yield "volume_folded_nearest_valid", cell(("0.7", "0.7", "0.7"))
    yield "left_handed_smallest", cell((1, 1, 1), axes=(1, 0, 2))
    yield "left_handed_nearest_valid", cell((1, 1, 1))
    cubes = [brick((0, 0, 0), (1, 1, 1)), brick((0, 1, 0), (1, 2, 1))]
    yield "curve_nonmanifold_split", "".join([*cubes, brick((1, 0, 0), (2, 2, 1), knots_of_v="0 0 1 2 2")])
    yield "curve_nonmanifold_nearest_valid", "".join([*cubes, brick((1, 0, 0), (2, 1, 1)),
                                                      brick((1, 1, 0), (2, 2, 1))])
    one = brick((0, 0, 0), (1, 1, 1))
    yield "curve_nonmanifold_smallest", one + brick((1, 1, 0), (2, 2, 1))
    yield "point_nonmanifold_smallest", one + brick((1, 1, 1), (2, 2, 2))
    yield "overlap_smallest", one + brick((Fraction(1, 2),) * 3, (2, 2, 2))
    yield "overlap_nearest_valid", one + brick((1, 0, 0), (2, 1, 1))
    yield "flat_smallest", one + brick((0, 0, 1), (1, 1, 1))
    on, above = [brick((1, 1, z), (2, 2, 2)) for z in (1, Fraction(1001, 1000))]
    yield "partial_contact_smallest", plate_with_knots((0, 0, 0), (3, 3, 1), "1 2") + on
    yield "partial_contact_nearest_valid", plate_with_knots((0, 0, 0), (3, 3, 1), "1 2") + above
    yield "contact_smallest", plate_with_knots((0, 0, 0), (3, 3, 1)) + on
    yield "contact_nearest_valid", plate_with_knots((0, 0, 0), (3, 3, 1)) + above
    yield "wedge", wedge()


def models():
    cube = block((0, 0, 0), (1, 1, 1))
    top = (1, 1, 1)
    yield "cube", cube
    yield "side_open_smallest", cube[1:]
    yield "side_open_crack", cube[:5] + moved(cube[5:], top,
                                              (1, 1, "1.0000000000000002220446049250313080847263336181640625"))
    yield "side_direction_smallest", cube[:5] + [turned(cube[5])]
    yield "side_overused_smallest", cube + block((1, 1, 0), (2, 2, 1))
    yield "side_overused_nearest_valid", cube + block((1, "1.0001", 0), (2, 2, 1))
    yield "patches_crossing_smallest", moved(cube, top, ("0.2", "0.2", "-0.5"))
    yield "patches_crossing_nearest_valid", moved(cube, top, ("0.4", "0.4", "0.4"))
    yield "shell_turned_smallest", [turned(net) for net in cube]
    yield "shell_turned_thin", [turned(net) for net in plate(10)]
    yield "shell_turned_thin_nearest_valid", plate(10)
    yield "side_t_junction_smallest", cube[:5] + belt_cut(cube[5:])
    yield "side_t_junction_nearest_valid", belt_cut(cube)
    yield "patch_repeated_smallest", [cube[5], turned(cube[5])]
    yield "patch_degenerate_smallest", cube + [[top] * 4]
    yield "singular_line_smallest", hourglass()
    yield "patches_touching_smallest", cube + block(("0.25", "0.25", 1), ("0.75", "0.75", 2))
    yield "patches_touching_nearest_valid", cube + block(("0.25", "0.25", "1.0001"), ("0.75", "0.75", 2))
    yield "patches_touching_corners", cube + block((1, 1, 1), (2, 2, 2))


def main(arguments):
    if len(arguments) > 1 or arguments[:1] in (["-h"], ["--help"]):
        print(__doc__)
        return 2
    folder = pathlib.Path(arguments[0]) if arguments else ROOT / "tests" / "models" / "patches"
    folder.mkdir(parents=True, exist_ok=True)
    for name, faces in models():
        (folder / f"{name}.itd").write_text(itd(faces))
    for name, text in volume_models():
        (folder / f"{name}.itd").write_text(text)
    for name, entities in vjson_models():
        (folder / f"{name}.vjson").write_text(vjson(entities))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
