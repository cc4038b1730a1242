#include "io/results/csv.h"
#include "io/results/output_file.h"
#include "io/study/read_study_parts.h"
#include "io/study/results.h"

#include <algorithm>
#include <limits>

namespace abut {

namespace {

const std::vector<std::string> first_columns{"variant", "status"};
const std::vector<std::string> last_columns{"solver_seconds",
                                            "solver_seconds_low",
                                            "solver_seconds_high",
                                            "solver_seconds_deviation",
                                            "solver_cpu_seconds",
                                            "wall_seconds",
                                            "repeats",
                                            "threads",
                                            "steps",
                                            "particles",
                                            "particle_updates",
                                            "particle_sweeps",
                                            "node_updates",
                                            "instructions",
                                            "peak_memory_bytes",
                                            "cause"};
constexpr const char* size_prefix = "size of ";

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> columns_of(const StudyResults& results) {
    std::vector<std::string> columns = first_columns;
    for (const AxisResult& axis : results.axes) {
        columns.push_back(axis.name);
        if (!axis.size.empty()) columns.push_back(size_prefix + axis.name);
    }
    for (const MetricResult& metric : results.metrics) columns.push_back(metric.name);
    columns.insert(columns.end(), last_columns.begin(), last_columns.end());
    return columns;
}

using Row = std::vector<CsvTable::Value>;

void add_costs(Row& row, const VariantResult& variant) {
    const Spread solver = variant.spread(&Cost::solver_seconds);
    const bool any = !variant.costs.empty();
    for (const double time :
         {solver.median, solver.low, solver.high, solver.deviation, variant.spread(&Cost::solver_cpu_seconds).median,
          variant.spread(&Cost::wall_seconds).median})
        row.emplace_back(any ? time : nothing);
    row.emplace_back(static_cast<std::int64_t>(variant.costs.size()));
    if (!any) {
        for (int i = 0; i < 8; ++i) row.emplace_back(nothing);
        return;
    }
    // These are the same in all repeats but for memory, of which the most counts.
    const Cost& cost = variant.costs.front();
    for (const std::int64_t count :
         {std::int64_t{cost.threads}, std::int64_t{cost.steps}, std::int64_t{cost.particles},
          std::int64_t{cost.particle_updates}, std::int64_t{cost.particle_sweeps}, std::int64_t{cost.node_updates}})
        row.emplace_back(count);
    std::vector<double> instructions;
    long long memory = 0;
    for (const Cost& one : variant.costs) {
        if (one.instructions) instructions.push_back(static_cast<double>(*one.instructions));
        memory = std::max(memory, one.peak_memory_bytes);
    }
    row.emplace_back(instructions.empty() ? nothing : spread_of(instructions).median);
    row.emplace_back(std::int64_t{memory});
}

} // namespace

bool is_study_column(const std::string& name) {
    const auto among = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    return among(first_columns) || among(last_columns) || name.starts_with(size_prefix);
}

void write_study_csv(const std::filesystem::path& file, const StudyResults& results) {
    replace_file(file, [&](const std::filesystem::path& temporary) {
        CsvTable table(temporary, columns_of(results));
        for (const VariantResult& variant : results.variants) {
            const std::string status = status_word(variant.status);
            Row row{std::string_view(variant.name), std::string_view(status)};
            for (std::size_t a = 0; a < results.axes.size(); ++a) {
                row.emplace_back(std::string_view(results.axes[a].levels[variant.levels[a]]));
                if (!results.axes[a].size.empty()) row.emplace_back(variant.sizes[a].value_or(nothing));
            }
            for (const auto& metric : variant.metrics) row.emplace_back(metric.value_or(nothing));
            add_costs(row, variant);
            row.emplace_back(std::string_view(variant.cause));
            table.row(row);
        }
        table.flush();
    });
}

} // namespace abut
