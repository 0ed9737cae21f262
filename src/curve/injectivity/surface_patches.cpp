// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/surface_patches.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/bernstein.h"
#include "elements/product/reference_nodes.h"
#include "elements/product/tensor_patch.h"
#include "mesh/weld_vertices.h"

namespace mq::curve {

using elements::ElementKind;
using elements::Lattice;
using elements::raised_to;

namespace {

/// Bound of the error of control points and their differences, relative to the largest coordinate. The conversion from
/// nodes has weights whose sum of sizes is less than 100 for triangles of order 5, and less than 1000 for
/// quadrilaterals.
constexpr double kOfTriangles = 1024.0 * std::numeric_limits<double>::epsilon();
constexpr double kOfQuadrilaterals = 16.0 * kOfTriangles;

int degree_of(const SideBlock& block) {
    return block.kind == ElementKind::Quadrilateral ? 2 * block.order : block.order;
}

void require_sound(const std::vector<Vec3>& nodes, const SideBlock& block) {
    const bool surface = elements::dimension_of(block.kind) == 2;
    const bool known = surface && block.order >= 1 && block.order <= elements::kMaxOrder &&
                       (block.nodes_per_side == elements::full_node_count(block.kind, block.order) ||
                        block.nodes_per_side == elements::serendipity_node_count(block.kind, block.order));
    if (!known || block.nodes.size() % static_cast<std::size_t>(block.nodes_per_side) != 0) {
        throw InvalidInput(phrases::kNoSides,
                           {{"count", block.nodes_per_side}, {"count2", block.order}, {"count3", elements::kMaxOrder}});
    }
    for (const std::int32_t node : block.nodes) {
        if (node < 0 || node >= static_cast<std::int32_t>(nodes.size()) ||
            !nodes[static_cast<std::size_t>(node)].allFinite()) {
            throw InvalidInput(phrases::kNodeMissing, {{"count", node}});
        }
    }
}

}  // namespace

SurfacePatches::SurfacePatches(const std::vector<Vec3>& nodes, const std::vector<SideBlock>& blocks) {
    int degree = 1;
    bool all_triangles = true;
    Box all;
    std::vector<char> used(nodes.size(), 0);
    for (const SideBlock& block : blocks) {
        require_sound(nodes, block);
        degree = std::max(degree, degree_of(block));
        all_triangles = all_triangles && block.kind == ElementKind::Triangle;
        for (const std::int32_t node : block.nodes) {
            all.add(nodes[static_cast<std::size_t>(node)]);
            used[static_cast<std::size_t>(node)] = 1;
        }
    }
    lattice_ = &Lattice::of(2, degree);
    const double size = all.empty() ? 0.0 : all.largest_side();
    middle_ = all.empty() ? Vec3::Zero() : all.center();
    limits_.least_size = kLeastPiece * size;
    limits_.touching = kTouching * size;
    limits_.rounding =
        (all_triangles ? kOfTriangles : kOfQuadrilaterals) * (0.5 * size + middle_.cwiseAbs().maxCoeff());
    const std::vector<std::int32_t> same = mesh::equal_vertices(nodes, used);
    for (const SideBlock& block : blocks) {
        const auto per = static_cast<std::size_t>(block.nodes_per_side);
        for (std::size_t first = 0; first < block.nodes.size(); first += per) {
            std::vector<std::int32_t> row(per);
            std::vector<Vec3> places(per);
            for (std::size_t i = 0; i < per; ++i) {
                row[i] = same[static_cast<std::size_t>(block.nodes[first + i])];
                places[i] = nodes[static_cast<std::size_t>(row[i])] - middle_;
            }
            add(block, row, std::move(places));
        }
    }
    find_bodies(blocks);
}

void SurfacePatches::add(const SideBlock& block, const std::vector<std::int32_t>& row, std::vector<Vec3> nodes) {
    const auto side = static_cast<std::int32_t>(side_nodes_.size());
    const Lattice& own = Lattice::of(2, degree_of(block));
    if (block.kind == ElementKind::Triangle) {
        patches_.push_back(
            {raised_to(lattice_->degree(), own, elements::gmsh_to_bezier(own, nodes)), {row[0], row[1], row[2]}, side});
    } else {
        auto [lower, upper] =
            elements::halves_of_quadrilateral(block.order, elements::tensor_control(block.order, std::move(nodes)));
        patches_.push_back({raised_to(lattice_->degree(), own, lower), {row[0], row[1], row[2]}, side});
        patches_.push_back({raised_to(lattice_->degree(), own, upper), {row[0], row[2], row[3]}, side});
    }
    side_nodes_.push_back(row);
    std::sort(side_nodes_.back().begin(), side_nodes_.back().end());
}

/// Sides belong to one body if edges of exactly two sides connect them. If bodies lie on each other, their common edges
/// have four sides.
void SurfacePatches::find_bodies(const std::vector<SideBlock>& blocks) {
    std::vector<std::array<std::int32_t, 3>> edges;  // the two corners of an edge, and the side that has it
    std::size_t t = 0;
    for (const SideBlock& block : blocks) {
        const bool halved = block.kind == ElementKind::Quadrilateral;
        for (std::size_t i = 0; i < block.nodes.size(); i += static_cast<std::size_t>(block.nodes_per_side)) {
            const Patch& patch = patches_[t];
            std::vector<std::int32_t> ring(patch.corners.begin(), patch.corners.end());
            if (halved) {
                ring.push_back(patches_[t + 1].corners[2]);
            }
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const auto [low, high] = std::minmax(ring[k], ring[(k + 1) % ring.size()]);
                edges.push_back({low, high, patch.side});
            }
            t += halved ? 2 : 1;
        }
    }
    std::sort(edges.begin(), edges.end());
    const auto same = [&](std::size_t i, std::size_t j) {
        return j < edges.size() && edges[i][0] == edges[j][0] && edges[i][1] == edges[j][1];
    };
    DisjointSets<std::int32_t> sets(sides());
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (same(i, end)) {
            ++end;
        }
        if (end == i + 2) {
            sets.unite(edges[i][2], edges[i + 1][2]);
        }
        i = end;
    }
    for (std::int32_t side = 0; side < static_cast<std::int32_t>(sides()); ++side) {
        body_.push_back(sets.find(side));
    }
}

