# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope certify on IRIT's .itd: models written by convert and by hand, both checkers, what is not covered, real files."""
import hashlib
import json
import math
import os
import re
import subprocess
import sys
import unittest
from fractions import Fraction

from certify_patches_test import UNIT, block, document, surface
from support import BIN, CHECKER_PY, DATA, INVALID, ROOT, VALID, Folder, run

sys.path.insert(0, str(ROOT / "verify" / "checker"))
from veritope_checker.patches import star_box_itd as itd, star_box_read as read  # noqa: E402

COVERED = {"irit__ai_b58", "irit__ai_wiggl", "irit__ih_alpha", "irit__il_dish", "irit__ir1eggs", "irit__ir2eggs", "irit__ir_b58", "irit__ir_eggs",
           "irit__ir_tpot1", "irit__ir_tpot3", "irit__ir_wiggl", "irit__pl_saddl"}   # surfaces only; all of them are open

# polygons only
POLYGONS = {"irit__ir_cube": "VALID", "irit__pl_cncyl": "INVALID", "irit__pl_sold3": "INVALID"}
# by their boundary faces, some of which are cut differently on both sides of a wall; the last one has a volume that folds
VOLUMES = {"iritprim__ns_cone_rational": "VALID", "iritprim__ns_cylinder_rational": "VALID", "iritprim__ns_sphere_rational": "VALID",
           "iritprim__ns_cylinder_poly": "INVALID", "iritprim__ns_sphere_poly": "INVALID"}


def bezier(net):
    """A bilinear surface of four points, (u, v) = (0, 0), (0, 1), (1, 0), (1, 1)."""
    return "[SURFACE BEZIER 2 2 E3 %s]" % " ".join("[%s %s %s]" % tuple(net[i]) for i in (0, 2, 1, 3))


def polygons(faces, clockwise=True):
    """Squares of four points, as bezier() takes them, seen from outside: IRIT's turn clockwise."""
    order = (0, 1, 3, 2) if clockwise else (0, 2, 3, 1)
    corners = [" ".join("[[RGB \"1,2\"] %s %s %s]" % tuple(net[i]) for i in order) for net in faces]
    return "[OBJECT CUBE\n%s\n]" % "\n".join("[POLYGON [PLANE 0 0 1 0] 4 %s]" % c for c in corners)


def ring(n, around, up=1.0):
    """A polynomial torus: one biquadratic surface that closes on itself along both axes; decimals of six digits. up = -1: inside out."""
    points = []
    for j in range(around):
        for i in range(n):
            a, b = 2 * math.pi * i / n, 2 * math.pi * j / around
            r = 3 + math.cos(b)
            points.append("[%.6f %.6f %.6f]" % (r * math.cos(a), r * math.sin(a), up * math.sin(b)))
    knots = " ".join("[KVP %s]" % " ".join(map(str, range(k + 5))) for k in (n, around))
    return "[SURFACE BSPLINE %d %d 3 3 E3 %s\n%s]\n" % (n, around, knots, "\n".join(points))


