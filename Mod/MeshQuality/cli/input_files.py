# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the files of a job hold: shapes, objects, meshes, and what names in them mean."""

import re

import FreeCAD
import numpy as np

import MeshQuality as mq
from MeshQuality.cli.parser import MESH_SUFFIXES, POINT_SUFFIXES
from MeshQuality.compat import extension
from MeshQuality.core.sources import convert, hidden_parts

left_out = []  # sentences about what is hidden in the containers that the present job has read


def read_shape(path, name=None):
    """The shape of a CAD file; of an FCStd file that of one object, or of all final ones."""
    return read_shape_and_objects(path, name)[0]


def read_shape_and_objects(path, name=None):
    """The same, and the objects of an FCStd file that make it up; none of other files."""
    if not path.lower().endswith(".fcstd"):
        return _read_file(path, name), []
    objects = _read_objects(path, name)
    return _shape_of_objects(objects), objects


def read_analysis(path, name):
    """The Fem::FemAnalysis of an FCStd file with this name or label; without a name the only one."""
    document = FreeCAD.openDocument(path, True)
    found = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemAnalysis") and name in (None, obj.Name, obj.Label)]
    if len(found) != 1:
        raise mq.InvalidInput(f"'{path}' has {len(found)} analyses" + (f" {name}" if name else "") + ": choose one by --object")
    return found[0]


def size_field_in(objects, names):
    """size_field= of paths of files, and of names of Size regions in the document of the objects."""
    documents = {obj.Document for obj in objects}
    named = {name: next(filter(None, (document.getObject(name) for document in documents)), None) for name in names or ()}
    return [obj or name for name, obj in named.items()] or None


def _shape_of_objects(objects):
    import Part

    shapes = [convert.shape_of(obj) for obj in objects]
    return shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)


def read_operand(path, name=None):
    """What a Boolean takes of a file: a mesh, a shape, or the object of an FCStd file, with the meshes in it."""
    if path.lower().endswith(MESH_SUFFIXES):
        return read_mesh(path)
    if not path.lower().endswith(".fcstd"):
        return _read_file(path, name)
    objects = _read_objects(path, name, with_meshes=True)
    holding = [obj for obj in objects if convert.meshes_in(obj)]
    if len(objects) > 1 and holding:
        raise mq.InvalidInput(f"'{path}' has {len(objects)} objects with shapes, and {convert.label_of(holding[0])} holds "
                              "meshes, too: choose one object by --object")
    return objects[0] if len(objects) == 1 else _shape_of_objects(objects)


def _one_line(error):
    """What an error of FreeCAD says: some have ends of lines in them."""
    return " ".join(str(error).split())


def _read_file(path, name):
    import Part

    if name:
        raise mq.InvalidInput(f"--object is for FCStd files, not for '{path}'")
    try:
        shape = Part.read(path)
    except Exception as error:  # noqa: BLE001 - FreeCAD raises many types, some of them its own
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if shape.isNull():
        raise mq.InvalidInput(f"cannot read '{path}': it holds no shape")
    return shape


def _read_objects(path, name, with_meshes=False):
    """The object of this name or label in an FCStd file, or all final ones; `left_out` tells of what is hidden in them,
    meshes too where these count.
    """
    found = _objects_in(path, name)
    for obj in found:
        left_out.extend(hidden_parts.sentences_of(obj, with_meshes))
    return found


def _objects_in(path, name):
    try:
        document = FreeCAD.openDocument(path)
    except Exception as error:  # noqa: BLE001
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if name:
        found = [o for o in document.Objects if name in (o.Name, o.Label)][:1]
        if not found:
            raise mq.InvalidInput(f"'{path}' has no object named '{name}'")
        return found
    found = final_objects(document)
    if not found:
        raise mq.InvalidInput(f"'{path}' has no object with faces")
    return found


