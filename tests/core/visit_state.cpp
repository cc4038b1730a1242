/// The lists of what a state and its particles keep: a member that is added to them is not forgotten there.
#include "step/visit_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace abut;

/// Stands for a member of any type.
struct Any {
    template <class T>
    operator T() const; // NOLINT: implicit, and never called
};

/// Number of members of an aggregate: of how many values it can be made.
template <class Aggregate, class... Members>
constexpr std::size_t members() {
    if constexpr (requires { Aggregate{Members{}..., Any{}}; })
        return members<Aggregate, Members..., Any>();
    else
        return sizeof...(Members);
}

struct Three {
    int one;
    std::vector<double> two;
    Vec<2> three = Vec<2>::Zero();
};
static_assert(members<Three>() == 3);

/// Where the members that were named lie in an object.
class Places {
public:
    template <class... Members>
    void add(const Members&... member) {
        (places_.push_back({reinterpret_cast<const char*>(&member), sizeof member}), ...);
    }
    template <class... Members>
    void add(const std::tuple<Members&...>& together) {
        std::apply([&](const auto&... member) { add(member...); }, together);
    }

    /// All of them in the object, none twice.
    template <class Object>
    void expect_all_of(const Object& object) {
        EXPECT_EQ(places_.size(), members<Object>());
        std::sort(places_.begin(), places_.end());
        const char* free = reinterpret_cast<const char*>(&object);
        const char* const end = free + sizeof object;
        for (const auto& [begin, size] : places_) {
            EXPECT_GE(begin, free) << "a member is named twice, or of another object";
            free = begin + size;
        }
        EXPECT_LE(free, end);
    }

private:
    std::vector<std::pair<const char*, std::size_t>> places_;
};

template <int D>
void expect_all_named() {
    const State<D> state{};
    Places places;
    visit_state([&](const char*, const auto& member) { places.add(member); }, state);
    // What follows from the scene and the model.
    places.add(state.scene, state.effects, state.bodies, state.materials, state.initial_position, state.temperature,
               state.orientation, state.grid, state.speed_limit, state.traction_faces);
    // What each step makes anew before it reads it.
    places.add(state.fields, state.stencil_store, state.nodes, state.contact, state.poses, state.controls,
               state.shaped_faces, state.wants_areas);
    places.expect_all_of(state);

    const Particles<D> particles{};
    Places arrays;
    const auto add = [&](const char*, const auto& values) { arrays.add(values); };
    visit_changing(add, particles);
    visit_lasting(add, particles);
    arrays.expect_all_of(particles);
}

TEST(VisitState, EveryMemberIsVisitedOrMadeAnew) {
    // If this fails for a member that you have added: does a run that is resumed need it? Then it belongs in
    // visit_state(), else in one of the lists above.
    expect_all_named<2>();
    expect_all_named<3>();
}

TEST(VisitState, SumsAreAllOfReals) {
    // Checkpoints write them as rows of reals.
    EXPECT_EQ(sizeof(Ledger), members<Ledger>() * sizeof(double));
    EXPECT_EQ(sizeof(EnergyWatch), members<EnergyWatch>() * sizeof(double));
    EXPECT_EQ(sizeof(PairTotals), (members<PairTotals>() - 1) * sizeof(double) + sizeof(Vector));
    EXPECT_EQ(sizeof(RigidTotals), members<RigidTotals>() * sizeof(Vector));
}

TEST(VisitState, OfTwoStatesGivesTheSameMemberOfBoth) {
    State<2> one;
    State<2> other;
    std::vector<std::string> names;
    const auto offset = [](const auto& member, const auto& state) {
        return reinterpret_cast<const char*>(&member) - reinterpret_cast<const char*>(&state);
    };
    visit_state(
        [&]<class A, class B>(const char* name, A&& a, B&& b) {
            names.emplace_back(name);
            if constexpr (std::is_lvalue_reference_v<A>) {
                EXPECT_EQ(offset(a, one), offset(b, other)) << name;
            } else { // numbers together
                std::get<0>(a) = 7;
                EXPECT_EQ(std::get<0>(b), 0) << name;
            }
        },
        one, other);
    EXPECT_EQ(one.time, 7);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

} // namespace
