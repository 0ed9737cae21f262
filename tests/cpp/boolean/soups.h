// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/soup.h"
#include "boolean/closed_solids.h"

/// Operands in one soup, and its arrangement, for tests of the stages of a Boolean.
namespace mq::boolean::soups {

inline Soup soup_of(const std::vector<mesh::TriangleMesh>& operands) {
    Soup soup;
    for (const mesh::TriangleMesh& operand : operands) {
        const auto first = static_cast<std::int32_t>(soup.vertices.size());
        soup.vertices.insert(soup.vertices.end(), operand.vertices.begin(), operand.vertices.end());
        for (const Triangle& t : operand.triangles) {
            soup.source.push_back({soup.operands, static_cast<std::int32_t>(&t - operand.triangles.data())});
            soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        ++soup.operands;
    }
    return soup;
}

/// All pairs of triangles whose boxes meet, but for those that coincide: find_twins tells of them.
inline std::vector<std::array<std::int32_t, 2>> pairs_of(const Soup& soup) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Triangle& t : soup.triangles) {
        Eigen::AlignedBox3d box;
        for (const std::int32_t v : t) {
            box.extend(soup.vertices[static_cast<std::size_t>(v)]);
        }
        boxes.push_back(box);
    }
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size(); ++b) {
            Triangle corners[2] = {soup.triangles[a], soup.triangles[b]};
            std::sort(corners[0].begin(), corners[0].end());
            std::sort(corners[1].begin(), corners[1].end());
            if (corners[0] != corners[1] && boxes[a].intersects(boxes[b])) {
                pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
            }
        }
    }
    return pairs;
}

/// A soup with its arrangement. The arrangement refers to the soup, so that it is neither copied nor moved.
struct Arranged {
    explicit Arranged(const std::vector<mesh::TriangleMesh>& operands) : soup(soup_of(operands)) {
        merge_touching(soup, pairs_of(soup));
        arrangement = std::make_unique<Arrangement>(arrange(soup, find_twins(soup), pairs_of(soup), progress));
    }
    Arranged(const Arranged&) = delete;
    Arranged& operator=(const Arranged&) = delete;

    Soup soup;
    Progress progress;
    std::unique_ptr<Arrangement> arrangement;
};

/// Area of a face of the arrangement, by the nearest doubles of its points.
inline double area(const Arrangement& arrangement, const Face& face) {
    const Vec3 a = arrangement.points.approx(face.points[0]);
    return 0.5 *
           (arrangement.points.approx(face.points[1]) - a).cross(arrangement.points.approx(face.points[2]) - a).norm();
}

/// Two cubes of side 2, the second shifted by (1, 1, 1): they share a cube of side 1.
inline std::vector<mesh::TriangleMesh> overlapping_cubes() {
    return {solids::box(Vec3(0, 0, 0), Vec3(2, 2, 2)), solids::box(Vec3(1, 1, 1), Vec3(3, 3, 3))};
}

}  // namespace mq::boolean::soups
