// Emits arrays that are passed by value: `for (k...) To[k] = From[k];` instead of a line for each scalar.
#include "SpirvEmitter.h"

#include "SpirvLimits.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr size_t MaxScan = 64; // instructions looked at behind a load

bool IsAccessChain(const FSpirvInstruction& I)
{
	return I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain;
}

std::string LoopHead(uint32_t Size)
{
	return "for (int32_t k = 0; k < " + std::to_string(Size) + "; ++k) ";
}

} // namespace

std::set<ESpirvType> FSpirvEmitter::GetKinds(uint32_t Type) const
{
	std::set<ESpirvType> Kinds;
	for (uint32_t i = 0; i < Module.GetType(Type).NumScalars; ++i)
	{
		Kinds.insert(Module.GetScalarKind(Type, i));
	}
	return Kinds;
}

void FSpirvEmitter::CountArray(uint32_t Size, size_t NumKinds, const FSpirvInstruction* Where)
{
	ArrayBytes += uint64_t(Size) * NumKinds * 4;
	if (ArrayBytes > SpirvLimits::MaxArrayBytesPerLane)
	{
		Module.FailLimit(SpirvLimits::MaxArrayBytesPerLane, "bytes of arrays for each thread",
			"put a large array into a buffer or a texture", Where);
	}
}

bool FSpirvEmitter::IsLoopedCopy(const FSpirvPlace& Place) const
{
	return !Place.bBytes && Place.Variable->Storage != StorageWorkgroup &&
		   Place.Scalars.size() >= SpirvLimits::MinLoopedCopy && DynamicVariables.count(Place.Variable->Id) &&
		   !Tables.count(Place.Variable->Id);
}

/** All uses of the loaded value follow in its block, before anything is written to the variable. */
bool FSpirvEmitter::CanReadInPlace(const FSpirvInstruction& Load, uint32_t Variable) const
{
	const auto Known = NumUses.find(Load.Result);
	uint32_t Left = Known == NumUses.end() ? 0 : Known->second;
	const std::vector<FSpirvInstruction>& Block = Module.GetBlock(CurrentBlock).Instructions;
	const size_t First = size_t(&Load - Block.data()) + 1;
	for (size_t i = First; Left && i < std::min(Block.size(), First + MaxScan); ++i)
	{
		const FSpirvInstruction& I = Block[i];
		const bool bStore = I.Op == OpStore || (I.Op == OpExtInst && I.Operands[1] == ExtModf);
		if (bStore)
		{
			const uint32_t Pointer = I.Operands[I.Op == OpStore ? 0 : 3];
			const auto Chain = Definitions.find(Pointer);
			const bool bChain = Chain != Definitions.end() && IsAccessChain(*Chain->second);
			if ((bChain ? Chain->second->Operands[0] : Pointer) == Variable)
			{
				return false;
			}
		}
		if (I.Op == OpStore && I.Operands[1] == Load.Result) // what else takes it keeps its scalars for later
		{
			--Left;
		}
	}
	return Left == 0;
}

