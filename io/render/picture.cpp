#include "io/render/picture.h"

#include "io/render/renderer_png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace abut {
namespace {

constexpr int dots_per_inch = 72;  // font sizes are then pixels
constexpr double quad_depth = 100; // quads lie at z from 0 to this, dots and faces below 0

/// Colours of points, `corners` successive ones of each colour: VTK draws them faster than colours of cells.
vtkSmartPointer<vtkUnsignedCharArray> colour_array(const std::vector<Rgb>& colours, std::size_t corners) {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size() * corners));
    std::uint8_t* out = array->GetPointer(0);
    for (const Rgb& colour : colours)
        for (std::size_t k = 0; k < corners; ++k) out = std::copy(colour.begin(), colour.end(), out);
    return array;
}

/// Points whose z is `depth(i)`; single precision is 1/1000 of a pixel.
template <class Depth>
vtkSmartPointer<vtkPoints> point_array(const std::vector<Pixel>& pixels, Depth depth) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetNumberOfPoints(static_cast<vtkIdType>(pixels.size()));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        points->SetPoint(static_cast<vtkIdType>(i), pixels[i][0], pixels[i][1], depth(i));
    return points;
}

/// Cells of `corners` successive points each.
vtkSmartPointer<vtkCellArray> cell_array(std::size_t points, int corners) {
    vtkNew<vtkTypeInt32Array> offsets, indices;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(points) / corners + 1);
    for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i) offsets->SetValue(i, static_cast<int>(i) * corners);
    indices->SetNumberOfValues(static_cast<vtkIdType>(points));
    std::iota(indices->GetPointer(0), indices->GetPointer(0) + points, 0);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, indices);
    return cells;
}

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    return actor;
}

vtkSmartPointer<vtkActor> actor_of(const Quads& quads) {
    vtkNew<vtkPolyData> data;
    // Of quads at the same depth OpenGL need not show the later one; so each lies a little in front of the one before.
    const double step = quad_depth / static_cast<double>(quads.colours.size());
    data->SetPoints(point_array(quads.corners, [&](std::size_t i) {
        const std::size_t quad = i / 4;
        return step * static_cast<double>(quad);
    }));
    data->SetPolys(cell_array(quads.corners.size(), 4));
    data->GetPointData()->SetScalars(colour_array(quads.colours, 4));
    return actor_of(data);
}

vtkSmartPointer<vtkActor> actor_of(const Faces& faces, double front) {
    vtkNew<vtkPolyData> data;
    data->SetPoints(point_array(faces.corners, [&](std::size_t i) { return faces.depths[i] - front; }));
    data->SetPolys(cell_array(faces.corners.size(), 4));
    data->GetPointData()->SetScalars(colour_array(faces.colours, 4));
    return actor_of(data);
}

vtkSmartPointer<vtkActor> actor_of(const Dots& dots, double front) {
    vtkNew<vtkPolyData> data;
    data->SetPoints(point_array(dots.centres, [&](std::size_t i) { return dots.depths[i] - front; }));
    data->SetVerts(cell_array(dots.centres.size(), 1));
    data->GetPointData()->SetScalars(colour_array(dots.colours, 1));
    auto actor = actor_of(data);
    actor->GetProperty()->SetPointSize(static_cast<float>(std::max(1.0, dots.diameter)));
    actor->GetProperty()->SetRenderPointsAsSpheres(true);
    actor->GetProperty()->SetLighting(dots.shaded);
    return actor;
}

/// Depth that nothing in space reaches [pixels].
double front_of(const Picture& picture) {
    double front = -std::numeric_limits<double>::infinity();
    for (const double depth : picture.dots.depths) front = std::max(front, depth + picture.dots.diameter);
    for (const double depth : picture.faces.depths) front = std::max(front, depth + 1);
    return front;
}

void set_font(vtkTextProperty& property, double size, bool bold) {
    property.SetFontFamilyToArial();
    property.SetFontSize(static_cast<int>(std::lround(size)));
    property.SetBold(bold);
}

vtkSmartPointer<vtkTextActor> actor_of(const Label& label) {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetInput(label.text.c_str());
    vtkTextProperty& property = *actor->GetTextProperty();
    set_font(property, label.size, label.bold);
    property.SetColor(label.colour[0] / 255.0, label.colour[1] / 255.0, label.colour[2] / 255.0);
    // VTK places the lower left corner of a box that reaches down to the descenders; on whole pixels the text is sharp.
    constexpr double descent = 0.21;
    const double width = text_width(label.text, label.size, label.bold);
    const double shift = label.align == Align::left ? 0 : label.align == Align::right ? width : width / 2;
    actor->SetDisplayPosition(static_cast<int>(std::lround(label.at[0] - shift)),
                              static_cast<int>(std::lround(label.at[1] - descent * label.size)));
    return actor;
}

/// A camera for which world coordinates are pixels.
void look_at_pixels(vtkRenderer& renderer, const Picture& picture) {
    vtkCamera& camera = *renderer.GetActiveCamera();
    camera.ParallelProjectionOn();
    camera.SetFocalPoint(picture.width / 2.0, picture.height / 2.0, 0);
    camera.SetPosition(picture.width / 2.0, picture.height / 2.0, 2 * quad_depth);
    camera.SetViewUp(0, 1, 0);
    camera.SetParallelScale(picture.height / 2.0);
    renderer.ResetCameraClippingRange();
}

} // namespace

void Quads::add(const Pixel& a, const Pixel& b, const Pixel& c, const Pixel& d, Rgb colour) {
    corners.insert(corners.end(), {a, b, c, d});
    colours.push_back(colour);
}

void Quads::add_rectangle(const Pixel& lower, const Pixel& upper, Rgb colour) {
    add(lower, {upper[0], lower[1]}, upper, {lower[0], upper[1]}, colour);
}

double text_width(const std::string& text, double size, bool bold) {
    vtkNew<vtkTextProperty> property;
    set_font(*property, size, bold);
    int box[4] = {0, 0, 0, 0};
    vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box, dots_per_inch);
    return box[1] - box[0] + 1;
}

void write_png(OffscreenContext& context, const Picture& picture, const std::filesystem::path& path) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    const double front = front_of(picture);
    if (!picture.dots.centres.empty()) renderer->AddActor(actor_of(picture.dots, front));
    if (!picture.faces.colours.empty()) renderer->AddActor(actor_of(picture.faces, front));
    if (!picture.quads.colours.empty()) renderer->AddActor(actor_of(picture.quads));
    for (const Label& label : picture.labels) renderer->AddViewProp(actor_of(label));
    look_at_pixels(*renderer, picture);

    write_renderer_png(context, *renderer, picture.width, picture.height, 4, path);
}

} // namespace abut
