"""What VTK itself reads of a .vtp or .ply file, as JSON: vtp_facts.py FILE. Needs python3-vtk9."""

import json
import sys

from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

errors = []
reader = vtkPLYReader() if sys.argv[1].endswith(".ply") else vtkXMLPolyDataReader()
reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
reader.SetFileName(sys.argv[1])
reader.Update()
data = reader.GetOutput()
points, cells = data.GetPointData(), data.GetCellData()


def values(fields):
    found = {}
    for k in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(k)
        found[array.GetName()] = [array.GetTuple(i) if array.GetNumberOfComponents() > 1 else array.GetTuple1(i)
                                  for i in range(array.GetNumberOfTuples())]
    return found


corners = []
for k in range(data.GetNumberOfCells()):
    cell = data.GetCell(k)
    corners.append([cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())])
json.dump({"errors": len(errors), "points": [data.GetPoint(k) for k in range(data.GetNumberOfPoints())],
           "lines": data.GetNumberOfLines(), "polys": data.GetNumberOfPolys(), "corners": corners,
           "point_data": values(points), "cell_data": values(cells)}, sys.stdout)
