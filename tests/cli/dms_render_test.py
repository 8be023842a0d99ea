#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope render of simplex-spline solids: pixels beside exact values of dms eval and dms xray, sizes, refusals, bytes."""
import json
import math
import re
import unittest
from fractions import Fraction as F

import schema
from dms_test import DOMAIN, TETRAHEDRON
from render_test import WHITE, RenderCase, pixels
from support import MODELS, ROOT, run

STOPS = [(68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37)]


def map_colour(share):
    place = min(max(share, 0), 1) * 4
    first = min(int(place), 3)
    return tuple(a + (b - a) * (place - first) for a, b in zip(STOPS[first], STOPS[first + 1]))


def exact_ray(rays, i, j):
    """The two ends of the ray of a pixel, of which the report has the numbers exactly."""
    row = {key: [F(x) for x in rays[key]] for key in rays}
    begin = [o + i * r + j * d for o, r, d in zip(row["origin"], row["right"], row["down"])]
    return begin, [b + a for b, a in zip(begin, row["along"])]


class DmsPicture(RenderCase):
    def setUp(self):
        super().setUp()
        domain = json.loads(DOMAIN.read_text())
        domain["attributes"] = ["density"]
        for control, value in zip(domain["control"], ["1", "3", "0", "1/2", "2"]):
            control["value"].append(value)
        self.write("domain.vdms", domain)
        self.assertEqual(run("dms", "make", "domain.vdms", "-o", "m.vdms", "--degree", 2, "--clouds", "1/10:3", cwd=self.folder).returncode, 0)

    def write(self, name, model):
        (self.folder / name).write_text(json.dumps(model))

    def picture(self, *arguments, model="m.vdms"):
        """(report, width, height, rows of pixels)"""
        report = json.loads(self.render(model, "-o", "p.png", "--json", "-", *arguments))
        self.assertEqual(schema.faults(report), [])
        return report, *pixels(self.folder / "p.png")


class Xray(DmsPicture):
    def means(self, ends, model="m.vdms"):
        lines = "".join(" ".join(map(str, p + q)) + "\n" for p, q in ends)
        done = run("dms", "xray", model, "-", "--attribute", "density", "--json", "-", input=lines, cwd=self.folder)
        return [F(s["mean"]) for s in json.loads(done.stdout)["segments"]]

    def test_pixels_are_exact_intensities(self):
        for view, more in (("-5,8,-5", []), ("0,0,-1", ["--absorption", "2"]), ("1,0,0", [])):
            report, width, height, rows = self.picture("--mode", "xray", "--attribute", "density", f"--view={view}", "--size", "80,64", *more)
            self.assertEqual((width, height), (80, 64))
            dms = report["dms"]
            places = [(i, j) for i in range(5, 80, 9) for j in range(3, 64, 7)]
            length = math.hypot(*dms["rays"]["along"])
            self.assertLess(dms["error"], 1e-5)
            seen = set()
            for (i, j), mean in zip(places, self.means([exact_ray(dms["rays"], i, j) for i, j in places])):
                level = 255 * math.exp(-dms["absorption"] * float(mean) * length)
                grey = set(rows[j][i])
                self.assertEqual(len(grey), 1)
                self.assertLessEqual(abs(grey.pop() - level), 0.5 + 1e-3, (view, i, j))
                seen.add(round(level))
            self.assertGreater(len(seen), 8, "the picture is not flat")
            self.assertIn(255, seen)
        self.assertEqual({p for p in rows[0]}, {WHITE}, "the margin")

    def test_the_darkest_pixel_shows_a_twentieth_of_the_light(self):
        report, _, _, rows = self.picture("--mode", "xray", "--attribute", "density")
        self.assertEqual(report["picture"]["width"], 256)
        self.assertEqual(min(p[0] for row in rows for p in row), round(255 * math.exp(-3)))

    def test_the_picture_shows_one_changed_coefficient_only_where_its_basis_function_is(self):
        model = json.loads((self.folder / "m.vdms").read_text())
        changed = model["control"][0]
        changed["value"][3] = "-7"
        self.write("n.vdms", model)
        arguments = ("--mode", "xray", "--attribute", "density", "--size", "64,64", "--absorption", "1")
        before, after = (self.picture(*arguments, model=name)[3] for name in ("m.vdms", "n.vdms"))
        pairs = [(p, q) for a, b in zip(before, after) for p, q in zip(a, b)]
        self.assertTrue(all(q[0] >= p[0] for p, q in pairs), "less absorbs less")
        self.assertTrue(any(q[0] > p[0] for p, q in pairs))
        self.assertTrue(any(p == q != WHITE for p, q in pairs))


