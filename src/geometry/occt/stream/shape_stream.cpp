// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/stream/shape_stream.h"

#include <BRep_Builder.hxx>
#include <BRep_Curve3D.hxx>
#include <BRep_CurveOn2Surfaces.hxx>
#include <BRep_CurveOnClosedSurface.hxx>
#include <BRep_CurveOnSurface.hxx>
#include <BRep_PointOnCurve.hxx>
#include <BRep_PointOnCurveOnSurface.hxx>
#include <BRep_PointOnSurface.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_TVertex.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_CompSolid.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/occt/stream/byte_reader.h"
#include "geometry/occt/stream/canonical_locations.h"
#include "geometry/occt/stream/stream_curves.h"

namespace mq::geometry {

namespace {

constexpr int kFreecadVersion = 3;  // what FreeCAD writes; 4 has normals of triangulations, too

/// Reads what stands in sections, and then the shapes, which name it by its numbers.
class ShapeReader {
  public:
    explicit ShapeReader(std::string_view bytes) : bytes_(bytes) {}

    TopoDS_Shape read() {
        read_version();
        read_locations();
        read_all("Curve2ds", plane_curves_, read_plane_curve);
        read_all("Curves", curves_, read_curve);
        refuse_any("Polygon3D");
        refuse_any("PolygonOnTriangulations");
        read_all("Surfaces", surfaces_, read_surface);
        read_all("Triangulations", triangulations_, [this](ByteReader&) { return triangulation(); });
        shape_count_ = bytes_.section("TShapes");
        for (std::size_t i = 0; i < shape_count_; ++i) {
            shapes_.push_back(definition());
        }
        const int number = bytes_.get<std::int32_t>();
        if (number == -1) {
            ByteReader::refuse("it holds no shape");
        }
        TopoDS_Shape shape = numbered(shapes_, number);
        const TopLoc_Location& location = this->location();
        shape.Location(location, false);
        shape.Orientation(orientation(bytes_.get<std::int32_t>()));
        return shape;
    }

  private:
    void read_version() {
        constexpr std::string_view kName = "Open CASCADE Topology V";
        bytes_.line();  // empty
        const std::string_view line = bytes_.line();
        const char version =
            line.size() > kName.size() && line.substr(0, kName.size()) == kName ? line[kName.size()] : '0';
        if (version != '3' && version != '4') {
            ByteReader::refuse("it is not of version 3 or 4");
        }
        has_normals_ = version == '4';
    }

    template <typename T, typename Read>
    void read_all(const char* section, std::vector<T>& values, const Read& read) {
        const int count = bytes_.section(section);
        values.reserve(count);
        for (int i = 0; i < count; ++i) {
            values.push_back(read(bytes_));
        }
    }

    void refuse_any(const char* section) {
        if (bytes_.section(section) != 0) {
            ByteReader::refuse("it has triangulations of faces with a surface");
        }
    }

    /// What has this number, from 1 on.
    template <typename T>
    static const T& numbered(const std::vector<T>& values, int number) {
        if (number < 1 || static_cast<std::size_t>(number) > values.size()) {
            ByteReader::refuse("a number names nothing");
        }
        return values[number - 1];
    }
    template <typename T>
    const T& named(const std::vector<T>& values) {
        return numbered(values, bytes_.get<std::int32_t>());
    }
    const TopLoc_Location& location() {
        static const TopLoc_Location none;
        const int number = bytes_.get<std::int32_t>();
        return number == 0 ? none : numbered(locations_, number);
    }

    void read_locations() {
        const int count = bytes_.section("Locations");
        for (int i = 0; i < count; ++i) {
            const char type = bytes_.get<char>();
            if (type == 1) {
                locations_.push_back(transformation());
            } else if (type == 2) {
                locations_.push_back(product());
            } else {
                ByteReader::refuse("a location has an unknown type");
            }
        }
    }

    /// Three rows of a matrix, each with its translation.
    TopLoc_Location transformation() {
        const std::array<double, 12> r = bytes_.numbers<12>();
        const gp_Mat rows(r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]);
        if (rows.IsSingular()) {
            ByteReader::refuse("a location has no inverse");
        }
        return TopLoc_Location(canonical_transformation(rows, gp_XYZ(r[3], r[7], r[11])));
    }

    /// The product of powers of other locations, the first factor last; 0 ends their list.
    TopLoc_Location product() {
        TopLoc_Location product;
        while (const int number = bytes_.get<std::int32_t>()) {
            const TopLoc_Location& factor = numbered(locations_, number);
            product = factor.Powered(bytes_.get<std::int32_t>()) * product;
        }
        return product;
    }

