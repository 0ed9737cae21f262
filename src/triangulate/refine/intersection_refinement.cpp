// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/intersection_refinement.h"

#include <algorithm>
#include <utility>

#include "triangulate/measure/deviation_peaks.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

using geometry::Query;

// Factor by which heights over squared lengths grow with each halving that leaves the heights as they are.
constexpr double kNoChords = 4.0;

}  // namespace

// Overlapping triangles of one face with the same orientation are a fold, which chords do not cause. (The same holds
// for coarse layers of a face that is rolled up: these are kept, and reported.)
bool IntersectionRefinement::folded(const std::array<int, 2>& pair) const {
    const ClassifiedMesh& mesh = work_.mesh;
    return mesh.face_of(pair[0]) == mesh.face_of(pair[1]) &&
           doubled_area(mesh, pair[0]).dot(doubled_area(mesh, pair[1])) > 0.0;
}

std::vector<IntersectionRefinement::Crossing> IntersectionRefinement::crossings() {
    const Pairs& pairs = finder_.pairs();
    const std::map<int, Side> highest = highest_sides(pairs);
    std::vector<Crossing> result;
    for (const auto& pair : pairs) {
        const std::array<Side, 2> sides{highest.at(pair[0]), highest.at(pair[1])};
        const bool by_chords = !folded(pair) && finder_.depth(pair) <= RefinementTuning::kDeepCrossing *
                                                                               (sides[0].height + sides[1].height) +
                                                                           work_.grid.resolution();
        result.push_back({pair, sides, by_chords});
    }
    return result;
}

// Marks pairs of faces as crossing in the shape itself: those with most crossings deeper than chords explain, or with
// more and more crossings while heights do not fall as those of chords. A chord half as long has a quarter of the
// height, so that heights over squared lengths stay the same.
void IntersectionRefinement::judge(const std::vector<Crossing>& crossings) {
    std::map<SelfIntersections::Faces, int> balance;
    std::map<SelfIntersections::Faces, Bends> bends;
    for (const Crossing& crossing : crossings) {
        const SelfIntersections::Faces faces = finder_.faces_of(crossing.pair);
        const Side& higher = crossing.sides[crossing.sides[1].height > crossing.sides[0].height ? 1 : 0];
        balance[faces] += crossing.by_chords ? 1 : -1;
        ++bends[faces].crossings;
        bends[faces].sum += higher.height / squared_length(work_.mesh, higher.half_edge);
    }
    for (const auto& [faces, more] : balance) {
        const Bends& now = bends.at(faces);
        const Bends& first = first_.emplace(faces, now).first->second;
        if (more < 0 ||
            (now.crossings > first.crossings && now.sum * first.crossings > kNoChords * first.sum * now.crossings)) {
            of_the_part_.insert(faces);
        }
    }
}

// Returns the heights over their curves, mm, of segments of crossing triangles, except those that cannot be split.
std::map<int, double> IntersectionRefinement::heights_of_segments(const Pairs& pairs) {
    const ClassifiedMesh& mesh = work_.mesh;
    std::map<int, double> heights;
    for (const auto& pair : pairs) {
        for (const int t : pair) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (const int s = mesh.segment_of(h); s >= 0 && !segments_.refused(s)) {
                    heights[s] = 0.0;
                }
            }
        }
    }
    geometry::Engine::Batch batch;
    for (const auto& entry : heights) {
        const ClassifiedMesh::Segment& piece = mesh.segment(entry.first);
        const Vec3 middle = 0.5 * (mesh.vertex(piece.vertices[0]).point + mesh.vertex(piece.vertices[1]).point);
        batch.push_back(Query::edge_nearest(piece.edge, work_.grid.to_shape(middle), 0.5 * (piece.t[0] + piece.t[1]),
                                            piece.t[0], piece.t[1]));
    }
    const geometry::Engine::Answers feet = work_.session.ask(std::move(batch));
    auto foot = feet.begin();
    for (auto& entry : heights) {
        entry.second = foot->found() ? foot->distance : 0.0;
        ++foot;
    }
    return heights;
}

