// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/winding_samples.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "layered_depth/samples/winding_blocks.h"

namespace mq::layered_depth {

namespace {

/// Cells: stops along a ray nearer than this count as one, as a point between them would lie on the triangles.
constexpr double kNearest = 1e-6;
/// Tolerance, in cells, of a crossing of 0.5, and the most steps of its search.
constexpr double kCrossing = 1e-4;
constexpr int kCrossingSteps = 12;

struct RaySamples {
    std::vector<double> depth;
    std::vector<std::int32_t> code;
    std::vector<SampleNormal> normal;
    std::vector<std::uint32_t> counts;  // samples of each ray
    std::size_t hits = 0, kept = 0;
    double kept_area = 0.0, guessed_area = 0.0;
};

/// Walks along the rays of one axis.
class RayWalk {
  public:
    RayWalk(const LayeredDepthImage& image, int axis, const OperandSet& operands, int operand, const SampleGrid& grid,
            const mesh::SurfaceWinding& winding, const WindingBlocks& blocks, const Box& box)
        : image_(image),
          axis_(axis),
          operands_(operands),
          gap_(operands.first_gap[operand]),
          grid_(grid),
          winding_(winding),
          blocks_(blocks),
          box_(box) {}

    /// Appends the samples of a ray.
    void walk(std::size_t ray, RaySamples& out);

  private:
    /// A place where the winding number is known.
    struct Known {
        double depth = 0.0;
        double winding = 0.0;
        double doubt = 0.0;  ///< bound of its error
        bool known = false;
        bool inside() const { return winding >= kInsideWinding; }
    };

    Vec3 point(double depth) const {
        Vec3 g = node_;
        g[axis_] = depth;
        return grid_.to_space(g);
    }
    double evaluate(double depth) const { return winding_.at(point(depth)); }
    void arrive(double depth, double winding, double doubt);
    bool count_through(double end, double change);
    void examine(double depth);
    void examine_all(double end);
    void change_sides(double depth);
    void cross_box();
    void put(double depth, std::int32_t triangle, const Vec3& normal);
    void put_gap(double from, double to);

    const LayeredDepthImage& image_;
    int axis_;
    const OperandSet& operands_;
    std::int32_t gap_;
    const SampleGrid& grid_;
    const mesh::SurfaceWinding& winding_;
    const WindingBlocks& blocks_;
    Box box_;  // the operand's box in grid coordinates, cut to the grid

