#include "scene/problem.h"

#include <utility>

namespace abut {

namespace {

std::string lines(const std::string& file, const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        if (!text.empty()) text += '\n';
        text += file + ": " + (problem.pointer.empty() ? "" : problem.pointer + ": ") + problem.message;
    }
    return text;
}

} // namespace

SceneError::SceneError(const std::string& file, std::vector<Problem> problems)
    : std::runtime_error(lines(file, problems)), problems_(std::move(problems)) {}

} // namespace abut
