// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/initial_triangulation.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "triangulate/initial/triangulation_rounds.h"

namespace mq::triangulate {

namespace {

// All rounds, and those that shape the border: see RoundLimits, where a narrow gap takes twenty.
constexpr RoundLimits kLimits{32, 16};

// The edges that were contracted at a vertex of a face without a triangulation.
std::vector<int> contracted_around_failures(const InitialTriangulation& result, const geometry::Topology& topology) {
    std::set<int> around;
    for (const auto& failure : result.failures) {
        for (const int e : topology.edges_of(failure.first)) {
            const EdgePolyline& chain = result.chains.chain(e);
            around.insert({chain.vertices.front(), chain.vertices.back()});
        }
    }
    std::vector<int> found;
    std::copy_if(result.chains.contracted().begin(), result.chains.contracted().end(), std::back_inserter(found),
                 [&](int e) { return around.count(result.chains.vertex_of_node(topology.edges[e].nodes[0])) > 0; });
    return found;
}

}  // namespace

InitialTriangulation triangulate_initially(geometry::Session& session, const SinglePrecisionGrid& grid,
                                           Progress& progress) {
    std::set<int> kept;
    while (true) {
        InitialTriangulation result =
            triangulate_the_rest(session, grid, {EdgeDiscretisation(session, grid, kept), {}, {}}, progress);
        const std::vector<int> more = contracted_around_failures(result, session.topology());
        if (more.empty()) {
            return result;
        }
        kept.insert(more.begin(), more.end());
    }
}

InitialTriangulation triangulate_the_rest(geometry::Session& session, const SinglePrecisionGrid& grid,
                                          InitialTriangulation begun, Progress& progress) {
    const geometry::Topology& topology = session.topology();
    InitialTriangulation result = std::move(begun);
    result.faces.resize(topology.faces.size());
    std::vector<int> open;
    for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
        // Faces without area are omitted (the faults of the model name them), and so are faces that are a single point.
        if (!topology.faces[f].no_area && !result.chains.is_a_point(f) && result.faces[f].triangles.empty()) {
            open.push_back(f);
        }
    }
    triangulate_in_rounds(
        session, result, std::move(open), kLimits, progress, [](int) { return true; },
        [&](geometry::Oracle& oracle, int f, bool border_may_change) {
            result.faces[f] = triangulate_face(oracle, result.chains, grid, f, border_may_change);
        });
    return result;
}

}  // namespace mq::triangulate
