// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <iosfwd>
#include <vector>

namespace mq::python {

/// The mesh inside a Mesh.Mesh of FreeCAD, accessed while Python's lock is free.
///
/// FreeCAD's Python functions keep that lock, so that one of them that takes 200 ms on a thread stops the window as
/// long. Its library exports the C++ functions behind them, but no headers come with an installed FreeCAD: they are
/// looked up by their names, and used only where the object given has the class that they expect.
class FreecadMesh {
  public:
    /// @param mesh a Mesh.Mesh that no other thread uses meanwhile, kept alive by the caller.
    explicit FreecadMesh(pybind11::handle mesh);

    /// Whether this build of FreeCAD has the functions, under these names; only then may the others be called.
    bool reachable() const { return object_ != nullptr; }

    /// Reads the mesh from FreeCAD's binary format; its segments are removed. Returns false on failure.
    bool read(std::istream& bms) const;
    /// Writes the mesh without its placement.
    void write(std::ostream& bms) const;
    /// Adds triangles, all of which must be in the mesh, as a segment.
    void add_segment(const std::vector<unsigned long>& triangles) const;

  private:
    void* object_ = nullptr;  ///< Mesh::MeshObject
};

}  // namespace mq::python
