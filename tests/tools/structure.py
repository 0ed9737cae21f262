# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of the house rules on a source tree; each returns a list of sentences, one a fault.

The arrows between the modules are read from the root's CMakeLists.txt, their one place. ROWS gives
the direction in which they may run: a module may use those of lower rows only.
"""

import ast
import re
from pathlib import Path

ROWS = [
    ["base"],
    ["geometry"],
    ["mesh", "tetrahedralise"],
    ["elements"],
    ["triangulate", "curve", "boolean", "improve", "inspection", "contour"],
    ["layered_depth", "given", "offset", "wrap"],
    ["workflows"],
    ["python"],
]
RANK = {module: rank for rank, row in enumerate(ROWS) for module in row}
RANK["occt"] = RANK["geometry"]

FOLDERS = ["src", "tests", "tools", "benchmarks", "Mod", "bin", "docs", "packaging",
           ".ci"]
ROOT_FILES = ["Init.py", "InitGui.py", "CMakeLists.txt"]
CPP = {".h", ".cpp"}
MAX_FILE, MAX_FUNCTION = 600, 60
SPDX = "SPDX-License-Identifier: LGPL-2.1-or-later"

FREECAD_AT = ("Mod/", "Init.py", "InitGui.py", "tests/", "tools/", "benchmarks/", "docs/")
FREECAD_MODULES = {"FreeCAD", "FreeCADGui", "Part", "Mesh", "MeshPart", "Fem", "Import"}
OPENCASCADE = re.compile(
    r"\.(hxx|lxx)$"
)
OF_A_SYSTEM = r"(arpa|linux|mach|net|netinet|sys)/.*|(aclapi|dirent|dlfcn|fcntl|grp|io|malloc|poll|process|pthread|pwd|sched|signal|unistd|win\w*)\.h"
# Words that must not appear, spelt in two halves so that this file passes its own check.
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|X" r"XX)\b")


def source_files(root):
    """All source files of the tree that people write, as paths relative to it."""
    found = [Path(name) for name in ROOT_FILES if (root / name).exists()]
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts and _is_source(path):
                found.append(path.relative_to(root))
    return found


def _is_source(path):
    if path.suffix in CPP | {".py", ".i", ".cmake", ".sh"} or path.name == "CMakeLists.txt":
        return True
    if path.suffix:
        return False
    with open(path, "rb") as stream:
        return stream.read(2) == b"#!"


def _read(root, path):
    return (root / path).read_text(encoding="utf-8")


def _module(path):
    """The module of a file below src/: its folder; geometry/occt counts as a module of its own."""
    parts = path.parts
    if parts[0] != "src" or len(parts) < 3:
        return None
    return "occt" if parts[1:3] == ("geometry", "occt") else parts[1]


def links(root):
    """Module -> the modules that CMakeLists.txt links it to."""
    text = re.sub(r"#.*", "", _read(root, Path("CMakeLists.txt")))
    direct = {}
    for call in re.finditer(r"\bmq_module\((\w+)([^)]*)\)", text):
        direct.setdefault(call[1], set()).update(re.findall(r"\bmq_(\w+)", call[2]))
    for call in re.finditer(r"\btarget_link_libraries\(mq_(\w+)([^)]*)\)", text):
        direct.setdefault(call[1], set()).update(re.findall(r"\bmq_(\w+)", call[2]))
    return {module: others - {"flags"} for module, others in direct.items()}


def arrows(root):
    """Module -> the modules it may include, itself too: the links followed through."""
    direct, reach = links(root), {}
    for module in direct:
        seen, queue = {module}, [module]
        while queue:
            new = direct.get(queue.pop(), set()) - seen
            seen |= new
            queue += new
        reach[module] = seen
    reach["python"] = set(RANK)
    return reach


def check_arrows(root):
    """The arrows that CMakeLists.txt draws point down."""
    faults = []
    for module, below in arrows(root).items():
        for other in sorted(below - {module}):
            down = RANK.get(other, 99) < RANK.get(module, 99)
            if module != "python" and not down and (module, other) != ("occt", "geometry"):
                faults.append(f"CMakeLists.txt: mq_{module} may not use mq_{other}")
    return faults


def check_includes(root):
    """Every include of src/ follows an arrow, and each foreign library is met in its one place."""
    reach, faults = arrows(root), []
    for path in source_files(root):
        module = _module(path)
        if module is None or path.suffix not in CPP | {".i"}:
            continue
        for line, name in _includes(_read(root, path)):
            target = _module(Path("src") / name) if (root / "src" / name).exists() else None
            if target and target not in reach.get(module, {module}):
                faults.append(f"{path}:{line}: {module} may not include {name}")
            elif target is None:
                place = "system" if path.parts[2:3] == ("system",) else module
                faults += [f"{path}:{line}: {fault}" for fault in _foreign(place, name)]
    return faults


def _includes(text):
    for line, content in enumerate(text.splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', content)
        if match:
            yield line, match[1]


def _foreign(module, name):
    homes = [
        ("OpenCASCADE", OPENCASCADE.search(name), {"occt", "python"}),
        ("pybind11 and Python", re.match(r"pybind11/|Python\.h$|numpy/", name), {"python"}),
        ("SWIG", "swig" in name.lower(), {"python"}),
        ("Coin", re.match(r"Inventor/", name), set()),
        ("FreeCAD", re.match(r"(App|Base|Gui|Mod)/", name), set()),
        ("headers of an operating system", re.fullmatch(OF_A_SYSTEM, name), {"system"}),
    ]
    return [f"{module} may not include {library} ({name})" for library, hit, home in homes
            if hit and module not in home]


def check_namespaces(root):
    """Code of src/ is in the namespace of its module, of `base` in mq; of other modules it may declare types, no more."""
    faults = []
    for path in source_files(root):
        module = _module(path)
        if module is None or path.suffix not in CPP:
            continue
        own = {"base": "mq", "occt": "mq::geometry"}.get(module, f"mq::{module}")
        text = _read(root, path)
        for found in re.finditer(r"^namespace (mq[\w:]*) \{\n(.*?)^\}", text, re.MULTILINE | re.DOTALL):
            if found[1] != own and not re.fullmatch(r"((class|struct) \w+;|\s)*", found[2]):
                faults.append(f"{path}:{text.count(chr(10), 0, found.start()) + 1}: code of {module} is in {own}, not in {found[1]}")
    return faults


def check_python_imports(root):
    """FreeCAD is imported only where it may be; Qt only in the GUI parts."""
    faults = []
    for path in source_files(root):
        if path.suffix != ".py":
            continue
        for line, name in _imports(_read(root, path)):
            if name in FREECAD_MODULES and not path.as_posix().startswith(FREECAD_AT):
                faults.append(f"{path}:{line}: {name} may not be imported here")
            is_gui = "gui" in path.stem or "gui" in path.parts or path.parts[0] == "tests"
            if name.startswith("PySide") and not is_gui:
                faults.append(f"{path}:{line}: Qt may be imported in gui/ and init_gui.py only")
    return faults


def _imports(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name.split(".")[0]
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.lineno, node.module.split(".")[0]


def check_texts(root):
    """Licence line, length, unfinished work, and what must not be said in src/."""
    faults = []
    for path in source_files(root):
        text = _read(root, path)
        lines = text.splitlines()
        if lines and SPDX not in "\n".join(lines[:4]):
            faults.append(f"{path}: no line '{SPDX}'")
        if len(lines) > MAX_FILE:
            faults.append(f"{path}: {len(lines)} lines, more than {MAX_FILE}")
        for number, line in enumerate(lines, 1):
            if UNFINISHED.search(line):
                faults.append(f"{path}:{number}: unfinished work is not committed")
        if path.suffix in CPP:
            faults += _check_cpp_text(path, strip_cpp(text))
    return faults


def _check_cpp_text(path, code):
    """A catch-all must hand the exception on; nothing is printed in src/."""
    hits = [
        (match.start(), "catch (...) that does not hand the exception on")
        for match in re.finditer(r"\bcatch\s*\(\s*\.\.\.\s*\)\s*\{([^}]*)", code)
        if not re.search(r"\bthrow;|\bstd::current_exception\(", match[1])
    ]
    if path.parts[0] == "src":
        printing = r"\bstd::(cout|cerr|clog)\b|\b(f?printf|puts|putchar)\s*\("
        hits += [(match.start(), "src/ prints nothing") for match in re.finditer(printing, code)]
    return [f"{path}:{code.count(chr(10), 0, at) + 1}: {why}" for at, why in hits]


def check_functions(root):
    """No function over MAX_FUNCTION lines."""
    faults = []
    for path in source_files(root):
        text = _read(root, path)
        if path.suffix in CPP:
            functions = cpp_functions(text)
        elif path.suffix == ".py":
            functions = python_functions(text)
        else:
            continue
        for name, line, length in functions:
            if length > MAX_FUNCTION:
                faults.append(f"{path}:{line}: {name} has {length} lines, more than {MAX_FUNCTION}")
    return faults


def python_functions(text):
    """(name, first line, lines) of every function."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name, node.lineno, node.end_lineno - node.lineno + 1


