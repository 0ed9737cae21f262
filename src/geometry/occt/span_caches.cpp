// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/span_caches.h"

#include <Precision.hxx>
#include <algorithm>

namespace mq::geometry {

namespace {

// Spans that are kept at most: of bicubic surfaces they need 150 kB.
constexpr std::size_t kSlots = 256;

std::vector<double> values(const TColStd_Array1OfReal& array) {
    return {array.begin(), array.end()};
}

std::size_t interval(const std::vector<double>& knots, double t) {
    return static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin());
}

}  // namespace

SpanCaches::SpanCaches(const Handle(Geom_BSplineSurface) & surface)
    : surface_(surface), knots_{values(surface->UKnots()), values(surface->VKnots())} {}

bool SpanCaches::contains(double u, double v) const {
    const double slack = Precision::PConfusion();
    return u > knots_[0].front() + slack && u < knots_[0].back() - slack && v > knots_[1].front() + slack &&
           v < knots_[1].back() - slack;
}

std::size_t SpanCaches::span_of(double u, double v) const {
    return interval(knots_[0], u) * (knots_[1].size() + 1) + interval(knots_[1], v);
}

const BSplSLib_Cache& SpanCaches::at(double u, double v) {
    const std::size_t spans = (knots_[0].size() - 1) * (knots_[1].size() - 1);
    slots_.resize(std::min(kSlots, spans));
    const std::size_t span = span_of(u, v);
    Slot& slot = slots_[span % slots_.size()];
    if (slot.cache.IsNull()) {
        slot.cache = new BSplSLib_Cache(surface_->UDegree(), surface_->IsUPeriodic(), surface_->UKnotSequence(),
                                        surface_->VDegree(), surface_->IsVPeriodic(), surface_->VKnotSequence(),
                                        surface_->Weights());
    } else if (slot.span == span && slot.cache->IsCacheValid(u, v)) {  // beside a knot it may be of the next span
        return *slot.cache;
    }
    slot.span = span;
    slot.cache->BuildCache(u, v, surface_->UKnotSequence(), surface_->VKnotSequence(), surface_->Poles(),
                           surface_->Weights());
    return *slot.cache;
}

}  // namespace mq::geometry
