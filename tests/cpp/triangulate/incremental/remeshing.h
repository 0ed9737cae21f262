// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "triangulate/checks.h"
#include "triangulate/incremental/mesh_cache.h"

/// Meshing a shape again with a cache, and comparing the results.
namespace mq::triangulate {

inline Result run(const std::shared_ptr<geometry::Model>& model, const TriangulateOptions& options, MeshCache& memory) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    return triangulate(engine, model, options, nullptr, &memory);
}

inline void expect_same(const Result& a, const Result& b) {
    EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    EXPECT_EQ(a.mesh.triangle_face, b.mesh.triangle_face);
    EXPECT_EQ(a.report.max_chord_height, b.report.max_chord_height);
    EXPECT_EQ(a.report.min_angle, b.report.min_angle);
    EXPECT_EQ(a.report.notes, b.report.notes);
}

}  // namespace mq::triangulate
