// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/solid_contacts.h"

#include <algorithm>
#include <map>
#include <set>

#include "mesh/quality/exemptions.h"

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

std::string solids_of(const std::vector<std::pair<int, int>>& faces, const geometry::Topology& topology) {
    std::vector<std::set<int>> solids(topology.faces.size());
    for (const geometry::Volume& volume : topology.volumes) {
        for (const geometry::Volume::Side& side : volume.sides) {
            solids[static_cast<std::size_t>(side.face)].insert(volume.solid);
        }
    }
    std::set<std::pair<int, int>> pairs;
    for (const auto& [a, b] : faces) {
        for (const int one : solids[static_cast<std::size_t>(a)]) {
            for (const int other : solids[static_cast<std::size_t>(b)]) {
                if (one >= 0 && other >= 0 && one != other) {
                    pairs.insert(std::minmax(one, other));
                }
            }
        }
    }
    std::vector<std::string> names;
    for (const auto& [a, b] : pairs) {
        names.push_back("Solid" + std::to_string(a + 1) + " and Solid" + std::to_string(b + 1));
    }
    return mesh::list_of(names);
}

}  // namespace mq::triangulate
