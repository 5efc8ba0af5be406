// The table of effects: nothing can be left out of a row, names and files agree, and settings have owners.
#include <gtest/gtest.h>

#include "Effects/Effects.h"
#include "PostProcessSettingsReflection.h"

#include <filesystem>
#include <set>
#include <type_traits>

using namespace Drydock;

namespace
{

template<typename EffectType>
concept CanLeaveOutAllButName = requires
{
	EffectType{.Id = EEffect::Bloom, .Name = "Bloom"};
};

template<typename EffectType>
concept CanLeaveOutTheLast = requires(const EffectType& E)
{
	EffectType{.Id = E.Id,
		.Name = E.Name,
		.Doc = E.Doc,
		.Settings = E.Settings,
		.bMayBrightenBeforeBloom = E.bMayBrightenBeforeBloom,
		.Decide = E.Decide,
		.Content = E.Content,
		.Complete = E.Complete,
		.GetPlace = E.GetPlace,
		.AddPasses = E.AddPasses};
};

template<typename EffectType>
concept CanLeaveOutWhetherItBrightens = requires(const EffectType& E)
{
	EffectType{.Id = E.Id,
		.Name = E.Name,
		.Doc = E.Doc,
		.Settings = E.Settings,
		.Decide = E.Decide,
		.Content = E.Content,
		.Complete = E.Complete,
		.GetPlace = E.GetPlace,
		.AddPasses = E.AddPasses,
		.Measurement = E.Measurement};
};

// A field that is forgotten does not compile.
static_assert(!CanLeaveOutAllButName<FEffect>);
static_assert(!CanLeaveOutTheLast<FEffect>);
static_assert(!CanLeaveOutWhetherItBrightens<FEffect>);
static_assert(!std::is_default_constructible_v<FEffect>);

/** Settings that drydock brought, so that some effect must read them. */
bool IsDrydocksOwn(const FSettingField& Field)
{
	return std::string(Field.Doc).starts_with("drydock:");
}

} // namespace

TEST(Effects, EachRowHasItsOwnIdNameAndFile)
{
	size_t Index = 0;
	for (const FEffect* const Effect : GetEffects())
	{
		const std::string Name = *Effect->Name;
		EXPECT_EQ(Index++, static_cast<size_t>(*Effect->Id)) << Name;
		EXPECT_EQ(Effect, FindEffectByName(Name));
		EXPECT_TRUE(std::filesystem::exists(DRYDOCK_TEST_SOURCE_DIR "/pipeline/Effects/" + Name + ".cpp")) << Name;
	}
	EXPECT_EQ(static_cast<size_t>(EEffect::Num), Index);
}

TEST(Effects, WhatMustNotBeNullIsNot)
{
	for (const FEffect* const Effect : GetEffects())
	{
		const std::string Name = *Effect->Name;
		EXPECT_NE(nullptr, *Effect->Decide) << Name;
		EXPECT_NE(nullptr, *Effect->GetPlace) << Name;
		EXPECT_EQ('.', std::string(*Effect->Doc).back()) << Name;
		EXPECT_EQ(Effect->Content->Ask == nullptr, Effect->Content->Gate == nullptr)
			<< Name << " asks and gates, or neither";
		EXPECT_EQ(Effect->Measurement->Textures.empty(), Effect->Measurement->Measure == nullptr) << Name;
	}
}

TEST(Effects, EverySettingOfDrydocksOwnHasAnOwner)
{
	int NumChecked = 0;
	for (const FSettingField& Field : GetSettingFields())
	{
		if (IsDrydocksOwn(Field))
		{
			EXPECT_NE(nullptr, FindSettingOwner(Field.Name)) << Field.Name << " is read by no effect of the table";
			EXPECT_EQ("", GetSettingNotBuiltReason(Field.Name));
			++NumChecked;
		}
	}
	EXPECT_GT(NumChecked, 40);
}

TEST(Effects, EveryClaimIsOnSettingsThatExistAndIsMadeOnce)
{
	std::set<std::string> Claims;
	for (const FEffect* const Effect : GetEffects())
	{
		for (const FSettingClaim& Claim : *Effect->Settings)
		{
			const std::string Beginning(Claim.Beginning);
			EXPECT_TRUE(Claims.insert(Beginning).second) << Beginning;
			const auto Fields = GetSettingFields();
			EXPECT_TRUE(std::any_of(Fields.begin(), Fields.end(),
				[&](const FSettingField& Field) { return std::string(Field.Name).starts_with(Beginning); }))
				<< *Effect->Name << " claims " << Beginning;
		}
	}
}

TEST(Effects, TheLongestClaimOwns)
{
	EXPECT_EQ(EEffect::Bloom, FindSettingOwner("BloomIntensity")->Id);
	EXPECT_EQ(EEffect::ToonBloom, FindSettingOwner("BloomToonIntensity")->Id);
	EXPECT_EQ(EEffect::FFTBloom, FindSettingOwner("BloomConvolutionSize")->Id);
	EXPECT_EQ(nullptr, FindSettingOwner("AmbientOcclusionBias"));
}

TEST(Effects, ASettingThatDoesNothingSaysWhy)
{
	EXPECT_EQ("", GetSettingNotBuiltReason("BloomIntensity"));
	EXPECT_EQ("it came with engine 5.6, whose convolution bloom is not simulated",
		GetSettingNotBuiltReason("BloomConvolutionIntensity"));
	EXPECT_EQ(
		"no pass reads it; it is blended and reported all the same", GetSettingNotBuiltReason("AmbientOcclusionBias"));
}
