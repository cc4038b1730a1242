#pragma once
/// \file plot_tables.h
/// The tables of a result folder, opened as asked for on the command line, and the curves of bodies and pairs. Requests
/// that can't be met throw RenderRequestError with the nearest name and all that there are.

#include "io/render/plot.h"
#include "io/render/plot_results.h"
#include "io/results/read_csv.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// Reads a table of the folder.
CsvFile open_table(const std::filesystem::path& results, const std::string& name,
                   const std::vector<std::string>& words);

/// The column of numbers of that name.
const CsvColumn& column_of(const CsvFile& table, const std::string& name);

/// Whether the table has no rows, as a run leaves it at its start; a note says so then.
bool is_empty(const CsvFile& table, std::vector<std::string>& notes);

/// One column with a curve for each body or pair.
struct CurveGroup {
    std::string column;
    std::vector<PlotCurve> curves;
};
using CurveGroups = std::vector<CurveGroup>;

/// The columns of bodies.csv for the bodies asked for; those of space only where they show anything. None of an empty
/// table.
CurveGroups body_curves(const std::filesystem::path& results, const PlotOptions& options,
                        std::vector<std::string>& notes);

/// The columns of pairs.csv, and "force", the magnitude of the force. Without a row a pair is not in contact: force and
/// area are zero then. Works are added up from the start.
/// None of an empty table.
CurveGroups pair_curves(const std::filesystem::path& results, const PlotOptions& options,
                        std::vector<std::string>& notes);

/// Keeps the `most` curves with the highest peaks, in their order; a note says if some were left out.
void keep_largest(std::vector<PlotCurve>& curves, std::size_t most, std::vector<std::string>& notes,
                  const std::string& file);

} // namespace abut
