// configs/toon_bloom_volume.json: the factor along the camera's path, and that nothing pops where the volume begins.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "Run/FinalSettings.h"
#include "Run/Run.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

namespace
{

const std::string ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/toon_bloom_volume.json";

/** The camera's walk, cm: from well before the volume into it. */
constexpr double Begin = -135.0;
constexpr double End = 105.0;

FViewSettings SettingsAt(const FConfig& Config, double X)
{
	FConfig Moved = Config;
	Moved.View.Location.Value = {X, 0.0, 145.0};
	Moved.View.Location.Place.Line = 1;
	return MakeViewSettings(Moved);
}

FConfig Load()
{
	std::vector<FDiagnostic> Diagnostics;
	return LoadConfig(ConfigFile, Diagnostics);
}

bool IsToonBloomActive(const FViewSettings& Chain)
{
	const std::vector<FEffectDecision> Effects = DecideEffects(Chain);
	return std::any_of(Effects.begin(), Effects.end(),
		[](const FEffectDecision& Effect) { return Effect.bActive && Effect.GetId() == EEffect::ToonBloom; });
}

FImage RenderAt(const std::string& X)
{
	FRunOptions Options;
	Options.ConfigFile = ConfigFile;
	std::string Text = R"({"scene": {"file": "scenes/moving_camera.0004.exr"}, "view": {"location": [)" + X +
					   R"(, 0, 145]}, "volumes": [
		{"bUnbound": true, "Settings": {"BloomIntensity": 1.5, "BloomToonIntensity": 1}},
		{"bounds": {"min": [0, -250, 0], "max": [600, 250, 300]}, "Priority": 1, "BlendRadius": 100,
			"Settings": {"BloomToonIntensity": 0.05}}]})";
	Options.ConfigText = Text;
	return RunConfig(Options).Final.ToImage();
}

double MaxDifference(const FImage& A, const FImage& B)
{
	double Largest = 0.0;
	for (size_t Index = 0; Index < A.Values.size(); ++Index)
	{
		Largest = std::max(Largest, std::abs(A.Values[Index] - B.Values[Index]));
	}
	return Largest;
}

} // namespace

TEST(ToonBloomVolume, TheFactorFallsEvenlyOverTheBlendRadius)
{
	const FConfig Config = Load();
	EXPECT_FLOAT_EQ(1.0f, SettingsAt(Config, -100.0).Settings.BloomToonIntensity);
	EXPECT_FLOAT_EQ(1.0f + 0.5f * (0.05f - 1.0f), SettingsAt(Config, -50.0).Settings.BloomToonIntensity);
	EXPECT_FLOAT_EQ(0.05f, SettingsAt(Config, 0.0).Settings.BloomToonIntensity);
	EXPECT_FLOAT_EQ(0.05f, SettingsAt(Config, 50.0).Settings.BloomToonIntensity);
}

TEST(ToonBloomVolume, TheFactorHasNoStepAlongThePath)
{
	const FConfig Config = Load();
	constexpr int NumSteps = 960; // a quarter of a centimetre each: at most 0.95 / 100 / 4 of the factor
	float Before = SettingsAt(Config, Begin).Settings.BloomToonIntensity;
	for (int Step = 1; Step <= NumSteps; ++Step)
	{
		const float Factor = SettingsAt(Config, Begin + (End - Begin) * Step / NumSteps).Settings.BloomToonIntensity;
		EXPECT_LE(std::abs(Factor - Before), 0.95f / 400 + 1e-6f) << Step;
		EXPECT_LE(Factor, Before) << Step;
		Before = Factor;
	}
	EXPECT_FLOAT_EQ(0.05f, Before);
}

TEST(ToonBloomVolume, ThePatchComesInWithTheVolume)
{
	const FConfig Config = Load();
	EXPECT_FALSE(IsToonBloomActive(SettingsAt(Config, -101.0)));
	EXPECT_TRUE(IsToonBloomActive(SettingsAt(Config, -99.0)));
}

TEST(ToonBloomVolume, ThePictureDoesNotJumpWhereThePatchComesIn)
{
	const FImage Outside = RenderAt("-100.001");
	const FImage Border = RenderAt("-99.9");
	const FImage Inside = RenderAt("50");
	// A thousandth of the way in: the final picture, 0 to 1 in 8 bits, moves by one step at most.
	EXPECT_LE(MaxDifference(Outside, Border), 1.0 / 255 + 1e-9);
	EXPECT_GT(MaxDifference(Outside, Inside), 4.0 / 255);
}
