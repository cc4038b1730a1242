#include "boundary/boundary.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// What imposing a control changes the velocity along its direction by.
double change_of(const Control& control, const std::vector<Pack>& velocity) {
    const double now = dot(velocity[control.slot], control.direction);
    const double wanted = control.mirror < 0 ? control.velocity : -dot(velocity[control.mirror], control.direction);
    const double change = wanted - now;
    return change * control.push < 0 ? 0 : change; // may leave the wall
}

} // namespace

void impose(std::vector<Control>& controls, std::vector<Pack>& velocity) {
    for (Control& control : controls) {
        const double change = change_of(control, velocity);
        Pack& v = velocity[control.slot];
        control.impulse += v[0] * change;
        v += change * control.direction;
    }
}

void impose_untracked(const std::vector<Control>& controls, std::vector<Pack>& velocity) {
    for (const Control& control : controls) velocity[control.slot] += change_of(control, velocity) * control.direction;
}

double settle(std::vector<Control>& controls, std::vector<Boundary>& boundaries) {
    double work = 0;
    for (Control& control : controls) {
        if (control.boundary >= 0) {
            Vector& total = boundaries[control.boundary].impulse;
            for (int a = 0; a < 3; ++a) total[a] += control.impulse * control.direction[a + 1];
            work += control.impulse * control.velocity;
        }
        control.impulse = 0;
    }
    return work;
}

void make_orthogonal(std::vector<Control>& controls, std::size_t slots) {
    std::vector<std::vector<Control*>> shared; // controls of each slot that a velocity condition controls
    std::vector<std::int32_t> place(slots, -1);
    for (const Control& control : controls)
        if (control.of_box && place[control.slot] < 0) {
            place[control.slot] = static_cast<std::int32_t>(shared.size());
            shared.emplace_back();
        }
    for (Control& control : controls)
        if (place[control.slot] >= 0) shared[place[control.slot]].push_back(&control);
    constexpr double parallel = 1e-6;
    constexpr std::int32_t dropped = -1;
    for (auto& group : shared) {
        if (group.size() < 2) continue;
        // Velocity conditions first, then walls that hold: those after them rely on what is before.
        std::stable_sort(group.begin(), group.end(), [](const Control* a, const Control* b) {
            const auto rank = [](const Control* c) { return c->of_box ? 0 : (c->push == 0 ? 1 : 2); };
            return rank(a) < rank(b);
        });
        std::vector<Control*> kept;
        for (Control* control : group) {
            const auto same = std::find_if(kept.begin(), kept.end(), [&](const Control* other) {
                return std::abs(std::abs(dot(control->direction, other->direction)) - 1) < parallel;
            });
            if (same == kept.end()) {
                kept.push_back(control);
                continue;
            }
            const double along = dot(control->direction, (*same)->direction);
            if (control->of_box)
                (*same)->velocity += along * control->velocity;
            else if (!(*same)->of_box)
                (*same)->velocity = along * control->velocity;
            control->slot = dropped;
        }
        // Gram and Schmidt: n₃ ∝ n₂ − Σ (n₂·e) e with velocity v₂ − Σ (n₂·e) v_e, e the directions before it. For two
        // conditions this is the p₃ of the notes.
        std::vector<const Control*> before;
        for (Control* control : kept) {
            Pack direction = control->direction;
            double velocity = control->velocity;
            for (const Control* other : before) {
                const double along = dot(control->direction, other->direction);
                direction -= along * other->direction;
                velocity -= along * other->velocity;
            }
            const double length = std::sqrt(dot(direction, direction));
            if (length < parallel) {
                control->slot = dropped;
                continue;
            }
            control->direction = direction / length;
            control->velocity = velocity / length;
            before.push_back(control);
        }
    }
    std::erase_if(controls, [](const Control& control) { return control.slot == dropped; });
}

} // namespace abut
