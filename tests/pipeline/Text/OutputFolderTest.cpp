// Folders of outputs: what drydock wrote is replaced and removed by its own list; whatever else is in the way stays,
// and is named.
#include <gtest/gtest.h>

#include "SequenceTestUtils.h"
#include "Text/OutputErrors.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"

#include <sys/wait.h>

using namespace Drydock;
using SequenceTest::FTemporaryFolder;
using SequenceTest::ReadBytes;

namespace
{

namespace Files = std::filesystem;

const FOutputNames Names = {
	.Name = "test", .Files = {"a.txt", "last.txt"}, .Last = "last.txt", .Folders = {"parts"}, .Unsteady = {"time.txt"}};

/** The number of a process that is no more. */
pid_t MakeDeadProcess()
{
	const pid_t Child = fork();
	if (Child == 0)
	{
		_exit(0);
	}
	waitpid(Child, nullptr, 0);
	return Child;
}

class OutputFolder : public testing::Test
{
protected:
	using FFiles = std::map<std::string, std::string>;

	/** Puts these files in place, by name. */
	void Write(const FFiles& Contents) const
	{
		FOutputFolder Output(Out, Names);
		for (const auto& [Name, Text] : Contents)
		{
			Files::create_directories((Output.GetAside() / Name).parent_path());
			WriteWholeFile((Output.GetAside() / Name).string(), Text);
		}
		Output.PutInPlace();
	}

	/** All files in the folder but lists. */
	FFiles Read() const
	{
		FFiles Contents = SequenceTest::ReadFolder(Out);
		std::erase_if(Contents, [](const auto& File) { return File.first.starts_with(".drydock."); });
		return Contents;
	}

	void Put(const std::string& Name, const std::string& Text) const
	{
		Files::create_directories((Out / Name).parent_path());
		std::ofstream(Out / Name, std::ios::binary) << Text;
	}

	/** "1080 2 parts/Bloom.cpp", or "none". */
	std::string ErrorOf(const FFiles& Contents) const
	{
		try
		{
			Write(Contents);
		}
		catch (const FError& Error)
		{
			const FDiagnostic& First = Error.GetDiagnostics().at(0);
			return std::to_string(First.Code) + " " + std::to_string(Error.GetExitCode()) + " " +
				   Files::path(First.File).lexically_relative(Out).string();
		}
		return "none";
	}

	const FTemporaryFolder Temporary{"drydock_output"};
	const Files::path Out = Temporary.Path / "out";
};

} // namespace

TEST_F(OutputFolder, LaterOutputsReplaceEarlierOnes)
{
	Write({{"a.txt", "1"}, {"b.txt", "1"}, {"parts/c.txt", "1"}, {"last.txt", "1"}});
	Put("mine.txt", "mine");
	Write({{"a.txt", "2"}, {"last.txt", "2"}});
	EXPECT_EQ((FFiles{{"a.txt", "2"}, {"last.txt", "2"}, {"mine.txt", "mine"}}), Read());
	EXPECT_FALSE(Files::exists(Out / "parts"));
}

TEST_F(OutputFolder, ForeignContentInTheWayIsRefusedByNameAndStays)
{
	for (const std::string Name : {"parts/Bloom.cpp", "parts/deep/er.txt", "a.txt", "last.txt"})
	{
		Files::remove_all(Out);
		Put(Name, "mine");
		EXPECT_EQ("1080 2 " + Name.substr(0, Name.find("/er")), ErrorOf({{"b.txt", "1"}, {"last.txt", "1"}}));
		EXPECT_EQ((FFiles{{Name, "mine"}}), Read());
		EXPECT_EQ(1, std::distance(Files::directory_iterator(Out), {})) << "nothing else is written";
	}
}

TEST_F(OutputFolder, ForeignContentAmongOwnIsRefusedToo)
{
	Write({{"a.txt", "1"}, {"parts/c.txt", "1"}, {"last.txt", "1"}});
	Put("parts/mine.txt", "mine");
	EXPECT_EQ("1080 2 parts/mine.txt", ErrorOf({{"last.txt", "2"}}));
	EXPECT_EQ((FFiles{{"a.txt", "1"}, {"parts/c.txt", "1"}, {"parts/mine.txt", "mine"}, {"last.txt", "1"}}), Read());
}

