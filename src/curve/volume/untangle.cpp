// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/untangle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "curve/bezier/blending.h"
#include "curve/volume/jacobian_batch.h"
#include "curve/volume/tuning.h"

namespace mq::curve {

namespace {

/// The objective where it is not defined.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// The objective of a patch: each element has a barrier of its own, so that elements that cannot become valid keep no
/// others back, and valid ones stay valid.
class Objective {
  public:
    Objective(UntanglingPatch& patch, const Progress& progress)
        : patch_(patch), progress_(progress), jacobian_(patch.lattice()) {
        weights_.resize(jacobian_.coefficients.size());
        find_movable();
    }

    /// The least coefficients of the elements that can be changed, 1 at most.
    const std::vector<Lanes>& least() const { return least_; }
    std::size_t elements() const { return elements_.size(); }
    /// The number of Jacobians evaluated.
    std::size_t evaluations() const { return evaluations_; }

    void find_least(const Eigen::VectorXd& x) {
        patch_.set_state(x);
        least_.assign(batches(), Lanes::Ones());
        for (std::size_t batch = 0; batch < batches(); ++batch) {
            evaluate(batch);
            for (std::size_t k = 0; k < weights_.size(); ++k) {
                least_[batch] = least_[batch].min(relative(batch, k));
            }
        }
    }

    /// Sets each barrier below the least coefficient, but at `highest` at most.
    void raise_barriers(double highest) {
        barrier_.resize(batches());
        for (std::size_t batch = 0; batch < batches(); ++batch) {
            const Lanes& least = least_[batch];
            barrier_[batch] = (least - 0.1 * least.abs().max(0.1)).min(highest);
        }
    }

    /// The objective, or infinity where it is not defined or exceeds `bound`.
    double value(const Eigen::VectorXd& x, double bound) {
        patch_.set_state(x);
        double sum = 0.0;
        for (std::size_t batch = 0; batch < batches() && sum <= bound; ++batch) {
            evaluate(batch);
            sum += value_of(batch);
        }
        return sum <= bound ? sum : kInfinity;
    }

    /// The same with the derivative, which is incomplete where the result is infinite.
    double value(const Eigen::VectorXd& x, double bound, Eigen::VectorXd& gradient) {
        patch_.set_state(x);
        gradient.setZero(x.size());
        double sum = 0.0;
        for (std::size_t batch = 0; batch < batches(); ++batch) {
            evaluate(batch);
            sum += value_of(batch);
            if (!(sum <= bound)) {
                return kInfinity;
            }
            jacobian_.differentiate_sum(weights_, by_lanes_);
            scatter(batch, gradient);
        }
        return sum;
    }

  private:
    std::size_t batches() const { return inverse_.size(); }
    std::size_t count(std::size_t batch) const {
        return std::min<std::size_t>(kLanes, elements_.size() - batch * kLanes);
    }

    /// Coefficient k relative to the J that the element is to have; 1 where nothing can change it.
    Lanes relative(std::size_t batch, std::size_t k) const {
        const unsigned char movable = movable_[batch][k];
        Lanes b = jacobian_.coefficients[k] * inverse_[batch];
        for (int lane = 0; lane < kLanes; ++lane) {
            b[lane] = (movable >> lane & 1) != 0 ? b[lane] : 1.0;
        }
        return b;
    }

    /// The sum over one batch; sets the weights of its derivative.
    double value_of(std::size_t batch) {
        const Lanes& barrier = barrier_[batch];
        Lanes sum = Lanes::Zero();
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            if (movable_[batch][k] == 0) {
                weights_[k].setZero();
                continue;
            }
            const Lanes b = relative(batch, k);
            const Lanes above = b - barrier;
            if (!(above > 0.0).all()) {
                return kInfinity;
            }
            const Lanes log = (above / (1.0 - barrier)).log();
            sum += log * log + (b - 1.0) * (b - 1.0);
            weights_[k] = (2.0 * log / above + 2.0 * (b - 1.0)) * inverse_[batch];
        }
        return sum[0] + sum[1] + sum[2] + sum[3];
    }

    /// @throws Cancelled
    void evaluate(std::size_t batch) {
        progress_.check();
        evaluations_ += count(batch);
        for (std::size_t lane = 0; lane < count(batch); ++lane) {
            patch_.gather(elements_[batch * kLanes + lane], control_);
            const auto l = static_cast<Eigen::Index>(lane);
            for (std::size_t p = 0; p < control_.size(); ++p) {
                jacobian_.control[p].x[l] = control_[p].x();
                jacobian_.control[p].y[l] = control_[p].y();
                jacobian_.control[p].z[l] = control_[p].z();
            }
        }
        jacobian_.evaluate();
    }

