// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/rasterise.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/parallel.h"

namespace mq::layered_depth {

namespace {

constexpr int kFixedBits = 30;  // within the grid differences have 31 bits, products 61: all fits 64-bit integers
/// Coordinates beyond this, 2^10 grids, are clamped to it; the triangles between them lie off the grid.
constexpr std::int64_t kFarthest = std::int64_t{1} << 40;
/// The side of the grid in integer positions.
constexpr std::int64_t kGrid = std::int64_t{1} << kFixedBits;
/// Wide enough for the products of triangles that reach beyond the grid.
__extension__ typedef __int128 WideInteger;

/// Triangles that one thread sorts at a time: enough that starting it costs little.
constexpr int kTrianglesPerTask = 8192;
/// Samples between two checks for cancellation: some milliseconds' work, most of it memory.
constexpr std::size_t kSamplesBetweenChecks = 1u << 18;

template <typename Integer>
std::int64_t ceil_div(Integer a, Integer b) {
    const Integer q = a / b;
    return static_cast<std::int64_t>(q * b < a ? q + 1 : q);
}

/// Depth of a triangle's plane over (u, v), limited to the range of the triangle's corners.
class PlaneDepth {
  public:
    PlaneDepth(const Vec3& p, const Vec3& q, const Vec3& r, int axis)
        : p_(p), axis_(axis), u_(axis == 2 ? 0 : axis + 1) {
        v_ = 3 - axis - u_;
        const Vec3 n = (q - p).cross(r - p);
        slope_u_ = -n[u_] / n[axis];
        slope_v_ = -n[v_] / n[axis];
        low_ = std::min({p[axis], q[axis], r[axis]});
        high_ = std::max({p[axis], q[axis], r[axis]});
    }
    double at(double u, double v) const {
        const double depth = p_[axis_] + slope_u_ * (u - p_[u_]) + slope_v_ * (v - p_[v_]);
        return std::isfinite(depth) ? std::clamp(depth, low_, high_) : 0.5 * (low_ + high_);
    }

