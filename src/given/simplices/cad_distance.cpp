// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/cad_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/bernstein.h"
#include "elements/product/reference_nodes.h"
#include "geometry/session.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::given {

using elements::Lattice;
using elements::value;

namespace {

using geometry::Answer;
using geometry::Query;
using geometry::Session;

/// The curved triangles, and the flat triangles into which they are cut.
class CurvedTriangles {
  public:
    CurvedTriangles(const std::vector<Vec3>& nodes, int order, const std::vector<std::int32_t>& triangles)
        : lattice_(Lattice::of(2, order)), steps_(order == 1 ? 1 : kFlatPieces) {
        const auto width = static_cast<std::size_t>(lattice_.size());
        control_.resize(triangles.size() / width);
        for (std::size_t t = 0; t < control_.size(); ++t) {
            std::vector<Vec3> own(width);
            for (std::size_t i = 0; i < width; ++i) {
                own[i] = nodes[static_cast<std::size_t>(triangles[t * width + i])];
            }
            control_[t] = elements::gmsh_to_bezier(lattice_, own);
            cut(t);
        }
        tree_.emplace(points_, flat_);
    }

    /// The distance from the nearest point of the curved triangles. Near an edge that point may be on a neighbour of
    /// the triangle whose flat triangles are nearest: up to kMostOwners triangles within reach are tried.
    double distance(const Vec3& p) const {
        const std::int32_t nearest = tree_->nearest(p).triangle;
        double best = distance_from(nearest, p);
        std::vector<std::size_t> tried{owner(nearest)};
        const Box reach{p - Vec3::Constant(best), p + Vec3::Constant(best)};
        tree_->for_each_in_box(reach, [&](std::int32_t flat) {
            if (std::find(tried.begin(), tried.end(), owner(flat)) == tried.end()) {
                tried.push_back(owner(flat));
                best = std::min(best, distance_from(flat, p));
            }
            return tried.size() < kMostOwners;
        });
        return best;
    }

  private:
    static constexpr int kFlatPieces = 4;  // flat triangles along an edge of a curved one
    static constexpr std::size_t kMostOwners = 8;

    std::size_t owner(std::int32_t flat) const { return static_cast<std::size_t>(flat) / cells(); }

    /// The distance from the curved triangle of a flat one. The search starts at the nearest point of the flat one.
    double distance_from(std::int32_t flat, const Vec3& p) const {
        const std::vector<Vec3>& control = control_[owner(flat)];
        const mesh::Triangle& t = flat_[static_cast<std::size_t>(flat)];
        const Vec3 nearest =
            mesh::nearest_on_triangle(p, points_[static_cast<std::size_t>(t[0])],
                                      points_[static_cast<std::size_t>(t[1])], points_[static_cast<std::size_t>(t[2])]);
        std::array<double, 2> at = start(static_cast<std::size_t>(flat), nearest);
        double best = (point(control, at) - p).norm();
        for (int round = 0; round < kNewtonSteps && steps_ > 1; ++round) {
            const std::array<double, 2> next = improved(control, at, p);
            const double distance = (point(control, next) - p).norm();
            if (!(distance < best)) {
                break;
            }
            best = distance;
            at = next;
        }
        return best;
    }

    std::size_t cells() const { return static_cast<std::size_t>(steps_) * static_cast<std::size_t>(steps_); }
    std::size_t own_points() const {
        return static_cast<std::size_t>(steps_ + 1) * static_cast<std::size_t>(steps_ + 2) / 2;
    }

    Vec3 point(const std::vector<Vec3>& control, const std::array<double, 2>& at) const {
        return value(lattice_, control, elements::Barycentric{1.0 - at[0] - at[1], at[0], at[1], 0.0});
    }

