// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/aabb_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace mq::mesh {
namespace {

/// Largest number of triangles in a leaf, which is tested triangle by triangle.
constexpr std::size_t kLeafSize = 4;
/// The next single-precision number toward minus infinity; std::nextafter, but inlined.
float next_below(float x) {
    if (x == 0.0f) {
        return -std::numeric_limits<float>::denorm_min();
    }
    std::int32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    bits += x > 0.0f ? -1 : 1;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

float round_down(double x) {
    const auto rounded = static_cast<float>(x);
    return static_cast<double>(rounded) <= x ? rounded : next_below(rounded);
}

float round_up(double x) {
    return -round_down(-x);
}

}  // namespace

void AabbTree::Bounds::add(const Bounds& o) {
    for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], o.low[i]);
        high[i] = std::max(high[i], o.high[i]);
    }
}

AabbTree::Bounds AabbTree::outward(const Box& box) {
    return {{round_down(box.low.x()), round_down(box.low.y()), round_down(box.low.z())},
            {round_up(box.high.x()), round_up(box.high.y()), round_up(box.high.z())}};
}

AabbTree::Bounds AabbTree::bounds_of(std::int32_t triangle) const {
    const Triangle& t = (*triangles_)[triangle];
    const Vec3& a = (*vertices_)[t[0]];
    const Vec3& b = (*vertices_)[t[1]];
    const Vec3& c = (*vertices_)[t[2]];
    Bounds bounds;
    for (int i = 0; i < 3; ++i) {
        bounds.low[i] = round_down(std::min(a[i], std::min(b[i], c[i])) - slack_);
        bounds.high[i] = round_up(std::max(a[i], std::max(b[i], c[i])) + slack_);
    }
    return bounds;
}

AabbTree::AabbTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, double slack)
    : vertices_(&vertices), triangles_(&triangles), slack_(slack) {
    LargeVector<MortonKey> keys(triangles.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        keys[i].item = static_cast<std::uint32_t>(i);
    }
    build(std::move(keys));
}

AabbTree::AabbTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                   const std::vector<std::int32_t>& subset, double slack)
    : vertices_(&vertices), triangles_(&triangles), slack_(slack) {
    LargeVector<MortonKey> keys(subset.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        keys[i].item = static_cast<std::uint32_t>(subset[i]);
    }
    build(std::move(keys));
}

Box AabbTree::node_box(std::int32_t node) const {
    const Bounds& bounds = nodes_[static_cast<std::size_t>(node)].bounds;
    Box box;
    box.low = Vec3(bounds.low[0], bounds.low[1], bounds.low[2]);
    box.high = Vec3(bounds.high[0], bounds.high[1], bounds.high[2]);
    return box;
}

Box AabbTree::box() const {
    return nodes_.empty() ? Box() : node_box(0);
}

void AabbTree::build(LargeVector<MortonKey> triangles) {
    if (triangles.empty()) {
        return;
    }
    sort(triangles);
    items_.reserve(triangles.size());
    for (const MortonKey& key : triangles) {
        const auto triangle = static_cast<std::int32_t>(key.item);
        items_.push_back({bounds_of(triangle), triangle, key.code});
    }
    nodes_.reserve(items_.size());
    nodes_.push_back({});
    build_node(0, 0, items_.size());
}

/// Sorts by the Morton code of the boxes' middles, in cubic cells; ties by position in the input.
void AabbTree::sort(LargeVector<MortonKey>& triangles) const {
    Box box;
    for (const MortonKey& key : triangles) {
        for (const std::int32_t v : (*triangles_)[key.item]) {
            box.add((*vertices_)[v]);
        }
    }
    const Bounds all = outward({box.low - Vec3::Constant(slack_), box.high + Vec3::Constant(slack_)});
    double side = 0.0;
    for (int i = 0; i < 3; ++i) {
        side = std::max(side, double(all.high[i]) - double(all.low[i]));
    }
    const double scale = side > 0.0 ? 0.5 * (kMortonCells - 1) / side : 0.0;
    for (MortonKey& key : triangles) {
        // Boxes are computed again in the order of the items, as moving them takes longer.
        const Bounds bounds = bounds_of(static_cast<std::int32_t>(key.item));
        std::array<double, 3> cell{};
        for (int i = 0; i < 3; ++i) {
            const double twice_middle = double(bounds.low[i]) + double(bounds.high[i]) - 2.0 * double(all.low[i]);
            // Not a number if bounds are infinite or beyond single precision: then items need no order.
            cell[i] = twice_middle * scale;
        }
        key.code = morton_code(cell);
    }
    sort_by_code(triangles);
}

