# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Solid": the CAD solid of a mesh of the document, with the exact surfaces that the mesh was made of."""

import json
from dataclasses import replace

import FreeCAD

from .. import phrases, solid_phrases
from ..compat import property_of
from ..core.brep.construction import Construction
from ..core.mesh_to_solid import to_solid
from ..core.operands.operands import Operands
from ..core.sources import convert, frames
from ..errors import InvalidInput
from ..phrases import Text
from . import boolean, export, hollow, offset, quality_mesh
from .gui_hooks import window
from .mesh_shape import MeshShape
from .properties import add_property, options_of

_READ_ONLY = (
    ("ExactFaces", "App::PropertyInteger", "Number of its faces on exact surfaces of the CAD; either this or FacetCount is 0"),
    ("FacetCount", "App::PropertyInteger", "Number of its faces that are planar facets of the mesh"),
    ("Deviation", "App::PropertyLength", "The largest distance of the mesh from the solid, measured at points"),
    ("DeviationBack", "App::PropertyLength", "The largest distance of the solid from the mesh, measured at points"),
    ("AllowedDeviation", "App::PropertyLength", "Both are at most this"),
    ("SolidVolume", "App::PropertyVolume", "Volume of the solid"),
    ("MeshVolume", "App::PropertyVolume", "Volume of the mesh"),
    ("Notes", "App::PropertyStringList", "Why it has facets, where it has"),
)
_ready = {}  # key_of and facets -> the MeshSolid that the window has made already


class SolidOfMesh(MeshShape):
    """Proxy of a Part::FeaturePython that holds the solid of its Source's mesh, and follows it."""

    NAME, TITLE, WORD = "Solid", "To solid", "solid"

    def __init__(self, obj):
        super().__init__(obj)
        if add_property(obj, "App::PropertyBool", "Facets", "Mesh",
                        "The solid has planar facets where exact surfaces do not close; off: it is refused then"):
            obj.Facets = True
        for name, kind, text in _READ_ONLY:
            add_property(obj, kind, name, "Quality", text)
            obj.setEditorMode(name, 1)

    def make_shape(self, obj, source):
        """Gives the object the solid, and how that was checked."""
        found = _ready.pop((frames.key_of(source), obj.Facets), None) or maker_of(source, obj.Facets)(None)
        obj.Shape, obj.ExactFaces, obj.FacetCount = found.shape, found.faces, found.facets
        obj.Deviation, obj.DeviationBack, obj.AllowedDeviation = found.deviation, found.deviation_back, found.tolerance
        obj.SolidVolume, obj.MeshVolume, obj.Notes = found.volume, found.mesh_volume, list(map(str, found.notes))
        window().show_solid(obj)
        FreeCAD.Console.PrintMessage(f"{obj.Label}: {' '.join(map(window().translated, sentences_of(found)))}\n")


def sentences_of(solid):
    """[Text, ...]: what was made of a mesh, and how it was checked."""
    made = phrases.counted(solid_phrases.EXACT, solid.faces) if solid.faces else \
        phrases.counted(solid_phrases.FACETS, solid.facets, phrase=solid.notes[0])
    return [made, Text(solid_phrases.DISTANCES, length=f"{max(solid.deviation, solid.deviation_back):.3g} mm", length2=f"{solid.tolerance:.3g} mm",
                       volume=f"{solid.volume:.6g} mm³", volume2=f"{solid.mesh_volume:.6g} mm³")]


def maker_of(source, facets=True):
    """make(progress) -> the MeshSolid of the mesh of a document object as it is now; any thread may call it. Raises InvalidInput
    for another object, and one that is out of date.
    """
    if not frames.is_object(source) or not convert.is_mesh(source):
        raise InvalidInput(Text(solid_phrases.NO_MESH_OBJECT, name=convert.label_of(source)))
    holder = frames.linked_of(source)[0]
    if _is_ours(holder) and export.is_outdated(holder):
        raise InvalidInput(Text(solid_phrases.OUTDATED, name=holder.Label))
    construction, motion = _construction_of(holder), _motion_from(holder, source)
    if construction is None or motion is None:
        make, construction, motion = export.flat_maker_of(source), None, FreeCAD.Placement()
    else:
        make = export.flat_maker_of(holder)

    def made(progress):
        mesh = make()
        mesh._construction = construction
        solid = to_solid(mesh, facets, progress)
        if frames.is_identity(motion):
            return solid
        shape = solid.shape.copy()
        shape.transformShape(motion.toMatrix(), True)
        return replace(solid, shape=shape)

    return made


def _motion_from(holder, source):
    """The placement that moves a mesh from its own place to that of a source, a link to it; None where the link is scaled or an array."""
    if getattr(frames.leaf_of(source), "ElementCount", 0):
        return None
    try:
        return frames.relative_motion(frames.placement_of(holder), frames.placement_of(source))
    except InvalidInput:  # scaled
        return None


def _is_ours(obj):
    return isinstance(getattr(obj, "Proxy", None), (quality_mesh.QualityMesh, offset.SolidMesh, boolean.MeshBoolean))


def _construction_of(source):
    """The Construction of the mesh of a document object; None where that is not known, and of a link, which stands elsewhere."""
    obj = frames.linked_of(source)[0]
    kind = type(getattr(obj, "Proxy", None))
    if obj != source or kind not in (quality_mesh.QualityMesh, offset.OffsetObject, hollow.HollowObject, boolean.MeshBoolean) \
            or obj.Proxy.lacks_source(obj):
        return None
    values, sources = options_of(obj, obj.Proxy.OPTIONS), obj.Proxy.sources(obj)
    bound = "MaxChordHeight" if kind is quality_mesh.QualityMesh else "ErrorBound"
    own = property_of(obj, bound).Value
    known = tuple(_source_of_construction(each) for each in sources)
    if kind is offset.OffsetObject:
        return Construction(known, values["distance"], None, own)
    if kind is hollow.HollowObject:
        faces = json.loads(obj.OpeningFaces)["names"] if obj.OpeningFaces else []
        openings = tuple(sorted(int(name[4:]) - 1 for name in convert.resolve_sizes(sources[0], dict.fromkeys(faces, 1.0)) or ()))
        return Construction(known, -values["thickness"], openings, own)
    return Construction(known, own=own)


def _source_of_construction(source):
    """What a Construction takes of a source: its shape, or the Construction of its mesh."""
    if convert.is_mesh(source):
        return _construction_of(source)
    operands = Operands([source])
    return operands.plain(0) if operands.is_shape(0) else None


def remember(source, facets, solid):
    """Keeps what maker_of made of an object for the add_solid that follows; returns what forgets it if it was not taken."""
    key = frames.key_of(source), facets
    _ready[key] = solid
    return lambda: _ready.pop(key, None)


def add_solid(obj, facets=True):
    """Adds the CAD solid of a mesh of the document, which follows that; one undo step.

    obj     document object with a closed mesh. Of add_quality_mesh, add_offset, add_hollow and add_boolean the solid has the exact
            surfaces of the shapes that these were made of, and of offsets of them
    facets  True: where exact surfaces do not close, the solid has planar facets, as of any other mesh; False: it is refused

    The properties ExactFaces, FacetCount, Deviation, DeviationBack, AllowedDeviation and Notes say what was made and how it was checked,
    see to_solid. Returns the object. Raises what to_solid raises, InvalidInput for another object and one that is out of date, and then
    adds nothing.
    """
    if not frames.is_object(obj):
        raise InvalidInput(Text(solid_phrases.NO_MESH_OBJECT, name=convert.label_of(obj)))
    return SolidOfMesh.add(obj, Facets=bool(facets))
