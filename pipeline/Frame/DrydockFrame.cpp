// Makes a frame of plain pixels and settings and renders it.
#include "Frame/DrydockFrame.h"

#include "EngineProfile.h"
#include "FinalPostProcessSettings.h"
#include "Frame/Frame.h"
#include "PrintText.h"
#include "RenderGraphBuilder.h"
#include "RenderTargetPool.h"
#include "Text/ConfigErrors.h"
#include "RangeTools.h"

#include <cstdio>

namespace Drydock
{

namespace
{

[[noreturn]] void Fail(EConfigError Code, const std::string& Where, const std::string& Message)
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = Code;
	Diagnostic.Where = "FFrameDesc::" + Where;
	Diagnostic.Message = Message;
	throw FError(Diagnostic, ExitUsage);
}

FIntRect GetViewRect(const FFrameDesc& Desc)
{
	const FIntRect Whole(FIntPoint(0, 0), Desc.Extent);
	return Desc.ViewRect.Width() == 0 && Desc.ViewRect.Height() == 0 ? Whole : Desc.ViewRect;
}

void CheckDesc(const FFrameDesc& Desc)
{
	const int64 NumPixels = static_cast<int64>(Desc.Extent.X) * Desc.Extent.Y;
	if (Desc.Extent.X <= 0 || Desc.Extent.Y <= 0)
	{
		Fail(ErrorBadValue, "Extent", "it must be above 0");
	}
	if (Desc.SceneColor.Num() != NumPixels)
	{
		Fail(ErrorWrongLength, "SceneColor",
			"expected " + std::to_string(NumPixels) + " pixels, found " + std::to_string(Desc.SceneColor.Num()));
	}
	if (Desc.ShadingModelID.Num() != 0 && Desc.ShadingModelID.Num() != NumPixels)
	{
		Fail(ErrorWrongLength, "ShadingModelID",
			"expected " + std::to_string(NumPixels) + " ids or none, found " +
				std::to_string(Desc.ShadingModelID.Num()));
	}
	const FIntRect Rect = GetViewRect(Desc);
	if (Rect.Min.X < 0 || Rect.Min.Y < 0 || Rect.Max.X > Desc.Extent.X || Rect.Max.Y > Desc.Extent.Y ||
		Rect.Width() <= 0 || Rect.Height() <= 0)
	{
		Fail(ErrorBadValue, "ViewRect", "it must be inside the extent and not empty");
	}
	if (FindEngineProfile(Desc.EngineMinorVersion) == nullptr)
	{
		Fail(ErrorBadValue, "EngineMinorVersion",
			"5." + std::to_string(Desc.EngineMinorVersion) + " is none of " + ListEngineVersions(", "));
	}
}

FEngineShowFlags MakeShowFlags(const FFrameDesc& Desc)
{
	FEngineShowFlags Flags;
	for (const TPair<FString, bool>& Flag : Desc.ShowFlags)
	{
		const std::string Name = *Flag.Key;
		const int32 Index = FEngineShowFlags::FindIndexByName(Name.c_str());
		if (Index == INDEX_NONE)
		{
			auto Names = ToVector<std::string>(GetShowFlagInfos(), &FShowFlagInfo::Name);
			Fail(ErrorUnknownShowFlag, "ShowFlags", "unknown show flag " + Name + SuggestName(Name, Names));
		}
		Flags.SetSingleFlag(static_cast<uint32>(Index), Flag.Value);
	}
	return Flags;
}

/** Pixel: the colour of a position in the rows. */
template<typename TPixel>
FRDGTextureRef Register(
	FRDGBuilder& GraphBuilder, const TCHAR* Name, FIntPoint Extent, EPixelFormat Format, TPixel Pixel)
{
	const TRefCountPtr<FRHITexture> Texture = new FRHITexture(
		FRHITextureDesc::Create2D(Extent, Format, FClearValueBinding::Black,
			ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable | ETextureCreateFlags::UAV),
		Name);
	TArray<FLinearColor> Row;
	Row.SetNum(Extent.X);
	for (int32 Y = 0; Y < Extent.Y; ++Y)
	{
		for (int32 X = 0; X < Extent.X; ++X)
		{
			Row[X] = Pixel(Y * Extent.X + X);
		}
		Texture->WriteRow(0, Y, Row);
	}
	return GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, Name), Name);
}

FSceneTextures RegisterSceneTextures(FRDGBuilder& GraphBuilder, const FFrameDesc& Desc)
{
	FSceneTextures SceneTextures;
	SceneTextures.Config.Extent = Desc.Extent;
	SceneTextures.Color = Register(GraphBuilder, TEXT("SceneColor"), Desc.Extent, PF_FloatRGBA,
		[&](int32 Index) { return Desc.SceneColor[Index]; });
	if (Desc.ShadingModelID.Num() != 0)
	{
		SceneTextures.GBufferB = Register(GraphBuilder, TEXT("GBufferB"), Desc.Extent, PF_B8G8R8A8,
			[&](int32 Index)
			{ return FLinearColor(0.0f, 0.0f, 0.0f, static_cast<float>(Desc.ShadingModelID[Index] & 0xF) / 255.0f); });
	}
	return SceneTextures;
}

} // namespace

FFrameOutput RenderFrame(const FFrameDesc& Desc)
{
	CheckDesc(Desc);
	FFrameInputs Inputs;
	Inputs.Engine = *FindEngineProfile(Desc.EngineMinorVersion);
	Inputs.Extent = Desc.Extent;
	Inputs.ShowFlags = MakeShowFlags(Desc);
	FFrameView View;
	View.Rect = GetViewRect(Desc);
	View.Settings.ShowFlags = Inputs.ShowFlags;
	View.Settings.Settings = StartFinalPostProcessSettings();
	View.Settings.Gates = EndFinalPostProcessSettings(View.Settings.Settings, Inputs.ShowFlags);
	Inputs.Views.push_back(View);
	Inputs.RegisterSceneTextures = [&Desc](FRDGBuilder& GraphBuilder)
	{
		return RegisterSceneTextures(GraphBuilder, Desc);
	};
	const FFrameResult Result = RenderViewFamily(Inputs);
	for (const FDiagnostic& Diagnostic : Result.Log.Diagnostics)
	{
		PrintText(stderr, Diagnostic.ToString() + "\n");
	}

	FFrameOutput Output;
	Output.Extent = FIntPoint(Result.Final.Width, Result.Final.Height);
	Output.Color.Reserve(Output.Extent.X * Output.Extent.Y);
	for (int Y = 0; Y < Result.Final.Height; ++Y)
	{
		for (int X = 0; X < Result.Final.Width; ++X)
		{
			const auto Get = [&](int Channel)
			{
				return static_cast<float>(Result.Final.Get(X, Y, Channel));
			};
			Output.Color.Add(FLinearColor(Get(0), Get(1), Get(2), Get(3)));
		}
	}
	return Output;
}

} // namespace Drydock
