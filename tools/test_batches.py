#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Which test files one run of the compiler can take together: in a batch no name has two meanings outside of functions.

The files of a batch share one translation unit ("unity build"), so that headers are parsed once for all of them. But
each file has helpers of its own, with names such as `draw` or `kSeed`. Names are read from lines that begin in the
first column, as clang-format leaves them; what this reading misses is an error of the compiler ("redefinition",
"ambiguous"), unless a header that one test includes has an overload that fits the calls of another one better.

usage: test_batches.py FILE...   prints the batch of each file, a list for CMake; batches are numbered from 0
"""
import collections
import functools
import pathlib
import re
import sys

LIMIT = 10                                                # files of one batch: it needs about 1 GB of memory
TYPED = r"^(?:(?:constexpr|const|static|inline|extern|long|unsigned) )*[\w:]+(?:<[^;\n]*>)?(?:::\w+)?[ *&]+"
NAMES = [re.compile(pattern, re.M) for pattern in (
    r"^(?:template.*\n)?(?:struct|class|enum class|enum) (\w+)",
    r"^using (\w+) =",
    r"^#define (\w+)",
    # constants and variables, then functions, whose return type may be a template
    TYPED + r"(\w+)(?:\[[^\]\n]*\])*(?: =|\{|;)",
    r"^(?!return|TEST)" + TYPED[1:] + r"(\w+)\(")]
BORROWED = re.compile(r"^using ((?:\w+::)+(\w+));", re.M)
OPENED = re.compile(r"^namespace (?:\w+::)*(\w+)", re.M)
INCLUDED = re.compile(r'^#include "(.*)"', re.M)
ROOT = pathlib.Path(__file__).resolve().parent.parent


@functools.cache
def read(file):
    """{name: what it is} in one file, and the headers that it includes."""
    text = file.read_text()
    what = file if file.is_relative_to(ROOT / "tests") else "the library's"
    found = {name: what for pattern in NAMES for name in pattern.findall(text)}
    found |= {name: whole for whole, name in BORROWED.findall(text)}
    found |= {name: "namespace" for name in OPENED.findall(text)}
    return found, {ROOT / header for header in INCLUDED.findall(text) if (ROOT / header).is_file()}


def names_of(path):
    """{name: all that it is} of a test and of the headers that it includes: the tests' files that declare it, the names
    that `using` borrows, "namespace", or "the library's"."""
    found, seen, todo = collections.defaultdict(set), set(), {pathlib.Path(path)}
    while todo:
        file = todo.pop()
        seen.add(file)
        names, headers = read(file)
        for name, what in names.items():
            found[name].add(what)
        todo |= headers - seen
    return dict(found)


def agree(some, others):
    """Whether each name that both have means the same in both, or less in one of them."""
    return all(some[name] <= others[name] or some[name] >= others[name] for name in some.keys() & others.keys())


def batches(paths):
    """The number of each file's batch: the first that has room and agrees with it."""
    numbers, sizes, taken = [], [], []
    for names in map(names_of, paths):
        number = next((i for i, size in enumerate(sizes) if size < LIMIT and agree(names, taken[i])), len(sizes))
        if number == len(sizes):
            sizes.append(0)
            taken.append({})
        sizes[number] += 1
        for name, what in names.items():
            taken[number][name] = taken[number].get(name, set()) | what
        numbers.append(number)
    return numbers


if __name__ == "__main__":
    print(";".join(map(str, batches(sys.argv[1:]))))
