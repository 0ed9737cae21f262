# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every document: its links, its pictures and the tests that it names exist, and its paragraphs and
sentences are short.

Tables, code, headings and formulas are neither paragraphs nor sentences.

    /usr/bin/python3 tests/tools/documents.py     lists what does not hold
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_WORDS_OF_PARAGRAPH = 100
MOST_WORDS_OF_SENTENCE = 45
# Made from docstrings by tools/reference; its paragraphs are descriptions of arguments.
GENERATED = {"docs/reference.md"}
PICTURES = (".png", ".svg")
KINDS = ("use", "method", "measurements", "papers")

_LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
_FENCE = re.compile(r"^ *```.*?^ *```", re.MULTILINE | re.DOTALL)
_NEW_ITEM = re.compile(r"^\s*(?:[-*]|\d+\.)\s+")
_TEST = re.compile(r"`(test_\w+)\.(\w+)\.(test_\w+)`")
_ATTACK = re.compile(r"`(\w+): ([^`]+)`")
_HEADING = re.compile(r"^#+\s+(.*?)\s*$", re.MULTILINE)
_SENTENCE_END = re.compile(r"(?<=[.!?])[)*\"]*\s+(?=[\[(*`\"A-Z0-9])")


def documents(root=ROOT):
    """The documents people read: README, SECURITY and all of docs/."""
    return [root / "README.md", root / "SECURITY.md", *sorted((root / "docs").rglob("*.md"))]


def without_code(text):
    """The text with the lines of fenced code taken out, so that line numbers stay."""
    return _FENCE.sub(lambda match: "\n" * match.group().count("\n"), text)


def anchors(text):
    """The names by which a link can reach the headings of a document, as GitHub makes them."""
    found = set()
    for heading in _HEADING.findall(without_code(text)):
        plain = re.sub(r"[^\w\- ]", "", _LINK.sub(r"\2", heading).lower())
        found.add(plain.replace(" ", "-"))
    return found


def links(text):
    """(is_picture, target) of each link."""
    return [(bool(mark), target) for mark, _, target in _LINK.findall(without_code(text))]


def paragraphs(text):
    """(line, words) of each paragraph and each item of a list; without code, tables and headings."""
    found, lines, first = [], [], 0

    def end():
        if lines:
            found.append((first, " ".join(lines)))
        lines.clear()

    for number, line in enumerate(without_code(text).splitlines(), 1):
        is_code = line.startswith("    ") and not lines
        if not line.strip() or is_code or line.lstrip().startswith(("|", "#")):
            end()
            continue
        if _NEW_ITEM.match(line):
            end()
        if not lines:
            first = number
        lines.append(_NEW_ITEM.sub("", line.strip()))
    end()
    return found


def words(text):
    """The words of a text; a picture has none, a link those that are read."""
    shown = _LINK.sub(lambda match: "" if match.group(1) else match.group(2), text)
    return [word for word in shown.split() if re.search(r"\w", word)]


def sentences(paragraph):
    return _SENTENCE_END.split(paragraph)


def too_long(path, root=ROOT):
    """What is longer than it may be in a document, as lines of text."""
    name, found = path.relative_to(root).as_posix(), []
    if name in GENERATED:
        return found
    for line, paragraph in paragraphs(path.read_text(encoding="utf-8")):
        count = len(words(paragraph))
        if count > MOST_WORDS_OF_PARAGRAPH:
            found.append(f"{name}:{line}: a paragraph of {count} words")
        for sentence in sentences(paragraph):
            count = len(words(sentence))
            if count > MOST_WORDS_OF_SENTENCE:
                found.append(f"{name}:{line}: a sentence of {count} words: {sentence[:60]}...")
    return found


def broken_links(path, root=ROOT):
    """The links of a document that lead nowhere, as lines of text."""
    name, found = path.relative_to(root).as_posix(), []
    text = path.read_text(encoding="utf-8")
    for _, target in links(text):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        there = (path.parent / file).resolve() if file else path
        if not there.exists():
            found.append(f"{name}: {target} does not exist")
        elif anchor and anchor not in anchors(there.read_text(encoding="utf-8")):
            found.append(f"{name}: {target}: no such heading")
    return found


