// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "curve/volume/editor.h"

namespace mq::curve {

namespace {

using Elements = std::vector<std::array<int, 4>>;

bool insert(VolumeEditor& editor, const std::vector<int>& removed, const Vec3& start, const std::vector<int>& replaced,
            VolumeEditor::Rule rule) {
    const int p = editor.volume.add_vertex(start, editor.tetrahedron(removed.front()).volume);
    Elements star;
    double size = 0.0;
    for (const int t : removed) {
        const std::array<int, 4>& corners = editor.tetrahedron(t).corners;
        for (std::size_t k = 0; k < 4; ++k) {
            size = std::max(size, (editor.volume.point(corners[k]) - editor.volume.point(corners[(k + 1) % 4])).norm());
            if (std::find(replaced.begin(), replaced.end(), corners[k]) != replaced.end()) {
                star.push_back(corners);
                star.back()[k] = p;
            }
        }
    }
    relocate_vertex(editor, p, star, size);
    // A vertex that no element uses stays behind when this fails; it is left out of the result.
    return editor.replace(removed, star, rule);
}

}  // namespace

bool split_region_edge(VolumeEditor& editor, int a, int b, VolumeEditor::Rule rule) {
    if (editor.volume.fixed_edge(a, b)) {
        return false;
    }
    const Vec3 middle = 0.5 * (editor.volume.point(a) + editor.volume.point(b));
    return insert(editor, editor.volume.of_edge(a, b), middle, {a, b}, rule);
}

bool split_region_face(VolumeEditor& editor, int a, int b, int c, VolumeEditor::Rule rule) {
    if (editor.volume.fixed_face(a, b, c)) {
        return false;
    }
    const Vec3 middle = (editor.volume.point(a) + editor.volume.point(b) + editor.volume.point(c)) / 3.0;
    return insert(editor, editor.volume.of_face(a, b, c), middle, {a, b, c}, rule);
}

bool split_region(VolumeEditor& editor, int tetrahedron, VolumeEditor::Rule rule) {
    const std::array<int, 4> v = editor.tetrahedron(tetrahedron).corners;
    Vec3 middle = Vec3::Zero();
    for (const int k : v) {
        middle += 0.25 * editor.volume.point(k);
    }
    return insert(editor, {tetrahedron}, middle, {v[0], v[1], v[2], v[3]}, rule);
}

}  // namespace mq::curve
