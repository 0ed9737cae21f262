// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/freecad/stream_cache.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "geometry/occt/stream/shape_stream.h"
#include "python/python_lock.h"

namespace py = pybind11;

namespace mq::python {

namespace {

/// Memory of a shape, here and in FreeCAD together, for each byte of its stream.
constexpr std::size_t kBytesPerByte = 8;

bool on_main_thread() {
    const py::module_ threading = py::module_::import("threading");
    return threading.attr("current_thread")().is(threading.attr("main_thread")());
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
    if (!on_main_thread()) {
        const Place place = found([&](const Entry& entry) { return part.attr("isEqual")(entry.part).cast<bool>(); });
        if (place != entries_.end()) {
            return place->copy;
        }
    }
    Entry entry;
    entry.stream = py::module_::import("MeshQuality.core.sources.shape_stream").attr("bytes_of")(part);
    entry.part = py::module_::import("Part").attr("Shape")(part);
    const auto view = std::string_view(entry.stream);
    const Place place = found([&](const Entry& other) { return std::string_view(other.stream) == view; });
    if (place != entries_.end()) {
        place->part = entry.part;
        return place->copy;
    }
    {
        const FreedLock free;
        entry.copy = geometry::read_shape_stream(view);
    }
    entry.bytes = kBytesPerByte * view.size();
    keep(entry);
    return entry.copy;
}

void StreamCache::keep(Entry entry) {
    // What FreeCAD has changed in place since has another stream.
    entries_.remove_if([&](const Entry& other) {
        const bool replaced = entry.part.attr("isEqual")(other.part).cast<bool>();
        bytes_ -= replaced ? other.bytes : 0;
        return replaced;
    });
    bytes_ += entry.bytes;
    entries_.push_front(std::move(entry));
    while (bytes_ > kMostBytes) {  // the one that was just taken is not kept either where it alone is larger
        bytes_ -= entries_.back().bytes;
        entries_.pop_back();
    }
}

}  // namespace mq::python
