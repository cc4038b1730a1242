#pragma once
#include <cmath>

namespace abut {

/// Times at which something is due: multiples of an interval, 0 among them. Steps are not shortened to meet them: what
/// is written doesn't change the results.
class Schedule {
public:
    /// \param every [s]; 0: never due, not even at 0
    explicit Schedule(double every = 0) : every_(every) {}
    /// Whether due(time) would be true.
    bool is_due(double time) const { return every_ > 0 && time >= next_; }
    /// True once for each due time that `time` has reached; several at once count as one.
    bool due(double time) {
        if (!is_due(time)) return false;
        next_ = (std::floor(time / every_ * (1 + 1e-12)) + 1) * every_;
        return true;
    }

private:
    double every_;
    double next_ = 0;
};

} // namespace abut