TEST_F(OutputFolder, WhatComesWhileOutputsAreMadeIsNoticed)
{
	FOutputFolder Output(Out, Names);
	WriteWholeFile((Output.GetAside() / "unforeseen.txt").string(), "1");
	Put("unforeseen.txt", "mine");
	EXPECT_THROW(Output.PutInPlace(), FError);
	EXPECT_EQ("mine", ReadBytes(Out / "unforeseen.txt"));
}

TEST_F(OutputFolder, ChangedOutputsAreTheirChangersUnlessTheirBytesAreNoMatter)
{
	Write({{"a.txt", "1"}, {"time.txt", "1"}, {"last.txt", "1"}});
	Put("time.txt", "another time");
	Write({{"a.txt", "1"}, {"time.txt", "2"}, {"last.txt", "1"}});
	Put("a.txt", "retouched");
	EXPECT_EQ("1080 2 a.txt", ErrorOf({{"last.txt", "2"}}));
	EXPECT_EQ("retouched", ReadBytes(Out / "a.txt"));
}

TEST_F(OutputFolder, EmptyAndMissingFilesAreNobodys)
{
	Write({{"a.txt", "1"}, {"last.txt", "1"}});
	Put("a.txt", "");
	Files::remove(Out / "last.txt");
	Write({{"a.txt", "2"}, {"last.txt", "2"}});
	EXPECT_EQ((FFiles{{"a.txt", "2"}, {"last.txt", "2"}}), Read());
}

TEST_F(OutputFolder, LinkInThePlaceOfAFolderIsForeign)
{
	Files::create_directories(Temporary.Path / "elsewhere");
	std::ofstream(Temporary.Path / "elsewhere" / "mine.txt") << "mine";
	Files::create_directories(Out);
	Files::create_directory_symlink(Temporary.Path / "elsewhere", Out / "parts");
	EXPECT_EQ("1080 2 parts", ErrorOf({{"parts/c.txt", "1"}}));
	EXPECT_EQ("mine", ReadBytes(Temporary.Path / "elsewhere" / "mine.txt"));
}

TEST_F(OutputFolder, DamagedListIsNoList)
{
	const Files::path List = Out / ".drydock.test.files";
	Write({{"a.txt", "1"}, {"last.txt", "1"}});
	const std::string Whole = ReadBytes(List);
	for (size_t Bit = 0; Bit < 8 * Whole.size(); Bit += 5)
	{
		std::string Flipped = Whole;
		Flipped[Bit / 8] = static_cast<char>(Flipped[Bit / 8] ^ (1 << Bit % 8));
		std::ofstream(List, std::ios::binary) << Flipped;
		EXPECT_EQ("5023 3 .drydock.test.files", ErrorOf({})) << Bit;
	}
	for (size_t Size = 0; Size < Whole.size(); Size += 7)
	{
		std::ofstream(List, std::ios::binary) << Whole.substr(0, Size);
		EXPECT_EQ("5023 3 .drydock.test.files", ErrorOf({})) << Size;
	}
	EXPECT_EQ((FFiles{{"a.txt", "1"}, {"last.txt", "1"}}), Read());
}

TEST_F(OutputFolder, ListThatLeadsOutOfTheFolderIsNoList)
{
	Write({{"a.txt", "1"}, {"last.txt", "1"}});
	std::ofstream(Temporary.Path / "mine.txt") << "mine";
	for (const std::string& Name : {std::string("../mine.txt"), std::string("parts/../../mine.txt"),
			 (Temporary.Path / "mine.txt").string(), std::string(".."), std::string("./a.txt"), std::string("parts/")})
	{
		FFileList Forged;
		Forged.Add(Name, ""); // its bytes are no matter
		std::ofstream(Out / ".drydock.test.files", std::ios::binary) << Forged.GetText();
		EXPECT_EQ("5023 3 .drydock.test.files", ErrorOf({})) << Name;
		EXPECT_EQ("mine", ReadBytes(Temporary.Path / "mine.txt")) << Name;
	}
}

