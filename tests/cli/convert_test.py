#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope convert: what is written reads back as the same model, or it is refused, or the loss is reported."""
import re
import unittest

import support
from support import MODELS, VALID, Folder, run

EXACT = ["stl-ascii", "obj", "ply", "ply-ascii", "ply-be", "off"]
EXTENSION = {"stl-ascii": "stl", "ply-ascii": "ply", "ply-be": "ply"}


class Convert(Folder):
    def convert(self, *arguments):
        return run("convert", *arguments)

    def judged(self, *paths_and_options):
        """What must survive in each file: verdict, rule counts, quantities, box."""
        kept = ("verdict", "rules", "volume", "bbox", "shells")
        files = support.report("--no-check", *paths_and_options)["files"]
        return [{key: file[key] for key in kept} for file in files]

    def test_every_exact_format_keeps_every_model(self):
        rows = [row for row in support.expectations() if row["verdict"] != "UNREADABLE" and row["options"] == "-"]
        sources = [MODELS / row["file"] for row in rows]
        expected = self.judged(*sources)
        for target in EXACT:
            paths = [self.folder / f"{i}.{EXTENSION.get(target, target)}" for i in range(len(sources))]
            for source, path in zip(sources, paths):
                done = self.convert("--to", target, source, path)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("nothing lost", done.stdout)
            for row, ours, theirs in zip(rows, self.judged(*paths), expected, strict=True):
                with self.subTest(row["file"], to=target):
                    self.assertEqual(ours, theirs)

    def test_the_name_of_the_output_chooses_the_format(self):
        for name, variant in [("a.stl", "stl-binary"), ("a.OBJ", "obj"), ("a.ply", "ply-binary-little-endian"), ("a.off", "off")]:
            self.assertEqual(self.convert(VALID, self.folder / name).returncode, 0)
            file = support.json.loads(run("info", "--json", "-", self.folder / name).stdout)["files"][0]
            self.assertEqual(file["variant"], variant)

    def test_float_is_for_binary_ply(self):
        path = self.folder / "a.ply"
        for target in ("ply", "ply-be"):
            self.assertEqual(self.convert("--float", "--to", target, VALID, path).returncode, 0)
            self.assertIn(b"property float x", path.read_bytes())

    def test_a_loss_is_refused_and_nothing_is_written(self):
        path = self.folder / "x.stl"
        for model in ("m3_crack.stl", "valid_tiny.off", "m6_nearest_valid.off"):
            done = self.convert(MODELS / model, path)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, r"not written, it would lose something: \d+ vert")
            self.assertIn("--lossy", done.stderr)
            self.assertEqual(self.listing(), [])
        self.assertEqual(self.convert("--float", MODELS / "m3_crack.stl", self.folder / "x.ply").returncode, 1)

    def test_pn_triangles_are_smooth_solids_over_meshes(self):
        cage = self.folder / "cage.obj"
        corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
        faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]

        def write(normals, corner="{0}//{0}"):
            text = "".join("v %d %d %d\n" % c for c in corners) + "".join(f"vn {n}\n" for n in normals)
            text += "".join("f " + " ".join(corner.format(v + 1) for v in f) + "\n" for f in faces)
            cage.write_text(text)

        own = ["%d %d %d" % c for c in corners]
        out = self.folder / "smooth.vjson"
        write(own)
        done = self.convert("--pn", cage, out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("8 entities, nothing lost\n  normals: those of the file", done.stdout)
        volume = support.only_file(out)["volume"]
        with_own = out.read_bytes()
        write(own, "{0}")
        done = self.convert("--pn", cage, out)
        self.assertIn("normals: sums over triangles, weighted by area", done.stdout)
        self.assertEqual(out.read_bytes(), with_own)  # by symmetry
        self.assertEqual(support.only_file(out)["verdict"], "VALID")
        self.assertGreater(float(volume["lo"]), 4 / 3)  # of the octahedron itself
        for format_ in ("off", "ply", "stl"):
            mesh = self.folder / f"cage.{format_}"
            self.convert(cage, mesh)
            self.assertEqual(self.convert("--pn", mesh, out).returncode, 0)
            if format_ != "stl":
                self.assertEqual(out.read_bytes(), with_own)

    def test_pn_refuses_corners_by_face_and_vertex(self):
        cage, out = self.folder / "t.obj", self.folder / "t.vjson"
        lines = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nvn 1 1 1\nvn -1 -1 1\nvn -1 1 -1\nvn %s\n"
        faces = "f 1//1 3//3 2//2\nf 1//1 2//2 4//4\nf 1//1 4//4 3//3\nf 2//2 3//3 4//4\n"
        for normal, face, words in (("1 -1 -1", faces.replace("f 1//1 4//4", "f 1//2 4//4"), "t.obj: face 2: vertex 0: the vertex has two normals"),
                                    ("0 0 0", faces, "t.obj: face 1: vertex 3: the normal of corner 2 is zero"),
                                    ("-1 1 1", faces, "t.obj: face 1: vertex 3: the normal of corner 2, (-1, 1, 1), is 90 degrees or more off")):
            cage.write_text(lines % normal + face)
            done = self.convert("--pn", cage, out)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(words, re.sub(r"\s+", " ", done.stderr))
            self.assertFalse(out.exists())
        cage.write_text(lines % "1 -1 nan" + faces)
        self.assertEqual(self.convert("--pn", cage, out).returncode, 4)

    def test_the_names_of_info_are_targets(self):
        names = support.json.loads(run("info", "--json", "-", VALID).stdout)["files"][0]["lossless"]
        self.assertIn("ply-binary-little-endian-float", names)
        for name in names:
            path = self.folder / f"x.{name[:3]}"
            self.assertEqual(self.convert("--to", name, VALID, path).returncode, 0)
            self.assertEqual(support.json.loads(run("info", "--json", "-", path).stdout)["files"][0]["variant"], name.replace("-float", ""))

    def test_what_is_dropped_is_told_wherever_the_model_goes(self):
        model = self.folder / "m.obj"
        model.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nvn 0 0 1\nf 1 2 3\n")
        self.assertIn("dropped: 1 vn lines, 1 unreferenced vertex, the numbers of the vertices", self.convert(model, self.folder / "x.stl").stdout)
        self.assertIn("dropped: 1 vn lines\n", self.convert(model, self.folder / "x.off").stdout)
        done = self.convert(model, "-", "--to", "off")
        self.assertTrue(done.stdout.startswith("OFF"))
        self.assertEqual(done.stderr, "veritope: not part of the model, dropped: 1 vn lines\n")

    def test_no_advice_that_cannot_be_followed(self):
        model = self.folder / "m.off"
        model.write_text("OFF\n3 1 0\n0 0 0\n1e200 0 0\n0 1 0\n3 0 1 2\n")
        done = self.convert(model, self.folder / "x.stl")
        self.assertEqual(done.returncode, 1)
        self.assertIn("vertex 1 is too large for binary32", done.stderr)
        self.assertNotIn("--lossy", done.stderr)

    def test_lossy_tells_the_largest_displacement_and_its_vertex(self):
        model = self.folder / "m.off"
        model.write_text(VALID.read_text().replace("\n0 1 0", "\n0 1 0.1", 1).replace("\n0 0 1", "\n0 0 100000.1", 1))
        done = self.convert("--lossy", model, self.folder / "x.stl")
        self.assertEqual(done.returncode, 0)
        moved, size, vertex = re.search(r"(\d+) vertices move by at most (\S+) \(vertex (\d+)\)", done.stdout).groups()
        self.assertEqual((moved, vertex), ("2", "3"))
        self.assertEqual(float(size), float("%.6g" % abs(100000.1 - 100000.1015625)))

    def test_lossy_tells_what_becomes_equal(self):
        done = self.convert("--lossy", MODELS / "m3_crack.stl", self.folder / "x.stl")
        self.assertIn("1 vertex becomes equal to others", done.stdout)
        self.assertEqual(self.judged(self.folder / "x.stl")[0]["verdict"], "VALID")

    def test_what_binary32_cannot_hold_at_all_is_refused_even_then(self):
        done = self.convert("--lossy", MODELS / "valid_huge.off", self.folder / "x.stl")
        self.assertEqual(done.returncode, 4)
        self.assertEqual(self.listing(), [])

    def test_indices_are_a_loss_only_where_they_were_kept(self):
        model = MODELS / "valid_own_corners.off"
        self.assertEqual(self.convert("--to", "stl-ascii", model, self.folder / "a.stl").returncode, 0)
        done = self.convert("--to", "stl-ascii", "--as-indexed", model, self.folder / "b.stl")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the vertex indices are not kept", done.stderr)
        self.assertEqual(self.convert("--to", "stl-ascii", "--as-indexed", "--lossy", model, self.folder / "b.stl").returncode, 0)
        for target in ("obj", "ply", "ply-ascii", "ply-be", "off"):
            path = self.folder / f"c.{EXTENSION.get(target, target)}"
            self.assertEqual(self.convert("--to", target, "--as-indexed", model, path).returncode, 0)
            self.assertEqual(self.judged("--as-indexed", path), self.judged("--as-indexed", model))

    def test_standard_streams(self):
        done = run("convert", "--format", "off", "--to", "obj", "-", "-", input=VALID.read_text())
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.count("f "), 4)
        self.assertEqual(run("certify", "-q", "--format", "obj", "-", input=done.stdout).returncode, 0)

    def test_the_input_is_never_replaced(self):
        model = support.shutil.copy(VALID, self.folder / "m.off")
        (self.folder / "link.off").symlink_to(model)
        for output in ("m.off", "link.off"):
            done = self.convert(model, self.folder / output)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("is the input", done.stderr)
        self.assertEqual(model.read_text(), VALID.read_text())

    def test_errors(self):
        self.assertEqual(self.convert(MODELS / "unreadable_nan.stl", self.folder / "x.off").returncode, 4)
        self.assertEqual(self.convert(VALID, "/nonexistent/x.off").returncode, 4)
        self.assertEqual(self.convert(VALID, self.folder).returncode, 2)
        self.assertEqual(self.listing(), [])


if __name__ == "__main__":
    support.main()
