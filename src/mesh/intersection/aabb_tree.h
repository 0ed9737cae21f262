// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/progress.h"
#include "base/vec.h"
#include "mesh/morton_sort.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// A hierarchy of bounding boxes over triangles (Lauterbach et al. 2009: Morton order, split at the highest bit that
/// differs). Built in O(n); about 0.1 s for a million triangles.
///
/// Boxes are closed and stored in single precision, rounded outward: a query never misses a triangle that it should
/// report, but it may report one whose box is only within a rounding of the query. Triangles are reported by their
/// index in the vector given, in an order that depends on the input only.
///
/// The vertices and triangles are referred to, not copied: they must outlive the tree and keep their places. All
/// indices must be in range and all coordinates finite.
class AabbTree {
  public:
    /// @param slack  mm, by which boxes are larger than their triangles on all sides: for vertices with rounding errors
    AabbTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, double slack = 0.0);
    /// A tree over some of the triangles only, each named once.
    AabbTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
             const std::vector<std::int32_t>& subset, double slack = 0.0);

    std::size_t size() const { return items_.size(); }
    /// The box of all triangles, rounded outward; empty when there are none.
    Box box() const;

    /// Sets the group of each triangle; -1: none. Pairs within a group need not be reported as own pairs, but may be
    /// where a subtree contains several groups.
    void set_groups(const std::vector<std::int32_t>& group);

    /// A superset of the triangles whose boxes are within a distance of the box of a triangle of another group;
    /// ascending. Every triangle must have a group. Leaves and subtrees that are near as a whole are not divided, so
    /// that n triangles in one place take n steps.
    /// @throws Cancelled
    std::vector<std::int32_t> near_other_groups(double distance, const Progress* progress) const;

    /// One task of a traversal: all pairs between two subtrees, or within one when they are the same.
    struct Task {
        std::int32_t a = 0;
        std::int32_t b = 0;
    };
    /// Divides the search for own pairs into tasks for several threads, of which each concerns subtrees with at most a
    /// `count`th of the triangles; the concatenation of the tasks' pairs is the list that for_each_own_pair gives.
    std::vector<Task> own_pair_tasks(std::size_t count) const;

    /// visit(i, j) for each triangle i of this tree and j of the other whose boxes meet.
    template <typename Visit>
    void for_each_pair(const AabbTree& other, Visit&& visit) const;

    /// visit(i, j) once for each two different triangles of this tree whose boxes meet. A visit that returns a bool
    /// ends the search by false; so do those of the traversals below.
    template <typename Visit>
    void for_each_own_pair(Visit&& visit) const {
        if (size() > 0) {
            for_each_own_pair(Task{0, 0}, visit);
        }
    }
    template <typename Visit>
    void for_each_own_pair(Task task, Visit&& visit) const;

    /// visit(i) for each triangle whose box meets the closed box.
    template <typename Visit>
    void for_each_in_box(const Box& box, Visit&& visit) const;

    /// visit(i) for each triangle whose box meets the points origin + t direction, 0 <= t <= reach.
    template <typename Visit>
    void for_each_on_ray(const Vec3& origin, const Vec3& direction, double reach, Visit&& visit) const;
    template <typename Visit>
    void for_each_on_ray(const Vec3& origin, const Vec3& direction, Visit&& visit) const {
        for_each_on_ray(origin, direction, std::numeric_limits<double>::infinity(), visit);
    }

    // ---- values of nodes, for sums over triangles in which far triangles are summed as one ----

    std::size_t node_count() const { return nodes_.size(); }
    Box node_box(std::int32_t node) const;
    /// Children before their parents: add(node, i) for each triangle i of a leaf, join(node, child) for the two
    /// children of every other node.
    template <typename Add, typename Join>
    void sum_up(Add&& add, Join&& join) const;
    /// Visits nodes from the root downwards: the children of a node if divide(node) is true; visit(i) is called for
    /// each triangle of the leaves that are reached.
    template <typename Divide, typename Visit>
    void for_each_divided(Divide&& divide, Visit&& visit) const;

  protected:
    /// Nodes on the stack while the tree is descended: one for each level, of which there are at most 30 for the bits
    /// of the Morton codes, and 32 for the halvings of triangles with the same code.
    static constexpr std::size_t kDeepest = 64;

    struct Bounds {
        std::array<float, 3> low;
        std::array<float, 3> high;

        bool meets(const Bounds& o) const {
            // Without branches, as half of the tested boxes meet and branch prediction would fail often.
            return bool(int(low[0] <= o.high[0]) & int(o.low[0] <= high[0]) & int(low[1] <= o.high[1]) &
                        int(o.low[1] <= high[1]) & int(low[2] <= o.high[2]) & int(o.low[2] <= high[2]));
        }
        void add(const Bounds& o);
        float size() const { return (high[0] - low[0]) + (high[1] - low[1]) + (high[2] - low[2]); }
    };
    /// A triangle in the order of the leaves.
    struct Item {
        Bounds bounds;
        std::int32_t triangle;
        std::uint32_t code;  ///< Morton code of the middle of its box
    };
    /// A leaf has `count` items from `first` on; an inner node (count 0) has the children `first` and `first` + 1,
    /// which come later than itself.
    struct Node {
        Bounds bounds;
        std::int32_t first;
        std::int32_t count;
    };
    static Bounds outward(const Box& box);

    const std::vector<Vec3>* vertices_;
    const std::vector<Triangle>* triangles_;
    LargeVector<Item> items_;
    LargeVector<Node> nodes_;

  private:
    class Ray;
    class NearGroups;

    Bounds bounds_of(std::int32_t triangle) const;
    void build(LargeVector<MortonKey> triangles);
    void sort(LargeVector<MortonKey>& triangles) const;
    void build_node(std::int32_t node, std::size_t begin, std::size_t end);
    std::size_t split(std::size_t begin, std::size_t end);

    /// The number of triangles under a node.
    std::size_t size_of(std::int32_t node) const;
    /// Appends the subtasks of a task, itself where it has none.
    void divide(Task task, std::vector<Task>& next) const;
    /// Whether the first of two nodes whose boxes meet is divided, rather than the second one.
    static bool divide_first(const Node& a, const Node& b) {
        return b.count > 0 || (a.count == 0 && a.bounds.size() >= b.bounds.size());
    }
    /// Runs one task of a traversal: reports the pairs of two leaves, or puts the subtasks on the stack. False when a
    /// visit ended the search.
    template <typename Visit>
    bool step(const AabbTree& other, Task task, std::vector<Task>& stack, Visit& visit) const;
    template <typename Visit>
    bool own_step(Task task, std::vector<Task>& stack, Visit& visit) const;
    bool in_one_group(Task task) const {
        return !node_group_.empty() && node_group_[task.a] >= 0 && node_group_[task.a] == node_group_[task.b];
    }
    template <typename Visit, typename... Triangles>
    static bool go_on(Visit& visit, Triangles... triangles) {
        if constexpr (std::is_same_v<decltype(visit(triangles...)), bool>) {
            return visit(triangles...);
        } else {
            visit(triangles...);
            return true;
        }
    }
    template <typename Meets, typename Visit>
    void descend(const Meets& meets, Visit& visit) const;

    double slack_ = 0.0;
    /// The common group of all triangles of a node, else -1; empty without groups.
    LargeVector<std::int32_t> node_group_;
};

