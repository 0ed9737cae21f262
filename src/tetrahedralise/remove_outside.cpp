// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/remove_outside.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "tetrahedralise/cells/flips.h"
#include "tetrahedralise/cells/tetrahedra.h"
#include "tetrahedralise/star_cavity.h"

namespace mq::tetrahedralise {

namespace {

/// The sides at which the faces of a cell are on the surface, one bit each, for the cells inside.
struct Walls {
    std::vector<std::uint8_t> faces;
    std::vector<int> inside;
};

Walls walls_of(const Tetrahedralisation& mesh, const SurfaceConstraints& surface) {
    Walls walls{std::vector<std::uint8_t>(mesh.cells.size(), 0), {}};
    for (const auto& t : surface.triangles()) {
        const int cell = mesh.cell_with(t[0], t[1], t[2]);
        int face = 0;
        while (std::find(t.begin(), t.end(), mesh.cells[cell].v[face]) != t.end()) {
            ++face;
        }
        const int other = mesh.cells[cell].n[face];
        walls.faces[cell] |= 1U << face;
        walls.faces[other] |= 1U << mesh.face_towards(other, cell);
        walls.inside.push_back(mesh.orient(t[0], t[1], t[2], mesh.cells[cell].v[face]) < 0 ? cell : other);
    }
    return walls;
}

}  // namespace

void remove_outside(Tetrahedralisation& mesh, const SurfaceConstraints& surface, int outer) {
    Walls walls = walls_of(mesh, surface);
    std::vector<char> inside(mesh.cells.size(), 0);
    std::vector<int>& queue = walls.inside;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const Cell& cell = mesh.cells[queue[i]];
        inside[queue[i]] = 1;
        for (int k = 0; k < 4; ++k) {
            if (cell.v[k] >= outer && cell.v[k] < outer + 4) {
                throw MeshingFailed(phrases::kNotOutward);
            }
            if ((walls.faces[queue[i]] >> k & 1U) == 0 && !inside[cell.n[k]]) {
                inside[cell.n[k]] = 1;
                queue.push_back(cell.n[k]);
            }
        }
    }
    std::vector<int> outside;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        if (mesh.alive(static_cast<int>(c)) && !inside[c]) {
            outside.push_back(static_cast<int>(c));
        }
    }
    std::vector<int> created;
    mesh.replace(outside, {}, created);
}

namespace {

double worst_quality(const Tetrahedralisation& mesh, const std::vector<std::array<int, 3>>& faces, const Vec3& p) {
    double worst = 1.0;
    for (const auto& f : faces) {
        worst = std::min(worst, volume_quality(mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2]), p));
    }
    return worst;
}

/// The directions in which a point on the surface may find its place: by the normals, and towards what lies inside.
std::vector<Vec3> ways_inside(const Tetrahedralisation& mesh, const SurfaceConstraints::Division& division,
                              const std::vector<int>& star) {
    Vec3 inwards = Vec3::Zero();
    for (const auto& t : division.parents) {
        inwards -= (mesh.point(t[1]) - mesh.point(t[0])).cross(mesh.point(t[2]) - mesh.point(t[0])).normalized();
    }
    Vec3 middle = Vec3::Zero();
    for (const int c : star) {
        for (const int v : mesh.cells[c].v) {
            middle += (mesh.point(v) - mesh.point(division.vertex)) / (4.0 * static_cast<double>(star.size()));
        }
    }
    std::vector<Vec3> ways{inwards.normalized(), middle.normalized(), (inwards.normalized() + middle.normalized())};
    for (const auto& t : division.parents) {
        ways.push_back(-(mesh.point(t[1]) - mesh.point(t[0])).cross(mesh.point(t[2]) - mesh.point(t[0])).normalized());
    }
    return ways;
}

/// A plane that the point must stay on the positive side of.
struct Plane {
    Vec3 normal;    ///< unit
    double height;  ///< the point's height above it, before it moves
};

