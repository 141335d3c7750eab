#include "base/origin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/local_folder.h"
#include "base/result_dir.h"
#include "base/sha256.h"
#include "base/table.h"
#include "base/yaml.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

std::vector<std::string> Paths(const Origin& origin) {
  std::vector<std::string> paths;
  for (const InputFile& file : origin.inputs) paths.push_back(file.path);
  return paths;
}

TEST(Origin, NotesWhatIsReadWithTheDigestOfItsBytes) {
  const ScratchDir dir;
  const std::string yaml = dir.Write("a.yaml", "a: 1\n"), csv = dir.Write("b.csv", "t_s\n0\n1\n");
  const OriginNotes notes("phs 9", "phs simulate a.yaml");
  ASSERT_TRUE(YamlMap::Load(yaml).ok());
  ASSERT_TRUE(ReadTable(csv).ok());
  const auto origin = NotedOrigin();
  ASSERT_TRUE(origin);
  EXPECT_EQ(Paths(*origin), (std::vector<std::string>{yaml, csv}));
  EXPECT_EQ(origin->inputs[0].sha256, Sha256("a: 1\n"));
  EXPECT_EQ(origin->inputs[1].sha256, Sha256("t_s\n0\n1\n"));
}

TEST(Origin, ThatWhichWasReadFirstCounts) {
  const ScratchDir dir;
  const std::string file = dir.Write("a.yaml", "a: 1\n");
  const OriginNotes notes("phs 9", "phs");
  NoteInput(file);
  dir.Write("a.yaml", "a: 2\n");
  NoteInput(file);
  EXPECT_EQ(NotedOrigin()->inputs.at(0).sha256, Sha256("a: 1\n"));
}

TEST(Origin, FilesOfItsOwnWorkAndThoseThatAreGoneAreNoInputs) {
  const ScratchDir dir;
  std::filesystem::create_directories(dir.File("r.partial.host.1.1"));
  std::filesystem::create_directories(dir.File("s.unfinished"));
  const OriginNotes notes("phs 9", "phs");
  NoteInput(dir.Write("r.partial.host.1.1/measured.csv", "x\n1\n"));
  NoteInput(dir.Write("s.unfinished/plan.txt", "x"));
  const LocalFolder scratch;
  const std::string tried = scratch.path() + "/scenario.yaml";
  std::ofstream(tried) << "a: 1\n";
  NoteInput(tried);
  const std::string gone = dir.Write("gone.yaml", "a: 1\n");
  NoteInput(gone);
  std::filesystem::remove(gone);
  EXPECT_TRUE(NotedOrigin()->inputs.empty());
}

TEST(Origin, WorksAtTheSameTimeKeepApart) {
  const ScratchDir dir;
  const std::string mine = dir.Write("mine.yaml", "a: 1\n"), theirs = dir.Write("theirs.yaml", "b");
  const OriginNotes notes("phs 9", "mine");
  std::thread([&] {
    const OriginNotes other("phs 9", "theirs");
    NoteInput(theirs);
    EXPECT_EQ(Paths(*NotedOrigin()), std::vector<std::string>{theirs});
    EXPECT_EQ(NotedOrigin()->command, "theirs");
  }).join();
  const OriginShare share;
  std::thread([&] {
    const OriginShare::Part part(share);
    NoteInput(mine);
    EXPECT_EQ(NotedOrigin()->command, "mine");
  }).join();
  EXPECT_EQ(Paths(*NotedOrigin()), std::vector<std::string>{mine});
}

TEST(Origin, AWorkWithinAWorkHasItsOwn) {
  const ScratchDir dir;
  const std::string file = dir.Write("a.yaml", "a: 1\n");
  const OriginNotes outer("phs 9", "outer");
  {
    const OriginNotes inner("phs 9", "inner");
    NoteInput(file);
    EXPECT_EQ(NotedOrigin()->command, "inner");
  }
  EXPECT_EQ(NotedOrigin()->command, "outer");
  EXPECT_TRUE(NotedOrigin()->inputs.empty());
}

TEST(Origin, FilesMadeOfWhatWasHandedOverAreNamedSo) {
  const ScratchDir dir;
  std::filesystem::create_directories(dir.File("given"));
  const OriginNotes notes("phs 9", "phs.run({…})", dir.File("given"));
  NoteInput(dir.Write("given/track.yaml", "a: 1\n"));
  EXPECT_EQ(Paths(*NotedOrigin()), std::vector<std::string>{"given: track.yaml"});
}

TEST(Origin, WithoutNotesNothingIsWritten) {
  const ScratchDir dir;
  NoteInput(dir.Write("a.yaml", "a: 1\n"));
  EXPECT_FALSE(NotedOrigin());
  ASSERT_TRUE(WriteOrigin(dir.path()).ok());
  EXPECT_FALSE(std::filesystem::exists(dir.File(kOriginFile)));
  EXPECT_FALSE(ReadOrigin(dir.path()));
}

TEST(Origin, WrittenAndReadAgain) {
  const ScratchDir dir;
  const std::string file = dir.Write("a.yaml", "a: 1\n");
  ASSERT_EQ(setenv("SOURCE_DATE_EPOCH", "1700000000", 1), 0);
  {
    const OriginNotes notes("phs 9", "phs rig 'a b.yaml'");
    NoteInput(file);
    ASSERT_TRUE(WriteOrigin(dir.path()).ok());
  }
  unsetenv("SOURCE_DATE_EPOCH");
  const auto origin = ReadOrigin(dir.path());
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->program, "phs 9");
  EXPECT_EQ(origin->command, "phs rig 'a b.yaml'");
  EXPECT_EQ(origin->date, "2023-11-14T22:13:20Z");
  ASSERT_EQ(origin->inputs.size(), 1u);
  EXPECT_EQ(origin->inputs[0].path, file);
  EXPECT_EQ(origin->inputs[0].sha256, Sha256("a: 1\n"));
}

TEST(Origin, DamagedFilesAreNone) {
  const ScratchDir dir;
  for (const char* text : {"", "[1]", "{\"date\": 3, \"inputs\": 4}", "{\"inputs\": [1, {}]}"}) {
    dir.Write(kOriginFile, text);
    const auto origin = ReadOrigin(dir.path());
    EXPECT_EQ(origin ? origin->date : "", "") << text;
  }
}

TEST(ShellLine, IsTakenApartTheSameWay) {
  EXPECT_EQ(ShellLine({"phs", "compare", "--bogies", "phs,rigid_link@x.yaml"}),
            "phs compare --bogies phs,rigid_link@x.yaml");
  EXPECT_EQ(ShellLine({"a b", "", "it's", "$(x)"}), "'a b' '' 'it'\\''s' '$(x)'");
}

TEST(UtcText, OfKnownInstants) {
  EXPECT_EQ(UtcText(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(UtcText(951782400), "2000-02-29T00:00:00Z");
}

}  // namespace
}  // namespace phs
