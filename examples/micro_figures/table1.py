#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""table1.py VERITOPE [--row 6c ...] [--bunny FILE] [--folder FOLDER] [--jobs N]: table 1 of [HPE22] on our own models.

For each row: makes model and cage, fills, filters, bridges (veritope micro), decides the result with the claim that it
lies in the model (veritope certify --model), and prints a line with the paper's numbers beside. The bunny is the file
thingiCSG__bunny_remap.off of the folder VERITOPE_DATA/mesh/solid1, or --bunny; without it rows 6 are left out. Exits
with 1 if a row is not VALID and inside. With --tile curves3 or jack-surfaces, of which no claim is made: the seconds of
filtering, of bridging the free ends of curves, and of composing and writing it all.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
BUNNY = "mesh/solid1/thingiCSG__bunny_remap.off"
# Seconds: construction of trivariates and of surfaces, filtering (eight threads), bridging; MS_T, MS_F, MS_B.
PAPER = {
    "4a": (456.484, 1.609, 258.281, 6.439, 576, 188, 272),
    "4b": (1854.469, 5.937, 946.63, 24.26, 2304, 916, 770),
    "4c": (214.735, 2.921, 739.912, 23.05, 2304, 1468, 692),
    "5a": (10.344, 1.047, 1.93, 7.675, 1480, 531, 728),
    "5b": (1534.844, 5.063, 1.78, 5.314, 1920, 387, 510),
    "5c": (12.281, 1.641, 3.565, 10.734, 2240, 939, 836),
    "6a": (6963.937, 22.328, 50.667, 261.711, 8448, 1706, 1519),
    "6b": (1307.093, 13.141, 58.611, 352.709, 10368, 2315, 2066),
    "6c": (1054.328, 12.906, 63.94, 412.034, 10368, 2786, 2407),
    "7a": (237.5, 3.75, 10400.717, 32.138, 2541, 889, 852),
    "7b": (328.25, 4.516, 10783.349, 46.006, 3549, 1287, 983)}
# Row: the model; how to make its cage; cells along the axes (of each volume).
EARS = [["split", "--at", "w=9/16", "--open", "v1", "--from", "27/32", "--low=0,0,-5", "--high", "0,0,5"]]
SPLIT_COUNTS = "18,20,13/18,20,11/18,4,13/18,4,11"
ROWS = {
    "4a": ("cylinder.vjson", [["box", "--around", "cylinder.vjson", "--degrees", "3,3,3"]], "8,6,12"),
    "4b": ("cylinder.vjson", [["box", "--around", "cylinder.vjson", "--degrees", "3,3,3"]], "12,12,16"),
    "4c": ("cylinder.vjson", [["radial", "--around", "cylinder.vjson"]], "6,24,16"),
    "5a": ("bone.off", "bone_a.vjson", "8,5,37"),
    "5b": ("bone.off", "bone_b.vjson", "8,6,40"),
    "5c": ("bone.off", "bone_c.vjson", "8,7,40"),
    "6a": ("bunny", [["box", "--around", "bunny", "--degrees", "3,3,3"]], "16,22,24"),
    "6b": ("bunny", [["box", "--around", "bunny"], *EARS], SPLIT_COUNTS),
    "6c": ("bunny", [["hull", "--around", "bunny", "--spans", "8,8,8", "--margin", "1/40"]], "18,24,24"),
    "7a": ("duck.vjson", [["box", "--around", "duck.vjson"]], "11,11,21"),
    "7b": ("duck.vjson", [["hull", "--around", "duck.vjson", "--spans", "6,6,6"]], "13,13,21"),
}


