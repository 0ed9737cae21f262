// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/mesh_cache.h"

#include "triangulate/incremental/remeshing.h"

namespace mq::triangulate {
namespace {

TEST(MeshCache, ForgetsWhatWasUsedLeastLately) {
    const auto part = [](double radius) { return geometry::make_cylinder(radius, 1.0); };
    MeshCache memory(2);
    const Result one = run(part(1.0), {}, memory);
    run(part(2.0), {}, memory);
    expect_same(run(part(1.0), {}, memory), one);
    run(part(3.0), {}, memory);  // evicts the run with 2.0
    EXPECT_EQ(memory.runs(), 2U);
    EXPECT_GT(run(part(1.0), {}, memory).report.reused_faces, 0U);
    EXPECT_EQ(run(part(2.0), {}, memory).report.reused_faces, 0U);
}

TEST(MeshCache, KeepsToItsBytes) {
    const auto part = [](double radius) { return geometry::make_cylinder(radius, 1.0); };
    MeshCache all;
    run(part(1.0), {}, all);
    const std::size_t bytes = all.bytes();
    EXPECT_GT(bytes, 0U);
    MeshCache memory(8, bytes + bytes / 2);
    run(part(1.0), {}, memory);
    run(part(2.0), {}, memory);
    EXPECT_EQ(memory.runs(), 1U);
    EXPECT_LE(memory.bytes(), bytes + bytes / 2);
    MeshCache none(8, bytes / 2);
    run(part(1.0), {}, none);
    EXPECT_EQ(none.runs(), 0U);
}

}  // namespace
}  // namespace mq::triangulate
