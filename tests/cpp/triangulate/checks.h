// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/parts.h"
#include "mesh/quality/mesh_report.h"
#include "triangulate/initial/initial_triangulation.h"
#include "triangulate/pipeline/assemble.h"
#include "triangulate/refine/angle_refinement.h"
#include "triangulate/triangulate.h"

/// Properties of every mesh, measured without the code that made it.
namespace mq::triangulate {

/// The single steps of `triangulate`, to inspect the mesh in between.
class Pipeline {
  public:
    explicit Pipeline(const std::shared_ptr<geometry::Model>& model)
        : session(engine, model),
          grid(model->topology().box),
          initial(triangulate_initially(session, grid, progress)),
          surface(assemble(initial, model->topology())),
          maxmin(surface),
          work{session, grid, surface, maxmin, progress} {
        work.floor = 16.0 * grid.resolution();
        work.budget = 1'000'000;
    }

    void refine(double min_angle, Insertion insertion = Insertion::OffCentre) {
        std::vector<int> touched;
        maxmin.sweep(touched);
        SegmentSplitter segments(work);
        AngleRefinement(work, segments, min_angle, insertion).run();
    }

    geometry::Engine engine{geometry::Engine::Mode::Direct};
    geometry::Session session;
    SinglePrecisionGrid grid;
    Progress progress;
    InitialTriangulation initial;
    ClassifiedMesh surface;
    MaxMinSwaps maxmin;
    Workspace work;
};

inline Result mesh_of(const std::shared_ptr<geometry::Model>& model, const TriangulateOptions& options = {},
                      geometry::Engine::Mode mode = geometry::Engine::Mode::Direct) {
    geometry::Engine engine(mode);
    return triangulate(engine, model, options);
}

inline double smallest_angle(const std::array<Vec3, 3>& p) {
    double smallest = 180.0;
    for (int i = 0; i < 3; ++i) {
        const Vec3 a = p[(i + 1) % 3] - p[i];
        const Vec3 b = p[(i + 2) % 3] - p[i];
        smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI);
    }
    return smallest;
}

inline std::array<Vec3, 3> corners_of(const mesh::TriangleMesh& mesh, std::size_t t) {
    const mesh::Triangle& v = mesh.triangles[t];
    return {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]};
}

inline bool single_precision(const Vec3& p) {
    return p.allFinite() && is_single(p);
}

/// Checks that vertices on CAD edges lie on the curve and on every face that shares it.
inline void expect_on_curves(Pipeline& pipeline) {
    const ClassifiedMesh& surface = pipeline.surface;
    const double slack = pipeline.grid.resolution() + 1e-6;
    for (int s = 0; s < surface.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = surface.segment(s);
        for (int end = 0; end < 2; ++end) {
            const Vec3& local = surface.vertex(segment.vertices[end]).point;
            EXPECT_TRUE(single_precision(local));
            const Vec3 point = pipeline.grid.to_shape(local);
            const auto curve = pipeline.session.ask(geometry::Query::edge_point(segment.edge, segment.t[end]));
            EXPECT_LE((point - curve.point).norm(), slack);
            for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
                const int h = surface.vertex_of(use.half_edge) == segment.vertices[end]
                                  ? use.half_edge
                                  : ClassifiedMesh::next(use.half_edge);
                const Vec2& uv = surface.site(surface.site_of(h)).uv;
                const int face = surface.face_of(h / 3);
                const auto on_face = pipeline.session.ask(geometry::Query::face_point(face, uv.x(), uv.y()));
                EXPECT_LE((point - on_face.point).norm(), slack);
            }
        }
    }
}

/// Checks that vertices have single precision and are all in use, and that the mesh is an outward oriented manifold
/// with the shape's topology.
inline void expect_sound(const Result& result, long euler, bool closed) {
    const mesh::MeshReport measured = mesh::measure(result.mesh);
    EXPECT_EQ(measured.closed, closed);
    EXPECT_TRUE(measured.oriented);
    EXPECT_TRUE(measured.manifold);
    EXPECT_EQ(measured.degenerate_triangles, 0u);
    EXPECT_EQ(measured.duplicate_triangles, 0u);
    EXPECT_EQ(measured.euler, euler);
    if (closed) {
        EXPECT_GT(measured.volume, 0.0);
    }
    std::vector<char> used(result.mesh.vertices.size(), 0);
    for (const mesh::Triangle& t : result.mesh.triangles) {
        for (const int v : t) {
            used[v] = 1;
        }
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
    EXPECT_TRUE(single_precision(result.mesh.origin));
    EXPECT_TRUE(std::all_of(result.mesh.vertices.begin(), result.mesh.vertices.end(), single_precision));
    EXPECT_EQ(result.mesh.triangle_face.size(), result.mesh.triangles.size());
    EXPECT_EQ(result.mesh.vertex_entity.size(), result.mesh.vertices.size());
}

/// Checks that every triangle reaches the angle bound or is listed with a reason, and that no listed one reaches it.
inline void expect_angles(const Result& result, double bound) {
    constexpr double kAngleRounding = 1e-6;  // degrees, for rounding
    std::set<int> exempt;
    for (const auto& [t, why] : result.report.exempt) {
        ASSERT_GE(t, 0);
        ASSERT_LT(static_cast<std::size_t>(t), result.mesh.triangles.size());
        EXPECT_TRUE(exempt.insert(t).second) << "listed twice";
        EXPECT_EQ(why.face.dimension, 2);
        EXPECT_LT(smallest_angle(corners_of(result.mesh, t)), bound + kAngleRounding) << mesh::message_of(why).text();
    }
    double least = 180.0;
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
        if (exempt.count(static_cast<int>(t)) == 0) {
            least = std::min(least, smallest_angle(corners_of(result.mesh, t)));
        }
    }
    EXPECT_GE(least, bound - kAngleRounding);
    EXPECT_NEAR(least, result.report.min_angle_unexempted, kAngleRounding);
    EXPECT_EQ(result.report.min_angle_asked, bound);
}

}  // namespace mq::triangulate
