// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/triangle_fidelity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mq::triangulate {
namespace {

/// A right triangle in the plane z = 0, on a surface whose normals at the corners lean by some degrees.
struct Sample {
    explicit Sample(double degrees, double height = 0.0) {
        const double angle = degrees * kDegree;
        const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
        sites[0].point = Vec3(0, 0, 0);
        sites[1].point = Vec3(1, 0, 0);
        sites[2].point = Vec3(0, 1, 0);
        for (FaceMesh::VertexUse& site : sites) {
            site.normal = normal;
        }
        triangle = {{&sites[0], &sites[1], &sites[2]}, Vec3(1.0 / 3.0, 1.0 / 3.0, height), normal, false, 1e-6, 1e-6};
    }
    Sample(const Sample&) = delete;
    Sample& operator=(const Sample&) = delete;

    std::array<FaceMesh::VertexUse, 3> sites;
    TriangleOnFace triangle;
};

TEST(TriangleFidelity, NormalsMayDeviateBy35Degrees) {
    EXPECT_EQ(fault_of(Sample(34.0).triangle), TriangleFault::None);
    EXPECT_EQ(fault_of(Sample(36.0).triangle), TriangleFault::NormalDeviation);
}

TEST(TriangleFidelity, AtASingularPointBy70Degrees) {
    for (const auto& [degrees, fault] :
         {std::pair{69.0, TriangleFault::None}, {71.0, TriangleFault::NormalDeviation}}) {
        Sample sample(degrees);
        sample.sites[0].normal = Vec3::Zero();
        EXPECT_EQ(fault_of(sample.triangle), fault) << degrees;
    }
}

TEST(TriangleFidelity, TheChordErrorMayBeHalfOfTheHeight) {
    const double height = 1.0 / std::sqrt(2.0);
    EXPECT_EQ(fault_of(Sample(0.0, 0.49 * height).triangle), TriangleFault::None);
    EXPECT_EQ(fault_of(Sample(0.0, 0.51 * height).triangle), TriangleFault::ChordDeviation);
    Sample small(0.0, 0.51 * height);
    small.triangle.sag_that_counts = 1.0;
    EXPECT_EQ(fault_of(small.triangle), TriangleFault::None) << "a smaller one than matters";
}

TEST(TriangleFidelity, UpsideDownIsAFaultOfTheBorder) {
    EXPECT_EQ(fault_of(Sample(120.0).triangle), TriangleFault::ChordDeviation);
    Sample reversed(0.0);
    reversed.triangle.reversed = true;
    EXPECT_EQ(fault_of(reversed.triangle), TriangleFault::ChordDeviation);
}

TEST(TriangleFidelity, LowTrianglesNeedNotFollowTheSurface) {
    Sample sample(80.0);
    sample.triangle.least_height = 0.8;
    EXPECT_EQ(fault_of(sample.triangle), TriangleFault::None);
}

}  // namespace
}  // namespace mq::triangulate
