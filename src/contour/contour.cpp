// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/contour.h"

#include <cstddef>
#include <utility>

#include "base/key_set.h"
#include "base/parallel.h"
#include "contour/cell_surface.h"

namespace mq::contour {

namespace {

class ContourBuilder {
  public:
    ContourBuilder(const CrossedCells& cells, bool has_level_set) : cells_(cells), has_level_set_(has_level_set) {}

    Contour run(const std::vector<CellSurface>& surfaces) {
        for (const Crossing& crossing : cells_.crossings) {
            result_.points.push_back(crossing.point);
        }
        for (std::size_t k = 0; k < surfaces.size(); ++k) {
            uses_own_plane_ = has_level_set_ && !surfaces[k].is_sharp;
            if (surfaces[k].is_cone) {
                add_cone(cells_.cells[k], surfaces[k]);
            } else {
                add_fan(cells_.cells[k], surfaces[k].first);
            }
        }
        for (Vec3& p : result_.points) {
            p = to_single(p);
        }
        return std::move(result_);
    }

  private:
    static std::int32_t crossing(const CrossedCell& cell, int k) {
        return cell.crossings[static_cast<std::size_t>(k % cell.polygon.count)];
    }
    const Crossing& at(std::int32_t crossing) const { return cells_.crossings[static_cast<std::size_t>(crossing)]; }

    void add_triangle(const mesh::Triangle& triangle, std::int32_t plane) {
        result_.triangles.push_back(triangle);
        result_.source.push_back(plane < 0 ? -1 : at(plane).source);
        result_.patch.push_back(plane < 0 ? -1 : at(plane).patch);
        result_.plane.push_back(uses_own_plane_ ? -1 : plane);
    }

    void add_fan(const CrossedCell& cell, int first) {
        std::int32_t plane = crossing(cell, first);
        for (int k = 0; k < cell.polygon.count; ++k) {
            plane = at(crossing(cell, k)).source < 0 ? -1 : plane;
        }
        for (int k = 1; k + 1 < cell.polygon.count; ++k) {
            add_triangle({crossing(cell, first), crossing(cell, first + k), crossing(cell, first + k + 1)}, plane);
        }
    }

    void add_cone(const CrossedCell& cell, const CellSurface& surface) {
        const auto apex = static_cast<std::int32_t>(result_.points.size());
        result_.points.push_back(surface.apex);
        for (int k = 0; k < cell.polygon.count; ++k) {
            const std::int32_t from = crossing(cell, k);
            const std::int32_t to = crossing(cell, k + 1);
            const std::int32_t from_plane = at(from).source < 0 ? -1 : from;
            const std::int32_t to_plane = at(to).source < 0 ? -1 : to;
            const auto slot = static_cast<std::size_t>(k);
            if (surface.has_face_point[slot]) {
                const std::int32_t between = on_face(from, to, surface.face_points[slot]);
                add_triangle({apex, from, between}, from_plane);
                add_triangle({apex, between, to}, to_plane);
            } else {
                add_triangle({apex, from, to}, to_plane < 0 ? -1 : from_plane);
            }
        }
    }

    /// The vertex on a face, which both cells of the face share.
    std::int32_t on_face(std::int32_t from, std::int32_t to, const Vec3& point) {
        const auto [at, is_new] =
            on_face_.insert({pair_key(from, to), static_cast<std::int32_t>(result_.points.size())});
        if (is_new) {
            result_.points.push_back(point);
        }
        return at->second;
    }

    const CrossedCells& cells_;
    const bool has_level_set_;
    bool uses_own_plane_ = false;
    KeyMap<std::int32_t> on_face_;
    Contour result_;
};

}  // namespace

void remove_gone(Contour& surface) {
    std::vector<std::int32_t> index(surface.points.size(), -1);
    for (const mesh::Triangle& c : surface.triangles) {
        for (const std::int32_t v : c) {
            if (v >= 0) {
                index[v] = 0;
            }
        }
    }
    std::size_t count = 0;
    for (std::size_t v = 0; v < surface.points.size(); ++v) {
        if (index[v] == 0) {
            index[v] = static_cast<std::int32_t>(count);
            surface.points[count++] = surface.points[v];
        }
    }
    surface.points.resize(count);
    std::size_t left = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const mesh::Triangle c = surface.triangles[t];
        if (c[0] >= 0) {
            surface.triangles[left] = {index[c[0]], index[c[1]], index[c[2]]};
            surface.source[left] = surface.source[t];
            surface.patch[left] = surface.patch[t];
            surface.plane[left] = surface.plane[t];
            if (!surface.kept.empty()) {
                std::swap(surface.kept[left], surface.kept[t]);
            }
            ++left;
        }
    }
    surface.triangles.resize(left);
    surface.source.resize(left);
    surface.patch.resize(left);
    surface.plane.resize(left);
    surface.kept.resize(surface.kept.empty() ? 0 : left);
}

Contour contour(const CrossedCells& cells, const LevelSet* level_set, const Progress& progress) {
    std::vector<CellSurface> surfaces(cells.cells.size());
    for_chunks(static_cast<int>(surfaces.size()), [&](int k) {
        progress.check();
        const auto cell = static_cast<std::size_t>(k);
        surfaces[cell] = cell_surface(cells.cells[cell], cells.crossings, level_set);
    });
    return ContourBuilder(cells, level_set != nullptr).run(surfaces);
}

}  // namespace mq::contour
