// What frames of 1920x1080 cost, pass by pass, in units of a plain copy of their scene colour (RGBA16F, one thread)
// made in the same process: default bloom and tonemap on all threads, and configs/frame_full.json, which has everything
// on, on one; then temporal antialiasing with a history, on all. Frames and copies alternate; medians of 7. Prints
// tables in Markdown.
//
//     bench_frame [SCENE.exr]
#include "Run/Run.h"
#include "Scenes/JitteredScenes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace
{

constexpr int GRepetitions = 7;

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + static_cast<long>(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

double TimeCopy(const std::vector<unsigned char>& Source, std::vector<unsigned char>& Dest)
{
	const auto Start = std::chrono::steady_clock::now();
	std::memcpy(Dest.data(), Source.data(), Source.size());
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count();
}

/** The config with its scene replaced. */
std::string ReadConfig(const std::string& File, const std::string& Scene)
{
	std::ifstream Stream(File);
	std::string Text{std::istreambuf_iterator<char>(Stream), std::istreambuf_iterator<char>()};
	const size_t Key = Text.find("\"file\": \"");
	const size_t Begin = Text.find('"', Key + 8) + 1;
	return Text.replace(Begin, Text.find('"', Begin) - Begin, Scene);
}

void PrintFrame(const char* Name, const Drydock::FRunOptions& Options)
{
	const std::vector<unsigned char> Source(size_t(1920) * 1080 * 8, 1);
	std::vector<unsigned char> Dest(Source.size(), 2);
	std::vector<double> CopyMs;
	std::vector<double> FrameMs;
	Drydock::FRunResult Result = Drydock::RunConfig(Options);
	std::vector<std::vector<double>> PassMs(Result.Passes.size());
	TimeCopy(Source, Dest);
	for (int Repetition = 0; Repetition < GRepetitions; ++Repetition)
	{
		Result = Drydock::RunConfig(Options);
		double Sum = 0.0;
		for (size_t Pass = 0; Pass < Result.Passes.size(); ++Pass)
		{
			PassMs[Pass].push_back(Result.Passes[Pass].Milliseconds);
			Sum += Result.Passes[Pass].Milliseconds;
		}
		FrameMs.push_back(Sum);
		CopyMs.push_back(TimeCopy(Source, Dest));
	}

	const double Copy = Median(CopyMs);
	std::printf("\n| %s, %dx%d, %d threads, medians of %d | ms | copies |\n|---|--:|--:|\n", Name, Result.SceneExtent.X,
		Result.SceneExtent.Y, Result.Threads, GRepetitions);
	for (size_t Pass = 0; Pass < Result.Passes.size(); ++Pass)
	{
		const double Ms = Median(PassMs[Pass]);
		std::printf("| %s | %.3f | %.2f |\n",
			Result.Graph.Passes[static_cast<size_t>(Result.Passes[Pass].Index)].Name.c_str(), Ms, Ms / Copy);
	}
	std::printf("| all passes | %.3f | %.2f |\n", Median(FrameMs), Median(FrameMs) / Copy);
	std::printf("| plain copy of the scene colour | %.3f | %.2f |\n", Copy, 1.0);
}

/** What it costs to follow texels that nothing wrote: frames with and without it, in turn. */
void PrintFollowing(Drydock::FRunOptions Options)
{
	constexpr int NumRounds = 31;
	std::vector<double> FrameMs[2];
	for (int Round = 0; Round < 2 * NumRounds + 2; ++Round)
	{
		Options.bFollowUnwritten = Round % 2 != 0;
		const auto Start = std::chrono::steady_clock::now();
		const Drydock::FRunResult Result = Drydock::RunConfig(Options);
		const std::chrono::duration<double, std::milli> Whole = std::chrono::steady_clock::now() - Start;
		if (Round >= 2) // the first of each are warm-ups
		{
			FrameMs[Round % 2].push_back(Whole.count() - Result.Times.Load);
		}
	}
	const double Without = Median(FrameMs[0]), With = Median(FrameMs[1]);
	std::printf(
		"\nfollowing unwritten texels: %.3f ms without, %.3f ms with, %+.2f %% (medians of %d frames in turn)\n",
		Without, With, 100.0 * (With / Without - 1.0), NumRounds);
}

/** The pass of temporal antialiasing in the second frame of a turning line. */
void PrintTemporalAA()
{
	namespace Files = std::filesystem;
	const Files::path Folder = Files::temp_directory_path() / "drydock_bench_frame";
	Files::create_directories(Folder);
	Drydock::FJitteredSceneOptions Scene;
	Scene.Scene = &Drydock::GetJitteredScenes().front();
	Scene.Size = FIntPoint(1920, 1080);
	Scene.NumFrames = 2;
	Drydock::WriteJitteredScene(Scene, Folder.string());
	Drydock::FRunOptions Options;
	Options.ConfigFile = (Folder / "line.json").string();
	Options.Frame = 1;
	const std::vector<unsigned char> Source(size_t(1920) * 1080 * 8, 1);
	std::vector<unsigned char> Dest(Source.size(), 2);
	std::vector<double> PassMs;
	std::vector<double> CopyMs;
	{
		Drydock::FRunSession Session(Options);
		const std::vector<Drydock::FViewHistory> Last = Session.Run(1, {}).ViewStates;
		TimeCopy(Source, Dest);
		for (int Repetition = 0; Repetition <= GRepetitions; ++Repetition)
		{
			const Drydock::FRunResult Result = Session.Run(2, Last);
			for (const Drydock::FRunPass& Pass : Result.Passes)
			{
				const std::string& Effect = Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Effect;
				if (Repetition > 0 && Effect == "TemporalAA") // the first is a warm-up
				{
					PassMs.push_back(Pass.Milliseconds);
				}
			}
			CopyMs.push_back(TimeCopy(Source, Dest));
		}
	}
	Files::remove_all(Folder);
	std::printf("\ntemporal antialiasing, 1920x1080, all threads: %.3f ms, %.2f copies (medians of %d)\n",
		Median(PassMs), Median(PassMs) / Median(CopyMs), GRepetitions);
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	const std::string Scene = ArgumentCount > 1 ? std::filesystem::absolute(Arguments[1]).string()
												: DRYDOCK_BENCH_SOURCE_DIR "/configs/scenes/toon_character_1080p.exr";
	Drydock::FRunOptions Options;
	Options.ConfigFile = "bench.json";
	Options.ConfigText = "{ \"scene\": { \"file\": \"" + Scene + "\" } }";
	PrintFrame("bloom and tonemap", Options);
	Options.ConfigFile = DRYDOCK_BENCH_SOURCE_DIR "/configs/frame_full.json";
	Options.ConfigText = ReadConfig(Options.ConfigFile, Scene);
	Options.Threads = 1;
	PrintFrame("frame_full", Options);
	PrintFollowing(Options);
	PrintTemporalAA();
	return 0;
}
