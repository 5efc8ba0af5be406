// The .usf fuzzer's checks over its corpus, over every cut of it and over damaged texts, so that they run without
// clang.
#include <gtest/gtest.h>

#include "fuzz/FuzzHlslGrammar.h"
#include "fuzz/FuzzUsfChecks.h"

namespace
{

using namespace Drydock;

const std::string Corpus = DRYDOCK_TEST_SOURCE_DIR "/tests/fuzz/corpus/";

std::vector<std::string> ReadTexts()
{
	std::vector<std::filesystem::path> Paths;
	for (const auto& Entry : std::filesystem::directory_iterator(Corpus + "usf"))
	{
		Paths.push_back(Entry.path());
	}
	std::sort(Paths.begin(), Paths.end());
	std::vector<std::string> Texts;
	for (const std::filesystem::path& Path : Paths)
	{
		std::ifstream Stream(Path, std::ios::binary);
		Texts.emplace_back(std::istreambuf_iterator<char>(Stream), std::istreambuf_iterator<char>());
	}
	return Texts;
}

} // namespace

TEST(UsfFuzzCorpus, Holds)
{
	const auto Modules = ReadModules(Corpus + "spirv");
	ASSERT_LE(7u, ReadTexts().size());
	for (const std::string& Text : ReadTexts())
	{
		EXPECT_EQ("", CheckUsfText(Text, Modules)) << Text;
	}
}

TEST(UsfFuzzCorpus, HoldsCutAnywhere)
{
	const auto Modules = ReadModules(Corpus + "spirv");
	for (const std::string& Text : ReadTexts())
	{
		for (size_t Length = 0; Length < Text.size(); ++Length)
		{
			ASSERT_EQ("", CheckUsfText(Text.substr(0, Length), Modules)) << Text.substr(0, Length);
		}
	}
}

TEST(UsfFuzzCorpus, HoldsDamaged)
{
	const auto Modules = ReadModules(Corpus + "spirv");
	std::mt19937 Random(16);
	for (const std::string& Text : ReadTexts())
	{
		for (int Round = 0; Round < 100; ++Round)
		{
			std::string Damaged = Text;
			Damaged[Random() % Damaged.size()] = char(Random());
			Damaged.insert(Random() % Damaged.size(), Text.substr(Random() % Text.size(), Random() % 20));
			ASSERT_EQ("", CheckUsfText(Damaged, Modules)) << Damaged;
		}
	}
}

TEST(UsfFuzzCorpus, HoldsForTheGrammar)
{
	const auto Modules = ReadModules(Corpus + "spirv");
	const FFuzzGrammar Grammar;
	std::mt19937 Random(38);
	int NumCompiled = 0;
	for (int Round = 0; Round < 400; ++Round)
	{
		const std::string Text = Grammar.Write("Unit", Random);
		ASSERT_EQ("", CheckUsfText(Text, Modules)) << Text;
		try
		{
			const FUsfInput Input = ReadUsfInput(Text);
			NumCompiled += !CompileToSpirv(FlattenShader(Input.Request), Input.Request).empty();
		}
		catch (const FError&)
		{
			continue;
		}
	}
	EXPECT_GT(NumCompiled, 60);
}

TEST(UsfFuzzCorpus, ALineThatMovesIsFound)
{
	const FUsfInput Input = ReadUsfInput("float A;\nfloat B;\n");
	const std::string Head = "#line 1 \"/Fuzz/Main.usf\"\n";
	EXPECT_EQ("", CheckLinesKeepTheirPlace(Input, Head + "float A;\nfloat B;\n"));
	EXPECT_NE("", CheckLinesKeepTheirPlace(Input, Head + "float B;\nfloat A;\n"));
	EXPECT_NE("", CheckLinesKeepTheirPlace(Input, Head + "float A;\n\nfloat B;\n"));
}
