// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/layered_depth_boolean.h"

#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <vector>

#include "base/error.h"
#include "boolean/closed_solids.h"
#include "boolean/input/operand_repair.h"
#include "boolean/random_meshes.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/surface_winding.h"
#include "mesh/quality/mesh_report.h"

namespace mq::layered_depth {

namespace fuzz = boolean::fuzz;
namespace solids = boolean::solids;

using boolean::name;
using boolean::Operation;

namespace {

const Operation kOperations[] = {Operation::Union, Operation::Intersection, Operation::Difference,
                                 Operation::SymmetricDifference};

LayeredDepthOptions at_resolution(int resolution) {
    LayeredDepthOptions options;
    options.resolution = resolution;
    return options;
}

double volume(const mesh::TriangleMesh& mesh) {
    return mesh::measure(mesh).volume;
}

/// Checks what the method promises of every result.
void expect_sound(const UniformResult& r, const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
    const mesh::MeshReport report = mesh::measure(r.mesh);
    EXPECT_EQ(report.border_edges, 0U);
    EXPECT_EQ(report.nonmanifold_edges, 0U);
    EXPECT_EQ(report.misoriented_edges, 0U);
    EXPECT_EQ(report.pinched_vertices, 0U);
    EXPECT_EQ(report.duplicate_triangles, 0U);
    ASSERT_EQ(r.triangle_source.size(), r.mesh.triangles.size());
    const std::array<const mesh::TriangleMesh*, 2> operands{&a, &b};
    std::size_t retained = 0;
    for (std::size_t k = 0; k < r.triangle_source.size(); ++k) {
        const auto [operand, index] = r.triangle_source[k];
        if (operand < 0) {
            continue;
        }
        ++retained;
        const mesh::TriangleMesh& from = *operands[operand];
        std::array<Vec3, 3> now, then;
        for (int i = 0; i < 3; ++i) {
            now[i] = r.mesh.vertices[r.mesh.triangles[k][i]];
            then[i] = from.vertices[from.triangles[index][i]];
        }
        const bool same = now == then;
        const bool reversed = now[0] == then[0] && now[1] == then[2] && now[2] == then[1];
        EXPECT_TRUE(same || reversed) << "triangle " << k;
    }
    EXPECT_EQ(retained, r.retained);
    EXPECT_EQ(r.retained + r.changed + r.reconstructed + r.hole_triangles, r.mesh.triangles.size());
    for (const Vec3& p : r.mesh.vertices) {
        EXPECT_EQ(p, to_single(p));
    }
}

double lens(double radius, double distance) {
    const double h = radius - 0.5 * distance;  // two caps
    return 2.0 * M_PI * h * h * (radius - h / 3.0);
}

TEST(Uniform, SpheresInAllOperations) {
    const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 64);
    const mesh::TriangleMesh b = solids::sphere(Vec3(0.7, 0.4, 0.2), 1.0, 64);
    const double ball = volume(a), common = lens(1.0, Vec3(0.7, 0.4, 0.2).norm());
    const double expected[] = {2 * ball - common, common, ball - common, 2 * (ball - common)};
    for (const Operation operation : kOperations) {
        SCOPED_TRACE(name(operation));
        const UniformResult r = layered_depth_boolean(a, b, operation, at_resolution(129), nullptr);
        expect_sound(r, a, b);
        EXPECT_NEAR(volume(r.mesh), expected[static_cast<int>(operation)], 0.01);
        EXPECT_GT(r.retained, r.mesh.triangles.size() / 3);
        EXPECT_GT(r.error_bound, 0.0);
        EXPECT_EQ(r.seconds.size(), 8U);
    }
}

TEST(Uniform, ApartAndWithin) {
    const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 24);
    const mesh::TriangleMesh inner = solids::sphere(Vec3(0.1, 0, 0), 0.5, 16);
    const mesh::TriangleMesh apart = solids::sphere(Vec3(3, 0, 0), 1.0, 24);
    const auto run = [&](const mesh::TriangleMesh& b, Operation operation) {
        const UniformResult r = layered_depth_boolean(a, b, operation, at_resolution(129), nullptr);
        expect_sound(r, a, b);
        EXPECT_EQ(r.retained, r.mesh.triangles.size());
        EXPECT_EQ(r.error_bound, 0.0);
        return volume(r.mesh);
    };
    EXPECT_NEAR(run(apart, Operation::Union), volume(a) + volume(apart), 1e-9);
    EXPECT_EQ(run(apart, Operation::Intersection), 0.0);
    EXPECT_NEAR(run(apart, Operation::Difference), volume(a), 1e-9);
    EXPECT_NEAR(run(inner, Operation::Difference), volume(a) - volume(inner), 1e-9);
    EXPECT_NEAR(run(inner, Operation::Intersection), volume(inner), 1e-9);
    EXPECT_NEAR(run(inner, Operation::SymmetricDifference), volume(a) - volume(inner), 1e-9);
}

