# SPDX-License-Identifier: LGPL-2.1-or-later
"""volume_mesh: a solid filled for flow solvers, with layers of prisms on its walls."""

import os

import numpy as np

from ... import flow_phrases, options
from ...compat import extension
from ...errors import Cancelled, GeometryError, InvalidInput
from ...listing import Public
from ...phrases import Text
from ..elements import conformity, kinds
from ..elements.alike import unique_pairs
from ..elements.assembly import Content, ElementBlock
from ..elements.boundary import boundary_of
from ..formats.completion import blended
from ..inspect.thickness import thickness
from ..meshes.element_mesh import ElementMesh
from ..meshes.writing import checked_scale
from ..operands.operands import part_of
from ..patches.patches import division_for, index_in, patches_of
from ..sources import convert
from ..triangulation import triangulate
from . import polymesh
from .curved_layers import curved
from .far_field import SYMMETRY, region_around
from .layers import Surface, layers_of, proven_bounds
from .marching import marching_of
from .volume_report import report_of

_PLANE = 2e-6  # share of the size: how far from a plane the points of a plane face are, which are single-precision numbers
REGION = "fluid"  # the group of the volume elements
_METRES = 0.001
_USUAL_GROWTH = 0.8  # of edges by the distance from the surface, where the factor of fill_surface is 1
_TETRAHEDRA = 2.0  # over the growth inside: tetrahedra on a triangle of the surface, where there is room for them; see _expected_inside


class VolumeMesh(ElementMesh, metaclass=Public):
    """An ElementMesh that volume_mesh made: prisms in layers on the walls, tetrahedra inside, pyramids and tetrahedra between, where
    layers end. All elements are proven valid, and conform.

    order        of all elements
    prisms, pyramids, tetrahedra
                 int32 (E, 6), (E, 5), (E, 4): rows of nodes in Gmsh's order; more of a higher order
    prism_layer  int32 (P,), the layer of each prism; 0 is on the wall
    boundary_triangles, boundary_quadrilaterals
                 int32 (F, 3), (F, 4): the faces of the boundary, outward; likewise
    triangle_face, quadrilateral_face
                 int32 (F,): they lie on shape.Faces[...]
    patch_names  of the boundary; groups of the mesh, as is the region "fluid"
    patch_types  {patch: "wall", "patch", or "symmetry" of those without layers whose names begin so}
    report       VolumeReport
    """

    __slots__ = {"_report": None, "_patches": None, "prism_layer": "int32 (P,), 0 is on the wall", "patch_types": '{patch: "wall", "patch" or "symmetry"}'}

    def __init__(self, content, prism_layer, patches, patch_types):
        super().__init__(content)
        self.prism_layer, self._patches, self.patch_types, self._report = prism_layer, patches, patch_types, None

    report = property(lambda self: self._report, doc="VolumeReport")
    order = property(lambda self: self.blocks[0].order, doc="of all elements")
    patch_names = property(lambda self: self._patches.names, doc="tuple of names")
    prisms = property(lambda self: self._rows("prism"), doc="int32 (E, 6)")
    pyramids = property(lambda self: self._rows("pyramid"), doc="int32 (E, 5)")
    tetrahedra = property(lambda self: self._rows("tetrahedron"), doc="int32 (E, 4)")
    boundary_triangles = property(lambda self: self._rows("triangle"), doc="int32 (F, 3)")
    boundary_quadrilaterals = property(lambda self: self._rows("quadrilateral"), doc="int32 (F, 4)")
    triangle_face = property(lambda self: self._faces("triangle"), doc="int32 (F,)")
    quadrilateral_face = property(lambda self: self._faces("quadrilateral"), doc="int32 (F,)")

    def _rows(self, kind):
        return next((block.nodes for block in self.blocks if block.kind == kind),
                    np.zeros((0, kinds.count_of(kind, self.order)), dtype=np.int32))

    def _faces(self, kind):
        return next((block.geometry for block in self.blocks if block.kind == kind), np.zeros(0, dtype=np.int32))

    @property
    def solid_blocks(self):
        """[(kind, int (E, corners)), ...] of the volume elements, in the order of the blocks."""
        return [(block.kind, block.nodes[:, :kinds.CORNERS[block.kind]]) for block in self.blocks if kinds.DIMENSION[block.kind] == 3]

    @property
    def sides(self):
        """(int (F, 3), int (F, 4)): the corners of the faces of the boundary."""
        return self.boundary_triangles[:, :3], self.boundary_quadrilaterals[:, :4]

    def patch_of_faces(self, rings):
        """int (F,): the patches of faces of the boundary, int (F, 4) corners, -1 after the third one of triangles."""
        triangles, quadrilaterals = self.sides
        sides = np.concatenate([np.pad(triangles, ((0, 0), (0, 1)), constant_values=-1), quadrilaterals]).astype(np.int64)
        faces = np.concatenate([self.triangle_face, self.quadrilateral_face])
        patch_of = dict(zip(np.unique(self.triangle_face).tolist(), self._patch_of_face(np.unique(self.triangle_face))))
        known = {tuple(key): face for key, face in zip(np.sort(sides, axis=1).tolist(), faces.tolist())}
        return np.array([patch_of[known[tuple(key)]] for key in np.sort(rings, axis=1).tolist()], dtype=np.int64)

    def _patch_of_face(self, faces):
        return patches_of(self._patches.division, faces, len(faces)).of_triangle.tolist()

    def write(self, path, scale=None, format=None, binary=False):  # noqa: A002
        """Writes into a file, as ElementMesh.write does, or, where the name has no extension, a case of OpenFOAM into a folder:
        constant/polyMesh, and system, without which no program of OpenFOAM starts.

        scale   factor of the coordinates, which are mm; None: 1, and 0.001, metres, for OpenFOAM
        format  the format whatever the extension, such as "msh"; "openfoam": a case
        binary  of OpenFOAM: numbers as bytes, with labels of 32 bits, instead of text

        Raises InvalidInput naming elements or a patch that the format cannot hold; IoError naming the path.
        """
        name = os.fsdecode(convert.file_name(path))
        if format == "openfoam" or (format is None and not os.path.splitext(name)[1]):
            polymesh.write_case(self, name, checked_scale(_METRES if scale is None else scale), self.patch_types, binary)
        elif binary:
            raise InvalidInput("binary is for cases of OpenFOAM: the extension says which other files are")
        else:
            super().write(path, 1.0 if scale is None else scale, format)


