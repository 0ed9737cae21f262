// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/curved_shapes.h"

#include <algorithm>

#include "elements/bezier/blending.h"

namespace mq::elements {

namespace {

/// Corner positions (0, 1, 2) in the order of ascending vertices.
std::array<std::size_t, 3> ascending(const std::array<int, 3>& corners) {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return corners[x] < corners[y]; });
    return order;
}

}  // namespace

FaceKey face_key(int a, int b, int c) {
    FaceKey key{a, b, c};
    std::sort(key.begin(), key.end());
    return key;
}

CurvedShapes::CurvedShapes(int order) : order_(order) {
    const Lattice& lattice = Lattice::of(2, order);
    for (int i = 0; i < lattice.size(); ++i) {
        if (lattice.carriers(i) == 3) {
            inner_.push_back(i);
        }
    }
}

void CurvedShapes::set_edge(int a, int b, const std::vector<Vec3>& inner) {
    std::vector<Vec3> control = inner;
    if (a > b) {
        std::reverse(control.begin(), control.end());
    }
    edges_[pair_key(a, b)] = std::move(control);
}

void CurvedShapes::forget_edge(int a, int b) {
    edges_.erase(pair_key(a, b));
}

std::vector<Vec3> CurvedShapes::edge_inner(int a, int b) const {
    const auto found = edges_.find(pair_key(a, b));
    if (found == edges_.end()) {
        const Vec3& from = vertices[static_cast<std::size_t>(std::min(a, b))].point;
        const Vec3& to = vertices[static_cast<std::size_t>(std::max(a, b))].point;
        std::vector<Vec3> inner;
        for (int i = 1; i < order_; ++i) {
            inner.push_back(from + (to - from) * (static_cast<double>(a < b ? i : order_ - i) / order_));
        }
        return inner;
    }
    std::vector<Vec3> inner = found->second;
    if (a > b) {
        std::reverse(inner.begin(), inner.end());
    }
    return inner;
}

void CurvedShapes::set_face(const std::array<int, 3>& corners, const std::vector<Vec3>& inner) {
    const Lattice& lattice = Lattice::of(2, order_);
    const auto order = ascending(corners);
    std::vector<Vec3> sorted(inner.size());
    for (std::size_t i = 0; i < inner_.size(); ++i) {
        const Exponents& e = lattice.exponents(inner_[i]);
        const Exponents turned{e[order[0]], e[order[1]], e[order[2]], 0};
        const auto at = std::lower_bound(inner_.begin(), inner_.end(), lattice.index(turned)) - inner_.begin();
        sorted[static_cast<std::size_t>(at)] = inner[i];
    }
    faces_[face_key(corners[0], corners[1], corners[2])] = std::move(sorted);
}

void CurvedShapes::set_inside(const std::array<int, 3>& corners, const std::vector<Vec3>& control) {
    std::vector<Vec3> inside;
    for (const int i : inner_) {
        inside.push_back(control[static_cast<std::size_t>(i)]);
    }
    set_face(corners, inside);
}

void CurvedShapes::forget_face(const std::array<int, 3>& corners) {
    faces_.erase(face_key(corners[0], corners[1], corners[2]));
}

bool CurvedShapes::has_face(const std::array<int, 3>& corners) const {
    return faces_.count(face_key(corners[0], corners[1], corners[2])) > 0;
}

void CurvedShapes::place_edge(const Lattice& lattice, int a, int b, std::size_t i, std::size_t k,
                              std::vector<Vec3>& control) const {
    if (a > b) {
        std::swap(a, b);
        std::swap(i, k);
    }
    const auto found = edges_.find(pair_key(a, b));
    const Vec3& from = vertices[static_cast<std::size_t>(a)].point;
    const Vec3& to = vertices[static_cast<std::size_t>(b)].point;
    for (int m = 1; m < order_; ++m) {
        Exponents e{0, 0, 0, 0};
        e[i] = order_ - m;
        e[k] = m;
        control[static_cast<std::size_t>(lattice.index(e))] =
            found != edges_.end() ? found->second[static_cast<std::size_t>(m - 1)]
                                  : from + (to - from) * (static_cast<double>(m) / order_);
    }
}

void CurvedShapes::triangle(const std::array<int, 3>& given, std::vector<Vec3>& control) const {
    const Lattice& lattice = Lattice::of(2, order_);
    const auto order = ascending(given);
    const std::array<int, 3> corners{given[order[0]], given[order[1]], given[order[2]]};
    std::vector<Vec3> sorted(static_cast<std::size_t>(lattice.size()));
    for (std::size_t i = 0; i < 3; ++i) {
        sorted[static_cast<std::size_t>(lattice.corner(static_cast<int>(i)))] =
            vertices[static_cast<std::size_t>(corners[i])].point;
        place_edge(lattice, corners[i], corners[(i + 1) % 3], i, (i + 1) % 3, sorted);
    }
    if (!inner_.empty()) {
        const auto found = faces_.find({corners[0], corners[1], corners[2]});
        if (found == faces_.end()) {
            blend_triangle(lattice, sorted);
        } else {
            for (std::size_t i = 0; i < inner_.size(); ++i) {
                sorted[static_cast<std::size_t>(inner_[i])] = found->second[i];
            }
        }
    }
    control.resize(sorted.size());
    for (int i = 0; i < lattice.size(); ++i) {
        const Exponents& e = lattice.exponents(i);
        Exponents turned{0, 0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k) {
            turned[order[k]] = e[k];
        }
        control[static_cast<std::size_t>(lattice.index(turned))] = sorted[static_cast<std::size_t>(i)];
    }
}

void CurvedShapes::tetrahedron(const std::array<int, 4>& corners, std::vector<Vec3>& control) const {
    // The faces of a tetrahedron by its corners.
    static constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
    const Lattice& lattice = Lattice::of(3, order_);
    control.resize(static_cast<std::size_t>(lattice.size()));
    for (std::size_t i = 0; i < 4; ++i) {
        control[static_cast<std::size_t>(lattice.corner(static_cast<int>(i)))] =
            vertices[static_cast<std::size_t>(corners[i])].point;
        for (std::size_t k = i + 1; k < 4; ++k) {
            place_edge(lattice, corners[i], corners[k], i, k, control);
        }
    }
    if (order_ < 3) {
        return;
    }
    const Lattice& face_lattice = Lattice::of(2, order_);
    std::vector<Vec3> face;
    for (const auto& f : kFaces) {
        triangle({corners[f[0]], corners[f[1]], corners[f[2]]}, face);
        for (const int i : inner_) {
            Exponents e{0, 0, 0, 0};
            for (std::size_t k = 0; k < 3; ++k) {
                e[f[k]] = face_lattice.exponents(i)[k];
            }
            control[static_cast<std::size_t>(lattice.index(e))] = face[static_cast<std::size_t>(i)];
        }
    }
    if (order_ >= 4) {
        blend_tetrahedron(lattice, control);
    }
}

}  // namespace mq::elements
