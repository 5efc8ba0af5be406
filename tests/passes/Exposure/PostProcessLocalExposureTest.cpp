// Local exposure against a second computation in double: the bilateral grid, the blurred luminance, the factor; where
// it is applied, and hazards.
#include "ExposureTestUtils.h"
#include "PassTestUtils.h"

#include "Bloom/PostProcessBloomSetup.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "Tonemap/PostProcessTonemap.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::EAddress;
using PassReference::MaxDifference;

namespace
{

struct FLocal
{
	float Highlight = 1.0f;
	float Shadow = 1.0f;
	float Detail = 1.0f;
	float HighlightThreshold = 0.0f;
	float ShadowThreshold = 0.0f;
	float Blend = 0.6f;
	float KernelSizePercent = 10.0f;
	float MiddleGreyBias = 0.0f;
	float ExposureScale = 1.0f;
	float PreExposure = 1.0f;
	bool bCompute = false;
};

FLocal Highlights(float Contrast)
{
	FLocal Local;
	Local.Highlight = Contrast;
	return Local;
}

FLocal Shadows(float Contrast)
{
	FLocal Local;
	Local.Shadow = Contrast;
	return Local;
}

/** Adds grid and blur of the run's input. */
FLocalExposureTextures AddLocalExposure(FPassRun& Run, const FLocal& Local)
{
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.LocalExposureHighlightContrastScale = Local.Highlight;
	Settings.LocalExposureShadowContrastScale = Local.Shadow;
	Settings.LocalExposureDetailStrength = Local.Detail;
	Settings.LocalExposureHighlightThreshold = Local.HighlightThreshold;
	Settings.LocalExposureShadowThreshold = Local.ShadowThreshold;
	Settings.LocalExposureBlurredLuminanceBlend = Local.Blend;
	Settings.LocalExposureMiddleGreyBias = Local.MiddleGreyBias;
	Run.View.PreExposure = Local.PreExposure;
	Run.View.InitViewUniformBuffer(Run.Input.Texture->Desc.Extent);
	Run.View.bUseComputePasses = Local.bCompute;

	FLocalExposureTextures Textures;
	Textures.EyeAdaptation = GetEyeAdaptationParameters(Run.View, AEM_Histogram, true);
	Textures.Parameters =
		GetLocalExposureParameters(Run.View, Run.Input.ViewRect.Size(), Textures.EyeAdaptation, false);
	Textures.BilateralGrid = AddLocalExposurePass(Run.GraphBuilder, Run.View, Textures.EyeAdaptation, Run.Input);
	Textures.BlurredLogLuminance = AddLocalExposureBlurredLogLuminancePass(
		Run.GraphBuilder, Run.View, Textures.EyeAdaptation, Run.Input, Local.KernelSizePercent);
	return Textures;
}

/** The run's input times its factor: what bloom setup does without a threshold. */
FImage Apply(FPassRun& Run, const FLocal& Local)
{
	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, Local.ExposureScale);
	Inputs.Threshold = -1.0f;
	const FLocalExposureTextures Textures = AddLocalExposure(Run, Local);
	Textures.GiveTo(Inputs);
	return Run.Execute(AddBloomSetupPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage Apply(const FImage& Image, const FLocal& Local, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic, PF_A32B32G32R32F);
	return Apply(Run, Local);
}

double ApplyToGrey(double Luminance, const FLocal& Local)
{
	return Apply(Grey(Luminance, 3, 2), Local).At(1, 1)[0];
}

/** Middle grey times a power of two. */
double Stops(double Number)
{
	return 0.18 * std::exp2(Number);
}

/** The second computation, for the histogram's default range. */
class FReference
{
public:
	FReference(const FImage& InImage, const FLocal& InLocal)
		: Image(InImage)
		, Local(InLocal)
		, CellsX((Image.Width + 63) / 64)
		, CellsY((Image.Height + 63) / 64)
		, Grid(static_cast<size_t>(CellsX * CellsY * 32))
	{
		FImage Logs(Image.Width, Image.Height);
		for (int Y = 0; Y < Image.Height; ++Y)
		{
			for (int X = 0; X < Image.Width; ++X)
			{
				const double Log = GetLog(Image.At(X, Y));
				Logs.At(X, Y) = {Log, 0, 0, 0};
				for (int Z = 0; Z < 32; ++Z)
				{
					const double Weight = std::max(0.0, 1 - std::abs(GetDepth(Log) - Z)) / 4096;
					FCell& Cell = At(X / 64, Y / 64, Z);
					Cell.Log += Log * Weight;
					Cell.Weight += Weight;
				}
			}
		}
		const double Radius = Image.Width * static_cast<double>(Local.KernelSizePercent) * 0.005;
		Blurred = PassReference::GaussianBlur(Logs, Radius, static_cast<int>(std::ceil(Radius)), EAddress::Mirror);
	}

