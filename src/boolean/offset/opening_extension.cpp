// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/offset/opening_extension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "base/vec.h"
#include "mesh/corner_table.h"

namespace mq::boolean {

namespace {

using mesh::next_corner;
using mesh::previous_corner;

/// Length of the prisms, in thicknesses.
constexpr double kLength = 2.0;
/// Least distance between the solid and what closes prisms, in thicknesses.
constexpr double kLeastReach = 1.1;
/// How far upright walls go on at most, in thicknesses.
constexpr double kMostLift = 1.5;
/// Normals whose cosine differs from 1 by less are the same.
constexpr double kSameDirection = 1e-9;

/// Open triangles in one plane that hang together by edges.
struct Opening {
    std::vector<std::int32_t> triangles;
    std::int32_t direction = -1;
    Vec3 point = Vec3::Zero();
};

class OpeningExtension {
  public:
    OpeningExtension(const mesh::TriangleMesh& solid, const std::vector<char>& open, const ExtensionOptions& options)
        : solid_(solid),
          open_(open),
          options_(options),
          length_(kLength * options.thickness),
          twins_(mesh::edge_twins(solid.triangles, solid.vertices.size())),
          opening_of_(solid.triangles.size(), -1),
          result_(solid) {}

    std::optional<mesh::TriangleMesh> run() {
        if (std::any_of(twins_.begin(), twins_.end(), [](std::int32_t twin) { return twin < 0; })) {
            return std::nullopt;
        }
        for (std::size_t t = 0; t < open_.size(); ++t) {
            if (open_[t] != 0 && opening_of_[t] < 0 && !find_opening(static_cast<std::int32_t>(t))) {
                return std::nullopt;
            }
        }
        for (const Opening& opening : openings_) {
            if (rises_above(opening)) {
                return std::nullopt;
            }
        }
        move_openings();
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(twins_.size()); ++c) {
            if (is_open(c) && !add_side(c)) {
                return std::nullopt;
            }
        }
        if (!close_vertices()) {
            return std::nullopt;
        }
        lift_walls();
        return std::move(result_);
    }

  private:
    bool is_open(std::int32_t corner) const { return open_[static_cast<std::size_t>(corner / 3)] != 0; }
    std::int32_t twin(std::int32_t corner) const { return twins_[static_cast<std::size_t>(corner)]; }
    std::int32_t vertex(std::int32_t corner) const {
        return solid_.triangles[static_cast<std::size_t>(corner / 3)][static_cast<std::size_t>(corner % 3)];
    }
    std::array<Vec3, 3> corners(std::int32_t t) const {
        const mesh::Triangle& c = solid_.triangles[static_cast<std::size_t>(t)];
        const auto& p = solid_.vertices;
        return {p[static_cast<std::size_t>(c[0])], p[static_cast<std::size_t>(c[1])],
                p[static_cast<std::size_t>(c[2])]};
    }
    std::int32_t face(std::int32_t t) const {
        return solid_.triangle_face.empty() ? -1 : solid_.triangle_face[static_cast<std::size_t>(t)];
    }
    std::int32_t direction_at(std::int32_t corner) const {
        return openings_[static_cast<std::size_t>(opening_of_[static_cast<std::size_t>(corner / 3)])].direction;
    }

    /// Collects the opening that a triangle belongs to, by CAD faces; false where it is not plane.
    bool find_opening(std::int32_t first) {
        Opening opening;
        const auto number = static_cast<std::int32_t>(openings_.size());
        opening.triangles.push_back(first);
        opening_of_[static_cast<std::size_t>(first)] = number;
        Vec3 normal = Vec3::Zero();
        for (std::size_t k = 0; k < opening.triangles.size(); ++k) {
            const std::int32_t t = opening.triangles[k];
            const std::array<Vec3, 3> p = corners(t);
            normal += (p[1] - p[0]).cross(p[2] - p[0]);
            for (std::int32_t c = 3 * t; c < 3 * t + 3; ++c) {
                const std::int32_t other = twin(c) / 3;
                std::int32_t& its = opening_of_[static_cast<std::size_t>(other)];
                if (is_open(twin(c)) && its < 0 && face(other) == face(t)) {
                    its = number;
                    opening.triangles.push_back(other);
                }
            }
        }
        normal.normalize();
        opening.point = corners(first)[0];
        for (const std::int32_t t : opening.triangles) {
            for (const Vec3& p : corners(t)) {
                if (!(std::abs(normal.dot(p - opening.point)) <= options_.flatness)) {
                    return false;
                }
            }
        }
        const auto same = [&](const Vec3& other) { return 1.0 - other.dot(normal) < kSameDirection; };
        const auto at = std::find_if(directions_.begin(), directions_.end(), same);
        opening.direction = static_cast<std::int32_t>(at - directions_.begin());
        if (at == directions_.end()) {
            directions_.push_back(normal);
        }
        openings_.push_back(std::move(opening));
        return true;
    }

