# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope certify on spline files: verdicts, reports against their schema, certificates, what is not covered."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import schema
from support import ROOT, Folder, run


def block(low, high, inward=False):
    """Six bilinear faces; control points of (u, v) = (0, 0), (0, 1), (1, 0), (1, 1)."""
    faces = []
    for axis in range(3):
        for end in (0, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            if (end == 0) != inward:
                u, v = v, u
            net = []
            for at_u in (0, 1):
                for at_v in (0, 1):
                    p = [0, 0, 0]
                    p[axis], p[u], p[v] = (low, high)[end][axis], (low, high)[at_u][u], (low, high)[at_v][v]
                    net.append(p)
            faces.append(net)
    return faces


def surface(net, degrees=(1, 1), rational=False):
    knots = [["0"] * (n + 1) + ["1"] * (n + 1) for n in degrees]
    return {"kind": "surface", "group": None, "attributes": [],
            "shape": {"degrees": list(degrees), "periodic": [False, False], "knots": knots, "rational": rational,
                      "components": 4 if rational else 3, "points": [[str(c) for c in p] for p in net]}}


def elevated(net):
    """The net raised to degrees (3, 3)."""
    a, b, c, d = net
    return [[((3 - i) * (3 - j) * a[k] + (3 - i) * j * b[k] + i * (3 - j) * c[k] + i * j * d[k]) * Fraction(1, 9) for k in range(3)]
            for i in range(4) for j in range(4)]


def triangle(corners):
    return {"kind": "triangle", "group": None, "attributes": [],
            "shape": {"degree": 1, "rational": False, "components": 3, "points": [[str(c) for c in p] for p in corners]}}


def document(entities):
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities})


UNIT = block((0, 0, 0), (1, 1, 1))


class Models(unittest.TestCase):
    """docs/rules/patches.md says of each of them what it is."""
    FOLDER = ROOT / "tests" / "models" / "patches"

    def test_every_model_gets_the_answer_of_its_section(self):
        page = (ROOT / "docs" / "rules" / "patches.md").read_text()
        seen = set()
        for code, section in re.findall(r"(?ms)^## (\S+)\n(.*?)(?=^## |\Z)", page):
            for name, verdict in re.findall(r"\(../../tests/models/patches/(\S+)\) .*\| (\w+) \|$", section, re.M):
                seen.add(name)
                done = run("certify", self.FOLDER / name, "--json", "-")
                (one,) = json.loads(done.stdout)["files"]
                said = [d["code"] for d in one["defects"]] if one["verdict"] == "INVALID" else [one["error"]["code"]] if one["error"] else []
                with self.subTest(name, section=code):
                    self.assertEqual((one["verdict"], said), (verdict, [] if verdict == "VALID" else [code]))
                shown = run("certify", self.FOLDER / name).stdout
                self.assertEqual(f"veritope explain {code}\n" in shown, verdict != "VALID")
        self.assertEqual(seen, {path.name for path in self.FOLDER.iterdir()})

    def test_the_script_writes_them(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "tools" / "make_patch_models.py", folder], check=True)
            for path in self.FOLDER.iterdir():
                self.assertEqual(path.read_bytes(), (pathlib.Path(folder) / path.name).read_bytes())


