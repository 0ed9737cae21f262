// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/boolean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "boolean/arrangement.h"
#include "boolean/cells.h"
#include "boolean/disturbance.h"
#include "boolean/extraction.h"
#include "boolean/near_coincidence.h"
#include "boolean/operand.h"
#include "boolean/parting.h"
#include "boolean/repair.h"
#include "boolean/soup.h"
#include "mesh/report.h"
#include "mesh/self_intersection.h"

namespace mq::boolean {

namespace {

constexpr double kSingleUnit = std::numeric_limits<float>::epsilon();
// Faces this near to each other, as a part of the size, are meant to lie in one plane.
constexpr double kFlush = 8.0 * kSingleUnit;

/// With two digits.
std::string in_short(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", length);
    return text;
}

/// One Boolean on its way through the stages.
class Run {
  public:
    Run(const std::vector<const mesh::TriangleMesh*>& operands, Operation operation, const BooleanOptions& options,
        Progress& progress, bool no_slivers)
        : inputs_(operands), operation_(operation), progress_(progress), no_slivers_(no_slivers) {
        Box box;
        for (const mesh::TriangleMesh* mesh : operands) {
            for (const Vec3& p : mesh->vertices) {
                box.add(p + mesh->origin - operands.front()->origin);
            }
        }
        size_ = box.largest_side();
        tolerance_ = options.tolerance > 0.0 ? options.tolerance : std::sqrt(3.0) * size_ / options.resolution;
    }

    /// Nothing for a symmetric difference of surfaces that run along each other: it takes several runs.
    std::optional<BooleanResult> run() {
        prepare();
        const BooleanResult prepared = result_;
        std::optional<BooleanResult> best;
        for (std::size_t k = 0; k <= kTries; ++k) {
            result_ = prepared;
            if (!run_once()) {
                return std::nullopt;
            }
            if (!best.has_value() || result_.faults_left < best->faults_left) {
                best = std::move(result_);
            }
            if (best->faults_left == 0) {
                break;
            }
            jolts_.push_back(std::move(faulty_));
        }
        return best;
    }

  private:
    /// Further tries after one that left faults, each with the operands moved a little more where these are.
    static constexpr std::size_t kTries = 6;

    bool run_once() {
        make_soup();
        if (!find_crossings()) {
            return false;
        }
        stage("dividing", 0.5, 0.7);
        const Arrangement arrangement = arrange(soup_, twins_, crossing_, progress_);
        result_.crossing_pairs = crossing_.size();
        stage("classifying", 0.7, 0.85);
        const Cells cells = find_cells(soup_, arrangement, progress_);
        result_.curve_edges = cells.curve_edges;
        stage("extracting", 0.85, 0.9);
        Extraction extraction = extract(soup_, arrangement, cells, operation_, progress_);
        stage("checking", 0.9, 1.0);
        finish(extraction);
        end_stage();
        return true;
    }

    /// Moves operands a little where tries so far left faults; by how much at most, mm.
    double disturb() {
        if (jolts_.empty()) {
            return 0.0;
        }
        constexpr double kFirst = 16.0 * kSingleUnit;  // of the size
        constexpr double kMore = 4.0;
        constexpr double kMost = 0.08;  // of the tolerance, so that all tries together stay within it
        double length = kFirst * size_;
        double sum = 0.0;
        for (std::size_t k = 0; k < jolts_.size(); ++k) {
            sum += jolt(soup_, jolts_[k], std::min(length, kMost * tolerance_), k);
            length *= kMore;
        }
        const auto count = [](std::size_t n, const std::vector<std::int32_t>& list) { return n + list.size(); };
        result_.notes.push_back(
            "operands were moved by up to " + in_short(sum) + " mm at " +
            mesh::counted(std::accumulate(jolts_.begin(), jolts_.end(), std::size_t{0}, count), "triangle") +
            ", where rounding left faults otherwise");
        return sum;
    }

    /// How far faces that were meant to lie in one plane are put apart, mm.
    double clearance() const { return std::min(4.0 * kFlush * size_, 0.25 * tolerance_); }

    void stage(const char* name, double from, double to) {
        end_stage();
        stage_ = name;
        progress_.stage(name, from, to);
        progress_.check();
    }
    void end_stage() {
        if (stage_ != nullptr) {
            clock_.end(stage_);
        }
        stage_ = nullptr;
    }

