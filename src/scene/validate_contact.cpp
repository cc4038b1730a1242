#include "grid/effective_cell.h"
#include "scene/validate_parts.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

using Problems = std::vector<Problem>;

void check_law(const LawSpec& law, SeparationMethod separation, const std::string& pointer, Problems& problems) {
    const auto demand_not_negative = [&](double value, const char* key) {
        demand(value >= 0, pointer + "/" + key, "must not be negative", problems);
    };
    demand_not_negative(law.coefficient, "coefficient");
    demand_not_negative(law.static_coefficient.value_or(0), "static_coefficient");
    demand_not_negative(law.decay_velocity, "decay_velocity");
    demand_not_negative(law.viscosity, "viscosity");
    demand(!law.contact_stiffness || *law.contact_stiffness > 0, pointer + "/contact_stiffness",
           "must be greater than 0 Pa/m", problems);
    demand(!law.contact_stiffness || separation == SeparationMethod::particle_edges ||
               separation == SeparationMethod::fitted_position,
           pointer + "/contact_stiffness",
           "needs to know by how much bodies overlap: use the separation \"particle-edges\"", problems);
    demand(law.reach >= 0, pointer + "/reach", "must not be negative", problems);
    demand_not_negative(law.tension_stiffness,
                        law.type == LawType::linear_interface ? "normal_stiffness" : "tension_stiffness");
    demand_not_negative(law.compression_stiffness.value_or(0), "compression_stiffness");
    demand_not_negative(law.tangential_stiffness, "tangential_stiffness");
    if (law.type == LawType::friction && law.static_coefficient)
        demand(*law.static_coefficient >= law.coefficient, pointer + "/static_coefficient",
               "must not be less than the coefficient while sliding", problems);
    const bool bond = law.type == LawType::adhesion || law.type == LawType::cohesive_interface;
    if (bond) {
        demand(law.strength > 0, pointer + "/strength", "must be greater than 0 Pa", problems);
        demand(law.shear_strength > 0, pointer + "/shear_strength", "must be greater than 0 Pa", problems);
    }
    if (law.type == LawType::cohesive_interface) {
        demand(law.opening > 0, pointer + "/opening", "must be greater than 0 m", problems);
        demand(law.sliding > 0, pointer + "/sliding", "must be greater than 0 m", problems);
    }
}

void check_rigid(const RigidSpec& rigid, const Scene& scene, const std::string& pointer, Problems& problems) {
    demand(scene.contact.has_value(), pointer,
           "a rigid body acts on others by contact, and the scene has none; add \"contact\"", problems);
    const Vector& axis = rigid.axis;
    demand(std::hypot(axis[0], axis[1], axis[2]) > 0, pointer + "/axis", "must not be zero", problems);
    if (scene.analysis != Analysis::axisymmetric) return;
    demand(rigid.velocity[0].is_zero(), pointer + "/velocity/0",
           "a rigid ring can't move along x, the radius, in an axisymmetric scene", problems);
    demand(rigid.angular_velocity.is_zero(), pointer + "/angular_velocity",
           "a rigid ring can't turn in the plane of an axisymmetric scene", problems);
}

/// Contact nodes that the scene wants taken apart.
void check_clouds(const Scene& scene, Problems& problems) {
    if (!scene.output.contact_clouds) return;
    const ContactCloudsSpec& clouds = *scene.output.contact_clouds;
    const std::string pointer = "/output/contact_clouds";
    if (!scene.contact) {
        problems.push_back({pointer, "the scene has no \"contact\", so that there are no contact nodes"});
        return;
    }
    const auto is_perfect = [](const LawSpec& law) { return law.type == LawType::perfect; };
    const std::vector<PairLawSpec>& laws = scene.contact->laws;
    demand(!is_perfect(scene.contact->law) ||
               !std::all_of(laws.begin(), laws.end(), [&](const PairLawSpec& pair) { return is_perfect(pair.law); }),
           pointer, "all interfaces are perfect: no normals and separations are found", problems);
    demand(!clouds.nodes.empty() || !clouds.near.empty() || clouds.disagreement, pointer,
           R"(names no nodes; give "nodes", "near" or "disagreement")", problems);
    demand(scene.output.contact.write, pointer,
           R"(is written with the frames of contact pairs, and "contact" is false)", problems);
    const std::array<int, 3> last = cell_counts(scene.grid);
    const bool plane = axes(scene) == 2;
    for (std::size_t n = 0; n < clouds.nodes.size(); ++n) {
        const std::array<int, 3>& node = clouds.nodes[n];
        const std::string at = pointer + "/nodes/" + std::to_string(n);
        demand((node[2] < 0) == plane, at,
               plane ? "must have 2 numbers in a plane scene" : "must have 3 numbers in a 3d scene", problems);
        for (std::size_t axis = 0; axis < axes(scene); ++axis)
            demand(node[axis] <= last[axis], at + "/" + std::to_string(axis),
                   "outside the grid, whose nodes along " + std::string(axis_names[axis]) + " are 0 to " +
                       std::to_string(last[axis]),
                   problems);
    }
}

} // namespace

void validate_contact(const Scene& scene, Problems& problems) {
    std::size_t rigid = 0;
    std::size_t bodies = scene.bodies.size();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].rigid) continue;
        ++rigid;
        check_rigid(*scene.bodies[i].rigid, scene, "/bodies/" + std::to_string(i) + "/rigid", problems);
    }
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        for (std::size_t k = 0; k < scene.images[i].legend.size(); ++k) {
            const LegendEntry& entry = scene.images[i].legend[k];
            bodies += entry.is_void ? 0 : 1;
            if (!entry.rigid) continue;
            ++rigid;
            check_rigid(*entry.rigid, scene, "/images/" + std::to_string(i) + "/legend/" + std::to_string(k) + "/rigid",
                        problems);
        }
    demand(bodies == 0 || rigid < bodies, "/bodies", "all bodies are rigid; nothing is left to compute", problems);

    check_clouds(scene, problems);
    const OutputSpec& output = scene.output;
    demand(scene.contact || !output.live || (output.live_preset != "contact" && output.live_preset != "normals"),
           "/output/live_preset", "\"" + output.live_preset + "\" shows contact, of which this scene has none",
           problems);
    if (!scene.contact) return;
    const ContactSpec& contact = *scene.contact;
    demand(contact.corrections == 1 || contact.corrections == 2, "/contact/corrections", "must be 1 or 2", problems);
    const auto& [x, y, z] = contact.direction;
    demand(contact.normal != NormalMethod::specified || x * x + y * y + z * z > 0, "/contact/direction",
           "must not be zero: it is the direction of the contact normal", problems);
    demand(contact.fit == PositionFit::power_law || contact.exponent == ContactSpec{}.exponent, "/contact/exponent",
           R"(only goes with "fit": "power-law")", problems);
    check_law(contact.law, contact.separation, "/contact/law", problems);
    for (std::size_t i = 0; i < contact.laws.size(); ++i)
        check_law(contact.laws[i].law, contact.separation, "/contact/laws/" + std::to_string(i) + "/law", problems);
}

} // namespace abut
