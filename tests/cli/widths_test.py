#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What every command prints on a terminal of 80 and of 120 columns: no line is longer, and the text is that of widths_80.txt and widths_120.txt.

    widths_test.py --update    writes these files: after a change that is meant to change the output
"""
import difflib
import os
import pathlib
import re
import sys
import tempfile
import unittest

import support
from support import COMMANDS, DATA, ROOT
from terminal import run_on_terminal

HERE = pathlib.Path(__file__).resolve().parent
WIDTHS = (80, 120)
EXAMPLES = ["part_with_hole.stl", "quarter_pipe.itd", "self_crossing.off", "sound_part.stl"]
MESHES = ["m3_crack.stl", "m7_flat.off", "m8_smallest.off", "valid_nested_three.off", "valid_quads_crlf.obj", "unreadable_index.off"]
SPLINES = ["groups.itd", "objects.g2", "patches.mesh", "surface.xml", "trimmed.itd", "two_cubes.mesh"]
PATCHES = ["cube.itd", "patches_crossing_smallest.itd", "side_open_crack.itd", "side_parametrization_smallest.vjson", "not_certified_smallest.vjson"]
# Real models, with what they are in the name: long numbers, many defects, long messages.
REAL = ["mesh/*/admesh__*.stl", "mesh/*/*bunny*", "cad/gotools-data__nut_*.g2", "cad/irit__*.itd", "cad/*.step", "thin/k_*.vjson"]


def screen(shown):
    """The lines that stay on a terminal: progress is erased."""
    return re.sub(r"[^\n]*\r\x1b\[K", "", shown.replace("\r\n", "\n"))


def on_terminal(columns, *arguments, folder):
    return screen(run_on_terminal(*arguments, environment={"NO_COLOR": "1"}, columns=columns, folder=folder))


def command_lines():
    """What the golden files show, in a folder with links to examples and tests."""
    models = [f"examples/{name}" for name in EXAMPLES] + [f"tests/models/{name}" for name in MESHES]
    splines = [f"tests/models/splines/{name}" for name in SPLINES] + [f"tests/models/patches/{name}" for name in PATCHES]
    cube = "tests/models/patches/cube.itd"
    for name in COMMANDS:
        yield [name, "--help"]
    for path in models + splines:
        yield ["info", path]
        yield ["certify", "--no-check", "--max-defects", "3", path]
    yield ["certify", "-q", "--no-check", *models, *splines]
    yield ["certify", "--glob", "*.off", "-q", "examples"]
    yield ["convert", models[0], "o.obj"]
    yield ["convert", "tests/models/valid_quads_crlf.obj", "o.stl"]
    yield ["convert", cube, "o.g2"]
    yield ["convert", "--pn", "tests/models/valid_nested_three.off", "o.vjson"]
    yield ["convert", "tests/models/splines/trimmed.itd", "o.vtu"]
    yield ["convert", "tests/cli/welds/walls.itd", "o.vjson", "--weld", "1e-3"]
    yield ["intersect", cube, cube]
    yield ["project", "1,2,3", cube]
    yield ["project", "1/3,2,3", "tests/models/splines/objects.g2"]
    yield ["classify", "examples/part_with_hole.stl", "examples/sound_part.stl"]
    yield ["inspect", "tests/models/splines/two_cubes.mesh"]
    yield ["inspect", "tests/models/splines/two_cubes.mesh", "--pair", "0,1"]
    yield ["inspect", "tests/models/patches/volume_folded_smallest.itd"]
    yield ["inspect", cube]
    yield ["chain", "examples/sound_part.stl"]
    yield ["chain", "tests/models/patches/cube.itd", "--origin", "auto"]
    yield ["chain", "examples/self_crossing.off"]
    yield ["boolean", "A - (B | !A)", "A=tests/models/valid_nested_three.off", "B=examples/sound_part.stl", "-o", "e.json"]
    yield ["boolean", "A | (B", f"A={models[0]}", "-o", "x.json"]
    yield ["boolean", "A | B", f"A={models[0]}", "B=examples/self_crossing.off", "-o", "x.json"]
    yield ["build", "tests/cli/trees/parts.json", "-o", "o.vjson"]
    yield ["build", "tests/cli/trees/wrong.json", "-o", "x.vjson"]
    yield ["cage", "box", "--around", "examples/sound_part.stl", "-o", "box.vjson"]
    yield ["cage", "radial", "--outer", "2", "--height", "0,1", "--sector", "50", "-o", "o.vjson"]
    yield ["cage", "hull", "--around", "tests/models/valid_nested_three.off", "-o", "o.vjson"]
    yield ["cage", "radial", "--around", "tests/models/valid_nested_three.off", "--sector", "90", "-o", "x.vjson"]
    yield ["micro", "--cage", "box.vjson", "--tile", "jack", "--counts", "3,3,3", "--model", "examples/sound_part.stl", "-o", "o.vmicro"]
    yield ["micro", "--cage", "box.vjson", "--tile", "jack", "--counts", "1,1,1", "--thickness", "x/7", "-o", "x.vmicro"]
    yield ["cage", "split", "--of", "box.vjson", "--at", "u=1/2", "--open", "w1", "--from", "1/2", "--low", "0,0,1", "-o", "x.vjson"]
    yield ["dms", "make", "tests/models/dms/domain.vdms", "-o", "m.vdms", "--degree", "3", "--clouds", "1/10:7", "--control", "edges"]
    yield ["dms", "eval", "m.vdms", "tests/cli/dms_points.txt"]
    yield ["dms", "eval", "m.vdms", "tests/cli/nothing.txt"]
    yield ["dms", "eval", "--help"]
    yield ["dms", "make", "--help"]
    yield ["dms", "domain", "tests/cli/dms_points.txt", "-o", "d.vdms", "--hull"]
    yield ["dms", "domain", "--help"]
    yield ["dms", "xray", "--help"]
    yield ["dms", "refine", "tests/models/dms/tetrahedron.vdms", "--at", "1/4,1/5,1/6", "--cloud", "1/4,1/5,1/7", "-o", "r.vdms"]
    yield ["dms", "refine", "tests/models/dms/tetrahedron.vdms", "--at", "1/3,1/3,0", "-o", "x.vdms"]
    yield ["dms", "refine", "tests/models/dms/tetrahedron.vdms", "--at", "0,0,0", "-o", "x.vdms"]
    yield ["info", "tests/models/dms/attribute_domain.vdms"]
    yield ["dms", "refine", "--help"]
    yield ["dms", "boundary", "tests/models/dms/tetrahedron.vdms", "-o", "b.vjson"]
    yield ["dms", "boundary", "--help"]
    yield ["dms", "edit", "tests/models/dms/tetrahedron.vdms", "tests/cli/dms_moves.json", "-o", "r.vdms"]
    yield ["dms", "edit", "--help"]
    yield ["dms", "iso", "--help"]
    yield ["info", "tests/models/dms/tetrahedron.vdms"]
    yield ["classify", "e.json", "examples/sound_part.stl"]
    yield ["certify", "e.json"]
    yield ["render", "e.json", "-o", "e.png", "--size", "64,64", "--grid", "25"]
    yield ["render", "examples/self_crossing.off", "-o", "e.png"]
    yield ["render", "tests/models/splines/two_cubes.mesh", "-o", "a.gltf", "--explode", "1", "--nets"]
    yield ["render", "examples/self_crossing.off", "-o", "e.png", "--nets"]
    yield ["render", "--help"]
    yield ["render", "tests/models/dms/tetrahedron.vdms", "-o", "e.png", "--mode", "slice", "--attribute", "density", "--size", "64,64"]
    yield ["render", "tests/models/dms/tetrahedron.vdms", "-o", "e.png", "--attribute", "density", "--size", "64,64"]
    yield ["render", "tests/models/dms/tetrahedron.vdms", "-o", "e.png", "--mode", "xray", "--attribute", "mass"]
    yield ["cover", cube, "-o", "o.vtu"]
    yield ["cover", cube, "--sweep", "1"]
    for page in ([], ["M3"], ["side-open"], ["undecided"], ["face"]):
        yield ["explain", *page]
    yield ["certify", "-q", cube, "--certificate", "c"]
    yield ["explain-certificate", "c"]
    yield ["selftest", "--cases", "100"]
    yield ["selftest", "--verbose", "--cases", "100"]
    yield ["certify", "--format", "stpl", "x"]
    yield ["convert", cube, "o.stl"]
    yield ["predicate", "nothing", "x"]


COMMAND_LINES = list(command_lines())


def golden(columns):
    text = ""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("examples", "tests"):
            os.symlink(ROOT / name, pathlib.Path(folder) / name)
        for line in COMMAND_LINES:
            shown = on_terminal(columns, *line, folder=folder)
            shown = re.sub(r"(?m)^  time  .*\n(   .*\n)*", "", shown)  # of runs that took over a second
            text += f"$ veritope {' '.join(line)}\n{shown}\n"
    return text


def golden_file(columns):
    return HERE / f"widths_{columns}.txt"


class Goldens(unittest.TestCase):
    def check(self, columns):
        found = golden(columns)
        for line in found.splitlines():
            self.assertTrue(len(line) <= columns or line.startswith("$ "), f"{len(line)} columns: {line}")
        want = golden_file(columns).read_text()
        unlike = "\n".join(difflib.unified_diff(want.splitlines(), found.splitlines(), "golden", "found", lineterm="", n=2))
        self.assertEqual(unlike, "", "if the output was meant to change: widths_test.py --update")

    def test_80_columns(self):
        self.check(80)

    def test_120_columns(self):
        self.check(120)

    def test_every_command_is_shown(self):
        listed = re.findall(r"(?m)^  ([a-z-]+) {2,}", support.run("--help").stdout.split("Subcommands:")[1])
        shown = {line[0] for line in COMMAND_LINES if "--help" not in line}
        self.assertEqual(set(listed), set(COMMANDS))
        self.assertEqual(set(listed) - shown, {"corpus"})  # its lines are for programs


@unittest.skipUnless(DATA.is_dir(), "needs VERITOPE_DATA")
class RealModels(unittest.TestCase):
    def test_no_line_but_a_path_is_longer_than_the_terminal(self):
        paths = [path for pattern in REAL for path in sorted(DATA.glob(pattern))[:4]]
        self.assertGreater(len(paths), 8)
        for columns in WIDTHS:
            for command in (["info"], ["certify", "--no-check", "--max-cells", "2000"]):
                shown = "".join(on_terminal(columns, *command, path.name, folder=path.parent) for path in paths)
                for line in shown.splitlines():
                    is_path = any(path.name in line for path in paths)
                    self.assertTrue(len(line) <= columns or is_path, f"{columns} columns: {line}")


def main():
    if "--update" in sys.argv:
        for columns in WIDTHS:
            golden_file(columns).write_text(golden(columns))
        return
    support.main()


if __name__ == "__main__":
    main()
