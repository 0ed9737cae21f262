// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/gradation.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

struct Spoke {
    int to;
    double length;
};

// Returns the edges at every vertex, on all faces; edges between two triangles of one face occur twice, those on
// borders once for each face.
std::vector<std::vector<Spoke>> spokes_of(const ClassifiedMesh& mesh) {
    std::vector<std::vector<Spoke>> spokes(mesh.vertex_count());
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        const int from = mesh.vertex_of(h);
        const int to = mesh.vertex_of(ClassifiedMesh::next(h));
        const double length = side_length(mesh, h);
        spokes[from].push_back({to, length});
        spokes[to].push_back({from, length});
    }
    return spokes;
}

}  // namespace

std::vector<double> graded_sizes(const ClassifiedMesh& mesh, double growth) {
    const std::vector<std::vector<Spoke>> spokes = spokes_of(mesh);
    std::vector<double> sizes(spokes.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t v = 0; v < spokes.size(); ++v) {
        double sum = 0.0;
        for (const Spoke& spoke : spokes[v]) {
            sum += spoke.length;
        }
        if (!spokes[v].empty()) {
            sizes[v] = sum / static_cast<double>(spokes[v].size());
            queue.emplace(sizes[v], static_cast<int>(v));
        }
    }
    while (!queue.empty()) {
        const auto [size, v] = queue.top();
        queue.pop();
        if (size > sizes[v]) {
            continue;
        }
        for (const Spoke& spoke : spokes[v]) {
            const double grown = size + (growth - 1.0) * spoke.length;
            if (grown < sizes[spoke.to]) {
                sizes[spoke.to] = grown;
                queue.emplace(grown, spoke.to);
            }
        }
    }
    return sizes;
}

}  // namespace mq::triangulate
