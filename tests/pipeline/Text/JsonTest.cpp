// JSON with positions. Expected lines and columns are counted by hand.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "Text/ConfigErrors.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"

#include <chrono>
#include <cmath>
#include <limits>

using namespace Drydock;

namespace
{

struct FParsed
{
	FJsonValue Root;
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
};

FParsed Parse(const std::string& Text)
{
	FParsed Parsed;
	Parsed.Root = ParseJson(Text, "t.json", Parsed.Diagnostics, Parsed.bSyntaxError);
	return Parsed;
}

/** "line:column code pointer" of the only message. */
std::string OnlyMessage(const std::string& Text)
{
	const FParsed Parsed = Parse(Text);
	EXPECT_EQ(1u, Parsed.Diagnostics.size()) << Text;
	if (Parsed.Diagnostics.empty())
	{
		return "";
	}
	const FDiagnostic& Message = Parsed.Diagnostics[0];
	return std::to_string(Message.Line) + ":" + std::to_string(Message.Column) + " " + std::to_string(Message.Code) +
		   " " + Message.Where;
}

std::string PlaceOf(const FJsonValue* Value)
{
	return Value == nullptr ? "none"
							: std::to_string(Value->Line) + ":" + std::to_string(Value->Column) + " " + Value->Pointer;
}

} // namespace

TEST(Json, ReadsEveryType)
{
	const FParsed Parsed = Parse(R"({"n": null, "b": true, "i": -3, "f": 2.5e1, "s": "a\nb", "a": [1], "o": {}})");
	EXPECT_TRUE(Parsed.Diagnostics.empty());
	EXPECT_EQ(EJsonType::Null, Parsed.Root.Find("n")->Type);
	EXPECT_TRUE(Parsed.Root.Find("b")->Bool);
	EXPECT_EQ(-3.0, Parsed.Root.Find("i")->Number);
	EXPECT_EQ(25.0, Parsed.Root.Find("f")->Number);
	EXPECT_EQ("a\nb", Parsed.Root.Find("s")->String);
	EXPECT_EQ(1u, Parsed.Root.Find("a")->Elements.size());
	EXPECT_EQ(EJsonType::Object, Parsed.Root.Find("o")->Type);
}

TEST(Json, MembersHaveDefaults)
{
	const FJsonValue Root = Parse(R"({"n": 2, "s": "a", "a": [1, 2], "null": null})").Root;
	EXPECT_EQ(2.0, Root.GetNumber("n", 7.0));
	EXPECT_EQ(7.0, Root.GetNumber("null", 7.0));
	EXPECT_EQ(7.0, Root.GetNumber("none", 7.0));
	EXPECT_EQ("a", Root.GetString("s"));
	EXPECT_EQ("", Root.GetString("none"));
	EXPECT_EQ(2u, Root.GetElements("a").size());
	EXPECT_TRUE(Root.GetElements("none").empty());
}

TEST(Json, NegativeZeroKeepsItsSign)
{
	EXPECT_TRUE(std::signbit(Parse("-0").Root.Number));
	EXPECT_TRUE(std::signbit(Parse("-0.0").Root.Number));
	EXPECT_FALSE(std::signbit(Parse("0").Root.Number));
}

TEST(Json, MembersKeepTheirOrder)
{
	const FParsed Parsed = Parse(R"({"b": 1, "a": 2})");
	EXPECT_EQ("b", Parsed.Root.Members[0].Key);
	EXPECT_EQ("a", Parsed.Root.Members[1].Key);
}

TEST(Json, ValuesKnowWhereTheyBegin)
{
	const FParsed Parsed = Parse("{\n  \"a\": [10,\n\t\"x\"],\n  \"b\": true\n}");
	EXPECT_EQ("1:1 ", PlaceOf(&Parsed.Root));
	EXPECT_EQ("2:8 /a", PlaceOf(Parsed.Root.Find("a")));
	EXPECT_EQ("2:9 /a/0", PlaceOf(&Parsed.Root.Find("a")->Elements[0]));
	EXPECT_EQ("3:2 /a/1", PlaceOf(&Parsed.Root.Find("a")->Elements[1]));
	EXPECT_EQ("4:8 /b", PlaceOf(Parsed.Root.Find("b")));
}

TEST(Json, MembersKnowWhereTheirKeyBegins)
{
	const FParsed Parsed = Parse("{\n  \"key\"  :\n 1}");
	EXPECT_EQ(2, Parsed.Root.Find("key")->KeyLine);
	EXPECT_EQ(3, Parsed.Root.Find("key")->KeyColumn);
	EXPECT_EQ("3:2 /key", PlaceOf(Parsed.Root.Find("key")));
}

