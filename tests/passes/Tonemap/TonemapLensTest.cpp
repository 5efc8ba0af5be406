// Vignette, fringe, sharpening, dirt and grain of the tonemapper, each against its formula, without the curve.
#include "TonemapTestUtils.h"

#include "ToneReference.h"

#include "Screen/TextureAssets.h"
#include "Tonemap/TonemapLens.h"

using namespace TonemapTest;
using PassReference::MaxDifference;
using PassTest::FScopedConsoleVariable;
using PassTest::Infinity;
using PassTest::NaN;

namespace
{

using FSettings = FFinalPostProcessSettings;

double Decode(double Code)
{
	return ToneReference::DecodeSrgb(Code);
}

FTonemapRun Plain(const std::function<void(FSettings&)>& More)
{
	return {.Settings = [More](FSettings& Settings)
			{
				Linear(Settings);
				More(Settings);
			}};
}

FTonemapRun Grainy(float Intensity, uint32 Frame = 0)
{
	FTonemapRun Run = Plain([Intensity](FSettings& Settings) { Settings.FilmGrainIntensity = Intensity; });
	Run.FrameNumber = Frame;
	return Run;
}

UTexture2D GDirt;

FTonemapRun Dirty(float Intensity)
{
	FTonemapRun Run = Plain(
		[Intensity](FSettings& Settings)
		{
			GDirt.SetFName(FName("Dirt"));
			Settings.BloomDirtMask = &GDirt;
			Settings.BloomDirtMaskIntensity = Intensity;
			Settings.BloomDirtMaskTint = FLinearColor(1.0f, 0.5f, 0.0f);
		});
	Run.Bloom = FImage(4, 4, {0.125, 0.125, 0.125, 1});
	return Run;
}

} // namespace

TEST(ChromaticAberration, ParametersOfThePublishedPrimaries)
{
	// 0.01 I * 0.007 * (611.3 - 464.3) = 0.01029 I, and 0.007 * (549.1 - 464.3) = 0.5936.
	const FVector4f Parameters = Drydock::ComputeChromaticAberration(5.0f, 0.0f);
	EXPECT_NEAR(0.05 * 1.029, Parameters.X, 1e-7);
	EXPECT_NEAR(0.05 * 0.5936, Parameters.Y, 1e-7);
}

TEST(ChromaticAberration, StartsLaterAndRisesFaster)
{
	const FVector4f Parameters = Drydock::ComputeChromaticAberration(5.0f, 0.5f);
	EXPECT_NEAR(0.1 * 1.029, Parameters.X, 1e-7);
	EXPECT_EQ(0.5f, Parameters.Z);
	EXPECT_EQ(0.0f, Drydock::ComputeChromaticAberration(5.0f, 1.0f).X);
}

TEST(ChromaticAberration, ShiftsRedAndGreenTowardsTheCentreNotBlue)
{
	// A ramp along x: its value tells where a channel was seen. Red, at the right edge less half a texel: position
	// p = 1 - 1 / 100, seen at p - p * 0.05 * 1.029.
	const FImage Ramp = FImage::Make(100, 3,
		[](int X, int)
		{
			const double Value = (X + 0.5) / 100;
			return FTexel{Value, Value, Value, 1};
		});
	FTonemapRun Run = Plain([](FSettings& Settings) { Settings.SceneFringeIntensity = 5; });
	Run.Arithmetic = EArithmetic::Exact;
	const FImage Result = Tonemap(Ramp, Run);
	for (const int X : {10, 50, 99})
	{
		const double Position = (X + 0.5) / 50 - 1;
		EXPECT_NEAR((Position * (1 - 0.05 * 1.029) + 1) / 2, Decode(Result.At(X, 1)[0]), 1e-6) << X;
		EXPECT_NEAR((Position * (1 - 0.05 * 0.5936) + 1) / 2, Decode(Result.At(X, 1)[1]), 1e-6) << X;
		EXPECT_NEAR((Position + 1) / 2, Decode(Result.At(X, 1)[2]), 1e-6) << X;
	}
}

