/// The schema and the reference page against the reader.
#include "scene_schema_rules.h"
#include "scene_support.h"

#include "io/scene/check.h"
#include "io/scene/specification.h"

#include <random>

namespace abut::scene_test {
namespace {

/// What the schema says at a path of the table.
const Json* schema_at(const Json& schema, const std::string& path) {
    const Json* place = &schema;
    for (std::size_t begin = 1; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string token = path.substr(begin, end - begin);
        place = token == "#"   ? find(*place, "items")
                : token == "*" ? find(*place, "additionalProperties")
                               : find((*place)["properties"], token);
        if (!place) return nullptr;
        begin = end + 1;
    }
    return place;
}

TEST(SceneSchema, HasEveryKeyOfTheTable) {
    const Json schema = parsed(scene_schema());
    EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    for (const Key& key : scene_keys()) {
        const Json* place = schema_at(schema, key.path);
        ASSERT_EQ(place != nullptr, key.kind != Kind::later) << key.path;
        if (!place) continue;
        EXPECT_THAT((*place)["description"].get<std::string>(), testing::StartsWith(key.meaning)) << key.path;
        EXPECT_TRUE(key.kind != Kind::object || (*place)["additionalProperties"] == false) << key.path;
        EXPECT_TRUE(!key.otherwise || conforms(Json::parse(*key.otherwise), *place)) << key.path;
    }
}

TEST(SceneTable, IsWellFormed) {
    for (const Key& key : scene_keys()) {
        EXPECT_THAT(key.meaning, testing::AllOf(testing::Not(testing::IsEmpty()), testing::EndsWith("."))) << key.path;
        EXPECT_FALSE(key.required && key.otherwise) << key.path;
        EXPECT_TRUE(key.kind == Kind::function || (key.kind == Kind::word) == !key.words.empty()) << key.path;
    }
    const auto has_key = [](const auto& self, const SpecificationNode& node) -> bool {
        return node.key && std::all_of(node.children.begin(), node.children.end(),
                                       [&](const SpecificationNode& child) { return self(self, child); });
    };
    EXPECT_TRUE(has_key(has_key, scene_specification())); // a path with a mistyped parent would leave a hole
}

/// The example with every contact law and with rigid bodies.
Json scene_of_laws() {
    Json scene = parsed(example);
    scene["contact"]["law"] =
        parsed(R"({"type": "friction", "coefficient": 0.2, "static_coefficient": 0.3, "decay_velocity": "1 m/s",
                   "contact_stiffness": "2 GPa/mm"})");
    scene["contact"]["rigid_bias"] = 2;
    const auto add = [&](const char* law) {
        scene["contact"]["laws"].push_back({{"bodies", {"block", "egg"}}, {"law", parsed(law)}});
    };
    add(R"({"type": "frictionless", "contact_stiffness": 1e9})");
    add(R"({"type": "viscous-friction", "coefficient": 0, "viscosity": "10 Pa*s/mm"})");
    add(R"({"type": "adhesion", "coefficient": 0.1, "strength": "1 MPa", "shear_strength": 2e6, "reach": 0.05})");
    add(R"({"type": "linear-interface", "normal_stiffness": "1 TPa/m", "tangential_stiffness": 0})");
    add(R"({"type": "bilinear-interface", "tension_stiffness": 0, "tangential_stiffness": 1,
            "compression_stiffness": "1 MPa/um"})");
    add(R"({"type": "cohesive-interface", "strength": "1 MPa", "shear_strength": 1e6, "opening": "1 um",
            "sliding": "2 um", "compression_stiffness": 1e12})");
    scene["bodies"][1].erase("material"); // it has no initial velocity
    scene["bodies"][1]["rigid"] = parsed(R"({"velocity": ["1 m/s", {"times": [0, 1e-6], "values": [0, 1]}],
                                              "angular_velocity": "30 deg/s", "center": [0, "1 mm"]})");
    scene["images"][0]["legend"][1].erase("material");
    scene["images"][0]["legend"][1].erase("velocity");
    scene["images"][0]["legend"][1]["rigid"] = Json::object();
    scene["output"]["pairs"] = false;
    return scene;
}

/// Good scenes that together use every key.
std::vector<Json> good_scenes() {
    std::vector<Json> scenes{parsed(example)};
    Json other = parsed(example);
    other["time"] = parsed(R"({"end": 1e-5, "step": 1e-9})");
    other["contact"] = parsed(R"({"separation": "fitted-position", "exponent": 0.6, "law": {"type": "stick"}})");
    other["method"] = parsed(R"({"transfer": {"scheme": "pic"}})");
    other["grid"]["cell"] = parsed(R"(["10 um", "10 um"])");
    scenes.push_back(other);
    scenes.push_back(scene_of_laws());
    scenes.push_back(parsed(example_3d));
    scenes.push_back(parsed(example_axisymmetric));
    scenes.push_back(parsed(load(example).resolved));
    other.erase("contact");
    other.erase("images");
    scenes.push_back(parsed(load(other.dump()).resolved));
    return scenes;
}

/// Whether the reader finds nothing wrong but what a schema cannot say: that two lists go together, and how numbers
/// follow each other.
bool reader_accepts(const Json& scene) {
    const std::vector<Problem> problems = check_scene(scene).problems;
    return std::all_of(problems.begin(), problems.end(), [](const Problem& problem) {
        return problem.message.starts_with("as many values as times are needed") ||
               problem.message.starts_with("must be later than the time before");
    });
}

using Pointer = Json::json_pointer;

void collect(const Json& value, const Pointer& at, std::vector<Pointer>& pointers) {
    pointers.push_back(at);
    if (value.is_object())
        for (const auto& [key, member] : value.items()) collect(member, at / key, pointers);
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], at / i, pointers);
}

