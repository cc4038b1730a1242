#pragma once
/// \file run_tables.h
/// The tables of a run by names in expressions.

#include "io/results/read_csv.h"
#include "io/study/metrics.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// A name in an expression and where its numbers are.
struct TableVariable {
    enum class Table { history, bodies, pairs } table = Table::history;
    std::string name;           ///< in the expression
    std::string column;         ///< of the table
    std::string body_a, body_b; ///< of bodies.csv: body_a; of pairs.csv: force on body_a
    bool first = false;         ///< the column's first value, at all rows
};

/// The names that an expression may use, with all columns of history.csv:
/// `COLUMN` and `t` of history.csv, `BODY.COLUMN` of bodies.csv, `BODY.OTHER.COLUMN` of pairs.csv (for the force on the
/// first one), and each with `first_` before it for its first value. What names can't have is "_" (expression_name()).
/// Throws std::runtime_error for a name with a dot that is none of these.
std::vector<TableVariable> table_variables(const std::string& expression, const VariantColumns& columns);

/// Their names, in the same order.
std::vector<std::string> names_of(const std::vector<TableVariable>& variables);

/// The tables of one run, each read when it is first asked for.
class RunTables {
public:
    explicit RunTables(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Times of the rows of history.csv [s].
    const std::vector<double>& times();
    /// The values of a variable, one a row of history.csv. Pairs are 0 where they have no row: they are not in contact.
    /// Throws std::runtime_error that names the file if there is no such column or the file is broken.
    std::vector<double> values(const TableVariable& variable);
    const CsvFile& history();
    const CsvFile& bodies();

private:
    std::vector<double> body_values(const TableVariable& variable);
    std::vector<double> pair_values(const TableVariable& variable);

    std::filesystem::path folder_;
    std::optional<CsvFile> history_, bodies_, pairs_;
};

} // namespace abut
