#pragma once
/// \file series_source.h
/// A result folder as the source of pictures.

#include "io/render/view.h"
#include "io/results/pvd.h"
#include "results/frame.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// The series of a result folder. All members throw std::runtime_error naming a file that is missing or broken.
struct SeriesSource {
    std::filesystem::path folder;
    PvdSeries series;                  ///< particles.pvd
    std::optional<PvdSeries> contacts; ///< contact.pvd, if it was asked for

    /// Frame `index`, with all point arrays or with the wanted ones only.
    PointFrame particles(int index, const std::vector<std::string>& wanted) const;
    /// The contact pairs at the time of particle frame `index`, for which contact_entry must not be null.
    PointFrame contact(int index) const;
    /// The entry at its time in contact.pvd; null if contact pairs were written at other times.
    const PvdEntry* contact_entry(int index) const;
    /// Throws if a file of these frames, or of their contact pairs if these were asked for, is missing or cut off;
    /// reads no more than each file's end.
    void check_files(const std::vector<int>& frames) const;
    /// The box of the first grid file; none without grid.pvd.
    std::optional<Bounds> grid_bounds() const;
    /// The scene's title from scene.json; empty if there is none.
    std::string title() const;
};

/// Opens a result folder; with `with_contact` it must hold contact.pvd.
SeriesSource open_series(const std::filesystem::path& folder, bool with_contact);

std::vector<std::string> array_names(const PointFrame& frame);

/// `no array "presure"; did you mean "pressure"? (there are: body, pressure)`, or that there are none
std::string no_such(const std::string& what, const std::string& name, const std::vector<std::string>& known);

} // namespace abut
