#include "base/result_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "scratch_dir.h"

namespace phs {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void Write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }
std::string TextOf(const std::string& path) { return ReadFile(path).value(); }

TEST(ResultDir, CompleteAfterCommitAndInvisibleBefore) {
  const ScratchDir scratch;
  auto dir = ResultDir::Create(scratch.File("deep/er/out/"), false);
  ASSERT_TRUE(dir.ok()) << dir.error().Line();
  Write(dir.value().File("a.json"), "1");
  EXPECT_FALSE(fs::exists(scratch.File("deep/er/out")));
  ASSERT_TRUE(dir.value().Commit().ok());
  EXPECT_EQ(TextOf(scratch.File("deep/er/out/a.json")), "1");
  EXPECT_THAT(NamesIn(scratch.File("deep/er")), ElementsAre("out"));
}

TEST(ResultDir, LeavesNothingWithoutCommit) {
  const ScratchDir scratch;
  {
    auto dir = ResultDir::Create(scratch.File("out"), false);
    ASSERT_TRUE(dir.ok());
    Write(dir.value().File("half.json"), "{");
    ResultDir moved = std::move(dir).value();
    EXPECT_EQ(NamesIn(scratch.path()).size(), 1u);
  }
  EXPECT_THAT(NamesIn(scratch.path()), IsEmpty());
}

/// A former result with one file.
void WriteResult(const std::string& path, const std::string& file) {
  auto dir = ResultDir::Create(path, false);
  ASSERT_TRUE(dir.ok());
  fs::create_directories(fs::path(dir.value().File(file)).parent_path());
  Write(dir.value().File(file), "old");
  ASSERT_TRUE(dir.value().Commit().ok());
}

TEST(ResultDir, ExistingIsReplacedOnlyByForce) {
  const ScratchDir scratch;
  WriteResult(scratch.File("out"), "old.json");
  EXPECT_EQ(ResultDir::Create(scratch.File("out"), false).error().Line(),
            scratch.File("out") +
                ": exists already; allowed: a new directory; choose another, or --force");
  auto dir = ResultDir::Create(scratch.File("out"), true);
  ASSERT_TRUE(dir.ok());
  Write(dir.value().File("new.json"), "new");
  EXPECT_EQ(TextOf(scratch.File("out/old.json")), "old");
  ASSERT_TRUE(dir.value().Commit().ok());
  EXPECT_THAT(NamesIn(scratch.File("out")), ElementsAre(".phs_result", "new.json"));
  EXPECT_THAT(NamesIn(scratch.path()), ElementsAre("out"));
}

// --junit into the result made the next --force refuse it.
TEST(ResultDir, AFileThatWasAdoptedIsReplacedWithIt) {
  const ScratchDir dir;
  const std::string out = dir.File("out");
  for (const char* text : {"1", "2"}) {
    auto made = ResultDir::Create(out, true);
    ASSERT_TRUE(made.ok()) << made.error().Line();
    ASSERT_TRUE(WriteFileAtomically(made.value().File("a.txt"), text).ok());
    ASSERT_TRUE(made.value().Commit().ok());
    for (int twice = 0; twice < 2; ++twice) {
      ASSERT_TRUE(WriteFileAtomically(out + "/junit.xml", text).ok());
      ASSERT_TRUE(AdoptIntoResult(out + "/junit.xml").ok());
    }
  }
  EXPECT_TRUE(CheckFormerResult(out).ok());
  ASSERT_TRUE(WriteFileAtomically(out + "/notes.txt", "the user's own").ok());
  EXPECT_FALSE(CheckFormerResult(out).ok());
  ASSERT_TRUE(WriteFileAtomically(dir.File("alone.xml"), "").ok());
  EXPECT_TRUE(AdoptIntoResult(dir.File("alone.xml")).ok());
  EXPECT_FALSE(std::filesystem::exists(dir.File(kResultMark)));
}

TEST(ResultDir, ForceNeedsNothingToReplaceAlsoBesideTheUser) {
  const ScratchDir scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.File(""));
  auto dir = ResultDir::Create("out", true);
  EXPECT_TRUE(dir.ok());
  if (dir.ok()) {
    EXPECT_TRUE(dir.value().Commit().ok());
  }
  fs::current_path(before);
  EXPECT_TRUE(fs::is_directory(scratch.File("out")));
}

/// What force says to `path`.
std::string RefusedByForce(const std::string& path) {
  const auto dir = ResultDir::Create(path, true);
  return dir.ok() ? "" : dir.error().Line();
}

