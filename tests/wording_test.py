#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Keeps lines short, and comments and pages plain.

Pages (*.md but changes/ and docs/design/, which tell history) have no sentence that opens with one of BANNED or has one of its
constructions. Each sentence of the pages for users, README first, has one of the verbs of VERBS: a sentence without any is probably
a fragment; if not, its verb is missing in the list. Lists, tables and headings may be fragments.

Two rules for code, each with an allowance a folder for what was there before the rule (tests/wording_allowance.txt, which only shrinks):
  line length  C++, CMake and Python outside of tests/ and of generated code: at most 120 columns;
  wording      comments of C++, CMake and Python: no sentence that opens with a bare genitive or another of BANNED.
`wording_test.py --list [FOLDER]` prints the places, `wording_test.py --lower` lowers the allowances to what is left.
"""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "infra"))
from comments import split  # noqa: E402
from tree import ROOT, files  # noqa: E402

MOST_COLUMNS = 120
ALLOWANCES = pathlib.Path("tests") / "wording_allowance.txt"
SLACK = 8  # An allowance that exceeds what is left by more than this must be lowered.

# name, pattern of one sentence of a comment, what to write instead
BANNED = [(name, re.compile(pattern), better) for name, pattern, better in (
    ("opens with Of", r"^Of (?!course)", "name the subject: 'The digits of ...', 'For a ...'"),
    ("opens with About", r"^About\b", "'Approximately', 'Approximate:', or a page's title"),
    ("opens with As many", r"^As (?:many|much|few)\b", "'The same number of ...'"),
    ("opens with None", r"^None\b", "'No box ...'"),
    ("opens with Back", r"^Back\b", "'Returns to ...', 'Converts back ...'"),
    ("opens with The same", r"^The same\b(?! as\b.*\bis\b)", "say what is computed: 'Adds ... in the same way'"),
    ("told", r"\b(?:is|are|was|were|be|been|not) told\b", "programs report, callers pass, names say"),
    ("is none", r"\b(?:is|are) none\b(?! of)", "'does not exist', 'has no ...'"),
    ("a digit less", r"\b(?:an?|one) [a-z]+ less\b(?! than)", "'one fewer digit'"),
    ("is no number", r"(?<![Tt]here )\b(?:is|are) no (?:legal )?(?:numbers?|points?|intervals?|boundary|manifolds?|polynomials?|"
                     r"signs?|decimals?|products?|members?|parameters?|facts?|defects?)\b", "'is not a number'"),
    ("one behind the other", r"\bone behind (?:the other|another)\b", "'one after the other'"),
)]
# The verbs of the pages for users, as stems: with or without s, es, ed. A noun such as "report" counts as the verb.
VERBS = re.compile(r"\b(?:am|is|are|was|were|be|has|have|had|can|cannot|could|do|does|did|may|must|should|will|would|"
                   r"made|makes?|found|finds?|read|reads|written|writes?|wrote|got|gets?|gives?|given|took|takes?|tells?|says?|said|"
                   r"(?:accept|answer|appear|apply|applie|ask|begin|bound|bring|call|certifi|certify|check|come|compare|compile|compute|"
                   r"consist|convert|copie|copy|correspond|count|cut|decide|declare|define|differ|draw|drop|end|ends|enforce|erase|exist|"
                   r"explain|face|fail|follow|form|gain|help|hold|identifie|ignore|include|intersect|keep|let|lie|lies|list|look|mean|measure|mirror|move|"
                   r"name|need|number|omit|open|point|print|prove|provide|put|reach|refuse|reject|remove|report|return|reverse|round|run|search|see|"
                   r"share|show|start|state|stop|support|test|trap|tr(?:y|ie)|turn|use|walk|want|work)(?:s|es|d|ed)?)\b")
HISTORY = ("changes/", "docs/design/")
FOR_USERS = ("README.md", "docs/README.md", "docs/library.md", "docs/cli/", "docs/how-to/fuzz-your-own-kernel.md")
CODE = {".h", ".cc", ".inc", ".py", ".cmake"}


def is_code(path):
    return path.suffix in CODE or path.name == "CMakeLists.txt"


def sentences(path, text):
    """(line, sentence) of every comment; lines of comments that follow each other are one comment."""
    blocks = []  # [first line, last line, text]
    for line, comment in sorted(split(path, text)[1]):
        own = text.splitlines()[line - 1].lstrip().startswith(comment.splitlines()[0].lstrip()[:2] or "\0")
        words = re.sub(r"(?m)^\s*(?://[/!]?<?|#+|/\*+|\*+/?)", "", comment)
        words = re.sub(r"^\s*@\w+(?: \w+)?", "", words)
        if blocks and own and blocks[-1][1] + 1 == line and blocks[-1][3]:
            blocks[-1][1], blocks[-1][2] = line, blocks[-1][2] + "\n" + words
        else:
            blocks.append([line, line, words, own])
    for first, _, words, _ in blocks:
        at = 0
        for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Z])|\n\s*\n", words):
            start = words.find(sentence, at)
            at = start + len(sentence)
            yield first + words.count("\n", 0, start + len(sentence) - len(sentence.lstrip())), " ".join(sentence.split())


def blocks_of_prose(text):
    """(line, paragraph or list item, whether it is a paragraph) of a page, without code, tables, headings and pictures."""
    text = re.sub(r"(?ms)^```.*?^```[ \t]*$", lambda code: "\n" * code[0].count("\n"), text)
    text = re.sub(r"(?m)^(?:\||#|!\[|    ).*$", "", text)
    line = 1
    for part in re.split(r"(\n[ \t]*\n|\n(?=[ \t]*(?:[-*]|\d+\.) ))", text):
        if part.strip():
            yield line + len(part[:len(part) - len(part.lstrip())].splitlines()), part.strip(), not re.match(r"(?:[-*]|\d+\.) ", part.strip())
        line += part.count("\n")


def sentences_of_page(text):
    """(line of the paragraph, sentence, whether it is one of a paragraph and not of a list)."""
    for line, block, is_paragraph in blocks_of_prose(text):
        words = re.sub(r"\[([^\]]*)\]\([^)\s]*\)", r"\1", " ".join(block.split()))
        for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Z`*])", re.sub(r"^(?:[-*]|\d+\.) ", "", words)):
            yield line, sentence, is_paragraph


def faults_of_page(path, text):
    """One line a fault."""
    for line, sentence, is_paragraph in sentences_of_page(text):
        for name, pattern, better in BANNED:
            if pattern.search(sentence):
                yield f"{path}:{line}: {name} (better: {better}): {sentence[:90]}"
        is_title = re.fullmatch(r"\*\*[^*]*\*\*\.?", sentence)
        if is_paragraph and path.startswith(FOR_USERS) and not is_title and not VERBS.search(re.sub(r"`[^`]*`", "", sentence)):
            yield f"{path}:{line}: no verb: {sentence[:90]}"


def folder_of(path):
    return path.parts[0] if len(path.parts) > 1 else "."


def places(root):
    """(rule, folder, place) of every fault."""
    for path in files(root):
        if not is_code(path) or "generated" in path.parts or path == pathlib.Path("tests/wording_test.py"):
            continue
        text = (root / path).read_text()
        if path.parts[0] != "tests":
            for number, line in enumerate(text.splitlines(), 1):
                if len(line) > MOST_COLUMNS:
                    yield "length", folder_of(path), f"{path}:{number}: {len(line)} columns"
        for number, sentence in sentences(path, text):
            for name, pattern, better in BANNED:
                if pattern.search(sentence):
                    yield "wording", folder_of(path), f"{path}:{number}: {name} (better: {better}): {sentence[:90]}"


def read_allowances(text):
    allowed = {}
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            rule, folder, count = line.split()
            allowed[rule, folder] = int(count)
    return allowed


def faults(root, allowed):
    """One line for each place of a folder that has more than it may have, and for each allowance that is far too large."""
    found = {}
    for rule, folder, place in places(root):
        found.setdefault((rule, folder), []).append(place)
    out = []
    for key in sorted(set(found) | set(allowed)):
        here, most = found.get(key, []), allowed.get(key, 0)
        if len(here) > most:
            out += [f"{key[0]} in {key[1]}: {len(here)}, allowed {most}"] + here
        elif most > len(here) + SLACK or (most and not here):
            out.append(f"{key[0]} in {key[1]}: {len(here)} left, allowed {most}: run tests/wording_test.py --lower")
    return out


class WordingOfTheTree(unittest.TestCase):
    def test_no_folder_has_more_long_lines_or_banned_sentences_than_it_may_have(self):
        out = faults(ROOT, read_allowances((ROOT / ALLOWANCES).read_text()))
        self.assertFalse(out, "\n" + "\n".join(out))


class WordingOfThePages(unittest.TestCase):
    def test_pages_have_no_banned_sentence_and_those_for_users_no_sentence_without_a_verb(self):
        pages = [str(path) for path in files(ROOT, {".md"}) if not str(path).startswith(HISTORY)]
        self.assertIn("README.md", pages)
        out = [fault for page in pages for fault in faults_of_page(page, (ROOT / page).read_text())]
        self.assertFalse(out, "\n" + "\n".join(out))


class PlantedFaultsOfPages(unittest.TestCase):
    SOUND = "# Of a title\n\nA program reads files. It\nreports them.\n\n- a list item. Of course.\n\n| of | a table |\n\n```\nOf code. None.\n```\n"

    def test_a_sound_page_has_none(self):
        self.assertEqual(list(faults_of_page("README.md", self.SOUND)), [])

    def test_each_banned_construction_is_found_with_its_line(self):
        for sentence in ("Of two files the second is read.", "None of them is read.", "The same is true.", "About a tenth is read.",
                         "The program is told so.", "A sum that is no number is read."):
            for text in (self.SOUND + "\n" + sentence + "\n", self.SOUND + "\n- It is read. " + sentence + "\n"):
                (fault,) = faults_of_page("docs/rules/M1.md", text)
                self.assertIn("docs/rules/M1.md:14: ", fault)

    def test_a_sentence_without_a_verb_is_found_on_pages_for_users_only(self):
        for fragment in ("Bytes of a file, exact.", "A prism of `is` and triangles."):
            (fault,) = faults_of_page("docs/cli/info.md", f"It reads files. {fragment}\n")
            self.assertIn("no verb: " + fragment, fault)
            self.assertEqual(list(faults_of_page("docs/rules/M1.md", f"It reads files. {fragment}\n")), [])


class PlantedFaults(unittest.TestCase):
    """Every rule rejects one small tree that breaks it, and accepts the tree before."""

    SOUND = {
        "robust/integer.h": "// robust/integer.h: integers.\n/// The sum of a and b. Rounds like double.\nint add(int a, int b);  ///< exact\n",
        "robust/CMakeLists.txt": "# Of course a layer.\nveritope_layer(robust robust)\n",
        "tools/make.py": '"""Makes a table."""\nprint("Of what is told there is none")\n',
        "tests/robust/long_test.cc": "// " + "x" * 130 + "\n",
        "predicates/generated/table.h": "// Of a table. " + "x" * 130 + "\n",
    }

    def faults(self, changes, allowed=None):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**self.SOUND, **changes}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return faults(root, allowed or {})

    def assert_fault(self, name, text, expected):
        found = self.faults({name: text})
        self.assertEqual(len(found), 2, found)
        self.assertIn(expected, found[1])

    def test_the_sound_tree_has_none(self):
        self.assertEqual(self.faults({}), [])

    def test_a_long_line_is_found_in_each_language(self):
        for name, comment in (("robust/a.cc", "//"), ("robust/a.cmake", "#"), ("tools/a.py", "#")):
            self.assertEqual(self.faults({name: comment + "x" * (120 - len(comment)) + "\n"}), [])
            self.assert_fault(name, comment + "x" * (121 - len(comment)) + "\n", "121 columns")

    def test_each_banned_construction_is_found(self):
        for sentence, expected in (("Of a planar model the faces.", "opens with Of"), ("About, for an order.", "opens with About"),
                                   ("As many numbers over one denominator.", "opens with As many"), ("None of them fits.", "opens with None"),
                                   ("Back to the first one.", "opens with Back"), ("The same for triangles.", "opens with The same"),
                                   ("The caller is told so.", "told"), ("A sum of these is none.", "is none"),
                                   ("With an operation less.", "a digit less"), ("A sum that is no number.", "is no number"),
                                   ("Such covers are no manifolds.", "is no number"),
                                   ("The parts lie one behind the other.", "one behind the other")):
            self.assert_fault("robust/a.h", f"/// {sentence}\n", expected)
            self.assert_fault("robust/a.h", f"/// What is true is said. {sentence}\nint a;\n", expected)
            self.assert_fault("robust/a.h", f"int a;  ///< {sentence}\n", expected)
            self.assert_fault("tools/a.py", f'"""A page.\n\n{sentence}\n"""\n', expected)

    def test_a_sentence_is_found_where_its_lines_are_broken(self):
        self.assert_fault("robust/a.h", "/// One.\n/// Here a name is\n/// told.\n", "robust/a.h:2: told")

    def test_what_does_not_exist_may_be_none(self):
        self.assertEqual(self.faults({"robust/a.h": "/// There is no number; there are no points. The sum is no longer than this.\n"}), [])

    def test_a_continued_line_opens_no_sentence(self):
        self.assertEqual(self.faults({"robust/a.h": "/// The faces are those\n/// Of the model, without\n/// The same ones again.\n"}), [])

    def test_a_string_is_no_comment(self):
        self.assertEqual(self.faults({"robust/a.cc": 'const char* a = "// Of a model";\n'}), [])

    def test_an_allowance_permits_as_many_and_no_more_and_must_shrink(self):
        changes = {"robust/a.h": "// Of one.\nint a;\n// Of two.\n"}
        self.assertEqual(self.faults(changes, {("wording", "robust"): 2}), [])
        self.assertEqual(len(self.faults(changes, {("wording", "robust"): 1})), 3)
        self.assertIn("--lower", self.faults(changes, {("wording", "robust"): 3 + SLACK})[0])
        self.assertIn("--lower", self.faults({}, {("wording", "robust"): 1})[0])


def lower():
    """Never raises a number."""
    path = ROOT / ALLOWANCES
    allowed, found = read_allowances(path.read_text()), {}
    for rule, folder, _ in places(ROOT):
        found[rule, folder] = found.get((rule, folder), 0) + 1
    head = [line for line in path.read_text().splitlines() if line.startswith("#")]
    rows = [f"{rule} {folder} {min(most, found.get((rule, folder), 0))}" for (rule, folder), most in sorted(allowed.items())]
    path.write_text("\n".join(head + [row for row in rows if not row.endswith(" 0")]) + "\n")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--list"]:
        for _rule, _folder, _place in places(ROOT):
            if len(sys.argv) < 3 or _folder == sys.argv[2]:
                print(_place)
    elif sys.argv[1:] == ["--lower"]:
        lower()
    else:
        unittest.main()
