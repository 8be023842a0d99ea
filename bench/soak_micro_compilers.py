#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Two builds write the same bytes: microstructures, lists, reports, meshes, composed splines, pictures, certificates.

usage: soak_micro_compilers.py BIN_FOLDER [OTHER_BIN_FOLDER] [--jobs N] [--keep FOLDER] [--run NAME ...]
Without OTHER_BIN_FOLDER the program is built by clang++-14 in the folder build-clang. Each run makes its cage, its
solid and its microstructure with both programs, in one folder after the other, and compares all files that were
written, and standard output. Seconds are left out of reports. One JSON line: the number of files that differ, and
which.
"""
import argparse
import csv
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SECONDS = re.compile(rb'"seconds":(\{[^{}]*\}|[-+.e0-9]+)')
BOX = ("cage", "box", "--min", "-1,-1,-1", "--max", "3,2,2", "--degrees", "2,3,1", "-o", "box.vjson")
RING = ("cage", "radial", "--around", "cylinder.vjson", "-o", "ring.vjson")
HULL = ("cage", "hull", "--around", "bone.off", "--spans", "4,4,8", "-o", "hull.vjson", "--json", "hull.json")
AROUND = ("cage", "box", "--around", "bone.off", "--degrees", "2,2,3", "-o", "around.vjson")
DUCK = ("cage", "box", "--around", "duck.vjson", "-o", "duck_box.vjson")
FIT = ("cage", "fit", "--field", "field.csv", "--spans", "3,3,3", "-o", "fit.vjson", "--json", "fit.json")
SPLIT = (("cage", "box", "--around", "bone.off", "-o", "whole.vjson"),
         ("cage", "split", "--of", "whole.vjson", "--at", "u=1/2", "-o", "split.vjson"))


def micro(cage, tile, counts, name, *more, solid=None, emit=None):
    command = ["micro", "--cage", cage, "--tile", tile, "--counts", counts, "--json", f"{name}.json", *more]
    if solid is not None:
        command += ["--model", solid, "--list", f"{name}.csv"]
    return tuple(command + ([] if emit is None else ["--emit", f"{name}.{emit}"]))


def certify(name, *more):
    return ("certify", f"{name}.vmicro", "--json", f"{name}_decided.json", "--certificate", f"{name}.cert", *more)


# The commands of each run.
RUNS = {
    "graded": (BOX, micro("box.vjson", "jack", "5,4,3", "a", "-o", "a.vmicro", "--thickness",
                          "1/8+sin(3*x)*cos(2*y+z)/24+rand(7)/64", "--mesh", "a.ply", "--chord", "0.005", emit="vjson"),
               certify("a"), ("certify", "a.ply", "--json", "ply.json", "--certificate", "ply.cert")),
    "bridges": (AROUND, micro("around.vjson", "jack", "8,6,16", "b", "-o", "b.vmicro", "--mesh", "b.stl", "--chord",
                              "0.02", solid="bone.off"), certify("b", "--model", "bone.off")),
    "hull": (HULL, micro("hull.vjson", "jack,degree=1", "6,6,16", "c", "-o", "c.vmicro", "--alpha", "1/3", "--skin",
                         "0.02", "--connected", solid="bone.off"), certify("c", "--model", "bone.off")),
    "rational": (RING, micro("ring.vjson", "branch,arms=u0+u1+v0+v1+w0", "3,12,5", "d", "-o", "d.vmicro", emit="itd"),
                 certify("d"), micro("ring.vjson", "jack", "3,12,5", "e", "-o", "e.vmicro", solid="cylinder.vjson")),
    "nested": (BOX, micro("box.vjson", "jack,degree=1", "2,1,1", "f", "-o", "f.vmicro", "--nest", "jack:2,1,2",
                          "--mesh", "f.off", "--chord", "0.01"), certify("f")),
    "frame": (BOX, micro("box.vjson", "frame,bar=1/4,margin=1/10", "4,4,3", "g", "-o", "g.vmicro", "--tile", "jack",
                         "--place", "rand(3)*2", "--mesh", "g.obj", "--chord", "0.01"), certify("g")),
    "materials": (BOX, micro("box.vjson", "jack", "3,3,4", "h", "-o", "h.vmicro", "--double", "w=2", "--material",
                             "heat=exp(-x^2)+sqrt(abs(y))", "--material", "noise=rand(5)+sin(pi*u)/3"), certify("h")),
    "fit": (FIT, micro("fit.vjson", "jack", "4,4,4", "i", "-o", "i.vmicro", emit="vtu"), certify("i"),
            ("certify", "fit.vjson", "--json", "fit_decided.json", "--certificate", "fit.cert")),
    "split": (*SPLIT, micro("split.vjson", "jack", "4,6,14/4,6,14", "j", "-o", "j.vmicro", solid="bone.off"),
              certify("j", "--model", "bone.off")),
    "curves": (AROUND, micro("around.vjson", "curves3", "8,6,16", "k", solid="bone.off", emit="vjson"),
               ("render", "k.vjson", "-o", "k.png", "--around", "bone.off", "--size", "300,200"),
               ("render", "k.vjson", "-o", "k.gltf"), ("render", "k.vjson", "-o", "k.obj")),
    "polylines": (DUCK, micro("duck_box.vjson", "curves3,radius=1/8,parts=6", "7,7,11", "l", "--alpha", "3/4",
                              solid="duck.vjson", emit="itd")),
    "sheets": (RING, micro("ring.vjson", "jack-surfaces,degree=1", "2,8,4", "m", "--thickness", "1/8+u*v/9",
                           solid="cylinder.vjson", emit="vtu")),
}


def write_inputs(folder, program):
    """The solids of examples/micro_figures, a field that turns, and the duck, by the first program."""
    subprocess.run([sys.executable, ROOT / "examples/micro_figures/make_models.py", folder], check=True)
    subprocess.run([program, "build", ROOT / "examples/vrep_figures/figure13.tree", "-o", "duck.vjson"], cwd=folder,
                   check=True, capture_output=True)
    with open(folder / "field.csv", "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        for i in range(6 * 6 * 6):
            x, y, z = (n / 5 for n in (i % 6, i // 6 % 6, i // 36))
            rows.writerow([x, y, z, math.sin(y / 2) / 3, math.sin(x * z) / 5, 1])


def contents(path):
    return SECONDS.sub(b'"seconds":0', path.read_bytes())


def run_in(program, commands, inputs, folder, jobs):
    """The bytes of each file that the commands wrote, and of their standard outputs."""
    shutil.copytree(inputs, folder)
    before, out = set(os.listdir(folder)), {}
    for number, command in enumerate(commands):
        done = subprocess.run([program, *command, "--jobs", str(jobs)], cwd=folder, capture_output=True, check=False)
        if done.returncode not in (0, 3):
            sys.exit(f"{program} {' '.join(command)}: status {done.returncode}\n"
                     f"{done.stdout.decode()}{done.stderr.decode()}")
        out[f"output {number} of {command[0]}"] = done.stdout + bytes([done.returncode])
    for name in sorted(set(os.listdir(folder)) - before):
        out[name] = contents(folder / name)
    return out


def build_other(folder, compiler):
    folder.mkdir(exist_ok=True)
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    f"-DCMAKE_CXX_COMPILER={compiler}", "-DVERITOPE_TESTS=OFF", "-DVERITOPE_BENCH=OFF"], check=True,
                   stdout=sys.stderr)
    subprocess.run(["ninja", "-C", folder, "bin/veritope", "bin/veritope-check"], check=True, stdout=sys.stderr)
    return folder / "bin"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("other", type=pathlib.Path, nargs="?")
    parser.add_argument("--compiler", default="clang++-14")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder that does not exist, for all files")
    parser.add_argument("--run", nargs="*", choices=list(RUNS), default=list(RUNS))
    options = parser.parse_args()
    other = options.other or build_other(ROOT / "build-clang", options.compiler)
    programs = [(folder / "veritope").resolve() for folder in (options.bin, other)]
    different, files, digest = [], 0, hashlib.sha256()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        inputs = folder / "inputs"
        inputs.mkdir(parents=True)
        write_inputs(inputs, programs[0])
        for name in options.run:
            first, second = (run_in(program, RUNS[name], inputs, folder / f"{name}_{i}", options.jobs)
                             for i, program in enumerate(programs))
            files += len(first)
            for file, data in first.items():
                digest.update(data)
                if second.get(file) != data:
                    different.append(f"{name}: {file}")
            different += [f"{name}: {file}" for file in second if file not in first]
            print(name, len(first), "files", file=sys.stderr, flush=True)
    print(json.dumps({"name": "micro_compilers", "value": len(different), "goal": "0", "runs": len(options.run),
                      "files": files, "different": different, "sha256": digest.hexdigest()}))
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
