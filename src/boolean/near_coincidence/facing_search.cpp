// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/facing_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "mesh/intersection/vertex_grid.h"

namespace mq::boolean {

namespace {

/// A grid over the places where boxes of operands come near each other, which knows the operands in each cell.
class OperandCells {
  public:
    /// @param box  what the grid covers
    /// @param least  mm, the least side of a cell
    OperandCells(const Soup& soup, const Box& box, double least)
        : grid_(soup.vertices, box, counts(soup, box, least)), operand_(grid_.size(), kNone) {}

    void mark(const Triangle& t, std::int32_t operand) {
        all_ = all_ || !grid_.visit(t, kMostMarked, [&](std::size_t cell) {
            if (operand_[cell] == kNone) {
                operand_[cell] = operand;
                occupied_.push_back(cell);
            } else if (operand_[cell] != operand) {
                operand_[cell] = kSeveral;
            }
            return true;
        });
    }
    /// Once all are marked: finds the cells beside which, or in which, there are several operands.
    void find_near() {
        near_.assign(operand_.size(), 0);
        for (const std::size_t cell : occupied_) {
            const auto is_free = [&](std::size_t beside) {
                return operand_[beside] == kNone ||
                       (operand_[beside] == operand_[cell] && operand_[beside] != kSeveral);
            };
            near_[cell] = static_cast<char>(!grid_.visit_around(cell, is_free));
        }
    }
    /// False only if no triangle of another operand was marked within a cell's side of this one.
    bool is_near_other(const Triangle& t) const {
        return all_ || !grid_.visit(t, kMostAsked, [&](std::size_t cell) { return near_[cell] == 0; });
    }

  private:
    /// Cells of one triangle at most; larger triangles make the grid useless, or are near without being asked.
    static constexpr int kMostMarked = 32768;
    static constexpr int kMostAsked = 4096;
    static constexpr std::int32_t kNone = -1;
    static constexpr std::int32_t kSeveral = -2;

    /// About as many cells on a surface as it has triangles.
    static std::array<int, 3> counts(const Soup& soup, const Box& box, double least) {
        const double most =
            std::clamp(std::sqrt(static_cast<double>(soup.triangles.size())), 1.0, double(mesh::VertexGrid::kMost));
        std::array<int, 3> result;
        for (int i = 0; i < 3; ++i) {
            result[i] = std::max(1, static_cast<int>(std::min(most, (box.high[i] - box.low[i]) / least)));
        }
        return result;
    }

    mesh::VertexGrid grid_;
    std::vector<std::int32_t> operand_;  ///< by cell
    std::vector<std::size_t> occupied_;  ///< cells
    std::vector<char> near_;             ///< cells near others
    bool all_ = false;                   ///< whether everything may be near other operands
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
std::vector<std::int32_t> near_other_operands(const Soup& soup, const std::vector<Box>& boxes, double reach,
                                              const Progress& progress) {
    std::vector<std::int32_t> result;
    const Box common = common_box(boxes, reach);
    if (common.empty()) {
        return result;
    }
    CancelPace pace(progress);
    OperandCells cells(soup, common, reach);
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        pace.step();
        cells.mark(soup.triangles[t], soup.source[t].operand);
    }
    cells.find_near();
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        pace.step();
        if (cells.is_near_other(soup.triangles[t])) {
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

BoundingCircle::BoundingCircle(const std::array<Vec3, 3>& q)
    : middle((q[0] + q[1] + q[2]) / 3.0), axis((q[1] - q[0]).cross(q[2] - q[0]).normalized()) {
    for (const Vec3& x : q) {
        radius = std::max(radius, (x - middle).norm());
    }
}

FacingSearch::FacingSearch(const Soup& soup, const std::vector<Box>& boxes, double reach, const Progress& progress)
    : soup_(soup), near_(near_other_operands(soup, boxes, reach, progress)), operands_(boxes.size()) {
    for (const std::int32_t t : near_) {
        NearTriangles& own = operands_[static_cast<std::size_t>(operand_of(soup, t))];
        own.index.push_back(t);
        own.triangles.push_back(soup.triangles[static_cast<std::size_t>(t)]);
    }
    parallel_for(static_cast<int>(operands_.size()), [&](int k) {
        NearTriangles& own = operands_[static_cast<std::size_t>(k)];
        for (const std::int32_t t : own.index) {
            own.circles.emplace_back(corners(soup, t));
        }
        own.tree.emplace(soup.vertices, own.triangles);
    });
    for (std::size_t i = 0; i < operands_.size(); ++i) {
        const Box box = operands_[i].tree->box();
        const Box larger{box.low - Vec3::Constant(reach), box.high + Vec3::Constant(reach)};
        for (std::size_t k = 0; k < i; ++k) {
            if (operands_[k].tree->size() > 0 && operands_[k].tree->box().meets(larger)) {
                operands_[i].earlier.push_back(k);
            }
        }
    }
}

}  // namespace mq::boolean
