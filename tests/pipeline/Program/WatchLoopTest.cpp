// The loop of --watch runs again after whatever an edit does to a file, and never ends by itself.
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "Program/WatchLoop.h"
#include "Text/TextFile.h"

#include <filesystem>
#include <fstream>
#include <new>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

class WatchLoop : public testing::Test
{
protected:
	WatchLoop()
		: Folder(Files::temp_directory_path() / ("drydock_watch_" + std::to_string(getpid())))
		, File((Folder / "a.json").string())
	{
		Files::create_directories(Folder);
	}
	~WatchLoop() override { Files::remove_all(Folder); }

	void Write(const std::string& Text) const { std::ofstream(File, std::ios::binary) << Text; }

	/** Runs read the file, and throw where they cannot; each look makes the next edit. What each run found. */
	std::vector<std::string> Watch(const std::vector<std::function<void()>>& Edits)
	{
		std::vector<std::string> Found;
		size_t NumEdits = 0;
		RunWatchLoop({.Run =
						  [&]
					  {
						  Found.push_back(TryReadTextFile(File).value_or("unreadable"));
						  ReadTextFile(File);
					  },
			.List =
				[&]
			{
				FWatchedFiles Watched;
				Watched.AddFile(File);
				return Watched;
			},
			.Wait =
				[&]
			{
				if (NumEdits == Edits.size())
				{
					return false;
				}
				Edits[NumEdits++]();
				return true;
			}});
		return Found;
	}

	const Files::path Folder;
	const std::string File;
};

} // namespace

TEST_F(WatchLoop, SurvivesWhateverAnEditMakesOfAFile)
{
	Write("whole");
	const auto Remove = [this]
	{
		Files::remove_all(File);
	};
	const std::vector<std::string> Found = Watch({
		Remove,
		[this] { Write("half"); },
		Remove,
		[this] { Files::create_directory(File); },
		Remove,
		[this] { Files::create_symlink(File, File); }, // a loop
		Remove,
		[this] { Write(""); },
		[this] { Write("whole"); },
	});
	// A loop of links is as good as no file: nothing changes.
	EXPECT_EQ((std::vector<std::string>{
				  "whole", "unreadable", "half", "unreadable", "unreadable", "unreadable", "", "whole"}),
		Found);
}

TEST_F(WatchLoop, RunsAgainForAChangeThatLeavesTheTimeOfWriting)
{
	constexpr useconds_t Tick = 50'000; // longer than one of the file system's clock
	Write("one");
	const Files::file_time_type Time = Files::last_write_time(File);
	const std::vector<std::string> Found = Watch({
		[&]
		{
			usleep(Tick);
			Write("two");
			Files::last_write_time(File, Time);
		},
		[&]
		{
			usleep(Tick);
			Files::permissions(File, Files::perms::owner_write);
		},
	});
	EXPECT_EQ(3u, Found.size());
	EXPECT_EQ("two", Found[1]);
}

TEST_F(WatchLoop, FilesThatTheFirstRunMadeKnownAreNoChange)
{
	Write("one");
	const std::string OfPlugin = (Folder / "plugin.usf").string();
	std::ofstream(OfPlugin) << "one";
	int NumRuns = 0;
	int NumLooks = 0;
	RunWatchLoop({.Run = [&] { ++NumRuns; },
		.List =
			[&]
		{
			FWatchedFiles Watched;
			Watched.AddFile(File);
			if (NumRuns > 0)
			{
				Watched.AddFile(OfPlugin);
			}
			return Watched;
		},
		.Wait =
			[&]
		{
			EXPECT_EQ(NumLooks < 3 ? 1 : 2, NumRuns);
			if (++NumLooks == 3)
			{
				std::ofstream(OfPlugin) << "edited";
			}
			return NumLooks < 6;
		}});
	EXPECT_EQ(2, NumRuns);
}

TEST_F(WatchLoop, GoesOnWhateverIsThrown)
{
	int NumRuns = 0;
	int NumLists = 0;
	RunWatchLoop({.Run =
					  [&]
				  {
					  switch (++NumRuns)
					  {
					  case 1:
						  throw FError({.Code = 1012, .Message = "wrong"}, ExitUsage);
					  case 2:
						  (void)Files::file_size(Folder / "none"); // throws
						  break;
					  case 3:
						  throw std::bad_alloc();
					  default:
						  throw 5;
					  }
				  },
		.List =
			[&]
		{
			FWatchedFiles Watched;
			if (++NumLists % 3 == 0)
			{
				throw std::runtime_error("half there");
			}
			if (NumRuns < 5)
			{
				Watched.AddFile("/" + std::to_string(NumLists));
			}
			return Watched;
		},
		.Wait =
			[]
		{
			return false;
		}});
	EXPECT_GE(NumRuns, 5);
}