	double GetFactor(int X, int Y) const
	{
		// The bloom setup looks both up at the pixel's corner, as the engine does.
		const int Left = std::max(X - 1, 0), Above = std::max(Y - 1, 0);
		const double Log = GetLog(Image.At(X, Y));
		const double Blur =
			(Blurred.At(Left, Above)[0] + Blurred.At(X, Above)[0] + Blurred.At(Left, Y)[0] + Blurred.At(X, Y)[0]) / 4;
		const FCell Cell = Lookup(X / 64.0 - 0.5, Y / 64.0 - 0.5, GetDepth(Log));
		const double Bilateral = Cell.Weight < 0.001 ? Blur : Cell.Log / Cell.Weight;
		const double Exposure = std::log2(static_cast<double>(Local.ExposureScale));
		const double Base = Bilateral + (Blur - Bilateral) * static_cast<double>(Local.Blend) + Exposure;
		const double Grey = std::log2(0.18) + static_cast<double>(Local.MiddleGreyBias);
		const double Contrast = static_cast<double>(Base > Grey ? Local.Highlight : Local.Shadow);
		const double Out =
			Grey + (Base - Grey) * Contrast + (Log + Exposure - Base) * static_cast<double>(Local.Detail);
		return std::exp2(Out - Log - Exposure);
	}

	FImage GetResult() const
	{
		return FImage::Make(Image.Width, Image.Height,
			[&](int X, int Y)
			{
				const FTexel Color = Image.At(X, Y) * GetFactor(X, Y);
				return FTexel{Color[0], Color[1], Color[2], 0};
			});
	}

private:
	struct FCell
	{
		double Log = 0, Weight = 0;
	};

	double GetLog(const FTexel& Color) const
	{
		return std::log2(std::max((Color[0] + Color[1] + Color[2]) / 3, 1.0 / 256));
	}
	static double GetDepth(double Log) { return std::clamp((Log + 8) / 12, 0.0, 1.0) * 31; }
	FCell& At(int X, int Y, int Z) { return Grid[static_cast<size_t>((Z * CellsY + Y) * CellsX + X)]; }

	FCell Lookup(double X, double Y, double Z) const
	{
		const auto Tent = [](double At, int Index, int Size)
		{
			return std::max(0.0, 1 - std::abs(std::clamp(At, 0.0, Size - 1.0) - Index));
		};
		FCell Sum;
		for (int CellZ = 0; CellZ < 32; ++CellZ)
		{
			for (int CellY = 0; CellY < CellsY; ++CellY)
			{
				for (int CellX = 0; CellX < CellsX; ++CellX)
				{
					const double Weight = Tent(X, CellX, CellsX) * Tent(Y, CellY, CellsY) * Tent(Z, CellZ, 32);
					const FCell& Cell = Grid[static_cast<size_t>((CellZ * CellsY + CellY) * CellsX + CellX)];
					Sum.Log += Cell.Log * Weight;
					Sum.Weight += Cell.Weight * Weight;
				}
			}
		}
		return Sum;
	}

