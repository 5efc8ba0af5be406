// Halves an image, and makes the chain of halved images that blurs, exposure and bloom share. Source: engine file
// PostProcessDownsample.h.
//
// Contract. Output extent and rect are ceil-divided by two, never below 1x1. Every tap is clamped to the input's
// bilinear rect, so nothing outside the rect is read and a constant stays constant to the edge.
//   Low:  one bilinear tap. NaN, infinities and negatives pass on to the pixels whose 2x2 footprint holds them.
//   High: four taps at one texel; colour below 0 and NaN become 0, alpha passes on; +Inf stays +Inf.
//   The store then applies the rules of the target's format (R11G11B10: negatives to 0, overflow to the largest).
#pragma once

#include "CoreMinimal.h"
#include "PixelFormat.h"
#include "ScreenPass.h"

#include <optional>

class FRDGBuilder;
class FViewInfo;

enum class EDownsampleFlags : uint8
{
	None = 0,
	/** A pixel shader even where the view prefers compute. */
	ForceRaster = 1,
};
ENUM_CLASS_FLAGS(EDownsampleFlags);

enum class EDownsampleQuality : uint8
{
	/** One bilinear tap: a 2x2 box where sizes are even. */
	Low,
	/** Four bilinear taps: a 4x4 box where sizes are even. */
	High,
	MAX
};

/** r.PostProcessing.DownsampleQuality: the half-resolution scene colour. */
DRYDOCK_API EDownsampleQuality GetDownsampleQuality();
/** r.PostProcessing.DownsampleChainQuality: the levels below it. */
DRYDOCK_API EDownsampleQuality GetDownsampleChainQuality();

struct FDownsamplePassInputs
{
	/** Name of the pass's output; kept as a pointer. */
	const TCHAR* Name = nullptr;
	FScreenPassTexture SceneColor;
	EDownsampleQuality Quality = EDownsampleQuality::Low;
	EDownsampleFlags Flags = EDownsampleFlags::None;
	/** PF_Unknown keeps the input's format. */
	EPixelFormat FormatOverride = PF_Unknown;
	/** Written in place of a new texture where valid; its rect is the output rect. */
	FScreenPassRenderTarget UserSuppliedOutput;
	/** Drawn by a pixel shader, in the output's texels; the rest of the output stays. Not set: its whole rect. */
	std::optional<FIntRect> DrawRect;
};

DRYDOCK_API FScreenPassTexture AddDownsamplePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FDownsamplePassInputs& Inputs);

/** Successive halvings of one image. Level 0 is the image itself. */
class FTextureDownsampleChain
{
public:
	/** Six levels: one to each stage of the bloom. */
	static constexpr uint32 StageCount = 6;

	/** Adds Levels - 1 passes; every level keeps the format of level 0. Name: of the event scope and of each texture.
	 */
	DRYDOCK_API void Init(FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture HalfResolution,
		EDownsampleQuality Quality, const TCHAR* Name = TEXT("SceneDownsample"), uint32 Levels = StageCount);

	bool IsInitialized() const { return Textures.Num() > 0; }
	uint32 GetLevelCount() const { return static_cast<uint32>(Textures.Num()); }
	FScreenPassTexture GetTexture(uint32 StageIndex) const { return Textures[static_cast<int32>(StageIndex)]; }
	FScreenPassTexture GetFirstTexture() const { return Textures[0]; }
	FScreenPassTexture GetLastTexture() const { return Textures.Last(); }

private:
	TArray<FScreenPassTexture> Textures;
};

using FSceneDownsampleChain = FTextureDownsampleChain;
