// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/freecad/stream_cache.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "geometry/occt/stream/shape_stream.h"

namespace py = pybind11;

namespace mq::python {

namespace {

/// Memory of a shape, here and in FreeCAD together, for each byte of its stream.
constexpr std::size_t kBytesPerByte = 8;

bool on_main_thread() {
    const py::module_ threading = py::module_::import("threading");
    return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// Whether both are the same shape in FreeCAD; None is none.
bool is_of(py::handle kept, py::handle part) {
    return !kept.is_none() && !part.is_none() && part.attr("isEqual")(kept).cast<bool>();
}

}  // namespace

StreamCache& StreamCache::shared() {
    static StreamCache& cache = *new StreamCache;
    return cache;
}

template <typename Wanted>
StreamCache::Place StreamCache::found(const Wanted& wanted) {
    const Place place = std::find_if(entries_.begin(), entries_.end(), wanted);
    if (place != entries_.end()) {
        entries_.splice(entries_.begin(), entries_, place);
    }
    return place;
}

std::shared_ptr<const TopoDS_Shape> StreamCache::copy_of(py::handle part) {
    const bool is_main = on_main_thread();
    if (!is_main) {
        const Place place = found([&](const Entry& entry) { return is_of(entry.part, part); });
        if (place != entries_.end()) {
            return place->copy;
        }
    }
    Entry entry;
    entry.stream = py::module_::import("MeshQuality.core.sources.shape_stream").attr("bytes_of")(part);
    entry.part = is_main ? py::module_::import("Part").attr("Shape")(part) : py::none();
    // What FreeCAD has changed in place since has another stream.
    for (Entry& other : entries_) {
        if (is_of(other.part, entry.part)) {
            other.part = py::none();
        }
    }
    const auto view = std::string_view(entry.stream);
    const Place place = found([&](const Entry& other) { return std::string_view(other.stream) == view; });
    if (place != entries_.end()) {
        place->part = is_main ? entry.part : place->part;
        return place->copy;
    }
    entry.copy = geometry::read_shape_stream(view);
    entry.bytes = kBytesPerByte * view.size();
    std::shared_ptr<const TopoDS_Shape> copy = entry.copy;
    keep(std::move(entry));  // one that is larger than the cache is not
    return copy;
}

void StreamCache::keep(Entry entry) {
    bytes_ += entry.bytes;
    entries_.push_front(std::move(entry));
    while (bytes_ > kMostBytes) {
        bytes_ -= entries_.back().bytes;
        entries_.pop_back();
    }
}

}  // namespace mq::python
