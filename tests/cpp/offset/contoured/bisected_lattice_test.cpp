// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/bisected_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace mq::offset {
namespace {

Box unit_box() {
    Box box;
    box.add(Vec3(0, 0, 0));
    box.add(Vec3(3, 2, 1));
    return box;
}

double longest_edge(const std::array<Vec3, 4>& c) {
    double longest = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            longest = std::max(longest, (c[i] - c[j]).norm());
        }
    }
    return longest;
}

double volume(const std::array<Vec3, 4>& c) {
    return std::abs((c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0])) / 6.0;
}

/// Whether cells share whole faces, and those of one cell only lie on the border of all; the volume of all cells.
double conforming_volume(const BisectedLattice& lattice) {
    std::map<std::array<std::int32_t, 3>, int> faces;
    double sum = 0.0;
    Box all;
    for (std::size_t k = 0; k < lattice.cell_count(); ++k) {
        if (lattice.is_divided(k)) {
            continue;
        }
        const BisectedLattice::Cell& cell = lattice.cell(k);
        sum += volume(lattice.corners(cell));
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            std::array<std::int32_t, 3> face{};
            for (std::size_t i = 0; i < 3; ++i) {
                face[i] = cell[(opposite + 1 + i) % 4];
                all.add(lattice.at(face[i]));
            }
            std::sort(face.begin(), face.end());
            ++faces[face];
        }
    }
    for (const auto& [face, count] : faces) {
        bool on_border = false;
        for (int i = 0; i < 3; ++i) {
            for (const double end : {all.low[i], all.high[i]}) {
                on_border = on_border || std::all_of(face.begin(), face.end(), [&](std::int32_t node) {
                                return std::abs(lattice.at(node)[i] - end) < 1e-9;
                            });
            }
        }
        EXPECT_EQ(count, on_border ? 1 : 2);
    }
    return sum;
}

TEST(BisectedLattice, FillsItsBoxWithTetrahedra) {
    const BisectedLattice lattice(unit_box(), 1.0, 0.1);
    const double all = conforming_volume(lattice);
    EXPECT_GE(all, 6.0);
    EXPECT_EQ(lattice.cell_count() % 6, 0U);
    EXPECT_NEAR(all, std::round(all), 1e-9);  // whole cubes
}

TEST(BisectedLattice, StaysConformingWhereItIsDivided) {
    BisectedLattice lattice(unit_box(), 1.0, 0.01);
    const double all = conforming_volume(lattice);
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        lattice.divide(random() % lattice.cell_count());
    }
    // Once more near to one point, down to the finest.
    const Vec3 deep(1.03, 0.77, 0.41);
    for (int round = 0; round < 14; ++round) {
        const std::size_t count = lattice.cell_count();
        for (std::size_t k = 0; k < count; ++k) {
            Box box;
            for (const Vec3& corner : lattice.corners(lattice.cell(k))) {
                box.add(corner);
            }
            if (!lattice.is_divided(k) && box.contains(deep)) {
                lattice.divide(k);
            }
        }
    }
    EXPECT_NEAR(conforming_volume(lattice), all, 1e-9);
    // All cells are similar to one of three: their volumes compared with their longest edges have one of few values.
    std::map<long, int> shapes;
    for (std::size_t k = 0; k < lattice.cell_count(); ++k) {
        const auto c = lattice.corners(lattice.cell(k));
        const double longest = longest_edge(c);
        ++shapes[std::lround(1e6 * volume(c) / (longest * longest * longest))];
    }
    EXPECT_LE(shapes.size(), 3U);
}

TEST(BisectedLattice, CellsAreDivisibleDownToTheFinest) {
    constexpr double kFinest = 0.6;
    BisectedLattice lattice(unit_box(), 1.0, kFinest);
    for (std::size_t k = 0; k < lattice.cell_count(); ++k) {
        if (lattice.is_divisible(lattice.cell(k))) {
            lattice.divide(k);
        }
    }
    conforming_volume(lattice);
    for (std::size_t k = 0; k < lattice.cell_count(); ++k) {
        const auto c = lattice.corners(lattice.cell(k));
        const double longest = longest_edge(c);
        EXPECT_EQ(lattice.is_divided(k), longest > kFinest);
    }
}

TEST(BisectedLattice, AnEdgeIsDividedAnywhere) {
    BisectedLattice lattice(unit_box(), 1.0, 0.1);
    const double all = conforming_volume(lattice);
    const std::size_t nodes = lattice.node_count();
    const BisectedLattice::Cell cell = lattice.cell(7);
    const Vec3 place = 0.8 * lattice.at(cell[0]) + 0.2 * lattice.at(cell[3]);
    lattice.divide_edge(cell[0], cell[3], place);
    EXPECT_EQ(lattice.node_count(), nodes + 1);
    EXPECT_EQ(lattice.at(static_cast<std::int32_t>(nodes)), place);
    EXPECT_TRUE(lattice.is_divided(7));
    EXPECT_NEAR(conforming_volume(lattice), all, 1e-9);
    lattice.divide_edge(cell[0], cell[3], place);  // there is no such edge any more
    EXPECT_EQ(lattice.node_count(), nodes + 1);
}

}  // namespace
}  // namespace mq::offset
