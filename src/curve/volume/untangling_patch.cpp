// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/untangling_patch.h"

#include <algorithm>

#include "elements/bezier/blending.h"

namespace mq::curve {

using elements::EdgeKey;
using elements::Exponents;
using elements::Lattice;

namespace {

/// The edges of a tetrahedron by its corners.
constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
/// The faces of a tetrahedron by its corners.
constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};

}  // namespace

UntanglingPatch::UntanglingPatch(TetrahedralMesh& volume, const std::vector<int>& tetrahedra,
                                 const std::unordered_set<int>& loose, int degree, const Progress& progress)
    : volume_(volume),
      lattice_(Lattice::of(3, degree)),
      members_(tetrahedra),
      loose_(loose),
      is_member_(tetrahedra.begin(), tetrahedra.end()) {
    for (const int t : members_) {
        progress.check();
        add_element(t);
    }
}

/// The inner control points of an edge, of the patch's degree.
std::vector<Vec3> UntanglingPatch::edge_points(int a, int b) const {
    std::vector<Vec3> inner = volume_.shapes().edge_inner(a, b);
    if (volume_.shapes().order() == lattice_.degree()) {
        return inner;
    }
    const Lattice& lattice = Lattice::of(1, volume_.shapes().order());
    const Vec3 ends = 0.5 * (volume_.point(a) + volume_.point(b));
    inner.insert(inner.begin(), volume_.point(a));
    inner.push_back(volume_.point(b));
    return {2.0 * elements::value(lattice, inner, {0.5, 0.5, 0.0, 0.0}) - ends};
}

/// The inner control points of a free edge, of the mesh's order.
std::vector<Vec3> UntanglingPatch::raised(const FreeEdge& edge) const {
    std::vector<Vec3> inner;
    for (const int p : edge.points) {
        inner.push_back(points_[static_cast<std::size_t>(p)]);
    }
    const int q = volume_.shapes().order();
    if (q == lattice_.degree()) {
        return inner;
    }
    // A quadratic with control points a, c, b in Bernstein form of degree q.
    const Vec3& a = volume_.point(edge.a);
    const Vec3& b = volume_.point(edge.b);
    const Vec3 bulge = 0.5 * (inner.front() - 0.5 * (a + b));
    inner.clear();
    for (int k = 1; k < q; ++k) {
        inner.push_back(a + (b - a) * (static_cast<double>(k) / q) + bulge * (4.0 * k * (q - k) / (q * (q - 1.0))));
    }
    return inner;
}

int UntanglingPatch::add_point(const Vec3& p, bool free) {
    points_.push_back(p);
    slot_.push_back(free ? static_cast<int>(free_.size()) : -1);
    const int index = static_cast<int>(points_.size()) - 1;
    if (free) {
        free_.push_back(index);
    }
    return index;
}

bool UntanglingPatch::inside_edge(int a, int b) const {
    const std::vector<int> around = volume_.of_edge(a, b);
    return !volume_.fixed_edge(a, b) &&
           std::all_of(around.begin(), around.end(), [&](int t) { return is_member_.count(t) > 0; });
}

bool UntanglingPatch::inside_face(int a, int b, int c) const {
    const std::vector<int> beside = volume_.of_face(a, b, c);
    return !volume_.fixed_face(a, b, c) &&
           std::all_of(beside.begin(), beside.end(), [&](int t) { return is_member_.count(t) > 0; });
}

void UntanglingPatch::add_element(int t) {
    const std::array<int, 4>& v = volume_.tetrahedra[static_cast<std::size_t>(t)].corners;
    const int q = lattice_.degree();
    std::vector<int> index(static_cast<std::size_t>(lattice_.size()), -1);
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [found, fresh] = points_of_vertex_.emplace(v[k], -1);
        if (fresh) {
            found->second = add_point(volume_.point(v[k]), loose_.count(v[k]) > 0);
        }
        index[static_cast<std::size_t>(lattice_.corner(static_cast<int>(k)))] = found->second;
    }
    for (const auto& edge : kEdges) {
        const std::size_t low = v[edge[0]] < v[edge[1]] ? edge[0] : edge[1];
        const std::size_t high = low == edge[0] ? edge[1] : edge[0];
        const auto [found, fresh] = points_of_edge_.try_emplace(pair_key(v[low], v[high]));
        if (fresh) {
            const bool free = inside_edge(v[low], v[high]);
            for (const Vec3& p : edge_points(v[low], v[high])) {
                found->second.push_back(add_point(p, free));
            }
            if (free) {
                edges_.push_back({v[low], v[high], found->second});
            }
        }
        for (int m = 1; m < q; ++m) {
            Exponents e{0, 0, 0, 0};
            e[low] = q - m;
            e[high] = m;
            index[static_cast<std::size_t>(lattice_.index(e))] = found->second[static_cast<std::size_t>(m - 1)];
        }
    }
    for (std::size_t f = 0; f < kFaces.size() && q > 2; ++f) {
        add_face(v, kFaces[f], index);
    }
    points_of_.push_back(std::move(index));
    reference_.push_back(volume_.reference_jacobian(v));
}

