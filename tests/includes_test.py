#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every file of the layers and of the program includes the standard headers whose names it uses. The builds compile
with a precompiled header that has them all (cmake/VeritopeTargets.cmake), so no compiler would report one that is
missing. A file may get a header through one of our headers that it includes. infra_headers_alone compiles each
header for itself; this test finds the usual mistake in seconds, and in .cc files, too."""
import functools
import pathlib
import re
import unittest

from infra import comments

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("robust", "splines", "interval", "predicates", "topology", "solids", "models", "io", "verify/format",
           "verify/certify", "verify/checker", "render", "named_predicates", "hard_models", "cli", "interop")

# Names of std:: by the header that the standard puts them in.
NAMES = {
    "algorithm": """adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if equal equal_range fill
        fill_n find find_if find_if_not generate includes inplace_merge is_permutation is_sorted
        lexicographical_compare lower_bound max max_element merge min min_element minmax minmax_element mismatch
        next_permutation none_of nth_element partial_sort partition partition_point prev_permutation remove
        remove_if replace reverse reverse_copy rotate search set_difference set_intersection set_union shuffle sort
        stable_sort swap_ranges transform unique upper_bound""",
    "array": "array to_array",
    "bit": """bit_cast bit_ceil bit_floor bit_width countl_one countl_zero countr_one countr_zero endian has_single_bit
        popcount rotl rotr""",
    "cmath": """atan2 cbrt ceil copysign cos exp exp2 fabs floor fma fmax fmin fmod fpclassify frexp hypot ilogb isfinite
        isinf isnan ldexp log log10 log2 logb lround modf nearbyint nextafter pow remainder rint round scalbn
        signbit sin sqrt tan trunc""",
    "functional": """bind cref function greater hash invoke less mem_fn minus multiplies not_fn plus ref reference_wrapper""",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "addressof allocator enable_shared_from_this make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "numeric": """accumulate adjacent_difference exclusive_scan gcd inclusive_scan inner_product iota lcm midpoint partial_sum
        reduce""",
    "optional": "make_optional nullopt optional",
    "span": "as_bytes as_writable_bytes span",
    "string": "basic_string getline stod stoi stol stoul stoull string to_string u8string",
    "string_view": "basic_string_view string_view",
    "variant": "bad_variant_access get_if holds_alternative monostate variant visit",
    "vector": "vector",
}
# What another header gives as well, by the standard or in every library there is.
ALSO = {"hash": {"string", "memory", "optional"}, "remove": {"cstdio"}, "string_view": {"string"}}
HEADER_OF = {name: header for header, names in NAMES.items() for name in names.split()}
USE = re.compile(r"\bstd::(\w+)")
INCLUDE = re.compile(r'(?m)^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)')


@functools.cache
def own(path):
    """(standard headers, our files) that the file itself includes, and its code."""
    text = path.read_text()
    standard, ours = set(), set()
    for mark, name in INCLUDE.findall(text):
        near = path.parent / name
        if mark == "<":
            standard.add(name)
        elif (ROOT / name).is_file():
            ours.add(ROOT / name)
        elif near.is_file():
            ours.add(near)
    return standard, ours, comments.split_cpp(text)[0]


def standard_headers(path):
    """The standard headers of the file and of all that it includes."""
    seen, todo, out = set(), [path], set()
    while todo:
        at = todo.pop()
        if at in seen:
            continue
        seen.add(at)
        standard, ours, _ = own(at)
        out |= standard
        todo += ours
    return out


def missing(path):
    """{header: a name of it} for those that the file needs and does not get."""
    there = standard_headers(path)
    out = {}
    for name in USE.findall(own(path)[2]):
        header = HEADER_OF.get(name)
        if header and header not in there and not ALSO.get(name, set()) & there:
            out.setdefault(header, name)
    return out


class Includes(unittest.TestCase):
    def test_every_file_includes_what_it_uses(self):
        paths = (path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*")))
        files = [path for path in paths if path.suffix in (".h", ".cc")]
        self.assertGreater(len(files), 600)
        for path in files:
            with self.subTest(path=str(path.relative_to(ROOT))):
                self.assertEqual(missing(path), {})

    def test_the_precompiled_headers_are_those_with_names_here(self):
        text = (ROOT / "cmake" / "VeritopeTargets.cmake").read_text()
        listed = set(re.findall(r"<(\w+)>", re.search(r"set\(VERITOPE_PRECOMPILED([^)]*)\)", text)[1]))
        # Every other standard header gives these three.
        self.assertEqual(listed - {"cstddef", "cstdint", "utility"}, set(NAMES))


if __name__ == "__main__":
    unittest.main()
