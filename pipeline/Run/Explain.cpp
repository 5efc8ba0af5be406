// Puts a frame beside the same frame with nothing skipped.
#include "Run/Explain.h"

#include "RangeTools.h"
#include "Run/SilentPass.h"

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
	const auto* const Found =
		Measured != nullptr ? FindItem(*Measured, Index, &FMeasuredPasses::value_type::first) : nullptr;
	return Found != nullptr ? &Found->second : nullptr;
}

FExplainedCost MakeCost(const FRunResult& Result, const FCostModel& Model, const FMeasuredPasses* Measured)
{
	FExplainedCost Cost;
	Cost.TransientBytes = Result.Graph.Memory.TransientPeakBytes;
	Cost.SceneBytes = Result.SceneTextureBytes;
	Cost.NumChannels = static_cast<int>(
		std::ranges::count_if(Result.Channels, [](const FSceneChannel& Channel) { return Channel.bDecoded; }));
	const std::string Conditions = MakeCostConditions(Result);
	for (const FRDGCompiledPass& Pass : Result.Graph.Passes)
	{
		if (IsReal(Pass) && !Pass.bCulled)
		{
			const double* Milliseconds = FindMeasured(Measured, Pass.Index);
			++Cost.NumPasses;
			Cost.Texels += CountWrittenTexels(Result.Graph, Pass);
			Cost.Milliseconds +=
				Milliseconds != nullptr ? *Milliseconds : Model.EstimateMilliseconds(Result.Graph, Pass, Conditions);
		}
	}
	for (const FRunPass& Pass : Result.Passes)
	{
		Cost.Taps = Cost.Taps && Pass.Taps ? std::optional(*Cost.Taps + *Pass.Taps) : std::nullopt;
		Cost.BytesMoved += Pass.Counters.BytesRead + Pass.Counters.BytesWritten;
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
		if (bWanted)
		{
			AddUnique(Names, Name);
		}
	}
	return Names;
}

std::vector<std::string> NameReaders(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass)
{
	std::vector<std::string> Names;
	for (const FRDGCompiledPass& Other : Graph.Passes)
	{
		const bool bReads = Contains(Other.Producers, Pass.Index);
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

/** "plugin libTint.so"; empty: drydock's own. */
std::string NamePlugin(const FRDGCompiledPass& Pass)
{
	return Pass.Owner.substr(0, Pass.Owner.find(','));
}

/** Adds a pass to the row of its effect or plugin. */
template<typename TRow>
void AddToRow(const FExplainedPass& Pass, double Megabytes, TRow& Row)
{
	Row.NumPasses += Pass.bExecutes;
	Row.NumCulled += !Pass.bExecutes;
	Row.Milliseconds += Pass.Milliseconds;
	Row.Megabytes += Pass.bExecutes ? Megabytes : 0.0;
}

FExplainedPlugin& FindPlugin(FExplainReport& Report, const std::string& Name)
{
	const auto Known = std::ranges::find(Report.Plugins, Name, &FExplainedPlugin::Name);
	return Known != Report.Plugins.end() ? *Known : Report.Plugins.emplace_back(FExplainedPlugin{Name});
}

/** Adds more facts on a pass: values of its parameters, render pass, whether it did anything. */
void AddDetails(const FRunResult& Frame, const FRDGCompiledPass& Pass, FExplainedPass& Explained)
{
	const auto Values = Frame.PassValues.find(Pass.Index);
	Explained.Values = Values == Frame.PassValues.end() ? std::vector<FPassValue>() : Values->second;
	Explained.MergeReason = Pass.MergeReason;
	if (Pass.RenderPassBegin >= 0 && Pass.RenderPassBegin != Pass.Index)
	{
		Explained.MergedInto = Frame.Graph.Passes[static_cast<size_t>(Pass.RenderPassBegin)].Name;
	}
	const auto Run = std::ranges::find(Frame.Passes, Pass.Index, &FRunPass::Index);
	if (Run != Frame.Passes.end() && !Run->SameAs.empty())
	{
		Explained.Silent = DescribeSilentPass({Run->SameAs, Run->SameBecause});
	}
}

} // namespace

FMeasuredSaving MakeMeasuredSaving(std::vector<double> Samples)
{
	std::ranges::sort(Samples);
	return {Samples.front(), Samples[Samples.size() / 2], Samples.back(), static_cast<int>(Samples.size())};
}

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
		Explained.Effect = Pass.Owner.empty() ? Pass.Effect : NamePlugin(Pass);
		Explained.bExecutes = !Pass.bCulled;
		Explained.Reason = Frame.Graph.DescribeCulled(Pass);
		Explained.Shader = Pass.Shader;
		Explained.RunsAs = Pass.RunsAs;
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
		AddDetails(Frame, Pass, Explained);
		const double Megabytes = GetMegabytesWritten(Frame.Graph, Pass);
		const auto Effect = std::ranges::find_if(Report.Effects,
			[&](const FExplainedEffect& Candidate) { return Candidate.Decision.GetName() == Explained.Effect; });
		if (!Pass.Owner.empty())
		{
			AddToRow(Explained, Megabytes, FindPlugin(Report, Explained.Effect));
		}
		else if (Effect != Report.Effects.end())
		{
			AddToRow(Explained, Megabytes, *Effect);
		}
		Report.Passes.push_back(std::move(Explained));
	}
	return Report;
}

} // namespace Drydock