    void cut(std::size_t t) {
        const auto base = static_cast<std::int32_t>(points_.size());
        for (int j = 0; j <= steps_; ++j) {
            for (int i = 0; i + j <= steps_; ++i) {
                places_.resize(std::max(places_.size(), points_.size() - static_cast<std::size_t>(base) + 1));
                const std::array<double, 2> at{double(i) / steps_, double(j) / steps_};
                places_[points_.size() - static_cast<std::size_t>(base)] = at;
                points_.push_back(point(control_[t], at));
            }
        }
        const auto number = [&](int i, int j) { return base + i + j * (2 * steps_ + 3 - j) / 2; };
        for (int j = 0; j < steps_; ++j) {
            for (int i = 0; i + j < steps_; ++i) {
                flat_.push_back({number(i, j), number(i + 1, j), number(i, j + 1)});
                if (i + j + 1 < steps_) {
                    flat_.push_back({number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
                }
            }
        }
    }

    /// The parameters, in the curved triangle, of a point of a flat triangle.
    std::array<double, 2> start(std::size_t flat, const Vec3& p) const {
        const mesh::Triangle& corners = flat_[flat];
        const auto corner = [&](std::size_t k) { return points_[static_cast<std::size_t>(corners[k])]; };
        const auto place = [&](std::size_t k) { return places_[static_cast<std::size_t>(corners[k]) % own_points()]; };
        const Vec3 u = corner(1) - corner(0);
        const Vec3 v = corner(2) - corner(0);
        const Vec3 n = u.cross(v);
        const double square = n.squaredNorm();
        const Vec3 to = p - corner(0);
        const double s = square > 0.0 ? to.cross(v).dot(n) / square : 0.0;
        const double t = square > 0.0 ? u.cross(to).dot(n) / square : 0.0;
        std::array<double, 2> at{};
        for (std::size_t d = 0; d < 2; ++d) {
            at[d] = place(0)[d] + s * (place(1)[d] - place(0)[d]) + t * (place(2)[d] - place(0)[d]);
        }
        return inside(at);
    }

    static std::array<double, 2> inside(std::array<double, 2> at) {
        at[0] = std::clamp(at[0], 0.0, 1.0);
        at[1] = std::clamp(at[1], 0.0, 1.0);
        const double over = at[0] + at[1] - 1.0;
        if (over > 0.0) {
            at[0] = std::clamp(at[0] - over / 2.0, 0.0, 1.0);
            at[1] = 1.0 - at[0];
        }
        return at;
    }

    std::array<double, 2> improved(const std::vector<Vec3>& control, const std::array<double, 2>& at,
                                   const Vec3& p) const {
        const Lattice& lower = Lattice::of(2, lattice_.degree() - 1);
        const elements::Barycentric place{1.0 - at[0] - at[1], at[0], at[1], 0.0};
        const Vec3 u = value(lower, elements::derivative(lattice_, control, 1), place);
        const Vec3 v = value(lower, elements::derivative(lattice_, control, 2), place);
        const Vec3 off = p - point(control, at);
        const double uu = u.squaredNorm();
        const double uv = u.dot(v);
        const double vv = v.squaredNorm();
        const double determinant = uu * vv - uv * uv;
        if (!(determinant > 0.0)) {
            return at;
        }
        return inside({at[0] + (vv * off.dot(u) - uv * off.dot(v)) / determinant,
                       at[1] + (uu * off.dot(v) - uv * off.dot(u)) / determinant});
    }

    const Lattice& lattice_;
    int steps_;
    std::vector<std::vector<Vec3>> control_;
    std::vector<std::array<double, 2>> places_;  ///< parameters of the points of one triangle
    std::vector<Vec3> points_;
    std::vector<mesh::Triangle> flat_;
    std::optional<mesh::NearestTree> tree_;
};

/// Samples of one face or edge.
struct Samples {
    std::vector<Vec3> points;
    double spacing = 0.0;
    int columns = 0;  ///< steps along u, or along the edge
    int rows = 0;
};

double between(const std::array<double, 2>& low_high, int i, int steps) {
    return low_high[0] + (low_high[1] - low_high[0]) * double(i) / steps;
}

/// The points of a grid of (columns + 1) x (rows + 1) parameters on the surface, each with a flag: whether it is inside
/// of the face.
struct Grid {
    int columns = 0;
    int rows = 0;
    std::vector<Vec3> points;
    std::vector<char> there;

    std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns + 1) + static_cast<std::size_t>(i);
    }
};

Grid grid_of(Session& session, int face, int columns, int rows, bool trimmed) {
    const geometry::Face& bounds = session.topology().faces[static_cast<std::size_t>(face)];
    Grid grid{columns, rows, {}, {}};
    geometry::Engine::Batch points;
    geometry::Engine::Batch contained;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double u = between({bounds.low[0], bounds.high[0]}, i, columns);
            const double v = between({bounds.low[1], bounds.high[1]}, j, rows);
            points.push_back(Query::face_point(face, u, v));
            if (trimmed) {
                contained.push_back(Query::face_contains(face, u, v));
            }
        }
    }
    const geometry::Engine::Answers places = session.ask(std::move(points));
    const geometry::Engine::Answers sides = session.ask(std::move(contained));
    for (std::size_t k = 0; k < places.size(); ++k) {
        const bool known = places[k].status == geometry::Status::Ok || places[k].status == geometry::Status::Singular;
        grid.points.push_back(places[k].point);
        grid.there.push_back(
            known && (!trimmed || (sides[k].status == geometry::Status::Ok && sides[k].side >= 0)) ? 1 : 0);
    }
    return grid;
}

