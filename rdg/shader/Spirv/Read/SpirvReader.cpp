// Words to FSpirvModule. Every access to a word is checked; every id is checked by SpirvChecker.cpp afterwards.
// Source: Khronos, SPIR-V specification 1.0.
#include "SpirvReaderImpl.h"

#include "ShaderKernel.h"
#include "SpirvAliases.h"
#include "SpirvCheck.h"
#include "SpirvCounters.h"
#include "SpirvLayout.h"
#include "SpirvLimits.h"
#include "SpirvQuads.h"
#include "SpirvRefusals.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint32_t GeneratorGlslang = 8; // Khronos' register of generators
constexpr uint32_t InclusiveScan = 1;
constexpr uint32_t ExclusiveScan = 2;

} // namespace

void FSpirvReader::CheckId(uint32_t Id) const
{
	if (Id == 0 || Id >= Module.Bound)
	{
		throw FSpirvError("SPIR-V: id " + std::to_string(Id) + " is out of bounds");
	}
}

void FSpirvReader::DefineValue(uint32_t Id, uint32_t Type)
{
	CheckId(Id);
	Module.GetType(Type);
	if (!Module.ValueTypes.emplace(Id, Type).second)
	{
		throw FSpirvError("SPIR-V: id " + std::to_string(Id) + " is defined twice");
	}
}

void FSpirvReader::ReadInOtherFunction(uint16_t Op, FSpirvOperands& Operands)
{
	OpsOfOtherFunction.push_back(Op);
	if (!Module.RefusedElsewhere.Message.empty() || Op == OpLabel)
	{
		return;
	}
	const std::vector<uint32_t> Words = Operands.Rest(); // type and result first, where there are any
	std::string Message;
	if (Op == OpLoad && Words.size() > 2)
	{
		const auto Found = Decorations.find(Words[2]);
		const bool bBuiltIn = Found != Decorations.end() && Found->second.Values.count(DecorationBuiltIn);
		Message = bBuiltIn ? ExplainRefusedBuiltIn(Found->second.Values.at(DecorationBuiltIn)) : std::string();
	}
	else if (Words.size() >= 2 && !RunsTogether(Module.ExecutionModel, Op))
	{
		Message = ExplainRefusedOp(Op, Words.data() + 2, Words.size() - 2);
	}
	Module.RefusedElsewhere = {Message, CurrentFile, CurrentLine};
}

void FSpirvReader::CheckTypeFaults(const FSpirvInstruction& Instruction) const
{
	const auto Check = [this, &Instruction](uint32_t Type)
	{
		const auto Fault = TypeFaults.find(Type);
		if (Fault != TypeFaults.end())
		{
			Fault->second.Throw(Module.Files[Instruction.File], Instruction.Line);
		}
	};
	Check(Instruction.Type);
	for (const uint32_t Operand : Instruction.Operands)
	{
		const auto Value = Module.ValueTypes.find(Operand);
		Check(Value == Module.ValueTypes.end() ? 0 : Value->second);
	}
}

void FSpirvReader::CountInstruction(const FSpirvInstruction& Instruction)
{
	if (++NumInstructions > SpirvLimits::MaxInstructions)
	{
		Module.FailLimit(SpirvLimits::MaxInstructions, "instructions when all calls are inlined",
			"do less in one pass, or write what is unrolled as a loop", &Instruction);
	}
	NumValueScalars += Instruction.Result ? Module.GetType(Instruction.Type).NumScalars : 0;
	if (NumValueScalars > SpirvLimits::MaxValueScalars)
	{
		Module.FailLimit(SpirvLimits::MaxValueScalars, "numbers in all its intermediate results",
			"pass large arrays and structs less often, or put them into a buffer", &Instruction);
	}
}

void FSpirvReader::BeginFunction(FSpirvOperands& Operands)
{
	const uint32_t Type = Operands.Next();
	if (CurrentFunction)
	{
		throw FSpirvError("SPIR-V: a function inside a function");
	}
	CurrentFunction = Operands.Next();
	CheckId(CurrentFunction);
	CurrentFile = 0;
	CurrentLine = 0;
	OpsOfOtherFunction.clear();
	// "@F(f1;" is F(float) behind the front end's own entry point.
	std::string& Name = Module.FunctionNames[CurrentFunction];
	Name = Names[CurrentFunction].substr(0, Names[CurrentFunction].find('('));
	std::erase(Name, '@');
	if (bWhole)
	{
		const bool bFrontEnds = CurrentFunction == EntryPoint;
		Module.Functions.push_back(
			{CurrentFunction, Type, bFrontEnds ? std::string() : Name, {}, uint32_t(Module.Blocks.size()), 0});
	}
}

void FSpirvReader::EndFunction()
{
	if (OpsOfOtherFunction == std::vector<uint16_t>{OpLabel, OpKill})
	{
		Module.KillFunctions.push_back(CurrentFunction);
	}
	if (bBlockOpen)
	{
		throw FSpirvError("SPIR-V: a function ends inside a block");
	}
	if (bWhole && CurrentFunction)
	{
		Module.Functions.back().NumBlocks = uint32_t(Module.Blocks.size()) - Module.Functions.back().FirstBlock;
	}
	CurrentFunction = 0;
}

