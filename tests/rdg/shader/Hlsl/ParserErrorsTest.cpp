// What the parser says of texts that are no HLSL; and that no text brings it down.
#include <gtest/gtest.h>

#include "TreePrinter.h"

#include <chrono>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Hlsl;
using namespace Drydock::Hlsl::Test;

/** Without the file and the number that every one has. */
std::string ParseErrors(const std::string& Text)
{
	std::vector<FDiagnostic> Errors;
	Parse(Text, "/T.usf", Errors);
	std::string Said;
	for (const FDiagnostic& Error : Errors)
	{
		EXPECT_EQ(Error.Code, 6010);
		Said += (Said.empty() ? "" : "\n") + std::to_string(Error.Line) + ":" + std::to_string(Error.Column) + " " +
				Error.Message;
	}
	return Said;
}

std::string ParseBodyErrors(const std::string& Text)
{
	return ParseErrors("void F()\n{\n" + Text + "\n}");
}

TEST(HlslParserErrors, NamesTheTokenAndWhatWasExpected)
{
	const std::string X = "X3000: syntax error: unexpected token ";
	EXPECT_EQ(
		ParseBodyErrors("int x = 1\nint y = 2;"), "4:1 " + X + "'int'; expected ';' behind the declaration of 'x'");
	EXPECT_EQ(ParseBodyErrors("x = y\nz = 1;"), "4:1 " + X + "'z'; expected ';' behind the expression");
	EXPECT_EQ(ParseBodyErrors("x = ;"), "3:5 " + X + "';'; expected an expression");
	EXPECT_EQ(ParseBodyErrors("x = (1 + 2;"), "3:11 " + X + "';'; expected ')' of the '(' in line 3, column 5");
	EXPECT_EQ(ParseBodyErrors("F(1, 2;"), "3:7 " + X + "';'; expected ')' or ',' behind the argument");
	EXPECT_EQ(ParseBodyErrors("x[1;"), "3:4 " + X + "';'; expected ']' behind the index");
	EXPECT_EQ(ParseBodyErrors("x.1;").substr(0, 10), "3:2 X3000:");
	EXPECT_EQ(ParseBodyErrors("x.(1);"), "3:3 " + X + "'('; expected a member's name or a swizzle behind '.'");
	EXPECT_EQ(ParseBodyErrors("x = float4;"),
		"3:11 " + X + "';'; expected '(' behind the type 'float4', which is not a value");
	EXPECT_EQ(ParseBodyErrors("x = {1, 2};"),
		"3:5 " + X + "'{'; expected an expression; a list in braces stands only behind the '=' of a declaration");
	EXPECT_EQ(ParseBodyErrors("goto x;"), "3:1 " + X + "'goto'; expected a statement");
	EXPECT_EQ(ParseBodyErrors("float out;"), "3:10 " + X + "';'; expected a name to declare");
	EXPECT_EQ(ParseBodyErrors("float float3 = 1;"), "3:7 " + X + "'float3'; expected a name to declare");
	EXPECT_EQ(ParseErrors("Foo<Bar> x;"),
		"1:1 X3000: unrecognized identifier 'Foo'; no template of this name is declared before it");
	EXPECT_EQ(ParseErrors("x = 3;"), "1:3 " + X + "'='; expected a name to declare");
	EXPECT_EQ(ParseErrors("struct S { int a; }\nfloat4 F();"),
		"2:1 " + X + "'float4'; expected ';' or a variable behind the struct");
	EXPECT_EQ(ParseErrors("int x;\n}\nint y;"), "2:1 " + X + "'}'; expected a type");
	EXPECT_EQ(ParseErrors("void F(int a int b) { }"), "1:14 " + X + "'int'; expected ')' or ',' behind the parameter");
	EXPECT_EQ(ParseErrors("cbuffer { int x; };"), "1:9 " + X + "'{'; expected the name of the buffer");
	EXPECT_EQ(
		ParseErrors("void F() { [unroll for (;;) { } }"), "1:20 " + X + "'for'; expected ']' behind the attribute");
	EXPECT_EQ(ParseErrors("int x : 3;"),
		"1:9 " + X + "'3'; expected a semantic, 'register(...)' or 'packoffset(...)' behind ':'");
	EXPECT_EQ(ParseErrors("enum E { A B };"), "1:12 " + X + "'B'; expected '}' of the '{' in line 1");
}

