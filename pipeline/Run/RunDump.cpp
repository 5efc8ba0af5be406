// Decides which resources are kept and what their files are called.
#include "Run/RunDump.h"

#include "Config/ConfigReader.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace Drydock
{

namespace
{

std::string Sanitize(const std::string& Name)
{
	std::string Clean = Name;
	std::replace_if(
		Clean.begin(), Clean.end(),
		[](char Character)
		{ return !std::isalnum(static_cast<unsigned char>(Character)) && Character != '_' && Character != '-'; },
		'_');
	return Clean;
}

/** Names that a pattern could have meant. */
std::vector<std::string> GetDumpCandidates(const FRDGCompiledGraph& Graph)
{
	std::vector<std::string> Names;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		Names.push_back(GetShortPassName(Pass.Name));
	}
	for (const FRDGCompiledResource& Resource : Graph.Resources)
	{
		Names.push_back(Resource.Name);
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

bool IsDumped(
	const std::vector<TConfigValue<std::string>>& Patterns, const std::string& Pass, const std::string& Resource)
{
	const std::string Short = GetShortPassName(Pass);
	return std::any_of(Patterns.begin(), Patterns.end(),
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
	char Number[16];
	std::snprintf(Number, sizeof(Number), "%03d", Dump.PassIndex);
	return std::string(Number) + "." + Sanitize(GetShortPassName(Dump.Pass)) + "." + Sanitize(Dump.Resource) +
		   (Dump.Mip >= 0 ? ".mip" + std::to_string(Dump.Mip) : "");
}

std::vector<FDiagnostic> CheckDumpPatterns(
	const std::vector<TConfigValue<std::string>>& Patterns, const FRunResult& Result)
{
	std::vector<FDiagnostic> Diagnostics;
	FConfigMessages Messages(Result.Config.File, Diagnostics);
	for (const TConfigValue<std::string>& Pattern : Patterns)
	{
		const bool bUsed = std::any_of(Result.Dumps.begin(), Result.Dumps.end(),
			[&](const FRunDump& Dump) { return IsDumped({Pattern}, Dump.Pass, Dump.Resource); });
		if (bUsed)
		{
			continue;
		}
		const FRDGCompiledPass* Culled = FindCulledMatch(Pattern.Value, Result.Graph);
		const std::string Why =
			Culled != nullptr
				? "fits only culled passes: " + Culled->Name + " (" + Culled->Reason + ")"
				: "fits no pass and no resource" + Suggest(Pattern.Value, GetDumpCandidates(Result.Graph));
		Messages.Warn(WarnNothingDumped, Pattern.Place, "dump pattern \"" + Pattern.Value + "\" " + Why);
	}
	return Diagnostics;
}

} // namespace Drydock
