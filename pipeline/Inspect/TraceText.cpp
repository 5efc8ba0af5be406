// Writes a trace for a person: each line of the source as it stands, below it what it did.
#include "Inspect/TraceCapture.h"

#include "OperationText.h"
#include "Text/Fmt.inl"
#include "TextTools.h"

namespace Drydock
{

namespace
{

/** Rounds of a loop that are written out; of more only the first ones and how many there were. */
constexpr size_t MaxRounds = 4;
constexpr size_t MaxTracedTexels = 8;

std::string FormatScalar(const FSpirvModule& Module, uint32_t Type, const FTraceValue& Value, size_t Word)
{
	switch (Module.GetScalarKind(Type, 0))
	{
	case ESpirvType::Bool:
		return Value.Bits[Word] ? "true" : "false";
	case ESpirvType::Float:
		return FormatReal(Value.Reals[Word]);
	default:
		return fmt::format("{}", int64_t(Value.Reals[Word]));
	}
}

std::string Format(const FSpirvModule& Module, uint32_t TypeId, const FTraceValue& Value, size_t& Word)
{
	const FSpirvType& Type = Module.GetType(TypeId);
	std::string Text;
	switch (Type.Kind)
	{
	case ESpirvType::Vector:
	case ESpirvType::Matrix:
	case ESpirvType::Array:
		for (uint32_t i = 0; i < Type.Count; ++i)
		{
			Text += (i ? ", " : "") + Format(Module, Type.Element, Value, Word);
		}
		return Type.Kind == ESpirvType::Vector ? "(" + Text + ")" : "[" + Text + "]";
	case ESpirvType::Struct:
		for (const FSpirvMember& Member : Type.Members)
		{
			Text += (Text.empty() ? "" : ", ") + Member.Name + ": " + Format(Module, Member.Type, Value, Word);
		}
		return "{ " + Text + " }";
	default:
		return FormatScalar(Module, TypeId, Value, Word++);
	}
}

std::string FormatList(const std::vector<double>& Values)
{
	return JoinText(Values, ", ", [&](const double Value) { return FormatReal(Value); });
}

std::string FormatTexels(const FTraceEvent& Event)
{
	std::string Text;
	size_t Count = 0;
	for (const FFootprintTexel& Texel : Event.Texels)
	{
		if (++Count > MaxTracedTexels)
		{
			return Text + fmt::format(" + {} more", Event.Texels.size() - MaxTracedTexels);
		}
		const std::string At = Texel.X < 0 ? "border" : fmt::format("{},{}", Texel.X, Texel.Y);
		Text += (Text.empty() ? "" : " + ") +
				(Texel.Weight == 1 ? At : fmt::format("{} of {}", FormatReal(Texel.Weight), At));
	}
	return Text;
}

std::string DescribeEvent(const FSpirvModule& Module, const FTraceEvent& Event)
{
	const std::string Value = Event.Value.Type ? FormatTraceValue(Module, Event.Value) : std::string();
	switch (Event.Kind)
	{
	case ETraceEvent::Sample:
		return fmt::format("sample {} at ({}){} = {}{}", Event.Name, FormatList(Event.Coordinates),
			Event.Level != 0 ? ", level " + FormatReal(Event.Level) : "", Value,
			Event.Texels.empty() ? "" : "   [" + FormatTexels(Event) + "]");
	case ETraceEvent::Load:
	case ETraceEvent::Store:
	{
		std::string At = JoinText(Event.Texel, ", ", [&](const int64_t Index) { return std::to_string(Index); });
		const std::string Put =
			Event.WriterLine
				? fmt::format("   [put there by thread {},{}{} in line {}]", Event.Writer[0], Event.Writer[1],
					  Event.Writer[2] ? fmt::format(",{}", Event.Writer[2]) : "", Event.WriterLine)
			: Event.bShared ? std::string("   [which no thread wrote]")
							: std::string();
		return fmt::format("{} {}{} = {}{}", Event.Kind == ETraceEvent::Load ? "load" : "store", Event.Name,
			At.empty() ? At : "[" + At + "]", Value, Put);
	}
	case ETraceEvent::Branch:
		return "branch: " + Value;
	case ETraceEvent::Call:
		return "call " + Event.Name;
	case ETraceEvent::Return:
		return Event.Name + " returns " + Value;
	case ETraceEvent::Fault:
		return "! " + Event.Name;
	default:
		return Event.Name + " = " + Value;
	}
}

} // namespace

std::string FormatTraceValue(const FSpirvModule& Module, const FTraceValue& Value)
{
	size_t Word = 0;
	return Format(Module, Value.Type, Value, Word);
}

std::string MakeTraceText(const FCapturedTrace& Trace, const FTraceRequest& Request)
{
	const FSpirvModule& Module = Trace.Inspected->GetModule();
	std::string Text = fmt::format("pass {} ({}, {}), {} {},{}{}{}\n", Trace.Pass, Trace.Shader, Trace.Entry,
		Trace.Written.empty() ? "thread" : "pixel", Trace.Thread[0], Trace.Thread[1],
		Trace.Thread[2] ? fmt::format(",{}", Trace.Thread[2]) : "",
		Trace.Stored.empty() ? ""
							 : fmt::format(", which stored to {} {},{}", Trace.Stored, Request.At[0], Request.At[1]));
	if (!Trace.Inspected->HasVariables())
	{
		Text += "(the shader keeps textures in structs or arrays: its calls are inlined and its variables are gone)\n";
	}
	std::string File;
	std::map<std::pair<std::string, int>, size_t> Rounds;
	size_t Skipped = 0;
	for (size_t Index = 0; Index < Trace.Float.Lines.size(); ++Index)
	{
		const FTraceLine& Line = Trace.Float.Lines[Index];
		const bool bDifference = Trace.Difference && Trace.Difference->Line == Index;
		if (++Rounds[{Line.File, Line.Line}] > MaxRounds && !bDifference)
		{
			++Skipped;
			continue;
		}
		if (Skipped)
		{
			Text += fmt::format("        ... {} lines of further rounds\n", std::exchange(Skipped, 0));
		}
		if (Line.File != File)
		{
			File = Line.File;
			Text += File + "\n";
		}
		std::string Source = Trace.Inspected->GetLine(Line.File, Line.Line);
		Source.erase(0, std::min(Source.find_first_not_of(" \t"), Source.size()));
		const std::string Indent(2 * (Line.Depth ? Line.Depth - 1 : 0), ' ');
		Text += fmt::format("{:5}   {}{}\n", Line.Line, Indent, Source);
		for (const FTraceEvent& Event : Line.Events)
		{
			Text += fmt::format("          {}{}\n", Indent, DescribeEvent(Module, Event));
		}
		if (bDifference)
		{
			Text += Trace.Difference->bOtherPath
						? "          < from here on double runs other lines than float\n"
						: fmt::format("          < float and double part: {} against {}\n",
							  FormatReal(Trace.Difference->Float), FormatReal(Trace.Difference->Double));
		}
	}
	if (Skipped)
	{
		Text += fmt::format("        ... {} lines of further rounds\n", Skipped);
	}
	Text += Trace.Float.bCut ? "(cut: there was more)\n" : "";
	if (Trace.Float.bDiscarded)
	{
		Text += "discarded\n";
	}
	for (size_t Target = 0; Target < Trace.Float.Targets.size(); ++Target)
	{
		Text += fmt::format("SV_Target{} = ({})", Target, FormatList(Trace.Float.Targets[Target]));
		if (Target < Trace.Double.Targets.size())
		{
			Text += fmt::format(", in double ({})", FormatList(Trace.Double.Targets[Target]));
		}
		if (Target < Trace.Written.size())
		{
			const std::array<double, 4>& Written = Trace.Written[Target];
			Text += fmt::format(", stored ({})", FormatList({Written.begin(), Written.end()}));
		}
		Text += "\n";
	}
	return Text + fmt::format("{} texture reads, {} instructions\n", Trace.Float.Taps, Trace.Float.Steps);
}

} // namespace Drydock
