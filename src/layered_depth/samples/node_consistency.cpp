// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/samples/node_consistency.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/parallel.h"

namespace mq::layered_depth {

namespace {

using GridNode = std::array<int, 3>;

/// A sample while its ray is rebuilt.
struct RaySample {
    double depth;
    std::int32_t triangle;
    SampleNormal normal;
    int turn;  // +1 enters, -1 leaves, 0 inserted: decided by its neighbours
};

/// The index of the unit interval between two nodes that contains a depth. A sample exactly at a node counts as before
/// it.
int interval(double depth) {
    return static_cast<int>(std::ceil(depth)) - 1;
}

/// Rows of rays that one thread copies at a time.
constexpr int kRowsAtATime = 32;

std::size_t band_count(int rays) {
    return static_cast<std::size_t>((rays + kRowsAtATime - 1) / kRowsAtATime);
}

/// The index of the first ray of a band; the number of all rays behind the last band.
std::uint32_t first_ray_of(int band, int rays) {
    return static_cast<std::uint32_t>(std::min(band * kRowsAtATime, rays)) * static_cast<std::uint32_t>(rays);
}

class NodeConsistency {
  public:
    NodeConsistency(LayeredDepthSet& set, const SampleGrid& grid, ConsistencyCounts& counts, const Progress* progress)
        : set_(set), rays_(grid.rays()), counts_(counts), progress_(progress) {}

    std::vector<SampleRef> run();

  private:
    using RayKey = std::pair<int, std::uint32_t>;  // axis and ray

    std::uint32_t ray_of(int axis, const GridNode& node) const {
        return static_cast<std::uint32_t>(node[(axis + 2) % 3] * rays_ + node[(axis + 1) % 3]);
    }
    bool within(const GridNode& node) const {
        return std::all_of(node.begin(), node.end(), [&](int k) { return k >= 0 && k < rays_; });
    }
    bool inside(int axis, const GridNode& node) const;
    bool agrees(const GridNode& node) const {
        const bool x = inside(0, node);
        return inside(1, node) == x && inside(2, node) == x;
    }
    template <typename Visit>
    void for_each_near(int axis, const GridNode& node, int first, int last, const Visit& visit) const;
    void find_nodes();
    void spread();
    bool truth(const GridNode& node) const;
    void find_turns();
    std::optional<RaySample> donor(int axis, std::uint32_t ray, int from) const;
    std::optional<std::vector<RaySample>> rebuilt(const RayKey& key, const std::vector<int>& turned) const;
    void replace(const std::map<RayKey, std::vector<RaySample>>& changed, std::vector<SampleRef>& inserted);
    LayeredDepthImage replaced(int axis, int band, const std::map<RayKey, std::vector<RaySample>>& changed,
                               std::vector<SampleRef>& inserted) const;

    LayeredDepthSet& set_;
    int rays_;
    ConsistencyCounts& counts_;
    const Progress* progress_;
    std::vector<GridNode> nodes_;               // nodes at which the rays do not agree, sorted
    std::map<RayKey, std::vector<int>> turns_;  // by ray: the nodes whose side the ray has wrong
};

/// Whether a node is inside by the normal index along one of its rays.
bool NodeConsistency::inside(int axis, const GridNode& node) const {
    const LayeredDepthImage& image = set_[axis];
    const std::uint32_t ray = ray_of(axis, node);
    int index = 0;
    for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1] && image.depth[i] <= node[axis]; ++i) {
        index += image.code[i] < 0 ? -1 : 1;
    }
    return index > 0;
}

/// Visits the samples on the node's ray in the unit intervals `first` to `last`.
template <typename Visit>
void NodeConsistency::for_each_near(int axis, const GridNode& node, int first, int last, const Visit& visit) const {
    const LayeredDepthImage& image = set_[axis];
    const std::uint32_t ray = ray_of(axis, node);
    for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1]; ++i) {
        const int at = interval(image.depth[i]);
        if (at >= first && at <= last) {
            visit(i);
        }
    }
}

