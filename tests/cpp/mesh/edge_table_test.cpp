// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/edge_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"
#include "mesh/random_triangles.h"
#include "mesh/sample_meshes.h"

namespace mq::mesh {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

TEST(EdgeTable, HasEveryEdgeWithAllCornersInOrder) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const std::vector<Triangle> triangles = random_triangles(seed, 12, 80);
        std::map<Edge, std::vector<std::uint32_t>> expected;
        for (std::uint32_t corner = 0; corner < 240; ++corner) {
            const Triangle& t = triangles[corner / 3];
            if (!is_collapsed(t)) {
                expected[std::minmax(t[corner % 3], t[(corner + 1) % 3])].push_back(corner);
            }
        }
        std::map<Edge, std::vector<std::uint32_t>> found;
        Edge last{-1, -1};
        EdgeTable(triangles, 12)
            .for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* end) {
                EXPECT_LT(last, Edge(low, high)) << "ascending, each once";
                last = {low, high};
                found[last].assign(first, end);
            });
        EXPECT_EQ(found, expected);
    }
}

TEST(RequireValid, NamesWhatIsWrong) {
    const TriangleMesh good = samples::tetrahedron();
    EXPECT_NO_THROW(require_valid(good));
    TriangleMesh mesh = good;
    mesh.triangles[1][2] = 4;
    EXPECT_THROW(require_valid(mesh), InvalidInput);
    mesh = good;
    mesh.vertices[0].x() = std::numeric_limits<double>::infinity();
    EXPECT_THROW(require_valid(mesh), InvalidInput);
    mesh = good;
    mesh.triangle_face = {0};
    EXPECT_THROW(require_valid(mesh), InvalidInput);
}

}  // namespace
}  // namespace mq::mesh
