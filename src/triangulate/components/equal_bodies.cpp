// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/equal_bodies.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/face_definition.h"

namespace mq::triangulate {

namespace {

using geometry::add_to;
using geometry::Fingerprint;
using geometry::Topology;
using Faces = std::vector<int>;

// Whether a body has a node or an edge in common with another one: its entities are not its own.
std::vector<char> that_share(const Topology& topology, const std::vector<Faces>& bodies) {
    std::vector<int> body_of_node(topology.nodes.size(), -1);
    std::vector<int> body_of_edge(topology.edges.size(), -1);
    std::vector<char> result(bodies.size(), 0);
    const auto see = [&](int& known, int body) {
        if (known >= 0 && known != body) {
            result[static_cast<std::size_t>(known)] = result[static_cast<std::size_t>(body)] = 1;
        }
        known = body;
    };
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        for (const int f : bodies[static_cast<std::size_t>(b)]) {
            const geometry::Face& face = topology.faces[static_cast<std::size_t>(f)];
            for (const int n : face.points) {
                see(body_of_node[static_cast<std::size_t>(n)], b);
            }
            for (const int e : topology.edges_of(f)) {
                see(body_of_edge[static_cast<std::size_t>(e)], b);
                for (const int n : topology.edges[static_cast<std::size_t>(e)].nodes) {
                    if (n >= 0) {
                        see(body_of_node[static_cast<std::size_t>(n)], b);
                    }
                }
            }
        }
    }
    return result;
}

// Data that are quickly compared: bodies that differ in them are not equal.
Fingerprint outline_of(const Topology& topology, const Faces& faces) {
    Fingerprint key{};
    for (const int f : faces) {
        const geometry::Face& face = topology.faces[static_cast<std::size_t>(f)];
        add_to(key, static_cast<int>(uses_in_order(face).size()));
        for (std::size_t k = 0; k < 2; ++k) {
            add_to(key, face.low[k]);
            add_to(key, face.high[k]);
        }
    }
    return key;
}

/// Computes fingerprints of all that defines a body.
class BodyFingerprints {
  public:
    using AddMore = std::function<void(geometry::Entity, Fingerprint&)>;

    BodyFingerprints(const Topology& topology, const AddMore& add_more)
        : topology_(topology), add_more_(add_more), sides_(topology.faces.size()) {
        for (std::size_t v = 0; v < topology.volumes.size(); ++v) {
            for (const geometry::Volume::Side& side : topology.volumes[v].sides) {
                sides_[static_cast<std::size_t>(side.face)].emplace_back(static_cast<int>(v), side.flipped);
            }
        }
    }

    Fingerprint of(geometry::Model& model, const Faces& faces, BodyEntities& entities) const {
        Fingerprint key{};
        geometry::LocalNumbers numbers;
        std::map<int, int> volumes;
        std::map<int, int> wholes;  // faces of the shape of which the body has pieces
        const auto number_in = [](std::map<int, int>& numbered, int index) {
            return numbered.emplace(index, static_cast<int>(numbered.size())).first->second;
        };
        for (const int f : faces) {
            const geometry::Face& face = topology_.faces[static_cast<std::size_t>(f)];
            add_to(key, numbers.of({2, f}));
            add_to(key, number_in(wholes, topology_.of_shape({2, f}).index));
            add_to(key, face.behind < 0 ? 0 : 1);
            for (const auto& [volume, flipped] : sides_[static_cast<std::size_t>(f)]) {
                add_to(key, 2 * number_in(volumes, volume) + (flipped ? 1 : 0));
                add_to(key, static_cast<int>(topology_.volumes[static_cast<std::size_t>(volume)].kind));
            }
            geometry::add_face_definition(model, f, faces.front(), numbers, key);
            const std::vector<int> uses = uses_in_order(face);
            entities.uses.insert(entities.uses.end(), uses.begin(), uses.end());
        }
        for (int dimension = 0; dimension < 3; ++dimension) {
            entities.of[static_cast<std::size_t>(dimension)] = numbers.in_order(dimension);
            for (const int index : numbers.in_order(dimension)) {
                add_to(key, dimension);  // a separator, so that what is added belongs to its entity
                add_more_({dimension, index}, key);
            }
        }
        return key;
    }

