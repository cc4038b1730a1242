#include "app/meter.h"

#include <ctime>

namespace abut {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Meter::Meter(bool instructions) {
    if (instructions) counter_.emplace();
}

void Meter::go_on() {
    running_ = true;
    cpu_ = cpu_seconds();
    if (counter_) instructions_ = counter_->count();
}

bool Meter::pause(RunTiming& timing) {
    if (!running_) return false;
    running_ = false;
    timing.solver_cpu_seconds += cpu_seconds() - cpu_;
    if (instructions_)
        if (const auto now = counter_->count())
            timing.instructions = timing.instructions.value_or(0) + *now - *instructions_;
    return true;
}

} // namespace abut
