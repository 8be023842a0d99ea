# SPDX-License-Identifier: LGPL-3.0-or-later
"""Gappa scripts: kRel pays for the roundings on the way of every monomial (docs/bounds/gappa/README.md)."""
import math
import re
from fractions import Fraction

from .cpp import flat
from .expression import post_order
from .header import hexadecimal


class Path:
    """A monomial's way through a formula: leaves, nodes that round it (with multiplicity), how often it occurs."""

    def __init__(self, leaves, nodes, count):
        self.leaves, self.nodes, self.count = leaves, nodes, count


def joined(a, b, node):
    return Path(tuple(sorted(a.leaves + b.leaves)), tuple(sorted(a.nodes + b.nodes + (node,))), a.count * b.count)


def merged(paths):
    found = {}
    for path in paths:
        key = (path.leaves, path.nodes)
        if key in found:
            found[key].count += path.count
        else:
            found[key] = Path(path.leaves, path.nodes, path.count)
    return list(found.values())


def paths_of(formula, names):
    """All of the sign's. The nodes are numbers: the order of evaluation; a leaf that is a difference rounds, too."""
    found, number = {}, 0
    for node in post_order([formula.sign]):
        if node.is_leaf:
            number += 1 if node.args else 0
            found[id(node)] = [Path((names.leaf(node),), (number,) if node.args else (), 1)]
            continue
        if node.kind == "integer":
            found[id(node)] = [Path((), (), node.value)]
            continue
        number += 1
        args = [found[id(a)] for a in node.args]
        if node.kind in "+-":
            found[id(node)] = [Path(p.leaves, p.nodes + (number,), p.count) for p in args[0] + args[1]]
        else:
            found[id(node)] = [joined(p, q, number) for p in args[0] for q in args[-1]]
        found[id(node)] = merged(found[id(node)])
    return found[id(formula.sign)], number


def shape_of(path, last):
    """The number of occurrences of each rounding, without the last addition, in falling order."""
    counts = {}
    for node in path.nodes:
        if node != last:
            counts[node] = counts.get(node, 0) + 1
    return tuple(sorted(counts.values(), reverse=True))


def product_of(variable, shape):
    factors = [f"(1 + {variable}{i})" for i, times in enumerate(shape, 1) for _ in range(times)]
    return " * ".join(factors) or "1"


NEAREST = ("@rnd = float<ieee_64, ne>;", "1b-53", "|rnd(x) -/ x| <= 1b-53 /\\ |rnd(y) - y| <= 1b-1075")
ANY_MODE = ("@up = float<ieee_64, up>;\n@down = float<ieee_64, dn>;\n@toward_zero = float<ieee_64, zr>;", "1b-52",
            " /\\\n   ".join(f"|{mode}(x) -/ x| <= 1b-52 /\\ |{mode}(y) - y| <= 1b-1074"
                             for mode in ("up", "down", "toward_zero")))


def script(name, source, rel, paths, last, magnitude_of, terms, modes=NEAREST):
    """magnitude_of(shape): the roundings of what the code computes in the place of S; S is at most `terms` times it."""
    classes = {}
    for path in paths:
        classes.setdefault(shape_of(path, last), []).append(path)
    lines, goals, sums, most, most_magnitude = [], [], {}, 0, 0
    for i, (shape, members) in enumerate(sorted(classes.items()), 1):
        magnitude = magnitude_of(shape)
        most, most_magnitude = max(most, len(shape)), max(most_magnitude, len(magnitude))
        example = " ".join(members[0].leaves)
        lines += [f"# {len(members)} monomial{'s' if len(members) > 1 else ''}, the first is {example}",
                  f"way{i} = {product_of('d', shape)};"]
        if magnitude not in sums:
            sums[magnitude] = f"sum{len(sums) + 1}"
            lines.append(f"{sums[magnitude]} = {product_of('s', magnitude)};")
        goals.append(f"{terms} * |way{i} - 1| * (1 + last) - kRel * ({sums[magnitude]} * (1 + e1) * (1 + e2)) <= 0")
    variables = [f"d{i}" for i in range(1, most + 1)] + [f"s{i}"
                                                         for i in range(1, most_magnitude + 1)] + ["last", "e1", "e2"]
    rounding, unit, model = modes
    hypotheses = [f"{v} in [-{unit}, {unit}]" for v in variables]
    return f"""# SPDX-License-Identifier: LGPL-3.0-or-later
# {name}: kRel pays for the roundings of every monomial. What that proves: README.md.
# Made by tools/generate_predicates.py from {source}: do not edit.
{rounding}
kRel = {rel};
{chr(10).join(lines)}
{{ |x| in [1b-1021, 1b1023] /\\ |y| <= 1b-1021 /\\
{' /' + chr(92) + chr(10)}  {(' /' + chr(92) + chr(10) + '  ').join(hypotheses)}
-> {model} /\\
   {(' /' + chr(92) + chr(10) + '   ').join(goals)} }}
""".replace("/\\\n /\\\n", "/\\\n")


