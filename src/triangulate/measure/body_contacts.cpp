// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/measure/body_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mesh/intersection/triangle_distance.h"

namespace mq::triangulate {

namespace {

using geometry::Query;

// Number of pairs of triangles of two faces that are examined first, spread over all pairs.
constexpr std::size_t kSample = 16;
// Number of points that are tried as common points of two solids.
constexpr std::size_t kTried = 8;
// Cosine of the angle between two faces that count as parallel.
constexpr double kParallel = 0.99;
// Triangles of two faces may deviate by twice the largest distance of one.
constexpr double kBoth = 2.0;
// Two points count as one up to this distance, in resolutions of single precision.
constexpr double kSame = 4.0;

using mesh::Corners;

Vec3 normal_of(const Corners& triangle) {
    return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
}

// The points where sides of a triangle go through another one.
void add_piercings(const Corners& sides, const Corners& other, std::vector<Vec3>& points) {
    const Vec3 normal = normal_of(other);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = sides[k];
        const Vec3& b = sides[(k + 1) % 3];
        const double above = normal.dot(a - other[0]);
        const double below = normal.dot(b - other[0]);
        if (above == below || (above > 0.0) == (below > 0.0)) {
            continue;
        }
        const Vec3 p = a + (b - a) * (above / (above - below));
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            inside = inside && normal.dot((other[(i + 1) % 3] - other[i]).cross(p - other[i])) >= 0.0;
        }
        if (inside) {
            points.push_back(p);
        }
    }
}

Vec3 mean_of(const std::vector<Vec3>& points) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points) {
        sum += p;
    }
    return sum / static_cast<double>(points.size());
}

// The middle of the intersection of two triangles that cross at an angle.
Vec3 common_middle(const Corners& first, const Corners& second) {
    std::vector<Vec3> points;
    add_piercings(first, second, points);
    add_piercings(second, first, points);
    return points.empty() ? mesh::triangle_distance(first, second).on_first : mean_of(points);
}

// Where a triangle ends.
struct End {
    double way = std::numeric_limits<double>::infinity();  // mm
    int side = -1;
};

// The end of a triangle in the direction of another one's normal, from a point in it, on the side where the end is
// nearer.
End end_of(const Corners& triangle, const Vec3& from, const Vec3& along) {
    const Vec3 normal = normal_of(triangle);
    const Vec3 direction = along - normal * normal.dot(along);
    const double slope = direction.squaredNorm();
    End end;
    for (int k = 0; k < 3; ++k) {
        const Vec3& a = triangle[static_cast<std::size_t>(k)];
        const Vec3 outward = (triangle[static_cast<std::size_t>((k + 1) % 3)] - a).cross(normal);
        const double speed = std::abs(outward.dot(direction));
        const double way = speed > 0.0 ? slope * std::max(outward.dot(a - from), 0.0) / speed : end.way;
        if (way < end.way) {
            end = {way, k};
        }
    }
    return end;
}

// The mean of the corners of the intersection of a triangle with another one's projection to its plane, and how far the
// other one would have to be moved until they are apart.
std::pair<Vec3, double> common_in_plane(const Corners& triangle, const Corners& other) {
    const Vec3 normal = normal_of(triangle);
    double least = std::numeric_limits<double>::infinity();
    std::vector<Vec3> common;
    for (const Vec3& p : other) {
        common.push_back(p - normal * normal.dot(p - triangle[0]));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 inward = normal.cross(triangle[(k + 1) % 3] - triangle[k]).normalized();
        const auto depth = [&](const Vec3& p) { return inward.dot(p - triangle[k]); };
        double deepest = 0.0;
        std::vector<Vec3> inside;
        for (std::size_t i = 0; i < common.size(); ++i) {
            const Vec3& p = common[i];
            const Vec3& q = common[(i + 1) % common.size()];
            deepest = std::max(deepest, depth(p));
            if (depth(p) >= 0.0) {
                inside.push_back(p);
            }
            if ((depth(p) > 0.0 && depth(q) < 0.0) || (depth(p) < 0.0 && depth(q) > 0.0)) {
                inside.push_back(p + (q - p) * (depth(p) / (depth(p) - depth(q))));
            }
        }
        least = std::min(least, deepest);
        common = std::move(inside);
    }
    if (common.empty()) {
        return {(triangle[0] + triangle[1] + triangle[2]) / 3.0, 0.0};
    }
    return {mean_of(common), least};
}

