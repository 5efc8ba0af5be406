// Statements: blocks, conditions, loops, returns, and whether control can go on behind them.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr size_t MaxJoinedStatements = 4096;

/** Whether a value without a sign is compared so that it always holds: `i >= 0`. */
bool IsNeverNegative(const FValue& Condition)
{
	return Condition.Kind == EValue::Binary && Condition.Operator == ">=" &&
		   Condition.Operands[0]->Type->Scalar == EScalar::Uint && Condition.Operands[1]->Kind == EValue::Constant &&
		   Condition.Operands[1]->Constant == FConstant{0};
}

bool ReturnsInside(const FCode& Code)
{
	return Code.Kind == EStep::Return ||
		   std::ranges::any_of(Code.Body, [](const FCode* Each) { return ReturnsInside(*Each); }) ||
		   std::ranges::any_of(Code.Cases, [](const FCase& Case)
			   { return std::ranges::any_of(Case.Body, [](const FCode* Each) { return ReturnsInside(*Each); }); });
}

std::optional<bool> FindTruth(const FValue* Condition)
{
	return Condition && Condition->Kind == EValue::Constant && !Condition->Constant.empty()
			   ? std::optional<bool>(Condition->Constant[0] != 0)
			   : std::nullopt;
}

} // namespace

FCode* FAnalyser::MakeCode(EStep Step, const FPlace& Place)
{
	FCode* const Code = Program->Make<FCode>();
	Code->Kind = Step;
	Code->Place = Place;
	return Code;
}

bool FAnalyser::AnalyseBlock(const FStatement& Block, std::vector<FCode*>& Code, bool bScope)
{
	FPosition Position = Here;
	Position.Scope = bScope ? MakeScope(EScopeKind::Block, Here.Scope) : Here.Scope;
	Position.Code = &Code;
	bool bBreaks = false;
	bool bGoesOn = true;
	{
		const FPositionGuard Guard(*this, Position);
		for (const FStatement* Each : Block.Body)
		{
			bGoesOn = AnalyseStatement(*Each, Code) && bGoesOn;
		}
		bBreaks = Here.bBreaks;
	}
	Here.bBreaks = bBreaks;
	return bGoesOn;
}

/** One statement as a scope of its own. */
bool FAnalyser::AnalyseScoped(const FStatement& Statement, FCode& Code)
{
	FCode* const Block = MakeCode(EStep::Block, Statement.Place);
	Code.Body.push_back(Block);
	FStatement Alone;
	Alone.Kind = EStatement::Block;
	Alone.Body.push_back(const_cast<FStatement*>(&Statement));
	return AnalyseBlock(Statement.Kind == EStatement::Block ? Statement : Alone, Block->Body);
}

bool FAnalyser::AnalyseStatement(const FStatement& Statement, std::vector<FCode*>& Code)
{
	bool bGoesOn = true;
	FCode* Made = nullptr;
	switch (Statement.Kind)
	{
	case EStatement::Block:
		Made = MakeCode(EStep::Block, Statement.Place);
		bGoesOn = AnalyseBlock(Statement, Made->Body);
		break;
	case EStatement::Declaration:
		for (const FDeclaration* Declaration : Statement.Declarations)
		{
			AnalyseLocal(*Declaration, Code);
		}
		return true;
	case EStatement::Expression:
		Made = MakeCode(EStep::Value, Statement.Place);
		Made->Value = Settle(Analyse(*Statement.Value));
		break;
	case EStatement::If:
		Made = MakeCode(EStep::If, Statement.Place);
		bGoesOn = AnalyseIf(Statement, *Made);
		break;
	case EStatement::For:
	case EStatement::While:
	case EStatement::Do:
		Made = MakeCode(Statement.Kind == EStatement::Do ? EStep::DoLoop : EStep::Loop, Statement.Place);
		bGoesOn = AnalyseLoop(Statement, *Made);
		break;
	case EStatement::Switch:
		Made = MakeCode(EStep::Switch, Statement.Place);
		bGoesOn = AnalyseSwitch(Statement, *Made);
		break;
	case EStatement::Return:
		Made = MakeCode(EStep::Return, Statement.Place);
		bGoesOn = AnalyseReturn(Statement, *Made);
		break;
	case EStatement::Case:
	case EStatement::Default:
		Error(Statement.Place, "X3000: labels stand right in the braces of a switch");
		return true;
	case EStatement::Break:
	case EStatement::Continue:
	case EStatement::Discard:
		return AnalyseJump(Statement, Code);
	case EStatement::Empty:
		return true;
	}
	Code.push_back(Made);
	return bGoesOn;
}

