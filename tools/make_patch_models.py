#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes tests/models/patches/: for each answer that `veritope explain` knows about spline models the smallest model
that gets it, and the nearest valid one, in five to twelve bilinear surfaces.

usage: make_patch_models.py [FOLDER]      (default: tests/models/patches/ of this tree)
"""
import pathlib
import sys

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
    yield "not_certified_smallest", cube + block(("0.25", "0.25", 1), ("0.75", "0.75", 2))
    yield "not_certified_nearest_valid", cube + block(("0.25", "0.25", "1.0001"), ("0.75", "0.75", 2))


def main(arguments):
    if len(arguments) > 1 or arguments[:1] in (["-h"], ["--help"]):
        print(__doc__)
        return 2
    folder = pathlib.Path(arguments[0]) if arguments else ROOT / "tests" / "models" / "patches"
    folder.mkdir(parents=True, exist_ok=True)
    for name, faces in models():
        (folder / f"{name}.itd").write_text(itd(faces))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
