#pragma once
/// \file result_folder.h
/// The folder of a run, made ready before the run starts.

#include <filesystem>
#include <vector>

namespace abut {

/// A result folder that no other run writes to while this lives. The lock goes with the process, however it ends.
class FolderLock {
public:
    FolderLock() = default; ///< none
    /// Of a folder that exists. Throws std::runtime_error that says what to do if another process has it.
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&& other) noexcept;
    ~FolderLock();

private:
    int descriptor_ = -1;
};

/// Creates `folder`, or makes an existing one ready: an empty folder is taken as it is; one that holds anything is
/// refused unless `overwrite`, and then only files that abut itself writes are removed (series, tables, scene.json,
/// checkpoint), never anything else. Refused in any case: a folder whose files to be replaced are among `inputs` (the
/// scene of the run), one that cannot be written to, and one that another run writes to. Throws std::runtime_error that
/// says what to do; nothing is removed then.
FolderLock prepare_result_folder(const std::filesystem::path& folder, bool overwrite,
                                 const std::vector<std::filesystem::path>& inputs = {});

} // namespace abut
