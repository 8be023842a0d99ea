# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope render: counts of grids against classify on the same points, pictures read by a reader of its own, the same bytes for every
number of threads, statuses and messages."""
import fractions
import json
import re
import struct
import subprocess
import sys
import unittest
import zlib

from support import MODELS, ROOT, Folder, run

CUBE = MODELS / "patches" / "cube.itd"
WHITE = b"\xff\xff\xff"


def pixels(path):
    """(width, height, rows of 3-byte pixels) of a PNG as RFC 2083 defines it."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            size = struct.unpack(">II", data[at + 8:at + 16])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, rows, before = zlib.decompress(packed), [], None
    stride = 3 * size[0]
    before = bytearray(stride)
    for y in range(size[1]):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, up = line[x - 3] if x >= 3 else 0, before[x]
            corner = before[x - 3] if x >= 3 else 0
            guess = left + up - corner
            paeth = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            line[x] = (line[x] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append([bytes(line[x:x + 3]) for x in range(0, stride, 3)])
        before = line
    return size[0], size[1], rows


def box(low, high):
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    rows = ["%r %r %r\n" % tuple((low, high)[i >> k & 1][k] for k in range(3)) for i in range(8)]
    return f"OFF\n8 {len(faces)} 0\n" + "".join(rows) + "".join("4 %d %d %d %d\n" % f for f in faces)


class RenderCase(Folder):
    def render(self, *arguments, status=0):
        done = run("render", *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout if status == 0 else re.sub(r"\s+", " ", done.stderr)

    def grid(self, *arguments, size="64,64"):
        return json.loads(self.render(*arguments, "-o", "g.png", "--size", size, "--json", "-"))


class Render(RenderCase):
    def setUp(self):
        super().setUp()
        (self.folder / "a.off").write_text(box((0, 0, 0), (1, 1, 1)))
        (self.folder / "b.off").write_text(box((0.5, 0.5, 0.5), (2, 2, 2)))
        run("boolean", "A - B", "A=a.off", "B=b.off", "-o", "e.json", cwd=self.folder)

    def counts_of_classify(self, model, bounds, n):
        """What classify counts, with the points as fractions."""
        bounds = [fractions.Fraction(b) for b in bounds]
        axes = [[bounds[k] + fractions.Fraction(2 * i + 1, 2 * n) * (bounds[k + 3] - bounds[k]) for i in range(n)] for k in range(3)]
        (self.folder / "points.txt").write_text("".join(f"{x} {y} {z}\n" for x in axes[0] for y in axes[1] for z in axes[2]))
        done = run("classify", model, "points.txt", "--decimals", "exact", "-o", "answers", "--json", "-", cwd=self.folder)
        counts = json.loads(done.stdout)["counts"]
        return {key: counts[key] for key in ("in", "on", "out", "undecided")}

    def test_grids_count_what_classify_says(self):
        for model, bounds, n in (("a.off", None, 5), ("a.off", "-1,-1,-1,2,2,2", 6), ("e.json", None, 8), ("e.json", "-1/3,-1,0,5/7,1,1", 7),
                                 (MODELS / "valid_frame.off", None, 9), (CUBE, "-1/2,-1/2,-1/2,3/2,3/2,3/2", 6), (CUBE, "0,0,0,1,1,1/3", 3)):
            report = self.grid(model, "--grid", n, *([f"--bounds={bounds}"] if bounds else []))
            grid = dict(report["grid"])
            self.assertEqual(grid.pop("n"), n)
            self.assertEqual(sum(grid.values()), n ** 3)
            self.assertEqual(grid, self.counts_of_classify(model, report["bounds"], n), (model, bounds, n))

    def test_points_on_the_boundary_are_on(self):
        self.assertEqual(self.grid("a.off", "--grid", 2, "--bounds=-1,-1,-1,3,3,3")["grid"], {"n": 2, "in": 0, "on": 1, "out": 7, "undecided": 0})
        self.assertEqual(self.grid("a.off", "--grid", 4)["grid"], {"n": 4, "in": 64, "on": 0, "out": 0, "undecided": 0})
        self.assertEqual(self.render("a.off", "-o", "g.png", "--grid", 1, "--size", "64,64"), "wrote  g.png  64 x 64, 1 point: 1 in, 0 on, 0 out\n")

    def test_the_box_of_a_model(self):
        self.assertEqual(self.grid("a.off", "--grid", 1)["bounds"], ["0", "0", "0", "1", "1", "1"])
        self.assertEqual(self.grid("e.json", "--grid", 1)["bounds"], ["0", "0", "0", "2", "2", "2"])
        run("boolean", "!A", "A=a.off", "-o", "n.json", "--box=-1,-1,-1,2,2,4/3", cwd=self.folder)
        self.assertEqual(self.grid("n.json", "--grid", 1)["bounds"], ["-1", "-1", "-1", "2", "2", "4/3"])
        self.assertIsNone(self.grid("a.off")["grid"])

    def test_a_picture_shows_three_sides_of_a_cube_and_white_around_it(self):
        self.render("a.off", "-o", "p.png", "--size", "120,100")
        width, height, rows = pixels(self.folder / "p.png")
        self.assertEqual((width, height), (120, 100))
        flat = [p for row in rows for p in row]
        self.assertEqual({rows[0][0], rows[0][-1], rows[-1][0], rows[-1][-1]}, {WHITE})
        frequent = [p for p in set(flat) if flat.count(p) > 300]
        self.assertEqual(len(frequent), 4, "white and three shades")

    def test_the_area_of_a_square_seen_from_its_front(self):
        """A cube along an axis is a square that fills the room: the picture without margins of 1/32 on each side."""
        self.render("a.off", "-o", "p.png", "--size", "320,320", "--view", "0,0,-1")
        rows = pixels(self.folder / "p.png")[2]
        shown = sum(p != WHITE for row in rows for p in row)
        self.assertLess(abs(shown - 300 ** 2), 4 * 300 * 2)

    def test_a_box_cuts_the_solid_open(self):
        self.render("a.off", "-o", "p.png", "--size", "100,100", "--view", "0,0,-1", "--bounds=-1,-1,-1,2,2,0.5")
        self.render("a.off", "-o", "q.png", "--size", "100,100", "--view", "0,0,-1", "--bounds=-1,-1,-1,2,2,1")
        cut, whole = (pixels(self.folder / name)[2][50][50] for name in ("p.png", "q.png"))
        self.assertGreater(cut[0], cut[2], "a warm tint")
        self.assertLess(whole[0], whole[2], "the side itself is no cut")

    def test_bytes_do_not_depend_on_threads(self):
        for arguments in (["e.json"], [CUBE], ["e.json", "--grid", 20], [MODELS / "valid_frame.off", "--view", "1,2,3"]):
            for jobs in (1, 2, 3):
                self.render(*arguments, "-o", f"{jobs}.png", "--jobs", jobs, "--size", "90,70")
            self.assertEqual((self.folder / "1.png").read_bytes(), (self.folder / "2.png").read_bytes())
            self.assertEqual((self.folder / "1.png").read_bytes(), (self.folder / "3.png").read_bytes())

    def test_plates_thinner_than_a_pixel_are_seen(self):
        (self.folder / "plate.off").write_text(box((0, 0, 0.5), (1, 1, 0.500001)))
        for view in ("0,0,-1", "1,2,-5", "-3,1,-2"):
            self.render("plate.off", "-o", "p.png", "--size", "100,100", "--view", view)
            rows = pixels(self.folder / "p.png")[2]
            self.assertNotEqual(rows[50][50], WHITE, view)
            self.assertGreater(sum(p != WHITE for row in rows for p in row), 1000, view)

    def test_models_that_are_no_solids_are_refused(self):
        self.assertIn("INVALID", self.render(MODELS / "m3_missing_face.off", "-o", "x.png", status=1))
        self.assertIn("M3", self.render(MODELS / "m3_missing_face.off", "-o", "x.png", status=1))
        self.render(MODELS / "unreadable_empty.off", "-o", "x.png", status=4)
        self.render(MODELS / "patches" / "not_certified_smallest.vjson", "-o", "x.png", status=3)
        self.assertIn("--bounds: the box of the picture", self.render("a.off", "-o", "x.png", "--bounds=1e300,1,1,2e300,2,2", status=2))
        self.assertIn("no point of the solid", self.render("a.off", "-o", "x.png", "--bounds", "5,5,5,6,6,6", status=4))
        self.assertFalse((self.folder / "x.png").exists())

    def test_an_empty_expression_has_no_points(self):
        run("boolean", "A - A", "A=a.off", "-o", "n.json", cwd=self.folder)
        self.assertEqual(self.grid("n.json", "--grid", 3)["grid"], {"n": 3, "in": 0, "on": 0, "out": 27, "undecided": 0})
        self.render("n.json", "-o", "x.png", "--size", "64,64", status=4)

    def test_walls_that_are_not_part_of_the_result_are_not_drawn(self):
        """The hole is flush with both sides of the plate: one looks through it."""
        (self.folder / "hole.off").write_text(box((0.25, 0.25, 0), (0.75, 0.75, 0.25)))
        (self.folder / "flat.off").write_text(box((0, 0, 0), (1, 1, 0.25)))
        run("boolean", "A - B", "A=flat.off", "B=hole.off", "-o", "f.json", cwd=self.folder)
        self.render("f.json", "-o", "p.png", "--size", "100,100", "--view", "0,0,-1")
        rows = pixels(self.folder / "p.png")[2]
        self.assertEqual({rows[y][x] for y in range(30, 70) for x in range(30, 70)}, {WHITE})
        self.assertNotEqual(rows[50][15], WHITE)


class Figures(RenderCase):
    """examples/esc_figures: what the program counts is what the commands count."""

    def test_counts_of_the_figures(self):
        folder = ROOT / "examples" / "esc_figures"
        for mesh in ("stomach.obj", "ring.off", "jack.obj"):
            name = mesh.split(".")[0]
            self.assertEqual(run("convert", "--pn", folder / mesh, self.folder / f"{name}.vjson").returncode, 0)
        for name, expression in (("union", "S | R"), ("intersection", "S & R"), ("difference", "S - R")):
            run("boolean", expression, "S=stomach.vjson", "R=ring.vjson", "-o", f"{name}.json", cwd=self.folder)
        expected = re.findall(r"(?m)^\d+  (union|intersection|difference|third solid) +(\d+) in, (\d+) on, +(\d+) out, (\d+) undecided$", (folder / "expected.txt").read_text())
        self.assertEqual(len(expected), 4)
        for name, *counts in expected:
            model, n, bounds = (f"{name}.json", 32, "-7/4,-3/2,-15/8,15/8,3/2,7/4")
            if name == "third solid":
                model, n, bounds = ("jack.vjson", 25, "-3/2,-3/2,-3/2,3/2,3/2,3/2")
            grid = self.grid(model, "--grid", n, f"--bounds={bounds}")["grid"]
            self.assertEqual([str(grid[key]) for key in ("in", "on", "out", "undecided")], counts, name)

    def test_the_meshes_are_those_of_the_script(self):
        folder = ROOT / "examples" / "esc_figures"
        subprocess.run([sys.executable, folder / "make_solids.py", self.folder], check=True)
        for mesh in ("stomach.obj", "ring.off", "jack.obj"):
            self.assertEqual((self.folder / mesh).read_text(), (folder / mesh).read_text())


if __name__ == "__main__":
    unittest.main()
