// The rows of the engine versions, and what each says of its version.
#include "EngineProfile.h"

#include <gtest/gtest.h>

using namespace Drydock;

namespace
{

/** Versions whose row says so. */
std::string ListWhere(bool FEngineProfile::*Field)
{
	std::string Versions;
	for (const FEngineProfile& Row : GetEngineProfiles())
	{
		Versions += Row.*Field ? Row.GetVersion() + " " : "";
	}
	return Versions;
}

} // namespace

TEST(EngineProfile, RowsAscendWithoutGaps)
{
	int32 Minor = GetEngineProfiles().front().Minor;
	for (const FEngineProfile& Row : GetEngineProfiles())
	{
		EXPECT_EQ(Minor++, Row.Minor);
	}
}

TEST(EngineProfile, IsFoundByNumberAndByName)
{
	EXPECT_EQ(6, FindEngineProfile(6)->Minor);
	EXPECT_EQ(6, FindEngineProfile("5.6")->Minor);
	EXPECT_EQ(nullptr, FindEngineProfile(0));
	EXPECT_EQ(nullptr, FindEngineProfile("4.27"));
	EXPECT_EQ(nullptr, FindEngineProfile(""));
}

TEST(EngineProfile, NearestIsTheNewestForNewerAndTheOldestForOlder)
{
	EXPECT_EQ(5, GetNearestEngineProfile(5).Minor);
	EXPECT_EQ(GetEngineProfiles().back().Minor, GetNearestEngineProfile(99).Minor);
	EXPECT_EQ(GetEngineProfiles().front().Minor, GetNearestEngineProfile(-1).Minor);
}

TEST(EngineProfile, TheDefaultIs54)
{
	EXPECT_EQ("5.4", GetDefaultEngineProfile().GetVersion());
}

TEST(EngineProfile, ADefaultRowIsThatOf54)
{
	const FEngineProfile Row;
	EXPECT_EQ(GetDefaultEngineProfile().bShadowContrastOfHighlights, Row.bShadowContrastOfHighlights);
	EXPECT_EQ(GetDefaultEngineProfile().bBloomRampWithoutThreshold, Row.bBloomRampWithoutThreshold);
	EXPECT_EQ(GetDefaultEngineProfile().bLocalExposureThresholds, Row.bLocalExposureThresholds);
}

TEST(EngineProfile, ShadowsTakeTheHighlightsContrastIn53Alone)
{
	EXPECT_EQ("5.3 ", ListWhere(&FEngineProfile::bShadowContrastOfHighlights));
}

TEST(EngineProfile, BloomHasARampWithoutThresholdUpTo53)
{
	EXPECT_EQ("5.1 5.2 5.3 ", ListWhere(&FEngineProfile::bBloomRampWithoutThreshold));
}

TEST(EngineProfile, LocalExposureHasThresholdsFrom54)
{
	EXPECT_EQ("5.4 5.5 5.6 5.7 5.8 ", ListWhere(&FEngineProfile::bLocalExposureThresholds));
}

TEST(EngineProfile, ListsItsVersions)
{
	EXPECT_EQ("5.1, 5.2, 5.3, 5.4, 5.5, 5.6, 5.7, 5.8", ListEngineVersions(", "));
}
