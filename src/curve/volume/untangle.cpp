// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/untangle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "curve/bezier/blending.h"
#include "curve/volume/tuning.h"

namespace mq::curve {

namespace {

/// The objective where it is not defined.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// The Jacobian of one element and its derivative by the control points, on buffers used again.
class ElementJacobian {
  public:
    explicit ElementJacobian(const Lattice& lattice)
        : lattice_(lattice),
          m_(lattice.degree() - 1),
          lower_(Lattice::of(3, m_)),
          first_(ProductTable::of(3, m_, m_)),
          second_(ProductTable::of(3, m_, 2 * m_)),
          coefficients(at(Lattice::of(3, 3 * m_).size())),
          crosses_(at(Lattice::of(3, 2 * m_).size())),
          by_cross_(crosses_.size()) {
        for (auto& d : derivatives_) {
            d.resize(at(lower_.size()));
        }
        by_derivatives_ = derivatives_;
    }

    void evaluate(const std::vector<Vec3>& control) {
        for (std::size_t k = 0; k < 3; ++k) {
            differentiate(control, k);
        }
        std::fill(crosses_.begin(), crosses_.end(), Vec3::Zero());
        std::fill(coefficients.begin(), coefficients.end(), 0.0);
        for (int i = 0; i < lower_.size(); ++i) {
            for (int j = 0; j < lower_.size(); ++j) {
                const auto& e = first_.at(i, j);
                crosses_[at(e.target)] += e.weight * derivatives_[1][at(i)].cross(derivatives_[2][at(j)]);
            }
        }
        for (int i = 0; i < lower_.size(); ++i) {
            for (std::size_t j = 0; j < crosses_.size(); ++j) {
                const auto& e = second_.at(i, static_cast<int>(j));
                coefficients[at(e.target)] += e.weight * derivatives_[0][at(i)].dot(crosses_[j]);
            }
        }
    }

    /// Differentiates the sum of the coefficients multiplied by `weights`; call after `evaluate`.
    void differentiate_sum(const std::vector<double>& weights, std::vector<Vec3>& by_control) {
        for (auto& d : by_derivatives_) {
            std::fill(d.begin(), d.end(), Vec3::Zero());
        }
        std::fill(by_cross_.begin(), by_cross_.end(), Vec3::Zero());
        for (int i = 0; i < lower_.size(); ++i) {
            for (std::size_t j = 0; j < crosses_.size(); ++j) {
                const auto& e = second_.at(i, static_cast<int>(j));
                const double w = weights[at(e.target)] * e.weight;
                by_derivatives_[0][at(i)] += w * crosses_[j];
                by_cross_[j] += w * derivatives_[0][at(i)];
            }
        }
        for (int i = 0; i < lower_.size(); ++i) {
            for (int j = 0; j < lower_.size(); ++j) {
                const auto& e = first_.at(i, j);
                const Vec3 g = e.weight * by_cross_[at(e.target)];
                by_derivatives_[1][at(i)] += derivatives_[2][at(j)].cross(g);
                by_derivatives_[2][at(j)] += g.cross(derivatives_[1][at(i)]);
            }
        }
        by_control.assign(at(lattice_.size()), Vec3::Zero());
        for (std::size_t k = 0; k < 3; ++k) {
            for (int i = 0; i < lower_.size(); ++i) {
                const Vec3 g = lattice_.degree() * by_derivatives_[k][at(i)];
                by_control[at(lattice_.index(raised(i, k + 1)))] += g;
                by_control[at(lattice_.index(raised(i, 0)))] -= g;
            }
        }
        spread_inner_gradient(lattice_, by_control);
    }

    const Lattice& lower() const { return lower_; }

  private:
    Exponents raised(int i, std::size_t k) const {
        Exponents e = lower_.exponents(i);
        ++e[k];
        return e;
    }
    void differentiate(const std::vector<Vec3>& control, std::size_t k) {
        for (int i = 0; i < lower_.size(); ++i) {
            derivatives_[k][at(i)] = lattice_.degree() * (control[at(lattice_.index(raised(i, k + 1)))] -
                                                          control[at(lattice_.index(raised(i, 0)))]);
        }
    }

    const Lattice& lattice_;
    int m_;
    const Lattice& lower_;
    const ProductTable& first_;
    const ProductTable& second_;

  public:
    std::vector<double> coefficients;

  private:
    std::vector<Vec3> crosses_;
    std::vector<Vec3> by_cross_;
    std::array<std::vector<Vec3>, 3> derivatives_;
    std::array<std::vector<Vec3>, 3> by_derivatives_;
};

class Objective {
  public:
    explicit Objective(UntanglingPatch& patch) : patch_(patch), jacobian_(patch.lattice()) { find_movable(); }

