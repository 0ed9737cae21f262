// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/mesher/netgen_filling.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <utility>

#include "base/child_process.h"
#include "base/memory/never_destroyed.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/volume/mesher/filling_answer.h"
#include "curve/volume/mesher/filling_check.h"

namespace mq::curve {

namespace {

std::string& fill_program() {
    static auto& path = never_destroyed<std::string>({});
    return path;
}

template <typename T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string request(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                    double grading_factor) {
    std::string bytes;
    append(bytes, static_cast<std::int64_t>(points.size()));
    append(bytes, static_cast<std::int64_t>(triangles.size()));
    append(bytes, grading_factor);
    for (const Vec3& p : points) {
        append(bytes, std::array<double, 3>{p.x(), p.y(), p.z()});
    }
    for (const auto& t : triangles) {
        append(bytes, std::array<std::int32_t, 3>{t[0], t[1], t[2]});
    }
    return bytes;
}

struct Attempt {
    TetrahedralFilling filling;
    std::string fault;  ///< empty: the filling is valid
    bool too_long = false;
};

Attempt attempt(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                double grading_factor, const Eigen::Matrix3d& turn, const Progress& progress) {
    std::vector<Vec3> turned = points;
    if (!turn.isIdentity()) {
        for (Vec3& p : turned) {
            p = turn * p;
        }
    }
    ChildProcess mesher(fill_program());
    const std::string answer = mesher.exchange(request(turned, triangles, grading_factor), progress);
    const ChildProcess::End end = mesher.end();
    if (!end.fault.empty()) {
        return {{}, end.fault, end.too_long};
    }
    FillingAnswer read = read_filling(answer, turned);
    // Points of the surface keep the given coordinates, bit for bit.
    for (Vec3& p : read.filling.inner_points) {
        p = turn.transpose() * p;
    }
    if (read.fault.empty() && !ends_at(triangles, read.filling.tetrahedra)) {
        read.fault = "the tetrahedra do not end at the surface";
    }
    return {std::move(read.filling), std::move(read.fault), false};
}

/// Models have many points on one sphere, as those of a box or a grid, where the mesher's Delaunay method fails.
/// Rotation by irregular angles moves the points off the sphere by rounding.
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

TetrahedralFilling fill_by_netgen(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
                                  double grading_factor, const Progress& progress) {
    std::string why;
    for (const double angle : {0.0, 1.0, 1.7}) {
        Attempt result = attempt(points, triangles, grading_factor, turned_by(angle), progress);
        if (result.fault.empty()) {
            return std::move(result.filling);
        }
        if (result.too_long) {
            throw GeometryError(Message{phrases::kFillingWithoutEnd});
        }
        why = result.fault;
    }
    throw MeshingFailed(Message::of(phrases::kNotFilled, {{"value", why}}));
}

}  // namespace mq::curve
