"""ParaView plugin of abut: Tools > Manage Plugins > Load New..., this file. It needs the folder `abut_paraview` that
lies beside its own folder.

Adds the reader of scene files ("abut scene", File > Open) and the filters Contact View and Deformed Particles.
"""

import inspect
import os
import sys

if not hasattr(inspect, "getargspec"):  # ParaView up to 5.11 wants it, Python from 3.11 on has it no longer
    inspect.getargspec = inspect.getfullargspec

sys.path[:0] = [path for path in [os.path.dirname(os.path.dirname(os.path.abspath(__file__)))] if path not in sys.path]

from paraview.util.vtkAlgorithm import smdomain, smhint, smproperty, smproxy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid

from abut_paraview import blocks, contact_arrows, deformed_particles, scene
from abut_paraview.arrays import DataError

paraview_plugin_name = "abut"
paraview_plugin_version = "1.0"


def choice(name, method, entries, default, text, label):
    """XML of a property that is one of several words."""
    words = "".join(f'<Entry value="{number}" text="{word}"/>' for number, word in entries)
    return (f'<IntVectorProperty name="{name}" label="{label}" command="{method}" number_of_elements="1" '
            f'default_values="{default}"><EnumerationDomain name="enum">{words}</EnumerationDomain>'
            f"<Documentation>{text}</Documentation></IntVectorProperty>")


def value(kind, name, method, default, text, label, domain=""):
    """XML of a property of one value; kind: Double, Int or String."""
    return (f'<{kind}VectorProperty name="{name}" label="{label}" command="{method}" number_of_elements="1" '
            f'default_values="{default}">{domain}<Documentation>{text}</Documentation></{kind}VectorProperty>')


def properties(*xmls):
    """Properties in the order of the panel: ParaView shows those of single decorators from the last to the first."""
    return "".join(xmls)


def flag(name, method, default, text, label):
    return value("Int", name, method, int(default), text, label, '<BooleanDomain name="bool"/>')


class AbutAlgorithm(VTKPythonAlgorithmBase):
    """What all three share: settings by name, and errors as one text for the user."""

    def set(self, **settings):
        for name, setting in settings.items():
            if getattr(self, name) != setting:
                setattr(self, name, setting)
                self.Modified()

    def RequestData(self, request, inputs, outputs):
        try:
            self.fill(inputs, outputs)
        except DataError as error:
            vtkOutputWindow.GetInstance().DisplayErrorText(f"{error}\n")
            vtkDataObject.GetData(outputs, 0).Initialize()
        return 1  # also on errors: else VTK adds ten lines about its executive to the one that says what is wrong

    @staticmethod
    def tell_left_out(count, what):
        if count:
            vtkOutputWindow.GetInstance().DisplayWarningText(f"{count} {what} left out: not-a-number in their arrays\n")


class AbutFilter(AbutAlgorithm):
    """A filter of datasets, which also converts the blocks of composite data that it applies to."""

    input_types = ()
    output_type = vtkUnstructuredGrid

    def FillInputPortInformation(self, port, info):
        key = self.INPUT_REQUIRED_DATA_TYPE()
        info.Remove(key)
        for name in (*self.input_types, "vtkCompositeDataSet"):
            info.Append(key, name)
        return 1

    def FillOutputPortInformation(self, port, info):
        info.Set(vtkDataObject.DATA_TYPE_NAME(), "vtkDataObject")
        return 1

    def RequestDataObject(self, request, inputs, outputs):
        composite = vtkDataObject.GetData(inputs[0], 0).IsA("vtkCompositeDataSet")
        wanted = vtkMultiBlockDataSet if composite else self.output_type
        present = vtkDataObject.GetData(outputs, 0)
        if present is None or present.GetClassName() != wanted.__name__:
            outputs.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), wanted())
        return 1

    def fill(self, inputs, outputs):
        data = vtkDataObject.GetData(inputs[0], 0)
        if data.IsA("vtkCompositeDataSet"):
            data = blocks.map_leaves(data, self.applies, self.convert, self.label, self.wanted)
        else:
            data = self.convert(data)
        vtkDataObject.GetData(outputs, 0).ShallowCopy(data)


@smproxy.reader(name="AbutScene", label="abut scene", extensions="json", file_description="abut scene",
                support_reload=False)
@smhint.xml('<ReloadFiles property="Refresh"/>')
@smproperty.xml(properties(
    """
<StringVectorProperty name="FileName" command="set_file" number_of_elements="1" animateable="0"
                      panel_visibility="never">
  <FileListDomain name="files"/><Documentation>Scene file of abut (JSON).</Documentation>
</StringVectorProperty>""",
    choice("Particles", "set_particles", [(0, "points"), (1, "domains")], 1,
           "Particles as points, for filters, or as the domains that they stand for.", "Particles"),
    choice("Grid", "set_grid", [(0, "none"), (1, "outline"), (2, "lines"), (3, "image data")], 1,
           "The grid: the edges of its box, the lines of its cells (in 3D those on the box's sides), or "
           "image data.", "Grid"),
    choice("Boundaries", "set_boundaries", [(0, "outlines"), (1, "surfaces")], 0,
           "Walls and faces of scenes in space: their outlines, or surfaces, which hide what is behind.",
           "Boundaries"),
    value("String", "Program", "set_program", "",
          "Path of the program abut; empty: environment variable ABUT, the PATH, the build folder of the "
          "source tree.", "Program"),
    '<Property name="Refresh" command="refresh" panel_widget="command_button" label="Read Again">'
    "<Documentation>Read the scene again, also if only its images have changed.</Documentation></Property>"))
