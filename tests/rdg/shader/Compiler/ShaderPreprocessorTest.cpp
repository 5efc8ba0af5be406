// Macros, conditions and includes come to what the rules of C say, in the lines where they stand. Against the system's
// C preprocessor on texts drawn at random.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ChildProcess.h"
#include "ShaderCondition.h"
#include "ShaderHarness.h"
#include "ShaderPreprocessor.h"

#include <filesystem>
#include <fstream>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;
using testing::Not;

struct FPreprocessed
{
	std::string Text; // without #line
	std::string Errors;
};

FPreprocessed Preprocess(const std::string& Text, const std::map<std::string, std::string>& Files = {})
{
	FShaderPreprocessor Preprocessor(
		[&Files](const std::string& Target, const std::string&, int)
		{
			const auto Found = Files.find(Target);
			return FShaderInclude{Target, Found == Files.end() ? nullptr : &Found->second};
		});
	Preprocessor.Append("/T/A.usf", Text);
	FPreprocessed Result;
	std::istringstream Lines(Preprocessor.GetText());
	for (std::string Line; std::getline(Lines, Line);)
	{
		Result.Text += Line.starts_with("#line") ? std::string() : Line + "\n";
	}
	for (const FDiagnostic& Error : Preprocessor.GetErrors())
	{
		Result.Errors += Error.ToString() + "\n";
	}
	return Result;
}

/** Words and signs with one blank between them. */
std::string Normalize(const std::string& Text)
{
	std::string Result;
	for (const FShaderToken& Token : SplitTokens(Text))
	{
		Result += Token.Text + " ";
	}
	return Result;
}

std::string Expand(const std::string& Text)
{
	return Normalize(Preprocess(Text).Text);
}

/** Random macros of four names, with and without parameters, that use each other, # and ##, and lines that call them.
 */
std::string MakeRandomMacros(std::mt19937& Random)
{
	const auto Pick = [&Random](int Count)
	{
		return int(Random() % uint32_t(Count));
	};
	const auto MakeBody = [&](const std::string& Parameter, int Depth, const auto& Self) -> std::string
	{
		std::string Body;
		for (int i = Pick(3); i >= 0; --i)
		{
			switch (Pick(Depth > 0 ? 4 : 6))
			{
			case 0:
				Body += " " + std::to_string(Pick(9));
				break;
			case 1:
				Body += Parameter.empty() ? " +" : " " + Parameter;
				break;
			case 2:
				Body += std::string(" M") + char('0' + Pick(4));
				break;
			case 3:
				Body += Parameter.empty() ? " y" : " x##y";
				break;
			case 4:
				Body += " (" + Self(Parameter, Depth + 1, Self) + ")";
				break;
			default:
				Body += std::string(" M") + char('0' + Pick(4)) + "(" + Self(Parameter, Depth + 1, Self) + ")";
				break;
			}
		}
		return Body;
	};
	std::string Text;
	for (char Name = '0'; Name < '4'; ++Name)
	{
		const bool bFunction = Pick(2) == 0;
		Text += std::string("#define M") + Name + (bFunction ? "(a)" : "") +
				MakeBody(bFunction ? "a" : "", 0, MakeBody) + "\n";
	}
	for (int i = 0; i < 4; ++i)
	{
		Text += "<" + MakeBody("", 0, MakeBody) + " >\n";
	}
	return Text;
}

} // namespace

TEST(ShaderPreprocessor, AFileIsIncludedEachTimeUnlessItSaysOnce)
{
	const std::map<std::string, std::string> Files = {{"/T/Each.ush", "int NAME;\n"},
		{"/T/Once.ush", "#pragma once\nint Once;\n"},
		{"/T/Loop.ush", "#include \"/T/Loop.ush\"\n#include \"/T/Loop.ush\"\n"}};
	const FPreprocessed Found =
		Preprocess("#define NAME A\n#include \"/T/Each.ush\"\n#include \"/T/Once.ush\"\n#undef NAME\n"
				   "#define NAME B\n#include \"/T/Each.ush\"\n#include \"/T/Once.ush\"\n",
			Files);
	EXPECT_EQ("int A ; int Once ; int B ; ", Normalize(Found.Text));
	EXPECT_EQ("", Found.Errors);
	EXPECT_THAT(Preprocess("#include \"/T/Loop.ush\"\n", Files).Errors, HasSubstr("includes are nested too deeply"));
}

