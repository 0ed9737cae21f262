// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/face_boundary.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"

namespace mq::triangulate {

namespace {

using VertexUse = FaceMesh::VertexUse;

// One use of an edge, in the direction in which the face lies on the left.
struct Run {
    int use;
    bool collapsed;
    bool internal;
    int loop;
    std::vector<int> index;  // index of the piece after point i
    std::vector<VertexUse> points;
};

// Returns the average length of the derivatives by u and v, mm, which scales (u, v) to approximate lengths. On a plane
// they are the same everywhere.
Vec2 metric_scale(geometry::Oracle& oracle, int face, bool plane) {
    const geometry::Face& f = oracle.topology().faces[face];
    constexpr int kDerivativeSamples = 5;  // Samples of the derivatives along each parameter; an average needs no more.
    const int steps = plane ? 1 : kDerivativeSamples;
    geometry::Engine::Batch batch;
    batch.reserve(static_cast<std::size_t>(steps * steps));
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double a = (i + 0.5) / steps;
            const double b = (j + 0.5) / steps;
            batch.push_back(geometry::Query::face_derivatives(face, f.low[0] + a * (f.high[0] - f.low[0]),
                                                              f.low[1] + b * (f.high[1] - f.low[1])));
        }
    }
    Vec2 sum = Vec2::Zero();
    int count = 0;
    for (const geometry::Answer& a : oracle.ask(std::move(batch))) {
        if (a.found()) {
            sum += Vec2(a.derivatives[0].norm(), a.derivatives[1].norm());
            ++count;
        }
    }
    const Vec2 mean = count > 0 ? Vec2(sum / count) : Vec2(Vec2::Ones());
    const double floor = 1e-6 * std::max(mean.maxCoeff(), 1e-30);
    return mean.cwiseMax(Vec2::Constant(floor));
}

std::vector<Run> collect_runs(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                              const SinglePrecisionGrid& grid, int face, std::vector<std::size_t>& loop_end,
                              FaceBoundary& border, std::string& failure) {
    const geometry::Topology& topology = oracle.topology();
    std::vector<Run> runs;
    geometry::Engine::Batch batch;
    batch.reserve(points_around(topology, chains, face));
    for (const geometry::Loop& loop : topology.faces[face].loops) {
        for (const int u : loop.uses) {
            const geometry::EdgeUse& use = topology.uses[u];
            const EdgePolyline& chain = chains.chain(use.edge);
            Run run{u, chain.collapsed, use.internal, static_cast<int>(loop_end.size()), {}, {}};
            const int n = static_cast<int>(chain.t.size());
            run.points.reserve(chain.t.size());
            run.index.reserve(chain.t.size());
            for (int k = 0; k < n; ++k) {
                const int i = use.forward ? k : n - 1 - k;
                VertexUse site;
                site.vertex = chain.vertices[i];
                run.points.push_back(site);
                run.index.push_back(chain.collapsed ? -1 : use.forward ? i : i - 1);
                batch.push_back(geometry::Query::use_on_face(u, chain.t[i]));
            }
            runs.push_back(std::move(run));
        }
        loop_end.push_back(runs.size());
    }
    const geometry::Engine::Answers answers = oracle.ask(std::move(batch));
    std::size_t a = 0;
    for (Run& run : runs) {
        for (VertexUse& site : run.points) {
            const geometry::Answer& answer = answers[a++];
            if (!answer.found()) {
                failure = topology.name_of({1, topology.uses[run.use].edge}) + " has no curve on it (" +
                          geometry::to_string(answer.status) + ")";
            }
            site.uv = Vec2(answer.u, answer.v);
            site.normal = answer.normal;
            site.point = chains.vertices()[site.vertex].point;
            if (!run.collapsed && answer.found()) {
                border.deviation = std::max(border.deviation, (grid.to_shape(site.point) - answer.point).norm());
            }
        }
    }
    return runs;
}

// Gives every point of every run its site; coinciding ends share one.
class SiteMerger {
  public:
    SiteMerger(FaceBoundary& border, const std::vector<Run>& runs) : border_(border) {
        for (const Run& run : runs) {
            for (const VertexUse& point : run.points) {
                vertices_.push_back(point.vertex);
            }
        }
        border_.sites.reserve(vertices_.size());
        border_.pieces.reserve(vertices_.size());
        next_.reserve(vertices_.size());
        std::sort(vertices_.begin(), vertices_.end());
        vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
        first_.assign(vertices_.size(), -1);
    }

