// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "base/progress.h"
#include "base/sizes/size_field.h"
#include "tetrahedralise/cells/delaunay.h"
#include "tetrahedralise/cells/tetrahedralisation.h"

namespace mq::tetrahedralise {

/// Puts points inside by Delaunay refinement: at circumcentres of cells that are large for the length wanted there,
/// which grows from the edges of the surface inwards.
class InteriorPoints {
  public:
    /// @param growth of the wanted length by the distance from the surface
    /// @param field bounds the wanted length; null: none
    InteriorPoints(Tetrahedralisation& mesh, const std::vector<std::array<int, 3>>& surface, double growth,
                   const SizeField* field = nullptr);

    /// @throws Cancelled
    void insert(const Progress& progress);

  private:
    /// A cell that may be too large, by its corners: numbers of cells are used again.
    struct Candidate {
        double ratio;
        int cell;
        std::array<int, 4> v;
        bool operator<(const Candidate& other) const {
            return ratio != other.ratio ? ratio < other.ratio : v < other.v;
        }
    };

    void consider(int cell);
    bool try_point(const Vec3& p, int cell);
    double length_at(const Vec3& p, const std::vector<int>& around) const;
    bool is_far_enough(const Vec3& p, double length) const;

    Tetrahedralisation& mesh_;
    double growth_;
    const SizeField* field_;
    std::vector<double> length_;  // by vertex: length wanted there, mm
    std::vector<Candidate> queue_;
    Locator locator_;
    CavityInsertion insertion_;
};

}  // namespace mq::tetrahedralise