/// The bound counts the free cells around the operands, which take some of the rays.
TEST(Uniform, TheBoundIsWithinTheToleranceThatTheResolutionIsFor) {
    const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 24);
    const mesh::TriangleMesh b = solids::sphere(Vec3(0.7, 0.4, 0.2), 1.0, 24);
    const double size = 2.7;  // along x
    const double exact = std::sqrt(3.0) * size / 64;
    for (const double tolerance : {0.5, exact, 1.001 * exact, 0.999 * exact, 0.05}) {
        SCOPED_TRACE(tolerance);
        const int resolution = uniform_resolution(size, tolerance);
        EXPECT_LE(uniform_bound(size, resolution), tolerance);
        const UniformResult r = layered_depth_boolean(a, b, Operation::Union, at_resolution(resolution), nullptr);
        EXPECT_GT(r.error_bound, 0.0);
        EXPECT_LE(r.error_bound, tolerance * (1.0 + 1e-12));
    }
    const double least = uniform_bound(size, 4097);
    EXPECT_LE(uniform_bound(size, uniform_resolution(size, least)), least);
    EXPECT_THROW(uniform_resolution(size, 0.99 * least), InvalidInput);
}

/// The rays lie where the result can be, however far the other operand reaches.
TEST(Uniform, ToolsFarLargerThanThePart) {
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0.1, 0.2, 0.3), 1.0, 40);
    for (const double size : {10.0, 1e3, 1e6}) {
        SCOPED_TRACE(size);
        const mesh::TriangleMesh tool = solids::box(Vec3(-0.4 * size, -0.7 * size, 0.3), Vec3(size, size, size));
        const UniformResult cut = layered_depth_boolean(ball, tool, Operation::Difference, at_resolution(65), nullptr);
        expect_sound(cut, ball, tool);
        EXPECT_NEAR(volume(cut.mesh), 0.5 * volume(ball), 0.02);
        EXPECT_NEAR(cut.spacing, 2.0 / 61.0, 1e-3);
        const UniformResult common =
            layered_depth_boolean(tool, ball, Operation::Intersection, at_resolution(65), nullptr);
        expect_sound(common, tool, ball);
        EXPECT_NEAR(volume(common.mesh), 0.5 * volume(ball), 0.02);
        EXPECT_EQ(common.spacing, cut.spacing);
    }
}

/// Remark 3: a solid and itself leave that solid's own triangles.
TEST(Uniform, ASolidWithItself) {
    const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 24, 0.1);
    for (const Operation operation : {Operation::Union, Operation::Intersection}) {
        const UniformResult r = layered_depth_boolean(a, a, operation, at_resolution(129), nullptr);
        expect_sound(r, a, a);
        EXPECT_EQ(r.mesh.triangles, a.triangles);
    }
    const UniformResult none = layered_depth_boolean(a, a, Operation::Difference, at_resolution(129), nullptr);
    EXPECT_TRUE(none.mesh.triangles.empty());
}

/// Faces, edges and corners that touch; every position of the grid's rays is a tie for axis-parallel faces.
TEST(Uniform, BoxesInContact) {
    const mesh::TriangleMesh a = solids::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const struct {
        mesh::TriangleMesh b;
        Operation operation;
        double volume;
    } cases[] = {
        {solids::box(Vec3(1, 0, 0), Vec3(2, 1, 1)), Operation::Union, 2.0},
        {solids::box(Vec3(0.5, 0, 0), Vec3(1.5, 1, 1)), Operation::Union, 1.5},
        {solids::box(Vec3(0.25, 0.25, 1), Vec3(0.75, 0.75, 2)), Operation::Union, 1.25},
        {solids::box(Vec3(0.25, 0.25, 0), Vec3(0.75, 0.75, 1)), Operation::Difference, 0.75},
        {solids::box(Vec3(0.5, 0.25, 0.25), Vec3(1, 0.75, 0.75)), Operation::Difference, 0.875},
        {solids::box(Vec3(0.5, 0.5, 0.5), Vec3(2, 2, 2)), Operation::Intersection, 0.125},
        {solids::box(Vec3(1, 1, 0), Vec3(2, 2, 1)), Operation::Union, 2.0},
        {solids::box(Vec3(1, 1, 1), Vec3(2, 2, 2)), Operation::Union, 2.0},
    };
    for (const auto& c : cases) {
        SCOPED_TRACE(&c - cases);
        const UniformResult r = layered_depth_boolean(a, c.b, c.operation, at_resolution(65), nullptr);
        expect_sound(r, a, c.b);
        EXPECT_NEAR(volume(r.mesh), c.volume, 0.02);
    }
}

