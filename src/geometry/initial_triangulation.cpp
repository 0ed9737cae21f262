// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/initial_triangulation.h"

#include "geometry/face_rounds.h"

namespace mq::geometry {

namespace {

constexpr RoundLimits kLimits{32, 16};

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
    triangulate_in_rounds(
        session, result, std::move(open), kLimits, progress, [](int) { return true; },
        [&](int f, bool border_may_change) {
            result.faces[f] = triangulate_face(session, result.chains, grid, f, border_may_change);
        });
    return result;
}

}  // namespace mq::geometry
