// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/mesher/filling_answer.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace mq::curve {

namespace {

/// Reads values from the front of the answer.
class Reader {
  public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}

    template <typename T>
    T take() {
        T value{};
        if (sizeof value > bytes_.size() - at_) {
            throw MeshingFailed("the tetrahedral mesher gave half an answer");
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

double box_product(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

std::array<int, 4> read_tetrahedron(Reader& reader, const std::vector<Vec3>& points) {
    std::array<int, 4> corners = reader.take<std::array<std::int32_t, 4>>();
    for (const int v : corners) {
        if (v < 0 || static_cast<std::size_t>(v) >= points.size()) {
            throw MeshingFailed("the tetrahedral mesher named a point that it did not give");
        }
    }
    const auto at = [&](std::size_t k) -> const Vec3& { return points[static_cast<std::size_t>(corners[k])]; };
    if (box_product(at(0), at(1), at(2), at(3)) < 0.0) {
        std::swap(corners[2], corners[3]);
    }
    return corners;
}

}  // namespace

FillingAnswer read_filling(const std::string& answer, const std::vector<Vec3>& surface) {
    Reader reader(answer);
    if (reader.take<std::int64_t>() != 0) {
        reader.take<std::int64_t>();
        const std::string why = reader.rest();
        return {{}, why.empty() ? "no reason was given" : why};
    }
    // If a count exceeds the values that follow, the loops end early with an incomplete answer.
    const auto points = reader.take<std::int64_t>();
    const auto tetrahedra = reader.take<std::int64_t>();
    std::vector<Vec3> all;
    for (std::int64_t i = 0; i < points; ++i) {
        const auto x = reader.take<std::array<double, 3>>();
        all.emplace_back(x[0], x[1], x[2]);
        if (all.size() <= surface.size() && all.back() != surface[all.size() - 1]) {
            throw MeshingFailed("the tetrahedral mesher moved a vertex of the surface");
        }
    }
    if (all.size() < surface.size()) {
        throw MeshingFailed("the tetrahedral mesher lost vertices of the surface");
    }
    FillingAnswer read;
    read.filling.inner_points.assign(all.begin() + static_cast<std::ptrdiff_t>(surface.size()), all.end());
    for (std::int64_t i = 0; i < tetrahedra; ++i) {
        read.filling.tetrahedra.push_back(read_tetrahedron(reader, all));
    }
    return read;
}

}  // namespace mq::curve
