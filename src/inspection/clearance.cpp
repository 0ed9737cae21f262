// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/clearance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "base/parallel.h"
#include "inspection/ray_crossings.h"
#include "mesh/corner_table.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::inspection {

using mesh::Corners;

namespace {

/// Triangles or vertices that a thread takes at a time.
constexpr int kChunk = 256;

using FacePair = std::pair<std::int32_t, std::int32_t>;
using NearestByFaces = std::map<FacePair, NearestPlaces>;

struct Body {
    const mesh::TriangleMesh* mesh = nullptr;
    std::unique_ptr<mesh::NearestTree> tree;
    std::vector<Vec3> starts;  ///< one vertex of each component

    Corners corners(std::int32_t triangle) const {
        const mesh::Triangle& t = mesh->triangles[triangle];
        return {mesh->vertices[t[0]], mesh->vertices[t[1]], mesh->vertices[t[2]]};
    }
    std::int32_t face(std::int32_t triangle) const {
        return mesh->triangle_face.empty() ? -1 : mesh->triangle_face[triangle];
    }
};

Body body_of(const mesh::TriangleMesh& mesh) {
    Body body;
    body.mesh = &mesh;
    body.tree = std::make_unique<mesh::NearestTree>(mesh.vertices, mesh.triangles);
    const mesh::Components components = mesh::components(mesh::edge_twins(mesh.triangles, mesh.vertices.size()));
    std::int32_t known = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        if (components.component_of[k] == known) {
            body.starts.push_back(mesh.vertices[mesh.triangles[k][0]]);
            ++known;
        }
    }
    return body;
}

