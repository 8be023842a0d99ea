#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""figures.py VERITOPE PICTURES [FIGURE...]: the figures of [HHQ04] on models of our own.

Makes the models (make_models.py), edits and fits them, and draws them into the folder PICTURES. Prints what was found.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SIZE = ["--size", "600,450"]
SQUARE = ["--size", "300,300"]
ABOVE = "--view=-1,2,-3"
HARE = "--view=1,3,-1"


def polyline(points, weight="1", width=4):
    """High within 1 / sqrt(width) of the line: 1 / (1 + width s + (width s)^2), s the squared distance."""
    return {"polyline": [[str(x) for x in p] for p in points], "over": ["1"],
            "under": ["1", str(width), str(width**2)], "weight": weight}


class Figures:
    def __init__(self, program, folder, pictures):
        self.program, self.folder = pathlib.Path(program).resolve(), pathlib.Path(folder)
        self.pictures = pathlib.Path(pictures).resolve()
        self.pictures.mkdir(parents=True, exist_ok=True)
        subprocess.run([sys.executable, HERE / "make_models.py", folder], check=True)

    def run(self, *arguments, allowed=(0,)):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder,
                              check=False)
        if done.returncode not in allowed:
            sys.exit(f"{' '.join(map(str, arguments))}: status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def make(self, domain, model, degree, clouds="1/10:7"):
        self.run("dms", "make", domain, "-o", model, "--degree", degree, "--clouds", clouds)

    def edit(self, model, out, moves):
        (self.folder / "moves.json").write_text(json.dumps(moves))
        self.run("dms", "edit", model, "moves.json", "-o", out)

    def picture(self, name, model, *options, allowed=(0,)):
        said = self.run("render", model, "-o", self.pictures / f"{name}.png", *options, allowed=allowed)
        print(f"{name}: {said.strip()}", flush=True)

    def fit(self, data, domain, out, *options):
        where = ["--domain", domain] if domain else ["--auto"]
        report = json.loads(self.run("dms", "fit", data, "-o", out, *where, "--degree", 2, *options, "--json", "-",
                                     allowed=(0, 3)))
        print(f"{out}: {report['points']} points, {report['tetrahedra']} tetrahedra, "
              f"{report['control_points']} control points, mean square error {report['attribute_mse'][0]:.3g}, "
              f"greatest error {report['max_error']}", flush=True)

    def show(self, figure):
        getattr(self, f"figure{figure}")()

    # One cubic tetrahedron: moved control points; and one basis function of it, as an attribute.
    def figure1(self):
        self.make("one.vdms", "one3.vdms", 3)
        self.edit("one3.vdms", "one3_moved.vdms", [
            {"move": "control", "at": [0, 1, 2], "by": ["0", "0", "-1/2"]},
            {"move": "control", "at": [1, 2, 3], "by": ["1/3", "1/3", "1/3"]},
            {"move": "control", "at": [1, 1, 2], "by": ["1/4", "0", "-1/4"]},
            {"move": "control", "at": [3, 3, 3], "by": ["0", "0", "1/3"]}])
        self.picture("1a", "one3_moved.vdms", *SIZE)
        self.edit("one3.vdms", "basis.vdms",
                  [{"move": "coefficient", "at": [0, 1, 2], "attribute": "basis", "to": "1"}])
        self.picture("1_basis_volume", "basis.vdms", "--mode", "volume", "--attribute", "basis", "--transfer",
                     "0:68,1,84,0;0.05:59,82,139,1;0.1:33,145,140,4;0.15:94,201,98,20;0.2:253,231,37,60", *SQUARE)
        self.picture("1_basis_xray", "basis.vdms", "--mode", "xray", "--attribute", "basis", *SQUARE)
        self.picture("1_basis_slice", "basis.vdms", "--mode", "slice", "--attribute", "basis", "--plane", "0,0,1,1/10",
                     "--isolines", 9, *SIZE)

    # A torus with six corners, and the solid after control points were moved.
    def figure2(self):
        self.make("ring.vdms", "ring2.vdms", 2, "collapsed")
        self.picture("2a", "ring2.vdms", ABOVE, "--attribute", "height", *SIZE)
        lift = lambda *at: {"at": list(at), "by": ["0", "0", "3"]}
        self.edit("ring2.vdms", "ring_moved.vdms", [
            {"move": "lattice", "box": [["-6", "-5", "-1"], ["6", "5", "1"]], "degree": [2, 2, 1], "counts": [5, 4, 2],
             "nodes": [lift(i, j, k) for i in (0, 4) for j in range(4) for k in range(2)]}])
        self.picture("2b", "ring_moved.vdms", ABOVE, "--attribute", "height", *SIZE)

    # Five tori, bent together by a lattice.
    def figure3(self):
        self.make("five.vdms", "five2.vdms", 2, "collapsed")
        self.picture("3a", "five2.vdms", ABOVE, "--attribute", "along", *SIZE)
        self.edit("five2.vdms", "five_bent.vdms", [
            {"move": "lattice", "box": [["-3", "-3", "-1"], ["21", "6", "1"]], "degree": [2, 1, 1], "counts": [5, 2, 2],
             "nodes": [{"at": [i, j, k], "by": ["0", "0", str(z)]}
                       for i, z in ((0, 6), (2, -4), (4, 6)) for j in range(2) for k in range(2)]}])
        self.picture("3b", "five_bent.vdms", ABOVE, "--attribute", "along", *SIZE)

    # A conforming domain of a mesh, materials by skeletons: colours of a slice, and volume rendering.
    def figure4(self):
        part = HERE.parent / "sound_part.stl"
        self.run("dms", "domain", part, "-o", "part.vdms")
        document = self.attach("part.vdms", "material")
        self.make("part.vdms", "part2.vdms", 2, "collapsed")
        places = [[float_of(x) for x in cloud[0]] for cloud in document["vertices"]]
        low, high = ([f(p[k] for p in places) for k in range(3)] for f in (min, max))
        at = lambda *t: [str(round((l + s * (h - l)) * 1024)) + "/1024" for l, h, s in zip(low, high, t)]
        width = 20 / max(h - l for l, h in zip(low, high))**2
        steep = [str(round(width * 4096)) + "/4096", str(round(width**2 * 65536)) + "/65536"]
        self.edit("part2.vdms", "part_made.vdms", [{"move": "skeleton", "attribute": "material", "skeletons": [
            {"polyline": [at(0, 0, 0.5), at(1, 0, 0.5)], "over": ["1"], "under": ["1", *steep]},
            {"point": at(1, 1, 1), "over": ["1"], "under": ["1", *steep]}]}])
        self.picture("4b", "part_made.vdms", *SIZE)
        self.picture("4c", "part_made.vdms", "--attribute", "material", *SIZE)
        self.picture("4d", "part_made.vdms", "--mode", "volume", "--attribute", "material", *SQUARE)

    # Attributes of the torus: a half of its middle line, and a ball.
    def figure5(self):
        self.make("ring.vdms", "ring2.vdms", 2, "collapsed")
        axes = [["1/2", "0", "0"], ["0", "1/2", "0"], ["0", "0", "1/2"]]
        ball = {"ellipsoid": {"centre": ["-3", "-7/4", "0"], "axes": axes}, "over": ["2"], "under": ["1", "1", "1"]}
        self.edit("ring2.vdms", "ring_made.vdms", [{"move": "skeleton", "attribute": "density", "skeletons": [
            polyline([(4, 0, 0), (2, "7/2", 0), (-2, "7/2", 0)]), ball]}])
        self.picture("5a", "ring_made.vdms", "--mode", "volume", "--attribute", "density", ABOVE, "--transfer",
                     "0.02:59,82,139,0.08;0.2:59,82,139,0.1;0.5:94,201,98,1;1:253,231,37,9", *SQUARE)
        self.picture("5_xray", "ring_made.vdms", "--mode", "xray", "--attribute", "density", ABOVE, *SQUARE)
        self.picture("5_slice", "ring_made.vdms", "--mode", "slice", "--attribute", "density", "--plane", "0,0,1,0",
                     "--isolines", 9, *SIZE)
        self.picture("5b", "ring_made.vdms", "--mode", "iso", "--attribute", "density", "--level", "1/2",
                     "--within", "1/2", ABOVE, *SIZE, allowed=(0, 3))

    # An animal, the surface on which a sum of four ellipsoids is 1; its domain; a stomach and two pipes inside of it.
    def figure6(self):
        self.run("dms", "iso", "hare.vdms", "--attribute", "inside", "--level", 1, "--within", 4, "-o", "hare.off")
        self.shorten("hare.off")
        self.run("dms", "domain", "hare.off", "-o", "animal.vdms")
        self.picture("6b", "animal.vdms", HARE, *SIZE)
        self.attach("animal.vdms", "digestion")
        self.make("animal.vdms", "animal2.vdms", 2, "collapsed")
        axes = [["3", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
        stomach = {"ellipsoid": {"centre": ["8", "9", "7"], "axes": axes}, "over": ["1"], "under": ["1", "1", "1"]}
        pipes = [polyline(p, width=2) for p in ([(14, 9, 12), (12, 9, 10), (11, 9, 7)], [(5, 9, 7), (2, 9, 6)])]
        self.edit("animal2.vdms", "digesting.vdms", [
            {"move": "skeleton", "attribute": "digestion", "skeletons": [stomach, *pipes], "round": 40}])
        self.picture("6c", "digesting.vdms", "--mode", "volume", "--attribute", "digestion", HARE, "--transfer",
                     "0.05:59,82,139,0.02;0.3:59,82,139,0.05;0.6:94,201,98,0.5;1:253,231,37,3", *SQUARE)
        self.picture("6d", "digesting.vdms", "--mode", "slice", "--attribute", "digestion", "--plane", "0,1,0,9",
                     "--isolines", 9, *SIZE)

    def shorten(self, mesh):
        """Rounds coordinates to multiples of 2^-16: vertices in one plane of the cells stay in one plane."""
        head, counts, *lines = (self.folder / mesh).read_text().splitlines()
        for v in range(int(counts.split()[0])):
            lines[v] = " ".join(repr(round(2**16 * float(x)) / 2**16) for x in lines[v].split())
        (self.folder / mesh).write_text("\n".join([head, counts, *lines]) + "\n")

    def attach(self, model, attribute):
        """Gives a model of degree 1 one attribute, which is 0."""
        document = json.loads((self.folder / model).read_text())
        document["attributes"] = [attribute]
        for control in document["control"]:
            control["value"].append("0")
        (self.folder / model).write_text(json.dumps(document))
        return document

    # Data in a cube: the domain, fits with fixed and with free knots, and what they show.
    def figure7(self):
        self.fit("shell.txt", "cube.vdms", "shell.vdms", "--knots", "fixed", "--max-tetrahedra", 400)
        self.picture("7b", "shell.vdms", "--mode", "volume", "--attribute", "a", *SQUARE)
        self.picture("7_slice", "shell.vdms", "--mode", "slice", "--attribute", "a", "--plane", "0,0,1,1/2",
                     "--isolines", 9, *SIZE)

    def figure8(self):
        self.run("dms", "domain", "cross_points.txt", "-o", "hull.vdms", "--hull")
        self.picture("8b", "hull.vdms", *SIZE)
        self.run("dms", "domain", "cross_points.txt", "-o", "cross_domain.vdms")
        self.picture("8c", "cross_domain.vdms", *SIZE)

    # Feature lines of a scan, and the domain that a fit begins with.
    def figure9(self):
        report = json.loads(self.run("dms", "domain", "cross_points.txt", "-o", "cross_domain.vdms", "--json", "-"))
        places = [cloud[0] for cloud in json.loads((self.folder / "cross_domain.vdms").read_text())["vertices"]]
        curves = []
        for line in report["feature_lines"]:
            knots = [*map(str, [0, *range(len(line)), len(line) - 1])]
            curves.append({"kind": "curve", "group": 0, "attributes": [], "shape": {
                "degrees": [1], "periodic": [False], "knots": [knots], "rational": False, "components": 3,
                "points": [places[v] for v in line]}})
        document = {"format": "veritope-spline-1", "groups": [{"name": "lines", "parent": None, "attributes": []}],
                    "entities": curves}
        (self.folder / "features.vjson").write_text(json.dumps(document))
        self.picture("9a", "features.vjson", *SIZE)
        self.fit("cross_scan.txt", None, "scan.vdms")
        self.picture("9b", "scan.vdms", *SIZE)

    # Fits of data with a steep layer: control vectors only, and knots as well.
    def figure10(self):
        for name, knots in (("10a", "fixed"), ("10c", "free")):
            self.fit("shell.txt", "small_cube.vdms", f"{knots}.vdms", "--knots", knots)
            self.picture(name, f"{knots}.vdms", "--mode", "slice", "--attribute", "a", "--plane", "0,0,1,1/2",
                         "--isolines", 9, *SIZE)

    def figure12(self):
        self.fit("cross.txt", "bars.vdms", "cross.vdms", "--knots", "fixed", "--max-tetrahedra", 1200)
        self.picture("12b", "cross.vdms", "--mode", "volume", "--attribute", "a", *SQUARE)

    def figure11(self):
        self.fit("waves.txt", "cube.vdms", "waves.vdms", "--knots", "fixed", "--max-tetrahedra", 400)
        self.picture("11b", "waves.vdms", "--mode", "iso", "--attribute", "a", "--level", "1/2", "--within", "1/8",
                     *SIZE, allowed=(0, 3))

    # The isosurface before and after cells were cut.
    def figure13(self):
        self.make("one.vdms", "one2.vdms", 3, "collapsed")
        near = {"point": ["0", "0", "0"], "over": ["1"], "under": ["1", "8"]}
        self.edit("one2.vdms", "level.vdms", [
            {"move": "skeleton", "attribute": "basis", "skeletons": [near]},
            {"move": "coefficient", "at": [1, 2, 3], "attribute": "basis", "to": "2"}])
        for name, within in (("13a", "2"), ("13_half", "1/2"), ("13b", "1/8")):
            self.picture(name, "level.vdms", "--mode", "iso", "--attribute", "basis", "--level", "1/2",
                         "--within", within, *SIZE, allowed=(0, 3))


def float_of(text):
    over, _, under = text.partition("/")
    return float(over) / float(under or 1)


def main():
    program, pictures, *chosen = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        figures = Figures(program, folder, pictures)
        for figure in chosen or [name.removeprefix("figure") for name in dir(figures) if name.startswith("figure")]:
            figures.show(figure)


if __name__ == "__main__":
    main()
