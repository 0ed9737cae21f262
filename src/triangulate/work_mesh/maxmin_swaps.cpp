// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/maxmin_swaps.h"

#include <algorithm>

#include "base/predicates.h"
#include "triangulate/work_mesh/tuning.h"

namespace mq::triangulate {

MaxMinSwaps::MaxMinSwaps(ClassifiedMesh& mesh) : mesh_(mesh) {
    rebuild();
}

void MaxMinSwaps::rebuild() {
    pairs_ = {};
    doubled_ = 0;
    for (int s = 0; s < mesh_.segment_count(); ++s) {
        if (!mesh_.segment(s).uses.empty()) {
            remember(mesh_.segment(s).vertices[0], mesh_.segment(s).vertices[1]);
        }
    }
    using Pairs = std::vector<std::array<int, 2>>;
    const auto count = static_cast<std::size_t>(mesh_.half_edge_count());
    const auto pairs = found_in_ranges<Pairs>(count, [&](std::size_t from, std::size_t to, Pairs& found) {
        for (int h = static_cast<int>(from); h < static_cast<int>(to); ++h) {
            if (mesh_.twin(h) > h && !mesh_.gone(ClassifiedMesh::triangle_of(h))) {
                const int a = mesh_.vertex_of(h);
                const int b = mesh_.vertex_of(ClassifiedMesh::next(h));
                if (may_be_doubled(a, b)) {
                    found.push_back({a, b});
                }
            }
        }
    });
    for (const auto& [a, b] : pairs) {
        remember(a, b);
    }
}

int MaxMinSwaps::edges_between(int a, int b) const {
    const auto found = pairs_.find(pair_key(a, b));
    return (found == pairs_.end() ? 0 : found->second) + (whole_ != nullptr ? whole_->edges_between(a, b) : 0);
}

void MaxMinSwaps::remember(int a, int b) {
    if (may_be_doubled(a, b) && ++pairs_[pair_key(a, b)] == 2 && whole_ == nullptr) {
        ++doubled_;
    }
}

void MaxMinSwaps::forget(int a, int b) {
    if (!may_be_doubled(a, b)) {
        return;
    }
    if (whole_ != nullptr) {
        --pairs_[pair_key(a, b)];
        return;
    }
    const auto found = pairs_.find(pair_key(a, b));
    if (found == pairs_.end()) {
        return;
    }
    const int left = --found.value();
    if (left == 1) {
        --doubled_;
    } else if (left == 0) {
        pairs_.erase(found);
    }
}

bool MaxMinSwaps::is_doubled(int h) const {
    const auto found = pairs_.find(pair_key(mesh_.vertex_of(h), mesh_.vertex_of(ClassifiedMesh::next(h))));
    return found != pairs_.end() && found->second > 1;
}

std::vector<int> MaxMinSwaps::doubled_edges() const {
    std::vector<int> result;
    for (int h = 0; doubled_ > 0 && h < mesh_.half_edge_count(); ++h) {
        if (mesh_.twin(h) > h && !mesh_.gone(ClassifiedMesh::triangle_of(h)) && is_doubled(h)) {
            result.push_back(h);
        }
    }
    return result;
}

bool MaxMinSwaps::legal(int h, double least) const {
    const int g = mesh_.twin(h);
    const int a = mesh_.site_of(h);
    const int b = mesh_.site_of(ClassifiedMesh::next(h));
    const int c = mesh_.site_of(ClassifiedMesh::prev(h));
    const int d = mesh_.site_of(ClassifiedMesh::prev(g));
    const int vc = mesh_.site(c).vertex;
    const int vd = mesh_.site(d).vertex;
    if (vc == vd || joined(vc, vd)) {
        return false;
    }
    const Corner ca = corner_of(mesh_, a);
    const Corner cb = corner_of(mesh_, b);
    const Corner cc = corner_of(mesh_, c);
    const Corner cd = corner_of(mesh_, d);
    const double after = std::min(alignment(ca, cd, cc), alignment(cd, cb, cc));
    if (after < least) {
        const double before = std::min(alignment(ca, cb, cc), alignment(cb, ca, cd));
        if (after < before || after <= -1.0) {
            return false;
        }
    }
    // In the plane two vertices visible to each other across an edge are not joined elsewhere, but triangles can be
    // folded.
    return may_be_doubled(vc, vd) || !mesh_.leads_to(ClassifiedMesh::prev(h), vd);
}

void MaxMinSwaps::swap(int h, std::vector<int>& touched) {
    const int t = ClassifiedMesh::triangle_of(h);
    touched.push_back(t);
    touched.push_back(ClassifiedMesh::triangle_of(mesh_.twin(h)));
    forget(mesh_.vertex_of(h), mesh_.vertex_of(ClassifiedMesh::next(h)));
    mesh_.swap(h);
    remember(mesh_.vertex_of(3 * t + 1), mesh_.vertex_of(3 * t + 2));
}

void MaxMinSwaps::book_inner_edges(const std::vector<int>& triangles, void (MaxMinSwaps::*book)(int, int)) {
    for (const int t : triangles) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int other = mesh_.twin(h) < 0 ? -1 : ClassifiedMesh::triangle_of(mesh_.twin(h));
            if (mesh_.twin(h) > h && std::find(triangles.begin(), triangles.end(), other) != triangles.end()) {
                (this->*book)(mesh_.vertex_of(h), mesh_.vertex_of(ClassifiedMesh::next(h)));
            }
        }
    }
}

