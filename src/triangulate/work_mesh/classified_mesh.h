// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/for_ranges.h"
#include "base/memory/large_vector.h"
#include "base/vec.h"
#include "mesh/corner_table.h"
#include "mesh/triangle_mesh.h"

namespace mq::triangulate {

/// Moves data by the numbers of edges to their new numbers, which `renumber_edges` has returned.
template <typename Values>
void move_to_numbers(const LargeVector<int>& renewed, Values& values) {
    std::size_t count = 0;
    for (std::size_t old = 0; old < values.size(); ++old) {
        if (renewed[old] >= 0) {
            count = static_cast<std::size_t>(renewed[old]) + 1;
            values[count - 1] = values[old];
        }
    }
    values.resize(count);
    values.shrink_to_fit();
}

/// New indices by the old ones; -1: it is gone. See ClassifiedMesh::order_in_space.
struct NewIndices {
    LargeVector<int> triangles;
    LargeVector<int> vertices;
    LargeVector<int> sites;
    LargeVector<int> edges;  ///< by number
};

/// Moves data to their new indices, which have no gaps; indices without former data get `none`.
template <typename Values>
void move_to_indices(const LargeVector<int>& renewed, Values& values, const typename Values::value_type& none) {
    if (values.empty()) {
        return;
    }
    const auto present = [](int index) { return index >= 0; };
    // Data are copied, as moving them along the chains of indices would wait for memory at every step.
    Values moved(static_cast<std::size_t>(std::count_if(renewed.begin(), renewed.end(), present)), none);
    for_each_in_ranges(std::min(values.size(), renewed.size()), [&](std::size_t old) {
        if (renewed[old] >= 0) {
            moved[static_cast<std::size_t>(renewed[old])] = values[old];
        }
    });
    values.swap(moved);
}

/// Likewise for data in a map by index, which may contain indices that no longer exist.
template <typename Value>
void move_to_indices(const LargeVector<int>& renewed, std::map<int, Value>& values) {
    std::map<int, Value> moved;
    for (const auto& [old, value] : values) {
        const auto index = static_cast<std::size_t>(old);
        if (index < renewed.size() && renewed[index] >= 0) {
            moved.emplace(renewed[index], value);
        }
    }
    values = std::move(moved);
}

/// A triangle mesh under construction, classified on CAD entities.
///
/// Each CAD face has a mesh of its own (half-edges with twins); the faces meet in *segments*, pieces of CAD edges that
/// constrain the triangulation. A segment knows the half-edges of all faces that use it: two on a closed solid, one at
/// a border, both on one face at a seam, more on a non-manifold edge. Splitting a segment splits it for all of them.
///
/// A *vertex* is a point; a *site* is the use of a vertex on one face, with that face's (u, v) and normal. A vertex on
/// a seam has two sites on one face, so that (u, v) never jumps within a face.
///
/// Half-edge 3 t + i runs from corner i to corner i + 1 of triangle t, its triangle on the left. Triangles and
/// vertices are added or rewritten, so that indices stay valid; indices that `replace` leaves unused are gone until
/// `compact`.
class ClassifiedMesh {
  public:
    struct Vertex {
        Vec3 point;
        mesh::VertexEntity entity{-1, -1};
    };
    /// The use of a vertex by the triangles of one face; in short, a site. A vertex on a seam or a pole has several.
    struct VertexUse {
        int vertex = -1;
        Vec2 uv = Vec2::Zero();
        Vec3 normal = Vec3::Zero();  ///< outward unit normal of the CAD face; zero where it has none
        /// Point of the vertex, which `add_site` copies: this saves a look-up in inner loops.
        Vec3 point = Vec3::Zero();
    };
    struct SegmentUse {
        int half_edge = -1;
        int use = -1;  ///< use of the CAD edge on the face (index into the CAD topology's uses)
    };
    struct Segment {
        int edge = -1;                  ///< CAD edge
        std::array<int, 2> vertices{};  ///< at t[0] and t[1]
        std::array<double, 2> t{};
        std::vector<SegmentUse> uses;
    };

    /// Where one of several threads that change triangles of their own puts the elements that it adds; see MeshBlocks.
    struct Share {
        int vertex = 0;    ///< the next vertex
        int site = 0;      ///< the next site
        int triangle = 0;  ///< the next triangle
        int number = 0;    ///< the next number of an edge: the same in all shares, until they are joined
    };
    /// While it lives, its thread adds elements to a share, and not at the end of the mesh.
    class SharedEditing {
      public:
        explicit SharedEditing(Share& share) { share_ = &share; }
        ~SharedEditing() { share_ = nullptr; }
        SharedEditing(const SharedEditing&) = delete;
        SharedEditing& operator=(const SharedEditing&) = delete;
    };

