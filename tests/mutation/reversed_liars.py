#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claim mesh-reversed-1: triangles of a file are turned, so that a certificate may turn them
back, and something else is wrong; or the file is a solid as it is. As attacks.py, whose liars and harness these are. Run

    python3 tests/mutation/reversed_liars.py --count 20000 --seed 1 --checker PATH_TO_veritope-check
"""
import copy
import sys
import time

import attacks
import forge

CONDITIONS = ["R1"] + ["V%d" % i for i in range(1, 12)]


class TurnedCase(attacks.Case):
    """The file has the triangles `flips` the other way round; mesh, truth and plans are about them turned back."""

    def certificate(self, plan):
        """plan: of mesh-valid-1 about the mesh."""
        plan.flips = self.flips
        body = forge.reversed_body(plan.body(), self.flips, len(self.mesh.tris))
        return forge.certificate(self.bytes, self.model, "mesh-reversed-1", body,
                                 {**forge.reversed_counts(plan), **plan.quantities()})


def turned(case, flips):
    """This case about another file, or None: in an STL file the order of corners decides on the numbers of vertices."""
    if case.model.fmt == "stl":
        return None
    other = copy.copy(case)
    other.__class__, other.flips = TurnedCase, set(flips)
    other.model = case.model.copy(tris=[(a, c, b) if f in flips else (a, b, c) for f, (a, b, c) in enumerate(case.model.tris)])
    other.bytes = other.model.encode()
    return other


def some_flips(case, rng):
    """Some triangles or some shells: at least one."""
    n = len(case.mesh.tris)
    if rng.random() < .5:
        return {f for shell in rng.sample(case.base.shells, rng.randint(1, len(case.base.shells))) for f in shell}
    return set(rng.sample(range(n), rng.choice((1, n, rng.randint(1, n)))))


def broken_case(rng):
    """(a case that breaks a rule once it is turned back, the solid before the defect)"""
    while True:
        case, before = attacks.false_case(rng)
        found = turned(case, some_flips(case, rng))
        if found:
            return found, before


def sound_case(rng):
    """A solid, in a file whose reading does not depend on the order of corners."""
    while True:
        case = attacks.valid_case(rng)
        if case.model.fmt != "stl":
            return case


# ---------------------------------------------------------------- liars

def broken_once_turned(rng):
    case, before = broken_case(rng)
    for cert in attacks.as_is(case, rng):
        yield "reversed_as_is", case, cert
    for liar in attacks.VALID_LIARS:
        made = liar(case, rng, before) if liar is attacks.transplant else liar(case, rng)
        for cert in made:
            yield "reversed_" + liar.__name__, case, cert


def sound_as_it_is(rng):
    """The file is a solid; the certificate reverses nothing, or some of its triangles."""
    case = sound_case(rng)
    for name, flips in (("nothing_reversed", set()), ("solid_reversed", some_flips(case, rng)), ("solid_reversed", some_flips(case, rng))):
        lie = turned(case, ())
        lie.flips = flips
        lie.mesh = forge.Mesh(case.mesh.floats, [(a, c, b) if f in flips else (a, b, c) for f, (a, b, c) in enumerate(case.mesh.tris)])
        for share in (0, 1):
            yield name, lie, lie.certificate(forge.Plan(lie.mesh, rng, share))


def another_choice(rng):
    """The file needs some reversals; the certificate makes others."""
    case = sound_case(rng)
    needed = some_flips(case, rng)
    true = turned(case, needed)
    for _ in range(6):
        flips = needed ^ set(rng.sample(range(len(case.mesh.tris)), rng.choice((1, 1, 2, 3))))
        lie = copy.copy(true)
        lie.flips = flips
        lie.mesh = forge.Mesh(case.mesh.floats, [(a, c, b) if f in flips ^ needed else (a, b, c) for f, (a, b, c) in enumerate(case.mesh.tris)])
        yield "another_choice", lie, lie.certificate(forge.Plan(lie.mesh, rng, rng.choice((0, 0, .5))))


def wrong_counts(rng):
    case = sound_case(rng)
    case = turned(case, some_flips(case, rng))
    case.base.flips = case.flips
    true = {**case.base.quantities(), **forge.reversed_counts(case.base)}
    for key in sorted(set(true) - {"volume"}):
        for step in (1, -1):
            if true[key] + step >= 0:
                plan = case.base.copy()
                plan.values = {key: true[key] + step}
                yield "wrong_count", case, case.certificate(plan)


def reversed_attacks(rng):
    r = rng.random()
    if r < .55:
        return broken_once_turned(rng)
    return sound_as_it_is(rng) if r < .7 else another_choice(rng) if r < .85 else wrong_counts(rng)


def honest(rng):
    case = sound_case(rng)
    case = turned(case, some_flips(case, rng))
    for share in (0, 1):
        plan = forge.Plan(case.mesh, rng, share)
        plan.detours = rng.choice((0, .2))
        yield "reversed", case, case.certificate(plan)


class Run(attacks.Run):
    conditions = CONDITIONS
    attacks, honest_certificates = staticmethod(reversed_attacks), staticmethod(honest)


def missing_conditions(alone):
    return attacks.missing_conditions(alone, CONDITIONS)


def figures(table, honest_found, failures, options, seconds):
    yield "reversed_attacks", sum(table.values()), options.count
    yield "reversed_attacks_accepted", sum(n for (_, c), n in table.items() if c == "ACCEPT"), 0
    yield "reversed_checker_disagreements", sum("disagree" in f for f in failures), 0
    yield "honest_reversed_certificates", sum(honest_found.values()), options.honest
    yield "honest_reversed_certificates_rejected", sum(n for (_, c), n in honest_found.items() if c != "ACCEPT"), 0
    yield "seconds", round(seconds, 1), None


def main(argv):
    options, start = attacks.parse(argv), time.monotonic()
    table, alone, honest_found, failures = attacks.run_all(options, Run)
    attacks.print_table(table, alone, CONDITIONS)
    return attacks.report(failures, figures(table, honest_found, failures, options, time.monotonic() - start),
                          missing_conditions(alone) if options.count >= 20000 else ())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
