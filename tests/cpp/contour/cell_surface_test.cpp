// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/cell_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::contour {
namespace {

const std::array<Vec3, 4> kCorners{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(0, 0, 4)};

TEST(CellPolygon, RunsCounterClockwiseSeenFromOutside) {
    for (int sides = 1; sides < 15; ++sides) {
        const std::array<bool, 4> outside{(sides & 1) != 0, (sides & 2) != 0, (sides & 4) != 0, (sides & 8) != 0};
        for (const bool mirrored : {false, true}) {
            std::array<Vec3, 4> corners = kCorners;
            if (mirrored) {
                for (Vec3& p : corners) {
                    p.x() = -p.x();
                }
            }
            const CellPolygon polygon = cell_polygon(corners, outside);
            const auto middle = [&](int k) {
                const auto& edge = polygon.edges[static_cast<std::size_t>(k)];
                EXPECT_TRUE(outside[static_cast<std::size_t>(edge[0])]);
                EXPECT_FALSE(outside[static_cast<std::size_t>(edge[1])]);
                return Vec3(0.5 *
                            (corners[static_cast<std::size_t>(edge[0])] + corners[static_cast<std::size_t>(edge[1])]));
            };
            const Vec3 normal = (middle(1) - middle(0)).cross(middle(2) - middle(0));
            for (int k = 0; k < polygon.count; ++k) {
                const auto& edge = polygon.edges[static_cast<std::size_t>(k)];
                EXPECT_GT(
                    normal.dot(corners[static_cast<std::size_t>(edge[0])] - corners[static_cast<std::size_t>(edge[1])]),
                    0.0);
                // Consecutive edges lie on one face: they have three corners together.
                const auto& next = polygon.edges[static_cast<std::size_t>((k + 1) % polygon.count)];
                EXPECT_TRUE(edge[0] == next[0] || edge[1] == next[1]);
            }
        }
    }
    EXPECT_EQ(cell_polygon(kCorners, {false, false, false, false}).count, 0);
    EXPECT_EQ(cell_polygon(kCorners, {true, true, true, true}).count, 0);
}

/// Crossings of the edges of kCorners with the surface of a convex body of planes through a point.
CrossedCell crossed(const Vec3& point, const std::vector<Vec3>& normals, std::vector<Crossing>& crossings) {
    const auto value = [&](const Vec3& p, std::size_t& plane) {
        double most = -1e9;
        for (std::size_t k = 0; k < normals.size(); ++k) {
            if (normals[k].dot(p - point) > most) {
                most = normals[k].dot(p - point);
                plane = k;
            }
        }
        return most;
    };
    std::array<bool, 4> outside{};
    std::size_t plane = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        outside[k] = value(kCorners[k], plane) >= 0.0;
    }
    CrossedCell cell;
    cell.corners = kCorners;
    cell.polygon = cell_polygon(kCorners, outside);
    for (int k = 0; k < cell.polygon.count; ++k) {
        const auto& edge = cell.polygon.edges[static_cast<std::size_t>(k)];
        Vec3 out = kCorners[static_cast<std::size_t>(edge[0])];
        Vec3 in = kCorners[static_cast<std::size_t>(edge[1])];
        for (int i = 0; i < 60; ++i) {
            const Vec3 half = 0.5 * (out + in);
            (value(half, plane) >= 0.0 ? out : in) = half;
        }
        value(out, plane);
        cell.crossings[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(crossings.size());
        crossings.push_back({out, out, normals[plane], static_cast<std::int32_t>(plane), 0});
    }
    return cell;
}

TEST(CellSurface, APlaneIsAFan) {
    std::vector<Crossing> crossings;
    const CrossedCell cell = crossed(Vec3(1, 1, 1), {Vec3(1, 1, 1).normalized()}, crossings);
    const CellSurface surface = cell_surface(cell, crossings, nullptr);
    EXPECT_FALSE(surface.is_cone);
    EXPECT_FALSE(surface.is_sharp);
}

TEST(CellSurface, AnEdgeAndACornerAreMet) {
    std::vector<Crossing> crossings;
    const Vec3 point(0.9, 0.8, 0.7);
    CrossedCell cell = crossed(point, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, crossings);
    CellSurface surface = cell_surface(cell, crossings, nullptr);
    EXPECT_TRUE(surface.is_sharp);
    EXPECT_NEAR((surface.apex - point).norm(), 0.0, 1e-9);
    crossings.clear();
    cell = crossed(point, {Vec3(1, 0, 0), Vec3(0, 1, 0)}, crossings);
    surface = cell_surface(cell, crossings, nullptr);
    EXPECT_NEAR(surface.apex.x(), 0.9, 1e-9);
    EXPECT_NEAR(surface.apex.y(), 0.8, 1e-9);
    int on_faces = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (surface.has_face_point[k]) {
            ++on_faces;
            EXPECT_NEAR(surface.face_points[k].x(), 0.9, 1e-9);
            EXPECT_NEAR(surface.face_points[k].y(), 0.8, 1e-9);
        }
    }
    EXPECT_EQ(on_faces, 2);
}

}  // namespace
}  // namespace mq::contour
