// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/joined_corners.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

using geometry::Entity;
using geometry::Joined;

JoinedCorners::JoinedCorners(const Workspace& work, const EdgeDiscretisation& chains) : work_(work) {
    const geometry::Topology& topology = work.session.topology();
    const auto place_of = [&](int node) {
        return chains.vertices()[static_cast<std::size_t>(chains.vertex_of_node(topology.node_of(node)))].entity.index;
    };
    std::vector<Joined> all = topology.joined;
    const std::set<int> contracted(chains.contracted().begin(), chains.contracted().end());
    for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
        const geometry::Edge& edge = topology.edges[static_cast<std::size_t>(e)];
        const auto [a, b] = edge.nodes;
        if (chains.chain(e).collapsed && !edge.degenerate && !edge.uses.empty() && a >= 0 && b >= 0 && a != b) {
            const double distance =
                (topology.nodes[static_cast<std::size_t>(a)].point - topology.nodes[static_cast<std::size_t>(b)].point)
                    .norm();
            all.push_back({{Entity{0, a}, Entity{0, b}}, distance, contracted.count(e) == 0});
        }
    }
    for (const Joined& joined : all) {
        std::set<int> places;
        for (const Entity& entity : joined.entities) {
            const auto& nodes =
                topology.edges[static_cast<std::size_t>(entity.dimension == 1 ? entity.index : 0)].nodes;
            for (const int node : entity.dimension == 1 ? nodes : std::array<int, 2>{entity.index, -1}) {
                if (node >= 0) {
                    places.insert(place_of(node));
                }
            }
        }
        for (const int place : places) {
            joined_[place].push_back(joined);
        }
    }
    if (joined_.empty()) {
        return;
    }
    for (int node = 0; node < static_cast<int>(topology.nodes.size()); ++node) {
        if (const int place = place_of(node); joined_.count(place) > 0) {
            nodes_[place].insert(node);
        }
    }
    for (const geometry::EdgeUse& use : topology.uses) {
        for (const int node : topology.edges[static_cast<std::size_t>(use.edge)].nodes) {
            if (const int place = node < 0 ? -1 : place_of(node); joined_.count(place) > 0) {
                faces_[place].insert(use.face);
            }
        }
    }
}

std::optional<JoinedCorners::Found> JoinedCorners::at(int vertex, std::vector<int> faces) {
    const mesh::VertexEntity& entity = work_.mesh.vertex(vertex).entity;
    const auto joined = entity[0] == 0 ? joined_.find(entity[1]) : joined_.end();
    if (joined == joined_.end()) {
        return std::nullopt;
    }
    const int place = joined->first;
    if (faces.empty()) {
        faces.assign(faces_[place].begin(), faces_[place].end());
    }
    double own = M_PI;
    for (const int face : faces) {
        for (const int node : nodes_[place]) {
            own = std::min(own, own_corner(face, node));
        }
    }
    const auto farther = [](const Joined& a, const Joined& b) {
        return std::tuple(!a.by_shape, a.distance) < std::tuple(!b.by_shape, b.distance);
    };
    return Found{*std::max_element(joined->second.begin(), joined->second.end(), farther), own};
}

const JoinedCorners::Meeting* JoinedCorners::narrowest(int vertex) {
    if (!meetings_) {
        meetings_.emplace();
        for (int s = 0; s < work_.mesh.segment_count(); ++s) {
            for (int end = 0; end < 2; ++end) {
                const int v = work_.mesh.segment(s).vertices[end];
                const mesh::VertexEntity& entity = work_.mesh.vertex(v).entity;
                if (work_.mesh.segment(s).uses.empty() || entity[0] != 0 || joined_.count(entity[1]) == 0) {
                    continue;
                }
                const NarrowCorner corner = narrowest_corner(work_.mesh, s, end);
                const auto [known, first] = meetings_->try_emplace(v, Meeting{corner.angle, {s, corner.segment}});
                if (!first && corner.angle < known->second.angle) {
                    known->second = {corner.angle, {s, corner.segment}};
                }
            }
        }
    }
    const auto found = meetings_->find(vertex);
    return found != meetings_->end() && found->second.segments[1] >= 0 ? &found->second : nullptr;
}

double JoinedCorners::own_corner(int face, int node) {
    const auto known = corners_.find({face, node});
    if (known != corners_.end()) {
        return known->second;
    }
    std::optional<double> angle;
    work_.session.run([&](geometry::Model& model) { angle = model.corner_angle(face, node); });
    return corners_[{face, node}] = angle.value_or(M_PI);
}

}  // namespace mq::triangulate
