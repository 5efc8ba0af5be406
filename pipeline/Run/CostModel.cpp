// Learns from runs what a texel of a pass costs, and estimates by it.
#include "Run/CostModel.h"

#include "Run/RunOutputs.h"
#include "ShaderCache.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace Drydock
{

namespace
{

const char* const CostsFile = "costs.json"; // in the shader cache

/** Passes of one shader cost alike; passes without one are known by name, whichever their number. */
std::string GetKey(const FRDGCompiledPass& Pass, const std::string& Conditions)
{
	std::string Kind = Pass.Shader;
	if (Kind.empty())
	{
		std::copy_if(Pass.Name.begin(), Pass.Name.end(), std::back_inserter(Kind),
			[](char Letter) { return Letter < '0' || Letter > '9'; });
	}
	return Kind + (Pass.Entry.empty() ? "" : ":" + Pass.Entry) + " " + Conditions;
}

/** With what the pass reads, which tells permutations of one shader apart: a tonemapper with local exposure costs three
 * times one without. */
std::string GetExactKey(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass, const std::string& Conditions)
{
	std::set<std::string> Names;
	for (const FRDGUse& Use : Pass.Uses)
	{
		if (Use.IsRead())
		{
			Names.insert(Graph.Resources[static_cast<size_t>(Use.Resource)].Name);
		}
	}
	return GetKey(Pass, Conditions) + " of" + JoinText(Names, "", [](const std::string& Name) { return " " + Name; });
}

uint64_t CountTexels(const FRDGResourceDescription& Resource, const FRDGUse& Use)
{
	if (Resource.Kind == ERDGResourceKind::Buffer)
	{
		return static_cast<uint64_t>(std::max(Resource.Extent.X, 1));
	}
	uint64_t Texels = 0;
	for (int32_t Mip = Use.FirstMip; Mip < Use.FirstMip + Use.NumMips; ++Mip)
	{
		const auto Side = [Mip](int32_t Size)
		{
			return static_cast<uint64_t>(std::max(Size >> Mip, 1));
		};
		Texels += Side(Resource.Extent.X) * Side(Resource.Extent.Y) * Side(Resource.Extent.Z);
	}
	return Texels * static_cast<uint64_t>(std::max(Use.NumSlices, 1));
}

} // namespace

std::string MakeCostConditions(const FRunResult& Result)
{
	return Result.Precision + " " + Result.Storage + " " + std::to_string(Result.Threads) +
		   (Result.Device.empty() ? "" : " " + Result.Device);
}

uint64_t CountWrittenTexels(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass)
{
	uint64_t Most = 0; // several targets are written by one draw
	for (const FRDGUse& Use : Pass.Uses)
	{
		if (Use.IsWrite())
		{
			Most = std::max(Most, CountTexels(Graph.Resources[static_cast<size_t>(Use.Resource)], Use));
		}
	}
	const uint64_t Drawn = static_cast<uint64_t>(Pass.Area.X) * static_cast<uint64_t>(Pass.Area.Y);
	return Drawn > 0 ? std::min(Most, Drawn) : Most;
}

FCostModel FCostModel::Load()
{
	return FromJson(FShaderCache::Open().ReadText(CostsFile).value_or(""));
}

void FCostModel::Learn(const FRunResult& Result)
{
	struct FSum
	{
		double Nanoseconds = 0.0;
		double Texels = 0.0;
	};
	std::map<std::string, FSum> Sums;
	const std::string Conditions = MakeCostConditions(Result);
	for (const FRunPass& Run : Result.Passes)
	{
		const FRDGCompiledPass& Pass = Result.Graph.Passes[static_cast<size_t>(Run.Index)];
		if (Run.Counters.Reused > 0)
		{
			continue; // it cost less than it does
		}
		for (const std::string& Key : {GetKey(Pass, Conditions), GetExactKey(Result.Graph, Pass, Conditions)})
		{
			FSum& Sum = Sums[Key];
			Sum.Nanoseconds += 1e6 * Run.Milliseconds;
			Sum.Texels += static_cast<double>(CountWrittenTexels(Result.Graph, Pass));
		}
	}
	for (const auto& [Key, Sum] : Sums)
	{
		if (Sum.Texels > 0.0)
		{
			const double Cost = Sum.Nanoseconds / Sum.Texels;
			const auto [Known, bNew] = NanosecondsPerTexel.try_emplace(Key, Cost);
			Known->second = 0.5 * (Known->second + Cost);
		}
	}
}

void FCostModel::Save() const
{
	FShaderCache::Open().StoreText(CostsFile, ToJson());
}

bool FCostModel::IsKnown(const FRDGCompiledPass& Pass, const std::string& Conditions) const
{
	return NanosecondsPerTexel.count(GetKey(Pass, Conditions)) > 0;
}

double FCostModel::EstimateMilliseconds(
	const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass, const std::string& Conditions) const
{
	auto Known = NanosecondsPerTexel.find(GetExactKey(Graph, Pass, Conditions));
	if (Known == NanosecondsPerTexel.end())
	{
		Known = NanosecondsPerTexel.find(GetKey(Pass, Conditions));
	}
	const double Cost = Known != NanosecondsPerTexel.end() ? Known->second : UnknownCost;
	return 1e-6 * Cost * static_cast<double>(CountWrittenTexels(Graph, Pass));
}

std::string FCostModel::ToJson() const
{
	FJsonWriter Writer('{');
	for (const auto& [Key, Cost] : NanosecondsPerTexel)
	{
		Writer.Member(Key, Cost);
	}
	return Writer.GetText();
}

FCostModel FCostModel::FromJson(const std::string& Text)
{
	FCostModel Model;
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = Text.empty();
	const FJsonValue Root = bSyntaxError ? FJsonValue() : ParseJson(Text, "costs.json", Ignored, bSyntaxError);
	for (const FJsonMember& Member : Root.Members)
	{
		if (!bSyntaxError && Member.Value.Type == EJsonType::Number && Member.Value.Number > 0.0)
		{
			Model.NanosecondsPerTexel[Member.Key] = Member.Value.Number;
		}
	}
	return Model;
}

} // namespace Drydock