    // Returns a site of the same vertex within `reach` in the scaled domain, or a new one.
    int find_or_add(const VertexUse& site, double reach) {
        int best = -1;
        double least = reach;
        int* end = &first_[place_of(site.vertex)];
        for (; *end >= 0; end = &next_[*end]) {
            const double d = (border_.scaled(border_.sites[*end].uv) - border_.scaled(site.uv)).norm();
            if (d <= least) {
                least = d;
                best = *end;
            }
        }
        if (best >= 0) {
            return best;
        }
        const int id = static_cast<int>(border_.sites.size());
        *end = id;
        next_.push_back(-1);
        border_.sites.push_back(site);
        return id;
    }

  private:
    std::size_t place_of(int vertex) const {
        return static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) -
                                        vertices_.begin());
    }

    FaceBoundary& border_;
    std::vector<int> vertices_;  // ascending
    std::vector<int> first_;     // by place of a vertex: its first site, or -1
    std::vector<int> next_;      // by site: the next one of its vertex, or -1
};

// Returns the length of a run's shortest piece in the scaled domain, which limits the distance within which images of
// its ends are merged.
double end_reach(const FaceBoundary& border, const Run& run) {
    double shortest = 1e300;
    for (std::size_t i = 1; i < run.points.size(); ++i) {
        shortest = std::min(shortest, (border.scaled(run.points[i].uv) - border.scaled(run.points[i - 1].uv)).norm());
    }
    return shortest;
}

// The place where two runs of a loop meet. The images of one node may be as far apart as its tolerance and those of
// the edges allow, which can exceed the length of a piece: without merging, the loop would turn back between them.
struct Joint {
    int site = -1;       // -1: not reached yet
    double reach = 0.0;  // mm, in the scaled domain

    bool holds(const FaceBoundary& border, const VertexUse& point) const {
        return site >= 0 && border.sites[site].vertex == point.vertex &&
               (border.scaled(border.sites[site].uv) - border.scaled(point.uv)).norm() <= reach;
    }
};

// @return the sites of the run's ends.
std::array<int, 2> add_run(FaceBoundary& border, SiteMerger& merger, const Run& run, double reach, const Joint& before,
                           const Joint& after) {
    const std::size_t n = run.points.size();
    // A point in space has one image, if it is no larger than the tolerances allow.
    const double own = (run.collapsed ? 1.0 : 0.25) * end_reach(border, run);
    std::vector<int> ids(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool end = i == 0 || i + 1 == n;
        const Joint& joint = i == 0 ? before : after;
        ids[i] = end && joint.holds(border, run.points[i])
                     ? joint.site
                     : merger.find_or_add(run.points[i], end ? std::min(std::max(reach, 1e-9), own) : 0.0);
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        if (ids[i] != ids[i + 1]) {
            border.pieces.push_back({ids[i], ids[i + 1], run.use, run.index[i], run.internal, run.loop});
        }
    }
    return {ids.front(), ids.back()};
}

// A loop may jump between two images of one vertex in (u, v) where the model has no edge: at a pole that is not marked
// as degenerate. A collapsed piece bridges the jump.
void bridge_gaps(FaceBoundary& border) {
    const std::size_t n = border.pieces.size();
    for (std::size_t begin = 0; begin < n;) {
        std::size_t end = begin;
        while (end < n && border.pieces[end].loop == border.pieces[begin].loop) {
            ++end;
        }
        for (std::size_t i = begin; i < end; ++i) {
            const int from = border.pieces[i].to;
            const int to = border.pieces[i + 1 < end ? i + 1 : begin].from;
            if (from != to && border.sites[from].vertex == border.sites[to].vertex) {
                border.pieces.push_back({from, to, -1, -1, false, border.pieces[i].loop});
            }
        }
        begin = end;
    }
}

}  // namespace

void FaceBoundary::find_collapsed_runs() {
    DisjointSets<int> runs(sites.size());
    for (const Piece& piece : pieces) {
        if (piece.collapsed() && same_vertex(sites[piece.from], sites[piece.to])) {
            runs.unite(piece.from, piece.to);
        }
    }
    int count = 0;
    collapsed_run = runs.number(count);
}

