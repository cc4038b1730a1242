#pragma once
/// \file plot_columns.h
/// Columns of the tables as curves.

#include "io/render/plot.h"
#include "io/results/read_csv.h"

#include <string>
#include <string_view>
#include <vector>

namespace abut {

/// What a column of history.csv, bodies.csv or pairs.csv is: "kinetic_energy" is "energy" in "J". Masses are in grams
/// and momenta in newton-seconds, which take prefixes; `factor` brings the column there.
struct ColumnMeaning {
    std::string quantity;
    std::string unit;
    double factor = 1;
};

ColumnMeaning meaning_of_column(std::string_view column);

/// A column's name as words: "kinetic_energy" is "kinetic energy", "vx" "velocity x".
std::string words_of(std::string_view column);

/// The column's values in the unit of its meaning.
std::vector<double> values_of(const CsvColumn& column);

/// An axis for a column; its quantity is the column's name in words.
PlotAxis axis_of_column(const std::string& column, bool logarithmic);

} // namespace abut
