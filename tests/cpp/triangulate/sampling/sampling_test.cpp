// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/sampling/sampling.h"

#include <cstring>
#include <string>

#include "base/error.h"
#include "triangulate/checks.h"
#include "triangulate/warped_face.h"

namespace mq::triangulate {
namespace {

using geometry::Part;

constexpr std::array<Method, 2> kMethods{Method::Star, Method::Sprinkle};  // Both sampling methods.
// Both rules for joining samples to triangles.
constexpr std::array<Connectivity, 2> kConnectivities{Connectivity::PseudoDelaunay, Connectivity::Parametric};

TriangulateOptions sampled(Method method, bool polish, Connectivity connectivity = Connectivity::PseudoDelaunay) {
    TriangulateOptions options;
    options.method = method;
    options.connectivity = connectivity;
    options.polish = polish;
    options.chord_height_relative = 0.005;
    return options;
}

const char* name_of(Method method) {
    return method == Method::Star ? "star" : "sprinkle";
}

TEST(Sampling, RawMeshesAreSoundOnEveryPart) {
    for (const Part& part : geometry::all_parts()) {
        for (const Method method : kMethods) {
            for (const Connectivity connectivity : kConnectivities) {
                SCOPED_TRACE(part.name + " " + name_of(method) +
                             (connectivity == Connectivity::Parametric ? " parametric" : ""));
                const Result result = mesh_of(part.model, sampled(method, false, connectivity));
                expect_sound(result, part.euler, part.closed);
                EXPECT_EQ(result.report.min_angle_asked, 0.0);
                EXPECT_TRUE(result.report.exempt.empty());
            }
        }
    }
}

TEST(Sampling, PolishedMeshesKeepTheBoundsOnEveryPart) {
    for (const Part& part : geometry::all_parts()) {
        for (const Method method : kMethods) {
            SCOPED_TRACE(part.name + " " + name_of(method));
            const Result result = mesh_of(part.model, sampled(method, true));
            expect_sound(result, part.euler, part.closed);
            expect_angles(result, 25.0);
            const SinglePrecisionGrid grid(part.model->topology().box);
            EXPECT_LE(result.report.max_chord_height, result.report.chord_height_asked + grid.resolution());
        }
    }
}

/// Around an apex the angles must add up to a full turn, wherever samples lie there.
TEST(Sampling, FrontsCloseAroundTheApexOfACone) {
    for (const Method method : kMethods) {
        for (std::uint64_t seed = 0; seed < (method == Method::Star ? 1 : 5); ++seed) {
            TriangulateOptions options = sampled(method, false);
            options.seed = seed;
            const Result result = mesh_of(geometry::make_cone(2.0, 5.0), options);
            expect_sound(result, 2, true);
            EXPECT_TRUE(result.report.fallback.empty());
        }
    }
}

TEST(Sampling, TurnsOfAThreadDoNotStandInEachOthersWay) {
    for (const Method method : kMethods) {
        SCOPED_TRACE(name_of(method));
        const Result result = mesh_of(thread_face(), sampled(method, false));
        expect_sound(result, 1, false);
        EXPECT_TRUE(result.report.fallback.empty());
    }
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST(Sampling, GivesTheSameBytesOnEveryRunAndEngine) {
    for (const Part& part : geometry::shape_parts()) {
        for (const Method method : kMethods) {
            SCOPED_TRACE(part.name + " " + name_of(method));
            const TriangulateOptions options = sampled(method, false);
            const Result first = mesh_of(part.model, options, geometry::Engine::Mode::Direct);
            const Result second = mesh_of(part.model, options, geometry::Engine::Mode::Threaded);
            EXPECT_TRUE(same_bytes(first.mesh.vertices, second.mesh.vertices));
            EXPECT_TRUE(same_bytes(first.mesh.triangles, second.mesh.triangles));
        }
    }
}

TEST(Sampling, TheSeedChangesTheSprinkledMesh) {
    const auto model = geometry::make_torus(5.0, 1.5);
    TriangulateOptions options = sampled(Method::Sprinkle, false);
    const Result first = mesh_of(model, options);
    options.seed = 1;
    const Result second = mesh_of(model, options);
    EXPECT_FALSE(same_bytes(first.mesh.vertices, second.mesh.vertices));
    const double ratio = static_cast<double>(first.report.vertices) / static_cast<double>(second.report.vertices);
    EXPECT_NEAR(ratio, 1.0, 0.05);
}

TEST(Sampling, StopsAtTheBudgetAndSaysSo) {
    for (const Method method : kMethods) {
        TriangulateOptions options = sampled(method, false);
        options.chord_height_relative = 1e-4;
        options.max_triangles = 500;
        const Result result = mesh_of(geometry::make_torus(5.0, 1.5), options);
        expect_sound(result, 0, true);
        EXPECT_FALSE(result.report.complete);
        ASSERT_FALSE(result.report.notes.empty());
        EXPECT_NE(result.report.notes.back().text().find("max_triangles"), std::string::npos);
        EXPECT_LE(result.mesh.triangles.size(), options.max_triangles);
    }
}

TEST(Sampling, SamplesOfEdgesCountAgainstTheBudget) {
    for (const Method method : kMethods) {
        for (const bool polish : {false, true}) {
            SCOPED_TRACE(std::string(name_of(method)) + (polish ? " polished" : ""));
            TriangulateOptions options = sampled(method, polish);
            options.max_edge = 1e-3;
            options.max_triangles = 5000;
            const Result result = mesh_of(geometry::make_box(1.0, 1.0, 1.0), options);
            expect_sound(result, 2, true);
            EXPECT_FALSE(result.report.complete);
            EXPECT_LE(result.mesh.triangles.size(), options.max_triangles);
        }
    }
}

TEST(Sampling, EndsWhenCancelled) {
    Progress progress;
    progress.cancel();
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    EXPECT_THROW(triangulate(engine, geometry::make_torus(5.0, 1.5), sampled(Method::Star, true), &progress),
                 Cancelled);
}

/// The purpose of the method: the same surface in other parameters gives the same mesh within noise.
TEST(Sampling, DoesNotDependOnTheParameters) {
    for (const Method method : kMethods) {
        SCOPED_TRACE(name_of(method));
        TriangulateOptions options = sampled(method, false);
        options.chord_height_relative = 2e-4;
        const mesh::MeshReport plain = mesh_of(warped_face(1.0, 1.0), options).report;
        EXPECT_GT(plain.triangles, 1000u);
        for (const auto& [in_u, in_v] : {std::pair{8.0, 1.0}, {1.0, 0.1}, {20.0, 20.0}}) {
            SCOPED_TRACE(std::to_string(in_u) + " " + std::to_string(in_v));
            const mesh::MeshReport warped = mesh_of(warped_face(in_u, in_v), options).report;
            EXPECT_TRUE(warped.fallback.empty());
            const auto count = static_cast<double>(plain.triangles);
            EXPECT_NEAR(static_cast<double>(warped.triangles), count, 0.03 * count);
            EXPECT_NEAR(warped.mean_min_angle, plain.mean_min_angle, 1.0);
            EXPECT_NEAR(warped.area, plain.area, 1e-3 * plain.area);
        }
    }
}

/// In parameters that are 900 times as fast at one end as at the other, the same samples give slivers; flipped in
/// space they do not.
TEST(Sampling, ParametricTrianglesAreFlippedInSpace) {
    for (const Method method : kMethods) {
        SCOPED_TRACE(name_of(method));
        const mesh::MeshReport front = mesh_of(warped_face(30.0, 30.0), sampled(method, false)).report;
        const mesh::MeshReport joined =
            mesh_of(warped_face(30.0, 30.0), sampled(method, false, Connectivity::Parametric)).report;
        EXPECT_TRUE(front.fallback.empty());
        EXPECT_EQ(joined.triangles, front.triangles);
        EXPECT_NEAR(joined.mean_min_angle, front.mean_min_angle, 0.5);
        EXPECT_GT(joined.min_angle, 15.0);
    }
}

/// Returns the fraction of triangles whose smallest angle is below `angle` degrees.
double share_below(const mesh::MeshReport& report, std::size_t angle) {
    std::size_t below = 0;
    for (std::size_t i = 0; i < angle; ++i) {
        below += report.angle_histogram[i];
    }
    return static_cast<double>(below) / static_cast<double>(report.triangles);
}

/// First defect of Attene's method by the paper: poor triangles where the front closes upon itself.
TEST(Sampling, TrianglesAreGoodWhereTheFrontsMeet) {
    for (const Method method : kMethods) {
        SCOPED_TRACE(name_of(method));
        const mesh::MeshReport report = mesh_of(geometry::make_sphere(2.0), sampled(method, false)).report;
        EXPECT_GT(report.min_angle, 15.0);
        EXPECT_LT(share_below(report, 30), 0.05);
        EXPECT_LT(report.max_aspect, 3.5);
    }
}

/// Second defect: faces with holes are not treated.
TEST(Sampling, FacesMayHaveHoles) {
    for (const Part& part : geometry::shape_parts()) {
        if (part.name != "holed plate" && part.name != "bored box") {
            continue;
        }
        for (const Method method : kMethods) {
            SCOPED_TRACE(part.name + " " + name_of(method));
            const Result result = mesh_of(part.model, sampled(method, false));
            expect_sound(result, part.euler, part.closed);
            EXPECT_TRUE(result.report.fallback.empty());
            EXPECT_GT(result.report.min_angle, 15.0);
        }
    }
}

/// Third defect: extremely acute isosceles triangles where the curvature is high, as the polygon gets more corners
/// there. Here the hexagon becomes smaller: on a face whose spacing varies by a factor of four or more, no triangle is
/// acute.
TEST(Sampling, TrianglesAreGoodWhereTheCurvatureIsHigh) {
    for (const Method method : kMethods) {
        SCOPED_TRACE(name_of(method));
        TriangulateOptions options = sampled(method, false);
        options.chord_height_relative = 2e-4;
        const Result result = mesh_of(peaked_face(), options);
        double shortest = 1e300;
        double longest = 0.0;
        for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
            const std::array<Vec3, 3> p = corners_of(result.mesh, t);
            const double side = (p[1] - p[0]).norm();
            shortest = std::min(shortest, side);
            longest = std::max(longest, side);
        }
        EXPECT_GT(longest, 4.0 * shortest);
        EXPECT_GT(result.report.min_angle, 15.0);
        EXPECT_LT(share_below(result.report, 30), 0.05);
    }
}

}  // namespace
}  // namespace mq::triangulate