    void scatter(std::size_t batch, Eigen::VectorXd& gradient) {
        by_control_.resize(by_lanes_.size());
        for (std::size_t lane = 0; lane < count(batch); ++lane) {
            const auto l = static_cast<Eigen::Index>(lane);
            for (std::size_t p = 0; p < by_lanes_.size(); ++p) {
                by_control_[p] = {by_lanes_[p].x[l], by_lanes_[p].y[l], by_lanes_[p].z[l]};
            }
            spread_inner_gradient(patch_.lattice(), by_control_);
            patch_.scatter(elements_[batch * kLanes + lane], by_control_, gradient);
        }
    }

    /// A coefficient depends on the control points next to it; where all those are fixed nothing can change it.
    /// Elements without any that can be changed are left out.
    void find_movable() {
        const int points = patch_.lattice().size();
        std::vector<std::vector<std::size_t>> dependent(at(points));
        for (int p = 0; p < points; ++p) {
            dependent[at(p)] = dependent_on(p);
        }
        for (std::size_t i = 0; i < patch_.elements(); ++i) {
            progress_.check();
            std::vector<char> movable(weights_.size(), 0);
            bool any = false;
            for (int p = 0; p < points; ++p) {
                if (!patch_.is_free(i, p)) {
                    continue;
                }
                any = true;
                for (const std::size_t k : dependent[at(p)]) {
                    movable[k] = 1;
                }
            }
            if (any) {
                append(i, movable);
            }
        }
    }

    void append(std::size_t element, const std::vector<char>& movable) {
        const std::size_t lane = elements_.size() % kLanes;
        if (lane == 0) {
            inverse_.push_back(Lanes::Ones());
            movable_.emplace_back(weights_.size(), static_cast<unsigned char>(0));
        }
        elements_.push_back(element);
        inverse_.back()[static_cast<Eigen::Index>(lane)] = 1.0 / patch_.reference(element);
        for (std::size_t k = 0; k < movable.size(); ++k) {
            movable_.back()[k] = static_cast<unsigned char>(movable_.back()[k] | (movable[k] != 0 ? 1U << lane : 0U));
        }
    }

    std::vector<std::size_t> dependent_on(int point) const {
        const Lattice& form = Lattice::of(3, 3 * (patch_.lattice().degree() - 1));
        std::vector<std::size_t> result;
        for (int k = 0; k < form.size(); ++k) {
            if (depends(form.exponents(k), patch_.lattice().exponents(point))) {
                result.push_back(at(k));
            }
        }
        return result;
    }

    /// Some derivative that holds point `e` is a factor of coefficient `l`.
    static bool depends(const Exponents& l, const Exponents& e) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (e[k] == 0) {
                continue;
            }
            bool within = true;
            for (std::size_t i = 0; i < 4; ++i) {
                within = within && e[i] - (i == k ? 1 : 0) <= l[i];
            }
            if (within) {
                return true;
            }
        }
        return false;
    }

    UntanglingPatch& patch_;
    const Progress& progress_;
    JacobianBatch jacobian_;
    std::size_t evaluations_ = 0;
    std::vector<std::size_t> elements_;                // those of the patch that can change, four to a batch
    std::vector<Lanes> inverse_;                       // 1 / J that the element is to have
    std::vector<std::vector<unsigned char>> movable_;  // by batch and coefficient: a bit for each lane
    std::vector<Lanes> barrier_;
    std::vector<Lanes> least_;
    std::vector<Vec3> control_;
    std::vector<Vec3> by_control_;
    std::vector<LaneVector> by_lanes_;
    std::vector<Lanes> weights_;
};

/// Limited-memory BFGS with backtracking.
class Minimiser {
  public:
    explicit Minimiser(Objective& objective) : objective_(objective) {}

