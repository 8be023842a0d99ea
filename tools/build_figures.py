#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What a build costs: objects and compile seconds of each target, and the share of weak duplicates in the libraries'
code.

    tools/build_figures.py BUILD_FOLDER [SLOWEST]

The seconds are those of BUILD_FOLDER/.ninja_log: elapsed time of each compiler run, so they mean something only for
a clean build on a machine that does nothing else, with CCACHE_DISABLE=1 (rm -r build; cmake --preset release;
CCACHE_DISABLE=1 ninja -C build). Weak duplicates are functions that the linker finds in several objects of the
static libraries, and keeps once: templates and inline functions that were compiled again and again."""
import collections
import pathlib
import re
import subprocess
import sys


def compile_seconds(build):
    """{object: seconds} of the last run of each."""
    out = {}
    for line in (build / ".ninja_log").read_text().splitlines():
        if not line.startswith("#"):
            start, end, _, path, _ = line.split("\t")
            if path.endswith((".o", ".gch")) and (build / path).is_file():
                out[path] = (int(end) - int(start)) / 1000
    return out


def target_of(path):
    return re.search(r"CMakeFiles/([^/]+)\.dir/", path)[1]


def code_bytes(build):
    """(bytes of functions in the libraries' objects, those of weak functions, those of weak functions that occur in
    several)."""
    strong, weak = 0, collections.defaultdict(list)
    for library in sorted(build.rglob("libveritope_*.a")):
        if library.name != "libveritope_test_support.a":
            command = ["nm", "-S", "--defined-only", library]
            listing = subprocess.run(command, capture_output=True, text=True, check=True).stdout
            for row in (line.split() for line in listing.splitlines()):
                if len(row) == 4 and row[2] in "tT":
                    strong += int(row[1], 16)
                elif len(row) == 4 and row[2] in "wW":
                    weak[row[3]].append(int(row[1], 16))
    once = sum(map(sum, weak.values()))
    return strong + once, once, sum(sum(sizes) for sizes in weak.values() if len(sizes) > 1)


def main():
    build = pathlib.Path(sys.argv[1])
    seconds = compile_seconds(build)
    targets = collections.defaultdict(list)
    for path, time in seconds.items():
        targets[target_of(path)].append(time)
    print("seconds  objects  target")
    for target, times in sorted(targets.items(), key=lambda row: -sum(row[1])):
        print(f"{sum(times):7.1f}  {len(times):7}  {target}")
    print(f"{sum(seconds.values()):7.1f}  {len(seconds):7}  all")
    print("slowest:")
    for path, time in sorted(seconds.items(), key=lambda row: -row[1])[:int(sys.argv[2]) if len(sys.argv) > 2 else 10]:
        print(f"{time:7.1f}  {path}")
    code, weak, repeated = code_bytes(build)
    shares = f"{100 * weak / code:.1f} % weak, {100 * repeated / code:.1f} % weak in several objects"
    print(f"code of the libraries: {code} bytes, {shares}")


if __name__ == "__main__":
    main()