def final_objects(document):
    """Those objects with faces that no other object with faces is made of or holds.

    Meshes, drawings and analyses may refer to them all the same.
    """
    import Part

    shaped = []
    for obj in document.Objects:
        shape = Part.getShape(obj)
        if not shape.isNull() and shape.Faces and not obj.isDerivedFrom("App::OriginFeature"):
            shaped.append(obj)
    return [obj for obj in shaped if not any(user in shaped for user in obj.InListRecursive)]


def sizes_in(shape, objects, path, sizes):
    """Local sizes by the sub-elements of the shape that objects of a file make up.

    A name may begin with that of one of the objects, as if the file was a container, and goes on with the path
    from there as in Python: "Box.Face6", "Part.Box.Face6". With one object it may begin below that, too.
    """
    found = {}
    for name, size in (sizes or {}).items():
        plain = _name_in_file(shape, objects, path, name, "local_sizes names") if "." in name else name
        found[plain] = min(size, found.get(plain, size))
    return found or None


def patches_in(shape, objects, path, patches):
    """The same of patches: {name: faces}, or {name: {"faces": faces, ...}}. What is not so is left as it is, to be refused
    with all else.
    """
    def plain(name, face):
        return _name_in_file(shape, objects, path, face, f"patch {name!r} names") \
            if isinstance(face, str) and "." in face else face

    found = {}
    for name, said in (patches or {}).items():
        faces = said.get("faces") if isinstance(said, dict) else said
        if isinstance(faces, list):
            faces = [plain(name, face) for face in faces]
            said = {**said, "faces": faces} if isinstance(said, dict) else faces
        found[name] = said
    return found if patches is not None else None


def _name_in_file(shape, objects, path, name, said):
    if not objects:
        element = name.rpartition(".")[2]
        raise mq.InvalidInput(f"{said} {name}, but '{path}' has no objects with names, as FCStd files have: "
                              f"name the sub-element of the whole shape, such as {element}")
    first, rest = name.split(".", 1)
    owners = [obj for obj in objects if obj.Name == first] or [obj for obj in objects if obj.Label == first]
    if owners:
        plain = next(iter(convert.resolve_sizes(owners[0], {rest: 1.0})))
        return convert.name_in(shape, _element(owners[0], plain, f"{said} {name}"))
    if len(objects) == 1:
        return next(iter(convert.resolve_sizes(objects[0], {name: 1.0})))
    raise mq.InvalidInput(f"{said} {name}, but '{path}' has no '{first}' among the objects that are meshed: "
                          f"begin with one of {', '.join(obj.Name for obj in objects)}")


def _element(obj, plain, said):
    shape = convert.shape_of(obj)
    try:
        return shape.getElement(plain)
    except Exception as error:  # noqa: BLE001 - FreeCAD raises many types, some of them its own
        raise mq.InvalidInput(f"{said}, but {convert.label_of(obj)} has no {plain}") from error


def read_mesh(path):
    """The Mesh.Mesh of a mesh file."""
    import Mesh

    try:
        mesh = Mesh.Mesh(path)
    except Exception as error:  # noqa: BLE001
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if mesh.CountFacets == 0:
        raise mq.InvalidInput(f"cannot read '{path}': it holds no triangles")
    return mesh


def read_points(path):
    """What deviation takes of a file: the Mesh.Mesh of a mesh, or the float64 (N, 3) of a text with a point a line.

    Columns are apart by blanks, commas or semicolons; lines that do not begin with three numbers, such as heads, are left out.
    """
    if not path.lower().endswith(POINT_SUFFIXES):
        return read_mesh(path)
    number = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
    try:
        with open(path, encoding="latin-1") as stream:
            found = re.findall(rf"^[ \t]*({number})[ \t,;]+({number})[ \t,;]+({number})(?![\d.])", stream.read(), re.MULTILINE)
    except OSError as error:
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if not found:
        raise mq.InvalidInput(f"cannot read '{path}': it holds no points, which are lines of three numbers")
    return np.array(found, dtype=np.float64)


def mesh_of(mesh):
    """The SurfaceMesh of a Mesh.Mesh."""
    return mq.SurfaceMesh(convert.surface_of_arrays(extension(), *convert.arrays_of_mesh(mesh)))