class CertifyItd(Folder):
    def certify(self, text, *options, name="model.itd"):
        path = self.folder / name
        path.write_text(text)
        done = run("certify", path, "--json", "-", *options)
        (one,) = json.loads(done.stdout)["files"]
        self.assertEqual(done.returncode, one["exit"])
        return one

    def valid(self, text, *options):
        """VALID, and both checkers accept the certificate that is kept."""
        kept = self.folder / "model.cert"
        one = self.certify(text, "--certificate", kept, *options)
        self.assertEqual((one["verdict"], one["format"], one["certificate"] and one["certificate"]["checked"]), ("VALID", "itd", True), one["error"])
        for program in ([BIN / "veritope-check"], [sys.executable, CHECKER_PY]):
            done = subprocess.run([*program, self.folder / "model.itd", kept], capture_output=True, text=True, timeout=300)
            self.assertTrue(done.stdout.startswith("ACCEPT star-box-1"), done)
        return one

    def not_valid(self, one, word=""):
        """INVALID, or undecided with a sentence."""
        if one["verdict"] != "INVALID":
            self.assertEqual((one["verdict"], one["reasons"][-1]["code"]), ("UNDECIDED", "not-certified"))
            self.assertIn(word, one["reasons"][-1]["message"])

    def test_what_convert_writes_is_certified_like_its_source(self):
        models = {"cube": UNIT, "cavity": block((0, 0, 0), (4, 4, 4)) + block((1, 1, 1), (2, 2, 2), inward=True)}
        for name, faces in models.items():
            source, target = self.folder / (name + ".vjson"), self.folder / (name + ".itd")
            source.write_text(document([surface(f) for f in faces]))
            self.assertEqual(run("convert", source, target).returncode, 0)
            expected = json.loads(run("certify", source, "--json", "-").stdout)["files"][0]
            one = self.valid(target.read_text())
            for key in ("verdict", "counts", "shells", "volume"):
                self.assertEqual(one[key], expected[key], (name, key))

    def test_objects_attributes_bases_and_kinds(self):
        faces = [bezier(f) for f in UNIT]
        faces[1] = faces[1].replace("SURFACE BEZIER", "MULTIVAR BEZIER 2")
        faces[2] = faces[2].replace("BEZIER 2 2", "BSPLINE [rgb \"1,2\"] 2 2 2 2").replace("E3", "E3 [KV 0 0 1 1] [KV 0 0 1 1]")
        o, b, c, d = UNIT[3]                                                       # the same face as powers of u and v
        powers = [o, [x - y for x, y in zip(c, o)], [x - y for x, y in zip(b, o)], [w - x - y + z for w, x, y, z in zip(d, b, c, o)]]
        faces[3] = "[SURFACE POWER 2 2 E3 %s]" % " ".join("[%g %g %g]" % tuple(p) for p in powers)
        text = "A cube\n[OBJECT [color 4] CUBE [OBJECT [MATRIX 2 0 0 0] SIDES %s] %s [NUMBER 3]]\nthe end" % (" ".join(faces[:4]), "\n".join(faces[4:]))
        one = self.valid(text)
        self.assertEqual((one["counts"]["entities"], one["counts"]["edges"], one["counts"]["vertices"]), (6, 12, 8))
        self.assertTrue(one["volume"]["lo"] <= 1 <= one["volume"]["hi"])            # the matrix moves nothing

    def test_a_periodic_surface_closes_on_itself(self):
        one = self.valid(ring(6, 5))
        self.assertEqual((one["counts"]["entities"], one["counts"]["patches"], [s["genus"] for s in one["shells"]]), (1, 30, [1]))
        self.not_valid(self.certify(ring(6, 5, up=-1.0)))

    def test_orient_auto_reverses_entities_of_an_itd_file(self):
        faces = [list(f) for f in UNIT]
        faces[2] = [faces[2][0], faces[2][2], faces[2][1], faces[2][3]]
        self.assertEqual(self.valid("\n".join(map(bezier, faces)), "--orient", "auto")["flipped"], [2])

    def test_what_is_no_solid_says_where(self):
        self.not_valid(self.certify("".join(map(bezier, UNIT[:5]))), "open-side")
        touching = UNIT + block((1, 0.25, 0.25), (2, 0.75, 0.75))
        self.not_valid(self.certify("".join(map(bezier, touching))))

    def test_what_is_not_covered_is_named(self):
        cube = "".join(map(bezier, UNIT))
        for other, word in (("[POLYGON 3 [0 0 0] [1 0 0] [0 1 0]]", "polygons"), ("[CURVE BEZIER 2 E3 [0 0 0] [1 0 0]]", "curve"),
                            ("[TRIVAR BEZIER 2 2 2 E3 %s]" % ("[0 0 0]" * 8), "1 volume and other shapes"), ("[OBJECT A [INSTANCE B]]", "instances"),
                            ("[SURFACE BEZIER 2 2 E2 [0 0] [1 0] [0 1] [1 1]]", "1 patch of the plane")):
            one = self.certify(cube + other)
            self.assertEqual((one["verdict"], one["exit"], one["error"]["code"]), ("UNDECIDED", 3, "not-covered"), other)
            self.assertIn(word, one["error"]["message"])

    def with_a_plane(self):
        """The unit cube as model.g2, its lid a plane, which the checkers do not read."""
        g2, cube = self.folder / "model.g2", self.folder / "cube.itd"
        cube.write_text("".join(map(bezier, [face for face in UNIT if any(point[2] == 0 for point in face)])))
        self.assertEqual(run("convert", cube, g2).returncode, 0)
        g2.write_text(g2.read_text() + "250 1 0 0 3 0 0 1 0 0 1 1 0 0 1 0 1 0 1 0\n")
        return g2

    def test_a_g2_file_of_surfaces_is_certified_as_it_stands(self):
        g2, cube = self.folder / "model.g2", self.folder / "cube.itd"
        cube.write_text("".join(map(bezier, UNIT)))
        self.assertEqual(run("convert", cube, g2).returncode, 0)
        (one,) = json.loads(run("certify", g2, "--json", "-", "--certificate", self.folder / "model.g2.cert").stdout)["files"]
        self.assertEqual((one["verdict"], one["copy"], one["by_boundary_faces"]), ("VALID", None, False))
        self.assertFalse((self.folder / "model.g2.cert.vjson").exists())
        for program in ([BIN / "veritope-check"], [sys.executable, CHECKER_PY]):
            done = subprocess.run([*program, g2, self.folder / "model.g2.cert"], capture_output=True, text=True, timeout=300)
            self.assertTrue(done.stdout.startswith("ACCEPT star-box-1"), done)

    def test_of_another_format_a_copy_is_certified_and_kept_beside_the_certificate(self):
        g2 = self.with_a_plane()
        (one,) = json.loads(run("certify", g2, "--json", "-", "--certificate", self.folder / "model.g2.cert").stdout)["files"]
        copy = self.folder / "model.g2.cert.vjson"
        self.assertEqual((one["verdict"], one["format"], one["copy"]["what"], one["copy"]["of_volumes"]), ("VALID", "g2", "its 6 surfaces", False))
        self.assertEqual((one["copy"]["path"], one["copy"]["bytes"]), (str(copy), copy.stat().st_size))
        self.assertEqual(one["copy"]["sha256"], hashlib.sha256(copy.read_bytes()).hexdigest())
        self.assertEqual(one["sha256"], hashlib.sha256(g2.read_bytes()).hexdigest())
        for program in ([BIN / "veritope-check"], [sys.executable, CHECKER_PY]):
            done = subprocess.run([*program, copy, self.folder / "model.g2.cert"], capture_output=True, text=True, timeout=300)
            self.assertTrue(done.stdout.startswith("ACCEPT star-box-1"), done)
        self.assertIn("certified    its 6 surfaces, as .vjson", run("certify", g2).stdout)

    def test_copies_beside_their_certificates_are_left_out_of_folders_and_counted(self):
        self.with_a_plane()
        (self.folder / "cube.itd").unlink()
        (self.folder / "kept").mkdir()
        (self.folder / "kept" / "p.itd").write_text(polygons(UNIT))
        before = run("certify", "-q", self.folder)
        self.assertEqual((before.returncode, before.stdout.splitlines()[-1]), (0, "2 files: 2 valid"))
        for name in ("model.g2", "kept/p.itd"):
            self.assertEqual(run("certify", "-q", self.folder / name, "--certificate", f"{self.folder / name}.cert").returncode, 0)
        copies = [self.folder / "model.g2.cert.vjson", self.folder / "kept" / "p.itd.cert.off"]
        self.assertTrue(all(path.exists() for path in copies))
        words = "2 copies beside their certificates were left out\n"
        after = run("certify", "-q", self.folder)
        self.assertEqual((after.returncode, after.stdout), (0, before.stdout + words))
        done = run("certify", "--tsv", "-", self.folder)
        self.assertEqual((len(done.stdout.splitlines()), done.stderr), (3, "veritope: " + words))
        alone = run("certify", "-q", "--glob", "*.vjson", self.folder).stdout     # nothing else in that run has its verdict
        self.assertTrue(alone.startswith("VALID") and "left out" not in alone, alone)
        self.assertEqual(run("certify", "-q", *copies).stdout.splitlines()[-1], "2 files: 2 valid", "files that are named are certified")
        # A name alone says nothing: the certificate must be one, and speak of exactly these bytes.
        copies[0].write_text(copies[0].read_text() + " ")
        for name in ("n", "m", "o"):
            (self.folder / f"{name}.cert.off").write_bytes(VALID.read_bytes())
        (self.folder / "m.cert").write_text("no certificate\n")
        os.mkfifo(self.folder / "o.cert")
        done = run("certify", "-q", self.folder)
        self.assertEqual(done.stdout.splitlines()[-2:], ["6 files: 6 valid", "1 copy beside its certificate was left out"])

    def test_no_model_is_left_out_because_a_certificate_lies_beside_it(self):
        """An invalid model under the name of a copy, with its own certificate."""
        (self.folder / "mine.cert.off").write_bytes(INVALID.read_bytes())
        run("certify", "-q", INVALID, "--certificate", self.folder / "mine.cert")
        (self.folder / "good.off").write_bytes(VALID.read_bytes())
        done = run("certify", "-q", self.folder)
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (1, "2 files: 1 valid, 1 invalid"))

    def test_polygons_are_a_mesh_and_a_copy_of_it_is_certified(self):
        path, kept = self.folder / "model.itd", self.folder / "model.cert"
        one = self.certify(polygons(UNIT), "--certificate", kept)
        self.assertEqual((one["verdict"], one["format"], one["variant"], one["certificate"]["checked"]), ("VALID", "itd", "itd", True))
        self.assertEqual((one["counts"]["faces"], one["counts"]["vertices"], one["counts"]["polygons_split"], one["volume"]["exact"]), (12, 8, 6, "1/1"))
        copy = self.folder / "model.cert.off"
        self.assertEqual(one["copy"], {"path": str(copy), "sha256": hashlib.sha256(copy.read_bytes()).hexdigest(),
                                       "bytes": copy.stat().st_size, "what": "its 6 polygons", "of_volumes": False})
        self.assertEqual((one["sha256"], one["bytes"]), (hashlib.sha256(path.read_bytes()).hexdigest(), path.stat().st_size))
        for program in ([BIN / "veritope-check"], [sys.executable, CHECKER_PY]):
            done = subprocess.run([*program, copy, kept], capture_output=True, text=True, timeout=300)
            self.assertTrue(done.stdout.startswith("ACCEPT mesh-valid-1"), done)
        text = " ".join(run("certify", path).stdout.split())
        self.assertIn("certified its 6 polygons, as .off (--certificate F keeps it, too)", text)
        self.assertIn("file itd, ", text)

    def test_polygons_that_turn_the_other_way_are_inside_out(self):
        path = self.folder / "model.itd"
        path.write_text(polygons(UNIT, clockwise=False))
        (one,) = json.loads(run("certify", path, "--json", "-").stdout)["files"]
        self.assertEqual((one["verdict"], one["rules"]["M8"], one["valid_once_reversed"]), ("INVALID", 1, True))
        kept = self.folder / "model.cert"
        (one,) = json.loads(run("certify", "--orient", "auto", path, "--json", "-", "--certificate", kept).stdout)["files"]
        self.assertEqual((one["verdict"], one["reversed"]["faces"], one["certificate"]["checked"]), ("VALID", 12, True))
        for program in ([BIN / "veritope-check"], [sys.executable, CHECKER_PY]):
            done = subprocess.run([*program, self.folder / "model.cert.off", kept], capture_output=True, text=True, timeout=300)
            self.assertTrue(done.stdout.startswith("ACCEPT mesh-reversed-1"), done)

    def test_other_commands_take_polygons_as_a_mesh(self):
        path = self.folder / "model.itd"
        path.write_text(polygons(UNIT))
        (one,) = json.loads(run("info", path, "--json", "-").stdout)["files"]
        self.assertEqual((one["format"], one["variant"], one["counts"]["faces"], one["bbox"]["max"]), ("itd", "itd", 12, [1, 1, 1]))
        done = run("convert", path, self.folder / "model.obj")
        self.assertEqual(done.returncode, 0, done)
        self.assertIn("6 polygons cut into triangles", done.stdout)
        self.assertIn("volume 1", run("certify", self.folder / "model.obj").stdout)
        for name in ("model.png", "model.ply"):
            done = run("certify", path, "--picture", self.folder / name)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done)
            self.assertTrue((self.folder / name).stat().st_size > 100)
        done = run("intersect", path, path)
        self.assertIn(done.returncode, (1, 2, 4), done)                             # a file without surfaces
        self.assertNotIn("bug", done.stderr)
        done = run("certify", "--format", "itd", "-", "--picture", self.folder / "model.png", input=polygons(UNIT))
        self.assertEqual((done.returncode, done.stdout[:5]), (0, "VALID"), done)

    def test_a_broken_polygon_is_refused_with_its_line(self):
        for polygon, word in (("[POLYGON 2 [0 0 0] [1 0 0]]", "a polygon with 2 corners"), ("[POLYGON 3 [0 0 0] [1 0 0] [0 1 x]]", "'x'"),
                              ("[POLYGON 3 [0 0 0] [1 0 0] [0 1e400 0]]", "not finite")):
            one = self.certify("[OBJECT A\n" + polygon + "]")
            self.assertEqual((one["verdict"], one["exit"], one["error"]["line"]), ("UNREADABLE", 4, 2))
            self.assertIn(word, one["error"]["message"])

    def test_a_copy_never_replaces_another_file_of_the_run_and_needs_a_place(self):
        g2, cube = self.with_a_plane(), self.folder / "cube.itd"
        taken = self.folder / "model.g2.cert.vjson"
        self.assertEqual(run("convert", cube, taken).returncode, 0)
        before = taken.read_bytes()
        for arguments in ((taken, g2, "--certificate", self.folder), (g2, "--certificate", self.folder / "a", "--json", self.folder / "a.vjson")):
            done = run("certify", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done)
        self.assertEqual(taken.read_bytes(), before)
        (one,) = json.loads(run("certify", g2, "--certificate", "/dev/null", "--json", "-").stdout)["files"]
        self.assertEqual((one["verdict"], one["exit"], one["copy"]["path"]), ("VALID", 0, None))

    def test_volumes_are_certified_as_the_cells_of_a_v_model(self):
        net = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        one = self.certify("[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%d %d %d]" % p for p in net))
        self.assertEqual((one["verdict"], one["copy"], one["by_boundary_faces"], one["regular"], one["singular"]), ("VALID", None, False, True, []))
        self.assertEqual((one["counts"]["cells"], one["counts"]["v_points"], one["volume"]["exact"]), (1, 8, "1/1"))
        text = run("certify", self.folder / "model.itd").stdout
        self.assertIn("1 cell, 1 body, genus 0, volume about 1 (checked)", text)
        self.assertIn("  cells        1 cell, 6 V-surfaces (0 internal), 12 V-curves, 8 V-points\n", text)
        loose = "[TRIVAR BSPLINE 2 2 2 2 2 2 E3 [KV -1 0 1 1.5] [KV 0 0 1 1] [KV 0 0 1 1] %s]" % "".join("[%d %d %d]" % p for p in net)
        one = self.certify(loose)
        self.assertEqual((one["verdict"], one["copy"]["what"], one["copy"]["of_volumes"], one["by_boundary_faces"]),
                         ("VALID", "its 1 volume", False, False))

    def test_a_fold_between_the_points_that_are_tried_is_found_by_the_signs_of_the_determinant(self):
        """det J is (u - 1/5)(u - 3/10) up to a factor: negative between these, where no corner and no middle lies."""
        net = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 6, -13, 43)]
        one = self.certify("[TRIVAR BEZIER 4 2 2 E3 %s]" % "".join("[%d %d %d]" % p for p in net))
        self.assertEqual((one["verdict"], one["certificate"]["checked"]), ("INVALID", True))
        (defect,) = one["defects"]
        positive, negative = [Fraction(place["parameters"][0]) for place in defect["fold"]["places"]]
        self.assertEqual(defect["code"], "folded")
        self.assertLess((negative - Fraction(1, 5)) * (negative - Fraction(3, 10)), 0)
        self.assertGreater((positive - Fraction(1, 5)) * (positive - Fraction(3, 10)), 0)

    def test_cells_that_may_be_torn_are_not_valid_by_their_faces(self):
        """Along u a double knot of degree 1; the middle is pulled through the wall w = 0."""
        row = ((0, 0), (1, 1), (1, 2), (2, 3))
        net = [(x, y, z) for z in (0, 1) for y in (0, 1) for x, _ in row]
        torn = "[TRIVAR BSPLINE 4 2 2 2 2 2 E3 [KV 0 0 1 1 2 2] [KV 0 0 1 1] [KV 0 0 1 1] %s]" % "".join("[%d %d %d]" % p for p in net)
        one = self.certify(torn)
        self.assertEqual((one["verdict"], one["error"]["code"], one["by_boundary_faces"]), ("UNDECIDED", "not-covered", False))
        self.assertIn("the boundary faces bound a solid", one["error"]["message"])

    def test_cells_are_glued_across_inner_knots_of_one_of_them(self):
        """A bar cut by a knot beside one without it: the reading rule of faces does not glue them."""
        bar = "[TRIVAR BSPLINE 2 3 2 2 2 2 E3 [KV 0 0 1 1] [KV 0 0 1 2 2] [KV 0 0 1 1] %s]" % "".join(
            "[%d %d %d]" % p for p in [(x, y, z) for z in (0, 1) for y in (0, 1, 2) for x in (1, 2)])
        whole = "[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%d %d %d]" % p for p in [(x, y, z) for z in (0, 1) for y in (0, 2) for x in (0, 1)])
        one = self.certify(bar + whole)
        self.assertEqual((one["verdict"], one["counts"]["internal"], one["counts"]["pieces"], one["volume"]["exact"]), ("VALID", 1, 4, "4/1"))
        (self.folder / "p.txt").write_text("1 1 1/2\n1 1 0\n3 0 0\n2 1 1/2\n")
        done = run("classify", self.folder / "model.itd", self.folder / "p.txt")
        self.assertEqual((done.returncode, [line.split()[3] for line in done.stdout.splitlines()]), (0, ["in", "on", "out", "on"]), done)

    def test_a_collar_of_volumes_is_one_of_their_boundary_faces(self):
        net = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        one = self.certify("[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%d %d %d]" % p for p in net), "--collar")
        self.assertEqual((one["verdict"], one["copy"], one["by_boundary_faces"], one["collar"]["found"]), ("VALID", None, True, True))
        text = run("certify", "--collar", self.folder / "model.itd").stdout
        self.assertIn("volume about 1, by boundary faces (checked)", text)
        self.assertIn("certified    the 6 boundary faces of its 1 volume, not their cells", text)

    def test_a_cell_that_is_collapsed_onto_its_axis_is_valid_and_not_regular(self):
        """A quarter of a cylinder's sector: u = 0 is the axis."""
        net = [(0, 0, z) if u == 0 else p for z in (0, 1) for p, u in (((1, 0, z), 0), ((1, 0, z), 1), ((0, 1, z), 0), ((0, 1, z), 1))]
        one = self.certify("[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%d %d %d]" % p for p in net))
        self.assertEqual((one["verdict"], one["regular"]), ("VALID", False))
        self.assertEqual(one["singular"], [{"cell": 0, "box": [["0/1", "0/1"], ["0/1", "1/1"], ["0/1", "1/1"]], "kind": "curve"}])
        self.assertIn("curve of cell 0: u = 0, v in [0, 1], w in [0, 1]", run("certify", self.folder / "model.itd").stdout)

    def test_no_report_about_volumes_names_an_option_without_effect(self):
        inner = "".join("[%s %s %s]" % (x, y, z) for z in (.25, .75) for y in (.25, .75) for x in (.25, .75))
        (self.folder / "nested.itd").write_text(box(0) + "\n[TRIVAR BEZIER 2 2 2 E3 %s]" % inner)
        for options in ([], ["--orient", "auto"]):
            text = run("certify", *options, self.folder / "nested.itd").stdout
            self.assertIn("  what helps   veritope explain overlap\n", text)
            self.assertNotIn("--orient", text)

    def test_reports_about_a_copy_name_the_volumes(self):
        """Two bars that cross, one of which is certified by a copy: its six faces are cut into ten pieces there."""
        loose = ("[TRIVAR BSPLINE 3 2 2 2 2 2 E3 [KV 2 3 5 7 9] [KV 0 0 1 1] [KV 0 0 1 1] %s]"
                 % "".join("[%d %d %d]" % (x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 2, 4)))
        pin = "[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%s %s %s]" % (x, y, z) for z in (.5, 3) for y in (.25, .75) for x in (2.5, 3.5))
        one = self.certify(loose + pin, "--collar", "--picture", self.folder / "p.vtu")
        (defect,) = one["defects"]
        self.assertEqual((one["verdict"], one["copy"]["what"], defect["code"]), ("INVALID", "the 16 boundary faces of its 2 volumes", "patches-crossing"))
        self.assertEqual(sorted(part["entity"] for part in defect["parts"]), [0, 1])
        for part in defect["parts"]:
            self.assertIn(f"of entity {part['entity']}", defect["message"])
            u, v, w = part["parameters"]
            if part["entity"] == 0:  # the upper face, in its second span
                self.assertEqual((part["face"], w["lo"], w["hi"], 5 <= u["lo"] <= u["hi"] <= 7), (5, 1, 1, True))
        # The picture marks the pieces that cross.
        names = (self.folder / "p.vtu").read_text()
        self.assertIn("patches-crossing", bytes(int(n) for n in re.search(r'Name="parts"[^>]*>([^<]*)<', names).group(1).split()).decode())

    def test_volumes_of_too_high_a_degree_are_refused_at_once(self):
        """Its faces would take exact arithmetic a minute."""
        points = "".join("[%s %s %s]" % (i + j * k / 3, j + i * k / 7, k + i * j / 5) for k in range(40) for j in range(40) for i in range(40))
        (self.folder / "high.itd").write_text("%s\n[TRIVAR BEZIER 40 40 40 E3 %s]" % (box(0), points))
        text = "entity 1: the volume has the degree 39 along u, and certificates are about %s of a degree of at most 15"
        done = run("certify", self.folder / "high.itd")
        self.assertEqual((done.returncode, text % "volumes" in " ".join(done.stdout.split())), (3, True), done)
        done = run("cover", self.folder / "high.itd", "-o", self.folder / "x.vtu")
        self.assertEqual((done.returncode, text % "patches" in done.stderr), (4, True), done)

    def test_volumes_that_fold_are_invalid_with_both_places(self):
        net = [(x, y, z) if (x, y, z) != (1, 1, 1) else (.5, .5, .5) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        one = self.certify("[TRIVAR BEZIER 2 2 2 E3 %s]" % "".join("[%s %s %s]" % p for p in net))
        self.assertEqual((one["verdict"], one["exit"], one["copy"], one["by_boundary_faces"], one["certificate"]["checked"]), ("INVALID", 1, None, False, True))
        (defect,) = one["defects"]
        self.assertEqual((defect["code"], defect["cells"]), ("folded", [0, 0]))
        self.assertEqual([place["determinant"] for place in defect["fold"]["places"]], [1, -1])
        self.assertEqual([place["parameters"] for place in defect["fold"]["places"]], defect["parameters"])
        for place in defect["fold"]["places"]:          # (u, v, w) - u v w / 2 (1, 1, 1): the corner is halved
            u, v, w = map(Fraction, place["parameters"])
            self.assertEqual([Fraction(x) for x in place["point"]], [t - u * v * w / 2 for t in (u, v, w)])
            self.assertEqual(place["determinant"], 1 if 1 - (v * w + u * w + u * v) / 2 > 0 else -1)
        text = run("certify", self.folder / "model.itd").stdout
        self.assertIn("entity 0: the volume folds: its map keeps the orientation of space at (", text.split("\n")[0])

    def test_a_volume_of_gismo_that_folds_is_invalid_by_a_copy_of_the_volumes(self):
        axis = "<Basis type='BSplineBasis' index='%d'><KnotVector degree='1'>0 0 1 1</KnotVector></Basis>"
        points = "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 0.5 0.5 0.5"
        part, certificate = self.folder / "part.xml", self.folder / "part.cert"
        part.write_text("<xml><Geometry type='TensorBSpline3' id='0'><Basis type='TensorBSplineBasis3'>%s</Basis><coefs geoDim='3'>%s</coefs></Geometry></xml>"
                        % ("".join(axis % i for i in range(3)), points))
        done = run("certify", part, "--certificate", certificate, "--json", "-")
        (one,) = json.loads(done.stdout)["files"]
        self.assertEqual((one["verdict"], [d["code"] for d in one["defects"]]), ("INVALID", ["folded"]), done)
        self.assertEqual((one["copy"]["what"], one["copy"]["of_volumes"], one["copy"]["path"]), ("its 1 volume", False, str(certificate) + ".vjson"))
        for checker in ((BIN / "veritope-check",), (sys.executable, CHECKER_PY)):
            checked = subprocess.run([*checker, str(certificate) + ".vjson", certificate], capture_output=True, text=True, check=False)
            self.assertEqual((checked.returncode, checked.stdout[:22]), (0, "ACCEPT volume-folded-1"), checked)

    def test_what_is_malformed_is_refused_with_its_line(self):
        cube = "\n".join(map(bezier, UNIT))
        cases = {cube[:-1]: "truncated", cube.replace("[0 1 1]", "[0 1 x]", 1): "syntax", cube.replace("2 2", "2 3", 1): "syntax", "no group": "syntax",
                 "[OBJECT NONE]": "empty", cube.replace("[1 1 0]", "[1 1 nan]", 1): "not-finite", cube + "[COLOR 4]": "syntax"}
        for text, code in cases.items():
            one = self.certify(text)
            self.assertEqual((one["verdict"], one["exit"], one["error"]["code"]), ("UNREADABLE", 4, code), text[-60:])

    def test_the_name_may_say_nothing(self):
        cube = "".join(map(bezier, UNIT))
        self.assertEqual(self.certify(cube, "--format", "itd", name="cube.txt")["verdict"], "VALID")
        done = run("certify", "--format", "itd", "-", input=cube)
        self.assertEqual((done.returncode, done.stdout[:5]), (0, "VALID"), done)


def box(x, left_handed=False):
    """The box from (x, 0, 0) to (x + 1, 1, 1) as a volume."""
    corners = [(i, j, k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    corners = [(x + j, i, k) if left_handed else (x + i, j, k) for i, j, k in corners]
    return "[TRIVAR BEZIER 2 2 2 E3 %s]" % " ".join("[%d %d %d]" % c for c in corners)


class Faces(Folder):
    """convert --faces, then certify."""

    def convert(self, text, *options, to="faces.itd"):
        (self.folder / "volumes.itd").write_text(text)
        return run("convert", "--faces", *options, self.folder / "volumes.itd", self.folder / to)

    def test_boxes_in_a_row_are_one_solid(self):
        done = self.convert(box(0) + box(1, left_handed=True) + box(2))
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in ("14 entities", "the inside of 3 volumes", "1 volume", "left-handed"):
            self.assertIn(words, done.stdout)
        (one,) = json.loads(run("certify", self.folder / "faces.itd", "--json", "-").stdout)["files"]
        self.assertEqual((one["verdict"], one["counts"]["bodies"]), ("VALID", 1))
        self.assertTrue(one["volume"]["lo"] <= 3 <= one["volume"]["hi"])

    def test_a_gap_of_one_digit_is_no_wall(self):
        done = self.convert(box(0) + box(1).replace("[1 0 0]", "[1.00000001 0 0]"))
        self.assertEqual((done.returncode, "12 entities" in done.stdout), (0, True), done)
        self.assertNotEqual(run("certify", self.folder / "faces.itd").returncode, 0)

    def test_what_else_there_is_is_lost(self):
        text = box(0) + bezier(UNIT[0])
        done = self.convert(text)
        self.assertEqual((done.returncode, "1 entity besides the volumes" in done.stderr), (1, True), done)
        self.assertEqual(self.convert(text, "--lossy").returncode, 0)
        self.assertEqual(self.convert(bezier(UNIT[0])).returncode, 4)              # no volume at all
        (self.folder / "mesh.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assertEqual(run("convert", "--faces", self.folder / "mesh.off", self.folder / "x.stl").returncode, 2)


@unittest.skipUnless((DATA / "cad").is_dir(), "no real .itd files (VERITOPE_DATA)")
class RealFiles(Folder):
    def test_each_has_a_verdict_and_nothing_open_is_valid(self):
        for path in sorted((DATA / "cad").glob("*.itd")):
            options = ("--orient", "auto") if path.stem in VOLUMES else ()      # cells of several are left-handed
            done = run("certify", path, "--json", "-", *options)
            (one,) = json.loads(done.stdout)["files"]
            if path.stem == "iritprim__ns_cone_rational":                        # cell 4 is flat
                self.assertEqual([(d["code"], d["cells"]) for d in one["defects"]], [("flat", [4])])
                continue
            if one["verdict"] in ("VALID", "INVALID"):
                self.assertEqual(one["verdict"], "INVALID" if path.stem in COVERED else {**VOLUMES, **POLYGONS}[path.stem], path.name)
                is_folded = {defect.get("code") for defect in one["defects"]} == {"folded"}
                self.assertEqual(is_folded, path.stem == "iritprim__ns_sphere_poly", path.name)
                continue
            expected = "not-certified" if path.stem in COVERED else "bad-spline" if path.stem.startswith("bad__") else "not-covered"
            code = one["reasons"][-1]["code"] if one["verdict"] == "UNDECIDED" else one["error"]["code"]
            self.assertEqual((code, done.returncode), (expected, 4 if expected == "bad-spline" else 3), path.name)

    def test_faces_of_real_volumes(self):
        """IRIT's and MFEM's balls, cylinders, cubes: VALID with the genus and volume that they have."""
        expected = {"iritprim__ns_sphere_rational.itd": (0, 4 * math.pi / 3), "iritprim__ns_cylinder_rational.itd": (0, 2 * math.pi),
                    "iritprim__ns_cone_rational.itd": (0, 2 * math.pi / 3),
                    "mfem__ball-nurbs.mesh": (0, 4 * math.pi / 3), "mfem__two-cubes-nurbs-rot.mesh": (0, 2), "gismo__fichera.xml": (0, 7),
                    "gismo__cylinder.xml": (1, 3 * math.pi)}
        for name, (genus, volume) in expected.items():
            faces = self.folder / "faces.vjson"
            self.assertEqual(run("convert", "--faces", DATA / "cad" / name, faces).returncode, 0, name)
            (one,) = json.loads(run("certify", faces, "--json", "-").stdout)["files"]
            self.assertEqual((one["verdict"], [s["genus"] for s in one["shells"]]), ("VALID", [genus]), name)
            self.assertAlmostEqual((one["volume"]["lo"] + one["volume"]["hi"]) / 2, volume, delta=1e-3, msg=name)

    def test_the_python_checker_reads_what_the_kernel_reads(self):
        for name in sorted(COVERED):
            path, converted = DATA / "cad" / (name + ".itd"), self.folder / "model.vjson"
            self.assertEqual(run("convert", path, converted).returncode, 0)
            pairs = list(zip(itd.Reader(path.read_bytes()).model(), read.read_model(converted.read_bytes()), strict=True))
            self.assertTrue(pairs)
            for mine, kernels in pairs:
                for key in ("kind", "degrees", "knots", "rational", "dimension"):
                    self.assertEqual(getattr(mine, key), getattr(kernels, key), (name, key))
                self.assertEqual(*[[list(map(list, row)) for row in e.rows] for e in (mine, kernels)], name)


if __name__ == "__main__":
    unittest.main()
