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

bool HoldsLight(EPixelFormat Format)
{
	return Format == PF_FloatRGBA || Format == PF_FloatRGB || Format == PF_FloatR11G11B10 || Format == PF_A32B32G32R32F;
}

/** Adds what is allowed, and what the passes behind seldom expect. */
void NoteUnexpected(const FPostProcessMaterialInputs& Inputs, const FScreenPassTexture& Result, bool bLinear,
	FDiagnostic Diagnostic, std::vector<FDiagnostic>& Out)
{
	const FScreenPassTexture Given(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	const FIntPoint Size = Result.ViewRect.Size();
	const FIntPoint Before = Given.ViewRect.Size();
	if (Inputs.OverrideOutput.IsValid())
	{
		return;
	}
	const auto Add = [&](ESeverity Severity, int Code, const std::string& Message)
	{
		Diagnostic.Severity = Severity;
		Diagnostic.Code = Code;
		Diagnostic.Message = Message;
		Out.push_back(Diagnostic);
	};
	if (Size != Before)
	{
		Add(ESeverity::Note, NoteCallbackSize,
			"its callback returned a view of " + std::to_string(Size.X) + " x " + std::to_string(Size.Y) +
				", and its input is " + std::to_string(Before.X) + " x " + std::to_string(Before.Y) +
				": the passes behind it go on at the size that it returned; draw to a rect as large as the input's");
	}
	const EPixelFormat Format = Result.Texture->Desc.Format;
	if (bLinear && HoldsLight(Given.Texture->Desc.Format) && !HoldsLight(Format))
	{
		Add(ESeverity::Warning, WarnCallbackFormat,
			"its callback returned " + TextureText(Result.Texture) + " of " + GetPixelFormatString(Format) +
				", and its input is linear light of " + GetPixelFormatString(Given.Texture->Desc.Format) +
				": what the format does not hold is lost before bloom and tonemapper; create the output from the "
				"input's Desc");
	}
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
	const FPassCallback& Callback, const FPostProcessMaterialInputs& Inputs, bool bLinear, FHookLog& Log)
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
		FDiagnostic Place = MakeExtensionDiagnostic(ESeverity::Note, 0, Callback.Extension, "");
		Place.Where += " at " + Point;
		NoteUnexpected(Inputs, Result, bLinear, std::move(Place), Log.Diagnostics);
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
