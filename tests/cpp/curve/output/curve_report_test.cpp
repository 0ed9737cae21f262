// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curve/output/curved_mesh.h"

namespace mq::curve {
namespace {

TEST(CurveReport, VolumeErrorIsAFractionOrUnknown) {
    CurveReport report;
    EXPECT_EQ(report.volume_error(), -1.0);
    report.cad_volume = 8.0;
    report.volume = 6.0;
    EXPECT_EQ(report.volume_error(), 0.25);
}

TEST(CurveReport, TextNamesWhatIsInvalidAndOnlyRepairsThatWereMade) {
    CurveReport report;
    report.elements = 12;
    report.vertices = 7;
    report.invalid = 1;
    report.invalid_before = 3;
    report.invalid_elements = {"triangle 3 on Face1"};
    report.straightened = {"tetrahedron 5"};
    report.repairs = {{"edge swaps", 4}, {"edge collapses", 0}};
    report.notes = {Message::value("A note.")};
    const std::string text = to_text(report);
    EXPECT_NE(text.find("12 elements, 7 vertices, 1 invalid (3 before repair)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("invalid: triangle 3 on Face1\n"), std::string::npos) << text;
    EXPECT_NE(text.find("made straight: tetrahedron 5\n"), std::string::npos) << text;
    EXPECT_NE(text.find("edge swaps: 4\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("edge collapses"), std::string::npos) << text;
    EXPECT_NE(text.find("A note.\n"), std::string::npos) << text;
}

TEST(CurveReport, TextSaysOfTheStraightMeshAndTheVolumeOnlyWhatIsKnown) {
    CurveReport report;
    EXPECT_EQ(to_text(report).find("before curving"), std::string::npos);
    EXPECT_EQ(to_text(report).find("volume"), std::string::npos);
    report.straight.triangles = 20;
    report.straight.min_angle = 26.5;
    report.straight.min_angle_asked = 25.0;
    report.cad_volume = 4.0;
    report.volume = 5.0;
    const std::string text = to_text(report);
    EXPECT_NE(text.find("smallest angle 26.500 (requested 25.000)"), std::string::npos) << text;
    EXPECT_NE(text.find("by a fraction of 0.25\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace mq::curve
