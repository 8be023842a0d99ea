#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""figures.py VERITOPE [PICTURES [FIGURE...]]: the microstructures of the figures of [HPE22].

Makes the models (make_models.py), fills, filters and bridges, decides the results, and draws them into the folder
PICTURES. Prints what was found. Figure 6 needs the bunny: see table1.py.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
BUNNY = "mesh/solid1/thingiCSG__bunny_remap.off"
LENGTHWISE, ABOVE = "--view=-3,5,-3", "--view=-1,-2,6"
BOX = ["box", "--around", "cylinder.vjson", "--degrees", "3,3,3"]
EARS = ["split", "--at", "w=9/16", "--open", "v1", "--from", "27/32", "--low=0,0,-5", "--high", "0,0,5"]


class Figures:
    def __init__(self, program, folder, pictures):
        self.program, self.folder, self.pictures = program, pathlib.Path(folder), pictures
        subprocess.run([sys.executable, HERE / "make_models.py", folder], check=True)
        bunny = pathlib.Path(os.environ.get("VERITOPE_DATA", "/nowhere")) / BUNNY
        self.bunny = bunny if bunny.exists() else None

    def run(self, *arguments, allowed=(0,)):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder,
                              check=False)
        if done.returncode not in allowed:
            sys.exit(f"{' '.join(map(str, arguments))}: status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def picture(self, name, model, *options):
        if self.pictures:
            self.run("render", model, "-o", pathlib.Path(self.pictures).resolve() / f"{name}.png", *options)

    def cage(self, name, *steps):
        made = None
        for i, step in enumerate(steps):
            before = [] if made is None else ["--of", made]
            made = f"{name}_{i}.vjson"
            self.run("cage", *step, *before, "-o", made)
        return made

    def micro(self, name, cage, counts, *more, model=None, tile="jack"):
        """Writes NAME.vmicro, prints what it holds and what certify says of it."""
        solid = [] if model is None else ["--model", model]
        report = json.loads(self.run("micro", "--cage", cage, "--tile", tile, "--counts", counts, *solid,
                                     "-o", f"{name}.vmicro", "--json", "-", *more))
        tiles, bridges = report["tiles"], report["bridges"]
        text = f"{tiles['kept']} of {tiles['total']} tiles"
        if bridges:
            text += f", {bridges['built']} of {bridges['caps']} caps bridged"
        if tiles["kept"]:
            [file] = json.loads(self.run("certify", f"{name}.vmicro", *solid, "--json", "-",
                                         allowed=(0, 1, 3)))["files"]
            counts = file["counts"]
            text += f", {counts['components']} components, genus {counts['genus']}: {file['verdict']}"
            text += " and inside" if file["inside"] else ""
        print(f"{name}: {text}", flush=True)
        return report

    def show(self, figure):
        getattr(self, f"figure{figure}")()

    # A regular grid that the bone's surface cuts, and tiles that follow the bone.
    def figure1(self):
        box = self.cage("box", ["box", "--around", "bone.off", "--margin", "1/100"])
        report = self.micro("1_grid", box, "6,4,18", "--mesh", "grid.ply", "--chord", "0.02", tile="jack,degree=1")
        kept = self.micro("1_kept", box, "6,4,18", "--bridge", "none", model="bone.off", tile="jack,degree=1")
        self.run("boolean", "grid & bone", "grid=grid.ply", "bone=bone.off", "-o", "clipped.json")
        print(f"1_clipped: {kept['tiles']['crossing']} of {report['tiles']['total']} tiles are cut by the surface")
        self.picture("1_clipped", "clipped.json", LENGTHWISE)
        self.micro("1_conformal", "bone_c.vjson", "6,4,18", model="bone.off")
        self.picture("1_conformal", "1_conformal.vmicro", LENGTHWISE, "--around", "bone.off")

    # One tile: equal arms, and six different ones.
    def figure2(self):
        cube = self.cage("cube", ["box", "--min", "0,0,0", "--max", "1,1,1"])
        self.micro("2_a", cube, "1,1,1")
        self.micro("2_b", cube, "1,1,1", "--thickness", "1/10+u/20+v/12+w/15")
        for name in ("2_a", "2_b"):
            self.picture(name, f"{name}.vmicro", "--nets")

    # The steps of algorithm 1.
    def figure3(self):
        cage = self.cage("steps", BOX)
        self.micro("3_tiles", cage, "10,10,14", tile="jack,degree=1")
        self.micro("3_filtered", cage, "10,10,14", "--bridge", "none", model="cylinder.off", tile="jack,degree=1")
        self.micro("3_bridged", cage, "10,10,14", model="cylinder.off", tile="jack,degree=1")
        for name in ("3_tiles", "3_filtered", "3_bridged"):
            self.picture(name, f"{name}.vmicro", "--nets", "--around", "cylinder.off")

    def figure4(self):
        box, ring = self.cage("square", BOX), self.cage("radial", ["radial", "--around", "cylinder.vjson"])
        for name, cage, counts in (("4_a", box, "8,6,12"), ("4_b", box, "12,12,16"), ("4_c", ring, "6,24,16")):
            self.micro(name, cage, counts, model="cylinder.off")
            self.picture(name, f"{name}.vmicro", "--nets", "--around", "cylinder.off")

    def figure5(self):
        for name, counts in (("a", "8,5,37"), ("b", "8,6,40"), ("c", "8,7,40")):
            self.micro(f"5_{name}", f"bone_{name}.vjson", counts, model="bone.off")
            self.picture(f"5_{name}", f"5_{name}.vmicro", LENGTHWISE, "--nets", "--around", "bone.off")

    def figure6(self):
        if self.bunny is None:
            print("6: left out, no bunny")
            return
        box = ["box", "--around", self.bunny]
        hull = ["hull", "--around", self.bunny, "--spans", "8,8,8", "--margin", "1/40"]
        for name, steps, counts in (("6_a", [[*box, "--degrees", "3,3,3"]], "16,22,24"),
                                    ("6_b", [box, EARS], "18,20,13/18,20,11/18,4,13/18,4,11"),
                                    ("6_c", [hull], "18,24,24")):
            self.micro(name, self.cage(name, *steps), counts, model=self.bunny)
            self.picture(name, f"{name}.vmicro", ABOVE, "--nets", "--around", self.bunny)

    def figure7(self):
        box = self.cage("7_a", ["box", "--around", "duck.off"])
        hull = self.cage("7_b", ["hull", "--around", "duck.off", "--spans", "6,6,6"])
        for name, cage, counts in (("7_a", box, "11,11,21"), ("7_b", hull, "13,13,21")):
            self.micro(name, cage, counts, model="duck.off")
            self.picture(name, f"{name}.vmicro", "--view=-4,9,-3", "--nets", "--around", "duck.off")

    # Thin at the ball's centre, thin towards the cylinder's base, and waves.
    def figure8(self):
        cage = self.cage("graded", BOX)
        for name, formula in (("a", "1/16+min(1/8,sqrt(x^2+y^2+(z-12)^2)/50)"), ("b", "1/20+z/120"),
                              ("c", "1/8+sin(x)*cos(y)*sin(z)/20")):
            self.micro(f"8_{name}", cage, "12,12,16", "--thickness", formula, model="cylinder.off")
            self.picture(f"8_{name}", f"8_{name}.vmicro", "--around", "cylinder.off")

    # Three periodic curves: the tile, a bone full of them, and the ball on the cylinder, as rational surfaces.
    def figure9(self):
        cube, box = self.cage("one", ["box", "--min", "0,0,0", "--max", "1,1,1"]), self.cage("9", BOX)
        self.curves("9_a", cube, "1,1,1", "--view=-5,8,-4")
        self.curves("9_b", "bone_b.vjson", "8,6,40", LENGTHWISE, model="bone.off", around="bone.off")
        self.curves("9_c", box, "12,12,16", model="cylinder.vjson", around="cylinder.off")

    def curves(self, name, cage, counts, *view, model=None, around=None):
        """Writes the curves and their bridges as NAME.vjson, prints how many there are, and draws them."""
        solid = [] if model is None else ["--model", model]
        report = json.loads(self.run("micro", "--cage", cage, "--tile", "curves3", "--counts", counts, *solid,
                                     "--emit", f"{name}.vjson", "--json", "-"))
        tiles, bridges = report["tiles"], report["bridges"]
        text = f"{report['composed']['curves']} curves of {tiles['kept']} of {tiles['total']} tiles"
        if bridges:
            text += f", {bridges['built']} of {bridges['caps']} ends bridged"
        print(f"{name}: {text}", flush=True)
        self.picture(name, f"{name}.vjson", *view, *([] if around is None else ["--around", around]))

    # A mesh to be printed: bone and duck with their bridges.
    def figure10(self):
        hull = self.cage("10", ["hull", "--around", "duck.off", "--spans", "6,6,6"])
        for name, cage, counts in (("bone", "bone_c.vjson", "6,5,24"), ("duck", hull, "9,9,15")):
            report = self.micro(f"10_{name}", cage, counts, "--connected", "--mesh", f"{name}.stl", "--chord", "0.01",
                                model=f"{name}.off")
            [mesh] = json.loads(self.run("certify", f"{name}.stl", "--json", "-"))["files"]
            print(f"10_{name}: {report['mesh']['facets']} facets, {mesh['verdict']}")
            self.picture(f"10_{name}", f"{name}.stl", "--view=-4,9,-3" if name == "duck" else LENGTHWISE)


ALL = ["1", "2", "3", "4", "5", "6", "7", "8", "9", "10"]


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    pictures = sys.argv[2] if len(sys.argv) > 2 else None
    if pictures:
        pathlib.Path(pictures).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        figures = Figures(program, folder, pictures)
        for figure in sys.argv[3:] or ALL:
            figures.show(figure)


if __name__ == "__main__":
    main()