// Returns the highest side of each crossing triangle.
std::map<int, IntersectionRefinement::Side> IntersectionRefinement::highest_sides(const Pairs& pairs) {
    const std::map<int, double> heights = heights_of_segments(pairs);
    std::map<int, Side> result;
    for (const auto& pair : pairs) {
        for (const int t : pair) {
            const auto [found, fresh] = result.try_emplace(t, Side{3 * t, -1.0});
            for (int h = 3 * t; fresh && h < 3 * t + 3; ++h) {
                const int s = work_.mesh.segment_of(h);
                const auto known = heights.find(s);
                const double height = s < 0                    ? edge_peak(work_.mesh, h).height
                                      : known != heights.end() ? known->second
                                                               : 0.0;
                if (height > found->second.height) {
                    found->second = {h, height};
                }
            }
        }
    }
    return result;
}

// The side that is higher over its surface, or both if they are equally high. Where two faces touch along an edge,
// their first rows of triangles are apart only while neither is much coarser: if both were split, they would cross as
// before at half the size.
void IntersectionRefinement::request(const Crossing& crossing, std::vector<SideToSplit>& sides) const {
    const double higher = std::max(crossing.sides[0].height, crossing.sides[1].height);
    for (int i = 0; i < 2; ++i) {
        const Side& side = crossing.sides[i];
        if (side.height >= higher && side.height > RefinementTuning::kExactHeight * work_.grid.resolution()) {
            sides.push_back({side.half_edge, work_.mesh.stamp(crossing.pair[i])});
        }
    }
}

bool IntersectionRefinement::split(std::vector<SideToSplit> sides) {
    std::sort(sides.begin(), sides.end(),
              [](const SideToSplit& a, const SideToSplit& b) { return a.half_edge < b.half_edge; });
    sides.erase(std::unique(sides.begin(), sides.end(),
                            [](const SideToSplit& a, const SideToSplit& b) { return a.half_edge == b.half_edge; }),
                sides.end());
    std::vector<int> touched;
    const int before = work_.mesh.vertex_count();
    std::vector<Candidate> candidates;
    for (const SideToSplit& side : sides) {
        candidates.push_back(edge_middle_site(work_.mesh, side.half_edge));
    }
    const auto points = surface_points(work_, candidates);
    for (std::size_t i = 0; i < sides.size() && !work_.over_budget(); ++i) {
        const int h = sides[i].half_edge;
        if (work_.mesh.stamp(h / 3) != sides[i].stamp) {
            continue;
        }
        if (const int s = work_.mesh.segment_of(h); s >= 0) {
            segments_.request(s, true);
        } else if (points[i]) {
            insert_vertex(work_, h / 3, *points[i], touched, kAlignedAtLast);
        }
    }
    segments_.run(touched);
    return work_.mesh.vertex_count() > before;
}

bool IntersectionRefinement::run() {
    if (work_.over_budget()) {
        return false;
    }
    const std::vector<Crossing> found = crossings();
    judge(found);
    std::vector<SideToSplit> sides;
    for (const Crossing& crossing : found) {
        if (crossing.by_chords && of_the_part_.count(finder_.faces_of(crossing.pair)) == 0) {
            request(crossing, sides);
        }
    }
    return !sides.empty() && split(std::move(sides));
}

bool IntersectionRefinement::run_between_bodies(double deviation) {
    if (work_.over_budget()) {
        return false;
    }
    Pairs pairs;
    for (const FaceContact& contact : bodies_.find(deviation)) {
        for (const auto& [pair, gap] : contact.apart) {
            if (contact.worst() == BodyContact::Apart && gap >= RefinementTuning::kLeastGap * deviation) {
                pairs.push_back(pair);
            }
        }
    }
    const std::map<int, Side> highest = highest_sides(pairs);
    std::vector<SideToSplit> sides;
    for (const auto& pair : pairs) {
        request({pair, {highest.at(pair[0]), highest.at(pair[1])}, true}, sides);
    }
    return !sides.empty() && split(std::move(sides));
}

}  // namespace mq::triangulate
