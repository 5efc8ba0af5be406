// From an edit to the bytes of its picture: `drydock live` by itself, asked over one connection as its page asks, while
// a hand drags one value. Beside it stand the frame's own passes. Medians and 95th percentiles in milliseconds, by the
// clock: an idle machine. Prints a table in Markdown.
//
//     bench_live [EDITS]
#include "tests/pipeline/Live/LiveConnection.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <signal.h>
#include <sys/wait.h>
#include <vector>

namespace
{

using namespace LiveTest;
namespace fs = std::filesystem;

struct FTimes
{
	std::vector<double> Whole;
	std::vector<double> Passes;
};

[[noreturn]] void Fail(const std::string& What)
{
	std::fprintf(stderr, "bench_live: %s\n", What.c_str());
	std::exit(1);
}

double GetPart(std::vector<double> Values, double Part)
{
	std::ranges::sort(Values);
	return Values[static_cast<size_t>(static_cast<double>(Values.size() - 1) * Part)];
}

/** The program, its first line read: "live     http://127.0.0.1:8123/?token=...". */
FILE* Start(const std::string& Config)
{
	return popen(("exec " DRYDOCK_BENCH_BINARY_DIR "/bin/drydock live --no-open '" + Config + "'").c_str(), "r");
}

std::string MakeRequest(const std::string& Method, const std::string& Path, int Port, const std::string& Token,
	const std::string& Body = "")
{
	return Method + " " + Path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(Port) +
		   "\r\nX-Drydock-Token: " + Token +
		   (Body.empty() ? ""
						 : "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(Body.size())) +
		   "\r\n\r\n" + Body;
}

/** The next frame of the stream: its JSON. */
FJson ReadFrame(FConnection& Events)
{
	Events.ReadUntil("event: frame\n");
	std::string Text = Events.ReadUntil("\n\n");
	std::string Json;
	for (size_t At = 0; Text.compare(At, 6, "data: ") == 0;)
	{
		const size_t End = Text.find('\n', At);
		Json += Text.substr(At + 6, End - At - 5);
		At = End + 1;
	}
	return FJson::parse(Json);
}

FTimes Measure(const std::string& Config, const std::string& Place, int NumEdits)
{
	FILE* const Program = Start(Config);
	char Line[200] = {};
	int Port = 0;
	char Token[100] = {};
	if (std::fgets(Line, sizeof(Line), Program) == nullptr ||
		std::sscanf(Line, "live http://127.0.0.1:%d/?token=%99s", &Port, Token) != 2)
	{
		Fail("drydock live does not start");
	}
	FConnection Events(Port);
	Events.Send(MakeRequest("GET", std::string("/api/events?token=") + Token, Port, Token));
	Events.ReadAnswer();
	FConnection Page(Port);
	FTimes Times;
	for (int Edit = -10; Edit < NumEdits; ++Edit) // the first ones warm up
	{
		const FJson Body = {{"edits", {{{"set", Place}, {"value", 1.0 + 0.01 * (Edit + 10)}}}}, {"drag", "d"}};
		const auto Begin = std::chrono::steady_clock::now();
		Page.Send(MakeRequest("POST", "/api/edit", Port, Token, Body.dump()));
		const FJson Revision = Page.ReadAnswer().Json()["revision"];
		FJson Frame = ReadFrame(Events);
		while (Frame["revision"] < Revision)
		{
			Frame = ReadFrame(Events);
		}
		Page.Send(MakeRequest("GET", "/api/picture/" + Revision.dump() + "?kind=final8", Port, Token));
		if (Page.ReadAnswer().Status != 200)
		{
			Fail("there is no picture");
		}
		const std::chrono::duration<double, std::milli> Whole = std::chrono::steady_clock::now() - Begin;
		if (Edit >= 0)
		{
			Times.Whole.push_back(Whole.count());
			Times.Passes.push_back(Frame["milliseconds"]["passes"]);
		}
	}
	Page.Send(MakeRequest("POST", "/api/end", Port, Token));
	Page.ReadAnswer();
	pclose(Program);
	return Times;
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	const int NumEdits = ArgumentCount > 1 ? std::max(std::atoi(Arguments[1]), 1) : 200;
	const fs::path Folder = fs::temp_directory_path() / ("drydock_bench_live." + std::to_string(getpid()));
	fs::create_directories(Folder);
	std::printf("| frame | dragged | median ms | 95th percentile | its passes, median | beside the passes |\n"
				"|---|---|--:|--:|--:|--:|\n");
	for (const auto& [Size, Scene] :
		{std::pair("960 x 540", "toon_character"), std::pair("1920 x 1080", "toon_character_1080p")})
	{
		const std::string Config = (Folder / (std::string(Scene) + ".json")).string();
		std::ofstream(Config) << R"({"scene": {"file": ")" << DRYDOCK_BENCH_SOURCE_DIR "/configs/scenes/" << Scene
							  << R"(.exr"}, "volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 1.5,
				"BloomToonIntensity": 0.1}}]})";
		for (const char* const Setting : {"BloomToonIntensity", "FilmSlope"})
		{
			const FTimes Times = Measure(Config, std::string("/camera/Settings/") + Setting, NumEdits);
			std::vector<double> Beside;
			for (size_t Index = 0; Index < Times.Whole.size(); ++Index)
			{
				Beside.push_back(Times.Whole[Index] - Times.Passes[Index]);
			}
			std::printf("| %s | %s | %.1f | %.1f | %.1f | %.1f |\n", Size, Setting, GetPart(Times.Whole, 0.5),
				GetPart(Times.Whole, 0.95), GetPart(Times.Passes, 0.5), GetPart(Beside, 0.5));
			std::fflush(stdout);
		}
	}
	fs::remove_all(Folder);
}
