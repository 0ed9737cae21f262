// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/triangulation_rounds.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <set>
#include <utility>

#include "base/stopwatch.h"
#include "triangulate/initial/face_boundary.h"

namespace mq::triangulate {

namespace {

// Modellers leave end artefacts at the ends of curves on faces: short stretches that lie on the curve of the next
// edge. Some are longer than the tolerance of the node; where nothing else helps, samples are suppressed within this
// number of node tolerances.
constexpr std::array<double, 2> kHooks{8.0, 32.0};

// Pieces around one face that a round halves at most. Where borders lie on each other all of their pieces cross,
// however short they are: twenty rounds would make a million times as many.
constexpr std::size_t kMostHalved = 4096;

// One round: triangulates the faces and advances the progress from one fraction of the stage to another.
struct Round {
    const std::vector<int>& faces;
    bool border_may_change;
    double from;
    double to;
};
using RoundTriangulator = std::function<void(const Round& round)>;

std::vector<int> faces_of(const geometry::Topology& topology, const std::set<int>& edges,
                          const std::function<bool(int)>& included) {
    std::set<int> faces;
    for (const int e : edges) {
        for (const int u : topology.edges[e].uses) {
            if (included(topology.uses[u].face)) {
                faces.insert(topology.uses[u].face);
            }
        }
    }
    return {faces.begin(), faces.end()};
}

void add_refused(const InitialTriangulation& result, std::vector<int>& open) {
    for (int f = 0; f < static_cast<int>(result.faces.size()); ++f) {
        if (!result.faces[f].marks.empty() && std::find(open.begin(), open.end(), f) == open.end()) {
            open.push_back(f);
        }
    }
}

void name_failures(InitialTriangulation& result, const std::function<bool(int)>& included) {
    for (int f = 0; f < static_cast<int>(result.faces.size()); ++f) {
        const FaceMesh& face = result.faces[f];
        if (!included(f)) {
            continue;
        }
        if (!face.failure.empty()) {
            result.failures.emplace_back(f, face.failure);
        } else if (!face.marks.empty()) {
            result.failures.emplace_back(f,
                                         "its border cannot be resolved: pieces cross or fold however short they are");
        }
    }
}

// Returns the edges of faces that could not be triangulated: those with obstructing pieces, or all edges of the face
// where its triangulation failed without naming pieces.
std::set<int> edges_in_the_way(const InitialTriangulation& result, const geometry::Topology& topology,
                               const std::function<bool(int)>& included) {
    std::set<int> edges;
    for (int f = 0; f < static_cast<int>(result.faces.size()); ++f) {
        const FaceMesh& face = result.faces[f];
        for (const EdgeDiscretisation::PieceRef& piece : face.marks) {
            if (included(f)) {
                edges.insert(piece.first);
            }
        }
        if (!face.failure.empty() && included(f)) {
            const std::set<int> around = topology.edges_of(f);
            edges.insert(around.begin(), around.end());
        }
    }
    return edges;
}

void run_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                const RoundLimits& limits, const std::function<bool(int)>& included,
                const RoundTriangulator& triangulate) {
    bool shaping = true;
    for (int round = 0; round < limits.rounds && !open.empty(); ++round) {
        triangulate({open, shaping, round / (round + 2.0), (round + 1.0) / (round + 2.0)});
        std::set<EdgeDiscretisation::PieceRef> marks;
        for (const int f : open) {
            const std::set<EdgeDiscretisation::PieceRef>& wished = result.faces[f].marks;
            if (wished.size() <= kMostHalved) {
                marks.insert(wished.begin(), wished.end());
            }
        }
        open = faces_of(session.topology(), result.chains.halve(session, marks), included);
        if (shaping && (round + 1 == limits.shaping || open.empty())) {
            shaping = false;
            add_refused(result, open);
        }
    }
}

// Faces with long borders first, so that no thread is left with one of them in the end.
std::vector<int> longest_border_first(const InitialTriangulation& result, const geometry::Topology& topology,
                                      const std::vector<int>& faces) {
    std::vector<std::pair<std::size_t, int>> order;
    order.reserve(faces.size());
    for (const int f : faces) {
        order.emplace_back(points_around(topology, result.chains, f), f);
    }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<int> sorted;
    sorted.reserve(order.size());
    for (const auto& [points, f] : order) {
        sorted.push_back(f);
    }
    return sorted;
}

// Triangulates the faces of a round on several threads, in turns.
void run_in_parallel(geometry::Session& session, const std::vector<int>& faces, Progress& progress, const Round& round,
                     const ParallelFaceTriangulator& triangulate) {
    std::vector<int> left = faces;
    std::mutex progress_mutex;
    double done = 0.0;
    while (!left.empty()) {
        const Stopwatch watch;
        std::vector<char> finished(left.size(), 0);
        session.run_parallel(static_cast<int>(left.size()), [&](geometry::Answerer& answerer, int k) {
            if (k > 0 && watch.wall() > std::chrono::duration<double>(geometry::Session::kOpenAfter).count()) {
                return;
            }
            progress.check();
            geometry::AnswererOracle oracle(session.topology(), answerer, &progress);
            triangulate(oracle, left[static_cast<std::size_t>(k)], round.border_may_change);
            finished[static_cast<std::size_t>(k)] = 1;
            const std::lock_guard<std::mutex> lock(progress_mutex);
            progress.advance(round.from + (round.to - round.from) * ++done / static_cast<double>(faces.size()));
        });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (finished[i] == 0) {
                left[kept++] = left[i];
            }
        }
        left.resize(kept);
    }
}

void run_all_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                    const RoundLimits& limits, const std::function<bool(int)>& included,
                    const RoundTriangulator& triangulate) {
    const geometry::Topology& topology = session.topology();
    run_rounds(session, result, std::move(open), limits, included, triangulate);
    for (const double tolerances : kHooks) {
        const std::set<int> changed =
            result.chains.suppress_near_nodes(topology, edges_in_the_way(result, topology, included), tolerances);
        open = faces_of(topology, changed, included);
        run_rounds(session, result, std::move(open), limits, included, triangulate);
    }
    name_failures(result, included);
}

}  // namespace

void triangulate_in_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                           const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                           const FaceTriangulator& triangulate) {
    run_all_rounds(session, result, std::move(open), limits, included, [&](const Round& round) {
        double done = 0.0;
        for (const int f : round.faces) {
            progress.check();
            triangulate(f, round.border_may_change);
            progress.advance(round.from + (round.to - round.from) * ++done / static_cast<double>(round.faces.size()));
        }
    });
}

void triangulate_in_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                           const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                           const ParallelFaceTriangulator& triangulate) {
    run_all_rounds(session, result, std::move(open), limits, included, [&](const Round& round) {
        const std::vector<int> order = longest_border_first(result, session.topology(), round.faces);
        run_in_parallel(session, order, progress, round, triangulate);
    });
}

}  // namespace mq::triangulate
