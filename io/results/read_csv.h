#pragma once
/// \file read_csv.h
/// Reads the tables of a run back: history.csv, bodies.csv, pairs.csv.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace abut {

/// A column of a table: numbers, or words if it was asked for so.
struct CsvColumn {
    std::string name;
    std::vector<double> numbers;
    std::vector<std::string> words;
};

/// A table by columns, all of the same length.
struct CsvFile {
    std::filesystem::path path;
    std::vector<CsvColumn> columns;
    std::size_t rows = 0;

    /// The column of that name; nullptr if there is none.
    const CsvColumn* find(std::string_view name) const;
    std::vector<std::string> names() const;
};

/// Reads a CSV file (RFC 4180; its first row names the columns) as CsvTable writes it: numbers come back with the same
/// bits, not-a-number and infinities included. A last row without its end of line is left out: the run that writes it
/// isn't done with it. Throws std::runtime_error "FILE: line N: CAUSE" for a row of another length, a cell that is no
/// number, a column that is there twice, and "FILE: CAUSE" for a file that is missing, or has no whole header yet.
/// \param words names of the columns that hold words
CsvFile read_csv(const std::filesystem::path& path, const std::vector<std::string>& words = {});

} // namespace abut