    void prepare() {
        stage("inspecting", 0.0, 0.15);
        prepared_.resize(inputs_.size());
        for_all(static_cast<int>(inputs_.size()), [&](int k) {
            const auto i = static_cast<std::size_t>(k);
            prepared_[i] = prepare_operand(*inputs_[i], operand_name(i, inputs_.size()), &progress_);
        });
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            const Repairs& repairs = prepared_[i].repairs;
            result_.repaired.push_back(repairs.any() ? operand_name(i, inputs_.size()) + ": " + repairs.summary()
                                                     : std::string());
        }
        if (tolerance_ < 4.0 * kSingleUnit * size_) {
            throw InvalidInput("tolerance is " + mesh::in_three_digits(tolerance_) +
                               " mm: single precision holds these operands to " +
                               mesh::in_three_digits(4.0 * kSingleUnit * size_) + " mm only; choose a larger value");
        }
    }

    void make_soup() {
        soup_ = Soup();
        soup_.operands = static_cast<int>(prepared_.size());
        const Vec3 origin = inputs_.front()->origin;
        for (std::size_t i = 0; i < prepared_.size(); ++i) {
            const auto first = static_cast<std::int32_t>(soup_.vertices.size());
            const Vec3 shift = inputs_[i]->origin - origin;
            for (const Vec3& p : prepared_[i].vertices) {
                soup_.vertices.emplace_back(shift.isZero() ? p : Vec3(p + shift));
            }
            for (std::size_t t = 0; t < prepared_[i].triangles.size(); ++t) {
                const Triangle& c = prepared_[i].triangles[t];
                soup_.triangles.push_back({c[0] + first, c[1] + first, c[2] + first});
                soup_.source.push_back({static_cast<std::int32_t>(i), unchanged(i, t) ? prepared_[i].source[t] : -1});
            }
        }
    }

    /// Whether a triangle of a prepared operand has the corners of the input's triangle from which it comes.
    bool unchanged(std::size_t operand, std::size_t t) const {
        const Operand& own = prepared_[operand];
        if (!own.repairs.any()) {
            return true;
        }
        const mesh::TriangleMesh& input = *inputs_[operand];
        const std::int32_t source = own.source[t];
        const auto is_corner = [&](std::int32_t v) {
            const Triangle& c = input.triangles[static_cast<std::size_t>(source)];
            return std::any_of(c.begin(), c.end(), [&](std::int32_t w) {
                return input.vertices[static_cast<std::size_t>(w)] == own.vertices[static_cast<std::size_t>(v)];
            });
        };
        return source >= 0 && std::all_of(own.triangles[t].begin(), own.triangles[t].end(), is_corner);
    }

    /// Pairs of triangles in contact, at most `limit` of them; twins are left out.
    std::vector<mesh::ContactPair> contacts(std::size_t limit, mesh::FlushPairs* flush = nullptr) {
        forget_moved_triangles(soup_);
        merge_vertices(soup_);
        twins_ = find_twins(soup_);
        if (twins_.empty()) {
            if (flush != nullptr) {
                for (const Source& source : soup_.source) {
                    flush->body.push_back(source.operand);
                }
            }
            return mesh::self_intersections(soup_.vertices, soup_.triangles, limit, &progress_, flush);
        }
        std::vector<char> twin(soup_.triangles.size(), 0);
        for (const Twin& t : twins_) {
            twin[static_cast<std::size_t>(t.triangle)] = 1;
        }
        std::vector<Triangle> others;
        std::vector<std::int32_t> index;
        for (std::size_t t = 0; t < twin.size(); ++t) {
            if (twin[t] == 0) {
                if (flush != nullptr) {
                    flush->body.push_back(soup_.source[t].operand);
                }
                others.push_back(soup_.triangles[t]);
                index.push_back(static_cast<std::int32_t>(t));
            }
        }
        auto pairs = mesh::self_intersections(soup_.vertices, others, limit, &progress_, flush);
        for (mesh::ContactPair& pair : pairs) {
            pair.a = index[static_cast<std::size_t>(pair.a)];
            pair.b = index[static_cast<std::size_t>(pair.b)];
        }
        if (flush != nullptr) {
            for (auto* found : {&flush->over, &flush->beside}) {
                for (std::array<std::int32_t, 2>& pair : *found) {
                    pair = {index[static_cast<std::size_t>(pair[0])], index[static_cast<std::size_t>(pair[1])]};
                }
            }
        }
        return pairs;
    }

