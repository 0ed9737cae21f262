// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/output/tessellation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/key_set.h"
#include "base/segment_distance.h"
#include "base/single_precision_grid.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/curved_shapes.h"
#include "elements/bezier/sub_simplex.h"
#include "elements/product/reference_nodes.h"

namespace mq::curve {

using elements::Barycentric;
using elements::Exponents;
using elements::Lattice;
using elements::value;

namespace {

/// Halvings of one curved edge at most: the control polygon comes four times nearer with each halving, so that single
/// precision is reached before.
constexpr int kDeepest = 20;
/// Fraction of the tolerance for edges: inside a patch that is curved alike in all directions the middle deviates 4/3
/// times as much as the middles of its edges.
constexpr double kEdgePart = 0.7;

double distance_to_triangle(const Vec3& p, const std::array<Vec3, 3>& c) {
    const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
    bool inside = normal.squaredNorm() > 0.0;
    double nearest = 1e300;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = c[k];
        const Vec3& b = c[(k + 1) % 3];
        inside = inside && normal.dot((b - a).cross(p - a)) >= 0.0;
        nearest = std::min(nearest, distance_to_segment(p, a, b));
    }
    return inside ? std::abs(normal.dot(p - c[0])) / normal.norm() : nearest;
}

/// The largest distance of a curve from its chord: the distance from the chord is convex, so that it is at most the
/// mean of the control points' distances with the Bernstein polynomials as weights; the ends' are zero.
double bend(const std::vector<Vec3>& control) {
    double most = 0.0;
    for (std::size_t i = 1; i + 1 < control.size(); ++i) {
        most = std::max(most, distance_to_segment(control[i], control.front(), control.back()));
    }
    return most * (1.0 - std::pow(0.5, static_cast<double>(control.size()) - 2.0));
}

/// The largest distance of a patch from its flat triangle.
double bend(const Lattice& lattice, const std::vector<Vec3>& control) {
    std::array<Vec3, 3> corners;
    for (int k = 0; k < 3; ++k) {
        corners[static_cast<std::size_t>(k)] = control[static_cast<std::size_t>(lattice.corner(k))];
    }
    double most = 0.0;
    for (int i = 0; i < lattice.size(); ++i) {
        if (lattice.carriers(i) > 1) {
            most = std::max(most, distance_to_triangle(control[static_cast<std::size_t>(i)], corners));
        }
    }
    return most * (1.0 - std::pow(3.0, 1.0 - static_cast<double>(lattice.degree())));
}

using Arguments = std::array<const Barycentric*, elements::kMaxOrder>;

/// The polar form of a patch at `order` points: control points of its pieces (Farin 1993).
Vec3 polar(const Lattice& lattice, const std::vector<Vec3>& control, const Arguments& at) {
    std::array<Vec3, 21> points;  // enough for a triangle of order kMaxOrder
    std::copy(control.begin(), control.end(), points.begin());
    const Lattice* above = &lattice;
    for (int degree = lattice.degree() - 1; degree >= 0; --degree) {
        const Lattice& here = Lattice::of(2, degree);
        const Barycentric& b = *at[static_cast<std::size_t>(degree)];
        // Point i of the lower lattice needs only points i and later of the upper one: the computation is in place.
        for (int i = 0; i < here.size(); ++i) {
            const Exponents& e = here.exponents(i);
            points[static_cast<std::size_t>(i)] =
                b[0] * points[static_cast<std::size_t>(above->index({e[0] + 1, e[1], e[2], 0}))] +
                b[1] * points[static_cast<std::size_t>(above->index({e[0], e[1] + 1, e[2], 0}))] +
                b[2] * points[static_cast<std::size_t>(above->index({e[0], e[1], e[2] + 1, 0}))];
        }
        above = &here;
    }
    return points[0];
}

/// Whether both points lie on one side of the curved triangle. Coordinates of 0 stay exactly 0 when edges are halved
/// and centroids are taken.
bool on_side(const Barycentric& a, const Barycentric& b) {
    return (a[0] == 0.0 && b[0] == 0.0) || (a[1] == 0.0 && b[1] == 0.0) || (a[2] == 0.0 && b[2] == 0.0);
}

Box box_of(const CurvedMesh& mesh) {
    Box box;
    for (const Vec3& p : mesh.nodes) {
        box.add(p);
    }
    return box;
}

/// A flat triangle that may be divided further, and the places of its corners in the curved one.
struct Piece {
    std::array<std::int32_t, 3> corners;
    std::array<Barycentric, 3> at;
    int depth = 0;
};

class Tessellator {
  public:
    Tessellator(const CurvedMesh& mesh, double deviation, const Progress* progress, std::size_t max_triangles)
        : mesh_(mesh),
          lattice_(Lattice::of(2, mesh.order)),
          order_(elements::gmsh_order(lattice_)),
          grid_(box_of(mesh)),
          pace_(progress),
          max_triangles_(max_triangles) {
        if (deviation > 0.0 && deviation < 4.0 * grid_.resolution()) {
            throw InvalidInput(phrases::kFineDeviation,
                               {{"length", in_mm(deviation)}, {"length2", in_mm(4.0 * grid_.resolution())}});
        }
        const double asked = deviation > 0.0 ? deviation : 1e-3 * box_of(mesh).largest_side();
        result_.deviation = std::max(asked, 4.0 * grid_.resolution());
        result_.mesh.origin = grid_.origin();
        corners_.assign(mesh.nodes.size(), -1);
    }

