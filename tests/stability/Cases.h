// What a pass is run with, and the frame around it.
#pragma once

#include "passes/PassTestUtils.h"

#include "Hazards.h"

#include "SceneTextureParameters.h"

#include <optional>
#include <vector>

namespace Stability
{

using PassReference::FImage;
using PassReference::FTexel;
using PassReference::operator*;
using PassTest::EArithmetic;

struct FCase
{
	FImage Image;
	FIntPoint Offset = FIntPoint(0, 0);  // of the picture in its texture
	FIntPoint Padding = FIntPoint(0, 0); // of the texture beyond the picture
	EArithmetic Arithmetic = EArithmetic::Native;
	EPixelFormat Format = PF_FloatRGBA;
	int Variant = 0;
	// Where they are not set, the runner takes a value of its own.
	std::optional<double> Sigma; // pixels
	std::optional<double> Threshold;
	std::optional<double> Intensity;
	std::optional<double> Power;
	std::optional<int> Levels;
	int Frames = 1;
};

/** One run that a hazard asks for. */
struct FTrial
{
	FCase Case;
	FCase Clean;                     // the same without the hazard
	FIntPoint Bad = FIntPoint(0, 0); // the pixel that is not as the others
};

/** A hazard's runs on one form of a pass. */
std::vector<FTrial> MakeTrials(EHazard Hazard, int Variant);

/** Where the bad pixel and the hot one lie. */
inline const FIntPoint BadPixel(13, 9);

/** A pass run whose view has a frame's other textures: left of column 44 all lies far behind the focus and moves by
 *  3.7 pixels along x, right of it nothing; cloth up to column 31; a character in columns 20..27, rows 16..27. */
class FFrameRun : public PassTest::FPassRun
{
public:
	explicit FFrameRun(const FCase& Case);

	/** Depth, velocity and G-buffer, made when first asked for. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> GetSceneTextures();

	/** What they hold. */
	static bool IsCloth(int X) { return X < 32; }
	static double GetMask(int X, int Y) { return X >= 20 && X < 28 && Y >= 16 && Y < 28 ? 1.0 : 0.0; }

private:
	FRDGTextureRef Add(const std::function<FTexel(int, int)>& Texel, EPixelFormat Format, const TCHAR* Name);

	const FCase& Case;
	FSceneTextures SceneTextures;
	TRDGUniformBufferRef<FSceneTextureUniformParameters> Buffer = nullptr;
};

} // namespace Stability
