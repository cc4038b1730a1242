#include "step/good_state.h"

#include "step/tasks.h"
#include "step/visit_state.h"

namespace abut {

namespace {

template <int D>
void copy_what_changes(const State<D>& from, State<D>& to) {
    visit_state([](const char*, auto&& copy, const auto& original) { copy = original; }, to, from);
}

} // namespace

template <int D>
State<D> kept_copy(const State<D>& state) {
    State<D> kept;
    copy_what_changes(state, kept);
    return kept;
}

template <int D>
void go_back(const State<D>& kept, State<D>& state) {
    copy_what_changes(kept, state);
    // The slots are those of the windows of another time: none may be taken for unchanged.
    for (Tile<D>& tile : state.tiling.tiles) tile.window = Window<D>::empty();
    find_traction_particles(state);
}

template State<2> kept_copy<2>(const State<2>&);
template State<3> kept_copy<3>(const State<3>&);
template void go_back<2>(const State<2>&, State<2>&);
template void go_back<3>(const State<3>&, State<3>&);

} // namespace abut
