// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boolean/arrangement/soup.h"

namespace mq::boolean {

/// Outward displacements of operands' vertices. The operands must not share vertices.
class VertexOffsets {
  public:
    explicit VertexOffsets(const Soup& soup);

    std::int32_t operand(std::size_t v) const { return operand_[v]; }
    /// The displacement of a vertex when all triangles around it move outward by 1; approximate at spikes.
    Vec3 at(std::size_t v) const;

  private:
    std::vector<std::int32_t> operand_;
    std::vector<Vec3> normal_;      ///< unit normal, weighted by angles
    std::vector<double> steepest_;  ///< cosine between it and the triangle's normal that is farthest from it
};

}  // namespace mq::boolean
