// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "python/bindings.h"
#include "view/quality_scene.h"

namespace py = pybind11;

namespace mq::python {

namespace {

using view::Colour;
using view::QualityScene;

template <typename Number>
using Array = py::array_t<Number, py::array::c_style | py::array::forcecast>;

/// The number of rows of an array of shape (n, ...) with `width` numbers in each row.
std::size_t rows(const py::array& array, py::ssize_t width, const char* name) {
    if (array.size() % width != 0) {
        throw InvalidInput(phrases::kColumns, {{"name", name}, {"count", width}});
    }
    return static_cast<std::size_t>(array.size() / width);
}

std::vector<Colour> colours_of(const Array<std::uint8_t>& array) {
    std::vector<Colour> colours(rows(array, 4, "colours"));
    for (std::size_t i = 0; i < colours.size(); ++i) {
        std::copy_n(array.data() + 4 * i, 4, colours[i].begin());
    }
    return colours;
}

view::LegendPicture legend_of(const Array<std::uint8_t>& rows, int corner, int reach) {
    if (rows.size() == 0) {
        return {};
    }
    if (rows.ndim() != 3 || rows.shape(2) != 4 || corner < 0 || corner > 3) {
        throw InvalidInput(phrases::kLegendRows);
    }
    view::LegendPicture picture;
    picture.width = static_cast<int>(rows.shape(1));
    picture.height = static_cast<int>(rows.shape(0));
    picture.rgba.assign(rows.data(), rows.data() + rows.size());
    picture.left_free = static_cast<view::Corner>(corner);
    picture.reach = reach;
    return picture;
}

void bind_legend(py::class_<QualityScene>& scenes) {
    scenes
        .def(
            "legend",
            [](QualityScene& scene, const Array<std::uint8_t>& rows, int corner, int reach) {
                scene.legend().show(legend_of(rows, corner, reach));
            },
            py::arg("rows"), py::arg("corner"), py::arg("reach"),
            "uint8 (height, width, 4): a picture, the lowest row first, and the corner of the view that it leaves free "
            "(0 to 3: top left, top right, bottom left, bottom right) so many pixels far; no row: no legend.")
        .def(
            "legend_place",
            [](QualityScene& scene, short width, short height) {
                const auto place = scene.legend().place_in({width, height});
                return std::pair(place[0], place[1]);
            },
            py::arg("width"), py::arg("height"),
            "Where the picture's lower left corner is in a view of so many pixels, in pixels from the view's.");
}

}  // namespace

PYBIND11_MODULE(_view, m) {
    m.doc() = "What MeshQuality draws in FreeCAD's 3D view, by Coin.";
    bind_errors(m);
    py::class_<QualityScene> scenes(m, "QualityScene", "A coloured mesh with edges, lit triangles and a legend.");
    scenes.def(py::init<>())
        .def_property_readonly("name", &QualityScene::name, "By which coin.SoNode.getByName finds the root node.")
        .def_property_readonly("triangles", [](QualityScene& scene) { return scene.triangles().count(); })
        .def(
            "show",
            [](QualityScene& scene, const Array<float>& corners) {
                scene.show(corners.data(), rows(corners, 9, "corners"));
            },
            py::arg("corners"), "Takes triangles as float32 (T, 3, 3).")
        .def(
            "colour",
            [](QualityScene& scene, const Array<std::uint8_t>& colours) {
                scene.triangles().colour(colours_of(colours));
            },
            py::arg("colours"), "uint8 (T, 4): red, green, blue, opacity of each triangle.")
        .def(
            "show_coarse",
            [](QualityScene& scene, const Array<float>& corners) {
                scene.coarse().show(corners.data(), rows(corners, 9, "corners"));
            },
            py::arg("corners"), "float32 (n, 3, 3): what is drawn instead while the camera moves.")
        .def(
            "colour_coarse",
            [](QualityScene& scene, const Array<std::uint8_t>& colours) { scene.coarse().colour(colours_of(colours)); },
            py::arg("colours"), "uint8 (n, 4), likewise.")
        .def("moving", &QualityScene::moving, py::arg("moves"), "Whether the camera moves now.")
        .def_property_readonly("drawing_seconds", &QualityScene::drawing_seconds,
                               "how long the processor was busy when all was drawn last")
        .def(
            "draw_edges",
            [](QualityScene& scene, const Array<float>& points, const Array<std::int32_t>& lines) {
                scene.draw_edges(points.data(), rows(points, 3, "points"),
                                 std::vector<std::int32_t>(lines.data(), lines.data() + lines.size()));
            },
            py::arg("points"), py::arg("lines"), "float32 (P, 3), and runs of point indices, each ended by -1.")
        .def(
            "light_up",
            [](QualityScene& scene, const Array<float>& corners) {
                scene.light_up(corners.data(), rows(corners, 9, "corners"));
            },
            py::arg("corners"), "Lights up triangles, float32 (n, 3, 3), instead of those before.");
    bind_legend(scenes);
}

}  // namespace mq::python
