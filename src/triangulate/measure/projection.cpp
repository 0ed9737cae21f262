// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/projection.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Engine;
using geometry::Query;

// Fractions of a curve's parameter range where searches for the nearest point start, since the distance may have
// several local minima.
constexpr std::array<double, 5> kGuesses{0.02, 0.25, 0.5, 0.75, 0.98};

void keep_nearer(SurfaceProjection& foot, const Answer& answer, int face) {
    if (answer.found() && answer.distance < foot.distance) {
        foot = {answer.distance, face, answer.point, Vec2(answer.u, answer.v), answer.normal};
    }
}

// Returns the edges of the faces: the projection of a point over the chord of a curved border lies on the border.
std::vector<int> edges_of(const geometry::Topology& topology, const std::vector<int>& faces) {
    std::vector<int> edges;
    for (const int face : faces) {
        for (const geometry::Loop& loop : topology.faces[static_cast<std::size_t>(face)].loops) {
            for (const int use : loop.uses) {
                const int e = topology.uses[static_cast<std::size_t>(use)].edge;
                if (!topology.edges[static_cast<std::size_t>(e)].degenerate) {
                    edges.push_back(e);
                }
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

// Projects the points that have no projection on a face yet onto the edges.
void ask_edges(Workspace& work, const std::vector<Vec3>& points, const CandidateFaces& sheets,
               std::vector<SurfaceProjection>& feet) {
    const geometry::Topology& topology = work.session.topology();
    const std::vector<int> edges = edges_of(topology, sheets.faces);
    Engine::Batch batch;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < edges.size() && !feet[i].found(); ++k) {
            const geometry::Edge& edge = topology.edges[static_cast<std::size_t>(edges[k])];
            for (const double part : kGuesses) {
                const double guess = edge.t0 + part * (edge.t1 - edge.t0);
                batch.push_back(Query::edge_nearest(edges[k], work.grid.to_shape(points[i]), guess, edge.t0, edge.t1));
                owner.push_back(i);
            }
        }
    }
    const Engine::Answers answers = work.session.ask(std::move(batch));
    for (std::size_t i = 0; i < answers.size(); ++i) {
        keep_nearer(feet[owner[i]], answers[i], -1);
    }
}

}  // namespace

std::vector<SurfaceProjection> project_onto(Workspace& work, const std::vector<Vec3>& points,
                                            const CandidateFaces& sheets) {
    const std::size_t count = sheets.faces.size();
    Engine::Batch batch;
    for (const Vec3& point : points) {
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3 p = work.grid.to_shape(point);
            const std::optional<Vec2>& guess = sheets.guesses[k];
            batch.push_back(guess ? Query::face_nearest(sheets.faces[k], p, guess->x(), guess->y())
                                  : Query::face_nearest_global(sheets.faces[k], p));
        }
    }
    const Engine::Answers nearest = work.session.ask(std::move(batch));
    std::vector<SurfaceProjection> feet(points.size());
    if (count == 1) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            keep_nearer(feet[i], nearest[i], sheets.faces[0]);
        }
        return feet;
    }
    Engine::Batch inside;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        inside.push_back(Query::face_contains(sheets.faces[i % count], nearest[i].u, nearest[i].v));
    }
    const Engine::Answers sides = work.session.ask(std::move(inside));
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        if (sides[i].found() && sides[i].side >= 0) {
            keep_nearer(feet[i / count], nearest[i], sheets.faces[i % count]);
        }
    }
    ask_edges(work, points, sheets, feet);
    return feet;
}

void sample_edge(const Vec3& a, const Vec3& b, std::vector<Vec3>& points) {
    for (const double at : {0.25, 0.5, 0.75}) {
        points.push_back((1.0 - at) * a + at * b);
    }
}

void sample_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<Vec3>& points) {
    points.push_back((a + b + c) / 3.0);
    points.push_back(0.6 * a + 0.2 * b + 0.2 * c);
    points.push_back(0.2 * a + 0.6 * b + 0.2 * c);
    points.push_back(0.2 * a + 0.2 * b + 0.6 * c);
}

}  // namespace mq::triangulate
