#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Do both checkers read every odd file and every damaged certificate alike?

Models: text and bytes of small valid files are damaged with the quirks of the reading rule; the
certificate is made for what the Python checker reads, so a different reading shows as a different
verdict.  Certificates: bodies and statements are damaged, hashes set right again.

    python3 tests/mutation/differential.py --count 50000 --seed 1 --checker PATH_TO_veritope-check
"""
import collections
import hashlib
import json
import multiprocessing
import pathlib
import random
import re
import struct
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import attacks                                            # noqa: E402
import forge                                              # noqa: E402
import reversed_liars                                     # noqa: E402
import solids                                             # noqa: E402

attacks.load_checker()
from veritope_checker.common import errors                # noqa: E402
from veritope_checker.mesh import mesh_reader as reader   # noqa: E402

NUMBERS = [b"1", b"+1", b"-1", b"1.", b".5", b"-.5", b".", b"+", b"-", b"1e", b"1e1", b"1E+1", b"1e-1", b"1e+", b"e1", b"-0", b"+0.0", b"0e5",
           b"nan", b"inf", b"NaN", b"-inf", b"Infinity", b"0x1", b"0x1p3", b"1e400", b"-1e400", b"1e-400", b"1e308", b"2e308",
           b"1.7976931348623158e308", b"1.7976931348623159e308", b"4.9e-324", b"2.4703282292062327e-324", b"2.4703282292062328e-324",
           b"2.2250738585072011e-308", b"9007199254740993", b"9007199254740992.9999999999999999999999", b"0." + b"0" * 400 + b"1e400", b"1" * 330,
           b"0" * 400 + b"1", b"1,5", b"1_0", b"1d0", b"--1", b"1.2.3", b"1e1.5", b"1\x00", b"\xb9", b"1e99999999999999999999", b"1e-99999999999999999999",
           b"0e99999999999999999999", b"0.1", b"0.30000000000000004", b"123456789012345678901234567890", b"1.5e-300", b"1e23", b"8.5e22"]
INTEGERS = [b"0", b"1", b"2", b"3", b"4", b"5", b"-1", b"-2", b"-3", b"+2", b"+0", b"-0", b"007", b"00000000000000000000003", b"3.0", b"3e0", b"0x3", b"",
            b"2147483647", b"2147483648", b"4294967295", b"4294967296", b"4294967297", b"-2147483649", b"18446744073709551616", b"18446744073709551619",
            b"-18446744073709551615", b"99999999999999999999999999", b"1000000000", b"256", b"255", b"128", b"3x", b"x", b"3/", b"/3", b"3//", b"3/1/1", b"3_0"]
LINES = {"stl": [b"solid", b"endsolid", b"solid a b", b"endsolid facet", b"facet normal 0 0 1", b"outer loop", b"vertex 0 0 0", b"endloop", b"endfacet", b"SOLID", b"color 1 2 3",
                 b"facet", b"outer", b"loop", b"# x", b"facet outer loop vertex 0 0 0 vertex 9 0 0 vertex 0 9 0 endloop endfacet", b"EndFacet", b"solid facet"],
         "obj": [b"v 0 0 0", b"v 1 2 3 4 5 x", b"v 1 2", b"f 1 2 3", b"f 1 2", b"f -1 -2 -3", b"f 1/2/3 2//3 3", b"fo 1 2 3", b"f 1 2 3 # f", b"# \\", b"\\", b"v 1 \\", b"f \\",
                 b"vn 0 0 1", b"l 1 2", b"f 0 1 2", b"g x", b"V 0 0 0", b"F 1 2 3", b"f 3 2 1 4", b"vt nan", b"f 99 1 2", b"p \\", b"fo", b"f", b"v"],
         "ply": [b"comment x", b"obj_info x", b"element vertex 3", b"element face 1", b"element tristrips 1", b"element other 2", b"element other 0", b"element vertex 0",
                 b"property float x", b"property float w", b"property list uchar int vertex_indices", b"property list uchar int vertex_index", b"property list int8 uint32 q",
                 b"property double z", b"property uint8 red", b"end_header", b"format ascii 1.0", b"comment", b"property list float int q", b"", b" ", b"foo", b"element other 4000000000",
                 b"property list uchar float vertex_index", b"property list uint uint vertex_index", b"ply", b"comment end_header", b"element vertex_ 1"],
         "off": [b"OFF", b"COFF", b"#", b"# 3 4 5", b"3 0 1 2", b"4 0 1 2 3", b"0 0 0", b"0 0 0 9", b"2 0 1", b"3 0 1 2 1 2 3", b"BINARY", b"3 0 1 99", b"", b" \t", b"#x", b"off", b"nOFF", b"STCNOFF"]}
BYTES = [b"\0", b"\t", b"\x0b", b"\x0c", b"\r", b"\n", b"\r\n", b"\n\r", b" ", b"\\", b"\\\n", b"\\\r", b"\\\r\n", b"#", b"\x1c", b"\x1d", b"\x1e", b"\x1f", b"\x85", b"\xa0", b"\xef\xbb\xbf",
         b"\xff", b"/", b"-", b"+", b".", b"e", b"0", b"1", b"\"", b"{", b"\x7f", b"\x1a"]
STARTS = [b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff", b"\0\0\xfe\xff", b"\x1f\x8b", b"PK\x03\x04", b"PK\x05\x06", b"PK", b"BZh", b"BZ", b"\xfd7zXZ\0", b"\xfd7z", b"\x28\xb5\x2f\xfd",
          b"version https://git-lfs", b"\xef\xbb\xbfversion https://git-lfs", b"\n", b" ", b"\0", b"\xef\xbb", b"\xef\xbb\xbf\xef\xbb\xbf", b"#", b"solid ", b"x", b"\x1f\x8c", b"\xef\xbb\xbf\x1f\x8b",
          b"\\\n\xef\xbb\xbf", b"\\\r\n\xef\xbb\xbf#", b"\xef\\\n\xbb\xbf", b"\\\r", b"#\\\n", b"#\n\xef\xbb\xbf"]
TOKEN = re.compile(rb"[^ \t\r\n\x0b\x0c]+")


def damage_token(data, fmt, rng):
    found = list(TOKEN.finditer(data))
    if not found:
        return data
    m = rng.choice(found if rng.random() < .7 else found[:40])
    word = rng.choice(rng.choice((NUMBERS, INTEGERS)))
    kind = rng.randrange(7)
    if kind == 0:
        return data[:m.start()] + data[m.end():]
    if kind == 1:
        return data[:m.start()] + word + b" " + data[m.start():]
    if kind == 2:
        return data[:m.start()] + m.group().swapcase() + data[m.end():]
    if kind == 3:
        other = rng.choice(found)
        return data[:m.start()] + other.group() + data[m.end():]
    return data[:m.start()] + word + data[m.end():]


def damage_line(data, fmt, rng):
    lines = data.split(b"\n")
    i = rng.randrange(len(lines))
    if rng.random() < .5:
        i = min(i, rng.randrange(12))
    kind = rng.randrange(6)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines.insert(i, lines[rng.randrange(len(lines))])
    elif kind == 2:
        j = rng.randrange(len(lines))
        lines[i], lines[j] = lines[j], lines[i]
    else:
        lines.insert(i, rng.choice(LINES[fmt]))
    return b"\n".join(lines)


def damage_bytes(data, fmt, rng):
    i = rng.randrange(len(data) + 1)
    if rng.random() < .4:
        i = min(i, rng.randrange(200))
    kind = rng.randrange(6)
    if kind == 0:
        return data[:i]
    if kind == 1:
        return data[:i] + data[i + rng.choice((1, 1, 2, 4, 12, 50)):]
    if kind == 2:
        return data[:i] + bytes([rng.randrange(256)]) + data[i + 1:]
    if kind == 3:
        return data + rng.choice((b"\0", b"x", b"\n1", b" 1 2 3\n", bytes(50)))
    return data[:i] + rng.choice(BYTES) + data[i:]


def damage_ends(data, fmt, rng):
    end = rng.choice((b"\r", b"\r\n", b"\n\n", b"\n\r", b" \n ", b"\n\t\x0b\x0c\n"))
    if rng.random() < .5:
        return data.replace(b"\n", end)
    at = data.find(b"\n", rng.randrange(len(data) + 1))
    return data[:at] + end + data[at + 1:] if at >= 0 else data


def damage_start(data, fmt, rng):
    return rng.choice(STARTS) + data


def damage_joints(data, fmt, rng):
    """Joints (of OBJ) between some tokens, or in them."""
    spots = sorted(rng.choice((m.start(), m.end(), m.end() - 1)) for m in TOKEN.finditer(data) if rng.random() < .1)
    for i in reversed(spots):
        data = data[:i] + rng.choice((b"\\\n", b"\\\r\n", b"\\\r", b"/1\\\n", b" \\\n ", b"/\\\n")) + data[i:]
    return data


DAMAGES = (damage_token, damage_token, damage_token, damage_line, damage_line, damage_bytes, damage_bytes, damage_ends, damage_start,
           damage_joints)


def small_model(rng):
    points, tris = rng.choice((solids.tetrahedron, solids.box, solids.bipyramid))(rng)
    model = forge.Model(points, tris, rng.choice(forge.FORMATS), rng.random() < .5, rng.randrange(3))
    data = model.encode()
    if model.fmt == "ply" and rng.random() < .5:
        data = odd_ply(model, rng)
    if model.fmt == "off" and rng.random() < .2:
        data = data.replace(b"\n", b" # c\n", rng.randrange(4))
    return model, data


def odd_ply(m, rng):
    """A PLY file with other types, orders of elements, strips and properties to read over."""
    ascii_, e = rng.random() < .4, rng.choice("<>")
    kind, name = rng.choice((("b", "char"), ("h", "int16"), ("i", "int"), ("f", "float32"), ("d", "double"), ("I", "uint32")))
    if min(c for p in m.points for c in p) < 0 and kind == "I" or max(abs(c) for p in m.points for c in p) > 127 and kind == "b":
        kind, name = "d", "float64"
    count, index = rng.choice((("B", "uchar"), ("b", "int8"), ("H", "ushort"), ("i", "int32"))), rng.choice((("B", "uint8"), ("h", "short"), ("i", "int"), ("I", "uint")))
    strips = rng.random() < .4
    extra = rng.random() < .5

    def pack(fmt, *values):
        if ascii_:
            return b" ".join(repr(v).encode() for v in values) + b"\n"
        return struct.pack(e + fmt, *values)

    vertex = [b"element vertex %d" % len(m.points)] + [b"property %s %c" % (name.encode(), c) for c in b"xyz"]
    vertex += [b"property list uchar short junk", b"property uchar red"] if extra else []
    vbody = b"".join(pack("3" + kind, *(p if kind in "fd" else map(int, p))) + (pack("B2hB", 2, 7, -7, 9) if extra else b"") for p in m.points)
    rows = [list(t) for t in m.tris]
    if strips and index[0] in "hi":
        rows = [[v for t in m.tris for v in t + (-1,)][:-1]] if count[0] != "b" or len(m.tris) < 30 else rows
    face = [b"element %s %d" % (b"tristrips" if strips else b"face", len(rows)), b"property list %s %s %s" % (
        count[1].encode(), index[1].encode(), rng.choice((b"vertex_indices", b"vertex_index")))]
    fbody = b"".join(pack("%s%d%s" % (count[0], len(r), index[0]), len(r), *r) for r in rows)
    parts = [(vertex, vbody), (face, fbody)]
    if extra:
        parts.append(([b"element other 2", b"property float q"], pack("2f", 1.5, 2.5)))
    rng.shuffle(parts)
    fmt = b"ascii" if ascii_ else b"binary_little_endian" if e == "<" else b"binary_big_endian"
    head = [b"ply", b"format " + fmt + b" 1.0"] + [line for p in parts for line in p[0]] + [b"end_header", b""]
    return b"\n".join(head) + b"".join(p[1] for p in parts)


def certify(data, model, rng):
    """A certificate for what the Python checker reads in the damaged bytes."""
    try:
        mesh = forge.Mesh(*reader.read_model(data, model.fmt, model.as_indexed))
    except errors.Refused:
        mesh = forge.mesh_of(model)
    truth = forge.Truth(mesh, pairs=False)
    true = forge.true_witnesses(truth, rng) if truth.broken else {}
    if true and rng.random() < .7:
        return forge.invalid_certificate(data, model, mesh, [true[r] for r in sorted(true)])
    return forge.Plan(mesh, rng, .5).certificate(data, model)


def damaged_model(rng):
    model, data = small_model(rng)
    for _ in range(rng.choice((0, 1, 1, 1, 2, 3))):
        data = rng.choice(DAMAGES)(data, model.fmt, rng)
    return model.fmt, data, certify(data, model, rng)


def damaged_certificate(rng):
    if rng.random() < .25:
        yield from damaged_reversal(rng)
        return
    case = attacks.valid_case(rng) if rng.random() < .5 else attacks.false_case(rng)[0]
    true = forge.true_witnesses(case.truth, rng)
    if true and rng.random() < .8:
        cert = case.invalid([true[r] for r in sorted(true)])
    else:
        plan = forge.Plan(case.mesh, rng, rng.random())
        plan.detours = rng.choice((0, .5))
        if rng.random() < .5:
            plan.cut = lambda a, b, i: forge.separator(case.mesh, *attacks.sides(case, a, b), rng) if rng.random() < .4 else None
        cert = case.certificate(plan)
    for _ in range(12):
        yield "certificate", case.bytes, damage_certificate(cert, rng), case.broken


def damaged_reversal(rng):
    """A certificate that reverses triangles, honest or not; nothing is known about what a damaged one claims."""
    _, case, cert = next(iter((reversed_liars.honest if rng.random() < .6 else reversed_liars.reversed_attacks)(rng)))
    for _ in range(12):
        yield "reversed", case.bytes, damage_certificate(cert, rng), None


def is_false(cert, broken):
    """Does the statement of a certificate claim what is not so?  broken: the rules that the mesh breaks."""
    statement = json.loads(cert.partition(b"\n")[0])
    if statement["claim"] == "mesh-valid-1":
        return bool(broken)
    claimed = set(statement["rules"].split())
    return not broken or bool((claimed - {"M8", "M9"}) - broken)


def damage_certificate(cert, rng):
    line, _, body = cert.partition(b"\n")
    if rng.random() < .3:
        line = damage_token(line.replace(b",", b"\t"), "off", rng).replace(b"\t", b",") if rng.random() < .3 else damage_statement(line, rng)
        return line + b"\n" + body
    old = hashlib.sha256(body).hexdigest().encode()
    for _ in range(rng.choice((1, 1, 2))):
        i = rng.randrange(len(body)) if rng.random() < .7 else max(len(body) - 1 - rng.randrange(40), 0)
        kind = rng.randrange(6)
        if kind == 0:
            body = body[:i] + body[i + rng.choice((1, 4)):] or b"V"
        elif kind == 1:
            body = body[:i] + bytes([rng.choice((0, 1, 14, 64, 127, 128, 255))]) + body[i:]
        elif kind == 2:
            body = body[:i] + struct.pack("<I", rng.choice((0, 1, 2, 2 ** 31, 2 ** 32 - 1))) + body[i + 4:]
        elif kind == 3:
            body = body[:i] + bytes([body[i] ^ 1 << rng.randrange(8)]) + body[i + 1:]
        else:
            body = body[:i] + bytes([rng.choice((0, 1, 5, 6, 14, 15, 16, 17, 32, 48, 64, 128, rng.randrange(256)))]) + body[i + 1:]
    return line.replace(old, hashlib.sha256(body).hexdigest().encode()) + b"\n" + body


def damage_statement(line, rng):
    kind = rng.randrange(7)
    members = line[1:-1].split(b',"')
    i = rng.randrange(len(members))
    if kind == 0:
        rng.shuffle(members)
        members = [m.lstrip(b'"') for m in members]
        return b'{"' + b',"'.join(members) + b"}"
    if kind == 1:
        del members[i]
        return b"{" + b',"'.join(members) + b"}"
    if kind == 2:
        members.insert(rng.randrange(1, len(members) + 1), members[i].lstrip(b'"'))
        return b"{" + b',"'.join(members) + b"}"
    if kind == 3:
        key, _, value = members[i].partition(b":")
        value = rng.choice((b"0", b"1", b"-1", b"01", b"1.0", b"true", b"false", b"null", b'""', b'"1/1"', b'"2/2"', b'"0/1"', b'"1/0"', b'"M1 M2"', b'"M9 M1"', b'"M3"', b'"stl"', b'"off"', b'"obj"',
                            b'"ply"', b"18446744073709551615", b"18446744073709551616", b"[]", b"{}", b'"' + b"x" * 201 + b'"', b'"mesh-valid-1"', b'"mesh-invalid-1"', b'"5"', b'"7/3"', b'"-1/6"',
                            b"12", b"8", b"4", b"00", b'"M1"', b'"M7 M7"', b'"1/6 "', b'"a\x01"', b'"a\x7f"', b'"a\xc3\xa9"', b'"a\\u0041"'))
        members[i] = key + b":" + value
        return b"{" + b',"'.join(members) + b"}"
    i = rng.randrange(len(line))
    if kind == 4:
        return line[:i] + rng.choice((b" ", b"\t", b"\\", b'"', b",", b"}", b"{", b"\r", b"\x7f", b"\xe9", b"0")) + line[i:]
    if kind == 5:
        return line[:i] + line[i + 1:]
    return rng.choice((line + b" ", b" " + line, b"", line * 2, b"[" + line + b"]", b"{" + b" " * 70000 + line[1:], line + b"\r", b"\xef\xbb\xbf" + line))


def worker(options, first, count, queue):
    run, done, seed = attacks.Run(options), 0, first
    table = collections.Counter()
    try:
        while done < count and len(run.failures) < 20:
            seed += options.jobs
            rng = random.Random(seed)
            if rng.random() < .96:
                cases = [damaged_model(rng) + (None,)]
            else:
                cases = damaged_certificate(rng)
            for name, data, cert, broken in cases:
                found = compare(run, data, cert, seed, name)
                if found == "ACCEPT" and broken is not None and is_false(cert, broken):
                    run.fail("FALSE CLAIM ACCEPTED", data, cert, seed, name)
                table[name, found] += 1
                done += 1
    except Exception as e:
        import traceback
        run.failures.append("seed %d: %s: %s\n%s" % (seed, type(e).__name__, e, traceback.format_exc()))
    run.native.close()
    queue.put((table, run.failures))


def compare(run, data, cert, seed, name):
    code, message = run.in_python(data, cert)
    found = attacks.condition_of(code, message)
    if code not in (0, 1, 4):
        run.fail("python checker: " + message, data, cert, seed, name)
    if run.options.checker:
        code2, message2 = run.native.check(data, cert)
        found2 = attacks.condition_of(code2, message2) if code2 in (0, 1) else "exit %d" % code2
        if found != found2:
            run.fail("the checkers disagree: %r, %r" % (message, message2), data, cert, seed, name)
    return found


def main(argv):
    options, start = attacks.parse(argv), time.monotonic()
    queue = multiprocessing.Queue()
    processes = [multiprocessing.Process(target=worker, args=(options, options.seed * 10 ** 8 * options.jobs + j, options.count // options.jobs, queue)) for j in range(options.jobs)]
    for p in processes:
        p.start()
    table, failures = collections.Counter(), []
    for _ in processes:
        t, f = queue.get()
        table, failures = table + t, failures + f
    for p in processes:
        p.join()
    attacks.print_table(table, {})
    return attacks.report(failures, figures(table, failures, options, time.monotonic() - start))


def figures(table, failures, options, seconds, prefix="differential_"):
    yield prefix + "cases", sum(table.values()), options.count
    yield prefix + "accepted_by_both", sum(n for (_, c), n in table.items() if c == "ACCEPT"), None
    yield prefix + "disagreements", len(failures), 0
    yield "seconds", round(seconds, 1), None


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
