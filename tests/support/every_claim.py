# SPDX-License-Identifier: LGPL-3.0-or-later
"""A model for every claim, as the tests of the command line and of the installation certify it."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES, MODELS = ROOT / "examples", ROOT / "tests" / "models"
PATCHES = MODELS / "patches"
# claim: the arguments of certify
COMMANDS = {
    "mesh-valid-1": (EXAMPLES / "sound_part.stl",),
    "mesh-invalid-1": (EXAMPLES / "self_crossing.off",),
    "mesh-reversed-1": (MODELS / "m9_inside_out.off", "--orient", "auto"),
    "star-box-1": (EXAMPLES / "quarter_pipe.itd",),
    "star-box-turned-1": (PATCHES / "shell_turned_smallest.itd", "--orient", "keep"),
    "star-box-2": (PATCHES / "shell_turned_thin_nearest_valid.itd",),
    "star-box-turned-2": (PATCHES / "shell_turned_thin.itd", "--orient", "keep"),
    "patch-invalid-1": (PATCHES / "side_open_smallest.itd",),
    "patch-invalid-2": (PATCHES / "singular_line_smallest.itd",),
    "collar-1": (EXAMPLES / "quarter_pipe.itd", "--collar"),
    "collar-2": (PATCHES / "normals_zero_at_corners.itd", "--collar"),
}


def output_of(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, check=False)
    return done.returncode, done.stdout + done.stderr


def claims_of(checker):
    """The names that a checker prints for --claims. checker: a command."""
    status, text = output_of(*checker, "--claims")
    assert status == 0, text
    return [line.split(" ")[0] for line in text.splitlines()]


def assert_every_claim(test, veritope, checkers, folder):
    """test: a TestCase; veritope: the program that certifies; checkers: commands; folder: where files may be written. Every claim that
    a checker decides is certified, and every checker accepts the certificate. A claim without a row in COMMANDS fails."""
    for checker in checkers:
        test.assertEqual(sorted(claims_of(checker)), sorted(COMMANDS), f"{checker}: claims, and those that this test covers")
    for claim, (model, *options) in COMMANDS.items():
        with test.subTest(claim):
            subject, certificate = folder / f"{claim}{model.suffix}", folder / f"{claim}.cert"
            subject.write_bytes(model.read_bytes())
            status, text = output_of(veritope, "certify", "--no-check", subject, *options, "--certificate", certificate)
            test.assertIn(status, (0, 1), text)
            for checker in checkers:
                status, text = output_of(*checker, subject, certificate)
                test.assertEqual((status, text.split(":")[0].strip()), (0, f"ACCEPT {claim}"), f"{checker}: {text}")
                damaged = folder / "damaged.cert"
                damaged.write_bytes(certificate.read_bytes()[:-1])
                test.assertEqual(output_of(*checker, subject, damaged)[0], 1, checker)
