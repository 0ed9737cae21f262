// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/sizes/size_field_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq {

namespace {

// Side of the cube, divided by the largest side of the box: faces of the box lie inside.
constexpr double kLarger = 1.02;
// Side of a cell below which it is not divided, divided by the least length in it.
constexpr double kSmallest = 0.5;
// New samples for a cell whose neighbours are divided likewise.
constexpr std::size_t kNewSamples = 8;
constexpr unsigned kBits = 21;  // number of them for one coordinate in a key
constexpr double kUnknown = -1.0;

constexpr std::uint32_t kUnits = 1U << (SizeFieldSampler::kDepth + 1);  // along the cube

}  // namespace

SizeFieldSampler::SizeFieldSampler(const Box& box, double error, int least_depth, std::size_t most_samples)
    : side_(kLarger * std::max(box.largest_side(), std::numeric_limits<double>::min())),
      error_(error),
      least_depth_(std::min(least_depth, kDepth)),
      most_samples_(most_samples),
      box_(box) {
    if (box_.empty()) {
        box_.add(Vec3::Zero());
    }
    low_ = box_.center() - Vec3::Constant(0.5 * side_);
    restart();
}

SizeFieldSampler::Key SizeFieldSampler::key_of(const std::array<std::uint32_t, 3>& place) {
    return (static_cast<Key>(place[2]) << 2 * kBits) | (static_cast<Key>(place[1]) << kBits) | place[0];
}

// The centre of a cell is the centre of no other one.
SizeFieldSampler::Key SizeFieldSampler::cell_key(const std::array<std::uint32_t, 3>& low, int depth) {
    const std::uint32_t half = 1U << static_cast<unsigned>(kDepth - depth);
    return key_of({low[0] + half, low[1] + half, low[2] + half});
}

void SizeFieldSampler::mark(const Vec3& point, double length) {
    const Vec3 place = (point - low_) / side_;
    if (!(place.minCoeff() >= 0.0 && place.maxCoeff() < 1.0)) {
        return;
    }
    double side = side_;
    for (int depth = 0; depth < kDepth && side > length; ++depth, side *= 0.5) {
        const std::uint32_t span = span_of(depth);
        std::array<std::uint32_t, 3> low{};
        for (int i = 0; i < 3; ++i) {
            low[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(place[i] * kUnits) / span * span;
        }
        marked_.insert(cell_key(low, depth));
    }
}

void SizeFieldSampler::restrict_to(const std::vector<Vec3>& points, int depth) {
    near_depth_ = std::min(depth, kDepth);
    const std::uint32_t span = span_of(near_depth_);
    std::unordered_set<Key> cells;
    for (const Vec3& point : points) {
        const Vec3 place = ((point - low_) / side_).cwiseMax(0.0).cwiseMin(1.0) * (kUnits - 1);
        std::array<std::uint32_t, 3> low{};
        for (int i = 0; i < 3; ++i) {
            low[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(place[i]) / span * span;
        }
        if (!cells.insert(cell_key(low, near_depth_)).second) {
            continue;
        }
        for (int n = 0; n < 27; ++n) {  // where one lies beyond the cube, its key is that of no cell
            near_.insert(cell_key({low[0] + span * static_cast<std::uint32_t>(n % 3) - span,
                                   low[1] + span * static_cast<std::uint32_t>(n / 3 % 3) - span,
                                   low[2] + span * static_cast<std::uint32_t>(n / 9) - span},
                                  near_depth_));
        }
    }
}

// Whether the model may lie in a cell.
bool SizeFieldSampler::is_relevant(const Cell& cell) const {
    const double unit = side_ / kUnits;
    const Vec3 low = low_ + unit * Vec3(cell.low[0], cell.low[1], cell.low[2]);
    if (!box_.meets({low, low + Vec3::Constant(unit * span_of(cell.depth))})) {
        return false;
    }
    if (near_.empty() || cell.depth < near_depth_) {
        return true;
    }
    const std::uint32_t span = span_of(near_depth_);
    return near_.count(cell_key({cell.low[0] / span * span, cell.low[1] / span * span, cell.low[2] / span * span},
                                near_depth_)) > 0;
}

void SizeFieldSampler::restart() {
    children_.assign(1, 0);
    leaves_.clear();
    unresolved_ = 0;
    front_ = {{{0, 0, 0}, 0, 0}};
    front_is_sampled_ = false;
    asked_.clear();
}

bool SizeFieldSampler::is_marked(const Cell& cell) const {
    return marked_.count(cell_key(cell.low, cell.depth)) > 0;
}

bool SizeFieldSampler::must_divide(const Cell& cell) const {
    return cell.depth < kDepth && (cell.depth < least_depth_ || is_marked(cell));
}

void SizeFieldSampler::want_samples_of(const Cell& cell) {
    const std::uint32_t half = span_of(cell.depth) / 2;
    for (std::uint32_t k = 0; k < 3; ++k) {
        for (std::uint32_t j = 0; j < 3; ++j) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Key key = key_of({cell.low[0] + half * i, cell.low[1] + half * j, cell.low[2] + half * k});
                if (value_of_.emplace(key, kUnknown).second) {
                    asked_.push_back(key);
                }
            }
        }
    }
}

