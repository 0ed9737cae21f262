// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elements/bezier/bernstein.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::elements {

namespace {

// Highest degree of a factor of any product taken, and of the product.
constexpr int kMaxFactor = 9;
constexpr int kMaxProduct = 13;

std::size_t slot_of(int dimension, int m, int n) {
    // Entries along one axis of the table: degrees 0 to kMaxFactor.
    constexpr int kSide = kMaxFactor + 1;
    return static_cast<std::size_t>(((dimension - 1) * kSide + m) * kSide + n);
}

std::vector<ProductTable> all_products() {
    std::vector<ProductTable> all;
    for (int dimension = 1; dimension <= 3; ++dimension) {
        for (int m = 0; m <= kMaxFactor; ++m) {
            for (int n = 0; n <= kMaxFactor; ++n) {
                all.emplace_back(dimension, m, m + n <= kMaxProduct ? n : 0);
            }
        }
    }
    return all;
}

struct Conversion {
    Eigen::MatrixXd to_nodes;
    Eigen::MatrixXd to_bezier;
};

Conversion conversion_of(const Lattice& lattice) {
    using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    const int n = lattice.size();
    Matrix values(n, n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            long double product = lattice.multinomial(j);
            for (std::size_t k = 0; k < 4; ++k) {
                for (int e = 0; e < lattice.exponents(j)[k]; ++e) {
                    product *= static_cast<long double>(lattice.exponents(i)[k]) / lattice.degree();
                }
            }
            values(i, j) = product;
        }
    }
    const Matrix inverse = values.fullPivLu().inverse();
    return {values.cast<double>(), inverse.cast<double>()};
}

const Conversion& conversion(const Lattice& lattice) {
    static const auto& all = never_destroyed([] {
        std::vector<Conversion> list;
        for (int dimension = 1; dimension <= 3; ++dimension) {
            for (int order = 1; order <= kMaxOrder; ++order) {
                list.push_back(conversion_of(Lattice::of(dimension, order)));
            }
        }
        return list;
    }());
    if (lattice.degree() < 1 || lattice.degree() > kMaxOrder) {
        throw InvalidInput(phrases::kElementOrder, {{"count", kMaxOrder}, {"count2", lattice.degree()}});
    }
    return all[static_cast<std::size_t>((lattice.dimension() - 1) * kMaxOrder + lattice.degree() - 1)];
}

std::vector<Vec3> multiplied(const Eigen::MatrixXd& matrix, const std::vector<Vec3>& points) {
    std::vector<Vec3> result(points.size(), Vec3::Zero());
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double weight = matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            if (weight != 0.0) {
                result[i] += weight * points[j];
            }
        }
    }
    return result;
}

/// See halve_blocks(). @tparam Width  of the blocks, or 0 where it is known at run time only
template <std::size_t Width>
void halve_rows(const Lattice& lattice, std::size_t blocks, std::size_t given_width, const double* c, int a, int b,
                double* first, double* second) {
    const std::size_t width = Width > 0 ? Width : given_width;
    const std::size_t stride = width * static_cast<std::size_t>(lattice.size());
    const auto ka = static_cast<std::size_t>(a);
    const auto kb = static_cast<std::size_t>(b);
    std::vector<double> row((static_cast<std::size_t>(lattice.degree()) + 1) * width);
    std::array<std::size_t, kMaxDegree + 1> at{};
    for (int i = 0; i < lattice.size(); ++i) {
        Exponents e = lattice.exponents(i);
        if (e[kb] != 0) {
            continue;
        }
        const auto n = static_cast<std::size_t>(e[ka]);
        for (std::size_t k = 0; k <= n; ++k, --e[ka], ++e[kb]) {
            at[k] = static_cast<std::size_t>(lattice.index(e)) * width;
        }
        for (std::size_t start = 0; start < blocks * stride; start += stride) {
            for (std::size_t k = 0; k <= n; ++k) {
                std::copy_n(c + start + at[k], width, row.data() + k * width);
            }
            for (std::size_t step = 0; step <= n; ++step) {
                const std::size_t left = n - step;
                std::copy_n(row.data(), width, first + start + at[step]);
                std::copy_n(row.data() + left * width, width, second + start + at[left]);
                for (std::size_t x = 0; x < left * width; ++x) {
                    row[x] = 0.5 * (row[x] + row[x + width]);
                }
            }
        }
    }
}

template <typename T>
std::pair<std::vector<T>, std::vector<T>> halved(const Lattice& lattice, const std::vector<T>& c, int a, int b) {
    std::pair<std::vector<T>, std::vector<T>> halves{std::vector<T>(c.size()), std::vector<T>(c.size())};
    halve_blocks(lattice, 1, sizeof(T) / sizeof(double), reinterpret_cast<const double*>(c.data()), a, b,
                 reinterpret_cast<double*>(halves.first.data()), reinterpret_cast<double*>(halves.second.data()));
    return halves;
}

}  // namespace

