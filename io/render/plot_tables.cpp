#include "io/render/plot_tables.h"

#include "io/render/plot_columns.h"
#include "io/render/render_series.h"
#include "io/render/select.h"
#include "io/render/series_source.h"
#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace abut {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> names_of_numbers(const CsvFile& table) {
    std::vector<std::string> names;
    for (const CsvColumn& column : table.columns)
        if (column.words.empty() || !column.numbers.empty()) names.push_back(column.name);
    std::erase_if(names, [](const std::string& name) { return name.starts_with("body"); });
    return names;
}

/// The words without repetition, in their order.
std::vector<std::string> distinct(const std::vector<std::string>& words) {
    std::vector<std::string> result;
    for (const std::string& word : words)
        if (!has(result, word)) result.push_back(word);
    return result;
}

/// The rows of each word.
std::map<std::string, std::vector<std::size_t>> rows_by(const std::vector<std::string>& words) {
    std::map<std::string, std::vector<std::size_t>> rows;
    for (std::size_t i = 0; i < words.size(); ++i) rows[words[i]].push_back(i);
    return rows;
}

/// The bodies that were asked for, each once.
std::vector<std::string> chosen_bodies(const CsvFile& table, const std::vector<std::string>& wanted,
                                       const std::vector<std::string>& known) {
    const bool all = has(wanted, "all") && !has(known, "all");
    std::vector<std::string> names = wanted;
    if (all) std::erase(names, "all");
    const std::vector<std::string> bodies = bodies_named(names, known, table.path.string());
    return all ? known : bodies;
}

bool shows_anything(const CsvColumn& column) {
    return std::any_of(column.numbers.begin(), column.numbers.end(), [](double value) { return value != 0; });
}

} // namespace

bool is_empty(const CsvFile& table, std::vector<std::string>& notes) {
    if (table.rows == 0) notes.push_back(table.path.string() + ": the table has no rows yet");
    return table.rows == 0;
}

CsvFile open_table(const std::filesystem::path& results, const std::string& name,
                   const std::vector<std::string>& words) {
    const auto path = results / name;
    if (!std::filesystem::exists(path))
        throw RenderRequestError(
            fmt::format("{}: no {}{}", results.string(), name,
                        name == "pairs.csv" ? "; it is written for scenes with contact, unless output.pairs is false"
                                            : "; is it the result folder of a run?"));
    return read_csv(path, words);
}

const CsvColumn& column_of(const CsvFile& table, const std::string& name) {
    const std::vector<std::string> known = names_of_numbers(table);
    if (!has(known, name)) throw RenderRequestError(table.path.string() + ": " + no_such("column", name, known));
    return *table.find(name);
}

