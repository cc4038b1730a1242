#include "io/render/plot_columns.h"

#include <algorithm>
#include <initializer_list>

namespace abut {
namespace {

struct Rule {
    std::string_view begin, end; ///< of the column's name
    ColumnMeaning meaning;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> list{
        // names of boundaries and bodies may end in anything
        {"force_", "", {"force", "N"}},
        {"torque_", "", {"torque", "N m"}},
        {"mean_stress_", "", {"mean stress", "Pa"}},
        {"stress_", "", {"stress", "Pa"}},
        {"momentum_", "", {"momentum", "N s"}},
        {"", "_energy", {"energy", "J"}},
        {"", "work", {"work", "J"}},
        {"balance_error", "", {"energy", "J"}},
        {"angular_velocity_", "", {"angular velocity", "rad/s"}},
        {"mass", "", {"mass", "g", 1e3}},
        {"area", "", {"area", "m²"}},
        {"time", "", {"time", "s"}},
        {"dt", "", {"time step", "s"}},
    };
    return list;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace

ColumnMeaning meaning_of_column(std::string_view column) {
    if (is_one_of(column, {"x", "y", "z"})) return {"position", "m"};
    if (is_one_of(column, {"vx", "vy", "vz"})) return {"velocity", "m/s"};
    if (column == "force") return {"force", "N"};
    for (const Rule& rule : rules())
        if (column.starts_with(rule.begin) && column.ends_with(rule.end)) return rule.meaning;
    return {words_of(column), ""};
}

std::string words_of(std::string_view column) {
    if (column == "dt") return "time step";
    if (is_one_of(column, {"x", "y", "z"})) return "position " + std::string(column);
    if (is_one_of(column, {"vx", "vy", "vz"})) return "velocity " + std::string(column.substr(1));
    std::string words(column);
    // The name of a boundary or a body stays as it is.
    std::size_t until = words.size(), from = 0;
    for (const std::string_view kind : {"force_", "torque_"})
        if (column.starts_with(kind) && column.size() > kind.size() + 2) from = kind.size(), until = words.size() - 2;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == '_' && (from == 0 || i < from || i >= until)) words[i] = ' ';
    return words;
}

std::vector<double> values_of(const CsvColumn& column) {
    std::vector<double> values = column.numbers;
    const double factor = meaning_of_column(column.name).factor;
    if (factor != 1)
        for (double& value : values) value *= factor;
    return values;
}

PlotAxis axis_of_column(const std::string& column, bool logarithmic) {
    return {words_of(column), meaning_of_column(column).unit, logarithmic};
}

} // namespace abut
