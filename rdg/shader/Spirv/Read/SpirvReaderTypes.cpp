// Reads what a module declares outside its functions. Source: Khronos, SPIR-V specification 1.0.
#include "SpirvReaderImpl.h"

#include "SpirvLimits.h"
#include "SpirvRefusals.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

void FSpirvReader::ReadDecoration(uint16_t Op, FSpirvOperands& Operands)
{
	const uint32_t Target = Operands.Next();
	const bool bMember = Op == OpMemberDecorate || Op == OpMemberDecorateString;
	FSpirvDecorations& Found = bMember ? MemberDecorations[{Target, Operands.Next()}] : Decorations[Target];
	const uint32_t Decoration = Operands.Next();
	if (Op == OpDecorateString || Op == OpMemberDecorateString)
	{
		if (Decoration == DecorationUserSemantic)
		{
			Found.Semantic = Operands.NextString();
		}
		return;
	}
	Found.Values[Decoration] = Operands.AtEnd() ? 0 : Operands.Next();
}

uint32_t FSpirvReader::FindFile(uint32_t StringId)
{
	const auto [Found, bNew] = FileOfString.emplace(StringId, uint32_t(Module.Files.size()));
	if (bNew)
	{
		Module.Files.push_back(Strings[StringId]);
	}
	return Found->second;
}

/** Type is a vector, a matrix or an array. */
void FSpirvReader::CheckElement(uint32_t Id, const FSpirvType& Type, const FSpirvType& Element)
{
	const bool bScalar = IsSpirvScalar(Element.Kind);
	const bool bFits = Type.Kind == ESpirvType::Vector ? bScalar && Type.Count >= 1 && Type.Count <= 4
					   : Type.Kind == ESpirvType::Matrix
						   ? Element.Kind == ESpirvType::Vector && Type.Count >= 1 && Type.Count <= 4
						   : Type.Count >= 1;
	if (!bFits)
	{
		TypeFaults.emplace(Id, FSpirvTypeFault{"the type " + GetHlslTypeName(Module, Type) +
											   " is not supported on the CPU tier; vectors have 1 to 4 components, "
											   "matrices 1 to 4 rows and columns, "
											   "arrays at least one element"});
	}
}

void FSpirvReader::DefineType(uint32_t Id, FSpirvType Type)
{
	CheckId(Id);
	Type.Name = Names[Id];
	int Depth = 0;
	const auto Contains = [this, &Depth, Id](uint32_t Part) -> const FSpirvType&
	{
		const FSpirvType& Found = Module.GetType(Part); // must be defined already, so types cannot contain themselves
		Depth = std::max(Depth, TypeDepths[Part] + 1);
		const auto Fault = TypeFaults.find(Part);
		if (Fault != TypeFaults.end())
		{
			TypeFaults.emplace(Id, Fault->second);
		}
		return Found;
	};
	uint64_t NumScalars = 0;
	switch (Type.Kind)
	{
	case ESpirvType::Vector:
	case ESpirvType::Matrix:
	case ESpirvType::Array:
	{
		const FSpirvType& Element = Contains(Type.Element);
		CheckElement(Id, Type, Element);
		NumScalars = uint64_t(Element.NumScalars) * Type.Count;
		break;
	}
	case ESpirvType::Struct:
	{
		bool bFlat = true;
		for (const FSpirvMember& Member : Type.Members)
		{
			const uint32_t Size = Contains(Member.Type).NumScalars;
			Type.MemberScalars.push_back(uint32_t(NumScalars));
			bFlat = bFlat && Size != 0;
			NumScalars += Size;
		}
		NumScalars = bFlat ? NumScalars : 0;
		break;
	}
	case ESpirvType::RuntimeArray:
	case ESpirvType::SampledImage:
	case ESpirvType::Image:
	case ESpirvType::Pointer:
		Contains(Type.Element);
		break;
	default:
		NumScalars = IsSpirvScalar(Type.Kind) ? 1 : 0;
		break;
	}
	if (NumScalars > SpirvLimits::MaxTypeScalars)
	{
		TypeFaults.emplace(
			Id, FSpirvTypeFault{"the type " + GetHlslTypeName(Module, Type) + " has " + std::to_string(NumScalars) +
									" numbers, more than the " + std::to_string(SpirvLimits::MaxTypeScalars) +
									" that are drydock's limit; put a large array into a buffer or a texture",
					true});
		NumScalars = 0;
	}
	if (Depth > SpirvLimits::MaxTypeDepth)
	{
		Module.FailLimit(
			SpirvLimits::MaxTypeDepth, "levels of structs and arrays inside each other", "use fewer levels");
	}
	Type.NumScalars = uint32_t(NumScalars);
	TypeDepths[Id] = Depth;
	if (!Module.Types.emplace(Id, std::move(Type)).second)
	{
		throw FSpirvError("SPIR-V: type " + std::to_string(Id) + " is defined twice");
	}
}

