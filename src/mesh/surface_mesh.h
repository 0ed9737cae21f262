// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// A triangle mesh under construction, classified on CAD entities.
///
/// Each CAD face has a mesh of its own (half-edges with twins); the faces meet in *segments*, pieces of CAD edges that
/// constrain the triangulation. A segment knows the half-edges of all faces that use it: two on a closed solid, one at
/// a border, both on one face at a seam, more on a non-manifold edge. Splitting a segment splits it for all of them.
///
/// A *vertex* is a point; a *site* is a vertex as one face sees it, with that face's (u, v) and normal. A vertex on a
/// seam has two sites on one face, so within a face (u, v) never jumps.
///
/// Half-edge 3 t + i runs from corner i to corner i + 1 of triangle t, its triangle on the left. Triangles and
/// vertices are added or rewritten, so indices stay; triangles that `replace` leaves over are gone until `compact`.
class SurfaceMesh {
  public:
    struct Vertex {
        Vec3 point;
        VertexEntity entity{-1, -1};
    };
    struct Site {
        int vertex = -1;
        Vec2 uv = Vec2::Zero();
        Vec3 normal = Vec3::Zero();  ///< outward unit normal of the CAD face; zero where it has none
        Vec3 point = Vec3::Zero();   ///< of the vertex, which `add_site` copies: one look-up less, millions of times
    };
    struct SegmentUse {
        int half_edge = -1;
        int use = -1;  ///< which appearance of the CAD edge on the face (index into the CAD topology's uses)
    };
    struct Segment {
        int edge = -1;                  ///< CAD edge
        std::array<int, 2> vertices{};  ///< at t[0] and t[1]
        std::array<double, 2> t{};
        std::vector<SegmentUse> uses;
    };

    int add_vertex(const Vec3& point, VertexEntity entity);
    int add_site(const Site& site);
    int add_triangle(const std::array<int, 3>& sites, int face);
    int add_segment(int edge, const std::array<int, 2>& vertices, const std::array<double, 2>& t);
    /// Makes two half-edges of one face twins.
    void link(int half_edge, int twin);
    /// Puts a half-edge on a segment.
    void bind(int half_edge, int segment, int use);

    int triangle_count() const { return static_cast<int>(face_.size()); }
    int half_edge_count() const { return static_cast<int>(corner_.size()); }
    int vertex_count() const { return static_cast<int>(vertices_.size()); }
    int segment_count() const { return static_cast<int>(segments_.size()); }
    int site_count() const { return static_cast<int>(sites_.size()); }

    static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
    static int triangle_of(int h) { return h / 3; }

    int site_of(int h) const { return corner_[h]; }
    int vertex_of(int h) const { return sites_[corner_[h]].vertex; }
    const Vec3& point_of(int h) const { return sites_[corner_[h]].point; }
    /// The other half-edge, or -1 where `h` lies on a segment.
    int twin(int h) const { return twin_[h] < 0 ? -1 : twin_[h]; }
    /// The segment under `h`, or -1 where it has a twin.
    int segment_of(int h) const { return twin_[h] < 0 ? ~twin_[h] : -1; }
    int face_of(int triangle) const { return face_[triangle]; }
    /// The number of the edge under `h`, on this face where it lies on a segment; the same for both half-edges. An edge
    /// keeps it as long as it joins the same vertices, and no other ever has it: what was found out about an edge can
    /// be kept by it.
    int number_of(int h) const { return number_[h]; }
    /// Of all numbers that were given.
    int number_count() const { return numbers_; }
    /// Changes whenever the corners of the triangle change.
    std::uint32_t stamp(int triangle) const { return stamp_[triangle]; }

    const Vertex& vertex(int v) const { return vertices_[v]; }
    const Site& site(int s) const { return sites_[s]; }
    void set_normal(int s, const Vec3& normal) { sites_[s].normal = normal; }
    const Segment& segment(int s) const { return segments_[s]; }

    /// Triangle (a, b, c) becomes (a, b, p), (b, c, p), (c, a, p); the first keeps its index.
    /// @return the indices of the three.
    std::array<int, 3> split_triangle(int triangle, int site);
    /// The two triangles beside the edge of `h` become four around `site`. Needs a twin.
    std::array<int, 4> split_edge(int h, int site);
    /// Splits a segment at `vertex`, parameter `t`; `sites[k]` is the vertex as use k sees it.
    /// @return the new segment from `vertex` to the old far end. The segment itself keeps the near half.
    int split_segment(int segment, int vertex, double t, const std::vector<int>& sites);
    /// Replaces the edge a-b of `h` by the one between the opposite corners. Needs a twin; `h` then is one of the
    /// half-edges of the same two triangles. Checks nothing.
    void swap(int h);

