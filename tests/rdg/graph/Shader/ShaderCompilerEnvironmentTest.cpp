// The defines that a shader class sets.
#include <gtest/gtest.h>

#include "ShaderCore.h"

namespace
{

using FDefines = std::vector<std::pair<std::string, std::string>>;

} // namespace

TEST(ShaderCompilerEnvironment, IntegersAreWrittenAsTheyAre)
{
	FShaderCompilerEnvironment Environment;
	Environment.SetDefine(TEXT("A"), -3);
	Environment.SetDefine(TEXT("B"), 4000000000u);
	EXPECT_EQ((FDefines{{"A", "-3"}, {"B", "4000000000"}}), Environment.GetDefines());
}

TEST(ShaderCompilerEnvironment, FlagsAreOneAndZero)
{
	FShaderCompilerEnvironment Environment;
	Environment.SetDefine(TEXT("ON"), true);
	Environment.SetDefine(TEXT("OFF"), false);
	EXPECT_EQ((FDefines{{"ON", "1"}, {"OFF", "0"}}), Environment.GetDefines());
}

TEST(ShaderCompilerEnvironment, FloatsReadBackAsTheSameFloat)
{
	FShaderCompilerEnvironment Environment;
	Environment.SetDefine(TEXT("TENTH"), 0.1f);
	EXPECT_EQ((FDefines{{"TENTH", "0.1"}}), Environment.GetDefines());
}

TEST(ShaderCompilerEnvironment, WholeFloatsKeepTheirPoint)
{
	FShaderCompilerEnvironment Environment;
	Environment.SetDefine(TEXT("TWO"), 2.0f);
	Environment.SetDefine(TEXT("MINUS"), -16.0);
	EXPECT_EQ((FDefines{{"TWO", "2.0"}, {"MINUS", "-16.0"}}), Environment.GetDefines());
}

TEST(ShaderCompilerEnvironment, TextIsTakenLiterally)
{
	FShaderCompilerEnvironment Environment;
	Environment.SetDefine(TEXT("TYPE"), TEXT("float4"));
	Environment.SetDefine(TEXT("NAME"), FString(TEXT("Main")));
	EXPECT_EQ((FDefines{{"TYPE", "float4"}, {"NAME", "Main"}}), Environment.GetDefines());
}

TEST(ShaderCompilerEnvironment, TheLastValueWinsAtTheFirstPlace)
{
	FShaderCompilerEnvironment Environment;
	Environment.SetDefine(TEXT("A"), 1);
	Environment.SetDefine(TEXT("B"), 2);
	Environment.SetDefine(TEXT("A"), 3);
	EXPECT_EQ((FDefines{{"A", "3"}, {"B", "2"}}), Environment.GetDefines());
}

TEST(ShaderCompilerEnvironment, TheMacroNamesTheDefine)
{
	FShaderCompilerEnvironment Environment;
	SET_SHADER_DEFINE(Environment, USE_MASK, true);
	SET_SHADER_DEFINE(Environment, GROUP_SIZE, 8);
	EXPECT_EQ((FDefines{{"USE_MASK", "1"}, {"GROUP_SIZE", "8"}}), Environment.GetDefines());
}

TEST(ShaderDirectories, AreListedAndForgotten)
{
	AddShaderSourceDirectoryMapping(TEXT("/Listed"), TEXT("/tmp/first"));
	AddShaderSourceDirectoryMapping(TEXT("/Listed"), TEXT("/tmp/second"));
	ASSERT_TRUE(AllShaderSourceDirectoryMappings().Contains(TEXT("/Listed")));
	EXPECT_STREQ("/tmp/second", **AllShaderSourceDirectoryMappings().Find(TEXT("/Listed")));
	ResetAllShaderSourceDirectoryMappings();
	EXPECT_FALSE(AllShaderSourceDirectoryMappings().Contains(TEXT("/Listed")));
	EXPECT_TRUE(AllShaderSourceDirectoryMappings().Contains(TEXT("/Engine")));
}
