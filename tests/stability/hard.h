#pragma once
/// What the hard cases measure and ask for.
///
/// Energy. The steps are symplectic Euler's: velocities first, then places and strains by the new velocities. For a
/// mode of frequency ω it keeps E − ½ Δt dU/dt (U strain energy), not E = T + U, so that E goes up and down by half of
/// what U changes by in a step. That, and nothing else, is what E may exceed its balance by:
///   T + U − (T + U)_0 − external work ≤ ½ max |U_n+1 − U_n| (+ a share that the case states with its reason).
///
/// Momentum. A gather or a scatter adds at most 36 terms, each with a relative error of 2^-53; momenta and impulses of
/// a step are at most √(2 M E) (Cauchy and Schwarz, Δt ≤ cell / wave speed). Errors that have nothing to do with each
/// other add up as their squares do: √(36 n) 2^-53 √(2 M E) after n steps, and four times that is never met by chance.

#include "core/support.h"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <string>

namespace test {

/// Hundreds of small scenes: threads would wait for each other more than they work.
inline const int one_thread = (omp_set_num_threads(1), 1);

/// Checks measured values against their limits and prints, at its end, the one of each kind that came nearest.
class Figures {
public:
    explicit Figures(std::string name_of_case) : name(std::move(name_of_case)) {}
    Figures(const Figures&) = delete;
    Figures& operator=(const Figures&) = delete;
    ~Figures() {
        for (const auto& [kind, figure] : worst)
            std::printf("[ figures  ] %s, %s: %.3g of at most %.3g (%.0f %%)%s%s\n", name.c_str(), kind.c_str(),
                        figure.measured, figure.limit, 100 * figure.measured / figure.limit,
                        figure.variant.empty() ? "" : ", nearest with ", figure.variant.c_str());
    }
    void at_most(const std::string& kind, const std::string& variant, double measured, double limit) {
        EXPECT_LE(measured, limit) << name << ", " << kind << ", " << variant;
        const auto [place, is_new] = worst.try_emplace(kind, Figure{variant, measured, limit});
        if (!is_new && !(measured / limit <= place->second.measured / place->second.limit))
            place->second = {variant, measured, limit};
    }

private:
    struct Figure {
        std::string variant;
        double measured, limit;
    };
    std::string name;
    std::map<std::string, Figure> worst;
};

/// Finite, and J > 0 everywhere.
template <int D>
bool is_sound(const State<D>& state) {
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (!state.particles.position[p].allFinite() || !state.particles.velocity[p].allFinite() ||
            !state.particles.stress[p].allFinite() || !(state.particles.deformation_gradient[p].determinant() > 0))
            return false;
    return true;
}

/// Follows energy and momentum.
template <int D>
struct Watch {
    State<D>& state;
    Totals start, now;
    double excess = 0;         ///< largest T + U − (T + U)_0 − external work [J]
    double half_change = 0;    ///< largest ½ |U_n+1 − U_n| [J]
    double largest = 0;        ///< T + U [J]
    double momentum_error = 0; ///< largest component of P − P_0 [kg m/s]
    long steps = 0;

    explicit Watch(State<D>& s) : state(s) {
        prepare(state);
        start = now = totals(state);
        largest = start.kinetic_energy + start.strain_energy;
    }
    void operator()() {
        const Totals next = totals(state);
        half_change = std::max(half_change, 0.5 * std::abs(next.strain_energy - now.strain_energy));
        const double energy = next.kinetic_energy + next.strain_energy;
        largest = std::max(largest, energy);
        excess = std::max(excess, energy + state.ledger.interface_energy - start.kinetic_energy - start.strain_energy -
                                      state.ledger.external_work);
        for (int a = 0; a < D; ++a)
            momentum_error = std::max(momentum_error, std::abs(next.momentum[a] - start.momentum[a]));
        now = next;
        ++steps;
    }
    double energy() const { return now.kinetic_energy + now.strain_energy; }
    /// What round-off can do to the momentum, see above.
    double momentum_limit() const {
        return 4 * std::sqrt(36 * static_cast<double>(steps)) * 0.5 * std::numeric_limits<double>::epsilon() *
               std::sqrt(2 * start.mass * largest);
    }
    /// What the time integration can do to the energy.
    double energy_limit(double share = 0) const { return half_change + share * largest; }

    bool keeps_momentum() const { return momentum_error <= momentum_limit(); }
    bool keeps_energy(double share = 0) const { return excess <= energy_limit(share); }

    void expect_energy(Figures& figures, const std::string& variant, double share = 0) const {
        figures.at_most("energy gained / largest energy", variant, std::max(0.0, excess) / largest,
                        energy_limit(share) / largest);
    }
    void expect_momentum(Figures& figures, const std::string& variant) const {
        const double scale = std::sqrt(2 * start.mass * largest);
        figures.at_most("momentum lost / sqrt(2 M E)", variant, momentum_error / scale, momentum_limit() / scale);
    }
};

/// The whole of a case without walls: runs, sound, energy, momentum.
template <int D>
Watch<D> run_watched(
    State<D>& state, double until, const std::function<void()>& each = [] {}) {
    Watch<D> watch(state);
    run(state, until, [&] {
        watch();
        each();
    });
    EXPECT_TRUE(is_sound(state));
    return watch;
}

inline const char* name_of(TransferScheme scheme) {
    constexpr const char* names[] = {"flip", "pic", "xpic", "fmpm"};
    return names[static_cast<int>(scheme)];
}

inline std::string name_of(const TransferSpec& t) {
    const bool ordered = t.scheme == TransferScheme::xpic || t.scheme == TransferScheme::fmpm;
    return name_of(t.scheme) + (ordered ? "(" + std::to_string(t.order) + ")" : std::string());
}

/// One of each scheme, of the orders in common use.
inline std::vector<TransferSpec> usual_transfers() {
    return {transfer(TransferScheme::flip),
            transfer(TransferScheme::pic),
            transfer(TransferScheme::xpic, 5),
            {TransferScheme::fmpm, 2, {}, {}}};
}

} // namespace test
