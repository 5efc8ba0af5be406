// Sequences of few small frames, and their folders compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <unistd.h>

namespace SequenceTest
{

namespace Files = std::filesystem;

/** Scenes: the folder of the shipped ones. Every frame shows what the one before kept for reflections, so that no frame
 * can do without its history. */
inline std::string MakeConfigText(const std::string& Scenes, const std::string& More = "")
{
	return R"({"scene": {"file": ")" + Scenes + R"(moving_camera.####.exr"}, "volumes": "fromScene",
		"passes": [
			{"type": "GaussianBlur", "at": "SSRInput", "name": "Kept"},
			{"type": "Downsample", "at": "MotionBlur", "name": "Shown", "inputs": {"Input": "CustomSSRInput"}}])" +
		   More + "}";
}

inline std::string ReadBytes(const Files::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

/** All files by name, with their bytes; those that hold milliseconds without. */
inline std::map<std::string, std::string> ReadFolder(const Files::path& Folder)
{
	std::map<std::string, std::string> Contents;
	for (const Files::directory_entry& Entry : Files::recursive_directory_iterator(Folder))
	{
		const std::string Name = Entry.path().filename().string();
		if (Entry.is_regular_file())
		{
			const bool bTimes = Name == "timing.json" || Name == "trace.json";
			Contents[Files::relative(Entry.path(), Folder).string()] = bTimes ? "" : ReadBytes(Entry.path());
		}
	}
	return Contents;
}

/** The first file that one has and the other has not, or not like that. */
inline testing::AssertionResult AreSameFolders(const Files::path& Expected, const Files::path& Actual)
{
	std::map<std::string, std::string> Left = ReadFolder(Expected);
	for (const auto& [Name, Bytes] : ReadFolder(Actual))
	{
		const auto Found = Left.find(Name);
		if (Found == Left.end() || Found->second != Bytes)
		{
			return testing::AssertionFailure()
				   << Name << (Found == Left.end() ? " is there too much" : " has other bytes");
		}
		Left.erase(Found);
	}
	return Left.empty() ? testing::AssertionSuccess()
						: testing::AssertionFailure() << Left.begin()->first << " is missing";
}

/** An empty folder, removed at the end. */
struct FTemporaryFolder
{
	explicit FTemporaryFolder(const std::string& Name)
		: Path(Files::temp_directory_path() / (Name + "_" + std::to_string(getpid())))
	{
		Files::remove_all(Path);
		Files::create_directories(Path);
	}
	~FTemporaryFolder() { Files::remove_all(Path); }
	FTemporaryFolder(const FTemporaryFolder&) = delete;
	FTemporaryFolder& operator=(const FTemporaryFolder&) = delete;

	const Files::path Path;
};

} // namespace SequenceTest
