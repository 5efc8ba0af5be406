// The shader cache is code that is run: what someone else could have put there is not used, what cannot be written is
// said, and no lock is waited for without end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ShaderCache.h"
#include "ShaderCacheLock.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;
using testing::Not;

class FCacheTrust : public testing::Test
{
protected:
	~FCacheTrust() override { FShaderCache::SetUse(EShaderCacheUse::Usual); }

	/** Compiles into the cache. */
	void Fill(const std::string& Value) const
	{
		const FShaderRun Run = RunCacheShader(Value);
		EXPECT_EQ("", Run.Error);
		EXPECT_FALSE(Run.bFromCache);
		EXPECT_EQ(1u, ListFiles(Cache, ".so").size());
	}

	/** Whether the shader of Fill runs without what the cache has of it; what was printed. */
	static std::string RunWithoutCache(const std::string& Value)
	{
		const FShaderRun Run = RunCacheShader(Value);
		EXPECT_EQ("", Run.Error);
		EXPECT_FALSE(Run.bFromCache);
		EXPECT_EQ(std::stof(Value), Run.Value);
		return Run.Printed;
	}

	const FScratchFolder Scratch;
	const fs::path Cache = Scratch.Path / "cache";
	const FScopedVariable Chosen{"DRYDOCK_CACHE_DIR", Cache.string()};
};

} // namespace

TEST_F(FCacheTrust, AFolderOfItsOwnIsMadeForTheUserAloneAndUsed)
{
	Fill("11");
	EXPECT_EQ(0700, GetMode(Cache));
	const FShaderRun Again = RunCacheShader("11");
	EXPECT_TRUE(Again.bFromCache);
	EXPECT_EQ(11.0f, Again.Value);
	EXPECT_EQ("", Again.Printed);
}

TEST_F(FCacheTrust, AFolderThatOthersCanWriteIsNotUsed)
{
	Fill("12");
	const std::vector<fs::path> Before = ListFiles(Cache);
	chmod(Cache.c_str(), 0777);
	const std::string Printed = RunWithoutCache("12");
	EXPECT_THAT(Printed, HasSubstr(Cache.string() + ": warning DD6050: "));
	EXPECT_THAT(Printed, HasSubstr("can be written by others (mode 0777)"));
	EXPECT_EQ(Before, ListFiles(Cache)); // nor is anything stored there
}

TEST_F(FCacheTrust, AFolderBehindALinkIsNotUsed)
{
	Fill("13");
	const fs::path Link = Scratch.Path / "link";
	fs::create_symlink(Cache, Link);
	const FScopedVariable Other("DRYDOCK_CACHE_DIR", Link.string());
	EXPECT_THAT(RunWithoutCache("13"), HasSubstr(Link.string() + ": warning DD6050: "));
}

TEST_F(FCacheTrust, AFolderOfAnotherUserIsNotUsed)
{
	if (geteuid() != 0)
	{
		GTEST_SKIP() << "only root can give a folder away; TrustedFolderTest has the rule";
	}
	Fill("14");
	ASSERT_EQ(0, chown(Cache.c_str(), 65534, 65534));
	EXPECT_THAT(RunWithoutCache("14"), HasSubstr("belongs to another user (uid 65534)"));
}

TEST_F(FCacheTrust, AnEntryOfAnotherUserIsNotUsed)
{
	if (geteuid() != 0)
	{
		GTEST_SKIP() << "only root can give a file away; TrustedFolderTest has the rule";
	}
	Fill("10");
	ASSERT_EQ(0, chown(ListFiles(Cache, ".so")[0].c_str(), 65534, 65534));
	RunWithoutCache("10");
}

TEST_F(FCacheTrust, AnEntryThatOthersCanWriteIsCompiledAgainAndReplaced)
{
	Fill("15");
	const fs::path Kernel = ListFiles(Cache, ".so")[0];
	chmod(Kernel.c_str(), 0666);
	RunWithoutCache("15");
	EXPECT_EQ(0, GetMode(Kernel) & 022);
	EXPECT_TRUE(RunCacheShader("15").bFromCache);
}

TEST_F(FCacheTrust, AnEntryBehindALinkIsCompiledAgain)
{
	Fill("16");
	const fs::path Kernel = ListFiles(Cache, ".so")[0];
	fs::rename(Kernel, Scratch.Path / "planted.so");
	fs::create_symlink(Scratch.Path / "planted.so", Kernel);
	RunWithoutCache("16");
	EXPECT_FALSE(fs::is_symlink(Kernel));
}

TEST_F(FCacheTrust, WithoutAHomeNothingHasAGuessableName)
{
	const FScratchFolder Temporary;
	const FScopedVariable Directory("DRYDOCK_CACHE_DIR", std::nullopt);
	const FScopedVariable Caches("XDG_CACHE_HOME", std::nullopt);
	const FScopedVariable Home("HOME", std::nullopt);
	const FScopedVariable Parent("TMPDIR", Temporary.Path.string());
	EXPECT_THAT(RunWithoutCache("17"), HasSubstr("DD6051"));
	EXPECT_FALSE(fs::exists(Temporary.Path / ("drydock-" + std::to_string(getuid()))));
}

TEST_F(FCacheTrust, ReadOnlyWritesNothing)
{
	FShaderCache::SetUse(EShaderCacheUse::ReadOnly);
	EXPECT_EQ("", RunWithoutCache("18"));
	EXPECT_FALSE(fs::exists(Cache));
	EXPECT_TRUE(RunCacheShader("18").bFromCache); // of the folder of the run

	FShaderCache::SetUse(EShaderCacheUse::Usual);
	Fill("19");
	const std::vector<fs::path> Before = ListFiles(Cache);
	FShaderCache::SetUse(EShaderCacheUse::ReadOnly);
	EXPECT_TRUE(RunCacheShader("19").bFromCache);
	RunWithoutCache("20");
	FShaderCache::Open().StoreText("costs.json", "{}");
	EXPECT_EQ(Before, ListFiles(Cache));
}

