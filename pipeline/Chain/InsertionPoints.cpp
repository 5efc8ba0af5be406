// Calls view extensions at their points of the chain and records what they did. Source: engine
// PostProcess/PostProcessing.cpp.
#include "Chain/InsertionPoints.h"

#include "Chain/PassCallbacks.h"
#include "ExtensionFactory.h"
#include "Extensions/ExtensionErrors.h"
#include "PixelFormat.h"
#include "SystemTextures.h"
#include "Tonemap/TonemapOutputDevice.h"

namespace Drydock
{

namespace
{

using EPoint = FInsertionPoints::EPoint;

/** The pass that a point comes after; none where the point comes before all that may be the last. */
std::optional<EFramePass> FindPass(EPoint Point)
{
	switch (Point)
	{
	case EPoint::MotionBlur:
		return EFramePass::MotionBlur;
	case EPoint::Tonemap:
		return EFramePass::Tonemap;
	case EPoint::FXAA:
		return EFramePass::FXAA;
	case EPoint::SMAA:
		return EFramePass::SMAA;
	case EPoint::VisualizeDepthOfField:
		return EFramePass::VisualizeDepthOfField;
	default:
		return {};
	}
}

std::string GetDroppedReason(EPoint Point)
{
	return std::string("the pass ") + GetPassName(Point) +
		   " is disabled and comes after the last enabled one, which has written the output: a texture returned "
		   "here is not seen; subscribe to Tonemap, or where bIsPassEnabled is true";
}

} // namespace

FInsertionPoints::FInsertionPoints(FRDGBuilder& InGraphBuilder, const FNamedView& InView,
	TRDGUniformBufferRef<FSceneTextureUniformParameters> InSceneTextures, FSequence& InSequence,
	FViewExtensionFrame& InExtensions)
	: GraphBuilder(InGraphBuilder)
	, View(InView)
	, SceneTextures(InSceneTextures)
	, Sequence(InSequence)
	, Extensions(InExtensions)
{
}

void FInsertionPoints::Subscribe()
{
	for (const FInsertionPoint& Point : GetInsertionPoints())
	{
		if (!HasInsertionPoint(Point.Pass, Extensions.GetEngine().Minor))
		{
			continue;
		}
		const std::optional<EFramePass> Pass = FindPass(Point.Pass);
		At(Point.Pass) = Extensions.Subscribe(Point.Pass, View, !Pass || Sequence.IsEnabled(*Pass));
		if (Pass)
		{
			Sequence.SetNumCallbacks(*Pass, static_cast<int32>(At(Point.Pass).size()));
		}
	}
}

void FInsertionPoints::SetSlot(EPostProcessMaterialInput Slot, const FScreenPassTexture& Texture)
{
	Slots[static_cast<size_t>(Slot)] = Texture;
}

FScreenPassTexture FInsertionPoints::Run(EPoint Point, FScreenPassTexture SceneColor, const std::string& Note)
{
	if (!IsThere(Point))
	{
		return SceneColor;
	}
	const std::optional<EFramePass> Pass = FindPass(Point);
	const bool bDropped = Pass && Sequence.IsAfterLastPass(*Pass);
	Record(Point, SceneColor, true, bDropped ? GetDroppedReason(Point) : Note);
	const std::vector<FPassCallback>& PointCallbacks = At(Point);
	for (size_t Index = 0; Index < PointCallbacks.size(); ++Index)
	{
		FPostProcessMaterialInputs CallbackInputs = MakeInputs(SceneColor);
		if (Pass)
		{
			Sequence.AcceptOverrideIfLastPass(*Pass, CallbackInputs.OverrideOutput, static_cast<int32>(Index));
		}
		SceneColor = RunPassCallback(GraphBuilder, View, GetPassName(Point), PointCallbacks[Index], CallbackInputs,
			GetInsertionPoint(Point).Space == EColorSpace::LinearHDR, Extensions.GetLog());
		if (bDropped && SceneColor.Texture != CallbackInputs.Textures[0].Texture)
		{
			Extensions.GetLog().Diagnostics.push_back(MakeExtensionDiagnostic(
				ESeverity::Warning, WarnCallbackDropped, PointCallbacks[Index].Extension, GetDroppedReason(Point)));
		}
	}
	return SceneColor;
}

FScreenPassTexture FInsertionPoints::RunReplacingTonemapper(
	const FScreenPassTexture& SceneColor, const FScreenPassTexture& Bloom)
{
	Record(EPoint::ReplacingTonemapper, SceneColor, true,
		At(EPoint::ReplacingTonemapper).size() > 1 ? "only the first runs" : "");
	FPostProcessMaterialInputs CallbackInputs = MakeInputs(SceneColor);
	CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::CombinedBloom,
		Bloom.IsValid() ? Bloom : FScreenPassTexture(FRDGSystemTextures::Get(GraphBuilder).Black));
	if (!Sequence.AcceptOverrideIfLastPass(EFramePass::Tonemap, CallbackInputs.OverrideOutput))
	{
		CallbackInputs.OutputFormat = GetDisplayFormat(GetTonemapperOutputDeviceParameters().OutputDevice);
	}
	return RunPassCallback(GraphBuilder, View, GetPassName(EPoint::ReplacingTonemapper),
		At(EPoint::ReplacingTonemapper)[0], CallbackInputs, false, Extensions.GetLog());
}

