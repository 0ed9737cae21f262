// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/virtual_topology/smooth_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.h"
#include "triangulate/virtual_topology/tuning.h"

namespace mq::triangulate {

namespace {

using geometry::Answer;
using geometry::Query;

// The volumes that a face bounds, each with the side of the face towards it.
using Sides = std::vector<std::pair<int, bool>>;

std::vector<Sides> sides_of_faces(const geometry::Topology& topology) {
    std::vector<Sides> sides(topology.faces.size());
    for (int v = 0; v < static_cast<int>(topology.volumes.size()); ++v) {
        for (const geometry::Volume::Side& side : topology.volumes[static_cast<std::size_t>(v)].sides) {
            sides[static_cast<std::size_t>(side.face)].emplace_back(v, side.flipped);
        }
    }
    return sides;
}

bool named(const std::vector<LocalSize>& sizes, int dimension, int index) {
    return std::any_of(sizes.begin(), sizes.end(),
                       [&](const LocalSize& size) { return size.dimension == dimension && size.index == index; });
}

// Whether the edge may be smooth by its topology.
bool may_be_smooth(const geometry::Topology& topology, int edge, const std::vector<Sides>& sides,
                   const std::vector<LocalSize>& sizes) {
    const geometry::Edge& e = topology.edges[static_cast<std::size_t>(edge)];
    if (e.degenerate || e.uses.size() != 2 || named(sizes, 1, edge) || named(sizes, 0, e.nodes[0]) ||
        named(sizes, 0, e.nodes[1])) {
        return false;
    }
    const geometry::EdgeUse& a = topology.uses[static_cast<std::size_t>(e.uses[0])];
    const geometry::EdgeUse& b = topology.uses[static_cast<std::size_t>(e.uses[1])];
    return a.face != b.face && !a.internal && !b.internal && !named(sizes, 2, a.face) && !named(sizes, 2, b.face) &&
           sides[static_cast<std::size_t>(a.face)] == sides[static_cast<std::size_t>(b.face)];
}

// Returns the parameters to be measured, by edge: none if the edge is excluded, or has a segment whose sides do not
// run in opposite directions.
std::vector<std::vector<double>> parameters(const ClassifiedMesh& mesh, const geometry::Topology& topology,
                                            const std::vector<char>& asked) {
    std::vector<std::vector<double>> all(topology.edges.size());
    for (std::size_t e = 0; e < all.size(); ++e) {
        for (int i = 1; asked[e] != 0 && i < VirtualTopologyTuning::kLeastPieces; ++i) {
            const double at = static_cast<double>(i) / VirtualTopologyTuning::kLeastPieces;
            all[e].push_back((1.0 - at) * topology.edges[e].t0 + at * topology.edges[e].t1);
        }
    }
    std::vector<char> good(asked);
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = mesh.segment(s);
        const auto e = static_cast<std::size_t>(segment.edge);
        if (segment.uses.empty()) {
            continue;  // it was joined with another one
        }
        if (good[e] == 0 || segment.uses.size() != 2 ||
            mesh.vertex_of(segment.uses[0].half_edge) == mesh.vertex_of(segment.uses[1].half_edge)) {
            good[e] = 0;
            all[e].clear();
            continue;
        }
        all[e].insert(all[e].end(), {segment.t[0], 0.5 * (segment.t[0] + segment.t[1]), segment.t[1]});
    }
    return all;
}

}  // namespace

std::vector<char> smooth_edges(Workspace& work, double feature_angle, const std::vector<LocalSize>& sizes) {
    const geometry::Topology& topology = work.session.topology();
    const std::vector<Sides> sides = sides_of_faces(topology);
    std::vector<char> smooth(topology.edges.size(), 0);
    for (int s = 0; s < work.mesh.segment_count(); ++s) {
        smooth[static_cast<std::size_t>(work.mesh.segment(s).edge)] = 1;
    }
    for (std::size_t e = 0; e < smooth.size(); ++e) {
        smooth[e] = smooth[e] != 0 && may_be_smooth(topology, static_cast<int>(e), sides, sizes) ? 1 : 0;
    }
    const double least = std::cos(feature_angle * kDegree);
    const std::vector<std::vector<double>> wanted = parameters(work.mesh, topology, smooth);
    for (std::size_t e = 0; e < smooth.size(); ++e) {
        geometry::Engine::Batch batch;
        for (const double t : wanted[e]) {
            batch.push_back(Query::use_on_face(topology.edges[e].uses[0], t));
            batch.push_back(Query::use_on_face(topology.edges[e].uses[1], t));
        }
        const geometry::Engine::Answers answers = work.session.ask(std::move(batch));
        smooth[e] = answers.empty() ? 0 : 1;
        for (std::size_t i = 0; i < wanted[e].size() && smooth[e] != 0; ++i) {
            const Answer& a = answers[2 * i];
            const Answer& b = answers[2 * i + 1];
            // At its ends an edge may run into a pole, whose other faces do not matter.
            const bool at_end = wanted[e][i] == topology.edges[e].t0 || wanted[e][i] == topology.edges[e].t1;
            const bool known = a.status == geometry::Status::Ok && b.status == geometry::Status::Ok;
            smooth[e] = (known ? a.normal.dot(b.normal) > least : at_end && a.found() && b.found()) ? 1 : 0;
        }
    }
    return smooth;
}

}  // namespace mq::triangulate
