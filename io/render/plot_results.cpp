#include "io/render/plot_results.h"

#include "io/render/offscreen_context.h"
#include "io/render/plot_columns.h"
#include "io/render/plot_tables.h"
#include "io/render/render_series.h"
#include "io/render/series_source.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>

namespace abut {
namespace {

namespace fs = std::filesystem;

bool shows_anything(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
}

/// The largest finite magnitude; 0 without one.
double largest(const std::vector<double>& values) {
    double result = 0;
    for (const double value : values)
        if (std::isfinite(value)) result = std::max(result, std::abs(value));
    return result;
}

std::string file_name(std::string name) {
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-' && c != '.') c = '_';
    return name + ".png";
}

std::string file_name_of(const std::vector<std::string>& columns) {
    std::string name = columns.front();
    for (std::size_t i = 1; i < columns.size(); ++i) name += "-" + columns[i];
    if (name.size() > 60) name = fmt::format("{}-and-{}-more", columns.front().substr(0, 40), columns.size() - 1);
    return file_name(name);
}

/// The pictures of one call.
class Figures {
public:
    Figures(const fs::path& results, const PlotOptions& options)
        : options_(options), folder_(options.output.empty() ? results / "plots" : options.output),
          title_(options.title.empty() ? SeriesSource{results, {}, {}}.title() : options.title) {}

    void draw(const std::string& file, PlotAxis x, PlotAxis y, std::vector<PlotCurve> curves) {
        x.logarithmic = options_.log_x;
        y.logarithmic = options_.log_y;
        if (!context_) {
            std::error_code error;
            fs::create_directories(folder_, error);
            if (error) throw std::runtime_error(fmt::format("{}: {}", folder_.string(), error.message()));
            context_.emplace();
        }
        if (curves.size() == 1) y.quantity = curves.front().name;
        write_plot(*context_, {title_, x, y, std::move(curves), options_.width, options_.height}, folder_ / file);
        outcome.files.push_back(folder_ / file);
    }

