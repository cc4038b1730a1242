#include "particles/particles.h"

namespace abut {

template <int D>
Particles<D> make_particles(const Model& model, const Scene& scene) {
    Particles<D> particles;
    const std::size_t n = model.size();
    particles.deformation_gradient.assign(n, Mat<D>::Identity());
    particles.stress.assign(n, Stress<D>::Zero());
    for (std::size_t p = 0; p < n; ++p) {
        const ModelBody& body = model.bodies[model.body[p]];
        const Vec<D> half_size = to_vec<D>(model.half_size[p]);
        const double volume = (2 * half_size).prod() * (D == 2 ? scene.thickness : 1.0);
        particles.position.push_back(to_vec<D>(model.position[p]));
        particles.velocity.push_back(to_vec<D>(body.velocity));
        particles.mass.push_back(scene.materials[body.material].density * volume);
        particles.volume.push_back(volume);
        particles.half_size.push_back(half_size);
        particles.body.push_back(model.body[p]);
        particles.id.push_back(static_cast<std::int32_t>(p));
    }
    return particles;
}

template Particles<2> make_particles<2>(const Model&, const Scene&);

} // namespace abut
