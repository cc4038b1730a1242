#include "app/commands.h"

#include <fmt/format.h>

namespace abut {

int plot_command(const std::filesystem::path& results, const PlotOptions& options) {
    PlotOutcome outcome;
    try {
        outcome = plot_results(results, options);
    } catch (const RenderRequestError& error) {
        throw UsageError(error.what());
    }
    for (const auto& file : outcome.files) fmt::print("{}\n", file.string());
    for (const std::string& note : outcome.notes) fmt::print("{}\n", note);
    return 0;
}

} // namespace abut
