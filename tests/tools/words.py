# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comments of the C++ code are sentences that name their quantities, and names are the field's. Each check returns a list of sentences, one a
fault.
"""

import re
from pathlib import Path

FILES = {".h", ".cpp", ".i"}
# Code without comments, to be skipped: string literals (raw ones too), characters, and all that begins no comment.
# A comment is a run of // lines, each with nothing but the next before it, or a /* */ block.
TOKEN = re.compile(
    r'R"(?P<fence>[^()\\\s]*)\(.*?\)(?P=fence)"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"
    r"|(?P<comment>//[^\n]*(?:\n[ \t]*//[^\n]*)*|/\*.*?\*/)",
    re.DOTALL,
)
MARK = re.compile(r"^[ \t]*(?://[/!]?<?|/?\*+/?)[ \t]?")
# A noun phrase that completes a sentence nobody has read.
FRAGMENT = re.compile(r"of\b", re.IGNORECASE)
# By retired words what to write instead. Words in `quotes` and names after @param are the code's own.
RETIRED = {
    r"so (?:many|much|far)": "name the quantity",
    r"what (?:is|was) asked for": "name what is requested",
    r"for ever": "without end, or without terminating",
    r"by and by": "later",
    r"within nothing": "within the resolution",
    r"the part(?!\.[A-Z])|to part": "the model or the shape; a fraction; to separate",
    r"part of": "fraction of, piece of, or region of",
    r"flush": "coplanar within rounding",
}
CODE = re.compile(r"`[^`]*`|@param\s+\S+")


def comments(text):
    """(line, text) of each paragraph of each comment, its lines joined."""
    found = []
    for match in TOKEN.finditer(text):
        if not match["comment"]:
            continue
        first = text.count("\n", 0, match.start()) + 1
        indent = " " * (match.start() - text.rfind("\n", 0, match.start()) - 1)
        place = None  # column and mark of the paragraph: a comment after code does not go on in a line of its own
        for number, row in enumerate((indent + match["comment"]).splitlines(), first):
            mark = MARK.match(row)
            words = re.sub(r"\*/$", "", row[mark.end():] if mark else row).strip()
            here = mark[0].rstrip() if mark and "//" in mark[0] else ""
            if words and here == place:
                found[-1] = (found[-1][0], f"{found[-1][1]} {words}")
            elif words:
                found.append((number, words))
            place = here if words else None
    return found


def _faults_of(comment):
    if FRAGMENT.match(comment):
        yield f'begins with "{comment.split()[0]}": write a sentence'
    prose = CODE.sub("", comment)
    for retired, instead in RETIRED.items():
        found = re.search(rf"\b(?:{retired})\b", prose, re.IGNORECASE)
        if found:
            yield f'"{found[0]}": {instead}'


def check_comments(root):
    """No comment of src/ begins with "of", and none has a word that was retired for one that names the quantity."""
    faults = []
    for path in sorted((root / "src").rglob("*")):
        if path.suffix not in FILES:
            continue
        for line, comment in comments(path.read_text(encoding="utf-8")):
            faults += [f"{path.relative_to(root).as_posix()}:{line}: {fault}" for fault in _faults_of(comment)]
    return faults


def retired_names():
    """{name: the one that took its place} of tests/tools/retired_names.txt."""
    lines = (Path(__file__).parent / "retired_names.txt").read_text(encoding="utf-8").splitlines()
    return dict(line.split() for line in lines if not line.startswith("#"))


def check_names(root):
    """No C++ of src/ and tests/ has a name that was retired."""
    retired = retired_names()
    faults = []
    for path in sorted([*(root / "src").rglob("*"), *(root / "tests" / "cpp").rglob("*")]):
        if path.suffix not in FILES:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            faults += [f"{path.relative_to(root).as_posix()}:{number}: {name} is called {retired[name]}"
                       for name in re.findall(r"\w+", line) if name in retired]
    return faults


RETIRED_IN_PYTHON = {words: instead for words, instead in RETIRED.items()
                     if words in (r"so (?:many|much|far)", r"for ever", r"by and by", r"within nothing")}


def check_python(root):
    """No comment or text of Mod/MeshQuality has words that were retired for ones that name the quantity."""
    faults = []
    for path in sorted((root / "Mod" / "MeshQuality").rglob("*.py")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for retired, instead in RETIRED_IN_PYTHON.items():
                found = re.search(rf"\b(?:{retired})\b", line, re.IGNORECASE)
                if found:
                    faults.append(f'{path.relative_to(root).as_posix()}:{number}: "{found[0]}": {instead}')
    return faults


CHECKS = [check_comments, check_names, check_python]
