// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/opening_extension.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "base/vec.h"
#include "mesh/corner_table.h"

namespace mq::offset {

namespace {

using mesh::next_corner;
using mesh::previous_corner;

/// Length of the prisms, in thicknesses of the wall.
constexpr double kLength = 2.0;
/// Least distance between the solid and the faces that close the prisms, in thicknesses of the wall.
constexpr double kLeastReach = 1.1;
/// Largest height by which upright walls are extended, in thicknesses of the wall.
constexpr double kMostLift = 1.5;
/// Two normals are equal if their cosine differs from 1 by less than this.
constexpr double kSameDirection = 1e-9;
/// Threshold of the solver for leans: rims whose directions differ by less count as parallel.
constexpr double kParallel = 1e-8;
/// Largest distance by which a prism leans inward beside walls that rise, in widths of the gap to the wall.
constexpr double kMostLean = 4.0;
/// Least gap between a prism and a wall that rises from its rim, as a fraction of the gap that the prism's lean leaves.
constexpr double kLeastGap = 0.25;
/// Group number of the pieces between the prisms of several openings.
constexpr std::int32_t kBetween = -1;

/// Open triangles in one plane that are connected by edges.
struct Opening {
    std::vector<std::int32_t> triangles;
    std::int32_t direction = -1;
    Vec3 point = Vec3::Zero();
};

/// A convex piece of the volume that is added on openings.
struct Piece {
    std::int32_t group = -1;  ///< the opening that it stands on; its pieces are not compared with each other
    Vec3 up = Vec3::Zero();   ///< normal of the plane through `base` below which nothing reaches the piece
    Vec3 base = Vec3::Zero();
    std::vector<Vec3> points;
    Box box;
};

/// Whether the convex hulls of two sets of points are apart by `gap` along the normal of a face or of two edges.
bool are_apart(const std::vector<Vec3>& one, const std::vector<Vec3>& two, double gap) {
    std::vector<Vec3> edges;
    for (const std::vector<Vec3>& points : {one, two}) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                edges.push_back(points[i] - points[k]);
            }
        }
    }
    const auto along = [](const std::vector<Vec3>& points, const Vec3& axis) {
        std::array<double, 2> range{axis.dot(points[0]), axis.dot(points[0])};
        for (const Vec3& p : points) {
            range = {std::min(range[0], axis.dot(p)), std::max(range[1], axis.dot(p))};
        }
        return range;
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            Vec3 axis = edges[i].cross(edges[k]);
            const double length = axis.norm();
            if (length > kSameDirection * edges[i].norm() * edges[k].norm()) {
                axis /= length;
                const std::array<double, 2> its = along(one, axis);
                const std::array<double, 2> others = along(two, axis);
                if (std::max(others[0] - its[1], its[0] - others[1]) >= gap) {
                    return true;
                }
            }
        }
    }
    return false;
}

