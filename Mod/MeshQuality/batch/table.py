# SPDX-License-Identifier: LGPL-2.1-or-later
"""parts.csv: the lines of parts.jsonl as a table; parts.parquet too, where pyarrow is."""

import csv
import importlib.util

from .atomic_file import replacing

NAME, PARQUET = "parts.csv", "parts.parquet"
FIRST = ("part", "state", "error", "attempts", "seconds", "peak_mib", "size", "output", "host",
         "digest")


def row_of(entry):
    """The single values of an entry and of its report; of lists their length, of a box its sides."""
    row = {name: entry.get(name) for name in FIRST}
    for name, value in entry.get("report", {}).items():
        if name == "box":
            sides = [high - low for low, high in zip(*value)] if value else [None] * 3
            row.update(zip(("size_x", "size_y", "size_z"), sides))
        elif not isinstance(value, (list, dict)):
            row[f"report_{name}" if name in FIRST else name] = value
    return row


def write(plan, ledger):
    """Writes the table, parts in the order of their names."""
    names = dict.fromkeys(FIRST)
    for entry in ledger.entries():
        names.update(dict.fromkeys(row_of(entry)))
    path = plan.out / NAME
    with replacing(path, encoding="utf-8", errors="surrogateescape", newline="") as stream:
        writer = csv.DictWriter(stream, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(row_of(entry) for entry in ledger.sorted_entries())
    if importlib.util.find_spec("pyarrow"):
        _write_parquet(path, plan.out / PARQUET)


def _write_parquet(table, path):
    from pyarrow import csv as arrow_csv
    from pyarrow import parquet

    parquet.write_table(arrow_csv.read_csv(table), path)
