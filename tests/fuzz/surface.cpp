// Surfaces of triangles: each input as an STL, OFF, PLY and OBJ file, read and checked, not repaired.
#include "geometry/shapes/surface.h"
#include "geometry/shapes/check_surface.h"
#include "one_file.h"

#include <array>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::array<fuzz::OneFile, 4> files{fuzz::OneFile(".stl"), fuzz::OneFile(".off"), fuzz::OneFile(".ply"),
                                                    fuzz::OneFile(".obj")};
    for (const fuzz::OneFile& file : files) {
        const auto& path = file.holds(data, size);
        abut::Surface surface;
        surface.file = path;
        try {
            const abut::TriangleMesh mesh = abut::read_surface(surface, path).mesh;
            for (const std::array<int, 3>& triangle : mesh.triangles)
                for (const int corner : triangle)
                    if (corner < 0 || corner >= static_cast<int>(mesh.points.size())) __builtin_trap();
        } catch (const std::runtime_error& error) {
            fuzz::require_helpful(error.what(), path);
        }
    }
    return 0;
}
