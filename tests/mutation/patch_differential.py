#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Do both checkers read every odd spline model, and judge every damaged certificate about one, alike?

Models of all formats, of surfaces and of volumes: the numbers of a sound model are written in other ways that mean the same, so that
its certificate must still be accepted; or the text is damaged.  Certificates of all claims: bodies and statements are damaged, hashes set
right again.  --only formats: models in .g2 and MFEM's format, and models of volumes; --only certificates,
--only sheets, --only vmodels, --only invalid_vmodels: those.

    python3 tests/mutation/patch_differential.py --count 50000 --seed 1 --checker PATH_TO_veritope-check
"""
import hashlib
import itertools
import json
import random
import re
import sys
import time
from fractions import Fraction as Q

import attacks
import collar_liars
import differential
import fold_liars
import format_cases as formats
import invalid_liars
import meeting_liars
import patch_attacks
import patch_liars
import patch_solids as ps
import sheet_liars
import star_box_itd_test as itd
import vmodel_invalid_liars
import vmodel_liars
import volume_folded_test as fold_tests

NUMBERS = [b"0", b"1", b"-1", b"+1", b"-0", b"1.", b".5", b".", b"", b"+", b"-", b"--1", b"1e", b"e1", b"1e1", b"1E+1", b"1e-1", b"1e+", b"1e4096",
           b"1e-4096", b"1e4097", b"1e-04097", b"1e" + b"0" * 16000 + b"1", b"0x1", b"0X.8", b"0x1p3", b"0x1P-4096", b"0x1p4097", b"0x", b"0x.p1", b"0x1g",
           b"-0x1.8p+1", b"1/2", b"-3/6", b"1/0", b"0/1", b"1/-2", b"+1/2", b"1/2/3", b"/2", b"1/", b"1e1/2", b"1.5/2", b"0x1/2", b"9" * 1000, b"9" * 1001, b"9" * 5096, b"9" * 5097,
           b"1/" + b"9" * 5097, b"." + b"9" * 1001, b"0" * 999 + b".5", b"0" * 1000 + b".5", b"nan", b"inf", b"1_0", b"1 ", b" 1", b"\xd9\xa1", b"1\\u0030", b"\\u0031", b"1\\n", b"1d0",
           b"1.2.3", b"1\x00"]
WORDS = [b"null", b"true", b"false", b"0", b"1", b"2", b"3", b"4", b"-1", b"-0", b"00", b"01", b"1.0", b"1e0", b"15", b"16", b"63", b"64", b"1001", b"1002", b"999999999999999",
         b"1000000000000000", b"1" * 30, b"NaN", b"-Infinity", b"[]", b"{}", b'""', b'"a"', b"[[]]", b"[1]", b"{}", b"[", b"]", b"{", b"}", b",", b":", b"nul", b"True", b"'a'",
         b'"surface"', b'"triangle"', b'"curve"', b'"model"', b'"kind"', b'"shape"', b'"points"', b'"knots"', b'"periodic"', b'"rational"', b'"degree"', b'"components"']
STRINGS = [b"\\u0041", b"\\q", b"\\u12", b"\\u12g4", b"\\ud800", b"\\udc00", b"\\ud83d\\ude00", b"\\ud83dx", b"\\ud83d\\u0041", b"\\", b"\\\"", b"\\/", b"\n", b"\t", b"\x00", b"\x1f", b"\x7f",
           b"\x80", b"\xc0\x80", b"\xc3\xa9", b"\xe2\x82\xac", b"\xed\xa0\x80", b"\xf0\x9f\x98\x80", b"\xf4\x90\x80\x80", b"\xf8\x88\x80\x80\x80", b"\xc3", b"\xff", b"\xef\xbb\xbf", b"\\u0000"]
SPACES = [b" ", b"\n", b"\t", b"\r", b"\x0b", b"\x0c", b"\xa0", b"\xe2\x80\xa8", b"\x00", b"/**/", b"//\n", b"#", b"\xef\xbb\xbf", b",", b"\x1a"]
ITD = [b"[", b"]", b'"', b"\\", b"\\\"", b"[a]", b'"]"', b"[OBJECT", b"[OBJECT A]", b"[SURFACE", b"SURFACE", b"MULTIVAR", b"[NUMBER 1]", b"[CURVE]", b"CTLPT", b"KV", b"KVP", b"BEZIER", b"BSPLINE", b"POWER",
       b"E3", b"P3", b"E2", b"+2", b"-2", b"02", b"2.", b"2e0", b"1", b"3", b"64", b"65", b"9" * 20, b"\x0b", b"\x0c", b"\x00", b"\xff", b"\xef\xbb\xbf", b"object", b"\x1c", b"\x85", b"#", b"TRIMCRV"]
JSON_TOKEN = re.compile(rb'"(?:[^"\\]|\\.)*"|[^\s"\[\]{},:]+|[\[\]{},:]')
ITD_TOKEN = re.compile(rb'[\[\]]|"(?:[^"\\]|\\.)*"|[^ \t\n\r\x0b\x0c\[\]"]+')
OTHER = {"kind": "curve", "group": 0, "attributes": ["a"], "shape": {"degrees": [1], "periodic": [False], "knots": [["0", "0", "1", "1"]], "rational": False, "components": 2,
                                                                     "points": [["0", "0"], ["1", "1"]]}}


# ---------------------------------------------------------------- models

def small_model(rng):
    """(entities, plan): the plan is the certificate's."""
    proof = ps.solid(rng, 0)
    return proof.entities, proof.plan


