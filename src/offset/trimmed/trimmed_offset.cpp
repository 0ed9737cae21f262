// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/trimmed_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/predicates.h"
#include "base/stopwatch.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "boolean/arrangement/soup.h"
#include "boolean/extraction/extraction.h"
#include "boolean/input/operation.h"
#include "boolean/rounding/snap_rounding.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/corner_table.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/proof/distance_bounds.h"
#include "offset/trimmed/dilation.h"
#include "offset/trimmed/raw_offset.h"
#include "offset/trimmed/tuning.h"

namespace mq::offset {

using boolean::CoincidentTriangle;

namespace {

/// The surface of a solid; reversed for an offset inward.
ClosedSurface one_side(const mesh::TriangleMesh& solid, const std::vector<Vec3>& normals, bool inward) {
    ClosedSurface result{solid.vertices, solid.triangles, {}, {}, normals};
    for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
        result.source.push_back(static_cast<std::int32_t>(t));
        if (inward) {
            std::swap(result.triangles[t][1], result.triangles[t][2]);
        }
    }
    for (std::size_t c = 0; inward && c < result.normals.size(); c += 3) {
        result.normals[c] = -result.normals[c];
        const Vec3 second = -result.normals[c + 1];
        result.normals[c + 1] = -result.normals[c + 2];
        result.normals[c + 2] = second;
    }
    result.twins = mesh::edge_twins(result.triangles, result.points.size());
    return result;
}

/// Two copies of the triangles that are not left out, the second one reversed; the copies are neighbours along the
/// border.
ClosedSurface both_sides(const mesh::TriangleMesh& surface, const std::vector<Vec3>& normals,
                         const std::vector<char>& left_out) {
    ClosedSurface result{surface.vertices, {}, {}, {}, {}};
    const bool has_normals = !normals.empty();
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        if (left_out[t] == 0) {
            result.triangles.push_back(surface.triangles[t]);
            result.source.push_back(static_cast<std::int32_t>(t));
            for (std::size_t c = 3 * t; has_normals && c < 3 * t + 3; ++c) {
                result.normals.push_back(normals[c]);
            }
        }
    }
    const std::vector<std::int32_t> front = mesh::edge_twins(result.triangles, result.points.size());
    const auto count = static_cast<std::int32_t>(front.size());
    // (a, b, c) becomes (a, c, b): the edge of corner i runs the other way at corner 2 - i.
    const auto turned = [count](std::int32_t c) { return count + c / 3 * 3 + 2 - c % 3; };
    result.twins.assign(static_cast<std::size_t>(2 * count), mesh::kBorder);
    for (std::int32_t c = 0; c < count; ++c) {
        const std::int32_t twin = front[static_cast<std::size_t>(c)];
        result.twins[static_cast<std::size_t>(c)] = twin >= 0 ? twin : turned(c);
        result.twins[static_cast<std::size_t>(turned(c))] = twin >= 0 ? turned(twin) : c;
    }
    for (std::int32_t t = 0; t < count / 3; ++t) {
        mesh::Triangle back = result.triangles[static_cast<std::size_t>(t)];
        std::swap(back[1], back[2]);
        result.triangles.push_back(back);
        result.source.push_back(result.source[static_cast<std::size_t>(t)]);
        for (const std::int32_t k : {0, 2, 1}) {
            if (has_normals) {
                const Vec3 front_normal = result.normals[static_cast<std::size_t>(3 * t + k)];
                result.normals.emplace_back(-front_normal);
            }
        }
    }
    return result;
}

/// The raw offset has more crossings than may be divided.
struct TooManyCrossings : TopologyError {
    using TopologyError::TopologyError;
};

/// One offset: it holds the state that the stages share.
class OffsetPipeline {
  public:
    OffsetPipeline(ClosedSurface surface, const Vec3& origin, const OffsetOptions& options, Progress& progress)
        : surface_(std::move(surface)),
          searched_(surface_.points, surface_.triangles),
          distance_(std::abs(options.distance) + OffsetTuning::kOvershoot * options.tolerance),
          asked_(std::abs(options.distance)),
          tolerance_(options.tolerance),
          progress_(progress) {
        result_.mesh.origin = origin;
    }

