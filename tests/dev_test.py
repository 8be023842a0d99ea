#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""./dev installs what is missing or stops before it changes anything. apt-get, dpkg-query, sudo, id and cmake are stand-ins that write
down how they were called; no package is touched."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent

STAND_INS = {
    "id": 'echo "${FAKE_UID}"',
    "dpkg-query": 'for name; do :; done; grep -qx "$name" installed && echo installed',
    "sudo": '[ "$FAKE_SUDO" = yes ] || exit 1; [ "$1" != -n ] || shift; exec "$@"',
    "cmake": 'exit "${FAKE_CMAKE}"',
    "ctest": "exit 0",
    "apt-get": """while [ "$1" = -o ]; do shift 2; done
case " $* " in
  *" update "*) touch lists ;;
  *) [ -e lists ] && [ "$FAKE_ARCHIVE" = yes ] || exit 100
     case " $* " in *" --simulate "*) ;; *) for name; do case $name in -*|install) ;; *) echo "$name" >> installed ;; esac; done ;; esac ;;
esac""",
}


def listed(section):
    text = re.sub(r"#.*", "", (ROOT / "tools" / "packages.txt").read_text())
    return re.search(rf"(?ms)^\[{section}\]\s*\n(.*?)(?=^\[|\Z)", text)[1].split()


class Packages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, body in STAND_INS.items():
            path = self.folder / name
            path.write_text(f'#!/bin/sh\ncd "{self.folder}"\necho "{name} $*" >> calls\n{body}\n')
            path.chmod(0o755)
        self.set_installed(listed("build"))

    def set_installed(self, names):
        (self.folder / "installed").write_text("".join(name + "\n" for name in names))

    def dev(self, *arguments, uid="0", sudo="no", archive="yes", lists=False, cmake=9):
        """(status, error text, the calls of apt-get, cmake and ctest)"""
        if lists:
            (self.folder / "lists").touch()
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}", "FAKE_UID": uid, "FAKE_SUDO": sudo,
                       "FAKE_ARCHIVE": archive, "FAKE_CMAKE": str(cmake)}
        environment.pop("VERITOPE_SKIP_PACKAGES", None)
        done = subprocess.run([ROOT / "dev", *arguments], cwd="/", env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        calls = (self.folder / "calls").read_text().splitlines() if (self.folder / "calls").exists() else []
        return done.returncode, done.stderr, [call for call in calls if call.startswith(("apt-get", "cmake", "ctest"))]

    # With cmake's stand-in failing, exit 1 after a cmake call means: the packages were found in order.

    def test_nothing_is_asked_of_apt_when_nothing_is_missing(self):
        status, _, calls = self.dev("build")
        self.assertEqual(status, 1)
        self.assertEqual([call.split()[0] for call in calls], ["cmake"])

    def test_without_root_and_sudo_it_names_the_packages_and_changes_nothing(self):
        self.set_installed(listed("build")[2:])
        for command in ("demo", "test"):
            status, error, calls = self.dev(command, uid="1000")
            self.assertEqual(status, 2)
            self.assertIn(" ".join(listed("build")[:2]), error)
            self.assertEqual(calls, [])

    def test_root_and_sudo_install_what_is_missing_and_nothing_else(self):
        for uid, sudo in (("0", "no"), ("1000", "yes")):
            self.set_installed(listed("build")[3:])
            (self.folder / "calls").unlink(missing_ok=True)
            status, _, calls = self.dev("build", uid=uid, sudo=sudo, lists=True)
            self.assertEqual(status, 1)
            self.assertEqual(calls[-1].split()[0], "cmake")
            self.assertFalse([call for call in calls if " update" in call])
            installs = [call for call in calls if " install " in call and "--simulate" not in call]
            self.assertEqual(len(installs), 1)
            self.assertTrue(installs[0].endswith(" --no-install-recommends " + " ".join(listed("build")[:3])), installs[0])

    def test_the_lists_are_updated_only_if_they_do_not_know_a_package(self):
        self.set_installed(listed("build")[1:])
        _, _, calls = self.dev("build")
        self.assertEqual(sum(" update" in call for call in calls), 1)
        self.assertEqual(calls[-1].split()[0], "cmake")

    def test_an_archive_that_lacks_a_package_is_exit_2_and_nothing_is_installed(self):
        self.set_installed(listed("build")[1:])
        status, error, calls = self.dev("build", archive="no")
        self.assertEqual(status, 2)
        self.assertIn(listed("build")[0], error)
        self.assertTrue(all("--simulate" in call or " update" in call for call in calls), calls)

    def test_each_tier_of_tests_runs_those_before_it(self):
        tiers = {"quick": ["quick"], "": ["quick", "standard"], "full": ["quick", "standard", "full"]}
        for argument, labels in tiers.items():
            (self.folder / "calls").unlink(missing_ok=True)
            status, _, calls = self.dev("test", *argument.split(), cmake=0)
            self.assertEqual(status, 0)
            ran = [re.search(r" -L \^(\w+)\$ ", call)[1] for call in calls if call.startswith("ctest")]
            self.assertEqual(ran, labels)

    def test_wrong_usage_is_exit_2(self):
        for arguments in (["nonsense"], ["demo", "x"], ["test", "all"], ["test", "quick", "full"], ["bench", "a", "b"],
                          ["fuzz", "a", "b", "c"], ["fuzz", "a", "soon"]):
            status, error, calls = self.dev(*arguments)
            self.assertEqual((status, calls), (2, []), arguments)
            self.assertIn("./dev demo", error)


if __name__ == "__main__":
    unittest.main()
