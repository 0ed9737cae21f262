// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Transient.hxx>
#include <TopLoc_Location.hxx>
#include <map>
#include <optional>
#include <sstream>

#include "geometry/fingerprint.h"
#include "geometry/occt/topology/shape_map.h"
#include "geometry/rigid_motion.h"

namespace mq::geometry {

/// Fingerprints of the numbers that define OpenCASCADE's geometry: as in its own text, with all digits.
class GeometryFingerprint {
  public:
    /// Numbers are relative to the location of the shape `part`, unless that is no rigid motion.
    explicit GeometryFingerprint(const TopoDS_Shape& part);

    /// The location of the shape.
    const RigidMotion& place() const { return place_; }
    /// The motion of a location; none where it scales or mirrors.
    static std::optional<RigidMotion> motion_of(const TopLoc_Location& location);

    /// Adds the numbers of an entity in the frame at the location `frame`; null: the shape's own.
    void add_face(const TopoDS_Face& face, const TopLoc_Location* frame, Fingerprint& key);
    void add_edge(const TopoDS_Edge& edge, const TopLoc_Location* frame, Fingerprint& key);
    void add_node(const TopoDS_Vertex& node, const TopLoc_Location* frame, Fingerprint& key);
    void add_use(const PCurve& use, Fingerprint& key);

  private:
    void add_location(const TopLoc_Location& location, const TopLoc_Location* frame, Fingerprint& key) const;
    template <typename Geometry, typename Print>
    void add_geometry(const Geometry& geometry, const Print& print, Fingerprint& key);

    TopLoc_Location to_own_frame_;
    RigidMotion place_;
    /// By surface or curve, which faces share; the shape keeps these objects alive.
    std::map<const Standard_Transient*, Fingerprint> known_;
    std::ostringstream text_;
};

}  // namespace mq::geometry
