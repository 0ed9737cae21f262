// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/boolean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/message.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "boolean/arrangement/soup.h"
#include "boolean/error_measure.h"
#include "boolean/extraction/extraction.h"
#include "boolean/input/operand_repair.h"
#include "boolean/input/tuning.h"
#include "boolean/near_coincidence/near_coincidence.h"
#include "boolean/rounding/snap_rounding.h"
#include "boolean/rounding/thin_shells.h"
#include "boolean/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/intersection/self_intersection.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/quality/surface_verification.h"
#include "option_ranges.h"

namespace mq::boolean {

namespace {

/// One Boolean operation: it holds the state that the stages share.
class BooleanPipeline {
  public:
    BooleanPipeline(const std::vector<const mesh::TriangleMesh*>& operands, const Expression& expression,
                    const BooleanOptions& options, Progress& progress)
        : inputs_(operands),
          expression_(expression),
          symmetric_(expression.chained() == Operation::SymmetricDifference),
          progress_(progress) {
        Box box;
        for (const mesh::TriangleMesh* mesh : operands) {
            for (const Vec3& p : mesh->vertices) {
                const Vec3 here = p + mesh->origin - operands.front()->origin;
                box.add(here);
                in_single_ = in_single_ && is_single(here);
            }
        }
        size_ = box.largest_side();
        tolerance_ = options.tolerance_for(size_);
        oriented_ = options.oriented;
    }

    /// Runs all stages. Returns nothing for a symmetric difference with common faces that do not coincide, which takes
    /// several runs.
    std::optional<BooleanResult> run() {
        prepare();
        make_soup();
        if (!find_crossings()) {
            return std::nullopt;
        }
        stages_.start("dividing", 0.5, 0.7);
        const Arrangement arrangement = arrange(soup_, twins_, crossing_, progress_);
        result_.crossing_pairs = crossing_.size();
        stages_.start("classifying", 0.7, 0.85);
        const Cells cells = find_cells(soup_, arrangement, progress_);
        result_.curve_edges = cells.curve_edges;
        stages_.start("extracting", 0.85, 0.9);
        Extraction extraction = extract(soup_, arrangement, cells, expression_, progress_);
        stages_.start("checking", 0.9, 1.0);
        finish(extraction);
        stages_.end();
        return std::move(result_);
    }

  private:
    /// The least distance by which common faces are moved beyond each other, mm.
    double clearance() const { return std::min(BooleanTuning::kClearance * size_, 0.25 * tolerance_); }

    void prepare() {
        stages_.start("inspecting", 0.0, 0.15);
        prepared_.resize(inputs_.size());
        parallel_for(static_cast<int>(inputs_.size()), [&](int k) {
            const auto i = static_cast<std::size_t>(k);
            prepared_[i] = prepare_operand(*inputs_[i], operand_name(i, inputs_.size()),
                                           InputTuning::kCrackShare * tolerance_, &progress_, oriented_);
        });
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            joined_ = std::max(joined_, prepared_[i].largest_move);
            result_.operand_topology.push_back(prepared_[i].topology);
            result_.repaired.push_back(prepared_[i].repairs.of_operand(operand_name(i, inputs_.size())));
        }
        require_possible(tolerance_, size_);
    }

    void make_soup() {
        soup_ = Soup();
        soup_.operands = static_cast<int>(prepared_.size());
        boxes_.assign(prepared_.size(), Box());
        const Vec3 origin = inputs_.front()->origin;
        for (std::size_t i = 0; i < prepared_.size(); ++i) {
            const auto first = static_cast<std::int32_t>(soup_.vertices.size());
            const Vec3 shift = inputs_[i]->origin - origin;
            for (const Vec3& p : prepared_[i].vertices) {
                soup_.vertices.emplace_back(shift.isZero() ? p : Vec3(p + shift));
                boxes_[i].add(soup_.vertices.back());
            }
            for (std::size_t t = 0; t < prepared_[i].triangles.size(); ++t) {
                const Triangle& c = prepared_[i].triangles[t];
                soup_.triangles.push_back({c[0] + first, c[1] + first, c[2] + first});
                const std::int32_t own = prepared_[i].source[t];
                soup_.source.push_back({static_cast<std::int32_t>(i), unchanged(i, t) ? own : -1, own});
            }
        }
    }

    /// Whether a triangle of a prepared operand has the same corners as the input's triangle from which it comes.
    bool unchanged(std::size_t operand, std::size_t t) const {
        const Operand& own = prepared_[operand];
        return !own.repairs.any() || has_corners_of(own, t, *inputs_[operand]);
    }

