# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims ball-1 and ball-invalid-1: docs/certificates/ball.md."""
import re
import struct
from fractions import Fraction

from ..common.errors import Refused, Reject

NUMBER = r"(-?[0-9]+(?:\.[0-9]+)?)"
FILE = re.compile(r"ball\ncentre {0} {0} {0}\nradius {0}\n".format(NUMBER).encode())

def check(claim, statement, body, model, skip):
    file = FILE.fullmatch(model)
    if not file:
        raise Refused("it is no file of a ball")
    tokens = [token.decode() for token in file.groups()]
    if any(len(re.sub("[-.]", "", token)) > 18 for token in tokens):
        raise Refused("a number has more than 18 digits")
    if len(body) != 4 + 4 * 9 or body[:4] != claim.magic:
        raise Reject("B1", "the body has not the length or the magic of the claim")
    for i, token in enumerate(tokens):
        digits, decimals = struct.unpack_from("<qB", body, 4 + 9 * i)
        if (digits, decimals) != shortest(token) and "P1" not in skip:
            raise Reject("P1", "not the model's number %d" % i)
    if statement["radius"] != text_of(*shortest(tokens[3])) and "P2" not in skip:
        raise Reject("P2", "not the model's radius")
    if (Fraction(tokens[3]) > 0) != (claim.name == "ball-1") and "P3" not in skip:
        raise Reject("P3", "the sign of the radius is not the claim's")

def shortest(token):
    """(digits, decimals): the value is digits / 10^decimals, with as few decimals as possible."""
    value, decimals = Fraction(token), 0
    while value.denominator > 1:
        value, decimals = 10 * value, decimals + 1
    return int(value), decimals

def text_of(digits, decimals):
    text = str(abs(digits)).rjust(decimals + 1, "0")
    text = text[:len(text) - decimals] + "." + text[len(text) - decimals:] if decimals else text
    return "-" + text if digits < 0 else text
