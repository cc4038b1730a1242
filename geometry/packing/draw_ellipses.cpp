#include "geometry/packing/draw_ellipses.h"

namespace abut {

DrawnImage draw_ellipses(const EllipseDrawing& drawing) {
    PackRequest request;
    request.width = drawing.width;
    request.height = drawing.height;
    request.bodies = drawing.bodies;
    request.area_fraction = drawing.area_fraction;
    request.sizes = drawing.sizes;
    request.min_aspect = drawing.min_aspect;
    request.max_aspect = drawing.max_aspect;
    request.gap = drawing.gap;
    request.seed = drawing.seed;
    const DrawingStyle style{drawing.shades, drawing.neighbour_distance, drawing.background, drawing.seed};
    check_style(style); // before the long work
    const PackedGrains packed = pack_grains(request);
    const ShadedGrains shaded = shade_grains(packed, style);
    DrawnImage drawn{draw(shaded), {}, shaded.shade, shaded.shades, shaded.background, shaded.fraction};
    for (const ShapeSpec& grain : packed.grains) drawn.ellipses.push_back(std::get<Ellipse>(grain));
    return drawn;
}

} // namespace abut