    /// Pairs of triangles in contact; coincident triangles are left out.
    /// @param search  over the soup as it is; none: the soup has changed
    std::vector<std::array<std::int32_t, 2>> contacts(std::optional<mesh::SelfIntersectionSearch>& search) const {
        std::vector<Triangle> others;
        std::vector<std::int32_t> index;
        if (!twins_.empty()) {
            std::vector<char> twin(soup_.triangles.size(), 0);
            for (const CoincidentTriangle& t : twins_) {
                twin[static_cast<std::size_t>(t.triangle)] = 1;
            }
            for (std::size_t t = 0; t < twin.size(); ++t) {
                if (twin[t] == 0) {
                    others.push_back(soup_.triangles[t]);
                    index.push_back(static_cast<std::int32_t>(t));
                }
            }
            search.emplace(soup_.vertices, others, &progress_);
        } else if (!search) {
            search.emplace(soup_.vertices, soup_.triangles, &progress_);
        }
        std::vector<std::array<std::int32_t, 2>> result;
        const auto own = [&](std::int32_t t) { return index.empty() ? t : index[static_cast<std::size_t>(t)]; };
        for (const mesh::ContactPair& pair : search->pairs()) {
            result.push_back({own(pair.a), own(pair.b)});
        }
        return result;
    }

    void merge() {
        forget_moved_triangles(soup_);
        progress_.check();
        merge_vertices(soup_, boxes_);
        progress_.check();
        twins_ = find_twins(soup_);
        progress_.check();
    }

    bool find_crossings() {
        stages_.start("finding contacts", 0.15, 0.25);
        merge();
        std::optional<mesh::SelfIntersectionSearch> crossings;
        crossings.emplace(soup_.vertices, soup_.triangles, &progress_);
        const FacingSearch search(soup_, crossings->tree(), 2.0 * tolerance_, progress_);
        const std::vector<ContactFace> faces = contact_faces(soup_, search, twins_, tolerance_, clearance(), progress_);
        if (std::any_of(faces.begin(), faces.end(), differs)) {
            // In a symmetric difference moving faces to either side would be wrong.
            if (symmetric_) {
                return false;
            }
            make_soup();  // now operands share no vertices
            const std::vector<Vec3> before = soup_.vertices;
            const NearCoincidence done =
                overlap_contacts(soup_, search, expression_, faces, {tolerance_, clearance()}, progress_);
            result_.separated_vertices = done.moved;
            moved_ = done.largest;
            for (const ContactFace& face : faces) {
                result_.closed_gaps = std::max({result_.closed_gaps, std::abs(face.low), std::abs(face.high)});
            }
            mark_contacts(faces);
            if (moved_ > 4.0 * clearance()) {
                result_.notes.push_back({phrases::kTakenAsOne, {{"length", in_mm(result_.closed_gaps, 2)}}});
            }
            undo_degenerate_moves(soup_, before);
            boxes_ = operand_boxes(soup_);
            merge();
            crossings.reset();
        }
        stages_.start("finding crossings", 0.25, 0.5);
        crossing_ = contacts(crossings);
        merge_touching(soup_, crossing_);
        return true;
    }

    bool an_operand_crosses_itself() const {
        return std::any_of(crossing_.begin(), crossing_.end(), [&](const std::array<std::int32_t, 2>& pair) {
            const auto operand = [&](std::int32_t t) { return soup_.source[static_cast<std::size_t>(t)].operand; };
            return operand(pair[0]) == operand(pair[1]);
        });
    }

    /// Marks the triangles of common faces, and those that share their moved vertices.
    void mark_contacts(const std::vector<ContactFace>& faces) {
        in_contact_.assign(soup_.triangles.size(), 0);
        for (const ContactFace& face : faces) {
            in_contact_[static_cast<std::size_t>(face.earlier)] = in_contact_[static_cast<std::size_t>(face.later)] = 1;
        }
        for (std::size_t t = 0; t < in_contact_.size(); ++t) {
            const Triangle& c = soup_.triangles[t];
            if (std::any_of(c.begin(), c.end(), [&](int v) { return soup_.moved[static_cast<std::size_t>(v)] != 0; })) {
                in_contact_[t] = 1;
            }
        }
    }

