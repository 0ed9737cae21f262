// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/single_grid.h"
#include "geometry/session.h"

namespace mq::triangulate {

/// Points of the part, some in every span of its curves and surfaces (geometry::Spans), by which the way back is
/// measured, from the part to the mesh. The mesh is measured at few places of a piece: a wave of the surface that is
/// zero at all of them is seen by these.
///
/// An edge or a face is asked for its points once, when they are first needed. In the mesh's frame.
class SpanPoints {
  public:
    SpanPoints(geometry::Session& session, const SingleGrid& grid) : session_(session), grid_(grid) {}

    /// Calls `see` for the points of an edge with parameters between `from` and `to`.
    void between(int edge, double from, double to, const std::function<void(const Vec3&)>& see);
    /// Calls `see` for the points of a face with parameters in a triangle.
    void inside(int face, const std::array<Vec2, 3>& uv, const std::function<void(const Vec3&)>& see);

  private:
    struct OfEdge {
        std::vector<double> t;  // ascending
        std::vector<std::optional<Vec3>> points;
    };
    struct OfFace {
        std::array<std::vector<double>, 2> uv;    // ascending
        std::vector<std::optional<Vec3>> points;  // for all v of the first u, then of the next
    };

    const OfEdge& of_edge(int edge);
    const OfFace& of_face(int face);
    std::vector<std::optional<Vec3>> points_of(geometry::Engine::Batch batch);

    geometry::Session& session_;
    const SingleGrid& grid_;
    std::unordered_map<int, OfEdge> edges_;
    std::unordered_map<int, OfFace> faces_;
};

}  // namespace mq::triangulate
