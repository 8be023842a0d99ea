#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""--certificate and --json: where outputs go, what is refused; the checker's word: no verdict without it."""
import hashlib
import os
import shutil
import unittest

import support
from certify_itd_test import UNIT, polygons
from support import BIN, INVALID, MODELS, UNREADABLE, VALID, Folder, run


class Outputs(Folder):
    def test_the_report_describes_the_certificate(self):
        path = self.folder / "c"
        certificate = support.only_file(VALID, "--certificate", path)["certificate"]
        data = path.read_bytes()
        self.assertEqual(certificate, {"path": str(path), "sha256": hashlib.sha256(data).hexdigest(), "bytes": len(data), "checked": True})
        self.assertEqual(self.listing(), ["c"])

    def test_a_temporary_certificate_is_the_same_and_leaves_nothing(self):
        kept = support.only_file(VALID, "--certificate", self.folder / "c")["certificate"]
        temporary = support.only_file(VALID, env=self.environment)["certificate"]
        self.assertEqual({**kept, "path": None}, temporary)
        self.assertEqual(self.listing(), ["c"])

    def test_it_does_not_depend_on_the_number_of_listed_defects(self):
        # The pair of copies has the least numbers; the witness of M7 must be another pair, and is the larger one.
        model = self.folder / "copies.off"
        model.write_text("OFF 11 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n.2 .2 -1\n.2 .2 1\n.4 .3 1\n5 5 5\n.5 .1 -1\n.5 .1 .01\n.51 .1 .01\n"
                         "3 0 1 2\n3 0 1 2\n3 8 9 10\n3 4 5 6\n3 0 1 3\n3 0 2 3\n")
        certificates = set()
        for most in (0, 1, 2, 3, 20, 100000):
            kept = self.folder / "a.cert"
            self.assertEqual(run("certify", "-q", "--max-defects", most, "--certificate", kept, model).returncode, 1)
            certificates.add(kept.read_bytes())
        self.assertEqual(len(certificates), 1)

    def test_several_inputs_need_a_folder_which_may_be_new(self):
        for folder in ("new", "new", "other/"):  # the second time it exists
            done = run("certify", "-q", VALID, INVALID, UNREADABLE, "--certificate", f"{self.folder}/{folder}")
            self.assertEqual((done.returncode, done.stderr), (1, ""))
            self.assertEqual(sorted(os.listdir(self.folder / folder)), [f"{path.name}.cert" for path in (INVALID, VALID)])

    def test_one_input_may_have_an_existing_folder_or_a_new_one_with_a_slash(self):
        run("certify", VALID, "--certificate", self.folder)
        run("certify", VALID, "--certificate", f"{self.folder}/new/")
        self.assertEqual(self.listing(), [f"{VALID.name}.cert", "new", f"new/{VALID.name}.cert"])

    def test_inputs_of_one_name_keep_the_folders_that_tell_them_apart(self):
        for name in ("in/x/a.off", "in/y/a.off", "in/y/b.off", "elsewhere/a.off"):
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            support.shutil.copy(VALID, path)
        for inputs, kept in [(["in"], ["x/a.off", "y/a.off", "y/b.off"]), (["in/x/../y/a.off", "in/x/a.off"], ["x/a.off", "y/a.off"]),
                             (["in/x/a.off", "./elsewhere/a.off"], ["elsewhere/a.off", "in/x/a.off"]),
                             (["in/x/a.off", "in/y/b.off"], ["a.off", "b.off"])]:
            for again in (False, True):  # the second time the folders exist
                done = run("certify", "-q", *inputs, "--certificate", "kept", cwd=self.folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                found = sorted(str(path.relative_to(self.folder / "kept")) for path in (self.folder / "kept").rglob("*") if path.is_file())
                self.assertEqual(found, [f"{name}.cert" for name in kept])
            for name in found:
                self.assertEqual(run(VALID, self.folder / "kept" / name, program=BIN / "veritope-check").returncode, 0)
            support.shutil.rmtree(self.folder / "kept")

    def test_the_names_of_open_streams_are_written_through_and_nothing_is_replaced(self):
        out = self.folder / "out"
        for redirection, path in [(">>", "/dev/stdout"), (">>", "/dev/fd/1"), ("3>>", "/dev/fd/3"), ("2>>", "/dev/stderr"), (">>", "-")]:
            for option in ("--json", "--tsv"):
                out.write_text("old\n")
                number = out.stat().st_ino
                done = support.subprocess.run(["sh", "-c", f'"{BIN}/veritope" certify -q "{VALID}" {option} {path} {redirection}out'],
                                              cwd=self.folder, capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual((out.stat().st_ino, out.read_text()[:4]), (number, "old\n"))
                said = out.read_text()[4:]
                self.assertTrue(said.startswith('{"schema"' if option == "--json" else "file\tverdict"), said)
        self.assertEqual(run("certify", VALID, "--json", "/dev/fd/77").returncode, 4)

    def test_an_existing_certificate_is_replaced_and_a_link_is_followed(self):
        target, link = self.folder / "target", self.folder / "link"
        target.write_text("old")
        link.symlink_to(target)
        self.assertEqual(run("certify", VALID, "--certificate", link).returncode, 0)
        self.assertTrue(link.is_symlink())
        self.assertTrue(target.read_bytes().startswith(b"{"))

    def test_json_goes_to_a_file_beside_the_human_report(self):
        path = self.folder / "r.json"
        done = run("certify", VALID, "--json", path)
        self.assertTrue(done.stdout.startswith("VALID"))
        self.assertEqual(support.json.loads(path.read_text())["files"][0]["verdict"], "VALID")

    def test_json_alone_on_standard_output(self):
        done = run("certify", VALID, UNREADABLE, "--json", "-")
        self.assertEqual(done.stderr, "")
        self.assertEqual(len(support.json.loads(done.stdout)["files"]), 2)
        self.assertEqual(len(done.stdout.splitlines()), 4)

    def test_pipes_and_devices_are_written_directly(self):
        self.assertEqual(run("certify", VALID, "--json", "/dev/null", "--certificate", "/dev/null").returncode, 0)
        done = support.subprocess.run(["bash", "-c", f'"{BIN}/veritope" certify -q "{VALID}" --json >(cat; echo end) | cat'],
                                      capture_output=True, text=True)
        self.assertIn('"verdict":"VALID"', done.stdout)


class Refusals(Folder):
    def assert_refused(self, *arguments, status=2, word=""):
        before = {name: (self.folder / name).read_bytes() for name in self.listing() if (self.folder / name).is_file()}
        done = run("certify", *arguments)
        self.assertEqual((done.returncode, done.stdout), (status, ""), done.stderr)
        self.assertRegex(done.stderr, rf"^veritope: .*{word}")
        after = {name: (self.folder / name).read_bytes() for name in self.listing() if (self.folder / name).is_file()}
        self.assertEqual(before, after)

    def copy(self, name):
        return support.shutil.copy(VALID, self.folder / name)

    def test_an_output_that_is_an_input_is_refused_whatever_its_name(self):
        a, b = self.copy("a.off"), self.copy("b.off")
        os.link(a, self.folder / "hard.off")
        os.symlink(a, self.folder / "soft.off")
        for output in ("a.off", "hard.off", "soft.off", "../" + self.folder.name + "/a.off"):
            for option in ("--certificate", "--json"):
                self.assert_refused(a, option, self.folder / output, word="is the input")
        self.assert_refused(a, b, "--json", b, word="is the input")

    def test_two_outputs_that_are_one_file_are_refused(self):
        a = self.copy("a.off")
        self.assert_refused(a, "--json", self.folder / "x", "--certificate", self.folder / "x", word="both write")
        self.assert_refused(a, "--json", self.folder / "x", "--certificate", f"{self.folder}/./x", word="both write")
        os.symlink(self.folder, self.folder / "self")
        self.assert_refused(a, "--json", self.folder / "x", "--certificate", f"{self.folder}/self/x", word="both write")

    def test_a_report_where_the_folder_of_certificates_goes_is_refused(self):
        self.assert_refused(VALID, INVALID, "--json", self.folder / "x", "--certificate", self.folder / "x/", word="both make")

    def test_one_file_given_twice_would_have_one_certificate(self):
        a = self.copy("a.off")
        self.assert_refused(a, a, "--certificate", self.folder / "certificates", word="would have one certificate")
        self.assertFalse((self.folder / "certificates").exists())

    def test_an_input_that_lies_where_a_certificate_goes_is_refused(self):
        a = self.copy("a.off")
        b = self.copy("a.off.cert")
        self.assert_refused("--format", "off", a, b, "--certificate", self.folder, word="is the input")

    def test_a_file_where_a_folder_is_needed_is_refused(self):
        a, b = self.copy("a.off"), self.copy("b.off")
        (self.folder / "file").write_text("old")
        self.assert_refused(a, b, "--certificate", self.folder / "file", word="need a folder")


class Unwritable(Folder):
    """An output that cannot be written takes no verdict back."""

    def assert_verdict_beside(self, model, *arguments, words, status=4, program=BIN / "veritope", **how):
        verdict = run("certify", "-q", model, program=program, **how).stdout.splitlines()[0]
        self.assertRegex(verdict, "^(IN)?VALID ")
        done = run("certify", "-q", model, *arguments, program=program, **how)
        self.assertEqual(done.returncode, status, done)
        self.assertEqual(done.stdout.splitlines()[0].split(), verdict.split(), arguments)
        self.assertRegex(done.stderr.replace("\n", " "), f"^veritope: .*{words}")
        self.assertEqual(done.stderr.count("veritope: "), 1, "the reason is printed once: " + done.stderr)
        return done

    def test_a_folder_that_does_not_exist(self):
        for option, name in [("--picture", "x.png"), ("--json", "x"), ("--tsv", "x"), ("--certificate", "x")]:
            path = self.folder / "none" / name
            self.assert_verdict_beside(VALID, option, path, words=f"none/{name}: cannot be written: No such file")
            self.assert_verdict_beside(INVALID, option, path, words="No such file", status=1)
        self.assertEqual(self.listing(), [])

    def test_of_several_inputs_each_verdict_is_printed_and_each_certificate_named(self):
        other = VALID.with_name("m1_nearest_valid.off")
        done = run("certify", "-q", VALID, other, INVALID, "--certificate", self.folder / "none" / "new")
        self.assertEqual((done.returncode, [line.split()[0] for line in done.stdout.splitlines()]), (1, ["VALID", "VALID", "INVALID", "3"]))
        for words in ("new: the folder cannot be made", *(f"new/{m.name}.cert: cannot be written" for m in (VALID, other, INVALID))):
            self.assertIn(words, done.stderr.replace("\n", " "))
        done = run("certify", "-q", VALID, other, "--json", self.folder / "report.json", "--tsv", self.folder)
        self.assertEqual((done.returncode, self.listing()), (4, ["report.json"]))
        self.assertIn("cannot be written: it is a directory", done.stderr)

    def test_a_device_that_is_full(self):
        for option in ("--json", "--tsv", "--certificate"):
            self.assert_verdict_beside(VALID, option, "/dev/full", words="/dev/full: cannot be written: No space")
        os.symlink("/dev/full", self.folder / "full.png")
        self.assert_verdict_beside(VALID, "--picture", self.folder / "full.png", words="full.png: cannot be written: No space")
        self.assert_verdict_beside(self.polygons(), "--certificate", "/dev/full", words="/dev/full: cannot be written: No space")

    def polygons(self):
        """A file of which a copy is certified."""
        path = self.folder / "polygons.itd"
        path.write_text(polygons(UNIT))
        return path

    def test_a_copy_that_cannot_be_kept_leaves_no_certificate(self):
        model = self.polygons()
        (self.folder / "c.off").mkdir()
        self.assert_verdict_beside(model, "--certificate", self.folder / "c", words="c.off: cannot be written: it is a directory")
        done = run("certify", "-q", model, VALID, "--certificate", self.folder / "kept")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        (self.folder / "kept" / "polygons.itd.cert.off").unlink()
        (self.folder / "kept" / "polygons.itd.cert.off").mkdir()
        done = run("certify", "-q", model, VALID, "--certificate", self.folder / "kept")
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (4, "2 files: 2 valid"))
        self.assertRegex(done.stderr.replace("\n", " "), "cert.off: cannot be written: it is a directory")
        self.assertEqual(self.listing(), ["c.off", "kept", "kept/m3_nearest_valid.off.cert", "kept/polygons.itd.cert",
                                          "kept/polygons.itd.cert.off", "polygons.itd"])

    def test_a_file_in_the_place_of_a_subfolder_of_certificates(self):
        for name in ("x", "y"):
            (self.folder / name).mkdir()
            shutil.copy(VALID, self.folder / name / "a.off")
        (self.folder / "kept").mkdir()
        (self.folder / "kept" / "x").write_text("old")
        done = run("certify", "-q", self.folder / "x" / "a.off", self.folder / "y" / "a.off", "--certificate", self.folder / "kept")
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (4, "2 files: 2 valid"))
        self.assertRegex(done.stderr.replace("\n", " "), "kept/x/a.off.cert: cannot be written: Not a directory")
        self.assertEqual((self.folder / "kept" / "x").read_text(), "old")
        self.assertTrue((self.folder / "kept" / "y" / "a.off.cert").exists())

    def test_a_folder_that_another_user_may_only_read(self):
        how = {}
        if os.geteuid() == 0:  # root may write everywhere
            how["user"] = how["group"] = 65534
        self.folder.chmod(0o755)
        programs, scratch, locked = (self.folder / name for name in ("programs", "scratch", "locked"))
        for path in (programs, scratch, locked):
            path.mkdir()
        for program in ("veritope", "veritope-check"):
            shutil.copy(BIN / program, programs)
        scratch.chmod(0o777)
        shutil.copy(VALID, self.folder / "a.off")
        (self.folder / "a.off").chmod(0o644)
        locked.chmod(0o555)
        how |= {"program": programs / "veritope", "env": {**os.environ, "TMPDIR": str(scratch)}}
        for option, name in [("--picture", "x.png"), ("--json", "x"), ("--tsv", "x"), ("--certificate", "x")]:
            self.assert_verdict_beside(self.folder / "a.off", option, locked / name, words=f"locked/{name}: .*Permission denied", **how)
        self.assertEqual((os.listdir(locked), os.listdir(scratch)), ([], []))
        locked.chmod(0o755)