    /// What takes the place of the triangles around a vertex on a segment, on one of its faces.
    struct Refill {
        std::vector<int> removed;
        std::vector<std::array<int, 3>> added;  ///< sites
        std::array<int, 2> base;                ///< sites at the ends of the side that lies on the joined segment
    };
    /// The inverse of `split_segment`: `far` starts where `near` ends, and one segment, `near`, takes the place of
    /// both. `refills[k]` for use k of `near`. Nothing uses `far` afterwards.
    /// @return the new triangles. Triangles may be gone until `compact`.
    std::vector<int> join_segments(int near, int far, const std::vector<Refill>& refills);
    /// Puts another vertex in the place of the one where `near` ends and `far` starts, at parameter `t`. `spokes[k]`
    /// are the half-edges that leave it on the face of use k of `near`, and `sites[k]` is the new vertex as that use
    /// sees it.
    void put_between(int near, int far, int vertex, double t, const std::vector<std::vector<int>>& spokes,
                     const std::vector<int>& sites);
    /// Joins the two sides of a segment as twins, across faces: it constrains no longer, and has no uses. Needs exactly
    /// two uses, which run opposite ways. Sites stay: the same vertex has one on either side.
    void dissolve(int segment);
    /// The vertex of `h` by another of its sites.
    void put_site(int h, int site) { corner_[h] = site; }
    /// The face that a triangle counts to.
    void put_face(int triangle, int face) { face_[triangle] = face; }

    /// Other triangles in the place of some: all of one face, with the same rim, sites as corners.
    /// @return the indices of `added`; those of `removed` come first, and what is left over of them is gone.
    std::vector<int> replace(const std::vector<int>& removed, const std::vector<std::array<int, 3>>& added);
    /// Only between `replace` and `compact`: the triangle is not there any more. Nothing else may be asked of it.
    bool gone(int triangle) const { return face_[triangle] < 0; }
    /// Gives the last triangles the indices of those that are gone.
    /// @return the pairs old index, new index of the triangles that moved.
    std::vector<std::pair<int, int>> compact();

    /// Becomes what it was, or another outcome of the same. Numbers of edges go on from the higher of the two.
    void become(const SurfaceMesh& other);

    /// The half-edge that leaves the end `vertex` of a segment on the face of one of its uses: along the segment, or
    /// the next one of the triangle.
    int leaving(const SegmentUse& use, int vertex) const {
        return vertex_of(use.half_edge) == vertex ? use.half_edge : next(use.half_edge);
    }
    /// Half-edges that leave the site of `h`, around it within the face, counter-clockwise from `h` or, where a
    /// segment cuts the turn, from the first after it.
    std::vector<int> star(int h) const;
    /// Of each of so many CAD faces, ascending. Nothing may be gone.
    std::vector<std::vector<int>> triangles_by_face(std::size_t faces) const;
    /// Whether an edge leads from the site of `h` to the vertex; `h` must leave a site that no segment touches.
    bool leads_to(int h, int vertex) const;

    /// The first inconsistency of links, segments and corners, or an empty string. For tests; O(n).
    std::string inconsistency() const;

  private:
    struct Link {
        int twin;
        int slot;  // of the segment's use, where twin names a segment
        int number;
    };
    Link take(int h) const;
    void put(int h, const Link& link);
    void set_corners(int triangle, int a, int b, int c);
    void drop_last_triangle();
    void link_by_vertices(const std::map<std::pair<int, int>, int>& open);

    std::vector<Vertex> vertices_;
    std::vector<Site> sites_;
    std::vector<Segment> segments_;
    std::vector<int> corner_;  // site at the origin of each half-edge
    std::vector<int> twin_;    // half-edge, or ~segment
    std::vector<int> number_;  // of the edge
    std::vector<int> face_;
    std::vector<std::uint32_t> stamp_;  // also of triangles that are gone from the end
    int numbers_ = 0;
};

}  // namespace mq::mesh
