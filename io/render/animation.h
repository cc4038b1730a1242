#pragma once
/// \file animation.h
/// Pictures of a series as one file that plays.

#include <filesystem>
#include <vector>

namespace abut {

/// Throws RenderRequestError unless write_animation can make such a file: .ogv, .apng or .png, 1 to 100 pictures a
/// second, in a folder that is there, under a name that is no folder's.
void check_animation(const std::filesystem::path& file, int fps);

/// Writes PNG files of one size (8 bits, RGB, as ours are), in their order, as a video (.ogv: Ogg with Theora, lossy)
/// or as an animated PNG that repeats for ever (.apng, .png: the very pictures). The file appears whole or not at all.
/// Throws std::runtime_error naming a file and the cause.
void write_animation(const std::vector<std::filesystem::path>& pictures, const std::filesystem::path& file, int fps);

} // namespace abut
