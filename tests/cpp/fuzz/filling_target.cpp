// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the program that fills surfaces answers, broken in any way.
#include <string>
#include <vector>

#include "bytes.h"
#include "curve/volume/mesher/filling_answer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace mq;
    const std::vector<Vec3> surface{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    try {
        const curve::FillingAnswer answer = curve::read_filling({reinterpret_cast<const char*>(data), size}, surface);
        const auto points = static_cast<int>(surface.size() + answer.filling.inner_points.size());
        for (const auto& corners : answer.filling.tetrahedra) {
            for (const int v : corners) {
                fuzz::require(v >= 0 && v < points, "tetrahedra name points that are there");
            }
        }
        fuzz::require(answer.fault.empty() || answer.filling.tetrahedra.empty(), "a fault has no tetrahedra");
    } catch (const curve::MeshingFailed&) {
        // Refused with a sentence.
    }
    return 0;
}