TEST(ResultDir, ForceLeavesAloneWhatIsNoFormerResult) {
  const ScratchDir scratch;
  Write(scratch.File("file"), "a file");
  EXPECT_THAT(RefusedByForce(scratch.File("file")), HasSubstr("it is a file"));
  fs::create_directories(scratch.File("work/deep"));
  EXPECT_THAT(RefusedByForce(scratch.File("work")), HasSubstr("it holds folders and no"));
  Write(scratch.File("work/deep/thesis.tex"), "x");
  EXPECT_THAT(
      RefusedByForce(scratch.File("work")),
      HasSubstr("is no former result of phs: it holds 'deep/thesis.tex' and no .phs_result"));
  Write(scratch.File("work/.phs_result"), "deep/thesis.tex\n");
  EXPECT_THAT(RefusedByForce(scratch.File("work")), HasSubstr("thesis.tex"));
  WriteResult(scratch.File("out"), "best/old.json");
  fs::create_directory_symlink(scratch.File("out"), scratch.File("link"));
  EXPECT_THAT(RefusedByForce(scratch.File("link")), HasSubstr("it is a link"));
  EXPECT_EQ(RefusedByForce(scratch.File("out")), "");
  Write(scratch.File("out/best/notes.txt"), "mine");
  EXPECT_THAT(RefusedByForce(scratch.File("out")), HasSubstr("it holds 'best/notes.txt' too"));
  EXPECT_EQ(TextOf(scratch.File("out/best/notes.txt")), "mine");
  EXPECT_EQ(TextOf(scratch.File("work/deep/thesis.tex")), "x");
  EXPECT_THAT(NamesIn(scratch.path()), ElementsAre("file", "link", "out", "work"));
}

TEST(ResultDir, WhatWasPutIntoTheOldOneMeanwhileIsKept) {
  const ScratchDir scratch;
  WriteResult(scratch.File("out"), "old.json");
  auto dir = ResultDir::Create(scratch.File("out"), true);
  ASSERT_TRUE(dir.ok());
  Write(scratch.File("out/notes.txt"), "mine");
  EXPECT_THAT(dir.value().Commit().error().Line(), HasSubstr("it holds 'notes.txt' too"));
  EXPECT_EQ(TextOf(scratch.File("out/notes.txt")), "mine");
  EXPECT_EQ(TextOf(scratch.File("out/old.json")), "old");
}

TEST(ResultDir, AnEmptyFolderMayBeTakenByForce) {
  const ScratchDir scratch;
  fs::create_directory(scratch.File("out"));
  auto dir = ResultDir::Create(scratch.File("out"), true);
  ASSERT_TRUE(dir.ok());
  Write(dir.value().File("new.json"), "new");
  ASSERT_TRUE(dir.value().Commit().ok());
  EXPECT_EQ(TextOf(scratch.File("out/new.json")), "new");
}

TEST(ResultDir, AResultThatAKilledWriterHadPutAsideGoesBack) {
  const ScratchDir scratch;
  WriteResult(scratch.File("out"), "old.json");
  pid_t dead = fork();
  if (dead == 0) _exit(0);
  waitpid(dead, nullptr, 0);
  const std::string aside =
      scratch.File("out.partial." + HostName() + "." + std::to_string(dead) + ".0.old");
  fs::rename(scratch.File("out"), aside);
  EXPECT_THAT(ResultDir::Create(scratch.File("out"), false).error().Line(),
              HasSubstr("exists already"));
  EXPECT_EQ(TextOf(scratch.File("out/old.json")), "old");
}

TEST(ResultDir, SecondWriterDoesNotOverwriteTheFirst) {
  const ScratchDir scratch;
  auto first = ResultDir::Create(scratch.File("out"), false);
  auto second = ResultDir::Create(scratch.File("out"), false);
  ASSERT_TRUE(first.ok() && second.ok());
  Write(first.value().File("who"), "first");
  ASSERT_TRUE(first.value().Commit().ok());
  EXPECT_THAT(second.value().Commit().error().Line(), HasSubstr("exists already"));
  EXPECT_EQ(TextOf(scratch.File("out/who")), "first");
}

TEST(ResultDir, RemovesWhatAKilledWriterLeft) {
  const ScratchDir scratch;
  const pid_t child = fork();
  if (child == 0) {
    auto dir = ResultDir::Create(scratch.File("out"), false);
    Write(dir.value().File("half"), "x");
    _exit(0);  // as if killed: no destructor
  }
  waitpid(child, nullptr, 0);
  ASSERT_EQ(NamesIn(scratch.path()).size(), 1u);
  auto other = ResultDir::Create(scratch.File("out2"), false);
  EXPECT_EQ(NamesIn(scratch.path()).size(), 2u) << "another directory's leavings are not ours";
  auto dir = ResultDir::Create(scratch.File("out"), false);
  ASSERT_TRUE(dir.ok());
  ASSERT_TRUE(dir.value().Commit().ok());
  ASSERT_TRUE(other.value().Commit().ok());
  EXPECT_THAT(NamesIn(scratch.path()), ElementsAre("out", "out2"));
}

