// Folders of code: who may have made them and what is in them, and that a write is whole or none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "TrustedFolder.h"

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

const uid_t Me = geteuid();

class FTrustedFolderTest : public testing::Test
{
protected:
	FTrustedFolderTest() { EXPECT_EQ(0, FTrustedFolder::Make(Path)); }

	FTrustedFolder Open(uid_t Owner = Me) const { return FTrustedFolder(Path, {Owner}); }

	const FScratchFolder Scratch;
	const std::string Path = (Scratch.Path / "above" / "cache").string();
};

} // namespace

TEST_F(FTrustedFolderTest, IsMadeForTheUserAlone)
{
	EXPECT_EQ(0700, GetMode(Path));
	EXPECT_EQ(ETrust::Trusted, Open().GetTrust());
	EXPECT_EQ(0, Open().FindWriteError());
}

TEST_F(FTrustedFolderTest, ThatIsThereStaysAsItIs)
{
	chmod(Path.c_str(), 0755);
	EXPECT_EQ(0, FTrustedFolder::Make(Path));
	EXPECT_EQ(0755, GetMode(Path));
	EXPECT_EQ(ETrust::Trusted, Open().GetTrust());
}

TEST_F(FTrustedFolderTest, OfAnotherUserIsForeign)
{
	const FTrustedFolder Folder = Open(Me + 1);
	EXPECT_EQ(ETrust::Foreign, Folder.GetTrust());
	EXPECT_EQ("belongs to another user (uid " + std::to_string(Me) + ")", Folder.GetFault());
}

TEST_F(FTrustedFolderTest, WritableByOthersIsForeign)
{
	for (const auto& [Mode, Text] : {std::pair(0770, "0770"), std::pair(0702, "0702"), std::pair(01777, "1777")})
	{
		chmod(Path.c_str(), mode_t(Mode));
		EXPECT_EQ(ETrust::Foreign, Open().GetTrust());
		EXPECT_EQ(std::string("can be written by others (mode ") + Text + ")", Open().GetFault());
	}
}

TEST_F(FTrustedFolderTest, BehindALinkIsForeign)
{
	const fs::path Link = Scratch.Path / "link";
	fs::create_symlink(Path, Link);
	for (const std::string& Name : {Link.string(), Link.string() + "/", Link.string() + "///"})
	{
		const FTrustedFolder Folder(Name, {Me});
		EXPECT_EQ(ETrust::Foreign, Folder.GetTrust()) << Name;
		EXPECT_EQ("is a symbolic link", Folder.GetFault());
	}
}

TEST_F(FTrustedFolderTest, ThatIsAFileIsForeignAndThatIsMissingIsAbsent)
{
	EXPECT_EQ(ETrust::Foreign, FTrustedFolder(Scratch.Add("file", ""), {Me}).GetTrust());
	const FTrustedFolder Missing((Scratch.Path / "missing").string(), {Me});
	EXPECT_EQ(ETrust::Absent, Missing.GetTrust());
	EXPECT_NE(0, Missing.FindWriteError());
	EXPECT_EQ(ETrust::Absent, Missing.Open("ab/entry").Trust);
}

TEST_F(FTrustedFolderTest, GivesBackWhatWasWritten)
{
	const FTrustedFolder Folder = Open();
	EXPECT_EQ(0, Folder.Write({{"ab/entry", std::string("\0two", 4)}, {"text", "one"}}));
	int Error = 1;
	EXPECT_EQ(std::string("\0two", 4), ReadToEnd(Folder.Open("ab/entry").File, Error));
	EXPECT_EQ(0, Error);
	EXPECT_EQ("one", ReadToEnd(Folder.Open("text").File, Error));
	EXPECT_EQ(2u, ListFiles(Path).size()); // nothing aside
	EXPECT_EQ("one", ReadBytes(Folder.GetLoadPath("text")));
}

TEST_F(FTrustedFolderTest, EntriesAreCheckedToo)
{
	const FTrustedFolder Folder = Open();
	ASSERT_EQ(0, Folder.Write({{"ab/entry", "code"}}));
	const fs::path Entry = fs::path(Path) / "ab" / "entry";

	chmod(Entry.c_str(), 0666);
	EXPECT_EQ("can be written by others (mode 0666)", Folder.Open("ab/entry").Fault);
	chmod(Entry.c_str(), 0644);
	EXPECT_EQ(ETrust::Trusted, Folder.Open("ab/entry").Trust);

	fs::create_symlink(Entry, fs::path(Path) / "ab" / "link");
	EXPECT_EQ("is a symbolic link", Folder.Open("ab/link").Fault);
	ASSERT_EQ(0, mkfifo((fs::path(Path) / "ab" / "pipe").c_str(), 0600));
	EXPECT_EQ("is not a file", Folder.Open("ab/pipe").Fault); // and nobody waits for a writer

	chmod((fs::path(Path) / "ab").c_str(), 0777);
	EXPECT_EQ("can be written by others (mode 0777)", Folder.Open("ab/entry").Fault);
	EXPECT_TRUE(Folder.List("ab").empty());
	EXPECT_NE(0, Folder.Write({{"ab/other", "code"}}));
}

TEST_F(FTrustedFolderTest, SubfoldersBehindALinkAreForeign)
{
	const FScratchFolder Elsewhere;
	Elsewhere.Add("entry", "planted");
	fs::create_directory_symlink(Elsewhere.Path, fs::path(Path) / "ab");
	EXPECT_EQ(ETrust::Foreign, Open().Open("ab/entry").Trust);
	EXPECT_NE(0, Open().Write({{"ab/new", "code"}}));
	EXPECT_FALSE(fs::exists(Elsewhere.Path / "new"));
}

TEST_F(FTrustedFolderTest, IsTheSameFolderWhateverItsPathLeadsTo)
{
	const FTrustedFolder Folder = Open();
	ASSERT_EQ(0, Folder.Write({{"ab/entry", "checked"}}));
	fs::rename(Path, Path + "_moved");
	fs::create_directories(fs::path(Path) / "ab");
	std::ofstream(fs::path(Path) / "ab" / "entry") << "planted";
	int Error = 0;
	EXPECT_EQ("checked", ReadToEnd(Folder.Open("ab/entry").File, Error));
	EXPECT_EQ("checked", ReadBytes(Folder.GetLoadPath("ab/entry")));
}

TEST_F(FTrustedFolderTest, WritesAllOrNothing)
{
	const pid_t Child = fork();
	ASSERT_GE(Child, 0);
	if (Child == 0)
	{
		std::signal(SIGXFSZ, SIG_IGN);
		const rlimit Limit{1000, 1000};
		setrlimit(RLIMIT_FSIZE, &Limit);
		const int Error =
			Open().Write({{"ab/entry.so", std::string(10, ' ')}, {"ab/entry.json", std::string(2000, ' ')}});
		_exit(Error == EFBIG ? 0 : 1);
	}
	int Status = 0;
	ASSERT_EQ(Child, waitpid(Child, &Status, 0));
	EXPECT_EQ(0, Status);
	EXPECT_TRUE(ListFiles(Path).empty());
}
