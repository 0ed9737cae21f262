# SPDX-License-Identifier: LGPL-2.1-or-later
"""triangulate, and the cache by which it follows edits."""

from .. import element_names, options
from ..compat import extension
from ..errors import InvalidInput
from ..listing import Public
from .brep.construction import Construction
from .meshes.surface_mesh import SurfaceMesh
from .patches.patches import division_for, kept
from .sources import convert
from .sources import hidden_parts
from .sizes import size_field as size_fields
from .stretching import forms as metric_forms
from .stretching import stretch

# Options that say how long edges are to be, or let triangles lie on several faces.
_NOT_WITH_METRIC = ("size_field", "local_sizes", "edges_per_circle", "growth_rate", "imprint", "keep_edges", "method")


@options.takes_aliases(options.TRIANGULATE, memory="cache")
def triangulate(shape, min_angle=25.0, chord_height=None, chord_height_relative=None, max_edge=None, min_edge=None,
                method="refine", max_triangles=None, progress=None, insertion="off-centre", order="rounds",
                allow_missing_faces=False, connectivity="pseudo-delaunay", refine_samples=True, seed=0, local_sizes=None, size_field=None,
                edges_per_circle=None, growth_rate=None, keep_edges="all", feature_angle=10.0, corners="auto", cache=None,
                sew=True, imprint=False, overlap="refuse", evaluation="fast", patches=None, patch_rest=None, threads=0, metric="none",
                max_stretching=5.0):
    """A triangle mesh of a shape with a guaranteed smallest angle and a bound on its distance.

    shape                  Part.Shape with faces, or a document object that has one
    min_angle              degrees, 0 < min_angle <= 34
    chord_height           mm; largest distance to the shape; "none": no bound
    chord_height_relative  the same as a fraction of the largest dimension; give one of the two, or neither for 0.003
    max_edge, min_edge     mm; None: no bound
    local_sizes            {"Face3": 0.5, "Edge7": 0.2, "Vertex1": 0.1}: longest edges in mm of the
                           triangles on a face, along an edge, around a vertex; of a container or link
                           also {"Box.Face3": 0.5}, with the names of the objects on the way
    size_field             edge lengths in mm by place: a function, points, files, regions, a list of these; see docs/use/sizes.md
    edges_per_circle       smallest number of edges for each full turn of a curve or a surface, 3 to 10000
    growth_rate            growth rate of edge length from fine to coarse regions, over 1; None: as fast as angles allow
    method                 "refine"; "star" and "sprinkle" sample the faces by their curvature first
    max_triangles          the work ends incomplete at this number; None: 5 million
    progress               callable(fraction 0..1, stage or "waits for ..."); returning False cancels
    insertion              where a triangle with a small angle gets its new point: "off-centre" needs
                           fewer triangles, "circumcentre" is the rule of Aftosmis 1999
    order                  of these triangles: "rounds", which threads share, or "worst first", one by one (Aftosmis 1999)
    keep_edges             "all": the mesh follows every edge of the shape; "feature": not those that the surface crosses
                           smoothly, so that tiny edges and slivers between such edges cost no triangles;
                           report.spanning then names the triangles that lie on several faces
    feature_angle          degrees, at most 40: an edge is smooth where the surface turns by less than this all along
    corners                "cut": narrow ones of faces are cut off, by 1 / 20 of the distance asked for; "auto": at pinches, and where they need it; "keep"
    allow_missing_faces    mesh the other faces where some fail, and name those in the report
    sew                    join faces without a shell, within a tenth of the distance or length asked for
    imprint                solids that share an area get the same triangles on both sides; see report.contacts
    overlap                bodies that overlap or cross are a fault in certificates: "refuse", or none: "allow"
    evaluation             of curves and surfaces: "fast" by formulas and polynomial pieces; "native" by OpenCASCADE alone
    connectivity           of star and sprinkle: samples are joined in space ("pseudo-delaunay") or in (u, v) ("parametric")
    refine_samples         of star and sprinkle: refine afterwards, so that the bounds hold
    seed                   of sprinkle's random points
    cache                  a MeshCache of earlier calls: faces that an edit left alone keep their triangles
    patches                named groups of faces for the files of solvers: {"inlet": ["Face1", "Box.Face4"], ...}, or
                           {"inlet": {"faces": ["Face1"], "colour": "#ff0000"}}; names as in local_sizes. They are
                           checked before the work, kept as mesh.patches, and are the default of mesh.write
    patch_rest             name of the patch of all other faces; None: each is one by its own name
    metric, max_stretching  stretched triangles, by "curvature" or a metric of your own, and how much, 1 to 100; see docs/use/sizes.md
    threads                at a time; 0: MESHQUALITY_THREADS, or one for each core. The result is the same for any number

    Returns a SurfaceMesh; with a metric a StretchedMesh. The shape is only read.
    Raises InvalidInput, TopologyError, GeometryError naming the sub-element; Cancelled.
    """
    values = options.check(options.TRIANGULATE, {
        "min_angle": min_angle, "chord_height": chord_height, "chord_height_relative": chord_height_relative, "max_edge": max_edge,
        "min_edge": min_edge, "method": method, "insertion": insertion, "order": order, "max_triangles": max_triangles,
        "allow_missing_faces": allow_missing_faces, "connectivity": connectivity, "refine_samples": refine_samples, "seed": seed,
        "local_sizes": local_sizes, "edges_per_circle": edges_per_circle, "growth_rate": growth_rate, "keep_edges": keep_edges,
        "feature_angle": feature_angle, "corners": corners, "sew": sew, "imprint": imprint, "overlap": overlap, "evaluation": evaluation,
        "metric": metric if isinstance(metric, str) else metric_forms.NONE, "max_stretching": max_stretching,
    })
    values["threads"] = options.THREADS.checked(threads)
    options.require_callable(progress)
    return _made(shape, values, metric, size_field, progress, cache, division_for(shape, patches, patch_rest))