bool FAnalyser::AnalyseJump(const FStatement& Statement, std::vector<FCode*>& Code)
{
	if (Statement.Kind == EStatement::Discard)
	{
		if (Options.Stage != EStage::Pixel)
		{
			Error(Statement.Place, "X4532: discard is only in pixel shaders; write return");
		}
		Code.push_back(MakeCode(EStep::Discard, Statement.Place));
		return true;
	}
	const bool bBreak = Statement.Kind == EStatement::Break;
	if (Here.NumLoops == 0 && !(bBreak && Here.NumSwitches > 0))
	{
		Error(Statement.Place, bBreak
								   ? "X3518: break stands outside of a loop or switch; to end the function write return"
								   : "X3519: continue stands outside of a loop");
		return true;
	}
	if (!bBreak && Here.bSwitch)
	{
		const char* const Message =
			"X3708: continue stands in a switch, which FXC refuses; set a flag, and write continue "
			"behind the switch";
		Options.bFxcRules ? Error(Statement.Place, Message) : Warn(Statement.Place, Message);
	}
	Here.bBreaks = Here.bBreaks || bBreak;
	Code.push_back(MakeCode(bBreak ? EStep::Break : EStep::Continue, Statement.Place));
	return false;
}

bool FAnalyser::AnalyseReturn(const FStatement& Statement, FCode& Code)
{
	const FType* const Result = Here.Function->Result;
	if (!Statement.Value)
	{
		if (Result->Kind != EType::Void)
		{
			Error(Statement.Place,
				"X3080: '" + Here.Function->Name + "' must return a value of '" + GetName(Result) + "'");
		}
		return false;
	}
	FValue* const Value = Analyse(*Statement.Value);
	if (Result->Kind == EType::Void)
	{
		if (Value->Type->Kind != EType::Void && !IsError(Value))
		{
			Error(Statement.Value->Place, "X3079: '" + Here.Function->Name + "' is void and cannot return a value");
		}
		Code.Kind = EStep::Block; // `return F();` of two void functions
		FCode* const Step = MakeCode(EStep::Value, Statement.Place);
		Step->Value = Value;
		Code.Body = {Step, MakeCode(EStep::Return, Statement.Place)};
		return false;
	}
	Code.Value = Convert(Value, Result);
	if (Here.Function->bPrecise && !IsError(Code.Value))
	{
		MarkPrecise(Code.Value);
	}
	return false;
}

bool FAnalyser::AnalyseIf(const FStatement& Statement, FCode& Code)
{
	ReadAttributes(Statement, Code);
	FPosition Position = Here;
	Position.Scope = MakeScope(EScopeKind::Block, Here.Scope);
	bool bBreaks = false;
	bool bGoesOn = true;
	{
		const FPositionGuard Guard(*this, Position);
		FValue* Condition = nullptr;
		if (Statement.Condition)
		{
			AnalyseLocal(*Statement.Condition, *Here.Code);
			FExpression Name;
			Name.Kind = EExpression::Name;
			Name.Place = Statement.Condition->Place;
			Name.Name = Statement.Condition->Name;
			Condition = AnalyseName(Name);
		}
		else
		{
			Condition = Analyse(*Statement.Value);
		}
		Code.Value = MakeCondition(Condition, "if", "write any(...) or all(...)");
		bGoesOn = AnalyseScoped(*Statement.Body[0], Code);
		bGoesOn = (Statement.Body.size() < 2 || AnalyseScoped(*Statement.Body[1], Code)) || bGoesOn;
		bBreaks = Here.bBreaks;
	}
	Here.bBreaks = bBreaks;
	return bGoesOn;
}

/** By FXC's rules, the names that a for declares stay behind it, and hide what had them before (X3078). */
void FAnalyser::KeepLoopVariables(const FNameScope& Loop, FNameScope& Outer)
{
	for (const auto& [Name, Symbol] : Loop.Symbols)
	{
		if (Options.bFxcRules && Symbol.Kind == ESymbol::Variable)
		{
			FSymbol& Kept = Outer.Symbols[Name];
			Kept = Symbol;
			Kept.Scope = &Outer;
			Kept.bOfLoop = true;
		}
	}
}

