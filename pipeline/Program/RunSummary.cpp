// Puts into words what a run did: passes with bars of their times, channels, memory.
#include "Program/RunSummary.h"

#include "Math/ToInteger.h"
#include "Run/Run.h"
#include "Text/Fmt.inl"
#include "Text/TextTable.h"

#include <algorithm>

namespace Drydock
{

namespace
{

std::string FormatMegabytes(uint64_t Bytes)
{
	return fmt::format("{:.1f} MB", static_cast<double>(Bytes) / 1e6);
}

/** A share of the time, as a bar of at most ten characters. */
std::string MakeBar(double Part, double Largest)
{
	const int Length = Largest > 0.0 ? ToCount(Part / Largest * 10.0 + 0.5, 0, 10) : 0;
	return std::string(static_cast<size_t>(Length), '#');
}

/** Taps of a pixel or thread; empty if the pass reads no texture; "? taps" if they are unknown. */
std::string FormatTaps(const FRunPass& Pass)
{
	if (!Pass.Taps || *Pass.Taps == 0 || Pass.Counters.Pixels == 0)
	{
		return Pass.Taps ? "" : "? taps";
	}
	const double PerPixel = static_cast<double>(*Pass.Taps) / static_cast<double>(Pass.Counters.Pixels);
	return PerPixel < 100.0 ? fmt::format("{:.3g} taps", PerPixel) : fmt::format("{:.0f} taps", PerPixel);
}

std::string FormatPasses(const FRunResult& Result, int Width)
{
	double Largest = 0.0;
	for (const FRunPass& Pass : Result.Passes)
	{
		Largest = std::max(Largest, Pass.Milliseconds);
	}
	FTextTable Table{
		{{ETextColumn::Number}, {ETextColumn::Name}, {ETextColumn::Number}, {ETextColumn::Number}, {ETextColumn::Text}},
		{}};
	for (const FRunPass& Pass : Result.Passes)
	{
		Table.Rows.push_back({std::to_string(Pass.Index), Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name,
			FormatTaps(Pass), fmt::format("{:.2f} ms", Pass.Milliseconds), MakeBar(Pass.Milliseconds, Largest)});
	}
	return Table.Format(Width, "  ");
}

} // namespace

std::string MakeRunSummary(
	const FRunResult& Result, const std::string& Folder, double SaveMs, std::optional<double> PageMs, int Width)
{
	const auto IsReal = [](const FRDGCompiledPass& Pass)
	{
		return !Pass.bIsSentinel;
	};
	const auto NumPasses = std::count_if(Result.Graph.Passes.begin(), Result.Graph.Passes.end(), IsReal);
	const auto NumDecoded = std::count_if(
		Result.Channels.begin(), Result.Channels.end(), [](const FSceneChannel& Channel) { return Channel.bDecoded; });
	const long NumRun = static_cast<long>(Result.Passes.size());
	std::string Text = fmt::format("{}: {} x {}, {} arithmetic, {} storage, {} {}\n", Result.Config.File,
		Result.ViewRect.Width(), Result.ViewRect.Height(), Result.Precision, Result.Storage, Result.Threads,
		Result.Threads == 1 ? "thread" : "threads");
	if (!Result.Device.empty())
	{
		Text += fmt::format("  shaders on {}, hand-written kernels on the CPU\n", Result.Device);
	}
	Text += FormatPasses(Result, Width);
	const auto NumReused = std::ranges::count_if(Result.Passes, &FRunPass::IsReused);
	Text += fmt::format("passes   {} of {} ran in {:.1f} ms, {} culled{}\n", NumRun, NumPasses, Result.Times.Execute,
		NumPasses - NumRun, NumReused > 0 ? fmt::format(", {} taken from the last frame", NumReused) : std::string());
	Text += fmt::format(
		"scene    {} of {} channels decoded in {:.1f} ms\n", NumDecoded, Result.Channels.size(), Result.Times.Load);
	Text += fmt::format("memory   {} transient, {} without aliasing\n",
		FormatMegabytes(Result.Graph.Memory.TransientPeakBytes),
		FormatMegabytes(Result.Graph.Memory.WithoutAliasingBytes));
	const FRunTimes& Times = Result.Times;
	Text += fmt::format(
		"time     {:.0f} ms: start {:.0f}, setup {:.0f}, load {:.0f}, compile {:.0f}, passes {:.0f}, report {:.0f}, "
		"save {:.0f}{}\n",
		Times.GetSum() + SaveMs + PageMs.value_or(0.0), Times.Start, Times.Setup, Times.Load, Times.Compile,
		Times.Execute, Times.Report, SaveMs, PageMs ? fmt::format(", page {:.0f}", *PageMs) : std::string());
	const bool bPng = Result.Write.count(EOutputKind::Png) > 0;
	return Text + fmt::format("picture  {}{}\n", Folder, bPng ? "/final.png" : "");
}

} // namespace Drydock
