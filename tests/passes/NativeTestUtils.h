// Holds a native kernel against the shader that it stands for: the same stored bits at every lane width and for two
// threads; and draws the pictures to do it with.
#pragma once

#include "PassTestUtils.h"

#include "Exposure/PostProcessLocalExposure.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <random>

namespace PassTest
{

inline bool IsSame(double A, double B)
{
	return (std::isnan(A) && std::isnan(B)) || std::memcmp(&A, &B, sizeof(A)) == 0;
}

/** The first texel that differs in a bit; NaN equals NaN. */
inline std::string Compare(const FImage& Expected, const FImage& Actual)
{
	for (int Y = 0; Y < Expected.Height; ++Y)
	{
		for (int X = 0; X < Expected.Width; ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				const double A = Expected.At(X, Y)[size_t(Channel)];
				const double B = Actual.At(X, Y)[size_t(Channel)];
				if (!IsSame(A, B))
				{
					char Text[160];
					std::snprintf(Text, sizeof(Text), "(%d, %d) channel %d of %dx%d: shader %a, native %a", X, Y,
						Channel, Expected.Width, Expected.Height, A, B);
					return Text;
				}
			}
		}
	}
	return {};
}

/** By the shader and, at every lane width, by the native kernel. */
inline void ExpectSameBits(const std::function<FImage()>& Run, const std::string& What)
{
	FImage Expected;
	{
		const FScopedConsoleVariable Switch(TEXT("r.Drydock.NativeKernels"), 0);
		Expected = Run();
	}
	for (const int Lanes : {0, 8, 4})
	{
		const FScopedConsoleVariable Threads(TEXT("r.Drydock.Threads"), Lanes == 4 ? 1.0f : 2.0f);
		const FScopedConsoleVariable Width(TEXT("r.Drydock.LaneWidth"), static_cast<float>(Lanes));
		EXPECT_EQ("", Compare(Expected, Run())) << What << ", " << Lanes << " lanes";
	}
}

/** Values of all kinds and both signs; bHazards: one in sixteen is NaN, infinite, -0, a denormal or very large. */
inline FImage Draw(std::mt19937& Random, int Width, int Height, bool bHazards)
{
	const double Hazards[] = {NaN, Infinity, -Infinity, -0.0, 0.0, 65504, -65504, 1e-40, 6e-8, 3e38, -3e38};
	std::uniform_real_distribution<double> Value(-1.0, 4.0);
	std::uniform_int_distribution<size_t> Kind(0, 16 * std::size(Hazards) - 1);
	return FImage::Make(Width, Height,
		[&](int, int)
		{
			FTexel Texel;
			for (double& Channel : Texel)
			{
				const size_t Hazard = Kind(Random);
				Channel = bHazards && Hazard < std::size(Hazards) ? Hazards[Hazard] : Value(Random);
			}
			return Texel;
		});
}

/** A picture that fills a texture or lies somewhere in one. */
struct FPlace
{
	FImage Image;
	FRect Rect;
	FIntPoint Extent;
	EPixelFormat Format;
};

inline FPlace DrawPlace(std::mt19937& Random)
{
	const auto Pick = [&Random](int Low, int High)
	{
		return std::uniform_int_distribution<int>(Low, High)(Random);
	};
	// One in three is wider than a tile.
	const int Width = Pick(0, 2) == 0 ? Pick(257, 600) : Pick(1, 90);
	const int Height = Pick(1, 60);
	const FIntPoint Min = Pick(0, 1) == 0 ? FIntPoint(0, 0) : FIntPoint(Pick(0, 40), Pick(0, 40));
	const int Padding = Pick(0, 2) == 0 ? Pick(1, 40) : 0;
	const EPixelFormat Formats[] = {
		PF_A32B32G32R32F, PF_FloatRGBA, PF_FloatR11G11B10, PF_B8G8R8A8, PF_R16F, PF_G16R16, PF_R32_FLOAT};
	FPlace Place;
	Place.Image = Draw(Random, Width, Height, Pick(0, 2) == 0);
	Place.Rect = {Min.X, Min.Y, Min.X + Width, Min.Y + Height};
	Place.Extent = FIntPoint(Place.Rect.MaxX + Padding, Place.Rect.MaxY + Padding);
	Place.Format = Formats[Pick(0, static_cast<int>(std::size(Formats)) - 1)];
	return Place;
}

