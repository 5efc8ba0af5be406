// What is read out of a run: of one that failed its messages, of one that did not its run.json.
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "Matrix/MatrixRunReport.h"

using namespace Drydock;

TEST(MatrixRunReport, TheFirstErrorIsThatOfDrydock)
{
	const FMatrixMessage Crash = FindFirstError(
		"LogTint: hello\nwarning DD2070 at extension FTint: not called\n"
		"error DD2086 at plugin libTint.so, SetupView of extension FTint: the plugin crashed: segmentation fault\n"
		"error DD2015 at pass X: later\n");
	EXPECT_EQ(2086, Crash.Code);
	EXPECT_EQ("plugin libTint.so, SetupView of extension FTint", Crash.Where);
	EXPECT_EQ("the plugin crashed: segmentation fault", Crash.Text);
	EXPECT_EQ("", Crash.File);
	EXPECT_EQ(0, Crash.Line);
}

TEST(MatrixRunReport, PlacesAreRead)
{
	const FMatrixMessage OfConfig = FindFirstError("configs/a.json:12:7: error DD1012 at /volumes/0: unknown setting");
	EXPECT_EQ(1012, OfConfig.Code);
	EXPECT_EQ("configs/a.json", OfConfig.File);
	EXPECT_EQ(12, OfConfig.Line);
	EXPECT_EQ("/volumes/0", OfConfig.Where);

	const FMatrixMessage OfShader = FindFirstError("/Plugin/Tint/Tint.usf:9: error: 'Foo' : undeclared [DD6010]");
	EXPECT_EQ(6010, OfShader.Code);
	EXPECT_EQ("/Plugin/Tint/Tint.usf", OfShader.File);
	EXPECT_EQ(9, OfShader.Line);
	EXPECT_EQ("'Foo' : undeclared", OfShader.Text);

	const FMatrixMessage OfFile = FindFirstError("out/a: error DD5004: cannot be written");
	EXPECT_EQ(5004, OfFile.Code);
	EXPECT_EQ("out/a", OfFile.File);
	EXPECT_EQ(0, OfFile.Line);
}

// Every way in which FDiagnostic writes an error is read back.
TEST(MatrixRunReport, ReadsWhatDiagnosticsWrite)
{
	for (const FDiagnostic& Said : std::vector<FDiagnostic>{
			 {.Code = 2015, .Message = "a: b", .Where = "pass X, parameter Y"},
			 {.Code = 1010, .Message = "no", .File = "a b.json", .Line = 3, .Column = 4, .Where = "/view"},
			 {.Code = 1010, .Message = "no", .File = "a.json", .Line = 3},
			 {.Code = 6010, .Message = "no", .File = "X.usf", .Line = 3},
			 {.Code = 5001, .Message = "cannot be read", .File = "a.exr"},
		 })
	{
		const FMatrixMessage Read = FindFirstError("before\n" + Said.ToString() + "\nafter\n");
		EXPECT_EQ((FMatrixMessage{Said.Code, Said.File, Said.Line, Said.Where, Said.Message}), Read) << Said.ToString();
	}
}

TEST(MatrixRunReport, WithoutANumberTheLastLineSpeaks)
{
	const FMatrixRun Run = ReadMatrixRun(139, "first\nlast\n\n", "not read");
	ASSERT_TRUE(Run.FirstError);
	EXPECT_EQ("last", Run.FirstError->Text);
	EXPECT_EQ(0, Run.FirstError->Code);
	EXPECT_FALSE(Run.Ran());
}

TEST(MatrixRunReport, ARunIsItsPassesAndWarnings)
{
	const FMatrixRun Run = ReadMatrixRun(0, "warning DD2070: printed, too\n", R"({
		"extensionCalls": [
			{"hook": "SetupView", "view": "View", "extension": "FTint", "did": "called"},
			{"hook": "MotionBlur", "view": "View", "extension": "FTint", "did": "subscribed"}],
		"passes": [
			{"index": 1, "name": "Tonemap 4x2", "executed": true, "shader": "FTonemapPS",
				"written": {"Tonemap": "aa", "Other": "bb"}},
			{"index": 2, "name": "Tint", "executed": false, "shader": ""}],
		"warnings": [{"code": "DD2070", "message": "not called", "where": "extension FTint"}]
	})");
	EXPECT_TRUE(Run.Ran());
	EXPECT_FALSE(Run.FirstError);
	EXPECT_EQ((std::vector<std::string>{"FTint"}), Run.Extensions);
	ASSERT_EQ(2u, Run.Passes.size());
	EXPECT_EQ("Tonemap 4x2", Run.Passes[0].Name);
	EXPECT_TRUE(Run.Passes[0].bExecuted);
	EXPECT_EQ("FTonemapPS", Run.Passes[0].Shader);
	EXPECT_EQ((std::vector<FMatrixTexture>{{"Tonemap", "aa"}, {"Other", "bb"}}), Run.Passes[0].Written);
	EXPECT_FALSE(Run.Passes[1].bExecuted);
	ASSERT_EQ(1u, Run.Warnings.size());
	EXPECT_EQ((FMatrixMessage{2070, "", 0, "extension FTint", "not called"}), Run.Warnings[0]);
}

// A plugin may print whatever it likes.
TEST(MatrixRunReport, LongLinesAndNumbersAreRead)
{
	const FMatrixMessage Found =
		FindFirstError(std::string(1000000, 'x') + "\na.json:99999999999:7: error DD1012: no\n");
	EXPECT_EQ(1012, Found.Code);
	EXPECT_EQ(0, Found.Line);
}