template <typename Item>
std::vector<Item> sample_of(const std::vector<Item>& items, std::size_t most) {
    std::vector<Item> sample;
    for (std::size_t k = 0; k < most; ++k) {
        sample.push_back(items[k * items.size() / most]);
    }
    return sample;
}

}  // namespace

BodyContact FaceContact::worst() const {
    BodyContact found = BodyContact::Touching;
    for (const auto& entry : contacts) {
        found = std::max(found, entry.second);
    }
    return found;
}

BodyContacts::BodyContacts(Workspace& work, SelfIntersections& finder) : work_(work), finder_(finder) {
    const geometry::Topology& topology = work.session.topology();
    owners_.resize(topology.faces.size());
    for (std::size_t v = 0; v < topology.volumes.size(); ++v) {
        const geometry::Volume& volume = topology.volumes[v];
        for (const auto& side : volume.sides) {
            owners_[static_cast<std::size_t>(side.face)].push_back(
                {static_cast<int>(v), volume.kind == geometry::Volume::Kind::Solid, side.flipped ? -1.0 : 1.0});
        }
    }
}

BodyContacts::Place BodyContacts::place_of(const std::array<int, 2>& pair, double deviation) const {
    const ClassifiedMesh& mesh = work_.mesh;
    const auto corners = [&](int t) {
        return Corners{mesh.point_of(3 * t), mesh.point_of(3 * t + 1), mesh.point_of(3 * t + 2)};
    };
    const Corners first = corners(pair[0]);
    const Corners second = corners(pair[1]);
    Place place;
    if (std::abs(normal_of(first).dot(normal_of(second))) >= kParallel) {
        const auto [common, depth] = common_in_plane(first, second);
        place.common = work_.grid.to_shape(common);
        place.depth = std::min(depth, common_in_plane(second, first).second);
    } else {
        const Vec3 common = common_middle(first, second);
        const std::array<End, 2> ends{end_of(first, common, normal_of(second)),
                                      end_of(second, common, normal_of(first))};
        place.ends = ends[1].way < ends[0].way ? 1 : 0;
        const End& end = ends[static_cast<std::size_t>(place.ends)];
        place.common = work_.grid.to_shape(common);
        place.depth = end.way;
        place.segment = end.side < 0 ? -1 : mesh.segment_of(3 * pair[static_cast<std::size_t>(place.ends)] + end.side);
    }
    place.deep = place.depth > kBoth * deviation + kSame * work_.grid.resolution();
    return place;
}

std::vector<BodyContacts::Place> BodyContacts::places_of(const Pairs& pairs, double deviation) {
    const ClassifiedMesh& mesh = work_.mesh;
    std::vector<Place> places;
    geometry::Engine::Batch batch;
    for (const auto& pair : pairs) {
        places.push_back(place_of(pair, deviation));
        for (const int t : pair) {
            const Vec2 uv = mesh.site(mesh.site_of(3 * t)).uv;
            batch.push_back(Query::face_nearest(mesh.face_of(t), places.back().common, uv.x(), uv.y()));
        }
    }
    const geometry::Engine::Answers answers = work_.session.ask(std::move(batch));
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const geometry::Answer& a = answers[2 * k];
        const geometry::Answer& b = answers[2 * k + 1];
        places[k].points = {a.point, b.point};
        places[k].normals = {a.normal, b.normal};
        places[k].found = a.status == geometry::Status::Ok && b.status == geometry::Status::Ok;
    }
    find_heights(pairs, places);
    return places;
}

