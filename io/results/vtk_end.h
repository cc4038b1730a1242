#pragma once
/// \file vtk_end.h
/// The end of VTK's XML files, which tells whether they were written to it.

#include <filesystem>

namespace abut {

/// Whether the file ends with its root's end tag, but for white space: one that is cut off, or continues with anything
/// else, does not. VTK itself notices neither on writing nor on reading. False for a file that can't be opened.
bool has_vtk_end(const std::filesystem::path& path);

} // namespace abut
