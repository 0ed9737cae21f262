// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/initial_triangulation.h"

#include <algorithm>

namespace mq::geometry {

namespace {

// Every round halves the pieces that stand in some face's way. A gap of 1e-6 of an edge takes twenty rounds.
constexpr int kMaxRounds = 32;
// Rounds in which faces may ask for shorter pieces to follow their surface; later ones only untangle borders.
constexpr int kShapingRounds = 16;

std::vector<int> faces_of(const Topology& topology, const std::set<int>& edges) {
    std::set<int> faces;
    for (const int e : edges) {
        for (const int u : topology.edges[e].uses) {
            faces.insert(topology.uses[u].face);
        }
    }
    return {faces.begin(), faces.end()};
}

}  // namespace

InitialTriangulation triangulate_initially(Session& session, const SingleGrid& grid, Progress& progress) {
    return triangulate_the_rest(session, grid, {EdgeChains(session, grid), {}, {}}, progress);
}

InitialTriangulation triangulate_the_rest(Session& session, const SingleGrid& grid, InitialTriangulation begun,
                                          Progress& progress) {
    const Topology& topology = session.topology();
    InitialTriangulation result = std::move(begun);
    result.faces.resize(topology.faces.size());
    std::vector<int> open;
    for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
        // Those without an area are left out; the part's faults name them. So are points.
        if (!topology.faces[f].no_area && !result.chains.is_a_point(f) && result.faces[f].triangles.empty()) {
            open.push_back(f);
        }
    }
    bool shaping = true;
    for (int round = 0; round < kMaxRounds && !open.empty(); ++round) {
        std::set<EdgeChains::Mark> marks;
        for (std::size_t i = 0; i < open.size(); ++i) {
            progress.check();
            FaceTriangulation& face = result.faces[open[i]];
            face = triangulate_face(session, result.chains, grid, open[i], shaping);
            marks.insert(face.marks.begin(), face.marks.end());
            progress.advance((round + static_cast<double>(i) / open.size()) / (round + 2.0));
        }
        open = faces_of(topology, result.chains.halve(session, marks));
        if (shaping && (round + 1 == kShapingRounds || open.empty())) {
            shaping = false;  // wishes that could not be granted do not count from now on
            for (int f = 0; f < static_cast<int>(result.faces.size()); ++f) {
                if (!result.faces[f].marks.empty() && std::find(open.begin(), open.end(), f) == open.end()) {
                    open.push_back(f);
                }
            }
        }
    }
    for (int f = 0; f < static_cast<int>(result.faces.size()); ++f) {
        FaceTriangulation& face = result.faces[f];
        if (!face.failure.empty()) {
            result.failures.emplace_back(f, face.failure);
        } else if (!face.marks.empty()) {
            result.failures.emplace_back(f,
                                         "its border cannot be resolved: pieces cross or fold however short they are");
        }
    }
    return result;
}

}  // namespace mq::geometry
