#include "base/hdf5_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "base/result_dir.h"
#include "scratch_dir.h"

namespace phs {
namespace {

using ::testing::HasSubstr;

const std::vector<Channel> kChannels = {{"z_m", "m", "height"}, {"a_N", "N", ""}};

/// Values with all their bits in use.
double Sample(int row, int channel) { return std::sin(0.37 * row + channel) / 3; }

Status WriteRows(const std::string& path, int rows) {
  auto writer = SeriesWriter::Create(path, kChannels);
  if (!writer.ok()) return writer.error();
  if (Status s = writer.value().Note("scenario", "curve_r550"); !s.ok()) return s;
  for (int i = 0; i < rows; ++i) {
    const double row[] = {Sample(i, 0), Sample(i, 1)};
    if (Status s = writer.value().Append(row); !s.ok()) return s;
  }
  return writer.value().Close();
}

class SeriesRows : public ::testing::TestWithParam<int> {};

TEST_P(SeriesRows, ReadBackToTheBit) {
  const ScratchDir scratch;
  ASSERT_TRUE(WriteRows(scratch.File("s.h5"), GetParam()).ok());
  auto series = ReadSeries(scratch.File("s.h5"));
  ASSERT_TRUE(series.ok()) << series.error().Line();
  ASSERT_EQ(series.value().channels.size(), 2u);
  EXPECT_EQ(series.value().channels[0].name, "z_m") << "order of writing, not of the alphabet";
  EXPECT_EQ(series.value().channels[0].unit, "m");
  EXPECT_EQ(series.value().channels[0].description, "height");
  EXPECT_EQ(series.value().channels[1].description, "");
  EXPECT_EQ(series.value().Find("a_N"), 1);
  EXPECT_EQ(series.value().Find("b_N"), -1);
  EXPECT_EQ(series.value().notes.at("scenario"), "curve_r550");
  for (int channel = 0; channel < 2; ++channel) {
    const auto& column = series.value().columns[static_cast<size_t>(channel)];
    ASSERT_EQ(column.size(), static_cast<size_t>(GetParam()));
    for (int i = 0; i < GetParam(); ++i) {
      ASSERT_EQ(column[static_cast<size_t>(i)], Sample(i, channel)) << i;
    }
  }
}

// None, one, a block less one, a block, a block more one, several blocks.
INSTANTIATE_TEST_SUITE_P(Blocks, SeriesRows, ::testing::Values(0, 1, 1023, 1024, 1025, 5000));

TEST(Series, EqualRunsGiveEqualBytes) {
  const ScratchDir scratch;
  ASSERT_TRUE(WriteRows(scratch.File("a.h5"), 3000).ok());
  ASSERT_TRUE(WriteRows(scratch.File("b.h5"), 3000).ok());
  EXPECT_TRUE(ReadFile(scratch.File("a.h5")).value() == ReadFile(scratch.File("b.h5")).value());
}

TEST(Series, Messages) {
  const ScratchDir scratch;
  EXPECT_THAT(
      WriteRows(scratch.File("no/s.h5"), 1).error().Line(),
      HasSubstr("s.h5: cannot be written (No such file or directory); allowed: a place with "
                "room that can be written"));
  EXPECT_THAT(
      SeriesWriter::Create(scratch.File("t.h5"), {{"x", "m", ""}, {"x", "m", ""}}).error().Line(),
      HasSubstr("channel 'x' cannot be created; allowed: each name once"));
  EXPECT_THAT(ReadSeries(scratch.File("none.h5")).error().Line(),
              HasSubstr("cannot be read; allowed: an HDF5 time series; check the path"));
  std::ofstream(scratch.File("text.h5")) << "no HDF5";
  EXPECT_FALSE(ReadSeries(scratch.File("text.h5")).ok());
  H5Fclose(H5Fcreate(scratch.File("e.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_THAT(ReadSeries(scratch.File("e.h5")).error().Line(),
              HasSubstr("has no /channels; allowed: a time series written by phs"));
}

/// A file with the datasets of `shapes` under /channels.
void WriteForeign(const std::string& path, const std::vector<std::vector<hsize_t>>& shapes) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t group = H5Gcreate2(file, "channels", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  for (size_t i = 0; i < shapes.size(); ++i) {
    const hid_t space =
        H5Screate_simple(static_cast<int>(shapes[i].size()), shapes[i].data(), nullptr);
    H5Dclose(H5Dcreate2(group, std::string(i + 1, 'c').c_str(), H5T_NATIVE_DOUBLE, space,
                        H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
  }
  H5Gclose(group);
  H5Fclose(file);
}

TEST(Series, ForeignFilesAreRefused) {
  const ScratchDir scratch;
  WriteForeign(scratch.File("matrix.h5"), {{3, 3}});
  EXPECT_THAT(ReadSeries(scratch.File("matrix.h5")).error().Line(),
              HasSubstr("channel 'c' cannot be read; allowed: a list of numbers"));
  WriteForeign(scratch.File("huge.h5"), {{hsize_t{1} << 40}});
  EXPECT_THAT(ReadSeries(scratch.File("huge.h5")).error().Line(), HasSubstr("cannot be read"));
  WriteForeign(scratch.File("ragged.h5"), {{3}, {4}});
  EXPECT_THAT(ReadSeries(scratch.File("ragged.h5")).error().Line(),
              HasSubstr("channel 'cc' has another length; allowed: channels of equal length"));
}

TEST(Series, TruncatedFileIsAnError) {
  const ScratchDir scratch;
  ASSERT_TRUE(WriteRows(scratch.File("s.h5"), 5000).ok());
  std::filesystem::resize_file(scratch.File("s.h5"), 20000);
  EXPECT_FALSE(ReadSeries(scratch.File("s.h5")).ok());
}

TEST(Series, FullDiskIsAnErrorAndTheProgramEndsInOrder) {
  const ScratchDir scratch;
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{60000, 60000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Status status = WriteRows(scratch.File("s.h5"), 100000);
    std::exit(!status.ok() && IsDiskFault(status.error()) ? 0 : 1);
  }
  int how = 0;
  waitpid(child, &how, 0);
  EXPECT_EQ(how, 0);
}

TEST(Series, AbandonedWriterLeavesNothing) {
  const ScratchDir scratch;
  {
    auto writer = SeriesWriter::Create(scratch.File("s.h5"), kChannels);
    const double row[] = {1, 2};
    ASSERT_TRUE(writer.value().Append(row).ok());
  }
  EXPECT_TRUE(NamesIn(scratch.path()).empty());
}

TEST(Series, ClosedWriterIsFinished) {
  const ScratchDir scratch;
  auto writer = SeriesWriter::Create(scratch.File("s.h5"), kChannels);
  ASSERT_TRUE(writer.value().Close().ok());
  EXPECT_FALSE(writer.value().Note("late", "x").ok());
  EXPECT_FALSE(writer.value().Close().ok());
}

}  // namespace
}  // namespace phs