    const Vec3& normal(const Opening& opening) const {
        return directions_[static_cast<std::size_t>(opening.direction)];
    }
    /// The box of the prism on a triangle, and of all that is near to it.
    Box prism_box(const Opening& opening, std::int32_t t, double margin) const {
        Box box;
        for (const Vec3& p : corners(t)) {
            box.add(p);
            box.add(p + length_ * normal(opening));
        }
        box.low.array() -= margin;
        box.high.array() += margin;
        return box;
    }
    /// Whether some triangle above the plane of an opening is near to its prism; one of another opening, whose prism
    /// could reach it.
    bool rises_above(const Opening& opening) const {
        Box whole;
        for (const std::int32_t t : opening.triangles) {
            const Box box = prism_box(opening, t, length_ + options_.thickness);
            whole.add(box.low);
            whole.add(box.high);
        }
        for (std::size_t t = 0; t < open_.size(); ++t) {
            const std::array<Vec3, 3> p = corners(static_cast<std::int32_t>(t));
            Box box;
            double height = 0.0;
            for (const Vec3& corner : p) {
                box.add(corner);
                height = std::max(height, normal(opening).dot(corner - opening.point));
            }
            const double margin = options_.thickness + (open_[t] != 0 ? length_ : 0.0);
            if (height > options_.flatness && box.meets(whole) &&
                std::any_of(opening.triangles.begin(), opening.triangles.end(),
                            [&](std::int32_t own) { return box.meets(prism_box(opening, own, margin)); })) {
                return true;
            }
        }
        return false;
    }

