// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/shape_model.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopAbs.hxx>
#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/single_precision_grid.h"
#include "base/waits.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/closed_edge.h"
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/edge_curves.h"
#include "geometry/occt/evaluation/face_corner.h"
#include "geometry/occt/evaluation/face_evaluator.h"
#include "geometry/occt/evaluation/failure_text.h"
#include "geometry/occt/geometry_fingerprint.h"
#include "geometry/occt/narrow/border_contacts.h"
#include "geometry/occt/narrow/corner_cuts.h"
#include "geometry/occt/narrow/degenerate_faces.h"
#include "geometry/occt/narrow/loose_faces.h"
#include "geometry/occt/narrow/spikes.h"
#include "geometry/occt/narrow/touching_edges.h"
#include "geometry/occt/plane_curves.h"
#include "geometry/occt/topology/creases.h"
#include "geometry/occt/topology/imprint.h"
#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

namespace {

Answer refused(Status status) {
    Answer answer;
    answer.status = status;
    return answer;
}

bool finite(const Query& query) {
    return std::isfinite(query.u) && std::isfinite(query.v) && std::isfinite(query.t) && std::isfinite(query.t2) &&
           std::isfinite(query.distance) && query.point.allFinite() && query.along.allFinite();
}

/// The box of a shape before its entities are known.
Box box_of(const TopoDS_Shape& shape) {
    Bnd_Box bounds;
    BRepBndLib::Add(shape, bounds, Standard_False);
    return to_box(bounds);
}

/// The evaluators of a shape's entities, each made when it is first asked for. Several objects may answer for one shape
/// at a time: what they share is only read.
class ShapeAnswerer final : public Answerer {
  public:
    ShapeAnswerer(const ShapeMap& live, const Topology& topology, Evaluation evaluation)
        : live_(live), topology_(topology), evaluation_(evaluation), edges_(evaluation) {}
    Answer answer(const Query& query) noexcept override;
    FaceEvaluator& face(int index);
    /// Takes over the curves that were made while the shape was read.
    void adopt(EdgeCurves curves) { edges_ = std::move(curves); }
    /// Drops the evaluators of entities that have changed.
    void forget_face(int index) {
        if (index < static_cast<int>(faces_.size())) {
            faces_[static_cast<std::size_t>(index)].reset();
        }
    }

  private:
    Answer dispatch(const Query& query);
    Answer on_edge(const Query& query);
    Answer on_face(const Query& query);
    Answer use_on_face(int index, double t);
    Answer volume_contains(int index, const Vec3& point);
    const EdgeEvaluator& edge(int index);

    const ShapeMap& live_;
    const Topology& topology_;
    Evaluation evaluation_;
    EdgeCurves edges_;
    std::vector<std::unique_ptr<FaceEvaluator>> faces_;
    std::vector<std::unique_ptr<BRepClass3d_SolidClassifier>> classifiers_;
};

class ShapeModel final : public Model {
  public:
    ShapeModel(const TopoDS_Shape& given, Creases creases, const VirtualTopology& join, Evaluation evaluation,
               const Progress* progress);
    Answer answer(const Query& query) noexcept override { return first_.answer(query); }
    Answerer* answerer(int thread) override;
    std::optional<ElementarySurface> elementary_surface(int index) override { return first_.face(index).elementary(); }
    std::optional<RigidMotion> place_of_face(int face) override {
        return GeometryFingerprint::motion_of(live_.faces[static_cast<std::size_t>(face)].Location());
    }
    std::optional<double> corner_angle(int face, int node) override {
        return smallest_corner(live_.faces[static_cast<std::size_t>(face)],
                               live_.nodes[static_cast<std::size_t>(node)]);
    }
    void add_definition(Entity entity, int frame, Fingerprint& key) override;
    void add_definition_of_use(int use, Fingerprint& key) override;

  private:
    void read_topology(const TopoDS_Shape& shape, Creases creases, const VirtualTopology& join,
                       std::vector<std::string>& failures, const Progress* progress);

