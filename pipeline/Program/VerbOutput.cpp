// What verbs say to a person. Source: drydock.
#include "Program/ProgressBar.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace Drydock
{

namespace
{

std::string FormatMegabytes(uint64_t Bytes)
{
	return Format("%.1f MB", static_cast<double>(Bytes) / 1e6);
}

const char* GetColor(ESeverity Severity)
{
	switch (Severity)
	{
	case ESeverity::Error:
		return "\x1b[31m";
	case ESeverity::Warning:
		return "\x1b[33m";
	case ESeverity::Note:
		break;
	}
	return "\x1b[36m";
}

/** Where the time went, as a bar of at most ten characters. */
std::string MakeBar(double Part, double Largest)
{
	const int Length = Largest > 0.0 ? static_cast<int>(Part / Largest * 10.0 + 0.5) : 0;
	return std::string(static_cast<size_t>(std::clamp(Length, 0, 10)), '#');
}

std::string FormatPasses(const FRunResult& Result)
{
	size_t NameWidth = 4;
	double Largest = 0.0;
	for (const FRunPass& Pass : Result.Passes)
	{
		NameWidth = std::max(NameWidth, Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name.size());
		Largest = std::max(Largest, Pass.Milliseconds);
	}
	std::string Text;
	for (const FRunPass& Pass : Result.Passes)
	{
		Text += PadLeft(std::to_string(Pass.Index), 5) + "  " +
				PadRight(Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name, NameWidth) +
				PadLeft(Format("%.2f", Pass.Milliseconds), 9) + " ms  " + MakeBar(Pass.Milliseconds, Largest) + "\n";
	}
	return Text;
}

} // namespace

void PrintDiagnostics(const std::vector<FDiagnostic>& Diagnostics)
{
	const bool bColorful = IsColorful(STDERR_FILENO);
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		std::fprintf(stderr, "%s%s%s\n", bColorful ? GetColor(Diagnostic.Severity) : "", Diagnostic.ToString().c_str(),
			bColorful ? "\x1b[0m" : "");
	}
}

std::vector<std::string> MakeClosingLines(const std::vector<FEffectDecision>& Effects)
{
	std::vector<std::string> Lines;
	for (const FEffectDecision& Effect : Effects)
	{
		if (Effect.bConfigured && !Effect.bActive)
		{
			Lines.push_back(Effect.GetName() + ": " + Effect.Reason);
		}
	}
	return Lines;
}

std::string MakeRunSummary(const FRunResult& Result, const std::string& Folder, double SaveMs)
{
	const auto IsReal = [](const FRDGCompiledPass& Pass)
	{
		return !Pass.bIsSentinel;
	};
	const auto NumPasses = std::count_if(Result.Graph.Passes.begin(), Result.Graph.Passes.end(), IsReal);
	const auto NumDecoded = std::count_if(
		Result.Channels.begin(), Result.Channels.end(), [](const FSceneChannel& Channel) { return Channel.bDecoded; });
	const std::string Size = std::to_string(Result.ViewRect.Width()) + " x " + std::to_string(Result.ViewRect.Height());

	std::string Text = Result.Config.File + ": " + Size + ", " + Result.Precision + " arithmetic, " + Result.Storage +
					   " storage, " + std::to_string(Result.Threads) +
					   (Result.Threads == 1 ? " thread\n" : " threads\n");
	Text += FormatPasses(Result);
	Text += "passes   " + std::to_string(Result.Passes.size()) + " of " + std::to_string(NumPasses) + " ran in " +
			Format("%.1f ms", Result.Times.Execute) + ", " +
			std::to_string(NumPasses - static_cast<long>(Result.Passes.size())) + " culled\n";
	Text += "scene    " + std::to_string(NumDecoded) + " of " + std::to_string(Result.Channels.size()) +
			" channels decoded in " + Format("%.1f ms", Result.Times.Load) + "\n";
	Text += "memory   " + FormatMegabytes(Result.Graph.Memory.TransientPeakBytes) + " transient, " +
			FormatMegabytes(Result.Graph.Memory.WithoutAliasingBytes) + " without aliasing\n";
	Text += "picture  " + Folder + "/final.png (written in " + Format("%.1f ms", SaveMs) + ")\n";
	return Text;
}

} // namespace Drydock