    /// The vertex at the end of the prism above a corner of an opening.
    std::int32_t raised(std::int32_t corner) {
        const auto [at, fresh] = raised_.insert({{vertex(corner), direction_at(corner)}, -1});
        if (fresh) {
            at->second = static_cast<std::int32_t>(result_.vertices.size());
            result_.vertices.push_back(solid_.vertices[static_cast<std::size_t>(vertex(corner))] +
                                       length_ * directions_[static_cast<std::size_t>(direction_at(corner))]);
        }
        return at->second;
    }
    void move_openings() {
        for (const Opening& opening : openings_) {
            for (const std::int32_t t : opening.triangles) {
                for (std::int32_t k = 0; k < 3; ++k) {
                    result_.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)] = raised(3 * t + k);
                }
            }
        }
    }
    void add(const mesh::Triangle& triangle, std::int32_t its_face) {
        if (!mesh::is_collapsed(triangle)) {
            result_.triangles.push_back(triangle);
            if (!result_.triangle_face.empty()) {
                result_.triangle_face.push_back(its_face);
            }
        }
    }
    /// The side of a prism at an edge of an opening, or what is between two prisms; false where that is too near.
    bool add_side(std::int32_t corner) {
        const std::int32_t other = twin(corner);
        const std::int32_t from = raised(corner);
        const std::int32_t to = raised(next_corner(corner));
        if (!is_open(other)) {
            add({vertex(corner), vertex(next_corner(corner)), to}, face(other / 3));
            add({vertex(corner), to, from}, face(other / 3));
            return true;
        }
        if (corner > other) {
            return true;
        }
        const std::int32_t its_from = raised(next_corner(other));
        const std::int32_t its_to = raised(other);
        add({from, its_to, to}, face(corner / 3));
        add({from, its_from, its_to}, face(other / 3));
        return is_beyond_reach(vertex(corner), {from, its_from});
    }
    bool is_beyond_reach(std::int32_t vertex, const std::vector<std::int32_t>& raised) const {
        Vec3 middle = Vec3::Zero();
        for (const std::int32_t v : raised) {
            middle += result_.vertices[static_cast<std::size_t>(v)] / static_cast<double>(raised.size());
        }
        return (middle - solid_.vertices[static_cast<std::size_t>(vertex)]).norm() >= kLeastReach * options_.thickness;
    }

    /// Closes what is left around vertices where openings in several planes meet.
    bool close_vertices() {
        std::vector<char> seen(twins_.size(), 0);
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(twins_.size()); ++c) {
            if (!is_open(c) || seen[static_cast<std::size_t>(c)] != 0) {
                continue;
            }
            // The first open triangle after a wall, where there is a wall; clockwise around the vertex.
            std::int32_t first = c;
            bool has_wall = false;
            for (std::int32_t before = next_corner(twin(first)); true; before = next_corner(twin(first))) {
                has_wall = !is_open(before);
                if (has_wall || before == c) {
                    break;
                }
                first = before;
            }
            first = has_wall ? first : c;
            std::vector<std::int32_t> above;
            std::int32_t corner = first;
            do {
                seen[static_cast<std::size_t>(corner)] = 1;
                if (above.empty() || above.back() != raised(corner)) {
                    above.push_back(raised(corner));
                }
                corner = twin(previous_corner(corner));
            } while (is_open(corner) && corner != first);
            if (!has_wall && above.size() > 1 && above.front() == above.back()) {
                above.pop_back();
            }
            if (!close(vertex(c), above, has_wall, face(c / 3))) {
                return false;
            }
        }
        return true;
    }
    bool close(std::int32_t base, const std::vector<std::int32_t>& above, bool has_wall, std::int32_t its_face) {
        if (has_wall) {
            for (std::size_t k = 1; k < above.size(); ++k) {
                add({base, above[k - 1], above[k]}, its_face);
            }
            return true;
        }
        for (std::size_t k = 2; k < above.size(); ++k) {
            add({above[0], above[k - 1], above[k]}, its_face);
        }
        return above.size() < 3 || is_beyond_reach(base, above);
    }

    /// Moves vertices of rims along the walls there, as far as the planes of these move by less than the flatness.
    void lift_walls() {
        constexpr std::int32_t kNone = -1;
        constexpr std::int32_t kSeveral = -2;
        const auto count = static_cast<std::int32_t>(twins_.size());
        std::vector<std::int32_t> along(solid_.vertices.size(), kNone);  // directions
        std::vector<double> lift(solid_.vertices.size(), kMostLift * options_.thickness);
        for (std::int32_t c = 0; c < count; ++c) {
            if (is_open(c)) {
                std::int32_t& its = along[static_cast<std::size_t>(vertex(c))];
                its = its == kNone || its == direction_at(c) ? direction_at(c) : kSeveral;
            }
        }
        for (std::int32_t c = 0; c < count; ++c) {
            const auto v = static_cast<std::size_t>(vertex(c));
            if (!is_open(c) && along[v] >= 0) {
                const std::array<Vec3, 3> p = corners(c / 3);
                const Vec3 wall = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
                const double slope = std::abs(wall.dot(directions_[static_cast<std::size_t>(along[v])]));
                lift[v] = lift[v] * slope <= options_.flatness ? lift[v] : options_.flatness / slope;
            }
        }
        for (std::size_t v = 0; v < along.size(); ++v) {
            if (along[v] >= 0) {
                result_.vertices[v] += lift[v] * directions_[static_cast<std::size_t>(along[v])];
            }
        }
    }

    const mesh::TriangleMesh& solid_;
    const std::vector<char>& open_;
    const ExtensionOptions options_;
    const double length_;  ///< mm, of the prisms
    const std::vector<std::int32_t> twins_;
    std::vector<std::int32_t> opening_of_;  ///< by triangle; -1: a wall
    std::vector<Opening> openings_;
    std::vector<Vec3> directions_;
    std::map<std::array<std::int32_t, 2>, std::int32_t> raised_;  ///< by vertex and direction
    mesh::TriangleMesh result_;
};

}  // namespace

std::optional<mesh::TriangleMesh> extend_openings(const mesh::TriangleMesh& solid, const std::vector<char>& open,
                                                  const ExtensionOptions& options) {
    return OpeningExtension(solid, open, options).run();
}

}  // namespace mq::boolean
