// The reader's state. SpirvReader.cpp: the module and its function; SpirvReaderTypes.cpp: types, constants, variables.
#pragma once

#include "SpirvModule.h"

#include <map>

namespace Drydock
{

/** The operands of one instruction, read in order. */
class FSpirvOperands
{
public:
	FSpirvOperands(const uint32_t* InWords, size_t InCount)
		: Words(InWords)
		, Count(InCount)
	{
	}

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

/** A type that cannot be used. It is reported where the shader first uses it, which has a line. */
struct FSpirvTypeFault
{
	std::string Message;
	bool bLimit = false;

	[[noreturn]] void Throw(const std::string& File = {}, int Line = 0) const
	{
		if (bLimit)
		{
			throw FSpirvLimitError(Message, File, Line);
		}
		throw FSpirvError(Message, File, Line);
	}
};

struct FSpirvDecorations
{
	std::map<uint32_t, uint32_t> Values; // decoration -> first literal
	std::string Semantic;

	bool Has(uint32_t Decoration) const { return Values.count(Decoration) != 0; }
	uint32_t Get(uint32_t Decoration, uint32_t Default = 0) const
	{
		const auto Found = Values.find(Decoration);
		return Found == Values.end() ? Default : Found->second;
	}
};

class FSpirvReader
{
public:
	FSpirvReader(const std::vector<uint32_t>& InWords, bool bInWhole)
		: Words(InWords)
		, bWhole(bInWhole)
	{
	}

	FSpirvModule Read();

private:
	void ReadWords();
	void DecorateTypes();
	void DecorateVariables();
	void ReadName(uint16_t Op, FSpirvOperands& Operands);
	void ReadLine(uint16_t Op, FSpirvOperands& Operands);
	void ReadInstruction(uint16_t Op, FSpirvOperands Operands);
	void ReadDecoration(uint16_t Op, FSpirvOperands& Operands);
	void ReadType(uint16_t Op, FSpirvOperands& Operands);
	void ReadConstant(uint16_t Op, FSpirvOperands& Operands);
	void ReadVariable(FSpirvOperands& Operands, bool bInFunction);
	void BeginFunction(FSpirvOperands& Operands);
	void EndFunction();
	void ReadInFunction(uint16_t Op, FSpirvOperands& Operands);
	void BeginBlock(uint32_t Label);
	FSpirvInstruction MakeInstruction(uint16_t Op, FSpirvOperands& Operands) const;
	ESpirvType ReadNumberType(uint16_t Op, uint32_t Id, FSpirvOperands& Operands);
	void CheckElement(uint32_t Id, const FSpirvType& Type, const FSpirvType& Element);
	void DefineType(uint32_t Id, FSpirvType Type);
	void DefineValue(uint32_t Id, uint32_t Type);
	void CheckId(uint32_t Id) const;
	void CheckTypeFaults(const FSpirvInstruction& Instruction) const;
	void ReadInOtherFunction(uint16_t Op, FSpirvOperands& Operands);
	void CountInstruction(const FSpirvInstruction& Instruction);
	uint32_t FindFile(uint32_t StringId);
	void FlattenChain(FSpirvInstruction& Chain);

	const std::vector<uint32_t>& Words;
	const bool bWhole;
	FSpirvModule Module;
	std::map<uint32_t, std::string> Names;
	std::map<std::pair<uint32_t, uint32_t>, std::string> MemberNames;
	std::map<uint32_t, std::string> Strings;
	std::map<uint32_t, uint32_t> FileOfString;
	std::map<uint32_t, FSpirvDecorations> Decorations;
	std::map<std::pair<uint32_t, uint32_t>, FSpirvDecorations> MemberDecorations;
	std::map<uint32_t, int> TypeDepths;
	std::map<uint32_t, FSpirvTypeFault> TypeFaults;
	std::map<uint32_t, std::vector<uint32_t>> Chains; // operands, by result
	size_t NumInstructions = 0;
	size_t NumValueScalars = 0;
	size_t NumConstantScalars = 0;
	uint32_t EntryPoint = 0;
	uint32_t GlslImport = 0;
	uint32_t CurrentFunction = 0;
	std::vector<uint16_t> OpsOfOtherFunction; // of the current one, when it is not the entry point
	uint32_t CurrentFile = 0;
	int CurrentLine = 0;
	bool bBlockOpen = false;
	bool bGlslang = false;
};

} // namespace Drydock
