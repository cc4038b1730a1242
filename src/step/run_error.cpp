#include "step/run_error.h"

#include <sstream>

namespace abut {

template <int D>
RunError run_error(Trouble trouble, const State<D>& state, std::int32_t particle, const std::string& what) {
    std::ostringstream text;
    const Vec<D>& x = state.particles.position[particle];
    text << "step " << state.step << ", time " << state.time << " s, particle " << state.particles.id[particle]
         << " of body \"" << state.bodies[state.particles.body[particle]].name << "\" at (" << x[0];
    for (int a = 1; a < D; ++a) text << ", " << x[a];
    text << ") m: " << what;
    return {trouble, particle, text.str()};
}

template RunError run_error<2>(Trouble, const State<2>&, std::int32_t, const std::string&);
template RunError run_error<3>(Trouble, const State<3>&, std::int32_t, const std::string&);

} // namespace abut