def put_text(entities, rng, with_others):
    model = {"format": "veritope-spline-1", "groups": [], "entities": entities}
    if rng.random() < .5:
        model["groups"] = [{"name": "A \u20ac", "parent": None, "attributes": []}, {"name": "b", "parent": 0, "attributes": ["x", ""]}]
        if with_others:
            model["entities"] = entities + [OTHER]
    return json.dumps(model, ensure_ascii=rng.random() < .5, separators=rng.choice(((",", ":"), (", ", ": ")))).encode()


def other_form(text, rng):
    """Another text of the same number."""
    q = Q(text)
    forms = ["%d/%d" % (k * q.numerator, k * q.denominator) for k in (1, rng.randint(1, 99))]
    if q.denominator & q.denominator - 1 == 0:
        n, e = q.numerator, 1 - q.denominator.bit_length()
        k = rng.randint(0, 9)
        forms += ["%s0x%xp%d" % ("-" * (n < 0), abs(n) << k, e - k), "%s0X%X.%sP%+d" % ("-" * (n < 0), abs(n), "0" * k, e)]
        digits, e = n * 5 ** -e, e
        forms += ["%de%d" % (digits, e), "%d.%sE%+05d" % (digits, "0" * k, e)]
        body = "%0*d" % (1 - e, abs(digits))
        forms += ["-" * (n < 0) + body[:len(body) + e] + "." + body[len(body) + e:]]
    form = rng.choice(forms)
    if rng.random() < .2:
        form = (form[0] if form[0] in "+-" else rng.choice(("", "+"))) + ("000" if "x" not in form.lower() else "") + form.lstrip("+-")
    return form


def rewritten(entities, rng):
    """Rewrites the entities with numbers in other forms and all keys in another order, kind before shape."""
    def numbers(value):
        return [numbers(v) for v in value] if isinstance(value, list) else other_form(value, rng) if rng.random() < .7 else value

    def shuffled(pairs):
        pairs = list(pairs)
        rng.shuffle(pairs)
        return dict(sorted(pairs, key=lambda kv: kv[0] == "shape"))

    return [shuffled({**e, "shape": shuffled((k, numbers(v) if k in ("knots", "points") else v) for k, v in e["shape"].items())}.items()) for e in entities]


def damaged_text(data, token, words, rng):
    found = list(token.finditer(data))
    if not found:
        return data
    m, kind = rng.choice(found), rng.randrange(12)
    a, b = m.span()
    if kind == 0:
        return data[:a] + data[b:]
    if kind == 1:
        return data[:b] + m[0] + data[b:]
    if kind == 2:
        i = rng.randrange(len(found))
        j = min(i + rng.randint(1, 3), len(found) - 1)
        (c, d), (e, f) = found[i].span(), found[j].span()
        return data[:c] + data[e:f] + data[d:e] + data[c:d] + data[f:] if i < j else data
    if kind in (3, 4):
        number = rng.choice(NUMBERS)
        return data[:a] + (b'"' + number + b'"' if token is JSON_TOKEN else number) + data[b:]
    if kind in (5, 6):
        return data[:a] + rng.choice(words) + data[b:]
    if kind == 7:
        at = rng.choice((a, b))
        return data[:at] + rng.choice(words) + data[at:]
    if kind == 8:
        at = rng.randint(a, b)
        return data[:at] + rng.choice(STRINGS) + data[at:]
    if kind == 9:
        at = rng.choice((a, b, 0, len(data)))
        return data[:at] + rng.choice(SPACES) + data[at:]
    if kind == 10:
        return data[:rng.randrange(len(data))]
    at = rng.randrange(len(data))
    return data[:at] + bytes([rng.choice((rng.randrange(256), data[at] ^ 1 << rng.randrange(8)))]) + data[at + 1:]


