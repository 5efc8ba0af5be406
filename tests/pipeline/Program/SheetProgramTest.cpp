// `drydock sheet`: pictures side by side in one file.
#include "ProgramTestUtils.h"

using namespace ProgramTest;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

} // namespace

TEST(SheetProgram, PutsRunsSideBySide)
{
	const FProgramFolder Folder("sheet");
	EXPECT_EQ(0, Folder.Call("run " + Configs + "neutral.json --out first").ExitCode);
	const FOutcome Sheet =
		Folder.Call("sheet first first/final.png --caption \"One\" --width 64 --columns 2 --out made/sheet.png");
	EXPECT_EQ(0, Sheet.ExitCode) << Sheet.Printed;
	EXPECT_EQ("made/sheet.png: 2 pictures, 152 x 74 pixels\n", Sheet.Printed); // 64 x 36 each
	EXPECT_TRUE(std::filesystem::exists(Folder.Path / "made/sheet.png"));
}

TEST(SheetProgram, TellsOfWrongArguments)
{
	const FProgramFolder Folder("sheet");
	EXPECT_EQ(0, Folder.Call("run " + Configs + "neutral.json --out first").ExitCode);
	const FOutcome Missing = Folder.Call("sheet first none.png --out sheet.png");
	EXPECT_EQ(3, Missing.ExitCode);
	EXPECT_NE(std::string::npos, Missing.Printed.find("none.png"));
	EXPECT_EQ(2, Folder.Call("sheet first --out sheet.jpg").ExitCode);
	EXPECT_EQ(2, Folder.Call("sheet first").ExitCode);
	EXPECT_EQ(2, Folder.Call("sheet first --out sheet.png --caption a --caption b").ExitCode);
	EXPECT_EQ(2, Folder.Call("sheet first --out sheet.png --inset 0,0,10,10,0").ExitCode);
	EXPECT_EQ(2, Folder.Call("sheet first --out sheet.png --crop 0,0,ten,10").ExitCode);
	const FOutcome Outside = Folder.Call("sheet first --out sheet.png --crop 900,0,100,10");
	EXPECT_EQ(2, Outside.ExitCode);
	EXPECT_NE(std::string::npos, Outside.Printed.find("960 x 540"));
	EXPECT_FALSE(std::filesystem::exists(Folder.Path / "sheet.png"));
}