CurveGroups body_curves(const std::filesystem::path& results, const PlotOptions& options,
                        std::vector<std::string>& notes) {
    const CsvFile table = open_table(results, "bodies.csv", {"body"});
    const CsvColumn* const of_body = table.find("body");
    if (!of_body) throw std::runtime_error(table.path.string() + ": cannot read: no column \"body\"");
    const std::vector<std::string> all = distinct(of_body->words);
    if (is_empty(table, notes)) return {};
    const std::vector<std::string> bodies = chosen_bodies(table, options.bodies, all);

    std::vector<std::string> columns = options.columns;
    if (columns.empty())
        for (const std::string name :
             {"x", "y", "z", "vx", "vy", "vz", "kinetic_energy", "strain_energy", "angular_velocity_z"}) {
            const CsvColumn* const column = table.find(name);
            const bool of_space = name == "z" || name == "vz"; // zero in plane scenes
            if (column && (!of_space || shows_anything(*column))) columns.push_back(name);
        }
    const std::vector<double> across = values_of(column_of(table, options.against));
    const auto rows = rows_by(of_body->words);
    CurveGroups groups;
    for (const std::string& name : columns) {
        CurveGroup group{name, {}};
        const std::vector<double> values = values_of(column_of(table, name));
        for (const std::string& body : bodies) {
            const auto number = static_cast<int>(std::find(all.begin(), all.end(), body) - all.begin());
            PlotCurve curve{body, {}, {}, number};
            for (const std::size_t i : rows.at(body)) {
                curve.x.push_back(across[i]);
                curve.y.push_back(values[i]);
            }
            group.curves.push_back(std::move(curve));
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

namespace {

/// The magnitude of the force as a column of its own.
void add_force(CsvFile& table) {
    CsvColumn force{"force", {}, {}};
    const std::array<const CsvColumn*, 3> parts{table.find("force_x"), table.find("force_y"), table.find("force_z")};
    if (!parts[0] || !parts[1] || !parts[2] || table.find("force")) return;
    for (std::size_t i = 0; i < table.rows; ++i)
        force.numbers.push_back(std::hypot(parts[0]->numbers[i], parts[1]->numbers[i], parts[2]->numbers[i]));
    table.columns.push_back(std::move(force));
}

/// Steps of the run and what they are on the axis across.
std::map<double, double> axis_of_steps(const std::filesystem::path& results, const CsvFile& pairs,
                                       const std::string& against) {
    std::map<double, double> axis;
    const auto add = [&](const CsvFile& table) {
        const CsvColumn &steps = column_of(table, "step"), &across = column_of(table, against);
        for (std::size_t i = 0; i < table.rows; ++i) axis[steps.numbers[i]] = across.numbers[i];
    };
    add(pairs);
    if (std::filesystem::exists(results / "history.csv")) add(read_csv(results / "history.csv"));
    return axis;
}

} // namespace

CurveGroups pair_curves(const std::filesystem::path& results, const PlotOptions& options,
                        std::vector<std::string>& notes) {
    CsvFile table = open_table(results, "pairs.csv", {"body_a", "body_b"});
    const CsvColumn *const a = table.find("body_a"), *const b = table.find("body_b");
    if (!a || !b) throw std::runtime_error(table.path.string() + ": cannot read: no columns \"body_a\" and \"body_b\"");
    std::vector<std::string> both = a->words, of_row;
    both.insert(both.end(), b->words.begin(), b->words.end());
    if (is_empty(table, notes)) return {};
    const std::vector<std::string> bodies =
        options.bodies.empty() ? distinct(both) : chosen_bodies(table, options.bodies, distinct(both));
    std::vector<std::string> pairs;
    for (std::size_t i = 0; i < table.rows; ++i) {
        of_row.push_back(a->words[i] + " - " + b->words[i]);
        if ((has(bodies, a->words[i]) || has(bodies, b->words[i])) && !has(pairs, of_row.back()))
            pairs.push_back(of_row.back());
    }
    const auto rows = rows_by(of_row);
    if (options.against != "time" && options.against != "step")
        throw RenderRequestError("--pairs: --against takes time or step, not " + options.against);

    add_force(table);
    const std::map<double, double> axis = axis_of_steps(results, table, options.against);
    std::vector<std::string> columns = options.columns;
    if (columns.empty())
        for (const char* name : {"force", "area", "work", "friction_work", "interface_energy"})
            if (table.find(name)) columns.emplace_back(name);
    const std::vector<double>& steps = column_of(table, "step").numbers;
    CurveGroups groups;
    for (const std::string& name : columns) {
        CurveGroup group{name, {}};
        const std::vector<double> values = values_of(column_of(table, name));
        for (const std::string& pair : pairs) {
            std::map<double, double> by_step;
            for (const std::size_t i : rows.at(pair)) by_step[steps[i]] = values[i];
            PlotCurve curve{pair, {}, {}, -1};
            double sum = 0;
            for (const auto& [step, across] : axis) {
                const auto found = by_step.find(step);
                const double value = found == by_step.end() ? 0 : found->second;
                sum += value;
                curve.x.push_back(across);
                curve.y.push_back(name.ends_with("work") ? sum : value);
            }
            group.curves.push_back(std::move(curve));
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

void keep_largest(std::vector<PlotCurve>& curves, std::size_t most, std::vector<std::string>& notes,
                  const std::string& file) {
    if (curves.size() <= most) return;
    const auto peak = [&](std::size_t i) {
        double result = 0;
        for (const double value : curves[i].y)
            if (std::isfinite(value)) result = std::max(result, std::abs(value));
        return result;
    };
    std::vector<std::size_t> order(curves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return peak(i) > peak(k); });
    notes.push_back(fmt::format("{}: the {} of {} curves with the highest peaks", file, most, curves.size()));
    order.resize(most);
    std::sort(order.begin(), order.end());
    std::vector<PlotCurve> kept;
    for (const std::size_t i : order) kept.push_back(std::move(curves[i]));
    curves = std::move(kept);
}

} // namespace abut
