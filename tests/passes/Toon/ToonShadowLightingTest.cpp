// The three uses of the blurred toon shadow in lighting, and the ramp, against the article's formulas in double.
#include "PassTestUtils.h"

#include "Screen/TextureAssets.h"
#include "Toon/ToonShadowBlur.h"

#include <random>

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

struct FLightingRun
{
	FTexel Color = {0.5, 0.25, 2, 1};
	FTexel Shadow = {0.2, 1, 0, 0.6}; // multiples of 1/5 are multiples of 1/255
	FTexel BaseColor = {1, 0.5, 0.25, 1};
	int ShadingModel = 8;
	FToonShadowLightingInputs Inputs;

	FTexel Run() const
	{
		FPassRun Pass(FImage(4, 4, Color), EArithmetic::Float32, PF_A32B32G32R32F);
		FSceneTextures SceneTextures;
		SceneTextures.GBufferB =
			Pass.AddInput(FImage(4, 4, {0, 0, 0, (0x30 | ShadingModel) / 255.0}), PF_B8G8R8A8, TEXT("GBufferB"))
				.Texture;
		SceneTextures.GBufferC = Pass.AddInput(FImage(4, 4, BaseColor), PF_A32B32G32R32F, TEXT("GBufferC")).Texture;
		FToonShadowLightingInputs Lighting = Inputs;
		Lighting.SceneColor = Pass.Input;
		Lighting.ToonShadow = Pass.AddInput(FImage(4, 4, Shadow), PF_A32B32G32R32F, TEXT("ToonShadow"));
		Lighting.SceneTextures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, &SceneTextures);
		return Pass.Execute(AddToonShadowLightingPass(Pass.GraphBuilder, Pass.View, Lighting)).At(2, 1);
	}
};

void ExpectColor(const FTexel& Expected, const FTexel& Color)
{
	for (int Channel = 0; Channel < 4; ++Channel)
	{
		EXPECT_NEAR(Expected[Channel], Color[Channel], 1e-6) << Channel;
	}
}

/** Red, green and blue only, relative to the largest of them where that is above 1. */
void ExpectNear(const FTexel& Expected, const FTexel& Color, double Bound, const std::string& Where)
{
	const double Scale = std::max({1.0, std::abs(Expected[0]), std::abs(Expected[1]), std::abs(Expected[2])});
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		EXPECT_NEAR(Expected[Channel], Color[Channel], Bound * Scale) << Where << ", channel " << Channel;
	}
}

/** Lit colours of both signs and above 1, shadows, light and base colour by chance. */
FLightingRun DrawLighting(std::mt19937& Random)
{
	const auto Draw = [&](double Min, double Max)
	{
		return std::uniform_real_distribution<double>(Min, Max)(Random);
	};
	const auto DrawColor = [&](double Min, double Max)
	{
		return FTexel{Draw(Min, Max), Draw(Min, Max), Draw(Min, Max), 1};
	};
	FLightingRun Lighting;
	Lighting.Color = DrawColor(-2, 8);
	Lighting.Shadow = {Draw(0, 1), Draw(0, 1), 0, Draw(0, 1)};
	Lighting.BaseColor = DrawColor(0, 1);
	Lighting.Inputs.Store = EToonShadowBlurStore::SixteenBit;
	Lighting.Inputs.Intensity = static_cast<float>(Draw(0, 1));
	Lighting.Inputs.LightColor = FLinearColor(1, static_cast<float>(Draw(0, 1)), static_cast<float>(Draw(0, 1)), 1);
	return Lighting;
}

/** Intensity times light times base colour. */
FTexel GetLight(const FLightingRun& Lighting)
{
	const FLinearColor& Light = Lighting.Inputs.LightColor;
	const double Colors[] = {Light.R, Light.G, Light.B};
	FTexel Result = {0, 0, 0, 0};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Result[Channel] =
			static_cast<double>(Lighting.Inputs.Intensity) * Colors[Channel] * Lighting.BaseColor[Channel];
	}
	return Result;
}