TEST(ChromaticAberration, BelowAHundredthThereIsNone)
{
	const FImage Image = FImage::Noise(9, 7);
	EXPECT_EQ(Tonemap(Image).Texels, Tonemap(Image, {.Settings =
															[](FSettings& S)
														{
															S.SceneFringeIntensity = 0.01f;
														}})
										 .Texels);
}

TEST(Sharpen, AddsASixthOfTheLaplacian)
{
	// Luma differences are small, so that the edge takes off 1/8 at most of what is added: colour 0.5 between
	// neighbours of 0.375, edge 0.125, result 0.5 + (4 * 0.5 - 4 * 0.375) / 6 * (1 - 0.125) * amount 1.
	FImage Image(3, 3, {0.375, 0.375, 0.375, 1});
	Image.At(1, 1) = {0.5, 0.5, 0.5, 1};
	const FImage Result = Tonemap(Image, Plain([](FSettings& S) { S.Sharpen = 1; }));
	EXPECT_NEAR(0.5 + 0.5 / 6 * 0.875, Decode(Result.At(1, 1)[1]), 1e-6);
}

TEST(Sharpen, BrightEdgesAreLeftAlone)
{
	FImage Image(3, 3, {0.25, 0.25, 0.25, 1});
	Image.At(1, 1) = {1.5, 1.5, 1.5, 1};
	EXPECT_EQ(Tonemap(Image, Plain([](FSettings&) {})).Texels,
		Tonemap(Image, Plain([](FSettings& S) { S.Sharpen = 1; })).Texels);
}

TEST(Sharpen, AFlatPictureComesThroughBitForBit)
{
	const FImage Image(7, 5, {0.3, 0.2, 0.1, 1});
	EXPECT_EQ(Tonemap(Image).Texels, Tonemap(Image, {.Settings =
															[](FSettings& S)
														{
															S.Sharpen = 10;
														}})
										 .Texels);
}

TEST(Sharpen, TheVariableBeatsTheSetting)
{
	FPostProcessSettings Settings;
	Settings.Sharpen = 2;
	EXPECT_EQ(2.0f, Drydock::GetSharpenAmount(Settings));
	const FScopedConsoleVariable Variable(TEXT("r.Tonemapper.Sharpen"), 25);
	EXPECT_EQ(10.0f, Drydock::GetSharpenAmount(Settings));
}

TEST(Sharpen, HazardsStayInTheDisplay)
{
	FImage Image(3, 3, {0.25, 0.25, 0.25, 1});
	Image.At(0, 1) = {NaN, Infinity, -Infinity, 1};
	Image.At(2, 1) = {65504, 0, 0, 1};
	const FImage Result = Tonemap(Image, {.Settings = [](FSettings& S)
											 {
												 S.Sharpen = 10;
											 }});
	for (const FTexel& Texel : Result.Texels)
	{
		EXPECT_TRUE(Texel[0] >= 0 && Texel[0] < 1.2 && Texel[1] >= 0 && Texel[1] < 1.2) << Texel[0] << " " << Texel[1];
	}
}

TEST(DirtMask, BrightensTheBloomByItsTintAndIntensity)
{
	// 1 + 0.5 * tint * 2 times bloom, added to 0.25.
	const Drydock::FScopedTextureLoader Loader([](const std::string&)
		{ return Drydock::MakePictureTexture(FIntPoint(1, 1), {FLinearColor(0.5f, 0.5f, 0.5f)}, "Dirt"); });
	const FTexel Result = Tonemap(FImage(8, 8, {0.25, 0.25, 0.25, 1}), Dirty(2)).At(3, 4);
	EXPECT_NEAR(0.25 + 0.125 * 2, Decode(Result[0]), 1e-6);
	EXPECT_NEAR(0.25 + 0.125 * 1.5, Decode(Result[1]), 1e-6);
	EXPECT_NEAR(0.25 + 0.125, Decode(Result[2]), 1e-6);
}