inline std::string Describe(const FPlace& Place)
{
	char Text[160];
	std::snprintf(Text, sizeof(Text), "%dx%d at (%d, %d) of %dx%d, format %d", Place.Rect.Width(), Place.Rect.Height(),
		Place.Rect.MinX, Place.Rect.MinY, Place.Extent.X, Place.Extent.Y, static_cast<int>(Place.Format));
	return Text;
}

/** A texture of three dimensions with values of its own. */
inline FRDGTextureRef AddVolume(FRDGBuilder& GraphBuilder, FIntVector Size, EPixelFormat Format, const TCHAR* Name,
	const std::function<FTexel(int, int, int)>& Texel)
{
	const FTextureRHIRef Texture = new FRHITexture(
		FRDGTextureDesc::Create3D(Size, Format, FClearValueBinding::None, TexCreate_ShaderResource), Name);
	for (int Z = 0; Z < Size.Z; ++Z)
	{
		for (int Y = 0; Y < Size.Y; ++Y)
		{
			for (int X = 0; X < Size.X; ++X)
			{
				const FTexel Value = Texel(X, Y, Z);
				Texture->WriteTexelDouble(X, Y, FVector4(Value[0], Value[1], Value[2], Value[3]), 0, Z);
			}
		}
	}
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Name));
}

/** Local exposure with drawn textures and parameters; some cells hold nothing. */
inline Drydock::FLocalExposureTextures DrawLocalExposure(FPassRun& Run, std::mt19937& Random)
{
	const auto Draw = [&Random](double Low, double High)
	{
		return std::uniform_real_distribution<double>(Low, High)(Random);
	};
	const FIntPoint Size = Run.Input.ViewRect.Size();
	const FIntPoint Cells = FIntPoint::DivideAndRoundUp(Size, Drydock::GBilateralGridCellSize);
	Drydock::FLocalExposureTextures Textures;
	FLocalExposureParameters& Parameters = Textures.Parameters;
	Parameters.HighlightContrastScale = static_cast<float>(Draw(0.3, 1.2));
	Parameters.ShadowContrastScale = static_cast<float>(Draw(0.3, 1.2));
	Parameters.HighlightThreshold = static_cast<float>(Draw(0.0, 2.0));
	Parameters.ShadowThreshold = static_cast<float>(Draw(0.0, 2.0));
	Parameters.DetailStrength = static_cast<float>(Draw(0.5, 1.5));
	Parameters.BlurredLuminanceBlend = static_cast<float>(Draw(0.0, 1.0));
	Parameters.MiddleGreyExposureCompensation = 1.5f;
	Parameters.BilateralGridUVScale = FVector2f(Size) / FVector2f(Cells * Drydock::GBilateralGridCellSize);
	Textures.EyeAdaptation.HistogramScale = 0.06f;
	Textures.EyeAdaptation.HistogramBias = 0.5f;
	Textures.EyeAdaptation.LuminanceMin = 0.001f;
	Textures.BilateralGrid = AddVolume(Run.GraphBuilder, FIntVector(Cells.X, Cells.Y, Drydock::GBilateralGridDepth),
		PF_G32R32F, TEXT("Grid"),
		[&](int, int, int)
		{
			const double Weight = Draw(-0.2, 1.0);
			return Weight > 0.0 ? FTexel{Weight * Draw(-4.0, 4.0), Weight, 0, 1} : FTexel{0, 0, 0, 1};
		});
	const FIntPoint Small = FIntPoint::DivideAndRoundUp(Size, 4);
	const FImage Blurred = FImage::Make(Small.X, Small.Y, [&](int, int) { return FTexel{Draw(-4.0, 4.0), 0, 0, 1}; });
	Textures.BlurredLogLuminance =
		Run.AddInput(Blurred, {0, 0, Small.X, Small.Y}, Small, PF_R16F, TEXT("Blurred")).Texture;
	return Textures;
}

} // namespace PassTest