TEST(Uniform, OperandThatIntersectsItself) {
    const mesh::TriangleMesh left = solids::sphere(Vec3(0, 0, 0), 1.0, 32);
    const mesh::TriangleMesh right = solids::sphere(Vec3(0.8, 0, 0), 1.0, 32);
    const mesh::TriangleMesh both = solids::together(left, right);
    const UniformResult r =
        layered_depth_boolean(both, mesh::TriangleMesh(), Operation::Union, at_resolution(129), nullptr);
    expect_sound(r, both, mesh::TriangleMesh());
    EXPECT_NEAR(volume(r.mesh), volume(left) + volume(right) - lens(1.0, 0.8), 0.03);
    LayeredDepthOptions parity = at_resolution(129);
    parity.normal_index = false;
    const UniformResult odd = layered_depth_boolean(both, mesh::TriangleMesh(), Operation::Union, parity, nullptr);
    EXPECT_NEAR(volume(odd.mesh), volume(left) + volume(right) - 2.0 * lens(1.0, 0.8), 0.06);
}

/// Triangles far smaller than the distance between rays, rough surfaces, any operation: always 2-manifold.
TEST(Uniform, RoughSolidsStayTwoManifold) {
    std::mt19937 random(11);
    for (unsigned round = 0; round < 24; ++round) {
        const double wobble = 0.3 * (round % 4) / 3.0;
        const auto coordinate = [&] { return random() / 4294967295.0 - 0.5; };
        const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 8 + round % 5 * 20, wobble, round);
        const Vec3 center(coordinate(), coordinate(), coordinate());
        const mesh::TriangleMesh b = solids::sphere(center, 0.9, 6 + round % 7 * 12, wobble, round + 100);
        SCOPED_TRACE(round);
        const UniformResult r =
            layered_depth_boolean(a, b, kOperations[round % 4], at_resolution(round % 3 == 0 ? 33 : 65), nullptr);
        expect_sound(r, a, b);
    }
}

/// Beside triangles far larger than r a reconstructed triangle may end up without a neighbour; its back would fill the
/// hole around it.
TEST(Uniform, NoTriangleIsFilledWithItsBack) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        const mesh::TriangleMesh coarse = solids::sphere(Vec3(0, 0, 0), 1.0, 3 + static_cast<int>(seed), 0.3, seed);
        const mesh::TriangleMesh rough = solids::sphere(Vec3(0.3, 0.1, -0.2), 0.9, 60, 0.3, seed + 100);
        for (const Operation operation : kOperations) {
            SCOPED_TRACE(std::to_string(seed) + " " + name(operation));
            expect_sound(layered_depth_boolean(coarse, rough, operation, at_resolution(33), nullptr), coarse, rough);
        }
    }
}

/// Where edges were halved, the middle of an edge and its ends are in line: no corner may move onto such a middle.
TEST(Uniform, CollapsesOfBorderVerticesLeaveNoTriangleWithoutArea) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        mesh::TriangleMesh halved = solids::sphere(Vec3(0, 0, 0), 1.0, 6, 0.2, seed);
        for (Vec3& p : halved.vertices) {
            p = (1024.0 * p).array().round() / 1024.0;  // so that the middles are exact
        }
        for (int level = 0; level < 3; ++level) {
            fuzz::subdivide(halved);
        }
        const mesh::TriangleMesh ball = solids::sphere(Vec3(0.4, 0.1, -0.2), 0.8, 9);
        for (const Operation operation : kOperations) {
            SCOPED_TRACE(std::to_string(seed) + " " + name(operation));
            const UniformResult r = layered_depth_boolean(halved, ball, operation, at_resolution(33), nullptr);
            expect_sound(r, halved, ball);
            EXPECT_EQ(mesh::measure(r.mesh).degenerate_triangles, 0U);
        }
    }
}

