// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"

/// Random operands for tests of the Boolean: closed meshes, placements and defects, all from a seed.
namespace mq::boolean::fuzz {

using mesh::Triangle;
using mesh::TriangleMesh;

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    bool chance(double probability) { return real(0.0, 1.0) < probability; }
    Vec3 direction() {
        while (true) {
            const Vec3 v(real(-1, 1), real(-1, 1), real(-1, 1));
            if (v.norm() > 0.1 && v.norm() <= 1.0) {
                return v.normalized();
            }
        }
    }

  private:
    std::mt19937_64 engine_;
};

inline void round_to_single(TriangleMesh& mesh) {
    for (Vec3& v : mesh.vertices) {
        v = to_single(v);
    }
}

inline double signed_volume(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
    double sum = 0.0;
    for (const Triangle& t : triangles) {
        sum += (vertices[t[0]] - vertices[0]).dot((vertices[t[1]] - vertices[0]).cross(vertices[t[2]] - vertices[0]));
    }
    return sum / 6.0;
}

inline double area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        sum += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
    return sum;
}

// ---- closed meshes --------------------------------------------------------------------------------------------------

/// Every triangle becomes four.
inline void subdivide(TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [at, fresh] = middles.emplace(std::minmax(a, b), int(mesh.vertices.size()));
        if (fresh) {
            const Vec3 point = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
            mesh.vertices.push_back(point);
        }
        return at->second;
    };
    std::vector<Triangle> fine;
    for (const Triangle& t : mesh.triangles) {
        const int a = middle(t[0], t[1]);
        const int b = middle(t[1], t[2]);
        const int c = middle(t[2], t[0]);
        fine.insert(fine.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
    }
    mesh.triangles.swap(fine);
}

/// The cube [0, 1]^3, its sides divided `levels` times.
inline TriangleMesh cube(int levels = 0) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    for (int i = 0; i < levels; ++i) {
        subdivide(mesh);
    }
    return mesh;
}

/// The unit sphere from an octahedron: 8 * 4^levels triangles.
inline TriangleMesh sphere(int levels) {
    TriangleMesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int i = 0; i < levels; ++i) {
        subdivide(mesh);
        for (Vec3& v : mesh.vertices) {
            v.normalize();
        }
    }
    return mesh;
}