    Vec3 node_ = Vec3::Zero();  // the ray's coordinates on the two axes across it
    std::uint32_t first_hit_ = 0, hit_ = 0, end_ = 0;
    std::uint32_t pending_ = 0;  // first sample behind the last known place
    Known last_;
    bool inside_ = false;
    RaySamples* out_ = nullptr;
};

void RayWalk::put(double depth, std::int32_t triangle, const Vec3& normal) {
    inside_ = !inside_;
    out_->depth.push_back(depth);
    out_->code.push_back(inside_ ? triangle : ~triangle);
    out_->normal.emplace_back(normal.cast<float>());
    // The rays of three directions meet a unit of area as often as its normal has components in all.
    (triangle == gap_ ? out_->guessed_area : out_->kept_area) += 1.0 / std::max(1.0, normal.lpNorm<1>());
}

/// Makes a sample at the depth between two depths, with no triangle between them, at which the number crosses 0.5
/// (Illinois method).
void RayWalk::put_gap(double from, double to) {
    double f = evaluate(from) - kInsideWinding, g = evaluate(to) - kInsideWinding;
    double depth = 0.5 * (from + to);
    for (int step = 0; step < kCrossingSteps && f * g < 0.0; ++step) {
        depth = (from * g - to * f) / (g - f);
        const double h = evaluate(depth) - kInsideWinding;
        if (std::abs(h) < kCrossing) {
            break;
        }
        if (h * g < 0.0) {
            from = to;
            f = g;
        } else {
            f *= 0.5;
        }
        to = depth;
        g = h;
    }
    Vec3 normal = -winding_.gradient(point(depth)).normalized();
    if (!normal.allFinite() || normal.isZero()) {
        normal = Vec3::Unit(axis_) * (inside_ ? 1.0 : -1.0);
    }
    put(depth, gap_, normal);
}

/// Records that the ray has changed sides before a known place: on the sample before it, or between samples.
void RayWalk::change_sides(double depth) {
    if (pending_ == hit_) {
        put_gap(last_.depth, depth);
        return;
    }
    std::uint32_t found = hit_;
    for (std::uint32_t i = pending_; i < hit_; ++i) {
        // Takes the outermost of several samples: the first that enters, the last that leaves.
        if ((image_.code[i] >= 0) != inside_ && (inside_ || found == hit_)) {
            found = i;
        }
    }
    if (found < hit_) {
        put(image_.depth[found], image_.triangle(found), operands_.unit_normal(image_.triangle(found)));
        ++out_->kept;
        return;
    }
    // The only triangle there is oriented the other way: it does not bound the solid.
    put(image_.depth[pending_], gap_, -operands_.unit_normal(image_.triangle(pending_)));
}

void RayWalk::arrive(double depth, double winding, double doubt) {
    if ((winding >= kInsideWinding) != inside_) {
        change_sides(depth);
    }
    last_ = {depth, winding, doubt, true};
    pending_ = hit_;
}

/// Passes the samples up to `end` by counting, if the number stays far enough from 0.5 that there is no doubt.
/// @param change bound of the number's change on the way
bool RayWalk::count_through(double end, double change) {
    const double doubt = last_.doubt + change;
    double winding = last_.winding;
    const auto doubtful = [&] { return std::abs(winding - kInsideWinding) <= doubt + kWindingError; };
    bool sure = last_.known && !doubtful();
    std::uint32_t next = hit_;
    for (; sure && next < end_ && image_.depth[next] <= end; ++next) {
        winding += image_.code[next] >= 0 ? 1.0 : -1.0;
        sure = !doubtful();
    }
    if (!sure) {
        return false;
    }
    while (hit_ < next) {
        const double step = image_.code[hit_] >= 0 ? 1.0 : -1.0;
        const double depth = image_.depth[hit_++];
        arrive(depth, last_.winding + step, last_.doubt);
    }
    arrive(end, last_.winding, doubt);
    return true;
}

/// Evaluates the number at a depth unless a sample is there.
void RayWalk::examine(double depth) {
    const bool behind = hit_ == first_hit_ || image_.depth[hit_ - 1] < depth - kNearest;
    const bool before = hit_ == end_ || image_.depth[hit_] > depth + kNearest;
    if (behind && before) {
        arrive(depth, evaluate(depth), 0.0);
    } else {
        last_.depth = depth;
        last_.known = false;
    }
}

/// Passes the samples up to `end` by evaluating the number at the nodes, and in the middle between samples.
void RayWalk::examine_all(double end) {
    for (double node = std::floor(last_.depth) + 1.0;; node += 1.0) {
        const double stop = std::min(node, end);
        bool after_hit = false;
        while (hit_ < end_ && image_.depth[hit_] <= stop) {
            if (after_hit) {
                examine(0.5 * (image_.depth[hit_ - 1] + image_.depth[hit_]));
            }
            ++hit_;
            after_hit = true;
        }
        examine(stop);
        if (stop >= end) {
            return;
        }
    }
}

/// Walks from the front of the operand's box to its back.
void RayWalk::cross_box() {
    const double last = box_.high[axis_];
    while (hit_ < end_ && image_.depth[hit_] < box_.low[axis_]) {
        ++hit_;
    }
    first_hit_ = pending_ = hit_;
    last_ = {box_.low[axis_], 0.0, 0.0, false};
    while (last_.depth < last) {
        Vec3 g = node_;
        g[axis_] = last_.depth;
        const WindingBlocks::Block& block = blocks_.at(g);
        const double end = std::min<double>(last, block.low[axis_] + block.size);
        if (block.decided) {
            while (hit_ < end_ && image_.depth[hit_] <= end) {
                ++hit_;  // on the wall of the block, up to rounding
            }
            arrive(last_.depth, block.winding, block.doubt());
            last_.depth = end;
            continue;
        }
        const double change = block.change * (end - last_.depth);
        bool passed = count_through(end, change);
        if (!passed && !(last_.known && last_.doubt == 0.0)) {
            examine(last_.depth);
            passed = count_through(end, change);
        }
        if (!passed) {
            examine_all(end);
        }
    }
    if (inside_) {  // points outside of the operand's box are outside of it
        put(last, gap_, Vec3::Unit(axis_));
    }
}

void RayWalk::walk(std::size_t ray, RaySamples& out) {
    const std::size_t before = out.depth.size();
    const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    node_[u] = static_cast<double>(ray % static_cast<std::size_t>(grid_.rays()));
    node_[v] = static_cast<double>(ray / static_cast<std::size_t>(grid_.rays()));
    out_ = &out;
    hit_ = image_.begin[ray];
    end_ = image_.begin[ray + 1];
    out.hits += end_ - hit_;
    inside_ = false;
    if (box_.low[u] <= node_[u] && node_[u] <= box_.high[u] && box_.low[v] <= node_[v] && node_[v] <= box_.high[v]) {
        cross_box();
    }
    out.counts.push_back(static_cast<std::uint32_t>(out.depth.size() - before));
}

LayeredDepthImage joined(std::vector<RaySamples>& rows, WindingSampleCounts& counts) {
    LayeredDepthImage image;
    image.begin.push_back(0);
    for (RaySamples& row : rows) {
        for (const std::uint32_t n : row.counts) {
            image.begin.push_back(image.begin.back() + n);
        }
        image.depth.insert(image.depth.end(), row.depth.begin(), row.depth.end());
        image.code.insert(image.code.end(), row.code.begin(), row.code.end());
        image.normal.insert(image.normal.end(), row.normal.begin(), row.normal.end());
        counts.kept += row.kept;
        counts.dropped += row.hits - row.kept;
        counts.guessed += row.depth.size() - row.kept;
        counts.kept_area += row.kept_area;
        counts.guessed_area += row.guessed_area;
        row = {};
    }
    return image;
}

/// The box of the operand in grid coordinates, cut to the grid.
Box box_in_grid(const mesh::SurfaceWinding& winding, const SampleGrid& grid) {
    Box box;
    const Box whole = winding.tree().box();
    box.low = grid.to_grid(whole.low).cwiseMax(0.0);
    box.high = grid.to_grid(whole.high).cwiseMin(static_cast<double>(grid.cells()));
    return box;
}

}  // namespace

void sample_by_winding(LayeredDepthSet& set, const OperandSet& operands, int operand, const SampleGrid& grid,
                       const mesh::SurfaceWinding& winding, WindingSampleCounts& counts, const Progress* progress) {
    const WindingBlocks blocks(grid, winding, winding.tree().box(), progress);
    const Box box = box_in_grid(winding, grid);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<RaySamples> rows(static_cast<std::size_t>(grid.rays()));
        parallel_for(grid.rays(), [&](int v) {
            RayWalk walk(set[axis], axis, operands, operand, grid, winding, blocks, box);
            for (int u = 0; u < grid.rays(); ++u) {
                if (u % 64 == 0) {
                    check_cancelled(progress);
                }
                walk.walk(
                    static_cast<std::size_t>(v) * static_cast<std::size_t>(grid.rays()) + static_cast<std::size_t>(u),
                    rows[static_cast<std::size_t>(v)]);
            }
        });
        set[axis] = joined(rows, counts);
    }
    make_consistent(set, grid, counts.nodes, progress);
}

}  // namespace mq::layered_depth
