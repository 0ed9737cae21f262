// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>

#include "base/progress.h"
#include "layered_depth/samples/layered_depth_image.h"

namespace mq::layered_depth {

/// The highest resolution of rasterise(): 2^12 cells a side.
constexpr int kMaxLevels = 12;
/// Rows of rays in a band: few enough that its samples take little memory, enough that starting a band costs little.
constexpr int kRowsPerBand = 32;

/// Number of samples of each triangle; several threads add to it.
using SampleCounts = std::vector<std::atomic<std::uint32_t>>;

/// Samples one operand along the rays of the grid (Wang 2010, section II, step 1), a band of rows at a time.
///
/// The rules are consistent: positions across the rays are integers (2^30 along the side of the grid), and each edge
/// decides in exact arithmetic on which side of it a ray passes, in the same way for all triangles that share it. A ray
/// through an edge or a vertex counts as passing on the side of greater coordinates (symbolic perturbation). So a
/// closed operand has as many entries as exits on every ray. The operand may reach beyond the grid.
class Rasteriser {
  public:
    /// Sorts the triangles into bands, on all cores.
    /// @throws Cancelled
    Rasteriser(const OperandSet& pair, int operand, const SampleGrid& grid, const Progress* progress,
               int rows_per_band = kRowsPerBand);

    int bands() const { return (rays_ + rows_per_band_ - 1) / rows_per_band_; }
    int first_row(int band) const { return std::min(band * rows_per_band_, rays_); }
    /// The samples on the rays of one direction in a band, whose first ray has the index 0. The samples do not depend
    /// on the height of the bands. Time O(triangles in the band + rays + samples log layers).
    /// @param counts the samples of each triangle are added to it; may be null
    /// @throws Cancelled
    LayeredDepthImage band(int axis, int band, SampleCounts* counts, const Progress* progress) const;

  private:
    struct Corner {
        std::int64_t u, v;
    };
    struct RawSample {
        std::uint32_t ray;  // from the first one of the band
        std::int32_t code;
        double depth;
    };
    /// The triangles that rays of a band may meet, in ascending order.
    struct Bins {
        std::vector<std::uint32_t> begin;  ///< first triangle of each band, and the number of all
        std::vector<std::int32_t> triangles;
    };
    struct Rows {
        std::int64_t first, end;
    };
    struct Span {
        std::int32_t triangle, first_band, end_band;
    };

    std::array<Corner, 3> corners(int axis, std::int32_t triangle) const;
    Rows rows_of(const std::array<Corner, 3>& c) const;
    void place_points(const OperandSet& pair, const SampleGrid& grid);
    void sort_triangles(int operand, const Progress* progress);
    void fill_bins(int axis, const std::vector<std::array<std::vector<Span>, 3>>& parts);
    void sample(int axis, std::int32_t triangle, const Rows& rows, std::vector<RawSample>& out) const;
    template <typename Integer>
    std::int64_t column(const Corner& p, const Corner& q, std::int64_t v) const;
    template <typename Integer>
    void fill(int axis, std::int32_t triangle, const std::array<Corner, 3>& c, const Rows& rows,
              std::vector<RawSample>& out) const;
    LayeredDepthImage gather(const std::vector<RawSample>& raw, std::size_t rays, const Progress* progress) const;
    std::int64_t ceil_ray(std::int64_t fixed) const { return (fixed + (std::int64_t{1} << shift_) - 1) >> shift_; }

    const OperandSet& pair_;
    std::int32_t first_point_;
    int rays_;
    int rows_per_band_;
    int shift_;
    std::vector<Vec3> points_;
    std::vector<std::array<std::int64_t, 3>> fixed_;
    std::array<Bins, 3> bins_;
};

/// All samples of one operand (0 or 1), on all cores.
/// @throws Cancelled
LayeredDepthSet rasterise(const OperandSet& pair, int operand, const SampleGrid& grid, const Progress* progress);

}  // namespace mq::layered_depth