def moved_number(data, rng):
    """A number of one list becomes the last of the one before it, or a part of the text comes twice."""
    spots = [m.start() for m in re.finditer(rb'\], ?\["', data)]
    if spots and rng.random() < .7:
        at = rng.choice(spots)
        m = re.compile(rb'\](, ?)\[("[^"]*")(, ?)?').match(data, at)
        return data[:at] + (m[1] + m[2] + b"]" + m[1] + b"[") + data[m.end():] if m else data
    at = rng.randrange(len(data))
    part = data[at:at + rng.randrange(200)]
    return data[:at] + part + data[at:]


TOKENS = {"vjson": (JSON_TOKEN, WORDS), "itd": (ITD_TOKEN, ITD), "g2": (formats.WORD, formats.G2), "mfem": (formats.WORD, formats.MFEM)}


def sound_model(rng, only=""):
    """(subject format, text, plan): a certificate of the plan is accepted for this text."""
    if rng.random() < (.2 if only == "formats" else .08):
        return formats.folded_model(rng)
    if rng.random() < (.6 if only == "formats" else .25):
        return formats.volume_model(rng)
    entities, plan = small_model(rng)
    try:
        chosen = rng.choice(("g2", "mfem") if only == "formats" else ("vjson", "vjson", "vjson", "itd", "itd", "g2", "mfem"))
        if chosen == "itd":
            return chosen, ("x\n[OBJECT [a 1] N\n" + itd.itd_text(entities) + "]\n").encode(), plan
        if chosen != "vjson":
            return chosen, formats.surfaces(entities, chosen, rng), plan
    except (KeyError, ValueError):                        # a triangle, or a number that is not a decimal
        pass
    return "vjson", put_text(entities if rng.random() < .3 else rewritten(entities, rng), rng, rng.random() < .2), plan


def model_case(rng, only=""):
    """(name, model, certificate)."""
    subject_format, data, plan = sound_model(rng, only)
    name = "same" if rng.random() < .2 and OTHER["kind"].encode() not in data else subject_format
    kind = subject_format.split("-")[0]
    for _ in range(0 if name == "same" else rng.choice((1, 1, 1, 2, 3))):
        r = rng.random()
        if kind == "vjson" and r < .08:
            data = moved_number(data, rng)
        elif kind in ("g2", "mfem") and r < .5:
            data = rng.choice((formats.exchanged, formats.another_number, formats.another_number))(data, rng)
        else:
            data = damaged_text(data, *TOKENS[kind], rng)
    if rng.random() < .5 and name != "same":
        return name, data, itd.hollow(data, subject_format)
    values = dict(plan.values)
    plan.values = dict(values, subject_format=subject_format)
    cert = plan.certificate(data)
    plan.values = values
    return name, data, cert


# ---------------------------------------------------------------- certificates

def bent_cases(rng):
    """Sound thin models with bodies of version 2 in which a field is another one; hashes and counts are right."""
    plan = sheet_liars.sound(rng)
    for lie in rng.sample(sheet_liars.LIES, 4):
        for new in lie(plan, rng):
            yield "bent_" + lie.__name__, *sheet_liars.encoded(new)


def sheet_cases(rng):
    """Bodies of version 2, honest or not: bent, damaged in some bytes."""
    if rng.random() < .5:
        yield from bent_cases(rng)
        return
    if rng.random() < .6:
        plan = sheet_liars.sound(rng)
    else:
        plan = sheet_liars.sheet_models.false_model(rng)[1]
    model, cert = sheet_liars.encoded(plan)
    for _ in range(12):
        yield "damaged_sheets", model, damaged_certificate(cert, rng)


