// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/offset_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "offset/contoured/contoured_offset.h"
#include "offset/trimmed/opening_extension.h"
#include "offset/trimmed/trimmed_offset.h"
#include "workflows/cad_normals.h"

namespace mq::workflows {

namespace {

using boolean::Expression;
using boolean::Operation;

BooleanSurface reported(offset::OffsetResult&& found, const BooleanSurface& solid, const offset::OffsetOptions& options,
                        const WorkBefore& before, const Stopwatch& watch, Progress& progress) {
    BooleanSurface result;
    result.mesh = std::move(found.mesh);
    if (!solid.mesh.triangle_face.empty()) {
        for (const std::int32_t t : found.triangle_source) {
            result.mesh.triangle_face.push_back(solid.mesh.triangle_face[static_cast<std::size_t>(t)]);
        }
    }
    result.triangle_source.assign(result.mesh.triangles.size(), {-1, -1});
    BooleanReport& figures = result.figures;
    figures.error_bound = found.error_bound;
    figures.tolerance_asked = options.tolerance;
    figures.reconstructed = result.mesh.triangles.size();
    figures.crossing_pairs = found.crossing_pairs;
    figures.self_intersections = 0;
    figures.seconds = std::move(found.seconds);
    complete_report(result, before, Message(phrases::kNoPointAway, {{"length", in_mm(std::abs(options.distance))}}),
                    progress);
    figures.cpu_seconds = before.cpu_seconds + watch.cpu();
    result.report = figures;
    return result;
}

/// The options with the normals of the solid's corners; triangles that were appended to the solid's own have none.
offset::OffsetOptions by_normals_of(const BooleanSurface& solid, offset::OffsetOptions options) {
    options.corner_normals = solid.corner_normals;
    if (!options.corner_normals.empty()) {
        options.corner_normals.resize(3 * solid.mesh.triangles.size(), Vec3::Zero());
    }
    return options;
}

/// Takes the trimmed raw offset if few of its triangles cross. Else it makes the contour of the distance, which takes
/// longer in general, but not for features smaller than the distance. If both miss the tolerance, or the contour fails,
/// the one with the smaller bound is taken.
template <typename Trimmed, typename Contoured>
offset::OffsetResult first_within(const offset::OffsetOptions& options, const Trimmed& trimmed,
                                  const Contoured& contoured) {
    const Stopwatch watch;
    std::optional<offset::OffsetResult> first;
    try {
        first = trimmed(options);
        if (first->error_bound <= options.tolerance) {
            return std::move(*first);
        }
    } catch (const TopologyError&) {
        // The result or error of the contour counts instead.
    }
    StageTimes seconds = first ? first->seconds : StageTimes{{"trimming the raw offset", watch.wall()}};
    offset::OffsetResult second;
    try {
        second = contoured(options);
    } catch (const Error&) {
        if (!first) {
            throw;
        }
        return std::move(*first);  // its bound says that it misses the tolerance
    }
    seconds.insert(seconds.end(), second.seconds.begin(), second.seconds.end());
    if (first && first->error_bound <= second.error_bound) {
        second = std::move(*first);
    }
    second.seconds = std::move(seconds);
    return second;
}

/// The offset of a solid with its report: offset::offset, and where too many triangles of the raw offset cross for
/// that, or where it fails or misses the tolerance, offset::contoured_offset (its report has no crossing pairs). Each
/// triangle is on the CAD face of the one from which it is offset, where those are known.
BooleanSurface offset_of_solid(const BooleanSurface& solid, const offset::OffsetOptions& options,
                               const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    offset::OffsetResult found = first_within(
        by_normals_of(solid, options),
        [&](const offset::OffsetOptions& how) { return offset::offset(solid.mesh, how, progress); },
        [&](const offset::OffsetOptions& how) { return offset::contoured_offset(solid.mesh, how, progress); });
    return reported(std::move(found), solid, options, before, watch, progress);
}

/// The points of a solid that are farther than a distance from its triangles that are not open
/// (offset::extend_openings), with report and CAD faces as in offset_of_solid. The result protrudes from the openings.
/// @return nothing where openings are not plane, or are in pockets that are too narrow
std::optional<BooleanSurface> hollow_beyond_openings(const BooleanSurface& solid, const std::vector<char>& open,
                                                     const offset::OffsetOptions& options, const WorkBefore& before,
                                                     Progress& progress) {
    options.validate();
    constexpr double kFlat = 0.1;  // fraction of the tolerance
    BooleanSurface extended;
    std::optional<mesh::TriangleMesh> mesh =
        offset::extend_openings(solid.mesh, open, {options.distance, kFlat * options.tolerance});
    if (!mesh) {
        return std::nullopt;
    }
    extended.mesh = std::move(*mesh);
    extended.corner_normals = solid.corner_normals;
    offset::OffsetOptions inward = options;
    inward.distance = -options.distance;
    inward.tolerance = (1.0 - kFlat) * options.tolerance;
    WorkBefore extending = before;
    extending.error_bound += kFlat * options.tolerance;
    return offset_of_solid(extended, inward, extending, progress);
}

/// All points within a distance of some triangles of a solid (offset::thicken, offset::contoured_walls), with report
/// and CAD faces as in offset_of_solid.
BooleanSurface thickened_walls(const BooleanSurface& solid, const std::vector<char>& left_out,
                               const offset::OffsetOptions& options, const WorkBefore& before, Progress& progress) {
    const Stopwatch watch;
    offset::OffsetResult found = first_within(
        by_normals_of(solid, options),
        [&](const offset::OffsetOptions& how) { return offset::thicken(solid.mesh, left_out, how, progress); },
        [&](const offset::OffsetOptions& how) { return offset::contoured_walls(solid.mesh, left_out, how, progress); });
    return reported(std::move(found), solid, options, before, watch, progress);
}

// Shares of the tolerance for the mesh of a shape, the union of its bodies, and cutting the hollow out; the offset has
// the rest.
constexpr double kChord = 0.15;
constexpr double kUnion = 0.05;
constexpr double kCutting = 0.05;
// Fractions of the progress at which the steps end: meshing, union, offset.
constexpr double kMeshed = 0.3;
constexpr double kUnited = 0.4;
constexpr double kOffset = 0.9;
/// Degrees, of the mesh of a shape: needles have short edges, where the raw offset gets many strips; larger bounds take
/// more triangles (docs/measurements/offset.md).
constexpr double kSmallestAngle = 1.0;

/// @throws InvalidInput where there are several or none
const GivenOperand& only_operand(const Operands& operands) {
    if (operands.given().size() != 1) {
        throw InvalidInput(phrases::kOneOperand, {{"count", operands.given().size()}});
    }
    return operands.given().front();
}

/// The state that the steps of an offset share.
class OffsetWork {
  public:
    OffsetWork(const Operands& operands, const OffsetShapeOptions& options, Progress& progress)
        : operands_(operands), options_(options), progress_(progress) {
        only_operand(operands);
        const double size = operands.size();
        const double distance = std::abs(options.distance);
        if (options_.tolerance <= 0.0) {
            // The default is relative to the size of the result: an offset outward is larger than the model.
            options_.tolerance = std::min(1e-3 * (size + 2.0 * std::max(options.distance, 0.0)), 0.1 * distance);
        }
        finest_ = boolean::kFinestTolerance * size;
        if (options_.tolerance > distance) {
            throw InvalidInput(phrases::kAboveDistance,
                               {{"length", in_mm(options_.tolerance, 6)}, {"length2", in_mm(distance, 6)}});
        }
    }

