// Pipes pictures to ffmpeg, which makes a video of them.
#include "Sequence/Video.h"

#include "Text/AsideFile.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

bool IsInstalled(const std::string& Program)
{
	const char* const Folders = std::getenv("PATH");
	for (const std::string& Folder : SplitText(Folders != nullptr ? Folders : "", ':'))
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

/** Keeps drydock running when the encoder ends early. */
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

/** Returns the problem, or nothing. Throws FError if the file cannot be written. */
std::string PipeToEncoder(const std::vector<std::string>& Pictures, double FramesPerSecond, const std::string& File)
{
	FAsideFile Aside{Files::path(File)};
	// Through a pipe, because frame numbers may leave gaps. Video coders want even sizes and halved colour.
	const std::string Command = fmt::format("ffmpeg -v error -y -f image2pipe -c:v png -framerate {:.6g} -i - -vf "
											"'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p {}",
		FramesPerSecond, Quote("file:" + Aside.GetPath().string())); // no option, no address
	const FBrokenPipesIgnored Guard;
	FILE* const Pipe = popen(Command.c_str(), "w");
	if (Pipe == nullptr)
	{
		return "ffmpeg cannot be started";
	}
	for (const std::string& Picture : Pictures)
	{
		const std::string Bytes = TryReadTextFile(Picture, MaxBinaryBytes).value_or("");
		std::fwrite(Bytes.data(), 1, Bytes.size(), Pipe);
	}
	std::error_code Ignored;
	if (pclose(Pipe) != 0 || !Files::exists(Aside.GetPath(), Ignored))
	{
		return "ffmpeg failed; its messages are above";
	}
	Aside.PutInPlace();
	return "";
}

} // namespace

std::string MakeVideo(const std::vector<std::string>& Pictures, double FramesPerSecond, const std::string& File)
{
	if (!IsInstalled("ffmpeg"))
	{
		return "ffmpeg is not on the PATH (Debian: apt install ffmpeg); the frames are complete";
	}
	try
	{
		return PipeToEncoder(Pictures, FramesPerSecond, File);
	}
	catch (const FError& Unwritten)
	{
		return File + " " + Unwritten.GetDiagnostics().front().Message;
	}
}

} // namespace Drydock
