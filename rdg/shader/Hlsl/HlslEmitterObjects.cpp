// Resources as values: which of them a variable, an argument or an element of an array may be. A known one is
// resolved; the rest is a number, by which each use chooses.
#include "HlslEmitterImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr int EmitMaxSweeps = 32; // over a function, until nothing new is assigned

bool AddEmitLeaves(std::vector<FLeaf*>& To, const std::vector<FLeaf*>& From)
{
	bool bNew = false;
	for (FLeaf* const Leaf : From)
	{
		if (std::ranges::find(To, Leaf) == To.end())
		{
			To.push_back(Leaf);
			bNew = true;
		}
	}
	return bNew;
}

} // namespace

uint32_t FEmitter::CountObjects(const FType* Type)
{
	if (!HasObject(Type))
	{
		return 0;
	}
	uint64_t Count = Type->IsObject() ? 1 : Type->IsArray() ? uint64_t(Type->Count) * CountObjects(Type->Element) : 0;
	for (size_t i = 0; Type->IsStruct() && i < Type->Struct->Members.size(); ++i)
	{
		Count += CountObjects(Type->Struct->Members[i].Type);
	}
	return uint32_t(std::min<uint64_t>(Count, 1u << 16));
}

uint32_t FEmitter::NumberOf(const FObjectSet& Set)
{
	return Set.Number ? Set.Number : Module.Uint(Set.Leaves.at(0)->Number);
}

uint32_t FEmitter::ForEach(const FObjectSet& Set, uint32_t Type, const std::function<uint32_t(FLeaf&)>& Work)
{
	if (Set.Leaves.empty())
	{
		Fail(Current, "a resource is used that nothing was assigned to");
	}
	if (Set.Leaves.size() == 1)
	{
		return Work(*Set.Leaves[0]);
	}
	const uint32_t Result = Type ? Temporary(Type) : 0;
	const uint32_t Merge = Module.NewId();
	FWords Words = {Set.Number, 0};
	FWords Labels;
	for (const FLeaf* const Leaf : Set.Leaves)
	{
		Labels.push_back(Module.NewId());
		if (Leaf != Set.Leaves.back()) // which is the default, so that a number that is none of these has one
		{
			Words.insert(Words.end(), {Leaf->Number, Labels.back()});
		}
	}
	Words[1] = Labels.back();
	Do(OpSelectionMerge, {Merge, 0});
	End(OpSwitch, Words);
	for (size_t i = 0; i < Labels.size(); ++i)
	{
		Begin(Labels[i]);
		const uint32_t Id = Work(*Set.Leaves[i]);
		if (Result)
		{
			Do(OpStore, {Result, Id});
		}
		Branch(Merge);
	}
	Begin(Merge);
	return Result ? Op(OpLoad, Type, {Result}) : 0;
}

FObjectSet FEmitter::Object(const FValue& Node)
{
	const FObjects Found = Objects(Node);
	if (Found.size() != 1 || Found[0].Leaves.empty())
	{
		Fail(Node.Place, "this resource is not known here: nothing was assigned to it");
	}
	return Found[0];
}

uint32_t FEmitter::Both(const FValue& Node, FObjects& Found)
{
	if (!HasObject(Node.Type))
	{
		return Value(Node);
	}
	Found = Objects(Node);
	if (Node.Kind != EValue::Call)
	{
		return CountScalars(Node.Type) == 0 ? 0 : Value(Node);
	}
	return LastCall;
}

FObjects FEmitter::VariableObjects(const FValue& Node, bool bEmit)
{
	FObjects Result;
	const FVariable& Variable = *Node.Variable;
	const auto Known = LeavesOf.find(&Variable);
	if (Known != LeavesOf.end())
	{
		for (FLeaf* const Leaf : Known->second)
		{
			Result.push_back({{Leaf}, 0});
		}
		return Result;
	}
	if (Variable.Storage == EStorage::Static)
	{
		if (Variable.bWritten || !Variable.Initializer)
		{
			Fail(Node.Place, "a static variable of resources has to be const, with a value");
		}
		return Objects(*Variable.Initializer, bEmit);
	}
	for (const FObjectSlot* const Slot : SlotsOf(Variable).Slots)
	{
		const bool bSeveral = Slot->Leaves.size() > 1;
		Result.push_back({Slot->Leaves, bSeveral && bEmit ? Op(OpLoad, Module.Uint(), {Slot->Variable}) : 0});
	}
	return Result;
}

