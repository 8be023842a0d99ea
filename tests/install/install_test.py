#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""An installation serves programs outside the tree: it is made, moved to another folder, and used through find_package, through
pkg-config, and by its programs. Its headers are those of the tree with other includes, and no folder of a user's can come in
between.

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
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "tests" / "infra"), str(ROOT / "tests"), str(ROOT / "tests" / "install")]
from every_claim import assert_every_claim  # noqa: E402
from installed_headers import installed_name, installed_text, public_headers  # noqa: E402
from layering_test import is_installed  # noqa: E402
from tree import Layers, files  # noqa: E402

CONSUMER = ROOT / "tests" / "install" / "consumer"
EXAMPLES = ROOT / "examples"
INTEROP_PAGE = ROOT / "docs" / "how-to" / "use-with-cgal-boost-eigen.md"
FUZZING_PAGE = ROOT / "docs" / "how-to" / "fuzz-your-own-kernel.md"
INTEROP_FLAGS = ["-isystem", "/usr/include/eigen3", "-frounding-math"]  # where Debian puts Eigen; what CGAL asks for
OLD_STANDARD = "Veritope needs C++20: compile with -std=c++20"


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
        cls.headers = sorted(str(path.relative_to(cls.include)) for path in cls.include.rglob("*") if path.is_file())
        layers = Layers((ROOT / "docs" / "layers.txt").read_text())
        cls.sources = [path for path in map(str, files(ROOT, {".h"})) if is_installed(path, layers)]
        cls.table = public_headers()
        cls.public = sorted(name for _, name, _ in cls.table)
        cls.clashes = cls.folder / "clashes"  # of a user who has chosen our names
        for source in cls.sources:
            (cls.clashes / source).parent.mkdir(parents=True, exist_ok=True)
            (cls.clashes / source).write_text("#error this header is not Veritope's\n")
        cls.pc_folder = next(cls.prefix.rglob("veritope.pc")).parent

    def succeed(self, *command, **keywords):
        status, output, text = run(*command, **keywords)
        self.assertEqual(status, 0, text)
        return output

    def pkg_config(self, *options):
        output = self.succeed("pkg-config", *options, "veritope", env={"PKG_CONFIG_LIBDIR": str(self.pc_folder), "PATH": "/usr/bin:/bin"})
        return output.split()

    def check_syntax(self, name, text, *flags):
        """What the compiler says of a program, after its status."""
        source = self.folder / name
        source.write_text(text)
        status, _, said = run(self.COMPILER, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *flags, source)
        return status, said

    def assert_consumer_works(self, program):
        self.assertEqual(run(program, EXAMPLES / "sound_part.stl")[:2], (0, "orient3d: 1\nvalid, 112 faces\n"))
        self.assertEqual(run(program, EXAMPLES / "self_crossing.off")[:2], (1, "orient3d: 1\ninvalid, 60 faces\n"))

    def test_find_package_gives_a_consumer_all_that_it_needs(self):
        build = self.folder / "cmake"
        self.succeed(self.CMAKE, "-S", CONSUMER, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                     f"-DCMAKE_CXX_COMPILER={self.COMPILER}", f"-DCMAKE_CXX_FLAGS=-I{self.clashes}")
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
        volume, certificate = ROOT / "tests" / "models" / "splines" / "two_cubes.mesh", self.folder / "volume.cert"
        self.assertEqual(self.succeed(program, volume, certificate).splitlines()[0], "VALID vmodel-1")
        self.succeed(self.prefix / "bin" / "veritope-check", volume, certificate)
        self.succeed(sys.executable, "-I", checker, volume, certificate)

    def test_pkg_config_gives_a_consumer_all_that_it_needs(self):
        program = self.folder / "by_pkg_config"
        flags = self.pkg_config("--cflags"), self.pkg_config("--libs", "--static")
        self.assertIn("-ffp-contract=off", flags[0])
        folders = [pathlib.Path(flag[2:]).resolve() for flag in flags[0] if flag.startswith("-I")]
        self.assertEqual(folders, [self.prefix.resolve() / "include"])
        self.succeed(self.COMPILER, "-std=c++20", f"-I{self.clashes}", *flags[0], CONSUMER / "main.cc", "-o", program, *flags[1])
        self.assert_consumer_works(program)

    def test_the_public_headers_are_those_of_the_table_and_all_others_are_internal(self):
        expected = [installed_name(source, self.table) for source in self.sources] + ["version.h"]
        self.assertEqual(self.headers, sorted(expected))
        self.assertEqual([name for name in self.headers if not name.startswith("internal/")], self.public)
        self.assertLess(len(self.public), len(self.headers) / 2)

    def test_an_installed_header_differs_from_that_of_the_tree_in_its_includes_only(self):
        self.assertGreater(len(self.sources), 250)
        for source in self.sources:
            installed = (self.include / installed_name(source, self.table)).read_bytes()
            self.assertTrue(installed == installed_text((ROOT / source).read_bytes(), self.table), source)

    def test_installed_headers_include_by_the_name_veritope(self):
        for header in self.headers:
            text = (self.include / header).read_text()
            self.assertEqual(re.findall(r'(?m)^[ \t]*#[ \t]*include[ \t]*"', text), [], header)
            if header != "version.h":  # it names a file that must not exist
                for name in re.findall(r"(?m)^[ \t]*#[ \t]*include[ \t]*<veritope/([^>]+)>", text):
                    self.assertIn(name, self.headers, header)

    def test_all_headers_compile_together_and_each_public_one_alone_before_folders_with_the_same_names(self):
        """tests/install/headers_test.py compiles each header of the tree alone. An installed internal one then compiles
        alone, too, if all that it includes is there."""
        flags = ["-std=c++20", f"-I{self.clashes}", *self.pkg_config("--cflags")]

        def compile_headers(place, headers):
            more = INTEROP_FLAGS if headers[0].startswith("interop/") else []
            text = "".join(f"#include <veritope/{header}>\n" for header in headers)
            return headers, self.check_syntax(f"headers_{place}.cc", text, *flags, *more)

        interop = [header for header in self.headers if header.startswith("interop/")]
        jobs = [[header for header in self.headers if header not in interop], interop, *([header] for header in self.public)]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for headers, (status, said) in pool.map(compile_headers, range(len(jobs)), jobs):
                with self.subTest(headers=headers[:3]):
                    self.assertEqual(status, 0, said)

    def test_an_older_standard_is_reported_first_and_nothing_else_is(self):
        cflags = self.pkg_config("--cflags")
        for standard in ("c++17", "c++11"):
            for name in ("predicates/orient3d.h", "io/read_model.h", "internal/splines/ring.h", "version.h"):
                status, said = self.check_syntax("old.cc", f"#include <veritope/{name}>\n", f"-std={standard}", *cflags)
                errors = [line for line in said.splitlines() if "error:" in line]
                self.assertNotEqual(status, 0)
                self.assertEqual(len(errors), 2, said)
                self.assertIn(OLD_STANDARD, errors[0])
                self.assertIn("veritope/needs_c++20", errors[1])

    def test_the_version_is_that_of_the_project(self):
        version = re.search(r"project\(veritope VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        text = (self.include / "version.h").read_text()
        macros = dict(re.findall(r"(?m)^#define VERITOPE_VERSION(_[A-Z]+|) (.*)", text))
        self.assertEqual(macros[""], f'"{version}"')
        self.assertEqual(".".join(macros[part] for part in ("_MAJOR", "_MINOR", "_PATCH")), version)
        self.assertIn(version, self.succeed(self.prefix / "bin" / "veritope", "--version"))

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

    def listings(self, language):
        return re.findall(rf"(?ms)^```{language}\n(.*?)^```\n", FUZZING_PAGE.read_text())

    def with_the_program(self, *command, **keywords):
        """The output of a command for which `veritope` is the installed program."""
        return self.succeed(*command, cwd=self.folder, env={"PATH": f"{self.prefix / 'bin'}:/usr/bin:/bin"}, **keywords)

    def test_the_listings_about_signs_find_the_wrong_signs_of_rounded_arithmetic(self):
        (c,), (python, _) = self.listings("c"), self.listings("python")
        (self.folder / "mine.c").write_text(c)
        (self.folder / "signs.py").write_text(python)
        self.succeed("cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", self.folder / "mine.c", "-o", self.folder / "mine")
        (command,) = re.findall(r"(?m)^    (veritope corpus .* --expect -)$", FUZZING_PAGE.read_text())
        said = self.with_the_program("bash", "-c", f"{command}; test $? = 1")
        cases, wrong = map(int, re.search(r"(\d+) cases, (\d+) disagreements\n\Z", said).groups())
        self.assertEqual(cases, 10000)
        self.assertGreater(wrong, 100)
        self.assertEqual(self.with_the_program(sys.executable, "signs.py"), f"{wrong} of 10000 signs are wrong\n")

    def test_the_listing_about_models_names_those_that_a_validator_gets_wrong(self):
        _, python = self.listings("python")
        (self.folder / "models.py").write_text(python)
        said = self.with_the_program(sys.executable, "models.py", "veritope", "certify", "-q")
        self.assertRegex(said, r"\Awrote  hard_meshes  \d+ models: .*\n\Z")
        shutil.rmtree(self.folder / "hard_meshes")
        _, *index = self.with_the_program(sys.executable, "models.py", "true").splitlines()
        self.assertGreater(len(index), 100)
        self.assertTrue(all("\tis\tINVALID\t" in line for line in index))

    def test_the_target_for_libfuzzer_accepts_a_right_operation_and_stops_at_a_wrong_one(self):
        (cpp,) = self.listings("cpp")
        right = "p = {p.z, p.x, p.y};"
        self.assertIn(right, cpp)
        main = """
#include <cstdio>
#include <vector>
int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::vector<std::uint8_t> bytes(1 << 20);
    std::FILE* const file = std::fopen(argv[i], "rb");
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
    std::fclose(file);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
}
"""
        cflags, libs = self.pkg_config("--cflags"), self.pkg_config("--libs", "--static")
        folder = self.folder / "seeds"
        self.with_the_program("veritope", "corpus", "--meshes", folder)
        for name, text, runs in (("right", cpp, True), ("wrong", cpp.replace(right, "p = {p.y, p.x, p.z};"), False)):
            source, program = self.folder / f"{name}_target.cc", self.folder / f"{name}_target"
            source.write_text(text + main)
            self.succeed(self.COMPILER, "-std=c++20", *cflags, source, "-o", program, *libs)
            self.assertEqual(run(program, *sorted(folder.glob("*.off")))[0] == 0, runs)
            fuzzer = shutil.which("clang++") or shutil.which("clang++-14")
            if fuzzer is None:
                continue  # the same target without libFuzzer ran above
            source.write_text(text)
            self.succeed(fuzzer, "-std=c++20", "-g", "-O1", "-fsanitize=fuzzer", *cflags, source, "-o", program, *libs)
            done = run(program, "-runs=2000", "-seed=1", f"-artifact_prefix={self.folder}/", folder)
            self.assertEqual(done[0] == 0, runs, done[2])
            if not runs:
                self.assertIn("deadly signal", done[2])

    def test_no_internal_header_and_nothing_of_the_checker_is_among_the_headers(self):
        self.assertEqual([name for name in self.headers if name.endswith("_internal.h") or "checker" in name], [])

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
        for name in ("docs/README.md", "docs/cli/certify.md", "docs/certificates/mesh.md", "docs/library.md", "LICENSE.md",
                     "LICENSES/LGPL-3.0-or-later.txt", "examples/sound_part.stl", "tests/models/m3_crack.stl"):
            self.assertTrue((self.prefix / "share" / "doc" / "veritope" / name).is_file(), name)


if __name__ == "__main__":
    Installation.BUILD, Installation.CMAKE, Installation.COMPILER = sys.argv[1:4]
    del sys.argv[1:4]
    unittest.main()
