#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Lying provers against both checkers of the claim points-1: a file of answers about points has a false line, or the triangles do not
close, and everything else is right. As attacks.py, whose harness this is. Run

    python3 tests/mutation/points_liars.py --count 20000 --seed 1 --checker PATH_TO_veritope-check
"""
import copy
import itertools
import sys
import time
from fractions import Fraction

import attacks
import forge
import patch_points_forge as curved
import points_forge
import solids

CONDITIONS = ["A1", "A2", "B1", "P1", "P2", "P3", "P4"]
DIRECTIONS = [tuple(s * (i == k) for i in range(3)) for k in range(3) for s in (1, -1)]
MOST_TRIANGLES = 80


class Case:
    """A model and its reading. answers: of the attack."""

    def __init__(self, points, tris, rng):
        self.model = forge.Model(points, tris, rng.choice(forge.FORMATS), rng.random() < .4, rng.randrange(3))
        self.bytes, self.mesh, self.answers = self.model.encode(), forge.mesh_of(self.model), b""

    def plan(self, rng, count=8):
        points = points_forge.interesting(self.mesh, rng, count)
        return points_forge.true_plan(self.mesh, points, rng, rng.choice(("nearest", "exact")), rng.random() < .6)

    def with_answers(self, plan):
        """(this case with the answers of a plan, its certificate)"""
        case = copy.copy(self)
        case.answers = plan.answers()
        return case, plan.certificate(self.bytes, self.model)


def shape(rng):
    """Points and triangles of a closed chain, often of a solid."""
    while True:
        points, tris = points_forge.chain(rng) if rng.random() < .5 else solids.solid(rng)
        if len(tris) <= MOST_TRIANGLES:
            if rng.random() < .2:                         # coordinates with many digits
                return [tuple(c * k for c, k in zip(p, (.1, .3, 1e-9))) for p in points], tris
            return solids.affine(points, rng), tris


def closed_case(rng):
    while True:
        case = Case(*shape(rng), rng)
        if points_forge.is_closed(case.mesh):             # coordinates with many digits may make two vertices one
            return case


def lies(name, case, plans):
    """The attacks of those plans whose claim is false because a line is."""
    for plan in plans:
        if not all(points_forge.holds(plan.mesh, line, plan.decimals) for line in plan.lines):
            yield name, *case.with_answers(plan)


def with_words(plan, *words):
    return [number for number, line in enumerate(plan.lines) if line.word in words]


def off_lines(plan):
    return with_words(plan, "in", "out", "-")


# ---------------------------------------------------------------- liars about lines

def other_f(case, plan, rng):
    """f is another number, and the word agrees with it."""
    for number in off_lines(plan):
        f = int(plan.lines[number].f)
        others = {f + 1, f - 1, -f, f + 2, rng.randint(-2 ** 31, 2 ** 31)} if plan.winding else {1 - f}
        for other in sorted(others):
            line = points_forge.off_line(plan.lines[number].tokens, other, plan.lines[number].shell, rng.randrange(6), plan.winding)
            yield plan.with_line(number, **vars(line))


def other_triangle(case, plan, rng):
    """A point lies on another triangle than the code says: on a neighbour, mostly."""
    tris = case.mesh.tris
    for number in with_words(plan, "on"):
        near = [f for f, t in enumerate(tris) if set(t) & set(tris[plan.lines[number].code])]
        for f in rng.sample(near, min(len(near), 4)) + [rng.randrange(len(tris))]:
            yield plan.with_line(number, code=f)


def on_as_off(case, plan, rng):
    """A point on a triangle is said to be off all; every f that a ray may find."""
    for number in with_words(plan, "on"):
        line = plan.lines[number]
        for f, direction in itertools.product((-2, -1, 0, 1, 2) if plan.winding else (0, 1), range(6)):
            yield plan.with_line(number, **vars(points_forge.off_line(line.tokens, f, "-", direction, plan.winding)))


def off_as_on(case, plan, rng):
    """A point off all triangles is said to be on one whose box holds it, or on any."""
    for number in off_lines(plan):
        at = [c / case.mesh.unit for c in plan.lines[number].point(plan.decimals)]
        near = [f for f, box in enumerate(case.mesh.box) if all(low <= c <= high for c, (low, high) in zip(at, box))]
        for f in near[:3] + [rng.randrange(len(case.mesh.tris))]:
            yield plan.with_line(number, word="on", f="-", code=f)


def moved(case, plan, rng):
    """Other coordinates, and the answer of those that were there: by a hair, across the model, or those of another point."""
    sizes = [max(c) - min(c) or 1 for c in zip(*[map(Fraction, p) for p in case.mesh.floats])]
    for number, line in enumerate(plan.lines):
        at, k = line.point(plan.decimals), rng.randrange(3)
        for step in (Fraction(1, 2 ** 70), Fraction(-1, 2 ** 70), Fraction(1, 3), Fraction(rng.randint(-9, 9), 8)):
            other = [c + step * sizes[k] * (i == k) for i, c in enumerate(at)]
            yield plan.with_line(number, tokens=[rng.choice(points_forge.tokens_of(c, plan.decimals)) for c in other])
        yield plan.with_line(number, tokens=rng.choice(plan.lines).tokens)
        yield plan.with_line(number, tokens=[line.tokens[i] for i in rng.sample(range(3), 3)])


def other_decimals(case, plan, rng):
    """What decimals mean is changed. The points are vertices in the fewest digits that round to them."""
    vertices = rng.sample(case.mesh.floats, min(4, len(case.mesh.floats)))
    lines = [points_forge.true_line(case.mesh, p, rng, "nearest", plan.winding, [repr(c) for c in p]) for p in vertices]
    yield plan.copy(lines=lines, decimals="exact")
    yield plan.copy(decimals="exact" if plan.decimals == "nearest" else "nearest")


ABOUT_LINES = (other_f, other_triangle, on_as_off, off_as_on, moved, other_decimals)


def false_lines(rng):
    case = closed_case(rng)
    plan = case.plan(rng)
    for liar in ABOUT_LINES:
        found = list(lies(liar.__name__, case, liar(case, plan, rng)))
        yield from rng.sample(found, min(len(found), 8))


# ---------------------------------------------------------------- the other liars

def open_chain(rng):
    """A triangle is missing, turned, there once more, or has a vertex of its own; f is what the ray finds."""
    while True:
        points, tris = shape(rng)
        points, tris = list(points), list(tris)
        f = rng.randrange(len(tris))
        a, b, c = tris[f]
        defect = rng.randrange(4)
        if defect == 3:
            points.append(points[a])
        tris[f:f + 1] = ([], [(a, c, b)], [(a, b, c)] * 2, [(len(points) - 1, b, c)])[defect]
        if tris:
            case = Case(points, tris, rng)
            if not points_forge.is_closed(case.mesh):
                break
    lines = []
    for point in points_forge.interesting(case.mesh, rng, 6):
        direction = rng.randrange(6)
        f = None if points_forge.triangles_at(case.mesh, point) else points_forge.crossings(points_forge.around(case.mesh, point), DIRECTIONS[direction])
        if f is not None:
            lines.append(points_forge.off_line([rng.choice(points_forge.tokens_of(c, "exact")) for c in point], f, "-", direction, True))
    for some in (lines, lines[:1], []):
        yield "open_chain", *case.with_answers(points_forge.Plan(case.mesh, some, "exact", True))


def wrong_statement(rng):
    """Numbers of lines, the flag of windings, and another file of answers."""
    case = closed_case(rng)
    plan = case.plan(rng)
    true = plan.quantities()
    for key, step in itertools.product(("points", "on", "undecided"), (1, -1)):
        if true[key] + step >= 0:
            yield "wrong_count", *case.with_answers(plan.copy(values={key: true[key] + step}))
    if off_lines(plan):
        yield "other_winding_flag", *case.with_answers(plan.copy(values={"winding": not plan.winding}))
    number = rng.randrange(len(plan.lines))
    line = plan.lines[number]
    if line.word != "undecided":
        yield "other_answers", *case.with_answers(plan.with_line(number, shell="1" if line.shell == "-" else "-").copy(claimed_answers=plan.answers()))
    yield "other_answers", *case.with_answers(plan.copy(claimed_answers=plan.answers() + plan.lines[0].text().encode()))


def wrong_body(rng):
    """Bytes too many, too few or out of range; the hash of the body is right."""
    case = closed_case(rng)
    plan = case.plan(rng)
    yield "wrong_body", *case.with_answers(plan.copy(extra=rng.choice((b"\0", b"\5", bytes(9)))))
    yield "wrong_body", *case.with_answers(plan.copy(magic=b"VTMV"))
    for number, line in enumerate(plan.lines):
        codes = {"on": (None, len(case.mesh.tris), 2 ** 64 - 1), "undecided": ()}.get(line.word, (None, 6, 255))
        for code in codes:
            yield "wrong_body", *case.with_answers(plan.with_line(number, code=code))


def too_much_work(rng):
    """Five hundred copies of a tetrahedron, all of whose faces have its box as theirs, and a few points in it more than the bound allows."""
    points, tris = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)] * 500
    case = Case(points, tris, rng)
    within = ["1/%d" % rng.randint(5, 99) for _ in range(3)]
    line = points_forge.off_line(within, 500, "-", rng.randrange(6), True)
    yield "too_much_work", *case.with_answers(points_forge.Plan(case.mesh, [line] * rng.randint(21, 23), "exact", True))


# ---------------------------------------------------------------- spline models

class PatchCase:
    """A spline model. answers: of the attack."""

    def __init__(self, solid):
        self.solid, self.bytes, self.answers, self.model = solid, solid.encode(), b"", None

    with_answers = Case.with_answers


def patch_case(rng):
    case = PatchCase(curved.solid(rng))
    return case, curved.true_plan(case.solid, rng)


def patch_lies(name, case, plans):
    for plan in plans:
        if not all(curved.holds(plan.mesh, line, plan.decimals) for line in plan.lines):
            yield name, *case.with_answers(plan)


def other_f_of_patches(case, plan, rng):
    for number in off_lines(plan):
        f = int(plan.lines[number].f)
        for other in {f + 1, f - 1, -f, f + 2, rng.randint(-2 ** 31, 2 ** 31)} if plan.winding else {1 - f}:
            line = points_forge.off_line(plan.lines[number].tokens, other, plan.lines[number].shell, rng.randrange(6), plan.winding)
            yield plan.with_line(number, **vars(line))


def other_parameters(case, plan, rng):
    """Parameters of another point, of another patch, exchanged, or beyond the domain: planes and spheres go on there."""
    for number in with_words(plan, "on"):
        patch, at = plan.lines[number].code
        if isinstance(at, curved.Root):
            yield from (plan.with_line(number, code=(patch, root)) for root in other_roots(at, rng))
            continue
        u, v = at
        step = Fraction(1, rng.choice((2, 64, 2 ** 70)))
        for at in ((u + step, v), (u, v - step), (v, u), (1 - u, v), (1 - v, 1 - u), (-u, v), (u, 2 - v), (u + 1, v), (Fraction(0), v)):
            yield plan.with_line(number, code=(patch, at))
        yield plan.with_line(number, code=(rng.randrange(len(case.solid.entities)), (u, v)))


def other_roots(root, rng):
    """Another polynomial, an interval without the root, or other functions of it."""
    step, (a, b) = Fraction(1, rng.choice((2, 64, 2 ** 70))), root.ends
    yield root.changed(modulus=[root.modulus[0] + step, *root.modulus[1:]])
    yield root.changed(modulus=[c * c for c in root.modulus])
    yield root.changed(ends=(b, b + 1))
    yield root.changed(ends=(a - 1, a))
    for name, p in (("u", root.u), ("v", root.v)):
        yield root.changed(**{name: [p[0] + step, *p[1:]]})
        yield root.changed(**{name: [*p, step]})


def beyond_the_domain(case, plan, rng):
    """A point of the surface on which a patch lies, but not of the patch."""
    patch = rng.randrange(len(case.solid.entities))
    for at in ((Fraction(5, 4), Fraction(1, 2)), (Fraction(1, 2), Fraction(-1, 4)), (Fraction(3, 4), Fraction(1, 2)), (Fraction(-1, 2), Fraction(1, 2))):
        q = curved.point_at(case.solid.entities[patch], at)
        line = curved.PatchLine([rng.choice(points_forge.tokens_of(c, "exact")) for c in q], "on", "-", "-", (patch, at))
        yield plan.copy(lines=[*plan.lines, line])


def off_as_on_patch(case, plan, rng):
    for number in off_lines(plan):
        patch = rng.randrange(len(case.solid.entities))
        yield plan.with_line(number, word="on", f="-", code=(patch, curved.parameters(case.solid.entities[patch], rng)))


def on_patch_as_off(case, plan, rng):
    """Both checkers cut the patches until the work is too much."""
    for number in with_words(plan, "on")[:1]:
        yield plan.with_line(number, **vars(points_forge.off_line(plan.lines[number].tokens, rng.randint(0, 1), "-", rng.randrange(6), plan.winding)))


def moved_by_a_hair(case, plan, rng):
    """Other coordinates, and the answer of those that were there."""
    for number, line in enumerate(plan.lines):
        at, k = line.point("exact"), rng.randrange(3)
        for step in (Fraction(1, 2 ** 70), Fraction(-1, 2 ** 70), Fraction(1, 3), Fraction(rng.randint(-9, 9), 8)):
            other = [c + step * (i == k) for i, c in enumerate(at)]
            yield plan.with_line(number, tokens=[rng.choice(points_forge.tokens_of(c, "exact")) for c in other])
        yield plan.with_line(number, tokens=rng.choice(plan.lines).tokens)


ABOUT_PATCHES = (other_f_of_patches, other_parameters, beyond_the_domain, off_as_on_patch, moved_by_a_hair)


def false_lines_about_patches(rng):
    case, plan = patch_case(rng)
    for liar in ABOUT_PATCHES + ((on_patch_as_off,) if rng.random() < .1 else ()):
        found = list(patch_lies(liar.__name__, case, liar(case, plan, rng)))
        yield from rng.sample(found, min(len(found), 6))


def open_patches(rng):
    """An entity is missing, turned, there once more, or has a control point of its own."""
    case, plan = patch_case(rng)
    entities = list(case.solid.entities)
    at = rng.randrange(len(entities))
    change = rng.randrange(4)
    if change == 3:
        entity = copy.deepcopy(entities[at])
        corner = entity["shape"]["points"][0]
        corner[rng.randrange(3)] = "1/1048576"
        entities[at] = entity
    else:
        entities[at:at + 1] = ([], [curved.reversed_entity(entities[at])], [entities[at]] * 2)[change]
    lines = [line for line in plan.lines if line.word != "on"]
    if entities:
        solid = curved.Solid(case.solid.parts)
        solid.entities = entities
        for some in (lines, lines[:1], []):
            yield "open_patches", *PatchCase(solid).with_answers(curved.PatchPlan(solid, some, "exact", plan.winding))


def wrong_body_of_patches(rng):
    """Bytes too many, too few or out of range."""
    case, plan = patch_case(rng)
    body = plan.body()
    for changes in ({"extra": rng.choice((b"\0", b"\5", bytes(9)))}, {"magic": b"VTSB"}, {"breaks": b""}, {"breaks": body[20:-1]}):
        if "breaks" not in changes or plan.copy(**changes).body() != body:
            yield "wrong_body_of_patches", *case.with_answers(plan.copy(**changes))
    wrong = {"on": (b"", b"\xff\xff\x7f\0\0\1\0\1", b"\0\2\0\1\0\1", b"\0\xff\0\1\0\1", b"\0\0\4\2\0\1", b"\0\0\2\0\0\1", b"\0\0\0\1"),
             "undecided": (b"\0",)}
    for number, line in enumerate(plan.lines):
        for code in wrong.get(line.word, (b"", b"\6", b"\xff", b"\0\0")):
            yield "wrong_body_of_patches", *case.with_answers(plan.with_line(number, code=code))
    for step in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        other = plan.copy()
        other.head = lambda step=step: [len(plan.mesh.entities) + s for s in step]
        yield "wrong_body_of_patches", *case.with_answers(other)


def patch_attacks(rng):
    r = rng.random()
    return false_lines_about_patches(rng) if r < .7 else open_patches(rng) if r < .85 else wrong_body_of_patches(rng)


def honest_about_patches(rng):
    case, plan = patch_case(rng)
    yield "patches", *case.with_answers(plan)
    for number in off_lines(plan)[:2]:
        for direction in range(6):
            yield "patches_other_direction", *case.with_answers(plan.with_line(number, code=direction))
    number = rng.randrange(len(plan.lines))
    yield "patches_undecided", *case.with_answers(plan.with_line(number, word="undecided", f="-", shell="-", code=None))


def points_attacks(rng):
    if rng.random() < .4:
        return patch_attacks(rng)
    r = rng.random()
    if r < .004:
        return too_much_work(rng)
    return false_lines(rng) if r < .7 else open_chain(rng) if r < .85 else wrong_statement(rng) if r < .95 else wrong_body(rng)


def honest(rng):
    """A true certificate, and others of the same claim: in other directions, on other triangles at the point, in other words for a number."""
    if rng.random() < .4:
        yield from honest_about_patches(rng)
        return
    case = closed_case(rng)
    plan = case.plan(rng)
    yield "points", *case.with_answers(plan)
    for number in off_lines(plan)[:3]:
        for direction in range(6):
            yield "points_other_direction", *case.with_answers(plan.with_line(number, code=direction))
    for number in with_words(plan, "on")[:3]:
        for f in points_forge.triangles_at(case.mesh, plan.lines[number].point(plan.decimals)):
            yield "points_other_triangle", *case.with_answers(plan.with_line(number, code=f))
    number = rng.randrange(len(plan.lines))
    for tokens in itertools.islice(itertools.product(*(points_forge.tokens_of(c, plan.decimals) for c in plan.lines[number].point(plan.decimals))), 4):
        yield "points_other_tokens", *case.with_answers(plan.with_line(number, tokens=tokens))
    yield "points_undecided", *case.with_answers(plan.with_line(number, word="undecided", f="-", shell="-", code=None))


class Run(attacks.Run):
    conditions = CONDITIONS
    attacks, honest_certificates = staticmethod(points_attacks), staticmethod(honest)

    def more(self, case):
        return (case.answers,)


def missing_conditions(alone):
    return attacks.missing_conditions(alone, CONDITIONS)


def figures(table, honest_found, failures, options, seconds):
    yield "points_attacks", sum(table.values()), options.count
    yield "points_attacks_accepted", sum(n for (_, c), n in table.items() if c == "ACCEPT"), 0
    yield "points_checker_disagreements", sum("disagree" in f for f in failures), 0
    yield "honest_points_certificates", sum(honest_found.values()), options.honest
    yield "honest_points_certificates_rejected", sum(n for (_, c), n in honest_found.items() if c != "ACCEPT"), 0
    yield "seconds", round(seconds, 1), None


def main(argv):
    options, start = attacks.parse(argv), time.monotonic()
    table, alone, honest_found, failures = attacks.run_all(options, Run)
    attacks.print_table(table, alone, [c for c in CONDITIONS if c != "B1"])
    return attacks.report(failures, figures(table, honest_found, failures, options, time.monotonic() - start),
                          missing_conditions(alone) if options.count >= 20000 else ())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
