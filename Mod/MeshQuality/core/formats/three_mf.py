# SPDX-License-Identifier: LGPL-2.1-or-later
"""3MF files: objects to print, each of one mesh or of several meshes as its components, with names and colours.

Source: 3MF Core Specification 1.3, chapters 3 and 4.
"""

import os
import shutil
import zipfile
from xml.sax.saxutils import escape

import numpy as np

from ... import files
from ..patches.patches import Patches, distinct_colour

_MODEL = "3D/3dmodel.model"
_PARTS = {
    "[Content_Types].xml":
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>\n',
    "_rels/.rels":
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
        f'<Relationship Target="/{_MODEL}" Id="rel0" '
        'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>\n',
}
_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n<model unit="{}" xml:lang="en-US" ' \
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n' \
        '<metadata name="Application">MeshQuality</metadata>\n<resources>\n'
_UNITS = {0.001: "meter", 0.1: "centimeter", 1 / 25.4: "inch"}  # by the factor from mm
_MATERIALS = 1  # the number of the resource, which the core writes into triangles
_FASTEST = 1  # zlib's level: a third of the usual time, for files a tenth larger


def write(path, items, scale):
    """Writes a container.

    items  [(name, [(name, SurfaceMesh, Patches), ...]), ...]: an object of one mesh, or of several as its components;
           names may be empty. Patches that were given are materials with name and colour.
    """
    model, mesh = path + ".model", path + ".mesh"
    try:
        with open(model, "wb") as out:
            _write_model(out, mesh, items, scale)
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=_FASTEST) as container:
            for name, text in _PARTS.items():
                container.writestr(name, text)
            container.write(model, _MODEL)
    finally:
        files.remove_if_there(model)
        files.remove_if_there(mesh)


def _write_model(out, piece, items, scale):
    """Writes the model; `piece` is the path of a file for one mesh at a time."""
    unit = next((unit for factor, unit in _UNITS.items() if abs(scale / factor - 1) < 1e-6), "millimeter")
    parts = [part for _, held in items for part in held]
    materials = _materials(patches for _, _, patches in parts if patches.given)
    out.write(_HEAD.format(unit).encode())
    if materials.names:
        bases = "".join(f'<base name="{_text(name)}" displaycolor="#{"%02X%02X%02X" % colour}"/>\n'
                        for name, colour in zip(materials.names, materials.colours))
        out.write(f'<basematerials id="{_MATERIALS}">\n{bases}</basematerials>\n'.encode())
    number, first, builds = _MATERIALS, 0, []
    for name, held in items:
        numbers = []
        for own_name, mesh, patches in held:
            number += 1
            numbers.append(number)
            material = f' pid="{_MATERIALS}" pindex="{first}"' if patches.given else ""
            out.write(f'<object id="{number}" type="model"{_name(own_name)}{material}>\n'.encode())
            mesh._write_core(os.fsencode(piece), "3mf",
                             materials._replace(of_triangle=patches.of_triangle + np.int32(first), given=patches.given)
                             if patches.given else patches, scale, False)
            with open(piece, "rb") as written:
                shutil.copyfileobj(written, out)
            out.write(b"</object>\n")
            first += len(patches.names) if patches.given else 0
        if len(numbers) > 1:
            number += 1
            components = "".join(f'<component objectid="{part}"/>\n' for part in numbers)
            out.write(f'<object id="{number}" type="model"{_name(name)}>\n<components>\n{components}</components>\n'
                      '</object>\n'.encode())
        builds.append(number)
    built = "".join(f'<item objectid="{number}"/>\n' for number in builds)
    out.write(f"</resources>\n<build>\n{built}</build>\n</model>\n".encode())


def _materials(all_patches):
    """The Patches of a whole file: all names and colours one after the other."""
    names, colours = [], []
    for patches in all_patches:
        colours += [colour or distinct_colour(len(names) + i) for i, colour in enumerate(patches.colours)]
        names += patches.names
    return Patches(tuple(names), tuple(colours), np.zeros(0, dtype=np.int32), True, None)


def _name(text):
    return f' name="{_text(text)}"' if text else ""


def _text(text):
    return escape(text, {'"': "&quot;"})
