// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/angle_refinement.h"

#include "triangulate/checks.h"

namespace mq::triangulate {
namespace {

using geometry::Part;

struct Setting {
    const char* name;
    double min_angle;
    Insertion insertion;
};

class RefineTest : public testing::TestWithParam<Setting> {
  protected:
    TriangulateOptions options() const {
        TriangulateOptions result;
        result.min_angle = GetParam().min_angle;
        result.insertion = GetParam().insertion;
        return result;
    }
};

INSTANTIATE_TEST_SUITE_P(Settings, RefineTest,
                         testing::Values(Setting{"OffCentre20", 20.0, Insertion::OffCentre},
                                         Setting{"OffCentre25", 25.0, Insertion::OffCentre},
                                         Setting{"OffCentre30", 30.0, Insertion::OffCentre},
                                         Setting{"Paper20", 20.0, Insertion::Circumcentre},
                                         Setting{"Paper25", 25.0, Insertion::Circumcentre},
                                         Setting{"Paper30", 30.0, Insertion::Circumcentre}),
                         [](const auto& setting) { return setting.param.name; });

TEST_P(RefineTest, EveryPartGetsAGoodMesh) {
    for (const Part& part : geometry::all_parts()) {
        SCOPED_TRACE(part.name);
        const Result result = mesh_of(part.model, options());
        expect_sound(result, part.euler, part.closed);
        expect_angles(result, GetParam().min_angle);
        EXPECT_TRUE(result.report.complete);
    }
}

/// Shapes without a small input angle: nothing justifies an angle below the bound there.
TEST_P(RefineTest, SimplePartsNeedNoExemptions) {
    for (const Part& part : geometry::shape_parts()) {
        const bool simple = part.name.find("cone") == std::string::npos && part.name != "cusp";
        if (simple && GetParam().min_angle <= 25.0) {
            const Result result = mesh_of(part.model, options());
            EXPECT_TRUE(result.report.exempt.empty())
                << part.name << ": " << mesh::message_of(result.report.exempt.front().second).text();
        }
    }
}

/// A larger bound needs more triangles, but only a few times as many.
TEST(Refine, MeshesStayCoarse) {
    for (const Part& part : geometry::all_parts()) {
        TriangulateOptions options;
        options.min_angle = 20.0;
        const std::size_t least = mesh_of(part.model, options).mesh.triangles.size();
        options.min_angle = 30.0;
        const std::size_t most = mesh_of(part.model, options).mesh.triangles.size();
        EXPECT_LT(most, 6 * least) << part.name;
        EXPECT_LT(most, 5000u) << part.name;
    }
}

}  // namespace
}  // namespace mq::triangulate
