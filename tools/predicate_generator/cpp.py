# SPDX-License-Identifier: LGPL-3.0-or-later
"""The C++ of a predicate: names, and the templates of its formula."""
import re
import textwrap

from .expression import post_order
from .magnitude import is_monomial, is_own_magnitude

WIDTH = 100


def camel(name):
    return "".join(part[:1].upper() + part[1:] for part in name.split("_"))


def flat(name):
    """The C++ name of an input; a.x is a_x where it occurs alone."""
    return name.replace(".", "_")


class Names:
    """The C++ names of the nodes of a formula."""

    def __init__(self, formula):
        self.formula, self.of = formula, {}
        for name, node in formula.definitions:
            self.of.setdefault(id(node), name)
        taken = set(self.of.values()) | {name for name, dimension in formula.arguments if dimension}
        for leaf in formula.leaves:
            if id(leaf) not in self.of:
                name = flat(leaf.name) if leaf.kind == "input" else "_".join(flat(a.name) for a in leaf.args)
                while name in taken:
                    name += "_leaf"
                taken.add(name)
                self.of[id(leaf)] = name

    def leaf(self, node):
        return self.of[id(node)]

    def leaves(self):
        return [self.leaf(node) for node in self.formula.leaves]

    def parameters(self):
        """Points are references, numbers values."""
        return [f"const Vec{dimension}d& {name}" if dimension else f"double {name}"
                for name, dimension in self.formula.arguments]

    def arguments(self):
        return [name for name, _ in self.formula.arguments]


def wrapped(head, items, tail, indent=4):
    """head + the items between commas + tail, in lines of at most WIDTH columns."""
    text = head + ", ".join(items) + tail
    if len(text) <= WIDTH:
        return text
    # An item stays in one piece.
    whole = ", ".join(item.replace(" ", "\0") for item in items) + tail.replace(" ", "\0")
    body = textwrap.wrap(whole, WIDTH - indent, break_long_words=False, break_on_hyphens=False)
    return head + "\n" + "\n".join(" " * indent + line.replace("\0", " ") for line in body)


def comment(text, prefix="/// ", hanging=""):
    return "\n".join(textwrap.wrap(text, WIDTH, initial_indent=prefix, subsequent_indent=prefix + hanging,
                                   break_long_words=False,
                                   break_on_hyphens=False))


def statement(name, expression):
    # Lines end behind an operation, not within a product.
    text = re.sub(r" \* ", "\0*\0",
                  f"const auto {name} = {expression};").replace("const auto ", "const\0auto\0").replace(" = ", "\0=\0")
    lines = textwrap.wrap(text, WIDTH - 2, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)
    return "\n".join("  " + line.replace("\0", " ") for line in lines)


ATOM, PRODUCT, SUM = 0, 1, 2


def joined(kind, parts):
    """(text, rank) of an operation on two (text, rank): the order of evaluation is spelled by brackets."""
    allowed = PRODUCT if kind in "+-" else ATOM
    texts = [text if rank <= allowed else f"({text})" for text, rank in parts]
    return f" {kind} ".join(texts), SUM if kind in "+-" else PRODUCT


class Writer:
    """Expressions of nodes as (text, rank), with the names of those that have one."""

    def __init__(self, names):
        self.names, self.magnitudes = names, {}

    def value(self, node, open_it=False):
        name = self.names.of.get(id(node))
        if name and not open_it:
            return name, ATOM
        return self.operation(node, self.value, node.kind)

    def magnitude(self, node, open_it=False):
        if not open_it and id(node) in self.magnitudes:
            return self.magnitudes[id(node)], ATOM
        if is_own_magnitude(node):
            return self.value(node)
        if is_monomial(node):
            return f"abs({self.value(node)[0]})", ATOM
        return self.operation(node, self.magnitude, "+" if node.kind == "-" else node.kind)

    @staticmethod
    def operation(node, write, kind):
        if kind == "sqr":
            return f"sqr({write(node.args[0])[0]})", ATOM
        if kind == "*" and node.args[0].kind == "integer":
            return f"multiple<{node.args[0].value}>({write(node.args[1])[0]})", ATOM
        return joined(kind, [write(a) for a in node.args])


def det_lines(formula, names):
    """The definitions of the formula in their order, as C++, and the sign's expression."""
    write, needed = Writer(names), {id(node) for node in post_order([formula.sign])}
    lines, done = [], set()
    for name, node in formula.definitions:
        if id(node) in needed and not node.is_leaf and id(node) not in done:
            done.add(id(node))
            if names.of[id(node)] == name:
                lines.append(statement(name, write.value(node, open_it=True)[0]))
    return lines, write.value(formula.sign, open_it=True)[0]


def magnitude_lines(formula, names):
    write = Writer(names)
    lines, values, done = [], {}, set()
    used = {id(node) for node in post_order([formula.sign])}
    for name, node in formula.definitions:
        if id(node) not in used or node.is_leaf or id(node) in done:
            continue
        done.add(id(node))
        values[name] = statement(name, write.value(node, open_it=True)[0])
        lines.append((name, values[name]))
        if not is_own_magnitude(node):
            text = write.magnitude(node, open_it=True)[0]
            write.magnitudes[id(node)] = name + "_"
            lines.append((name + "_", statement(name + "_", text)))
    return prune(lines, write.magnitude(formula.sign, open_it=True)[0])


def prune(lines, last):
    """The definitions without those that no later one mentions."""
    kept, words = [], set(re.findall(r"\w+", last))
    for name, text in reversed(lines):
        if name in words:
            kept.append(text)
            words |= set(re.findall(r"\w+", text.split("=", 1)[1]))
    return kept[::-1], last