def write_scripts(formula, names, bound, shown):
    """(the script of the constant, the script of the box)"""
    paths, number = paths_of(formula, names)
    last = number if formula.sign.is_sum else None
    rel = hexadecimal(bound.rel)
    return (script(formula.name, shown, rel, paths, last, lambda shape: shape + ((1,) if last else ()), 1),
            write_box_script(formula, names, shown, rel, 1))


def constant_in(root, text):
    """(value as written) of "kName in path"."""
    name, _, path = text.split()
    match = re.search(rf"\b{name}\s*=\s*(0x[0-9a-f.]+p[-+]?\d+)", (root / path).read_text(encoding="utf-8"))
    if not match:
        raise ValueError(f"{path} has no constant {name}")
    return match[1]


def write_by_hand_scripts(formula, names, shown, root):
    """bound: "S", or "TERMS times a product of ROUNDINGS roundings"."""
    paths, number = paths_of(formula, names)
    last = number if formula.sign.is_sum else None
    words = formula.texts["bound"].split()
    rel = constant_in(root, formula.texts["constant"])
    if words == ["S"]:
        magnitude_of, terms = (lambda shape: shape + ((1,) if last else ())), 1
    else:
        terms, roundings = int(words[0]), int(words[5])
        magnitude_of = lambda shape: (1,) * roundings  # noqa: E731
    modes = ANY_MODE if formula.texts.get("rounding") == "any" else NEAREST
    return script(formula.name, shown, rel, paths, last, magnitude_of, terms,
                  modes), write_box_script(formula, names, shown, rel, terms)


def round_down(value):
    """The greatest binary64 number that is not larger."""
    return math.nextafter(float(value), 0.0) if Fraction(float(value)) > value else float(value)


def size_at_one(node, found):
    """S where every leaf is 1 in magnitude: the number of monomials."""
    if id(node) not in found:
        args = [size_at_one(a, found) for a in (node.args if not node.is_leaf else ())]
        found[id(node)] = (1 if node.is_leaf else node.value if node.kind == "integer" else
                           args[0] + args[1] if node.kind in "+-" else args[0] * args[-1])
    return found[id(node)]


def write_box_script(formula, names, source, rel, terms):
    """The rounded program itself, on inputs of [0, 1]; terms as for script."""
    name_of, lines = {}, [f"{flat(i)} = rnd({flat(i)}_);" for i in formula.inputs]
    exact = []
    for k, node in enumerate(post_order([formula.sign])):
        if node.kind in ("integer", "input"):
            name_of[id(node)] = (flat(node.name) or str(node.value),) * 2
            continue
        parts = [(flat(a.name),) * 2 if node.is_leaf else name_of[id(a)] for a in node.args]
        kind = "*" if node.kind == "sqr" else node.kind
        label = "det" if node is formula.sign else names.of.get(id(node), f"t{k}")
        lines.append(f"{label} rnd= {parts[0][0]} {kind} {parts[-1][0]};")
        exact.append(f"{label}_exact = {parts[0][1]} {kind} {parts[-1][1]};")
        name_of[id(node)] = (label, label + "_exact")
    size = Fraction(size_at_one(formula.sign, {}), terms)
    bound = Fraction(float.fromhex(rel)) * size
    hypotheses = [f"{flat(i)} in [0, 1]" for i in formula.inputs]
    title = (f"# {formula.name}: the program as it is, on numbers of [0, 1]: at most kRel {size} from the exact value. "
             "What that says: README.md.")
    return f"""# SPDX-License-Identifier: LGPL-3.0-or-later
{title}
# Made by tools/generate_predicates.py from {source}: do not edit.
@rnd = float<ieee_64, ne>;
{chr(10).join(lines)}
{chr(10).join(exact)}
{{ {(' /' + chr(92) + chr(10) + '  ').join(hypotheses)}
-> |det - det_exact| <= {round_down(bound).hex()} }}
"""
