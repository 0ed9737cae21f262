// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "curve/injectivity/patch_pair.h"
#include "elements/bezier/simplex_lattice.h"
#include "elements/product/element_kind.h"

namespace mq::curve {

/// Smallest pieces of curved triangles that are halved, as a fraction of the mesh's size.
constexpr double kLeastPiece = 1e-6;
/// Points within this fraction of the mesh's size from a plane count as on it.
constexpr double kTouching = 1e-9;

/// Sides of elements: triangles or quadrilaterals of one order, with the nodes of one side after those of another, in
/// Gmsh's order.
struct SideBlock {
    elements::ElementKind kind = elements::ElementKind::Triangle;
    int order = 1;
    int nodes_per_side = 3;
    std::vector<std::int32_t> nodes;
};

/// The Bezier triangles, all of one degree, of which curved sides of elements consist. A triangle is one of them,
/// raised to that degree; a quadrilateral is two of twice its order.
///
/// Control points are relative to the middle of the mesh, which keeps rounding errors small. Nodes of equal coordinates
/// count as one node.
class SurfacePatches {
  public:
    /// @throws InvalidInput if the sizes of the lists do not agree, or a coordinate is not finite
    SurfacePatches(const std::vector<Vec3>& nodes, const std::vector<SideBlock>& blocks);

    std::size_t size() const { return patches_.size(); }
    /// Number of sides, which are numbered from block to block.
    std::size_t sides() const { return side_nodes_.size(); }
    const elements::Lattice& lattice() const { return *lattice_; }
    const Vec3& middle() const { return middle_; }
    const std::vector<Vec3>& control(std::int32_t t) const { return patch(t).control; }
    /// The side that a patch belongs to.
    std::int32_t side(std::int32_t t) const { return patch(t).side; }
    double rounding() const { return limits_.rounding; }

    /// Whether two patches belong to different sides with the same nodes.
    bool lie_on_each_other(std::int32_t a, std::int32_t b) const;
    /// How two patches meet; for a == b how the patch meets itself.
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

    const elements::Lattice* lattice_;
    Vec3 middle_ = Vec3::Zero();
    PatchLimits limits_;
    std::vector<Patch> patches_;
    std::vector<std::vector<std::int32_t>> side_nodes_;  ///< by side, in ascending order
    std::vector<std::int32_t> body_;                     ///< by side
};

}  // namespace mq::curve
