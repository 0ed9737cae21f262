// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/simplify_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "contour/simplification.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/edge_table.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/proof/distance_bounds.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/weld_vertices.h"

namespace mq::workflows {

using mesh::Corners;
using mesh::Triangle;

namespace {

/// Rounds at most; in the last one no edge is collapsed.
constexpr int kRounds = 12;
/// Rounds with the same distance from planes; in each further one it is halved.
constexpr int kFullRounds = 5;
/// The root of the sum of squared distances from planes up to which edges are collapsed, as a
/// multiple of the tolerance: the sum grows with the number of planes, and the proof decides.
constexpr double kPlaneSum = 6.0;
/// Fraction of the tolerance within which sample points of moved triangles are: the proof comes afterwards.
constexpr double kForward = 0.93;
/// Rounds in which points of a triangle that is too far are kept near, before it is fixed.
constexpr int kTimes = 2;
/// Bounds of distances are proven to this fraction of the tolerance.
constexpr double kFineness = 0.04;
/// Blocks along the largest side, which are simplified in parallel.
constexpr double kBlocks = 8.0;

class Simplification {
  public:
    Simplification(const mesh::TriangleMesh& given, const SimplifyOptions& options, Progress& progress)
        : options_(options),
          progress_(progress),
          triangles_(welded(given)),
          points_(rounded(given.vertices)),
          searched_(points_, triangles_),
          kept_(points_),
          times_(triangles_.size(), 0) {
        for (const Vec3& p : points_) {
            box_.add(p);
        }
        find_border();
        start_ = contour_of(given);
    }

    void run(SimplifiedSurface& result) {
        contour::CollapseLimits limits;
        limits.distance = kPlaneSum * options_.tolerance;
        limits.border = options_.tolerance;
        limits.kept_points = &kept_;
        limits.kept_distance = kForward * options_.tolerance;
        limits.accepts = [this](const Corners& c, std::int32_t source) { return is_near(c, source); };
        for (result.rounds = 1; result.rounds <= kRounds; ++result.rounds) {
            now_ = start_;
            progress_.stage("simplifying", 0.0, 0.7);
            if (result.rounds > kFullRounds) {
                limits.distance = std::max(limits.distance / 2.0, options_.tolerance);
            }
            if (result.rounds < kRounds) {
                limits.fixed = fixed_;
                contour::simplify(now_, planes_, limits, box_.largest_side() / kBlocks, progress_);
            }
            progress_.stage("proving the distance", 0.7, 0.9);
            if (!keep_what_is_far()) {
                break;
            }
        }
        // What is not far is proven to be within the tolerance, which may be less than a bound of this fineness.
        result.deviation = result.rounds < kRounds ? std::min(bound(), options_.tolerance) : bound();
    }

    mesh::TriangleMesh mesh(const mesh::TriangleMesh& given) const {
        mesh::TriangleMesh found;
        found.origin = given.origin;
        found.vertices = now_.points;
        found.triangles = now_.triangles;
        for (std::size_t t = 0; t < now_.triangles.size() && !given.triangle_face.empty(); ++t) {
            found.triangle_face.push_back(given.triangle_face[static_cast<std::size_t>(now_.source[t])]);
        }
        return found;
    }

  private:
    static std::vector<Triangle> welded(const mesh::TriangleMesh& given) {
        const std::vector<std::int32_t> lowest = mesh::equal_vertices(rounded(given.vertices));
        std::vector<Triangle> triangles = given.triangles;
        for (Triangle& t : triangles) {
            for (std::int32_t& v : t) {
                v = lowest[static_cast<std::size_t>(v)];
            }
        }
        return triangles;
    }
    static std::vector<Vec3> rounded(const std::vector<Vec3>& points) {
        std::vector<Vec3> single;
        single.reserve(points.size());
        for (const Vec3& p : points) {
            single.push_back(to_single(p));
        }
        return single;
    }

    /// A point of a given triangle.
    struct Place {
        std::int32_t triangle = -1;
        Vec3 point = Vec3::Zero();
        std::int32_t source = -1;  ///< the given triangle from which the present one comes that is far from it; or -1
    };
    Corners corners(const Triangle& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }
    Vec3 normal(const Triangle& t) const {
        return (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]).normalized();
    }

