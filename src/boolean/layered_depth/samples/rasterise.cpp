// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/layered_depth/samples/rasterise.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"

namespace mq::boolean {

namespace {

constexpr int kFixedBits = 30;  // within the grid differences have 31 bits, products 61: all fits 64-bit integers
/// Coordinates beyond this, 2^10 grids, are clamped to it; the triangles between them lie off the grid.
constexpr std::int64_t kFarthest = std::int64_t{1} << 40;
/// Wide enough for the products of triangles that reach beyond the grid.
__extension__ typedef __int128 WideInteger;

/// Triangles in one parallel task: enough that starting a task costs little.
constexpr int kTrianglesPerTask = 8192;
/// Samples between two checks for cancellation: some milliseconds' work, most of it memory.
constexpr std::size_t kSamplesBetweenChecks = 1u << 18;

using FixedPoint = std::array<std::int64_t, 3>;

struct RawSample {
    std::uint32_t ray;
    std::int32_t code;
    double depth;
};
using RawSet = std::array<std::vector<RawSample>, 3>;

template <typename Integer>
std::int64_t ceil_div(Integer a, Integer b) {
    const Integer q = a / b;
    return static_cast<std::int64_t>(q * b < a ? q + 1 : q);
}

/// Samples triangles along all three axes.
class Rasteriser {
  public:
    Rasteriser(const OperandSet& pair, int operand, const SampleGrid& grid);

    void sample(std::int32_t triangle, RawSet& out) const;

  private:
    struct Corner {
        std::int64_t u, v;
    };
    void sample_along(int axis, std::int32_t triangle, std::vector<RawSample>& out) const;
    /// The first column at or beyond the edge p-q (p.v < q.v) on the row at fixed coordinate `v`.
    template <typename Integer>
    std::int64_t column(const Corner& p, const Corner& q, std::int64_t v) const {
        const Integer rise = q.v - p.v;
        return ceil_div<Integer>(p.u * rise + Integer(v - p.v) * (q.u - p.u), rise << shift_);
    }
    template <typename Integer>
    void fill(int axis, std::int32_t triangle, const std::array<Corner, 3>& c, std::vector<RawSample>& out) const;
    std::int64_t ceil_ray(std::int64_t fixed) const { return (fixed + (std::int64_t{1} << shift_) - 1) >> shift_; }

