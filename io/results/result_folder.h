#pragma once
/// \file result_folder.h
/// The folder of a run, made ready before the run starts.

#include <filesystem>
#include <vector>

namespace abut {

/// Creates `folder`, or makes an existing one ready: an empty folder is taken as it is; one that holds anything is
/// refused unless `overwrite`, and then only files that abut itself writes are removed (series, tables, scene.json,
/// checkpoint), never anything else. Refused in any case: a folder whose files to be replaced are among `inputs` (the
/// scene of the run), and one that cannot be written to. Throws std::runtime_error that says what to do; nothing is
/// removed then.
void prepare_result_folder(const std::filesystem::path& folder, bool overwrite,
                           const std::vector<std::filesystem::path>& inputs = {});

} // namespace abut
