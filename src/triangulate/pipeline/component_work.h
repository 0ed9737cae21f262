// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "triangulate/components/equal_bodies.h"
#include "triangulate/components/mesh_components.h"
#include "triangulate/pipeline/refinement.h"

namespace mq::triangulate {

/// The mesh of one body after its refinement, with the measurements on it: its copies are made of this.
struct RefinedBody {
    ClassifiedMesh mesh;                              ///< without unused indices
    std::map<int, Exemption> exempt;                  ///< by triangle
    std::vector<std::uint8_t> shrinks;                ///< by vertex
    std::vector<ChordErrorCache::Measured> measured;  ///< by half-edge
};

/// Copies of refined bodies at their places, as one component.
class PlacedBodies {
  public:
    /// A copy, with indices in the component.
    struct Copy {
        const RefinedBody& original;
        int body;
        int first_vertex;
        int first_triangle;
    };

    explicit PlacedBodies(const EqualBodies& equal) : equal_(equal) {}

    /// Adds a copy of a body, which has to outlive this.
    /// @param whole  the mesh before refinement
    /// @param triangles  those of the copy in it
    /// @return whether it was added (see add_placed)
    /// @throws Cancelled
    bool add(geometry::Session& session, const SinglePrecisionGrid& grid, const RefinedBody& original, int copy,
             const ClassifiedMesh& whole, const std::vector<int>& triangles);

    const EqualBodies& equal() const { return equal_; }
    const std::vector<Copy>& copies() const { return copies_; }
    MeshComponent release_component() { return std::move(component_); }

  private:
    const EqualBodies& equal_;
    MeshComponent component_;
    std::vector<Copy> copies_;
};

/// A component of a mesh and all that refines it.
class ComponentWork {
  public:
    /// Data that the components share.
    struct Common {
        Refinement& whole;
        const ChordErrorCache& measured;  ///< measurements of the whole mesh
        const geometry::Session& session;
        const Progress& progress;  ///< progress of the component, used by its constructor, `run` and `body` only
        std::size_t budget;        ///< largest number of its triangles
    };

    /// A component of the whole mesh before its refinement.
    ComponentWork(MeshComponent component, const Common& common);
    /// Placed bodies. Their vertices stay, and triangles are changed only where rounding has broken a bound.
    ComponentWork(PlacedBodies& placed, const Common& common);

    /// Refines the component.
    /// @throws Cancelled
    void run();

    const MeshComponent& component() const { return component_; }
    const StageTimes& stages() const { return stages_; }
    const Workspace& work() const { return work_; }

    /// Cuts out a body by its faces, ascending. @throws Cancelled
    RefinedBody body(const std::vector<int>& faces) const;
    /// Passes measurements of triangles, edges and vertices on to the whole mesh, in which the component's first
    /// triangle is `first` and its vertices are `vertices`.
    void write_to(Workspace& whole, ChordErrorCache& measured, int first, const std::vector<int>& vertices);

  private:
    ComponentWork(MeshComponent component, const Common& common, bool placed);
    int index_of(int vertex_of_whole) const;
    void read_from(const Workspace& whole, const ChordErrorCache& measured);
    void read_from(const PlacedBodies& placed);
    void read_measured(const PlacedBodies::Copy& copy, const geometry::RigidMotion& motion);
    void mark_settled(double bound);
    void start(Refinement& whole, int first_vertex);

    MeshComponent component_;
    bool placed_;
    geometry::Session session_;
    Progress progress_;
    StageTimes stages_;
    StageTimer clock_{stages_};
    MaxMinSwaps maxmin_;
    Workspace work_;
    MeasurementCache findings_;
    std::optional<Refinement> refinement_;
};

}  // namespace mq::triangulate
