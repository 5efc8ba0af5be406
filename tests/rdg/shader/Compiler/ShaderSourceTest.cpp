// Flattening gives one text, files with #pragma once once, lines that lead back, whatever the encoding.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"
#include "ShaderSource.h"

#include <filesystem>
#include <fstream>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;
using testing::Not;

FShaderCompileRequest MakeRequest(std::vector<std::pair<std::string, std::string>> Files)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = Files[0].first;
	Request.EntryPoint = "MainCS";
	Request.GeneratedFiles = std::move(Files);
	return Request;
}

std::string Flatten(std::vector<std::pair<std::string, std::string>> Files)
{
	return FlattenShader(MakeRequest(std::move(Files))).Text;
}

size_t Count(const std::string& Text, const std::string& Part)
{
	size_t Result = 0;
	for (size_t At = Text.find(Part); At != std::string::npos; At = Text.find(Part, At + 1))
	{
		++Result;
	}
	return Result;
}

} // namespace

TEST(FlattenShader, IncludesAFileWithPragmaOnceOnceHoweverOftenItIsNamed)
{
	const std::string Text = Flatten({{"/T/A.usf", "#include \"/T/B.ush\"\n#include \"B.ush\"\n#include \"C.ush\"\n"},
		{"/T/B.ush", "#pragma once\nint b;\n"}, {"/T/C.ush", "#include \"../T/B.ush\"\nint c;\n"}});
	EXPECT_EQ(1u, Count(Text, "int b;"));
	EXPECT_EQ(1u, Count(Text, "int c;"));
	const std::string Again =
		Flatten({{"/T/A.usf", "#include \"B.ush\"\n#include \"/T/B.ush\"\n"}, {"/T/B.ush", "int b;\n"}});
	EXPECT_EQ(2u, Count(Again, "int b;"));
}

TEST(FlattenShader, FilesThatIncludeEachOtherEnd)
{
	const auto FlattenBoth = [](const std::string& First)
	{
		return Flatten({{"/T/A.usf", First + "#include \"B.ush\"\nint a;\n"},
			{"/T/B.ush", First + "#include \"A.usf\"\nint b;\n"}});
	};
	const std::string Text = FlattenBoth("#pragma once\n");
	EXPECT_EQ(1u, Count(Text, "int a;"));
	EXPECT_EQ(1u, Count(Text, "int b;"));
	EXPECT_THAT(ErrorOf([&] { FlattenBoth(""); }), HasSubstr("includes are nested too deeply"));
}

TEST(FlattenShader, NamesFileAndLineAtEverySeam)
{
	const std::string Text = Flatten({{"/T/A.usf", "int x;\n#include \"B.ush\"\nint y;\n"}, {"/T/B.ush", "int b;\n"}});
	EXPECT_THAT(Text, HasSubstr("#line 1 \"/T/A.usf\"\nint x;\n"));
	EXPECT_THAT(Text, HasSubstr("#line 1 \"/T/B.ush\"\nint b;\n"));
	EXPECT_THAT(Text, HasSubstr("#line 3 \"/T/A.usf\"\nint y;\n"));
}

TEST(FlattenShader, DoesNotIncludeFromComments)
{
	EXPECT_THAT(Flatten({{"/T/A.usf", "// #include \"Missing.ush\"\n/*\n#include \"Missing.ush\"\n*/ int a;\n"}}),
		HasSubstr("int a;"));
}

TEST(FlattenShader, MissingIncludeNamesTheIncluderAndItsLine)
{
	const std::string Error = ErrorOf([] { Flatten({{"/T/A.usf", "\n\n#include \"/T/Nowhere.ush\"\n"}}); });
	EXPECT_THAT(Error, HasSubstr("/T/A.usf:3: error: cannot open include file '/T/Nowhere.ush'"));
}

TEST(FlattenShader, ReportsEveryMissingInclude)
{
	const std::string Error = ErrorOf([] { Flatten({{"/T/A.usf", "#include \"X.ush\"\n#include \"Y.ush\"\n"}}); });
	EXPECT_THAT(Error, HasSubstr("/T/A.usf:1: error: cannot open include file 'X.ush'"));
	EXPECT_THAT(Error, HasSubstr("/T/A.usf:2: error: cannot open include file 'Y.ush'"));
}

TEST(FlattenShader, MissingShaderIsAnErrorThatNamesIt)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Nowhere/X.usf";
	EXPECT_THAT(ErrorOf([&] { FlattenShader(Request); }), HasSubstr("cannot open shader '/Nowhere/X.usf'"));
}

