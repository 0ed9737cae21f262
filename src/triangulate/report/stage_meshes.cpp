// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/stage_meshes.h"

#include <algorithm>
#include <cstdlib>

#include "base/memory/large_vector.h"
#include "base/progress.h"
#include "mesh/io/io.h"
#include "triangulate/report/manifold_output.h"

namespace mq::triangulate {

StageMeshes::StageMeshes(const ClassifiedMesh& mesh, const geometry::Topology& topology, const Vec3& origin,
                         StageTimer& clock)
    : mesh_(mesh), topology_(topology), origin_(origin), clock_(clock) {
    const char* folder = std::getenv("MESHQUALITY_STAGES");
    folder_ = folder != nullptr ? folder : "";
    write("initial triangulation");
}

void StageMeshes::end(const char* stage) {
    release_memory();
    clock_.end(stage);
    write(stage);
}

void StageMeshes::release_memory() const {
    // Number of triangles above which the memory is worth a millisecond.
    constexpr int kLarge = 50'000;
    if (mesh_.triangle_count() >= kLarge) {
        release_freed_memory();
    }
}

void StageMeshes::end_together(const StageTimes& stages) {
    release_memory();
    clock_.end_together(stages);
    write("refinement");
}

void StageMeshes::write(const std::string& stage) {
    if (folder_.empty()) {
        return;
    }
    const int number = ++written_;
    std::string name = (number < 10 ? "0" : "") + std::to_string(number) + "-" + stage + ".ply";
    std::replace(name.begin(), name.end(), ' ', '-');
    mesh::write(write_out(mesh_, topology_, origin_, Progress()).mesh, folder_ + "/" + name);
}

}  // namespace mq::triangulate
