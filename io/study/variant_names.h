#pragma once
#include "io/study/study.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace abut {

/// What variants and their folders are called.
class VariantNames {
public:
    explicit VariantNames(const Study& study) : study_(study) {}

    /// The levels in words: "1 mm, FMPM(2), cpdi".
    std::string name(const std::vector<std::size_t>& levels) const;
    /// A file name like `name`, another one in each call: "1_mm-FMPM(2)-cpdi".
    std::string folder(const std::string& name);

private:
    const Study& study_;
    std::set<std::string> taken_;
};

} // namespace abut
