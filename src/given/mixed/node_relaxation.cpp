// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/node_relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "base/disjoint_sets.h"
#include "given/mixed/sampled_jacobian.h"

namespace mq::given {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The work ends when the least sample, relative to the straight element, reaches this value.
constexpr double kTarget = 0.15;
constexpr int kBarrierMoves = 8;
constexpr int kDescentSteps = 25;
constexpr int kHalvings = 12;

std::size_t at(std::int64_t i) {
    return static_cast<std::size_t>(i);
}

/// Elements that change together, and those of their nodes that may move.
class Patch {
  public:
    Patch(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& straight,
          std::vector<std::size_t> members, std::vector<std::int32_t> free, std::vector<Vec3>& nodes)
        : elements_(elements), order_(order), free_(std::move(free)), nodes_(nodes) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            place_.emplace(free_[i], i);
        }
        for (const std::size_t e : members) {
            add(e, straight);
        }
    }

    double barrier = 0.0;

    Eigen::VectorXd state() const {
        Eigen::VectorXd x(static_cast<Eigen::Index>(3 * free_.size()));
        for (std::size_t i = 0; i < free_.size(); ++i) {
            x.segment<3>(static_cast<Eigen::Index>(3 * i)) = nodes_[at(free_[i])];
        }
        return x;
    }
    void set(const Eigen::VectorXd& x) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            nodes_[at(free_[i])] = x.segment<3>(static_cast<Eigen::Index>(3 * i));
        }
    }
    double size() const { return size_; }

    double least() {
        double result = 1.0;
        for (std::size_t m = 0; m < members_.size(); ++m) {
            evaluate(m);
            for (std::size_t q = 0; q < jacobians_.size(); ++q) {
                result = std::min(result, jacobians_[q] / members_[m].scale[q]);
            }
        }
        return result;
    }

    double operator()(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        set(x);
        gradient.setZero(x.size());
        double sum = 0.0;
        for (std::size_t m = 0; m < members_.size(); ++m) {
            const SampledJacobian& sampled = evaluate(m);
            weights_.resize(jacobians_.size());
            const double share = 1.0 / static_cast<double>(jacobians_.size());
            for (std::size_t q = 0; q < jacobians_.size(); ++q) {
                const double scale = members_[m].scale[q];
                const double r = jacobians_[q] / scale;
                if (!(r > barrier)) {
                    return kInfinity;
                }
                const double log = std::log((r - barrier) / (1.0 - barrier));
                sum += share * (log * log + (r - 1.0) * (r - 1.0));
                weights_[q] = share * (2.0 * log / (r - barrier) + 2.0 * (r - 1.0)) / scale;
            }
            by_nodes_.assign(own_.size(), Vec3::Zero());
            sampled.differentiate(own_, weights_, by_nodes_);
            const std::vector<std::int32_t>& numbers = elements_[members_[m].element].nodes;
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                const auto found = place_.find(numbers[i]);
                if (found != place_.end()) {
                    gradient.segment<3>(static_cast<Eigen::Index>(3 * found->second)) += by_nodes_[i];
                }
            }
        }
        return sum;
    }

  private:
    struct Member {
        std::size_t element;
        std::vector<double> scale;  ///< by sample: J of the straight element
    };

    const SampledJacobian& evaluate(std::size_t m) {
        const ElementNodes& element = elements_[members_[m].element];
        own_.clear();
        for (const std::int32_t n : element.nodes) {
            own_.push_back(nodes_[at(n)]);
        }
        const SampledJacobian& sampled = SampledJacobian::of(element.kind, order_);
        sampled.evaluate(own_, jacobians_);
        return sampled;
    }

    /// Straight elements that are folded cannot be repaired by nodes that are no corners: they are left out.
    void add(std::size_t e, const std::vector<Vec3>& straight) {
        own_.clear();
        for (const std::int32_t n : elements_[e].nodes) {
            own_.push_back(straight[at(n)]);
        }
        SampledJacobian::of(elements_[e].kind, order_).evaluate(own_, jacobians_);
        double mean = 0.0;
        for (const double j : jacobians_) {
            mean += j / static_cast<double>(jacobians_.size());
        }
        if (!(*std::min_element(jacobians_.begin(), jacobians_.end()) > 0.0)) {
            return;
        }
        Member member{e, jacobians_};
        for (double& scale : member.scale) {
            scale = std::max(scale, 0.05 * mean);
        }
        members_.push_back(std::move(member));
        size_ = std::max(size_, std::cbrt(mean));
    }

    const std::vector<ElementNodes>& elements_;
    int order_;
    std::vector<std::int32_t> free_;
    std::vector<Vec3>& nodes_;
    std::unordered_map<std::int32_t, std::size_t> place_;
    std::vector<Member> members_;
    double size_ = 0.0;
    std::vector<Vec3> own_;
    std::vector<double> jacobians_;
    std::vector<double> weights_;
    std::vector<Vec3> by_nodes_;
};

