// Words to FSpirvModule. Every access to a word is checked; every id is checked by SpirvCheck.cpp afterwards.
// Source: Khronos, SPIR-V specification 1.0.
#include "SpirvModule.h"

#include "SpirvCheck.h"
#include "SpirvLayout.h"

#include <map>

namespace Drydock
{

namespace
{

using namespace Spirv;

constexpr uint32_t MaxBound = 1u << 22;
constexpr uint32_t MaxScalars = 1u << 16; // of one value
constexpr int MaxTypeDepth = 32;

/** The operands of one instruction, read in order. */
class FOperands
{
public:
	FOperands(const uint32_t* InWords, size_t InCount) : Words(InWords), Count(InCount) {}

	uint32_t Next()
	{
		if (Position >= Count)
		{
			throw FSpirvError("SPIR-V: an instruction is too short");
		}
		return Words[Position++];
	}

	std::string NextString()
	{
		std::string Result;
		for (;;)
		{
			const uint32_t Word = Next();
			for (int i = 0; i < 4; ++i)
			{
				const char c = char(Word >> (8 * i));
				if (!c)
				{
					return Result;
				}
				Result += c;
			}
		}
	}

	std::vector<uint32_t> Rest()
	{
		std::vector<uint32_t> Result(Words + Position, Words + Count);
		Position = Count;
		return Result;
	}

	bool AtEnd() const { return Position >= Count; }

private:
	const uint32_t* Words;
	size_t Count;
	size_t Position = 0;
};

struct FDecorations
{
	std::map<uint32_t, uint32_t> Values; // decoration -> first literal
	std::string Semantic;
};

class FReader
{
public:
	explicit FReader(const std::vector<uint32_t>& InWords) : Words(InWords) {}

	FSpirvModule Read();

private:
	void ReadInstruction(uint16_t Op, FOperands Operands);
	void ReadDecoration(uint16_t Op, FOperands& Operands);
	void ReadType(uint16_t Op, FOperands& Operands);
	void ReadConstant(uint16_t Op, FOperands& Operands);
	void ReadVariable(FOperands& Operands, bool bInFunction);
	void ReadInFunction(uint16_t Op, FOperands& Operands);
	void DefineType(uint32_t Id, FSpirvType Type);
	void DefineValue(uint32_t Id, uint32_t Type);
	void CheckId(uint32_t Id) const;
	uint32_t FindFile(uint32_t StringId);