def volume_mesh(shape, layers, first_height, growth_rate=1.2, walls=None, min_angle=25.0, chord_height=None,
                chord_height_relative=None, max_edge=None, local_sizes=None, patches=None, patch_rest=None, far_field=None,
                symmetry=None, far_edge=None, growth_inside=0.3, order=1, progress=None):
    """Fills a solid, the region of a flow, or the space around a part with layers of prisms on the walls and tetrahedra
    -> VolumeMesh.

    shape         Part.Shape, or a document object that has one: one solid, which is the fluid; with far_field solids that it flows around
    layers        how many layers of prisms, 1 to 100
    first_height  mm, of the one on the wall; mq.first_height estimates it for a y+
    growth_rate   how many times as high each layer is as the one before it, 1 to 4
    walls         names of faces, or of patches, that get layers; None: all faces. Layers end in the other faces beside them, which
                  must be planes
    min_angle, chord_height, chord_height_relative, max_edge, local_sizes, patches, patch_rest
                  of the surface, as for triangulate. Around a part they are of the part; patches may also name faces of the far field
    far_field     the flow goes around the shape, as far as a "box" or "sphere" in 5 times its largest dimension, in 10 times:
                  "box:10", or a Part.Shape of one solid. Its faces are xMin, xMax, yMin, yMax, zMin, zMax of a box, farField of a
                  sphere, Far1, Far2, ... of a solid: patches by these names unless patches has them
    symmetry      the half-space of the fluid, "y>0" or "z>-2.5" (mm), in whose plane a box or a sphere ends in the patch symmetry
    far_edge      mm, longest edges of triangles on the far field; None: a fifth of its distance
    growth_inside by how much longer edges of tetrahedra get for each length of distance from the surface that layers leave, 0.02 to 2
    order         of the elements, 1 to 4; from 2 on layers follow the CAD. Elements that would not be valid so bend less, or stay
                  straight: report.straightened names them
    progress      callable(fraction 0..1, stage); returning False cancels

    Vertices march by the direction from which all of their walls are seen best. Layers get lower than asked for where elements
    would be invalid or nearly vanish, or where they would take more than 0.4 of a gap; where they would get lower than a fifth, they
    are left off: beside the bare wall they run out within one triangle, as pyramids and tetrahedra. The report says so for each face. Every element is
    proven valid, and that all conform is checked.

    Raises InvalidInput for what is no single solid, for walls that are none of its faces, for a curved face in which layers would
    end, and for layers that fit nowhere, as they are thicker than a gap, on a face that walls names itself, naming it; GeometryError where the inside cannot be filled; TopologyError; Cancelled.
    """
    options.require_callable(progress)
    asked = _Asked(shape, walls, patches, patch_rest, far_field, symmetry, {
        "layers": layers, "first_height": first_height, "growth_rate": growth_rate, "min_angle": min_angle,
        "chord_height": chord_height, "chord_height_relative": chord_height_relative, "max_edge": max_edge,
        "local_sizes": local_sizes, "far_edge": far_edge, "growth_inside": growth_inside, "order": order})
    order = asked.values["order"]
    straight = progress if order == 1 else part_of(progress, 0.0, 0.7)
    mesh = asked.triangulated(progress=part_of(straight, 0.0, 0.3))
    surface = _surface_of(mesh, asked.region, asked.chosen)
    made = _filled(mesh, surface, {**asked.values, "first_height": first_height, "named": asked.named},
                   patches_of(asked.division, surface.face, len(surface.triangles)), straight)
    return made if order == 1 else _with_order(made, convert.shape_of(asked.shape), order, part_of(progress, 0.7, 1.0))