/// Conjugate gradients with backtracking. @return whether x moved.
bool minimise(Patch& patch, Eigen::VectorXd& x, const Progress& progress) {
    Eigen::VectorXd gradient;
    double value = patch(x, gradient);
    Eigen::VectorXd direction = -gradient;
    double length = gradient.size() > 0 ? 0.02 * patch.size() / std::max(gradient.cwiseAbs().maxCoeff(), 1e-300) : 0.0;
    bool moved = false;
    for (int step = 0; step < kDescentSteps; ++step) {
        progress.check();
        const double slope = direction.dot(gradient);
        Eigen::VectorXd next;
        Eigen::VectorXd next_gradient;
        double next_value = kInfinity;
        int halvings = 0;
        for (; halvings < kHalvings; ++halvings, length *= 0.4) {
            next = x + length * direction;
            next_value = patch(next, next_gradient);
            if (next_value <= value + 1e-4 * length * slope) {
                break;
            }
        }
        if (halvings == kHalvings) {
            break;
        }
        const double gain = value - next_value;
        const double ratio =
            std::max(0.0, next_gradient.dot(next_gradient - gradient) / std::max(gradient.squaredNorm(), 1e-300));
        x = next;
        direction = -next_gradient + ratio * direction;
        if (!(direction.dot(next_gradient) < 0.0)) {
            direction = -next_gradient;
        }
        gradient = next_gradient;
        value = next_value;
        moved = true;
        length *= halvings == 0 ? 2.0 : 1.0;
        if (gain < 1e-5 * std::abs(value)) {
            break;
        }
    }
    patch.set(x);
    return moved;
}

void untangle(Patch& patch, const Progress& progress) {
    Eigen::VectorXd x = patch.state();
    double least = patch.least();
    int stalled = 0;
    for (int move = 0; move < kBarrierMoves && least < kTarget && stalled < 2; ++move) {
        patch.barrier = least - 0.1 * std::max(std::abs(least), 0.1);
        if (!minimise(patch, x, progress)) {
            break;
        }
        const double now = patch.least();
        stalled = now > least + 1e-3 + 0.01 * std::abs(least) ? 0 : stalled + 1;
        least = now;
    }
}

/// By node: the elements that have it.
std::vector<std::vector<std::size_t>> elements_of_nodes(const std::vector<ElementNodes>& elements, std::size_t count) {
    std::vector<std::vector<std::size_t>> result(count);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        for (const std::int32_t n : elements[e].nodes) {
            result[at(n)].push_back(e);
        }
    }
    return result;
}

/// By element whether it is bad, or within some layers around bad ones.
std::vector<char> around(const std::vector<ElementNodes>& elements, const std::vector<std::vector<std::size_t>>& beside,
                         const std::vector<std::size_t>& bad, int layers) {
    std::vector<char> within(elements.size(), 0);
    std::vector<std::size_t> chosen = bad;
    for (const std::size_t e : bad) {
        within[e] = 1;
    }
    std::size_t from = 0;
    for (int layer = 0; layer < layers; ++layer) {
        const std::size_t end = chosen.size();
        for (; from < end; ++from) {
            for (const std::int32_t n : elements[chosen[from]].nodes) {
                for (const std::size_t other : beside[at(n)]) {
                    if (!within[other]) {
                        within[other] = 1;
                        chosen.push_back(other);
                    }
                }
            }
        }
    }
    return within;
}

}  // namespace

std::size_t relax_nodes(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& straight,
                        const std::vector<char>& fixed, const std::vector<std::size_t>& bad, int layers,
                        std::vector<Vec3>& nodes, const Progress& progress) {
    const auto beside = elements_of_nodes(elements, nodes.size());
    const std::vector<char> within = around(elements, beside, bad, layers);
    // A node is free if all of its elements are in the patch; elements that share a free node change together.
    DisjointSets<std::size_t> joined(elements.size());
    std::vector<std::int32_t> free;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const bool all = !beside[n].empty() && !fixed[n] &&
                         std::all_of(beside[n].begin(), beside[n].end(), [&](std::size_t e) { return within[e] != 0; });
        if (all) {
            free.push_back(static_cast<std::int32_t>(n));
            for (const std::size_t e : beside[n]) {
                joined.unite(beside[n].front(), e);
            }
        }
    }
    std::unordered_map<std::size_t, std::pair<std::vector<std::size_t>, std::vector<std::int32_t>>> patches;
    std::vector<std::size_t> roots;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        if (!within[e]) {
            continue;
        }
        auto& patch = patches[joined.find(e)];
        if (patch.first.empty()) {
            roots.push_back(joined.find(e));
        }
        patch.first.push_back(e);
    }
    for (const std::int32_t n : free) {
        patches[joined.find(beside[at(n)].front())].second.push_back(n);
    }
    std::size_t worked_on = 0;
    for (const std::size_t root : roots) {
        auto& [members, own] = patches[root];
        if (own.empty()) {
            continue;
        }
        Patch patch(elements, order, straight, members, own, nodes);
        untangle(patch, progress);
        ++worked_on;
    }
    return worked_on;
}

}  // namespace mq::given
