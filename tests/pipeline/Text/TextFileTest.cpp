// Tests of files read and written whole: nobody sees half of one, and nothing stays beside it.
#include <gtest/gtest.h>

#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

class TextFile : public testing::Test
{
protected:
	TextFile()
		: Folder(Files::temp_directory_path() / ("drydock_text_" + std::to_string(getpid())))
	{
		Files::create_directories(Folder);
	}
	~TextFile() override { Files::remove_all(Folder); }

	size_t CountFiles() const
	{
		return static_cast<size_t>(std::distance(Files::directory_iterator(Folder), Files::directory_iterator()));
	}

	const Files::path Folder;
};

} // namespace

TEST_F(TextFile, WhatIsWrittenIsRead)
{
	const std::string Path = (Folder / "new" / "a.txt").string();
	WriteTextFile(Path, "one\n");
	WriteTextFile(Path, "two\n");
	EXPECT_EQ("two\n", ReadTextFile(Path));
}

TEST_F(TextFile, MissingFileAndFolderCannotBeRead)
{
	EXPECT_EQ(std::nullopt, TryReadTextFile((Folder / "none").string()));
	EXPECT_EQ(std::nullopt, TryReadTextFile(Folder.string()));
	EXPECT_THROW(ReadTextFile(Folder.string()), FError);
}

TEST_F(TextFile, NothingStaysBesideWhatWasWritten)
{
	WriteTextFile((Folder / "a.txt").string(), "one");
	EXPECT_EQ(1u, CountFiles());
}

TEST_F(TextFile, WhatIsNotPutInPlaceGoesAway)
{
	{
		const FAsideFile Aside(Folder / "a.txt");
		WriteWholeFile(Aside.GetPath().string(), "half");
		EXPECT_TRUE(FAsideFile::IsAside(Aside.GetPath()));
		EXPECT_EQ(1u, CountFiles());
	}
	EXPECT_EQ(0u, CountFiles());
}

TEST_F(TextFile, NameAsideKeepsTheExtension)
{
	EXPECT_EQ(".png", FAsideFile(Folder / "final.png").GetPath().extension().string());
}

TEST_F(TextFile, FolderTakesItsPlaceWhole)
{
	FAsideFile Aside(Folder / "run");
	WriteTextFile((Aside.GetPath() / "passes" / "a.txt").string(), "one");
	Aside.PutInPlace();
	EXPECT_EQ("one", ReadTextFile((Folder / "run" / "passes" / "a.txt").string()));
	EXPECT_EQ(1u, CountFiles());
}

TEST_F(TextFile, PlaceUnderAFileIsAnError)
{
	WriteTextFile((Folder / "a").string(), "one");
	EXPECT_THROW(FAsideFile(Folder / "a" / "b.txt"), FError);
}
