// Runs the analysis of one entry, and puts what it found in order: messages, functions, variables, buffers.
#include "HlslAnalysisImpl.h"
#include "HlslUnset.h"

#include <algorithm>
#include <array>

namespace Drydock::Hlsl
{

namespace
{

constexpr size_t MaxOtherLines = 5;

/** "N::F(float3, int)". */
std::string MangleFunction(const FFunction& Function)
{
	std::string Result = Function.Name + "(";
	for (size_t i = Function.bMethod ? 1 : 0; i < Function.Parameters.size(); ++i)
	{
		Result += (Result.back() == '(' ? "" : ",") + GetName(Function.Parameters[i]->Type);
	}
	return Result + ")" + (Function.bMethod ? " of " + GetName(Function.Parameters[0]->Type) : "");
}

} // namespace

std::string_view KeepOperator(std::string_view Operator)
{
	static constexpr std::array<std::string_view, 36> All = {"+", "-", "*", "/", "%", "<<", ">>", "<", ">",
		"<=", ">=", "==", "!=", "&", "^", "|", "&&", "||", "!", "~", "++", "--",
		"+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|=", "=", ",", "()", "[]"};
	const auto Found = std::find(All.begin(), All.end(), Operator);
	return Found == All.end() ? std::string_view() : *Found;
}

uint64_t CountLeaves(const FType* Type)
{
	if (Type->IsNumeric())
	{
		return Type->NumComponents();
	}
	if (Type->IsArray())
	{
		return CountLeaves(Type->Element) * Type->Count;
	}
	if (Type->IsStruct())
	{
		return static_cast<const FStructInfo*>(Type->Struct->Scope)->NumLeaves;
	}
	return Type->IsObject() ? 1 : 0;
}

bool IsKnown(const FValue& Value)
{
	switch (Value.Kind)
	{
	case EValue::Constant:
		return true;
	case EValue::Variable:
		return Value.Variable->Constant.has_value();
	case EValue::Member:
	case EValue::Swizzle:
	case EValue::Elements:
	case EValue::Index:
	case EValue::Compose:
	case EValue::Cast:
		return CountLeaves(Value.Type) <= MaxLeaves / 16 && Value.Type->Kind != EType::Error &&
			   std::ranges::all_of(Value.Operands, [](const FValue* Each) { return IsKnown(*Each); });
	case EValue::Zero:
		return Value.Type->Kind != EType::Error && CountLeaves(Value.Type) <= MaxLeaves / 16 && !HasObject(Value.Type);
	default:
		return false;
	}
}

FAnalyser::FAnalyser(const FTree& InTree, const FAnalysisOptions& InOptions)
	: Tree(InTree)
	, Options(InOptions)
	, Types(std::make_shared<FTypes>(InOptions.bRealHalf))
	, Program(std::make_shared<FProgram>())
{
	Program->Stage = Options.Stage;
	Program->bFxcRules = Options.bFxcRules;
	Program->Types = Types.get();
	Program->Files = Tree.Files;
	File = MakeScope(EScopeKind::File, nullptr);
	Here.Scope = File;
}

FAnalysis FAnalyser::Run()
{
	EnterAll(Tree.Declarations, *File);
	EnterOutside();
	for (const auto& [Declaration, Scope] : Asserts)
	{
		FPosition Position;
		Position.Scope = Scope;
		Position.Order = NumDeclarations;
		const FPositionGuard Guard(*this, Position);
		CheckAssert(*Declaration);
	}
	AnalyseEntry();
	while (!Work.empty())
	{
		const auto [Function, Overload] = Work.back();
		Work.pop_back();
		AnalyseBody(*Function, *Overload);
	}
	AddUnusedLoose();
	OrderFunctions();
	WarnOfUnset();
	Finish();
	FAnalysis Analysis;
	Analysis.Errors = TakeMessages(ESeverity::Error);
	Analysis.Warnings = TakeMessages(ESeverity::Warning);
	Analysis.Types = Types;
	Analysis.Program = Analysis.Errors.empty() ? Program : nullptr;
	return Analysis;
}

void FAnalyser::AnalyseBody(FFunction& Function, FOverload& Overload)
{
	FPosition Position;
	Position.Scope = MakeScope(EScopeKind::Block, Overload.Scope);
	Position.Scope->Function = &Function;
	Position.Function = &Function;
	Position.Overload = &Overload;
	Position.Order = std::max(Overload.BodyOrder, Overload.Struct ? Overload.Struct->Order : 0u);
	Position.This = Function.bMethod ? Function.Parameters[0] : nullptr;
	Instance = Overload.Template ? Function.Name : std::string();
	const FPositionGuard Guard(*this, Position);
	for (size_t i = Function.bMethod ? 1 : 0; i < Function.Parameters.size(); ++i)
	{
		FVariable& Parameter = *Function.Parameters[i];
		if (!Parameter.Name.empty())
		{
			if (FSymbol* const Symbol = Add(*Here.Scope, Parameter.Name, ESymbol::Variable, Parameter.Place))
			{
				Symbol->Variable = &Parameter;
			}
		}
	}
	for (FVariable* Uniform : Program->Entry == &Function ? EntryUniforms : std::vector<FVariable*>())
	{
		if (FSymbol* const Symbol = Add(*Here.Scope, Uniform->Name, ESymbol::Variable, Uniform->Place))
		{
			Symbol->Variable = Uniform;
		}
	}
	Function.Body = MakeCode(EStep::Block, Overload.Declaration->Body->Place);
	const bool bGoesOn = AnalyseBlock(*Overload.Declaration->Body, Function.Body->Body, false);
	if (bGoesOn && Function.Result->Kind != EType::Void && Function.Result->Kind != EType::Error)
	{
		Error(Function.Place, "X3507: '" + Function.Name + "': not all control paths return a value (" +
								  GetName(Function.Result) + "); write a return at its end");
	}
	Instance.clear();
}

void FAnalyser::WarnOfUnset()
{
	for (const FFunction* Function : bFailed ? std::vector<FFunction*>() : Program->Functions)
	{
		for (const FUnset& Unset : FindUnset(*Function))
		{
			const std::string What = Unset.Variable->Name;
			Warn(Unset.Place,
				Unset.bOut ? "X3508: output parameter '" + What +
								 "' not completely initialized: not every way to the function's end sets " + Unset.Part
						   : "X4000: use of potentially uninitialized variable '" + What + "': " +
								 (!Unset.Variable->bWritten
										 ? "nothing sets it"
										 : "not every path to here sets " + (Unset.Part == What ? "it" : Unset.Part)));
		}
	}
}

void FAnalyser::Say(ESeverity Severity, const FPlace& Place, const std::string& Message, int Code)
{
	std::string Text = Message + (Instance.empty() ? "" : " (in " + Instance + ")");
	bFailed = bFailed || Severity == ESeverity::Error;
	const auto [Known, bNew] =
		MessageByText.emplace((Severity == ESeverity::Error ? "E" : "W") + Text, Messages.size());
	if (bNew)
	{
		Messages.push_back({Severity, Code, Place, std::move(Text), {}});
		return;
	}
	FMessage& Old = Messages[Known->second];
	std::vector<int>& Lines = Old.OtherLines;
	if (Place.Line != Old.Place.Line && std::ranges::find(Lines, Place.Line) == Lines.end())
	{
		Lines.push_back(Place.Line);
		if (Place.File == Old.Place.File && Place.Line < Old.Place.Line)
		{
			std::swap(Lines.back(), Old.Place.Line);
			Old.Place.Column = Place.Column;
		}
	}
}

void FAnalyser::Error(const FPlace& Place, const std::string& Message, int Code)
{
	Say(ESeverity::Error, Place, Message, Code);
}

void FAnalyser::Warn(const FPlace& Place, const std::string& Message)
{
	Say(ESeverity::Warning, Place, Message, 6010);
}

FValue* FAnalyser::Fail(const FPlace& Place, const std::string& Message)
{
	Error(Place, Message);
	return MakeError(Place);
}

std::vector<FDiagnostic> FAnalyser::TakeMessages(ESeverity Severity)
{
	std::vector<const FMessage*> Taken;
	for (const FMessage& Message : Messages)
	{
		if (Message.Severity == Severity)
		{
			Taken.push_back(&Message);
		}
	}
	std::ranges::stable_sort(Taken,
		[](const FMessage* A, const FMessage* B)
		{
			return std::tuple(A->Place.File, A->Place.Line, A->Place.Column) <
				   std::tuple(B->Place.File, B->Place.Line, B->Place.Column);
		});
	std::vector<FDiagnostic> Result;
	for (const FMessage* Message : Taken)
	{
		if (Result.size() == MaxMessages)
		{
			break;
		}
		std::vector<int> Lines = Message->OtherLines;
		std::ranges::sort(Lines);
		std::string Text = Message->Text;
		for (size_t i = 0; i < Lines.size() && i <= MaxOtherLines; ++i)
		{
			Text += i == 0 ? " (also in line " : ", ";
			Text += i == MaxOtherLines ? "..." : std::to_string(Lines[i]);
		}
		Text += Lines.empty() ? "" : ")";
		const bool bPlaced = Message->Place.Line > 0 && Message->Place.File < Tree.Files.size();
		Result.push_back(
			{Severity, Message->Code, Text, bPlaced ? Tree.Files[Message->Place.File] : Options.VirtualPath,
				bPlaced ? Message->Place.Line : 0, bPlaced ? Message->Place.Column : 0, {}});
	}
	return Result;
}

/** Functions behind those that they call. HLSL has no recursion. */
void FAnalyser::OrderFunctions()
{
	std::map<const FFunction*, int> State;
	for (const auto& [Callee, Place] : Calls[nullptr]) // of initializers
	{
		VisitCalls(Callee, State);
	}
	if (Program->Entry)
	{
		VisitCalls(Program->Entry, State);
	}
	for (FFunction* Function : Program->Functions)
	{
		Function->Mangled = MangleFunction(*Function);
	}
}

void FAnalyser::VisitCalls(FFunction* Root, std::map<const FFunction*, int>& State)
{
	std::vector<std::pair<FFunction*, size_t>> Stack;
	const auto Push = [&](FFunction* Function)
	{
		State[Function] = 1;
		Stack.emplace_back(Function, 0);
	};
	if (State[Root] == 0)
	{
		Push(Root);
	}
	while (!Stack.empty())
	{
		auto& [Function, Next] = Stack.back();
		const auto& Callees = Calls[Function];
		if (Next == Callees.size())
		{
			State[Function] = 2;
			Program->Functions.push_back(Function);
			Stack.pop_back();
			continue;
		}
		const auto& [Callee, Place] = Callees[Next++];
		if (State[Callee] == 1)
		{
			const auto First =
				std::ranges::find_if(Stack, [&Callee = Callee](const auto& Each) { return Each.first == Callee; });
			std::string Cycle;
			for (auto It = First; It != Stack.end(); ++It)
			{
				const bool bLast = It + 1 == Stack.end();
				Cycle += "'" + It->first->Name + "' calls '" + (bLast ? Callee : (It + 1)->first)->Name + "'" +
						 (bLast ? "" : ", ");
			}
			Error(Place,
				"X3500: functions of HLSL cannot call themselves, not even through others; write a loop: " + Cycle);
		}
		else if (State[Callee] == 0)
		{
			Push(Callee);
		}
	}
}

void FAnalyser::Finish()
{
	const auto ByOrder = [](const FMade& A, const FMade& B)
	{
		return A.Order < B.Order;
	};
	std::ranges::stable_sort(Statics, ByOrder);
	std::ranges::stable_sort(Resources, ByOrder);
	std::ranges::stable_sort(Loose, ByOrder);
	for (const FMade& Made : Statics)
	{
		Program->Statics.push_back(Made.Variable);
	}
	for (const FMade& Made : Resources)
	{
		Program->Resources.push_back(Made.Variable);
	}
	if (Global)
	{
		for (const FMade& Made : Loose)
		{
			Made.Variable->Index = uint32_t(Global->Members.size());
			Global->Members.push_back(Made.Variable);
		}
		LayOut(*Global);
		Program->Buffers.push_back(Global);
	}
	std::ranges::stable_sort(Buffers, [](const auto& A, const auto& B) { return A.first < B.first; });
	for (const auto& [Order, Buffer] : Buffers)
	{
		Program->Buffers.push_back(Buffer);
	}
}

void FAnalyser::LayOut(FBuffer& Buffer)
{
	FStructType Struct;
	for (const FVariable* Member : Buffer.Members)
	{
		if (Member->Type->Kind == EType::Error)
		{
			return;
		}
		FMember Each;
		Each.Name = Member->Name;
		Each.Type = Member->Type;
		Struct.Members.push_back(std::move(Each));
	}
	Buffer.Offsets = GetOffsets(*Types, Struct, ELayout::Constants);
	for (size_t i = 0; i < Buffer.Members.size(); ++i)
	{
		if (const auto Offset = Offsets.find(Buffer.Members[i]); Offset != Offsets.end())
		{
			Buffer.Offsets[i] = Offset->second;
		}
	}
}

FAnalysis Analyse(const FTree& Tree, const FAnalysisOptions& Options)
{
	return FAnalyser(Tree, Options).Run();
}

} // namespace Drydock::Hlsl
