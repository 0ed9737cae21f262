// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "triangulate/surface_samples.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Applies every legal operation at random, at random places.
class Shaker {
  public:
    Shaker(ClassifiedMesh& mesh, std::uint64_t seed) : mesh_(mesh), random_(seed) {}

    void step() {
        const int h = pick(mesh_.half_edge_count());
        switch (pick(3)) {
            case 0:
                split_triangle(h / 3);
                break;
            case 1:
                split_segment(pick(mesh_.segment_count()));
                break;
            default:
                if (legal_swap(h)) {
                    mesh_.swap(h);
                }
        }
    }

    void split_triangle(int t) {
        const Vec2 uv = (uv_of(3 * t) + uv_of(3 * t + 1) + uv_of(3 * t + 2)) / 3.0;
        const Vec3 p = (mesh_.point_of(3 * t) + mesh_.point_of(3 * t + 1) + mesh_.point_of(3 * t + 2)) / 3.0;
        mesh_.split_triangle(t, mesh_.add_site({mesh_.add_vertex(p, {2, mesh_.face_of(t)}), uv, Vec3(0, 0, 1)}));
    }

    int split_segment(int s) {
        const ClassifiedMesh::Segment old = mesh_.segment(s);
        const int vertex = mesh_.add_vertex(middle(old.uses.front().half_edge), {1, old.edge});
        std::vector<int> sites;
        for (const ClassifiedMesh::SegmentUse& use : old.uses) {
            sites.push_back(mesh_.add_site({vertex, middle_uv(use.half_edge), Vec3(0, 0, 1)}));
        }
        return mesh_.split_segment(s, vertex, 0.5 * (old.t[0] + old.t[1]), sites);
    }

    /// Excludes swaps that create an edge from a vertex to itself, or a site inside a face with fewer than three
    /// edges.
    bool legal_swap(int h) const {
        const int g = mesh_.twin(h);
        if (g < 0 || mesh_.vertex_of(ClassifiedMesh::prev(h)) == mesh_.vertex_of(ClassifiedMesh::prev(g))) {
            return false;
        }
        for (const int end : {h, ClassifiedMesh::next(h)}) {
            const std::vector<int> star = mesh_.star(end);
            if (star.size() <= 3 && mesh_.segment_of(star.front()) < 0) {
                return false;
            }
        }
        return true;
    }

  private:
    int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    Vec2 uv_of(int h) const { return mesh_.site(mesh_.site_of(h)).uv; }
    Vec2 middle_uv(int h) const { return 0.5 * (uv_of(h) + uv_of(ClassifiedMesh::next(h))); }
    Vec3 middle(int h) const { return 0.5 * (mesh_.point_of(h) + mesh_.point_of(ClassifiedMesh::next(h))); }

    ClassifiedMesh& mesh_;
    std::mt19937_64 random_;
};

struct Sample {
    const char* name;
    ClassifiedMesh mesh;
};

inline std::vector<Sample> all_samples() {
    return {{"sheet", samples::sheet(3, 2)},
            {"two pages", samples::book(2, 2, 2)},
            {"three pages", samples::book(3, 2, 1)},
            {"tube", samples::tube(4, 2)}};
}

}  // namespace mq::triangulate
