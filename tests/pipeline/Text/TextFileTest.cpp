// Tests of files read and written whole: nobody sees half of one, and nothing stays beside it.
#include <gtest/gtest.h>

#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"
#include "Text/TextFile.h"

#include <filesystem>
#include <sys/stat.h>
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

TEST_F(TextFile, APipeIsRefusedAndNobodyWaits)
{
	const std::string Pipe = (Folder / "pipe").string();
	ASSERT_EQ(0, mkfifo(Pipe.c_str(), 0600));
	alarm(20);
	EXPECT_EQ(std::nullopt, TryReadTextFile(Pipe));
	EXPECT_THROW(ReadTextFile(Pipe), FError);
	EXPECT_THROW(FingerprintFile(Pipe), FError);
	alarm(0);
}

TEST_F(TextFile, WhyATextCannotBeReadIsSaid)
{
	const auto ErrorOf = [](const std::string& Path, size_t MaxBytes)
	{
		try
		{
			ReadTextFile(Path, "the text cannot be read", MaxBytes);
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitFiles, Error.GetExitCode());
			return Error.GetDiagnostics()[0].ToString();
		}
		return std::string();
	};
	const std::string Path = (Folder / "a.txt").string();
	EXPECT_EQ(Path + ": error DD5001: the text cannot be read: No such file or directory", ErrorOf(Path, 10));
	WriteTextFile(Path, "01234567890");
	EXPECT_EQ(
		Path + ": error DD5007: the text cannot be read: it has 11 bytes, and at most 10 are read", ErrorOf(Path, 10));
	EXPECT_EQ("", ErrorOf(Path, 11));
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
		EXPECT_EQ(0u, Aside.GetPath().parent_path().filename().string().find("a.txt.writing."));
		EXPECT_EQ(1u, CountFiles());
	}
	EXPECT_EQ(0u, CountFiles());
}

TEST_F(TextFile, NameAsideIsTheOwn)
{
	EXPECT_EQ("final.png", FAsideFile(Folder / "final.png").GetPath().filename().string());
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

TEST_F(TextFile, DiskThatIsFullIsSaidOfTheFile)
{
	Files::create_symlink("/dev/full", Folder / "full.txt");
	try
	{
		WriteWholeFile((Folder / "full.txt").string(), "one");
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
		EXPECT_EQ((Folder / "full.txt").string() + ": error DD5004: cannot be written: No space left on device",
			Error.GetDiagnostics().at(0).ToString());
	}
}