void FSpirvEmitter::EmitLoopedLoad(const FSpirvInstruction& I, const FSpirvPlace& Place)
{
	const FSpirvVariable& Variable = *Place.Variable;
	const uint32_t Size = uint32_t(Place.Scalars.size());
	const std::set<ESpirvType> Kinds = GetKinds(Place.Type);
	const bool bSourceVaries = Variable.Storage == StorageOutput || Uniformity.IsVariableVarying(Variable.Id);
	FArrayValue Value;
	if (Place.Indices.empty() && CanReadInPlace(I, Variable.Id))
	{
		Value.Offset = Place.Offset;
		Value.bVarying = bSourceVaries;
		for (const ESpirvType Kind : Kinds)
		{
			Value.Names[Kind] = LocalArray(Variable, Kind);
		}
	}
	else
	{
		CountArray(Size, Kinds.size(), &I);
		const std::string Name = "v" + std::to_string(I.Result);
		Value.bVarying = Uniformity.IsAnyVarying(I.Result);
		Value.Local = int(Locals.size());
		Locals.push_back({Name, Scopes.back(), Loops});
		const bool bHoisted = Findings.Hoisted.count(Name) != 0;
		const bool bKept = Value.bVarying && bHoisted && Findings.KeptByLanes.count(Name);
		for (const ESpirvType Kind : Kinds)
		{
			const std::string Array = Name + ArraySuffix(Kind);
			if (bHoisted)
			{
				Declare(TypeName(Kind, Value.bVarying), Array, Size, "{}");
			}
			else
			{
				Line(TypeName(Kind, Value.bVarying) + " " + Array + "[" + std::to_string(Size) + "];");
			}
			bool bIndexVaries = false;
			const std::string Index = IndexText(Place, std::to_string(Place.Offset) + " + k", bIndexVaries);
			const std::string Source = LocalArray(Variable, Kind);
			const FEmitScalar Element = {
				bIndexVaries ? "PickElement(" + Source + ", " + Index + ")" : Source + "[" + Index + "]", Kind,
				bSourceVaries || bIndexVaries, -1};
			const std::string New = UseAs(Element, Kind, Value.bVarying);
			Line(LoopHead(Size) + (bKept ? "Assign(e, " + Array + "[k], " + New + ");" : Array + "[k] = " + New + ";"));
			Value.Names[Kind] = Array;
		}
	}
	std::vector<FEmitScalar>& List = Values[I.Result];
	List.clear();
	for (uint32_t i = 0; i < Size; ++i)
	{
		const ESpirvType Kind = Module.GetScalarKind(Place.Type, i);
		List.push_back({Value.Names[Kind] + "[" + std::to_string(Value.Offset + i) + "]", Kind, Value.bVarying,
			Value.Local, EEmitLevel::Pack});
	}
	ArrayValues[I.Result] = std::move(Value);
}

const FSpirvEmitter::FArrayValue* FSpirvEmitter::FindArrayValue(uint32_t Id)
{
	const auto Known = ArrayValues.find(Id);
	const FSpirvConstant* Constant = Module.FindConstant(Id);
	if (Known != ArrayValues.end() || !Constant || Constant->Scalars.size() < SpirvLimits::MinLoopedCopy)
	{
		return Known == ArrayValues.end() ? nullptr : &Known->second;
	}
	FArrayValue& Value = ArrayValues[Id];
	for (const ESpirvType Kind : GetKinds(Constant->Type))
	{
		std::string Elements;
		for (uint32_t i = 0; i < Constant->Scalars.size(); ++i)
		{
			const bool bThis = Module.GetScalarKind(Constant->Type, i) == Kind;
			Elements += (i ? ", " : "") + Literal(Kind, bThis ? Constant->Scalars[i] : 0).Text;
		}
		const std::string Array = "c" + std::to_string(Id) + ArraySuffix(Kind);
		TableText += "constexpr " + TypeName(Kind, false) + " " + Array + "[" +
					 std::to_string(Constant->Scalars.size()) + "] = {" + Elements + "};\n";
		Value.Names[Kind] = Array;
	}
	return &Value;
}

bool FSpirvEmitter::EmitLoopedStore(const FSpirvInstruction& I)
{
	const FSpirvPlace Place = Resolve(I.Operands[0]);
	const FArrayValue* const Value = IsLoopedCopy(Place) ? FindArrayValue(I.Operands[1]) : nullptr;
	if (!Value)
	{
		return false;
	}
	Use({"", ESpirvType::Float, Value->bVarying, Value->Local});
	const FSpirvVariable& Variable = *Place.Variable;
	const uint32_t Size = uint32_t(Place.Scalars.size());
	const bool bVarying = Variable.Storage == StorageOutput || Uniformity.IsVariableVarying(Variable.Id);
	const bool bMasked = bVarying && Uniformity.IsDivergentBlock(CurrentBlock);
	for (const auto& [Kind, Name] : Value->Names)
	{
		const std::string From = Name + "[" + std::to_string(Value->Offset) + " + k]";
		const std::string New = UseAs({From, Kind, Value->bVarying, -1}, Kind, bVarying);
		bool bIndexVaries = false;
		const std::string Array = LocalArray(Variable, Kind);
		const std::string Index = IndexText(Place, std::to_string(Place.Offset) + " + k", bIndexVaries);
		const std::string Target = Array + "[" + Index + "]";
		Line(LoopHead(Size) + (bIndexVaries ? "PutElement(e, " + Array + ", " + Index + ", " + New + ");"
								  : bMasked ? "Assign(e, " + Target + ", " + New + ");"
											: Target + " = " + New + ";"));
	}
	return true;
}

} // namespace Drydock
