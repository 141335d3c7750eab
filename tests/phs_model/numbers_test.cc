// Each number of a PHS is described once (hydraulics/phs_numbers.h): it can be named, changed,
// written, read back and is refused outside its range.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "hydraulics/phs_numbers.h"
#include "hydraulics/phs_validate.h"
#include "phs_model/effects_yaml.h"
#include "phs_model/keys.h"
#include "phs_model/model_changes.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {
namespace {

using hydraulics::NumberInfo;
using hydraulics::PhsParams;

const PhsParams& Model() {
  static const PhsParams params = FindPhsParams("bo_bo").value();
  return params;
}

PhsParams ReadBack(const PhsParams& params) {
  auto map = YamlMap::Parse(ToYaml(params), "model.yaml");
  PHS_CHECK(map.ok());
  auto read = ReadPhsParams(map.value());
  EXPECT_TRUE(read.ok()) << read.error().Line();
  return read.ok() ? read.value() : PhsParams{};
}

std::vector<ParameterInfo> All() { return ListParameters(Model()); }

TEST(Numbers, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (const ParameterInfo& info : All()) EXPECT_TRUE(names.insert(info.name).second) << info.name;
  EXPECT_GT(names.size(), 80u);
}

TEST(Numbers, EachIsChangedByNameAndOnlyItself) {
  const std::vector<ParameterInfo> before = All();
  for (const ParameterInfo& info : before) {
    SCOPED_TRACE(info.name);
    PhsParams changed = Model();
    const double value = info.value * 1.01 + 1e-6;
    ASSERT_TRUE(SetParameter(&changed, info.name, value).ok());
    EXPECT_EQ(GetParameter(changed, info.name).value(), value);
    const std::vector<ParameterInfo> after = ListParameters(changed);
    int different = 0;
    for (size_t i = 0; i < before.size(); ++i) different += after[i].value != before[i].value;
    EXPECT_EQ(different, 1);
  }
}

// A name given twice would act twice.
TEST(Effects, ATargetIsNamedOnce) {
  auto map = YamlMap::Parse("leak:\n  targets: [L1, L2, L1]\n", "model.yaml");
  ReadEffects(map.value());
  EXPECT_EQ(map.value().Finish().error().Line(),
            "model.yaml:2: leak.targets: 'L1' is given twice; allowed: each name once");
}

TEST(Numbers, EachComesBackFromAFile) {
  for (const auto curve :
       {hydraulics::FrictionCurve::kTable, hydraulics::FrictionCurve::kCoulomb}) {
    for (const ParameterInfo& info : All()) {
      SCOPED_TRACE(info.name);
      PhsParams changed = Model();
      changed.friction.curve = curve;
      ASSERT_TRUE(SetParameter(&changed, info.name, info.value * (1 - 1e-9)).ok());
      // The numbers of the other curve are not written.
      if (ToYaml(changed) == ToYaml(Model())) continue;
      const PhsParams back = ReadBack(changed);
      EXPECT_EQ(GetParameter(back, info.name).value(), GetParameter(changed, info.name).value());
    }
  }
}

TEST(Numbers, EachIsRefusedOutsideItsRangeByNameAndRange) {
  PhsParams model = Model();
  ForEachNumber(&model, [](const std::string& name, const NumberInfo& info, double) {
    SCOPED_TRACE(name);
    PhsParams changed = Model();
    ASSERT_TRUE(SetParameter(&changed, name, info.allowed.max * 1.001 + 1e-9).ok());
    const Status status = Validate(changed);
    ASSERT_FALSE(status.ok());
    EXPECT_THAT(status.error().Line(), testing::HasSubstr(name));
    EXPECT_THAT(status.error().Line(), testing::HasSubstr(info.allowed.Text()));
  });
}

TEST(Numbers, DefaultsAndPlausibleValuesAreAllowed) {
  PhsParams model = Model();
  ForEachNumber(&model, [](const std::string& name, const NumberInfo& info, double value) {
    EXPECT_TRUE(info.allowed.Contains(value)) << name;
    EXPECT_LT(info.low, info.high) << name;
    EXPECT_TRUE(info.allowed.Contains(info.high)) << name;
    EXPECT_FALSE(info.text.empty() || info.unit.empty()) << name;
  });
}

// A number that the model has not is told with its place in the file that names it.
TEST(Numbers, AnUnknownOneOfAFileIsToldWithItsPlace) {
  auto map = YamlMap::Parse("speed_m_s: 20\nphs_parameters:\n  friction.scale: 2\n  L9.gas: 1\n",
                            "run.yaml");
  PhsChanges changes;
  ReadParameters(map.value().Map("phs_parameters"), &changes);
  PhsParams params = Model();
  const Status done = ApplyChanges(changes, "", &params);
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().where, "run.yaml:4: phs_parameters.L9.gas");
  // One that no file named: by its name.
  EXPECT_EQ(ApplyChanges({.parameters = {{"L9.gas", 1}}}, "", &params).error().where, "L9.gas");
}

/// Every line "key:" of a written file is a key of a row.
TEST(Numbers, AWrittenFileHasOnlyKeysOfTheRows) {
  std::set<std::string> keys = {"end_stop", "reservoir", "accumulator", "friction", "element"};
  const auto last = [](const std::string& where) { return where.substr(where.rfind('.') + 1); };
  for (const KeyRow& row : OtherKeys()) keys.insert(last(row.where));
  PhsParams model = Model();
  ForEachNumber(&model, [&](const std::string&, const NumberInfo& info, double) {
    keys.insert(last(info.where));
  });
  model.friction.curve = hydraulics::FrictionCurve::kCoulomb;
  std::istringstream lines(ToYaml(model));
  for (std::string line; std::getline(lines, line);) {
    const size_t begin = line.find_first_not_of(" -");
    EXPECT_TRUE(keys.contains(line.substr(begin, line.find(':') - begin))) << line;
  }
}

}  // namespace
}  // namespace phs::phs_model
