// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/spacing/face_cells.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/key_set.h"
#include "triangulate/spacing/morton_order.h"
#include "triangulate/spacing/tuning.h"

namespace mq::triangulate {

namespace {

using geometry::Engine;
using geometry::Query;

// Cells along each side of the rectangle at first: the length of the surface between their corners is measurable on a
// quarter of a period.
constexpr int kRoots = 4;
// Largest number of halvings: where the surface is discontinuous, sides never become shorter.
constexpr int kMostDepth = 48;

}  // namespace

FaceCells::FaceCells(geometry::Session& session, int face, std::vector<Segment2> outline, Spacing spacing)
    : session_(session), face_(face), outline_(std::move(outline)), spacing_(std::move(spacing)) {
    make_roots();
}

void FaceCells::make_roots() {
    if (outline_.empty()) {
        return;
    }
    low_ = outline_[0][0];
    high_ = low_;
    for (const Segment2& s : outline_) {
        low_ = low_.cwiseMin(s[0]).cwiseMin(s[1]);
        high_ = high_.cwiseMax(s[0]).cwiseMax(s[1]);
    }
    for (int j = 0; j <= kRoots; ++j) {
        for (int i = 0; i <= kRoots; ++i) {
            const Vec2 part(static_cast<double>(i) / kRoots, static_cast<double>(j) / kRoots);
            corners_.push_back({low_ + part.cwiseProduct(high_ - low_), Vec3::Zero(), 0.0});
        }
    }
    measure(0);
    std::vector<int> all(outline_.size());
    std::iota(all.begin(), all.end(), 0);
    const Vec2 beyond = low_ - 0.1 * (high_ - low_);
    for (int j = 0; j < kRoots; ++j) {
        for (int i = 0; i < kRoots; ++i) {
            const int a = j * (kRoots + 1) + i;
            const int d = a + kRoots + 1;
            Cell cell{{a, a + 1, d + 1, d}, -1, false, 0};
            place(cell, all, beyond, false);
            const bool found = std::all_of(cell.corners.begin(), cell.corners.end(),
                                           [this](int c) { return corners_[c].spacing > 0.0; });
            if (found && !outside(cell)) {
                cells_.push_back(cell);
            }
        }
    }
}

void FaceCells::measure(std::size_t first) {
    for (std::size_t from = first; from < corners_.size(); from += SpacingTuning::kCornersInBatch) {
        const std::size_t to = std::min(corners_.size(), from + SpacingTuning::kCornersInBatch);
        Engine::Batch batch;
        for (std::size_t i = from; i < to; ++i) {
            batch.push_back(Query::face_curvatures(face_, corners_[i].uv.x(), corners_[i].uv.y()));
        }
        const Engine::Answers answers = session_.ask(std::move(batch));
        for (std::size_t i = from; i < to; ++i) {
            const geometry::Answer& a = answers[i - from];
            if (a.found()) {
                corners_[i].point = a.point;
                corners_[i].spacing = spacing_(a);
            }
        }
    }
}

// An arbitrary point, so that it does not lie on the outline of regular faces.
Vec2 FaceCells::reference(const Cell& cell) const {
    const Vec2& low = corners_[cell.corners[0]].uv;
    const Vec2& high = corners_[cell.corners[2]].uv;
    return low + Vec2(0.497, 0.511).cwiseProduct(high - low);
}

// Half 0 has the corners 0, 1, 2, half 1 has 0, 2, 3.
Triangle2 FaceCells::triangle(const Cell& cell, int half) const {
    return {corners_[cell.corners[0]].uv, corners_[cell.corners[1 + half]].uv, corners_[cell.corners[2 + half]].uv};
}

// Classifies the cell, given a classified point and the segments that lie between both or in the cell.
void FaceCells::place(Cell& cell, const std::vector<int>& among, const Vec2& known, bool inside) {
    const Triangle2 first = triangle(cell, 0);
    const Triangle2 second = triangle(cell, 1);
    const Vec2 here = reference(cell);
    std::vector<int> met;
    cell.inside = inside;
    for (const int s : among) {
        if (crosses(known, here, outline_[s])) {
            cell.inside = !cell.inside;
        }
        if (meets(first, outline_[s]) || meets(second, outline_[s])) {
            met.push_back(s);
        }
    }
    cell.list = met.empty() ? -1 : static_cast<int>(lists_.size());
    if (!met.empty()) {
        lists_.push_back(std::move(met));
    }
}

double FaceCells::extent(const Cell& cell, int axis) const {
    const std::array<int, 4>& c = cell.corners;
    return axis == 0 ? std::max(side(c[0], c[1]), side(c[3], c[2])) : std::max(side(c[0], c[3]), side(c[1], c[2]));
}

double FaceCells::longest_side(std::size_t cell) const {
    return std::max(extent(cells_[cell], 0), extent(cells_[cell], 1));
}

double FaceCells::least_spacing(std::size_t cell) const {
    return std::min(
        {corner(cell, 0).spacing, corner(cell, 1).spacing, corner(cell, 2).spacing, corner(cell, 3).spacing});
}

std::vector<Segment2> FaceCells::outline(std::size_t cell) const {
    std::vector<Segment2> found;
    if (cells_[cell].list >= 0) {
        for (const int s : lists_[cells_[cell].list]) {
            found.push_back(outline_[s]);
        }
    }
    return found;
}

std::vector<std::size_t> FaceCells::all() const {
    const Vec2 size = (high_ - low_).cwiseMax(1e-300);
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        if (!outside(cells_[c])) {
            order.emplace_back(morton_order((reference(c) - low_).cwiseQuotient(size)), c);
        }
    }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> found;
    for (const auto& entry : order) {
        found.push_back(entry.second);
    }
    return found;
}

