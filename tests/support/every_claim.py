# SPDX-License-Identifier: LGPL-3.0-or-later
"""A model for every claim and one for every format of spline models, as the tests of the command line and of the installation certify
them."""
import itertools
import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES, MODELS = ROOT / "examples", ROOT / "tests" / "models"
PATCHES = MODELS / "patches"
# claim: the arguments of certify; those in POINTS are of classify
COMMANDS = {
    "mesh-valid-1": (EXAMPLES / "sound_part.stl",),
    "mesh-invalid-1": (EXAMPLES / "self_crossing.off",),
    "mesh-reversed-1": (MODELS / "m9_inside_out.off", "--orient", "auto"),
    "points-1": (MODELS / "valid_frame.off",),
    "star-box-1": (EXAMPLES / "quarter_pipe.itd",),
    "star-box-turned-1": (PATCHES / "shell_turned_smallest.itd", "--orient", "keep"),
    "star-box-2": (PATCHES / "shell_turned_thin_nearest_valid.itd",),
    "star-box-turned-2": (PATCHES / "shell_turned_thin.itd", "--orient", "keep"),
    "patch-invalid-1": (PATCHES / "side_open_smallest.itd",),
    "patch-invalid-2": (PATCHES / "singular_line_smallest.itd",),
    "volume-folded-1": (PATCHES / "volume_folded_smallest.itd",),
    "collar-1": (EXAMPLES / "quarter_pipe.itd", "--collar"),
    "collar-2": (pathlib.Path(__file__).parent / "normals_zero_at_corners.itd", "--collar"),
    "vmodel-1": (PATCHES / "left_handed_nearest_valid.itd", "--orient", "auto"),
    "vmodel-invalid-1": (PATCHES / "left_handed_smallest.itd", "--orient", "keep"),
    "microstructure-1": (MODELS / "micro" / "three_cells.vmicro",),
    "dms-solid-1": (MODELS / "dms" / "inner_clouds.vdms",),
    "dms-solid-2": (MODELS / "dms" / "outward_clouds.vdms",),
    "dms-invalid-1": (MODELS / "dms" / "folded.vdms",),
    "micro-inside-1": (MODELS / "micro" / "three_cells.vmicro",),
}


# claim: the points that are classified
POINTS = {"points-1": "0 0 0\n0.5 0.25 1/3\n1e3 0 0\n"}


# claim: the solid in whose interior the model lies, an OFF file: a box with a bubble in a corner of the first cell
SOLIDS = {"micro-inside-1": "OFF\n16 12 0\n" + "".join(
    f"{x} {y} {z}\n" for lo, hi in ((-1, 4), (.0625, .125)) for x, y, z in itertools.product((lo, hi), repeat=3)) + "".join(
    f"4 {' '.join(str(i + at) for i in face[::turn])}\n" for at, turn in ((0, 1), (8, -1))
    for face in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)))}


# The unit cube: corner number i; its faces, outward, each by its corners, u fastest.
CORNERS = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
FACES = ((0, 2, 1, 3), (4, 5, 6, 7), (0, 1, 4, 5), (2, 6, 3, 7), (0, 4, 2, 6), (1, 3, 5, 7))


def nets(of_volumes):
    """The control points of the cube as one volume or as its six faces."""
    return [[CORNERS[i] for i in net] for net in ((range(8),) if of_volumes else FACES)]


def as_vjson(of_volumes):
    n, kind = (3, "volume") if of_volumes else (2, "surface")
    order = [sum(i << k for k, i in enumerate(index)) for index in itertools.product((0, 1), repeat=n)]     # the last axis fastest
    shapes = [{"degrees": [1] * n, "periodic": [False] * n, "knots": [["0", "0", "1", "1"]] * n, "rational": False, "components": 3,
               "points": [[str(x) for x in net[i]] for i in order]} for net in nets(of_volumes)]
    entities = [{"kind": kind, "group": None, "attributes": [], "shape": shape} for shape in shapes]
    return ".vjson", json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities})


def as_itd(of_volumes):
    head = "[TRIVAR BEZIER 2 2 2 E3" if of_volumes else "[SURFACE BEZIER 2 2 E3"
    return ".itd", "".join(head + "".join(" [%d %d %d]" % p for p in net) + "]\n" for net in nets(of_volumes))


def as_g2(of_volumes):
    head = "700 1 0 0\n3 0\n" + 3 * "2 2\n0 0 1 1\n" if of_volumes else "200 1 0 0\n3 0\n" + 2 * "2 2\n0 0 1 1\n"
    return ".g2", "".join(head + "".join("%d %d %d\n" % p for p in net) for net in nets(of_volumes))


