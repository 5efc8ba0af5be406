// Frames of a few pixels with extensions whose hooks are given as lambdas:
//
//     const auto Extension = MakeExtension(EPoint::Tonemap, [](FCall Call) { return Call.Untouched(); });
//     const FFrameResult Frame = Render(MakeFrame());
#pragma once

#include "ExtensionFactory.h"
#include "Frame/Frame.h"
#include "PostProcess/PostProcessing.h"
#include "RenderTargetPool.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ExtensionTest
{

using namespace Drydock;
using EPoint = ISceneViewExtension::EPostProcessingPass;

constexpr int32 Width = 24;
constexpr int32 Height = 12;

/** What a callback is called with. */
struct FCall
{
	FRDGBuilder& GraphBuilder;
	const FSceneView& View;
	const FPostProcessMaterialInputs& Inputs;

	FScreenPassTexture GetPicture() const { return Inputs.GetInput(EPostProcessMaterialInput::SceneColor); }
	FScreenPassTexture Untouched() const { return Inputs.ReturnUntouchedSceneColorForPostProcessing(GraphBuilder); }

	/** OverrideOutput where there is one, else a new texture like the picture; all of it Color. */
	FScreenPassTexture Fill(const FLinearColor& Color) const
	{
		FScreenPassRenderTarget Output = Inputs.OverrideOutput;
		if (!Output.IsValid())
		{
			Output = FScreenPassRenderTarget::CreateFromInput(
				GraphBuilder, GetPicture(), ERenderTargetLoadAction::ENoAction, TEXT("Filled"));
		}
		if (Output.LoadAction == ERenderTargetLoadAction::EClear)
		{
			AddClearRenderTargetPass(GraphBuilder, Output.Texture);
		}
		AddClearRenderTargetPass(GraphBuilder, Output.Texture, Color, Output.ViewRect);
		return FScreenPassTexture(Output);
	}

	FScreenPassTexture MakeTexture(FIntPoint Extent, EPixelFormat Format, const FLinearColor& Color) const
	{
		const FRDGTextureRef Texture =
			GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Extent, Format, FClearValueBinding::Black,
										   TexCreate_ShaderResource | TexCreate_RenderTargetable),
				TEXT("Made"));
		AddClearRenderTargetPass(GraphBuilder, Texture, Color);
		return FScreenPassTexture(Texture);
	}
};

using FCallback = std::function<FScreenPassTexture(const FCall&)>;

/** Subscribes one callback to one point. */
class FAtPoint : public FSceneViewExtensionBase
{
public:
	FAtPoint(const FAutoRegister& AutoRegister, EPoint InPoint, FCallback InCallback)
		: FSceneViewExtensionBase(AutoRegister)
		, Point(InPoint)
		, Callback(std::move(InCallback))
	{
	}

	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == Point)
		{
			bWasEnabled = bIsPassEnabled;
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FAtPoint::Call));
		}
	}

	FScreenPassTexture Call(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		++NumCalls;
		return Callback({GraphBuilder, View, Inputs});
	}

	EPoint Point;
	FCallback Callback;
	bool bWasEnabled = false;
	int NumCalls = 0;
};

inline TSharedRef<FAtPoint, ESPMode::ThreadSafe> MakeExtension(EPoint Point, FCallback Callback)
{
	return FSceneViewExtensions::NewExtension<FAtPoint>(Point, std::move(Callback));
}

/** Scene colour: red grows to the right, green downwards. No bloom, no vignette, so that a pixel is its own. */
inline FFrameInputs MakeFrame(FIntRect ViewRect = FIntRect(0, 0, Width, Height))
{
	FFrameInputs Inputs;
	Inputs.Engine = *FindEngineProfile(4);
	Inputs.Plugins = std::vector<std::string>(); // other tests load some
	Inputs.Extent = FIntPoint(Width, Height);
	FFrameView View;
	View.Rect = ViewRect;
	View.Settings.Settings = StartFinalPostProcessSettings();
	View.Settings.Settings.BloomIntensity = 0.0f;
	View.Settings.Settings.VignetteIntensity = 0.0f;
	Inputs.Views.push_back(View);
	Inputs.RegisterSceneTextures = [](FRDGBuilder& GraphBuilder)
	{
		const TRefCountPtr<FRHITexture> Texture = new FRHITexture(
			FRHITextureDesc::Create2D(FIntPoint(Width, Height), PF_FloatRGBA, FClearValueBinding::Black,
				ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable | ETextureCreateFlags::UAV),
			TEXT("SceneColor"));
		for (int32 Y = 0; Y < Height; ++Y)
		{
			for (int32 X = 0; X < Width; ++X)
			{
				Texture->WriteTexelDouble(X, Y, FVector4(X / 32.0, Y / 16.0, 0.25, 1.0));
			}
		}
		FSceneTextures SceneTextures;
		SceneTextures.Config.Extent = FIntPoint(Width, Height);
		SceneTextures.Color =
			GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("SceneColor")), TEXT("SceneColor"));
		return SceneTextures;
	};
	return Inputs;
}

inline FFrameResult Render(const FFrameInputs& Inputs = MakeFrame())
{
	return RenderViewFamily(Inputs);
}

/** "Extension.Hook" of each call, hooks that say nothing left out: SetupView and the like are kept. */
inline std::vector<std::string> GetCalls(const FFrameResult& Frame)
{
	std::vector<std::string> Calls;
	for (const FHookCall& Call : Frame.Log.Calls)
	{
		Calls.push_back(Call.Extension + "." + Call.Hook);
	}
	return Calls;
}

/** What an extension did at a hook, the first time; "(not called)" otherwise. */
inline std::string GetDid(const FFrameResult& Frame, const std::string& Hook)
{
	const auto Found = std::find_if(
		Frame.Log.Calls.begin(), Frame.Log.Calls.end(), [&](const FHookCall& Call) { return Call.Hook == Hook; });
	return Found == Frame.Log.Calls.end() ? "(not called)" : Found->Did;
}

inline const FHookPoint* FindPoint(const FFrameResult& Frame, const std::string& Name)
{
	const auto Found = std::find_if(
		Frame.Log.Points.begin(), Frame.Log.Points.end(), [&](const FHookPoint& Point) { return Point.Point == Name; });
	return Found == Frame.Log.Points.end() ? nullptr : &*Found;
}

inline std::vector<int> GetCodes(const FFrameResult& Frame)
{
	std::vector<int> Codes;
	for (const FDiagnostic& Diagnostic : Frame.Log.Diagnostics)
	{
		Codes.push_back(Diagnostic.Code);
	}
	return Codes;
}

} // namespace ExtensionTest