// Finds the heights over the other face of the edges at which a triangle ends just behind the other one: the height of
// the lowest of three points; 0 if the edge passes through the face.
void BodyContacts::find_heights(const Pairs& pairs, std::vector<Place>& places) {
    constexpr std::size_t kPoints = 3;
    const ClassifiedMesh& mesh = work_.mesh;
    geometry::Engine::Batch batch;
    std::vector<std::size_t> asked;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Place& place = places[k];
        if (place.found && !place.deep && place.segment >= 0) {
            const ClassifiedMesh::Segment& piece = mesh.segment(place.segment);
            asked.push_back(k);
            batch.push_back(
                Query::edge_nearest(piece.edge, place.common, 0.5 * (piece.t[0] + piece.t[1]), piece.t[0], piece.t[1]));
        }
    }
    const geometry::Engine::Answers on_edges = work_.session.ask(std::move(batch));
    geometry::Engine::Batch over_faces;
    std::vector<Vec3> over_points;
    for (std::size_t k = 0; k < asked.size(); ++k) {
        const Place& place = places[asked[k]];
        const int other = pairs[asked[k]][static_cast<std::size_t>(1 - place.ends)];
        const Vec2 uv = mesh.site(mesh.site_of(3 * other)).uv;
        const auto& ends = mesh.segment(place.segment).vertices;
        for (const Vec3& p : {on_edges[k].point, work_.grid.to_shape(mesh.vertex(ends[0]).point),
                              work_.grid.to_shape(mesh.vertex(ends[1]).point)}) {
            over_faces.push_back(Query::face_nearest(mesh.face_of(other), p, uv.x(), uv.y()));
            over_points.push_back(p);
        }
    }
    const geometry::Engine::Answers over = work_.session.ask(std::move(over_faces));
    for (std::size_t k = 0; k < asked.size(); ++k) {
        Place& place = places[asked[k]];
        std::array<double, kPoints> heights{};
        bool found = on_edges[k].found();
        for (std::size_t i = 0; i < kPoints; ++i) {
            const geometry::Answer& answer = over[kPoints * k + i];
            found = found && answer.status == geometry::Status::Ok;
            heights[i] = answer.normal.dot(over_points[kPoints * k + i] - answer.point);
        }
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        place.segment = found ? place.segment : -1;
        place.height = *low > 0.0 ? *low : *high < 0.0 ? *high : 0.0;
    }
}

// @return the gap at this place, mm; 0: there is none. Shells have no inside: they only cross or touch.
double BodyContacts::gap_at(const Place& place, const Owner& first, const Owner& second, double tolerance,
                            Evidence& evidence) const {
    const bool solids = first.solid && second.solid;
    if (!solids && place.deep) {
        evidence.contact = BodyContact::Overlapping;
    }
    if (!place.found) {
        return 0.0;
    }
    const Vec3 outward = first.side * place.normals[0];
    const Vec3 other_outward = second.side * place.normals[1];
    const double cosine = outward.dot(other_outward);
    double gap = 0.0;
    if (cosine <= -kParallel) {
        const Vec3 between = place.points[1] - place.points[0];
        gap = std::copysign(between.norm(), outward.dot(between));
        if (gap < -tolerance) {
            evidence.common.push_back(place.points[0] + 0.5 * between);
        }
    } else if (cosine >= kParallel) {
        if (place.deep) {
            evidence.common.push_back(place.common - 2.0 * tolerance * outward);
        }
    } else {
        if (!place.deep && place.segment >= 0) {
            gap = (place.ends == 0 ? second.side : first.side) * place.height;
        }
        if (place.deep || gap < -tolerance) {
            evidence.common.push_back(place.common - 0.25 * place.depth * (outward + other_outward).normalized());
        }
    }
    if (gap > tolerance || (!solids && gap < -tolerance)) {
        evidence.contact = std::max(evidence.contact, BodyContact::Apart);
        return std::abs(gap);
    }
    return 0.0;
}