/// Table III of the paper: M_D is empty.
TEST(Uniform, FullReconstructionKeepsNoTriangle) {
    const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 64);
    const mesh::TriangleMesh b = solids::sphere(Vec3(0.7, 0.4, 0.2), 1.0, 64);
    for (const Operation operation : kOperations) {
        SCOPED_TRACE(name(operation));
        LayeredDepthOptions options = at_resolution(65);
        const UniformResult partial = layered_depth_boolean(a, b, operation, options, nullptr);
        options.full = true;
        const UniformResult full = layered_depth_boolean(a, b, operation, options, nullptr);
        expect_sound(full, a, b);
        EXPECT_GT(partial.retained, 0U);
        EXPECT_EQ(full.retained, 0U);
        EXPECT_EQ(full.changed, 0U);
        EXPECT_EQ(full.boundary_cells, 0U);
        EXPECT_GT(full.reconstructed, partial.reconstructed);
        EXPECT_EQ(full.samples, partial.samples);
        EXPECT_NEAR(volume(full.mesh), volume(partial.mesh), 0.01 * volume(partial.mesh));
        EXPECT_DOUBLE_EQ(full.error_bound, std::sqrt(3.0) * full.spacing);
    }
    // Where nothing meets, all triangles would stay.
    LayeredDepthOptions options = at_resolution(65);
    options.full = true;
    const UniformResult alone = layered_depth_boolean(a, mesh::TriangleMesh(), Operation::Union, options, nullptr);
    expect_sound(alone, a, b);
    EXPECT_EQ(alone.retained, 0U);
    EXPECT_NEAR(volume(alone.mesh), volume(a), 0.01);
}

TEST(Uniform, TheSameEveryTime) {
    const mesh::TriangleMesh a = solids::sphere(Vec3(0, 0, 0), 1.0, 40, 0.1);
    const mesh::TriangleMesh b = solids::sphere(Vec3(0.5, 0.3, 0.1), 0.9, 30, 0.1);
    const UniformResult first = layered_depth_boolean(a, b, Operation::Union, at_resolution(65), nullptr);
    for (int round = 0; round < 3; ++round) {
        const UniformResult again = layered_depth_boolean(a, b, Operation::Union, at_resolution(65), nullptr);
        EXPECT_EQ(again.mesh.triangles, first.mesh.triangles);
        EXPECT_EQ(again.mesh.vertices, first.mesh.vertices);
    }
}

/// What repair closes is the operand's own solid; its own triangles stay.
TEST(Uniform, RepairsOperandsFirst) {
    const mesh::TriangleMesh good = solids::sphere(Vec3(0, 0, 0), 1.0, 24);
    const mesh::TriangleMesh tool = solids::box(Vec3(0.2, 0.1, -2), Vec3(2, 2, 2));
    const double wanted =
        volume(layered_depth_boolean(good, tool, Operation::Difference, at_resolution(65), nullptr).mesh);
    mesh::TriangleMesh faulty = good;
    std::swap(faulty.triangles[100][1], faulty.triangles[100][2]);
    faulty.triangles.push_back(faulty.triangles[200]);
    faulty.triangles.erase(faulty.triangles.begin() + 7);
    mesh::TriangleMesh inward = good;
    for (mesh::Triangle& t : inward.triangles) {
        std::swap(t[1], t[2]);
    }
    for (const mesh::TriangleMesh& operand : {faulty, inward}) {
        const UniformResult r = layered_depth_boolean(operand, tool, Operation::Difference, at_resolution(65), nullptr);
        EXPECT_EQ(r.open, (std::vector<char>{0, 0}));
        EXPECT_EQ(r.guessed_samples, 0U);
        EXPECT_EQ(r.repaired[0].text().rfind("operand A: ", 0), 0U) << r.repaired[0].text();
        EXPECT_TRUE(r.repaired[1].empty());
        EXPECT_NEAR(volume(r.mesh), wanted, 1e-3);
        EXPECT_GT(r.retained, good.triangles.size() / 3);
        EXPECT_EQ(mesh::measure(r.mesh).border_edges, 0U);
    }
}

