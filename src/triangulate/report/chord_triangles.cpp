// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/chord_triangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mq::triangulate {

std::size_t chord_triangles(const Workspace& work, const ChordErrorCache& measured, double chord) {
    const ClassifiedMesh& mesh = work.mesh;
    const auto fraction = [&](int half_edge) { return std::min(1.0, measured.distance_known(half_edge) / chord); };
    std::vector<double> pieces(work.session.topology().edges.size(), 0.0);
    std::vector<std::size_t> faces(pieces.size(), 0);
    for (int s = 0; s < mesh.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = mesh.segment(s);
        if (!segment.uses.empty()) {
            const auto edge = static_cast<std::size_t>(segment.edge);
            pieces[edge] += std::sqrt(fraction(segment.uses.front().half_edge));
            faces[edge] = std::max(faces[edge], segment.uses.size());
        }
    }
    double sum = 0.0;
    for (std::size_t e = 0; e < pieces.size(); ++e) {
        sum += std::max(1.0, pieces[e]) * static_cast<double>(faces[e]);
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double largest = 0.0;
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            largest = std::max(largest, mesh.twin(h) >= 0 ? fraction(h) : 0.0);
        }
        sum += largest;
    }
    return static_cast<std::size_t>(std::ceil(sum));
}

}  // namespace mq::triangulate