/// Finds the nodes beside a sample at which the rays do not agree.
void NodeConsistency::find_nodes() {
    std::vector<std::vector<GridNode>> rows(3 * static_cast<std::size_t>(rays_));
    parallel_for(static_cast<int>(rows.size()), [&](int row) {
        check_cancelled(progress_);
        const int axis = row / rays_, v = row % rays_;
        const LayeredDepthImage& image = set_[axis];
        for (int u = 0; u < rays_; ++u) {
            const auto ray = static_cast<std::size_t>(v) * rays_ + u;
            for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1]; ++i) {
                if (!(image.depth[i] > -1.0 && image.depth[i] < rays_)) {
                    continue;  // the operand reaches beyond the grid
                }
                GridNode node{};
                node[(axis + 1) % 3] = u;
                node[(axis + 2) % 3] = v;
                for (int k = 0; k < 2; ++k) {
                    node[axis] = interval(image.depth[i]) + k;
                    if (within(node) && !agrees(node)) {
                        rows[row].push_back(node);
                    }
                }
            }
        }
    });
    for (const std::vector<GridNode>& row : rows) {
        nodes_.insert(nodes_.end(), row.begin(), row.end());
    }
}

/// Follows rays in a gap between mesh and face as far as the gap reaches, one node at a time.
void NodeConsistency::spread() {
    const auto tidy = [](std::vector<GridNode>& nodes) {
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    };
    tidy(nodes_);
    for (std::vector<GridNode> last = nodes_; !last.empty();) {
        check_cancelled(progress_);
        std::vector<GridNode> next;
        for (const GridNode& node : last) {
            for (int k = 0; k < 6; ++k) {
                GridNode other = node;
                other[k / 2] += k % 2 == 0 ? -1 : 1;
                if (within(other) && !std::binary_search(nodes_.begin(), nodes_.end(), other) && !agrees(other)) {
                    next.push_back(other);
                }
            }
        }
        tidy(next);
        nodes_.insert(nodes_.end(), next.begin(), next.end());
        std::sort(nodes_.begin(), nodes_.end());
        last = std::move(next);
    }
}

/// Whether a node is inside according to the ray that meets the surface beside it most nearly at right angles. If no
/// ray meets it, according to two of the three rays.
bool NodeConsistency::truth(const GridNode& node) const {
    // Least sine of the angle between a ray and the surface that it decides on; one of three rays has at least 0.57.
    constexpr float kSquare = 0.3F;
    int decides = -1;
    float best = kSquare;
    for (int axis = 0; axis < 3; ++axis) {
        for_each_near(axis, node, node[axis] - 1, node[axis], [&](std::uint32_t i) {
            const float square = std::abs(set_[axis].normal[i][axis]);
            if (square > best) {
                best = square;
                decides = axis;
            }
        });
    }
    if (decides >= 0) {
        return inside(decides, node);
    }
    const int votes = (inside(0, node) ? 1 : 0) + (inside(1, node) ? 1 : 0) + (inside(2, node) ? 1 : 0);
    return votes >= 2;
}

void NodeConsistency::find_turns() {
    std::vector<std::uint8_t> wrong(nodes_.size(), 0);  // by node: bits of the axes whose rays have its side wrong
    for_chunks(static_cast<int>(nodes_.size()), [&](int k) {
        const GridNode& node = nodes_[static_cast<std::size_t>(k)];
        const bool in = truth(node);
        for (int axis = 0; axis < 3; ++axis) {
            const unsigned bit = inside(axis, node) != in ? 1U << axis : 0U;
            wrong[static_cast<std::size_t>(k)] |= static_cast<std::uint8_t>(bit);
        }
    });
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            if ((wrong[k] >> axis & 1U) != 0) {
                turns_[{axis, ray_of(axis, nodes_[k])}].push_back(nodes_[k][axis]);
            }
        }
    }
    for (auto& turns : turns_) {
        std::sort(turns.second.begin(), turns.second.end());
    }
}

