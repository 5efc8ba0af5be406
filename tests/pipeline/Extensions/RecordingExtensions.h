// Extensions of tests that write down, or count, which of their hooks were called.
#pragma once

#include <gtest/gtest.h>

#include "ExtensionFactory.h"
#include "ExtensionTestUtils.h"
#include "Extensions/EngineHooks.h"
#include "Extensions/ExtensionErrors.h"
#include "Frame/DrydockFrame.h"

namespace ExtensionTest
{

/** Overrides every hook of 5.4 and writes down each call. */
class FEverything : public FSceneViewExtensionBase
{
public:
	FEverything(const FAutoRegister& AutoRegister, std::string& InCalls, std::string InName, int32 InPriority = 0)
		: FSceneViewExtensionBase(AutoRegister)
		, Calls(InCalls)
		, Name(std::move(InName))
		, Priority(InPriority)
	{
	}

	int32 GetPriority() const override { return Priority; }
	void SetupViewFamily(FSceneViewFamily&) override { Note("SetupViewFamily"); }
	void SetupViewPoint(APlayerController*, FMinimalViewInfo&) override { Note("SetupViewPoint"); }
	void SetupViewProjectionMatrix(FSceneViewProjectionData&) override { Note("SetupViewProjectionMatrix"); }
	void SetupView(FSceneViewFamily&, FSceneView&) override { Note("SetupView"); }
	void BeginRenderViewFamily(FSceneViewFamily&) override { Note("BeginRenderViewFamily"); }
	void PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { Note("PreRenderViewFamily"); }
	void PreRenderView_RenderThread(FRDGBuilder&, FSceneView&) override { Note("PreRenderView"); }
	void PreInitViews_RenderThread(FRDGBuilder&) override { Note("PreInitViews"); }
	void PreRenderBasePass_RenderThread(FRDGBuilder&, bool) override { Note("PreRenderBasePass"); }
	void PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&,
		TRDGUniformBufferRef<FSceneTextureUniformParameters>) override
	{
		Note("PostRenderBasePassDeferred");
	}
	void PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs& Inputs) override
	{
		Inputs.Validate();
		Note("PrePostProcessPass");
	}
	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Note("Subscribe");
			Callbacks.Add(FAfterPassCallbackDelegate::CreateSP(this, &FEverything::Callback, 3));
		}
	}
	void PostRenderView_RenderThread(FRDGBuilder&, FSceneView&) override { Note("PostRenderView"); }
	void PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { Note("PostRenderViewFamily"); }

	FScreenPassTexture Callback(
		FRDGBuilder&, const FSceneView&, const FPostProcessMaterialInputs& Inputs, int32 Payload)
	{
		Note("Callback" + std::to_string(Payload));
		return Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	}

private:
	void Note(const std::string& Hook) { Calls += Name + "." + Hook + "\n"; }

	std::string& Calls;
	std::string Name;
	int32 Priority;
};

/** Old and new form of everything that changed between versions. */
class FBothForms : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	void SubscribeToPostProcessingPass(EPostProcessingPass, FAfterPassCallbackDelegateArray&, bool) override
	{
		++NumOld;
	}
	void SubscribeToPostProcessingPass(
		EPostProcessingPass, const FSceneView&, FPostProcessingPassDelegateArray&, bool) override
	{
		++NumNew;
	}
	void PreRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&) override { ++NumCommandList; }

	int NumOld = 0;
	int NumNew = 0;
	int NumCommandList = 0;
};

inline void SetEngine(const ISceneViewExtension& Extension, int32 EngineMinor)
{
	FExtensionInfo Info = *GEngine->ViewExtensions->FindInfo(Extension);
	Info.EngineMinor = EngineMinor;
	GEngine->ViewExtensions->SetInfo(Extension, Info);
}

} // namespace ExtensionTest
