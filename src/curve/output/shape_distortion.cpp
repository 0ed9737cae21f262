// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/output/shape_distortion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <queue>

#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "elements/bezier/jacobian.h"
#include "elements/bezier/sub_simplex.h"
#include "elements/product/reference_nodes.h"

namespace mq::curve {

using elements::halve;
using elements::JacobianForm;
using elements::Lattice;
using elements::ProductTable;

namespace {

/// Simplices at most for each element, so that the search ends near a fold.
constexpr int kMaxPieces = 1000;

double length_of(double value) {
    return value;
}

double length_of(const Vec3& value) {
    return value.norm();
}

/// The numerator of 1 / eta, whose denominator is the sum of the squared edge derivatives; the constants are those of
/// the regular simplex. It is computed from the area of a triangle's map from the reference simplex, or from the
/// Jacobian of a tetrahedron's map.
double weighed(const Vec3&, double area) {
    return 2.0 * std::sqrt(3.0) * area;
}

double weighed(double, double jacobian) {
    return std::copysign(6.0 * std::cbrt(2.0 * jacobian * jacobian), jacobian);
}

/// Coefficients of a polynomial on the same lattice that is nowhere larger than `weighed`: for a normal, its component
/// along the mean direction; for a Jacobian, the chord between its least and largest value, below the concave
/// `weighed`.
void lower_bounds(const std::vector<Vec3>& normal, double rounding, std::vector<double>& bounds) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& c : normal) {
        sum += c;
    }
    const Vec3 direction = sum.normalized();
    for (std::size_t i = 0; i < normal.size(); ++i) {
        bounds[i] = weighed(direction, direction.dot(normal[i]) - rounding);
    }
}

void lower_bounds(const std::vector<double>& jacobian, double rounding, std::vector<double>& bounds) {
    const auto [least, most] = std::minmax_element(jacobian.begin(), jacobian.end());
    const double low = *least - rounding;
    const double high = *most + rounding;
    const double slope =
        low > 0.0 ? (weighed(0.0, high) - weighed(0.0, low)) / std::max(high - low, 1e-12 * high) : 0.0;
    for (std::size_t i = 0; i < jacobian.size(); ++i) {
        bounds[i] = weighed(0.0, low) + slope * (jacobian[i] - *least);
    }
}

/// The least 1 / eta on an element, by halving it where the bound is worst. A quotient of polynomials on one lattice
/// lies between the least and the largest quotient of their Bernstein coefficients.
/// @tparam TetrahedralMesh double: Jacobian; Vec3: normal.
template <typename TetrahedralMesh>
class ShapeSearch {
  public:
    ShapeSearch(const Lattice& lattice, double rounding)
        : lattice_(lattice), rounding_(rounding), bounds_(static_cast<std::size_t>(lattice.size())) {}

    /// @return the reciprocal of the least 1 / eta; infinite where that is not proven to be positive.
    double inverse_of_least(std::vector<TetrahedralMesh> volume, std::vector<double> stretch) {
        push({0.0, 0, std::move(volume), std::move(stretch)});
        while (high_ > 0.0 && queue_.top().low < (1.0 - kDistortionAccuracy) * high_ && serial_ < kMaxPieces) {
            const Piece piece = queue_.top();
            queue_.pop();
            const auto [a, b] = elements::longest_edge(piece.part, lattice_.dimension());
            auto [volume_a, volume_b] = halve(lattice_, piece.volume, a, b);
            auto [stretch_a, stretch_b] = halve(lattice_, piece.stretch, a, b);
            const auto [part_a, part_b] = halve(piece.part, a, b);
            push({0.0, 0, std::move(volume_a), std::move(stretch_a), part_a});
            push({0.0, 0, std::move(volume_b), std::move(stretch_b), part_b});
        }
        return queue_.top().low > 0.0 ? 1.0 / queue_.top().low : std::numeric_limits<double>::infinity();
    }

  private:
    struct Piece {
        double low = 0.0;
        int serial = 0;  // ties go to the older piece, so that the order is fixed
        std::vector<TetrahedralMesh> volume;
        std::vector<double> stretch;
        elements::SimplexPart part = elements::kWholeSimplex;

        bool operator<(const Piece& other) const { return low != other.low ? low > other.low : serial > other.serial; }
    };

    void push(Piece piece) {
        piece.serial = serial_++;
        lower_bounds(piece.volume, rounding_, bounds_);
        piece.low = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < bounds_.size(); ++i) {
            // If the coefficient is not positive, although the polynomial is, it gives no bound.
            if (piece.stretch[i] > 0.0) {
                piece.low = std::min(piece.low, bounds_[i] / piece.stretch[i]);
            }
        }
        for (int k = 0; k <= lattice_.dimension(); ++k) {
            const auto corner = static_cast<std::size_t>(lattice_.corner(k));
            const double attained = weighed(piece.volume[corner], length_of(piece.volume[corner]));
            high_ = std::min(high_, attained > 0.0 ? attained / piece.stretch[corner] : 0.0);
        }
        piece.low = std::min(piece.low, high_);
        queue_.push(std::move(piece));
    }

    const Lattice& lattice_;
    double rounding_;
    std::vector<double> bounds_;
    int serial_ = 0;
    double high_ = std::numeric_limits<double>::infinity();
    std::priority_queue<Piece> queue_;
};

