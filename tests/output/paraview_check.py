# paraview_check.py FRAMES.pvd PICTURE...: fields that ParaView finds in the frames, the table of histories beside them,
# and the colours of the pictures. Writes the file `checked` where all is right.
import os
import sys

from paraview import servermanager
from paraview.simple import PVDReader
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLTableReader, vtkXMLTableWriter


def table_in(file):
    reader = vtkXMLTableReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


histories = table_in(os.path.join(os.path.dirname(sys.argv[1]), "histories.vtt"))
assert histories.GetNumberOfRows() > 500
# Data behind the XML are refused since Debian's security updates of libexpat. An older one would read all files.
writer = vtkXMLTableWriter()
writer.SetInputData(histories)
writer.SetFileName("appended.vtt")
writer.SetDataModeToAppended()
writer.EncodeAppendedDataOff()
assert writer.Write() == 1
assert table_in("appended.vtt").GetNumberOfRows() == 0, "libexpat is older than Debian's security updates"

frames = PVDReader(FileName=sys.argv[1])
times = list(frames.TimestepValues)
assert len(times) > 50, times
points = {"Displacement", "Velocity", "AbsoluteAcceleration"}
# Name: whether it is never zero everywhere during the run
cells = ["Drift", "StoreyShear", "IsolatorForce", "Opening", "ImpactForce", "InContact"]
largest = dict.fromkeys(cells, 0.0)
for time in times:
    frames.UpdatePipeline(time)
    grid = servermanager.Fetch(frames)
    assert points <= {grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())}
    for name in cells:
        array = grid.GetCellData().GetArray(name)
        assert array is not None, name
        values = [array.GetValue(i) for i in range(array.GetNumberOfTuples())]
        largest[name] = max([largest[name]] + [abs(value) for value in values if value == value])
assert all(value > 0.0 for value in largest.values()), largest

for picture in sys.argv[2:]:
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    pixels = reader.GetOutput().GetPointData().GetScalars()
    colours = {pixels.GetTuple(i) for i in range(0, pixels.GetNumberOfTuples(), 7)}
    white = sum(pixels.GetTuple(i)[:3] == (255.0, 255.0, 255.0) for i in range(0, pixels.GetNumberOfTuples(), 7))
    drawn = 1.0 - 7.0 * white / pixels.GetNumberOfTuples()
    assert len(colours) > 50 and drawn > 0.05, (picture, len(colours), drawn)
open("checked", "w").write("yes")
