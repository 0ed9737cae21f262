// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/face_keys.h"

#include <map>

namespace mq::geometry {

namespace {

// By the order in which they are met first: numbers within the part do not count.
int local_number(std::map<int, int>& numbers, int index) {
    return numbers.emplace(index, static_cast<int>(numbers.size())).first->second;
}

void add_edge_use(Model& model, int u, Fingerprint& key) {
    const EdgeUse& use = model.topology().uses[u];
    const Edge& edge = model.topology().edges[use.edge];
    add_to(key, (use.forward ? 1 : 0) + (use.internal ? 2 : 0) + (edge.degenerate ? 4 : 0));
    add_to(key, edge.t0);
    add_to(key, edge.t1);
    add_to(key, edge.tolerance);
    model.add_definition({1, use.edge}, key);
    model.add_definition_of_use(u, key);
}

Fingerprint key_of_face(Model& model, int f) {
    const Topology& topology = model.topology();
    const Face& face = topology.faces[f];
    Fingerprint key{};
    add_to(key, (face.reversed ? 1 : 0) + (face.no_area ? 2 : 0));
    add_to(key, face.tolerance);
    for (std::size_t k = 0; k < 2; ++k) {
        add_to(key, face.low[k]);
        add_to(key, face.high[k]);
        add_to(key, face.period[k]);
    }
    model.add_definition({2, f}, key);
    add_to(key, static_cast<int>(face.points.size()));
    for (const int n : face.points) {
        model.add_definition({0, n}, key);
    }
    std::map<int, int> edges;
    std::map<int, int> nodes;
    for (const Loop& loop : face.loops) {
        add_to(key, static_cast<int>(loop.uses.size()));
        for (const int u : loop.uses) {
            const int e = topology.uses[u].edge;
            add_to(key, local_number(edges, e));
            add_edge_use(model, u, key);
            for (const int n : topology.edges[e].nodes) {
                add_to(key, n < 0 ? -1 : local_number(nodes, n));
                if (n >= 0) {
                    add_to(key, topology.nodes[n].tolerance);
                    model.add_definition({0, n}, key);
                }
            }
        }
    }
    return key;
}

void add_motion(const Motion& motion, Fingerprint& key) {
    for (int i = 0; i < 3; ++i) {
        add_to(key, Vec3(motion.turn.col(i)));
    }
    add_to(key, motion.shift);
}

}  // namespace

std::vector<int> uses_in_order(const Face& face) {
    std::vector<int> uses;
    for (const Loop& loop : face.loops) {
        uses.insert(uses.end(), loop.uses.begin(), loop.uses.end());
    }
    return uses;
}

std::vector<Fingerprint> keys_of_faces(Session& session) {
    std::vector<Fingerprint> keys(session.topology().faces.size());
    for (int f = 0; f < static_cast<int>(keys.size()); ++f) {
        session.run([&](Model& model) { keys[f] = key_of_face(model, f); });
    }
    return keys;
}

void add_structure(Session& session, Fingerprint& key) {
    const Topology& topology = session.topology();
    add_motion(session.place(), key);
    add_to(key, topology.box.low);
    add_to(key, topology.box.high);
    add_to(key, static_cast<int>(topology.nodes.size()));
    for (const Edge& edge : topology.edges) {
        add_to(key, edge.nodes[0]);
        add_to(key, edge.nodes[1]);
    }
    for (const EdgeUse& use : topology.uses) {
        add_to(key, use.edge);
        add_to(key, use.face);
    }
    for (const Volume& volume : topology.volumes) {
        add_to(key, static_cast<int>(volume.kind));
        for (const Volume::Side& side : volume.sides) {
            add_to(key, side.flipped ? -side.face : side.face + 1);
        }
    }
}

}  // namespace mq::geometry
