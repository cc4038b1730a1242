#include "expression/expression.h"
#include "io/study/measures.h"
#include "io/study/reduce.h"

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace abut {

namespace {

/// An expression at all rows of a run.
std::vector<double> at_rows(const std::string& text, MeasuredRun& run) {
    const std::vector<TableVariable> variables = table_variables(text, run.columns);
    const Expression expression(text, names_of(variables), run.variant.parameters);
    std::vector<std::pair<std::size_t, std::vector<double>>> used;
    for (const std::size_t i : expression.used()) used.emplace_back(i, run.tables.values(variables[i]));
    std::vector<double> row(variables.size(), 0.0), result;
    for (std::size_t r = 0; r < run.tables.times().size(); ++r) {
        for (const auto& [i, values] : used) row[i] = values[r];
        result.push_back(expression(row));
    }
    return result;
}

/// Rows of a run and of what it is compared with, at the same times; one list a component.
struct Compared {
    std::vector<double> times;
    std::vector<std::vector<double>> values, targets;
};

Compared compare(const Metric& metric, MeasuredRun& run, MeasuredRun* reference) {
    Compared compared{run.tables.times(), {}, {}};
    for (const std::string& text : metric.value) compared.values.push_back(at_rows(text, run));
    for (const std::string& text : metric.exact) compared.targets.push_back(at_rows(text, run));
    if (!reference) return compared;

    const std::vector<double>& reference_times = reference->tables.times();
    const double end = reference_times.back();
    std::size_t rows = 0; // that the reference reaches
    while (rows < compared.times.size() && (compared.times[rows] <= end || same_time(compared.times[rows], end)))
        ++rows;
    const double last = metric.at.value_or(metric.to.value_or(compared.times.back()));
    if (last > end && !same_time(last, end))
        throw NoValue(fmt::format("what it is compared with ends at {:g} s, before {:g} s", end, last));
    compared.times.resize(rows);
    for (std::vector<double>& values : compared.values) values.resize(rows);
    for (const std::string& text : metric.value) {
        const std::vector<double> values = at_rows(text, *reference);
        std::vector<double>& target = compared.targets.emplace_back();
        for (const double t : compared.times) target.push_back(interpolate(reference_times, values, t));
    }
    return compared;
}

/// Magnitude of a vector at all rows. \param minus subtracted, if it has components
std::vector<double> magnitudes(const std::vector<std::vector<double>>& values,
                               const std::vector<std::vector<double>>& minus) {
    std::vector<double> result;
    for (std::size_t r = 0; r < values.front().size(); ++r) {
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double difference = values[i][r] - (minus.empty() ? 0 : minus[i][r]);
            sum += difference * difference;
        }
        result.push_back(std::sqrt(sum));
    }
    return result;
}

} // namespace

double scale_of(const Metric& metric, MeasuredRun& run) {
    if (metric.scale.empty()) return 1;
    const double scale = std::abs(at_rows(metric.scale, run).front());
    if (!(scale > 0)) throw NoValue(fmt::format("its scale \"{}\" is {}", metric.scale, scale));
    return scale;
}

double measure_history(const Metric& metric, MeasuredRun& run, MeasuredRun* reference) {
    const Compared compared = compare(metric, run, reference);
    const bool plain = compared.targets.empty() && compared.values.size() == 1;
    const std::vector<double> rows = plain ? compared.values.front() : magnitudes(compared.values, compared.targets);
    const double value = reduce_in_time(metric, compared.times, rows);
    if (!metric.relative) return value / scale_of(metric, run);
    const double whole = std::abs(reduce_in_time(metric, compared.times, magnitudes(compared.targets, {})));
    if (!(whole > 0)) throw NoValue("what it should be is 0: there is no relative error");
    return value / whole;
}

std::vector<Problem> check_history(const Metric& metric, const std::vector<Constant>& parameters,
                                   const VariantColumns& columns) {
    std::vector<Problem> problems;
    const auto check = [&](const std::string& text, const std::string& where) {
        try {
            const Expression expression(text, names_of(table_variables(text, columns)), parameters);
        } catch (const std::runtime_error& error) {
            problems.push_back({where, error.what()});
        }
    };
    for (const std::string& text : metric.value) check(text, metric.where + "/value");
    for (const std::string& text : metric.exact) check(text, metric.where + "/exact");
    if (!metric.scale.empty()) check(metric.scale, metric.where + "/scale");
    return problems;
}

} // namespace abut
