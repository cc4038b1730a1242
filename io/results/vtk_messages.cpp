#include "io/results/vtk_messages.h"

#include <cstring>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace abut {
namespace {

/// Keeps the first error; warnings and debug text are dropped.
class CollectingWindow : public vtkOutputWindow {
public:
    static CollectingWindow* New();
    vtkTypeMacro(CollectingWindow, vtkOutputWindow) // ends in its own semicolon

        void DisplayText(const char*) override {}
    void DisplayWarningText(const char*) override {}
    void DisplayGenericWarningText(const char*) override {}
    void DisplayDebugText(const char*) override {}
    void DisplayErrorText(const char* text) override {
        // Without X, GLEW misses GLX each time a window is set up; it has loaded OpenGL's functions all the same.
        const bool harmless = std::strstr(text, "GLEW could not be initialized") != nullptr;
        if (first.empty() && !harmless) first = text;
    }

    std::string first;
};
vtkStandardNewMacro(CollectingWindow);

} // namespace

struct VtkMessages::State {
    vtkNew<CollectingWindow> window;
    vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
    vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
};

VtkMessages::VtkMessages() : state_(std::make_unique<State>()) {
    vtkOutputWindow::SetInstance(state_->window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages() {
    vtkOutputWindow::SetInstance(state_->before);
    vtkLogger::SetStderrVerbosity(state_->verbosity);
}

std::string VtkMessages::first_error() const {
    // "ERROR: In file.cxx, line 12\nvtkWriter (0x55…): what went wrong\n\n" -> "what went wrong"
    std::string text = state_->window->first;
    if (const auto at = text.find("): "); at != std::string::npos) text.erase(0, at + 3);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

} // namespace abut