TEST(ShaderPreprocessor, PasteAtAMacrosEndPastesNothing)
{
	EXPECT_EQ("Field_1_ A ", Normalize(Preprocess("#define F(I) Field_##I##_##\nF(1) A\n").Text));
}

TEST(ShaderPreprocessor, ObjectsAndFunctions)
{
	EXPECT_EQ("a = 4 ; ", Expand("#define N 4\na = N;\n"));
	EXPECT_EQ("f ( ( 1 ) * ( 2 + 3 ) ) ; ", Expand("#define MUL(A, B) ((A) * (B))\nf MUL(1, 2 + 3);\n"));
	EXPECT_EQ("MUL ; ", Expand("#define MUL(A, B) ((A) * (B))\nMUL;\n"));
	EXPECT_EQ("g ( ( 1 , 2 ) , 3 ) ", Expand("#define F(A, B) g(A, B)\nF((1, 2), 3)\n"));
	EXPECT_EQ("1 ; ", Expand("#define F() 1\nF();\n"));
}

TEST(ShaderPreprocessor, AMacroIsNotExpandedInsideItself)
{
	EXPECT_EQ("f ( 2 * f ) ; ", Expand("#define f f(2 * f)\nf;\n"));
	EXPECT_EQ("B ; ", Expand("#define A B\n#define B A\nB;\n"));
}

TEST(ShaderPreprocessor, PastesQuotesAndTakesTheRest)
{
	EXPECT_EQ("float4 View_Extent ; ", Expand("#define VIEWPORT(Name) float4 Name##_Extent;\nVIEWPORT(View)\n"));
	EXPECT_EQ("\"a + b\" ", Expand("#define TEXT(X) #X\nTEXT(a + b)\n"));
	EXPECT_EQ("f ( 1 , 2 , 3 ) ; g ( ) ; ", Expand("#define CALL(F, ...) F(__VA_ARGS__);\nCALL(f, 1, 2, 3) CALL(g)\n"));
	EXPECT_EQ("f ( 1 ) ; f ( 1 , 2 ) ; ", Expand("#define CALL(A, ...) f(A, ##__VA_ARGS__);\nCALL(1) CALL(1, 2)\n"));
	EXPECT_EQ("a ; b ; ", Expand("#define A(X) X;\n#define B A\nB(a) A\n(b)\n"));
}

TEST(ShaderPreprocessor, ACallMayGoOverSeveralLines)
{
	const FPreprocessed Result = Preprocess("#define F(A, B) A + B\nint a = F(1,\n\t2);\nint b;\n");
	EXPECT_EQ("int a = 1 + 2;\n\nint b;\n", Result.Text);
}

TEST(ShaderPreprocessor, LinesStayWhereTheyAre)
{
	EXPECT_EQ("a\n\n\n\nb\n", Preprocess("a // comment\n/* over\nthree\nlines */\nb\n").Text);
	EXPECT_EQ("ab\n\nc\n", Preprocess("a\\\nb\nc\n").Text);
}

TEST(ShaderPreprocessor, Conditions)
{
	EXPECT_EQ("yes ", Expand("#if defined(A) || !defined B && 1\nyes\n#else\nno\n#endif\n"));
	EXPECT_EQ(
		"two ", Expand("#define N 2\n#if N == 1\none\n#elif N == 2\ntwo\n#elif 1 / 0\nnever\n#else\nmore\n#endif\n"));
	EXPECT_EQ("", Expand("#if 0\n#if 1\nno\n#else\nno\n#endif\n#bogus\n#error no\n#endif\n"));
	EXPECT_EQ("yes ", Expand("#define F(X) (X * 2)\n#if F(3) == 6 && UNKNOWN == 0\nyes\n#endif\n"));
}

TEST(ShaderPreprocessor, AnIncludeUnderAFalseConditionIsNotLookedFor)
{
	EXPECT_EQ("", Preprocess("#if 0\n#include \"/Nowhere.ush\"\n#endif\n").Text);
	EXPECT_EQ("int b ; int a ; ",
		Normalize(Preprocess("#define FILE \"/B.ush\"\n#include FILE\nint a;\n", {{"/B.ush", "int b;\n"}}).Text));
}

