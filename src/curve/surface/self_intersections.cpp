// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/self_intersections.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "curve/surface/tuning.h"
#include "mesh/intersection/self_intersection.h"

namespace mq::curve {

namespace {

std::vector<int> triangles_around(const CurvedSurface& surface, std::size_t volume) {
    std::set<int> faces;
    for (const auto& [face, flipped] : surface.volume_faces[volume]) {
        faces.insert(face);
    }
    std::vector<int> result;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (surface.triangles[t].alive && faces.count(surface.triangles[t].face) > 0) {
            result.push_back(static_cast<int>(t));
        }
    }
    return result;
}

std::pair<int, int> longest_edge(const SurfaceEditor& editor, int triangle) {
    const auto& v = editor.triangle(triangle).corners;
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (editor.length(v[k], v[(k + 1) % 3]) > editor.length(v[longest], v[(longest + 1) % 3])) {
            longest = k;
        }
    }
    return {v[longest], v[(longest + 1) % 3]};
}

std::string place(const CurvedSurface& surface, int triangle) {
    const SurfaceTriangle& t = surface.triangles[static_cast<std::size_t>(triangle)];
    Vec3 centre = Vec3::Zero();
    for (const int v : t.corners) {
        centre += surface.shapes.vertices[static_cast<std::size_t>(v)].point / 3.0;
    }
    char text[96];
    std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", centre.x(), centre.y(), centre.z());
    return text;
}

/// The height of a straight triangle divided by its longest edge.
double flatness(const CurvedSurface& surface, int triangle) {
    const auto& v = surface.triangles[static_cast<std::size_t>(triangle)].corners;
    const auto point = [&](std::size_t k) -> const Vec3& {
        return surface.shapes.vertices[static_cast<std::size_t>(v[k % 3])].point;
    };
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, (point(k + 1) - point(k)).squaredNorm());
    }
    return (point(1) - point(0)).cross(point(2) - point(0)).norm() / longest;
}

}  // namespace

std::vector<Crossing> find_self_intersections(const CurvedSurface& surface, std::size_t volume,
                                              const Progress& progress) {
    const std::vector<int> around = triangles_around(surface, volume);
    std::vector<Vec3> points;
    for (const elements::Vertex& vertex : surface.shapes.vertices) {
        points.push_back(vertex.point);
    }
    std::vector<mesh::Triangle> triangles;
    for (const int t : around) {
        const auto& v = surface.triangles[static_cast<std::size_t>(t)].corners;
        triangles.push_back({v[0], v[1], v[2]});
    }
    std::vector<Crossing> result;
    for (const mesh::ContactPair& pair :
         mesh::self_intersections(points, triangles, SurfaceTuning::kMostCrossings, &progress)) {
        result.emplace_back(around[static_cast<std::size_t>(pair.a)], around[static_cast<std::size_t>(pair.b)]);
    }
    return result;
}

int refine_crossings(SurfaceEditor& editor, const geometry::Topology& topology, const Progress& progress) {
    int halved = 0;
    for (std::size_t volume = 0; volume < topology.volumes.size(); ++volume) {
        if (topology.volumes[volume].kind != geometry::Volume::Kind::Solid) {
            continue;
        }
        for (int round = 0; round < SurfaceTuning::kHalvingRounds; ++round) {
            std::set<std::pair<int, int>> edges;
            for (const Crossing& crossing : find_self_intersections(editor.surface, volume, progress)) {
                edges.insert(longest_edge(editor, crossing.first));
                edges.insert(longest_edge(editor, crossing.second));
            }
            int now = 0;
            for (const auto& [a, b] : edges) {
                progress.check();
                if (editor.surface.has_edge(a, b)) {
                    now += split_surface_edge(editor, a, b, SurfaceEditor::Rule::Refine) >= 0 ? 1 : 0;
                }
            }
            halved += now;
            if (now == 0) {
                break;
            }
        }
    }
    return halved;
}

std::string first_fault(const CurvedSurface& surface, const geometry::Topology& topology, std::size_t volume,
                        const Progress& progress) {
    const auto face = [&](int t) { return topology.name_of({2, surface.triangles[static_cast<std::size_t>(t)].face}); };
    const std::vector<Crossing> crossing = find_self_intersections(surface, volume, progress);
    if (!crossing.empty()) {
        const auto& [a, b] = crossing.front();
        return "straight triangles of " + face(a) + " and " + face(b) + " meet near " + place(surface, a);
    }
    const std::vector<int> around = triangles_around(surface, volume);
    if (around.empty()) {
        return "it has no triangles";
    }
    const int flattest = *std::min_element(around.begin(), around.end(),
                                           [&](int a, int b) { return flatness(surface, a) < flatness(surface, b); });
    return "its triangles do not cross; the flattest one is on " + face(flattest) + " near " + place(surface, flattest);
}

}  // namespace mq::curve
