# SPDX-License-Identifier: LGPL-2.1-or-later
"""Benchmarks in C++ that tables of the papers come from."""

import subprocess
import sys
from pathlib import Path

import inside_freecad


def add_option(parser, name):
    """--program, by default the benchmark of this name in build/."""
    parser.add_argument("--program", default=str(inside_freecad.ROOT / "build" / "benchmarks" / name))


def output(program, *options):
    """What the program prints. Ends with how it is built where it is not there."""
    path = Path(program)
    if not path.exists():
        print(f"{path} is not there: cmake -B build -DMESHQUALITY_BENCHMARKS=ON && ninja -C build {path.name}", file=sys.stderr)
        sys.exit(2)
    return subprocess.run([str(path), *options], check=True, capture_output=True, text=True).stdout
