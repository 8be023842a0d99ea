# SPDX-License-Identifier: LGPL-3.0-or-later
"""Formula files: docs/how-to/generate-a-predicate.md has the language. Errors are refused with line, column and a
sentence."""
import random
import re

from .expression import Graph, leaves_of, polynomial_of, value_modulo
from .expression_parser import AXES, ExpressionParser

NAME = re.compile(r"[a-z][a-z0-9_]*\Z")
PRIME = 2**61 - 1
TAKEN = set("""alignas alignof and asm auto bool break case catch char class const constexpr continue default delete
do double else enum explicit export extern false float for friend goto if inline int long mutable namespace new
noexcept not operator or private protected public register return short signed sizeof static struct switch template
this throw true try typedef typename union unsigned using virtual void volatile while xor concept requires consteval
constinit co_await co_return co_yield char8_t char16_t char32_t decltype dynamic_cast const_cast goto nullptr
reinterpret_cast static_assert static_cast thread_local typeid wchar_t and_eq bitand bitor compl not_eq or_eq xor_eq
main errno int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t wide odd_parts cascade is_certain
sign_beyond abs det sign size larger tally magnitude multiple fits narrowed put scaled sqr dot cross norm2 std
veritope internal formulas""".split())


class FormulaError(Exception):
    """The text is PATH:LINE:COLUMN: what is wrong."""

    def __init__(self, path, line, column, message):
        super().__init__(f"{path}:{line}:{column}: {message}")


class Formula:
    """The content of a formula file.

    arguments: [(name, dimension)], 0 for a number; scale_of: {input: (scale, power)}; definitions: [(name, node)] in
    order, without the sign; sign: node; laws: [(kind, permutation of the arguments, factor)]; examples: [(numbers as
    text, sign)]; texts: {word: text}.
    """

    def __init__(self):
        self.texts, self.arguments, self.scale_of = {}, [], {}
        self.definitions, self.laws, self.examples = [], [], []
        self.sign, self.graph = None, Graph()

    @property
    def name(self):
        return self.texts["predicate"]

    @property
    def inputs(self):
        """Names of the numbers, in the order of the arguments: a.x, a.y, wa, ..."""
        return [name for argument, dimension in self.arguments for name in inputs_of(argument, dimension)]

    @property
    def leaves(self):
        """In the order of their definitions, then of their first use."""
        place = {id(node): i for i, (_, node) in reversed(list(enumerate(self.definitions)))}
        found = leaves_of(self.sign)
        return sorted(found, key=lambda node: place.get(id(node), len(place)))

    def scales(self):
        return sorted({scale for scale, _ in self.scale_of.values()})

    def is_homogeneous(self):
        """Whether scaling the inputs of a scale scales the polynomial."""
        for scale in self.scales():
            degrees = {sum(e * self.scale_of[name][1] for name, e in monomial if self.scale_of[name][0] == scale)
                       for monomial in polynomial_of(self.sign).terms}
            if len(degrees) > 1:
                return False
        return True


def inputs_of(argument, dimension):
    return [f"{argument}.{axis}" for axis in AXES[:dimension]] if dimension else [argument]


def read_formula(text, path):
    return _Reader(text, path).read()


