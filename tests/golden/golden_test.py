#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reports and certificates of fixed models have the hashes in hashes.txt, whatever the compiler and its -O level.

    golden_test.py --program FILE                the hashes that one build of hash_main.cc prints
    golden_test.py --cmake CMAKE --build FOLDER  builds it with g++ and clang++-14 at -O0 and -O2 first (kept in FOLDER)
    golden_test.py --program FILE --update       writes hashes.txt: after a change that is meant to change the output
"""
import argparse
import difflib
import json
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GOLDEN = HERE / "hashes.txt"
HEAD = """# Written by tests/golden/golden_test.py --update: model, SHA-256 of the report's exact text, SHA-256 of its certificate.
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


def build(cmake, folder, compiler, level):
    folder = folder / (compiler + level)
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    flags = ["-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={level}", "-DVERITOPE_TESTS=ON",
             "-DVERITOPE_FUZZ=OFF", "-DVERITOPE_BENCH=OFF", "-DVERITOPE_WERROR=OFF"]
    for command in ([cmake, "-S", ROOT, "-B", folder, *generator, *flags], [cmake, "--build", folder, "--target", "golden_hash", "-j", "2"]):
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"{compiler} {level} does not build:\n{run.stdout[-4000:]}\n{run.stderr[-4000:]}")
    return folder / "tests" / "golden_hash"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--build", type=pathlib.Path)
    options = parser.parse_args()
    if options.program:
        hashes = hashes_of(options.program)
        if options.update:
            GOLDEN.write_text(HEAD + hashes)
        return 0 if is_golden(options.program.name, hashes) else 1
    if not options.build:
        parser.error("--program or --build")
    good, builds = True, 0
    for compiler in COMPILERS:
        if not shutil.which(compiler):
            print(f"{compiler} is not installed: its builds are skipped")
            continue
        for level in LEVELS:
            good = is_golden(f"{compiler} {level}", hashes_of(build(options.cmake, options.build, compiler, level))) and good
            builds += 1
            print(f"{compiler} {level}: done", flush=True)
    print(json.dumps({"name": "builds_with_other_bytes", "value": 0 if good else 1, "goal": "0", "builds": builds}))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