    /// Makes the union of the operand's bodies, on the faces of the shape.
    void unite(double min_angle) {
        OperandMeshing meshing;
        meshing.tolerance = 2.0 * kChord * options_.tolerance;
        meshing.min_angle = min_angle;
        meshing.threads = options_.threads;
        const MeshedOperands meshed = operands_.meshed(meshing, progress_, 0.0, kMeshed);
        BooleanOperand operand = meshed.operands.front();
        operand.shape = nullptr;  // offsets follow the normals of faces, and triangles stay plane
        {
            const ProgressShare part(progress_, operands_.any_shapes() ? kMeshed : 0.0, kUnited);
            WorkBefore before = meshed.work;
            before.notes.clear();
            solid_ = boolean_of({operand}, Operation::Union, kUnion, before);
        }
        name_faces(solid_, {operand.surface});
        add(solid_.figures);
        if (meshed.operands.front().shape != nullptr) {
            const ProgressShare part(progress_, kUnited, kUnited);
            const Stopwatch watch;
            solid_.corner_normals =
                corner_normals(operands_.engine(), solid_.mesh, *meshed.operands.front().shape, progress_);
            work_.seconds.emplace_back("reading the shape", watch.wall());
            work_.cpu_seconds += watch.cpu();
        }
        for (const Message& sentence : solid_.figures.repaired) {
            repaired_.push_back(sentence.places.back().content);  // without the name of the only operand
            work_.notes.push_back({phrases::kRepairedBefore, {{"list", repaired_.back()}}});
        }
    }

    /// @param last  whether no step follows
    BooleanSurface offset(bool last, double distance, double until) const {
        const ProgressShare part(progress_, kUnited, until);
        return offset_of_solid(solid_, left_for(distance), before(last), progress_);
    }

