// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/face_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/analytic/analytic_model.h"
#include "layered_depth/samples/rasterise.h"

namespace mq::layered_depth {
namespace {

using geometry::Query;

/// A mesh and the CAD faces of its triangles.
struct FacedMesh {
    mesh::TriangleMesh mesh;
    std::vector<std::int32_t> faces;
};

/// A solid of revolution about z from a polygon of (distance from the axis, height), whose side i is of face faces[i].
/// An open polygon begins and ends on the axis.
FacedMesh revolved(const std::vector<Vec2>& profile, const std::vector<std::int32_t>& faces, int n) {
    FacedMesh result;
    std::vector<std::int32_t> first;
    for (const Vec2& p : profile) {
        first.push_back(static_cast<std::int32_t>(result.mesh.vertices.size()));
        for (int i = 0; i < (p.x() == 0.0 ? 1 : n); ++i) {
            const double turn = 2.0 * M_PI * i / n;
            result.mesh.vertices.push_back(to_single(Vec3(p.x() * std::cos(turn), p.x() * std::sin(turn), p.y())));
        }
    }
    for (std::size_t side = 0; side < faces.size(); ++side) {
        const std::size_t next = (side + 1) % profile.size();
        const auto at = [&](std::size_t k, int i) {
            return first[k] + (profile[k].x() == 0.0 ? 0 : static_cast<std::int32_t>(i % n));
        };
        for (int i = 0; i < n; ++i) {
            for (const mesh::Triangle& t : {mesh::Triangle{at(side, i), at(side, i + 1), at(next, i + 1)},
                                            mesh::Triangle{at(side, i), at(next, i + 1), at(next, i)}}) {
                if (!mesh::is_collapsed(t)) {
                    result.mesh.triangles.push_back(t);
                    result.faces.push_back(faces[side]);
                }
            }
        }
    }
    return result;
}

FacedMesh sphere(double radius, int n) {
    std::vector<Vec2> profile{Vec2(0.0, -radius)};
    for (int i = 1; i < n; ++i) {
        const double angle = M_PI * (i / static_cast<double>(n) - 0.5);
        profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    profile.emplace_back(0.0, radius);
    return revolved(profile, std::vector<std::int32_t>(static_cast<std::size_t>(n), 0), 2 * n);
}

FacedMesh torus(double major, double minor, int n) {
    std::vector<Vec2> profile;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * M_PI * i / n;
        profile.emplace_back(major + minor * std::cos(angle), minor * std::sin(angle));
    }
    return revolved(profile, std::vector<std::int32_t>(static_cast<std::size_t>(n), 0), 2 * n);
}

FacedMesh box(double a, double b, double c) {
    FacedMesh result;
    for (int k = 0; k < 8; ++k) {
        result.mesh.vertices.emplace_back((k & 1) != 0 ? a : 0.0, (k & 2) != 0 ? b : 0.0, (k & 4) != 0 ? c : 0.0);
    }
    result.mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                             {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    result.faces = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    return result;
}

/// A grid of 64 cells of this size with a node at the origin.
SampleGrid grid_about_origin(double spacing) {
    // The margin of SampleGrid in cells, and how many cells it leaves.
    const Vec3 margin(1.4370, 1.3913, 1.5231);
    Box bounds;
    bounds.add(Vec3(spacing * (margin - Vec3::Constant(32.0))));
    bounds.add(Vec3(bounds.low + Vec3::Constant(spacing * (64.0 - 3.2))));
    return SampleGrid(bounds, 65);
}

struct Sampled {
    LayeredDepthSet set;
    FaceSampleCounts counts;
};

Sampled sample(const FacedMesh& faced, const std::shared_ptr<geometry::Model>& model, const SampleGrid& grid,
               double chord_height, const Progress* progress = nullptr) {
    OperandSet pair(faced.mesh, mesh::TriangleMesh());
    pair.face = faced.faces;
    Sampled result;
    result.set = rasterise(pair, 0, grid, nullptr);
    geometry::Engine engine;
    sample_faces(result.set, pair, grid, Vec3::Zero(), {model, &faced.faces, chord_height}, engine, result.counts,
                 progress);
    return result;
}

/// Every ray enters and leaves in turn, ascending; all rays agree about each node with what the model says, but for
/// those on the surface.
void expect_solid(const LayeredDepthSet& set, const SampleGrid& grid, geometry::Model& model) {
    const int rays = grid.rays();
    for (int axis = 0; axis < 3; ++axis) {
        const LayeredDepthImage& image = set[axis];
        ASSERT_EQ(image.normal.size(), image.depth.size());
        for (int ray = 0; ray < rays * rays; ++ray) {
            Vec3 g;
            g[(axis + 1) % 3] = ray % rays;
            g[(axis + 2) % 3] = ray / rays;
            bool inside = false;
            std::uint32_t i = image.begin[ray];
            for (int k = 0; k < rays; ++k) {
                for (; i < image.begin[ray + 1] && image.depth[i] <= k; ++i) {
                    EXPECT_EQ(image.code[i] >= 0, !inside) << "axis " << axis << " ray " << ray;
                    EXPECT_TRUE(i == image.begin[ray] || image.depth[i - 1] <= image.depth[i]);
                    inside = !inside;
                }
                g[axis] = k;
                const int side = model.answer(Query::volume_contains(0, grid.to_space(g))).side;
                ASSERT_TRUE(side == 0 || (side > 0) == inside) << "axis " << axis << " node " << g.transpose();
            }
            EXPECT_FALSE(inside);
            EXPECT_EQ(i, image.begin[ray + 1]);
        }
    }
}

/// All samples lie on the model's surface, whose normal they have.
void expect_on_surface(const LayeredDepthSet& set, const SampleGrid& grid, geometry::Model& model, double within) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int ray = 0; ray < grid.rays() * grid.rays(); ++ray) {
            for (std::uint32_t i = set[axis].begin[ray]; i < set[axis].begin[ray + 1]; ++i) {
                Vec3 g;
                g[axis] = set[axis].depth[i];
                g[(axis + 1) % 3] = ray % grid.rays();
                g[(axis + 2) % 3] = ray / grid.rays();
                const Vec3 p = grid.to_space(g);
                double distance = 1e300, cosine = 0.0;
                for (int face = 0; face < static_cast<int>(model.topology().faces.size()); ++face) {
                    const geometry::Answer answer = model.answer(Query::face_nearest_global(face, p));
                    if (answer.found() && answer.distance < distance) {
                        distance = answer.distance;
                        cosine = answer.normal.dot(set[axis].normal[i].cast<double>());
                    }
                }
                ASSERT_LT(distance, within) << "axis " << axis << " at " << p.transpose();
                ASSERT_GT(cosine, 1.0 - 1e-6) << "axis " << axis << " at " << p.transpose();
            }
        }
    }
}

