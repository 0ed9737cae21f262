// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/placed_body.h"

#include <array>
#include <cstddef>
#include <utility>

#include "triangulate/work_mesh/corner_classification.h"

namespace mq::triangulate {

namespace {

/// One copy of one mesh.
class Placement {
  public:
    Placement(const SinglePrecisionGrid& grid, const ClassifiedMesh& original, const EqualBodies& equal, int copy)
        : grid_(grid),
          original_(original),
          equal_(equal),
          copy_(copy),
          motion_(equal.motion[static_cast<std::size_t>(copy)]) {}

    bool place(const ClassifiedMesh& whole, const std::map<int, int>& nodes);
    bool keeps_sides() const;
    bool evaluate_points(geometry::Session& session);
    void add_to(MeshComponent& component) const;

  private:
    bool near(const Vec3& placed, const Vec3& point_of_shape) const {
        return (grid_.to_shape(placed) - point_of_shape).norm() <= kOffPlace * grid_.resolution();
    }

    const SinglePrecisionGrid& grid_;
    const ClassifiedMesh& original_;
    const EqualBodies& equal_;
    int copy_;
    const geometry::RigidMotion& motion_;
    std::vector<Vec3> points_;  // by vertex of the original
    std::vector<int> former_;   // by vertex of the original: that of the whole mesh at the same node, or -1
};

// @return whether the copy has all the nodes where they should be
bool Placement::place(const ClassifiedMesh& whole, const std::map<int, int>& nodes) {
    for (int v = 0; v < original_.vertex_count(); ++v) {
        const ClassifiedMesh::Vertex vertex = original_.vertex(v);
        const Vec3 moved = motion_.of_point(grid_.to_shape(vertex.point));
        former_.push_back(-1);
        points_.push_back(grid_.snap(moved));
        if (vertex.entity[0] == 0) {
            const auto own = nodes.find(equal_.in_copy({0, vertex.entity[1]}, copy_));
            if (own == nodes.end() || !near(whole.vertex(own->second).point, moved)) {
                return false;
            }
            former_.back() = own->second;
            points_.back() = whole.vertex(own->second).point;
        }
    }
    return true;
}

// Takes the points of the copy's own curves and surfaces.
// @return whether these are where they should be
bool Placement::evaluate_points(geometry::Session& session) {
    geometry::Engine::Batch batch;
    std::vector<int> vertices;
    for (int s = 0; s < original_.site_count(); ++s) {
        const ClassifiedMesh::VertexUse& site = original_.site(s);
        const mesh::VertexEntity entity = original_.vertex(site.vertex).entity;
        if (entity[0] == 2) {
            const int face = equal_.in_copy({2, entity[1]}, copy_);
            batch.push_back(geometry::Query::face_point(face, site.uv.x(), site.uv.y()));
            vertices.push_back(site.vertex);
        }
    }
    for (int s = 0; s < original_.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = original_.segment(s);
        if (original_.vertex(segment.vertices[0]).entity[0] == 1) {
            batch.push_back(geometry::Query::edge_point(equal_.in_copy({1, segment.edge}, copy_), segment.t[0]));
            vertices.push_back(segment.vertices[0]);
        }
    }
    const geometry::Engine::Answers answers = session.ask(std::move(batch));
    for (std::size_t i = 0; i < answers.size(); ++i) {
        Vec3& point = points_[static_cast<std::size_t>(vertices[i])];
        if (!answers[i].found() || !near(point, answers[i].point)) {
            return false;
        }
        point = grid_.snap(answers[i].point);
    }
    return true;
}

// Whether no triangle is turned over or has become a line.
bool Placement::keeps_sides() const {
    for (int t = 0; t < original_.triangle_count(); ++t) {
        const auto corner = [&](int k) -> const Vec3& {
            return points_[static_cast<std::size_t>(original_.vertex_of(3 * t + k))];
        };
        const Vec3 now = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        if (!(now.dot(motion_.of_direction(doubled_area(original_, t))) > 0.0)) {
            return false;
        }
    }
    return true;
}

void Placement::add_to(MeshComponent& component) const {
    ClassifiedMesh& mesh = component.mesh;
    const int vertices = mesh.vertex_count();
    const int sites = mesh.site_count();
    const int half_edges = mesh.half_edge_count();
    for (int v = 0; v < original_.vertex_count(); ++v) {
        const mesh::VertexEntity entity = original_.vertex(v).entity;
        mesh.add_vertex(points_[static_cast<std::size_t>(v)],
                        {entity[0], equal_.in_copy({entity[0], entity[1]}, copy_)});
    }
    component.vertices.insert(component.vertices.end(), former_.begin(), former_.end());
    for (int s = 0; s < original_.site_count(); ++s) {
        ClassifiedMesh::VertexUse site = original_.site(s);
        site.vertex += vertices;
        site.normal = motion_.of_direction(site.normal);
        mesh.add_site(site);
    }
    for (int t = 0; t < original_.triangle_count(); ++t) {
        const std::array<int, 3> corners{original_.site_of(3 * t) + sites, original_.site_of(3 * t + 1) + sites,
                                         original_.site_of(3 * t + 2) + sites};
        mesh.add_triangle(corners, equal_.in_copy({2, original_.face_of(t)}, copy_));
    }
    for (int h = 0; h < original_.half_edge_count(); ++h) {
        if (h < original_.twin(h)) {
            mesh.link(half_edges + h, half_edges + original_.twin(h));
        }
    }
    for (int s = 0; s < original_.segment_count(); ++s) {
        const ClassifiedMesh::Segment& segment = original_.segment(s);
        const int added = mesh.add_segment(equal_.in_copy({1, segment.edge}, copy_),
                                           {segment.vertices[0] + vertices, segment.vertices[1] + vertices}, segment.t);
        for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
            mesh.bind(half_edges + use.half_edge, added, equal_.use_in_copy(use.use, copy_));
        }
    }
}

}  // namespace

std::map<int, int> vertices_of_nodes(const ClassifiedMesh& mesh, const std::vector<int>& triangles) {
    std::map<int, int> vertices;
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const mesh::VertexEntity entity = mesh.vertex(mesh.vertex_of(h)).entity;
            if (entity[0] == 0) {
                vertices.emplace(entity[1], mesh.vertex_of(h));
            }
        }
    }
    return vertices;
}

bool add_placed(geometry::Session& session, const SinglePrecisionGrid& grid, const ClassifiedMesh& original,
                const EqualBodies& equal, int copy, const ClassifiedMesh& whole, const std::map<int, int>& nodes,
                MeshComponent& component) {
    Placement placement(grid, original, equal, copy);
    if (!placement.place(whole, nodes) || !placement.evaluate_points(session) || !placement.keeps_sides()) {
        return false;
    }
    session.check();
    placement.add_to(component);
    return true;
}

}  // namespace mq::triangulate
