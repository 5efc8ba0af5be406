// drydock lint as a user calls it: configs that ship, files by any of their paths, findings and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"

namespace
{

using namespace ProgramTest;
using testing::HasSubstr;

const Files::path Root = DRYDOCK_TEST_SOURCE_DIR;

} // namespace

TEST(LintProgram, ConfigsThatShipAreClean)
{
	const FProgramFolder Folder("lint_configs");
	int NumConfigs = 0;
	for (const Files::directory_entry& Entry : Files::directory_iterator(Root / "configs"))
	{
		if (Entry.path().extension() == ".json")
		{
			const FOutcome Outcome = Folder.Call("lint '" + Entry.path().string() + "'");
			EXPECT_EQ(0, Outcome.ExitCode) << Entry.path();
			EXPECT_THAT(Outcome.Printed, HasSubstr(" looked at, 0 findings")) << Entry.path();
			++NumConfigs;
		}
	}
	EXPECT_LT(20, NumConfigs);
}

TEST(LintProgram, AFileOfTwoMappingsHasTheClassesOfBoth)
{
	const FProgramFolder Folder("lint_file");
	const FOutcome Outcome = Folder.Call("lint '" + (Root / "passes/Shaders/Drydock/FourTapBlur.usf").string() + "'");
	EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr(" looked at, 0 findings")); // without a class it would not compile
}

TEST(LintProgram, FindingsAreNamedThoughAnotherShaderDoesNotCompile)
{
	const FProgramFolder Folder("lint_broken");
	Folder.Write("Part.usf", "RWTexture2D<float4> Out;\ngroupshared uint S[64];\n[numthreads(8, 8, 1)]\n"
							 "void MainCS(uint2 P : SV_DispatchThreadID, uint N : SV_GroupIndex)\n{\n"
							 "	if (any(P >= uint2(7, 7)))\n	{\n		return;\n	}\n"
							 "	S[N] = N;\n	GroupMemoryBarrierWithGroupSync();\n	Out[P] = S[N ^ 1];\n}\n");
	Folder.Write("Broken.usf", "[numthreads(8, 8, 1)]\nvoid MainCS()\n{\n	Missing = 1;\n}\n");
	const FOutcome Found = Folder.Call("lint Part.usf Broken.usf");
	EXPECT_EQ(2, Found.ExitCode) << Found.Printed;
	EXPECT_THAT(Found.Printed, HasSubstr("Part.usf:11: error: threads part in line 6: a barrier that not all threads"));
	EXPECT_THAT(Found.Printed, HasSubstr("Broken.usf:4:2: error: X3004: undeclared identifier 'Missing'"));
	EXPECT_THAT(Folder.Call("lint Broken.usf").Printed, testing::Not(HasSubstr("looked at")));
}

TEST(LintProgram, NamesOfDrydocksOwnAreNotInTheEngine)
{
	const FProgramFolder Folder("lint_names");
	const std::string Engine = "#include \"/Engine/Private/TonemapCommon.ush\"\n#include \"ShaderPrint.ush\"\n";
	const std::string Body =
		"RWTexture2D<float4> Out;\n[numthreads(8, 8, 1)]\n"
		"void MainCS(uint2 P : SV_DispatchThreadID)\n{\n"
		"	FShaderPrintContext Context = InitShaderPrintContext();\n	Print(Context, TEXT(\"a\"));\n"
		"	float2 UV = MapPixelToInputUV(P, 0.0f, 1.0f, 0.0f, 1.0f);\n"
		"	Out[P] = float4(LinToLog(UV.xyx), AcesYc(UV.xyx));\n}\n";
	Folder.Write("Part.usf", Engine + "#include \"/Drydock/Private/ScreenMapping.ush\"\n" + Body);
	const FOutcome Found = Folder.Call("lint Part.usf");
	EXPECT_EQ(1, Found.ExitCode);
	EXPECT_THAT(
		Found.Printed, HasSubstr("Part.usf:3: error: /Drydock/Private/ScreenMapping.ush: the engine does not have"));
	EXPECT_THAT(
		Found.Printed, HasSubstr("Part.usf:10: error: MapPixelToInputUV of /Drydock/Private/ScreenMapping.ush (the "
								 "engine has ApplyScreenTransform of a parameter FScreenTransform): "));
	EXPECT_THAT(
		Found.Printed, HasSubstr("Part.usf:11: error: AcesYc of /Drydock/Private/ACES.ush (the engine has rgb_2_yc)"));
	EXPECT_THAT(Found.Printed, HasSubstr("1 shader looked at, 3 findings\n"));

	std::string Own = Body;
	Own.replace(Own.find("AcesYc(UV.xyx)"), 14, "AcesYc(UV.xyx, 1.75f)");
	Folder.Write(
		"Part.usf", Engine +
						"float2 MapPixelToInputUV(float2 P, float2 A, float2 B, float2 C, float2 D) { return P; }\n"
						"float AcesYc(float3 Color, float Weight) { return Weight * Color.x; }\n" +
						Own);
	EXPECT_THAT(Folder.Call("lint Part.usf").Printed, HasSubstr("1 shader looked at, 0 findings\n"));

	Folder.Write(
		"Part.usf", "#include \"/Engine/Private/UnityBloom.usf\"\n" + Body.substr(0, Body.find("	FShader")) + "}\n");
	EXPECT_THAT(Folder.Call("lint Part.usf --entry MainCS").Printed,
		HasSubstr("Part.usf:1: error: /Engine/Private/UnityBloom.usf (an article adds it): "));
}

