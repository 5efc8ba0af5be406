// Puts a frame beside the same frame with nothing skipped.
#include "Run/Explain.h"

#include <algorithm>

namespace Drydock
{

namespace
{

bool IsReal(const FRDGCompiledPass& Pass)
{
	return !Pass.bIsSentinel;
}

const double* FindMeasured(const FMeasuredPasses* Measured, int Index)
{
	if (Measured == nullptr)
	{
		return nullptr;
	}
	const auto Found = std::find_if(Measured->begin(), Measured->end(),
		[Index](const std::pair<int, double>& Pass) { return Pass.first == Index; });
	return Found == Measured->end() ? nullptr : &Found->second;
}

FExplainedCost MakeCost(const FRunResult& Result, const FCostModel& Model, const FMeasuredPasses* Measured)
{
	FExplainedCost Cost;
	Cost.TransientBytes = Result.Graph.Memory.TransientPeakBytes;
	Cost.SceneBytes = Result.SceneTextureBytes;
	Cost.NumChannels = static_cast<int>(std::count_if(
		Result.Channels.begin(), Result.Channels.end(), [](const FSceneChannel& Channel) { return Channel.bDecoded; }));
	const std::string Conditions = MakeCostConditions(Result);
	for (const FRDGCompiledPass& Pass : Result.Graph.Passes)
	{
		if (IsReal(Pass) && !Pass.bCulled)
		{
			const double* Milliseconds = FindMeasured(Measured, Pass.Index);
			++Cost.NumPasses;
			Cost.Milliseconds +=
				Milliseconds != nullptr ? *Milliseconds : Model.EstimateMilliseconds(Result.Graph, Pass, Conditions);
		}
	}
	return Cost;
}

std::vector<std::string> NameResources(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass, bool bWritten)
{
	std::vector<std::string> Names;
	for (const FRDGUse& Use : Pass.Uses)
	{
		const std::string& Name = Graph.Resources[static_cast<size_t>(Use.Resource)].Name;
		const bool bWanted = bWritten ? Use.IsWrite() : Use.IsRead();
		if (bWanted && std::find(Names.begin(), Names.end(), Name) == Names.end())
		{
			Names.push_back(Name);
		}
	}
	return Names;
}

std::vector<std::string> NameReaders(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass)
{
	std::vector<std::string> Names;
	for (const FRDGCompiledPass& Other : Graph.Passes)
	{
		const bool bReads =
			std::find(Other.Producers.begin(), Other.Producers.end(), Pass.Index) != Other.Producers.end();
		if (bReads && !Other.bCulled && !Other.bIsSentinel)
		{
			Names.push_back(Other.Name);
		}
	}
	return Names;
}

double GetMegabytesWritten(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass)
{
	double Bytes = 0.0;
	for (const FRDGUse& Use : Pass.Uses)
	{
		Bytes += Use.IsWrite() ? static_cast<double>(Graph.Resources[static_cast<size_t>(Use.Resource)].Bytes) : 0.0;
	}
	return 1e-6 * Bytes;
}

} // namespace

FExplainReport MakeExplainReport(const FRunResult& Frame, const FRunResult& NoSkip, const FCostModel& Model,
	const FMeasuredPasses* MeasuredFrame, const FMeasuredPasses* MeasuredNoSkip)
{
	FExplainReport Report;
	Report.Config = Frame.Config.File;
	Report.Channels = Frame.Channels;
	Report.bMeasured = MeasuredFrame != nullptr;
	Report.Cost = MakeCost(Frame, Model, MeasuredFrame);
	Report.WithoutSkipping = MakeCost(NoSkip, Model, MeasuredNoSkip);
	for (const FEffectDecision& Decision : Frame.Effects)
	{
		Report.Effects.push_back({Decision});
	}
	const std::string Conditions = MakeCostConditions(Frame);
	for (const FRDGCompiledPass& Pass : Frame.Graph.Passes)
	{
		if (!IsReal(Pass))
		{
			continue;
		}
		FExplainedPass Explained;
		Explained.Index = Pass.Index;
		Explained.Name = Pass.Name;
		Explained.Effect = Pass.Effect;
		Explained.bExecutes = !Pass.bCulled;
		Explained.Reason = Frame.Graph.DescribeCulled(Pass);
		Explained.Shader = Pass.Shader;
		Explained.Reads = NameResources(Frame.Graph, Pass, false);
		Explained.Writes = NameResources(Frame.Graph, Pass, true);
		Explained.Readers = NameReaders(Frame.Graph, Pass);
		if (Explained.bExecutes)
		{
			const double* Measured = FindMeasured(MeasuredFrame, Pass.Index);
			Explained.Milliseconds =
				Measured != nullptr ? *Measured : Model.EstimateMilliseconds(Frame.Graph, Pass, Conditions);
			Report.NumUnknown += Measured == nullptr && !Model.IsKnown(Pass, Conditions);
		}
		const auto Effect = std::find_if(Report.Effects.begin(), Report.Effects.end(),
			[&](const FExplainedEffect& Candidate) { return Candidate.Decision.GetName() == Explained.Effect; });
		if (Effect != Report.Effects.end())
		{
			Effect->NumPasses += Explained.bExecutes;
			Effect->NumCulled += !Explained.bExecutes;
			Effect->Milliseconds += Explained.Milliseconds;
			Effect->Megabytes += Explained.bExecutes ? GetMegabytesWritten(Frame.Graph, Pass) : 0.0;
		}
		Report.Passes.push_back(std::move(Explained));
	}
	return Report;
}

} // namespace Drydock
