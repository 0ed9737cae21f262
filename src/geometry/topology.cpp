// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/topology.h"

namespace mq::geometry {

std::string name_of(Entity entity) {
    // FreeCAD's names of sub-elements, by dimension.
    static constexpr std::array<const char*, 3> kKinds{"Vertex", "Edge", "Face"};
    if (entity.dimension < 0 || entity.dimension > 2 || entity.index < 0) {
        return "(no entity)";
    }
    return kKinds[static_cast<std::size_t>(entity.dimension)] + std::to_string(entity.index + 1);
}

std::size_t Topology::own_count(int dimension) const {
    const std::size_t counts[3] = {nodes.size(), edges.size(), faces.size()};
    const auto d = static_cast<std::size_t>(dimension);
    return counts[d] - parts_of[d].size();
}

Entity Topology::of_shape(Entity entity) const {
    if (entity.dimension < 0 || entity.dimension > 2 || entity.index < 0) {
        return entity;
    }
    const std::size_t own = own_count(entity.dimension);
    const auto index = static_cast<std::size_t>(entity.index);
    return index < own ? entity : parts_of[static_cast<std::size_t>(entity.dimension)][index - own];
}

std::vector<int> Topology::pieces_of(Entity entity) const {
    std::vector<int> pieces{entity.index};
    const std::vector<Entity>& parts = parts_of[static_cast<std::size_t>(entity.dimension)];
    const int own = static_cast<int>(own_count(entity.dimension));
    for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
        if (parts[static_cast<std::size_t>(i)] == entity) {
            pieces.push_back(own + i);
        }
    }
    for (int f = 0; entity.dimension == 2 && f < static_cast<int>(faces.size()); ++f) {
        if (faces[static_cast<std::size_t>(f)].behind == entity.index) {
            pieces.push_back(f);
        }
    }
    return pieces;
}

std::set<int> Topology::edges_of(int face) const {
    std::set<int> around;
    for (const Loop& loop : faces[static_cast<std::size_t>(face)].loops) {
        for (const int u : loop.uses) {
            around.insert(uses[static_cast<std::size_t>(u)].edge);
        }
    }
    return around;
}

std::string Topology::name_of(Entity entity) const {
    const Entity whole = of_shape(entity);
    const std::string name = geometry::name_of(whole);
    if (whole.dimension == entity.dimension) {
        return name;
    }
    return (entity.dimension == 1 ? "a crease of " : "the end of a crease on ") + name;
}

}  // namespace mq::geometry
