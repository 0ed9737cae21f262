// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/face_definition.h"

namespace mq::geometry {

namespace {

void add_edge_use(Model& model, int u, int frame, Fingerprint& key) {
    const EdgeUse& use = model.topology().uses[static_cast<std::size_t>(u)];
    const Edge& edge = model.topology().edges[static_cast<std::size_t>(use.edge)];
    add_to(key, (use.forward ? 1 : 0) + (use.internal ? 2 : 0) + (edge.degenerate ? 4 : 0));
    add_to(key, edge.t0);
    add_to(key, edge.t1);
    add_to(key, edge.tolerance);
    model.add_definition({1, use.edge}, frame, key);
    model.add_definition_of_use(u, key);
}

void add_node(Model& model, int n, int frame, LocalNumbers& numbers, Fingerprint& key) {
    add_to(key, numbers.of({0, n}));
    add_to(key, model.topology().nodes[static_cast<std::size_t>(n)].tolerance);
    model.add_definition({0, n}, frame, key);
}

}  // namespace

void add_face_definition(Model& model, int f, int frame, LocalNumbers& numbers, Fingerprint& key) {
    const Topology& topology = model.topology();
    const Face& face = topology.faces[static_cast<std::size_t>(f)];
    add_to(key, (face.reversed ? 1 : 0) + (face.no_area ? 2 : 0));
    add_to(key, face.tolerance);
    for (std::size_t k = 0; k < 2; ++k) {
        add_to(key, face.low[k]);
        add_to(key, face.high[k]);
        add_to(key, face.period[k]);
    }
    model.add_definition({2, f}, frame, key);
    add_to(key, static_cast<int>(face.points.size()));
    for (const int n : face.points) {
        add_node(model, n, frame, numbers, key);
    }
    for (const Loop& loop : face.loops) {
        add_to(key, static_cast<int>(loop.uses.size()));
        for (const int u : loop.uses) {
            const int e = topology.uses[static_cast<std::size_t>(u)].edge;
            add_to(key, numbers.of({1, e}));
            add_edge_use(model, u, frame, key);
            for (const int n : topology.edges[static_cast<std::size_t>(e)].nodes) {
                if (n < 0) {
                    add_to(key, -1);
                } else {
                    add_node(model, n, frame, numbers, key);
                }
            }
        }
    }
}

std::vector<int> uses_in_order(const Face& face) {
    std::vector<int> uses;
    for (const Loop& loop : face.loops) {
        uses.insert(uses.end(), loop.uses.begin(), loop.uses.end());
    }
    return uses;
}

}  // namespace mq::geometry
