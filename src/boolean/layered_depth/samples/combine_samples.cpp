// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/samples/combine_samples.h"

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/parallel.h"

namespace mq::boolean {

namespace {

struct Sample {
    double depth;
    std::int32_t source;
    SampleNormal normal;
};

/// Combines the operands' samples along one ray after the other.
class RayMerger {
  public:
    RayMerger(const CombineOptions& options, const OperandPair& pair, bool with_normals)
        : options_(options), pair_(pair), with_normals_(with_normals) {}

    /// Appends the samples of the result.
    void merge(const std::array<const LayeredDepthImage*, 2>& operands, std::size_t ray, std::vector<Sample>& out);
    /// The operand whose entries and exits on the last ray do not balance, or -1.
    int unbalanced() const { return index_[0] != 0 ? 0 : index_[1] != 0 ? 1 : -1; }

  private:
    bool inside() const {
        const auto in = [&](int k) { return options_.normal_index ? index_[k] > 0 : parity_[k]; };
        return in_result(options_.operation, in(0), in(1));
    }
    /// A sample of an operand by its index; kNone for none.
    std::uint32_t in_contact(const LayeredDepthImage& other, int operand, double depth, bool enters) const;
    std::int32_t source_of(const LayeredDepthImage& image, std::uint32_t i, bool reversed) const {
        return 2 * image.triangle(i) + (reversed ? 1 : 0);
    }
    SampleNormal normal_of(const LayeredDepthImage& image, std::uint32_t i) const {
        if (!with_normals_) {
            return SampleNormal::Zero();
        }
        return image.normal.empty() ? SampleNormal(pair_.unit_normal(image.triangle(i)).cast<float>())
                                    : image.normal[i];
    }

    static constexpr std::uint32_t kNone = 0xffffffff;

