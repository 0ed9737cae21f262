# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes and meshes of FreeCAD in and out: what scripts may pass, and what the core works on."""

import contextlib
import io
import mmap
import os
import tempfile
from functools import cached_property

import FreeCAD
import numpy as np

from ... import phrases
from ...compat import attribute_of, extension
from ...errors import InvalidInput, IoError
from ...phrases import Text
from . import frames
from .repeated_parts import each_once

_MANY = 5000  # numbers that take longer than a millisecond
_NOT_SAID = -1  # by isElementVisible: the object itself says whether it is visible
_BMS_HEAD = 264  # magic, version and comment; then two counts, points, facets and the box


def shape_text(shape):
    """BREP text of a Part.Shape, as bytes: the same after saving and loading, and after showing it."""
    return extension().brep_text(shape)


def label_of(source):
    """How messages name a shape or a document object."""
    obj, path = frames.object_of(source), frames.path_of(source)
    label = getattr(obj, "Label", None)
    if path.endswith("."):
        leaf = obj.getSubObject(path, retType=1)
        label = f"{leaf.Label if leaf is not None else path.rstrip('.')} in {label}"
    return f"'{label}'" if label else "the shape"


def file_name(path):
    """The name of a file to write, as bytes; it need not be UTF-8.

    Raises InvalidInput for what is no path, IoError for a name that no file can have.
    """
    try:
        name = os.fsencode(path)
    except (TypeError, UnicodeError) as error:
        raise InvalidInput(f"the name of a file is needed, not {path!r}: give a text or a path") from error
    if b"\0" in name:
        raise IoError(f"{path!r} has a NUL character, which no name of a file can have: take it out")
    return name


def shape_of(source):
    """The Part.Shape of a Part.Shape, a document object or (document object, "Face3"), where the
    document has it: objects inside of containers are moved with these. A container gives a compound
    of what it holds.

    Raises InvalidInput when there are no faces.
    """
    shape = own_shape_of(source)
    if isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        frame = frames.frame_of(source)
        if not frames.is_identity(frame):
            shape.transformShape(frame.toMatrix(), False)
    return shape


def taken(shape):
    """The same Part.Shape, which the core takes as it is now: on FreeCAD's thread, before work on another one."""
    extension().take(shape)
    return shape


def own_shape_of(source):
    """The same with the placement of the object alone, not that of its containers."""
    import Part

    obj, path = frames.object_of(source), frames.path_of(source)
    if isinstance(obj, Part.Shape):
        shape = obj.getElement(path) if path else obj
    elif isinstance(obj, FreeCAD.DocumentObject):
        named = bool(path) and not path.endswith(".")
        shape = Part.getShape(obj, path, needSubElement=named)
        if not (named or shape.isNull()) and frames.leaf_of(source).getLinkedObject(True).hasExtension("App::GroupExtension"):
            shape = each_once(shape)
    else:
        raise InvalidInput("a Part.Shape or a document object with a shape is needed, not "
                           f"{type(source).__name__}")
    if shape.isNull():
        raise InvalidInput(Text(_null_phrase(source), name=label_of(source)))
    if not shape.Faces:
        raise InvalidInput(Text(phrases.NO_FACES, name=label_of(source), name2=shape.ShapeType))
    return shape


def has_faces(source):
    """Whether shape_of gives a shape."""
    try:
        return bool(own_shape_of(source).Faces)
    except InvalidInput:
        return False


def size_of(source):
    """The largest dimension in mm of what shape_of gives; 0 where that is nothing."""
    try:
        box = attribute_of(shape_of(source), "BoundBox")
    except InvalidInput:
        return 0.0
    return max(box.XLength, box.YLength, box.ZLength)


def _null_phrase(source):
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        return phrases.IS_NULL
    is_container = frames.leaf_of(source).hasExtension("App::GroupExtension")
    return phrases.IS_NULL_HIDDEN if is_container else phrases.IS_NULL_RECOMPUTE


def is_mesh(candidate):
    """True for a Mesh.Mesh and for a document object that holds one, or a path to such an object."""
    import Mesh

    if isinstance(frames.object_of(candidate), FreeCAD.DocumentObject):
        candidate = frames.leaf_of(candidate)
    return isinstance(getattr(candidate, "Mesh", candidate), Mesh.Mesh)


