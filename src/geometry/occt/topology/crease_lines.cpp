// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/crease_lines.h"

#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <memory>

#include "base/angle.h"

namespace mq::geometry {

namespace {

// Least jump of the normal, radians. A smaller one is left to the refinement, which treats it like a curved surface.
constexpr double kLeastJump = 10.0 * kDegree;

class CreaseSearch {
  public:
    explicit CreaseSearch(const TopoDS_Face& face)
        : face_(face), surface_(BRep_Tool::Surface(face)), adaptor_(surface_), tolerance_(BRep_Tool::Tolerance(face)) {
        BRepTools::UVBounds(face, low_[0], high_[0], low_[1], high_[1]);
    }

    std::vector<double> lines(int direction) {
        std::vector<double> found;
        for (const double at : inner_kinks(direction)) {
            // Most lines neither jump nor shrink: their border is not evaluated.
            if ((jumps(direction, at) || shrinks_to_a_point(direction, at)) && apart_from_border(direction, at)) {
                found.push_back(at);
            }
        }
        return found;
    }

  private:
    /// Samples along a line at which the normal's jump is measured.
    static constexpr int kSamples = 16;

    // Parameters where the surface is not continuously differentiable: most surfaces have none.
    std::vector<double> inner_kinks(int direction) const {
        const int intervals = direction == 0 ? adaptor_.NbUIntervals(GeomAbs_C1) : adaptor_.NbVIntervals(GeomAbs_C1);
        TColStd_Array1OfReal values(1, intervals + 1);
        direction == 0 ? adaptor_.UIntervals(values, GeomAbs_C1) : adaptor_.VIntervals(values, GeomAbs_C1);
        const double least = 1e-9 * (high_[direction] - low_[direction]);
        std::vector<double> kinks;
        for (int i = 2; i <= intervals; ++i) {
            if (values(i) > low_[direction] + least && values(i) < high_[direction] - least) {
                kinks.push_back(values(i));
            }
        }
        return kinks;
    }

    double across(int direction, int sample) const {
        const double share = (sample + 0.5) / kSamples;
        return low_[1 - direction] + share * (high_[1 - direction] - low_[1 - direction]);
    }
    static gp_Pnt2d place(int direction, double at, double other) {
        return direction == 0 ? gp_Pnt2d(at, other) : gp_Pnt2d(other, at);
    }
    gp_Pnt2d uv(int direction, double at, int sample) const { return place(direction, at, across(direction, sample)); }
    gp_Pnt value(const gp_Pnt2d& p) const { return surface_->Value(p.X(), p.Y()); }
    gp_Pnt point(int direction, double at, int sample) const { return value(uv(direction, at, sample)); }

    // Whether a line is farther from the border than the tolerance: narrower pieces would have no area.
    bool apart_from_border(int direction, double at) const {
        for (const double border : {low_[direction], high_[direction]}) {
            double width = 0.0;
            for (int i = 0; i < kSamples; ++i) {
                width = std::max(width, point(direction, at, i).Distance(point(direction, border, i)));
            }
            if (width <= 10.0 * std::max(tolerance_, Precision::Confusion())) {
                return false;
            }
        }
        return true;
    }

    bool normal(int direction, double at, int sample, gp_Vec& n) const {
        const gp_Pnt2d where = uv(direction, at, sample);
        gp_Pnt p;
        gp_Vec su;
        gp_Vec sv;
        surface_->D1(where.X(), where.Y(), p, su, sv);
        n = su.Crossed(sv);
        const double size = n.Magnitude();
        if (size <= 1e-9 * su.Magnitude() * sv.Magnitude() || size <= gp::Resolution()) {
            return false;
        }
        n /= size;
        return true;
    }

    // Whether the normal jumps somewhere on the line within the face, or is defined on one side only.
    bool jumps(int direction, double at) {
        const double beside = 1e-6 * (high_[direction] - low_[direction]);
        for (int i = 0; i < kSamples; ++i) {
            gp_Vec before;
            gp_Vec after;
            const bool one = normal(direction, at - beside, i, before);
            const bool other = normal(direction, at + beside, i, after);
            const bool differ = one != other || (one && before.Angle(after) > kLeastJump);
            if (differ && within_face(uv(direction, at, i))) {
                return true;
            }
        }
        return false;
    }

    // Whether the line is a point in space, somewhere between two kinks of the other direction.
    bool shrinks_to_a_point(int direction, double at) {
        std::vector<double> ends = inner_kinks(1 - direction);
        ends.push_back(high_[1 - direction]);
        double from = low_[1 - direction];
        for (const double to : ends) {
            if (is_a_point(direction, at, from, to)) {
                return true;
            }
            from = to;
        }
        return false;
    }

    bool is_a_point(int direction, double at, double from, double to) {
        const double most = std::max(tolerance_, Precision::Confusion());
        const gp_Pnt start = value(place(direction, at, from));
        for (int i = 1; i <= kSamples; ++i) {
            if (value(place(direction, at, from + (to - from) * i / kSamples)).Distance(start) > most) {
                return false;
            }
        }
        return within_face(place(direction, at, 0.5 * (from + to)));
    }

    bool within_face(const gp_Pnt2d& where) {
        if (!classifier_) {
            classifier_ = std::make_unique<BRepTopAdaptor_FClass2d>(face_, Precision::PConfusion());
        }
        return classifier_->Perform(where) == TopAbs_IN;
    }

    TopoDS_Face face_;
    // Used for evaluation: the adaptor prepares the polynomials of a knot span again for each point of another span.
    Handle(Geom_Surface) surface_;
    GeomAdaptor_Surface adaptor_;
    double tolerance_;
    double low_[2]{};
    double high_[2]{};
    std::unique_ptr<BRepTopAdaptor_FClass2d> classifier_;
};

// Most surfaces have no such parameter at all: neither their borders nor their points are evaluated.
bool may_have_creases(const Handle(Geom_Surface) & surface) {
    const GeomAdaptor_Surface adaptor(surface);
    return adaptor.NbUIntervals(GeomAbs_C1) > 1 || adaptor.NbVIntervals(GeomAbs_C1) > 1;
}

}  // namespace

std::vector<double> crease_lines(const TopoDS_Face& face, int direction) {
    TopLoc_Location location;
    const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, location);
    const bool possible = !surface.IsNull() && may_have_creases(surface);
    return possible ? CreaseSearch(face).lines(direction) : std::vector<double>();
}

bool has_crease(const TopoDS_Face& face) {
    return !crease_lines(face, 0).empty() || !crease_lines(face, 1).empty();
}

}  // namespace mq::geometry
