#include "io/render/offscreen_context.h"

#include "io/results/vtk_messages.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <atomic>
#include <fmt/format.h>
#include <stdexcept>
#include <string_view>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

namespace abut {
namespace {

std::atomic<bool> any_context{false};

[[noreturn]] void fail(std::string_view what) {
    throw std::runtime_error(fmt::format("cannot render: {} (EGL error {:#x}); is libgl1-mesa-dri installed?", what,
                                         static_cast<unsigned>(eglGetError())));
}

EGLDisplay surfaceless_display() {
    any_context = true;
    // Asked for by extension: the platform exists in EGL 1.5 and, as an extension, before.
    const auto get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!get_platform_display) fail("EGL has no platform displays");
    EGLDisplay display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) fail("no surfaceless EGL display");
    return display;
}

EGLContext core_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL has no desktop OpenGL");
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    const EGLint version[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &found) || found == 0) fail("no OpenGL configuration");
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT) fail("no OpenGL 3.2 context");
    return context;
}

} // namespace

struct OffscreenContext::State {
    EGLDisplay display = surfaceless_display();
    EGLContext context = core_context(display);
    vtkNew<vtkGenericOpenGLRenderWindow> window;

    bool is_current() const { return eglGetCurrentContext() == context; }
    void make_current() const { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context); }

    ~State() {
        make_current();
        window->Finalize();
        window->RemoveAllObservers();
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
        // The display is the process's own, not ours: another context may live on it.
    }
};

OffscreenContext::OffscreenContext() : state_(std::make_unique<State>()) {
    // The window asks its owner for everything that concerns the context.
    vtkNew<vtkCallbackCommand> answer;
    answer->SetClientData(state_.get());
    answer->SetCallback([](vtkObject*, unsigned long event, void* client, void* call) {
        const auto& state = *static_cast<State*>(client);
        if (event == vtkCommand::WindowMakeCurrentEvent) state.make_current();
        if (event == vtkCommand::WindowIsCurrentEvent) *static_cast<bool*>(call) = state.is_current();
        if (event == vtkCommand::WindowIsDirectEvent) *static_cast<int*>(call) = 1;
        if (event == vtkCommand::WindowSupportsOpenGLEvent) *static_cast<int*>(call) = 1;
    });
    auto& window = *state_->window;
    for (const unsigned long event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                                      vtkCommand::WindowIsDirectEvent, vtkCommand::WindowSupportsOpenGLEvent})
        window.AddObserver(event, answer);
    window.SetOwnContext(0);
    window.SetReadyForRendering(true);
    window.SetMapped(1);
    state_->make_current();
    VtkMessages silent; // GLEW looks for X first and complains
    window.OpenGLInit();
}

OffscreenContext::~OffscreenContext() = default;

bool OffscreenContext::used() {
    return any_context;
}

vtkRenderWindow& OffscreenContext::window() {
    return *state_->window;
}

} // namespace abut