    double barrier = 0.0;

    /// The least coefficient that can be changed.
    double least(const Eigen::VectorXd& x) {
        patch_.set_state(x);
        double least = 1.0;
        for (std::size_t i = 0; i < patch_.elements(); ++i) {
            patch_.gather(i, control_);
            jacobian_.evaluate(control_);
            for (std::size_t k = 0; k < jacobian_.coefficients.size(); ++k) {
                if (movable_[i][k]) {
                    least = std::min(least, jacobian_.coefficients[k] / patch_.straight(i));
                }
            }
        }
        return least;
    }

    double operator()(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        patch_.set_state(x);
        gradient.setZero(x.size());
        double sum = 0.0;
        weights_.resize(jacobian_.coefficients.size());
        for (std::size_t i = 0; i < patch_.elements(); ++i) {
            patch_.gather(i, control_);
            jacobian_.evaluate(control_);
            for (std::size_t k = 0; k < weights_.size(); ++k) {
                weights_[k] = 0.0;
                if (!movable_[i][k]) {
                    continue;
                }
                const double b = jacobian_.coefficients[k] / patch_.straight(i);
                if (!(b > barrier)) {
                    return kInfinity;
                }
                const double log = std::log((b - barrier) / (1.0 - barrier));
                sum += log * log + (b - 1.0) * (b - 1.0);
                weights_[k] = (2.0 * log / (b - barrier) + 2.0 * (b - 1.0)) / patch_.straight(i);
            }
            jacobian_.differentiate_sum(weights_, by_control_);
            patch_.scatter(i, by_control_, gradient);
        }
        return sum;
    }

  private:
    /// A coefficient depends on the control points next to it; where all those are fixed nothing can change it.
    void find_movable() {
        const Lattice& lattice = patch_.lattice();
        const Lattice& form = Lattice::of(3, 3 * (lattice.degree() - 1));
        for (std::size_t i = 0; i < patch_.elements(); ++i) {
            std::vector<char> movable(at(form.size()), 0);
            for (int p = 0; p < lattice.size(); ++p) {
                if (!patch_.is_free(i, p)) {
                    continue;
                }
                for (int k = 0; k < form.size(); ++k) {
                    movable[at(k)] |= depends(form.exponents(k), lattice.exponents(p)) ? 1 : 0;
                }
            }
            movable_.push_back(std::move(movable));
        }
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
    ElementJacobian jacobian_;
    std::vector<std::vector<char>> movable_;
    std::vector<Vec3> control_;
    std::vector<Vec3> by_control_;
    std::vector<double> weights_;
};

/// Limited-memory BFGS with backtracking.
class Minimiser {
  public:
    explicit Minimiser(Objective& objective) : objective_(objective) {}

    /// @return whether x moved.
    bool run(Eigen::VectorXd& x, double scale, const Progress& progress) {
        Eigen::VectorXd gradient;
        double value = objective_(x, gradient);
        bool moved = false;
        pairs_.clear();
        for (int step = 0; step < VolumeTuning::kMinimisationSteps; ++step) {
            progress.check();
            Eigen::VectorXd direction = -two_loops(gradient, scale);
            if (direction.dot(gradient) >= 0.0) {
                pairs_.clear();
                direction = -gradient;
            }
            Eigen::VectorXd next;
            Eigen::VectorXd next_gradient;
            double length = 1.0;
            double next_value = kInfinity;
            for (int i = 0; i < VolumeTuning::kLineHalvings; ++i, length *= 0.5) {
                next = x + length * direction;
                next_value = objective_(next, next_gradient);
                if (next_value <= value + 1e-4 * length * direction.dot(gradient)) {
                    break;
                }
                next_value = kInfinity;
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

double untangle(UntanglingPatch& patch, double target, const Progress& progress) {
    if (patch.free_count() == 0) {
        return 1.0;
    }
    Objective objective(patch);
    Minimiser minimiser(objective);
    Eigen::VectorXd x = patch.state();
    double size = 0.0;
    for (std::size_t i = 0; i < patch.elements(); ++i) {
        size += std::cbrt(std::abs(patch.straight(i)));
    }
    size /= static_cast<double>(patch.elements());
    double least = objective.least(x);
    int stalled = 0;
    for (int move = 0; move < VolumeTuning::kBarrierMoves && least < target && stalled < 3; ++move) {
        objective.barrier = least - 0.1 * std::max(std::abs(least), 0.1);
        if (!minimiser.run(x, size, progress)) {
            break;
        }
        const double now = objective.least(x);
        stalled = now > least + 1e-3 + 0.01 * std::abs(least) ? 0 : stalled + 1;
        least = now;
    }
    patch.set_state(x);
    return least;
}

}  // namespace mq::curve
