// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <list>
#include <memory>

class TopoDS_Shape;

namespace mq::python {

/// Copies of FreeCAD's shapes that came as binary BREP. One that was taken before is found by its bytes, as FreeCAD
/// changes shapes in place: Booleans raise tolerances of their operands. On other threads than the main one, on which
/// FreeCAD may be at work on it, a shape is found by its identity, as the main thread took it last. FreeCAD's shapes
/// are kept with their copies, so that no other shape gets their identity. Call it with Python's lock held.
class StreamCache {
  public:
    static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

    /// That of the process. It is not destroyed, as Python ends before.
    static StreamCache& shared();

    /// The copy of a Part.Shape.
    /// @throws InvalidInput where FreeCAD cannot write it; IoError where there is no place for it
    std::shared_ptr<const TopoDS_Shape> copy_of(pybind11::handle part);

    std::size_t count() const { return entries_.size(); }
    std::size_t bytes() const { return bytes_; }

  private:
    struct Entry {
        pybind11::object part;  // another Part.Shape of the same TShape, which scripts do not know, and so do not move
        pybind11::bytes stream;
        std::shared_ptr<const TopoDS_Shape> copy;
        std::size_t bytes = 0;
    };
    using Place = std::list<Entry>::iterator;

    template <typename Wanted>
    Place found(const Wanted& wanted);
    void keep(Entry entry);

    std::list<Entry> entries_;  // the one that was used last comes first
    std::size_t bytes_ = 0;
};

}  // namespace mq::python