class Slice(DmsPicture):
    def check(self, report, rows, model="m.vdms", step=5):
        dms, n = report["dms"], 0
        places = [(i, j) for j in range(2, len(rows), step) for i in range(2, len(rows[0]), step)]
        points = [exact_ray(dms["rays"], i, j)[0] for i, j in places]
        done = run("dms", "eval", model, "-", "--exact", "--json", "-", input="".join(" ".join(map(str, p)) + "\n" for p in points), cwd=self.folder)
        low, high = dms["range"]
        for (i, j), point in zip(places, json.loads(done.stdout)["points"]):
            if point["exact"] is None:
                self.assertEqual(rows[j][i], WHITE)
                continue
            n += 1
            want = map_colour((float(F(point["exact"][3])) - low) / (high - low))
            self.assertLessEqual(max(abs(c - w) for c, w in zip(rows[j][i], want)), 0.5 + 1e-6, (i, j))
        self.assertGreater(n, 10)

    def test_pixels_have_the_colours_of_exact_values(self):
        for arguments in ([], ["--plane", "0,0,1,1/8"], ["--plane=1,2,-1,1/3", "--range=-1,2"], ["--view", "0,1,0"]):
            report, _, _, rows = self.picture("--mode", "slice", "--attribute", "density", "--size", "90,70", *arguments)
            self.check(report, rows)
            if arguments[-1:] == ["--range=-1,2"]:
                self.assertEqual(report["dms"]["range"], [-1, 2])

    def test_a_side_of_the_domain_across_an_axis_is_seen(self):
        report, _, _, rows = self.picture("--mode", "slice", "--attribute", "density", "--size", "90,90", "--plane", "0,0,1,0")
        self.check(report, rows)
        shown = sum(p != WHITE for row in rows for p in row)
        self.assertLess(abs(shown - (90 * 15 / 16)**2 / 2), 2 * 90, "half of the square that fills the room")

    def test_points_of_the_picture_are_in_the_plane(self):
        report, *_ = self.picture("--mode", "slice", "--attribute", "density", "--size", "90,70", "--plane=1,2,-1,1/3")
        for i, j in ((0, 0), (89, 0), (45, 69)):
            x, y, z = exact_ray(report["dms"]["rays"], i, j)[0]
            self.assertLess(abs(x + 2 * y - z - F(1, 3)), 1e-14)

    def test_isolines_part_the_bands(self):
        arguments = ("--mode", "slice", "--attribute", "density", "--size", "120,120", "--plane", "0,0,1,1/8")
        report, _, _, plain = self.picture(*arguments)
        _, _, _, lined = self.picture(*arguments, "--isolines", 3)
        dark = (30, 30, 30)
        count = 0
        for before, after in zip(plain, lined):
            for p, q in zip(before, after):
                if tuple(q) == dark:
                    count += 1
                    self.assertNotEqual(p, WHITE)
                else:
                    self.assertEqual(p, q)
        self.assertTrue(60 < count < 120 * 3 * 3, count)

    def test_a_plane_beside_the_domain_shows_nothing(self):
        self.assertIn("no pixel shows a point of the domain", self.render("m.vdms", "-o", "x.png", "--mode", "slice", "--attribute", "density", "--plane", "0,0,1,3", status=4))
        self.assertFalse((self.folder / "x.png").exists())