    BooleanSurface hollowed(const std::optional<std::vector<std::int32_t>>& openings) {
        bool cuts = true;  // whether `inside` is the hollow to be cut out; else it is the wall to be kept
        const BooleanSurface inside =
            openings ? inside_of(*openings, cuts) : offset(false, -options_.distance, kOffset);
        add(inside.figures);
        const bool is_whole = inside.mesh.triangles.empty();
        if (is_whole) {
            work_.notes.emplace_back(phrases::kNoHollow);
        } else if (!openings) {
            work_.notes.emplace_back(phrases::kHollowClosed);
        }
        std::vector<BooleanOperand> operands{{&solid_}};
        std::vector<const triangulate::Result*> surfaces{&solid_};
        if (!is_whole) {
            operands.push_back({&inside});
            surfaces.push_back(&inside);
        }
        const ProgressShare part(progress_, kOffset, 1.0);
        BooleanSurface result =
            boolean_of(operands, cuts ? Operation::Difference : Operation::Intersection, kCutting, before(true));
        name_faces(result, surfaces);
        return result;
    }

  private:
    BooleanSurface boolean_of(const std::vector<BooleanOperand>& operands, Operation operation, double share,
                              const WorkBefore& before) const {
        boolean::BooleanOptions options;
        options.tolerance = std::max(share * options_.tolerance, finest_);
        options.threads = options_.threads;
        return boolean_of_operands(operands_.engine(), operands,
                                   Expression::chain(operation, static_cast<int>(operands.size())), options,
                                   BooleanMethod::Exact, before, progress_);
    }

    /// The options of an offset with the tolerance that meshing, union and cutting have left.
    offset::OffsetOptions left_for(double distance) const {
        const double left = (1.0 - kUnion - kCutting) * options_.tolerance - work_.error_bound;
        if (left <= 0.0) {
            throw InvalidInput(phrases::kCoarseOperand,
                               {{"length", in_mm(work_.error_bound)}, {"length2", in_mm(options_.tolerance)}});
        }
        return {distance, left, options_.threads};
    }

    BooleanSurface inside_of(const std::vector<std::int32_t>& openings, bool& cuts) const {
        std::vector<char> open;
        for (const std::int32_t face : solid_.mesh.triangle_face) {
            open.push_back(std::find(openings.begin(), openings.end(), face) != openings.end() ? 1 : 0);
        }
        const offset::OffsetOptions options = left_for(options_.distance);
        if (std::find(open.begin(), open.end(), 0) == open.end()) {
            throw InvalidInput(phrases::kAllLeftOut);
        }
        // Plane openings are extended by prisms, so that the hollow is an offset inward. Elsewhere both sides of all
        // walls are offset, which takes many times as long.
        const ProgressShare part(progress_, kUnited, kOffset);
        std::optional<BooleanSurface> inside = hollow_beyond_openings(solid_, open, options, before(false), progress_);
        cuts = inside.has_value();
        return cuts ? std::move(*inside) : thickened_walls(solid_, open, options, before(false), progress_);
    }

    /// Adopts the error bound, times and notes of a step's report.
    void add(const BooleanReport& report) {
        work_.error_bound = report.error_bound;
        work_.seconds = report.seconds;
        work_.cpu_seconds = report.cpu_seconds;
        if (report.triangles > 0) {  // notes on an empty result do not concern the rest
            work_.notes = report.notes;
        }
    }

    WorkBefore before(bool last) const {
        WorkBefore before = work_;
        if (last) {
            before.repaired = repaired_;
            before.tolerance = options_.tolerance;
        }
        return before;
    }

    const Operands& operands_;
    OffsetShapeOptions options_;
    Progress& progress_;
    double finest_ = 0.0;
    BooleanSurface solid_;
    WorkBefore work_;
    std::vector<Message> repaired_;
};

}  // namespace

BooleanSurface offset_shape(const Operands& solid, const OffsetShapeOptions& options, Progress& progress) {
    OffsetWork work(solid, options, progress);
    work.unite(kSmallestAngle);
    return work.offset(true, options.distance, 1.0);
}

BooleanSurface hollow_shape(const Operands& solid, const std::optional<std::vector<std::int32_t>>& openings,
                            OffsetShapeOptions options, Progress& progress) {
    constexpr double kShareOfWall = 40.0;  // the thickness over the tolerance, where none is given
    if (!only_operand(solid).is_shape() && openings) {
        throw InvalidInput(phrases::kOpeningsOfMesh, {{"name", only_operand(solid).name}});
    }
    if (options.tolerance <= 0.0) {
        options.tolerance = options.distance / kShareOfWall;
    }
    OffsetWork work(solid, options, progress);
    work.unite(OperandMeshing().min_angle);
    return work.hollowed(openings);
}

}  // namespace mq::workflows