void UntanglingPatch::add_face(const std::array<int, 4>& v, const std::array<std::size_t, 3>& face,
                               std::vector<int>& index) {
    const Lattice& face_lattice = Lattice::of(2, lattice_.degree());
    std::array<std::size_t, 3> local = face;
    std::sort(local.begin(), local.end(), [&](std::size_t x, std::size_t y) { return v[x] < v[y]; });
    const std::array<int, 3> corners{v[local[0]], v[local[1]], v[local[2]]};
    const auto [found, fresh] = points_of_face_.try_emplace(corners);
    const bool free = fresh && inside_face(corners[0], corners[1], corners[2]);
    std::vector<Vec3> control;
    if (fresh) {
        volume_.shapes().triangle(corners, control);
    }
    std::size_t next = 0;
    for (int i = 0; i < face_lattice.size(); ++i) {
        if (face_lattice.carriers(i) < 3) {
            continue;
        }
        if (fresh) {
            found->second.push_back(add_point(control[static_cast<std::size_t>(i)], free));
        }
        Exponents e{0, 0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k) {
            e[local[k]] = face_lattice.exponents(i)[k];
        }
        index[static_cast<std::size_t>(lattice_.index(e))] = found->second[next++];
    }
    if (free) {
        faces_.push_back({corners, found->second});
    }
}

Eigen::VectorXd UntanglingPatch::state() const {
    Eigen::VectorXd state(static_cast<Eigen::Index>(3 * free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
        state.segment<3>(static_cast<Eigen::Index>(3 * i)) = points_[static_cast<std::size_t>(free_[i])];
    }
    return state;
}

void UntanglingPatch::set_state(const Eigen::VectorXd& state) {
    for (std::size_t i = 0; i < free_.size(); ++i) {
        points_[static_cast<std::size_t>(free_[i])] = state.segment<3>(static_cast<Eigen::Index>(3 * i));
    }
}

bool UntanglingPatch::is_free(std::size_t i, int p) const {
    const auto free = [&](int point) { return point >= 0 && slot_[static_cast<std::size_t>(point)] >= 0; };
    const std::vector<int>& index = points_of_[i];
    const int point = index[static_cast<std::size_t>(p)];
    return point < 0 ? std::any_of(index.begin(), index.end(), free) : free(point);
}

void UntanglingPatch::gather(std::size_t i, std::vector<Vec3>& control) const {
    const std::vector<int>& index = points_of_[i];
    control.resize(index.size());
    bool blended = false;
    for (std::size_t k = 0; k < index.size(); ++k) {
        if (index[k] >= 0) {
            control[k] = points_[static_cast<std::size_t>(index[k])];
        } else {
            blended = true;
        }
    }
    if (blended) {
        elements::blend_tetrahedron(lattice_, control);
    }
}

void UntanglingPatch::scatter(std::size_t i, const std::vector<Vec3>& by_control, Eigen::VectorXd& gradient) const {
    const std::vector<int>& index = points_of_[i];
    for (std::size_t k = 0; k < index.size(); ++k) {
        const int slot = index[k] < 0 ? -1 : slot_[static_cast<std::size_t>(index[k])];
        if (slot >= 0) {
            gradient.segment<3>(3 * slot) += by_control[k];
        }
    }
}

void UntanglingPatch::propagate_curvature(int sweeps) {
    const int q = lattice_.degree();
    if (edges_.empty() || q < 2) {
        return;
    }
    // The bulge of an edge: its middle less the mean of its ends.
    std::unordered_map<EdgeKey, Vec3> bulge;
    const std::vector<double> middle = elements::bernstein_values(Lattice::of(1, q), {0.5, 0.5, 0.0, 0.0});
    for (const auto& [key, points] : points_of_edge_) {
        const Vec3& a = volume_.point(static_cast<int>(key >> 32));
        const Vec3& b = volume_.point(static_cast<int>(key & 0xffffffffu));
        Vec3 at = (middle.front() - 0.5) * a + (middle.back() - 0.5) * b;
        for (std::size_t k = 0; k < points.size(); ++k) {
            at += middle[k + 1] * points_[static_cast<std::size_t>(points[k])];
        }
        bulge[key] = at;
    }
    std::vector<std::vector<EdgeKey>> around(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        for (const int t : volume_.of_edge(edges_[i].a, edges_[i].b)) {
            for (const int c : volume_.tetrahedra[static_cast<std::size_t>(t)].corners) {
                if (c != edges_[i].a && c != edges_[i].b) {
                    around[i].push_back(pair_key(edges_[i].a, c));
                    around[i].push_back(pair_key(edges_[i].b, c));
                }
            }
        }
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            Vec3 sum = Vec3::Zero();
            for (const EdgeKey key : around[i]) {
                sum += bulge.at(key);
            }
            bulge[pair_key(edges_[i].a, edges_[i].b)] = sum / static_cast<double>(around[i].size());
        }
    }
    for (const FreeEdge& edge : edges_) {
        const Vec3& a = volume_.point(edge.a);
        const Vec3& b = volume_.point(edge.b);
        const Vec3& m = bulge.at(pair_key(edge.a, edge.b));
        for (int k = 1; k < q; ++k) {
            const double s = static_cast<double>(k) / q;
            points_[static_cast<std::size_t>(edge.points[static_cast<std::size_t>(k - 1)])] =
                a + s * (b - a) + m * (4.0 * k * (q - k) / (q * (q - 1.0)));
        }
    }
    reblend_faces();
}

