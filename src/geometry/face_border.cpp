// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/face_border.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mq::geometry {

namespace {

using Site = FaceTriangulation::Site;

// One use of an edge, walked with the face on the left.
struct Run {
    int use;
    bool collapsed;
    bool internal;
    std::vector<int> index;  // of the piece after point i
    std::vector<Site> points;
};

// Average stretch of the parameter lines, so that distances in (u, v) mean something.
Vec2 metric_scale(Session& session, int face) {
    const Face& f = session.topology().faces[face];
    constexpr int kSteps = 5;
    Engine::Batch batch;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double a = (i + 0.5) / kSteps;
            const double b = (j + 0.5) / kSteps;
            batch.push_back(Query::face_derivatives(face, f.low[0] + a * (f.high[0] - f.low[0]),
                                                    f.low[1] + b * (f.high[1] - f.low[1])));
        }
    }
    Vec2 sum = Vec2::Zero();
    int count = 0;
    for (const Answer& a : session.ask(std::move(batch))) {
        if (a.found()) {
            sum += Vec2(a.derivatives[0].norm(), a.derivatives[1].norm());
            ++count;
        }
    }
    const Vec2 mean = count > 0 ? Vec2(sum / count) : Vec2(Vec2::Ones());
    const double floor = 1e-6 * std::max(mean.maxCoeff(), 1e-30);
    return mean.cwiseMax(Vec2::Constant(floor));
}

std::vector<Run> collect_runs(Session& session, const EdgeChains& chains, const SingleGrid& grid, int face,
                              std::vector<std::size_t>& loop_end, FaceBorder& border, std::string& failure) {
    const Topology& topology = session.topology();
    std::vector<Run> runs;
    Engine::Batch batch;
    for (const Loop& loop : topology.faces[face].loops) {
        for (const int u : loop.uses) {
            const EdgeUse& use = topology.uses[u];
            const EdgeChain& chain = chains.chain(use.edge);
            Run run{u, chain.collapsed, use.internal, {}, {}};
            const int n = static_cast<int>(chain.t.size());
            for (int k = 0; k < n; ++k) {
                const int i = use.forward ? k : n - 1 - k;
                Site site;
                site.vertex = chain.vertices[i];
                run.points.push_back(site);
                run.index.push_back(chain.collapsed ? -1 : use.forward ? i : i - 1);
                batch.push_back(Query::use_on_face(u, chain.t[i]));
            }
            runs.push_back(std::move(run));
        }
        loop_end.push_back(runs.size());
    }
    const Engine::Answers answers = session.ask(std::move(batch));
    std::size_t a = 0;
    for (Run& run : runs) {
        for (Site& site : run.points) {
            const Answer& answer = answers[a++];
            if (!answer.found()) {
                failure = name_of({1, topology.uses[run.use].edge}) + " has no curve on it (" +
                          to_string(answer.status) + ")";
            }
            site.uv = Vec2(answer.u, answer.v);
            site.normal = answer.normal;
            site.point = chains.vertices()[site.vertex].point;
            if (!run.collapsed && answer.found()) {
                border.deviation = std::max(border.deviation, (grid.to_part(site.point) - answer.point).norm());
            }
        }
    }
    return runs;
}

// Gives every point of every run its site; ends that meet share one.
class SiteMerger {
  public:
    explicit SiteMerger(FaceBorder& border) : border_(border) {}

    int add(const Site& site) {
        border_.sites.push_back(site);
        const int id = static_cast<int>(border_.sites.size()) - 1;
        of_vertex_[site.vertex].push_back(id);
        return id;
    }
    // A site of the same vertex within `reach` in the scaled domain, or a new one.
    int find_or_add(const Site& site, double reach) {
        int best = -1;
        double least = reach;
        for (const int s : of_vertex_[site.vertex]) {
            const double d = (border_.scaled(border_.sites[s].uv) - border_.scaled(site.uv)).norm();
            if (d <= least) {
                least = d;
                best = s;
            }
        }
        return best >= 0 ? best : add(site);
    }

  private:
    FaceBorder& border_;
    std::map<int, std::vector<int>> of_vertex_;
};

// How far apart in (u, v) two images of the end of a run may lie and still be one: a part of its shortest piece.
double end_reach(const FaceBorder& border, const Run& run) {
    double shortest = 1e300;
    for (std::size_t i = 1; i < run.points.size(); ++i) {
        shortest = std::min(shortest, (border.scaled(run.points[i].uv) - border.scaled(run.points[i - 1].uv)).norm());
    }
    return shortest;
}

void add_run(FaceBorder& border, SiteMerger& merger, const Run& run, double reach) {
    const std::size_t n = run.points.size();
    const double own = 0.25 * end_reach(border, run);
    std::vector<int> ids(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool end = i == 0 || i + 1 == n;
        ids[i] = merger.find_or_add(run.points[i], end ? std::min(std::max(reach, 1e-9), own) : 0.0);
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        if (ids[i] != ids[i + 1]) {
            border.pieces.push_back({ids[i], ids[i + 1], run.use, run.index[i], run.internal});
        }
    }
}

// A loop may jump between two images of one vertex in (u, v) where the model has no edge for it: at a pole that is not
// marked as degenerate. The jump is bridged by a collapsed piece.
void bridge_gaps(FaceBorder& border, const std::vector<std::size_t>& loop_of_piece) {
    const std::size_t n = border.pieces.size();
    for (std::size_t begin = 0; begin < n;) {
        std::size_t end = begin;
        while (end < n && loop_of_piece[end] == loop_of_piece[begin]) {
            ++end;
        }
        for (std::size_t i = begin; i < end; ++i) {
            const int from = border.pieces[i].to;
            const int to = border.pieces[i + 1 < end ? i + 1 : begin].from;
            if (from != to && border.sites[from].vertex == border.sites[to].vertex) {
                border.pieces.push_back({from, to, -1, -1, false});
            }
        }
        begin = end;
    }
}

}  // namespace

FaceBorder face_border(Session& session, const EdgeChains& chains, const SingleGrid& grid, int face,
                       std::string& failure) {
    const Topology& topology = session.topology();
    FaceBorder border;
    border.scale = metric_scale(session, face);
    border.plane = std::string(topology.faces[face].surface) == "plane";
    std::vector<std::size_t> loop_end;
    const std::vector<Run> runs = collect_runs(session, chains, grid, face, loop_end, border, failure);
    if (!failure.empty()) {
        return border;
    }
    double tolerance = topology.faces[face].tolerance;
    for (const Run& run : runs) {
        const Edge& edge = topology.edges[topology.uses[run.use].edge];
        tolerance = std::max(tolerance, edge.tolerance);
        for (const int n : edge.nodes) {
            tolerance = std::max(tolerance, n >= 0 ? topology.nodes[n].tolerance : 0.0);
        }
    }
    const double reach = 4.0 * std::max(tolerance, grid.resolution());
    SiteMerger merger(border);
    std::vector<std::size_t> loop_of_piece;
    std::size_t loop = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        while (loop < loop_end.size() && r >= loop_end[loop]) {
            ++loop;
        }
        add_run(border, merger, runs[r], reach);
        loop_of_piece.resize(border.pieces.size(), loop);
    }
    bridge_gaps(border, loop_of_piece);
    return border;
}

}  // namespace mq::geometry
