// Takes a module of SPIR-V apart as far as its entries and its source go; everything else is the reader's. Source of
// the numbers: Khronos, SPIR-V specification, sections 2.3 and 3.
#include "SpirvFile.h"

#include "Diagnostics.h"
#include "SpirvOps.h"

#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint32_t SwappedMagic = 0x03022307;

constexpr uint32_t OpExecutionModeId = 331;

struct FInstruction
{
	uint32_t Op = 0;
	size_t At = 0;
	size_t Size = 0; // words
};

/** The text that begins at a word; it ends with a zero byte. */
std::string ReadText(const std::vector<uint32_t>& Words, size_t At, size_t End)
{
	std::string Text;
	for (; At < End; ++At)
	{
		char Bytes[sizeof(uint32_t)];
		std::memcpy(Bytes, &Words[At], sizeof(Bytes));
		for (const char c : Bytes)
		{
			if (c == '\0')
			{
				return Text;
			}
			Text += c;
		}
	}
	return Text;
}

const char* GetModelName(uint32_t Model)
{
	return Model == 0 ? "vertex" : Model == 4 ? "pixel" : Model == 5 ? "compute" : "another stage";
}

class FSpirvFile
{
public:
	FSpirvFile(const std::string& Bytes, const FShaderCompileRequest& InRequest)
		: Request(InRequest)
		, Words(Bytes.size() / sizeof(uint32_t))
	{
		if (Bytes.size() % sizeof(uint32_t) != 0 || Words.size() < HeaderWords)
		{
			throw MakeError(6004, "this file is not SPIR-V: it has " + std::to_string(Bytes.size()) +
									  " bytes, and a module is a row of words of 4 bytes, at least 5");
		}
		std::memcpy(Words.data(), Bytes.data(), Bytes.size());
		if (Words[0] != Magic)
		{
			throw MakeError(6004, Words[0] == SwappedMagic
									  ? "this SPIR-V has its bytes in the other order; write it little-endian"
									  : "this file is not SPIR-V: it does not begin with 0x07230203");
		}
		for (size_t At = HeaderWords; At < Words.size();)
		{
			const size_t Size = Words[At] >> 16;
			if (Size == 0 || Size > Words.size() - At)
			{
				throw MakeError(6004, "this SPIR-V is cut short: the instruction at word " + std::to_string(At) +
										  " reaches beyond the end");
			}
			Instructions.push_back({Words[At] & 0xffff, At, Size});
			At += Size;
		}
	}

	/** The place and the name of each entry. */
	std::vector<std::pair<size_t, std::string>> ListEntries() const
	{
		std::vector<std::pair<size_t, std::string>> Entries;
		for (const FInstruction& Each : Instructions)
		{
			if (Each.Op == OpEntryPoint && Each.Size > 3)
			{
				Entries.emplace_back(Each.At, ReadText(Words, Each.At + 3, Each.At + Each.Size));
			}
		}
		return Entries;
	}

	uint32_t GetModel(size_t Entry) const { return Words[Entry + 1]; }

	FShaderSource Read() const
	{
		const std::vector<uint32_t> Kept = KeepEntry();
		FShaderSource Source;
		Source.Text = std::to_string(Kept.size()) + "\n";
		Source.Text.append(reinterpret_cast<const char*>(Kept.data()), Kept.size() * sizeof(uint32_t));
		Source.Text += DeclareByteBuffers();
		return Source;
	}

private:
	FError MakeError(int Code, const std::string& Message) const
	{
		return FError({ESeverity::Error, Code, Message, Request.VirtualPath, 0, 0, {}}, ExitUsage);
	}

	/** Without the other entries, whose functions nobody then calls. */
	std::vector<uint32_t> KeepEntry() const
	{
		const uint32_t Model = Request.Stage == EShaderStage::Vertex ? 0 : Request.Stage == EShaderStage::Pixel ? 4 : 5;
		uint32_t Function = 0;
		size_t Asked = 0; // where its OpEntryPoint stands
		std::string Others;
		for (const auto& [At, Name] : ListEntries())
		{
			const bool bAsked = Name == Request.EntryPoint && GetModel(At) == Model;
			Function = bAsked ? Words[At + 2] : Function;
			Asked = bAsked ? At : Asked;
			Others += (Others.empty() ? "" : ", ") + Name + " (" + GetModelName(GetModel(At)) + ")";
		}
		if (!Asked)
		{
			throw MakeError(6011, "entry point '" + Request.EntryPoint + "' (" + GetModelName(Model) +
									  ") is not in this module; it has " + (Others.empty() ? "none" : Others));
		}
		std::vector<uint32_t> Result(Words.begin(), Words.begin() + HeaderWords);
		for (const FInstruction& Each : Instructions)
		{
			const bool bEntry = Each.Op == OpEntryPoint && Each.At != Asked;
			const bool bMode = (Each.Op == OpExecutionMode || Each.Op == OpExecutionModeId) && Each.Size > 1 &&
							   Words[Each.At + 1] != Function;
			if (!bEntry && !bMode)
			{
				const auto First = Words.begin() + std::ptrdiff_t(Each.At);
				Result.insert(Result.end(), First, First + std::ptrdiff_t(Each.Size));
			}
		}
		return Result;
	}

