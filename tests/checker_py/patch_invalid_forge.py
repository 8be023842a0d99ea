# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A prover of patch-invalid certificates for small models: tests only. It looks for a crossing near given parameters with a few steps
of Newton's method in floats; Finding can write every lie."""
import hashlib
import json
from fractions import Fraction

import star_box_forge as forge
from veritope_checker.patches import patch_invalid_check as check


def interval(at):
    """(k, a, b) of two dyadic numbers."""
    lo, hi = [Fraction(x) for x in at]
    k = max(lo.denominator, hi.denominator).bit_length() - 1
    return k, int(lo * 2 ** k), int(hi * 2 ** k)


class Finding:
    """Everything that a body says. pair: two (patch, at, at); arcs: (patch, side, at); at: (lo, hi) or (k, a, b)."""
    claim, magic = "patch-invalid-1", b"VTPI"

    def __init__(self, entities, flags=None, kind=0):
        plan = forge.Plan(entities)
        self.entities, self.flags, self.breaks, self.kind = entities, flags or plan.flags, plan.breaks, kind
        self.pair, self.y, self.arcs, self.axis, self.t0, self.values, self.tail = [], [], [], 0, (1, 1), {}, b""

    def body(self):
        return self.head() + self.found() + self.tail

    def head(self):
        out = [self.magic, forge.u32(len(self.entities)), self.marks()]
        for axes in self.breaks:
            for axis in axes:
                out += [forge.u32(len(axis)), *map(forge.rational, axis)]
        return b"".join(out)

    def marks(self):
        """What stands for each entity."""
        return bytes(self.flags)

    def found(self):
        """What stands after the breaks."""
        out = [bytes([self.kind])]
        if self.kind == 0:
            for patch, *at in self.pair:
                out += [forge.varint(patch)] + [self.interval(a) for a in at]
            out += [forge.zigzag(c) for row in self.y for c in row]
        else:
            out.append(forge.u32(len(self.arcs)))
            out += [forge.varint(patch) + bytes([side]) + self.interval(at) for patch, side, at in self.arcs]
            out += [bytes([self.axis]), *map(forge.varint, self.t0)]
        return b"".join(out)

    def interval(self, at):
        return b"".join(map(forge.varint, interval(at) if len(at) == 2 else at))

    def stated(self):
        """The keys of the finding in the statement."""
        return {"finding": "side" if self.kind else "crossing", "same": 0, "opposite": 0}

    def certificate(self, model=None):
        model, body = forge.encode_model(self.entities) if model is None else model, self.body()
        counts = [(len(b[0]) - 1) * (len(b[1]) - 1) if b else 1 for b in self.breaks]
        statement = {"certificate": "veritope-certificate-1", "tool": "patch_invalid_forge", "claim": self.claim,
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": "vjson",
                     "body_sha256": hashlib.sha256(body).hexdigest(), "patches": sum(counts), "flipped": sum(self.flags)}
        statement.update(self.stated())
        statement.update(self.values)
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


def sides(entities, arcs, same, opposite, axis=0, t0=Fraction(1, 2), flags=None):
    finding = Finding(entities, flags, 1)
    k, a, _ = interval((t0, t0))
    finding.arcs, finding.axis, finding.t0, finding.values = arcs, axis, (k, a), {"same": same, "opposite": opposite}
    if flags:
        finding.values["flipped"] = sum(flags)
    return finding


# ---------------------------------------------------------------- crossings by Newton's method

class Parsed:
    """The checker's own patches, in floats."""

    def __init__(self, entities, flags=None):
        finding = Finding(entities, flags)
        parsed = forge.read.read_model(forge.encode_model(entities))
        self.patches = check.Patches(parsed, finding.flags, finding.breaks)

    def at(self, number, u, v):
        """The point and the two derivatives, by differences."""
        net = check.tensor_net(self.patches[number])
        scale = max(abs(c) for a in net for row in a for c in row)
        net = [[[forge.ratio(c, scale) for c in row] for row in a] for a in net]

        def point(u, v):
            x, y, z, w = [blend([blend(row, v) for row in a], u) for a in net]
            return [x / w, y / w, z / w]
        h = 1e-6
        return [point(u, v)] + [[(b - a) / (2 * h) for a, b in zip(point(u - du, v - dv), point(u + du, v + dv))]
                                for du, dv in ((h, 0), (0, h))]


