#include "geometry/labels/speckles.h"

#include "geometry/labels/components.h"
#include "geometry/labels/neighbours.h"

#include <functional>
#include <map>
#include <queue>
#include <vector>

namespace abut {

namespace {

class SpeckleRemoval {
public:
    SpeckleRemoval(LabelVolume& labels, int connectivity, std::int64_t smallest)
        : labels_(labels), smallest_(smallest),
          parts_(connected_components(labels, connectivity, complementary_connectivity(connectivity))),
          faces_(labels.size, connectivity == 4 || connectivity == 8 ? 4 : 6), of_bodies_(labels.size, connectivity),
          of_void_(labels.size, complementary_connectivity(connectivity)) {
        component_.resize(static_cast<std::size_t>(parts_.count) + 1);
        for (std::size_t k = 0; k < component_.size(); ++k) component_[k].parent = static_cast<std::int32_t>(k);
        next_.resize(labels.label.size());
        for (std::size_t p = 0; p < next_.size(); ++p) {
            Component& component = component_[parts_.volume.label[p]];
            const auto pixel = static_cast<Pixel>(p);
            next_[p] = component.pixels == 0 ? pixel : next_[component.pixel];
            if (component.pixels > 0) next_[component.pixel] = pixel;
            component.label = labels.label[p];
            component.pixel = pixel;
            ++component.pixels;
        }
    }

    RemovedSpeckles run() {
        for (std::int32_t k = 1; k <= parts_.count; ++k) wait_if_small(k);
        while (!waiting_.empty()) {
            const auto [pixels, k] = waiting_.top();
            waiting_.pop();
            if (component_[k].parent == k && component_[k].pixels == pixels) give_away(k);
        }
        RemovedSpeckles removed;
        std::vector<bool> changed(component_.size(), false);
        for (std::size_t p = 0; p < next_.size(); ++p) {
            const std::int32_t label = component_[root(parts_.volume.label[p])].label;
            if (label == labels_.label[p]) continue;
            labels_.label[p] = label;
            ++removed.pixels;
            changed[parts_.volume.label[p]] = true;
        }
        for (const bool each : changed) removed.components += each ? 1 : 0;
        return removed;
    }

private:
    using Pixel = std::uint32_t;
    struct Component {
        std::int32_t parent = 0; ///< itself, or one that it has become part of
        std::int32_t label = 0;
        std::int64_t pixels = 0;
        Pixel pixel = 0; ///< one of its pixels; the others follow in the ring next_
    };

    std::int32_t root(std::int32_t k) {
        while (component_[k].parent != k) {
            component_[k].parent = component_[component_[k].parent].parent;
            k = component_[k].parent;
        }
        return k;
    }

    void wait_if_small(std::int32_t k) {
        if (component_[k].pixels < smallest_) waiting_.push({component_[k].pixels, k});
    }

    template <class Visit>
    void visit_around(std::int32_t k, const Neighbours& neighbours, const Visit& visit_one) {
        const Pixel first = component_[k].pixel;
        Pixel p = first;
        do {
            neighbours.visit(p, [&](std::size_t q) {
                const std::int32_t other = root(parts_.volume.label[q]);
                if (other != k) visit_one(other);
            });
            p = next_[p];
        } while (p != first);
    }

    void give_away(std::int32_t k) {
        std::map<std::int32_t, std::int64_t> faces; // by label: of equals the smaller wins
        visit_around(k, faces_, [&](std::int32_t other) { ++faces[component_[other].label]; });
        if (faces.empty()) return; // the whole image
        auto most = faces.begin();
        for (auto each = faces.begin(); each != faces.end(); ++each)
            if (each->second > most->second) most = each;
        const std::int32_t label = component_[k].label = most->first;
        std::vector<std::int32_t> touched;
        visit_around(k, label == 0 ? of_void_ : of_bodies_, [&](std::int32_t other) {
            if (component_[other].label == label && (touched.empty() || touched.back() != other))
                touched.push_back(other);
        });
        for (const std::int32_t other : touched) k = join(k, root(other));
        wait_if_small(k);
    }

    std::int32_t join(std::int32_t a, std::int32_t b) {
        if (a == b) return a;
        if (a > b) std::swap(a, b);
        component_[b].parent = a;
        component_[a].pixels += component_[b].pixels;
        std::swap(next_[component_[a].pixel], next_[component_[b].pixel]); // two rings become one
        return a;
    }

    LabelVolume& labels_;
    std::int64_t smallest_ = 0;
    Components parts_;
    Neighbours faces_, of_bodies_, of_void_;
    std::vector<Component> component_;
    std::vector<Pixel> next_; ///< the pixels of each component form a ring
    using Waiting = std::pair<std::int64_t, std::int32_t>;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

} // namespace

RemovedSpeckles remove_speckles(LabelVolume& labels, int connectivity, std::int64_t smallest) {
    if (smallest <= 1 || labels.label.empty()) return {};
    return SpeckleRemoval(labels, connectivity, smallest).run();
}

} // namespace abut
