#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""figures.py VERITOPE [PICTURES [FIGURE...]]: the V-models of the figures of [ME16].

Builds, decides and inspects them, and draws them into the folder PICTURES with the options that README.md lists. Prints
what was found; expected.txt is the output for all figures.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
FIGURES = {  # the tree, and the options of its pictures
    "1a": [["--view=-3,5,-8"]],
    "1a_halves": [["--view=-3,5,-8"]],
    "1b": [["--nets"]],
    "1b_cut": [["--explode", "2"]],
    "2": [["--explode", "2", "--view=-5,6,-3"]],
    "3": [[], ["--explode", "1/2"]],
    "7a": [["--nets"]],
    "7b": [["--nets"]],
    "7c": [["--nets"]],
    "7d": [["--nets"]],
    "7e": [["--nets"]],
    "8a": [["--nets"]],
    "8b": [["--nets"]],
    "9a": [["--explode", "1", "--nets"]],
    "9b": [["--explode", "1", "--nets", "--view=-5,7,-8"]],
    "9c": [["--explode", "2", "--view=-4,8,-5"]],
    "9c_cut": [["--explode", "1", "--view=-3,8,-5"]],
    "9d": [["--explode", "1", "--nets"]],
    "13": [["--view=-4,9,-3"]],
    "13_cut": [["--explode", "1/2", "--nets", "--view=-4,9,-4"]],
}


class Figures:
    def __init__(self, program, folder, pictures):
        self.program, self.folder, self.pictures = program, pathlib.Path(folder), pictures

    def run(self, *arguments, allowed=(0,)):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder,
                              check=False)
        if done.returncode not in allowed:
            sys.exit(f"{' '.join(map(str, arguments))}: status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def certify(self, model):
        [report] = json.loads(self.run("certify", model, "--json", "-", allowed=(0, 1, 3)))["files"]
        return report

    def build(self, name):
        self.run("build", HERE / f"figure{name}.tree", "-o", f"figure{name}.vjson")
        return f"figure{name}.vjson"

    def show(self, name):
        model = self.build(name)
        self.line(name, model)
        for i, options in enumerate(FIGURES[name]):
            picture = self.pictures / f"figure{name}{'' if i == 0 else '_apart'}.png"
            self.run("render", model, "-o", picture, "--size", "800,600", *options)
        details = getattr(self, "details_" + name, None)
        if details is not None:
            details(model)

    def line(self, name, model):
        report = self.certify(model)
        n = json.loads(self.run("inspect", model, "--json", "-"))["counts"]
        is_valid = report["verdict"] == "VALID"
        verdict = ("VALID" if report["regular"] else "VALID, not regular") if is_valid else " ".join(
            [report["verdict"], *sorted({d["code"] for d in report["defects"]})])
        print(f"{name:10} {verdict:19} {counted(n['cells'], 'cell')}, "
              f"{n['v_surfaces']} V-surfaces ({n['internal']} internal), {n['half_v_surfaces']} half, "
              f"{n['v_curves']} V-curves, {n['v_points']} V-points")
        for s in (report["singular"] or []) if is_valid else []:
            ranges = [f"{axis} = {short(low)}" if low == high else f"{axis} in [{short(low)}, {short(high)}]"
                      for axis, (low, high) in zip("uvw", s["box"])]
            print(f"{'':10} singular {s['kind']} of cell {s['cell']}: {', '.join(ranges)}")

    def details_1a_halves(self, model):
        """Each half of the bar is regular and does not meet itself: so the whole is regular."""
        for cell in (0, 1):
            root = {"op": "file", "path": model, "entity": cell}
            (self.folder / "half.json").write_text(json.dumps({"format": "veritope-tree-1", "root": root}))
            self.run("build", "half.json", "-o", "half.vjson")
            report = self.certify("half.vjson")
            regular = "regular" if report["regular"] else "not regular"
            print(f"{'':10} half {cell} alone: {report['verdict']}, {regular}")

    def details_1b(self, model):
        """The six faces bound a box, although the cell folds."""
        self.run("convert", model, "faces.vjson", "--faces")
        report = self.certify("faces.vjson")
        print(f"{'':10} its six faces: {report['verdict']}")

    def details_3(self, model):
        """V-curves 1 and 2 of the paper: the inner one, and one that a single cell has."""
        found = json.loads(self.run("inspect", model, "--json", "-"))
        at_point = {point["id"]: len(point["v_curves"]) for point in found["v_points"]}
        inner = [curve for curve in found["v_curves"] if len(curve["cells"]) == 3]
        outer = next(curve for curve in found["v_curves"]
                     if len(curve["cells"]) == 1 and all(at_point[p] == 3 for p in curve["points"]))
        for what, curve in [("the inner V-curve", *inner), ("an outer V-curve", outer)]:
            points = " and ".join(str(at_point[p]) for p in curve["points"])
            print(f"{'':10} {what}: {len(curve['v_surfaces'])} V-surfaces, {curve['half_v_surfaces']} half, "
                  f"{counted(len(curve['cells']), 'cell')}; its V-points are in {points} V-curves")


def counted(n, what):
    return f"{n} {what}{'' if n == 1 else 's'}"


def short(ratio):
    return ratio[:-2] if ratio.endswith("/1") else ratio


def main():
    program, names = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[3:] or list(FIGURES)
    with tempfile.TemporaryDirectory() as folder:
        pictures = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else pathlib.Path(folder)
        figures = Figures(program, folder, pictures)
        for name in names:
            figures.show(name)


if __name__ == "__main__":
    main()
