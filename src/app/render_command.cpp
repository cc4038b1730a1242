#include "app/commands.h"
#include "io/results/bar.h"
#include "io/scene/read_scene.h"
#include "io/scene/units.h"
#include "io/study/specification_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <thread>

namespace abut {

namespace {

/// "0.2mm,0,1.5e-3,2 mm"
std::vector<double> parse_region(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(',', from), text.size());
        std::string word = text.substr(from, to - from);
        word.erase(0, word.find_first_not_of(' '));
        double value = 0;
        const char* const end = word.data() + word.size();
        try {
            if (word.empty()) throw std::invalid_argument("a length is missing");
            if (std::from_chars(word.data(), end, value).ptr != end) // else a plain number, in m
                value = parse_quantity(word, dimensions::length);
        } catch (const std::exception& error) {
            throw UsageError(fmt::format("--region {}: {}", text, error.what()));
        }
        numbers.push_back(value);
        from = to + 1;
    }
    return numbers;
}

} // namespace

int render_command(const RenderRequest& request) {
    RenderOptions options = request.options;
    if (!request.region.empty()) options.region = parse_region(request.region);
    if (options.jobs < 1) options.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::filesystem::path> files;
    try {
        std::optional<CountBar> bar;
        if (!request.quiet) bar.emplace("pictures");
        options.progress = [&](int done, int total) {
            if (bar) bar->update(done, total);
        };
        options.note = [](const std::string& note) { fmt::print(stderr, "abut: {}\n", note); };
        files = render_series(request.results, options);
    } catch (const RenderRequestError& error) {
        throw UsageError(error.what());
    }
    if (request.quiet || files.empty()) return 0;
    const bool animated = !options.animation.empty();
    const std::size_t pictures = files.size() - (animated ? 1 : 0);
    if (pictures == 1)
        fmt::print("1 picture: {}", files.front().string());
    else
        fmt::print("{} pictures; the last: {}", pictures, files[pictures - 1].string());
    fmt::print("{}\n", animated ? "; and " + options.animation.string() : "");
    return 0;
}

int schema_command() {
    fmt::print("{}", scene_schema());
    return 0;
}

int reference_command(bool study) {
    fmt::print("{}", study ? study_reference() : scene_reference());
    return 0;
}

} // namespace abut
