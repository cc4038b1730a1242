#pragma once
/// \file csv.h
/// Tables that grow row by row: history.csv, bodies.csv.

#include "io/results/output_file.h"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace abut {

/// A text as a cell of a table, quoted only where RFC 4180 asks for it.
std::string csv_cell(std::string_view text);

/// A CSV file under way. Reals are written in the shortest form that reads back to the same bits. Rows are buffered and
/// reach the file in whole rows, by `flush` or when the buffer is full; so a killed run leaves whole rows.
/// Every failure (disk full, no such folder) throws std::runtime_error naming the file and the cause.
class CsvTable {
public:
    using Value = std::variant<double, std::int64_t, std::string_view>;

    /// Creates or replaces the file and writes the header.
    CsvTable(const std::filesystem::path& path, const std::vector<std::string>& columns);
    /// Goes on with a file that is there after its first `bytes`; what follows is cut off. See check_continued().
    CsvTable(const std::filesystem::path& path, const std::vector<std::string>& columns, std::uintmax_t bytes);
    CsvTable(CsvTable&&) noexcept = default;
    CsvTable& operator=(CsvTable&&) noexcept = default;
    ~CsvTable(); ///< flushes; a failure is only noticed by calling flush() before

    /// Adds a row, one value a column; std::logic_error if their number differs.
    void row(std::span<const Value> values);
    void row(std::initializer_list<Value> values) { row(std::span(values.begin(), values.size())); }
    void row(std::span<const double> values);
    void flush();
    void sync();                                                     ///< waits until all rows are on the disk
    std::uintmax_t bytes() const { return bytes_ + buffer_.size(); } ///< of the file after a flush

private:
    void end_row(std::size_t values);

    OutputFile file_;
    std::size_t columns_;
    std::uintmax_t bytes_ = 0; ///< in the file
    std::string buffer_;
};

/// Whether a table can go on after its first `bytes`: it has the columns, and a row ends there. Changes nothing. Throws
/// std::runtime_error naming the file, what is wrong with it and what to do.
void check_continued(const std::filesystem::path& path, const std::vector<std::string>& columns, std::uintmax_t bytes);

} // namespace abut