TEST(DirtMask, IsStretchedOverTheView)
{
	const Drydock::FScopedTextureLoader Loader(
		[](const std::string&) {
			return Drydock::MakePictureTexture(FIntPoint(2, 1), {FLinearColor(0, 0, 0), FLinearColor(1, 1, 1)}, "Dirt");
		});
	const FImage Result = Tonemap(FImage(8, 8, {0, 0, 0, 1}), Dirty(1));
	EXPECT_NEAR(0.125, Decode(Result.At(0, 0)[0]), 1e-6);
	EXPECT_NEAR(0.25, Decode(Result.At(7, 7)[0]), 1e-6);
}

TEST(DirtMask, WithoutPixelsThereIsNone)
{
	const FTexel Result = Tonemap(FImage(8, 8, {0.25, 0.25, 0.25, 1}), Dirty(2)).At(3, 4);
	EXPECT_NEAR(0.25 + 0.125, Decode(Result[0]), 1e-6);
}

TEST(FilmGrain, KeepsTheMeanAndSpreadsByItsIntensity)
{
	// A triangle over 0..2: mean 1, variance 1/6. 128 x 128 samples: the mean's deviation is sqrt(1/6) / 128 = 0.0032.
	const FImage Result = Tonemap(FImage(128, 128, {0.25, 0.25, 0.25, 1}), Grainy(0.5f));
	double Sum = 0, Squares = 0;
	for (const FTexel& Texel : Result.Texels)
	{
		const double Factor = Decode(Texel[1]) / 0.25;
		Sum += Factor;
		Squares += (Factor - 1) * (Factor - 1);
		EXPECT_TRUE(Factor > 0.49 && Factor < 1.51);
	}
	EXPECT_NEAR(1, Sum / (128 * 128), 4 * 0.5 * 0.0032);
	EXPECT_NEAR(0.25 / 6, Squares / (128 * 128), 0.03 * 0.25 / 6);
}

TEST(FilmGrain, IsTheSameForAFrameAndAnotherForTheNext)
{
	const FImage Image(16, 16, {0.25, 0.25, 0.25, 1});
	EXPECT_EQ(Tonemap(Image, Grainy(1, 3)).Texels, Tonemap(Image, Grainy(1, 3)).Texels);
	EXPECT_NE(Tonemap(Image, Grainy(1, 3)).Texels, Tonemap(Image, Grainy(1, 4)).Texels);
	EXPECT_EQ(Tonemap(Image, Grainy(1, 3)).Texels, Tonemap(Image, Grainy(1, 100)).Texels); // 97 later
}

TEST(FilmGrain, IntensityFollowsTheLuminance)
{
	const FTonemapRun OnlyShadows = Plain(
		[](FSettings& Settings)
		{
			Settings.FilmGrainIntensity = 1;
			Settings.FilmGrainIntensityMidtones = 0;
			Settings.FilmGrainIntensityHighlights = 0;
		});
	const FImage Bright(16, 16, {0.25, 0.25, 0.25, 1}), Dark(16, 16, {0.015625, 0.015625, 0.015625, 1});
	EXPECT_EQ(Tonemap(Bright, Plain([](FSettings&) {})).Texels, Tonemap(Bright, OnlyShadows).Texels);
	EXPECT_NE(Tonemap(Dark, Plain([](FSettings&) {})).Texels, Tonemap(Dark, OnlyShadows).Texels);
}

TEST(FilmGrain, LargerTexelsCoverMorePixels)
{
	FTonemapRun Run = Plain(
		[](FSettings& Settings)
		{
			Settings.FilmGrainIntensity = 1;
			Settings.FilmGrainTexelSize = 2;
		});
	const FImage Result = Tonemap(FImage(8, 8, {0.25, 0.25, 0.25, 1}), Run);
	EXPECT_EQ(Result.At(0, 0), Result.At(1, 1));
	EXPECT_NE(Result.At(1, 1), Result.At(2, 1));
}

