// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/boolean_report.h"

#include <gtest/gtest.h>

namespace mq::workflows {
namespace {

BooleanReport sound() {
    BooleanReport report;
    report.closed = report.oriented = report.manifold = true;
    report.triangles = 12;
    report.error_bound = 0.01;
    report.tolerance_asked = 0.05;
    return report;
}

TEST(BooleanReport, IsMetWithoutFaultsAndWithinTheTolerance) {
    EXPECT_TRUE(met(sound()));
    BooleanReport report = sound();
    report.error_bound = 0.06;
    EXPECT_FALSE(met(report));
    report = sound();
    report.faults_left = 1;
    EXPECT_FALSE(met(report));
    report = sound();
    report.manifold = false;
    EXPECT_FALSE(met(report));
}

TEST(BooleanReport, TextsNameBoundRepairsAndFittedVertices) {
    BooleanReport report = sound();
    report.repaired = {Message::value("operand A: 1 hole was filled")};
    EXPECT_NE(in_short(report).find("max. deviation 0.01 mm of 0.05 mm"), std::string::npos);
    EXPECT_EQ(to_text(report).find("on surfaces"), std::string::npos);
    report.fitted_vertices = 7;
    const std::string text = to_text(report);
    for (const char* words : {"on surfaces  7 vertices put there", "repaired     operand A: 1 hole was filled",
                              "deviation    0.01 mm; requested at most 0.05 mm"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    }
}

}  // namespace
}  // namespace mq::workflows
