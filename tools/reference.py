# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/reference.md from the docstrings of the package.

    tools/reference     writes it
"""

import inspect
from pathlib import Path

import MeshQuality

PAGE = Path(__file__).resolve().parent.parent / "docs" / "reference.md"
MADE_BY_USERS = ("Memory",)
HEAD = """# Reference

Everything public of `import MeshQuality as mq`, from the docstrings: `tools/reference` writes this
page. Lengths are in mm, angles in degrees. What is named here stays as it is within a major version;
see [contributing](contributing.md).
"""


def public_names():
    """Of the package, functions first, then classes, then errors."""
    def order(name):
        value = getattr(MeshQuality, name)
        kind = 0 if not inspect.isclass(value) else 2 if issubclass(value, Exception) else 1
        return kind, name.lower()

    return sorted(MeshQuality.__all__, key=order)


def members(cls):
    """[(name, value), ...] of what a class defines for its users, in its order."""
    return [(name, value) for name, value in vars(cls).items() if not name.startswith("_")]


def _block(text):
    return f"```text\n{text}\n```\n"


def _cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def _signature(name, value):
    try:
        return f"{name}{inspect.signature(value)}"
    except (TypeError, ValueError):  # made by pybind11: the first line of the docstring is one
        return inspect.getdoc(value).splitlines()[0]


def _code(name, value):
    return f"```python\n{_signature(name, value)}\n```\n"


def _function(name, value):
    return f"## {name}\n\n{_code(name, value)}\n{_block(inspect.getdoc(value))}"


def _class(name, cls):
    parts = [f"## {name}\n"]
    if name in MADE_BY_USERS:
        parts.append(_code(name, cls))
    parts.append(_block(inspect.getdoc(cls)))
    rows = [(member, inspect.getdoc(value)) for member, value in members(cls)
            if inspect.isdatadescriptor(value) and inspect.getdoc(value)]  # of slots the class tells
    if rows:
        parts.append("| property | |\n|---|---|")
        parts += [f"| `{member}` | {_cell(text)} |" for member, text in rows]
        parts.append("")
    for member, value in members(cls):
        if callable(value) or isinstance(value, classmethod):
            bound = getattr(cls, member)
            parts.append(f"### {name}.{member}\n\n{_code(member, bound)}\n"
                         f"{_block(inspect.getdoc(bound))}")
    return "\n".join(parts)


def page():
    """The text of docs/reference.md."""
    parts = [HEAD]
    for name in public_names():
        value = getattr(MeshQuality, name)
        parts.append(_class(name, value) if inspect.isclass(value) else _function(name, value))
    return "\n".join(parts)


def main():
    """Writes the page."""
    PAGE.write_text(page(), encoding="utf-8")
    print(PAGE)

