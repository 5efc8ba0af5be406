// Listens to the calls of functions that print.
#include "PrintedLines.h"

#include "OperationText.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>

namespace Drydock
{

using namespace Spirv;

namespace
{

enum class EPrintCall : uint8_t
{
	None,
	Text,    // DrydockPrintText
	Value,   // DrydockPrintValue
	End,     // DrydockPrintEnd
	Print,   // of ShaderPrint.ush: a text or value
	Newline, // the same, with the line's end
};

/** The type of a parameter, or the type that it points to: the front end makes both. */
uint32_t GetParameterType(const FSpirvModule& Module, uint32_t Parameter)
{
	const uint32_t Type = Module.GetValueTypeId(Parameter);
	return Module.GetType(Type).Kind == ESpirvType::Pointer ? Module.GetType(Type).Element : Type;
}

EPrintCall FindPrintCall(const FSpirvModule& Module, const FSpirvFunction& Function)
{
	if (Function.Name == "DrydockPrintText")
	{
		return EPrintCall::Text;
	}
	if (Function.Name == "DrydockPrintValue")
	{
		return EPrintCall::Value;
	}
	if (Function.Name == "DrydockPrintEnd")
	{
		return EPrintCall::End;
	}
	const bool bContext =
		!Function.Parameters.empty() &&
		Module.GetType(GetParameterType(Module, Function.Parameters[0])).Name == "FShaderPrintContext";
	return bContext && Function.Name == "Print"                                        ? EPrintCall::Print
		   : bContext && (Function.Name == "Newline" || Function.Name == "PrintLineN") ? EPrintCall::Newline
																					   : EPrintCall::None;
}

std::vector<EPrintCall> FindPrintCalls(const FSpirvModule& Module)
{
	return ToVector<EPrintCall>(
		Module.Functions, [&](const FSpirvFunction& Function) { return FindPrintCall(Module, Function); });
}

std::string FormatNumber(double Number, ESpirvType Kind, char Conversion, int Precision)
{
	char Text[64];
	if (Kind == ESpirvType::Bool)
	{
		return Number != 0 ? "true" : "false";
	}
	if (Conversion == 'x' && !IsSpirvReal(Kind))
	{
		std::snprintf(Text, sizeof(Text), "%x", unsigned(int64_t(Number)));
		return Text;
	}
	if (Precision >= 0 && IsSpirvReal(Kind) && std::isfinite(Number))
	{
		std::snprintf(Text, sizeof(Text), Conversion == 'e' ? "%.*e" : "%.*f", std::min(Precision, 9), Number);
		return Text;
	}
	return FormatReal(Number);
}

std::string FormatValue(const FPrintedValue& Value, char Conversion, int Precision)
{
	std::string Text = JoinText(Value.Numbers, ", ",
		[&](const double Number) { return FormatNumber(Number, Value.Kind, Conversion, Precision); });
	return Value.Numbers.size() == 1 ? Text : "(" + Text + ")";
}

class FPrintWatcher final : public IThreadWatcher
{
public:
	FPrintWatcher(const FInspectedShader& InShader, const std::vector<EPrintCall>& InCalls)
		: Shader(InShader)
		, Module(InShader.GetModule())
		, Program(InShader.GetProgram())
		, Calls(InCalls)
	{
	}

	void OnCall(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const EPrintCall Call = Step.Function < Calls.size() ? Calls[Step.Function] : EPrintCall::None;
		switch (Call)
		{
		case EPrintCall::Text:
			Format += GetString(Thread.GetBits(GetWords(Thread, Step, 0)));
			break;
		case EPrintCall::Value:
			Values.push_back(GetValue(Thread, Step, 0));
			break;
		case EPrintCall::End:
			Add(Thread, *Step.I, FormatPrinted(Format, Values));
			Format.clear();
			Values.clear();
			break;
		case EPrintCall::Print:
		case EPrintCall::Newline:
			HearContext(Thread, Step, Call);
			break;
		case EPrintCall::None:
			break;
		}
	}

	void EndThread(size_t, TSpirvThread<float>& Thread) override
	{
		if (LastPrint)
		{
			Add(Thread, *LastPrint, Row); // nobody said Newline
		}
		LastPrint = nullptr;
		Row.clear();
		Format.clear();
		Values.clear();
	}

	FPrintedLines Printed;

private:
	/** A call of ShaderPrint.ush; its first parameter is the context, whose first number says whether it prints. */
	void HearContext(const FSpirvThreadView& Thread, const FSpirvStep& Step, EPrintCall Call)
	{
		if (!Thread.GetBits(GetWords(Thread, Step, 0)))
		{
			return;
		}
		const std::vector<uint32_t>& Parameters = Module.Functions[Step.Function].Parameters;
		if (Parameters.size() > 1)
		{
			const uint32_t Type = GetParameterType(Module, Parameters[1]);
			Row += Module.GetType(Type).Name == "FShaderPrintText"
					   ? GetString(Thread.GetBits(GetWords(Thread, Step, 1)))
					   : FormatValue(GetValue(Thread, Step, 1), 'f', -1) + " ";
		}
		LastPrint = Step.I;
		if (Call == EPrintCall::Newline)
		{
			Add(Thread, *Step.I, Row);
			Row.clear();
			LastPrint = nullptr;
		}
	}

