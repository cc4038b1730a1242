#pragma once
#include "io/checkpoint/checkpoint.h"
#include "step/good_state.h"

#include <algorithm>
#include <vector>

namespace abut {

/// The states that a run with "on_trouble": "shrink-step" may go back to: copies every 100 steps. Of the last two it is
/// the older one that counts, so that the trouble, which begins some steps before it is noticed, is not in it.
///
/// Checkpoints of such a run are of this state too: a resumed run then goes back to where the uninterrupted one would.
template <int D>
class GoodStates {
public:
    struct Good {
        State<D> state; ///< kept_copy()
        OutputProgress output;
    };

    explicit GoodStates(bool wanted) : wanted_(wanted) {}

    /// Whether a copy is to be made of the state, which is about to be advanced.
    bool due(const State<D>& state) const {
        if (!wanted_) return false;
        return kept_.empty() || (state.step % 100 == 0 && state.step > kept_.back().state.step);
    }
    void keep(const State<D>& state, const OutputProgress& output) {
        if (kept_.size() == 2) kept_.erase(kept_.begin());
        kept_.push_back({kept_copy(state), output});
    }
    bool empty() const { return kept_.empty(); }
    Good& oldest() { return kept_.front(); }
    /// Those after the oldest are of steps that are given up.
    void drop_newer() { kept_.resize(std::min<std::size_t>(kept_.size(), 1)); }

private:
    bool wanted_;
    std::vector<Good> kept_;
};

} // namespace abut