void AabbTree::build_node(std::int32_t node, std::size_t begin, std::size_t end) {
    if (end - begin <= kLeafSize) {
        Bounds bounds = items_[begin].bounds;
        for (std::size_t i = begin + 1; i < end; ++i) {
            bounds.add(items_[i].bounds);
        }
        nodes_[node] = {bounds, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end - begin)};
        return;
    }
    const std::size_t middle = split(begin, end);
    const auto child = static_cast<std::int32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    build_node(child, begin, middle);
    build_node(child + 1, middle, end);
    Bounds bounds = nodes_[child].bounds;
    bounds.add(nodes_[child + 1].bounds);
    nodes_[node] = {bounds, child, 0};
}

/// Where the second half begins: at the highest bit in which the codes differ; within one cell of the Morton grid at
/// the median along the longest side of the middles' box.
std::size_t AabbTree::split(std::size_t begin, std::size_t end) {
    const std::uint32_t differing = items_[begin].code ^ items_[end - 1].code;
    if (differing != 0) {
        std::uint32_t bit = differing;
        while ((bit & (bit - 1)) != 0) {
            bit &= bit - 1;
        }
        const auto second = std::partition_point(items_.begin() + begin, items_.begin() + end,
                                                 [bit](const Item& item) { return (item.code & bit) == 0; });
        return second - items_.begin();
    }
    const auto middle_of = [](const Item& item, int i) {
        return double(item.bounds.low[i]) + double(item.bounds.high[i]);
    };
    Box middles;
    for (std::size_t k = begin; k < end; ++k) {
        middles.add(Vec3(middle_of(items_[k], 0), middle_of(items_[k], 1), middle_of(items_[k], 2)));
    }
    int axis = 0;
    (middles.high - middles.low).maxCoeff(&axis);
    const std::size_t median = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + median, items_.begin() + end,
                     [&](const Item& a, const Item& b) {
                         const double x = middle_of(a, axis);
                         const double y = middle_of(b, axis);
                         return x != y ? x < y : a.triangle < b.triangle;
                     });
    return median;
}

void AabbTree::set_groups(const std::vector<std::int32_t>& group) {
    node_group_.resize(nodes_.size());
    for (std::size_t k = nodes_.size(); k-- > 0;) {
        const Node& node = nodes_[k];
        if (node.count == 0) {
            const std::int32_t first = node_group_[node.first];
            node_group_[k] = first == node_group_[node.first + 1] ? first : -1;
            continue;
        }
        node_group_[k] = group[items_[node.first].triangle];
        for (std::int32_t i = node.first + 1; i < node.first + node.count; ++i) {
            node_group_[k] = group[items_[i].triangle] == node_group_[k] ? node_group_[k] : -1;
        }
    }
}

/// Finds the leaves near triangles of other groups by descending pairs of nodes.
class AabbTree::NearGroups {
  public:
    NearGroups(const AabbTree& tree, double distance, const Progress* progress)
        : tree_(tree), distance_(distance), near_(tree.nodes_.size(), 0), pace_(progress) {}

