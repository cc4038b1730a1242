#pragma once
#include "step/state.h"

#include <stdexcept>
#include <string>

namespace abut {

/// A run went wrong. what() tells step, time, body, particle, position and what is wrong.
class RunError : public std::runtime_error {
public:
    RunError(Trouble trouble, std::int32_t particle, const std::string& message)
        : std::runtime_error(message), trouble_(trouble), particle_(particle) {}
    Trouble trouble() const { return trouble_; }
    /// Index of the particle in the state gone wrong.
    std::int32_t particle() const { return particle_; }

private:
    Trouble trouble_;
    std::int32_t particle_;
};

/// An error that says "step 12, time 3.1e-06 s, particle 17 of body "grain" at (x, y) m: WHAT".
template <int D>
RunError run_error(Trouble trouble, const State<D>& state, std::int32_t particle, const std::string& what);

} // namespace abut
