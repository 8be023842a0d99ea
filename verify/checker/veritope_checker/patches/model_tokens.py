# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Tokens and numbers, as several reading rules define them (docs/certificates/reading-rule-g2.md, section 1)."""
import re

from ..common.errors import Refused
from .star_box_read import MAX_DIGITS, axis_size, number

TOKEN = re.compile(rb"[^ \t\v\f\n\r]+")
DECIMAL = re.compile(r"[-+]?([0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
INTEGER = re.compile(rb"[-+]?[0-9]+")
MAX_INTEGER = 1 << 62
MARK = b"\xef\xbb\xbf"

def decimal(token, at):
    """The rational that a token at this byte denotes."""
    word = token.decode("latin-1")
    m = DECIMAL.fullmatch(word)
    if not m or len(m[1].replace(".", "")) > MAX_DIGITS:
        raise Refused("byte %d: %r is no decimal, or has too many digits" % (at, word[:40]))
    return number(word)

class Tokens:
    """A cursor over the tokens of a file. size: the number of its bytes, which bounds every count."""

    def __init__(self, data, size=None):
        self.data, self.pos = data, len(MARK) if data[:3] == MARK else 0
        self.at, self.size = self.pos, len(data) if size is None else size

    def peek(self):
        """The next token; empty at the end."""
        m = TOKEN.search(self.data, self.pos)
        return m[0] if m else b""

    def word(self):
        m = TOKEN.search(self.data, self.pos)
        if not m:
            raise Refused("the file ends too early")
        self.at, self.pos = m.span()
        return m[0]

    def refuse(self, wanted):
        """Refuses the token that was read last."""
        token = self.data[self.at:self.pos][:40].decode("latin-1")
        raise Refused("byte %d: %r where %s belongs" % (self.at, token, wanted))

    def one_of(self, *words):
        word = self.word()
        if word not in words:
            self.refuse(" or ".join(w.decode() for w in words))
        return word

    def integer(self, least=-MAX_INTEGER, most=MAX_INTEGER):
        word = self.word()
        digits = word.lstrip(b"+-").lstrip(b"0") or b"0"
        if not INTEGER.fullmatch(word) or len(digits) > 19:
            self.refuse("an integer of at most 2^62")
        value = -int(digits) if word[:1] == b"-" else int(digits)
        if not least <= value <= most:
            self.refuse("an integer from %d to %d" % (least, most))
        return value

    def count(self):
        return self.integer(0, self.size)

    def decimals(self, n):
        """The next n decimals. No more are announced than the rest of the file can hold."""
        if 2 * n > len(self.data) - self.pos + 1:
            raise Refused("byte %d: %d numbers are announced, more than the file holds" % (self.pos, n))
        return [decimal(self.word(), self.at) for _ in range(n)]

    def knots(self, degree, num_points):
        start, knots = self.pos, self.decimals(num_points + degree + 1)
        try:
            axis_size(degree, knots)
        except Refused as e:
            raise Refused("byte %d: %s" % (start, e))
        return knots

    def end(self):
        if self.peek():
            self.word()
            self.refuse("the end of the file")

    def weighted(self, num_points, dimension):
        """Homogeneous points as they stand in the file: so many coordinates, then the weight."""
        numbers, points = self.decimals(num_points * (dimension + 1)), []
        for i in range(num_points):
            points.append(numbers[i * (dimension + 1):(i + 1) * (dimension + 1)])
            if points[-1][-1] <= 0:
                raise Refused("byte %d: the weight of control point %d before it is not positive" % (self.pos, i))
        return points