    Tessellation run() {
        if (too_many()) {
            refuse();
        }
        for (std::size_t t = 0; t < mesh_.triangle_face.size(); ++t) {
            element_ = static_cast<std::int32_t>(t);
            read_control();
            for (std::size_t k = 0; k < 3; ++k) {
                divide_side(k);
            }
            divide_patch();
        }
        return std::move(result_);
    }

  private:
    /// Whether there would be more triangles than allowed, by estimates for all curved triangles before any is divided:
    /// first by estimates that are too large, which suffice for most meshes, then by those of sixteen pieces of each
    /// triangle.
    bool too_many() {
        const auto most = static_cast<double>(max_triangles_);
        return estimate([&] { return most_pieces(); }) > most && estimate([&] { return likely_pieces(); }) > most;
    }

    template <typename Pieces>
    double estimate(const Pieces& pieces) {
        double sum = 0.0;
        for (std::size_t t = 0; t < mesh_.triangle_face.size(); ++t) {
            pace_.step();
            element_ = static_cast<std::int32_t>(t);
            read_nodes();
            sum += pieces();
        }
        return sum;
    }

    /// Number of halvings until a bend is at most the allowed one: each halving leaves a fourth of the bend.
    static double halvings(double bend, double allowed) {
        return std::clamp(std::ceil(0.5 * std::log2(std::max(bend, 1e-300) / allowed)), 0.0, double{kDeepest});
    }

    /// An upper bound of the pieces of the triangle: it is divided into four at a time, by the piece that bends most.
    double most_pieces() {
        double most = halvings(bend(lattice_, control_), result_.deviation);
        for (std::size_t k = 0; k < 3; ++k) {
            most = std::max(most, halvings(bend(side(k, (k + 1) % 3)), kEdgePart * result_.deviation));
        }
        return std::exp2(2.0 * most);
    }

