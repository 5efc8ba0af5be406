// What is read of files that strangers name: pipes, sockets, devices and endless files are refused, and nobody waits.
#include <gtest/gtest.h>

#include "RegularFile.h"

#include <filesystem>
#include <fstream>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

class RegularFile : public testing::Test
{
protected:
	RegularFile()
		: Folder(Files::temp_directory_path() / ("drydock_regular_" + std::to_string(getpid())))
	{
		Files::create_directories(Folder);
		alarm(20); // in the place of a test that waits for ever
	}
	~RegularFile() override
	{
		alarm(0);
		Files::remove_all(Folder);
	}

	std::string Path(const std::string& Name) const { return (Folder / Name).string(); }

	std::string Write(const std::string& Name, const std::string& Text) const
	{
		std::ofstream(Path(Name), std::ios::binary) << Text;
		return Path(Name);
	}

	static std::string ProblemOf(const std::string& Path)
	{
		const FFileBytes Read = ReadRegularFile(Path);
		EXPECT_FALSE(Read.Bytes) << Path;
		EXPECT_FALSE(Read.bTooLarge) << Path;
		EXPECT_EQ(Read.Problem, FRegularFile(Path).GetProblem());
		return Read.Problem;
	}

	const Files::path Folder;
};

} // namespace

TEST_F(RegularFile, APathOfWindowsIsNamedAsWslHasIt)
{
	EXPECT_EQ("No such file or directory; the drive of Windows is /mnt/c in WSL: /mnt/c/frames/a.exr",
		ProblemOf(Path("C:\\frames\\a.exr")));
	EXPECT_EQ("No such file or directory; the drive of Windows is /mnt/d in WSL: /mnt/d/a.exr", ProblemOf("d:/a.exr"));
	EXPECT_EQ("No such file or directory; folders of a path are parted by /, not by \\", ProblemOf(Path("a\\b.exr")));
	EXPECT_EQ("No such file or directory", ProblemOf(Path("a.exr")));
}

TEST_F(RegularFile, AllBytesAreRead)
{
	std::string Bytes;
	for (int Index = 0; Index < 100'000; ++Index)
	{
		Bytes += static_cast<char>(Index * 7);
	}
	EXPECT_EQ(Bytes, ReadRegularFile(Write("a", Bytes)).Bytes);
	EXPECT_EQ("", ReadRegularFile(Write("empty", "")).Bytes);
}

TEST_F(RegularFile, WhatIsNoFileIsRefusedAtOnce)
{
	ASSERT_EQ(0, mkfifo(Path("pipe").c_str(), 0600));
	EXPECT_EQ("it is a pipe, and only files are read", ProblemOf(Path("pipe")));
	EXPECT_EQ("it is a device, and only files are read", ProblemOf("/dev/zero"));
	EXPECT_EQ("it is a folder", ProblemOf(Folder.string()));

	sockaddr_un Address = {};
	Address.sun_family = AF_UNIX;
	Path("socket").copy(Address.sun_path, sizeof(Address.sun_path) - 1);
	const int Socket = socket(AF_UNIX, SOCK_STREAM, 0);
	ASSERT_EQ(0, bind(Socket, reinterpret_cast<const sockaddr*>(&Address), sizeof(Address)));
	EXPECT_EQ("it is a socket, and only files are read", ProblemOf(Path("socket")));
	close(Socket);
}

TEST_F(RegularFile, WhatTheSystemRefusesIsSaidInItsWords)
{
	EXPECT_EQ("No such file or directory", ProblemOf(Path("none")));
	EXPECT_EQ("File name too long", ProblemOf(Path(std::string(300, 'n'))));
	Files::create_symlink("loop", Path("loop"));
	EXPECT_EQ("Too many levels of symbolic links", ProblemOf(Path("loop")));
	EXPECT_EQ("Not a directory", ProblemOf(Write("file", "") + "/below"));
	EXPECT_EQ("its path holds the character NUL", ProblemOf(Path("file") + std::string(1, '\0') + ".json"));
}

TEST_F(RegularFile, LargerThanAllowedIsRefused)
{
	const std::string File = Write("a", std::string(1000, 'a'));
	EXPECT_TRUE(ReadRegularFile(File, 1000).Bytes);
	const FFileBytes Read = ReadRegularFile(File, 999);
	EXPECT_FALSE(Read.Bytes);
	EXPECT_TRUE(Read.bTooLarge);
	EXPECT_EQ("it has 1000 bytes, and at most 999 are read", Read.Problem);
}

TEST_F(RegularFile, ASizeThatLiesIsNotBelieved)
{
	// The system says 0 for each file of /proc.
	const FFileBytes Whole = ReadRegularFile("/proc/self/status");
	ASSERT_TRUE(Whole.Bytes);
	EXPECT_NE(std::string::npos, Whole.Bytes->find("VmHWM:"));
	EXPECT_TRUE(ReadRegularFile("/proc/self/status", 16).bTooLarge);
}
