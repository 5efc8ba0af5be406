// Mistakes that were tried in a second week of work (the reference of issue 40) and did not lead to their mend by run
// alone: what run says now. Those in plugins and overlays are where plugins are tested.
#include <gmock/gmock.h>

#include "../ProgramTestUtils.h"

using namespace ProgramTest;
using testing::HasSubstr;

namespace
{

static_assert(sizeof(DRYDOCK_TEST_BINARY_DIR) > 1); // which files that name it are given: the program is there

struct FMistake
{
	const char* More;      // behind the config's scene
	const char* Arguments; // of run
	int ExitCode;
	const char* Said;
};

const FMistake GMistakes[] = {
	{", \"camera\": {},", "", 2, "a comma stands before the closing }; delete the comma"},
	{", \"camera\": {} \"engine\": \"5.4\"", "", 2, "a comma is missing before this"},
	{" # why", "", 2, "# does not begin a comment here; write // or /* */"},
	{", 'engine': '5.4'", "", 2, "a text stands in straight double quotes"},
	{", \"volumes\": [{\"bUnbound\": true, \"BloomIntensity\": 1}]", "", 2, "belongs in \"Settings\" beside it"},
	{"", "--set r.BloomQuality 5", 2, "--set takes r.NAME=VALUE as one word: --set r.BloomQuality=5"},
	{"", "--pp BloomIntensity 5", 2, "--pp takes SETTING=VALUE as one word: --pp BloomIntensity=5"},
	{"", "--dump CombineLUTss", 0, "did you mean CombineLUTs"},
	{"", "--dump 'Combinee*'", 0, "did you mean Combin"},
	{"", "--dump Tonemap.ViewFamilyTextur", 0, "did you mean Tonemap.ViewFamilyTexture"},
};

} // namespace

TEST(Mistakes, OfConfigAndCommandLineSayWhatToWrite)
{
	const FProgramFolder Folder("mistakes");
	for (const FMistake& Mistake : GMistakes)
	{
		Folder.WriteFrame("a.json", Mistake.More);
		const FOutcome Outcome = Folder.Call(std::string("run a.json ") + Mistake.Arguments);
		EXPECT_EQ(Mistake.ExitCode, Outcome.ExitCode) << Mistake.More << Mistake.Arguments << Outcome.Printed;
		EXPECT_THAT(Outcome.Printed, HasSubstr(Mistake.Said));
	}
}

TEST(Mistakes, APathOfWindowsAndARawRenderAsScene)
{
	const FProgramFolder Folder("mistakes_scene");
	Folder.Write("w.json", R"({"scene": {"file": "C:\\frames\\a.exr"}})");
	const FOutcome Windows = Folder.Call("run w.json");
	EXPECT_EQ(3, Windows.ExitCode);
	EXPECT_THAT(Windows.Printed, HasSubstr("/mnt/c/frames/a.exr"));
	Drydock::FImage Image{8, 4, 5, std::vector<double>(8 * 4 * 5, 0.5)};
	Drydock::WriteExr((Folder.Path / "raw.exr").string(), Image,
		{"R", "G", "B", "FinalImageWorldDepth.R", "FinalImageWorldNormal.X"});
	Folder.Write("raw.json", R"({"scene": {"file": "raw.exr"}})");
	const FOutcome Raw = Folder.Call("run raw.json");
	EXPECT_EQ(0, Raw.ExitCode) << Raw.Printed;
	EXPECT_THAT(Raw.Printed, HasSubstr("drydock import raw.exr"));
	Folder.WriteFrame("plain.json", "");
	EXPECT_THAT(Folder.Call("run plain.json").Printed, testing::Not(HasSubstr("drydock import")));
}

TEST(Mistakes, OfShadersAreSaidByRun)
{
	const FProgramFolder Folder("mistakes_shader");
	ASSERT_EQ(0, Folder.Call("overlay new O --pass BloomSetup").ExitCode);
	// The shader alone: what the overlay has of C++ would be built first.
	Files::remove_all(Folder.Path / "O/Engine/Source");
	const std::string File = "O/Engine/Shaders/Private/PostProcessBloom.usf";
	const std::string Text = Folder.Read(File);
	const std::string Return = "	return float4(LinearColor * View.PreExposure, 0.0f);";
	const std::string Out = "	OutColor = BloomSetupCommon(";
	const std::string Target = "	out float4 OutColor : SV_Target0)";
	struct FEdit
	{
		std::string From;
		std::string To;
		int ExitCode;
		const char* Said;
	};
	const FEdit Edits[] = {
		{Return, "	float W; if (UV.x > 2.0f) W = 0.5f; return float4(LinearColor * W, 0.0f);", 0,
			"X4000: use of potentially uninitialized variable 'W'"},
		{Return, "	float W; return float4(LinearColor * W, 0.0f);", 0, "'W': nothing sets it"},
		{Out, "	if (UV.x > 0.5f) OutColor = BloomSetupCommon(", 0, "X3508: output parameter 'OutColor'"},
		{Return, "	return float4(LinearColor * (1 / 2), 0.0f);", 0, "a division of whole numbers loses its fraction"},
		{Return, "#if USE_THRESHOLDD\n	LinearColor = 0;\n#endif\n" + Return, 0,
			"'USE_THRESHOLDD', which counts as 0; did you mean USE_THRESHOLD?"},
		{Return, "	while (true) { LinearColor *= 0.99f; }\n" + Return, 2, "X3696: infinite loop"},
		{Target, "	out float4 OutColor : SV_Target0, out float4 Second : SV_Target1)\n{\n	Second = 1;", 0,
			"the shader writes SV_Target1, and the pass binds 1 render target"},
		{"void BloomSetupPS(", "void MainPS(", 2,
			"entry point 'BloomSetupPS' does not exist in this shader; it has MainPS"},
	};
	for (const FEdit& Edit : Edits)
	{
		std::string Edited = Text;
		const size_t At = Edited.find(Edit.From);
		ASSERT_NE(std::string::npos, At) << Edit.From;
		const size_t Length = Edit.From.size() + (Edit.From == Target ? 3 : 0); // with the brace that follows
		Edited.replace(At, Length, Edit.To);
		Folder.Write(File, Edited);
		const FOutcome Outcome = Folder.Call("run O/O.json --report off");
		EXPECT_EQ(Edit.ExitCode, Outcome.ExitCode) << Edit.To << "\n" << Outcome.Printed;
		EXPECT_THAT(Outcome.Printed, HasSubstr(Edit.Said));
	}
	Folder.Write(File, Text);
	EXPECT_THAT(Folder.Call("run O/O.json --report off").Printed, testing::Not(HasSubstr("DD6024")));
}
