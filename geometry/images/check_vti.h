#pragma once
/// \file check_vti.h
/// What VTK 9.1's reader of VTI files takes on trust, checked before it allocates: how many elements there are, that
/// the pieces fill the volume, and what the compressed blocks claim.

#include <array>
#include <filesystem>
#include <string>
#include <vtkXMLImageDataReader.h>

namespace abut::formats {

/// One array of the file.
struct VtiArray {
    std::string name;
    int components = 0;
    int type = 0; ///< of VTK
    bool on_cells = false;
    bool active = false; ///< the active scalars
};

/// Checks a file before it is parsed: a parsed element takes 800 times the memory of its tag.
/// \throws std::runtime_error for more elements than any picture has, declarations of entities, or a missing end
void check_vti_markup(const std::filesystem::path& file);

/// Checks what the parsed file says about \p array, and takes out of the parsed tree what is not needed for it.
/// \param reader after UpdateInformation(), and not modified before its next Update()
/// \param whole extent of all pieces together
/// \throws std::runtime_error when the pieces do not fill the volume, one lacks the array, or its blocks cannot be so
void check_vti_pieces(vtkXMLImageDataReader& reader, const std::filesystem::path& file, const VtiArray& array,
                      const std::array<int, 6>& whole);

} // namespace abut::formats
