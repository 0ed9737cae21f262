// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/height_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "base/cases.h"
#include "mesh/intersection/triangle_contact.h"

namespace mq::mesh {
namespace {

/// A sheet of squares, each two triangles, that lie over a grid; squares may lie above each other.
class Sheet {
  public:
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

    std::int32_t vertex(int x, int y, int level, const Vec3& point) {
        const auto [found, fresh] = index_.emplace(std::array<int, 3>{x, y, level}, int(vertices.size()));
        if (fresh) {
            vertices.push_back(point);
        }
        return found->second;
    }
    void add(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }

  private:
    std::map<std::array<int, 3>, std::int32_t> index_;
};

Sheet flat(int side) {
    Sheet sheet;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto at = [&](int i, int j) { return sheet.vertex(i, j, 0, Vec3(i, j, 0.1 * ((i * j) % 3))); };
            sheet.add(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
        }
    }
    return sheet;
}

/// A ring of `steps` squares around the z axis, `per_turn` of them in a turn, that rises as a screw does.
Sheet screw(int steps, int per_turn) {
    Sheet sheet;
    for (int k = 0; k < steps; ++k) {
        const auto at = [&](int i, int level) {
            const double angle = 2.0 * M_PI * i / per_turn;
            return sheet.vertex(i, level, 0,
                                Vec3((1.0 + level) * std::cos(angle), (1.0 + level) * std::sin(angle), 0.02 * i));
        };
        sheet.add(at(k, 0), at(k, 1), at(k + 1, 1), at(k + 1, 0));
    }
    return sheet;
}

std::size_t members(const std::vector<std::int32_t>& patch) {
    return static_cast<std::size_t>(std::count_if(patch.begin(), patch.end(), [](std::int32_t p) { return p >= 0; }));
}

TEST(HeightFields, OfASheetIsAllOfIt) {
    const Sheet sheet = flat(12);
    EXPECT_EQ(height_fields(sheet.vertices, sheet.triangles, 1), std::vector<std::int32_t>(288, 0));
}

TEST(HeightFields, LeaveOutPatchesTooSmallToBeWorthAProof) {
    const Sheet sheet = flat(4);
    EXPECT_EQ(members(height_fields(sheet.vertices, sheet.triangles, 33)), 0u);
    EXPECT_EQ(members(height_fields(sheet.vertices, sheet.triangles, 32)), 32u);
}

TEST(HeightFields, AScrewIsOneForLessThanATurn) {
    const Sheet most = screw(23, 24);
    EXPECT_EQ(members(height_fields(most.vertices, most.triangles, 1)), most.triangles.size());
    const Sheet more = screw(25, 24);
    EXPECT_EQ(members(height_fields(more.vertices, more.triangles, 1)), 0u);
    const Sheet twice = screw(60, 24);
    EXPECT_EQ(members(height_fields(twice.vertices, twice.triangles, 1)), 0u);
}

TEST(HeightFields, HoleAndPinchedVertexDoNoHarm) {
    Sheet sheet = flat(6);
    const auto drop = [&](int square) { sheet.triangles[2 * square] = sheet.triangles[2 * square + 1] = {0, 0, 0}; };
    drop(7);
    drop(14);  // they meet in a vertex
    EXPECT_EQ(members(height_fields(sheet.vertices, sheet.triangles, 1)), sheet.triangles.size() - 4);
}

TEST(HeightFields, OfAClosedSurfaceHaveSeveralSides) {
    // A tetrahedron whose sides look along the axes' signs.
    const std::vector<Vec3> vertices{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const std::vector<std::int32_t> patch = height_fields(vertices, triangles, 1);
    EXPECT_EQ(members(patch), 4u);
    EXPECT_GT(*std::max_element(patch.begin(), patch.end()), 0);
}

TEST(HeightFields, ABorderThatCrossesItselfInAVertexProvesNothing) {
    // A disc that turns twice around its hub; both turns have the border's vertex at half a turn in common.
    constexpr int kTurn = 24;
    std::vector<Vec3> vertices{{0.0, 0.0, 0.0}};
    std::vector<Triangle> triangles;
    for (int k = 0; k < 2 * kTurn; ++k) {
        const double angle = 2.0 * M_PI * k / kTurn;
        const double radius = 2.0 + (k % kTurn == kTurn / 2 ? 0.0 : std::cos(0.5 * angle));
        const Vec3 way(std::cos(angle), std::sin(angle), 0.0);
        vertices.insert(vertices.end(), {0.5 * way, radius * way});
    }
    const auto ring = [](int k) { return 1 + 2 * (k % (2 * kTurn)); };
    const auto rim = [&](int k) { return 1 + ring(k == kTurn + kTurn / 2 ? kTurn / 2 : k); };
    for (int k = 0; k < 2 * kTurn; ++k) {
        triangles.push_back({0, ring(k), ring(k + 1)});
        triangles.push_back({ring(k), rim(k), rim(k + 1)});
        triangles.push_back({ring(k), rim(k + 1), ring(k + 1)});
    }
    EXPECT_EQ(members(height_fields(vertices, triangles, 1)), 0u);
}

TEST(HeightFields, TwoLoopsThatBothRunRoundProveNothing) {
    // A large level and a small one above it, joined crosswise along a cut between two branch points.
    Sheet sheet;
    for (int level = 0; level < 2; ++level) {
        for (int y = level; y < 8 - level; ++y) {
            for (int x = level; x < 8 - level; ++x) {
                const auto at = [&](int i, int j) {
                    const bool branch = j == 4 && (i == 3 || i == 5);
                    const bool beyond = y == 3 && j == 4 && i == 4;
                    const int own = branch ? 2 : beyond ? 1 - level : level;
                    return sheet.vertex(i, j, own, Vec3(i, j, 0.3 * own));
                };
                sheet.add(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
            }
        }
    }
    EXPECT_EQ(members(height_fields(sheet.vertices, sheet.triangles, 1)), 0u);
}

/// Squares of a surface of two levels that runs around a branch point twice before it closes: it crosses itself along a
/// ray, lies above itself or in the same place.
Sheet branched(std::mt19937_64& random) {
    // Squares along a side of the sheet.
    constexpr int kSide = 6;
    // Column and row of the branch point.
    constexpr int kBranch = 3;
    const auto integer = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    const int step = integer(0, 2);
    const double noise = integer(0, 1) == 0 ? 0.0 : 0.3;
    const int kept = integer(3, 10);
    std::uniform_real_distribution<double> real(-noise, noise);
    Sheet sheet;
    for (int level = 0; level < 2; ++level) {
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                if (integer(0, 9) >= kept || (x == kBranch - 1 && y == kBranch - 1 && integer(0, 1) == 0)) {
                    continue;
                }
                const auto at = [&](int i, int j) {
                    const bool beyond = y == kBranch - 1 && x >= kBranch && j == kBranch;
                    const int own = beyond ? 1 - level : level;
                    const Vec3 point(i + real(random), j + real(random), step * own + real(random));
                    return sheet.vertex(i, j, own, point);
                };
                sheet.add(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
            }
        }
    }
    return sheet;
}

TEST(HeightFields, AreNeverMistaken) {
    std::mt19937_64 random(11);
    std::size_t proven = 0;
    std::size_t left = 0;
    for (int i = 0; i < scaled_cases(1500); ++i) {
        const Sheet sheet = branched(random);
        const std::vector<std::int32_t> patch = height_fields(sheet.vertices, sheet.triangles, 1);
        for (std::size_t a = 0; a < patch.size(); ++a) {
            for (std::size_t b = a + 1; b < patch.size(); ++b) {
                if (patch[a] >= 0 && patch[a] == patch[b]) {
                    ASSERT_EQ(contact(sheet.vertices, sheet.triangles[a], sheet.triangles[b]), Contact::None)
                        << "case " << i << ", triangles " << a << " and " << b;
                }
            }
        }
        proven += members(patch);
        left += patch.size() - members(patch);
    }
    EXPECT_GT(proven, left / 4);
    EXPECT_GT(left, proven / 100);
}

}  // namespace
}  // namespace mq::mesh
