# Writes grains.png (three grains), temperature.png (hot below, cold above) and orientation.png (one grey per grain).
import numpy as np
from vtk import vtkImageImport, vtkPNGWriter

row, column = np.mgrid[0:60, 0:120] + 0.5
grain = (column + 0.4 * row > 50).astype(int) + (column - 0.3 * row > 75)


def write(name, grey):
    data = np.ascontiguousarray(grey[::-1], dtype=np.uint8).tobytes()  # VTK's first row is the bottom
    image = vtkImageImport()
    image.CopyImportVoidPointer(data, len(data))
    image.SetDataScalarTypeToUnsignedChar()
    image.SetWholeExtent(0, 119, 0, 59, 0, 0)
    image.SetDataExtentToWholeExtent()
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


write("grains.png", 60 + 60 * grain)
write("temperature.png", 255 * row / 60)
write("orientation.png", np.array([0, 85, 170])[grain])
