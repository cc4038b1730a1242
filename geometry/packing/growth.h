#pragma once
/// \file growth.h
/// Growth of grains in stages, with relaxation after each.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace abut {

/// Lets grains grow until they fill the share `fraction` of their box. `grains` has set_fraction(share), fits() (each
/// of them alone fits in the box), relax_once() and apart() (none overlap). \throws std::runtime_error when that share
/// is not reached
template <class Grains>
void grow_to(Grains& grains, double fraction, const std::string& name, std::size_t count) {
    constexpr double first = 0.2, step = 0.02; // at 0.2 random places relax at once
    constexpr int most_sweeps = 4000;
    double reached = 0;
    for (double share = std::min(first, fraction);; share = std::min(share + step, fraction)) {
        grains.set_fraction(share);
        if (!grains.fits())
            throw std::runtime_error(
                fmt::format("the largest of {} {} that fill {:.2f} of the box is larger than the box; "
                            "ask for more bodies, more equal sizes or a wider box",
                            count, name, share));
        int sweep = 0;
        while (sweep < most_sweeps && !grains.apart()) {
            grains.relax_once();
            ++sweep;
        }
        if (!grains.apart())
            throw std::runtime_error(
                reached == 0
                    ? fmt::format("no room for {} {} with this gap", count, name)
                    : fmt::format(
                          "{} {} fill {:.2f} of the box at most, not {:.3f}; ask for less, or for a smaller gap", count,
                          name, reached, fraction));
        reached = share;
        if (share >= fraction) return;
    }
}

} // namespace abut
