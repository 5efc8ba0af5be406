// Calls one callback and holds what it returns to the engine's contract.
#include "Chain/PassCallbacks.h"

#include "CodeScope.h"
#include "Extensions/ExtensionErrors.h"
#include "PixelFormat.h"

namespace Drydock
{

namespace
{

bool IsValidationStrict()
{
	const IConsoleVariable* Validation = IConsoleManager::Get().FindConsoleVariable(TEXT("r.RDG.Validation"));
	return Validation != nullptr && Validation->GetInt() >= 2;
}

std::string RectText(const FIntRect& Rect)
{
	return "[" + std::to_string(Rect.Min.X) + ", " + std::to_string(Rect.Min.Y) + ", " + std::to_string(Rect.Max.X) +
		   ", " + std::to_string(Rect.Max.Y) + "]";
}

std::string TextureText(FRDGTextureRef Texture)
{
	return std::string(Texture->Name) + " (" + std::to_string(Texture->Desc.Extent.X) + " x " +
		   std::to_string(Texture->Desc.Extent.Y) + ")";
}

bool IsInside(const FIntRect& Rect, FIntPoint Extent)
{
	return Rect.Min.X >= 0 && Rect.Min.Y >= 0 && Rect.Max.X <= Extent.X && Rect.Max.Y <= Extent.Y;
}

struct FBreach
{
	int Code = 0; // 0: none
	std::string Message;
};

/** Finds what the callback did wrong. bWasDrawn: OverrideOutput had contents before it ran. */
FBreach FindBreach(const FPostProcessMaterialInputs& Inputs, const FScreenPassTexture& Result, bool bWasDrawn)
{
	const FScreenPassRenderTarget& Override = Inputs.OverrideOutput;
	if (Result.Texture == nullptr)
	{
		return {ErrorCallbackInvalidTexture, "its callback returned no texture"};
	}
	if (!Result.IsValid())
	{
		return {ErrorCallbackInvalidTexture, "its callback returned " + TextureText(Result.Texture) +
												 " with the empty rect " + RectText(Result.ViewRect)};
	}
	if (Override.IsValid() && Result.Texture != Override.Texture)
	{
		return {ErrorCallbackOverride, "its callback is the last of the frame and ignored the valid OverrideOutput " +
										   TextureText(Override.Texture) + ": it returned " +
										   TextureText(Result.Texture) + "; draw to OverrideOutput and return it"};
	}
	if (!IsInside(Result.ViewRect, Result.Texture->Desc.Extent))
	{
		return {ErrorCallbackRect, "its callback returned " + TextureText(Result.Texture) + " with the rect " +
									   RectText(Result.ViewRect) +
									   ", which leaves it; a texture of another size needs a ViewRect of its own"};
	}
	if (Override.IsValid() && !bWasDrawn && !Override.Texture->HasBeenProduced())
	{
		return {ErrorCallbackNotDrawn, "its callback is the last of the frame and returned OverrideOutput with "
									   "nothing drawn to it: in the engine the screen would be black or stale"};
	}
	return {};
}

FScreenPassTexture ReturnUntouched(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPostProcessMaterialInputs& Inputs)
{
	const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	if (!Inputs.OverrideOutput.IsValid())
	{
		return SceneColor;
	}
	AddDrawTexturePass(GraphBuilder, View, SceneColor, Inputs.OverrideOutput);
	return Inputs.OverrideOutput;
}

bool IsInput(const FPostProcessMaterialInputs& Inputs, const FScreenPassTexture& Result)
{
	const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	return Result.Texture == SceneColor.Texture && Result.ViewRect == SceneColor.ViewRect;
}

std::string DescribeResult(const FPostProcessMaterialInputs& Inputs, const FScreenPassTexture& Result)
{
	if (IsInput(Inputs, Result))
	{
		return "returned its input";
	}
	return (Inputs.OverrideOutput.IsValid() ? "drew to " : "returned ") + TextureText(Result.Texture) + " " +
		   GetPixelFormatString(Result.Texture->Desc.Format);
}

} // namespace

FScreenPassTexture RunPassCallback(FRDGBuilder& GraphBuilder, const FNamedView& View, const std::string& Point,
	const FPassCallback& Callback, const FPostProcessMaterialInputs& Inputs, FHookLog& Log)
{
	if (!Callback.Delegate.IsBound())
	{
		Log.Diagnostics.push_back(MakeExtensionDiagnostic(ESeverity::Warning, WarnCallbackUnbound, Callback.Extension,
			"its callback at " + Point + " is not bound, or its object is gone: the picture goes on untouched"));
		return ReturnUntouched(GraphBuilder, *View.View, Inputs);
	}
	const std::string Scope = Point + ": " + Callback.Extension + (View.Name.empty() ? "" : ", " + View.Name);
	RDG_EVENT_SCOPE(GraphBuilder, "%s", Scope.c_str());
	const size_t LogIndex = Log.Calls.size();
	Log.Calls.push_back({Point, View.Name, Callback.Extension, "", Scope});

	const bool bWasDrawn = Inputs.OverrideOutput.IsValid() && Inputs.OverrideOutput.Texture->HasBeenProduced();
	const FScreenPassTexture Result = CallCode(Callback.Owner,
		[&]
		{
			const FScreenPassTexture Returned = Callback.Delegate.Execute(GraphBuilder, *View.View, Inputs);
			if (Returned.Texture != nullptr)
			{
				GraphBuilder.CheckArgument(Returned.Texture, "what it returned", "Texture");
			}
			return Returned;
		});
	const FBreach Breach = FindBreach(Inputs, Result, bWasDrawn);
	if (Breach.Code == 0)
	{
		Log.Calls[LogIndex].Did = DescribeResult(Inputs, Result);
		Log.Calls[LogIndex].bReturnedInput = IsInput(Inputs, Result);
		return Result;
	}
	const ESeverity Severity = IsValidationStrict() ? ESeverity::Error : ESeverity::Warning;
	FDiagnostic Diagnostic = MakeExtensionDiagnostic(Severity, Breach.Code, Callback.Extension, Breach.Message);
	Diagnostic.Where += " at " + Point;
	Log.Diagnostics.push_back(Diagnostic);
	if (IsValidationStrict())
	{
		throw FError(Log.Diagnostics, ExitUsage);
	}
	Log.Diagnostics.back().Message += "; the picture goes on untouched";
	Log.Calls[LogIndex].Did = "broke its contract: the picture goes on untouched";
	return ReturnUntouched(GraphBuilder, *View.View, Inputs);
}

} // namespace Drydock
