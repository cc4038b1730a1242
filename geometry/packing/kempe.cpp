#include "geometry/packing/kempe.h"

#include <algorithm>
#include <set>
#include <utility>

namespace abut {

namespace {

constexpr int none = -1;

/// The body of smallest degree is the last; so on with what is left.
std::vector<int> smallest_last(const Neighbours& neighbours) {
    std::vector<int> degree, order;
    std::set<std::pair<int, int>> left;
    for (std::size_t body = 0; body < neighbours.size(); ++body) {
        degree.push_back(static_cast<int>(neighbours[body].size()));
        left.emplace(degree.back(), static_cast<int>(body));
    }
    std::vector<char> taken(neighbours.size(), 0);
    while (!left.empty()) {
        const int body = left.begin()->second;
        left.erase(left.begin());
        taken[body] = 1;
        order.push_back(body);
        for (const int other : neighbours[body]) {
            if (taken[other]) continue;
            left.erase({degree[other], other});
            left.emplace(--degree[other], other);
        }
    }
    std::reverse(order.begin(), order.end());
    return order;
}

class Colouring {
public:
    Colouring(const Neighbours& neighbours, int colours, Random& random)
        : neighbours_(neighbours), colours_(colours), random_(random), colour_(neighbours.size(), none),
          uses_(colours, 0), mark_(neighbours.size(), 0) {}

    bool run() {
        for (const int body : smallest_last(neighbours_))
            if (!colour_in(body)) return false;
        balance();
        return true;
    }

    const std::vector<int>& colours() const { return colour_; }

private:
    bool colour_in(int body) {
        int free = free_colour(body);
        if (free == none && colours_ > 1) {
            for (int a = 0; a < colours_ && free == none; ++a)
                for (int b = a + 1; b < colours_ && free == none; ++b) {
                    free_by_chain(body, a, b);
                    free = free_colour(body);
                }
            // Kempe's flaw: chains in the way of each other. Other colourings of the neighbourhood have other chains.
            constexpr int most_tries = 2000;
            for (int attempt = 0; attempt < most_tries && free == none; ++attempt) {
                const auto& near = neighbours_[body];
                int start = near[random_.below(static_cast<int>(near.size()))];
                const auto& further = neighbours_[start];
                if (attempt % 3 != 0) start = further[random_.below(static_cast<int>(further.size()))];
                if (colour_[start] == none) continue;
                int other = random_.below(colours_ - 1);
                if (other >= colour_[start]) ++other;
                swap(chain(start, other), other);
                free = free_colour(body);
            }
        }
        if (free == none) return false;
        colour_[body] = free;
        ++uses_[free];
        return true;
    }

    /// The least used of the colours that no neighbour has.
    int free_colour(int body) const {
        std::vector<char> taken(colours_, 0);
        for (const int other : neighbours_[body])
            if (colour_[other] != none) taken[colour_[other]] = 1;
        int best = none;
        for (int colour = 0; colour < colours_; ++colour)
            if (!taken[colour] && (best == none || uses_[colour] < uses_[best])) best = colour;
        return best;
    }

    /// Swaps a and b in the chains of all neighbours with colour a, if none of these has a neighbour of colour b.
    void free_by_chain(int body, int a, int b) {
        std::vector<int> bodies;
        const int own_mark = ++last_mark_;
        for (const int start : neighbours_[body]) {
            if (colour_[start] != a || mark_[start] == own_mark) continue;
            for (const int each : chain(start, b, own_mark)) bodies.push_back(each);
        }
        for (const int other : neighbours_[body])
            if (colour_[other] == b && mark_[other] == own_mark) return;
        swap(bodies, a, b);
    }

    /// What hangs together with a body in its colour and another.
    std::vector<int> chain(int start, int other) { return chain(start, other, ++last_mark_); }
    std::vector<int> chain(int start, int other, int mark) {
        std::vector<int> bodies{start};
        mark_[start] = mark;
        const int own = colour_[start];
        for (std::size_t k = 0; k < bodies.size(); ++k)
            for (const int next : neighbours_[bodies[k]])
                if ((colour_[next] == own || colour_[next] == other) && mark_[next] != mark) {
                    mark_[next] = mark;
                    bodies.push_back(next);
                }
        return bodies;
    }

    void swap(const std::vector<int>& bodies, int other) { swap(bodies, colour_[bodies.front()], other); }
    void swap(const std::vector<int>& bodies, int a, int b) {
        for (const int body : bodies) {
            --uses_[colour_[body]];
            colour_[body] = colour_[body] == a ? b : a;
            ++uses_[colour_[body]];
        }
    }

    /// Recolours bodies of the most used colour with the least used one while that evens them out.
    void balance() {
        for (std::size_t round = 0; round < neighbours_.size(); ++round) {
            const auto most = std::max_element(uses_.begin(), uses_.end()) - uses_.begin();
            bool changed = false;
            for (std::size_t body = 0; body < colour_.size() && !changed; ++body) {
                if (colour_[body] != most) continue;
                const int better = free_colour(static_cast<int>(body));
                if (better == none || better == most || uses_[better] + 1 >= uses_[most]) continue;
                --uses_[most];
                ++uses_[better];
                colour_[body] = better;
                changed = true;
            }
            if (!changed) return;
        }
    }

    const Neighbours& neighbours_;
    int colours_;
    Random& random_;
    std::vector<int> colour_;
    std::vector<int> uses_; ///< per colour
    std::vector<int> mark_; ///< the last search that met the body
    int last_mark_ = 0;
};

} // namespace

std::optional<std::vector<int>> kempe_colouring(const Neighbours& neighbours, int colours, Random& random) {
    constexpr int most_starts = 5;
    for (int start = 0; start < most_starts; ++start) {
        Colouring colouring(neighbours, colours, random);
        if (colouring.run()) return colouring.colours();
    }
    return {};
}

} // namespace abut