	uint32_t GetWords(const FSpirvThreadView& Thread, const FSpirvStep& Step, size_t Parameter) const
	{
		const uint32_t Word = Program.Functions[Step.Function].Parameters[Parameter];
		const FSpirvType& Type = Module.GetValueType(Module.Functions[Step.Function].Parameters[Parameter]);
		return Type.Kind == ESpirvType::Pointer ? Thread.GetBits(Word) : Word;
	}

	FPrintedValue GetValue(const FSpirvThreadView& Thread, const FSpirvStep& Step, size_t Parameter) const
	{
		const uint32_t Type = GetParameterType(Module, Module.Functions[Step.Function].Parameters[Parameter]);
		const uint32_t First = GetWords(Thread, Step, Parameter);
		FPrintedValue Value;
		const uint32_t Size = Module.GetType(Type).NumScalars;
		for (uint32_t i = 0; i < Size; ++i)
		{
			Value.Kind = Module.GetScalarKind(Type, i);
			Value.Numbers.push_back(Thread.GetNumber(First + i, Value.Kind));
		}
		return Value;
	}

	std::string GetString(uint32_t Index) const
	{
		return Index < Shader.GetStrings().size() ? Shader.GetStrings()[Index] : std::string();
	}

	void Add(const FSpirvThreadView& Thread, const FSpirvInstruction& I, const std::string& Text)
	{
		if (Printed.Lines.size() >= MaxPrintedLines)
		{
			++Printed.NumMore;
			return;
		}
		const int32_t* const At = Thread.GetPosition();
		Printed.Lines.push_back({{At[0], At[1], At[2]}, Module.Files.at(I.File), I.Line, Text});
	}

	const FInspectedShader& Shader;
	const FSpirvModule& Module;
	const FSpirvProgram& Program;
	const std::vector<EPrintCall>& Calls; // by function
	std::string Format;                   // of the DrydockPrint that is being called
	std::vector<FPrintedValue> Values;
	std::string Row; // of ShaderPrint, up to Newline
	const FSpirvInstruction* LastPrint = nullptr;
};

} // namespace

bool DoesPrint(const FInspectedShader& Shader)
{
	const std::vector<EPrintCall> Calls = FindPrintCalls(Shader.GetModule());
	const std::vector<FSpirvStep>& Steps = Shader.GetProgram().Steps;
	return std::any_of(Steps.begin(), Steps.end(),
		[&Calls](const FSpirvStep& Step) {
			return Step.I->Op == OpFunctionCall && Step.Function < Calls.size() &&
				   Calls[Step.Function] != EPrintCall::None;
		});
}

FPrintedLines CollectPrints(FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args,
	std::vector<std::array<int32_t, 3>> Threads)
{
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		Step.bHook = false;
	}
	const std::vector<EPrintCall> Calls = FindPrintCalls(Shader.GetModule());
	const FThreadRuns Runs(Shader, Bound, Args, std::move(Threads));
	std::deque<FPrintWatcher> Watchers;
	for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
	{
		Watchers.emplace_back(Shader, Calls);
	}
	Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Watchers[Piece]; });
	FPrintedLines All;
	for (FPrintWatcher& Watcher : Watchers)
	{
		std::vector<FPrintedLine>& Lines = Watcher.Printed.Lines;
		const size_t Kept = std::min(Lines.size(), MaxPrintedLines - All.Lines.size());
		All.Lines.insert(All.Lines.end(), Lines.begin(), Lines.begin() + std::ptrdiff_t(Kept));
		All.NumMore += Watcher.Printed.NumMore + (Lines.size() - Kept);
	}
	return All;
}

std::string FormatPrinted(const std::string& Format, const std::vector<FPrintedValue>& Values)
{
	std::string Text;
	size_t Next = 0;
	for (size_t At = 0; At < Format.size(); ++At)
	{
		if (Format[At] != '%')
		{
			Text += Format[At];
			continue;
		}
		const size_t Conversion = Format.find_first_not_of("0123456789.+- #", At + 1);
		if (Conversion == std::string::npos || Format[Conversion] == '%' || Next >= Values.size())
		{
			Text += '%';
			At = Conversion == At + 1 && Format[Conversion] == '%' ? Conversion : At;
			continue;
		}
		const size_t Point = Format.find('.', At);
		const int Precision = Point < Conversion ? std::atoi(Format.c_str() + Point + 1) : -1;
		Text += FormatValue(Values[Next++], Format[Conversion], Precision);
		At = Conversion;
	}
	for (; Next < Values.size(); ++Next)
	{
		Text += (Text.empty() ? "" : " ") + FormatValue(Values[Next], 'f', -1);
	}
	return Text;
}

} // namespace Drydock