class CertifyPatches(Folder):
    def file(self, entities, name="model.vjson"):
        path = self.folder / name
        path.write_text(document(entities))
        return path

    def certify(self, entities, *options):
        done = run("certify", self.file(entities), "--json", "-", *options)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        (one,) = report["files"]
        self.assertEqual(done.returncode, one["exit"])
        return one

    def test_a_cube_is_valid_with_its_volume_and_a_checked_certificate(self):
        one = self.certify([surface(f) for f in UNIT])
        self.assertEqual((one["verdict"], one["exit"]), ("VALID", 0))
        self.assertEqual([s["genus"] for s in one["shells"]], [0])
        self.assertLessEqual(one["volume"]["lo"], 1)
        self.assertGreaterEqual(one["volume"]["hi"], 1)
        self.assertLess(one["volume"]["hi"] - one["volume"]["lo"], 1e-12)
        self.assertTrue(one["certificate"]["checked"])
        counts = one["counts"]
        self.assertEqual((counts["patches"], counts["edges"], counts["vertices"], counts["bodies"]), (6, 12, 8, 1))

    def test_models_with_longer_numbers_than_certificates_hold_are_no_bug_of_ours(self):
        shift = Fraction(3 ** 6000, 7 ** 4000)
        long_points = [surface([[c + shift for c in p] for p in f]) for f in UNIT]
        tiny = [surface([[c * Fraction(1, 10 ** 2000) for c in p] for p in f]) for f in UNIT]
        long_knots = [surface(f) for f in UNIT]
        for entity in long_knots:
            entity["shape"]["knots"] = [["0", "0", str(shift), str(shift)]] * 2
        for entities in (long_points, long_points[1:], tiny, long_knots, long_knots[1:]):
            one = self.certify(entities)
            self.assertEqual((one["verdict"], one["exit"], one["certificate"]), ("UNDECIDED", 3, None))
            self.assertIn(one["error"]["code"], ("not-covered", "not-certified"))

    def test_numbers_that_only_wider_limits_read_are_not_covered(self):
        for option, text in (("--max-digits", "0." + "0" * 1200 + "1"), ("--max-exponent", "1e-5000")):
            cube = [surface(f) for f in UNIT]
            for entity in cube:
                entity["shape"]["points"] = [[text if c == "0" else c for c in p] for p in entity["shape"]["points"]]
            self.assertEqual(self.certify(cube)["exit"], 4)
            one = self.certify(cube, option, "6000")
            self.assertEqual((one["exit"], one["error"]["code"]), (3, "not-covered"))
            self.assertEqual(self.certify([surface(f) for f in UNIT], option, "6000")["verdict"], "VALID")
            with open(self.file(cube)) as file:
                done = run("certify", "-q", "--format", "vjson", option, "6000", "-", stdin=file)
            self.assertEqual(done.returncode, 3, done)

    def test_a_collar_that_is_asked_for_costs_models_far_away_nothing_else(self):
        for away in (10 ** 6, 10 ** 15):
            low = (away + Fraction(1, 3), Fraction(1, 7), 0)
            one = self.certify([surface(f) for f in block(low, [c + 1 for c in low])], "--collar")
            self.assertEqual((one["verdict"], one["collar"]["found"]), ("VALID", away < 10 ** 9))
            self.assertLess(one["volume"]["hi"] - one["volume"]["lo"], 1e-12)

    def test_a_place_or_a_volume_beyond_binary64_is_not_made_up(self):
        cube = [surface([[c * Fraction(10) ** 200 for c in p] for p in f]) for f in UNIT]
        one = self.certify(cube)
        self.assertEqual((one["verdict"], one["volume"]["hi"]), ("VALID", None))
        self.assertIn("volume at least 1.7", run("certify", "-q", self.folder / "model.vjson").stdout)
        beyond = [surface([[c * Fraction(10) ** 400 for c in p] for p in f]) for f in UNIT]
        one = self.certify(beyond[1:])
        message = one["defects"][0]["message"]
        self.assertEqual([side["length"] for side in one["open_sides"]], [None] * 4)
        self.assertIn("is an open border", message)
        self.assertNotIn("inf", message)
        steep = [surface([p + [1] for p in elevated(f)], (3, 3), True) for f in UNIT]
        for entity in steep:
            entity["shape"]["points"][5] = [str(Fraction(c) * 10 ** 100) for c in entity["shape"]["points"][5]]
        one = self.certify(steep)
        self.assertEqual(one["verdict"], "UNDECIDED")
        if one["place"]:
            self.assertTrue(all(c is not None for end in one["place"].values() for c in end), one["place"])

    def test_the_certificate_is_kept_and_both_checkers_accept_it(self):
        model, kept = self.file([surface(f) for f in UNIT]), self.folder / "model.cert"
        self.assertEqual(run("certify", model, "--certificate", kept).returncode, 0)
        for words in self.check(model, kept):
            self.assertTrue(words.startswith("ACCEPT star-box-1"), words)
        damaged = bytearray(kept.read_bytes())
        damaged[-1] ^= 1
        kept.write_bytes(damaged)
        for words in self.check(model, kept):
            self.assertTrue(words.startswith("REJECT S4"), words)

    def check(self, model, certificate):
        import subprocess
        import sys
        from support import BIN
        programs = [[BIN / "veritope-check"], [sys.executable, ROOT / "verify" / "checker" / "veritope_check.py"]]
        return [subprocess.run([*p, model, certificate], capture_output=True, text=True, timeout=120).stdout for p in programs]

    def test_triangles_make_a_tetrahedron(self):
        o, x, y, z = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
        one = self.certify([triangle(t) for t in ((o, y, x), (o, x, z), (o, z, y), (x, y, z))])
        self.assertEqual(one["verdict"], "VALID")
        self.assertLess(abs(one["volume"]["lo"] - 1 / 6), 1e-12)

    def test_a_cavity_is_a_shell_of_one_body(self):
        faces = block((0, 0, 0), (4, 4, 4)) + block((1, 1, 1), (2, 2, 2), inward=True)
        one = self.certify([surface(f) for f in faces])
        self.assertEqual(one["verdict"], "VALID")
        self.assertEqual((one["counts"]["shells"], one["counts"]["bodies"]), (2, 1))
        self.assertEqual([s["outward"] for s in one["shells"]], [True, False])

    def test_what_is_proved_wrong_is_invalid_and_says_where(self):
        moved = [list(map(list, f)) for f in UNIT]
        moved[5] = [[x, y, "4503599627370497/4503599627370496"] for x, y, _ in moved[5]]
        turned = list(UNIT)
        turned[2] = [turned[2][0], turned[2][2], turned[2][1], turned[2][3]]
        cases = {
            "side-open": UNIT[:5],
            "side-direction": turned,
            "side-overused": UNIT + block((1, 1, 0), (2, 2, 1)),
            "shell-turned": block((0, 0, 0), (1, 1, 1), inward=True),
            "patches-crossing": UNIT + block((0.5, 0.25, 0.25), (1.5, 0.75, 0.75)),
        }
        for code, faces in [*cases.items(), ("side-open", moved)]:
            with self.subTest(code):
                one = self.certify([surface(f) for f in faces], "--no-check")
                self.assertEqual((one["verdict"], one["exit"], one["error"]), ("INVALID", 1, None))
                (defect,) = one["defects"]
                self.assertEqual(defect["code"], code)
                self.assertIsNotNone(one["certificate"])
        self.assertEqual(self.certify([surface(f) for f in cases["shell-turned"]], "--no-check")["defects"][0]["winding"], 0)
        (crossing,) = self.certify([surface(f) for f in cases["patches-crossing"]], "--no-check")["defects"]
        x, y, z = crossing["point"]
        self.assertTrue(abs(x - 1) < 1e-4 and min(abs(y - 0.25), abs(y - 0.75), abs(z - 0.25), abs(z - 0.75)) < 1e-4)
        for low, value, high in zip(crossing["box"]["min"], (x, y, z), crossing["box"]["max"]):
            self.assertTrue(low - 1e-4 <= value <= high + 1e-4)
        done = run("certify", self.file([surface(f) for f in cases["side-open"]]), "--no-check")
        self.assertEqual(done.returncode, 1)
        self.assertIn("INVALID", done.stdout)
        self.assertIn("side-open", done.stdout)

    def test_the_option_that_helps_is_named_only_where_it_does(self):
        """Patches and shells that face the wrong way: the report names --orient auto, and with it the model is VALID."""
        turned = list(UNIT)
        turned[2] = [turned[2][0], turned[2][2], turned[2][1], turned[2][3]]
        crossing = block((0.5, 0.25, 0.25), (1.5, 0.75, 0.75))
        helps = "veritope certify --orient auto FILE reverses "
        for faces, code, what in ((turned, "side-direction", "patches so that their sides fit"),
                                  (block((0, 0, 0), (1, 1, 1), inward=True), "shell-turned", "whole shells that face the wrong way"),
                                  (turned[:5], "side-open", None), (turned + crossing, "side-direction", None),
                                  (UNIT + crossing, "patches-crossing", None)):
            path = self.file([surface(f) for f in faces])
            words = " ".join(run("certify", "--no-check", path).stdout.split())
            self.assertIn(f"what helps {helps}{what}; veritope explain {code} " if what else f"what helps veritope explain {code} ", words)
            self.assertEqual(run("certify", "--orient", "auto", path).returncode, 0 if what else 1, code)
        text = run("certify", "--no-check", "--orient", "auto", path).stdout
        self.assertTrue(text.startswith("INVALID") and "--orient" not in text, text)

    def test_the_ends_of_a_range_differ(self):
        """A surface whose parameter u takes 50 units in the last place."""
        narrow = surface(UNIT[5])
        narrow["shape"]["knots"][0] = ["3.8", "3.8", "3.80000000000001", "3.80000000000001"]
        text = run("certify", "--no-check", self.file([narrow])).stdout
        self.assertIn("u in [3.8, 3.80000000000001]", text)
        self.assertNotRegex(text, r"\[(\S+), \1\]")

    def test_parameters_are_those_of_the_entity(self):
        # The lower face as one surface of two spans over [0, 2] x [0, 1]; its neighbours are cut as it is.
        faces = [surface(f) for f in UNIT if any(p[2] == 1 for p in f)]
        wide = {"kind": "surface", "group": None, "attributes": [],
                "shape": {"degrees": [1, 1], "periodic": [False, False], "knots": [["0", "0", "1", "2", "2"], ["3", "3", "4", "4"]],
                          "rational": False, "components": 3,
                          "points": [["0", "0", "0"], ["1", "0", "0"], ["0", "1/2", "0"], ["1", "1/2", "0"], ["0", "1", "0"], ["1", "1", "0"]]}}
        one = self.certify([wide, *faces[:-1]], "--no-check")
        self.assertEqual(one["verdict"], "INVALID")
        for part in one["defects"][0]["parts"]:
            if part["entity"] == 0:
                (u, v) = part["parameters"]
                self.assertTrue(0 <= u["lo"] <= u["hi"] <= 2 and 3 <= v["lo"] <= v["hi"] <= 4)

    def test_crossings_of_reversed_entities_are_certified_too(self):
        for reversed_face in (0, 7):
            faces = [list(f) for f in UNIT + block((0.5, 0.25, 0.25), (1.5, 0.75, 0.75))]
            faces[reversed_face] = [faces[reversed_face][i] for i in (0, 2, 1, 3)]
            one = self.certify([surface(f) for f in faces], "--orient", "auto", "--no-check")
            self.assertEqual((one["verdict"], one["flipped"]), ("INVALID", [reversed_face]))
            self.assertEqual(one["defects"][0]["code"], "patches-crossing")

    def test_orient_auto_turns_single_patches_and_then_whole_shells(self):
        faces = block((0, 0, 0), (1, 1, 1), inward=True)
        faces[1] = [faces[1][i] for i in (0, 2, 1, 3)]
        one = self.certify([surface(f) for f in faces], "--orient", "auto")
        self.assertEqual((one["verdict"], one["flipped"]), ("VALID", [0, 2, 3, 4, 5]))

    def test_what_touches_is_invalid_with_both_places(self):
        """Face in face, edge in face, corner on corner, corner in edge; the point lies in both."""
        for other in (block((1, 0.25, 0.25), (2, 0.75, 0.75)), block((1, 1, 1), (2, 2, 2)), block((1, 0.25, 1), (2, 0.75, 2))):
            one = self.certify([surface(f) for f in UNIT + other])
            self.assertEqual((one["verdict"], one["exit"], one["certificate"]["checked"]), ("INVALID", 1, True))
            (defect,) = one["defects"]
            self.assertEqual(defect["code"], "patches-touching")
            self.assertEqual({part["entity"] < 6 for part in defect["parts"]}, {False, True})
            self.assertEqual(defect["point"][0], 1)
            self.assertTrue(all(0 <= x <= 2 for x in defect["point"]))

    def test_what_touches_in_an_irrational_place_is_undecided_there(self):
        one = self.certify(json.loads((ROOT / "tests/models/patches" / "not_certified_smallest.vjson").read_text())["entities"])
        self.assertEqual((one["verdict"], one["exit"]), ("UNDECIDED", 3))
        self.assertEqual((one["error"]["code"], one["defects"]), ("not-certified", []))
        self.assertIsNone(one["certificate"])
        self.assertAlmostEqual(one["place"]["min"][0], 0.5 ** 0.5, places=3)

    def test_sheets_that_are_near_each_other_are_named_with_both_patches_and_their_distance(self):
        above = block((0.25, 0.25, 1 + Fraction(1, 2 ** 70)), (0.75, 0.75, 2))
        self.assertEqual(self.certify([surface(f) for f in UNIT + above])["verdict"], "VALID")  # flat faces are taken whole
        one = self.certify(json.loads((ROOT / "tests/models/patches" / "not_certified_smallest.vjson").read_text())["entities"])
        self.assertEqual((one["verdict"], one["error"]["code"]), ("UNDECIDED", "not-certified"))
        (reason,) = one["reasons"]
        self.assertEqual(reason["message"], one["error"]["message"])
        self.assertRegex(reason["message"], r"two sheets (run approximately \S+ apart|meet) here.*; [0-9,]+ boxes tried")
        self.assertEqual({part["entity"] for part in reason["parts"]}, {5, 10})
        self.assertLess(reason["approximate_distance"], 1e-9)
        lid, floor = sorted(reason["parts"], key=lambda part: part["entity"])
        self.assertAlmostEqual(lid["parameters"][0]["lo"], 0.5 ** 0.5, places=3)  # u of the lid is x
        shown = run("certify", self.folder / "model.vjson").stdout
        self.assertIn("entity 5: u in [", shown)
        self.assertIn("entity 10: u in [", shown)

    def test_a_t_junction_is_named_with_the_place_of_the_missing_vertex_and_rejoined(self):
        third = Fraction(1, 3)
        halves = [[(0, 0, 1), (0, 1, 1), (third, 0, 1), (third, 1, 1)], [(third, 0, 1), (third, 1, 1), (1, 0, 1), (1, 1, 1)]]
        one = self.certify([surface(f) for f in UNIT[:5] + halves])
        self.assertEqual((one["verdict"], one["error"]["code"]), ("UNDECIDED", "side-t-junction"))
        named = [r for r in one["reasons"] if r["code"] == "side-t-junction"]
        self.assertEqual(len(named), 2)
        for reason in named:
            self.assertRegex(reason["message"], r"insert a vertex at \(u, v\) = \((0|1|1/3|2/3), (0|1|1/3|2/3)\) of entity [0-4]")
            self.assertAlmostEqual(reason["point"][0], 1 / 3)
        joined = self.folder / "joined.vjson"
        done = run("convert", "--rejoin", self.folder / "model.vjson", joined)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("(u, v) = (", done.stdout)
        self.assertNotIn("left:", done.stdout)
        self.assertTrue(run("certify", joined).stdout.startswith("VALID"))
        # .itd has no thirds: nothing is joined, and the model is not rounded either.
        refused = run("convert", "--rejoin", self.folder / "model.vjson", self.folder / "joined.itd")
        self.assertEqual(refused.returncode, 1)
        self.assertFalse((self.folder / "joined.itd").exists())
        again = run("convert", "--rejoin", joined, self.folder / "again.vjson")
        self.assertIn("nothing to join", again.stdout)

    def test_a_third_in_an_itd_file_is_left_alone_and_said(self):
        floor = [[(0, 1, 0), (0, 0, 0), (1, 1, 0), (1, 0, 0)], [(1, 1, 0), (1, 0, 0), (3, 1, 0), (3, 0, 0)]]
        model = [f for f in block((0, 0, 0), (3, 1, 1)) if any(p[2] != 0 for p in f)] + floor
        source = self.file([surface(f) for f in model])
        done = run("convert", "--rejoin", source, self.folder / "cut.itd")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("left: entity", done.stdout)
        self.assertIn("cannot be written exactly", done.stdout)
        self.assertNotIn("joined:", done.stdout)
        self.assertIn("joined:", run("convert", "--rejoin", source, self.folder / "cut.vjson").stdout)

    def test_a_copy_that_others_touch_is_refuted_and_named(self):
        for again in (UNIT[3], [UNIT[3][i] for i in (2, 0, 3, 1)], [UNIT[3][i] for i in (0, 2, 1, 3)]):
            one = self.certify([surface(f) for f in UNIT + [again]])
            self.assertEqual((one["verdict"], [d["code"] for d in one["defects"]]), ("INVALID", ["side-overused"]))
            self.assertIn("entity 6 is entity 3 again", one["defects"][0]["message"])
            self.assertTrue(one["certificate"]["checked"])

    def test_a_copy_that_is_all_alone_is_named_in_all_its_orders(self):
        a, b, c, d = UNIT[5]
        orders = [[a, b, c, d], [c, a, d, b], [d, c, b, a], [b, d, a, c]]
        for net in [*orders, *[[p, r, q, s] for p, q, r, s in orders]]:
            one = self.certify([surface([a, b, c, d]), surface(net)], "--orient", "auto")
            self.assertEqual((one["verdict"], [d["code"] for d in one["defects"]]), ("INVALID", ["patch-repeated"]))
            self.assertEqual([p["entity"] for p in one["defects"][0]["parts"]], [0, 1])
            self.assertTrue(one["certificate"]["checked"])

    def test_sides_that_agree_as_point_sets_only_are_undecided(self):
        halves = [[(0, 0, 1), (0, 1, 1), (0.5, 0, 1), (0.5, 1, 1)], [(0.5, 0, 1), (0.5, 1, 1), (1, 0, 1), (1, 1, 1)]]
        faces = [f for f in UNIT if any(p[2] != 1 for p in f)] + halves
        one = self.certify([surface(f) for f in faces])
        self.assertEqual((one["verdict"], one["error"]["code"]), ("UNDECIDED", "side-t-junction"))

    def test_orient_auto_reverses_what_does_not_fit_and_lists_it(self):
        faces = [list(f) for f in UNIT]
        faces[2] = [faces[2][0], faces[2][2], faces[2][1], faces[2][3]]
        self.assertEqual(self.certify([surface(f) for f in faces], "--no-check")["verdict"], "INVALID")
        one = self.certify([surface(f) for f in faces], "--orient", "auto")
        self.assertEqual((one["verdict"], one["flipped"]), ("VALID", [2]))
        self.assertTrue(one["certificate"]["checked"])

    def test_orient_auto_turns_whole_shells(self):
        turned = block((0, 0, 0), (1, 1, 1), inward=True)
        self.assertNotEqual(self.certify([surface(f) for f in turned])["verdict"], "VALID")
        one = self.certify([surface(f) for f in turned], "--orient", "auto")
        self.assertEqual((one["verdict"], one["flipped"]), ("VALID", list(range(6))))
        self.assertTrue(one["certificate"]["checked"])
        # A box in a box, both outward: the inner one becomes a cavity.
        inner = block((0.25, 0.25, 0.25), (0.5, 0.5, 0.75))
        one = self.certify([surface(f) for f in UNIT + inner], "--orient", "auto")
        self.assertEqual((one["verdict"], one["flipped"]), ("VALID", list(range(6, 12))))

    def test_tolerance_is_a_positive_length(self):
        self.assertEqual(self.certify([surface(f) for f in UNIT], "--tolerance", "1e-9")["verdict"], "VALID")
        for bad in ("0", "-1", "inf", "x"):
            self.assertEqual(run("certify", self.file([surface(UNIT[0])]), "--tolerance", bad).returncode, 2)

    def test_a_torn_surface_may_be_proved_valid_and_is_never_refuted(self):
        lid = surface([(x, y, 1) for x in (0, "1/2", "1/2", 1) for y in (0, 1)])
        lid["shape"]["knots"][0] = ["0", "0", "1/2", "1/2", "1", "1"]  # the inner knot twice, of degree 1: it may jump there
        sides = [surface(face) for face in UNIT if any(p[2] != 1 for p in face)]
        self.assertEqual(self.certify([lid, *sides])["verdict"], "VALID")
        one = self.certify([lid, *sides[1:]])
        self.assertEqual((one["verdict"], one["error"]["code"]), ("UNDECIDED", "knot-multiplicity"))
        self.assertIn("multiplicity above its degree: u = 1/2 of entity 0", one["error"]["message"])
        self.assertIn("though it does not", one["error"]["message"])

    def test_what_certificates_do_not_cover_is_named(self):
        curve = {"kind": "curve", "group": None, "attributes": [],
                 "shape": {"degrees": [1], "periodic": [False], "knots": [["0", "0", "1", "1"]], "rational": False,
                           "components": 3, "points": [["0", "0", "0"], ["1", "0", "0"]]}}
        one = self.certify([surface(UNIT[0]), curve])
        self.assertEqual((one["verdict"], one["error"]["code"]), ("UNDECIDED", "not-covered"))
        self.assertEqual(one["error"]["message"], "beside 1 surface the file has 1 curve: such shapes are no part of a boundary")
        self.assertEqual(self.certify([])["error"]["code"], "empty")


if __name__ == "__main__":
    unittest.main()