/// The lengths, mm, of the longest grid lines of a coarse grid along u and along v.
std::array<double, 2> extent(const Grid& grid) {
    std::array<double, 2> longest{};
    for (int j = 0; j <= grid.rows; ++j) {
        double length = 0.0;
        for (int i = 0; i < grid.columns; ++i) {
            length += (grid.points[grid.at(i + 1, j)] - grid.points[grid.at(i, j)]).norm();
        }
        longest[0] = std::max(longest[0], length);
    }
    for (int i = 0; i <= grid.columns; ++i) {
        double length = 0.0;
        for (int j = 0; j < grid.rows; ++j) {
            length += (grid.points[grid.at(i, j + 1)] - grid.points[grid.at(i, j)]).norm();
        }
        longest[1] = std::max(longest[1], length);
    }
    return longest;
}

/// Steps of a grid along one parameter: what is much longer than wide is sampled coarser than requested.
int steps_along(double length, double spacing) {
    return static_cast<int>(std::clamp(std::ceil(length / spacing), 2.0, 400.0));
}

/// @param spacing  requested distance between neighbours, mm
Samples samples_of_face(Session& session, int face, const std::array<double, 2>& extent, double spacing) {
    const Grid grid = grid_of(session, face, steps_along(extent[0], spacing), steps_along(extent[1], spacing), true);
    Samples found{{}, 0.0, grid.columns, grid.rows};
    for (int j = 0; j <= grid.rows; ++j) {
        for (int i = 0; i <= grid.columns; ++i) {
            if (grid.there[grid.at(i, j)] == 0) {
                continue;
            }
            const Vec3& p = grid.points[grid.at(i, j)];
            found.points.push_back(p);
            if (i < grid.columns && j < grid.rows) {
                found.spacing = std::max(found.spacing, (grid.points[grid.at(i + 1, j + 1)] - p).norm());
            }
        }
    }
    return found;
}

Samples samples_of_edge(Session& session, int edge, double spacing) {
    constexpr int kCoarse = 8;
    const geometry::Edge& bounds = session.topology().edges[static_cast<std::size_t>(edge)];
    const auto ask = [&](int steps) {
        geometry::Engine::Batch batch;
        for (int i = 0; i <= steps; ++i) {
            batch.push_back(Query::edge_point(edge, between({bounds.t0, bounds.t1}, i, steps)));
        }
        std::vector<Vec3> points;
        for (const Answer& answer : session.ask(std::move(batch))) {
            if (answer.status == geometry::Status::Ok || answer.status == geometry::Status::Singular) {
                points.push_back(answer.point);
            }
        }
        return points;
    };
    double length = 0.0;
    const std::vector<Vec3> coarse = ask(kCoarse);
    for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
        length += (coarse[i + 1] - coarse[i]).norm();
    }
    const int steps = steps_along(length, spacing);
    Samples found{ask(steps), 0.0, steps, 0};
    for (std::size_t i = 0; i + 1 < found.points.size(); ++i) {
        found.spacing = std::max(found.spacing, (found.points[i + 1] - found.points[i]).norm());
    }
    return found;
}