void BodyContacts::examine(FaceContact& contact, const Pairs& pairs, double deviation) {
    const geometry::Topology& topology = work_.session.topology();
    const std::vector<Place> places = places_of(pairs, deviation);
    contact.apart.clear();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::array<int, 2> faces{work_.mesh.face_of(pairs[k][0]), work_.mesh.face_of(pairs[k][1])};
        const double tolerance = kSame * work_.grid.resolution() +
                                 topology.faces[static_cast<std::size_t>(faces[0])].tolerance +
                                 topology.faces[static_cast<std::size_t>(faces[1])].tolerance;
        double apart = 0.0;
        for (const Owner& first : owners_[static_cast<std::size_t>(faces[0])]) {
            for (const Owner& second : owners_[static_cast<std::size_t>(faces[1])]) {
                const std::pair<int, int> volumes = std::minmax(first.volume, second.volume);
                Evidence evidence;
                apart = std::max(apart, gap_at(places[k], first, second, tolerance, evidence));
                BodyContact& known = contact.contacts[volumes];
                known = std::max(known, evidence.contact);
                std::vector<Vec3>& common = evidence_[volumes].common;
                common.insert(common.end(), evidence.common.begin(), evidence.common.end());
            }
        }
        if (apart > 0.0) {
            contact.apart.emplace_back(pairs[k], apart);
        }
    }
}

// Whether one of the points is in both solids.
bool BodyContacts::have_in_common(const std::pair<int, int>& volumes, const std::vector<Vec3>& points) {
    const auto& of = work_.session.topology().volumes;
    if (of[static_cast<std::size_t>(volumes.first)].kind != geometry::Volume::Kind::Solid ||
        of[static_cast<std::size_t>(volumes.second)].kind != geometry::Volume::Kind::Solid) {
        return false;
    }
    return std::any_of(points.begin(), points.end(), [&](const Vec3& p) {
        return work_.session.ask(Query::volume_contains(volumes.first, p)).side > 0 &&
               work_.session.ask(Query::volume_contains(volumes.second, p)).side > 0;
    });
}

const std::vector<FaceContact>& BodyContacts::find(double deviation) {
    const std::array<std::int64_t, 2> state{work_.mesh.edges_made(), work_.mesh.triangle_count()};
    if (state != state_ || deviation != deviation_) {
        examine_all(deviation);
        state_ = state;
        deviation_ = deviation;
    }
    return found_;
}

void BodyContacts::examine_all(double deviation) {
    std::map<SelfIntersections::Faces, FaceContact> by_faces;
    for (const auto& pair : finder_.pairs_of_bodies()) {
        FaceContact& contact = by_faces[finder_.faces_of(pair)];
        contact.faces = finder_.faces_of(pair);
        contact.pairs.push_back(pair);
    }
    evidence_.clear();
    found_.clear();
    for (auto& entry : by_faces) {
        work_.progress.check();
        FaceContact& contact = entry.second;
        const bool few = contact.pairs.size() <= kSample;
        examine(contact, few ? contact.pairs : sample_of(contact.pairs, kSample), deviation);
        if (!few && !contact.apart.empty()) {
            examine(contact, contact.pairs, deviation);
        }
        found_.push_back(std::move(contact));
    }
    std::set<std::pair<int, int>> overlapping;
    for (const auto& [volumes, evidence] : evidence_) {
        work_.progress.check();
        if (have_in_common(volumes,
                           evidence.common.size() <= kTried ? evidence.common : sample_of(evidence.common, kTried))) {
            overlapping.insert(volumes);
        }
    }
    for (FaceContact& contact : found_) {
        for (auto& [volumes, how] : contact.contacts) {
            how = overlapping.count(volumes) > 0 ? BodyContact::Overlapping : how;
        }
    }
}

}  // namespace mq::triangulate
