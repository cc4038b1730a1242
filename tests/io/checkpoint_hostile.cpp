/// Damaged and hostile checkpoints: always a std::runtime_error that names the file, and a state left as it was.
#include "checkpoint_support.h"
#include "sanitizer_memory.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sys/resource.h>

namespace abut::test {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A state with all that a checkpoint can hold in the plane, its checkpoint and a new state to read it into.
class HostileCheckpoint : public testing::Test {
protected:
    HostileCheckpoint() {
        write_checkpoint(path, state_after<2>(everything, 17), {}, "{}", 1);
        sound = read_document(path);
    }

    static Case all() {
        Case c = two_blocks("everything");
        c.scene.analysis = Analysis::plane_stress;
        ::test::add_wall(c.scene, "floor", 1, Side::lower, 2);
        RigidSpec rigid;
        rigid.velocity[1] = -0.3;
        c.model.bodies[1] = {"upper", -1, {}, rigid};
        c.scene.bodies.emplace_back().rigid = rigid;
        ::test::add_box(c.model, ::test::add_body(c.model, "lid", {0, -0.5, 0}), 9, 4, 11, 6, 4, 4);
        return c;
    }

    /// What is said about the file; the state must be as before. Empty if it is taken.
    std::string refusal() {
        State<2> state = fresh;
        std::string message;
        try {
            read_checkpoint_head(path);
            read_checkpoint(path, state);
        } catch (const std::runtime_error& error) {
            message = error.what();
            EXPECT_THAT(message, HasSubstr("checkpoint.h5")) << message;
        }
        if (!message.empty()) expect_same(fresh, state, message);
        return message;
    }
    std::string refusal_of(const Document& document) {
        std::filesystem::remove(path); // file systems take time to empty files that are written anew
        write_document(path, document);
        return refusal();
    }
    template <class Change>
    std::string refusal_with(const std::string& name, Change&& change) {
        Document document = sound;
        change(document.at(name));
        return refusal_of(document);
    }
    void write_bytes(const std::string& bytes) {
        std::filesystem::remove(path);
        std::ofstream(path, std::ios::binary) << bytes;
    }

    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "checkpoint.h5";
    const Case everything = all();
    const State<2> fresh = make_state<2>(everything.scene, everything.model);
    Document sound;
};

TEST_F(HostileCheckpoint, SoundOnesAreTaken) {
    EXPECT_EQ(refusal_of(sound), "");
    EXPECT_GT(sound.size(), 20U);
    for (const auto& [name, set] : sound) EXPECT_NE(set.shape, Shape{0}) << name << " is empty: cases are missing";
}

TEST_F(HostileCheckpoint, EveryMissingArrayIsNamed) {
    for (const auto& [name, set] : sound) {
        Document document = sound;
        document.erase(name);
        const std::string message = refusal_of(document);
        if (name != "format")
            EXPECT_THAT(message, HasSubstr("no array \"" + name + "\""));
        else
            EXPECT_THAT(message, HasSubstr("is no checkpoint of abut"));
    }
}

TEST_F(HostileCheckpoint, EveryArrayOfOtherExtentsIsNamed) {
    for (const auto& [name, set] : sound) {
        if (set.kind == Dataset::Kind::text) continue; // of any length
        const auto reshaped = [&](const Shape& shape) {
            std::size_t count = 1;
            for (const std::size_t extent : shape) count *= extent;
            return refusal_with(name, [&](Dataset& changed) {
                changed.shape = shape;
                if (changed.kind == Dataset::Kind::reals)
                    changed.reals.resize(count);
                else
                    changed.integers.resize(count);
            });
        };
        Shape more = set.shape;
        ++more[0];
        Shape fewer = set.shape;
        --fewer[0];
        Shape deeper = set.shape;
        deeper.push_back(1);
        Shape wider = set.shape;
        ++wider.back();
        for (const Shape& shape : {more, fewer, deeper, wider, Shape{}, Shape{0}})
            EXPECT_THAT(reshaped(shape), HasSubstr(name.substr(0, name.find('/')))) << name << " " << shape.size();
    }
}

TEST_F(HostileCheckpoint, EveryArrayOfAnotherTypeIsNamed) {
    for (const auto& [name, set] : sound) {
        const std::string message = refusal_with(name, [&](Dataset& changed) {
            std::size_t count = 1;
            for (const std::size_t extent : set.shape) count *= extent;
            changed.reals.assign(count, 1);
            changed.integers.assign(count, 1);
            changed.kind = set.kind == Dataset::Kind::reals ? Dataset::Kind::integers : Dataset::Kind::reals;
        });
        EXPECT_THAT(message, HasSubstr("\"" + name + "\" has values of another type")) << name;
    }
}

TEST_F(HostileCheckpoint, ValuesThatAreNoNumbersAreNamed) {
    for (const auto& [name, set] : sound) {
        if (set.kind != Dataset::Kind::reals) continue;
        for (const double bad :
             {nan, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
            for (const std::size_t place : {std::size_t{0}, set.reals.size() - 1})
                EXPECT_THAT(refusal_with(name, [&](Dataset& changed) { changed.reals[place] = bad; }),
                            HasSubstr(name + ": entry "))
                    << name << " " << bad;
    }
}

TEST_F(HostileCheckpoint, ValuesThatCannotBeAreNamed) {
    const auto integer = [&](const std::string& name, std::size_t place, std::int64_t value) {
        return refusal_with(name, [&](Dataset& changed) { changed.integers.at(place) = value; });
    };
    const auto real = [&](const std::string& name, std::size_t place, double value) {
        return refusal_with(name, [&](Dataset& changed) { changed.reals.at(place) = value; });
    };
    const auto n = static_cast<std::int64_t>(fresh.particles.size());
    constexpr std::int64_t huge = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t id : {std::int64_t{-1}, n, huge, std::int64_t{1} << 32, -huge})
        EXPECT_THAT(integer("particles/id", 3, id), HasSubstr(fmt::format("{} is out of its range", id)));
    EXPECT_THAT(integer("particles/id", 3, sound.at("particles/id").integers[4]), HasSubstr("is there twice"));

    for (const double place : {-1.1, 13.1, 1e300})
        EXPECT_THAT(real("particles/position", 2, place), HasSubstr("is outside the grid"));
    EXPECT_THAT(real("particles/deformation_gradient", 0, -1), HasSubstr("is turned inside out"));
    EXPECT_THAT(real("particles/deformation_gradient", 0, 0), HasSubstr("is turned inside out"));
    EXPECT_THAT(real("particles/across", 0, -1), HasSubstr("is turned inside out"));

    for (const std::int64_t value : {std::int64_t{-1}, huge, -huge}) {
        EXPECT_THAT(integer("step", 0, value), HasSubstr("step"));
        EXPECT_THAT(integer("transfers", 0, value), HasSubstr("transfers"));
        EXPECT_THAT(integer("stride", 0, value), HasSubstr("stride"));
        EXPECT_THAT(integer("step_reductions", 0, value), HasSubstr("step_reductions"));
        EXPECT_THAT(integer("setback/trouble", 0, value), HasSubstr("setback/trouble"));
        EXPECT_THAT(integer("setback/returns", 0, value), HasSubstr("setback/returns"));
        EXPECT_THAT(integer("pairs/bodies", 1, value), HasSubstr("pairs/bodies"));
        EXPECT_THAT(integer("rigid/bodies", 0, value), HasSubstr("rigid/bodies"));
        EXPECT_THAT(integer("output/counts", 0, value), HasSubstr("output/counts"));
    }
    EXPECT_THAT(integer("step_reductions", 0, 6), HasSubstr("step_reductions")) << "five are the most";
    EXPECT_THAT(integer("stride", 0, 1 << 16), HasSubstr("stride")) << "colours for it would take gigabytes";
    EXPECT_THAT(integer("pairs/bodies", 1, 3), HasSubstr("pairs/bodies")) << "there are three bodies";
    for (const std::size_t place : {0U, 1U, 3U}) EXPECT_THAT(real("clock", place, -1), HasSubstr("clock")) << place;
    EXPECT_THAT(real("clock", 2, 0), HasSubstr("clock"));
    EXPECT_THAT(integer("version", 0, 2), HasSubstr("has version 2, and this program reads version 1"));
    const auto text = [&](const std::string& name, const std::string& value) {
        return refusal_with(name, [&](Dataset& changed) { changed.text = value; });
    };
    EXPECT_THAT(text("format", "abut checkpoinT"), HasSubstr("is no checkpoint of abut"));
    EXPECT_THAT(text("format", std::string(1000, 'a')), HasSubstr("format"));
    for (const std::string& scene :
         {std::string("{"), std::string("[1]"), std::string("\xff"), std::string(1 << 20, '['),
          "{\"a\":" + std::string(100000, '[') + std::string(100000, ']') + "}"})
        EXPECT_THAT(text("scene", scene), HasSubstr("is no scene"));
}

TEST_F(HostileCheckpoint, PairsAndRigidBodiesAreThoseOfTheScene) {
    // A pair in the wrong order, of one body with itself, there twice; a body that is not rigid.
    const auto pair = [&](std::int64_t a, std::int64_t b) {
        return refusal_with("pairs/bodies", [&](Dataset& changed) {
            changed.integers[0] = a;
            changed.integers[1] = b;
        });
    };
    EXPECT_THAT(pair(1, 0), HasSubstr("pairs/bodies"));
    EXPECT_THAT(pair(1, 1), HasSubstr("pairs/bodies"));
    EXPECT_THAT(refusal_with("rigid/bodies", [](Dataset& changed) { changed.integers[0] = 0; }),
                HasSubstr("rigid/bodies"));
}

TEST_F(HostileCheckpoint, TilesThatAreNoDivisionAreNamed) {
    const std::vector<std::int64_t>& rows = sound.at("tiles").integers;
    ASSERT_GT(rows.size(), 12U);
    const auto changed = [&](std::size_t row, std::size_t column, std::int64_t by) {
        return refusal_with("tiles", [&](Dataset& set) { set.integers[4 * row + column] += by; });
    };
    for (const std::int64_t by : {std::int64_t{-1}, std::int64_t{1}, std::int64_t{1} << 31, std::int64_t{1} << 32}) {
        EXPECT_THAT(changed(1, 2, by), HasSubstr("tiles")) << "first, by " << by;
        EXPECT_THAT(changed(1, 3, by), HasSubstr("tiles")) << "last, by " << by;
    }
    for (const std::int64_t by : {std::int64_t{1}, std::int64_t{-5}, std::int64_t{1} << 32})
        EXPECT_THAT(changed(1, 1, by), HasSubstr("tiles")) << "body, by " << by;
    for (const std::int64_t by : {std::int64_t{-1000}, std::int64_t{1000}, std::int64_t{1} << 32})
        EXPECT_THAT(changed(0, 0, by), HasSubstr("tiles")) << "block, by " << by;
    const auto divided = [&](const std::vector<std::int64_t>& integers) {
        return refusal_with("tiles", [&](Dataset& set) {
            set.integers = integers;
            set.shape[0] = integers.size() / 4;
        });
    };
    EXPECT_THAT(divided({rows.begin(), rows.end() - 4}), HasSubstr("do not hold all particles"));
    EXPECT_THAT(divided({rows.begin() + 4, rows.end()}), HasSubstr("tiles"));
    // The first tile in two of the same block and body.
    std::vector<std::int64_t> split(rows);
    split.insert(split.begin(), rows.begin(), rows.begin() + 4);
    split[3] = split[6] = rows[2] + 1;
    EXPECT_THAT(divided(split), HasSubstr("not in their order"));
}

TEST_F(HostileCheckpoint, OtherFilesAreRefused) {
    for (const std::string& bytes : {std::string(), std::string("{}\n"), std::string("\x89HDF\r\n\x1a\n"),
                                     std::string(100000, '\0'), std::string(5000, 'x')}) {
        write_bytes(bytes);
        EXPECT_THAT(refusal(), HasSubstr("no HDF5 file, or a broken one"));
    }
    std::filesystem::remove(path);
    EXPECT_THAT(refusal(), HasSubstr("no such file"));
    std::filesystem::create_directory(path);
    EXPECT_THAT(refusal(), HasSubstr("no such file"));
    std::filesystem::remove(path);
    write_document(path, {});
    EXPECT_THAT(refusal(), HasSubstr("is no checkpoint of abut"));
}

using ::test::sanitizer_keeps;

long peak_mebibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

TEST_F(HostileCheckpoint, CutFilesAreRefused) {
    const std::string bytes = read_text(path);
    const long before = peak_mebibytes();
    for (std::size_t size = 0; size < bytes.size(); size += 13) {
        write_bytes(bytes.substr(0, size));
        EXPECT_NE(refusal(), "") << size;
    }
    EXPECT_LT(peak_mebibytes() - before, 50 + sanitizer_keeps);
}

TEST_F(HostileCheckpoint, ChangedBytesAreRefusedOrHarmless) {
    const std::string bytes = read_text(path);
    const long before = peak_mebibytes();
    std::mt19937 random(3);
    std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1);
    std::uniform_int_distribution<int> value(0, 255);
    std::uniform_int_distribution<int> count(1, 4);
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string changed = bytes;
        for (int k = count(random); k > 0; --k) changed[place(random)] = static_cast<char>(value(random));
        write_bytes(changed);
        refused += refusal().empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 400); // most bytes are of values, and many values can be
    EXPECT_LT(peak_mebibytes() - before, 50 + sanitizer_keeps);
}

} // namespace
} // namespace abut::test
