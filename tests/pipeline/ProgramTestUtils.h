// The program called as a user calls it, in a folder that goes away.
#pragma once

#include <gtest/gtest.h>

#include "Picture/ImageFile.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace ProgramTest
{

namespace Files = std::filesystem;

struct FOutcome
{
	int ExitCode = -1;
	std::string Printed; // on both streams
};

class FProgramFolder
{
public:
	explicit FProgramFolder(const std::string& Name)
		: Path(Files::temp_directory_path() / ("drydock_" + Name + "_" + std::to_string(getpid())))
	{
		Files::remove_all(Path);
		Files::create_directories(Path);
	}
	~FProgramFolder() { Files::remove_all(Path); }
	FProgramFolder(const FProgramFolder&) = delete;
	FProgramFolder& operator=(const FProgramFolder&) = delete;

	/** Arguments as a shell takes them. */
	FOutcome Call(const std::string& Arguments) const
	{
		const std::string Command =
			"cd '" + Path.string() + "' && '" DRYDOCK_TEST_BINARY_DIR "/bin/drydock' " + Arguments + " 2>&1";
		FOutcome Outcome;
		FILE* const Pipe = popen(Command.c_str(), "r");
		std::array<char, 4096> Buffer;
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Outcome.Printed.append(Buffer.data(), NumRead);
		}
		Outcome.ExitCode = WEXITSTATUS(pclose(Pipe));
		return Outcome;
	}

	void Write(const std::string& Name, const std::string& Text) const
	{
		Files::create_directories((Path / Name).parent_path());
		std::ofstream(Path / Name, std::ios::binary) << Text;
	}

	std::string Read(const std::string& Name) const
	{
		std::ifstream Stream(Path / Name, std::ios::binary);
		return std::string(std::istreambuf_iterator<char>(Stream), {});
	}

	/** A scene of 16 x 8: red x / 16, green y / 8, blue 1/4; and a config of it with More. */
	void WriteFrame(const std::string& Config, const std::string& More) const
	{
		Drydock::FImage Image{16, 8, 3, {}};
		for (int Pixel = 0; Pixel < 16 * 8; ++Pixel)
		{
			const double Color[] = {Pixel % 16 / 16.0, Pixel / 16 / 8.0, 0.25};
			Image.Values.insert(Image.Values.end(), std::begin(Color), std::end(Color));
		}
		Drydock::WriteExr((Path / "scene.exr").string(), Image, {"R", "G", "B"});
		Write(Config, R"({"scene": {"file": "scene.exr"})" + More + "}");
	}

	const Files::path Path;
};

} // namespace ProgramTest
