// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/cache_keys.h"

#include <utility>

#include "geometry/face_definition.h"

namespace mq::triangulate {

namespace {

using geometry::add_to;
using geometry::Fingerprint;
using geometry::Topology;

void add_sizes(const TriangulateOptions& options, int dimension, int index, Fingerprint& key) {
    for (const LocalSize& size : options.local_sizes) {
        if (size.dimension == dimension && size.index == index) {
            add_to(key, dimension);
            add_to(key, size.max_edge);
        }
    }
}

void add_sizes_around(const TriangulateOptions& options, const Topology& topology, int f, Fingerprint& key) {
    add_sizes(options, 2, f, key);
    for (const int u : uses_in_order(topology.faces[f])) {
        add_to(key, 1);  // a separator, so that local sizes are assigned to their edge use
        add_sizes(options, 1, topology.uses[u].edge, key);
        for (const int n : topology.edges[topology.uses[u].edge].nodes) {
            add_sizes(options, 0, n, key);
        }
    }
}

void add_field(const SizeField& field, const Box& box, Fingerprint& key) {
    field.for_each_leaf(box, [&](const Vec3& low, double side, const SizeField::Corners& sizes) {
        add_to(key, low);
        add_to(key, side);
        for (const double size : sizes) {
            add_to(key, size);
        }
    });
}

// Bounds a face by points of its surface: the trimmed face lies on it.
Box box_of(geometry::Session& session, int f) {
    constexpr int kPoints = 9;       // in u and in v
    constexpr double kBeyond = 0.1;  // fraction of the size, on each side: the surface may bulge between the points
    const geometry::Face& face = session.topology().faces[static_cast<std::size_t>(f)];
    geometry::Engine::Batch batch;
    for (int i = 0; i < kPoints * kPoints; ++i) {
        const double s = static_cast<double>(i % kPoints) / (kPoints - 1);
        const double t = static_cast<double>(i / kPoints) / (kPoints - 1);
        batch.push_back(geometry::Query::face_point(f, face.low[0] + s * (face.high[0] - face.low[0]),
                                                    face.low[1] + t * (face.high[1] - face.low[1])));
    }
    Box box;
    for (const geometry::Answer& answer : session.ask(std::move(batch))) {
        box.add(answer.point);
    }
    const Vec3 beyond = Vec3::Constant(kBeyond * box.largest_side());
    return {box.low - beyond, box.high + beyond};
}

void add_options(const TriangulateOptions& o, Fingerprint& key) {
    for (const double number : {o.min_angle, o.chord_height, o.chord_height_relative, o.max_edge, o.min_edge,
                                o.edges_per_circle, o.growth, o.feature_angle}) {
        add_to(key, number);
    }
    for (const int choice :
         {static_cast<int>(o.insertion), static_cast<int>(o.order), static_cast<int>(o.keep_edges),
          static_cast<int>(o.corners), static_cast<int>(o.allow_missing_faces), static_cast<int>(o.sew),
          static_cast<int>(o.imprint), static_cast<int>(o.method), static_cast<int>(o.connectivity),
          static_cast<int>(o.polish), static_cast<int>(o.record_angles), static_cast<int>(o.evaluation)}) {
        add_to(key, choice);
    }
    add_to(key, static_cast<std::uint64_t>(o.budget()));
    add_to(key, o.seed);
    add_to(key, static_cast<std::uint64_t>(o.sites_in_round));
    for (const LocalSize& size : o.local_sizes) {
        add_to(key, size.dimension);
        add_to(key, size.index);
        add_to(key, size.max_edge);
    }
    if (o.size_field != nullptr) {
        add_field(*o.size_field, {o.size_field->low(), o.size_field->low() + Vec3::Constant(o.size_field->side())},
                  key);
    }
}

}  // namespace

CacheKeys keys_of(geometry::Session& session, const TriangulateOptions& options) {
    CacheKeys keys;
    keys.faces = face_fingerprints(session);
    add_options(options, keys.input);
    add_structure(session, keys.input);
    for (int f = 0; f < static_cast<int>(keys.faces.size()); ++f) {
        add_to(keys.input, keys.faces[f]);
        add_sizes_around(options, session.topology(), f, keys.faces[f]);
        if (options.size_field != nullptr) {
            add_field(*options.size_field, box_of(session, f), keys.faces[f]);
        }
    }
    return keys;
}

}  // namespace mq::triangulate