bool FAnalyser::AnalyseLoop(const FStatement& Statement, FCode& Code)
{
	ReadAttributes(Statement, Code);
	FPosition Position = Here;
	FNameScope* const Outer = Here.Scope;
	Position.Scope = MakeScope(EScopeKind::Block, Outer);
	Position.bBreaks = false;
	++Position.NumLoops;
	Position.bSwitch = false;
	const FPositionGuard Guard(*this, Position);
	const bool bFor = Statement.Kind == EStatement::For;
	const bool bDo = Statement.Kind == EStatement::Do;
	FCode* const Before = MakeCode(EStep::Block, Statement.Place);
	Code.Body.push_back(Before);
	if (bFor && Statement.Body[0])
	{
		AnalyseStatement(*Statement.Body[0], Before->Body);
		KeepLoopVariables(*Position.Scope, *Outer);
	}
	const auto MakeHead = [&]()
	{
		const std::string What = bFor ? "for" : "while";
		FValue* const Value = Statement.Value ? Analyse(*Statement.Value) : nullptr;
		Code.Value = Value ? MakeCondition(Value, What, "write any(...) or all(...)") : nullptr;
		Code.Next = Statement.Step ? Settle(Analyse(*Statement.Step)) : nullptr;
	};
	if (!bDo)
	{
		MakeHead();
	}
	const bool bBodyGoesOn = AnalyseScoped(*Statement.Body.back(), Code);
	if (bDo)
	{
		MakeHead();
	}
	if (Code.bUnroll && Code.MaxTurns == 0 && !Here.bBreaks && Code.Value && Code.Value->Kind == EValue::Binary &&
		IsRuntime(*Code.Value))
	{
		Error(Code.Value->Place, "X3511: forced to unroll loop, but unrolling failed: how often it turns is known only "
								 "when the shader runs; write [loop], or [unroll(N)] with the most turns");
	}
	const bool bEndless = !Code.Value || FindTruth(Code.Value) == true;
	if ((bEndless || IsNeverNegative(*Code.Value)) && !Here.bBreaks && !ReturnsInside(Code))
	{
		Warn(Code.Place, std::string("X3696: infinite loop: ") +
							 (bEndless ? "its condition is always true"
									   : "a uint is never below 0, so its condition is always true") +
							 ", and no break and no return leaves it");
	}
	const bool bOnce = bDo && !bBodyGoesOn && Here.bBreaks == false && !Code.Value;
	return (!bEndless && !bOnce) || Here.bBreaks;
}

/** Whether a value depends on what is certainly not known before. */
bool FAnalyser::IsRuntime(const FValue& Value) const
{
	if (Value.Kind == EValue::Variable)
	{
		const FVariable& Variable = *Value.Variable;
		const bool bInitialised = Variable.Storage == EStorage::Local && !Variable.bWritten && Variable.Initializer;
		return Variable.Storage == EStorage::Loose || Variable.Storage == EStorage::Member ||
			   (bInitialised && IsRuntime(*Variable.Initializer));
	}
	const bool bOpen = Value.Kind == EValue::Call || Value.Kind == EValue::Choose || Value.Kind == EValue::Select ||
					   Value.Kind == EValue::And || Value.Kind == EValue::Or;
	return Value.Kind == EValue::Element ||
		   (!bOpen && std::ranges::any_of(Value.Operands, [this](const FValue* Each) { return IsRuntime(*Each); }));
}

bool FAnalyser::AnalyseSwitch(const FStatement& Statement, FCode& Code)
{
	ReadAttributes(Statement, Code);
	FPosition Position = Here;
	Position.Scope = MakeScope(EScopeKind::Block, Here.Scope);
	Position.bBreaks = false;
	++Position.NumSwitches;
	Position.bSwitch = true;
	const FPositionGuard Guard(*this, Position);
	FValue* Value = Settle(Analyse(*Statement.Value));
	const FType* Type = Types->Error();
	if (!IsError(Value))
	{
		const bool bScalar = Value->Type->IsNumeric() && Value->Type->NumComponents() == 1;
		if (!bScalar || Types->GetBits(Value->Type->Scalar) == 64)
		{
			Error(Value->Place, "X3000: switch takes an int or a uint, not '" + GetName(Value->Type) + "'" +
									(bScalar ? "; cast it: switch (int(...))" : ""));
		}
		else
		{
			Type = Value->Type->IsEnum()
					   ? Value->Type
					   : Types->Scalar(IsUnsigned(Value->Type->Scalar) ? EScalar::Uint : EScalar::Int);
			Value = Convert(Value, Type);
		}
	}
	Code.Value = Type->IsEnum()
					 ? Convert(Value, Types->Scalar(IsUnsigned(Type->Scalar) ? EScalar::Uint : EScalar::Int), true)
					 : Value;
	const bool bGoesOn = AnalyseCases(*Statement.Body[0], Type, Code);
	const bool bDefault = std::ranges::any_of(Code.Cases, [](const FCase& Each) { return Each.bDefault; });
	return bGoesOn || Here.bBreaks || !bDefault;
}

