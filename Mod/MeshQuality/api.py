# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripting functions that need FreeCAD; the package hands them out under its own name."""

from . import convert, options
from .compat import core
from .errors import InvalidInput
from .surface_mesh import SurfaceMesh


@options.takes_aliases(options.TRIANGULATE)
def triangulate(shape, min_angle=25.0, chord_height=None, chord_height_relative=None,
                max_edge=None, min_edge=None, method="refine", max_triangles=None,
                progress=None, insertion="off-centre", allow_missing_faces=False,
                connectivity="pseudo-delaunay", refine_samples=True, seed=0, local_sizes=None,
                edges_per_circle=None, growth_rate=None, keep_edges="all", feature_angle=10.0,
                memory=None):
    """A triangle mesh of a shape with a guaranteed smallest angle and a bound on its distance.

    shape                  Part.Shape with faces, or a document object that has one
    min_angle              degrees, 0 < min_angle <= 34
    chord_height           mm; largest distance to the shape; "none": no bound
    chord_height_relative  the same as a fraction of the largest dimension; give one of the two, or
                           neither for 0.003 of the largest dimension
    max_edge, min_edge     mm; None: no bound
    local_sizes            {"Face3": 0.5, "Edge7": 0.2, "Vertex1": 0.1}: longest edges in mm of the
                           triangles on a face, along an edge, around a vertex; of a container or link
                           also {"Box.Face3": 0.5}, with the names of the objects on the way
    edges_per_circle       smallest number of edges for each full turn of a curve or a surface, 3 to 10000
    growth_rate            growth rate of edge length from fine to coarse regions, greater than 1;
                           None: as fast as the angles allow
    method                 "refine"; "star" and "sprinkle" sample the faces by their curvature first
    max_triangles          the work ends incomplete at this number; None: 5 million
    progress               callable(fraction 0..1, stage); returning False cancels
    insertion              where a triangle with a small angle gets its new point: "off-centre" needs
                           fewer triangles, "circumcentre" is the rule of Aftosmis 1999
    keep_edges             "all": the mesh follows every edge of the shape; "feature": not those that
                           the surface crosses smoothly, so that tiny edges and slivers between such
                           edges cost no triangles; report.spanning then names the triangles that
                           lie on several faces
    feature_angle          degrees, at most 40: an edge is smooth where the surface turns by less than
                           this all along
    allow_missing_faces    mesh the other faces where some fail, and name those in the report

    connectivity           of star and sprinkle: samples are joined in space ("pseudo-delaunay") or in
                           the faces' parameters ("parametric")
    refine_samples         of star and sprinkle: refine afterwards, so that the bounds hold
    seed                   of sprinkle's random points

    memory                 a Memory of earlier calls: what an edit left alone keeps its triangles

    Returns a SurfaceMesh. The shape is only read.
    Raises InvalidInput, TopologyError, GeometryError naming the sub-element; Cancelled.
    """
    values = options.check(options.TRIANGULATE, {
        "min_angle": min_angle, "chord_height": chord_height,
        "chord_height_relative": chord_height_relative, "max_edge": max_edge,
        "min_edge": min_edge, "method": method, "insertion": insertion,
        "max_triangles": max_triangles, "allow_missing_faces": allow_missing_faces,
        "connectivity": connectivity, "refine_samples": refine_samples, "seed": seed,
        "local_sizes": local_sizes, "edges_per_circle": edges_per_circle, "growth_rate": growth_rate,
        "keep_edges": keep_edges, "feature_angle": feature_angle,
    })
    require_callable(progress)
    live_shape = convert.shape_of(shape)
    values = convert.with_resolved_sizes(shape, values)
    module = core()
    core_options = module.TriangulateOptions()
    core_options.local_sizes = options.entities_of(values.pop("local_sizes"))
    options.hand_over(values, core_options)
    return SurfaceMesh(module.triangulate(live_shape, core_options, progress, _held(memory)))


class Memory:
    """What the last calls of triangulate leave for the next ones, while a shape is edited.

    The same shape with the same options as in one of them gets the same mesh. Else faces of the same
    geometry start with the triangles that they had, where the options are the same: the guarantees are
    the same, but the triangles depend on what was remembered. report.reused_faces says how many faces
    kept all of theirs. No face is remembered by star and sprinkle, nor with keep_edges="feature".
    Not saved; about 250 bytes a triangle.

    most_runs   of more calls, those go that were used least lately
    most_bytes  the same of their bytes, in all
    """

    def __init__(self, most_runs=8, most_bytes=2**29):
        for name, value in (("most_runs", most_runs), ("most_bytes", most_bytes)):
            if not isinstance(value, int) or not 0 <= value < 2**63:
                raise InvalidInput(f"{name} = {value!r} is not allowed: it must be a whole number, "
                                   "at least 0 and less than 2^63")
        self.held = core().Memory(most_runs, most_bytes)

    def __len__(self):
        """How many calls it holds."""
        return self.held.runs

    @property
    def bytes(self):
        """What it takes, about."""
        return self.held.bytes

    def __repr__(self):
        calls = "1 call" if len(self) == 1 else f"{len(self)} calls"
        return f"<Memory: {calls} of triangulate, {self.bytes / 2**20:.1f} MiB>"


