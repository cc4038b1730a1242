#pragma once
#include "app/good_states.h"
#include "app/run_files.h"
#include "step/run_error.h"

#include <string>

namespace abut {

/// "energy-growth", "left-grid" ...: for timing.json.
std::string word_of(Trouble trouble);

/// Whether a smaller time step can help.
bool depends_on_step(Trouble trouble);

/// Ends a run that went wrong: leaves the states before and after, and throws the diagnosis with the names of these
/// files and advice that fits the scene's settings. If the files can't be written, the diagnosis is given all the same.
/// \param checkpoint Checkpoints::last() \param unwritten why something else was not written; empty: nothing
template <int D>
[[noreturn]] void report_trouble(const RunError& error, State<D>& state, RunFiles& files, GoodStates<D>& good,
                                 const std::string& checkpoint, const std::string& unwritten);

} // namespace abut
