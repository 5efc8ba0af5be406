// Which effects have nothing to do in a scene, decided from what was measured.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "pipeline/EffectTestUtils.h"
#include "HAL/ConsoleVariableTools.h"
#include "Run/FinalSettings.h"

#include <algorithm>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

/** A view's settings and what is known of its scene. */
struct FGatedView : FViewSettings
{
	FViewContent Content;
};

FGatedView MakeChain(const std::string& Settings)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config =
		ReadConfig(R"({"volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]}", "a.json", Diagnostics);
	EXPECT_FALSE(HasErrors(Diagnostics));
	FGatedView Chain{MakeViewSettings(Config), {}};
	Chain.Content.Size = FIntPoint(100, 50);
	return Chain;
}

FEffectDecision Decide(const FGatedView& Chain, const std::string& Name)
{
	return FindEffect(DecideEffects(Chain, Chain.Content), Name);
}

FContentQuestions Ask(const FGatedView& Chain)
{
	return AskContent(Chain, DecideBySettings(Chain));
}

const FIntRect None;
const FIntRect Corner(0, 0, 10, 5);
const FIntRect Whole(0, 0, 100, 50);

/** An effect, settings that call for it, and a scene that leaves it nothing to do. */
struct FGate
{
	const char* Effect;
	const char* Settings;
	FViewContent Content;
	FContentQuestions Asked;
	const char* Reason;
};

void PrintTo(const FGate& Gate, std::ostream* Stream)
{
	*Stream << Gate.Effect;
}

FViewContent WithToon(const FIntRect& Toon)
{
	FViewContent Content;
	Content.Toon = Toon;
	return Content;
}

FViewContent WithMask(const FIntRect& Mask)
{
	FViewContent Content;
	Content.GlowMask = Mask;
	return Content;
}

FViewContent Still(bool bStill)
{
	FViewContent Content;
	Content.bStill = bStill;
	return Content;
}

FViewContent WithBrightest(double Brightest)
{
	FViewContent Content;
	Content.Brightest = Brightest;
	return Content;
}

const std::vector<FGate> Gates = {
	{"ToonBloom", R"("BloomToonIntensity": 0.1)", WithToon(None), {true, false, false, false},
		"no pixel of the view is shaded as toon"},
	{"ToonShadowBlur", R"("ToonShadowBlurIntensity": 1)", WithToon(None), {true, false, false, false},
		"no pixel of the view is shaded as toon"},
	{"CharaGlow", R"("CharaGlowArea": 4)", WithMask(None), {false, true, false, false},
		"the character mask is 0 in the whole view"},
	{"MotionBlur", R"("MotionBlurAmount": 0.5)", Still(true), {false, false, true, false}, "nothing moves in the view"},
	{"Bloom", R"("BloomThreshold": 2)", WithBrightest(1.0), {false, false, false, true},
		"nothing is brighter than BloomThreshold 2"},
};

class ContentGate : public testing::TestWithParam<FGate>
{
protected:
	FEffectDecision DecideWith(const FViewContent& Content) const
	{
		FGatedView Chain = MakeChain(GetParam().Settings);
		const FIntPoint Size = Chain.Content.Size;
		Chain.Content = Content;
		Chain.Content.Size = Size;
		return Decide(Chain, GetParam().Effect);
	}
};

} // namespace

TEST_P(ContentGate, SettingsAloneCallForIt)
{
	const FEffectDecision Decision = DecideWith({});
	EXPECT_TRUE(Decision.bActive);
	EXPECT_FALSE(Decision.bNothingToDo);
}

TEST_P(ContentGate, TheSceneLeavesItNothingToDo)
{
	const FEffectDecision Decision = DecideWith(GetParam().Content);
	EXPECT_FALSE(Decision.bActive);
	EXPECT_TRUE(Decision.bNothingToDo);
	EXPECT_THAT(Decision.Reason, HasSubstr(GetParam().Reason));
}

TEST_P(ContentGate, AsksWhatItNeedsAndNoMore)
{
	const FGatedView Chain = MakeChain(GetParam().Settings);
	const FContentQuestions Asked = Ask(Chain);
	EXPECT_EQ(GetParam().Asked.bToon, Asked.bToon);
	EXPECT_EQ(GetParam().Asked.bGlowMask, Asked.bGlowMask);
	EXPECT_EQ(GetParam().Asked.bStill, Asked.bStill);
	EXPECT_EQ(GetParam().Asked.bBrightest, Asked.bBrightest);
}

