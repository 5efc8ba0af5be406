// Which names `drydock new` takes.
#include <gtest/gtest.h>

#include "Patch/PatchName.h"

using namespace Drydock;

namespace
{

const std::set<std::string>& GetTaken()
{
	static const std::set<std::string> Taken = FindTakenNames();
	return Taken;
}

bool IsGood(const std::string& Name)
{
	return ExplainBadPatchName(Name, GetTaken()).empty();
}

} // namespace

TEST(PatchName, IdentifiersAreGood)
{
	for (const char* Name : {"MyPatch", "x", "My_Patch2", "RainOnLens", "mypatch"})
	{
		EXPECT_TRUE(IsGood(Name)) << Name << ": " << ExplainBadPatchName(Name, GetTaken());
	}
}

TEST(PatchName, WhatIsNoIdentifierIsRefused)
{
	for (const char* Name : {"", "1Patch", "My-Patch", "My Patch", "../Patch", "My/Patch", "Gr\xc3\xbcn", "_Patch"})
	{
		EXPECT_FALSE(IsGood(Name)) << Name;
	}
}

TEST(PatchName, NamesThatCppKeepsForItselfAreRefused)
{
	for (const char* Name : {"class", "co_await", "xor", "My__Patch"})
	{
		EXPECT_FALSE(IsGood(Name)) << Name;
	}
}

TEST(PatchName, EngineTypesAreRefusedWithAndWithoutTheirPrefix)
{
	for (const char* Name : {"FSceneView", "SceneView", "FRDGBuilder", "ISceneViewExtension", "FVector", "TArray"})
	{
		EXPECT_FALSE(IsGood(Name)) << Name;
	}
}

TEST(PatchName, MacrosAreRefused)
{
	for (const char* Name : {"check", "TEXT", "RDG_EVENT_NAME"})
	{
		EXPECT_FALSE(IsGood(Name)) << Name;
	}
}

// Two shader classes of one name end the engine when it starts: FTonemapPS is the tonemapper's.
TEST(PatchName, ShaderClassesAreRefused)
{
	EXPECT_EQ("FTonemapPS is a name of the engine's", ExplainBadPatchName("Tonemap", GetTaken()));
}

// SceneViewExtension.h would include itself.
TEST(PatchName, HeadersAreRefused)
{
	EXPECT_FALSE(ExplainBadPatchName("Scene", {"SceneViewExtension"}).empty());
}

TEST(PatchName, ModulesAndBuildTargetsAreRefused)
{
	for (const char* Name : {"Engine", "Renderer", "test", "install", "drydock"})
	{
		EXPECT_FALSE(IsGood(Name)) << Name;
	}
}

TEST(PatchName, LongNamesAreRefused)
{
	EXPECT_TRUE(IsGood(std::string(64, 'P')));
	EXPECT_FALSE(IsGood(std::string(65, 'P')));
}

TEST(PatchName, TheNearestGoodNameIsSuggested)
{
	EXPECT_EQ("MyPatch", SuggestPatchName("My-Patch", GetTaken()));
	EXPECT_EQ("Patch", SuggestPatchName("1patch", GetTaken()));
	EXPECT_EQ("MyTonemap", SuggestPatchName("Tonemap", GetTaken()));
	EXPECT_EQ("MySceneView", SuggestPatchName("FSceneView", GetTaken()));
	EXPECT_EQ("", SuggestPatchName("123", GetTaken()));
}

TEST(PatchName, DeclarationsAreFound)
{
	const std::set<std::string> Expected = {"FA", "EB", "FC", "FD", "FE", "PI_F"};
	EXPECT_EQ(Expected, FindDeclaredNames("class DRYDOCK_API FA : public FBase\n"
										  "enum class EB : uint8\n"
										  "struct FC;\n"
										  "using FD = int;\n"
										  "using namespace Drydock;\n"
										  "using Other::FX;\n"
										  "BEGIN_SHADER_PARAMETER_STRUCT(FE, DRYDOCK_API)\n"
										  "#define PI_F(X) X\n"
										  "	class FNested;\n"
										  "// class FComment\n"));
}
