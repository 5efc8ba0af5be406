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

template<typename T>
void WriteList(FJsonWriter& Writer, const char* Key, const T& Values)
{
	Writer.Key(Key).BeginArray(true);
	for (const auto& Value : Values)
	{
		Writer.Value(Value);
	}
	Writer.EndArray();
}

void WriteEvent(FJsonWriter& Writer, const FSpirvModule& Module, const FTraceEvent& Event)
{
	Writer.BeginObject(true);
	Writer.Member("event", GetEventName(Event.Kind));
	if (!Event.Name.empty())
	{
		Writer.Member("name", Event.Name);
	}
	if (Event.Value.Type)
	{
		Writer.Member("text", FormatTraceValue(Module, Event.Value));
		WriteList(Writer, "value", Event.Value.Reals);
	}
	if (!Event.Coordinates.empty())
	{
		WriteList(Writer, "coordinates", Event.Coordinates);
		Writer.Member("level", Event.Level);
	}
	if (!Event.Texel.empty())
	{
		WriteList(Writer, "texel", Event.Texel);
	}
	if (!Event.Texels.empty())
	{
		Writer.Key("texels").BeginArray(true);
		for (const FFootprintTexel& Texel : Event.Texels)
		{
			Writer.BeginObject(true);
			Writer.Member("mip", Texel.Mip);
			Writer.Member("x", Texel.X);
			Writer.Member("y", Texel.Y);
			Writer.Member("z", Texel.Z);
			Writer.Member("weight", Texel.Weight);
			WriteList(Writer, "value", Texel.Value);
			Writer.EndObject();
		}
		Writer.EndArray();
	}
	Writer.EndObject();
}

void WriteTrace(FJsonWriter& Writer, const FCapturedTrace& Trace)
{
	Writer.BeginObject();
	Writer.Member("pass", Trace.Pass);
	Writer.Member("shader", Trace.Shader);
	Writer.Member("entry", Trace.Entry);
	Writer.Member("variables", Trace.Inspected->HasVariables());
	Writer.Member("discarded", Trace.Float.bDiscarded);
	Writer.Member("taps", Trace.Float.Taps);
	Writer.Member("instructions", Trace.Float.Steps);
	Writer.Member("cut", Trace.Float.bCut);
	for (const auto& [Key, Targets] :
		{std::pair("targets", &Trace.Float.Targets), {"targetsDouble", &Trace.Double.Targets}})
	{
		Writer.Key(Key).BeginArray();
		for (const std::vector<double>& Target : *Targets)
		{
			Writer.BeginArray(true);
			for (const double Value : Target)
			{
				Writer.Value(Value);
			}
			Writer.EndArray();
		}
		Writer.EndArray();
	}
	if (Trace.Difference)
	{
		Writer.Key("partsFromDouble").BeginObject(true);
		Writer.Member("line", uint64_t(Trace.Difference->Line));
		Writer.Member("event", uint64_t(Trace.Difference->Event));
		Writer.Member("float", Trace.Difference->Float);
		Writer.Member("double", Trace.Difference->Double);
		Writer.Member("otherPath", Trace.Difference->bOtherPath);
		Writer.EndObject();
	}
	Writer.Key("lines").BeginArray();
	for (const FTraceLine& Line : Trace.Float.Lines)
	{
		Writer.BeginObject();
		Writer.Member("file", Line.File);
		Writer.Member("line", Line.Line);
		Writer.Member("function", Line.Function);
		Writer.Member("depth", uint64_t(Line.Depth));
		Writer.Member("source", Trace.Inspected->GetLine(Line.File, Line.Line));
		Writer.Key("events").BeginArray();
		for (const FTraceEvent& Event : Line.Events)
		{
			WriteEvent(Writer, Trace.Inspected->GetModule(), Event);
		}
		Writer.EndArray();
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
}

} // namespace

std::string MakeTraceJson(const std::vector<FCapturedTrace>& Traces, const FTraceRequest& Request)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	WriteList(Writer, "at", Request.At);
	Writer.Key("traces").BeginArray();
	for (const FCapturedTrace& Trace : Traces)
	{
		WriteTrace(Writer, Trace);
	}
	Writer.EndArray();
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
