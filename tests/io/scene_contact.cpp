/// Contact: how normals and separations are found, and what goes with each.
#include "scene_support.h"

#include "io/render/live_picture.h"
#include "io/render/render_series.h"
#include "scene/validate.h"

namespace abut::scene_test {
namespace {

ContactSpec contact_of(const std::string& json) {
    const std::optional<ContactSpec> contact = load(changed("/contact", json)).scene.contact;
    EXPECT_TRUE(contact) << json;
    return contact.value_or(ContactSpec{});
}

TEST(SceneContact, Words) {
    const std::vector<std::pair<std::string, NormalMethod>> normals{
        {"logistic-regression", NormalMethod::logistic_regression},
        {"linear-regression", NormalMethod::linear_regression},
        {"irls-regression", NormalMethod::irls_regression},
        {"average-gradient", NormalMethod::average_gradient},
        {"maximum-gradient", NormalMethod::maximum_gradient},
        {"maximum-volume", NormalMethod::maximum_volume},
        {"own-gradient", NormalMethod::own_gradient}};
    for (const auto& [word, normal] : normals) EXPECT_EQ(contact_of(R"({"normal": ")" + word + "\"}").normal, normal);
    const std::vector<std::pair<std::string, SeparationMethod>> separations{
        {"particle-edges", SeparationMethod::particle_edges},
        {"critical-position", SeparationMethod::critical_position},
        {"fitted-position", SeparationMethod::fitted_position},
        {"displacement", SeparationMethod::displacement},
        {"none", SeparationMethod::none}};
    for (const auto& [word, separation] : separations)
        EXPECT_EQ(contact_of(R"({"separation": ")" + word + "\"}").separation, separation);
    const std::vector<std::pair<std::string, ThreeOrMore>> nodes{
        {"lumped", ThreeOrMore::lumped}, {"explicit", ThreeOrMore::explicit_}, {"up-to-two", ThreeOrMore::up_to_two}};
    for (const auto& [word, three] : nodes)
        EXPECT_EQ(contact_of(R"({"three_or_more": ")" + word + "\"}").three_or_more, three);
}

/// A live picture of contact needs a scene with contact; which presets show it is known to the pictures.
TEST(SceneContact, LivePresets) {
    const std::string pointer = "/output/live_preset";
    Scene scene = load(changed("/contact/corrections", "1")).scene;
    std::size_t refused = 0;
    for (const std::string& preset : render_presets()) {
        SCOPED_TRACE(preset);
        const auto problems_with = [&](bool live, bool contact) {
            Scene one = scene;
            if (!contact) one.contact.reset();
            one.output.live = live;
            one.output.live_preset = preset;
            std::vector<Problem> problems = validate(one);
            std::erase_if(problems, [&](const Problem& problem) { return problem.pointer != pointer; });
            return problems;
        };
        EXPECT_THAT(problems_with(true, true), testing::IsEmpty());
        EXPECT_THAT(problems_with(false, false), testing::IsEmpty());
        if (LivePicture("live.png", {{0, 0, 0}, {1, 1, 0}}, "", preset, 1).wants_contact()) {
            EXPECT_THAT(problems_with(true, false),
                        testing::ElementsAre(
                            IsProblem(pointer, "\"" + preset + "\" shows contact, of which this scene has none")));
            ++refused;
        } else {
            EXPECT_THAT(problems_with(true, false), testing::IsEmpty());
        }
    }
    EXPECT_EQ(refused, 2U);
}

TEST(SceneContact, SpecifiedNormal) {
    const ContactSpec spec = contact_of(R"({"normal": "specified", "direction": [0, -2]})");
    EXPECT_EQ(spec.normal, NormalMethod::specified);
    EXPECT_EQ(spec.direction, (Vector{0, -2, 0}));
    expect_problems({
        {"/contact", R"({"normal": "specified"})", "/contact/direction", "required and missing"},
        {"/contact", R"({"normal": "specified", "direction": [0, 0]})", "/contact/direction", "must not be zero"},
        {"/contact", R"({"normal": "specified", "direction": [0, 1e-200]})", "/contact/direction", "must not be zero"},
        {"/contact", R"({"normal": "specified", "direction": [0, 0, 1]})", "/contact/direction", "2"},
        {"/contact", R"({"normal": "specified", "direction": "up"})", "/contact/direction", "list"},
        {"/contact", R"({"normal": "specified", "direction": ["1 m", 0]})", "/contact/direction/0", ""},
        {"/contact", R"({"direction": [0, 1]})", "/contact/direction",
         "only goes with \"normal\": \"specified\"; here it is \"logistic-regression\""},
        {"/contact", R"({"normal": "specifed", "direction": [0, 1]})", "/contact/normal", "\"specified\"?"},
    });
}

TEST(SceneContact, FitsOfPositions) {
    EXPECT_EQ(contact_of(R"({"separation": "fitted-position"})").fit, PositionFit::power_law);
    EXPECT_EQ(contact_of(R"({"separation": "fitted-position", "fit": "two-per-cell"})").fit, PositionFit::two_per_cell);
    EXPECT_EQ(contact_of(R"({"separation": "fitted-position", "fit": "one-per-cell"})").fit, PositionFit::one_per_cell);
    EXPECT_EQ(contact_of(R"({"separation": "critical-position", "offset": 1.07})").offset, 1.07);
    expect_problems({
        {"/contact", R"({"fit": "two-per-cell"})", "/contact/fit",
         "only goes with \"separation\": \"fitted-position\""},
        {"/contact", R"({"separation": "fitted-position", "fit": "three"})", "/contact/fit", "unknown word"},
        {"/contact", R"({"separation": "fitted-position", "fit": "one-per-cell", "exponent": 0.6})",
         "/contact/exponent", "only goes with \"fit\": \"power-law\""},
    });
    // The scene as run has all defaults filled in, and can be run again.
    EXPECT_THAT(problems_of(changed("/contact",
                                    R"({"separation": "fitted-position", "fit": "one-per-cell", "exponent": 0.58})")),
                testing::IsEmpty());
}

std::vector<Problem> advice_on(const std::string& contact, const std::string& particles) {
    return advice(load(changed("/bodies/2/particles_per_cell", particles, changed("/contact", contact))).scene);
}

TEST(SceneContact, Advice) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    EXPECT_THAT(advice_on("{}", "3"), IsEmpty());
    EXPECT_THAT(advice_on(R"({"normal": "own-gradient"})", "2"),
                ElementsAre(IsProblem("/contact/normal", "momentum is not conserved")));
    const std::string power = R"({"separation": "fitted-position"})";
    EXPECT_THAT(advice_on(power, "2"), IsEmpty());
    EXPECT_THAT(advice_on(power, "3"), ElementsAre(IsProblem("/bodies/2/particles_per_cell", "2 particles per cell")));
    const std::string offset = R"({"separation": "critical-position"})";
    EXPECT_THAT(advice_on(offset, "2"), IsEmpty());
    EXPECT_THAT(advice_on(offset, "1"), ElementsAre(IsProblem("/bodies/2/particles_per_cell", "offset is for 2")));
    Json scene = parsed(changed("/contact", R"({"separation": "fitted-position", "fit": "one-per-cell"})"));
    for (auto& body : scene["bodies"]) body["particles_per_cell"] = 1;
    for (auto& image : scene["images"]) image["particles_per_cell"] = 1;
    EXPECT_THAT(advice(load(scene.dump()).scene), IsEmpty());
}

} // namespace
} // namespace abut::scene_test