def expected_cells(shape, most, progress=None, walls=None, far_field=None, symmetry=None, **values):
    """(about how many elements volume_mesh makes of a shape with these options, whether that is all): an estimate by the triangles
    of the surface, of which at most `most` are made. Raises what volume_mesh raises of its arguments.
    """
    asked = _Asked(shape, walls, None, None, far_field, symmetry, values)
    mesh = asked.triangulated(max_triangles=most, progress=progress)
    face = np.asarray(mesh.triangle_face)
    face = face if asked.region is None else asked.region.origin[face]
    on_walls = len(face) if asked.chosen is None else int(np.isin(face, sorted(asked.chosen)).sum())
    return round(asked.values["layers"] * on_walls + _expected_inside(mesh, asked.values["growth_inside"])), mesh.report.complete


def _expected_inside(mesh, growth):
    """About how many tetrahedra a SurfaceMesh gets. Edges that grow from h by g for each mm of depth make 2 / g of them in the column below
    a triangle, less those below the depth, which is volume over area: (h / (h + g depth))^2 of them. Within 10 % on a box, a slab and
    a pipe, growth 0.3 and 0.8; 30 % too few around a pin in a box.
    """
    a, b, c = mesh.vertices[mesh.triangles].transpose(1, 0, 2).astype(np.float64)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2.0
    edge, depth = np.sqrt(area * 4.0 / np.sqrt(3.0)), abs(mesh.report.volume) / area.sum()
    return float((_TETRAHEDRA / growth * (1.0 - (edge / (edge + growth * depth)) ** 2)).sum())


class _Asked:
    """What volume_mesh is asked for, checked.

    values    the options; region: the Region around a part, or None
    shape     what is filled, a Part.Shape or a document object
    named     indices of the faces that are walls by their own names, not by a patch's
    division  of the patches; chosen: indices of the faces that are walls, None: all
    """

    def __init__(self, shape, walls, patches, patch_rest, far_field, symmetry, values):
        self.values = values = options.check(options.volume.VOLUME, values)
        for name in ("layers", "first_height"):
            if not values[name]:
                raise InvalidInput(f"{name} = {values[name]!r}: it must be given, above 0")
        if far_field is not None:
            self.region = region_around(shape, far_field, symmetry, values["far_edge"])
            self.division = self.region.division(shape, patches, patch_rest)
            chosen, self.named = _walls_of(shape, walls, self.division)
            self.chosen = chosen or set(range(self.region.count))
            self.shape, sizes = self.region.shape, self.region.sizes(values, shape)
        else:
            self.region, self.division = None, division_for(shape, patches, patch_rest)
            self.chosen, self.named = _walls_of(_one_solid(shape, symmetry, values["far_edge"]), walls, self.division)
            self.shape, sizes = shape, values
        self._sizes = {option.name: sizes[option.name] for option in options.volume.SURFACE}

    def triangulated(self, **others):
        """The SurfaceMesh of the region."""
        return triangulate(self.shape, **self._sizes, **others)


