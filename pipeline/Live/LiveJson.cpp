// Writes messages and frames.
#include "Live/LiveJson.h"

#include "Run/RunResult.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <iterator>

namespace Drydock
{

namespace
{

void WriteMessageList(FJsonWriter& Writer, const std::vector<FDiagnostic>& Messages)
{
	Writer.Objects("messages", Messages,
		[&](const FDiagnostic& Message)
		{
			Writer.Members({{"severity", Message.Severity == ESeverity::Error     ? "error"
										 : Message.Severity == ESeverity::Warning ? "warning"
																				  : "note"},
				{"code", FormatCode(Message.Code)}, {"message", Message.Message}, {"where", Message.Where},
				{"file", Message.File}, {"line", Message.Line}});
		});
}

} // namespace

std::string MakeMessagesJson(const std::vector<FDiagnostic>& Messages)
{
	FJsonWriter Writer('{');
	WriteMessageList(Writer, Messages);
	return Writer.GetText();
}

std::string MakeFaultJson(uint64_t Revision, std::vector<FDiagnostic> Messages)
{
	std::stable_partition(Messages.begin(), Messages.end(),
		[](const FDiagnostic& Message) { return Message.Severity == ESeverity::Error; });
	FJsonWriter Writer('{');
	Writer.Member("revision", Revision);
	WriteMessageList(Writer, Messages);
	return Writer.GetText();
}

std::string MakeFrameJson(uint64_t Revision, const FRunResult& Result, double WholeMs)
{
	FJsonWriter Writer('{');
	Writer.Members({{"revision", Revision}, {"width", Result.Final.Width}, {"height", Result.Final.Height}});
	Writer.Key("milliseconds")
		.Object({{"passes", Result.Times.Execute}, {"setup", Result.Times.Setup}, {"load", Result.Times.Load},
			{"compile", Result.Times.Compile}, {"report", Result.Times.Report}, {"whole", WholeMs}});
	const auto NumReused = std::ranges::count_if(Result.Passes, &FRunPass::IsReused);
	Writer.Members({{"passesRun", static_cast<uint64_t>(std::ssize(Result.Passes) - NumReused)},
		{"passesReused", static_cast<uint64_t>(NumReused)}});
	Writer.Objects("passes", Result.Passes,
		[&](const FRunPass& Pass)
		{
			Writer.Members({{"index", Pass.Index}, {"name", Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name},
				{"ms", Pass.Milliseconds}, {"reused", Pass.IsReused()}});
		});
	WriteMessageList(Writer, Result.Diagnostics);
	Writer.Objects("effects", Result.Effects,
		[&](const FEffectDecision& Decision) {
			Writer.Members({{"name", Decision.GetName()}, {"active", Decision.bActive}, {"reason", Decision.Reason}});
		});
	return Writer.GetText();
}

} // namespace Drydock
