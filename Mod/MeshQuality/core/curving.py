# SPDX-License-Identifier: LGPL-2.1-or-later
"""CurvedMesh: a mesh of high-order elements, and how it is made."""

import FreeCAD
import numpy as np

from .. import options
from ..compat import extension
from ..errors import InvalidInput
from ..listing import Public
from .certify.certification import given_mesh
from .curved import curved_elements, simplex_arrays, orders
from .curved.curved_arrays import ARRAYS
from .fem import fem, fem_places
from .meshes import writing
from .meshes.element_mesh import ElementMesh
from .meshes.surface_mesh import SurfaceMesh, names_of_patches, numbers_of_patches
from .patches.patches import division_for, kept
from .sources import convert, frames
from .sources import hidden_parts
from .sizes import size_field as size_fields


class CurvedMesh(metaclass=Public):
    """Curved triangles, or tetrahedra, of one order with their link to the CAD and a report.

    order              1 to 5 (volumes: 4)
    nodes              float64 (N, 3), mm; the corners come first
    elements           int32 (E, nodes per element), Gmsh node order: tetrahedra of a volume mesh,
                       triangles otherwise
    triangles          int32 (T, nodes per triangle), on the CAD faces
    triangle_face      int32 (T,), triangle i lies on shape.Faces[triangle_face[i]]
    triangle_face_behind
                       int32 (T,), the CAD face of the solid on the other side of triangle i, or -1; empty where
                       no solid shares a face with another (imprint=True)
    edges              int32 (L, order + 1), on the CAD edges
    edge_entity        int32 (L,), element i of edges lies on shape.Edges[edge_entity[i]]
    tetrahedra         int32 (E, nodes per tetrahedron), empty without volume
    tetrahedron_solid  int32 (E,), tetrahedron i lies in shape.Solids[tetrahedron_solid[i]]
    node_entity        int32 (N, 2), (dimension 0|1|2|3, index)
    triangle_quality   float64 (T,), lower bounds of min J / max J against the CAD normal; not
                       positive: invalid
    tetrahedron_quality
                       float64 (E,), lower bounds of min J / J of the straight element; likewise
    triangle_distortion, tetrahedron_distortion
                       float64 (T,), (E,), measured when they are first asked for: how far the shape
                       of the worst place of each element is from that of the regular simplex, see
                       docs/method/validity.md; upper bounds, 1 is best, infinite: it folds
    report             CurveReport; None of a mesh that comes from a document
    straight           SurfaceMesh that was curved, with its report; likewise
    given_node         int32 (corners,), of a mesh that another program made (curve(..., mesh=)): its node at each corner,
                       or -1; empty of others, as are the next two
    given_element      int32 (E,), its element with the corners of element i, or -1 where that is a new one
    moved_nodes        int32, its nodes that are not where they were
    patches            the names of its patches; empty where none were given
    triangle_patch     int32 (T,), triangle i is in patches[triangle_patch[i]]; empty likewise

    The arrays are read-only views of the core's memory.
    """

    __slots__ = ("_curved", "_distortions", "_measured", "_patches", "_solid_names")

    def __init__(self, curved, measured=True, patches=None):
        self._curved = curved
        self._patches = patches
        self._solid_names = ()  # by the index of a solid, what files call it in place of "Solid1"
        self._measured = measured
        self._distortions = {}

    @classmethod
    def of(cls, obj):
        """The curved mesh that a document object of add_curved_mesh keeps, where the document has it, or has
        it by a link.

        Its report is None: what it said is in the object's properties. Raises InvalidInput for
        other objects and for one that was never computed.
        """
        return taken_from(obj)()

    order = property(lambda self: self._curved.order, doc="1 to 5")
    nodes = property(lambda self: self._curved.nodes, doc="float64 (N, 3), mm")
    triangles = property(lambda self: self._curved.triangles, doc="int32 (T, nodes per triangle)")
    triangle_face = property(lambda self: self._curved.triangle_face, doc="int32 (T,)")
    triangle_face_behind = property(lambda self: self._curved.triangle_face_behind, doc="int32 (T,)")
    edges = property(lambda self: self._curved.edges, doc="int32 (L, order + 1)")
    edge_entity = property(lambda self: self._curved.edge_entity, doc="int32 (L,)")
    tetrahedra = property(lambda self: self._curved.tetrahedra,
                          doc="int32 (E, nodes per tetrahedron)")
    tetrahedron_solid = property(lambda self: self._curved.tetrahedron_solid, doc="int32 (E,)")
    node_entity = property(lambda self: self._curved.node_entity, doc="int32 (N, 2)")
    triangle_quality = property(lambda self: self._curved.triangle_quality, doc="float64 (T,)")
    tetrahedron_quality = property(lambda self: self._curved.tetrahedron_quality,
                                   doc="float64 (E,)")

    given_node = property(lambda self: self._curved.given_node, doc="int32 (corners,)")
    given_element = property(lambda self: self._curved.given_element, doc="int32 (E,)")
    moved_nodes = property(lambda self: self._curved.moved_nodes, doc="int32")
    patches = property(names_of_patches, doc="names of the patches")
    triangle_patch = property(numbers_of_patches, doc="int32 (T,)")

    @property
    def triangle_distortion(self):
        """float64 (T,)"""
        return self._distortion("triangle_distortions")

    @property
    def tetrahedron_distortion(self):
        """float64 (E,)"""
        return self._distortion("tetrahedron_distortions")

    def _distortion(self, which, progress=None):
        if which not in self._distortions:
            found = getattr(self._curved, which)(progress)
            found.flags.writeable = False
            self._distortions[which] = found
        return self._distortions[which]

    @property
    def report(self):
        """CurveReport, or None."""
        return self._curved.report if self._measured else None

    @property
    def straight(self):
        """SurfaceMesh, or None."""
        surface = self._curved.straight
        return None if surface is None else SurfaceMesh(surface)

    @property
    def elements(self):
        """The tetrahedra of a volume mesh, the triangles of a surface mesh."""
        return self.tetrahedra if len(self.tetrahedra) else self.triangles

    @property
    def shown_quality(self):
        """float64 (T,): of each triangle, or of the tetrahedron behind it where there is one."""
        return self._shown(self.triangle_quality, self.tetrahedron_quality)

    def tetrahedra_at_surface(self):
        """How many tetrahedra have a triangle on the surface."""
        behind = self._curved.tetrahedra_behind()
        return len(np.unique(behind[behind >= 0]))

    def shown_distortion(self, progress=None):
        """float64 (T,), likewise; progress as for curve."""
        tetrahedra = self._distortion("tetrahedron_distortions", progress)
        return self._shown(self._distortion("triangle_distortions"), tetrahedra)

    def _shown(self, of_triangles, of_tetrahedra):
        if not len(self.tetrahedra):
            return of_triangles
        behind = self._curved.tetrahedra_behind()
        return np.where(behind >= 0, of_tetrahedra[np.maximum(behind, 0)], of_triangles)

    def with_order(self, order):
        """The same mesh with elements of another order, 1 to 5 (volumes: 4): a new CurvedMesh.

        A higher order has the same shape: nodes are put where the polynomials of this one are, and its qualities are
        those of this one. A lower order goes through points of the edges, faces and elements as they are: triangle_quality
        and tetrahedron_quality are measured anew, as lower bounds of min J / max J by the elements themselves. Elements,
        entities and patches stay; the report is None; `straight`, and the relation to a given mesh, are not
        kept. Raises InvalidInput naming the orders there are.
        """
        order, arrays = orders.arrays_of_order(self, order)
        return CurvedMesh(extension().curved_from_arrays(order, arrays), measured=False, patches=self._patches)

    def with_orders(self, orders, raise_invalid=False):
        """The same elements, each with an order of its own: a CurvedElementMesh; see its with_orders.

        orders  int (E,), 1 to 5 (volumes: 4), of `elements`. Raises InvalidInput naming the orders there are.
        """
        orders = np.asarray(orders)
        highest = int(orders.max(initial=1)) if orders.dtype.kind in "iu" else self.order
        mesh = self if highest <= self.order else self.with_order(highest)
        return curved_elements.with_orders(ElementMesh.of(mesh), mesh.order, orders, raise_invalid)

    def tessellate(self, deviation=None, progress=None):
        """Flat triangles that the curved ones keep within `deviation` mm of.

        None: a thousandth of the size. Only what bends is cut. The result has `surface()`,
        `element` (by triangle: index of its curved triangle), `edge_lines` (the curved triangles'
        edges as runs of vertices, each followed by -1), `normals` of the curved triangles and three
        `triangle_normals` a triangle.
        Raises InvalidInput when that takes more than 20 million triangles, or is finer than single
        precision; Cancelled.
        """
        values = options.check(options.CURVED_DISPLAY, {"deviation": deviation})
        options.require_callable(progress)
        return self._curved.tessellate(values["deviation"] or 0.0, progress)

    def to_mesh(self, deviation=None):
        """A Mesh.Mesh of the curved triangles as `tessellate` cuts them; one segment a CAD face."""
        return convert.mesh_of_surface(self.tessellate(deviation).surface())

    def to_fem_mesh(self, groups=False):
        """A Fem.FemMesh of a mesh of order 1 or 2: tetrahedra of a volume, triangles otherwise.

        groups   also the triangles of a volume and the edges on the CAD edges, and a group for each CAD
                 entity by FreeCAD's name: Solid1, Face1, Edge1
        Node i + 1 is nodes[i]; element i + 1 is elements[i]. With groups the triangles of a volume come next in
        their order, and then the edges. Raises InvalidInput for higher orders, which FreeCAD's FEM meshes
        cannot hold; Error where FreeCAD is built without its FEM workbench.
        """
        return fem.mesh_of(fem.elements_of(self, groups))

    def write(self, path, patches=None, patch_rest=None, scale=1.0, ascii=False, format=None):  # noqa: A002
        """Writes into a file; one that is there is replaced once the new one is complete.

        path    the extension says the format: .msh (Gmsh 4.1, with a physical group a CAD edge, patch and solid),
                .msh2 (Gmsh 2.2), .vtu (VTK), .mesh (MFEM) and .xml (Nektar++) hold all orders, .cgns orders 1 to 4,
                .inp .unv .nas .bdf .exo orders 1 and 2, .su2 order 1
        The others are as for SurfaceMesh.write. Raises InvalidInput naming patch, face or order and the remedy; IoError
        naming the path.
        """
        writing.write(self, path, patches, patch_rest, scale, ascii, format)

    def _write_core(self, path, name, patches, scale, _ascii):
        self._curved.write(path, name, **writing.arguments_of(patches), scale=scale, solids=writing.solids_of(self))

    def __repr__(self):
        count, kind = len(self.elements), "tetrahedron" if len(self.tetrahedra) else "triangle"
        plural = "tetrahedra" if kind == "tetrahedron" else "triangles"
        quality = self.tetrahedron_quality if len(self.tetrahedra) else self.triangle_quality
        folded = int((~(quality > 0.0)).sum())
        valid = f"{folded:,} not proven valid" if folded else "all valid"
        return f"<CurvedMesh: {count:,} {kind if count == 1 else plural} of order {self.order}, {valid}>"