TEST(HlslParserErrors, SaysWhatHlslHasInstead)
{
	const std::string X = "X3000: syntax error: unexpected token ";
	EXPECT_EQ(ParseErrors("float* p;"),
		"1:6 " + X + "'*'; HLSL has no pointers and references: write inout for an argument that is changed");
	EXPECT_EQ(ParseErrors("void F(float& p);").substr(0, 5), "1:13 ");
	EXPECT_EQ(ParseErrors("template<typename T> struct { T a; };"),
		"1:1 X3000: syntax error: a template needs a name, by which it is used");
	EXPECT_EQ(ParseErrors("interface I { void F(); };"),
		"1:1 " + X + "'interface', which is reserved; interfaces are not supported: write a template");
	EXPECT_EQ(ParseErrors("struct S { virtual void F(); };"),
		"1:12 " + X + "'virtual', which is reserved; HLSL has no virtual");
	EXPECT_EQ(ParseBodyErrors("float4 x(1, 2, 3, 4);"),
		"3:10 " + X + "'1'; expected a parameter's type; a variable's value stands behind '=': T x = T(...)");
	EXPECT_EQ(ParseBodyErrors("int G() { return 1; }"),
		"3:9 " + X + "'{'; a function cannot be defined inside of a function");
	EXPECT_EQ(ParseBodyErrors("while (int x = 1) { }"),
		"3:8 X3000: syntax error: a variable cannot be declared in the condition of 'while'; declare it before");
	EXPECT_EQ(ParseBodyErrors("case 1: x;"), "3:1 " + X + "'case'; labels stand right in the braces of a 'switch'");
	EXPECT_EQ(ParseBodyErrors("x; else y;"),
		"3:4 " + X + "'else'; no 'if' stands before it: an 'if' has one statement, or several in braces");
	EXPECT_EQ(
		ParseBodyErrors("cbuffer X { int a; };"), "3:1 " + X + "'cbuffer'; it stands outside of functions and structs");
	EXPECT_EQ(ParseBodyErrors("a->b;"), "3:2 " + X + "'->'; HLSL has no pointers: write '.'");
}

TEST(HlslParserErrors, GoesOnBehindEachFault)
{
	const std::string X = "X3000: syntax error: unexpected token ";
	EXPECT_EQ(
		ParseErrors("int a = ;\nvoid F() { b = ; for (int i = 0 i < 2; ++i) { c = ; } }\nfloat G( { }\nint h = );"),
		"1:9 " + X + "';'; expected an expression\n2:16 " + X + "';'; expected an expression\n2:33 " + X +
			"'i'; expected ';' behind the declaration of 'i'\n2:51 " + X + "';'; expected an expression\n3:10 " + X +
			"'{'; expected a parameter's type; a variable's value stands behind '=': T G = T(...)\n4:9 " + X +
			"')'; expected an expression");
	EXPECT_EQ(ParseBodyErrors("if (d 1) { } else if (e) { } else { } x = ;\nint a[2] = {1, 2 3}; y = ;"),
		"3:7 " + X + "'1'; expected ')' behind the condition of 'if'\n3:43 " + X +
			"';'; expected an expression\n4:18 " + X +
			"'3'; expected '}' or ',' in the list that begins in line 4\n4:26 " + X + "';'; expected an expression");
	EXPECT_EQ(ParseErrors("struct S { int a b; int c; void F() { } }; int = 3; namespace A { int d e; } int x y;"),
		"1:18 " + X + "'b'; expected ';' behind the declaration of 'a'\n1:48 " + X +
			"'='; expected a name to declare\n1:73 " + X + "'e'; expected ';' behind the declaration of 'd'\n1:84 " +
			X + "'y'; expected ';' behind the declaration of 'x'");
}