TEST_P(ContentGate, AsksNothingWithNoSkip)
{
	FGatedView Chain = MakeChain(GetParam().Settings);
	Chain.bNoSkip = true;
	EXPECT_FALSE(Ask(Chain).Any());
}

INSTANTIATE_TEST_SUITE_P(Effects, ContentGate, testing::ValuesIn(Gates),
	[](const testing::TestParamInfo<FGate>& Info) { return std::string(Info.param.Effect); });

TEST(ContentGates, DefaultsAskNothing)
{
	const FGatedView Chain = MakeChain("");
	EXPECT_FALSE(Ask(Chain).Any());
}

TEST(ContentGates, WithoutToonTheSetupPassIsNotNeeded)
{
	FGatedView Chain = MakeChain(R"("BloomToonIntensity": 0.1)");
	Chain.Content.Toon = None;
	EXPECT_THAT(Decide(Chain, "Bloom").Reason, HasSubstr("the setup pass is not needed"));
	Chain.Content.Toon = Corner;
	EXPECT_THAT(Decide(Chain, "Bloom").Reason, HasSubstr("the setup pass is there for the toon's factor"));
}

TEST(ContentGates, AsPrintedItRoundsUnlessTheThresholdDoesToo)
{
	const FScopedConsoleVariable Variable(TEXT("r.ToonBloom.AsPrinted"), 1);
	FGatedView Chain = MakeChain(R"("BloomToonIntensity": 0.1)");
	Chain.Content.Toon = None;
	EXPECT_TRUE(Decide(Chain, "ToonBloom").bActive);
	Chain = MakeChain(R"("BloomToonIntensity": 0.1, "BloomThreshold": 1)");
	Chain.Content.Toon = None;
	EXPECT_FALSE(Decide(Chain, "ToonBloom").bActive);
}

TEST(ContentGates, WhereTheSetupPassHasARampItChangesMoreThanToon)
{
	FGatedView Chain = MakeChain(R"("BloomToonIntensity": 0.1)");
	Chain.Content.Toon = None;
	for (const FEngineProfile& Engine : GetEngineProfiles())
	{
		Chain.Engine = Engine;
		EXPECT_EQ(Engine.bBloomRampWithoutThreshold, Decide(Chain, "ToonBloom").bActive) << Engine.GetVersion();
	}
}

TEST(ContentGates, AlwaysMeansAlways)
{
	const FScopedConsoleVariable Variable(TEXT("r.ToonBloom"), 1);
	FGatedView Chain = MakeChain("");
	EXPECT_FALSE(Ask(Chain).bToon);
	Chain.Content.Toon = None;
	EXPECT_TRUE(Decide(Chain, "ToonBloom").bActive);
}

TEST(ContentGates, ACornerIsTheRegionAndMostOfTheViewIsNone)
{
	FGatedView Chain = MakeChain(R"("BloomToonIntensity": 0.1, "CharaGlowArea": 2)");
	Chain.Content.Toon = Corner;
	Chain.Content.GlowMask = Corner;
	EXPECT_EQ(Corner, Decide(Chain, "ToonBloom").Region);
	EXPECT_THAT(Decide(Chain, "ToonBloom").Reason, HasSubstr("toon in 10x5 of 100x50 pixels"));
	EXPECT_EQ(Corner, Decide(Chain, "CharaGlow").Region);
	Chain.Content.Toon = Whole;
	EXPECT_TRUE(Decide(Chain, "ToonBloom").bActive);
	EXPECT_FALSE(Decide(Chain, "ToonBloom").Region);
}

TEST(ContentGates, ThePrintedGlowIsNeverLeftOutBecauseItWritesAlpha)
{
	const FScopedConsoleVariable Variable(TEXT("r.RED.AsPrinted"), 1);
	FGatedView Chain = MakeChain(R"("CharaGlowArea": 2)");
	EXPECT_FALSE(Ask(Chain).bGlowMask);
	for (const FIntRect& Mask : {None, Corner})
	{
		Chain.Content.GlowMask = Mask;
		EXPECT_TRUE(Decide(Chain, "CharaGlow").bActive);
		EXPECT_FALSE(Decide(Chain, "CharaGlow").Region);
	}
}

TEST(ContentGates, ComputeEntriesHaveNoRegion)
{
	const FScopedConsoleVariable Variable(TEXT("r.PostProcessing.PreferCompute"), 1);
	FGatedView Chain = MakeChain(R"("BloomToonIntensity": 0.1)");
	Chain.Content.Toon = Corner;
	EXPECT_FALSE(Decide(Chain, "ToonBloom").Region);
}

