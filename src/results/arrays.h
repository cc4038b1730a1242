#pragma once
/// \file arrays.h
/// The arrays that result series may have, with their units and meanings: checking, writing, pictures and the
/// reference page share this one table.

#include <span>
#include <string_view>

namespace abut {

/// One array of a series.
struct ArrayInfo {
    std::string_view name;
    int components = 1;
    std::string_view unit; ///< SI; "" for pure numbers
    std::string_view meaning;
    std::string_view only{}; ///< when it is there, if not always
};

/// Arrays of particles.pvd.
std::span<const ArrayInfo> particle_arrays();
/// Arrays of grid.pvd.
std::span<const ArrayInfo> grid_arrays();
/// Arrays of contact.pvd.
std::span<const ArrayInfo> contact_arrays();

/// Arrays of the cells of cloud_….vtu and plane_….vtp (io/results/write_contact_clouds.h).
std::span<const ArrayInfo> cloud_arrays();
std::span<const ArrayInfo> plane_arrays();

/// Unit of the array of that name in any of these; "" if there is none.
std::string_view unit_of_array(std::string_view name);

} // namespace abut