    void finish(Extraction& extraction) {
        ResultMesh& draft = extraction.draft;
        RoundingCount rounded = snap_round(extraction, {size_, tolerance_, in_single_}, progress_);
        if (moved_ > 0.0 || an_operand_crosses_itself()) {
            remove_thin_shells(draft, soup_, in_contact_, {result_.closed_gaps, 0.5 * rounded.unit});
        }
        result_.separated_contacts = rounded.separated;
        result_.faults_left = rounded.faulty.empty() ? nonmanifold(draft).size() : rounded.faulty.size();
        result_.error_bound = rounded.error_bound + joined_;
        result_.mesh.origin = inputs_.front()->origin;
        result_.mesh.vertices = std::move(draft.vertices);
        result_.mesh.triangles = std::move(draft.triangles);
        for (const Source& source : draft.source) {
            const bool own = source.operand >= 0 && source.triangle >= 0;
            result_.triangle_source.push_back(own ? std::array<std::int32_t, 2>{source.operand, source.triangle}
                                                  : std::array<std::int32_t, 2>{-1, -1});
            ++(own ? result_.retained : result_.reconstructed);
        }
        result_source_ = draft.from;
        for (const std::int32_t from : draft.from) {
            const Source& source = soup_.source[static_cast<std::size_t>(from)];
            const bool known = source.moved_from >= 0;
            result_.triangle_origin.push_back(known ? std::array<std::int32_t, 2>{source.operand, source.moved_from}
                                                    : std::array<std::int32_t, 2>{-1, -1});
        }
        if (moved_ > 0.0) {
            result_.error_bound += error_of_moves();
        }
    }

    /// The distance of the result, mm, from the exact Boolean of the operands before common faces were moved, except
    /// for closed gaps and slivers.
    double error_of_moves() const {
        std::vector<std::vector<Vec3>> places(prepared_.size());
        std::vector<EnclosedOperand> enclosed(prepared_.size());
        for (std::size_t i = 0; i < prepared_.size(); ++i) {
            for (const Vec3& p : prepared_[i].vertices) {
                places[i].emplace_back(p + inputs_[i]->origin - inputs_.front()->origin);
            }
            enclosed[i].vertices = &places[i];
            enclosed[i].triangles = &prepared_[i].triangles;
        }
        MovedOperands moved;
        moved.reach = 2.0 * moved_;
        moved.source = result_source_;
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
            moved.triangles.push_back(corners(soup_, static_cast<std::int32_t>(t)));
        }
        // Distances below a twentieth of the tolerance are not told apart. A gap is at most 3^0.5 times as wide along
        // an axis as along its normal.
        const ErrorLimits limits{tolerance_, 0.05 * tolerance_, 1.75 * result_.closed_gaps};
        return measure_error(enclosed, expression_, result_.mesh, {}, limits, progress_, &moved).largest();
    }

    /// The triangles of the soup with pieces at nonmanifold edges or vertices. The result that is returned is the one
    /// that was verified. Contacts were searched while it was rounded.
    std::set<std::int32_t> nonmanifold(const ResultMesh& draft) {
        const std::vector<std::int32_t> no_contacts;
        constexpr std::size_t kAllFaults = std::numeric_limits<std::size_t>::max();
        std::set<std::int32_t> result;
        for (const mesh::Fault& fault :
             mesh::verify(draft.vertices, draft.triangles, &no_contacts, kAllFaults, &progress_).faults) {
            for (const std::int32_t t : fault.triangles) {
                if (t >= 0) {
                    result.insert(draft.from[static_cast<std::size_t>(t)]);
                }
            }
        }
        return result;
    }

    const std::vector<const mesh::TriangleMesh*> inputs_;
    const Expression expression_;
    const bool symmetric_;  ///< a chain of symmetric differences
    Progress& progress_;
    bool oriented_ = false;  ///< see BooleanOptions
    BooleanResult result_;
    double size_ = 0.0;
    bool in_single_ = true;  ///< all vertices of the operands are single-precision numbers
    double tolerance_ = 0.0;
    double moved_ = 0.0;
    std::vector<char> in_contact_;             ///< for each triangle of the soup, where common faces were moved
    std::vector<std::int32_t> result_source_;  ///< for each triangle of the result the triangle of the soup
    double joined_ = 0.0;                      ///< how far operands were moved where cracks were closed, mm
    std::vector<Operand> prepared_;
    Soup soup_;
    std::vector<Box> boxes_;  ///< boxes that contain the operands
    std::vector<CoincidentTriangle> twins_;
    std::vector<std::array<std::int32_t, 2>> crossing_;
    WatchedStageTimer stages_{progress_, result_.seconds};
};

