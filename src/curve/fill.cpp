// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "curve/child_process.h"

namespace mq::curve {

namespace {

std::string& fill_program() {
    static std::string path;
    return path;
}

template <typename T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes values off the front of the program's answer.
class Reader {
  public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}

    template <typename T>
    T take() {
        T value{};
        if (at_ + sizeof value > bytes_.size()) {
            throw CannotFill("the tetrahedral mesher gave half an answer");
        }
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    std::string rest() const { return bytes_.substr(at_); }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

std::string request(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                    double grading_part) {
    std::string bytes;
    append(bytes, static_cast<std::int64_t>(points.size()));
    append(bytes, static_cast<std::int64_t>(triangles.size()));
    append(bytes, grading_part);
    for (const Vec3& p : points) {
        append(bytes, std::array<double, 3>{p.x(), p.y(), p.z()});
    }
    for (const auto& t : triangles) {
        append(bytes, std::array<std::int32_t, 3>{t[0], t[1], t[2]});
    }
    return bytes;
}

double box_product(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// `turn` is undone for the inner points; those of the surface are the given ones again, bit for bit.
Filling read_answer(Reader& reader, const std::vector<Vec3>& turned, const Eigen::Matrix3d& turn) {
    const auto count = static_cast<std::size_t>(reader.take<std::int64_t>());
    const auto elements = static_cast<std::size_t>(reader.take<std::int64_t>());
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = reader.take<std::array<double, 3>>();
        all.emplace_back(x[0], x[1], x[2]);
        if (i < turned.size() && all.back() != turned[i]) {
            throw CannotFill("the tetrahedral mesher moved a vertex of the surface");
        }
    }
    Filling filling;
    for (std::size_t i = turned.size(); i < all.size(); ++i) {
        filling.inner_points.push_back(turn.transpose() * all[i]);
    }
    for (std::size_t i = 0; i < elements; ++i) {
        const auto v = reader.take<std::array<std::int32_t, 4>>();
        std::array<int, 4> corners{v[0], v[1], v[2], v[3]};
        const auto at = [&](std::size_t k) -> const Vec3& { return all.at(static_cast<std::size_t>(corners[k])); };
        if (box_product(at(0), at(1), at(2), at(3)) < 0.0) {
            std::swap(corners[2], corners[3]);
        }
        filling.tetrahedra.push_back(corners);
    }
    return filling;
}

std::array<int, 3> sorted(std::array<int, 3> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Whether the tetrahedra share their triangles two by two, but for those of the surface.
bool ends_at(const std::vector<std::array<int, 3>>& surface, const std::vector<std::array<int, 4>>& tetrahedra) {
    std::vector<std::array<int, 3>> sides;
    sides.reserve(4 * tetrahedra.size() + surface.size());
    for (const auto& t : surface) {
        sides.push_back(sorted(t));
    }
    for (const auto& t : tetrahedra) {
        sides.push_back(sorted({t[0], t[1], t[2]}));
        sides.push_back(sorted({t[0], t[1], t[3]}));
        sides.push_back(sorted({t[0], t[2], t[3]}));
        sides.push_back(sorted({t[1], t[2], t[3]}));
    }
    // With the surface's own each triangle is there twice.
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        const bool single = i + 1 == sides.size() || sides[i] != sides[i + 1];
        if (single || (i + 2 < sides.size() && sides[i] == sides[i + 2])) {
            return false;
        }
    }
    return true;
}

struct Attempt {
    Filling filling;
    std::string fault;  ///< empty: the filling stands
    bool too_long = false;
};

Attempt attempt(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles, double grading_part,
                const Eigen::Matrix3d& turn, const Progress& progress) {
    std::vector<Vec3> turned = points;
    if (!turn.isIdentity()) {
        for (Vec3& p : turned) {
            p = turn * p;
        }
    }
    ChildProcess mesher(fill_program());
    const std::string answer = mesher.exchange(request(turned, triangles, grading_part), progress);
    const ChildProcess::End end = mesher.end();
    if (!end.fault.empty()) {
        return {{}, end.fault, end.too_long};
    }
    Reader reader(answer);
    if (reader.take<std::int64_t>() == 0) {
        Attempt done{read_answer(reader, turned, turn), "", false};
        if (!ends_at(triangles, done.filling.tetrahedra)) {
            done.fault = "the tetrahedra do not end at the surface";
        }
        return done;
    }
    reader.take<std::int64_t>();
    return {{}, reader.rest(), false};
}

/// Parts have many points on one sphere, as those of a box or a grid, where the mesher's Delaunay method loses its way.
/// Turned by angles that fit nothing they are a little off by rounding.
Eigen::Matrix3d turned_by(double angle) {
    const auto about = [&](double part, const Vec3& axis) {
        return Eigen::AngleAxisd(part * angle, axis).toRotationMatrix();
    };
    return about(0.3, Vec3::UnitZ()) * about(0.7, Vec3::UnitX()) * about(1.1, Vec3::UnitY());
}

}  // namespace

void set_fill_program(const std::string& path) {
    fill_program() = path;
}

Filling fill(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles, double grading_part,
             const Progress& progress) {
    std::string why;
    for (const double angle : {0.0, 1.0, 1.7}) {
        Attempt result = attempt(points, triangles, grading_part, turned_by(angle), progress);
        if (result.fault.empty()) {
            return std::move(result.filling);
        }
        if (result.too_long) {
            throw GeometryError(
                "filling the surface with tetrahedra did not come to an end: its triangles do not fit each "
                "other across thin walls; ask for a smaller chord height or shorter edges");
        }
        why = result.fault;
    }
    throw CannotFill("the surface could not be filled with tetrahedra (the mesher says: " + why +
                     "): it meets itself, or walls are too thin for its triangles; ask for a smaller chord height");
}

}  // namespace mq::curve