std::size_t points_around(const geometry::Topology& topology, const EdgeDiscretisation& chains, int face) {
    std::size_t points = 0;
    for (const geometry::Loop& loop : topology.faces[face].loops) {
        for (const int u : loop.uses) {
            points += chains.chain(topology.uses[u].edge).t.size();
        }
    }
    return points;
}

FaceBoundary face_boundary(geometry::Oracle& oracle, const EdgeDiscretisation& chains, const SinglePrecisionGrid& grid,
                           int face, std::string& failure) {
    const geometry::Topology& topology = oracle.topology();
    FaceBoundary border;
    border.plane = std::string(topology.faces[face].surface) == "plane";
    border.scale = metric_scale(oracle, face, border.plane);
    std::vector<std::size_t> loop_end;
    const std::vector<Run> runs = collect_runs(oracle, chains, grid, face, loop_end, border, failure);
    if (!failure.empty()) {
        return border;
    }
    const auto tolerance_of = [&](const Run& run) {
        const geometry::Edge& edge = topology.edges[topology.uses[run.use].edge];
        double tolerance = edge.tolerance;
        for (const int n : edge.nodes) {
            tolerance = std::max(tolerance, n >= 0 ? topology.nodes[n].tolerance : 0.0);
        }
        return tolerance;
    };
    constexpr double kTolerances = 4.0;  // Images of a node may be apart by the tolerances of two edges and two nodes.
    double tolerance = std::max(topology.faces[face].tolerance, grid.resolution());
    for (const Run& run : runs) {
        tolerance = std::max(tolerance, tolerance_of(run));
    }
    SiteMerger merger(border, runs);
    for (std::size_t loop = 0, first = 0; loop < loop_end.size(); first = loop_end[loop++]) {
        std::array<int, 2> ends{-1, -1};
        int start = -1;
        for (std::size_t r = first; r < loop_end[loop]; ++r) {
            const std::size_t next = r + 1 < loop_end[loop] ? r + 1 : first;
            const std::size_t last = r > first ? r - 1 : loop_end[loop] - 1;
            const double own = tolerance_of(runs[r]);
            const Joint before{ends[1], kTolerances * std::max(own, tolerance_of(runs[last]))};
            const Joint after{next == first ? start : -1, kTolerances * std::max(own, tolerance_of(runs[next]))};
            ends = add_run(border, merger, runs[r], kTolerances * tolerance, before, after);
            start = r == first ? ends[0] : start;
        }
    }
    bridge_gaps(border);
    return border;
}

std::vector<std::optional<Vec2>> middles_of_pieces(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                                                   const FaceBoundary& border) {
    geometry::Engine::Batch batch;
    batch.reserve(border.pieces.size());
    std::vector<std::size_t> asked;
    asked.reserve(border.pieces.size());
    for (std::size_t k = 0; k < border.pieces.size(); ++k) {
        const FaceBoundary::Piece& p = border.pieces[k];
        if (!p.collapsed()) {
            const std::vector<double>& t = chains.chain(oracle.topology().uses[p.use].edge).t;
            batch.push_back(geometry::Query::use_on_face(p.use, 0.5 * (t[p.index] + t[p.index + 1])));
            asked.push_back(k);
        }
    }
    std::vector<std::optional<Vec2>> middles(border.pieces.size());
    const geometry::Engine::Answers answers = oracle.ask(std::move(batch));
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (answers[i].found()) {
            middles[asked[i]] = border.scaled(Vec2(answers[i].u, answers[i].v));
        }
    }
    return middles;
}

std::vector<VertexUse> sites_of_points(geometry::Oracle& oracle, const EdgeDiscretisation& chains,
                                       const SinglePrecisionGrid& grid, int face, const FaceBoundary& border) {
    std::vector<VertexUse> result;
    for (const int node : oracle.topology().faces[face].points) {
        VertexUse site;
        site.vertex = chains.vertex_of_node(node);
        site.point = chains.vertices()[site.vertex].point;
        const bool on_border = std::any_of(border.sites.begin(), border.sites.end(),
                                           [&](const VertexUse& s) { return s.vertex == site.vertex; });
        const geometry::Answer foot = oracle.ask(geometry::Query::face_nearest_global(face, grid.to_shape(site.point)));
        if (!on_border && foot.found()) {
            site.uv = Vec2(foot.u, foot.v);
            site.normal = foot.normal;
            result.push_back(site);
        }
    }
    return result;
}

}  // namespace mq::triangulate