TEST(FlattenShader, AMissingFileNamesTheNearestAndTheMappedFolders)
{
	const std::filesystem::path Folder = std::filesystem::temp_directory_path() / "drydock-nearest-test";
	std::filesystem::create_directories(Folder / "Private");
	std::ofstream(Folder / "Private" / "OutlineCommon.ush") << "int c;\n";
	AddShaderDirectory("/NearestTest", Folder.string());
	AddShaderDirectory("/NearestGone", (Folder / "None").string());
	const auto ErrorOfInclude = [](const std::string& Target)
	{
		return ErrorOf([&] { Flatten({{"/T/A.usf", "#include \"" + Target + "\"\n"}}); });
	};
	const std::string Misspelt = ErrorOfInclude("/NearestTest/Private/OutlineComon.ush");
	EXPECT_THAT(Misspelt, HasSubstr("did you mean /NearestTest/Private/OutlineCommon.ush?"));
	EXPECT_THAT(Misspelt, HasSubstr("/NearestTest to " + Folder.string()));
	EXPECT_THAT(Misspelt, HasSubstr((Folder / "None").string() + " (no such folder)"));
	EXPECT_THAT(ErrorOfInclude("/NearestTest/OutlineCommon.ush"),
		HasSubstr("did you mean /NearestTest/Private/OutlineCommon.ush?"));
	EXPECT_THAT(ErrorOfInclude("/NearestTest/Private/Fog.ush"), Not(HasSubstr("did you mean")));
	std::filesystem::remove_all(Folder);
}

TEST(FlattenShader, LaterDefineOfTheSameNameWins)
{
	FShaderCompileRequest Request = MakeRequest({{"/T/A.usf", "int a = SIZE;\n"}});
	Request.Defines = {{"SIZE", "1"}, {"SIZE", "2"}};
	EXPECT_THAT(FlattenShader(Request).Text, HasSubstr("int a = 2;\n"));
}

TEST(FlattenShader, ListsTheFilesOnDisk)
{
	const std::filesystem::path Folder = std::filesystem::temp_directory_path() / "drydock-flatten-test";
	std::filesystem::create_directories(Folder / "Sub");
	std::ofstream(Folder / "Sub" / "Common.ush") << "int c;\n";
	AddShaderDirectory("/FlattenTest", Folder.string());
	// The name's case differs from the file system's, as on Windows.
	const FShaderSource Source =
		FlattenShader(MakeRequest({{"/T/A.usf", "#include \"/FlattenTest/sub/COMMON.ush\"\n"}}));
	ASSERT_EQ(1u, Source.Files.size());
	EXPECT_EQ((Folder / "Sub" / "Common.ush").string(), Source.Files[0]);
	std::filesystem::remove_all(Folder);
}

TEST(FindShaderFile, LaterMappingOfAPrefixWins)
{
	const std::filesystem::path Folder = std::filesystem::temp_directory_path() / "drydock-mapping-test";
	std::filesystem::create_directories(Folder / "Old");
	std::filesystem::create_directories(Folder / "New");
	std::ofstream(Folder / "Old" / "Both.usf") << "old";
	std::ofstream(Folder / "New" / "Both.usf") << "new";
	std::ofstream(Folder / "Old" / "Only.usf") << "old";
	AddShaderDirectory("/MappingTest", (Folder / "Old").string());
	AddShaderDirectory("/MappingTest/", (Folder / "New").string());
	EXPECT_EQ((Folder / "New" / "Both.usf").string(), FindShaderFile("/MappingTest/Both.usf"));
	EXPECT_EQ((Folder / "Old" / "Only.usf").string(), FindShaderFile("/MappingTest/Only.usf"));
	EXPECT_EQ("", FindShaderFile("/MappingTest/None.usf"));
	std::filesystem::remove_all(Folder);
}

TEST(NormalizeShaderText, RemovesByteOrderMarkAndCarriageReturns)
{
	EXPECT_EQ("a\nb\n", NormalizeShaderText("\xEF\xBB\xBF"
											"a\r\nb\r\n"));
}

TEST(NormalizeShaderText, ABackslashInsideADoubleByteCharacterJoinsNoLines)
{
	// 0x95 0x5C is one character in Shift-JIS and GBK.
	EXPECT_EQ("// ??\nint a;\n", NormalizeShaderText("// \x95\x5C\nint a;\n"));
}

TEST(NormalizeShaderText, KeepsTheBackslashAfterUtf8)
{
	EXPECT_EQ("#define A ?? \\\n1\n", NormalizeShaderText("#define A \xC3\xA9 \\\n1\n"));
}

TEST(ResolveVirtualPath, TakesRelativePathsFromTheIncludersFolder)
{
	EXPECT_EQ("/P/Sub/B.ush", ResolveVirtualPath("B.ush", "/P/Sub/A.usf"));
	EXPECT_EQ("/P/B.ush", ResolveVirtualPath("../B.ush", "/P/Sub/A.usf"));
	EXPECT_EQ("/Q/B.ush", ResolveVirtualPath("/Q/B.ush", "/P/A.usf"));
}