// A tenth above the brightest value is the least threshold that nothing reaches.
TEST(ContentGates, BrightnessIsExposedAndHasAMargin)
{
	FGatedView Chain = MakeChain(R"("BloomThreshold": 2)");
	Chain.Content.Brightest = 1.8;
	EXPECT_FALSE(Decide(Chain, "Bloom").bActive);
	Chain.Content.Brightest = 1.9;
	EXPECT_TRUE(Decide(Chain, "Bloom").bActive);
	Chain.ExposureScale = 0.5f;
	EXPECT_FALSE(Decide(Chain, "Bloom").bActive);
	Chain.bAutoExposure = true; // unknown before the frame has run
	EXPECT_TRUE(Decide(Chain, "Bloom").bActive);
}

TEST(ContentGates, AThresholdBelowZeroLetsBlackBloom)
{
	FGatedView Chain = MakeChain(R"("BloomThreshold": -0.5)");
	Chain.Content.Brightest = 0.0;
	EXPECT_TRUE(Decide(Chain, "Bloom").bActive);
	Chain = MakeChain(R"("BloomThreshold": 0)");
	Chain.Content.Brightest = 0.0;
	EXPECT_FALSE(Decide(Chain, "Bloom").bActive);
}

TEST(ContentGates, AnEffectThatMayBrightenTheSceneKeepsBloom)
{
	for (const char* Brightening : {R"("ToonShadowBlurIntensity": 1)", R"("GlowIntensity": 1)",
			 R"("UnityBloomIntensity": 1)", R"("CharaGlowArea": 2)", R"("DualKawaseBlurPassNum": 1)",
			 R"("BloomMethod": "BM_FFT")", R"("LocalExposureShadowContrastScale": 0.5)"})
	{
		FGatedView Chain = MakeChain(R"("BloomThreshold": 2, )" + std::string(Brightening));
		Chain.Content.Brightest = 0.0;
		EXPECT_TRUE(Decide(Chain, "Bloom").bActive) << Brightening;
	}
}

namespace
{

/** An effect that brightens the picture, as somebody would add it: a value of its own and a row in the table. */
const FEffect GBrighten{
	.Id = EEffect::Num,
	.Name = "Brighten",
	.Doc = "Brightens the picture.",
	.Settings = std::span<const FSettingClaim>(),
	.bMayBrightenBeforeBloom = true,
	.Decide =
		[](const FEffect&, const FEffectInputs&) {
			return FEffectDecision{nullptr, true, true, "always"};
		},
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::Lighting}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace

// The gate of bloom keeps no list of names: an effect that is new to the table keeps bloom by its own word.
TEST(ContentGates, ANewEffectThatMayBrightenTheSceneKeepsBloom)
{
	FGatedView Chain = MakeChain(R"("BloomThreshold": 2)");
	Chain.Content.Brightest = 0.0;
	const auto GateBloom = [&](FEffectTable Table)
	{
		return FindEffect(GateByContent(Chain, Chain.Content, DecideBySettings(Chain, Table)), "Bloom").bActive;
	};
	std::vector<const FEffect*> Table(GetEffects().begin(), GetEffects().end());
	EXPECT_FALSE(GateBloom(Table));
	Table.push_back(&GBrighten);
	EXPECT_TRUE(GateBloom(Table));
	EXPECT_FALSE(AskContent(Chain, DecideBySettings(Chain, Table)).bBrightest);
}

// A step looks at what the one before it made, and never goes back: what gates find is no part of what settings decide.
TEST(ContentGates, GatesTakeDecisionsAndLeaveThemAsTheyWere)
{
	FGatedView Chain = MakeChain(R"("BloomToonIntensity": 0.1, "BloomThreshold": 2)");
	const std::vector<FEffectDecision> Decided = DecideBySettings(Chain);
	Chain.Content.Brightest = 0.0;
	const std::vector<FEffectDecision> Gated = GateByContent(Chain, Chain.Content, Decided);
	EXPECT_TRUE(FindEffect(Decided, "Bloom").bActive);
	EXPECT_FALSE(FindEffect(Gated, "Bloom").bActive);
	EXPECT_THAT(FindEffect(Gated, "ToonBloom").Reason, HasSubstr("there is no bloom to mask: nothing is brighter"));
}
