#include "io/render/renderer_png.h"

#include "io/render/offscreen_context.h"
#include "io/results/vtk_messages.h"
#include "io/results/write_text.h"

#include <fmt/format.h>
#include <stdexcept>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

namespace abut {

void write_renderer_png(OffscreenContext& context, vtkRenderer& renderer, int width, int height, int samples,
                        const std::filesystem::path& path) {
    VtkMessages messages;
    vtkRenderWindow& window = context.window();
    window.SetDPI(72);
    window.SetSize(width, height);
    window.SetMultiSamples(samples);
    window.AddRenderer(&renderer);
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(&window);
    image->SetInputBufferTypeToRGB();
    image->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(image->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    window.RemoveRenderer(&renderer);

    vtkUnsignedCharArray* bytes = writer->GetResult();
    const std::string cause = messages.first_error();
    if (!cause.empty() || !bytes || bytes->GetNumberOfValues() == 0)
        throw std::runtime_error(
            fmt::format("{}: cannot draw: {}", path.string(), cause.empty() ? "no picture" : cause));
    write_text_atomically(path, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                                 static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

} // namespace abut
