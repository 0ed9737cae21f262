// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/contour.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "layered_depth/reconstruction/border_stitching.h"

namespace mq::layered_depth {

namespace {

/// Rows of rays whose faces one thread finds at a time.
constexpr int kRowsAtATime = 32;

/// A face around an edge of the octree: the sheets of the leaves around it, in the order of its corners.
struct SheetFace {
    std::array<std::int32_t, 4> sheets;
    std::int32_t source;
};

class Contourer {
  public:
    Contourer(const OperandSet& pair, const Octree& tree, const SampleGrid& grid, const CombinedSet& combined,
              const std::vector<Retention>& fate, std::vector<std::int32_t>& vertices, RetainedSurface& surface)
        : pair_(pair),
          tree_(tree),
          grid_(grid),
          combined_(combined),
          fate_(fate),
          vertices_(vertices),
          surface_(surface) {}

    ContouredSurface run(const Progress* progress);

  private:
    void note_border();
    std::vector<SheetFace> find_faces(int axis, int first_row, const Progress* progress) const;
    std::optional<SheetFace> find_face(int axis, std::size_t ray, std::uint32_t sample) const;
    void make_face(const SheetFace& face);
    bool reconstructed(const CombinedDepth& direction, std::uint32_t i) const {
        return fate_[CombinedDepth::triangle(direction.source[i])] == Retention::Removed;
    }
    static int interval(double depth) { return static_cast<int>(std::ceil(depth)) - 1; }
    bool inside(const std::array<int, 3>& node) const {
        return combined_[0].inside(static_cast<std::size_t>(node[2]) * grid_.rays() + node[1], node[0]);
    }
    std::int32_t vertex_of(std::int32_t sheet);
    void add_polygon(const std::array<std::int32_t, 4>& corners, int count, const Vec3& normal);
    void add_triangle(const mesh::Triangle& t);
    bool first_diagonal(const std::array<std::int32_t, 4>& c, const Vec3& normal) const;
    Vec3 normal_of(std::int32_t source) const;

