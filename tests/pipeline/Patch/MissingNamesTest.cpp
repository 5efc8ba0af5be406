// The sentences about unknown names, written by hand as g++, clang and ld write them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Patch/MissingNames.h"

using namespace Drydock;

namespace
{

FMissingName FindOne(const std::string& Sentence, const std::vector<std::string>& Notes = {})
{
	std::vector<FCompilerMessage> Others;
	const std::vector<FMissingName> Names = FindMissingNames({{"a.cpp", 7, Sentence}}, Notes, Others);
	EXPECT_EQ(1u, Names.size()) << Sentence;
	EXPECT_TRUE(Others.empty()) << Sentence;
	return Names.empty() ? FMissingName() : Names.front();
}

} // namespace

TEST(MissingNames, EachCompilersSentencesAreRead)
{
	const struct
	{
		const char* Sentence;
		const char* Name;
		const char* Kind;
		const char* Instead;
	} Cases[] = {
		{"'FNothing' was not declared in this scope", "FNothing", "name", ""},
		{"\u2018FVektor\u2019 was not declared in this scope; did you mean \u2018FVector\u2019?", "FVektor", "name",
			"did you mean FVector?"},
		{"'FVektor' does not name a type; did you mean 'FVector'?", "FVektor", "type", "did you mean FVector?"},
		{"'class FSceneView' has no member named 'FieldOfView'", "FSceneView::FieldOfView", "member", ""},
		{"'const struct FPlan' has no member named 'Z'", "FPlan::Z", "member", ""},
		{"'Sinus' is not a member of 'FMath'; did you mean 'Sin'?", "FMath::Sinus", "member", "did you mean Sin?"},
		{"'FInner' in 'struct FOuter' does not name a type", "FOuter::FInner", "type", ""},
		{"'FApp' has not been declared", "FApp", "name", ""},
		{"invalid use of incomplete type 'class UGone'", "UGone", "type", ""},
		{"Lib/Absent.h: No such file or directory", "Lib/Absent.h", "header", ""},
		{"'virtual void FTint::Gone(int)' marked 'override', but does not override", "FTint::Gone", "override", ""},
		{"no base class 'APawn'", "APawn", "base class", ""},
		{"undefined reference to `Missing()'", "Missing()", "definition", ""},
		{"use of undeclared identifier 'FVektor'; did you mean 'FVector'?", "FVektor", "name", "did you mean FVector?"},
		{"unknown type name 'FGone'", "FGone", "type", ""},
		{"no member named 'FieldOfView' in 'FSceneView'", "FSceneView::FieldOfView", "member", ""},
		{"no type named 'FInner' in 'FOuter'", "FOuter::FInner", "member", ""},
		{"'Lib/Absent.h' file not found", "Lib/Absent.h", "header", ""},
		{"member access into incomplete type 'UGone'", "UGone", "type", ""},
	};
	for (const auto& Case : Cases)
	{
		const FMissingName Found = FindOne(Case.Sentence);
		EXPECT_EQ(Case.Name, Found.Name) << Case.Sentence;
		EXPECT_EQ(Case.Kind, Found.Kind) << Case.Sentence;
		EXPECT_EQ(Case.Instead, Found.Instead) << Case.Sentence;
	}
}

TEST(MissingNames, ANameIsToldOnceWithItsCount)
{
	std::vector<FCompilerMessage> Others;
	const std::vector<FMissingName> Names = FindMissingNames(
		{{"a.cpp", 7, "'FGone' was not declared in this scope"}, {"a.cpp", 8, "expected ';' before 'x'"},
			{"b.cpp", 3, "'FGone' does not name a type"}, {"b.cpp", 9, "unknown type name 'FOther'"}},
		{}, Others);
	ASSERT_EQ(2u, Names.size());
	EXPECT_EQ("FGone", Names[0].Name);
	EXPECT_EQ(2, Names[0].Count);
	EXPECT_EQ("a.cpp:7", Names[0].Place);
	EXPECT_EQ("FOther", Names[1].Name);
	EXPECT_EQ((std::vector<FCompilerMessage>{{"a.cpp", 8, "expected ';' before 'x'"}}), Others);
	EXPECT_EQ("  missing  kind  uses  first place\n"
			  "  FGone    name     2  a.cpp:7\n"
			  "  FOther   type     1  b.cpp:9\n",
		FormatMissingNames(Names, "  "));
}

TEST(MissingNames, BaseClassesAreFirst)
{
	std::vector<FCompilerMessage> Others;
	const std::vector<FMissingName> Names = FindMissingNames(
		{{"a.cpp", 7, "'FGone' was not declared in this scope"}, {"b.h", 8, "no base class 'APawn'"}}, {}, Others);
	ASSERT_EQ(2u, Names.size());
	EXPECT_EQ("APawn", Names[0].Name);
	EXPECT_EQ("FGone", Names[1].Name);
}

TEST(MissingNames, ALongNameDoesNotWidenTheTable)
{
	const std::string Table =
		FormatMissingNames({{std::string(40, 'A') + std::string(40, 'B'), "name", 1, "a.cpp:1", ""}}, "");
	EXPECT_EQ("missing" + std::string(41, ' ') + "  kind  uses  first place\n" + std::string(23, 'A') + "..." +
				  std::string(22, 'B') + "  name     1  a.cpp:1\n",
		Table);
}

TEST(MissingNames, TheHeaderThatIsTakenAsEmptyIsNamed)
{
	const std::vector<std::string> Notes = {
		"there is no CompGeom/Delaunay2.h here, it is taken as empty (for /p/a.cpp)",
		"there is no MeshThing.inl here, it is taken as empty (for /p/a.cpp)"};
	EXPECT_EQ(
		"neither drydock nor the plugin has MeshThing.inl", FindOne("'FMeshThing' was not declared", Notes).Instead);
	EXPECT_EQ("neither drydock nor the plugin has CompGeom/Delaunay2.h",
		FindOne("'FDelaunay2' was not declared", Notes).Instead);
	EXPECT_EQ("neither drydock nor the plugin has CompGeom/Delaunay2.h",
		FindOne("'UE::Geometry::FDelaunay2' has not been declared", Notes).Instead);
	EXPECT_EQ("", FindOne("'FDelaunay' was not declared", Notes).Instead);
}
