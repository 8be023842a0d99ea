# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The answers file of the claim points-1: docs/certificates/points.md, section 2, and conditions A1 and A2."""
import hashlib
import math
import re

from ..common.errors import Reject

DECIMAL = re.compile(rb"([+-]?)(?:([0-9]+)(?:\.([0-9]*))?|\.([0-9]+))(?:[eE]([+-]?[0-9]+))?")
HEXADECIMAL = re.compile(rb"([+-]?)0[xX](?:([0-9a-fA-F]+)(?:\.([0-9a-fA-F]*))?|\.([0-9a-fA-F]+))[pP]([+-]?[0-9]+)")
FRACTION = re.compile(rb"([+-]?[0-9]+)/([0-9]+)")
NUMBER = re.compile(rb"0|[1-9][0-9]{0,9}")
INTEGER = re.compile(rb"0|-?[1-9][0-9]{0,9}")
LONGEST_COORDINATE = GREATEST_EXPONENT = 4096
INSIDE_OR_NOT = {b"in": b"1", b"out": b"0"}                # word -> f, if winding is false

class NotAllowed(Exception):
    """A token that section 2 does not allow."""

def read_answers(answers, statement, skip):
    """The words of the lines, after A1 and A2.  Nothing else of a line is kept."""
    if "A1" not in skip and (len(answers) != statement["answers_bytes"] or
                             hashlib.sha256(answers).hexdigest() != statement["answers_sha256"]):
        raise Reject("A1", "the certificate is about another answers file")
    if statement["subject_format"] == "chain" and statement["winding"] and "A2" not in skip:
        raise Reject("A2", "an expression has no winding numbers")
    count_equals("points", answers.count(b"\n"), statement, skip)               # before anything is kept
    words = [word for _, word, _ in lines_of(answers, statement)]
    for word in ("on", "undecided"):
        count_equals(word, words.count(word), statement, skip)
    return words

def count_equals(key, counted, statement, skip):
    if statement[key] != counted and "A2" not in skip:
        raise Reject("A2", "%s: stated %d, counted %d" % (key, statement[key], counted))

def lines_of(answers, statement):
    """(three coordinates as pairs of numerator and denominator, word, f or None) of each line.  Another line is A2."""
    start, number = 0, 0
    while start < len(answers):
        end, number = answers.find(b"\n", start), number + 1
        try:
            if end < 0:
                raise NotAllowed("no line feed at its end")
            fields = answers[start:end].split(b" ", 6)
            if len(fields) != 6:
                raise NotAllowed("not six fields with one blank between them")
            point = [coordinate(token, statement["decimals"] == "nearest") for token in fields[:3]]
            if statement["subject_format"] == "chain" and fields[5] != b"-":
                raise NotAllowed("an expression has no shells")
            yield (point, *answer(fields[3:], statement["winding"]))
        except NotAllowed as e:
            raise Reject("A2", "line %d: %s" % (number, e)) from None
        start = end + 1

def answer(fields, winding):
    """(word, f): the word is "off" for a point off the triangles, of which alone f is a number."""
    word, f, shell = fields
    if word == b"undecided":
        if f != b"-" or shell != b"-":
            raise NotAllowed("an undecided point has f or a shell")
        return "undecided", None
    if shell != b"-" and not NUMBER.fullmatch(shell):
        raise NotAllowed("not a shell: %r" % shell[:40])
    if word == b"on":
        if f != b"-":
            raise NotAllowed("a point on a triangle has f")
        return "on", None
    if winding:
        if word != b"-" or not INTEGER.fullmatch(f):
            raise NotAllowed("not a word and f: %r %r" % (word[:40], f[:40]))
    elif INSIDE_OR_NOT.get(word) != f:
        raise NotAllowed("not a word and its f: %r %r" % (word[:40], f[:40]))
    return "off", int(f)

def coordinate(token, nearest):
    """The rational number as (numerator, denominator), not always in lowest terms."""
    if len(token) > LONGEST_COORDINATE:
        raise NotAllowed("a coordinate of %d bytes" % len(token))
    m = DECIMAL.fullmatch(token)
    if m and nearest:
        value = float(token)                                # rounds correctly once the grammar is checked
        if math.isinf(value):
            raise NotAllowed("a coordinate rounds to infinity: %r" % token[:40])
        return value.as_integer_ratio()
    if m:
        return power_times(m, 10, 10)
    m = HEXADECIMAL.fullmatch(token)
    if m:
        return power_times(m, 16, 2)
    m = FRACTION.fullmatch(token)
    if not m:
        raise NotAllowed("not a coordinate: %r" % token[:40])
    if int(m[2]) == 0:
        raise NotAllowed("a denominator is 0")
    return int(m[1]), int(m[2])

def power_times(m, radix, base):
    """The number whose digits have this radix and whose exponent this base."""
    sign, whole, after, only, exponent = m.groups()
    digits, places = (b"", only) if only is not None else (whole, after or b"")
    power = exponent_of(exponent or b"0")
    value = int(sign + digits + places, radix)
    scale = radix ** len(places)
    return (value * base ** power, scale) if power >= 0 else (value, scale * base ** -power)

def exponent_of(text):
    digits = text.lstrip(b"+-").lstrip(b"0")
    if len(digits) > 4 or int(digits or b"0") > GREATEST_EXPONENT:
        raise NotAllowed("an exponent is too large")
    return -int(digits or b"0") if text[:1] == b"-" else int(digits or b"0")
