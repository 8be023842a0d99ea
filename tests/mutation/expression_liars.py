#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claim points-1 about expressions: a word is false, or the files, codes or numbers are not
those that it needs, and everything else is right. As attacks.py, whose harness this is. Run

    python3 tests/mutation/expression_liars.py --count 20000 --seed 1 --checker PATH_TO_veritope-check
"""
import copy
import itertools
import os
import pathlib
import random
import sys
import time
from fractions import Fraction

import attacks
import expression_forge as forge
import fan_forge
import points_forge

CONDITIONS = ["A1", "A2", "O1", "O2", "B1", "P1", "P2", "P3", "P4", "P5"]
WORDS = ("in", "on", "out")


class Case:
    """A chain file with the files that it names. files: {path: bytes}. answers: of the attack."""

    def __init__(self, subject):
        self.subject, self.bytes, self.files, self.answers, self.model = subject, subject.chain.data, subject.chain.files(), b"", None

    def with_answers(self, plan):
        """(this case with the answers of a plan, its certificate)"""
        case = copy.copy(self)
        case.answers = plan.answers()
        return case, plan.certificate(self.bytes, self.subject.as_indexed)

    def copy(self, **changes):
        case = copy.copy(self)
        case.__dict__.update(changes)
        return case


def random_case(rng, count=6):
    case = Case(forge.random_subject(rng))
    return case, forge.true_plan(case.subject, rng, count)


def covered(plan):
    return [n for n, line in enumerate(plan.lines) if line.word != "undecided" and line.codes != bytes([forge.NOT_COVERED])]


# ---------------------------------------------------------------- liars about lines

def other_word(case, plan, rng):
    """Another word with the true codes."""
    for number in covered(plan):
        for word in WORDS:
            yield plan.with_line(number, word=word)


def false_belief(case, plan, rng):
    """Something else is said of one or two solids, and what follows from that."""
    subject = case.subject
    for number in covered(plan):
        q = plan.lines[number].point(plan.decimals)
        near = [v for v in subject.solids if forge.is_in_box(v, q)]
        if not near:
            continue
        for _ in range(4):
            changed = {v: rng.choice((True, False, "on", "open")) for v in rng.sample(near, min(len(near), rng.choice((1, 1, 2))))}
            beliefs = forge.Beliefs(subject, q, rng, changed)
            concluded = beliefs.conclusion()
            for word in (concluded,) if concluded in WORDS else WORDS:
                yield plan.with_line(number, word=word, codes=beliefs.codes())


def open_claims(case, plan, rng):
    """Every solid is open, and the word is claimed all the same."""
    for number in covered(plan):
        q = plan.lines[number].point(plan.decimals)
        beliefs = forge.Beliefs(case.subject, q, rng, {v: "open" for v in case.subject.solids if forge.is_in_box(v, q)})
        beliefs.conclusion()
        for word in WORDS:
            yield plan.with_line(number, word=word, codes=beliefs.codes())


def other_place(case, plan, rng):
    """Another triangle or other parameters, as if the point were there."""
    for number in covered(plan):
        line = plan.lines[number]
        q = line.point(plan.decimals)
        beliefs = forge.Beliefs(case.subject, q, rng, {v: "on" for v in case.subject.solids})
        concluded = beliefs.conclusion()
        for word in (concluded,) if concluded in WORDS else WORDS:
            yield plan.with_line(number, word=word, codes=beliefs.codes())


def codes_as_if_simpler(case, plan, rng):
    """Codes of the last solids are left out, doubled, or those of another line."""
    for number in covered(plan):
        line, word = plan.lines[number], rng.choice(WORDS)
        for codes in (line.codes[:-1], line.codes * 2, line.codes[:1], rng.choice(plan.lines).codes):
            yield plan.with_line(number, word=word, codes=codes)


def moved(case, plan, rng):
    """Other coordinates, and the answer of those that were there."""
    for number, line in enumerate(plan.lines):
        if line.word == "undecided":
            continue
        at, k = line.point(plan.decimals), rng.randrange(3)
        for step in (Fraction(1, 2 ** 70), Fraction(-1, 2 ** 70), Fraction(1, 3), Fraction(rng.randint(-9, 9), 4)):
            other = [c + step * (i == k) for i, c in enumerate(at)]
            yield plan.with_line(number, tokens=[rng.choice(points_forge.tokens_of(c, plan.decimals)) for c in other])
        yield plan.with_line(number, tokens=rng.choice(plan.lines).tokens)


def hidden_mark(case, plan, rng):
    """A line without a proof whose word is false, and which the body does not count."""
    for number in covered(plan):
        if plan.lines[number].codes:
            other = plan.with_line(number, word=rng.choice(WORDS), codes=bytes([forge.NOT_COVERED]))
            marked = sum(line.codes == bytes([forge.NOT_COVERED]) for line in other.lines)
            yield other.copy(counts={"marked": marked - 1})


ABOUT_LINES = (other_word, false_belief, false_belief, open_claims, other_place, codes_as_if_simpler, moved)


def lies(name, case, plans):
    for plan in plans:
        if not plan.holds():
            yield name, *case.with_answers(plan)


def false_lines(rng):
    case, plan = random_case(rng)
    for liar in ABOUT_LINES:
        found = list(lies(liar.__name__, case, liar(case, plan, rng)))
        yield from rng.sample(found, min(len(found), 8))
    for other in hidden_mark(case, plan, rng):
        yield "hidden_mark", *case.with_answers(other)


# ---------------------------------------------------------------- liars about files

def with_chain(chain, plan, rng, as_indexed):
    """The case of another chain file with the lines and the codes of a plan, and with codes that follow from its own solids."""
    subject = forge.Subject(chain, as_indexed)
    other = plan.copy(subject=subject)
    case = Case(subject)
    yield case, other
    lines = []
    for line in plan.lines:
        if line.word != "undecided":
            q = line.point(plan.decimals)
            beliefs = forge.Beliefs(subject, q, rng)
            beliefs.conclusion()
            line = line.changed(codes=beliefs.codes())
        lines.append(line)
    yield case, other.copy(lines=lines)


def other_files(rng):
    """The lines of one expression with the file of another: operands exchanged, another operator, another solid, another box, another
    expression in it. The hashes are right."""
    case, plan = random_case(rng, 8)
    chain = case.subject.chain
    names = sorted(chain.operands)

    def changed(**fields):
        other = copy.copy(chain)
        other.__dict__.update(fields)
        return other

    others = []
    if len(names) > 1:
        a, b = rng.sample(names, 2)
        swapped = {**chain.operands, a: chain.operands[b], b: chain.operands[a]}
        others.append(("operands_exchanged", changed(operands=swapped, paths={**chain.paths, a: chain.paths[b], b: chain.paths[a]})))
    if not isinstance(chain.tree, str):
        others.append(("other_operator", changed(tree=other_operator(chain.tree, rng))))
    name = rng.choice(names)
    if not isinstance(chain.operands[name], forge.Chain) and sum(o is chain.operands[name] for o in chain.operands.values()) == 1:
        solid = forge.some_solid(rng, case.subject.as_indexed)
        if inside(solid, chain.box):
            others.append(("other_solid", changed(operands={**chain.operands, name: solid})))
    box = forge.BoxVariable([c - 1 for c in chain.box.low], [c + 1 for c in chain.box.high])
    others.append(("other_box", changed(box=box)))
    for kind, other in others:
        if any(isinstance(o, forge.Chain) for o in other.operands.values()) and kind == "operands_exchanged":
            continue
        for changed_case, changed_plan in with_chain(other, plan, rng, case.subject.as_indexed):
            if not changed_plan.holds():
                yield kind, *changed_case.with_answers(changed_plan)


def inside(solid, box):
    return all(a < c and d < b for a, c, d, b in zip(box.low, solid.low, solid.high, box.high))


def other_operator(tree, rng):
    if isinstance(tree, str):
        return tree
    if rng.random() < .4 and tree[0] != "!":
        return (rng.choice([op for op in "|&-" if op != tree[0]]), *tree[1:])
    k = rng.randrange(1, len(tree))
    if isinstance(tree[k], str):
        return (rng.choice("|&-"), *tree[1:]) if tree[0] != "!" else tree[1]
    return (*tree[:k], other_operator(tree[k], rng), *tree[k + 1:])


def changed_files(rng):
    """A file has changed since the chain file was made: by a byte, for that of another operand, or both are exchanged."""
    case, plan = random_case(rng)
    paths = sorted(case.files)
    path = rng.choice(paths)
    data = case.files[path]
    at = rng.randrange(len(data))
    others = [{path: data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1:]}, {path: data + b"\n"}, {path: data[:-1]}]
    different = [p for p in paths if case.files[p] != data]
    if different:
        other = rng.choice(different)
        others += [{path: case.files[other]}, {path: case.files[other], other: data}]
    read_first = first_paths(case.subject.chain)
    for change in others:
        if any(p in read_first for p in change):
            yield "changed_file", *case.copy(files={**case.files, **change}).with_answers(plan)


def first_paths(chain):
    """The files that checkers read: the first one of each content."""
    found = {}

    def visit(chain, folder):
        for name in dict.fromkeys(forge.leaves_of(chain.tree)):
            operand, path = chain.operands[name], folder + chain.paths[name]
            if (operand.data, operand.form) in found:
                continue
            found[operand.data, operand.form] = path
            if isinstance(operand, forge.Chain):
                visit(operand, path[:path.rfind("/") + 1])

    visit(chain, "")
    return set(found.values())


def narrow_boxes(rng):
    """An operand touches a side of the box, or passes it; the words are those of the expression with that box."""
    case, plan = random_case(rng)
    chain = case.subject.chain
    k, operand = rng.randrange(3), rng.choice(list(chain.operands.values()))
    solid = operand.box if isinstance(operand, forge.Chain) else operand
    low, high = list(chain.box.low), list(chain.box.high)
    step = rng.choice((0, 0, Fraction(1, 4), Fraction(1, 2 ** 60)))
    if rng.random() < .5:
        low[k] = solid.low[k] + step
    else:
        high[k] = solid.high[k] - step
    other = copy.copy(chain)
    other.box = forge.BoxVariable(low, high)
    subject = forge.Subject(other, case.subject.as_indexed)
    yield "narrow_box", *Case(subject).with_answers(forge.true_plan(subject, rng, 4))


def split_variables(rng):
    """Two operands are one file, and the certificate takes them for two solids; or two solids for one."""
    case, _ = random_case(rng)
    chain = case.subject.chain
    names = [name for name, o in chain.operands.items() if not isinstance(o, forge.Chain)]
    if not names:
        return
    a = rng.choice(names)
    twin = forge.Chain(("-", a, "B"), {a: chain.operands[a], "B": chain.operands[a]} if a != "B" else {"B": chain.operands[a]},
                       {a: "x", "B": "y"} if a != "B" else {"B": "x"}, (chain.box.low, chain.box.high))
    if a == "B":
        twin.tree = ("-", "B", "B")
    subject = forge.Subject(twin, case.subject.as_indexed)
    case, solid = Case(subject), chain.operands[a]
    honest = forge.true_plan(subject, rng, 6)
    for number, line in enumerate(honest.lines):
        if line.word == "undecided" or not forge.is_in_box(solid, line.point(honest.decimals)):
            continue
        says = forge.Beliefs(subject, line.point(honest.decimals), rng)
        says.conclusion()
        for word in WORDS:
            if word != subject.word(line.point(honest.decimals)):
                for codes in (says.codes() * 2, says.codes()):
                    yield "split_variables", *case.with_answers(honest.with_line(number, word=word, codes=codes))
    yield "split_variables", *case.with_answers(honest.copy(counts={"solids": 2}, heads=2 * solid.head()))


def open_meshes(rng):
    """A mesh lacks a triangle or has one turned; the codes are those of the solid."""
    case, plan = random_case(rng)
    chain = case.subject.chain
    names = [name for name, o in chain.operands.items() if isinstance(o, forge.MeshSolid)]
    if not names:
        return
    name = rng.choice(names)
    solid = copy.copy(chain.operands[name])
    tris = list(solid.model.tris)
    f = rng.randrange(len(tris))
    tris[f:f + 1] = rng.choice(([], [tris[f][::-1]], [tris[f]] * 2))
    solid.model = solid.model.copy(tris=tris)
    solid.mesh, solid.data = forge.forge.mesh_of(solid.model), solid.model.encode()
    other = copy.copy(chain)
    other.operands = {n: solid if o is chain.operands[name] else o for n, o in chain.operands.items()}
    subject = forge.Subject(other, case.subject.as_indexed)
    lines = [line for line in plan.lines if forge.ON not in line.codes]
    yield "open_mesh", *Case(subject).with_answers(plan.copy(subject=subject, lines=lines[:rng.choice((0, 1, 6))]))


def curved_walls(rng):
    """A point of a ball and of the side of a block; the certificate leaves out that the ball is not flat."""
    ball = forge.BallSolid(rng)
    q = ball.point(rng)
    k, side = rng.randrange(3), rng.choice((1, -1))
    low, high = [Fraction(-2)] * 3, [Fraction(2)] * 3
    (low if side > 0 else high)[k] = q[k]
    if points_forge.nearest(q[k]) != q[k] or low[k] >= high[k]:
        return
    points, tris = forge.box_mesh(low, high)
    block = forge.MeshSolid(forge.box_planes(low, high), points, tris, rng, False)
    tree = rng.choice((("|", "A", "B"), ("&", "A", "B"), ("-", "A", "B"), ("-", "B", "A")))
    chain = forge.Chain(tree, {"A": ball, "B": block}, {"A": "ball", "B": "block"}, ([-3] * 3, [3] * 3))
    subject = forge.Subject(chain, False)
    beliefs = forge.Beliefs(subject, q, rng)
    beliefs.conclusion()
    tokens = [rng.choice(points_forge.tokens_of(c, "exact")) for c in q]
    for word in WORDS:
        yield "curved_wall", *Case(subject).with_answers(forge.Plan(subject, [forge.Line(tokens, word, beliefs.codes())], "exact"))


def at_pole(rng, fault=None):
    """(case, plan of the true word) of the pole of a rose on a box, where a block has a wall, too. fault: of a petal there."""
    face, size = rng.randrange(6), [rng.randint(1, 3) for _ in range(3)]
    fans = forge.FanBox((0, 0, 0), size, rng, lambda number: fault if number == face else rng.choice(("plain", None, "fan", "corner")))
    q = fans.pole_of[face]
    low, high, k = [c - 1 for c in q], [c + 1 for c in q], next(k for k in range(3) if q[k] in (0, size[k]))
    k = rng.choice((k, rng.randrange(3)))
    rng.choice((low, high))[k] = q[k]
    points, tris = forge.box_mesh(low, high)
    block = forge.MeshSolid(forge.box_planes(low, high), points, tris, rng, False)
    tree = rng.choice((("|", "A", "B"), ("&", "A", "B"), ("-", "A", "B"), ("-", "B", "A")))
    subject = forge.Subject(forge.Chain(tree, {"A": fans, "B": block}, {"A": "fans", "B": "block"}, ([-2] * 3, [5] * 3)), False)
    return Case(subject), forge.Plan(subject, [forge.true_line(subject, q, rng, "exact")], "exact")


def bad_fans(rng):
    """A petal is not as the page has it; whatever the word, its fan proves nothing. Without a fault: a false word."""
    for fault in fan_forge.FAULTS:
        case, plan = at_pole(rng, fault)
        codes = forge.Beliefs(case.subject, plan.lines[0].point("exact"), rng)
        codes.conclusion()
        for word in WORDS:
            yield "fan_" + fault, *case.with_answers(plan.with_line(0, word=word, codes=codes.codes()))
    case, plan = at_pole(rng)
    for word in WORDS:
        yield from lies("fan_word", case, [plan.with_line(0, word=word)] if covered(plan) else [])


def wrong_numbers(rng):
    """Numbers of the body, bytes after it, flags and numbers of the statement."""
    case, plan = random_case(rng)
    for key, step in itertools.product(("solids", "leaves", "points", "marked"), (1, -1)):
        true = {"solids": len(case.subject.solids), "leaves": case.subject.num_leaves, "points": len(plan.lines),
                "marked": sum(line.codes == bytes([forge.NOT_COVERED]) for line in plan.lines)}[key]
        if true + step >= 0:
            yield "wrong_number", *case.with_answers(plan.copy(counts={key: true + step}))
    heads = b"".join(solid.head() for solid in case.subject.solids)
    at = rng.randrange(len(heads))
    for key in ("on", "undecided"):
        yield "wrong_number", *case.with_answers(plan.copy(values={key: len(plan.lines) + 1}))
    for changes in ({"extra": rng.choice((b"\0", b"\xff", bytes(9)))}, {"magic": b"VTMV"}, {"heads": heads[:at] + bytes([heads[at] ^ 1]) + heads[at + 1:]},
                    {"heads": heads[:at] + heads[at + 1:]}, {"values": {"winding": True}}, {"values": {"points": len(plan.lines) + 1}},
                    {"claimed_answers": plan.answers() + plan.lines[0].text().encode()}):
        yield "wrong_number", *case.with_answers(plan.copy(**changes))
    for number in covered(plan):
        if plan.lines[number].codes:
            for codes in (b"", b"\x0f", b"\xff", plan.lines[number].codes + b"\x0e"):
                yield "wrong_code", *case.with_answers(plan.with_line(number, codes=codes))


def too_much_work(rng):
    """Two pyramids with one apex, at which more wedges meet than the bound allows."""
    operands = {name: forge.pyramid(300, floor, rng) for name, floor in (("A", 0.0), ("B", -1.0))}
    chain = forge.Chain(("|", "A", "B"), operands, {"A": "a", "B": "b"}, ([-2000] * 3, [2000] * 3))
    subject = forge.Subject(chain, False)
    codes = b"".join(bytes([forge.ON]) + rng.choice(solid.places((0, 0, 9))) for solid in operands.values())
    yield "too_much_work", *Case(subject).with_answers(forge.Plan(subject, [forge.Line(["0", "0", "9"], "on", codes)], "exact"))


def shells(rng):
    """Lines name shells, which expressions do not have."""
    case, plan = random_case(rng)
    text = plan.answers().decode().splitlines(keepends=True)
    number = rng.randrange(len(text))
    text[number] = text[number][:-2] + "0\n"
    other = plan.copy()
    other.answers = lambda: "".join(text).encode()
    yield "shell", *case.with_answers(other)


def expression_attacks(rng):
    r = rng.random()
    if r < .01:
        return too_much_work(rng)
    if r < .2:
        return false_lines(rng)
    sources = (other_files, other_files, changed_files, narrow_boxes, split_variables, open_meshes, curved_walls, bad_fans, bad_fans, wrong_numbers,
               shells)
    return rng.choice(sources)(rng)


def honest(rng):
    """A true certificate, and others: with other codes, without some lines' proofs."""
    case, plan = random_case(rng)
    yield "expression", *case.with_answers(plan)
    lines = [forge.true_line(case.subject, line.point(plan.decimals), rng, plan.decimals) for line in plan.lines]
    yield "expression_other_codes", *case.with_answers(plan.copy(lines=lines))
    number = rng.randrange(len(plan.lines))
    yield "expression_undecided", *case.with_answers(plan.with_line(number, word="undecided", codes=b""))
    if plan.lines[number].codes:
        marked = plan.with_line(number, word=rng.choice(WORDS), codes=bytes([forge.NOT_COVERED]))
        yield "expression_not_covered", *case.with_answers(marked)
    case, plan = at_pole(rng)
    yield "expression_pole", *case.with_answers(plan)


