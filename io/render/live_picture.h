#pragma once
/// \file live_picture.h
/// A picture of a run under way, replaced from time to time.

#include "io/render/view.h"
#include "results/frame.h"

#include <filesystem>
#include <memory>
#include <string>

namespace abut {

/// Draws frames that are in memory to one PNG file, which anyone who looks sees whole. The view stays: that of the
/// grid in the plane; in space that of the particles at first, widened when they leave it. Colours are for all values
/// so far. OpenGL is opened at the first picture.
class LivePicture {
public:
    /// \param grid box of the grid [m] \param preset one of render_presets() \param end_time of the run [s]
    LivePicture(const std::filesystem::path& file, const Bounds& grid, const std::string& title,
                const std::string& preset, double end_time);
    ~LivePicture();
    LivePicture(LivePicture&& other) noexcept;
    LivePicture& operator=(LivePicture&& other) noexcept;

    /// Whether draw() needs the contact pairs.
    bool wants_contact() const;

    /// Replaces the picture. A picture is no reason to end a run: what goes wrong is told on stderr, once, and nothing
    /// is drawn from then on. \param contact the contact pairs, or null where there are none
    void draw(const PointFrame& particles, const PointFrame* contact);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace abut
