// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "boolean/boolean.h"
#include "boolean/random_meshes.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"

/// The stated error bound against the distance of surfaces, measured in both directions.
namespace mq::boolean {
namespace {

using mesh::TriangleMesh;

Vec3 normal(const TriangleMesh& mesh, std::int32_t t) {
    const mesh::Triangle& c = mesh.triangles[static_cast<std::size_t>(t)];
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(c[0])];
    return (mesh.vertices[static_cast<std::size_t>(c[1])] - a)
        .cross(mesh.vertices[static_cast<std::size_t>(c[2])] - a)
        .normalized();
}

/// The smallest height of a triangle.
double height(const TriangleMesh& mesh, std::size_t t) {
    const mesh::Triangle& c = mesh.triangles[t];
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = mesh.vertices[static_cast<std::size_t>(c[k])];
        longest = std::max(longest, (mesh.vertices[static_cast<std::size_t>(c[(k + 1) % 3])] - a).norm());
    }
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(c[0])];
    const Vec3& b = mesh.vertices[static_cast<std::size_t>(c[1])];
    return (b - a).cross(mesh.vertices[static_cast<std::size_t>(c[2])] - a).norm() / longest;
}

/// Whether the surface has a point with the opposite normal nearer to a point than `reach`.
bool comes_back(const TriangleMesh& mesh, const mesh::NearestTree& tree, const Vec3& p, const Vec3& n, double reach) {
    // Largest cosine between normals that are opposite.
    constexpr double kOpposite = -0.5;
    const Vec3 around = Vec3::Constant(reach);
    bool found = false;
    tree.for_each_in_box({p - around, p + around}, [&](std::int32_t t) {
        const mesh::Triangle& c = mesh.triangles[static_cast<std::size_t>(t)];
        const Vec3 near = mesh::nearest_on_triangle(p, mesh.vertices[static_cast<std::size_t>(c[0])],
                                                    mesh.vertices[static_cast<std::size_t>(c[1])],
                                                    mesh.vertices[static_cast<std::size_t>(c[2])]);
        found = found || ((near - p).norm() <= reach && n.dot(normal(mesh, t)) < kOpposite);
        return !found;
    });
    return found;
}

/// Whether a ball less than `reach` thick that touches the surface in a point, before or behind it, meets the surface
/// elsewhere: the tip of a sliver, or the neighbourhood of a sharp edge.
bool in_a_tip(const mesh::NearestTree& tree, const Vec3& p, const Vec3& n, double reach) {
    constexpr double kMet = 0.9;  // neighbours whose normals differ by up to 25 degrees do not count
    // Radius of the smallest ball, as a fraction of `reach`.
    constexpr double kSmallest = 1.0 / 64.0;
    for (double r = reach / (1.0 + kMet); r > kSmallest * reach; r *= 0.5) {
        if (tree.nearest(p + r * n).distance < kMet * r || tree.nearest(p - r * n).distance < kMet * r) {
            return true;
        }
    }
    return false;
}

struct Distance {
    double largest = 0.0;
    std::size_t points = 0;
    std::size_t thin = 0;  ///< points of slivers and gaps, left out
};

/// The distance from points in triangles of one surface, near their corners, the middles of their edges and their
/// centres, to the other surface. The normals of needles are mostly rounding error; the triangles on both sides of them
/// are as near to the other surface as they are.
Distance distance(const TriangleMesh& from, const TriangleMesh& to, double sliver, double needle) {
    Distance result;
    const mesh::NearestTree own(from.vertices, from.triangles);
    const mesh::NearestTree other(to.vertices, to.triangles);
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        if (height(from, t) < needle) {
            continue;
        }
        const auto at = [&](std::size_t k) {
            return from.vertices[static_cast<std::size_t>(from.triangles[t][k % 3])];
        };
        const Vec3 n = normal(from, static_cast<std::int32_t>(t));
        const Vec3 centre = (at(0) + at(1) + at(2)) / 3.0;
        std::vector<Vec3> points{centre};
        for (std::size_t k = 0; k < 3; ++k) {
            // Distance of the points from the border, as a fraction of the way to the centre.
            constexpr double kInside = 0.02;
            points.push_back(at(k) + kInside * (centre - at(k)));
            const Vec3 middle = 0.5 * (at(k) + at(k + 1));
            points.push_back(middle + kInside * (centre - middle));
        }
        for (const Vec3& p : points) {
            ++result.points;
            if (comes_back(from, own, p, n, sliver) || in_a_tip(own, p, n, sliver)) {
                ++result.thin;
            } else {
                result.largest = std::max(result.largest, other.nearest(p).distance);
            }
        }
    }
    return result;
}

struct Case {
    const char* name;
    TriangleMesh a;
    double turn;
    Vec3 shift;
};

void expect_within_bound(const Case& what, Operation operation) {
    SCOPED_TRACE(std::string(what.name) + ", " + name(operation));
    TriangleMesh a = what.a;
    fuzz::round_to_single(a);
    TriangleMesh b = a;
    fuzz::move(b, Eigen::AngleAxisd(what.turn, Vec3(1, 2, 3).normalized()).toRotationMatrix(), 1.0, what.shift);
    const BooleanResult result = boolean({&a, &b}, operation, {});
    BooleanOptions exact;  // a tolerance that allows nearly no displacement
    exact.tolerance = 3e-6;
    const BooleanResult reference = boolean({&a, &b}, operation, exact);
    ASSERT_LT(reference.error_bound, 1e-5);
    ASSERT_GT(result.separated_vertices, 0u);
    const double sliver = 1.75 * result.closed_gaps + reference.error_bound;  // as measure_error is asked to
    const Distance there = distance(result.mesh, reference.mesh, sliver, reference.error_bound);
    const Distance back = distance(reference.mesh, result.mesh, sliver, reference.error_bound);
    const double bound = result.error_bound + reference.error_bound;
    EXPECT_LE(there.largest, bound) << there.thin << " of " << there.points << " points are thin";
    EXPECT_LE(back.largest, bound) << back.thin << " of " << back.points << " points are thin";
    if (operation != Operation::Difference) {
        EXPECT_LT(there.thin, there.points / 2);
        EXPECT_LT(back.thin, back.points / 2);
    }
}

TEST(ErrorBound, HoldsBothWaysWhereSurfacesRunAlongEachOther) {
    fuzz::Random random(5);
    const Case cases[] = {{"torus", fuzz::torus(96, 36, 0.3), 0.003, Vec3::Zero()},
                          {"sphere", fuzz::sphere(4), 0.0, Vec3(3e-4, 1e-4, -2e-4)},
                          {"facets", fuzz::facetted(random, 4), 1e-3, Vec3(1e-4, 0, 0)}};
    for (const Case& what : cases) {
        for (const Operation operation : {Operation::Union, Operation::Intersection, Operation::Difference}) {
            expect_within_bound(what, operation);
        }
    }
}

}  // namespace
}  // namespace mq::boolean
