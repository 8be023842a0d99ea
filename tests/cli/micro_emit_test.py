#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""veritope micro --emit: composed surfaces that certify accepts, and files that appear complete or not at all."""
import json
import random
import resource
import signal
import subprocess
import time
import unittest

import schema
import support
from support import BIN, run


class MicroEmit(support.Folder):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out.vmicro"
        self.box = self.volumes("box", {"op": "box", "min": [0, 0, 0], "max": [2, 3, 4]})

    def command(self, *arguments, cage=None, counts="2,1,1", tile="jack,degree=1"):
        return ["micro", "--cage", cage or self.box, "--tile", tile, "--counts", counts, "-o", self.out, *arguments]

    def emit(self, path, *arguments, **how):
        done = run(*self.command("--emit", path, "--json", "-", *arguments, **how), timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(schema.faults(report), [])
        return report

    def test_the_composed_surface_is_certified_and_has_the_numbers_of_the_structure(self):
        cone = self.volumes("cone", {"op": "cone", "bottom": 2, "top": 1, "height": 3})
        for cage, counts, thickness in ((self.box, "2,1,2", ()), (self.box, "2,1,1", ("--thickness", "1/8+x/40")), (cone, "1,1,1", ())):
            path = self.folder / "surface.vjson"
            report = self.emit(path, *thickness, cage=cage, counts=counts)
            file = support.only_file(path, timeout=600)
            self.assertEqual((file["verdict"], file["sha256"], file["bytes"]), ("VALID", report["composed"]["file"]["sha256"], report["composed"]["file"]["bytes"]))
            self.assertLessEqual(report["volume"]["lo"], file["volume"]["hi"])
            self.assertGreaterEqual(report["volume"]["hi"], file["volume"]["lo"])
            self.assertEqual((file["counts"]["genus"], file["counts"]["shells"], file["counts"]["patches"]), (report["genus"], report["shells"], report["composed"]["patches"]))

    def test_formats_hold_the_same_patches_for_every_number_of_jobs(self):
        for ending in ("vjson", "itd", "vtu"):
            path = self.folder / f"surface.{ending}"
            texts = []
            for jobs in (1, 2):
                report = self.emit(path, "--jobs", jobs, counts="5,8,8")
                texts.append(path.read_bytes())
            self.assertEqual(texts[0], texts[1])
            patches = report["composed"]["patches"]
            if ending == "vtu":
                self.assertIn(f'NumberOfCells="{patches}"'.encode(), texts[0])
                types = texts[0].split(b'Name="types"')[1].split(b"</DataArray>")[0].splitlines()[1:]
                self.assertEqual((len(types), set(types)), (patches, {b"77"}))
            else:
                (info,) = json.loads(run("info", path, "--json", "-").stdout)["files"]
                self.assertEqual(info["counts"]["entities"], patches)

    def test_without_tiles_nothing_is_emitted(self):
        small, path = self.folder / "small.off", self.folder / "surface.vjson"
        ends = ("0.1", "0.2")
        small.write_text("OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in ends for y in ends for x in ends) +
                         "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")
        report = self.emit(path, "--model", small)
        self.assertEqual((report["tiles"]["kept"], report["composed"], report["volume"]), (0, None, None))
        self.assertFalse(path.exists())

    def test_names_that_cannot_be_written_are_refused_before_anything_is(self):
        path = self.folder / "surface.vjson"
        before = self.listing()
        for emit, status in (("-", 2), (self.folder / "surface.stl", 2), (self.out, 2), (self.box, 2), (self.folder / "none" / "s.vjson", 4), (self.folder, 2)):
            self.assertEqual(run(*self.command("--emit", emit)).returncode, status, emit)
        for others in (("--list", path), ("--json", path), ("--mesh", path, "--chord", "1")):
            self.assertEqual(run(*self.command("--emit", path, *others)).returncode, 2, others)
        self.assertEqual(self.listing(), before)

    def test_a_full_disk_leaves_nothing(self):
        before = self.listing()
        done = run(*self.command("--emit", self.folder / "surface.vjson"), preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)))
        self.assertEqual(done.returncode, 4)
        self.assertIn("surface.vjson", done.stderr)
        self.assertEqual(self.listing(), before)

    def test_an_interrupted_run_leaves_the_old_files(self):
        path = self.folder / "surface.vjson"
        begin = time.monotonic()
        run(*self.command("--emit", path, counts="6,6,6"), timeout=600)
        length, new = time.monotonic() - begin, path.read_bytes()
        choose, before = random.Random(7), self.listing()
        for _ in range(6):
            path.write_bytes(b"old")
            child = subprocess.Popen([BIN / "veritope", *map(str, self.command("--emit", path, counts="6,6,6"))], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(choose.random() * length)
            child.send_signal(signal.SIGINT)
            child.wait(60)
            self.assertIn(child.returncode, (0, -signal.SIGINT))
            self.assertIn(path.read_bytes(), (b"old", new))
            self.assertEqual(self.listing(), before)


if __name__ == "__main__":
    unittest.main()