/// Tests a ray against boxes: the slabs of Kay and Kajiya, with divisions rounded so that no box is missed.
class AabbTree::Ray {
  public:
    Ray(const Vec3& origin, const Vec3& direction, double reach)
        : origin_(origin), direction_(direction), reach_(reach) {}

    bool operator()(const Bounds& bounds) const {
        double enter = 0.0;
        double leave = reach_;
        for (int i = 0; i < 3; ++i) {
            const double to_low = double(bounds.low[i]) - origin_[i];
            const double to_high = double(bounds.high[i]) - origin_[i];
            if (direction_[i] == 0.0) {
                if (to_low > 0.0 || to_high < 0.0) {
                    return false;
                }
                continue;
            }
            const double first = (direction_[i] > 0.0 ? to_low : to_high) / direction_[i];
            const double last = (direction_[i] > 0.0 ? to_high : to_low) / direction_[i];
            enter = first > enter ? first : enter;
            leave = last < leave ? last : leave;
        }
        // A difference and a quotient, each with an error of half a unit in the last place; their signs are right.
        constexpr double kSlack = 4.0 * std::numeric_limits<double>::epsilon();
        return leave >= 0.0 && enter * (1.0 - kSlack) <= leave * (1.0 + kSlack);
    }

  private:
    Vec3 origin_;
    Vec3 direction_;
    double reach_;
};

