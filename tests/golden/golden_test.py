#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reports, certificates and pictures of fixed models have the hashes in hashes.txt, whatever the compiler and its -O level.

    golden_test.py --program FILE                the hashes that one build of hash_main.cc prints
    golden_test.py --cmake CMAKE --build FOLDER --map FILE
                                                 builds it with g++ and clang++-14 at -O0 and -O2 first (kept in FOLDER): the linker's map of the
                                                 build that it is part of says which of the libraries' objects it needs, about a tenth of them
    golden_test.py --program FILE --update       writes hashes.txt: after a change that is meant to change the output
"""
import argparse
import difflib
import json
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GOLDEN = HERE / "hashes.txt"
HEAD = """# Written by tests/golden/golden_test.py --update: model, SHA-256 of the report's exact text, SHA-256 of its certificate.
# Pictures: SHA-256 of the PNG, SHA-256 of PLY, VTU and glTF one after the other.
"""
COMPILERS = ["g++", "clang++-14"]
LEVELS = ["-O0", "-O2"]


def hashes_of(program):
    run = subprocess.run([program], capture_output=True, text=True, timeout=600)
    if run.returncode != 0:
        sys.exit(f"{program}: exit {run.returncode}\n{run.stderr}")
    return run.stdout


def is_golden(name, hashes):
    want = GOLDEN.read_text().removeprefix(HEAD)
    if hashes == want:
        return True
    print(f"{name}: other hashes than {GOLDEN.name}")
    print("\n".join(line for line in difflib.unified_diff(want.splitlines(), hashes.splitlines(), lineterm="", n=0) if line[0] in "+-"))
    print("If the output was meant to change: golden_test.py --program FILE --update")
    return False


def needed_objects(linker_map):
    """The objects of our libraries in a program of the folder tests/ of a build, as paths in any build."""
    top, objects = linker_map.parent.parent, ["tests/CMakeFiles/golden_hash.dir/golden/hash_main.cc.o"]
    members = set(re.findall(r"(?m)^(\S*?)lib(veritope\w*)\.a\((\S+)\)", linker_map.read_text()))
    for folder, library, name in sorted(members):
        found = sorted((top / folder / "CMakeFiles" / f"{library}.dir").rglob(name))
        if not found:
            sys.exit(f"{linker_map} names {name} of {library}, which {top} has not built")
        objects += [str(path.relative_to(top)) for path in found]
    if len(objects) < 20:
        sys.exit(f"{linker_map} is no map of golden_hash")
    return objects


def succeed(what, *command):
    run = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{what} does not build:\n{run.stdout[-4000:]}\n{run.stderr[-4000:]}")


def build(cmake, folder, objects, compiler, level):
    folder, what = folder / (compiler + level), f"{compiler} {level}"
    succeed(what, cmake, "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_COMPILER={compiler}",
            f"-DCMAKE_CXX_FLAGS={level}", "-DVERITOPE_TESTS=ON", "-DVERITOPE_FUZZ=OFF", "-DVERITOPE_BENCH=OFF", "-DVERITOPE_WERROR=OFF")
    succeed(what, cmake, "--build", folder, "-j", "2", "--target", *objects)
    program = folder / "golden_hash"
    succeed(what, compiler, level, *(folder / name for name in objects), "-o", program, "-lmpfr", "-lgmp", "-lz", "-pthread")
    return program


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("--map", type=pathlib.Path)
    options = parser.parse_args()
    if options.program:
        hashes = hashes_of(options.program)
        if options.update:
            GOLDEN.write_text(HEAD + hashes)
        return 0 if is_golden(options.program.name, hashes) else 1
    if not options.build or not options.map:
        parser.error("--program, or --build and --map")
    if not shutil.which("ninja"):
        sys.exit("ninja is not installed")
    objects = needed_objects(options.map)
    good, builds = True, 0
    for compiler in COMPILERS:
        if not shutil.which(compiler):
            print(f"{compiler} is not installed: its builds are skipped")
            continue
        for level in LEVELS:
            good = is_golden(f"{compiler} {level}", hashes_of(build(options.cmake, options.build, objects, compiler, level))) and good
            builds += 1
            print(f"{compiler} {level}: done", flush=True)
    print(json.dumps({"name": "builds_with_other_bytes", "value": 0 if good else 1, "goal": "0", "builds": builds, "objects": len(objects)}))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