def beside(py, files):
    """What check() of this checker needs to read the files."""
    return "", forge.Files(files, sys.modules[py.__package__ + ".common.errors"].Refused)


class Native(attacks.Native):
    """The C++ checker, with files beside the model."""

    def check(self, model, cert, answers, files):
        for name in files:
            path = os.path.join(self.dir, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as f:
                f.write(files[name])
        try:
            return super().check(model, cert, answers)
        finally:
            for name in files:
                os.remove(os.path.join(self.dir, name))

    def close(self):
        for folder, _, _ in sorted(os.walk(self.dir), reverse=True)[:-1]:
            os.rmdir(folder)
        super().close()


class Run(attacks.Run):
    """Both checkers may refuse a file (exit 4) in the place of rejecting it."""
    conditions, often_enough = CONDITIONS, 10
    attacks, honest_certificates = staticmethod(expression_attacks), staticmethod(honest)

    def __init__(self, options):
        super().__init__(options)
        self.native = Native(options.checker)

    def more(self, case):
        return case.answers, case.files

    def in_python(self, model, cert, answers, files):
        return super().in_python(model, cert, answers, beside(self.py, files))

    def try_alone(self, case, cert, found):
        if self.py._check(case.bytes, cert, frozenset([found]), case.answers, beside(self.py, case.files))[0] == 0:
            self.alone[found] += 1

    def both(self, case, cert, seed, name):
        code, message = self.in_python(case.bytes, cert, case.answers, case.files)
        found = attacks.condition_of(code, message)
        if code not in (0, 1, 4):
            self.fail("python checker: " + message, case.bytes, cert, seed, name, *self.more(case))
        if self.options.checker:
            code2, message2 = self.native.check(case.bytes, cert, case.answers, case.files)
            found2 = attacks.condition_of(code2, message2)
            if (code, found) != (code2, found2):
                self.fail("the checkers disagree: %r, %r" % (message, message2), case.bytes, cert, seed, name, *self.more(case))
            if code2 == 0 and code != 0:
                found = "ACCEPT"
        return found

    def fail(self, why, model, cert, seed, name, answers, files):
        super().fail(why, model, cert, seed, name, answers)
        folder = pathlib.Path(self.options.save) / ("files%d" % len(self.failures))
        for path, data in files.items():
            target = folder / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)


def missing_conditions(alone):
    return attacks.missing_conditions(alone, CONDITIONS)


def figures(table, honest_found, failures, options, seconds):
    yield "expression_attacks", sum(table.values()), options.count
    yield "expression_attacks_accepted", sum(n for (_, c), n in table.items() if c == "ACCEPT"), 0
    yield "expression_checker_disagreements", sum("disagree" in f for f in failures), 0
    yield "honest_expression_certificates", sum(honest_found.values()), options.honest
    yield "honest_expression_certificates_rejected", sum(n for (_, c), n in honest_found.items() if c != "ACCEPT"), 0
    yield "seconds", round(seconds, 1), None


def main(argv):
    options, start = attacks.parse(argv), time.monotonic()
    table, alone, honest_found, failures = attacks.run_all(options, Run)
    attacks.print_table(table, alone, [c for c in CONDITIONS if c != "B1"])
    return attacks.report(failures, figures(table, honest_found, failures, options, time.monotonic() - start),
                          missing_conditions(alone) if options.count >= 20000 else ())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