bool SurfacePatches::lie_on_each_other(std::int32_t a, std::int32_t b) const {
    return side(a) != side(b) &&
           side_nodes_[static_cast<std::size_t>(side(a))] == side_nodes_[static_cast<std::size_t>(side(b))];
}

PatchVerdict SurfacePatches::contact(std::int32_t a, std::int32_t b, int most_pairs) const {
    PatchLimits limits = limits_;
    limits.most_pairs = most_pairs;
    return a == b ? contact_with_itself(*lattice_, control(a), limits)
                  : contact_of_patches(*lattice_, control(a), control(b), shared(a, b), limits);
}

SharedEntities SurfacePatches::shared(std::int32_t a, std::int32_t b) const {
    SharedEntities found;
    const Patch& first = patch(a);
    const Patch& second = patch(b);
    found.may_touch = body_[static_cast<std::size_t>(first.side)] != body_[static_cast<std::size_t>(second.side)];
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t m = 0; m < 3; ++m) {
            if (first.corners[k] == second.corners[m]) {
                found.corners.push_back({static_cast<int>(k), static_cast<int>(m)});
            }
        }
    }
    for (std::size_t i = 0; i < found.corners.size(); ++i) {
        for (std::size_t j = i + 1; j < found.corners.size(); ++j) {
            if (share_edge(first, second, found.corners[i], found.corners[j])) {
                found.edges.push_back({static_cast<int>(i), static_cast<int>(j)});
            }
        }
    }
    return found;
}

/// Whether the edges between two pairs of equal corners are the same curve up to rounding: their control points are
/// equal, whatever the orders of the sides are.
bool SurfacePatches::share_edge(const Patch& a, const Patch& b, const std::array<int, 2>& from,
                                const std::array<int, 2>& to) const {
    if (from[0] == to[0] || from[1] == to[1]) {
        return false;
    }
    for (int i = 1; i < lattice_->degree(); ++i) {
        const auto at = [&](const Patch& patch, std::size_t side) -> const Vec3& {
            elements::Exponents e{};
            e[static_cast<std::size_t>(from[side])] = lattice_->degree() - i;
            e[static_cast<std::size_t>(to[side])] = i;
            return patch.control[static_cast<std::size_t>(lattice_->index(e))];
        };
        if ((at(a, 0) - at(b, 1)).cwiseAbs().maxCoeff() > limits_.rounding) {
            return false;
        }
    }
    return true;
}

}  // namespace mq::curve