    const OperandSet& pair_;
    std::int32_t first_point_;
    std::int64_t rays_;
    int shift_;
    std::vector<Vec3> points_;
    std::vector<FixedPoint> fixed_;
};

Rasteriser::Rasteriser(const OperandSet& pair, int operand, const SampleGrid& grid)
    : pair_(pair),
      first_point_(pair.first_point[operand]),
      rays_(grid.rays()),
      shift_(kFixedBits - grid.levels()),
      points_(pair.first_point[operand + 1] - first_point_),
      fixed_(points_.size()) {
    const double scale = std::ldexp(1.0, shift_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points_[i] = grid.to_grid(pair.points[first_point_ + i]);
        for (int a = 0; a < 3; ++a) {
            const double fixed = std::clamp(points_[i][a] * scale, -double(kFarthest), double(kFarthest));
            fixed_[i][a] = std::llround(fixed);
        }
    }
}

void Rasteriser::sample(std::int32_t triangle, RawSet& out) const {
    for (int axis = 0; axis < 3; ++axis) {
        sample_along(axis, triangle, out[axis]);
    }
}

/// Depth of a triangle's plane over (u, v), never outside of the triangle's own range.
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

void Rasteriser::sample_along(int axis, std::int32_t triangle, std::vector<RawSample>& out) const {
    const mesh::Triangle& t = pair_.triangles[triangle];
    const std::array<std::int32_t, 3> index{t[0] - first_point_, t[1] - first_point_, t[2] - first_point_};
    const int ua = axis == 2 ? 0 : axis + 1, va = 3 - axis - ua;
    std::array<Corner, 3> c;
    for (int i = 0; i < 3; ++i) {
        c[i] = {fixed_[index[i]][ua], fixed_[index[i]][va]};
    }
    const auto [low_u, high_u] = std::minmax({c[0].u, c[1].u, c[2].u});
    const auto [low_v, high_v] = std::minmax({c[0].v, c[1].v, c[2].v});
    if (ceil_ray(low_v) >= ceil_ray(high_v) || ceil_ray(low_u) >= ceil_ray(high_u)) {
        return;  // between rays, as most triangles of a fine mesh
    }
    // The side of the grid in integer positions.
    constexpr std::int64_t kGrid = std::int64_t{1} << kFixedBits;
    if (low_u >= 0 && low_v >= 0 && high_u <= kGrid && high_v <= kGrid) {
        fill<std::int64_t>(axis, triangle, c, out);
    } else if (low_u <= kGrid && low_v <= kGrid && high_u >= 0 && high_v >= 0) {
        fill<WideInteger>(axis, triangle, c, out);
    }
}

template <typename Integer>
void Rasteriser::fill(int axis, std::int32_t triangle, const std::array<Corner, 3>& c,
                      std::vector<RawSample>& out) const {
    const Integer area = Integer(c[1].u - c[0].u) * (c[2].v - c[0].v) - Integer(c[1].v - c[0].v) * (c[2].u - c[0].u);
    const std::int32_t code = area > 0 ? ~triangle : triangle;
    const std::int64_t first_row = std::max<std::int64_t>(0, ceil_ray(std::min({c[0].v, c[1].v, c[2].v})));
    const std::int64_t end_row = std::min(rays_, ceil_ray(std::max({c[0].v, c[1].v, c[2].v})));
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
            out.push_back({static_cast<std::uint32_t>(row * rays_ + u), code,
                           plane->at(static_cast<double>(u), static_cast<double>(row))});
        }
    }
}

/// Sorts raw samples into rays, and along each ray by depth. At equal depth exits come first, so that two touching
/// sheets separate rather than overlap; then the lower triangle.
LayeredDepthImage gather(const std::vector<RawSet>& parts, int axis, std::size_t rays, const Progress* progress) {
    LayeredDepthImage result;
    result.begin.assign(rays * rays + 1, 0);
    std::size_t count = 0;
    for (const RawSet& part : parts) {
        check_cancelled(progress);
        count += part[axis].size();
        for (const RawSample& s : part[axis]) {
            ++result.begin[s.ray + 1];
        }
    }
    for (std::size_t k = 1; k < result.begin.size(); ++k) {
        result.begin[k] += result.begin[k - 1];
    }
    result.depth.resize(count);
    result.code.resize(count);
    std::vector<std::uint32_t> filled(rays * rays, 0);
    CancelPace pace(progress);
    for (const RawSet& part : parts) {
        for (const RawSample& s : part[axis]) {
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
    }
    return result;
}

}  // namespace

LayeredDepthSet rasterise(const OperandSet& pair, int operand, const SampleGrid& grid, const Progress* progress) {
    const Rasteriser rasteriser(pair, operand, grid);
    const std::int32_t first = pair.first_triangle[operand], end = pair.first_triangle[operand + 1];
    std::vector<RawSet> parts((end - first + kTrianglesPerTask - 1) / kTrianglesPerTask);
    parallel_for(static_cast<int>(parts.size()), [&](int k) {
        const std::int32_t from = first + k * kTrianglesPerTask;
        std::size_t checked = 0;
        for (std::int32_t t = from; t < std::min(end, from + kTrianglesPerTask); ++t) {
            const RawSet& own = parts[k];
            const std::size_t count = own[0].size() + own[1].size() + own[2].size();
            if (t == from || count > checked + kSamplesBetweenChecks) {
                check_cancelled(progress);
                checked = count;
            }
            rasteriser.sample(t, parts[k]);
        }
    });
    LayeredDepthSet result;
    parallel_for(
        3, [&](int axis) { result[axis] = gather(parts, axis, static_cast<std::size_t>(grid.rays()), progress); });
    return result;
}

}  // namespace mq::boolean
