// Every field of the settings table, each as a test of its own name. Defaults and rules come from
// PostProcessSettingsExpected.inl, blends from arithmetic in double.
#include <gtest/gtest.h>

#include "PostProcessSettingsReflection.h"
#include "SettingSamples.h"

#include <cmath>
#include <limits>
#include <map>

using namespace Drydock;

namespace
{

struct FExpected
{
	std::string Default;
	ESettingBlend Blend;
};

const std::map<std::string, FExpected> ExpectedFields = {
#define EXPECTED(Name, Default, Rule) {#Name, {Default, ESettingBlend::Rule}},
#include "PostProcessSettingsExpected.inl"
#undef EXPECTED
};

class SettingField : public testing::TestWithParam<const FSettingField*>
{
protected:
	const FSettingField& Field = *GetParam();
	FSettingValue Other = MakeOtherValue(Field);

	FPostProcessSettings With(const FSettingValue& Value) const
	{
		FPostProcessSettings Settings;
		Field.Set(Settings, Value);
		return Settings;
	}

	FSettingValue Blend(const FSettingValue& From, const FSettingValue& To, float Weight) const
	{
		FPostProcessSettings Settings = With(From);
		Field.BlendFrom(Settings, With(To), Weight);
		return Field.Get(Settings);
	}
};

bool IsZero(const FSettingValue& Value)
{
	return Value == FSettingValue{Value.Type};
}

/** The rules as the engine's documentation tells them, on whole values and in double. */
FSettingValue BlendByHand(
	const FSettingField& Field, ESettingBlend Rule, const FSettingValue& From, const FSettingValue& To, double Weight)
{
	const bool bMoves = Rule != ESettingBlend::Accumulate && Rule != ESettingBlend::LUT && Weight > 0.0;
	if (!bMoves || (Rule == ESettingBlend::SetIfNonZero && IsZero(To)))
	{
		return From;
	}
	const bool bLerps =
		Rule == ESettingBlend::Lerp || (Rule == ESettingBlend::FocalDistance && !IsZero(From) && !IsZero(To));
	if (!bLerps)
	{
		return To;
	}
	FSettingValue Result = From;
	for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
	{
		Result.Components[Index] = (1.0 - Weight) * From.Components[Index] + Weight * To.Components[Index];
	}
	return Result;
}

/** One rounding step of float on numbers of the size of Scale. */
double FloatStep(double Scale)
{
	return (std::fabs(Scale) + 1.0) * 2.0 * std::numeric_limits<float>::epsilon();
}

void ExpectNear(const FSettingField& Field, const FSettingValue& Expected, const FSettingValue& Value)
{
	EXPECT_EQ(Expected.Object, Value.Object);
	for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
	{
		EXPECT_NEAR(Expected.Components[Index], Value.Components[Index], FloatStep(Expected.Components[Index]));
	}
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Each, SettingField, AllSettingFields(), FNameOfSetting());

TEST_P(SettingField, DefaultIsTheExpectedOne)
{
	ASSERT_EQ(1u, ExpectedFields.count(Field.Name)) << "a new setting wants a line in PostProcessSettingsExpected.inl";
	FSettingValue Expected;
	std::string Error;
	ASSERT_TRUE(SettingFromText(Field, ExpectedFields.at(Field.Name).Default, Expected, Error)) << Error;
	EXPECT_EQ(Expected, Field.Default);
	EXPECT_EQ(Expected, Field.Get(FPostProcessSettings()));
}

TEST_P(SettingField, RuleIsTheExpectedOne)
{
	ASSERT_EQ(1u, ExpectedFields.count(Field.Name));
	EXPECT_EQ(ExpectedFields.at(Field.Name).Blend, Field.Blend);
}

TEST_P(SettingField, RangesAreInOrderAndHoldTheDefault)
{
	EXPECT_LT(Field.Range.ClampMin, Field.Range.ClampMax);
	EXPECT_LT(Field.Range.UIMin, Field.Range.UIMax);
	EXPECT_LE(Field.Range.ClampMin, Field.Range.UIMin);
	EXPECT_LE(Field.Range.UIMax, Field.Range.ClampMax);
	EXPECT_TRUE(Field.IsInRange(Field.Default));
}

TEST_P(SettingField, IsDocumented)
{
	EXPECT_GT(std::string(Field.Doc).size(), 8u);
	EXPECT_EQ('.', std::string(Field.Doc).back());
	EXPECT_FALSE(std::string(Field.Category).empty());
}

TEST_P(SettingField, SetMovesOnlyItself)
{
	ASSERT_NE(Field.Default, Other);
	const FPostProcessSettings Settings = With(Other);
	for (const FSettingField& Each : GetSettingFields())
	{
		EXPECT_EQ(&Each == &Field ? Other : Each.Default, Each.Get(Settings)) << Each.Name;
		EXPECT_FALSE(Each.IsOverridden(Settings)) << Each.Name;
	}
}

TEST_P(SettingField, OverrideBitMovesOnlyItself)
{
	FPostProcessSettings Settings;
	Field.SetOverridden(Settings, true);
	for (const FSettingField& Each : GetSettingFields())
	{
		EXPECT_EQ(&Each == &Field, Each.IsOverridden(Settings)) << Each.Name;
		EXPECT_EQ(Each.Default, Each.Get(Settings)) << Each.Name;
	}
	Field.SetOverridden(Settings, false);
	EXPECT_FALSE(Field.IsOverridden(Settings));
}

TEST_P(SettingField, IsFoundByItsNames)
{
	EXPECT_EQ(&Field, FindSettingField(Field.Name));
	EXPECT_EQ(&Field, FindSettingFieldByOverride(Field.OverrideName));
}

TEST_P(SettingField, WeightZeroKeepsTheOldValue)
{
	EXPECT_EQ(Field.Default, Blend(Field.Default, Other, 0.0f));
	EXPECT_EQ(Field.Default, Blend(Field.Default, Other, -1.0f));
	EXPECT_EQ(Field.Default, Blend(Field.Default, Other, std::nanf("")));
}

TEST_P(SettingField, PartialWeightsFollowTheRule)
{
	ASSERT_EQ(1u, ExpectedFields.count(Field.Name));
	const ESettingBlend Rule = ExpectedFields.at(Field.Name).Blend;
	const FSettingValue Zero{Field.Type};
	for (const float Weight : {0.01f, 0.5f})
	{
		for (const auto& [From, To] :
			{std::pair{Field.Default, Other}, {Other, Field.Default}, {Zero, Other}, {Other, Zero}})
		{
			ExpectNear(Field, BlendByHand(Field, Rule, From, To, Weight), Blend(From, To, Weight));
		}
	}
}

TEST_P(SettingField, WeightOneAssignsExactly)
{
	ASSERT_EQ(1u, ExpectedFields.count(Field.Name));
	const ESettingBlend Rule = ExpectedFields.at(Field.Name).Blend;
	FSettingValue Far = Field.Default;
	for (int32 Index = 0; Field.bInterpolates && Index < Field.GetNumComponents(); ++Index)
	{
		Far.Components[Index] = 1e8f; // from here a + (b - a) would not come back to b
	}
	EXPECT_EQ(BlendByHand(Field, Rule, Far, Other, 1.0), Blend(Far, Other, 1.0f));
	EXPECT_EQ(BlendByHand(Field, Rule, Other, Far, 1.0), Blend(Other, Far, 1.0f));
}

TEST_P(SettingField, NotFiniteSourcesStayOut)
{
	for (int32 Index = 0; Field.bInterpolates && Index < Field.GetNumComponents(); ++Index)
	{
		for (const double Bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
		{
			FSettingValue Source = Other;
			Source.Components[Index] = Bad;
			EXPECT_EQ(Field.Default, Blend(Field.Default, Source, 0.5f));
			EXPECT_EQ(Field.Default, Blend(Field.Default, Source, 1.0f));
		}
	}
}

TEST_P(SettingField, TextReadsBack)
{
	for (const FSettingValue& Value : {Field.Default, Other, FSettingValue{Field.Type}})
	{
		FSettingValue Read;
		std::string Error;
		ASSERT_TRUE(SettingFromText(Field, SettingToText(Field, Value), Read, Error)) << Error;
		EXPECT_EQ(Value, Read);
	}
}

TEST(SettingFields, AllExpectedOnesAreThere)
{
	for (const auto& [Name, Expected] : ExpectedFields)
	{
		EXPECT_NE(nullptr, FindSettingField(Name)) << Name;
	}
	EXPECT_EQ(ExpectedFields.size(), GetSettingFields().size());
}

TEST(SettingFields, OnlyTheMobileGaussiansBitIsNamedOtherwise)
{
	for (const FSettingField& Field : GetSettingFields())
	{
		const bool bMobile = std::string(Field.Name) == "bMobileHQGaussian";
		EXPECT_EQ(bMobile ? "bOverride_MobileHQGaussian" : std::string("bOverride_") + Field.Name, Field.OverrideName);
	}
}
