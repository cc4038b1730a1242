#pragma once
#include "step/state.h"

#include <stdexcept>
#include <string>

namespace abut {

/// A run went wrong: it diverged, or a particle left the grid. what() tells step, time, particle, body and position.
class RunError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// "step 12, time 3.1e-06 s, particle 17 of body "grain" at (x, y) m: WHAT".
template <int D>
std::string describe_failure(const State<D>& state, std::int32_t particle, const std::string& what);

} // namespace abut
