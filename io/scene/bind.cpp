#include "io/scene/bind.h"

#include "io/scene/bind_parts.h"
#include "io/scene/elastic_constants.h"
#include "io/scene/words.h"
#include "scene/suggest.h"

#include <algorithm>

namespace abut {

namespace {

MaterialSpec bind_material(const std::string& name, const Json& json, std::vector<Problem>& problems) {
    MaterialSpec material;
    material.name = name;
    copy_word(json, "model", model_words, material.model);
    copy(json, "density", material.density);
    ElasticConstants constants;
    copy(json, "bulk_modulus", constants.bulk_modulus);
    copy(json, "shear_modulus", constants.shear_modulus);
    copy(json, "youngs_modulus", constants.youngs_modulus);
    copy(json, "poissons_ratio", constants.poissons_ratio);
    copy(json, "lame_lambda", constants.lame_lambda);
    try {
        const Moduli moduli = bulk_and_shear(constants);
        material.bulk_modulus = moduli.bulk;
        material.shear_modulus = moduli.shear;
    } catch (const std::invalid_argument& error) {
        problems.push_back({"/materials/" + pointer_token(name), error.what()});
    }
    return material;
}

BodySpec bind_body(const Json& json) {
    BodySpec body;
    copy(json, "name", body.name);
    copy(json, "material", body.material);
    if (const Json* rigid = find(json, "rigid")) body.rigid = bind_rigid(*rigid);
    body.shape = bind_shape(json);
    copy_components(json, "velocity", body.velocity.value);
    const Json& rows = part(json, "velocity_gradient");
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t i = 0; i < rows[row].size(); ++i) body.velocity.gradient[row][i] = rows[row][i].get<double>();
    copy_components(json, "velocity_center", body.velocity.center);
    copy(json, "particles_per_cell", body.particles_per_cell);
    copy_word(json, "fill", fill_words, body.fill);
    copy_word(json, "arrangement", arrangement_words, body.arrangement);
    body.state = bind_initial_state(json);
    return body;
}

LawSpec bind_law(const Json& json) {
    LawSpec law;
    copy_word(json, "type", law_words, law.type);
    copy(json, "coefficient", law.coefficient);
    copy(json, "static_coefficient", law.static_coefficient);
    copy(json, "decay_velocity", law.decay_velocity);
    copy(json, "viscosity", law.viscosity);
    copy(json, "contact_stiffness", law.contact_stiffness);
    copy(json, "strength", law.strength);
    copy(json, "shear_strength", law.shear_strength);
    copy(json, "reach", law.reach);
    copy(json, "normal_stiffness", law.tension_stiffness);
    copy(json, "tension_stiffness", law.tension_stiffness);
    copy(json, "compression_stiffness", law.compression_stiffness);
    copy(json, "tangential_stiffness", law.tangential_stiffness);
    copy(json, "opening", law.opening);
    copy(json, "sliding", law.sliding);
    return law;
}

PairLawSpec bind_pair_law(const Json& json) {
    PairLawSpec pair;
    const Json& bodies = part(json, "bodies");
    for (std::size_t i = 0; i < std::min(bodies.size(), pair.bodies.size()); ++i)
        pair.bodies[i] = bodies[i].get<std::string>();
    pair.law = bind_law(part(json, "law"));
    return pair;
}

ContactSpec bind_contact(const Json& json) {
    ContactSpec contact;
    copy_word(json, "normal", normal_words, contact.normal);
    copy_word(json, "separation", separation_words, contact.separation);
    copy_components(json, "direction", contact.direction);
    copy(json, "offset", contact.offset);
    copy_word(json, "fit", fit_words, contact.fit);
    copy(json, "exponent", contact.exponent);
    copy(json, "corrections", contact.corrections);
    copy_word(json, "three_or_more", three_or_more_words, contact.three_or_more);
    copy(json, "overlap_correction", contact.overlap_correction);
    copy(json, "screening", contact.screening);
    copy(json, "rigid_bias", contact.rigid_bias);
    contact.law = bind_law(part(json, "law"));
    copy_list(json, "laws", contact.laws, bind_pair_law);
    return contact;
}

MethodSpec bind_method(const Json& json) {
    MethodSpec method;
    copy_word(json, "shape", shape_words, method.shape);
    const Json& transfer = part(json, "transfer");
    copy_word(transfer, "scheme", scheme_words, method.transfer.scheme);
    copy(transfer, "order", method.transfer.order);
    copy_word(transfer, "position", position_words, method.transfer.position);
    copy(transfer, "every_cfl", method.transfer.every_cfl);
    copy_word(json, "stress_update", stress_update_words, method.stress_update);
    copy_word(json, "deformation_increment", deformation_increment_words, method.deformation_increment);
    copy_word(json, "velocity_conditions", velocity_conditions_words, method.velocity_conditions);
    return method;
}

} // namespace

Scene bind_scene(const Json& checked, std::vector<Problem>& problems) {
    Scene scene;
    copy(checked, "title", scene.title);
    copy_word(checked, "analysis", analysis_words, scene.analysis);
    copy(checked, "thickness", scene.thickness);
    const Json& grid = part(checked, "grid");
    copy_per_axis(grid, "cell", scene.grid.cell, std::size_t(dimension(scene.analysis)));
    copy_components(grid, "lower", scene.grid.lower);
    copy_components(grid, "upper", scene.grid.upper);
    const Json& time = part(checked, "time");
    copy(time, "end", scene.time.end);
    copy(time, "cfl", scene.time.cfl);
    copy(time, "step", scene.time.step);
    copy_word(time, "on_trouble", on_trouble_words, scene.time.on_trouble);
    const Json& limits = part(time, "limits");
    copy(limits, "speed", scene.time.limits.speed);
    copy(limits, "energy_growth", scene.time.limits.energy_growth);
    scene.method = bind_method(part(checked, "method"));
    for (const auto& [name, material] : part(checked, "materials").items())
        scene.materials.push_back(bind_material(name, material, problems));
    for (const auto& [name, shape] : part(checked, "shapes").items()) scene.shapes.push_back({name, bind_shape(shape)});
    copy_list(checked, "bodies", scene.bodies, bind_body);
    copy_word(checked, "overlap", overlap_words, scene.overlap);
    copy_list(checked, "images", scene.images, bind_image);
    if (const Json* contact = find(checked, "contact")) scene.contact = bind_contact(*contact);
    copy_list(checked, "boundaries", scene.boundaries, bind_boundary);
    copy_components(checked, "gravity", scene.gravity);
    scene.output = bind_output(part(checked, "output"));
    return scene;
}

} // namespace abut
