// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/face_spacing.h"

#include <algorithm>
#include <array>
#include <string>

#include "triangulate/uv_triangle.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

constexpr double kMeasured = 1.0;  // longest side of a cell, in spacings
constexpr int kLeastDepth = 1;
constexpr int kMostDepth = 10;

bool has_plain_curvature(const char* surface) {
    constexpr std::array<const char*, 5> kPlain{"plane", "cylinder", "sphere", "cone", "torus"};
    return std::find(kPlain.begin(), kPlain.end(), std::string(surface)) != kPlain.end();
}

// A part of a coarse triangle.
struct Cell {
    int face;
    int depth;
    UvTriangle triangle;
};

std::vector<Cell> coarse_cells(const geometry::Topology& topology, const geometry::InitialTriangulation& coarse) {
    std::vector<Cell> cells;
    for (int f = 0; f < static_cast<int>(coarse.faces.size()); ++f) {
        if (has_plain_curvature(topology.faces[f].surface)) {
            continue;
        }
        const auto& sites = coarse.faces[f].sites;
        for (const auto& t : coarse.faces[f].triangles) {
            cells.push_back({f,
                             0,
                             {{sites[t[0]].uv, sites[t[1]].uv, sites[t[2]].uv},
                              {sites[t[0]].point, sites[t[1]].point, sites[t[2]].point}}});
        }
    }
    return cells;
}

std::vector<Cell> quarters(geometry::Session& session, const std::vector<Cell>& cells) {
    Engine::Batch batch;
    for (const Cell& c : cells) {
        for (int i = 0; i < 3; ++i) {
            const Vec2 uv = c.triangle.middle(i);
            batch.push_back(Query::face_point(c.face, uv.x(), uv.y()));
        }
    }
    const Engine::Answers answers = session.ask(std::move(batch));
    std::vector<Cell> found;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const Cell& c = cells[k];
        const Answer* a = &answers[3 * k];
        if (!a[0].found() || !a[1].found() || !a[2].found()) {
            continue;
        }
        for (const UvTriangle& quarter : c.triangle.quarters({a[0].point, a[1].point, a[2].point})) {
            found.push_back({c.face, c.depth + 1, quarter});
        }
    }
    return found;
}

}  // namespace

void add_face_spacings(geometry::Session& session, const geometry::InitialTriangulation& coarse,
                       const SpacingBounds& bounds, SpacingField& field, const Progress& progress) {
    std::vector<Cell> open = coarse_cells(session.topology(), coarse);
    while (!open.empty()) {
        progress.check();
        Engine::Batch batch;
        for (const Cell& c : open) {
            const Vec2 uv = (c.triangle.uv[0] + c.triangle.uv[1] + c.triangle.uv[2]) / 3.0;
            batch.push_back(Query::face_curvatures(c.face, uv.x(), uv.y()));
        }
        const Engine::Answers answers = session.ask(std::move(batch));
        std::vector<Cell> next;
        for (std::size_t k = 0; k < open.size(); ++k) {
            const double spacing =
                answers[k].status == geometry::Status::Ok ? spacing_for(answers[k].u, bounds) : bounds.most;
            if (spacing < bounds.most) {
                field.add(answers[k].point, spacing);
            }
            const bool coarse_cell = open[k].triangle.longest_side() > kMeasured * spacing;
            if (open[k].depth < kMostDepth && (open[k].depth < kLeastDepth || coarse_cell)) {
                next.push_back(open[k]);
            }
        }
        open = quarters(session, next);
    }
}

}  // namespace mq::triangulate
