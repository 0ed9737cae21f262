// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/solid_contacts.h"

#include <algorithm>
#include <map>

namespace mq::triangulate {

namespace {

double area_of(const mesh::TriangleMesh& mesh, std::size_t triangle) {
    const mesh::Triangle& t = mesh.triangles[triangle];
    const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
    return 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
}

}  // namespace

void pair_opposite_triangles(mesh::TriangleMesh& mesh, const std::vector<int>& source) {
    if (source.empty()) {
        return;
    }
    std::vector<std::int32_t> first(static_cast<std::size_t>(*std::max_element(source.begin(), source.end())) + 1, -1);
    for (std::size_t i = 0; i < source.size(); ++i) {
        std::int32_t& other = first[static_cast<std::size_t>(source[i])];
        if (other < 0) {
            other = static_cast<std::int32_t>(i);
            continue;
        }
        mesh.triangle_opposite.resize(source.size(), -1);
        mesh.triangle_opposite[i] = other;
        mesh.triangle_opposite[static_cast<std::size_t>(other)] = static_cast<std::int32_t>(i);
    }
}

std::vector<mesh::SolidContact> solid_contacts(const mesh::TriangleMesh& mesh) {
    std::map<std::array<std::int32_t, 2>, mesh::SolidContact> found;
    for (std::size_t i = 0; i < mesh.triangle_opposite.size(); ++i) {
        const std::int32_t other = mesh.triangle_opposite[i];
        if (other < static_cast<std::int32_t>(i)) {
            continue;  // none, or counted from its other side
        }
        std::array<std::int32_t, 2> solids{mesh.triangle_solid[i],
                                           mesh.triangle_solid[static_cast<std::size_t>(other)]};
        std::sort(solids.begin(), solids.end());
        mesh::SolidContact& contact = found[solids];
        contact.solids = solids;
        ++contact.triangles;
        contact.area += area_of(mesh, i);
    }
    std::vector<mesh::SolidContact> result;
    for (const auto& entry : found) {
        result.push_back(entry.second);
    }
    return result;
}

}  // namespace mq::triangulate
