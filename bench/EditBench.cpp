// From an edit to the picture: a shader of a patch that `drydock new` made is edited under `run --watch`, by `run` as a
// whole command, and its C++ by `drydock build`. CPU time (user and system) of the process and all that it started; the
// ways take turns, medians. Beside them stands what the compiler takes of it, and what it takes for no code at all:
// less cannot be reached with it. Prints a table in Markdown.
//
//     bench_edit [ROUNDS] [SCENE.exr]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{

namespace fs = std::filesystem;

struct FCost
{
	double CpuMs = 0.0;
	double WallMs = 0.0;
};

double Now()
{
	timespec Time;
	clock_gettime(CLOCK_MONOTONIC, &Time);
	return 1e3 * static_cast<double>(Time.tv_sec) + 1e-6 * static_cast<double>(Time.tv_nsec);
}

[[noreturn]] void Fail(const std::string& What)
{
	std::fprintf(stderr, "bench_edit: %s\n", What.c_str());
	std::exit(1);
}

/** Starts a program, silently; what it prints to stderr goes to Errors. */
pid_t Start(const std::vector<std::string>& Arguments, int Errors)
{
	const pid_t Child = fork();
	if (Child == 0)
	{
		dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
		dup2(Errors, STDERR_FILENO);
		std::vector<char*> Pointers;
		for (const std::string& Argument : Arguments)
		{
			Pointers.push_back(const_cast<char*>(Argument.c_str()));
		}
		Pointers.push_back(nullptr);
		execvp(Pointers[0], Pointers.data());
		_exit(127);
	}
	return Child;
}

double ToMs(const timeval& Time)
{
	return 1e3 * static_cast<double>(Time.tv_sec) + 1e-3 * static_cast<double>(Time.tv_usec);
}

/** Runs a program to its end. */
FCost Run(const std::vector<std::string>& Arguments)
{
	const double Begin = Now();
	int Status = 0;
	rusage Usage = {};
	wait4(Start(Arguments, STDERR_FILENO), &Status, 0, &Usage);
	if (!WIFEXITED(Status) || WEXITSTATUS(Status) != 0)
	{
		Fail(Arguments[0] + " " + Arguments[1] + " failed");
	}
	return {ToMs(Usage.ru_utime) + ToMs(Usage.ru_stime), Now() - Begin};
}

