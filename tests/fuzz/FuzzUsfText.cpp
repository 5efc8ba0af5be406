// libFuzzer's entry for .usf text, and a mutator that also puts in words that mean something to the text stages, and
// HLSL by a grammar.
#include "FuzzHlslGrammar.h"
#include "FuzzUsfChecks.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" size_t LLVMFuzzerMutate(uint8_t* Data, size_t Size, size_t MaxSize);

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* Data, size_t Size, size_t MaxSize, unsigned int Seed)
{
	static const char* const Words[] = {"\n#include \"A.ush\"\n", "#include \"/Fuzz/B.ush\"\n", "\n//@ /Fuzz/A.ush\n",
		"\n//@ /Fuzz/B.ush\n", "\n//@ messages\n", "\n//@ uniform View A\n", "\n//@ define X 1\n", "View.A", "/*", "*/",
		"//", "\"", "\\\n", "\r\n", "#if 1\n", "#ifdef X\n", "#endif\n", "#pragma once\n",
		"/Fuzz/Main.usf:3:1: error: ", "ByteAddressBuffer B", "\xEF\xBB\xBF"};
	static const Drydock::FFuzzGrammar Grammar;
	std::mt19937 Random(Seed);
	const uint32_t Kind = Random() % 6;
	if (Kind < 2)
	{
		return LLVMFuzzerMutate(Data, Size, MaxSize);
	}
	std::string Text(reinterpret_cast<const char*>(Data), Size);
	if (Kind == 2)
	{
		Text = Grammar.Write("Unit", Random);
	}
	else
	{
		Text.insert(
			Random() % (Text.size() + 1), Kind == 3 ? Words[Random() % std::size(Words)] : Grammar.WriteAny(Random));
	}
	Text.resize(std::min(Text.size(), MaxSize));
	std::memcpy(Data, Text.data(), Text.size());
	return Text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	static const auto Modules = Drydock::ReadModules(DRYDOCK_SOURCE_DIR "/tests/fuzz/corpus/spirv");
	const std::string Problem = Drydock::CheckUsfText(std::string(reinterpret_cast<const char*>(Data), Size), Modules);
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
