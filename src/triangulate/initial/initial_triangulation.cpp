// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/initial_triangulation.h"

#include "triangulate/initial/triangulation_rounds.h"

namespace mq::triangulate {

namespace {

// All rounds, and those that shape the border: see RoundLimits, where a narrow gap takes twenty.
constexpr RoundLimits kLimits{32, 16};

}  // namespace

InitialTriangulation triangulate_initially(geometry::Session& session, const SinglePrecisionGrid& grid,
                                           Progress& progress) {
    return triangulate_the_rest(session, grid, {EdgeDiscretisation(session, grid), {}, {}}, progress);
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