class AbutScene(AbutAlgorithm):
    """Bodies, boundaries and grid of a scene file before any run, as `abut particles` makes them."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkMultiBlockDataSet")
        self.file, self.program, self.particles, self.grid = "", "", scene.DOMAINS, scene.OUTLINE
        self.surfaces = False
        self.cache = scene.SceneCache()

    def set_file(self, name):
        self.set(file=name if name and name != "None" else "")

    def set_particles(self, kind):
        self.set(particles=kind)

    def set_grid(self, kind):
        self.set(grid=kind)

    def set_boundaries(self, surfaces):
        self.set(surfaces=bool(surfaces))

    def set_program(self, path):
        self.set(program=path or "")

    def refresh(self):
        self.cache.clear()
        self.Modified()

    def fill(self, inputs, outputs):
        if not self.file:
            raise DataError("abut scene: no file is chosen")
        made = scene.scene_blocks(self.cache.model(self.file, self.program), self.particles, self.grid,
                                  self.surfaces)
        vtkMultiBlockDataSet.GetData(outputs, 0).ShallowCopy(made)


@smproxy.filter(name="AbutContactView", label="Contact View", support_reload=False)
@smhint.xml('<ShowInMenu category="abut"/>')
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData", "vtkCompositeDataSet"], composite_data_supported=True)
@smproperty.xml(properties(
    choice("ScaleBy", "set_scale_by", [(0, "force"), (1, "area"), (2, "fixed length")], 0,
           "What the lengths of the arrows show.", "Scale By"),
    value("Double", "Length", "set_length", 4,
          "Length of the longest arrow (or of one whose value is Reference), in spacings of the grid.",
          "Length"),
    value("Double", "Reference", "set_reference", 0,
          "Force (N) or area (m^2) of an arrow of that length; 0: the frame's largest. Give it to compare "
          "frames.", "Reference"),
    value("Double", "Spacing", "set_spacing", 0,
          "Spacing of the grid (m); 0: found from the places of the pairs.", "Spacing"),
    choice("Direction", "set_direction", [(0, "normal"), (1, "force")], 0,
           "Arrows along the normal, from body_a to body_b, or along the force on body_a.", "Direction"),
    flag("OnlyInContact", "set_only_in_contact", True,
         "Only pairs that a force acted on in the last step.", "Only In Contact"),
    value("String", "Bodies", "set_bodies", "",
          "Only pairs of these bodies: names or numbers with commas between; empty: all.", "Bodies")))
class AbutContactView(AbutFilter):
    """Arrows at contact pairs (contact.pvd)."""

    label, wanted = "Contact View", "contact pairs (point arrays normal, separation, force ...; see contact.pvd)"
    input_types, output_type = ("vtkPolyData",), vtkPolyData

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, outputType="vtkPolyData")
        self.scale_by, self.length, self.reference, self.spacing = contact_arrows.BY_FORCE, 4.0, 0.0, 0.0
        self.direction, self.only_in_contact, self.bodies = contact_arrows.NORMAL, True, ""

    def set_scale_by(self, kind):
        self.set(scale_by=kind)

    def set_length(self, length):
        self.set(length=length)

    def set_reference(self, reference):
        self.set(reference=reference)

    def set_spacing(self, spacing):
        self.set(spacing=spacing)

    def set_direction(self, kind):
        self.set(direction=kind)

    def set_only_in_contact(self, only):
        self.set(only_in_contact=bool(only))

    def set_bodies(self, bodies):
        self.set(bodies=bodies or "")

    @staticmethod
    def applies(data):
        return data is not None and data.IsA("vtkPolyData") and data.GetPointData().HasArray("normal")

    def convert(self, data):
        arrows, left_out = contact_arrows.contact_arrows(
            data, scale_by=self.scale_by, length=self.length, reference=self.reference, spacing=self.spacing,
            direction=self.direction, only_in_contact=self.only_in_contact, bodies=self.bodies)
        self.tell_left_out(left_out, "contact pairs")
        return arrows


@smproxy.filter(name="AbutDeformedParticles", label="Deformed Particles", support_reload=False)
@smhint.xml('<ShowInMenu category="abut"/>')
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPointSet", "vtkCompositeDataSet"], composite_data_supported=True)
@smproperty.xml(properties(
    choice("Shape", "set_shape", [(0, "domains"), (1, "ellipses")], 0,
           "Parallelograms (3D: parallelepipeds), or ellipses (3D: ellipsoids) within them.", "Shape"),
    value("Double", "Scale", "set_scale", 1,
          "Of each domain about its centre; 0.9 shows the single particles.", "Scale"),
    value("Int", "Resolution", "set_resolution", 16, "Corners of an ellipse.", "Resolution",
          '<IntRangeDomain name="range" min="3" max="128"/>')))
class AbutDeformedParticles(AbutFilter):
    """Particles (particles.pvd) as the domains that they stand for."""

    label, wanted = "Deformed Particles", "the point arrays half_size and deformation_gradient (see particles.pvd)"
    input_types, output_type = ("vtkPointSet",), vtkUnstructuredGrid

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        self.shape, self.scale, self.resolution = deformed_particles.DOMAINS, 1.0, 16

    def set_shape(self, kind):
        self.set(shape=kind)

    def set_scale(self, scale):
        self.set(scale=scale)

    def set_resolution(self, resolution):
        self.set(resolution=max(3, resolution))

    @staticmethod
    def applies(data):
        return deformed_particles.is_particles(data)

    def convert(self, data):
        domains, left_out = deformed_particles.deformed_particles(data, self.shape, self.scale, self.resolution)
        self.tell_left_out(left_out, "particles")
        return domains
