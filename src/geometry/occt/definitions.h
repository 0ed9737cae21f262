// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Transient.hxx>
#include <TopLoc_Location.hxx>
#include <map>
#include <sstream>

#include "geometry/fingerprint.h"
#include "geometry/motion.h"
#include "geometry/occt/live_shape.h"

namespace mq::geometry {

/// Fingerprints of the numbers that OpenCASCADE's geometry is made of: as its own text has them, with all digits.
class Definitions {
  public:
    /// Definitions are relative to the location of `part`, unless that is no rigid motion.
    explicit Definitions(const TopoDS_Shape& part);

    /// The location of the part.
    const Motion& place() const { return place_; }
    void add_face(const TopoDS_Face& face, Fingerprint& key);
    void add_edge(const TopoDS_Edge& edge, Fingerprint& key);
    void add_node(const TopoDS_Vertex& node, Fingerprint& key);
    void add_use(const UseCurve& use, Fingerprint& key);

  private:
    void add_location(const TopLoc_Location& location, Fingerprint& key) const;
    template <typename Geometry, typename Print>
    void add_geometry(const Geometry& geometry, const Print& print, Fingerprint& key);

    TopLoc_Location to_own_frame_;
    Motion place_;
    /// Faces share surfaces. The part keeps these alive.
    std::map<const Standard_Transient*, Fingerprint> known_;
    std::ostringstream text_;
};

}  // namespace mq::geometry