	FImage Image;
	FLocal Local;
	int CellsX, CellsY;
	std::vector<FCell> Grid;
	FImage Blurred;
};

/** A dark and a bright half with detail in both. */
FImage HalfLit(int Width, int Height)
{
	const FImage Noise = FImage::Noise(Width, Height, 1, 7);
	return FImage::Make(Width, Height,
		[&](int X, int Y)
		{
			const double Light = X * 3 < Width ? 0.03125 : 4.0;
			const FTexel& Detail = Noise.At(X, Y);
			return FTexel{Light * (0.5 + Detail[0]), Light * (0.5 + Detail[1]), Light * (0.5 + Detail[2]), 1};
		});
}

double LargestRelativeDifference(const FImage& Expected, const FImage& Actual)
{
	double Largest = 0;
	for (size_t Index = 0; Index < Expected.Texels.size(); ++Index)
	{
		for (size_t Channel = 0; Channel < 3; ++Channel)
		{
			const double Value = Expected.Texels[Index][Channel];
			Largest = std::max(Largest, std::abs(Value - Actual.Texels[Index][Channel]) / std::max(Value, 1e-3));
		}
	}
	return Largest;
}

} // namespace

TEST(LocalExposure, FollowsTheFormulas)
{
	FLocal Local;
	Local.Highlight = 0.6f;
	Local.Shadow = 0.7f;
	Local.Detail = 1.3f;
	Local.MiddleGreyBias = 0.5f;
	Local.ExposureScale = 1.5f;
	for (const auto& [Width, Height] : {std::pair(100, 45), {65, 70}, {17, 9}, {1, 1}, {1, 5}, {2, 3}})
	{
		const FImage Image = HalfLit(Width, Height);
		const FImage Expected = FReference(Image, Local).GetResult();
		// Not snapped: float coordinates of the lookups, a few 2^-24 of the size in cells and texels whose logarithms
		// differ by up to 8. Snapped: the depth by 1/512 of 31 steps of 12/31 EV and the plane by 1/512, about 0.5 %.
		EXPECT_LE(LargestRelativeDifference(Expected, Apply(Image, Local, EArithmetic::Exact)), 2e-4)
			<< Width << "x" << Height;
		EXPECT_LE(LargestRelativeDifference(Expected, Apply(Image, Local, EArithmetic::Float32)), 2e-2)
			<< Width << "x" << Height;
	}
}

TEST(LocalExposure, IsOffWhileContrastsAndDetailAreOne)
{
	FFinalPostProcessSettings Settings;
	EXPECT_FALSE(IsLocalExposureEnabled(Settings));
	Settings.LocalExposureHighlightThreshold = 2;
	Settings.LocalExposureMiddleGreyBias = 3;
	EXPECT_FALSE(IsLocalExposureEnabled(Settings));
	for (float FFinalPostProcessSettings::*Setting :
		{static_cast<float FFinalPostProcessSettings::*>(
			 &FFinalPostProcessSettings::LocalExposureHighlightContrastScale),
			static_cast<float FFinalPostProcessSettings::*>(
				&FFinalPostProcessSettings::LocalExposureShadowContrastScale),
			static_cast<float FFinalPostProcessSettings::*>(&FFinalPostProcessSettings::LocalExposureDetailStrength)})
	{
		FFinalPostProcessSettings Changed;
		Changed.*Setting = 0.9f;
		EXPECT_TRUE(IsLocalExposureEnabled(Changed));
	}
}

TEST(LocalExposure, NeutralValuesKeepEveryBit)
{
	const FImage Image = HalfLit(70, 20);
	const FImage Result = Apply(Image, {});
	EXPECT_EQ(0, MaxDifference(Image, Result));
}

TEST(LocalExposure, HighlightsComeNearerToMiddleGrey)
{
	EXPECT_NEAR(Stops(2), ApplyToGrey(Stops(4), Highlights(0.5f)), 1e-4);
	EXPECT_NEAR(Stops(-4), ApplyToGrey(Stops(-4), Highlights(0.5f)), 1e-7);
	EXPECT_NEAR(Stops(0), ApplyToGrey(Stops(4), Highlights(0)), 1e-5);
}

TEST(LocalExposure, ShadowsComeNearerToMiddleGrey)
{
	EXPECT_NEAR(Stops(-2), ApplyToGrey(Stops(-4), Shadows(0.5f)), 1e-5);
	EXPECT_NEAR(Stops(4), ApplyToGrey(Stops(4), Shadows(0.5f)), 1e-4);
}