TEST_F(OutputFolder, ListThatLeadsThroughALinkRemovesNothing)
{
	Write({{"a.txt", "1"}, {"last.txt", "1"}});
	Files::create_directories(Temporary.Path / "elsewhere");
	std::ofstream(Temporary.Path / "elsewhere" / "mine.txt") << "mine";
	Files::create_directory_symlink(Temporary.Path / "elsewhere", Out / "other");
	FFileList Forged = FFileList::Read(Out / ".drydock.test.files");
	Forged.Add("other/mine.txt", "");
	std::ofstream(Out / ".drydock.test.files", std::ios::binary) << Forged.GetText();
	EXPECT_EQ("1080 2 other/mine.txt", ErrorOf({{"last.txt", "2"}}));
	EXPECT_EQ("mine", ReadBytes(Temporary.Path / "elsewhere" / "mine.txt"));
}

TEST_F(OutputFolder, StoppedBetweenTwoFilesGoesOnNextTime)
{
	// As PutInPlace leaves it when it is killed after its first rename.
	Write({{"a.txt", "1"}, {"parts/c.txt", "1"}, {"last.txt", "1"}});
	const FFileList Before = FFileList::Read(Out / ".drydock.test.files");
	Write({{"a.txt", "2"}, {"parts/d.txt", "2"}, {"last.txt", "2"}});
	FFileList Both = FFileList::Read(Out / ".drydock.test.files");
	Both.Add(Before);
	std::ofstream(Out / ".drydock.test.files", std::ios::binary) << Both.GetText();
	Put("parts/c.txt", "1");
	Files::remove(Out / "last.txt");
	Write({{"a.txt", "3"}, {"last.txt", "3"}});
	EXPECT_EQ((FFiles{{"a.txt", "3"}, {"last.txt", "3"}}), Read());
}

TEST_F(OutputFolder, SecondCallIsRefusedAndNamesTheFirst)
{
	const FOutputFolder First(Out, Names);
	try
	{
		const FOutputFolder Second(Out, Names);
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(3, Error.GetExitCode());
		EXPECT_EQ(ErrorFolderInUse, Error.GetDiagnostics().at(0).Code);
		EXPECT_EQ("process " + std::to_string(getpid()) +
					  " is writing to this folder: wait for it, or name another with --out",
			Error.GetDiagnostics().at(0).Message);
	}
}

TEST_F(OutputFolder, LockOfADeadProcessIsNone)
{
	Put(".drydock.lock", std::to_string(MakeDeadProcess()) + "\n");
	Write({{"a.txt", "1"}});
	EXPECT_FALSE(Files::exists(Out / ".drydock.lock"));
}

TEST_F(OutputFolder, NothingIsLeftOfOneThatWroteNothing)
{
	{
		const FOutputFolder Output(Out / "deep", Names);
		EXPECT_TRUE(Files::exists(Out / "deep/.drydock.lock"));
	}
	EXPECT_FALSE(Files::exists(Out));
}

TEST_F(OutputFolder, OnlyWhatADeadProcessWroteAsideIsCleared)
{
	const std::string Dead = std::to_string(MakeDeadProcess());
	const pid_t Killed = fork();
	if (Killed == 0)
	{
		const FAsideFile Aside(Out / "test");
		Files::create_directory(Aside.GetPath());
		std::ofstream(Aside.GetPath() / "half.txt") << "1";
		_exit(0);
	}
	waitpid(Killed, nullptr, 0);
	ASSERT_EQ(1, std::distance(Files::directory_iterator(Out), {}));
	const std::vector<std::string> Others = {
		"test.writing." + Dead + "/half.txt", "test.writing.abcdef/thesis.txt", "story.writing." + Dead + ".txt"};
	for (const std::string& Name : Others)
	{
		Put(Name, "mine");
	}
	Files::permissions(Out / "test.writing.abcdef", Files::perms::owner_all);
	const FAsideFile Living(Out / "test");
	std::ofstream(Living.GetPath()) << "at work";
	Write({{"a.txt", "1"}});
	for (const std::string& Name : Others)
	{
		EXPECT_EQ("mine", ReadBytes(Out / Name));
	}
	EXPECT_EQ("at work", ReadBytes(Living.GetPath()));
	EXPECT_EQ(6, std::distance(Files::directory_iterator(Out), {})); // and a.txt and the list
}

TEST_F(OutputFolder, FileOfTheLocksNameThatIsNoLockStays)
{
	Put(".drydock.lock", "mine");
	EXPECT_THROW(Write({{"a.txt", "1"}}), FError);
	EXPECT_EQ("mine", ReadBytes(Out / ".drydock.lock"));
}