std::vector<int> MaxMinSwaps::replace(const std::vector<int>& removed, const std::vector<std::array<int, 3>>& added) {
    book_inner_edges(removed, &MaxMinSwaps::forget);
    std::vector<int> indices = mesh_.replace(removed, added);
    book_inner_edges(indices, &MaxMinSwaps::remember);
    return indices;
}

std::array<int, 3> MaxMinSwaps::split_triangle(int triangle, int site) {
    const std::array<int, 3> result = mesh_.split_triangle(triangle, site);
    for (const int t : result) {
        remember(mesh_.site(site).vertex, mesh_.vertex_of(3 * t));
    }
    return result;
}

int MaxMinSwaps::split_segment(int segment, int vertex, double t, const std::vector<int>& sites) {
    const std::array<int, 2> ends = mesh_.segment(segment).vertices;
    forget(ends[0], ends[1]);
    const int far = mesh_.split_segment(segment, vertex, t, sites);
    remember(ends[0], vertex);
    remember(vertex, ends[1]);
    for (const ClassifiedMesh::SegmentUse& use : mesh_.segment(segment).uses) {
        remember(vertex, mesh_.vertex_of(ClassifiedMesh::prev(use.half_edge)));
    }
    return far;
}

std::vector<int> MaxMinSwaps::join_segments(int near, int far, const std::vector<ClassifiedMesh::CavityFill>& refills) {
    for (const int s : {near, far}) {
        forget(mesh_.segment(s).vertices[0], mesh_.segment(s).vertices[1]);
    }
    for (const ClassifiedMesh::CavityFill& refill : refills) {
        book_inner_edges(refill.removed, &MaxMinSwaps::forget);
    }
    std::vector<int> indices = mesh_.join_segments(near, far, refills);
    book_inner_edges(indices, &MaxMinSwaps::remember);
    remember(mesh_.segment(near).vertices[0], mesh_.segment(near).vertices[1]);
    return indices;
}

void MaxMinSwaps::replace_between(int near, int far, int vertex, double t, const std::vector<std::vector<int>>& spokes,
                                  const std::vector<int>& sites) {
    const auto book = [&](void (MaxMinSwaps::*booked)(int, int)) {
        for (const int s : {near, far}) {
            (this->*booked)(mesh_.segment(s).vertices[0], mesh_.segment(s).vertices[1]);
        }
        for (const std::vector<int>& around : spokes) {
            for (const int h : around) {
                if (mesh_.twin(h) >= 0) {
                    (this->*booked)(mesh_.vertex_of(h), mesh_.vertex_of(ClassifiedMesh::next(h)));
                }
            }
        }
    };
    book(&MaxMinSwaps::forget);
    mesh_.replace_between(near, far, vertex, t, spokes, sites);
    book(&MaxMinSwaps::remember);
}

void MaxMinSwaps::restore(std::vector<int>& stack, std::vector<int>& touched, double least) {
    while (!stack.empty()) {
        const int h = stack.back();
        stack.pop_back();
        const int g = mesh_.twin(h);
        if (g < 0) {
            continue;
        }
        const int next = ClassifiedMesh::next(h);
        if (locally_maxmin(mesh_.point_of(h), mesh_.point_of(next), mesh_.point_of(ClassifiedMesh::prev(h)),
                           mesh_.point_of(ClassifiedMesh::prev(g))) ||
            !legal(h, least)) {
            continue;
        }
        const int t = ClassifiedMesh::triangle_of(h);
        const int o = ClassifiedMesh::triangle_of(g);
        swap(h, touched);
        stack.insert(stack.end(), {3 * t, 3 * t + 2, 3 * o, 3 * o + 1});
    }
}

// Visits inner edges once, not from both sides.
void MaxMinSwaps::restore_around(std::size_t first, std::vector<int>& touched) {
    around_.clear();
    const auto from = touched.begin() + static_cast<std::ptrdiff_t>(first);
    for (auto it = from; it != touched.end(); ++it) {
        for (int h = 3 * *it; h < 3 * *it + 3; ++h) {
            const int g = mesh_.twin(h);
            if (g >= 0 && std::find(from, it + 1, ClassifiedMesh::triangle_of(g)) == it + 1) {
                around_.push_back(h);
            }
        }
    }
    restore(around_, touched);
}

void MaxMinSwaps::sweep(std::vector<int>& touched, const TriangleMarks& settled) {
    // A distant swap can separate a pair of vertices that made another swap illegal, so that one sweep may leave
    // violations.
    for (int round = 0; round < WorkMeshTuning::kMaxSweeps; ++round) {
        std::vector<int> stack;
        for (int h = mesh_.half_edge_count() - 1; h >= 0; --h) {
            if (mesh_.twin(h) > h && !settled.marked(mesh_, h / 3)) {
                stack.push_back(h);
            }
        }
        const std::size_t before = touched.size();
        restore(stack, touched);
        if (touched.size() == before) {
            return;
        }
    }
}

}  // namespace mq::triangulate