    bool find_crossings() {
        stage("finding crossings", 0.15, 0.5);
        crossing_.clear();
        moved_ = 0.0;
        // Curves cross few triangles. When many are crossed a sample shows whether surfaces run along each other.
        const std::size_t many = std::max<std::size_t>(20'000, soup_.triangles.size() / 8);
        mesh::FlushPairs flush{kFlush * size_, {}, {}, {}};
        std::vector<mesh::ContactPair> pairs = contacts(many, &flush);
        const bool along = run_along(soup_, pairs, no_slivers_);
        if (along && operation_ == Operation::SymmetricDifference) {
            return false;
        }
        // Of a symmetric difference either way would be wrong.
        const bool flushed = !flush.over.empty() && operation_ != Operation::SymmetricDifference;
        const bool moves = along || flushed || !jolts_.empty();
        if (moves) {
            make_soup();
            const std::vector<Vec3> before = soup_.vertices;
            NearCoincidence done;
            if (along) {
                done = separate(soup_, operation_, tolerance_, pairs, progress_);
            } else if (flushed) {
                done = separate_flush(soup_, operation_, flush, clearance());
            }
            result_.separated_vertices = done.moved;
            moved_ = done.largest + disturb();
            if (along && done.moved > 0) {
                result_.notes.push_back("surfaces that nearly coincide were separated: slivers and gaps up to " +
                                        in_short(2.0 * moved_) + " mm thin may be gone");
            }
            undo_degenerate_moves(soup_, before);
        }
        if (moves || pairs.size() == many) {
            pairs = contacts(mesh::kAllPairs);
        }
        for (const mesh::ContactPair& pair : pairs) {
            crossing_.push_back({pair.a, pair.b});
        }
        merge_touching(soup_, crossing_);
        return true;
    }

    void finish(Extraction& extraction) {
        constexpr double kRepairPart = 1e-4;  // of the size
        Draft& draft = extraction.draft;
        const bool in_single = std::all_of(soup_.vertices.begin(), soup_.vertices.end(), is_single);
        part(extraction, in_single);
        result_.parted_contacts = extraction.copies.size();
        const RepairCount repaired = repair(draft, std::min(tolerance_, kRepairPart * size_), progress_);
        result_.faults_left = repaired.faulty.size();
        faulty_.clear();
        for (const std::int32_t t : repaired.faulty) {
            faulty_.push_back(draft.from[static_cast<std::size_t>(t)]);
        }
        if (repaired.flakes > 0) {
            result_.notes.push_back("left out, as they are thinner than single precision can hold: " +
                                    mesh::counted(repaired.flakes, "separate piece"));
        }
        if (result_.faults_left > 0) {
            result_.notes.push_back("no repair helps where rounding made triangles touch or cross others: " +
                                    mesh::counted(result_.faults_left, "triangle"));
        }
        result_.error_bound = draft.largest_move + moved_;
        result_.mesh.origin = inputs_.front()->origin;
        result_.mesh.vertices = std::move(draft.vertices);
        result_.mesh.triangles = std::move(draft.triangles);
        for (const Source& source : draft.source) {
            const bool own = source.operand >= 0 && source.triangle >= 0;
            result_.triangle_source.push_back(own ? std::array<std::int32_t, 2>{source.operand, source.triangle}
                                                  : std::array<std::int32_t, 2>{-1, -1});
            ++(own ? result_.retained : result_.reconstructed);
        }
    }

    /// Parts contacts in the way that leaves the fewest faults; repair may choose another one for single vertices.
    void part(Extraction& extraction, bool in_single) {
        constexpr double kPartOfSize = 1e-5;
        Draft& draft = extraction.draft;
        const double least = 8.0 * kSingleUnit * size_;
        PartingPlan plan = plan_parting(extraction, kPartOfSize * size_, std::min(least, tolerance_), tolerance_);
        if (in_single) {
            round_to_single(draft);
            for (std::vector<Vec3>& places : plan.variants) {
                std::transform(places.begin(), places.end(), places.begin(), to_single);
            }
        }
        std::size_t fewest = std::numeric_limits<std::size_t>::max();
        Draft best;
        for (std::size_t k = 0; k < plan.variants.size() && fewest > 0; ++k) {
            Draft trial = draft;
            move_copies(trial, plan, k);
            const std::size_t faults = count_parting_faults(trial, progress_);
            if (faults < fewest) {
                fewest = faults;
                best = std::move(trial);
            }
        }
        if (!plan.copies.empty()) {
            draft = std::move(best);
        }
        for (std::size_t i = 0; i < plan.copies.size() && fewest > 0; ++i) {
            for (const std::vector<Vec3>& places : plan.variants) {
                draft.places[plan.copies[i]].push_back(places[i]);
            }
        }
    }

    const std::vector<const mesh::TriangleMesh*> inputs_;
    Operation operation_;
    Progress& progress_;
    bool no_slivers_;  ///< however few
    BooleanResult result_;
    double size_ = 0.0;
    double tolerance_ = 0.0;
    double moved_ = 0.0;
    std::vector<std::vector<std::int32_t>> jolts_;  ///< triangles of the soup at the faults of each try so far
    std::vector<std::int32_t> faulty_;              ///< at the faults of this one
    std::vector<Operand> prepared_;
    Soup soup_;
    std::vector<Twin> twins_;
    std::vector<std::array<std::int32_t, 2>> crossing_;
    const char* stage_ = nullptr;
    StageClock clock_{result_.seconds};
};

/// The symmetric difference of operands whose surfaces run along each other, one operand after the other: what is in
/// the one but not in the other, joined with what is in the other but not in the one. Each difference leaves out the
/// slivers between the surfaces.
BooleanResult join_differences(const std::vector<const mesh::TriangleMesh*>& operands, const BooleanOptions& options,
                               Progress& progress) {
    BooleanResult sum;
    sum.mesh = *operands.front();
    for (std::size_t t = 0; t < sum.mesh.triangles.size(); ++t) {
        sum.triangle_source.push_back({0, static_cast<std::int32_t>(t)});
    }
    for (std::size_t k = 1; k < operands.size(); ++k) {
        const BooleanResult one = *Run({&sum.mesh, operands[k]}, Operation::Difference, options, progress, true).run();
        const BooleanResult two = *Run({operands[k], &sum.mesh}, Operation::Difference, options, progress, true).run();
        std::vector<const mesh::TriangleMesh*> parts;
        std::vector<const BooleanResult*> part_results;
        for (const BooleanResult* part : {&one, &two}) {
            if (!part->mesh.triangles.empty()) {
                parts.push_back(&part->mesh);
                part_results.push_back(part);
            }
        }
        BooleanResult joined =
            parts.empty() ? BooleanResult() : *Run(parts, Operation::Union, options, progress, true).run();
        for (std::array<std::int32_t, 2>& source : joined.triangle_source) {
            if (source[0] >= 0) {
                const BooleanResult& part = *part_results[static_cast<std::size_t>(source[0])];
                const bool swapped = &part == &two;
                source = part.triangle_source[static_cast<std::size_t>(source[1])];
                if (source[0] >= 0) {
                    const bool of_sum = (source[0] == 0) != swapped;
                    source = of_sum ? sum.triangle_source[static_cast<std::size_t>(source[1])]
                                    : std::array<std::int32_t, 2>{static_cast<std::int32_t>(k), source[1]};
                }
            }
        }
        joined.error_bound += std::max(one.error_bound, two.error_bound) + sum.error_bound;
        joined.separated_vertices += one.separated_vertices + two.separated_vertices + sum.separated_vertices;
        joined.parted_contacts += sum.parted_contacts;
        joined.repaired = one.repaired;
        sum = std::move(joined);
    }
    sum.retained = static_cast<std::size_t>(std::count_if(sum.triangle_source.begin(), sum.triangle_source.end(),
                                                          [](const auto& source) { return source[0] >= 0; }));
    sum.reconstructed = sum.mesh.triangles.size() - sum.retained;
    return sum;
}

}  // namespace

void BooleanOptions::validate() const {
    if (!(tolerance >= 0.0) || !std::isfinite(tolerance)) {
        throw InvalidInput("tolerance is " + std::to_string(tolerance) + ": it must be a positive length in mm");
    }
    if (resolution < 8 || resolution > 65536) {
        throw InvalidInput("resolution is " + std::to_string(resolution) + ": it must be from 8 to 65536");
    }
}

BooleanResult boolean(const std::vector<const mesh::TriangleMesh*>& operands, Operation operation,
                      const BooleanOptions& options, Progress* progress) {
    options.validate();
    if (operands.empty()) {
        throw InvalidInput("a Boolean without operands: give at least one mesh");
    }
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    const bool symmetric = operation == Operation::SymmetricDifference;
    std::optional<BooleanResult> result = Run(operands, operation, options, watched, symmetric).run();
    if (symmetric && (!result || result->faults_left > 0)) {
        BooleanResult joined = join_differences(operands, options, watched);
        if (!result || joined.faults_left < result->faults_left) {
            return joined;
        }
    }
    return std::move(*result);
}

}  // namespace mq::boolean