FObjects FEmitter::ChosenObjects(const FValue& Node, bool bEmit)
{
	const uint32_t Condition = bEmit ? Value(*Node.Operands[0]) : 0;
	FObjects Result = Objects(*Node.Operands[1], bEmit);
	const FObjects Other = Objects(*Node.Operands[2], bEmit);
	for (size_t i = 0; i < Result.size() && i < Other.size(); ++i)
	{
		const uint32_t A = bEmit ? NumberOf(Result[i]) : 0;
		AddEmitLeaves(Result[i].Leaves, Other[i].Leaves);
		const bool bSeveral = bEmit && Result[i].Leaves.size() > 1;
		Result[i].Number = bSeveral ? Op(OpSelect, Module.Uint(), {Condition, A, NumberOf(Other[i])}) : 0;
	}
	return Result;
}

/** bEmit: with the code that finds the numbers; else which they may be. */
FObjects FEmitter::Objects(const FValue& Node, bool bEmit)
{
	FObjects Result;
	switch (Node.Kind)
	{
	case EValue::Variable:
		return VariableObjects(Node, bEmit);
	case EValue::Member:
	{
		const FObjects All = Objects(*Node.Operands[0], bEmit);
		size_t First = 0;
		for (uint32_t i = 0; i < Node.Index; ++i)
		{
			First += CountObjects(Node.Operands[0]->Type->Struct->Members[i].Type);
		}
		return FObjects(All.begin() + ptrdiff_t(First), All.begin() + ptrdiff_t(First + CountObjects(Node.Type)));
	}
	case EValue::Index:
		return ElementObjects(Node, bEmit);
	case EValue::Choose:
		return ChosenObjects(Node, bEmit);
	case EValue::Call:
	{
		FInstance* Called = nullptr;
		FindCallee(Node, bEmit, Called);
		for (const FObjectSlot& Slot : Called->Results)
		{
			const bool bSeveral = Slot.Leaves.size() > 1;
			Result.push_back({Slot.Leaves, bSeveral && bEmit ? Op(OpLoad, Module.Uint(), {Slot.Variable}) : 0});
		}
		return Result;
	}
	case EValue::Comma:
		if (bEmit)
		{
			Value(*Node.Operands[0]);
		}
		return Objects(*Node.Operands[1], bEmit);
	case EValue::Assign:
		if (bEmit)
		{
			Assign(Node);
		}
		return Objects(*Node.Operands[0], bEmit);
	case EValue::Zero:
		return FObjects(CountObjects(Node.Type));
	case EValue::Convert:
	case EValue::Cast:
	case EValue::Compose:
		for (const FValue* const Operand : Node.Operands)
		{
			const FObjects Part = HasObject(Operand->Type) ? Objects(*Operand, bEmit) : FObjects();
			Result.insert(Result.end(), Part.begin(), Part.end());
		}
		return Result;
	default:
		Fail(Node.Place, "a resource cannot be found by this expression; name it");
	}
}

