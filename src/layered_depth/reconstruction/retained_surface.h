// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "layered_depth/reconstruction/triangle_retention.h"

namespace mq::layered_depth {

/// The retained triangles, M_D, and their border, beyond which triangles were removed.
struct RetainedSurface {
    /// An edge of a retained triangle without a neighbour, directed as in that triangle.
    struct BorderEdge {
        std::int32_t from, to;
        std::int32_t triangle;  ///< index into `triangles`
    };

    std::vector<Vec3> points;               ///< points of both operands, mm; new ones are appended
    std::vector<mesh::Triangle> triangles;  ///< reversed if the result's surface is
    std::vector<std::int32_t> source;       ///< triangle of the operands; -1 if it was changed
    std::vector<std::int32_t> lies_on;      ///< triangle of the operands that each is, or was cut from
    std::vector<BorderEdge> border;         ///< sorted by the points of the edges
    std::vector<std::uint8_t> on_border;    ///< for each point whether it is on the border
};

RetainedSurface retained_surface(const OperandSet& pair, const std::vector<Retention>& fate);

}  // namespace mq::layered_depth
