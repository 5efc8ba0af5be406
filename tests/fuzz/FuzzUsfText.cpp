// libFuzzer's entry for .usf text, and a mutator that also puts in words that mean something to the text stages.
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
		"ERROR: /Fuzz/Main.usf:3: ", "'View_B' : unknown variable", "ByteAddressBuffer B", "\xEF\xBB\xBF",
		"Entry point not found"};
	std::mt19937 Random(Seed);
	if (Random() % 3)
	{
		return LLVMFuzzerMutate(Data, Size, MaxSize);
	}
	std::string Text(reinterpret_cast<const char*>(Data), Size);
	Text.insert(Random() % (Text.size() + 1), Words[Random() % std::size(Words)]);
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
