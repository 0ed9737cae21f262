# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folders of src/ are stages: which there are, which way includes may go between them, how many files each
holds, and that tests/cpp mirrors them. Each check returns a list of sentences, one a fault.
"""

import re
from collections import Counter
from pathlib import Path

# By module the folders below it in rows, low to high: a folder may include those of lower rows, and itself.
STAGES = {
    "base": [["base/system"], ["base/memory", "base/threads"], ["base"], ["base/sizes"]],
    "geometry": [
        ["geometry"],
        ["geometry/elementary"],
        ["geometry/analytic", "geometry/occt/evaluation"],
        ["geometry/occt/topology"],
        ["geometry/occt/narrow"],
        ["geometry/occt/checks", "geometry/occt/stream"],
        ["geometry/occt/distance"],
        ["geometry/occt"],
    ],
    "mesh": [["mesh"], ["mesh/io", "mesh/intersection"], ["mesh/quality", "mesh/proof"]],
    "triangulate": [
        ["triangulate/edges", "triangulate/work_mesh"],
        ["triangulate/initial", "triangulate/components", "triangulate/rounds"],
        ["triangulate/measure", "triangulate/operators", "triangulate/spacing"],
        ["triangulate/front"],
        ["triangulate/sampling"],
        ["triangulate/refine", "triangulate/optimise", "triangulate/virtual_topology", "triangulate/incremental",
         "triangulate/report"],
        ["triangulate/pipeline"],
        ["triangulate"],
    ],
    "boolean": [
        ["boolean/input", "boolean/exact"],
        ["boolean/arrangement"],
        ["boolean/near_coincidence"],
        ["boolean/extraction"],
        ["boolean/rounding"],
        ["boolean"],
    ],
    "layered_depth": [["layered_depth/samples"], ["layered_depth/reconstruction"], ["layered_depth"]],
    "elements": [["elements/bezier"], ["elements/product"]],
    "tetrahedralise": [["tetrahedralise/cells"], ["tetrahedralise"]],
    "curve": [["curve/surface"], ["curve/volume"], ["curve/volume/remeshing"], ["curve/output"], ["curve/injectivity"], ["curve"]],
    "given": [["given/matching"], ["given/simplices"], ["given/mixed"]],
    "improve": [["improve"]],
    "inspection": [["inspection"]],
    "contour": [["contour"]],
    "offset": [["offset/trimmed"], ["offset/contoured"]],
    "wrap": [["wrap/lattice"], ["wrap/outside"], ["wrap/surface"], ["wrap/measure"], ["wrap"]],
    "workflows": [["workflows/operands"], ["workflows"]],
    "python": [["python/freecad"], ["python"], ["python/sizes"]],
}
MAX_FILES = 24  # of C++ in a folder of src: about ten pairs of header and source
FILES = {".h", ".cpp", ".i"}
# Pairs of header and source, with an algorithm. This share of them has a test of its own, tests/cpp/PAIR_test.cpp.
LEAST_TESTED = 0.6


def _rank():
    return {folder: row for rows in STAGES.values() for row, folders in enumerate(rows) for folder in folders}


def _cpp_files(root):
    return sorted(path.relative_to(root / "src") for path in (root / "src").rglob("*") if path.suffix in FILES)


def check_folders(root):
    """Every folder is a stage that is declared, and holds no more files than a reader can survey."""
    faults, rank = [], _rank()
    for folder, count in sorted(Counter(path.parent.as_posix() for path in _cpp_files(root)).items()):
        if folder not in rank:
            faults.append(f"src/{folder} is no stage of tests/tools/stages.py")
        if count > MAX_FILES:
            faults.append(f"src/{folder} has {count} files, more than {MAX_FILES}")
    return faults


def check_stage_includes(root):
    """Includes within a module go to lower rows of its stages."""
    faults, rank = [], _rank()
    for path in _cpp_files(root):
        folder = path.parent.as_posix()
        for number, line in enumerate((root / "src" / path).read_text(encoding="utf-8").splitlines(), 1):
            found = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
            other = Path(found[1]).parent.as_posix() if found else folder
            if other == folder or other.split("/")[0] != folder.split("/")[0]:
                continue
            if rank.get(other, 99) >= rank.get(folder, -1):
                faults.append(f"src/{path}:{number}: {folder} may not include {found[1]}")
    return faults


def check_tests_mirror(root):
    """A test named after a pair of src lies in the folder of that pair."""
    pairs = {}
    for path in _cpp_files(root):
        pairs.setdefault((path.parts[0], path.stem), set()).add(path.parent.as_posix())
    faults = []
    for path in sorted((root / "tests" / "cpp").rglob("*_test.cpp")):
        relative = path.relative_to(root / "tests" / "cpp")
        homes = pairs.get((relative.parts[0], path.name.removesuffix("_test.cpp")), set())
        if homes and relative.parent.as_posix() not in homes:
            faults.append(f"tests/cpp/{relative} belongs to tests/cpp/{min(homes)}")
    return faults


def check_tested(root):
    """Enough pairs with an algorithm have a test of their name."""
    pairs = {path.with_suffix("").as_posix() for path in _cpp_files(root) if path.suffix == ".cpp"}
    pairs = {pair for pair in pairs if (root / "src" / f"{pair}.h").exists() and not pair.startswith("python")}
    tested = [pair for pair in pairs if (root / "tests" / "cpp" / f"{pair}_test.cpp").exists()]
    share = len(tested) / max(len(pairs), 1)
    return [] if share >= LEAST_TESTED else [
        f"{len(tested)} of {len(pairs)} pairs have a test of their name, less than {LEAST_TESTED:.0%}"]


CHECKS = [check_folders, check_stage_includes, check_tests_mirror, check_tested]
