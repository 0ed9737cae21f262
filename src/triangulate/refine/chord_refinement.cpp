// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/chord_refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.h"
#include "base/for_ranges.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/rounds/block_round.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/gradation.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

// Returns the angle between the surface normals at the ends, radians; 0 where there is no normal.
double turn_along(const ClassifiedMesh& mesh, int h) {
    return angle_between(mesh.site(mesh.site_of(h)).normal, mesh.site(mesh.site_of(ClassifiedMesh::next(h))).normal);
}

// Returns the versions of the two triangles beside an edge, in either direction, and in any order of the mesh.
std::array<std::uint32_t, 2> stamps_beside(const ClassifiedMesh& mesh, int h) {
    const auto [older, newer] = std::minmax({mesh.stamp(h / 3), mesh.stamp(mesh.twin(h) / 3)});
    return {older, newer};
}

// Pieces measured, or surface points found, at a time: their results are larger than the mesh if all are kept.
constexpr std::size_t kPiecesAtOnce = 8192;

// Ratio of excesses that are alike: those of a chord and of one that is 10 % longer.
constexpr double kAlike = 1.21;

}  // namespace

double ChordRefinement::excess_of_edge(double chord, int half_edge) const {
    double worst = excess(chord);
    if (sizing_.bounds.any()) {
        const double length = side_length(work_.mesh, half_edge);
        worst = std::max(worst, length / sizing_.bounds.of(work_.mesh, half_edge));
        worst =
            worst > 1.0 ? worst : std::max(worst, length / sizing_.bounds.by_triangles(work_.mesh, half_edge, length));
    }
    return sizing_.turn > 0.0 ? std::max(worst, turn_along(work_.mesh, half_edge) / sizing_.turn) : worst;
}

// Returns the angles by which the curve, and the surfaces beside it, turn along segments, radians.
std::vector<double> ChordRefinement::turns_of(const std::vector<int>& segments) {
    std::vector<double> turns(segments.size(), 0.0);
    if (!(sizing_.turn > 0.0)) {
        return turns;
    }
    geometry::Engine::Batch batch;
    for (const int s : segments) {
        for (const double t : work_.mesh.segment(s).t) {
            batch.push_back(geometry::Query::edge_point(work_.mesh.segment(s).edge, t));
        }
    }
    const geometry::Engine::Answers ends = work_.session.ask(std::move(batch));
    for (std::size_t i = 0; i < segments.size(); ++i) {
        turns[i] = angle_between(ends[2 * i].normal, ends[2 * i + 1].normal);
        for (const ClassifiedMesh::SegmentUse& use : work_.mesh.segment(segments[i]).uses) {
            turns[i] = std::max(turns[i], turn_along(work_.mesh, use.half_edge));
        }
    }
    return turns;
}

void ChordRefinement::measure_segments(Violations& found) {
    std::vector<int> segments;
    std::vector<int> sides;
    for (int s = 0; s < work_.mesh.segment_count(); ++s) {
        const auto& uses = work_.mesh.segment(s).uses;
        if (!uses.empty() && !segments_.refused(s) && !passed_.marked(work_.mesh, uses[0].half_edge)) {
            segments.push_back(s);
            sides.push_back(uses[0].half_edge);
        }
    }
    const std::vector<Distance> distances = sizing_.tolerance > 0.0 ? measure_.of_segments(segments, sizing_.tolerance)
                                                                    : std::vector<Distance>(segments.size());
    const std::vector<double> turns = turns_of(segments);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        double e = excess_of_edge(distances[i].avoidable, sides[i]);
        e = sizing_.turn > 0.0 ? std::max(e, turns[i] / sizing_.turn) : e;
        if (e > 1.0) {
            found.push_back({sides[i], 0, e});
        } else {
            passed_.mark(work_.mesh, sides[i]);
        }
    }
}

// Adds those edges of a triangle that are not known to be within their bounds, each at one of its triangles only.
// Changes marks of this triangle only: several threads may look at different ones.
void ChordRefinement::add_unpassed_edges(int triangle, std::vector<int>& edges) {
    if (edges_passed_.marked(work_.mesh, triangle)) {
        return;
    }
    bool all_passed = true;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (work_.mesh.twin(h) < 0 || passed_.marked(work_.mesh, h)) {
            continue;
        }
        all_passed = false;
        if (work_.mesh.twin(h) > h && !refused(h)) {
            edges.push_back(h);
        }
    }
    if (all_passed) {
        edges_passed_.mark(work_.mesh, triangle);
    }
}

