// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/simplification.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/key_set.h"
#include "base/parallel.h"
#include "contour/edge_collapse.h"
#include "mesh/intersection/self_intersection.h"

namespace mq::contour {

namespace {

using BlockKey = std::array<std::int32_t, 3>;

/// The shift of the blocks the first time, as a fraction of their side.
constexpr double kShift = 0.309;

/// A block of space: the surface of the triangles in it and of those that reach into it.
struct Block {
    CollapseLimits limits;
    Contour surface;
    std::vector<std::int32_t> triangles;  ///< those that reach into it, by their index in the whole surface
    std::vector<char> fixed;              ///< by triangle: whether it stays, or is in other blocks, too
    std::vector<std::int32_t> vertices;   ///< the vertices of fixed triangles, by their index in the whole surface
};

/// The boxes of the triangles that meet; of some of them, where they are many.
std::vector<Box> boxes_of_contacts(const Contour& surface, const Progress& progress) {
    constexpr std::size_t kMostCrossings = 16;
    std::vector<Box> boxes;
    for (const mesh::ContactPair& pair :
         mesh::self_intersections(surface.points, surface.triangles, kMostCrossings, &progress)) {
        boxes.emplace_back();
        for (const std::int32_t t : {pair.a, pair.b}) {
            for (const std::int32_t v : surface.triangles[static_cast<std::size_t>(t)]) {
                boxes.back().add(surface.points[static_cast<std::size_t>(v)]);
            }
        }
    }
    return boxes;
}

/// Collapses edges without a test of each collapse. If triangles of the result meet, all is done again, with a test of
/// the collapses there; if that is not enough, with a test of all.
void collapse(Contour& surface, const std::vector<Crossing>& crossings, CollapseLimits& limits, Progress& progress,
              double from = 0.0) {
    const Contour before = surface;
    limits.tested.clear();
    for (const bool is_first : {true, false}) {
        collapse_edges(surface, crossings, limits, progress, from);
        const std::vector<Box> contacts = boxes_of_contacts(surface, progress);
        if (contacts.empty()) {
            return;
        }
        surface = before;
        limits.tested = is_first ? contacts : std::vector<Box>{limits.within};
    }
    collapse_edges(surface, crossings, limits, progress, from);
}

class Blocks {
  public:
    /// @param shift  of the blocks along each axis, as a fraction of their side
    Blocks(Contour& surface, double side, double shift, const std::vector<char>& stays)
        : surface_(surface), side_(side), shift_(shift) {
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            distribute(static_cast<std::int32_t>(t), !stays.empty() && stays[t] != 0);
        }
    }

    void simplify(const std::vector<Crossing>& crossings, const CollapseLimits& limits, Progress& progress) {
        // Blocks take nine tenths of the stage: those that are not shifted, then the shifted ones.
        std::atomic<int> done{0};
        const auto count = static_cast<double>(blocks_.size());
        parallel_for(static_cast<int>(blocks_.size()), [&](int k) {
            Block& block = blocks_[static_cast<std::size_t>(k)];
            const Box within = block.limits.within;
            block.limits = limits;
            block.limits.within = within;
            block.limits.fixed.clear();
            fill(block);
            Progress piece(&progress);
            collapse(block.surface, crossings, block.limits, piece);
            progress.advance(0.45 * (shift_ > kShift) + 0.45 * ++done / count);
        });
        join();
    }

