// Random damage to small files of every format: a closed surface or an error, and not a word on stderr.
#include "geometry/packing/random.h"
#include "geometry/shapes/check_surface.h"
#include "sanitizer_memory.h"
#include "surface_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

using namespace test; // NOLINT(google-build-using-namespace)

namespace {

Bytes damaged(Bytes bytes, abut::Random& random) {
    const auto place = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(bytes.size()))); };
    const int changes = 1 + random.below(4);
    for (int change = 0; change < changes && bytes.size() > 4; ++change) switch (random.below(7)) {
        case 0:
            bytes[place()] = static_cast<std::uint8_t>(random.below(256));
            break;
        case 1:
            bytes[place()] ^= static_cast<std::uint8_t>(1 << random.below(8));
            break;
        case 2:
            bytes.resize(place() + 1);
            break;
        case 3:
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(place()));
            break;
        case 4:
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place()), "0123456789-.e \n"[random.below(15)]);
            break;
        case 5: { // digits are the usual victims
            const std::size_t at = place();
            for (std::size_t i = at; i < bytes.size(); ++i)
                if (bytes[i] >= '0' && bytes[i] <= '9') {
                    bytes[i] = static_cast<std::uint8_t>('0' + random.below(10));
                    break;
                }
            break;
        }
        default: { // a piece moves
            const std::size_t from = place(), to = place(),
                              length = std::min<std::size_t>(16, bytes.size() - std::max(from, to));
            std::copy_n(Bytes(bytes).begin() + static_cast<std::ptrdiff_t>(from), length,
                        bytes.begin() + static_cast<std::ptrdiff_t>(to));
        }
        }
    return bytes;
}

/// Reads `count` damaged files of every format. Returns how many were surfaces all the same.
int attack(int count, bool repair, std::uint64_t seed) {
    abut::Random random(seed);
    const std::vector<Faces> meshes{faces_of(tetrahedron()), quad_cube(), faces_of(icosphere(0)),
                                    faces_of(together(cube(), cube({0.5, 0.25, 0.125})))};
    const Folder folder;
    int good = 0, written = 0; // files are not written over: some file systems then wait for the disk
    for (int i = 0; i < count; ++i)
        for (const Faces& mesh : meshes)
            for (const auto& [name, bytes] : every_format(mesh)) {
                if (name == "binary.stl" && mesh.faces[0].size() != 3) continue;
                const Bytes file = damaged(bytes, random);
                abut::Surface spec;
                spec.repair = repair;
                const auto path = folder.write(
                    "damaged" + std::to_string(written++) + std::filesystem::path(name).extension().string(), file);
                try {
                    const abut::RepairedMesh result = abut::read_surface(spec, path);
                    EXPECT_TRUE(abut::surface_problems(result.mesh).empty()) << name;
                    EXPECT_GT(volume(result.mesh), 0);
                    ++good;
                } catch (const std::runtime_error& error) {
                    EXPECT_THAT(error.what(), testing::HasSubstr("damaged"));
                }
                if (testing::Test::HasFailure()) {
                    std::filesystem::copy_file(path, std::filesystem::temp_directory_path() / ("abut-hostile-" + name),
                                               std::filesystem::copy_options::overwrite_existing);
                    return good;
                }
            }
    return good;
}

} // namespace

TEST(SurfaceHostile, Counts) {
    for (const char* count : {"2000000000", "99999999999999999999", "-1", "4294967295", "1e9"}) {
        const std::string c = count;
        EXPECT_NE(complaint(bytes_of("OFF\n" + c + " 1 0\n0 0 0\n")), "");
        EXPECT_NE(complaint(bytes_of("OFF\n3 " + c + " 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")), "");
        EXPECT_NE(complaint(bytes_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + c + " 0 1 2\n")), "");
        EXPECT_NE(complaint(bytes_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + c + "\n")), "");
        EXPECT_NE(complaint(bytes_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + c + "\n"), "a.obj"), "");
        for (const char* format : {"ascii", "binary_little_endian"})
            for (const char* element : {"vertex", "face", "other"})
                EXPECT_NE(
                    complaint(bytes_of(std::string("ply\nformat ") + format + " 1.0\nelement " + element + " " + c +
                                       "\nproperty float x\nproperty float y\nproperty float z\nproperty list uint int "
                                       "vertex_indices\nend_header\n0 0 0 \n"),
                              "a.ply"),
                    "");
    }
    Bytes stl = stl_binary(faces_of(cube()));
    stl[80] = stl[81] = stl[82] = stl[83] = 0xff;
    EXPECT_THAT(complaint(stl, "a.stl"), testing::HasSubstr("4294967295 triangles"));
    // An element without properties would take no bytes at all.
    EXPECT_NE(
        complaint(
            bytes_of("ply\nformat ascii 1.0\nelement x 2000000000\nelement vertex 0\nproperty float x\nproperty "
                     "float y\nproperty float z\nelement face 0\nproperty list int int vertex_index\nend_header\n"),
            "a.ply"),
        "");
}

TEST(SurfaceHostile, DamagedFilesAreSurfacesOrErrors) {
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const int good = attack(150, false, 1);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_GT(good, 100);
    EXPECT_LT(good, 150 * 27);
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, (200 + sanitizer_keeps) * 1024) << "KiB";
}

TEST(SurfaceHostile, DamagedFilesAreRepairedOrRefused) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const int good = attack(40, true, 2);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_GT(good, 100);
}
