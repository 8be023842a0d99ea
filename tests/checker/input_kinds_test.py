#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Both checkers read regular files, by whatever name, and refuse everything else at once: a FIFO without a writer must not keep them
waiting. VERITOPE_CHECK names the program."""
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "checker_py"), str(ROOT / "verify" / "checker")]
import mesh_test                                          # noqa: E402

CHECKERS = {"C++": [os.environ["VERITOPE_CHECK"]], "Python": [sys.executable, str(ROOT / "verify" / "checker" / "veritope_check.py")]}

SOLID = ROOT / "tests" / "models" / "m3_nearest_valid.off"


class InputKinds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        certificates = mesh_test.CertificateTest().use(mesh_test.models.File(SOLID.read_bytes(), "off"))
        cls.proof = certificates.cert(certificates.plan(1))

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.model, self.certificate = SOLID, self.folder / "certificate"
        self.certificate.write_bytes(self.proof)

    def ask(self, checker, model, certificate, **how):
        return subprocess.run([*CHECKERS[checker], str(model), str(certificate)], capture_output=True, text=True, timeout=60, **how)

    def assert_refused(self, path):
        for checker in CHECKERS:
            for pair in ((path, self.certificate), (self.model, path)):
                with self.subTest(checker=checker, pair=pair):
                    done = self.ask(checker, *pair, stdin=subprocess.DEVNULL)
                    self.assertEqual((done.returncode, done.stdout), (4, ""), done)
                    self.assertIn(f"{path}: is not a regular file", done.stderr)

    def test_a_regular_file_is_read(self):
        for checker in CHECKERS:
            done = self.ask(checker, self.model, self.certificate)
            self.assertEqual((done.returncode, done.stdout[:6]), (0, "ACCEPT"), (checker, done))

    def test_a_fifo_without_a_writer_is_refused(self):
        os.mkfifo(self.folder / "fifo")
        self.assert_refused(self.folder / "fifo")

    def test_a_link_to_a_fifo_is_refused(self):
        os.mkfifo(self.folder / "fifo")
        (self.folder / "link").symlink_to("fifo")
        self.assert_refused(self.folder / "link")

    def test_folders_devices_and_sockets_are_refused(self):
        self.assert_refused(self.folder)
        self.assert_refused("/dev/null")
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(self.folder / "socket"))
            self.assert_refused(self.folder / "socket")

    def test_a_descriptor_of_a_regular_file_is_read(self):
        memory = os.memfd_create("model")
        self.addCleanup(os.close, memory)
        os.write(memory, SOLID.read_bytes())
        on_disk = os.open(self.certificate, os.O_RDONLY)
        self.addCleanup(os.close, on_disk)
        for checker in CHECKERS:
            for folder in ("/dev/fd", "/proc/self/fd"):
                done = self.ask(checker, f"{folder}/{memory}", f"{folder}/{on_disk}", pass_fds=(memory, on_disk))
                self.assertEqual((done.returncode, done.stdout[:6]), (0, "ACCEPT"), (checker, folder, done))


if __name__ == "__main__":
    unittest.main()