TEST(ShaderPreprocessor, MistakesHaveFileLineAndReason)
{
	EXPECT_THAT(Preprocess("a\n#if 1\nb\n").Errors, HasSubstr("/T/A.usf:2: error: this #if has no #endif [DD6002]"));
	EXPECT_THAT(Preprocess("#endif\n").Errors, HasSubstr("/T/A.usf:1: error: #endif without #if"));
	EXPECT_THAT(Preprocess("#if 1\n#else\n#else\n#endif\n").Errors, HasSubstr(":3: error: #else behind the #else"));
	EXPECT_THAT(Preprocess("#define F(A, B) A\nF(1)\n").Errors,
		HasSubstr(":2: error: macro 'F' takes 2 arguments and is given 1"));
	EXPECT_THAT(Preprocess("#define F(A) A\nF(1\n").Errors, HasSubstr("'F' has no closing parenthesis"));
	EXPECT_THAT(Preprocess("#if 1 +\n#endif\n").Errors, HasSubstr("it ends where a value is expected"));
	EXPECT_THAT(Preprocess("#if 1 / 0\n#endif\n").Errors, HasSubstr("a division by zero"));
	EXPECT_THAT(Preprocess("#if 0.5\n#endif\n").Errors, HasSubstr("'0.5' is not an integer"));
	EXPECT_THAT(Preprocess("#error \"say so\"\n").Errors, HasSubstr("#error \"say so\""));
	EXPECT_THAT(Preprocess("#includ \"x\"\n").Errors, HasSubstr("there is no directive #includ"));
}

TEST(ShaderPreprocessor, MacrosThatGrowWithoutEndAreStopped)
{
	std::string Text = "#define A0 x x x x\n";
	for (int i = 1; i < 32; ++i)
	{
		const std::string Last = " A" + std::to_string(i - 1);
		Text += "#define A" + std::to_string(i) + Last + Last + Last + Last + "\n";
	}
	EXPECT_THAT(Preprocess(Text + "A31\n").Errors, HasSubstr("expand to more than"));
	std::string Calls;
	for (int i = 0; i < 5000; ++i)
	{
		Calls += "F(";
	}
	EXPECT_THAT(Preprocess("#define F(A) A\n" + Calls + std::string(5000, ')') + "\n").Errors, HasSubstr("deep"));
}

namespace
{

/** Preprocesses; how much of the bound of all macros that took, and the only error. */
struct FSpending
{
	explicit FSpending(const std::string& Text)
	{
		FShaderPreprocessor Preprocessor(
			[](const std::string& Target, const std::string&, int) {
				return FShaderInclude{Target, nullptr};
			});
		Preprocessor.Append("/T/A.usf", Text);
		NumTokens = Preprocessor.GetMacros().GetNumTokens();
		EXPECT_EQ(1u, Preprocessor.GetErrors().size());
		Error = Preprocessor.GetErrors().empty() ? "" : Preprocessor.GetErrors()[0].ToString();
	}

	size_t NumTokens = 0;
	std::string Error;
};

/** Defines A8: 4 to the power of 9 times Leaf. */
std::string DefineBomb(const std::string& Leaf)
{
	std::string Text = "#define A0 " + Leaf + " " + Leaf + " " + Leaf + " " + Leaf + "\n";
	for (int i = 1; i <= 8; ++i)
	{
		const std::string Last = " A" + std::to_string(i - 1);
		Text += "#define A" + std::to_string(i) + Last + Last + Last + Last + "\n";
	}
	return Text;
}

std::string Repeat(const std::string& Text, int Times)
{
	std::string Result;
	for (int i = 0; i < Times; ++i)
	{
		Result += Text;
	}
	return Result;
}

/** The bound, and what the step that goes beyond it takes. */
constexpr size_t GMostTokens = FShaderMacros::MaxTokens + FShaderMacros::MaxLineTokens;

} // namespace