std::string ReadText(const fs::path& File)
{
	std::ifstream Stream(File);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

/** In one step, so that nobody sees half of it. */
void ReplaceText(const fs::path& File, const std::string& Text)
{
	const fs::path Aside = File.string() + ".aside";
	std::ofstream(Aside) << Text;
	fs::rename(Aside, File);
}

/** CPU time so far of a process that runs, of the children that it waited for, and of those that run. */
double ReadCpuMs(pid_t Process)
{
	const std::string Folder = "/proc/" + std::to_string(Process);
	const std::string Status = ReadText(Folder + "/stat");
	std::istringstream Fields(Status.substr(std::min(Status.size(), Status.rfind(')') + 1)));
	std::string Skipped;
	for (int Field = 3; Field < 14; ++Field)
	{
		Fields >> Skipped;
	}
	double Ticks = 0.0;
	for (int Field = 14; Field < 18; ++Field) // utime, stime, cutime, cstime
	{
		double Value = 0.0;
		Fields >> Value;
		Ticks += Value;
	}
	double Milliseconds = 1e3 * Ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
	std::istringstream Children(ReadText(Folder + "/task/" + std::to_string(Process) + "/children"));
	for (pid_t Child = 0; Children >> Child;)
	{
		Milliseconds += ReadCpuMs(Child);
	}
	return Milliseconds;
}

/** `drydock run --watch`, which says when it has run. */
class FWatch
{
public:
	explicit FWatch(const std::vector<std::string>& Arguments)
	{
		int Pipe[2];
		if (pipe2(Pipe, O_CLOEXEC) != 0)
		{
			Fail("no pipe");
		}
		Process = Start(Arguments, Pipe[1]);
		close(Pipe[1]);
		Errors = fdopen(Pipe[0], "r");
		WaitForRun();
	}
	~FWatch()
	{
		kill(Process, SIGTERM);
		waitpid(Process, nullptr, 0);
		std::fclose(Errors);
	}
	FWatch(const FWatch&) = delete;
	FWatch& operator=(const FWatch&) = delete;

	/** From the edit to the picture; looking for the edit is part of it. */
	template<typename FEdit>
	FCost Measure(FEdit Edit)
	{
		const double Cpu = ReadCpuMs(Process);
		const double Begin = Now();
		Edit();
		WaitForRun();
		return {ReadCpuMs(Process) - Cpu, Now() - Begin};
	}

private:
	void WaitForRun()
	{
		char Line[4096];
		while (std::fgets(Line, sizeof(Line), Errors))
		{
			const std::string Text = Line;
			if (Text.starts_with("watching"))
			{
				return;
			}
			if (Text.find("error") != std::string::npos)
			{
				Fail(Text);
			}
		}
		Fail("the watch has ended");
	}

	pid_t Process = 0;
	std::FILE* Errors = nullptr;
};

struct FRow
{
	std::string Name;
	std::vector<FCost> Costs = {};

	double GetMedian(double FCost::*Member) const
	{
		std::vector<double> Values;
		for (const FCost& Cost : Costs)
		{
			Values.push_back(Cost.*Member);
		}
		const auto Middle = Values.begin() + static_cast<std::ptrdiff_t>(Values.size() / 2);
		std::nth_element(Values.begin(), Middle, Values.end());
		return *Middle;
	}
};

/** The compiler as drydock calls it for the kernel of an edit: its command, and the command for the kernel's headers
 * alone, which are precompiled as there. Edits twice: the first kernel has no precompiled headers. */
struct FKernelCommands
{
	template<typename FEdit>
	FKernelCommands(const fs::path& Folder, FEdit EditAndRun)
	{
		fs::create_directories(Folder);
		const std::string Compiler = (Folder / "compiler").string();
		std::ofstream(Compiler) << "#!/bin/sh\n"
								   "for Argument; do\n"
								   "	case $Argument in */kernel.cpp)\n"
								   "		cp ${Argument%kernel.cpp}* "
								<< Folder.string() << "/ 2>/dev/null; printf '%s\\n' \"$@\" >" << Folder.string()
								<< "/arguments;;\n"
								   "	esac\n"
								   "done\n"
								   "exec g++ \"$@\"\n";
		fs::permissions(Compiler, fs::perms::owner_all);
		setenv("DRYDOCK_CXX", Compiler.c_str(), 1);
		EditAndRun();
		EditAndRun();
		unsetenv("DRYDOCK_CXX");
		std::ofstream(Folder / "nothing.cpp") << "#include \"KernelSupport.h\"\n";
		std::ifstream Arguments(Folder / "arguments");
		Kernel = Nothing = {"g++"};
		for (std::string Argument; std::getline(Arguments, Argument);)
		{
			const std::string Name = fs::path(Argument).filename().string();
			const bool bKernel = Name == "kernel.cpp";
			const bool bOutput = Name == "kernel.so";
			Kernel.push_back(bKernel || bOutput ? (Folder / Name).string() : Argument);
			Nothing.push_back(bKernel ? (Folder / "nothing.cpp").string() : Kernel.back());
		}
	}

	std::vector<std::string> Kernel;
	std::vector<std::string> Nothing;
};

/** What ninja runs in Folder for the object of Source, with another source in its place. */
std::vector<std::string> GetCompileCommand(const fs::path& Folder, const fs::path& Source, const fs::path& Instead)
{
	std::FILE* const Pipe = popen(("ninja -C " + Folder.string() + " -t commands").c_str(), "r");
	std::string Found;
	char Part[65536];
	while (Pipe && std::fgets(Part, sizeof(Part), Pipe))
	{
		const std::string Line = Part;
		const size_t At = Line.find(" -c " + Source.string());
		Found = At == std::string::npos ? Found : Line.substr(0, At) + " -c " + Instead.string();
	}
	if (!Pipe || pclose(Pipe) != 0 || Found.empty())
	{
		Fail("ninja does not tell how " + Source.string() + " is compiled");
	}
	return {"sh", "-c", "cd " + Folder.string() + " && " + Found};
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	const int Rounds = ArgumentCount > 1 ? std::max(1, std::atoi(Arguments[1])) : 9;
	const std::string Scene = ArgumentCount > 2 ? fs::absolute(Arguments[2]).string()
												: DRYDOCK_BENCH_SOURCE_DIR "/configs/scenes/toon_character.exr";
	const std::string Program = DRYDOCK_BENCH_BINARY_DIR "/bin/drydock";
	const fs::path Folder = fs::temp_directory_path() / ("drydock_bench_edit_" + std::to_string(getpid()));
	fs::create_directories(Folder);
	setenv("DRYDOCK_CACHE_DIR", (Folder / "cache").c_str(), 1);
	const std::string Patch = (Folder / "Patch").string();
	const std::vector<std::string> Build = {Program, "build", Patch, "--out", (Folder / "build").string()};
	Run({Program, "new", "Patch", "--dir", Folder.string()});
	const FCost FirstBuild = Run(Build);
	const std::string Config = (Folder / "patch.json").string();
	std::ofstream(Config) << R"({"engine": "5.4", "scene": {"file": ")" << Scene << R"("}, "plugins": [")"
						  << (Folder / "build/cmake/libPatch.so").string()
						  << R"("], "cvars": {"r.Patch.Intensity": 0.8}})";
	const fs::path Shader = fs::path(Patch) / "Shaders/Private/Patch.usf";
	const std::string ShaderText = ReadText(Shader);
	const std::string Begin = "float Weight = ";
	const size_t Place = ShaderText.find(Begin);
	if (Place == std::string::npos)
	{
		Fail("the shader of the patch is not the one that is edited here");
	}
	int NumEdits = 0;
	const auto Edit = [&]
	{
		std::string Text = ShaderText;
		Text.insert(Place + Begin.size(), std::to_string(++NumEdits) + "e-6 + ");
		ReplaceText(Shader, Text);
	};
	const fs::path Source = fs::path(Patch) / "Source/Patch/Private/PatchViewExtension.cpp";
	const std::vector<std::string> RunOnce = {
		Program, "run", Config, "--out", (Folder / "once").string(), "--report", "off"};
	std::vector<FRow> Rows = {{"a shader, `run --watch`"}, {"a shader, `run`"}, {"nothing, `run`"},
		{"a patch's C++, `drydock build`"}, {"of a shader: `g++`, its kernel"},
		{"the least of that: `g++`, no kernel, precompiled headers"}, {"of a patch's C++: `c++`, its file"},
		{"the least of that: `c++`, no code, precompiled headers"}};
	const auto WatchEdit = [&]
	{
		FWatch Watch({Program, "run", Config, "--out", (Folder / "watch").string(), "--watch"});
		Watch.Measure(Edit); // starts what is kept from then on
		return Watch.Measure(Edit);
	};
	Run(RunOnce);
	const FKernelCommands KernelCommands(Folder / "kernel",
		[&]
		{
			Edit();
			Run(RunOnce);
		});
	const fs::path NoCode = Folder / "nothing.cpp";
	std::ofstream(NoCode) << "\n";
	const fs::path BuildFolder = Folder / "build/cmake";
	for (int Round = 0; Round < Rounds; ++Round)
	{
		Rows[0].Costs.push_back(WatchEdit());
		Edit();
		Rows[1].Costs.push_back(Run(RunOnce));
		Rows[2].Costs.push_back(Run(RunOnce));
		std::ofstream(Source, std::ios::app) << "// edit " << Round << "\n";
		Rows[3].Costs.push_back(Run(Build));
		Rows[4].Costs.push_back(Run(KernelCommands.Kernel));
		Rows[5].Costs.push_back(Run(KernelCommands.Nothing));
		Rows[6].Costs.push_back(Run(GetCompileCommand(BuildFolder, Source, Source)));
		Rows[7].Costs.push_back(Run(GetCompileCommand(BuildFolder, Source, NoCode)));
	}
	std::printf("%s, medians of %d\n\n| edited | CPU ms | wall ms |\n|---|--:|--:|\n",
		fs::path(Scene).filename().c_str(), Rounds);
	for (const FRow& Row : Rows)
	{
		std::printf(
			"| %s | %.0f | %.0f |\n", Row.Name.c_str(), Row.GetMedian(&FCost::CpuMs), Row.GetMedian(&FCost::WallMs));
	}
	std::printf("\nThe patch's first build takes %.0f ms of CPU time.\n", FirstBuild.CpuMs);
	fs::remove_all(Folder);
}