TEST(LintProgram, AFileOfAPluginIncludesByThePluginsNames)
{
	const FProgramFolder Folder("lint_plugin");
	Folder.Write("My/Plug.uplugin", "{}");
	Folder.Write("My/Source/Plug/Plug.cpp", "void F() { AddShaderSourceDirectoryMapping(TEXT(\"/PlugShaders\"), "
											"FPaths::Combine(Dir, TEXT(\"Shaders\"))); }");
	Folder.Write("My/Shaders/Private/One.ush", "#define ONE 1\n");
	Folder.Write("My/Shaders/Two.ush", "#define TWO 2\n");
	Folder.Write("My/Shaders/Part.usf",
		"#include \"/Plugin/Plug/Private/One.ush\"\n#include \"/PlugShaders/Two.ush\"\nRWTexture2D<float4> Out;\n"
		"[numthreads(8, 8, 1)]\nvoid MainCS(uint2 P : SV_DispatchThreadID) { Out[P].x = ONE + TWO; }\n");
	const FOutcome Found = Folder.Call("lint My/Shaders/Part.usf --platform d3d11");
	EXPECT_THAT(Found.Printed, HasSubstr("Part.usf:5: error: a store to a typed UAV")) << Found.Printed;
}

TEST(LintProgram, EntriesThatFillAStructAreFoundAndBracketsThatLackAreNamed)
{
	const FProgramFolder Folder("lint_entries");
	const std::string Struct = "struct FOut { float4 A : SV_Target0; float4 B : SV_Target1; };\n";
	Folder.Write(
		"Returns.usf", Struct + "FOut Main(float2 UV : TEXCOORD0) { FOut O; O.A = UV.xyxy; O.B = 1; return O; }\n");
	Folder.Write("Fills.usf", Struct + "void Main(float2 UV : TEXCOORD0, out FOut O) { O.A = UV.xyxy; O.B = 1; }\n");
	Folder.Write("Bracket.usf", "float F(float x { return x; }\nfloat4 Main() : SV_Target { return F(1); }\n");
	for (const char* const File : {"Returns.usf", "Fills.usf"})
	{
		EXPECT_THAT(Folder.Call(std::string("lint ") + File).Printed, HasSubstr("1 shader looked at, 0 findings\n"));
	}
	EXPECT_THAT(Folder.Call("lint Bracket.usf").Printed, HasSubstr("Bracket.usf:1:17: error: X3000: syntax error"));
}

TEST(LintProgram, VariablesChooseTheRules)
{
	const FProgramFolder Folder("lint_set");
	Folder.Write("Vector.usf", "float4 Main(float4 P : SV_Position) : SV_Target { return P > 4 ? P : 1; }\n");
	EXPECT_THAT(Folder.Call("lint Vector.usf").Printed, HasSubstr("X3019"));
	EXPECT_THAT(
		Folder.Call("lint Vector.usf --set r.D3D.ForceDXC=0").Printed, HasSubstr("1 shader looked at, 0 findings\n"));
}

TEST(LintProgram, FindingsHaveTheirLineAndAllowedOnesAreLeftOut)
{
	const FProgramFolder Folder("lint_findings");
	const std::string Head =
		"RWTexture2D<float4> Out;\n[numthreads(8, 8, 1)]\nvoid MainCS(uint2 P : SV_DispatchThreadID)\n{\n";
	Folder.Write("Part.usf", Head + "\tOut[P].x = 1;\n}\n");
	const FOutcome Found = Folder.Call("lint Part.usf --platform d3d11");
	EXPECT_EQ(1, Found.ExitCode);
	EXPECT_THAT(Found.Printed, HasSubstr("Part.usf:5: error: a store to a typed UAV writes all components of a texel"));
	EXPECT_THAT(Found.Printed, HasSubstr("1 shader looked at, 1 finding\n"));
	Folder.Write("Part.usf", Head + "\tOut[P].x = 1; // drydock-lint: allow partial-uav-store: D3D12 only\n}\n");
	const FOutcome Allowed = Folder.Call("lint Part.usf --platform d3d11");
	EXPECT_EQ(0, Allowed.ExitCode);
	EXPECT_THAT(Allowed.Printed, HasSubstr("1 shader looked at, 0 findings\n"));
}