bool FAnalyser::AnalyseCases(const FStatement& Body, const FType* Type, FCode& Code)
{
	std::set<uint32_t> Seen;
	std::vector<size_t> Falls; // cases that go on into the next one
	bool bGoesOn = false;      // from the case before
	bool bLabels = false;      // labels without a statement yet
	for (const FStatement* Each : Body.Body)
	{
		const bool bLabel = Each->Kind == EStatement::Case || Each->Kind == EStatement::Default;
		if (bLabel)
		{
			if (!bLabels)
			{
				if (bGoesOn && !Code.Cases.empty() && !Code.Cases.back().Body.empty())
				{
					Warn(Each->Place, "X3533: the case before this label goes on into it, which FXC refuses: non-empty "
									  "case statements must have break or return");
					Falls.push_back(Code.Cases.size() - 1);
				}
				Code.Cases.emplace_back();
			}
			bLabels = true;
			bGoesOn = true;
			AddLabel(*Each, Type, Code.Cases.back(), Seen);
			continue;
		}
		if (Code.Cases.empty())
		{
			Error(Each->Place, "X3000: a statement of a switch stands before its first case");
			Code.Cases.emplace_back();
		}
		bLabels = false;
		std::vector<FCode*>& Into = Code.Cases.back().Body;
		Here.Code = &Into;
		if (Each->Kind == EStatement::Break)
		{
			Here.bBreaks = true;
			bGoesOn = false; // what follows is never run
			std::vector<FCode*> Unreached;
			Here.Code = &Unreached;
			continue;
		}
		if (bGoesOn)
		{
			bGoesOn = AnalyseStatement(*Each, Into);
			continue;
		}
		std::vector<FCode*> Unreached;
		Here.Code = &Unreached;
		AnalyseStatement(*Each, Unreached);
	}
	if (bLabels)
	{
		Error(Body.End.Line ? Body.End : Body.Place,
			"X3000: a label at the end of a switch needs a statement; write break");
	}
	JoinCases(Falls, Body.Place, Code);
	return bGoesOn;
}

/** A case that goes on into the next one has its statements, too. */
void FAnalyser::JoinCases(const std::vector<size_t>& Falls, const FPlace& Place, FCode& Code)
{
	size_t NumJoined = 0;
	for (size_t i = Falls.size(); i-- > 0 && NumJoined <= MaxJoinedStatements;)
	{
		const std::vector<FCode*>& Next = Code.Cases[Falls[i] + 1].Body;
		NumJoined += Next.size();
		std::vector<FCode*>& Own = Code.Cases[Falls[i]].Body;
		Own.insert(Own.end(), Next.begin(), Next.end());
	}
	if (NumJoined > MaxJoinedStatements)
	{
		Error(Place, "X3533: too many cases of a switch go on into the next ones; write break");
	}
}

void FAnalyser::AddLabel(const FStatement& Label, const FType* Type, FCase& Case, std::set<uint32_t>& Seen)
{
	if (Label.Kind == EStatement::Default)
	{
		if (!Seen.insert(UINT32_MAX).second && Case.bDefault)
		{
			Error(Label.Place, "X3532: a switch has one default");
		}
		Case.bDefault = true;
		return;
	}
	FValue* const Value = Analyse(*Label.Value);
	if (IsError(Value) || Type->Kind == EType::Error)
	{
		return;
	}
	FValue* const Converted = Convert(Value, Type);
	const std::optional<FConstant> Constant = IsError(Converted) ? std::nullopt : Fold(*Types, *Converted);
	if (!Constant)
	{
		if (!IsError(Converted))
		{
			Error(Label.Value->Place, "X3058: the label of a case must be a constant expression");
		}
		return;
	}
	const uint32_t Bits = uint32_t(Constant->at(0));
	if (std::ranges::find(Case.Labels, Bits) != Case.Labels.end() || !Seen.insert(Bits).second)
	{
		Error(Label.Value->Place, "X3532: duplicate case " + std::to_string(int32_t(Bits)));
	}
	Case.Labels.push_back(Bits);
}

void FAnalyser::ReadAttributes(const FStatement& Statement, FCode& Code)
{
	for (const FAttribute& Attribute : Statement.Attributes)
	{
		const std::string& Name = Attribute.Name;
		Code.bUnroll = Code.bUnroll || Name == "unroll";
		Code.bLoop = Code.bLoop || Name == "loop";
		Code.bBranch = Code.bBranch || Name == "branch";
		Code.bFlatten = Code.bFlatten || Name == "flatten";
		if (Name == "unroll" && !Attribute.Arguments.empty())
		{
			const std::optional<int64_t> Turns = FindInteger(*Attribute.Arguments[0], "the number of [unroll]");
			if (Turns && (*Turns < 1 || *Turns > INT32_MAX))
			{
				Error(Attribute.Place, "X3084: [unroll(N)] takes a number from 1 on, not " + std::to_string(*Turns));
			}
			Code.MaxTurns = Turns ? uint32_t(*Turns) : 0;
		}
	}
	if (Code.bUnroll && Code.bLoop)
	{
		Error(Statement.Place, "X3524: [loop] and [unroll] cannot stand before one loop; leave one out");
	}
	if (Code.bBranch && Code.bFlatten)
	{
		Error(Statement.Place, "X3525: [branch] and [flatten] cannot stand before one statement; leave one out");
	}
}

} // namespace Drydock::Hlsl