    /// @param inward  see DilationOptions
    OffsetResult run(double extension, bool inward) {
        OffsetResult best;
        best.error_bound = std::numeric_limits<double>::infinity();
        TopologyError failure(phrases::kOffsetLacks);
        double share = OffsetTuning::kRawShare;
        for (; round_ < OffsetTuning::kRounds && best.error_bound > tolerance_; ++round_) {
            try {
                attempt(share, extension, inward);
                if (result_.error_bound < best.error_bound) {
                    best = result_;
                }
            } catch (const TooManyCrossings&) {
                if (std::isfinite(best.error_bound)) {
                    break;
                }
                throw;  // a finer raw offset has about as many crossings for each triangle
            } catch (const TopologyError& error) {
                failure = error;  // a finer raw offset has fewer sheets that nearly coincide
            }
            share *= OffsetTuning::kRefinement;
        }
        if (!std::isfinite(best.error_bound)) {
            throw failure;
        }
        best.seconds = result_.seconds;
        return best;
    }

  private:
    void attempt(double share, double extension, bool inward) {
        result_.triangle_source.clear();
        soup_ = boolean::Soup();
        stage("offsetting", 0.0, 0.1);
        make_soup(share * tolerance_, extension);
        stage("finding crossings", 0.1, 0.3);
        const auto [crossing, twins] = contacts();
        result_.crossing_pairs = crossing.size();
        stage("dividing", 0.3, 0.6);
        const boolean::Arrangement arrangement = boolean::arrange(soup_, twins, crossing, progress_);
        stage("classifying", 0.6, 0.75);
        boolean::Cells cells = boolean::find_cells(soup_, arrangement, progress_);
        assign_dilation(arrangement, searched_.tree, {distance_, OffsetTuning::kDeepShare * tolerance_, inward}, cells,
                        progress_);
        stage("extracting", 0.75, 0.8);
        boolean::Extraction extraction = boolean::extract(
            soup_, arrangement, cells, boolean::Expression::chain(boolean::Operation::Union, 1), progress_);
        stage("rounding", 0.8, 0.9);
        finish(extraction);
        stage("measuring distances", 0.9, 1.0);
        measure(arrangement, cells, std::max(share * tolerance_, face_error()));
        stages_.end();
    }

    /// Starts a stage of the current round. The first round has half of the progress, each further one half of the
    /// rest.
    void stage(const char* name, double from, double to) {
        const double left = std::exp2(-round_);
        stages_.start(name, 1.0 - left + 0.5 * left * from, 1.0 - left + 0.5 * left * to);
    }

    /// Error of the raw offset where normals of CAD faces are known: finer rounds leave it as it is.
    double face_error() const { return surface_.normals.empty() ? 0.0 : OffsetTuning::kFaceShare * tolerance_; }

    void make_soup(double raw_error, double extension) {
        const double deep = distance_ - OffsetTuning::kDeepShare * tolerance_;
        RawOffset raw =
            raw_offset(surface_, {distance_, raw_error, face_error(), deep, &searched_, extension, &progress_});
        result_.raw_triangles = raw.triangles.size();
        soup_.operands = 1;
        soup_.vertices = std::move(raw.vertices);
        soup_.triangles = std::move(raw.triangles);
        for (const std::int32_t source : raw.source) {
            soup_.source.push_back({0, source});
        }
        boolean::merge_all_vertices(soup_);
        remove_collapsed_triangles();
        spread_flat_triangles();
    }

