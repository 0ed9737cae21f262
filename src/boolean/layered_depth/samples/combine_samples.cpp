// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/samples/combine_samples.h"

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "boolean/input/operand_repair.h"

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
    RayMerger(const CombineOptions& options, const OperandSet& operands, std::vector<const LayeredDepthImage*> along,
              bool with_normals)
        : options_(options),
          operands_(operands),
          along_(std::move(along)),
          with_normals_(with_normals),
          membership_(options.expression),
          index_(along_.size(), 0),
          parity_(along_.size(), 0) {}

    /// Appends the samples of the result.
    void merge(std::size_t ray, std::vector<Sample>& out);
    /// The operand whose entries and exits on the last ray do not balance, or -1.
    int unbalanced() const {
        const auto found = std::find_if(index_.begin(), index_.end(), [](int index) { return index != 0; });
        return found == index_.end() ? -1 : static_cast<int>(found - index_.begin());
    }

  private:
    /// A sample of an operand.
    struct Stop {
        double depth;
        std::int32_t operand;
        std::uint32_t index;
        bool operator<(const Stop& o) const {
            return std::tie(depth, operand, index) < std::tie(o.depth, o.operand, o.index);
        }
    };
    void gather(std::size_t ray);
    void pass(const Stop& stop);
    const Stop* in_contact(std::size_t at, bool enters, std::int32_t& source) const;
    bool entry(const Stop& stop) const { return along_[stop.operand]->code[stop.index] >= 0; }
    std::int32_t source_of(const Stop& stop, bool reversed) const {
        return 2 * along_[stop.operand]->triangle(stop.index) + (reversed ? 1 : 0);
    }
    SampleNormal normal_of(const Stop& stop) const {
        if (!with_normals_) {
            return SampleNormal::Zero();
        }
        const LayeredDepthImage& image = *along_[stop.operand];
        return image.normal.empty() ? SampleNormal(operands_.unit_normal(image.triangle(stop.index)).cast<float>())
                                    : image.normal[stop.index];
    }

    const CombineOptions& options_;
    const OperandSet& operands_;
    std::vector<const LayeredDepthImage*> along_;
    bool with_normals_;
    Membership membership_;
    std::vector<int> index_;
    std::vector<char> parity_;
    std::vector<Stop> stops_;            // all samples on the ray
    std::vector<std::int32_t> operand_;  // the operand whose triangle each sample of the ray has
};

void RayMerger::gather(std::size_t ray) {
    stops_.clear();
    for (std::size_t k = 0; k < along_.size(); ++k) {
        for (std::uint32_t i = along_[k]->begin[ray]; i < along_[k]->begin[ray + 1]; ++i) {
            stops_.push_back({along_[k]->depth[i], static_cast<std::int32_t>(k), i});
        }
    }
    std::sort(stops_.begin(), stops_.end());
}

void RayMerger::pass(const Stop& stop) {
    int& index = index_[stop.operand];
    char& parity = parity_[stop.operand];
    index += entry(stop) ? 1 : -1;
    parity = parity != 0 ? 0 : 1;
    membership_.set(stop.operand, options_.normal_index ? index > 0 : parity != 0);
}

/// The sample of another operand in contact with the one at `at` that is oriented the same way in the result, with a
/// lower source than `source`, which then becomes its own; null where there is none.
const RayMerger::Stop* RayMerger::in_contact(std::size_t at, bool enters, std::int32_t& source) const {
    const Stop& stop = stops_[at];
    const Stop* found = nullptr;
    const auto look_at = [&](const Stop& other) {
        if (other.operand == stop.operand) {
            return;
        }
        const Pairing pairing = options_.expression.pairing(stop.operand, other.operand);
        const bool opposed = pairing == Pairing::FirstLessSecond || pairing == Pairing::SecondLessFirst;
        const bool reversed = (entry(stop) != enters) != opposed;
        if (pairing == Pairing::None || (entry(other) != reversed) != enters) {
            return;
        }
        if (source_of(other, reversed) < source) {
            source = source_of(other, reversed);
            found = &other;
        }
    };
    for (std::size_t i = at; i-- > 0 && stops_[i].depth >= stop.depth - options_.thinnest;) {
        look_at(stops_[i]);
    }
    for (std::size_t i = at + 1; i < stops_.size() && stops_[i].depth <= stop.depth + options_.thinnest; ++i) {
        look_at(stops_[i]);
    }
    return found;
}

void RayMerger::merge(std::size_t ray, std::vector<Sample>& out) {
    gather(ray);
    operand_.clear();
    for (std::size_t at = 0; at < stops_.size(); ++at) {
        const Stop& stop = stops_[at];
        const bool before = membership_.inside();
        pass(stop);
        if (membership_.inside() == before) {
            continue;
        }
        std::int32_t source = source_of(stop, entry(stop) == before);
        const Stop* other = in_contact(at, !before, source);
        const Stop& chosen = other != nullptr ? *other : stop;
        if (!operand_.empty() && operand_.back() != chosen.operand &&
            stop.depth - out.back().depth <= options_.thinnest) {
            operand_.pop_back();
            out.pop_back();
            continue;
        }
        operand_.push_back(chosen.operand);
        out.push_back({stop.depth, source, normal_of(chosen)});
    }
}

[[noreturn]] void fail_unbalanced(int operand, std::size_t operands, int axis, std::size_t ray,
                                  const SampleGrid& grid) {
    Vec3 at = Vec3::Zero();
    at[(axis + 1) % 3] = static_cast<double>(ray % grid.rays());
    at[(axis + 2) % 3] = static_cast<double>(ray / grid.rays());
    const Vec3 p = grid.to_space(at);
    std::ostringstream text;
    text << operand_name(static_cast<std::size_t>(operand), operands) << " is not closed or not oriented: along "
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

CombinedDepth combine_along(int axis, const OperandSet& set, const std::vector<LayeredDepthSet>& operands,
                            const SampleGrid& grid, const CombineOptions& options, const Progress* progress) {
    std::vector<const LayeredDepthImage*> along;
    for (const LayeredDepthSet& operand : operands) {
        along.push_back(&operand[axis]);
    }
    const bool with_normals =
        std::any_of(along.begin(), along.end(), [](const LayeredDepthImage* image) { return !image->normal.empty(); });
    std::vector<Row> rows(grid.rays());
    parallel_for(grid.rays(), [&](int v) {
        check_cancelled(progress);
        RayMerger merger(options, set, along, with_normals);
        Row& row = rows[v];
        row.counts.reserve(grid.rays());
        for (int u = 0; u < grid.rays(); ++u) {
            const std::size_t ray = static_cast<std::size_t>(v) * grid.rays() + u;
            const std::size_t before = row.samples.size();
            merger.merge(ray, row.samples);
            if (merger.unbalanced() >= 0) {
                fail_unbalanced(merger.unbalanced(), operands.size(), axis, ray, grid);
            }
            row.counts.push_back(static_cast<std::uint32_t>(row.samples.size() - before));
        }
    });
    return join(rows, with_normals, progress);
}

}  // namespace

CombinedSet combine(const OperandSet& set, const std::vector<LayeredDepthSet>& operands, const SampleGrid& grid,
                    const CombineOptions& options, const Progress* progress) {
    CombinedSet result;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = combine_along(axis, set, operands, grid, options, progress);
    }
    return result;
}

}  // namespace mq::boolean
