// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/untangle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "base/parallel.h"
#include "base/tuning.h"
#include "curve/volume/jacobian_batch.h"
#include "curve/volume/tuning.h"
#include "elements/bezier/blending.h"

namespace mq::curve {

using elements::Lattice;

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
        : patch_(patch),
          progress_(progress),
          coefficients_(at(Lattice::of(3, 3 * (patch.lattice().degree() - 1)).size())) {
        find_movable();
        const int threads = threads_for(batches(), kOfThread);
        at_once_ = threads > 1 ? kOfThread * at(threads) : 1;
        workspaces_.assign(at(threads), Workspace(patch.lattice()));
        sums_.resize(at_once_);
        by_control_.resize(at_once_ * kLanes);
    }

    /// The least coefficients of the elements that can be changed, 1 at most.
    const std::vector<Lanes>& least() const { return least_; }
    std::size_t elements() const { return elements_.size(); }
    /// The number of Jacobians evaluated.
    std::size_t evaluations() const { return evaluations_; }

    void find_least(const Eigen::VectorXd& x) {
        patch_.set_state(x);
        least_.assign(batches(), Lanes::Ones());
        for (std::size_t first = 0; first < batches(); first += at_once_) {
            for_batches(first, [&](Workspace& work, std::size_t batch) {
                evaluate(work, batch);
                for (std::size_t k = 0; k < coefficients_; ++k) {
                    least_[batch] = least_[batch].min(relative(work, batch, k));
                }
            });
        }
        evaluations_ += elements_.size();
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
    /// @param gradient  gets the derivative, which is incomplete where the result is infinite; nullptr: only the value
    double value(const Eigen::VectorXd& x, double bound, Eigen::VectorXd* gradient = nullptr) {
        patch_.set_state(x);
        if (gradient != nullptr) {
            gradient->setZero(x.size());
        }
        double sum = 0.0;
        for (std::size_t first = 0; first < batches(); first += at_once_) {
            for_batches(first, [&](Workspace& work, std::size_t batch) {
                evaluate(work, batch);
                double& own = sums_[batch - first];
                own = value_of(work, batch);
                if (gradient != nullptr && own < kInfinity) {
                    work.jacobian.differentiate_sum(work.weights, work.by_lanes);
                    unpack(work, batch, first);
                }
            });
            // Summed in the order of the batches, so that rounding does not depend on the number of threads.
            for (std::size_t batch = first; batch < std::min(first + at_once_, batches()); ++batch) {
                evaluations_ += count(batch);
                sum += sums_[batch - first];
                if (!(sum <= bound)) {
                    return kInfinity;
                }
                for (std::size_t lane = 0; lane < count(batch) && gradient != nullptr; ++lane) {
                    patch_.scatter(elements_[batch * kLanes + lane], by_control_[(batch - first) * kLanes + lane],
                                   *gradient);
                }
            }
        }
        return sum;
    }

  private:
    /// Least number of batches for a thread, so that starting it pays.
    static constexpr std::size_t kOfThread = 64;

    /// The buffers of one thread.
    struct Workspace {
        explicit Workspace(const Lattice& lattice) : jacobian(lattice), weights(jacobian.coefficients.size()) {}
        JacobianBatch jacobian;
        std::vector<Vec3> control;
        std::vector<LaneVector> by_lanes;
        std::vector<Lanes> weights;
    };

    /// Calls work(workspace, batch) for the batches that are done at once, from `first` on.
    template <typename Work>
    void for_batches(std::size_t first, const Work& work) {
        const std::size_t end = std::min(first + at_once_, batches());
        if (end == first + 1) {
            work(workspaces_.front(), first);
            return;
        }
        const ThreadLimit limit(static_cast<int>(workspaces_.size()));
        constexpr std::size_t kChunk = 8;
        parallel_for_on_threads(static_cast<int>((end - first + kChunk - 1) / kChunk), [&](int thread, int k) {
            const std::size_t from = first + kChunk * at(k);
            for (std::size_t batch = from; batch < std::min(from + kChunk, end); ++batch) {
                work(workspaces_[at(thread)], batch);
            }
        });
    }

    std::size_t batches() const { return inverse_.size(); }
    std::size_t count(std::size_t batch) const {
        return std::min<std::size_t>(kLanes, elements_.size() - batch * kLanes);
    }

    /// Coefficient k relative to the J that the element shall have; 1 if no free point can change it.
    Lanes relative(const Workspace& work, std::size_t batch, std::size_t k) const {
        const unsigned char movable = movable_[batch][k];
        Lanes b = work.jacobian.coefficients[k] * inverse_[batch];
        for (int lane = 0; lane < kLanes; ++lane) {
            b[lane] = (movable >> lane & 1) != 0 ? b[lane] : 1.0;
        }
        return b;
    }

    /// The sum over one batch; sets the weights of its derivative.
    double value_of(Workspace& work, std::size_t batch) const {
        const Lanes& barrier = barrier_[batch];
        Lanes sum = Lanes::Zero();
        for (std::size_t k = 0; k < coefficients_; ++k) {
            if (movable_[batch][k] == 0) {
                work.weights[k].setZero();
                continue;
            }
            const Lanes b = relative(work, batch, k);
            const Lanes above = b - barrier;
            if (!(above > 0.0).all()) {
                return kInfinity;
            }
            const Lanes log = (above / (1.0 - barrier)).log();
            sum += log * log + (b - 1.0) * (b - 1.0);
            work.weights[k] = (2.0 * log / above + 2.0 * (b - 1.0)) * inverse_[batch];
        }
        return sum[0] + sum[1] + sum[2] + sum[3];
    }

    /// @throws Cancelled
    void evaluate(Workspace& work, std::size_t batch) const {
        progress_.check();
        for (std::size_t lane = 0; lane < count(batch); ++lane) {
            patch_.gather(elements_[batch * kLanes + lane], work.control);
            const auto l = static_cast<Eigen::Index>(lane);
            for (std::size_t p = 0; p < work.control.size(); ++p) {
                work.jacobian.control[p].x[l] = work.control[p].x();
                work.jacobian.control[p].y[l] = work.control[p].y();
                work.jacobian.control[p].z[l] = work.control[p].z();
            }
        }
        work.jacobian.evaluate();
    }

    /// The derivatives of the elements of a batch by their control points.
    void unpack(const Workspace& work, std::size_t batch, std::size_t first) {
        for (std::size_t lane = 0; lane < count(batch); ++lane) {
            std::vector<Vec3>& by_control = by_control_[(batch - first) * kLanes + lane];
            by_control.resize(work.by_lanes.size());
            const auto l = static_cast<Eigen::Index>(lane);
            for (std::size_t p = 0; p < by_control.size(); ++p) {
                by_control[p] = {work.by_lanes[p].x[l], work.by_lanes[p].y[l], work.by_lanes[p].z[l]};
            }
            elements::spread_inner_gradient(patch_.lattice(), by_control);
        }
    }

    /// A coefficient depends on the control points next to it; where all those are fixed nothing can change it.
    /// Elements without coefficients that can be changed are left out.
    void find_movable() {
        const int points = patch_.lattice().size();
        std::vector<std::vector<std::size_t>> dependent(at(points));
        for (int p = 0; p < points; ++p) {
            dependent[at(p)] = dependent_on(p);
        }
        for (std::size_t i = 0; i < patch_.elements(); ++i) {
            progress_.check();
            std::vector<char> movable(coefficients_, 0);
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
            movable_.emplace_back(coefficients_, static_cast<unsigned char>(0));
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

    /// Whether coefficient `l` has a factor that is a derivative with point `e`.
    static bool depends(const elements::Exponents& l, const elements::Exponents& e) {
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
    std::size_t coefficients_;  // number of coefficients of an element's Jacobian
    std::size_t evaluations_ = 0;
    std::vector<std::size_t> elements_;                // elements of the patch that can change, four to a batch
    std::vector<Lanes> inverse_;                       // 1 / J that the element shall have
    std::vector<std::vector<unsigned char>> movable_;  // by batch and coefficient: a bit for each lane
    std::vector<Lanes> barrier_;
    std::vector<Lanes> least_;
    std::size_t at_once_ = 1;                    // batches
    std::vector<Workspace> workspaces_;          // by thread
    std::vector<double> sums_;                   // by batch among those that are summed in parallel
    std::vector<std::vector<Vec3>> by_control_;  // likewise, by element
};

/// Limited-memory BFGS with backtracking.
class Minimiser {
  public:
    explicit Minimiser(Objective& objective) : objective_(objective) {}

    /// @return whether x moved.
    bool run(Eigen::VectorXd& x, double scale) {
        Eigen::VectorXd gradient;
        double value = objective_.value(x, kInfinity, &gradient);
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
            for (int i = 0; i < kMostRounds && next_value == kInfinity; ++i, length *= 0.5) {
                next = x + length * direction;
                const double bound = value + 1e-4 * length * direction.dot(gradient);
                // Full steps are mostly accepted; for shorter steps the gradient is computed only after they are
                // accepted.
                next_value = i == 0 ? objective_.value(next, bound, &next_gradient) : objective_.value(next, bound);
                if (i > 0 && next_value < kInfinity) {
                    next_value = objective_.value(next, bound, &next_gradient);
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

/// How far the elements are from the target; all inverted elements count alike.
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
