// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "curve/surface/curved_surface.h"
#include "curve/volume/tetrahedral_mesh.h"
#include "mesh/io/export_mesh.h"
#include "mesh/io/output.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::curve {

/// Measurements of the curved mesh, and counts of its repairs.
struct CurveReport {
    std::size_t elements = 0;
    std::size_t vertices = 0;
    std::size_t invalid_before = 0;  ///< elements invalid right after curving, before any repair
    std::size_t invalid = 0;         ///< invalid elements of the final mesh, tetrahedra and boundary triangles
    std::vector<std::string> invalid_elements;  ///< "triangle 3 on Face1": numbers as in the lists of the mesh
    std::vector<std::string> straightened;      ///< elements that were made straight, named likewise
    double min_scaled_jacobian = 0.0;           ///< min over the elements of min J / J of the straight element
    double min_distortion = 0.0;                ///< min over the elements of I = min J / max J, equation (3)
    double mean_distortion = 0.0;
    double max_shape_distortion = 0.0;  ///< largest eta of the elements, see curve/distortion.h; 0 without elements
    double max_deviation = 0.0;         ///< largest distance of boundary triangles from their CAD faces, mm
    double rms_deviation = 0.0;
    double volume = 0.0;              ///< volume that the curved triangles enclose, mm^3; 0 without a solid
    double cad_volume = 0.0;          ///< volume of the model's solids, mm^3; 0: unknown
    double cad_volume_error = 0.0;    ///< how far it may be off, mm^3 (geometry/occt/solid_volume.h)
    std::size_t moved_vertices = 0;   ///< corner vertices that left their places in the straight mesh
    double chord_height_asked = 0.0;  ///< largest deviation that was requested, mm; 0: none
    /// Pairs of curved triangles that are proven to cross, and those that are neither proven to cross nor to be apart
    /// (injectivity/curved_crossings.h); -1: not looked for.
    std::int64_t curved_intersections = -1;
    std::int64_t not_proven_apart = -1;
    std::int64_t curved_overlaps = -1;  ///< pairs that cross and belong to different bodies, which share no node
    mesh::MeshReport straight;          ///< report of the mesh that was curved
    std::vector<std::pair<std::string, std::size_t>> repairs;
    std::vector<std::string> notes;
    StageTimes seconds;
    double cpu_seconds = 0.0;

    /// |volume - cad_volume| / cad_volume; -1: unknown.
    double volume_error() const;
};

/// The result: nodes, and elements of one order in Gmsh's node order.
struct CurvedMesh {
    int order = 1;
    std::vector<Vec3> nodes;                      ///< the corner vertices come first
    std::vector<mesh::VertexEntity> node_entity;  ///< dimension 0 to 3 and index
    std::size_t vertices = 0;                     ///< how many of the nodes are corners
    /// Flat lists with a fixed number of nodes for each element.
    std::vector<std::int32_t> edges;  ///< mesh edges on CAD edges
    std::vector<std::int32_t> edge_entity;
    std::vector<std::int32_t> triangles;  ///< on CAD faces
    std::vector<std::int32_t> triangle_face;
    /// By triangle: the CAD face of the solid on its other side, where two solids touch; -1: none. Empty where none
    /// do.
    std::vector<std::int32_t> triangle_face_behind;
    std::vector<std::int32_t> tetrahedra;  ///< empty unless `volume` is set
    std::vector<std::int32_t> tetrahedron_volume;
    /// By triangle: lower bound of min / max of the normal component, against the CAD; not positive: invalid.
    std::vector<double> triangle_quality;
    /// By tetrahedron: lower bound of min J / J of the straight element; not positive: invalid.
    std::vector<double> tetrahedron_quality;
    /// Data on a mesh that another program made (given/curve_given.h), else empty: by corner, the given node; by
    /// element (by tetrahedron if there are any), the given element with the same corners; -1: none. The given nodes
    /// that moved.
    std::vector<std::int32_t> given_node;
    std::vector<std::int32_t> given_element;
    std::vector<std::int32_t> moved_nodes;
    mesh::TriangleMesh straight;  ///< the mesh that was curved; empty where that is not known
    CurveReport report;

    int nodes_per_edge() const { return Lattice::of(1, order).size(); }
    int nodes_per_triangle() const { return Lattice::of(2, order).size(); }
    int nodes_per_tetrahedron() const { return Lattice::of(3, order).size(); }
};

/// By triangle: a tetrahedron that it is a face of, the one of lowest index; -1 where there is none.
std::vector<std::int32_t> tetrahedra_behind(const CurvedMesh& mesh);

/// Numbers the nodes of a surface and of the tetrahedra in it, and lists all elements. Vertices no element uses are
/// left out.
/// @param number  gets the node of each vertex of the surface, -1 where it is left out
CurvedMesh assemble(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra,
                    std::vector<int>* number = nullptr);

/// Changes the entities from pieces of faces that are cut along creases to those of the original shape
/// (Topology::of_shape). Creases are no elements then.
void classify_on_original_entities(CurvedMesh& mesh, const geometry::Topology& topology);

/// Checks the conditions on which the functions below rely, for a mesh of another program: a supported order, finite
/// nodes of a size that SinglePrecisionGrid accepts, known entities, elements with complete rows of known nodes and one
/// entity each, and one quality each or none.
/// @throws InvalidInput naming the list that is wrong.
void require_sound(const CurvedMesh& mesh);

/// The mesh as writers see it, with its patches; without any each face is one by its own name, as are edges and solids.
/// @throws InvalidInput where there is not one patch for each triangle
mesh::ExportMesh exported(const CurvedMesh& mesh, const mesh::Patches& patches = {}, double scale = 1.0);

/// A text of a dozen lines for people.
std::string to_text(const CurveReport& report);

}  // namespace mq::curve
