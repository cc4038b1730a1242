#pragma once
/// \file offscreen_context.h
/// OpenGL without a display: neither X nor a monitor nor a graphics card is needed.

#include <memory>

class vtkRenderWindow; // NOLINT(cppcoreguidelines-virtual-class-destructor)

namespace abut {

/// A VTK render window on an OpenGL context of our own (EGL, surfaceless; Mesa's software renderer if there is no
/// other). Debian's VTK knows only X windows by itself. Throws std::runtime_error if the system has no such OpenGL.
class OffscreenContext {
public:
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    vtkRenderWindow& window();

    /// Whether this process has had a context, also one that is gone: a process forked from it cannot have one.
    static bool used();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace abut
