// Base classes that lack: their names, which g++ does not write, and the errors that follow from them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Patch/MissingBases.h"
#include "TextTools.h"

using namespace Drydock;

namespace
{

const char* const GHeader = R"(UCLASS()
class TINT_API ACameraPawn : public APawn
{
	GENERATED_BODY()
	void BeginPlay() override;
};
class FOther
{
	int Gone() { return Lost; }
};
)";

const char* const GSource = R"(#include "CameraPawn.h"
ACameraPawn::ACameraPawn()
{
	PrimaryActorTick.bCanEverTick = true;
	EMissingMode Mode;
	View.NoSuchMember();
}
void Free() { Lost(); }
static int32 FOther::Count() const
{
	return Lost;
}
)";

std::vector<std::string> ReadLines(const std::string& File)
{
	return SplitText(File == "CameraPawn.h" ? GHeader : File == "CameraPawn.cpp" ? GSource : "");
}

} // namespace

TEST(MissingBases, AreNamedAndWhatFollowsIsSetApart)
{
	const FCompilerMessage Base = {"CameraPawn.h", 2, "no base class 'APawn'"};
	const FCompilerMessage Mode = {"CameraPawn.cpp", 5, "'EMissingMode' was not declared in this scope"};
	const FCompilerMessage Member = {"CameraPawn.cpp", 6, "'class FSceneView' has no member named 'NoSuchMember'"};
	const FCompilerMessage Count = {"CameraPawn.cpp", 11, "'Lost' was not declared in this scope"};
	const FCompilerMessage Inline = {"CameraPawn.h", 9, "'Lost' was not declared in this scope"};
	const std::vector<FCompilerMessage> Following = {
		{"CameraPawn.h", 5, "'virtual void ACameraPawn::BeginPlay()' marked 'override', but does not override"},
		{"CameraPawn.cpp", 4, "'PrimaryActorTick' was not declared in this scope"},
		{"/b/CameraPawn.generated.h", 8, "'APawn' does not name a type"},
	};
	for (const char* const Sentence : {"expected class-name before '{' token", "expected class name",
			 "unknown class name 'APawn'; did you mean 'ACameraPawn'?"})
	{
		std::vector<FCompilerMessage> Errors = Following;
		Errors.insert(Errors.end(), {{"CameraPawn.h", 2, Sentence}, Mode, Member, Count, Inline});
		std::vector<FCompilerMessage> Found;
		NameMissingBases(Errors, ReadLines, Found);
		EXPECT_THAT(Errors, testing::ElementsAre(Base, Mode, Member, Count, Inline)) << Sentence;
		EXPECT_EQ(Following, Found) << Sentence;
	}
}

TEST(MissingBases, NothingIsSetApartWhereNoBaseLacks)
{
	const std::vector<FCompilerMessage> All = {
		{"CameraPawn.cpp", 4, "'PrimaryActorTick' was not declared in this scope"},
		{"CameraPawn.h", 99, "expected class-name before '{' token"}, {"Gone.h", 1, "expected class-name before 'x'"},
		{"/b/CameraPawn.generated.h", 8, "'APawn' does not name a type"}, {"", 0, "undefined reference to 'F()'"}};
	std::vector<FCompilerMessage> Errors = All;
	std::vector<FCompilerMessage> Found;
	NameMissingBases(Errors, ReadLines, Found);
	EXPECT_EQ(All, Errors);
	EXPECT_TRUE(Found.empty());
}
