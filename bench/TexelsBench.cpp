// What a kernel's texels cost: samples, gathers, loads and stores by format and by where the lanes lie, on the widest
// float lanes of the CPU, in the cache. Prints nanoseconds per 16 lanes as a table in Markdown: medians of rounds in
// which every cell is measured once, so that all see the same state of the machine. Then which cells take long beside
// their neighbours: an operation is compared over the formats, and with the operation that it is a little more than.
//
//     bench_texels [ROUNDS] [FORMAT...]
#include "LanesDispatch.h"
#include "LanesResources.h"
#include "PixelFormatConversion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace Drydock::Bench
{
namespace
{

constexpr int32_t GSizeX = 512;
constexpr int32_t GSizeY = 32;
constexpr int32_t GVolume = 32;

/** Packs of one measurement, and how often they are run in it. */
constexpr int GNumPacks = 96;
constexpr int GRepetitions = 8;

/** Random texels as the library lays them out. */
class FPicture
{
public:
	FPicture(ETexelStorage Storage, int32_t SizeX, int32_t SizeY, int32_t SizeZ)
	{
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		Mip = {nullptr, SizeX, SizeY, SizeZ, (SizeX * Bytes + 63) / 64 * 64, 0};
		Mip.SlicePitch = int64_t(Mip.RowPitch) * SizeY;
		Memory.resize(size_t(Mip.SlicePitch * SizeZ) + 192);
		const size_t Misplaced = reinterpret_cast<uintptr_t>(Memory.data()) % 64;
		Mip.Data = Memory.data() + 128 - Misplaced;
		Texture = {&Mip, 1, Storage, uint8_t(SizeZ > 1), 0};
		std::mt19937 Engine(1);
		std::uniform_real_distribution<float> Value(0, 1);
		for (int32_t Row = 0; Row < SizeY * SizeZ; ++Row)
		{
			for (int32_t X = 0; X < SizeX; ++X)
			{
				const float RGBA[4] = {Value(Engine), Value(Engine), Value(Engine), 0.5f};
				EncodeTexel(Storage, RGBA, Mip.Data + int64_t(Row) * Mip.RowPitch + int64_t(X) * Bytes);
			}
		}
	}
	FPicture(const FPicture&) = delete;
	FPicture& operator=(const FPicture&) = delete;

	FKernelTexture Texture;

private:
	FKernelMip Mip;
	std::vector<uint8_t> Memory;
};

double ThreadSeconds()
{
	timespec Time;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &Time);
	return double(Time.tv_sec) + 1e-9 * double(Time.tv_nsec);
}

FKernelSampler MakeSampler(EKernelAddress Address)
{
	return {EKernelFilter::Bilinear, Address, Address, Address, 8, 0, {0, 0, 0, 0}};
}

/** Coordinates of packs; where the lanes lie is in texels. */
template<int N>
struct TCoordinates
{
	alignas(64) float U[GNumPacks][N];
	alignas(64) float V[GNumPacks][N];
	alignas(64) float W[GNumPacks][N];
	alignas(64) int32_t X[GNumPacks][N];
	alignas(64) int32_t Y[GNumPacks][N];

	template<typename F>
	void Fill(F Place)
	{
		std::mt19937 Engine(2);
		std::uniform_real_distribution<float> Unit(0.02f, 0.98f);
		for (int Pack = 0; Pack < GNumPacks; ++Pack)
		{
			for (int Lane = 0; Lane < N; ++Lane)
			{
				const float Column = float((Pack % 8) * N + Lane);
				const float Row = float(Pack / 8);
				const auto [Left, Top] = Place(Column, Row, Unit(Engine), Unit(Engine));
				U[Pack][Lane] = Left / GSizeX;
				V[Pack][Lane] = Top / GSizeY;
				W[Pack][Lane] = Unit(Engine);
				X[Pack][Lane] = int32_t(std::floor(Left));
				Y[Pack][Lane] = int32_t(std::floor(Top));
			}
		}
	}
};

struct FPlace
{
	float X;
	float Y;
};

/** Every operation on one format. Run(i) does operation i once for all packs. */
template<int N>
class TOperations
{
	using FSampling = Lanes::TSampling<float, N>;

public:
	explicit TOperations(ETexelStorage Storage)
		: Flat(Storage, GSizeX, GSizeY, 1)
		, Layered(Storage, GSizeX, GSizeY, 2)
		, Deep(Storage, GVolume, GVolume, GVolume)
		, Output(Storage, GSizeX, GSizeY, 1)
	{
		Straight.Fill([](float X, float Y, float, float) { return FPlace{X + 0.5f, Y + 0.5f}; });
		Half.Fill([](float X, float Y, float, float) { return FPlace{X + 1, Y + 1}; });
		Twice.Fill([](float X, float Y, float, float) { return FPlace{2 * X + 1, 2 * Y + 1}; });
		Up.Fill([](float X, float Y, float, float) { return FPlace{X / 2 + 0.25f, Y / 2 + 0.25f}; });
		Scattered.Fill([](float, float, float A, float B) { return FPlace{A * GSizeX, B * GSizeY}; });
		Edge.Fill([](float X, float Y, float, float) { return FPlace{std::fmod(X, float(N)) - N / 2 + 0.3f, Y + 1}; });
		for (int Lane = 0; Lane < N; ++Lane)
		{
			On[Lane] = -1;
			Checkered[Lane] = -(Lane & 1);
			Layers[Lane] = float(Lane & 1);
		}
		std::fill_n(Values, 4 * N, 0.3f);
	}

	static const std::vector<const char*>& GetNames()
	{
		static const std::vector<const char*> Names = {"1:1", "bilinear", "2:1", "up 2x", "scattered", "edge, clamp",
			"edge, border", "edge, wrap", "layers", "3D", "gather", "load row", "load scattered", "store",
			"store masked", "store scattered", "target blended", "target RGB only"};
		return Names;
	}
	/** The operation that each is a little more than. */
	static size_t GetNeighbour(size_t Operation)
	{
		constexpr size_t Neighbours[] = {0, 0, 1, 1, 1, 1, 5, 5, 4, 8, 1, 0, 11, 11, 13, 14, 14, 16};
		return Neighbours[Operation];
	}

	void Run(size_t Operation)
	{
		const FKernelSampler Clamp = MakeSampler(EKernelAddress::Clamp);
		switch (Operation)
		{
		case 0:
			return Sample(Straight, Clamp);
		case 1:
			return Sample(Half, Clamp);
		case 2:
			return Sample(Twice, Clamp);
		case 3:
			return Sample(Up, Clamp);
		case 4:
			return Sample(Scattered, Clamp);
		case 5:
			return Sample(Edge, Clamp);
		case 6:
			return Sample(Edge, MakeSampler(EKernelAddress::Border));
		case 7:
			return Sample(Edge, MakeSampler(EKernelAddress::Wrap));
		case 8:
			return ForEachPack([&](int P)
				{ FSampling::Sample2D(Layered.Texture, Clamp, Half.U[P], Half.V[P], Layers, &Level, true, Out); });
		case 9:
			return ForEachPack(
				[&](int P) {
					FSampling::Sample3D(
						Deep.Texture, Clamp, Scattered.U[P], Scattered.V[P], Scattered.W[P], &Level, true, Out);
				});
		case 10:
			return ForEachPack(
				[&](int P) {
					FSampling::Gather(Flat.Texture, Clamp, {{Half.U[P], Half.V[P]}}, 0, Out);
				});
		case 11:
			return Load(Straight);
		case 12:
			return Load(Scattered);
		case 13:
			return Store(Straight, On);
		case 14:
			return Store(Straight, Checkered);
		case 15:
			return Store(Scattered, On);
		case 16:
			return Blend(15, true);
		default:
			return Blend(7, false);
		}
	}

private:
	template<typename F>
	void ForEachPack(F f)
	{
		for (int Pack = 0; Pack < GNumPacks; ++Pack)
		{
			f(Pack);
			asm volatile("" : : "r"(Out) : "memory");
		}
	}
	void Sample(const TCoordinates<N>& At, const FKernelSampler& Sampler)
	{
		ForEachPack(
			[&](int P) { FSampling::Sample2D(Flat.Texture, Sampler, At.U[P], At.V[P], nullptr, &Level, true, Out); });
	}
	void Load(const TCoordinates<N>& At)
	{
		ForEachPack([&](int P) { FSampling::Load(Flat.Texture, At.X[P], At.Y[P], nullptr, &Mip, true, Out); });
	}
	void Store(const TCoordinates<N>& At, const int32_t* Mask)
	{
		ForEachPack([&](int P) { FSampling::Store(Output.Texture, Mask, At.X[P], At.Y[P], nullptr, Values); });
	}
	void Blend(uint8_t WriteMask, bool bBlend)
	{
		const FKernelTarget Target = {Output.Texture, WriteMask, bBlend, EKernelBlendOp::Add,
			EKernelBlendFactor::SourceAlpha, EKernelBlendFactor::InverseSourceAlpha, EKernelBlendOp::Add,
			EKernelBlendFactor::One, EKernelBlendFactor::Zero};
		ForEachPack([&](int P) { FSampling::StoreTarget(Target, On, Straight.X[P][0], Straight.Y[P][0], Values); });
	}

	FPicture Flat;
	FPicture Layered;
	FPicture Deep;
	FPicture Output;
	TCoordinates<N> Straight, Half, Twice, Up, Scattered, Edge;
	alignas(64) int32_t On[N];
	alignas(64) int32_t Checkered[N];
	alignas(64) float Layers[N];
	alignas(64) float Values[4 * N];
	alignas(64) float Out[4 * N];
	float Level = 0;
	int32_t Mip = 0;
};

double Median(std::vector<double>& Values)
{
	std::nth_element(Values.begin(), Values.begin() + long(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

/** A cell that takes long beside others: the same operation on other formats, or its neighbour on the same format. */
struct FOutlier
{
	double Ratio = 0.0;
	std::string What;
};

/** Cells by rows of formats. */
template<int N>
void PrintSummary(const std::vector<std::string>& Formats, const std::vector<double>& Cells)
{
	constexpr double Cliff = 4.0;
	const auto& Operations = TOperations<N>::GetNames();
	const size_t NumColumns = Operations.size();
	FOutlier ByFormat;
	FOutlier ByOperation;
	std::vector<FOutlier> Cliffs;
	const auto Note = [&](FOutlier& Furthest, double Ratio, const std::string& What)
	{
		if (Ratio > Furthest.Ratio)
		{
			Furthest = {Ratio, What};
		}
		if (Ratio > Cliff)
		{
			Cliffs.push_back({Ratio, What});
		}
	};
	for (size_t Column = 0; Column < NumColumns; ++Column)
	{
		std::vector<double> OfFormats;
		for (size_t Row = 0; Row < Formats.size(); ++Row)
		{
			OfFormats.push_back(Cells[Row * NumColumns + Column]);
		}
		const double Middle = Median(OfFormats);
		const size_t Neighbour = TOperations<N>::GetNeighbour(Column);
		for (size_t Row = 0; Row < Formats.size(); ++Row)
		{
			const double Cell = Cells[Row * NumColumns + Column];
			const std::string What = std::string(Operations[Column]) + " of " + Formats[Row];
			Note(ByFormat, Cell / Middle, What);
			Note(ByOperation, Cell / Cells[Row * NumColumns + Neighbour], What + " over " + Operations[Neighbour]);
		}
	}
	std::printf(
		"\nFurthest from the median of all formats: %s, %.1f times. Furthest from its neighbouring operation: %s, "
		"%.1f times. Above %.0f times: %s.\n",
		ByFormat.What.c_str(), ByFormat.Ratio, ByOperation.What.c_str(), ByOperation.Ratio, Cliff,
		Cliffs.empty() ? "nothing" : (std::to_string(Cliffs.size()) + " cells").c_str());
	for (const FOutlier& Outlier : Cliffs)
	{
		std::printf("- %s: %.1f\n", Outlier.What.c_str(), Outlier.Ratio);
	}
}

template<int N>
void PrintTable(int Rounds, const std::vector<std::string>& Formats)
{
	using FOperations = TOperations<N>;
	std::vector<std::unique_ptr<FOperations>> Rows;
	std::vector<std::string> Names;
	for (int Index = 0; Index < int(ETexelStorage::Count); ++Index)
	{
		const FTexelStorageInfo& Info = GetTexelStorageInfo(ETexelStorage(Index));
		const bool bWanted = Formats.empty() ? Info.Kind != ETexelKind::Uint && Info.BitsPerChannel <= 32
											 : std::find(Formats.begin(), Formats.end(), Info.Name) != Formats.end();
		if (bWanted)
		{
			Rows.push_back(std::make_unique<FOperations>(ETexelStorage(Index)));
			Names.push_back(Info.Name);
		}
	}
	const size_t NumColumns = FOperations::GetNames().size();
	std::vector<std::vector<double>> Times(Rows.size() * NumColumns);
	for (int Round = 0; Round < Rounds; ++Round)
	{
		for (size_t Cell = 0; Cell < Times.size(); ++Cell)
		{
			FOperations& Row = *Rows[Cell / NumColumns];
			Row.Run(Cell % NumColumns); // brings code and texels into the cache
			const double Begin = ThreadSeconds();
			for (int Repetition = 0; Repetition < GRepetitions; ++Repetition)
			{
				Row.Run(Cell % NumColumns);
			}
			const double Nanoseconds = (ThreadSeconds() - Begin) * 1e9;
			Times[Cell].push_back(Nanoseconds / (GRepetitions * GNumPacks) * 16 / N);
		}
	}
	std::string Rule = "|---|";
	std::printf("| ns per 16 texels, %d lanes |", N);
	for (const char* Name : FOperations::GetNames())
	{
		std::printf(" %s |", Name);
		Rule += "---:|";
	}
	std::printf("\n%s\n", Rule.c_str());
	std::vector<double> Cells;
	for (size_t Row = 0; Row < Rows.size(); ++Row)
	{
		std::printf("| %s |", Names[Row].c_str());
		for (size_t Column = 0; Column < NumColumns; ++Column)
		{
			Cells.push_back(Median(Times[Row * NumColumns + Column]));
			std::printf(" %.0f |", Cells.back());
		}
		std::printf("\n");
	}
	PrintSummary<N>(Names, Cells);
}

} // namespace
} // namespace Drydock::Bench

int main(int ArgumentCount, char** Arguments)
{
	using namespace Drydock;
	const int Rounds = ArgumentCount > 1 ? std::max(1, std::atoi(Arguments[1])) : 31;
	const std::vector<std::string> Formats(Arguments + std::min(ArgumentCount, 2), Arguments + ArgumentCount);
	// As kernels run: denormals are zero.
	__builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);
	switch (GetWidestLanes(false))
	{
	case 16:
		Bench::PrintTable<16>(Rounds, Formats);
		break;
	case 8:
		Bench::PrintTable<8>(Rounds, Formats);
		break;
	default:
		Bench::PrintTable<4>(Rounds, Formats);
		break;
	}
	return 0;
}
