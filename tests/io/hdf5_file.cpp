/// Named arrays in HDF5 files; files that claim what they have not.
#include "checkpoint_support.h"

#include <gmock/gmock.h>

#include <limits>

namespace abut::test {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

TEST(Hdf5File, GivesBackWhatItWasGiven) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    const std::vector<double> reals{0.1, -0.0, 5e-324, 1.7976931348623157e308, std::numeric_limits<double>::infinity(),
                                    3};
    const std::vector<std::int64_t> integers{std::numeric_limits<std::int64_t>::min(), -1,
                                             std::numeric_limits<std::int64_t>::max()};
    Hdf5Writer writer(path, path);
    writer.reals("group/inner/reals", reals, {2, 3});
    writer.integers("group/integers", integers, {3});
    writer.text("text", std::string("a\0µ", 4));
    writer.reals("none", {}, {0, 3});
    writer.text("no text", "");
    writer.close();

    const Hdf5Reader reader(path);
    EXPECT_THAT(reader.reals("group/inner/reals", {2, 3}), ElementsAreArray(reals));
    EXPECT_TRUE(std::signbit(reader.reals("group/inner/reals", {2, 3})[1]));
    EXPECT_EQ(reader.rows("group/inner/reals", 3, 2), 2U);
    EXPECT_EQ(reader.integers("group/integers", {3}), integers);
    EXPECT_EQ(reader.text("text", 4), std::string("a\0µ", 4));
    EXPECT_TRUE(reader.reals("none", {0, 3}).empty());
    EXPECT_EQ(reader.text("no text", 10), "");
    EXPECT_TRUE(reader.has("group/inner/reals"));
    for (const char* name : {"group/inner/other", "other/inner/reals", "text/inner", "/", ""})
        EXPECT_FALSE(reader.has(name)) << name;
    EXPECT_THAT(error_of([&] { reader.reals("group", {1}); }), HasSubstr("a.h5"));
    EXPECT_THAT(error_of([&] { reader.reals("group/inner/reals", {3, 2}); }), HasSubstr("2 x 3 instead of 3 x 2"));
    EXPECT_THAT(error_of([&] { reader.rows("group/inner/reals", 3, 1); }), HasSubstr("which cannot be"));
    EXPECT_THAT(error_of([&] { reader.text("text", 3); }), HasSubstr("which cannot be"));
}

TEST(Hdf5File, ValuesThatDoNotFitTheShapeAreAMistakeOfTheCaller) {
    const TemporaryFolder folder;
    Hdf5Writer writer(folder / "a.h5", "a.h5");
    EXPECT_THROW(writer.reals("a", std::vector<double>(5), {2, 3}), std::invalid_argument);
    EXPECT_THROW(writer.integers("b", std::vector<std::int64_t>(5), {6}), std::invalid_argument);
}

/// A file with one array "a" of `count` reals, made as `creation` says, without values.
std::filesystem::path odd_file(const TemporaryFolder& folder, hsize_t count, hid_t type, hid_t creation) {
    const auto path = folder / "odd.h5";
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t data = H5Dcreate2(file, "a", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    H5Dclose(data);
    H5Sclose(space);
    H5Pclose(creation);
    H5Fclose(file);
    return path;
}

TEST(Hdf5File, OnlyValuesThatStandInTheFileAreRead) {
    const TemporaryFolder folder;
    const auto refusal = [&](hsize_t count, hid_t type, hid_t creation) {
        const auto path = odd_file(folder, count, type, creation);
        const Hdf5Reader reader(path);
        return error_of([&] { reader.reals("a", {static_cast<std::size_t>(count)}); });
    };
    EXPECT_THAT(refusal(8, H5T_NATIVE_DOUBLE, H5Pcreate(H5P_DATASET_CREATE)), HasSubstr("are not in the file"))
        << "HDF5 would fill it";
    hsize_t chunk = 1000000;
    hid_t packed = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(packed, 1, &chunk);
    H5Pset_deflate(packed, 9);
    EXPECT_THAT(refusal(1000000, H5T_NATIVE_DOUBLE, packed), HasSubstr("are not in the file"));
    hid_t elsewhere = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(elsewhere, "/etc/passwd", 0, 64);
    EXPECT_THAT(refusal(8, H5T_NATIVE_DOUBLE, elsewhere), HasSubstr("are not in the file"));
    EXPECT_THAT(refusal(8, H5T_NATIVE_FLOAT, H5Pcreate(H5P_DATASET_CREATE)), HasSubstr("another type"));
    EXPECT_THAT(refusal(8, H5T_IEEE_F64BE, H5Pcreate(H5P_DATASET_CREATE)), HasSubstr("another type"));
    EXPECT_THAT(refusal(8, H5T_NATIVE_UINT64, H5Pcreate(H5P_DATASET_CREATE)), HasSubstr("another type"));
}

TEST(Hdf5File, LinksToOtherFilesAreNoArrays) {
    const TemporaryFolder folder;
    const auto path = folder / "a.h5";
    {
        Hdf5Writer other(folder / "other.h5", "other.h5");
        other.reals("a", std::vector<double>{1}, {1});
        other.close();
    }
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_external((folder / "other.h5").c_str(), "a", file, "a", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/b", file, "b", H5P_DEFAULT, H5P_DEFAULT); // to itself
    H5Fclose(file);
    const Hdf5Reader reader(path);
    EXPECT_THAT(error_of([&] { reader.reals("a", {1}); }), HasSubstr("a.h5"));
    EXPECT_THAT(error_of([&] { reader.reals("b", {1}); }), HasSubstr("a.h5"));
}

} // namespace
} // namespace abut::test
