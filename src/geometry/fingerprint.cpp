// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/fingerprint.h"

#include <cstring>
#include <map>

namespace mq::geometry {

namespace {

// Equal steps, on every edge and along u and v on every face.
constexpr int kStepsOfEdge = 8;
constexpr int kStepsOfFace = 4;

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the result depends on all bits of `x`.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
}

void add_vector(Fingerprint& fingerprint, const Vec3& v) {
    for (int i = 0; i < 3; ++i) {
        add_to(fingerprint, v[i]);
    }
}

void add_number(Fingerprint& fingerprint, int number) {
    add_to(fingerprint, static_cast<std::uint64_t>(static_cast<std::int64_t>(number)));
}

// By the order in which they are met first: numbers within the part do not count.
int local_number(std::map<int, int>& numbers, int index) {
    return numbers.emplace(index, static_cast<int>(numbers.size())).first->second;
}

void add_face(Fingerprint& print, const Topology& topology, const Face& face) {
    add_number(print, face.reversed ? 1 : 0);
    add_number(print, face.no_area ? 1 : 0);
    add_to(print, face.tolerance);
    for (std::size_t k = 0; k < 2; ++k) {
        add_to(print, face.low[k]);
        add_to(print, face.high[k]);
        add_to(print, face.period[k]);
    }
    std::map<int, int> edges;
    std::map<int, int> nodes;
    for (const Loop& loop : face.loops) {
        add_number(print, static_cast<int>(loop.uses.size()));
        for (const int u : loop.uses) {
            const EdgeUse& use = topology.uses[u];
            const Edge& edge = topology.edges[use.edge];
            add_number(print, local_number(edges, use.edge));
            add_number(print, (use.forward ? 1 : 0) + (use.internal ? 2 : 0) + (edge.degenerate ? 4 : 0));
            add_to(print, edge.t0);
            add_to(print, edge.t1);
            add_to(print, edge.tolerance);
            for (const int n : edge.nodes) {
                add_number(print, n < 0 ? -1 : local_number(nodes, n));
                if (n >= 0) {
                    add_vector(print, topology.nodes[n].point);
                    add_to(print, topology.nodes[n].tolerance);
                }
            }
        }
    }
}

void ask_about(const Topology& topology, int f, Engine::Batch& batch) {
    const Face& face = topology.faces[f];
    for (const int u : uses_in_order(face)) {
        const Edge& edge = topology.edges[topology.uses[u].edge];
        for (int i = 0; i <= kStepsOfEdge; ++i) {
            const double t = i == kStepsOfEdge ? edge.t1 : edge.t0 + (edge.t1 - edge.t0) * i / kStepsOfEdge;
            batch.push_back(Query::use_on_face(u, t));
            if (!edge.degenerate) {
                batch.push_back(Query::edge_point(topology.uses[u].edge, t));
            }
        }
    }
    for (int i = 0; i <= kStepsOfFace; ++i) {
        for (int j = 0; j <= kStepsOfFace; ++j) {
            batch.push_back(Query::face_point(f, face.low[0] + (face.high[0] - face.low[0]) * i / kStepsOfFace,
                                              face.low[1] + (face.high[1] - face.low[1]) * j / kStepsOfFace));
        }
    }
}

}  // namespace

void add_to(Fingerprint& fingerprint, std::uint64_t number) {
    fingerprint[0] = mixed(fingerprint[0] + 0x9E3779B97F4A7C15ULL + number);
    fingerprint[1] = mixed((fingerprint[1] ^ number) * 0xD6E8FEB86659FD93ULL + 1);
}

void add_to(Fingerprint& fingerprint, double number) {
    const double unsigned_zero = number + 0.0;  // equal numbers have equal bits
    std::uint64_t bits = 0;
    std::memcpy(&bits, &unsigned_zero, sizeof bits);
    add_to(fingerprint, bits);
}

std::vector<int> uses_in_order(const Face& face) {
    std::vector<int> uses;
    for (const Loop& loop : face.loops) {
        uses.insert(uses.end(), loop.uses.begin(), loop.uses.end());
    }
    return uses;
}

std::vector<Fingerprint> fingerprints_of_faces(Session& session) {
    const Topology& topology = session.topology();
    std::vector<Fingerprint> prints(topology.faces.size(), Fingerprint{});
    for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
        Fingerprint& print = prints[f];
        add_face(print, topology, topology.faces[f]);
        Engine::Batch batch;
        ask_about(topology, f, batch);
        for (const Answer& answer : session.ask(std::move(batch))) {
            add_number(print, static_cast<int>(answer.status));
            add_to(print, answer.u);
            add_to(print, answer.v);
            add_vector(print, answer.point);
            add_vector(print, answer.normal);
        }
    }
    return prints;
}

}  // namespace mq::geometry
