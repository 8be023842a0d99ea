# SPDX-License-Identifier: LGPL-3.0-or-later
"""What a Gappa script claims, and what the Coq term that Gappa printed for it proves: both as the same kind of value, so that == compares them.

A statement is a pair of sorted lists, hypotheses and goals. Each atom is ("in", e, lo, hi), ("rel", a, b, lo, hi) for a = b (1 + r) with
r in [lo, hi], or ("le", e, c). Ends of ranges are Fractions. Expressions are numbers of nodes in a table that both sides share: equal
expressions have equal numbers. Numbers are read exactly; no double is ever made of them. The grammar is what the scripts and the terms of
this tree use: anything else is an error, never skipped.
"""
import re
from fractions import Fraction


class TermError(Exception):
    """The text is not as the grammar says, or the term assumes something."""


class Nodes:
    """Expressions, each stored once."""

    def __init__(self):
        self.numbers, self.nodes = {}, []

    def __call__(self, *node):
        if node not in self.numbers:
            self.numbers[node] = len(self.nodes)
            self.nodes.append(node)
        return self.numbers[node]

    def value(self, number):
        """The Fraction of a number's node."""
        kind, *rest = self.nodes[number]
        if kind != "number":
            raise TermError(f"a number is expected, not {kind}")
        return rest[0]


NUMBER = re.compile(r"(-?)(?:0x([0-9a-f]+)(?:\.([0-9a-f]*))?p([+-]?\d+)|(\d+)b([+-]?\d+)|(\d+))")


def read_number(text):
    """The rational that 0x1.8p-52 (C++, Gappa), 1b-53 (Gappa: 1 times 2^-53) or 36 stands for."""
    match = NUMBER.fullmatch(text)
    if not match:
        raise TermError(f"{text!r} is no number")
    sign, whole, digits, hex_power, binary, power, plain = match.groups()
    if whole is not None:
        digits = digits or ""
        value = Fraction(int(whole + digits, 16), 16 ** len(digits)) * Fraction(2) ** int(hex_power)
    elif binary is not None:
        value = int(binary) * Fraction(2) ** int(power)
    else:
        value = Fraction(int(plain))
    return -value if sign else value


def round_down(value):
    """The largest number of 53 bits that is not above a positive rational."""
    power = value.numerator.bit_length() - value.denominator.bit_length() - 54
    scaled = value / Fraction(2) ** power
    mantissa = scaled.numerator // scaled.denominator
    extra = mantissa.bit_length() - 53
    return Fraction(mantissa >> extra << extra) * Fraction(2) ** power


# Gappa's scripts.

TOKEN = re.compile(r"\s*(0x[0-9a-f.]+p[+-]?\d+|\d+b[+-]?\d+|\d+|[A-Za-z]\w*|/\\|->|<=|-/|[-+*|()\[\],])")
ROUNDINGS = {"ne": "rndNE", "up": "rndUP", "dn": "rndDN", "zr": "rndZR"}


