// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace mq {

/// Bounds of iterations that ended by themselves in all measurements (docs/measurements/tuning.md). They hold where the
/// same states come again, for instance by rounding: of rounds through a whole model ...
constexpr int kMostRounds = 16;
/// ... of steps that take little time ...
constexpr int kMostSteps = 100;
/// ... and of Newton steps of a projection; each about squares the distance.
constexpr int kNewtonSteps = 8;

}  // namespace mq