ESpirvType FSpirvReader::ReadNumberType(uint16_t Op, uint32_t Id, FSpirvOperands& Operands)
{
	const uint32_t Width = Operands.Next();
	const bool bFloat = Op == OpTypeFloat;
	const bool bSigned = !bFloat && Operands.Next() != 0;
	const ESpirvType Real = Width == 64 ? ESpirvType::Double : Width == 16 ? ESpirvType::Half : ESpirvType::Float;
	const ESpirvType Signed = Width == 64 ? ESpirvType::Long : Width == 16 ? ESpirvType::Short : ESpirvType::Int;
	const ESpirvType Kind = bFloat ? Real : bSigned ? Signed : GetSpirvUnsigned(Signed);
	if (GetSpirvBytes(Kind) * 8 != Width)
	{
		const std::string Name = (bFloat ? "float" : bSigned ? "int" : "uint") + std::to_string(Width) + "_t";
		TypeFaults.emplace(
			Id, FSpirvTypeFault{Name + " is not supported on the CPU tier; use " + (bFloat ? "float" : "int or uint")});
	}
	return Kind;
}

void FSpirvReader::ReadType(uint16_t Op, FSpirvOperands& Operands)
{
	const uint32_t Id = Operands.Next();
	FSpirvType Type;
	switch (Op)
	{
	case OpTypeVoid:
		Type.Kind = ESpirvType::Void;
		break;
	case OpTypeBool:
		Type.Kind = ESpirvType::Bool;
		break;
	case OpTypeInt:
	case OpTypeFloat:
		Type.Kind = ReadNumberType(Op, Id, Operands);
		break;
	case OpTypeVector:
	case OpTypeMatrix:
		Type.Kind = Op == OpTypeVector ? ESpirvType::Vector : ESpirvType::Matrix;
		Type.Element = Operands.Next();
		Type.Count = Operands.Next();
		break;
	case OpTypeArray:
		Type.Kind = ESpirvType::Array;
		Type.Element = Operands.Next();
		Type.Count = Module.GetConstantScalar(Operands.Next());
		break;
	case OpTypeRuntimeArray:
		Type.Kind = ESpirvType::RuntimeArray;
		Type.Element = Operands.Next();
		break;
	case OpTypeStruct:
		Type.Kind = ESpirvType::Struct;
		for (const uint32_t Member : Operands.Rest())
		{
			Type.Members.push_back({Member, {}, 0, 0, false, false});
		}
		break;
	case OpTypePointer:
		Type.Kind = ESpirvType::Pointer;
		Type.Storage = Operands.Next();
		Type.Element = Operands.Next();
		break;
	case OpTypeImage:
		Type.Kind = ESpirvType::Image;
		Type.Element = Operands.Next();
		Type.Dim = Operands.Next();
		Operands.Next(); // depth comparison is told by the sampling instruction
		Type.bArrayed = Operands.Next() != 0;
		Type.bMultisampled = Operands.Next() != 0;
		Type.bStorageImage = Operands.Next() == 2;
		Type.Format = Operands.Next();
		break;
	case OpTypeSampler:
		Type.Kind = ESpirvType::Sampler;
		break;
	case OpTypeSampledImage:
		Type.Kind = ESpirvType::SampledImage;
		Type.Element = Operands.Next();
		break;
	case OpTypeFunction:
		Type.Kind = ESpirvType::Function;
		break;
	default:
		throw FSpirvError("SPIR-V: " + GetSpirvOpName(Op) + " declares a type that the CPU tier does not know");
	}
	DefineType(Id, std::move(Type));
}