class OpeningExtension {
  public:
    OpeningExtension(const mesh::TriangleMesh& solid, const std::vector<char>& open, const ExtensionOptions& options)
        : solid_(solid),
          open_(open),
          options_(options),
          length_(kLength * options.thickness),
          slope_(std::sqrt(options.flatness / options.thickness)),
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
        if (!lean_from_walls()) {
            return std::nullopt;
        }
        move_openings();
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(twins_.size()); ++c) {
            if (is_open(c) && !add_side(c)) {
                return std::nullopt;
            }
        }
        if (!close_vertices() || !is_apart()) {
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

    /// Collects the opening of a triangle across its CAD faces. False if it is not plane.
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
    /// Sets how far prisms lean inward beside walls that rise from an opening, at any outward angle, so that a gap is
    /// left between prism and wall. False if a prism would have to lean farther than the gap is wide.
    bool lean_from_walls() {
        struct Rim {
            Vec3 inward;
            double lean;
        };
        std::map<std::array<std::int32_t, 2>, std::vector<Rim>> rims;  // by vertex and direction
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(twins_.size()); ++c) {
            if (!is_open(c) || is_open(twin(c))) {
                continue;
            }
            const Vec3& up = directions_[static_cast<std::size_t>(direction_at(c))];
            const Vec3& from = point(vertex(c));
            const Vec3 inward = up.cross(point(vertex(next_corner(c))) - from).normalized();
            const Vec3 wall = point(vertex(previous_corner(twin(c)))) - from;
            const double height = up.dot(wall);
            const bool rises = height > options_.flatness;
            for (const std::int32_t end : {c, next_corner(c)}) {
                rims[{vertex(end), direction_at(c)}].push_back({inward, rises ? slope_ * length_ : 0.0});
                rises_.insert(rises ? vertex(end) : -1);
            }
        }
        for (const auto& [at, edges] : rims) {
            Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
            Vec3 wanted = Vec3::Zero();
            for (const Rim& edge : edges) {
                squares += edge.inward * edge.inward.transpose();
                wanted += edge.lean * edge.inward;
            }
            if (wanted.isZero(0.0)) {
                continue;
            }
            Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> solver;
            solver.setThreshold(kParallel);
            const Vec3 lean = solver.compute(squares).solve(wanted);
            if (lean.norm() > kMostLean * slope_ * length_) {
                return false;
            }
            lean_[at] = lean;
        }
        return true;
    }
    const Vec3& point(std::int32_t vertex) const { return solid_.vertices[static_cast<std::size_t>(vertex)]; }

    /// Records a piece on an opening: the convex hull of points of the solid and the points raised from them.
    void add_piece(std::int32_t group, const Vec3& up, const std::vector<std::array<std::int32_t, 2>>& lines) {
        Piece piece;
        piece.group = group;
        piece.up = up;
        piece.base = point(lines[0][0]);
        const double begin = options_.flatness / length_;
        for (const auto& [base, raised] : lines) {
            const Vec3& end = result_.vertices[static_cast<std::size_t>(raised)];
            piece.points.push_back(point(base) + begin * (end - point(base)));
            piece.points.push_back(end);
        }
        for (const Vec3& p : piece.points) {
            piece.box.add(p);
        }
        pieces_.push_back(std::move(piece));
    }
    /// Whether the pieces on the openings are apart from the solid and from each other.
    bool is_apart() const {
        Box whole;
        for (const Piece& piece : pieces_) {
            whole.add(piece.box.low);
            whole.add(piece.box.high);
        }
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(open_.size()); ++t) {
            const std::array<Vec3, 3> p = corners(t);
            Box box;
            for (const Vec3& corner : p) {
                box.add(corner);
            }
            if (box.meets(whole) && std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
                    return box.meets(piece.box) && reaches(p, piece);
                })) {
                return false;
            }
        }
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                if (pieces_[i].group != pieces_[k].group && pieces_[i].box.meets(pieces_[k].box) &&
                    !are_apart(pieces_[i].points, pieces_[k].points, -options_.flatness)) {
                    return false;
                }
            }
        }
        return true;
    }
    bool reaches(const std::array<Vec3, 3>& triangle, const Piece& piece) const {
        const auto above = [&](std::size_t k) { return piece.up.dot(triangle[k] - piece.base) - options_.flatness; };
        std::vector<Vec3> part;  // the polygon that lies above the plane
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const double here = above(k);
            const double there = above(next);
            if (here > 0.0) {
                part.push_back(triangle[k]);
            }
            if ((here > 0.0) != (there > 0.0)) {
                part.emplace_back(triangle[k] + here / (here - there) * (triangle[next] - triangle[k]));
            }
        }
        return !part.empty() && !are_apart(part, piece.points, kLeastGap * slope_ * options_.flatness);
    }

    /// The vertex at the end of the prism above a corner of an opening.
    std::int32_t raised(std::int32_t corner) {
        const auto [at, fresh] = raised_.insert({{vertex(corner), direction_at(corner)}, -1});
        if (fresh) {
            at->second = static_cast<std::int32_t>(result_.vertices.size());
            result_.vertices.push_back(solid_.vertices[static_cast<std::size_t>(vertex(corner))] +
                                       length_ * directions_[static_cast<std::size_t>(direction_at(corner))] +
                                       lean_of(corner));
        }
        return at->second;
    }
    Vec3 lean_of(std::int32_t corner) const {
        const auto at = lean_.find({vertex(corner), direction_at(corner)});
        return at == lean_.end() ? Vec3::Zero() : at->second;
    }
    void move_openings() {
        for (std::size_t group = 0; group < openings_.size(); ++group) {
            for (const std::int32_t t : openings_[group].triangles) {
                std::vector<std::array<std::int32_t, 2>> lines;
                for (std::int32_t c = 3 * t; c < 3 * t + 3; ++c) {
                    lines.push_back({vertex(c), raised(c)});
                }
                add_piece(static_cast<std::int32_t>(group), normal(openings_[group]), lines);
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
    /// Adds the side of a prism at an edge of an opening, or the piece between two prisms. False if it is too near to
    /// the solid.
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
        if (from != its_from || to != its_to) {
            const std::int32_t begin = vertex(corner);
            const std::int32_t end = vertex(next_corner(corner));
            add_piece(kBetween, between({direction_at(corner), direction_at(other)}),
                      {{begin, from}, {begin, its_from}, {end, to}, {end, its_to}});
        }
        add({from, its_to, to}, face(corner / 3));
        add({from, its_from, its_to}, face(other / 3));
        return is_beyond_reach(vertex(corner), {from, its_from});
    }
    Vec3 between(const std::vector<std::int32_t>& directions) const {
        Vec3 sum = Vec3::Zero();
        for (const std::int32_t direction : directions) {
            sum += directions_[static_cast<std::size_t>(direction)];
        }
        return sum.normalized();
    }
    bool is_beyond_reach(std::int32_t vertex, const std::vector<std::int32_t>& raised) const {
        Vec3 middle = Vec3::Zero();
        for (const std::int32_t v : raised) {
            middle += result_.vertices[static_cast<std::size_t>(v)] / static_cast<double>(raised.size());
        }
        return (middle - solid_.vertices[static_cast<std::size_t>(vertex)]).norm() >= kLeastReach * options_.thickness;
    }

    /// Closes the surface around vertices in which openings of several planes meet.
    bool close_vertices() {
        std::vector<char> seen(twins_.size(), 0);
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(twins_.size()); ++c) {
            if (!is_open(c) || seen[static_cast<std::size_t>(c)] != 0) {
                continue;
            }
            // The first open triangle after a wall, clockwise around the vertex; any one if no wall is there.
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
            std::vector<std::int32_t> directions;
            std::int32_t corner = first;
            do {
                seen[static_cast<std::size_t>(corner)] = 1;
                if (above.empty() || above.back() != raised(corner)) {
                    above.push_back(raised(corner));
                    directions.push_back(direction_at(corner));
                }
                corner = twin(previous_corner(corner));
            } while (is_open(corner) && corner != first);
            if (!has_wall && above.size() > 1 && above.front() == above.back()) {
                above.pop_back();
                directions.pop_back();
            }
            if (above.size() > 2) {
                std::vector<std::array<std::int32_t, 2>> lines;
                for (const std::int32_t end : above) {
                    lines.push_back({vertex(c), end});
                }
                add_piece(kBetween, between(directions), lines);
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

    /// Moves the vertices of rims along their walls, as far as the planes of the walls move by less than the flatness.
    void lift_walls() {
        constexpr std::int32_t kNoDirection = -1;
        constexpr std::int32_t kSeveral = -2;
        const auto count = static_cast<std::int32_t>(twins_.size());
        std::vector<std::int32_t> along(solid_.vertices.size(), kNoDirection);  // directions
        std::vector<double> lift(solid_.vertices.size(), kMostLift * options_.thickness);
        for (std::int32_t c = 0; c < count; ++c) {
            if (is_open(c)) {
                std::int32_t& its = along[static_cast<std::size_t>(vertex(c))];
                its = its == kNoDirection || its == direction_at(c) ? direction_at(c) : kSeveral;
            }
        }
        for (std::int32_t c = 0; c < count; ++c) {
            const auto v = static_cast<std::size_t>(vertex(c));
            if (rises_.count(vertex(c)) != 0) {
                along[v] = kSeveral;
            }
            if (!is_open(c) && along[v] >= 0) {
                const std::array<Vec3, 3> p = corners(c / 3);
                const Vec3 wall = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
                const double slope = std::abs(wall.dot(directions_[static_cast<std::size_t>(along[v])]));
                lift[v] = lift[v] * slope <= options_.flatness ? lift[v] : options_.flatness / slope;
            }
        }
        std::vector<Vec3> shift(along.size(), Vec3::Zero());
        for (std::size_t v = 0; v < along.size(); ++v) {
            if (along[v] >= 0) {
                shift[v] = lift[v] * directions_[static_cast<std::size_t>(along[v])];
            }
        }
        keep_turned_triangles(shift);
        for (std::size_t v = 0; v < shift.size(); ++v) {
            result_.vertices[v] += shift[v];
        }
    }

    /// Leaves the vertices of a wall's triangle where they are if their shifts would turn it over, as beside a vertex
    /// that stays.
    void keep_turned_triangles(std::vector<Vec3>& shift) const {
        const auto shifted = [&](std::int32_t v) { return Vec3(point(v) + shift[static_cast<std::size_t>(v)]); };
        const auto moves = [&](std::int32_t v) { return !shift[static_cast<std::size_t>(v)].isZero(0.0); };
        for (bool again = true; again;) {
            again = false;
            for (std::int32_t t = 0; t < static_cast<std::int32_t>(open_.size()); ++t) {
                const mesh::Triangle& c = solid_.triangles[static_cast<std::size_t>(t)];
                if (is_open(3 * t) || std::none_of(c.begin(), c.end(), moves)) {
                    continue;
                }
                const Vec3 before = (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0]));
                const Vec3 after = (shifted(c[1]) - shifted(c[0])).cross(shifted(c[2]) - shifted(c[0]));
                if (!(before.dot(after) > 0.0)) {
                    for (const std::int32_t v : c) {
                        shift[static_cast<std::size_t>(v)].setZero();
                    }
                    again = true;
                }
            }
        }
    }

    const mesh::TriangleMesh& solid_;
    const std::vector<char>& open_;
    const ExtensionOptions options_;
    const double length_;  ///< mm, of the prisms
    const double slope_;   ///< rise per length of a prism's side beside a wall that rises
    const std::vector<std::int32_t> twins_;
    std::vector<std::int32_t> opening_of_;  ///< by triangle; -1: a wall
    std::vector<Opening> openings_;
    std::vector<Vec3> directions_;
    std::map<std::array<std::int32_t, 2>, Vec3> lean_;            ///< mm, of prisms; by vertex and direction
    std::map<std::array<std::int32_t, 2>, std::int32_t> raised_;  ///< by vertex and direction
    std::set<std::int32_t> rises_;                                ///< vertices from which walls rise
    std::vector<Piece> pieces_;
    mesh::TriangleMesh result_;
};

}  // namespace

std::optional<mesh::TriangleMesh> extend_openings(const mesh::TriangleMesh& solid, const std::vector<char>& open,
                                                  const ExtensionOptions& options) {
    return OpeningExtension(solid, open, options).run();
}

}  // namespace mq::offset
