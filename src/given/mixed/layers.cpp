// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/layers.h"

#include <algorithm>
#include <utility>

#include "given/mixed/transfinite_blending.h"

namespace mq::given {

using elements::ElementKind;

namespace {

/// Largest fraction of its height by which a row may be compressed or stretched.
constexpr double kMostStrain = 1.0 / 3.0;

/// The fraction of the displacement that is kept at the end of a row that is not on the CAD.
double kept(double height, const std::vector<Vec3>& displacement) {
    double most = 0.0;
    for (const Vec3& d : displacement) {
        most = std::max(most, d.norm());
    }
    return most > 0.0 ? std::max(0.0, 1.0 - kMostStrain * height / most) : 0.0;
}

}  // namespace

void Layers::add(const SideRow& row, const std::vector<std::vector<std::int32_t>>& nodes,
                 const std::vector<std::vector<double>>& fractions, const std::vector<Vec3>& first,
                 const std::vector<Vec3>& last) {
    if (!(row.height > 0.0)) {
        return;
    }
    const double weight = 1.0 / (row.height * row.height);
    const double share = row.ends_on_cad ? 0.0 : kept(row.height, first);
    const std::size_t end = row.sides.size() - (row.ends_on_cad ? 1 : 0);
    for (std::size_t k = 1; k < end; ++k) {
        for (std::size_t i = 0; i < first.size(); ++i) {
            const double s = fractions[k][i];
            const Vec3 far = row.ends_on_cad ? last[i] : Vec3(share * first[i]);
            Sum& sum = sums_[nodes[k][i]];
            sum.displacement += weight * ((1.0 - s) * first[i] + s * far);
            sum.weight += weight;
        }
    }
}

void Layers::add_edges(const SideRow& row) {
    const int order = table_.order();
    std::vector<std::vector<std::int32_t>> nodes;
    std::vector<std::vector<double>> fractions;
    for (std::size_t k = 0; k < row.sides.size(); ++k) {
        const std::vector<std::int32_t> edge = table_.edge(row.sides[k][0], row.sides[k][1]);
        nodes.emplace_back(edge.begin() + 1, edge.end() - 1);
        fractions.emplace_back();
        for (int i = 1; i < order; ++i) {
            const double t = static_cast<double>(i) / order;
            fractions.back().push_back((1.0 - t) * row.fractions[k][0] + t * row.fractions[k][1]);
        }
    }
    std::vector<Vec3> first;
    std::vector<Vec3> last;
    for (std::size_t i = 0; i < nodes.front().size(); ++i) {
        first.push_back(displacement_[static_cast<std::size_t>(nodes.front()[i])]);
        last.push_back(displacement_[static_cast<std::size_t>(nodes.back()[i])]);
    }
    add(row, nodes, fractions, first, last);
}

void Layers::add_faces(const SideRow& row) {
    const ElementKind kind = row.sides.front().size() == 3 ? ElementKind::Triangle : ElementKind::Quadrilateral;
    const Blending& blending = Blending::of(kind, table_.order());
    const Eigen::MatrixXd& weights = corner_weights(kind, table_.order());
    const auto deviation = [&](const std::vector<std::int32_t>& of_side) {
        std::vector<Vec3> own;
        for (const std::int32_t node : of_side) {
            own.push_back(displacement_[static_cast<std::size_t>(node)]);
        }
        std::vector<Vec3> blended = own;
        blending.apply(blended);
        std::vector<Vec3> result;
        for (const int i : blending.inner) {
            result.push_back(own[static_cast<std::size_t>(i)] - blended[static_cast<std::size_t>(i)]);
        }
        return result;
    };
    std::vector<std::vector<std::int32_t>> nodes;
    std::vector<std::vector<double>> fractions;
    std::vector<Vec3> first;
    std::vector<Vec3> last;
    for (std::size_t k = 0; k < row.sides.size(); ++k) {
        const std::vector<std::int32_t> all = table_.nodes_of(kind, row.sides[k].data());
        nodes.emplace_back();
        fractions.emplace_back();
        for (const int i : blending.inner) {
            nodes.back().push_back(all[static_cast<std::size_t>(i)]);
            double s = 0.0;
            for (std::size_t c = 0; c < row.sides[k].size(); ++c) {
                s += weights(i, static_cast<Eigen::Index>(c)) * row.fractions[k][c];
            }
            fractions.back().push_back(s);
        }
        if (k == 0 || k + 1 == row.sides.size()) {
            (k == 0 ? first : last) = deviation(all);
        }
    }
    add(row, nodes, fractions, first, last);
}

std::vector<std::pair<std::int32_t, Vec3>> Layers::result() const {
    std::vector<std::pair<std::int32_t, Vec3>> all;
    for (const auto& [node, sum] : sums_) {
        all.emplace_back(node, sum.displacement / sum.weight);
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return all;
}

}  // namespace mq::given