/// A bowl with a hole too large to be filled: the result is closed, the share of the guess is told, and the triangles
/// away from the hole are the bowl's own.
TEST(Uniform, OpenOperandsAreClosedByTheirWindingNumber) {
    mesh::TriangleMesh bowl =
        solids::only(solids::sphere(Vec3(0, 0, 0), 1.0, 48), [](const Vec3& p) { return p.z() < 0.1; });
    for (std::size_t t = 0; t < bowl.triangles.size(); t += 3) {
        std::swap(bowl.triangles[t][0], bowl.triangles[t][1]);  // any way round
    }
    const mesh::TriangleMesh tool = solids::box(Vec3(-2, -2, -2), Vec3(0.05, 2, 2));
    for (const Operation operation : kOperations) {
        SCOPED_TRACE(name(operation));
        const UniformResult r = layered_depth_boolean(bowl, tool, operation, at_resolution(65), nullptr);
        EXPECT_EQ(r.open, (std::vector<char>{1, 0}));
        EXPECT_GT(r.guessed_samples, r.result_samples / 50);
        const mesh::MeshReport report = mesh::measure(r.mesh);
        EXPECT_EQ(report.border_edges + report.nonmanifold_edges + report.misoriented_edges + report.pinched_vertices,
                  0U);
        EXPECT_GT(r.retained, bowl.triangles.size() / 10);
    }
    const UniformResult whole = layered_depth_boolean(bowl, {}, Operation::Union, at_resolution(129), nullptr);
    // About half a ball; the winding number of half a sphere is 0.5 on a dome a little below the plane of its rim.
    EXPECT_NEAR(volume(whole.mesh), 2.0 / 3.0 * M_PI, 0.35);
    EXPECT_GT(whole.retained, bowl.triangles.size() / 2);
}

/// Six faces of a box that do not touch, two of them the wrong way round.
TEST(Uniform, LooseFacesAreTurnedAndSpanned) {
    mesh::TriangleMesh loose;
    const mesh::TriangleMesh box = solids::box(Vec3(0, 0, 0), Vec3(2, 1, 1));
    for (std::size_t face = 0; face < 6; ++face) {
        for (std::size_t t = 2 * face; t < 2 * face + 2; ++t) {
            mesh::Triangle triangle;
            Vec3 centre = Vec3::Zero();
            for (std::size_t s = 2 * face; s < 2 * face + 2; ++s) {
                for (const std::int32_t v : box.triangles[s]) {
                    centre += box.vertices[static_cast<std::size_t>(v)] / 6.0;
                }
            }
            for (int i = 0; i < 3; ++i) {
                triangle[i] = static_cast<std::int32_t>(loose.vertices.size());
                const Vec3 p = box.vertices[static_cast<std::size_t>(box.triangles[t][i])];
                loose.vertices.push_back(to_single(Vec3(centre + 0.9 * (p - centre))));
            }
            if (face % 3 == 0) {
                std::swap(triangle[1], triangle[2]);
            }
            loose.triangles.push_back(triangle);
        }
    }
    const UniformResult r = layered_depth_boolean(loose, {}, Operation::Union, at_resolution(129), nullptr);
    EXPECT_EQ(r.open, (std::vector<char>{1, 0}));
    EXPECT_NEAR(volume(r.mesh), 2.0, 0.1);
    EXPECT_EQ(mesh::measure(r.mesh).border_edges, 0U);
}

/// Many operands in one pass are what two at a time make, but for the errors of each pass.
TEST(Uniform, ManyOperandsAreThoseTwoAtATime) {
    std::vector<mesh::TriangleMesh> balls;
    std::mt19937 random(4);
    const auto coordinate = [&] { return random() / 4294967295.0 - 0.5; };
    for (unsigned k = 0; k < 5; ++k) {
        balls.push_back(solids::sphere(0.6 * Vec3(coordinate(), coordinate(), coordinate()), 0.8, 24, 0.1, k));
    }
    std::vector<const mesh::TriangleMesh*> operands;
    for (const mesh::TriangleMesh& ball : balls) {
        operands.push_back(&ball);
    }
    for (const Operation operation : kOperations) {
        SCOPED_TRACE(name(operation));
        const UniformResult all =
            layered_depth_boolean(operands, boolean::Expression::chain(operation, 5), at_resolution(129), nullptr);
        mesh::TriangleMesh folded = balls[0];
        for (std::size_t k = 1; k < balls.size(); ++k) {
            folded = layered_depth_boolean(folded, balls[k], operation, at_resolution(129), nullptr).mesh;
        }
        const mesh::MeshReport report = mesh::measure(all.mesh);
        EXPECT_EQ(report.border_edges + report.nonmanifold_edges + report.misoriented_edges, 0U);
        const mesh::SurfaceWinding by_all(all.mesh.vertices, all.mesh.triangles);
        const mesh::SurfaceWinding by_two(folded.vertices, folded.triangles);
        std::vector<mesh::SurfaceWinding> solids;
        std::deque<mesh::NearestTree> surfaces;
        for (const mesh::TriangleMesh& ball : balls) {
            solids.emplace_back(ball.vertices, ball.triangles);
            surfaces.emplace_back(ball.vertices, ball.triangles);
        }
        int compared = 0, inside = 0;
        for (int k = 0; k < 2000; ++k) {
            const Vec3 p = 2.0 * Vec3(coordinate(), coordinate(), coordinate());
            bool near = false;
            std::vector<std::int32_t> winding;
            for (const mesh::NearestTree& surface : surfaces) {
                near = near || surface.nearest(p, 0.05).triangle >= 0;
            }
            for (const mesh::SurfaceWinding& solid : solids) {
                winding.push_back(solid.at(p) > 0.5 ? 1 : 0);
            }
            if (near) {
                continue;
            }
            ++compared;
            const bool wanted = boolean::Expression::chain(operation, 5).contains(winding.data());
            inside += wanted ? 1 : 0;
            EXPECT_EQ(by_all.at(p) > 0.5, wanted) << p.transpose();
            EXPECT_EQ(by_two.at(p) > 0.5, wanted) << p.transpose();
        }
        EXPECT_GT(compared, 500);
        EXPECT_GT(inside, 10);
        EXPECT_GT(all.retained, 0U);
        EXPECT_EQ(all.triangle_source.size(), all.mesh.triangles.size());
    }
}

