// FString and FName behave as the engine's.
#include <gtest/gtest.h>

#include "CoreMinimal.h"

namespace
{

std::vector<std::string> ToWords(const TArray<FString>& Words)
{
	std::vector<std::string> Result;
	for (const FString& Word : Words)
	{
		Result.push_back(*Word);
	}
	return Result;
}

using FWords = std::vector<std::string>;

} // namespace

TEST(String, PrintfFormats)
{
	EXPECT_STREQ("Blur 3x2 0.50", *FString::Printf(TEXT("%s %dx%d %.2f"), TEXT("Blur"), 3, 2, 0.5));
}

TEST(String, PrintfTakesLongText)
{
	const FString Long = FString::ChrN(5000, 'x');
	EXPECT_EQ(5002, FString::Printf("[%s]", *Long).Len());
}

TEST(String, ConcatenatesLiteralsAndNumbers)
{
	EXPECT_STREQ("Mip7.exr", *("Mip" + FString::FromInt(7) + ".exr"));
}

TEST(String, EqualityIgnoresCase)
{
	EXPECT_TRUE(FString("Bloom") == FString("bLOOM"));
	EXPECT_TRUE(FString("Bloom") == "BLOOM");
	EXPECT_FALSE(FString("Bloom") == FString("Bloom2"));
}

TEST(String, EqualsComparesCase)
{
	EXPECT_FALSE(FString("Bloom").Equals("bloom"));
	EXPECT_TRUE(FString("Bloom").Equals("bloom", ESearchCase::IgnoreCase));
}

TEST(String, OrderIgnoresCase)
{
	EXPECT_TRUE(FString("alpha") < FString("Beta"));
	EXPECT_FALSE(FString("beta") < FString("Alpha"));
}

TEST(String, SanitizeFloatKeepsAPoint)
{
	EXPECT_STREQ("1.0", *FString::SanitizeFloat(1.0));
	EXPECT_STREQ("-0.25", *FString::SanitizeFloat(-0.25));
	EXPECT_STREQ("2", *FString::SanitizeFloat(2.0, 0));
	EXPECT_STREQ("0.500", *FString::SanitizeFloat(0.5, 3));
}

TEST(String, FloatTextIsTheShortestThatReadsBack)
{
	EXPECT_STREQ("0.1", *LexToString(0.1f));
	EXPECT_STREQ("0.30000000000000004", *LexToString(0.1 + 0.2));
}

TEST(String, LeftRightMid)
{
	EXPECT_STREQ("Tex", *FString("Texture").Left(3));
	EXPECT_STREQ("ure", *FString("Texture").Right(3));
	EXPECT_STREQ("xtu", *FString("Texture").Mid(2, 3));
}

TEST(String, CutsOutsideTheTextAreEmptyOrAll)
{
	EXPECT_STREQ("abc", *FString("abc").Left(10));
	EXPECT_STREQ("abc", *FString("abc").Right(10));
	EXPECT_STREQ("", *FString("abc").Mid(5));
	EXPECT_STREQ("", *FString("abc").Left(-1));
	EXPECT_STREQ("ab", *FString("abc").LeftChop(1));
	EXPECT_STREQ("bc", *FString("abc").RightChop(1));
}

TEST(String, SplitAtTheFirstSeparator)
{
	FString Left, Right;
	ASSERT_TRUE(FString("a=b=c").Split("=", &Left, &Right));
	EXPECT_STREQ("a", *Left);
	EXPECT_STREQ("b=c", *Right);
}

TEST(String, SplitFromTheEnd)
{
	FString Left, Right;
	ASSERT_TRUE(FString("a=b=c").Split("=", &Left, &Right, ESearchCase::IgnoreCase, ESearchDir::FromEnd));
	EXPECT_STREQ("a=b", *Left);
	EXPECT_STREQ("c", *Right);
}

TEST(String, SplitWithoutSeparatorLeavesTheOutputs)
{
	FString Left("kept");
	EXPECT_FALSE(FString("abc").Split("=", &Left, nullptr));
	EXPECT_STREQ("kept", *Left);
}

TEST(String, ParseIntoArrayCullsEmptyParts)
{
	TArray<FString> Parts;
	EXPECT_EQ(2, FString(",a,,b,").ParseIntoArray(Parts, ","));
	EXPECT_EQ((FWords{"a", "b"}), ToWords(Parts));
}

TEST(String, ParseIntoArrayKeepsEmptyPartsIfAsked)
{
	TArray<FString> Parts;
	FString("a,,b").ParseIntoArray(Parts, ",", false);
	EXPECT_EQ((FWords{"a", "", "b"}), ToWords(Parts));
}

TEST(String, ParseIntoArrayTakesLongSeparators)
{
	TArray<FString> Parts;
	FString("one::two::three").ParseIntoArray(Parts, "::");
	EXPECT_EQ((FWords{"one", "two", "three"}), ToWords(Parts));
}

TEST(String, LinesEndInEveryWay)
{
	TArray<FString> Lines;
	FString("a\r\nb\rc\nd").ParseIntoArrayLines(Lines);
	EXPECT_EQ((FWords{"a", "b", "c", "d"}), ToWords(Lines));
}

