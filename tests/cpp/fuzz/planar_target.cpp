// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The constrained Delaunay triangulation of arbitrary points and constraints.
#include <vector>

#include "base/predicates.h"
#include "bytes.h"
#include "triangulate/initial/constrained_delaunay.h"

namespace mq::geometry {
namespace {

using Planar = triangulate::ConstrainedDelaunay;

void check_edge(const Planar& planar, int h) {
    const int g = planar.twin(h);
    if (g < 0) {
        return;
    }
    fuzz::require(planar.twin(g) == h && planar.label(g) == planar.label(h), "half-edges are twins both ways");
    fuzz::require(planar.corner(g) == planar.corner(Planar::next(h)), "twins have the same ends");
    if (planar.label(h) < 0) {
        fuzz::require(
            in_circle(planar.point(planar.corner(h)), planar.point(planar.corner(Planar::next(h))),
                      planar.point(planar.corner(Planar::prev(h))), planar.point(planar.corner(Planar::prev(g)))) <= 0,
            "edges without constraint are Delaunay");
    }
}

void check(const Planar& planar) {
    fuzz::require(planar.triangle_count() == 2 * planar.vertex_count() - 6, "Euler's formula holds");
    for (int h = 0; h < 3 * planar.triangle_count(); ++h) {
        if (h % 3 == 0) {
            fuzz::require(orient2d(planar.point(planar.corner(h)), planar.point(planar.corner(h + 1)),
                                   planar.point(planar.corner(h + 2))) > 0,
                          "triangles are counter-clockwise");
        }
        check_edge(planar, h);
    }
}

}  // namespace
}  // namespace mq::geometry

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    constexpr double kBox = 128.0;
    constexpr std::size_t kPoints = 60;
    fuzz::Bytes bytes(data, size);
    triangulate::ConstrainedDelaunay planar(Vec2(-kBox, -kBox), Vec2(kBox, kBox));
    std::vector<int> vertices;
    Vec2 before = Vec2::Zero();
    while (bytes.left() > 0 && vertices.size() < kPoints) {
        const int what = bytes.number(0, 3);
        if (what == 0 && vertices.size() > 1) {
            const int last = static_cast<int>(vertices.size()) - 1;
            const int a = vertices[static_cast<std::size_t>(bytes.number(0, last))];
            const int b = vertices[static_cast<std::size_t>(bytes.number(0, last))];
            if (a != b) {
                planar.insert_constraint(a, b, static_cast<int>(vertices.size()));
            }
            continue;
        }
        for (int i = 0; i < 2; ++i) {
            const double value = bytes.near(before[i]);
            before[i] = std::abs(value) <= kBox ? value : 0.0;
        }
        const int v = what == 1 ? planar.insert_off_constraints(before) : planar.insert(before);
        if (v >= 0) {
            fuzz::require(planar.point(v) == before, "an inserted point is where it was asked for");
            vertices.push_back(v);
        }
    }
    geometry::check(planar);
    return 0;
}