TEST(LocalExposure, WhatLiesWithinTheThresholdIsLeftAlone)
{
	FLocal Local;
	Local.Highlight = Local.Shadow = 0.5f;
	Local.HighlightThreshold = 1;
	Local.ShadowThreshold = 2;
	EXPECT_NEAR(Stops(1 + 3 * 0.5), ApplyToGrey(Stops(4), Local), 1e-4);
	EXPECT_NEAR(Stops(0.75), ApplyToGrey(Stops(0.75), Local), 1e-5);
	EXPECT_NEAR(Stops(-2 - 2 * 0.5), ApplyToGrey(Stops(-4), Local), 1e-5);
	EXPECT_NEAR(Stops(-1.5), ApplyToGrey(Stops(-1.5), Local), 1e-6);
}

TEST(LocalExposure, ThresholdsCountWhereTheEngineVersionHasThem)
{
	FPassRun Run(FImage(1, 1, {1, 1, 1, 1}), EArithmetic::Float32);
	Run.View.FinalPostProcessSettings.LocalExposureHighlightThreshold = 1;
	Run.View.FinalPostProcessSettings.LocalExposureShadowThreshold = 2;
	for (const Drydock::FEngineProfile& Engine : Drydock::GetEngineProfiles())
	{
		Run.View.EngineProfile = Engine;
		const FLocalExposureParameters Parameters = GetLocalExposureParameters(
			Run.View, FIntPoint(1, 1), GetEyeAdaptationParameters(Run.View, AEM_Histogram, true), false);
		EXPECT_EQ(Engine.bLocalExposureThresholds ? 1.0f : 0.0f, Parameters.HighlightThreshold) << Engine.GetVersion();
		EXPECT_EQ(Engine.bLocalExposureThresholds ? 2.0f : 0.0f, Parameters.ShadowThreshold) << Engine.GetVersion();
	}
	Run.Execute(Run.Input);
}

TEST(LocalExposure, MiddleGreyIsThatOfTheExposedPicture)
{
	FLocal Local = Highlights(0.5f);
	Local.ExposureScale = 4;
	EXPECT_NEAR(Stops(0), ApplyToGrey(Stops(2), Local), 1e-5); // exposed 4 EV above: halved, 2 EV darker
	Local.MiddleGreyBias = 4;
	EXPECT_NEAR(Stops(2), ApplyToGrey(Stops(2), Local), 1e-5);
}

TEST(LocalExposure, DetailOfAFlatAreaIsNone)
{
	FLocal Local;
	Local.Detail = 3;
	EXPECT_NEAR(1, ApplyToGrey(1, Local), 1e-4);
}

TEST(LocalExposure, PreExposureChangesTheUnitsOnly)
{
	FLocal Local = Highlights(0.5f);
	Local.PreExposure = 0.25f;
	EXPECT_NEAR(Stops(2) / 4, ApplyToGrey(Stops(4) / 4, Local), 1e-4);
}

TEST(LocalExposure, BlackStaysBlackAndHazardsStayWhereTheyAre)
{
	FLocal Local;
	Local.Highlight = Local.Shadow = 0;
	Local.Detail = 4;
	EXPECT_EQ(0, ApplyToGrey(0, Local));
	FImage Image = HalfLit(40, 30);
	Image.At(3, 4) = {NaN, 1, 1, 1};
	Image.At(20, 20) = {Infinity, Infinity, Infinity, 1};
	Image.At(30, 1) = {-5, -5, -5, 1};
	const FImage Result = Apply(Image, Local);
	for (size_t Index = 0; Index < Result.Texels.size(); ++Index)
	{
		EXPECT_TRUE(std::isfinite(Result.Texels[Index][1])) << Index; // the setup's clamp makes them finite
	}
	FImage Clean = HalfLit(40, 30);
	EXPECT_NEAR(Apply(Clean, Local).At(0, 29)[1], Result.At(0, 29)[1], 0.05 * Result.At(0, 29)[1]);
}

TEST(LocalExposure, APictureInACornerIsThatPicture)
{
	const FLocal Local = Highlights(0.3f);
	const FImage Image = HalfLit(70, 20);
	const FImage Alone = Apply(Image, Local);
	FPassRun Run(Image, {5, 3, 75, 23}, FIntPoint(96, 40), EArithmetic::Float32, PF_A32B32G32R32F);
	EXPECT_LE(LargestRelativeDifference(Alone, Apply(Run, Local)), 2e-2);
}