    void remove_collapsed_triangles() {
        std::size_t kept = 0;
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
            if (!mesh::is_collapsed(soup_.triangles[t])) {
                soup_.triangles[kept] = soup_.triangles[t];
                soup_.source[kept++] = soup_.source[t];
            }
        }
        soup_.triangles.resize(kept);
        soup_.source.resize(kept);
    }

    /// Moves the corners of triangles without area by a few steps of single precision, until none is left. Removing
    /// these triangles would open the surface.
    void spread_flat_triangles() {
        constexpr int kRounds = 30;
        constexpr double kMove = 8.0 * 6e-8;  // fraction of the coordinate
        std::uint32_t random = 1;
        bool again = true;
        for (int round = 0; again && round < kRounds; ++round) {
            again = false;
            for (const mesh::Triangle& c : soup_.triangles) {
                if (collinear(vertex(c[0]), vertex(c[1]), vertex(c[2]))) {
                    again = true;
                    for (const std::int32_t v : c) {
                        const double most = kMove * std::max(vertex(v).cwiseAbs().maxCoeff(), distance_);
                        for (double& x : vertex(v)) {
                            random = random * 1664525U + 1013904223U;  // Knuth, TAOCP 2, 3.3.4
                            x += most * (random / 2147483648.0 - 1.0);
                        }
                        vertex(v) = to_single(vertex(v));
                    }
                }
            }
        }
        if (again) {
            throw TopologyError(phrases::kOffsetDegenerate);
        }
    }
    Vec3& vertex(std::int32_t v) { return soup_.vertices[static_cast<std::size_t>(v)]; }

    using Pairs = std::vector<std::array<std::int32_t, 2>>;
    /// The pairs of triangles that meet, and the triangles that have the same three vertices as another one; such pairs
    /// are not among the pairs that meet.
    std::pair<Pairs, std::vector<CoincidentTriangle>> contacts() const {
        std::vector<std::int32_t> all(soup_.triangles.size());
        for (std::size_t t = 0; t < all.size(); ++t) {
            all[t] = static_cast<std::int32_t>(t);
        }
        std::vector<CoincidentTriangle> twins = boolean::find_twins(soup_, all);
        std::vector<char> twin(all.size(), 0);
        for (const CoincidentTriangle& t : twins) {
            twin[static_cast<std::size_t>(t.triangle)] = 1;
        }
        // The sum of squares has its smallest value if all triangles cross equally many others.
        const double count = static_cast<double>(all.size());
        const double most = std::max(OffsetTuning::kLeastDivisions, OffsetTuning::kDivisions * count);
        const auto most_pairs = static_cast<std::size_t>(0.5 * std::sqrt(count * most)) + 1;
        const std::vector<mesh::ContactPair> found =
            mesh::self_intersections(soup_.vertices, soup_.triangles, most_pairs, &progress_);
        Pairs crossing;
        for (const mesh::ContactPair& pair : found) {
            if (twin[static_cast<std::size_t>(pair.a)] == 0 && twin[static_cast<std::size_t>(pair.b)] == 0) {
                crossing.push_back({pair.a, pair.b});
            }
        }
        if (found.size() == most_pairs || divisions(crossing, all.size()) > most) {
            throw TooManyCrossings(phrases::kManyCrossings, {{"count", crossing.size()}});
        }
        return {std::move(crossing), std::move(twins)};
    }

    /// Sum over all triangles of the squared number of triangles that each one crosses. The time to divide them grows
    /// as this sum.
    static double divisions(const Pairs& crossing, std::size_t triangles) {
        std::vector<double> counts(triangles);
        for (const auto& [a, b] : crossing) {
            ++counts[static_cast<std::size_t>(a)];
            ++counts[static_cast<std::size_t>(b)];
        }
        return std::inner_product(counts.begin(), counts.end(), counts.begin(), 0.0);
    }

    void finish(boolean::Extraction& extraction) {
        boolean::ResultMesh& draft = extraction.draft;
        Box box;
        for (const Vec3& p : soup_.vertices) {
            box.add(p);
        }
        const boolean::RoundingCount rounded = boolean::snap_round(
            extraction, {box.largest_side(), OffsetTuning::kRoundingShare * tolerance_, true}, progress_);
        if (!rounded.faulty.empty()) {
            throw TopologyError(phrases::kOffsetNotHeld, {{"count", rounded.faulty.size()}});
        }
        for (const std::int32_t from : draft.from) {
            result_.triangle_source.push_back(soup_.source[static_cast<std::size_t>(from)].triangle);
        }
        result_.mesh.vertices = std::move(draft.vertices);
        result_.mesh.triangles = std::move(draft.triangles);
    }

    void measure(const boolean::Arrangement& arrangement, const boolean::Cells& cells, double raw_error) {
        const double fineness = OffsetTuning::kFineness * tolerance_;
        const mesh::SearchedSurface result(result_.mesh.vertices, result_.mesh.triangles);
        std::vector<mesh::Corners> triangles;
        for (const mesh::Triangle& t : result_.mesh.triangles) {
            const auto& v = result_.mesh.vertices;
            triangles.push_back({v[static_cast<std::size_t>(t[0])], v[static_cast<std::size_t>(t[1])],
                                 v[static_cast<std::size_t>(t[2])]});
        }
        const mesh::ProvenBound there =
            mesh::deviation_from_distance(triangles, searched_, asked_, fineness, progress_);
        // Every point of the exact offset has a point of the raw offset within the raw offset's error; that point may
        // be in a piece that was trimmed off.
        triangles.clear();
        for (std::size_t f = 0; f < arrangement.faces.size(); ++f) {
            const auto front = static_cast<std::size_t>(cells.front[f]);
            const auto back = static_cast<std::size_t>(cells.back[f]);
            if (cells.windings[front].empty() == cells.windings[back].empty()) {
                const auto& p = arrangement.faces[f].points;
                triangles.push_back({arrangement.points.approx(p[0]), arrangement.points.approx(p[1]),
                                     arrangement.points.approx(p[2])});
            }
        }
        // The result has the larger of both bounds, so the second one need not be refined below the first.
        const mesh::ProvenBound back =
            mesh::distance_of_outer_points(triangles, searched_, distance_ - raw_error, tolerance_, result,
                                           std::max(raw_error, there.bound), progress_);
        result_.error_bound = std::max(there.bound, back.bound);
    }

    const ClosedSurface surface_;
    const mesh::SearchedSurface searched_;
    const double distance_;  ///< mm: distance of the raw offset
    const double asked_;     ///< mm: distance that the caller requested
    const double tolerance_;
    Progress& progress_;
    OffsetResult result_;
    boolean::Soup soup_;
    int round_ = 0;
    WatchedStageTimer stages_{progress_, result_.seconds};
};

}  // namespace

