// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/rigid_motion.h"
#include "triangulate/incremental/cache_keys.h"
#include "triangulate/initial/face_triangulator.h"
#include "triangulate/measure/chord_error.h"
#include "triangulate/work_mesh/options.h"
#include "triangulate/work_mesh/result.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// The final mesh of one CAD face, numbered such that it fits any shape with this face.
struct CachedFace {
    /// A vertex on a CAD edge: its place in `parameters`.
    struct EdgeParameter {
        int use = -1;    ///< index into uses_in_order
        int index = -1;  ///< index of the parameter; 0 on a collapsed edge
    };
    /// An exempt triangle: it keeps an angle below the bound, for a cause that lies on the face's border.
    struct GivenUp {
        int triangle = -1;  ///< index into the triangles of `mesh`
        Cause cause = Cause::NoImprovingChange;
        EdgeParameter vertex;  ///< the vertex that causes it; `use` is -1 if there is none
        int use = -1;          ///< the edge that causes it, as an index into uses_in_order, or -1
    };
    /// Parameters of all vertices along the edge of each use, ascending; empty for a collapsed edge.
    std::vector<std::vector<double>> parameters;
    /// By use: the least number of vertices its edge had in any run since it is known; 0: none.
    std::vector<std::size_t> min_sample_count;
    std::vector<EdgeParameter> edge_parameters;
    /// `vertex` of a site is an index into `edge_parameters`, `use` of a border counts as in EdgeParameter. Points are
    /// in the shape's coordinates.
    FaceMesh mesh;
    std::vector<ChordErrorCache::Measured> measured;  ///< by half-edge
    std::vector<GivenUp> given_up;                    ///< only those whose cause lies on the face's border
    double chord = 0.0;  ///< chord tolerance in mm when the face was triangulated from scratch

    std::size_t bytes() const;
};

/// The cached data of one run: its result, and the faces that a later run may start with; about 250 bytes per
/// triangle.
struct CachedRun {
    geometry::Fingerprint input{};  ///< CacheKeys::input
    Result result;
    TriangulateOptions options;
    double chord = 0.0;                                                        ///< chord tolerance, mm; 0: none
    double resolution = 0.0;                                                   ///< resolution of the grid, mm
    geometry::RigidMotion place;                                               ///< placement of the shape
    std::map<geometry::Fingerprint, std::shared_ptr<const CachedFace>> faces;  ///< by CacheKeys::faces

    /// Whether its faces may be reused with these options.
    bool serves(const TriangulateOptions& now) const;
};

/// The most recent runs on a shape that is being edited. An identical input returns the cached result, so that undoing
/// a step restores its mesh. Several threads may use one memory.
class MeshCache {
  public:
    static constexpr std::size_t kMostRuns = 8;  // A few steps of undo and redo.
    // 512 MB, about two million triangles at 250 bytes each.
    static constexpr std::size_t kMostBytes = std::size_t{1} << 29;

    /// Evicts the least recently used runs once there are more than `most_runs`, or once they exceed `most_bytes`
    /// together.
    explicit MeshCache(std::size_t most_runs = kMostRuns, std::size_t most_bytes = kMostBytes)
        : most_runs_(most_runs), most_bytes_(most_bytes) {}

    /// Returns the run with this input; null: there is none.
    std::shared_ptr<const CachedRun> run_on(const geometry::Fingerprint& input);
    /// Returns the run with the most triangles on these faces among those that serve the options; the most recently
    /// used one if several are equal.
    std::shared_ptr<const CachedRun> nearest(const std::vector<geometry::Fingerprint>& faces,
                                             const TriangulateOptions& options) const;
    void add(std::shared_ptr<const CachedRun> run);

    std::size_t runs() const;
    std::size_t bytes() const;

  private:
    void evict();

    std::size_t most_runs_;
    std::size_t most_bytes_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const CachedRun>> runs_;  // the most recently used run is last
};

}  // namespace mq::triangulate
