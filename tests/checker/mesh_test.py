#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of mesh certificates beside the Python one, whose tests it runs: both must give the same exit code and name the same
condition. VERITOPE_CHECK names the program."""
import os
import resource
import unittest

import judges
import mesh_models as models
import mesh_test as python_tests

forge = python_tests.forge
judges.judge(python_tests.vc)
Solids, Statement, Bodies = python_tests.Solids, python_tests.Statement, python_tests.Bodies
Valid, Invalid = python_tests.Valid, python_tests.Invalid


def tearDownModule():
    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    assert most < 700 * 1024, "a run took %d KiB: a count that lies was believed" % most


class CommandLine(python_tests.CommandLine):
    PROGRAM, VERSION = [judges.CHECK], "veritope-check 1"

    def test_names_are_printed_without_control_characters(self):
        self.assertEqual(self.run_it(judges.CHECK, "no\x7f\x1b[31m"), (4, "", "no??[31m: cannot be opened"))

    @unittest.skipIf(os.environ.get("VERITOPE_SANITIZE"), "sanitizers need more address space")
    def test_missing_memory_is_exit_3(self):
        with self.model.open("r+b") as file:
            file.truncate(1 << 28)
        answer = self.run_it(self.model, self.certificate, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 27, 1 << 27)))
        self.assertEqual(answer, (3, "", "veritope-check stops: out of memory"))


class Cpp(python_tests.CertificateTest):
    """What this checker prints, and bounds on the work that the Python checker takes minutes to reach."""

    def prints(self, cert, *words):
        code, _, text = judges.in_cpp(self.bytes, cert)
        self.assertEqual(code, 0, text)
        for word in words:
            self.assertIn(word, text)

    def test_quantities_and_rules_are_printed(self):
        for mesh, shells, bodies, genus, volume in models.SOLIDS.values():
            self.shape(mesh)
            self.prints(self.cert(self.plan(1)), "mesh-valid-1: ", "%d vertices" % len(mesh[0]), "%d shells" % shells, "%d bodies" % bodies,
                        "%d genus" % genus, "volume " + volume)
        self.prints(self.claim("ACCEPT", *models.OPEN, (3, 1, 2)), "mesh-invalid-1: ", "rules M3")

    def bad_order(self, shift, n, order=None, codes=b"", stars=True):
        """n tetrahedra, each moved by `shift` from the one before; nothing is walked here."""
        self.shape(models.join(*(models.move(models.REGULAR, (shift * i,) * 3) for i in range(n))))
        plan = self.plan()
        table = {v: forge.star(self.mesh, v) for v in range(4)}
        plan.stars = {v: table[v % 4] for v in self.mesh.at} if stars else {}
        self.assertEqual({type(star) for star in plan.stars.values()} or {int}, {int})
        plan.order = order or list(range(4 * n))
        plan.nesting, plan.walk = [0] * n, lambda: ([], codes)
        return plan

    def test_a_work_bound_that_only_a_bad_order_meets(self):
        """Tetrahedra along a diagonal. Pairs from opposite ends make all boxes overlap."""
        n = 4096
        plan = self.bad_order(4, n)
        self.prints(self.cert(plan), "%d bodies" % n)
        plan.order = [f for i in range(2 * n) for f in (i, 4 * n - 1 - i)]
        self.assertEqual(judges.in_cpp(self.bytes, self.cert(plan))[:2], (1, "B1"))

    def test_the_work_bound_of_the_walk_is_exact(self):
        """Tetrahedra whose boxes all meet, so F triangles take all (F - 1)^2 calls of cross; no code is right."""
        for last, answer in ((969, "V9"), (1, "B1")):     # the greatest and the least last digits of a square
            n = next(n for n in range(2500, 9999) if (4 * n - 1) ** 2 % 1000 == last)
            plan = self.bad_order(1 / 4096, n, stars=False)
            codes = ((4 * n - 1) ** 2 + 31) // 1000 - 4 * n - len(plan.body())
            plan.walk = lambda codes=codes: ([], b"\x11" * codes)
            self.assertEqual(judges.in_cpp(self.bytes, self.cert(plan))[:2], (1, answer))


if __name__ == "__main__":
    unittest.main()
