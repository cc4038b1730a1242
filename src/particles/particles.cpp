#include "particles/particles.h"

#include "material/prestress.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <numbers>

namespace abut {

namespace {

/// What makes a volume of a plane particle's area: the thickness, or the way around the axis [m]; 1 in 3D.
double depth_of(const Scene& scene, const Vector& x) {
    if (scene.analysis == Analysis::three_d) return 1;
    return scene.analysis == Analysis::axisymmetric ? 2 * std::numbers::pi * x[0] : scene.thickness;
}

/// Stresses of bodies that have one at the start. Domains that are turned are so by F, which S then has to undo.
template <int D>
void add_prestress(Particles<D>& particles, const Model& model) {
    if (std::none_of(model.bodies.begin(), model.bodies.end(), [](const ModelBody& body) { return body.stress; }))
        return;
    particles.prestress.assign(particles.size(), Stress<D>::Zero());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::optional<std::array<double, 6>>& stress = model.bodies[particles.body[p]].stress;
        if (!stress) continue;
        for (int c = 0; c < static_cast<int>(particles.stress[p].size()); ++c) particles.stress[p][c] = (*stress)[c];
        particles.prestress[p] =
            pushed_forward<D>(particles.stress[p], particles.deformation_gradient[p].inverse(), 1.0);
    }
}

} // namespace

template <int D>
Particles<D> make_particles(const Model& model, const Scene& scene) {
    Particles<D> particles;
    const std::size_t n = model.size();
    particles.deformation_gradient.assign(n, Mat<D>::Identity());
    particles.stress.assign(n, Stress<D>::Zero());
    if (scene.analysis == Analysis::plane_stress || scene.analysis == Analysis::axisymmetric)
        particles.across.assign(n, 1.0);
    if constexpr (D == 2)
        for (std::size_t p = 0; p < model.angle.size(); ++p)
            particles.deformation_gradient[p] = Eigen::Rotation2Dd(model.angle[p]).toRotationMatrix();
    // Rigid particles have a mass as if of the densest material, to weigh what they extrapolate; no force moves it.
    double densest = 0;
    for (const MaterialSpec& material : scene.materials) densest = std::max(densest, material.density);
    for (std::size_t p = 0; p < n; ++p) {
        const ModelBody& body = model.bodies[model.body[p]];
        const Vec<D> half_size = to_vec<D>(model.half_size[p]);
        const double volume = (2 * half_size).prod() * depth_of(scene, model.position[p]);
        particles.position.push_back(to_vec<D>(model.position[p]));
        particles.velocity.push_back(to_vec<D>(body.velocity.at(model.position[p])));
        particles.mass.push_back((body.rigid ? densest : scene.materials[body.material].density) * volume);
        particles.volume.push_back(volume);
        particles.half_size.push_back(half_size);
        particles.body.push_back(model.body[p]);
        particles.id.push_back(static_cast<std::int32_t>(p));
    }
    add_prestress(particles, model);
    return particles;
}

template Particles<2> make_particles<2>(const Model&, const Scene&);
template Particles<3> make_particles<3>(const Model&, const Scene&);

} // namespace abut