def taken_from(obj):
    """A function that makes what CurvedMesh.of gives of the object as it is now; any thread may call it."""
    if not holds_elements(obj):
        raise InvalidInput(f"{convert.label_of(obj)} holds no curved mesh: give an object of "
                           "add_curved_mesh that was computed, or a link to one")
    return loader_of(frames.linked_of(obj)[0], frames.motion_of(obj))


def holds_elements(source):
    """Whether it is a document object with curved elements, or a link to one that shows it once."""
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        return False
    once = not getattr(frames.leaf_of(source), "ElementCount", 0)
    return once and getattr(frames.linked_of(source)[0], "ElementsOrder", 0) > 0


def loader_of(obj, motion=None):
    """A function that makes the elements that an object holds, where they were computed or moved from there by a
    placement.
    """
    label, order = obj.Label, obj.ElementsOrder
    lists = {name: getattr(obj, name) for name in ARRAYS}

    def make():
        arrays = {array: np.array(lists[name], dtype=np.float64)
                  for name, array in ARRAYS.items()}
        for name, width in (("nodes", 3), ("node_entity", 2)):
            if len(arrays[name]) % width:
                raise InvalidInput(f"{label} holds {len(arrays[name])} numbers as {name}, not {width} for each "
                                   "node: update it")
        if motion is not None:
            arrays["nodes"] = convert.moved(arrays["nodes"].reshape(-1, 3), motion).ravel()
        return CurvedMesh(extension().curved_from_arrays(order, arrays), measured=False)

    return make