TEST(String, FindsForwardsAndBackwards)
{
	const FString Text("abcABC");
	EXPECT_EQ(1, Text.Find("bc"));
	EXPECT_EQ(4, Text.Find("BC", ESearchCase::CaseSensitive));
	EXPECT_EQ(4, Text.Find("bc", ESearchCase::IgnoreCase, ESearchDir::FromEnd));
	EXPECT_EQ(INDEX_NONE, Text.Find("x"));
}

TEST(String, FindBackwardsEndsBeforeTheStart)
{
	const FString Text("a.b.c");
	EXPECT_EQ(1, Text.Find(".", ESearchCase::IgnoreCase, ESearchDir::FromEnd, 3));
}

TEST(String, ContainsStartsEnds)
{
	const FString Path("/Engine/Private/Common.ush");
	EXPECT_TRUE(Path.Contains("private"));
	EXPECT_TRUE(Path.StartsWith("/engine"));
	EXPECT_TRUE(Path.EndsWith(".USH"));
	EXPECT_FALSE(Path.EndsWith(".USH", ESearchCase::CaseSensitive));
	EXPECT_FALSE(FString("a").EndsWith("ba"));
}

TEST(String, ReplacesEveryOccurrence)
{
	FString Text("aXbxc");
	EXPECT_EQ(2, Text.ReplaceInline("x", "--"));
	EXPECT_STREQ("a--b--c", *Text);
}

TEST(String, ReplacementIsNotSearchedAgain)
{
	EXPECT_STREQ("aaaa", *FString("aa").Replace("a", "aa"));
}

TEST(String, SlashJoinsPathsOnce)
{
	EXPECT_STREQ("a/b", *(FString("a") / "b"));
	EXPECT_STREQ("a/b", *(FString("a/") / "b"));
	EXPECT_STREQ("a/b", *(FString("a/") / "/b"));
	EXPECT_STREQ("b", *(FString("") / "b"));
}

TEST(String, WildcardsMatch)
{
	EXPECT_TRUE(FString("BloomBlurY.Output").MatchesWildcard("*blur?.*"));
	EXPECT_TRUE(FString("aab").MatchesWildcard("*ab"));
	EXPECT_FALSE(FString("BloomSetup").MatchesWildcard("*Blur*"));
	EXPECT_FALSE(FString("a").MatchesWildcard("a?"));
}

TEST(String, TrimsAndChangesCase)
{
	EXPECT_STREQ("a b", *FString(" \ta b\r\n").TrimStartAndEnd());
	EXPECT_STREQ("abc1", *FString("aBC1").ToLower());
	EXPECT_STREQ("ABC1", *FString("aBc1").ToUpper());
}

TEST(String, IsNumericTakesSignAndOnePoint)
{
	EXPECT_TRUE(FString("-1.5").IsNumeric());
	EXPECT_FALSE(FString("1.5.2").IsNumeric());
	EXPECT_FALSE(FString("").IsNumeric());
	EXPECT_FALSE(FString("1e3").IsNumeric());
}

TEST(String, IndexOutsideFails)
{
	const FString Text("ab");
	EXPECT_EQ('b', Text[1]);
	EXPECT_THROW(Text[2], Drydock::FCheckFailure);
}

TEST(String, JoinPutsSeparatorsBetween)
{
	EXPECT_STREQ("a, b, c", *FString::Join(TArray<FString>{"a", "b", "c"}, ", "));
	EXPECT_STREQ("", *FString::Join(TArray<FString>{}, ", "));
}

TEST(String, HashIgnoresCaseAsEqualityDoes)
{
	EXPECT_EQ(GetTypeHash(FString("Bloom")), GetTypeHash(FString("bLOOM")));
	EXPECT_NE(GetTypeHash(FString("Bloom")), GetTypeHash(FString("Blood")));
}

TEST(Name, IgnoresCaseAndKeepsTheFirstSpelling)
{
	const FName First(TEXT("CoreTestName"));
	const FName Second(TEXT("coretestNAME"));
	EXPECT_EQ(First, Second);
	EXPECT_STREQ("CoreTestName", *Second.ToString());
	EXPECT_NE(First, FName(TEXT("CoreTestName2")));
}

TEST(Name, DefaultAndEmptyAreNone)
{
	EXPECT_TRUE(FName().IsNone());
	EXPECT_TRUE(FName(TEXT("")).IsNone());
	EXPECT_EQ(FName(NAME_None), FName(TEXT("none")));
	EXPECT_STREQ("None", *FName().ToString());
}

TEST(Name, FindDoesNotAdd)
{
	EXPECT_TRUE(FName(TEXT("CoreTestNobodyMadeThis"), FNAME_Find).IsNone());
	EXPECT_TRUE(FName(TEXT("CoreTestNobodyMadeThis"), FNAME_Find).IsNone());
}

TEST(Name, ComparesWithTextAndAlphabetically)
{
	EXPECT_TRUE(FName(TEXT("Blur")) == TEXT("blur"));
	EXPECT_FALSE(FName(TEXT("Blur")) == TEXT("None"));
	EXPECT_TRUE(FName(TEXT("zz")).LexicalLess(FName(TEXT("ZZZ"))));
}
