// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/node_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "base/memory/never_destroyed.h"
#include "elements/product/reference_nodes.h"

namespace mq::given {

using elements::ElementKind;

namespace {

/// Adds the bilinear weights of a quadrilateral's corners at (u, v) of the unit square, times `share`.
void put_square(Eigen::MatrixXd& weights, Eigen::Index row, Eigen::Index first, double u, double v, double share) {
    weights(row, first) = share * (1.0 - u) * (1.0 - v);
    weights(row, first + 1) = share * u * (1.0 - v);
    weights(row, first + 2) = share * u * v;
    weights(row, first + 3) = share * (1.0 - u) * v;
}

void put_triangle(Eigen::MatrixXd& weights, Eigen::Index row, Eigen::Index first, double u, double v, double share) {
    weights(row, first) = share * (1.0 - u - v);
    weights(row, first + 1) = share * u;
    weights(row, first + 2) = share * v;
}

Eigen::MatrixXd weights_of(ElementKind kind, int order) {
    const std::vector<elements::GridPoint> points = elements::gmsh_nodes(kind, order);
    Eigen::MatrixXd weights =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), elements::full_node_count(kind, 1));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double x = static_cast<double>(points[i][0]) / order;
        const double y = static_cast<double>(points[i][1]) / order;
        const double z = static_cast<double>(points[i][2]) / order;
        const double side = 1.0 - z;
        switch (kind) {
            case ElementKind::Triangle:
                put_triangle(weights, row, 0, x, y, 1.0);
                break;
            case ElementKind::Quadrilateral:
                put_square(weights, row, 0, x, y, 1.0);
                break;
            case ElementKind::Tetrahedron:
                put_triangle(weights, row, 0, x, y, 1.0);
                weights(row, 0) -= z;
                weights(row, 3) = z;
                break;
            case ElementKind::Pyramid:
                put_square(weights, row, 0, side > 0.0 ? 0.5 * (x / side + 1.0) : 0.0,
                           side > 0.0 ? 0.5 * (y / side + 1.0) : 0.0, side);
                weights(row, 4) = z;
                break;
            case ElementKind::Prism:
                put_triangle(weights, row, 0, x, y, side);
                put_triangle(weights, row, 3, x, y, z);
                break;
            case ElementKind::Hexahedron:
                put_square(weights, row, 0, x, y, side);
                put_square(weights, row, 4, x, y, z);
                break;
        }
    }
    return weights;
}

}  // namespace

const Eigen::MatrixXd& corner_weights(ElementKind kind, int order) {
    static std::mutex mutex;
    static auto& known = never_destroyed<std::map<std::pair<ElementKind, int>, Eigen::MatrixXd>>({});
    const std::lock_guard<std::mutex> lock(mutex);
    const auto [at, fresh] = known.try_emplace({kind, order});
    if (fresh) {
        at->second = weights_of(kind, order);
    }
    return at->second;
}

NodeTable::NodeTable(int order, std::vector<Vec3> corners)
    : order_(order), vertices_(corners.size()), straight_(std::move(corners)) {}

std::int32_t NodeTable::node(const std::vector<std::array<std::int32_t, 2>>& weights, bool shared) {
    if (weights.size() == 1) {
        return weights[0][0];
    }
    const auto fresh = static_cast<std::int32_t>(straight_.size());
    if (shared) {
        Key key;
        key.fill(-1);
        for (std::size_t k = 0; k < weights.size(); ++k) {
            key[2 * k] = weights[k][0];
            key[2 * k + 1] = weights[k][1];
        }
        const auto [at, is_new] = known_.emplace(key, fresh);
        if (!is_new) {
            return at->second;
        }
    }
    straight_.emplace_back(Vec3::Zero());
    return fresh;
}

std::vector<std::int32_t> NodeTable::nodes_of(ElementKind kind, const std::int32_t* corners) {
    const Eigen::MatrixXd& weights = corner_weights(kind, order_);
    const double whole = std::pow(order_, 3);  // weights of nodes on faces are whole multiples of 1 / whole
    std::vector<std::int32_t> nodes;
    for (Eigen::Index i = 0; i < weights.rows(); ++i) {
        std::vector<std::array<std::int32_t, 2>> carriers;
        Vec3 place = Vec3::Zero();
        for (Eigen::Index k = 0; k < weights.cols(); ++k) {
            if (weights(i, k) > 1e-9) {
                carriers.push_back({corners[k], static_cast<std::int32_t>(std::lround(weights(i, k) * whole))});
                place += weights(i, k) * straight_[static_cast<std::size_t>(corners[k])];
            }
        }
        std::sort(carriers.begin(), carriers.end());
        const bool inside =
            elements::dimension_of(kind) == 3 && static_cast<Eigen::Index>(carriers.size()) == weights.cols();
        const std::size_t before = straight_.size();
        nodes.push_back(node(carriers, !inside));
        if (straight_.size() > before) {
            straight_.back() = place;
        }
    }
    return nodes;
}

std::vector<std::int32_t> NodeTable::edge(std::int32_t a, std::int32_t b) {
    const auto whole = static_cast<std::int32_t>(std::lround(std::pow(order_, 2)));
    std::vector<std::int32_t> nodes{a};
    for (int i = 1; i < order_; ++i) {
        std::vector<std::array<std::int32_t, 2>> carriers{{a, (order_ - i) * whole}, {b, i * whole}};
        std::sort(carriers.begin(), carriers.end());
        const std::size_t before = straight_.size();
        nodes.push_back(node(carriers, true));
        if (straight_.size() > before) {
            const double t = static_cast<double>(i) / order_;
            straight_.back() =
                (1.0 - t) * straight_[static_cast<std::size_t>(a)] + t * straight_[static_cast<std::size_t>(b)];
        }
    }
    nodes.push_back(b);
    return nodes;
}

}  // namespace mq::given
