# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formats of files that meshes are written in: one table for Python, the command line and its help. Imports nothing
of FreeCAD.
"""

import re
from typing import NamedTuple

from .errors import InvalidInput

WORD = r"""[^\s"'`/\\;:,{}()\[\]<>$|=*#%]+"""
HIGHEST_ORDER = 5


class Names(NamedTuple):
    """What names of patches a format can hold: a pattern of the whole name with what it says in words, the greatest
    length, whether names that differ in case only are one, what is put behind a name for another one, and names that the
    format gives to something else.
    """

    pattern: str = r"[^\x00-\x1f\x7f]+"
    words: str = "no control characters"
    longest: int = 127
    folded: bool = False
    more: str = ""
    reserved: tuple = ()


class Format(NamedTuple):
    """A format. `curved` is the highest order of the elements of curved meshes in it; 0: it holds flat triangles alone.
    `text` says whether there is a text form to choose beside the binary one, `volumes` whether it holds volumes alone.
    """

    title: str
    curved: int = 0
    names: Names = None
    text: bool = False
    solids: bool = False
    volumes: bool = False


_ONE_WORD = Names(WORD, "no blanks, quotes or brackets")
_QUOTED = Names(r'[^"\x00-\x1f\x7f]+', "no double quotes")
_ABAQUS = Names(r"[A-Za-z][A-Za-z0-9_.\-]*", "a letter first, then letters, digits, _ - and . alone", 72, True, "_surface")

# Names that the standard (CGNS/SIDS) gives to what lies beside families and sections, and that of our zone.
_CGNS = Names(r"(?!\.{1,2}$)[^/\x00-\x1f\x7f]+", "no slashes, and are not dots alone", 32, reserved=(
    "ArbitraryGridMotion", "Axisymmetry", "BaseIterativeData", "ConvergenceHistory", "DataClass", "DimensionalUnits",
    "DiscreteData", "FamilyName", "FlowEquationSet", "FlowSolution", "GlobalConvergenceHistory", "Gravity",
    "GridCoordinates", "Ordinal", "ReferenceState", "RigidGridMotion", "RotatingCoordinates", "SimulationType", "Zone1",
    "ZoneBC", "ZoneConvergenceHistory", "ZoneGridConnectivity", "ZoneIterativeData", "ZoneType"))

# By extension as it is written; it is told from others in lower case.
FORMATS = {
    ".stl": Format("STL", text=True),
    ".ply": Format("PLY"),
    ".obj": Format("Wavefront OBJ", names=_ONE_WORD),
    ".off": Format("OFF"),
    ".msh": Format("Gmsh 4.1", HIGHEST_ORDER, _QUOTED),
    ".msh2": Format("Gmsh 2.2", HIGHEST_ORDER, _QUOTED),
    ".vtu": Format("VTK unstructured grid", HIGHEST_ORDER),
    ".su2": Format("SU2", 1, _ONE_WORD),
    ".cgns": Format("CGNS", 4, _CGNS, solids=True),
    ".mesh": Format("MFEM", HIGHEST_ORDER, Names()),
    ".xml": Format("Nektar++", HIGHEST_ORDER, Names(), solids=True),
    ".inp": Format("Abaqus and CalculiX", 2, _ABAQUS, solids=True),
    ".unv": Format("I-DEAS universal file", 2, Names(r"(?!\s*-1\s*$)[^\x00-\x1f\x7f]+", "no control characters, and are not -1", 40),
                   solids=True),
    ".nas": Format("Nastran bulk data", 2, Names(longest=40), solids=True),
    ".bdf": Format("Nastran bulk data", 2, Names(longest=40), solids=True),
    ".exo": Format("Exodus II", 2, Names(longest=32), solids=True),
    ".h5": Format("HOPR", 4, Names(longest=255), volumes=True),
    ".tri": Format("Cart3D"),
    ".eMesh": Format("edges for OpenFOAM"),
    ".fms": Format("surface for cfMesh", names=_ONE_WORD),
    ".3mf": Format("3MF for printing", names=Names()),
    ".amf": Format("AMF for printing"),
}
SUFFIXES = tuple(suffix for suffix, form in FORMATS.items() if not form.volumes)
CURVED_SUFFIXES = tuple(suffix for suffix, form in FORMATS.items() if form.curved)
FLAT_ONLY_SUFFIXES = tuple(suffix for suffix, form in FORMATS.items() if not form.curved)
# By extension that files of elements are read from: what errors call the format, and the module of core/formats.
READABLE = {
    ".msh": ("a file of Gmsh", "gmsh"),
    ".msh2": ("a file of Gmsh", "gmsh"),
    ".inp": ("a file of Abaqus", "abaqus"),
    ".unv": ("an I-DEAS universal file", "universal"),
    ".vtu": ("a VTK unstructured grid", "vtu"),
    ".vtk": ("a legacy file of VTK", "vtk"),
    ".med": ("a file of Salome", "med"),
    ".cgns": ("a CGNS file", "cgns"),
    ".su2": ("a file of SU2", "su2"),
    ".nas": ("Nastran bulk data", "nastran"),
    ".bdf": ("Nastran bulk data", "nastran"),
    ".exo": ("an Exodus file", "exodus"),
    ".e": ("an Exodus file", "exodus"),
    ".h5": ("a file of HOPR", "hopr"),
}
# Extensions of files for elements of all kinds.
ELEMENTS_WRITTEN = (".msh", ".vtu", ".inp", ".unv", ".nas", ".bdf", ".su2", ".cgns", ".mesh", ".h5", ".re2")
# Formats that are not in FORMATS, as no mesh that this package makes has their elements.
ELEMENTS_ONLY = {".re2": Format("Nek5000")}
_TEXT_ONLY = Format("STL as text", names=_ONE_WORD)


def title_of(suffix):
    """The name of a format."""
    return (FORMATS.get(suffix) or ELEMENTS_ONLY[suffix]).title


def known_suffix(text, known=SUFFIXES):
    """The extension of the table that a text is in any case; None where none is."""
    return next((suffix for suffix in known if suffix.lower() == text.lower()), None)


def check_order(suffix, order):
    """Raises InvalidInput where a format does not hold curved elements of an order."""
    most = FORMATS[suffix].curved
    if order > most:
        others = " ".join(other for other, form in FORMATS.items() if form.curved >= order)
        orders = {1: "1", 2: "1 and 2"}.get(most, f"1 to {most}")
        held = f"elements of order {orders}" if most else "flat triangles alone"
        raise InvalidInput(f"{suffix} files hold {held}, not elements of order {order}: choose one of {others}")


def check_text(suffix):
    """Raises InvalidInput where a format has no text form to choose."""
    if not FORMATS[suffix].text:
        raise InvalidInput(f"{suffix} files have no other form as text: leave ascii out, which is for "
                           + " ".join(other for other, form in FORMATS.items() if form.text))


def check_names(suffix, names, solids=(), ascii=False):  # noqa: A002 - the option is called so
    """Raises InvalidInput naming a patch that a format cannot hold by its name, and the remedy."""
    form = _TEXT_ONLY if ascii else FORMATS.get(suffix) or ELEMENTS_ONLY[suffix]
    rule, taken = form.names, {name: f"solid {name}" for name in solids} if form.solids else {}
    if rule is None:
        return
    if rule.folded:
        taken = {name.casefold(): said for name, said in taken.items()}
    if rule.more:
        taken.update({(name + rule.more).casefold(): f"the surface of patch {name}" for name in names})
    for name in names:
        if not re.fullmatch(rule.pattern, name):
            plain = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_")
            plain = plain if re.fullmatch(rule.pattern, plain) else f"patch_{plain}"
            raise InvalidInput(f"{suffix} files cannot hold a patch called {name!r}: names there have {rule.words}; "
                               f"call it {plain!r}, for example")
        if name in rule.reserved:
            raise InvalidInput(f"{suffix} files cannot hold a patch called {name!r}: the format gives this name to "
                               f"something else; call it {'patch_' + name!r}, for example")
        if len(name.encode()) > rule.longest:
            from . import phrases  # not above: FreeCAD loads this module when it starts

            raise InvalidInput(phrases.Text(phrases.FILE_PATCH_TOO_LONG, value=suffix, name=repr(name),
                                            count=str(rule.longest)))
        key = name.casefold() if rule.folded else name
        if key in taken:
            raise InvalidInput(f"{suffix} files cannot tell patch {name!r} from {taken[key]}: give one of them another "
                               "name")
        taken[key] = f"patch {name}"
