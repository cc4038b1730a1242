#pragma once
#include <optional>

namespace abut {

/// Counts the instructions of this program in user space: a cost that doesn't depend on the machine's load. Linux's
/// perf_event_open; threads that are started later are counted with it. Where the system or the processor (many virtual
/// machines) doesn't allow it, there is no count.
class InstructionCounter {
public:
    InstructionCounter(); ///< starts counting
    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;
    ~InstructionCounter();

    /// Since the start; nothing where they can't be counted.
    std::optional<long long> count() const;

private:
    int descriptor_ = -1;
};

} // namespace abut