    /// Estimate of the number of pieces of the triangle, from the bends of edges of sixteen pieces.
    double likely_pieces() {
        constexpr int kRows = 4;  // 16 pieces: an estimate for the limit of triangles needs no more
        const auto at = [](int i, int j) -> Barycentric {
            const double u = static_cast<double>(i) / kRows;
            const double v = static_cast<double>(j) / kRows;
            return {1.0 - u - v, u, v, 0.0};
        };
        double sum = 0.0;
        for (int i = 0; i < kRows; ++i) {
            for (int j = 0; i + j < kRows; ++j) {
                sum += pieces_between({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 2 <= kRows) {
                    sum += pieces_between({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                }
            }
        }
        return sum;
    }

    /// The edge that bends most is divided, and each of its pieces is a side of a triangle; where the other edges bend,
    /// too, there are rows of triangles.
    double pieces_between(const std::array<Barycentric, 3>& corners) {
        std::array<double, 3> times;
        for (std::size_t k = 0; k < 3; ++k) {
            times[k] = halvings(bend_of(corners[k], corners[(k + 1) % 3]), kEdgePart * result_.deviation);
        }
        std::sort(times.begin(), times.end());
        return std::exp2(std::max(times[2], times[0] + times[1]));
    }

    [[noreturn]] void refuse() const {
        throw InvalidInput(phrases::kManyTriangles, {{"length", in_mm(result_.deviation)}, {"count", max_triangles_}});
    }

    std::size_t node_of(std::size_t i) const {
        return static_cast<std::size_t>(mesh_.triangles[static_cast<std::size_t>(element_) * order_.size() + i]);
    }

    void read_nodes() {
        nodes_.resize(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) {
            nodes_[static_cast<std::size_t>(order_[i])] = mesh_.nodes[node_of(i)];
        }
        control_ = elements::nodes_to_bezier(lattice_, nodes_);
    }

    /// Reads the control points of the triangle, and makes its corners vertices of the result.
    void read_control() {
        read_nodes();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t node = node_of(i);
            if (corners_[node] < 0) {
                corners_[node] = add_vertex(mesh_.nodes[node]);
            }
            triangle_[i] = corners_[node];
        }
        derivatives_ = {elements::derivative(lattice_, control_, 1), elements::derivative(lattice_, control_, 2)};
        normals_.clear();
    }

    std::int32_t add_vertex(const Vec3& point) {
        result_.mesh.vertices.push_back(grid_.snap(point));
        return static_cast<std::int32_t>(result_.mesh.vertices.size()) - 1;
    }

    /// Divides side k, from corner k to the next, unless the neighbour has done it. It is taken from its lower vertex
    /// to the higher, so that both triangles give the same result.
    void divide_side(std::size_t k) {
        std::size_t a = k;
        std::size_t b = (k + 1) % 3;
        if (triangle_[a] > triangle_[b]) {
            std::swap(a, b);
        }
        if (!sides_.insert(pair_key(triangle_[a], triangle_[b])).second) {
            return;
        }
        result_.edge_lines.push_back(triangle_[a]);
        divide(triangle_[a], triangle_[b], side(a, b), 0);
        result_.edge_lines.push_back(-1);
    }

    /// Control points of the side from one corner to another.
    std::vector<Vec3> side(std::size_t from, std::size_t to) const {
        std::vector<Vec3> nodes;
        Exponents e{0, 0, 0, 0};
        for (int i = 0; i <= mesh_.order; ++i) {
            e[from] = mesh_.order - i;
            e[to] = i;
            nodes.push_back(nodes_[static_cast<std::size_t>(lattice_.index(e))]);
        }
        return elements::nodes_to_bezier(Lattice::of(1, mesh_.order), nodes);
    }

    /// Halves a curve until its chords are near enough, and lists the vertices after the first.
    void divide(std::int32_t a, std::int32_t b, const std::vector<Vec3>& control, int depth) {
        if (depth == kDeepest || bend(control) <= kEdgePart * result_.deviation) {
            result_.edge_lines.push_back(b);
            return;
        }
        const auto [first, second] = elements::halve(Lattice::of(1, mesh_.order), control, 0, 1);
        const std::int32_t middle = add_vertex(first.back());
        side_middles_[pair_key(a, b)] = middle;
        divide(a, middle, first, depth + 1);
        divide(middle, b, second, depth + 1);
    }

    void divide_patch() {
        inner_middles_.clear();
        pieces_.push_back({triangle_, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, 0});
        while (!pieces_.empty()) {
            pace_.step();
            const Piece piece = pieces_.back();
            pieces_.pop_back();
            std::array<std::int32_t, 3> middles{};
            int halved = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                middles[k] = middle(piece, k);
                halved += middles[k] >= 0 ? 1 : 0;
            }
            if (halved > 0) {
                cut(piece, middles, halved);
            } else if (piece.depth < kDeepest && bend_of(piece) > result_.deviation) {
                cut_at_centre(piece);
            } else {
                keep(piece);
            }
        }
    }

    /// The vertex that halves edge k of the piece, from its corner k to the next; -1: the edge is within the tolerance.
    std::int32_t middle(const Piece& piece, std::size_t k) {
        const std::size_t next = (k + 1) % 3;
        const elements::EdgeKey key = pair_key(piece.corners[k], piece.corners[next]);
        if (on_side(piece.at[k], piece.at[next])) {
            const auto found = side_middles_.find(key);
            return found == side_middles_.end() ? -1 : found->second;
        }
        const auto [found, fresh] = inner_middles_.try_emplace(key, -1);
        if (fresh && piece.depth < kDeepest && bend_of(piece.at[k], piece.at[next]) > kEdgePart * result_.deviation) {
            found.value() = add_vertex(value(lattice_, control_, elements::middle_of(piece.at[k], piece.at[next])));
        }
        return found->second;
    }

    double bend_of(const Barycentric& from, const Barycentric& to) {
        Arguments at{};
        part_.clear();
        for (int i = 0; i <= mesh_.order; ++i) {
            for (int k = 0; k < mesh_.order; ++k) {
                at[static_cast<std::size_t>(k)] = k < i ? &to : &from;
            }
            part_.push_back(polar(lattice_, control_, at));
        }
        return bend(part_);
    }

    double bend_of(const Piece& piece) {
        Arguments at{};
        part_.clear();
        for (int i = 0; i < lattice_.size(); ++i) {
            const Exponents& e = lattice_.exponents(i);
            for (int k = 0; k < mesh_.order; ++k) {
                at[static_cast<std::size_t>(k)] = &piece.at[k < e[0] ? 0 : k < e[0] + e[1] ? 1 : 2];
            }
            part_.push_back(polar(lattice_, control_, at));
        }
        return bend(lattice_, part_);
    }

    void add_piece(const Piece& whole, const std::array<std::int32_t, 3>& corners,
                   const std::array<Barycentric, 3>& at) {
        pieces_.push_back({corners, at, whole.depth + 1});
    }

    /// One halved edge gives two pieces, two give three, three give four.
    void cut(const Piece& piece, const std::array<std::int32_t, 3>& middles, int halved) {
        // Rotates the corners so that the halved edges come first: 0; 0 and 1; all.
        std::size_t k = 0;
        while (middles[k] < 0 || (halved == 2 && middles[(k + 1) % 3] < 0)) {
            ++k;
        }
        const std::array<std::size_t, 3> turn{k, (k + 1) % 3, (k + 2) % 3};
        std::array<std::int32_t, 6> v{};
        std::array<Barycentric, 6> at{};
        for (std::size_t i = 0; i < 3; ++i) {
            v[i] = piece.corners[turn[i]];
            at[i] = piece.at[turn[i]];
            v[3 + i] = middles[turn[i]];
            at[3 + i] = elements::middle_of(at[i], piece.at[turn[(i + 1) % 3]]);
        }
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
            add_piece(piece, {v[a], v[b], v[c]}, {at[a], at[b], at[c]});
        };
        if (halved == 1) {
            add(0, 3, 2);
            add(3, 1, 2);
        } else if (halved == 2) {
            add(3, 1, 4);
            if (distance(v[0], v[4]) <= distance(v[3], v[2])) {
                add(0, 3, 4);
                add(0, 4, 2);
            } else {
                add(0, 3, 2);
                add(3, 4, 2);
            }
        } else {
            add(0, 3, 5);
            add(3, 1, 4);
            add(5, 4, 2);
            add(3, 4, 5);
        }
    }

