# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The first line of a certificate (docs/certificates/mesh.md, section 1): conditions S1 to S4."""
import hashlib
import re

from .errors import Reject

READING_RULE = (
    "Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, unless"
    " as_indexed is true (STL: always one); vertex ids count first occurrences in file order;"
    " polygons are fans from their first vertex; decimals round to the nearest binary64, ties to"
    " even; binary floats are widened exactly; normals, colours, texture, lines, groups and"
    " attribute bytes are ignored; unreferenced vertices are ignored; all solid blocks of an ASCII"
    " STL are one model; the file is refused unless it yields at least one triangle, finite"
    " coordinates and indices in range.")

MEMBER = re.compile(r'"([^"\\]*)":(?:"([^"\\]*)"|(0|[1-9][0-9]*)|(true|false))')
HEX64 = r"[0-9a-f]{64}"
COMMON_KEYS = {"certificate": "veritope-certificate-1", "tool": r".{0,200}",
               "subject_sha256": HEX64, "subject_bytes": int, "body_sha256": HEX64}

def read_statement(claims, cert, model):
    """(statement, body), after S1 to S4.  claims: the rows by name."""
    statement, body = parse_statement(claims, cert)
    if statement.get("reading_rule", READING_RULE) != READING_RULE:
        raise Reject("S2", "another reading rule")
    if (statement["subject_bytes"] != len(model) or
            statement["subject_sha256"] != hashlib.sha256(model).hexdigest()):
        raise Reject("S3", "the certificate is about another file")
    if statement["body_sha256"] != hashlib.sha256(body).hexdigest():
        raise Reject("S4", "the body is not the one that the statement names")
    return statement, body

def parse_statement(claims, cert):
    """(statement, body), after S1."""
    end = cert.find(b"\n")
    if not 0 <= end <= 65536:
        raise Reject("S1", "no line feed in the first 64 KiB")
    if any(not 32 <= b <= 126 for b in cert[:end]):
        raise Reject("S1", "a byte that is not printable ASCII")
    line, statement, pos = cert[:end].decode("ascii"), {}, 1
    if not re.fullmatch(r"\{.*\}", line):
        raise Reject("S1", "not a JSON object")
    while True:
        m = MEMBER.match(line, pos)
        if not m or m.group(1) in statement or m.end() >= len(line):
            raise Reject("S1", "not a flat JSON object, or a key twice, at byte %d" % pos)
        key, text, number, boolean = m.groups()
        if number and (len(number) > 20 or int(number) >= 1 << 64):
            raise Reject("S1", "%s is too large" % key)
        statement[key] = text if text is not None else int(number) if number else boolean == "true"
        pos = m.end() + 1
        if line[m.end()] != ",":
            break
    if line[m.end()] != "}" or pos != len(line):
        raise Reject("S1", "text after a member at byte %d" % m.end())
    check_keys(claims, statement)
    return statement, cert[end + 1:]

def keys_of(claim):
    """Every key of the claim's statement with the kind of its value: a pattern of a text, int or bool."""
    return {**COMMON_KEYS, "claim": re.escape(claim.name), "subject_format": "|".join(claim.formats), **claim.keys}

def check_keys(claims, statement):
    if statement.get("claim") not in claims:
        raise Reject("S1", "an unknown claim, or none")
    keys = keys_of(claims[statement["claim"]])
    if set(keys) != set(statement):
        raise Reject("S1", "keys missing or unknown: %s" % sorted(set(keys) ^ set(statement)))
    for key, rule in keys.items():
        value = statement[key]
        good = (type(value) is rule if isinstance(rule, type) else
                type(value) is str and re.fullmatch(rule, value))
        if not good:
            raise Reject("S1", "value of %s" % key)
    rules = statement.get("rules", "").split(" ")
    if rules != sorted(set(rules)):
        raise Reject("S1", "rules are not ascending")
