// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/progress.h"
#include "boolean/input/operand_repair.h"
#include "mesh/intersection/surface_winding.h"
#include "mesh/triangle_mesh.h"

namespace mq::layered_depth {

/// An operand of the uniform scheme that its rays can sample: unchanged if it has no faults, else repaired. If no
/// repair closes it, its winding number determines which points are inside.
class UniformOperand {
  public:
    UniformOperand() = default;
    /// @param given must outlive this object
    /// @param name for messages, such as "operand A"
    /// @param reach mm: the width up to which cracks are closed
    /// @throws InvalidInput naming the operand: as prepare_operand(), except for open surfaces. An operand without
    /// triangles is an empty solid.
    /// @throws OpenOperand for an open sheet: most of a surface that closes it would be a guess
    /// @throws Cancelled
    UniformOperand(const mesh::TriangleMesh& given, const std::string& name, double reach, const Progress* progress);

    const mesh::TriangleMesh& mesh() const { return made_ ? *made_ : *given_; }
    bool as_given() const { return made_ == nullptr; }
    /// Whether it is still open after repair.
    bool open() const { return winding_ != nullptr; }
    const mesh::SurfaceWinding& winding() const { return *winding_; }
    /// For a triangle of mesh() the given triangle with the same corners; -1: made or changed by the repair.
    std::int32_t source(std::int32_t triangle) const {
        return as_given() ? triangle : source_[static_cast<std::size_t>(triangle)];
    }
    /// The CAD face of each triangle of mesh(), from the faces of the given triangles; empty if the repair made
    /// triangles that are on no face, or did not close the operand.
    std::vector<std::int32_t> faces(const std::vector<std::int32_t>& given) const;
    /// A sentence on the repair; empty: nothing was repaired.
    const Message& repaired() const { return repaired_; }
    double largest_move() const { return largest_move_; }  ///< mm: by closing cracks

  private:
    void adopt(boolean::Operand&& operand, const std::string& name);

    const mesh::TriangleMesh* given_ = nullptr;
    std::unique_ptr<mesh::TriangleMesh> made_;
    std::unique_ptr<mesh::SurfaceWinding> winding_;
    std::vector<std::int32_t> source_;
    std::vector<std::int32_t> origin_;  ///< by triangle: the given triangle that it is, or is a piece of; -1: none
    Message repaired_;
    double largest_move_ = 0.0;
};

}  // namespace mq::layered_depth