class Script:
    """The definitions and the statement of a script."""

    def __init__(self, text, nodes):
        self.nodes, self.roundings, self.names, self.operator_rounding = nodes, {}, {}, None
        text = re.sub(r"#.*", "", text)
        head, brace, tail = text.partition("{")
        if not brace or not tail.rstrip().endswith("}"):
            raise TermError("a script ends with { statement }")
        for line in filter(None, (line.strip() for line in head.split(";"))):
            self.define(line)
        self.tokens = self.split(tail.rstrip()[:-1])
        hypotheses = self.atoms()
        self.expect("->")
        goals = self.atoms()
        if self.tokens:
            raise TermError(f"{self.tokens[0]!r} follows the statement")
        self.statement = sorted(hypotheses), sorted(goals)

    @staticmethod
    def split(text):
        tokens, at = [], 0
        text = text.rstrip()
        while at < len(text):
            match = TOKEN.match(text, at)
            if not match:
                raise TermError(f"no token: {text[at:at + 20]!r}")
            tokens.append(match[1])
            at = match.end()
        return tokens

    def define(self, line):
        rounding = re.fullmatch(r"@(\w+) = float<ieee_64, (\w+)>", line)
        value = re.fullmatch(r"(\w+)(?: (\w+))?\s*= (.*)", line, re.DOTALL)
        if rounding and rounding[2] in ROUNDINGS:
            self.roundings[rounding[1]] = ROUNDINGS[rounding[2]]
        elif value and value[1] not in self.names and (value[2] is None or value[2] in self.roundings):
            self.tokens, self.operator_rounding = self.split(value[3]), self.roundings.get(value[2])
            self.names[value[1]] = self.sum()
            self.operator_rounding = None
            if self.tokens:
                raise TermError(f"{self.tokens[0]!r} in {line!r}")
        else:
            raise TermError(f"{line!r} is no definition")

    def peek(self):
        return self.tokens[0] if self.tokens else None

    def expect(self, *allowed):
        if self.peek() not in allowed:
            raise TermError(f"{' or '.join(allowed)} is expected before {' '.join(self.tokens[:6])!r}")
        return self.tokens.pop(0)

    def operation(self, *node):
        """The node, rounded if the definition is one with `rnd=`."""
        number = self.nodes(*node)
        return self.nodes("round", self.operator_rounding, number) if self.operator_rounding else number

    def sum(self):
        left = self.product()
        while self.peek() in ("+", "-"):
            operator = self.tokens.pop(0)
            left = self.operation(operator, left, self.product())
        return left

    def product(self):
        left = self.factor()
        while self.peek() == "*":
            self.tokens.pop(0)
            left = self.operation("*", left, self.factor())
        return left

    def factor(self):
        if not self.tokens:
            raise TermError("an expression is expected at the end")
        token = self.tokens.pop(0)
        if token == "-":
            return self.nodes("negate", self.factor())
        if token in "(|":
            inner = self.sum()
            self.expect(")" if token == "(" else "|")
            return inner if token == "(" else self.nodes("abs", inner)
        if token[0].isdigit():
            return self.nodes("number", read_number(token))
        if token in self.roundings:
            self.expect("(")
            inner = self.sum()
            self.expect(")")
            return self.nodes("round", self.roundings[token], inner)
        if not token[0].isalpha():
            raise TermError(f"{token!r} begins no expression")
        return self.names[token] if token in self.names else self.nodes("variable", token)

    def number(self):
        sign = self.tokens.pop(0) if self.peek() == "-" else ""
        return read_number(sign + self.tokens.pop(0))

    def atoms(self):
        found = [self.atom()]
        while self.peek() == "/\\":
            self.tokens.pop(0)
            found.append(self.atom())
        return found

    def atom(self):
        relative = self.tokens[0] == "|" and "-/" in self.tokens[:self.tokens.index("|", 1)]
        if relative:
            self.tokens.pop(0)
            a = self.sum()
            self.expect("-/")
            b = self.sum()
            self.expect("|")
            self.expect("<=")
            bound = self.number()
            return "rel", a, b, -bound, bound
        inner = self.sum()
        if self.expect("in", "<=") == "<=":
            bound = self.number()
            is_abs = self.nodes.nodes[inner][0] == "abs"
            return ("in", inner, Fraction(0), bound) if is_abs else ("le", inner, bound)
        self.expect("[")
        low = self.number()
        self.expect(",")
        high = self.number()
        self.expect("]")
        return "in", inner, low, high


# The terms that `gappa -Bcoq` prints.

LINE = re.compile(r"(?m)^(Notation|Definition|Variable|Let|Hypothesis|Axiom|Parameter|Conjecture|Admitted|Axioms|Parameters)\b *(.*)$")
DYADIC = re.compile(r"Float2 \((-?\d+)\) \((-?\d+)\)")
FALSE = "Lemma l1 : s1 -> False."