	const std::vector<uint32_t>& Words;
	FSpirvModule Module;
	std::map<uint32_t, std::string> Names;
	std::map<std::pair<uint32_t, uint32_t>, std::string> MemberNames;
	std::map<uint32_t, std::string> Strings;
	std::map<uint32_t, uint32_t> FileOfString;
	std::map<uint32_t, FDecorations> Decorations;
	std::map<std::pair<uint32_t, uint32_t>, FDecorations> MemberDecorations;
	std::map<uint32_t, int> TypeDepths;
	uint32_t EntryPoint = 0;
	uint32_t GlslImport = 0;
	uint32_t CurrentFunction = 0;
	std::vector<uint16_t> OpsOfOtherFunction; // of the current one, when it is not the entry point
	uint32_t CurrentFile = 0;
	int CurrentLine = 0;
	bool bBlockOpen = false;
};

void FReader::CheckId(uint32_t Id) const
{
	if (Id == 0 || Id >= Module.Bound)
	{
		throw FSpirvError("SPIR-V: id " + std::to_string(Id) + " is out of bounds");
	}
}

void FReader::DefineValue(uint32_t Id, uint32_t Type)
{
	CheckId(Id);
	Module.GetType(Type);
	if (!Module.ValueTypes.emplace(Id, Type).second)
	{
		throw FSpirvError("SPIR-V: id " + std::to_string(Id) + " is defined twice");
	}
}

void FReader::DefineType(uint32_t Id, FSpirvType Type)
{
	CheckId(Id);
	int Depth = 0;
	const auto Contains = [this, &Depth](uint32_t Part) -> const FSpirvType&
	{
		const FSpirvType& Found = Module.GetType(Part); // must be defined already, so types cannot contain themselves
		Depth = std::max(Depth, TypeDepths[Part] + 1);
		return Found;
	};
	uint64_t NumScalars = 0;
	switch (Type.Kind)
	{
	case ESpirvType::Bool:
	case ESpirvType::Int:
	case ESpirvType::Uint:
	case ESpirvType::Float:
		NumScalars = 1;
		break;
	case ESpirvType::Vector:
	case ESpirvType::Matrix:
	case ESpirvType::Array:
	{
		const FSpirvType& Element = Contains(Type.Element);
		const bool bScalar = Element.Kind >= ESpirvType::Bool && Element.Kind <= ESpirvType::Float;
		const bool bFits = Type.Kind == ESpirvType::Vector ? bScalar && Type.Count >= 2 && Type.Count <= 4
			: Type.Kind == ESpirvType::Matrix ? Element.Kind == ESpirvType::Vector && Type.Count >= 2 && Type.Count <= 4
											  : Type.Count >= 1;
		if (!bFits)
		{
			throw FSpirvError("SPIR-V: type " + std::to_string(Id) + " is malformed");
		}
		NumScalars = uint64_t(Element.NumScalars) * Type.Count;
		break;
	}
	case ESpirvType::Struct:
	{
		bool bFlat = true;
		for (const FSpirvMember& Member : Type.Members)
		{
			const uint32_t Size = Contains(Member.Type).NumScalars;
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
		break;
	}
	if (NumScalars > MaxScalars || Depth > MaxTypeDepth)
	{
		throw FSpirvError("SPIR-V: type " + std::to_string(Id) + " is too large");
	}
	Type.NumScalars = uint32_t(NumScalars);
	TypeDepths[Id] = Depth;
	if (!Module.Types.emplace(Id, std::move(Type)).second)
	{
		throw FSpirvError("SPIR-V: type " + std::to_string(Id) + " is defined twice");
	}
}

void FReader::ReadType(uint16_t Op, FOperands& Operands)
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
	{
		const uint32_t Width = Operands.Next();
		Type.Kind = Operands.Next() ? ESpirvType::Int : ESpirvType::Uint;
		if (Width != 32)
		{
			throw FSpirvError("integers of " + std::to_string(Width) + " bits are not supported on the CPU tier; use int or uint");
		}
		break;
	}
	case OpTypeFloat:
	{
		const uint32_t Width = Operands.Next();
		Type.Kind = ESpirvType::Float;
		if (Width != 32)
		{
			throw FSpirvError("floats of " + std::to_string(Width) + " bits are not supported on the CPU tier; use float "
							  "(run with --precision double for 64-bit arithmetic)");
		}
		break;
	}
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

void FReader::ReadConstant(uint16_t Op, FOperands& Operands)
{
	FSpirvConstant Constant;
	Constant.Type = Operands.Next();
	const uint32_t Id = Operands.Next();
	const FSpirvType& Type = Module.GetType(Constant.Type);
	switch (Op)
	{
	case OpConstantTrue:
	case OpConstantFalse:
		Constant.Scalars = {Op == OpConstantTrue ? 1u : 0u};
		break;
	case OpConstant:
		Constant.Scalars = {Operands.Next()};
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
	if (Type.NumScalars == 0 || Constant.Scalars.size() != Type.NumScalars)
	{
		throw FSpirvError("SPIR-V: constant " + std::to_string(Id) + " does not fit its type");
	}
	DefineValue(Id, Constant.Type);
	Module.Constants.emplace(Id, std::move(Constant));
}

void FReader::ReadVariable(FOperands& Operands, bool bInFunction)
{
	const uint32_t PointerType = Operands.Next();
	FSpirvVariable Variable;
	Variable.Id = Operands.Next();
	Variable.Storage = Operands.Next();
	Variable.Initializer = Operands.AtEnd() ? 0 : Operands.Next();
	const FSpirvType& Pointer = Module.GetType(PointerType);
	if (Pointer.Kind != ESpirvType::Pointer || Pointer.Storage != Variable.Storage
		|| bInFunction != (Variable.Storage == StorageFunction))
	{
		throw FSpirvError("SPIR-V: variable " + std::to_string(Variable.Id) + " is malformed");
	}
	Variable.Type = Pointer.Element;
	if (Variable.Initializer)
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

void FReader::ReadDecoration(uint16_t Op, FOperands& Operands)
{
	const uint32_t Target = Operands.Next();
	const bool bMember = Op == OpMemberDecorate || Op == OpMemberDecorateString;
	FDecorations& Found = bMember ? MemberDecorations[{Target, Operands.Next()}] : Decorations[Target];
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

uint32_t FReader::FindFile(uint32_t StringId)
{
	const auto [Found, bNew] = FileOfString.emplace(StringId, uint32_t(Module.Files.size()));
	if (bNew)
	{
		Module.Files.push_back(Strings[StringId]);
	}
	return Found->second;
}

void FReader::ReadInFunction(uint16_t Op, FOperands& Operands)
{
	if (CurrentFunction != EntryPoint)
	{
		OpsOfOtherFunction.push_back(Op);
		return;
	}
	if (Op == OpLabel)
	{
		const uint32_t Label = Operands.Next();
		CheckId(Label);
		if (bBlockOpen || !Module.BlockIndex.emplace(Label, uint32_t(Module.Blocks.size())).second)
		{
			throw FSpirvError("SPIR-V: block " + std::to_string(Label) + " is malformed");
		}
		Module.Blocks.push_back({Label, {}, 0, 0});
		bBlockOpen = true;
		return;
	}
	if (!bBlockOpen)
	{
		throw FSpirvError("SPIR-V: " + GetSpirvOpName(Op) + " stands outside of a block");
	}
	FSpirvBlock& Block = Module.Blocks.back();
	if (Op == OpVariable)
	{
		ReadVariable(Operands, true);
		return;
	}
	if (Op == OpSelectionMerge || Op == OpLoopMerge)
	{
		if (Block.Merge)
		{
			throw FSpirvError("SPIR-V: two merge instructions in one block");
		}
		Block.Merge = Operands.Next();
		Block.Continue = Op == OpLoopMerge ? Operands.Next() : 0;
		return;
	}
	FSpirvInstruction Instruction;
	Instruction.Op = Op;
	Instruction.File = CurrentFile;
	Instruction.Line = CurrentLine;
	const bool bTerminator = (Op >= OpBranch && Op <= OpUnreachable);
	const bool bNoResult = bTerminator || Op == OpStore || Op == OpImageWrite || Op == OpControlBarrier || Op == OpMemoryBarrier;
	if (!bNoResult)
	{
		Instruction.Type = Operands.Next();
		Instruction.Result = Operands.Next();
	}
	Instruction.Operands = Operands.Rest();
	if (Op == OpExtInst && (Instruction.Operands.size() < 2 || Instruction.Operands[0] != GlslImport))
	{
		throw FSpirvError("SPIR-V: an instruction of an unknown extended set", Module.Files[CurrentFile], CurrentLine);
	}
	if (Instruction.Result)
	{
		DefineValue(Instruction.Result, Instruction.Type);
	}
	if (Op == OpUndef)
	{
		const uint32_t NumScalars = Module.GetType(Instruction.Type).NumScalars;
		Module.Constants[Instruction.Result] = {Instruction.Type, std::vector<uint32_t>(NumScalars, 0)};
		return;
	}
	Block.Instructions.push_back(std::move(Instruction));
	bBlockOpen = !bTerminator;
}

void FReader::ReadInstruction(uint16_t Op, FOperands Operands)
{
	switch (Op)
	{
	case OpNop:
	case OpSource:
	case OpSourceContinued:
	case OpSourceExtension:
	case OpExtension:
	case OpCapability:
	case OpMemoryModel:
	case OpModuleProcessed:
		return;
	case OpExtInstImport:
	{
		const uint32_t Id = Operands.Next();
		if (Operands.NextString() == "GLSL.std.450")
		{
			GlslImport = Id;
		}
		return;
	}
	case OpEntryPoint:
		Module.ExecutionModel = Operands.Next();
		EntryPoint = Operands.Next();
		return;
	case OpExecutionMode:
		Operands.Next();
		if (Operands.Next() == ExecutionModeLocalSize)
		{
			for (uint32_t& Size : Module.LocalSize)
			{
				Size = Operands.Next();
			}
		}
		return;
	case OpName:
	{
		const uint32_t Id = Operands.Next();
		Names[Id] = Operands.NextString();
		return;
	}
	case OpMemberName:
	{
		const uint32_t Id = Operands.Next();
		const uint32_t Member = Operands.Next();
		MemberNames[{Id, Member}] = Operands.NextString();
		return;
	}
	case OpString:
	{
		const uint32_t Id = Operands.Next();
		Strings[Id] = Operands.NextString();
		return;
	}
	case OpLine:
		CurrentFile = FindFile(Operands.Next());
		CurrentLine = int(std::min<uint32_t>(Operands.Next(), 1u << 30));
		return;
	case OpNoLine:
		CurrentFile = 0;
		CurrentLine = 0;
		return;
	case OpDecorate:
	case OpMemberDecorate:
	case OpDecorateString:
	case OpMemberDecorateString:
		ReadDecoration(Op, Operands);
		return;
	case OpFunction:
		Operands.Next();
		if (CurrentFunction)
		{
			throw FSpirvError("SPIR-V: a function inside a function");
		}
		CurrentFunction = Operands.Next();
		CheckId(CurrentFunction);
		OpsOfOtherFunction.clear();
		return;
	case OpFunctionEnd:
		if (OpsOfOtherFunction == std::vector<uint16_t>{OpLabel, OpKill})
		{
			Module.KillFunctions.push_back(CurrentFunction);
		}
		if (bBlockOpen)
		{
			throw FSpirvError("SPIR-V: a function ends inside a block");
		}
		CurrentFunction = 0;
		return;
	default:
		break;
	}
	if (CurrentFunction)
	{
		ReadInFunction(Op, Operands);
	}
	else if (Op >= OpTypeVoid && Op <= OpTypeFunction)
	{
		ReadType(Op, Operands);
	}
	else if ((Op >= OpConstantTrue && Op <= OpConstantNull) || Op == OpUndef)
	{
		ReadConstant(Op, Operands);
	}
	else if (Op == OpVariable)
	{
		ReadVariable(Operands, false);
	}
	else
	{
		throw FSpirvError("SPIR-V: " + GetSpirvOpName(Op) + " is not known at module scope");
	}
}

FSpirvModule FReader::Read()
{
	if (Words.size() < 5 || Words[0] != Magic)
	{
		throw FSpirvError("SPIR-V: not a module");
	}
	Module.Bound = Words[3];
	if (Module.Bound > MaxBound)
	{
		throw FSpirvError("SPIR-V: too many ids");
	}
	Module.Files.push_back("");
	for (size_t Position = 5; Position < Words.size();)
	{
		const uint32_t Length = Words[Position] >> 16;
		if (Length == 0 || Length > Words.size() - Position)
		{
			throw FSpirvError("SPIR-V: an instruction runs past the end");
		}
		ReadInstruction(uint16_t(Words[Position] & 0xffff), FOperands(&Words[Position] + 1, Length - 1));
		Position += Length;
	}
	if (bBlockOpen || CurrentFunction)
	{
		throw FSpirvError("SPIR-V: a block has no end");
	}

	for (auto& [Id, Type] : Module.Types)
	{
		Type.Name = Names[Id];
		const std::map<uint32_t, uint32_t>& Values = Decorations[Id].Values;
		Type.bBlock = Values.count(DecorationBlock) != 0;
		Type.bBufferBlock = Values.count(DecorationBufferBlock) != 0;
		const auto Stride = Values.find(DecorationArrayStride);
		Type.ArrayStride = Stride == Values.end() ? 0 : Stride->second;
		for (uint32_t i = 0; i < Type.Members.size(); ++i)
		{
			FSpirvMember& Member = Type.Members[i];
			const std::map<uint32_t, uint32_t>& OfMember = MemberDecorations[{Id, i}].Values;
			const auto Get = [&OfMember](uint32_t Decoration)
			{
				const auto Found = OfMember.find(Decoration);
				return Found == OfMember.end() ? 0 : Found->second;
			};
			Member.Name = MemberNames[{Id, i}];
			Member.Offset = Get(DecorationOffset);
			Member.MatrixStride = Get(DecorationMatrixStride);
			Member.bRowMajor = OfMember.count(DecorationRowMajor) != 0;
			Member.bNonWritable = OfMember.count(DecorationNonWritable) != 0;
		}
	}
	for (FSpirvVariable& Variable : Module.Variables)
	{
		const FDecorations& Found = Decorations[Variable.Id];
		const auto Get = [&Found](uint32_t Decoration, uint32_t Default)
		{
			const auto Value = Found.Values.find(Decoration);
			return Value == Found.Values.end() ? Default : Value->second;
		};
		Variable.Name = Names[Variable.Id];
		Variable.Semantic = Found.Semantic;
		Variable.BuiltIn = Get(DecorationBuiltIn, BuiltInNone);
		Variable.Location = Get(DecorationLocation, 0);
	}
	CheckSpirv(Module);
	ApplyD3DLayout(Module);
	return std::move(Module);
}

} // namespace

FSpirvModule ReadSpirv(const std::vector<uint32_t>& Words)
{
	return FReader(Words).Read();
}

} // namespace Drydock
