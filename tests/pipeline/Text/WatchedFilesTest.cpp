// What is told of watched files: which were edited, and that one came or went.
#include <gtest/gtest.h>

#include "Text/WatchedFiles.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;
using FPaths = std::vector<std::string>;

class WatchedFiles : public testing::Test
{
protected:
	WatchedFiles()
		: Folder(Files::temp_directory_path() / ("drydock_watched_" + std::to_string(getpid())))
		, A((Folder / "a.usf").string())
		, B((Folder / "b.usf").string())
	{
		Files::create_directories(Folder);
		std::ofstream(A) << "a";
		std::ofstream(B) << "b";
	}
	~WatchedFiles() override { Files::remove_all(Folder); }

	static FWatchedFiles List(const FPaths& Paths)
	{
		FWatchedFiles Result;
		for (const std::string& Path : Paths)
		{
			Result.AddFile(Path);
		}
		return Result;
	}

	const Files::path Folder;
	const std::string A;
	const std::string B;
};

} // namespace

TEST_F(WatchedFiles, NameThoseThatWereEdited)
{
	const FWatchedFiles Before = List({A, B});
	EXPECT_EQ(FPaths(), List({A, B}).FindEdited(Before));
	std::ofstream(B) << "longer";
	EXPECT_EQ(FPaths{B}, List({A, B}).FindEdited(Before));
}

TEST_F(WatchedFiles, NameNoneWhereOneCameOrWent)
{
	const FWatchedFiles Both = List({A, B});
	EXPECT_EQ(std::nullopt, Both.FindEdited(List({A})));
	EXPECT_EQ(std::nullopt, List({A}).FindEdited(Both));
	EXPECT_EQ(std::nullopt, List({A}).FindEdited(List({B}))); // as many
	Files::remove(B);
	EXPECT_EQ(std::nullopt, List({A, B}).FindEdited(Both));
	EXPECT_EQ(std::nullopt, Both.FindEdited(List({A, B})));
}

TEST_F(WatchedFiles, TakeOverThoseThatTheyDoNotKnow)
{
	FWatchedFiles Known = List({A});
	std::ofstream(A) << "longer";
	Known.AddUnknown(List({A, B}));
	EXPECT_EQ(FPaths{A}, List({A, B}).FindEdited(Known)); // what they knew stays as it was
}