TEST(Json, ColumnsCountCharactersNotBytes)
{
	EXPECT_EQ(12, Parse("{\"é\": \"ü\", \"x\": 1}").Root.Find("x")->KeyColumn);
}

TEST(Json, ByteOrderMarkHasNoColumn)
{
	const FParsed Parsed = Parse("\xEF\xBB\xBF{}");
	EXPECT_EQ("1:1 ", PlaceOf(&Parsed.Root));
}

TEST(Json, PointersEscapeSlashAndTilde)
{
	EXPECT_EQ("/a~1b~0c", Parse(R"({"a/b~c": 1})").Root.Members[0].Value.Pointer);
}

TEST(Json, CommentsAreSkippedAndCounted)
{
	const FParsed Parsed = Parse("// first\n{ /* two\nlines */ \"a\": 1 // last \"b\": 2\n}");
	EXPECT_TRUE(Parsed.Diagnostics.empty());
	EXPECT_EQ("3:15 /a", PlaceOf(Parsed.Root.Find("a")));
}

TEST(Json, QuotesAndSlashesInStringsAreText)
{
	const FParsed Parsed = Parse(R"({"a": "no // comment \" {", "b": 1})");
	EXPECT_EQ("no // comment \" {", Parsed.Root.Find("a")->String);
	EXPECT_EQ("1:34 /b", PlaceOf(Parsed.Root.Find("b")));
}

TEST(Json, DuplicateKeyIsReportedAtTheSecondAndTheFirstCounts)
{
	EXPECT_EQ("2:2 1003 /a", OnlyMessage("{\"a\": 1,\n \"a\": 2}"));
	EXPECT_EQ(1.0, Parse("{\"a\": 1, \"a\": 2}").Root.Find("a")->Number);
}

TEST(Json, SameKeyInAnotherObjectIsNoDuplicate)
{
	EXPECT_TRUE(Parse(R"({"a": {"a": 1}, "b": {"a": 1}})").Diagnostics.empty());
}

TEST(Json, NumberThatOverflowsIsReportedAtItsPlace)
{
	EXPECT_EQ("1:7 1004 /a", OnlyMessage(R"({"a": 1e999})"));
	EXPECT_EQ("1:7 1004 /a", OnlyMessage(R"({"a": -1e999})"));
}

TEST(Json, NaNAndInfinityAreReportedAtTheirPlace)
{
	for (const char* Number : {"NaN", "Infinity", "-Infinity", "nan", "inf"})
	{
		EXPECT_EQ("1:10 1004 /a/1", OnlyMessage(std::string(R"({"a": [1,)") + Number + "]}")) << Number;
	}
}

TEST(Json, FileGoesOnAfterANumberThatIsNotFinite)
{
	const FParsed Parsed = Parse(R"({"a": 1e999, "b": NaN, "c": 3})");
	EXPECT_EQ(2u, Parsed.Diagnostics.size());
	EXPECT_FALSE(Parsed.bSyntaxError);
	EXPECT_EQ(EJsonType::Invalid, Parsed.Root.Find("a")->Type);
	EXPECT_EQ(3.0, Parsed.Root.Find("c")->Number);
}

TEST(Json, SyntaxErrorEndsTheFileAtItsPlace)
{
	EXPECT_EQ("2:7 1001 ", OnlyMessage("{\n  \"a\" 1,\n  \"b\": NaN }"));
}

TEST(Json, EmptyTextIsASyntaxError)
{
	EXPECT_EQ("1:1 1001 ", OnlyMessage(""));
}

TEST(Json, TrailingCommaIsASyntaxError)
{
	EXPECT_EQ("1:8 1001 ", OnlyMessage("{\"a\": 1, }"));
}

/** Texts that are not JSON, the place by hand, and the words that lead to the mend. */
struct FSyntaxMistake
{
	const char* Text;
	const char* Place;
	const char* Words;
};

TEST(Json, SyntaxErrorsSayWhatIsToBeChanged)
{
	const FSyntaxMistake Mistakes[] = {
		{"{\n \"a\": 1,\n}", "2:8", "delete the comma"},
		{"{\"a\": [1, 2,]}", "1:12", "delete the comma"},
		{"{\"a\": 1, // one\n}", "1:8", "delete the comma"},
		{"{\n \"a\": 1\n \"b\": 2\n}", "3:2", "a comma is missing"},
		{"{\"a\": [1 2]}", "1:10", "a comma is missing"},
		{"{ # why\n}", "1:3", "write // or /* */"},
		{"{ 'a': 1 }", "1:3", "double quotes"},
		{"{\"a\": 'b'}", "1:7", "double quotes"},
		{"{ \xE2\x80\x9C"
		 "a\xE2\x80\x9D: 1 }",
			"1:3", "straight double quotes"},
		{"{ a: 1 }", "1:3", "double quotes: \"a\""},
		{"{\"a\": True}", "1:7", "write true"},
		{"{\"a\": high}", "1:7", "double quotes: \"high\""},
		{"{\"a\": .5}", "1:7", "not a number of JSON, such as -0.5"},
		{"{\"a\" 1}", "1:6", "a colon is missing"},
		{"{\"a\" = 1}", "1:6", "a colon is missing"},
		{"{\"a\": \"b,\n \"c\": 1}", "1:7", "no closing quotation mark"},
		{"{\"a\": \"C:\\Users\"}", "1:7", "a backslash stands twice"},
		{"{\n\"a\": [1, 2}", "2:11", "} closes the [ of line 2"},
		{"{\n\"a\": {\"b\": 1}\n", "2:14", "the { of line 1 is not closed"},
		{"{} 1", "1:4", "behind its last bracket"},
		{"", "1:1", "the file is empty"},
	};
	for (const FSyntaxMistake& Mistake : Mistakes)
	{
		EXPECT_TRUE(OnlyMessage(Mistake.Text).starts_with(std::string(Mistake.Place) + " 1001"))
			<< Mistake.Text << "\n"
			<< OnlyMessage(Mistake.Text);
		const std::string Said = Parse(Mistake.Text).Diagnostics[0].Message;
		EXPECT_NE(std::string::npos, Said.find(Mistake.Words)) << Mistake.Text << "\n" << Said;
	}
}

TEST(Json, TextAfterTheValueIsASyntaxError)
{
	EXPECT_TRUE(Parse("{} 1").bSyntaxError);
}

TEST(Json, DeepNestingIsRefused)
{
	const std::string Deep = std::string(65, '[') + std::string(65, ']');
	EXPECT_TRUE(Parse(Deep).bSyntaxError);
	EXPECT_EQ(1002, Parse(Deep).Diagnostics[0].Code);
	EXPECT_FALSE(Parse(std::string(64, '[') + std::string(64, ']')).bSyntaxError);
}

TEST(Json, ABombOfBracketsEndsQuickly)
{
	EXPECT_TRUE(Parse(std::string(1000000, '[')).bSyntaxError);
}

namespace
{

/** Count times Make(index), with commas between. */
template<typename TFunction>
std::string Join(size_t Count, const TFunction& Make)
{
	std::string Text;
	for (size_t Index = 0; Index < Count; ++Index)
	{
		Text += (Index > 0 ? "," : "") + Make(Index);
	}
	return Text;
}

class FStopwatch
{
public:
	double GetSeconds() const
	{
		return std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
	}

private:
	const std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};

} // namespace

/** Compared with each other, these keys took five minutes. */
TEST(Json, ManyKeysTakeLinearTime)
{
	const std::string Text =
		"{" + Join(200'000, [](size_t Index) { return "\"k" + std::to_string(Index) + "\":1"; }) + "}";
	const FStopwatch Watch;
	const FParsed Parsed = Parse(Text);
	EXPECT_LT(Watch.GetSeconds(), 20.0);
	EXPECT_TRUE(Parsed.Diagnostics.empty());
	EXPECT_EQ(200'000u, Parsed.Root.Members.size());
}

TEST(Json, AMillionMistakesAreAHundredMessages)
{
	const FParsed Parsed = Parse("[" + Join(900'000, [](size_t) { return std::string("NaN"); }) + "]");
	EXPECT_FALSE(Parsed.bSyntaxError);
	ASSERT_EQ(101u, Parsed.Diagnostics.size());
	EXPECT_EQ("/99", Parsed.Diagnostics[99].Where);
	EXPECT_EQ("and 899900 more like it (DD1004)", Parsed.Diagnostics[100].Message);
}

TEST(Json, MoreValuesThanAnyConfigHasAreRefused)
{
	const auto One = [](size_t)
	{
		return std::string("1");
	};
	EXPECT_FALSE(Parse("[" + Join(999'999, One) + "]").bSyntaxError); // the array is the millionth
	const FParsed Parsed = Parse("[" + Join(1'000'000, One) + "]");
	EXPECT_TRUE(Parsed.bSyntaxError);
	ASSERT_EQ(1u, Parsed.Diagnostics.size());
	EXPECT_EQ("t.json:1:2000000: error DD1024 at /999999: more than 1000000 values; no more are read",
		Parsed.Diagnostics[0].ToString());
}

TEST(Json, MoreTextThanIsReadIsRefused)
{
	const FParsed Parsed = Parse(std::string((16 << 20) + 1, ' '));
	EXPECT_TRUE(Parsed.bSyntaxError);
	ASSERT_EQ(1u, Parsed.Diagnostics.size());
	EXPECT_EQ("t.json: error DD5007: the text has 16777217 bytes, and at most 16777216 are read",
		Parsed.Diagnostics[0].ToString());
}

/** A pointer of the whole key for every element would be a terabyte. */
TEST(Json, LongKeysDoNotMakeLongPointers)
{
	const FParsed Parsed = Parse(
		"{\"" + std::string(5'000'000, 'k') + "\":[" + Join(200'000, [](size_t) { return std::string("1"); }) + "]}");
	EXPECT_TRUE(Parsed.Diagnostics.empty());
	const FJsonValue& Array = Parsed.Root.Members[0].Value;
	EXPECT_EQ("/...", Array.Pointer);
	EXPECT_LT(Array.Elements.back().Pointer.size(), 300u);
}

TEST(Json, ATextWithNulIsRefused)
{
	EXPECT_EQ("1:17 1010 /scene/f", OnlyMessage(R"({"scene": {"f": "a\u0000.exr"}})"));
	EXPECT_EQ("1:2 1010 ", OnlyMessage(R"({"sc\u0000ene": 1})"));
	EXPECT_TRUE(Parse(R"(["\u0000"])").bSyntaxError);
	EXPECT_FALSE(Parse(R"(["\u0001"])").bSyntaxError);
}

/** Seeds for random damage. */
RC_GTEST_PROP(Json, DamagedTextNeverCrashesAndAlwaysSaysSo, ())
{
	std::string Text = R"({"a": [1, 2.5, "x\u00e9", {"b": null}], "c": true, "d": 1e999, "e": NaN} // end)";
	const int NumEdits = *rc::gen::inRange(1, 6);
	for (int Edit = 0; Edit < NumEdits; ++Edit)
	{
		const size_t At = *rc::gen::inRange<size_t>(0, Text.size());
		Text[At] = *rc::gen::element(
			'{', '}', '[', ']', '"', ',', ':', '\\', '/', '*', '\n', '0', 'e', 'N', '-', '\x80', '\0', ' ');
	}
	const FParsed Parsed = Parse(Text);
	RC_ASSERT(!Parsed.bSyntaxError || !Parsed.Diagnostics.empty());
}

TEST(JsonWriter, WritesNestedAndInline)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("a", 1);
	Writer.Key("b").BeginArray(true);
	Writer.Value(true);
	Writer.Null();
	Writer.EndArray();
	Writer.Key("c").BeginObject();
	Writer.EndObject();
	Writer.EndObject();
	EXPECT_EQ("{\n  \"a\": 1,\n  \"b\": [true, null],\n  \"c\": {}\n}\n", Writer.GetText());
}

TEST(JsonWriter, FloatsAreShortestAndNonFiniteIsNull)
{
	FJsonWriter Writer;
	Writer.BeginArray(true);
	Writer.Value(0.1f);
	Writer.Value(0.1);
	Writer.Value(std::numeric_limits<double>::infinity());
	Writer.Value(std::nan(""));
	Writer.EndArray();
	EXPECT_EQ("[0.1, 0.1, null, null]\n", Writer.GetText());
}

TEST(JsonWriter, EscapesWhatJsonMustEscape)
{
	EXPECT_EQ(R"("a\"b\\c\n\t\u0001é")", FJsonWriter::Quote("a\"b\\c\n\t\x01é"));
}

RC_GTEST_PROP(JsonWriter, AnyAsciiTextReadsBack, ())
{
	const std::string Text = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
	RC_ASSERT(Parse("[" + FJsonWriter::Quote(Text) + "]").Root.Elements[0].String == Text);
}

RC_GTEST_PROP(JsonWriter, AnyNumberReadsBack, (double Number))
{
	FJsonWriter Writer;
	Writer.BeginArray();
	Writer.Value(Number);
	Writer.EndArray();
	RC_ASSERT(Parse(Writer.GetText()).Root.Elements[0].Number == Number);
}