    void visit(std::int32_t a, std::int32_t b) {
        pace_.step();
        if (tree_.in_one_group({a, b}) || (is_near(a) && is_near(b)) || !within_distance(a, b)) {
            return;
        }
        const Node& first = tree_.nodes_[a];
        const Node& second = tree_.nodes_[b];
        if (first.count > 0 && second.count > 0) {
            near_[a] = near_[b] = 1;
        } else if (a == b) {
            visit(first.first, first.first);
            visit(first.first + 1, first.first + 1);
            visit(first.first, first.first + 1);
            join(a);
        } else if (divide_first(first, second)) {
            visit(first.first, b);
            visit(first.first + 1, b);
            join(a);
        } else {
            visit(a, second.first);
            visit(a, second.first + 1);
            join(b);
        }
    }
    /// Whether all triangles of a node are known to be near others.
    bool is_near(std::int32_t node) const { return near_[node] != 0; }

  private:
    bool within_distance(std::int32_t a, std::int32_t b) const {
        const Bounds& one = tree_.nodes_[a].bounds;
        const Bounds& other = tree_.nodes_[b].bounds;
        for (int i = 0; i < 3; ++i) {
            if (double(one.low[i]) - other.high[i] > distance_ || double(other.low[i]) - one.high[i] > distance_) {
                return false;
            }
        }
        return true;
    }
    void join(std::int32_t node) {
        const std::int32_t child = tree_.nodes_[node].first;
        near_[node] = static_cast<char>(is_near(child) && is_near(child + 1));
    }

    const AabbTree& tree_;
    double distance_;
    std::vector<char> near_;  ///< by node
    CancelPace pace_;
};

std::vector<std::int32_t> AabbTree::near_other_groups(double distance, const Progress* progress) const {
    std::vector<std::int32_t> result;
    if (items_.empty()) {
        return result;
    }
    NearGroups search(*this, distance, progress);
    search.visit(0, 0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (nodes_[n].count > 0 && search.is_near(static_cast<std::int32_t>(n))) {
            for (std::int32_t i = 0; i < nodes_[n].count; ++i) {
                result.push_back(items_[nodes_[n].first + i].triangle);
            }
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::size_t AabbTree::size_of(std::int32_t node) const {
    std::int32_t first = node;
    std::int32_t last = node;
    while (nodes_[first].count == 0) {
        first = nodes_[first].first;
    }
    while (nodes_[last].count == 0) {
        last = nodes_[last].first + 1;
    }
    return static_cast<std::size_t>(nodes_[last].first + nodes_[last].count - nodes_[first].first);
}

void AabbTree::divide(Task task, std::vector<Task>& next) const {
    const Node& a = nodes_[task.a];
    const Node& b = nodes_[task.b];
    if (in_one_group(task)) {
        return;
    }
    if (task.a == task.b && a.count == 0) {
        next.push_back({a.first, a.first});
        next.push_back({a.first + 1, a.first + 1});
        next.push_back({a.first, a.first + 1});
    } else if (task.a == task.b || (a.count > 0 && b.count > 0)) {
        next.push_back(task);
    } else if (a.bounds.meets(b.bounds) && divide_first(a, b)) {
        next.push_back({a.first, task.b});
        next.push_back({a.first + 1, task.b});
    } else if (a.bounds.meets(b.bounds)) {
        next.push_back({task.a, b.first});
        next.push_back({task.a, b.first + 1});
    }
}

std::vector<AabbTree::Task> AabbTree::own_pair_tasks(std::size_t count) const {
    if (size() == 0) {
        return {};
    }
    const std::size_t most = std::max<std::size_t>(1, size() / count);
    std::vector<Task> tasks{{0, 0}};
    for (bool changed = true; changed;) {
        std::vector<Task> next;
        changed = false;
        for (const Task& task : tasks) {
            const std::size_t before = next.size();
            if (std::max(size_of(task.a), size_of(task.b)) <= most) {
                next.push_back(task);
                continue;
            }
            divide(task, next);
            const bool same = next.size() == before + 1 && next[before].a == task.a && next[before].b == task.b;
            changed = changed || !same;
        }
        tasks.swap(next);
    }
    return tasks;
}

}  // namespace mq::mesh
