// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/facing_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace mq::boolean {

namespace {

Box box_of(const Soup& soup, std::size_t t) {
    Box box;
    for (const std::int32_t v : soup.triangles[t]) {
        box.add(soup.vertices[static_cast<std::size_t>(v)]);
    }
    return box;
}

/// A grid over the places where boxes of operands come near each other, which knows the operands in each cell.
class OperandCells {
  public:
    /// @param box  what the grid covers
    /// @param cell  mm, the least side of a cell
    OperandCells(const Box& box, double cell, std::size_t triangles) : box_(box) {
        // About as many cells on a surface as it has triangles.
        const double most = std::clamp(std::sqrt(static_cast<double>(triangles)), 1.0, kMostCells);
        for (int i = 0; i < 3; ++i) {
            const double side = box.high[i] - box.low[i];
            count_[i] = std::max(1, static_cast<int>(std::min(most, side / cell)));
            scale_[i] = side > 0.0 ? count_[i] / side : 0.0;
        }
        operand_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2], kNone);
    }

    /// Calls use(cell) for each cell that a box meets.
    template <typename Use>
    void visit(const Box& box, const Use& use) const {
        std::array<int, 3> low;
        std::array<int, 3> high;
        for (int i = 0; i < 3; ++i) {
            if (box.high[i] < box_.low[i] || box.low[i] > box_.high[i]) {
                return;
            }
            low[i] = place(box.low[i], i);
            high[i] = place(box.high[i], i);
        }
        for (int z = low[2]; z <= high[2]; ++z) {
            for (int y = low[1]; y <= high[1]; ++y) {
                for (int x = low[0]; x <= high[0]; ++x) {
                    use((static_cast<std::size_t>(z) * count_[1] + y) * count_[0] + x);
                }
            }
        }
    }
    void mark(const Box& box, std::int32_t operand) {
        visit(box, [&](std::size_t cell) {
            operand_[cell] = operand_[cell] == kNone || operand_[cell] == operand ? operand : kSeveral;
        });
    }
    bool has_other(const Box& box, std::int32_t operand) const {
        bool result = false;
        visit(box,
              [&](std::size_t cell) { result = result || (operand_[cell] != kNone && operand_[cell] != operand); });
        return result;
    }

  private:
    static constexpr double kMostCells = 128.0;  ///< along a side: 8 MB
    static constexpr std::int32_t kNone = -1;
    static constexpr std::int32_t kSeveral = -2;

    int place(double x, int i) const {
        return std::clamp(static_cast<int>((x - box_.low[i]) * scale_[i]), 0, count_[i] - 1);
    }

    Box box_;
    std::array<int, 3> count_{};
    Vec3 scale_ = Vec3::Zero();
    std::vector<std::int32_t> operand_;
};

/// What is common to the boxes of two operands at least, each larger by `reach`.
Box common_box(const std::vector<Box>& boxes, double reach) {
    Box result;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = i + 1; k < boxes.size(); ++k) {
            const Box common{boxes[i].low.cwiseMax(boxes[k].low) - Vec3::Constant(reach),
                             boxes[i].high.cwiseMin(boxes[k].high) + Vec3::Constant(reach)};
            if ((common.low.array() <= common.high.array()).all()) {
                result.add(common);
            }
        }
    }
    return result;
}

/// Triangles near those of other operands: at least all that are within `reach` of one.
std::vector<std::int32_t> near_other_operands(const Soup& soup, double reach) {
    std::vector<Box> boxes(static_cast<std::size_t>(soup.operands));
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        boxes[static_cast<std::size_t>(soup.source[t].operand)].add(box_of(soup, t));
    }
    std::vector<std::int32_t> result;
    const Box common = common_box(boxes, reach);
    if (common.empty()) {
        return result;
    }
    OperandCells cells(common, reach, soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        cells.mark(box_of(soup, t), soup.source[t].operand);
    }
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const Box own = box_of(soup, t);
        const Box larger{own.low - Vec3::Constant(reach), own.high + Vec3::Constant(reach)};
        if (cells.has_other(larger, soup.source[t].operand)) {
            result.push_back(static_cast<std::int32_t>(t));
        }
    }
    return result;
}

}  // namespace

std::array<Vec3, 3> corners(const Soup& soup, std::int32_t t) {
    const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
    return {soup.vertices[static_cast<std::size_t>(c[0])], soup.vertices[static_cast<std::size_t>(c[1])],
            soup.vertices[static_cast<std::size_t>(c[2])]};
}

Box swept(const std::array<Vec3, 3>& q, double reach, double margin) {
    const Vec3 way = reach * (q[1] - q[0]).cross(q[2] - q[0]).normalized();
    Box box;
    for (const Vec3& x : q) {
        box.add(x + way);
        box.add(x - way);
    }
    return {box.low - Vec3::Constant(margin), box.high + Vec3::Constant(margin)};
}

FacingSearch::BoundingCircle::BoundingCircle(const std::array<Vec3, 3>& q)
    : middle((q[0] + q[1] + q[2]) / 3.0), axis((q[1] - q[0]).cross(q[2] - q[0]).normalized()) {
    for (const Vec3& x : q) {
        radius = std::max(radius, (x - middle).norm());
    }
}

bool FacingSearch::BoundingCircle::meets_column_of(const std::array<Vec3, 3>& p, double margin) const {
    const Vec3 way = (p[0] + p[1] + p[2]) / 3.0 - middle;
    const double aside = way.squaredNorm() - std::pow(way.dot(axis), 2);
    const Vec3 center = (p[0] + p[1] + p[2]) / 3.0;
    const double other = std::sqrt(
        std::max({(p[0] - center).squaredNorm(), (p[1] - center).squaredNorm(), (p[2] - center).squaredNorm()}));
    // An edge that is shifted by the margin shifts corners of the enlarged triangle farther; what is left out there
    // lies beside a corner.
    return aside <= std::pow(radius + other + 2.0 * margin, 2);
}

FacingSearch::FacingSearch(const Soup& soup, double reach) : soup_(soup), near_(near_other_operands(soup, reach)) {
    const auto operands = static_cast<std::size_t>(soup.operands);
    std::vector<std::vector<std::int32_t>> own(operands);
    for (const std::int32_t t : near_) {
        own[static_cast<std::size_t>(operand_of(soup, t))].push_back(t);
    }
    trees_.resize(operands);
    parallel_for(soup.operands, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        trees_[i] = std::make_unique<mesh::AabbTree>(soup.vertices, soup.triangles, own[i]);
    });
    earlier_.resize(operands);
    for (std::size_t i = 0; i < operands; ++i) {
        const Box box = trees_[i]->box();
        const Box larger{box.low - Vec3::Constant(reach), box.high + Vec3::Constant(reach)};
        for (std::size_t k = 0; k < i; ++k) {
            if (trees_[k]->size() > 0 && trees_[k]->box().meets(larger)) {
                earlier_[i].push_back(k);
            }
        }
    }
}

}  // namespace mq::boolean