std::vector<Vec3> SizeFieldSampler::wanted() {
    while (!front_.empty()) {
        if (!front_is_sampled_) {
            for (const Cell& cell : front_) {
                if (!must_divide(cell)) {
                    want_samples_of(cell);
                }
            }
            front_is_sampled_ = true;
        }
        if (!asked_.empty()) {
            break;
        }
        advance();
    }
    constexpr Key kMask = (static_cast<Key>(1) << kBits) - 1;
    std::vector<Vec3> points;
    points.reserve(asked_.size());
    for (const Key key : asked_) {
        const Vec3 place(static_cast<double>(key & kMask), static_cast<double>(key >> kBits & kMask),
                         static_cast<double>(key >> 2 * kBits));
        points.push_back(low_ + (side_ / kUnits) * place);
    }
    return points;
}

void SizeFieldSampler::give(const double* values, std::size_t count) {
    if (count != asked_.size()) {
        throw InvalidInput(phrases::kNumbersForEach, {{"name", "sizes"}, {"count", count}, {"count2", asked_.size()}});
    }
    // Lengths above the side of the cube bound no edge: they are all alike.
    for (std::size_t i = 0; i < count; ++i) {
        value_of_[asked_[i]] = std::min(values[i], side_);
    }
    asked_.clear();
}

double SizeFieldSampler::at(const Cell& cell, int i, int j, int k) const {
    const std::uint32_t half = span_of(cell.depth) / 2;
    const std::array<std::uint32_t, 3> place{cell.low[0] + half * static_cast<std::uint32_t>(i),
                                             cell.low[1] + half * static_cast<std::uint32_t>(j),
                                             cell.low[2] + half * static_cast<std::uint32_t>(k)};
    return value_of_.at(key_of(place));
}

void SizeFieldSampler::divide(const Cell& cell, std::vector<Cell>& next) {
    const std::uint32_t half = span_of(cell.depth) / 2;
    const auto first = static_cast<std::int32_t>(children_.size());
    children_[static_cast<std::size_t>(cell.index)] = first;
    children_.resize(children_.size() + 8);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
        next.push_back({{cell.low[0] + half * (octant & 1U), cell.low[1] + half * (octant >> 1U & 1U),
                         cell.low[2] + half * (octant >> 2U)},
                        cell.depth + 1,
                        first + static_cast<std::int32_t>(octant)});
    }
}

// Divides a cell whose values are known, or makes it a leaf.
void SizeFieldSampler::settle(const Cell& cell, std::vector<Cell>& next) {
    SizeField::Corners corners{};
    for (int c = 0; c < 8; ++c) {
        corners[static_cast<std::size_t>(c)] = at(cell, 2 * (c & 1), 2 * (c >> 1 & 1), 2 * (c >> 2));
    }
    double least = side_;
    double worst = 0.0;
    for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) {
                const double value = at(cell, i, j, k);
                const double between = trilinear(corners, Vec3(0.5 * i, 0.5 * j, 0.5 * k));
                least = std::min(least, value);
                worst = std::max(worst, std::abs(value - between) / std::min(value, between));
            }
        }
    }
    const double side = std::ldexp(side_, -cell.depth);
    const bool is_good = worst <= error_ || !is_relevant(cell);
    if (!is_good && side > kSmallest * least && cell.depth < kDepth &&
        value_of_.size() + kNewSamples * next.size() < most_samples_) {
        divide(cell, next);
        return;
    }
    if (!is_good) {
        ++unresolved_;
        corners.fill(least);
    }
    children_[static_cast<std::size_t>(cell.index)] = -1 - static_cast<std::int32_t>(leaves_.size());
    leaves_.push_back(corners);
}

void SizeFieldSampler::advance() {
    std::vector<Cell> next;
    for (const Cell& cell : front_) {
        if (must_divide(cell)) {
            divide(cell, next);
        } else {
            settle(cell, next);
        }
    }
    front_ = std::move(next);
    front_is_sampled_ = false;
}

SizeField SizeFieldSampler::field() const {
    return {low_, side_, children_, leaves_};
}

}  // namespace mq
