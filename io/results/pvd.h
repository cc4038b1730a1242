#pragma once
/// \file pvd.h
/// Time series for ParaView: a .pvd file that lists the frames with their times.

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

struct PvdEntry {
    double time = 0;  ///< [s]
    std::string file; ///< relative to the .pvd file's folder, with '/'
};

/// A .pvd file and what is in it.
struct PvdSeries {
    std::filesystem::path path;
    std::vector<PvdEntry> entries;

    /// Adds a frame and rewrites the file at once, so that it can be opened at any moment. Entries at this time or
    /// later are replaced: a resumed run continues the series without duplicates. Throws as write_text_atomically.
    void append(double time, const std::string& file);
    void write() const; ///< rewrites the file as the entries are
};

/// One of the series in a .pvd file of several parts.
struct PvdPart {
    std::string name;
    const PvdSeries* series = nullptr;
};

/// Writes a .pvd file of several parts, which ParaView opens as one multi-block source: at each time of any of the
/// series, the latest frame of each. Throws as write_text_atomically.
void write_parts(const std::filesystem::path& path, const std::vector<PvdPart>& parts);

/// Reads a .pvd file. Throws std::runtime_error naming the file if it is missing or broken.
PvdSeries read_pvd(const std::filesystem::path& path);

} // namespace abut