TEST_F(FCacheTrust, ThatIsRequiredFailsWhereItCannotBeUsed)
{
	FShaderCache::SetUse(EShaderCacheUse::Required);
	ASSERT_TRUE(fs::create_directory(Cache));
	chmod(Cache.c_str(), 0777);
	const FShaderRun Foreign = RunCacheShader("21");
	EXPECT_EQ(ExitFiles, Foreign.ExitCode);
	EXPECT_THAT(Foreign.Error, HasSubstr(Cache.string() + ": error DD6050: "));

	const std::string BelowAFile = Scratch.Add("file", "") + "/cache";
	const FScopedVariable Other("DRYDOCK_CACHE_DIR", BelowAFile);
	const FShaderRun Unwritten = RunCacheShader("21");
	EXPECT_EQ(ExitFiles, Unwritten.ExitCode);
	EXPECT_THAT(
		Unwritten.Error, HasSubstr(BelowAFile + ": error DD6051: the shader cache cannot be written: Not a directory"));
}

TEST_F(FCacheTrust, ThatCannotBeWrittenIsSaidOnce)
{
	const FScopedVariable Other("DRYDOCK_CACHE_DIR", Scratch.Add("file", "") + "/cache");
	EXPECT_THAT(
		RunWithoutCache("22"), HasSubstr("warning DD6051: the shader cache cannot be written: Not a directory"));
	EXPECT_EQ("", RunCacheShader("23").Printed);
}

TEST_F(FCacheTrust, LeftoversOfTheDeadGoWithTheNextRun)
{
	ASSERT_TRUE(fs::create_directory(Cache));
	const pid_t Child = fork();
	ASSERT_GE(Child, 0);
	if (Child == 0)
	{
		const FMarkedFolder Left((Cache / MakeTemporaryName()).string());
		std::ofstream(Left.Reserve("0")) << "half";
		_exit(0);
	}
	waitpid(Child, nullptr, 0);
	ASSERT_FALSE(fs::is_empty(Cache));
	const fs::path Mine = Cache / ("drydock-" + std::to_string(Child) + "-7");
	std::ofstream(Mine) << "mine";
	FShaderCache::Open();
	EXPECT_TRUE(fs::exists(Mine));
	EXPECT_EQ(1, std::distance(fs::directory_iterator(Cache), {}));
}

TEST_F(FCacheTrust, FilesOfTheLocksNamesThatAreNoLocksStay)
{
	fs::create_directories(Cache / "locks");
	const auto GetName = [this](unsigned Number)
	{
		char Name[8];
		std::snprintf(Name, sizeof(Name), "%02x", Number);
		return Cache / "locks" / Name;
	};
	for (unsigned Number = 0; Number < 256; ++Number)
	{
		std::ofstream(GetName(Number)) << "mine";
	}
	EXPECT_EQ(25.0f, RunCacheShader("25").Value);
	for (unsigned Number = 0; Number < 256; ++Number)
	{
		EXPECT_EQ("mine", ReadBytes(GetName(Number)));
	}
}

TEST_F(FCacheTrust, ALockThatIsNeverGivenBackIsSaidAndLeft)
{
	ASSERT_TRUE(fs::create_directory(Cache));
	int Ready[2];
	ASSERT_EQ(0, pipe(Ready));
	const pid_t Holder = fork();
	ASSERT_GE(Holder, 0);
	if (Holder == 0)
	{
		const FTrustedFolder Folder(Cache.string(), {geteuid()});
		std::vector<std::unique_ptr<FShaderCacheLock>> Locks;
		for (int Number = 0; Number < 256; ++Number)
		{
			char Name[8];
			std::snprintf(Name, sizeof(Name), "%02x", unsigned(Number));
			Locks.push_back(std::make_unique<FShaderCacheLock>(Folder, Name));
		}
		[[maybe_unused]] const ssize_t Told = write(Ready[1], "", 1);
		alarm(60); // also where nobody kills it
		pause();
		_exit(0);
	}
	char Byte;
	ASSERT_EQ(1, read(Ready[0], &Byte, 1));
	const FScopedVariable Patience("DRYDOCK_LOCK_SECONDS", "1");
	const FShaderRun Run = RunCacheShader("24");
	kill(Holder, SIGKILL);
	waitpid(Holder, nullptr, 0);
	close(Ready[0]);
	close(Ready[1]);

	EXPECT_EQ("", Run.Error);
	EXPECT_EQ(24.0f, Run.Value);
	EXPECT_THAT(Run.Printed, HasSubstr("warning DD6052: process " + std::to_string(Holder) + " holds this lock"));
	EXPECT_THAT(Run.Printed, HasSubstr("after 1 s the shader is compiled without it"));
	EXPECT_TRUE(RunCacheShader("24").bFromCache); // what was compiled without the lock is whole
}

TEST_F(FCacheTrust, ALockIsGivenBack)
{
	ASSERT_TRUE(fs::create_directory(Cache));
	const FTrustedFolder Folder(Cache.string(), {geteuid()});
	{
		const FShaderCacheLock First(Folder, "ab");
		EXPECT_EQ(std::to_string(getpid()) + "\n", ReadBytes(Cache / "locks" / "ab"));
	}
	EXPECT_EQ("", ReadBytes(Cache / "locks" / "ab"));
	testing::internal::CaptureStderr();
	const FShaderCacheLock Second(Folder, "ab");
	EXPECT_EQ("", testing::internal::GetCapturedStderr());
}
