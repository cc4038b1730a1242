#pragma once
#include "io/scene/specification.h"

#include <string>

namespace abut {

/// A table of keys as Markdown: a section for each object. \param heading of the document itself
std::string key_tables(const SpecificationNode& specification, const std::string& heading);

} // namespace abut