    PlotOutcome outcome;

private:
    const PlotOptions& options_;
    fs::path folder_;
    std::string title_;
    std::optional<OffscreenContext> context_;
};

// === history.csv

/// Energy that no work accounts for: total - first total - external work - contact work [J].
std::vector<double> balance_error(const CsvFile& history) {
    const CsvColumn* const total = history.find("total_energy");
    const CsvColumn* const external = history.find("external_work");
    const CsvColumn* const contact = history.find("contact_work");
    if (!total || !external || !contact || history.rows == 0) return {};
    std::vector<double> error(history.rows);
    for (std::size_t i = 0; i < error.size(); ++i)
        error[i] = total->numbers[i] - total->numbers[0] - external->numbers[i] - contact->numbers[i];
    return error;
}

void draw_energies(Figures& figures, const CsvFile& history, const CsvColumn& across) {
    std::vector<PlotCurve> curves;
    const auto add = [&](const std::string& name, const std::vector<double>& values) {
        if (shows_anything(values)) curves.push_back({name, values_of(across), values, -1});
    };
    for (const char* name : {"total_energy", "kinetic_energy", "strain_energy", "external_work", "contact_work",
                             "friction_work", "interface_energy"})
        if (const CsvColumn* column = history.find(name)) add(words_of(name), column->numbers);
    const std::vector<double> error = balance_error(history);
    add("balance error", error);
    const CsvColumn* const total = history.find("total_energy");
    if (curves.empty()) {
        figures.outcome.notes.emplace_back("no energies.png: all energies are zero");
        return;
    }
    figures.draw("energies.png", axis_of_column(across.name, false), {"energy", "J", false}, std::move(curves));
    const double most = total ? largest(total->numbers) : 0;
    if (most > 0 && !error.empty())
        figures.outcome.notes.push_back(
            fmt::format("balance error (total energy less its first value and all work): at most {:.3g} J, {:.2g} % of "
                        "the largest total energy",
                        largest(error), 100 * largest(error) / most));
}

/// Columns that begin so and are not all zero, as one picture; a note if there is none.
void draw_beginning(Figures& figures, const CsvFile& history, const CsvColumn& across, const std::string& file,
                    const std::string& begin, bool with_zeros) {
    std::vector<PlotCurve> curves;
    for (const CsvColumn& column : history.columns)
        if (column.name.starts_with(begin) && (with_zeros || shows_anything(column.numbers))) {
            const std::string words = words_of(column.name);
            curves.push_back({words, values_of(across), values_of(column), -1});
        }
    const ColumnMeaning meaning = meaning_of_column(begin + "x");
    if (curves.empty()) {
        figures.outcome.notes.push_back(
            fmt::format("no {}: the table has no {} other than zero", file, meaning.quantity));
        return;
    }
    keep_largest(curves, 24, figures.outcome.notes, file);
    figures.draw(file, axis_of_column(across.name, false), {meaning.quantity, meaning.unit, false}, std::move(curves));
}

/// One picture for each unit that the columns have.
void draw_columns(Figures& figures, const CsvFile& table, const CsvColumn& across,
                  const std::vector<std::string>& columns) {
    std::vector<std::string> units;
    for (const std::string& name : columns) {
        const std::string unit = meaning_of_column(name).unit;
        if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
    }
    for (const std::string& unit : units) {
        std::vector<PlotCurve> curves;
        std::vector<std::string> names;
        std::string quantity;
        for (const std::string& name : columns) {
            const ColumnMeaning meaning = meaning_of_column(name);
            if (meaning.unit != unit) continue;
            curves.push_back({words_of(name), values_of(across), values_of(*table.find(name)), -1});
            names.push_back(name);
            if (quantity.find(meaning.quantity) == std::string::npos)
                quantity += (quantity.empty() ? "" : ", ") + meaning.quantity;
        }
        figures.draw(file_name_of(names), axis_of_column(across.name, false), {quantity, unit, false},
                     std::move(curves));
    }
}

void draw_history(Figures& figures, const fs::path& results, const PlotOptions& options) {
    const CsvFile history = open_table(results, "history.csv", {});
    const CsvColumn& across = column_of(history, options.against);
    for (const std::string& name : options.columns) column_of(history, name);
    if (is_empty(history, figures.outcome.notes)) return;
    if (!options.columns.empty()) return draw_columns(figures, history, across, options.columns);
    draw_energies(figures, history, across);
    draw_beginning(figures, history, across, "stresses.png", "mean_stress_", true);
    draw_beginning(figures, history, across, "forces.png", "force_", false);
    draw_beginning(figures, history, across, "momentum.png", "momentum_", false);
}

// === bodies.csv and pairs.csv: a picture for each column, a curve for each body or pair

void draw_groups(Figures& figures, const CurveGroups& groups, const std::string& prefix, const std::string& against,
                 std::size_t most, bool chosen) {
    for (const CurveGroup& group : groups) {
        std::vector<PlotCurve> curves = group.curves;
        const std::string file = file_name(prefix + group.column);
        const bool zero =
            std::none_of(curves.begin(), curves.end(), [](const auto& curve) { return shows_anything(curve.y); });
        if (zero && !chosen) {
            figures.outcome.notes.push_back(fmt::format("no {}: all values are zero", file));
            continue;
        }
        keep_largest(curves, most, figures.outcome.notes, file);
        const std::string name = curves.size() == 1 ? words_of(group.column) + ", " + curves.front().name : "";
        if (curves.size() == 1) curves.front().name = name;
        figures.draw(file, axis_of_column(against, false), axis_of_column(group.column, false), std::move(curves));
    }
}

} // namespace

PlotOutcome plot_results(const fs::path& result_dir, const PlotOptions& options) {
    if (!fs::is_directory(result_dir)) throw RenderRequestError(result_dir.string() + ": no such folder");
    Figures figures(result_dir, options);
    const bool chosen = !options.columns.empty();
    if (options.pairs)
        draw_groups(figures, pair_curves(result_dir, options, figures.outcome.notes), "pairs-", options.against, 12,
                    chosen);
    else if (!options.bodies.empty())
        draw_groups(figures, body_curves(result_dir, options, figures.outcome.notes), "bodies-", options.against, 24,
                    chosen);
    else
        draw_history(figures, result_dir, options);
    return figures.outcome;
}

} // namespace abut
