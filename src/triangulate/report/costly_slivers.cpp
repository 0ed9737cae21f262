// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/costly_slivers.h"

#include <algorithm>
#include <vector>

#include "base/message.h"
#include "base/vec.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/topology.h"
#include "mesh/quality/exemptions.h"
#include "triangulate/work_mesh/options.h"

namespace mq::triangulate {

namespace {

using mesh::Triangle;

/// Faces of a shape, as their triangles show them.
class FaceWidths {
  public:
    explicit FaceWidths(const mesh::TriangleMesh& mesh) : mesh_(mesh) {
        const auto last = std::max_element(mesh.triangle_face.begin(), mesh.triangle_face.end());
        const auto count = static_cast<std::size_t>(last == mesh.triangle_face.end() ? 0 : *last + 1);
        width_.assign(count, 0.0);
        std::vector<Box> boxes(count);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto face = static_cast<std::size_t>(mesh.triangle_face[t]);
            const Triangle& c = mesh.triangles[t];
            for (const std::int32_t v : c) {
                boxes[face].add(at(v));
            }
            width_[face] += 0.5 * (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0])).norm();
        }
        for (std::size_t f = 0; f < count; ++f) {
            length_.push_back(boxes[f].empty() ? 0.0 : (boxes[f].high - boxes[f].low).norm());
            width_[f] = length_[f] > 0.0 ? width_[f] / length_[f] : 0.0;
        }
    }

    /// mm: the area divided by the largest extent, which is about the mean width of a sliver.
    double width(std::size_t face) const { return width_[face]; }
    std::vector<std::size_t> slivers() const {
        constexpr double kNarrow = 1e-3;  // width / length: with less, a strip takes more than 2000 triangles
        std::vector<std::size_t> found;
        for (std::size_t f = 0; f < width_.size(); ++f) {
            if (width_[f] > 0.0 && width_[f] < kNarrow * length_[f]) {
                found.push_back(f);
            }
        }
        return found;
    }
    /// For each face whether it is one of the slivers, or shares a vertex with one.
    std::vector<char> beside(const std::vector<std::size_t>& slivers) const {
        std::vector<char> is_sliver(width_.size(), 0);
        for (const std::size_t f : slivers) {
            is_sliver[f] = 1;
        }
        std::vector<char> on_sliver(mesh_.vertices.size(), 0);
        std::vector<char> found = is_sliver;
        for (const bool marking : {true, false}) {
            for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
                const auto face = static_cast<std::size_t>(mesh_.triangle_face[t]);
                for (const std::int32_t v : mesh_.triangles[t]) {
                    char& on = on_sliver[static_cast<std::size_t>(v)];
                    on = static_cast<char>(on | (marking ? is_sliver[face] : 0));
                    found[face] = static_cast<char>(found[face] | (marking ? 0 : on));
                }
            }
        }
        return found;
    }
    double shortest_side(std::size_t t) const {
        const Triangle& c = mesh_.triangles[t];
        return std::min({(at(c[1]) - at(c[0])).norm(), (at(c[2]) - at(c[1])).norm(), (at(c[0]) - at(c[2])).norm()});
    }

  private:
    const Vec3& at(std::int32_t v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }

    const mesh::TriangleMesh& mesh_;
    std::vector<double> width_;
    std::vector<double> length_;
};

}  // namespace

Message costly_slivers(const mesh::TriangleMesh& mesh, double size) {
    constexpr std::size_t kCostly = 10'000;  // triangles
    constexpr double kSmall = 8.0;           // widths: sides of triangles that grow away from a sliver
    if (mesh.triangles.size() < kCostly || mesh.triangle_face.size() != mesh.triangles.size() ||
        *std::min_element(mesh.triangle_face.begin(), mesh.triangle_face.end()) < 0) {
        return {};
    }
    const FaceWidths faces(mesh);
    const std::vector<std::size_t> slivers = faces.slivers();
    if (slivers.empty()) {
        return {};
    }
    std::vector<std::string> names;
    double widest = 0.0;
    for (const std::size_t f : slivers) {
        names.push_back(geometry::name_of({2, static_cast<int>(f)}));
        widest = std::max(widest, faces.width(f));
    }
    const std::vector<char> beside = faces.beside(slivers);
    std::size_t small = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (beside[static_cast<std::size_t>(mesh.triangle_face[t])] != 0 && faces.shortest_side(t) <= kSmall * widest) {
            ++small;
        }
    }
    if (small < kCostly || 4 * small < mesh.triangles.size()) {
        return {};
    }
    return {widest < TriangulateOptions::kLargestDetail * size ? phrases::kCostlySliversOr : phrases::kCostlySlivers,
            {{"list", mesh::list_of(names)},
             {"length", in_mm(widest, 2)},
             {"count", small},
             {"count2", mesh.triangles.size()},
             {"length2", in_mm(1.5 * widest / TriangulateOptions::kDetailOfWhatIsAsked, 2)}}};
}

}  // namespace mq::triangulate