void UntanglingPatch::reblend_faces() {
    const int q = lattice_.degree();
    const Lattice& lattice = Lattice::of(2, q);
    for (const FreeFace& face : faces_) {
        std::vector<Vec3> control(static_cast<std::size_t>(lattice.size()), Vec3::Zero());
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = (i + 1) % 3;
            control[static_cast<std::size_t>(lattice.corner(static_cast<int>(i)))] = volume_.point(face.corners[i]);
            const std::vector<int>& points = points_of_edge_.at(pair_key(face.corners[i], face.corners[k]));
            for (int m = 1; m < q; ++m) {
                Exponents e{0, 0, 0, 0};
                e[i] = face.corners[i] < face.corners[k] ? q - m : m;
                e[k] = q - e[i];
                control[static_cast<std::size_t>(lattice.index(e))] =
                    points_[static_cast<std::size_t>(points[static_cast<std::size_t>(m - 1)])];
            }
        }
        elements::blend_triangle(lattice, control);
        std::size_t next = 0;
        for (int i = 0; i < lattice.size(); ++i) {
            if (lattice.carriers(i) == 3) {
                points_[static_cast<std::size_t>(face.points[next++])] = control[static_cast<std::size_t>(i)];
            }
        }
    }
}

int UntanglingPatch::move_vertices() {
    int moved = 0;
    for (const auto& [v, point] : points_of_vertex_) {
        Vec3& place = volume_.shapes().vertices[static_cast<std::size_t>(v)].point;
        if (place != points_[static_cast<std::size_t>(point)]) {
            place = points_[static_cast<std::size_t>(point)];
            ++moved;
        }
    }
    return moved;
}

/// The faces are blended from their new edges.
void UntanglingPatch::forget_inner_faces() {
    for (const int t : members_) {
        const std::array<int, 4>& v = volume_.tetrahedra[static_cast<std::size_t>(t)].corners;
        for (const auto& face : kFaces) {
            const std::array<int, 3> corners{v[face[0]], v[face[1]], v[face[2]]};
            if (volume_.shapes().has_face(corners) && inside_face(corners[0], corners[1], corners[2])) {
                volume_.shapes().forget_face(corners);
            }
        }
    }
}

int UntanglingPatch::store(const Progress& progress) {
    const int moved = move_vertices();
    for (const FreeEdge& edge : edges_) {
        volume_.shapes().set_edge(edge.a, edge.b, raised(edge));
    }
    for (const FreeFace& face : faces_) {
        std::vector<Vec3> inner;
        for (const int p : face.points) {
            inner.push_back(points_[static_cast<std::size_t>(p)]);
        }
        volume_.shapes().set_face(face.corners, inner);
    }
    if (lattice_.degree() < volume_.shapes().order()) {
        forget_inner_faces();
    }
    volume_.measure(members_, &progress);
    return moved;
}

}  // namespace mq::curve
