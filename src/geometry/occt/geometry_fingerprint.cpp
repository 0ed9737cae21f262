// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/geometry_fingerprint.h"

#include <BRep_Tool.hxx>
#include <GeomTools_Curve2dSet.hxx>
#include <GeomTools_CurveSet.hxx>
#include <GeomTools_SurfaceSet.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

namespace {

Fingerprint fingerprint_of(const std::string& text) {
    Fingerprint result{};
    for (std::size_t from = 0; from < text.size(); from += sizeof(std::uint64_t)) {
        std::uint64_t piece = 0;
        std::memcpy(&piece, text.data() + from, std::min(sizeof piece, text.size() - from));
        add_to(result, piece);
    }
    return result;
}

// A unique fingerprint, for kinds of geometry that OpenCASCADE cannot write.
Fingerprint like_nothing_else() {
    static std::atomic<std::uint64_t> count{0};
    Fingerprint result{};
    add_to(result, ++count);
    return result;
}

}  // namespace

GeometryFingerprint::GeometryFingerprint(const TopoDS_Shape& part) {
    text_.precision(std::numeric_limits<double>::max_digits10);
    if (const auto motion = motion_of(part.Location())) {
        to_own_frame_ = part.Location().Inverted();
        place_ = *motion;
    }
}

std::optional<RigidMotion> GeometryFingerprint::motion_of(const TopLoc_Location& location) {
    const gp_Trsf trsf = location.Transformation();
    if (!is_rigid(trsf)) {
        return std::nullopt;
    }
    RigidMotion motion;
    const gp_Mat turn = trsf.VectorialPart();
    for (int i = 0; i < 3; ++i) {
        motion.turn.col(i) = to_vec(turn.Column(i + 1));
    }
    motion.shift = to_vec(trsf.TranslationPart());
    return motion;
}

// The locations of an entity and of a face of the same solid begin alike, which cancels without any rounding.
void GeometryFingerprint::add_location(const TopLoc_Location& location, const TopLoc_Location* frame,
                                       Fingerprint& key) const {
    const gp_Trsf trsf = ((frame != nullptr ? frame->Inverted() : to_own_frame_) * location).Transformation();
    for (int row = 1; row <= 3; ++row) {
        for (int column = 1; column <= 4; ++column) {
            add_to(key, trsf.Value(row, column));
        }
    }
}

template <typename Geometry, typename Print>
void GeometryFingerprint::add_geometry(const Geometry& geometry, const Print& print, Fingerprint& key) {
    if (geometry.IsNull()) {
        add_to(key, 0);
        return;
    }
    const auto [entry, fresh] = known_.emplace(geometry.get(), Fingerprint{});
    if (fresh) {
        text_.str({});
        print(geometry, text_);
        entry->second = text_.str().empty() ? like_nothing_else() : fingerprint_of(text_.str());
    }
    add_to(key, entry->second);
}

void GeometryFingerprint::add_face(const TopoDS_Face& face, const TopLoc_Location* frame, Fingerprint& key) {
    TopLoc_Location location;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
    add_location(location, frame, key);
    add_geometry(
        surface, [](const auto& s, std::ostream& out) { GeomTools_SurfaceSet::PrintSurface(s, out, true); }, key);
}

void GeometryFingerprint::add_edge(const TopoDS_Edge& edge, const TopLoc_Location* frame, Fingerprint& key) {
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
    add_location(location, frame, key);
    add_geometry(
        curve, [](const auto& c, std::ostream& out) { GeomTools_CurveSet::PrintCurve(c, out, true); }, key);
}

// The point of a vertex is defined before its location is applied.
void GeometryFingerprint::add_node(const TopoDS_Vertex& node, const TopLoc_Location* frame, Fingerprint& key) {
    add_location(node.Location(), frame, key);
    add_to(key, to_vec(BRep_Tool::Pnt(TopoDS::Vertex(node.Located(TopLoc_Location())))));
}

void GeometryFingerprint::add_use(const PCurve& use, Fingerprint& key) {
    add_to(key, use.of_neighbour ? 1 : 0);
    add_to(key, use.first);
    add_to(key, use.last);
    add_geometry(
        use.curve, [](const auto& c, std::ostream& out) { GeomTools_Curve2dSet::PrintCurve2d(c, out, true); }, key);
}

}  // namespace mq::geometry