    /// @return whether x moved.
    bool run(Eigen::VectorXd& x, double scale) {
        Eigen::VectorXd gradient;
        double value = objective_.value(x, kInfinity, gradient);
        bool moved = false;
        pairs_.clear();
        for (int step = 0; step < VolumeTuning::kMinimisationSteps; ++step) {
            Eigen::VectorXd direction = -two_loops(gradient, scale);
            if (direction.dot(gradient) >= 0.0) {
                pairs_.clear();
                direction = -gradient;
            }
            Eigen::VectorXd next;
            Eigen::VectorXd next_gradient;
            double length = 1.0;
            double next_value = kInfinity;
            for (int i = 0; i < VolumeTuning::kLineHalvings && next_value == kInfinity; ++i, length *= 0.5) {
                next = x + length * direction;
                const double bound = value + 1e-4 * length * direction.dot(gradient);
                // Full steps are mostly taken; of shorter ones only the value is found before they are.
                next_value = i == 0 ? objective_.value(next, bound, next_gradient) : objective_.value(next, bound);
                if (i > 0 && next_value < kInfinity) {
                    next_value = objective_.value(next, bound, next_gradient);
                }
            }
            if (next_value == kInfinity) {
                return moved;
            }
            const double gain = value - next_value;
            remember(next - x, next_gradient - gradient);
            x = next;
            gradient = next_gradient;
            value = next_value;
            moved = true;
            if (gain < 1e-4 * std::abs(value)) {
                return true;
            }
        }
        return moved;
    }

  private:
    struct Pair {
        Eigen::VectorXd s;
        Eigen::VectorXd y;
        double rho;
    };

    Eigen::VectorXd two_loops(const Eigen::VectorXd& gradient, double scale) const {
        Eigen::VectorXd r = gradient;
        std::vector<double> alpha(pairs_.size());
        for (std::size_t i = pairs_.size(); i-- > 0;) {
            alpha[i] = pairs_[i].rho * pairs_[i].s.dot(r);
            r -= alpha[i] * pairs_[i].y;
        }
        if (pairs_.empty()) {
            const double largest = gradient.cwiseAbs().maxCoeff();
            r *= largest > 0.0 ? 0.02 * scale / largest : 1.0;
        } else {
            r *= 1.0 / (pairs_.back().rho * pairs_.back().y.squaredNorm());
        }
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            r += (alpha[i] - pairs_[i].rho * pairs_[i].y.dot(r)) * pairs_[i].s;
        }
        return r;
    }

    void remember(const Eigen::VectorXd& s, const Eigen::VectorXd& y) {
        const double product = s.dot(y);
        if (product > 1e-12 * s.norm() * y.norm()) {
            pairs_.push_back({s, y, 1.0 / product});
            if (pairs_.size() > at(VolumeTuning::kBfgsMemory)) {
                pairs_.pop_front();
            }
        }
    }

    Objective& objective_;
    std::deque<Pair> pairs_;
};

}  // namespace

namespace {

/// How far the elements are from the target; those that are turned inside out count alike.
double shortfall(const std::vector<Lanes>& least, double target) {
    double sum = 0.0;
    for (const Lanes& l : least) {
        sum += (target - l.max(-1.0)).max(0.0).sum();
    }
    return sum;
}

std::size_t below(const std::vector<Lanes>& least, double target) {
    std::size_t result = 0;
    for (const Lanes& l : least) {
        result += static_cast<std::size_t>((l < target).count());
    }
    return result;
}

}  // namespace

std::size_t untangle(UntanglingPatch& patch, double target, const Progress& progress) {
    Objective objective(patch, progress);
    if (objective.elements() == 0) {
        return 0;
    }
    Minimiser minimiser(objective);
    Eigen::VectorXd x = patch.state();
    double size = 0.0;
    for (std::size_t i = 0; i < patch.elements(); ++i) {
        size += std::cbrt(patch.reference(i));
    }
    size /= static_cast<double>(patch.elements());
    objective.find_least(x);
    double missing = shortfall(objective.least(), target);
    int stalled = 0;
    for (int move = 0; move < VolumeTuning::kBarrierMoves && missing > 0.0 && stalled < 2; ++move) {
        objective.raise_barriers(VolumeTuning::kHighestBarrier);
        if (!minimiser.run(x, size)) {
            break;
        }
        objective.find_least(x);
        const double now = shortfall(objective.least(), target);
        stalled = now < VolumeTuning::kLeastProgress * missing ? 0 : stalled + 1;
        missing = now;
        if (stalled > 0 &&
            below(objective.least(), target) < VolumeTuning::kPatchShare * static_cast<double>(patch.elements())) {
            break;
        }
    }
    patch.set_state(x);
    return objective.evaluations();
}

}  // namespace mq::curve