class Volume(DmsPicture):
    def test_black_that_absorbs_as_the_attribute_says_is_an_x_ray(self):
        """The transfer function is linear from 0 on, so that the exact light is that of eq. 12."""
        _, _, _, rays = self.picture("--mode", "xray", "--attribute", "density", "--size", "64,64", "--absorption", "1")
        report, _, _, volume = self.picture("--mode", "volume", "--attribute", "density", "--size", "64,64", "--transfer", "0:0,0,0,0;4:0,0,0,4")
        self.assertTrue(0 < report["dms"]["step"] <= math.sqrt(3) / 200)
        levels = [(p[0], q[0]) for a, b in zip(rays, volume) for p, q in zip(a, b)]
        differences = [abs(p - q) for p, q in levels]
        self.assertLessEqual(sum(d > 1 for d in differences), 64, "rays that meet the domain for less than a step")
        self.assertLessEqual(max(differences), 255 * 3 * report["dms"]["step"])
        self.assertLess(min(p for p, _ in levels), 200)

    def test_what_is_opaque_shows_its_colour_and_a_finer_step_changes_little(self):
        arguments = ("--mode", "volume", "--attribute", "density", "--size", "64,64", "--transfer=-9:10,20,30,1e6")
        _, _, _, rows = self.picture(*arguments)
        flat = [tuple(p) for row in rows for p in row]
        self.assertGreater(flat.count((10, 20, 30)), 300)
        coarse, fine = (self.picture("--mode", "volume", "--attribute", "density", "--size", "64,64", "--step", step)[3] for step in ("0.02", "0.0025"))
        worse = sum(max(abs(a - b) for a, b in zip(x, y)) > 4 for p, q in zip(coarse, fine) for x, y in zip(p, q))
        self.assertLessEqual(worse, 40, "rays that meet the domain for less than a step")

    def test_values_without_extinction_do_not_show(self):
        _, _, _, rows = self.picture("--mode", "volume", "--attribute", "density", "--size", "64,64", "--transfer", "5:0,0,0,0;6:0,0,0,9")
        self.assertEqual({p for row in rows for p in row}, {WHITE})


def triangles_of(path):
    """The triangles of an .obj, as points."""
    rows = [line.split() for line in path.read_text().splitlines()]
    points = [tuple(map(float, row[1:4])) for row in rows if row[0] == "v"]
    return [[points[int(i) - 1] for i in row[1:]] for row in rows if row[0] == "f"]


class Surface(DmsPicture):
    def bent(self):
        """A model with one knot a vertex whose image is bent upward: z + x^2 / 2 at the control points."""
        self.assertEqual(run("dms", "make", "domain.vdms", "-o", "c.vdms", "--degree", 2, cwd=self.folder).returncode, 0)
        model = json.loads((self.folder / "c.vdms").read_text())
        for control in model["control"]:
            control["value"][2] = str(F(control["value"][2]) + F(control["value"][0])**2 / 2)
        self.write("bent.vdms", model)
        return model

    def test_the_boundary_is_that_of_the_solid_or_of_the_domain(self):
        self.bent()
        for space, top in ((), 0.5), (("--space", "solid"), 0.5), (("--space", "domain"), 0):
            self.render("bent.vdms", "-o", "b.obj", *space)
            triangles = triangles_of(self.folder / "b.obj")
            at_x = [p[2] for t in triangles for p in t if p[0] == 1]
            self.assertTrue(at_x and abs(min(at_x) - top) < 0.05, (space, min(at_x)))
            volume = sum(x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]) for x, y, z in triangles) / 6
            self.assertAlmostEqual(volume, 1 / 6, delta=1e-3, msg="the map moves columns along z, and faces point outward")

    def test_colours_are_those_of_the_attribute(self):
        """Seen along an axis, a side of the domain is a slice."""
        report, _, _, rows = self.picture("--attribute", "density", "--size", "100,100", "--view", "0,0,1", "--space", "domain", "--range", "0,4")
        self.assertEqual((report["dms"]["mode"], report["dms"]["range"], report["dms"]["rays"]), ("boundary", [0, 4], None))
        hues = {p for row in rows for p in row}
        self.assertGreater(len(hues), 100)
        _, _, _, plain = self.picture("--size", "100,100", "--view", "0,0,1", "--space", "domain")
        self.assertLess(len({p for row in plain for p in row}), 40)

    def test_level_sets_are_those_of_dms_iso(self):
        model = self.bent()
        model["attributes"] = ["z"]
        for control in model["control"]:
            control["value"][3] = str(F(control["value"][2]) - F(control["value"][0])**2 / 2)
        self.write("flat.vdms", model)
        report, _, _, rows = self.picture("--mode", "iso", "--attribute", "z", "--level", "1/3", "--size", "100,80", model="flat.vdms")
        self.assertEqual((report["dms"]["mode"], report["dms"]["certified"], report["dms"]["attribute"]), ("iso", True, "z"))
        self.assertTrue(any(p[0] > p[2] + 60 for row in rows for p in row), "an orange surface")
        self.render("flat.vdms", "-o", "i.obj", "--mode", "iso", "--attribute", "z", "--level", "1/3", "--space", "domain")
        text = (self.folder / "i.obj").read_text()
        self.assertEqual(re.findall(r"(?m)^g (\S+)", text), ["level", "boundary"])
        (self.folder / "l.obj").write_text(text[:text.index("g boundary")])
        level = triangles_of(self.folder / "l.obj")
        self.assertGreater(len(level), 20)
        self.assertLess(max(abs(p[2] - 1 / 3) for t in level for p in t), 1e-15)
        area = sum((a[0] * b[1] - a[1] * b[0] + b[0] * c[1] - b[1] * c[0] + c[0] * a[1] - c[1] * a[0]) / 2 for a, b, c in level)
        self.assertAlmostEqual(abs(area), (2 / 3)**2 / 2, delta=1e-14)

    def test_a_level_that_is_not_certified_is_drawn_with_status_3(self):
        self.bent()
        done = run("render", "bent.vdms", "-o", "v.png", "--mode", "iso", "--attribute", "density", "--level", 1, "--size", "64,64", cwd=self.folder)
        self.assertEqual(done.returncode, 3, done)
        self.assertIn("the topology of the surface is not certified", re.sub(r"\s+", " ", done.stderr))
        self.assertTrue((self.folder / "v.png").exists())

    def test_a_level_that_is_nowhere_leaves_the_boundary(self):
        report, _, _, rows = self.picture("--mode", "iso", "--attribute", "density", "--level", "9", "--size", "64,64")
        self.assertTrue(report["dms"]["certified"])
        self.assertGreater(len({p for row in rows for p in row}), 20)