def _made(shape, values, metric, size_field, progress, cache, division):
    """The SurfaceMesh of a shape with checked options; with a metric the StretchedMesh."""
    chosen, stretching = values.pop("metric"), values.pop("max_stretching")
    form = chosen if metric is None or isinstance(metric, str) else metric
    if isinstance(form, str) and form == metric_forms.NONE:
        return _meshed(shape, values, size_field, progress, cache, division)
    return _stretched(shape, values, size_field, form, stretching, progress, cache, division)


def _stretched(shape, values, size_field, form, stretching, progress, cache, division):
    """The StretchedMesh of a shape with checked options, of a quality mesh with the shortest lengths that the metric wants."""
    for option in options.TRIANGULATE:
        if option.name in _NOT_WITH_METRIC and (size_field if option.is_fields else values[option.name]) != option.default:
            raise InvalidInput(f"{option.name} does not go with metric, which says how long edges are to be: leave one of the two out")
    box = convert.shape_of(shape).BoundBox
    longest = values["max_edge"] / stretch.LONGEST if values["max_edge"] else max(box.XLength, box.YLength, box.ZLength)
    given = None if isinstance(form, str) else metric_forms.Given(form, longest, stretching)
    if values["corners"] == "auto":
        values = {**values, "corners": "keep"}
    mesh = _meshed(shape, values, given and given.shortest, progress, cache, None)
    metric = given or metric_forms.Curvature.of(mesh.report.chord_height_asked, longest, stretching)
    found, said = stretch.stretched(mesh, convert.shape_of(shape), metric, progress)
    found._patches = kept(division, found)
    return hidden_parts.noted(found, [*(note for note in mesh.report.notes if note not in found.report.notes), *said])


def _meshed(shape, values, size_field, progress, cache, division):
    """The SurfaceMesh of a shape with checked options."""
    live_shape = convert.shape_of(shape)
    values = convert.with_resolved_sizes(shape, values)
    module = extension()
    core_options = module.TriangulateOptions()
    overlap, _ = values.pop("overlap"), values.pop("size_field")
    core_options.local_sizes = element_names.entities_of(values.pop("local_sizes"))
    options.hand_over(values, core_options)
    left_out = hidden_parts.sentences_of(shape)
    sampling = size_fields.Sampling.of(shape, size_field, progress, inside=False)

    def make(field):
        core_options.size_field = field
        return module.triangulate(live_shape, core_options, progress, _core_cache(cache))

    if sampling is None:
        surface, said = make(None), []
    else:
        sampling.require_affordable(values["max_triangles"])
        surface, said = size_fields.meshed(sampling, make, size_fields.surface_edges)
    return hidden_parts.noted(SurfaceMesh(surface, kept(division, surface), overlap, Construction((live_shape,))), [*left_out, *said])


class MeshCache(metaclass=Public):
    """Meshes of the last calls of triangulate, for the next calls while a shape is edited.

    The same shape with the same options as in one of them gets the same mesh. Otherwise faces of the same
    geometry start with the triangles that they had, if the options are the same: the guarantees are
    the same, but the triangles depend on what is cached. report.reused_faces says how many faces
    kept all of their triangles. No face is cached by star and sprinkle, nor with keep_edges="feature".
    Not saved; about 250 bytes a triangle.

    most_runs   largest number of calls in the cache; the least recently used ones are evicted
    most_bytes  largest size of all of them, in bytes
    """

    def __init__(self, most_runs=8, most_bytes=2**29):
        for name, value in (("most_runs", most_runs), ("most_bytes", most_bytes)):
            if not isinstance(value, int) or not 0 <= value < 2**63:
                raise InvalidInput(f"{name} = {value!r} is not allowed: it must be a whole number, "
                                   "at least 0 and less than 2^63")
        self._core_cache = extension().MeshCache(most_runs, most_bytes)

    def __len__(self):
        """How many calls it holds."""
        return self._core_cache.runs

    @property
    def bytes(self):
        """About how many bytes it holds."""
        return self._core_cache.bytes

    def __repr__(self):
        calls = "1 call" if len(self) == 1 else f"{len(self)} calls"
        return f"<MeshCache: {calls} of triangulate, {self.bytes / 2**20:.1f} MiB>"


def _core_cache(cache):
    if cache is not None and not isinstance(cache, MeshCache):
        raise InvalidInput(f"cache is {cache!r}: give a MeshQuality.MeshCache")
    return None if cache is None else cache._core_cache
