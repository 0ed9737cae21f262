# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a header declares what its name says: one word of the name begins like a word of a name that it declares."""

import re
from pathlib import Path

# Headers of several operations, which no single one of them names.
SEVERAL = {
    "base/system/system.h", "geometry/occt/evaluation/conversion.h", "improve/local_operations.h", "mesh/io/io.h",
    "mesh/io/io_formats.h", "python/bindings.h",
}
DECLARED = re.compile(r"\b(?:class|struct|enum|using|concept|define)\s+(?:class\s+)?([A-Za-z_]\w*)|\b([a-z_]\w*)\s*\(|"
                      r"\bconstexpr\s+[\w:<>]+\s+(\w+)|^(?:\w+::)*(?:shared_ptr<)?([A-Z]\w+)", re.M)
ALIKE = 4  # letters: "simplification" declares simplify


def words(name):
    return [word for word in re.split(r"[_\d]+", re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()) if word]


def declared(text):
    """The names in a header, and the types that its functions give."""
    text = re.sub(r"//.*", "", text).replace("std::shared_ptr<", "")
    return {name for found in DECLARED.findall(text) for name in found if name}


def says(header, names):
    """Whether a word of the header's name begins like one of the names'."""
    own = {word[:ALIKE] for word in words(header) if word not in ("of", "in", "the", "to", "and", "by")}
    return any(word[:ALIKE] in own for name in names for word in words(name))


def check(root):
    """['file: fault', ...]"""
    source = Path(root) / "src"
    faults = []
    for path in sorted(source.rglob("*.h")):
        at = path.relative_to(source).as_posix()
        if at not in SEVERAL and not says(path.stem, declared(path.read_text(encoding="utf-8"))):
            faults.append(f"src/{at}: declares no name like its own")
    return faults