    /// Which triangles have a vertex on an open border.
    /// @throws InvalidInput where an edge has not one triangle or two that run along it in opposite ways
    void find_border() {
        std::vector<char> on_border(points_.size(), 0);
        std::size_t bad = 0;
        mesh::EdgeTable(triangles_, points_.size())
            .for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
                const auto runs_up = [&](std::uint32_t corner) { return triangles_[corner / 3][corner % 3] == low; };
                if (last - first == 1) {
                    on_border[static_cast<std::size_t>(low)] = on_border[static_cast<std::size_t>(high)] = 1;
                } else if (last - first > 2 || runs_up(first[0]) == runs_up(first[1])) {
                    ++bad;
                }
            });
        bad += static_cast<std::size_t>(std::count_if(triangles_.begin(), triangles_.end(), mesh::is_collapsed));
        if (bad > 0) {
            throw InvalidInput(phrases::kNotSimplified, {{"count", bad}});
        }
        for (const Triangle& t : triangles_) {
            fixed_.push_back(std::any_of(t.begin(), t.end(), [&](std::int32_t v) { return on_border[v] != 0; }) ? 1
                                                                                                                : 0);
        }
    }

    /// By given triangle: vertices to keep near its patch, each once for each patch that it is a corner of.
    std::vector<std::vector<std::int32_t>> vertices_of(const std::vector<std::vector<std::int32_t>>& patches) const {
        std::vector<std::vector<std::int32_t>> kept(triangles_.size());
        std::vector<std::size_t> seen(points_.size(), 0);
        for (std::size_t patch = 0; patch < patches.size(); ++patch) {
            for (const std::int32_t t : patches[patch]) {
                for (const std::int32_t v : triangles_[static_cast<std::size_t>(t)]) {
                    if (std::exchange(seen[static_cast<std::size_t>(v)], patch + 1) != patch + 1) {
                        kept[static_cast<std::size_t>(t)].push_back(v);
                    }
                }
            }
        }
        return kept;
    }

    contour::Contour contour_of(const mesh::TriangleMesh& given) {
        DisjointSets<std::int32_t> smooth(triangles_.size());
        const double cosine = std::cos(options_.feature_angle * M_PI / 180.0);
        mesh::EdgeTable(triangles_, points_.size())
            .for_each([&](std::int32_t, std::int32_t, const std::uint32_t* first, const std::uint32_t* last) {
                const std::uint32_t a = first[0] / 3, b = last[-1] / 3;
                const bool one_face = given.triangle_face.empty() || given.triangle_face[a] == given.triangle_face[b];
                if (one_face && normal(triangles_[a]).dot(normal(triangles_[b])) >= cosine) {
                    smooth.unite(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
                }
            });
        contour::Contour contour;
        contour.points = points_;
        contour.triangles = triangles_;
        std::int32_t count = 0;
        contour.patch = smooth.number(count);
        std::vector<std::vector<std::int32_t>> of_patch(static_cast<std::size_t>(count));
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            of_patch[static_cast<std::size_t>(contour.patch[t])].push_back(static_cast<std::int32_t>(t));
        }
        contour.kept = vertices_of(of_patch);
        for (const std::vector<std::int32_t>& patch : of_patch) {
            trees_.push_back(std::make_unique<mesh::NearestTree>(points_, triangles_, patch));
        }
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            contour::Crossing plane;
            plane.on_input = points_[triangles_[t][0]];
            plane.normal = normal(triangles_[t]);
            planes_.push_back(plane);
            contour.source.push_back(static_cast<std::int32_t>(t));
            contour.plane.push_back(plane.normal.allFinite() ? static_cast<std::int32_t>(t) : -1);
        }
        return contour;
    }

    /// Whether sample points of a moved triangle are within a fraction of the tolerance of its patch of the given
    /// surface: so borders between patches stay, too, where the surface beside them is plane. The surfaces are farthest
    /// apart at vertices of either, or where edges of both cross. Those of the given one are kept points; here are the
    /// vertex that moved and the edges at it, each of which is in turn the first and the second of two triangles.
    /// @param source  the triangle of the given surface that it comes from
    bool is_near(const Corners& c, std::int32_t source) const {
        const mesh::NearestTree& tree =
            *trees_[static_cast<std::size_t>(start_.patch[static_cast<std::size_t>(source)])];
        std::int32_t guess = source;
        for (const Vec3& p :
             {c[0], Vec3(0.75 * c[0] + 0.25 * c[1]), Vec3(0.25 * c[0] + 0.75 * c[1]), Vec3(0.5 * (c[0] + c[2]))}) {
            guess = tree.any_within(p, kForward * options_.tolerance, guess);
            if (guess < 0) {
                return false;
            }
        }
        return true;
    }

    std::vector<Corners> given_corners() const {
        std::vector<Corners> all;
        for (const Triangle& t : triangles_) {
            all.push_back(corners(t));
        }
        return all;
    }
    std::vector<Corners> own_corners() const {
        std::vector<Corners> all;
        for (const Triangle& t : now_.triangles) {
            all.push_back({now_.points[t[0]], now_.points[t[1]], now_.points[t[2]]});
        }
        return all;
    }

    /// Numbers the present triangles: those that are in the same place as in the round before keep their numbers.
    void number(const std::vector<Corners>& own) {
        std::map<std::array<double, 9>, std::int32_t> before = std::exchange(places_, {});
        alive_.assign(near_own_.size(), 0);
        numbers_.clear();
        for (const Corners& c : own) {
            const std::array<double, 9> place{c[0].x(), c[0].y(), c[0].z(), c[1].x(), c[1].y(),
                                              c[1].z(), c[2].x(), c[2].y(), c[2].z()};
            const auto known = before.find(place);
            if (known == before.end()) {
                near_own_.push_back(0);
                alive_.push_back(1);
            }
            numbers_.push_back(known != before.end() ? known->second : static_cast<std::int32_t>(alive_.size()) - 1);
            alive_[static_cast<std::size_t>(numbers_.back())] = 1;
            places_.emplace(place, numbers_.back());
        }
    }
    /// Whether the present surface has all triangles that proved a given one to be near.
    bool is_still_near(std::size_t t) const {
        return !witnesses_[t].empty() && std::all_of(witnesses_[t].begin(), witnesses_[t].end(), [&](std::int32_t n) {
            return alive_[static_cast<std::size_t>(n)] != 0;
        });
    }

    /// The given triangles that are too far from the present surface. What was proven in an earlier round and has not
    /// changed is not proven again, here and in `own_far`.
    std::vector<Place> given_far() {
        std::vector<std::int32_t> asked;
        std::vector<Corners> some;
        witnesses_.resize(triangles_.size());
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            if (!is_still_near(t)) {
                asked.push_back(static_cast<std::int32_t>(t));
                some.push_back(corners(triangles_[t]));
            }
        }
        std::vector<std::vector<std::int32_t>> found;
        const mesh::SearchedSurface present(now_.points, now_.triangles);
        std::vector<Vec3> places;
        const std::vector<std::int32_t> far = beyond(some, present, &found, places);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            std::vector<std::int32_t>& of = witnesses_[static_cast<std::size_t>(asked[k])];
            of.clear();
            for (const std::int32_t t : found[k]) {
                of.push_back(numbers_[static_cast<std::size_t>(t)]);
            }
            std::sort(of.begin(), of.end());
            of.erase(std::unique(of.begin(), of.end()), of.end());
        }
        std::vector<Place> result;
        for (std::size_t k = 0; k < far.size(); ++k) {
            const std::int32_t t = asked[static_cast<std::size_t>(far[k])];
            witnesses_[static_cast<std::size_t>(t)].clear();
            result.push_back({t, places[k]});
        }
        return result;
    }
    /// The places of the given surface next to those of the present one that are too far from it.
    std::vector<Place> own_far(const std::vector<Corners>& own) {
        std::vector<std::int32_t> asked;
        std::vector<Corners> some;
        for (std::size_t t = 0; t < own.size(); ++t) {
            char& near = near_own_[static_cast<std::size_t>(numbers_[t])];
            if (std::exchange(near, 1) == 0) {
                asked.push_back(static_cast<std::int32_t>(t));
                some.push_back(own[t]);
            }
        }
        std::vector<Vec3> places;
        const std::vector<std::int32_t> far = beyond(some, searched_, nullptr, places);
        std::vector<Place> found;
        for (std::size_t k = 0; k < far.size(); ++k) {
            const auto index = static_cast<std::size_t>(asked[static_cast<std::size_t>(far[k])]);
            near_own_[static_cast<std::size_t>(numbers_[index])] = 0;
            const mesh::ClosestPoint next = searched_.tree.nearest(places[k]);
            found.push_back({next.triangle, next.point, now_.source[index]});
        }
        return found;
    }

    /// Adds the places that are too far from the other surface to the kept points, and fixes the given triangles around
    /// those for which that did not do; false where there is nothing.
    bool keep_what_is_far() {
        const std::vector<Corners> own = own_corners();
        number(own);
        std::vector<Place> far = given_far();
        const std::vector<Place> others = own_far(own);
        far.insert(far.end(), others.begin(), others.end());
        std::vector<char> around(points_.size(), 0);
        std::vector<char> asked(triangles_.size(), 0);
        for (const Place& place : far) {
            const auto t = static_cast<std::size_t>(place.triangle);
            if (times_[t] < kTimes) {
                asked[t] = 1;
                start_.kept[t].push_back(static_cast<std::int32_t>(kept_.size()));
                kept_.push_back(place.point);
                continue;
            }
            for (const std::int32_t fixed : {place.triangle, place.source}) {
                for (int k = 0; k < 3 && fixed >= 0; ++k) {
                    around[static_cast<std::size_t>(triangles_[static_cast<std::size_t>(fixed)][k])] = 1;
                }
            }
        }
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            times_[t] += asked[t];
        }
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const Triangle& c = triangles_[t];
            if (around[c[0]] != 0 || around[c[1]] != 0 || around[c[2]] != 0) {
                fixed_[t] = 1;
            }
        }
        return !far.empty();
    }
    std::vector<std::int32_t> beyond(const std::vector<Corners>& all, const mesh::SearchedSurface& other,
                                     std::vector<std::vector<std::int32_t>>* witnesses,
                                     std::vector<Vec3>& places) const {
        return mesh::triangles_beyond(all, other, 0.0, options_.tolerance, kFineness * options_.tolerance, progress_,
                                      witnesses, &places);
    }

    double bound() const {
        const mesh::SearchedSurface found(now_.points, now_.triangles);
        const double fineness = kFineness * options_.tolerance;
        return std::max(mesh::deviation_from_distance(given_corners(), found, 0.0, fineness, progress_).bound,
                        mesh::deviation_from_distance(own_corners(), searched_, 0.0, fineness, progress_).bound);
    }

    const SimplifyOptions& options_;
    Progress& progress_;
    const std::vector<Triangle> triangles_;  ///< as given, vertices in one place as one
    const std::vector<Vec3> points_;         ///< as given, in single precision
    const mesh::SearchedSurface searched_;
    std::vector<Vec3> kept_;   ///< points of the given surface that stay near: its vertices, and where that did not do
    std::vector<char> times_;  ///< by given triangle: how often points of it were added
    Box box_;
    std::vector<char> fixed_;  ///< by triangle: whether it is at an open border, or where simplifying went too far
    std::vector<contour::Crossing> planes_;                  ///< by given triangle
    std::vector<std::unique_ptr<mesh::NearestTree>> trees_;  ///< by patch: its given triangles
    contour::Contour start_;
    contour::Contour now_;
    std::map<std::array<double, 9>, std::int32_t> places_;  ///< numbers of the present triangles, by their corners
    std::vector<std::int32_t> numbers_;                     ///< by present triangle
    std::vector<char> alive_;                               ///< by number: whether the triangle is there
    std::vector<char> near_own_;                            ///< by number: whether it was proven to be near
    std::vector<std::vector<std::int32_t>> witnesses_;      ///< by given triangle: numbers of those that prove it near
};

}  // namespace

SimplifiedSurface simplify_surface(const mesh::TriangleMesh& given, const SimplifyOptions& options,
                                   Progress& progress) {
    mesh::require_valid(given);
    const Stopwatch watch_all;
    SimplifiedSurface result;
    StageTimer clock(result.surface.report.seconds);
    Simplification simplification(given, options, progress);
    simplification.run(result);
    clock.end("simplifying");
    result.surface.mesh = simplification.mesh(given);
    progress.stage("measuring", 0.9, 1.0);
    StageTimes seconds = std::move(result.surface.report.seconds);
    result.surface.report = mesh::measure(result.surface.mesh, &progress);
    result.surface.report.self_intersections =
        static_cast<std::int64_t>(mesh::self_intersections(result.surface.mesh.vertices, result.surface.mesh.triangles,
                                                           mesh::kMostCounted, &progress)
                                      .size());
    result.surface.report.seconds = std::move(seconds);
    result.surface.report.cpu_seconds = watch_all.cpu();
    return result;
}

}  // namespace mq::workflows
