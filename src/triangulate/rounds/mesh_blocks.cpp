// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/rounds/mesh_blocks.h"

#include <algorithm>

#include "base/for_ranges.h"

namespace mq::triangulate {

MeshBlocks::MeshBlocks(ClassifiedMesh& mesh, std::size_t count)
    : mesh_(mesh),
      count_(count),
      first_cut_(mesh.segment_count()),
      triangles_(mesh.triangle_count()),
      vertices_(mesh.vertex_count()),
      sites_(mesh.site_count()),
      numbers_(mesh.number_count()) {
    assign();
    cut();
}

// The ends of the blocks are quantiles of a sample of the triangles' places.
void MeshBlocks::assign() {
    constexpr int kSamplesOfBlock = 64;
    const MortonCurve curve(mesh_);
    const int samples = std::min(triangles_, kSamplesOfBlock * static_cast<int>(count_));
    std::vector<std::uint32_t> places(static_cast<std::size_t>(samples));
    for (int i = 0; i < samples; ++i) {
        places[static_cast<std::size_t>(i)] = curve.place(static_cast<int>(std::int64_t{i} * triangles_ / samples));
    }
    std::sort(places.begin(), places.end());
    std::vector<std::uint32_t> ends;
    for (std::size_t k = 1; k < count_; ++k) {
        ends.push_back(places[k * places.size() / count_]);
    }
    block_.resize(static_cast<std::size_t>(triangles_));
    for_each_in_ranges(block_.size(), [&](std::size_t t) {
        const auto end = std::upper_bound(ends.begin(), ends.end(), curve.place(static_cast<int>(t)));
        block_[t] = static_cast<std::uint16_t>(end - ends.begin());
    });
}

void MeshBlocks::cut() {
    using HalfEdges = std::vector<int>;
    const auto count = static_cast<std::size_t>(3 * triangles_);
    const auto cuts = found_in_ranges<HalfEdges>(count, [&](std::size_t from, std::size_t to, HalfEdges& found) {
        for (int h = static_cast<int>(from); h < static_cast<int>(to); ++h) {
            const int g = mesh_.twin(h);
            if (g > h && block_of(h / 3) != block_of(g / 3)) {
                found.push_back(h);
            }
        }
    });
    for (const int h : cuts) {
        const int g = mesh_.twin(h);
        const int s = mesh_.add_segment(-1, {mesh_.vertex_of(h), mesh_.vertex_of(ClassifiedMesh::next(h))}, {0.0, 0.0});
        for (const int side : {h, g}) {
            mesh_.twin_[side] = mesh_.add_side(s, static_cast<int>(mesh_.segments_[s].uses.size()));
            mesh_.segments_[s].uses.push_back({side, -1});
        }
    }
}

void MeshBlocks::reserve(const std::vector<std::size_t>& insertions) {
    int all = 0;
    for (std::size_t k = 0; k < count_; ++k) {
        shares_.push_back({vertices_ + all, sites_ + all, triangles_ + 2 * all, numbers_});
        new_vertices_.push_back({shares_.back().vertex});
        new_sites_.push_back({shares_.back().site});
        new_triangles_.push_back({shares_.back().triangle});
        all += static_cast<int>(insertions[k]);
    }
    const auto triangles = static_cast<std::size_t>(triangles_ + 2 * all);
    mesh_.points_.resize(static_cast<std::size_t>(vertices_ + all));
    mesh_.entities_.resize(static_cast<std::size_t>(vertices_ + all));
    mesh_.sites_.resize(static_cast<std::size_t>(sites_ + all));
    mesh_.corner_.resize(3 * triangles);
    mesh_.twin_.resize(3 * triangles);
    mesh_.number_.resize(3 * triangles);
    mesh_.face_.resize(triangles, -1);
    dropped_stamps_.assign(mesh_.stamp_.begin() + triangles_, mesh_.stamp_.end());
    mesh_.stamp_.resize(static_cast<std::size_t>(triangles_));
    mesh_.stamp_.resize(triangles, 0);
}

// How much of its room each share has used.
void MeshBlocks::measure_shares() {
    Range vertices{vertices_};
    Range sites{sites_};
    Range triangles{triangles_};
    int numbers = 0;
    // `all.first` is where the elements of the block go.
    const auto close_gap = [](Range& range, int end, Range& all) {
        range.shift = range.first - all.first;
        all.first += end - range.first;
    };
    for (std::size_t k = 0; k < count_; ++k) {
        close_gap(new_vertices_[k], shares_[k].vertex, vertices);
        close_gap(new_sites_[k], shares_[k].site, sites);
        close_gap(new_triangles_[k], shares_[k].triangle, triangles);
        new_numbers_.push_back(numbers);
        numbers += shares_[k].number - numbers_;
    }
    mesh_.numbers_ = numbers_ + numbers;
}

std::size_t MeshBlocks::block_with(const std::vector<Range>& ranges, int index) {
    const auto after = std::upper_bound(ranges.begin(), ranges.end(), index,
                                        [](int value, const Range& range) { return value < range.first; });
    return static_cast<std::size_t>(after - ranges.begin()) - 1;
}

int MeshBlocks::moved(const std::vector<Range>& ranges, int index, int first_new) {
    return index < first_new ? index : index - ranges[block_with(ranges, index)].shift;
}

int MeshBlocks::joined_vertex(std::size_t block, int vertex) const {
    return vertex < vertices_ ? vertex : vertex - new_vertices_[block].shift;
}

// Gives the triangle the present indices of its corners and neighbours, and tells segments its own. Changes what is
// its own only.
void MeshBlocks::renumber(int triangle) {
    const int index = moved(new_triangles_, triangle, triangles_);
    const std::size_t block = triangle < triangles_ ? block_of(triangle) : block_with(new_triangles_, triangle);
    for (int k = 0; k < 3; ++k) {
        const int h = 3 * triangle + k;
        mesh_.corner_[h] = moved(new_sites_, mesh_.corner_[h], sites_);
        mesh_.number_[h] += mesh_.number_[h] < numbers_ ? 0 : new_numbers_[block];
        if (mesh_.twin_[h] >= 0) {
            mesh_.twin_[h] = 3 * moved(new_triangles_, mesh_.twin_[h] / 3, triangles_) + mesh_.twin_[h] % 3;
        } else if (index != triangle) {
            const ClassifiedMesh::SegmentSide side = mesh_.sides_[~mesh_.twin_[h]];
            mesh_.segments_[side.segment].uses[side.slot].half_edge = 3 * index + k;
        }
    }
}

void MeshBlocks::move_elements() {
    for (std::size_t k = 0; k < count_; ++k) {
        for (int s = new_sites_[k].first; s < shares_[k].site; ++s) {
            mesh_.sites_[s].vertex = joined_vertex(k, mesh_.sites_[s].vertex);
        }
        move(mesh_.points_, new_vertices_[k], shares_[k].vertex, 1);
        move(mesh_.entities_, new_vertices_[k], shares_[k].vertex, 1);
        move(mesh_.sites_, new_sites_[k], shares_[k].site, 1);
        move(mesh_.corner_, new_triangles_[k], shares_[k].triangle, 3);
        move(mesh_.twin_, new_triangles_[k], shares_[k].triangle, 3);
        move(mesh_.number_, new_triangles_[k], shares_[k].triangle, 3);
        move(mesh_.face_, new_triangles_[k], shares_[k].triangle, 1);
        move(mesh_.stamp_, new_triangles_[k], shares_[k].triangle, 1);
    }
    const auto shrink = [&](auto& values, int count) { values.resize(static_cast<std::size_t>(count)); };
    const int triangles = shares_.back().triangle - new_triangles_.back().shift;
    shrink(mesh_.points_, shares_.back().vertex - new_vertices_.back().shift);
    shrink(mesh_.entities_, shares_.back().vertex - new_vertices_.back().shift);
    shrink(mesh_.sites_, shares_.back().site - new_sites_.back().shift);
    shrink(mesh_.corner_, 3 * triangles);
    shrink(mesh_.twin_, 3 * triangles);
    shrink(mesh_.number_, 3 * triangles);
    shrink(mesh_.face_, triangles);
    shrink(mesh_.stamp_, triangles);
    // Marks of triangles that had the indices before must not hold for these.
    for (std::size_t i = 0; i < dropped_stamps_.size(); ++i) {
        const std::size_t t = static_cast<std::size_t>(triangles_) + i;
        if (t < mesh_.stamp_.size()) {
            mesh_.stamp_[t] += dropped_stamps_[i] + 1;
        } else {
            mesh_.stamp_.push_back(dropped_stamps_[i]);
        }
    }
}

std::vector<int> MeshBlocks::join() {
    measure_shares();
    for_each_in_ranges(static_cast<std::size_t>(mesh_.triangle_count()), [&](std::size_t t) {
        if (!mesh_.gone(static_cast<int>(t))) {
            renumber(static_cast<int>(t));
        }
    });
    move_elements();
    std::vector<int> joined;
    for (int s = first_cut_; s < mesh_.segment_count(); ++s) {
        const auto& uses = mesh_.segments_[s].uses;
        const int h = uses[0].half_edge;
        joined.push_back(h);
        mesh_.twin_[h] = uses[1].half_edge;
        mesh_.twin_[uses[1].half_edge] = h;
    }
    const std::size_t cuts = joined.size();
    mesh_.segments_.resize(static_cast<std::size_t>(first_cut_));
    mesh_.sides_.resize(mesh_.sides_.size() - 2 * cuts);
    return joined;
}

}  // namespace mq::triangulate