/// A sheet bounds nothing, flat or curved, wherever it is.
TEST(Uniform, SheetsAreRefused) {
    const mesh::TriangleMesh ball = solids::sphere(Vec3(0, 0, 0), 1.0, 24);
    mesh::TriangleMesh flat = solids::box(Vec3(-0.7, -0.6, 0.03), Vec3(0.8, 0.5, 0.1));
    flat.triangles.resize(2);
    const mesh::TriangleMesh cap =
        solids::only(solids::sphere(Vec3(0, 0, 0), 1.1, 24), [](const Vec3& p) { return p.z() > 1.0; });
    mesh::TriangleMesh far = flat;
    for (Vec3& p : far.vertices) {
        p.x() += 100.0;
    }
    for (const mesh::TriangleMesh& sheet : {flat, cap, far}) {
        try {
            layered_depth_boolean(ball, sheet, Operation::Difference, at_resolution(65), nullptr);
            ADD_FAILURE();
        } catch (const boolean::OpenOperand& error) {
            EXPECT_EQ(std::string(error.what()).rfind("operand B bounds no volume: ", 0), 0U) << error.what();
        }
    }
}

TEST(Uniform, RefusesWhatItCannotDo) {
    const mesh::TriangleMesh good = solids::sphere(Vec3(0, 0, 0), 1.0, 10);
    const auto message = [&](const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                             const LayeredDepthOptions& options) {
        try {
            layered_depth_boolean(a, b, Operation::Union, options, nullptr);
        } catch (const InvalidInput& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    mesh::TriangleMesh endless = good;
    endless.vertices[0].x() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(message(endless, good, at_resolution(65)).find("operand A: vertex 0 "), 0U);
    EXPECT_EQ(message(good, endless, at_resolution(65)).find("operand B: vertex 0 "), 0U);
    EXPECT_NE(message(good, good, at_resolution(5)).find("resolution = 5 is not allowed"), std::string::npos);
    mesh::TriangleMesh moved = good;
    moved.origin = Vec3(1, 0, 0);
    EXPECT_NE(message(good, moved, at_resolution(65)).find("origins"), std::string::npos);
    LayeredDepthOptions thick;
    thick.thinnest = 0.5;
    EXPECT_NE(message(good, good, thick).find("thinnest"), std::string::npos);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(layered_depth_boolean(good, good, Operation::Union, at_resolution(65), &progress), Cancelled);
}

TEST(Uniform, EmptyOperands) {
    const mesh::TriangleMesh none, ball = solids::sphere(Vec3(0, 0, 0), 1.0, 10);
    EXPECT_TRUE(layered_depth_boolean(none, none, Operation::Union, at_resolution(33), nullptr).mesh.triangles.empty());
    EXPECT_EQ(layered_depth_boolean(none, ball, Operation::Union, at_resolution(33), nullptr).mesh.triangles,
              ball.triangles);
    EXPECT_TRUE(
        layered_depth_boolean(ball, none, Operation::Intersection, at_resolution(33), nullptr).mesh.triangles.empty());
}

}  // namespace
}  // namespace mq::layered_depth