class Checker(Folder):
    """Other programs in the place of veritope-check."""

    def verdict_with(self, checker, model=VALID, *arguments):
        veritope = self.copy_programs(checker)
        done = run("certify", "--json", "-", model, "--certificate", self.folder / "c", *arguments, program=veritope)
        file = support.json.loads(done.stdout)["files"][0]
        support.shutil.rmtree(self.folder / "programs")
        return done.returncode, file

    def assert_no_verdict(self, checker, words):
        for model in (VALID, INVALID):
            status, file = self.verdict_with(checker, model)
            self.assertEqual((status, file["exit"], file["verdict"], file["certificate"]), (5, 5, "UNDECIDED", None))
            self.assertEqual(file["error"]["code"], "internal")
            self.assertIn(words, file["error"]["message"])
            self.assertIn("please report it", file["error"]["message"])
            self.assertIn("--no-check --certificate bug.cert", file["error"]["message"])
            self.assertEqual(self.listing(), [])

    def test_a_rejection_is_our_bug(self):
        self.assert_no_verdict('echo "REJECT V9: pair 3"; exit 1', "REJECT V9: pair 3")

    def test_a_checker_that_dies_is_our_bug(self):
        self.assert_no_verdict("kill -SEGV $$", "died by signal 11")
        self.assert_no_verdict("echo oops >&2; exit 5", "oops")

    def test_a_checker_without_memory_or_work_left_is_undecided(self):
        for checker, code in [("echo out of memory >&2; exit 3", "out-of-memory"), ("kill -KILL $$", "out-of-memory"),
                              ("echo 'REJECT B1: more work than allowed, units 7'; exit 1", "over-budget"),
                              ("echo 'REJECT C2: more work than allowed, units 7'; exit 1", "over-budget"),
                              ("echo 'REJECT C2: over a limit of this checker: 1,280 MiB of nodes'; exit 1", "over-budget")]:
            for model in (VALID, INVALID):
                with self.subTest(checker, model=model.name):
                    status, file = self.verdict_with(checker, model)
                    self.assertEqual((status, file["exit"], file["verdict"], file["error"]["code"]), (3, 3, "UNDECIDED", code))
                    self.assertEqual((file["counts"]["edges"], file["rules"]["M3"], file["defects"], file["certificate"]), (None, None, [], None))
                    self.assertEqual(self.listing(), [])

    def test_names_of_descriptors_mean_the_same_file_to_the_checker(self):
        for name in ("/dev/stdin", "/proc/self/fd/0"):
            with open(VALID) as file:
                done = run("certify", "-q", "--format", "off", name, stdin=file)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("(checked)", done.stdout)

    def test_a_checker_that_accepts_without_saying_what_is_not_believed(self):
        self.assert_no_verdict("exit 0", "said nothing")
        self.assert_no_verdict("echo ACCEPT", "ACCEPT")
        self.assert_no_verdict("echo ACCEPT mesh-valid-17; exit 0", "mesh-valid-17")
        self.assert_no_verdict("echo ACCEPT mesh-valid-1 mesh-invalid-1; exit 1", "ACCEPT")

    def test_the_claim_must_be_the_verdict(self):
        self.assertEqual(self.verdict_with("echo ACCEPT mesh-valid-1: fine")[1]["verdict"], "VALID")
        self.assertEqual(self.verdict_with("echo ACCEPT mesh-valid-1", INVALID)[0], 5)
        self.assertEqual(self.verdict_with("echo ACCEPT mesh-invalid-1", INVALID)[1]["verdict"], "INVALID")
        self.assertEqual(self.verdict_with("echo ACCEPT mesh-invalid-1")[0], 5)

    def test_a_file_that_changes_meanwhile_is_no_bug(self):
        model = support.shutil.copy(VALID, self.folder / "m.off")
        status, file = self.verdict_with(f'echo "# changed" >> "{model}"; echo "REJECT S3: hash"; exit 1', model)
        self.assertEqual((status, file["verdict"], file["error"]["code"]), (4, "UNREADABLE", "file-changed"))
        self.assertEqual((file["sha256"], file["counts"]["faces"], file["defects"]), (None, None, []))

    def test_the_words_for_a_report_of_a_bug_can_be_run(self):
        model = support.shutil.copy(MODELS / "valid_own_corners.off", self.folder / "it's odd.dat")
        message = self.verdict_with("exit 1", model, "--as-indexed", "--format", "off")[1]["error"]["message"]
        command = message.split("what this prints: ")[1].split(";")
        done = support.subprocess.run(";".join(command[:2]), shell=True, cwd=self.folder, capture_output=True, text=True,
                                      env={**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}"})
        self.assertIn("ACCEPT mesh-invalid-1", done.stdout + done.stderr)

    def test_a_bug_comes_first_among_several_files(self):
        veritope = self.copy_programs("echo 'REJECT B1: x'; exit 1")
        self.assertEqual(run("certify", "-q", UNREADABLE, VALID, program=veritope).returncode, 5)

    def test_without_a_checker_there_is_no_work_unless_no_check(self):
        veritope = self.copy_programs()
        environment = {**self.environment, "PATH": "/nonexistent"}
        environment.pop("VERITOPE_CHECK", None)
        done = run("certify", VALID, program=veritope, env=environment)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("veritope-check was found neither", done.stderr)
        self.assertEqual(run("certify", "-q", "--no-check", VALID, program=veritope, env=environment).returncode, 0)

    def test_the_checker_is_found_beside_in_libexec_in_path_or_by_name(self):
        for place in ("programs", "libexec/veritope", "libexec", "elsewhere"):
            with self.subTest(place):
                veritope = self.copy_programs()
                (self.folder / place).mkdir(parents=True, exist_ok=True)
                checker = support.shutil.copy(BIN / "veritope-check", self.folder / place)
                for environment in ({"PATH": "/nonexistent:" + str(self.folder / "elsewhere")}, {"PATH": "", "VERITOPE_CHECK": checker}):
                    done = run("certify", "-q", VALID, program=veritope, env={"TMPDIR": str(self.folder), **environment})
                    self.assertEqual(done.returncode, 0, done.stderr)
                for name in ("programs", "libexec", "elsewhere"):
                    support.shutil.rmtree(self.folder / name, ignore_errors=True)


if __name__ == "__main__":
    support.main()