def vmodel_cases(rng):
    """Certificates of V-models, damaged before X; random cells, glued at random, with signs that hold or not."""
    if rng.random() < .5:
        plan = vmodel_liars.false_plan(rng)[1] if rng.random() < .4 else vmodel_liars.true_plan(rng)
        model, cert = plan.model(), plan.certificate()
        tail = plan.x.body()
        for _ in range(12):
            head = damaged_certificate(cert[:len(cert) - len(tail)], rng)
            line, _, body = head.partition(b"\n")
            old, new = (hashlib.sha256(b).hexdigest().encode() for b in (cert.partition(b"\n")[2], body + tail))
            yield "damaged_vmodel", model, line.replace(old, new) + b"\n" + body + tail
        return
    maps = [fold_tests.random_volume(rng) for _ in range(rng.choice((1, 1, 2)))]
    if len(maps) == 2 and rng.random() < .7:
        axes, reverse = rng.sample(range(3), 3), [rng.randrange(2) for _ in range(3)]
        maps[1] = vmodel_liars.models.permuted(maps[0], axes, reverse)
    plan = vmodel_liars.forge.Plan(maps, [rng.randrange(2) for _ in maps])
    for m, added in zip(maps, plan.added):
        for axis, knots in enumerate(m.knots):
            if rng.random() < .2:
                t = knots[0] + (knots[-1] - knots[0]) * Q(rng.randint(1, 1000), 1001)
                added[axis] += [] if t in knots else [t]
    faces = vmodel_liars.forge.Faces(maps, plan.added)
    for signs in (rng.random() < .7, False, False):
        plan.codes = vmodel_liars.forge.glued(faces, plan.flags)
        plan.entries = vmodel_liars.forge.signs_of(plan, 2) if signs else {rng.randrange(2): ([rng.randrange(26)], vmodel_liars.random_tree(rng, 5))}
        if rng.random() < .5:
            f = rng.randrange(len(plan.codes))
            plan.codes[f] = vmodel_liars.random_code(plan, f, rng)
        if rng.random() < .3:
            plan.codes = [2 if isinstance(code, tuple) or code == 2 else code for code in plan.codes]
            for f in range(0, len(plan.codes) - 1):
                if plan.codes[f] == 2 and rng.random() < .5:
                    plan.codes[f] = vmodel_liars.random_code(plan, f, rng)
        plan.settled()
        yield "random_vmodel", plan.model(), plan.certificate()


def cell_of_a_lattice(rng):
    """A cell whose corners are those of a cube, but that some are others: many faces and edges are collapsed, equal, or equal in several ways."""
    corners = list(itertools.product((0, 1), repeat=3))
    moved = {p: p for p in corners}
    for _ in range(rng.choice((0, 0, 1, 2, 4, 8))):
        moved[rng.choice(corners)] = rng.choice(corners)
    if rng.random() < .3:                                 # a face becomes a line, a line a point
        axis, end = rng.randrange(3), rng.randrange(2)
        across = rng.choice([a for a in range(3) if a != axis])
        moved = {p: moved[p[:across] + (0,) + p[across + 1:]] if p[axis] == end else image for p, image in moved.items()}
    shift = [rng.choice((0, 0, 0, 1, Q(1, 2))) for _ in range(3)]
    return fold_tests.forge.cube(lambda p: tuple(c + d for c, d in zip(moved[p], shift)))


def invalid_vmodel_cases(rng):
    """Findings about V-models, damaged; random findings about random cells with corners of a lattice."""
    liars = vmodel_invalid_liars
    if rng.random() < .4:
        found = list((liars.honest if rng.random() < .6 else liars.invalid_cells_attacks)(rng))
        for name, model, cert in rng.sample(found, min(1, len(found))):
            for _ in range(12):
                yield "damaged_" + name, model, damaged_certificate(cert, rng)
        return
    maps = [cell_of_a_lattice(rng) for _ in range(rng.randint(1, 4))]
    maps = liars.varied(maps + [rng.choice(maps)] if rng.random() < .3 else maps, rng)
    arcs = [a for arcs in liars.models.sides_by_curve(maps).values() for a in arcs]
    groups = [arcs for arcs in liars.models.sides_by_curve(maps).values() if len(arcs) > 2]
    findings = [("point-nonmanifold", (rng.randrange(len(maps)), rng.randrange(8))) for _ in range(4)]
    findings += [("curve-nonmanifold", rng.sample(rng.choice(groups), 3)) for _ in range(3) if groups]
    findings += [("curve-nonmanifold", rng.choices(arcs, k=3))] if arcs else []
    cell = rng.randrange(len(maps))
    findings += [("flat", (cell, [rng.randrange(len(set(t)) - 1) for t in maps[cell].knots])),
                 (rng.choice(("left-handed", "singular")), [(cell, liars.somewhere(maps[cell], rng))]),
                 ("overlap", [(c, liars.somewhere(maps[c], rng)) for c in (cell, rng.randrange(len(maps)))])]
    text = None
    for kind, parts in findings:
        finding = liars.Invalid(maps, kind, *parts)
        finding.text = text
        text = finding.model()
        yield "random_" + kind, text, finding.certificate()