    const OperandSet& pair_;
    const Octree& tree_;
    const SampleGrid& grid_;
    const CombinedSet& combined_;
    const std::vector<Retention>& fate_;
    std::vector<std::int32_t>& vertices_;
    RetainedSurface& surface_;
    ContouredSurface result_;
};

/// Records the border edges: an edge of a new triangle may be an edge of a retained one only between border vertices.
void Contourer::note_border() {
    for (const mesh::Triangle& t : surface_.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::int32_t from = t[i], to = t[i == 2 ? 0 : i + 1];
            if (surface_.on_border[from] != 0 && surface_.on_border[to] != 0) {
                result_.edges.add(from, to);
            }
        }
    }
}

std::int32_t Contourer::vertex_of(std::int32_t sheet) {
    std::int32_t& vertex = vertices_[sheet];
    if (vertex < 0) {
        vertex = static_cast<std::int32_t>(surface_.points.size());
        surface_.points.push_back(to_single(grid_.to_space(tree_.sheets[sheet].minimiser)));
    }
    return vertex;
}

/// The outward normal of a source triangle, not of unit length.
Vec3 Contourer::normal_of(std::int32_t source) const {
    const auto& [a, b, c] = pair_.triangles[CombinedDepth::triangle(source)];
    const Vec3 normal = (pair_.points[b] - pair_.points[a]).cross(pair_.points[c] - pair_.points[a]);
    return CombinedDepth::reversed(source) ? Vec3(-normal) : normal;
}

void Contourer::add_triangle(const mesh::Triangle& t) {
    if (mesh::is_collapsed(t)) {
        return;
    }
    if (!result_.edges.admits(t)) {
        ++result_.refused;
        return;
    }
    result_.edges.add(t);
    result_.triangles.push_back(t);
}

/// Whether a quadrilateral is divided along the diagonal from corner 0 to 2 rather than from 1 to 3. The diagonal is
/// chosen whose worse triangle has more area in projection along the sample's normal; never an edge in use.
bool Contourer::first_diagonal(const std::array<std::int32_t, 4>& c, const Vec3& normal) const {
    const auto used = [&](int i, int j) { return result_.edges.has(c[i], c[j]) || result_.edges.has(c[j], c[i]); };
    const bool used_first = used(0, 2), used_second = used(1, 3);
    if (used_first != used_second) {
        return used_second;
    }
    const auto area = [&](int i, int j, int k) {
        const Vec3& p = surface_.points[c[i]];
        return (surface_.points[c[j]] - p).cross(surface_.points[c[k]] - p).dot(normal);
    };
    return std::min(area(0, 1, 2), area(0, 2, 3)) >= std::min(area(0, 1, 3), area(1, 2, 3));
}

void Contourer::add_polygon(const std::array<std::int32_t, 4>& corners, int count, const Vec3& normal) {
    if (count == 3) {
        add_triangle({corners[0], corners[1], corners[2]});
    } else if (first_diagonal(corners, normal)) {
        add_triangle({corners[0], corners[1], corners[2]});
        add_triangle({corners[0], corners[2], corners[3]});
    } else {
        add_triangle({corners[0], corners[1], corners[3]});
        add_triangle({corners[1], corners[2], corners[3]});
    }
}

/// The face that a sample stands for; none if another sample stands for it, or if the surface does not pass there.
std::optional<SheetFace> Contourer::find_face(int axis, std::size_t ray, std::uint32_t sample) const {
    const CombinedDepth& direction = combined_[axis];
    const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    std::array<int, 3> at{};
    at[axis] = interval(direction.depth[sample]);
    at[u_axis] = static_cast<int>(ray % grid_.rays());
    at[v_axis] = static_cast<int>(ray / grid_.rays());
    // The four cells around a minimal edge, counter-clockwise as seen from the far end of the ray.
    constexpr std::array<std::array<int, 2>, 4> kAround{{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    std::array<std::int32_t, 4> leaves{};
    int size = grid_.cells();
    for (int k = 0; k < 4; ++k) {
        std::array<int, 3> cell = at;
        cell[u_axis] += kAround[k][0];
        cell[v_axis] += kAround[k][1];
        leaves[k] = tree_.leaf_at(cell[0], cell[1], cell[2]);
        if (leaves[k] < 0) {
            return std::nullopt;
        }
        size = std::min<int>(size, tree_.leaves[leaves[k]].size);
    }
    if (at[u_axis] % size != 0 || at[v_axis] % size != 0) {
        return std::nullopt;  // inside of a cell or of a face
    }
    std::array<int, 3> low = at, high = at;
    low[axis] = at[axis] / size * size;
    high[axis] = low[axis] + size;
    for (std::uint32_t i = sample; i > direction.begin[ray] && interval(direction.depth[i - 1]) >= low[axis]; --i) {
        if (reconstructed(direction, i - 1)) {
            return std::nullopt;  // the other sample stands for the face
        }
    }
    const bool leaves_solid = inside(low);
    if (leaves_solid == inside(high)) {
        return std::nullopt;
    }
    SheetFace face{{}, direction.source[sample]};
    for (int k = 0; k < 4; ++k) {
        const int around = leaves_solid ? k : 3 - k;
        const Leaf& leaf = tree_.leaves[leaves[around]];
        // A cell on the lower side on an axis has the ray on its upper side.
        const int edge = 4 * axis - kAround[around][0] - 2 * kAround[around][1];
        face.sheets[k] = leaf.first_sheet + (leaf.size > 1 ? 0 : leaf.sheet_of_edge[edge]);
    }
    return face;
}

void Contourer::make_face(const SheetFace& face) {
    std::array<std::int32_t, 4> corners{};
    int count = 0;
    for (const std::int32_t sheet : face.sheets) {
        const std::int32_t vertex = vertex_of(sheet);
        if (count == 0 || (vertex != corners[count - 1] && vertex != corners[0])) {
            corners[count++] = vertex;
        }
    }
    if (count >= 3) {
        add_polygon(corners, count, normal_of(face.source));
    }
}

std::vector<SheetFace> Contourer::find_faces(int axis, int first_row, const Progress* progress) const {
    const CombinedDepth& direction = combined_[axis];
    const auto rays = static_cast<std::size_t>(grid_.rays());
    const std::size_t end = static_cast<std::size_t>(std::min(first_row + kRowsAtATime, grid_.rays())) * rays;
    std::vector<SheetFace> faces;
    check_cancelled(progress);
    for (std::size_t ray = static_cast<std::size_t>(first_row) * rays; ray < end; ++ray) {
        for (std::uint32_t i = direction.begin[ray]; i < direction.begin[ray + 1]; ++i) {
            if (!reconstructed(direction, i)) {
                continue;
            }
            if (const std::optional<SheetFace> face = find_face(axis, ray, i)) {
                faces.push_back(*face);
            }
        }
    }
    return faces;
}

ContouredSurface Contourer::run(const Progress* progress) {
    note_border();
    const int per_axis = (grid_.rays() + kRowsAtATime - 1) / kRowsAtATime;
    std::vector<std::vector<SheetFace>> parts(3 * static_cast<std::size_t>(per_axis));
    parallel_for(static_cast<int>(parts.size()), [&](int k) {
        parts[static_cast<std::size_t>(k)] = find_faces(k / per_axis, k % per_axis * kRowsAtATime, progress);
    });
    for (const std::vector<SheetFace>& faces : parts) {
        check_cancelled(progress);
        for (const SheetFace& face : faces) {
            make_face(face);
        }
    }
    surface_.on_border.resize(surface_.points.size(), 0);
    result_.vertices = std::move(vertices_);
    return std::move(result_);
}

}  // namespace

ContouredSurface contour(const OperandSet& pair, const Octree& tree, const SampleGrid& grid,
                         const CombinedSet& combined, const std::vector<Retention>& fate,
                         std::vector<std::int32_t> vertices, RetainedSurface& surface, const Progress* progress) {
    return Contourer(pair, tree, grid, combined, fate, vertices, surface).run(progress);
}

}  // namespace mq::layered_depth