TEST(ResultDir, RefusesPlacesThatCannotBeReplaced) {
  EXPECT_THAT(ResultDir::Create(".", true).error().Line(),
              HasSubstr("current directory lies in it"));
  EXPECT_THAT(ResultDir::Create("/", true).error().Line(),
              HasSubstr("current directory lies in it"));
  EXPECT_THAT(ResultDir::Create("", true).error().Line(), HasSubstr("result directory ''"));
  EXPECT_EQ(
      ResultDir::Create("/proc/out", false).error().Line(),
      "/proc/out: cannot be created (No such file or directory); allowed: a place that can be "
      "written");
  const ScratchDir scratch;
  Write(scratch.File("file"), "");
  EXPECT_THAT(ResultDir::Create(scratch.File("file/out"), false).error().Line(),
              HasSubstr("cannot be created (Not a directory)"));
}

TEST(WriteFileAtomically, ReplacesWholeAndReportsWhy) {
  const ScratchDir scratch;
  ASSERT_TRUE(WriteFileAtomically(scratch.File("f"), "one").ok());
  ASSERT_TRUE(WriteFileAtomically(scratch.File("f"), "two").ok());
  EXPECT_EQ(TextOf(scratch.File("f")), "two");
  ASSERT_TRUE(WriteFileAtomically(scratch.File("empty"), "").ok());
  EXPECT_EQ(TextOf(scratch.File("empty")), "");
  EXPECT_EQ(WriteFileAtomically(scratch.File("no/f"), "x").error().Line(),
            scratch.File("no/f") +
                ": cannot be written (No such file or directory); allowed: a place with room that "
                "can be written");
  EXPECT_THAT(NamesIn(scratch.path()), ElementsAre("empty", "f"));
  EXPECT_TRUE(WriteFileAtomically("/dev/null", "x").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null")) << "a device is written to, not replaced";
}

TEST(WriteFileAtomically, FullDiskIsAnErrorAndKeepsTheOld) {
  const ScratchDir scratch;
  ASSERT_TRUE(WriteFileAtomically(scratch.File("f"), "old").ok());
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100000, 100000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Status status = WriteFileAtomically(scratch.File("f"), std::string(200000, 'x'));
    _exit(!status.ok() && IsDiskFault(status.error()) &&
                  status.error().what.ends_with("no room left on the disk (File too large)")
              ? 0
              : 1);
  }
  int how = 0;
  waitpid(child, &how, 0);
  EXPECT_EQ(how, 0);
  EXPECT_EQ(TextOf(scratch.File("f")), "old");
  EXPECT_THAT(NamesIn(scratch.path()), ElementsAre("f"));
}

TEST(DiskFault, IsToldFromAPlaceThatCannotBeWritten) {
  EXPECT_EQ(WriteFault("f", ENOSPC).Line(),
            "f: cannot be written: no room left on the disk (No space left on device); free some "
            "space, then repeat");
  EXPECT_TRUE(IsDiskFault(WriteFault("f", EDQUOT)));
  EXPECT_TRUE(IsDiskFault(ReadFault("f", EIO)));
  EXPECT_FALSE(IsDiskFault(WriteFault("f", EACCES)));
  EXPECT_FALSE(IsDiskFault(ReadFault("f", ENOENT)));
}

TEST(ReadFile, Messages) {
  const ScratchDir scratch;
  EXPECT_EQ(ReadFile(scratch.path()).error().Line(),
            scratch.path() + ": is a directory; allowed: a readable file; check the path");
  EXPECT_THAT(ReadFile(scratch.File("none")).error().Line(),
              HasSubstr("cannot be read (No such file or directory)"));
}

TEST(Error, LineJoinsWhatIsThere) {
  EXPECT_EQ((Error{"a.yaml:3: k", "is wrong", "right", "mend it"}.Line()),
            "a.yaml:3: k: is wrong; allowed: right; mend it");
  EXPECT_EQ((Error{.what = "is\nwrong"}.Line()), "is wrong");
}

TEST(Result, BrokenPromisesThrow) {
  const Result<int> value = 3;
  const Result<int> fault = Error{.what = "x"};
  EXPECT_EQ(value.value(), 3);
  EXPECT_TRUE(value.status().ok());
  EXPECT_FALSE(fault.status().ok());
  EXPECT_THROW((void)fault.value(), std::logic_error);
  EXPECT_THROW((void)value.error(), std::logic_error);
  EXPECT_THROW((void)Status().error(), std::logic_error);
}

}  // namespace
}  // namespace phs