class Page(DmsPicture):
    def test_the_page_shows_what_the_program_prints(self):
        (self.folder / "m.vdms").write_bytes(TETRAHEDRON.read_bytes())
        text = (ROOT / "docs" / "cli" / "render.md").read_text().split("## Simplex-spline solids")[1]
        commands = re.findall(r"(?m)^\$ veritope (.*)\n(.*)$", text.split("```")[1])
        self.assertEqual(len(commands), 5)
        for command, answer in commands:
            done = run(*command.split(), cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout.rstrip("\n")), (0, answer), command)

    def test_options_are_on_the_page(self):
        page = (ROOT / "docs" / "cli" / "render.md").read_text()
        for option in ("--mode", "--attribute", "--absorption", "--transfer", "--step", "--plane", "--range", "--isolines", "--level", "--within", "--space"):
            self.assertIn(f"| `{option} ", page)


class Scales(DmsPicture):
    """Domains that are huge, tiny or far from the origin: right pictures, or status 4 with the reason."""
    ISO = ("--mode", "iso", "--attribute", "a", "--level", "1/3", "--size", "64,64")

    def tetrahedron(self, side, at="0"):
        """A linear model, the identity, on which a falls from 1 to 0 along z and to 1/2 along x and y."""
        at, side = F(at), F(side)
        places = [[at + side * (m == axis) for axis in (1, 2, 3)] for m in range(4)]
        points = [list(map(str, p)) for p in places]
        control = [{"at": [m], "value": p + [a]} for m, (p, a) in enumerate(zip(points, ("1", "1/2", "1/2", "0")))]
        self.write("t.vdms", {"format": "veritope-dms-1", "degree": 1, "attributes": ["a"], "vertices": [[p] for p in points],
                              "tetrahedra": [[0, 1, 2, 3]], "control": control})

    def refused(self, *arguments):
        return " ".join(self.render("t.vdms", "-o", "x.png", *arguments, status=4).split())

    def test_coordinates_beyond_binary64_are_refused_with_the_reason(self):
        self.tetrahedron("1e400")
        self.assertIn("the domain has coordinates beyond binary64", self.refused("--mode", "slice", "--attribute", "a"))
        self.assertIn("a vertex of the surface is beyond binary64", self.refused(*self.ISO))
        self.assertIn("a vertex of the surface is beyond binary64", self.refused(*self.ISO, "--space", "domain"))
        self.assertFalse((self.folder / "x.png").exists())

    def test_level_sets_are_drawn_in_domains_of_every_size_in_binary64(self):
        pictures = []
        for side in "1", "1e160", "1.7e308", "1e-200", "1e-320":
            self.tetrahedron(side)
            for space in "solid", "domain":
                report, _, _, rows = self.picture(*self.ISO, "--space", space, model="t.vdms")
                self.assertTrue(report["dms"]["certified"], side)
                pictures.append(rows)
        orange = [[[p[0] > p[2] + 60 for p in row] for row in rows] for rows in pictures]
        self.assertGreater(sum(map(sum, orange[0])), 100)
        for side, other in enumerate(orange):
            unlike = sum(a != b for p, q in zip(orange[0], other) for a, b in zip(p, q))
            self.assertLess(unlike, 10, side)

    def test_vertices_that_rounding_moves_outside_have_the_images_of_their_places(self):
        self.tetrahedron("1e-14", at="1/3")
        self.picture(*self.ISO, "--within", "1e-13", model="t.vdms")
        for space in "solid", "domain":
            self.render("t.vdms", "-o", "i.obj", *self.ISO[:6], "--space", space)
            text = (self.folder / "i.obj").read_text()
            (self.folder / "l.obj").write_text(text[:text.index("g boundary")])
            level = triangles_of(self.folder / "l.obj")
            self.assertGreater(len(level), 100)
            for x, y, z in {p for t in level for p in t}:
                value = 1 - ((F(x) - F(1, 3)) / 2 + (F(y) - F(1, 3)) / 2 + F(z) - F(1, 3)) / F("1e-14")
                self.assertLess(abs(value - F(1, 3)), F(1, 20), "a unit in the last place changes it by up to 0.0056")