// Returns the edges that are not known to be within their bounds, in the order of their half-edges.
std::vector<int> ChordRefinement::unpassed_edges() {
    edges_passed_.cover(work_.mesh);
    using Edges = std::vector<int>;
    const auto count = static_cast<std::size_t>(work_.mesh.triangle_count());
    return found_in_ranges<Edges>(count, [&](std::size_t from, std::size_t to, Edges& edges) {
        work_.progress.check();
        for (int t = static_cast<int>(from); t < static_cast<int>(to); ++t) {
            add_unpassed_edges(t, edges);
        }
    });
}

void ChordRefinement::measure_edges(Violations& found) {
    const std::vector<int> edges = unpassed_edges();
    for (std::size_t from = 0; from < edges.size(); from += kPiecesAtOnce) {
        measure_edges(edges.data() + from, edges.data() + std::min(from + kPiecesAtOnce, edges.size()), found);
    }
}

void ChordRefinement::measure_edges(const int* first, const int* last, Violations& found) {
    const std::vector<int> edges(first, last);
    const std::vector<Distance> distances =
        sizing_.tolerance > 0.0 ? measure_.of_edges(edges, sizing_.tolerance) : std::vector<Distance>(edges.size());
    const auto last_foot = measure_.projections_of_far_midpoints().end();
    auto foot = sizing_.tolerance > 0.0 ? measure_.projections_of_far_midpoints().begin() : last_foot;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const int h = edges[i];
        const double e = excess_of_edge(distances[i].avoidable, h);
        if (!(e > 1.0)) {
            passed_.mark(work_.mesh, h);
            continue;
        }
        found.push_back({h, work_.mesh.stamp(h / 3), e});
        foot = std::find_if(foot, last_foot, [&](const ChordErrorCache::SurfaceProjection& f) { return f.index >= i; });
        if (foot != last_foot && foot->index == i) {
            found.back().surface_point = static_cast<int>(known_points_.size());
            known_points_.push_back(surface_point(work_, edge_middle_site(work_.mesh, h), foot->nearest));
        }
    }
}

void ChordRefinement::measure_triangles(Violations& found) {
    using Triangles = std::vector<int>;
    const auto count = static_cast<std::size_t>(work_.mesh.triangle_count());
    const auto triangles = found_in_ranges<Triangles>(count, [&](std::size_t begin, std::size_t end, Triangles& news) {
        work_.progress.check();
        for (int t = static_cast<int>(begin); t < static_cast<int>(end); ++t) {
            if (!measured_.marked(work_.mesh, t)) {
                news.push_back(t);
            }
        }
    });
    for (std::size_t from = 0; from < triangles.size(); from += kPiecesAtOnce) {
        const auto begin = triangles.begin() + static_cast<std::ptrdiff_t>(from);
        const auto count = static_cast<std::ptrdiff_t>(std::min(kPiecesAtOnce, triangles.size() - from));
        measure_triangles(std::vector<int>(begin, begin + count), found);
    }
}

void ChordRefinement::measure_triangles(const std::vector<int>& triangles, Violations& found) {
    const std::vector<Distance> distances = measure_.of_triangles(triangles, sizing_.tolerance);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const int t = triangles[i];
        const double e = excess(distances[i].avoidable);
        const std::optional<int> h = e > 1.0 ? side_to_split(t) : std::nullopt;
        if (h) {
            found.push_back({*h, work_.mesh.stamp(t), e});
        } else {
            measured_.mark(work_.mesh, t);
        }
    }
}

// Returns the longest side that can be split.
std::optional<int> ChordRefinement::side_to_split(int triangle) const {
    std::optional<int> best;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const int s = work_.mesh.segment_of(h);
        const bool possible = s >= 0 ? !segments_.refused(s) : !refused(h);
        if (possible && (!best || side_length(work_.mesh, h) > side_length(work_.mesh, *best))) {
            best = h;
        }
    }
    return best;
}

// Whether the edge could not be split, as long as the triangles beside it do not change.
bool ChordRefinement::refused(int half_edge) const {
    const auto found = refused_.find(work_.mesh.number_of(half_edge));
    return found != refused_.end() && found->second == stamps_beside(work_.mesh, half_edge);
}

void ChordRefinement::refuse(int half_edge) {
    refused_[work_.mesh.number_of(half_edge)] = stamps_beside(work_.mesh, half_edge);
}