    ShapeMap live_;
    GeometryFingerprint definitions_;
    Evaluation evaluation_;
    ShapeAnswerer first_;
    std::vector<std::unique_ptr<ShapeAnswerer>> further_;
};

/// The item at an index of a list, which is extended up to the index if it is shorter.
template <typename Item>
Item& reached(std::vector<Item>& list, int index) {
    const auto i = static_cast<std::size_t>(index);
    if (list.size() <= i) {
        list.resize(i + 1);
    }
    return list[i];
}

ShapeModel::ShapeModel(const TopoDS_Shape& given, Creases creases, const VirtualTopology& join, Evaluation evaluation,
                       const Progress* progress)
    : definitions_(given), evaluation_(evaluation), first_(live_, topology_, evaluation) {
    place_ = definitions_.place();
    TopoDS_Shape shape;
    {
        const OpenCascadeWait wait(progress, "reading the shape");
        shape = with_plane_curves(given, progress);
    }
    std::vector<std::string> failures;
    read_topology(shape, creases, join, failures, progress);
    if (evaluation == Evaluation::Fast) {
        first_.adopt(std::exchange(live_.curves, EdgeCurves()));
    }
    topology_.faults.insert(topology_.faults.end(), failures.begin(), failures.end());
    const std::vector<std::string> faults = kernel_faults(shape, live_, topology_, progress);
    topology_.faults.insert(topology_.faults.end(), faults.begin(), faults.end());
}

void ShapeModel::read_topology(const TopoDS_Shape& shape, Creases creases, const VirtualTopology& join,
                               std::vector<std::string>& failures, const Progress* progress) {
    OrderedShape entities;
    {
        const OpenCascadeWait wait(progress, "reading the shape");
        entities = ordered(shape, progress);
        if (join.imprint) {
            const double within = join.detail ? join.detail(box_of(shape)) : 0.0;
            entities = imprint_contacts(std::move(entities), within, failures, progress);
        }
        if (creases == Creases::Cut) {
            entities = cut_at_creases(std::move(entities), failures, progress);
        }
        check_cancelled(progress);
        topology_ = build_topology(entities, live_, progress);
    }
    topology_.imprinted = join.imprint;
    check_cancelled(progress);
    const auto evaluator = [this](int index) -> FaceEvaluator& { return first_.face(index); };
    {
        const OpenCascadeWait wait(progress, "measuring the size");
        topology_.box = bounding_box(shape, live_, topology_, evaluator, progress);
    }
    if (join.detail) {
        static_cast<void>(SinglePrecisionGrid(topology_.box));  // refuses an unbounded part before edges are searched
        topology_.detail = join.detail(topology_.box);
    }
    const OpenCascadeWait wait(progress, "reading the shape");
    remove_degenerate_faces(entities, topology_, live_, progress);
    if (remove_spikes(topology_, live_, progress)) {
        remove_degenerate_faces(entities, topology_, live_, progress);  // what remains of a face can be thin, too
    }
    join_touching_edges(topology_, live_, progress);
    join_border_contacts(topology_, live_, progress);
    cut_narrow_corners(topology_, live_, join.corner_cuts, progress);
    topology_.sewn = join.sew && topology_.detail > 0.0;
    if (topology_.sewn) {
        for (const int turned : join_loose_faces(topology_, live_, progress)) {
            first_.forget_face(turned);  // it has cached the size and side of the former face
        }
    }
    check_cancelled(progress);
}

Answerer* ShapeModel::answerer(int thread) {
    if (thread == 0) {
        return this;
    }
    std::unique_ptr<ShapeAnswerer>& further = reached(further_, thread - 1);
    if (!further) {
        further = std::make_unique<ShapeAnswerer>(live_, topology_, evaluation_);
    }
    return further.get();
}

void ShapeModel::add_definition(Entity entity, int frame, Fingerprint& key) {
    const auto i = static_cast<std::size_t>(entity.index);
    const TopLoc_Location* const place =
        frame >= 0 ? &live_.faces[static_cast<std::size_t>(frame)].Location() : nullptr;
    if (entity.dimension == 0) {
        definitions_.add_node(live_.nodes[i], place, key);
    } else if (entity.dimension == 1) {
        definitions_.add_edge(live_.edges[i], place, key);
    } else {
        definitions_.add_face(live_.faces[i], place, key);
    }
}

void ShapeModel::add_definition_of_use(int use, Fingerprint& key) {
    definitions_.add_use(live_.uses[static_cast<std::size_t>(use)], key);
}

const EdgeEvaluator& ShapeAnswerer::edge(int index) {
    const auto i = static_cast<std::size_t>(index);
    return edges_.of(index, live_.edges[i], topology_.edges[i]);
}

FaceEvaluator& ShapeAnswerer::face(int index) {
    const auto i = static_cast<std::size_t>(index);
    std::unique_ptr<FaceEvaluator>& evaluator = reached(faces_, index);
    if (!evaluator) {
        evaluator = std::make_unique<FaceEvaluator>(live_.faces[i], topology_.faces[i], evaluation_);
    }
    return *evaluator;
}

Answer ShapeAnswerer::answer(const Query& query) noexcept {
    try {
        return finite(query) && query.index >= 0 ? dispatch(query) : refused(Status::BadQuery);
    } catch (const Standard_Failure&) {
        return refused(Status::KernelFailure);
    } catch (const std::exception&) {
        return refused(Status::KernelFailure);
    }
}

Answer ShapeAnswerer::dispatch(const Query& query) {
    using Kind = Query::Kind;
    switch (query.kind) {
        case Kind::EdgePoint:
        case Kind::EdgeMiddle:
        case Kind::EdgeAtDistance:
        case Kind::EdgeNearest:
        case Kind::EdgeLength:
            return on_edge(query);
        case Kind::UseOnFace:
            return use_on_face(query.index, query.t);
        case Kind::VolumeContains:
            return volume_contains(query.index, query.point);
        default:
            return on_face(query);
    }
}

Answer ShapeAnswerer::on_edge(const Query& query) {
    if (query.index >= static_cast<int>(live_.edges.size()) ||
        topology_.edges[static_cast<std::size_t>(query.index)].degenerate) {
        return refused(Status::BadQuery);
    }
    const EdgeEvaluator& curve = edge(query.index);
    switch (query.kind) {
        case Query::Kind::EdgePoint:
            return curve.point(query.t);
        case Query::Kind::EdgeMiddle:
            return curve.middle(query.t, query.t2);
        case Query::Kind::EdgeAtDistance:
            return curve.at_distance(query.t, query.t2, query.distance);
        case Query::Kind::EdgeNearest:
            return curve.nearest(query.point, query.t, query.u, query.v);
        default:
            return curve.length(query.t, query.t2);
    }
}

Answer ShapeAnswerer::on_face(const Query& query) {
    if (query.index >= static_cast<int>(live_.faces.size())) {
        return refused(Status::BadQuery);
    }
    FaceEvaluator& surface = face(query.index);
    switch (query.kind) {
        case Query::Kind::FacePoint:
            return surface.point(query.u, query.v);
        case Query::Kind::FaceDerivatives:
            return surface.derivatives(query.u, query.v);
        case Query::Kind::FaceCurvatures:
            return surface.curvatures(query.u, query.v);
        case Query::Kind::FaceNearest:
            return surface.nearest(query.point, query.u, query.v);
        case Query::Kind::FaceNearestGlobal:
            return surface.nearest_global(query.point);
        case Query::Kind::FaceOnLine:
            return surface.on_line(query.point, query.along, query.u, query.v);
        default:
            return surface.contains(query.u, query.v, query.distance);
    }
}

Answer ShapeAnswerer::use_on_face(int index, double t) {
    if (index >= static_cast<int>(topology_.uses.size())) {
        return refused(Status::BadQuery);
    }
    const EdgeUse& use = topology_.uses[static_cast<std::size_t>(index)];
    const Edge& data = topology_.edges[static_cast<std::size_t>(use.edge)];
    const PCurve& pcurve = live_.uses[static_cast<std::size_t>(index)];
    const double range = data.t1 - data.t0;
    t = in_first_turn(data, t);
    if (t < data.t0 - 1e-9 * range || t > data.t1 + 1e-9 * range) {
        return refused(Status::BadQuery);
    }
    FaceEvaluator& surface = face(use.face);
    if (pcurve.curve.IsNull()) {
        return data.degenerate ? refused(Status::NotFound) : surface.nearest_global(edge(use.edge).point(t).point);
    }
    double s = t;
    if ((pcurve.first != data.t0 || pcurve.last != data.t1) && range > 0.0) {
        s = pcurve.first + (t - data.t0) / range * (pcurve.last - pcurve.first);
    }
    const gp_Pnt2d uv = pcurve.curve->Value(s);
    Answer answer = surface.point_of_curve(uv.X(), uv.Y());
    if (!data.degenerate) {
        const Vec3 target = edge(use.edge).point(t).point;
        const double tolerance =
            std::max(data.tolerance, topology_.faces[static_cast<std::size_t>(use.face)].tolerance);
        answer.distance = (answer.point - target).norm();
        // At a pole the nearest point may have any parameter along the collapsed side: that of the curve is the right
        // one.
        const bool near_neighbour = pcurve.of_neighbour && answer.status != Status::Singular;
        if (answer.distance > 10.0 * tolerance || near_neighbour) {
            const Answer better = surface.nearest(target, answer.u, answer.v);
            if (better.found() && better.distance < answer.distance) {
                answer = better;
            }
        }
    }
    answer.t = t;
    return answer;
}

Answer ShapeAnswerer::volume_contains(int index, const Vec3& point) {
    if (index >= static_cast<int>(live_.volumes.size()) ||
        topology_.volumes[static_cast<std::size_t>(index)].kind == Volume::Kind::Faces) {
        return refused(Status::BadQuery);
    }
    const auto i = static_cast<std::size_t>(index);
    // The query is answered in the shape's own coordinates: OpenCASCADE's classifier fails in mirrored and scaled
    // locations.
    const TopLoc_Location& location = live_.volumes[i].Location();
    std::unique_ptr<BRepClass3d_SolidClassifier>& classifier = reached(classifiers_, index);
    if (!classifier) {
        classifier = std::make_unique<BRepClass3d_SolidClassifier>(live_.volumes[i].Located(TopLoc_Location()));
    }
    // Distance from the boundary that counts as zero, mm: OpenCASCADE's default tolerance.
    constexpr double kOn = 1e-7;
    classifier->Perform(to_pnt(point).Transformed(location.Transformation().Inverted()), kOn);
    const TopAbs_State state = classifier->State();
    Answer answer = refused(state == TopAbs_UNKNOWN ? Status::NotFound : Status::Ok);
    answer.side = state == TopAbs_IN ? 1 : (state == TopAbs_ON ? 0 : -1);
    answer.point = point;
    return answer;
}

}  // namespace