/// The meshes are so coarse that many rays pass between mesh and surface.
TEST(FaceSamples, SphereHasItsOwnDepthsWhateverItsMesh) {
    const auto model = geometry::make_sphere(1.0);
    const SampleGrid grid = grid_about_origin(0.0371);
    for (const int n : {8, 10, 20, 40}) {
        const Sampled s = sample(sphere(1.0, n), model, grid, 1.0 - std::cos(M_PI / n / 1.4));
        EXPECT_EQ(s.counts.nodes.left, 0U) << n;
        EXPECT_EQ(s.counts.on_mesh, 0U) << n;
        expect_solid(s.set, grid, *model);
        expect_on_surface(s.set, grid, *model, 1e-12);
    }
}

TEST(FaceSamples, TorusHasFourDepthsOnARay) {
    const auto model = geometry::make_torus(0.8, 0.3);
    const SampleGrid grid = grid_about_origin(0.0371);
    const Sampled s = sample(torus(0.8, 0.3, 24), model, grid, 0.01);
    EXPECT_EQ(s.counts.nodes.left, 0U);
    expect_solid(s.set, grid, *model);
    // The ray along x through the centre.
    const LayeredDepthImage& image = s.set[0];
    const std::uint32_t ray = 32 * 65 + 32, first = image.begin[ray];
    ASSERT_EQ(image.begin[ray + 1] - first, 4U);
    constexpr std::array<double, 4> kAt{-1.1, -0.5, 0.5, 1.1};
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(grid.to_space(Vec3(image.depth[first + i], 32, 32)).x(), kAt[i], 1e-12);
        EXPECT_NEAR(image.normal[first + i].x(), i % 2 == 0 ? -1.0 : 1.0, 1e-6);
    }
}

