// Tables of a run (history.csv, …), the one column of words included.
#include "io/results/read_csv.h"
#include "one_file.h"

#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::OneFile file(".csv");
    const auto& path = file.holds(data, size);
    try {
        const abut::CsvFile table = abut::read_csv(path, {"body"});
        for (const abut::CsvColumn& column : table.columns)
            if (column.numbers.size() + column.words.size() != table.rows) __builtin_trap();
    } catch (const std::runtime_error& error) {
        fuzz::require_helpful(error.what(), path);
    }
    return 0;
}
