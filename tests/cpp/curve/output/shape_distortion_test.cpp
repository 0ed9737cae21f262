// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/output/shape_distortion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/error.h"
#include "curve/elements.h"
#include "elements/bezier/jacobian.h"
#include "elements/product/reference_nodes.h"
#include "mesh/quality/triangle_quality.h"

namespace mq::curve {

using elements::Barycentric;
using elements::Lattice;
using elements::nodes_to_bezier;

namespace {

/// Largest factor between the bound and the value, with a margin for the samples.
constexpr double kRoom = 1.0 + 2.0 * kDistortionAccuracy;

/// The regular simplex with edges of length 1.
Vec3 regular(const Vec3& x) {
    return x.x() * Vec3(1, 0, 0) + x.y() * Vec3(0.5, std::sqrt(0.75), 0) +
           x.z() * Vec3(0.5, std::sqrt(1.0 / 12.0), std::sqrt(2.0 / 3.0));
}

double distortion_of(const Lattice& lattice, const std::vector<Vec3>& nodes) {
    const std::vector<Vec3> control = nodes_to_bezier(lattice, nodes);
    return lattice.dimension() == 2 ? max_distortion_of_triangle(lattice, control)
                                    : max_distortion_of_tetrahedron(lattice, control);
}

/// eta by its definition, from the derivatives at one point; infinite for a negative determinant.
double eta_at(const Lattice& lattice, const std::vector<Vec3>& control, const Barycentric& at) {
    const Lattice& lower = Lattice::of(lattice.dimension(), lattice.degree() - 1);
    const int d = lattice.dimension();
    Eigen::MatrixXd map(3, d), ideal(3, d);
    for (int k = 0; k < d; ++k) {
        map.col(k) = elements::value(lower, elements::derivative(lattice, control, k + 1), at);
        ideal.col(k) = regular(Vec3::Unit(k));
    }
    // S = map * ideal^-1; for a triangle in a plane of its own.
    const Eigen::MatrixXd s = map * ideal.topRows(d).inverse();
    const double determinant = d == 3 ? s.determinant() : std::sqrt((s.transpose() * s).determinant());
    return determinant > 0.0 ? s.squaredNorm() / (d * std::pow(determinant, 2.0 / d)) : HUGE_VAL;
}

/// The largest value at the points of a lattice that contains corners, edges and sides.
double sampled(const Lattice& lattice, const std::vector<Vec3>& nodes) {
    const std::vector<Vec3> control = nodes_to_bezier(lattice, nodes);
    const Lattice& points = Lattice::of(lattice.dimension(), elements::kMaxDegree);
    double most = 0.0;
    for (int i = 0; i < points.size(); ++i) {
        most = std::max(most, eta_at(lattice, control, points.node(i)));
    }
    return most;
}

/// Whether a triangle turns back anywhere: near such a line the normal changes abruptly, and bounds stay wide.
bool turns_back(const Lattice& lattice, const std::vector<Vec3>& nodes) {
    const elements::NormalForm normal = elements::normal_of(lattice, nodes_to_bezier(lattice, nodes));
    return std::any_of(normal.coefficients.begin(), normal.coefficients.end(),
                       [](const Vec3& c) { return c.z() <= 0.0; });
}

TEST(Distortion, OfTheRegularSimplexIsOneAtAnySizeAndTurn) {
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
    for (int dimension = 2; dimension <= 3; ++dimension) {
        for (int order = 1; order <= 4; ++order) {
            const Lattice& lattice = Lattice::of(dimension, order);
            const auto map = [&](const Vec3& x) { return Vec3(25.0 * (turn * regular(x)) + Vec3(3, -4, 9)); };
            EXPECT_NEAR(distortion_of(lattice, nodes_of(lattice, map)), 1.0, 1e-9) << dimension << " " << order;
        }
    }
}

TEST(Distortion, OfStraightElementsIsTheInverseMeanRatio) {
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const std::vector<Vec3> corners = perturbed(nodes_of(Lattice::of(2, 1), regular), 0.3, random);
        const mesh::TriangleShape shape = mesh::shape_of({corners[0], corners[1], corners[2]});
        EXPECT_NEAR(distortion_of(Lattice::of(2, 1), corners), shape.distortion, 1e-9 * shape.distortion);
    }
    // The corner of a cube: edges 1 and sqrt(2), volume 1/6; 12 (3 V)^(2/3) / 9 is its mean ratio.
    const double expected = 9.0 / (12.0 * std::pow(0.5, 2.0 / 3.0));
    for (int order = 1; order <= 4; ++order) {
        const Lattice& lattice = Lattice::of(3, order);
        EXPECT_NEAR(distortion_of(lattice, nodes_of(lattice, identity)), expected, 1e-9);
    }
}

TEST(Distortion, OfAKnownTriangle) {
    // A right angle between sides 1 and 1: (1 + 1 + 2) / (4 sqrt(3) / 2).
    const mesh::TriangleShape right = mesh::shape_of({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    EXPECT_NEAR(right.distortion, 2.0 / std::sqrt(3.0), 1e-12);
    EXPECT_EQ(mesh::shape_of({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}).distortion, HUGE_VAL);
}

TEST(Distortion, BoundsWhatSamplesFindAndIsNear) {
    std::mt19937 random(4);
    int finite = 0;
    for (int dimension = 2; dimension <= 3; ++dimension) {
        for (int order = 2; order <= (dimension == 2 ? 5 : 4); ++order) {
            const Lattice& lattice = Lattice::of(dimension, order);
            for (int i = 0; i < 30; ++i) {
                const std::vector<Vec3> nodes = perturbed(nodes_of(lattice, regular), 0.12 / order, random);
                const double bound = distortion_of(lattice, nodes);
                const double found = sampled(lattice, nodes);
                EXPECT_GE(bound, found * (1.0 - 1e-12));
                // Samples miss the worst point slightly, unless it is a corner.
                if (found < 4.0 && !(dimension == 2 && turns_back(lattice, nodes))) {
                    EXPECT_LE(bound, found * kRoom * 1.1) << dimension << " " << order;
                    ++finite;
                }
            }
        }
    }
    EXPECT_GT(finite, 100);
}

TEST(Distortion, OfAFoldIsInfinite) {
    const Lattice& lattice = Lattice::of(3, 2);
    std::vector<Vec3> nodes = nodes_of(lattice, regular);
    for (Vec3& node : nodes) {
        node.z() *= -1.0;
    }
    EXPECT_TRUE(std::isinf(distortion_of(lattice, nodes)));
    // The Jacobian changes its sign inside: a middle node is pulled over the opposite edge.
    nodes = nodes_of(lattice, regular);
    nodes[static_cast<std::size_t>(lattice.index({1, 1, 0, 0}))] = regular(Vec3(0.1, 0.8, 0.1));
    EXPECT_TRUE(std::isinf(sampled(lattice, nodes)));
    EXPECT_TRUE(std::isinf(distortion_of(lattice, nodes)));
}

TEST(Distortion, GrowsAsAnElementBends) {
    const Lattice& lattice = Lattice::of(2, 2);
    double before = 1.0;
    for (const double height : {0.05, 0.1, 0.2, 0.4}) {
        std::vector<Vec3> nodes = nodes_of(lattice, regular);
        nodes[static_cast<std::size_t>(lattice.index({1, 1, 0, 0}))] += Vec3(0, 0, height);
        const double distortion = distortion_of(lattice, nodes);
        EXPECT_GT(distortion, before);
        before = distortion;
    }
}

TEST(Distortion, OfAMeshByElement) {
    CurvedMesh mesh;
    mesh.order = 2;
    const Lattice& lattice = Lattice::of(3, 2);
    for (const int point : elements::gmsh_order(lattice)) {
        const Barycentric b = lattice.node(point);
        mesh.tetrahedra.push_back(static_cast<std::int32_t>(mesh.nodes.size()));
        mesh.nodes.push_back(regular(Vec3(b[1], b[2], b[3])));
    }
    mesh.tetrahedron_volume = {0};
    const std::vector<double> found = tetrahedron_distortions(mesh);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0], 1.0, 1e-9);

    const Lattice& flat = Lattice::of(2, 2);
    for (const int point : elements::gmsh_order(flat)) {
        const Barycentric b = flat.node(point);
        mesh.triangles.push_back(static_cast<std::int32_t>(mesh.nodes.size()));
        mesh.nodes.push_back(regular(Vec3(b[1], b[2], 0.0)));
    }
    mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    mesh.triangle_face = {0, 0};
    EXPECT_THROW(triangle_distortions(mesh), InvalidInput);
    mesh.triangle_quality = {0.9, -0.1};
    const std::vector<double> triangles = triangle_distortions(mesh);
    EXPECT_NEAR(triangles[0], 1.0, 1e-9);
    EXPECT_TRUE(std::isinf(triangles[1]));
    Progress progress;
    progress.cancel();
    EXPECT_THROW(triangle_distortions(mesh, &progress), Cancelled);
}

}  // namespace
}  // namespace mq::curve