def as_mfem(of_volumes):
    n, shapes = 3 if of_volumes else 2, nets(of_volumes)
    patches = "".join("1 %d %s\n" % (2 * n - 1, " ".join(str(k * 2 ** n + i) for i in range(2 ** n))) for k in range(len(shapes)))
    text = "MFEM NURBS mesh v1.0\ndimension\n%d\nelements\n%d\n%sboundary\n0\nedges\n0\nvertices\n%d\npatches\n" % (n, len(shapes), patches, len(shapes) << n)
    for net in shapes:
        text += "knotvectors\n%d\n%sdimension\n3\ncontrolpoints\n" % (n, n * "1 2 0 0 1 1\n") + "".join("%d %d %d 1\n" % p for p in net)
    return ".mesh", text


# format of statements: the cube's text, whether as a volume
FORMATS = {name + faces: (text, bool(faces)) for name, text in (("vjson", as_vjson), ("itd", as_itd), ("g2", as_g2), ("mfem", as_mfem)) for faces in ("", "-faces")}


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
            answers = ()
            if claim in POINTS:
                points, answers = folder / f"{claim}.points", (folder / f"{claim}.answers",)
                points.write_text(POINTS[claim])
                command = "classify", "--no-check", subject, points, "-o", *answers
            elif claim in SOLIDS:
                solid = folder / f"{claim}.off"
                solid.write_text(SOLIDS[claim])
                answers = ("--model", solid)
                command = "certify", "--no-check", subject, *answers
            else:
                command = "certify", "--no-check", subject
            status, text = output_of(veritope, *command, *options, "--certificate", certificate)
            test.assertIn(status, (0, 1), text)
            for checker in checkers:
                status, text = output_of(*checker, subject, certificate, *answers)
                test.assertEqual((status, text.split(":")[0].strip()), (0, f"ACCEPT {claim}"), f"{checker}: {text}")
                damaged = folder / "damaged.cert"
                damaged.write_bytes(certificate.read_bytes()[:-1])
                test.assertEqual(output_of(*checker, subject, damaged, *answers)[0], 1, checker)
    assert_every_format(test, veritope, checkers, folder)
    assert_expression(test, veritope, checkers, folder)


def assert_expression(test, veritope, checkers, folder):
    """Answers about a chain file, whose format only this claim has: the checkers read the operand beside it."""
    operand, chain, points, answers, certificate = (folder / f"expression.{end}" for end in ("off", "json", "points", "answers", "cert"))
    operand.write_bytes((MODELS / "valid_frame.off").read_bytes())
    points.write_text(POINTS["points-1"])
    for command in (("boolean", "--no-check", "!A & A", f"A={operand}", "-o", chain),
                    ("classify", "--no-check", chain, points, "-o", answers, "--certificate", certificate)):
        status, text = output_of(veritope, *command)
        test.assertEqual(status, 0, text)
    for checker in checkers:
        status, text = output_of(*checker, chain, certificate, answers)
        test.assertEqual((status, text.split(":")[0].strip()), (0, "ACCEPT points-1"), f"{checker}: {text}")
    operand.write_bytes(operand.read_bytes() + b"\n")
    for checker in checkers:
        test.assertEqual(output_of(*checker, chain, certificate, answers)[0], 1, checker)


def formats_of(checker):
    """The formats of spline models that a checker prints for --claims."""
    lists = [line.split(" ")[2].split(",") for line in output_of(*checker, "--claims")[1].splitlines()]
    return {name for names in lists if "vjson" in names for name in names} - {"stl", "obj", "ply", "off", "chain"}


def assert_every_format(test, veritope, checkers, folder):
    """A cube in every format is certified in its own bytes, and every checker accepts the certificate, for this cube and no other. A
    format without a row in FORMATS fails."""
    for checker in checkers:
        test.assertEqual(formats_of(checker), set(FORMATS), f"{checker}: formats, and those that this test covers")
    for name, (text_of, of_volumes) in FORMATS.items():
        with test.subTest(name):
            suffix, text = text_of(of_volumes)
            subject, certificate = folder / f"{name}{suffix}", folder / f"{name}.cert"
            subject.write_text(text)
            # A collar of volumes is one of their boundary faces.
            claim, options = ("collar-1", ("--collar",)) if of_volumes else ("star-box-1", ())
            status, words = output_of(veritope, "certify", "--no-check", subject, *options, "--certificate", certificate)
            test.assertEqual(status, 0, words)
            statement = json.loads(certificate.read_bytes().split(b"\n", 1)[0])
            test.assertEqual((statement["subject_format"], statement["subject_bytes"]), (name, len(text.encode())))
            for checker in checkers:
                status, words = output_of(*checker, subject, certificate)
                test.assertEqual((status, words.split(":")[0].strip()), (0, f"ACCEPT {claim}"), f"{checker}: {words}")
                other = folder / f"other{suffix}"
                other.write_text(text.replace("1", "2"))
                test.assertEqual(output_of(*checker, other, certificate)[:1], (1,), checker)
