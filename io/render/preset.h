#pragma once
/// \file preset.h
/// Presets of pictures by name, and what to say where results lack what a picture needs.

#include "io/render/render_series.h"

namespace abut {

/// The options with what their preset stands for. Throws RenderRequestError for an unknown preset or a wrong option.
RenderOptions resolved(RenderOptions options);

/// The array that colours the particles. Throws RenderRequestError, saying what could be drawn, if the frame lacks it
/// or its component. \param where for messages
const Array& chosen_array(const PointFrame& frame, const RenderOptions& options, const std::string& where);

/// Throws RenderRequestError, naming the array and `where`, if the contact pairs lack one that the pictures need.
void check_contact_arrays(const PointFrame& contact, const RenderOptions& options, const std::string& where);

/// Whether particles have the colours of their bodies.
bool by_body(const RenderOptions& options);

/// Whether contact pairs are drawn.
bool with_contact(const RenderOptions& options);

} // namespace abut