/// The symmetric difference of operands with common faces, one operand after the other: the union of both
/// differences of the result and the next operand. Each difference leaves out the slivers between the surfaces.
BooleanResult join_differences(const std::vector<const mesh::TriangleMesh*>& operands, const BooleanOptions& options,
                               Progress& progress) {
    const Expression less = Expression::chain(Operation::Difference, 2);
    BooleanResult sum;
    sum.mesh = *operands.front();
    for (std::size_t t = 0; t < sum.mesh.triangles.size(); ++t) {
        sum.triangle_source.push_back({0, static_cast<std::int32_t>(t)});
    }
    sum.triangle_origin = sum.triangle_source;
    for (std::size_t k = 1; k < operands.size(); ++k) {
        const BooleanResult one = *BooleanPipeline({&sum.mesh, operands[k]}, less, options, progress).run();
        const BooleanResult two = *BooleanPipeline({operands[k], &sum.mesh}, less, options, progress).run();
        std::vector<const mesh::TriangleMesh*> parts;
        std::vector<const BooleanResult*> part_results;
        for (const BooleanResult* part : {&one, &two}) {
            if (!part->mesh.triangles.empty()) {
                parts.push_back(&part->mesh);
                part_results.push_back(part);
            }
        }
        BooleanResult joined =
            parts.empty() ? BooleanResult()
                          : *BooleanPipeline(parts, Expression::chain(Operation::Union, static_cast<int>(parts.size())),
                                             options, progress)
                                 .run();
        for (const auto list : {&BooleanResult::triangle_source, &BooleanResult::triangle_origin}) {
            for (std::array<std::int32_t, 2>& source : joined.*list) {
                if (source[0] >= 0) {
                    const BooleanResult& part = *part_results[static_cast<std::size_t>(source[0])];
                    const bool swapped = &part == &two;
                    source = (part.*list)[static_cast<std::size_t>(source[1])];
                    if (source[0] >= 0) {
                        const bool of_sum = (source[0] == 0) != swapped;
                        source = of_sum ? (sum.*list)[static_cast<std::size_t>(source[1])]
                                        : std::array<std::int32_t, 2>{static_cast<std::int32_t>(k), source[1]};
                    }
                }
            }
        }
        joined.error_bound += std::max(one.error_bound, two.error_bound) + sum.error_bound;
        joined.closed_gaps = std::max({joined.closed_gaps, one.closed_gaps, two.closed_gaps, sum.closed_gaps});
        joined.separated_vertices += one.separated_vertices + two.separated_vertices + sum.separated_vertices;
        joined.separated_contacts += sum.separated_contacts;
        joined.repaired = one.repaired;
        sum = std::move(joined);
    }
    sum.retained = static_cast<std::size_t>(std::count_if(sum.triangle_source.begin(), sum.triangle_source.end(),
                                                          [](const auto& source) { return source[0] >= 0; }));
    sum.reconstructed = sum.mesh.triangles.size() - sum.retained;
    sum.operand_topology.clear();  // the runs counted components of partial results
    return sum;
}

}  // namespace

double BooleanOptions::tolerance_for(double size) const {
    return tolerance > 0.0 ? tolerance : std::sqrt(3.0) * (length > 0.0 ? length : size) / resolution;
}

void require_possible(double tolerance, double size) {
    if (tolerance < kFinestTolerance * size) {
        throw InvalidInput(phrases::kFineTolerance,
                           {{"length", in_mm(tolerance)}, {"length2", in_mm(kFinestTolerance * size)}});
    }
}

void BooleanOptions::validate() const {
    ranges::boolean::kTolerance.require(tolerance);
    ranges::boolean::kResolution.require(resolution);
    ranges::boolean::kThreads.require(threads);
}

BooleanResult boolean(const std::vector<const mesh::TriangleMesh*>& operands, Operation operation,
                      const BooleanOptions& options, Progress* progress) {
    return boolean(operands, Expression::chain(operation, static_cast<int>(operands.size())), options, progress);
}

BooleanResult boolean(const std::vector<const mesh::TriangleMesh*>& operands, const Expression& expression,
                      const BooleanOptions& options, Progress* progress) {
    options.validate();
    const ThreadLimit threads(options.threads);
    if (operands.empty()) {
        throw InvalidInput(phrases::kNoOperands);
    }
    if (expression.operands() != operands.size()) {
        throw InvalidInput(phrases::kExpressionOperands,
                           {{"count", operands.size()}, {"count2", expression.operands()}});
    }
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    const bool symmetric = expression.chained() == Operation::SymmetricDifference;
    std::optional<BooleanResult> result = BooleanPipeline(operands, expression, options, watched).run();
    if (symmetric && (!result || result->faults_left > 0)) {
        result = join_differences(operands, options, watched);
    }
    if (result->faults_left > 0) {
        throw TopologyError(counted(phrases::kResultNotHeld, result->faults_left));
    }
    return std::move(*result);
}

}  // namespace mq::boolean