/** A chain that starts where another one ends starts at that one's variable: all later stages know one step only. */
void FSpirvReader::FlattenChain(FSpirvInstruction& Chain)
{
	if (Chain.Operands.empty())
	{
		return;
	}
	const auto Before = Chains.find(Chain.Operands[0]);
	if (Before != Chains.end())
	{
		std::vector<uint32_t> Whole = Before->second;
		Whole.insert(Whole.end(), Chain.Operands.begin() + 1, Chain.Operands.end());
		if (Whole.size() > size_t(SpirvLimits::MaxTypeDepth) + 2)
		{
			Module.FailLimit(
				SpirvLimits::MaxTypeDepth, "levels of structs and arrays in a pointer", "use fewer levels");
		}
		Chain.Operands = std::move(Whole);
	}
	Chains[Chain.Result] = Chain.Operands;
}

void FSpirvReader::BeginBlock(uint32_t Label)
{
	CheckId(Label);
	if (bBlockOpen || !Module.BlockIndex.emplace(Label, uint32_t(Module.Blocks.size())).second)
	{
		throw FSpirvError("SPIR-V: block " + std::to_string(Label) + " is malformed");
	}
	Module.Blocks.push_back({Label, {}, 0, 0});
	bBlockOpen = true;
}

FSpirvInstruction FSpirvReader::MakeInstruction(uint16_t Op, FSpirvOperands& Operands) const
{
	FSpirvInstruction Instruction;
	Instruction.Op = Op;
	Instruction.File = CurrentFile;
	Instruction.Line = CurrentLine;
	const bool bNoResult = IsSpirvTerminator(Op) || Op == OpStore || Op == OpImageWrite || Op == OpControlBarrier ||
						   Op == OpMemoryBarrier || Op == OpAtomicStore || Op == OpDemote;
	if (!bNoResult)
	{
		Instruction.Type = Operands.Next();
		Instruction.Result = Operands.Next();
	}
	Instruction.Operands = Operands.Rest();
	if (HasGroupOperation(Op) && bGlslang && Instruction.Operands.size() > 1 &&
		Instruction.Operands[1] == InclusiveScan)
	{
		Instruction.Operands[1] = ExclusiveScan; // glslang takes WavePrefix* for the other kind of prefix
	}
	return Instruction;
}

