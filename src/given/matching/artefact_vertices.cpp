// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/artefact_vertices.h"

#include <utility>

#include "geometry/closed_edge.h"

namespace mq::given {

namespace {

using geometry::Query;

/// Two tangents are equal up to the angle of this cosine: one degree.
constexpr double kSameTangent = 0.99985;

}  // namespace

bool is_seam(const geometry::Topology& topology, const geometry::Edge& edge) {
    return !edge.degenerate && edge.uses.size() == 2 &&
           topology.uses[static_cast<std::size_t>(edge.uses[0])].face ==
               topology.uses[static_cast<std::size_t>(edge.uses[1])].face;
}

std::vector<char> artefact_vertices(geometry::Session& session) {
    const geometry::Topology& topology = session.topology();
    std::vector<int> closed_at(topology.nodes.size(), -1);
    std::vector<char> at_seam(topology.nodes.size(), 0);
    std::vector<char> others(topology.nodes.size(), 0);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const geometry::Edge& edge = topology.edges[e];
        for (const int node : edge.nodes) {
            if (node < 0 || edge.uses.empty()) {
                continue;
            }
            if (is_seam(topology, edge)) {
                at_seam[static_cast<std::size_t>(node)] = 1;
                continue;
            }
            int& closed = closed_at[static_cast<std::size_t>(node)];
            if (geometry::is_closed(edge) && (closed < 0 || closed == static_cast<int>(e))) {
                closed = static_cast<int>(e);
            } else {
                others[static_cast<std::size_t>(node)] = 1;
            }
        }
    }
    geometry::Engine::Batch batch;
    std::vector<std::size_t> asked;
    std::vector<char> result(topology.nodes.size(), 0);
    for (std::size_t n = 0; n < topology.nodes.size(); ++n) {
        if (closed_at[n] >= 0 && !others[n]) {
            const geometry::Edge& edge = topology.edges[static_cast<std::size_t>(closed_at[n])];
            batch.push_back(Query::edge_point(closed_at[n], edge.t0));
            batch.push_back(Query::edge_point(closed_at[n], edge.t1));
            asked.push_back(n);
        }
        result[n] = static_cast<char>(closed_at[n] < 0 && at_seam[n] && !others[n]);
    }
    const auto answers = session.ask(std::move(batch));
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& first = answers[2 * i];
        const auto& last = answers[2 * i + 1];
        result[asked[i]] = static_cast<char>(first.found() && last.found() &&
                                             first.normal.normalized().dot(last.normal.normalized()) >= kSameTangent);
    }
    return result;
}

}  // namespace mq::given
