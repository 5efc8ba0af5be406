// Writes traces for programs: everything that the text has, and every round of every loop.
#include "Inspect/TraceCapture.h"

#include "Text/JsonWriter.h"

namespace Drydock
{

namespace
{

const char* GetEventName(ETraceEvent Kind)
{
	constexpr const char* Names[] = {"value", "sample", "load", "store", "branch", "call", "return", "fault"};
	return Names[size_t(Kind)];
}

void WriteEvent(FJsonWriter& Writer, const FSpirvModule& Module, const FTraceEvent& Event)
{
	Writer.BeginObject(true);
	Writer.Member("event", GetEventName(Event.Kind));
	Writer.MemberIfAny("name", Event.Name);
	if (Event.Value.Type)
	{
		Writer.Members({{"text", FormatTraceValue(Module, Event.Value)}, {"value", Event.Value.Reals}});
	}
	if (!Event.Coordinates.empty())
	{
		Writer.Members({{"coordinates", Event.Coordinates}, {"level", Event.Level}});
	}
	Writer.MemberIfAny("texel", Event.Texel);
	if (Event.WriterLine)
	{
		Writer.Members({{"writer", Event.Writer}, {"writerLine", Event.WriterLine}});
	}
	if (!Event.Texels.empty())
	{
		Writer.Key("texels").BeginArray(true);
		for (const FFootprintTexel& Texel : Event.Texels)
		{
			Writer.Object({{"mip", Texel.Mip}, {"x", Texel.X}, {"y", Texel.Y}, {"z", Texel.Z}, {"weight", Texel.Weight},
				{"value", Texel.Value}});
		}
		Writer.EndArray();
	}
	Writer.EndObject();
}

void WriteTrace(FJsonWriter& Writer, const FCapturedTrace& Trace)
{
	Writer.BeginObject();
	Writer.Members({{"pass", Trace.Pass}, {"shader", Trace.Shader}, {"entry", Trace.Entry}, {"thread", Trace.Thread},
		{"storedTo", Trace.Stored}, {"variables", Trace.Inspected->HasVariables()},
		{"discarded", Trace.Float.bDiscarded}, {"taps", Trace.Float.Taps}, {"instructions", Trace.Float.Steps},
		{"cut", Trace.Float.bCut}});
	for (const auto& [Key, Targets] :
		{std::pair("targets", &Trace.Float.Targets), {"targetsDouble", &Trace.Double.Targets}})
	{
		Writer.Array(Key, *Targets, [&](const std::vector<double>& Target) { Writer.Value(Target); });
	}
	if (Trace.Difference)
	{
		Writer.Key("partsFromDouble")
			.Object({{"line", uint64_t(Trace.Difference->Line)}, {"event", uint64_t(Trace.Difference->Event)},
				{"float", Trace.Difference->Float}, {"double", Trace.Difference->Double},
				{"otherPath", Trace.Difference->bOtherPath}});
	}
	Writer.Array("lines", Trace.Float.Lines,
		[&](const FTraceLine& Line)
		{
			Writer.BeginObject();
			Writer.Members({{"file", Line.File}, {"line", Line.Line}, {"function", Line.Function},
				{"depth", uint64_t(Line.Depth)}, {"source", Trace.Inspected->GetLine(Line.File, Line.Line)}});
			Writer.Array("events", Line.Events,
				[&](const FTraceEvent& Event) { WriteEvent(Writer, Trace.Inspected->GetModule(), Event); });
			Writer.EndObject();
		});
	Writer.EndObject();
}

} // namespace

std::string MakeTraceJson(const std::vector<FCapturedTrace>& Traces, const FTraceRequest& Request)
{
	FJsonWriter Writer('{');
	Writer.Member("at", Request.At);
	Writer.Array("traces", Traces, [&](const FCapturedTrace& Trace) { WriteTrace(Writer, Trace); });
	return Writer.GetText();
}

} // namespace Drydock