std::vector<FaceCells::Corner> FaceCells::inner_corners() const {
    std::vector<bool> inner(corners_.size(), false);
    for (const std::size_t c : all()) {
        const std::vector<Segment2> segments = outline(c);
        for (const int k : cells_[c].corners) {
            const auto crossings = std::count_if(segments.begin(), segments.end(), [&](const Segment2& s) {
                return crosses(reference(c), corners_[k].uv, s);
            });
            inner[k] = inner[k] || inside(c) == (crossings % 2 == 0);
        }
    }
    std::vector<Corner> found;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        if (inner[k]) {
            found.push_back(corners_[k]);
        }
    }
    return found;
}

void FaceCells::divide(double share, const Progress& progress) {
    std::vector<std::size_t> open = all();
    while (!open.empty()) {
        progress.check();
        const auto small = [&](std::size_t c) { return longest_side(c) <= share * least_spacing(c); };
        open.erase(std::remove_if(open.begin(), open.end(), small), open.end());
        open = halve(open);
    }
}

std::vector<std::size_t> FaceCells::halve(const std::vector<std::size_t>& cells) {
    const std::size_t first = corners_.size();
    std::vector<std::array<int, 2>> middles;
    KeyMap<int> known;
    const auto middle = [&](int a, int b) {
        const auto entry = known.insert({pair_key(a, b), static_cast<int>(corners_.size())});
        if (entry.second) {
            corners_.push_back({0.5 * (corners_[a].uv + corners_[b].uv), Vec3::Zero(), 0.0});
        }
        return entry.first->second;
    };
    for (const std::size_t c : cells) {
        const std::array<int, 4>& k = cells_[c].corners;
        const bool in_u = longer_axis(cells_[c]) == 0;
        const int from = middle(k[0], in_u ? k[1] : k[3]);
        middles.push_back({from, middle(k[2], in_u ? k[3] : k[1])});
    }
    measure(first);
    std::vector<std::size_t> halves;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        halve(cells[i], middles[i], halves);
    }
    return halves;
}

void FaceCells::halve(std::size_t number, const std::array<int, 2>& middles, std::vector<std::size_t>& halves) {
    const Cell whole = cells_[number];
    const int axis = longer_axis(whole);
    const auto& [low, right, high, left] = whole.corners;
    const auto& [from, to] = middles;
    const double middle = corners_[from].uv[axis];
    if (!(corners_[from].spacing > 0.0) || !(corners_[to].spacing > 0.0) || whole.depth >= kMostDepth ||
        middle == corners_[low].uv[axis] || middle == corners_[high].uv[axis]) {
        return;
    }
    const auto depth = static_cast<std::uint8_t>(whole.depth + 1);
    const std::vector<int> among = whole.list < 0 ? std::vector<int>() : std::move(lists_[whole.list]);
    const Vec2 known = reference(whole);
    const auto half = [&](const std::array<int, 4>& corners) {
        Cell made{corners, -1, whole.inside, depth};
        if (whole.list >= 0) {
            place(made, among, known, whole.inside);
        }
        return made;
    };
    cells_[number] = axis == 0 ? half({low, from, to, left}) : half({low, right, to, from});
    if (!outside(cells_[number])) {
        halves.push_back(number);
    }
    const Cell second = axis == 0 ? half({from, right, high, to}) : half({from, to, high, left});
    if (!outside(second)) {
        halves.push_back(cells_.size());
        cells_.push_back(second);
    }
}

}  // namespace mq::triangulate
