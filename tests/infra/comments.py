# SPDX-License-Identifier: LGPL-3.0-or-later
"""Splits a source file into its code and its comments, well enough to look for names in either."""
import ast
import io
import re
import tokenize

CPP_TOKEN = re.compile(r'(?P<string>"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')|(?P<comment>//[^\n]*|/\*.*?\*/)', re.S)


def split_cpp(text):
    """(code, comments); strings belong to the code, comments keep their line numbers."""
    comments = []

    def cut(match):
        if match["comment"] is None:
            return match[0]
        comments.append((text.count("\n", 0, match.start()) + 1, match[0]))
        return "\n" * match[0].count("\n")

    return CPP_TOKEN.sub(cut, text), comments


def split_python(text):
    """Docstrings are comments."""
    comments, code = [], []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        (comments if token.type == tokenize.COMMENT else code).append((token.start[0], token.string))
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            comments.append((node.body[0].lineno, ast.get_docstring(node, clean=False)))
    return " ".join(string for _, string in code), comments


def split_hash(text):
    """Shell, CMake, tables: # starts a comment at the beginning of a line or after a blank."""
    comments = [(number, match[0]) for number, line in enumerate(text.splitlines(), 1)
                if (match := re.search(r"(?:^|(?<=\s))#.*", line))]
    return re.sub(r"(?m)(?:^|(?<=\s))#.*", "", text), comments


def split(path, text):
    """(code, [(line, comment)]) of a file of ours; (text, []) where there are no comments."""
    if path.suffix in (".h", ".cc", ".inc"):
        return split_cpp(text)
    if path.suffix == ".py":
        return split_python(text)
    if path.suffix in (".cmake", ".txt", ".sh") or path.name in ("dev", "run", "pre-commit"):
        return split_hash(text)
    return text, []