void FSpirvReader::ReadConstant(uint16_t Op, FSpirvOperands& Operands)
{
	FSpirvConstant Constant;
	Constant.Type = Operands.Next();
	const uint32_t Id = Operands.Next();
	if (TypeFaults.count(Constant.Type))
	{
		DefineValue(Id, Constant.Type); // what uses it is refused
		return;
	}
	const FSpirvType& Type = Module.GetType(Constant.Type);
	switch (Op)
	{
	case OpConstantTrue:
	case OpConstantFalse:
		Constant.Scalars = {Op == OpConstantTrue ? 1u : 0u};
		break;
	case OpConstant:
		Constant.Scalars = {Operands.Next()};
		if (GetSpirvBytes(Type.Kind) == 8)
		{
			Constant.Scalars[0] |= uint64_t(Operands.Next()) << 32;
		}
		else if (GetSpirvBytes(Type.Kind) == 2)
		{
			Constant.Scalars[0] &= 0xFFFF;
		}
		break;
	case OpConstantComposite:
		for (const uint32_t Part : Operands.Rest())
		{
			const FSpirvConstant* Found = Module.FindConstant(Part);
			if (!Found || Constant.Scalars.size() + Found->Scalars.size() > Type.NumScalars)
			{
				throw FSpirvError("SPIR-V: constant " + std::to_string(Id) + " is malformed");
			}
			Constant.Scalars.insert(Constant.Scalars.end(), Found->Scalars.begin(), Found->Scalars.end());
		}
		break;
	default: // OpConstantNull, OpUndef: what is undefined is zero here
		Constant.Scalars.assign(Type.NumScalars, 0);
		break;
	}
	const bool bNowhere = Op == OpUndef && Type.Kind == ESpirvType::Pointer;
	if ((Type.NumScalars == 0 && !bNowhere) || Constant.Scalars.size() != Type.NumScalars)
	{
		throw FSpirvError("SPIR-V: constant " + std::to_string(Id) + " does not fit its type");
	}
	NumConstantScalars += Constant.Scalars.size();
	if (NumConstantScalars > SpirvLimits::MaxConstantScalars)
	{
		Module.FailLimit(SpirvLimits::MaxConstantScalars, "numbers in its constants", "put tables into a buffer");
	}
	DefineValue(Id, Constant.Type);
	Module.Constants.emplace(Id, std::move(Constant));
}

void FSpirvReader::ReadVariable(FSpirvOperands& Operands, bool bInFunction)
{
	const uint32_t PointerType = Operands.Next();
	FSpirvVariable Variable;
	Variable.Id = Operands.Next();
	Variable.Storage = Operands.Next();
	Variable.Initializer = Operands.AtEnd() ? 0 : Operands.Next();
	const FSpirvType& Pointer = Module.GetType(PointerType);
	if (Pointer.Kind != ESpirvType::Pointer || Pointer.Storage != Variable.Storage ||
		bInFunction != (Variable.Storage == StorageFunction))
	{
		throw FSpirvError("SPIR-V: variable " + std::to_string(Variable.Id) + " is malformed");
	}
	Variable.Type = Pointer.Element;
	if (Variable.Initializer && !TypeFaults.count(Variable.Type))
	{
		const FSpirvConstant* Initial = Module.FindConstant(Variable.Initializer);
		if (!Initial || Initial->Scalars.size() != Module.GetType(Variable.Type).NumScalars)
		{
			throw FSpirvError("SPIR-V: variable " + std::to_string(Variable.Id) + " has a malformed initial value");
		}
	}
	DefineValue(Variable.Id, PointerType);
	Module.VariableIndex.emplace(Variable.Id, uint32_t(Module.Variables.size()));
	Module.Variables.push_back(std::move(Variable));
}

} // namespace Drydock
