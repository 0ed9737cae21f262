// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/crossing_refiner.h"

#include <algorithm>

#include "triangulate/deviation.h"

namespace mq::triangulate {

namespace {

using geometry::Query;
using mesh::SurfaceMesh;

// A crossing deeper than so many times the heights of both triangles over their surfaces is not due to chords.
constexpr double kDeeper = 2.0;
// Of a pair that triangle is split whose side is higher over its surface, and the other one if it is about as high.
constexpr double kAsHigh = 0.5;
// Sides nearer to the surface than this, in steps of single precision, are exact.
constexpr double kExact = 4.0;

}  // namespace

// How far triangle a lies on the lesser side of the plane of b.
double CrossingRefiner::depth(int a, int b) const {
    const SurfaceMesh& mesh = work_.mesh;
    const Vec3& o = mesh.point_of(3 * b);
    const Vec3 normal = (mesh.point_of(3 * b + 1) - o).cross(mesh.point_of(3 * b + 2) - o).normalized();
    double above = 0.0;
    double below = 0.0;
    for (int h = 3 * a; h < 3 * a + 3; ++h) {
        const double height = normal.dot(mesh.point_of(h) - o);
        above = std::max(above, height);
        below = std::max(below, -height);
    }
    return std::min(above, below);
}

// Triangles of one face that lie the same way and overlap are a fold, which is no matter of chords. (So are coarse
// layers of a face that is rolled up: these are left, and reported.)
bool CrossingRefiner::folded(const std::array<int, 2>& pair) const {
    const SurfaceMesh& mesh = work_.mesh;
    std::array<Vec3, 2> normals;
    for (int i = 0; i < 2; ++i) {
        const Vec3& o = mesh.point_of(3 * pair[i]);
        normals[i] = (mesh.point_of(3 * pair[i] + 1) - o).cross(mesh.point_of(3 * pair[i] + 2) - o);
    }
    return mesh.face_of(pair[0]) == mesh.face_of(pair[1]) && normals[0].dot(normals[1]) > 0.0;
}

std::vector<CrossingRefiner::Crossing> CrossingRefiner::crossings() {
    std::vector<Crossing> result;
    for (const auto& pair : finder_.pairs()) {
        Crossing crossing{pair, {}, {}, false};
        double heights = 0.0;
        for (int i = 0; i < 2; ++i) {
            crossing.sides[i] = highest_side(pair[i]);
            crossing.heights[i] = height(crossing.sides[i]);
            heights += crossing.heights[i];
        }
        crossing.by_chords = !folded(pair) && std::min(depth(pair[0], pair[1]), depth(pair[1], pair[0])) <=
                                                  kDeeper * heights + work_.grid.resolution();
        result.push_back(crossing);
    }
    return result;
}

// Where most crossings of two faces are deeper than the chords explain, the part's own faces cross.
void CrossingRefiner::judge(const std::vector<Crossing>& crossings) {
    std::map<CrossingFinder::Faces, int> balance;
    for (const Crossing& crossing : crossings) {
        balance[finder_.faces_of(crossing.pair)] += crossing.by_chords ? 1 : -1;
    }
    for (const auto& [faces, more] : balance) {
        if (more < 0) {
            of_the_part_.insert(faces);
        }
    }
}

// Of a side over its surface, or over its curve.
double CrossingRefiner::height(int half_edge) {
    const SurfaceMesh& mesh = work_.mesh;
    const int s = mesh.segment_of(half_edge);
    if (s < 0) {
        return edge_peak(mesh, half_edge).height;
    }
    const SurfaceMesh::Segment& piece = mesh.segment(s);
    const Vec3 middle = 0.5 * (mesh.vertex(piece.vertices[0]).point + mesh.vertex(piece.vertices[1]).point);
    const geometry::Answer foot = work_.session.ask(Query::edge_nearest(
        piece.edge, work_.grid.to_part(middle), 0.5 * (piece.t[0] + piece.t[1]), piece.t[0], piece.t[1]));
    return segments_.refused(s) || !foot.found() ? 0.0 : foot.distance;
}

int CrossingRefiner::highest_side(int triangle) {
    int best = 3 * triangle;
    double most = -1.0;
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const double here = height(h);
        if (here > most) {
            most = here;
            best = h;
        }
    }
    return best;
}

void CrossingRefiner::request(const Crossing& crossing, std::vector<Site>& sites) const {
    const double higher = std::max(crossing.heights[0], crossing.heights[1]);
    for (int i = 0; i < 2; ++i) {
        if (crossing.heights[i] >= kAsHigh * higher && crossing.heights[i] > kExact * work_.grid.resolution()) {
            sites.push_back({crossing.sides[i], work_.mesh.stamp(crossing.pair[i])});
        }
    }
}

bool CrossingRefiner::split(const std::vector<Site>& sites) {
    std::vector<int> touched;
    const int before = work_.mesh.triangle_count();
    std::vector<Candidate> candidates;
    for (const Site& site : sites) {
        candidates.push_back(edge_middle_site(work_.mesh, site.half_edge));
    }
    const auto points = surface_points(work_, candidates);
    for (std::size_t i = 0; i < sites.size() && !work_.over_budget(); ++i) {
        const int h = sites[i].half_edge;
        if (work_.mesh.stamp(h / 3) != sites[i].stamp) {
            continue;
        }
        if (const int s = work_.mesh.segment_of(h); s >= 0) {
            segments_.request(s, true);
        } else if (points[i]) {
            insert_vertex(work_, h / 3, *points[i], touched, kAlignedAtLast);
        }
    }
    segments_.run(touched);
    return work_.mesh.triangle_count() > before;
}

bool CrossingRefiner::run() {
    if (work_.over_budget()) {
        return false;
    }
    const std::vector<Crossing> found = crossings();
    judge(found);
    std::vector<Site> sites;
    for (const Crossing& crossing : found) {
        if (crossing.by_chords && of_the_part_.count(finder_.faces_of(crossing.pair)) == 0) {
            request(crossing, sites);
        }
    }
    std::sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return a.half_edge < b.half_edge; });
    sites.erase(std::unique(sites.begin(), sites.end(),
                            [](const Site& a, const Site& b) { return a.half_edge == b.half_edge; }),
                sites.end());
    return !sites.empty() && split(sites);
}

}  // namespace mq::triangulate