FTextureRHIRef MakeRamp(const std::vector<FTexel>& Colors, int Height = 1)
{
	std::vector<FLinearColor> Texels;
	for (int Row = 0; Row < Height; ++Row)
	{
		for (const FTexel& Color : Colors)
		{
			Texels.push_back(FLinearColor(
				static_cast<float>(Color[0]), static_cast<float>(Color[1]), static_cast<float>(Color[2]), 1.0f));
		}
	}
	return MakePictureTexture(FIntPoint(static_cast<int32>(Colors.size()), Height), Texels, "Ramp");
}

/** The ramp's colour between its texels, ends at their centres. */
FTexel LookUp(const std::vector<FTexel>& Ramp, double Shadow)
{
	const double At = Shadow * static_cast<double>(Ramp.size() - 1);
	const size_t Left = std::min(static_cast<size_t>(At), Ramp.size() - 1), Right = std::min(Left + 1, Ramp.size() - 1);
	FTexel Color = {0, 0, 0, 1};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Color[Channel] =
			Ramp[Left][Channel] + (At - static_cast<double>(Left)) * (Ramp[Right][Channel] - Ramp[Left][Channel]);
	}
	return Color;
}

std::vector<FTexel> DrawRamp(std::mt19937& Random, size_t Width)
{
	std::uniform_real_distribution<double> Draw(0, 2);
	std::vector<FTexel> Ramp;
	while (Ramp.size() < Width)
	{
		Ramp.push_back({Draw(Random), Draw(Random), Draw(Random), 1});
	}
	return Ramp;
}

} // namespace

TEST(ToonShadowLighting, ScreenOfLightAndBlurredShadow)
{
	FLightingRun Lighting;
	Lighting.Inputs.Store = EToonShadowBlurStore::SixteenBit;
	Lighting.Inputs.LightColor = FLinearColor(1, 0.5f, 1, 1);
	// b = 0.6 * light * base = 0.6, 0.15, 0.15. Red: 1 - 0.5 * 0.4. Green: 1 - 0.75 * 0.85. Blue: lit is 2, of which 1
	// is screened (1 - 0 * 0.85 = 1) and 1 is kept.
	ExpectColor({0.8, 0.3625, 2, 1}, Lighting.Run());
}

TEST(ToonShadowLighting, AsPrintedTheScreenDarkensWhatIsAboveOne)
{
	FLightingRun Lighting;
	Lighting.Inputs.Store = EToonShadowBlurStore::SixteenBit;
	Lighting.Inputs.bAsPrinted = true;
	// Blue: 1 - (1 - 2)(1 - 0.6 * 0.25) = 1.85.
	ExpectColor({0.8, 1 - 0.75 * 0.7, 1.85, 1}, Lighting.Run());
}

TEST(ToonShadowLighting, BothScreensAgreeBetweenZeroAndOne)
{
	FLightingRun Lighting;
	Lighting.Color = {0.5, 0.25, 0.75, 1};
	const FTexel Corrected = Lighting.Run();
	Lighting.Inputs.bAsPrinted = true;
	ExpectColor(Corrected, Lighting.Run());
}

TEST(ToonShadowLighting, SquareRootStoreIsSquared)
{
	FLightingRun Lighting;
	Lighting.Inputs.Blend = EToonShadowBlurBlend::Max; // shadow 0.2, blurred 0.36
	ExpectColor({0.5 + 0.16, 0.25 + 0.16 * 0.5, 2 + 0.16 * 0.25, 1}, Lighting.Run());
}

TEST(ToonShadowLighting, MaxNeverTouchesTheBrightSide)
{
	FLightingRun Lighting;
	Lighting.Inputs.Blend = EToonShadowBlurBlend::Max;
	Lighting.Shadow = {1, 1, 0, 0.6};
	EXPECT_EQ((FTexel{0.5, 0.25, 2, 1}), Lighting.Run());
}

TEST(ToonShadowLighting, IntensityScalesTheAddedLight)
{
	FLightingRun Lighting;
	Lighting.Inputs.Blend = EToonShadowBlurBlend::Max;
	Lighting.Inputs.Intensity = 0.5f;
	ExpectColor({0.5 + 0.08, 0.25 + 0.04, 2 + 0.02, 1}, Lighting.Run());
}

