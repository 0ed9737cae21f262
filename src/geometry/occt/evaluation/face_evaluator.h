// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepTopAdaptor_FClass2d.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/elementary/surface.h"
#include "geometry/evaluation.h"
#include "geometry/occt/evaluation/spline_surface_pieces.h"
#include "geometry/query.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// Answers for one face. The surface is evaluated in its own coordinates, in which the curves of the edges are given;
/// points and derivatives are transformed by the face's location.
class FaceEvaluator {
  public:
    /// @param shape is reoriented to FORWARD
    /// @param data is the same face in the topology
    FaceEvaluator(const TopoDS_Face& shape, const Face& data, Evaluation evaluation = Evaluation::Fast);

    Answer point(double u, double v) const;
    Answer derivatives(double u, double v) const;
    Answer curvatures(double u, double v) const;
    Answer nearest(const Vec3& point, double u, double v);
    Answer nearest_global(const Vec3& point);
    /// The point of the surface on the line through `point`, by Newton's method from a guess; `along` is a unit vector.
    Answer on_line(const Vec3& point, const Vec3& along, double u, double v) const;
    /// @param border  mm: half the width of the strip that counts as the border, if it is less than the face's
    /// tolerance; 0: the tolerance
    Answer contains(double u, double v, double border);
    /// The surface by formula, with the face's location; empty where there is none.
    std::optional<ElementarySurface> elementary() const;
    /// Extends the box so that it holds the face, given that it holds its edges.
    void add_to(Box& box);
    /// The same as `point`, for a (u, v) on a curve of the shape: a point out of the surface's bounds is moved into
    /// them.
    Answer point_of_curve(double u, double v) const;

  private:
    /// The result of a search for the nearest point.
    struct Projection {
        Vec2 uv = Vec2::Zero();
        double square = 0.0;
        bool found = false;
        SurfacePoint at{};  ///< point and first derivatives at the parameters, once they are computed
    };
    struct Step {
        Vec2 move = Vec2::Zero();
        bool minimum = false;  ///< the distance is convex here, so that a vanishing step means a minimum
        Vec2 squares;          ///< squared lengths of Su and Sv
    };

    void set_bounds(const Face& data);
    void set_references();
    void set_elementary();
    bool legal(double u, double v) const;
    Vec2 into_domain(double u, double v) const;
    bool in_a_patch(double u, double v) const;
    Vec3 place(double u, double v) const;
    SurfacePoint first(double u, double v) const;
    SurfacePoint second(double u, double v) const;
    SurfacePoint placed(SurfacePoint s) const;
    Vec3 local(const Vec3& point) const;
    std::optional<Vec3> regular_normal(const SurfacePoint& s) const;
    int pole_parameter(const Vec2& uv) const;
    std::optional<Vec3> limit_normal(double u, double v) const;
    std::optional<Vec3> normal_beside(const Vec2& uv, const Vec2& aside) const;
    void set_normal(double u, double v, const SurfacePoint& s, Answer& answer) const;
    Answer at(double u, double v) const;
    Answer at(double u, double v, const SurfacePoint& s) const;
    Answer answer_at(const Vec3& point, const Projection& projection, const Vec2& guess) const;

    ParameterBox elementary_box(const Vec2& guess) const;
    void set_search_box();
    Step newton_step(const SurfacePoint& s, const Vec3& r, const Vec2& uv, const ParameterBox& box) const;
    Projection newton(const Vec3& p, const Vec2& start, const ParameterBox& box) const;
    bool collapsed(const SurfacePoint& s) const;
    bool is_local_minimum(const Vec3& p, const Projection& projection, const ParameterBox& box) const;
    Projection search(const Vec3& p, const ParameterBox& box);
    std::optional<Projection> native_nearest(const Vec3& p, const Vec2& guess) const;
    Projection pattern_search(const Vec3& p, const Vec2& start, const ParameterBox& box) const;
    void sample();
    Vec2 offset_from_pole(const Vec3& p, const Vec2& pole) const;
    Vec2 sample_at(int i, int k) const;
    std::vector<std::pair<int, int>> samples_at_peaks(const std::vector<double>& values, double bound) const;
    void search_peak(int i, int k, int axis, double sign, Box& box);
    std::vector<std::pair<double, Vec2>> best_samples(const Vec3& p) const;

    TopoDS_Face shape_;
    GeomAdaptor_Surface surface_;
    bool native_;  ///< whether OpenCASCADE evaluates and projects
    mutable std::optional<SplineSurfacePieces> patches_;
    gp_Trsf location_;
    gp_Trsf inverse_;
    bool located_ = false;
    bool mirrored_ = false;  ///< whether the location turns the surface inside out
    double sign_ = 1.0;      ///< sign of the outward normal along Su x Sv
    double tolerance_;
    std::array<double, 2> period_;
    ParameterBox natural_;  ///< bounds of the surface
    ParameterBox trimmed_;  ///< bounds of the face, made finite
    ParameterBox search_;   ///< the surface's bounds, made finite; free where it closes
    ParameterBox patched_;  ///< bounds within which polynomial pieces are evaluated; empty without them
    double su_ = 0.0;       ///< usual size of Su, Sv on the face
    double sv_ = 0.0;
    double size_ = 0.0;  ///< size of the face in space, in its own coordinates
    std::optional<ElementarySurface> elementary_;
    std::array<int, 2> samples_{0, 0};
    std::vector<Vec3> grid_;
    std::map<double, BRepTopAdaptor_FClass2d> classifiers_;  ///< by half the width of the border, mm
};

}  // namespace mq::geometry
