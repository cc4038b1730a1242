#pragma once
/// \file vtk_messages.h
/// VTK reports errors as text in an "output window" and on stderr; here they become something to throw.

#include <memory>
#include <string>

namespace abut {

/// While it lives, VTK is silent and its error messages are collected. One at a time; not for several threads.
class VtkMessages {
public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// The first error so far in one line, without VTK's file and line numbers; empty if there was none.
    std::string first_error() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace abut