  private:
    const Vec3& p_;
    int axis_, u_, v_;
    double slope_u_, slope_v_, low_, high_;
};

}  // namespace

Rasteriser::Rasteriser(const OperandSet& pair, int operand, const SampleGrid& grid, const Progress* progress,
                       int rows_per_band)
    : pair_(pair),
      first_point_(pair.first_point[operand]),
      rays_(grid.rays()),
      rows_per_band_(rows_per_band),
      shift_(kFixedBits - grid.levels()),
      points_(pair.first_point[operand + 1] - first_point_),
      fixed_(points_.size()) {
    place_points(pair, grid);
    sort_triangles(operand, progress);
}

void Rasteriser::place_points(const OperandSet& pair, const SampleGrid& grid) {
    const double scale = std::ldexp(1.0, shift_);
    for_chunks(static_cast<int>(points_.size()), [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        points_[i] = grid.to_grid(pair.points[first_point_ + i]);
        for (int a = 0; a < 3; ++a) {
            const double fixed = std::clamp(points_[i][a] * scale, -double(kFarthest), double(kFarthest));
            fixed_[i][a] = std::llround(fixed);
        }
    });
}

std::array<Rasteriser::Corner, 3> Rasteriser::corners(int axis, std::int32_t triangle) const {
    const mesh::Triangle& t = pair_.triangles[triangle];
    const int u = axis == 2 ? 0 : axis + 1, v = 3 - axis - u;
    std::array<Corner, 3> c{};
    for (int i = 0; i < 3; ++i) {
        const std::array<std::int64_t, 3>& fixed = fixed_[t[i] - first_point_];
        c[i] = {fixed[u], fixed[v]};
    }
    return c;
}

/// The rows of rays that a triangle may meet; empty if it lies between rays, as most triangles of a fine mesh do.
Rasteriser::Rows Rasteriser::rows_of(const std::array<Corner, 3>& c) const {
    const auto [low_u, high_u] = std::minmax({c[0].u, c[1].u, c[2].u});
    const auto [low_v, high_v] = std::minmax({c[0].v, c[1].v, c[2].v});
    if (ceil_ray(low_u) >= ceil_ray(high_u) || low_u > kGrid || high_u < 0) {
        return {0, 0};
    }
    return {std::max<std::int64_t>(0, ceil_ray(low_v)), std::min<std::int64_t>(rays_, ceil_ray(high_v))};
}

void Rasteriser::sort_triangles(int operand, const Progress* progress) {
    const std::int32_t first = pair_.first_triangle[operand], end = pair_.first_triangle[operand + 1];
    std::vector<std::array<std::vector<Span>, 3>> parts((end - first + kTrianglesPerTask - 1) / kTrianglesPerTask);
    parallel_for(static_cast<int>(parts.size()), [&](int k) {
        check_cancelled(progress);
        const std::int32_t from = first + k * kTrianglesPerTask;
        for (std::int32_t t = from; t < std::min(end, from + kTrianglesPerTask); ++t) {
            for (int axis = 0; axis < 3; ++axis) {
                const Rows rows = rows_of(corners(axis, t));
                if (rows.first < rows.end) {
                    parts[k][axis].push_back({t, static_cast<std::int32_t>(rows.first / rows_per_band_),
                                              static_cast<std::int32_t>((rows.end - 1) / rows_per_band_ + 1)});
                }
            }
        }
    });
    parallel_for(3, [&](int axis) { fill_bins(axis, parts); });
}

void Rasteriser::fill_bins(int axis, const std::vector<std::array<std::vector<Span>, 3>>& parts) {
    Bins& bins = bins_[axis];
    bins.begin.assign(static_cast<std::size_t>(bands()) + 1, 0);
    for (const auto& part : parts) {
        for (const Span& span : part[axis]) {
            for (std::int32_t band = span.first_band; band < span.end_band; ++band) {
                ++bins.begin[band + 1];
            }
        }
    }
    std::partial_sum(bins.begin.begin(), bins.begin.end(), bins.begin.begin());
    bins.triangles.resize(bins.begin.back());
    std::vector<std::uint32_t> next(bins.begin.begin(), bins.begin.end() - 1);
    for (const auto& part : parts) {
        for (const Span& span : part[axis]) {
            for (std::int32_t band = span.first_band; band < span.end_band; ++band) {
                bins.triangles[next[band]++] = span.triangle;
            }
        }
    }
}

void Rasteriser::sample(int axis, std::int32_t triangle, const Rows& rows, std::vector<RawSample>& out) const {
    const std::array<Corner, 3> c = corners(axis, triangle);
    const bool within = std::all_of(c.begin(), c.end(), [](const Corner& corner) {
        return corner.u >= 0 && corner.v >= 0 && corner.u <= kGrid && corner.v <= kGrid;
    });
    if (within) {
        fill<std::int64_t>(axis, triangle, c, rows, out);
    } else {
        fill<WideInteger>(axis, triangle, c, rows, out);
    }
}

/// The first column at or beyond the edge p-q (p.v < q.v) on the row at fixed coordinate `v`.
template <typename Integer>
std::int64_t Rasteriser::column(const Corner& p, const Corner& q, std::int64_t v) const {
    const Integer rise = q.v - p.v;
    return ceil_div<Integer>(p.u * rise + Integer(v - p.v) * (q.u - p.u), rise << shift_);
}

template <typename Integer>
void Rasteriser::fill(int axis, std::int32_t triangle, const std::array<Corner, 3>& c, const Rows& rows,
                      std::vector<RawSample>& out) const {
    const Integer area = Integer(c[1].u - c[0].u) * (c[2].v - c[0].v) - Integer(c[1].v - c[0].v) * (c[2].u - c[0].u);
    const std::int32_t code = area > 0 ? ~triangle : triangle;
    const std::int64_t first_row = std::max(rows.first, ceil_ray(std::min({c[0].v, c[1].v, c[2].v})));
    const std::int64_t end_row = std::min(rows.end, ceil_ray(std::max({c[0].v, c[1].v, c[2].v})));
    std::optional<PlaneDepth> plane;
    for (std::int64_t row = first_row; row < end_row; ++row) {
        const std::int64_t v = row << shift_;
        std::array<std::int64_t, 2> columns{};
        int crossings = 0;
        for (int i = 0; i < 3 && crossings < 2; ++i) {
            const Corner* p = &c[i];
            const Corner* q = &c[i == 2 ? 0 : i + 1];
            if (p->v > q->v) {
                std::swap(p, q);
            }
            if (p->v <= v && v < q->v) {
                columns[crossings++] = std::clamp<std::int64_t>(column<Integer>(*p, *q, v), 0, rays_);
            }
        }
        const auto [from, to] = std::minmax(columns[0], columns[1]);
        if (from < to && !plane) {
            const auto point = [&](int i) -> const Vec3& {
                return points_[pair_.triangles[triangle][i] - first_point_];
            };
            plane.emplace(point(0), point(1), point(2), axis);
        }
        for (std::int64_t u = from; u < to; ++u) {
            out.push_back({static_cast<std::uint32_t>((row - rows.first) * rays_ + u), code,
                           plane->at(static_cast<double>(u), static_cast<double>(row))});
        }
    }
}

/// Sorts raw samples into rays, and along each ray by depth. At equal depths exits come first, so that two touching
/// sheets separate rather than overlap; then the triangle with the lower index.
LayeredDepthImage Rasteriser::gather(const std::vector<RawSample>& raw, std::size_t rays,
                                     const Progress* progress) const {
    LayeredDepthImage result;
    result.begin.assign(rays + 1, 0);
    for (const RawSample& s : raw) {
        ++result.begin[s.ray + 1];
    }
    std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
    result.depth.resize(raw.size());
    result.code.resize(raw.size());
    std::vector<std::uint32_t> filled(rays, 0);
    CancelPace pace(progress);
    for (const RawSample& s : raw) {
        const std::uint32_t first = result.begin[s.ray];
        std::uint32_t place = first + filled[s.ray]++;
        const auto follows = [&](double depth, std::int32_t code) {
            return depth != s.depth ? depth > s.depth : code > s.code;
        };
        pace.step();
        for (; place > first && follows(result.depth[place - 1], result.code[place - 1]); --place) {
            pace.step();
            result.depth[place] = result.depth[place - 1];
            result.code[place] = result.code[place - 1];
        }
        result.depth[place] = s.depth;
        result.code[place] = s.code;
    }
    return result;
}

LayeredDepthImage Rasteriser::band(int axis, int band, SampleCounts* counts, const Progress* progress) const {
    const Rows rows{first_row(band), first_row(band + 1)};
    const Bins& bins = bins_[axis];
    std::vector<RawSample> raw;
    std::size_t checked = 0;
    check_cancelled(progress);
    for (std::uint32_t i = bins.begin[band]; i < bins.begin[band + 1]; ++i) {
        const std::size_t before = raw.size();
        sample(axis, bins.triangles[i], rows, raw);
        if (counts != nullptr && raw.size() > before) {
            (*counts)[bins.triangles[i]].fetch_add(static_cast<std::uint32_t>(raw.size() - before),
                                                   std::memory_order_relaxed);
        }
        if (raw.size() > checked + kSamplesBetweenChecks) {
            check_cancelled(progress);
            checked = raw.size();
        }
    }
    return gather(raw, static_cast<std::size_t>(rows.end - rows.first) * static_cast<std::size_t>(rays_), progress);
}

LayeredDepthSet rasterise(const OperandSet& pair, int operand, const SampleGrid& grid, const Progress* progress) {
    const Rasteriser rasteriser(pair, operand, grid, progress);
    LayeredDepthSet result;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<LayeredDepthImage> bands(static_cast<std::size_t>(rasteriser.bands()));
        parallel_for(rasteriser.bands(), [&](int band) {
            bands[static_cast<std::size_t>(band)] = rasteriser.band(axis, band, nullptr, progress);
        });
        result[axis] = joined(bands);
    }
    return result;
}

}  // namespace mq::layered_depth