/// The largest distance of the points from the surface, and the point that has it.
std::pair<double, Vec3> farthest(const CurvedTriangles& surface, const std::vector<Vec3>& points, Progress& progress) {
    std::vector<double> distance(points.size());
    for_chunks(static_cast<int>(points.size()), [&](int k) {
        progress.check();
        const auto i = static_cast<std::size_t>(k);
        distance[i] = surface.distance(points[i]);
    });
    const auto most = std::max_element(distance.begin(), distance.end());
    return most == distance.end() ? std::pair{0.0, Vec3(Vec3::Zero())}
                                  : std::pair{*most, points[static_cast<std::size_t>(most - distance.begin())]};
}

/// By face: the lengths of the longest grid lines of a coarse grid on it.
std::vector<std::array<double, 2>> extents_of_faces(Session& session) {
    constexpr int kCoarse = 6;
    const std::vector<geometry::Face>& faces = session.topology().faces;
    std::vector<std::array<double, 2>> found(faces.size(), {0.0, 0.0});
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!faces[f].no_area) {
            found[f] = extent(grid_of(session, static_cast<int>(f), kCoarse, kCoarse, false));
        }
    }
    return found;
}

/// The requested spacing, mm, on faces with these extents.
double spacing_for(const std::vector<std::array<double, 2>>& extents, double triangles, double size) {
    double area = 0.0;
    for (const std::array<double, 2>& sides : extents) {
        area += sides[0] * sides[1];
    }
    const double count = std::max(kLeastSamples, kSamplesOfTriangle * triangles);
    return std::max(std::sqrt(area / count), 1e-9 * size);
}

}  // namespace

CadDistances cad_distances(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model,
                           const std::vector<Vec3>& nodes, int order, const std::vector<std::int32_t>& triangles,
                           Progress* progress) {
    if (order < 1 || order > elements::kMaxOrder || triangles.empty()) {
        throw InvalidInput(phrases::kNothingToMeasure, {{"count", elements::kMaxOrder}});
    }
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    const CurvedTriangles surface(nodes, order, triangles);
    Session session(engine, model, &watched);
    const geometry::Topology& topology = session.topology();
    const std::vector<std::array<double, 2>> extents = extents_of_faces(session);
    const double spacing =
        spacing_for(extents, double(triangles.size()) / Lattice::of(2, order).size(), topology.box.largest_side());
    CadDistances result;
    double largest = -1.0;
    const auto add_distances = [&](const Samples& samples, const std::vector<int>& faces) {
        const auto [distance, point] = farthest(surface, samples.points, watched);
        if (distance > largest) {
            largest = distance;
            result.farthest = point;
        }
        result.spacing = std::max(result.spacing, samples.spacing);
        result.samples += samples.points.size();
        for (const int face : faces) {
            const auto own = static_cast<std::size_t>(topology.of_shape({2, face}).index);
            result.of_face.resize(std::max(result.of_face.size(), own + 1), 0.0);
            result.of_face[own] = std::max(result.of_face[own], distance);
        }
    };
    std::vector<std::vector<int>> faces_of_edge(topology.edges.size());
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        watched.advance(double(f) / double(topology.faces.size()));
        if (topology.faces[f].no_area) {
            continue;
        }
        const Samples samples = samples_of_face(session, static_cast<int>(f), extents[f], spacing);
        add_distances(samples, {static_cast<int>(f)});
        result.face_grids.push_back({topology.of_shape({2, static_cast<int>(f)}).index, topology.faces[f].low,
                                     topology.faces[f].high, samples.columns, samples.rows});
        for (const geometry::Loop& loop : topology.faces[f].loops) {
            for (const int use : loop.uses) {
                faces_of_edge[static_cast<std::size_t>(topology.uses[static_cast<std::size_t>(use)].edge)].push_back(
                    static_cast<int>(f));
            }
        }
    }
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        if (!topology.edges[e].degenerate && !faces_of_edge[e].empty()) {
            const Samples samples = samples_of_edge(session, static_cast<int>(e), spacing);
            add_distances(samples, faces_of_edge[e]);
            const geometry::Entity own = topology.of_shape({1, static_cast<int>(e)});
            if (own.dimension == 1) {
                result.edge_grids.push_back({own.index, topology.edges[e].t0, topology.edges[e].t1, samples.columns});
            }
        }
    }
    return result;
}

}  // namespace mq::given