    Handle(Poly_Triangulation) triangulation() {
        const int nodes = bytes_.count(sizeof(gp_Pnt));
        const int triangles = bytes_.count(3 * sizeof(std::int32_t));
        const bool has_uv = bytes_.flag();
        const bool has_normals = has_normals_ && bytes_.flag();
        Handle(Poly_Triangulation) made = new Poly_Triangulation(nodes, triangles, has_uv);
        made->Deflection(bytes_.get<double>());
        for (int i = 1; i <= nodes; ++i) {
            made->SetNode(i, read_bits<gp_Pnt>(bytes_));
        }
        for (int i = 1; has_uv && i <= nodes; ++i) {
            made->SetUVNode(i, read_bits<gp_Pnt2d>(bytes_));
        }
        for (int i = 1; i <= triangles; ++i) {
            std::array<int, 3> corners{};
            for (int& corner : corners) {
                corner = bytes_.get<std::int32_t>();
                if (corner < 1 || corner > nodes) {
                    ByteReader::refuse("a triangle names no node");
                }
            }
            made->SetTriangle(i, Poly_Triangle(corners[0], corners[1], corners[2]));
        }
        for (int i = 0; has_normals && i < 3 * nodes; ++i) {
            bytes_.get<float>();
        }
        return made;
    }

    /// A shape without location, with what it consists of.
    TopoDS_Shape definition() {
        TopoDS_Shape shape = without_parts(static_cast<TopAbs_ShapeEnum>(bytes_.get<char>()));
        std::array<bool, 7> flags{};
        for (bool& flag : flags) {
            flag = bytes_.flag();
        }
        constexpr char kEnd = '*';
        for (char next = bytes_.get<char>(); next != kEnd; next = bytes_.get<char>()) {
            // Written are numbers from the last one on.
            const auto number = static_cast<std::int64_t>(shape_count_) + 1 - bytes_.get<std::int32_t>();
            TopoDS_Shape part = numbered(shapes_, static_cast<int>(number));
            part.Orientation(orientation(next));
            part.Location(location(), false);
            builder_.Add(shape, part);
        }
        shape.Free(flags[0]);
        shape.Modified(flags[1]);
        shape.Checked(flags[2]);
        shape.Orientable(flags[3]);
        shape.Closed(flags[4]);
        shape.Infinite(flags[5]);
        shape.Convex(flags[6]);
        return shape;
    }

    static TopAbs_Orientation orientation(int number) {
        if (number < TopAbs_FORWARD || number > TopAbs_EXTERNAL) {
            ByteReader::refuse("an orientation is unknown");
        }
        return static_cast<TopAbs_Orientation>(number);
    }

    TopoDS_Shape without_parts(TopAbs_ShapeEnum type) {
        switch (type) {
            case TopAbs_VERTEX:
                return vertex();
            case TopAbs_EDGE:
                return edge();
            case TopAbs_FACE:
                return face();
            case TopAbs_WIRE:
                return made<TopoDS_Wire>(&BRep_Builder::MakeWire);
            case TopAbs_SHELL:
                return made<TopoDS_Shell>(&BRep_Builder::MakeShell);
            case TopAbs_SOLID:
                return made<TopoDS_Solid>(&BRep_Builder::MakeSolid);
            case TopAbs_COMPSOLID:
                return made<TopoDS_CompSolid>(&BRep_Builder::MakeCompSolid);
            case TopAbs_COMPOUND:
                return made<TopoDS_Compound>(&BRep_Builder::MakeCompound);
            default:
                ByteReader::refuse("a shape has an unknown type");
        }
    }

    template <typename Shape, typename Make>
    TopoDS_Shape made(Make make) {
        Shape shape;
        (builder_.*make)(shape);
        return shape;
    }

    TopoDS_Shape vertex() {
        TopoDS_Vertex vertex;
        builder_.MakeVertex(vertex);
        auto& data = static_cast<BRep_TVertex&>(*vertex.TShape());
        data.Tolerance(bytes_.get<double>());
        data.Pnt(read_bits<gp_Pnt>(bytes_));
        while (const char type = bytes_.get<char>()) {
            Handle(BRep_PointRepresentation) point = point_on(type);
            point->Location(location());
            data.ChangePoints().Append(point);
        }
        return vertex;
    }

    Handle(BRep_PointRepresentation) point_on(char type) {
        const double first = bytes_.get<double>();
        const TopLoc_Location none;
        if (type == 1) {
            return new BRep_PointOnCurve(first, named(curves_), none);
        }
        if (type == 2) {
            const Handle(Geom2d_Curve)& curve = named(plane_curves_);
            return new BRep_PointOnCurveOnSurface(first, curve, named(surfaces_), none);
        }
        if (type == 3) {  // the second parameter is written first
            const double second = bytes_.get<double>();
            return new BRep_PointOnSurface(second, first, named(surfaces_), none);
        }
        ByteReader::refuse("a point of a vertex has an unknown type");
    }

    TopoDS_Shape edge() {
        TopoDS_Edge edge;
        builder_.MakeEdge(edge);
        auto& data = static_cast<BRep_TEdge&>(*edge.TShape());
        data.Tolerance(bytes_.get<double>());
        data.SameParameter(bytes_.flag());
        data.SameRange(bytes_.flag());
        builder_.Degenerated(edge, bytes_.flag());  // with a null curve in space, which is not written
        while (const char type = bytes_.get<char>()) {
            data.ChangeCurves().Append(curve_on(type));
        }
        return edge;
    }