def missing_tests(path, root=ROOT):
    """The tests and attacks named in a document that do not exist: `test_file.Class.test_name`, `table: attack`."""
    name, found = path.relative_to(root).as_posix(), []
    text = path.read_text(encoding="utf-8")
    for file, group, test in _TEST.findall(text):
        sources = (source.read_text(encoding="utf-8") for source in (root / "tests").glob(f"*/{file}.py"))
        classes = [code for source in sources for code in re.split(r"^class ", source, flags=re.MULTILINE)]
        if not any(re.match(rf"{group}\b", code) and f"def {test}(" in code for code in classes):
            found.append(f"{name}: no test is called {file}.{group}.{test}")
    for table, attack in _ATTACK.findall(text):
        source = root / "tests" / "attacks" / f"{table}.py"
        if source.is_file() and attack not in source.read_text(encoding="utf-8"):
            found.append(f"{name}: no attack of {table} is called {attack}")
    return found


def unused_pictures(root=ROOT):
    """The pictures of docs/ that no document shows."""
    shown = {(path.parent / target).resolve() for path in documents(root)
             for is_picture, target in links(path.read_text(encoding="utf-8")) if is_picture}
    return [path.relative_to(root).as_posix() for path in sorted((root / "docs").rglob("*"))
            if path.suffix in PICTURES and path.resolve() not in shown]


def unreachable(root=ROOT):
    """The pages of docs/ to which no chain of links leads from the README."""
    reached, waiting = set(), [root / "README.md"]
    while waiting:
        path = waiting.pop()
        if path in reached:
            continue
        reached.add(path)
        for _, target in links(path.read_text(encoding="utf-8")):
            there = (path.parent / target.partition("#")[0]).resolve()
            if there.suffix == ".md" and there.is_file():
                waiting.append(there)
    return [path.relative_to(root).as_posix() for path in sorted((root / "docs").rglob("*.md")) if path not in reached]


def missing_figures(root=ROOT):
    """Pages of methods without a figure or a link to the folder of their code."""
    found = []
    for path in sorted((root / "docs" / "method").glob("*.md")):
        targets = links(path.read_text(encoding="utf-8"))
        name = path.relative_to(root).as_posix()
        if not any(is_picture for is_picture, _ in targets):
            found.append(f"{name} has no figure")
        if not any("/src/" in target or "/Mod/" in target for _, target in targets):
            found.append(f"{name} names no folder of code")
    return found


def missing_commands(root=ROOT):
    """Pages of measurements that name nothing by which their figures can be repeated."""
    return [f"{path.relative_to(root).as_posix()} names no benchmark or tool"
            for path in sorted((root / "docs" / "measurements").glob("*.md"))
            if not re.search(r"\b(?:benchmarks|tools|tests)/\w", path.read_text(encoding="utf-8"))]


def of_no_kind(root=ROOT):
    """Pages in other folders of docs/ than those of the kinds."""
    kinds = [root / "docs", *(root / "docs" / kind for kind in KINDS)]
    return [f"{path.relative_to(root).as_posix()} is of no kind: {', '.join(KINDS)}"
            for path in sorted((root / "docs").rglob("*.md")) if path.parent not in kinds]


def lost_walks(root=ROOT):
    """Steps of the walks through the code whose file does not exist, or does not have the names that they say. A step is
    "1. `FILE`, `NAME` and `OTHER`: what it does"; other files of the step lie beside the first.
    """
    page = root / "docs" / "architecture.md"
    _, _, walks = page.read_text(encoding="utf-8").partition("## Walks\n") if page.exists() else ("", "", "")
    found = []
    for _, step in paragraphs(walks.partition("\n## ")[0]):
        file, *names = re.findall(r"`([^`]+)`", re.split(r"(?<!:):(?!:)", step)[0]) or [""]
        if "/" not in file:
            continue  # no step
        if not (root / file).is_file():
            found.append(f"docs/architecture.md: {file} does not exist")
            continue
        text = (root / file).read_text(encoding="utf-8")
        for name in names:
            is_there = (root / file).with_name(name).is_file() if "." in name else \
                re.search(rf"\b{re.escape(name.rpartition('::')[2])}\b", text)
            if not is_there:
                found.append(f"docs/architecture.md: {file} has no {name}")
    return found


def complaints(root=ROOT):
    """All that does not hold, as lines of text."""
    found = []
    for path in documents(root):
        found += too_long(path, root) + broken_links(path, root) + missing_tests(path, root)
    found += [f"{name}: no document shows it" for name in unused_pictures(root)]
    found += [f"{name}: no link leads to it" for name in unreachable(root)]
    return found + missing_figures(root) + missing_commands(root) + of_no_kind(root) + lost_walks(root)


if __name__ == "__main__":
    faults = complaints()
    print("\n".join(faults) or "All documents keep the rules.")
    sys.exit(1 if faults else 0)
