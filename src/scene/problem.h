#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace abut {

/// Something wrong with a scene: where (JSON pointer, e.g. "/bodies/2/material") and what, in words a user can act on.
struct Problem {
    std::string pointer;
    std::string message;
};

/// Thrown when a scene cannot be used; carries all of its problems. what(): one line per problem, "FILE: POINTER:
/// message".
class SceneError : public std::runtime_error {
public:
    SceneError(const std::string& file, std::vector<Problem> problems);
    const std::vector<Problem>& problems() const { return problems_; }

private:
    std::vector<Problem> problems_;
};

} // namespace abut