def meshes_in(source):
    """The sources of all meshes that are visible in a container, or a link to one, and in what that holds; none of what
    has a shape of its own, such as a body.
    """
    found = {}
    for mesh in _visible_meshes(source):
        linked, matrix = frames.linked_of(mesh)
        if linked.Mesh.CountFacets:
            # What lies in a plain group is listed by the container around that, too.
            found.setdefault((linked, matrix.A), mesh)
    return list(found.values())


def _visible_meshes(source):
    leaf = frames.leaf_of(source)
    if is_mesh(source) or "Shape" in leaf.getLinkedObject(True).PropertiesList:
        return
    for name, part in frames.held_by(source):
        if is_visible(leaf, name):
            if is_mesh(part):
                yield part
            else:
                yield from _visible_meshes(part)


def is_visible(container, name):
    """Whether a container shows what it holds by this name, which ends with a full stop."""
    said = container.isElementVisible(name[:-1])
    return container.getSubObject(name, retType=1).Visibility if said == _NOT_SAID else said


def arrays_of_mesh(mesh):
    """(vertices float64 (V, 3), triangles int32 (T, 3)) of a Mesh.Mesh, a Mesh feature or a link.

    Coordinates include the mesh's placement and those of its containers.
    """
    return MeshCopy(mesh).arrays


class MeshCopy:
    """A Mesh.Mesh, a Mesh feature, a link or the meshes in a container as they are now, for work on another thread."""

    def __init__(self, source):
        self._parts = [(mesh.copy(), matrix) for mesh, matrix in _meshes_and_matrices(source)]
        self._frame = None
        if isinstance(frames.object_of(source), FreeCAD.DocumentObject):
            frame = frames.frame_of(source)
            self._frame = None if frames.is_identity(frame) else frame.toMatrix()

    @cached_property
    def own_arrays(self):
        """What `arrays` gives with the placement of the mesh alone; one thread at a time may ask."""
        arrays = [_arrays(mesh, matrix) for mesh, matrix in self._parts]
        self._parts = None
        if len(arrays) == 1:
            return arrays[0]
        starts = np.cumsum([0, *(len(vertices) for vertices, _ in arrays)])
        return (np.concatenate([vertices for vertices, _ in arrays]),
                np.concatenate([triangles + start for (_, triangles), start in zip(arrays, starts)]).astype(np.int32))

    @cached_property
    def arrays(self):
        """What arrays_of_mesh gives; one thread at a time may ask for it."""
        vertices, triangles = self.own_arrays
        return (vertices if self._frame is None else _moved(vertices, self._frame)), triangles


def _arrays(mesh, matrix):
    data = extension().bms_of_mesh(mesh)
    if data is None:
        data = _bms_by_file(mesh)
    points, facets = (int(n) for n in np.frombuffer(data, "<u4", 2, _BMS_HEAD))
    start = _BMS_HEAD + 8
    vertices = np.frombuffer(data, "<f4", 3 * points, start).astype(np.float64).reshape(-1, 3)
    columns = np.frombuffer(data, "<u4", 6 * facets, start + 12 * points).reshape(-1, 6)
    if matrix != FreeCAD.Matrix():
        vertices = _moved(vertices, matrix)
    return vertices, columns[:, :3].astype(np.int32)


def moved(points, placement):
    """float64 (N, 3): the points where a placement puts them; themselves where it moves nothing."""
    return points if frames.is_identity(placement) else _moved(points, placement.toMatrix())


