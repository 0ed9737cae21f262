// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/face_cells.h"

#include <random>

#include "triangulate/checks.h"
#include "triangulate/spacing/spacing_field.h"
#include "triangulate/warped_face.h"

/// Number, size and position of cells.
namespace mq::triangulate {
namespace {

FaceCells cells_of(Pipeline& pipeline, int face, double spacing) {
    std::string failure;
    const auto border = face_boundary(pipeline.session, pipeline.initial.chains, pipeline.grid, face, failure);
    return FaceCells(pipeline.session, face, outline_of(border),
                     [spacing](const geometry::Answer&) { return spacing; });
}

double area(const FaceCells& cells, std::size_t cell) {
    const Vec3 across = cells.corner(cell, 2).point - cells.corner(cell, 0).point;
    const Vec3 other = cells.corner(cell, 3).point - cells.corner(cell, 1).point;
    return 0.5 * across.cross(other).norm();
}

TEST(FaceCells, AreAsSmallAsAskedAndNotManyMore) {
    for (const auto& [c, d] : {std::pair{1.0, 1.0}, {30.0, 1.0}, {20.0, 0.05}}) {
        SCOPED_TRACE(std::to_string(c) + " " + std::to_string(d));
        Pipeline pipeline(warped_face(c, d));
        constexpr double kSpacing = 0.25;  // mm, constant over the face.
        FaceCells cells = cells_of(pipeline, 0, kSpacing);
        cells.divide(1.0, pipeline.progress);
        double total = 0.0;
        for (const std::size_t cell : cells.all()) {
            EXPECT_LE(cells.longest_side(cell), kSpacing);
            total += area(cells, cell);
        }
        const double whole = mesh_of(warped_face(1.0, 1.0)).report.area;
        EXPECT_NEAR(total, whole, 0.02 * whole);
        EXPECT_LT(static_cast<double>(cells.all().size()), 4.5 * whole / (kSpacing * kSpacing));
    }
}

TEST(FaceCells, WhatLiesOutsideIsDropped) {
    for (const geometry::Part& part : geometry::shape_parts()) {
        if (part.model->topology().volumes.size() > 1) {
            continue;  // their common faces count twice in the mesh
        }
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        const double spacing = 0.02 * part.model->topology().box.largest_side();
        double total = 0.0;
        double crossed = 0.0;
        for (int f = 0; f < static_cast<int>(pipeline.initial.faces.size()); ++f) {
            FaceCells cells = cells_of(pipeline, f, spacing);
            cells.divide(1.0, pipeline.progress);
            for (const std::size_t cell : cells.all()) {
                (cells.outline(cell).empty() ? total : crossed) += area(cells, cell);
            }
        }
        TriangulateOptions fine;
        fine.chord_height_relative = 1e-3;
        const double whole = mesh_of(part.model, fine).report.area;
        EXPECT_LE(total, 1.01 * whole);
        EXPECT_GE(total + crossed, 0.97 * whole);
    }
}

TEST(FaceCells, HalvesTakeTheirWholesPlace) {
    Pipeline pipeline(warped_face(1.0, 1.0));
    FaceCells cells = cells_of(pipeline, 0, 10.0);
    const std::vector<std::size_t> before = cells.all();
    const std::vector<std::size_t> halves = cells.halve({before[3], before[5]});
    EXPECT_EQ(halves, (std::vector<std::size_t>{before[3], before.size(), before[5], before.size() + 1}));
    EXPECT_EQ(cells.all().size(), before.size() + 2);
}

// The outline follows chords of the border: a few corners inside it may lie beside the face.
TEST(FaceCells, InnerCornersAreThoseOfTheTrimmedFace) {
    for (const geometry::Part& part : geometry::shape_parts()) {
        if (part.name != "holed plate" && part.name != "bored box") {
            continue;
        }
        SCOPED_TRACE(part.name);
        Pipeline pipeline(part.model);
        std::size_t right = 0;
        std::size_t wrong = 0;
        for (int f = 0; f < static_cast<int>(pipeline.initial.faces.size()); ++f) {
            FaceCells cells = cells_of(pipeline, f, 0.02 * part.model->topology().box.largest_side());
            cells.divide(1.0, pipeline.progress);
            for (const FaceCells::Corner& corner : cells.inner_corners()) {
                const auto query = geometry::Query::face_contains(f, corner.uv.x(), corner.uv.y());
                (pipeline.session.ask(query).side < 0 ? wrong : right) += 1;
            }
        }
        EXPECT_GT(right, 1000u);
        EXPECT_LT(wrong, right / 50);
    }
}

}  // namespace
}  // namespace mq::triangulate
