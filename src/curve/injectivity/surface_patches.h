// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "curve/bezier/simplex_lattice.h"
#include "curve/elements/element_kind.h"
#include "curve/injectivity/patch_pair.h"

namespace mq::curve {

/// Pieces of curved triangles smaller than this share of the mesh's size are not halved any more.
constexpr double kLeastPiece = 1e-6;
/// What is within this share of the mesh's size of a plane counts as on it.
constexpr double kTouching = 1e-9;

/// Sides of elements: triangles or quadrilaterals of one order, with their nodes in Gmsh's order, one side after the
/// other.
struct SideBlock {
    ElementKind kind = ElementKind::Triangle;
    int order = 1;
    int nodes_per_side = 3;
    std::vector<std::int32_t> nodes;
};

/// The Bezier triangles, of one degree, that curved sides of elements are made of: each triangle is one, raised to that
/// degree; each quadrilateral is two of twice its order.
///
/// Control points are about the middle of the mesh, where rounding errors are least. Nodes of equal coordinates are one
/// node.
class SurfacePatches {
  public:
    /// @throws InvalidInput where the numbers do not fit together, or a coordinate is not finite
    SurfacePatches(const std::vector<Vec3>& nodes, const std::vector<SideBlock>& blocks);

    std::size_t size() const { return patches_.size(); }
    /// Sides, numbered from block to block.
    std::size_t sides() const { return side_nodes_.size(); }
    const Lattice& lattice() const { return *lattice_; }
    const Vec3& middle() const { return middle_; }
    const std::vector<Vec3>& control(std::int32_t t) const { return patch(t).control; }
    /// The side that a patch is of.
    std::int32_t side(std::int32_t t) const { return patch(t).side; }
    double rounding() const { return limits_.rounding; }

    /// Whether two patches are of different sides with the same nodes.
    bool lie_on_each_other(std::int32_t a, std::int32_t b) const;
    /// How two patches meet, or a patch itself.
    PatchVerdict contact(std::int32_t a, std::int32_t b, int most_pairs) const;

  private:
    struct Patch {
        std::vector<Vec3> control;
        std::array<std::int32_t, 3> corners;
        std::int32_t side;
    };

    const Patch& patch(std::int32_t t) const { return patches_[static_cast<std::size_t>(t)]; }
    void add(const SideBlock& block, const std::vector<std::int32_t>& row, std::vector<Vec3> nodes);
    void find_bodies(const std::vector<SideBlock>& blocks);
    SharedEntities shared(std::int32_t a, std::int32_t b) const;
    bool share_edge(const Patch& a, const Patch& b, const std::array<int, 2>& from, const std::array<int, 2>& to) const;

    const Lattice* lattice_;
    Vec3 middle_ = Vec3::Zero();
    PatchLimits limits_;
    std::vector<Patch> patches_;
    std::vector<std::vector<std::int32_t>> side_nodes_;  ///< in ascending order
    std::vector<std::int32_t> body_;                     ///< by side
};

}  // namespace mq::curve
