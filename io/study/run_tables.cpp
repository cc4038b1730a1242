#include "io/study/run_tables.h"

#include "expression/expression.h"
#include "results/history.h"
#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

namespace abut {

namespace {

using Table = TableVariable::Table;

const CsvColumn& column_of(const CsvFile& table, const std::string& name) {
    if (const CsvColumn* column = table.find(name)) return *column;
    throw std::runtime_error(fmt::format("{}: no column \"{}\"", table.path.string(), name));
}

/// The body whose name a text begins with, followed by a dot; the longest such name. Null if there is none.
const std::string* body_before_dot(const std::string& text, const std::vector<std::string>& bodies) {
    const std::string* found = nullptr;
    for (const std::string& body : bodies) {
        const std::string name = expression_name(body);
        if (text.starts_with(name + ".") && (!found || name.size() > found->size())) found = &body;
    }
    return found;
}

std::vector<std::string> all_names(const std::vector<std::string>& bodies) {
    std::vector<std::string> names;
    for (const std::string& body : bodies) names.push_back(expression_name(body));
    return names;
}

void require_column(const std::string& name, const std::string& column, const std::vector<std::string>& known,
                    const char* table) {
    if (std::find(known.begin(), known.end(), column) != known.end()) return;
    const std::string guess = did_you_mean(column, known);
    throw std::runtime_error(fmt::format("\"{}\": {} has no column \"{}\"{}", name, table, column,
                                         guess.empty() ? "; there are: " + quoted_list(known, "and") : guess));
}

/// A name with dots.
TableVariable dotted_variable(const std::string& name, const VariantColumns& columns) {
    TableVariable variable;
    variable.name = name;
    std::string text = name;
    if (!body_before_dot(text, columns.bodies) && text.starts_with("first_")) {
        variable.first = true;
        text = text.substr(6);
    }
    const std::string* a = body_before_dot(text, columns.bodies);
    if (!a) {
        const std::string written = text.substr(0, text.find('.'));
        throw std::runtime_error(
            fmt::format("\"{}\": no body \"{}\"{}", name, written, did_you_mean(written, all_names(columns.bodies))));
    }
    variable.body_a = *a;
    text = text.substr(expression_name(*a).size() + 1);
    if (const std::string* b = body_before_dot(text, columns.bodies)) {
        if (!columns.contact) throw std::runtime_error(fmt::format("\"{}\": the scene has no contact", name));
        variable.table = Table::pairs;
        variable.body_b = *b;
        variable.column = text.substr(expression_name(*b).size() + 1);
        require_column(name, variable.column, pair_columns(), "pairs.csv");
    } else {
        variable.table = Table::bodies;
        variable.column = text;
        require_column(name, variable.column, body_columns(), "bodies.csv");
    }
    return variable;
}

} // namespace

std::vector<TableVariable> table_variables(const std::string& expression, const VariantColumns& columns) {
    std::vector<TableVariable> variables;
    std::set<std::string> taken;
    const auto add = [&](TableVariable variable) {
        if (taken.insert(variable.name).second) variables.push_back(std::move(variable));
    };
    add({Table::history, "t", "time", {}, {}, false});
    for (const std::string& column : columns.history) {
        const std::string name = expression_name(column);
        add({Table::history, name, column, {}, {}, false});
        add({Table::history, "first_" + name, column, {}, {}, true});
    }
    static const std::regex dotted(R"([A-Za-z_][A-Za-z_0-9]*\.[A-Za-z_0-9.]*)");
    for (std::sregex_iterator match(expression.begin(), expression.end(), dotted), end; match != end; ++match)
        if (!taken.contains(match->str())) add(dotted_variable(match->str(), columns));
    return variables;
}

std::vector<std::string> names_of(const std::vector<TableVariable>& variables) {
    std::vector<std::string> names;
    for (const TableVariable& variable : variables) names.push_back(variable.name);
    return names;
}

const CsvFile& RunTables::history() {
    if (!history_) {
        history_ = read_csv(folder_ / "history.csv");
        if (history_->rows == 0) throw std::runtime_error(history_->path.string() + ": has no rows");
    }
    return *history_;
}

const CsvFile& RunTables::bodies() {
    if (!bodies_) bodies_ = read_csv(folder_ / "bodies.csv", {"body"});
    return *bodies_;
}

const std::vector<double>& RunTables::times() {
    return column_of(history(), "time").numbers;
}

std::vector<double> RunTables::values(const TableVariable& variable) {
    std::vector<double> values = variable.table == Table::history  ? column_of(history(), variable.column).numbers
                                 : variable.table == Table::bodies ? body_values(variable)
                                                                   : pair_values(variable);
    if (variable.first) std::fill(values.begin(), values.end(), double(values.front()));
    return values;
}

std::vector<double> RunTables::body_values(const TableVariable& variable) {
    const std::vector<std::string>& names = column_of(bodies(), "body").words;
    const std::vector<double>& numbers = column_of(bodies(), variable.column).numbers;
    std::vector<double> values;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == variable.body_a) values.push_back(numbers[i]);
    if (values.size() != history().rows)
        throw std::runtime_error(fmt::format("{}: {} rows of body \"{}\" for {} of history.csv", bodies().path.string(),
                                             values.size(), variable.body_a, history().rows));
    return values;
}

std::vector<double> RunTables::pair_values(const TableVariable& variable) {
    if (!pairs_) pairs_ = read_csv(folder_ / "pairs.csv", {"body_a", "body_b"});
    const std::vector<std::string>& a = column_of(*pairs_, "body_a").words;
    const std::vector<std::string>& b = column_of(*pairs_, "body_b").words;
    const std::vector<double>& steps = column_of(*pairs_, "step").numbers;
    const std::vector<double>& numbers = column_of(*pairs_, variable.column).numbers;
    std::map<double, double> by_step;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool as_written = a[i] == variable.body_a && b[i] == variable.body_b;
        const bool reversed = a[i] == variable.body_b && b[i] == variable.body_a;
        if (as_written || reversed)
            by_step[steps[i]] = reversed && variable.column.starts_with("force_") ? -numbers[i] : numbers[i];
    }
    std::vector<double> values;
    for (const double step : column_of(history(), "step").numbers) {
        const auto found = by_step.find(step);
        values.push_back(found == by_step.end() ? 0 : found->second);
    }
    return values;
}

} // namespace abut
