#pragma once
/// \file write_contact_clouds.h
/// Contact nodes taken apart (contact/inspect.h) as files for ParaView and spreadsheets. Three files for a node, or for
/// several together, in SI units:
///
/// * cloud_….vtu: the deformed domains of the particles that the search saw (quadrilaterals, hexahedra), once for each
///   pair of bodies at the node. Cell arrays: `body`, `id`, `distance` (signed, of the centre to the plane of the
///   scene's own method, positive on the side of `body_b`; NaN without a plane) [m], `edge_distance` (R) [m], `support`
///   (1: its side ends with it), `deformation_gradient` (9), `half_size` [m], `centre` [m], `pair` (number of the pair
///   at its node), `body_a`, `body_b` and `node` (its numbers along the axes).
/// * plane_….vtp: the plane of each method (2D a segment, 3D a square) halfway between both edges, as wide as the
///   cloud. Cell arrays: `normal` (unit, from `body_a` to `body_b`), `fitted_normal` (before `particle-edges` turned
///   it), `separation_particle_edges`, `separation_critical_position`, `separation_fitted_position`,
///   `separation_displacement` [m], `end_a`, `end_b` (where the sides end along the normal, from the node) [m],
///   `iterations`, `angle` (to the scene's own normal) [rad], `method` (place in the field data `method_names`),
///   `chosen` (1: the scene's own), `lumped` (1: `body_a` against all others), `pair`, `body_a`, `body_b`, `node`.
///   A method that finds no normal has no plane here, but a row in the table.
/// * node_….csv: the same side by side, a row for each pair and method.
///
/// Field data: TimeValue, `step`, `units`, `body_names`, `method_names`; for one node `node` and `node_position` [m]
/// too.

#include "contact/inspect.h"
#include "results/frame.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abut {

/// What is in cloud_….vtu and plane_….vtp.
template <int D>
CellFrame cloud_frame(const State<D>& state, const std::vector<NodeSeen<D>>& nodes);
template <int D>
CellFrame plane_frame(const State<D>& state, const std::vector<NodeSeen<D>>& nodes);
/// What is in node_….csv; names of bodies and methods as texts, `inf` and `nan` where there is no plane.
template <int D>
std::string node_table(const State<D>& state, const std::vector<NodeSeen<D>>& nodes);

/// "00012_7_3": number of the frame and of the node along the axes, as in the names of its files.
template <int D>
std::string node_file_suffix(int frame, const Index<D>& node);

/// Writes cloud_SUFFIX.vtu, plane_SUFFIX.vtp and node_SUFFIX.csv to a folder, which is made if need be; each appears
/// complete or not at all. \return the three files. Throws as write_cells().
template <int D>
std::vector<std::filesystem::path> write_node_files(const State<D>& state, const std::vector<NodeSeen<D>>& nodes,
                                                    const std::filesystem::path& folder, const std::string& suffix);

/// What `output.contact_clouds` of the scene asks for (which must be given), to RESULTS/clouds: three files for each
/// chosen node, and three for all nodes in disagreement together (cloud_FRAME.vtu, …); series for ParaView for each
/// choice, which continue those on the disk: cloud_I_J.pvd, cloud_near_K.pvd (K: place in `near`, from 0; the nearest
/// contact node may change), cloud_disagreement.pvd, and the same of planes. A chosen node that is no contact node at
/// the time gets files without cells. The state must have been `look`ed at.
template <int D>
void write_contact_clouds(State<D>& state, const std::filesystem::path& results, int frame);

} // namespace abut
