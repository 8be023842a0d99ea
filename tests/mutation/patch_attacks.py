#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claims about patches: star-box-1 and -2, star-box-turned-1 and -2,
patch-invalid-1 and -2, volume-folded-1, collar-1.

As attacks.py, whose harness it uses: a model of known truth, a false claim, and a certificate in which everything but that claim is
right for some part of the model.  Every attack must be rejected, by both checkers, for the same condition; honest certificates must be
accepted.  Run

    python3 tests/mutation/patch_attacks.py --count 100000 --seed 1 --checker PATH_TO_veritope-check
"""
import random
import sys
import time

import attacks
import collar_liars
import fold_liars
import invalid_liars
import meeting_liars
import patch_liars
import sheet_conditions
import sheet_liars

CONDITIONS = ["B2", "B3", "P1", "C1", "C2", "C3", "C4", "W1", "W2", "W3", "K0", "K1E", "K1V", "K2", "K3", "I1", "I2", "I3", "I4",
              "X1", "X2", "X3", "D1", "D2", "D3", "D4", "M1", "M2", "J1", "J2"]
# X3 implies X2 (patch-invalid.md, section 4); sides that are not one and one for each component get stuck (referee-2, 2.3).
IMPLIED = {"X2": ("X3",), "K2": ("K3",)}


class Subject:
    def __init__(self, data):
        self.bytes = data


def subjects(found):
    last = None
    for name, model, cert in found:
        if last is None or last.bytes is not model:
            last = Subject(model)
        yield name, last, cert


def draw(rng):
    """More than half of the attacks are about star boxes of version 2."""
    r = rng.random()
    if r < .2:
        return patch_liars.star_attacks
    if r < .8:
        return sheet_liars.sheet_attacks
    if r < .98:
        return invalid_liars.invalid_attacks if r < .91 else meeting_liars.meeting_attacks if r < .96 else fold_liars.fold_attacks
    return collar_liars.collar_attacks


def honest(rng):
    r = rng.random()
    if r < .4:
        yield from patch_liars.honest(rng)
    elif r < .65:
        yield from sheet_liars.honest(rng)
    elif r < .85:
        for name, finding in (invalid_liars if r < .75 else meeting_liars).honest(rng):
            model = patch_liars.forge.encode_model(finding.entities)
            yield name, model, finding.certificate(model)
    elif r < .9:
        yield from fold_liars.honest(rng)
    else:
        made = collar_liars.honest(rng)
        yield "collar", made.model, made.certificate()


TRIED = .05                                               # of the attacks of version 2: is a part of a condition needed?
KINDS = {make.__name__: make for make in (patch_liars.star_attacks, sheet_liars.sheet_attacks, invalid_liars.invalid_attacks,
                                          meeting_liars.meeting_attacks, fold_liars.fold_attacks, collar_liars.collar_attacks)}


class Run(attacks.Run):
    conditions, implied = CONDITIONS, IMPLIED

    def __init__(self, options):
        super().__init__(options)
        self.order = random.Random(options.seed)          # which attacks the Python checker judges

    def attacks(self, rng):
        kind = self.options.only or draw(rng).__name__
        return subjects(KINDS[kind](rng))

    def attack(self, name, case, cert, seed):
        is_new = sheet_conditions.is_new(cert)
        self.seen["2" if is_new else "rest"] += 1
        if self.options.checker and self.order.random() >= self.options.python_share:
            code, message = self.native.check(case.bytes, cert)
            found = attacks.condition_of(code, message)
            if code != 1:
                self.fail("FALSE CLAIM ACCEPTED" if code == 0 else message, case.bytes, cert, seed, name)
            self.table[name, found] += 1
            return
        self.seen["2 by python" if is_new else "rest by python"] += 1
        super().attack(name, case, cert, seed)

    @property
    def seen(self):
        """Counts of attacks by versions and judges, beside those of needed conditions."""
        return self.alone

    def both(self, case, cert, seed, name):
        found = super().both(case, cert, seed, name)
        if sheet_conditions.is_new(cert) and self.order.random() < TRIED:
            sheet_conditions.needed(self.py._check, case.bytes, cert, found, self.alone, 2)
        return found

    @staticmethod
    def honest_certificates(rng):
        return subjects(honest(rng))


def print_parts(alone):
    print("needed alone in version 2 of star boxes:")
    for name in sheet_conditions.NAMES:
        why = "" if alone.get(name) else sheet_conditions.UNCOVERED.get(name, "NOT COVERED")
        print("  %-24s %4s  %s" % (name[2:], alone.get(name) or "", why))


def missing_conditions(alone):
    return attacks.missing_conditions(alone, CONDITIONS, IMPLIED)


def by_lie(table):
    """(what was bent, condition): the false models are summed up."""
    short = {}
    for (name, condition), n in table.items():
        key = name.split("/")[-1], condition
        short[key] = short.get(key, 0) + n
    return short


def figures(table, alone, honest_found, failures, seconds, options):
    yield "patch_attacks", sum(table.values()), options.count
    yield "patch_attacks_stopped_by_S_or_B1", sum(n for (_, c), n in table.items() if c in attacks.UNCOUNTED), None
    yield "patch_attacks_of_version_2", alone.get("2", 0), options.count // 2
    yield "patch_attacks_of_version_2_judged_by_python", alone.get("2 by python", 0), options.count // 5
    total = len(sheet_conditions.NAMES)
    yield "patch_parts_of_version_2_needed_alone", total - len(sheet_conditions.missing(alone)), total - len(sheet_conditions.UNCOVERED)
    yield "patch_attack_strategies", len({n for n, _ in table}), 100
    yield "patch_attacks_accepted", sum(n for (_, c), n in table.items() if c == "ACCEPT"), 0
    yield "patch_checker_disagreements", sum("disagree" in f for f in failures), 0
    yield "patch_conditions_needed_alone", sum(1 for c in CONDITIONS if alone.get(c)), len(CONDITIONS) - len(IMPLIED)
    yield "patch_conditions_not_needed", len(missing_conditions(alone)), 0
    yield "honest_patch_certificates", sum(honest_found.values()), options.honest
    yield "honest_patch_certificates_rejected", sum(n for (_, c), n in honest_found.items() if c != "ACCEPT"), 0
    yield "checkers_compared", 2 if options.checker else 1, 2
    yield "seconds", round(seconds, 1), None


def main(argv):
    options, start = attacks.parse(argv), time.monotonic()
    table, alone, honest_found, failures = attacks.run_all(options, Run)
    attacks.print_table(by_lie(table), alone, CONDITIONS)
    print_parts(alone)
    done, missing = sum(table.values()), []
    if done >= 20000 and not options.only:
        missing += missing_conditions(alone)
    if done >= 50000:
        missing += [name for name in sheet_conditions.missing(alone) if name not in sheet_conditions.UNCOVERED]
    return attacks.report(failures, figures(table, alone, honest_found, failures, time.monotonic() - start, options), missing)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