/** An element of an array of resources. */
FObjects FEmitter::ElementObjects(const FValue& Node, bool bEmit)
{
	const FValue& Whole = *Node.Operands[0];
	const FValue& Index = *Node.Operands[1];
	const bool bKnown = Index.Kind == EValue::Constant;
	if (Whole.Type->Count == 0)
	{
		if (!bKnown || Whole.Kind != EValue::Variable || Whole.Variable->Storage != EStorage::Resource)
		{
			const std::string Name = Whole.Kind == EValue::Variable ? " '" + Whole.Variable->Name + "'" : "";
			Fail(Node.Place,
				"the array" + Name + " of resources without a size needs a literal as its index; give it a size");
		}
		return UnboundedLeaves(*Whole.Variable, uint32_t(Index.Constant.at(0)), Node.Place);
	}
	const FObjects All = Objects(Whole, bEmit);
	const size_t Each = CountObjects(Node.Type);
	const size_t Count = Each ? All.size() / Each : 0;
	if (Count == 0)
	{
		return FObjects(Each);
	}
	if (bKnown)
	{
		const size_t At = std::min<size_t>(uint32_t(Index.Constant.at(0)), Count - 1) * Each;
		return FObjects(All.begin() + ptrdiff_t(At), All.begin() + ptrdiff_t(At + Each));
	}
	const FType* const Uint = Types.Scalar(EScalar::Uint);
	const uint32_t Number = bEmit ? Convert(Value(Index), Index.Type, Uint) : 0;
	FObjects Result(Each);
	for (size_t k = 0; k < Each; ++k)
	{
		bool bRow = Count > 1; // the numbers stand in a row
		for (size_t i = 0; i < Count; ++i)
		{
			const FObjectSet& Set = All[i * Each + k];
			AddEmitLeaves(Result[k].Leaves, Set.Leaves);
			bRow = bRow && Set.Leaves.size() == 1 && All[k].Leaves.size() == 1 && All[Each + k].Leaves.size() == 1;
			bRow = bRow && Set.Leaves[0]->Number - All[k].Leaves[0]->Number ==
							   i * (All[Each + k].Leaves[0]->Number - All[k].Leaves[0]->Number);
		}
		if (!bEmit || Result[k].Leaves.size() < 2)
		{
			continue;
		}
		if (bRow)
		{
			const uint32_t First = All[k].Leaves[0]->Number;
			const uint32_t Step = All[Each + k].Leaves[0]->Number - First;
			const uint32_t Scaled = Step == 1 ? Number : Op(OpIMul, Module.Uint(), {Number, Module.Uint(Step)});
			Result[k].Number = First == 0 ? Scaled : Op(OpIAdd, Module.Uint(), {Scaled, Module.Uint(First)});
			continue;
		}
		uint32_t Chosen = NumberOf(All[(Count - 1) * Each + k]);
		for (size_t i = 0; i + 1 < Count; ++i)
		{
			const uint32_t Is = Op(OpIEqual, Module.Bool(), {Number, Module.Uint(uint32_t(i))});
			Chosen = Op(OpSelect, Module.Uint(), {Is, NumberOf(All[i * Each + k]), Chosen});
		}
		Result[k].Number = Chosen;
	}
	return Result;
}

FEmitter::FSlotChoice FEmitter::SlotsOf(const FVariable& Variable)
{
	std::vector<FObjectSlot>& Slots = Frame->Slots[&Variable];
	Slots.resize(CountObjects(Variable.Type));
	FSlotChoice Choice;
	for (FObjectSlot& Slot : Slots)
	{
		Choice.Slots.push_back(&Slot);
	}
	return Choice;
}

/** The memory of a local variable, or of a part of one. */
std::vector<FEmitter::FSlotChoice> FEmitter::SlotsOf(const FValue& Node, bool bEmit)
{
	if (Node.Kind == EValue::Variable && Node.Variable->Storage != EStorage::Resource)
	{
		return {SlotsOf(*Node.Variable)};
	}
	const bool bIndex = Node.Kind == EValue::Index;
	if (Node.Kind != EValue::Member && !bIndex)
	{
		Fail(Node.Place, "a resource can be assigned to a local variable, to a member of one or to an element of one");
	}
	const size_t Size = CountObjects(Node.Type);
	std::vector<FSlotChoice> Result;
	for (const FSlotChoice& Whole : SlotsOf(*Node.Operands[0], bEmit))
	{
		size_t First = 0;
		size_t Count = 1;
		for (uint32_t i = 0; !bIndex && i < Node.Index; ++i)
		{
			First += CountObjects(Node.Operands[0]->Type->Struct->Members[i].Type);
		}
		const bool bKnown = bIndex && Node.Operands[1]->Kind == EValue::Constant;
		const uint32_t Index = bIndex && !bKnown && bEmit ? Value(*Node.Operands[1]) : 0;
		First = bKnown ? uint32_t(Node.Operands[1]->Constant.at(0)) * Size : First;
		Count = bIndex && !bKnown ? Node.Operands[0]->Type->Count : 1;
		for (size_t i = 0; i < Count && First + (i + 1) * Size <= Whole.Slots.size(); ++i)
		{
			const auto Begin = Whole.Slots.begin() + ptrdiff_t(First + i * Size);
			FSlotChoice Part{{Begin, Begin + ptrdiff_t(Size)}, Whole.Condition};
			if (Index)
			{
				const uint32_t Number = ScalarConstant(Node.Operands[1]->Type->Scalar, i);
				const uint32_t Is = Op(OpIEqual, Module.Bool(), {Index, Number});
				Part.Condition = Part.Condition ? Op(OpLogicalAnd, Module.Bool(), {Part.Condition, Is}) : Is;
			}
			Result.push_back(std::move(Part));
		}
	}
	return Result;
}