/// The coefficients of the same polynomial on the lattice of a degree that is higher by `degrees`.
std::vector<double> raised(const JacobianForm& form, int degrees) {
    const Lattice& lattice = form.lattice->factor(0);
    const int dimension = lattice.dimension();
    const Lattice& one = Lattice::of(dimension, degrees);
    const ProductTable& table = ProductTable::of(dimension, lattice.degree(), degrees);
    std::vector<double> result(static_cast<std::size_t>(Lattice::of(dimension, lattice.degree() + degrees).size()));
    for (std::size_t i = 0; i < form.coefficients.size(); ++i) {
        for (int j = 0; j < one.size(); ++j) {
            const ProductTable::Entry& entry = table.at(static_cast<int>(i), j);
            result[static_cast<std::size_t>(entry.target)] += entry.weight * form.coefficients[i];
        }
    }
    return result;
}

/// Control points of element `e` of a flat list.
std::vector<Vec3> control_of(const CurvedMesh& mesh, const Lattice& lattice, const std::vector<std::int32_t>& list,
                             int e) {
    const auto width = static_cast<std::size_t>(lattice.size());
    std::vector<Vec3> nodes(width);
    for (std::size_t i = 0; i < width; ++i) {
        const std::int32_t node = list[static_cast<std::size_t>(e) * width + i];
        nodes[i] = mesh.nodes[static_cast<std::size_t>(node)];
    }
    return elements::gmsh_to_bezier(lattice, nodes);
}

/// distortion(e) of all elements, in parallel.
template <typename Distortion>
std::vector<double> of_all(std::size_t count, Progress* progress, const Distortion& distortion) {
    // Elements in one parallel task: enough that starting a task costs little.
    constexpr int kChunk = 64;
    std::vector<double> found(count);
    const int chunks = static_cast<int>((count + kChunk - 1) / kChunk);
    std::atomic<int> done{0};
    parallel_for(chunks, [&](int chunk) {
        const int end = std::min<int>((chunk + 1) * kChunk, static_cast<int>(count));
        for (int e = chunk * kChunk; e < end; ++e) {
            check_cancelled(progress);
            found[static_cast<std::size_t>(e)] = distortion(e);
        }
        if (progress != nullptr) {
            progress->advance(static_cast<double>(++done) / chunks);
        }
    });
    return found;
}

}  // namespace

double max_distortion_of_triangle(const Lattice& lattice, const std::vector<Vec3>& control) {
    elements::NormalForm normal = elements::normal_of(lattice, control);
    JacobianForm stretch = elements::stretch_of(lattice, control);
    ShapeSearch<Vec3> search(normal.lattice->factor(0), normal.rounding);
    return search.inverse_of_least(std::move(normal.coefficients), std::move(stretch.coefficients));
}

double max_distortion_of_tetrahedron(const Lattice& lattice, const std::vector<Vec3>& control) {
    JacobianForm jacobian = elements::jacobian_of(lattice, control);
    ShapeSearch<double> search(jacobian.lattice->factor(0), jacobian.rounding);
    std::vector<double> stretch = raised(elements::stretch_of(lattice, control), lattice.degree() - 1);
    return search.inverse_of_least(std::move(jacobian.coefficients), std::move(stretch));
}

std::vector<double> triangle_distortions(const CurvedMesh& mesh, Progress* progress) {
    if (mesh.triangle_quality.size() != mesh.triangle_face.size()) {
        throw InvalidInput(phrases::kFoldsNotTold);
    }
    const Lattice& lattice = Lattice::of(2, mesh.order);
    return of_all(mesh.triangle_face.size(), progress, [&](int e) {
        const bool folded = !(mesh.triangle_quality[static_cast<std::size_t>(e)] > 0.0);
        return folded ? std::numeric_limits<double>::infinity()
                      : max_distortion_of_triangle(lattice, control_of(mesh, lattice, mesh.triangles, e));
    });
}

std::vector<double> tetrahedron_distortions(const CurvedMesh& mesh, Progress* progress) {
    const Lattice& lattice = Lattice::of(3, mesh.order);
    return of_all(mesh.tetrahedron_volume.size(), progress, [&](int e) {
        return max_distortion_of_tetrahedron(lattice, control_of(mesh, lattice, mesh.tetrahedra, e));
    });
}

}  // namespace mq::curve
