// Text of strangers is printed whole, and does not steer a terminal.
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "PrintText.h"

using namespace Drydock;

TEST(PrintText, CharactersOfUtf8StayWhole)
{
	const std::string Text = "B\xC3\xA4ume, \xE2\x82\xAC, \xF0\x9F\x8E\xA8\tand\n\xC2\xA0\xED\x9F\xBF\xEE\x80\x80";
	EXPECT_EQ(Text, MakePrintable(Text));
}

TEST(PrintText, ControlCharactersBecomeTheirNumbers)
{
	EXPECT_EQ("\\u001b]0;owned\\u0007\\u001b[2J\\u000d", MakePrintable("\x1b]0;owned\x07\x1b[2J\r"));
	EXPECT_EQ(
		"\\u0000\\u007f\\u0080\\u009b\\u009f2J", MakePrintable(std::string("\0", 1) + "\x7F\xC2\x80\xC2\x9B\xC2\x9F"
																					  "2J"));
	EXPECT_EQ("\\u202egnp.\\u2066", MakePrintable("\xE2\x80\xAEgnp.\xE2\x81\xA6"));
	EXPECT_EQ("a\\u000ab\\u0009", MakePrintable("a\nb\t", false));
}

TEST(PrintText, BytesThatAreNoCharacterAreReplaced)
{
	const std::string Replaced = "\xEF\xBF\xBD";
	EXPECT_EQ("a" + Replaced + "b", MakePrintable("a\x9B"
												  "b")); // a C1 control where a terminal reads bytes
	EXPECT_EQ(Replaced + Replaced, MakePrintable("\xC0\x80"));
	EXPECT_EQ(Replaced + Replaced + "[", MakePrintable("\xE2\x82["));
	EXPECT_EQ(Replaced + Replaced + Replaced, MakePrintable("\xED\xA0\x80"));
	EXPECT_EQ(Replaced, MakePrintable("\xF5"));
}

TEST(PrintText, OnlyTheStylesOfTablesArePrintedAsTheyAre)
{
	testing::internal::CaptureStdout();
	PrintText(stdout, "\x1b[1mname\x1b[0m \x1b[2mdim\x1b[0m \x1b[2J\n");
	std::fflush(stdout);
	EXPECT_EQ("\x1b[1mname\x1b[0m \x1b[2mdim\x1b[0m \\u001b[2J\n", testing::internal::GetCapturedStdout());
	EXPECT_EQ("\\u001b[1m", MakePrintable("\x1b[1m"));
}

TEST(PrintText, DiagnosticsAreOneLineUpToTheirMessage)
{
	const FDiagnostic Diagnostic = {
		ESeverity::Error, 1005, "no key \x1b[2J\nof this name", "a\n.json", 1, 2, "/\x07\n"};
	EXPECT_EQ(
		"a\\u000a.json:1:2: error DD1005 at /\\u0007\\u000a: no key \\u001b[2J\nof this name", Diagnostic.ToString());
}
