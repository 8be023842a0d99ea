#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""coq_terms.py reads scripts and terms exactly, and notices each way in which a term could prove something else. Needs neither Coq nor Gappa;
where Gappa is installed, the terms that it prints for orient2d are compared, too (coq_proofs.py does so for all scripts)."""
import re
import shutil
import sys
import unittest
from fractions import Fraction

import coq_proofs
from coq_terms import Nodes, Script, Term, TermError, faults, read_number, round_down
from gappa_test import PRECISION, SCRIPTS, constants, gappa

CONSTANT = "0x1.8000000000007p-52"
SCRIPT = """# a comment with { braces }
@rnd = float<ieee_64, ne>;
kRel = 0x1.8000000000007p-52;
way1 = (1 + d1) * (1 + d2);
{ |x| in [1b-1021, 1b1023] /\\ d1 in [-1b-53, 1b-53] /\\ d2 in [-1b-53, 1b-53]
-> |rnd(x) -/ x| <= 1b-53 /\\
   3 * |way1 - 1| - kRel * (1 + d2) <= 0 }
"""
TERM = """Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x : R.
Notation r1 := ((Rabs _x)%R).
Definition f1 := Float2 (1) (-1021).
Definition f2 := Float2 (1) (1023).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND r1 i1). (* BND(|x|, [4.45015e-308, 8.98847e+307]) *)
Variable _d1 : R.
Definition f3 := Float2 (-1) (-53).
Definition f4 := Float2 (1) (-53).
Definition i2 := makepairF f3 f4.
Notation p2 := (BND _d1 i2). (* BND(d1, [-1.11022e-16, 1.11022e-16]) *)
Definition s3 := (p1 /\\ p2).
Variable _d2 : R.
Notation p3 := (BND _d2 i2). (* BND(d2, [-1.11022e-16, 1.11022e-16]) *)
Definition s2 := (s3 /\\ p3).
Notation r2 := ((rounding_float rndNE (53)%positive (-1074)%Z) _x).
Notation p4 := (REL r2 _x i2). (* REL(float<53,-1074,ne>(x), x, [-1.11022e-16, 1.11022e-16]) *)
Definition s5 := (not p4).
Notation r3 := (Float1 (3)).
Notation r4 := (Float1 (1)).
Notation r5 := ((r4 + _d1)%R).
Notation r6 := ((r4 + _d2)%R).
Notation _way1 := ((r5 * r6)%R).
Notation r7 := ((_way1 - r4)%R).
Notation r8 := ((Rabs r7)%R).
Notation r9 := ((r3 * r8)%R).
Notation _kRel := (float2R (Float2 (6755399441055751) (-104))).
Notation r10 := ((_kRel * r6)%R).
Notation r11 := ((r9 - r10)%R).
Definition f5 := Float2 (0) (0).
Notation p5 := ((r11 <= f5)%R). (* BND(3 * |way1 - 1| - kRel * (1 + d2), [-inf, 0]) *)
Definition s6 := (not p5).
Definition s4 := (s5 \\/ s6).
Definition s1 := (s2 /\\ s4).
Lemma l1 : s1 -> False.
Proof.
Qed.
End Generated_by_Gappa.
"""
BOX = """@rnd = float<ieee_64, ne>;
a = rnd(a_);
t rnd= a * a - a;
t_exact = a * a - a;
{ a in [0, 1] -> |t - t_exact| <= 0x1.2000000000005p-50 }
"""


class Numbers(unittest.TestCase):
    def test_numbers_are_exact(self):
        self.assertEqual(read_number(CONSTANT), Fraction(6755399441055751, 2**104))
        self.assertEqual(read_number("-1b-53"), Fraction(-1, 2**53))
        self.assertEqual(read_number("36"), 36)
        self.assertEqual(read_number("0x1p-1074"), Fraction(1, 2**1074))
        for text in ("1.5", "0x1.8", "1e-3", "", "kRel"):
            with self.assertRaises(TermError):
                read_number(text)

    def test_products_are_rounded_down_to_53_bits(self):
        three = 3 * read_number("0x1.8000000000007p-52")
        self.assertEqual(round_down(three), read_number("0x1.2000000000005p-50"))
        self.assertLess(round_down(three), three)
        for value in (Fraction(1), Fraction(2**60 + 2**8), Fraction(3, 2**70)):
            self.assertEqual(round_down(value), value)
        self.assertEqual(round_down(Fraction(2**53 + 1)), 2**53)
        self.assertEqual(round_down(Fraction(2**54 - 1)), 2**54 - 2)
        self.assertEqual(round_down(Fraction(1, 3)), Fraction((2**54 - 1) // 3, 2**54))


class Statements(unittest.TestCase):
    def test_the_term_of_the_script_has_no_faults(self):
        self.assertEqual(faults(SCRIPT, TERM, CONSTANT), [])

    def test_another_constant_in_the_header_is_found(self):
        for other in ("0x1.8000000000006p-52", "0x1.8000000000008p-52", "0x1.8000000000007p-53", "0x1.80000000000070001p-52"):
            found = faults(SCRIPT, TERM, other)
            self.assertEqual(len(found), 1)
            self.assertIn("the term's constant is 6755399441055751/", found[0])

    def test_every_change_of_the_statement_is_found(self):
        changes = [
            ("Float2 (6755399441055751)", "Float2 (6755399441055752)"),  # the constant
            ("Float2 (1) (1023)", "Float2 (1) (1022)"),  # fewer x
            ("Float2 (-1) (-53)", "Float2 (-1) (-54)"),  # fewer roundings
            ("(Float1 (3))", "(Float1 (2))"),  # a smaller factor
            ("((r5 * r6)%R)", "((r5 + r6)%R)"),
            ("((_way1 - r4)%R)", "((r4 - _way1)%R)"),
            ("rndNE", "rndUP"),
            ("Float2 (0) (0)", "Float2 (1) (0)"),  # <= 1
            ("(s5 \\/ s6)", "(s5 \\/ s5)"),  # a goal less
            ("(s3 /\\ p3)", "(s3 /\\ p2)"),  # d2 is not bounded
            ("(s2 /\\ s4)", "(s3 /\\ s4)"),  # a hypothesis less
            ("(s2 /\\ s4)", "(s4 /\\ p2)"),
            ("(BND r1 i1)", "(BND _x i1)"),
        ]
        for old, new in changes:
            with self.subTest(new):
                self.assertEqual(TERM.count(old), 1)
                self.assertTrue(faults(SCRIPT, TERM.replace(old, new), CONSTANT))

    def test_terms_that_assume_or_prove_nothing_are_refused(self):
        for old, new, sentence in (
            ("Variable _d1 : R.", "Variable _d1 : R.\nVariable h : False.", "assumes"),
            ("Variable _d1 : R.", "Variable _d1 : R.\nHypothesis h : False.", "assumes"),
            ("Variable _d1 : R.", "Variable _d1 : R.\nAxiom h : False.", "assumes"),
            ("Proof.\nQed.", "Admitted.", "assumes"),
            ("Lemma l1 : s1 -> False.", "Lemma l1 : s1 -> True.", "no lemma"),
            ("Definition s4", "Definition s2 := (s3 /\\ p3).\nDefinition s4", "twice"),
            ("((r5 * r6)%R)", "((r5 / r6)%R)", "no expression"),
            ("(BND _d1 i2)", "(FIX _d1 i2)", "no atom"),
            ("Definition s1 :=", "Definition s0 :=", "no atom"),
        ):
            with self.subTest(new):
                self.assertEqual(TERM.count(old), 1)
                self.assertIn(sentence, " ".join(faults(SCRIPT, TERM.replace(old, new), CONSTANT)))

    def test_scripts_outside_of_the_grammar_are_refused(self):
        for old, new in (("<= 0 }", "<= 0"), ("kRel = ", "kRel ? "), ("3 * ", "3 / "), ("<ieee_64, ne>", "<ieee_32, ne>"), ("d1 in ", "d1 @ "),
                         ("-> ", "/\\ "), ("<= 0 }", "<= 0 -> d1 <= 0 }"), ("kRel = ", "way1 = 1; kRel = ")):
            with self.subTest(new):
                self.assertTrue(faults(SCRIPT.replace(old, new, 1), TERM, CONSTANT))

    def test_every_operation_of_a_rounded_definition_is_rounded(self):
        nodes = Nodes()
        goal = Script(BOX, nodes).statement[1][0]
        kind, computed, exact = nodes.nodes[nodes.nodes[goal[1]][1]]
        self.assertEqual((goal[0], kind), ("in", "-"))
        direction, difference = nodes.nodes[computed][1:]
        self.assertEqual((direction, nodes.nodes[difference][0]), ("rndNE", "-"))
        self.assertEqual(nodes.nodes[nodes.nodes[difference][1]][0], "round")
        self.assertEqual(nodes.nodes[exact][0], "-")
        self.assertEqual(nodes.nodes[nodes.nodes[exact][1]][0], "*")


class Tool(unittest.TestCase):
    def test_falsified_terms_have_another_constant(self):
        lie = coq_proofs.falsified(TERM, read_number(CONSTANT))
        self.assertEqual(Term(lie, Nodes()).bodies["_kRel"], "(float2R (Float2 (6755399441055750) (-104)))")
        self.assertTrue(faults(SCRIPT, lie, CONSTANT))
        box = "Definition f3 := Float2 (1) (-51).\nDefinition f4 := Float2 (3) (-50).\n"
        self.assertIn("f4 := Float2 (3) (-52)", coq_proofs.falsified(box, Fraction(3, 2**50)))
        with self.assertRaises(TermError):
            coq_proofs.falsified(box, Fraction(5))

    def test_axioms_are_listed(self):
        said = "Axioms:\nClassicalDedekindReals.sig_not_dec : forall P : Prop, {~ ~ P} + {~ P}\nmine\n  : forall n : nat,\n    n = 0\n"
        self.assertEqual(coq_proofs.axioms_of(said), {"ClassicalDedekindReals.sig_not_dec", "mine"})
        self.assertEqual(coq_proofs.axioms_of("Closed under the global context\n"), set())
        self.assertTrue(coq_proofs.axioms_of("") - coq_proofs.AXIOMS)

    def test_theorems_that_gappas_library_lacks_are_filled_in_and_proved_in_the_file(self):
        term = f"{coq_proofs.IMPORT}\n refine (UNKNOWN_float_absolute_wide_zr) ; finalize.\n"
        self.assertIn("(float_absolute_wide_zr _ _ _ _ _ h0 _)", coq_proofs.completed(term))
        library = (SCRIPTS / f"{coq_proofs.LIBRARY}.v").read_text()
        self.assertEqual(len(re.findall(r"(?m)^Theorem float_(?:relative|absolute_wide)_(?:up|dn|zr) :", library)), 6)
        self.assertNotRegex(library, r"Admitted|Axiom|Parameter|admit\b")

    def test_every_script_has_a_header_constant(self):
        self.assertEqual(set(coq_proofs.expected_constants()), {path.stem for path in SCRIPTS.glob("*.g")})

    @unittest.skipUnless(shutil.which("gappa"), "gappa is not installed")
    def test_the_terms_that_gappa_prints_are_read(self):
        for name, (constant, factor) in coq_proofs.expected_constants().items():
            if name in ("orient2d", "orient2d_box", "implicit_line_plane"):
                script = (SCRIPTS / f"{name}.g").read_text()
                term = gappa(script, *PRECISION, "-Bcoq")[1]
                self.assertEqual(faults(script, term, constant, factor), [], name)
                self.assertTrue(faults(script, term, "0x1.8p-52", factor), name)
        self.assertIn("orient2d", constants())


if __name__ == "__main__":
    sys.exit(unittest.main())
