/// Methods, boundaries and analyses that don't go together: a message that names file, place and cause, exit code 2,
/// and nothing written.
#include "app_support.h"

namespace abut::app_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The scene must be refused with one line that begins with the place and contains the cause.
void expect_refused(const std::vector<std::string>& patches, const std::string& place, const std::string& cause) {
    const Folder folder;
    folder.write("bad.json", small_scene(patches).dump(2));
    const auto before = folder.content();
    for (const char* command : {"run", "check"}) {
        const Outcome outcome = folder.abut({command, "bad.json"});
        EXPECT_EQ(outcome.exit_code, 2) << place;
        std::vector<std::string> errors;
        for (const std::string& line : lines(outcome.err))
            if (line.find(": advice: ") == std::string::npos) errors.push_back(line);
        ASSERT_EQ(errors.size(), 1u) << outcome.err;
        EXPECT_THAT(errors[0], StartsWith("bad.json: " + place + ": "));
        EXPECT_THAT(errors[0], HasSubstr(cause));
        EXPECT_EQ(folder.content(), before);
    }
}

TEST(BadMethod, OrderBelowOneOrAbsurd) {
    for (const char* order : {"0", "-3", "1000"})
        expect_refused({std::string(R"({"method": {"transfer": {"scheme": "fmpm", "order": )") + order + "}}}"},
                       "/method/transfer/order", "must be between 1 and 100");
}

TEST(BadMethod, OrderThatIsNoNumber) {
    expect_refused({R"({"method": {"transfer": {"scheme": "fmpm", "order": 2.5}}})"}, "/method/transfer/order",
                   "a whole number is needed");
}

TEST(BadMethod, PeriodicTransferMoreOftenThanSteps) {
    expect_refused({R"({"time": {"cfl": 0.3}, "method": {"transfer": {"every_cfl": 0.2}}})"},
                   "/method/transfer/every_cfl", "0.3");
    expect_refused({R"({"time": {"step": "2 us"}, "method": {"transfer": {"every_cfl": 0.05}}})"},
                   "/method/transfer/every_cfl", "less than a time step");
}

TEST(BadMethod, FixedStepAboveWhatFmpmTakes) {
    // Stable for FLIP: a crossing takes 8.2 us.
    expect_refused({R"({"time": {"step": "3 us"}, "method": {"transfer": {"scheme": "fmpm", "order": 16}}})"},
                   "/time/step", "is above the stable step");
}

TEST(BadMethod, RulesOfOtherSchemes) {
    expect_refused({R"({"method": {"transfer": {"scheme": "xpic", "position": "mean-velocity"}}})"},
                   "/method/transfer/position", "mean-velocity");
    expect_refused({R"({"method": {"velocity_conditions": "lumped"}})"}, "/method/velocity_conditions", "fmpm");
}

TEST(BadAnalysis, PlaneStressNeedsAShearModulus) {
    expect_refused({R"({"analysis": "plane-stress", "materials": {"rubber": {"youngs_modulus": null,
                        "poissons_ratio": null, "bulk_modulus": "10 MPa", "shear_modulus": 0}}})"},
                   "/materials/rubber", "shear");
}

TEST(BadAnalysis, AxisymmetricScenesHaveNoNegativeRadius) {
    expect_refused({R"({"analysis": "axisymmetric", "gravity": null, "grid": {"lower": ["-2 mm", 0]}})"}, "/grid/lower",
                   "must not be negative");
    expect_refused({R"({"analysis": "axisymmetric", "gravity": ["1 m/s^2", 0]})"}, "/gravity/0", "");
}

TEST(BadAnalysis, BodiesOfOtherDimensions) {
    expect_refused({R"({"bodies": [{"name": "ball", "material": "rubber",
                        "ball": {"center": ["6 mm", "6 mm"], "radius": "2 mm"}}]})"},
                   "/bodies/0/ball", "3d");
}

/// The boundaries of a scene in which nothing else moves.
std::vector<std::string> still(const std::string& boundaries) {
    return {R"({"gravity": null, "contact": null, "bodies": [{"name": "block", "material": "rubber",
                "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "4 mm"]}}], "boundaries": [)" +
            boundaries + "]}"};
}

TEST(BadBoundary, WallThatGripsNothing) {
    expect_refused(still(R"({"name": "roof", "wall": {"axis": "y", "side": "upper", "position": "9 mm"}})"),
                   "/boundaries/0/wall", "the wall grips nothing");
}

TEST(BadBoundary, WallWithAllMaterialBehindIt) {
    expect_refused(still(R"({"name": "roof", "wall": {"axis": "y", "side": "lower", "position": "9 mm"}})"),
                   "/boundaries/0/wall/side", "all material lies behind the wall");
}

TEST(BadBoundary, TractionOnABodyWithoutSuchAFace) {
    expect_refused(still(R"({"name": "pull", "traction": {"body": "block", "axis": "x", "side": "upper",
                             "pressure": "1 MPa", "within": {"lower": [0, 0], "upper": ["3 mm", "4 mm"]}}})"),
                   "/boundaries/0/traction", "body \"block\" has no such face within the given box");
}

TEST(BadBoundary, TractionOnAnUnknownBody) {
    expect_refused(still(R"({"name": "pull", "traction": {"body": "blok", "axis": "x", "side": "upper",
                             "pressure": "1 MPa"}})"),
                   "/boundaries/0/traction/body", "did you mean \"block\"?");
}

TEST(BadBoundary, FunctionOfTimeThatGoesBack) {
    expect_refused(still(R"({"name": "roof", "wall": {"axis": "y", "side": "lower", "position": 0,
                             "velocity": {"times": [0, "1 ms", "0.5 ms"], "values": [0, "1 m/s", 0]}}})"),
                   "/boundaries/0/wall/velocity/times/2", "");
}

} // namespace
} // namespace abut::app_test