inline TriangleMesh torus(int n, int m, double minor) {
    TriangleMesh mesh;
    const auto at = [&](int i, int j) { return (i % n) * m + j % m; };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const double u = 2 * M_PI * i / n;
            const double v = 2 * M_PI * j / m;
            const double r = 1.0 + minor * std::cos(v);
            mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

/// A sphere whose radius is cut down by random planes: flat facets of many coplanar triangles, sharp edges.
inline TriangleMesh facetted(Random& random, int levels) {
    TriangleMesh mesh = sphere(levels);
    std::vector<Vec3> normals;
    for (int i = random.integer(6, 20); i > 0; --i) {
        normals.push_back(random.direction() / random.real(0.5, 0.95));
    }
    for (Vec3& v : mesh.vertices) {
        double radius = 1.0;
        for (const Vec3& n : normals) {
            radius = std::min(radius, n.dot(v) > 1e-3 ? 1.0 / n.dot(v) : 1.0);
        }
        v *= radius;
    }
    return mesh;
}

/// A sphere whose radius varies at random from vertex to vertex: closed and free of self-intersection.
inline TriangleMesh noisy(Random& random, int levels) {
    TriangleMesh mesh = sphere(levels);
    const double noise = random.real(0.01, 0.3);
    for (Vec3& v : mesh.vertices) {
        v *= 1.0 + random.real(-noise, noise);
    }
    return mesh;
}

/// A closed mesh of one component, about 2 mm large, around the origin; free of self-intersection.
inline TriangleMesh closed_mesh(Random& random) {
    TriangleMesh mesh;
    switch (random.integer(0, 4)) {
        case 0:
            mesh = sphere(random.integer(0, 4));
            break;
        case 1:
            mesh = cube(random.integer(0, 3));
            break;
        case 2:
            mesh = torus(random.integer(3, 40), random.integer(3, 20), random.real(0.1, 0.8));
            break;
        case 3:
            mesh = facetted(random, random.integer(2, 4));
            break;
        default:
            mesh = noisy(random, random.integer(1, 4));
    }
    round_to_single(mesh);
    return mesh;
}

// ---- placements -----------------------------------------------------------------------------------------------------

inline void move(TriangleMesh& mesh, const Eigen::Matrix3d& rotation, double scale, const Vec3& shift) {
    for (Vec3& v : mesh.vertices) {
        v = scale * (rotation * v) + shift;
    }
    round_to_single(mesh);
}

/// The position of an operand relative to the other one.
enum class Placement { General, Grid, Same, Near, Touching, kCount };

inline const char* name_of(Placement placement) {
    /// The names of the placements in their order.
    constexpr const char* kNames[] = {"general", "grid", "same", "near", "touching"};
    return kNames[static_cast<int>(placement)];
}

inline void place(TriangleMesh& mesh, Placement placement, Random& random) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(random.real(0, M_PI), random.direction()).toRotationMatrix();
    const Eigen::Matrix3d quarter =
        Eigen::AngleAxisd(0.5 * M_PI * random.integer(0, 3), Vec3::Unit(random.integer(0, 2))).toRotationMatrix();
    switch (placement) {
        case Placement::General:
            move(mesh, turn, random.real(0.4, 2.0), random.real(0.0, 1.2) * random.direction());
            break;
        case Placement::Grid: {
            // Faces, edges and vertices that coincide.
            const Vec3 shift(random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2));
            move(mesh, quarter.array().round(), std::pow(2.0, random.integer(-1, 1)), 0.5 * shift);
            break;
        }
        case Placement::Same:
            break;
        case Placement::Near: {
            const double small = std::pow(10.0, random.real(-7, -1));
            move(mesh, Eigen::AngleAxisd(small, random.direction()).toRotationMatrix(), 1.0,
                 random.chance(0.5) ? Vec3(small * random.direction()) : Vec3(0, 0, 0));
            break;
        }
        default:
            // Side by side along an axis, in contact or nearly so.
            move(mesh, Eigen::Matrix3d::Identity(), 1.0,
                 (random.chance(0.5) ? 1.0 : 2.0) * Vec3(Vec3::Unit(random.integer(0, 2))) +
                     (random.chance(0.5) ? 1e-6 : 0.0) * random.direction());
    }
}

// ---- defects --------------------------------------------------------------------------------------------------------

enum class Defect { Holes, Flips, InsideOut, Duplicates, Opposites, Unwelded, Degenerate, Overlap, kCount };

inline const char* name_of(Defect defect) {
    /// The names of the defects in their order.
    constexpr const char* kNames[] = {"holes",     "flips",    "inside out", "duplicates",
                                      "opposites", "unwelded", "degenerate", "overlap"};
    return kNames[static_cast<int>(defect)];
}

/// A triangle without area on an edge: the neighbour there is divided at a point of the edge, this one is not.
inline void add_degenerate(TriangleMesh& mesh, std::size_t k) {
    const Triangle t = mesh.triangles[k];
    const Vec3 a = mesh.vertices[t[0]];
    const Vec3 b = mesh.vertices[t[1]];
    const Vec3 middle = 0.5 * (a + b);
    if (!(middle - a).cross(b - middle).isZero(0.0) || middle == a || middle == b) {
        return;
    }
    const auto m = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(middle);
    mesh.triangles[k] = {t[0], m, t[2]};
    mesh.triangles.push_back({m, t[1], t[2]});
    mesh.triangles.push_back({t[0], t[1], m});
}

