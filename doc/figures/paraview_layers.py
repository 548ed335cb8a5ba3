# Draws the layers of the initial material as draw_flow does, in ParaView 5.10
# or later:
#   pvbatch doc/figures/paraview_layers.py output/quickstart 0.5 layers.png
import sys

from paraview.simple import *

if len(sys.argv) != 4:
    sys.exit("usage: pvbatch paraview_layers.py OUTPUT_DIRECTORY TIME PICTURE")
directory, time, picture = sys.argv[1:]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [900, 1200]
view.OrientationAxesVisibility = 0

particles = PVDReader(FileName=directory + "/particles.pvd")
# Set to 0.5 s, the reader would not take 0.5002 s.
times = particles.TimestepValues
view.ViewTime = min(times, key=lambda t: abs(t - float(time)))

display = Show(particles, view)
display.SetRepresentationType("Points")
display.PointSize = 4
display.RenderPointsAsSpheres = 0
ColorBy(display, ("POINTS", "layer"))
display.SetScalarBarVisibility(view, False)

# Each layer is a category of its own: odd ones dark, even ones light.
colors = GetColorTransferFunction("layer")
colors.InterpretValuesAsCategories = 1
colors.Annotations = [str(layer) for layer in range(1, 17) for _ in range(2)]
colors.IndexedColors = 8 * [0.59, 0.37, 0.16, 0.93, 0.78, 0.53]

walls = Show(PVDReader(FileName=directory + "/walls.pvd"), view)
ColorBy(walls, None)
walls.AmbientColor = walls.DiffuseColor = [0.15, 0.16, 0.19]
walls.LineWidth = 5

view.InteractionMode = "2D"
ResetCamera(view)
SaveScreenshot(picture, view, OverrideColorPalette="WhiteBackground")