double distance_of_boxes(const Box& a, const Box& b) {
    return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

bool is_nearer(const NearestPlaces& a, const NearestPlaces& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.triangles < b.triangles;
}

/// The smallest distance of vertices of the one body from the other, an upper bound; at most `bound`.
double distance_of_vertices(const Body& a, const Body& b, double bound, const Progress* progress) {
    const auto count = static_cast<int>(a.mesh->vertices.size());
    const int chunks = (count + kChunk - 1) / kChunk;
    std::vector<double> least(static_cast<std::size_t>(chunks), bound);
    const Box other = b.tree->box();
    parallel_for(chunks, [&](int chunk) {
        check_cancelled(progress);
        double& best = least[static_cast<std::size_t>(chunk)];
        for (int v = chunk * kChunk; v < std::min((chunk + 1) * kChunk, count); ++v) {
            const Vec3& p = a.mesh->vertices[static_cast<std::size_t>(v)];
            const Vec3 gap = (other.low - p).cwiseMax(p - other.high).cwiseMax(0.0);
            if (gap.norm() <= best) {
                best = std::min(best, b.tree->nearest(p, best).distance);
            }
        }
    });
    return chunks > 0 ? *std::min_element(least.begin(), least.end()) : bound;
}

struct Found {
    NearestByFaces faces;
    std::array<std::set<std::int32_t>, 2> crossing;  ///< by body: triangles that cross the other one
};

/// For pairs of faces the nearest places of a chunk of triangles of body a and of body b, as far as they are within
/// `reach`.
Found nearest_in_chunk(const Body& a, const Body& b, double reach, int chunk, const Progress* progress) {
    Found found;
    const auto count = static_cast<std::int32_t>(a.mesh->triangles.size());
    const Box other = b.tree->box();
    for (std::int32_t i = chunk * kChunk; i < std::min((chunk + 1) * kChunk, count); ++i) {
        check_cancelled(progress);
        const Corners corners = a.corners(i);
        Box box;
        for (const Vec3& p : corners) {
            box.add(p);
        }
        box.low -= Vec3::Constant(reach);
        box.high += Vec3::Constant(reach);
        if (!box.meets(other)) {
            continue;
        }
        b.tree->for_each_in_box(box, [&](std::int32_t j) {
            const mesh::TriangleDistance distance = mesh::triangle_distance(corners, b.corners(j));
            if (distance.depth > 0.0) {
                found.crossing[0].insert(i);
                found.crossing[1].insert(j);
            }
            if (distance.distance <= reach) {
                const NearestPlaces places{distance.distance, {i, j}, {distance.on_first, distance.on_second}};
                const auto [at, is_new] = found.faces.try_emplace({a.face(i), b.face(j)}, places);
                if (!is_new && is_nearer(places, at->second)) {
                    at->second = places;
                }
            }
        });
    }
    return found;
}

bool contains(const Body& body, const Vec3& p) {
    // The direction of the ray is arbitrary.
    const Vec3 direction(0.36, 0.48, 0.8);
    return body.tree->box().contains(p) &&
           winding_at_start(crossings_of(*body.tree, body.mesh->vertices, body.mesh->triangles, p, direction, -1)) > 0;
}

bool lies_in(const Body& a, const Body& b) {
    return std::any_of(a.starts.begin(), a.starts.end(), [&](const Vec3& start) { return contains(b, start); });
}

/// The largest distance from the surface of the second body of vertices of the first that lie in it.
double depth_of_vertices(const Body& a, const Body& b, const Progress* progress) {
    const auto count = static_cast<int>(a.mesh->vertices.size());
    const int chunks = (count + kChunk - 1) / kChunk;
    std::vector<double> most(static_cast<std::size_t>(chunks), 0.0);
    parallel_for(chunks, [&](int chunk) {
        double& depth = most[static_cast<std::size_t>(chunk)];
        for (int v = chunk * kChunk; v < std::min((chunk + 1) * kChunk, count); ++v) {
            check_cancelled(progress);
            const Vec3& p = a.mesh->vertices[static_cast<std::size_t>(v)];
            if (b.tree->box().contains(p) && b.tree->any_within(p, depth, 0) < 0 && contains(b, p)) {
                depth = std::max(depth, b.tree->nearest(p).distance);
            }
        }
    });
    return chunks > 0 ? *std::max_element(most.begin(), most.end()) : 0.0;
}

/// The largest depth below the surface of b of the middles of pieces of edges of a that are inside of b, for the edges
/// of the given triangles.
double depth_of_edges(const Body& a, const std::set<std::int32_t>& triangles, const Body& b, const Progress* progress) {
    const std::vector<std::int32_t> list(triangles.begin(), triangles.end());
    std::vector<double> most(list.size(), 0.0);
    for_chunks(static_cast<int>(list.size()), [&](int k) {
        check_cancelled(progress);
        const Corners corners = a.corners(list[static_cast<std::size_t>(k)]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = corners[i];
            const Vec3 along = corners[(i + 1) % 3] - p;
            const double length = along.norm();
            const Vec3 direction = along / length;
            double before = 0.0;
            std::vector<Crossing> ends = crossings_of(*b.tree, b.mesh->vertices, b.mesh->triangles, p, direction, -1);
            ends.push_back({length, -1, false});
            for (const Crossing& end : ends) {
                const double here = std::min(end.distance, length);
                const Vec3 middle = p + 0.5 * (before + here) * direction;
                if (here > before && contains(b, middle)) {
                    double& depth = most[static_cast<std::size_t>(k)];
                    depth = std::max(depth, b.tree->nearest(middle).distance);
                }
                before = here;
            }
        }
    });
    return list.empty() ? 0.0 : *std::max_element(most.begin(), most.end());
}

/// The clearance of two bodies, without the numbers of the bodies.
Clearance clearance_of(const Body& a, const Body& b, double slack, double within, const Progress* progress) {
    double bound = distance_of_vertices(a, b, within, progress);
    bound = distance_of_vertices(b, a, bound, progress);
    // Slightly larger than the bound, so that rounding of boxes does not lose places that are as near.
    const double reach = bound * (1.0 + 1e-12) + slack;
    const int chunks = (static_cast<int>(a.mesh->triangles.size()) + kChunk - 1) / kChunk;
    std::vector<Found> found(static_cast<std::size_t>(chunks));
    parallel_for(chunks, [&](int chunk) {
        found[static_cast<std::size_t>(chunk)] = nearest_in_chunk(a, b, reach, chunk, progress);
    });
    Clearance clearance;
    NearestByFaces all;
    std::array<std::set<std::int32_t>, 2> crossing;
    for (const Found& one : found) {
        for (std::size_t k = 0; k < 2; ++k) {
            crossing[k].insert(one.crossing[k].begin(), one.crossing[k].end());
        }
        for (const auto& [faces, places] : one.faces) {
            const auto [at, is_new] = all.try_emplace(faces, places);
            if (!is_new && is_nearer(places, at->second)) {
                at->second = places;
            }
            if (is_nearer(places, clearance.nearest)) {
                clearance.nearest = places;
            }
        }
    }
    for (const auto& [faces, places] : all) {
        if (places.distance <= clearance.nearest.distance + slack) {
            clearance.faces.push_back(places);
        }
    }
    if (clearance.nearest.distance > 0.0) {
        clearance.inside = lies_in(a, b) ? 0 : lies_in(b, a) ? 1 : -1;
    } else {
        clearance.depth =
            std::max({depth_of_vertices(a, b, progress), depth_of_vertices(b, a, progress),
                      depth_of_edges(a, crossing[0], b, progress), depth_of_edges(b, crossing[1], a, progress)});
    }
    return clearance;
}

}  // namespace

std::vector<Clearance> clearances(const std::vector<const mesh::TriangleMesh*>& bodies,
                                  const std::vector<double>& slack, const ClearanceOptions& options,
                                  Progress* progress) {
    std::vector<Body> all;
    for (const mesh::TriangleMesh* mesh : bodies) {
        check_cancelled(progress);
        all.push_back(body_of(*mesh));
    }
    std::vector<Clearance> found;
    const double pairs = 0.5 * static_cast<double>(all.size()) * static_cast<double>(all.size() - 1);
    double done = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (distance_of_boxes(all[i].tree->box(), all[j].tree->box()) <= options.within) {
                Clearance clearance = clearance_of(all[i], all[j], slack[i] + slack[j], options.within, progress);
                clearance.bodies = {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
                if (clearance.nearest.distance <= options.within || clearance.inside >= 0) {
                    found.push_back(std::move(clearance));
                }
            }
            if (progress != nullptr) {
                progress->advance(++done / pairs);
            }
        }
    }
    return found;
}

}  // namespace mq::inspection
