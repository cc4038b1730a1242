#pragma once
/// \file workers.h
/// Work shared among processes: VTK draws in one thread only, and an OpenGL context cannot be shared.

#include <functional>

namespace abut {

/// Calls `work(0)` to `work(count - 1)`, each once, in up to `jobs` forked processes that take the next number when
/// they are done with one; what `work` leaves in memory is lost. `done(n)` is called in this process whenever n calls
/// are done. If a call throws, the others end with what they are at, and its message is thrown as std::runtime_error;
/// so it is, with another message, if a process dies. With one job, or nothing to share, all is called here.
void share_work(int count, int jobs, const std::function<void(int)>& work, const std::function<void(int)>& done);

} // namespace abut
