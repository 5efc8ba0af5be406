// check, lint and warm --all look at every shader class of a config's plugins, seen in a pass or not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"

#include "Run/PluginShaders.h"
#include "Run/RunErrors.h"

namespace
{

using namespace ProgramTest;
using testing::HasSubstr;
using testing::Not;

const std::string Plugin = R"("plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libLambdaPass.so"])";
const std::string Broken = R"(, "cvars": {"r.LambdaPass.Broken": 1})";
const std::string Message = "/Plugin/LambdaPass/LambdaPass.usf:15:15: error: X3004: undeclared identifier 'Missing'";

size_t Count(const std::string& Text, const std::string& Part)
{
	size_t Found = 0;
	for (size_t At = Text.find(Part); At != std::string::npos; At = Text.find(Part, At + 1))
	{
		++Found;
	}
	return Found;
}

} // namespace

TEST(PluginShaders, CheckCountsClassesThatNoPassShows)
{
	const FProgramFolder Folder("plugin_shaders_check");
	Folder.WriteFrame("a.json", ", " + Plugin);
	const FOutcome Outcome = Folder.Call("check a.json");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed,
		HasSubstr("a.json: no errors; looked at 2 shader classes of its plugins, 259 permutations\n")); // 256 and 3
	EXPECT_THAT(Outcome.Printed, HasSubstr("note DD6013"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("shader class FLambdaWideCS: 44 of its 300 permutations are not looked at"));
	EXPECT_THAT(Folder.Call("check a.json --json").Printed, HasSubstr(R"("code": "DD6013")"));
}

TEST(PluginShaders, CheckFindsTheBrokenOneOnce)
{
	const FProgramFolder Folder("plugin_shaders_broken");
	Folder.WriteFrame("a.json", ", " + Plugin + Broken);
	Folder.Write("nothing.json", "{" + Plugin + Broken + "}");
	for (const char* const Call : {"check a.json", "check nothing.json", "warm --cache cache --all a.json"})
	{
		const FOutcome Outcome = Folder.Call(Call);
		EXPECT_EQ(2, Outcome.ExitCode) << Call << Outcome.Printed;
		EXPECT_EQ(1u, Count(Outcome.Printed, Message)) << Call << Outcome.Printed;
		EXPECT_THAT(Outcome.Printed, HasSubstr("(compiled for FLambdaBrokenCS, entry BrokenCS)")) << Call;
	}
}

TEST(PluginShaders, LintLooksAtThemToo)
{
	const FProgramFolder Folder("plugin_shaders_lint");
	Folder.WriteFrame("a.json", "");
	Folder.WriteFrame("b.json", ", " + Plugin);
	Folder.WriteFrame("c.json", ", " + Plugin + Broken);
	const int Without = std::stoi(Folder.Call("lint a.json").Printed);
	const FOutcome With = Folder.Call("lint b.json");
	EXPECT_EQ(0, With.ExitCode) << With.Printed;
	EXPECT_THAT(With.Printed, HasSubstr(std::to_string(Without + 259) + " shaders looked at, "));
	EXPECT_THAT(With.Printed, HasSubstr("44 of its 300 permutations are not looked at"));
	const FOutcome Fails = Folder.Call("lint c.json");
	EXPECT_EQ(2, Fails.ExitCode);
	EXPECT_THAT(Fails.Printed, HasSubstr(Message));
}

TEST(PluginShaders, WarmCompilesTheRestWhereItIsAsked)
{
	const FProgramFolder Folder("plugin_shaders_warm");
	Folder.WriteFrame("broken.json", ", " + Plugin + Broken);
	EXPECT_EQ(0, Folder.Call("warm --cache cache broken.json").ExitCode); // its frame does not use the class
	Folder.WriteFrame("a.json", ", " + Plugin);
	const FOutcome All = Folder.Call("warm --cache cache --all a.json");
	EXPECT_EQ(0, All.ExitCode) << All.Printed;
	EXPECT_THAT(All.Printed, HasSubstr("warmed 2 shader classes of its plugins, 259 permutations\n"));
	EXPECT_THAT(All.Printed, HasSubstr("44 of its 300 permutations are not looked at"));
	EXPECT_THAT(Folder.Call("warm --cache cache a.json").Printed, Not(HasSubstr("shader class")));
}

TEST(PluginShaders, APassWithoutAShaderIsNamedWhereNoClassStandsForIt)
{
	Drydock::FRDGCompiledGraph Graph;
	for (const char* const Owner : {"plugin libSeen.so, X of Y", "plugin libBlind.so, X of Y", ""})
	{
		Drydock::FRDGCompiledPass Pass;
		Pass.Name = "Lambda";
		Pass.Owner = Owner;
		Graph.Passes.push_back(Pass);
		Pass.Name = "ClearRenderTarget(X) 8x8";
		Graph.Passes.push_back(Pass);
		Pass.Name = "ReadBack";
		Pass.Flags = ERDGPassFlags::Copy;
		Graph.Passes.push_back(Pass);
	}
	Drydock::FPluginShaders Shaders;
	Shaders.Plugins = {"libSeen.so"};
	const std::vector<Drydock::FDiagnostic> Notes = FindUnseenPasses(Graph, Shaders);
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(Drydock::NoteShaderNotLookedAt, Notes[0].Code);
	EXPECT_THAT(Notes[0].ToString(), HasSubstr("pass Lambda, plugin libBlind.so"));
	Graph.Passes[3].bCulled = true;
	EXPECT_TRUE(FindUnseenPasses(Graph, Shaders).empty());
}