TEST(FilmGrain, TheVariableSwitchesItOff)
{
	const FScopedConsoleVariable Off(TEXT("r.FilmGrain"), 0);
	const FImage Image(8, 8, {0.25, 0.25, 0.25, 1});
	EXPECT_EQ(Tonemap(Image, Plain([](FSettings&) {})).Texels, Tonemap(Image, Grainy(1)).Texels);
}

namespace
{

/** Codes of 0 .. Largest that a flat grey, by its linear light, becomes. */
std::vector<double> DitherCodes(double Light, EPixelFormat Format, double Largest, uint32 Frame = 0)
{
	const FScopedConsoleVariable On(TEXT("r.Tonemapper.GrainQuantization"), 1);
	FTonemapRun Run = Plain([](FSettings&) {});
	Run.Arithmetic = EArithmetic::Native;
	Run.OutputFormat = Format;
	Run.FrameNumber = Frame;
	std::vector<double> Codes;
	for (const FTexel& Texel : Tonemap(FImage(256, 256, {Light, Light, Light, 1}), Run).Texels)
	{
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			Codes.push_back(Texel[Channel] * Largest);
		}
	}
	return Codes;
}

} // namespace

TEST(GrainQuantization, TheMeanOfTheCodesIsTheGreyBetweenThem)
{
	std::mt19937 Random(9);
	std::uniform_real_distribution<double> Grey(0.05, 0.95);
	for (const auto& [Format, Largest] : {std::pair(PF_B8G8R8A8, 255.0), {PF_A2B10G10R10, 1023.0}})
	{
		for (int Case = 0; Case < 6; ++Case)
		{
			const double Code = Grey(Random);
			const std::vector<double> Codes = DitherCodes(Decode(Code), Format, Largest);
			double Sum = 0;
			for (const double Value : Codes)
			{
				Sum += Value;
				EXPECT_LT(std::abs(Value - Code * Largest), 1.0);
			}
			// Two neighbouring codes: a deviation of at most half a code; 3 * 256^2 of them.
			EXPECT_NEAR(Code * Largest, Sum / Codes.size(), 4 * 0.5 / std::sqrt(3.0 * 256 * 256))
				<< Code << " " << Largest;
		}
	}
}

TEST(GrainQuantization, AValueOnACodeStaysThere)
{
	for (const int Code : {0, 1, 100, 255})
	{
		// The curve gives the code but for a few of its last bits, so a few pixels of 100000 may leave it.
		const std::vector<double> Codes = DitherCodes(Decode(Code / 255.0), PF_B8G8R8A8, 255);
		const auto Stay = std::ranges::count_if(Codes, [&](double Value) { return std::abs(Value - Code) < 1e-6; });
		EXPECT_GT(Stay, Codes.size() * (1 - 1e-4)) << Code;
	}
}

TEST(GrainQuantization, IsTheSameForAFrameAndAnotherForTheNext)
{
	const double Light = Decode(100.5 / 255);
	EXPECT_EQ(DitherCodes(Light, PF_B8G8R8A8, 255, 3), DitherCodes(Light, PF_B8G8R8A8, 255, 3));
	EXPECT_NE(DitherCodes(Light, PF_B8G8R8A8, 255, 3), DitherCodes(Light, PF_B8G8R8A8, 255, 4));
}

TEST(GrainQuantization, LeavesFloatOutputsAndDefaultsAlone)
{
	const FImage Image = MakeSwatches();
	const FTonemapRun Plainly = Plain([](FSettings&) {});
	const FImage Expected = Tonemap(Image, Plainly);
	const FScopedConsoleVariable On(TEXT("r.Tonemapper.GrainQuantization"), 1);
	EXPECT_EQ(Expected.Texels, Tonemap(Image, Plainly).Texels);
	EXPECT_EQ(0.0f, Drydock::GetGrainQuantizationStep(PF_FloatRGBA));
	const FScopedConsoleVariable Off(TEXT("r.Tonemapper.GrainQuantization"), 0);
	EXPECT_EQ(0.0f, Drydock::GetGrainQuantizationStep(PF_B8G8R8A8));
}

