// Source: drydock.
#include "Sequence/Video.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

bool IsInstalled(const std::string& Program)
{
	const char* const Folders = std::getenv("PATH");
	std::istringstream Stream(Folders != nullptr ? Folders : "");
	for (std::string Folder; std::getline(Stream, Folder, ':');)
	{
		if (access((Files::path(Folder) / Program).c_str(), X_OK) == 0)
		{
			return true;
		}
	}
	return false;
}

/** For a shell. */
std::string Quote(const std::string& Text)
{
	std::string Quoted = "'";
	for (const char Character : Text)
	{
		Quoted += Character == '\'' ? "'\\''" : std::string(1, Character);
	}
	return Quoted + "'";
}

/** A program that goes away early is no reason to go away too. */
class FBrokenPipesIgnored
{
public:
	FBrokenPipesIgnored()
		: Before(std::signal(SIGPIPE, SIG_IGN))
	{
	}
	~FBrokenPipesIgnored() { std::signal(SIGPIPE, Before); }

private:
	void (*Before)(int);
};

} // namespace

std::string MakeVideo(const std::vector<std::string>& Pictures, double FramesPerSecond, const std::string& File)
{
	if (!IsInstalled("ffmpeg"))
	{
		return "there is no ffmpeg on the PATH (Debian: apt install ffmpeg); the frames are there";
	}
	const Files::path Target(File);
	std::error_code Error;
	if (Target.has_parent_path())
	{
		Files::create_directories(Target.parent_path(), Error);
	}
	const Files::path Aside = Target.parent_path() / (Target.stem().string() + ".writing." + std::to_string(getpid()) +
														 Target.extension().string());
	// Through a pipe, because frame numbers may leave gaps. Video coders want even sizes and halved colour.
	char Rate[32];
	std::snprintf(Rate, sizeof(Rate), "%.6g", FramesPerSecond);
	const std::string Command = std::string("ffmpeg -v error -y -f image2pipe -c:v png -framerate ") + Rate +
								" -i - -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p " + Quote(Aside.string());
	const FBrokenPipesIgnored Guard;
	FILE* const Pipe = popen(Command.c_str(), "w");
	if (Pipe == nullptr)
	{
		return "ffmpeg cannot be started";
	}
	for (const std::string& Picture : Pictures)
	{
		std::ifstream Stream(Picture, std::ios::binary);
		const std::string Bytes(std::istreambuf_iterator<char>(Stream), {});
		std::fwrite(Bytes.data(), 1, Bytes.size(), Pipe);
	}
	const bool bDone = pclose(Pipe) == 0 && Files::exists(Aside, Error);
	if (bDone)
	{
		Files::rename(Aside, Target, Error);
	}
	if (!bDone || Error)
	{
		std::error_code Ignored;
		Files::remove(Aside, Ignored);
		return bDone ? File + " cannot be written: " + Error.message() : "ffmpeg failed; what it said stands above";
	}
	return "";
}

} // namespace Drydock
