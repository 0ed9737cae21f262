// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/face_triangulation.h"
#include "geometry/motion.h"
#include "triangulate/chord_measure.h"
#include "triangulate/keys.h"
#include "triangulate/triangulate.h"

namespace mq::triangulate {

/// The final mesh of one CAD face, in words that hold for any part that has this face.
struct RememberedFace {
    /// A vertex on a CAD edge: its place in `parameters`.
    struct Knot {
        int use = -1;    ///< in the order of geometry::uses_in_order
        int index = -1;  ///< of the parameter; 0 on a collapsed edge
    };
    /// Of all vertices along the edge of each use, ascending; none of a collapsed edge.
    std::vector<std::vector<double>> parameters;
    std::vector<std::size_t> fewest;  ///< of them that an edge had in any run since it is known; 0: no run
    std::vector<Knot> knots;
    /// `vertex` of a site is an index into `knots`, `use` of a border counts as in Knot. Points are the part's.
    geometry::FaceTriangulation mesh;
    std::vector<ChordMeasure::Measured> measured;  ///< by half-edge
    double chord = 0.0;  ///< mm, as it was asked for when the face was triangulated from nothing

    std::size_t bytes() const;
};

/// What one run leaves: its result, and the faces that a later one may begin with, about 250 bytes a triangle.
struct Run {
    geometry::Fingerprint input{};  ///< Keys::input
    Result result;
    Options options;
    double chord = 0.0;                                                            ///< mm, as it was asked for; 0: not
    double resolution = 0.0;                                                       ///< of the grid, mm
    geometry::Motion place;                                                        ///< of the part
    std::map<geometry::Fingerprint, std::shared_ptr<const RememberedFace>> faces;  ///< by Keys::faces

    /// Whether its faces are of use where this is asked for.
    bool serves(const Options& now) const;
};

/// The last runs on a part that is being edited. The very same input as in one of them gets the very same result: a
/// step that is undone gives the mesh that was there. Several threads may use one memory.
class Memory {
  public:
    static constexpr std::size_t kMostRuns = 8;
    static constexpr std::size_t kMostBytes = std::size_t{1} << 29;

    /// Of more runs, or more bytes in all of them, those go that were used least lately.
    explicit Memory(std::size_t most_runs = kMostRuns, std::size_t most_bytes = kMostBytes)
        : most_runs_(most_runs), most_bytes_(most_bytes) {}

    /// The run on this input; null: there is none.
    std::shared_ptr<const Run> run_on(const geometry::Fingerprint& input);
    /// The run that has most triangles of these faces, of those that serve; of equals the one used last.
    std::shared_ptr<const Run> nearest(const std::vector<geometry::Fingerprint>& faces, const Options& options) const;
    void add(std::shared_ptr<const Run> run);

    std::size_t runs() const;
    std::size_t bytes() const;

  private:
    void forget_what_is_too_much();

    std::size_t most_runs_;
    std::size_t most_bytes_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const Run>> runs_;  // the one used last at the end
};

}  // namespace mq::triangulate