def certificate_cases(rng):
    if rng.random() < .3:
        yield from vmodel_cases(rng) if rng.random() < .3 else invalid_vmodel_cases(rng) if rng.random() < .2 else sheet_cases(rng)
        return
    kinds = [patch_attacks.honest] * 5 + [patch_liars.star_attacks, invalid_liars.invalid_attacks, meeting_liars.meeting_attacks, fold_liars.fold_attacks]
    kind = collar_liars.collar_attacks if rng.random() < .02 else rng.choice(kinds)
    found = list(kind(rng))
    for name, model, cert in rng.sample(found, min(1, len(found))):
        for _ in range(12):
            yield "damaged_" + name.split("/")[0], model, damaged_certificate(cert, rng)


def damaged_certificate(cert, rng):
    line, _, body = cert.partition(b"\n")
    if rng.random() < .2:
        return differential.damage_statement(line, rng) + b"\n" + body
    old = hashlib.sha256(body).hexdigest().encode()
    for _ in range(rng.choice((1, 1, 2))):
        i, kind = rng.randrange(len(body)), rng.randrange(8)
        if rng.random() < .3:
            i = max(0, len(body) - 1 - rng.randrange(60))
        if kind == 0:
            body = body[:i] + body[i + rng.choice((1, 1, 4)):] or b"V"
        elif kind == 1:
            body = body[:i] + bytes([rng.choice((0, 1, 2, 64, 127, 128, 255))]) + body[i:]
        elif kind == 2:
            body = body[:i] + rng.choice((0, 1, 2, 255, 2 ** 31, 2 ** 32 - 1)).to_bytes(4, "little") + body[i + 4:]
        elif kind == 3:
            body = body[:i] + bytes([body[i] ^ 1 << rng.randrange(8)]) + body[i + 1:]
        elif kind == 4:
            long = rng.choice((2 ** 63 - 1, 2 ** 63, 2 ** 64 - 2, 2 ** 64 - 1, 2 ** 64, 2 ** 61, 2 ** 62 - 1, 4096, 4097, 128))
            body = body[:i] + itd.forge.varint(long) + body[i + 1:]
        elif kind == 5:
            j = rng.randrange(len(body))
            body = body[:i] + body[j:j + rng.randrange(12)] + body[i:]
        else:
            body = body[:i] + bytes([rng.choice((0, 1, 2, 3, 4, 6, 7, 8, 24, 25, 62, 63, 128, (body[i] + 1) % 256, (body[i] + 2) % 256, (body[i] - 2) % 256))]) + body[i + 1:]
    return line.replace(old, hashlib.sha256(body).hexdigest().encode()) + b"\n" + body


# ---------------------------------------------------------------- running

def cases(rng):
    if rng.random() < .8:
        yield model_case(rng)
    else:
        yield from certificate_cases(rng)


ONLY = {"": cases, "sheets": sheet_cases, "vmodels": vmodel_cases, "invalid_vmodels": invalid_vmodel_cases,
        "formats": lambda rng: [model_case(rng, "formats")], "certificates": certificate_cases}


class Run(attacks.Run):
    def attacks(self, rng):
        return ONLY[self.options.only](rng)

    def attack(self, name, case, cert, seed):
        """case: the model's bytes."""
        code, message = self.in_python(case, cert)
        found = attacks.condition_of(code, message)
        if code not in (0, 1, 4):
            self.fail("python checker: " + message, case, cert, seed, name)
        if self.options.checker:
            code2, message2 = self.native.check(case, cert)
            found2 = attacks.condition_of(code2, message2) if code2 in (0, 1) else "exit %d" % code2
            is_own = "too far away" in message2 or "over a limit of this checker" in message2   # star-box.md, section 8
            if found != found2 and not (is_own and code in (0, 1) and code2 == 1):
                self.fail("the checkers disagree: %r, %r" % (message[:200], message2[:200]), case, cert, seed, name)
        if name == "same" and found != "ACCEPT":
            self.fail("the same numbers in other forms: " + message[:200], case, cert, seed, name)
        self.table[name, found] += 1


def main(argv):
    options, start = attacks.parse(argv), time.monotonic()
    options.honest = 0
    table, _, _, failures = attacks.run_all(options, Run)
    attacks.print_table(table, {}, patch_attacks.CONDITIONS)
    return attacks.report(failures, differential.figures(table, failures, options, time.monotonic() - start, "patch_differential_"))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