/// A new sample for the unit interval behind a node of a ray, on the tangent plane of a neighbouring sample: that of a
/// parallel ray in the same interval or, if there is none, that of a ray across it through one end of the interval.
std::optional<RaySample> NodeConsistency::donor(int axis, std::uint32_t ray, int from) const {
    const int u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    GridNode node{};
    node[axis] = from;
    node[u_axis] = static_cast<int>(ray) % rays_;
    node[v_axis] = static_cast<int>(ray) / rays_;
    std::optional<RaySample> found;
    float best = 0.0F;
    const auto consider = [&](int other_axis, const GridNode& other, std::uint32_t i) {
        const LayeredDepthImage& image = set_[other_axis];
        const float square = std::abs(image.normal[i][other_axis]);
        if (square <= best) {
            return;
        }
        best = square;
        Vec3 p(other[0], other[1], other[2]);
        p[other_axis] = image.depth[i];
        const Vec3 n = image.normal[i].cast<double>();
        const double rise = n[u_axis] * (node[u_axis] - p[u_axis]) + n[v_axis] * (node[v_axis] - p[v_axis]);
        const double depth = n[axis] != 0.0 ? p[axis] - rise / n[axis] : p[axis];
        // Keeps the sample away from the ends of the interval, which belong to the neighbouring intervals.
        constexpr double kInset = 1e-3;
        found = RaySample{std::clamp(depth, from + kInset, from + 1.0 - kInset), image.triangle(i), image.normal[i], 0};
    };
    for (int k = 0; k < 4; ++k) {
        GridNode other = node;
        other[k < 2 ? u_axis : v_axis] += k % 2 == 0 ? -1 : 1;
        if (within(other)) {
            for_each_near(axis, other, from, from, [&](std::uint32_t i) { consider(axis, other, i); });
        }
    }
    for (int k = 0; k < 4 && !found; ++k) {
        GridNode other = node;
        other[axis] += k % 2;
        const int across = k < 2 ? u_axis : v_axis;
        if (within(other)) {
            for_each_near(across, other, other[across] - 1, other[across],
                          [&](std::uint32_t i) { consider(across, other, i); });
        }
    }
    return found;
}

/// The samples of a ray with the nodes in `turned` on the other side; empty if surfaces overlap, or if no sample nearby
/// gives the place of a crossing. Intervals between nodes that stay keep their samples. Each other interval gets the
/// most nearly perpendicular crossing if its ends differ, and none if they are equal.
std::optional<std::vector<RaySample>> NodeConsistency::rebuilt(const RayKey& key,
                                                               const std::vector<int>& turned) const {
    const auto [axis, ray] = key;
    const LayeredDepthImage& image = set_[axis];
    std::vector<RaySample> samples;
    std::uint32_t i = image.begin[ray];
    const std::uint32_t end = image.begin[ray + 1];
    bool before = false;  // whether the previous node was inside
    const auto sample = [&](std::uint32_t k) {
        return RaySample{image.depth[k], image.triangle(k), image.normal[k], image.code[k] < 0 ? -1 : 1};
    };
    std::size_t next = 0;
    bool was_turned = false;
    for (int k = -1; k < rays_; ++k) {
        // The interval from node k to the next one; the first and the last interval are unbounded.
        std::vector<RaySample> here;
        bool after = before;
        for (; i < end && (k == rays_ - 1 || image.depth[i] <= k + 1); ++i) {
            here.push_back(sample(i));
            if ((here.back().turn > 0) == after) {
                return std::nullopt;
            }
            after = !after;
        }
        const bool turns = next < turned.size() && turned[next] == k + 1;
        next += turns ? 1 : 0;
        const bool from = before != was_turned, to = after != turns;
        if (!was_turned && !turns) {
            samples.insert(samples.end(), here.begin(), here.end());
        } else if (from != to) {
            std::optional<RaySample> best;
            for (const RaySample& s : here) {
                const bool squarer = !best || std::abs(s.normal[axis]) > std::abs(best->normal[axis]);
                best = (s.turn > 0) == to && squarer ? s : best;
            }
            if (!best && k >= 0 && k < rays_ - 1) {
                best = donor(axis, ray, k);
            }
            if (!best) {
                return std::nullopt;
            }
            samples.push_back(*best);
        }
        before = after;
        was_turned = turns;
    }
    return samples;
}