    Handle(BRep_CurveRepresentation) curve_on(char type) {
        if (type == 1) {
            const Handle(Geom_Curve)& curve = named(curves_);
            Handle(BRep_Curve3D) made = new BRep_Curve3D(curve, location());
            const auto [first, last] = bytes_.numbers<2>();
            made->SetRange(first, last);
            return made;
        }
        if (type == 2 || type == 3) {
            return curve_on_surface(type == 3);
        }
        if (type == 4) {
            const GeomAbs_Shape continuity = this->continuity();
            const Handle(Geom_Surface)& first = named(surfaces_);
            const TopLoc_Location& first_location = location();
            const Handle(Geom_Surface)& second = named(surfaces_);
            return new BRep_CurveOn2Surfaces(first, second, first_location, location(), continuity);
        }
        ByteReader::refuse("a curve of an edge has an unknown type");
    }

    Handle(BRep_CurveRepresentation) curve_on_surface(bool closed) {
        const Handle(Geom2d_Curve)& curve = named(plane_curves_);
        const Handle(Geom2d_Curve)& second = closed ? named(plane_curves_) : curve;
        const GeomAbs_Shape continuity = closed ? this->continuity() : GeomAbs_C0;
        const Handle(Geom_Surface)& surface = named(surfaces_);
        const TopLoc_Location& location = this->location();
        const auto [first, last] = bytes_.numbers<2>();
        const auto start = read_bits<gp_Pnt2d>(bytes_);
        const auto end = read_bits<gp_Pnt2d>(bytes_);
        if (!closed) {
            Handle(BRep_CurveOnSurface) made = new BRep_CurveOnSurface(curve, surface, location);
            made->SetRange(first, last);
            made->SetUVPoints(start, end);
            return made;
        }
        Handle(BRep_CurveOnClosedSurface) made =
            new BRep_CurveOnClosedSurface(curve, second, surface, location, continuity);
        made->SetRange(first, last);
        made->SetUVPoints2(start, end);
        return made;
    }

    GeomAbs_Shape continuity() {
        const char value = bytes_.get<char>();
        if (value < GeomAbs_C0 || value > GeomAbs_CN) {
            ByteReader::refuse("a continuity is unknown");
        }
        return static_cast<GeomAbs_Shape>(value);
    }

    TopoDS_Shape face() {
        TopoDS_Face face;
        builder_.MakeFace(face);
        auto& data = static_cast<BRep_TFace&>(*face.TShape());
        data.NaturalRestriction(bytes_.flag());
        data.Tolerance(bytes_.get<double>());
        const int surface = bytes_.get<std::int32_t>();
        if (surface != 0) {
            data.Surface(numbered(surfaces_, surface));
        }
        data.Location(location());
        constexpr char kTriangulated = 2;
        if (bytes_.get<char>() == kTriangulated) {
            data.Triangulation(named(triangulations_));
        }
        return face;
    }

    ByteReader bytes_;
    BRep_Builder builder_;
    bool has_normals_ = false;
    std::size_t shape_count_ = 0;
    std::vector<TopLoc_Location> locations_;
    std::vector<Handle(Geom2d_Curve)> plane_curves_;
    std::vector<Handle(Geom_Curve)> curves_;
    std::vector<Handle(Geom_Surface)> surfaces_;
    std::vector<Handle(Poly_Triangulation)> triangulations_;
    std::vector<TopoDS_Shape> shapes_;
};

}  // namespace

std::shared_ptr<const TopoDS_Shape> read_shape_stream(std::string_view bytes) {
    try {
        return std::make_shared<const TopoDS_Shape>(ShapeReader(bytes).read());
    } catch (const Standard_Failure& failure) {
        ByteReader::refuse(failure.GetMessageString());
    }
}

std::string write_shape_stream(const TopoDS_Shape& shape) {
    BinTools_ShapeSet set;
    set.SetFormatNb(kFreecadVersion);
    std::ostringstream stream;
    try {
        const int number = set.Add(shape);
        set.Write(stream);
        BinTools::PutInteger(stream, number);
        BinTools::PutInteger(stream, set.Locations().Index(shape.Location()));
        BinTools::PutInteger(stream, shape.Orientation());
    } catch (const Standard_Failure& failure) {
        throw InvalidInput(phrases::kStreamNotWritten, {{"text", failure.GetMessageString()}});
    }
    return stream.str();
}

bool is_of_this_kernel(const TopoDS_Shape& vertex) {
    TopoDS_Vertex ours;
    BRep_Builder().MakeVertex(ours);
    const auto table_of = [](const TopoDS_Shape& shape) {
        return *reinterpret_cast<const void* const*>(shape.TShape().get());
    };
    return table_of(vertex) == table_of(ours);
}

}  // namespace mq::geometry
