#include "expression/expression.h"
#include "io/study/measures.h"
#include "io/study/particle_frames.h"
#include "io/study/reduce.h"

#include "scene/suggest.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace abut {

namespace {

std::vector<std::string> names_of(const std::vector<ParticleVariable>& variables) {
    std::vector<std::string> names;
    for (const ParticleVariable& variable : variables) names.push_back(variable.name);
    return names;
}

/// A frame by the names of its numbers, each taken out of its array once.
class Numbers {
public:
    explicit Numbers(const PointFrame& frame) : frame_(frame) {}

    const std::vector<double>& of(const ParticleVariable& variable) {
        const auto [place, added] = columns_.try_emplace(variable.name);
        if (added) place->second = column(variable);
        return place->second;
    }

private:
    std::vector<double> column(const ParticleVariable& variable) const {
        if (!variable.array.empty()) return component_of(array_of(frame_, variable.array), variable.component);
        const std::size_t count = frame_.points.size() / 3;
        if (variable.name == "t") return std::vector<double>(count, frame_.time);
        std::vector<double> position;
        for (std::size_t p = 0; p < count; ++p)
            position.push_back(frame_.points[3 * p + static_cast<std::size_t>(variable.component)]);
        if (variable.name[0] >= 'x') return position;
        const std::vector<double> moved = component_of(array_of(frame_, "displacement"), variable.component);
        for (std::size_t p = 0; p < count; ++p) position[p] -= moved[p];
        return position;
    }

    const PointFrame& frame_;
    std::map<std::string, std::vector<double>> columns_;
};

/// An expression at the chosen particles.
std::vector<double> at_particles(const std::string& text, const std::vector<ParticleVariable>& variables,
                                 const std::vector<Constant>& parameters, const std::vector<std::size_t>& chosen,
                                 Numbers& numbers) {
    const Expression expression(text, names_of(variables), parameters);
    std::vector<std::pair<std::size_t, const std::vector<double>*>> used;
    for (const std::size_t i : expression.used()) used.emplace_back(i, &numbers.of(variables[i]));
    std::vector<double> values(variables.size(), 0.0), result;
    for (const std::size_t p : chosen) {
        for (const auto& [i, column] : used) values[i] = (*column)[p];
        result.push_back(expression(values));
    }
    return result;
}

/// The arrays that some expressions use.
std::vector<std::string> arrays_of(const Metric& metric, const std::vector<ParticleVariable>& variables,
                                   const std::vector<Constant>& parameters) {
    std::vector<std::string> arrays{"displacement", "body", "mass", "volume"};
    for (const auto* texts : {&metric.value, &metric.exact})
        for (const std::string& text : *texts) {
            const Expression expression(text, names_of(variables), parameters);
            for (const std::size_t i : expression.used())
                if (!variables[i].array.empty()) arrays.push_back(variables[i].array);
        }
    return arrays;
}

/// The measure of one frame, before it is divided by the metric's scale.
double measure_frame(const Metric& metric, const MeasuredRun& run, const std::vector<ParticleVariable>& variables,
                     const PointFrame& frame) {
    const std::vector<std::size_t> chosen = particles_of(frame, metric.bodies);
    if (chosen.empty()) throw NoValue("there are no particles");

    Numbers numbers(frame);
    const auto evaluate = [&](const std::string& text) {
        return at_particles(text, variables, run.variant.parameters, chosen, numbers);
    };
    std::vector<double> values(chosen.size()), targets(chosen.size());
    const bool plain = metric.exact.empty() && metric.value.size() == 1;
    if (plain) values = evaluate(metric.value.front());
    for (std::size_t c = 0; !plain && c < metric.value.size(); ++c) {
        const std::vector<double> component = evaluate(metric.value[c]);
        const std::vector<double> exact =
            metric.exact.empty() ? std::vector<double>(chosen.size()) : evaluate(metric.exact[c]);
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            values[i] += (component[i] - exact[i]) * (component[i] - exact[i]);
            targets[i] += exact[i] * exact[i];
        }
    }
    for (std::size_t i = 0; !plain && i < chosen.size(); ++i) {
        values[i] = std::sqrt(values[i]);
        targets[i] = std::sqrt(targets[i]);
    }
    std::vector<double> weights(chosen.size(), 1.0);
    if (metric.weight != Weight::none) {
        const std::vector<double> all =
            component_of(array_of(frame, metric.weight == Weight::mass ? "mass" : "volume"), 0);
        for (std::size_t i = 0; i < chosen.size(); ++i) weights[i] = all[chosen[i]];
    }
    const double value = reduce_weighted(metric.reduce, values, weights);
    if (!metric.relative) return value;
    const double whole = reduce_weighted(metric.reduce, targets, weights);
    if (!(whole > 0)) throw NoValue("what it should be is 0: there is no relative error");
    return value / whole;
}

} // namespace

double measure_particles(const Metric& metric, MeasuredRun& run) {
    const std::vector<ParticleVariable> variables =
        particle_variables(run.columns.temperature, run.columns.orientation);
    const double value =
        over_frames(run.folder, metric.frames, metric.at, arrays_of(metric, variables, run.variant.parameters),
                    [&](const PointFrame& frame) { return measure_frame(metric, run, variables, frame); });
    return value / scale_of(metric, run);
}

std::vector<Problem> check_particles(const Metric& metric, const std::vector<Constant>& parameters,
                                     const VariantColumns& columns) {
    std::vector<Problem> problems;
    const std::vector<std::string> names = names_of(particle_variables(columns.temperature, columns.orientation));
    const auto check = [&](const std::string& text, const std::string& where) {
        try {
            const Expression expression(text, names, parameters);
        } catch (const std::runtime_error& error) {
            problems.push_back({where, error.what()});
        }
    };
    for (const std::string& text : metric.value) check(text, metric.where + "/value");
    for (const std::string& text : metric.exact) check(text, metric.where + "/exact");
    return problems;
}

} // namespace abut
