// Holds the insertion points of one view's chain: the subscribers of each, and the calls of view extensions in order.
// Source: engine PostProcess/PostProcessing.cpp; the record of it is drydock's.
#pragma once

#include "Chain/OverridePassSequence.h"
#include "Extensions/ViewExtensions.h"
#include "PostProcess/PostProcessMaterialInputs.h"

#include <array>
#include <string>
#include <vector>

namespace Drydock
{

/** The passes that can be the last of a frame, in order. */
enum class EFramePass : uint32
{
	MotionBlur,
	Tonemap,
	AfterTonemap, // effects that stand there
	FXAA,
	SMAA,
	VisualizeDepthOfField,
	PrimaryUpscale,
	MAX
};

/** Calls go in the order of the chain; each gives the picture as it is from then on. */
class FInsertionPoints
{
public:
	using EPoint = ISceneViewExtension::EPostProcessingPass;
	using FSequence = TOverridePassSequence<EFramePass>;

	/** SceneTextures: null if they are not read. All outlive this. */
	FInsertionPoints(FRDGBuilder& InGraphBuilder, const FNamedView& InView,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> InSceneTextures, FSequence& InSequence,
		FViewExtensionFrame& InExtensions);

	/** Asks the extensions for their callbacks at every point there is in this version. */
	void Subscribe();

	bool HasCallbacks(EPoint Point) const { return !Callbacks[static_cast<size_t>(Point)].empty(); }

	/** Slots that callbacks find beside the picture. */
	void SetSlot(EPostProcessMaterialInput Slot, const FScreenPassTexture& Texture);

	/** The picture after all callbacks of a point. Note: what else is to be known of it. */
	FScreenPassTexture Run(EPoint Point, FScreenPassTexture SceneColor, const std::string& Note = "");

	/** The one callback that stands in for the tonemapper. The first subscribed wins. */
	FScreenPassTexture RunReplacingTonemapper(const FScreenPassTexture& SceneColor, const FScreenPassTexture& Bloom);

	/** Records a point that this frame does not reach. */
	void Skip(EPoint Point, const std::string& Reason);

private:
	std::vector<FPassCallback>& At(EPoint Point) { return Callbacks[static_cast<size_t>(Point)]; }
	bool IsThere(EPoint Point) const { return HasInsertionPoint(Point, Extensions.GetEngine().Minor); }
	FPostProcessMaterialInputs MakeInputs(const FScreenPassTexture& SceneColor) const;
	void Record(EPoint Point, const FScreenPassTexture& SceneColor, bool bReached, const std::string& Reason);

	FRDGBuilder& GraphBuilder;
	const FNamedView& View;
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures;
	FSequence& Sequence;
	FViewExtensionFrame& Extensions;
	std::array<std::vector<FPassCallback>, static_cast<size_t>(EPoint::MAX)> Callbacks;
	std::array<FScreenPassTexture, kPostProcessMaterialInputCountMax> Slots;
};

} // namespace Drydock