TEST(ShaderPreprocessor, ACallThatGoesOnIsNotExpandedWithoutEnd)
{
	// With each of the lines once more all before it: 350 million tokens, were there no bound.
	const FSpending Unclosed(
		"#if 1\n#define F(A) A\n" + DefineBomb("x") + "A8 F(\n" + Repeat("y\n", 1000) + "#endif\n");
	EXPECT_THAT(Unclosed.Error, HasSubstr("A.usf:12: error"));
	EXPECT_THAT(Unclosed.Error, HasSubstr("the macros of this shader expand to more than 16777216 tokens"));
	EXPECT_LE(Unclosed.NumTokens, GMostTokens);
	// The call's own text is looked through again with each line.
	const FSpending Long("#define F(A) A\nF(\n" + Repeat(Repeat("y ", 200) + "\n", 900));
	EXPECT_THAT(Long.Error, HasSubstr("the macros of this shader expand to more than"));
	EXPECT_LE(Long.NumTokens, GMostTokens);
}

TEST(ShaderPreprocessor, ManyLinesShareOneBound)
{
	const FSpending Nothing("#define E\n" + DefineBomb("E") + Repeat("A8\n", 1000));
	EXPECT_THAT(Nothing.Error, HasSubstr("the macros of this shader expand to more than"));
	EXPECT_LE(Nothing.NumTokens, GMostTokens);
}

TEST(ShaderPreprocessor, ACallIsRefusedBeforeItFillsTheMemory)
{
	// The last call puts 64 to the power of 4 tokens in, or fewer with many letters.
	const std::string Define = "#define D(X)" + Repeat(" X", 64) + "\n";
	const FSpending Tokens(Define + "D(D(D(D(a))))\n");
	EXPECT_THAT(Tokens.Error, HasSubstr("the macros of this line expand to more than 1048576 tokens"));
	EXPECT_LE(Tokens.NumTokens, 4 * FShaderMacros::MaxLineTokens);
	const FSpending Letters(Define + "D(D(D(" + std::string(64 * 64, 'a') + ")))\n");
	EXPECT_THAT(Letters.Error, HasSubstr("the macros of this line expand to more than"));
	EXPECT_LE(Letters.NumTokens, 4 * FShaderMacros::MaxLineTokens);
}

TEST(ShaderCondition, IntegersAsInC)
{
	const FShaderMacros None;
	const auto Evaluate = [&None](const std::string& Text)
	{
		std::string Problem;
		return EvaluateCondition(Text, None, Problem);
	};
	EXPECT_EQ(7, Evaluate("1 + 2 * 3"));
	EXPECT_EQ(1, Evaluate("(1 << 4) - 15"));
	EXPECT_EQ(-2, Evaluate("-7 / 3"));
	EXPECT_EQ(1, Evaluate("1 || 1 / 0"));
	EXPECT_EQ(5, Evaluate("0 ? 1 / 0 : 5"));
	EXPECT_EQ(255, Evaluate("0xFFu"));
	EXPECT_EQ(1, Evaluate("!0 && ~0 == -1"));
	EXPECT_EQ(4, Evaluate("5 & 4 | 0 ^ 0"));
	EXPECT_EQ(1, Evaluate("true"));
	EXPECT_EQ(std::nullopt, Evaluate("(1"));
	EXPECT_EQ(std::nullopt, Evaluate("1 2"));
}

TEST(ShaderPreprocessor, AgreesWithTheSystemsPreprocessorOnRandomMacros)
{
	// Several texts in one file, so that one process answers for all.
	constexpr int NumTexts = 300;
	std::mt19937 Random(20261122); // seed of the texts
	const std::filesystem::path File = std::filesystem::temp_directory_path() / "drydock-preprocessor-test.h";
	std::string Whole;
	for (int i = 0; i < NumTexts; ++i)
	{
		Whole += MakeRandomMacros(Random) + "#undef M0\n#undef M1\n#undef M2\n#undef M3\n@\n";
	}
	std::ofstream(File) << Whole;
	const FChildResult Child = RunChild({"/usr/bin/cpp", "-P", "-undef", "-w", File.string()}, 30);
	std::filesystem::remove(File);
	if (!Child.Succeeded())
	{
		GTEST_SKIP() << "no C preprocessor: " << Child.Describe(30);
	}
	EXPECT_EQ(Normalize(Child.Output), Normalize(Preprocess(Whole).Text));
}
