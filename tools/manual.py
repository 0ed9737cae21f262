# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the manual page Resources/man/meshquality.1 from the parser of bin/meshquality.

    python3 tools/manual.py
"""

import argparse
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "Mod"))

from MeshQuality import version  # noqa: E402
from MeshQuality.cli import parser as cli_parser  # noqa: E402

PAGE = ROOT / "Resources" / "man" / "meshquality.1"

ENVIRONMENT = (
    ("MESHQUALITY_FREECADCMD", "FreeCAD's console program, where it is not freecadcmd on PATH."),
)
FILES = (
    ("OUT/meshes/", "Of batch: the meshes, in the folders and with the names of their parts."),
    ("OUT/parts.jsonl", "Of batch: a line of JSON a part: its state, its figures, or why it failed."),
    ("OUT/parts.csv", "Of batch: the same as a table, without lists."),
    ("OUT/report.html", "Of batch: histograms, the parts that failed, the worst parts."),
)


def text(words):
    """Plain text as roff has it."""
    words = words.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", words, flags=re.MULTILINE)


def paragraphs(words):
    return text(" ".join(words.split()))


def item(head, words):
    return [".TP", head, paragraphs(words)]


def actions(group):
    """An item for each argument of a group."""
    lines = []
    for action in group._group_actions:
        if isinstance(action, (argparse._HelpAction, argparse._VersionAction,
                               argparse._SubParsersAction)) or action.help == argparse.SUPPRESS:
            continue
        names = ", ".join(f"\\fB{text(flag)}\\fR" for flag in action.option_strings)
        value = f"\\fI{text(action.metavar)}\\fR" if action.metavar else ""
        lines += item(" ".join(filter(None, (names, value))), (action.help or "") % vars(action))
    return lines


def examples(epilog):
    body = epilog.partition("examples:\n")[2].partition("\n\n")[0]
    return [".PP", "Examples:", ".PP", ".nf", ".RS", text(body.rstrip("\n")), ".RE", ".fi"]


def command(name, parser, title):
    """The section of one command."""
    lines = [f".SS {name} \\- {text(title)}", f".B {text(parser.usage)}", ".PP",
             paragraphs(parser.description)]
    for group in parser._action_groups:
        found = actions(group)
        if found and group.title not in ("positional arguments", "options"):
            lines += [".PP", f"\\fI{text(group.title.capitalize())}\\fR"]
        lines += found
    return lines + examples(parser.epilog)


def page():
    """The manual page as one text."""
    top = cli_parser.parser()
    commands = next(action for action in top._actions
                    if isinstance(action, argparse._SubParsersAction))
    titles = {choice.dest: choice.help for choice in commands._choices_actions}
    lines = [
        '.\\" SPDX-License-Identifier: LGPL-2.1-or-later',
        '.\\" Made by tools/manual.py from the arguments of bin/meshquality.',
        f'.TH MESHQUALITY 1 "" "MeshQuality {version.__version__}" "User Commands"',
        ".SH NAME", "meshquality \\- quality meshes of CAD shapes, and operations on meshes",
        ".SH SYNOPSIS", ".B meshquality", "\\fICOMMAND\\fR [options]", ".br",
        ".B meshquality", "\\fICOMMAND\\fR \\fB\\-\\-help\\fR", ".br",
        ".B meshquality \\-\\-version",
        ".SH DESCRIPTION", paragraphs(top.description),
        "CAD files are read by FreeCAD, which does the work; it needs no screen.",
        "Progress is shown where standard error is a terminal.",
        ".SH COMMANDS",
    ]
    for name, parser in commands.choices.items():
        lines += command(name, parser, titles[name])
    lines += [".SH EXIT STATUS", *item("0", "Done."), *item("1", "Failed; of batch: a part failed."),
              *item("2", "Bad usage or bad input."),
              *item("3", "With --strict: done, but a requested limit is not met."), ".PP",
              "The last line on standard error says why."]
    for section, rows in (("ENVIRONMENT", ENVIRONMENT), ("FILES", FILES)):
        lines.append(f".SH {section}")
        for head, words in rows:
            lines += item(f"\\fB{text(head)}\\fR", words)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.parent.mkdir(parents=True, exist_ok=True)
    PAGE.write_text(page(), encoding="utf-8")