TEST(LocalExposure, ComputeAndPixelShaderGiveTheSameBits)
{
	FLocal Local = Shadows(0.4f);
	const FImage Image = HalfLit(65, 33);
	const FImage Pixel = Apply(Image, Local);
	Local.bCompute = true;
	EXPECT_EQ(Pixel.Texels, Apply(Image, Local).Texels);
}

TEST(LocalExposure, TheGridHoldsSumsOfItsCells)
{
	FPassRun Run(Grey(1.0 / 16, 70, 3), EArithmetic::Float32, PF_A32B32G32R32F);
	TRefCountPtr<IPooledRenderTarget> Grid;
	Run.GraphBuilder.QueueTextureExtraction(AddLocalExposure(Run, {}).BilateralGrid, &Grid);
	Run.GraphBuilder.Execute();
	FRHITexture& Texture = *Grid->GetRHI();
	EXPECT_EQ(FIntVector(2, 1, 32), Texture.GetSizeXYZ());
	// log2 -4 lies at 31/3: two thirds at depth 10, one at 11. 64 x 3 and 6 x 3 of 4096 texels.
	EXPECT_NEAR(192.0 / 4096 * 2 / 3, Texture.ReadTexelDouble(0, 0, 0, 10).Y, 1e-6);
	EXPECT_NEAR(-4 * 192.0 / 4096 / 3, Texture.ReadTexelDouble(0, 0, 0, 11).X, 1e-6);
	EXPECT_NEAR(18.0 / 4096 / 3, Texture.ReadTexelDouble(1, 0, 0, 11).Y, 1e-6);
	EXPECT_EQ(0, Texture.ReadTexelDouble(1, 0, 0, 12).Y);
}

TEST(LocalExposure, TheTonemapperExposesColourWithIt)
{
	const auto Tonemap = [](double Luminance, const FLocal* Local)
	{
		FPassRun Run(Grey(Luminance, 3, 2), EArithmetic::Float32, PF_A32B32G32R32F);
		Run.View.FinalPostProcessSettings.VignetteIntensity = 0;
		FLocalExposureTextures Textures;
		FTonemapInputs Inputs;
		Inputs.SceneColor = Run.Input;
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
		Inputs.OutputFormat = PF_A32B32G32R32F;
		if (Local != nullptr)
		{
			Textures = AddLocalExposure(Run, *Local);
			Textures.GiveTo(Inputs);
		}
		return Run.Execute(AddTonemapPass(Run.GraphBuilder, Run.View, Inputs)).At(1, 1)[0];
	};
	const FLocal Local = Highlights(0.5f);
	EXPECT_NEAR(Tonemap(Stops(1), nullptr), Tonemap(Stops(2), &Local), 1e-5);
}

TEST(LocalExposure, AverageLocalExposureIsThatOfTheAverage)
{
	FMeteringRun Run(Grey(0.25), {});
	FLocalExposureParameters Local = GetLocalExposureParameters(Run.Run.View, FIntPoint(1, 1), Run.Parameters, false);
	Local.HighlightContrastScale = 0.5f;
	Local.ShadowContrastScale = 0.5f;
	Local.MiddleGreyExposureCompensation = 0.25f;
	FEyeAdaptationInputs Inputs;
	Inputs.Parameters = Run.Parameters;
	Inputs.LocalExposure = &Local;
	FRHIGPUBufferReadback Readback(TEXT("EyeAdaptation"));
	FRDGBuilder& GraphBuilder = Run.Run.GraphBuilder;
	const FRDGBufferRef Buffer = AddHistogramEyeAdaptationPass(GraphBuilder, Run.Run.View, Inputs,
		AddHistogramPass(GraphBuilder, Run.Run.View, Run.Parameters, Run.Run.Input));
	AddEnqueueCopyPass(GraphBuilder, &Readback, Buffer, Buffer->Desc.GetSize());
	GraphBuilder.Execute();
	// The average is exposed to 2 * 0.18, middle grey is 0.18 * 2 / 4: two stops above, one is taken away.
	EXPECT_NEAR(0.5f, static_cast<const FVector4f*>(Readback.Lock(32))[1].X, 1e-5f);
	Readback.Unlock();
}
