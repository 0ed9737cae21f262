// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/combine_samples.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "boolean/input/operand_repair.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::layered_depth {

using boolean::Pairing;

namespace {

/// Samples of the result on consecutive rays.
struct Piece {
    std::vector<std::uint32_t> counts;  // number of samples of each ray
    std::vector<double> depth;
    std::vector<std::int32_t> source;
    std::vector<SampleNormal> normal;  // empty: samples have no normals

    void drop_last() {
        depth.pop_back();
        source.pop_back();
        if (!normal.empty()) {
            normal.pop_back();
        }
    }
};

/// Combines the operands' samples, one ray after another.
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
    void merge(std::size_t ray, Piece& out);
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
        const LayeredDepthImage& image = *along_[stop.operand];
        return image.normal.empty() ? SampleNormal(operands_.unit_normal(image.triangle(stop.index)).cast<float>())
                                    : image.normal[stop.index];
    }

    const CombineOptions& options_;
    const OperandSet& operands_;
    std::vector<const LayeredDepthImage*> along_;
    bool with_normals_;
    boolean::Membership membership_;
    std::vector<int> index_;
    std::vector<char> parity_;
    std::vector<Stop> stops_;            // all samples on the ray
    std::vector<std::int32_t> operand_;  // by sample of the ray: the operand whose triangle it has
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

/// The sample of another operand that is in contact with the one at `at`, is oriented the same way in the result, and
/// has a lower source than `source`. Sets `source` to the source of that sample; null if there is none.
const RayMerger::Stop* RayMerger::in_contact(std::size_t at, bool enters, std::int32_t& source) const {
    const Stop& stop = stops_[at];
    const Stop* found = nullptr;
    const auto examine = [&](const Stop& other) {
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
        examine(stops_[i]);
    }
    for (std::size_t i = at + 1; i < stops_.size() && stops_[i].depth <= stop.depth + options_.thinnest; ++i) {
        examine(stops_[i]);
    }
    return found;
}

void RayMerger::merge(std::size_t ray, Piece& out) {
    gather(ray);
    const std::size_t first = out.depth.size();
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
            stop.depth - out.depth.back() <= options_.thinnest) {
            operand_.pop_back();
            out.drop_last();
            continue;
        }
        operand_.push_back(chosen.operand);
        out.depth.push_back(stop.depth);
        out.source.push_back(source);
        if (with_normals_) {
            out.normal.push_back(normal_of(chosen));
        }
    }
    out.counts.push_back(static_cast<std::uint32_t>(out.depth.size() - first));
}

[[noreturn]] void fail_unbalanced(int operand, std::size_t operands, int axis, std::size_t ray,
                                  const SampleGrid& grid) {
    Vec3 at = Vec3::Zero();
    at[(axis + 1) % 3] = static_cast<double>(ray % grid.rays());
    at[(axis + 2) % 3] = static_cast<double>(ray / grid.rays());
    throw InvalidInput(phrases::kNotOriented,
                       {{"name", boolean::operand_name(static_cast<std::size_t>(operand), operands)},
                        {"value", std::string(1, "xyz"[axis])},
                        {"point", in_mm(grid.to_space(at), 6)}});
}

/// Combines consecutive rays.
class PieceMaker {
  public:
    PieceMaker(const CombineOptions& options, const OperandSet& set, const SampleGrid& grid)
        : options_(options), set_(set), grid_(grid) {}

    /// @param along the operands' images, in which the index of the first ray is `first`
    /// @param shift is added to these indices to get the indices in the grid
    Piece make(int axis, const std::vector<const LayeredDepthImage*>& along, std::size_t first, std::size_t count,
               std::size_t shift) const {
        const bool with_normals = std::any_of(along.begin(), along.end(),
                                              [](const LayeredDepthImage* image) { return !image->normal.empty(); });
        RayMerger merger(options_, set_, along, with_normals);
        Piece piece;
        piece.counts.reserve(count);
        for (std::size_t ray = first; ray < first + count; ++ray) {
            merger.merge(ray, piece);
            if (merger.unbalanced() >= 0) {
                fail_unbalanced(merger.unbalanced(), along.size(), axis, ray + shift, grid_);
            }
        }
        return piece;
    }

