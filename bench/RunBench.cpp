// What a whole run costs: drydock run against oiiotool, which reads the same EXR and writes the same three files with
// nothing in between; the same frame with twice the width and height; and the start of drydock alone. The programs take
// turns; medians of CPU time (user and system, of all threads) and the most memory. Prints a table in Markdown.
//
//     bench_run [ROUNDS] [SCENE.exr]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{

struct FCost
{
	double CpuMs = 0.0;
	double WallMs = 0.0;
	double Megabytes = 0.0;
};

double ToMs(const timeval& Time)
{
	return 1e3 * static_cast<double>(Time.tv_sec) + 1e-3 * static_cast<double>(Time.tv_usec);
}

double Now()
{
	timespec Time;
	clock_gettime(CLOCK_MONOTONIC, &Time);
	return 1e3 * static_cast<double>(Time.tv_sec) + 1e-6 * static_cast<double>(Time.tv_nsec);
}

/** Runs a program to its end, silently. Exits where it fails. */
FCost Run(const std::vector<std::string>& Arguments)
{
	const double Begin = Now();
	const pid_t Child = fork();
	if (Child == 0)
	{
		const int Nowhere = open("/dev/null", O_WRONLY);
		dup2(Nowhere, STDOUT_FILENO);
		std::vector<char*> Pointers;
		for (const std::string& Argument : Arguments)
		{
			Pointers.push_back(const_cast<char*>(Argument.c_str()));
		}
		Pointers.push_back(nullptr);
		execvp(Pointers[0], Pointers.data());
		_exit(127);
	}
	int Status = 0;
	rusage Usage = {};
	wait4(Child, &Status, 0, &Usage);
	if (!WIFEXITED(Status) || WEXITSTATUS(Status) != 0)
	{
		std::fprintf(stderr, "%s failed\n", Arguments[0].c_str());
		std::exit(1);
	}
	return {ToMs(Usage.ru_utime) + ToMs(Usage.ru_stime), Now() - Begin, static_cast<double>(Usage.ru_maxrss) / 1024.0};
}

double TakeMedian(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + static_cast<std::ptrdiff_t>(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

struct FRow
{
	std::string Name;
	std::vector<std::string> Arguments;
	std::vector<FCost> Costs = {};

	double GetMedian(double FCost::*Member) const
	{
		std::vector<double> Values;
		for (const FCost& Cost : Costs)
		{
			Values.push_back(Cost.*Member);
		}
		return TakeMedian(std::move(Values));
	}
};

/** The sample config of toon bloom with another scene: plain JSON, without its comments. */
void WriteConfig(const std::filesystem::path& File, const std::string& Scene)
{
	std::ofstream(File) << R"({"scene": {"file": ")" << Scene << R"("}, "volumes": [{"bUnbound": true, "Settings": )"
						<< R"({"BloomIntensity": 1.5, "BloomThreshold": -1, "BloomToonIntensity": 0.1}}]})";
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	const int Rounds = ArgumentCount > 1 ? std::max(1, std::atoi(Arguments[1])) : 7;
	const std::string Scene = ArgumentCount > 2 ? std::filesystem::absolute(Arguments[2]).string()
												: DRYDOCK_BENCH_SOURCE_DIR "/configs/scenes/toon_character_1080p.exr";
	const std::string Program = DRYDOCK_BENCH_BINARY_DIR "/bin/drydock";
	const std::filesystem::path Folder =
		std::filesystem::temp_directory_path() / ("drydock_bench_run_" + std::to_string(getpid()));
	std::filesystem::create_directories(Folder);
	const std::string Config = (Folder / "toon_bloom.json").string();
	WriteConfig(Config, Scene);
	const auto Out = [&Folder](const char* Name)
	{
		return (Folder / Name).string();
	};
	const std::string Large = (Folder / "large.exr").string();
	Run({"oiiotool", Scene, "--resample", "3840x2160", "-o", Large});
	const std::string LargeConfig = (Folder / "toon_bloom_large.json").string();
	WriteConfig(LargeConfig, Large);
	std::vector<FRow> Rows = {
		{"oiiotool: read, write the same three files",
			{"oiiotool", Scene, "--ch", "R,G,B,A", "-o", Out("scene_linear.exr"), "--ch", "R,G,B", "-o",
				Out("final.exr"), "-d", "uint8", "-o", Out("final.png")}},
		{"drydock run, toon bloom", {Program, "run", Config, "--out", Out("all"), "--report", "off"}},
		{"the same, --outputs png",
			{Program, "run", Config, "--out", Out("png"), "--outputs", "png", "--report", "off"}},
		{"drydock run, toon bloom, 3840 x 2160",
			{Program, "run", LargeConfig, "--out", Out("large"), "--report", "off"}},
		{"drydock --version", {Program, "--version"}},
		{"drydock check", {Program, "check", DRYDOCK_BENCH_SOURCE_DIR "/configs/neutral.json"}},
	};
	Run(Rows[1].Arguments); // compiles what is not compiled yet
	for (int Round = 0; Round < Rounds; ++Round)
	{
		for (FRow& Row : Rows)
		{
			Row.Costs.push_back(Run(Row.Arguments));
		}
	}
	std::printf(
		"%s, medians of %d\n\n| | CPU ms | wall ms | memory MB | CPU, against oiiotool |\n|---|---|---|---|---|\n",
		ArgumentCount > 2 ? Scene.c_str() : "configs/scenes/toon_character_1080p.exr", Rounds);
	for (const FRow& Row : Rows)
	{
		std::printf("| %s | %.0f | %.0f | %.0f | %.2f |\n", Row.Name.c_str(), Row.GetMedian(&FCost::CpuMs),
			Row.GetMedian(&FCost::WallMs), Row.GetMedian(&FCost::Megabytes),
			Row.GetMedian(&FCost::CpuMs) / Rows[0].GetMedian(&FCost::CpuMs));
	}
	std::printf(
		"\n3840 x 2160 takes %.2f times the CPU time of the scene's own size, and %.0f bytes of memory a pixel.\n",
		Rows[3].GetMedian(&FCost::CpuMs) / Rows[1].GetMedian(&FCost::CpuMs),
		Rows[3].GetMedian(&FCost::Megabytes) * 1024.0 * 1024.0 / (3840.0 * 2160.0));
	std::filesystem::remove_all(Folder);
}
