// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "curve/measuring.h"
#include "curve/surface/editor.h"
#include "triangulate/triangulate.h"

namespace mq::curve {

/// A curved surface before any repair.
class PlacedCurvedSurface {
  public:
    PlacedCurvedSurface(const std::shared_ptr<geometry::Model>& model, int order, double max_edge)
        : PlacedCurvedSurface(model, order, straight(model, max_edge)) {}
    PlacedCurvedSurface(const std::shared_ptr<geometry::Model>& model, int order, const mesh::TriangleMesh& straight)
        : session(engine, model), surface(classify(session, straight, order)), editor(session, surface) {
        editor.placement.place(live_triangles(surface));
    }

    static mesh::TriangleMesh straight(const std::shared_ptr<geometry::Model>& model, double max_edge) {
        geometry::Engine engine(geometry::Engine::Mode::Direct);
        triangulate::TriangulateOptions options;
        options.min_angle = 20.0;
        options.max_edge = max_edge;
        return triangulate::triangulate(engine, model, options).mesh;
    }

    int invalid() const {
        int count = 0;
        for (const int t : live_triangles(surface)) {
            count += editor.triangle(t).quality > 0.0 ? 0 : 1;
        }
        return count;
    }
    /// A live triangle of a surface type, with its corners turned so that edge (0, 1) is inside its face or, if
    /// `border`, on a CAD edge.
    int find(const char* type, bool border, std::array<int, 3>& corners) const {
        for (const int t : live_triangles(surface)) {
            if (std::string(session.topology().faces[static_cast<std::size_t>(editor.triangle(t).face)].surface) !=
                type) {
                continue;
            }
            corners = editor.triangle(t).corners;
            for (int k = 0; k < 3; ++k, corners = {corners[1], corners[2], corners[0]}) {
                if ((surface.segment(corners[0], corners[1]) != nullptr) == border) {
                    return t;
                }
            }
        }
        ADD_FAILURE() << "no triangle on a " << type;
        return -1;
    }
    void expect_closed() const {
        for (const int t : live_triangles(surface)) {
            const auto& v = editor.triangle(t).corners;
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_EQ(surface.triangles_of_edge(v[k], v[(k + 1) % 3]).size(), 2u);
            }
        }
    }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    mutable geometry::Session session;
    CurvedSurface surface;
    SurfaceEditor editor;
};

}  // namespace mq::curve