class Common(DmsPicture):
    MODES = [("--mode", "xray", "--attribute", "density"), ("--mode", "volume", "--attribute", "density"), ("--mode", "slice", "--attribute", "density", "--isolines", 4),
             ("--attribute", "density")]

    def test_bytes_do_not_depend_on_threads(self):
        for mode in self.MODES:
            for jobs in (1, 3):
                self.render("m.vdms", "-o", f"{jobs}.png", *mode, "--jobs", jobs, "--size", "70,65")
            self.assertEqual((self.folder / "1.png").read_bytes(), (self.folder / "3.png").read_bytes(), mode)

    def test_models_with_defects_are_refused(self):
        model = json.loads(TETRAHEDRON.read_text())
        model["vertices"][3].append(["0", "0", "-1"])
        self.write("bad.vdms", model)
        for mode in self.MODES:
            self.assertIn("bad.vdms: cloud-degenerate: tetrahedron 0, beta (0,0,0,1)", self.render("bad.vdms", "-o", "x.png", *mode, status=1))
        self.write("worse.vdms", {**model, "degree": 3})
        self.render("worse.vdms", "-o", "x.png", *self.MODES[0], status=4)
        self.assertFalse((self.folder / "x.png").exists())

    def test_volumes_and_slices_in_the_solid_need_a_certified_map(self):
        model = json.loads((self.folder / "m.vdms").read_text())
        for control in model["control"]:  # z' = z + x^2 / 4 at the control points
            control["value"][2] = str(F(control["value"][2]) + F(control["value"][0]) ** 2 / 4)
        self.write("bent.vdms", model)
        bounds = []
        for space in "domain", "solid":
            report, _, _, rows = self.picture("--mode", "slice", "--attribute", "density", "--space", space, "--plane", "0,1,0,1/4",
                                              "--size", "64,64", model="bent.vdms")
            self.assertEqual(report["dms"]["space"], space)
            bounds.append([float(F(x)) for x in report["bounds"]])
            self.assertGreater(len({p for row in rows for p in row} - {WHITE}), 20)
            # Where z is small and x near 1/2, the solid ends at x^2 / 4 at the control points, and the domain at 0.
            rays = {k: [F(x) for x in v] for k, v in report["dms"]["rays"].items()}
            at = [[float(rays["origin"][k] + i * rays["right"][k] + j * rays["down"][k]) for k in (0, 2)] for j in range(64) for i in range(64)]
            low = [rows[n // 64][n % 64] != WHITE for n, (x, z) in enumerate(at) if 0.4 < x < 0.6 and 0.005 < z < 0.025]
            self.assertGreater(len(low), 3)
            self.assertEqual(set(low), {space == "domain"})
        self.assertEqual(bounds[0], [0, 0, 0, 1, 1, 1])
        self.assertTrue(all(abs(a - b) < 0.3 for a, b in zip(*bounds)), bounds)
        self.picture("--mode", "volume", "--attribute", "density", "--space", "solid", "--size", "64,64", model="bent.vdms")
        folded = MODELS / "dms" / "folded.vdms"
        why = self.render(folded, "-o", "x.png", "--mode", "slice", "--attribute", "density", "--space", "solid", status=1)
        self.assertIn("a map that is proved to be one to one, and this model is INVALID", " ".join(why.split()))
        why = self.render("m.vdms", "-o", "x.png", "--mode", "xray", "--attribute", "density", "--space", "solid", status=2)
        self.assertIn("--space: pictures of mode xray are of the domain", " ".join(why.split()))
        self.assertFalse((self.folder / "x.png").exists())

    def test_factors_and_lengths_are_decimals_fractions_and_hexadecimal_numbers(self):
        for mode, option, key in (("xray", "--absorption", "absorption"), ("volume", "--step", "step")):
            found = [self.picture("--mode", mode, "--attribute", "density", "--size", "64,64", option, text)[0]["dms"][key]
                     for text in ("0.125", "1/8", "0x1p-3")]
            self.assertEqual(found[1:], found[:1] * 2)
            self.assertAlmostEqual(found[0], 0.125, delta=0.01)

    def test_wrong_options_are_named(self):
        (self.folder / "a.off").write_bytes((ROOT / "tests" / "models" / "m3_nearest_valid.off").read_bytes())
        xray = ("--mode", "xray", "--attribute", "density")
        for arguments, words in ((("m.vdms", "--mode", "xray"), "--attribute A is required with --mode"),
                                 (("m.vdms", "--mode", "xrays"), "--mode: must be"),
                                 (("m.vdms", *xray, "--plane", "1,0,0,0"), "--plane is not for this mode"),
                                 (("m.vdms", "--mode", "xray", "--attribute", "mass"), "the model has the attributes density"),
                                 (("a.off", *xray), "--mode is for simplex-spline solids, and a.off is none"),
                                 (("m.vdms", "--range", "0,1"), "--range needs --attribute"),
                                 (("m.vdms", "--isolines", "3"), "--isolines needs --mode"),
                                 (("m.vdms", *xray, "--absorption", "0"), "--absorption: must be a factor from 1e-300 to 1e300, not 0"),
                                 (("m.vdms", *xray, "--absorption", "1/0"), "--absorption: must be a factor from 1e-300 to 1e300, not 1/0"),
                                 (("m.vdms", "--mode", "volume", "--attribute", "density", "--step", "0x1p-1000"), "--step: must be a length from 1e-300 to 1e300"),
                                 (("m.vdms", *xray, "--grid", 3), "--grid is not for simplex-spline solids"),
                                 (("m.vdms", *xray, "--nets"), "--nets is not for simplex-spline solids"),
                                 (("m.vdms", *xray, "--size", "8192,8192"), "at most 16777216 pixels"),
                                 (("m.vdms", "--mode", "slice", "--attribute", "density", "--plane", "0,0,0,1"), "--plane: is no plane"),
                                 (("m.vdms", "--mode", "slice", "--attribute", "density", "--range", "1,1"), "--range: needs two numbers LO,HI"),
                                 (("m.vdms", "--mode", "volume", "--attribute", "density", "--transfer", "1:2,3"), "--transfer: needs nodes V:R,G,B,E"),
                                 (("m.vdms", "--mode", "volume", "--attribute", "density", "--transfer", "1:2,3,4,5;0:1,1,1,1"), "--transfer: has values that do not ascend"),
                                 (("m.vdms", "--mode", "volume", "--attribute", "density", "--transfer", "1:2,3,256,5"), "is not from 0 to 255"),
                                 (("m.vdms", "--mode", "volume", "--attribute", "density", "--transfer", "1:2,3,4,-5"), "has an extinction below 0")):
            self.assertIn(words, self.render(*arguments, "-o", "x.png", status=2), arguments)
        self.assertIn("a picture by --mode xray is a .png", self.render("m.vdms", *xray, "-o", "x.vtu", status=2))
        self.assertIn("at most 65536 steps", self.render("m.vdms", "--mode", "volume", "--attribute", "density", "--step", "1e-9", "-o", "x.png", status=4))


if __name__ == "__main__":
    unittest.main()
