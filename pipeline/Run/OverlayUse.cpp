// Asks the ledger of effects why a pass was not called, and the passes for their shaders.
#include "Run/OverlayUse.h"

#include "GlobalShader.h"
#include "Overlay/OverlayErrors.h"
#include "Overlay/OverlayShaders.h"
#include "RangeTools.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <algorithm>
#include <set>

namespace Drydock
{

namespace
{

/** Why the chain did not call it; empty: no reason is known, and the overlay's own code may have called it. */
std::string DescribeUncalled(const FPassFunction& Pass, const FOverlayFolder& Folder, const FRunResult& Result)
{
	const FEffectDecision* const Found = FindItem(Result.Effects, Pass.Effect, &FEffectDecision::GetName);
	if (Found == nullptr || !Found->bActive)
	{
		return std::string(Pass.Effect) + " does not run" + (Found == nullptr ? "" : ": " + Found->Reason);
	}
	if (Found->GetId() == EEffect::Bloom && IsEffectActive(Result.Effects, EEffect::FFTBloom))
	{
		return "bloom is a convolution: " + FindEffect(Result.Effects, EEffect::FFTBloom)->Reason;
	}
	const float Threshold = Result.Settings.BloomThreshold;
	if (std::string_view(Pass.Name) == ChainPlacesOfOverlays[0].Call && !(Threshold > -1.0f))
	{
		const bool bOwn =
			std::ranges::any_of(Folder.Places, [](const FOverlayPlace& Place) { return !Place.Condition.empty(); });
		return "BloomThreshold is " + NumberText(Threshold) + " and local exposure does not act on bloom, so " +
			   ChainPlacesOfOverlays[0].Condition + " is false" +
			   (bOwn ? ", in the overlay's own definition, too" : "");
	}
	const bool bAlone = Folder.Passes.size() + Folder.Places.size() == 1;
	return bAlone ? std::string(Pass.Effect) + " runs without it (" + Found->Reason + ")" : "";
}

/** Files that the shaders of the frame's passes are made of: virtual paths in lower case. */
std::set<std::string> ListUsedShaders(const FRunResult& Result)
{
	std::set<std::string> Names;
	for (const FRunPass& Pass : Result.Passes)
	{
		const std::string& Shader = Result.Graph.Passes.at(static_cast<size_t>(Pass.Index)).Shader;
		Names.insert(Shader.empty() ? Pass.Counters.Shader : Shader);
	}
	std::set<std::string> Used;
	ForEachGlobalShader(
		[&](const FGlobalShaderType& Type)
		{
			if (Names.contains(Type.GetName()))
			{
				Used.merge(ListIncludedShaders(Type.GetShaderFilename()));
			}
		});
	return Used;
}

} // namespace

std::vector<FDiagnostic> FindUnusedOfOverlays(
	const std::vector<FOverlayFolder>& Folders, const std::vector<std::string>& Uncalled, const FRunResult& Result)
{
	std::vector<FDiagnostic> Notes;
	const auto Note = [&](const std::string& Message)
	{
		Notes.push_back({.Severity = ESeverity::Note, .Code = NoteOverlayNotUsed, .Message = Message});
	};
	const auto NoteUncalled = [&](const FOverlayFolder& Folder, const std::string& Name, const FPassFunction& Pass)
	{
		if (const std::string Why = Contains(Uncalled, Name) ? DescribeUncalled(Pass, Folder, Result) : "";
			!Why.empty())
		{
			Note("the overlay " + Folder.Name + "'s " + Name + " was not called: " + Why);
		}
	};
	const std::set<std::string> Used =
		Result.Passes.empty() || Folders.empty() ? std::set<std::string>() : ListUsedShaders(Result);
	const std::set<std::string> Read = Folders.empty() ? std::set<std::string>() : ListReadShaders(Result.Config);
	for (const FOverlayFolder& Folder : Folders)
	{
		for (const FOverlayPass& Pass : Folder.Passes)
		{
			NoteUncalled(Folder, Pass.Function->Name, *Pass.Function);
		}
		for (const FOverlayPlace& Place : Folder.Places)
		{
			for (const FPassFunction& Pass : GetPassFunctions())
			{
				if (std::string_view(Pass.Name) == Place.Place->Call)
				{
					NoteUncalled(Folder, Place.Place->Name, Pass);
				}
			}
		}
		for (const std::string& Shader : Folder.Shaders)
		{
			const std::string Lower = ToLowerCase(Shader);
			if (!Result.Passes.empty() && Read.contains(Lower) && !Used.contains(Lower))
			{
				Note("the overlay " + Folder.Name + "'s " + Shader +
					 " is in no pass of this frame; `drydock check` compiles it all the same");
			}
		}
	}
	return Notes;
}

} // namespace Drydock