template <typename Visit>
bool AabbTree::step(const AabbTree& other, Task task, std::vector<Task>& stack, Visit& visit) const {
    const Node& a = nodes_[task.a];
    const Node& b = other.nodes_[task.b];
    if (!a.bounds.meets(b.bounds)) {
        return true;
    }
    if (a.count > 0 && b.count > 0) {
        const Item* a_end = items_.data() + a.first + a.count;
        const Item* b_end = other.items_.data() + b.first + b.count;
        for (const Item* i = &items_[a.first]; i != a_end; ++i) {
            for (const Item* j = &other.items_[b.first]; j != b_end; ++j) {
                if (i->bounds.meets(j->bounds) && !go_on(visit, i->triangle, j->triangle)) {
                    return false;
                }
            }
        }
    } else if (divide_first(a, b)) {
        stack.push_back({a.first + 1, task.b});
        stack.push_back({a.first, task.b});
    } else {
        stack.push_back({task.a, b.first + 1});
        stack.push_back({task.a, b.first});
    }
    return true;
}

template <typename Visit>
bool AabbTree::own_step(Task task, std::vector<Task>& stack, Visit& visit) const {
    if (in_one_group(task)) {
        return true;
    }
    if (task.a != task.b) {
        return step(*this, task, stack, visit);
    }
    const Node& node = nodes_[task.a];
    if (node.count == 0) {
        stack.push_back({node.first, node.first + 1});
        stack.push_back({node.first + 1, node.first + 1});
        stack.push_back({node.first, node.first});
        return true;
    }
    const Item* end = items_.data() + node.first + node.count;
    for (const Item* i = &items_[node.first]; i != end; ++i) {
        for (const Item* j = i + 1; j != end; ++j) {
            if (i->bounds.meets(j->bounds) && !go_on(visit, i->triangle, j->triangle)) {
                return false;
            }
        }
    }
    return true;
}

template <typename Visit>
void AabbTree::for_each_pair(const AabbTree& other, Visit&& visit) const {
    std::vector<Task> stack;
    if (size() > 0 && other.size() > 0) {
        stack.push_back({0, 0});
    }
    while (!stack.empty()) {
        const Task top = stack.back();
        stack.pop_back();
        if (!step(other, top, stack, visit)) {
            return;
        }
    }
}

template <typename Visit>
void AabbTree::for_each_own_pair(Task task, Visit&& visit) const {
    std::vector<Task> stack{task};
    while (!stack.empty()) {
        const Task top = stack.back();
        stack.pop_back();
        if (!own_step(top, stack, visit)) {
            return;
        }
    }
}

template <typename Meets, typename Visit>
void AabbTree::descend(const Meets& meets, Visit& visit) const {
    std::array<std::int32_t, kDeepest> stack;
    std::size_t height = 0;
    if (!nodes_.empty()) {
        stack[height++] = 0;
    }
    while (height > 0) {
        const Node& node = nodes_[stack[--height]];
        if (!meets(node.bounds)) {
            continue;
        }
        if (node.count == 0) {
            stack[height++] = node.first + 1;
            stack[height++] = node.first;
            continue;
        }
        for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
            if (meets(items_[i].bounds) && !go_on(visit, items_[i].triangle)) {
                return;
            }
        }
    }
}

template <typename Visit>
void AabbTree::for_each_in_box(const Box& box, Visit&& visit) const {
    const Bounds bounds = outward(box);
    descend([&bounds](const Bounds& other) { return bounds.meets(other); }, visit);
}

template <typename Visit>
void AabbTree::for_each_on_ray(const Vec3& origin, const Vec3& direction, double reach, Visit&& visit) const {
    descend(Ray(origin, direction, reach), visit);
}

template <typename Add, typename Join>
void AabbTree::sum_up(Add&& add, Join&& join) const {
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        const Node& node = nodes_[n];
        const auto index = static_cast<std::int32_t>(n);
        if (node.count == 0) {
            join(index, node.first);
            join(index, node.first + 1);
        }
        for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
            add(index, items_[i].triangle);
        }
    }
}

template <typename Divide, typename Visit>
void AabbTree::for_each_divided(Divide&& divide, Visit&& visit) const {
    std::array<std::int32_t, kDeepest> stack;
    std::size_t height = 0;
    if (!nodes_.empty()) {
        stack[height++] = 0;
    }
    while (height > 0) {
        const std::int32_t n = stack[--height];
        if (!divide(n)) {
            continue;
        }
        const Node& node = nodes_[n];
        if (node.count == 0) {
            stack[height++] = node.first + 1;
            stack[height++] = node.first;
        }
        for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
            visit(items_[i].triangle);
        }
    }
}

}  // namespace mq::mesh