def _one_solid(shape, symmetry, far_edge):
    """The shape, which must be one solid."""
    alone = next((name for name, value in (("symmetry", symmetry), ("far_edge", far_edge)) if value is not None), None)
    if alone is not None:
        raise InvalidInput(f"{alone} is of a far field: give far_field, too, or leave it out")
    solids = convert.shape_of(shape).countElement("Solid")
    if solids != 1:
        raise InvalidInput(Text(flow_phrases.ONE_SOLID, name=convert.label_of(shape), count=str(solids)))
    return shape


def _walls_of(shape, walls, division):
    """(indices of the faces that are walls, None: all; those of them that are named themselves)."""
    if walls is None:
        return None, set()
    if isinstance(walls, str) or not hasattr(walls, "__iter__"):
        raise InvalidInput(f"walls = {walls!r}: give a list of faces or patches such as ['Face1', 'Face4']")
    count, found, named = convert.shape_of(shape).countElement("Face"), set(), set()
    for name in walls:
        index = index_in(shape, str(name))
        if index is None and division is not None and name in division.names:
            found |= {face for face, patch in division.patch_of.items() if division.names[patch] == name}
            continue
        if index is None and division is not None and name == division.rest:
            found |= set(range(count)) - set(division.patch_of)
            continue
        if index is None or not 0 <= index < count:
            raise InvalidInput(f"walls name {name!r}, which is no face of {convert.label_of(shape)}: it has Face1 to Face{count}"
                               + (f", and the patches {', '.join(division.names)}" if division is not None else ""))
        named.add(index)
    if not found | named:
        raise InvalidInput("walls is an empty list: name the faces that get layers, or leave it out for all")
    return found | named, named


def _surface_of(mesh, region, chosen):
    """The Surface of a SurfaceMesh, of the Region around a part or, None, of a solid; raises GeometryError where it is not closed."""
    triangles, face = np.array(mesh.triangles, dtype=np.int64), np.array(mesh.triangle_face, dtype=np.int64)
    face, far = (face, (0, ())) if region is None else (region.origin[face], (region.count, region.names))
    edges = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    _, counts = unique_pairs(edges)
    if not mesh.report.closed or (counts != 2).any():
        raise GeometryError(Text(flow_phrases.OPEN_REGION))
    is_wall = np.ones(len(triangles), dtype=bool) if chosen is None else np.isin(face, sorted(chosen))
    return Surface(np.array(mesh.vertices) + mesh.origin, triangles, face, is_wall, far)


def _plane_normals(surface):
    """float64 (T, 3): of triangles off the walls the normal of their face, not a number where that is no plane. Raises InvalidInput
    naming a curved face at which layers would end.
    """
    found = np.full((len(surface.triangles), 3), np.nan)
    size = np.ptp(surface.points, axis=0).max()
    at_walls = np.zeros(len(surface.points), dtype=bool)
    at_walls[surface.triangles[surface.is_wall]] = True
    for face in np.unique(surface.face[~surface.is_wall]).tolist():
        rows = surface.triangles[surface.face == face]
        a, b, c = surface.points[rows].transpose(1, 0, 2)
        normal = np.cross(b - a, c - a).sum(axis=0)
        normal /= np.linalg.norm(normal)
        if np.ptp(surface.points[np.unique(rows)] @ normal) <= _PLANE * size:
            found[surface.face == face] = normal
        elif at_walls[rows].any():
            raise InvalidInput(Text(flow_phrases.NOT_PLANE, face=surface.name_of(face)))
    return found