void FSpirvReader::ReadInFunction(uint16_t Op, FSpirvOperands& Operands)
{
	if (Op == OpFunctionParameter && bWhole)
	{
		const uint32_t Type = Operands.Next();
		Module.Functions.back().Parameters.push_back(Operands.Next());
		DefineValue(Module.Functions.back().Parameters.back(), Type);
		return;
	}
	if (CurrentFunction != EntryPoint && !bWhole)
	{
		ReadInOtherFunction(Op, Operands);
		return;
	}
	if (Op == OpLabel)
	{
		BeginBlock(Operands.Next());
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
	FSpirvInstruction Instruction = MakeInstruction(Op, Operands);
	if (Op == OpAccessChain || Op == OpInBoundsAccessChain)
	{
		FlattenChain(Instruction);
	}
	if (!TypeFaults.empty())
	{
		CheckTypeFaults(Instruction);
	}
	if (Op == OpExtInst && (Instruction.Operands.size() < 2 || Instruction.Operands[0] != GlslImport))
	{
		throw FSpirvError("printf and other extensions are not supported on the CPU tier; leave them out",
			Module.Files[CurrentFile], CurrentLine);
	}
	if (Instruction.Result)
	{
		DefineValue(Instruction.Result, Instruction.Type);
	}
	CountInstruction(Instruction);
	if (Op == OpUndef)
	{
		const uint32_t NumScalars = Module.GetType(Instruction.Type).NumScalars;
		Module.Constants[Instruction.Result] = {Instruction.Type, std::vector<uint64_t>(NumScalars, 0)};
		return;
	}
	Block.Instructions.push_back(std::move(Instruction));
	bBlockOpen = !IsSpirvTerminator(Op);
}

void FSpirvReader::ReadName(uint16_t Op, FSpirvOperands& Operands)
{
	const uint32_t Id = Operands.Next();
	const uint32_t Member = Op == OpMemberName ? Operands.Next() : 0;
	std::string& Name = Op == OpName ? Names[Id] : Op == OpString ? Strings[Id] : MemberNames[{Id, Member}];
	Name = Operands.NextString();
}

void FSpirvReader::ReadLine(uint16_t Op, FSpirvOperands& Operands)
{
	if (Op == OpNoLine)
	{
		CurrentFile = 0;
		CurrentLine = 0;
		return;
	}
	const uint32_t File = Operands.Next();
	if (Strings[File] != GSpirvFileOfCallers)
	{
		CurrentFile = FindFile(File);
		CurrentLine = int(std::min<uint32_t>(Operands.Next(), 1u << 30));
	}
}

void FSpirvReader::ReadInstruction(uint16_t Op, FSpirvOperands Operands)
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
	case OpMemberName:
	case OpString:
		ReadName(Op, Operands);
		return;
	case OpLine:
	case OpNoLine:
		ReadLine(Op, Operands);
		return;
	case OpDecorate:
	case OpMemberDecorate:
	case OpDecorateString:
	case OpMemberDecorateString:
	case OpDecorateId:
		ReadDecoration(Op, Operands);
		return;
	case OpFunction:
		BeginFunction(Operands);
		return;
	case OpFunctionEnd:
		EndFunction();
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

namespace
{

/** The front end takes structs of inputs and outputs apart, arrays in them too, and gives every element the semantic of
 * the whole: "In.UV[2]" at TEXCOORD1 is TEXCOORD3. */
std::string GetElementSemantic(const std::string& Semantic, const std::string& Name)
{
	constexpr size_t MaxDigits = 3;
	const size_t Open = Name.rfind('[');
	const size_t Digits = Semantic.find_last_not_of("0123456789") + 1;
	const bool bElement = Open != std::string::npos && Name.back() == ']' && Name.size() - Open - 2 <= MaxDigits &&
						  Name.find_first_not_of("0123456789", Open + 1) == Name.size() - 1 &&
						  Semantic.size() - Digits <= MaxDigits;
	if (!bElement || Semantic.empty())
	{
		return Semantic;
	}
	const int First = std::atoi(Semantic.c_str() + Digits);
	return Semantic.substr(0, Digits) + std::to_string(First + std::atoi(Name.c_str() + Open + 1));
}

} // namespace

void FSpirvReader::ReadWords()
{
	if (Words.size() < HeaderWords || Words[0] != Magic)
	{
		throw FSpirvError("SPIR-V: not a module");
	}
	Module.Bound = Words[3];
	bGlslang = Words[2] >> 16 == GeneratorGlslang;
	if (Module.Bound > SpirvLimits::MaxIds)
	{
		throw FSpirvError("SPIR-V: too many ids");
	}
	Module.Files.push_back("");
	for (size_t Position = HeaderWords; Position < Words.size();)
	{
		const uint32_t Length = Words[Position] >> 16;
		if (Length == 0 || Length > Words.size() - Position)
		{
			throw FSpirvError("SPIR-V: an instruction runs past the end");
		}
		ReadInstruction(uint16_t(Words[Position] & 0xffff), FSpirvOperands(&Words[Position] + 1, Length - 1));
		Position += Length;
	}
	if (bBlockOpen || CurrentFunction)
	{
		throw FSpirvError("SPIR-V: a block has no end");
	}
	if (!TypeFaults.empty())
	{
		TypeFaults.begin()->second.Throw();
	}
}

void FSpirvReader::DecorateTypes()
{
	for (auto& [Id, Type] : Module.Types)
	{
		Type.Name = Names[Id];
		const FSpirvDecorations& Found = Decorations[Id];
		Type.bBlock = Found.Has(DecorationBlock);
		Type.bBufferBlock = Found.Has(DecorationBufferBlock);
		Type.ArrayStride = Found.Get(DecorationArrayStride);
		for (uint32_t i = 0; i < Type.Members.size(); ++i)
		{
			FSpirvMember& Member = Type.Members[i];
			const FSpirvDecorations& OfMember = MemberDecorations[{Id, i}];
			Member.Name = MemberNames[{Id, i}];
			Member.Offset = OfMember.Get(DecorationOffset);
			Member.MatrixStride = OfMember.Get(DecorationMatrixStride);
			Member.bRowMajor = OfMember.Has(DecorationRowMajor);
			Member.bNonWritable = OfMember.Has(DecorationNonWritable);
		}
	}
}

void FSpirvReader::DecorateVariables()
{
	for (FSpirvVariable& Variable : Module.Variables)
	{
		const FSpirvDecorations& Found = Decorations[Variable.Id];
		Variable.Name = GetViewedBuffer(Names[Variable.Id]);
		Variable.Semantic = GetElementSemantic(Found.Semantic, Variable.Name);
		Variable.BuiltIn = Found.Get(DecorationBuiltIn, BuiltInNone);
		Variable.Location =
			Variable.BuiltIn == BuiltInFragDepth ? uint32_t(GDepthTarget) : Found.Get(DecorationLocation);
		Variable.Counter = Found.Get(DecorationCounterBuffer);
	}
}

FSpirvModule FSpirvReader::Read()
{
	ReadWords();
	DecorateTypes();
	DecorateVariables();
	MakeCountersBuffers(Module);
	Module.EntryFunction = EntryPoint;
	if (bWhole)
	{
		Module.Names.insert(Names.begin(), Names.end());
	}
	else
	{
		CheckSpirv(Module);
	}
	ApplyD3DLayout(Module);
	RunByQuadsWhereUsed(Module);
	return std::move(Module);
}

FSpirvModule ReadSpirv(const std::vector<uint32_t>& Words)
{
	return FSpirvReader(Words, false).Read();
}

FSpirvModule ReadWholeSpirv(const std::vector<uint32_t>& Words)
{
	return FSpirvReader(Words, true).Read();
}

} // namespace Drydock
