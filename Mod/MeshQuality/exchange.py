# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD calls for its File menu, and freecadcmd for files to convert: quality meshes by Export, meshes with their groups by
Import.

FreeCAD knows this module by the types of files that `register` names to it when it starts; nothing else is loaded then.
"""

import FreeCAD

from . import formats

_HERE = __name__
# For printing and viewing; the other formats of FORMATS that hold elements are for solvers.
_PRINTED = (".stl", ".3mf", ".obj", ".ply")
# What FreeCAD reads no groups of, or does not read at all.
_IMPORTED = (".cgns", ".e", ".exo", ".h5", ".inp", ".msh", ".msh2", ".nas", ".su2")


def register():
    """Names the types of files to FreeCAD, once: the addon may be installed twice."""
    if _HERE in FreeCAD.getExportType(_PRINTED[0][1:]):
        return
    for suffix in _PRINTED:
        FreeCAD.addExportType(f"Quality mesh (*{suffix})", _HERE)
    for suffix, form in formats.FORMATS.items():
        if form.curved:
            FreeCAD.addExportType(f"Quality mesh, {form.title} (*{suffix})", _HERE)
    FreeCAD.addImportType(f"FEM mesh with groups ({' '.join('*' + suffix for suffix in _IMPORTED)})", _HERE)


def export(objects, filename):
    """Writes quality meshes of document objects into one file, by the preferences, and their certificates into the Report view.

    objects   shapes, bodies, parts, links and assemblies, of which what is visible in them counts; meshes are written as they are
    filename  the extension says the format

    Raises what triangulate, curve and export_mesh raise, naming the object; then there is no file, or the older one.
    """
    from .features import file_export

    file_export.export(objects, filename)


def insert(filename, document):
    """Adds the mesh in a file, with its groups, as a FEM mesh to the document of a name, which is made where there is none;
    returns the object. Raises what read_mesh raises.
    """
    from .features import file_import

    known = document in FreeCAD.listDocuments()
    return file_import.add(filename, FreeCAD.getDocument(document) if known else FreeCAD.newDocument(document))


def open(filename):  # noqa: A001 - FreeCAD calls it so
    """The same in a new document, which it returns."""
    from .features import file_import

    return file_import.add(filename, FreeCAD.newDocument(file_import.name_of(filename))).Document
