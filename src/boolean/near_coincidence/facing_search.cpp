// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/facing_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace mq::boolean {

namespace {

/// A grid over the places where boxes of operands come near each other, which knows the operands in each cell.
class OperandCells {
  public:
    /// @param box  what the grid covers
    /// @param least  mm, the least side of a cell
    OperandCells(const Soup& soup, const Box& box, double least) : cell_(soup.vertices.size()) {
        // About as many cells on a surface as it has triangles.
        const double most = std::clamp(std::sqrt(static_cast<double>(soup.triangles.size())), 1.0, kMostCells);
        Vec3 scale;
        std::array<double, 3> last;
        for (int i = 0; i < 3; ++i) {
            const double side = box.high[i] - box.low[i];
            const int count = std::max(1, static_cast<int>(std::min(most, side / least)));
            scale[i] = side > 0.0 ? count / side : 0.0;
            last[i] = count;
            side_[i] = count + 2;
        }
        // Cells 0 and count + 1 take what is outside of the box. The cell of a coordinate is a monotone function of it,
        // however it is rounded.
        for (std::size_t v = 0; v < cell_.size(); ++v) {
            for (int i = 0; i < 3; ++i) {
                const double x = soup.vertices[v][i];
                const double inside = 1.0 + std::min((x - box.low[i]) * scale[i], last[i] - 1.0);
                cell_[v][i] = static_cast<std::uint8_t>(x < box.low[i]    ? 0.0
                                                        : x > box.high[i] ? last[i] + 1.0
                                                                          : inside);
            }
        }
        operand_.assign(static_cast<std::size_t>(side_[0]) * side_[1] * side_[2], kNone);
    }

    void mark(const Triangle& t, std::int32_t operand) {
        all_ = all_ || !visit(t, kMostMarked, [&](std::size_t cell) {
                   if (operand_[cell] == kNone) {
                       operand_[cell] = operand;
                       occupied_.push_back(static_cast<std::int32_t>(cell));
                   } else if (operand_[cell] != operand) {
                       operand_[cell] = kSeveral;
                   }
                   return true;
               });
    }
    /// Once all are marked: finds the cells beside which, or in which, there are several operands.
    void find_near() {
        near_.assign(operand_.size(), 0);
        for (const std::int32_t cell : occupied_) {
            const std::array<int, 3> at{cell % side_[0], cell / side_[0] % side_[1], cell / side_[0] / side_[1]};
            near_[static_cast<std::size_t>(cell)] = static_cast<char>(!visit_between(
                {std::max(at[0] - 1, 0), std::max(at[1] - 1, 0), std::max(at[2] - 1, 0)},
                {std::min(at[0] + 1, side_[0] - 1), std::min(at[1] + 1, side_[1] - 1),
                 std::min(at[2] + 1, side_[2] - 1)},
                [&](std::size_t beside) {
                    return operand_[beside] == kNone || (operand_[beside] == operand_[static_cast<std::size_t>(cell)] &&
                                                         operand_[beside] != kSeveral);
                }));
        }
    }
    /// False only if no triangle of another operand was marked within a cell's side of this one.
    bool is_near_other(const Triangle& t) const {
        return all_ || !visit(t, kMostAsked, [&](std::size_t cell) { return near_[cell] == 0; });
    }

  private:
    static constexpr double kMostCells = 126.0;  ///< inside, along a side: 10 MB
    /// Cells of one triangle at most; larger triangles make the grid useless, or are near without being asked.
    static constexpr int kMostMarked = 32768;
    static constexpr int kMostAsked = 4096;
    static constexpr std::int32_t kNone = -1;
    static constexpr std::int32_t kSeveral = -2;

    /// use(cell) for each cell of the box of a triangle. False when that has too many, or as soon as `use` says so.
    /// Boxes outside of the grid have no cells.
    template <typename Use>
    bool visit(const Triangle& t, int most, const Use& use) const {
        std::array<int, 3> low;
        std::array<int, 3> high;
        for (int i = 0; i < 3; ++i) {
            const auto [least, greatest] = std::minmax({cell_[t[0]][i], cell_[t[1]][i], cell_[t[2]][i]});
            low[i] = least;
            high[i] = greatest;
            if (greatest == 0 || least == side_[i] - 1) {
                return true;
            }
        }
        if ((high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1) > most) {
            return false;
        }
        return visit_between(low, high, use);
    }
    template <typename Use>
    bool visit_between(const std::array<int, 3>& low, const std::array<int, 3>& high, const Use& use) const {
        for (int z = low[2]; z <= high[2]; ++z) {
            for (int y = low[1]; y <= high[1]; ++y) {
                for (int x = low[0]; x <= high[0]; ++x) {
                    if (!use((static_cast<std::size_t>(z) * side_[1] + y) * side_[0] + x)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    std::vector<std::array<std::uint8_t, 3>> cell_;  ///< by vertex
    std::array<int, 3> side_{};
    std::vector<std::int32_t> operand_;
    std::vector<std::int32_t> occupied_;  ///< cells
    std::vector<char> near_;              ///< cells near others
    bool all_ = false;                    ///< whether everything may be near other operands
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
