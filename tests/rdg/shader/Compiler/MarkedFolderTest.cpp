// Folders for what is written aside: that they go, and that nothing else goes with them.
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "MarkedFolder.h"
#include "TemporaryFolder.h"

#include <set>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

class MarkedFolder : public testing::Test
{
protected:
	std::string GetBegin() const { return (Scratch.Path / "drydock-1-").string(); }

	/** Calls the function in a child that ends without cleaning up. */
	template<typename TFunction>
	static void InAChild(const TFunction& Function)
	{
		const pid_t Child = fork();
		if (Child == 0)
		{
			Function();
			_exit(0);
		}
		waitpid(Child, nullptr, 0);
	}

	/** A folder with a file and a folder, of a process that is dead. */
	fs::path Abandon() const
	{
		const std::set<std::string> Before = ListFiles();
		InAChild(
			[this]
			{
				const FMarkedFolder Folder(GetBegin());
				std::ofstream(Folder.Reserve("kernel.cpp")) << "half";
				const fs::path Inside = Folder.Reserve("tools");
				fs::create_directory(Inside);
				std::ofstream(Inside / "a.s") << "half";
				_exit(0);
			});
		for (const std::string& Name : ListFiles())
		{
			if (Before.count(Name) == 0)
			{
				return Scratch.Path / Name;
			}
		}
		return {};
	}

	std::set<std::string> ListFiles() const
	{
		std::set<std::string> Names;
		for (const fs::directory_entry& Entry : fs::directory_iterator(Scratch.Path))
		{
			Names.insert(Entry.path().filename().string());
		}
		return Names;
	}

	const FScratchFolder Scratch;
};

} // namespace

TEST_F(MarkedFolder, GoesWithItsScopeAndNothingElse)
{
	std::string Path;
	{
		const FMarkedFolder Folder(GetBegin());
		Path = Folder.GetPath();
		EXPECT_EQ(0700, GetMode(Path));
		std::ofstream(Folder.Reserve("kernel.cpp")) << "x";
		InAChild([&] { Folder.~FMarkedFolder(); });
		EXPECT_TRUE(fs::exists(Path + "/kernel.cpp"));
		std::ofstream(Path + "/thesis.txt") << "mine";
	}
	EXPECT_TRUE(fs::exists(Path + "/thesis.txt"));
	EXPECT_EQ(1, std::distance(fs::directory_iterator(Path), {}));
	{
		const FMarkedFolder Folder(GetBegin());
		std::ofstream(Folder.Reserve("kernel.cpp")) << "x";
	}
	EXPECT_EQ(1u, ListFiles().size());
}

TEST_F(MarkedFolder, GoesWithTheProcessWhileItIsWrittenTo)
{
	InAChild(
		[this]
		{
			const FMarkedFolder Folder(GetBegin());
			const fs::path Inside = Folder.Reserve("run");
			fs::create_directory(Inside);
			std::thread(
				[&]
				{
					for (int Index = 0; fs::exists(Inside); ++Index)
					{
						std::ofstream(Inside / std::to_string(Index)) << Index;
					}
				})
				.detach();
			usleep(20000);
			DoEndActions();
			_exit(0);
		});
	EXPECT_TRUE(fs::is_empty(Scratch.Path));
}

TEST_F(MarkedFolder, OfTheDeadIsRemoved)
{
	ASSERT_TRUE(fs::exists(Abandon() / "tools/a.s"));
	fs::rename(Abandon(), GetBegin() + "going."); // it was killed while it took its folder away
	const FMarkedFolder Living(GetBegin());
	RemoveTemporaryFolders(Scratch.Path.string());
	EXPECT_EQ(1u, ListFiles().size());
	EXPECT_TRUE(fs::exists(Living.GetPath()));
}

TEST_F(MarkedFolder, OfWhoDiedWhileMakingTheMarkIsRemovedIfNothingElseIsIn)
{
	const auto CutMark = [this](size_t Length)
	{
		const fs::path Folder = Abandon();
		const std::string Whole = ReadBytes(Folder / ".drydock.mark");
		fs::remove_all(Folder / "tools");
		fs::remove(Folder / "kernel.cpp");
		fs::resize_file(Folder / ".drydock.mark", std::min(Length, Whole.find('\0')));
		return Folder;
	};
	for (const size_t Length : {size_t(0), size_t(10), std::string::npos})
	{
		CutMark(Length);
	}
	const fs::path Other = CutMark(0);
	std::ofstream(Other / "thesis.txt") << "mine";
	std::ofstream(CutMark(0) / ".drydock.mark") << "mine";
	RemoveTemporaryFolders(Scratch.Path.string());
	EXPECT_EQ(2u, ListFiles().size());
	EXPECT_TRUE(fs::exists(Other / "thesis.txt"));
	EXPECT_TRUE(fs::exists(Other / ".drydock.mark"));
}

TEST_F(MarkedFolder, WhatOnlyHasTheNameStays)
{
	for (const char* const Name : {"drydock-2026-11-27", "drydock-9999999-abcdef", "drydock-2024-fork"})
	{
		fs::create_directory(Scratch.Path / Name);
		fs::permissions(Scratch.Path / Name, fs::perms::owner_all);
		Scratch.Add(std::string(Name) + "/thesis.txt", "mine");
	}
	Scratch.Add("drydock-2025-plan.txt", "mine");
	Scratch.Add("drydock-9999999-abcdeg", "mine");
	const fs::path Left = Abandon();
	fs::copy(Left, Scratch.Path / "drydock-1-copied", fs::copy_options::recursive);
	fs::permissions(Scratch.Path / "drydock-1-copied", fs::perms::owner_all);
	fs::create_directory_symlink(Left, Scratch.Path / "drydock-1-linked");
	const std::set<std::string> Before = ListFiles();
	fs::permissions(Left, fs::perms::owner_all | fs::perms::group_read); // which drydock's never are
	RemoveTemporaryFolders(Scratch.Path.string());
	EXPECT_EQ(Before, ListFiles());
	EXPECT_TRUE(fs::exists(Scratch.Path / "drydock-2026-11-27/thesis.txt"));
	EXPECT_TRUE(fs::exists(Scratch.Path / "drydock-1-copied/kernel.cpp"));
	EXPECT_TRUE(fs::exists(Left / "kernel.cpp"));
}

TEST_F(MarkedFolder, OnlyWhatTheMarkListsIsRemoved)
{
	const fs::path Left = Abandon();
	Scratch.Add("outside", "mine");
	std::ofstream(Left / "thesis.txt") << "mine";
	std::ofstream(Left / ".drydock.mark", std::ios::app) << std::string("../outside\0.\0\0..\0thesis.txt", 27);
	RemoveTemporaryFolders(Scratch.Path.string());
	EXPECT_TRUE(fs::exists(Scratch.Path / "outside"));
	EXPECT_TRUE(fs::exists(Left / "thesis.txt")); // a name that was cut short is none
	EXPECT_FALSE(fs::exists(Left / "kernel.cpp"));
}