void ChordRefinement::measure_growth(Violations& found) {
    const ClassifiedMesh& mesh = work_.mesh;
    const std::vector<double> sizes = graded_sizes(mesh, sizing_.growth);
    const auto check = [&](int h) {
        const double size = std::max(sizes[mesh.vertex_of(h)], sizes[mesh.vertex_of(ClassifiedMesh::next(h))]);
        const double e = side_length(mesh, h) / (RefinementTuning::kLongestEdge * size);
        if (e > 1.0) {
            found.push_back({h, mesh.stamp(h / 3), e});
        }
    };
    for (int s = 0; s < mesh.segment_count(); ++s) {
        if (!mesh.segment(s).uses.empty() && !segments_.refused(s)) {
            check(mesh.segment(s).uses.front().half_edge);
        }
    }
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        if (mesh.twin(h) > h && !refused(h)) {
            check(h);
        }
    }
}

void ChordRefinement::sort_worst_first(Violations& found) {
    std::sort(found.begin(), found.end(), [](const Violation& a, const Violation& b) {
        return a.excess != b.excess ? a.excess > b.excess : a.place < b.place;
    });
}

// Returns the worst first, and those of similar excess in the order in which they were found: pieces that are split one
// after another then lie together in memory.
ChordRefinement::Violations ChordRefinement::violations() {
    Violations found;
    measure_segments(found);
    if (found.empty()) {
        measure_edges(found);
    }
    if (found.empty() && sizing_.tolerance > 0.0) {
        measure_triangles(found);
    }
    if (found.empty() && sizing_.growth > 0.0) {
        measure_growth(found);
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        found[i].place = static_cast<int>(i);
        found[i].excess = std::floor(std::log(found[i].excess) / std::log(kAlike));
    }
    sort_worst_first(found);
    return found;
}

// Without this, edges that are gone would leave most of the data that are stored by number unused.
void ChordRefinement::forget_gone_edges() {
    constexpr double kWorthRenumbering = 1.125;  // numbers for each edge
    if (work_.mesh.number_count() <= kWorthRenumbering * work_.mesh.edge_count()) {
        return;
    }
    const LargeVector<int> renewed = work_.mesh.renumber_edges();
    measure_.renumber(renewed);
    passed_.renumber(renewed);
    move_to_indices(renewed, refused_);
}

void ChordRefinement::renumber(const NewIndices& renewed) {
    passed_.renumber(renewed);
    edges_passed_.renumber(renewed);
    measured_.renumber(renewed);
    move_to_indices(renewed.edges, refused_);
}

bool ChordRefinement::run(const std::function<void()>& before_round) {
    changed_ = false;
    for (int round = 0; round < RefinementTuning::kMaxSplitRounds && !work_.over_budget(); ++round) {
        work_.progress.check();
        before_round();
        const int before = work_.mesh.vertex_count();
        forget_gone_edges();
        const Violations found = violations();
        work_.progress.check();
        if (found.empty()) {
            break;
        }
        split(found);
        if (work_.mesh.vertex_count() == before) {
            break;
        }
        changed_ = true;
    }
    return changed_;
}

void ChordRefinement::split(const Violations& found) {
    Violations inner;
    for (const Violation& violation : found) {
        const int s = work_.mesh.segment_of(violation.half_edge);
        if (s >= 0) {
            segments_.request(s, true);
        } else {
            inner.push_back(violation);
        }
    }
    const std::size_t blocks = blocks_for(work_, inner.size());
    if (blocks > 1 && work_.triangles() + 2 * inner.size() <= work_.budget) {
        inner = split_in_blocks(inner, blocks);
    }
    CancelPace pace(work_.progress);
    for (std::size_t from = 0; from < inner.size() && !work_.over_budget(); from += kPiecesAtOnce) {
        const std::size_t to = std::min(from + kPiecesAtOnce, inner.size());
        const SurfacePoints points = surface_points_of(inner.data() + from, inner.data() + to);
        for (std::size_t i = from; i < to && !work_.over_budget(); ++i) {
            pace.step();
            split_one(inner[i], points[i - from]);
        }
    }
    known_points_ = {};
    segments_.run(touched_);
    touched_.clear();
}

// Splits edges inside faces in blocks of the mesh, those of each block in their order.
// @return those that are left, in their order
ChordRefinement::Violations ChordRefinement::split_in_blocks(const Violations& inner, std::size_t count) {
    MeshBlocks blocks(work_.mesh, count);
    std::vector<Violations> of_block(count);
    Violations left;
    for (const Violation& violation : inner) {
        if (work_.mesh.stamp(violation.half_edge / 3) == violation.stamp) {
            Violations& list =
                work_.mesh.twin(violation.half_edge) < 0 ? left : of_block[blocks.block_of(violation.half_edge / 3)];
            list.push_back(violation);
        }
    }
    std::vector<std::size_t> insertions;
    for (const Violations& violations : of_block) {
        insertions.push_back(violations.size());
    }
    edit_in_blocks(work_, blocks, insertions, [&](geometry::Answerer& answerer, Workspace& block, std::size_t k) {
        of_block[k] = split_block(answerer, block, of_block[k]);
    });
    for (const Violations& violations : of_block) {
        left.insert(left.end(), violations.begin(), violations.end());
    }
    sort_worst_first(left);
    return left;
}