def blend(c, t):
    while len(c) > 1:
        c = [(1 - t) * a + t * b for a, b in zip(c, c[1:])]
    return c[0]


def inverse(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [[x / det for x in row] for row in ((e * i - f * h, c * h - b * i, b * f - c * e), (f * g - d * i, a * i - c * g, c * d - a * f),
                                               (d * h - e * g, b * g - a * h, a * e - b * d))]


def newton(parsed, a, b, start, fixed):
    """The parameters and the inverse of the matrix of derivatives by the three that are not fixed."""
    x = [float(s) for s in start]
    for _ in range(12):
        p, pu, pv = parsed.at(a, *x[:2])
        q, qu, qv = parsed.at(b, *x[2:])
        columns = [pu, pv, [-c for c in qu], [-c for c in qv]]
        free = [i for i in range(4) if i != fixed]
        y = inverse(list(zip(*[columns[i] for i in free])))
        gap = [s - t for s, t in zip(p, q)]
        for i, row in zip(free, y):
            x[i] -= sum(r * g for r, g in zip(row, gap))
    return x, y


def crossing(entities, a, b, start, fixed=0, bits=5, flags=None):
    """A crossing of patches a and b near the parameters start, with boxes of half-width 2^-bits."""
    x, y = newton(Parsed(entities, flags), a, b, start, fixed)
    finding, unit = Finding(entities, flags), 1 << bits + 8
    at = []
    for i, c in enumerate(x):
        c = int(c * unit + 0.5)
        half = 0 if i == fixed else 1 << 8
        at.append((Fraction(max(c - half, 0), unit), Fraction(min(c + half, unit), unit)))
    finding.pair = [(a, *at[:2]), (b, *at[2:])]
    finding.y = [[round(c * 2 ** 20) for c in row] for row in y]
    return finding


# ---------------------------------------------------------------- sides

WHOLE, MOST = (0, 0, 1), (2, 1, 3)


def passing(entities, patch, side, flags=None, part=WHOLE):
    """This part, in space, of all outer sides that are the same curve as this one, which comes first, or the opposite one:
    (arcs, same, opposite)."""
    patches = Parsed(entities, flags).patches
    k, a, b = part
    mirrored, first, counts, arcs = (k, (1 << k) - b, (1 << k) - a), None, [0, 0], []
    for n, s in sorted(patches.outer(), key=lambda ns: ns != (patch, side)):
        curve = patches[n].side(s)
        if check.is_collapsed(curve):
            continue
        keys = [check.curve_key(c) for c in (curve, curve[::-1])][::-1 if patches[n].flag else 1]
        first = first or (keys[0], patches[n].flag)
        if first[0] in keys:
            is_opposite = keys.index(first[0])
            counts[is_opposite] += 1
            arcs.append((n, s, mirrored if is_opposite != (patches[n].flag != first[1]) else part))
    return arcs, *counts


def side(entities, patch, number, flags=None, t0=Fraction(1, 2), part=MOST):
    """The finding about a part of a side, on the last axis on which D3 holds."""
    arcs, same, opposite = passing(entities, patch, number, flags, part)
    finding = sides(entities, arcs, same, opposite, 0, t0, flags)
    of = Parsed(entities, flags).patches[patch]
    curve = check.part_of_curve(of.side(number), type("At", (), {"lo": part[1], "hi": part[2], "full": 1 << part[0]}))
    for axis in range(3):
        signs = check.slopes([p[axis] for p in curve], [p[3] for p in curve])
        if min(signs) > 0 or max(signs) < 0:
            finding.axis = axis
    return finding