void OffsetOptions::validate() const {
    if (!std::isfinite(distance) || distance == 0.0) {
        throw InvalidInput(phrases::kNotGiven, {{"option", "distance"}});
    }
    if (!std::isfinite(tolerance) || !(tolerance > 0.0)) {
        throw InvalidInput(phrases::kLengthNotAllowed,
                           {{"option", "tolerance"},
                            {"length", in_mm(tolerance)},
                            {"range", Message(phrases::kLongerThan, {{"length", in_mm(0.0)}})}});
    }
    if (tolerance > std::abs(distance)) {
        throw InvalidInput(phrases::kAboveDistance,
                           {{"length", in_mm(tolerance)}, {"length2", in_mm(std::abs(distance))}});
    }
}

OffsetResult offset(const mesh::TriangleMesh& solid, const OffsetOptions& options, Progress& progress) {
    options.validate();
    const ThreadLimit threads(options.threads);
    const bool inward = options.distance < 0.0;
    return OffsetPipeline(one_side(solid, options.corner_normals, inward), solid.origin, options, progress)
        .run(0.0, inward);
}

OffsetResult thicken(const mesh::TriangleMesh& surface, const std::vector<char>& left_out, const OffsetOptions& options,
                     Progress& progress) {
    options.validate();
    if (options.distance < 0.0) {
        throw InvalidInput(phrases::kLengthNotAllowed,
                           {{"option", "distance"},
                            {"length", in_mm(options.distance)},
                            {"range", Message(phrases::kLongerThan, {{"length", in_mm(0.0)}})}});
    }
    const ThreadLimit threads(options.threads);
    if (std::all_of(left_out.begin(), left_out.end(), [](char out) { return out != 0; })) {
        throw InvalidInput(phrases::kAllLeftOut);
    }
    return OffsetPipeline(both_sides(surface, options.corner_normals, left_out), surface.origin, options, progress)
        .run(OffsetTuning::kExtension * options.tolerance, false);
}

}  // namespace mq::offset