ProductTable::ProductTable(int dimension, int m, int n) {
    const Lattice& a = Lattice::of(dimension, m);
    const Lattice& b = Lattice::of(dimension, n);
    const Lattice& c = Lattice::of(dimension, m + n);
    columns_ = b.size();
    for (int i = 0; i < a.size(); ++i) {
        for (int j = 0; j < b.size(); ++j) {
            Exponents sum{};
            for (std::size_t k = 0; k < 4; ++k) {
                sum[k] = a.exponents(i)[k] + b.exponents(j)[k];
            }
            const int target = c.index(sum);
            entries_.push_back({target, a.multinomial(i) * b.multinomial(j) / c.multinomial(target)});
        }
    }
}

const ProductTable& ProductTable::of(int dimension, int m, int n) {
    static const auto& all = never_destroyed(all_products());
    if (m > kMaxFactor || n > kMaxFactor || m + n > kMaxProduct) {
        throw InvalidInput(phrases::kNoProduct, {{"count", m}, {"count2", n}});
    }
    return all[slot_of(dimension, m, n)];
}

std::vector<double> bernstein_values(const Lattice& lattice, const Barycentric& at) {
    std::array<std::array<double, kMaxDegree + 1>, 4> powers{};
    for (std::size_t k = 0; k < 4; ++k) {
        powers[k][0] = 1.0;
        for (std::size_t e = 1; e <= static_cast<std::size_t>(lattice.degree()); ++e) {
            powers[k][e] = powers[k][e - 1] * at[k];
        }
    }
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(lattice.size()));
    for (int i = 0; i < lattice.size(); ++i) {
        double product = lattice.multinomial(i);
        for (std::size_t k = 0; k < 4; ++k) {
            product *= powers[k][static_cast<std::size_t>(lattice.exponents(i)[k])];
        }
        values.push_back(product);
    }
    return values;
}

double value(const Lattice& lattice, const std::vector<double>& coefficients, const Barycentric& at) {
    const std::vector<double> b = bernstein_values(lattice, at);
    double sum = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        sum += b[i] * coefficients[i];
    }
    return sum;
}

Vec3 value(const Lattice& lattice, const std::vector<Vec3>& control, const Barycentric& at) {
    const std::vector<double> b = bernstein_values(lattice, at);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < b.size(); ++i) {
        sum += b[i] * control[i];
    }
    return sum;
}

std::vector<Vec3> derivative(const Lattice& lattice, const std::vector<Vec3>& control, int k) {
    const Lattice& lower = Lattice::of(lattice.dimension(), lattice.degree() - 1);
    std::vector<Vec3> result;
    result.reserve(static_cast<std::size_t>(lower.size()));
    for (int i = 0; i < lower.size(); ++i) {
        Exponents from = lower.exponents(i);
        Exponents to = from;
        ++from[0];
        ++to[static_cast<std::size_t>(k)];
        result.push_back(lattice.degree() * (control[static_cast<std::size_t>(lattice.index(to))] -
                                             control[static_cast<std::size_t>(lattice.index(from))]));
    }
    return result;
}

const Eigen::MatrixXd& nodes_to_bezier_matrix(const Lattice& lattice) {
    return conversion(lattice).to_bezier;
}

std::vector<Vec3> nodes_to_bezier(const Lattice& lattice, const std::vector<Vec3>& nodes) {
    return multiplied(conversion(lattice).to_bezier, nodes);
}

std::vector<Vec3> bezier_to_nodes(const Lattice& lattice, const std::vector<Vec3>& control) {
    return multiplied(conversion(lattice).to_nodes, control);
}

std::pair<std::vector<double>, std::vector<double>> halve(const Lattice& lattice, const std::vector<double>& c, int a,
                                                          int b) {
    return halved(lattice, c, a, b);
}

std::pair<std::vector<Vec3>, std::vector<Vec3>> halve(const Lattice& lattice, const std::vector<Vec3>& c, int a,
                                                      int b) {
    return halved(lattice, c, a, b);
}

void halve_blocks(const Lattice& lattice, std::size_t blocks, std::size_t width, const double* c, int a, int b,
                  double* first, double* second) {
    const auto rows = width == 1 ? halve_rows<1> : width == 3 ? halve_rows<3> : halve_rows<0>;
    rows(lattice, blocks, width, c, a, b, first, second);
}

std::vector<Vec3> raised_to(int degree, const Lattice& lattice, const std::vector<Vec3>& control) {
    if (degree == lattice.degree()) {
        return control;
    }
    const Lattice& higher = Lattice::of(2, lattice.degree() + 1);
    std::vector<Vec3> found(static_cast<std::size_t>(higher.size()), Vec3::Zero());
    for (int i = 0; i < higher.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            Exponents e = higher.exponents(i);
            const double share = static_cast<double>(e[k]) / higher.degree();
            if (e[k]-- > 0) {
                found[static_cast<std::size_t>(i)] += share * control[static_cast<std::size_t>(lattice.index(e))];
            }
        }
    }
    return raised_to(degree, higher, found);
}

}  // namespace mq::elements
