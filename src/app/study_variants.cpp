#include "app/study_variants.h"

#include "geometry/build_model.h"
#include "io/results/read_csv.h"
#include "plan/time_step.h"
#include "results/history.h"
#include "scene/problem.h"
#include "step/check_state.h"
#include "step/run_error.h"
#include "step/step.h"
#include "step/sweeps.h"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

template <int D>
VariantModel examine(const Scene& scene, const Model& model) {
    State<D> state = make_state<D>(scene, model);
    std::vector<Problem> problems = check_state(state);
    if (!problems.empty()) throw SceneError("", std::move(problems));
    VariantModel result;
    result.columns.history = history_columns(state);
    for (const ModelBody& body : state.bodies) result.columns.bodies.push_back(body.name);
    result.columns.contact = state.effects.contact;
    result.columns.dimension = D;
    result.columns.temperature = !state.temperature.empty();
    result.columns.orientation = !state.orientation.empty();
    result.particles = state.particles.size();
    try {
        result.steps = std::ceil(scene.time.end / next_step(state, scene.time.end));
    } catch (const RunError&) { // a fixed step above the stable one; the run will say so
        result.steps = 1;
    }
    result.work = static_cast<double>(result.particles) * result.steps * sweeps_of_step(state);
    return result;
}

} // namespace

VariantModel examine(const Variant& variant) {
    const Scene& scene = variant.scene.scene;
    try {
        const Model model = build_model(scene, "");
        return dimension(scene.analysis) == 3 ? examine<3>(scene, model) : examine<2>(scene, model);
    } catch (const SceneError&) {
        throw;
    } catch (const std::runtime_error& error) { // an image or a surface
        throw SceneError("", {{"", error.what()}});
    }
}

VariantModel examine_results(const Variant& variant, const std::filesystem::path& results) {
    VariantModel result;
    result.columns.history = read_csv(results / "history.csv").names();
    const CsvFile bodies = read_csv(results / "bodies.csv", {"body"});
    const std::vector<std::string>& names = bodies.find("body")->words;
    for (const std::string& name : names) {
        if (!result.columns.bodies.empty() && name == result.columns.bodies.front()) break; // the second row
        result.columns.bodies.push_back(name);
    }
    result.columns.contact = variant.scene.scene.contact.has_value();
    result.columns.dimension = dimension(variant.scene.scene.analysis);
    result.columns.temperature = true; // what is missing shows when it is looked for
    result.columns.orientation = true;
    return result;
}

} // namespace abut