TEST(FaceSamples, ConeWithItsApexOnARay) {
    const SampleGrid grid = grid_about_origin(0.0625);
    for (const double height : {1.5, 1.53}) {  // the apex is a node, or lies between two
        const auto model = geometry::make_cone(1.0, height);
        const FacedMesh cone = revolved({Vec2(0, 0), Vec2(1, 0), Vec2(0, height)}, {1, 0}, 36);
        const Sampled s = sample(cone, model, grid, 0.004);
        EXPECT_EQ(s.counts.nodes.left, 0U);
        expect_solid(s.set, grid, *model);
        const LayeredDepthImage& image = s.set[2];
        const std::uint32_t ray = 32 * 65 + 32;
        ASSERT_EQ(image.begin[ray + 1] - image.begin[ray], 2U);
        EXPECT_NEAR(grid.to_space(Vec3(32, 32, image.depth[image.begin[ray]])).z(), 0.0, 1e-12);
        EXPECT_NEAR(grid.to_space(Vec3(32, 32, image.depth[image.begin[ray] + 1])).z(), height, 1e-6);
    }
}

/// The seam of the cylinder lies on rays along z, and its ends between rays and in a plane of nodes.
TEST(FaceSamples, CylinderWithItsSeamOnRays) {
    const SampleGrid grid = grid_about_origin(0.0625);
    for (const double height : {1.25, 1.28}) {
        const auto model = geometry::make_cylinder(1.0, height);
        for (const int n : {8, 17, 64}) {
            const FacedMesh cylinder =
                revolved({Vec2(0, 0), Vec2(1, 0), Vec2(1, height), Vec2(0, height)}, {2, 0, 1}, n);
            const Sampled s = sample(cylinder, model, grid, 1.0 - std::cos(M_PI / n));
            EXPECT_EQ(s.counts.nodes.left, 0U) << n;
            expect_solid(s.set, grid, *model);
        }
    }
}

TEST(FaceSamples, BoxWithFacesInPlanesOfNodes) {
    const SampleGrid grid = grid_about_origin(0.0625);
    const auto model = geometry::make_box(1.0, 0.75, 1.25);
    const Sampled s = sample(box(1.0, 0.75, 1.25), model, grid, 0.0);
    expect_solid(s.set, grid, *model);
    EXPECT_EQ(s.counts.on_mesh, 0U);
    EXPECT_EQ(s.counts.nodes.nodes, 0U);
    // The planes at the lower coordinates are of the box, those at the higher ones are not: a node on a surface lies
    // behind it.
    const std::array<std::size_t, 3> cells{16, 12, 20};
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(s.set[axis].depth.size(), 2 * cells[(axis + 1) % 3] * cells[(axis + 2) % 3]);
        for (const double depth : s.set[axis].depth) {
            EXPECT_EQ(depth, std::round(depth));
        }
    }
}

TEST(FaceSamples, AreTheSameForAnyNumberOfThreads) {
    const SampleGrid grid = grid_about_origin(0.0371);
    const auto model = geometry::make_torus(0.8, 0.3);
    const FacedMesh mesh = torus(0.8, 0.3, 16);
    const auto on_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return sample(mesh, model, grid, 0.02).set;
    };
    const LayeredDepthSet one = on_threads(1), five = on_threads(5);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(one[axis].begin, five[axis].begin);
        EXPECT_EQ(one[axis].depth, five[axis].depth);
        EXPECT_EQ(one[axis].code, five[axis].code);
        EXPECT_EQ(one[axis].normal, five[axis].normal);
    }
}

TEST(FaceSamples, StopWhenCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(sample(sphere(1.0, 8), geometry::make_sphere(1.0), grid_about_origin(0.0371), 0.1, &progress),
                 Cancelled);
}

}  // namespace
}  // namespace mq::layered_depth
