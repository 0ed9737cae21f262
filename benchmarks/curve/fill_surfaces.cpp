// SPDX-License-Identifier: LGPL-2.1-or-later
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "base/predicates.h"
#include "tetrahedralise/tetrahedralise.h"

/// Fills closed surfaces, for filling.py:
///
///     fill_surfaces SURFACE.off ...
///
/// Prints one JSON object a surface: CPU seconds, tetrahedra, the smallest dihedral angle, the one that a
/// twentieth of the tetrahedra are below, and how many have no positive volume; or why it failed.
namespace {

using mq::Vec3;
using mq::tetrahedralise::Tetrahedra;

constexpr double kDegrees = 57.29577951308232;

struct Surface {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
};

Surface read(const std::string& path) {
    std::ifstream file(path);
    std::string format;
    std::size_t points = 0, triangles = 0, edges = 0;
    file >> format >> points >> triangles >> edges;
    Surface surface;
    surface.points.resize(points);
    for (Vec3& p : surface.points) {
        file >> p[0] >> p[1] >> p[2];
    }
    surface.triangles.resize(triangles);
    for (std::array<int, 3>& t : surface.triangles) {
        std::size_t corners = 0;
        file >> corners >> t[0] >> t[1] >> t[2];
    }
    return surface;
}

/// CPU seconds of this process.
double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    double sum = 0.0;
    for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
        sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    return sum;
}

double smallest_dihedral(const std::vector<Vec3>& points, const std::array<int, 4>& t) {
    double smallest = 180.0;
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
            const int k = i == 0 ? (j == 1 ? 2 : 1) : 0;
            const int l = 6 - i - j - k;
            const Vec3 edge = points[t[j]] - points[t[i]];
            const Vec3 one = edge.cross(points[t[k]] - points[t[i]]);
            const Vec3 two = edge.cross(points[t[l]] - points[t[i]]);
            smallest = std::min(smallest, kDegrees * std::atan2(one.cross(two).norm(), one.dot(two)));
        }
    }
    return smallest;
}

void print(const std::string& path, const Surface& surface, const std::function<Tetrahedra()>& fill) {
    const double start = cpu_seconds();
    std::printf("{\"surface\": \"%s\", \"triangles\": %zu, ", path.c_str(), surface.triangles.size());
    try {
        const Tetrahedra filling = fill();
        const double seconds = cpu_seconds() - start;
        std::vector<Vec3> points = surface.points;
        points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
        std::vector<double> angles;
        std::size_t flat = 0;
        for (const std::array<int, 4>& t : filling.tetrahedra) {
            angles.push_back(smallest_dihedral(points, t));
            flat += mq::orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) > 0 ? 0 : 1;
        }
        std::sort(angles.begin(), angles.end());
        std::printf("\"seconds\": %.4f, \"tetrahedra\": %zu, \"smallest\": %.4f, \"twentieth\": %.4f, \"flat\": %zu}\n",
                    seconds, angles.size(), angles.front(), angles[angles.size() / 20], flat);
    } catch (const std::exception& error) {
        std::printf("\"seconds\": %.4f, \"failed\": \"%s\"}\n", cpu_seconds() - start, error.what());
    }
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    for (int i = 1; i < count; ++i) {
        const Surface surface = read(arguments[i]);
        const mq::Progress progress;
        print(arguments[i], surface,
              [&] { return mq::tetrahedralise::tetrahedralise(surface.points, surface.triangles, {}, progress); });
    }
    return 0;
}
