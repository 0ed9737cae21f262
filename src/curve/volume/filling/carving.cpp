// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/filling/carving.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "curve/volume/filling/flips.h"
#include "curve/volume/mesher/tetrahedral_mesher.h"

namespace mq::curve {

namespace {

/// The side of a cell on which the surface is its face, one bit each, and the cells inside at the surface.
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
                throw MeshingFailed("the surface is not closed or not outward");
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

/// The cells around a point on the surface once it has moved inwards, those on its parent triangles with them.
std::vector<std::array<int, 4>> star_after(const Tetrahedralisation& mesh, const std::vector<int>& star,
                                           const SurfaceConstraints::Division& division) {
    std::vector<std::array<int, 4>> cells;
    for (const int c : star) {
        cells.push_back(mesh.cells[c].v);
    }
    for (const auto& t : division.parents) {
        cells.push_back({t[0], t[2], t[1], division.vertex});
    }
    return cells;
}

double worst_quality(const Tetrahedralisation& mesh, const std::vector<std::array<int, 4>>& cells) {
    double worst = 1.0;
    for (const auto& v : cells) {
        worst = std::min(worst, volume_quality(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])));
    }
    return worst;
}

}  // namespace

void move_divisions_inwards(Tetrahedralisation& mesh, const SurfaceConstraints& surface) {
    /// Halvings of the first step: down to what rounding leaves of it.
    constexpr int kHalvings = 40;
    std::vector<int> star;
    std::vector<int> created;
    const auto& divisions = surface.divisions();
    for (auto division = divisions.rbegin(); division != divisions.rend(); ++division) {
        const int v = division->vertex;
        Vec3 inwards = Vec3::Zero();
        double size = 0.0;
        for (const auto& t : division->parents) {
            const Vec3 normal = (mesh.point(t[1]) - mesh.point(t[0])).cross(mesh.point(t[2]) - mesh.point(t[0]));
            inwards -= normal.normalized();
            size = std::max(size, std::sqrt(normal.norm()));
        }
        inwards.normalize();
        mesh.star(v, star);
        const auto cells = star_after(mesh, star, *division);
        const Vec3 start = mesh.point(v);
        Vec3 best = start;
        double best_quality = 0.0;
        double step = size;
        for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
            mesh.move_point(v, start + step * inwards);
            const double quality = worst_quality(mesh, cells);
            if (quality > best_quality) {
                best_quality = quality;
                best = mesh.point(v);
            }
        }
        mesh.move_point(v, best);
        if (!(best_quality > 0.0)) {
            throw MeshingFailed("a point on the surface cannot be moved inwards");
        }
        mesh.replace(star, cells, created);
    }
}

}  // namespace mq::curve
