// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/contoured_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "contour/contour.h"
#include "contour/simplification.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/intersection/self_intersection.h"
#include "mesh/proof/distance_bounds.h"
#include "offset/contoured/distance_level_set.h"
#include "offset/contoured/lattice_refinement.h"
#include "offset/contoured/tuning.h"
#include "offset/trimmed/tuning.h"

namespace mq::offset {

namespace {

/// Some triangles of a mesh, given by their indices, with their patches.
OffsetSurface surface_of(const mesh::TriangleMesh& mesh, const std::vector<std::int32_t>& chosen) {
    OffsetSurface result{mesh.vertices, {}, {}, true};
    for (const std::int32_t t : chosen) {
        result.triangles.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
        result.patch.push_back(mesh.triangle_face.empty() ? 0 : mesh.triangle_face[static_cast<std::size_t>(t)]);
    }
    return result;
}

/// One offset: it holds the state that the stages share.
class ContouredOffset {
  public:
    /// @param chosen  indices in the mesh of the triangles of the surface
    /// @param inward  whether the result is the solid without the points near its surface
    ContouredOffset(OffsetSurface surface, std::vector<std::int32_t> chosen, bool inward, const OffsetOptions& options,
                    Progress& progress)
        : surface_(std::move(surface)),
          chosen_(std::move(chosen)),
          inward_(inward),
          distance_(std::abs(options.distance)),
          tolerance_(options.tolerance),
          level_set_(surface_, distance_, ContouredOffsetTuning::kResolution * tolerance_),
          progress_(progress) {}

    OffsetResult run(const Vec3& origin) {
        stages_.start("dividing cells", 0.0, 0.6);
        const RefinedCells cells = refine(level_set_, box(), ContouredOffsetTuning::kSlack * tolerance_,
                                          ContouredOffsetTuning::kFinest * tolerance_, progress_);
        stages_.start("contouring", 0.6, 0.65);
        const contour::Contour whole = contour::contour(cells.crossed, &level_set_, progress_);
        simplify(whole, cells);
        stages_.start("checking crossings", 0.95, 1.0);
        finish(origin);
        stages_.end();
        return std::move(result_);
    }

  private:
    Box box() const {
        Box result = level_set_.tree().box();
        const double margin = (inward_ ? 0.0 : distance_) + 2.0 * tolerance_;
        result.low.array() -= margin;
        result.high.array() += margin;
        return result;
    }