def lists_of(curved):
    """{property: list} of a CurvedMesh, as store_in needs it; any thread may make them."""
    return {name: convert.lists(getattr(curved._curved, array).ravel()) for name, array in ARRAYS.items()}


def store_in(obj, curved, lists):
    """Puts a CurvedMesh into the properties of a document object, from which loader_of makes it again."""
    for name, values in lists.items():
        setattr(obj, name, values)
    obj.ElementsOrder = curved.order


# Options of curve that are for meshes that it makes itself.
_OF_STRAIGHT_MESH = ("min_angle", "chord_height", "chord_height_relative", "max_edge")


def _require_no_straight_options(values):
    usual = options.check(options.CURVE, {})
    given = [name for name in _OF_STRAIGHT_MESH if values[name] != usual[name]]
    if given:
        raise InvalidInput(f"{given[0]} is for a mesh that is made, not for one that is given: leave it out with mesh=")


def _check_given(mesh, mesh_scale, values, shape):
    """Refuses options of the straight mesh if `mesh` is given, and options of a given mesh if none is."""
    if mesh is None:
        if mesh_scale != 1.0:
            raise InvalidInput("mesh_scale= is for a mesh that another program made: give its path as mesh=")
        return
    _require_no_straight_options(values)
    if shape is not None:
        raise InvalidInput("shape= is that of a SurfaceMesh: with mesh= give the shape as first argument")