def strip_cpp(text):
    """The text with comments, strings and directives blanked; lines and columns stay."""
    pattern = re.compile(
        r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\""
        r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'"
        r"|^[ \t]*#(?:\\\n|[^\n])*",
        re.DOTALL | re.MULTILINE,
    )
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def cpp_functions(text):
    """(name, first line, lines) of every function body that is not inside another one."""
    code, stack, start = strip_cpp(text), [], 0
    for match in re.finditer(r"[{};]|\b(?:public|private|protected)\s*:", code):
        at, kinds = match.start(), [kind for kind, _, _ in stack]
        if match[0] == "{":
            head = code[start:at].strip()
            nested = "brace" if "brace" in kinds else "block" if "function" in kinds else None
            first = start + len(code[start:at]) - len(code[start:at].lstrip())
            stack.append((nested or _scope_kind(head), head, first))
        elif match[0] == "}" and stack:
            kind, head, first = stack.pop()
            if kind == "function":
                line = code.count("\n", 0, first) + 1
                yield _name(head), line, code.count("\n", 0, at) + 2 - line
            if kind == "brace":
                continue
        if not stack or stack[-1][0] != "brace":
            start = match.end()


def _scope_kind(head):
    """What a brace after this text opens: declarations, a function or an initialiser."""
    if re.match(r"(inline\s+)?namespace\b|extern\s*$", head):
        return "scope"
    plain = re.sub(r"^template\s*<.*?>\s*(?=class|struct|union)", "", head, flags=re.DOTALL)
    is_type = re.match(r"(class|struct|union|enum)\b", plain)
    if is_type and not re.search(r"\)\s*(const)?$", plain):
        return "scope"
    in_list = re.search(r"\)\s*(noexcept\s*)?:[^:]", head) and re.search(r"[\w>]$", head)
    if "(" not in head or head.endswith(("=", ",")) or in_list:
        return "brace"
    return "function"


def _name(head):
    match = re.search(r"([\w:~]+|operator\S+)\s*\(", head)
    return match[1] if match else "a function"


CHECKS = [check_arrows, check_includes, check_namespaces, check_python_imports, check_texts, check_functions]
