// What blending costs: volumes that each override every field, all of them reaching the view. Sizes take turns, small
// ones several times in a row; medians of 15. Linear growth shows as a ratio of 2 from row to row.
#include "BlendSettings.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace
{

using namespace Drydock;

constexpr int GRepetitions = 15;
constexpr int GSizes[] = {125, 250, 500, 1000};

/** Bounded and unbound ones in turn, every priority once. */
FBlendInputs MakeInputs(int NumVolumes)
{
	FBlendInputs Inputs;
	for (int Index = 0; Index < NumVolumes; ++Index)
	{
		APostProcessVolume Volume;
		Volume.Name = "volume";
		Volume.Priority = static_cast<float>((Index * 7919) % NumVolumes);
		Volume.BlendWeight = 0.5f;
		Volume.bUnbound = Index % 2 == 0;
		Volume.Shape = FVolumeShape::MakeBox(FVector(Index, 0, 0), FVector(10, 10, 10), FRotator(0, Index, 0));
		Volume.BlendRadius = 1e6f;
		for (const FSettingField& Field : GetSettingFields())
		{
			Field.SetOverridden(Volume.Settings, true);
		}
		Inputs.Volumes.push_back(Volume);
	}
	return Inputs;
}

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + static_cast<long>(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

/** Per call. */
template<typename TFunction>
double TimeMs(int NumCalls, const TFunction& Function)
{
	const auto Start = std::chrono::steady_clock::now();
	for (int Call = 0; Call < NumCalls; ++Call)
	{
		Function();
	}
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count() / NumCalls;
}

struct FRow
{
	std::vector<double> Prepare;
	std::vector<double> Blend;
	std::vector<double> Record;
};

} // namespace

int main()
{
	std::vector<FBlendInputs> Inputs;
	std::vector<FSettingsBlender> Blenders;
	for (const int Size : GSizes)
	{
		Inputs.push_back(MakeInputs(Size));
		Blenders.emplace_back(Inputs.back());
	}
	const FVector Location(5, 5, 500);
	std::vector<FRow> Rows(std::size(GSizes));
	float Sum = 0.0f;
	for (int Repetition = 0; Repetition < GRepetitions; ++Repetition)
	{
		for (size_t Index = 0; Index < Rows.size(); ++Index)
		{
			const int NumCalls = 2 * GSizes[Rows.size() - 1] / GSizes[Index];
			Rows[Index].Prepare.push_back(
				TimeMs(NumCalls, [&] { Sum += FSettingsBlender(Inputs[Index]).GetInputs().CameraWeight; }));
			Rows[Index].Blend.push_back(
				TimeMs(NumCalls, [&] { Sum += Blenders[Index].At(Location).Settings.BloomIntensity; }));
			Rows[Index].Record.push_back(TimeMs(1,
				[&]
				{
					FBlendLedger Ledger;
					Sum += Blenders[Index].At(Location, &Ledger).Settings.BloomIntensity;
				}));
		}
	}
	std::printf("%zu fields, all overridden by every volume; medians of %d, ms (sum %g)\n", GetSettingFields().size(),
		GRepetitions, static_cast<double>(Sum));
	std::printf("%8s %9s %9s %7s %12s %7s\n", "volumes", "prepare", "blend", "ratio", "with ledger", "ratio");
	for (size_t Index = 0; Index < Rows.size(); ++Index)
	{
		const auto Ratio = [&](std::vector<double> FRow::*Column)
		{
			return Index == 0 ? 0.0 : Median(Rows[Index].*Column) / Median(Rows[Index - 1].*Column);
		};
		std::printf("%8d %9.3f %9.3f %7.2f %12.3f %7.2f\n", GSizes[Index], Median(Rows[Index].Prepare),
			Median(Rows[Index].Blend), Ratio(&FRow::Blend), Median(Rows[Index].Record), Ratio(&FRow::Record));
	}
	return 0;
}
