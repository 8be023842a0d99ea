#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""An installation serves programs outside the tree: it is made, moved to another folder, and used through find_package, through
pkg-config, and by its programs.

usage: install_test.py BUILD_FOLDER CMAKE CXX_COMPILER
"""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from every_claim import assert_every_claim  # noqa: E402

CONSUMER = ROOT / "tests" / "install" / "consumer"
EXAMPLES = ROOT / "examples"
INTEROP_PAGE = ROOT / "docs" / "how-to" / "use-with-cgal-boost-eigen.md"
INTEROP_FLAGS = ["-isystem", "/usr/include/eigen3", "-frounding-math"]  # where Debian puts Eigen; what CGAL asks for


def run(*command, env=None, cwd=None):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, env=env, cwd=cwd)
    return done.returncode, done.stdout, done.stdout + done.stderr


class Installation(unittest.TestCase):
    BUILD = CMAKE = COMPILER = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        status, _, text = run(cls.CMAKE, "--install", cls.BUILD, "--prefix", cls.folder / "first")
        if status != 0:
            raise AssertionError(text)
        cls.prefix = cls.folder / "moved"
        (cls.folder / "first").rename(cls.prefix)
        cls.include = cls.prefix / "include" / "veritope"
        cls.pc_folder = next(cls.prefix.rglob("veritope.pc")).parent

    def succeed(self, *command, **keywords):
        status, output, text = run(*command, **keywords)
        self.assertEqual(status, 0, text)
        return output

    def pkg_config(self, *options):
        output = self.succeed("pkg-config", *options, "veritope", env={"PKG_CONFIG_LIBDIR": str(self.pc_folder), "PATH": "/usr/bin:/bin"})
        return output.split()

    def assert_consumer_works(self, program):
        self.assertEqual(run(program, EXAMPLES / "sound_part.stl")[:2], (0, "orient3d: 1\nvalid, 112 faces\n"))
        self.assertEqual(run(program, EXAMPLES / "self_crossing.off")[:2], (1, "orient3d: 1\ninvalid, 60 faces\n"))

    def test_find_package_gives_a_consumer_all_that_it_needs(self):
        build = self.folder / "cmake"
        self.succeed(self.CMAKE, "-S", CONSUMER, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                     f"-DCMAKE_CXX_COMPILER={self.COMPILER}")
        self.succeed(self.CMAKE, "--build", build, "-j", 2)
        self.assert_consumer_works(build / "consumer")
        self.assert_consumer_works(build / "consumer_of_io")
        self.assert_certified_models_are_accepted(build / "certify")

    def assert_certified_models_are_accepted(self, program):
        for name, claim in [("sound_part.stl", "VALID mesh-valid-1"), ("self_crossing.off", "INVALID mesh-invalid-1"),
                            ("quarter_pipe.itd", "VALID star-box-1")]:
            certificate = self.folder / (name + ".cert")
            self.assertEqual(self.succeed(program, EXAMPLES / name, certificate).splitlines()[0], claim)
            self.succeed(self.prefix / "bin" / "veritope-check", EXAMPLES / name, certificate)
            checker = self.prefix / "share" / "veritope" / "veritope_check.py"
            self.succeed(sys.executable, "-I", checker, EXAMPLES / name, certificate)

    def test_pkg_config_gives_a_consumer_all_that_it_needs(self):
        program = self.folder / "by_pkg_config"
        flags = self.pkg_config("--cflags"), self.pkg_config("--libs", "--static")
        self.assertIn("-ffp-contract=off", flags[0])
        self.succeed(self.COMPILER, "-std=c++20", *flags[0], CONSUMER / "main.cc", "-o", program, *flags[1])
        self.assert_consumer_works(program)

    def test_the_installed_headers_compile_and_include_installed_headers_only(self):
        """tests/install/headers_test.py compiles each header of the tree alone. An installed one then compiles alone, too,
        if all that it includes is there."""
        headers = sorted(path.relative_to(self.include) for path in self.include.rglob("*") if path.is_file())
        self.assertIn(pathlib.Path("predicates/orient3d.h"), headers)
        for header in headers:
            for name in re.findall(r'(?m)^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', (self.include / header).read_text()):
                self.assertIn(pathlib.Path(name), headers, str(header))
        cflags = self.pkg_config("--cflags")
        for place, more in (("", []), ("interop", INTEROP_FLAGS)):
            source = self.folder / f"all_headers_{place}.cc"
            wanted = [header for header in headers if header.is_relative_to("interop") == bool(place)]
            source.write_text("".join(f'#include "{header}"\n' for header in wanted))
            flags = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *cflags, *more]
            self.succeed(self.COMPILER, *flags, source)

    def test_the_programs_of_the_interop_page_print_what_it_shows(self):
        pairs = re.findall(r"(?ms)^```cpp\n(.*?)^```\n```text\n(.*?)^```", INTEROP_PAGE.read_text())
        self.assertEqual(len(pairs), 3)
        cflags, libs = self.pkg_config("--cflags"), self.pkg_config("--libs", "--static")

        def output_of(number):
            source, program = self.folder / f"interop{number}.cc", self.folder / f"interop{number}"
            source.write_text(pairs[number][0])
            built = run(self.COMPILER, "-std=c++20", *cflags, *INTEROP_FLAGS, source, "-o", program, *libs, "-lmpfr", "-lgmp")
            return run(program) if built[0] == 0 else built

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for (_, shown), (status, output, text) in zip(pairs, pool.map(output_of, range(3))):
                self.assertEqual((status, output), (0, shown), text)

    def test_no_internal_header_and_nothing_of_the_checker_is_among_the_headers(self):
        self.assertEqual([path.name for path in self.include.rglob("*_internal.h")], [])
        self.assertFalse((self.include / "verify" / "checker").exists())

    def test_the_installed_programs_work_without_the_tree(self):
        model = self.folder / "part.stl"
        shutil.copy(EXAMPLES / "sound_part.stl", model)
        self.succeed(self.prefix / "bin" / "veritope", "certify", model, "--certificate", "part.cert", cwd=self.folder)
        self.succeed(self.prefix / "bin" / "veritope-check", model, "part.cert", cwd=self.folder)

    def test_both_installed_checkers_accept_a_certificate_of_every_claim(self):
        place = self.folder / "every claim"
        place.mkdir()
        python = (sys.executable, "-I", "-B", self.prefix / "share" / "veritope" / "veritope_check.py")
        assert_every_claim(self, self.prefix / "bin" / "veritope", [(self.prefix / "bin" / "veritope-check",), python], place)

    def test_the_whole_checker_in_python_is_installed(self):
        there = {path.relative_to(self.prefix / "share" / "veritope") for path in (self.prefix / "share" / "veritope").rglob("*.py")}
        here = {path.relative_to(ROOT / "verify" / "checker") for path in (ROOT / "verify" / "checker").rglob("*.py")}
        self.assertEqual(there, here)

    def test_licences_and_documents_are_there(self):
        for name in ("README.md", "LICENSE.md", "LICENSES/LGPL-3.0-or-later.txt", "docs/certificates/mesh.md"):
            self.assertTrue((self.prefix / "share" / "doc" / "veritope" / name).is_file(), name)


if __name__ == "__main__":
    Installation.BUILD, Installation.CMAKE, Installation.COMPILER = sys.argv[1:4]
    del sys.argv[1:4]
    unittest.main()