/// Replaces the old rays by the rebuilt ones.
void NodeConsistency::replace(const std::map<RayKey, std::vector<RaySample>>& changed,
                              std::vector<SampleRef>& inserted) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto first = changed.lower_bound({axis, 0});
        if (first == changed.end() || first->first.first != axis) {
            continue;
        }
        std::vector<LayeredDepthImage> bands(band_count(rays_));
        std::vector<std::vector<SampleRef>> inserted_in(bands.size());
        parallel_for(static_cast<int>(bands.size()), [&](int band) {
            const auto k = static_cast<std::size_t>(band);
            bands[k] = replaced(axis, band, changed, inserted_in[k]);
        });
        std::uint32_t before = 0;  // number of samples in the previous bands
        for (std::size_t k = 0; k < bands.size(); ++k) {
            for (SampleRef& ref : inserted_in[k]) {
                inserted.push_back({ref.axis, ref.ray, ref.index + before});
            }
            before += static_cast<std::uint32_t>(bands[k].depth.size());
        }
        set_[axis] = joined(bands);
    }
}

/// The rays of a band, some of them rebuilt; inserted samples get their indices in the band.
LayeredDepthImage NodeConsistency::replaced(int axis, int band, const std::map<RayKey, std::vector<RaySample>>& changed,
                                            std::vector<SampleRef>& inserted) const {
    const LayeredDepthImage& old = set_[axis];
    const std::uint32_t first = first_ray_of(band, rays_), end = first_ray_of(band + 1, rays_);
    LayeredDepthImage image;
    image.begin.push_back(0);
    auto next = changed.lower_bound({axis, first});
    for (std::uint32_t ray = first; ray < end; ++ray) {
        if (next != changed.end() && next->first == RayKey(axis, ray)) {
            for (std::size_t i = 0; i < next->second.size(); ++i) {
                const RaySample& s = next->second[i];
                if (s.turn == 0) {
                    inserted.push_back({axis, ray, static_cast<std::uint32_t>(image.depth.size())});
                }
                image.depth.push_back(s.depth);
                image.code.push_back(i % 2 == 0 ? s.triangle : ~s.triangle);
                image.normal.push_back(s.normal);
            }
            ++next;
        } else {
            const std::uint32_t from = old.begin[ray], to = old.begin[ray + 1];
            image.depth.insert(image.depth.end(), old.depth.begin() + from, old.depth.begin() + to);
            image.code.insert(image.code.end(), old.code.begin() + from, old.code.begin() + to);
            image.normal.insert(image.normal.end(), old.normal.begin() + from, old.normal.begin() + to);
        }
        image.begin.push_back(static_cast<std::uint32_t>(image.depth.size()));
    }
    return image;
}