    /// Simplifies the contour. Regions in which the result left the tolerance are not simplified in the next round; in
    /// the last round nothing is.
    void simplify(const contour::Contour& whole, const RefinedCells& cells) {
        contour::CollapseLimits limits;
        limits.distance = ContouredOffsetTuning::kSimplification * tolerance_;
        limits.border = limits.distance;
        limits.accepts = [this](const std::array<Vec3, 3>& c, std::int32_t) { return is_free(c) && is_near(c); };
        const double block = box().largest_side() / ContouredOffsetTuning::kBlocks;
        std::vector<double> wrong;
        for (int round = 1; round <= ContouredOffsetTuning::kRounds; ++round) {
            stages_.start("simplifying", 0.65, 0.8);
            contour_ = whole;
            if (round < ContouredOffsetTuning::kRounds) {
                contour::simplify(contour_, cells.crossed.crossings, limits, block, progress_);
            }
            stages_.start("proving the distance", 0.8, 0.95);
            wrong = misclassified(cells.nodes);
            const std::vector<Box> faults = faults_of(cells.nodes, wrong);
            if (faults.empty()) {
                break;
            }
            kept_.insert(kept_.end(), faults.begin(), faults.end());
        }
        result_.error_bound = std::max(cells.bound, deviation());
        for (const double distance : wrong) {
            result_.error_bound = std::max(result_.error_bound, distance);
        }
    }
    /// Whether a triangle is outside of all regions in which the contour is not simplified.
    bool is_free(const std::array<Vec3, 3>& c) const {
        Box box;
        for (const Vec3& p : c) {
            box.add(p);
        }
        return std::none_of(kept_.begin(), kept_.end(), [&](const Box& kept) { return kept.meets(box); });
    }
    /// Whether sample points of a triangle have the asked distance within a fraction of the tolerance. Samples are one
    /// chord apart in triangles up to 16 chords long: the chord of a ball of this distance whose arc is one tolerance
    /// high.
    bool is_near(const std::array<Vec3, 3>& c) const {
        constexpr double kMostChords = 16.0;
        const double longest = std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
        const double chord = std::sqrt(8.0 * distance_ * tolerance_);
        const int parts = static_cast<int>(std::clamp(std::ceil(longest / chord), 2.0, kMostChords));
        std::int32_t guess = -1;
        const auto near = [&](const Vec3& p) {
            const contour::LevelSample level = level_set_.at(p, guess);
            guess = level.source;
            return std::abs(level.value) <= ContouredOffsetTuning::kNear * tolerance_;
        };
        bool holds = near((c[0] + c[1] + c[2]) / 3.0);
        for (int i = 0; holds && i <= parts; ++i) {
            for (int j = 0; holds && i + j <= parts; ++j) {
                holds = near((i * c[0] + j * c[1] + (parts - i - j) * c[2]) / parts);
            }
        }
        return holds;
    }
    std::vector<mesh::Corners> triangles_found() const {
        std::vector<mesh::Corners> triangles;
        for (const mesh::Triangle& t : contour_.triangles) {
            const auto& v = contour_.points;
            triangles.push_back({v[static_cast<std::size_t>(t[0])], v[static_cast<std::size_t>(t[1])],
                                 v[static_cast<std::size_t>(t[2])]});
        }
        return triangles;
    }
    double deviation() const {
        const double fineness = OffsetTuning::kFineness * tolerance_;
        return mesh::deviation_from_distance(triangles_found(), level_set_.searched(), distance_, fineness, progress_)
            .bound;
    }
    /// By node: how far from the offset it is if it lies on the wrong side of the contour; 0 if it lies on the right
    /// side.
    std::vector<double> misclassified(const std::vector<LatticeNode>& nodes) const {
        std::vector<double> result(nodes.size());
        if (contour_.triangles.empty()) {
            return result;
        }
        const OffsetSurface found{contour_.points, contour_.triangles, contour_.patch, true};
        const DistanceLevelSet side(found, 0.0, 0.0);
        for_chunks(static_cast<int>(nodes.size()), [&](int k) {
            const LatticeNode& node = nodes[static_cast<std::size_t>(k)];
            const bool is_outside = side.at(node.place, -1).value >= 0.0;
            result[static_cast<std::size_t>(k)] = is_outside == (node.value >= 0.0) ? 0.0 : std::abs(node.value);
        });
        return result;
    }
    /// Boxes around the triangles and nodes that are outside of the tolerance.
    /// @param wrong  the result of misclassified()
    std::vector<Box> faults_of(const std::vector<LatticeNode>& nodes, const std::vector<double>& wrong) const {
        std::vector<Box> result;
        const std::vector<mesh::Corners> triangles = triangles_found();
        const double fineness = OffsetTuning::kFineness * tolerance_;
        const auto add = [&](const Box& box) {
            result.push_back(box);
            result.back().low.array() -= tolerance_;
            result.back().high.array() += tolerance_;
        };
        for (const std::int32_t t :
             mesh::triangles_beyond(triangles, level_set_.searched(), distance_, tolerance_, fineness, progress_)) {
            Box box;
            for (const Vec3& p : triangles[static_cast<std::size_t>(t)]) {
                box.add(p);
            }
            add(box);
        }
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            if (wrong[k] > tolerance_) {
                Box box;
                box.add(nodes[k].place + Vec3::Constant(wrong[k]));
                box.add(nodes[k].place - Vec3::Constant(wrong[k]));
                add(box);
            }
        }
        return result;
    }