void FEmitter::StoreObjects(const std::vector<FSlotChoice>& Choices, const FObjects& Values)
{
	for (const FSlotChoice& Choice : Choices)
	{
		for (size_t i = 0; i < Choice.Slots.size() && i < Values.size(); ++i)
		{
			FObjectSlot& Slot = *Choice.Slots[i];
			if (Slot.Leaves.size() < 2 || Values[i].Leaves.empty())
			{
				continue;
			}
			Slot.Variable = Slot.Variable ? Slot.Variable : Temporary(Module.Uint());
			uint32_t Number = NumberOf(Values[i]);
			if (Choice.Condition)
			{
				const uint32_t Old = Op(OpLoad, Module.Uint(), {Slot.Variable});
				Number = Op(OpSelect, Module.Uint(), {Choice.Condition, Number, Old});
			}
			Do(OpStore, {Slot.Variable, Number});
		}
	}
}

/** Finds what each local variable may be before any code is written: a loop may assign behind the use. */
void FEmitter::FindObjects(const FFunction& Function)
{
	int Sweeps = 0;
	while (FindObjectsOf(*Function.Body) && ++Sweeps < EmitMaxSweeps)
	{
	}
	for (auto& [Variable, Slots] : Frame->Slots)
	{
		for (FObjectSlot& Slot : Slots)
		{
			Slot.Variable = Slot.Leaves.size() > 1 && !Slot.Variable ? Temporary(Module.Uint()) : Slot.Variable;
		}
	}
	for (FObjectSlot& Slot : Frame->Instance->Results)
	{
		Slot.Variable = Slot.Leaves.size() > 1 ? Module.Global(Module.Uint(), StoragePrivate, "@result") : 0;
	}
}

bool FEmitter::FindObjectsOf(const FCode& Code)
{
	bool bNew = false;
	const auto Add = [&](const std::vector<FObjectSlot*>& Slots, const FValue& From)
	{
		const FObjects Found = Objects(From, false);
		for (size_t i = 0; i < Slots.size() && i < Found.size(); ++i)
		{
			bNew = AddEmitLeaves(Slots[i]->Leaves, Found[i].Leaves) || bNew;
		}
	};
	if (Code.Kind == EStep::Variable && Code.Value && HasObject(Code.Variable->Type))
	{
		Add(SlotsOf(*Code.Variable).Slots, *Code.Value);
	}
	if (Code.Kind == EStep::Return && Code.Value && HasObject(Code.Value->Type))
	{
		std::vector<FObjectSlot*> Slots;
		for (FObjectSlot& Slot : Frame->Instance->Results)
		{
			Slots.push_back(&Slot);
		}
		Add(Slots, *Code.Value);
	}
	for (const FValue* const Each : {Code.Value, Code.Next})
	{
		bNew = (Each && FindObjectsOf(*Each)) || bNew;
	}
	for (const FCode* const Each : Code.Body)
	{
		bNew = (Each && FindObjectsOf(*Each)) || bNew;
	}
	for (const FCase& Case : Code.Cases)
	{
		for (const FCode* const Each : Case.Body)
		{
			bNew = FindObjectsOf(*Each) || bNew;
		}
	}
	return bNew;
}

bool FEmitter::FindObjectsOf(const FValue& Node)
{
	bool bNew = false;
	Deeper(Node.Place,
		[&]
		{
			if (Node.Kind == EValue::Assign && HasObject(Node.Type))
			{
				const FValue* Root = Node.Operands[0];
				while (!Root->Operands.empty())
				{
					Root = Root->Operands[0];
				}
				if (Root->Variable &&
					(Root->Variable->Storage == EStorage::This ||
						(Root->Variable->Storage == EStorage::Parameter && (Root->Variable->Modifiers & ModifierOut))))
				{
					Fail(Node.Place, "a resource cannot be given back through a parameter; return it");
				}
				const FObjects Found = Objects(*Node.Operands[1], false);
				for (const FSlotChoice& Choice : SlotsOf(*Node.Operands[0], false))
				{
					for (size_t i = 0; i < Choice.Slots.size() && i < Found.size(); ++i)
					{
						bNew = AddEmitLeaves(Choice.Slots[i]->Leaves, Found[i].Leaves) || bNew;
					}
				}
			}
			for (const FValue* const Operand : Node.Operands)
			{
				bNew = FindObjectsOf(*Operand) || bNew;
			}
		});
	return bNew;
}

} // namespace Drydock::Hlsl
