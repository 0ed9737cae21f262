// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/face_fingerprints.h"

#include "geometry/face_definition.h"

namespace mq::triangulate {

namespace {

void add_motion(const geometry::RigidMotion& motion, geometry::Fingerprint& key) {
    for (int i = 0; i < 3; ++i) {
        geometry::add_to(key, Vec3(motion.turn.col(i)));
    }
    geometry::add_to(key, motion.shift);
}

}  // namespace

std::vector<geometry::Fingerprint> face_fingerprints(geometry::Session& session) {
    std::vector<geometry::Fingerprint> keys(session.topology().faces.size());
    for (int f = 0; f < static_cast<int>(keys.size()); ++f) {
        session.run([&](geometry::Model& model) {
            constexpr int kOwnFrame = -1;
            geometry::LocalNumbers numbers;
            geometry::add_face_definition(model, f, kOwnFrame, numbers, keys[f]);
        });
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