  private:
    BlockKey key_of(const Vec3& p) const {
        BlockKey key{};
        for (int i = 0; i < 3; ++i) {
            key[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(std::floor(p[i] / side_ - shift_));
        }
        return key;
    }
    Block& block_at(const BlockKey& key) {
        const auto [at, is_new] = numbers_.insert({key, blocks_.size()});
        if (is_new) {
            // Slightly inside of the block, so that triangles of two blocks do not touch on the plane between them.
            constexpr double kInside = 1e-6;
            Block block;
            block.limits.within.low = side_ * (Vec3(key[0], key[1], key[2]) + Vec3::Constant(shift_ + kInside));
            block.limits.within.high = side_ * (Vec3(key[0], key[1], key[2]) + Vec3::Constant(shift_ + 1.0 - kInside));
            blocks_.push_back(std::move(block));
        }
        return blocks_[at->second];
    }
    /// Adds a triangle to all blocks into which its box reaches.
    void distribute(std::int32_t t, bool stays) {
        Box box;
        for (const std::int32_t v : surface_.triangles[t]) {
            box.add(surface_.points[v]);
        }
        const BlockKey low = key_of(box.low);
        const BlockKey high = key_of(box.high);
        for (std::int32_t x = low[0]; x <= high[0]; ++x) {
            for (std::int32_t y = low[1]; y <= high[1]; ++y) {
                for (std::int32_t z = low[2]; z <= high[2]; ++z) {
                    Block& block = block_at({x, y, z});
                    block.triangles.push_back(t);
                    const bool is_inside =
                        block.limits.within.contains(box.low) && block.limits.within.contains(box.high);
                    block.fixed.push_back(is_inside && !stays ? 0 : 1);
                }
            }
        }
    }
    /// Copies the triangles of a block with their vertices, the fixed ones first.
    void fill(Block& block) const {
        KeyMap<std::int32_t> numbers;
        for (const char fixed : {1, 0}) {
            for (std::size_t k = 0; k < block.triangles.size(); ++k) {
                if (block.fixed[k] == fixed) {
                    add(block, block.triangles[k], numbers);
                    block.limits.fixed.push_back(fixed);
                }
            }
            if (fixed != 0) {
                block.vertices.resize(block.surface.points.size());
                for (const auto& [v, number] : numbers) {
                    block.vertices[static_cast<std::size_t>(number)] = static_cast<std::int32_t>(v);
                }
            }
        }
    }
    void add(Block& block, std::int32_t t, KeyMap<std::int32_t>& numbers) const {
        mesh::Triangle triangle = surface_.triangles[t];
        for (std::int32_t& v : triangle) {
            const auto number = static_cast<std::int32_t>(block.surface.points.size());
            const auto [at, is_new] = numbers.insert({static_cast<std::uint64_t>(v), number});
            if (is_new) {
                block.surface.points.push_back(surface_.points[v]);
            }
            v = at->second;
        }
        block.surface.triangles.push_back(triangle);
        block.surface.source.push_back(surface_.source[t]);
        block.surface.patch.push_back(surface_.patch[t]);
        block.surface.plane.push_back(surface_.plane[t]);
        if (!surface_.kept.empty()) {
            block.surface.kept.push_back(surface_.kept[t]);
        }
    }
    /// Joins the blocks' results and the triangles between blocks to the whole surface.
    void join() {
        Contour all;
        all.points = surface_.points;
        std::vector<char> is_fixed(surface_.triangles.size());
        for (const Block& block : blocks_) {
            for (std::size_t k = 0; k < block.triangles.size(); ++k) {
                is_fixed[block.triangles[k]] = block.fixed[k];
            }
        }
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (is_fixed[t] != 0) {
                append(all, surface_, t, surface_.triangles[t]);
            }
        }
        for (const Block& block : blocks_) {
            std::vector<std::int32_t> index = block.vertices;
            for (std::size_t v = index.size(); v < block.surface.points.size(); ++v) {
                index.push_back(static_cast<std::int32_t>(all.points.size()));
                all.points.push_back(block.surface.points[v]);
            }
            const auto fixed = static_cast<std::size_t>(std::count(block.fixed.begin(), block.fixed.end(), 1));
            for (std::size_t t = fixed; t < block.surface.triangles.size(); ++t) {
                mesh::Triangle triangle = block.surface.triangles[t];
                for (std::int32_t& v : triangle) {
                    v = index[v];
                }
                append(all, block.surface, t, triangle);
            }
        }
        surface_ = std::move(all);
    }
    static void append(Contour& all, const Contour& from, std::size_t t, const mesh::Triangle& triangle) {
        all.triangles.push_back(triangle);
        all.source.push_back(from.source[t]);
        all.patch.push_back(from.patch[t]);
        all.plane.push_back(from.plane[t]);
        if (!from.kept.empty()) {
            all.kept.push_back(from.kept[t]);
        }
    }

    Contour& surface_;
    double side_;
    double shift_;
    std::vector<Block> blocks_;
    tsl::robin_map<BlockKey, std::size_t, KeyHash> numbers_;
};

/// By triangle of a surface: whether it is a fixed one of those that it was made of.
std::vector<char> still_fixed(const Contour& surface, const std::vector<char>& fixed) {
    std::vector<char> found;
    for (std::size_t t = 0; t < surface.triangles.size() && !fixed.empty(); ++t) {
        found.push_back(fixed[static_cast<std::size_t>(surface.source[t])]);
    }
    return found;
}

}  // namespace

void simplify(Contour& surface, const std::vector<Crossing>& crossings, const CollapseLimits& limits, double block,
              Progress& progress) {
    // In the second round most triangles that lay between blocks are inside of one. The shifts avoid whole multiples of
    // lengths, in which faces of models often lie.
    for (const double shift : {kShift, kShift + 0.5}) {
        Blocks(surface, block, shift, still_fixed(surface, limits.fixed)).simplify(crossings, limits, progress);
    }
    CollapseLimits rest = limits;
    rest.fixed = still_fixed(surface, limits.fixed);
    collapse(surface, crossings, rest, progress, 0.9);
}

}  // namespace mq::contour
