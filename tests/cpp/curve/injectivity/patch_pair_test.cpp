// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/patch_pair.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <map>
#include <optional>

#include "curve/elements.h"
#include "curve/injectivity/straight_piercing.h"

namespace mq::curve {

using elements::Barycentric;
using elements::Lattice;
using elements::nodes_to_bezier;
using elements::value;

namespace {

constexpr PatchLimits kLimits{1e-13, 1e-6, 1e-9};

using Control = std::vector<Vec3>;

/// Values on a grid of the reference triangle.
class Samples {
  public:
    static constexpr int kSide = 10;

    Samples(const Lattice& lattice, const Control& control) {
        for (int i = 0; i <= kSide; ++i) {
            for (int j = 0; j + i <= kSide; ++j) {
                points_[at(i, j)] = value(lattice, control, place(i, j));
            }
        }
    }
    static Barycentric place(double i, double j) { return {1.0 - (i + j) / kSide, i / kSide, j / kSide, 0.0}; }
    const Vec3& operator()(int i, int j) const { return points_[at(i, j)]; }

  private:
    static std::size_t at(int i, int j) { return static_cast<std::size_t>(i * (kSide + 1) + j); }
    std::array<Vec3, (kSide + 1) * (kSide + 1)> points_;
};

/// A common point of a line on patch a and of patch b, by Newton's method from a first guess.
struct Meeting {
    Barycentric in_a{};
    Barycentric in_b{};
};

std::optional<Meeting> converged(const Lattice& lattice, const Control& a, const Control& b, const Barycentric& from,
                                 const Barycentric& to, Vec3 unknown) {
    const auto meeting_at = [&](const Vec3& x) {
        Meeting m;
        for (std::size_t k = 0; k < 3; ++k) {
            m.in_a[k] = (1.0 - x[0]) * from[k] + x[0] * to[k];
        }
        m.in_b = {1.0 - x[1] - x[2], x[1], x[2], 0.0};
        return m;
    };
    const auto gap = [&](const Vec3& x) {
        const Meeting m = meeting_at(x);
        return Vec3(value(lattice, a, m.in_a) - value(lattice, b, m.in_b));
    };
    for (int round = 0; round < 20 && gap(unknown).norm() > 1e-13; ++round) {
        Eigen::Matrix3d slope;
        for (int k = 0; k < 3; ++k) {
            const Vec3 step = 1e-6 * Vec3::Unit(k);
            slope.col(k) = (gap(unknown + step) - gap(unknown - step)) / 2e-6;
        }
        unknown -= Vec3(slope.fullPivLu().solve(gap(unknown)));
    }
    const Meeting m = meeting_at(unknown);
    const bool inside =
        unknown[0] >= 0.0 && unknown[0] <= 1.0 && m.in_b[0] >= 0.0 && m.in_b[1] >= 0.0 && m.in_b[2] >= 0.0;
    return inside && gap(unknown).norm() < 1e-12 ? std::optional<Meeting>(m) : std::nullopt;
}

/// A common point of two patches, where their straight pieces cross; away from what is shared by `away`.
template <typename Away>
bool meet(const Lattice& lattice, const Control& a, const Control& b, const Away& away) {
    const Samples in_a(lattice, a);
    const Samples in_b(lattice, b);
    const auto try_segment = [&](int i, int j, int to_i, int to_j) {
        for (int k = 0; k < Samples::kSide; ++k) {
            for (int m = 0; m + k < Samples::kSide; ++m) {
                if (!certain_piercing(in_a(i, j), in_a(to_i, to_j), 0.0, {in_b(k, m), in_b(k + 1, m), in_b(k, m + 1)},
                                      0.0)) {
                    continue;
                }
                const Vec3 guess(0.5, (k + 0.3) / Samples::kSide, (m + 0.3) / Samples::kSide);
                const std::optional<Meeting> meeting =
                    converged(lattice, a, b, Samples::place(i, j), Samples::place(to_i, to_j), guess);
                if (meeting && away(*meeting)) {
                    return true;
                }
            }
        }
        return false;
    };
    for (int i = 0; i < Samples::kSide; ++i) {
        for (int j = 0; j + i < Samples::kSide; ++j) {
            if (try_segment(i, j, i + 1, j) || try_segment(i, j, i, j + 1) || try_segment(i + 1, j, i, j + 1)) {
                return true;
            }
        }
    }
    return false;
}

struct Counts {
    std::map<PatchContact, int> verdicts;
    int meetings = 0;
};

enum class Shared { Nothing, Vertex, Edge };

/// Random pairs; those with a common point by Newton's method must not be proven apart.
Counts compare_random_pairs(int order, Shared shared, int rounds) {
    std::mt19937 random(static_cast<unsigned>(order));
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const Lattice& lattice = Lattice::of(2, order);
    Counts counts;
    for (int round = 0; round < rounds; ++round) {
        const Control a = perturbed(nodes_of(lattice, identity), 0.15, random);
        const Vec3 top(0.6 * uniform(random) - 0.1, -0.4 + 0.7 * uniform(random), 0.6 * uniform(random));
        const Vec3 origin = shared == Shared::Nothing ? Vec3(uniform(random), uniform(random), 0.4 * uniform(random))
                                                      : Vec3(0.0, 0.0, 0.0);
        const Vec3 side = shared == Shared::Edge ? Vec3(1.0, 0.0, 0.0)
                                                 : Vec3(uniform(random), uniform(random), 0.5 * uniform(random));
        const auto map = [&](const Vec3& x) { return Vec3(origin + x.x() * side + x.y() * top); };
        Control b = perturbed(nodes_of(lattice, map), 0.15, random);
        SharedEntities entities;
        for (int i = 0; i < lattice.size(); ++i) {
            const elements::Exponents& e = lattice.exponents(i);
            const bool same = shared == Shared::Vertex ? e[0] == order : shared == Shared::Edge && e[2] == 0;
            if (same) {
                b[static_cast<std::size_t>(i)] = a[static_cast<std::size_t>(i)];
            }
        }
        if (shared != Shared::Nothing) {
            entities.corners.push_back({0, 0});
        }
        if (shared == Shared::Edge) {
            entities.corners.push_back({1, 1});
            entities.edges.push_back({0, 1});
        }
        const bool meeting = meet(lattice, a, b, [&](const Meeting& m) {
            return shared == Shared::Nothing || (shared == Shared::Vertex ? m.in_a[0] < 0.999 : m.in_a[2] > 0.001);
        });
        const PatchContact contact = contact_of_patches(lattice, a, b, entities, kLimits).contact;
        ++counts.verdicts[contact];
        counts.meetings += meeting ? 1 : 0;
        EXPECT_FALSE(meeting && contact == PatchContact::None) << "order " << order << ", pair " << round;
    }
    return counts;
}

TEST(PatchPair, WhatMeetsIsNeverProvenApart) {
    constexpr int kRounds = 60;
    for (const Shared shared : {Shared::Nothing, Shared::Vertex, Shared::Edge}) {
        for (int order = 1; order <= 5; ++order) {
            Counts counts = compare_random_pairs(order, shared, kRounds);
            EXPECT_LE(counts.verdicts[PatchContact::NotProven], 3) << order << " " << static_cast<int>(shared);
            EXPECT_GT(counts.verdicts[PatchContact::None], kRounds / 10) << order << " " << static_cast<int>(shared);
            EXPECT_GE(counts.verdicts[PatchContact::Crossing] + counts.verdicts[PatchContact::NotProven],
                      counts.meetings);
            if (order > 1 || shared != Shared::Edge) {
                EXPECT_GT(counts.meetings, 0) << order << " " << static_cast<int>(shared);
            }
        }
    }
}

TEST(PatchPair, PatchesWithoutACommonEdgeButTwoCommonVerticesAreTold) {
    // Two sheets that bulge to both sides between the same corners.
    const Lattice& lattice = Lattice::of(2, 2);
    const auto bulge = [&](double height) {
        return nodes_to_bezier(lattice, nodes_of(lattice, [=](const Vec3& x) {
                                   return Vec3(x.x(), 0.5 * x.y(), height * (x.x() * (1.0 - x.x()) + x.y()));
                               }));
    };
    SharedEntities corners;
    corners.corners = {{0, 0}, {1, 1}};
    EXPECT_EQ(contact_of_patches(lattice, bulge(0.5), bulge(-0.5), corners, kLimits).contact, PatchContact::None);
    EXPECT_EQ(contact_of_patches(lattice, bulge(0.5), bulge(0.4), corners, kLimits).contact, PatchContact::None);
}

TEST(PatchPair, AMonotonePatchDoesNotMeetItself) {
    std::mt19937 random(3);
    for (int order = 1; order <= 5; ++order) {
        const Lattice& lattice = Lattice::of(2, order);
        for (int round = 0; round < 50; ++round) {
            const Control control = perturbed(nodes_of(lattice, identity), 0.2 / order, random);
            EXPECT_EQ(contact_with_itself(lattice, control, kLimits).contact, PatchContact::None);
        }
    }
}

TEST(PatchPair, ASpiralStaircaseDoesNotMeetItselfAndAFoldMayDo) {
    const Lattice& lattice = Lattice::of(2, 5);
    // Not monotone: it turns by more than half a circle.
    const auto turned = [&](double rise) {
        return nodes_to_bezier(lattice, nodes_of(lattice, [=](const Vec3& x) {
                                   const double angle = 4.0 * x.x();
                                   const double radius = 1.0 + 0.5 * x.y();
                                   return Vec3(radius * std::cos(angle), radius * std::sin(angle), rise * angle);
                               }));
    };
    EXPECT_EQ(contact_with_itself(lattice, turned(0.2), kLimits).contact, PatchContact::None);
    const auto fold = nodes_to_bezier(
        lattice, nodes_of(lattice, [](const Vec3& x) { return Vec3((x.x() - 0.4) * (x.x() - 0.4), x.y(), 0.0); }));
    EXPECT_NE(contact_with_itself(lattice, fold, kLimits).contact, PatchContact::None);
}

}  // namespace
}  // namespace mq::curve
