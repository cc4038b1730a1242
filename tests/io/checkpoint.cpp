/// Checkpoints give back what they were given, bit for bit, appear whole or not at all.
#include "checkpoint_support.h"

#include <gmock/gmock.h>

namespace abut::test {
namespace {

using testing::HasSubstr;

OutputProgress some_progress() {
    OutputProgress output;
    for (std::size_t s = 0; s < 3; ++s)
        output.series[s] = {std::int64_t(s) + 5, 0.1 + double(s), 1.0 / 3 * double(s), 1e-300 * double(s)};
    output.history_every = 0.7;
    output.history_next = 1e300;
    output.history_last = -0.0;
    output.bytes = {std::int64_t{1} << 40, 0, 17};
    return output;
}

/// Written in the middle of a run and read into a new state: the same then, and some steps later.
template <int D>
void expect_goes_on(const Case& c, int before) {
    const TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    State<D> whole = state_after<D>(c, before);
    const OutputProgress output = some_progress();
    write_checkpoint(path, whole, output, R"({"title": "µ"})", 0xfedcba9876543210U);

    State<D> resumed = make_state<D>(c.scene, c.model);
    const OutputProgress found = read_checkpoint(path, resumed);
    expect_same(whole, resumed, c.name + ", read");
    advance_by(whole, 12);
    advance_by(resumed, 12);
    expect_same(whole, resumed, c.name + ", later");

    for (std::size_t s = 0; s < 3; ++s) {
        EXPECT_EQ(found.series[s].frames, output.series[s].frames);
        EXPECT_EQ(found.series[s].last_time, output.series[s].last_time);
        EXPECT_EQ(found.series[s].every, output.series[s].every);
        EXPECT_EQ(found.series[s].next, output.series[s].next);
    }
    EXPECT_EQ(found.history_every, output.history_every);
    EXPECT_EQ(found.history_next, output.history_next);
    EXPECT_TRUE(std::signbit(found.history_last));
    EXPECT_EQ(found.bytes, output.bytes);
    const CheckpointHead head = read_checkpoint_head(path);
    EXPECT_EQ(head.resolved_scene, R"({"title": "µ"})");
    EXPECT_EQ(head.checksum, 0xfedcba9876543210U);
    EXPECT_EQ(head.step, before);
    EXPECT_GT(head.time, 0);
}

TEST(Checkpoint, GivesEveryValueBackAndRunsOnAlike) {
    for (const Case& c : plane_cases()) expect_goes_on<2>(c, 17);
}

TEST(Checkpoint, GivesEveryValueBackInSpace) {
    expect_goes_on<3>(two_cubes(), 11);
}

TEST(Checkpoint, CasesHoldWhatTheyAreNamedFor) {
    std::map<std::string, State<2>> states;
    for (const Case& c : plane_cases()) states.emplace(c.name, state_after<2>(c, 17));
    EXPECT_FALSE(states.at("friction").pair_totals.empty());
    EXPECT_NE(states.at("friction").boundaries[0].impulse[1], 0);
    EXPECT_FALSE(states.at("plane stress").particles.across.empty());
    EXPECT_FALSE(states.at("rings").particles.across.empty());
    EXPECT_NE(states.at("springs").ledger.interface_energy, 0);
    EXPECT_NE(states.at("periodic fmpm").since_transfer, 0);
    EXPECT_FALSE(states.at("tractions").traction_faces.empty());
    EXPECT_FALSE(states.at("rigid").rigid_totals.empty());
    EXPECT_FALSE(states.at("prestress").particles.prestress.empty());
    bool reordered = false;
    const auto& ids = states.at("friction").particles.id;
    for (std::size_t p = 0; p < ids.size(); ++p) reordered |= ids[p] != std::int32_t(p);
    EXPECT_TRUE(reordered);
}

TEST(Checkpoint, IsReadIntoAStateThatHasRunOn) {
    const TemporaryFolder folder;
    const Case c = plane_cases().front();
    State<2> state = state_after<2>(c, 9);
    write_checkpoint(folder / "a.h5", state, {}, "{}", 0);
    const State<2> then = state;
    advance_by(state, 60);
    read_checkpoint(folder / "a.h5", state);
    expect_same(then, state, "gone back");
}

TEST(Checkpoint, BeforeTheFirstStep) {
    const TemporaryFolder folder;
    const Case c = plane_cases().front();
    State<2> fresh = make_state<2>(c.scene, c.model);
    write_checkpoint(folder / "a.h5", fresh, {}, "{}", 0);
    State<2> read = make_state<2>(c.scene, c.model);
    read_checkpoint(folder / "a.h5", read);
    advance_by(fresh, 3);
    advance_by(read, 3);
    expect_same(fresh, read, "three steps");
}

TEST(Checkpoint, WithoutASetbackNoneIsRead) {
    const TemporaryFolder folder;
    const Case c = plane_cases().front();
    State<2> state = state_after<2>(c, 3);
    state.setback.reset();
    write_checkpoint(folder / "a.h5", state, {}, "{}", 0);
    State<2> read = state_after<2>(c, 5); // has one
    read_checkpoint(folder / "a.h5", read);
    EXPECT_FALSE(read.setback.has_value());
    expect_same(state, read, "without");
}

TEST(Checkpoint, ReplacesTheOneBeforeTheLast) {
    const TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    State<2> state = state_after<2>(plane_cases().front(), 1);
    for (int i = 0; i < 4; ++i) {
        write_checkpoint(path, state, {}, "{}", 0);
        EXPECT_EQ(read_checkpoint_head(path).step, i + 1);
        if (i > 0) {
            EXPECT_EQ(read_checkpoint_head(previous_checkpoint(path)).step, i);
        }
        advance_by(state, 1);
    }
    EXPECT_EQ(folder.count(), 2U);
}

TEST(Checkpoint, AFullDiskLeavesTheOldFiles) {
    const TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    State<2> state = state_after<2>(plane_cases().front(), 1);
    for (int i = 0; i < 2; ++i) {
        write_checkpoint(path, state, {}, "{}", 0);
        advance_by(state, 1);
    }
    const std::string last = read_text(path);
    const std::string previous = read_text(previous_checkpoint(path));
    for (const std::size_t room :
         {std::size_t{0}, std::size_t{1}, std::size_t{96}, std::size_t{2048}, last.size() / 2, last.size() - 1}) {
        const DiskLimit full(room);
        EXPECT_THAT(error_of([&] { write_checkpoint(path, state, {}, "{}", 0); }),
                    HasSubstr("checkpoint.h5: cannot write"))
            << room;
        EXPECT_TRUE(read_text(path) == last) << room;
        EXPECT_TRUE(read_text(previous_checkpoint(path)) == previous) << room;
        EXPECT_EQ(folder.count(), 2U) << room;
    }
    write_checkpoint(path, state, {}, "{}", 0); // there is room again
    EXPECT_EQ(read_checkpoint_head(path).step, 3);
    EXPECT_TRUE(read_text(previous_checkpoint(path)) == last);
}

TEST(Checkpoint, NoSuchFolderIsSaid) {
    const TemporaryFolder folder;
    State<2> state = state_after<2>(plane_cases().front(), 1);
    EXPECT_THAT(error_of([&] { write_checkpoint(folder / "nowhere/a.h5", state, {}, "{}", 0); }),
                testing::AllOf(HasSubstr("nowhere/a"), HasSubstr("cannot write: No such file")));
}

TEST(ModelChecksum, TellsModelsApart) {
    const Model model = two_blocks("").model;
    const std::uint64_t sum = model_checksum(model);
    EXPECT_EQ(model_checksum(Model(model)), sum);
    const auto changed = [&](auto&& change) {
        Model other = model;
        change(other);
        return model_checksum(other);
    };
    EXPECT_NE(changed([](Model& m) { m.bodies[0].name = "lowe"; }), sum);
    EXPECT_NE(changed([](Model& m) { m.position[3][1] = std::nextafter(m.position[3][1], 9); }), sum);
    EXPECT_NE(changed([](Model& m) { m.half_size[7][0] *= 2; }), sum);
    EXPECT_NE(changed([](Model& m) { m.body.back() = 0; }), sum);
    EXPECT_NE(changed([](Model& m) { m.angle.assign(m.size(), 0.0); }), sum);
    EXPECT_NE(changed([](Model& m) { m.temperature.assign(m.size(), 300.0); }), sum);
    EXPECT_NE(changed([](Model& m) { m.orientation.assign(m.size(), 1.0); }), sum);
    EXPECT_NE(changed([](Model& m) { std::swap(m.position[0], m.position[1]); }), sum);
}

} // namespace
} // namespace abut::test
