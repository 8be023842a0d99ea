#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Signals, full disks, closed pipes: no partial file, old files as they were, a clear message."""
import os
import random
import resource
import signal
import subprocess
import sys
import time
import unittest

import support
from support import BIN, INVALID, MODELS, VALID, Folder, run


def is_running(pid):
    try:
        with open(f"/proc/{pid}/stat") as file:
            return ") Z " not in file.read()
    except OSError:
        return False


ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU)


class Signals(Folder):
    def start(self, *arguments, program=BIN / "veritope", action=signal.SIG_DFL, **how):
        def set_actions():
            for number in ENDING:
                signal.signal(number, action)
        return subprocess.Popen([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=self.environment, preexec_fn=set_actions, **how)

    def assert_ended(self, child, number):
        out, err = child.communicate(timeout=60)
        self.assertEqual((child.returncode, out), (-number, ""))
        self.assertRegex(err, r"^veritope: (interrupted \(SIGINT\)|ended by a signal)\n$")

    def test_a_signal_while_the_checker_runs_ends_both_and_leaves_nothing(self):
        pids = self.folder / "pid"
        veritope = self.copy_programs(f'echo $$ > "{pids}"; exec sleep 60')
        old = self.folder / "old.cert"
        old.write_text("old")
        before = self.listing()
        for number in ENDING:
            with self.subTest(number.name):
                child = self.start("certify", VALID, "--certificate", old, "--json", self.folder / "r", program=veritope)
                while not (pids.exists() and pids.read_text().strip()):
                    time.sleep(0.01)
                child.send_signal(number)
                self.assert_ended(child, number)
                checker = int(pids.read_text())
                pids.unlink()
                deadline = time.monotonic() + 10
                while is_running(checker):
                    self.assertLess(time.monotonic(), deadline, "the checker still runs")
                    time.sleep(0.01)
                self.assertEqual((old.read_text(), self.listing()), ("old", before))

    def test_signals_that_were_ignored_from_the_start_are_ignored(self):
        child = self.start("certify", "-q", "--format", "off", "-", action=signal.SIG_IGN, stdin=subprocess.PIPE)
        for number in ENDING:
            time.sleep(0.1)
            child.send_signal(number)
        out, err = child.communicate(VALID.read_text(), timeout=60)
        self.assertEqual((child.returncode, err), (0, ""))
        self.assertTrue(out.startswith("VALID"), out)

    def test_a_signal_while_standard_input_is_read(self):
        child = self.start("certify", "--format", "off", "-", "--certificate", self.folder / "c", stdin=subprocess.PIPE)
        child.stdin.write("OFF\n")
        child.stdin.flush()
        time.sleep(0.2)
        child.send_signal(signal.SIGINT)
        self.assert_ended(child, signal.SIGINT)
        self.assertEqual(self.listing(), [])

    def test_signals_at_any_time_of_a_large_run_leave_the_old_file_or_the_new_one(self):
        model = support.write_off(self.folder / "large.off", *support.grid(70))
        old = self.folder / "c"
        begin = time.monotonic()
        run("certify", model, "--certificate", old, env=self.environment)
        length, new = time.monotonic() - begin, old.read_bytes()
        choose, ended = random.Random(4), 0
        for _ in range(8):
            old.write_bytes(b"old")
            child = self.start("certify", model, "--certificate", old)
            time.sleep(choose.random() * length)
            child.send_signal(signal.SIGINT)
            child.communicate(timeout=60)
            self.assertIn(child.returncode, (0, -signal.SIGINT))
            ended += child.returncode != 0
            self.assertIn(old.read_bytes(), (b"old", new))
            self.assertEqual(self.listing(), ["c", "large.off"])
        self.assertGreater(ended, 0)

    def test_a_convert_that_is_interrupted_leaves_nothing(self):
        model = support.write_off(self.folder / "large.off", *support.grid(70))
        choose = random.Random(5)
        for _ in range(8):
            child = self.start("convert", model, self.folder / "new.obj")
            time.sleep(choose.random() * 0.1)
            child.send_signal(signal.SIGTERM)
            child.communicate(timeout=60)
            whole = ["large.off", "new.obj"] if child.returncode == 0 else ["large.off"]
            self.assertIn(self.listing(), (whole, ["large.off", "new.obj"]))
            (self.folder / "new.obj").unlink(missing_ok=True)


class FullDisk(Folder):
    def assert_not_written(self, done, status=4):
        self.assertEqual(done.returncode, status)
        self.assertRegex(done.stderr, r"^veritope: .*(No space left on device|File too large)")

    def test_a_full_standard_output_is_status_4(self):
        for arguments in (["certify", VALID], ["certify", VALID, "--json", "-"], ["info", VALID], ["explain", "M1"], ["--help"],
                          ["convert", VALID, "-", "--to", "obj"]):
            with open("/dev/full", "w") as full:
                done = subprocess.run([BIN / "veritope", *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assert_not_written(done)
        with open("/dev/full", "w") as full:
            done = subprocess.run([BIN / "veritope", "certify", INVALID], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assert_not_written(done, status=1)

    def test_a_full_device_is_status_4_and_the_verdict_is_printed(self):
        for option in ("--json", "--certificate"):
            done = run("certify", VALID, option, "/dev/full")
            self.assert_not_written(done)
            self.assertTrue(done.stdout.startswith("VALID"))
        file = support.only_file(VALID, "--certificate", "/dev/full")
        self.assertEqual((file["verdict"], file["exit"], file["error"]["code"]), ("VALID", 4, "cannot-write"))
        self.assertEqual(file["certificate"]["path"], None)

    def limited(self, *arguments, size):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        return run(*arguments, preexec_fn=limit, env=self.environment)

    def test_a_disk_that_fills_up_leaves_no_partial_file_and_the_old_one(self):
        old = self.folder / "old"
        old.write_text("old")
        model = MODELS / "valid_frame.off"
        done = self.limited("certify", "--no-check", model, "--certificate", old, size=500)
        self.assert_not_written(done)
        done = self.limited("certify", "--no-check", model, "--json", old, size=500)
        self.assert_not_written(done)
        done = self.limited("convert", model, old, "--to", "obj", size=100)
        self.assert_not_written(done)
        self.assertEqual((old.read_text(), self.listing()), ("old", ["old"]))

    def test_a_full_folder_for_temporary_files_is_named(self):
        file = support.json.loads(self.limited("certify", VALID, "--json", "-", size=500).stdout)["files"][0]
        self.assertEqual((file["verdict"], file["exit"], file["error"]["code"]), ("UNDECIDED", 4, "cannot-write"))
        self.assertIn("TMPDIR", file["error"]["message"])
        self.environment["TMPDIR"] = "/nonexistent"
        self.assertEqual(run("certify", VALID, env=self.environment).returncode, 4)

    @unittest.skipUnless(os.geteuid() == 0, "needs root to mount a small file system")
    def test_a_small_file_system(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", disk], capture_output=True).returncode != 0:
            self.skipTest("mounting is not allowed here")
        try:
            (disk / "old.obj").write_text("old")
            model = support.write_off(self.folder / "large.off", *support.grid(40))
            for arguments in (["certify", model, "--certificate", disk / "c"], ["convert", model, disk / "old.obj"]):
                done = run(*arguments)
                self.assert_not_written(done)
            self.assertEqual(sorted(os.listdir(disk)), ["old.obj"])
            self.assertEqual((disk / "old.obj").read_text(), "old")
        finally:
            subprocess.run(["umount", disk], check=True)


class ClosedStreams(Folder):
    def test_a_reader_that_goes_away_is_no_error(self):
        certificate = self.folder / "c"
        for first in ("true", "head -c 1"):
            done = subprocess.run(["bash", "-c", f'"{BIN}/veritope" certify "{INVALID}" "{VALID}" --certificate "{certificate}" | {first};'
                                   ' echo "${PIPESTATUS[0]}"'], capture_output=True, text=True)
            self.assertEqual((done.stdout.split("\n")[-2][-1], done.stderr), ("1", ""))
            self.assertEqual(len(os.listdir(certificate)), 2)

    def test_closed_standard_streams_harm_no_file(self):
        out = self.folder / "c"
        done = subprocess.run(["bash", "-c", f'"{BIN}/veritope" certify "{VALID}" --certificate "{out}" <&- >&- 2>&-'])
        self.assertEqual(done.returncode, 4, "the verdict could not be printed")
        self.assertEqual(run(VALID, out, program=BIN / "veritope-check").returncode, 0)

    def test_output_to_a_closed_stream_is_not_lost_in_silence(self):
        done = subprocess.run(["bash", "-c", f'"{BIN}/veritope" certify --json - "{VALID}" >&-'], capture_output=True, text=True)
        self.assertEqual(done.returncode, 4)
        self.assertIn("standard output", done.stderr)

    def test_a_checker_whose_answer_cannot_be_printed_gives_none(self):
        certificate = self.folder / "c"
        run("certify", "-q", VALID, "--certificate", certificate)
        for program in ([BIN / "veritope-check"], [sys.executable, support.CHECKER_PY]):
            with open("/dev/full", "w") as full:
                done = subprocess.run([*program, VALID, certificate], stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 4)


if __name__ == "__main__":
    support.main()