def _gap_of(mesh, progress):
    """float64 (T,), mm, by rays to what is opposite of each triangle; infinite at corners, and where that is not known."""
    found = thickness(mesh, "rays", progress=progress)
    if not np.array_equal(found.mesh.triangles, mesh.triangles):
        return np.full(len(mesh.triangles), np.inf)
    return np.where(found.is_wall & np.isfinite(found.values), found.values, np.inf)


def _filled(mesh, surface, values, patches, progress):
    heights = values["first_height"] * values["growth_rate"] ** np.arange(values["layers"])
    check = _checker(progress)
    marching = marching_of(surface.points, surface.triangles, surface.face, surface.is_wall, _plane_normals(surface),
                          _checker(progress, 0.3))
    gap = _gap_of(mesh, part_of(progress, 0.3, 0.4))
    layers = layers_of(surface, marching, heights, gap, check)
    if layers is None:
        raise GeometryError(Text(flow_phrases.NO_LAYERS))
    gap_of = _widest_gaps(surface, gap)
    _require_some(surface, layers, gap_of, heights.sum(), values["named"])
    points, tetrahedra = _inside(layers, values["growth_inside"], part_of(progress, 0.5, 0.95))
    check = _checker(progress, 0.95, "checking elements")
    check()
    made = _mesh_of(surface, layers, points, tetrahedra, patches, check)
    least = _require_valid(made, check)
    made._report = report_of(made, surface, layers, values, heights, float(mesh.report.max_chord_height), least, gap_of, check)
    return made


def _with_order(straight, shape, order, progress):
    """The VolumeMesh of a higher order on the same corners."""
    found = curved(straight, shape, order, progress)
    made = VolumeMesh(found.content, straight.prism_layer, straight._patches, straight.patch_types)
    least = _require_valid(made, _checker(progress, 0.95, "checking elements"))
    made._report = straight.report.of_order(made, found, least)
    return made


def _checker(progress, done=0.45, stage="growing layers"):
    def check():
        if progress is not None and progress(done, stage) is False:
            raise Cancelled("cancelled")
    return check


def _widest_gaps(surface, gap):
    """{wall face: mm}, the widest gap at a triangle of it."""
    return {face: float(gap[surface.face == face].max()) for face in np.unique(surface.face[surface.is_wall]).tolist()}


def _require_some(surface, layers, gap_of, total, named):
    """Raises InvalidInput naming a wall face without any layers: one that walls names itself, or where all have none. The report names
    others, such as the blunt trailing edge of a wing, or a face in a narrow slot.
    """
    bare = [face for face in gap_of if not layers.share[surface.triangles[surface.face == face]].any()]
    refused = bare if len(bare) == len(gap_of) else [face for face in bare if face in named]
    if not refused:
        return
    face = next((face for face in refused if gap_of[face] < total), refused[0])
    if gap_of[face] < total:
        raise InvalidInput(Text(flow_phrases.TOO_THICK, face=surface.name_of(face), length=f"{total:.4g} mm", length2=f"{gap_of[face]:.4g} mm"))
    raise InvalidInput(Text(flow_phrases.NOWHERE, face=surface.name_of(face), length=f"{total:.4g} mm"))


