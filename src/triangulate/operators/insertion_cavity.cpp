// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/insertion_cavity.h"

#include <algorithm>

#include "triangulate/operators/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

bool aligned(const ClassifiedMesh& mesh, int side, const Corner& p, double least) {
    const double a =
        alignment(corner_of(mesh, mesh.site_of(side)), corner_of(mesh, mesh.site_of(ClassifiedMesh::next(side))), p);
    return a >= least && a > 0.0;
}

}  // namespace

InsertionCavity grow_cavity(const ClassifiedMesh& mesh, int half_edge, bool split, const Corner& p, double least) {
    InsertionCavity c;
    const int start = ClassifiedMesh::triangle_of(half_edge);
    c.triangles = {start};
    constexpr std::size_t kUsual = 8;  // Typical size of a cavity's boundary, for which memory is reserved.
    std::vector<int> vertices;
    vertices.reserve(kUsual);
    c.rim.reserve(kUsual);
    for (int h = 3 * start; h < 3 * start + 3; ++h) {
        vertices.push_back(mesh.vertex_of(h));
        if (!split || h != half_edge) {
            c.rim.push_back(h);
        }
    }
    for (std::size_t i = 0; i < c.rim.size();) {
        const int side = c.rim[i];
        if (aligned(mesh, side, p, least)) {
            ++i;
            continue;
        }
        const int g = mesh.twin(side);
        if (g < 0) {
            c.segment = mesh.segment_of(side);
            return c;
        }
        const int apex = mesh.vertex_of(ClassifiedMesh::prev(g));
        // If the apex is a vertex of the cavity already, the cavity would close around it.
        if (c.triangles.size() >= OperatorTuning::kMaxCavity ||
            (!split && narrow_corner_of(mesh, ClassifiedMesh::triangle_of(g)) >= 0) ||
            std::find(vertices.begin(), vertices.end(), apex) != vertices.end()) {
            return c;
        }
        vertices.push_back(apex);
        c.triangles.push_back(ClassifiedMesh::triangle_of(g));
        c.outside.push_back(g);
        c.rim[i] = ClassifiedMesh::next(g);
        c.rim.push_back(ClassifiedMesh::prev(g));
    }
    c.complete = true;
    return c;
}

}  // namespace mq::triangulate
