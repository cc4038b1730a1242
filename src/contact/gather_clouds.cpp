#include "contact/find_contacts.h"
#include "grid/parallel.h"
#include "shape/dispatch.h"

#include <atomic>

namespace abut {

namespace {

/// \return false if a cloud has more particles than it has places
template <int D, class Source>
bool fill(State<D>& state, Source) {
    Contact<D>& contact = state.contact;
    contact.cloud_size.assign(contact.groups.size(), 0);
    contact.cloud_particles.resize(contact.groups.size() * contact.cloud_capacity);
    std::atomic<bool> complete = true;
    for_each_tile_by_colour(state.tiling, [&](const Tile<D>& tile) {
        if (!tile.contact) return;
        auto stencils = state.template stencils<Source>(tile);
        for (std::int32_t p = tile.first; p < tile.last; ++p) {
            const StencilView<D> s = stencils.of(p);
            for (int k = 0; k < s.count; ++k) {
                if (!(s.S[k] > 0)) continue;
                const std::int32_t group = contact.group_of_slot[s.slot[k]];
                if (group < 0) continue;
                std::int32_t& size = contact.cloud_size[group];
                std::int32_t* cloud = contact.cloud_particles.data() + group * std::ptrdiff_t{contact.cloud_capacity};
                // A shape that lists a node more than once does so for one particle at a time.
                if (size > 0 && size <= contact.cloud_capacity && cloud[size - 1] == p) continue;
                if (size < contact.cloud_capacity)
                    cloud[size] = p;
                else
                    complete = false;
                ++size;
            }
        }
    });
    return complete;
}

} // namespace

template <int D>
void gather_clouds(State<D>& state) {
    Contact<D>& contact = state.contact;
    contact.group_of_slot.assign(state.fields.size(), -1);
    for (std::size_t g = 0; g < contact.groups.size(); ++g)
        for (std::int32_t i = contact.groups[g].first; i < contact.groups[g].last; ++i)
            contact.group_of_slot[contact.active[i]] = static_cast<std::int32_t>(g);
    with_stencils(state, [&](auto source) {
        while (!fill(state, source)) contact.cloud_capacity *= 2;
    });
}

template void gather_clouds<2>(State<2>&);
template void gather_clouds<3>(State<3>&);

} // namespace abut
