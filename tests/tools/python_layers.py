# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of Mod/MeshQuality: which there are, which others each may import, and that no modules import each
other in a circle, be it inside functions. Each check returns a list of sentences, one a fault.
"""

import ast

PACKAGE = "MeshQuality"
# By layer the layers below that it may import, itself apart; a layer names earlier ones only.
MAY_IMPORT = {
    "foundation": [],
    "core": ["foundation"],
    "features": ["foundation", "core"],
    "scripts": ["foundation", "features"],
    "gui": ["foundation", "core", "features"],
    "cli": ["foundation", "core", "scripts"],
    "batch": ["foundation", "cli"],
    "program": ["foundation", "cli", "batch"],
}
# By module, or package with all below it, its layer. `scripts` is the package itself, as `import MeshQuality` has it.
LAYER = {
    **dict.fromkeys(["charts", "html_page", "errors", "version", "listing", "compat", "files", "formats", "limits", "scratch", "options", "error_phrases",
                     "fault_phrases", "flow_phrases", "label_phrases", "note_phrases", "report_phrases", "solid_phrases", "element_names", "phrases", "stage_names"], "foundation"),
    "core": "core",
    "features": "features",
    "": "scripts",
    "exchange": "scripts",  # what FreeCAD calls
    "gui": "gui",
    "cli": "cli",
    "cli.main": "program",  # what is run: single jobs, and batches, which are built on them
    "batch": "batch",
    "__main__": "program",
}
# The folders and modules of `core` in rows, low to high: each imports lower rows, and itself.
CORE = [
    ["brep", "colour_scale", "sources"],
    ["elements", "patches"],
    ["formats"],
    ["meshes"],
    ["sizes"],
    ["places"],
    ["stretching"],
    ["triangulation", "improvement", "simplification", "quality", "fem"],
    ["curved", "certify", "following"],
    ["operands", "verify"],
    ["booleans", "curving", "inspect"],
    ["adapting", "measures", "mesh_to_solid", "offsetting", "repair", "sectioning", "solid_expression", "wrapping"],
    ["machining", "volumes"],
    ["reporting"],
]


def layer_of(module):
    """The layer of a module named below the package, such as "gui.words"; None where none is declared."""
    return LAYER.get(module) or LAYER.get(module.partition(".")[0])


def modules(root):
    """{name below the package: path} of all modules; the package itself is ""."""
    package = root / "Mod" / PACKAGE
    found = {}
    for path in sorted(package.rglob("*.py")):
        parts = path.relative_to(package).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports(root):
    """{module: [(line, imported module, imported name or None)]} of what modules of the package import of it."""
    known = modules(root)
    found = {}
    for module, path in known.items():
        home = module if path.name == "__init__.py" else module.rpartition(".")[0]
        tree = ast.parse(path.read_text(encoding="utf-8"))
        found[module] = [target for node in ast.walk(tree) for target in _targets(node, home, known)]
    return found


def _targets(node, home, known):
    if isinstance(node, ast.Import):
        for alias in node.names:
            if alias.name.split(".")[0] == PACKAGE:
                yield node.lineno, alias.name.partition(".")[2], None
    elif isinstance(node, ast.ImportFrom):
        base = _base(node, home)
        for alias in node.names if base is not None else []:
            below = f"{base}.{alias.name}".lstrip(".")
            yield (node.lineno, below, None) if below in known else (node.lineno, base, alias.name)


def _base(node, home):
    """The module of the package after `from`, None of another package."""
    if node.level == 0:
        first, _, rest = node.module.partition(".")
        return rest if first == PACKAGE else None
    around = home.split(".") if home else []
    around = around[:len(around) - node.level + 1]
    return ".".join([*around, *([node.module] if node.module else [])])


def check_layers(root):
    """Every module has a layer; it imports its own layer, and those that this may import."""
    faults = []
    for module, targets in imports(root).items():
        layer = layer_of(module)
        if layer is None:
            faults.append(f"{PACKAGE}.{module} has no layer in tests/tools/python_layers.py")
            continue
        for line, target in dict.fromkeys((line, target) for line, target, _ in targets):
            if layer_of(target) not in (layer, *MAY_IMPORT[layer]):
                faults.append(f"{_named(module)}:{line}: {layer} may not import {_named(target)}")
    return faults


def check_declared(_root):
    """The layers are declared from low to high."""
    order = list(MAY_IMPORT)
    return [f"{layer} may not import {below}, which is not below it" for layer, allowed in MAY_IMPORT.items()
            for below in allowed if order.index(below) >= order.index(layer)]


def check_core(root):
    """Within core, imports go to lower rows."""
    row = {name: number for number, names in enumerate(CORE) for name in names}
    faults = []
    for module, targets in imports(root).items():
        home = _part_of_core(module)
        for line, target in dict.fromkeys((line, target) for line, target, _ in targets if home):
            other = _part_of_core(target)
            if other and other != home and row.get(other, len(CORE)) >= row.get(home, -1):
                faults.append(f"{_named(module)}:{line}: core.{home} may not import {_named(target)}")
    return faults


def _part_of_core(module):
    """The folder or module of core that a module belongs to; "" of others."""
    first, _, rest = module.partition(".")
    return rest.partition(".")[0] if first == "core" else ""


def check_circles(root):
    """No module imports itself by way of others."""
    below = {module: {target for _, target, _ in targets} - {module} for module, targets in imports(root).items()}
    return [f"{' -> '.join(map(_named, circle))} is a circle" for circle in _circles(below)]


def _circles(below):
    """One circle through each module that is in one, each circle once, as lists that end where they begin."""
    seen = set()
    for start in sorted(below):
        way = _way_back(below, start)
        if way and not seen.intersection(way):
            seen.update(way)
            yield way


def _way_back(below, start):
    """The shortest way from a module back to itself, None where there is none."""
    ways, met = [[start]], set()
    for way in ways:
        for target in sorted(below.get(way[-1], ())):
            if target == start:
                return [*way, start]
            if target not in met:
                met.add(target)
                ways.append([*way, target])
    return None


def check_private_names(root):
    """What begins with an underscore is a module's own."""
    return [f"{_named(module)}:{line}: {name} is private to {_named(target)}"
            for module, targets in imports(root).items() for line, target, name in targets
            if name and name.startswith("_") and not name.startswith("__") and target in modules(root)]


def _named(module):
    return f"{PACKAGE}.{module}".rstrip(".")


CHECKS = [check_declared, check_layers, check_core, check_circles, check_private_names]