inline void damage(TriangleMesh& mesh, Defect defect, Random& random) {
    const auto any = [&] { return static_cast<std::size_t>(random.integer(0, int(mesh.triangles.size()) - 1)); };
    const int few = 1 + static_cast<int>(mesh.triangles.size()) / 50;
    switch (defect) {
        case Defect::Holes:
            for (int i = 0; i < few; ++i) {
                mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(any()));
            }
            break;
        case Defect::Flips:
            for (int i = 0; i < few; ++i) {
                Triangle& t = mesh.triangles[any()];
                std::swap(t[0], t[1]);
            }
            break;
        case Defect::InsideOut:
            for (Triangle& t : mesh.triangles) {
                std::swap(t[0], t[1]);
            }
            break;
        case Defect::Duplicates:
        case Defect::Opposites:
            for (int i = 0; i < few; ++i) {
                Triangle t = mesh.triangles[any()];
                if (defect == Defect::Opposites) {
                    std::swap(t[1], t[2]);
                }
                mesh.triangles.push_back(t);
            }
            break;
        case Defect::Unwelded: {
            std::vector<Vec3> vertices;
            for (Triangle& t : mesh.triangles) {
                for (std::int32_t& v : t) {
                    vertices.push_back(mesh.vertices[v]);
                    v = static_cast<std::int32_t>(vertices.size()) - 1;
                }
            }
            mesh.vertices.swap(vertices);
            break;
        }
        case Defect::Degenerate:
            for (int i = 0; i < few; ++i) {
                add_degenerate(mesh, any());
            }
            break;
        default: {
            TriangleMesh other = closed_mesh(random);
            place(other, Placement::General, random);
            const auto first = static_cast<std::int32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
            for (const Triangle& t : other.triangles) {
                mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            }
        }
    }
}

// ---- pairs ----------------------------------------------------------------------------------------------------------

/// Two operands and their description in words.
struct Pair {
    TriangleMesh a;
    TriangleMesh b;
    std::string description;
    bool clean = true;                ///< both are closed and free of defects
    std::vector<TriangleMesh> whole;  ///< the operands without dirt, where what encloses them is known in spite of it
};

/// A random pair: the same for the same seed, on every machine with the same standard library.
inline Pair random_pair(std::uint64_t seed) {
    Random random(seed);
    Pair pair;
    pair.a = closed_mesh(random);
    const auto placement = static_cast<Placement>(random.integer(0, static_cast<int>(Placement::kCount) - 1));
    const bool copy = placement == Placement::Same || (placement == Placement::Near && random.chance(0.8));
    pair.b = copy ? pair.a : closed_mesh(random);
    place(pair.b, placement, random);
    pair.description = "seed " + std::to_string(seed) + ": " + name_of(placement) + (copy ? " copy" : "");
    for (TriangleMesh* mesh : {&pair.a, &pair.b}) {
        while (random.chance(0.3)) {
            const auto defect = static_cast<Defect>(random.integer(0, static_cast<int>(Defect::kCount) - 1));
            damage(*mesh, defect, random);
            pair.description += std::string(mesh == &pair.a ? ", A " : ", B ") + name_of(defect);
            pair.clean = false;
        }
    }
    return pair;
}

/// The same pair, rotated as a whole at random: faces that were coplanar are so only within rounding.
inline Pair turned_pair(std::uint64_t seed) {
    /// Offset of the seeds of rotations, so that they differ from those of the pairs.
    constexpr std::uint64_t kOtherSeed = 77777;
    Pair pair = random_pair(seed);
    Random random(seed + kOtherSeed);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(random.real(0.0, 3.0), random.direction()).toRotationMatrix();
    move(pair.a, turn, 1.0, Vec3::Zero());
    move(pair.b, turn, 1.0, Vec3::Zero());
    pair.description += ", turned";
    return pair;
}

// ---- dirt that leaves no doubt about what is inside
// ------------------------------------------------------------------

enum class Dirt { Crack, Sheet, TwoSided, Flips, kCount };