    int add_vertex(const Vec3& point, mesh::VertexEntity entity);
    int add_site(const VertexUse& site);
    int add_triangle(const std::array<int, 3>& sites, int face);
    int add_segment(int edge, const std::array<int, 2>& vertices, const std::array<double, 2>& t);
    /// Makes two half-edges of one face twins.
    void link(int half_edge, int twin);
    /// Puts a half-edge on a segment.
    void bind(int half_edge, int segment, int use);

    int triangle_count() const { return static_cast<int>(face_.size()); }
    /// Number of triangles without the indices that `replace` left unused.
    int used_triangle_count() const { return triangle_count() - static_cast<int>(gone_.size()); }
    int half_edge_count() const { return static_cast<int>(corner_.size()); }
    int vertex_count() const { return static_cast<int>(points_.size()); }
    int segment_count() const { return static_cast<int>(segments_.size()); }
    int site_count() const { return static_cast<int>(sites_.size()); }

    static int next(int h) { return mesh::next_corner(h); }
    static int prev(int h) { return mesh::previous_corner(h); }
    static int triangle_of(int h) { return h / 3; }

    int site_of(int h) const { return corner_[h]; }
    int vertex_of(int h) const { return sites_[corner_[h]].vertex; }
    const Vec3& point_of(int h) const { return sites_[corner_[h]].point; }
    /// Returns the other half-edge, or -1 if `h` lies on a segment.
    int twin(int h) const { return twin_[h] < 0 ? -1 : twin_[h]; }
    /// Returns the segment under `h`, or -1 if `h` has a twin.
    int segment_of(int h) const { return twin_[h] < 0 ? sides_[~twin_[h]].segment : -1; }
    int face_of(int triangle) const { return face_[triangle]; }
    /// Returns the number of the edge under `h`, on this face if it lies on a segment; the same for both half-edges.
    /// An edge keeps it as long as it joins the same vertices, and no other edge gets it before `renumber_edges`, so
    /// that data on an edge can be stored by it.
    int number_of(int h) const { return number_[h]; }
    /// Returns one more than the largest number given to an edge.
    int number_count() const { return numbers_; }
    /// Returns how many edges there have ever been: it changes with every change of the mesh that creates an edge.
    std::int64_t edges_made() const { return dropped_ + numbers_; }
    /// Returns how many numbers are in use.
    int edge_count() const;
    /// Numbers the edges anew, without gaps and in the same order, so that data by number have none for edges that are
    /// gone.
    /// @return by old number: the new one; -1: no edge has it any more. See move_to_numbers
    LargeVector<int> renumber_edges();
    /// Gives near triangles near indices, and so for vertices, sites and edges: work on neighbours then finds its data
    /// in the processor's caches. Segments keep their indices, and so do vertices below `vertices` and sites below
    /// `sites`; others that nothing uses are gone. No index of a triangle may be unused.
    NewIndices order_in_space(int vertices, int sites);
    /// Returns the version of the triangle, which changes whenever its corners change.
    std::uint32_t stamp(int triangle) const { return stamp_[triangle]; }

    Vertex vertex(int v) const { return {points_[v], entities_[v]}; }
    /// Returns the points of all vertices.
    const std::vector<Vec3>& points() const { return points_; }
    const VertexUse& site(int s) const { return sites_[s]; }
    void set_normal(int s, const Vec3& normal) { sites_[s].normal = normal; }
    const Segment& segment(int s) const { return segments_[s]; }

    /// Triangle (a, b, c) becomes (a, b, p), (b, c, p), (c, a, p); the first keeps its index.
    /// @return the indices of the three.
    std::array<int, 3> split_triangle(int triangle, int site);
    /// Splits a segment at `vertex`, parameter `t`; `sites[k]` is the vertex's site for use k.
    /// @return the new segment from `vertex` to the old far end. The segment itself keeps the near half.
    int split_segment(int segment, int vertex, double t, const std::vector<int>& sites);
    /// Replaces the edge a-b of `h` by the one between the opposite corners. Needs a twin; `h` then is one of the
    /// half-edges of the same two triangles. No checks are made.
    void swap(int h);

