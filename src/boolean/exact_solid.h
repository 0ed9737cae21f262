// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "boolean/input/operation.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/surface_winding.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// An operand as the set of points that it encloses, in the frame of the result. The pointers must outlive it.
struct EnclosedOperand {
    const std::vector<Vec3>* vertices = nullptr;
    const std::vector<mesh::Triangle>* triangles = nullptr;
    /// Null: the triangles are closed, and points with a winding number of at least 1 are inside. Else points at which
    /// this is at least 0.5 are inside.
    const mesh::SurfaceWinding* winding = nullptr;
    std::vector<char> retained{};  ///< for each triangle whether the result has it bit for bit; empty: it has none
};

/// Calls visit for the 26 steps to neighbours in a grid, of one length, until it returns false.
template <typename Visit>
void for_each_way(double length, const Visit& visit) {
    for (int k = 0; k < 27; ++k) {
        const Vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        if (k != 13 && !visit(Vec3(length / way.norm() * way))) {
            return;
        }
    }
}

/// The points of space that an expression makes of its operands, by the winding numbers of these, counted along rays.
/// The arguments must outlive it.
class ExactSolid {
  public:
    ExactSolid(const std::vector<EnclosedOperand>& operands, const Expression& expression)
        : operands_(operands), expression_(expression), triangles_(merge()), tree_(vertices_, triangles_) {
        constexpr double kBeside = 1e-7;  // by the size: as single precision rounds
        beside_ = tree_.box().empty() ? 0.0 : kBeside * tree_.box().largest_side();
    }

    const mesh::NearestTree& tree() const { return tree_; }
    /// mm: half the distance between the two points by which the sides of a surface are told apart.
    double beside() const { return beside_; }
    std::array<Vec3, 3> corners(std::int32_t triangle) const {
        const mesh::Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
        return {vertices_[static_cast<std::size_t>(t[0])], vertices_[static_cast<std::size_t>(t[1])],
                vertices_[static_cast<std::size_t>(t[2])]};
    }
    std::int32_t first_triangle(std::size_t operand) const { return first_[operand]; }
    std::int32_t operand_of(std::int32_t triangle) const { return operand_[static_cast<std::size_t>(triangle)]; }

    bool contains(const Vec3& p) const;

    /// Whether the points before and behind p along an axis, at the distance `half`, belong to the solid.
    std::array<bool, 2> sides(const Vec3& p, int axis, double half) const;

    /// Whether exactly one of the points at beside() in front of and behind a point of a triangle belongs to the solid.
    bool is_bounded_at(const Vec3& p, const Vec3& normal) const { return is_bounded_at(p, normal, beside_); }
    /// Tests the points at the distance `beside` (mm) instead.
    bool is_bounded_at(const Vec3& p, const Vec3& normal, double beside) const;

    /// Whether there are balls of this diameter near a point of the surface, one inside of the solid and one outside:
    /// at a film or a gap that is thinner, or at its rim, one of them does not exist. Centres up to a diameter away
    /// count as near, so that edges of 60 degrees do not count as films. A ball is tested by 26 points.
    bool is_thick_at(const Vec3& p, double diameter) const;

    /// Adds the steps by which the winding numbers of open operands would reach 0.5, if these have a gradient, and the
    /// steps to the sides of the operands' boxes.
    void add_steps_to_guess(const Vec3& p, std::vector<Vec3>& steps) const;

  private:
    bool has_ball(const Vec3& p, bool inside, double radius) const;

    /// Whether a point is in an open operand: in the box of its triangles, where it winds around it.
    bool guesses_inside(std::size_t operand, const Vec3& p) const;

    std::vector<mesh::Triangle> merge();

    const std::vector<EnclosedOperand>& operands_;
    const Expression& expression_;
    std::vector<Vec3> vertices_;
    std::vector<std::int32_t> operand_;  ///< by triangle
    std::vector<std::int32_t> first_;    ///< triangle of each operand
    std::vector<mesh::Triangle> triangles_;
    mesh::NearestTree tree_;
    double beside_ = 0.0;
};

}  // namespace mq::boolean
