#pragma once
/// \file write_frame.h
/// Frames as VTK's XML files: appended raw binary, LZ4, 64-bit headers; reals as Float64 or Float32, whole numbers as
/// Int32, the time as `TimeValue` field data, lists of words as string field data. No array is made the active one.

#include "results/frame.h"

#include <filesystem>

namespace abut {

/// How reals are written: arrays and places of particles, but not places of contact nodes, the time and other field
/// data.
enum class Reals { float64, float32 };

/// Writes particles as a .vtu file, one VTK_VERTEX each. The file appears complete or not at all.
/// Throws std::runtime_error naming file and cause if it cannot be written, std::invalid_argument if an array's length
/// does not fit the number of points.
void write_particles(const std::filesystem::path& path, const PointFrame& frame, Reals reals = Reals::float64);

/// Writes contact pairs as a .vtp file, one vertex each; otherwise as write_particles.
void write_contact(const std::filesystem::path& path, const PointFrame& frame, Reals reals = Reals::float64);

/// Writes cells with cell data; otherwise as write_particles. If the name ends in .vtp, cells of two corners are lines,
/// those of more polygons; else, in a .vtu file, those of 2 are lines, of 4 quadrilaterals, of 8 hexahedra. Throws
/// std::invalid_argument also for cells of other numbers of corners, and in a .vtp file for a line after a polygon (VTK
/// numbers lines first).
void write_cells(const std::filesystem::path& path, const CellFrame& frame);

/// Writes the grid's nodes as a .vti file (image data with point arrays); otherwise as write_particles.
void write_grid(const std::filesystem::path& path, const GridFrame& frame, Reals reals = Reals::float64);

} // namespace abut
