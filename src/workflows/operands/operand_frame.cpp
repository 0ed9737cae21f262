// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workflows/operands/operand_frame.h"

#include <algorithm>

#include "base/single_precision_grid.h"

namespace mq::workflows {

namespace {

bool all_single(const mesh::TriangleMesh& mesh) {
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_single);
}

}  // namespace

OperandFrame::OperandFrame(const std::vector<FramedOperand>& operands) {
    Box box;
    std::vector<char> exact;
    for (const FramedOperand& operand : operands) {
        for (const Vec3& p : operand.mesh->vertices) {
            // Coordinates that are not finite are left to the operation, which names the operand and the vertex.
            if (p.allFinite()) {
                box.add(p + operand.mesh->origin);
            }
        }
        exact.push_back(all_single(*operand.mesh));
        single_ = single_ && (exact.back() != 0 || operand.round);
    }
    size_ = box.empty() ? 0.0 : box.largest_side();
    const SinglePrecisionGrid grid(box);
    const Vec3 origin = single_ ? grid.origin() : Vec3(Vec3::Zero());
    moved_.reserve(operands.size());
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const mesh::TriangleMesh& mesh = *operands[i].mesh;
        if (mesh.origin == origin && (exact[i] != 0 || !single_)) {
            meshes_.push_back(&mesh);
            continue;
        }
        moved_.emplace_back();
        moved_.back().origin = origin;
        moved_.back().triangles = mesh.triangles;
        moved_.back().vertices.reserve(mesh.vertices.size());
        for (const Vec3& p : mesh.vertices) {
            const Vec3 there = p + mesh.origin;
            moved_.back().vertices.push_back(single_ ? grid.snap(there) : there);
        }
        meshes_.push_back(&moved_.back());
    }
}

}  // namespace mq::workflows