Box box_of_shape(const TopoDS_Shape& shape) {
    Box box = make_shape_model(shape)->topology().box;
    Bnd_Box quick;
    BRepBndLib::Add(shape, quick, Standard_False);
    if (!quick.IsVoid() && !quick.IsOpen()) {
        quick.SetGap(0.0);
        box.low = box.low.cwiseMax(to_vec(quick.CornerMin()));
        box.high = box.high.cwiseMin(to_vec(quick.CornerMax()));
    }
    return box;
}

std::shared_ptr<Model> make_shape_model(const TopoDS_Shape& shape, const Progress* progress, Creases creases,
                                        const VirtualTopology& join, Evaluation evaluation) {
    if (shape.IsNull()) {
        throw InvalidInput(phrases::kShapeNull);
    }
    try {
        auto model = std::make_shared<ShapeModel>(shape, creases, join, evaluation, progress);
        if (model->topology().faces.empty()) {
            throw InvalidInput(phrases::kNoFacesInType, {{"value", TopAbs::ShapeTypeToString(shape.ShapeType())}});
        }
        return model;
    } catch (const Standard_Failure& failure) {
        throw GeometryError(phrases::kKernelFails, {{"text", failure_text(failure)}});
    }
}

const char* occt_version() {
    return OCC_VERSION_COMPLETE;
}

}  // namespace mq::geometry
