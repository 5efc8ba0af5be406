// Decides which resources are kept and what their files are called.
#include "Run/RunDump.h"

#include "Config/ConfigReader.h"
#include "RangeTools.h"
#include "RenderGraphPass.h"
#include "ShaderParameterMetadata.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/GlobPattern.h"
#include "Text/TextFormat.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

/** Names that a pattern could have meant. For a pattern that ends with *: their beginnings of nearly its length. */
std::vector<std::string> GetDumpCandidates(const std::string& Pattern, const FRDGCompiledGraph& Graph)
{
	auto Names =
		ToVector<std::string>(Graph.Passes, [&](const FRDGCompiledPass& Pass) { return GetShortPassName(Pass.Name); });
	for (const FRDGCompiledResource& Resource : Graph.Resources)
	{
		Names.push_back(Resource.Name);
	}
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		for (const FRDGUse& Use : Pass.Uses)
		{
			Names.push_back(
				GetShortPassName(Pass.Name) + "." + Graph.Resources[static_cast<size_t>(Use.Resource)].Name);
		}
	}
	if (Pattern.size() > 2 && Pattern.back() == '*')
	{
		for (std::string& Name : Names)
		{
			Name = Name.substr(0, Pattern.size() - 2) + "*";
		}
	}
	return Names;
}

/** The first culled pass that a pattern fits, or null. */
const FRDGCompiledPass* FindCulledMatch(const std::string& Pattern, const FRDGCompiledGraph& Graph)
{
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		if (!Pass.bCulled)
		{
			continue;
		}
		for (const FRDGUse& Use : Pass.Uses)
		{
			const std::string& Resource = Graph.Resources[static_cast<size_t>(Use.Resource)].Name;
			if (Use.IsWrite() && IsDumped({{Pattern, {}}}, Pass.Name, Resource))
			{
				return &Pass;
			}
		}
	}
	return nullptr;
}

} // namespace

std::string GetShortPassName(const std::string& Pass)
{
	return Pass.substr(0, Pass.find_first_of(" ("));
}

bool IsPassNamed(const std::string& Pattern, const std::string& Pass)
{
	return MatchesPattern(Pattern, Pass) || MatchesPattern(Pattern, GetShortPassName(Pass));
}

bool IsDumped(
	const std::vector<TConfigValue<std::string>>& Patterns, const std::string& Pass, const std::string& Resource)
{
	const std::string Short = GetShortPassName(Pass);
	return std::ranges::any_of(Patterns,
		[&](const TConfigValue<std::string>& Pattern)
		{
			const auto Fits = [&](const std::string& Name)
			{
				return MatchesPattern(Pattern.Value, Name);
			};
			return Fits(Pass) || Fits(Short) || Fits(Resource) || Fits(Pass + "." + Resource) ||
				   Fits(Short + "." + Resource);
		});
}

std::string GetDumpFileName(const FRunDump& Dump)
{
	return fmt::format("{:03}.{}.{}", Dump.PassIndex, MakeFileNamePart(GetShortPassName(Dump.Pass)),
			   MakeFileNamePart(Dump.Resource)) +
		   (Dump.Mip >= 0 ? ".mip" + std::to_string(Dump.Mip) : "");
}

TOptional<FIntRect> FindOutputRect(const FRDGPass& Pass, FIntPoint Extent)
{
	if (Pass.GetParametersMetadata() == nullptr)
	{
		return {};
	}
	const std::vector<FHlslMember>& Members = Pass.GetParametersMetadata()->GetHlslMembers();
	const auto Find = [&](const char* Name, EUniformBufferBaseType Type, auto& Value)
	{
		const auto Member = std::ranges::find_if(Members, [&](const FHlslMember& Each)
			{ return Each.Name == Name && Each.BaseType == Type && Each.NumColumns == 2 && Each.NumElements == 0; });
		if (Member != Members.end())
		{
			std::memcpy(&Value, static_cast<const uint8*>(Pass.GetParameters()) + Member->Offset, sizeof(Value));
		}
		return Member != Members.end();
	};
	FVector2f OutputExtent;
	FIntRect Rect;
	const bool bSaid = Find("Output_Extent", UBMT_FLOAT32, OutputExtent) &&
					   Find("Output_ViewportMin", UBMT_INT32, Rect.Min) &&
					   Find("Output_ViewportMax", UBMT_INT32, Rect.Max);
	return bSaid && OutputExtent == FVector2f(Extent) ? TOptional<FIntRect>(Rect) : TOptional<FIntRect>();
}

std::vector<FDiagnostic> CheckDumpPatterns(
	const std::vector<TConfigValue<std::string>>& Patterns, const FRunResult& Result)
{
	std::vector<FDiagnostic> Diagnostics;
	FConfigMessages Messages(Result.Config.File, Diagnostics);
	for (const TConfigValue<std::string>& Pattern : Patterns)
	{
		const bool bUsed = std::ranges::any_of(
			Result.Dumps, [&](const FRunDump& Dump) { return IsDumped({Pattern}, Dump.Pass, Dump.Resource); });
		if (bUsed)
		{
			continue;
		}
		const FRDGCompiledPass* Culled = FindCulledMatch(Pattern.Value, Result.Graph);
		const std::string Why =
			Culled != nullptr
				? "matches only culled passes: " + Culled->Name + " (" + Result.Graph.DescribeCulled(*Culled) + ")"
				: "matches no pass and no resource" +
					  Suggest(Pattern.Value, GetDumpCandidates(Pattern.Value, Result.Graph));
		Messages.Warn(WarnNothingDumped, Pattern.Place, "dump pattern \"" + Pattern.Value + "\" " + Why);
	}
	return Diagnostics;
}

} // namespace Drydock
