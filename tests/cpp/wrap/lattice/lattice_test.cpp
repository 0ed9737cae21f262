// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/lattice/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace mq::wrap {
namespace {

Lattice lattice_of_box(double side) {
    Box box;
    box.add(Vec3(0.0, 0.0, 0.0));
    box.add(Vec3(10.0, 4.0, 6.0));
    return Lattice(box, 1.0, side);
}

double volume(const Lattice& lattice, const std::array<Node, 4>& c) {
    const Vec3 o = lattice.at(c[0]);
    return std::abs((lattice.at(c[1]) - o).cross(lattice.at(c[2]) - o).dot(lattice.at(c[3]) - o)) / 6.0;
}

/// visit(corners) for each of the 12 tetrahedra whose even axis edge goes from `node`, which is even, along +x, +y or
/// +z; over all nodes each tetrahedron is visited once.
template <typename Visit>
void for_each_tetrahedron(const Node& node, const Visit& visit) {
    for (int axis = 0; axis < 3; ++axis) {
        for_each_tetrahedron_around(node, axis, 1, visit);
    }
}

TEST(Lattice, TetrahedraAreCongruentAndFillSpace) {
    const Lattice lattice = lattice_of_box(0.5);
    // Each cube has two nodes, of which the even one has 12 tetrahedra: together they are as large as the cube.
    double sum = 0.0;
    for_each_tetrahedron(Node{8, 8, 8}, [&](const std::array<Node, 4>& cell) {
        const double one = volume(lattice, cell);
        EXPECT_NEAR(one, 0.125 / 12.0, 1e-12);
        sum += one;
        std::multiset<long> lengths;
        for (int i = 0; i < 4; ++i) {
            for (int j = i + 1; j < 4; ++j) {
                const int step = Lattice::step_between(cell[i], cell[j]);
                ASSERT_GE(step, 0);
                EXPECT_NEAR((lattice.at(cell[i]) - lattice.at(cell[j])).norm(), lattice.length_of_step(step), 1e-12);
                lengths.insert(std::lround(1000.0 * lattice.length_of_step(step)));
            }
        }
        EXPECT_EQ(lengths.count(500), 2U);
        EXPECT_EQ(lengths.count(433), 4U);
    });
    EXPECT_NEAR(sum, 0.125, 1e-12);
}

TEST(Lattice, TetrahedraShareTheirFaces) {
    std::map<std::set<Node>, int> faces;
    std::set<std::set<Node>> at_node;
    for (std::int32_t x = 4; x <= 12; x += 2) {
        for (std::int32_t y = 4; y <= 12; y += 2) {
            for (std::int32_t z = 4; z <= 12; z += 2) {
                for_each_tetrahedron(Node{x, y, z}, [&](const std::array<Node, 4>& cell) {
                    for (std::size_t k = 0; k < 4; ++k) {
                        std::set<Node> face(cell.begin(), cell.end());
                        face.erase(cell[k]);
                        ++faces[face];
                    }
                    if (std::count(cell.begin(), cell.end(), Node{8, 8, 8}) > 0) {
                        at_node.insert(std::set<Node>(cell.begin(), cell.end()));
                    }
                });
            }
        }
    }
    for (const auto& [face, count] : faces) {
        EXPECT_LE(count, 2);
        const bool inner = std::all_of(face.begin(), face.end(), [](const Node& n) {
            return std::all_of(n.begin(), n.end(), [](std::int32_t c) { return c >= 7 && c <= 10; });
        });
        EXPECT_TRUE(!inner || count == 2);
    }
    std::set<std::set<Node>> by_node;
    for_each_tetrahedron_at(Node{8, 8, 8}, [&](const std::array<Node, 4>& cell) {
        by_node.insert(std::set<Node>(cell.begin(), cell.end()));
    });
    EXPECT_EQ(by_node.size(), 24U);
    EXPECT_EQ(by_node, at_node);
}

TEST(Lattice, PlacesInBlocksAreThoseOfNodes) {
    const Lattice lattice = lattice_of_box(0.5);
    std::set<std::uint64_t> keys;
    for (int place = 0; place < Lattice::kBlockNodes; ++place) {
        const Node node = Lattice::node_at({1, 0, 2}, place);
        EXPECT_EQ(Lattice::place_in_block(node), place);
        EXPECT_EQ(lattice.block_of(node), lattice.block_index({1, 0, 2}));
        keys.insert(Lattice::key(node));
    }
    EXPECT_EQ(keys.size(), std::size_t(Lattice::kBlockNodes));
    EXPECT_EQ(lattice.block_at(lattice.block_index({1, 0, 2})), (std::array<std::int32_t, 3>{1, 0, 2}));
}

}  // namespace
}  // namespace mq::wrap
