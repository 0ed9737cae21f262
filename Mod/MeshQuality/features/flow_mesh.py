# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Flow mesh": layers of prisms on walls and tetrahedra inside that follow a part of the document."""

from functools import partial

import FreeCAD
import numpy as np

from .. import flow_phrases, options, phrases, solid_phrases
from ..core.certify import verdict
from ..core.elements import kinds
from ..core.elements.assembly import Content
from ..core.fem import fem
from ..core.meshes.element_mesh import ElementMesh
from ..core.patches.patches import Patches, division_of
from ..core.sources import convert, frames
from ..core.volumes import volume_mesh as volumes
from ..core.volumes.far_field import FAR_NAMES
from ..core.volumes.volume_report import percent
from ..errors import GeometryError, InvalidInput
from . import fem_groups, fem_mesh, mesh_object, properties, transactions
from .chosen_faces import ChosenFaces, Said
from .gui_hooks import window
from .patches import give_patches
from .recompute_work import Work

_MEASURED = (
    ("Elements", "App::PropertyInteger", "Number of volume elements"),
    ("Kinds", "App::PropertyStringList", "Kinds of elements, and the number of each", "elements"),
    ("NodeCount", "App::PropertyInteger", "Number of nodes", "nodes"),
    ("Covered", "App::PropertyFloat", "Share of the area of the walls with all layers", "covered"),
    ("FullHeight", "App::PropertyFloat", "Share of it with layers at least 0.95 times as high as asked for", "full_height"),
    ("Coverage", "App::PropertyStringList", "For each wall the share of its area with all layers, and the height of the first one"),
    ("MinScaledJacobian", "App::PropertyFloat", "Least scaled Jacobian of prisms and tetrahedra", "min_scaled_jacobian"),
    ("MaxNonOrthogonality", "App::PropertyAngle", "Largest angle between a face and the line through the centres beside it",
     "max_non_orthogonality"),
    ("MaxSkewness", "App::PropertyFloat", "Largest skewness of a face, as OpenFOAM measures it", "max_skewness"),
    ("MaxDeviation", "App::PropertyLength", "Max. deviation of the surface from the part", "chord_height"),
    ("MeshVolume", "App::PropertyVolume", "Volume of the mesh", "volume"),
    ("MinDistortion", "App::PropertyFloat", "Smallest min J / max |J| of an element, proven", "min_distortion"),
    ("Straightened", "App::PropertyStringList", "Elements that bend less than the part, or not at all, to be valid", "straightened"),
    properties.NOTES,
)
_WALL_FACES = ("WallFaces", "App::PropertyString", "What the faces of the source were like when the walls were last right")
_GROUPS = ("GivenGroups", "App::PropertyStringList", "Groups of the mesh that are of no face of the part: the fluid and the far field")
_PYRAMIDS = ("Pyramids", "App::PropertyIntegerList", "Numbers of the nodes of pyramids, which FreeCAD's files do not hold")
_SAID = Said(flow_phrases.WALL_LOST, flow_phrases.WALL_ELSEWHERE, flow_phrases.NO_WALL)
_PYRAMIDS_OF = {1: 5, 2: 13}  # nodes, by order
_NAMED = 8  # walls that a sentence names


