// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boolean/soup.h"

namespace mq::boolean {

/// How the vertices of operands go outward. The operands must not share vertices.
class VertexOffsets {
  public:
    explicit VertexOffsets(const Soup& soup);

    std::int32_t operand(std::size_t v) const { return operand_[v]; }
    /// The way by which a vertex goes outward when all triangles around it go outward by 1, or nearly so at spikes.
    Vec3 at(std::size_t v) const;

  private:
    std::vector<std::int32_t> operand_;
    std::vector<Vec3> normal_;      ///< weighted by angles
    std::vector<double> steepest_;  ///< cosine between it and the triangle's normal that is farthest from it
};

}  // namespace mq::boolean
