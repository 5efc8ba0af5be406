// Statements: control flow with the merge blocks that SPIR-V wants. Source: SPIR-V specification, section 2.11.
#include "HlslEmitterImpl.h"

namespace Drydock::Hlsl
{

using namespace Spirv;

void FEmitter::End(uint16_t Opcode, const FWords& Operands)
{
	Do(Opcode, Operands);
	Frame->Body.bOpen = false;
}

/** A block that nothing leads to is left empty. */
void FEmitter::Begin(uint32_t Label)
{
	FBody& Body = Frame->Body;
	Body.bOpen = true;
	Body.Line = -1;
	AddWords(Body.Code, OpLabel, {Label});
}

void FEmitter::Branch(uint32_t Label)
{
	if (Frame->Body.bOpen)
	{
		Frame->Body.Reached.insert(Label);
		End(OpBranch, {Label});
	}
}

/** Merge 0: one of the labels is where a loop goes on or ends. */
void FEmitter::BranchIf(uint32_t Condition, uint32_t Then, uint32_t Else, uint32_t Merge)
{
	if (Merge)
	{
		Do(OpSelectionMerge, {Merge, 0});
	}
	Frame->Body.Reached.insert({Then, Else});
	End(OpBranchConditional, {Condition, Then, Else});
}

/** The block behind a selection or a loop. */
void FEmitter::BeginMerge(uint32_t Label)
{
	Begin(Label);
	if (!Frame->Body.Reached.count(Label))
	{
		End(OpUnreachable);
	}
}

void FEmitter::If(uint32_t Condition, const std::function<void()>& Then, const std::function<void()>& Else)
{
	const uint32_t ThenLabel = Module.NewId();
	const uint32_t ElseLabel = Else ? Module.NewId() : 0;
	const uint32_t Merge = Module.NewId();
	BranchIf(Condition, ThenLabel, Else ? ElseLabel : Merge, Merge);
	Begin(ThenLabel);
	Then();
	Branch(Merge);
	if (Else)
	{
		Begin(ElseLabel);
		Else();
		Branch(Merge);
	}
	BeginMerge(Merge);
}

void FEmitter::Kill()
{
	End(OpKill);
}

void FEmitter::StatementBody(const std::vector<FCode*>& Body)
{
	for (const FCode* const Code : Body)
	{
		if (Code)
		{
			Statement(*Code);
		}
	}
}

void FEmitter::Statement(const FCode& Code)
{
	if (!Frame->Body.bOpen) // behind a return
	{
		return;
	}
	SetPlace(Code.Place);
	switch (Code.Kind)
	{
	case EStep::Block:
		Deeper(Code.Place, [&] { StatementBody(Code.Body); });
		return;
	case EStep::Variable:
		Declare(Code);
		return;
	case EStep::Value:
		HasObject(Code.Value->Type) && Code.Value->Kind != EValue::Assign ? void(Objects(*Code.Value))
																		  : void(Value(*Code.Value));
		return;
	case EStep::If:
	{
		const uint32_t Condition = Value(*Code.Value);
		const bool bElse = Code.Body.size() > 1 && Code.Body[1];
		const auto Side = [this, &Code](size_t i)
		{
			return [this, &Code, i]
			{
				if (i < Code.Body.size() && Code.Body[i])
				{
					Deeper(Code.Place, [&] { Statement(*Code.Body[i]); });
				}
			};
		};
		bElse ? If(Condition, Side(0), Side(1)) : If(Condition, Side(0));
		return;
	}
	case EStep::Loop:
	case EStep::DoLoop:
		Deeper(Code.Place, [&] { Loop(Code); });
		return;
	case EStep::Switch:
		Deeper(Code.Place, [&] { Switch(Code); });
		return;
	case EStep::Break:
		Branch(Frame->Exits.back().Break);
		return;
	case EStep::Continue:
		Branch(Frame->Exits.back().Continue);
		return;
	case EStep::Return:
		Return(Code);
		return;
	case EStep::Discard:
		if (Program.Stage != EStage::Pixel)
		{
			Fail(Code.Place, "discard is for pixel shaders only");
		}
		Kill();
		return;
	}
}

void FEmitter::Declare(const FCode& Code)
{
	const FVariable& Variable = *Code.Variable;
	const bool bNumbers = CountScalars(Variable.Type) > 0;
	if (Variable.Storage == EStorage::Static || (Variable.Constant && !Variable.bWritten))
	{
		return; // set before the entry; a constant, which has no memory
	}
	const FTarget Target = bNumbers ? VariablePlace(Variable) : FTarget();
	if (!Code.Value)
	{
		return;
	}
	FObjects Found;
	const uint32_t Id = Both(*Code.Value, Found);
	if (Id && bNumbers)
	{
		Store(Target, Id);
	}
	if (HasObject(Variable.Type))
	{
		StoreObjects({SlotsOf(Variable)}, Found);
	}
}

void FEmitter::Loop(const FCode& Code)
{
	const bool bDo = Code.Kind == EStep::DoLoop;
	if (!bDo && !Code.Body.empty() && Code.Body[0])
	{
		Statement(*Code.Body[0]);
		SetPlace(Code.Place);
	}
	const uint32_t Turns = Code.MaxTurns ? Temporary(Module.Uint()) : 0;
	if (Turns)
	{
		Do(OpStore, {Turns, Module.Uint(0)});
	}
	const uint32_t Header = Module.NewId();
	const uint32_t Test = Module.NewId();
	const uint32_t Body = Module.NewId();
	const uint32_t Continue = Module.NewId();
	const uint32_t Merge = Module.NewId();
	Branch(Header);
	Begin(Header);
	Do(OpLoopMerge, {Merge, Continue, 0});
	Branch(Test);
	Begin(Test);
	if (Turns)
	{
		const uint32_t Count = Op(OpLoad, Module.Uint(), {Turns});
		Do(OpStore, {Turns, Op(OpIAdd, Module.Uint(), {Count, Module.Uint(1)})});
		const uint32_t Known = Module.NewId();
		BranchIf(Op(OpULessThan, Module.Bool(), {Count, Module.Uint(Code.MaxTurns)}), Known, Merge, 0);
		Begin(Known);
	}
	if (!bDo && Code.Value)
	{
		BranchIf(Value(*Code.Value), Body, Merge, 0);
	}
	else
	{
		Branch(Body);
	}
	Begin(Body);
	Frame->Exits.push_back({Merge, Continue});
	if (Code.Body.size() > 1 && Code.Body[1])
	{
		Statement(*Code.Body[1]);
	}
	Frame->Exits.pop_back();
	Branch(Continue);
	Begin(Continue);
	if (Frame->Body.Reached.count(Continue))
	{
		SetPlace(bDo && Code.Value ? Code.Value->Place : Code.Place);
		const FValue* const Next = bDo ? Code.Value : Code.Next;
		const uint32_t Id = Next ? Value(*Next) : 0;
		bDo&& Id ? BranchIf(Id, Header, Merge, 0) : Branch(Header);
	}
	else
	{
		Branch(Header);
	}
	BeginMerge(Merge);
}

void FEmitter::Switch(const FCode& Code)
{
	const uint32_t Selector = Value(*Code.Value);
	const bool bWide = Bits(Code.Value->Type->Scalar) == 64;
	const uint32_t Merge = Module.NewId();
	FWords Words = {Selector, Merge};
	FWords Labels;
	for (const FCase& Case : Code.Cases)
	{
		Labels.push_back(Module.NewId());
		Words[1] = Case.bDefault ? Labels.back() : Words[1];
		for (const uint32_t Label : Case.Labels)
		{
			Words.push_back(Label);
			if (bWide)
			{
				Words.push_back(KindOf(Code.Value->Type->Scalar) == ENumber::Signed && Label >> 31 ? ~0u : 0u);
			}
			Words.push_back(Labels.back());
		}
	}
	Frame->Body.Reached.insert(Labels.begin(), Labels.end());
	Frame->Body.Reached.insert(Words[1]);
	Do(OpSelectionMerge, {Merge, 0});
	End(OpSwitch, Words);
	const uint32_t Continue = Frame->Exits.empty() ? 0 : Frame->Exits.back().Continue;
	Frame->Exits.push_back({Merge, Continue});
	for (size_t i = 0; i < Code.Cases.size(); ++i)
	{
		const bool bUsed = Code.Cases[i].bDefault || !Code.Cases[i].Labels.empty();
		if (bUsed)
		{
			Begin(Labels[i]);
			StatementBody(Code.Cases[i].Body);
			Branch(Merge);
		}
	}
	Frame->Exits.pop_back();
	BeginMerge(Merge);
}

void FEmitter::Return(const FCode& Code)
{
	FObjects Found;
	const uint32_t Id = Code.Value ? Both(*Code.Value, Found) : 0;
	if (Frame->Instance && !Found.empty())
	{
		FSlotChoice Choice;
		for (FObjectSlot& Slot : Frame->Instance->Results)
		{
			Choice.Slots.push_back(&Slot);
		}
		StoreObjects({Choice}, Found);
	}
	const bool bValue = Id && CountScalars(Frame->Function->Result) > 0;
	bValue ? End(OpReturnValue, {Id}) : End(OpReturn);
}

} // namespace Drydock::Hlsl