class Term:
    """The statement of a term: s1, the hypotheses with the negated goals, is proved to be false."""

    def __init__(self, text, nodes):
        self.nodes, self.bodies, self.variables, self.seen = nodes, {}, set(), {}
        for kind, rest in LINE.findall(text):
            rest = re.sub(r"\s*\(\*.*?\*\)\s*$", "", rest)
            variable = re.fullmatch(r"(\w+) : R\.", rest)
            body = re.fullmatch(r"(\w+) := (.*)\.", rest)
            if kind == "Variable" and variable:
                name = variable[1]
                self.variables.add(name)
            elif kind in ("Notation", "Definition") and body:
                name = body[1]
                if name in self.bodies:
                    raise TermError(f"{name} is defined twice")
                self.bodies[name] = body[2]
            else:
                raise TermError(f"the term assumes something, or defines it in another way: {kind} {rest}")
        if text.count(FALSE) != 1:
            raise TermError(f"the term has no lemma {FALSE!r}")
        hypotheses, goals = [], []
        self.collect(self.bodies.get("s1", ""), hypotheses, goals)
        self.statement = sorted(hypotheses), sorted(goals)

    def collect(self, body, hypotheses, goals):
        """Splits a conjunction into atoms and one disjunction of negated atoms."""
        both = re.fullmatch(r"\((\w+) (/\\|\\/) (\w+)\)", body)
        negated = re.fullmatch(r"\(not (\w+)\)", body)
        if both and both[2] == "/\\":
            for part in (both[1], both[3]):
                self.collect(self.body(part), hypotheses, goals)
        elif both or negated:
            if goals:
                raise TermError("more than one negated part")
            self.negations(body, goals)
        else:
            hypotheses.append(self.atom(body))

    def negations(self, body, goals):
        either = re.fullmatch(r"\((\w+) \\/ (\w+)\)", body)
        negated = re.fullmatch(r"\(not (\w+)\)", body)
        if either:
            for part in (either[1], either[2]):
                self.negations(self.body(part), goals)
        elif negated:
            goals.append(self.atom(self.body(negated[1])))
        else:
            raise TermError(f"no negated atom: {body}")

    def body(self, name):
        if name not in self.bodies:
            raise TermError(f"{name} is not defined")
        return self.bodies[name]

    def dyadic(self, name):
        match = DYADIC.fullmatch(self.body(name))
        if not match:
            raise TermError(f"{name} is no dyadic number: {self.body(name)}")
        return int(match[1]) * Fraction(2) ** int(match[2])

    def pair(self, name):
        match = re.fullmatch(r"makepairF (\w+) (\w+)", self.body(name))
        if not match:
            raise TermError(f"{name} is no interval: {self.body(name)}")
        return self.dyadic(match[1]), self.dyadic(match[2])

    def atom(self, body):
        inside = re.fullmatch(r"\(BND (\w+) (\w+)\)", body)
        relative = re.fullmatch(r"\(REL (\w+) (\w+) (\w+)\)", body)
        below = re.fullmatch(r"\(\((\w+) <= (\w+)\)%R\)", body)
        if inside:
            return ("in", self.expression(inside[1]), *self.pair(inside[2]))
        if relative:
            return ("rel", self.expression(relative[1]), self.expression(relative[2]), *self.pair(relative[3]))
        if below:
            return "le", self.expression(below[1]), self.dyadic(below[2])
        raise TermError(f"no atom: {body}")

    def expression(self, name):
        if name not in self.seen:
            self.seen[name] = self.build(name)
        return self.seen[name]

    def build(self, name):
        if name in self.variables:
            return self.nodes("variable", name[1:])
        body = self.body(name)
        binary = re.fullmatch(r"\(\((\w+) ([-+*]) (\w+)\)%R\)", body)
        unary = re.fullmatch(r"\(\((Rabs|-) ?(\w+)\)%R\)", body)
        rounded = re.fullmatch(r"\(\(rounding_float (\w+) \(53\)%positive \(-1074\)%Z\) (\w+)\)", body)
        whole = re.fullmatch(r"\(Float1 \((-?\d+)\)\)", body)
        dyadic = re.fullmatch(rf"\(float2R \({DYADIC.pattern}\)\)", body)
        if binary:
            return self.nodes(binary[2], self.expression(binary[1]), self.expression(binary[3]))
        if unary:
            return self.nodes("abs" if unary[1] == "Rabs" else "negate", self.expression(unary[2]))
        if rounded:
            return self.nodes("round", rounded[1], self.expression(rounded[2]))
        if whole:
            return self.nodes("number", Fraction(int(whole[1])))
        if dyadic:
            return self.nodes("number", int(dyadic[1]) * Fraction(2) ** int(dyadic[2]))
        raise TermError(f"no expression: {body}")


def constants_of(nodes, goals):
    """The Fractions in the constant's place of the goals: K of `... - K * (...) <= 0`, or c of `|det - det_exact| <= c`.

    The goals |rnd(y) - y| <= 1b-1075, which have no constant of a filter, differ by subtracting a variable.
    """
    found = set()
    for goal in goals:
        kind, expression, *ends = goal if goal[0] != "rel" else ("rel", goal[1])
        node = nodes.nodes[expression]
        if kind == "le" and node[0] == "-" and ends == [0] and nodes.nodes[node[2]][0] == "*":
            found.add(nodes.value(nodes.nodes[node[2]][1]))
        elif kind == "in" and node[0] == "abs" and nodes.nodes[node[1]][0] == "-" and nodes.nodes[nodes.nodes[node[1]][2]][0] != "variable":
            found.add(ends[1])
    return found


def faults(script_text, term_text, constant, factor=None):
    """What is wrong with a term: a list of sentences, empty if its statement is the script's and its constant the header's, a hexadecimal text.

    With a factor, the constant in the statement is the product rounded down to 53 bits.
    """
    nodes = Nodes()
    try:
        script, term = Script(script_text, nodes), Term(term_text, nodes)
        expected = read_number(constant) if factor is None else round_down(read_number(constant) * factor)
    except TermError as error:
        return [str(error)]
    out = []
    for what, ours, theirs in zip(("hypotheses", "goals"), script.statement, term.statement):
        if ours != theirs:
            out.append(f"the term's {what} are not the script's")
    found = constants_of(nodes, term.statement[1])
    if found != {expected}:
        out.append(f"the term's constant is {', '.join(map(str, sorted(found))) or 'missing'}, the header's {expected}")
    return out