void FInsertionPoints::Skip(EPoint Point, const std::string& Reason)
{
	if (!IsThere(Point))
	{
		return;
	}
	Record(Point, FScreenPassTexture(), false, Reason);
	for (const FPassCallback& Callback : At(Point))
	{
		Extensions.GetLog().Diagnostics.push_back(MakeExtensionDiagnostic(ESeverity::Warning, WarnPointNotReached,
			Callback.Extension, std::string("its callback at ") + GetPassName(Point) + " is not called: " + Reason));
	}
}

FPostProcessMaterialInputs FInsertionPoints::MakeInputs(const FScreenPassTexture& SceneColor) const
{
	FPostProcessMaterialInputs CallbackInputs;
	CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::SceneColor, SceneColor);
	const FRDGSystemTextures& SystemTextures = FRDGSystemTextures::Get(GraphBuilder);
	const FRDGTextureRef Translucency =
		View.View->SceneTextures ? View.View->SceneTextures->SeparateTranslucency : nullptr;
	CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::SeparateTranslucency,
		Translucency ? FScreenPassTexture(Translucency, View.View->ViewRect)
					 : FScreenPassTexture(SystemTextures.Black));
	const FRDGTextureRef Velocity =
		SceneTextures ? SceneTextures->GetContents()->GBufferVelocityTexture : SystemTextures.Black;
	CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::Velocity,
		Velocity == SystemTextures.Black ? FScreenPassTexture(Velocity)
										 : FScreenPassTexture(Velocity, View.View->ViewRect));
	for (size_t Slot = 0; Slot < Slots.size(); ++Slot)
	{
		if (Slots[Slot].IsValid())
		{
			CallbackInputs.SetInput(GraphBuilder, static_cast<EPostProcessMaterialInput>(Slot), Slots[Slot]);
		}
	}
	CallbackInputs.SceneTextures = GetSceneTextureShaderParameters(SceneTextures);
	CallbackInputs.CustomDepthTexture = SceneTextures ? SceneTextures->GetContents()->CustomDepthTexture : nullptr;
	return CallbackInputs;
}

void FInsertionPoints::Record(
	EPoint Point, const FScreenPassTexture& SceneColor, bool bReached, const std::string& Reason)
{
	FHookPoint Entry;
	Entry.Point = GetPassName(Point);
	Entry.View = View.Name;
	Entry.Space = ToString(GetInsertionPoint(Point).Space);
	if (SceneColor.IsValid())
	{
		Entry.Resource = SceneColor.Texture->Name;
		Entry.Format = GetPixelFormatString(SceneColor.Texture->Desc.Format);
		Entry.Width = SceneColor.ViewRect.Width();
		Entry.Height = SceneColor.ViewRect.Height();
	}
	for (const FPassCallback& Callback : At(Point))
	{
		Entry.Subscribers.push_back(Callback.Extension);
	}
	Entry.bCalled = bReached && !Entry.Subscribers.empty();
	Entry.Reason = !Reason.empty() ? Reason : Entry.Subscribers.empty() ? "nobody subscribed" : "";
	Extensions.GetLog().Points.push_back(Entry);
}

} // namespace Drydock
