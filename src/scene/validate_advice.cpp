#include "plan/time_step.h"
#include "scene/validate.h"
#include "scene/validate_parts.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

void advise_walls(const Scene& scene, Problems& advice) {
    const ShapeKind shape = scene.method.shape;
    const bool splines = shape == ShapeKind::b2spline || shape == ShapeKind::b2gimp || shape == ShapeKind::b2cpdi;
    for (std::size_t i = 0; i < scene.boundaries.size(); ++i) {
        const auto* wall = std::get_if<WallSpec>(&scene.boundaries[i].condition);
        if (!wall) continue;
        if (splines && wall->grip && !wall->velocity.is_zero() && wall->depth < 1.5)
            advice.push_back({"/boundaries/" + std::to_string(i) + "/wall/depth",
                              "quadratic splines reach farther than other shapes, and a wall of less than 1.5 cells "
                              "may lose the body that it moves; use depth 1.5 (FMPM paper, section 3.4)"});
    }
}

/// Springs that the time step can't carry (notes 5.3.2, item 5).
void advise_interface(const Scene& scene, const LawSpec& law, const std::string& pointer, Problems& advice) {
    const double stiffness = largest_stiffness(law);
    if (stiffness == 0) return;
    const double limit = interface_step_limit(scene, stiffness);
    const double step = initial_step(scene);
    if (step < limit) return;
    advice.push_back({pointer, "a stiffness of " + with_unit(stiffness, "Pa/m") + " needs a time step below " +
                                   with_unit(limit, "s") + ", and it is " + with_unit(step, "s") +
                                   ": the bodies will stick as if bonded (" +
                                   (law.contact_stiffness ? "hard contact" : "in compression and tension") +
                                   ") where these springs act; take smaller steps, larger cells, or less than " +
                                   with_unit(stiffness * limit * limit / (step * step), "Pa/m")});
}

void advise_contact(const Scene& scene, Problems& advice) {
    const ContactSpec& contact = *scene.contact;
    if (contact.normal == NormalMethod::own_gradient)
        advice.push_back({"/contact/normal",
                          "\"own-gradient\" corrects each body by its own normal, so that momentum is not conserved; "
                          "it is there to compare with"});
    if (contact.separation != SeparationMethod::critical_position &&
        contact.separation != SeparationMethod::fitted_position)
        return;
    const bool fitted = contact.separation == SeparationMethod::fitted_position;
    const int right = fitted ? (contact.fit == PositionFit::one_per_cell ? 1 : 2) : (contact.offset < 0.95 ? 2 : 1);
    const auto advise = [&](const std::string& pointer, int particles) {
        if (particles != right)
            advice.push_back({pointer, std::string("the separation's ") + (fitted ? "fit" : "offset") + " is for " +
                                           std::to_string(right) + (right == 1 ? " particle" : " particles") +
                                           " per cell along an axis, so that contact comes too early or too late; "
                                           "\"particle-edges\" goes with any"});
    };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        advise("/bodies/" + std::to_string(i) + "/particles_per_cell", scene.bodies[i].particles_per_cell);
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        advise("/images/" + std::to_string(i) + "/particles_per_cell", scene.images[i].particles_per_cell);
}

/// Bodies that spin from the beginning on: with dF = exp(∇v Δt), or with positions that go by other velocities than
/// those that deform, the radius grows by up to exp(½ θ²) in a step of angle θ (tests/stability/deformation.cpp).
void advise_spin(const Scene& scene, Problems& advice) {
    const MethodSpec& method = scene.method;
    const TransferSpec& transfer = method.transfer;
    const bool grid_positions = transfer.scheme == TransferScheme::flip
                                    ? transfer.position == PositionUpdate::end_velocity
                                    : position_update(transfer) == PositionUpdate::end_velocity;
    const bool linear = method.deformation_increment == DeformationIncrement::linear;
    if (linear && grid_positions) return;
    const double step = initial_step(scene);
    const auto advise = [&](const std::string& name, const InitialVelocity& velocity, const InitialState& state) {
        const auto& L = velocity.gradient;
        const Vector& w = state.angular_velocity;
        const double spin = std::hypot(w[0] + 0.5 * (L[2][1] - L[1][2]), w[1] + 0.5 * (L[0][2] - L[2][0]),
                                       w[2] + 0.5 * (L[1][0] - L[0][1])); // [rad/s]
        const double growth = std::expm1(0.5 * spin * step * spin * scene.time.end);
        if (growth < 0.01) return;
        std::ostringstream text;
        text.precision(2);
        text << "\"" << name << "\" spins by " << spin * step << " rad a step, "
             << spin * scene.time.end / (2 * std::numbers::pi) << " turns in all: its radius may ";
        if (growth < 1)
            text << "grow by up to " << 100 * growth << " %";
        else
            text << "more than double";
        text << "; use " << (linear ? "" : "\"deformation_increment\": \"linear\"")
             << (linear || grid_positions ? "" : " and ")
             << (grid_positions ? "" : "\"position\": \"end-velocity\" in /method/transfer") << ", or smaller steps";
        advice.push_back({"/method", text.str()});
    };
    for (const BodySpec& body : scene.bodies)
        if (!body.rigid) advise(body.name, body.velocity, body.state);
    for (const ImageSpec& image : scene.images)
        for (const auto& entry : image.legend)
            if (!entry.is_void && !entry.rigid) advise(entry.body, {}, entry.state);
}

} // namespace

Problems advice(const Scene& scene) {
    Problems advice;
    const MethodSpec& method = scene.method;
    if (method.shape == ShapeKind::linear && method.stress_update == StressUpdate::usl)
        advice.push_back({"/method/shape",
                          "linear shape functions with stress_update \"usl\" are unstable where particles "
                          "cross cells: nodes come to see next to no mass; use \"usf\", or \"ugimp\" "
                          "or \"cpdi\""});
    if (method.shape == ShapeKind::linear && method.transfer.scheme == TransferScheme::fmpm &&
        method.transfer.order > 1)
        advice.push_back({"/method/transfer/scheme",
                          "linear shape functions and \"fmpm\" don't go together: what the full mass matrix gives "
                          "nodes with next to no mass is mostly noise (the two-block impact loses ten times the energy "
                          "of other shapes); use \"b2spline\", which costs as little, or \"ugimp\""});
    advise_walls(scene, advice);
    advise_spin(scene, advice);
    if (scene.contact) {
        advise_contact(scene, advice);
        advise_interface(scene, scene.contact->law, "/contact/law", advice);
        for (std::size_t i = 0; i < scene.contact->laws.size(); ++i)
            advise_interface(scene, scene.contact->laws[i].law, "/contact/laws/" + std::to_string(i) + "/law", advice);
    }
    return advice;
}

} // namespace abut