def _moved(points, matrix):
    matrix = np.array(matrix.A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _bms_by_file(mesh):
    """The mesh in FreeCAD's binary format, written by its Python function."""
    handle, path = tempfile.mkstemp(suffix=".bms")
    os.close(handle)
    try:
        # A file, because writing this format into a stream loses its beginning in FreeCAD 0.20.
        mesh.write(Filename=path, Format="BMS")
        with open(path, "rb") as stream:
            return stream.read()
    finally:
        os.unlink(path)


def _meshes_and_matrices(source):
    """[(Mesh.Mesh, the matrix of its own placement), ...] of a mesh or a document object: one of each, or
    one for each element of a link array, or for each mesh in a container.
    """
    obj, path = frames.object_of(source), frames.path_of(source)
    if not isinstance(obj, FreeCAD.DocumentObject):
        return [(source, attribute_of(source, "Placement").toMatrix())]
    leaf = frames.leaf_of(source)
    if getattr(leaf, "ElementCount", 0):
        elements = [name for name in leaf.getSubObjects() if name.endswith(".")]
        return [found for name in elements for found in _meshes_and_matrices((obj, path + name))]
    if not is_mesh(source):
        return [found for mesh in meshes_in(source) for found in _meshes_and_matrices(mesh)]
    linked, matrix = frames.linked_of(source)
    return [(linked.Mesh, matrix)]


def surface_of_arrays(module, vertices, triangles, measured=True):
    """A Surface of the core module, of (V, 3) numbers and (T, 3) indices; raises InvalidInput."""
    vertices = _plain_array(vertices, "vertices", "numbers", "iuf")
    triangles = _plain_array(triangles, "triangles", "whole numbers", "iu")
    return module.surface_from_arrays(vertices.astype(np.float64, copy=False),
                                    triangles.astype(np.int64, copy=False), measured=measured)


def _plain_array(given, name, wanted, kinds):
    """An array of one of these kinds of dtype. NumPy would make numbers of texts and of the real parts of
    complex numbers, and forget which numbers are masked.
    """
    try:
        array = np.asanyarray(given)
    except (TypeError, ValueError, OverflowError) as error:
        raise InvalidInput(f"a mesh as arrays needs (V, 3) numbers and (T, 3) indices: {error}") \
            from error
    if np.ma.isMaskedArray(array):
        if np.ma.is_masked(array):
            raise InvalidInput(f"{name} is an array with masked numbers: take these out")
        array = array.data
    array = np.asarray(array)
    if array.size and array.dtype.kind not in kinds:
        raise InvalidInput(f"{name} must be {wanted}, not {array.dtype}")
    if not array.size:
        return np.zeros(array.shape)
    _require_whole_file(array, name)
    return array


def _require_whole_file(array, name):
    """Raises InvalidInput where the array lies on a file that has got shorter since it was mapped: to read it would
    end the process.
    """
    offset = 0
    while array is not None and not isinstance(array, mmap.mmap):
        offset = getattr(array, "offset", 0) or offset
        array = array.obj if isinstance(array, memoryview) else getattr(array, "base", None)
    if array is None:
        return
    with contextlib.suppress(OSError, ValueError):  # no file, or closed
        if array.size() < offset - offset % mmap.ALLOCATIONGRANULARITY + len(array):
            raise InvalidInput(f"{name} lies on a file that is shorter than when it was mapped: read the file again")


def mesh_of_surface(surface):
    """A Mesh.Mesh with the same triangles in the same order, one segment a CAD face."""
    import Mesh

    mesh = Mesh.Mesh()
    if not extension().fill_mesh(mesh, surface):
        fill_by_python(mesh, surface)
    if np.any(surface.origin):
        mesh.Placement = FreeCAD.Placement(FreeCAD.Vector(*surface.origin), FreeCAD.Rotation())
    return mesh


def fill_by_python(mesh, surface):
    """Fills an empty Mesh.Mesh by FreeCAD's Python functions."""
    mesh.read(Stream=_Stream(surface.to_bms()), Format="BMS")
    add_segments(mesh, face_segments(surface.triangle_face))


def add_segments(mesh, segments):
    """Adds index arrays of triangles as segments of a Mesh.Mesh."""
    for triangles in segments:
        mesh.addSegment(_Numbers(triangles) if len(triangles) > _MANY else triangles.tolist())


# These Python functions of FreeCAD keep Python's lock, which stops the window for as long when they
# are called in the background. Functions of ours that they call meanwhile, often enough, let Python
# hand the lock over; a single large segment still takes long.


class _Stream:
    """A stream of bytes."""

    def __init__(self, content):
        self._content = io.BytesIO(content)

    def read(self, size=-1):
        return self._content.read(size)


class _Numbers:
    """A sequence of whole numbers."""

    def __init__(self, numbers):
        self._numbers = numbers.tolist()

    def __len__(self):
        return len(self._numbers)

    def __getitem__(self, i):
        return self._numbers[i]


def face_segments(triangle_face):
    """The triangles of each CAD face, faces in ascending order, as index arrays."""
    if triangle_face.size == 0:
        return []
    order = np.argsort(triangle_face, kind="stable")
    borders = np.flatnonzero(np.diff(triangle_face[order])) + 1
    return np.split(order, borders)


def lists(array):
    """array.tolist(), by parts, as NumPy keeps Python's lock while it makes one."""
    if len(array) <= _MANY:
        return array.tolist()
    made = []
    for start in range(0, len(array), _MANY):
        made += array[start:start + _MANY].tolist()
    return made


def resolve_sizes(source, sizes):
    """{"Face12": 0.5} of {"Box.Face6": 0.5}: sizes by the sub-elements of the shape of `source`, where a
    name begins with the path from the container or link `source` to the object that has the sub-element.

    None without any. Raises InvalidInput naming what the source does not hold.
    """
    if not sizes:
        return None
    found = {}
    for name, size in sizes.items():
        plain = _sub_element_of(source, name) if "." in name else name
        # Two names may mean one sub-element: both bounds hold.
        found[plain] = min(size, found.get(plain, size))
    return found


def with_resolved_sizes(source, values):
    """Checked options of an operation on `source`, local sizes by the sub-elements of its shape."""
    if not values.get("local_sizes"):
        return values
    return {**values, "local_sizes": resolve_sizes(source, values["local_sizes"])}


def _sub_element_of(source, name):
    """The sub-element "Face12" of the shape of `source` that "Box.Face6" is."""
    import Part

    path, element = name.rsplit(".", 1)
    obj, path = frames.object_of(source), f"{frames.path_of(source)}{path}."
    kind = element.rstrip("0123456789")
    wanted = None
    if isinstance(obj, FreeCAD.DocumentObject) and obj.getSubObject(path, retType=1):
        held = _elements(Part.getShape(obj, path), kind)
        index = int(element[len(kind):]) - 1
        wanted = held[index] if index < len(held) else None
    found = None if wanted is None else name_in(own_shape_of(source), wanted)
    if found is None:
        raise InvalidInput(Text(phrases.NO_SUCH_ELEMENT, value=name, name=label_of(source)))
    return found


def name_in(whole, wanted):
    """The name "Face12" of a sub-element in a shape that has it, or a copy of it; else None."""
    return ElementFinder(whole, wanted.ShapeType).name_of(wanted)


class ElementFinder:
    """Finds many sub-elements of one kind, "Face", "Edge" or "Vertex", in a shape that has them, or copies of them."""

    def __init__(self, whole, kind):
        self._kind, self._elements = kind, _elements(whole, kind)
        self._near = 1e-6 * max(whole.BoundBox.DiagonalLength, 1.0)
        self._middles = np.array([_middle(element) for element in self._elements], dtype=float).reshape(-1, 3)

    def name_of(self, wanted):
        """The name "Face12"; None where the shape does not have it."""
        close = (np.abs(self._middles - np.array(_middle(wanted))) <= self._near).all(axis=1)
        there = [i for i in np.flatnonzero(close).tolist() if _same_place(wanted, self._elements[i], self._near)]
        # Neighbours may touch in a face or an edge. Bodies have copies of what their features have.
        own = [i for i in there if wanted.isPartner(self._elements[i])]
        return f"{self._kind}{(own or there)[0] + 1}" if there else None


def _middle(element):
    return element.Point if element.ShapeType == "Vertex" else element.CenterOfMass


def _elements(shape, kind):
    return {"Face": shape.Faces, "Edge": shape.Edges, "Vertex": shape.Vertexes}[kind]


def _same_place(one, other, near):
    """Whether two sub-elements have the same vertices and the same centre."""
    points = [[vertex.Point for vertex in element.Vertexes] +
              ([element.CenterOfMass] if element.ShapeType != "Vertex" else [])
              for element in (one, other)]
    return len(points[0]) == len(points[1]) \
        and all((a - b).Length <= near for a, b in zip(*points))
