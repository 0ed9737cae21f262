// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/apex_rings.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "triangulate/side_length.h"

namespace mq::triangulate {

namespace {

using mesh::SurfaceMesh;

// Of a few triangles around an apex: less would not outlast the changes around them, more would waste triangles.
constexpr double kComfortable = 40.0 * kDegree;
constexpr double kSlack = 1.15;
// Height of an equilateral triangle of side 1.
constexpr double kHeight = 0.87;
// Rings that halve the number of triangles, and some for what happens in between.
constexpr int kMaxTries = 48;
constexpr int kMaxSwaps = 16;
constexpr int kMaxMisses = 2;
// Share in a whole turn: a triangle that spans more runs deep below its cone, and a ring would fold over it.
constexpr double kWidestBelowRing = 100.0 / 360.0;
constexpr double kOnRing = 1.05;
// Of the chord height: what the middles of a ring's chords may take up.
constexpr double kShareOfChordHeight = 0.9;
// Of the distance that a ring would have without a chord height. In a coarse first triangulation chords run so deep
// below a cone that rings that keep theirs at once would crowd around the apex.
constexpr double kMostJump = 0.1;

}  // namespace

bool ApexRings::put_around(int h, std::vector<int>& touched) {
    if (!cone_fan(work_.mesh, h)) {
        return false;
    }
    Apex apex{work_.mesh.vertex_of(h), work_.mesh.face_of(SurfaceMesh::triangle_of(h)), h};
    if (segments_.is_free(apex.vertex)) {
        return false;
    }
    if (++tries_[apex.vertex] > kMaxTries) {
        segments_.free_apex(apex.vertex);
        return false;
    }
    const std::size_t before = touched.size();
    auto fan = cone_fan(work_.mesh, h);
    for (int k = 0; fan && k < kMaxSwaps && narrow_widest(apex, *fan, touched); ++k) {
        fan = cone_fan(work_.mesh, apex.half_edge);
    }
    if (fan) {
        Ring ring = ring_within(apex, *fan);
        const bool begun = split_seam(apex, ring, touched);
        fan = cone_fan(work_.mesh, apex.half_edge);
        if (begun && fan) {
            insert(sites_on(apex, *fan, ring), touched);
            find_again(apex, touched, before);
            give_up_if_missed(apex, ring);
        }
    }
    return touched.size() > before;
}

// Around a sharp turn of the surface, as at the ends of an ellipse, chords of a ring would run deep below it, and old
// spokes stay.
void ApexRings::give_up_if_missed(const Apex& apex, const Ring& ring) {
    const auto fan = cone_fan(work_.mesh, apex.half_edge);
    if (fan && static_cast<int>(fan->triangles) > ring.count && ++misses_[apex.vertex] >= kMaxMisses) {
        segments_.free_apex(apex.vertex);
    }
}

void ApexRings::find_again(Apex& apex, const std::vector<int>& touched, std::size_t first) const {
    const SurfaceMesh& mesh = work_.mesh;
    for (std::size_t i = first; i < touched.size(); ++i) {
        for (int h = 3 * touched[i]; h < 3 * touched[i] + 3; ++h) {
            if (mesh.vertex_of(h) == apex.vertex && mesh.face_of(touched[i]) == apex.face) {
                apex.half_edge = h;
            }
        }
    }
}

// A first triangulation takes chords across the base of a cone for edges: the apex gets the vertices beyond them as
// neighbours, one by one.
bool ApexRings::narrow_widest(Apex& apex, const ApexFan& fan, std::vector<int>& touched) {
    const SurfaceMesh& mesh = work_.mesh;
    const double most = kWidestBelowRing * fan.sum;
    for (const int h : mesh.star(apex.half_edge)) {
        const int opposite = SurfaceMesh::next(h);
        const int twin = mesh.twin(opposite);
        if (twin < 0 || angle_at(mesh, h) <= most) {
            continue;
        }
        const int beyond = SurfaceMesh::prev(twin);
        const Corner top = corner_of(mesh, mesh.site_of(h));
        const Corner third = corner_of(mesh, mesh.site_of(beyond));
        if (mesh.vertex_of(beyond) == apex.vertex || work_.maxmin.joined(apex.vertex, mesh.vertex_of(beyond)) ||
            alignment(top, corner_of(mesh, mesh.site_of(opposite)), third) < kAlignedAtApex ||
            alignment(top, third, corner_of(mesh, mesh.site_of(SurfaceMesh::prev(h)))) < kAlignedAtApex) {
            return false;
        }
        const std::size_t before = touched.size();
        work_.maxmin.swap(opposite, touched);
        find_again(apex, touched, before);
        return true;
    }
    return false;
}

ApexRings::Ring ApexRings::ring_within(const Apex& apex, const ApexFan& fan) const {
    const SurfaceMesh& mesh = work_.mesh;
    const int now = static_cast<int>(fan.triangles);
    const int most = std::max(3, static_cast<int>(fan.sum / (kSlack * bound_)));
    const int count = now > most ? std::max(most, (now + 1) / 2)
                                 : std::clamp(static_cast<int>(std::lround(fan.sum / kComfortable)), 3, most);
    double shortest = 1e300;
    for (const int h : mesh.star(apex.half_edge)) {
        if (mesh.segment_of(h) < 0) {
            shortest = std::min(shortest, side_length(mesh, h));
        }
    }
    // With the mean of the edges along both rings, `shortest - away` is the height of triangles between them.
    const double height = kHeight * 0.5 * fan.sum;
    double away = shortest * (1.0 - height / now) / (1.0 + height / count);
    if (chord_height_ > 0.0) {
        const double below = fan.sum / (2.0 * M_PI) * (1.0 - std::cos(M_PI / count));  // a chord's middle, at 1 mm
        away = std::max(std::min(away, kShareOfChordHeight * chord_height_ / below), kMostJump * away);
    }
    return {count, away, shortest};
}

// A vertex so far from the apex. Around slender cones rings lie close together.
bool ApexRings::Ring::holds(double length) const {
    return length <= std::min(kOnRing * away, 0.5 * (away + least_beyond));
}

// Where a seam ends in the apex, its vertex on the ring is the first. `ring` takes its distance.
// @return whether there is none, or one on the ring now
bool ApexRings::split_seam(Apex& apex, Ring& ring, std::vector<int>& touched) {
    const SurfaceMesh& mesh = work_.mesh;
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
        find_again(apex, touched, before);
        length = side_length(mesh, mesh.star(apex.half_edge).front());
    }
    if (!ring.holds(length)) {
        return false;
    }
    ring.away = length;
    return true;
}

// In the triangles as they lie around the apex, unrolled.
std::vector<Candidate> ApexRings::sites_on(const Apex& apex, const ApexFan& fan, const Ring& ring) const {
    const SurfaceMesh& mesh = work_.mesh;
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
        const Vec3 b = mesh.point_of(SurfaceMesh::next(h)) - top;
        const Vec3 c = mesh.point_of(SurfaceMesh::prev(h)) - top;
        const Vec3 along = b.normalized();
        const Vec3 across = (c - along * along.dot(c)).normalized();
        const double x = ring.away * std::cos(turn - passed);
        const double y = ring.away * std::sin(turn - passed);
        const double of_c = y / across.dot(c);
        const double of_b = (x - of_c * along.dot(c)) / b.norm();
        const auto uv = [&](int g) { return mesh.site(mesh.site_of(g)).uv; };
        sites.push_back({SurfaceMesh::triangle_of(h), top + x * along + y * across,
                         uv(h) + of_b * (uv(SurfaceMesh::next(h)) - uv(h)) + of_c * (uv(SurfaceMesh::prev(h)) - uv(h)),
                         false, ring.away});
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