std::vector<SampleRef> NodeConsistency::run() {
    find_nodes();
    spread();
    find_turns();
    std::map<RayKey, std::vector<RaySample>> changed;
    const std::vector<std::pair<RayKey, std::vector<int>>> turns(turns_.begin(), turns_.end());
    std::vector<std::optional<std::vector<RaySample>>> rays(turns.size());
    for_chunks(static_cast<int>(turns.size()), [&](int k) {
        check_cancelled(progress_);
        const auto& [key, nodes] = turns[static_cast<std::size_t>(k)];
        rays[static_cast<std::size_t>(k)] = rebuilt(key, nodes);
    });
    for (std::size_t k = 0; k < turns.size(); ++k) {
        if (rays[k]) {
            changed.emplace(turns[k].first, std::move(*rays[k]));
        }
    }
    std::size_t before = 0, after = 0;
    for (const auto& [key, samples] : changed) {
        before += set_[key.first].begin[key.second + 1] - set_[key.first].begin[key.second];
        after += samples.size();
    }
    std::vector<SampleRef> inserted;
    replace(changed, inserted);
    counts_.nodes += nodes_.size();
    counts_.inserted += inserted.size();
    counts_.removed += before + inserted.size() - after;
    counts_.left += static_cast<std::size_t>(
        std::count_if(nodes_.begin(), nodes_.end(), [&](const GridNode& node) { return !agrees(node); }));
    return inserted;
}

using OrderedSamples = std::vector<std::tuple<double, std::int32_t, SampleNormal>>;

/// Whether a ray that is outside touches the solid only: it leaves the solid where it enters.
bool only_touches(OrderedSamples::const_iterator at, OrderedSamples::const_iterator end) {
    return std::get<1>(*at) < 0 && at + 1 != end && std::get<1>(at[1]) >= 0 && std::get<0>(at[1]) == std::get<0>(*at);
}

/// Some consecutive rays with their samples in ascending order.
LayeredDepthImage in_order(const LayeredDepthImage& image, std::size_t first_ray, std::size_t end_ray) {
    LayeredDepthImage result;
    result.begin.push_back(0);
    std::vector<std::uint32_t> kept;
    OrderedSamples samples;
    for (std::size_t ray = first_ray; ray < end_ray; ++ray) {
        kept.clear();
        for (std::uint32_t i = image.begin[ray]; i < image.begin[ray + 1]; ++i) {
            const bool passed = !kept.empty() && image.depth[kept.back()] > image.depth[i] &&
                                (image.code[kept.back()] < 0) != (image.code[i] < 0);
            if (passed) {
                kept.pop_back();
            } else {
                kept.push_back(i);
            }
        }
        std::sort(kept.begin(), kept.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tie(image.depth[a], image.code[a]) < std::tie(image.depth[b], image.code[b]);
        });
        samples.clear();
        for (const std::uint32_t i : kept) {
            samples.emplace_back(image.depth[i], image.code[i], image.normal[i]);
        }
        int index = 0;
        for (std::size_t i = 0; i < samples.size();) {
            const auto at = samples.begin() + static_cast<std::ptrdiff_t>(i);
            if (index == 0 && only_touches(at, samples.end())) {
                samples.erase(at, at + 2);
            } else {
                index += std::get<1>(samples[i++]) < 0 ? -1 : 1;
            }
        }
        for (const auto& [depth, code, normal] : samples) {
            result.depth.push_back(depth);
            result.code.push_back(code);
            result.normal.push_back(normal);
        }
        result.begin.push_back(static_cast<std::uint32_t>(result.depth.size()));
    }
    return result;
}

}  // namespace

std::size_t restore_order(LayeredDepthImage& image) {
    const std::size_t before = image.depth.size(), rays = image.begin.size() - 1;
    // Rays that one thread sorts at a time.
    constexpr std::size_t kRays = std::size_t{1} << 14;
    std::vector<LayeredDepthImage> bands((rays + kRays - 1) / kRays);
    parallel_for(static_cast<int>(bands.size()), [&](int k) {
        const std::size_t first = static_cast<std::size_t>(k) * kRays;
        bands[static_cast<std::size_t>(k)] = in_order(image, first, std::min(first + kRays, rays));
    });
    image = joined(bands);
    return before - image.depth.size();
}

std::vector<SampleRef> make_consistent(LayeredDepthSet& set, const SampleGrid& grid, ConsistencyCounts& counts,
                                       const Progress* progress) {
    return NodeConsistency(set, grid, counts, progress).run();
}

}  // namespace mq::layered_depth
