// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/boundary_refinement.h"

#include <algorithm>
#include <array>
#include <set>

namespace mq::triangulate {

namespace {

// Modellers leave end artefacts at the ends of curves on faces: short stretches that lie on the curve of the next
// edge. Some are longer than the tolerance of the node; where nothing else helps, samples are suppressed within this
// number of node tolerances.
constexpr std::array<double, 2> kHooks{8.0, 32.0};

// Pieces around one face that a round halves at most. Where borders lie on each other all of their pieces cross,
// however short they are: twenty rounds would make a million times as many.
constexpr std::size_t kMostHalved = 4096;

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
                const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                const FaceTriangulator& triangulate) {
    bool shaping = true;
    for (int round = 0; round < limits.rounds && !open.empty(); ++round) {
        std::set<EdgeDiscretisation::PieceRef> marks;
        for (std::size_t i = 0; i < open.size(); ++i) {
            progress.check();
            triangulate(open[i], shaping);
            const std::set<EdgeDiscretisation::PieceRef>& wished = result.faces[open[i]].marks;
            if (wished.size() <= kMostHalved) {
                marks.insert(wished.begin(), wished.end());
            }
            progress.advance((round + static_cast<double>(i) / static_cast<double>(open.size())) / (round + 2.0));
        }
        open = faces_of(session.topology(), result.chains.halve(session, marks), included);
        if (shaping && (round + 1 == limits.shaping || open.empty())) {
            shaping = false;
            add_refused(result, open);
        }
    }
}

}  // namespace

void triangulate_in_rounds(geometry::Session& session, InitialTriangulation& result, std::vector<int> open,
                           const RoundLimits& limits, Progress& progress, const std::function<bool(int)>& included,
                           const FaceTriangulator& triangulate) {
    const geometry::Topology& topology = session.topology();
    run_rounds(session, result, std::move(open), limits, progress, included, triangulate);
    for (const double tolerances : kHooks) {
        const std::set<int> changed =
            result.chains.suppress_near_nodes(topology, edges_in_the_way(result, topology, included), tolerances);
        open = faces_of(topology, changed, included);
        run_rounds(session, result, std::move(open), limits, progress, included, triangulate);
    }
    name_failures(result, included);
}

}  // namespace mq::triangulate
