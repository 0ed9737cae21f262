// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "boolean/input/operand_repair.h"
#include "mesh/intersection/winding_number.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// An operand of the uniform scheme, fit for its rays: as it was given where there is nothing to repair; else repaired;
/// where no repair closes it, with the winding number that tells what is inside.
class UniformOperand {
  public:
    UniformOperand() = default;
    /// @param given is referred to
    /// @param name for messages, such as "operand A"
    /// @param reach the width up to which cracks are closed, mm
    /// @throws InvalidInput naming the operand: as prepare_operand, but for open surfaces. An operand without
    ///     triangles is an empty solid.
    /// @throws OpenOperand for an open sheet, around which a guess would be most of the surface
    /// @throws Cancelled
    UniformOperand(const mesh::TriangleMesh& given, const std::string& name, double reach, const Progress* progress);

    const mesh::TriangleMesh& mesh() const { return made_ ? *made_ : *given_; }
    bool as_given() const { return made_ == nullptr; }
    /// Whether no repair has closed it.
    bool open() const { return winding_ != nullptr; }
    const mesh::WindingNumber& winding() const { return *winding_; }
    /// The triangle that was given, of one of mesh() that has its corners; -1: made or changed by the repair.
    std::int32_t source(std::int32_t triangle) const {
        return as_given() ? triangle : source_[static_cast<std::size_t>(triangle)];
    }
    /// The CAD face of each triangle of mesh(), from those of the triangles given; none where the repair made triangles
    /// that are on no face, or has not closed the operand.
    std::vector<std::int32_t> faces(const std::vector<std::int32_t>& given) const;
    /// A sentence on what was repaired; empty: nothing.
    const std::string& repaired() const { return repaired_; }
    double largest_move() const { return largest_move_; }  ///< by closing cracks, mm

  private:
    void take(Operand&& operand, const std::string& name);

    const mesh::TriangleMesh* given_ = nullptr;
    std::unique_ptr<mesh::TriangleMesh> made_;
    std::unique_ptr<mesh::WindingNumber> winding_;
    std::vector<std::int32_t> source_;
    std::vector<std::int32_t> origin_;  ///< the triangle given that each is, or is a piece of; -1: none
    std::string repaired_;
    double largest_move_ = 0.0;
};

}  // namespace mq::boolean
