#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a first build takes: the processor's time, user and system, for compiling a sample of the files.

    benchmarks/batch/build_time.py [--every 10] [--flags=-O1 ...] [--folder build]

Every Nth file of compile_commands.json in the build folder is compiled as it is and with each of the --flags at its end, in
turn, without ccache and to /dev/null. By group (libraries, bindings, tests, fuzz targets) it prints the number of files, the
seconds of the sample, and what that makes for all of its files; linking is left out. The time that other programs take does
not count, but they make caches colder: compare figures of one run only.
"""

import argparse
import json
import resource
import shlex
import subprocess
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def group_of(path):
    """What a file belongs to."""
    name = path.relative_to(ROOT).as_posix()
    if "/fuzz/" in name:
        return "fuzz targets"
    return "tests" if name.startswith("tests") else "bindings" if "python" in name else "libraries"


def command_of(entry):
    """The compiler's command without ccache, to /dev/null."""
    words = shlex.split(entry["command"])
    words = words[next((i + 1 for i, word in enumerate(words) if word.endswith("ccache")), 0):]
    words[words.index("-o") + 1] = "/dev/null"
    return words


def seconds_of(command, folder):
    """The processor's time of a command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, check=True, stdin=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    """Compiles and prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every", type=int, default=10, help="compile every Nth file")
    parser.add_argument("--flags", action="append", default=[], help="flags at the end of the command; may be repeated")
    parser.add_argument("--folder", default="build", help="build folder that was configured")
    given = parser.parse_args()
    groups = defaultdict(list)
    for entry in json.loads((ROOT / given.folder / "compile_commands.json").read_text(encoding="utf-8")):
        groups[group_of(Path(entry["file"]))].append(entry)
    variants = ["", *given.flags]
    print("group", "files", "sample", *(f"s, all{' ' + flags if flags else ''}" for flags in variants), sep="\t")
    for group, entries in groups.items():
        sample = sorted(entries, key=lambda entry: entry["file"])[given.every // 2::given.every]
        spent = [0.0] * len(variants)
        for entry in sample:
            for i, flags in enumerate(variants):
                spent[i] += seconds_of([*command_of(entry), *shlex.split(flags)], entry["directory"])
        estimates = (f"{total * len(entries) / max(len(sample), 1):.0f}" for total in spent)
        print(group, len(entries), len(sample), *estimates, sep="\t", flush=True)


if __name__ == "__main__":
    main()
