// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/thin_shells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/disjoint_sets.h"

namespace mq::boolean {

std::size_t remove_thin_shells(ResultMesh& draft, const Soup& soup, const std::vector<char>& in_contact,
                               const ShellThickness& thickness) {
    DisjointSets<std::int32_t> sets(draft.vertices.size());  // shells share no vertex
    for (const Triangle& t : draft.triangles) {
        sets.unite(t[0], t[1]);
        sets.unite(t[0], t[2]);
    }
    std::int32_t count = 0;
    const std::vector<std::int32_t> shell_of = sets.number(count);
    struct Shell {
        double area = 0.0;
        double volume = 0.0;
        bool in_contact = false;
        std::int32_t operand = -1;  ///< operand of a piece
        bool of_several = false;
        bool made = false;  ///< a triangle is no operand's own

        bool is_too_thin(const ShellThickness& thickness) const {
            const double limit = std::max(in_contact && of_several ? thickness.of_gaps : 0.0,  //
                                          made ? thickness.of_any : 0.0);
            return 2.0 * std::abs(volume) < limit * area;
        }
    };
    std::vector<Shell> shells(static_cast<std::size_t>(count));
    std::vector<Vec3> corner(shells.size());  // volumes are added up about a vertex of each shell
    for (const Triangle& t : draft.triangles) {
        corner[static_cast<std::size_t>(shell_of[static_cast<std::size_t>(t[0])])] =
            draft.vertices[static_cast<std::size_t>(t[0])];
    }
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const Triangle& c = draft.triangles[t];
        const auto index = static_cast<std::size_t>(shell_of[static_cast<std::size_t>(c[0])]);
        Shell& shell = shells[index];
        const Vec3 a = draft.vertices[static_cast<std::size_t>(c[0])] - corner[index];
        const Vec3 b = draft.vertices[static_cast<std::size_t>(c[1])] - corner[index];
        const Vec3 d = draft.vertices[static_cast<std::size_t>(c[2])] - corner[index];
        shell.area += 0.5 * (b - a).cross(d - a).norm();
        shell.volume += a.dot(b.cross(d)) / 6.0;
        const auto from = static_cast<std::size_t>(draft.from[t]);
        const std::int32_t operand = soup.source[from].operand;
        shell.in_contact = shell.in_contact || (!in_contact.empty() && in_contact[from] != 0);
        shell.made = shell.made || draft.source[t].operand < 0;
        shell.of_several = shell.of_several || (shell.operand >= 0 && shell.operand != operand);
        shell.operand = operand;
    }
    std::vector<char> thin(draft.triangles.size(), 0);
    std::size_t removed = 0;
    for (std::size_t t = 0; t < thin.size(); ++t) {
        const auto first = static_cast<std::size_t>(draft.triangles[t][0]);
        thin[t] = static_cast<char>(shells[static_cast<std::size_t>(shell_of[first])].is_too_thin(thickness));
        removed += static_cast<std::size_t>(thin[t]);
    }
    if (removed > 0) {
        remove_triangles(draft, thin);
    }
    return removed;
}

}  // namespace mq::boolean