    double distance(std::int32_t a, std::int32_t b) const {
        return (result_.mesh.vertices[static_cast<std::size_t>(a)] - result_.mesh.vertices[static_cast<std::size_t>(b)])
            .norm();
    }

    /// Divides patches that bend inside although their edges do not.
    void cut_at_centre(const Piece& piece) {
        Barycentric centre{};
        for (std::size_t i = 0; i < 3; ++i) {
            centre[i] = (piece.at[0][i] + piece.at[1][i] + piece.at[2][i]) / 3.0;
        }
        const std::int32_t vertex = add_vertex(value(lattice_, control_, centre));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            add_piece(piece, {piece.corners[k], piece.corners[next], vertex}, {piece.at[k], piece.at[next], centre});
        }
    }

    void keep(const Piece& piece) {
        if (result_.mesh.triangles.size() == max_triangles_) {
            refuse();
        }
        result_.mesh.triangles.push_back(piece.corners);
        result_.mesh.triangle_face.push_back(mesh_.triangle_face[static_cast<std::size_t>(element_)]);
        result_.element.push_back(element_);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto key = static_cast<std::uint64_t>(piece.corners[k]);
            const auto [found, fresh] = normals_.try_emplace(key, static_cast<std::int32_t>(result_.normals.size()));
            if (fresh) {
                result_.normals.push_back(normal_of(piece, k));
            }
            result_.triangle_normals.push_back(found->second);
        }
    }

    /// The normal at a corner of the piece; that of the flat piece where the curved triangle is singular, zero where
    /// that is degenerate, too.
    Vec3 normal_of(const Piece& piece, std::size_t k) const {
        const Lattice& lower = Lattice::of(2, mesh_.order - 1);
        const Vec3 normal =
            value(lower, derivatives_[0], piece.at[k]).cross(value(lower, derivatives_[1], piece.at[k]));
        if (normal.squaredNorm() > 0.0) {
            return normal.normalized();
        }
        std::array<Vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = result_.mesh.vertices[static_cast<std::size_t>(piece.corners[i])];
        }
        return Vec3((p[1] - p[0]).cross(p[2] - p[0])).normalized();
    }

    const CurvedMesh& mesh_;
    const Lattice& lattice_;
    std::vector<int> order_;
    SinglePrecisionGrid grid_;
    CancelPace pace_;
    std::size_t max_triangles_;
    Tessellation result_;
    std::vector<std::int32_t> corners_;  // vertex by node of the mesh
    KeySet sides_;
    KeyMap<std::int32_t> side_middles_;
    // The curved triangle that is divided at present:
    std::int32_t element_ = 0;
    std::array<std::int32_t, 3> triangle_{};
    std::vector<Vec3> nodes_;
    std::vector<Vec3> control_;
    std::array<std::vector<Vec3>, 2> derivatives_;  // derivatives along the sides from the first corner
    KeyMap<std::int32_t> normals_;                  // by vertex
    KeyMap<std::int32_t> inner_middles_;
    std::vector<Piece> pieces_;
    std::vector<Vec3> part_;
};

}  // namespace

Tessellation tessellate(const CurvedMesh& mesh, double deviation, const Progress* progress, std::size_t max_triangles) {
    return Tessellator(mesh, deviation, progress, max_triangles).run();
}

}  // namespace mq::curve
