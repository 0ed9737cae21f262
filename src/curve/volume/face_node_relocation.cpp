// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "base/tuning.h"
#include "curve/volume/editor.h"
#include "curve/volume/tuning.h"

namespace mq::curve {

using elements::Lattice;

namespace {

/// A face inside a volume, and its inner nodes while they are moved.
class Relocation {
  public:
    Relocation(VolumeEditor& editor, const std::array<int, 3>& corners)
        : volume_(editor.volume),
          corners_(corners),
          around_(volume_.of_face(corners[0], corners[1], corners[2])),
          had_shape_(volume_.shapes().has_face(corners)),
          before_(inner()),
          quality_(worst()) {}

    bool carry_out() {
        // A face without a shape of its own is blended from its edges.
        volume_.shapes().forget_face(corners_);
        double best = worst();
        std::vector<Vec3> kept = inner();
        put(average_of_centroids(volume_.shapes(), corners_));
        const double at_average = worst();
        if (at_average > best) {
            best = at_average;
            kept = inner();
        }
        double step = VolumeTuning::kFirstFaceStep * size();
        for (int halving = 0; halving < VolumeTuning::kHalvings; ++halving, step *= 0.5) {
            while (try_steps(step, best, kept)) {
            }
        }
        if (best > quality_ + kLeastGain) {
            return true;
        }
        put(before_);
        if (!had_shape_) {
            volume_.shapes().forget_face(corners_);
        }
        volume_.measure(around_);
        return false;
    }

  private:
    /// Moves the nodes by a step along the axis that helps most.
    bool try_steps(double step, double& best, std::vector<Vec3>& kept) {
        const std::vector<Vec3> from = kept;
        bool any = false;
        for (int way = 0; way < 6; ++way) {
            std::vector<Vec3> moved = from;
            for (Vec3& p : moved) {
                p[way / 2] += way % 2 == 0 ? step : -step;
            }
            put(moved);
            const double now = worst();
            if (now > best + kLeastGain) {
                best = now;
                kept = moved;
                any = true;
            }
        }
        put(kept);
        worst();
        return any;
    }

    void put(const std::vector<Vec3>& nodes) { volume_.shapes().set_face(corners_, nodes); }

    std::vector<Vec3> inner() const {
        const Lattice& lattice = Lattice::of(2, volume_.shapes().order());
        std::vector<Vec3> control;
        volume_.shapes().triangle(corners_, control);
        std::vector<Vec3> result;
        for (int i = 0; i < lattice.size(); ++i) {
            if (lattice.carriers(i) == 3) {
                result.push_back(control[static_cast<std::size_t>(i)]);
            }
        }
        return result;
    }

    double worst() {
        volume_.measure(around_);
        double least = 1.0;
        for (const int t : around_) {
            least = std::min(least, volume_.tetrahedra[static_cast<std::size_t>(t)].quality);
        }
        return least;
    }

    double size() const {
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 along = volume_.point(corners_[(k + 1) % 3]) - volume_.point(corners_[k]);
            longest = std::max(longest, along.norm());
        }
        return longest;
    }

    TetrahedralMesh& volume_;
    std::array<int, 3> corners_;
    std::vector<int> around_;
    bool had_shape_;
    std::vector<Vec3> before_;
    double quality_;
};

}  // namespace

std::vector<Vec3> average_of_centroids(const elements::CurvedShapes& shapes, const std::array<int, 3>& corners) {
    const int q = shapes.order();
    const Lattice& lattice = Lattice::of(2, q);
    std::vector<Vec3> control;
    shapes.triangle(corners, control);
    std::vector<Vec3> nodes = elements::bezier_to_nodes(lattice, control);
    std::vector<int> inner;
    for (int i = 0; i < lattice.size(); ++i) {
        if (lattice.carriers(i) != 3) {
            continue;
        }
        inner.push_back(i);
        const elements::Exponents& e = lattice.exponents(i);
        Vec3 sum = Vec3::Zero();
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            const double along = static_cast<double>(q * e[b]) / (e[a] + e[b]);
            const int below = static_cast<int>(along);
            const auto edge_node = [&](int k) -> const Vec3& {
                elements::Exponents at{};
                at[a] = q - k;
                at[b] = k;
                return nodes[static_cast<std::size_t>(lattice.index(at))];
            };
            const double part = along - below;
            const Vec3 on_edge = (1.0 - part) * edge_node(below) + part * edge_node(below + 1);
            const std::size_t c = (a + 2) % 3;
            const Vec3& opposite = nodes[static_cast<std::size_t>(lattice.corner(static_cast<int>(c)))];
            sum += on_edge + static_cast<double>(e[c]) / q * (opposite - on_edge);
        }
        nodes[static_cast<std::size_t>(i)] = sum / 3.0;
    }
    control = elements::nodes_to_bezier(lattice, nodes);
    std::vector<Vec3> result;
    for (const int i : inner) {
        result.push_back(control[static_cast<std::size_t>(i)]);
    }
    return result;
}

bool relocate_face_nodes(VolumeEditor& editor, int a, int b, int c) {
    if (editor.volume.shapes().order() < 3 || editor.volume.fixed_face(a, b, c)) {
        return false;
    }
    return Relocation(editor, {a, b, c}).carry_out();
}

}  // namespace mq::curve