TEST(ToonShadowLighting, IntensityZeroIsTheIdentityBitForBit)
{
	FLightingRun Lighting;
	Lighting.Inputs.Intensity = 0.0f;
	for (const EToonShadowBlurBlend Blend :
		{EToonShadowBlurBlend::Screen, EToonShadowBlurBlend::Max, EToonShadowBlurBlend::Add})
	{
		Lighting.Inputs.Blend = Blend;
		EXPECT_EQ((FTexel{0.5, 0.25, 2, 1}), Lighting.Run());
	}
}

TEST(ToonShadowLighting, OnlyToonPixelsChange)
{
	FLightingRun Lighting;
	for (const int ShadingModel : {0, 1, 4, 6, 7, 9})
	{
		Lighting.ShadingModel = ShadingModel;
		EXPECT_EQ((FTexel{0.5, 0.25, 2, 1}), Lighting.Run()) << ShadingModel;
	}
}

TEST(ToonShadowLighting, CorrectedIsNeverNegativeNorDarker)
{
	for (const double Lit : {-3.0, 0.0, 0.5, 1.0, 7.0, 65504.0})
	{
		FLightingRun Lighting;
		Lighting.Color = {Lit, Lit, Lit, 1};
		const FTexel Result = Lighting.Run();
		EXPECT_GE(Result[0], std::max(0.0, Lit)) << Lit;
	}
}

TEST(ToonShadowLighting, AddIsTheSumOfColorAndLight)
{
	std::mt19937 Random(21);
	for (int Step = 0; Step < 40; ++Step)
	{
		FLightingRun Lighting = DrawLighting(Random);
		Lighting.Inputs.Blend = EToonShadowBlurBlend::Add;
		const FTexel Light = GetLight(Lighting);
		FTexel Expected = Lighting.Color;
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			Expected[Channel] += Lighting.Shadow[3] * Light[Channel];
		}
		const FTexel Corrected = Lighting.Run();
		ExpectNear(Expected, Corrected, 1e-6, "step " + std::to_string(Step));
		Lighting.Inputs.bAsPrinted = true;
		EXPECT_EQ(Corrected, Lighting.Run()) << Step;
	}
}

TEST(ToonShadowLighting, AddSquaresTheSquareRootStore)
{
	FLightingRun Lighting;
	Lighting.Inputs.Blend = EToonShadowBlurBlend::Add; // blurred 0.36, light 1, 0.5, 0.25
	ExpectColor({0.5 + 0.36, 0.25 + 0.18, 2 + 0.09, 1}, Lighting.Run());
}

TEST(ToonShadowLighting, AddKeepsWhatIsNotFinite)
{
	FLightingRun Lighting;
	Lighting.Inputs.Blend = EToonShadowBlurBlend::Add;
	Lighting.Color = {NaN, Infinity, -Infinity, 1};
	const FTexel Result = Lighting.Run();
	EXPECT_TRUE(std::isnan(Result[0]));
	EXPECT_EQ(Infinity, Result[1]);
	EXPECT_EQ(-Infinity, Result[2]);
}

TEST(ToonShadowLighting, MaxLooksItsLightUpInTheRamp)
{
	std::mt19937 Random(22);
	for (int Step = 0; Step < 60; ++Step)
	{
		FLightingRun Lighting = DrawLighting(Random);
		const std::vector<FTexel> Ramp = DrawRamp(Random, 1 + static_cast<size_t>(Step % 6));
		Lighting.Inputs.Blend = EToonShadowBlurBlend::Max;
		Lighting.Inputs.Ramp = MakeRamp(Ramp, 1 + Step % 3);
		const double Shadow = std::min(Lighting.Shadow[0], Lighting.Shadow[1]);
		const FTexel Before = LookUp(Ramp, Shadow), After = LookUp(Ramp, std::max(Shadow, Lighting.Shadow[3]));
		const FTexel Light = GetLight(Lighting);
		FTexel Expected = Lighting.Color;
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			// What a falling ramp takes is no more than is there.
			Expected[Channel] +=
				std::max((After[Channel] - Before[Channel]) * Light[Channel], -std::max(Lighting.Color[Channel], 0.0));
		}
		// A sampler steps by 1/256 of a texel, and neighbours differ by up to 2: half a step on either side.
		ExpectNear(Expected, Lighting.Run(), 2.0 / 256 + 1e-5, "step " + std::to_string(Step));
	}
}

