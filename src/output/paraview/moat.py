"""Draws the frames beside this file in ParaView: displaced, coloured, seen from the front or from above.

    paraview --script=moat.py                                the program, started in the folder of this file
    pvbatch moat.py --picture frame.png --time 3.4           a picture without a window
    pvbatch moat.py --help                                   all options

In ParaView's own Python shell: `colour("Drift")` shows another field.
"""

import argparse
import os
import sys

from paraview.simple import *  # noqa: F401,F403 (the commands of ParaView)

# Name: (association, title of the legend, whether both signs occur)
FIELDS = {
    "Displacement": ("POINTS", "displacement [m]", False),
    "AbsoluteAcceleration": ("POINTS", "absolute acceleration [m/s^2]", False),
    "Drift": ("CELLS", "drift [m]", True),
    "StoreyShear": ("CELLS", "storey shear [N]", True),
    "IsolatorForce": ("CELLS", "isolator force [N]", True),
    "Opening": ("CELLS", "opening of gaps [m]", True),
    "ImpactForce": ("CELLS", "impact force [N]", False),
    "InContact": ("CELLS", "in contact", False),
}
SHARE_OF_SIZE = 0.1  # of the largest displacement, drawn without --exaggeration


def parse_options():
    parser = argparse.ArgumentParser(prog="moat.py", description="Draws the frames of moat in ParaView.")
    parser.add_argument("--field", choices=FIELDS, default="AbsoluteAcceleration", help="the field that colours")
    parser.add_argument("--exaggeration", type=float, help="of displacements; chosen by the size of the model")
    parser.add_argument("--time", type=float, help="s; the last frame by default")
    parser.add_argument("--picture", help="write this PNG file and end")
    parser.add_argument("--size", type=int, nargs=2, default=(1280, 960), help="of the picture, pixels")
    return parser.parse_known_args(sys.argv[1:])[0]


def frames_file():
    folder = os.path.dirname(os.path.abspath(globals().get("__file__", "moat.py")))
    file = os.path.join(folder, "frames.pvd")
    if not os.path.exists(file):
        raise SystemExit("moat.py: there is no " + file + ". Start ParaView in the folder of the results.")
    return file


def largest_displacement(frames, times):
    largest = 0.0
    for time in times:
        frames.UpdatePipeline(time)
        # The magnitude; -1 selects it.
        largest = max(largest, frames.PointData["Displacement"].GetRange(-1)[1])
    return largest


def colour(name):
    """Colours by a field of FIELDS, with one range for all times. Cells without it are grey."""
    association, title, both_signs = FIELDS[name]
    ColorBy(shown, (association, name))
    shown.RescaleTransferFunctionToDataRangeOverTime()
    scale = GetColorTransferFunction(name)
    # The colours of both maps differ for every kind of colour vision.
    scale.ApplyPreset("Cool to Warm" if both_signs else "Viridis (matplotlib)", True)
    if both_signs:
        largest = max(abs(scale.RGBPoints[0]), abs(scale.RGBPoints[-4]))
        if largest > 0.0:
            scale.RescaleTransferFunction(-largest, largest)
    scale.NanColor = (0.8, 0.8, 0.8)
    legend = GetScalarBar(scale, view)
    legend.Title, legend.ComponentTitle = title, ""
    legend.TitleColor = legend.LabelColor = (0.0, 0.0, 0.0)
    shown.SetScalarBarVisibility(view, True)
    Render(view)


options = parse_options()
frames = PVDReader(FileName=frames_file())
times = list(frames.TimestepValues)
frames.UpdatePipeline(times[0])
bounds = frames.GetDataInformation().GetBounds()
sides = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
exaggeration = options.exaggeration
if exaggeration is None:
    largest = largest_displacement(frames, times)
    exaggeration = max(1.0, SHARE_OF_SIZE * max(sides) / largest) if largest > 0.0 else 1.0

view = GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = (1.0, 1.0, 1.0)
view.OrientationAxesLabelColor = (0.0, 0.0, 0.0)
warped = WarpByVector(Input=frames, Vectors=["POINTS", "Displacement"], ScaleFactor=exaggeration)
shown = Show(warped, view)
shown.SetRepresentationType("Surface With Edges")
shown.EdgeColor = (0.35, 0.35, 0.35)
shown.LineWidth = 4.0
caption = Show(
    AnnotateTimeFilter(Input=frames, Format="t = {time:.3f} s, displacements x %.3g" % exaggeration), view
)
caption.Color = (0.0, 0.0, 0.0)

animation = GetAnimationScene()
animation.UpdateAnimationUsingDataTimeSteps()
animation.AnimationTime = times[-1] if options.time is None else min(times, key=lambda t: abs(t - options.time))
colour(options.field)

# A model on a line lies in the plane of x and z.
view.InteractionMode = "2D" if sides[1] == 0.0 else "3D"
middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
towards = (0.0, -1.0, 0.0) if sides[1] == 0.0 else (0.6, -1.0, 0.5)
view.CameraFocalPoint = middle
view.CameraPosition = [middle[i] + 3.0 * max(sides) * towards[i] for i in range(3)]
view.CameraViewUp = (0.0, 0.0, 1.0)
ResetCamera(view)
Render(view)
if options.picture:
    view.ViewSize = options.size
    SaveScreenshot(options.picture, view, ImageResolution=options.size)