// Returns the violations that have to be looked at without cuts.
ChordRefinement::Violations ChordRefinement::split_block(geometry::Answerer& answerer, Workspace& block,
                                                         const Violations& violations) const {
    Violations left;
    std::vector<int> touched;
    for (const Violation& violation : violations) {
        const int h = violation.half_edge;
        block.progress.check();
        if (block.mesh.stamp(h / 3) != violation.stamp) {
            continue;
        }
        const std::optional<SurfacePoint> p = violation.surface_point >= 0
                                                  ? known_points_[static_cast<std::size_t>(violation.surface_point)]
                                                  : surface_point(answerer, block, edge_middle_site(block.mesh, h));
        if (!p || !split_in_block(block, h, *p, touched)) {
            left.push_back(violation);
        }
        touched.clear();
    }
    return left;
}

// Splits an edge that needs nothing but the triangles of its block: what concerns segments is left.
bool ChordRefinement::split_in_block(Workspace& block, int half_edge, const SurfacePoint& p,
                                     std::vector<int>& touched) const {
    const ClassifiedMesh& mesh = block.mesh;
    const auto is_corner = [&](int h) {
        return mesh.segment_of(ClassifiedMesh::prev(h)) >= 0 && mesh.segment_of(ClassifiedMesh::next(h)) >= 0;
    };
    return !is_corner(half_edge) && !is_corner(mesh.twin(half_edge)) &&
           surroundings_of(mesh, half_edge / 3, p.point).encroached.empty() &&
           !insert_vertex(block, half_edge / 3, p, touched, kAlignedAtLast);
}

bool ChordRefinement::changed(const Violation& violation) const {
    return work_.mesh.stamp(violation.half_edge / 3) != violation.stamp || work_.mesh.twin(violation.half_edge) < 0;
}

// Projects the middles of those edges whose surface points are not known, and that are still there.
ChordRefinement::SurfacePoints ChordRefinement::surface_points_of(const Violation* first, const Violation* last) {
    std::vector<Candidate> unknown;
    for (const Violation* violation = first; violation != last; ++violation) {
        if (violation->surface_point < 0 && !changed(*violation)) {
            unknown.push_back(edge_middle_site(work_.mesh, violation->half_edge));
        }
    }
    const SurfacePoints asked = surface_points(work_, unknown);
    auto next = asked.begin();
    SurfacePoints result;
    result.reserve(static_cast<std::size_t>(last - first));
    for (const Violation* violation = first; violation != last; ++violation) {
        if (violation->surface_point >= 0) {
            result.push_back(known_points_[static_cast<std::size_t>(violation->surface_point)]);
        } else {
            result.push_back(changed(*violation) ? std::nullopt : *next++);
        }
    }
    return result;
}

// Where an edge lies across a corner of the border that has no room for two triangles, its segments are halved: a
// vertex on the edge would divide the corner.
bool ChordRefinement::shorten_corner(int h) {
    const int corner = ClassifiedMesh::prev(h);
    const std::array<int, 2> sides{work_.mesh.segment_of(corner), work_.mesh.segment_of(ClassifiedMesh::next(h))};
    if (sides[0] < 0 || sides[1] < 0 || segments_.refused(sides[0]) || segments_.refused(sides[1]) ||
        angle_at(work_.mesh, corner) >= sizing_.whole_corner) {
        return false;
    }
    for (const int s : sides) {
        segments_.request(s, true);
    }
    return true;
}

void ChordRefinement::split_one(const Violation& violation, const std::optional<SurfacePoint>& p) {
    const int h = violation.half_edge;
    if (changed(violation)) {
        return;
    }
    if (!p) {
        refuse(h);
        return;
    }
    bool split_segment = shorten_corner(h) || shorten_corner(work_.mesh.twin(h));
    for (const int s : surroundings_of(work_.mesh, h / 3, p->point).encroached) {
        if (segments_.may_split(s)) {
            segments_.request(s);
            split_segment = true;
        }
    }
    if (!split_segment && insert_vertex(work_, h / 3, *p, touched_, kAlignedAtLast)) {
        refuse(h);
    }
}

}  // namespace mq::triangulate
