// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <gp_Lin.hxx>
#include <sstream>
#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "geometry/occt/brep_text.h"
#include "layered_depth/samples/layered_depth_image.h"

/// What rays cost and miss that are shot at trimmed faces without a mesh, by OpenCASCADE's intersections of lines with
/// faces, which trims them by the curves of edges in (u, v):   direct_rays_bench RAYS [PART.brep]...
/// prints for primitives and each part the samples, the rays with an odd number of them, the nodes of the grid about
/// which the rays of three directions do not agree, and samples a second. Compare native_rays.py.
namespace {

using namespace mq;

/// Hits nearer to each other than this fraction of the size that turn the same way count once: seams and edges.
constexpr double kSame = 1e-6;
/// The tolerance of the intersections, as a fraction of the size.
constexpr double kTolerance = 1e-7;

struct Hit {
    double depth;
    int turn;
};

struct Counts {
    std::size_t samples = 0, odd = 0, disagree = 0;
    double seconds = 0.0;
};

std::vector<Hit> hits_on(IntCurvesFace_ShapeIntersector& faces, const gp_Lin& line, double length, double size) {
    faces.Perform(line, 0.0, length);
    std::vector<Hit> all, once;
    for (int i = 1; faces.IsDone() && i <= faces.NbPnt(); ++i) {
        all.push_back({faces.WParameter(i), static_cast<int>(faces.Transition(i))});
    }
    std::sort(all.begin(), all.end(), [](const Hit& a, const Hit& b) { return a.depth < b.depth; });
    for (const Hit& hit : all) {
        if (once.empty() || hit.depth - once.back().depth > kSame * size || hit.turn != once.back().turn) {
            once.push_back(hit);
        }
    }
    return once;
}

Counts shoot(const TopoDS_Shape& shape, int rays) {
    Bnd_Box bounds;
    BRepBndLib::Add(shape, bounds);
    Box box;
    const gp_Pnt low = bounds.CornerMin(), high = bounds.CornerMax();
    box.add(Vec3(low.X(), low.Y(), low.Z()));
    box.add(Vec3(high.X(), high.Y(), high.Z()));
    const layered_depth::SampleGrid grid(box, rays);
    const int n = grid.rays();
    const double size = box.largest_side();
    Counts counts;
    const Stopwatch watch;
    IntCurvesFace_ShapeIntersector faces;
    faces.Load(shape, kTolerance * size);
    std::array<std::vector<std::vector<Hit>>, 3> hits;
    for (int axis = 0; axis < 3; ++axis) {
        hits[axis].resize(static_cast<std::size_t>(n) * n);
        for (int ray = 0; ray < n * n; ++ray) {
            Vec3 g = Vec3::Zero();
            g[(axis + 1) % 3] = ray % n;
            g[(axis + 2) % 3] = ray / n;
            const Vec3 p = grid.to_space(g);
            const gp_Lin line(gp_Pnt(p.x(), p.y(), p.z()), gp_Dir(axis == 0, axis == 1, axis == 2));
            hits[axis][ray] = hits_on(faces, line, n * grid.spacing(), size);
            counts.samples += hits[axis][ray].size();
            counts.odd += hits[axis][ray].size() % 2;
        }
    }
    counts.seconds = watch.wall();
    for (int node = 0; node < n * n * n; ++node) {
        const std::array<int, 3> at{node % n, node / n % n, node / n / n};
        std::array<bool, 3> inside{};
        for (int axis = 0; axis < 3; ++axis) {
            for (const Hit& hit : hits[axis][at[(axis + 2) % 3] * n + at[(axis + 1) % 3]]) {
                inside[axis] = inside[axis] != (hit.depth <= at[axis] * grid.spacing());
            }
        }
        counts.disagree += inside[0] != inside[1] || inside[1] != inside[2] ? 1 : 0;
    }
    return counts;
}

void show(const std::string& name, const TopoDS_Shape& shape, int rays) {
    const Counts counts = shoot(shape, rays);
    std::printf("%-28s %9zu samples, %5zu rays odd, %6zu nodes disagree, %8.2f s, %9.0f samples a second\n",
                name.c_str(), counts.samples, counts.odd, counts.disagree, counts.seconds,
                static_cast<double>(counts.samples) / counts.seconds);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) {
        std::fprintf(stderr, "direct_rays_bench RAYS [PART.brep]...\n");
        return 2;
    }
    const int rays = std::atoi(arguments[1]);
    show("sphere", BRepPrimAPI_MakeSphere(10.0).Shape(), rays);
    show("torus", BRepPrimAPI_MakeTorus(12.0, 4.0).Shape(), rays);
    show("cylinder", BRepPrimAPI_MakeCylinder(5.0, 40.0).Shape(), rays);
    show("cone", BRepPrimAPI_MakeCone(9.0, 0.0, 22.0).Shape(), rays);
    for (int i = 2; i < count; ++i) {
        std::ifstream file(arguments[i]);
        std::ostringstream text;
        text << file.rdbuf();
        const std::string path = arguments[i];
        show(path.substr(path.rfind('/') + 1), *geometry::read_brep_text(text.str()), rays);
    }
    return 0;
}
