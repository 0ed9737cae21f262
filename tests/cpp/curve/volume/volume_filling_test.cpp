// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/volume_filling.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <string>
#include <vector>

#include "base/error.h"
#include "curve/checks.h"
#include "curve/placed_surface.h"
#include "geometry/occt/shape_model.h"

namespace mq::curve {
namespace {

/// A filler whose fillings have the given numbers of invalid tetrahedra, one after the other; a negative number: that
/// one fails. Each puts vertices of its own inside: one in the first filling, two in the second ...
class Stub {
  public:
    explicit Stub(std::vector<int> invalid) : invalid_(std::move(invalid)) {}

    FilledTetrahedralMesh operator()(CurvedSurface& surface, double grading_factor) {
        const auto number = static_cast<int>(gradings.size());
        gradings.push_back(grading_factor);
        TetrahedralMesh volume(surface);
        for (int i = 0; i <= number; ++i) {
            volume.add_vertex(Vec3(0.1 * number, 0.1 * i, 0.5), 0);
        }
        const int count = invalid_.at(static_cast<std::size_t>(number));
        if (count < 0) {
            throw GeometryError("the stub fails");
        }
        for (int i = 0; i < count; ++i) {
            volume.tetrahedra[static_cast<std::size_t>(volume.add(corners, 0))].quality = -1.0;
        }
        volume.add({0, 1, 2, 4}, 0);
        VolumeRepairs repairs;
        repairs.invalid_after = count;
        return {std::move(volume), repairs, 1, {}};
    }

    std::vector<double> gradings;
    std::array<int, 4> corners{0, 1, 2, 3};  ///< corners of the invalid ones

  private:
    std::vector<int> invalid_;
};

/// Four vertices, and one valid triangle between three of them.
class BestFilling : public testing::Test {
  protected:
    BestFilling() {
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1)}) {
            surface.add_vertex({p, {0, 0}});
        }
        surface.triangles[static_cast<std::size_t>(surface.add_triangle({0, 1, 2}, 0))].quality = 1.0;
    }

    FilledTetrahedralMesh fill(Stub& stub) {
        return best_filling(surface, [&](CurvedSurface& bare, double part) {
            EXPECT_EQ(bare.shapes.vertices.size(), 5u) << "it still holds vertices of another filling";
            return stub(bare, part);
        });
    }
    /// The filling that is kept is that one, with its vertices and no other's.
    void expect_kept(const FilledTetrahedralMesh& filled, int number, int invalid) {
        EXPECT_EQ(&filled.volume.surface, &surface);
        EXPECT_EQ(filled.repairs.invalid_after, invalid);
        EXPECT_EQ(filled.volume.tetrahedra.size(), static_cast<std::size_t>(invalid) + 1);
        ASSERT_EQ(surface.shapes.vertices.size(), 6u + static_cast<std::size_t>(number));
        EXPECT_EQ(surface.shapes.vertices[5].point, Vec3(0.1 * number, 0.0, 0.5));
    }

    CurvedSurface surface{2};
};

TEST_F(BestFilling, AValidOneIsTheLast) {
    Stub stub({0});
    const FilledTetrahedralMesh filled = fill(stub);
    expect_kept(filled, 0, 0);
    EXPECT_EQ(filled.fillings, 1);
    EXPECT_TRUE(filled.notes.empty());
}

TEST_F(BestFilling, ABetterOneIsKeptAndIsTheLastWhenItIsValid) {
    Stub stub({3, 0});
    const FilledTetrahedralMesh filled = fill(stub);
    expect_kept(filled, 1, 0);
    EXPECT_EQ(filled.fillings, 2);
    ASSERT_EQ(stub.gradings.size(), 2u);
    EXPECT_LT(stub.gradings[1], stub.gradings[0]);
    ASSERT_EQ(filled.notes.size(), 1u);
    EXPECT_NE(filled.notes[0].find("filled 2 times"), std::string::npos) << filled.notes[0];
    EXPECT_EQ(filled.notes[0].find("failed"), std::string::npos) << filled.notes[0];
}

TEST_F(BestFilling, WhileItGetsBetterItIsFilledAgain) {
    Stub stub({5, 3, 1});
    expect_kept(fill(stub), 2, 1);
    ASSERT_EQ(stub.gradings.size(), 3u);
    EXPECT_LT(stub.gradings[2], stub.gradings[1]);
}

TEST_F(BestFilling, AWorseOneIsDropped) {
    Stub stub({2, 3});
    expect_kept(fill(stub), 0, 2);
    EXPECT_EQ(stub.gradings.size(), 2u) << "nor is there a third";
}

TEST_F(BestFilling, OfEqualOnesTheFirstIsKept) {
    Stub stub({4, 2, 2});
    expect_kept(fill(stub), 1, 2);
}

TEST_F(BestFilling, OneThatFailsKeepsTheFirstAndIsTold) {
    Stub stub({2, -1});
    const FilledTetrahedralMesh filled = fill(stub);
    expect_kept(filled, 0, 2);
    ASSERT_EQ(filled.notes.size(), 1u);
    EXPECT_NE(filled.notes[0].find("the last filling failed: the stub fails"), std::string::npos) << filled.notes[0];
}

TEST_F(BestFilling, TheFirstOneMustNotFail) {
    Stub stub({-1});
    EXPECT_THROW(fill(stub), GeometryError);
}

TEST_F(BestFilling, OnFoldedTrianglesNoOtherIsTried) {
    surface.triangles[0].quality = -0.5;
    Stub hopeless({2});
    expect_kept(fill(hopeless), 0, 2);
}

TEST_F(BestFilling, BesideFoldedTrianglesAnotherIsTried) {
    surface.triangles[0].quality = -0.5;
    Stub stub({2, 0});
    stub.corners = {1, 2, 3, 4};
    expect_kept(fill(stub), 1, 0);
}

TEST(FilledTetrahedralMesh, AFillingThatIsGivenUpIsTold) {
    PlacedCurvedSurface placed(geometry::make_shape_model(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape()), 2, 2.0);
    std::array<int, 3> corners{};
    placed.find("plane", false, corners);
    // The edge is bent through the whole box, so that no tetrahedron at it can be valid.
    placed.surface.shapes.set_edge(corners[0], corners[1], {Vec3(5.0, 5.0, 5.0)});
    Progress progress;
    CurveReport report;
    StageClock clock(report.seconds);
    const FilledTetrahedralMesh filled = fill_and_repair(placed.surface, placed.session.topology(), progress, clock);
    EXPECT_GE(filled.fillings, 2);
    EXPECT_GT(filled.repairs.invalid_after, 0);
    EXPECT_FALSE(filled.volume.living().empty());
    for (const int t : filled.volume.living()) {
        for (const int v : filled.volume.tetrahedra[static_cast<std::size_t>(t)].corners) {
            EXPECT_LT(static_cast<std::size_t>(v), placed.surface.shapes.vertices.size());
        }
    }
    ASSERT_EQ(filled.notes.size(), 1u);
    EXPECT_NE(filled.notes[0].find("elements stayed invalid: the solids were filled"), std::string::npos);
}

}  // namespace
}  // namespace mq::curve
