// Tokens of HLSL: numbers beside swizzles, signs, places, directives.
#include <gtest/gtest.h>

#include "HlslParser.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Hlsl;

struct FLexed
{
	std::string Tokens; // with blanks between; ~ where one touches the one before
	std::string Errors;
};

FLexed Lex(const std::string& Text)
{
	FLexed Lexed;
	std::vector<std::string> Files;
	std::vector<FDiagnostic> Errors;
	for (const FToken& Token : ReadTokens(Text, "/T.usf", Files, Errors))
	{
		if (Token.Kind != EToken::End)
		{
			Lexed.Tokens += (Lexed.Tokens.empty() ? "" : Token.bTouches ? "~" : " ") + std::string(Token.Text);
		}
	}
	for (const FDiagnostic& Error : Errors)
	{
		Lexed.Errors += Error.ToString() + "\n";
	}
	return Lexed;
}

std::string LexPlaces(const std::string& Text)
{
	std::string Places;
	std::vector<std::string> Files;
	std::vector<FDiagnostic> Errors;
	for (const FToken& Token : ReadTokens(Text, "/T.usf", Files, Errors))
	{
		Places += std::string(Token.Text) + "@" + Files[Token.Place.File] + ":" + std::to_string(Token.Place.Line) +
				  ":" + std::to_string(Token.Place.Column) + " ";
	}
	return Places;
}

TEST(HlslLexer, TellsNumbersFromSwizzles)
{
	EXPECT_EQ(Lex("1.0.xxx 1.xxx 0.xx 1.f.xx 1.5f 1. .5 .5.x 1..x").Tokens,
		"1.0~.~xxx 1~.~xxx 0~.~xx 1.f~.~xx 1.5f 1. .5 .5~.~x 1.~.~x");
	EXPECT_EQ(Lex("1.e5 1.e-5f 1e3L 1.rgb 1.h 1.L 2.l.x 1.e").Tokens, "1.e5 1.e-5f 1e3L 1~.~rgb 1.h 1.L 2.l~.~x 1~.~e");
	EXPECT_EQ(
		Lex("0x10u 0XFFull 017 10ll 1.0h 3UL 1.#INF 1.#INFf").Tokens, "0x10u 0XFFull 017 10ll 1.0h 3UL 1.#INF 1.#INFf");
	EXPECT_EQ(Lex("1.0xyz 5abc").Tokens, "1.0xyz 5abc"); // who reads the number refuses it
	EXPECT_EQ(Lex("a.x-1.0+b[0].y").Tokens, "a~.~x~-~1.0~+~b~[~0~]~.~y");
}

TEST(HlslLexer, TakesTheLongestSignButNotOfClosingAngles)
{
	EXPECT_EQ(Lex("a<<=b<<c<=d").Tokens, "a~<<=~b~<<~c~<=~d");
	EXPECT_EQ(Lex("a>>=b>>c>=d > > e").Tokens, "a~>~>~=~b~>~>~c~>~=~d > > e");
	EXPECT_EQ(Lex("A::B ... ++a-- a&&b||c ^= %= != ==").Tokens, "A~::~B ... ++~a~-- a~&&~b~||~c ^= %= != ==");
}

TEST(HlslLexer, KnowsPlaces)
{
	EXPECT_EQ(LexPlaces("a\n\tb  c"), "a@/T.usf:1:1 b@/T.usf:2:2 c@/T.usf:2:5 @/T.usf:2:6 ");
	EXPECT_EQ(LexPlaces("a\n#line 10 \"/Other.ush\"\nb\n#line 3\nc\n# line 7 \"/T.usf\"\r\nd"),
		"a@/T.usf:1:1 b@/Other.ush:10:1 c@/Other.ush:3:1 d@/T.usf:7:1 @/T.usf:7:2 ");
	EXPECT_EQ(LexPlaces("\"\xc3\xa4\xc3\xb6\" x"), "\"\xc3\xa4\xc3\xb6\"@/T.usf:1:1 x@/T.usf:1:6 @/T.usf:1:7 ");
	EXPECT_EQ(LexPlaces("a /* b\n\n */ c // d\ne"), "a@/T.usf:1:1 c@/T.usf:3:5 e@/T.usf:4:1 @/T.usf:4:2 ");
}

TEST(HlslLexer, KeepsEachFileOnce)
{
	std::vector<std::string> Files;
	std::vector<FDiagnostic> Errors;
	ReadTokens("#line 1 \"/A\"\na\n#line 1 \"/B\"\nb\n#line 2 \"/A\"\nc", "/T.usf", Files, Errors);
	EXPECT_EQ(Files, (std::vector<std::string>{"/T.usf", "/A", "/B"}));
	EXPECT_TRUE(Errors.empty());
}

TEST(HlslLexer, GivesStringsAndPragmasWhole)
{
	EXPECT_EQ(Lex("x \"a \\\" b\" y").Tokens, "x \"a \\\" b\" y");
	std::vector<std::string> Files;
	std::vector<FDiagnostic> Errors;
	const std::string Text = "  #pragma pack_matrix(row_major)  \nx";
	const std::vector<FToken> Tokens = ReadTokens(Text, "/T.usf", Files, Errors);
	ASSERT_EQ(Tokens.size(), 3u);
	EXPECT_EQ(Tokens[0].Kind, EToken::Pragma);
	EXPECT_EQ(Tokens[0].Text, "#pragma pack_matrix(row_major)");
	EXPECT_EQ(Tokens[2].Kind, EToken::End);
}

TEST(HlslLexer, SaysWhatItCannotRead)
{
	EXPECT_EQ(Lex("a\n  @ b").Errors, "/T.usf:2:3: error: X3000: syntax error: unexpected character '@' [DD6010]\n");
	EXPECT_EQ(Lex("x = \"abc\ny").Errors,
		"/T.usf:1:5: error: X3000: syntax error: expected '\"' at the end of the string [DD6010]\n");
	EXPECT_EQ(Lex("#define A\nb").Errors, "/T.usf:1:1: error: X1506: unexpected directive '#define'; the text is "
										  "preprocessed already, and only #line and "
										  "#pragma are read here [DD6010]\n");
	EXPECT_EQ(Lex("#line\nb").Errors,
		"/T.usf:1:1: error: X3000: syntax error: expected #line and a number, then perhaps \"the file\" [DD6010]\n");
	EXPECT_EQ(Lex("#line 99999999999\nb").Errors.substr(0, 20), "/T.usf:1:1: error: X");
	EXPECT_EQ(Lex("'a").Errors,
		"/T.usf:1:1: error: X3000: syntax error: expected ''' at the end of the character [DD6010]\n");
	EXPECT_EQ(Lex("a /* b").Errors,
		"/T.usf:1:3: error: X3000: syntax error: unexpected end of file; expected '*/' of the comment [DD6010]\n");
	EXPECT_EQ(Lex(std::string("a \0\x80\xff b", 7)).Tokens, "a b");
}

TEST(HlslLexer, EndsForTextsCutAnywhere)
{
	const std::string Text =
		"#line 3 \"/A\"\nfloat4 A = 1.0e-5f.xxxx; /* c */ \"str\\\"\" 0x1F 'c' 1.#INF // d\n#pragma x";
	for (size_t Size = 0; Size <= Text.size(); ++Size)
	{
		Lex(Text.substr(0, Size));
	}
}

} // namespace
