// Blocks of articles and of pages, and files that they are pasted into.
#pragma once

#include <gtest/gtest.h>

#include "pipeline/ProgramTestUtils.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace PasteTest
{

/** The blocks of a text between ```Language and ```. */
inline std::vector<std::string> FindBlocks(const std::string& Text, const std::string& Language)
{
	std::vector<std::string> Blocks;
	const std::string Begin = "```" + Language + "\n";
	for (size_t At = Text.find(Begin); At != Text.npos; At = Text.find(Begin, At + 1))
	{
		const size_t First = At + Begin.size();
		Blocks.push_back(Text.substr(First, Text.find("```", First) - First));
	}
	return Blocks;
}

inline std::string ReadWholeFile(const std::filesystem::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

/** The blocks of the article whose file begins with Number. Empty where DRYDOCK_ARTICLES names no folder with it: the
 * project holds nothing of the articles. */
inline std::vector<std::string> ReadArticle(const std::string& Number, const std::string& Language)
{
	const char* const Folder = std::getenv("DRYDOCK_ARTICLES");
	std::vector<std::string> Blocks;
	for (const auto& Entry :
		Folder == nullptr ? std::filesystem::directory_iterator() : std::filesystem::directory_iterator(Folder))
	{
		if (Entry.path().filename().string().starts_with(Number))
		{
			Blocks = FindBlocks(ReadWholeFile(Entry.path()), Language);
		}
	}
	EXPECT_TRUE(Folder == nullptr || !Blocks.empty()) << "no article " << Number << " in " << Folder;
	return Blocks;
}

/** The last block that holds all of the texts. */
inline std::string FindBlock(const std::vector<std::string>& Blocks, const std::vector<std::string>& Texts)
{
	for (auto Block = Blocks.rbegin(); Block != Blocks.rend(); ++Block)
	{
		if (std::all_of(
				Texts.begin(), Texts.end(), [&](const std::string& Text) { return Block->find(Text) != Block->npos; }))
		{
			return *Block;
		}
	}
	ADD_FAILURE() << "there is no block with " << Texts[0];
	return "";
}

/** From First to the end of Last, which comes after it. */
inline std::string Between(const std::string& Text, const std::string& First, const std::string& Last)
{
	const size_t Begin = Text.find(First);
	const size_t End = Begin == Text.npos ? Text.npos : Text.find(Last, Begin);
	EXPECT_NE(std::string::npos, End) << First << " ... " << Last;
	return End == Text.npos ? "" : Text.substr(Begin, End + Last.size() - Begin);
}

inline void Replace(std::string& Text, const std::string& Old, const std::string& New)
{
	const size_t At = Text.find(Old);
	ASSERT_NE(std::string::npos, At) << Old;
	Text.replace(At, Old.size(), New);
}

inline void Edit(
	const ProgramTest::FProgramFolder& Folder, const std::string& File, const std::function<void(std::string&)>& Change)
{
	std::string Text = Folder.Read(File);
	Change(Text);
	Folder.Write(File, Text);
}

} // namespace PasteTest
