# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repeats a table or figure of one of the four papers; without a name, lists them.

    /usr/bin/python3 benchmarks/papers [NAME [options]]

Each is a module of this folder, with its options under --help. docs/papers has what came out.
"""

import ast
import runpy
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def names():
    """{name: first line of the module's docstring} of all that can be repeated."""
    found = {}
    for path in sorted(HERE.glob("[a-z]*.py")):
        text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))
        found[path.stem.replace("_", "-")] = text.partition("\n")[0]
    return found


def main():
    known = names()
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        for name, text in known.items():
            print(f"{name:<30} {text}")
        return 0
    name = sys.argv[1]
    if name not in known:
        print(f"'{name}' is not a table or figure that can be repeated: name one of {', '.join(known)}", file=sys.stderr)
        return 2
    script = HERE / f"{name.replace('-', '_')}.py"
    sys.argv = [str(script), *sys.argv[2:]]
    sys.path += map(str, [HERE.parent, *HERE.parent.iterdir()])
    runpy.run_path(str(script), run_name="__main__")
    return 0


if __name__ == "__main__":
    sys.exit(main())
