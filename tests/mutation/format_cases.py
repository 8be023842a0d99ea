# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models in .g2 and MFEM's format, and models of volumes in all formats, with certificates: written in odd ways that mean the same, or
damaged. For patch_differential.py."""
import random
import re
from fractions import Fraction as Q

import patch_solids as ps                                 # and the way to the forges
import fold_liars
import mfem_blocks
import model_faces_test as volumes_of_tests
import model_texts as texts
import model_volumes as volumes

WORD = re.compile(rb"[^ \t\n\r\x0b\x0c]+")
G2 = [b"200", b"700", b"100", b"210", b"0", b"1", b"2", b"3", b"4", b"-1", b"+2", b"002", b"2.", b"64", b"65", b"1000", b"1001", b"9" * 20, b"4611686018427387904", b"4611686018427387905", b"1 0", b"#",
      b"\x00", b"\xff", b"\x1c", b"\x85", b"\xef\xbb\xbf", b""]
MFEM = [b"MFEM", b"NURBS", b"mesh", b"v1.0", b"v1.1", b"dimension", b"elements", b"boundary", b"edges", b"vertices", b"patches", b"knotvectors", b"weights", b"unitweights", b"autoweights", b"spacing",
        b"refinements", b"knotvector_refinements", b"FiniteElementSpace", b"FiniteElementCollection:", b"NURBS1", b"NURBS2", b"NURBS01", b"VDim:", b"Ordering:", b"controlpoints", b"controlpoints_cartesian",
        b"controlpoints_homogeneous", b"#", b"# 1\n", b"#\r", b"0", b"1", b"2", b"3", b"4", b"5", b"7", b"8", b"-1", b"+1", b"00", b"1.", b"64", b"9" * 20, b"4611686018427387905", b"\xef\xbb\xbf", b"\x00"]
AXES = (texts.bezier_knots(1), texts.bezier_knots(2), [0, 0, 1, 3, 3])


# ---------------------------------------------------------------- what means the same

def odd_text(data, subject_format, rng):
    """The text with other blanks, signs, zeros in front, and comments."""
    out, is_mfem = [], subject_format.startswith("mfem")
    for word in WORD.findall(re.sub(rb"#[^\n]*", b"", data) if is_mfem else data):
        if word[:1].isdigit() and rng.random() < .2:
            word = rng.choice((b"+", b"0", b"000", b"+0")) + word
        blank = rng.choice((b" ", b" ", b" ", b"\n", b"\t", b"\r\n", b"\x0b", b"\x0c", b"  \n"))
        if is_mfem and rng.random() < .02:
            blank = rng.choice((b"# 1 2\n", b"#\r", b" ## x\r\n", b"#\xff\n"))
        out += [word, blank]
    return (b"\xef\xbb\xbf" if rng.random() < .1 else b"") + b"".join(out)


def surfaces(entities, subject_format, rng):
    """The text of a model of surfaces; KeyError for one with triangles, ValueError for numbers that are not decimals."""
    maps = [texts.map_of(entity) for entity in entities]
    if subject_format == "g2":
        return odd_text(texts.g2_text(maps), subject_format, rng)
    return odd_text(texts.mfem_text(maps, rng.choice(("controlpoints", "controlpoints_homogeneous"))), subject_format, rng)


def proved(maps):
    """(maps, the plan of a certificate about their faces)."""
    return maps, volumes_of_tests.forge.Prover([f.entity() for f in volumes.faces(maps)]).prove().plan


def lattice(seed):
    """A bar of two or three blocks whose patches share control points: (maps, text, plan)."""
    rng = random.Random(seed)
    blocks = mfem_blocks.Blocks(rng, (rng.choice((2, 3)), 1, 1), [(t.count(t[0]) - 1, t) for t in rng.choices(AXES, k=3)], spare_vertices=rng.choice((0, 2)))
    maps = list(blocks.maps(lambda p: [Q(c) for c in p], lambda p: Q(1)))
    return maps, blocks.text(lambda p: [Q(c) for c in p], None if seed % 2 else lambda p: Q(1), seed // 2 % 2).encode(), proved(maps)[1]


def once(key, make):
    """make(), for each process once: proofs take a search."""
    if key not in ps.MADE:
        ps.MADE[key] = make()
    return ps.MADE[key]


def solid(n, is_rational):
    maps = volumes_of_tests.Formats.SOLIDS[n][1]
    return proved([volumes.made_rational(m) for m in maps] if is_rational else maps)


def volume_model(rng):
    """(subject format, text, plan)."""
    if rng.random() < .3:
        seed = rng.randrange(6)
        maps, text, plan = once(("lattice", seed), lambda: lattice(seed))
        return "mfem-faces", odd_text(text, "mfem", rng), plan
    n, subject_format = rng.choice((0, 0, 1, 1, 3)), rng.choice(("vjson", "itd", "g2", "mfem"))
    is_rational = subject_format == "mfem"
    maps, plan = once(("solid", n, is_rational), lambda: solid(n, is_rational))
    text = texts.WRITERS[subject_format](maps)
    return subject_format + "-faces", odd_text(text, subject_format, rng) if subject_format in ("g2", "mfem") else text, plan


def folded_model(rng):
    """(subject format, text, Fold): volumes that are read without their faces."""
    fold = fold_liars.folded(rng)
    text = fold.model()
    return fold.subject_format, odd_text(text, fold.subject_format, rng) if fold.subject_format in ("g2", "mfem") else text, fold


# ---------------------------------------------------------------- damage

def exchanged(data, rng):
    """Two words change places, or one stands in the place of another."""
    words = list(WORD.finditer(data))
    if len(words) < 2:                                    # little is left of a text that was cut before
        return data
    (a, b), (c, d) = sorted(w.span() for w in rng.sample(words, 2))
    first, second = data[a:b], data[c:d]
    return data[:a] + second + data[b:c] + (first if rng.random() < .5 else second) + data[d:]


def another_number(data, rng):
    """A small number is another one: counts, knots, coordinates."""
    words = [w for w in WORD.finditer(data) if w[0].isdigit()]
    if not words:
        return data
    a, b = rng.choice(words).span()
    return data[:a] + b"%d" % max(0, int(data[a:b][:6]) + rng.choice((-2, -1, -1, 1, 1, 2, 7))) + data[b:]