    void finish(const Vec3& origin) {
        const std::size_t crossing =
            mesh::self_intersections(contour_.points, contour_.triangles, mesh::kAllPairs, &progress_).size();
        if (crossing > 0) {
            throw TopologyError(phrases::kOffsetCrosses, {{"count", crossing}});
        }
        result_.mesh.origin = origin;
        result_.mesh.vertices = std::move(contour_.points);
        result_.mesh.triangles = std::move(contour_.triangles);
        // Simplification may have moved borders between faces across the middles of triangles.
        result_.triangle_source.resize(result_.mesh.triangles.size());
        for_chunks(static_cast<int>(result_.mesh.triangles.size()), [&](int t) {
            const auto slot = static_cast<std::size_t>(t);
            Vec3 middle = Vec3::Zero();
            for (const std::int32_t v : result_.mesh.triangles[slot]) {
                middle += result_.mesh.vertices[static_cast<std::size_t>(v)] / 3.0;
            }
            const std::int32_t source = level_set_.at(middle, contour_.source[slot]).source;
            result_.triangle_source[slot] = chosen_[static_cast<std::size_t>(source)];
        });
        if (inward_) {
            for (mesh::Triangle& t : result_.mesh.triangles) {
                std::swap(t[1], t[2]);
            }
        }
    }

    const OffsetSurface surface_;
    const std::vector<std::int32_t> chosen_;
    const bool inward_;
    const double distance_;  ///< mm
    const double tolerance_;
    const DistanceLevelSet level_set_;
    Progress& progress_;
    std::vector<Box> kept_;  ///< regions in which the contour is not simplified
    contour::Contour contour_;
    OffsetResult result_;
    WatchedStageTimer stages_{progress_, result_.seconds};
};

}  // namespace

OffsetResult contoured_offset(const mesh::TriangleMesh& solid, const OffsetOptions& options, Progress& progress) {
    options.validate();
    if (solid.triangles.empty()) {
        OffsetResult nothing;
        nothing.mesh.origin = solid.origin;
        return nothing;
    }
    const ThreadLimit threads(options.threads);
    std::vector<std::int32_t> all(solid.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    OffsetSurface surface = surface_of(solid, all);
    const bool inward = options.distance < 0.0;
    if (inward) {
        for (mesh::Triangle& t : surface.triangles) {
            std::swap(t[1], t[2]);
        }
    }
    return ContouredOffset(std::move(surface), std::move(all), inward, options, progress).run(solid.origin);
}

OffsetResult contoured_walls(const mesh::TriangleMesh& surface, const std::vector<char>& left_out,
                             const OffsetOptions& options, Progress& progress) {
    options.validate();
    if (options.distance < 0.0) {
        throw InvalidInput(phrases::kLengthNotAllowed,
                           {{"option", "distance"},
                            {"length", in_mm(options.distance)},
                            {"range", Message(phrases::kLongerThan, {{"length", in_mm(0.0)}})}});
    }
    if (left_out.size() != surface.triangles.size()) {
        throw InvalidInput(phrases::kOneForEach,
                           {{"name", "left_out"}, {"count", left_out.size()}, {"count2", surface.triangles.size()}});
    }
    const ThreadLimit threads(options.threads);
    std::vector<std::int32_t> chosen;
    for (std::size_t t = 0; t < left_out.size(); ++t) {
        if (left_out[t] == 0) {
            chosen.push_back(static_cast<std::int32_t>(t));
        }
    }
    if (chosen.empty()) {
        throw InvalidInput(phrases::kAllLeftOut);
    }
    OffsetSurface sheet = surface_of(surface, chosen);
    sheet.is_solid = false;
    return ContouredOffset(std::move(sheet), std::move(chosen), false, options, progress).run(surface.origin);
}

}  // namespace mq::offset
