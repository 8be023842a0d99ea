# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The parts of the conditions of version 2, each with what disables it alone in the Python checker: does some attack need it?"""
import contextlib
import importlib
from unittest import mock

WHOLE = ("P1", "C1", "C2", "C3", "C4", "W1", "W2", "W3")


def module(name):
    return importlib.import_module("veritope_checker.patches." + name)


def replaced(file, name, value):
    return lambda: mock.patch.object(module(file), name, value)


def unheard(text):
    """Rejections with this text in their reasons do not happen."""
    def make():
        checker = module("star_box_check").Checker
        fail = checker.fail
        return mock.patch.object(checker, "fail", lambda self, c, why: None if text in why else fail(self, c, why))
    return make


def any_centres():
    """A node with S1 for some sheet's centres belongs to the sheet whose separators it satisfies."""
    sheets, found = module("star_box_2_sheets"), {}
    has_s1, sheet_of = sheets.has_s1, sheets.Signs.sheet_of

    def remember(signs, node):
        found["pairs"] = [sheet.c for sheet in signs.box.sheets]
        return sheet_of(signs, node)
    stack = contextlib.ExitStack()
    stack.enter_context(mock.patch.object(sheets, "has_s1", lambda node, c: any(has_s1(node, pair) for pair in found["pairs"])))
    stack.enter_context(mock.patch.object(sheets.Signs, "sheet_of", remember))
    return stack


class AnySign(int):
    """Equal to every sign of a sheet."""
    __hash__ = int.__hash__

    def __eq__(self, other):
        return True


def zero_counts():
    """Coefficients of separators that are zero have either sign."""
    sheets = module("star_box_2_sheets")
    sign_on = sheets.sign_on

    def moved(node, q, by):
        return sign_on(node, q._replace(terms=[(n * 2 ** 40 + by * (p == (0, 0, 0)), p) for n, p in q.terms]))

    def lenient(node, q):
        signs = {sign_on(node, q), moved(node, q, 1), moved(node, q, -1)} - {0}
        return AnySign() if len(signs) == 2 else max(signs, default=0, key=abs)
    return mock.patch.object(sheets, "sign_on", lenient)


ALWAYS, NEVER = (lambda *_: True), (lambda *_: False)
PARTS = {
    "B1": {"det A": replaced("star_box_2_read", "dot", lambda *_: 1),
           "centres inside": replaced("star_box_2_read", "in_frame", lambda *_: ()),
           "signs differ": replaced("star_box_2_read", "combinations", lambda *_: ())},
    "C1": {"hull": unheard("is not in its box"), "component": unheard("two components"), "named": unheard("no leaf names")},
    "C2": {"own centres": any_centres, "separators": replaced("star_box_2_sheets", "sign_on", lambda *_: AnySign()), "zero of q": zero_counts,
           "inner side": replaced("star_box_2_sheets", "is_inner_side", NEVER),
           "inner corner": replaced("star_box_2_sheets", "is_inner_corner", NEVER),
           "radial": replaced("star_box_2_sheets", "touches_radial_side", NEVER), "collapsed": replaced("star_box_2_sheets", "are_apart", ALWAYS)},
    "C4": {"meet": unheard("do not meet properly"), "convex": replaced("star_box_2_flat", "is_convex", ALWAYS),
           "plane": replaced("star_box_2_flat", "lies_in_plane", ALWAYS), "straight": replaced("star_box_2_flat", "has_straight_sides", ALWAYS),
           "unfolded": replaced("star_box_2_flat", "is_unfolded", ALWAYS)},
    "W1": {"one sheet": lambda: mock.patch.object(module("star_box_2_check").Checker2, "may_walk", ALWAYS),
           "one walk": unheard("walks for"), "earlier": unheard("without an earlier walk")},
}
NAMES = ["2 " + c for c in WHOLE] + ["2 %s %s" % (c, part) for c, parts in PARTS.items() for part in parts]

# Parts that no attack is expected to need, and why: the last column of the table says so.
UNCOVERED = {
    "2 B1 det A": "a box in a singular frame has no end, but is tested as every other; shown with a sound solid (star_box_2_body_test.py)",
    "2 C2": "its parts are needed; without all of it the first sheet has every node, and another crossing number",
    "2 C1 component": "a star box of one sheet that passes C2 and C3 has one disk, so leaves of one component only; in a mesh box nothing follows",
    "2 C2 inner corner": "shown with an open surface (star_box_2_zeros_test.py), as are the next two",
    "2 C2 radial": "", "2 C2 collapsed": "",
    "2 C4 convex": "a quadrilateral that is not convex folds at that corner, unless control points there are equal",
    "2 C4 straight": "shown with a sound solid (star_box_2_flat_test.py)",
}


def is_new(cert):
    """Is it a certificate of version 2 of the claims about star boxes?"""
    statement = cert.split(b"\n", 1)[0]
    return b'"star-box-2"' in statement or b'"star-box-turned-2"' in statement


def accepts_without(check, model, cert, name):
    """Is the certificate accepted if this part, or this condition, is disabled?"""
    condition, _, part = name.partition(" ")
    if not part:
        return check(model, cert, frozenset((condition,)))[0] == 0
    with PARTS[condition][part]():
        return check(model, cert, frozenset())[0] == 0


def needed(check, model, cert, found, alone, most):
    """Counts in `alone` the parts without which the certificate, rejected by `found`, is accepted."""
    for name in NAMES:
        if name.split()[1] == found and alone[name] < most:
            alone[name] += accepts_without(check, model, cert, name[2:])


def missing(alone):
    return [name for name in NAMES if not alone.get(name)]