def _check_field(size_field, mesh, source):
    if size_field is not None and (mesh is not None or isinstance(source, SurfaceMesh)):
        raise InvalidInput("size_field is for a mesh that is made, not for one that is given: leave it out")


def _given_on(shape, mesh, mesh_scale):
    return fem_places.mesh_at(mesh, shape) if frames.is_object(mesh) else given_mesh(mesh, mesh_scale)


def _curve_given(shape, mesh, curving, imprint, division, progress):
    """The CurvedMesh of an ElementMesh; the CurvedElementMesh where it has other elements than simplices."""
    module, solids = extension(), len(shape.Solids)
    if not simplex_arrays.is_mixed(mesh):
        curved = module.curve_given(*simplex_arrays.corners_of(mesh, solids), shape, curving, imprint, progress)
        return CurvedMesh(curved, patches=kept(division, curved))
    if division is not None:
        raise InvalidInput("patches are of meshes of triangles and tetrahedra: leave them out, elements of other kinds have "
                           "a group for each face")
    found = module.curve_mixed(*simplex_arrays.blocks_of(mesh, solids), shape, curving, imprint, progress)
    return curved_elements.of_core(found, curving.order, mesh)


def _curved(source, curving, straight, size_field, progress):
    """The Curved of the core of a shape, after a size field if there is one, and sentences on that."""
    live_shape = convert.shape_of(source)
    sampling = size_fields.Sampling.of(source, size_field, progress)
    if sampling is None:
        return extension().curve(live_shape, curving, straight, progress), []
    sampling.require_affordable(None)

    def make(field):
        straight.size_field = curving.size_field = field
        return extension().curve(live_shape, curving, straight, progress)

    return size_fields.meshed(sampling, make, size_fields.curved_edges)


