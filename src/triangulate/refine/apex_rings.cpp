// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/refine/apex_rings.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "triangulate/refine/tuning.h"
#include "triangulate/work_mesh/side_lengths.h"

namespace mq::triangulate {

namespace {

// Height of an equilateral triangle of side 1, rounded.
constexpr double kHeight = 0.87;

}  // namespace

bool ApexRings::insert_ring(int h, std::vector<int>& touched) {
    if (!cone_fan(work_.mesh, h)) {
        return false;
    }
    Apex apex{work_.mesh.vertex_of(h), work_.mesh.face_of(ClassifiedMesh::triangle_of(h)), h};
    if (segments_.is_free(apex.vertex)) {
        return false;
    }
    ++tried_;
    if (++tries_[apex.vertex] > RefinementTuning::kMaxRings) {
        segments_.free_apex(apex.vertex);
        return false;
    }
    const std::size_t before = touched.size();
    auto fan = cone_fan(work_.mesh, h);
    for (int k = 0; fan && k < RefinementTuning::kMaxRingSwaps && swap_widest(apex, *fan, touched); ++k) {
        fan = cone_fan(work_.mesh, apex.half_edge);
    }
    if (fan) {
        Ring ring = ring_within(apex, *fan);
        const bool begun = split_seam(apex, ring, touched);
        fan = cone_fan(work_.mesh, apex.half_edge);
        if (begun && fan) {
            insert(sites_on(apex, *fan, ring), touched);
            relocate(apex, touched, before);
            count_miss(apex, ring);
        }
    }
    return touched.size() > before;
}

// Around a sharp turn of the surface, as at the ends of an ellipse, chords of a ring would lie deep below it, and old
// spokes remain: such apexes are released.
void ApexRings::count_miss(const Apex& apex, const Ring& ring) {
    const auto fan = cone_fan(work_.mesh, apex.half_edge);
    if (fan && static_cast<int>(fan->triangles) > ring.count &&
        ++misses_[apex.vertex] >= RefinementTuning::kMaxRingMisses) {
        segments_.free_apex(apex.vertex);
    }
}

void ApexRings::relocate(Apex& apex, const std::vector<int>& touched, std::size_t first) const {
    const ClassifiedMesh& mesh = work_.mesh;
    for (std::size_t i = first; i < touched.size(); ++i) {
        for (int h = 3 * touched[i]; h < 3 * touched[i] + 3; ++h) {
            if (mesh.vertex_of(h) == apex.vertex && mesh.face_of(touched[i]) == apex.face) {
                apex.half_edge = h;
            }
        }
    }
}

// An initial triangulation has chords across the base of a cone as edges; this swaps them, so that the apex gets the
// vertices beyond as neighbours, one by one.
bool ApexRings::swap_widest(Apex& apex, const ApexFan& fan, std::vector<int>& touched) {
    const ClassifiedMesh& mesh = work_.mesh;
    const double most = RefinementTuning::kWidestBelowRing * fan.sum;
    for (const int h : mesh.star(apex.half_edge)) {
        const int opposite = ClassifiedMesh::next(h);
        const int twin = mesh.twin(opposite);
        if (twin < 0 || angle_at(mesh, h) <= most) {
            continue;
        }
        const int beyond = ClassifiedMesh::prev(twin);
        const Corner top = corner_of(mesh, mesh.site_of(h));
        const Corner third = corner_of(mesh, mesh.site_of(beyond));
        if (mesh.vertex_of(beyond) == apex.vertex || work_.maxmin.joined(apex.vertex, mesh.vertex_of(beyond)) ||
            alignment(top, corner_of(mesh, mesh.site_of(opposite)), third) < kAlignedAtApex ||
            alignment(top, third, corner_of(mesh, mesh.site_of(ClassifiedMesh::prev(h)))) < kAlignedAtApex) {
            return false;
        }
        const std::size_t before = touched.size();
        work_.maxmin.swap(opposite, touched);
        relocate(apex, touched, before);
        return true;
    }
    return false;
}

ApexRings::Ring ApexRings::ring_within(const Apex& apex, const ApexFan& fan) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const int now = static_cast<int>(fan.triangles);
    const int most = std::max(3, static_cast<int>(fan.sum / (RefinementTuning::kRingSlack * bound_)));
    const int count = now > most
                          ? std::max(most, (now + 1) / 2)
                          : std::clamp(static_cast<int>(std::lround(fan.sum / RefinementTuning::kFewAtApex)), 3, most);
    double shortest = 1e300;
    for (const int h : mesh.star(apex.half_edge)) {
        if (mesh.segment_of(h) < 0) {
            shortest = std::min(shortest, side_length(mesh, h));
        }
    }
    // With the mean length of the edges along both rings, `shortest - away` is the height of triangles between them.
    const double height = kHeight * 0.5 * fan.sum;
    double away = shortest * (1.0 - height / now) / (1.0 + height / count);
    if (chord_height_ > 0.0) {
        // Depth of a chord's middle below the cone at 1 mm from the apex.
        const double below = fan.sum / (2.0 * M_PI) * (1.0 - std::cos(M_PI / count));
        away = std::max(std::min(away, RefinementTuning::kRingChordHeight * chord_height_ / below),
                        RefinementTuning::kLeastRing * away);
    }
    return {count, away, shortest};
}

