// A frame around the bloom setup with toon bloom, for tests: a full-resolution picture, shading model ids, and the
// half-resolution copy.
#pragma once

#include "NativeTestUtils.h"
#include "PassTestUtils.h"

#include "Bloom/ToonBloomSetup.h"

#include <functional>
#include <optional>

namespace PassTest
{

using namespace Drydock;

/** The shading model id that marks toon. */
constexpr double Cloth = 8;

/** A toon bloom setup: settings, and how it is computed. */
struct FToon
{
	std::optional<float> Factor = 1.0f; // empty: the setup without the patch
	float Threshold = -1.0f;
	bool bCompute = false;
	bool bAsPrinted = false;
	EPixelFormat Format = PF_A32B32G32R32F;
	EDownsampleQuality Quality = EDownsampleQuality::Low;
	float PreExposure = 1.0f;
	bool bLocalExposure = false;
};

/** Alpha as G-buffer B holds it. */
inline FImage PackIds(const FImage& Ids)
{
	return FImage::Make(Ids.Width, Ids.Height, [&](int X, int Y) { return FTexel{0, 0, 0, Ids.At(X, Y)[0] / 255}; });
}

/** Red: the shading model id of a pixel. */
inline FImage MakeIds(int Width, int Height, const std::function<bool(int, int)>& IsToon)
{
	return FImage::Make(Width, Height, [&](int X, int Y) { return FTexel{IsToon(X, Y) ? Cloth : 1, 0, 0, 0}; });
}

/** A full-resolution picture in a rect, its ids, its half-resolution copy and the setup over that. */
class FToonRun
{
public:
	FToonRun(const FImage& Color, const FImage& Ids, const FRect& Rect, FIntPoint Extent, const FToon& InToon,
		EArithmetic Arithmetic)
		: AsPrinted(TEXT("r.ToonBloom.AsPrinted"), InToon.bAsPrinted ? 1.0f : 0.0f)
		, Toon(InToon)
		, Run(Color, Rect, Extent, Arithmetic, Toon.Format)
	{
		Run.View.PreExposure = Toon.PreExposure;
		Run.View.bUseComputePasses = Toon.bCompute;
		Run.View.InitViewUniformBuffer(Extent);
		SceneTextures.Color = Run.Input.Texture;
		SceneTextures.GBufferB = Run.AddInput(Place(PackIds(Ids), Rect, Extent), PF_B8G8R8A8, TEXT("GBufferB")).Texture;
		Run.View.SceneTextures = &SceneTextures;
		FDownsamplePassInputs HalfInputs;
		HalfInputs.Name = TEXT("Half");
		HalfInputs.SceneColor = Run.Input;
		HalfInputs.Quality = Toon.Quality;
		Half = AddDownsamplePass(Run.GraphBuilder, Run.View, HalfInputs);
	}

	FBloomSetupInputs MakeInputs()
	{
		FBloomSetupInputs Inputs;
		Inputs.SceneColor = Half;
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
		Inputs.Threshold = Toon.Threshold;
		if (Toon.bLocalExposure)
		{
			std::mt19937 Random(7);
			LocalExposure = DrawLocalExposure(Run, Random);
			LocalExposure.GiveTo(Inputs);
		}
		return Inputs;
	}

	/** SceneColor: the full resolution's. */
	FScreenPassTexture AddSetup(const FScreenPassTexture& SceneColor)
	{
		return Toon.Factor
				   ? AddToonBloomSetupPass(Run.GraphBuilder, Run.View, MakeInputs(),
						 {SceneColor, CreateSceneTextureUniformBuffer(Run.GraphBuilder, Run.View), *Toon.Factor},
						 Toon.Quality)
				   : AddBloomSetupPass(Run.GraphBuilder, Run.View, MakeInputs());
	}

	FScreenPassTexture AddSetup() { return AddSetup(Run.Input); }

private:
	/** Outside the rect everything claims to be toon. */
	static FImage Place(const FImage& Image, const FRect& Rect, FIntPoint Extent)
	{
		FImage Placed(Extent.X, Extent.Y, {1, 1, 1, Cloth / 255});
		for (int Y = 0; Y < Rect.Height(); ++Y)
		{
			for (int X = 0; X < Rect.Width(); ++X)
			{
				Placed.At(Rect.MinX + X, Rect.MinY + Y) = Image.At(X, Y);
			}
		}
		return Placed;
	}

	FScopedConsoleVariable AsPrinted;
	FToon Toon;
	FSceneTextures SceneTextures;
	FLocalExposureTextures LocalExposure;

public:
	FPassRun Run;
	FScreenPassTexture Half;
};

/** 4x4 in four quads: two toon pixels of four, all, none, and only the lower right one. */
inline FImage QuadIds()
{
	return MakeIds(4, 4, [](int X, int Y) { return Y < 2 ? (X < 2 ? X == Y : true) : X == 3 && Y == 3; });
}

inline FImage Grey(int Width, int Height, double Value)
{
	return FImage(Width, Height, {Value, Value, Value, 1});
}

} // namespace PassTest