	/** DXC names their types "type.ByteAddressBuffer"; nothing else in SPIR-V tells them from a StructuredBuffer<uint>,
	 * but the HLSL that a module may carry with it. */
	std::string DeclareByteBuffers() const
	{
		std::string Text;
		std::map<uint32_t, std::string> Names;
		std::map<uint32_t, uint32_t> Pointees;
		for (const FInstruction& Each : Instructions)
		{
			const size_t End = Each.At + Each.Size;
			if (Each.Op == OpName && Each.Size > 2)
			{
				Names[Words[Each.At + 1]] = ReadText(Words, Each.At + 2, End);
			}
			else if (Each.Op == OpTypePointer && Each.Size > 3)
			{
				Pointees[Words[Each.At + 1]] = Words[Each.At + 3];
			}
			else if (Each.Op == OpVariable && Each.Size > 3)
			{
				const std::string Type = Names[Pointees[Words[Each.At + 1]]];
				if (Type == "type.ByteAddressBuffer" || Type == "type.RWByteAddressBuffer")
				{
					Text += '\n';
					Text += Type.substr(5) + " " + Names[Words[Each.At + 2]] + ";";
				}
			}
		}
		return Text + "\n";
	}

	const FShaderCompileRequest& Request;
	std::vector<uint32_t> Words;
	std::vector<FInstruction> Instructions;
};

} // namespace

bool IsSpirvFile(const std::string& VirtualPath)
{
	return VirtualPath.ends_with(".spv");
}

FShaderSource ReadSpirvFile(const std::string& Bytes, const FShaderCompileRequest& Request)
{
	return FSpirvFile(Bytes, Request).Read();
}

std::vector<std::pair<std::string, EShaderStage>> ListSpirvEntries(
	const std::string& Bytes, const FShaderCompileRequest& Request)
{
	const FSpirvFile File(Bytes, Request);
	std::vector<std::pair<std::string, EShaderStage>> Entries;
	for (const auto& [At, Name] : File.ListEntries())
	{
		const uint32_t Model = File.GetModel(At);
		if (Model == 0 || Model == 4 || Model == 5)
		{
			Entries.emplace_back(Name, Model == 0   ? EShaderStage::Vertex
									   : Model == 4 ? EShaderStage::Pixel
													: EShaderStage::Compute);
		}
	}
	return Entries;
}

std::vector<uint32_t> GetSpirvWords(const std::string& Text)
{
	const size_t Begin = Text.find('\n') + 1;
	std::vector<uint32_t> Words(std::strtoul(Text.c_str(), nullptr, 10));
	std::memcpy(Words.data(), Text.data() + Begin, Words.size() * sizeof(uint32_t));
	return Words;
}

std::vector<uint32_t> InlineSpirvCalls(std::vector<uint32_t> Words)
{
	std::map<uint32_t, size_t> Sizes; // instructions of each function behind its first
	std::set<uint32_t> Called;
	uint32_t Current = 0;
	for (size_t At = HeaderWords; At < Words.size() && Words[At] >> 16; At += Words[At] >> 16)
	{
		const uint32_t Op = Words[At] & 0xffff;
		const bool bWhole = At + 3 < Words.size();
		if (Op == OpFunction && bWhole)
		{
			Current = Words[At + 2];
			Words[At + 3] = 0; // its wishes, "not inlined" among them
			continue;
		}
		++Sizes[Current];
		if (Op == OpFunctionCall && bWhole)
		{
			Called.insert(Words[At + 3]);
		}
	}
	// A function that only discards, of a label and its end, stays.
	if (std::ranges::none_of(Called, [&Sizes](uint32_t Function) { return Sizes[Function] > 3; }))
	{
		return Words;
	}
	spvtools::Optimizer Optimizer(SPV_ENV_UNIVERSAL_1_3);
	Optimizer.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
	Optimizer.RegisterPass(spvtools::CreateWrapOpKillPass())
		.RegisterPass(spvtools::CreateMergeReturnPass())
		.RegisterPass(spvtools::CreateInlineExhaustivePass())
		.RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
	std::vector<uint32_t> Result;
	return Optimizer.Run(Words.data(), Words.size(), &Result) ? Result : Words;
}

} // namespace Drydock
