// Looks up types, values and constants of a module without running off an end, whatever the ids.
#include "SpirvModule.h"

#include <algorithm>

namespace Drydock
{

FSpirvError::FSpirvError(const std::string& Message, std::string InFile, int InLine)
	: std::runtime_error(Message)
	, File(std::move(InFile))
	, Line(InLine)
{
}

FSpirvError::~FSpirvError() = default;

FSpirvLimitError::~FSpirvLimitError() = default;

void FSpirvModule::Fail(const std::string& Message, const FSpirvInstruction* Where) const
{
	if (Where && Where->File < Files.size())
	{
		throw FSpirvError(Message, Files[Where->File], Where->Line);
	}
	throw FSpirvError(Message);
}

void FSpirvModule::FailLimit(
	size_t Limit, const std::string& What, const std::string& Advice, const FSpirvInstruction* Where) const
{
	const bool bKnown = Where && Where->File < Files.size();
	throw FSpirvLimitError(
		"the shader has more than " + std::to_string(Limit) + " " + What + ", which is drydock's limit; " + Advice,
		bKnown ? Files[Where->File] : std::string(), bKnown ? Where->Line : 0);
}

const FSpirvType& FSpirvModule::GetType(uint32_t Id) const
{
	const auto Found = Types.find(Id);
	if (Found == Types.end())
	{
		Fail("SPIR-V: id " + std::to_string(Id) + " is not a type");
	}
	return Found->second;
}

uint32_t FSpirvModule::GetValueTypeId(uint32_t Id) const
{
	const auto Found = ValueTypes.find(Id);
	if (Found == ValueTypes.end())
	{
		Fail("SPIR-V: id " + std::to_string(Id) + " is not a value");
	}
	return Found->second;
}

const FSpirvType& FSpirvModule::GetValueType(uint32_t Id) const
{
	return GetType(GetValueTypeId(Id));
}

const FSpirvBlock& FSpirvModule::GetBlock(uint32_t Label) const
{
	const auto Found = BlockIndex.find(Label);
	if (Found == BlockIndex.end())
	{
		Fail("SPIR-V: id " + std::to_string(Label) + " is not a block");
	}
	return Blocks[Found->second];
}

const FSpirvVariable* FSpirvModule::FindVariable(uint32_t Id) const
{
	const auto Found = VariableIndex.find(Id);
	return Found == VariableIndex.end() ? nullptr : &Variables[Found->second];
}

const FSpirvConstant* FSpirvModule::FindConstant(uint32_t Id) const
{
	const auto Found = Constants.find(Id);
	return Found == Constants.end() ? nullptr : &Found->second;
}

uint32_t FSpirvModule::GetConstantScalar(uint32_t Id) const
{
	const FSpirvConstant* Constant = FindConstant(Id);
	if (!Constant || Constant->Scalars.size() != 1)
	{
		Fail("SPIR-V: id " + std::to_string(Id) + " is not a scalar constant");
	}
	return uint32_t(Constant->Scalars[0]);
}

uint32_t FSpirvModule::GetMemberType(uint32_t Type, uint32_t Index) const
{
	const FSpirvType& T = GetType(Type);
	switch (T.Kind)
	{
	case ESpirvType::Struct:
		if (Index < T.Members.size())
		{
			return T.Members[Index].Type;
		}
		break;
	case ESpirvType::Vector:
	case ESpirvType::Matrix:
	case ESpirvType::Array:
		if (Index < T.Count)
		{
			return T.Element;
		}
		break;
	case ESpirvType::RuntimeArray:
		return T.Element;
	default:
		break;
	}
	Fail("SPIR-V: type " + std::to_string(Type) + " has no member " + std::to_string(Index));
}

FSpirvModule::FPart FSpirvModule::FindPart(uint32_t Type, const uint32_t* Begin, const uint32_t* End) const
{
	FPart Part{0, Type};
	for (const uint32_t* Index = Begin; Index != End; ++Index)
	{
		Part.Offset += GetMemberScalar(Part.Type, *Index);
		Part.Type = GetMemberType(Part.Type, *Index);
	}
	return Part;
}

uint32_t FSpirvModule::GetMemberScalar(uint32_t Type, uint32_t Index) const
{
	const FSpirvType& T = GetType(Type);
	const uint32_t MemberType = GetMemberType(Type, Index); // checks Index
	return T.Kind != ESpirvType::Struct ? Index * GetType(MemberType).NumScalars : T.MemberScalars[Index];
}

ESpirvType FSpirvModule::GetScalarKind(uint32_t Type, uint32_t Scalar) const
{
	const FSpirvType& T = GetType(Type);
	if (IsSpirvScalar(T.Kind))
	{
		return T.Kind;
	}
	switch (T.Kind)
	{
	case ESpirvType::Vector:
	case ESpirvType::Matrix:
	case ESpirvType::Array:
		if (const uint32_t Size = GetType(T.Element).NumScalars)
		{
			return GetScalarKind(T.Element, Scalar % Size);
		}
		break;
	case ESpirvType::Struct:
		if (Scalar < T.NumScalars)
		{
			// The last member that begins at Scalar or before it.
			const auto After = std::upper_bound(T.MemberScalars.begin(), T.MemberScalars.end(), Scalar);
			const size_t Index = size_t(After - T.MemberScalars.begin()) - 1;
			return GetScalarKind(T.Members[Index].Type, Scalar - T.MemberScalars[Index]);
		}
		break;
	default:
		break;
	}
	Fail("SPIR-V: type " + std::to_string(Type) + " is not numeric");
}

std::vector<uint32_t> GetSuccessors(const FSpirvInstruction& Terminator)
{
	std::vector<uint32_t> Result;
	const auto Add = [&Result](uint32_t Label)
	{
		if (std::find(Result.begin(), Result.end(), Label) == Result.end())
		{
			Result.push_back(Label);
		}
	};
	const std::vector<uint32_t>& Operands = Terminator.Operands;
	switch (Terminator.Op)
	{
	case Spirv::OpBranch:
		Add(Operands[0]);
		break;
	case Spirv::OpBranchConditional:
		Add(Operands[1]);
		Add(Operands[2]);
		break;
	case Spirv::OpSwitch:
		for (size_t i = 1; i < Operands.size(); i += 2)
		{
			Add(Operands[i]);
		}
		break;
	default:
		break;
	}
	return Result;
}

std::string GetSpirvOpName(uint16_t Op)
{
	return Op == Spirv::OpFunctionCall ? "OpFunctionCall" : "Op" + std::to_string(Op);
}

} // namespace Drydock
