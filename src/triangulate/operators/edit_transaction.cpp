// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/operators/edit_transaction.h"

#include <algorithm>
#include <utility>

#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/surface_alignment.h"

namespace mq::triangulate {

void EditTransaction::about_to_remove(const std::vector<int>& triangles) {
    const ClassifiedMesh& mesh = work_.mesh;
    for (const int t : triangles) {
        if (now_.erase(t) > 0) {
            continue;
        }
        Before before{t, mesh.face_of(t), {}, smallest_angle(mesh, t).angle, std::nullopt};
        before.sites = {mesh.site_of(3 * t), mesh.site_of(3 * t + 1), mesh.site_of(3 * t + 2)};
        if (const Exemption* exemption = work_.exemption_of(t)) {
            before.exemption = *exemption;
        }
        before_.push_back(before);
        alignment_ = std::min(alignment_, alignment(mesh, t));
    }
}

void EditTransaction::about_to_split(int segment) {
    const ClassifiedMesh& mesh = work_.mesh;
    split_ = Split{segment, mesh.segment_count(), {}, {}};
    for (const ClassifiedMesh::SegmentUse& use : mesh.segment(segment).uses) {
        split_->bases.push_back({mesh.site_of(use.half_edge), mesh.site_of(ClassifiedMesh::next(use.half_edge))});
        split_->faces.push_back(mesh.face_of(ClassifiedMesh::triangle_of(use.half_edge)));
    }
}

void EditTransaction::record_relocation(int near, int far) {
    const ClassifiedMesh::Segment& segment = work_.mesh.segment(near);
    Slide slide{near, far, segment.vertices[1], segment.t[1], {}};
    for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
        slide.sites[use.use] = work_.mesh.site_of(work_.mesh.leaving(use, slide.vertex));
    }
    slides_.push_back(std::move(slide));
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
    for (const Before& before : before_) {
        angles.push_back(before.angle);
    }
    return angles;
}

// Collects the triangles of one face to be removed, and those to be restored.
ClassifiedMesh::CavityFill EditTransaction::refill_of(int face) const {
    ClassifiedMesh::CavityFill refill;
    for (const int t : now_) {
        if (work_.mesh.face_of(t) == face) {
            refill.removed.push_back(t);
        }
    }
    for (const Before& before : before_) {
        if (before.face == face) {
            refill.added.push_back(before.sites);
        }
    }
    return refill;
}

// Vertices are moved back first, so that the restored triangles fit between the segments.
std::map<int, int> EditTransaction::undo() {
    std::for_each(slides_.rbegin(), slides_.rend(), [&](const Slide& slide) { undo_relocation(slide); });
    std::set<int> faces;
    for (const Before& before : before_) {
        faces.insert(before.face);
    }
    for (const int t : now_) {
        work_.exempt.erase(t);
    }
    std::map<int, std::vector<int>> again;  // by face, in the order of `before_`
    if (split_) {
        std::vector<ClassifiedMesh::CavityFill> refills;
        for (std::size_t k = 0; k < split_->faces.size(); ++k) {
            refills.push_back(refill_of(split_->faces[k]));
            refills.back().base = split_->bases[k];
        }
        const std::vector<int> joined = work_.maxmin.join_segments(split_->near, split_->far, refills);
        auto next = joined.begin();
        for (std::size_t k = 0; k < refills.size(); ++k) {
            const auto end = next + static_cast<std::ptrdiff_t>(refills[k].added.size());
            again[split_->faces[k]].assign(next, end);
            faces.erase(split_->faces[k]);
            next = end;
        }
    }
    for (const int face : faces) {
        const ClassifiedMesh::CavityFill refill = refill_of(face);
        again[face] = work_.maxmin.replace(refill.removed, refill.added);
    }
    std::map<int, int> moved;
    std::map<int, std::size_t> done;
    for (Before& before : before_) {
        const int t = again[before.face][done[before.face]++];
        moved[before.triangle] = t;
        if (before.exemption) {
            before.exemption->stamp = work_.mesh.stamp(t);
            work_.exempt[t] = *before.exemption;
        }
    }
    return moved;
}

void TransactionStack::about_to_remove(const std::vector<int>& triangles) {
    for (EditTransaction& trial : open_) {
        trial.about_to_remove(triangles);
    }
}

void TransactionStack::about_to_split(int segment) {
    for (const ClassifiedMesh::SegmentUse& use : work_.mesh.segment(segment).uses) {
        about_to_remove({ClassifiedMesh::triangle_of(use.half_edge)});
    }
    if (!open_.empty()) {
        open_.back().about_to_split(segment);
    }
}

void TransactionStack::record_relocation(int near, int far, const std::vector<int>& around) {
    about_to_remove(around);
    if (!open_.empty()) {
        open_.back().record_relocation(near, far);
    }
}

void TransactionStack::added(const std::vector<int>& triangles) {
    for (EditTransaction& trial : open_) {
        trial.added(triangles);
    }
}

std::map<int, int> TransactionStack::undo_last() {
    EditTransaction last = std::move(open_.back());
    open_.pop_back();
    about_to_remove({last.now().begin(), last.now().end()});
    std::map<int, int> moved = last.undo();
    std::vector<int> again;
    for (const auto& [before, now] : moved) {
        again.push_back(now);
    }
    added(again);
    return moved;
}

}  // namespace mq::triangulate