@options.takes_aliases(options.CURVE)
def curve(shape_or_mesh, order=2, volume=False, progress=None, straighten_invalid=False, shape=None,
          min_angle=20.0, chord_height=None, chord_height_relative=None, max_edge=None, imprint=False, overlap="refuse",
          patches=None, patch_rest=None, mesh=None, mesh_scale=1.0, threads=0, size_field=None):
    """A mesh of curved elements on a shape, proven valid element by element.

    shape_or_mesh  Part.Shape, a document object that has one, or a SurfaceMesh together with
                   `shape`, from which it was made
    order          of the elements: 1 to 5, volumes 1 to 4
    volume         fill the solids with tetrahedra
    straighten_invalid
                   make elements straight that stay invalid after all repairs
    min_angle, chord_height, chord_height_relative, max_edge
                   of the straight mesh that is curved, as for triangulate; where neither chord
                   height is given it is 0.01 of the largest dimension
    imprint        solids that share an area have the same elements there, so that a mesh of an assembly is conforming
    overlap        bodies that overlap or cross are a fault in certificates: "refuse", or none: "allow"
    progress       callable(fraction 0..1, stage); returning False cancels
    patches, patch_rest
                   named groups of faces, as for triangulate; of a SurfaceMesh that has patches these are the default
    mesh           a mesh that another program made of the shape: an ElementMesh, or the path of a file that
                   mq.read_mesh takes. It is found on the CAD and curved; vertices and connectivity stay unless elements
                   would be invalid: then given_node, given_element and moved_nodes of the result say what changed. One
                   with prisms, pyramids, hexahedra or quadrilaterals keeps all of its elements, and its boundary layers
                   follow their walls. volume, patches and the options of the straight mesh do not apply
    mesh_scale     factor from the coordinates of that file to mm: 1000 for one in metres, 25.4 for inches
    threads        that work at a time; 0: MESHQUALITY_THREADS, or one for each core. The result is the same for any number
    size_field     edge lengths in mm by place, on the surface and inside, as for triangulate; see report.size_ratio

    Returns a CurvedMesh, or a CurvedElementMesh if a mesh has other elements than triangles and tetrahedra; its report
    has the elements that stay invalid. The shape is only read.
    Raises InvalidInput, TopologyError, GeometryError naming the sub-element; Cancelled.
    """
    options.require_callable(progress)
    values = options.check(options.CURVE, {
        "order": order, "volume": volume, "straighten_invalid": straighten_invalid, "min_angle": min_angle,
        "chord_height": chord_height, "chord_height_relative": chord_height_relative, "max_edge": max_edge, "imprint": imprint,
        "overlap": overlap,
    })
    values["threads"] = options.THREADS.checked(threads)
    _check_given(mesh, mesh_scale, values, shape)
    _check_field(size_field, mesh, shape_or_mesh)
    source, module = shape_or_mesh if shape is None else shape, extension()
    division = None if isinstance(source, SurfaceMesh) else division_for(source, patches, patch_rest)
    left_out, said = hidden_parts.sentences_of(source), []
    curving = module.CurveOptions()
    options.hand_over({name: values.pop(name) for name in ("order", "volume", "straighten_invalid", "threads")}, curving)
    if mesh is not None:
        elements = _given_on(shape_or_mesh, mesh, mesh_scale)
        return _curve_given(convert.shape_of(shape_or_mesh), elements, curving, values["imprint"], division, progress)
    if isinstance(shape_or_mesh, SurfaceMesh):
        if shape is None:
            raise InvalidInput("a SurfaceMesh is curved to the shape it was made from: give shape=")
        if division is None and shape_or_mesh._patches is not None:
            division = shape_or_mesh._patches.division
        curved = module.curve_surface(shape_or_mesh._surface, convert.shape_of(shape), curving, progress)
    else:
        straight = module.TriangulateOptions()
        options.hand_over({name: value for name, value in values.items() if name not in ("overlap", "size_field")}, straight)
        curved, said = _curved(shape_or_mesh, curving, straight, size_field, progress)
    return hidden_parts.noted(CurvedMesh(curved, patches=kept(division, curved)), [*left_out, *said])
