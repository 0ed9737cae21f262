// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/proof/triangle_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mq::mesh {
namespace {

double area(const Piece& piece) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 2; k < piece.count; ++k) {
        sum += (piece.corners[k - 1] - piece.corners[0]).cross(piece.corners[k] - piece.corners[0]);
    }
    return 0.5 * sum.norm();
}

Piece triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    Piece piece;
    for (const Vec3& p : {a, b, c}) {
        piece.add(p);
    }
    return piece;
}

TEST(TrianglePieces, PartsOnBothSidesOfAPlaneAreAllOfAPiece) {
    const Piece whole = triangle(Vec3(0, 0, 1), Vec3(4, 0, 2), Vec3(0, 3, 5));
    const std::array<Piece, 2> parts = cut(whole, {Vec3(1, 0, 0), Vec3(1, 0.5, 0)});
    EXPECT_NEAR(area(parts[0]) + area(parts[1]), area(whole), 1e-12);
    for (std::size_t k = 0; k < parts[0].count; ++k) {
        EXPECT_LE(parts[0].corners[k].dot(Vec3(1, 0.5, 0)), 1.0 + 1e-12);
    }
    for (std::size_t k = 0; k < parts[1].count; ++k) {
        EXPECT_GE(parts[1].corners[k].dot(Vec3(1, 0.5, 0)), 1.0 - 1e-12);
    }
}

TEST(TrianglePieces, APlaneThroughNothingOrNextToASideDoesNotCut) {
    const Piece whole = triangle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_EQ(cut(whole, {Vec3(2, 0, 0), Vec3(1, 0, 0)})[1].count, 0U);
    EXPECT_EQ(cut(whole, {Vec3(-1, 0, 0), Vec3(1, 0, 0)})[0].count, 0U);
    EXPECT_EQ(cut(whole, {Vec3(1e-9, 0, 0), Vec3(1, 0, 0)})[0].count, 0U);
    const Piece needle = triangle(Vec3(-4.7, -26.2, 2e-7), Vec3(-3.5, -28.9, 4e-7), Vec3(-3.5, -28.9 + 1e-15, 4e-7));
    EXPECT_EQ(cut(needle, {Vec3(-4.7, -26.2, 0), Vec3(2.7, 1.2, 0)})[0].count, 3U);
}

TEST(TrianglePieces, HalvesOfHalvesStayAllOfATriangle) {
    std::vector<Piece> pieces{triangle(Vec3(0, 0, 0), Vec3(7, 1, 0), Vec3(2, 3, 4))};
    const double whole = area(pieces[0]);
    const std::array<Plane, 3> planes = upright({Vec3(1, 1, 0), Vec3(5, 1, 0), Vec3(2, 4, 0)});
    for (int round = 0; round < 7; ++round) {
        std::vector<Piece> smaller;
        for (const Piece& piece : pieces) {
            for (const Piece& part : piece.has_many() ? halves(piece) : cut(piece, planes[round % 3])) {
                for (const Piece& half : part.count > 0 ? halves(part) : std::array<Piece, 2>{}) {
                    ASSERT_LE(half.count, Piece::kMostCorners);
                    smaller.push_back(half);
                }
            }
        }
        pieces = smaller;
    }
    double sum = 0.0;
    for (const Piece& piece : pieces) {
        sum += area(piece);
    }
    EXPECT_NEAR(sum, whole, 1e-9);
}

}  // namespace
}  // namespace mq::mesh