class FlowMeshObject(fem_mesh.FemMeshObject):
    """Proxy of a Fem::FemMeshObjectPython that holds a volume mesh for flow solvers.

    After an edit of the source the walls are found again, as the faces of patches are. Patches are groups of the mesh.
    """

    COMMAND, CALL = "MeshQuality_FlowMesh", "add_flow_mesh"
    OPTIONS, PRESETS = options.volume.FLOW, options.volume.FLOW_PRESETS
    MEASURED, PROMISES = _MEASURED, (properties.DEVIATION,)
    HIDDEN = (*fem_mesh.FemMeshObject.HIDDEN, _WALL_FACES, _GROUPS, _PYRAMIDS)

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """The Work of filling the region of the source."""
        mesh_object.require_source(sources, obj)
        values = options.check(cls.OPTIONS, values)
        shape = convert.taken(convert.own_shape_of(sources[0]))
        walls = ChosenFaces(sources[0], values["walls"], obj.WallFaces if obj is not None else "", _SAID)
        found = {**convert.with_resolved_sizes(sources[0], values), "walls": walls.faces}
        work = Work(sources, values, partial(mesh_object.fingerprint_of, shape, found), partial(cls.compute, shape, found, walls=walls))
        work.resolved = found
        return work

    @classmethod
    def compute(cls, shape, values, progress, walls):
        """The fem_mesh.Result."""
        mesh = volumes.volume_mesh(shape, **arguments_of(values), progress=progress)
        if not volumes.valid_without_middles(mesh):
            raise GeometryError(phrases.Text(flow_phrases.NEEDS_MIDDLES))
        return fem_mesh.Result(fem.elements_of_mesh(mesh), _Proof(mesh, walls))

    def require_patch_names(self, names):
        """As in the base class; nor may they be called as the fluid or a face of a far field."""
        super().require_patch_names(names)
        wrong = next((name for name in names if name in (volumes.REGION, *FAR_NAMES)), None)
        if wrong is not None:
            raise InvalidInput(phrases.Text(phrases.PATCH_LIKE_GROUP, name=repr(wrong)))

    def take(self, obj, result):
        """As in the base class; which groups are none of the part's faces has to be known before patches become groups."""
        obj.GivenGroups = [name for name, _, _ in result.elements.groups if not fem_groups.is_of_shape(name)]
        obj.Pyramids = [node for kind, _, rows in result.elements.blocks if kind == "Volume" for nodes in rows
                        if len(nodes) in _PYRAMIDS_OF.values() for node in nodes]
        return super().take(obj, result)

    def told(self, obj):
        """The coverage of the walls, and of each where it is not all."""
        if not obj.Fingerprint:
            return super().told(obj)
        covered = phrases.Text(flow_phrases.COVERED, number=percent(obj.Covered), number2=percent(obj.FullHeight))
        beside = super().told(obj)
        return covered if beside is None else phrases.Text("{list}", list=[covered, beside])

    def onDocumentRestored(self, obj):
        """As in the base class; the mesh gets its pyramids back."""
        super().onDocumentRestored(obj)
        missing, width = obj.Elements - obj.FemMesh.VolumeCount, _PYRAMIDS_OF.get(obj.Order)
        if not missing or missing * width != len(obj.Pyramids):
            return
        mesh = obj.FemMesh.copy()
        numbers = [mesh.addVolume(list(obj.Pyramids[i:i + width])) for i in range(0, len(obj.Pyramids), width)]
        group = next(group for group in mesh.Groups if mesh.getGroupElementType(group) == "Volume")
        mesh.addGroupElements(group, numbers)
        obj.FemMesh = mesh
        obj.purgeTouched()


class _Proof:
    """The report of a VolumeMesh, its certificate, and the ChosenFaces of its walls."""

    def __init__(self, mesh, walls):
        self.report, self._walls = mesh.report, walls
        self.findings = _findings_of(mesh)

    def show(self, obj):
        """Fills the groups Quality and Certificate."""
        properties.show_report(obj, obj.Proxy.MEASURED, self.report)
        obj.Elements = sum(self.report.elements.values())
        obj.Coverage = [_line_of(wall) for wall in self.report.walls]
        obj.Walls, obj.WallFaces = self._walls.names or [], self._walls.described
        obj.Notes = [*obj.Notes, *self._walls.lost]
        for sentence in self._walls.lost:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(sentence)}\n")
        mesh_object.show_certificate(obj, _Sound, True, self.findings)


class _Sound:
    """What volume_mesh has checked of all of its meshes."""

    closed = manifold = True


def _findings_of(mesh):
    """The finding that layers do not cover all walls, with the largest triangle without."""
    bare = [wall for wall in mesh.report.walls if wall.covered < 1.0]
    if not bare:
        return []
    listed = [phrases.Text(flow_phrases.ON_WALL, face=wall.face, number=percent(wall.covered)) for wall in bare]
    names = [wall.face for wall in bare]
    return [verdict.Finding(phrases.counted_sentence(flow_phrases.NOT_COVERED, len(bare), list=phrases.first_of(listed, _NAMED)),
                            tuple(name for name in names if fem_groups.is_of_shape(name)), _largest_bare(mesh, names))]


def _largest_bare(mesh, names):
    """The corners of the largest triangle on walls of these names that no prism stands on; () where none is known."""
    bottoms = set(map(tuple, np.sort(mesh.prisms[mesh.prism_layer == 0][:, :3], axis=1).tolist()))
    free = np.array([tuple(key) not in bottoms for key in np.sort(mesh.sides[0], axis=1).tolist()], dtype=bool)
    walls = [int(name[4:]) - 1 for name in names if fem_groups.is_of_shape(name)]
    corners = mesh.nodes[mesh.sides[0][free & np.isin(mesh.triangle_face, walls)]]
    if not len(corners):
        return ()
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return tuple(map(tuple, corners[areas.argmax()].tolist()))


def _line_of(wall):
    if not wall.covered:
        return f"{wall.face}: 0 %"
    return f"{wall.face}: {percent(wall.covered)} %, {percent(wall.full_height)} % as high as asked for, first layer at least {wall.least_height:.4g} mm"


def arguments_of(values):
    """The options of volume_mesh for checked ones of an object, walls as indices."""
    given = dict(values)
    distance, symmetry, place = given.pop("far_distance"), given.pop("symmetry"), given.pop("symmetry_at")
    given["walls"] = None if values["walls"] is None else [f"Face{i + 1}" for i in values["walls"]]
    if values["far_field"] == options.volume.NONE:
        return {**given, "far_field": None, "far_edge": None}
    return {**given, "far_field": f"{values['far_field']}:{distance!r}",
            "symmetry": None if symmetry == options.volume.NONE else f"{symmetry}{place!r}"}