TEST(ToonShadowLighting, EndsOfTheRampAreItsOuterTexels)
{
	FLightingRun Lighting;
	Lighting.Color = {0, 0, 0, 1};
	Lighting.Shadow = {0, 1, 0, 1};
	Lighting.BaseColor = {1, 1, 1, 1};
	Lighting.Inputs.Blend = EToonShadowBlurBlend::Max;
	Lighting.Inputs.Ramp = MakeRamp({{0.25, 0, 0, 1}, {9, 9, 9, 1}, {1, 0.5, 0.125, 1}});
	ExpectColor({0.75, 0.5, 0.125, 1}, Lighting.Run());
}

TEST(ToonShadowLighting, RampFromBlackToWhiteIsTheMaxWithoutOne)
{
	std::mt19937 Random(23);
	std::vector<FTexel> Straight;
	for (int Index = 0; Index < 256; ++Index)
	{
		Straight.push_back({Index / 255.0, Index / 255.0, Index / 255.0, 1});
	}
	for (int Step = 0; Step < 20; ++Step)
	{
		FLightingRun Lighting = DrawLighting(Random);
		Lighting.Inputs.Blend = EToonShadowBlurBlend::Max;
		const FTexel Plain = Lighting.Run();
		Lighting.Inputs.Ramp = MakeRamp(Straight);
		ExpectNear(Plain, Lighting.Run(), 2e-5, "step " + std::to_string(Step));
	}
}

TEST(ToonShadowLighting, RampNeverTouchesTheBrightSide)
{
	std::mt19937 Random(24);
	for (int Step = 0; Step < 20; ++Step)
	{
		FLightingRun Lighting = DrawLighting(Random);
		Lighting.Shadow[3] *= std::min(Lighting.Shadow[0], Lighting.Shadow[1]);
		Lighting.Inputs.Blend = EToonShadowBlurBlend::Max;
		Lighting.Inputs.Ramp = MakeRamp(DrawRamp(Random, 5));
		const FTexel Result = Lighting.Run();
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			EXPECT_EQ(static_cast<float>(Lighting.Color[Channel]), static_cast<float>(Result[Channel])) << Step;
		}
	}
}

TEST(ToonShadowLighting, RampIsForMaxOnly)
{
	std::mt19937 Random(25);
	for (const EToonShadowBlurBlend Blend : {EToonShadowBlurBlend::Screen, EToonShadowBlurBlend::Add})
	{
		FLightingRun Lighting = DrawLighting(Random);
		Lighting.Inputs.Blend = Blend;
		const FTexel Plain = Lighting.Run();
		Lighting.Inputs.Ramp = MakeRamp({{3, 0, 0, 1}, {0, 3, 0, 1}});
		EXPECT_EQ(Plain, Lighting.Run());
	}
}

TEST(ToonShadowLighting, OverrideOutputIsWritten)
{
	FPassRun Pass(FImage(4, 4, {1, 1, 1, 1}), EArithmetic::Float32, PF_A32B32G32R32F);
	FToonShadowLightingInputs Inputs;
	Inputs.SceneColor = Pass.Input;
	Inputs.ToonShadow = Pass.AddInput(FImage(4, 4, {1, 1, 0, 1}), PF_R8G8B8A8, TEXT("ToonShadow"));
	Inputs.SceneTextures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, nullptr);
	Inputs.OverrideOutput = FScreenPassRenderTarget::CreateFromInput(
		Pass.GraphBuilder, Pass.Input, ERenderTargetLoadAction::ENoAction, TEXT("Override"));
	const FScreenPassTexture Output = AddToonShadowLightingPass(Pass.GraphBuilder, Pass.View, Inputs);
	EXPECT_EQ(Inputs.OverrideOutput.Texture, Output.Texture);
	Pass.Execute(Output);
}
