#pragma once
/// \file run_record.h
/// What is kept of a variant's runs between two calls of abut study: DIR/records/VARIANT.json.

#include "io/study/results.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abut {

struct RunRecord {
    std::string key; ///< Variant::key of the runs
    Status status = Status::missing;
    std::string cause;
    std::vector<Cost> costs; ///< one a repeat that is done
    std::string history;     ///< checksum of history.csv
    bool repeats_agree = true;

    /// Whether nothing is left to run. A failure may have been the machine's: such a variant is run again.
    bool complete(int repeats) const {
        return status == Status::unstable ||
               (status == Status::done && costs.size() >= static_cast<std::size_t>(repeats));
    }
};

void write_record(const std::filesystem::path& file, const RunRecord& record);
/// Nothing if there is no such file, or none that can be read.
std::optional<RunRecord> read_record(const std::filesystem::path& file);

} // namespace abut
