#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Keeps the arrows of docs/layers.txt: every #include and every CMake link of the tree.

Also: an included file exists; an installed header (*.h of a layer, not *_internal.h) includes only installed headers, the
standard library, intrinsics and GMP; verify/checker/ includes its own files and the standard library, nothing else; only
the programs of tests/install/consumer, which are built outside of the tree, include headers as they are installed.
"""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "infra"))
from tree import CPP, ROOT, Layers, files  # noqa: E402

STANDARD = set("""algorithm any array atomic barrier bit bitset charconv chrono compare complex concepts condition_variable coroutine
deque exception execution filesystem format forward_list fstream functional future initializer_list iomanip ios iosfwd iostream
istream iterator latch limits list locale map memory memory_resource mutex new numbers numeric optional ostream queue random ranges
ratio regex scoped_allocator semaphore set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string
string_view syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray
variant vector version cassert cctype cerrno cfenv cfloat cinttypes climits clocale cmath csetjmp csignal cstdarg cstddef cstdint
cstdio cstdlib cstring ctime cuchar cwchar cwctype assert.h ctype.h errno.h fenv.h float.h inttypes.h limits.h locale.h math.h
setjmp.h signal.h stdarg.h stddef.h stdint.h stdio.h stdlib.h string.h time.h""".split())
OUTSIDE = [  # kind, headers; the first that fits
    ("stat", r"sys/stat\.h"),
    ("posix", r"(unistd|malloc|fcntl|fnmatch|dirent|poll|pthread|spawn|termios)\.h|sys/.*\.h"),
    ("intrinsics", r"([a-z]*intrin|x86gprintrin|cpuid|arm_neon)\.h"),
    ("gmp", r"gmp\.h"),
    ("cli11", r"CLI/.*"),
    ("zlib", r"zlib\.h"),
    ("json", r"nlohmann/.*"),
    ("gtest", r"(gtest|gmock)/.*"),
    ("rapidcheck", r"rapidcheck(/.*|\.h)"),
    ("mpfr", r"mpfr\.h"),
    ("mpfi", r"mpfi(_io)?\.h"),
    ("cgal", r"(CGAL|boost)/.*|gmpxx\.h"),
    ("peers", r"(arb|gmsh|tetgen|vtk\w+)\.h|embree3/.*"),
    ("eigen", r"Eigen/.*"),
    ("occt", r"\w+\.hxx"),
    ("gudhi", r"gudhi/.*"),
]
PUBLIC_OUTSIDE = {"intrinsics", "gmp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)


def outside_kind(header):
    """ "std", a word of docs/layers.txt, or None for a header that nobody may include."""
    if header in STANDARD:
        return "std"
    return next((kind for kind, pattern in OUTSIDE if re.fullmatch(pattern, header)), None)


def is_checker(row):
    return row == "verify/checker" or row.startswith("verify/checker/")


def is_installed(path, layers):
    """Whether it is installed, as a public header or below internal/: cmake/VeritopeHeaders.cmake."""
    row = layers.layer_of(path)
    if row and is_checker(row):
        return False
    unlisted = {None, "cli", "python", "models", "hard_models", "named_predicates", "render", "report",
                "tools", "tests", "examples", "fuzz", "bench"}
    return path.endswith(".h") and not path.endswith("_internal.h") and row not in unlisted


def find_ours(root, includer, header):
    """The file of the tree that a header names, as the compiler would find it, or None. A generated one counts by its .in file."""
    for base in ((root / includer).parent, root):
        for name in (header, header + ".in"):
            path = (base / name).resolve()
            if path.is_file() and path.is_relative_to(root.resolve()):
                return str(path.relative_to(root.resolve()))
    return None


def include_faults(root, layers):
    """One line a fault, in the order of the files."""
    faults = []
    for path in map(str, files(root, CPP)):
        row = layers.layer_of(path)
        text = (root / path).read_text()
        if row is None:
            faults.append(f"{path}: its folder has no row in docs/layers.txt")
            continue
        for match in INCLUDE.finditer(text):
            place = f"{path}:{text.count(chr(10), 0, match.start(2)) + 1}: "
            fault = include_fault(root, layers, path, match[1] == '"', match[2])
            if fault:
                faults.append(place + fault)
    return faults


def include_fault(root, layers, path, quoted, header):
    row, kind = layers.layer_of(path), outside_kind(header)
    if kind == "std" and not quoted:
        return None
    if header.startswith("veritope/") and not quoted:  # the installed names: tests/install/public_headers_test.py
        return None if path.startswith("tests/install/consumer/") else f"<{header}> is for programs outside of the tree"
    target = find_ours(root, path, header)
    if target is None and (quoted or kind is None):
        return f"{header} does not exist" if quoted else f"<{header}> is no header that docs/layers.txt knows"
    if target is None:
        allowed = layers.outside_of(row)
        if kind not in allowed and not (kind == "stat" and "posix" in allowed):
            return f"{row} may not include <{header}> ({kind})"
        if is_installed(path, layers) and kind not in PUBLIC_OUTSIDE and row != "interop":
            return f"an installed header may not include <{header}> ({kind})"
        return None
    other = layers.layer_of(target)
    if other not in layers.may_include(row):
        return f"{row} may not include {target}: no arrow from {other}"
    if is_installed(path, layers) and not is_installed(target, layers):
        return f"an installed header may not include {target}, which is not installed"
    if target.endswith("_internal.h") and row not in (other, "tests", "fuzz", "bench"):
        return f"{target} is for {other} and its tests only"
    return None


LAYER_CALL = re.compile(r"veritope_layer\(\s*(\w+)\s+([^\s)]+)([^)]*)\)")
LINK_CALL = re.compile(r"target_link_libraries\(\s*([^\s)]+)([^)]*)\)")
OUR_LIBRARY = re.compile(r"veritope(?:::|_)(\w+)")


def cmake_text(path):
    return re.sub(r"#.*", "", path.read_text())


def link_faults(root, layers):
    """Links between layers that the table does not allow, and includes that no link stands behind."""
    lists = [path for path in files(root) if path.name == "CMakeLists.txt" or path.suffix == ".cmake"]
    texts = {str(path): cmake_text(root / path) for path in lists if path.parts[0] != "cmake"}
    folder_of, links, faults = {}, {}, []
    for path, text in texts.items():
        for name, folder, rest in LAYER_CALL.findall(text):
            folder_of[name] = folder
            links.setdefault(folder, set()).update(OUR_LIBRARY.findall(rest))
            if folder not in layers.arrows:
                faults.append(f"{path}: {folder} has no row in docs/layers.txt")
    for path, text in texts.items():
        for target, rest in LINK_CALL.findall(text):
            own = OUR_LIBRARY.fullmatch(target)
            folder = folder_of.get(own[1]) if own else None
            folder = folder or layers.layer_of(str(pathlib.PurePath(path).parent)) or ""
            links.setdefault(folder, set()).update(OUR_LIBRARY.findall(rest))
    for folder, names in sorted(links.items()):
        for name in sorted(names & folder_of.keys()):
            if folder_of[name] not in layers.may_include(folder):
                faults.append(f"CMake links {folder or 'the top folder'} to {folder_of[name]}: no such arrow in docs/layers.txt")
    return faults


class LayeringOfTheTree(unittest.TestCase):
    def setUp(self):
        self.layers = Layers((ROOT / "docs" / "layers.txt").read_text())

    def test_every_include_follows_an_arrow_of_the_table(self):
        faults = include_faults(ROOT, self.layers)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_every_cmake_link_follows_an_arrow_of_the_table(self):
        faults = link_faults(ROOT, self.layers)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_the_table_has_no_cycle_and_the_checker_no_arrow(self):
        for row, arrows in self.layers.arrows.items():
            self.assertLessEqual(arrows - {"*"}, self.layers.arrows.keys(), f"{row} names a folder without a row")
            for lower in arrows - {"*"}:
                self.assertNotIn(row, self.layers.may_include(lower), f"{row} and {lower} reach each other")
            sees_checker = any(map(is_checker, self.layers.may_include(row)))
            self.assertEqual(sees_checker, is_checker(row) or row in ("tests", "fuzz", "bench"), row)
            if is_checker(row):
                self.assertTrue(all(map(is_checker, self.layers.may_include(row))), row)


class PlantedFaults(unittest.TestCase):
    """Every rule of this file rejects one small tree that breaks it, and accepts the tree before."""

    SOUND = {
        "robust/base/sign.h": "#include <cstdint>\n",
        "robust/CMakeLists.txt": "veritope_layer(base robust/base)\nveritope_layer(robust robust veritope_base gmp)\n",
        "robust/integer.h": '#include <gmp.h>\n#include "robust/base/sign.h"\n',
        "predicates/CMakeLists.txt": "veritope_layer(predicates predicates veritope_robust)\n",
        "predicates/orient2d.h": '#include "robust/integer.h"\n',
        "predicates/orient2d_internal.h": '#include "predicates/orient2d.h"\n',
        "predicates/orient2d.cc": '#include "predicates/orient2d_internal.h"\n',
        "verify/checker/main.cc": '#include <vector>\n#include "mesh/mesh.h"\n',
        "verify/checker/mesh/mesh.h": '#include "../common/numbers.h"\n',
        "verify/checker/patches/star.h": '#include "../common/numbers.h"\n',
        "verify/checker/common/numbers.h": "#include <vector>\n",
        "tests/predicates/orient2d_test.cc": '#include <CGAL/Gmpq.h>\n#include "predicates/orient2d_internal.h"\n',
    }

    def faults(self, changes):
        layers = Layers((ROOT / "docs" / "layers.txt").read_text())
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**self.SOUND, **changes}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return include_faults(root, layers) + link_faults(root, layers)

    def assert_only_fault(self, changes, expected):
        faults = self.faults(changes)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(expected, faults[0])

    def test_the_sound_tree_has_none(self):
        self.assertEqual(self.faults({}), [])

    def test_an_upward_include_is_found(self):
        self.assert_only_fault({"robust/up.cc": '#include "predicates/orient2d.h"\n'}, "no arrow from predicates")

    def test_a_missing_file_is_found(self):
        self.assert_only_fault({"robust/lost.cc": '#include "robust/base/nowhere.h"\n'}, "does not exist")

    def test_an_unknown_library_is_found(self):
        self.assert_only_fault({"robust/odd.cc": "#include <bzlib.h>\n"}, "no header that docs/layers.txt knows")

    def test_the_name_of_an_installed_header_in_the_tree_is_found(self):
        include = "#include <veritope/robust/integer.h>\n"
        self.assertEqual(self.faults({"tests/install/consumer/main.cc": include}), [])
        self.assert_only_fault({"robust/odd.cc": include}, "is for programs outside of the tree")
        self.assert_only_fault({"tests/robust/odd_test.cc": include}, "is for programs outside of the tree")

    def test_cgal_and_boost_in_a_layer_are_found(self):
        self.assert_only_fault({"predicates/peer.h": "#include <CGAL/Gmpq.h>\n"}, "(cgal)")
        self.assert_only_fault({"robust/peer.h": "#include <boost/multiprecision/cpp_int.hpp>\n"}, "(cgal)")

    def test_mpfr_is_for_bodies_and_internal_headers_of_interval(self):
        self.assertEqual(self.faults({"interval/real_internal.h": "#include <mpfr.h>\n", "interval/real.cc": "#include <mpfr.h>\n"}), [])
        self.assert_only_fault({"interval/real.h": "#include <mpfr.h>\n"}, "an installed header may not include")
        self.assert_only_fault({"interval/real.cc": "#include <mpfi.h>\n"}, "(mpfi)")
        self.assert_only_fault({"predicates/real.cc": "#include <mpfr.h>\n"}, "(mpfr)")

    def test_a_kernel_header_in_the_checker_is_found(self):
        self.assert_only_fault({"verify/checker/extra.h": '#include "robust/base/sign.h"\n'}, "no arrow from robust/base")
        self.assert_only_fault({"verify/checker/extra.h": "#include <gmp.h>\n"}, "(gmp)")
        self.assert_only_fault({"verify/checker/extra.h": "#include <unistd.h>\n"}, "(posix)")
        self.assert_only_fault({"verify/checker/mesh/extra.h": "#include <gmp.h>\n"}, "(gmp)")
        self.assert_only_fault({"verify/checker/extra.h": "#include <sys/mman.h>\n"}, "(posix)")
        self.assert_only_fault({"verify/format/extra.cc": "#include <sys/stat.h>\n"}, "(stat)")

    def test_a_claim_of_the_checker_that_includes_another_is_found(self):
        self.assert_only_fault({"verify/checker/mesh/extra.h": '#include "../patches/star.h"\n'}, "no arrow from verify/checker/patches")
        self.assert_only_fault({"verify/checker/common/extra.h": '#include "../mesh/mesh.h"\n'}, "no arrow from verify/checker/mesh")

    def test_the_checker_in_the_kernel_is_found(self):
        self.assert_only_fault({"solids/polyhedron/cheat.cc": '#include "verify/checker/common/numbers.h"\n'}, "no arrow from verify/checker")

    def test_a_posix_or_internal_header_in_an_installed_one_is_found(self):
        self.assert_only_fault({"robust/wait.h": "#include <unistd.h>\n"}, "an installed header may not include")
        self.assert_only_fault({"predicates/open.h": '#include "predicates/orient2d_internal.h"\n'}, "which is not installed")

    def test_an_internal_header_of_another_layer_is_found(self):
        self.assert_only_fault({"solids/polyhedron/curious.cc": '#include "predicates/orient2d_internal.h"\n'}, "its tests only")

    def test_a_folder_without_a_row_is_found(self):
        self.assert_only_fault({"misc/thing.cc": "#include <vector>\n"}, "no row")

    def test_an_upward_link_is_found(self):
        link = "veritope_layer(base robust/base)\nveritope_layer(robust robust veritope_base veritope_predicates)\n"
        self.assert_only_fault({"robust/CMakeLists.txt": link}, "CMake links robust to predicates")
        link = "target_link_libraries(veritope_check PRIVATE veritope::robust)\n"
        self.assert_only_fault({"verify/checker/CMakeLists.txt": link}, "CMake links verify/checker to robust")


if __name__ == "__main__":
    unittest.main()