    const CombineOptions& options_;
    const OperandPair& pair_;
    bool with_normals_;
    std::array<int, 2> index_{};
    std::array<bool, 2> parity_{};
    std::array<std::uint32_t, 2> begin_{}, at_{}, end_{};
    std::vector<int> operand_;  // the operand whose triangle each sample of the ray has
};

/// The sample of an operand in contact with one of the other at `depth` that is oriented the same way; kNone when there
/// is none.
std::uint32_t RayMerger::in_contact(const LayeredDepthImage& other, int operand, double depth, bool enters) const {
    const bool reversed = options_.operation == Operation::Difference && operand == 1;
    std::uint32_t i = at_[operand];
    while (i > begin_[operand] && other.depth[i - 1] >= depth - options_.thinnest) {
        --i;
    }
    for (; i < end_[operand] && other.depth[i] <= depth + options_.thinnest; ++i) {
        const bool turns_in = (other.code[i] >= 0) != reversed;
        if (turns_in == enters) {
            return i;
        }
    }
    return kNone;
}

void RayMerger::merge(const std::array<const LayeredDepthImage*, 2>& operands, std::size_t ray,
                      std::vector<Sample>& out) {
    for (int k = 0; k < 2; ++k) {
        begin_[k] = at_[k] = operands[k]->begin[ray];
        end_[k] = operands[k]->begin[ray + 1];
    }
    index_ = {};
    parity_ = {};
    operand_.clear();
    const auto next_depth = [&](int k) { return at_[k] < end_[k] ? operands[k]->depth[at_[k]] : 1e300; };
    while (at_[0] < end_[0] || at_[1] < end_[1]) {
        const int k = next_depth(0) <= next_depth(1) ? 0 : 1;
        const double depth = next_depth(k);
        std::uint32_t chosen = at_[k]++;
        const std::int32_t code = operands[k]->code[chosen];
        const bool before = inside();
        index_[k] += code < 0 ? -1 : 1;
        parity_[k] = !parity_[k];
        if (inside() == before) {
            continue;
        }
        std::int32_t source = source_of(*operands[k], chosen, (code >= 0) == before);
        int operand = k;
        if (options_.operation != Operation::SymmetricDifference) {
            const std::uint32_t other = in_contact(*operands[1 - k], 1 - k, depth, !before);
            const bool reversed = options_.operation == Operation::Difference && k == 0;
            if (other != kNone && source_of(*operands[1 - k], other, reversed) < source) {
                source = source_of(*operands[1 - k], other, reversed);
                operand = 1 - k;
                chosen = other;
            }
        }
        if (!operand_.empty() && operand_.back() != operand && depth - out.back().depth <= options_.thinnest) {
            operand_.pop_back();
            out.pop_back();
            continue;
        }
        operand_.push_back(operand);
        out.push_back({depth, source, normal_of(*operands[operand], chosen)});
    }
}

[[noreturn]] void fail_unbalanced(int operand, int axis, std::size_t ray, const SampleGrid& grid) {
    Vec3 at = Vec3::Zero();
    at[(axis + 1) % 3] = static_cast<double>(ray % grid.rays());
    at[(axis + 2) % 3] = static_cast<double>(ray / grid.rays());
    const Vec3 p = grid.to_space(at);
    std::ostringstream text;
    text << "operand " << (operand == 0 ? "A" : "B") << " is not closed or not oriented: along "
         << "xyz"[axis] << ", the line through (" << p.x() << ", " << p.y() << ", " << p.z()
         << ") does not leave it as often as it enters; fill its holes and turn its triangles outwards first";
    throw InvalidInput(text.str());
}

struct Row {
    std::vector<Sample> samples;
    std::vector<std::uint32_t> counts;  // number of samples of each ray
};

CombinedDepth join(const std::vector<Row>& rows, bool with_normals, const Progress* progress) {
    CombinedDepth result;
    std::size_t count = 0;
    for (const Row& row : rows) {
        count += row.samples.size();
    }
    result.begin.reserve(rows.size() * rows.size() + 1);
    result.begin.push_back(0);
    result.depth.reserve(count);
    result.source.reserve(count);
    result.normal.reserve(with_normals ? count : 0);
    for (const Row& row : rows) {
        check_cancelled(progress);
        for (const std::uint32_t n : row.counts) {
            result.begin.push_back(result.begin.back() + n);
        }
        for (const Sample& s : row.samples) {
            result.depth.push_back(s.depth);
            result.source.push_back(s.source);
            if (with_normals) {
                result.normal.push_back(s.normal);
            }
        }
    }
    return result;
}

CombinedDepth combine_along(int axis, const OperandPair& pair, const std::array<LayeredDepthSet, 2>& operands,
                            const SampleGrid& grid, const CombineOptions& options, const Progress* progress) {
    const std::array<const LayeredDepthImage*, 2> along{&operands[0][axis], &operands[1][axis]};
    const bool with_normals = !along[0]->normal.empty() || !along[1]->normal.empty();
    std::vector<Row> rows(grid.rays());
    parallel_for(grid.rays(), [&](int v) {
        check_cancelled(progress);
        RayMerger merger(options, pair, with_normals);
        Row& row = rows[v];
        row.counts.reserve(grid.rays());
        for (int u = 0; u < grid.rays(); ++u) {
            const std::size_t ray = static_cast<std::size_t>(v) * grid.rays() + u;
            const std::size_t before = row.samples.size();
            merger.merge(along, ray, row.samples);
            if (merger.unbalanced() >= 0) {
                fail_unbalanced(merger.unbalanced(), axis, ray, grid);
            }
            row.counts.push_back(static_cast<std::uint32_t>(row.samples.size() - before));
        }
    });
    return join(rows, with_normals, progress);
}

}  // namespace

CombinedSet combine(const OperandPair& pair, const std::array<LayeredDepthSet, 2>& operands, const SampleGrid& grid,
                    const CombineOptions& options, const Progress* progress) {
    CombinedSet result;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = combine_along(axis, pair, operands, grid, options, progress);
    }
    return result;
}

}  // namespace mq::boolean
