// Text of C++: comments and strings are blanked in place, brackets are paired, definitions are told from calls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Overlay/CppText.h"

using namespace Drydock;
using testing::ElementsAre;

TEST(CppText, CommentsAndStringsAreBlankedInPlace)
{
	EXPECT_EQ("a       \nb", BlankComments("a // (b)\nb"));
	EXPECT_EQ("a     \n   b", BlankComments("a /* (\n*/ b"));
	EXPECT_EQ("f(   , x)", BlankComments(R"~(f("{", x))~"));
	EXPECT_EQ("x = 1'000; y", BlankComments("x = 1'000; y"));
	EXPECT_EQ("open   ", BlankComments("open /*"));
	EXPECT_EQ("     ;", BlankComments(R"~("\"{";)~"));
}

TEST(CppText, WordsAreWholeWords)
{
	EXPECT_THAT(FindWord("Bloom BloomX XBloom Bloom", "Bloom"), ElementsAre(0u, 20u));
	EXPECT_TRUE(FindWord("", "Bloom").empty());
}

TEST(CppText, BracketsArePaired)
{
	EXPECT_EQ(12u, FindClosing("f(a[0], {b}) c", 1));
	EXPECT_EQ(6u, FindClosing("f(a[0], {b}) c", 3));
	EXPECT_FALSE(FindClosing("f((a)", 1));
}

TEST(CppText, DefinitionsAreToldFromCalls)
{
	EXPECT_TRUE(FindDefinition("FScreenPassTexture AddTonemapPass(\n\tFRDGBuilder& A)\n{\n}", "AddTonemapPass"));
	EXPECT_FALSE(FindDefinition("FScreenPassTexture AddTonemapPass(FRDGBuilder& A);", "AddTonemapPass"));
	EXPECT_FALSE(FindDefinition("return AddTonemapPass(A, B);", "AddTonemapPass"));
	EXPECT_FALSE(FindDefinition("int AddTonemapPasses() {}", "AddTonemapPass"));
	EXPECT_TRUE(FindDefinition("namespace DiaphragmDOF { int AddPasses(int) { } }", "DiaphragmDOF::AddPasses"));
	EXPECT_FALSE(FindDefinition("int AddPasses(int) { }", "DiaphragmDOF::AddPasses"));
}

TEST(CppText, LinesAreCountedFromOne)
{
	EXPECT_EQ(1, GetLineOf("a\nb", 0));
	EXPECT_EQ(2, GetLineOf("a\nb", 2));
}
