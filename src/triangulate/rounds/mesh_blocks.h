// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Divides a mesh into blocks of near triangles, each of which a thread changes by itself: the edges between blocks are
/// *cut*, that is they constrain like segments, so that no operator looks or works beyond them. What could not be done
/// for that is done after the blocks are joined. Blocks depend on the mesh alone, not on the number of threads, so that
/// the bytes of the mesh do not either.
///
/// The method is the domain decomposition with frozen interfaces of parallel remeshing (Cirrottola and Froehly 2019,
/// ParMmg), on one mesh in shared memory. Blocks are pieces of a Morton curve.
class MeshBlocks {
  public:
    /// Cuts the mesh into `count` blocks of about equal numbers of triangles. No index of a triangle may be unused.
    MeshBlocks(ClassifiedMesh& mesh, std::size_t count);
    MeshBlocks(const MeshBlocks&) = delete;
    MeshBlocks& operator=(const MeshBlocks&) = delete;

    std::size_t count() const { return count_; }
    std::size_t block_of(int triangle) const { return block_[static_cast<std::size_t>(triangle)]; }

    /// Makes room for vertices inside faces: `insertions[k]` in block k, with two triangles each. Afterwards each
    /// thread adds elements by ClassifiedMesh::SharedEditing, to the share of the block that it works on.
    void reserve(const std::vector<std::size_t>& insertions);
    ClassifiedMesh::Share& share(std::size_t block) { return shares_[block]; }

    /// Joins the blocks: closes the gaps between the elements that were added, which get the order of the blocks, and
    /// makes cut edges edges again.
    /// @return a half-edge of each
    std::vector<int> join();
    /// After `join`: the present index of a vertex from that block.
    int joined_vertex(std::size_t block, int vertex) const;

    /// After `join`: moves data by vertex, which was stored by the indices of `reserve`, to the present ones.
    template <typename Values>
    void move_by_vertex(Values& values) const {
        for (std::size_t k = 0; k < count_; ++k) {
            move(values, new_vertices_[k], shares_[k].vertex, 1);
        }
        values.resize(mesh_.points_.size());
    }

  private:
    struct Range {
        int first = 0;  // index of its first element
        int shift = 0;  // by which `join` lowers the indices
    };
    // Moves the elements of the range up to `end`, `width` values each, to their places, which lie before it or where
    // it begins.
    template <typename Values>
    static void move(Values& values, const Range& range, int end, int width) {
        const auto first = values.begin() + std::ptrdiff_t{width} * range.first;
        std::copy(first, values.begin() + std::ptrdiff_t{width} * end, first - std::ptrdiff_t{width} * range.shift);
    }
    void assign();
    void cut();
    void measure_shares();
    static std::size_t block_with(const std::vector<Range>& ranges, int index);
    static int moved(const std::vector<Range>& ranges, int index, int first_new);
    void renumber(int triangle);
    void move_elements();

    ClassifiedMesh& mesh_;
    std::size_t count_;
    LargeVector<std::uint16_t> block_;  // by triangle
    int first_cut_ = 0;                 // segment
    // The numbers of elements before `reserve`.
    int triangles_;
    int vertices_;
    int sites_;
    int numbers_;
    std::vector<ClassifiedMesh::Share> shares_;
    // By block.
    std::vector<Range> new_triangles_;
    std::vector<Range> new_vertices_;
    std::vector<Range> new_sites_;
    std::vector<int> new_numbers_;  // how many come before
    LargeVector<std::uint32_t> dropped_stamps_;
};

}  // namespace mq::triangulate