  private:
    const Topology& topology_;
    const AddMore& add_more_;
    std::vector<std::vector<std::pair<int, bool>>> sides_;  // by face: volumes, with the side towards them
};

/// Compares bodies with the same outline.
class Comparison {
  public:
    Comparison(const BodyFingerprints& fingerprints, const std::vector<Faces>& bodies, EqualBodies& result)
        : fingerprints_(fingerprints), bodies_(bodies), result_(result) {}

    void compare(geometry::Model& model, int body) {
        const auto b = static_cast<std::size_t>(body);
        const auto place = model.place_of_face(bodies_[b].front());
        if (!place) {
            return;
        }
        const Fingerprint key = fingerprints_.of(model, bodies_[b], result_.entities[b]);
        const auto [entry, fresh] = first_.emplace(key, First{body, *place});
        if (!fresh) {
            result_.original[b] = entry->second.body;
            result_.motion[b] = geometry::RigidMotion::between(entry->second.place, *place);
        }
    }

  private:
    struct First {
        int body;
        geometry::RigidMotion place;
    };
    const BodyFingerprints& fingerprints_;
    const std::vector<Faces>& bodies_;
    EqualBodies& result_;
    std::map<Fingerprint, First> first_;
};

std::vector<int> places_in(const std::vector<std::vector<int>>& lists, std::size_t count) {
    std::vector<int> places(count, -1);
    for (const std::vector<int>& list : lists) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            places[static_cast<std::size_t>(list[i])] = static_cast<int>(i);
        }
    }
    return places;
}

void set_places(const Topology& topology, EqualBodies& result) {
    const std::size_t counts[3] = {topology.nodes.size(), topology.edges.size(), topology.faces.size()};
    std::vector<std::vector<int>> lists(result.entities.size());
    for (std::size_t d = 0; d < 3; ++d) {
        for (std::size_t b = 0; b < lists.size(); ++b) {
            lists[b] = result.entities[b].of[d];
        }
        result.places[d] = places_in(lists, counts[d]);
    }
    for (std::size_t b = 0; b < lists.size(); ++b) {
        lists[b] = result.entities[b].uses;
    }
    result.places_of_uses = places_in(lists, topology.uses.size());
}

}  // namespace

EqualBodies find_equal_bodies(geometry::Session& session, const std::vector<Faces>& bodies,
                              const std::function<void(geometry::Entity, geometry::Fingerprint&)>& add_more) {
    EqualBodies result;
    result.original.resize(bodies.size(), -1);
    result.motion.resize(bodies.size());
    result.entities.resize(bodies.size());
    std::map<Fingerprint, std::vector<int>> by_outline;
    const std::vector<char> shares = that_share(session.topology(), bodies);
    std::vector<int> in_order(bodies.size());
    std::iota(in_order.begin(), in_order.end(), 0);
    std::sort(in_order.begin(), in_order.end(),
              [&](int a, int b) { return bodies[static_cast<std::size_t>(a)] < bodies[static_cast<std::size_t>(b)]; });
    for (const int b : in_order) {
        const Faces& faces = bodies[static_cast<std::size_t>(b)];
        if (shares[static_cast<std::size_t>(b)] == 0) {
            by_outline[outline_of(session.topology(), faces)].push_back(b);
        }
    }
    const BodyFingerprints fingerprints(session.topology(), add_more);
    for (const auto& alike : by_outline) {
        Comparison comparison(fingerprints, bodies, result);
        for (std::size_t i = 0; alike.second.size() > 1 && i < alike.second.size(); ++i) {
            session.run([&](geometry::Model& model) { comparison.compare(model, alike.second[i]); });
        }
    }
    set_places(session.topology(), result);
    return result;
}

}  // namespace mq::triangulate
