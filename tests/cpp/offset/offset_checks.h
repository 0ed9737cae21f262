// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "boolean/boolean.h"
#include "mesh/quality/surface_verification.h"
#include "offset/trimmed/trimmed_offset.h"

/// What the tests of trimmed and of contoured offsets share.
namespace mq::offset::checks {

inline double volume(const mesh::TriangleMesh& mesh) {
    return mesh::verify(mesh.vertices, mesh.triangles).volume;
}

inline mesh::TriangleMesh united(const std::vector<const mesh::TriangleMesh*>& bodies,
                                 boolean::Operation operation = boolean::Operation::Union) {
    boolean::BooleanOptions options;
    options.tolerance = 1e-3;
    return boolean::boolean(bodies, operation, options).mesh;
}

/// Checks what is promised of every offset that keeps its tolerance, and returns it.
inline OffsetResult sound(OffsetResult result, double tolerance) {
    EXPECT_TRUE(mesh::verify(result.mesh.vertices, result.mesh.triangles).passed());
    EXPECT_LE(result.error_bound, tolerance);
    EXPECT_EQ(result.triangle_source.size(), result.mesh.triangles.size());
    return result;
}

}  // namespace mq::offset::checks