TEST(HlslParserErrors, SaysOnceThatTheTextEnds)
{
	EXPECT_EQ(ParseErrors("void F()\n{\nif (a)\n{\nfor (;;)\n{\nx = 1;\n"),
		"8:1 X3000: syntax error: unexpected end of file; expected '}' of the '{' in line 6");
	EXPECT_EQ(ParseErrors("namespace A { struct S { int a"),
		"1:31 X3000: syntax error: unexpected end of file; expected ';' behind the "
		"declaration of 'a'");
}

TEST(HlslParserErrors, StopsAtTwenty)
{
	std::string Text;
	for (int Count = 0; Count < 100; ++Count)
	{
		Text += "int a = ;\n";
	}
	std::vector<FDiagnostic> Errors;
	Parse(Text, "/T.usf", Errors);
	EXPECT_EQ(Errors.size(), MaxErrors);
	Errors.clear();
	std::string Signs;
	for (int Count = 0; Count < 100; ++Count)
	{
		Signs += "@ x $ ";
	}
	Parse(Signs, "/T.usf", Errors);
	EXPECT_EQ(Errors.size(), MaxErrors);
}

std::string RepeatText(const std::string& Text, size_t Count)
{
	std::string All;
	for (size_t Index = 0; Index < Count; ++Index)
	{
		All += Text;
	}
	return All;
}

TEST(HlslParserErrors, BoundsDepth)
{
	const std::string Deep =
		"the text is nested too deep: more than 600 levels of parentheses, blocks, types and operators";
	EXPECT_EQ(ParseBodyErrors("x = " + RepeatText("(", 200) + "1" + RepeatText(")", 200) + ";"), "");
	EXPECT_NE(ParseBodyErrors("x = " + RepeatText("(", 2000) + "1" + RepeatText(")", 2000) + "; y = 1;").find(Deep),
		std::string::npos);
	EXPECT_EQ(ParseBodyErrors("x = " + RepeatText("(", 2000) + "1" + RepeatText(")", 2000) + "; y = 1;").find('\n'),
		std::string::npos);
	for (const char* Each : {"{", "-", "(float)", "a ? ", "a = ", "f(", "a[", "if (a) ", "else if (a) ", "for (;;) ",
			 "{ if (a) ", "do ", "vector<", "G<", "G<G<float>, ", "x.G<float, vector<", "a ? b : ", "sizeof ", "int a[",
			 "struct {", "[a(", "switch (a) {", "float(", "(vector<float, (", "typename ", "static ", "template<",
			 "A::", "int x = {", "a<", "a<float, ", "(a<float", "::"})
	{
		for (const char* Before :
			{"template<typename T> struct G { }; void F() { ", "struct ", "namespace A { ", "int x = ", ""})
		{
			ParseErrors(Before + RepeatText(Each, 20000));
			ParseErrors(Before + ("if (a) b; " + RepeatText(Each, 300)) + "1;");
		}
	}
	for (const char* Each : {"namespace A { ", "struct S { ", "template<typename T> struct S { ", "[a] ", "[[a]] ",
			 "template<int x = ", "cbuffer a { "})
	{
		ParseErrors(RepeatText(Each, 20000));
	}
}

TEST(HlslParserErrors, BoundsTheHeightOfExpressions)
{
	for (const char* Each : {" + 1", ", 1", ".x", "[0]", "(1)", "++", " < 1"})
	{
		EXPECT_EQ(ParseBodyErrors("a" + RepeatText(Each, 900) + ";"), "");
		EXPECT_NE(ParseBodyErrors("a" + RepeatText(Each, 20000) + ";").find("has more than 1024 operators in a row"),
			std::string::npos)
			<< Each;
	}
}

