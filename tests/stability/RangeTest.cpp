// Every range that settings span has the stated result where it is empty, inverted or far away.
#include <gtest/gtest.h>

#include "RangeRows.h"
#include "SweepScene.h"

#include "PostProcessSettingsReflection.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

using namespace Drydock;

namespace Stability
{

namespace
{

std::vector<std::string> Split(const char* Text)
{
	std::istringstream Stream(Text);
	std::vector<std::string> Words;
	for (std::string Word; Stream >> Word;)
	{
		Words.push_back(Word);
	}
	return Words;
}

std::string MakeCaseName(const testing::TestParamInfo<FRangeCase>& Info)
{
	std::string Name;
	for (const char Letter : std::string(Info.param.Range) + "__" + Info.param.Kind)
	{
		Name += std::isalnum(static_cast<unsigned char>(Letter)) ? Letter : '_';
	}
	return Name;
}

class Ranges : public testing::TestWithParam<FRangeCase>
{
protected:
	static const FSweepScene& GetScene()
	{
		static const FSweepScene Scene;
		return Scene;
	}
};

} // namespace

void PrintTo(const FRangeCase& Case, std::ostream* Stream)
{
	*Stream << Case.Given;
}

TEST_P(Ranges, AreAsTheTableSays)
{
	const FRangeCase& Case = GetParam();
	const ESweepFrame Frame = Case.bPrinted ? ESweepFrame::Printed : ESweepFrame::Corrected;
	const FRunResult Result = GetScene().Run(Frame, Split(Case.Given));
	const FImage SceneLinear = Result.SceneLinear.ToImage(), Final = Result.Final.ToImage();
	for (const double Value : SceneLinear.Values)
	{
		ASSERT_TRUE(std::isfinite(Value)) << Case.Given;
	}
	for (const double Value : Final.Values)
	{
		ASSERT_TRUE(Value >= 0.0 && Value <= 1.0) << Case.Given << ": " << Value;
	}
	if (*Case.As != '\0')
	{
		const FRunResult As = GetScene().Run(Frame, Split(Case.As));
		EXPECT_EQ(As.SceneLinear.ToImage().Values, Result.SceneLinear.ToImage().Values)
			<< Case.Given << " as " << Case.As;
		EXPECT_EQ(As.Final.ToImage().Values, Result.Final.ToImage().Values) << Case.Given << " as " << Case.As;
		EXPECT_EQ(As.ExposureScale, Result.ExposureScale);
	}
}

INSTANTIATE_TEST_SUITE_P(Table, Ranges, testing::ValuesIn(RangeCases), &MakeCaseName);

/** Settings of two names that differ by Min and Max, or Low and High. */
TEST(RangeTable, HasARowForEveryPairOfEnds)
{
	const auto Covers = [](const std::string& Range)
	{
		return [Range](const FRangeCase& Case)
		{
			return Range == Case.Range;
		};
	};
	const std::pair<const char*, const char*> Ends[] = {{"Min", "Max"}, {"Low", "High"}};
	int NumPairs = 0;
	for (const FSettingField& Field : GetSettingFields())
	{
		for (const auto& [Lower, Upper] : Ends)
		{
			const std::string Name = Field.Name;
			const size_t At = Name.find(Lower);
			if (At == std::string::npos)
			{
				continue;
			}
			const std::string Other = Name.substr(0, At) + Upper + Name.substr(At + std::string(Lower).size());
			if (FindSettingField(Other) != nullptr)
			{
				++NumPairs;
				EXPECT_TRUE(std::any_of(std::begin(RangeCases), std::end(RangeCases), Covers(Name + " .. " + Other)))
					<< Name << " .. " << Other;
			}
		}
	}
	EXPECT_LE(6, NumPairs);
}

/** A case that says what it equals would prove nothing if the settings changed nothing. */
TEST(RangeTable, ItsSettingsChangeThePicture)
{
	const FSweepScene Scene;
	std::set<std::string> Seen;
	const FRunResult Plain[] = {Scene.Run(ESweepFrame::Corrected, {}), Scene.Run(ESweepFrame::Printed, {})};
	for (const FRangeCase& Case : RangeCases)
	{
		if (Seen.count(Case.Range) == 0)
		{
			const FRunResult Result =
				Scene.Run(Case.bPrinted ? ESweepFrame::Printed : ESweepFrame::Corrected, Split(Case.Given));
			if (Result.Final.ToImage().Values != Plain[Case.bPrinted].Final.ToImage().Values)
			{
				Seen.insert(Case.Range);
			}
		}
	}
	for (const FRangeCase& Case : RangeCases)
	{
		EXPECT_EQ(1u, Seen.count(Case.Range)) << Case.Range;
	}
}

} // namespace Stability
