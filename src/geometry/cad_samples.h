// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/single_precision_grid.h"
#include "geometry/session.h"

namespace mq::geometry {

/// Sample points of the model, some in every span of its curves and surfaces (geometry::KnotSpans), by which the
/// backward distance is measured, from the model to the mesh. The other direction is measured at few points of a piece
/// of the mesh: the samples find undulations of the surface that vanish at these points.
///
/// The points of an edge or a face are computed once, when they are first needed. They are in the mesh's frame. Several
/// threads may read points that were computed before.
class CadSamples {
  public:
    CadSamples(Session& session, const SinglePrecisionGrid& grid) : session_(session), grid_(grid) {}

    /// Takes over the points of other edges and faces of the same model.
    void adopt(CadSamples& other) {
        edges_.merge(other.edges_);
        faces_.merge(other.faces_);
    }
    /// Computes the points of an edge, or a face, if they are not known.
    void compute_on_edge(int edge) { of_edge(edge); }
    void compute_on_face(int face) {
        if (has_spans(face)) {
            of_face(face);
        }
    }
    /// Calls `see` for the points of an edge with parameters between `from` and `to`.
    void between(int edge, double from, double to, const std::function<void(const Vec3&)>& see);
    /// Calls `see` for the points of a face with parameters in a triangle.
    void inside(int face, const std::array<Vec2, 3>& uv, const std::function<void(const Vec3&)>& see);

  private:
    struct OfEdge {
        std::vector<double> t;  // parameters, ascending
        std::vector<std::optional<Vec3>> points;
    };
    struct OfFace {
        std::array<std::vector<double>, 2> uv;    // parameters u and v, ascending
        std::vector<std::optional<Vec3>> points;  // for all v of the first u, then of the next
    };

    bool has_spans(int face) const {
        return !session_.topology().faces[static_cast<std::size_t>(face)].spans[0].bounds.empty();
    }
    const OfEdge& of_edge(int edge);
    const OfFace& of_face(int face);
    std::vector<std::optional<Vec3>> points_of(Engine::Batch batch);

    Session& session_;
    const SinglePrecisionGrid& grid_;
    std::unordered_map<int, OfEdge> edges_;
    std::unordered_map<int, OfFace> faces_;
};

}  // namespace mq::geometry