def _held(memory):
    if memory is not None and not isinstance(memory, Memory):
        raise InvalidInput(f"memory is {memory!r}: give a MeshQuality.Memory")
    return None if memory is None else memory.held


def improve(mesh, min_angle=25.0, tolerance=None, feature_angle=35.0, progress=None):
    """The same surface with better triangles, for a mesh that has no CAD behind it.

    mesh           Mesh.Mesh, Mesh feature, SurfaceMesh, or arrays (V, F); it need not be closed
    min_angle      degrees, 0 < a <= 34: what the smallest angle of every triangle is to reach
    tolerance      mm: the surface changes only where corners, edge middles and centres of the new
                   triangles stay within it of the surface given, and the vertices given within it
                   of the new surface; a thousandth of the largest dimension unless given
    feature_angle  degrees: edges where the surface turns by more than this stay, borders too
    progress       as for triangulate

    Returns a SurfaceMesh; report.exempt names the triangles that stay below min_angle, and why.
    Raises InvalidInput for a mesh with a triangle that names a vertex twice; Cancelled.
    """
    values = options.check(options.IMPROVE, {
        "min_angle": min_angle, "tolerance": tolerance, "feature_angle": feature_angle})
    require_callable(progress)
    module = core()
    core_options = module.ImproveOptions()
    options.hand_over(values, core_options)
    return SurfaceMesh(module.improve(_surface_of(mesh, measured=False), core_options, progress))


def _surface_of(mesh, measured=True):
    """The core's Surface of anything that is a mesh; raises InvalidInput."""
    module = core()
    if isinstance(mesh, SurfaceMesh):
        return mesh._surface
    if convert.is_mesh(mesh):
        return convert.surface_of_arrays(module, *convert.arrays_of_mesh(mesh), measured=measured)
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return convert.surface_of_arrays(module, *mesh, measured=measured)
    raise InvalidInput("a Mesh.Mesh, a SurfaceMesh or arrays (V, F) are needed, not "
                       f"{type(mesh).__name__}")


def quality(mesh, shape=None, progress=None):
    """The MeshReport of a mesh: a Mesh.Mesh, a Mesh feature, a SurfaceMesh, or arrays (V, F).

    With `shape` (Part.Shape or document object) the report also has max_chord_height, the largest
    distance from the shape's faces of the triangles' corners, edge middles and centroids, and of points
    inside large triangles, measured apart from what the mesher measures; progress as for triangulate.
    Raises InvalidInput for anything else and for indices out of range.
    """
    surface = _surface_of(mesh)
    if shape is None:
        return surface.report
    require_callable(progress)
    return core().measure_against(surface, convert.shape_of(shape), progress)


def require_callable(progress):
    """Raises InvalidInput unless the progress is None or can be called."""
    if progress is not None and not callable(progress):
        raise InvalidInput(f"progress = {progress!r} is not callable: give a function of "
                           "(fraction, stage)")


def add_quality_mesh(source, **values):
    """Adds a document object that keeps a quality mesh of `source` up to date; one undo step.

    source   document object with a shape: feature, body, link or container
    values   the options of triangulate, except progress

    Returns the object. Raises what triangulate raises, and then adds nothing.
    """
    from .features import quality_mesh

    return quality_mesh.add(source, values)


def update(obj, progress=None, **values):
    """Brings a document object of this package up to date, with changed options; one undo step.

    obj       of add_quality_mesh, add_curved_mesh, add_boolean or add_improved_mesh
    progress  callable(fraction 0..1, stage); returning False cancels
    values    options to change; the others stay as they are, but a bound on the distance replaces the
              one that was there

    Raises what adding such an object raises, and then leaves it as it was; Error where progress has
    removed it, closed its document or changed what it is made of.
    """
    from .features import mesh_object

    require_callable(progress)
    mesh_object.update(obj, values, progress)


def add_improved_mesh(source, **values):
    """Adds a document object that keeps a mesh with better triangles than `source`; one undo step.

    source   document object with a mesh
    values   the options of improve, except progress

    Returns the object. Raises what improve raises, and then adds nothing.
    """
    from .features import improved_mesh

    return improved_mesh.add(source, values)