def _inside(layers, growth, progress):
    """(points of all, tetrahedra of the inside as rows of these)."""
    used, triangles = np.unique(layers.inner, return_inverse=True)
    triangles = triangles.reshape(-1, 3).astype(np.int32)
    added, tetrahedra = extension().fill_surface(layers.points[used], triangles, growth / _USUAL_GROWTH, progress)
    number = np.concatenate([used, len(layers.points) + np.arange(len(added) // 3)])
    return np.concatenate([layers.points, np.asarray(added).reshape(-1, 3)]), number[np.asarray(tetrahedra).reshape(-1, 4)]


def _mesh_of(surface, layers, points, tetrahedra, patches, check):
    """The VolumeMesh, without points that no element has."""
    solid = {"tetrahedron": np.concatenate([layers.tetrahedra, tetrahedra]), "pyramid": layers.pyramids, "prism": layers.prisms}
    flat = {"triangle": 3, "quadrilateral": 4}
    is_used = np.zeros(len(points), dtype=bool)
    for rows in solid.values():
        check()
        is_used[rows] = True
    used, number = np.flatnonzero(is_used), np.full(len(points), -1, dtype=np.int32)
    number[used] = np.arange(len(used))
    names = [REGION, *patches.names]
    blocks, members = [], {name: [] for name in names}
    for kind, rows in solid.items():
        check()
        if len(rows):
            members[REGION].append((len(blocks), np.arange(len(rows), dtype=np.int32)))
            zero = np.zeros(len(rows), dtype=np.int32)
            blocks.append(ElementBlock(kind, 1, number[rows], zero, zero.copy()))
    patch_of = np.full(int(surface.face.max()) + 1, -1, dtype=np.int32)
    patch_of[surface.face] = patches.of_triangle
    for kind, corners in flat.items():
        parts = [(rows, faces) for rows, faces in layers.boundary if rows.shape[1] == corners and len(rows)]
        if not parts:
            continue
        rows, faces = (np.concatenate(side) for side in zip(*parts))
        for i, name in enumerate(patches.names):
            chosen = np.flatnonzero(patch_of[faces] == i).astype(np.int32)
            if len(chosen):
                members[name].append((len(blocks), chosen))
        blocks.append(ElementBlock(kind, 1, number[rows], (patch_of[faces] + 1).astype(np.int32), faces.astype(np.int32)))
    walls = set(np.unique(surface.face[surface.is_wall]).tolist())
    types = {name: "wall" if set(np.unique(surface.face[patches.of_triangle == i]).tolist()) <= walls else
             "symmetry" if name.lower().startswith(SYMMETRY) else "patch" for i, name in enumerate(patches.names)}
    return VolumeMesh(Content(points[used], tuple(blocks), {name: tuple(parts) for name, parts in members.items()}, ()),
                      layers.level.astype(np.int32), patches, types)


def _require_valid(mesh, check=lambda: None):
    """The smallest proven bound of min J / max |J|. Raises GeometryError unless all elements are proven valid, conform, and have the listed
    boundary and no other.
    """
    least = 1.0
    for block in mesh.blocks:
        if kinds.DIMENSION[block.kind] < 3:
            continue
        bounds = proven_bounds(mesh.nodes, block.kind, block.nodes, block.order, check)
        wrong = int((~(bounds > 0.0)).sum())
        if wrong:
            raise GeometryError(f"{wrong} {kinds.PLURALS[block.kind]} are not proven valid: give thinner layers, or a finer surface by "
                                "max_edge")
        least = min(least, float(bounds.min()))
    conforming, oriented = conformity.of_blocks(mesh.blocks, mesh.nodes, check)
    listed = {len(rows[0]): rows for rows in (mesh.boundary_triangles, mesh.boundary_quadrilaterals) if len(rows)}
    bounds = {len(rows[0]): rows for rows in boundary_of(mesh.blocks, check) if len(rows)}
    check()
    same = set(listed) == set(bounds) and all(_same_sides(listed[count], bounds[count]) for count in listed)
    if not (conforming and oriented and same):
        raise GeometryError("the elements do not conform: give thinner layers, or a finer surface by max_edge")
    return least


def valid_without_middles(mesh):
    """Whether all elements of a VolumeMesh of order 1 or 2 are also valid in programs that have no nodes amid quadrilaterals."""
    solids = [(block.kind, block.nodes) for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3]
    if mesh.order == 1:
        return True
    nodes = blended(mesh.nodes, solids)
    return np.array_equal(nodes, mesh.nodes) or all((proven_bounds(nodes, kind, rows, mesh.order) > 0.0).all() for kind, rows in solids)


def _same_sides(one, other):
    """Whether sides are the same, seen from the same side."""
    def keys(sides):
        turn = (np.argmin(sides, axis=1)[:, None] + np.arange(sides.shape[1])) % sides.shape[1]
        return np.unique(np.take_along_axis(sides, turn, axis=1), axis=0)
    return len(one) == len(other) and np.array_equal(keys(one), keys(other))