def is_flow_mesh(obj):
    """Whether a document object holds a volume mesh of add_flow_mesh."""
    return isinstance(getattr(obj, "Proxy", None), FlowMeshObject) and bool(obj.Fingerprint) and obj.FemMesh.VolumeCount > 0


def volume_mesh_of(source):
    """The VolumeMesh, without a report and the numbers of layers, that an object of add_flow_mesh holds, or a link to one, where
    that stands: patches are those of set_patches, else each face by its own name. Raises InvalidInput where its mesh is not the one of its report.
    """
    obj = frames.linked_of(source)[0]
    if obj.FemMesh.VolumeCount != obj.Elements:  # after undo, which does not bring back the FemMesh
        raise InvalidInput(phrases.Text(solid_phrases.OUTDATED, name=f"'{obj.Label}'"))
    mesh = ElementMesh.of(source)
    members = mesh.group_members
    region, far = next(name for name in obj.GivenGroups if _is_solid(mesh, members[name])), set(obj.GivenGroups)
    own = [name for name in members if name not in far and not fem_groups.is_of_shape(name)]
    faces = [name for name in members if (name in far or fem_groups.is_of_shape(name)) and name != region]
    blocks, left = list(mesh.blocks), {name: [] for name in (*own, *faces)}
    patch_of = {block: np.full(len(each.nodes), -1, dtype=np.int32) for block, each in enumerate(blocks)}
    for number, name in enumerate(left):
        for block, rows in members[name]:
            free = rows[patch_of[block][rows] < 0]
            patch_of[block][free] = number
            if len(free):
                left[name].append((block, free))
    names = [name for name, parts in left.items() if parts]
    renumbered = np.array([names.index(name) if name in names else -1 for name in left], dtype=np.int32)
    on_walls = _elements_of(members, [line.partition(":")[0] for line in obj.Coverage])  # by the names of groups
    types = {name: "wall" if _elements_of(left, [name]) <= on_walls else "symmetry" if name.startswith("symmetry") else "patch"
             for name in names}
    for block, each in enumerate(blocks):
        if kinds.DIMENSION[each.kind] == 2:
            blocks[block] = each._replace(geometry=renumbered[patch_of[block]])
    division = division_of({name: [] for name in names})._replace(patch_of={i: i for i in range(len(names))})
    content = Content(mesh.nodes, tuple(blocks), {region: members[region], **{name: tuple(left[name]) for name in names}}, ())
    return volumes.VolumeMesh(content, None, Patches(division.names, division.colours, None, True, division), types)


def _is_solid(mesh, parts):
    return kinds.DIMENSION[mesh.blocks[parts[0][0]].kind] == 3


def _elements_of(members, names):
    return {(block, row) for name in names for block, rows in members.get(name, ()) for row in rows.tolist()}


def add_flow_mesh(source, layers, first_height, patches=None, patch_rest=None, **values):
    """Adds a document object that keeps a volume mesh for a flow up to date; one undo step.

    source        document object with a shape: feature, body, link or container
    layers        how many layers of prisms; first_height: mm, of the one on the wall
    patches, patch_rest
                  as for set_patches
    values        growth_rate, order (1 or 2), walls, min_angle, chord_height, chord_height_relative, max_edge and local_sizes as for volume_mesh, walls as
                  names of faces; far_field: "none" (the part is the fluid), "box" or "sphere", far_distance: as many sizes of the part
                  away from it; symmetry: "none", "x>", "x<", ... "z<", the side of the fluid, symmetry_at: mm; far_edge and growth_inside as there

    Its property FemMesh has the elements, with a group for each face of the part and of the far field, for each patch, and for the
    fluid. export_mesh writes it into files, write_openfoam_case into a case. After an edit of the source walls are found again.
    A wall that layers do not cover is named in the certificate. Returns the object. Raises what volume_mesh raises, and then adds
    nothing; Error where FreeCAD is built without its FEM workbench.
    """
    fem.module()
    if values.get("walls") is not None and isinstance(values["walls"], str):
        raise InvalidInput(f"walls = {values['walls']!r}: give a list of faces such as ['Face1', 'Face4']")

    def begin(obj):
        fem_mesh.put_into(None, obj, source)
        if patches is not None or patch_rest is not None:
            obj.Proxy.require_patch_names([*(patches or ()), *filter(None, (patch_rest,))])
            give_patches(obj, obj.Proxy.faces(obj), patches, patch_rest)

    return transactions.add_of_source(FlowMeshObject, source, {"layers": layers, "first_height": first_height, **values}, "FlowMesh",
                                      "Flow mesh", "flow mesh", then=begin)
