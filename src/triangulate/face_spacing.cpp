// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/face_spacing.h"

#include <algorithm>
#include <array>
#include <string>

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

// A triangle in (u, v) with the places of its corners in space.
struct Cell {
    int face;
    int depth;
    std::array<Vec2, 3> uv;
    std::array<Vec3, 3> point;

    double longest_side() const {
        return std::max({(point[1] - point[0]).norm(), (point[2] - point[1]).norm(), (point[0] - point[2]).norm()});
    }
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
                             {sites[t[0]].uv, sites[t[1]].uv, sites[t[2]].uv},
                             {sites[t[0]].point, sites[t[1]].point, sites[t[2]].point}});
        }
    }
    return cells;
}

std::vector<Cell> quarters(geometry::Session& session, const std::vector<Cell>& cells) {
    Engine::Batch batch;
    for (const Cell& c : cells) {
        for (int i = 0; i < 3; ++i) {
            const Vec2 uv = 0.5 * (c.uv[i] + c.uv[(i + 1) % 3]);
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
        Cell middle{c.face, c.depth + 1, {}, {a[0].point, a[1].point, a[2].point}};
        for (int i = 0; i < 3; ++i) {
            middle.uv[i] = 0.5 * (c.uv[i] + c.uv[(i + 1) % 3]);
        }
        for (int i = 0; i < 3; ++i) {
            found.push_back({c.face,
                             c.depth + 1,
                             {c.uv[i], middle.uv[i], middle.uv[(i + 2) % 3]},
                             {c.point[i], middle.point[i], middle.point[(i + 2) % 3]}});
        }
        found.push_back(middle);
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
            const Vec2 uv = (c.uv[0] + c.uv[1] + c.uv[2]) / 3.0;
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
            const bool coarse_cell = open[k].longest_side() > kMeasured * spacing;
            if (open[k].depth < kMostDepth && (open[k].depth < kLeastDepth || coarse_cell)) {
                next.push_back(open[k]);
            }
        }
        open = quarters(session, next);
    }
}

}  // namespace mq::triangulate
