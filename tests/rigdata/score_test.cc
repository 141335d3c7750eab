// The scorer on answers whose score is known by hand, and its black-box run with a stand-in for
// the program.
#include "score.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "../base/execute.h"

namespace rigdata {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

Json Truth(const std::vector<std::string>& names) {
  Json truth;
  truth["effects"] = Json::array();
  for (const std::string& n : names) {
    truth["effects"].push_back({{"name", n}, {"grade", "strong"}});
  }
  truth["validation_rmse"]["true_model"] = {{"load_cell_N", 50.0}, {"p_bore_Pa", 1000.0}};
  truth["validation_rmse"]["true_model_true_motion"] = {{"load_cell_N", 25.0}};
  return truth;
}

Json Answer(const std::vector<std::string>& names, double load_after) {
  Json answer;
  answer["effects"] = Json::array();
  for (const std::string& n : names) answer["effects"].push_back({{"name", n}});
  answer["channels"]["load_cell_N"] = {{"before", {{"rmse", 500.0}}},
                                       {"after", {{"rmse", load_after}}}};
  answer["channels"]["p_bore_Pa"] = {{"before", {{"rmse", 1000.0}}}, {"after", {{"rmse", 1000.0}}}};
  return answer;
}

SetScore Judge(const std::string& kind, const std::vector<std::string>& hidden,
               const std::vector<std::string>& accepted, double load_after = 50) {
  return JudgeSet("s", kind, Truth(hidden), Answer(accepted, load_after));
}

TEST(Score, OneSetIsJudgedByItsNamesAndItsError) {
  const SetScore right = Judge("single", {"a"}, {"a"}, 70);
  EXPECT_TRUE(right.answered && right.FirstRight() && right.Exact() && right.Complete());
  EXPECT_NEAR(right.error_ratio, std::sqrt((1.4 * 1.4 + 1) / 2), 1e-12);
  EXPECT_NEAR(right.strict_ratio, 2.8, 1e-12);

  const SetScore extra = Judge("single", {"a"}, {"a", "b"});
  EXPECT_TRUE(extra.FirstRight() && extra.Complete());
  EXPECT_FALSE(extra.Exact());
  const SetScore second = Judge("single", {"a"}, {"b", "a"});
  EXPECT_FALSE(second.FirstRight());
  const SetScore half = Judge("pair", {"a", "b"}, {"b"});
  EXPECT_TRUE(half.FirstRight());
  EXPECT_FALSE(half.Complete());
  EXPECT_TRUE(Judge("pair", {"a", "b"}, {"b", "a"}).Exact());
  EXPECT_TRUE(Judge("clean", {}, {"a"}).FalseAlarm());
  EXPECT_FALSE(Judge("clean", {}, {}).FalseAlarm());
  EXPECT_TRUE(Judge("off_list", {"x"}, {"unlisted_1"}).Described());
  EXPECT_FALSE(Judge("off_list", {"x"}, {"unlisted_1"}).Bent());
  EXPECT_TRUE(Judge("off_list", {"x"}, {"a"}).Bent());
}

TEST(Score, AnUnreadableResultIsNoAnswer) {
  const SetScore none = JudgeSet("s", "single", Truth({"a"}), Json());
  EXPECT_FALSE(none.answered || none.FirstRight() || none.Exact());
  EXPECT_FALSE(none.problem.empty());
  Json no_channels = Answer({"a"}, 50);
  no_channels.erase("channels");
  EXPECT_FALSE(JudgeSet("s", "single", Truth({"a"}), no_channels).answered);
}

// Clopper and Pearson's limits: 0 of 20: 1 - 0.025^(1/20); 8 of 10: 44.4 to 97.5 % (tables, e.g.
// Documenta Geigy).
TEST(Score, ASharesIntervalIsTheBinomialOne) {
  const auto none = ShareInterval(0, 20);
  EXPECT_EQ(none[0], 0);
  EXPECT_NEAR(none[1], 1 - std::pow(0.025, 0.05), 1e-9);
  const auto all = ShareInterval(20, 20);
  EXPECT_NEAR(all[0], std::pow(0.025, 0.05), 1e-9);
  EXPECT_EQ(all[1], 1);
  const auto most = ShareInterval(8, 10);
  EXPECT_NEAR(most[0], 0.4439, 1e-4);
  EXPECT_NEAR(most[1], 0.9748, 1e-4);
}

std::vector<SetScore> Repeat(int right, int wrong, const std::string& kind) {
  std::vector<SetScore> sets;
  const std::vector<std::string> hidden =
      kind == "pair" ? std::vector<std::string>{"a", "b"} : std::vector<std::string>{"a"};
  for (int i = 0; i < right; ++i) sets.push_back(Judge(kind, hidden, hidden));
  for (int i = 0; i < wrong; ++i) sets.push_back(Judge(kind, hidden, {"c"}));
  return sets;
}

TEST(Score, ThresholdsHoldAtTheirLimitsAndFailJustBelow) {
  EXPECT_TRUE(JudgeSuite(Repeat(9, 1, "single")).Passed());
  EXPECT_FALSE(JudgeSuite(Repeat(8, 1, "single")).Passed());
  EXPECT_TRUE(JudgeSuite(Repeat(7, 3, "pair")).Passed());
  EXPECT_FALSE(JudgeSuite(Repeat(6, 3, "pair")).Passed());
  std::vector<SetScore> clean(19, Judge("clean", {}, {}));
  clean.push_back(Judge("clean", {}, {"a"}));
  EXPECT_TRUE(JudgeSuite(clean).Passed());
  clean.pop_back();
  clean.pop_back();
  clean.push_back(Judge("clean", {}, {"a"}));
  EXPECT_FALSE(JudgeSuite(clean).Passed());
  EXPECT_FALSE(JudgeSuite({Judge("single", {"a"}, {"a"}, 80)}).Passed()) << "error too large";
}

// A shell script plays the program: it names what the set's folder name says.
TEST(ScoreIdentify, RunsTheProgramOnEverySetAndTellsByItsExitCode) {
  const fs::path folder = fs::path(testing::TempDir()) / "score_identify";
  fs::remove_all(folder);
  Json index = Json::array();
  for (const std::string set : {"set_001", "set_002"}) {
    fs::create_directories(folder / "suite" / set);
    fs::create_directories(folder / "suite" / "truth");
    std::ofstream(folder / "suite" / "truth" / (set + ".json")) << Truth({"a"});
    index.push_back({{"set", set}, {"kind", "single"}, {"truth", set + ".json"}});
  }
  std::ofstream(folder / "suite" / "truth" / "index.json") << index;
  std::ofstream(folder / "answer.json") << Answer({"a"}, 50);
  const fs::path program = folder / "program";
  std::ofstream(program) << "#!/bin/sh\n[ \"$1\" = identify ] && [ \"$3\" = --out ] || exit 2\n"
                         << "mkdir -p \"$4\" && cp " << (folder / "answer.json").string()
                         << " \"$4/result.json\"\n";
  chmod(program.c_str(), 0755);
  const auto score = [&](const std::string& phs) {
    const std::string command = std::string(SCORE_IDENTIFY) + " " + (folder / "suite").string() +
                                " --phs " + phs + " --out " + (folder / "out").string() +
                                " --markdown " + (folder / "score.md").string() + " > /dev/null";
    return phs::Execute(command).code;
  };
  EXPECT_EQ(score(program.string()), 0);
  std::ifstream in(folder / "score.md");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(text.find("100.0 % (2 of 2)"), std::string::npos) << text;
  EXPECT_EQ(score("/bin/false"), 1);
  EXPECT_EQ(score(program.string() + " --nonsense 1"), 2);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace rigdata
