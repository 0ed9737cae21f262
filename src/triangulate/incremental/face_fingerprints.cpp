// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/face_fingerprints.h"

#include <map>

namespace mq::triangulate {

namespace {

// Numbers entities in the order in which they occur first, so that the numbering within the shape has no effect.
int local_number(std::map<int, int>& numbers, int index) {
    return numbers.emplace(index, static_cast<int>(numbers.size())).first->second;
}

void add_edge_use(geometry::Model& model, int u, geometry::Fingerprint& key) {
    const geometry::EdgeUse& use = model.topology().uses[u];
    const geometry::Edge& edge = model.topology().edges[use.edge];
    geometry::add_to(key, (use.forward ? 1 : 0) + (use.internal ? 2 : 0) + (edge.degenerate ? 4 : 0));
    geometry::add_to(key, edge.t0);
    geometry::add_to(key, edge.t1);
    geometry::add_to(key, edge.tolerance);
    model.add_definition({1, use.edge}, key);
    model.add_definition_of_use(u, key);
}

geometry::Fingerprint key_of_face(geometry::Model& model, int f) {
    const geometry::Topology& topology = model.topology();
    const geometry::Face& face = topology.faces[f];
    geometry::Fingerprint key{};
    geometry::add_to(key, (face.reversed ? 1 : 0) + (face.no_area ? 2 : 0));
    geometry::add_to(key, face.tolerance);
    for (std::size_t k = 0; k < 2; ++k) {
        geometry::add_to(key, face.low[k]);
        geometry::add_to(key, face.high[k]);
        geometry::add_to(key, face.period[k]);
    }
    model.add_definition({2, f}, key);
    geometry::add_to(key, static_cast<int>(face.points.size()));
    for (const int n : face.points) {
        model.add_definition({0, n}, key);
    }
    std::map<int, int> edges;
    std::map<int, int> nodes;
    for (const geometry::Loop& loop : face.loops) {
        geometry::add_to(key, static_cast<int>(loop.uses.size()));
        for (const int u : loop.uses) {
            const int e = topology.uses[u].edge;
            geometry::add_to(key, local_number(edges, e));
            add_edge_use(model, u, key);
            for (const int n : topology.edges[e].nodes) {
                geometry::add_to(key, n < 0 ? -1 : local_number(nodes, n));
                if (n >= 0) {
                    geometry::add_to(key, topology.nodes[n].tolerance);
                    model.add_definition({0, n}, key);
                }
            }
        }
    }
    return key;
}

void add_motion(const geometry::RigidMotion& motion, geometry::Fingerprint& key) {
    for (int i = 0; i < 3; ++i) {
        geometry::add_to(key, Vec3(motion.turn.col(i)));
    }
    geometry::add_to(key, motion.shift);
}

}  // namespace

std::vector<int> uses_in_order(const geometry::Face& face) {
    std::vector<int> uses;
    for (const geometry::Loop& loop : face.loops) {
        uses.insert(uses.end(), loop.uses.begin(), loop.uses.end());
    }
    return uses;
}

std::vector<geometry::Fingerprint> face_fingerprints(geometry::Session& session) {
    std::vector<geometry::Fingerprint> keys(session.topology().faces.size());
    for (int f = 0; f < static_cast<int>(keys.size()); ++f) {
        session.run([&](geometry::Model& model) { keys[f] = key_of_face(model, f); });
    }
    return keys;
}

void add_structure(geometry::Session& session, geometry::Fingerprint& key) {
    const geometry::Topology& topology = session.topology();
    add_motion(session.place(), key);
    geometry::add_to(key, topology.box.low);
    geometry::add_to(key, topology.box.high);
    geometry::add_to(key, static_cast<int>(topology.nodes.size()));
    for (const geometry::Edge& edge : topology.edges) {
        geometry::add_to(key, edge.nodes[0]);
        geometry::add_to(key, edge.nodes[1]);
    }
    for (const geometry::EdgeUse& use : topology.uses) {
        geometry::add_to(key, use.edge);
        geometry::add_to(key, use.face);
    }
    for (const geometry::Volume& volume : topology.volumes) {
        geometry::add_to(key, static_cast<int>(volume.kind));
        for (const geometry::Volume::Side& side : volume.sides) {
            geometry::add_to(key, side.flipped ? -side.face : side.face + 1);
        }
    }
}

}  // namespace mq::triangulate
