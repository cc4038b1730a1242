#pragma once
#include "app/instruction_counter.h"
#include "app/run_files.h"

#include <optional>

namespace abut {

/// CPU time of all threads of this program so far [s].
double cpu_seconds();

/// Adds up what stepping costs, with pauses.
class Meter {
public:
    /// \param instructions whether they are counted, too; of threads that are there before, they are not
    explicit Meter(bool instructions);
    void go_on();
    /// Adds what has been used since go_on(). \return whether it was going on
    bool pause(RunTiming& timing);

private:
    std::optional<InstructionCounter> counter_;
    bool running_ = false;
    double cpu_ = 0;                        ///< at the last go_on()
    std::optional<long long> instructions_; ///< likewise
};

} // namespace abut