// Whether a vertex at this distance from the apex (mm) counts as on the ring. Around slender cones rings lie close
// together.
bool ApexRings::Ring::holds(double length) const {
    return length <= std::min(RefinementTuning::kOnRing * away, 0.5 * (away + least_beyond));
}

// Where a seam ends in the apex, its vertex on the ring is the first one, and `ring` gets its distance.
// @return whether there is no seam, or one with a vertex on the ring
bool ApexRings::split_seam(Apex& apex, Ring& ring, std::vector<int>& touched) {
    const ClassifiedMesh& mesh = work_.mesh;
    const int h = mesh.star(apex.half_edge).front();
    const int seam = mesh.segment_of(h);
    if (seam < 0) {
        return true;
    }
    double length = side_length(mesh, h);
    if (!ring.holds(length)) {
        if (segments_.refused(seam)) {
            return false;
        }
        const std::size_t before = touched.size();
        segments_.request_at(seam, mesh.segment(seam).vertices[0] == apex.vertex ? 0 : 1, ring.away);
        segments_.run(touched);
        relocate(apex, touched, before);
        length = side_length(mesh, mesh.star(apex.half_edge).front());
    }
    if (!ring.holds(length)) {
        return false;
    }
    ring.away = length;
    return true;
}

// Places the sites in the triangles around the apex, unrolled into a plane.
std::vector<Candidate> ApexRings::sites_on(const Apex& apex, const ApexFan& fan, const Ring& ring) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const std::vector<int> spokes = mesh.star(apex.half_edge);
    const Vec3 top = mesh.point_of(apex.half_edge);
    std::vector<Candidate> sites;
    std::size_t i = 0;
    double passed = 0.0;
    for (int k = mesh.segment_of(spokes.front()) >= 0 ? 1 : 0; k < ring.count; ++k) {
        const double turn = fan.sum * k / ring.count;
        while (i + 1 < spokes.size() && passed + angle_at(mesh, spokes[i]) < turn) {
            passed += angle_at(mesh, spokes[i]);
            ++i;
        }
        const int h = spokes[i];
        const Vec3 b = mesh.point_of(ClassifiedMesh::next(h)) - top;
        const Vec3 c = mesh.point_of(ClassifiedMesh::prev(h)) - top;
        const Vec3 along = b.normalized();
        const Vec3 across = (c - along * along.dot(c)).normalized();
        const double x = ring.away * std::cos(turn - passed);
        const double y = ring.away * std::sin(turn - passed);
        const double of_c = y / across.dot(c);
        const double of_b = (x - of_c * along.dot(c)) / b.norm();
        const auto uv = [&](int g) { return mesh.site(mesh.site_of(g)).uv; };
        sites.push_back(
            {ClassifiedMesh::triangle_of(h), top + x * along + y * across,
             uv(h) + of_b * (uv(ClassifiedMesh::next(h)) - uv(h)) + of_c * (uv(ClassifiedMesh::prev(h)) - uv(h)), false,
             ring.away});
    }
    return sites;
}

void ApexRings::insert(const std::vector<Candidate>& sites, std::vector<int>& touched) {
    const auto points = surface_points(work_, sites);
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const Location place = points[k] ? locate(work_.mesh, sites[k].triangle, *points[k]) : Location{};
        if (place.triangle >= 0 && place.segment < 0) {
            insert_vertex(work_, place.triangle, *points[k], touched);
        }
    }
}

}  // namespace mq::triangulate
