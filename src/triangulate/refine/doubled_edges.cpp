// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/doubled_edges.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "triangulate/operators/vertex_insertion.h"
#include "triangulate/refine/tuning.h"

namespace mq::triangulate {

namespace {

// Splits every doubled edge that earlier insertions of the round left in place.
bool split_doubled_edges(Workspace& work, std::vector<int>& touched) {
    const ClassifiedMesh& mesh = work.mesh;
    const std::vector<int> doubled = work.maxmin.doubled_edges();
    std::vector<Candidate> middles;
    std::vector<int> numbers;
    for (const int h : doubled) {
        middles.push_back(edge_middle_site(mesh, h));
        numbers.push_back(mesh.number_of(h));
    }
    const auto points = surface_points(work, middles);
    bool any = false;
    for (std::size_t i = 0; i < doubled.size(); ++i) {
        const int h = doubled[i];
        if (points[i] && mesh.number_of(h) == numbers[i] && work.maxmin.is_doubled(h)) {
            const int t = ClassifiedMesh::triangle_of(h);
            any = !insert_vertex(work, t, *points[i], touched, kAligned, work.floor) || any;
        }
    }
    return any;
}

}  // namespace

void separate_doubled_segments(Workspace& work, SegmentSplitter& splitter, std::vector<int>& touched) {
    std::map<std::pair<int, int>, std::vector<int>> by_ends;
    for (int s = 0; s < work.mesh.segment_count(); ++s) {
        if (!work.mesh.segment(s).uses.empty()) {
            const auto& v = work.mesh.segment(s).vertices;
            by_ends[std::minmax(v[0], v[1])].push_back(s);
        }
    }
    for (const auto& [ends, segments] : by_ends) {
        if (segments.size() < 2) {
            continue;
        }
        const Vec3 middle = 0.5 * (work.mesh.vertex(ends.first).point + work.mesh.vertex(ends.second).point);
        std::vector<std::pair<double, int>> by_height;
        for (const int s : segments) {
            const ClassifiedMesh::Segment& segment = work.mesh.segment(s);
            const geometry::Answer on_curve =
                work.session.ask(geometry::Query::edge_middle(segment.edge, segment.t[0], segment.t[1]));
            by_height.emplace_back((work.grid.snap(on_curve.point) - middle).norm(), s);
        }
        std::sort(by_height.begin(), by_height.end());
        for (std::size_t i = 1; i < by_height.size(); ++i) {
            splitter.request(by_height[i].second, true);
        }
    }
    splitter.run(touched);
}

bool separate_doubled_edges(Workspace& work, std::vector<int>& touched) {
    bool any = false;
    for (int round = 0; round < RefinementTuning::kMaxPassesOfDoubled && split_doubled_edges(work, touched); ++round) {
        any = true;
    }
    return any;
}

}  // namespace mq::triangulate
