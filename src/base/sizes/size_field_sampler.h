// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/sizes/size_field.h"
#include "base/vec.h"

namespace mq {

/// Makes a SizeField of a function that is known by its values at points: cells are divided until the trilinear
/// interpolation is within a fraction of the function at the 19 further corners of their halves, or until they are
/// smaller than half of the least length there. Those that are still not resolved then take their least length.
///
/// The caller evaluates:   while (!(points = sampler.wanted()).empty()) sampler.give(values at points);
class SizeFieldSampler {
  public:
    /// Largest depth of the octree: its smallest cells are 2^-19 of the cube.
    static constexpr int kDepth = 19;

    /// @param box  of the model; the cube around it is a little larger
    /// @param error  largest relative error of the interpolation, above 0
    /// @param least_depth  all cells are at least that deep: smaller features of the function may be missed
    /// @param most_samples  values that are asked for at most, about
    SizeFieldSampler(const Box& box, double error, int least_depth, std::size_t most_samples);

    /// Divides the cells at a point until they are no longer than a length: where the function has small features.
    void mark(const Vec3& point, double length);
    /// Leaves cells alone that are deeper than `depth` and lie farther than one cell of that depth from all points:
    /// those of a surface. To be called before the first wanted().
    void restrict_to(const std::vector<Vec3>& points, int depth);
    /// Starts again from the root, after further marks; known values are not asked for again.
    void restart();
    /// The points at which values are needed next; none: the field is complete.
    std::vector<Vec3> wanted();
    /// The values at the points that wanted() has returned last, in their order: above 0, mm.
    /// @throws InvalidInput for another number of values
    void give(const double* values, std::size_t count);
    /// The field. To be asked when wanted() returns no more.
    SizeField field() const;

    std::size_t samples() const { return value_of_.size(); }
    /// Number of cells that the limits on samples, depth or size have left with their least length.
    std::size_t unresolved() const { return unresolved_; }

  private:
    using Key = std::uint64_t;
    /// A cell that may be divided: its lowest corner in units of the smallest halves of cells, and its depth.
    struct Cell {
        std::array<std::uint32_t, 3> low;
        int depth;
        std::int32_t index;
    };

    std::uint32_t span_of(int depth) const { return 1U << static_cast<unsigned>(kDepth + 1 - depth); }
    static Key key_of(const std::array<std::uint32_t, 3>& place);
    static Key cell_key(const std::array<std::uint32_t, 3>& low, int depth);
    bool is_marked(const Cell& cell) const;
    bool is_relevant(const Cell& cell) const;
    bool must_divide(const Cell& cell) const;
    void want_samples_of(const Cell& cell);
    double at(const Cell& cell, int i, int j, int k) const;
    void divide(const Cell& cell, std::vector<Cell>& next);
    void settle(const Cell& cell, std::vector<Cell>& next);
    void advance();

    Vec3 low_;
    double side_;
    double error_;
    int least_depth_;
    std::size_t most_samples_;
    Box box_;
    std::unordered_set<Key> marked_;
    std::unordered_set<Key> near_;  // cells of the depth near_depth_ to which the work is restricted
    int near_depth_ = kDepth;
    std::unordered_map<Key, double> value_of_;
    std::vector<Key> asked_;
    std::vector<Cell> front_;  // the cells of one depth
    std::vector<std::int32_t> children_;
    std::vector<SizeField::Corners> leaves_;
    std::size_t unresolved_ = 0;
    bool front_is_sampled_ = false;
};

}  // namespace mq
