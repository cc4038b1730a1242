#pragma once
/// \file read_study.h
/// Study files to studies. The format is in specification_study.cpp and, in words, in README.md.

#include "io/study/study.h"

#include <filesystem>

namespace abut {

/// Reads a study file and checks all that can be known without building a model: keys, units, axes and levels,
/// pointers, references, names of metrics. Throws SceneError with all of its problems, those of a base scene that can't
/// be read among them.
Study read_study(const std::filesystem::path& file);

} // namespace abut
