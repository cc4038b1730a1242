#pragma once
#include <string>
#include <vector>

namespace abut {

/// What has changed between two resolved scenes (scene.json) that a resumed run may not change, one message each:
/// `/method/shape: was "cpdi", is "ugimp"`. The end time, the title and what is written when may change, but not
/// whether there is pairs.csv. Files may lie elsewhere: model_checksum() tells whether they give the same particles.
std::vector<std::string> forbidden_changes(const std::string& before, const std::string& now);

} // namespace abut
