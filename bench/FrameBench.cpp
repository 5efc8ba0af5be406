// What a 1920x1080 frame with default bloom and tonemap costs, pass by pass, in units of a plain copy of its scene
// colour (RGBA16F, one thread) made in the same process. Frames and copies alternate; medians of 7.
#include "Run/Run.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>
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

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	const std::string Scene =
		ArgumentCount > 1 ? Arguments[1] : DRYDOCK_BENCH_SOURCE_DIR "/configs/scenes/toon_character_1080p.exr";
	Drydock::FRunOptions Options;
	Options.ConfigFile = "bench.json";
	Options.ConfigText = "{ \"scene\": { \"file\": \"" + Scene + "\" } }";

	const std::vector<unsigned char> Source(size_t(1920) * 1080 * 8, 1);
	std::vector<unsigned char> Dest(Source.size(), 2);
	std::vector<double> CopyMs;
	std::vector<double> FrameMs;
	std::vector<std::vector<double>> PassMs;
	Drydock::FRunResult Result = Drydock::RunConfig(Options);
	PassMs.resize(Result.Passes.size());
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
	std::printf("%dx%d, %d threads, %s, medians of %d\n", Result.SceneExtent.X, Result.SceneExtent.Y, Result.Threads,
		Result.Precision.c_str(), GRepetitions);
	std::printf("%9s %9s  pass\n", "ms", "copies");
	for (size_t Pass = 0; Pass < Result.Passes.size(); ++Pass)
	{
		const double Ms = Median(PassMs[Pass]);
		std::printf("%9.3f %9.2f  %s\n", Ms, Ms / Copy,
			Result.Graph.Passes[static_cast<size_t>(Result.Passes[Pass].Index)].Name.c_str());
	}
	std::printf("%9.3f %9.2f  all passes\n", Median(FrameMs), Median(FrameMs) / Copy);
	std::printf("%9.3f %9.2f  plain copy of the scene colour\n", Copy, 1.0);
	return 0;
}
