#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 16 and 17 of Wang 2010: results of the examples, triangles of the operands in grey, those that were made in red.

    /usr/bin/python3 benchmarks/papers wang-pictures [--rays 257] [--picture docs/pictures/wang_results.png]

Drawn by VTK, on xvfb where there is no display. Models stand for the paper's (benchmarks/boolean/wang_models.py), in $MESHQUALITY_DATA.
"""

import argparse
import os
import shutil
import sys
import tempfile
from pathlib import Path

import wang_models
import wang_runs

# (example, whether all is reconstructed, camera: where it looks from)
PICTURES = (
    ("dragon - bunny", False, (0.4, 0.35, 1.0)), ("armadillo U nefertiti", False, (0.6, 0.3, -1.0)),
    ("pig U filigree", False, (0.6, 0.8, 1.0)), ("that n cylinder", False, (0.7, -1.0, 0.5)),
    ("ring U bars", False, (0.5, -0.6, 1.0)), ("chair - flower", False, (1.0, 0.5, 0.6)),
    ("dragon - bunny", True, (0.4, 0.35, 1.0)), ("chair - flower", True, (1.0, 0.5, 0.6)),
)
COLUMNS, WIDTH, HEIGHT = 4, 300, 270
GREY, RED = (0.78, 0.79, 0.82), (0.85, 0.22, 0.18)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rays", type=int, default=257)
    parser.add_argument("--picture", metavar="FILE", default="out/wang_results.png")
    arguments = parser.parse_args()
    if "DISPLAY" not in os.environ:
        if not shutil.which("xvfb-run"):
            sys.exit("there is no display: set DISPLAY, or install xvfb-run (package xvfb)")
        os.execvp("xvfb-run", ["xvfb-run", "-a", *sys.orig_argv])
    with tempfile.TemporaryDirectory() as folder:
        for name in {name for name, _, _ in PICTURES}:
            wang_runs.operands(name, folder)
        for number, (name, full, _) in enumerate(PICTURES):
            run = wang_runs.boolean(name, folder, arguments.rays, full=full, save=f"{number}.npz")
            print(f"{name}{', full' if full else ''}: {run['retained']:,} of {run['triangles']:,} triangles kept", flush=True)
        draw([wang_runs.load(Path(folder) / f"{number}.npz") for number in range(len(PICTURES))], arguments.picture)


def draw(results, path):
    import vtk

    rows = -(-len(PICTURES) // COLUMNS)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(COLUMNS * WIDTH, rows * HEIGHT)
    window.SetMultiSamples(8)
    for number, (result, (name, full, eye)) in enumerate(zip(results, PICTURES)):
        x, y = number % COLUMNS, rows - 1 - number // COLUMNS
        window.AddRenderer(scene(result, f"{name}{', full' if full else ''}", eye,
                                 (x / COLUMNS, y / rows, (x + 1) / COLUMNS, (y + 1) / rows)))
    window.Render()
    image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    writer.SetFileName(str(path))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def scene(result, title, eye, viewport):
    import vtk
    from offset_parts import poly_data

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetViewport(*viewport)
    for (points, triangles), colour in zip(result, (GREY, RED)):
        mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
        mapper.SetInputData(poly_data(points, triangles))
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*colour)
        actor.GetProperty().SetInterpolationToFlat()
        renderer.AddActor(actor)
    text = vtk.vtkTextActor()
    text.SetInput(title)
    text.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    text.GetTextProperty().SetFontSize(14)
    text.SetPosition(8, 6)
    renderer.AddActor2D(text)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(*eye)
    camera.SetViewUp(0.0, 1.0, 0.0)
    renderer.ResetCamera()
    camera.Zoom(1.35)
    return renderer


if __name__ == "__main__":
    main()