class Table:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        bunny = pathlib.Path(options.bunny or pathlib.Path(os.environ.get("VERITOPE_DATA", "/nowhere")) / BUNNY)
        self.bunny = bunny.resolve() if bunny.exists() else None
        subprocess.run([sys.executable, HERE / "make_models.py", folder], check=True)
        tree = HERE.parent / "vrep_figures" / "figure13.tree"
        self.run("build", tree, "-o", "duck.vjson")

    def run(self, *arguments, allowed=(0,)):
        words = [str(self.bunny) if a == "bunny" else str(a) for a in arguments]
        done = subprocess.run([self.options.veritope, *words], capture_output=True, text=True, cwd=self.folder,
                              check=False)
        if done.returncode not in allowed:
            sys.exit(f"veritope {' '.join(words)}: status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def cage(self, name, steps):
        if isinstance(steps, str):
            return steps
        made = None
        for i, step in enumerate(steps):
            before = [] if made is None else ["--of", made]
            made = f"{name}_{i}.vjson"
            self.run("cage", *step, *before, "-o", made)
        return made

    def micro(self, cage, counts, model, out, *more):
        return json.loads(self.run("micro", "--cage", cage, "--tile", self.options.tile, "--counts", counts,
                                   "--model", model, "-o", out, "--json", "-", "--jobs", self.options.jobs,
                                   *more, *self.options.more, allowed=(0, 3)))

    def row(self, name):
        model, steps, counts = ROWS[name]
        if model == "bunny" and self.bunny is None:
            print(f"{name}   left out: no bunny")
            return True
        cage = self.cage(name, steps)
        if self.options.tile.startswith(("curves3", "jack-surfaces")):
            return self.open_row(name, cage, model, counts)
        out = f"{name}.vmicro"
        report = self.micro(cage, counts, model, out)
        begin = time.monotonic()
        [decided] = json.loads(self.run("certify", out, "--model", model, "--json", "-",
                                        allowed=(0, 1, 3)))["files"]
        seconds = time.monotonic() - begin
        is_good = decided["verdict"] == "VALID" and decided["inside"] is not None
        self.print_row(name, report, is_good, seconds)
        return is_good

    def open_row(self, name, cage, model, counts):
        report = json.loads(self.run("micro", "--cage", cage, "--tile", self.options.tile, "--counts", counts,
                                     "--model", model, "--emit", f"{name}_open.vjson", "--json", "-",
                                     "--jobs", self.options.jobs, *self.options.more, allowed=(0, 3)))
        tiles, s, written = report["tiles"], report["seconds"], report["composed"] or {"patches": 0}
        ends = report["bridges"] or {"built": 0, "caps": 0}
        print(f"{name}  {tiles['total']:6} {tiles['kept']:5}        {tiles['undecided']:4} undecided  "
              f"filter {s['filter']:.3f} s  {ends['built']} of {ends['caps']} ends in {s['bridge']:.2f} s  "
              f"{written['patches']} patches or curves in {s['compose']:.2f} s", flush=True)
        return True

    @staticmethod
    def print_row(name, report, is_good, decided):
        tiles, s, bridges, paper = report["tiles"], report["seconds"], report["bridges"], PAPER[name]
        share = 100 * bridges["built"] / max(1, bridges["caps"])
        print(f"{name}  {tiles['total']:6} {tiles['kept']:5} {bridges['built']:5} ({share:5.1f} %)  "
              f"{s['filter']:6.2f} {s['bridge']:6.2f} {decided:6.2f}  {'VALID inside' if is_good else 'NOT PROVED'}  "
              f"{paper[4]:6} {paper[5]:5} {paper[6]:5} {paper[2]:9.2f} {paper[3]:8.2f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("veritope")
    parser.add_argument("--row", nargs="*", choices=list(ROWS), default=list(ROWS))
    parser.add_argument("--bunny")
    parser.add_argument("--folder")
    parser.add_argument("--jobs", default="1")
    parser.add_argument("--tile", default="jack")
    parser.add_argument("--more", nargs="*", default=[], help="options for veritope micro")
    options = parser.parse_args()
    options.veritope = str(pathlib.Path(options.veritope).resolve())
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(options.folder or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        table = Table(options, folder)
        print("row    MS_T  MS_F  MS_B (of caps) filter bridge decide s       "
              "        paper: MS_T  MS_F  MS_B    filter   bridge s")
        return 0 if all([table.row(name) for name in options.row]) else 1


if __name__ == "__main__":
    sys.exit(main())