inline const char* name_of(Dirt dirt) {
    /// The names in their order.
    constexpr const char* kNames[] = {"a crack", "a sheet beside it", "two-sided", "half of it flipped"};
    return kNames[static_cast<int>(dirt)];
}

/// Parts the surface along a plane, and moves the vertices on one side of the crack by up to `width` in each
/// coordinate.
inline void crack(TriangleMesh& mesh, double width, Random& random) {
    const Vec3 normal = random.direction();
    const Vec3 middle = mesh.vertices[static_cast<std::size_t>(random.integer(0, int(mesh.vertices.size()) - 1))];
    std::vector<char> above(mesh.vertices.size(), 0);
    const auto beyond = [&](const Triangle& t) {
        return normal.dot(mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]] - 3.0 * middle) > 0.0;
    };
    std::vector<char> side;
    for (const Triangle& t : mesh.triangles) {
        side.push_back(beyond(t) ? 1 : 0);
        for (const std::int32_t v : t) {
            above[v] |= static_cast<char>(1 << side.back());
        }
    }
    std::map<std::int32_t, std::int32_t> copies;
    for (std::size_t t = 0; t < side.size(); ++t) {
        for (std::int32_t& v : mesh.triangles[t]) {
            if (side[t] == 0 || above[v] != 3) {
                continue;
            }
            const auto [copy, fresh] = copies.emplace(v, static_cast<std::int32_t>(mesh.vertices.size()));
            if (fresh) {
                const Vec3 shift(random.real(-width, width), random.real(-width, width), random.real(-width, width));
                mesh.vertices.push_back(to_single(mesh.vertices[v] + shift));
            }
            v = copy->second;
        }
    }
}

/// Adds a square of a quarter of the surface's area, at a random place through or beside it.
inline void add_sheet(TriangleMesh& mesh, Random& random) {
    const double side = 0.5 * std::sqrt(area(mesh));
    const Vec3 x = random.direction();
    const Vec3 y = x.unitOrthogonal();
    const Vec3 corner = mesh.vertices[0] + random.real(0.0, 1.0) * side * random.direction();
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Vec3& step : {Vec3(0, 0, 0), x, Vec3(x + y), y}) {
        mesh.vertices.push_back(to_single(corner + side * step));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

/// @param width  of cracks, mm
inline void soil(TriangleMesh& mesh, Dirt dirt, double width, Random& random) {
    const std::size_t count = mesh.triangles.size();
    switch (dirt) {
        case Dirt::Crack:
            crack(mesh, width, random);
            break;
        case Dirt::Sheet:
            add_sheet(mesh, random);
            break;
        case Dirt::TwoSided:
            for (std::size_t t = 0; t < count; ++t) {
                const Triangle& c = mesh.triangles[t];
                mesh.triangles.push_back({c[0], c[2], c[1]});
            }
            break;
        case Dirt::Flips:
            for (Triangle& t : mesh.triangles) {
                if (random.chance(0.5)) {
                    std::swap(t[0], t[1]);
                }
            }
            break;
        case Dirt::kCount:
            break;
    }
}

/// A pair of closed meshes, placed at random, with dirt on one or both. None may be refused, and volumes are those of
/// the pair without dirt.
inline Pair dirty_pair(std::uint64_t seed) {
    Random random(seed);
    Pair pair;
    pair.a = closed_mesh(random);
    pair.b = closed_mesh(random);
    place(pair.b, Placement::General, random);
    pair.description = "seed " + std::to_string(seed) + ", dirty";
    pair.whole = {pair.a, pair.b};
    for (TriangleMesh* mesh : {&pair.a, &pair.b}) {
        const int most = static_cast<int>(Dirt::kCount) - 1;
        const auto dirt = static_cast<Dirt>(random.integer(0, most));
        soil(*mesh, dirt, 1e-4, random);
        pair.description += std::string(mesh == &pair.a ? ", A " : ", B ") + name_of(dirt);
        if (random.chance(0.5)) {
            break;
        }
    }
    return pair;
}

}  // namespace mq::boolean::fuzz