const char* const GWholeText =
	"#line 5 \"/T.usf\"\n#pragma pack_matrix(row_major)\nnamespace A::B { template<typename T, int N = 2> struct P : Q "
	"{ T a[N]; "
	"T F(int x = 3) const { return (T)a[x] + T(1); } T operator+(P o) { return a[0]; } }; }\n"
	"cbuffer C : register(b0, space1) { float4x4 M : packoffset(c0.x); }\nSamplerState S { Filter = A; };\n"
	"enum class E : uint { X = 1, Y };\ntypedef float F3[3]; using V = vector<float, 3>;\n"
	"static const struct { int a; } K = {1};\ntemplate<> float G<float>(A::B::P<int, 3> p) { return 1.xxx.x; }\n"
	"[numthreads(8, 8, 1)] void Main(in uint3 Id : SV_DispatchThreadID, inout float4 x[2]) : SV_Target {\n"
	"[unroll(4)] for (int i = 0; i < 4; ++i) { if (a.x < b && c >>= 1) { x[i] = T.Load<uint>(0).xy; } else discard; }\n"
	"switch (i) { case 1: break; default: return; } do { int y{3}; } while (sizeof(float3) > (uint)1 ? a : b);\n"
	"static_assert(1 < 2, \"no\"); }\n";

TEST(HlslParserErrors, EndsForTextsCutAnywhere)
{
	const std::string Text = GWholeText;
	EXPECT_EQ(ParseErrors(Text), "");
	for (size_t Size = 0; Size < Text.size(); ++Size)
	{
		ParseErrors(Text.substr(0, Size));
		ParseErrors(Text.substr(Size));
	}
}

TEST(HlslParserErrors, EndsForRandomTokens)
{
	std::vector<std::string> Files;
	std::vector<FDiagnostic> Errors;
	const std::string Text = GWholeText;
	const std::vector<FToken> Tokens = ReadTokens(Text, "/T.usf", Files, Errors);
	std::mt19937 Random(1);
	for (int Turn = 0; Turn < 3000; ++Turn)
	{
		std::string Mixed;
		for (int Count = 0; Count < 60; ++Count)
		{
			const FToken& Token = Tokens[Random() % Tokens.size()];
			if (Token.Kind != EToken::Pragma)
			{
				Mixed += std::string(Token.Text) + (Random() % 4 == 0 ? "" : " ");
			}
		}
		ParseErrors(Mixed);
		std::string Mutant = Text; // a text with a few tokens of others
		for (int Count = 0; Count < 3; ++Count)
		{
			const FToken& From = Tokens[Random() % Tokens.size()];
			Mutant.insert(Random() % Mutant.size(), " " + std::string(From.Text) + " ");
		}
		ParseErrors(Mutant);
	}
}

TEST(HlslParserErrors, TakesLittleTimeForLongTexts)
{
	std::string Text;
	for (int Index = 0; Text.size() < 1000000; ++Index)
	{
		Text += "float F" + std::to_string(Index) + "(float a) { return a * 2; }\n";
	}
	Text += "int a = 0" + RepeatText(", b", 100000) + "; struct S0 { struct I { }; };";
	for (int Index = 1; Index < 5000; ++Index)
	{
		Text += "struct S" + std::to_string(Index) + " : S" + std::to_string(Index - 1) + " { typedef I J" +
				std::to_string(Index) + "; };";
	}
	Text += "static int X[] = {" + RepeatText("1, ", 100000) + "}; void F() { " +
			RepeatText("{ int Texture; }", 20000) + RepeatText("x.a < b, ", 900) + "1; }";
	const auto Start = std::chrono::steady_clock::now();
	EXPECT_EQ(ParseErrors(Text), "");
	EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - Start).count(), 5);
}

} // namespace
