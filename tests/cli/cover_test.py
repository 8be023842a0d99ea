# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope cover, and certify --collar: files, reports, solids that certify accepts, refusals."""
import json
import unittest
import xml.etree.ElementTree

import schema
from certify_patches_test import UNIT, block, document, surface
from support import Folder, only_file, run


class Cover(Folder):
    def model(self, faces=UNIT, name="model.vjson"):
        path = self.folder / name
        path.write_text(document([surface(f) for f in faces]))
        return path

    def test_certify_reports_the_collar_and_certifies_it(self):
        kept = self.folder / "model.cert"
        done = run("certify", self.model(), "--collar", "--no-check", "--json", "-", "--certificate", kept)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        (one,) = report["files"]
        collar = one["collar"]
        self.assertTrue(collar["found"])
        # Smaller than the cube, so that something is left inside.
        self.assertLess(collar["edges"]["longest"], 1)
        statement = json.loads(kept.read_bytes().split(b"\n", 1)[0])
        self.assertEqual((statement["claim"], statement["cells"]), ("collar-1", collar["cells"]))
        text = run("certify", self.model(), "--collar", "--no-check").stdout
        self.assertIn(f"coarsest collar {collar['cells']} cells", " ".join(text.split()))

    def test_without_the_option_there_is_none(self):
        self.assertIsNone(only_file(self.model(), "--no-check")["collar"])

    def test_both_solids_are_valid_and_hold_each_other(self):
        faces = block((0, 0, 0), (8, 8, 8)) + block((3, 3, 3), (5, 5, 5), inward=True)
        volumes = {}
        for part in ("outer", "inner"):
            for end in ("obj", "ply", "off"):
                out = self.folder / f"{part}.{end}"
                done = run("cover", self.model(faces), "-o", out, "--what", part)
                self.assertEqual(done.returncode, 0, done.stderr)
                one = only_file(out)
                self.assertEqual(one["verdict"], "VALID")
                self.assertEqual((one["counts"]["genus"], one["counts"]["bodies"], one["counts"]["shells"]), (0, 1, 2))
                volumes[part] = float(one["volume"]["decimal"])
        self.assertLess(volumes["inner"], 8**3 - 2**3)
        self.assertGreater(volumes["outer"], 8**3 - 2**3)

    def test_boxes_and_cells_are_grids_of_hexahedra(self):
        for part, values in (("boxes", {"shell"}), ("collar", {"level", "shell"})):
            out = self.folder / f"{part}.vtu"
            done = run("cover", self.model(), "--output", out, "--what", part)
            self.assertEqual(done.returncode, 0, done.stderr)
            piece = xml.etree.ElementTree.parse(out).getroot().find("UnstructuredGrid/Piece")
            n = int(piece.get("NumberOfCells"))
            self.assertEqual(int(piece.get("NumberOfPoints")), 8 * n)
            self.assertEqual({a.get("Name") for a in piece.findall("CellData/DataArray")}, values)
            arrays = {a.get("Name"): a.text.split() for a in piece.iter("DataArray")}
            self.assertEqual(set(arrays["types"]), {"12"})
            self.assertEqual(arrays["connectivity"], [str(i) for i in range(8 * n)])
            points = [float(x) for x in arrays["Points"]]
            self.assertEqual(len(points), 24 * n)
            # The cells reach out of the cube, and all of them near its surface.
            self.assertLess(min(points), 0)
            self.assertGreater(max(points), 1)

    def test_boxes_are_closed_meshes_one_by_one(self):
        out = self.folder / "boxes.off"
        self.assertEqual(run("cover", self.model(), "-o", out, "--what", "boxes").returncode, 0)
        _, counts, *rest = out.read_text().split("\n")
        vertices, faces, _ = map(int, counts.split())
        self.assertEqual((vertices % 8, faces * 8), (0, vertices * 12))

    def test_what_keeps_volumes_from_a_surface_is_named_by_them(self):
        """An edge of a box lies on a line inside a face of a bar, along which the face is cut."""
        corners = lambda xs, ys: "".join("[%d %d %d]" % (x, y, z) for z in (0, 1) for y in ys for x in xs)
        bar = "[TRIVAR BSPLINE 3 2 2 2 2 2 E3 [KV 0 0 1 2 2] [KV 0 0 1 1] [KV 0 0 1 1] %s]\n" % corners((0, 2, 4), (0, 1))
        box = "[TRIVAR BEZIER 2 2 2 E3 [2 1 0][3 2 0][1 2 0][2 3 0] [2 1 1][3 2 1][1 2 1][2 3 1]]\n"
        model = self.folder / "standing.itd"
        model.write_text(bar + box)
        for options in (["-o", self.folder / "x.vtu"], ["--sweep", 0]):
            done = run("cover", model, *options)
            self.assertEqual(done.returncode, 3)
            self.assertIn("overused-side: edge u = 1, v = 1 of entity 0, ", done.stderr)
            self.assertNotIn("surface 0", done.stderr)

    def test_volumes_are_covered_by_their_boundary_faces(self):
        model = self.folder / "block.itd"
        net = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        model.write_text("[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%d %d %d]" % p for p in net))
        self.assertEqual(run("cover", model, "-o", self.folder / "a.vtu").returncode, 0)
        self.assertEqual(run("cover", self.model(UNIT), "-o", self.folder / "b.vtu").returncode, 0)
        counts = [len((self.folder / name).read_text().split()) for name in ("a.vtu", "b.vtu")]
        self.assertEqual(counts[0], counts[1])

    def test_an_undecided_or_invalid_model_writes_nothing(self):
        out = self.folder / "x.vtu"
        touching = UNIT + block((1, 0.25, 0.25), (2, 0.75, 0.75))
        for faces, status in ((block((0, 0, 0), (1, 1, 1), inward=True), 1), (UNIT[:5], 1), (touching, 1)):
            self.assertEqual(run("cover", self.model(faces), "-o", out).returncode, status)
            self.assertFalse(out.exists())
            out.write_text("old")
            self.assertEqual(run("cover", self.model(faces), "-o", out).returncode, status)
            self.assertEqual(out.read_text(), "old")
            out.unlink()

    def sweep(self, *options, faces=UNIT):
        done = run("cover", self.model(faces), "--sweep", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_a_sweep_tables_the_conditions_of_halved_sizes(self):
        head, *rows = self.sweep(1, "--eps", 0.5).splitlines()
        self.assertEqual(head.split(), "eps face edge vertex A B1 B2 C1 C2 C3 C3* cells K1 K2 K3".split())
        self.assertEqual([row.split()[0] for row in rows[:2]], ["0.5", "0.25"])
        for row in rows[:2]:
            self.assertEqual(row.split()[4:11], ["yes"] * 6 + ["no"])
        # A quarter of the cube and smaller cells leave an inner solid; three boxes in a corner have a part that the surface misses.
        self.assertEqual(rows[1].split()[12:15], ["yes"] * 3)
        self.assertRegex(rows[2], r"^ +C3\* +no at eps 0.25: boxes \d+, \d+, \d+: V misses it, at ")

    def test_a_sweep_as_json_says_the_same(self):
        text = self.sweep(1)
        self.assertEqual(self.sweep(1, "--eps", 0.25), text)  # of a side of 1
        report = json.loads(self.sweep(1, "--json", "-"))
        self.assertEqual(schema.faults(report), [])
        words = {"true": "yes", "false": "no", "undecided": "?"}
        for row, line in zip(report["rows"], text.splitlines()[1:]):
            answers = [c["answer"] for c in row["conditions"].values()]
            told = [row["eps"], *row["boxes"].values(), *(words[a] for a in answers), row["cells"], *(words[a] for a in row["collar"].values())]
            self.assertEqual([str(x) for x in told], line.split())

    def test_a_sweep_ends_at_its_budgets_and_says_so(self):
        (row,) = json.loads(self.sweep(0, "--eps", 1e-4, "--json", "-"))["rows"]
        self.assertEqual({c["answer"] for c in row["conditions"].values()} | set(row["collar"].values()), {"undecided"})
        self.assertRegex(row["limit"], "boxes: over .* cells: over")

    def test_the_last_boxes_of_a_sweep_are_a_picture(self):
        out = self.folder / "boxes.vtu"
        text = self.sweep(1, "--eps", 0.5, "-o", out)
        counts = [int(n) for n in text.splitlines()[2].split()[1:4]]
        piece = xml.etree.ElementTree.parse(out).getroot().find("UnstructuredGrid/Piece")
        arrays = {a.get("Name"): a.text.split() for a in piece.iter("DataArray")}
        self.assertEqual([arrays["kind"].count(k) for k in "012"], counts)
        self.assertEqual(int(piece.get("NumberOfCells")), sum(counts))

    def test_a_sweep_of_an_open_surface_is_undecided(self):
        done = run("cover", self.model(UNIT[:5]), "--sweep", 1)
        self.assertEqual((done.returncode, done.stdout), (3, ""))
        self.assertIn("open-side", done.stderr)

    def test_a_message_names_its_file_once(self):
        step, model = self.folder / "part.step", self.model()
        step.write_text("ISO-10303-21;\n")
        done = run("cover", step, "-o", self.folder / "x.vtu")
        self.assertEqual(done.returncode, 4)
        self.assertTrue(done.stderr.startswith(f"veritope: {step}: byte 0: this is a STEP file"), done.stderr)
        self.assertEqual(run("cover", model, "--sweep", 0, "--json", "/dev/full").stderr,
                         "veritope: /dev/full: cannot be written: No space left on device\n")
        self.model([])
        self.assertEqual(run("cover", model, "-o", self.folder / "x.vtu").stderr,
                         f"veritope: {model}: there is no surface and no triangle in this file\n")

    def test_wrong_usage_is_found_before_any_work(self):
        model = self.model()
        for words in (["cover", model], ["cover", model, "-o", "x.png"], ["cover", model, "-o", model], ["cover", model, "-o", "-"],
                      ["cover", model, "-o", "x.vtu", "--what", "all"], ["cover", model, "--sweep", "21"],
                      ["cover", model, "--sweep", "1", "--eps", "0"], ["cover", model, "--sweep", "1", "--what", "boxes"],
                      ["cover", model, "-o", "x.vtu", "--eps", "1"], ["cover", model, "-o", "x.vtu", "--json", "-"],
                      ["cover", model, "--sweep", "1", "--json", model], ["cover", model, "--sweep", "1", "-o", "x.png"]):
            self.assertEqual(run(*words, cwd=self.folder).returncode, 2, words)
        self.assertEqual(run("cover", self.folder / "none.vjson", "-o", self.folder / "x.vtu").returncode, 4)


if __name__ == "__main__":
    unittest.main()