    /// The replacement of the triangles around a vertex on a segment, on one of its faces.
    struct CavityFill {
        std::vector<int> removed;
        std::vector<std::array<int, 3>> added;  ///< sites
        std::array<int, 2> base;                ///< sites at the ends of the side that lies on the joined segment
    };
    /// The inverse of `split_segment`: `far` starts where `near` ends, and `near` becomes the union of both.
    /// `refills[k]` is for use k of `near`. Nothing uses `far` afterwards.
    /// @return the new triangles. Indices may be unused until `compact`.
    std::vector<int> join_segments(int near, int far, const std::vector<CavityFill>& refills);
    /// Replaces the vertex where `near` ends and `far` starts by another one, at parameter `t`. `spokes[k]` are the
    /// half-edges that leave it on the face of use k of `near`, and `sites[k]` is the new vertex's site for that use.
    void replace_between(int near, int far, int vertex, double t, const std::vector<std::vector<int>>& spokes,
                         const std::vector<int>& sites);
    /// Joins the two sides of a segment as twins, across faces: it no longer constrains, and has no uses. Needs
    /// exactly two uses in opposite directions. Sites stay: the same vertex has one on either side.
    void dissolve(int segment);
    /// Replaces the site at the origin of `h` by another site of the same vertex.
    void put_site(int h, int site) { corner_[h] = site; }
    /// Assigns a triangle to a face.
    void put_face(int triangle, int face) { face_[triangle] = face; }

    /// Replaces triangles of one face by others with the same boundary, given by sites as corners.
    /// @return the indices of `added`; those of `removed` are used first, and the remaining ones are gone.
    std::vector<int> replace(const std::vector<int>& removed, const std::vector<std::array<int, 3>>& added);
    /// Whether the triangle's index is unused, between `replace` and `compact`. No other function may be called for
    /// it.
    bool gone(int triangle) const { return face_[triangle] < 0; }
    /// Moves the last triangles to the unused indices.
    /// @return the pairs old index, new index of the triangles that moved.
    std::vector<std::pair<int, int>> compact();

    /// Returns the half-edge that leaves the end `vertex` of a segment on the face of one of its uses: along the
    /// segment, or the next one of the triangle.
    int leaving(const SegmentUse& use, int vertex) const {
        return vertex_of(use.half_edge) == vertex ? use.half_edge : next(use.half_edge);
    }
    /// Returns the half-edges that leave the site of `h`, around it within the face, counter-clockwise from `h` or,
    /// where a segment interrupts the turn, from the first one after it. None where there are more than `most`: where
    /// a question about a large fan has no use, asking it for each triangle of the fan must not cost the square of
    /// their number.
    std::vector<int> star(int h, std::size_t most = SIZE_MAX) const;
    /// Returns the triangles of each of `faces` CAD faces, ascending. No index may be unused.
    std::vector<std::vector<int>> triangles_by_face(std::size_t faces) const;
    /// Whether an edge leads from the site of `h` to the vertex, on this side of segments.
    bool leads_to(int h, int vertex) const;

    /// Returns the first inconsistency of links, segments and corners, or an empty string. For tests; O(n).
    std::string inconsistency() const;

  private:
    friend class MeshBlocks;

    struct Link {
        int twin;
        int number;
    };
    // One of the uses of a segment. Threads that change different sides of a segment look at their own only.
    struct SegmentSide {
        int segment;
        int slot;  // index of the use
    };
    static constexpr SegmentSide kLooseSide{0x7ffffffe, -1};  // half-edges neither linked nor bound yet
    static thread_local Share* share_;                        // the one that SharedEditing sets; null: none

    Link link_of(int h) const { return {twin_[h], number_[h]}; }
    int new_number();
    int add_side(int segment, int slot);
    void put(int h, const Link& link);
    void set_corners(int triangle, int a, int b, int c);
    void drop_last_triangle();
    NewIndices new_indices(const LargeVector<int>& order, int vertices, int sites);
    void move_triangles(const LargeVector<int>& order, const NewIndices& renewed);
    void link_by_vertices(const std::map<std::pair<int, int>, int>& open,
                          const std::map<std::pair<int, int>, Link>& rim);

    std::vector<Vec3> points_;  // by vertex
    LargeVector<mesh::VertexEntity> entities_;
    LargeVector<VertexUse> sites_;
    LargeVector<Segment> segments_;
    LargeVector<int> corner_;  // site at the origin of each half-edge
    LargeVector<int> twin_;    // half-edge, or ~(index into sides_)
    LargeVector<SegmentSide> sides_{kLooseSide};
    LargeVector<int> number_;  // number of the edge
    LargeVector<int> face_;
    LargeVector<std::uint32_t> stamp_;  // also for indices that were dropped from the end
    int numbers_ = 0;
    std::int64_t dropped_ = 0;  // count of the numbers that renumber_edges has dropped
    std::vector<int> gone_;     // unused indices of triangles
};

/// A Morton curve through the bounding box of a mesh.
class MortonCurve {
  public:
    explicit MortonCurve(const ClassifiedMesh& mesh);
    /// Returns the place of the triangle's centroid along the curve.
    std::uint32_t place(int triangle) const;

  private:
    const ClassifiedMesh& mesh_;
    Vec3 low_;
    double scale_ = 0.0;
};

}  // namespace mq::triangulate
