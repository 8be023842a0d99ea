#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""hostile_builds.py [--cases N] [--seed S] [--folder F] [--only TEXT]: builds the predicates by every compiler here
under flags that change floating point, and decides hard cases in each build under every rounding mode, with FTZ and
DAZ. N cases of every predicate; Ctrl-C ends after the chunk in work, and the figures say how many there were (go on
with another --seed). Prints one JSON line a build and mode; exit 1 if a sign is wrong or a build fails. The expected
signs: bench/hostile_cases.cc, built by ./dev bench or soak."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHUNK = 200_000  # cases a file
WARNING_FREE = ["-w", "-std=c++20", f"-I{ROOT}"]

# What a build must withstand: each flag set with each compiler that knows it.
FLAGS = {
    "plain": ["-O2"],
    "fast_math": ["-O3", "-ffast-math"],
    "ofast_avx2": ["-Ofast", "-march=x86-64-v3"],
    "contraction": ["-O2", "-march=x86-64-v3"],
    "contraction_fast": ["-O3", "-march=x86-64-v3", "-ffp-contract=fast"],
    "finite_math": ["-O2", "-ffinite-math-only"],
    "associative": ["-O2", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"],
    "x87": ["-O2", "-mfpmath=387"],
}
COMPILERS = ["g++", "clang++-14", "clang++-19"]


def sources():
    """The sources of the program under test: the predicates, their dependencies, and their names."""
    named = ["hard_cases.cc", "named_predicate.cc", "implicit_names.cc", "generated_names.cc"]
    files = [*(ROOT / "robust").rglob("*.cc"), *(ROOT / "predicates").rglob("*.cc"), *(ROOT / "interval").glob("*.cc"),
             *(p for p in (ROOT / "cli" / n for n in named) if p.exists()), ROOT / "bench" / "hostile_signs.cc"]
    # Files for one instruction set choose their own flags; files that need MPFR are not predicates.
    skipped = ("batch", "functions", "mp_interval", "power", "trigonometric", "monotone", "reverse", "reduction")
    return [p for p in files if not (p.parent.name == "interval" and p.name.startswith(skipped))
            and "side_batch" not in p.name]


def knows(compiler, flags):
    run = subprocess.run([compiler, *flags, "-x", "c++", "-E", "-", "-o", os.devnull], input="", text=True,
                         capture_output=True)
    return run.returncode == 0


def compile_one(compiler, flags, source, folder):
    target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
    launcher = [shutil.which("ccache")] if shutil.which("ccache") else []
    run = subprocess.run([*launcher, compiler, *WARNING_FREE, *flags, "-c", str(source), "-o", str(target)],
                         capture_output=True, text=True)
    return target, run.stderr if run.returncode != 0 else ""


def build(compiler, name, flags, folder, pool):
    folder.mkdir(parents=True, exist_ok=True)
    objects = list(pool.map(lambda s: compile_one(compiler, flags, s, folder), sources()))
    errors = [text for _, text in objects if text]
    program = folder / "hostile_signs"
    if not errors:
        main = [str(o) for o, _ in objects if o.name.startswith("bench_")]
        archive = folder / "all.a"
        archive.unlink(missing_ok=True)
        subprocess.run(["ar", "qc", str(archive), *(str(o) for o, _ in objects if str(o) not in main)], check=True)
        run = subprocess.run([compiler, *flags, *main, str(archive), "-lgmp", "-lmpfr", "-pthread", "-o", str(program)],
                             capture_output=True, text=True)
        errors = [run.stderr] if run.returncode != 0 else []
    if errors:
        print(f"hostile_builds: {compiler} {name} does not build:\n{errors[0][:4000]}", file=sys.stderr)
        return None
    return program


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=20_000, help="of every predicate")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "hostile")
    parser.add_argument("--only", default="", help="builds whose name contains this")
    arguments = parser.parse_args()
    maker = ROOT / "build" / "bin" / "hostile_cases"
    listed = subprocess.run([str(ROOT / "build" / "bin" / "veritope"), "corpus", "--cases", "200"], check=True,
                            capture_output=True, text=True)
    num_predicates = len({line.split()[0] for line in listed.stdout.splitlines() if line and not line.startswith("#")})
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    programs, failed = {}, False
    for compiler in filter(shutil.which, COMPILERS):
        for name, flags in FLAGS.items():
            label = f"{compiler}_{name}"
            if arguments.only not in label or not knows(compiler, flags):
                continue
            program = build(compiler, name, flags, arguments.folder / label, pool)
            failed |= program is None
            if program:
                programs[label] = program
                print(f"hostile_builds: {label} built", file=sys.stderr)
    counts = {}
    stopped = []
    signal.signal(signal.SIGINT, lambda *_: stopped.append(True))
    left = arguments.cases * num_predicates
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as folder:
        number = 0
        while left > 0 and not stopped:
            size = min(left, CHUNK)
            path = pathlib.Path(folder) / "cases"
            with open(path, "wb") as out:
                subprocess.run([str(maker), "--cases", str(size), "--seed", str(1_000_003 * arguments.seed + number)],
                               check=True, stdout=out, start_new_session=True)

            def decide(label):
                return label, subprocess.run([str(programs[label]), str(path)], capture_output=True, text=True,
                                             start_new_session=True)

            for label, run in pool.map(decide, programs):
                if run.returncode not in (0, 1) or run.stderr:
                    print(f"hostile_builds: {label}: status {run.returncode}\n{run.stderr[:2000]}", file=sys.stderr)
                failed |= run.returncode != 0
                for mode, *values in (line.split() for line in run.stdout.splitlines()):
                    total = counts.setdefault((label, mode), [0, 0, 0])
                    for i, v in enumerate(values):
                        total[i] += int(v)
            left -= size
            number += 1
            print(f"hostile_builds: {arguments.cases * num_predicates - left} of {arguments.cases * num_predicates} "
                  f"cases", file=sys.stderr)
    for (label, mode), (cases, zeros, wrong) in counts.items():
        print(json.dumps({"name": f"hostile_{label}_{mode}", "value": wrong, "goal": "0 wrong signs", "cases": cases,
                          "zeros": zeros}))
    totals = [sum(c[i] for c in counts.values()) for i in range(3)]
    print(json.dumps({"name": "hostile_all", "value": totals[2], "goal": "0 wrong signs", "cases": totals[0],
                      "zeros": totals[1], "builds": len(programs), "predicates": num_predicates}))
    return 1 if failed or totals[2] else 0


if __name__ == "__main__":
    sys.exit(main())
