// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "layered_depth/reconstruction/retained_surface.h"
#include "layered_depth/samples/combine_samples.h"

namespace mq::layered_depth {

/// The kinds of leaves with IR-samples (Wang 2010, section III-A). IR-samples are samples of the result whose triangle
/// is not retained.
enum class CellKind : std::uint8_t {
    Interior,      ///< all samples are IR-samples, or the cell has no border edge
    SingleEdge,    ///< simple boundary cell with one border edge that passes through
    SharedVertex,  ///< simple boundary cell with two border edges and their shared vertex
    Complex,       ///< any other boundary cell
};

/// A border edge within a leaf.
struct CellEdge {
    std::int32_t edge;  ///< index into RetainedSurface::border
    double from, to;    ///< parameters where it enters and leaves the cell, 0 <= from <= to <= 1
};

/// One sheet of the surface in a leaf, which gets one vertex. A leaf wider than r has one sheet.
struct Sheet {
    Vec3 minimiser = Vec3::Zero();  ///< minimiser of the quadratic error function, within the cell; grid coordinates
    /// A triangle of each CAD face that has samples on the sheet, up to three; -1 in unused entries. All are -1 if a
    /// sample has no CAD face, or if more than three faces have samples.
    std::array<std::int32_t, 3> face_triangles{-1, -1, -1};
};

struct Leaf {
    std::array<std::int16_t, 3> low{};  ///< lowest corner
    std::int16_t size = 1;              ///< side; this and `low` in grid units
    CellKind kind = CellKind::Interior;
    std::uint32_t first_edge = 0, end_edge = 0;  ///< range in Octree::edges
    std::int32_t first_sheet = 0;                ///< index into Octree::sheets
    /// In a boundary cell the sheet with both IR- and retained samples, which takes its vertex from the border; -1 in
    /// other cells.
    std::int32_t border_sheet = -1;
    std::array<std::uint8_t, 12> sheet_of_edge{};  ///< by edge of the leaf: its sheet in the leaf, see CellSheets

    /// Whether a point in grid coordinates belongs to this cell; every point belongs to one leaf.
    bool holds(const Vec3& g) const {
        return (g.array() >= Vec3(low[0], low[1], low[2]).array()).all() &&
               (g.array() < Vec3(low[0] + size, low[1] + size, low[2] + size).array()).all();
    }
};

/// The octree over the IR-samples. The edges of its cells lie on rays.
class Octree {
  public:
    std::vector<Leaf> leaves;  ///< the leaves with IR-samples
    std::vector<Sheet> sheets;
    std::vector<CellEdge> edges;

    /// The leaf that contains the unit cell (x, y, z); -1 if it has no IR-samples. `size` is set only for leaves with
    /// IR-samples.
    std::int32_t leaf_at(int x, int y, int z) const;

  private:
    friend class OctreeBuilder;
    std::vector<std::int32_t> nodes_;  // index of the first of eight children; -1: no IR-samples; -2 - leaf
    int levels_ = 0;
};

/// Builds the octree top down (Procedures 1 and 2). A cell with IR-samples that is wider than r is split in these
/// cases: it is face- or voxel-ambiguous; an edge has more than one sample; it is, or has a face that is, a fake solid
/// or empty volume; its vertex (the minimiser, or the point on the border) lies farther than 0.1 r from a sample's
/// plane; the border in it is not simple.
///
/// Beyond the paper, a leaf of width r through which several sheets of the surface pass has a vertex for each of them
/// (as in Schaefer, Ju and Warren 2007), so that thin walls and narrow gaps stay 2-manifold.
/// @param most_at_a_time above this number of samples of the result the octree is built in four passes, one quarter of
/// the grid each, so that the octree's own copies of samples (16 bytes each) take a fraction of the memory; the octree
/// is the same
/// @throws Cancelled
Octree build_octree(const OperandSet& pair, const SampleGrid& grid, const CombinedSet& combined,
                    const std::vector<Retention>& fate, const RetainedSurface& retained, Progress* progress,
                    std::size_t most_at_a_time = std::size_t{1} << 24);

}  // namespace mq::layered_depth