class _Reader:
    TEXTS = ("predicate", "question", "claim", "zero", "source", "constant", "bound", "rounding")

    def __init__(self, text, path):
        self.path, self.lines = path, text.split("\n")
        self.formula, self.values = Formula(), {}
        self.line = self.column = 0
        self.order, self.bound_line = None, 0

    def fail(self, message, column=None, line=None):
        raise FormulaError(self.path, line or self.line, column or self.column or 1, message)

    def read(self):
        block = None
        for self.line, raw in enumerate(self.lines, 1):
            self.column = 1
            line = re.sub(r"(?:^|\s)#.*", "", raw).rstrip()
            if not line:
                continue
            if line[0] in " \t":
                self.continue_block(block, line)
            else:
                block = self.begin(line)
        return self.checked()

    def begin(self, line):
        word, rest = (line.split(None, 1) + [""])[:2]
        self.column = line.find(rest, len(word)) + 1 if rest else len(word) + 1
        if word in self.TEXTS:
            if word in self.formula.texts:
                self.fail(f"a second line {word!r}", 1)
            self.formula.texts[word] = rest
            self.bound_line = self.line if word == "bound" else self.bound_line
        elif word in ("points", "scalars"):
            self.declare(word, rest)
        elif word == "order":
            self.order = (self.line, self.column, rest.split())
        elif word == "law":
            self.formula.laws.append((self.line, self.column, rest))
        elif word == "example":
            self.example(rest)
        elif word != "evaluate":
            self.fail(f"{word!r} begins no line of a formula file: predicate, question, claim, zero, source, points, "
                      f"scalars, order, law, "
                      "example or evaluate expected", 1)
        if word == "predicate" and (not NAME.match(rest) or rest in TAKEN):
            self.fail(f"{rest!r} cannot be the name of a predicate: small letters, digits and _ expected, no word of "
                      f"C++")
        return word

    def continue_block(self, block, line):
        self.column = len(line) - len(line.lstrip()) + 1
        if block == "evaluate":
            self.define(line)
        elif block in self.TEXTS:
            self.formula.texts[block] += " " + line.strip()
        else:
            self.fail("an indented line continues a text or stands under evaluate")

    def declare(self, word, rest):
        match = re.fullmatch(r"((?:\w+\s+)*?\w+)(?:\s+in\s+(\d+))?(?:\s+scale\s+(\w+)(?:\^(\d+))?)?", rest)
        if not match:
            self.fail(f"expected: {word} NAME..." + (" in 2|3" if word == "points" else "") + " [scale NAME[^POWER]]")
        names, dimension, scale, power = match.groups()
        if (word == "points") != (dimension in ("2", "3")):
            self.fail("points are in 2 or in 3 dimensions" if word == "points" else "scalars have no dimension")
        if power and not 1 <= int(power) <= 4:
            self.fail("the power of a scale is 1 to 4")
        for name in names.split():
            self.new_name(name)
            self.formula.arguments.append((name, int(dimension or 0)))
            nodes = [self.formula.graph.make("input", name=i) for i in inputs_of(name, int(dimension or 0))]
            self.values[name] = nodes if dimension else nodes[0]
            for node in nodes:
                self.formula.scale_of[node.name] = (scale or "length", int(power or 1))

    def new_name(self, name, column=None):
        if not NAME.match(name) or name in TAKEN or name.endswith("_"):
            self.fail(f"{name!r} cannot be a name: small letters, digits and _ expected, no word of C++ or of this "
                      f"language", column)
        if name in self.values:
            self.fail(f"{name!r} has been defined before", column)

    def example(self, rest):
        numbers, _, sign = rest.partition("->")
        if sign.strip() not in ("-1", "0", "1"):
            self.fail("expected: example NUMBERS -> -1, 0 or 1")
        self.formula.examples.append((self.line, self.column, numbers.replace(",", " ").split(), int(sign)))

    def define(self, line):
        parser = ExpressionParser(line, self.formula.graph, self.values, self.fail)
        name, column = parser.begin()
        if name == "sign":
            if self.formula.sign is not None:
                self.fail("a second definition of sign", column)
        else:
            self.new_name(name, column)
        value = parser.whole()
        if name == "sign":
            if isinstance(value, list) or value.is_leaf or value.kind == "integer":
                self.fail("sign must be a number that is computed from more than one difference", parser.column)
            self.formula.sign = value
            return
        self.values[name] = value
        self.formula.definitions += [(name + axis, node)
                                     for axis, node in zip(AXES, value)] if isinstance(value, list) else [(name, value)]

    def checked(self):
        formula = self.formula
        self.line, self.column = len(self.lines), 1
        for word in ("predicate", "question", "claim"):
            if not formula.texts.get(word):
                self.fail(f"the line {word!r} is missing")
        if not formula.arguments:
            self.fail("no points and no scalars")
        if formula.sign is None:
            self.fail("evaluate does not define sign")
        self.reorder()
        self.check_dependence()
        if "constant" not in formula.texts and formula.texts.get("bound", "S") not in ("S", "largest"):
            self.fail("the bound is S, the sum of the absolute terms, or largest", 1, self.bound_line)
        self.check_names()
        for line, column, numbers, _ in formula.examples:
            if len(numbers) != len(formula.inputs):
                self.fail(f"{len(formula.inputs)} numbers expected, but there are {len(numbers)}", column, line)
        from .laws import read_laws
        formula.laws = read_laws(formula, self.fail)
        return formula

    def check_dependence(self):
        """Tests by values modulo a prime: a polynomial that is not constant would pass with a probability below
        2^-50."""
        formula, draw = self.formula, random.Random(1)
        values = {name: draw.randrange(PRIME) for name in formula.inputs}
        value = value_modulo(formula.sign, values, PRIME)
        if value == 0:
            self.fail("sign is zero whatever the inputs are")
        for argument, dimension in formula.arguments:
            changed = {name: draw.randrange(PRIME) for name in inputs_of(argument, dimension)}
            if value_modulo(formula.sign, {**values, **changed}, PRIME) == value:
                self.fail(f"the sign does not depend on {argument}")

    def reorder(self):
        if self.order is None:
            return
        line, column, names = self.order
        declared = dict(self.formula.arguments)
        if sorted(names) != sorted(declared):
            self.fail("order must name every point and scalar once", column, line)
        self.formula.arguments = [(name, declared[name]) for name in names]

    def check_names(self):
        """Vectors become ux, uy, uz in C++."""
        names = [name for name, _ in self.formula.definitions] + [name for name, _ in self.formula.arguments]
        for name in names:
            if names.count(name) > 1:
                self.fail(f"{name!r} is the name of a number and, with an axis, of a part of a vector")