namespace
{

UTexture2D GGrain;

FTonemapRun Pictured(float Intensity, float TexelSize, uint32 Frame = 0)
{
	FTonemapRun Run = Plain(
		[=](FSettings& Settings)
		{
			GGrain.SetFName(FName("Grain"));
			Settings.FilmGrainTexture = &GGrain;
			Settings.FilmGrainIntensity = Intensity;
			Settings.FilmGrainTexelSize = TexelSize;
		});
	Run.FrameNumber = Frame;
	return Run;
}

} // namespace

TEST(FilmGrainTexture, RepeatsOverTheViewDividedByItsMean)
{
	// Red is 1, 2, 3 and 6 of a mean of 3; the offset of the frame is one and the same for all pixels.
	const double Reds[4] = {1, 2, 3, 6};
	const Drydock::FScopedTextureLoader Loader(
		[&](const std::string&)
		{
			std::vector<FLinearColor> Colors;
			for (const double Red : Reds)
			{
				Colors.emplace_back(static_cast<float>(Red), 0.5f, 0.25f);
			}
			return Drydock::MakePictureTexture(FIntPoint(4, 1), Colors, "Grain");
		});
	for (const int TexelSize : {1, 2})
	{
		const FImage Result =
			Tonemap(FImage(16, 3, {0.25, 0.25, 0.25, 1}), Pictured(0.5f, static_cast<float>(TexelSize)));
		int Matches = 0;
		for (int Offset = 0; Offset < 4; ++Offset)
		{
			double Largest = 0;
			for (int X = 0; X < 16; ++X)
			{
				// Bilinear: a texel of grain of two pixels has its centre between them.
				const double At = (X + 0.5) / TexelSize - 0.5 + Offset;
				const double Left = Reds[static_cast<int>(std::floor(At + 4)) % 4];
				const double Right = Reds[static_cast<int>(std::floor(At + 4) + 1) % 4];
				const double Red = Left + (Right - Left) * (At - std::floor(At));
				Largest = std::max(Largest, std::abs(0.25 * (0.5 + 0.5 * Red / 3) - Decode(Result.At(X, 1)[0])));
			}
			Matches += Largest < 1e-4 ? 1 : 0;
		}
		EXPECT_EQ(1, Matches) << TexelSize;
		// Even channels are their own mean.
		EXPECT_NEAR(0.25, Decode(Result.At(5, 2)[1]), 1e-5);
		EXPECT_NEAR(0.25, Decode(Result.At(5, 2)[2]), 1e-5);
	}
}

TEST(FilmGrainTexture, MovesFromFrameToFrame)
{
	const Drydock::FScopedTextureLoader Loader(
		[](const std::string&)
		{
			std::vector<FLinearColor> Colors(64 * 64);
			std::mt19937 Random(5);
			for (FLinearColor& Color : Colors)
			{
				Color.R = Color.G = Color.B = static_cast<float>(Random() % 1000) / 1000;
			}
			return Drydock::MakePictureTexture(FIntPoint(64, 64), Colors, "Grain");
		});
	const FImage Image(64, 64, {0.25, 0.25, 0.25, 1});
	const FImage First = Tonemap(Image, Pictured(1, 1, 3));
	EXPECT_EQ(First.Texels, Tonemap(Image, Pictured(1, 1, 3)).Texels);
	EXPECT_NE(First.Texels, Tonemap(Image, Pictured(1, 1, 4)).Texels);
	EXPECT_EQ(First.Texels, Tonemap(Image, Pictured(1, 1, 100)).Texels); // 97 later
	// The whole picture once: the light stays.
	double Sum = 0;
	for (const FTexel& Texel : First.Texels)
	{
		Sum += Decode(Texel[1]);
	}
	EXPECT_NEAR(0.25, Sum / (64 * 64), 1e-3);
}

TEST(FilmGrainTexture, WithoutPixelsTheNoiseStays)
{
	const FImage Image(16, 16, {0.25, 0.25, 0.25, 1});
	EXPECT_EQ(Tonemap(Image, Grainy(1)).Texels, Tonemap(Image, Pictured(1, 1)).Texels);
}