/// The planes of the faces opposite a vertex, and of the triangles that its own triangles on the surface came of.
std::vector<Plane> planes_around(const Tetrahedralisation& mesh, int vertex, const std::vector<int>& star,
                                 const std::vector<std::array<int, 3>>& parents) {
    std::vector<std::array<int, 3>> faces = parents;
    for (const int c : star) {
        const int(&k)[3] = kFaceOf[mesh.index_of(c, vertex)];
        const std::array<int, 4>& v = mesh.cells[c].v;
        faces.push_back({v[k[0]], v[k[1]], v[k[2]]});
    }
    std::vector<Plane> planes;
    for (const auto& f : faces) {
        const Vec3& a = mesh.point(f[0]);
        const Vec3 normal = (mesh.point(f[1]) - a).cross(mesh.point(f[2]) - a).normalized();
        planes.push_back({normal, normal.dot(mesh.point(vertex) - a)});
    }
    return planes;
}

/// The direction that leads away from all planes nearer than a distance: the point nearest the origin in the convex
/// hull of their normals (Gilbert 1966). Zero where there is no such direction.
Vec3 way_from_planes(const std::vector<Plane>& planes, double distance) {
    /// Enough for directions that no plane leaves more than a few degrees.
    constexpr int kRounds = 200;
    std::vector<Vec3> normals;
    for (const Plane& plane : planes) {
        if (plane.height < distance) {
            normals.push_back(plane.normal);
        }
    }
    Vec3 way = normals.empty() ? Vec3(Vec3::Zero()) : normals.front();
    for (int round = 0; round < kRounds && !normals.empty(); ++round) {
        const Vec3 change = *std::min_element(normals.begin(), normals.end(), [&](const Vec3& a, const Vec3& b) {
            return a.dot(way) < b.dot(way);
        }) - way;
        if (change.isZero()) {
            break;
        }
        way += std::clamp(-way.dot(change) / change.squaredNorm(), 0.0, 1.0) * change;
    }
    return way.normalized();
}

void move_inwards(Tetrahedralisation& mesh, const SurfaceConstraints& surface,
                  const SurfaceConstraints::Division& division) {
    /// Halvings of the first step: until it is of the size of rounding errors.
    constexpr int kHalvings = 36;
    std::vector<int> star;
    mesh.star(division.vertex, star);
    std::vector<std::array<int, 3>> parents;
    double size = 0.0;
    for (const auto& t : division.parents) {
        parents.push_back({t[0], t[2], t[1]});
        size = std::max(size, (mesh.point(t[1]) - mesh.point(t[0])).norm());
    }
    const Vec3 start = mesh.point(division.vertex);
    StarCavity cavity(mesh, surface);
    Vec3 best = start;
    double best_quality = 0.0;
    const auto try_place = [&](const Vec3& place) {
        if (cavity.open(place, star, division.vertex, parents)) {
            const double quality = worst_quality(mesh, cavity.faces(), place);
            best = quality > best_quality ? place : best;
            best_quality = std::max(quality, best_quality);
        }
    };
    for (const Vec3& way : ways_inside(mesh, division, star)) {
        for (int i = 0; i < kHalvings; ++i) {
            try_place(start + std::ldexp(size, -i) * way);
        }
    }
    if (!(best_quality > 0.0)) {
        // In a thin wall, faces opposite may leave a narrow wedge.
        const std::vector<Plane> planes = planes_around(mesh, division.vertex, star, parents);
        for (int i = 0; i < kHalvings; ++i) {
            const double step = std::ldexp(size, -i);
            try_place(start + step * way_from_planes(planes, step));
        }
    }
    if (!(best_quality > 0.0) || !cavity.open(best, star, division.vertex, parents)) {
        throw MeshingFailed(phrases::kPointNotMoved);
    }
    mesh.move_point(division.vertex, best);
    std::vector<int> created;
    const auto added = cavity.cells_of(division.vertex);
    mesh.replace(cavity.cells(), added, created);
}

}  // namespace

void move_divisions_inwards(Tetrahedralisation& mesh, const SurfaceConstraints& surface) {
    const auto& divisions = surface.divisions();
    for (auto division = divisions.rbegin(); division != divisions.rend(); ++division) {
        move_inwards(mesh, surface, *division);
    }
}

}  // namespace mq::tetrahedralise