  private:
    const CombineOptions& options_;
    const OperandSet& set_;
    const SampleGrid& grid_;
};

/// Joins the pieces, on all cores; each piece is released as soon as it is copied.
CombinedDepth join(std::vector<Piece>& pieces, const Progress* progress) {
    std::vector<std::size_t> first_ray{0}, first_sample{0};
    bool with_normals = false;
    for (const Piece& piece : pieces) {
        first_ray.push_back(first_ray.back() + piece.counts.size());
        first_sample.push_back(first_sample.back() + piece.depth.size());
        with_normals = with_normals || !piece.normal.empty();
    }
    CombinedDepth result;
    result.begin.resize(first_ray.back() + 1);
    result.begin.back() = static_cast<std::uint32_t>(first_sample.back());
    result.depth.resize(first_sample.back());
    result.source.resize(first_sample.back());
    result.normal.resize(with_normals ? first_sample.back() : 0);
    parallel_for(static_cast<int>(pieces.size()), [&](int k) {
        check_cancelled(progress);
        Piece& piece = pieces[static_cast<std::size_t>(k)];
        const auto at = static_cast<std::ptrdiff_t>(first_sample[static_cast<std::size_t>(k)]);
        auto begin = static_cast<std::uint32_t>(at);
        std::size_t ray = first_ray[static_cast<std::size_t>(k)];
        for (const std::uint32_t count : piece.counts) {
            result.begin[ray++] = begin;
            begin += count;
        }
        std::copy(piece.depth.begin(), piece.depth.end(), result.depth.begin() + at);
        std::copy(piece.source.begin(), piece.source.end(), result.source.begin() + at);
        std::copy(piece.normal.begin(), piece.normal.end(), result.normal.begin() + (with_normals ? at : 0));
        piece = {};
    });
    return result;
}

CombinedDepth combine_along(int axis, const OperandSet& set, const std::vector<LayeredDepthSet>& operands,
                            const SampleGrid& grid, const CombineOptions& options, const Progress* progress) {
    std::vector<const LayeredDepthImage*> along;
    for (const LayeredDepthSet& operand : operands) {
        along.push_back(&operand[axis]);
    }
    const PieceMaker maker(options, set, grid);
    const auto rays = static_cast<std::size_t>(grid.rays());
    std::vector<Piece> rows(rays);
    parallel_for(grid.rays(), [&](int v) {
        check_cancelled(progress);
        const auto row = static_cast<std::size_t>(v);
        rows[row] = maker.make(axis, along, row * rays, rays, 0);
    });
    return join(rows, progress);
}

}  // namespace

CombinedSet combine(const OperandSet& set, std::vector<LayeredDepthSet> operands, const SampleGrid& grid,
                    const CombineOptions& options, const Progress* progress) {
    CombinedSet result;
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = combine_along(axis, set, operands, grid, options, progress);
        for (LayeredDepthSet& operand : operands) {
            operand[axis] = {};
        }
    }
    return result;
}

CombinedSet combine_meshes(const OperandSet& set, const SampleGrid& grid, const CombineOptions& options,
                           SampleCounts& counts, const Progress* progress, int rows_per_band) {
    std::vector<Rasteriser> operands;
    for (int k = 0; k < set.size(); ++k) {
        operands.emplace_back(set, k, grid, progress, rows_per_band);
    }
    const PieceMaker maker(options, set, grid);
    const auto rays = static_cast<std::size_t>(grid.rays());
    CombinedSet result;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Piece> pieces(static_cast<std::size_t>(operands.front().bands()));
        parallel_for(operands.front().bands(), [&](int band) {
            std::vector<LayeredDepthImage> images;
            std::vector<const LayeredDepthImage*> along;
            for (const Rasteriser& operand : operands) {
                images.push_back(operand.band(axis, band, &counts, progress));
            }
            for (const LayeredDepthImage& image : images) {
                along.push_back(&image);
            }
            const auto first_row = static_cast<std::size_t>(operands.front().first_row(band));
            pieces[static_cast<std::size_t>(band)] =
                maker.make(axis, along, 0, images.front().begin.size() - 1, first_row * rays);
        });
        result[axis] = join(pieces, progress);
    }
    return result;
}

}  // namespace mq::layered_depth