std::vector<Pointer> all_pointers(const Json& scene) {
    std::vector<Pointer> pointers;
    collect(scene, Pointer(), pointers);
    return pointers;
}

const std::vector<Json> wrong_values{nullptr,
                                     true,
                                     false,
                                     3,
                                     -1,
                                     0,
                                     0.5,
                                     1000,
                                     "text",
                                     "",
                                     "#00ff00",
                                     "none",
                                     "xpic",
                                     Json::array(),
                                     Json::array({1, 2}),
                                     Json::array({0, 1, 2}),
                                     "axisymmetric",
                                     Json{{"times", {0, 1}}, {"values", {2, 3}}},
                                     Json{{"pulse", {{"width", 1}, {"peak", -1}}}},
                                     Json::array({"a", "b"}),
                                     Json::object()};

/// One random change: a value replaced, a key removed, an unknown or a misplaced key added.
void mutate(Json& scene, std::mt19937& random) {
    const std::vector<Pointer> pointers = all_pointers(scene);
    const auto pick = [&random](const auto& list) { return list[random() % list.size()]; };
    const Pointer at = pick(pointers);
    Json& value = scene[at];
    static const std::vector<std::string> extra{"unknown",   "step",         "cfl",      "order",     "offset",
                                                "exponent",  "coefficient",  "disk",     "size",      "rgb",
                                                "velocity",  "bulk_modulus", "wall",     "later",     "ball",
                                                "thickness", "rigid",        "material", "strength",  "center",
                                                "reach",     "images",       "position", "every_cfl", "velocity_center",
                                                "traction",  "pressure",     "pulse",    "times"};
    if (random() % 2 == 0 && value.is_object()) {
        value[pick(extra)] = pick(wrong_values);
    } else if (random() % 2 == 0 && !at.empty() && scene[at.parent_pointer()].is_object()) {
        scene[at.parent_pointer()].erase(at.back());
    } else {
        value = pick(wrong_values);
    }
}

TEST(SceneSchema, AgreesWithTheReaderOnGoodScenes) {
    const Json schema = parsed(scene_schema());
    for (const Json& scene : good_scenes()) {
        EXPECT_TRUE(conforms(scene, schema));
        EXPECT_TRUE(reader_accepts(scene));
    }
}

TEST(SceneSchema, AgreesWithTheReaderOnEverySingleChange) {
    const Json schema = parsed(scene_schema());
    int refused = 0;
    for (const Json& good : good_scenes()) {
        for (const Pointer& at : all_pointers(good)) {
            std::vector<Json> scenes;
            for (const Json& wrong : wrong_values) {
                scenes.push_back(good);
                scenes.back()[at] = wrong;
            }
            if (good[at].is_object()) {
                scenes.push_back(good);
                scenes.back()[at]["unknown"] = 1;
            }
            if (!at.empty()) {
                scenes.push_back(good);
                Json& parent = scenes.back()[at.parent_pointer()];
                if (parent.is_object()) parent.erase(at.back());
            }
            for (const Json& scene : scenes) {
                EXPECT_EQ(conforms(scene, schema), reader_accepts(scene)) << at.to_string() << "\n"
                                                                          << in_lines(check_scene(scene).problems);
                refused += reader_accepts(scene) ? 0 : 1;
            }
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(SceneSchema, AgreesWithTheReaderOnEveryAnalysis) {
    const Json schema = parsed(scene_schema());
    for (const Json& good : good_scenes()) {
        int accepted = 0;
        for (const char* analysis : {"plane-strain", "plane-stress", "axisymmetric", "3d"}) {
            Json scene = good;
            scene["analysis"] = analysis;
            EXPECT_EQ(conforms(scene, schema), reader_accepts(scene))
                << analysis << in_lines(check_scene(scene).problems);
            accepted += reader_accepts(scene) ? 1 : 0;
        }
        EXPECT_GE(accepted, 1);
        EXPECT_LE(accepted, 3); // no scene is both plane and 3d
    }
}

TEST(SceneSchema, AgreesWithTheReaderOnRandomChanges) {
    const Json schema = parsed(scene_schema());
    const std::vector<Json> scenes = good_scenes();
    std::mt19937 random(2024); // NOLINT: the same scenes in every run
    int accepted = 0;
    for (int i = 0; i < 3000; ++i) {
        Json scene = scenes[random() % scenes.size()];
        for (unsigned changes = 1 + random() % 3; changes > 0; --changes) mutate(scene, random);
        ASSERT_EQ(conforms(scene, schema), reader_accepts(scene))
            << scene.dump(2) << in_lines(check_scene(scene).problems);
        accepted += reader_accepts(scene) ? 1 : 0;
    }
    EXPECT_GT(accepted, 50);
    EXPECT_LT(accepted, 2500);
}

TEST(SceneReference, NamesEveryKey) {
    const std::string page = scene_reference();
    for (const Key& key : scene_keys()) {
        const std::string name = key.path.substr(key.path.rfind('/') + 1);
        if (key.path.empty() || name == "*" || name == "#" || key.kind == Kind::later) continue;
        EXPECT_THAT(page, testing::HasSubstr("| `" + name + "` |")) << key.path;
        EXPECT_THAT(page, testing::HasSubstr(key.meaning)) << key.path;
        for (const std::string& word : key.later_words) EXPECT_THAT(page, testing::HasSubstr("`" + word + "`"));
    }
    EXPECT_THAT(page, testing::HasSubstr("## `/materials/NAME`"));
    EXPECT_THAT(page, testing::HasSubstr("| `density` | kg/m^3, greater than 0 | **required** |"));
}

} // namespace
} // namespace abut::scene_test
