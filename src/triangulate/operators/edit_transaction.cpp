// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/edit_transaction.h"

#include <algorithm>
#include <utility>

#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

void EditTransaction::about_to_remove(const std::vector<int>& triangles) {
    if (!changes_) {
        return;
    }
    const ClassifiedMesh& mesh = work_.mesh;
    for (const int t : triangles) {
        if (changes_->now.erase(t) > 0) {
            continue;
        }
        Before before{t, mesh.face_of(t), {}, smallest_angle(mesh, t).angle, std::nullopt};
        before.sites = {mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)};
        if (const Exemption* exemption = work_.exemption_of(t)) {
            before.exemption = *exemption;
        }
        changes_->before.push_back(before);
        changes_->alignment = std::min(changes_->alignment, alignment(mesh, t));
    }
}

void EditTransaction::added(const std::vector<int>& triangles) {
    if (changes_) {
        changes_->now.insert(triangles.begin(), triangles.end());
    }
}

void EditTransaction::record_relocation(int near, int far, const std::vector<int>& around) {
    if (!changes_) {
        return;
    }
    about_to_remove(around);
    const ClassifiedMesh::Segment& segment = work_.mesh.segment(near);
    Slide slide{near, far, segment.vertices[1], segment.t[1], {}};
    for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
        slide.sites[use.use] = work_.mesh.site_of(work_.mesh.leaving(use, slide.vertex));
    }
    changes_->slides.push_back(std::move(slide));
}

void EditTransaction::undo_relocation(const Slide& slide) {
    const ClassifiedMesh::Segment& segment = work_.mesh.segment(slide.near);
    std::vector<std::vector<int>> spokes;
    std::vector<int> sites;
    for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
        spokes.push_back(work_.mesh.star(work_.mesh.leaving(use, segment.vertices[1])));
        sites.push_back(slide.sites.at(use.use));
    }
    work_.maxmin.replace_between(slide.near, slide.far, slide.vertex, slide.t, spokes, sites);
}

std::vector<double> EditTransaction::angles_before() const {
    std::vector<double> angles;
    for (const Before& before : changes_->before) {
        angles.push_back(before.angle);
    }
    return angles;
}

// Collects the triangles of one face to be removed, and those to be restored.
ClassifiedMesh::CavityFill EditTransaction::refill_of(const Changes& changes, int face) const {
    ClassifiedMesh::CavityFill refill;
    for (const int t : changes.now) {
        if (work_.mesh.face_of(t) == face) {
            refill.removed.push_back(t);
        }
    }
    for (const Before& before : changes.before) {
        if (before.face == face) {
            refill.added.push_back(before.sites);
        }
    }
    return refill;
}

// @return by face, in the order of `before`: the restored triangles
std::map<int, std::vector<int>> EditTransaction::restore_triangles(const Changes& changes) {
    std::set<int> faces;
    for (const Before& before : changes.before) {
        faces.insert(before.face);
    }
    std::map<int, std::vector<int>> again;
    for (const int face : faces) {
        const ClassifiedMesh::CavityFill refill = refill_of(changes, face);
        again[face] = work_.maxmin.replace(refill.removed, refill.added);
    }
    return again;
}

// Vertices are moved back first, so that the restored triangles fit between the segments.
std::map<int, int> EditTransaction::undo() {
    const Changes changes = std::move(*changes_);
    changes_.reset();
    std::for_each(changes.slides.rbegin(), changes.slides.rend(), [&](const Slide& slide) { undo_relocation(slide); });
    for (const int t : changes.now) {
        work_.exempt.erase(t);
    }
    const std::map<int, std::vector<int>> again = restore_triangles(changes);
    std::map<int, int> moved;
    std::map<int, std::size_t> done;
    for (const Before& before : changes.before) {
        const int t = again.at(before.face)[done[before.face]++];
        moved[before.triangle] = t;
        if (before.exemption) {
            Exemption& exemption = work_.exempt[t] = *before.exemption;
            exemption.stamp = work_.mesh.stamp(t);
        }
    }
    return moved;
}

}  // namespace mq::triangulate
