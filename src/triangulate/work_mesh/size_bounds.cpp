// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/size_bounds.h"

#include <algorithm>
#include <limits>
#include <string>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::triangulate {

namespace {

// Longest edge, divided by the size field at its middle: edges are then as long as the field on average, and within the
// promised 1.3 where the field is known within some per cent only.
constexpr double kLongestByField = 1.2;

// Longest edge of a triangle, divided by the least size in it.
constexpr double kLongestByLeast = 3.0;

constexpr double kUnboundedLength =
    std::numeric_limits<double>::infinity();  // Length in mm of an entity without a bound.

}  // namespace

std::vector<LocalSize> sizes_of_pieces(const std::vector<LocalSize>& local, const geometry::Topology& topology) {
    const char* const kinds[2][3] = {{"vertices", "edges", "faces"}, {"vertex", "edge", "face"}};
    std::vector<LocalSize> all;
    for (const LocalSize& size : local) {
        const std::size_t count = topology.own_count(size.dimension);
        const std::string name = geometry::name_of({size.dimension, size.index});
        if (size.index < 0 || static_cast<std::size_t>(size.index) >= count) {
            throw InvalidInput(
                phrases::kNoSuchEntity,
                {{"name", name}, {"count", count}, {"name2", kinds[count == 1 ? 1 : 0][size.dimension]}});
        }
        if (!(size.max_edge > 0.0)) {
            throw InvalidInput(phrases::kNoLocalSize, {{"name", name}});
        }
        for (const int index : topology.pieces_of({size.dimension, size.index})) {
            all.push_back(size);
            all.back().index = index;
        }
    }
    return all;
}

EdgeBounds::EdgeBounds(const geometry::Topology& topology, double max_edge, const std::vector<LocalSize>& local)
    : everywhere_(max_edge > 0.0 ? max_edge : kUnboundedLength), any_(max_edge > 0.0 || !local.empty()) {
    const std::size_t counts[3] = {topology.nodes.size(), topology.edges.size(), topology.faces.size()};
    for (const LocalSize& size : local) {
        std::vector<double>& bounds = of_entity_[size.dimension];
        bounds.resize(counts[size.dimension], kUnboundedLength);
        double& bound = bounds[static_cast<std::size_t>(size.index)];
        bound = std::min(bound, size.max_edge);
    }
}

double EdgeBounds::of(const ClassifiedMesh& mesh, int half_edge) const {
    double least = everywhere_;
    const auto include = [&](int dimension, int index) {
        if (!of_entity_[dimension].empty() && index >= 0) {
            least = std::min(least, of_entity_[dimension][static_cast<std::size_t>(index)]);
        }
    };
    include(2, mesh.face_of(half_edge / 3));
    const int s = mesh.segment_of(half_edge);
    if (s >= 0) {
        include(1, mesh.segment(s).edge);
        for (const auto& use : mesh.segment(s).uses) {
            include(2, mesh.face_of(use.half_edge / 3));
        }
    }
    for (const int h : {half_edge, ClassifiedMesh::next(half_edge)}) {
        const mesh::VertexEntity& entity = mesh.vertex(mesh.vertex_of(h)).entity;
        if (entity[0] == 0) {
            include(0, entity[1]);
        }
    }
    if (field_ != nullptr) {
        const Vec3 middle = 0.5 * (mesh.point_of(half_edge) + mesh.point_of(ClassifiedMesh::next(half_edge)));
        least = std::min(least, kLongestByField * field_->at(middle + origin_));
    }
    return least;
}

double EdgeBounds::by_triangles(const ClassifiedMesh& mesh, int half_edge, double length) const {
    if (field_ == nullptr) {
        return kUnboundedLength;
    }
    const double limit = length / kLongestByLeast;
    double least = limit;
    const auto include = [&](int h) {
        const int t = 3 * (h / 3);
        least = field_->least_in_simplex(
            {mesh.point_of(t) + origin_, mesh.point_of(t + 1) + origin_, mesh.point_of(t + 2) + origin_, Vec3::Zero()},
            3, least);
    };
    include(half_edge);
    const int s = mesh.segment_of(half_edge);
    if (s >= 0) {
        for (const auto& use : mesh.segment(s).uses) {
            include(use.half_edge);
        }
    } else if (mesh.twin(half_edge) >= 0) {
        include(mesh.twin(half_edge));
    }
    return least < limit ? kLongestByLeast * least : kUnboundedLength;
}

}  // namespace mq::triangulate
